; sha256 d0e2d12bfa1987243dbdebdeed55e6caef6ef846c6a333a87bf6f9777f9fd672 543bec0a8cc289801cfaa6806def1ab0cab973d8600d5a19094f8af2e352d1bc, Python 3.11, numba 0.68.1

@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1, ptr null, i32 0 }
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.10 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.11 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.9 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.10, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.11, ptr null, i32 0 }
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.31 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.32 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.30 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.31, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.32, ptr null, i32 0 }
@switch.table.advance_of_many.2 = private unnamed_addr constant [9 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00], align 8
@switch.table._ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7 = private unnamed_addr constant [18 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00, double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00], align 8

define dso_local range(i32 0, 2) i32 @advance_of_many(ptr noalias %v0, ptr noalias %v1, ptr readnone %v2, ptr readnone %v3, i64 %v4, i64 %v5, ptr readonly %v6, i64 %v7, i64 %v8, i64 %v9, i64 %v10, i64 %v11, i64 %v12, i64 %v13, i64 %v14, i64 %v15, i64 %v16, i64 %v17, i64 %v18, i64 %v19, ptr readnone %v20, ptr readnone %v21, i64 %v22, i64 %v23, ptr %v24, i64 %v25, i64 %v26, ptr readnone %v27, ptr readnone %v28, i64 %v29, i64 %v30, ptr readonly %v31, i64 %v32, i64 %v33, i64 %v34, i64 %v35, ptr readnone %v36, ptr readnone %v37, i64 %v38, i64 %v39, ptr readonly %v40, i64 %v41, i64 %v42, i64 %v43, i64 %v44, ptr readnone %v45, ptr readnone %v46, i64 %v47, i64 %v48, ptr readonly %v49, i64 %v50, i64 %v51, ptr readnone %v52, ptr readnone %v53, i64 %v54, i64 %v55, ptr readonly %v56, i64 %v57, i64 %v58, ptr readnone %v59, ptr readnone %v60, i64 %v61, i64 %v62, ptr readonly %v63, i64 %v64, i64 %v65, ptr readnone %v66, ptr readnone %v67, i64 %v68, i64 %v69, ptr readonly %v70, i64 %v71, i64 %v72, ptr readnone %v73, ptr readnone %v74, i64 %v75, i64 %v76, ptr readonly %v77, i64 %v78, i64 %v79, i64 %v80, i64 %v81, ptr readnone %v82, ptr readnone %v83, i64 %v84, i64 %v85, ptr readonly %v86, i64 %v87, i64 %v88, ptr readnone %v89, ptr readnone %v90, i64 %v91, i64 %v92, ptr readonly %v93, i64 %v94, i64 %v95, ptr readnone %v96, ptr readnone %v97, i64 %v98, i64 %v99, ptr %v100, i64 %v101, i64 %v102, i64 %v103, i64 %v104, i64 %v105, i64 %v106, ptr readnone %v107, ptr readnone %v108, i64 %v109, i64 %v110, ptr %v111, i64 %v112, i64 %v113, ptr readnone %v114, ptr readnone %v115, i64 %v116, i64 %v117, ptr %v118, i64 %v119, i64 %v120, ptr readnone %v121, ptr readnone %v122, i64 %v123, i64 %v124, ptr %v125, i64 %v126, i64 %v127, i64 %v128, i64 %v129, ptr readnone %v130, ptr readnone %v131, i64 %v132, i64 %v133, ptr %v134, i64 %v135, i64 %v136, i64 %v137, i64 %v138, ptr readnone %v139, ptr readnone %v140, i64 %v141, i64 %v142, ptr %v143, i64 %v144, i64 %v145, i64 %v146, i64 %v147, ptr readnone %v148, ptr readnone %v149, i64 %v150, i64 %v151, ptr %v152, i64 %v153, i64 %v154, ptr readnone %v155, ptr readnone %v156, i64 %v157, i64 %v158, ptr %v159, i64 %v160, i64 %v161, ptr readnone %v162, ptr readnone %v163, i64 %v164, i64 %v165, ptr %v166, i64 %v167, i64 %v168, ptr readnone %v169, ptr readnone %v170, i64 %v171, i64 %v172, ptr %v173, i64 %v174, i64 %v175, ptr readnone %v176, ptr readnone %v177, i64 %v178, i64 %v179, ptr %v180, i64 %v181, i64 %v182, ptr readnone %v183, ptr readnone %v184, i64 %v185, i64 %v186, ptr %v187, i64 %v188, i64 %v189, ptr readnone %v190, ptr readnone %v191, i64 %v192, i64 %v193, ptr %v194, i64 %v195, i64 %v196, i64 %v197, i64 %v198, i64 %v199, i64 %v200, ptr readnone %v201, ptr readnone %v202, i64 %v203, i64 %v204, ptr %v205, i64 %v206, i64 %v207, i64 %v208, i64 %v209, i64 %v210, i64 %v211, ptr readnone %v212, ptr readnone %v213, i64 %v214, i64 %v215, ptr readonly %v216, i64 %v217, i64 %v218, ptr readnone %v219, ptr readnone %v220, i64 %v221, i64 %v222, ptr %v223, i64 %v224, i64 %v225, ptr readnone %v226, ptr readnone %v227, i64 %v228, i64 %v229, ptr %v230, i64 %v231, i64 %v232, ptr readnone %v233, ptr readnone %v234, i64 %v235, i64 %v236, ptr %v237, i64 %v238, i64 %v239, ptr readnone %v240, ptr readnone %v241, i64 %v242, i64 %v243, ptr %v244, i64 %v245, i64 %v246, ptr readnone %v247, ptr readnone %v248, i64 %v249, i64 %v250, ptr %v251, i64 %v252, i64 %v253, i64 %v254, i64 %v255, ptr readnone %v256, ptr readnone %v257, i64 %v258, i64 %v259, ptr readonly %v260, i64 %v261, i64 %v262, ptr readnone %v263, ptr readnone %v264, i64 %v265, i64 %v266, ptr readonly %v267, i64 %v268, i64 %v269, ptr readnone %v270, ptr readnone %v271, i64 %v272, i64 %v273, ptr readonly %v274, i64 %v275, i64 %v276, ptr readnone %v277, ptr readnone %v278, i64 %v279, i64 %v280, ptr readonly %v281, i64 %v282, i64 %v283, ptr readnone %v284, ptr readnone %v285, i64 %v286, i64 %v287, ptr readonly %v288, i64 %v289, i64 %v290, ptr readnone %v291, ptr readnone %v292, i64 %v293, i64 %v294, ptr readonly %v295, i64 %v296, i64 %v297, i64 %v298, i64 %v299) local_unnamed_addr {
v300:
  %v301 = alloca i8, align 1
  %v302 = alloca ptr, align 8
  %v303 = alloca i8, align 1
  %v304 = alloca ptr, align 8
  %v305 = icmp sgt i64 %v16, 0
  %v306 = icmp sgt i64 %v19, 0
  %v307 = select i1 %v305, i1 true, i1 %v306
  %v308 = icmp slt i64 %v9, 1
  %v309 = select i1 %v308, i64 0, i64 %v9
  br i1 %v308, label %v310, label %v311

v311:
  %v312 = mul i64 %v136, 24
  %v313 = getelementptr i8, ptr %v134, i64 %v312
  %v314 = getelementptr i8, ptr %v152, i64 8
  %v315 = getelementptr i8, ptr %v152, i64 16
  %v316 = getelementptr i64, ptr %v143, i64 %v145
  %v317 = shl i64 %v145, 4
  %v318 = getelementptr i8, ptr %v143, i64 %v317
  %v319 = mul i64 %v145, 24
  %v320 = getelementptr i8, ptr %v143, i64 %v319
  %v321 = icmp slt i64 %v42, 1
  %v322 = icmp slt i64 %v64, 1
  %v323 = icmp slt i64 %v10, 1
  %v324 = mul i64 %v136, 144
  %v325 = getelementptr i8, ptr %v134, i64 %v324
  %v326 = mul i64 %v136, 240
  %v327 = getelementptr i8, ptr %v134, i64 %v326
  %v328 = mul i64 %v136, 232
  %v329 = getelementptr i8, ptr %v134, i64 %v328
  %v330 = shl i64 %v136, 4
  %v331 = shl i64 %v136, 5
  %v332 = mul i64 %v136, 40
  %v333 = mul i64 %v136, 48
  %v334 = mul i64 %v136, 56
  %v335 = shl i64 %v136, 6
  %v336 = mul i64 %v136, 72
  %v337 = mul i64 %v136, 80
  %v338 = mul i64 %v136, 88
  %v339 = mul i64 %v136, 96
  %v340 = mul i64 %v136, 104
  %v341 = mul i64 %v136, 112
  %v342 = mul i64 %v136, 120
  %v343 = shl i64 %v136, 7
  %v344 = mul i64 %v136, 136
  %v345 = mul i64 %v136, 152
  %v346 = mul i64 %v136, 160
  %v347 = mul i64 %v136, 168
  %v348 = mul i64 %v136, 176
  %v349 = mul i64 %v136, 184
  %v350 = mul i64 %v136, 192
  %v351 = mul i64 %v136, 200
  %v352 = mul i64 %v136, 208
  %v353 = mul i64 %v136, 216
  %v354 = mul i64 %v136, 224
  %v355 = getelementptr i8, ptr %v134, i64 %v342
  %v356 = getelementptr i8, ptr %v134, i64 %v354
  %v357 = getelementptr i8, ptr %v134, i64 %v330
  br label %v358

v359:
  %v360 = getelementptr double, ptr %v313, i64 %v361
  store double 0.000000e+00, ptr %v360, align 8, !noalias !0
  %v362 = load i64, ptr %v152, align 8, !noalias !0
  %v363 = load i64, ptr %v314, align 8, !noalias !0
  %v364 = icmp eq i64 %v362, %v363
  br i1 %v364, label %v365, label %v366

v366:
  %v367 = add nsw i64 %v362, 1
  store i64 %v367, ptr %v152, align 8, !noalias !0
  store i64 2, ptr %v315, align 8, !noalias !0
  %v368 = getelementptr i64, ptr %v143, i64 %v361
  store i64 %v362, ptr %v368, align 8, !noalias !0
  %v369 = icmp slt i64 %v362, 0
  %v370 = select i1 %v369, i64 %v50, i64 0
  %v371 = getelementptr i64, ptr %v49, i64 %v362
  %v372 = getelementptr i64, ptr %v371, i64 %v370
  %v373 = load i64, ptr %v372, align 8, !noalias !0
  %v374 = icmp slt i64 %v373, 0
  %v375 = select i1 %v374, i64 %v57, i64 0
  %v376 = getelementptr i64, ptr %v56, i64 %v373
  %v377 = getelementptr i64, ptr %v376, i64 %v375
  %v378 = load i64, ptr %v377, align 8, !noalias !0
  %v379 = getelementptr i64, ptr %v316, i64 %v361
  store i64 %v378, ptr %v379, align 8, !noalias !0
  %v380 = getelementptr i64, ptr %v318, i64 %v361
  store i64 1, ptr %v380, align 8, !noalias !0
  %v381 = getelementptr i64, ptr %v320, i64 %v361
  store i64 0, ptr %v381, align 8, !noalias !0
  br i1 %v321, label %v382, label %v383

v383:
  %v384 = select i1 %v369, i64 %v41, i64 0
  %v385 = add i64 %v384, %v362
  %v386 = mul i64 %v385, %v42
  %v387 = getelementptr double, ptr %v40, i64 %v386
  %v388 = getelementptr double, ptr %v166, i64 %v361
  br label %v389

v382:
  br i1 %v322, label %v390, label %v391

v391:
  %v392 = load i64, ptr %v379, align 8, !noalias !0
  %v393 = icmp slt i64 %v392, 0
  %v394 = select i1 %v393, i64 %v78, i64 0
  %v395 = add i64 %v394, %v392
  %v396 = mul i64 %v395, %v79
  %v397 = getelementptr double, ptr %v77, i64 %v396
  br label %v398

v398:
  %v399 = phi i64 [ 0, %v391 ], [ %v400, %v398 ]
  %v400 = add nsw i64 %v399, 1
  %v401 = getelementptr double, ptr %v397, i64 %v399
  %v402 = load double, ptr %v401, align 8, !noalias !3
  %v403 = getelementptr i64, ptr %v63, i64 %v399
  %v404 = load i64, ptr %v403, align 8, !noalias !3
  %v405 = mul nsw i64 %v404, %v9
  %v406 = add nsw i64 %v405, %v361
  %v407 = icmp slt i64 %v406, 0
  %v408 = select i1 %v407, i64 %v167, i64 0
  %v409 = getelementptr double, ptr %v166, i64 %v406
  %v410 = getelementptr double, ptr %v409, i64 %v408
  store double %v402, ptr %v410, align 8, !noalias !3
  %v411 = icmp eq i64 %v400, %v64
  br i1 %v411, label %v390, label %v398

v412:
  %v413 = getelementptr double, ptr %v134, i64 %v361
  %v414 = getelementptr double, ptr %v325, i64 %v361
  %v415 = load double, ptr %v414, align 8, !noalias !7
  %v416 = getelementptr double, ptr %v327, i64 %v361
  %v417 = load double, ptr %v416, align 8, !noalias !7
  %v418 = getelementptr double, ptr %v329, i64 %v361
  %v419 = load double, ptr %v418, align 8, !noalias !7
  store double 0.000000e+00, ptr %v413, align 8, !noalias !7
  %v420 = getelementptr double, ptr %v413, i64 %v136
  store double 0.000000e+00, ptr %v420, align 8, !noalias !7
  %v421 = getelementptr i8, ptr %v413, i64 %v330
  store double 0.000000e+00, ptr %v421, align 8, !noalias !7
  %v422 = getelementptr i8, ptr %v413, i64 %v312
  store double 0.000000e+00, ptr %v422, align 8, !noalias !7
  %v423 = getelementptr i8, ptr %v413, i64 %v331
  store double 0.000000e+00, ptr %v423, align 8, !noalias !7
  %v424 = getelementptr i8, ptr %v413, i64 %v332
  store double 0.000000e+00, ptr %v424, align 8, !noalias !7
  %v425 = getelementptr i8, ptr %v413, i64 %v333
  store double 0.000000e+00, ptr %v425, align 8, !noalias !7
  %v426 = getelementptr i8, ptr %v413, i64 %v334
  store double 0.000000e+00, ptr %v426, align 8, !noalias !7
  %v427 = getelementptr i8, ptr %v413, i64 %v335
  store double 0.000000e+00, ptr %v427, align 8, !noalias !7
  %v428 = getelementptr i8, ptr %v413, i64 %v336
  store double 0.000000e+00, ptr %v428, align 8, !noalias !7
  %v429 = getelementptr i8, ptr %v413, i64 %v337
  store double 0.000000e+00, ptr %v429, align 8, !noalias !7
  %v430 = getelementptr i8, ptr %v413, i64 %v338
  store double 0.000000e+00, ptr %v430, align 8, !noalias !7
  %v431 = getelementptr i8, ptr %v413, i64 %v339
  store double 0.000000e+00, ptr %v431, align 8, !noalias !7
  %v432 = getelementptr i8, ptr %v413, i64 %v340
  store double 0.000000e+00, ptr %v432, align 8, !noalias !7
  %v433 = getelementptr i8, ptr %v413, i64 %v341
  store double 0.000000e+00, ptr %v433, align 8, !noalias !7
  %v434 = getelementptr i8, ptr %v413, i64 %v342
  store double 0.000000e+00, ptr %v434, align 8, !noalias !7
  %v435 = getelementptr i8, ptr %v413, i64 %v343
  store double 0.000000e+00, ptr %v435, align 8, !noalias !7
  %v436 = getelementptr i8, ptr %v413, i64 %v344
  store double 0.000000e+00, ptr %v436, align 8, !noalias !7
  %v437 = getelementptr i8, ptr %v413, i64 %v324
  store double 0.000000e+00, ptr %v437, align 8, !noalias !7
  %v438 = getelementptr i8, ptr %v413, i64 %v345
  store double 0.000000e+00, ptr %v438, align 8, !noalias !7
  %v439 = getelementptr i8, ptr %v413, i64 %v346
  store double 0.000000e+00, ptr %v439, align 8, !noalias !7
  %v440 = getelementptr i8, ptr %v413, i64 %v347
  store double 0.000000e+00, ptr %v440, align 8, !noalias !7
  %v441 = getelementptr i8, ptr %v413, i64 %v348
  store double 0.000000e+00, ptr %v441, align 8, !noalias !7
  %v442 = getelementptr i8, ptr %v413, i64 %v349
  store double 0.000000e+00, ptr %v442, align 8, !noalias !7
  %v443 = getelementptr i8, ptr %v413, i64 %v350
  store double 0.000000e+00, ptr %v443, align 8, !noalias !7
  %v444 = getelementptr i8, ptr %v413, i64 %v351
  store double 0.000000e+00, ptr %v444, align 8, !noalias !7
  %v445 = getelementptr i8, ptr %v413, i64 %v352
  store double 0.000000e+00, ptr %v445, align 8, !noalias !7
  %v446 = getelementptr i8, ptr %v413, i64 %v353
  store double 0.000000e+00, ptr %v446, align 8, !noalias !7
  %v447 = getelementptr i8, ptr %v413, i64 %v354
  store double 0.000000e+00, ptr %v447, align 8, !noalias !7
  %v448 = getelementptr i8, ptr %v413, i64 %v328
  store double 0.000000e+00, ptr %v448, align 8, !noalias !7
  %v449 = getelementptr i8, ptr %v413, i64 %v326
  store double 0.000000e+00, ptr %v449, align 8, !noalias !7
  %v450 = fcmp oeq double %v419, 0xFFF0000000000000
  %v451 = select i1 %v450, double 0xFFF0000000000000, double 0.000000e+00
  store double %v451, ptr %v418, align 8, !noalias !7
  store double %v417, ptr %v416, align 8, !noalias !7
  store double %v415, ptr %v414, align 8, !noalias !7
  store double 1.000000e+00, ptr %v360, align 8, !noalias !7
  %v452 = getelementptr double, ptr %v355, i64 %v361
  store double 0xFFF0000000000000, ptr %v452, align 8, !noalias !7
  %v453 = getelementptr double, ptr %v356, i64 %v361
  store double 0x7FF0000000000000, ptr %v453, align 8, !noalias !7
  %v454 = load double, ptr %v93, align 8, !noalias !0
  store double %v454, ptr %v413, align 8, !noalias !0
  %v455 = load i64, ptr %v379, align 8, !noalias !0
  %v456 = icmp slt i64 %v455, 0
  %v457 = select i1 %v456, i64 %v71, i64 0
  %v458 = getelementptr double, ptr %v70, i64 %v455
  %v459 = getelementptr double, ptr %v458, i64 %v457
  %v460 = load double, ptr %v459, align 8, !noalias !0
  %v461 = getelementptr double, ptr %v357, i64 %v361
  store double %v460, ptr %v461, align 8, !noalias !0
  br label %v365

v389:
  %v462 = phi i64 [ 0, %v383 ], [ %v463, %v389 ]
  %v463 = add nsw i64 %v462, 1
  %v464 = getelementptr double, ptr %v387, i64 %v462
  %v465 = load double, ptr %v464, align 8, !noalias !0
  %v466 = mul nsw i64 %v462, %v9
  %v467 = getelementptr double, ptr %v388, i64 %v466
  store double %v465, ptr %v467, align 8, !noalias !0
  %v468 = icmp eq i64 %v463, %v42
  br i1 %v468, label %v382, label %v389

v390:
  br i1 %v323, label %v412, label %v469

v469:
  %v470 = getelementptr double, ptr %v194, i64 %v361
  %v471 = select i1 %v369, i64 %v32, i64 0
  %v472 = add i64 %v471, %v362
  %v473 = mul i64 %v472, %v33
  %v474 = getelementptr double, ptr %v31, i64 %v473
  br label %v475

v475:
  %v476 = phi i64 [ 0, %v469 ], [ %v477, %v475 ]
  %v477 = add nsw i64 %v476, 1
  %v478 = getelementptr double, ptr %v474, i64 %v476
  %v479 = load double, ptr %v478, align 8, !noalias !0
  %v480 = mul i64 %v476, %v197
  %v481 = getelementptr double, ptr %v470, i64 %v480
  store double %v479, ptr %v481, align 8, !noalias !0
  %v482 = icmp eq i64 %v477, %v10
  br i1 %v482, label %v412, label %v475

v365:
  %v483 = load i64, ptr %v484, align 8
  %v485 = icmp sgt i64 %v483, -1
  %v486 = zext i1 %v485 to i64
  %v487 = add nsw i64 %v488, %v486
  %v489 = icmp sgt i64 %v490, 1
  br i1 %v489, label %v358, label %v310

v310:
  %v491 = phi i64 [ 0, %v300 ], [ %v487, %v365 ]
  %v492 = icmp ne i64 %v491, 0
  %v493 = icmp sgt i64 %v298, 0
  %v494 = select i1 %v492, i1 %v493, i1 false
  br i1 %v494, label %v495, label %v496

v495:
  %v497 = getelementptr i8, ptr %v152, i64 16
  %v498 = mul i64 %v10, %v9
  %v499 = mul i64 %v197, %v196
  %v500 = shl i64 %v197, 7
  %v501 = mul i64 %v208, %v207
  %v502 = getelementptr i8, ptr %v6, i64 8
  %v503 = getelementptr i8, ptr %v6, i64 32
  %v504 = mul i64 %v136, 24
  %v505 = getelementptr i8, ptr %v134, i64 %v504
  %v506 = icmp sgt i64 %v19, 0
  %v507 = getelementptr i8, ptr %v6, i64 32
  %v508 = mul i64 %v136, 24
  %v509 = getelementptr i8, ptr %v134, i64 %v508
  %v510 = icmp slt i64 %v19, 1
  %v511 = icmp sgt i64 %v13, 0
  %v512 = mul nsw i64 %v10, %v9
  %v513 = shl i64 %v512, 4
  %v514 = getelementptr i8, ptr %v159, i64 %v513
  %v515 = getelementptr i8, ptr %v6, i64 56
  %v516 = getelementptr i8, ptr %v6, i64 64
  %v517 = shl i64 %v136, 6
  %v518 = getelementptr i8, ptr %v134, i64 %v517
  %v519 = mul i64 %v512, 136
  %v520 = getelementptr i8, ptr %v159, i64 %v519
  %v521 = mul i64 %v512, 24
  %v522 = getelementptr i8, ptr %v159, i64 %v521
  %v523 = getelementptr i8, ptr %v6, i64 72
  %v524 = mul i64 %v498, 112
  %v525 = mul i64 %v136, 24
  %v526 = getelementptr i8, ptr %v134, i64 %v525
  %v527 = shl i64 %v136, 5
  %v528 = getelementptr i8, ptr %v134, i64 %v527
  %v529 = mul i64 %v136, 144
  %v530 = getelementptr i8, ptr %v134, i64 %v529
  %v531 = select i1 %v511, i64 2, i64 0
  %v532 = icmp slt i64 %v15, 1
  %v533 = zext i1 %v532 to i64
  %v534 = mul i64 %v136, 88
  %v535 = getelementptr i8, ptr %v134, i64 %v534
  %v536 = getelementptr double, ptr %v93, i64 %v94
  %v537 = getelementptr i8, ptr %v536, i64 -8
  %v538 = shl i64 %v136, 6
  %v539 = getelementptr i8, ptr %v134, i64 %v538
  %v540 = getelementptr i8, ptr %v159, i64 %v524
  %v541 = icmp slt i64 %v10, 1
  %v542 = mul i64 %v197, %v196
  %v543 = mul i64 %v542, 112
  %v544 = getelementptr i8, ptr %v194, i64 %v543
  %v545 = shl i64 %v542, 7
  %v546 = getelementptr i8, ptr %v194, i64 %v545
  %v547 = getelementptr i8, ptr %v6, i64 32
  %v548 = mul i64 %v208, 216
  %v549 = getelementptr i8, ptr %v187, i64 %v548
  %v550 = shl i64 %v10, 7
  %v551 = getelementptr i8, ptr %v159, i64 %v550
  %v552 = mul i64 %v208, 240
  %v553 = getelementptr i8, ptr %v187, i64 %v552
  %v554 = sub i64 %v208, %v19
  %v555 = tail call i64 @llvm.smax.i64(i64 %v554, i64 0)
  %v556 = getelementptr double, ptr %v205, i64 %v208
  %v557 = mul i64 %v208, %v207
  %v558 = mul i64 %v557, 80
  %v559 = getelementptr i8, ptr %v556, i64 %v558
  %v560 = mul i64 %v557, 72
  %v561 = getelementptr i8, ptr %v205, i64 %v560
  %v562 = getelementptr double, ptr %v561, i64 %v208
  %v563 = shl i64 %v208, 4
  %v564 = getelementptr i8, ptr %v561, i64 %v563
  %v565 = shl i64 %v145, 5
  %v566 = getelementptr i8, ptr %v143, i64 %v565
  %v567 = shl i64 %v136, 4
  %v568 = getelementptr i8, ptr %v134, i64 %v567
  %v569 = mul i64 %v136, 112
  %v570 = getelementptr i8, ptr %v134, i64 %v569
  %v571 = shl i64 %v136, 4
  %v572 = getelementptr i8, ptr %v134, i64 %v571
  %v573 = mul i64 %v136, 168
  %v574 = getelementptr i8, ptr %v134, i64 %v573
  %v575 = shl i64 %v145, 4
  %v576 = getelementptr i8, ptr %v143, i64 %v575
  %v577 = getelementptr i8, ptr %v6, i64 40
  %v578 = icmp eq i64 %v13, 0
  %v579 = mul nsw i64 %v10, %v9
  %v580 = getelementptr double, ptr %v159, i64 %v579
  %v581 = icmp sgt i64 %v14, 0
  %v582 = shl i64 %v136, 5
  %v583 = getelementptr i8, ptr %v134, i64 %v582
  %v584 = icmp slt i64 %v10, 1
  %v585 = mul i64 %v197, %v196
  %v586 = mul i64 %v585, 136
  %v587 = getelementptr i8, ptr %v194, i64 %v586
  %v588 = mul i64 %v585, 88
  %v589 = getelementptr i8, ptr %v194, i64 %v588
  %v590 = mul nsw i64 %v10, 19
  %v591 = add nsw i64 %v590, 1
  %v592 = mul nsw i64 %v10, 18
  %v593 = icmp slt i64 %v10, 0
  %v594 = select i1 %v593, i64 %v160, i64 0
  %v595 = add i64 %v594, %v592
  %v596 = icmp slt i64 %v595, 0
  %v597 = icmp slt i64 %v595, %v160
  %v598 = add i64 %v591, %v594
  %v599 = icmp slt i64 %v598, 0
  %v600 = icmp slt i64 %v598, %v160
  %v601 = icmp sgt i64 %v275, 1
  %v602 = mul i64 %v197, %v196
  %v603 = getelementptr i8, ptr %v24, i64 8
  %v604 = select i1 %v593, i64 %v268, i64 0
  %v605 = getelementptr i64, ptr %v267, i64 %v10
  %v606 = getelementptr i64, ptr %v605, i64 %v604
  %v607 = mul i64 %v136, 48
  %v608 = getelementptr i8, ptr %v134, i64 %v607
  %v609 = mul i64 %v602, 136
  %v610 = shl i64 %v136, 6
  %v611 = getelementptr i8, ptr %v134, i64 %v610
  %v612 = mul nsw i64 %v10, %v9
  %v613 = mul i64 %v612, 136
  %v614 = getelementptr i8, ptr %v159, i64 %v613
  %v615 = getelementptr i8, ptr %v194, i64 %v609
  %v616 = mul i64 %v602, 96
  %v617 = getelementptr i8, ptr %v194, i64 %v616
  %v618 = mul i64 %v602, 104
  %v619 = getelementptr i8, ptr %v194, i64 %v618
  %v620 = getelementptr double, ptr %v194, i64 %v602
  %v621 = mul i64 %v602, 88
  %v622 = getelementptr i8, ptr %v194, i64 %v621
  %v623 = mul i64 %v612, 96
  %v624 = getelementptr i8, ptr %v159, i64 %v623
  %v625 = mul i64 %v612, 96
  %v626 = getelementptr i8, ptr %v159, i64 %v625
  %v627 = mul i64 %v612, 104
  %v628 = getelementptr i8, ptr %v159, i64 %v627
  %v629 = add nsw i64 %v275, -2
  %v630 = icmp sgt i64 %v10, 0
  %v631 = add i64 %v255, %v254
  %v632 = add i64 %v254, 1
  %v633 = add i64 %v10, 1
  %v634 = mul i64 %v136, 160
  %v635 = getelementptr i8, ptr %v134, i64 %v634
  %v636 = add i64 %v255, 1
  %v637 = add i64 %v11, -1
  %v638 = tail call i64 @llvm.smax.i64(i64 %v637, i64 0)
  %v639 = mul i64 %v499, 136
  %v640 = icmp slt i64 %v637, 1
  %v641 = shl i64 %v136, 6
  %v642 = getelementptr i8, ptr %v134, i64 %v641
  %v643 = mul nsw i64 %v10, %v9
  %v644 = mul i64 %v643, 136
  %v645 = getelementptr i8, ptr %v159, i64 %v644
  %v646 = icmp slt i64 %v10, 1
  %v647 = mul i64 %v197, %v196
  %v648 = mul i64 %v647, 80
  %v649 = getelementptr i8, ptr %v194, i64 %v648
  %v650 = mul i64 %v647, 136
  %v651 = getelementptr i8, ptr %v194, i64 %v650
  %v652 = mul nsw i64 %v10, 17
  %v653 = getelementptr double, ptr %v159, i64 %v652
  %v654 = add i64 %v254, 1
  %v655 = add i64 %v254, 1
  %v656 = getelementptr double, ptr %v159, i64 %v652
  %v657 = add i64 %v255, %v254
  %v658 = getelementptr i8, ptr %v194, i64 %v639
  %v659 = mul i64 %v197, %v196
  %v660 = getelementptr i8, ptr %v6, i64 48
  %v661 = or i1 %v581, %v307
  %v662 = mul i64 %v136, 40
  %v663 = getelementptr i8, ptr %v134, i64 %v662
  %v664 = mul i64 %v136, 184
  %v665 = getelementptr i8, ptr %v134, i64 %v664
  %v666 = mul i64 %v136, 192
  %v667 = getelementptr i8, ptr %v134, i64 %v666
  %v668 = mul i64 %v136, 200
  %v669 = getelementptr i8, ptr %v134, i64 %v668
  %v670 = mul i64 %v136, 176
  %v671 = getelementptr i8, ptr %v134, i64 %v670
  %v672 = shl i64 %v145, 4
  %v673 = getelementptr i8, ptr %v143, i64 %v672
  %v674 = mul i64 %v136, 208
  %v675 = getelementptr i8, ptr %v134, i64 %v674
  %v676 = mul i64 %v136, 72
  %v677 = getelementptr i8, ptr %v134, i64 %v676
  %v678 = mul i64 %v136, 40
  %v679 = getelementptr i8, ptr %v134, i64 %v678
  %v680 = mul i64 %v136, 56
  %v681 = getelementptr i8, ptr %v134, i64 %v680
  %v682 = mul i64 %v136, 232
  %v683 = getelementptr i8, ptr %v134, i64 %v682
  %v684 = icmp sgt i64 %v13, 0
  %v685 = icmp ne i64 %v14, 0
  %v686 = xor i1 %v684, true
  %v687 = select i1 %v686, i1 true, i1 %v685
  %v688 = shl i64 %v136, 6
  %v689 = getelementptr i8, ptr %v134, i64 %v688
  %v690 = mul nsw i64 %v10, %v9
  %v691 = mul i64 %v690, 136
  %v692 = getelementptr i8, ptr %v159, i64 %v691
  %v693 = mul i64 %v690, 104
  %v694 = getelementptr i8, ptr %v159, i64 %v693
  %v695 = getelementptr i8, ptr %v6, i64 104
  %v696 = getelementptr i8, ptr %v6, i64 96
  %v697 = mul i64 %v197, %v196
  %v698 = mul i64 %v136, 48
  %v699 = getelementptr i8, ptr %v134, i64 %v698
  %v700 = shl i64 %v136, 6
  %v701 = getelementptr i8, ptr %v134, i64 %v700
  %v702 = shl i64 %v697, 7
  %v703 = icmp slt i64 %v10, 1
  %v704 = getelementptr i8, ptr %v194, i64 %v702
  %v705 = mul i64 %v208, 3
  %v706 = getelementptr i8, ptr %v6, i64 32
  %v707 = mul i64 %v697, 192
  %v708 = mul i64 %v697, 184
  %v709 = mul i64 %v697, 176
  %v710 = mul i64 %v697, 168
  %v711 = mul i64 %v697, 160
  %v712 = mul i64 %v697, 152
  %v713 = mul i64 %v697, 144
  %v714 = mul i64 %v136, 56
  %v715 = getelementptr i8, ptr %v134, i64 %v714
  %v716 = tail call i64 @llvm.smax.i64(i64 %v208, i64 0)
  %v717 = mul i64 %v208, %v207
  %v718 = getelementptr double, ptr %v205, i64 %v208
  %v719 = mul i64 %v208, %v207
  %v720 = getelementptr double, ptr %v205, i64 %v208
  %v721 = getelementptr double, ptr %v205, i64 %v208
  %v722 = shl i64 %v208, 4
  %v723 = getelementptr i8, ptr %v205, i64 %v722
  %v724 = icmp sgt i64 %v12, 0
  %v725 = add nsw i64 %v11, 13
  %v726 = shl i64 %v136, 6
  %v727 = getelementptr i8, ptr %v134, i64 %v726
  %v728 = mul nsw i64 %v10, %v9
  %v729 = mul i64 %v728, 136
  %v730 = getelementptr i8, ptr %v159, i64 %v729
  %v731 = icmp slt i64 %v11, -13
  %v732 = select i1 %v731, i64 %v7, i64 0
  %v733 = getelementptr i64, ptr %v6, i64 %v11
  %v734 = getelementptr i8, ptr %v733, i64 104
  %v735 = getelementptr i64, ptr %v734, i64 %v732
  %v736 = getelementptr i8, ptr %v6, i64 88
  %v737 = shl i64 %v145, 4
  %v738 = getelementptr i8, ptr %v143, i64 %v737
  %v739 = mul i64 %v136, 40
  %v740 = getelementptr i8, ptr %v134, i64 %v739
  %v741 = mul i64 %v136, 56
  %v742 = getelementptr i8, ptr %v134, i64 %v741
  %v743 = mul i64 %v136, 216
  %v744 = getelementptr i8, ptr %v134, i64 %v743
  %v745 = mul i64 %v136, 48
  %v746 = getelementptr i8, ptr %v134, i64 %v745
  %v747 = shl i64 %v136, 5
  %v748 = getelementptr i8, ptr %v134, i64 %v747
  %v749 = getelementptr double, ptr %v134, i64 %v136
  %v750 = mul i64 %v136, 224
  %v751 = getelementptr i8, ptr %v134, i64 %v750
  %v752 = mul i64 %v197, %v196
  %v753 = mul i64 %v136, 48
  %v754 = getelementptr i8, ptr %v134, i64 %v753
  %v755 = shl i64 %v136, 6
  %v756 = getelementptr i8, ptr %v134, i64 %v755
  %v757 = shl i64 %v752, 7
  %v758 = icmp slt i64 %v10, 1
  %v759 = getelementptr i8, ptr %v194, i64 %v757
  %v760 = mul i64 %v208, 3
  %v761 = getelementptr i8, ptr %v6, i64 32
  %v762 = mul i64 %v752, 192
  %v763 = mul i64 %v752, 184
  %v764 = mul i64 %v752, 176
  %v765 = mul i64 %v752, 168
  %v766 = mul i64 %v752, 160
  %v767 = mul i64 %v752, 152
  %v768 = mul i64 %v752, 144
  %v769 = getelementptr double, ptr %v93, i64 %v94
  %v770 = getelementptr i8, ptr %v769, i64 -8
  %v771 = icmp slt i64 %v16, 1
  %v772 = mul i64 %v208, %v207
  %v773 = shl i64 %v208, 4
  %v774 = getelementptr double, ptr %v205, i64 %v208
  %v775 = getelementptr i8, ptr %v205, i64 %v773
  %v776 = shl i64 %v772, 4
  %v777 = mul i64 %v772, 24
  %v778 = shl i64 %v772, 5
  %v779 = mul i64 %v772, 40
  %v780 = mul i64 %v772, 48
  %v781 = mul i64 %v772, 56
  %v782 = shl i64 %v772, 6
  %v783 = mul i64 %v136, 104
  %v784 = getelementptr i8, ptr %v134, i64 %v783
  %v785 = getelementptr double, ptr %v93, i64 %v94
  %v786 = getelementptr i8, ptr %v785, i64 -8
  %v787 = mul i64 %v136, 56
  %v788 = getelementptr i8, ptr %v134, i64 %v787
  %v789 = mul i64 %v136, 120
  %v790 = getelementptr i8, ptr %v134, i64 %v789
  %v791 = mul i64 %v136, 112
  %v792 = getelementptr i8, ptr %v134, i64 %v791
  %v793 = mul i64 %v208, %v207
  %v794 = shl i64 %v136, 7
  %v795 = getelementptr i8, ptr %v134, i64 %v794
  %v796 = mul i64 %v136, 136
  %v797 = getelementptr i8, ptr %v134, i64 %v796
  %v798 = icmp sgt i64 %v10, 0
  %v799 = shl i64 %v10, 7
  %v800 = getelementptr i8, ptr %v159, i64 %v799
  %v801 = mul i64 %v208, 216
  %v802 = getelementptr i8, ptr %v187, i64 %v801
  %v803 = sub i64 %v208, %v19
  %v804 = tail call i64 @llvm.smax.i64(i64 %v803, i64 0)
  %v805 = icmp sgt i64 %v803, 0
  %v806 = shl i64 %v793, 6
  %v807 = getelementptr i8, ptr %v205, i64 %v806
  %v808 = shl i64 %v208, 4
  %v809 = getelementptr i8, ptr %v807, i64 %v808
  %v810 = mul i64 %v793, 72
  %v811 = getelementptr i8, ptr %v205, i64 %v810
  %v812 = getelementptr i8, ptr %v811, i64 %v808
  %v813 = icmp slt i64 %v208, 1
  %v814 = getelementptr double, ptr %v811, i64 %v208
  %v815 = mul i64 %v793, 80
  %v816 = getelementptr i8, ptr %v205, i64 %v815
  %v817 = tail call i64 @llvm.smax.i64(i64 %v10, i64 0)
  %v818 = mul i64 %v500, %v196
  %v819 = getelementptr i8, ptr %v194, i64 %v818
  %v820 = mul nsw i64 %v10, %v9
  %v821 = shl i64 %v820, 7
  %v822 = getelementptr i8, ptr %v159, i64 %v821
  %v823 = mul i64 %v820, 112
  %v824 = getelementptr i8, ptr %v159, i64 %v823
  %v825 = getelementptr i8, ptr %v6, i64 8
  %v826 = mul i64 %v820, 120
  %v827 = getelementptr i8, ptr %v159, i64 %v826
  %v828 = getelementptr i8, ptr %v24, i64 8
  %v829 = mul i64 %v752, 120
  %v830 = getelementptr i8, ptr %v194, i64 %v829
  %v831 = mul i64 %v752, 112
  %v832 = getelementptr i8, ptr %v194, i64 %v831
  %v833 = mul i64 %v136, 40
  %v834 = getelementptr i8, ptr %v134, i64 %v833
  %v835 = icmp slt i64 %v19, 1
  %v836 = mul i64 %v793, 80
  %v837 = getelementptr i8, ptr %v205, i64 %v836
  %v838 = mul i64 %v820, 136
  %v839 = getelementptr i8, ptr %v159, i64 %v838
  %v840 = mul i64 %v820, 104
  %v841 = getelementptr i8, ptr %v159, i64 %v840
  %v842 = mul i64 %v136, 40
  %v843 = getelementptr i8, ptr %v134, i64 %v842
  %v844 = select i1 %v813, i64 0, i64 %v208
  %v845 = icmp slt i64 %v803, 1
  %v846 = shl i64 %v145, 4
  %v847 = getelementptr i8, ptr %v143, i64 %v846
  %v848 = mul i64 %v136, 224
  %v849 = getelementptr i8, ptr %v134, i64 %v848
  %v850 = mul i64 %v103, %v102
  %v851 = mul i64 %v752, 136
  %v852 = getelementptr i8, ptr %v194, i64 %v851
  %v853 = add i64 %v94, -1
  %v854 = shl i64 %v145, 5
  %v855 = getelementptr i8, ptr %v143, i64 %v854
  %v856 = mul i64 %v136, 40
  %v857 = getelementptr i8, ptr %v134, i64 %v856
  %v858 = mul i64 %v136, 96
  %v859 = getelementptr i8, ptr %v134, i64 %v858
  %v860 = mul i64 %v136, 216
  %v861 = getelementptr i8, ptr %v134, i64 %v860
  %v862 = mul i64 %v136, 40
  %v863 = getelementptr i8, ptr %v134, i64 %v862
  %v864 = shl i64 %v136, 5
  %v865 = getelementptr i8, ptr %v134, i64 %v864
  %v866 = getelementptr double, ptr %v134, i64 %v136
  %v867 = mul i64 %v752, 136
  %v868 = getelementptr i8, ptr %v194, i64 %v867
  %v869 = mul nsw i64 %v10, %v9
  %v870 = mul i64 %v869, 136
  %v871 = getelementptr i8, ptr %v159, i64 %v870
  %v872 = mul i64 %v869, 104
  %v873 = getelementptr i8, ptr %v159, i64 %v872
  %v874 = mul i64 %v10, 136
  %v875 = getelementptr i8, ptr %v159, i64 %v874
  %v876 = mul i64 %v208, 192
  %v877 = getelementptr i8, ptr %v187, i64 %v876
  %v878 = mul i64 %v197, %v196
  %v879 = mul i64 %v136, 40
  %v880 = getelementptr i8, ptr %v134, i64 %v879
  %v881 = mul i64 %v136, 56
  %v882 = getelementptr i8, ptr %v134, i64 %v881
  %v883 = shl i64 %v145, 4
  %v884 = getelementptr i8, ptr %v143, i64 %v883
  %v885 = mul i64 %v136, 48
  %v886 = getelementptr i8, ptr %v134, i64 %v885
  %v887 = mul i64 %v878, 136
  %v888 = icmp slt i64 %v10, 1
  %v889 = mul i64 %v136, 224
  %v890 = getelementptr i8, ptr %v134, i64 %v889
  %v891 = mul i64 %v103, %v102
  %v892 = getelementptr i8, ptr %v194, i64 %v887
  %v893 = add i64 %v94, -1
  %v894 = mul i64 %v878, 192
  %v895 = mul i64 %v878, 184
  %v896 = mul i64 %v878, 176
  %v897 = mul i64 %v878, 168
  %v898 = mul i64 %v878, 160
  %v899 = mul i64 %v878, 152
  %v900 = mul i64 %v878, 144
  %v901 = icmp sgt i64 %v9, 1
  %v902 = mul i64 %v136, 40
  %v903 = getelementptr i8, ptr %v134, i64 %v902
  %v904 = getelementptr i8, ptr %v6, i64 80
  %v905 = mul i64 %v136, 40
  %v906 = getelementptr i8, ptr %v134, i64 %v905
  %v907 = shl i64 %v501, 6
  %v908 = icmp sgt i64 %v19, 0
  %v909 = getelementptr i8, ptr %v205, i64 %v907
  %v910 = mul i64 %v136, 96
  %v911 = getelementptr i8, ptr %v134, i64 %v910
  %v912 = mul i64 %v136, 120
  %v913 = getelementptr i8, ptr %v134, i64 %v912
  %v914 = icmp slt i64 %v10, 1
  %v915 = getelementptr i8, ptr %v24, i64 8
  %v916 = getelementptr double, ptr %v93, i64 %v94
  %v917 = getelementptr i8, ptr %v916, i64 -8
  %v918 = mul i64 %v145, 24
  %v919 = getelementptr i8, ptr %v143, i64 %v918
  %v920 = mul i64 %v145, 24
  %v921 = getelementptr i8, ptr %v143, i64 %v920
  %v922 = mul i64 %v136, 24
  %v923 = getelementptr i8, ptr %v134, i64 %v922
  %v924 = icmp ne i64 %v17, 0
  %v925 = tail call i64 @llvm.smax.i64(i64 %v9, i64 0)
  %v926 = mul i64 %v136, 40
  %v927 = getelementptr i8, ptr %v134, i64 %v926
  %v928 = shl i64 %v136, 4
  %v929 = getelementptr i8, ptr %v134, i64 %v928
  %v930 = getelementptr i64, ptr %v143, i64 %v145
  %v931 = icmp slt i64 %v64, 1
  %v932 = getelementptr i8, ptr %v6, i64 8
  %v933 = mul nsw i64 %v10, %v9
  %v934 = getelementptr i8, ptr %v6, i64 24
  %v935 = mul i64 %v933, 136
  %v936 = getelementptr i8, ptr %v159, i64 %v935
  %v937 = mul i64 %v103, %v102
  %v938 = add nsw i64 %v925, -1
  %v939 = mul i64 %v197, %v196
  %v940 = shl i64 %v145, 4
  %v941 = getelementptr i8, ptr %v143, i64 %v940
  %v942 = mul i64 %v939, 136
  %v943 = icmp slt i64 %v10, 1
  %v944 = getelementptr i8, ptr %v194, i64 %v942
  %v945 = getelementptr double, ptr %v93, i64 %v94
  %v946 = getelementptr i8, ptr %v945, i64 -8
  %v947 = shl i64 %v136, 6
  %v948 = getelementptr i8, ptr %v134, i64 %v947
  %v949 = mul i64 %v933, 112
  %v950 = getelementptr i8, ptr %v159, i64 %v949
  %v951 = mul i64 %v939, 112
  %v952 = getelementptr i8, ptr %v194, i64 %v951
  %v953 = shl i64 %v939, 7
  %v954 = getelementptr i8, ptr %v194, i64 %v953
  %v955 = getelementptr i8, ptr %v6, i64 32
  %v956 = mul i64 %v10, 136
  %v957 = getelementptr i8, ptr %v159, i64 %v956
  %v958 = mul i64 %v208, 216
  %v959 = getelementptr i8, ptr %v187, i64 %v958
  %v960 = shl i64 %v10, 7
  %v961 = getelementptr i8, ptr %v159, i64 %v960
  %v962 = mul i64 %v208, 240
  %v963 = getelementptr i8, ptr %v187, i64 %v962
  %v964 = sub i64 %v208, %v19
  %v965 = tail call i64 @llvm.smax.i64(i64 %v964, i64 0)
  %v966 = getelementptr double, ptr %v205, i64 %v208
  %v967 = mul i64 %v208, %v207
  %v968 = mul i64 %v967, 80
  %v969 = getelementptr i8, ptr %v966, i64 %v968
  %v970 = mul i64 %v967, 72
  %v971 = getelementptr i8, ptr %v205, i64 %v970
  %v972 = getelementptr double, ptr %v971, i64 %v208
  %v973 = shl i64 %v208, 4
  %v974 = getelementptr i8, ptr %v971, i64 %v973
  %v975 = shl i64 %v145, 5
  %v976 = getelementptr i8, ptr %v143, i64 %v975
  %v977 = mul i64 %v136, 112
  %v978 = getelementptr i8, ptr %v134, i64 %v977
  %v979 = mul i64 %v136, 40
  %v980 = getelementptr i8, ptr %v134, i64 %v979
  %v981 = shl i64 %v136, 4
  %v982 = getelementptr i8, ptr %v134, i64 %v981
  %v983 = getelementptr i64, ptr %v143, i64 %v145
  %v984 = mul i64 %v136, 24
  %v985 = getelementptr i8, ptr %v134, i64 %v984
  %v986 = mul i64 %v136, 24
  %v987 = getelementptr i8, ptr %v134, i64 %v986
  %v988 = icmp slt i64 %v64, 1
  %v989 = shl i64 %v145, 4
  %v990 = getelementptr i8, ptr %v143, i64 %v989
  %v991 = mul i64 %v136, 24
  %v992 = getelementptr i8, ptr %v134, i64 %v991
  %v993 = getelementptr i8, ptr %v152, i64 8
  %v994 = getelementptr i64, ptr %v143, i64 %v145
  %v995 = mul i64 %v145, 24
  %v996 = getelementptr i8, ptr %v143, i64 %v995
  %v997 = icmp slt i64 %v42, 1
  %v998 = icmp slt i64 %v64, 1
  %v999 = icmp slt i64 %v10, 1
  %v1000 = mul i64 %v136, 144
  %v1001 = getelementptr i8, ptr %v134, i64 %v1000
  %v1002 = mul i64 %v136, 240
  %v1003 = getelementptr i8, ptr %v134, i64 %v1002
  %v1004 = mul i64 %v136, 232
  %v1005 = getelementptr i8, ptr %v134, i64 %v1004
  %v1006 = shl i64 %v136, 4
  %v1007 = shl i64 %v136, 5
  %v1008 = mul i64 %v136, 48
  %v1009 = mul i64 %v136, 56
  %v1010 = shl i64 %v136, 6
  %v1011 = mul i64 %v136, 72
  %v1012 = mul i64 %v136, 80
  %v1013 = mul i64 %v136, 88
  %v1014 = mul i64 %v136, 96
  %v1015 = mul i64 %v136, 104
  %v1016 = mul i64 %v136, 112
  %v1017 = mul i64 %v136, 120
  %v1018 = shl i64 %v136, 7
  %v1019 = mul i64 %v136, 136
  %v1020 = mul i64 %v136, 152
  %v1021 = mul i64 %v136, 160
  %v1022 = mul i64 %v136, 168
  %v1023 = mul i64 %v136, 176
  %v1024 = mul i64 %v136, 184
  %v1025 = mul i64 %v136, 192
  %v1026 = mul i64 %v136, 200
  %v1027 = mul i64 %v136, 208
  %v1028 = mul i64 %v136, 216
  %v1029 = mul i64 %v136, 224
  %v1030 = getelementptr i8, ptr %v134, i64 %v1017
  %v1031 = getelementptr i8, ptr %v134, i64 %v1029
  %v1032 = getelementptr i8, ptr %v134, i64 %v1006
  %v1033 = mul i64 %v136, 232
  %v1034 = getelementptr i8, ptr %v134, i64 %v1033
  %v1035 = getelementptr double, ptr %v93, i64 %v94
  %v1036 = getelementptr i8, ptr %v1035, i64 -8
  %v1037 = getelementptr double, ptr %v134, i64 %v136
  %v1038 = mul i64 %v136, 232
  %v1039 = getelementptr i8, ptr %v134, i64 %v1038
  %v1040 = mul i64 %v136, 176
  %v1041 = getelementptr i8, ptr %v134, i64 %v1040
  %v1042 = shl i64 %v136, 4
  %v1043 = getelementptr i8, ptr %v134, i64 %v1042
  %v1044 = mul i64 %v136, 168
  %v1045 = getelementptr i8, ptr %v134, i64 %v1044
  %v1046 = shl i64 %v145, 4
  %v1047 = getelementptr i8, ptr %v143, i64 %v1046
  %v1048 = shl i64 %v717, 4
  %v1049 = mul i64 %v717, 24
  %v1050 = shl i64 %v717, 5
  %v1051 = mul i64 %v717, 40
  %v1052 = mul i64 %v717, 48
  %v1053 = mul i64 %v717, 56
  %v1054 = shl i64 %v717, 6
  %v1055 = shl i64 %v719, 4
  %v1056 = shl i64 %v719, 5
  %v1057 = mul i64 %v719, 48
  %v1058 = shl i64 %v719, 6
  %v1059 = mul i64 %v719, 24
  %v1060 = shl i64 %v719, 4
  %v1061 = shl i64 %v719, 5
  %v1062 = mul i64 %v719, 48
  %v1063 = shl i64 %v719, 6
  %v1064 = mul i64 %v719, 40
  %v1065 = shl i64 %v719, 4
  %v1066 = shl i64 %v719, 5
  %v1067 = mul i64 %v719, 48
  %v1068 = shl i64 %v719, 6
  %v1069 = mul i64 %v719, 56
  %v1070 = shl i64 %v719, 4
  %v1071 = shl i64 %v719, 5
  %v1072 = mul i64 %v719, 48
  %v1073 = shl i64 %v719, 6
  br label %v1074

v1074:
  %v1075 = phi i64 [ %v1076, %v1077 ], [ %v298, %v495 ]
  %v1078 = phi i64 [ %v1079, %v1077 ], [ %v491, %v495 ]
  %v1080 = add nsw i64 %v1075, -1
  %v1081 = load i64, ptr %v497, align 8, !noalias !11
  %v1082 = icmp eq i64 %v1081, 0
  br i1 %v1082, label %v1083, label %v1084

v1084:
  %v1085 = icmp eq i64 %v1081, 2
  store i64 0, ptr %v497, align 8, !noalias !11
  %v1086 = load i64, ptr %v502, align 8, !noalias !15
  %v1087 = inttoptr i64 %v1086 to ptr
  tail call void %v1087(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !15
  br i1 %v306, label %v1088, label %v1089

v1088:
  %v1090 = load i64, ptr %v503, align 8, !noalias !18
  %v1091 = inttoptr i64 %v1090 to ptr
  tail call void %v1091(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !18
  %v1092 = load double, ptr %v505, align 8, !noalias !24
  %v1093 = fcmp une double %v1092, 2.500000e-01
  br i1 %v1093, label %v1089, label %v1094

v1094:
  store double 0.000000e+00, ptr %v505, align 8, !noalias !24
  br i1 %v506, label %v1095, label %v1096

v1097:
  store double 1.000000e+00, ptr %v505, align 8, !noalias !24
  br label %v1098

v1098:
  %v1099 = icmp eq i64 %v1100, %v19
  br i1 %v1099, label %v1096, label %v1095

v1096:
  %v1101 = load double, ptr %v505, align 8, !noalias !24
  %v1102 = fcmp ogt double %v1101, 5.000000e-01
  %v1103 = or i1 %v1085, %v1102
  br label %v1089

v1095:
  %v1104 = phi i64 [ %v1100, %v1098 ], [ 0, %v1094 ]
  %v1100 = add nsw i64 %v1104, 1
  %v1105 = getelementptr double, ptr %v205, i64 %v1104
  %v1106 = load double, ptr %v1105, align 8, !noalias !24
  %v1107 = add nsw i64 %v1104, %v18
  %v1108 = icmp slt i64 %v1107, 0
  %v1109 = select i1 %v1108, i64 %v167, i64 0
  %v1110 = getelementptr double, ptr %v166, i64 %v1107
  %v1111 = getelementptr double, ptr %v1110, i64 %v1109
  %v1112 = load double, ptr %v1111, align 8, !noalias !24
  %v1113 = fcmp une double %v1106, %v1112
  br i1 %v1113, label %v1097, label %v1098

v1089:
  %v1114 = phi i1 [ %v1085, %v1084 ], [ %v1103, %v1096 ], [ %v1085, %v1088 ]
  br i1 %v1114, label %v1115, label %v1083

v1115:
  br i1 %v306, label %v1116, label %v1117

v1116:
  %v1118 = load i64, ptr %v507, align 8, !noalias !25
  %v1119 = inttoptr i64 %v1118 to ptr
  tail call void %v1119(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !25
  %v1120 = load double, ptr %v509, align 8, !noalias !31
  %v1121 = fcmp ule double %v1120, 5.000000e-01
  %v1122 = select i1 %v1121, i1 true, i1 %v510
  br i1 %v1122, label %v1123, label %v1124

v1123:
  %v1125 = load i64, ptr %v502, align 8, !noalias !32
  %v1126 = inttoptr i64 %v1125 to ptr
  tail call void %v1126(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !32
  br label %v1117

v1124:
  %v1127 = phi i64 [ %v1128, %v1124 ], [ 0, %v1116 ]
  %v1128 = add nsw i64 %v1127, 1
  %v1129 = getelementptr double, ptr %v205, i64 %v1127
  %v1130 = load double, ptr %v1129, align 8, !noalias !31
  %v1131 = add nsw i64 %v1127, %v18
  %v1132 = icmp slt i64 %v1131, 0
  %v1133 = select i1 %v1132, i64 %v167, i64 0
  %v1134 = getelementptr double, ptr %v166, i64 %v1131
  %v1135 = getelementptr double, ptr %v1134, i64 %v1133
  store double %v1130, ptr %v1135, align 8, !noalias !31
  %v1136 = icmp eq i64 %v1128, %v19
  br i1 %v1136, label %v1123, label %v1124

v1117:
  br i1 %v511, label %v1137, label %v1138

v1137:
  %v1139 = load i64, ptr %v6, align 8, !noalias !35
  %v1140 = inttoptr i64 %v1139 to ptr
  tail call void %v1140(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v514), !noalias !35
  %v1141 = load i64, ptr %v515, align 8, !noalias !38
  %v1142 = inttoptr i64 %v1141 to ptr
  tail call void %v1142(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !38
  %v1143 = load i64, ptr %v516, align 8, !noalias !41
  %v1144 = inttoptr i64 %v1143 to ptr
  tail call void %v1144(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !41
  %v1145 = load i64, ptr %v6, align 8, !noalias !44
  %v1146 = inttoptr i64 %v1145 to ptr
  tail call void %v1146(ptr %v518, ptr %v520, ptr %v166, ptr %v173, ptr %v180, ptr %v522), !noalias !44
  %v1147 = load i64, ptr %v523, align 8, !noalias !47
  %v1148 = inttoptr i64 %v1147 to ptr
  tail call void %v1148(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !47
  br label %v1138

v1138:
  br i1 %v308, label %v1083, label %v1149

v1150:
  store double 0.000000e+00, ptr %v1151, align 8, !noalias !50
  %v1152 = getelementptr double, ptr %v528, i64 %v1153
  store double 0.000000e+00, ptr %v1152, align 8, !noalias !50
  %v1154 = getelementptr double, ptr %v530, i64 %v1153
  store double 0.000000e+00, ptr %v1154, align 8, !noalias !50
  %v1155 = getelementptr i64, ptr %v143, i64 %v1153
  %v1156 = load i64, ptr %v1155, align 8, !noalias !50
  %v1157 = icmp slt i64 %v1156, 0
  %v1158 = select i1 %v1157, i64 %v126, i64 0
  %v1159 = add i64 %v1158, %v1156
  %v1160 = mul i64 %v1159, %v127
  %v1161 = getelementptr i64, ptr %v125, i64 %v1160
  %v1162 = getelementptr i8, ptr %v1161, i64 8
  %v1163 = load i64, ptr %v1162, align 8, !noalias !50
  %v1164 = add nsw i64 %v1163, %v531
  store i64 %v1164, ptr %v1162, align 8, !noalias !50
  %v1165 = load i64, ptr %v1155, align 8, !noalias !50
  %v1166 = icmp slt i64 %v1165, 0
  %v1167 = select i1 %v1166, i64 %v126, i64 0
  %v1168 = add i64 %v1167, %v1165
  %v1169 = mul i64 %v1168, %v127
  %v1170 = getelementptr i64, ptr %v125, i64 %v1169
  %v1171 = getelementptr i8, ptr %v1170, i64 16
  %v1172 = load i64, ptr %v1171, align 8, !noalias !50
  %v1173 = add nsw i64 %v1172, %v533
  store i64 %v1173, ptr %v1171, align 8, !noalias !50
  %v1174 = getelementptr double, ptr %v535, i64 %v1153
  %v1175 = load double, ptr %v1174, align 8, !noalias !50
  %v1176 = fcmp une double %v1175, 0.000000e+00
  br i1 %v1176, label %v1177, label %v1178

v1177:
  %v1179 = load i64, ptr %v1155, align 8, !noalias !54
  %v1180 = icmp sgt i64 %v1179, -1
  br i1 %v1180, label %v1181, label %v1178

v1181:
  %v1182 = getelementptr i64, ptr %v111, i64 %v1179
  %v1183 = load i64, ptr %v1182, align 8, !noalias !54
  %v1184 = icmp eq i64 %v1183, 0
  br i1 %v1184, label %v1185, label %v1178

v1185:
  store i64 3, ptr %v1182, align 8, !noalias !54
  br label %v1178

v1178:
  br i1 %v305, label %v1186, label %v1187

v1186:
  %v1188 = load double, ptr %v537, align 8, !noalias !57
  %v1189 = load double, ptr %v93, align 8, !noalias !57
  %v1190 = fsub double %v1188, %v1189
  %v1191 = fmul double %v1190, 1.000000e-13
  %v1192 = load double, ptr %v134, align 8, !noalias !57
  %v1193 = tail call double @llvm.fabs.f64(double %v1192)
  %v1194 = fmul double %v1193, 4.000000e-15
  %v1195 = fcmp ogt double %v1194, %v1191
  %v1196 = select i1 %v1195, double %v1194, double %v1191
  %v1197 = fadd double %v1192, %v1196
  store double %v1197, ptr %v539, align 8, !noalias !67
  %v1198 = load i64, ptr %v6, align 8, !noalias !68
  %v1199 = inttoptr i64 %v1198 to ptr
  tail call void %v1199(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v540), !noalias !68
  br i1 %v541, label %v1200, label %v1201

v1200:
  %v1202 = load i64, ptr %v547, align 8, !noalias !71
  %v1203 = inttoptr i64 %v1202 to ptr
  tail call void %v1203(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v549), !noalias !71
  %v1204 = load i64, ptr %v547, align 8, !noalias !74
  %v1205 = inttoptr i64 %v1204 to ptr
  tail call void %v1205(ptr nonnull %v539, ptr %v551, ptr %v166, ptr %v173, ptr %v180, ptr %v553), !noalias !74
  br label %v1206

v1206:
  %v1207 = phi i64 [ %v19, %v1200 ], [ %v1208, %v1209 ]
  %v1210 = phi i64 [ %v555, %v1200 ], [ %v1211, %v1209 ]
  %v1212 = icmp sgt i64 %v1210, 0
  br i1 %v1212, label %v1209, label %v1213

v1209:
  %v1211 = add nsw i64 %v1210, -1
  %v1208 = add i64 %v1207, 1
  %v1214 = icmp slt i64 %v1207, 0
  %v1215 = select i1 %v1214, i64 %v208, i64 0
  %v1216 = add i64 %v1215, %v1207
  %v1217 = getelementptr double, ptr %v559, i64 %v1216
  %v1218 = load double, ptr %v1217, align 8, !noalias !67
  %v1219 = getelementptr double, ptr %v562, i64 %v1216
  %v1220 = load double, ptr %v1219, align 8, !noalias !67
  %v1221 = fsub double %v1218, %v1220
  %v1222 = tail call double @llvm.fabs.f64(double %v1221)
  %v1223 = getelementptr double, ptr %v564, i64 %v1216
  %v1224 = load double, ptr %v1223, align 8, !noalias !67
  %v1225 = tail call i1 @llvm.is.fpclass.f64(double %v1224, i32 543)
  %v1226 = select i1 %v1225, double 0.000000e+00, double %v1224
  %v1227 = fcmp ueq double %v1222, 0x7FF0000000000000
  %v1228 = select i1 %v1227, double -0.000000e+00, double %v1222
  %v1229 = fadd double %v1226, %v1228
  %v1230 = getelementptr double, ptr %v561, i64 %v1216
  %v1231 = load double, ptr %v1230, align 8, !noalias !67
  %v1232 = fneg double %v1229
  %v1233 = fcmp olt double %v1231, %v1232
  br i1 %v1233, label %v1213, label %v1206

v1201:
  %v1234 = phi i64 [ %v1235, %v1201 ], [ 0, %v1186 ]
  %v1235 = add nsw i64 %v1234, 1
  %v1236 = mul i64 %v1234, %v197
  %v1237 = getelementptr double, ptr %v194, i64 %v1236
  %v1238 = load double, ptr %v1237, align 8, !noalias !67
  %v1239 = getelementptr double, ptr %v544, i64 %v1236
  %v1240 = load double, ptr %v1239, align 8, !noalias !67
  %v1241 = fmul double %v1196, %v1240
  %v1242 = fadd double %v1238, %v1241
  %v1243 = getelementptr double, ptr %v546, i64 %v1236
  store double %v1242, ptr %v1243, align 8, !noalias !67
  %v1244 = icmp eq i64 %v10, %v1235
  br i1 %v1244, label %v1200, label %v1201

v1245:
  %v1246 = getelementptr i64, ptr %v566, i64 %v1153
  store i64 %v1247, ptr %v1246, align 8, !noalias !77
  %v1248 = load i64, ptr %v1155, align 8, !noalias !78
  %v1249 = icmp sgt i64 %v1248, -1
  br i1 %v1249, label %v1250, label %v1251

v1250:
  %v1252 = getelementptr i64, ptr %v111, i64 %v1248
  %v1253 = load i64, ptr %v1252, align 8, !noalias !78
  %v1254 = icmp eq i64 %v1253, 0
  br i1 %v1254, label %v1255, label %v1251

v1255:
  store i64 4, ptr %v1252, align 8, !noalias !78
  br label %v1251

v1251:
  %v1256 = getelementptr double, ptr %v134, i64 %v1153
  %v1257 = load double, ptr %v1256, align 8, !noalias !77
  %v1258 = getelementptr double, ptr %v568, i64 %v1153
  store double %v1257, ptr %v1258, align 8, !noalias !77
  %v1259 = getelementptr double, ptr %v570, i64 %v1153
  store double 0.000000e+00, ptr %v1259, align 8, !noalias !77
  br label %v1187

v1213:
  %v1247 = phi i64 [ %v1207, %v1209 ], [ -1, %v1206 ]
  %v1260 = icmp sgt i64 %v1247, -1
  br i1 %v1260, label %v1245, label %v1187

v1261:
  %v1262 = icmp sgt i64 %v1263, 1
  br i1 %v1262, label %v1149, label %v1083

v1149:
  %v1263 = phi i64 [ %v1264, %v1261 ], [ %v309, %v1138 ]
  %v1153 = phi i64 [ %v1265, %v1261 ], [ 0, %v1138 ]
  %v1264 = add nsw i64 %v1263, -1
  %v1265 = add nsw i64 %v1153, 1
  %v1151 = getelementptr double, ptr %v526, i64 %v1153
  %v1266 = load double, ptr %v1151, align 8, !noalias !50
  %v1267 = fcmp olt double %v1266, 5.000000e-01
  br i1 %v1267, label %v1261, label %v1150

v1187:
  %v1268 = getelementptr double, ptr %v572, i64 %v1153
  %v1269 = load double, ptr %v1268, align 8, !noalias !81
  %v1270 = getelementptr double, ptr %v574, i64 %v1153
  store double %v1269, ptr %v1270, align 8, !noalias !81
  %v1271 = getelementptr i64, ptr %v576, i64 %v1153
  %v1272 = load i64, ptr %v1271, align 8, !noalias !81
  %v1273 = icmp slt i64 %v1272, %v94
  br i1 %v1273, label %v1274, label %v1261

v1274:
  %v1275 = icmp slt i64 %v1272, 0
  %v1276 = select i1 %v1275, i64 %v94, i64 0
  %v1277 = getelementptr double, ptr %v93, i64 %v1272
  %v1278 = getelementptr double, ptr %v1277, i64 %v1276
  %v1279 = load double, ptr %v1278, align 8, !noalias !81
  %v1280 = load double, ptr %v1268, align 8, !noalias !81
  %v1281 = fcmp olt double %v1280, %v1279
  %v1282 = select i1 %v1281, double %v1280, double %v1279
  store double %v1282, ptr %v1270, align 8, !noalias !81
  br label %v1261

v1083:
  %v1283 = phi i1 [ %v661, %v1089 ], [ %v661, %v1074 ], [ true, %v1138 ], [ true, %v1261 ]
  %v1284 = load i64, ptr %v577, align 8, !noalias !85
  %v1285 = inttoptr i64 %v1284 to ptr
  tail call void %v1285(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !85
  br i1 %v578, label %v1286, label %v1287

v1288:
  %v1289 = getelementptr double, ptr %v663, i64 %v1290
  %v1291 = load double, ptr %v1289, align 8
  %v1292 = fcmp ogt double %v1291, 5.000000e-01
  br label %v1293

v1293:
  %v1294 = phi i1 [ true, %v1295 ], [ %v1292, %v1288 ]
  br i1 %v1296, label %v1297, label %v1298

v1298:
  %v1299 = getelementptr double, ptr %v665, i64 %v1290
  %v1300 = load double, ptr %v1299, align 8
  %v1301 = fcmp ogt double %v1300, 5.000000e-01
  br label %v1297

v1297:
  %v1302 = phi i1 [ true, %v1293 ], [ %v1301, %v1298 ]
  %v1303 = icmp sgt i64 %v1304, 1
  br i1 %v1303, label %v1295, label %v1305

v1305:
  %v1306 = phi i1 [ false, %v1307 ], [ %v1294, %v1297 ]
  %v1308 = phi i1 [ %v1283, %v1307 ], [ %v1302, %v1297 ]
  %v1309 = xor i1 %v1308, true
  %v1310 = or i1 %v308, %v1309
  br i1 %v1310, label %v1311, label %v1312

v1313:
  br i1 %v308, label %v1311, label %v1314

v1315:
  %v1316 = getelementptr double, ptr %v667, i64 %v1317
  %v1318 = load double, ptr %v1316, align 8, !noalias !91
  %v1319 = fptosi double %v1318 to i64
  %v1320 = getelementptr double, ptr %v669, i64 %v1317
  %v1321 = load double, ptr %v1320, align 8, !noalias !91
  %v1322 = fptosi double %v1321 to i64
  %v1323 = mul i64 %v1324, %v127
  %v1325 = getelementptr i64, ptr %v125, i64 %v1323
  %v1326 = load i64, ptr %v1325, align 8, !noalias !91
  %v1327 = add nsw i64 %v1326, %v1319
  store i64 %v1327, ptr %v1325, align 8, !noalias !91
  %v1328 = getelementptr i8, ptr %v1325, i64 24
  %v1329 = load i64, ptr %v1328, align 8, !noalias !91
  %v1330 = add nsw i64 %v1329, %v1322
  store i64 %v1330, ptr %v1328, align 8, !noalias !91
  %v1331 = getelementptr i8, ptr %v1325, i64 8
  %v1332 = load i64, ptr %v1331, align 8, !noalias !91
  %v1333 = add nsw i64 %v1322, %v1319
  %v1334 = mul nsw i64 %v1333, %v637
  %v1335 = add nsw i64 %v1334, %v1319
  %v1336 = add nsw i64 %v1335, %v1332
  store i64 %v1336, ptr %v1331, align 8, !noalias !91
  store double 0.000000e+00, ptr %v1316, align 8, !noalias !91
  store double 0.000000e+00, ptr %v1320, align 8, !noalias !91
  %v1337 = getelementptr double, ptr %v671, i64 %v1317
  %v1338 = load double, ptr %v1337, align 8, !noalias !91
  %v1339 = sitofp i64 %v1333 to double
  %v1340 = fsub double %v1338, %v1339
  store double %v1340, ptr %v1337, align 8, !noalias !91
  br label %v1341

v1341:
  %v1342 = icmp sgt i64 %v1343, 1
  br i1 %v1342, label %v1312, label %v1313

v1312:
  %v1343 = phi i64 [ %v1344, %v1341 ], [ %v309, %v1305 ]
  %v1317 = phi i64 [ %v1345, %v1341 ], [ 0, %v1305 ]
  %v1344 = add nsw i64 %v1343, -1
  %v1345 = add nsw i64 %v1317, 1
  %v1346 = getelementptr i64, ptr %v143, i64 %v1317
  %v1324 = load i64, ptr %v1346, align 8, !noalias !91
  %v1347 = icmp sgt i64 %v1324, -1
  br i1 %v1347, label %v1315, label %v1341

v1348:
  %v1349 = getelementptr double, ptr %v677, i64 %v1350
  %v1351 = load double, ptr %v1349, align 8, !noalias !98
  %v1352 = fcmp ogt double %v1351, 5.000000e-01
  br i1 %v1352, label %v1353, label %v1354

v1353:
  %v1355 = fptosi double %v1351 to i64
  %v1356 = load i64, ptr %v1357, align 8, !noalias !99
  %v1358 = icmp sgt i64 %v1356, -1
  br i1 %v1358, label %v1359, label %v1354

v1354:
  %v1360 = getelementptr double, ptr %v679, i64 %v1350
  %v1361 = load double, ptr %v1360, align 8, !noalias !98
  %v1362 = fcmp ogt double %v1361, 5.000000e-01
  br i1 %v1362, label %v1363, label %v1364

v1363:
  %v1365 = select i1 %v1366, i1 true, i1 %v305
  %v1367 = icmp slt i64 %v1368, %v94
  br i1 %v1367, label %v1369, label %v1370

v1369:
  %v1371 = icmp slt i64 %v1368, 0
  %v1372 = select i1 %v1371, i64 %v94, i64 0
  %v1373 = getelementptr double, ptr %v93, i64 %v1368
  %v1374 = getelementptr double, ptr %v1373, i64 %v1372
  %v1375 = load double, ptr %v1374, align 8, !noalias !98
  %v1376 = getelementptr double, ptr %v681, i64 %v1350
  %v1377 = load double, ptr %v1376, align 8, !noalias !98
  %v1378 = fcmp olt double %v1375, %v1377
  br i1 %v1378, label %v1379, label %v1370

v1379:
  br label %v1370

v1370:
  %v1380 = phi i1 [ true, %v1379 ], [ %v1365, %v1369 ], [ %v1365, %v1363 ]
  %v1381 = mul i64 %v1382, %v127
  %v1383 = getelementptr i64, ptr %v125, i64 %v1381
  %v1384 = load i64, ptr %v1383, align 8, !noalias !98
  %v1385 = and i64 %v1384, 127
  %v1386 = icmp eq i64 %v1385, 0
  br i1 %v1386, label %v1387, label %v1388

v1388:
  %v1389 = getelementptr double, ptr %v683, i64 %v1350
  %v1390 = load double, ptr %v1389, align 8, !noalias !98
  %v1391 = fcmp ogt double %v1390, 0.000000e+00
  br i1 %v1391, label %v1387, label %v1364

v1387:
  store double 1.000000e+00, ptr %v1392, align 8, !noalias !98
  br label %v1364

v1364:
  %v1393 = phi i1 [ %v1380, %v1387 ], [ %v1380, %v1388 ], [ %v1366, %v1354 ], [ %v1366, %v1314 ]
  %v1394 = phi i1 [ true, %v1387 ], [ %v1395, %v1388 ], [ %v1395, %v1354 ], [ %v1395, %v1314 ]
  %v1396 = icmp sgt i64 %v1397, 1
  br i1 %v1396, label %v1314, label %v1398

v1314:
  %v1395 = phi i1 [ %v1394, %v1364 ], [ false, %v1313 ]
  %v1366 = phi i1 [ %v1393, %v1364 ], [ false, %v1313 ]
  %v1397 = phi i64 [ %v1399, %v1364 ], [ %v309, %v1313 ]
  %v1350 = phi i64 [ %v1400, %v1364 ], [ 0, %v1313 ]
  %v1399 = add nsw i64 %v1397, -1
  %v1400 = add nsw i64 %v1350, 1
  %v1357 = getelementptr i64, ptr %v143, i64 %v1350
  %v1382 = load i64, ptr %v1357, align 8, !noalias !98
  %v1401 = getelementptr i64, ptr %v673, i64 %v1350
  %v1368 = load i64, ptr %v1401, align 8, !noalias !98
  %v1392 = getelementptr double, ptr %v675, i64 %v1350
  store double 0.000000e+00, ptr %v1392, align 8, !noalias !98
  %v1402 = icmp sgt i64 %v1382, -1
  br i1 %v1402, label %v1348, label %v1364

v1359:
  %v1403 = getelementptr i64, ptr %v111, i64 %v1356
  %v1404 = load i64, ptr %v1403, align 8, !noalias !99
  %v1405 = icmp eq i64 %v1404, 0
  br i1 %v1405, label %v1406, label %v1354

v1406:
  store i64 %v1355, ptr %v1403, align 8, !noalias !99
  br label %v1354

v1311:
  %v1407 = phi i1 [ true, %v1305 ], [ true, %v1313 ], [ %v1408, %v1398 ]
  %v1409 = phi i1 [ true, %v1305 ], [ true, %v1313 ], [ %v1410, %v1398 ]
  %v1411 = and i1 %v684, %v1306
  br i1 %v1411, label %v1412, label %v1413

v1412:
  %v1414 = load i64, ptr %v6, align 8, !noalias !102
  %v1415 = inttoptr i64 %v1414 to ptr
  tail call void %v1415(ptr %v689, ptr %v692, ptr %v166, ptr %v173, ptr %v180, ptr %v694), !noalias !102
  br label %v1413

v1413:
  br i1 %v1409, label %v1416, label %v1417

v1417:
  %v1418 = load i64, ptr %v695, align 8, !noalias !108
  %v1419 = inttoptr i64 %v1418 to ptr
  tail call void %v1419(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !108
  br label %v1416

v1416:
  %v1420 = select i1 %v1306, i1 %v305, i1 false
  %v1421 = xor i1 %v1306, true
  %v1422 = select i1 %v306, i1 %v1306, i1 false
  %v1423 = xor i1 %v1422, true
  %v1424 = select i1 %v1423, i1 true, i1 %v1420
  %v1425 = select i1 %v306, i1 %v1306, i1 %v1420
  br i1 %v1424, label %v1426, label %v1427

v1427:
  %v1428 = load i64, ptr %v696, align 8, !noalias !111
  %v1429 = inttoptr i64 %v1428 to ptr
  tail call void %v1429(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !111
  br label %v1430

v1430:
  %v1431 = phi i64 [ 0, %v1427 ], [ %v1432, %v1433 ]
  %v1432 = add nsw i64 %v1431, 1
  %v1434 = icmp ult i64 %v1431, 9
  br i1 %v1434, label %v1435, label %v1436

v1435:
  %v1437 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v1431
  %v1438 = load double, ptr %v1437, align 8
  %v1439 = load double, ptr %v134, align 8, !noalias !114
  %v1440 = load double, ptr %v699, align 8, !noalias !114
  %v1441 = fmul double %v1438, %v1440
  %v1442 = fadd double %v1439, %v1441
  store double %v1442, ptr %v701, align 8, !noalias !114
  br i1 %v703, label %v1433, label %v1443

v1443:
  %v1444 = fsub double 1.000000e+00, %v1438
  br label %v1445

v1445:
  %v1446 = phi i64 [ 0, %v1443 ], [ %v1447, %v1445 ]
  %v1448 = mul i64 %v1446, %v197
  %v1449 = getelementptr double, ptr %v194, i64 %v1448
  %v1450 = getelementptr i8, ptr %v1449, i64 %v707
  %v1451 = load double, ptr %v1450, align 8, !noalias !124
  %v1452 = fadd double %v1451, 0.000000e+00
  %v1453 = fmul double %v1438, %v1452
  %v1454 = getelementptr i8, ptr %v1449, i64 %v708
  %v1455 = load double, ptr %v1454, align 8, !noalias !124
  %v1456 = fadd double %v1455, %v1453
  %v1457 = fmul double %v1444, %v1456
  %v1458 = getelementptr i8, ptr %v1449, i64 %v709
  %v1459 = load double, ptr %v1458, align 8, !noalias !124
  %v1460 = fadd double %v1459, %v1457
  %v1461 = fmul double %v1438, %v1460
  %v1462 = getelementptr i8, ptr %v1449, i64 %v710
  %v1463 = load double, ptr %v1462, align 8, !noalias !124
  %v1464 = fadd double %v1463, %v1461
  %v1465 = fmul double %v1444, %v1464
  %v1466 = getelementptr i8, ptr %v1449, i64 %v711
  %v1467 = load double, ptr %v1466, align 8, !noalias !124
  %v1468 = fadd double %v1467, %v1465
  %v1469 = fmul double %v1438, %v1468
  %v1470 = getelementptr i8, ptr %v1449, i64 %v712
  %v1471 = load double, ptr %v1470, align 8, !noalias !124
  %v1472 = fadd double %v1471, %v1469
  %v1473 = fmul double %v1444, %v1472
  %v1474 = getelementptr i8, ptr %v1449, i64 %v713
  %v1475 = load double, ptr %v1474, align 8, !noalias !124
  %v1476 = fadd double %v1475, %v1473
  %v1477 = fmul double %v1438, %v1476
  %v1447 = add nsw i64 %v1446, 1
  %v1478 = load double, ptr %v1449, align 8, !noalias !124
  %v1479 = fadd double %v1478, %v1477
  %v1480 = getelementptr double, ptr %v704, i64 %v1448
  store double %v1479, ptr %v1480, align 8, !noalias !114
  %v1481 = icmp eq i64 %v10, %v1447
  br i1 %v1481, label %v1433, label %v1445

v1433:
  %v1482 = icmp eq i64 %v1431, 8
  %v1483 = select i1 %v1482, i64 17, i64 16
  %v1484 = mul i64 %v705, %v1431
  %v1485 = load i64, ptr %v706, align 8, !noalias !128
  %v1486 = mul nsw i64 %v1483, %v10
  %v1487 = getelementptr double, ptr %v159, i64 %v1486
  %v1488 = getelementptr double, ptr %v187, i64 %v1484
  %v1489 = inttoptr i64 %v1485 to ptr
  tail call void %v1489(ptr nonnull %v701, ptr %v1487, ptr %v166, ptr %v173, ptr %v180, ptr %v1488), !noalias !128
  %v1490 = icmp eq i64 %v1432, 9
  br i1 %v1490, label %v1436, label %v1430

v1436:
  %v1491 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v1430 ], [ null, %v1433 ]
  %v1492 = phi i32 [ 1, %v1430 ], [ 0, %v1433 ]
  br i1 %v1434, label %v1493, label %v1494, !prof !131

v1426:
  %v1495 = phi i1 [ %v1425, %v1416 ], [ %v1496, %v1494 ]
  %v1497 = xor i1 %v1407, true
  %v1498 = select i1 %v1497, i1 true, i1 %v1495
  br i1 %v1498, label %v1499, label %v1500

v1499:
  br i1 %v724, label %v1501, label %v1502

v1503:
  %v1504 = load i64, ptr %v735, align 8, !noalias !132
  %v1505 = inttoptr i64 %v1504 to ptr
  tail call void %v1505(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !132
  br label %v1502

v1501:
  %v1506 = phi i64 [ %v1507, %v1501 ], [ 1, %v1499 ]
  %v1507 = add i64 %v1506, 1
  %v1508 = add nsw i64 %v725, %v1506
  %v1509 = icmp slt i64 %v1508, 0
  %v1510 = select i1 %v1509, i64 %v7, i64 0
  %v1511 = getelementptr i64, ptr %v6, i64 %v1508
  %v1512 = getelementptr i64, ptr %v1511, i64 %v1510
  %v1513 = load i64, ptr %v1512, align 8, !noalias !138
  %v1514 = inttoptr i64 %v1513 to ptr
  tail call void %v1514(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !138
  %v1515 = add nsw i64 %v1506, 13
  %v1516 = load i64, ptr %v6, align 8, !noalias !141
  %v1517 = mul nsw i64 %v1515, %v728
  %v1518 = getelementptr double, ptr %v159, i64 %v1517
  %v1519 = inttoptr i64 %v1516 to ptr
  tail call void %v1519(ptr %v727, ptr %v730, ptr %v166, ptr %v173, ptr %v180, ptr %v1518), !noalias !141
  %v1520 = icmp eq i64 %v1506, %v12
  br i1 %v1520, label %v1503, label %v1501

v1502:
  %v1521 = load i64, ptr %v736, align 8, !noalias !144
  %v1522 = inttoptr i64 %v1521 to ptr
  tail call void %v1522(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !144
  %v1523 = select i1 %v687, i1 true, i1 %v1421
  %v1524 = or i1 %v1523, %v308
  br i1 %v1524, label %v1525, label %v1526

v1527:
  %v1528 = getelementptr double, ptr %v740, i64 %v1529
  %v1530 = load double, ptr %v1528, align 8, !noalias !147
  %v1531 = fcmp uge double %v1530, 5.000000e-01
  %v1532 = icmp slt i64 %v1533, %v94
  %v1534 = select i1 %v1531, i1 %v1532, i1 false
  br i1 %v1534, label %v1535, label %v1536

v1535:
  %v1537 = icmp slt i64 %v1533, 0
  %v1538 = select i1 %v1537, i64 %v94, i64 0
  %v1539 = getelementptr double, ptr %v93, i64 %v1533
  %v1540 = getelementptr double, ptr %v1539, i64 %v1538
  %v1541 = load double, ptr %v1540, align 8, !noalias !147
  %v1542 = getelementptr double, ptr %v742, i64 %v1529
  %v1543 = load double, ptr %v1542, align 8, !noalias !147
  %v1544 = fcmp olt double %v1541, %v1543
  br i1 %v1544, label %v1545, label %v1536

v1545:
  %v1546 = getelementptr double, ptr %v744, i64 %v1529
  %v1547 = load double, ptr %v1546, align 8, !noalias !147
  %v1548 = fcmp ogt double %v1547, 1.000000e+00
  br i1 %v1548, label %v1549, label %v1536

v1549:
  %v1550 = getelementptr double, ptr %v746, i64 %v1529
  %v1551 = load double, ptr %v1550, align 8, !noalias !147
  store double 0.000000e+00, ptr %v1528, align 8, !noalias !151
  %v1552 = getelementptr double, ptr %v748, i64 %v1529
  store double 0.000000e+00, ptr %v1552, align 8, !noalias !151
  %v1553 = getelementptr double, ptr %v749, i64 %v1529
  store double %v1551, ptr %v1553, align 8, !noalias !151
  %v1554 = load i64, ptr %v1555, align 8, !noalias !151
  %v1556 = icmp slt i64 %v1554, 0
  %v1557 = select i1 %v1556, i64 %v126, i64 0
  %v1558 = add i64 %v1557, %v1554
  %v1559 = mul i64 %v1558, %v127
  %v1560 = getelementptr i64, ptr %v125, i64 %v1559
  %v1561 = load i64, ptr %v1560, align 8, !noalias !151
  %v1562 = add nsw i64 %v1561, -1
  store i64 %v1562, ptr %v1560, align 8, !noalias !151
  %v1563 = load i64, ptr %v1555, align 8, !noalias !151
  %v1564 = icmp slt i64 %v1563, 0
  %v1565 = select i1 %v1564, i64 %v126, i64 0
  %v1566 = add i64 %v1565, %v1563
  %v1567 = mul i64 %v1566, %v127
  %v1568 = getelementptr i64, ptr %v125, i64 %v1567
  %v1569 = getelementptr i8, ptr %v1568, i64 24
  %v1570 = load i64, ptr %v1569, align 8, !noalias !151
  %v1571 = add nsw i64 %v1570, 1
  store i64 %v1571, ptr %v1569, align 8, !noalias !151
  %v1572 = load double, ptr %v1540, align 8, !noalias !147
  %v1573 = getelementptr double, ptr %v751, i64 %v1529
  store double %v1572, ptr %v1573, align 8, !noalias !147
  %v1574 = mul i64 %v1575, %v127
  %v1576 = getelementptr i64, ptr %v125, i64 %v1574
  %v1577 = getelementptr i8, ptr %v1576, i64 8
  %v1578 = load i64, ptr %v1577, align 8, !noalias !147
  %v1579 = add nsw i64 %v1578, %v12
  store i64 %v1579, ptr %v1577, align 8, !noalias !147
  br label %v1536

v1536:
  %v1580 = icmp sgt i64 %v1581, 1
  br i1 %v1580, label %v1526, label %v1525

v1526:
  %v1581 = phi i64 [ %v1582, %v1536 ], [ %v309, %v1502 ]
  %v1529 = phi i64 [ %v1583, %v1536 ], [ 0, %v1502 ]
  %v1582 = add nsw i64 %v1581, -1
  %v1583 = add nsw i64 %v1529, 1
  %v1555 = getelementptr i64, ptr %v143, i64 %v1529
  %v1575 = load i64, ptr %v1555, align 8, !noalias !147
  %v1584 = getelementptr i64, ptr %v738, i64 %v1529
  %v1533 = load i64, ptr %v1584, align 8, !noalias !147
  %v1585 = icmp slt i64 %v1575, 0
  br i1 %v1585, label %v1536, label %v1527

v1525:
  br i1 %v1495, label %v1586, label %v1587

v1586:
  call void @llvm.lifetime.start.p0(ptr nonnull %v303)
  call void @llvm.lifetime.start.p0(ptr nonnull %v304)
  store i8 0, ptr %v303, align 1, !noalias !154
  store ptr null, ptr %v304, align 8, !noalias !154
  br label %v1588

v1588:
  %v1589 = phi i64 [ 0, %v1586 ], [ %v1590, %v1591 ]
  %v1590 = add nsw i64 %v1589, 1
  %v1592 = icmp ult i64 %v1589, 9
  br i1 %v1592, label %v1593, label %v1594

v1593:
  %v1595 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v1589
  %v1596 = load double, ptr %v1595, align 8
  %v1597 = load double, ptr %v134, align 8, !noalias !158
  %v1598 = load double, ptr %v754, align 8, !noalias !158
  %v1599 = fmul double %v1596, %v1598
  %v1600 = fadd double %v1597, %v1599
  store double %v1600, ptr %v756, align 8, !noalias !158
  br i1 %v758, label %v1591, label %v1601

v1601:
  %v1602 = fsub double 1.000000e+00, %v1596
  br label %v1603

v1603:
  %v1604 = phi i64 [ 0, %v1601 ], [ %v1605, %v1603 ]
  %v1606 = mul i64 %v1604, %v197
  %v1607 = getelementptr double, ptr %v194, i64 %v1606
  %v1608 = getelementptr i8, ptr %v1607, i64 %v762
  %v1609 = load double, ptr %v1608, align 8, !noalias !165
  %v1610 = fadd double %v1609, 0.000000e+00
  %v1611 = fmul double %v1596, %v1610
  %v1612 = getelementptr i8, ptr %v1607, i64 %v763
  %v1613 = load double, ptr %v1612, align 8, !noalias !165
  %v1614 = fadd double %v1613, %v1611
  %v1615 = fmul double %v1602, %v1614
  %v1616 = getelementptr i8, ptr %v1607, i64 %v764
  %v1617 = load double, ptr %v1616, align 8, !noalias !165
  %v1618 = fadd double %v1617, %v1615
  %v1619 = fmul double %v1596, %v1618
  %v1620 = getelementptr i8, ptr %v1607, i64 %v765
  %v1621 = load double, ptr %v1620, align 8, !noalias !165
  %v1622 = fadd double %v1621, %v1619
  %v1623 = fmul double %v1602, %v1622
  %v1624 = getelementptr i8, ptr %v1607, i64 %v766
  %v1625 = load double, ptr %v1624, align 8, !noalias !165
  %v1626 = fadd double %v1625, %v1623
  %v1627 = fmul double %v1596, %v1626
  %v1628 = getelementptr i8, ptr %v1607, i64 %v767
  %v1629 = load double, ptr %v1628, align 8, !noalias !165
  %v1630 = fadd double %v1629, %v1627
  %v1631 = fmul double %v1602, %v1630
  %v1632 = getelementptr i8, ptr %v1607, i64 %v768
  %v1633 = load double, ptr %v1632, align 8, !noalias !165
  %v1634 = fadd double %v1633, %v1631
  %v1635 = fmul double %v1596, %v1634
  %v1605 = add nsw i64 %v1604, 1
  %v1636 = load double, ptr %v1607, align 8, !noalias !165
  %v1637 = fadd double %v1636, %v1635
  %v1638 = getelementptr double, ptr %v759, i64 %v1606
  store double %v1637, ptr %v1638, align 8, !noalias !158
  %v1639 = icmp eq i64 %v10, %v1605
  br i1 %v1639, label %v1591, label %v1603

v1591:
  %v1640 = icmp eq i64 %v1589, 8
  %v1641 = select i1 %v1640, i64 17, i64 16
  %v1642 = mul i64 %v1589, %v760
  %v1643 = load i64, ptr %v761, align 8, !noalias !169
  %v1644 = mul nsw i64 %v1641, %v10
  %v1645 = getelementptr double, ptr %v159, i64 %v1644
  %v1646 = getelementptr double, ptr %v187, i64 %v1642
  %v1647 = inttoptr i64 %v1643 to ptr
  tail call void %v1647(ptr nonnull %v756, ptr %v1645, ptr %v166, ptr %v173, ptr %v180, ptr %v1646), !noalias !169
  %v1648 = icmp eq i64 %v1590, 9
  br i1 %v1648, label %v1594, label %v1588

v1594:
  %v1649 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v1588 ], [ null, %v1591 ]
  %v1650 = phi i32 [ 1, %v1588 ], [ 0, %v1591 ]
  br i1 %v1592, label %v1651, label %v1652, !prof !131

v1651:
  %v1653 = load double, ptr %v770, align 8, !noalias !172
  %v1654 = load double, ptr %v93, align 8, !noalias !172
  %v1655 = fsub double %v1653, %v1654
  %v1656 = fmul double %v1655, 1.000000e-13
  %v1657 = load double, ptr %v134, align 8, !noalias !172
  %v1658 = tail call double @llvm.fabs.f64(double %v1657)
  %v1659 = fmul double %v1658, 4.000000e-15
  %v1660 = fcmp ogt double %v1659, %v1656
  %v1661 = select i1 %v1660, double %v1659, double %v1656
  %v1662 = load double, ptr %v754, align 8, !noalias !179
  %v1663 = fdiv double %v1661, %v1662
  %v1664 = fcmp olt double %v1663, 1.000000e+00
  %v1665 = select i1 %v1664, double %v1663, double 1.000000e+00
  br i1 %v771, label %v1666, label %v1667

v1668:
  %v1669 = fcmp olt double %v1670, %v1671
  %v1672 = select i1 %v1669, double %v1670, double %v1671
  %v1673 = fcmp ogt double %v1670, %v1674
  %v1675 = select i1 %v1673, double %v1670, double %v1674
  br label %v1676

v1676:
  %v1677 = phi double [ %v1675, %v1668 ], [ %v1674, %v1678 ]
  %v1679 = phi double [ %v1672, %v1668 ], [ %v1671, %v1678 ]
  %v1680 = icmp eq i64 %v1681, 9
  br i1 %v1680, label %v1682, label %v1678

v1682:
  %v1683 = fsub double %v1677, %v1679
  %v1684 = fmul double %v1665, %v1683
  %v1685 = tail call i1 @llvm.is.fpclass.f64(double %v1686, i32 543)
  %v1687 = select i1 %v1685, double 0.000000e+00, double %v1686
  %v1688 = tail call i1 @llvm.is.fpclass.f64(double %v1684, i32 543)
  %v1689 = select i1 %v1688, double -0.000000e+00, double %v1684
  %v1690 = fadd double %v1687, %v1689
  %v1691 = getelementptr double, ptr %v774, i64 %v1692
  %v1693 = load double, ptr %v1691, align 8, !noalias !179
  %v1694 = sub nsw i64 %v1695, %v19
  %v1696 = getelementptr double, ptr %v216, i64 %v1694
  %v1697 = load double, ptr %v1696, align 8, !noalias !179
  %v1698 = getelementptr double, ptr %v775, i64 %v1692
  store double %v1690, ptr %v1698, align 8, !noalias !179
  %v1699 = fcmp ule double %v1697, 5.000000e-01
  %v1700 = fcmp ule double %v1693, 0.000000e+00
  %v1701 = select i1 %v1699, i1 true, i1 %v1700
  %v1702 = select i1 %v1701, double %v1690, double 0.000000e+00
  %v1703 = getelementptr double, ptr %v1698, i64 %v772
  store double %v1702, ptr %v1703, align 8, !noalias !179
  %v1704 = getelementptr i8, ptr %v1698, i64 %v776
  store double %v1702, ptr %v1704, align 8, !noalias !179
  %v1705 = getelementptr i8, ptr %v1698, i64 %v777
  store double %v1702, ptr %v1705, align 8, !noalias !179
  %v1706 = getelementptr i8, ptr %v1698, i64 %v778
  store double %v1702, ptr %v1706, align 8, !noalias !179
  %v1707 = getelementptr i8, ptr %v1698, i64 %v779
  store double %v1702, ptr %v1707, align 8, !noalias !179
  %v1708 = getelementptr i8, ptr %v1698, i64 %v780
  store double %v1702, ptr %v1708, align 8, !noalias !179
  %v1709 = getelementptr i8, ptr %v1698, i64 %v781
  store double %v1702, ptr %v1709, align 8, !noalias !179
  %v1710 = getelementptr i8, ptr %v1698, i64 %v782
  store double %v1702, ptr %v1710, align 8, !noalias !179
  %v1711 = add nsw i64 %v1712, -1
  %v1713 = add i64 %v1695, 1
  %v1714 = icmp sgt i64 %v1712, 1
  br i1 %v1714, label %v1667, label %v1666

v1667:
  %v1712 = phi i64 [ %v1711, %v1682 ], [ %v16, %v1651 ]
  %v1695 = phi i64 [ %v1713, %v1682 ], [ %v19, %v1651 ]
  %v1715 = icmp slt i64 %v1695, 0
  %v1716 = select i1 %v1715, i64 %v208, i64 0
  %v1692 = add i64 %v1716, %v1695
  br label %v1678

v1678:
  %v1671 = phi double [ 0x7FF0000000000000, %v1667 ], [ %v1679, %v1676 ]
  %v1674 = phi double [ 0xFFF0000000000000, %v1667 ], [ %v1677, %v1676 ]
  %v1717 = phi double [ 0.000000e+00, %v1667 ], [ %v1686, %v1676 ]
  %v1718 = phi i64 [ 0, %v1667 ], [ %v1681, %v1676 ]
  %v1681 = add nsw i64 %v1718, 1
  %v1719 = mul i64 %v1718, %v772
  %v1720 = getelementptr double, ptr %v205, i64 %v1719
  %v1721 = getelementptr i8, ptr %v1720, i64 %v773
  %v1722 = getelementptr double, ptr %v1721, i64 %v1692
  %v1723 = load double, ptr %v1722, align 8, !noalias !179
  %v1724 = tail call i1 @llvm.is.fpclass.f64(double %v1723, i32 543)
  %v1725 = fadd double %v1723, 0.000000e+00
  %v1726 = select i1 %v1724, double 0.000000e+00, double %v1725
  %v1727 = fcmp ogt double %v1726, %v1717
  %v1686 = select i1 %v1727, double %v1726, double %v1717
  %v1728 = getelementptr double, ptr %v1720, i64 %v208
  %v1729 = getelementptr double, ptr %v1728, i64 %v1692
  %v1670 = load double, ptr %v1729, align 8, !noalias !179
  %v1730 = tail call double @llvm.fabs.f64(double %v1670)
  %v1731 = fcmp ueq double %v1730, 0x7FF0000000000000
  br i1 %v1731, label %v1676, label %v1668

v1666:
  store i8 0, ptr %v303, align 1, !noalias !154
  %v1732 = call fastcc i32 @_ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr %v303, ptr %v304, i64 %v13, ptr nonnull readonly %v93, i64 %v94, ptr %v125, i64 %v126, i64 %v127, ptr nonnull %v134, i64 %v136, ptr %v143, i64 %v145, ptr %v205, i64 %v206, i64 %v207, i64 %v208, double 0.000000e+00)
  %v1733 = icmp eq i32 %v1732, 0
  br i1 %v1733, label %v1734, label %v1735, !prof !131

v1735:
  %v1736 = load ptr, ptr %v304, align 8, !noalias !154
  br label %v1652

v1734:
  %v1737 = load i8, ptr %v303, align 1, !noalias !154
  %v1738 = icmp eq i8 %v1737, 0
  br label %v1652

v1652:
  %v1739 = phi i1 [ %v1738, %v1734 ], [ true, %v1735 ], [ true, %v1594 ]
  %v1740 = phi ptr [ null, %v1734 ], [ %v1736, %v1735 ], [ %v1649, %v1594 ]
  %v1741 = phi i32 [ 0, %v1734 ], [ 1, %v1735 ], [ %v1650, %v1594 ]
  call void @llvm.lifetime.end.p0(ptr nonnull %v303)
  call void @llvm.lifetime.end.p0(ptr nonnull %v304)
  %v1742 = icmp eq i32 %v1741, 0
  %v1743 = select i1 %v1742, ptr undef, ptr %v1740
  br i1 %v1742, label %v1744, label %v1500, !prof !131

v1745:
  %v1746 = load double, ptr %v784, align 8, !noalias !180
  %v1747 = load double, ptr %v754, align 8, !noalias !180
  %v1748 = load double, ptr %v786, align 8, !noalias !180
  %v1749 = load double, ptr %v93, align 8, !noalias !180
  %v1750 = fsub double %v1748, %v1749
  %v1751 = load double, ptr %v788, align 8, !noalias !180
  %v1752 = load double, ptr %v790, align 8, !noalias !180
  %v1753 = fsub double %v1751, %v1752
  %v1754 = fmul double %v1750, 5.000000e-06
  %v1755 = fcmp olt double %v1753, %v1754
  br label %v1756

v1757:
  %v1758 = sub nsw i64 45, %v1759
  %v1760 = load double, ptr %v795, align 8, !noalias !184
  %v1761 = load double, ptr %v797, align 8, !noalias !184
  br label %v1762

v1762:
  %v1763 = phi double [ %v1764, %v1762 ], [ 1.000000e+00, %v1757 ]
  %v1765 = phi double [ %v1766, %v1762 ], [ 2.000000e+00, %v1757 ]
  %v1767 = phi i64 [ %v1768, %v1762 ], [ %v1758, %v1757 ]
  %v1769 = and i64 %v1767, 1
  %v1770 = icmp eq i64 %v1769, 0
  %v1771 = fmul double %v1763, %v1765
  %v1764 = select i1 %v1770, double %v1763, double %v1771
  %v1768 = lshr i64 %v1767, 1
  %v1766 = fmul double %v1765, %v1765
  %v1772 = icmp eq i64 %v1768, 0
  br i1 %v1772, label %v1773, label %v1762

v1774:
  %v1775 = fcmp olt double %v1776, 0.000000e+00
  %v1777 = select i1 %v1775, double 0.000000e+00, double %v1776
  %v1778 = fmul double %v1779, %v1777
  %v1780 = fsub double %v1781, %v1778
  br label %v1782

v1773:
  %v1783 = fadd double %v1784, %v1785
  %v1781 = fmul double %v1783, 5.000000e-01
  %v1786 = fmul double %v1764, 1.000000e-13
  %v1787 = fsub double %v1786, %v1788
  %v1776 = fmul double %v1787, 5.000000e-01
  %v1789 = fmul double %v1785, %v1761
  %v1790 = fmul double %v1784, %v1760
  %v1791 = fsub double %v1789, %v1790
  %v1792 = fsub double %v1761, %v1760
  %v1793 = fdiv double %v1791, %v1792
  %v1794 = fcmp olt double %v1785, %v1793
  %v1795 = fcmp olt double %v1793, %v1784
  %v1796 = and i1 %v1794, %v1795
  %v1797 = select i1 %v1796, double %v1793, double %v1781
  %v1798 = fsub double %v1781, %v1797
  %v1779 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v1798)
  %v1799 = fmul double %v1788, %v1788
  %v1800 = tail call double @llvm.fabs.f64(double %v1798)
  %v1801 = fcmp olt double %v1800, %v1799
  %v1802 = select i1 %v1801, double %v1800, double %v1799
  %v1803 = fmul double %v1779, %v1802
  %v1804 = fadd double %v1797, %v1803
  %v1805 = fsub double %v1804, %v1781
  %v1806 = tail call double @llvm.fabs.f64(double %v1805)
  %v1807 = fcmp ugt double %v1806, %v1776
  br i1 %v1807, label %v1774, label %v1782

v1808:
  store double %v1809, ptr %v792, align 8, !noalias !190
  store double %v1810, ptr %v797, align 8, !noalias !190
  br label %v1811

v1812:
  store double %v1809, ptr %v784, align 8, !noalias !190
  store double %v1810, ptr %v795, align 8, !noalias !190
  br label %v1811

v1811:
  %v1813 = icmp eq i64 %v1814, 45
  br i1 %v1813, label %v1815, label %v1756

v1756:
  %v1759 = phi i64 [ 0, %v1745 ], [ %v1814, %v1811 ]
  %v1814 = add nsw i64 %v1759, 1
  %v1784 = load double, ptr %v792, align 8, !noalias !190
  %v1785 = load double, ptr %v784, align 8, !noalias !190
  %v1788 = fsub double %v1784, %v1785
  %v1816 = fcmp ugt double %v1788, 1.000000e-13
  br i1 %v1816, label %v1757, label %v1815

v1782:
  %v1809 = phi double [ %v1804, %v1773 ], [ %v1780, %v1774 ]
  %v1817 = load double, ptr %v134, align 8, !noalias !191
  %v1818 = load double, ptr %v754, align 8, !noalias !191
  %v1819 = fmul double %v1809, %v1818
  %v1820 = fadd double %v1817, %v1819
  store double %v1820, ptr %v756, align 8, !noalias !191
  br i1 %v798, label %v1821, label %v1822

v1821:
  %v1823 = fsub double 1.000000e+00, %v1809
  br label %v1824

v1824:
  %v1825 = phi i64 [ 0, %v1821 ], [ %v1826, %v1824 ]
  %v1827 = mul i64 %v1825, %v197
  %v1828 = getelementptr double, ptr %v194, i64 %v1827
  %v1829 = getelementptr i8, ptr %v1828, i64 %v762
  %v1830 = load double, ptr %v1829, align 8, !noalias !198
  %v1831 = fadd double %v1830, 0.000000e+00
  %v1832 = fmul double %v1809, %v1831
  %v1833 = getelementptr i8, ptr %v1828, i64 %v763
  %v1834 = load double, ptr %v1833, align 8, !noalias !198
  %v1835 = fadd double %v1834, %v1832
  %v1836 = fmul double %v1823, %v1835
  %v1837 = getelementptr i8, ptr %v1828, i64 %v764
  %v1838 = load double, ptr %v1837, align 8, !noalias !198
  %v1839 = fadd double %v1838, %v1836
  %v1840 = fmul double %v1809, %v1839
  %v1841 = getelementptr i8, ptr %v1828, i64 %v765
  %v1842 = load double, ptr %v1841, align 8, !noalias !198
  %v1843 = fadd double %v1842, %v1840
  %v1844 = fmul double %v1823, %v1843
  %v1845 = getelementptr i8, ptr %v1828, i64 %v766
  %v1846 = load double, ptr %v1845, align 8, !noalias !198
  %v1847 = fadd double %v1846, %v1844
  %v1848 = fmul double %v1809, %v1847
  %v1849 = getelementptr i8, ptr %v1828, i64 %v767
  %v1850 = load double, ptr %v1849, align 8, !noalias !198
  %v1851 = fadd double %v1850, %v1848
  %v1852 = fmul double %v1823, %v1851
  %v1853 = getelementptr i8, ptr %v1828, i64 %v768
  %v1854 = load double, ptr %v1853, align 8, !noalias !198
  %v1855 = fadd double %v1854, %v1852
  %v1856 = fmul double %v1809, %v1855
  %v1826 = add nsw i64 %v1825, 1
  %v1857 = load double, ptr %v1828, align 8, !noalias !198
  %v1858 = fadd double %v1857, %v1856
  %v1859 = getelementptr double, ptr %v759, i64 %v1827
  store double %v1858, ptr %v1859, align 8, !noalias !191
  %v1860 = icmp eq i64 %v10, %v1826
  br i1 %v1860, label %v1822, label %v1824

v1822:
  %v1861 = load i64, ptr %v761, align 8, !noalias !202
  %v1862 = inttoptr i64 %v1861 to ptr
  tail call void %v1862(ptr nonnull %v756, ptr %v800, ptr %v166, ptr %v173, ptr %v180, ptr %v802), !noalias !202
  br i1 %v805, label %v1863, label %v1864

v1863:
  %v1865 = phi i64 [ %v1866, %v1863 ], [ %v804, %v1822 ]
  %v1867 = phi i64 [ %v1868, %v1863 ], [ %v19, %v1822 ]
  %v1866 = add nsw i64 %v1865, -1
  %v1868 = add i64 %v1867, 1
  %v1869 = icmp slt i64 %v1867, 0
  %v1870 = select i1 %v1869, i64 %v208, i64 0
  %v1871 = add i64 %v1870, %v1867
  %v1872 = getelementptr double, ptr %v809, i64 %v1871
  %v1873 = load double, ptr %v1872, align 8, !noalias !205
  %v1874 = getelementptr double, ptr %v812, i64 %v1871
  store double %v1873, ptr %v1874, align 8, !noalias !205
  %v1875 = icmp sgt i64 %v1865, 1
  br i1 %v1875, label %v1863, label %v1864

v1864:
  br i1 %v813, label %v1876, label %v1877

v1877:
  %v1878 = phi double [ %v1879, %v1877 ], [ 0x7FF0000000000000, %v1864 ]
  %v1880 = phi i64 [ %v1881, %v1877 ], [ 0, %v1864 ]
  %v1881 = add nsw i64 %v1880, 1
  %v1882 = getelementptr double, ptr %v814, i64 %v1880
  %v1883 = load double, ptr %v1882, align 8, !noalias !206
  %v1884 = getelementptr double, ptr %v812, i64 %v1880
  %v1885 = load double, ptr %v1884, align 8, !noalias !206
  %v1886 = fadd double %v1883, %v1885
  %v1887 = fcmp olt double %v1886, %v1878
  %v1879 = select i1 %v1887, double %v1886, double %v1878
  %v1888 = icmp eq i64 %v208, %v1881
  br i1 %v1888, label %v1876, label %v1877

v1876:
  %v1810 = phi double [ 0x7FF0000000000000, %v1864 ], [ %v1879, %v1877 ]
  %v1889 = fcmp olt double %v1810, 0.000000e+00
  br i1 %v1889, label %v1808, label %v1812

v1890:
  %v1891 = load double, ptr %v792, align 8, !noalias !210
  %v1892 = load double, ptr %v134, align 8, !noalias !214
  %v1893 = load double, ptr %v754, align 8, !noalias !214
  %v1894 = fmul double %v1891, %v1893
  %v1895 = fadd double %v1892, %v1894
  store double %v1895, ptr %v756, align 8, !noalias !214
  br i1 %v798, label %v1896, label %v1897

v1896:
  %v1898 = fsub double 1.000000e+00, %v1891
  br label %v1899

v1899:
  %v1900 = phi i64 [ 0, %v1896 ], [ %v1901, %v1899 ]
  %v1902 = mul i64 %v1900, %v197
  %v1903 = getelementptr double, ptr %v194, i64 %v1902
  %v1904 = getelementptr i8, ptr %v1903, i64 %v762
  %v1905 = load double, ptr %v1904, align 8, !noalias !221
  %v1906 = fadd double %v1905, 0.000000e+00
  %v1907 = fmul double %v1891, %v1906
  %v1908 = getelementptr i8, ptr %v1903, i64 %v763
  %v1909 = load double, ptr %v1908, align 8, !noalias !221
  %v1910 = fadd double %v1909, %v1907
  %v1911 = fmul double %v1898, %v1910
  %v1912 = getelementptr i8, ptr %v1903, i64 %v764
  %v1913 = load double, ptr %v1912, align 8, !noalias !221
  %v1914 = fadd double %v1913, %v1911
  %v1915 = fmul double %v1891, %v1914
  %v1916 = getelementptr i8, ptr %v1903, i64 %v765
  %v1917 = load double, ptr %v1916, align 8, !noalias !221
  %v1918 = fadd double %v1917, %v1915
  %v1919 = fmul double %v1898, %v1918
  %v1920 = getelementptr i8, ptr %v1903, i64 %v766
  %v1921 = load double, ptr %v1920, align 8, !noalias !221
  %v1922 = fadd double %v1921, %v1919
  %v1923 = fmul double %v1891, %v1922
  %v1924 = getelementptr i8, ptr %v1903, i64 %v767
  %v1925 = load double, ptr %v1924, align 8, !noalias !221
  %v1926 = fadd double %v1925, %v1923
  %v1927 = fmul double %v1898, %v1926
  %v1928 = getelementptr i8, ptr %v1903, i64 %v768
  %v1929 = load double, ptr %v1928, align 8, !noalias !221
  %v1930 = fadd double %v1929, %v1927
  %v1931 = fmul double %v1891, %v1930
  %v1901 = add nsw i64 %v1900, 1
  %v1932 = load double, ptr %v1903, align 8, !noalias !221
  %v1933 = fadd double %v1932, %v1931
  %v1934 = getelementptr double, ptr %v759, i64 %v1902
  store double %v1933, ptr %v1934, align 8, !noalias !214
  %v1935 = icmp eq i64 %v10, %v1901
  br i1 %v1935, label %v1897, label %v1899

v1897:
  %v1936 = load i64, ptr %v761, align 8, !noalias !225
  %v1937 = inttoptr i64 %v1936 to ptr
  tail call void %v1937(ptr nonnull %v756, ptr %v800, ptr %v166, ptr %v173, ptr %v180, ptr %v802), !noalias !225
  br i1 %v805, label %v1938, label %v1939

v1939:
  br label %v1940

v1938:
  %v1941 = phi i64 [ %v1942, %v1938 ], [ %v804, %v1897 ]
  %v1943 = phi i64 [ %v1944, %v1938 ], [ %v19, %v1897 ]
  %v1942 = add nsw i64 %v1941, -1
  %v1944 = add i64 %v1943, 1
  %v1945 = icmp slt i64 %v1943, 0
  %v1946 = select i1 %v1945, i64 %v208, i64 0
  %v1947 = add i64 %v1946, %v1943
  %v1948 = getelementptr double, ptr %v809, i64 %v1947
  %v1949 = load double, ptr %v1948, align 8, !noalias !228
  %v1950 = getelementptr double, ptr %v812, i64 %v1947
  store double %v1949, ptr %v1950, align 8, !noalias !228
  %v1951 = icmp sgt i64 %v1941, 1
  br i1 %v1951, label %v1938, label %v1939

v1952:
  %v1953 = icmp slt i64 %v1954, 0
  %v1955 = select i1 %v1953, i64 %v208, i64 0
  %v1956 = add i64 %v1955, %v1954
  %v1957 = getelementptr double, ptr %v814, i64 %v1956
  %v1958 = load double, ptr %v1957, align 8, !noalias !210
  store double %v1958, ptr %v797, align 8, !noalias !210
  br label %v1959

v1960:
  %v1961 = phi i64 [ 0, %v1962 ], [ %v1963, %v1960 ]
  %v1964 = mul i64 %v1961, %v197
  %v1965 = getelementptr double, ptr %v194, i64 %v1964
  %v1966 = getelementptr i8, ptr %v1965, i64 %v762
  %v1967 = load double, ptr %v1966, align 8, !noalias !229
  %v1968 = fadd double %v1967, 0.000000e+00
  %v1969 = fmul double %v1970, %v1968
  %v1971 = getelementptr i8, ptr %v1965, i64 %v763
  %v1972 = load double, ptr %v1971, align 8, !noalias !229
  %v1973 = fadd double %v1972, %v1969
  %v1974 = fmul double %v1975, %v1973
  %v1976 = getelementptr i8, ptr %v1965, i64 %v764
  %v1977 = load double, ptr %v1976, align 8, !noalias !229
  %v1978 = fadd double %v1977, %v1974
  %v1979 = fmul double %v1970, %v1978
  %v1980 = getelementptr i8, ptr %v1965, i64 %v765
  %v1981 = load double, ptr %v1980, align 8, !noalias !229
  %v1982 = fadd double %v1981, %v1979
  %v1983 = fmul double %v1975, %v1982
  %v1984 = getelementptr i8, ptr %v1965, i64 %v766
  %v1985 = load double, ptr %v1984, align 8, !noalias !229
  %v1986 = fadd double %v1985, %v1983
  %v1987 = fmul double %v1970, %v1986
  %v1988 = getelementptr i8, ptr %v1965, i64 %v767
  %v1989 = load double, ptr %v1988, align 8, !noalias !229
  %v1990 = fadd double %v1989, %v1987
  %v1991 = fmul double %v1975, %v1990
  %v1992 = getelementptr i8, ptr %v1965, i64 %v768
  %v1993 = load double, ptr %v1992, align 8, !noalias !229
  %v1994 = fadd double %v1993, %v1991
  %v1995 = fmul double %v1970, %v1994
  %v1963 = add nsw i64 %v1961, 1
  %v1996 = load double, ptr %v1965, align 8, !noalias !229
  %v1997 = fadd double %v1996, %v1995
  %v1998 = getelementptr double, ptr %v759, i64 %v1964
  store double %v1997, ptr %v1998, align 8, !noalias !239
  %v1999 = icmp eq i64 %v10, %v1963
  br i1 %v1999, label %v2000, label %v1960

v2000:
  %v2001 = load i64, ptr %v761, align 8, !noalias !240
  %v2002 = inttoptr i64 %v2001 to ptr
  tail call void %v2002(ptr nonnull %v756, ptr %v800, ptr %v166, ptr %v173, ptr %v180, ptr %v802), !noalias !240
  br i1 %v845, label %v2003, label %v2004

v2004:
  %v2005 = phi i64 [ %v2006, %v2004 ], [ %v804, %v2000 ]
  %v2007 = phi i64 [ %v2008, %v2004 ], [ %v19, %v2000 ]
  %v2006 = add nsw i64 %v2005, -1
  %v2008 = add i64 %v2007, 1
  %v2009 = icmp slt i64 %v2007, 0
  %v2010 = select i1 %v2009, i64 %v208, i64 0
  %v2011 = add i64 %v2010, %v2007
  %v2012 = getelementptr double, ptr %v809, i64 %v2011
  %v2013 = load double, ptr %v2012, align 8, !noalias !243
  %v2014 = getelementptr double, ptr %v812, i64 %v2011
  store double %v2013, ptr %v2014, align 8, !noalias !243
  %v2015 = icmp sgt i64 %v2005, 1
  br i1 %v2015, label %v2004, label %v2003

v2016:
  br i1 %v2017, label %v2018, label %v2019

v2018:
  %v2020 = load double, ptr %v792, align 8, !noalias !210
  br label %v2019

v2019:
  %v2021 = phi double [ %v2020, %v2018 ], [ %v1970, %v2016 ]
  %v2022 = fmul double %v2021, 5.000000e-01
  %v2023 = icmp eq i64 %v2024, 45
  br i1 %v2023, label %v2025, label %v1959

v2026:
  %v2027 = getelementptr double, ptr %v809, i64 %v1956
  store double 0.000000e+00, ptr %v2027, align 8, !noalias !210
  br label %v2028

v2029:
  %v2030 = sub nsw i64 45, %v2031
  %v2032 = load double, ptr %v795, align 8, !noalias !244
  %v2033 = load double, ptr %v797, align 8, !noalias !244
  br label %v2034

v2034:
  %v2035 = phi double [ %v2036, %v2034 ], [ 1.000000e+00, %v2029 ]
  %v2037 = phi double [ %v2038, %v2034 ], [ 2.000000e+00, %v2029 ]
  %v2039 = phi i64 [ %v2040, %v2034 ], [ %v2030, %v2029 ]
  %v2041 = and i64 %v2039, 1
  %v2042 = icmp eq i64 %v2041, 0
  %v2043 = fmul double %v2035, %v2037
  %v2036 = select i1 %v2042, double %v2035, double %v2043
  %v2040 = lshr i64 %v2039, 1
  %v2038 = fmul double %v2037, %v2037
  %v2044 = icmp eq i64 %v2040, 0
  br i1 %v2044, label %v2045, label %v2034

v2046:
  %v2047 = fcmp olt double %v2048, 0.000000e+00
  %v2049 = select i1 %v2047, double 0.000000e+00, double %v2048
  %v2050 = fmul double %v2051, %v2049
  %v2052 = fsub double %v2053, %v2050
  br label %v2054

v2045:
  %v2055 = fadd double %v2056, %v2057
  %v2053 = fmul double %v2055, 5.000000e-01
  %v2058 = fmul double %v2036, 0x3D06849B86A12B9B
  %v2059 = fsub double %v2058, %v2060
  %v2048 = fmul double %v2059, 5.000000e-01
  %v2061 = fmul double %v2057, %v2033
  %v2062 = fmul double %v2056, %v2032
  %v2063 = fsub double %v2061, %v2062
  %v2064 = fsub double %v2033, %v2032
  %v2065 = fdiv double %v2063, %v2064
  %v2066 = fcmp olt double %v2057, %v2065
  %v2067 = fcmp olt double %v2065, %v2056
  %v2068 = and i1 %v2066, %v2067
  %v2069 = select i1 %v2068, double %v2065, double %v2053
  %v2070 = fsub double %v2053, %v2069
  %v2051 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v2070)
  %v2071 = fmul double %v2060, %v2060
  %v2072 = tail call double @llvm.fabs.f64(double %v2070)
  %v2073 = fcmp olt double %v2072, %v2071
  %v2074 = select i1 %v2073, double %v2072, double %v2071
  %v2075 = fmul double %v2051, %v2074
  %v2076 = fadd double %v2069, %v2075
  %v2077 = fsub double %v2076, %v2053
  %v2078 = tail call double @llvm.fabs.f64(double %v2077)
  %v2079 = fcmp ugt double %v2078, %v2048
  br i1 %v2079, label %v2046, label %v2054

v2080:
  store double %v2081, ptr %v792, align 8, !noalias !250
  store double %v2082, ptr %v797, align 8, !noalias !250
  br label %v2083

v2084:
  store double %v2081, ptr %v784, align 8, !noalias !250
  store double %v2082, ptr %v795, align 8, !noalias !250
  br label %v2083

v2083:
  %v2085 = icmp eq i64 %v2086, 45
  br i1 %v2085, label %v2087, label %v2028

v2028:
  %v2031 = phi i64 [ 0, %v2026 ], [ %v2086, %v2083 ]
  %v2086 = add nsw i64 %v2031, 1
  %v2056 = load double, ptr %v792, align 8, !noalias !250
  %v2057 = load double, ptr %v784, align 8, !noalias !250
  %v2060 = fsub double %v2056, %v2057
  %v2088 = fcmp ugt double %v2060, 0x3D06849B86A12B9B
  br i1 %v2088, label %v2029, label %v2087

v2054:
  %v2081 = phi double [ %v2076, %v2045 ], [ %v2052, %v2046 ]
  %v2089 = load double, ptr %v134, align 8, !noalias !251
  %v2090 = load double, ptr %v754, align 8, !noalias !251
  %v2091 = fmul double %v2081, %v2090
  %v2092 = fadd double %v2089, %v2091
  store double %v2092, ptr %v756, align 8, !noalias !251
  br i1 %v798, label %v2093, label %v2094

v2093:
  %v2095 = fsub double 1.000000e+00, %v2081
  br label %v2096

v2096:
  %v2097 = phi i64 [ 0, %v2093 ], [ %v2098, %v2096 ]
  %v2099 = mul i64 %v2097, %v197
  %v2100 = getelementptr double, ptr %v194, i64 %v2099
  %v2101 = getelementptr i8, ptr %v2100, i64 %v762
  %v2102 = load double, ptr %v2101, align 8, !noalias !258
  %v2103 = fadd double %v2102, 0.000000e+00
  %v2104 = fmul double %v2081, %v2103
  %v2105 = getelementptr i8, ptr %v2100, i64 %v763
  %v2106 = load double, ptr %v2105, align 8, !noalias !258
  %v2107 = fadd double %v2106, %v2104
  %v2108 = fmul double %v2095, %v2107
  %v2109 = getelementptr i8, ptr %v2100, i64 %v764
  %v2110 = load double, ptr %v2109, align 8, !noalias !258
  %v2111 = fadd double %v2110, %v2108
  %v2112 = fmul double %v2081, %v2111
  %v2113 = getelementptr i8, ptr %v2100, i64 %v765
  %v2114 = load double, ptr %v2113, align 8, !noalias !258
  %v2115 = fadd double %v2114, %v2112
  %v2116 = fmul double %v2095, %v2115
  %v2117 = getelementptr i8, ptr %v2100, i64 %v766
  %v2118 = load double, ptr %v2117, align 8, !noalias !258
  %v2119 = fadd double %v2118, %v2116
  %v2120 = fmul double %v2081, %v2119
  %v2121 = getelementptr i8, ptr %v2100, i64 %v767
  %v2122 = load double, ptr %v2121, align 8, !noalias !258
  %v2123 = fadd double %v2122, %v2120
  %v2124 = fmul double %v2095, %v2123
  %v2125 = getelementptr i8, ptr %v2100, i64 %v768
  %v2126 = load double, ptr %v2125, align 8, !noalias !258
  %v2127 = fadd double %v2126, %v2124
  %v2128 = fmul double %v2081, %v2127
  %v2098 = add nsw i64 %v2097, 1
  %v2129 = load double, ptr %v2100, align 8, !noalias !258
  %v2130 = fadd double %v2129, %v2128
  %v2131 = getelementptr double, ptr %v759, i64 %v2099
  store double %v2130, ptr %v2131, align 8, !noalias !251
  %v2132 = icmp eq i64 %v10, %v2098
  br i1 %v2132, label %v2094, label %v2096

v2094:
  %v2133 = load i64, ptr %v761, align 8, !noalias !262
  %v2134 = inttoptr i64 %v2133 to ptr
  tail call void %v2134(ptr nonnull %v756, ptr %v800, ptr %v166, ptr %v173, ptr %v180, ptr %v802), !noalias !262
  br i1 %v805, label %v2135, label %v2136

v2135:
  %v2137 = phi i64 [ %v2138, %v2135 ], [ %v804, %v2094 ]
  %v2139 = phi i64 [ %v2140, %v2135 ], [ %v19, %v2094 ]
  %v2138 = add nsw i64 %v2137, -1
  %v2140 = add i64 %v2139, 1
  %v2141 = icmp slt i64 %v2139, 0
  %v2142 = select i1 %v2141, i64 %v208, i64 0
  %v2143 = add i64 %v2142, %v2139
  %v2144 = getelementptr double, ptr %v809, i64 %v2143
  %v2145 = load double, ptr %v2144, align 8, !noalias !265
  %v2146 = getelementptr double, ptr %v812, i64 %v2143
  store double %v2145, ptr %v2146, align 8, !noalias !265
  %v2147 = icmp sgt i64 %v2137, 1
  br i1 %v2147, label %v2135, label %v2136

v2136:
  br i1 %v813, label %v2148, label %v2149

v2149:
  %v2150 = phi double [ %v2151, %v2149 ], [ 0x7FF0000000000000, %v2136 ]
  %v2152 = phi i64 [ %v2153, %v2149 ], [ 0, %v2136 ]
  %v2153 = add nsw i64 %v2152, 1
  %v2154 = getelementptr double, ptr %v814, i64 %v2152
  %v2155 = load double, ptr %v2154, align 8, !noalias !266
  %v2156 = getelementptr double, ptr %v812, i64 %v2152
  %v2157 = load double, ptr %v2156, align 8, !noalias !266
  %v2158 = fadd double %v2155, %v2157
  %v2159 = fcmp olt double %v2158, %v2150
  %v2151 = select i1 %v2159, double %v2158, double %v2150
  %v2160 = icmp eq i64 %v208, %v2153
  br i1 %v2160, label %v2148, label %v2149

v2148:
  %v2082 = phi double [ 0x7FF0000000000000, %v2136 ], [ %v2151, %v2149 ]
  %v2161 = fcmp olt double %v2082, 0.000000e+00
  br i1 %v2161, label %v2080, label %v2084

v2025:
  store double 0.000000e+00, ptr %v792, align 8, !noalias !210
  br label %v2087

v2087:
  %v2162 = load double, ptr %v134, align 8, !noalias !210
  %v2163 = load double, ptr %v792, align 8, !noalias !210
  %v2164 = load double, ptr %v754, align 8, !noalias !210
  %v2165 = fmul double %v2163, %v2164
  %v2166 = fadd double %v2162, %v2165
  %v2167 = load i64, ptr %v143, align 8, !noalias !270
  %v2168 = load i64, ptr %v847, align 8, !noalias !270
  %v2169 = icmp slt i64 %v2168, %v94
  br i1 %v2169, label %v2170, label %v2171

v2170:
  %v2172 = icmp slt i64 %v2168, 0
  %v2173 = select i1 %v2172, i64 %v94, i64 0
  %v2174 = getelementptr double, ptr %v93, i64 %v2168
  %v2175 = getelementptr double, ptr %v2174, i64 %v2173
  %v2176 = load double, ptr %v2175, align 8, !noalias !270
  %v2177 = fcmp ugt double %v2176, %v2166
  br i1 %v2177, label %v2171, label %v2178

v2178:
  %v2179 = icmp slt i64 %v2167, 0
  %v2180 = select i1 %v2179, i64 %v101, i64 0
  %v2181 = add i64 %v2180, %v2167
  %v2182 = mul i64 %v850, %v2181
  %v2183 = getelementptr double, ptr %v100, i64 %v2182
  br label %v2184

v2184:
  %v2185 = phi i64 [ %v2186, %v2187 ], [ %v2168, %v2178 ]
  %v2188 = icmp slt i64 %v2185, 0
  %v2189 = select i1 %v2188, i64 %v94, i64 0
  %v2190 = getelementptr double, ptr %v93, i64 %v2185
  %v2191 = getelementptr double, ptr %v2190, i64 %v2189
  %v2192 = load double, ptr %v2191, align 8, !noalias !270
  %v2193 = load double, ptr %v134, align 8, !noalias !270
  %v2194 = fsub double %v2192, %v2193
  %v2195 = load double, ptr %v754, align 8, !noalias !270
  %v2196 = fdiv double %v2194, %v2195
  br i1 %v758, label %v2197, label %v2198

v2198:
  %v2199 = fsub double 1.000000e+00, %v2196
  %v2200 = select i1 %v2188, i64 %v102, i64 0
  %v2201 = add i64 %v2200, %v2185
  %v2202 = mul i64 %v2201, %v103
  %v2203 = getelementptr double, ptr %v2183, i64 %v2202
  br label %v2204

v2205:
  %v2206 = getelementptr double, ptr %v852, i64 %v2207
  %v2208 = load double, ptr %v2206, align 8, !noalias !270
  br label %v2209

v2197:
  store double 0x7FF0000000000000, ptr %v849, align 8, !noalias !270
  %v2210 = icmp eq i64 %v2185, %v853
  br i1 %v2210, label %v2171, label %v2187

v2187:
  %v2186 = add i64 %v2185, 1
  %v2211 = icmp slt i64 %v2185, -1
  %v2212 = select i1 %v2211, i64 %v94, i64 0
  %v2213 = getelementptr double, ptr %v93, i64 %v2186
  %v2214 = getelementptr double, ptr %v2213, i64 %v2212
  %v2215 = load double, ptr %v2214, align 8, !noalias !270
  %v2216 = fcmp ugt double %v2215, %v2166
  br i1 %v2216, label %v2171, label %v2184

v2171:
  %v2217 = phi i64 [ %v2168, %v2170 ], [ %v2168, %v2087 ], [ %v94, %v2197 ], [ %v2186, %v2187 ]
  store i64 %v2217, ptr %v847, align 8, !noalias !270
  store i64 %v1954, ptr %v855, align 8, !noalias !210
  %v2218 = load i64, ptr %v143, align 8, !noalias !274
  %v2219 = icmp sgt i64 %v2218, -1
  br i1 %v2219, label %v2220, label %v2221

v2209:
  %v2222 = phi double [ %v2223, %v2224 ], [ %v2208, %v2205 ]
  %v2225 = getelementptr double, ptr %v2203, i64 %v2226
  store double %v2222, ptr %v2225, align 8, !noalias !270
  %v2227 = icmp eq i64 %v10, %v2228
  br i1 %v2227, label %v2197, label %v2204

v2204:
  %v2226 = phi i64 [ 0, %v2198 ], [ %v2228, %v2209 ]
  %v2228 = add nsw i64 %v2226, 1
  %v2229 = load double, ptr %v2191, align 8, !noalias !270
  %v2230 = load double, ptr %v788, align 8, !noalias !270
  %v2231 = fcmp oeq double %v2229, %v2230
  %v2207 = mul i64 %v2226, %v197
  br i1 %v2231, label %v2205, label %v2224

v2224:
  %v2232 = getelementptr double, ptr %v194, i64 %v2207
  %v2233 = getelementptr i8, ptr %v2232, i64 %v762
  %v2234 = load double, ptr %v2233, align 8, !noalias !277
  %v2235 = fadd double %v2234, 0.000000e+00
  %v2236 = fmul double %v2196, %v2235
  %v2237 = getelementptr i8, ptr %v2232, i64 %v763
  %v2238 = load double, ptr %v2237, align 8, !noalias !277
  %v2239 = fadd double %v2238, %v2236
  %v2240 = fmul double %v2199, %v2239
  %v2241 = getelementptr i8, ptr %v2232, i64 %v764
  %v2242 = load double, ptr %v2241, align 8, !noalias !277
  %v2243 = fadd double %v2242, %v2240
  %v2244 = fmul double %v2196, %v2243
  %v2245 = getelementptr i8, ptr %v2232, i64 %v765
  %v2246 = load double, ptr %v2245, align 8, !noalias !277
  %v2247 = fadd double %v2246, %v2244
  %v2248 = fmul double %v2199, %v2247
  %v2249 = getelementptr i8, ptr %v2232, i64 %v766
  %v2250 = load double, ptr %v2249, align 8, !noalias !277
  %v2251 = fadd double %v2250, %v2248
  %v2252 = fmul double %v2196, %v2251
  %v2253 = getelementptr i8, ptr %v2232, i64 %v767
  %v2254 = load double, ptr %v2253, align 8, !noalias !277
  %v2255 = fadd double %v2254, %v2252
  %v2256 = fmul double %v2199, %v2255
  %v2257 = getelementptr i8, ptr %v2232, i64 %v768
  %v2258 = load double, ptr %v2257, align 8, !noalias !277
  %v2259 = fadd double %v2258, %v2256
  %v2260 = fmul double %v2196, %v2259
  %v2261 = load double, ptr %v2232, align 8, !noalias !277
  %v2223 = fadd double %v2261, %v2260
  br label %v2209

v1940:
  %v2262 = phi i64 [ %v2263, %v2264 ], [ 0, %v1939 ]
  %v2265 = phi i64 [ %v2266, %v2264 ], [ %v844, %v1939 ]
  %v2267 = icmp sgt i64 %v2265, 0
  br i1 %v2267, label %v2264, label %v2268

v2264:
  %v2266 = add nsw i64 %v2265, -1
  %v2263 = add i64 %v2262, 1
  %v2269 = getelementptr double, ptr %v814, i64 %v2262
  %v2270 = load double, ptr %v2269, align 8, !noalias !281
  %v2271 = getelementptr double, ptr %v812, i64 %v2262
  %v2272 = load double, ptr %v2271, align 8, !noalias !281
  %v2273 = fneg double %v2272
  %v2274 = fcmp olt double %v2270, %v2273
  br i1 %v2274, label %v2268, label %v1940

v2268:
  %v1954 = phi i64 [ %v2262, %v2264 ], [ -1, %v1940 ]
  %v2275 = icmp slt i64 %v1954, %v19
  br i1 %v2275, label %v2276, label %v1952

v1959:
  %v1970 = phi double [ %v1746, %v1952 ], [ %v2022, %v2019 ]
  %v2277 = phi i64 [ 0, %v1952 ], [ %v2024, %v2019 ]
  %v2024 = add nsw i64 %v2277, 1
  %v2017 = icmp eq i64 %v2277, 0
  %v2278 = load double, ptr %v134, align 8, !noalias !239
  %v2279 = load double, ptr %v754, align 8, !noalias !239
  %v2280 = fmul double %v1970, %v2279
  %v2281 = fadd double %v2278, %v2280
  store double %v2281, ptr %v756, align 8, !noalias !239
  br i1 %v758, label %v2000, label %v1962

v1962:
  %v1975 = fsub double 1.000000e+00, %v1970
  br label %v1960

v2003:
  store double %v1970, ptr %v784, align 8, !noalias !210
  %v2282 = load double, ptr %v1957, align 8, !noalias !210
  store double %v2282, ptr %v795, align 8, !noalias !210
  %v2283 = fcmp ogt double %v2282, 0.000000e+00
  br i1 %v2283, label %v2026, label %v2016

v2220:
  %v2284 = getelementptr i64, ptr %v111, i64 %v2218
  %v2285 = load i64, ptr %v2284, align 8, !noalias !274
  %v2286 = icmp eq i64 %v2285, 0
  br i1 %v2286, label %v2287, label %v2221

v2287:
  store i64 4, ptr %v2284, align 8, !noalias !274
  br label %v2221

v2221:
  store double 0.000000e+00, ptr %v857, align 8, !noalias !210
  br label %v2288

v2289:
  br i1 %v1755, label %v2276, label %v2290

v2290:
  call void @llvm.lifetime.start.p0(ptr nonnull %v301), !noalias !180
  call void @llvm.lifetime.start.p0(ptr nonnull %v302), !noalias !180
  store i8 0, ptr %v301, align 1, !noalias !285
  store ptr null, ptr %v302, align 8, !noalias !285
  %v2291 = load double, ptr %v784, align 8, !noalias !285
  %v2292 = load double, ptr %v792, align 8, !noalias !285
  br i1 %v306, label %v2293, label %v2294

v2295:
  %v2296 = phi i64 [ %v2297, %v2298 ], [ 0, %v2299 ]
  %v2297 = add nsw i64 %v2296, 1
  %v2300 = icmp ult i64 %v2296, 9
  br i1 %v2300, label %v2301, label %v2302

v2301:
  %v2303 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v2296
  %v2304 = load double, ptr %v2303, align 8
  %v2305 = load double, ptr %v134, align 8, !noalias !289
  %v2306 = load double, ptr %v754, align 8, !noalias !289
  %v2307 = fmul double %v2304, %v2306
  %v2308 = fadd double %v2305, %v2307
  store double %v2308, ptr %v756, align 8, !noalias !289
  br i1 %v798, label %v2309, label %v2298

v2309:
  %v2310 = fsub double 1.000000e+00, %v2304
  br label %v2311

v2311:
  %v2312 = phi i64 [ 0, %v2309 ], [ %v2313, %v2311 ]
  %v2314 = mul i64 %v2312, %v197
  %v2315 = getelementptr double, ptr %v194, i64 %v2314
  %v2316 = getelementptr i8, ptr %v2315, i64 %v762
  %v2317 = load double, ptr %v2316, align 8, !noalias !296
  %v2318 = fadd double %v2317, 0.000000e+00
  %v2319 = fmul double %v2304, %v2318
  %v2320 = getelementptr i8, ptr %v2315, i64 %v763
  %v2321 = load double, ptr %v2320, align 8, !noalias !296
  %v2322 = fadd double %v2321, %v2319
  %v2323 = fmul double %v2310, %v2322
  %v2324 = getelementptr i8, ptr %v2315, i64 %v764
  %v2325 = load double, ptr %v2324, align 8, !noalias !296
  %v2326 = fadd double %v2325, %v2323
  %v2327 = fmul double %v2304, %v2326
  %v2328 = getelementptr i8, ptr %v2315, i64 %v765
  %v2329 = load double, ptr %v2328, align 8, !noalias !296
  %v2330 = fadd double %v2329, %v2327
  %v2331 = fmul double %v2310, %v2330
  %v2332 = getelementptr i8, ptr %v2315, i64 %v766
  %v2333 = load double, ptr %v2332, align 8, !noalias !296
  %v2334 = fadd double %v2333, %v2331
  %v2335 = fmul double %v2304, %v2334
  %v2336 = getelementptr i8, ptr %v2315, i64 %v767
  %v2337 = load double, ptr %v2336, align 8, !noalias !296
  %v2338 = fadd double %v2337, %v2335
  %v2339 = fmul double %v2310, %v2338
  %v2340 = getelementptr i8, ptr %v2315, i64 %v768
  %v2341 = load double, ptr %v2340, align 8, !noalias !296
  %v2342 = fadd double %v2341, %v2339
  %v2343 = fmul double %v2304, %v2342
  %v2313 = add nsw i64 %v2312, 1
  %v2344 = load double, ptr %v2315, align 8, !noalias !296
  %v2345 = fadd double %v2344, %v2343
  %v2346 = getelementptr double, ptr %v759, i64 %v2314
  store double %v2345, ptr %v2346, align 8, !noalias !289
  %v2347 = icmp eq i64 %v10, %v2313
  br i1 %v2347, label %v2298, label %v2311

v2298:
  %v2348 = icmp eq i64 %v2296, 8
  %v2349 = select i1 %v2348, i64 17, i64 16
  %v2350 = mul i64 %v2296, %v760
  %v2351 = load i64, ptr %v761, align 8, !noalias !300
  %v2352 = mul nsw i64 %v2349, %v10
  %v2353 = getelementptr double, ptr %v159, i64 %v2352
  %v2354 = getelementptr double, ptr %v187, i64 %v2350
  %v2355 = inttoptr i64 %v2351 to ptr
  tail call void %v2355(ptr nonnull %v756, ptr %v2353, ptr %v166, ptr %v173, ptr %v180, ptr %v2354), !noalias !300
  %v2356 = icmp eq i64 %v2297, 9
  br i1 %v2356, label %v2302, label %v2295

v2302:
  %v2357 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v2295 ], [ %v2358, %v2298 ]
  %v2359 = phi i32 [ 1, %v2295 ], [ 0, %v2298 ]
  br i1 %v2300, label %v2360, label %v2361, !prof !131

v2362:
  %v2363 = load double, ptr %v834, align 8, !noalias !285
  %v2364 = fcmp ogt double %v2363, 5.000000e-01
  br i1 %v2364, label %v2365, label %v2366

v2365:
  %v2367 = load i64, ptr %v6, align 8, !noalias !303
  %v2368 = inttoptr i64 %v2367 to ptr
  tail call void %v2368(ptr nonnull %v788, ptr %v839, ptr %v166, ptr %v173, ptr %v180, ptr %v841), !noalias !303
  %v2369 = load double, ptr %v788, align 8, !noalias !285
  store double %v2369, ptr %v790, align 8, !noalias !285
  br label %v2370

v2371:
  %v2372 = sub nsw i64 45, %v2373
  %v2374 = load double, ptr %v795, align 8, !noalias !306
  %v2375 = load double, ptr %v797, align 8, !noalias !306
  br label %v2376

v2376:
  %v2377 = phi double [ %v2378, %v2376 ], [ 1.000000e+00, %v2371 ]
  %v2379 = phi double [ %v2380, %v2376 ], [ 2.000000e+00, %v2371 ]
  %v2381 = phi i64 [ %v2382, %v2376 ], [ %v2372, %v2371 ]
  %v2383 = and i64 %v2381, 1
  %v2384 = icmp eq i64 %v2383, 0
  %v2385 = fmul double %v2377, %v2379
  %v2378 = select i1 %v2384, double %v2377, double %v2385
  %v2382 = lshr i64 %v2381, 1
  %v2380 = fmul double %v2379, %v2379
  %v2386 = icmp eq i64 %v2382, 0
  br i1 %v2386, label %v2387, label %v2376

v2388:
  %v2389 = fcmp olt double %v2390, 0.000000e+00
  %v2391 = select i1 %v2389, double 0.000000e+00, double %v2390
  %v2392 = fmul double %v2393, %v2391
  %v2394 = fsub double %v2395, %v2392
  br label %v2396

v2387:
  %v2397 = fadd double %v2398, %v2399
  %v2395 = fmul double %v2397, 5.000000e-01
  %v2400 = fmul double %v2378, 1.000000e-13
  %v2401 = fsub double %v2400, %v2402
  %v2390 = fmul double %v2401, 5.000000e-01
  %v2403 = fmul double %v2399, %v2375
  %v2404 = fmul double %v2398, %v2374
  %v2405 = fsub double %v2403, %v2404
  %v2406 = fsub double %v2375, %v2374
  %v2407 = fdiv double %v2405, %v2406
  %v2408 = fcmp olt double %v2399, %v2407
  %v2409 = fcmp olt double %v2407, %v2398
  %v2410 = and i1 %v2408, %v2409
  %v2411 = select i1 %v2410, double %v2407, double %v2395
  %v2412 = fsub double %v2395, %v2411
  %v2393 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v2412)
  %v2413 = fmul double %v2402, %v2402
  %v2414 = tail call double @llvm.fabs.f64(double %v2412)
  %v2415 = fcmp olt double %v2414, %v2413
  %v2416 = select i1 %v2415, double %v2414, double %v2413
  %v2417 = fmul double %v2393, %v2416
  %v2418 = fadd double %v2411, %v2417
  %v2419 = fsub double %v2418, %v2395
  %v2420 = tail call double @llvm.fabs.f64(double %v2419)
  %v2421 = fcmp ugt double %v2420, %v2390
  br i1 %v2421, label %v2388, label %v2396

v2422:
  store double %v2423, ptr %v792, align 8, !noalias !312
  store double %v2424, ptr %v797, align 8, !noalias !312
  br label %v2425

v2426:
  store double %v2423, ptr %v784, align 8, !noalias !312
  store double %v2424, ptr %v795, align 8, !noalias !312
  br label %v2425

v2425:
  %v2427 = icmp eq i64 %v2428, 45
  br i1 %v2427, label %v2429, label %v2430

v2430:
  %v2373 = phi i64 [ %v2428, %v2425 ], [ 0, %v2431 ]
  %v2428 = add nsw i64 %v2373, 1
  %v2398 = load double, ptr %v792, align 8, !noalias !312
  %v2399 = load double, ptr %v784, align 8, !noalias !312
  %v2402 = fsub double %v2398, %v2399
  %v2432 = fcmp ugt double %v2402, 1.000000e-13
  br i1 %v2432, label %v2371, label %v2429

v2396:
  %v2423 = phi double [ %v2418, %v2387 ], [ %v2394, %v2388 ]
  %v2433 = load double, ptr %v134, align 8, !noalias !313
  %v2434 = load double, ptr %v754, align 8, !noalias !313
  %v2435 = fmul double %v2423, %v2434
  %v2436 = fadd double %v2433, %v2435
  store double %v2436, ptr %v756, align 8, !noalias !313
  br i1 %v798, label %v2437, label %v2438

v2437:
  %v2439 = fsub double 1.000000e+00, %v2423
  br label %v2440

v2440:
  %v2441 = phi i64 [ 0, %v2437 ], [ %v2442, %v2440 ]
  %v2443 = mul i64 %v2441, %v197
  %v2444 = getelementptr double, ptr %v194, i64 %v2443
  %v2445 = getelementptr i8, ptr %v2444, i64 %v762
  %v2446 = load double, ptr %v2445, align 8, !noalias !320
  %v2447 = fadd double %v2446, 0.000000e+00
  %v2448 = fmul double %v2423, %v2447
  %v2449 = getelementptr i8, ptr %v2444, i64 %v763
  %v2450 = load double, ptr %v2449, align 8, !noalias !320
  %v2451 = fadd double %v2450, %v2448
  %v2452 = fmul double %v2439, %v2451
  %v2453 = getelementptr i8, ptr %v2444, i64 %v764
  %v2454 = load double, ptr %v2453, align 8, !noalias !320
  %v2455 = fadd double %v2454, %v2452
  %v2456 = fmul double %v2423, %v2455
  %v2457 = getelementptr i8, ptr %v2444, i64 %v765
  %v2458 = load double, ptr %v2457, align 8, !noalias !320
  %v2459 = fadd double %v2458, %v2456
  %v2460 = fmul double %v2439, %v2459
  %v2461 = getelementptr i8, ptr %v2444, i64 %v766
  %v2462 = load double, ptr %v2461, align 8, !noalias !320
  %v2463 = fadd double %v2462, %v2460
  %v2464 = fmul double %v2423, %v2463
  %v2465 = getelementptr i8, ptr %v2444, i64 %v767
  %v2466 = load double, ptr %v2465, align 8, !noalias !320
  %v2467 = fadd double %v2466, %v2464
  %v2468 = fmul double %v2439, %v2467
  %v2469 = getelementptr i8, ptr %v2444, i64 %v768
  %v2470 = load double, ptr %v2469, align 8, !noalias !320
  %v2471 = fadd double %v2470, %v2468
  %v2472 = fmul double %v2423, %v2471
  %v2442 = add nsw i64 %v2441, 1
  %v2473 = load double, ptr %v2444, align 8, !noalias !320
  %v2474 = fadd double %v2473, %v2472
  %v2475 = getelementptr double, ptr %v759, i64 %v2443
  store double %v2474, ptr %v2475, align 8, !noalias !313
  %v2476 = icmp eq i64 %v10, %v2442
  br i1 %v2476, label %v2438, label %v2440

v2438:
  %v2477 = load i64, ptr %v761, align 8, !noalias !324
  %v2478 = inttoptr i64 %v2477 to ptr
  tail call void %v2478(ptr nonnull %v756, ptr %v800, ptr %v166, ptr %v173, ptr %v180, ptr %v802), !noalias !324
  br i1 %v805, label %v2479, label %v2480

v2479:
  %v2481 = phi i64 [ %v2482, %v2479 ], [ %v804, %v2438 ]
  %v2483 = phi i64 [ %v2484, %v2479 ], [ %v19, %v2438 ]
  %v2482 = add nsw i64 %v2481, -1
  %v2484 = add i64 %v2483, 1
  %v2485 = icmp slt i64 %v2483, 0
  %v2486 = select i1 %v2485, i64 %v208, i64 0
  %v2487 = add i64 %v2486, %v2483
  %v2488 = getelementptr double, ptr %v809, i64 %v2487
  %v2489 = load double, ptr %v2488, align 8, !noalias !327
  %v2490 = getelementptr double, ptr %v812, i64 %v2487
  store double %v2489, ptr %v2490, align 8, !noalias !327
  %v2491 = icmp sgt i64 %v2481, 1
  br i1 %v2491, label %v2479, label %v2480

v2480:
  br i1 %v813, label %v2492, label %v2493

v2493:
  %v2494 = phi double [ %v2495, %v2493 ], [ 0x7FF0000000000000, %v2480 ]
  %v2496 = phi i64 [ %v2497, %v2493 ], [ 0, %v2480 ]
  %v2497 = add nsw i64 %v2496, 1
  %v2498 = getelementptr double, ptr %v814, i64 %v2496
  %v2499 = load double, ptr %v2498, align 8, !noalias !328
  %v2500 = getelementptr double, ptr %v812, i64 %v2496
  %v2501 = load double, ptr %v2500, align 8, !noalias !328
  %v2502 = fadd double %v2499, %v2501
  %v2503 = fcmp olt double %v2502, %v2494
  %v2495 = select i1 %v2503, double %v2502, double %v2494
  %v2504 = icmp eq i64 %v208, %v2497
  br i1 %v2504, label %v2492, label %v2493

v2492:
  %v2424 = phi double [ 0x7FF0000000000000, %v2480 ], [ %v2495, %v2493 ]
  %v2505 = fcmp olt double %v2424, 0.000000e+00
  br i1 %v2505, label %v2422, label %v2426

v2429:
  %v2506 = icmp ugt i64 %v2507, 1
  br i1 %v2506, label %v2508, label %v2366

v2366:
  br i1 %v835, label %v2509, label %v2510

v2509:
  %v2511 = load i64, ptr %v825, align 8, !noalias !332
  %v2512 = inttoptr i64 %v2511 to ptr
  tail call void %v2512(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !332
  store double %v2291, ptr %v784, align 8, !noalias !285
  store double %v2292, ptr %v792, align 8, !noalias !285
  br label %v2370

v2510:
  %v2513 = phi i64 [ %v2514, %v2510 ], [ 0, %v2366 ]
  %v2514 = add nsw i64 %v2513, 1
  %v2515 = add nsw i64 %v2513, %v18
  %v2516 = icmp slt i64 %v2515, 0
  %v2517 = select i1 %v2516, i64 %v167, i64 0
  %v2518 = getelementptr double, ptr %v166, i64 %v2515
  %v2519 = getelementptr double, ptr %v2518, i64 %v2517
  %v2520 = load double, ptr %v2519, align 8, !noalias !338
  %v2521 = getelementptr double, ptr %v837, i64 %v2513
  %v2522 = load double, ptr %v2521, align 8, !noalias !338
  store double %v2522, ptr %v2519, align 8, !noalias !338
  store double %v2520, ptr %v2521, align 8, !noalias !338
  %v2523 = icmp eq i64 %v19, %v2514
  br i1 %v2523, label %v2509, label %v2510

v2293:
  %v2524 = phi i64 [ %v2525, %v2293 ], [ 0, %v2290 ]
  %v2525 = add nsw i64 %v2524, 1
  %v2526 = add nsw i64 %v2524, %v18
  %v2527 = icmp slt i64 %v2526, 0
  %v2528 = select i1 %v2527, i64 %v167, i64 0
  %v2529 = getelementptr double, ptr %v166, i64 %v2526
  %v2530 = getelementptr double, ptr %v2529, i64 %v2528
  %v2531 = load double, ptr %v2530, align 8, !noalias !285
  %v2532 = getelementptr double, ptr %v816, i64 %v2524
  store double %v2531, ptr %v2532, align 8, !noalias !285
  %v2533 = icmp eq i64 %v19, %v2525
  br i1 %v2533, label %v2294, label %v2293

v2294:
  br label %v2508

v2508:
  %v2358 = phi ptr [ %v2357, %v2429 ], [ null, %v2294 ]
  %v2534 = phi ptr [ %v2535, %v2429 ], [ null, %v2294 ]
  %v2507 = phi i64 [ %v2536, %v2429 ], [ 32, %v2294 ]
  %v2536 = add nsw i64 %v2507, -1
  %v2537 = load double, ptr %v792, align 8, !noalias !339
  %v2538 = load double, ptr %v134, align 8, !noalias !343
  %v2539 = load double, ptr %v754, align 8, !noalias !343
  %v2540 = fmul double %v2537, %v2539
  %v2541 = fadd double %v2538, %v2540
  store double %v2541, ptr %v756, align 8, !noalias !343
  br i1 %v798, label %v2542, label %v2543

v2542:
  %v2544 = fsub double 1.000000e+00, %v2537
  br label %v2545

v2545:
  %v2546 = phi i64 [ 0, %v2542 ], [ %v2547, %v2545 ]
  %v2548 = mul i64 %v2546, %v197
  %v2549 = getelementptr double, ptr %v194, i64 %v2548
  %v2550 = getelementptr i8, ptr %v2549, i64 %v762
  %v2551 = load double, ptr %v2550, align 8, !noalias !350
  %v2552 = fadd double %v2551, 0.000000e+00
  %v2553 = fmul double %v2537, %v2552
  %v2554 = getelementptr i8, ptr %v2549, i64 %v763
  %v2555 = load double, ptr %v2554, align 8, !noalias !350
  %v2556 = fadd double %v2555, %v2553
  %v2557 = fmul double %v2544, %v2556
  %v2558 = getelementptr i8, ptr %v2549, i64 %v764
  %v2559 = load double, ptr %v2558, align 8, !noalias !350
  %v2560 = fadd double %v2559, %v2557
  %v2561 = fmul double %v2537, %v2560
  %v2562 = getelementptr i8, ptr %v2549, i64 %v765
  %v2563 = load double, ptr %v2562, align 8, !noalias !350
  %v2564 = fadd double %v2563, %v2561
  %v2565 = fmul double %v2544, %v2564
  %v2566 = getelementptr i8, ptr %v2549, i64 %v766
  %v2567 = load double, ptr %v2566, align 8, !noalias !350
  %v2568 = fadd double %v2567, %v2565
  %v2569 = fmul double %v2537, %v2568
  %v2570 = getelementptr i8, ptr %v2549, i64 %v767
  %v2571 = load double, ptr %v2570, align 8, !noalias !350
  %v2572 = fadd double %v2571, %v2569
  %v2573 = fmul double %v2544, %v2572
  %v2574 = getelementptr i8, ptr %v2549, i64 %v768
  %v2575 = load double, ptr %v2574, align 8, !noalias !350
  %v2576 = fadd double %v2575, %v2573
  %v2577 = fmul double %v2537, %v2576
  %v2547 = add nsw i64 %v2546, 1
  %v2578 = load double, ptr %v2549, align 8, !noalias !350
  %v2579 = fadd double %v2578, %v2577
  %v2580 = getelementptr double, ptr %v819, i64 %v2548
  store double %v2579, ptr %v2580, align 8, !noalias !343
  %v2581 = icmp eq i64 %v10, %v2547
  br i1 %v2581, label %v2543, label %v2545

v2543:
  %v2582 = load i64, ptr %v761, align 8, !noalias !354
  %v2583 = inttoptr i64 %v2582 to ptr
  tail call void %v2583(ptr nonnull %v756, ptr %v800, ptr %v166, ptr %v173, ptr %v180, ptr %v802), !noalias !354
  br i1 %v805, label %v2584, label %v2585

v2584:
  %v2586 = phi i64 [ %v2587, %v2584 ], [ %v803, %v2543 ]
  %v2588 = phi i64 [ %v2589, %v2584 ], [ %v19, %v2543 ]
  %v2587 = add nsw i64 %v2586, -1
  %v2589 = add i64 %v2588, 1
  %v2590 = icmp slt i64 %v2588, 0
  %v2591 = select i1 %v2590, i64 %v208, i64 0
  %v2592 = add i64 %v2591, %v2588
  %v2593 = getelementptr double, ptr %v809, i64 %v2592
  %v2594 = load double, ptr %v2593, align 8, !noalias !357
  %v2595 = getelementptr double, ptr %v812, i64 %v2592
  store double %v2594, ptr %v2595, align 8, !noalias !357
  %v2596 = icmp sgt i64 %v2586, 1
  br i1 %v2596, label %v2584, label %v2585

v2585:
  br label %v2597

v2598:
  br label %v2599

v2599:
  %v2600 = phi double [ %v2537, %v2597 ], [ 1.000000e+00, %v2601 ], [ 8.889000e-01, %v2602 ], [ 2.500000e-01, %v2603 ], [ 3.333000e-01, %v2604 ], [ 5.000000e-01, %v2605 ], [ 0x3FE50A3D70A3D70A, %v2606 ], [ 7.500000e-01, %v2607 ], [ 0x3FB48E8A71DE69AD, %v2598 ]
  %v2608 = fcmp ult double %v2600, %v2537
  br i1 %v2608, label %v2609, label %v2610

v2610:
  %v2611 = load double, ptr %v134, align 8, !noalias !358
  %v2612 = load double, ptr %v754, align 8, !noalias !358
  %v2613 = fmul double %v2600, %v2612
  %v2614 = fadd double %v2611, %v2613
  store double %v2614, ptr %v756, align 8, !noalias !358
  br i1 %v798, label %v2615, label %v2616

v2615:
  %v2617 = fsub double 1.000000e+00, %v2600
  br label %v2618

v2618:
  %v2619 = phi i64 [ 0, %v2615 ], [ %v2620, %v2618 ]
  %v2621 = mul i64 %v2619, %v197
  %v2622 = getelementptr double, ptr %v194, i64 %v2621
  %v2623 = getelementptr i8, ptr %v2622, i64 %v762
  %v2624 = load double, ptr %v2623, align 8, !noalias !362
  %v2625 = fadd double %v2624, 0.000000e+00
  %v2626 = fmul double %v2600, %v2625
  %v2627 = getelementptr i8, ptr %v2622, i64 %v763
  %v2628 = load double, ptr %v2627, align 8, !noalias !362
  %v2629 = fadd double %v2628, %v2626
  %v2630 = fmul double %v2617, %v2629
  %v2631 = getelementptr i8, ptr %v2622, i64 %v764
  %v2632 = load double, ptr %v2631, align 8, !noalias !362
  %v2633 = fadd double %v2632, %v2630
  %v2634 = fmul double %v2600, %v2633
  %v2635 = getelementptr i8, ptr %v2622, i64 %v765
  %v2636 = load double, ptr %v2635, align 8, !noalias !362
  %v2637 = fadd double %v2636, %v2634
  %v2638 = fmul double %v2617, %v2637
  %v2639 = getelementptr i8, ptr %v2622, i64 %v766
  %v2640 = load double, ptr %v2639, align 8, !noalias !362
  %v2641 = fadd double %v2640, %v2638
  %v2642 = fmul double %v2600, %v2641
  %v2643 = getelementptr i8, ptr %v2622, i64 %v767
  %v2644 = load double, ptr %v2643, align 8, !noalias !362
  %v2645 = fadd double %v2644, %v2642
  %v2646 = fmul double %v2617, %v2645
  %v2647 = getelementptr i8, ptr %v2622, i64 %v768
  %v2648 = load double, ptr %v2647, align 8, !noalias !362
  %v2649 = fadd double %v2648, %v2646
  %v2650 = fmul double %v2600, %v2649
  %v2620 = add nsw i64 %v2619, 1
  %v2651 = load double, ptr %v2622, align 8, !noalias !362
  %v2652 = fadd double %v2651, %v2650
  %v2653 = getelementptr double, ptr %v759, i64 %v2621
  store double %v2652, ptr %v2653, align 8, !noalias !358
  %v2654 = icmp eq i64 %v10, %v2620
  br i1 %v2654, label %v2616, label %v2618

v2655:
  %v2656 = load i64, ptr %v825, align 8, !noalias !366
  %v2657 = inttoptr i64 %v2656 to ptr
  tail call void %v2657(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !366
  br label %v2609

v2658:
  %v2659 = phi i64 [ %v2660, %v2658 ], [ 0, %v2661 ]
  %v2660 = add nsw i64 %v2659, 1
  %v2662 = add nsw i64 %v2659, %v18
  %v2663 = icmp slt i64 %v2662, 0
  %v2664 = select i1 %v2663, i64 %v167, i64 0
  %v2665 = getelementptr double, ptr %v166, i64 %v2662
  %v2666 = getelementptr double, ptr %v2665, i64 %v2664
  %v2667 = load double, ptr %v2666, align 8, !noalias !372
  %v2668 = getelementptr double, ptr %v811, i64 %v2659
  %v2669 = load double, ptr %v2668, align 8, !noalias !372
  store double %v2669, ptr %v2666, align 8, !noalias !372
  store double %v2667, ptr %v2668, align 8, !noalias !372
  %v2670 = icmp eq i64 %v19, %v2660
  br i1 %v2670, label %v2655, label %v2658

v2609:
  %v2671 = icmp ugt i64 %v2672, 1
  br i1 %v2671, label %v2597, label %v2673

v2673:
  br i1 %v306, label %v2674, label %v2675

v2675:
  %v2676 = load i64, ptr %v825, align 8, !noalias !373
  %v2677 = inttoptr i64 %v2676 to ptr
  tail call void %v2677(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !373
  br label %v2678

v2674:
  %v2679 = phi i64 [ %v2680, %v2674 ], [ 0, %v2673 ]
  %v2680 = add nsw i64 %v2679, 1
  %v2681 = add nsw i64 %v2679, %v18
  %v2682 = icmp slt i64 %v2681, 0
  %v2683 = select i1 %v2682, i64 %v167, i64 0
  %v2684 = getelementptr double, ptr %v166, i64 %v2681
  %v2685 = getelementptr double, ptr %v2684, i64 %v2683
  %v2686 = load double, ptr %v2685, align 8, !noalias !379
  %v2687 = getelementptr double, ptr %v811, i64 %v2679
  %v2688 = load double, ptr %v2687, align 8, !noalias !379
  store double %v2688, ptr %v2685, align 8, !noalias !379
  store double %v2686, ptr %v2687, align 8, !noalias !379
  %v2689 = icmp eq i64 %v2680, %v19
  br i1 %v2689, label %v2675, label %v2674

v2597:
  %v2672 = phi i64 [ %v2690, %v2609 ], [ 9, %v2585 ]
  %v2691 = phi i64 [ %v2692, %v2609 ], [ 8, %v2585 ]
  %v2690 = add nsw i64 %v2672, -1
  %v2692 = add nsw i64 %v2691, -1
  switch i64 %v2691, label %v2678 [
    i64 0, label %v2599
    i64 -1, label %v2601
    i64 8, label %v2601
    i64 1, label %v2598
    i64 -8, label %v2598
    i64 2, label %v2603
    i64 -7, label %v2603
    i64 3, label %v2604
    i64 -6, label %v2604
    i64 4, label %v2605
    i64 -5, label %v2605
    i64 5, label %v2606
    i64 -4, label %v2606
    i64 6, label %v2607
    i64 -3, label %v2607
    i64 7, label %v2602
    i64 -2, label %v2602
  ]

v2603:
  br label %v2599

v2604:
  br label %v2599

v2605:
  br label %v2599

v2606:
  br label %v2599

v2607:
  br label %v2599

v2602:
  br label %v2599

v2601:
  br label %v2599

v2616:
  %v2693 = load i64, ptr %v6, align 8, !noalias !380
  %v2694 = inttoptr i64 %v2693 to ptr
  tail call void %v2694(ptr nonnull %v756, ptr %v822, ptr %v166, ptr %v173, ptr %v180, ptr %v824), !noalias !380
  br i1 %v306, label %v2695, label %v2696

v2696:
  %v2697 = load i64, ptr %v825, align 8, !noalias !383
  %v2698 = inttoptr i64 %v2697 to ptr
  tail call void %v2698(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !383
  %v2699 = load i64, ptr %v6, align 8, !noalias !389
  %v2700 = inttoptr i64 %v2699 to ptr
  tail call void %v2700(ptr nonnull %v756, ptr %v822, ptr %v166, ptr %v173, ptr %v180, ptr %v827), !noalias !389
  %v2701 = load double, ptr %v24, align 8, !noalias !392
  %v2702 = load double, ptr %v828, align 8, !noalias !392
  br label %v2703

v2695:
  %v2704 = phi i64 [ %v2705, %v2695 ], [ 0, %v2616 ]
  %v2705 = add nsw i64 %v2704, 1
  %v2706 = add nsw i64 %v2704, %v18
  %v2707 = icmp slt i64 %v2706, 0
  %v2708 = select i1 %v2707, i64 %v167, i64 0
  %v2709 = getelementptr double, ptr %v166, i64 %v2706
  %v2710 = getelementptr double, ptr %v2709, i64 %v2708
  %v2711 = load double, ptr %v2710, align 8, !noalias !396
  %v2712 = getelementptr double, ptr %v811, i64 %v2704
  %v2713 = load double, ptr %v2712, align 8, !noalias !396
  store double %v2713, ptr %v2710, align 8, !noalias !396
  store double %v2711, ptr %v2712, align 8, !noalias !396
  %v2714 = icmp eq i64 %v19, %v2705
  br i1 %v2714, label %v2696, label %v2695

v2703:
  %v2715 = phi i64 [ 0, %v2696 ], [ %v2716, %v2717 ]
  %v2718 = icmp eq i64 %v2715, %v817
  br i1 %v2718, label %v2661, label %v2717

v2661:
  br i1 %v306, label %v2658, label %v2655

v2717:
  %v2716 = add i64 %v2715, 1
  %v2719 = mul i64 %v2715, %v197
  %v2720 = getelementptr double, ptr %v830, i64 %v2719
  %v2721 = load double, ptr %v2720, align 8, !noalias !392
  %v2722 = getelementptr double, ptr %v832, i64 %v2719
  %v2723 = load double, ptr %v2722, align 8, !noalias !392
  %v2724 = fsub double %v2721, %v2723
  %v2725 = tail call double @llvm.fabs.f64(double %v2724)
  %v2726 = getelementptr double, ptr %v194, i64 %v2719
  %v2727 = load double, ptr %v2726, align 8, !noalias !392
  %v2728 = tail call double @llvm.fabs.f64(double %v2727)
  %v2729 = fmul double %v2701, %v2728
  %v2730 = fadd double %v2702, %v2729
  %v2731 = load double, ptr %v754, align 8, !noalias !392
  %v2732 = fmul double %v2731, %v2725
  %v2733 = fmul double %v2730, 1.000000e-01
  %v2734 = fcmp ugt double %v2732, %v2733
  br i1 %v2734, label %v2678, label %v2703

v2678:
  %v2735 = phi i1 [ false, %v2717 ], [ true, %v2675 ], [ true, %v2597 ]
  %v2535 = phi ptr [ %v2534, %v2717 ], [ %v2534, %v2675 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.30, %v2597 ]
  %v2736 = phi i1 [ true, %v2717 ], [ true, %v2675 ], [ false, %v2597 ]
  %v2737 = phi i32 [ 0, %v2717 ], [ 0, %v2675 ], [ 1, %v2597 ]
  br i1 %v2736, label %v2299, label %v2361, !prof !131

v2299:
  br i1 %v2735, label %v2295, label %v2366

v2360:
  %v2738 = load double, ptr %v792, align 8, !noalias !285
  store i8 0, ptr %v301, align 1, !noalias !285
  %v2739 = call fastcc i32 @_ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr %v301, ptr %v302, i64 %v13, ptr nonnull readonly %v93, i64 %v94, ptr %v125, i64 %v126, i64 %v127, ptr nonnull %v134, i64 %v136, ptr %v143, i64 %v145, ptr %v205, i64 %v206, i64 %v207, i64 %v208, double %v2738)
  %v2740 = icmp eq i32 %v2739, 0
  br i1 %v2740, label %v2431, label %v2741, !prof !131

v2741:
  %v2742 = load ptr, ptr %v302, align 8, !noalias !285
  br label %v2370

v2431:
  %v2743 = load i8, ptr %v301, align 1, !noalias !285
  %v2744 = icmp eq i8 %v2743, 0
  br i1 %v2744, label %v2362, label %v2430

v2361:
  %v2745 = phi ptr [ %v2357, %v2302 ], [ %v2535, %v2678 ]
  %v2746 = phi i32 [ %v2359, %v2302 ], [ %v2737, %v2678 ]
  %v2747 = icmp ne i32 %v2746, 0
  br label %v2370

v2370:
  %v2748 = phi i1 [ true, %v2365 ], [ false, %v2509 ], [ true, %v2741 ], [ %v2747, %v2361 ]
  %v2749 = phi ptr [ null, %v2365 ], [ null, %v2509 ], [ %v2742, %v2741 ], [ %v2745, %v2361 ]
  %v2750 = phi i1 [ false, %v2365 ], [ false, %v2509 ], [ true, %v2741 ], [ %v2747, %v2361 ]
  call void @llvm.lifetime.end.p0(ptr nonnull %v301), !noalias !180
  call void @llvm.lifetime.end.p0(ptr nonnull %v302), !noalias !180
  %v2751 = select i1 %v2750, ptr %v2749, ptr null, !prof !397
  %v2752 = xor i1 %v2750, true
  br i1 %v2748, label %v2288, label %v2753, !prof !398

v2753:
  %v2754 = load double, ptr %v843, align 8, !noalias !180
  %v2755 = fcmp olt double %v2754, 5.000000e-01
  br i1 %v2755, label %v2288, label %v2276

v2276:
  store double 1.000000e+00, ptr %v859, align 8, !noalias !180
  %v2756 = load double, ptr %v786, align 8, !noalias !399
  %v2757 = load double, ptr %v93, align 8, !noalias !399
  %v2758 = fsub double %v2756, %v2757
  %v2759 = fmul double %v2758, 1.000000e-13
  %v2760 = load double, ptr %v134, align 8, !noalias !399
  %v2761 = tail call double @llvm.fabs.f64(double %v2760)
  %v2762 = fmul double %v2761, 4.000000e-15
  %v2763 = fcmp ogt double %v2762, %v2759
  %v2764 = select i1 %v2763, double %v2762, double %v2759
  %v2765 = load double, ptr %v792, align 8, !noalias !180
  %v2766 = fdiv double %v2764, %v1747
  %v2767 = fcmp ogt double %v2766, %v2765
  %v2768 = select i1 %v2767, double %v2766, double %v2765
  %v2769 = fcmp ult double %v2768, 1.000000e+00
  br i1 %v2769, label %v2770, label %v2288

v2770:
  %v2771 = fsub double 1.000000e+00, %v2768
  br i1 %v724, label %v2772, label %v2773

v2772:
  %v2774 = load double, ptr %v861, align 8, !noalias !180
  %v2775 = fmul double %v2768, 4.000000e+00
  %v2776 = fmul double %v2775, %v2771
  %v2777 = fmul double %v2776, %v2774
  %v2778 = fmul double %v2776, %v2777
  %v2779 = fcmp olt double %v2778, 5.000000e-04
  br i1 %v2779, label %v2780, label %v2773

v2780:
  %v2781 = load double, ptr %v754, align 8, !noalias !403
  %v2782 = fmul double %v2768, %v2781
  %v2783 = fadd double %v2760, %v2782
  store double %v2783, ptr %v756, align 8, !noalias !403
  br i1 %v758, label %v2784, label %v2785

v2785:
  %v2786 = phi i64 [ %v2787, %v2785 ], [ 0, %v2780 ]
  %v2788 = mul i64 %v2786, %v197
  %v2789 = getelementptr double, ptr %v194, i64 %v2788
  %v2790 = getelementptr i8, ptr %v2789, i64 %v762
  %v2791 = load double, ptr %v2790, align 8, !noalias !410
  %v2792 = fadd double %v2791, 0.000000e+00
  %v2793 = fmul double %v2768, %v2792
  %v2794 = getelementptr i8, ptr %v2789, i64 %v763
  %v2795 = load double, ptr %v2794, align 8, !noalias !410
  %v2796 = fadd double %v2795, %v2793
  %v2797 = fmul double %v2771, %v2796
  %v2798 = getelementptr i8, ptr %v2789, i64 %v764
  %v2799 = load double, ptr %v2798, align 8, !noalias !410
  %v2800 = fadd double %v2799, %v2797
  %v2801 = fmul double %v2768, %v2800
  %v2802 = getelementptr i8, ptr %v2789, i64 %v765
  %v2803 = load double, ptr %v2802, align 8, !noalias !410
  %v2804 = fadd double %v2803, %v2801
  %v2805 = fmul double %v2771, %v2804
  %v2806 = getelementptr i8, ptr %v2789, i64 %v766
  %v2807 = load double, ptr %v2806, align 8, !noalias !410
  %v2808 = fadd double %v2807, %v2805
  %v2809 = fmul double %v2768, %v2808
  %v2810 = getelementptr i8, ptr %v2789, i64 %v767
  %v2811 = load double, ptr %v2810, align 8, !noalias !410
  %v2812 = fadd double %v2811, %v2809
  %v2813 = fmul double %v2771, %v2812
  %v2814 = getelementptr i8, ptr %v2789, i64 %v768
  %v2815 = load double, ptr %v2814, align 8, !noalias !410
  %v2816 = fadd double %v2815, %v2813
  %v2817 = fmul double %v2768, %v2816
  %v2787 = add nsw i64 %v2786, 1
  %v2818 = load double, ptr %v2789, align 8, !noalias !410
  %v2819 = fadd double %v2818, %v2817
  %v2820 = getelementptr double, ptr %v759, i64 %v2788
  store double %v2819, ptr %v2820, align 8, !noalias !403
  %v2821 = icmp eq i64 %v10, %v2787
  br i1 %v2821, label %v2822, label %v2785

v2784:
  %v2823 = load double, ptr %v756, align 8, !noalias !414
  store double %v2823, ptr %v788, align 8, !noalias !414
  br label %v2824

v2824:
  %v2825 = load i64, ptr %v6, align 8, !noalias !415
  %v2826 = inttoptr i64 %v2825 to ptr
  tail call void %v2826(ptr nonnull %v756, ptr %v871, ptr %v166, ptr %v173, ptr %v180, ptr %v873), !noalias !415
  %v2827 = load i64, ptr %v761, align 8, !noalias !418
  %v2828 = inttoptr i64 %v2827 to ptr
  tail call void %v2828(ptr nonnull %v756, ptr %v875, ptr %v166, ptr %v173, ptr %v180, ptr %v877), !noalias !418
  br label %v2288

v2822:
  %v2829 = load double, ptr %v756, align 8, !noalias !414
  store double %v2829, ptr %v788, align 8, !noalias !414
  br label %v2830

v2830:
  %v2831 = phi i64 [ 0, %v2822 ], [ %v2832, %v2830 ]
  %v2832 = add nsw i64 %v2831, 1
  %v2833 = mul i64 %v2831, %v197
  %v2834 = getelementptr double, ptr %v759, i64 %v2833
  %v2835 = load double, ptr %v2834, align 8, !noalias !414
  %v2836 = getelementptr double, ptr %v868, i64 %v2833
  store double %v2835, ptr %v2836, align 8, !noalias !414
  %v2837 = icmp eq i64 %v10, %v2832
  br i1 %v2837, label %v2824, label %v2830

v2773:
  %v2838 = fmul double %v2764, 2.000000e+00
  %v2839 = fcmp ogt double %v1747, %v2838
  br i1 %v2839, label %v2840, label %v2288

v2840:
  %v2841 = load double, ptr %v788, align 8, !noalias !180
  %v2842 = tail call double @llvm.fabs.f64(double %v2841)
  %v2843 = fmul double %v2842, 4.000000e-15
  %v2844 = fmul double %v1747, 0x3D719799812DEA11
  %v2845 = fcmp ogt double %v2843, %v2844
  %v2846 = select i1 %v2845, double %v2843, double %v2844
  %v2847 = load double, ptr %v784, align 8, !noalias !180
  %v2848 = fsub double 1.000000e+00, %v2847
  %v2849 = fmul double %v1747, %v2848
  %v2850 = fcmp ogt double %v2849, %v2846
  br i1 %v2850, label %v2851, label %v2288

v2851:
  %v2852 = fmul double %v1747, %v2768
  store double 0.000000e+00, ptr %v863, align 8, !noalias !421
  store double 0.000000e+00, ptr %v865, align 8, !noalias !421
  store double %v2852, ptr %v866, align 8, !noalias !421
  %v2853 = load i64, ptr %v143, align 8, !noalias !421
  %v2854 = icmp slt i64 %v2853, 0
  %v2855 = select i1 %v2854, i64 %v126, i64 0
  %v2856 = add i64 %v2855, %v2853
  %v2857 = mul i64 %v2856, %v127
  %v2858 = getelementptr i64, ptr %v125, i64 %v2857
  %v2859 = load i64, ptr %v2858, align 8, !noalias !421
  %v2860 = add nsw i64 %v2859, -1
  store i64 %v2860, ptr %v2858, align 8, !noalias !421
  %v2861 = load i64, ptr %v143, align 8, !noalias !421
  %v2862 = icmp slt i64 %v2861, 0
  %v2863 = select i1 %v2862, i64 %v126, i64 0
  %v2864 = add i64 %v2863, %v2861
  %v2865 = mul i64 %v2864, %v127
  %v2866 = getelementptr i64, ptr %v125, i64 %v2865
  %v2867 = getelementptr i8, ptr %v2866, i64 24
  %v2868 = load i64, ptr %v2867, align 8, !noalias !421
  %v2869 = add nsw i64 %v2868, 1
  store i64 %v2869, ptr %v2867, align 8, !noalias !421
  br label %v2288

v1815:
  br i1 %v305, label %v1890, label %v2289

v2288:
  %v2870 = phi ptr [ null, %v2824 ], [ null, %v2851 ], [ null, %v2773 ], [ null, %v2276 ], [ null, %v2753 ], [ null, %v2221 ], [ null, %v2840 ], [ %v2751, %v2370 ]
  %v2871 = phi i1 [ true, %v2824 ], [ true, %v2851 ], [ true, %v2773 ], [ true, %v2276 ], [ true, %v2753 ], [ true, %v2221 ], [ true, %v2840 ], [ %v2752, %v2370 ]
  br i1 %v2871, label %v1587, label %v1500, !prof !131

v1587:
  %v2872 = select i1 %v1407, i1 true, i1 %v687
  %v2873 = select i1 %v2872, i64 0, i64 %v12
  br label %v1500

v2874:
  %v2875 = phi i64 [ 0, %v1493 ], [ %v2876, %v2877 ]
  %v2878 = phi i64 [ %v716, %v1493 ], [ %v2879, %v2877 ]
  %v2880 = icmp sgt i64 %v2878, 0
  br i1 %v2880, label %v2877, label %v1494

v1493:
  %v2881 = load double, ptr %v715, align 8, !noalias !424
  store double %v2881, ptr %v701, align 8, !noalias !424
  br label %v2874

v2877:
  %v2879 = add nsw i64 %v2878, -1
  %v2876 = add i64 %v2875, 1
  %v2882 = getelementptr double, ptr %v718, i64 %v2875
  %v2883 = icmp slt i64 %v2875, 0
  %v2884 = select i1 %v2883, i64 %v208, i64 0
  %v2885 = getelementptr double, ptr %v2882, i64 %v2884
  %v2886 = load double, ptr %v2885, align 8, !noalias !424
  %v2887 = fcmp olt double %v2886, 0x7FF0000000000000
  %v2888 = select i1 %v2887, double %v2886, double 0x7FF0000000000000
  %v2889 = fcmp ogt double %v2886, 0xFFF0000000000000
  %v2890 = select i1 %v2889, double %v2886, double 0xFFF0000000000000
  %v2891 = getelementptr double, ptr %v2885, i64 %v717
  %v2892 = load double, ptr %v2891, align 8, !noalias !424
  %v2893 = fcmp olt double %v2892, %v2888
  %v2894 = select i1 %v2893, double %v2892, double %v2888
  %v2895 = fcmp ogt double %v2892, %v2890
  %v2896 = select i1 %v2895, double %v2892, double %v2890
  %v2897 = getelementptr i8, ptr %v2885, i64 %v1048
  %v2898 = load double, ptr %v2897, align 8, !noalias !424
  %v2899 = fcmp olt double %v2898, %v2894
  %v2900 = select i1 %v2899, double %v2898, double %v2894
  %v2901 = fcmp ogt double %v2898, %v2896
  %v2902 = select i1 %v2901, double %v2898, double %v2896
  %v2903 = getelementptr i8, ptr %v2885, i64 %v1049
  %v2904 = load double, ptr %v2903, align 8, !noalias !424
  %v2905 = fcmp olt double %v2904, %v2900
  %v2906 = select i1 %v2905, double %v2904, double %v2900
  %v2907 = fcmp ogt double %v2904, %v2902
  %v2908 = select i1 %v2907, double %v2904, double %v2902
  %v2909 = getelementptr i8, ptr %v2885, i64 %v1050
  %v2910 = load double, ptr %v2909, align 8, !noalias !424
  %v2911 = fcmp olt double %v2910, %v2906
  %v2912 = select i1 %v2911, double %v2910, double %v2906
  %v2913 = fcmp ogt double %v2910, %v2908
  %v2914 = select i1 %v2913, double %v2910, double %v2908
  %v2915 = getelementptr i8, ptr %v2885, i64 %v1051
  %v2916 = load double, ptr %v2915, align 8, !noalias !424
  %v2917 = fcmp olt double %v2916, %v2912
  %v2918 = select i1 %v2917, double %v2916, double %v2912
  %v2919 = fcmp ogt double %v2916, %v2914
  %v2920 = select i1 %v2919, double %v2916, double %v2914
  %v2921 = getelementptr i8, ptr %v2885, i64 %v1052
  %v2922 = load double, ptr %v2921, align 8, !noalias !424
  %v2923 = fcmp olt double %v2922, %v2918
  %v2924 = select i1 %v2923, double %v2922, double %v2918
  %v2925 = fcmp ogt double %v2922, %v2920
  %v2926 = select i1 %v2925, double %v2922, double %v2920
  %v2927 = getelementptr i8, ptr %v2885, i64 %v1053
  %v2928 = load double, ptr %v2927, align 8, !noalias !424
  %v2929 = fcmp olt double %v2928, %v2924
  %v2930 = select i1 %v2929, double %v2928, double %v2924
  %v2931 = fcmp ogt double %v2928, %v2926
  %v2932 = select i1 %v2931, double %v2928, double %v2926
  %v2933 = getelementptr i8, ptr %v2885, i64 %v1054
  %v2934 = load double, ptr %v2933, align 8, !noalias !424
  %v2935 = fcmp olt double %v2934, %v2930
  %v2936 = select i1 %v2935, double %v2934, double %v2930
  %v2937 = fcmp ogt double %v2934, %v2932
  %v2938 = select i1 %v2937, double %v2934, double %v2932
  %v2939 = fsub double %v2938, %v2936
  %v2940 = fmul double %v2939, 2.500000e-01
  %v2941 = icmp slt i64 %v2875, 0
  %v2942 = select i1 %v2941, i64 %v208, i64 0
  %v2943 = add i64 %v2942, %v2875
  %v2944 = getelementptr double, ptr %v720, i64 %v2943
  %v2945 = getelementptr double, ptr %v721, i64 %v2943
  %v2946 = getelementptr double, ptr %v2944, i64 %v719
  %v2947 = load double, ptr %v2946, align 8, !noalias !425
  %v2948 = load double, ptr %v2945, align 8, !noalias !425
  %v2949 = fmul double %v2948, 0x3FDDF27AAAADCB3A
  %v2950 = fsub double %v2947, %v2949
  %v2951 = getelementptr i8, ptr %v2945, i64 %v1055
  %v2952 = load double, ptr %v2951, align 8, !noalias !425
  %v2953 = fmul double %v2952, 0x3FEC575F1EBC4F2F
  %v2954 = fsub double %v2950, %v2953
  %v2955 = getelementptr i8, ptr %v2945, i64 %v1056
  %v2956 = load double, ptr %v2955, align 8, !noalias !425
  %v2957 = fmul double %v2956, 0xBFE1306AA3D795F4
  %v2958 = fsub double %v2954, %v2957
  %v2959 = getelementptr i8, ptr %v2945, i64 %v1057
  %v2960 = load double, ptr %v2959, align 8, !noalias !425
  %v2961 = fmul double %v2960, 0x3FCCB9F574BDCC3A
  %v2962 = fsub double %v2958, %v2961
  %v2963 = getelementptr i8, ptr %v2945, i64 %v1058
  %v2964 = load double, ptr %v2963, align 8, !noalias !425
  %v2965 = fmul double %v2964, 0xBFA4EAF2D6B11E79
  %v2966 = fsub double %v2962, %v2965
  %v2967 = tail call double @llvm.fabs.f64(double %v2966)
  %v2968 = fcmp ogt double %v2967, 0.000000e+00
  %v2969 = select i1 %v2968, double %v2967, double 0.000000e+00
  %v2970 = getelementptr i8, ptr %v2944, i64 %v1059
  %v2971 = load double, ptr %v2970, align 8, !noalias !425
  %v2972 = load double, ptr %v2945, align 8, !noalias !425
  %v2973 = fmul double %v2972, 0xBFA5118805F8B876
  %v2974 = fsub double %v2971, %v2973
  %v2975 = getelementptr i8, ptr %v2945, i64 %v1060
  %v2976 = load double, ptr %v2975, align 8, !noalias !425
  %v2977 = fmul double %v2976, 0x3FE51326698BC5BD
  %v2978 = fsub double %v2974, %v2977
  %v2979 = getelementptr i8, ptr %v2945, i64 %v1061
  %v2980 = load double, ptr %v2979, align 8, !noalias !425
  %v2981 = fmul double %v2980, 0x3FDF97DED30D4572
  %v2982 = fsub double %v2978, %v2981
  %v2983 = getelementptr i8, ptr %v2945, i64 %v1062
  %v2984 = load double, ptr %v2983, align 8, !noalias !425
  %v2985 = fmul double %v2984, 0xBFC0DA0C684D1D67
  %v2986 = fsub double %v2982, %v2985
  %v2987 = getelementptr i8, ptr %v2945, i64 %v1063
  %v2988 = load double, ptr %v2987, align 8, !noalias !425
  %v2989 = fmul double %v2988, 0x3F9510B8EC0D4D92
  %v2990 = fsub double %v2986, %v2989
  %v2991 = tail call double @llvm.fabs.f64(double %v2990)
  %v2992 = fcmp ogt double %v2991, %v2969
  %v2993 = select i1 %v2992, double %v2991, double %v2969
  %v2994 = getelementptr i8, ptr %v2944, i64 %v1064
  %v2995 = load double, ptr %v2994, align 8, !noalias !425
  %v2996 = load double, ptr %v2945, align 8, !noalias !425
  %v2997 = fmul double %v2996, 0x3F9635A30F8F142F
  %v2998 = fsub double %v2995, %v2997
  %v2999 = getelementptr i8, ptr %v2945, i64 %v1065
  %v3000 = load double, ptr %v2999, align 8, !noalias !425
  %v3001 = fmul double %v3000, 0xBFC1EAE0FF33D241
  %v3002 = fsub double %v2998, %v3001
  %v3003 = getelementptr i8, ptr %v2945, i64 %v1066
  %v3004 = load double, ptr %v3003, align 8, !noalias !425
  %v3005 = fmul double %v3004, 0x3FE1625D59218460
  %v3006 = fsub double %v3002, %v3005
  %v3007 = getelementptr i8, ptr %v2945, i64 %v1067
  %v3008 = load double, ptr %v3007, align 8, !noalias !425
  %v3009 = fmul double %v3008, 0x3FE3BBC3E8A29641
  %v3010 = fsub double %v3006, %v3009
  %v3011 = getelementptr i8, ptr %v2945, i64 %v1068
  %v3012 = load double, ptr %v3011, align 8, !noalias !425
  %v3013 = fmul double %v3012, 0xBFA55161A739EB34
  %v3014 = fsub double %v3010, %v3013
  %v3015 = tail call double @llvm.fabs.f64(double %v3014)
  %v3016 = fcmp ogt double %v3015, %v2993
  %v3017 = select i1 %v3016, double %v3015, double %v2993
  %v3018 = getelementptr i8, ptr %v2944, i64 %v1069
  %v3019 = load double, ptr %v3018, align 8, !noalias !425
  %v3020 = load double, ptr %v2945, align 8, !noalias !425
  %v3021 = fmul double %v3020, 0xBFA4F0C0BB579409
  %v3022 = fsub double %v3019, %v3021
  %v3023 = getelementptr i8, ptr %v2945, i64 %v1070
  %v3024 = load double, ptr %v3023, align 8, !noalias !425
  %v3025 = fmul double %v3024, 0x3FCD2266FBC0D976
  %v3026 = fsub double %v3022, %v3025
  %v3027 = getelementptr i8, ptr %v2945, i64 %v1071
  %v3028 = load double, ptr %v3027, align 8, !noalias !425
  %v3029 = fmul double %v3028, 0xBFE1F2DB6FEE3151
  %v3030 = fsub double %v3026, %v3029
  %v3031 = getelementptr i8, ptr %v2945, i64 %v1072
  %v3032 = load double, ptr %v3031, align 8, !noalias !425
  %v3033 = fmul double %v3032, 0x3FF0C05015964CBE
  %v3034 = fsub double %v3030, %v3033
  %v3035 = getelementptr i8, ptr %v2945, i64 %v1073
  %v3036 = load double, ptr %v3035, align 8, !noalias !425
  %v3037 = fmul double %v3036, 0x3FD4F15B230DB570
  %v3038 = fsub double %v3034, %v3037
  %v3039 = tail call double @llvm.fabs.f64(double %v3038)
  %v3040 = fcmp ogt double %v3039, %v3017
  %v3041 = select i1 %v3040, double %v3039, double %v3017
  %v3042 = fmul double %v3041, 1.000000e+01
  %v3043 = fadd double %v2940, %v3042
  %v3044 = icmp slt i64 %v2875, 0
  %v3045 = select i1 %v3044, i64 %v208, i64 0
  %v3046 = getelementptr double, ptr %v723, i64 %v2875
  %v3047 = getelementptr double, ptr %v3046, i64 %v3045
  %v3048 = load double, ptr %v3047, align 8, !noalias !424
  %v3049 = fcmp ogt double %v3043, %v3048
  %v3050 = fneg double %v3048
  %v3051 = select i1 %v3049, double %v3043, double %v3050
  %v3052 = fcmp olt double %v2936, %v3051
  br i1 %v3052, label %v1494, label %v2874

v1494:
  %v1496 = phi i1 [ false, %v1436 ], [ %v2880, %v2877 ], [ %v2880, %v2874 ]
  %v3053 = phi ptr [ %v1491, %v1436 ], [ null, %v2877 ], [ null, %v2874 ]
  %v3054 = phi i32 [ %v1492, %v1436 ], [ 0, %v2877 ], [ 0, %v2874 ]
  %v3055 = icmp eq i32 %v3054, 0
  br i1 %v3055, label %v1426, label %v1500, !prof !131

v1744:
  br i1 %v1739, label %v1587, label %v1745

v1500:
  %v3056 = phi i64 [ 0, %v1426 ], [ %v2873, %v1587 ], [ 0, %v1494 ], [ 0, %v1652 ], [ 0, %v2288 ]
  %v3057 = phi i1 [ true, %v1426 ], [ true, %v1587 ], [ false, %v1494 ], [ false, %v1652 ], [ false, %v2288 ]
  %v3058 = phi ptr [ undef, %v1426 ], [ undef, %v1587 ], [ %v3053, %v1494 ], [ %v1743, %v1652 ], [ %v2870, %v2288 ]
  %v3059 = phi i32 [ 0, %v1426 ], [ 0, %v1587 ], [ 1, %v1494 ], [ 1, %v1652 ], [ 1, %v2288 ]
  br i1 %v3057, label %v3060, label %v3061, !prof !131

v3062:
  %v3063 = getelementptr double, ptr %v880, i64 %v3064
  %v3065 = load double, ptr %v3063, align 8, !noalias !429
  %v3066 = fcmp olt double %v3065, 5.000000e-01
  br i1 %v3066, label %v3067, label %v3068

v3068:
  %v3069 = getelementptr i64, ptr %v111, i64 %v3070
  %v3071 = load i64, ptr %v3069, align 8, !noalias !429
  %v3072 = icmp eq i64 %v3071, 0
  br i1 %v3072, label %v3073, label %v3067

v3073:
  %v3074 = mul i64 %v3070, %v127
  %v3075 = getelementptr i64, ptr %v125, i64 %v3074
  %v3076 = getelementptr i8, ptr %v3075, i64 8
  %v3077 = load i64, ptr %v3076, align 8, !noalias !429
  %v3078 = add nsw i64 %v3077, %v3056
  store i64 %v3078, ptr %v3076, align 8, !noalias !429
  %v3079 = getelementptr double, ptr %v882, i64 %v3064
  %v3080 = load double, ptr %v3079, align 8, !noalias !429
  %v3081 = load i64, ptr %v3082, align 8, !noalias !432
  %v3083 = getelementptr i64, ptr %v884, i64 %v3064
  %v3084 = load i64, ptr %v3083, align 8, !noalias !432
  %v3085 = icmp slt i64 %v3084, %v94
  br i1 %v3085, label %v3086, label %v3087

v3086:
  %v3088 = icmp slt i64 %v3084, 0
  %v3089 = select i1 %v3088, i64 %v94, i64 0
  %v3090 = getelementptr double, ptr %v93, i64 %v3084
  %v3091 = getelementptr double, ptr %v3090, i64 %v3089
  %v3092 = load double, ptr %v3091, align 8, !noalias !432
  %v3093 = fcmp ugt double %v3092, %v3080
  br i1 %v3093, label %v3087, label %v3094

v3094:
  %v3095 = getelementptr double, ptr %v134, i64 %v3064
  %v3096 = getelementptr double, ptr %v886, i64 %v3064
  %v3097 = getelementptr double, ptr %v194, i64 %v3064
  %v3098 = getelementptr double, ptr %v890, i64 %v3064
  %v3099 = icmp slt i64 %v3081, 0
  %v3100 = select i1 %v3099, i64 %v101, i64 0
  %v3101 = add i64 %v3100, %v3081
  %v3102 = mul i64 %v891, %v3101
  %v3103 = getelementptr double, ptr %v100, i64 %v3102
  %v3104 = getelementptr double, ptr %v892, i64 %v3064
  br label %v3105

v3105:
  %v3106 = phi i64 [ %v3107, %v3108 ], [ %v3084, %v3094 ]
  %v3109 = icmp slt i64 %v3106, 0
  %v3110 = select i1 %v3109, i64 %v94, i64 0
  %v3111 = getelementptr double, ptr %v93, i64 %v3106
  %v3112 = getelementptr double, ptr %v3111, i64 %v3110
  %v3113 = load double, ptr %v3112, align 8, !noalias !432
  %v3114 = load double, ptr %v3095, align 8, !noalias !432
  %v3115 = fsub double %v3113, %v3114
  %v3116 = load double, ptr %v3096, align 8, !noalias !432
  %v3117 = fdiv double %v3115, %v3116
  br i1 %v888, label %v3118, label %v3119

v3119:
  %v3120 = fsub double 1.000000e+00, %v3117
  %v3121 = select i1 %v3109, i64 %v102, i64 0
  %v3122 = add i64 %v3121, %v3106
  %v3123 = mul i64 %v3122, %v103
  %v3124 = getelementptr double, ptr %v3103, i64 %v3123
  br label %v3125

v3126:
  %v3127 = getelementptr double, ptr %v3104, i64 %v3128
  %v3129 = load double, ptr %v3127, align 8, !noalias !432
  br label %v3130

v3118:
  store double 0x7FF0000000000000, ptr %v3098, align 8, !noalias !432
  %v3131 = icmp eq i64 %v3106, %v893
  br i1 %v3131, label %v3087, label %v3108

v3108:
  %v3107 = add i64 %v3106, 1
  %v3132 = icmp slt i64 %v3106, -1
  %v3133 = select i1 %v3132, i64 %v94, i64 0
  %v3134 = getelementptr double, ptr %v93, i64 %v3107
  %v3135 = getelementptr double, ptr %v3134, i64 %v3133
  %v3136 = load double, ptr %v3135, align 8, !noalias !432
  %v3137 = fcmp ugt double %v3136, %v3080
  br i1 %v3137, label %v3087, label %v3105

v3087:
  %v3138 = phi i64 [ %v3084, %v3086 ], [ %v3084, %v3073 ], [ %v94, %v3118 ], [ %v3107, %v3108 ]
  store i64 %v3138, ptr %v3083, align 8, !noalias !432
  br label %v3067

v3130:
  %v3139 = phi double [ %v3140, %v3141 ], [ %v3129, %v3126 ]
  %v3142 = getelementptr double, ptr %v3124, i64 %v3143
  store double %v3139, ptr %v3142, align 8, !noalias !432
  %v3144 = icmp eq i64 %v10, %v3145
  br i1 %v3144, label %v3118, label %v3125

v3125:
  %v3143 = phi i64 [ 0, %v3119 ], [ %v3145, %v3130 ]
  %v3145 = add nsw i64 %v3143, 1
  %v3146 = load double, ptr %v3112, align 8, !noalias !432
  %v3147 = load double, ptr %v3079, align 8, !noalias !432
  %v3148 = fcmp oeq double %v3146, %v3147
  %v3128 = mul i64 %v3143, %v197
  br i1 %v3148, label %v3126, label %v3141

v3141:
  %v3149 = getelementptr double, ptr %v3097, i64 %v3128
  %v3150 = getelementptr i8, ptr %v3149, i64 %v894
  %v3151 = load double, ptr %v3150, align 8, !noalias !436
  %v3152 = fadd double %v3151, 0.000000e+00
  %v3153 = fmul double %v3117, %v3152
  %v3154 = getelementptr i8, ptr %v3149, i64 %v895
  %v3155 = load double, ptr %v3154, align 8, !noalias !436
  %v3156 = fadd double %v3155, %v3153
  %v3157 = fmul double %v3120, %v3156
  %v3158 = getelementptr i8, ptr %v3149, i64 %v896
  %v3159 = load double, ptr %v3158, align 8, !noalias !436
  %v3160 = fadd double %v3159, %v3157
  %v3161 = fmul double %v3117, %v3160
  %v3162 = getelementptr i8, ptr %v3149, i64 %v897
  %v3163 = load double, ptr %v3162, align 8, !noalias !436
  %v3164 = fadd double %v3163, %v3161
  %v3165 = fmul double %v3120, %v3164
  %v3166 = getelementptr i8, ptr %v3149, i64 %v898
  %v3167 = load double, ptr %v3166, align 8, !noalias !436
  %v3168 = fadd double %v3167, %v3165
  %v3169 = fmul double %v3117, %v3168
  %v3170 = getelementptr i8, ptr %v3149, i64 %v899
  %v3171 = load double, ptr %v3170, align 8, !noalias !436
  %v3172 = fadd double %v3171, %v3169
  %v3173 = fmul double %v3120, %v3172
  %v3174 = getelementptr i8, ptr %v3149, i64 %v900
  %v3175 = load double, ptr %v3174, align 8, !noalias !436
  %v3176 = fadd double %v3175, %v3173
  %v3177 = fmul double %v3117, %v3176
  %v3178 = load double, ptr %v3149, align 8, !noalias !436
  %v3140 = fadd double %v3178, %v3177
  br label %v3130

v3067:
  %v3179 = icmp eq i64 %v3180, %v9
  br i1 %v3179, label %v3181, label %v3182

v3182:
  %v3064 = phi i64 [ %v3180, %v3067 ], [ 0, %v3060 ]
  %v3180 = add nsw i64 %v3064, 1
  %v3082 = getelementptr i64, ptr %v143, i64 %v3064
  %v3070 = load i64, ptr %v3082, align 8, !noalias !429
  %v3183 = icmp slt i64 %v3070, 0
  br i1 %v3183, label %v3067, label %v3062

v3181:
  br i1 %v901, label %v3184, label %v3185

v3185:
  %v3186 = load double, ptr %v903, align 8
  %v3187 = fcmp ogt double %v3186, 5.000000e-01
  br i1 %v3187, label %v3184, label %v3188

v3184:
  %v3189 = load i64, ptr %v904, align 8, !noalias !440
  %v3190 = inttoptr i64 %v3189 to ptr
  tail call void %v3190(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !440
  br label %v3188

v3188:
  br i1 %v1422, label %v3191, label %v3192

v3191:
  %v3193 = load double, ptr %v906, align 8, !noalias !443
  %v3194 = fcmp olt double %v3193, 5.000000e-01
  br i1 %v3194, label %v3192, label %v3195

v3195:
  br i1 %v908, label %v3196, label %v3197

v3198:
  %v3199 = getelementptr double, ptr %v909, i64 %v3200
  %v3201 = load double, ptr %v3199, align 8, !noalias !443
  %v3202 = add nsw i64 %v3200, %v18
  %v3203 = icmp slt i64 %v3202, 0
  %v3204 = select i1 %v3203, i64 %v167, i64 0
  %v3205 = getelementptr double, ptr %v166, i64 %v3202
  %v3206 = getelementptr double, ptr %v3205, i64 %v3204
  %v3207 = load double, ptr %v3206, align 8, !noalias !443
  %v3208 = fcmp une double %v3201, %v3207
  br label %v3209

v3209:
  %v3210 = phi i1 [ true, %v3196 ], [ %v3208, %v3198 ]
  %v3211 = icmp eq i64 %v3212, %v19
  br i1 %v3211, label %v3197, label %v3196

v3197:
  %v3213 = phi i1 [ false, %v3195 ], [ %v3210, %v3209 ]
  %v3214 = load double, ptr %v911, align 8, !noalias !443
  %v3215 = fcmp oeq double %v3214, 1.000000e+00
  %v3216 = select i1 %v3215, i1 %v3213, i1 false
  br i1 %v3216, label %v3217, label %v3218

v3217:
  %v3219 = load double, ptr %v134, align 8, !noalias !443
  %v3220 = load double, ptr %v913, align 8, !noalias !443
  %v3221 = fsub double %v3219, %v3220
  br i1 %v914, label %v3222, label %v3223

v3224:
  %v3225 = load double, ptr %v915, align 8, !noalias !443
  %v3226 = load double, ptr %v24, align 8, !noalias !443
  %v3227 = mul i64 %v3228, %v197
  %v3229 = getelementptr double, ptr %v194, i64 %v3227
  %v3230 = load double, ptr %v3229, align 8, !noalias !443
  %v3231 = tail call double @llvm.fabs.f64(double %v3230)
  %v3232 = fmul double %v3226, %v3231
  %v3233 = fadd double %v3225, %v3232
  %v3234 = add i64 %v3228, %v196
  %v3235 = mul i64 %v3234, %v197
  %v3236 = getelementptr double, ptr %v194, i64 %v3235
  %v3237 = load double, ptr %v3236, align 8, !noalias !443
  %v3238 = tail call double @llvm.fabs.f64(double %v3237)
  %v3239 = fmul double %v3221, %v3238
  %v3240 = fcmp ogt double %v3239, %v3233
  br label %v3241

v3241:
  %v3242 = phi i1 [ true, %v3223 ], [ %v3240, %v3224 ]
  %v3243 = icmp eq i64 %v10, %v3244
  br i1 %v3243, label %v3245, label %v3223

v3245:
  %v3246 = select i1 %v3242, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  br label %v3222

v3222:
  %v3247 = phi double [ 5.000000e-06, %v3217 ], [ %v3246, %v3245 ]
  %v3248 = load double, ptr %v917, align 8, !noalias !443
  %v3249 = load double, ptr %v93, align 8, !noalias !443
  %v3250 = fsub double %v3248, %v3249
  %v3251 = fmul double %v3247, %v3250
  %v3252 = fcmp olt double %v3221, %v3251
  br i1 %v3252, label %v3253, label %v3254

v3253:
  %v3255 = load i64, ptr %v919, align 8, !noalias !443
  %v3256 = add nsw i64 %v3255, 1
  br label %v3254

v3254:
  %v3257 = phi i64 [ %v3256, %v3253 ], [ 0, %v3222 ]
  store i64 %v3257, ptr %v921, align 8, !noalias !443
  %v3258 = load double, ptr %v134, align 8, !noalias !443
  store double %v3258, ptr %v913, align 8, !noalias !443
  store double 1.000000e+00, ptr %v923, align 8, !noalias !443
  store i64 2, ptr %v497, align 8, !noalias !443
  %v3259 = load i64, ptr %v921, align 8, !noalias !443
  %v3260 = icmp sgt i64 %v3259, 1000
  br i1 %v3260, label %v3261, label %v3218

v3261:
  %v3262 = load i64, ptr %v143, align 8, !noalias !447
  %v3263 = icmp sgt i64 %v3262, -1
  br i1 %v3263, label %v3264, label %v3218

v3264:
  %v3265 = getelementptr i64, ptr %v111, i64 %v3262
  %v3266 = load i64, ptr %v3265, align 8, !noalias !447
  %v3267 = icmp eq i64 %v3266, 0
  br i1 %v3267, label %v3268, label %v3218

v3268:
  store i64 6, ptr %v3265, align 8, !noalias !447
  br label %v3218

v3218:
  store double 0.000000e+00, ptr %v911, align 8, !noalias !443
  br label %v3192

v3196:
  %v3269 = phi i1 [ %v3210, %v3209 ], [ false, %v3195 ]
  %v3200 = phi i64 [ %v3212, %v3209 ], [ 0, %v3195 ]
  %v3212 = add nsw i64 %v3200, 1
  br i1 %v3269, label %v3209, label %v3198

v3223:
  %v3270 = phi i1 [ %v3242, %v3241 ], [ false, %v3217 ]
  %v3228 = phi i64 [ %v3244, %v3241 ], [ 0, %v3217 ]
  %v3244 = add nsw i64 %v3228, 1
  br i1 %v3270, label %v3241, label %v3224

v3192:
  %v3271 = and i1 %v924, %v1308
  %v3272 = xor i1 %v3271, true
  %v3273 = or i1 %v308, %v3272
  br i1 %v3273, label %v3274, label %v3275

v3276:
  %v3277 = getelementptr i64, ptr %v111, i64 %v3278
  %v3279 = load i64, ptr %v3277, align 8, !noalias !450
  %v3280 = icmp eq i64 %v3279, 0
  br i1 %v3280, label %v3281, label %v3282

v3281:
  %v3283 = getelementptr double, ptr %v927, i64 %v3284
  %v3285 = load double, ptr %v3283, align 8, !noalias !450
  %v3286 = fcmp olt double %v3285, 5.000000e-01
  br i1 %v3286, label %v3282, label %v3287

v3287:
  %v3288 = getelementptr double, ptr %v134, i64 %v3284
  %v3289 = load double, ptr %v3288, align 8, !noalias !450
  %v3290 = getelementptr double, ptr %v929, i64 %v3284
  %v3291 = load double, ptr %v3290, align 8, !noalias !450
  %v3292 = fcmp une double %v3289, %v3291
  %v3293 = select i1 %v3292, i1 true, i1 %v931
  %v3294 = xor i1 %v3292, true
  %v3295 = select i1 %v3294, i1 true, i1 %v3296
  br i1 %v3293, label %v3282, label %v3297

v3297:
  %v3298 = getelementptr i64, ptr %v930, i64 %v3284
  %v3299 = load i64, ptr %v3298, align 8, !noalias !455
  %v3300 = add nsw i64 %v3299, 1
  %v3301 = icmp slt i64 %v3299, -1
  %v3302 = select i1 %v3301, i64 %v78, i64 0
  %v3303 = add i64 %v3300, %v3302
  %v3304 = mul i64 %v3303, %v79
  %v3305 = getelementptr double, ptr %v77, i64 %v3304
  br label %v3306

v3306:
  %v3307 = phi i64 [ 0, %v3297 ], [ %v3308, %v3306 ]
  %v3308 = add nsw i64 %v3307, 1
  %v3309 = getelementptr double, ptr %v3305, i64 %v3307
  %v3310 = load double, ptr %v3309, align 8, !noalias !456
  %v3311 = getelementptr i64, ptr %v63, i64 %v3307
  %v3312 = load i64, ptr %v3311, align 8, !noalias !456
  %v3313 = mul nsw i64 %v3312, %v9
  %v3314 = add nsw i64 %v3313, %v3284
  %v3315 = icmp slt i64 %v3314, 0
  %v3316 = select i1 %v3315, i64 %v167, i64 0
  %v3317 = getelementptr double, ptr %v166, i64 %v3314
  %v3318 = getelementptr double, ptr %v3317, i64 %v3316
  store double %v3310, ptr %v3318, align 8, !noalias !456
  %v3319 = icmp eq i64 %v64, %v3308
  br i1 %v3319, label %v3282, label %v3306

v3282:
  %v3320 = phi i1 [ %v3295, %v3287 ], [ %v3296, %v3281 ], [ %v3296, %v3275 ], [ %v3296, %v3276 ], [ true, %v3306 ]
  %v3321 = icmp eq i64 %v9, %v3322
  br i1 %v3321, label %v3323, label %v3275

v3323:
  br i1 %v3320, label %v3324, label %v3274

v3324:
  %v3325 = load i64, ptr %v932, align 8, !noalias !460
  %v3326 = inttoptr i64 %v3325 to ptr
  tail call void %v3326(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !460
  %v3327 = load i64, ptr %v934, align 8, !noalias !455
  %v3328 = inttoptr i64 %v3327 to ptr
  tail call void %v3328(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v936), !noalias !455
  br label %v3329

v3329:
  %v3330 = phi i64 [ 0, %v3324 ], [ %v3331, %v3332 ]
  %v3333 = phi i64 [ %v938, %v3324 ], [ %v3334, %v3332 ]
  %v3335 = phi i64 [ 1, %v3324 ], [ %v3336, %v3332 ]
  %v3337 = icmp slt i64 %v3330, 0
  %v3338 = select i1 %v3337, i64 %v145, i64 0
  %v3339 = add i64 %v3338, %v3330
  %v3340 = getelementptr i64, ptr %v143, i64 %v3339
  %v3341 = load i64, ptr %v3340, align 8, !noalias !463
  %v3342 = icmp slt i64 %v3341, 0
  br i1 %v3342, label %v3332, label %v3343

v3343:
  %v3344 = getelementptr i64, ptr %v111, i64 %v3341
  %v3345 = load i64, ptr %v3344, align 8, !noalias !463
  %v3346 = icmp eq i64 %v3345, 0
  br i1 %v3346, label %v3347, label %v3332

v3347:
  %v3348 = select i1 %v3337, i64 %v136, i64 0
  %v3349 = add i64 %v3348, %v3330
  %v3350 = getelementptr double, ptr %v927, i64 %v3349
  %v3351 = load double, ptr %v3350, align 8, !noalias !463
  %v3352 = fcmp olt double %v3351, 5.000000e-01
  br i1 %v3352, label %v3332, label %v3353

v3353:
  %v3354 = getelementptr double, ptr %v134, i64 %v3349
  %v3355 = load double, ptr %v3354, align 8, !noalias !463
  %v3356 = getelementptr double, ptr %v929, i64 %v3349
  %v3357 = load double, ptr %v3356, align 8, !noalias !463
  %v3358 = fcmp une double %v3355, %v3357
  br i1 %v3358, label %v3332, label %v3359

v3359:
  %v3360 = getelementptr i64, ptr %v941, i64 %v3339
  %v3361 = load i64, ptr %v3360, align 8, !noalias !466
  %v3362 = icmp sgt i64 %v3361, 0
  br i1 %v3362, label %v3363, label %v3364

v3363:
  %v3365 = getelementptr double, ptr %v93, i64 %v3361
  %v3366 = getelementptr i8, ptr %v3365, i64 -8
  %v3367 = load double, ptr %v3366, align 8, !noalias !466
  %v3368 = getelementptr double, ptr %v134, i64 %v3330
  %v3369 = getelementptr double, ptr %v3368, i64 %v3348
  %v3370 = load double, ptr %v3369, align 8, !noalias !466
  %v3371 = fcmp oeq double %v3367, %v3370
  br label %v3364

v3364:
  %v3372 = phi i1 [ %v3371, %v3363 ], [ false, %v3359 ]
  br i1 %v943, label %v3373, label %v3374

v3374:
  %v3375 = mul i64 %v937, %v3341
  %v3376 = select i1 %v3337, i64 %v197, i64 0
  %v3377 = add i64 %v3376, %v3330
  %v3378 = getelementptr double, ptr %v944, i64 %v3377
  %v3379 = getelementptr double, ptr %v194, i64 %v3377
  %v3380 = add nsw i64 %v3361, -1
  %v3381 = select i1 %v3362, i64 0, i64 %v102
  %v3382 = add i64 %v3380, %v3381
  %v3383 = mul i64 %v3382, %v103
  %v3384 = getelementptr double, ptr %v100, i64 %v3375
  %v3385 = getelementptr double, ptr %v3384, i64 %v3383
  br label %v3386

v3387:
  %v3388 = getelementptr double, ptr %v3385, i64 %v3389
  store double %v3390, ptr %v3388, align 8, !noalias !466
  br label %v3391

v3391:
  %v3392 = icmp eq i64 %v10, %v3393
  br i1 %v3392, label %v3394, label %v3386

v3394:
  %v3395 = fcmp une double %v3396, 0.000000e+00
  br i1 %v3395, label %v3397, label %v3373

v3397:
  %v3398 = load i64, ptr %v3340, align 8, !noalias !470
  %v3399 = icmp sgt i64 %v3398, -1
  br i1 %v3399, label %v3400, label %v3373

v3400:
  %v3401 = getelementptr i64, ptr %v111, i64 %v3398
  %v3402 = load i64, ptr %v3401, align 8, !noalias !470
  %v3403 = icmp eq i64 %v3402, 0
  br i1 %v3403, label %v3404, label %v3373

v3404:
  store i64 3, ptr %v3401, align 8, !noalias !470
  br label %v3373

v3373:
  br i1 %v305, label %v3405, label %v3332

v3405:
  %v3406 = load double, ptr %v946, align 8, !noalias !473
  %v3407 = load double, ptr %v93, align 8, !noalias !473
  %v3408 = fsub double %v3406, %v3407
  %v3409 = fmul double %v3408, 1.000000e-13
  %v3410 = load double, ptr %v134, align 8, !noalias !473
  %v3411 = tail call double @llvm.fabs.f64(double %v3410)
  %v3412 = fmul double %v3411, 4.000000e-15
  %v3413 = fcmp ogt double %v3412, %v3409
  %v3414 = select i1 %v3413, double %v3412, double %v3409
  %v3415 = fadd double %v3410, %v3414
  store double %v3415, ptr %v948, align 8, !noalias !483
  %v3416 = load i64, ptr %v6, align 8, !noalias !484
  %v3417 = inttoptr i64 %v3416 to ptr
  tail call void %v3417(ptr nonnull %v134, ptr %v936, ptr %v166, ptr %v173, ptr %v180, ptr %v950), !noalias !484
  br i1 %v943, label %v3418, label %v3419

v3418:
  %v3420 = load i64, ptr %v955, align 8, !noalias !487
  %v3421 = inttoptr i64 %v3420 to ptr
  tail call void %v3421(ptr nonnull %v134, ptr %v957, ptr %v166, ptr %v173, ptr %v180, ptr %v959), !noalias !487
  %v3422 = load i64, ptr %v955, align 8, !noalias !490
  %v3423 = inttoptr i64 %v3422 to ptr
  tail call void %v3423(ptr nonnull %v948, ptr %v961, ptr %v166, ptr %v173, ptr %v180, ptr %v963), !noalias !490
  br label %v3424

v3424:
  %v3425 = phi i64 [ %v19, %v3418 ], [ %v3426, %v3427 ]
  %v3428 = phi i64 [ %v965, %v3418 ], [ %v3429, %v3427 ]
  %v3430 = icmp sgt i64 %v3428, 0
  br i1 %v3430, label %v3427, label %v3431

v3427:
  %v3429 = add nsw i64 %v3428, -1
  %v3426 = add i64 %v3425, 1
  %v3432 = icmp slt i64 %v3425, 0
  %v3433 = select i1 %v3432, i64 %v208, i64 0
  %v3434 = add i64 %v3433, %v3425
  %v3435 = getelementptr double, ptr %v969, i64 %v3434
  %v3436 = load double, ptr %v3435, align 8, !noalias !483
  %v3437 = getelementptr double, ptr %v972, i64 %v3434
  %v3438 = load double, ptr %v3437, align 8, !noalias !483
  %v3439 = fsub double %v3436, %v3438
  %v3440 = tail call double @llvm.fabs.f64(double %v3439)
  %v3441 = getelementptr double, ptr %v974, i64 %v3434
  %v3442 = load double, ptr %v3441, align 8, !noalias !483
  %v3443 = tail call i1 @llvm.is.fpclass.f64(double %v3442, i32 543)
  %v3444 = select i1 %v3443, double 0.000000e+00, double %v3442
  %v3445 = fcmp ueq double %v3440, 0x7FF0000000000000
  %v3446 = select i1 %v3445, double -0.000000e+00, double %v3440
  %v3447 = fadd double %v3444, %v3446
  %v3448 = getelementptr double, ptr %v971, i64 %v3434
  %v3449 = load double, ptr %v3448, align 8, !noalias !483
  %v3450 = fneg double %v3447
  %v3451 = fcmp olt double %v3449, %v3450
  br i1 %v3451, label %v3431, label %v3424

v3419:
  %v3452 = phi i64 [ %v3453, %v3419 ], [ 0, %v3405 ]
  %v3453 = add nsw i64 %v3452, 1
  %v3454 = mul i64 %v3452, %v197
  %v3455 = getelementptr double, ptr %v944, i64 %v3454
  %v3456 = load double, ptr %v3455, align 8, !noalias !483
  %v3457 = getelementptr double, ptr %v952, i64 %v3454
  %v3458 = load double, ptr %v3457, align 8, !noalias !483
  %v3459 = fmul double %v3414, %v3458
  %v3460 = fadd double %v3456, %v3459
  %v3461 = getelementptr double, ptr %v954, i64 %v3454
  store double %v3460, ptr %v3461, align 8, !noalias !483
  %v3462 = icmp eq i64 %v10, %v3453
  br i1 %v3462, label %v3418, label %v3419

v3463:
  %v3464 = getelementptr i64, ptr %v976, i64 %v3339
  store i64 %v3465, ptr %v3464, align 8, !noalias !493
  %v3466 = load i64, ptr %v3340, align 8, !noalias !494
  %v3467 = icmp sgt i64 %v3466, -1
  br i1 %v3467, label %v3468, label %v3469

v3468:
  %v3470 = getelementptr i64, ptr %v111, i64 %v3466
  %v3471 = load i64, ptr %v3470, align 8, !noalias !494
  %v3472 = icmp eq i64 %v3471, 0
  br i1 %v3472, label %v3473, label %v3469

v3473:
  store i64 4, ptr %v3470, align 8, !noalias !494
  br label %v3469

v3469:
  %v3474 = load double, ptr %v3354, align 8, !noalias !493
  store double %v3474, ptr %v3356, align 8, !noalias !493
  %v3475 = getelementptr double, ptr %v978, i64 %v3349
  store double 0.000000e+00, ptr %v3475, align 8, !noalias !493
  br label %v3332

v3431:
  %v3465 = phi i64 [ %v3425, %v3427 ], [ -1, %v3424 ]
  %v3476 = icmp sgt i64 %v3465, -1
  br i1 %v3476, label %v3463, label %v3332

v3386:
  %v3477 = phi double [ 0.000000e+00, %v3374 ], [ %v3396, %v3391 ]
  %v3389 = phi i64 [ 0, %v3374 ], [ %v3393, %v3391 ]
  %v3393 = add nsw i64 %v3389, 1
  %v3478 = mul i64 %v3389, %v197
  %v3479 = getelementptr double, ptr %v3378, i64 %v3478
  %v3390 = load double, ptr %v3479, align 8, !noalias !466
  %v3480 = fmul double %v3390, 0.000000e+00
  %v3396 = fadd double %v3477, %v3480
  %v3481 = getelementptr double, ptr %v3379, i64 %v3478
  store double %v3390, ptr %v3481, align 8, !noalias !466
  br i1 %v3372, label %v3387, label %v3391

v3332:
  %v3482 = icmp sgt i64 %v3333, 0
  %v3483 = zext i1 %v3482 to i64
  %v3336 = add i64 %v3335, %v3483
  %v3484 = sext i1 %v3482 to i64
  %v3334 = add nsw i64 %v3333, %v3484
  %v3331 = select i1 %v3482, i64 %v3335, i64 0
  br i1 %v3482, label %v3329, label %v3274

v3275:
  %v3296 = phi i1 [ %v3320, %v3282 ], [ false, %v3192 ]
  %v3284 = phi i64 [ %v3322, %v3282 ], [ 0, %v3192 ]
  %v3322 = add nsw i64 %v3284, 1
  %v3485 = getelementptr i64, ptr %v143, i64 %v3284
  %v3278 = load i64, ptr %v3485, align 8, !noalias !450
  %v3486 = icmp slt i64 %v3278, 0
  br i1 %v3486, label %v3282, label %v3276

v3274:
  %v3487 = xor i1 %v1308, true
  %v3488 = or i1 %v308, %v3487
  %v3489 = select i1 %v1308, i64 0, i64 %v1078
  br i1 %v3488, label %v1077, label %v3490

v3491:
  %v3492 = mul i64 %v3493, %v127
  %v3494 = getelementptr i64, ptr %v125, i64 %v3492
  %v3495 = load i64, ptr %v3494, align 8, !noalias !497
  %v3496 = getelementptr i8, ptr %v3494, i64 24
  %v3497 = load i64, ptr %v3496, align 8, !noalias !497
  %v3498 = add i64 %v3495, %v3497
  %v3499 = sub i64 %v299, %v3498
  %v3500 = icmp slt i64 %v3499, 1
  br i1 %v3500, label %v3501, label %v3502

v3501:
  %v3503 = getelementptr i64, ptr %v111, i64 %v3493
  %v3504 = load i64, ptr %v3503, align 8, !noalias !501
  %v3505 = icmp eq i64 %v3504, 0
  br i1 %v3505, label %v3506, label %v3502

v3506:
  store i64 5, ptr %v3503, align 8, !noalias !501
  br label %v3502

v3502:
  %v3507 = getelementptr double, ptr %v980, i64 %v3508
  %v3509 = load double, ptr %v3507, align 8, !noalias !497
  %v3510 = fcmp ogt double %v3509, 5.000000e-01
  br i1 %v3510, label %v3511, label %v3512

v3511:
  %v3513 = getelementptr double, ptr %v134, i64 %v3508
  %v3514 = load double, ptr %v3513, align 8, !noalias !497
  %v3515 = getelementptr double, ptr %v982, i64 %v3508
  %v3516 = load double, ptr %v3515, align 8, !noalias !497
  %v3517 = fcmp oeq double %v3514, %v3516
  br i1 %v3517, label %v3518, label %v3512

v3518:
  %v3519 = getelementptr i64, ptr %v983, i64 %v3508
  %v3520 = load i64, ptr %v3519, align 8, !noalias !504
  %v3521 = add nsw i64 %v3520, 1
  store i64 %v3521, ptr %v3519, align 8, !noalias !504
  %v3522 = icmp slt i64 %v3520, -1
  %v3523 = select i1 %v3522, i64 %v71, i64 0
  %v3524 = getelementptr double, ptr %v70, i64 %v3521
  %v3525 = getelementptr double, ptr %v3524, i64 %v3523
  %v3526 = load double, ptr %v3525, align 8, !noalias !504
  %v3527 = fcmp oeq double %v3526, 0x7FF0000000000000
  br i1 %v3527, label %v3528, label %v3529

v3528:
  %v3530 = load i64, ptr %v3531, align 8, !noalias !504
  %v3532 = icmp slt i64 %v3530, 0
  %v3533 = select i1 %v3532, i64 %v112, i64 0
  %v3534 = getelementptr i64, ptr %v111, i64 %v3530
  %v3535 = getelementptr i64, ptr %v3534, i64 %v3533
  %v3536 = load i64, ptr %v3535, align 8, !noalias !504
  %v3537 = icmp eq i64 %v3536, 0
  br i1 %v3537, label %v3538, label %v3512

v3538:
  store i64 1, ptr %v3535, align 8, !noalias !504
  br label %v3512

v3529:
  store double %v3526, ptr %v3515, align 8, !noalias !504
  %v3539 = select i1 %v3522, i64 %v87, i64 0
  %v3540 = getelementptr i64, ptr %v86, i64 %v3521
  %v3541 = getelementptr i64, ptr %v3540, i64 %v3539
  %v3542 = load i64, ptr %v3541, align 8, !noalias !504
  %v3543 = icmp eq i64 %v3542, 0
  br i1 %v3543, label %v3544, label %v3545

v3544:
  %v3546 = getelementptr double, ptr %v987, i64 %v3508
  store double 1.000000e+00, ptr %v3546, align 8, !noalias !504
  br label %v3547

v3545:
  %v3548 = getelementptr double, ptr %v985, i64 %v3508
  %v3549 = load double, ptr %v3548, align 8, !noalias !504
  %v3550 = fcmp olt double %v3549, 2.500000e-01
  %v3551 = select i1 %v3550, double 2.500000e-01, double %v3549
  store double %v3551, ptr %v3548, align 8, !noalias !504
  %v3552 = load i64, ptr %v497, align 8, !noalias !504
  %v3553 = tail call i64 @llvm.smax.i64(i64 %v3552, i64 1)
  br label %v3547

v3547:
  %v3554 = phi i64 [ %v3553, %v3545 ], [ 2, %v3544 ]
  store i64 %v3554, ptr %v497, align 8, !noalias !504
  br i1 %v988, label %v3512, label %v3555

v3555:
  %v3556 = select i1 %v3522, i64 %v78, i64 0
  %v3557 = add i64 %v3556, %v3521
  %v3558 = mul i64 %v3557, %v79
  %v3559 = getelementptr double, ptr %v77, i64 %v3558
  br label %v3560

v3560:
  %v3561 = phi i64 [ 0, %v3555 ], [ %v3562, %v3560 ]
  %v3562 = add nsw i64 %v3561, 1
  %v3563 = getelementptr double, ptr %v3559, i64 %v3561
  %v3564 = load double, ptr %v3563, align 8, !noalias !508
  %v3565 = getelementptr i64, ptr %v63, i64 %v3561
  %v3566 = load i64, ptr %v3565, align 8, !noalias !508
  %v3567 = mul nsw i64 %v3566, %v9
  %v3568 = add nsw i64 %v3567, %v3508
  %v3569 = icmp slt i64 %v3568, 0
  %v3570 = select i1 %v3569, i64 %v167, i64 0
  %v3571 = getelementptr double, ptr %v166, i64 %v3568
  %v3572 = getelementptr double, ptr %v3571, i64 %v3570
  store double %v3564, ptr %v3572, align 8, !noalias !508
  %v3573 = icmp eq i64 %v64, %v3562
  br i1 %v3573, label %v3512, label %v3560

v3512:
  %v3574 = getelementptr i64, ptr %v111, i64 %v3493
  %v3575 = load i64, ptr %v3574, align 8, !noalias !497
  %v3576 = icmp eq i64 %v3575, 0
  br i1 %v3576, label %v3577, label %v3578

v3578:
  %v3579 = getelementptr i64, ptr %v990, i64 %v3508
  %v3580 = load i64, ptr %v3579, align 8, !noalias !497
  %v3581 = getelementptr i64, ptr %v118, i64 %v3493
  store i64 %v3580, ptr %v3581, align 8, !noalias !497
  store i64 -1, ptr %v3531, align 8, !noalias !497
  %v3582 = getelementptr double, ptr %v992, i64 %v3508
  store double 0.000000e+00, ptr %v3582, align 8, !noalias !512
  %v3583 = load i64, ptr %v152, align 8, !noalias !512
  %v3584 = load i64, ptr %v993, align 8, !noalias !512
  %v3585 = icmp eq i64 %v3583, %v3584
  br i1 %v3585, label %v3586, label %v3587

v3587:
  %v3588 = add nsw i64 %v3583, 1
  store i64 %v3588, ptr %v152, align 8, !noalias !512
  store i64 2, ptr %v497, align 8, !noalias !512
  store i64 %v3583, ptr %v3531, align 8, !noalias !512
  %v3589 = icmp slt i64 %v3583, 0
  %v3590 = select i1 %v3589, i64 %v50, i64 0
  %v3591 = getelementptr i64, ptr %v49, i64 %v3583
  %v3592 = getelementptr i64, ptr %v3591, i64 %v3590
  %v3593 = load i64, ptr %v3592, align 8, !noalias !512
  %v3594 = icmp slt i64 %v3593, 0
  %v3595 = select i1 %v3594, i64 %v57, i64 0
  %v3596 = getelementptr i64, ptr %v56, i64 %v3593
  %v3597 = getelementptr i64, ptr %v3596, i64 %v3595
  %v3598 = load i64, ptr %v3597, align 8, !noalias !512
  %v3599 = getelementptr i64, ptr %v994, i64 %v3508
  store i64 %v3598, ptr %v3599, align 8, !noalias !512
  store i64 1, ptr %v3579, align 8, !noalias !512
  %v3600 = getelementptr i64, ptr %v996, i64 %v3508
  store i64 0, ptr %v3600, align 8, !noalias !512
  br i1 %v997, label %v3601, label %v3602

v3602:
  %v3603 = select i1 %v3589, i64 %v41, i64 0
  %v3604 = add i64 %v3603, %v3583
  %v3605 = mul i64 %v3604, %v42
  %v3606 = getelementptr double, ptr %v40, i64 %v3605
  %v3607 = getelementptr double, ptr %v166, i64 %v3508
  br label %v3608

v3601:
  br i1 %v998, label %v3609, label %v3610

v3610:
  %v3611 = load i64, ptr %v3599, align 8, !noalias !512
  %v3612 = icmp slt i64 %v3611, 0
  %v3613 = select i1 %v3612, i64 %v78, i64 0
  %v3614 = add i64 %v3613, %v3611
  %v3615 = mul i64 %v3614, %v79
  %v3616 = getelementptr double, ptr %v77, i64 %v3615
  br label %v3617

v3617:
  %v3618 = phi i64 [ 0, %v3610 ], [ %v3619, %v3617 ]
  %v3619 = add nsw i64 %v3618, 1
  %v3620 = getelementptr double, ptr %v3616, i64 %v3618
  %v3621 = load double, ptr %v3620, align 8, !noalias !515
  %v3622 = getelementptr i64, ptr %v63, i64 %v3618
  %v3623 = load i64, ptr %v3622, align 8, !noalias !515
  %v3624 = mul nsw i64 %v3623, %v9
  %v3625 = add nsw i64 %v3624, %v3508
  %v3626 = icmp slt i64 %v3625, 0
  %v3627 = select i1 %v3626, i64 %v167, i64 0
  %v3628 = getelementptr double, ptr %v166, i64 %v3625
  %v3629 = getelementptr double, ptr %v3628, i64 %v3627
  store double %v3621, ptr %v3629, align 8, !noalias !515
  %v3630 = icmp eq i64 %v3619, %v64
  br i1 %v3630, label %v3609, label %v3617

v3631:
  %v3632 = getelementptr double, ptr %v134, i64 %v3508
  %v3633 = getelementptr double, ptr %v1001, i64 %v3508
  %v3634 = load double, ptr %v3633, align 8, !noalias !519
  %v3635 = getelementptr double, ptr %v1003, i64 %v3508
  %v3636 = load double, ptr %v3635, align 8, !noalias !519
  %v3637 = getelementptr double, ptr %v1005, i64 %v3508
  %v3638 = load double, ptr %v3637, align 8, !noalias !519
  store double 0.000000e+00, ptr %v3632, align 8, !noalias !519
  %v3639 = getelementptr double, ptr %v3632, i64 %v136
  store double 0.000000e+00, ptr %v3639, align 8, !noalias !519
  %v3640 = getelementptr i8, ptr %v3632, i64 %v1006
  store double 0.000000e+00, ptr %v3640, align 8, !noalias !519
  %v3641 = getelementptr i8, ptr %v3632, i64 %v991
  store double 0.000000e+00, ptr %v3641, align 8, !noalias !519
  %v3642 = getelementptr i8, ptr %v3632, i64 %v1007
  store double 0.000000e+00, ptr %v3642, align 8, !noalias !519
  %v3643 = getelementptr i8, ptr %v3632, i64 %v979
  store double 0.000000e+00, ptr %v3643, align 8, !noalias !519
  %v3644 = getelementptr i8, ptr %v3632, i64 %v1008
  store double 0.000000e+00, ptr %v3644, align 8, !noalias !519
  %v3645 = getelementptr i8, ptr %v3632, i64 %v1009
  store double 0.000000e+00, ptr %v3645, align 8, !noalias !519
  %v3646 = getelementptr i8, ptr %v3632, i64 %v1010
  store double 0.000000e+00, ptr %v3646, align 8, !noalias !519
  %v3647 = getelementptr i8, ptr %v3632, i64 %v1011
  store double 0.000000e+00, ptr %v3647, align 8, !noalias !519
  %v3648 = getelementptr i8, ptr %v3632, i64 %v1012
  store double 0.000000e+00, ptr %v3648, align 8, !noalias !519
  %v3649 = getelementptr i8, ptr %v3632, i64 %v1013
  store double 0.000000e+00, ptr %v3649, align 8, !noalias !519
  %v3650 = getelementptr i8, ptr %v3632, i64 %v1014
  store double 0.000000e+00, ptr %v3650, align 8, !noalias !519
  %v3651 = getelementptr i8, ptr %v3632, i64 %v1015
  store double 0.000000e+00, ptr %v3651, align 8, !noalias !519
  %v3652 = getelementptr i8, ptr %v3632, i64 %v1016
  store double 0.000000e+00, ptr %v3652, align 8, !noalias !519
  %v3653 = getelementptr i8, ptr %v3632, i64 %v1017
  store double 0.000000e+00, ptr %v3653, align 8, !noalias !519
  %v3654 = getelementptr i8, ptr %v3632, i64 %v1018
  store double 0.000000e+00, ptr %v3654, align 8, !noalias !519
  %v3655 = getelementptr i8, ptr %v3632, i64 %v1019
  store double 0.000000e+00, ptr %v3655, align 8, !noalias !519
  %v3656 = getelementptr i8, ptr %v3632, i64 %v1000
  store double 0.000000e+00, ptr %v3656, align 8, !noalias !519
  %v3657 = getelementptr i8, ptr %v3632, i64 %v1020
  store double 0.000000e+00, ptr %v3657, align 8, !noalias !519
  %v3658 = getelementptr i8, ptr %v3632, i64 %v1021
  store double 0.000000e+00, ptr %v3658, align 8, !noalias !519
  %v3659 = getelementptr i8, ptr %v3632, i64 %v1022
  store double 0.000000e+00, ptr %v3659, align 8, !noalias !519
  %v3660 = getelementptr i8, ptr %v3632, i64 %v1023
  store double 0.000000e+00, ptr %v3660, align 8, !noalias !519
  %v3661 = getelementptr i8, ptr %v3632, i64 %v1024
  store double 0.000000e+00, ptr %v3661, align 8, !noalias !519
  %v3662 = getelementptr i8, ptr %v3632, i64 %v1025
  store double 0.000000e+00, ptr %v3662, align 8, !noalias !519
  %v3663 = getelementptr i8, ptr %v3632, i64 %v1026
  store double 0.000000e+00, ptr %v3663, align 8, !noalias !519
  %v3664 = getelementptr i8, ptr %v3632, i64 %v1027
  store double 0.000000e+00, ptr %v3664, align 8, !noalias !519
  %v3665 = getelementptr i8, ptr %v3632, i64 %v1028
  store double 0.000000e+00, ptr %v3665, align 8, !noalias !519
  %v3666 = getelementptr i8, ptr %v3632, i64 %v1029
  store double 0.000000e+00, ptr %v3666, align 8, !noalias !519
  %v3667 = getelementptr i8, ptr %v3632, i64 %v1004
  store double 0.000000e+00, ptr %v3667, align 8, !noalias !519
  %v3668 = getelementptr i8, ptr %v3632, i64 %v1002
  store double 0.000000e+00, ptr %v3668, align 8, !noalias !519
  %v3669 = fcmp oeq double %v3638, 0xFFF0000000000000
  %v3670 = select i1 %v3669, double 0xFFF0000000000000, double 0.000000e+00
  store double %v3670, ptr %v3637, align 8, !noalias !519
  store double %v3636, ptr %v3635, align 8, !noalias !519
  store double %v3634, ptr %v3633, align 8, !noalias !519
  store double 1.000000e+00, ptr %v3582, align 8, !noalias !519
  %v3671 = getelementptr double, ptr %v1030, i64 %v3508
  store double 0xFFF0000000000000, ptr %v3671, align 8, !noalias !519
  %v3672 = getelementptr double, ptr %v1031, i64 %v3508
  store double 0x7FF0000000000000, ptr %v3672, align 8, !noalias !519
  %v3673 = load double, ptr %v93, align 8, !noalias !512
  store double %v3673, ptr %v3632, align 8, !noalias !512
  %v3674 = load i64, ptr %v3599, align 8, !noalias !512
  %v3675 = icmp slt i64 %v3674, 0
  %v3676 = select i1 %v3675, i64 %v71, i64 0
  %v3677 = getelementptr double, ptr %v70, i64 %v3674
  %v3678 = getelementptr double, ptr %v3677, i64 %v3676
  %v3679 = load double, ptr %v3678, align 8, !noalias !512
  %v3680 = getelementptr double, ptr %v1032, i64 %v3508
  store double %v3679, ptr %v3680, align 8, !noalias !512
  br label %v3586

v3608:
  %v3681 = phi i64 [ 0, %v3602 ], [ %v3682, %v3608 ]
  %v3682 = add nsw i64 %v3681, 1
  %v3683 = getelementptr double, ptr %v3606, i64 %v3681
  %v3684 = load double, ptr %v3683, align 8, !noalias !512
  %v3685 = mul nsw i64 %v3681, %v9
  %v3686 = getelementptr double, ptr %v3607, i64 %v3685
  store double %v3684, ptr %v3686, align 8, !noalias !512
  %v3687 = icmp eq i64 %v3682, %v42
  br i1 %v3687, label %v3601, label %v3608

v3609:
  br i1 %v999, label %v3631, label %v3688

v3688:
  %v3689 = getelementptr double, ptr %v194, i64 %v3508
  %v3690 = select i1 %v3589, i64 %v32, i64 0
  %v3691 = add i64 %v3690, %v3583
  %v3692 = mul i64 %v3691, %v33
  %v3693 = getelementptr double, ptr %v31, i64 %v3692
  br label %v3694

v3694:
  %v3695 = phi i64 [ 0, %v3688 ], [ %v3696, %v3694 ]
  %v3696 = add nsw i64 %v3695, 1
  %v3697 = getelementptr double, ptr %v3693, i64 %v3695
  %v3698 = load double, ptr %v3697, align 8, !noalias !512
  %v3699 = mul i64 %v3695, %v197
  %v3700 = getelementptr double, ptr %v3689, i64 %v3699
  store double %v3698, ptr %v3700, align 8, !noalias !512
  %v3701 = icmp eq i64 %v3696, %v10
  br i1 %v3701, label %v3631, label %v3694

v3577:
  %v3702 = getelementptr double, ptr %v1034, i64 %v3508
  %v3703 = load double, ptr %v3702, align 8, !noalias !497
  %v3704 = fcmp ult double %v3703, 1.500000e+01
  br i1 %v3704, label %v3586, label %v3705

v3705:
  %v3706 = load double, ptr %v1036, align 8, !noalias !497
  %v3707 = getelementptr double, ptr %v134, i64 %v3508
  %v3708 = load double, ptr %v3707, align 8, !noalias !497
  %v3709 = fsub double %v3706, %v3708
  %v3710 = getelementptr double, ptr %v1037, i64 %v3508
  %v3711 = load double, ptr %v3710, align 8, !noalias !497
  %v3712 = fmul double %v3711, 2.500000e+02
  %v3713 = fcmp ogt double %v3709, %v3712
  br i1 %v3713, label %v3586, label %v3714

v3714:
  store double 0.000000e+00, ptr %v3702, align 8, !noalias !497
  br label %v3586

v3586:
  %v3715 = phi i1 [ %v3716, %v3577 ], [ true, %v3705 ], [ %v3716, %v3714 ], [ %v3716, %v3578 ], [ %v3716, %v3631 ]
  %v3717 = load i64, ptr %v3531, align 8, !noalias !497
  %v3718 = icmp sgt i64 %v3717, -1
  br i1 %v3718, label %v3719, label %v3720

v3719:
  %v3721 = add nsw i64 %v3722, 1
  %v3723 = getelementptr double, ptr %v1039, i64 %v3508
  %v3724 = load double, ptr %v3723, align 8, !noalias !497
  %v3725 = fcmp ogt double %v3724, 0.000000e+00
  br i1 %v3725, label %v3726, label %v3727

v3727:
  %v3728 = mul i64 %v3717, %v127
  %v3729 = getelementptr i64, ptr %v125, i64 %v3728
  %v3730 = load i64, ptr %v3729, align 8, !noalias !497
  %v3731 = and i64 %v3730, 127
  %v3732 = sub nsw i64 128, %v3731
  %v3733 = tail call i64 @llvm.smin.i64(i64 %v3732, i64 %v3499)
  %v3734 = sitofp i64 %v3733 to double
  br label %v3726

v3726:
  %v3735 = phi double [ %v3734, %v3727 ], [ 1.000000e+00, %v3719 ]
  %v3736 = getelementptr double, ptr %v1041, i64 %v3508
  store double %v3735, ptr %v3736, align 8, !noalias !497
  %v3737 = getelementptr double, ptr %v1043, i64 %v3508
  %v3738 = load double, ptr %v3737, align 8, !noalias !523
  %v3739 = getelementptr double, ptr %v1045, i64 %v3508
  store double %v3738, ptr %v3739, align 8, !noalias !523
  %v3740 = getelementptr i64, ptr %v1047, i64 %v3508
  %v3741 = load i64, ptr %v3740, align 8, !noalias !523
  %v3742 = icmp slt i64 %v3741, %v94
  br i1 %v3742, label %v3743, label %v3720

v3743:
  %v3744 = icmp slt i64 %v3741, 0
  %v3745 = select i1 %v3744, i64 %v94, i64 0
  %v3746 = getelementptr double, ptr %v93, i64 %v3741
  %v3747 = getelementptr double, ptr %v3746, i64 %v3745
  %v3748 = load double, ptr %v3747, align 8, !noalias !523
  %v3749 = load double, ptr %v3737, align 8, !noalias !523
  %v3750 = fcmp olt double %v3749, %v3748
  %v3751 = select i1 %v3750, double %v3749, double %v3748
  store double %v3751, ptr %v3739, align 8, !noalias !523
  br label %v3720

v3720:
  %v3752 = phi i64 [ %v3722, %v3490 ], [ %v3722, %v3586 ], [ %v3721, %v3726 ], [ %v3721, %v3743 ]
  %v3753 = phi i1 [ %v3716, %v3490 ], [ %v3715, %v3586 ], [ %v3715, %v3726 ], [ %v3715, %v3743 ]
  %v3754 = icmp sgt i64 %v3755, 1
  br i1 %v3754, label %v3490, label %v3756

v3490:
  %v3716 = phi i1 [ %v3753, %v3720 ], [ false, %v3274 ]
  %v3722 = phi i64 [ %v3752, %v3720 ], [ 0, %v3274 ]
  %v3508 = phi i64 [ %v3757, %v3720 ], [ 0, %v3274 ]
  %v3755 = phi i64 [ %v3758, %v3720 ], [ %v309, %v3274 ]
  %v3758 = add nsw i64 %v3755, -1
  %v3757 = add nsw i64 %v3508, 1
  %v3531 = getelementptr i64, ptr %v143, i64 %v3508
  %v3493 = load i64, ptr %v3531, align 8, !noalias !497
  %v3759 = icmp slt i64 %v3493, 0
  br i1 %v3759, label %v3720, label %v3491

v1077:
  %v1076 = phi i64 [ %v1080, %v3274 ], [ %v3760, %v3756 ]
  %v1079 = phi i64 [ %v3489, %v3274 ], [ %v3752, %v3756 ]
  %v3761 = icmp sgt i64 %v1079, 0
  %v3762 = icmp sgt i64 %v1076, 0
  %v3763 = select i1 %v3761, i1 %v3762, i1 false
  br i1 %v3763, label %v1074, label %v496

v496:
  %v3764 = phi i64 [ %v491, %v310 ], [ %v1079, %v1077 ]
  br i1 %v308, label %v3765, label %v3766

v3766:
  %v3767 = mul i64 %v136, 192
  %v3768 = getelementptr i8, ptr %v134, i64 %v3767
  %v3769 = mul i64 %v136, 200
  %v3770 = getelementptr i8, ptr %v134, i64 %v3769
  %v3771 = add nsw i64 %v11, -1
  %v3772 = mul i64 %v136, 176
  %v3773 = getelementptr i8, ptr %v134, i64 %v3772
  br label %v3774

v3775:
  %v3776 = getelementptr double, ptr %v3768, i64 %v3777
  %v3778 = load double, ptr %v3776, align 8, !noalias !527
  %v3779 = fptosi double %v3778 to i64
  %v3780 = getelementptr double, ptr %v3770, i64 %v3777
  %v3781 = load double, ptr %v3780, align 8, !noalias !527
  %v3782 = fptosi double %v3781 to i64
  %v3783 = mul i64 %v3784, %v127
  %v3785 = getelementptr i64, ptr %v125, i64 %v3783
  %v3786 = load i64, ptr %v3785, align 8, !noalias !527
  %v3787 = add nsw i64 %v3786, %v3779
  store i64 %v3787, ptr %v3785, align 8, !noalias !527
  %v3788 = getelementptr i8, ptr %v3785, i64 24
  %v3789 = load i64, ptr %v3788, align 8, !noalias !527
  %v3790 = add nsw i64 %v3789, %v3782
  store i64 %v3790, ptr %v3788, align 8, !noalias !527
  %v3791 = getelementptr i8, ptr %v3785, i64 8
  %v3792 = load i64, ptr %v3791, align 8, !noalias !527
  %v3793 = add nsw i64 %v3782, %v3779
  %v3794 = mul nsw i64 %v3793, %v3771
  %v3795 = add nsw i64 %v3794, %v3779
  %v3796 = add nsw i64 %v3795, %v3792
  store i64 %v3796, ptr %v3791, align 8, !noalias !527
  store double 0.000000e+00, ptr %v3776, align 8, !noalias !527
  store double 0.000000e+00, ptr %v3780, align 8, !noalias !527
  %v3797 = getelementptr double, ptr %v3773, i64 %v3777
  %v3798 = load double, ptr %v3797, align 8, !noalias !527
  %v3799 = sitofp i64 %v3793 to double
  %v3800 = fsub double %v3798, %v3799
  store double %v3800, ptr %v3797, align 8, !noalias !527
  br label %v3801

v3801:
  %v3802 = icmp sgt i64 %v3803, 1
  br i1 %v3802, label %v3774, label %v3765

v3774:
  %v3777 = phi i64 [ 0, %v3766 ], [ %v3804, %v3801 ]
  %v3803 = phi i64 [ %v309, %v3766 ], [ %v3805, %v3801 ]
  %v3805 = add nsw i64 %v3803, -1
  %v3804 = add nsw i64 %v3777, 1
  %v3806 = getelementptr i64, ptr %v143, i64 %v3777
  %v3784 = load i64, ptr %v3806, align 8, !noalias !527
  %v3807 = icmp sgt i64 %v3784, -1
  br i1 %v3807, label %v3775, label %v3801

v3808:
  %v3809 = phi i32 [ 0, %v3765 ], [ %v3059, %v3061 ]
  ret i32 %v3809

v358:
  %v488 = phi i64 [ 0, %v311 ], [ %v487, %v365 ]
  %v490 = phi i64 [ %v309, %v311 ], [ %v3810, %v365 ]
  %v361 = phi i64 [ 0, %v311 ], [ %v3811, %v365 ]
  %v3810 = add nsw i64 %v490, -1
  %v3811 = add nsw i64 %v361, 1
  %v484 = getelementptr i64, ptr %v143, i64 %v361
  %v3812 = load i64, ptr %v484, align 8
  %v3813 = icmp slt i64 %v3812, 0
  br i1 %v3813, label %v359, label %v365

v1286:
  %v3814 = load i64, ptr %v6, align 8, !noalias !531
  %v3815 = inttoptr i64 %v3814 to ptr
  tail call void %v3815(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v580), !noalias !531
  br label %v1287

v1287:
  br i1 %v581, label %v3816, label %v3817

v3816:
  %v3818 = load double, ptr %v583, align 8, !noalias !534
  %v3819 = fcmp olt double %v3818, 5.000000e-01
  br i1 %v3819, label %v3820, label %v3821

v3820:
  br i1 %v584, label %v3822, label %v3823

v3822:
  br i1 %v596, label %v3824, label %v3825, !prof !397

v3826:
  %v3827 = icmp eq i64 %v3828, %v629
  br i1 %v3827, label %v3821, label %v3829

v3830:
  %v3831 = load i64, ptr %v606, align 8, !noalias !538
  %v3832 = icmp eq i64 %v3831, %v3828
  br i1 %v3832, label %v3833, label %v3834

v3833:
  %v3835 = load double, ptr %v608, align 8, !noalias !538
  %v3836 = fmul double %v3835, 1.000000e-03
  br label %v3834

v3834:
  %v3837 = phi double [ %v3836, %v3833 ], [ 0.000000e+00, %v3830 ]
  store double %v3837, ptr %v3838, align 8, !noalias !538
  br i1 %v584, label %v3839, label %v3840

v3841:
  %v3842 = phi i64 [ %v3843, %v3841 ], [ 0, %v3829 ]
  %v3843 = add nsw i64 %v3842, 1
  %v3844 = mul i64 %v3842, %v197
  %v3845 = getelementptr double, ptr %v194, i64 %v3844
  %v3846 = load double, ptr %v3845, align 8, !noalias !538
  %v3847 = tail call double @llvm.fabs.f64(double %v3846)
  %v3848 = fcmp ogt double %v3849, %v3847
  %v3850 = select i1 %v3848, double %v3849, double %v3847
  %v3851 = fcmp ogt double %v3850, 0.000000e+00
  %v3852 = fmul double %v3850, 1.200000e-05
  %v3853 = select i1 %v3851, double %v3852, double 1.200000e-05
  %v3854 = getelementptr i64, ptr %v267, i64 %v3842
  %v3855 = load i64, ptr %v3854, align 8, !noalias !538
  %v3856 = icmp eq i64 %v3855, %v3828
  %v3857 = select i1 %v3856, double %v3853, double 0.000000e+00
  %v3858 = getelementptr double, ptr %v3859, i64 %v3842
  store double %v3857, ptr %v3858, align 8, !noalias !538
  %v3860 = icmp eq i64 %v10, %v3843
  br i1 %v3860, label %v3830, label %v3841

v3861:
  %v3862 = getelementptr double, ptr %v622, i64 %v3863
  store double %v3864, ptr %v3862, align 8, !noalias !544
  br label %v3865

v3866:
  %v3867 = select i1 %v3868, i64 %v296, i64 0
  %v3869 = getelementptr i64, ptr %v295, i64 %v3870
  %v3871 = getelementptr i64, ptr %v3869, i64 %v3867
  %v3872 = load i64, ptr %v3871, align 8, !noalias !544
  %v3873 = icmp slt i64 %v3872, 0
  %v3874 = select i1 %v3873, i64 %v224, i64 0
  %v3875 = getelementptr double, ptr %v223, i64 %v3872
  %v3876 = getelementptr double, ptr %v3875, i64 %v3874
  store double %v3864, ptr %v3876, align 8, !noalias !544
  br label %v3865

v3865:
  %v3877 = icmp sgt i64 %v3878, 1
  br i1 %v3877, label %v3879, label %v3826

v3823:
  %v3880 = phi i64 [ %v3881, %v3823 ], [ 0, %v3820 ]
  %v3881 = add nsw i64 %v3880, 1
  %v3882 = mul i64 %v3880, %v197
  %v3883 = getelementptr double, ptr %v194, i64 %v3882
  %v3884 = load double, ptr %v3883, align 8, !noalias !544
  %v3885 = getelementptr double, ptr %v587, i64 %v3882
  store double %v3884, ptr %v3885, align 8, !noalias !544
  %v3886 = getelementptr double, ptr %v589, i64 %v3882
  store double 0.000000e+00, ptr %v3886, align 8, !noalias !544
  %v3887 = icmp eq i64 %v10, %v3881
  br i1 %v3887, label %v3822, label %v3823

v3888:
  %v3889 = phi i64 [ %v160, %v3890 ], [ %v3891, %v3892 ]
  %v3893 = sub i64 %v3889, %v3894
  %v3895 = tail call i64 @llvm.smax.i64(i64 %v3893, i64 0)
  %v3859 = getelementptr double, ptr %v159, i64 %v3894
  br i1 %v601, label %v3896, label %v3821

v3896:
  %v3897 = select i1 %v593, i64 %v3895, i64 0
  %v3898 = getelementptr double, ptr %v3859, i64 %v10
  %v3838 = getelementptr double, ptr %v3898, i64 %v3897
  br label %v3829

v3824:
  br label %v3825

v3825:
  %v3899 = phi i64 [ 0, %v3824 ], [ %v595, %v3822 ]
  br i1 %v597, label %v3900, label %v3901, !prof !131

v3901:
  br label %v3900

v3900:
  %v3894 = phi i64 [ %v160, %v3901 ], [ %v3899, %v3825 ]
  br i1 %v599, label %v3902, label %v3892, !prof !397

v3902:
  br label %v3892

v3892:
  %v3891 = phi i64 [ 0, %v3902 ], [ %v598, %v3900 ]
  br i1 %v600, label %v3888, label %v3890, !prof !131

v3890:
  br label %v3888

v3829:
  %v3828 = phi i64 [ 0, %v3896 ], [ %v3903, %v3826 ]
  %v3903 = add nsw i64 %v3828, 1
  %v3904 = load double, ptr %v603, align 8, !noalias !538
  %v3905 = load double, ptr %v24, align 8, !noalias !538
  %v3849 = fdiv double %v3904, %v3905
  br i1 %v584, label %v3830, label %v3841

v3906:
  %v3907 = load double, ptr %v134, align 8, !noalias !545
  %v3908 = load double, ptr %v3838, align 8, !noalias !545
  %v3909 = fmul double %v3908, 5.000000e-01
  %v3910 = fadd double %v3907, %v3909
  store double %v3910, ptr %v611, align 8, !noalias !545
  %v3911 = load i64, ptr %v6, align 8, !noalias !549
  %v3912 = inttoptr i64 %v3911 to ptr
  tail call void %v3912(ptr nonnull %v611, ptr %v614, ptr %v166, ptr %v173, ptr %v180, ptr %v624), !noalias !549
  br label %v3913

v3913:
  %v3914 = phi i64 [ %v3915, %v3913 ], [ 0, %v3906 ]
  %v3915 = add nsw i64 %v3914, 1
  %v3916 = mul i64 %v3914, %v197
  %v3917 = getelementptr double, ptr %v194, i64 %v3916
  %v3918 = load double, ptr %v3917, align 8, !noalias !545
  %v3919 = getelementptr double, ptr %v3859, i64 %v3914
  %v3920 = load double, ptr %v3919, align 8, !noalias !545
  %v3921 = fmul double %v3920, 5.000000e-01
  %v3922 = fsub double %v3918, %v3921
  %v3923 = getelementptr double, ptr %v615, i64 %v3916
  store double %v3922, ptr %v3923, align 8, !noalias !545
  %v3924 = icmp eq i64 %v10, %v3915
  br i1 %v3924, label %v3925, label %v3913

v3839:
  %v3926 = load double, ptr %v134, align 8, !noalias !545
  %v3927 = fmul double %v3837, 5.000000e-01
  %v3928 = fadd double %v3927, %v3926
  store double %v3928, ptr %v611, align 8, !noalias !545
  %v3929 = load i64, ptr %v6, align 8, !noalias !549
  %v3930 = inttoptr i64 %v3929 to ptr
  tail call void %v3930(ptr nonnull %v611, ptr %v614, ptr %v166, ptr %v173, ptr %v180, ptr %v626), !noalias !549
  br label %v3925

v3925:
  %v3931 = load double, ptr %v134, align 8, !noalias !545
  %v3932 = load double, ptr %v3838, align 8, !noalias !545
  %v3933 = fmul double %v3932, 5.000000e-01
  %v3934 = fsub double %v3931, %v3933
  store double %v3934, ptr %v611, align 8, !noalias !545
  %v3935 = load i64, ptr %v6, align 8, !noalias !549
  %v3936 = inttoptr i64 %v3935 to ptr
  tail call void %v3936(ptr nonnull %v611, ptr %v614, ptr %v166, ptr %v173, ptr %v180, ptr %v628), !noalias !549
  br i1 %v584, label %v3937, label %v3938

v3939:
  %v3940 = fsub double %v3941, %v3942
  br label %v3943

v3944:
  %v3945 = getelementptr double, ptr %v620, i64 %v3946
  %v3947 = load double, ptr %v3945, align 8, !noalias !545
  %v3948 = fsub double %v3941, %v3947
  %v3949 = fmul double %v3948, 2.000000e+00
  br label %v3943

v3943:
  %v3950 = phi double [ %v3949, %v3944 ], [ %v3940, %v3939 ]
  store double %v3950, ptr %v3951, align 8, !noalias !545
  %v3952 = icmp eq i64 %v10, %v3953
  br i1 %v3952, label %v3937, label %v3938

v3840:
  %v3954 = phi i64 [ %v3955, %v3840 ], [ 0, %v3834 ]
  %v3955 = add nsw i64 %v3954, 1
  %v3956 = mul i64 %v3954, %v197
  %v3957 = getelementptr double, ptr %v194, i64 %v3956
  %v3958 = load double, ptr %v3957, align 8, !noalias !545
  %v3959 = getelementptr double, ptr %v3859, i64 %v3954
  %v3960 = load double, ptr %v3959, align 8, !noalias !545
  %v3961 = fmul double %v3960, 5.000000e-01
  %v3962 = fadd double %v3958, %v3961
  %v3963 = getelementptr double, ptr %v615, i64 %v3956
  store double %v3962, ptr %v3963, align 8, !noalias !545
  %v3964 = icmp eq i64 %v10, %v3955
  br i1 %v3964, label %v3906, label %v3840

v3938:
  %v3965 = phi i64 [ %v3953, %v3943 ], [ 0, %v3925 ]
  %v3953 = add nsw i64 %v3965, 1
  %v3946 = mul i64 %v3965, %v197
  %v3966 = getelementptr double, ptr %v194, i64 %v3946
  %v3967 = load double, ptr %v3966, align 8, !noalias !545
  %v3968 = getelementptr double, ptr %v615, i64 %v3946
  store double %v3967, ptr %v3968, align 8, !noalias !545
  %v3951 = getelementptr double, ptr %v617, i64 %v3946
  %v3941 = load double, ptr %v3951, align 8, !noalias !545
  %v3969 = getelementptr double, ptr %v619, i64 %v3946
  %v3942 = load double, ptr %v3969, align 8, !noalias !545
  %v3970 = fsub double %v3942, %v3942
  %v3971 = fcmp oeq double %v3970, 0.000000e+00
  br i1 %v3971, label %v3939, label %v3944

v3937:
  %v3972 = getelementptr i64, ptr %v274, i64 %v3828
  %v3973 = load i64, ptr %v3972, align 8, !noalias !544
  %v3974 = getelementptr i8, ptr %v3972, i64 8
  %v3975 = load i64, ptr %v3974, align 8, !noalias !544
  %v3976 = sub i64 %v3975, %v3973
  %v3977 = icmp slt i64 %v3976, 1
  br i1 %v3977, label %v3826, label %v3879

v3879:
  %v3878 = phi i64 [ %v3978, %v3865 ], [ %v3976, %v3937 ]
  %v3870 = phi i64 [ %v3979, %v3865 ], [ %v3973, %v3937 ]
  %v3978 = add nsw i64 %v3878, -1
  %v3979 = add i64 %v3870, 1
  %v3868 = icmp slt i64 %v3870, 0
  %v3980 = select i1 %v3868, i64 %v282, i64 0
  %v3981 = getelementptr i64, ptr %v281, i64 %v3870
  %v3982 = getelementptr i64, ptr %v3981, i64 %v3980
  %v3983 = load i64, ptr %v3982, align 8, !noalias !544
  %v3984 = select i1 %v3868, i64 %v289, i64 0
  %v3985 = getelementptr i64, ptr %v288, i64 %v3870
  %v3986 = getelementptr i64, ptr %v3985, i64 %v3984
  %v3987 = load i64, ptr %v3986, align 8, !noalias !544
  %v3988 = icmp slt i64 %v3983, 0
  %v3989 = select i1 %v3988, i64 %v196, i64 0
  %v3990 = add i64 %v3989, %v3983
  %v3863 = mul i64 %v3990, %v197
  %v3991 = getelementptr double, ptr %v617, i64 %v3863
  %v3992 = load double, ptr %v3991, align 8, !noalias !544
  %v3993 = icmp slt i64 %v3987, 0
  %v3994 = select i1 %v3993, i64 %v3895, i64 0
  %v3995 = getelementptr double, ptr %v3859, i64 %v3987
  %v3996 = getelementptr double, ptr %v3995, i64 %v3994
  %v3997 = load double, ptr %v3996, align 8, !noalias !544
  %v3998 = fdiv double %v3992, %v3997
  %v3999 = fsub double %v3998, %v3998
  %v4000 = fcmp oeq double %v3999, 0.000000e+00
  %v3864 = select i1 %v4000, double %v3998, double 0.000000e+00
  %v4001 = icmp eq i64 %v3987, %v10
  br i1 %v4001, label %v3861, label %v3866

v3821:
  br i1 %v630, label %v4002, label %v3817

v4003:
  %v4004 = mul i64 %v4005, %v633
  %v4006 = icmp slt i64 %v4004, 0
  %v4007 = select i1 %v4006, i64 %v231, i64 0
  %v4008 = getelementptr double, ptr %v230, i64 %v4004
  %v4009 = getelementptr double, ptr %v4008, i64 %v4007
  %v4010 = load double, ptr %v4009, align 8, !noalias !534
  %v4011 = load double, ptr %v635, align 8, !noalias !534
  %v4012 = fadd double %v4010, %v4011
  store double %v4012, ptr %v4009, align 8, !noalias !534
  %v4013 = icmp eq i64 %v10, %v4014
  br i1 %v4013, label %v4015, label %v4002

v4016:
  %v4017 = icmp eq i64 %v4018, %v10
  br i1 %v4017, label %v3817, label %v4015

v4019:
  %v4020 = phi i64 [ %v4021, %v4015 ], [ %v4022, %v4023 ]
  %v4024 = getelementptr i64, ptr %v237, i64 %v4021
  store i64 %v4020, ptr %v4024, align 8, !noalias !552
  %v4025 = add nsw i64 %v4020, %v4026
  %v4027 = icmp slt i64 %v4025, 0
  %v4028 = select i1 %v4027, i64 %v231, i64 0
  %v4029 = getelementptr double, ptr %v230, i64 %v4025
  %v4030 = getelementptr double, ptr %v4029, i64 %v4028
  %v4031 = load double, ptr %v4030, align 8, !noalias !552
  %v4032 = load double, ptr %v4033, align 8, !noalias !552
  store double %v4031, ptr %v4033, align 8, !noalias !552
  store double %v4032, ptr %v4030, align 8, !noalias !552
  br i1 %v4034, label %v4035, label %v4036

v4035:
  %v4037 = sub i64 %v4038, %v4018
  %v4039 = icmp slt i64 %v4037, 1
  br i1 %v4039, label %v4016, label %v4040

v4041:
  %v4042 = icmp sgt i64 %v4043, 1
  br i1 %v4042, label %v4040, label %v4016

v4015:
  %v4021 = phi i64 [ %v4018, %v4016 ], [ 0, %v4003 ]
  %v4018 = add nsw i64 %v4021, 1
  %v4026 = mul nsw i64 %v4021, %v10
  %v4044 = add nsw i64 %v4021, %v254
  %v4045 = add nsw i64 %v4044, 1
  %v4046 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %v4045, i64 %v10)
  %v4047 = add i64 %v636, %v4044
  %v4038 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %v4047, i64 %v10)
  %v4048 = getelementptr double, ptr %v230, i64 %v4026
  %v4033 = getelementptr double, ptr %v4048, i64 %v4021
  %v4049 = sub i64 %v4046, %v4018
  %v4050 = tail call i64 @llvm.smax.i64(i64 %v4049, i64 0)
  %v4034 = icmp slt i64 %v4049, 1
  br i1 %v4034, label %v4019, label %v4051

v4051:
  %v4052 = load double, ptr %v4033, align 8, !noalias !552
  %v4053 = tail call double @llvm.fabs.f64(double %v4052)
  br label %v4023

v4023:
  %v4054 = phi i64 [ %v4022, %v4023 ], [ %v4021, %v4051 ]
  %v4055 = phi double [ %v4056, %v4023 ], [ %v4053, %v4051 ]
  %v4057 = phi i64 [ %v4058, %v4023 ], [ %v4050, %v4051 ]
  %v4059 = phi i64 [ %v4060, %v4023 ], [ %v4018, %v4051 ]
  %v4058 = add nsw i64 %v4057, -1
  %v4060 = add i64 %v4059, 1
  %v4061 = add nsw i64 %v4059, %v4026
  %v4062 = icmp slt i64 %v4061, 0
  %v4063 = select i1 %v4062, i64 %v231, i64 0
  %v4064 = getelementptr double, ptr %v230, i64 %v4061
  %v4065 = getelementptr double, ptr %v4064, i64 %v4063
  %v4066 = load double, ptr %v4065, align 8, !noalias !552
  %v4067 = tail call double @llvm.fabs.f64(double %v4066)
  %v4068 = fcmp ogt double %v4067, %v4055
  %v4056 = select i1 %v4068, double %v4067, double %v4055
  %v4022 = select i1 %v4068, i64 %v4059, i64 %v4054
  %v4069 = icmp sgt i64 %v4057, 1
  br i1 %v4069, label %v4023, label %v4019

v4036:
  %v4070 = phi i64 [ %v4071, %v4036 ], [ %v4050, %v4019 ]
  %v4072 = phi i64 [ %v4073, %v4036 ], [ %v4018, %v4019 ]
  %v4071 = add nsw i64 %v4070, -1
  %v4073 = add i64 %v4072, 1
  %v4074 = add nsw i64 %v4072, %v4026
  %v4075 = icmp slt i64 %v4074, 0
  %v4076 = select i1 %v4075, i64 %v231, i64 0
  %v4077 = getelementptr double, ptr %v230, i64 %v4074
  %v4078 = getelementptr double, ptr %v4077, i64 %v4076
  %v4079 = load double, ptr %v4078, align 8, !noalias !552
  %v4080 = load double, ptr %v4033, align 8, !noalias !552
  %v4081 = fdiv double %v4079, %v4080
  store double %v4081, ptr %v4078, align 8, !noalias !552
  %v4082 = icmp sgt i64 %v4070, 1
  br i1 %v4082, label %v4036, label %v4035

v4040:
  %v4043 = phi i64 [ %v4083, %v4041 ], [ %v4037, %v4035 ]
  %v4084 = phi i64 [ %v4085, %v4041 ], [ %v4018, %v4035 ]
  %v4083 = add nsw i64 %v4043, -1
  %v4085 = add i64 %v4084, 1
  %v4086 = mul nsw i64 %v4084, %v10
  %v4087 = add nsw i64 %v4086, %v4020
  %v4088 = icmp slt i64 %v4087, 0
  %v4089 = select i1 %v4088, i64 %v231, i64 0
  %v4090 = getelementptr double, ptr %v230, i64 %v4087
  %v4091 = getelementptr double, ptr %v4090, i64 %v4089
  %v4092 = load double, ptr %v4091, align 8, !noalias !552
  %v4093 = add nsw i64 %v4086, %v4021
  %v4094 = icmp slt i64 %v4093, 0
  %v4095 = select i1 %v4094, i64 %v231, i64 0
  %v4096 = getelementptr double, ptr %v230, i64 %v4093
  %v4097 = getelementptr double, ptr %v4096, i64 %v4095
  %v4098 = load double, ptr %v4097, align 8, !noalias !552
  store double %v4098, ptr %v4091, align 8, !noalias !552
  store double %v4092, ptr %v4097, align 8, !noalias !552
  %v4099 = fcmp oeq double %v4092, 0.000000e+00
  %v4100 = or i1 %v4034, %v4099
  br i1 %v4100, label %v4041, label %v4101

v4101:
  %v4102 = phi i64 [ %v4103, %v4101 ], [ %v4050, %v4040 ]
  %v4104 = phi i64 [ %v4105, %v4101 ], [ %v4018, %v4040 ]
  %v4103 = add nsw i64 %v4102, -1
  %v4105 = add i64 %v4104, 1
  %v4106 = add nsw i64 %v4104, %v4086
  %v4107 = icmp slt i64 %v4106, 0
  %v4108 = select i1 %v4107, i64 %v231, i64 0
  %v4109 = getelementptr double, ptr %v230, i64 %v4106
  %v4110 = getelementptr double, ptr %v4109, i64 %v4108
  %v4111 = load double, ptr %v4110, align 8, !noalias !552
  %v4112 = add nsw i64 %v4104, %v4026
  %v4113 = icmp slt i64 %v4112, 0
  %v4114 = select i1 %v4113, i64 %v231, i64 0
  %v4115 = getelementptr double, ptr %v230, i64 %v4112
  %v4116 = getelementptr double, ptr %v4115, i64 %v4114
  %v4117 = load double, ptr %v4116, align 8, !noalias !552
  %v4118 = fmul double %v4092, %v4117
  %v4119 = fsub double %v4111, %v4118
  store double %v4119, ptr %v4110, align 8, !noalias !552
  %v4120 = icmp sgt i64 %v4102, 1
  br i1 %v4120, label %v4101, label %v4041

v4002:
  %v4005 = phi i64 [ %v4014, %v4003 ], [ 0, %v3821 ]
  %v4014 = add nsw i64 %v4005, 1
  %v4121 = sub i64 %v4005, %v631
  %v4122 = tail call i64 @llvm.smax.i64(i64 %v4121, i64 0)
  %v4123 = add i64 %v632, %v4005
  %v4124 = tail call i64 @llvm.smin.i64(i64 %v4123, i64 %v10)
  %v4125 = sub i64 %v4124, %v4122
  %v4126 = icmp slt i64 %v4125, 1
  br i1 %v4126, label %v4003, label %v4127

v4127:
  %v4128 = mul nsw i64 %v4005, %v10
  br label %v4129

v4129:
  %v4130 = phi i64 [ %v4125, %v4127 ], [ %v4131, %v4129 ]
  %v4132 = phi i64 [ %v4122, %v4127 ], [ %v4133, %v4129 ]
  %v4131 = add nsw i64 %v4130, -1
  %v4133 = add i64 %v4132, 1
  %v4134 = add nsw i64 %v4132, %v4128
  %v4135 = icmp slt i64 %v4134, 0
  %v4136 = select i1 %v4135, i64 %v224, i64 0
  %v4137 = getelementptr double, ptr %v223, i64 %v4134
  %v4138 = getelementptr double, ptr %v4137, i64 %v4136
  %v4139 = load double, ptr %v4138, align 8, !noalias !534
  %v4140 = fneg double %v4139
  %v4141 = select i1 %v4135, i64 %v231, i64 0
  %v4142 = getelementptr double, ptr %v230, i64 %v4134
  %v4143 = getelementptr double, ptr %v4142, i64 %v4141
  store double %v4140, ptr %v4143, align 8, !noalias !534
  %v4144 = icmp sgt i64 %v4130, 1
  br i1 %v4144, label %v4129, label %v4003

v3817:
  br i1 %v640, label %v1307, label %v4145

v4146:
  br i1 %v646, label %v4147, label %v4148

v4148:
  %v4149 = mul i64 %v4150, %v647
  %v4151 = getelementptr double, ptr %v194, i64 %v4149
  br label %v4152

v4153:
  %v4154 = icmp slt i64 %v4155, 0
  %v4156 = select i1 %v4154, i64 %v252, i64 0
  %v4157 = getelementptr i64, ptr %v251, i64 %v4155
  %v4158 = getelementptr i64, ptr %v4157, i64 %v4156
  store i64 %v4159, ptr %v4158, align 8, !noalias !555
  %v4160 = add nsw i64 %v4155, 1
  br label %v4161

v4161:
  %v4162 = phi i64 [ %v4160, %v4153 ], [ %v4155, %v4163 ]
  %v4164 = icmp eq i64 %v10, %v4165
  br i1 %v4164, label %v4147, label %v4163

v4147:
  %v4166 = phi i64 [ 0, %v4146 ], [ %v4162, %v4161 ]
  %v4167 = icmp sgt i64 %v4166, 0
  %v4168 = icmp slt i64 %v4166, %v10
  %v4169 = and i1 %v4167, %v4168
  br i1 %v4169, label %v4170, label %v4171

v4170:
  %v4172 = phi i64 [ %v4173, %v4174 ], [ %v4166, %v4147 ]
  %v4175 = phi i64 [ %v4176, %v4174 ], [ 0, %v4147 ]
  %v4177 = getelementptr i64, ptr %v251, i64 %v4175
  %v4178 = load i64, ptr %v4177, align 8, !noalias !555
  %v4176 = add nsw i64 %v4175, 1
  %v4179 = sub nsw i64 %v4178, %v255
  %v4180 = tail call i64 @llvm.smax.i64(i64 %v4179, i64 0)
  %v4181 = add i64 %v654, %v4178
  %v4182 = tail call i64 @llvm.smin.i64(i64 %v4181, i64 %v10)
  %v4183 = sub i64 %v4182, %v4180
  %v4184 = icmp slt i64 %v4183, 1
  br i1 %v4184, label %v4174, label %v4185

v4185:
  %v4186 = mul nsw i64 %v4178, %v10
  br label %v4187

v4188:
  %v4189 = icmp slt i64 %v4190, 0
  %v4191 = select i1 %v4189, i64 %v245, i64 0
  %v4192 = getelementptr i64, ptr %v244, i64 %v4190
  %v4193 = getelementptr i64, ptr %v4192, i64 %v4191
  %v4194 = load i64, ptr %v4193, align 8, !noalias !555
  %v4195 = icmp eq i64 %v4194, 0
  br i1 %v4195, label %v4196, label %v4197

v4196:
  store i64 1, ptr %v4193, align 8, !noalias !555
  %v4198 = getelementptr i64, ptr %v251, i64 %v4199
  store i64 %v4190, ptr %v4198, align 8, !noalias !555
  %v4200 = add nsw i64 %v4199, 1
  br label %v4197

v4197:
  %v4201 = phi i64 [ %v4199, %v4188 ], [ %v4200, %v4196 ], [ %v4199, %v4187 ]
  %v4202 = icmp sgt i64 %v4203, 1
  br i1 %v4202, label %v4187, label %v4174

v4174:
  %v4173 = phi i64 [ %v4172, %v4170 ], [ %v4201, %v4197 ]
  %v4204 = icmp slt i64 %v4176, %v4173
  %v4205 = icmp slt i64 %v4173, %v10
  %v4206 = and i1 %v4204, %v4205
  br i1 %v4206, label %v4170, label %v4171

v4163:
  %v4155 = phi i64 [ %v4162, %v4161 ], [ 0, %v4152 ]
  %v4159 = phi i64 [ %v4165, %v4161 ], [ 0, %v4152 ]
  %v4165 = add nsw i64 %v4159, 1
  %v4207 = getelementptr double, ptr %v653, i64 %v4159
  %v4208 = load double, ptr %v4207, align 8, !noalias !555
  %v4209 = fcmp une double %v4208, 0.000000e+00
  %v4210 = getelementptr i64, ptr %v244, i64 %v4159
  %v4211 = zext i1 %v4209 to i64
  store i64 %v4211, ptr %v4210, align 8, !noalias !555
  br i1 %v4209, label %v4153, label %v4161

v4187:
  %v4199 = phi i64 [ %v4172, %v4185 ], [ %v4201, %v4197 ]
  %v4203 = phi i64 [ %v4183, %v4185 ], [ %v4212, %v4197 ]
  %v4190 = phi i64 [ %v4180, %v4185 ], [ %v4213, %v4197 ]
  %v4212 = add nsw i64 %v4203, -1
  %v4213 = add i64 %v4190, 1
  %v4214 = add nsw i64 %v4190, %v4186
  %v4215 = icmp slt i64 %v4214, 0
  %v4216 = select i1 %v4215, i64 %v224, i64 0
  %v4217 = getelementptr double, ptr %v223, i64 %v4214
  %v4218 = getelementptr double, ptr %v4217, i64 %v4216
  %v4219 = load double, ptr %v4218, align 8, !noalias !555
  %v4220 = fcmp une double %v4219, 0.000000e+00
  br i1 %v4220, label %v4188, label %v4197

v4221:
  %v4222 = select i1 %v4223, i64 %v196, i64 0
  %v4224 = add i64 %v4222, %v4225
  %v4226 = mul i64 %v4224, %v197
  %v4227 = getelementptr double, ptr %v658, i64 %v4226
  %v4228 = load double, ptr %v4227, align 8, !noalias !561
  br label %v4229

v4229:
  %v4230 = phi double [ %v4228, %v4221 ], [ 0.000000e+00, %v4231 ]
  %v4232 = mul i64 %v4233, %v197
  %v4234 = getelementptr double, ptr %v4235, i64 %v4232
  store double %v4230, ptr %v4234, align 8, !noalias !561
  %v4236 = icmp eq i64 %v10, %v4237
  br i1 %v4236, label %v4238, label %v4231

v4152:
  %v4239 = phi i64 [ 0, %v4148 ], [ %v4240, %v4152 ]
  %v4240 = add nsw i64 %v4239, 1
  %v4241 = mul i64 %v4239, %v197
  %v4242 = getelementptr double, ptr %v4151, i64 %v4241
  %v4243 = load double, ptr %v4242, align 8, !noalias !561
  %v4244 = getelementptr double, ptr %v649, i64 %v4241
  %v4245 = load double, ptr %v4244, align 8, !noalias !561
  %v4246 = fadd double %v4243, %v4245
  %v4247 = getelementptr i64, ptr %v260, i64 %v4239
  %v4248 = load i64, ptr %v4247, align 8, !noalias !561
  %v4249 = icmp slt i64 %v4248, 0
  %v4250 = select i1 %v4249, i64 %v196, i64 0
  %v4251 = add i64 %v4250, %v4248
  %v4252 = mul i64 %v4251, %v197
  %v4253 = getelementptr double, ptr %v651, i64 %v4252
  store double %v4246, ptr %v4253, align 8, !noalias !561
  %v4254 = icmp eq i64 %v10, %v4240
  br i1 %v4254, label %v4163, label %v4152

v4171:
  br i1 %v646, label %v4238, label %v4255

v4256:
  %v4257 = icmp eq i64 %v10, %v4258
  br i1 %v4257, label %v4259, label %v4255

v4260:
  %v4261 = icmp sgt i64 %v4262, 1
  br i1 %v4261, label %v4259, label %v4263

v4263:
  %v4264 = mul i64 %v659, %v4150
  %v4235 = getelementptr double, ptr %v194, i64 %v4264
  br label %v4231

v4255:
  %v4265 = phi i64 [ %v4258, %v4256 ], [ 0, %v4171 ]
  %v4258 = add nsw i64 %v4265, 1
  %v4266 = getelementptr i64, ptr %v237, i64 %v4265
  %v4267 = load i64, ptr %v4266, align 8, !noalias !562
  %v4268 = add nsw i64 %v4267, %v652
  %v4269 = icmp slt i64 %v4268, 0
  %v4270 = select i1 %v4269, i64 %v160, i64 0
  %v4271 = getelementptr double, ptr %v159, i64 %v4268
  %v4272 = getelementptr double, ptr %v4271, i64 %v4270
  %v4273 = load double, ptr %v4272, align 8, !noalias !562
  %v4274 = getelementptr double, ptr %v656, i64 %v4265
  %v4275 = load double, ptr %v4274, align 8, !noalias !562
  store double %v4275, ptr %v4272, align 8, !noalias !562
  store double %v4273, ptr %v4274, align 8, !noalias !562
  %v4276 = add i64 %v655, %v4265
  %v4277 = tail call i64 @llvm.smin.i64(i64 %v4276, i64 %v10)
  %v4278 = sub i64 %v4277, %v4258
  %v4279 = icmp slt i64 %v4278, 1
  br i1 %v4279, label %v4256, label %v4280

v4280:
  %v4281 = mul nsw i64 %v4265, %v10
  br label %v4282

v4282:
  %v4283 = phi i64 [ %v4278, %v4280 ], [ %v4284, %v4282 ]
  %v4285 = phi i64 [ %v4258, %v4280 ], [ %v4286, %v4282 ]
  %v4284 = add nsw i64 %v4283, -1
  %v4286 = add i64 %v4285, 1
  %v4287 = add nsw i64 %v4285, %v652
  %v4288 = icmp slt i64 %v4287, 0
  %v4289 = select i1 %v4288, i64 %v160, i64 0
  %v4290 = getelementptr double, ptr %v159, i64 %v4287
  %v4291 = getelementptr double, ptr %v4290, i64 %v4289
  %v4292 = load double, ptr %v4291, align 8, !noalias !562
  %v4293 = add nsw i64 %v4285, %v4281
  %v4294 = icmp slt i64 %v4293, 0
  %v4295 = select i1 %v4294, i64 %v231, i64 0
  %v4296 = getelementptr double, ptr %v230, i64 %v4293
  %v4297 = getelementptr double, ptr %v4296, i64 %v4295
  %v4298 = load double, ptr %v4297, align 8, !noalias !562
  %v4299 = fmul double %v4273, %v4298
  %v4300 = fsub double %v4292, %v4299
  store double %v4300, ptr %v4291, align 8, !noalias !562
  %v4301 = icmp sgt i64 %v4283, 1
  br i1 %v4301, label %v4282, label %v4256

v4259:
  %v4262 = phi i64 [ %v4302, %v4260 ], [ %v10, %v4256 ]
  %v4302 = add nsw i64 %v4262, -1
  %v4303 = add nsw i64 %v4302, %v652
  %v4304 = icmp slt i64 %v4303, 0
  %v4305 = select i1 %v4304, i64 %v160, i64 0
  %v4306 = getelementptr double, ptr %v159, i64 %v4303
  %v4307 = getelementptr double, ptr %v4306, i64 %v4305
  %v4308 = load double, ptr %v4307, align 8, !noalias !562
  %v4309 = mul nsw i64 %v4302, %v10
  %v4310 = add nsw i64 %v4309, %v4302
  %v4311 = icmp slt i64 %v4310, 0
  %v4312 = select i1 %v4311, i64 %v231, i64 0
  %v4313 = getelementptr double, ptr %v230, i64 %v4310
  %v4314 = getelementptr double, ptr %v4313, i64 %v4312
  %v4315 = load double, ptr %v4314, align 8, !noalias !562
  %v4316 = fdiv double %v4308, %v4315
  store double %v4316, ptr %v4307, align 8, !noalias !562
  %v4317 = sub i64 %v4302, %v657
  %v4318 = tail call i64 @llvm.smax.i64(i64 %v4317, i64 0)
  %v4319 = sub i64 %v4302, %v4318
  %v4320 = icmp slt i64 %v4319, 1
  br i1 %v4320, label %v4260, label %v4321

v4321:
  %v4322 = phi i64 [ %v4323, %v4321 ], [ %v4319, %v4259 ]
  %v4324 = phi i64 [ %v4325, %v4321 ], [ %v4318, %v4259 ]
  %v4323 = add nsw i64 %v4322, -1
  %v4325 = add i64 %v4324, 1
  %v4326 = add nsw i64 %v4324, %v652
  %v4327 = icmp slt i64 %v4326, 0
  %v4328 = select i1 %v4327, i64 %v160, i64 0
  %v4329 = getelementptr double, ptr %v159, i64 %v4326
  %v4330 = getelementptr double, ptr %v4329, i64 %v4328
  %v4331 = load double, ptr %v4330, align 8, !noalias !562
  %v4332 = add nsw i64 %v4324, %v4309
  %v4333 = icmp slt i64 %v4332, 0
  %v4334 = select i1 %v4333, i64 %v231, i64 0
  %v4335 = getelementptr double, ptr %v230, i64 %v4332
  %v4336 = getelementptr double, ptr %v4335, i64 %v4334
  %v4337 = load double, ptr %v4336, align 8, !noalias !562
  %v4338 = fmul double %v4316, %v4337
  %v4339 = fsub double %v4331, %v4338
  store double %v4339, ptr %v4330, align 8, !noalias !562
  %v4340 = icmp sgt i64 %v4322, 1
  br i1 %v4340, label %v4321, label %v4260

v4231:
  %v4233 = phi i64 [ 0, %v4263 ], [ %v4237, %v4229 ]
  %v4237 = add nsw i64 %v4233, 1
  %v4341 = getelementptr i64, ptr %v260, i64 %v4233
  %v4225 = load i64, ptr %v4341, align 8, !noalias !561
  %v4223 = icmp slt i64 %v4225, 0
  %v4342 = select i1 %v4223, i64 %v245, i64 0
  %v4343 = getelementptr i64, ptr %v244, i64 %v4225
  %v4344 = getelementptr i64, ptr %v4343, i64 %v4342
  %v4345 = load i64, ptr %v4344, align 8, !noalias !561
  %v4346 = icmp eq i64 %v4345, 0
  br i1 %v4346, label %v4229, label %v4221

v4238:
  %v4347 = icmp eq i64 %v4348, %v638
  br i1 %v4347, label %v1307, label %v4145

v1307:
  %v4349 = load i64, ptr %v660, align 8, !noalias !566
  %v4350 = inttoptr i64 %v4349 to ptr
  tail call void %v4350(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !566
  br i1 %v308, label %v1305, label %v1295

v4145:
  %v4348 = phi i64 [ %v4150, %v4238 ], [ 1, %v3817 ]
  %v4150 = add i64 %v4348, 1
  %v4351 = getelementptr i64, ptr %v6, i64 %v4348
  %v4352 = getelementptr i8, ptr %v4351, i64 104
  %v4353 = load i64, ptr %v4352, align 8, !noalias !569
  %v4354 = inttoptr i64 %v4353 to ptr
  tail call void %v4354(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !569
  %v4355 = load i64, ptr %v6, align 8, !noalias !572
  %v4356 = mul nsw i64 %v4150, %v643
  %v4357 = getelementptr double, ptr %v159, i64 %v4356
  %v4358 = inttoptr i64 %v4355 to ptr
  tail call void %v4358(ptr %v642, ptr %v645, ptr %v166, ptr %v173, ptr %v180, ptr %v4357), !noalias !572
  br i1 %v581, label %v4146, label %v4238

v1295:
  %v1296 = phi i1 [ %v1302, %v1297 ], [ %v1283, %v1307 ]
  %v4359 = phi i1 [ %v1294, %v1297 ], [ false, %v1307 ]
  %v1304 = phi i64 [ %v4360, %v1297 ], [ %v309, %v1307 ]
  %v1290 = phi i64 [ %v4361, %v1297 ], [ 0, %v1307 ]
  %v4360 = add nsw i64 %v1304, -1
  %v4361 = add nsw i64 %v1290, 1
  br i1 %v4359, label %v1293, label %v1288

v1398:
  %v1408 = xor i1 %v1393, true
  %v4362 = xor i1 %v1394, true
  %v1410 = select i1 %v4362, i1 true, i1 %v687
  br label %v1311

v3061:
  store ptr %v3058, ptr %v1, align 8
  br label %v3808

v3060:
  %v4363 = select i1 %v1308, i1 %v1306, i1 false
  %v4364 = xor i1 %v4363, true
  %v4365 = or i1 %v308, %v4364
  br i1 %v4365, label %v3181, label %v3182

v3756:
  %v3760 = select i1 %v3753, i64 0, i64 %v1080
  br label %v1077

v3765:
  store i64 %v3764, ptr %v0, align 8
  br label %v3808
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc range(i32 0, 2) i32 @_ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr noalias nonnull %v0, ptr noalias nonnull %v1, i64 %v2, ptr readonly %v3, i64 %v4, ptr %v5, i64 %v6, i64 %v7, ptr %v8, i64 %v9, ptr %v10, i64 %v11, ptr readonly %v12, i64 %v13, i64 %v14, i64 %v15, double %v16) unnamed_addr {
v17:
  %v18 = icmp eq i64 %v2, 0
  %v19 = shl i64 %v11, 5
  %v20 = getelementptr i8, ptr %v10, i64 %v19
  store i64 -1, ptr %v20, align 8
  %v21 = mul i64 %v9, 56
  %v22 = getelementptr i8, ptr %v8, i64 %v21
  %v23 = load double, ptr %v22, align 8
  %v24 = shl i64 %v9, 6
  %v25 = getelementptr i8, ptr %v8, i64 %v24
  store double %v23, ptr %v25, align 8
  %v26 = load i64, ptr %v10, align 8
  %v27 = icmp slt i64 %v26, 0
  br i1 %v27, label %v28, label %v29

v29:
  %v30 = mul i64 %v9, 40
  %v31 = getelementptr i8, ptr %v8, i64 %v30
  %v32 = load double, ptr %v31, align 8
  %v33 = fcmp olt double %v32, 5.000000e-01
  br i1 %v33, label %v28, label %v34

v35:
  %v36 = phi i32 [ 0, %v28 ], [ 0, %v37 ], [ 1, %v38 ]
  ret i32 %v36

v28:
  store i8 0, ptr %v0, align 1
  br label %v35

v34:
  br i1 %v18, label %v39, label %v40

v39:
  %v41 = phi i64 [ 0, %v40 ], [ 7, %v34 ], [ 1, %v42 ], [ 4, %v43 ], [ 7, %v44 ], [ 2, %v45 ], [ 6, %v46 ], [ 3, %v47 ], [ 5, %v48 ]
  %v49 = add nsw i64 %v41, 1
  %v50 = load i64, ptr %v20, align 8
  %v51 = icmp slt i64 %v50, 0
  br i1 %v51, label %v52, label %v53

v52:
  %v54 = tail call i64 @llvm.smax.i64(i64 %v15, i64 0)
  %v55 = mul i64 %v15, %v14
  %v56 = shl i64 %v15, 4
  br label %v57

v57:
  %v58 = phi i64 [ %v59, %v60 ], [ %v41, %v52 ]
  %v59 = add nsw i64 %v58, 1
  %v61 = mul i64 %v55, %v59
  %v62 = getelementptr double, ptr %v12, i64 %v61
  %v63 = getelementptr double, ptr %v62, i64 %v15
  %v64 = getelementptr i8, ptr %v62, i64 %v56
  br label %v65

v65:
  %v66 = phi i64 [ 0, %v57 ], [ %v67, %v68 ]
  %v69 = icmp eq i64 %v66, %v54
  br i1 %v69, label %v70, label %v68

v68:
  %v67 = add i64 %v66, 1
  %v71 = getelementptr double, ptr %v63, i64 %v66
  %v72 = load double, ptr %v71, align 8, !noalias !575
  %v73 = getelementptr double, ptr %v64, i64 %v66
  %v74 = load double, ptr %v73, align 8, !noalias !575
  %v75 = fneg double %v74
  %v76 = fcmp olt double %v72, %v75
  br i1 %v76, label %v70, label %v65

v60:
  %v77 = icmp slt i64 %v78, 0
  br i1 %v77, label %v57, label %v53

v53:
  %v79 = phi i64 [ %v41, %v39 ], [ %v59, %v60 ], [ 8, %v70 ]
  %v80 = add nsw i64 %v79, -1
  %v81 = select i1 %v18, i64 0, i64 %v80
  %v82 = getelementptr double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v81
  %v83 = getelementptr i8, ptr %v82, i64 72
  %v84 = load double, ptr %v83, align 8
  %v85 = fcmp ogt double %v84, %v16
  %v86 = select i1 %v85, double %v84, double %v16
  %v87 = getelementptr double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v79
  %v88 = getelementptr i8, ptr %v87, i64 72
  %v89 = load double, ptr %v88, align 8
  %v90 = mul i64 %v9, 104
  %v91 = getelementptr i8, ptr %v8, i64 %v90
  store double %v86, ptr %v91, align 8
  %v92 = mul i64 %v9, 112
  %v93 = getelementptr i8, ptr %v8, i64 %v92
  store double %v89, ptr %v93, align 8
  %v94 = icmp slt i64 %v15, 1
  br i1 %v94, label %v95, label %v96

v97:
  %v98 = load double, ptr %v22, align 8
  %v99 = tail call double @llvm.fabs.f64(double %v98)
  %v100 = fmul double %v99, 1.000000e-15
  %v101 = fdiv double %v100, %v102
  %v103 = tail call i64 @llvm.smax.i64(i64 %v15, i64 0)
  %v104 = mul i64 %v15, %v14
  %v105 = getelementptr double, ptr %v12, i64 %v15
  %v106 = shl i64 %v15, 4
  %v107 = getelementptr i8, ptr %v12, i64 %v106
  %v108 = tail call i64 @llvm.smin.i64(i64 range(i64 -1, 9) %v109, i64 7)
  %v110 = sub nsw i64 %v108, %v49
  %v111 = tail call i64 @llvm.smax.i64(i64 %v110, i64 -1)
  %v112 = add nsw i64 %v111, 1
  %v113 = icmp ult i64 %v110, 9223372036854775807
  %v114 = zext i1 %v113 to i64
  %v115 = add nsw i64 %v49, %v114
  %v116 = sext i1 %v113 to i64
  %v117 = add nsw i64 %v112, %v116
  %v118 = select i1 %v113, i64 %v49, i64 0
  %v119 = shl i64 %v104, 4
  %v120 = shl i64 %v104, 5
  %v121 = mul i64 %v104, 48
  %v122 = shl i64 %v104, 6
  %v123 = mul i64 %v104, 24
  %v124 = mul i64 %v104, 40
  %v125 = mul i64 %v104, 56
  br label %v126

v126:
  %v127 = phi i64 [ 0, %v97 ], [ %v128, %v129 ]
  %v130 = phi i64 [ %v103, %v97 ], [ %v131, %v129 ]
  %v132 = phi ptr [ null, %v97 ], [ %v133, %v129 ]
  %v134 = icmp sgt i64 %v130, 0
  %v135 = zext i1 %v134 to i64
  %v128 = add i64 %v127, %v135
  %v136 = sext i1 %v134 to i64
  %v131 = add nsw i64 %v130, %v136
  br i1 %v134, label %v137, label %v138

v137:
  %v139 = icmp slt i64 %v127, 0
  %v140 = select i1 %v139, i64 %v15, i64 0
  %v141 = add i64 %v140, %v127
  %v142 = getelementptr double, ptr %v105, i64 %v141
  %v143 = getelementptr double, ptr %v142, i64 %v104
  %v144 = load double, ptr %v143, align 8, !noalias !579
  %v145 = load double, ptr %v142, align 8, !noalias !579
  %v146 = fmul double %v145, 0x3FDDF27AAAADCB3A
  %v147 = fsub double %v144, %v146
  %v148 = getelementptr i8, ptr %v142, i64 %v119
  %v149 = load double, ptr %v148, align 8, !noalias !579
  %v150 = fmul double %v149, 0x3FEC575F1EBC4F2F
  %v151 = fsub double %v147, %v150
  %v152 = getelementptr i8, ptr %v142, i64 %v120
  %v153 = load double, ptr %v152, align 8, !noalias !579
  %v154 = fmul double %v153, 0x3FE1306AA3D795F4
  %v155 = fadd double %v151, %v154
  %v156 = getelementptr i8, ptr %v142, i64 %v121
  %v157 = load double, ptr %v156, align 8, !noalias !579
  %v158 = fmul double %v157, 0x3FCCB9F574BDCC3A
  %v159 = fsub double %v155, %v158
  %v160 = getelementptr i8, ptr %v142, i64 %v122
  %v161 = load double, ptr %v160, align 8, !noalias !579
  %v162 = fmul double %v161, 0x3FA4EAF2D6B11E79
  %v163 = fadd double %v159, %v162
  %v164 = tail call double @llvm.fabs.f64(double %v163)
  %v165 = fcmp ogt double %v164, 0.000000e+00
  %v166 = select i1 %v165, double %v164, double 0.000000e+00
  %v167 = getelementptr i8, ptr %v142, i64 %v123
  %v168 = load double, ptr %v167, align 8, !noalias !579
  %v169 = fmul double %v145, 0x3FA5118805F8B876
  %v170 = fadd double %v168, %v169
  %v171 = fmul double %v149, 0x3FE51326698BC5BD
  %v172 = fsub double %v170, %v171
  %v173 = fmul double %v153, 0x3FDF97DED30D4572
  %v174 = fsub double %v172, %v173
  %v175 = fmul double %v157, 0x3FC0DA0C684D1D67
  %v176 = fadd double %v174, %v175
  %v177 = fmul double %v161, 0x3F9510B8EC0D4D92
  %v178 = fsub double %v176, %v177
  %v179 = tail call double @llvm.fabs.f64(double %v178)
  %v180 = fcmp ogt double %v179, %v166
  %v181 = select i1 %v180, double %v179, double %v166
  %v182 = getelementptr i8, ptr %v142, i64 %v124
  %v183 = load double, ptr %v182, align 8, !noalias !579
  %v184 = fmul double %v145, 0x3F9635A30F8F142F
  %v185 = fsub double %v183, %v184
  %v186 = fmul double %v149, 0x3FC1EAE0FF33D241
  %v187 = fadd double %v185, %v186
  %v188 = fmul double %v153, 0x3FE1625D59218460
  %v189 = fsub double %v187, %v188
  %v190 = fmul double %v157, 0x3FE3BBC3E8A29641
  %v191 = fsub double %v189, %v190
  %v192 = fmul double %v161, 0x3FA55161A739EB34
  %v193 = fadd double %v191, %v192
  %v194 = tail call double @llvm.fabs.f64(double %v193)
  %v195 = fcmp ogt double %v194, %v181
  %v196 = select i1 %v195, double %v194, double %v181
  %v197 = getelementptr i8, ptr %v142, i64 %v125
  %v198 = load double, ptr %v197, align 8, !noalias !579
  %v199 = fmul double %v145, 0x3FA4F0C0BB579409
  %v200 = fadd double %v198, %v199
  %v201 = fmul double %v149, 0x3FCD2266FBC0D976
  %v202 = fsub double %v200, %v201
  %v203 = fmul double %v153, 0x3FE1F2DB6FEE3151
  %v204 = fadd double %v202, %v203
  %v205 = fmul double %v157, 0x3FF0C05015964CBE
  %v206 = fsub double %v204, %v205
  %v207 = fmul double %v161, 0x3FD4F15B230DB570
  %v208 = fsub double %v206, %v207
  %v209 = tail call double @llvm.fabs.f64(double %v208)
  %v210 = fcmp ogt double %v209, %v196
  %v211 = select i1 %v210, double %v209, double %v196
  %v212 = getelementptr double, ptr %v107, i64 %v141
  %v213 = load double, ptr %v212, align 8, !noalias !586
  %v214 = tail call double @llvm.fabs.f64(double %v213)
  %v215 = fsub double %v144, %v145
  %v216 = tail call double @llvm.fabs.f64(double %v215)
  %v217 = fmul double %v101, %v216
  %v218 = fadd double %v217, %v214
  %v219 = fsub double %v149, %v144
  %v220 = tail call double @llvm.fabs.f64(double %v219)
  %v221 = fmul double %v101, %v220
  %v222 = fadd double %v221, %v218
  %v223 = fsub double %v168, %v149
  %v224 = tail call double @llvm.fabs.f64(double %v223)
  %v225 = fmul double %v101, %v224
  %v226 = fadd double %v225, %v222
  %v227 = fsub double %v153, %v168
  %v228 = tail call double @llvm.fabs.f64(double %v227)
  %v229 = fmul double %v101, %v228
  %v230 = fadd double %v229, %v226
  %v231 = fsub double %v183, %v153
  %v232 = tail call double @llvm.fabs.f64(double %v231)
  %v233 = fmul double %v101, %v232
  %v234 = fadd double %v233, %v230
  %v235 = fsub double %v157, %v183
  %v236 = tail call double @llvm.fabs.f64(double %v235)
  %v237 = fmul double %v101, %v236
  %v238 = fadd double %v237, %v234
  %v239 = fsub double %v198, %v157
  %v240 = tail call double @llvm.fabs.f64(double %v239)
  %v241 = fmul double %v101, %v240
  %v242 = fadd double %v241, %v238
  %v243 = fsub double %v161, %v198
  %v244 = tail call double @llvm.fabs.f64(double %v243)
  %v245 = fmul double %v101, %v244
  %v246 = fadd double %v245, %v242
  br i1 %v113, label %v247, label %v248

v247:
  %v249 = fmul double %v211, 1.000000e+01
  br label %v250

v250:
  %v251 = phi i64 [ %v118, %v247 ], [ %v252, %v253 ]
  %v254 = phi i64 [ %v117, %v247 ], [ %v255, %v253 ]
  %v256 = phi i64 [ %v115, %v247 ], [ %v257, %v253 ]
  %v258 = phi double [ 0x7FF0000000000000, %v247 ], [ %v259, %v253 ]
  %v260 = add nsw i64 %v251, -1
  %v261 = icmp sgt i64 %v251, 0
  %v262 = select i1 %v261, i64 0, i64 %v13
  %v263 = add i64 %v260, %v262
  %v264 = mul i64 %v263, %v104
  %v265 = getelementptr double, ptr %v142, i64 %v264
  %v266 = load double, ptr %v265, align 8, !noalias !587
  %v267 = icmp slt i64 %v251, 0
  %v268 = select i1 %v267, i64 %v13, i64 0
  %v269 = add i64 %v268, %v251
  %v270 = mul i64 %v269, %v104
  %v271 = getelementptr double, ptr %v142, i64 %v270
  %v272 = load double, ptr %v271, align 8, !noalias !587
  %v273 = fcmp olt double %v272, %v258
  %v274 = select i1 %v273, double %v272, double %v258
  %v275 = icmp slt i64 %v251, %v109
  br i1 %v275, label %v276, label %v253

v276:
  %v277 = add nsw i64 %v251, 1
  %v278 = icmp slt i64 %v251, -1
  %v279 = select i1 %v278, i64 %v13, i64 0
  %v280 = add i64 %v277, %v279
  %v281 = mul i64 %v280, %v104
  %v282 = getelementptr double, ptr %v142, i64 %v281
  %v283 = load double, ptr %v282, align 8, !noalias !587
  %v284 = fsub double %v266, %v272
  %v285 = tail call double @llvm.fabs.f64(double %v284)
  %v286 = fsub double %v283, %v272
  %v287 = tail call double @llvm.fabs.f64(double %v286)
  %v288 = fadd double %v285, %v287
  %v289 = fmul double %v288, 3.000000e+00
  %v290 = fadd double %v249, %v289
  %v291 = fcmp olt double %v272, %v290
  br i1 %v291, label %v292, label %v253

v292:
  %v293 = add i64 %v251, 9
  %v294 = icmp ult i64 %v293, 18
  br i1 %v294, label %v295, label %v248

v296:
  %v297 = fneg double %v298
  %v299 = fmul double %v300, 5.000000e-01
  %v301 = fdiv double %v299, %v302
  %v303 = fcmp ogt double %v301, %v297
  %v304 = fcmp olt double %v301, %v305
  %v306 = and i1 %v303, %v304
  br i1 %v306, label %v307, label %v253

v307:
  %v308 = fmul double %v300, 3.750000e-01
  %v309 = fmul double %v300, %v308
  %v310 = fdiv double %v309, %v302
  %v311 = fsub double %v272, %v310
  %v312 = fcmp olt double %v311, %v274
  %v313 = select i1 %v312, double %v311, double %v274
  br label %v253

v253:
  %v259 = phi double [ %v274, %v296 ], [ %v313, %v307 ], [ %v274, %v250 ], [ %v274, %v314 ], [ %v274, %v276 ]
  %v315 = icmp sgt i64 %v254, 0
  %v316 = zext i1 %v315 to i64
  %v257 = add i64 %v256, %v316
  %v317 = sext i1 %v315 to i64
  %v255 = add nsw i64 %v254, %v317
  %v252 = select i1 %v315, i64 %v256, i64 0
  br i1 %v315, label %v250, label %v248

v295:
  %v318 = add i64 %v251, 8
  %v319 = icmp ult i64 %v318, 18
  br i1 %v319, label %v320, label %v248

v320:
  %v321 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v293
  %v322 = load double, ptr %v321, align 8
  %v323 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v318
  %v324 = load double, ptr %v323, align 8
  %v305 = fsub double %v322, %v324
  %v325 = add i64 %v251, 10
  %v326 = icmp ult i64 %v325, 18
  br i1 %v326, label %v327, label %v248

v327:
  %v328 = add i64 %v251, 9
  %v329 = icmp ult i64 %v328, 18
  br i1 %v329, label %v314, label %v248

v314:
  %v330 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v325
  %v331 = load double, ptr %v330, align 8
  %v332 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v328
  %v333 = load double, ptr %v332, align 8
  %v298 = fsub double %v331, %v333
  %v334 = fdiv double %v286, %v298
  %v335 = fsub double %v272, %v266
  %v336 = fdiv double %v335, %v305
  %v337 = fsub double %v334, %v336
  %v338 = fadd double %v305, %v298
  %v302 = fdiv double %v337, %v338
  %v339 = fmul double %v305, %v302
  %v300 = fadd double %v336, %v339
  %v340 = fcmp ogt double %v302, 0.000000e+00
  br i1 %v340, label %v296, label %v253

v248:
  %v341 = phi i1 [ false, %v137 ], [ false, %v253 ], [ true, %v292 ], [ true, %v295 ], [ true, %v320 ], [ true, %v327 ]
  %v342 = phi double [ 0x7FF0000000000000, %v137 ], [ %v259, %v253 ], [ 0.000000e+00, %v292 ], [ 0.000000e+00, %v295 ], [ 0.000000e+00, %v320 ], [ 0.000000e+00, %v327 ]
  %v133 = phi ptr [ %v132, %v137 ], [ %v132, %v253 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.9, %v292 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.9, %v295 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.9, %v320 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.9, %v327 ]
  %v343 = phi i32 [ 0, %v137 ], [ 0, %v253 ], [ 1, %v292 ], [ 1, %v295 ], [ 1, %v320 ], [ 1, %v327 ]
  br i1 %v341, label %v138, label %v344, !prof !397

v129:
  %v345 = fcmp ule double %v211, %v246
  %v346 = fmul double %v211, 1.000000e+01
  %v347 = fcmp ugt double %v342, %v346
  %v348 = select i1 %v345, i1 true, i1 %v347
  br i1 %v348, label %v126, label %v138

v344:
  %v349 = fneg double %v246
  %v350 = fcmp olt double %v342, %v349
  br i1 %v350, label %v138, label %v129

v138:
  %v351 = phi i1 [ true, %v126 ], [ false, %v129 ], [ false, %v344 ], [ true, %v248 ]
  %v352 = phi ptr [ null, %v126 ], [ null, %v129 ], [ null, %v344 ], [ %v133, %v248 ]
  %v353 = phi i32 [ 0, %v126 ], [ 0, %v129 ], [ 0, %v344 ], [ %v343, %v248 ]
  %v354 = icmp eq i32 %v353, 0
  br i1 %v354, label %v355, label %v38, !prof !131

v356:
  %v357 = fmul double %v102, 5.000000e-01
  store double 0.000000e+00, ptr %v31, align 8, !noalias !591
  %v358 = shl i64 %v9, 5
  %v359 = getelementptr i8, ptr %v8, i64 %v358
  store double 0.000000e+00, ptr %v359, align 8, !noalias !591
  %v360 = getelementptr double, ptr %v8, i64 %v9
  store double %v357, ptr %v360, align 8, !noalias !591
  %v361 = load i64, ptr %v10, align 8, !noalias !591
  %v362 = icmp slt i64 %v361, 0
  %v363 = select i1 %v362, i64 %v6, i64 0
  %v364 = add i64 %v363, %v361
  %v365 = mul i64 %v364, %v7
  %v366 = getelementptr i64, ptr %v5, i64 %v365
  %v367 = load i64, ptr %v366, align 8, !noalias !591
  %v368 = add nsw i64 %v367, -1
  store i64 %v368, ptr %v366, align 8, !noalias !591
  %v369 = load i64, ptr %v10, align 8, !noalias !591
  %v370 = icmp slt i64 %v369, 0
  %v371 = select i1 %v370, i64 %v6, i64 0
  %v372 = add i64 %v371, %v369
  %v373 = mul i64 %v372, %v7
  %v374 = getelementptr i64, ptr %v5, i64 %v373
  %v375 = getelementptr i8, ptr %v374, i64 24
  %v376 = load i64, ptr %v375, align 8, !noalias !591
  %v377 = add nsw i64 %v376, 1
  store i64 %v377, ptr %v375, align 8, !noalias !591
  store i64 -1, ptr %v20, align 8
  br label %v37

v37:
  %v378 = load i64, ptr %v20, align 8
  %v379 = icmp sgt i64 %v378, -1
  %v380 = zext i1 %v379 to i8
  store i8 %v380, ptr %v0, align 1
  br label %v35

v40:
  %v381 = fcmp ult double %v16, 0x3FB48E8A71DE69AD
  br i1 %v381, label %v39, label %v42

v42:
  %v382 = fcmp ult double %v16, 2.500000e-01
  br i1 %v382, label %v39, label %v45

v45:
  %v383 = fcmp ult double %v16, 3.333000e-01
  br i1 %v383, label %v39, label %v47

v47:
  %v384 = fcmp ult double %v16, 5.000000e-01
  br i1 %v384, label %v39, label %v43

v43:
  %v385 = fcmp ult double %v16, 0x3FE50A3D70A3D70A
  br i1 %v385, label %v39, label %v48

v48:
  %v386 = fcmp ult double %v16, 7.500000e-01
  br i1 %v386, label %v39, label %v46

v46:
  %v387 = fcmp ult double %v16, 8.889000e-01
  br i1 %v387, label %v39, label %v44

v44:
  br label %v39

v70:
  %v78 = phi i64 [ %v66, %v68 ], [ -1, %v65 ]
  store i64 %v78, ptr %v20, align 8
  %v388 = icmp eq i64 %v58, 7
  br i1 %v388, label %v53, label %v60

v96:
  %v389 = icmp slt i64 %v81, 0
  %v390 = select i1 %v389, i64 %v13, i64 0
  %v391 = add i64 %v390, %v81
  %v392 = mul i64 %v15, %v14
  %v393 = mul i64 %v392, %v391
  %v394 = getelementptr double, ptr %v12, i64 %v393
  %v395 = getelementptr double, ptr %v394, i64 %v15
  %v396 = shl i64 %v15, 4
  %v397 = getelementptr i8, ptr %v394, i64 %v396
  br label %v398

v398:
  %v399 = phi double [ 0x7FF0000000000000, %v96 ], [ %v400, %v398 ]
  %v401 = phi i64 [ 0, %v96 ], [ %v402, %v398 ]
  %v402 = add nsw i64 %v401, 1
  %v403 = getelementptr double, ptr %v395, i64 %v401
  %v404 = load double, ptr %v403, align 8, !noalias !594
  %v405 = getelementptr double, ptr %v397, i64 %v401
  %v406 = load double, ptr %v405, align 8, !noalias !594
  %v407 = fadd double %v404, %v406
  %v408 = fcmp olt double %v407, %v399
  %v400 = select i1 %v408, double %v407, double %v399
  %v409 = icmp eq i64 %v15, %v402
  br i1 %v409, label %v95, label %v398

v95:
  %v410 = phi double [ 0x7FF0000000000000, %v53 ], [ %v400, %v398 ]
  %v411 = fcmp olt double %v410, 0.000000e+00
  %v412 = select i1 %v411, double 0.000000e+00, double %v410
  %v413 = shl i64 %v9, 7
  %v414 = getelementptr i8, ptr %v8, i64 %v413
  store double %v412, ptr %v414, align 8
  %v415 = icmp slt i64 %v15, 1
  br i1 %v415, label %v416, label %v417

v417:
  %v418 = mul i64 %v15, %v79
  %v419 = mul i64 %v418, %v14
  %v420 = getelementptr double, ptr %v12, i64 %v419
  %v421 = getelementptr double, ptr %v420, i64 %v15
  %v422 = shl i64 %v15, 4
  %v423 = getelementptr i8, ptr %v420, i64 %v422
  br label %v424

v424:
  %v425 = phi double [ 0x7FF0000000000000, %v417 ], [ %v426, %v424 ]
  %v427 = phi i64 [ 0, %v417 ], [ %v428, %v424 ]
  %v428 = add nsw i64 %v427, 1
  %v429 = getelementptr double, ptr %v421, i64 %v427
  %v430 = load double, ptr %v429, align 8, !noalias !598
  %v431 = getelementptr double, ptr %v423, i64 %v427
  %v432 = load double, ptr %v431, align 8, !noalias !598
  %v433 = fadd double %v430, %v432
  %v434 = fcmp olt double %v433, %v425
  %v426 = select i1 %v434, double %v433, double %v425
  %v435 = icmp eq i64 %v15, %v428
  br i1 %v435, label %v416, label %v424

v416:
  %v436 = phi double [ 0x7FF0000000000000, %v95 ], [ %v426, %v424 ]
  %v437 = mul i64 %v9, 136
  %v438 = getelementptr i8, ptr %v8, i64 %v437
  store double %v436, ptr %v438, align 8
  %v439 = load i64, ptr %v20, align 8
  %v440 = icmp slt i64 %v439, 0
  %v109 = select i1 %v440, i64 %v79, i64 %v80
  br i1 %v18, label %v37, label %v441

v441:
  %v442 = load double, ptr %v8, align 8, !noalias !602
  %v443 = tail call double @llvm.fabs.f64(double %v442)
  %v444 = fmul double %v443, 4.000000e-15
  %v445 = getelementptr double, ptr %v3, i64 %v4
  %v446 = getelementptr i8, ptr %v445, i64 -8
  %v447 = load double, ptr %v446, align 8, !noalias !602
  %v448 = load double, ptr %v3, align 8, !noalias !602
  %v449 = fsub double %v447, %v448
  %v450 = fmul double %v449, 1.000000e-13
  %v451 = fcmp ogt double %v444, %v450
  %v452 = select i1 %v451, double %v444, double %v450
  %v453 = mul i64 %v9, 48
  %v454 = getelementptr i8, ptr %v8, i64 %v453
  %v102 = load double, ptr %v454, align 8
  %v455 = fmul double %v452, 2.000000e+00
  %v456 = fcmp ogt double %v102, %v455
  br i1 %v456, label %v97, label %v37

v38:
  store ptr %v352, ptr %v1, align 8
  br label %v35

v355:
  br i1 %v351, label %v37, label %v356
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.copysign.f64(double, double)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i1 @llvm.is.fpclass.f64(double, i32)

; Function Attrs: nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.start.p0(ptr)

; Function Attrs: nocallback nofree nosync nounwind willreturn memory(argmem: readwrite)
declare void @llvm.lifetime.end.p0(ptr)

define dso_local noundef i32 @evaluate_of_many(ptr noalias %v0, ptr noalias readnone %v1, ptr readnone %v2, ptr readnone %v3, i64 %v4, i64 %v5, ptr readonly %v6, i64 %v7, i64 %v8, i64 %v9, i64 %v10, i64 %v11, i64 %v12, ptr readnone %v13, ptr readnone %v14, i64 %v15, i64 %v16, ptr readonly %v17, i64 %v18, i64 %v19, ptr readnone %v20, ptr readnone %v21, i64 %v22, i64 %v23, ptr readonly %v24, i64 %v25, i64 %v26, ptr readnone %v27, ptr readnone %v28, i64 %v29, i64 %v30, ptr %v31, i64 %v32, i64 %v33, ptr readnone %v34, ptr readnone %v35, i64 %v36, i64 %v37, ptr %v38, i64 %v39, i64 %v40, ptr readnone %v41, ptr readnone %v42, i64 %v43, i64 %v44, ptr readonly %v45, i64 %v46, i64 %v47, ptr readnone %v48, ptr readnone %v49, i64 %v50, i64 %v51, ptr readonly %v52, i64 %v53, i64 %v54, i64 %v55, i64 %v56, ptr readnone %v57, ptr readnone %v58, i64 %v59, i64 %v60, ptr %v61, i64 %v62, i64 %v63, ptr readnone %v64, ptr readnone %v65, i64 %v66, i64 %v67, ptr %v68, i64 %v69, i64 %v70, ptr readnone %v71, ptr readnone %v72, i64 %v73, i64 %v74, ptr %v75, i64 %v76, i64 %v77, ptr readnone %v78, ptr readnone %v79, i64 %v80, i64 %v81, ptr %v82, i64 %v83, i64 %v84, ptr readnone %v85, ptr readnone %v86, i64 %v87, i64 %v88, ptr %v89, i64 %v90, i64 %v91, i64 %v92, i64 %v93) local_unnamed_addr {
v94:
  %v95 = icmp slt i64 %v18, 1
  br i1 %v95, label %v96, label %v97

v97:
  %v98 = icmp slt i64 %v46, 1
  %v99 = getelementptr i8, ptr %v6, i64 8
  %v100 = icmp eq i64 %v9, 0
  %v101 = icmp sgt i64 %v12, 0
  %v102 = select i1 %v100, i1 %v101, i1 false
  %v103 = getelementptr i8, ptr %v6, i64 32
  %v104 = getelementptr i8, ptr %v6, i64 8
  %v105 = icmp slt i64 %v9, 0
  %v106 = select i1 %v105, i64 %v7, i64 0
  %v107 = getelementptr i64, ptr %v6, i64 %v9
  %v108 = getelementptr i64, ptr %v107, i64 %v106
  %v109 = icmp slt i64 %v91, 1
  %v110 = icmp eq i64 %v9, 2
  %v111 = select i1 %v110, ptr %v75, ptr %v82
  br label %v112

v113:
  %v114 = icmp eq i64 %v115, %v18
  br i1 %v114, label %v96, label %v112

v116:
  br i1 %v98, label %v117, label %v118

v118:
  %v119 = icmp slt i64 %v120, 0
  %v121 = select i1 %v119, i64 %v53, i64 0
  %v122 = add i64 %v121, %v120
  %v123 = mul i64 %v122, %v54
  %v124 = getelementptr double, ptr %v52, i64 %v123
  br label %v125

v117:
  %v126 = load i64, ptr %v99, align 8
  %v127 = mul nsw i64 %v128, %v10
  %v129 = getelementptr double, ptr %v38, i64 %v127
  %v130 = inttoptr i64 %v126 to ptr
  tail call void %v130(ptr nonnull %v31, ptr %v129, ptr %v61, ptr %v68, ptr %v75, ptr %v75)
  br label %v131

v131:
  %v132 = phi i64 [ %v120, %v117 ], [ %v133, %v112 ]
  br i1 %v102, label %v134, label %v135

v134:
  %v136 = load i64, ptr %v103, align 8
  %v137 = mul nsw i64 %v128, %v10
  %v138 = getelementptr double, ptr %v38, i64 %v137
  %v139 = inttoptr i64 %v136 to ptr
  tail call void %v139(ptr nonnull %v31, ptr %v138, ptr %v61, ptr %v68, ptr %v75, ptr %v82)
  br label %v140

v141:
  %v142 = load i64, ptr %v104, align 8
  %v143 = inttoptr i64 %v142 to ptr
  tail call void %v143(ptr nonnull %v31, ptr %v138, ptr %v61, ptr %v68, ptr %v75, ptr %v75)
  br label %v135

v135:
  %v144 = load i64, ptr %v108, align 8
  %v145 = mul nsw i64 %v128, %v10
  %v146 = getelementptr double, ptr %v38, i64 %v145
  %v147 = inttoptr i64 %v144 to ptr
  tail call void %v147(ptr nonnull %v31, ptr %v146, ptr %v61, ptr %v68, ptr %v75, ptr %v82)
  br i1 %v109, label %v113, label %v148

v148:
  %v149 = mul i64 %v128, %v91
  %v150 = getelementptr double, ptr %v89, i64 %v149
  br label %v151

v96:
  store ptr null, ptr %v0, align 8
  ret i32 0

v112:
  %v133 = phi i64 [ -1, %v97 ], [ %v132, %v113 ]
  %v128 = phi i64 [ 0, %v97 ], [ %v115, %v113 ]
  %v115 = add nsw i64 %v128, 1
  %v152 = getelementptr double, ptr %v17, i64 %v128
  %v153 = load double, ptr %v152, align 8
  store double %v153, ptr %v31, align 8
  %v154 = getelementptr i64, ptr %v24, i64 %v128
  %v120 = load i64, ptr %v154, align 8
  %v155 = icmp eq i64 %v120, %v133
  br i1 %v155, label %v131, label %v116

v125:
  %v156 = phi i64 [ 0, %v118 ], [ %v157, %v125 ]
  %v157 = add nsw i64 %v156, 1
  %v158 = getelementptr double, ptr %v124, i64 %v156
  %v159 = load double, ptr %v158, align 8
  %v160 = getelementptr i64, ptr %v45, i64 %v156
  %v161 = load i64, ptr %v160, align 8
  %v162 = icmp slt i64 %v161, 0
  %v163 = select i1 %v162, i64 %v62, i64 0
  %v164 = getelementptr double, ptr %v61, i64 %v161
  %v165 = getelementptr double, ptr %v164, i64 %v163
  store double %v159, ptr %v165, align 8
  %v166 = icmp eq i64 %v46, %v157
  br i1 %v166, label %v117, label %v125

v140:
  %v167 = phi i64 [ 0, %v134 ], [ %v168, %v140 ]
  %v168 = add nsw i64 %v167, 1
  %v169 = getelementptr double, ptr %v82, i64 %v167
  %v170 = load double, ptr %v169, align 8
  %v171 = add nsw i64 %v167, %v11
  %v172 = icmp slt i64 %v171, 0
  %v173 = select i1 %v172, i64 %v62, i64 0
  %v174 = getelementptr double, ptr %v61, i64 %v171
  %v175 = getelementptr double, ptr %v174, i64 %v173
  store double %v170, ptr %v175, align 8
  %v176 = icmp eq i64 %v168, %v12
  br i1 %v176, label %v141, label %v140

v151:
  %v177 = phi i64 [ 0, %v148 ], [ %v178, %v151 ]
  %v178 = add nsw i64 %v177, 1
  %v179 = getelementptr double, ptr %v111, i64 %v177
  %v180 = load double, ptr %v179, align 8
  %v181 = getelementptr double, ptr %v150, i64 %v177
  store double %v180, ptr %v181, align 8
  %v182 = icmp eq i64 %v91, %v178
  br i1 %v182, label %v113, label %v151
}


!0 = !{!1}
!1 = distinct !{!1, !2, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!2 = distinct !{!2, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!3 = !{!4, !6, !1}
!4 = distinct !{!4, !5, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!5 = distinct !{!5, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!6 = distinct !{!6, !5, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!7 = !{!8, !10, !1}
!8 = distinct !{!8, !9, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!9 = distinct !{!9, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!10 = distinct !{!10, !9, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!11 = !{!12, !14}
!12 = distinct !{!12, !13, !"_ZN5pages12time_stepper14start_segmentsB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!13 = distinct !{!13, !"_ZN5pages12time_stepper14start_segmentsB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!14 = distinct !{!14, !13, !"_ZN5pages12time_stepper14start_segmentsB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!15 = !{!16, !12, !14}
!16 = distinct !{!16, !17, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!17 = distinct !{!17, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!18 = !{!19, !21, !23, !12, !14}
!19 = distinct !{!19, !20, !"_ZN5pages13solver_layout6decideB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_280_29: %retptr"}
!20 = distinct !{!20, !"_ZN5pages13solver_layout6decideB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_280_29"}
!21 = distinct !{!21, !22, !"_ZN5pages12event_checks17decisions_changedB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!22 = distinct !{!22, !"_ZN5pages12event_checks17decisions_changedB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!23 = distinct !{!23, !22, !"_ZN5pages12event_checks17decisions_changedB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!24 = !{!21, !23, !12, !14}
!25 = !{!26, !28, !30, !12, !14}
!26 = distinct !{!26, !27, !"_ZN5pages13solver_layout6decideB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_280_29: %retptr"}
!27 = distinct !{!27, !"_ZN5pages13solver_layout6decideB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_280_29"}
!28 = distinct !{!28, !29, !"_ZN5pages12event_checks14hold_decisionsB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!29 = distinct !{!29, !"_ZN5pages12event_checks14hold_decisionsB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!30 = distinct !{!30, !29, !"_ZN5pages12event_checks14hold_decisionsB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!31 = !{!28, !30, !12, !14}
!32 = !{!33, !28, !30, !12, !14}
!33 = distinct !{!33, !34, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!34 = distinct !{!34, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!35 = !{!36, !12, !14}
!36 = distinct !{!36, !37, !"_ZN5pages13solver_layout10derivativeB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29x: %retptr"}
!37 = distinct !{!37, !"_ZN5pages13solver_layout10derivativeB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29x"}
!38 = !{!39, !12, !14}
!39 = distinct !{!39, !40, !"_ZN5pages13solver_layout7formulaB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_287_29: %retptr"}
!40 = distinct !{!40, !"_ZN5pages13solver_layout7formulaB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_287_29"}
!41 = !{!42, !12, !14}
!42 = distinct !{!42, !43, !"_ZN5pages13solver_layout7formulaB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_288_29: %retptr"}
!43 = distinct !{!43, !"_ZN5pages13solver_layout7formulaB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_288_29"}
!44 = !{!45, !12, !14}
!45 = distinct !{!45, !46, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!46 = distinct !{!46, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!47 = !{!48, !12, !14}
!48 = distinct !{!48, !49, !"_ZN5pages13solver_layout7formulaB3v14B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!49 = distinct !{!49, !"_ZN5pages13solver_layout7formulaB3v14B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!50 = !{!51, !53, !12, !14}
!51 = distinct !{!51, !52, !"_ZN5pages8segments13begin_segmentB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!52 = distinct !{!52, !"_ZN5pages8segments13begin_segmentB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!53 = distinct !{!53, !52, !"_ZN5pages8segments13begin_segmentB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!54 = !{!55, !51, !53, !12, !14}
!55 = distinct !{!55, !56, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!56 = distinct !{!56, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!57 = !{!58, !60, !61, !63, !64, !66, !51, !53, !12, !14}
!58 = distinct !{!58, !59, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!59 = distinct !{!59, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!60 = distinct !{!60, !59, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!61 = distinct !{!61, !62, !"_ZN5pages8segments13first_outsideB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29: %retptr"}
!62 = distinct !{!62, !"_ZN5pages8segments13first_outsideB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29"}
!63 = distinct !{!63, !62, !"_ZN5pages8segments13first_outsideB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29: %excinfo"}
!64 = distinct !{!64, !65, !"_ZN5pages8segments12stop_outsideB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x23Literal_5bint_5d_280_29: %retptr"}
!65 = distinct !{!65, !"_ZN5pages8segments12stop_outsideB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x23Literal_5bint_5d_280_29"}
!66 = distinct !{!66, !65, !"_ZN5pages8segments12stop_outsideB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x23Literal_5bint_5d_280_29: %excinfo"}
!67 = !{!61, !63, !64, !66, !51, !53, !12, !14}
!68 = !{!69, !61, !63, !64, !66, !51, !53, !12, !14}
!69 = distinct !{!69, !70, !"_ZN5pages13solver_layout10derivativeB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2924Literal_5bint_5d_2814_29: %retptr"}
!70 = distinct !{!70, !"_ZN5pages13solver_layout10derivativeB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2924Literal_5bint_5d_2814_29"}
!71 = !{!72, !61, !63, !64, !66, !51, !53, !12, !14}
!72 = distinct !{!72, !73, !"_ZN5pages13solver_layout6decideB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_289_29: %retptr"}
!73 = distinct !{!73, !"_ZN5pages13solver_layout6decideB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_289_29"}
!74 = !{!75, !61, !63, !64, !66, !51, !53, !12, !14}
!75 = distinct !{!75, !76, !"_ZN5pages13solver_layout6decideB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29: %retptr"}
!76 = distinct !{!76, !"_ZN5pages13solver_layout6decideB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29"}
!77 = !{!64, !66, !51, !53, !12, !14}
!78 = !{!79, !64, !66, !51, !53, !12, !14}
!79 = distinct !{!79, !80, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!80 = distinct !{!80, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!81 = !{!82, !84, !51, !53, !12, !14}
!82 = distinct !{!82, !83, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!83 = distinct !{!83, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!84 = distinct !{!84, !83, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!85 = !{!86, !88, !90}
!86 = distinct !{!86, !87, !"_ZN5pages13solver_layout7formulaB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_285_29: %retptr"}
!87 = distinct !{!87, !"_ZN5pages13solver_layout7formulaB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_285_29"}
!88 = distinct !{!88, !89, !"_ZN5pages12time_stepper12attempt_stepB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!89 = distinct !{!89, !"_ZN5pages12time_stepper12attempt_stepB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!90 = distinct !{!90, !89, !"_ZN5pages12time_stepper12attempt_stepB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!91 = !{!92, !94, !95, !97}
!92 = distinct !{!92, !93, !"_ZN5pages12time_stepper11count_stepsB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!93 = distinct !{!93, !"_ZN5pages12time_stepper11count_stepsB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!94 = distinct !{!94, !93, !"_ZN5pages12time_stepper11count_stepsB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!95 = distinct !{!95, !96, !"_ZN5pages12time_stepper11check_lanesB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!96 = distinct !{!96, !"_ZN5pages12time_stepper11check_lanesB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!97 = distinct !{!97, !96, !"_ZN5pages12time_stepper11check_lanesB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!98 = !{!95, !97}
!99 = !{!100, !95, !97}
!100 = distinct !{!100, !101, !"_ZN5pages13solver_layout4failB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!101 = distinct !{!101, !"_ZN5pages13solver_layout4failB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!102 = !{!103, !105, !107}
!103 = distinct !{!103, !104, !"_ZN5pages13solver_layout10derivativeB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!104 = distinct !{!104, !"_ZN5pages13solver_layout10derivativeB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!105 = distinct !{!105, !106, !"_ZN5pages12time_stepper13handle_eventsB4v105B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb: %retptr"}
!106 = distinct !{!106, !"_ZN5pages12time_stepper13handle_eventsB4v105B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb"}
!107 = distinct !{!107, !106, !"_ZN5pages12time_stepper13handle_eventsB4v105B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb: %excinfo"}
!108 = !{!109, !105, !107}
!109 = distinct !{!109, !110, !"_ZN5pages13solver_layout7formulaB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2813_29: %retptr"}
!110 = distinct !{!110, !"_ZN5pages13solver_layout7formulaB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2813_29"}
!111 = !{!112, !105, !107}
!112 = distinct !{!112, !113, !"_ZN5pages13solver_layout7formulaB3v50B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2812_29: %retptr"}
!113 = distinct !{!113, !"_ZN5pages13solver_layout7formulaB3v50B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2812_29"}
!114 = !{!115, !117, !118, !120, !121, !123, !105, !107}
!115 = distinct !{!115, !116, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!116 = distinct !{!116, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!117 = distinct !{!117, !116, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!118 = distinct !{!118, !119, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!119 = distinct !{!119, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!120 = distinct !{!120, !119, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!121 = distinct !{!121, !122, !"_ZN5pages12event_checks10comes_nearB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!122 = distinct !{!122, !"_ZN5pages12event_checks10comes_nearB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!123 = distinct !{!123, !122, !"_ZN5pages12event_checks10comes_nearB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!124 = !{!125, !127, !115, !117, !118, !120, !121, !123, !105, !107}
!125 = distinct !{!125, !126, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!126 = distinct !{!126, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!127 = distinct !{!127, !126, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!128 = !{!129, !118, !120, !121, !123, !105, !107}
!129 = distinct !{!129, !130, !"_ZN5pages13solver_layout6decideB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!130 = distinct !{!130, !"_ZN5pages13solver_layout6decideB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!131 = !{!"branch_weights", i32 99, i32 1}
!132 = !{!133, !135, !137, !105, !107}
!133 = distinct !{!133, !134, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!134 = distinct !{!134, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!135 = distinct !{!135, !136, !"_ZN5pages12time_stepper18interpolant_stagesB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!136 = distinct !{!136, !"_ZN5pages12time_stepper18interpolant_stagesB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!137 = distinct !{!137, !136, !"_ZN5pages12time_stepper18interpolant_stagesB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!138 = !{!139, !135, !137, !105, !107}
!139 = distinct !{!139, !140, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!140 = distinct !{!140, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!141 = !{!142, !135, !137, !105, !107}
!142 = distinct !{!142, !143, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!143 = distinct !{!143, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!144 = !{!145, !105, !107}
!145 = distinct !{!145, !146, !"_ZN5pages13solver_layout7formulaB3v59B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2811_29: %retptr"}
!146 = distinct !{!146, !"_ZN5pages13solver_layout7formulaB3v59B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2811_29"}
!147 = !{!148, !150, !105, !107}
!148 = distinct !{!148, !149, !"_ZN5pages12time_stepper17check_interpolantB3v60B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!149 = distinct !{!149, !"_ZN5pages12time_stepper17check_interpolantB3v60B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!150 = distinct !{!150, !149, !"_ZN5pages12time_stepper17check_interpolantB3v60B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!151 = !{!152, !148, !150, !105, !107}
!152 = distinct !{!152, !153, !"_ZN5pages13solver_layout5retryB3v61B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd: %retptr"}
!153 = distinct !{!153, !"_ZN5pages13solver_layout5retryB3v61B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd"}
!154 = !{!155, !157, !105, !107}
!155 = distinct !{!155, !156, !"_ZN5pages12event_checks12check_eventsB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!156 = distinct !{!156, !"_ZN5pages12event_checks12check_eventsB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!157 = distinct !{!157, !156, !"_ZN5pages12event_checks12check_eventsB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!158 = !{!159, !161, !162, !164, !155, !157, !105, !107}
!159 = distinct !{!159, !160, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!160 = distinct !{!160, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!161 = distinct !{!161, !160, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!162 = distinct !{!162, !163, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!163 = distinct !{!163, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!164 = distinct !{!164, !163, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!165 = !{!166, !168, !159, !161, !162, !164, !155, !157, !105, !107}
!166 = distinct !{!166, !167, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!167 = distinct !{!167, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!168 = distinct !{!168, !167, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!169 = !{!170, !162, !164, !155, !157, !105, !107}
!170 = distinct !{!170, !171, !"_ZN5pages13solver_layout6decideB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!171 = distinct !{!171, !"_ZN5pages13solver_layout6decideB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!172 = !{!173, !175, !176, !178, !155, !157, !105, !107}
!173 = distinct !{!173, !174, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!174 = distinct !{!174, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!175 = distinct !{!175, !174, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!176 = distinct !{!176, !177, !"_ZN5pages12event_checks9set_edgesB3v63B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!177 = distinct !{!177, !"_ZN5pages12event_checks9set_edgesB3v63B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!178 = distinct !{!178, !177, !"_ZN5pages12event_checks9set_edgesB3v63B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!179 = !{!176, !178, !155, !157, !105, !107}
!180 = !{!181, !183, !105, !107}
!181 = distinct !{!181, !182, !"_ZN5pages14event_location13locate_eventsB3v71B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!182 = distinct !{!182, !"_ZN5pages14event_location13locate_eventsB3v71B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!183 = distinct !{!183, !182, !"_ZN5pages14event_location13locate_eventsB3v71B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!184 = !{!185, !187, !188, !181, !183, !105, !107}
!185 = distinct !{!185, !186, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %retptr"}
!186 = distinct !{!186, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx"}
!187 = distinct !{!187, !186, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %excinfo"}
!188 = distinct !{!188, !189, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!189 = distinct !{!189, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!190 = !{!188, !181, !183, !105, !107}
!191 = !{!192, !194, !195, !197, !188, !181, !183, !105, !107}
!192 = distinct !{!192, !193, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!193 = distinct !{!193, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!194 = distinct !{!194, !193, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!195 = distinct !{!195, !196, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!196 = distinct !{!196, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!197 = distinct !{!197, !196, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!198 = !{!199, !201, !192, !194, !195, !197, !188, !181, !183, !105, !107}
!199 = distinct !{!199, !200, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!200 = distinct !{!200, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!201 = distinct !{!201, !200, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!202 = !{!203, !195, !197, !188, !181, !183, !105, !107}
!203 = distinct !{!203, !204, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!204 = distinct !{!204, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!205 = !{!195, !197, !188, !181, !183, !105, !107}
!206 = !{!207, !209, !188, !181, !183, !105, !107}
!207 = distinct !{!207, !208, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!208 = distinct !{!208, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!209 = distinct !{!209, !208, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!210 = !{!211, !213, !181, !183, !105, !107}
!211 = distinct !{!211, !212, !"_ZN5pages14event_location9stops_runB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!212 = distinct !{!212, !"_ZN5pages14event_location9stops_runB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!213 = distinct !{!213, !212, !"_ZN5pages14event_location9stops_runB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!214 = !{!215, !217, !218, !220, !211, !213, !181, !183, !105, !107}
!215 = distinct !{!215, !216, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!216 = distinct !{!216, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!217 = distinct !{!217, !216, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!218 = distinct !{!218, !219, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!219 = distinct !{!219, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!220 = distinct !{!220, !219, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!221 = !{!222, !224, !215, !217, !218, !220, !211, !213, !181, !183, !105, !107}
!222 = distinct !{!222, !223, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!223 = distinct !{!223, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!224 = distinct !{!224, !223, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!225 = !{!226, !218, !220, !211, !213, !181, !183, !105, !107}
!226 = distinct !{!226, !227, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!227 = distinct !{!227, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!228 = !{!218, !220, !211, !213, !181, !183, !105, !107}
!229 = !{!230, !232, !233, !235, !236, !238, !211, !213, !181, !183, !105, !107}
!230 = distinct !{!230, !231, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!231 = distinct !{!231, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!232 = distinct !{!232, !231, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!233 = distinct !{!233, !234, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!234 = distinct !{!234, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!235 = distinct !{!235, !234, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!236 = distinct !{!236, !237, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!237 = distinct !{!237, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!238 = distinct !{!238, !237, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!239 = !{!233, !235, !236, !238, !211, !213, !181, !183, !105, !107}
!240 = !{!241, !236, !238, !211, !213, !181, !183, !105, !107}
!241 = distinct !{!241, !242, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!242 = distinct !{!242, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!243 = !{!236, !238, !211, !213, !181, !183, !105, !107}
!244 = !{!245, !247, !248, !211, !213, !181, !183, !105, !107}
!245 = distinct !{!245, !246, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %retptr"}
!246 = distinct !{!246, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx"}
!247 = distinct !{!247, !246, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %excinfo"}
!248 = distinct !{!248, !249, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!249 = distinct !{!249, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!250 = !{!248, !211, !213, !181, !183, !105, !107}
!251 = !{!252, !254, !255, !257, !248, !211, !213, !181, !183, !105, !107}
!252 = distinct !{!252, !253, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!253 = distinct !{!253, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!254 = distinct !{!254, !253, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!255 = distinct !{!255, !256, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!256 = distinct !{!256, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!257 = distinct !{!257, !256, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!258 = !{!259, !261, !252, !254, !255, !257, !248, !211, !213, !181, !183, !105, !107}
!259 = distinct !{!259, !260, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!260 = distinct !{!260, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!261 = distinct !{!261, !260, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!262 = !{!263, !255, !257, !248, !211, !213, !181, !183, !105, !107}
!263 = distinct !{!263, !264, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!264 = distinct !{!264, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!265 = !{!255, !257, !248, !211, !213, !181, !183, !105, !107}
!266 = !{!267, !269, !248, !211, !213, !181, !183, !105, !107}
!267 = distinct !{!267, !268, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!268 = distinct !{!268, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!269 = distinct !{!269, !268, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!270 = !{!271, !273, !211, !213, !181, !183, !105, !107}
!271 = distinct !{!271, !272, !"_ZN5pages8segments19write_samples_untilB3v80B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!272 = distinct !{!272, !"_ZN5pages8segments19write_samples_untilB3v80B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!273 = distinct !{!273, !272, !"_ZN5pages8segments19write_samples_untilB3v80B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %excinfo"}
!274 = !{!275, !211, !213, !181, !183, !105, !107}
!275 = distinct !{!275, !276, !"_ZN5pages13solver_layout4failB3v81B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29: %retptr"}
!276 = distinct !{!276, !"_ZN5pages13solver_layout4failB3v81B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29"}
!277 = !{!278, !280, !271, !273, !211, !213, !181, !183, !105, !107}
!278 = distinct !{!278, !279, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!279 = distinct !{!279, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!280 = distinct !{!280, !279, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!281 = !{!282, !284, !211, !213, !181, !183, !105, !107}
!282 = distinct !{!282, !283, !"_ZN5pages12event_checks13first_crossedB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!283 = distinct !{!283, !"_ZN5pages12event_checks13first_crossedB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!284 = distinct !{!284, !283, !"_ZN5pages12event_checks13first_crossedB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!285 = !{!286, !288, !181, !183, !105, !107}
!286 = distinct !{!286, !287, !"_ZN5pages14event_location11pass_eventsB3v82B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!287 = distinct !{!287, !"_ZN5pages14event_location11pass_eventsB3v82B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!288 = distinct !{!288, !287, !"_ZN5pages14event_location11pass_eventsB3v82B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!289 = !{!290, !292, !293, !295, !286, !288, !181, !183, !105, !107}
!290 = distinct !{!290, !291, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!291 = distinct !{!291, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!292 = distinct !{!292, !291, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!293 = distinct !{!293, !294, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!294 = distinct !{!294, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!295 = distinct !{!295, !294, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!296 = !{!297, !299, !290, !292, !293, !295, !286, !288, !181, !183, !105, !107}
!297 = distinct !{!297, !298, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!298 = distinct !{!298, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!299 = distinct !{!299, !298, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!300 = !{!301, !293, !295, !286, !288, !181, !183, !105, !107}
!301 = distinct !{!301, !302, !"_ZN5pages13solver_layout6decideB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!302 = distinct !{!302, !"_ZN5pages13solver_layout6decideB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!303 = !{!304, !286, !288, !181, !183, !105, !107}
!304 = distinct !{!304, !305, !"_ZN5pages13solver_layout10derivativeB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!305 = distinct !{!305, !"_ZN5pages13solver_layout10derivativeB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!306 = !{!307, !309, !310, !286, !288, !181, !183, !105, !107}
!307 = distinct !{!307, !308, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %retptr"}
!308 = distinct !{!308, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx"}
!309 = distinct !{!309, !308, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %excinfo"}
!310 = distinct !{!310, !311, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!311 = distinct !{!311, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!312 = !{!310, !286, !288, !181, !183, !105, !107}
!313 = !{!314, !316, !317, !319, !310, !286, !288, !181, !183, !105, !107}
!314 = distinct !{!314, !315, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!315 = distinct !{!315, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!316 = distinct !{!316, !315, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!317 = distinct !{!317, !318, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!318 = distinct !{!318, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!319 = distinct !{!319, !318, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!320 = !{!321, !323, !314, !316, !317, !319, !310, !286, !288, !181, !183, !105, !107}
!321 = distinct !{!321, !322, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!322 = distinct !{!322, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!323 = distinct !{!323, !322, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!324 = !{!325, !317, !319, !310, !286, !288, !181, !183, !105, !107}
!325 = distinct !{!325, !326, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!326 = distinct !{!326, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!327 = !{!317, !319, !310, !286, !288, !181, !183, !105, !107}
!328 = !{!329, !331, !310, !286, !288, !181, !183, !105, !107}
!329 = distinct !{!329, !330, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!330 = distinct !{!330, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!331 = distinct !{!331, !330, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!332 = !{!333, !335, !337, !286, !288, !181, !183, !105, !107}
!333 = distinct !{!333, !334, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!334 = distinct !{!334, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!335 = distinct !{!335, !336, !"_ZN5pages14event_location18exchange_decisionsB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %retptr"}
!336 = distinct !{!336, !"_ZN5pages14event_location18exchange_decisionsB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29"}
!337 = distinct !{!337, !336, !"_ZN5pages14event_location18exchange_decisionsB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %excinfo"}
!338 = !{!335, !337, !286, !288, !181, !183, !105, !107}
!339 = !{!340, !342, !286, !288, !181, !183, !105, !107}
!340 = distinct !{!340, !341, !"_ZN5pages14event_location12rates_changeB3v83B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!341 = distinct !{!341, !"_ZN5pages14event_location12rates_changeB3v83B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!342 = distinct !{!342, !341, !"_ZN5pages14event_location12rates_changeB3v83B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!343 = !{!344, !346, !347, !349, !340, !342, !286, !288, !181, !183, !105, !107}
!344 = distinct !{!344, !345, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!345 = distinct !{!345, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!346 = distinct !{!346, !345, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!347 = distinct !{!347, !348, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!348 = distinct !{!348, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!349 = distinct !{!349, !348, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!350 = !{!351, !353, !344, !346, !347, !349, !340, !342, !286, !288, !181, !183, !105, !107}
!351 = distinct !{!351, !352, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!352 = distinct !{!352, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!353 = distinct !{!353, !352, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!354 = !{!355, !347, !349, !340, !342, !286, !288, !181, !183, !105, !107}
!355 = distinct !{!355, !356, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!356 = distinct !{!356, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!357 = !{!347, !349, !340, !342, !286, !288, !181, !183, !105, !107}
!358 = !{!359, !361, !340, !342, !286, !288, !181, !183, !105, !107}
!359 = distinct !{!359, !360, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!360 = distinct !{!360, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!361 = distinct !{!361, !360, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!362 = !{!363, !365, !359, !361, !340, !342, !286, !288, !181, !183, !105, !107}
!363 = distinct !{!363, !364, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!364 = distinct !{!364, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!365 = distinct !{!365, !364, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!366 = !{!367, !369, !371, !340, !342, !286, !288, !181, !183, !105, !107}
!367 = distinct !{!367, !368, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!368 = distinct !{!368, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!369 = distinct !{!369, !370, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!370 = distinct !{!370, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!371 = distinct !{!371, !370, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!372 = !{!369, !371, !340, !342, !286, !288, !181, !183, !105, !107}
!373 = !{!374, !376, !378, !340, !342, !286, !288, !181, !183, !105, !107}
!374 = distinct !{!374, !375, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!375 = distinct !{!375, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!376 = distinct !{!376, !377, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!377 = distinct !{!377, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!378 = distinct !{!378, !377, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!379 = !{!376, !378, !340, !342, !286, !288, !181, !183, !105, !107}
!380 = !{!381, !340, !342, !286, !288, !181, !183, !105, !107}
!381 = distinct !{!381, !382, !"_ZN5pages13solver_layout10derivativeB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2814_29: %retptr"}
!382 = distinct !{!382, !"_ZN5pages13solver_layout10derivativeB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2814_29"}
!383 = !{!384, !386, !388, !340, !342, !286, !288, !181, !183, !105, !107}
!384 = distinct !{!384, !385, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!385 = distinct !{!385, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!386 = distinct !{!386, !387, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!387 = distinct !{!387, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!388 = distinct !{!388, !387, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!389 = !{!390, !340, !342, !286, !288, !181, !183, !105, !107}
!390 = distinct !{!390, !391, !"_ZN5pages13solver_layout10derivativeB3v86B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2815_29: %retptr"}
!391 = distinct !{!391, !"_ZN5pages13solver_layout10derivativeB3v86B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2815_29"}
!392 = !{!393, !395, !340, !342, !286, !288, !181, !183, !105, !107}
!393 = distinct !{!393, !394, !"_ZN5pages14event_location12rates_differB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!394 = distinct !{!394, !"_ZN5pages14event_location12rates_differB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!395 = distinct !{!395, !394, !"_ZN5pages14event_location12rates_differB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!396 = !{!386, !388, !340, !342, !286, !288, !181, !183, !105, !107}
!397 = !{!"branch_weights", i32 1, i32 99}
!398 = !{!"branch_weights", i32 101, i32 99}
!399 = !{!400, !402, !181, !183, !105, !107}
!400 = distinct !{!400, !401, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!401 = distinct !{!401, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!402 = distinct !{!402, !401, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!403 = !{!404, !406, !407, !409, !181, !183, !105, !107}
!404 = distinct !{!404, !405, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!405 = distinct !{!405, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!406 = distinct !{!406, !405, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!407 = distinct !{!407, !408, !"_ZN5pages14event_location8end_stepB3v89B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!408 = distinct !{!408, !"_ZN5pages14event_location8end_stepB3v89B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!409 = distinct !{!409, !408, !"_ZN5pages14event_location8end_stepB3v89B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!410 = !{!411, !413, !404, !406, !407, !409, !181, !183, !105, !107}
!411 = distinct !{!411, !412, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!412 = distinct !{!412, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!413 = distinct !{!413, !412, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!414 = !{!407, !409, !181, !183, !105, !107}
!415 = !{!416, !407, !409, !181, !183, !105, !107}
!416 = distinct !{!416, !417, !"_ZN5pages13solver_layout10derivativeB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!417 = distinct !{!417, !"_ZN5pages13solver_layout10derivativeB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!418 = !{!419, !407, !409, !181, !183, !105, !107}
!419 = distinct !{!419, !420, !"_ZN5pages13solver_layout6decideB3v90B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_288_29: %retptr"}
!420 = distinct !{!420, !"_ZN5pages13solver_layout6decideB3v90B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_288_29"}
!421 = !{!422, !181, !183, !105, !107}
!422 = distinct !{!422, !423, !"_ZN5pages13solver_layout5retryB3v70B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!423 = distinct !{!423, !"_ZN5pages13solver_layout5retryB3v70B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!424 = !{!121, !123, !105, !107}
!425 = !{!426, !428, !121, !123, !105, !107}
!426 = distinct !{!426, !427, !"_ZN5pages12event_checks13error_betweenB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!427 = distinct !{!427, !"_ZN5pages12event_checks13error_betweenB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!428 = distinct !{!428, !427, !"_ZN5pages12event_checks13error_betweenB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!429 = !{!430}
!430 = distinct !{!430, !431, !"_ZN5pages12time_stepper13write_samplesB3v91B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29b: %retptr"}
!431 = distinct !{!431, !"_ZN5pages12time_stepper13write_samplesB3v91B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29b"}
!432 = !{!433, !435, !430}
!433 = distinct !{!433, !434, !"_ZN5pages8segments19write_samples_untilB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd: %retptr"}
!434 = distinct !{!434, !"_ZN5pages8segments19write_samples_untilB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd"}
!435 = distinct !{!435, !434, !"_ZN5pages8segments19write_samples_untilB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd: %excinfo"}
!436 = !{!437, !439, !433, !435, !430}
!437 = distinct !{!437, !438, !"_ZN5pages13solver_layout11interpolateB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd: %retptr"}
!438 = distinct !{!438, !"_ZN5pages13solver_layout11interpolateB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd"}
!439 = distinct !{!439, !438, !"_ZN5pages13solver_layout11interpolateB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd: %excinfo"}
!440 = !{!441}
!441 = distinct !{!441, !442, !"_ZN5pages13solver_layout7formulaB3v94B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %retptr"}
!442 = distinct !{!442, !"_ZN5pages13solver_layout7formulaB3v94B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29"}
!443 = !{!444, !446}
!444 = distinct !{!444, !445, !"_ZN5pages14event_location20restart_behind_eventB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!445 = distinct !{!445, !"_ZN5pages14event_location20restart_behind_eventB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!446 = distinct !{!446, !445, !"_ZN5pages14event_location20restart_behind_eventB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!447 = !{!448, !444, !446}
!448 = distinct !{!448, !449, !"_ZN5pages13solver_layout4failB3v81B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29: %retptr"}
!449 = distinct !{!449, !"_ZN5pages13solver_layout4failB3v81B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29"}
!450 = !{!451, !453}
!451 = distinct !{!451, !452, !"_ZN5pages8segments14at_segment_endB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!452 = distinct !{!452, !"_ZN5pages8segments14at_segment_endB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!453 = distinct !{!453, !454, !"_ZN5pages8segments11jump_statesB3v96B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!454 = distinct !{!454, !"_ZN5pages8segments11jump_statesB3v96B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!455 = !{!453}
!456 = !{!457, !459, !453}
!457 = distinct !{!457, !458, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!458 = distinct !{!458, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!459 = distinct !{!459, !458, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!460 = !{!461, !453}
!461 = distinct !{!461, !462, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!462 = distinct !{!462, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!463 = !{!464, !453}
!464 = distinct !{!464, !465, !"_ZN5pages8segments14at_segment_endB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!465 = distinct !{!465, !"_ZN5pages8segments14at_segment_endB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!466 = !{!467, !469, !453}
!467 = distinct !{!467, !468, !"_ZN5pages8segments11accept_jumpB3v98B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!468 = distinct !{!468, !"_ZN5pages8segments11accept_jumpB3v98B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!469 = distinct !{!469, !468, !"_ZN5pages8segments11accept_jumpB3v98B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!470 = !{!471, !467, !469, !453}
!471 = distinct !{!471, !472, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!472 = distinct !{!472, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!473 = !{!474, !476, !477, !479, !480, !482, !467, !469, !453}
!474 = distinct !{!474, !475, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!475 = distinct !{!475, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!476 = distinct !{!476, !475, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!477 = distinct !{!477, !478, !"_ZN5pages8segments13first_outsideB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2817_29: %retptr"}
!478 = distinct !{!478, !"_ZN5pages8segments13first_outsideB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2817_29"}
!479 = distinct !{!479, !478, !"_ZN5pages8segments13first_outsideB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2817_29: %excinfo"}
!480 = distinct !{!480, !481, !"_ZN5pages8segments12stop_outsideB3v99B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29: %retptr"}
!481 = distinct !{!481, !"_ZN5pages8segments12stop_outsideB3v99B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29"}
!482 = distinct !{!482, !481, !"_ZN5pages8segments12stop_outsideB3v99B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29: %excinfo"}
!483 = !{!477, !479, !480, !482, !467, !469, !453}
!484 = !{!485, !477, !479, !480, !482, !467, !469, !453}
!485 = distinct !{!485, !486, !"_ZN5pages13solver_layout10derivativeB4v101B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2814_29: %retptr"}
!486 = distinct !{!486, !"_ZN5pages13solver_layout10derivativeB4v101B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2814_29"}
!487 = !{!488, !477, !479, !480, !482, !467, !469, !453}
!488 = distinct !{!488, !489, !"_ZN5pages13solver_layout6decideB4v102B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_289_29: %retptr"}
!489 = distinct !{!489, !"_ZN5pages13solver_layout6decideB4v102B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_289_29"}
!490 = !{!491, !477, !479, !480, !482, !467, !469, !453}
!491 = distinct !{!491, !492, !"_ZN5pages13solver_layout6decideB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29: %retptr"}
!492 = distinct !{!492, !"_ZN5pages13solver_layout6decideB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29"}
!493 = !{!480, !482, !467, !469, !453}
!494 = !{!495, !480, !482, !467, !469, !453}
!495 = distinct !{!495, !496, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!496 = distinct !{!496, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!497 = !{!498, !500}
!498 = distinct !{!498, !499, !"_ZN5pages12time_stepper12end_segmentsB4v103B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!499 = distinct !{!499, !"_ZN5pages12time_stepper12end_segmentsB4v103B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!500 = distinct !{!500, !499, !"_ZN5pages12time_stepper12end_segmentsB4v103B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!501 = !{!502, !498, !500}
!502 = distinct !{!502, !503, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!503 = distinct !{!503, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!504 = !{!505, !507, !498, !500}
!505 = distinct !{!505, !506, !"_ZN5pages8segments13enter_segmentB4v104B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!506 = distinct !{!506, !"_ZN5pages8segments13enter_segmentB4v104B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!507 = distinct !{!507, !506, !"_ZN5pages8segments13enter_segmentB4v104B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!508 = !{!509, !511, !505, !507, !498, !500}
!509 = distinct !{!509, !510, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!510 = distinct !{!510, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!511 = distinct !{!511, !510, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!512 = !{!513, !498, !500}
!513 = distinct !{!513, !514, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!514 = distinct !{!514, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!515 = !{!516, !518, !513, !498, !500}
!516 = distinct !{!516, !517, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!517 = distinct !{!517, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!518 = distinct !{!518, !517, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!519 = !{!520, !522, !513, !498, !500}
!520 = distinct !{!520, !521, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!521 = distinct !{!521, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!522 = distinct !{!522, !521, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!523 = !{!524, !526, !498, !500}
!524 = distinct !{!524, !525, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!525 = distinct !{!525, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!526 = distinct !{!526, !525, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!527 = !{!528, !530}
!528 = distinct !{!528, !529, !"_ZN5pages12time_stepper11count_stepsB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!529 = distinct !{!529, !"_ZN5pages12time_stepper11count_stepsB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!530 = distinct !{!530, !529, !"_ZN5pages12time_stepper11count_stepsB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!531 = !{!532, !88, !90}
!532 = distinct !{!532, !533, !"_ZN5pages13solver_layout10derivativeB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_281_29: %retptr"}
!533 = distinct !{!533, !"_ZN5pages13solver_layout10derivativeB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_281_29"}
!534 = !{!535, !537, !88, !90}
!535 = distinct !{!535, !536, !"_ZN5pages8implicit13factor_matrixB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!536 = distinct !{!536, !"_ZN5pages8implicit13factor_matrixB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!537 = distinct !{!537, !536, !"_ZN5pages8implicit13factor_matrixB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!538 = !{!539, !541, !542, !535, !537, !88, !90}
!539 = distinct !{!539, !540, !"_ZN5pages8implicit11set_changesB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!540 = distinct !{!540, !"_ZN5pages8implicit11set_changesB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE"}
!541 = distinct !{!541, !540, !"_ZN5pages8implicit11set_changesB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!542 = distinct !{!542, !543, !"_ZN5pages8implicit13differentiateB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!543 = distinct !{!543, !"_ZN5pages8implicit13differentiateB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!544 = !{!542, !535, !537, !88, !90}
!545 = !{!546, !548, !542, !535, !537, !88, !90}
!546 = distinct !{!546, !547, !"_ZN5pages8implicit16difference_ratesB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!547 = distinct !{!547, !"_ZN5pages8implicit16difference_ratesB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!548 = distinct !{!548, !547, !"_ZN5pages8implicit16difference_ratesB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!549 = !{!550, !546, !548, !542, !535, !537, !88, !90}
!550 = distinct !{!550, !551, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!551 = distinct !{!551, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!552 = !{!553, !535, !537, !88, !90}
!553 = distinct !{!553, !554, !"_ZN5pages8implicit6factorB3v36B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!554 = distinct !{!554, !"_ZN5pages8implicit6factorB3v36B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!555 = !{!556, !558, !559, !88, !90}
!556 = distinct !{!556, !557, !"_ZN5pages8implicit12find_nonzeroB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx450Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!557 = distinct !{!557, !"_ZN5pages8implicit12find_nonzeroB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx450Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedEx"}
!558 = distinct !{!558, !557, !"_ZN5pages8implicit12find_nonzeroB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx450Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!559 = distinct !{!559, !560, !"_ZN5pages8implicit11solve_stageB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!560 = distinct !{!560, !"_ZN5pages8implicit11solve_stageB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!561 = !{!559, !88, !90}
!562 = !{!563, !565, !559, !88, !90}
!563 = distinct !{!563, !564, !"_ZN5pages8implicit5solveB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!564 = distinct !{!564, !"_ZN5pages8implicit5solveB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!565 = distinct !{!565, !564, !"_ZN5pages8implicit5solveB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!566 = !{!567, !88, !90}
!567 = distinct !{!567, !568, !"_ZN5pages13solver_layout7formulaB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_286_29: %retptr"}
!568 = distinct !{!568, !"_ZN5pages13solver_layout7formulaB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_286_29"}
!569 = !{!570, !88, !90}
!570 = distinct !{!570, !571, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!571 = distinct !{!571, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!572 = !{!573, !88, !90}
!573 = distinct !{!573, !574, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!574 = distinct !{!574, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!575 = !{!576, !578}
!576 = distinct !{!576, !577, !"_ZN5pages12event_checks13first_crossedB3v65B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!577 = distinct !{!577, !"_ZN5pages12event_checks13first_crossedB3v65B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!578 = distinct !{!578, !577, !"_ZN5pages12event_checks13first_crossedB3v65B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!579 = !{!580, !582, !583, !585}
!580 = distinct !{!580, !581, !"_ZN5pages12event_checks13error_betweenB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!581 = distinct !{!581, !"_ZN5pages12event_checks13error_betweenB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!582 = distinct !{!582, !581, !"_ZN5pages12event_checks13error_betweenB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!583 = distinct !{!583, !584, !"_ZN5pages12event_checks8may_hideB3v68B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd: %retptr"}
!584 = distinct !{!584, !"_ZN5pages12event_checks8may_hideB3v68B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd"}
!585 = distinct !{!585, !584, !"_ZN5pages12event_checks8may_hideB3v68B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd: %excinfo"}
!586 = !{!583, !585}
!587 = !{!588, !590, !583, !585}
!588 = distinct !{!588, !589, !"_ZN5pages12event_checks17least_distance_ofB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd: %retptr"}
!589 = distinct !{!589, !"_ZN5pages12event_checks17least_distance_ofB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd"}
!590 = distinct !{!590, !589, !"_ZN5pages12event_checks17least_distance_ofB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd: %excinfo"}
!591 = !{!592}
!592 = distinct !{!592, !593, !"_ZN5pages13solver_layout5retryB3v70B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!593 = distinct !{!593, !"_ZN5pages13solver_layout5retryB3v70B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!594 = !{!595, !597}
!595 = distinct !{!595, !596, !"_ZN5pages12event_checks14least_distanceB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!596 = distinct !{!596, !"_ZN5pages12event_checks14least_distanceB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!597 = distinct !{!597, !596, !"_ZN5pages12event_checks14least_distanceB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!598 = !{!599, !601}
!599 = distinct !{!599, !600, !"_ZN5pages12event_checks14least_distanceB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!600 = distinct !{!600, !"_ZN5pages12event_checks14least_distanceB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!601 = distinct !{!601, !600, !"_ZN5pages12event_checks14least_distanceB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!602 = !{!603, !605}
!603 = distinct !{!603, !604, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!604 = distinct !{!604, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!605 = distinct !{!605, !604, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}

define i64 @advance(ptr %v0) {
  %v1 = alloca i64
  %v2 = alloca ptr
  %v3 = getelementptr i64, ptr %v0, i64 0
  %v4 = load ptr, ptr %v3
  %v5 = getelementptr i64, ptr %v0, i64 1
  %v6 = load ptr, ptr %v5
  %v7 = getelementptr i64, ptr %v0, i64 2
  %v8 = load i64, ptr %v7
  %v9 = getelementptr i64, ptr %v0, i64 3
  %v10 = load i64, ptr %v9
  %v11 = getelementptr i64, ptr %v0, i64 4
  %v12 = load ptr, ptr %v11
  %v13 = getelementptr i64, ptr %v0, i64 5
  %v14 = load i64, ptr %v13
  %v15 = getelementptr i64, ptr %v0, i64 6
  %v16 = load i64, ptr %v15
  %v17 = getelementptr i64, ptr %v0, i64 7
  %v18 = load i64, ptr %v17
  %v19 = getelementptr i64, ptr %v0, i64 8
  %v20 = load i64, ptr %v19
  %v21 = getelementptr i64, ptr %v0, i64 9
  %v22 = load i64, ptr %v21
  %v23 = getelementptr i64, ptr %v0, i64 10
  %v24 = load i64, ptr %v23
  %v25 = getelementptr i64, ptr %v0, i64 11
  %v26 = load i64, ptr %v25
  %v27 = getelementptr i64, ptr %v0, i64 12
  %v28 = load i64, ptr %v27
  %v29 = getelementptr i64, ptr %v0, i64 13
  %v30 = load i64, ptr %v29
  %v31 = getelementptr i64, ptr %v0, i64 14
  %v32 = load i64, ptr %v31
  %v33 = getelementptr i64, ptr %v0, i64 15
  %v34 = load i64, ptr %v33
  %v35 = getelementptr i64, ptr %v0, i64 16
  %v36 = load i64, ptr %v35
  %v37 = getelementptr i64, ptr %v0, i64 17
  %v38 = load i64, ptr %v37
  %v39 = getelementptr i64, ptr %v0, i64 18
  %v40 = load ptr, ptr %v39
  %v41 = getelementptr i64, ptr %v0, i64 19
  %v42 = load ptr, ptr %v41
  %v43 = getelementptr i64, ptr %v0, i64 20
  %v44 = load i64, ptr %v43
  %v45 = getelementptr i64, ptr %v0, i64 21
  %v46 = load i64, ptr %v45
  %v47 = getelementptr i64, ptr %v0, i64 22
  %v48 = load ptr, ptr %v47
  %v49 = getelementptr i64, ptr %v0, i64 23
  %v50 = load i64, ptr %v49
  %v51 = getelementptr i64, ptr %v0, i64 24
  %v52 = load i64, ptr %v51
  %v53 = getelementptr i64, ptr %v0, i64 25
  %v54 = load ptr, ptr %v53
  %v55 = getelementptr i64, ptr %v0, i64 26
  %v56 = load ptr, ptr %v55
  %v57 = getelementptr i64, ptr %v0, i64 27
  %v58 = load i64, ptr %v57
  %v59 = getelementptr i64, ptr %v0, i64 28
  %v60 = load i64, ptr %v59
  %v61 = getelementptr i64, ptr %v0, i64 29
  %v62 = load ptr, ptr %v61
  %v63 = getelementptr i64, ptr %v0, i64 30
  %v64 = load i64, ptr %v63
  %v65 = getelementptr i64, ptr %v0, i64 31
  %v66 = load i64, ptr %v65
  %v67 = getelementptr i64, ptr %v0, i64 32
  %v68 = load i64, ptr %v67
  %v69 = getelementptr i64, ptr %v0, i64 33
  %v70 = load i64, ptr %v69
  %v71 = getelementptr i64, ptr %v0, i64 34
  %v72 = load ptr, ptr %v71
  %v73 = getelementptr i64, ptr %v0, i64 35
  %v74 = load ptr, ptr %v73
  %v75 = getelementptr i64, ptr %v0, i64 36
  %v76 = load i64, ptr %v75
  %v77 = getelementptr i64, ptr %v0, i64 37
  %v78 = load i64, ptr %v77
  %v79 = getelementptr i64, ptr %v0, i64 38
  %v80 = load ptr, ptr %v79
  %v81 = getelementptr i64, ptr %v0, i64 39
  %v82 = load i64, ptr %v81
  %v83 = getelementptr i64, ptr %v0, i64 40
  %v84 = load i64, ptr %v83
  %v85 = getelementptr i64, ptr %v0, i64 41
  %v86 = load i64, ptr %v85
  %v87 = getelementptr i64, ptr %v0, i64 42
  %v88 = load i64, ptr %v87
  %v89 = getelementptr i64, ptr %v0, i64 43
  %v90 = load ptr, ptr %v89
  %v91 = getelementptr i64, ptr %v0, i64 44
  %v92 = load ptr, ptr %v91
  %v93 = getelementptr i64, ptr %v0, i64 45
  %v94 = load i64, ptr %v93
  %v95 = getelementptr i64, ptr %v0, i64 46
  %v96 = load i64, ptr %v95
  %v97 = getelementptr i64, ptr %v0, i64 47
  %v98 = load ptr, ptr %v97
  %v99 = getelementptr i64, ptr %v0, i64 48
  %v100 = load i64, ptr %v99
  %v101 = getelementptr i64, ptr %v0, i64 49
  %v102 = load i64, ptr %v101
  %v103 = getelementptr i64, ptr %v0, i64 50
  %v104 = load ptr, ptr %v103
  %v105 = getelementptr i64, ptr %v0, i64 51
  %v106 = load ptr, ptr %v105
  %v107 = getelementptr i64, ptr %v0, i64 52
  %v108 = load i64, ptr %v107
  %v109 = getelementptr i64, ptr %v0, i64 53
  %v110 = load i64, ptr %v109
  %v111 = getelementptr i64, ptr %v0, i64 54
  %v112 = load ptr, ptr %v111
  %v113 = getelementptr i64, ptr %v0, i64 55
  %v114 = load i64, ptr %v113
  %v115 = getelementptr i64, ptr %v0, i64 56
  %v116 = load i64, ptr %v115
  %v117 = getelementptr i64, ptr %v0, i64 57
  %v118 = load ptr, ptr %v117
  %v119 = getelementptr i64, ptr %v0, i64 58
  %v120 = load ptr, ptr %v119
  %v121 = getelementptr i64, ptr %v0, i64 59
  %v122 = load i64, ptr %v121
  %v123 = getelementptr i64, ptr %v0, i64 60
  %v124 = load i64, ptr %v123
  %v125 = getelementptr i64, ptr %v0, i64 61
  %v126 = load ptr, ptr %v125
  %v127 = getelementptr i64, ptr %v0, i64 62
  %v128 = load i64, ptr %v127
  %v129 = getelementptr i64, ptr %v0, i64 63
  %v130 = load i64, ptr %v129
  %v131 = getelementptr i64, ptr %v0, i64 64
  %v132 = load ptr, ptr %v131
  %v133 = getelementptr i64, ptr %v0, i64 65
  %v134 = load ptr, ptr %v133
  %v135 = getelementptr i64, ptr %v0, i64 66
  %v136 = load i64, ptr %v135
  %v137 = getelementptr i64, ptr %v0, i64 67
  %v138 = load i64, ptr %v137
  %v139 = getelementptr i64, ptr %v0, i64 68
  %v140 = load ptr, ptr %v139
  %v141 = getelementptr i64, ptr %v0, i64 69
  %v142 = load i64, ptr %v141
  %v143 = getelementptr i64, ptr %v0, i64 70
  %v144 = load i64, ptr %v143
  %v145 = getelementptr i64, ptr %v0, i64 71
  %v146 = load ptr, ptr %v145
  %v147 = getelementptr i64, ptr %v0, i64 72
  %v148 = load ptr, ptr %v147
  %v149 = getelementptr i64, ptr %v0, i64 73
  %v150 = load i64, ptr %v149
  %v151 = getelementptr i64, ptr %v0, i64 74
  %v152 = load i64, ptr %v151
  %v153 = getelementptr i64, ptr %v0, i64 75
  %v154 = load ptr, ptr %v153
  %v155 = getelementptr i64, ptr %v0, i64 76
  %v156 = load i64, ptr %v155
  %v157 = getelementptr i64, ptr %v0, i64 77
  %v158 = load i64, ptr %v157
  %v159 = getelementptr i64, ptr %v0, i64 78
  %v160 = load i64, ptr %v159
  %v161 = getelementptr i64, ptr %v0, i64 79
  %v162 = load i64, ptr %v161
  %v163 = getelementptr i64, ptr %v0, i64 80
  %v164 = load ptr, ptr %v163
  %v165 = getelementptr i64, ptr %v0, i64 81
  %v166 = load ptr, ptr %v165
  %v167 = getelementptr i64, ptr %v0, i64 82
  %v168 = load i64, ptr %v167
  %v169 = getelementptr i64, ptr %v0, i64 83
  %v170 = load i64, ptr %v169
  %v171 = getelementptr i64, ptr %v0, i64 84
  %v172 = load ptr, ptr %v171
  %v173 = getelementptr i64, ptr %v0, i64 85
  %v174 = load i64, ptr %v173
  %v175 = getelementptr i64, ptr %v0, i64 86
  %v176 = load i64, ptr %v175
  %v177 = getelementptr i64, ptr %v0, i64 87
  %v178 = load ptr, ptr %v177
  %v179 = getelementptr i64, ptr %v0, i64 88
  %v180 = load ptr, ptr %v179
  %v181 = getelementptr i64, ptr %v0, i64 89
  %v182 = load i64, ptr %v181
  %v183 = getelementptr i64, ptr %v0, i64 90
  %v184 = load i64, ptr %v183
  %v185 = getelementptr i64, ptr %v0, i64 91
  %v186 = load ptr, ptr %v185
  %v187 = getelementptr i64, ptr %v0, i64 92
  %v188 = load i64, ptr %v187
  %v189 = getelementptr i64, ptr %v0, i64 93
  %v190 = load i64, ptr %v189
  %v191 = getelementptr i64, ptr %v0, i64 94
  %v192 = load ptr, ptr %v191
  %v193 = getelementptr i64, ptr %v0, i64 95
  %v194 = load ptr, ptr %v193
  %v195 = getelementptr i64, ptr %v0, i64 96
  %v196 = load i64, ptr %v195
  %v197 = getelementptr i64, ptr %v0, i64 97
  %v198 = load i64, ptr %v197
  %v199 = getelementptr i64, ptr %v0, i64 98
  %v200 = load ptr, ptr %v199
  %v201 = getelementptr i64, ptr %v0, i64 99
  %v202 = load i64, ptr %v201
  %v203 = getelementptr i64, ptr %v0, i64 100
  %v204 = load i64, ptr %v203
  %v205 = getelementptr i64, ptr %v0, i64 101
  %v206 = load i64, ptr %v205
  %v207 = getelementptr i64, ptr %v0, i64 102
  %v208 = load i64, ptr %v207
  %v209 = getelementptr i64, ptr %v0, i64 103
  %v210 = load i64, ptr %v209
  %v211 = getelementptr i64, ptr %v0, i64 104
  %v212 = load i64, ptr %v211
  %v213 = getelementptr i64, ptr %v0, i64 105
  %v214 = load ptr, ptr %v213
  %v215 = getelementptr i64, ptr %v0, i64 106
  %v216 = load ptr, ptr %v215
  %v217 = getelementptr i64, ptr %v0, i64 107
  %v218 = load i64, ptr %v217
  %v219 = getelementptr i64, ptr %v0, i64 108
  %v220 = load i64, ptr %v219
  %v221 = getelementptr i64, ptr %v0, i64 109
  %v222 = load ptr, ptr %v221
  %v223 = getelementptr i64, ptr %v0, i64 110
  %v224 = load i64, ptr %v223
  %v225 = getelementptr i64, ptr %v0, i64 111
  %v226 = load i64, ptr %v225
  %v227 = getelementptr i64, ptr %v0, i64 112
  %v228 = load ptr, ptr %v227
  %v229 = getelementptr i64, ptr %v0, i64 113
  %v230 = load ptr, ptr %v229
  %v231 = getelementptr i64, ptr %v0, i64 114
  %v232 = load i64, ptr %v231
  %v233 = getelementptr i64, ptr %v0, i64 115
  %v234 = load i64, ptr %v233
  %v235 = getelementptr i64, ptr %v0, i64 116
  %v236 = load ptr, ptr %v235
  %v237 = getelementptr i64, ptr %v0, i64 117
  %v238 = load i64, ptr %v237
  %v239 = getelementptr i64, ptr %v0, i64 118
  %v240 = load i64, ptr %v239
  %v241 = getelementptr i64, ptr %v0, i64 119
  %v242 = load ptr, ptr %v241
  %v243 = getelementptr i64, ptr %v0, i64 120
  %v244 = load ptr, ptr %v243
  %v245 = getelementptr i64, ptr %v0, i64 121
  %v246 = load i64, ptr %v245
  %v247 = getelementptr i64, ptr %v0, i64 122
  %v248 = load i64, ptr %v247
  %v249 = getelementptr i64, ptr %v0, i64 123
  %v250 = load ptr, ptr %v249
  %v251 = getelementptr i64, ptr %v0, i64 124
  %v252 = load i64, ptr %v251
  %v253 = getelementptr i64, ptr %v0, i64 125
  %v254 = load i64, ptr %v253
  %v255 = getelementptr i64, ptr %v0, i64 126
  %v256 = load i64, ptr %v255
  %v257 = getelementptr i64, ptr %v0, i64 127
  %v258 = load i64, ptr %v257
  %v259 = getelementptr i64, ptr %v0, i64 128
  %v260 = load ptr, ptr %v259
  %v261 = getelementptr i64, ptr %v0, i64 129
  %v262 = load ptr, ptr %v261
  %v263 = getelementptr i64, ptr %v0, i64 130
  %v264 = load i64, ptr %v263
  %v265 = getelementptr i64, ptr %v0, i64 131
  %v266 = load i64, ptr %v265
  %v267 = getelementptr i64, ptr %v0, i64 132
  %v268 = load ptr, ptr %v267
  %v269 = getelementptr i64, ptr %v0, i64 133
  %v270 = load i64, ptr %v269
  %v271 = getelementptr i64, ptr %v0, i64 134
  %v272 = load i64, ptr %v271
  %v273 = getelementptr i64, ptr %v0, i64 135
  %v274 = load i64, ptr %v273
  %v275 = getelementptr i64, ptr %v0, i64 136
  %v276 = load i64, ptr %v275
  %v277 = getelementptr i64, ptr %v0, i64 137
  %v278 = load ptr, ptr %v277
  %v279 = getelementptr i64, ptr %v0, i64 138
  %v280 = load ptr, ptr %v279
  %v281 = getelementptr i64, ptr %v0, i64 139
  %v282 = load i64, ptr %v281
  %v283 = getelementptr i64, ptr %v0, i64 140
  %v284 = load i64, ptr %v283
  %v285 = getelementptr i64, ptr %v0, i64 141
  %v286 = load ptr, ptr %v285
  %v287 = getelementptr i64, ptr %v0, i64 142
  %v288 = load i64, ptr %v287
  %v289 = getelementptr i64, ptr %v0, i64 143
  %v290 = load i64, ptr %v289
  %v291 = getelementptr i64, ptr %v0, i64 144
  %v292 = load i64, ptr %v291
  %v293 = getelementptr i64, ptr %v0, i64 145
  %v294 = load i64, ptr %v293
  %v295 = getelementptr i64, ptr %v0, i64 146
  %v296 = load ptr, ptr %v295
  %v297 = getelementptr i64, ptr %v0, i64 147
  %v298 = load ptr, ptr %v297
  %v299 = getelementptr i64, ptr %v0, i64 148
  %v300 = load i64, ptr %v299
  %v301 = getelementptr i64, ptr %v0, i64 149
  %v302 = load i64, ptr %v301
  %v303 = getelementptr i64, ptr %v0, i64 150
  %v304 = load ptr, ptr %v303
  %v305 = getelementptr i64, ptr %v0, i64 151
  %v306 = load i64, ptr %v305
  %v307 = getelementptr i64, ptr %v0, i64 152
  %v308 = load i64, ptr %v307
  %v309 = getelementptr i64, ptr %v0, i64 153
  %v310 = load ptr, ptr %v309
  %v311 = getelementptr i64, ptr %v0, i64 154
  %v312 = load ptr, ptr %v311
  %v313 = getelementptr i64, ptr %v0, i64 155
  %v314 = load i64, ptr %v313
  %v315 = getelementptr i64, ptr %v0, i64 156
  %v316 = load i64, ptr %v315
  %v317 = getelementptr i64, ptr %v0, i64 157
  %v318 = load ptr, ptr %v317
  %v319 = getelementptr i64, ptr %v0, i64 158
  %v320 = load i64, ptr %v319
  %v321 = getelementptr i64, ptr %v0, i64 159
  %v322 = load i64, ptr %v321
  %v323 = getelementptr i64, ptr %v0, i64 160
  %v324 = load ptr, ptr %v323
  %v325 = getelementptr i64, ptr %v0, i64 161
  %v326 = load ptr, ptr %v325
  %v327 = getelementptr i64, ptr %v0, i64 162
  %v328 = load i64, ptr %v327
  %v329 = getelementptr i64, ptr %v0, i64 163
  %v330 = load i64, ptr %v329
  %v331 = getelementptr i64, ptr %v0, i64 164
  %v332 = load ptr, ptr %v331
  %v333 = getelementptr i64, ptr %v0, i64 165
  %v334 = load i64, ptr %v333
  %v335 = getelementptr i64, ptr %v0, i64 166
  %v336 = load i64, ptr %v335
  %v337 = getelementptr i64, ptr %v0, i64 167
  %v338 = load ptr, ptr %v337
  %v339 = getelementptr i64, ptr %v0, i64 168
  %v340 = load ptr, ptr %v339
  %v341 = getelementptr i64, ptr %v0, i64 169
  %v342 = load i64, ptr %v341
  %v343 = getelementptr i64, ptr %v0, i64 170
  %v344 = load i64, ptr %v343
  %v345 = getelementptr i64, ptr %v0, i64 171
  %v346 = load ptr, ptr %v345
  %v347 = getelementptr i64, ptr %v0, i64 172
  %v348 = load i64, ptr %v347
  %v349 = getelementptr i64, ptr %v0, i64 173
  %v350 = load i64, ptr %v349
  %v351 = getelementptr i64, ptr %v0, i64 174
  %v352 = load ptr, ptr %v351
  %v353 = getelementptr i64, ptr %v0, i64 175
  %v354 = load ptr, ptr %v353
  %v355 = getelementptr i64, ptr %v0, i64 176
  %v356 = load i64, ptr %v355
  %v357 = getelementptr i64, ptr %v0, i64 177
  %v358 = load i64, ptr %v357
  %v359 = getelementptr i64, ptr %v0, i64 178
  %v360 = load ptr, ptr %v359
  %v361 = getelementptr i64, ptr %v0, i64 179
  %v362 = load i64, ptr %v361
  %v363 = getelementptr i64, ptr %v0, i64 180
  %v364 = load i64, ptr %v363
  %v365 = getelementptr i64, ptr %v0, i64 181
  %v366 = load ptr, ptr %v365
  %v367 = getelementptr i64, ptr %v0, i64 182
  %v368 = load ptr, ptr %v367
  %v369 = getelementptr i64, ptr %v0, i64 183
  %v370 = load i64, ptr %v369
  %v371 = getelementptr i64, ptr %v0, i64 184
  %v372 = load i64, ptr %v371
  %v373 = getelementptr i64, ptr %v0, i64 185
  %v374 = load ptr, ptr %v373
  %v375 = getelementptr i64, ptr %v0, i64 186
  %v376 = load i64, ptr %v375
  %v377 = getelementptr i64, ptr %v0, i64 187
  %v378 = load i64, ptr %v377
  %v379 = getelementptr i64, ptr %v0, i64 188
  %v380 = load ptr, ptr %v379
  %v381 = getelementptr i64, ptr %v0, i64 189
  %v382 = load ptr, ptr %v381
  %v383 = getelementptr i64, ptr %v0, i64 190
  %v384 = load i64, ptr %v383
  %v385 = getelementptr i64, ptr %v0, i64 191
  %v386 = load i64, ptr %v385
  %v387 = getelementptr i64, ptr %v0, i64 192
  %v388 = load ptr, ptr %v387
  %v389 = getelementptr i64, ptr %v0, i64 193
  %v390 = load i64, ptr %v389
  %v391 = getelementptr i64, ptr %v0, i64 194
  %v392 = load i64, ptr %v391
  %v393 = getelementptr i64, ptr %v0, i64 195
  %v394 = load i64, ptr %v393
  %v395 = getelementptr i64, ptr %v0, i64 196
  %v396 = load i64, ptr %v395
  %v397 = getelementptr i64, ptr %v0, i64 197
  %v398 = load i64, ptr %v397
  %v399 = getelementptr i64, ptr %v0, i64 198
  %v400 = load i64, ptr %v399
  %v401 = getelementptr i64, ptr %v0, i64 199
  %v402 = load ptr, ptr %v401
  %v403 = getelementptr i64, ptr %v0, i64 200
  %v404 = load ptr, ptr %v403
  %v405 = getelementptr i64, ptr %v0, i64 201
  %v406 = load i64, ptr %v405
  %v407 = getelementptr i64, ptr %v0, i64 202
  %v408 = load i64, ptr %v407
  %v409 = getelementptr i64, ptr %v0, i64 203
  %v410 = load ptr, ptr %v409
  %v411 = getelementptr i64, ptr %v0, i64 204
  %v412 = load i64, ptr %v411
  %v413 = getelementptr i64, ptr %v0, i64 205
  %v414 = load i64, ptr %v413
  %v415 = getelementptr i64, ptr %v0, i64 206
  %v416 = load i64, ptr %v415
  %v417 = getelementptr i64, ptr %v0, i64 207
  %v418 = load i64, ptr %v417
  %v419 = getelementptr i64, ptr %v0, i64 208
  %v420 = load i64, ptr %v419
  %v421 = getelementptr i64, ptr %v0, i64 209
  %v422 = load i64, ptr %v421
  %v423 = getelementptr i64, ptr %v0, i64 210
  %v424 = load ptr, ptr %v423
  %v425 = getelementptr i64, ptr %v0, i64 211
  %v426 = load ptr, ptr %v425
  %v427 = getelementptr i64, ptr %v0, i64 212
  %v428 = load i64, ptr %v427
  %v429 = getelementptr i64, ptr %v0, i64 213
  %v430 = load i64, ptr %v429
  %v431 = getelementptr i64, ptr %v0, i64 214
  %v432 = load ptr, ptr %v431
  %v433 = getelementptr i64, ptr %v0, i64 215
  %v434 = load i64, ptr %v433
  %v435 = getelementptr i64, ptr %v0, i64 216
  %v436 = load i64, ptr %v435
  %v437 = getelementptr i64, ptr %v0, i64 217
  %v438 = load ptr, ptr %v437
  %v439 = getelementptr i64, ptr %v0, i64 218
  %v440 = load ptr, ptr %v439
  %v441 = getelementptr i64, ptr %v0, i64 219
  %v442 = load i64, ptr %v441
  %v443 = getelementptr i64, ptr %v0, i64 220
  %v444 = load i64, ptr %v443
  %v445 = getelementptr i64, ptr %v0, i64 221
  %v446 = load ptr, ptr %v445
  %v447 = getelementptr i64, ptr %v0, i64 222
  %v448 = load i64, ptr %v447
  %v449 = getelementptr i64, ptr %v0, i64 223
  %v450 = load i64, ptr %v449
  %v451 = getelementptr i64, ptr %v0, i64 224
  %v452 = load ptr, ptr %v451
  %v453 = getelementptr i64, ptr %v0, i64 225
  %v454 = load ptr, ptr %v453
  %v455 = getelementptr i64, ptr %v0, i64 226
  %v456 = load i64, ptr %v455
  %v457 = getelementptr i64, ptr %v0, i64 227
  %v458 = load i64, ptr %v457
  %v459 = getelementptr i64, ptr %v0, i64 228
  %v460 = load ptr, ptr %v459
  %v461 = getelementptr i64, ptr %v0, i64 229
  %v462 = load i64, ptr %v461
  %v463 = getelementptr i64, ptr %v0, i64 230
  %v464 = load i64, ptr %v463
  %v465 = getelementptr i64, ptr %v0, i64 231
  %v466 = load ptr, ptr %v465
  %v467 = getelementptr i64, ptr %v0, i64 232
  %v468 = load ptr, ptr %v467
  %v469 = getelementptr i64, ptr %v0, i64 233
  %v470 = load i64, ptr %v469
  %v471 = getelementptr i64, ptr %v0, i64 234
  %v472 = load i64, ptr %v471
  %v473 = getelementptr i64, ptr %v0, i64 235
  %v474 = load ptr, ptr %v473
  %v475 = getelementptr i64, ptr %v0, i64 236
  %v476 = load i64, ptr %v475
  %v477 = getelementptr i64, ptr %v0, i64 237
  %v478 = load i64, ptr %v477
  %v479 = getelementptr i64, ptr %v0, i64 238
  %v480 = load ptr, ptr %v479
  %v481 = getelementptr i64, ptr %v0, i64 239
  %v482 = load ptr, ptr %v481
  %v483 = getelementptr i64, ptr %v0, i64 240
  %v484 = load i64, ptr %v483
  %v485 = getelementptr i64, ptr %v0, i64 241
  %v486 = load i64, ptr %v485
  %v487 = getelementptr i64, ptr %v0, i64 242
  %v488 = load ptr, ptr %v487
  %v489 = getelementptr i64, ptr %v0, i64 243
  %v490 = load i64, ptr %v489
  %v491 = getelementptr i64, ptr %v0, i64 244
  %v492 = load i64, ptr %v491
  %v493 = getelementptr i64, ptr %v0, i64 245
  %v494 = load ptr, ptr %v493
  %v495 = getelementptr i64, ptr %v0, i64 246
  %v496 = load ptr, ptr %v495
  %v497 = getelementptr i64, ptr %v0, i64 247
  %v498 = load i64, ptr %v497
  %v499 = getelementptr i64, ptr %v0, i64 248
  %v500 = load i64, ptr %v499
  %v501 = getelementptr i64, ptr %v0, i64 249
  %v502 = load ptr, ptr %v501
  %v503 = getelementptr i64, ptr %v0, i64 250
  %v504 = load i64, ptr %v503
  %v505 = getelementptr i64, ptr %v0, i64 251
  %v506 = load i64, ptr %v505
  %v507 = getelementptr i64, ptr %v0, i64 252
  %v508 = load i64, ptr %v507
  %v509 = getelementptr i64, ptr %v0, i64 253
  %v510 = load i64, ptr %v509
  %v511 = getelementptr i64, ptr %v0, i64 254
  %v512 = load ptr, ptr %v511
  %v513 = getelementptr i64, ptr %v0, i64 255
  %v514 = load ptr, ptr %v513
  %v515 = getelementptr i64, ptr %v0, i64 256
  %v516 = load i64, ptr %v515
  %v517 = getelementptr i64, ptr %v0, i64 257
  %v518 = load i64, ptr %v517
  %v519 = getelementptr i64, ptr %v0, i64 258
  %v520 = load ptr, ptr %v519
  %v521 = getelementptr i64, ptr %v0, i64 259
  %v522 = load i64, ptr %v521
  %v523 = getelementptr i64, ptr %v0, i64 260
  %v524 = load i64, ptr %v523
  %v525 = getelementptr i64, ptr %v0, i64 261
  %v526 = load ptr, ptr %v525
  %v527 = getelementptr i64, ptr %v0, i64 262
  %v528 = load ptr, ptr %v527
  %v529 = getelementptr i64, ptr %v0, i64 263
  %v530 = load i64, ptr %v529
  %v531 = getelementptr i64, ptr %v0, i64 264
  %v532 = load i64, ptr %v531
  %v533 = getelementptr i64, ptr %v0, i64 265
  %v534 = load ptr, ptr %v533
  %v535 = getelementptr i64, ptr %v0, i64 266
  %v536 = load i64, ptr %v535
  %v537 = getelementptr i64, ptr %v0, i64 267
  %v538 = load i64, ptr %v537
  %v539 = getelementptr i64, ptr %v0, i64 268
  %v540 = load ptr, ptr %v539
  %v541 = getelementptr i64, ptr %v0, i64 269
  %v542 = load ptr, ptr %v541
  %v543 = getelementptr i64, ptr %v0, i64 270
  %v544 = load i64, ptr %v543
  %v545 = getelementptr i64, ptr %v0, i64 271
  %v546 = load i64, ptr %v545
  %v547 = getelementptr i64, ptr %v0, i64 272
  %v548 = load ptr, ptr %v547
  %v549 = getelementptr i64, ptr %v0, i64 273
  %v550 = load i64, ptr %v549
  %v551 = getelementptr i64, ptr %v0, i64 274
  %v552 = load i64, ptr %v551
  %v553 = getelementptr i64, ptr %v0, i64 275
  %v554 = load ptr, ptr %v553
  %v555 = getelementptr i64, ptr %v0, i64 276
  %v556 = load ptr, ptr %v555
  %v557 = getelementptr i64, ptr %v0, i64 277
  %v558 = load i64, ptr %v557
  %v559 = getelementptr i64, ptr %v0, i64 278
  %v560 = load i64, ptr %v559
  %v561 = getelementptr i64, ptr %v0, i64 279
  %v562 = load ptr, ptr %v561
  %v563 = getelementptr i64, ptr %v0, i64 280
  %v564 = load i64, ptr %v563
  %v565 = getelementptr i64, ptr %v0, i64 281
  %v566 = load i64, ptr %v565
  %v567 = getelementptr i64, ptr %v0, i64 282
  %v568 = load ptr, ptr %v567
  %v569 = getelementptr i64, ptr %v0, i64 283
  %v570 = load ptr, ptr %v569
  %v571 = getelementptr i64, ptr %v0, i64 284
  %v572 = load i64, ptr %v571
  %v573 = getelementptr i64, ptr %v0, i64 285
  %v574 = load i64, ptr %v573
  %v575 = getelementptr i64, ptr %v0, i64 286
  %v576 = load ptr, ptr %v575
  %v577 = getelementptr i64, ptr %v0, i64 287
  %v578 = load i64, ptr %v577
  %v579 = getelementptr i64, ptr %v0, i64 288
  %v580 = load i64, ptr %v579
  %v581 = getelementptr i64, ptr %v0, i64 289
  %v582 = load ptr, ptr %v581
  %v583 = getelementptr i64, ptr %v0, i64 290
  %v584 = load ptr, ptr %v583
  %v585 = getelementptr i64, ptr %v0, i64 291
  %v586 = load i64, ptr %v585
  %v587 = getelementptr i64, ptr %v0, i64 292
  %v588 = load i64, ptr %v587
  %v589 = getelementptr i64, ptr %v0, i64 293
  %v590 = load ptr, ptr %v589
  %v591 = getelementptr i64, ptr %v0, i64 294
  %v592 = load i64, ptr %v591
  %v593 = getelementptr i64, ptr %v0, i64 295
  %v594 = load i64, ptr %v593
  %v595 = getelementptr i64, ptr %v0, i64 296
  %v596 = load i64, ptr %v595
  %v597 = getelementptr i64, ptr %v0, i64 297
  %v598 = load i64, ptr %v597
  %v599 = call i32 @advance_of_many(ptr %v1, ptr %v2, ptr %v4, ptr %v6, i64 %v8, i64 %v10, ptr %v12, i64 %v14, i64 %v16, i64 %v18, i64 %v20, i64 %v22, i64 %v24, i64 %v26, i64 %v28, i64 %v30, i64 %v32, i64 %v34, i64 %v36, i64 %v38, ptr %v40, ptr %v42, i64 %v44, i64 %v46, ptr %v48, i64 %v50, i64 %v52, ptr %v54, ptr %v56, i64 %v58, i64 %v60, ptr %v62, i64 %v64, i64 %v66, i64 %v68, i64 %v70, ptr %v72, ptr %v74, i64 %v76, i64 %v78, ptr %v80, i64 %v82, i64 %v84, i64 %v86, i64 %v88, ptr %v90, ptr %v92, i64 %v94, i64 %v96, ptr %v98, i64 %v100, i64 %v102, ptr %v104, ptr %v106, i64 %v108, i64 %v110, ptr %v112, i64 %v114, i64 %v116, ptr %v118, ptr %v120, i64 %v122, i64 %v124, ptr %v126, i64 %v128, i64 %v130, ptr %v132, ptr %v134, i64 %v136, i64 %v138, ptr %v140, i64 %v142, i64 %v144, ptr %v146, ptr %v148, i64 %v150, i64 %v152, ptr %v154, i64 %v156, i64 %v158, i64 %v160, i64 %v162, ptr %v164, ptr %v166, i64 %v168, i64 %v170, ptr %v172, i64 %v174, i64 %v176, ptr %v178, ptr %v180, i64 %v182, i64 %v184, ptr %v186, i64 %v188, i64 %v190, ptr %v192, ptr %v194, i64 %v196, i64 %v198, ptr %v200, i64 %v202, i64 %v204, i64 %v206, i64 %v208, i64 %v210, i64 %v212, ptr %v214, ptr %v216, i64 %v218, i64 %v220, ptr %v222, i64 %v224, i64 %v226, ptr %v228, ptr %v230, i64 %v232, i64 %v234, ptr %v236, i64 %v238, i64 %v240, ptr %v242, ptr %v244, i64 %v246, i64 %v248, ptr %v250, i64 %v252, i64 %v254, i64 %v256, i64 %v258, ptr %v260, ptr %v262, i64 %v264, i64 %v266, ptr %v268, i64 %v270, i64 %v272, i64 %v274, i64 %v276, ptr %v278, ptr %v280, i64 %v282, i64 %v284, ptr %v286, i64 %v288, i64 %v290, i64 %v292, i64 %v294, ptr %v296, ptr %v298, i64 %v300, i64 %v302, ptr %v304, i64 %v306, i64 %v308, ptr %v310, ptr %v312, i64 %v314, i64 %v316, ptr %v318, i64 %v320, i64 %v322, ptr %v324, ptr %v326, i64 %v328, i64 %v330, ptr %v332, i64 %v334, i64 %v336, ptr %v338, ptr %v340, i64 %v342, i64 %v344, ptr %v346, i64 %v348, i64 %v350, ptr %v352, ptr %v354, i64 %v356, i64 %v358, ptr %v360, i64 %v362, i64 %v364, ptr %v366, ptr %v368, i64 %v370, i64 %v372, ptr %v374, i64 %v376, i64 %v378, ptr %v380, ptr %v382, i64 %v384, i64 %v386, ptr %v388, i64 %v390, i64 %v392, i64 %v394, i64 %v396, i64 %v398, i64 %v400, ptr %v402, ptr %v404, i64 %v406, i64 %v408, ptr %v410, i64 %v412, i64 %v414, i64 %v416, i64 %v418, i64 %v420, i64 %v422, ptr %v424, ptr %v426, i64 %v428, i64 %v430, ptr %v432, i64 %v434, i64 %v436, ptr %v438, ptr %v440, i64 %v442, i64 %v444, ptr %v446, i64 %v448, i64 %v450, ptr %v452, ptr %v454, i64 %v456, i64 %v458, ptr %v460, i64 %v462, i64 %v464, ptr %v466, ptr %v468, i64 %v470, i64 %v472, ptr %v474, i64 %v476, i64 %v478, ptr %v480, ptr %v482, i64 %v484, i64 %v486, ptr %v488, i64 %v490, i64 %v492, ptr %v494, ptr %v496, i64 %v498, i64 %v500, ptr %v502, i64 %v504, i64 %v506, i64 %v508, i64 %v510, ptr %v512, ptr %v514, i64 %v516, i64 %v518, ptr %v520, i64 %v522, i64 %v524, ptr %v526, ptr %v528, i64 %v530, i64 %v532, ptr %v534, i64 %v536, i64 %v538, ptr %v540, ptr %v542, i64 %v544, i64 %v546, ptr %v548, i64 %v550, i64 %v552, ptr %v554, ptr %v556, i64 %v558, i64 %v560, ptr %v562, i64 %v564, i64 %v566, ptr %v568, ptr %v570, i64 %v572, i64 %v574, ptr %v576, i64 %v578, i64 %v580, ptr %v582, ptr %v584, i64 %v586, i64 %v588, ptr %v590, i64 %v592, i64 %v594, i64 %v596, i64 %v598)
  %v600 = load i64, ptr %v1
  ret i64 %v600
}

define i64 @evaluate(ptr %v0) {
  %v1 = alloca i64
  %v2 = alloca ptr
  %v3 = getelementptr i64, ptr %v0, i64 0
  %v4 = load ptr, ptr %v3
  %v5 = getelementptr i64, ptr %v0, i64 1
  %v6 = load ptr, ptr %v5
  %v7 = getelementptr i64, ptr %v0, i64 2
  %v8 = load i64, ptr %v7
  %v9 = getelementptr i64, ptr %v0, i64 3
  %v10 = load i64, ptr %v9
  %v11 = getelementptr i64, ptr %v0, i64 4
  %v12 = load ptr, ptr %v11
  %v13 = getelementptr i64, ptr %v0, i64 5
  %v14 = load i64, ptr %v13
  %v15 = getelementptr i64, ptr %v0, i64 6
  %v16 = load i64, ptr %v15
  %v17 = getelementptr i64, ptr %v0, i64 7
  %v18 = load i64, ptr %v17
  %v19 = getelementptr i64, ptr %v0, i64 8
  %v20 = load i64, ptr %v19
  %v21 = getelementptr i64, ptr %v0, i64 9
  %v22 = load i64, ptr %v21
  %v23 = getelementptr i64, ptr %v0, i64 10
  %v24 = load i64, ptr %v23
  %v25 = getelementptr i64, ptr %v0, i64 11
  %v26 = load ptr, ptr %v25
  %v27 = getelementptr i64, ptr %v0, i64 12
  %v28 = load ptr, ptr %v27
  %v29 = getelementptr i64, ptr %v0, i64 13
  %v30 = load i64, ptr %v29
  %v31 = getelementptr i64, ptr %v0, i64 14
  %v32 = load i64, ptr %v31
  %v33 = getelementptr i64, ptr %v0, i64 15
  %v34 = load ptr, ptr %v33
  %v35 = getelementptr i64, ptr %v0, i64 16
  %v36 = load i64, ptr %v35
  %v37 = getelementptr i64, ptr %v0, i64 17
  %v38 = load i64, ptr %v37
  %v39 = getelementptr i64, ptr %v0, i64 18
  %v40 = load ptr, ptr %v39
  %v41 = getelementptr i64, ptr %v0, i64 19
  %v42 = load ptr, ptr %v41
  %v43 = getelementptr i64, ptr %v0, i64 20
  %v44 = load i64, ptr %v43
  %v45 = getelementptr i64, ptr %v0, i64 21
  %v46 = load i64, ptr %v45
  %v47 = getelementptr i64, ptr %v0, i64 22
  %v48 = load ptr, ptr %v47
  %v49 = getelementptr i64, ptr %v0, i64 23
  %v50 = load i64, ptr %v49
  %v51 = getelementptr i64, ptr %v0, i64 24
  %v52 = load i64, ptr %v51
  %v53 = getelementptr i64, ptr %v0, i64 25
  %v54 = load ptr, ptr %v53
  %v55 = getelementptr i64, ptr %v0, i64 26
  %v56 = load ptr, ptr %v55
  %v57 = getelementptr i64, ptr %v0, i64 27
  %v58 = load i64, ptr %v57
  %v59 = getelementptr i64, ptr %v0, i64 28
  %v60 = load i64, ptr %v59
  %v61 = getelementptr i64, ptr %v0, i64 29
  %v62 = load ptr, ptr %v61
  %v63 = getelementptr i64, ptr %v0, i64 30
  %v64 = load i64, ptr %v63
  %v65 = getelementptr i64, ptr %v0, i64 31
  %v66 = load i64, ptr %v65
  %v67 = getelementptr i64, ptr %v0, i64 32
  %v68 = load ptr, ptr %v67
  %v69 = getelementptr i64, ptr %v0, i64 33
  %v70 = load ptr, ptr %v69
  %v71 = getelementptr i64, ptr %v0, i64 34
  %v72 = load i64, ptr %v71
  %v73 = getelementptr i64, ptr %v0, i64 35
  %v74 = load i64, ptr %v73
  %v75 = getelementptr i64, ptr %v0, i64 36
  %v76 = load ptr, ptr %v75
  %v77 = getelementptr i64, ptr %v0, i64 37
  %v78 = load i64, ptr %v77
  %v79 = getelementptr i64, ptr %v0, i64 38
  %v80 = load i64, ptr %v79
  %v81 = getelementptr i64, ptr %v0, i64 39
  %v82 = load ptr, ptr %v81
  %v83 = getelementptr i64, ptr %v0, i64 40
  %v84 = load ptr, ptr %v83
  %v85 = getelementptr i64, ptr %v0, i64 41
  %v86 = load i64, ptr %v85
  %v87 = getelementptr i64, ptr %v0, i64 42
  %v88 = load i64, ptr %v87
  %v89 = getelementptr i64, ptr %v0, i64 43
  %v90 = load ptr, ptr %v89
  %v91 = getelementptr i64, ptr %v0, i64 44
  %v92 = load i64, ptr %v91
  %v93 = getelementptr i64, ptr %v0, i64 45
  %v94 = load i64, ptr %v93
  %v95 = getelementptr i64, ptr %v0, i64 46
  %v96 = load ptr, ptr %v95
  %v97 = getelementptr i64, ptr %v0, i64 47
  %v98 = load ptr, ptr %v97
  %v99 = getelementptr i64, ptr %v0, i64 48
  %v100 = load i64, ptr %v99
  %v101 = getelementptr i64, ptr %v0, i64 49
  %v102 = load i64, ptr %v101
  %v103 = getelementptr i64, ptr %v0, i64 50
  %v104 = load ptr, ptr %v103
  %v105 = getelementptr i64, ptr %v0, i64 51
  %v106 = load i64, ptr %v105
  %v107 = getelementptr i64, ptr %v0, i64 52
  %v108 = load i64, ptr %v107
  %v109 = getelementptr i64, ptr %v0, i64 53
  %v110 = load i64, ptr %v109
  %v111 = getelementptr i64, ptr %v0, i64 54
  %v112 = load i64, ptr %v111
  %v113 = getelementptr i64, ptr %v0, i64 55
  %v114 = load ptr, ptr %v113
  %v115 = getelementptr i64, ptr %v0, i64 56
  %v116 = load ptr, ptr %v115
  %v117 = getelementptr i64, ptr %v0, i64 57
  %v118 = load i64, ptr %v117
  %v119 = getelementptr i64, ptr %v0, i64 58
  %v120 = load i64, ptr %v119
  %v121 = getelementptr i64, ptr %v0, i64 59
  %v122 = load ptr, ptr %v121
  %v123 = getelementptr i64, ptr %v0, i64 60
  %v124 = load i64, ptr %v123
  %v125 = getelementptr i64, ptr %v0, i64 61
  %v126 = load i64, ptr %v125
  %v127 = getelementptr i64, ptr %v0, i64 62
  %v128 = load ptr, ptr %v127
  %v129 = getelementptr i64, ptr %v0, i64 63
  %v130 = load ptr, ptr %v129
  %v131 = getelementptr i64, ptr %v0, i64 64
  %v132 = load i64, ptr %v131
  %v133 = getelementptr i64, ptr %v0, i64 65
  %v134 = load i64, ptr %v133
  %v135 = getelementptr i64, ptr %v0, i64 66
  %v136 = load ptr, ptr %v135
  %v137 = getelementptr i64, ptr %v0, i64 67
  %v138 = load i64, ptr %v137
  %v139 = getelementptr i64, ptr %v0, i64 68
  %v140 = load i64, ptr %v139
  %v141 = getelementptr i64, ptr %v0, i64 69
  %v142 = load ptr, ptr %v141
  %v143 = getelementptr i64, ptr %v0, i64 70
  %v144 = load ptr, ptr %v143
  %v145 = getelementptr i64, ptr %v0, i64 71
  %v146 = load i64, ptr %v145
  %v147 = getelementptr i64, ptr %v0, i64 72
  %v148 = load i64, ptr %v147
  %v149 = getelementptr i64, ptr %v0, i64 73
  %v150 = load ptr, ptr %v149
  %v151 = getelementptr i64, ptr %v0, i64 74
  %v152 = load i64, ptr %v151
  %v153 = getelementptr i64, ptr %v0, i64 75
  %v154 = load i64, ptr %v153
  %v155 = getelementptr i64, ptr %v0, i64 76
  %v156 = load ptr, ptr %v155
  %v157 = getelementptr i64, ptr %v0, i64 77
  %v158 = load ptr, ptr %v157
  %v159 = getelementptr i64, ptr %v0, i64 78
  %v160 = load i64, ptr %v159
  %v161 = getelementptr i64, ptr %v0, i64 79
  %v162 = load i64, ptr %v161
  %v163 = getelementptr i64, ptr %v0, i64 80
  %v164 = load ptr, ptr %v163
  %v165 = getelementptr i64, ptr %v0, i64 81
  %v166 = load i64, ptr %v165
  %v167 = getelementptr i64, ptr %v0, i64 82
  %v168 = load i64, ptr %v167
  %v169 = getelementptr i64, ptr %v0, i64 83
  %v170 = load ptr, ptr %v169
  %v171 = getelementptr i64, ptr %v0, i64 84
  %v172 = load ptr, ptr %v171
  %v173 = getelementptr i64, ptr %v0, i64 85
  %v174 = load i64, ptr %v173
  %v175 = getelementptr i64, ptr %v0, i64 86
  %v176 = load i64, ptr %v175
  %v177 = getelementptr i64, ptr %v0, i64 87
  %v178 = load ptr, ptr %v177
  %v179 = getelementptr i64, ptr %v0, i64 88
  %v180 = load i64, ptr %v179
  %v181 = getelementptr i64, ptr %v0, i64 89
  %v182 = load i64, ptr %v181
  %v183 = getelementptr i64, ptr %v0, i64 90
  %v184 = load i64, ptr %v183
  %v185 = getelementptr i64, ptr %v0, i64 91
  %v186 = load i64, ptr %v185
  %v187 = call i32 @evaluate_of_many(ptr %v1, ptr %v2, ptr %v4, ptr %v6, i64 %v8, i64 %v10, ptr %v12, i64 %v14, i64 %v16, i64 %v18, i64 %v20, i64 %v22, i64 %v24, ptr %v26, ptr %v28, i64 %v30, i64 %v32, ptr %v34, i64 %v36, i64 %v38, ptr %v40, ptr %v42, i64 %v44, i64 %v46, ptr %v48, i64 %v50, i64 %v52, ptr %v54, ptr %v56, i64 %v58, i64 %v60, ptr %v62, i64 %v64, i64 %v66, ptr %v68, ptr %v70, i64 %v72, i64 %v74, ptr %v76, i64 %v78, i64 %v80, ptr %v82, ptr %v84, i64 %v86, i64 %v88, ptr %v90, i64 %v92, i64 %v94, ptr %v96, ptr %v98, i64 %v100, i64 %v102, ptr %v104, i64 %v106, i64 %v108, i64 %v110, i64 %v112, ptr %v114, ptr %v116, i64 %v118, i64 %v120, ptr %v122, i64 %v124, i64 %v126, ptr %v128, ptr %v130, i64 %v132, i64 %v134, ptr %v136, i64 %v138, i64 %v140, ptr %v142, ptr %v144, i64 %v146, i64 %v148, ptr %v150, i64 %v152, i64 %v154, ptr %v156, ptr %v158, i64 %v160, i64 %v162, ptr %v164, i64 %v166, i64 %v168, ptr %v170, ptr %v172, i64 %v174, i64 %v176, ptr %v178, i64 %v180, i64 %v182, i64 %v184, i64 %v186)
  %v188 = load i64, ptr %v1
  ret i64 %v188
}

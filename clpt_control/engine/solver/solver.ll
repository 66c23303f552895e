; sha256 95af1686ac2475c7ac9e0a4fee3dd704027245c584d164fb7e587ac95312c2cb 445654673f908ebd12365ebb6ebd52dacda504a6ee90bdc391a1d53086c56a68, Python 3.11, numba 0.68.1

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
@switch.table._ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7 = private unnamed_addr constant [18 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00, double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00], align 8

define dso_local range(i32 0, 2) i32 @advance_of_many(ptr noalias %v0, ptr noalias %v1, ptr readnone %v2, ptr readnone %v3, i64 %v4, i64 %v5, ptr readonly %v6, i64 %v7, i64 %v8, i64 %v9, i64 %v10, i64 %v11, i64 %v12, i64 %v13, i64 %v14, i64 %v15, i64 %v16, i64 %v17, i64 %v18, ptr readnone %v19, ptr readnone %v20, i64 %v21, i64 %v22, ptr %v23, i64 %v24, i64 %v25, ptr readnone %v26, ptr readnone %v27, i64 %v28, i64 %v29, ptr readonly %v30, i64 %v31, i64 %v32, i64 %v33, i64 %v34, ptr readnone %v35, ptr readnone %v36, i64 %v37, i64 %v38, ptr readonly %v39, i64 %v40, i64 %v41, i64 %v42, i64 %v43, ptr readnone %v44, ptr readnone %v45, i64 %v46, i64 %v47, ptr readonly %v48, i64 %v49, i64 %v50, ptr readnone %v51, ptr readnone %v52, i64 %v53, i64 %v54, ptr readonly %v55, i64 %v56, i64 %v57, ptr readnone %v58, ptr readnone %v59, i64 %v60, i64 %v61, ptr readonly %v62, i64 %v63, i64 %v64, ptr readnone %v65, ptr readnone %v66, i64 %v67, i64 %v68, ptr readonly %v69, i64 %v70, i64 %v71, ptr readnone %v72, ptr readnone %v73, i64 %v74, i64 %v75, ptr readonly %v76, i64 %v77, i64 %v78, i64 %v79, i64 %v80, ptr readnone %v81, ptr readnone %v82, i64 %v83, i64 %v84, ptr readonly %v85, i64 %v86, i64 %v87, ptr readnone %v88, ptr readnone %v89, i64 %v90, i64 %v91, ptr readonly %v92, i64 %v93, i64 %v94, ptr readnone %v95, ptr readnone %v96, i64 %v97, i64 %v98, ptr %v99, i64 %v100, i64 %v101, i64 %v102, i64 %v103, i64 %v104, i64 %v105, ptr readnone %v106, ptr readnone %v107, i64 %v108, i64 %v109, ptr %v110, i64 %v111, i64 %v112, ptr readnone %v113, ptr readnone %v114, i64 %v115, i64 %v116, ptr %v117, i64 %v118, i64 %v119, ptr readnone %v120, ptr readnone %v121, i64 %v122, i64 %v123, ptr %v124, i64 %v125, i64 %v126, i64 %v127, i64 %v128, ptr readnone %v129, ptr readnone %v130, i64 %v131, i64 %v132, ptr %v133, i64 %v134, i64 %v135, i64 %v136, i64 %v137, ptr readnone %v138, ptr readnone %v139, i64 %v140, i64 %v141, ptr %v142, i64 %v143, i64 %v144, i64 %v145, i64 %v146, ptr readnone %v147, ptr readnone %v148, i64 %v149, i64 %v150, ptr %v151, i64 %v152, i64 %v153, ptr readnone %v154, ptr readnone %v155, i64 %v156, i64 %v157, ptr %v158, i64 %v159, i64 %v160, ptr readnone %v161, ptr readnone %v162, i64 %v163, i64 %v164, ptr %v165, i64 %v166, i64 %v167, ptr readnone %v168, ptr readnone %v169, i64 %v170, i64 %v171, ptr %v172, i64 %v173, i64 %v174, ptr readnone %v175, ptr readnone %v176, i64 %v177, i64 %v178, ptr %v179, i64 %v180, i64 %v181, ptr readnone %v182, ptr readnone %v183, i64 %v184, i64 %v185, ptr %v186, i64 %v187, i64 %v188, ptr readnone %v189, ptr readnone %v190, i64 %v191, i64 %v192, ptr %v193, i64 %v194, i64 %v195, i64 %v196, i64 %v197, i64 %v198, i64 %v199, ptr readnone %v200, ptr readnone %v201, i64 %v202, i64 %v203, ptr %v204, i64 %v205, i64 %v206, i64 %v207, i64 %v208, i64 %v209, i64 %v210, ptr readnone %v211, ptr readnone %v212, i64 %v213, i64 %v214, ptr readonly %v215, i64 %v216, i64 %v217, ptr readnone %v218, ptr readnone %v219, i64 %v220, i64 %v221, ptr %v222, i64 %v223, i64 %v224, ptr readnone %v225, ptr readnone %v226, i64 %v227, i64 %v228, ptr %v229, i64 %v230, i64 %v231, ptr readnone %v232, ptr readnone %v233, i64 %v234, i64 %v235, ptr %v236, i64 %v237, i64 %v238, ptr readnone %v239, ptr readnone %v240, i64 %v241, i64 %v242, ptr %v243, i64 %v244, i64 %v245, ptr readnone %v246, ptr readnone %v247, i64 %v248, i64 %v249, ptr %v250, i64 %v251, i64 %v252, i64 %v253, i64 %v254, ptr readnone %v255, ptr readnone %v256, i64 %v257, i64 %v258, ptr readonly %v259, i64 %v260, i64 %v261, ptr readnone %v262, ptr readnone %v263, i64 %v264, i64 %v265, ptr readonly %v266, i64 %v267, i64 %v268, ptr readnone %v269, ptr readnone %v270, i64 %v271, i64 %v272, ptr readonly %v273, i64 %v274, i64 %v275, ptr readnone %v276, ptr readnone %v277, i64 %v278, i64 %v279, ptr readonly %v280, i64 %v281, i64 %v282, ptr readnone %v283, ptr readnone %v284, i64 %v285, i64 %v286, ptr readonly %v287, i64 %v288, i64 %v289, ptr readnone %v290, ptr readnone %v291, i64 %v292, i64 %v293, ptr readonly %v294, i64 %v295, i64 %v296, i64 %v297, i64 %v298) local_unnamed_addr {
v299:
  %v300 = alloca i8, align 1
  %v301 = alloca ptr, align 8
  %v302 = alloca i8, align 1
  %v303 = alloca ptr, align 8
  %v304 = icmp sgt i64 %v15, 0
  %v305 = icmp sgt i64 %v18, 0
  %v306 = select i1 %v304, i1 true, i1 %v305
  %v307 = icmp slt i64 %v9, 1
  %v308 = select i1 %v307, i64 0, i64 %v9
  br i1 %v307, label %v309, label %v310

v310:
  %v311 = mul i64 %v135, 24
  %v312 = getelementptr i8, ptr %v133, i64 %v311
  %v313 = getelementptr i8, ptr %v151, i64 8
  %v314 = getelementptr i8, ptr %v151, i64 16
  %v315 = getelementptr i64, ptr %v142, i64 %v144
  %v316 = shl i64 %v144, 4
  %v317 = getelementptr i8, ptr %v142, i64 %v316
  %v318 = mul i64 %v144, 24
  %v319 = getelementptr i8, ptr %v142, i64 %v318
  %v320 = icmp slt i64 %v41, 1
  %v321 = icmp slt i64 %v63, 1
  %v322 = icmp slt i64 %v10, 1
  %v323 = mul i64 %v135, 144
  %v324 = getelementptr i8, ptr %v133, i64 %v323
  %v325 = mul i64 %v135, 240
  %v326 = getelementptr i8, ptr %v133, i64 %v325
  %v327 = mul i64 %v135, 232
  %v328 = getelementptr i8, ptr %v133, i64 %v327
  %v329 = shl i64 %v135, 4
  %v330 = shl i64 %v135, 5
  %v331 = mul i64 %v135, 40
  %v332 = mul i64 %v135, 48
  %v333 = mul i64 %v135, 56
  %v334 = shl i64 %v135, 6
  %v335 = mul i64 %v135, 72
  %v336 = mul i64 %v135, 80
  %v337 = mul i64 %v135, 88
  %v338 = mul i64 %v135, 96
  %v339 = mul i64 %v135, 104
  %v340 = mul i64 %v135, 112
  %v341 = mul i64 %v135, 120
  %v342 = shl i64 %v135, 7
  %v343 = mul i64 %v135, 136
  %v344 = mul i64 %v135, 152
  %v345 = mul i64 %v135, 160
  %v346 = mul i64 %v135, 168
  %v347 = mul i64 %v135, 176
  %v348 = mul i64 %v135, 184
  %v349 = mul i64 %v135, 192
  %v350 = mul i64 %v135, 200
  %v351 = mul i64 %v135, 208
  %v352 = mul i64 %v135, 216
  %v353 = mul i64 %v135, 224
  %v354 = getelementptr i8, ptr %v133, i64 %v341
  %v355 = getelementptr i8, ptr %v133, i64 %v353
  %v356 = getelementptr i8, ptr %v133, i64 %v329
  br label %v357

v358:
  %v359 = getelementptr double, ptr %v312, i64 %v360
  store double 0.000000e+00, ptr %v359, align 8, !noalias !0
  %v361 = load i64, ptr %v151, align 8, !noalias !0
  %v362 = load i64, ptr %v313, align 8, !noalias !0
  %v363 = icmp eq i64 %v361, %v362
  br i1 %v363, label %v364, label %v365

v365:
  %v366 = add nsw i64 %v361, 1
  store i64 %v366, ptr %v151, align 8, !noalias !0
  store i64 2, ptr %v314, align 8, !noalias !0
  %v367 = getelementptr i64, ptr %v142, i64 %v360
  store i64 %v361, ptr %v367, align 8, !noalias !0
  %v368 = icmp slt i64 %v361, 0
  %v369 = select i1 %v368, i64 %v49, i64 0
  %v370 = getelementptr i64, ptr %v48, i64 %v361
  %v371 = getelementptr i64, ptr %v370, i64 %v369
  %v372 = load i64, ptr %v371, align 8, !noalias !0
  %v373 = icmp slt i64 %v372, 0
  %v374 = select i1 %v373, i64 %v56, i64 0
  %v375 = getelementptr i64, ptr %v55, i64 %v372
  %v376 = getelementptr i64, ptr %v375, i64 %v374
  %v377 = load i64, ptr %v376, align 8, !noalias !0
  %v378 = getelementptr i64, ptr %v315, i64 %v360
  store i64 %v377, ptr %v378, align 8, !noalias !0
  %v379 = getelementptr i64, ptr %v317, i64 %v360
  store i64 1, ptr %v379, align 8, !noalias !0
  %v380 = getelementptr i64, ptr %v319, i64 %v360
  store i64 0, ptr %v380, align 8, !noalias !0
  br i1 %v320, label %v381, label %v382

v382:
  %v383 = select i1 %v368, i64 %v40, i64 0
  %v384 = add i64 %v383, %v361
  %v385 = mul i64 %v384, %v41
  %v386 = getelementptr double, ptr %v39, i64 %v385
  %v387 = getelementptr double, ptr %v165, i64 %v360
  br label %v388

v381:
  br i1 %v321, label %v389, label %v390

v390:
  %v391 = load i64, ptr %v378, align 8, !noalias !0
  %v392 = icmp slt i64 %v391, 0
  %v393 = select i1 %v392, i64 %v77, i64 0
  %v394 = add i64 %v393, %v391
  %v395 = mul i64 %v394, %v78
  %v396 = getelementptr double, ptr %v76, i64 %v395
  br label %v397

v397:
  %v398 = phi i64 [ 0, %v390 ], [ %v399, %v397 ]
  %v399 = add nsw i64 %v398, 1
  %v400 = getelementptr double, ptr %v396, i64 %v398
  %v401 = load double, ptr %v400, align 8, !noalias !3
  %v402 = getelementptr i64, ptr %v62, i64 %v398
  %v403 = load i64, ptr %v402, align 8, !noalias !3
  %v404 = mul nsw i64 %v403, %v9
  %v405 = add nsw i64 %v404, %v360
  %v406 = icmp slt i64 %v405, 0
  %v407 = select i1 %v406, i64 %v166, i64 0
  %v408 = getelementptr double, ptr %v165, i64 %v405
  %v409 = getelementptr double, ptr %v408, i64 %v407
  store double %v401, ptr %v409, align 8, !noalias !3
  %v410 = icmp eq i64 %v399, %v63
  br i1 %v410, label %v389, label %v397

v411:
  %v412 = getelementptr double, ptr %v133, i64 %v360
  %v413 = getelementptr double, ptr %v324, i64 %v360
  %v414 = load double, ptr %v413, align 8, !noalias !7
  %v415 = getelementptr double, ptr %v326, i64 %v360
  %v416 = load double, ptr %v415, align 8, !noalias !7
  %v417 = getelementptr double, ptr %v328, i64 %v360
  %v418 = load double, ptr %v417, align 8, !noalias !7
  store double 0.000000e+00, ptr %v412, align 8, !noalias !7
  %v419 = getelementptr double, ptr %v412, i64 %v135
  store double 0.000000e+00, ptr %v419, align 8, !noalias !7
  %v420 = getelementptr i8, ptr %v412, i64 %v329
  store double 0.000000e+00, ptr %v420, align 8, !noalias !7
  %v421 = getelementptr i8, ptr %v412, i64 %v311
  store double 0.000000e+00, ptr %v421, align 8, !noalias !7
  %v422 = getelementptr i8, ptr %v412, i64 %v330
  store double 0.000000e+00, ptr %v422, align 8, !noalias !7
  %v423 = getelementptr i8, ptr %v412, i64 %v331
  store double 0.000000e+00, ptr %v423, align 8, !noalias !7
  %v424 = getelementptr i8, ptr %v412, i64 %v332
  store double 0.000000e+00, ptr %v424, align 8, !noalias !7
  %v425 = getelementptr i8, ptr %v412, i64 %v333
  store double 0.000000e+00, ptr %v425, align 8, !noalias !7
  %v426 = getelementptr i8, ptr %v412, i64 %v334
  store double 0.000000e+00, ptr %v426, align 8, !noalias !7
  %v427 = getelementptr i8, ptr %v412, i64 %v335
  store double 0.000000e+00, ptr %v427, align 8, !noalias !7
  %v428 = getelementptr i8, ptr %v412, i64 %v336
  store double 0.000000e+00, ptr %v428, align 8, !noalias !7
  %v429 = getelementptr i8, ptr %v412, i64 %v337
  store double 0.000000e+00, ptr %v429, align 8, !noalias !7
  %v430 = getelementptr i8, ptr %v412, i64 %v338
  store double 0.000000e+00, ptr %v430, align 8, !noalias !7
  %v431 = getelementptr i8, ptr %v412, i64 %v339
  store double 0.000000e+00, ptr %v431, align 8, !noalias !7
  %v432 = getelementptr i8, ptr %v412, i64 %v340
  store double 0.000000e+00, ptr %v432, align 8, !noalias !7
  %v433 = getelementptr i8, ptr %v412, i64 %v341
  store double 0.000000e+00, ptr %v433, align 8, !noalias !7
  %v434 = getelementptr i8, ptr %v412, i64 %v342
  store double 0.000000e+00, ptr %v434, align 8, !noalias !7
  %v435 = getelementptr i8, ptr %v412, i64 %v343
  store double 0.000000e+00, ptr %v435, align 8, !noalias !7
  %v436 = getelementptr i8, ptr %v412, i64 %v323
  store double 0.000000e+00, ptr %v436, align 8, !noalias !7
  %v437 = getelementptr i8, ptr %v412, i64 %v344
  store double 0.000000e+00, ptr %v437, align 8, !noalias !7
  %v438 = getelementptr i8, ptr %v412, i64 %v345
  store double 0.000000e+00, ptr %v438, align 8, !noalias !7
  %v439 = getelementptr i8, ptr %v412, i64 %v346
  store double 0.000000e+00, ptr %v439, align 8, !noalias !7
  %v440 = getelementptr i8, ptr %v412, i64 %v347
  store double 0.000000e+00, ptr %v440, align 8, !noalias !7
  %v441 = getelementptr i8, ptr %v412, i64 %v348
  store double 0.000000e+00, ptr %v441, align 8, !noalias !7
  %v442 = getelementptr i8, ptr %v412, i64 %v349
  store double 0.000000e+00, ptr %v442, align 8, !noalias !7
  %v443 = getelementptr i8, ptr %v412, i64 %v350
  store double 0.000000e+00, ptr %v443, align 8, !noalias !7
  %v444 = getelementptr i8, ptr %v412, i64 %v351
  store double 0.000000e+00, ptr %v444, align 8, !noalias !7
  %v445 = getelementptr i8, ptr %v412, i64 %v352
  store double 0.000000e+00, ptr %v445, align 8, !noalias !7
  %v446 = getelementptr i8, ptr %v412, i64 %v353
  store double 0.000000e+00, ptr %v446, align 8, !noalias !7
  %v447 = getelementptr i8, ptr %v412, i64 %v327
  store double 0.000000e+00, ptr %v447, align 8, !noalias !7
  %v448 = getelementptr i8, ptr %v412, i64 %v325
  store double 0.000000e+00, ptr %v448, align 8, !noalias !7
  %v449 = fcmp oeq double %v418, 0xFFF0000000000000
  %v450 = select i1 %v449, double 0xFFF0000000000000, double 0.000000e+00
  store double %v450, ptr %v417, align 8, !noalias !7
  store double %v416, ptr %v415, align 8, !noalias !7
  store double %v414, ptr %v413, align 8, !noalias !7
  store double 1.000000e+00, ptr %v359, align 8, !noalias !7
  %v451 = getelementptr double, ptr %v354, i64 %v360
  store double 0xFFF0000000000000, ptr %v451, align 8, !noalias !7
  %v452 = getelementptr double, ptr %v355, i64 %v360
  store double 0x7FF0000000000000, ptr %v452, align 8, !noalias !7
  %v453 = load double, ptr %v92, align 8, !noalias !0
  store double %v453, ptr %v412, align 8, !noalias !0
  %v454 = load i64, ptr %v378, align 8, !noalias !0
  %v455 = icmp slt i64 %v454, 0
  %v456 = select i1 %v455, i64 %v70, i64 0
  %v457 = getelementptr double, ptr %v69, i64 %v454
  %v458 = getelementptr double, ptr %v457, i64 %v456
  %v459 = load double, ptr %v458, align 8, !noalias !0
  %v460 = getelementptr double, ptr %v356, i64 %v360
  store double %v459, ptr %v460, align 8, !noalias !0
  br label %v364

v388:
  %v461 = phi i64 [ 0, %v382 ], [ %v462, %v388 ]
  %v462 = add nsw i64 %v461, 1
  %v463 = getelementptr double, ptr %v386, i64 %v461
  %v464 = load double, ptr %v463, align 8, !noalias !0
  %v465 = mul nsw i64 %v461, %v9
  %v466 = getelementptr double, ptr %v387, i64 %v465
  store double %v464, ptr %v466, align 8, !noalias !0
  %v467 = icmp eq i64 %v462, %v41
  br i1 %v467, label %v381, label %v388

v389:
  br i1 %v322, label %v411, label %v468

v468:
  %v469 = getelementptr double, ptr %v193, i64 %v360
  %v470 = select i1 %v368, i64 %v31, i64 0
  %v471 = add i64 %v470, %v361
  %v472 = mul i64 %v471, %v32
  %v473 = getelementptr double, ptr %v30, i64 %v472
  br label %v474

v474:
  %v475 = phi i64 [ 0, %v468 ], [ %v476, %v474 ]
  %v476 = add nsw i64 %v475, 1
  %v477 = getelementptr double, ptr %v473, i64 %v475
  %v478 = load double, ptr %v477, align 8, !noalias !0
  %v479 = mul i64 %v475, %v196
  %v480 = getelementptr double, ptr %v469, i64 %v479
  store double %v478, ptr %v480, align 8, !noalias !0
  %v481 = icmp eq i64 %v476, %v10
  br i1 %v481, label %v411, label %v474

v364:
  %v482 = load i64, ptr %v483, align 8
  %v484 = icmp sgt i64 %v482, -1
  %v485 = zext i1 %v484 to i64
  %v486 = add nsw i64 %v487, %v485
  %v488 = icmp sgt i64 %v489, 1
  br i1 %v488, label %v357, label %v309

v309:
  %v490 = phi i64 [ 0, %v299 ], [ %v486, %v364 ]
  %v491 = icmp ne i64 %v490, 0
  %v492 = icmp sgt i64 %v297, 0
  %v493 = select i1 %v491, i1 %v492, i1 false
  br i1 %v493, label %v494, label %v495

v494:
  %v496 = getelementptr i8, ptr %v151, i64 16
  %v497 = mul i64 %v10, %v9
  %v498 = mul i64 %v196, %v195
  %v499 = shl i64 %v196, 7
  %v500 = mul i64 %v207, %v206
  %v501 = getelementptr i8, ptr %v6, i64 8
  %v502 = getelementptr i8, ptr %v6, i64 32
  %v503 = mul i64 %v135, 24
  %v504 = getelementptr i8, ptr %v133, i64 %v503
  %v505 = icmp sgt i64 %v18, 0
  %v506 = getelementptr i8, ptr %v6, i64 32
  %v507 = mul i64 %v135, 24
  %v508 = getelementptr i8, ptr %v133, i64 %v507
  %v509 = icmp slt i64 %v18, 1
  %v510 = icmp eq i64 %v14, 0
  %v511 = mul nsw i64 %v10, %v9
  %v512 = shl i64 %v511, 4
  %v513 = getelementptr i8, ptr %v158, i64 %v512
  %v514 = getelementptr i8, ptr %v6, i64 56
  %v515 = getelementptr i8, ptr %v6, i64 64
  %v516 = shl i64 %v135, 6
  %v517 = getelementptr i8, ptr %v133, i64 %v516
  %v518 = mul i64 %v511, 136
  %v519 = getelementptr i8, ptr %v158, i64 %v518
  %v520 = mul i64 %v511, 24
  %v521 = getelementptr i8, ptr %v158, i64 %v520
  %v522 = getelementptr i8, ptr %v6, i64 72
  %v523 = mul i64 %v497, 112
  %v524 = mul i64 %v135, 24
  %v525 = getelementptr i8, ptr %v133, i64 %v524
  %v526 = shl i64 %v135, 5
  %v527 = getelementptr i8, ptr %v133, i64 %v526
  %v528 = mul i64 %v135, 144
  %v529 = getelementptr i8, ptr %v133, i64 %v528
  %v530 = icmp slt i64 %v14, 1
  %v531 = select i1 %v530, i64 2, i64 0
  %v532 = zext i1 %v530 to i64
  %v533 = mul i64 %v135, 88
  %v534 = getelementptr i8, ptr %v133, i64 %v533
  %v535 = getelementptr double, ptr %v92, i64 %v93
  %v536 = getelementptr i8, ptr %v535, i64 -8
  %v537 = shl i64 %v135, 6
  %v538 = getelementptr i8, ptr %v133, i64 %v537
  %v539 = getelementptr i8, ptr %v158, i64 %v523
  %v540 = icmp slt i64 %v10, 1
  %v541 = mul i64 %v196, %v195
  %v542 = mul i64 %v541, 112
  %v543 = getelementptr i8, ptr %v193, i64 %v542
  %v544 = shl i64 %v541, 7
  %v545 = getelementptr i8, ptr %v193, i64 %v544
  %v546 = getelementptr i8, ptr %v6, i64 32
  %v547 = mul i64 %v207, 216
  %v548 = getelementptr i8, ptr %v186, i64 %v547
  %v549 = shl i64 %v10, 7
  %v550 = getelementptr i8, ptr %v158, i64 %v549
  %v551 = mul i64 %v207, 240
  %v552 = getelementptr i8, ptr %v186, i64 %v551
  %v553 = sub i64 %v207, %v18
  %v554 = tail call i64 @llvm.smax.i64(i64 %v553, i64 0)
  %v555 = getelementptr double, ptr %v204, i64 %v207
  %v556 = mul i64 %v207, %v206
  %v557 = mul i64 %v556, 80
  %v558 = getelementptr i8, ptr %v555, i64 %v557
  %v559 = mul i64 %v556, 72
  %v560 = getelementptr i8, ptr %v204, i64 %v559
  %v561 = getelementptr double, ptr %v560, i64 %v207
  %v562 = shl i64 %v207, 4
  %v563 = getelementptr i8, ptr %v560, i64 %v562
  %v564 = shl i64 %v144, 5
  %v565 = getelementptr i8, ptr %v142, i64 %v564
  %v566 = shl i64 %v135, 4
  %v567 = getelementptr i8, ptr %v133, i64 %v566
  %v568 = mul i64 %v135, 112
  %v569 = getelementptr i8, ptr %v133, i64 %v568
  %v570 = shl i64 %v135, 4
  %v571 = getelementptr i8, ptr %v133, i64 %v570
  %v572 = mul i64 %v135, 168
  %v573 = getelementptr i8, ptr %v133, i64 %v572
  %v574 = shl i64 %v144, 4
  %v575 = getelementptr i8, ptr %v142, i64 %v574
  %v576 = getelementptr i8, ptr %v6, i64 40
  %v577 = icmp sgt i64 %v14, 0
  %v578 = mul nsw i64 %v10, %v9
  %v579 = getelementptr double, ptr %v158, i64 %v578
  %v580 = icmp sgt i64 %v13, 0
  %v581 = shl i64 %v135, 5
  %v582 = getelementptr i8, ptr %v133, i64 %v581
  %v583 = icmp slt i64 %v10, 1
  %v584 = mul i64 %v196, %v195
  %v585 = mul i64 %v584, 136
  %v586 = getelementptr i8, ptr %v193, i64 %v585
  %v587 = mul i64 %v584, 88
  %v588 = getelementptr i8, ptr %v193, i64 %v587
  %v589 = mul nsw i64 %v10, 19
  %v590 = add nsw i64 %v589, 1
  %v591 = mul nsw i64 %v10, 18
  %v592 = icmp slt i64 %v10, 0
  %v593 = select i1 %v592, i64 %v159, i64 0
  %v594 = add i64 %v593, %v591
  %v595 = icmp slt i64 %v594, 0
  %v596 = icmp slt i64 %v594, %v159
  %v597 = add i64 %v590, %v593
  %v598 = icmp slt i64 %v597, 0
  %v599 = icmp slt i64 %v597, %v159
  %v600 = icmp sgt i64 %v274, 1
  %v601 = mul i64 %v196, %v195
  %v602 = getelementptr i8, ptr %v23, i64 8
  %v603 = select i1 %v592, i64 %v267, i64 0
  %v604 = getelementptr i64, ptr %v266, i64 %v10
  %v605 = getelementptr i64, ptr %v604, i64 %v603
  %v606 = mul i64 %v135, 48
  %v607 = getelementptr i8, ptr %v133, i64 %v606
  %v608 = mul i64 %v601, 136
  %v609 = shl i64 %v135, 6
  %v610 = getelementptr i8, ptr %v133, i64 %v609
  %v611 = mul nsw i64 %v10, %v9
  %v612 = mul i64 %v611, 136
  %v613 = getelementptr i8, ptr %v158, i64 %v612
  %v614 = getelementptr i8, ptr %v193, i64 %v608
  %v615 = mul i64 %v601, 96
  %v616 = getelementptr i8, ptr %v193, i64 %v615
  %v617 = mul i64 %v601, 104
  %v618 = getelementptr i8, ptr %v193, i64 %v617
  %v619 = getelementptr double, ptr %v193, i64 %v601
  %v620 = mul i64 %v601, 88
  %v621 = getelementptr i8, ptr %v193, i64 %v620
  %v622 = mul i64 %v611, 96
  %v623 = getelementptr i8, ptr %v158, i64 %v622
  %v624 = mul i64 %v611, 96
  %v625 = getelementptr i8, ptr %v158, i64 %v624
  %v626 = mul i64 %v611, 104
  %v627 = getelementptr i8, ptr %v158, i64 %v626
  %v628 = add nsw i64 %v274, -2
  %v629 = icmp sgt i64 %v10, 0
  %v630 = add i64 %v254, %v253
  %v631 = add i64 %v253, 1
  %v632 = add i64 %v10, 1
  %v633 = mul i64 %v135, 160
  %v634 = getelementptr i8, ptr %v133, i64 %v633
  %v635 = add i64 %v254, 1
  %v636 = add i64 %v11, -1
  %v637 = tail call i64 @llvm.smax.i64(i64 %v636, i64 0)
  %v638 = mul i64 %v498, 136
  %v639 = icmp slt i64 %v636, 1
  %v640 = shl i64 %v135, 6
  %v641 = getelementptr i8, ptr %v133, i64 %v640
  %v642 = mul nsw i64 %v10, %v9
  %v643 = mul i64 %v642, 136
  %v644 = getelementptr i8, ptr %v158, i64 %v643
  %v645 = icmp slt i64 %v10, 1
  %v646 = mul i64 %v196, %v195
  %v647 = mul i64 %v646, 80
  %v648 = getelementptr i8, ptr %v193, i64 %v647
  %v649 = mul i64 %v646, 136
  %v650 = getelementptr i8, ptr %v193, i64 %v649
  %v651 = mul nsw i64 %v10, 17
  %v652 = getelementptr double, ptr %v158, i64 %v651
  %v653 = add i64 %v253, 1
  %v654 = add i64 %v253, 1
  %v655 = getelementptr double, ptr %v158, i64 %v651
  %v656 = add i64 %v254, %v253
  %v657 = getelementptr i8, ptr %v193, i64 %v638
  %v658 = mul i64 %v196, %v195
  %v659 = getelementptr i8, ptr %v6, i64 48
  %v660 = or i1 %v580, %v306
  %v661 = mul i64 %v135, 40
  %v662 = getelementptr i8, ptr %v133, i64 %v661
  %v663 = mul i64 %v135, 184
  %v664 = getelementptr i8, ptr %v133, i64 %v663
  %v665 = mul i64 %v135, 192
  %v666 = getelementptr i8, ptr %v133, i64 %v665
  %v667 = mul i64 %v135, 200
  %v668 = getelementptr i8, ptr %v133, i64 %v667
  %v669 = mul i64 %v135, 176
  %v670 = getelementptr i8, ptr %v133, i64 %v669
  %v671 = shl i64 %v144, 4
  %v672 = getelementptr i8, ptr %v142, i64 %v671
  %v673 = mul i64 %v135, 208
  %v674 = getelementptr i8, ptr %v133, i64 %v673
  %v675 = mul i64 %v135, 72
  %v676 = getelementptr i8, ptr %v133, i64 %v675
  %v677 = mul i64 %v135, 40
  %v678 = getelementptr i8, ptr %v133, i64 %v677
  %v679 = mul i64 %v135, 56
  %v680 = getelementptr i8, ptr %v133, i64 %v679
  %v681 = mul i64 %v135, 232
  %v682 = getelementptr i8, ptr %v133, i64 %v681
  %v683 = icmp eq i64 %v14, 0
  %v684 = icmp ne i64 %v13, 0
  %v685 = xor i1 %v683, true
  %v686 = select i1 %v685, i1 true, i1 %v684
  %v687 = shl i64 %v135, 6
  %v688 = getelementptr i8, ptr %v133, i64 %v687
  %v689 = mul nsw i64 %v10, %v9
  %v690 = mul i64 %v689, 136
  %v691 = getelementptr i8, ptr %v158, i64 %v690
  %v692 = mul i64 %v689, 104
  %v693 = getelementptr i8, ptr %v158, i64 %v692
  %v694 = getelementptr i8, ptr %v6, i64 104
  %v695 = getelementptr i8, ptr %v6, i64 96
  %v696 = mul i64 %v196, %v195
  %v697 = mul i64 %v135, 48
  %v698 = getelementptr i8, ptr %v133, i64 %v697
  %v699 = shl i64 %v135, 6
  %v700 = getelementptr i8, ptr %v133, i64 %v699
  %v701 = shl i64 %v696, 7
  %v702 = icmp slt i64 %v10, 1
  %v703 = getelementptr i8, ptr %v193, i64 %v701
  %v704 = mul i64 %v207, 3
  %v705 = getelementptr i8, ptr %v6, i64 32
  %v706 = mul i64 %v696, 192
  %v707 = mul i64 %v696, 184
  %v708 = mul i64 %v696, 176
  %v709 = mul i64 %v696, 168
  %v710 = mul i64 %v696, 160
  %v711 = mul i64 %v696, 152
  %v712 = mul i64 %v696, 144
  %v713 = mul i64 %v135, 56
  %v714 = getelementptr i8, ptr %v133, i64 %v713
  %v715 = tail call i64 @llvm.smax.i64(i64 %v207, i64 0)
  %v716 = mul i64 %v207, %v206
  %v717 = getelementptr double, ptr %v204, i64 %v207
  %v718 = mul i64 %v207, %v206
  %v719 = getelementptr double, ptr %v204, i64 %v207
  %v720 = getelementptr double, ptr %v204, i64 %v207
  %v721 = shl i64 %v207, 4
  %v722 = getelementptr i8, ptr %v204, i64 %v721
  %v723 = icmp sgt i64 %v12, 0
  %v724 = add nsw i64 %v11, 13
  %v725 = shl i64 %v135, 6
  %v726 = getelementptr i8, ptr %v133, i64 %v725
  %v727 = mul nsw i64 %v10, %v9
  %v728 = mul i64 %v727, 136
  %v729 = getelementptr i8, ptr %v158, i64 %v728
  %v730 = icmp slt i64 %v11, -13
  %v731 = select i1 %v730, i64 %v7, i64 0
  %v732 = getelementptr i64, ptr %v6, i64 %v11
  %v733 = getelementptr i8, ptr %v732, i64 104
  %v734 = getelementptr i64, ptr %v733, i64 %v731
  %v735 = getelementptr i8, ptr %v6, i64 88
  %v736 = shl i64 %v144, 4
  %v737 = getelementptr i8, ptr %v142, i64 %v736
  %v738 = mul i64 %v135, 40
  %v739 = getelementptr i8, ptr %v133, i64 %v738
  %v740 = mul i64 %v135, 56
  %v741 = getelementptr i8, ptr %v133, i64 %v740
  %v742 = mul i64 %v135, 216
  %v743 = getelementptr i8, ptr %v133, i64 %v742
  %v744 = mul i64 %v135, 48
  %v745 = getelementptr i8, ptr %v133, i64 %v744
  %v746 = shl i64 %v135, 5
  %v747 = getelementptr i8, ptr %v133, i64 %v746
  %v748 = getelementptr double, ptr %v133, i64 %v135
  %v749 = mul i64 %v135, 224
  %v750 = getelementptr i8, ptr %v133, i64 %v749
  %v751 = mul i64 %v196, %v195
  %v752 = mul i64 %v135, 48
  %v753 = getelementptr i8, ptr %v133, i64 %v752
  %v754 = shl i64 %v135, 6
  %v755 = getelementptr i8, ptr %v133, i64 %v754
  %v756 = shl i64 %v751, 7
  %v757 = icmp slt i64 %v10, 1
  %v758 = getelementptr i8, ptr %v193, i64 %v756
  %v759 = mul i64 %v207, 3
  %v760 = getelementptr i8, ptr %v6, i64 32
  %v761 = mul i64 %v751, 192
  %v762 = mul i64 %v751, 184
  %v763 = mul i64 %v751, 176
  %v764 = mul i64 %v751, 168
  %v765 = mul i64 %v751, 160
  %v766 = mul i64 %v751, 152
  %v767 = mul i64 %v751, 144
  %v768 = getelementptr double, ptr %v92, i64 %v93
  %v769 = getelementptr i8, ptr %v768, i64 -8
  %v770 = icmp slt i64 %v15, 1
  %v771 = mul i64 %v207, %v206
  %v772 = shl i64 %v207, 4
  %v773 = getelementptr double, ptr %v204, i64 %v207
  %v774 = getelementptr i8, ptr %v204, i64 %v772
  %v775 = shl i64 %v771, 4
  %v776 = mul i64 %v771, 24
  %v777 = shl i64 %v771, 5
  %v778 = mul i64 %v771, 40
  %v779 = mul i64 %v771, 48
  %v780 = mul i64 %v771, 56
  %v781 = shl i64 %v771, 6
  %v782 = mul i64 %v135, 104
  %v783 = getelementptr i8, ptr %v133, i64 %v782
  %v784 = getelementptr double, ptr %v92, i64 %v93
  %v785 = getelementptr i8, ptr %v784, i64 -8
  %v786 = mul i64 %v135, 56
  %v787 = getelementptr i8, ptr %v133, i64 %v786
  %v788 = mul i64 %v135, 120
  %v789 = getelementptr i8, ptr %v133, i64 %v788
  %v790 = mul i64 %v135, 112
  %v791 = getelementptr i8, ptr %v133, i64 %v790
  %v792 = mul i64 %v207, %v206
  %v793 = shl i64 %v135, 7
  %v794 = getelementptr i8, ptr %v133, i64 %v793
  %v795 = mul i64 %v135, 136
  %v796 = getelementptr i8, ptr %v133, i64 %v795
  %v797 = icmp sgt i64 %v10, 0
  %v798 = shl i64 %v10, 7
  %v799 = getelementptr i8, ptr %v158, i64 %v798
  %v800 = mul i64 %v207, 216
  %v801 = getelementptr i8, ptr %v186, i64 %v800
  %v802 = sub i64 %v207, %v18
  %v803 = tail call i64 @llvm.smax.i64(i64 %v802, i64 0)
  %v804 = icmp sgt i64 %v802, 0
  %v805 = shl i64 %v792, 6
  %v806 = getelementptr i8, ptr %v204, i64 %v805
  %v807 = shl i64 %v207, 4
  %v808 = getelementptr i8, ptr %v806, i64 %v807
  %v809 = mul i64 %v792, 72
  %v810 = getelementptr i8, ptr %v204, i64 %v809
  %v811 = getelementptr i8, ptr %v810, i64 %v807
  %v812 = icmp slt i64 %v207, 1
  %v813 = getelementptr double, ptr %v810, i64 %v207
  %v814 = mul i64 %v792, 80
  %v815 = getelementptr i8, ptr %v204, i64 %v814
  %v816 = tail call i64 @llvm.smax.i64(i64 %v10, i64 0)
  %v817 = mul i64 %v499, %v195
  %v818 = getelementptr i8, ptr %v193, i64 %v817
  %v819 = mul nsw i64 %v10, %v9
  %v820 = shl i64 %v819, 7
  %v821 = getelementptr i8, ptr %v158, i64 %v820
  %v822 = mul i64 %v819, 112
  %v823 = getelementptr i8, ptr %v158, i64 %v822
  %v824 = getelementptr i8, ptr %v6, i64 8
  %v825 = mul i64 %v819, 120
  %v826 = getelementptr i8, ptr %v158, i64 %v825
  %v827 = getelementptr i8, ptr %v23, i64 8
  %v828 = mul i64 %v751, 120
  %v829 = getelementptr i8, ptr %v193, i64 %v828
  %v830 = mul i64 %v751, 112
  %v831 = getelementptr i8, ptr %v193, i64 %v830
  %v832 = mul i64 %v135, 40
  %v833 = getelementptr i8, ptr %v133, i64 %v832
  %v834 = icmp slt i64 %v18, 1
  %v835 = mul i64 %v792, 80
  %v836 = getelementptr i8, ptr %v204, i64 %v835
  %v837 = mul i64 %v819, 136
  %v838 = getelementptr i8, ptr %v158, i64 %v837
  %v839 = mul i64 %v819, 104
  %v840 = getelementptr i8, ptr %v158, i64 %v839
  %v841 = mul i64 %v135, 40
  %v842 = getelementptr i8, ptr %v133, i64 %v841
  %v843 = select i1 %v812, i64 0, i64 %v207
  %v844 = icmp slt i64 %v802, 1
  %v845 = shl i64 %v144, 4
  %v846 = getelementptr i8, ptr %v142, i64 %v845
  %v847 = mul i64 %v135, 224
  %v848 = getelementptr i8, ptr %v133, i64 %v847
  %v849 = mul i64 %v102, %v101
  %v850 = mul i64 %v751, 136
  %v851 = getelementptr i8, ptr %v193, i64 %v850
  %v852 = add i64 %v93, -1
  %v853 = shl i64 %v144, 5
  %v854 = getelementptr i8, ptr %v142, i64 %v853
  %v855 = mul i64 %v135, 40
  %v856 = getelementptr i8, ptr %v133, i64 %v855
  %v857 = mul i64 %v135, 96
  %v858 = getelementptr i8, ptr %v133, i64 %v857
  %v859 = mul i64 %v135, 216
  %v860 = getelementptr i8, ptr %v133, i64 %v859
  %v861 = mul i64 %v135, 40
  %v862 = getelementptr i8, ptr %v133, i64 %v861
  %v863 = shl i64 %v135, 5
  %v864 = getelementptr i8, ptr %v133, i64 %v863
  %v865 = getelementptr double, ptr %v133, i64 %v135
  %v866 = mul i64 %v751, 136
  %v867 = getelementptr i8, ptr %v193, i64 %v866
  %v868 = mul nsw i64 %v10, %v9
  %v869 = mul i64 %v868, 136
  %v870 = getelementptr i8, ptr %v158, i64 %v869
  %v871 = mul i64 %v868, 104
  %v872 = getelementptr i8, ptr %v158, i64 %v871
  %v873 = mul i64 %v10, 136
  %v874 = getelementptr i8, ptr %v158, i64 %v873
  %v875 = mul i64 %v207, 192
  %v876 = getelementptr i8, ptr %v186, i64 %v875
  %v877 = mul i64 %v196, %v195
  %v878 = mul i64 %v135, 40
  %v879 = getelementptr i8, ptr %v133, i64 %v878
  %v880 = mul i64 %v135, 56
  %v881 = getelementptr i8, ptr %v133, i64 %v880
  %v882 = shl i64 %v144, 4
  %v883 = getelementptr i8, ptr %v142, i64 %v882
  %v884 = mul i64 %v135, 48
  %v885 = getelementptr i8, ptr %v133, i64 %v884
  %v886 = mul i64 %v877, 136
  %v887 = icmp slt i64 %v10, 1
  %v888 = mul i64 %v135, 224
  %v889 = getelementptr i8, ptr %v133, i64 %v888
  %v890 = mul i64 %v102, %v101
  %v891 = getelementptr i8, ptr %v193, i64 %v886
  %v892 = add i64 %v93, -1
  %v893 = mul i64 %v877, 192
  %v894 = mul i64 %v877, 184
  %v895 = mul i64 %v877, 176
  %v896 = mul i64 %v877, 168
  %v897 = mul i64 %v877, 160
  %v898 = mul i64 %v877, 152
  %v899 = mul i64 %v877, 144
  %v900 = icmp sgt i64 %v9, 1
  %v901 = mul i64 %v135, 40
  %v902 = getelementptr i8, ptr %v133, i64 %v901
  %v903 = getelementptr i8, ptr %v6, i64 80
  %v904 = mul i64 %v135, 40
  %v905 = getelementptr i8, ptr %v133, i64 %v904
  %v906 = shl i64 %v500, 6
  %v907 = icmp sgt i64 %v18, 0
  %v908 = getelementptr i8, ptr %v204, i64 %v906
  %v909 = mul i64 %v135, 96
  %v910 = getelementptr i8, ptr %v133, i64 %v909
  %v911 = mul i64 %v135, 120
  %v912 = getelementptr i8, ptr %v133, i64 %v911
  %v913 = icmp slt i64 %v10, 1
  %v914 = getelementptr i8, ptr %v23, i64 8
  %v915 = getelementptr double, ptr %v92, i64 %v93
  %v916 = getelementptr i8, ptr %v915, i64 -8
  %v917 = mul i64 %v144, 24
  %v918 = getelementptr i8, ptr %v142, i64 %v917
  %v919 = mul i64 %v144, 24
  %v920 = getelementptr i8, ptr %v142, i64 %v919
  %v921 = mul i64 %v135, 24
  %v922 = getelementptr i8, ptr %v133, i64 %v921
  %v923 = icmp ne i64 %v16, 0
  %v924 = tail call i64 @llvm.smax.i64(i64 %v9, i64 0)
  %v925 = mul i64 %v135, 40
  %v926 = getelementptr i8, ptr %v133, i64 %v925
  %v927 = shl i64 %v135, 4
  %v928 = getelementptr i8, ptr %v133, i64 %v927
  %v929 = getelementptr i64, ptr %v142, i64 %v144
  %v930 = icmp slt i64 %v63, 1
  %v931 = getelementptr i8, ptr %v6, i64 8
  %v932 = mul nsw i64 %v10, %v9
  %v933 = getelementptr i8, ptr %v6, i64 24
  %v934 = mul i64 %v932, 136
  %v935 = getelementptr i8, ptr %v158, i64 %v934
  %v936 = mul i64 %v102, %v101
  %v937 = add nsw i64 %v924, -1
  %v938 = mul i64 %v196, %v195
  %v939 = shl i64 %v144, 4
  %v940 = getelementptr i8, ptr %v142, i64 %v939
  %v941 = mul i64 %v938, 136
  %v942 = icmp slt i64 %v10, 1
  %v943 = getelementptr i8, ptr %v193, i64 %v941
  %v944 = getelementptr double, ptr %v92, i64 %v93
  %v945 = getelementptr i8, ptr %v944, i64 -8
  %v946 = shl i64 %v135, 6
  %v947 = getelementptr i8, ptr %v133, i64 %v946
  %v948 = mul i64 %v932, 112
  %v949 = getelementptr i8, ptr %v158, i64 %v948
  %v950 = mul i64 %v938, 112
  %v951 = getelementptr i8, ptr %v193, i64 %v950
  %v952 = shl i64 %v938, 7
  %v953 = getelementptr i8, ptr %v193, i64 %v952
  %v954 = getelementptr i8, ptr %v6, i64 32
  %v955 = mul i64 %v10, 136
  %v956 = getelementptr i8, ptr %v158, i64 %v955
  %v957 = mul i64 %v207, 216
  %v958 = getelementptr i8, ptr %v186, i64 %v957
  %v959 = shl i64 %v10, 7
  %v960 = getelementptr i8, ptr %v158, i64 %v959
  %v961 = mul i64 %v207, 240
  %v962 = getelementptr i8, ptr %v186, i64 %v961
  %v963 = sub i64 %v207, %v18
  %v964 = tail call i64 @llvm.smax.i64(i64 %v963, i64 0)
  %v965 = getelementptr double, ptr %v204, i64 %v207
  %v966 = mul i64 %v207, %v206
  %v967 = mul i64 %v966, 80
  %v968 = getelementptr i8, ptr %v965, i64 %v967
  %v969 = mul i64 %v966, 72
  %v970 = getelementptr i8, ptr %v204, i64 %v969
  %v971 = getelementptr double, ptr %v970, i64 %v207
  %v972 = shl i64 %v207, 4
  %v973 = getelementptr i8, ptr %v970, i64 %v972
  %v974 = shl i64 %v144, 5
  %v975 = getelementptr i8, ptr %v142, i64 %v974
  %v976 = mul i64 %v135, 112
  %v977 = getelementptr i8, ptr %v133, i64 %v976
  %v978 = mul i64 %v135, 40
  %v979 = getelementptr i8, ptr %v133, i64 %v978
  %v980 = shl i64 %v135, 4
  %v981 = getelementptr i8, ptr %v133, i64 %v980
  %v982 = getelementptr i64, ptr %v142, i64 %v144
  %v983 = mul i64 %v135, 24
  %v984 = getelementptr i8, ptr %v133, i64 %v983
  %v985 = mul i64 %v135, 24
  %v986 = getelementptr i8, ptr %v133, i64 %v985
  %v987 = icmp slt i64 %v63, 1
  %v988 = shl i64 %v144, 4
  %v989 = getelementptr i8, ptr %v142, i64 %v988
  %v990 = mul i64 %v135, 24
  %v991 = getelementptr i8, ptr %v133, i64 %v990
  %v992 = getelementptr i8, ptr %v151, i64 8
  %v993 = getelementptr i64, ptr %v142, i64 %v144
  %v994 = mul i64 %v144, 24
  %v995 = getelementptr i8, ptr %v142, i64 %v994
  %v996 = icmp slt i64 %v41, 1
  %v997 = icmp slt i64 %v63, 1
  %v998 = icmp slt i64 %v10, 1
  %v999 = mul i64 %v135, 144
  %v1000 = getelementptr i8, ptr %v133, i64 %v999
  %v1001 = mul i64 %v135, 240
  %v1002 = getelementptr i8, ptr %v133, i64 %v1001
  %v1003 = mul i64 %v135, 232
  %v1004 = getelementptr i8, ptr %v133, i64 %v1003
  %v1005 = shl i64 %v135, 4
  %v1006 = shl i64 %v135, 5
  %v1007 = mul i64 %v135, 48
  %v1008 = mul i64 %v135, 56
  %v1009 = shl i64 %v135, 6
  %v1010 = mul i64 %v135, 72
  %v1011 = mul i64 %v135, 80
  %v1012 = mul i64 %v135, 88
  %v1013 = mul i64 %v135, 96
  %v1014 = mul i64 %v135, 104
  %v1015 = mul i64 %v135, 112
  %v1016 = mul i64 %v135, 120
  %v1017 = shl i64 %v135, 7
  %v1018 = mul i64 %v135, 136
  %v1019 = mul i64 %v135, 152
  %v1020 = mul i64 %v135, 160
  %v1021 = mul i64 %v135, 168
  %v1022 = mul i64 %v135, 176
  %v1023 = mul i64 %v135, 184
  %v1024 = mul i64 %v135, 192
  %v1025 = mul i64 %v135, 200
  %v1026 = mul i64 %v135, 208
  %v1027 = mul i64 %v135, 216
  %v1028 = mul i64 %v135, 224
  %v1029 = getelementptr i8, ptr %v133, i64 %v1016
  %v1030 = getelementptr i8, ptr %v133, i64 %v1028
  %v1031 = getelementptr i8, ptr %v133, i64 %v1005
  %v1032 = mul i64 %v135, 232
  %v1033 = getelementptr i8, ptr %v133, i64 %v1032
  %v1034 = getelementptr double, ptr %v92, i64 %v93
  %v1035 = getelementptr i8, ptr %v1034, i64 -8
  %v1036 = getelementptr double, ptr %v133, i64 %v135
  %v1037 = mul i64 %v135, 232
  %v1038 = getelementptr i8, ptr %v133, i64 %v1037
  %v1039 = mul i64 %v135, 176
  %v1040 = getelementptr i8, ptr %v133, i64 %v1039
  %v1041 = shl i64 %v135, 4
  %v1042 = getelementptr i8, ptr %v133, i64 %v1041
  %v1043 = mul i64 %v135, 168
  %v1044 = getelementptr i8, ptr %v133, i64 %v1043
  %v1045 = shl i64 %v144, 4
  %v1046 = getelementptr i8, ptr %v142, i64 %v1045
  %v1047 = shl i64 %v716, 4
  %v1048 = mul i64 %v716, 24
  %v1049 = shl i64 %v716, 5
  %v1050 = mul i64 %v716, 40
  %v1051 = mul i64 %v716, 48
  %v1052 = mul i64 %v716, 56
  %v1053 = shl i64 %v716, 6
  %v1054 = shl i64 %v718, 4
  %v1055 = shl i64 %v718, 5
  %v1056 = mul i64 %v718, 48
  %v1057 = shl i64 %v718, 6
  %v1058 = mul i64 %v718, 24
  %v1059 = shl i64 %v718, 4
  %v1060 = shl i64 %v718, 5
  %v1061 = mul i64 %v718, 48
  %v1062 = shl i64 %v718, 6
  %v1063 = mul i64 %v718, 40
  %v1064 = shl i64 %v718, 4
  %v1065 = shl i64 %v718, 5
  %v1066 = mul i64 %v718, 48
  %v1067 = shl i64 %v718, 6
  %v1068 = mul i64 %v718, 56
  %v1069 = shl i64 %v718, 4
  %v1070 = shl i64 %v718, 5
  %v1071 = mul i64 %v718, 48
  %v1072 = shl i64 %v718, 6
  br label %v1073

v1073:
  %v1074 = phi i64 [ %v1075, %v1076 ], [ %v297, %v494 ]
  %v1077 = phi i64 [ %v1078, %v1076 ], [ %v490, %v494 ]
  %v1079 = add nsw i64 %v1074, -1
  %v1080 = load i64, ptr %v496, align 8, !noalias !11
  %v1081 = icmp eq i64 %v1080, 0
  br i1 %v1081, label %v1082, label %v1083

v1083:
  %v1084 = icmp eq i64 %v1080, 2
  store i64 0, ptr %v496, align 8, !noalias !11
  %v1085 = load i64, ptr %v501, align 8, !noalias !15
  %v1086 = inttoptr i64 %v1085 to ptr
  tail call void %v1086(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !15
  br i1 %v305, label %v1087, label %v1088

v1087:
  %v1089 = load i64, ptr %v502, align 8, !noalias !18
  %v1090 = inttoptr i64 %v1089 to ptr
  tail call void %v1090(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !18
  %v1091 = load double, ptr %v504, align 8, !noalias !24
  %v1092 = fcmp une double %v1091, 2.500000e-01
  br i1 %v1092, label %v1088, label %v1093

v1093:
  store double 0.000000e+00, ptr %v504, align 8, !noalias !24
  br i1 %v505, label %v1094, label %v1095

v1096:
  store double 1.000000e+00, ptr %v504, align 8, !noalias !24
  br label %v1097

v1097:
  %v1098 = icmp eq i64 %v1099, %v18
  br i1 %v1098, label %v1095, label %v1094

v1095:
  %v1100 = load double, ptr %v504, align 8, !noalias !24
  %v1101 = fcmp ogt double %v1100, 5.000000e-01
  %v1102 = or i1 %v1084, %v1101
  br label %v1088

v1094:
  %v1103 = phi i64 [ %v1099, %v1097 ], [ 0, %v1093 ]
  %v1099 = add nsw i64 %v1103, 1
  %v1104 = getelementptr double, ptr %v204, i64 %v1103
  %v1105 = load double, ptr %v1104, align 8, !noalias !24
  %v1106 = add nsw i64 %v1103, %v17
  %v1107 = icmp slt i64 %v1106, 0
  %v1108 = select i1 %v1107, i64 %v166, i64 0
  %v1109 = getelementptr double, ptr %v165, i64 %v1106
  %v1110 = getelementptr double, ptr %v1109, i64 %v1108
  %v1111 = load double, ptr %v1110, align 8, !noalias !24
  %v1112 = fcmp une double %v1105, %v1111
  br i1 %v1112, label %v1096, label %v1097

v1088:
  %v1113 = phi i1 [ %v1084, %v1083 ], [ %v1102, %v1095 ], [ %v1084, %v1087 ]
  br i1 %v1113, label %v1114, label %v1082

v1114:
  br i1 %v305, label %v1115, label %v1116

v1115:
  %v1117 = load i64, ptr %v506, align 8, !noalias !25
  %v1118 = inttoptr i64 %v1117 to ptr
  tail call void %v1118(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !25
  %v1119 = load double, ptr %v508, align 8, !noalias !31
  %v1120 = fcmp ule double %v1119, 5.000000e-01
  %v1121 = select i1 %v1120, i1 true, i1 %v509
  br i1 %v1121, label %v1122, label %v1123

v1122:
  %v1124 = load i64, ptr %v501, align 8, !noalias !32
  %v1125 = inttoptr i64 %v1124 to ptr
  tail call void %v1125(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !32
  br label %v1116

v1123:
  %v1126 = phi i64 [ %v1127, %v1123 ], [ 0, %v1115 ]
  %v1127 = add nsw i64 %v1126, 1
  %v1128 = getelementptr double, ptr %v204, i64 %v1126
  %v1129 = load double, ptr %v1128, align 8, !noalias !31
  %v1130 = add nsw i64 %v1126, %v17
  %v1131 = icmp slt i64 %v1130, 0
  %v1132 = select i1 %v1131, i64 %v166, i64 0
  %v1133 = getelementptr double, ptr %v165, i64 %v1130
  %v1134 = getelementptr double, ptr %v1133, i64 %v1132
  store double %v1129, ptr %v1134, align 8, !noalias !31
  %v1135 = icmp eq i64 %v1127, %v18
  br i1 %v1135, label %v1122, label %v1123

v1116:
  br i1 %v510, label %v1136, label %v1137

v1136:
  %v1138 = load i64, ptr %v6, align 8, !noalias !35
  %v1139 = inttoptr i64 %v1138 to ptr
  tail call void %v1139(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v513), !noalias !35
  %v1140 = load i64, ptr %v514, align 8, !noalias !38
  %v1141 = inttoptr i64 %v1140 to ptr
  tail call void %v1141(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !38
  %v1142 = load i64, ptr %v515, align 8, !noalias !41
  %v1143 = inttoptr i64 %v1142 to ptr
  tail call void %v1143(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !41
  %v1144 = load i64, ptr %v6, align 8, !noalias !44
  %v1145 = inttoptr i64 %v1144 to ptr
  tail call void %v1145(ptr %v517, ptr %v519, ptr %v165, ptr %v172, ptr %v179, ptr %v521), !noalias !44
  %v1146 = load i64, ptr %v522, align 8, !noalias !47
  %v1147 = inttoptr i64 %v1146 to ptr
  tail call void %v1147(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !47
  br label %v1137

v1137:
  br i1 %v307, label %v1082, label %v1148

v1149:
  store double 0.000000e+00, ptr %v1150, align 8, !noalias !50
  %v1151 = getelementptr double, ptr %v527, i64 %v1152
  store double 0.000000e+00, ptr %v1151, align 8, !noalias !50
  %v1153 = getelementptr double, ptr %v529, i64 %v1152
  store double 0.000000e+00, ptr %v1153, align 8, !noalias !50
  %v1154 = getelementptr i64, ptr %v142, i64 %v1152
  %v1155 = load i64, ptr %v1154, align 8, !noalias !50
  %v1156 = icmp slt i64 %v1155, 0
  %v1157 = select i1 %v1156, i64 %v125, i64 0
  %v1158 = add i64 %v1157, %v1155
  %v1159 = mul i64 %v1158, %v126
  %v1160 = getelementptr i64, ptr %v124, i64 %v1159
  %v1161 = getelementptr i8, ptr %v1160, i64 8
  %v1162 = load i64, ptr %v1161, align 8, !noalias !50
  %v1163 = add nsw i64 %v1162, %v531
  store i64 %v1163, ptr %v1161, align 8, !noalias !50
  %v1164 = load i64, ptr %v1154, align 8, !noalias !50
  %v1165 = icmp slt i64 %v1164, 0
  %v1166 = select i1 %v1165, i64 %v125, i64 0
  %v1167 = add i64 %v1166, %v1164
  %v1168 = mul i64 %v1167, %v126
  %v1169 = getelementptr i64, ptr %v124, i64 %v1168
  %v1170 = getelementptr i8, ptr %v1169, i64 16
  %v1171 = load i64, ptr %v1170, align 8, !noalias !50
  %v1172 = add nsw i64 %v1171, %v532
  store i64 %v1172, ptr %v1170, align 8, !noalias !50
  %v1173 = getelementptr double, ptr %v534, i64 %v1152
  %v1174 = load double, ptr %v1173, align 8, !noalias !50
  %v1175 = fcmp une double %v1174, 0.000000e+00
  br i1 %v1175, label %v1176, label %v1177

v1176:
  %v1178 = load i64, ptr %v1154, align 8, !noalias !54
  %v1179 = icmp sgt i64 %v1178, -1
  br i1 %v1179, label %v1180, label %v1177

v1180:
  %v1181 = getelementptr i64, ptr %v110, i64 %v1178
  %v1182 = load i64, ptr %v1181, align 8, !noalias !54
  %v1183 = icmp eq i64 %v1182, 0
  br i1 %v1183, label %v1184, label %v1177

v1184:
  store i64 3, ptr %v1181, align 8, !noalias !54
  br label %v1177

v1177:
  br i1 %v304, label %v1185, label %v1186

v1185:
  %v1187 = load double, ptr %v536, align 8, !noalias !57
  %v1188 = load double, ptr %v92, align 8, !noalias !57
  %v1189 = fsub double %v1187, %v1188
  %v1190 = fmul double %v1189, 1.000000e-13
  %v1191 = load double, ptr %v133, align 8, !noalias !57
  %v1192 = tail call double @llvm.fabs.f64(double %v1191)
  %v1193 = fmul double %v1192, 4.000000e-15
  %v1194 = fcmp ogt double %v1193, %v1190
  %v1195 = select i1 %v1194, double %v1193, double %v1190
  %v1196 = fadd double %v1191, %v1195
  store double %v1196, ptr %v538, align 8, !noalias !67
  %v1197 = load i64, ptr %v6, align 8, !noalias !68
  %v1198 = inttoptr i64 %v1197 to ptr
  tail call void %v1198(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v539), !noalias !68
  br i1 %v540, label %v1199, label %v1200

v1199:
  %v1201 = load i64, ptr %v546, align 8, !noalias !71
  %v1202 = inttoptr i64 %v1201 to ptr
  tail call void %v1202(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v548), !noalias !71
  %v1203 = load i64, ptr %v546, align 8, !noalias !74
  %v1204 = inttoptr i64 %v1203 to ptr
  tail call void %v1204(ptr nonnull %v538, ptr %v550, ptr %v165, ptr %v172, ptr %v179, ptr %v552), !noalias !74
  br label %v1205

v1205:
  %v1206 = phi i64 [ %v18, %v1199 ], [ %v1207, %v1208 ]
  %v1209 = phi i64 [ %v554, %v1199 ], [ %v1210, %v1208 ]
  %v1211 = icmp sgt i64 %v1209, 0
  br i1 %v1211, label %v1208, label %v1212

v1208:
  %v1210 = add nsw i64 %v1209, -1
  %v1207 = add i64 %v1206, 1
  %v1213 = icmp slt i64 %v1206, 0
  %v1214 = select i1 %v1213, i64 %v207, i64 0
  %v1215 = add i64 %v1214, %v1206
  %v1216 = getelementptr double, ptr %v558, i64 %v1215
  %v1217 = load double, ptr %v1216, align 8, !noalias !67
  %v1218 = getelementptr double, ptr %v561, i64 %v1215
  %v1219 = load double, ptr %v1218, align 8, !noalias !67
  %v1220 = fsub double %v1217, %v1219
  %v1221 = tail call double @llvm.fabs.f64(double %v1220)
  %v1222 = getelementptr double, ptr %v563, i64 %v1215
  %v1223 = load double, ptr %v1222, align 8, !noalias !67
  %v1224 = tail call i1 @llvm.is.fpclass.f64(double %v1223, i32 543)
  %v1225 = select i1 %v1224, double 0.000000e+00, double %v1223
  %v1226 = fcmp ueq double %v1221, 0x7FF0000000000000
  %v1227 = select i1 %v1226, double -0.000000e+00, double %v1221
  %v1228 = fadd double %v1225, %v1227
  %v1229 = getelementptr double, ptr %v560, i64 %v1215
  %v1230 = load double, ptr %v1229, align 8, !noalias !67
  %v1231 = fneg double %v1228
  %v1232 = fcmp olt double %v1230, %v1231
  br i1 %v1232, label %v1212, label %v1205

v1200:
  %v1233 = phi i64 [ %v1234, %v1200 ], [ 0, %v1185 ]
  %v1234 = add nsw i64 %v1233, 1
  %v1235 = mul i64 %v1233, %v196
  %v1236 = getelementptr double, ptr %v193, i64 %v1235
  %v1237 = load double, ptr %v1236, align 8, !noalias !67
  %v1238 = getelementptr double, ptr %v543, i64 %v1235
  %v1239 = load double, ptr %v1238, align 8, !noalias !67
  %v1240 = fmul double %v1195, %v1239
  %v1241 = fadd double %v1237, %v1240
  %v1242 = getelementptr double, ptr %v545, i64 %v1235
  store double %v1241, ptr %v1242, align 8, !noalias !67
  %v1243 = icmp eq i64 %v10, %v1234
  br i1 %v1243, label %v1199, label %v1200

v1244:
  %v1245 = getelementptr i64, ptr %v565, i64 %v1152
  store i64 %v1246, ptr %v1245, align 8, !noalias !77
  %v1247 = load i64, ptr %v1154, align 8, !noalias !78
  %v1248 = icmp sgt i64 %v1247, -1
  br i1 %v1248, label %v1249, label %v1250

v1249:
  %v1251 = getelementptr i64, ptr %v110, i64 %v1247
  %v1252 = load i64, ptr %v1251, align 8, !noalias !78
  %v1253 = icmp eq i64 %v1252, 0
  br i1 %v1253, label %v1254, label %v1250

v1254:
  store i64 4, ptr %v1251, align 8, !noalias !78
  br label %v1250

v1250:
  %v1255 = getelementptr double, ptr %v133, i64 %v1152
  %v1256 = load double, ptr %v1255, align 8, !noalias !77
  %v1257 = getelementptr double, ptr %v567, i64 %v1152
  store double %v1256, ptr %v1257, align 8, !noalias !77
  %v1258 = getelementptr double, ptr %v569, i64 %v1152
  store double 0.000000e+00, ptr %v1258, align 8, !noalias !77
  br label %v1186

v1212:
  %v1246 = phi i64 [ %v1206, %v1208 ], [ -1, %v1205 ]
  %v1259 = icmp sgt i64 %v1246, -1
  br i1 %v1259, label %v1244, label %v1186

v1260:
  %v1261 = icmp sgt i64 %v1262, 1
  br i1 %v1261, label %v1148, label %v1082

v1148:
  %v1262 = phi i64 [ %v1263, %v1260 ], [ %v308, %v1137 ]
  %v1152 = phi i64 [ %v1264, %v1260 ], [ 0, %v1137 ]
  %v1263 = add nsw i64 %v1262, -1
  %v1264 = add nsw i64 %v1152, 1
  %v1150 = getelementptr double, ptr %v525, i64 %v1152
  %v1265 = load double, ptr %v1150, align 8, !noalias !50
  %v1266 = fcmp olt double %v1265, 5.000000e-01
  br i1 %v1266, label %v1260, label %v1149

v1186:
  %v1267 = getelementptr double, ptr %v571, i64 %v1152
  %v1268 = load double, ptr %v1267, align 8, !noalias !81
  %v1269 = getelementptr double, ptr %v573, i64 %v1152
  store double %v1268, ptr %v1269, align 8, !noalias !81
  %v1270 = getelementptr i64, ptr %v575, i64 %v1152
  %v1271 = load i64, ptr %v1270, align 8, !noalias !81
  %v1272 = icmp slt i64 %v1271, %v93
  br i1 %v1272, label %v1273, label %v1260

v1273:
  %v1274 = icmp slt i64 %v1271, 0
  %v1275 = select i1 %v1274, i64 %v93, i64 0
  %v1276 = getelementptr double, ptr %v92, i64 %v1271
  %v1277 = getelementptr double, ptr %v1276, i64 %v1275
  %v1278 = load double, ptr %v1277, align 8, !noalias !81
  %v1279 = load double, ptr %v1267, align 8, !noalias !81
  %v1280 = fcmp olt double %v1279, %v1278
  %v1281 = select i1 %v1280, double %v1279, double %v1278
  store double %v1281, ptr %v1269, align 8, !noalias !81
  br label %v1260

v1082:
  %v1282 = phi i1 [ %v660, %v1088 ], [ %v660, %v1073 ], [ true, %v1137 ], [ true, %v1260 ]
  %v1283 = load i64, ptr %v576, align 8, !noalias !85
  %v1284 = inttoptr i64 %v1283 to ptr
  tail call void %v1284(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !85
  br i1 %v577, label %v1285, label %v1286

v1287:
  %v1288 = getelementptr double, ptr %v662, i64 %v1289
  %v1290 = load double, ptr %v1288, align 8
  %v1291 = fcmp ogt double %v1290, 5.000000e-01
  br label %v1292

v1292:
  %v1293 = phi i1 [ true, %v1294 ], [ %v1291, %v1287 ]
  br i1 %v1295, label %v1296, label %v1297

v1297:
  %v1298 = getelementptr double, ptr %v664, i64 %v1289
  %v1299 = load double, ptr %v1298, align 8
  %v1300 = fcmp ogt double %v1299, 5.000000e-01
  br label %v1296

v1296:
  %v1301 = phi i1 [ true, %v1292 ], [ %v1300, %v1297 ]
  %v1302 = icmp sgt i64 %v1303, 1
  br i1 %v1302, label %v1294, label %v1304

v1304:
  %v1305 = phi i1 [ false, %v1306 ], [ %v1293, %v1296 ]
  %v1307 = phi i1 [ %v1282, %v1306 ], [ %v1301, %v1296 ]
  %v1308 = xor i1 %v1307, true
  %v1309 = or i1 %v307, %v1308
  br i1 %v1309, label %v1310, label %v1311

v1312:
  br i1 %v307, label %v1310, label %v1313

v1314:
  %v1315 = getelementptr double, ptr %v666, i64 %v1316
  %v1317 = load double, ptr %v1315, align 8, !noalias !91
  %v1318 = fptosi double %v1317 to i64
  %v1319 = getelementptr double, ptr %v668, i64 %v1316
  %v1320 = load double, ptr %v1319, align 8, !noalias !91
  %v1321 = fptosi double %v1320 to i64
  %v1322 = mul i64 %v1323, %v126
  %v1324 = getelementptr i64, ptr %v124, i64 %v1322
  %v1325 = load i64, ptr %v1324, align 8, !noalias !91
  %v1326 = add nsw i64 %v1325, %v1318
  store i64 %v1326, ptr %v1324, align 8, !noalias !91
  %v1327 = getelementptr i8, ptr %v1324, i64 24
  %v1328 = load i64, ptr %v1327, align 8, !noalias !91
  %v1329 = add nsw i64 %v1328, %v1321
  store i64 %v1329, ptr %v1327, align 8, !noalias !91
  %v1330 = getelementptr i8, ptr %v1324, i64 8
  %v1331 = load i64, ptr %v1330, align 8, !noalias !91
  %v1332 = add nsw i64 %v1321, %v1318
  %v1333 = mul nsw i64 %v1332, %v636
  %v1334 = add nsw i64 %v1333, %v1318
  %v1335 = add nsw i64 %v1334, %v1331
  store i64 %v1335, ptr %v1330, align 8, !noalias !91
  store double 0.000000e+00, ptr %v1315, align 8, !noalias !91
  store double 0.000000e+00, ptr %v1319, align 8, !noalias !91
  %v1336 = getelementptr double, ptr %v670, i64 %v1316
  %v1337 = load double, ptr %v1336, align 8, !noalias !91
  %v1338 = sitofp i64 %v1332 to double
  %v1339 = fsub double %v1337, %v1338
  store double %v1339, ptr %v1336, align 8, !noalias !91
  br label %v1340

v1340:
  %v1341 = icmp sgt i64 %v1342, 1
  br i1 %v1341, label %v1311, label %v1312

v1311:
  %v1342 = phi i64 [ %v1343, %v1340 ], [ %v308, %v1304 ]
  %v1316 = phi i64 [ %v1344, %v1340 ], [ 0, %v1304 ]
  %v1343 = add nsw i64 %v1342, -1
  %v1344 = add nsw i64 %v1316, 1
  %v1345 = getelementptr i64, ptr %v142, i64 %v1316
  %v1323 = load i64, ptr %v1345, align 8, !noalias !91
  %v1346 = icmp sgt i64 %v1323, -1
  br i1 %v1346, label %v1314, label %v1340

v1347:
  %v1348 = getelementptr double, ptr %v676, i64 %v1349
  %v1350 = load double, ptr %v1348, align 8, !noalias !98
  %v1351 = fcmp ogt double %v1350, 5.000000e-01
  br i1 %v1351, label %v1352, label %v1353

v1352:
  %v1354 = fptosi double %v1350 to i64
  %v1355 = load i64, ptr %v1356, align 8, !noalias !99
  %v1357 = icmp sgt i64 %v1355, -1
  br i1 %v1357, label %v1358, label %v1353

v1353:
  %v1359 = getelementptr double, ptr %v678, i64 %v1349
  %v1360 = load double, ptr %v1359, align 8, !noalias !98
  %v1361 = fcmp ogt double %v1360, 5.000000e-01
  br i1 %v1361, label %v1362, label %v1363

v1362:
  %v1364 = select i1 %v1365, i1 true, i1 %v304
  %v1366 = icmp slt i64 %v1367, %v93
  br i1 %v1366, label %v1368, label %v1369

v1368:
  %v1370 = icmp slt i64 %v1367, 0
  %v1371 = select i1 %v1370, i64 %v93, i64 0
  %v1372 = getelementptr double, ptr %v92, i64 %v1367
  %v1373 = getelementptr double, ptr %v1372, i64 %v1371
  %v1374 = load double, ptr %v1373, align 8, !noalias !98
  %v1375 = getelementptr double, ptr %v680, i64 %v1349
  %v1376 = load double, ptr %v1375, align 8, !noalias !98
  %v1377 = fcmp olt double %v1374, %v1376
  br i1 %v1377, label %v1378, label %v1369

v1378:
  br label %v1369

v1369:
  %v1379 = phi i1 [ true, %v1378 ], [ %v1364, %v1368 ], [ %v1364, %v1362 ]
  %v1380 = mul i64 %v1381, %v126
  %v1382 = getelementptr i64, ptr %v124, i64 %v1380
  %v1383 = load i64, ptr %v1382, align 8, !noalias !98
  %v1384 = and i64 %v1383, 127
  %v1385 = icmp eq i64 %v1384, 0
  br i1 %v1385, label %v1386, label %v1387

v1387:
  %v1388 = getelementptr double, ptr %v682, i64 %v1349
  %v1389 = load double, ptr %v1388, align 8, !noalias !98
  %v1390 = fcmp ogt double %v1389, 0.000000e+00
  br i1 %v1390, label %v1386, label %v1363

v1386:
  store double 1.000000e+00, ptr %v1391, align 8, !noalias !98
  br label %v1363

v1363:
  %v1392 = phi i1 [ %v1379, %v1386 ], [ %v1379, %v1387 ], [ %v1365, %v1353 ], [ %v1365, %v1313 ]
  %v1393 = phi i1 [ true, %v1386 ], [ %v1394, %v1387 ], [ %v1394, %v1353 ], [ %v1394, %v1313 ]
  %v1395 = icmp sgt i64 %v1396, 1
  br i1 %v1395, label %v1313, label %v1397

v1313:
  %v1394 = phi i1 [ %v1393, %v1363 ], [ false, %v1312 ]
  %v1365 = phi i1 [ %v1392, %v1363 ], [ false, %v1312 ]
  %v1396 = phi i64 [ %v1398, %v1363 ], [ %v308, %v1312 ]
  %v1349 = phi i64 [ %v1399, %v1363 ], [ 0, %v1312 ]
  %v1398 = add nsw i64 %v1396, -1
  %v1399 = add nsw i64 %v1349, 1
  %v1356 = getelementptr i64, ptr %v142, i64 %v1349
  %v1381 = load i64, ptr %v1356, align 8, !noalias !98
  %v1400 = getelementptr i64, ptr %v672, i64 %v1349
  %v1367 = load i64, ptr %v1400, align 8, !noalias !98
  %v1391 = getelementptr double, ptr %v674, i64 %v1349
  store double 0.000000e+00, ptr %v1391, align 8, !noalias !98
  %v1401 = icmp sgt i64 %v1381, -1
  br i1 %v1401, label %v1347, label %v1363

v1358:
  %v1402 = getelementptr i64, ptr %v110, i64 %v1355
  %v1403 = load i64, ptr %v1402, align 8, !noalias !99
  %v1404 = icmp eq i64 %v1403, 0
  br i1 %v1404, label %v1405, label %v1353

v1405:
  store i64 %v1354, ptr %v1402, align 8, !noalias !99
  br label %v1353

v1310:
  %v1406 = phi i1 [ true, %v1304 ], [ true, %v1312 ], [ %v1407, %v1397 ]
  %v1408 = phi i1 [ true, %v1304 ], [ true, %v1312 ], [ %v1409, %v1397 ]
  %v1410 = and i1 %v683, %v1305
  br i1 %v1410, label %v1411, label %v1412

v1411:
  %v1413 = load i64, ptr %v6, align 8, !noalias !102
  %v1414 = inttoptr i64 %v1413 to ptr
  tail call void %v1414(ptr %v688, ptr %v691, ptr %v165, ptr %v172, ptr %v179, ptr %v693), !noalias !102
  br label %v1412

v1412:
  br i1 %v1408, label %v1415, label %v1416

v1416:
  %v1417 = load i64, ptr %v694, align 8, !noalias !108
  %v1418 = inttoptr i64 %v1417 to ptr
  tail call void %v1418(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !108
  br label %v1415

v1415:
  %v1419 = select i1 %v1305, i1 %v304, i1 false
  %v1420 = xor i1 %v1305, true
  %v1421 = select i1 %v305, i1 %v1305, i1 false
  %v1422 = xor i1 %v1421, true
  %v1423 = select i1 %v1422, i1 true, i1 %v1419
  %v1424 = select i1 %v305, i1 %v1305, i1 %v1419
  br i1 %v1423, label %v1425, label %v1426

v1426:
  %v1427 = load i64, ptr %v695, align 8, !noalias !111
  %v1428 = inttoptr i64 %v1427 to ptr
  tail call void %v1428(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !111
  br label %v1429

v1429:
  %v1430 = phi i64 [ 0, %v1426 ], [ %v1431, %v1432 ]
  %v1431 = add nsw i64 %v1430, 1
  %v1433 = icmp ult i64 %v1430, 9
  br i1 %v1433, label %v1434, label %v1435

v1434:
  %v1436 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v1430
  %v1437 = load double, ptr %v1436, align 8
  %v1438 = load double, ptr %v133, align 8, !noalias !114
  %v1439 = load double, ptr %v698, align 8, !noalias !114
  %v1440 = fmul double %v1437, %v1439
  %v1441 = fadd double %v1438, %v1440
  store double %v1441, ptr %v700, align 8, !noalias !114
  br i1 %v702, label %v1432, label %v1442

v1442:
  %v1443 = fsub double 1.000000e+00, %v1437
  br label %v1444

v1444:
  %v1445 = phi i64 [ 0, %v1442 ], [ %v1446, %v1444 ]
  %v1447 = mul i64 %v1445, %v196
  %v1448 = getelementptr double, ptr %v193, i64 %v1447
  %v1449 = getelementptr i8, ptr %v1448, i64 %v706
  %v1450 = load double, ptr %v1449, align 8, !noalias !124
  %v1451 = fadd double %v1450, 0.000000e+00
  %v1452 = fmul double %v1437, %v1451
  %v1453 = getelementptr i8, ptr %v1448, i64 %v707
  %v1454 = load double, ptr %v1453, align 8, !noalias !124
  %v1455 = fadd double %v1454, %v1452
  %v1456 = fmul double %v1443, %v1455
  %v1457 = getelementptr i8, ptr %v1448, i64 %v708
  %v1458 = load double, ptr %v1457, align 8, !noalias !124
  %v1459 = fadd double %v1458, %v1456
  %v1460 = fmul double %v1437, %v1459
  %v1461 = getelementptr i8, ptr %v1448, i64 %v709
  %v1462 = load double, ptr %v1461, align 8, !noalias !124
  %v1463 = fadd double %v1462, %v1460
  %v1464 = fmul double %v1443, %v1463
  %v1465 = getelementptr i8, ptr %v1448, i64 %v710
  %v1466 = load double, ptr %v1465, align 8, !noalias !124
  %v1467 = fadd double %v1466, %v1464
  %v1468 = fmul double %v1437, %v1467
  %v1469 = getelementptr i8, ptr %v1448, i64 %v711
  %v1470 = load double, ptr %v1469, align 8, !noalias !124
  %v1471 = fadd double %v1470, %v1468
  %v1472 = fmul double %v1443, %v1471
  %v1473 = getelementptr i8, ptr %v1448, i64 %v712
  %v1474 = load double, ptr %v1473, align 8, !noalias !124
  %v1475 = fadd double %v1474, %v1472
  %v1476 = fmul double %v1437, %v1475
  %v1446 = add nsw i64 %v1445, 1
  %v1477 = load double, ptr %v1448, align 8, !noalias !124
  %v1478 = fadd double %v1477, %v1476
  %v1479 = getelementptr double, ptr %v703, i64 %v1447
  store double %v1478, ptr %v1479, align 8, !noalias !114
  %v1480 = icmp eq i64 %v10, %v1446
  br i1 %v1480, label %v1432, label %v1444

v1432:
  %v1481 = icmp eq i64 %v1430, 8
  %v1482 = select i1 %v1481, i64 17, i64 16
  %v1483 = mul i64 %v704, %v1430
  %v1484 = load i64, ptr %v705, align 8, !noalias !128
  %v1485 = mul nsw i64 %v1482, %v10
  %v1486 = getelementptr double, ptr %v158, i64 %v1485
  %v1487 = getelementptr double, ptr %v186, i64 %v1483
  %v1488 = inttoptr i64 %v1484 to ptr
  tail call void %v1488(ptr nonnull %v700, ptr %v1486, ptr %v165, ptr %v172, ptr %v179, ptr %v1487), !noalias !128
  %v1489 = icmp eq i64 %v1431, 9
  br i1 %v1489, label %v1435, label %v1429

v1435:
  %v1490 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v1429 ], [ null, %v1432 ]
  %v1491 = phi i32 [ 1, %v1429 ], [ 0, %v1432 ]
  br i1 %v1433, label %v1492, label %v1493, !prof !131

v1425:
  %v1494 = phi i1 [ %v1424, %v1415 ], [ %v1495, %v1493 ]
  %v1496 = xor i1 %v1406, true
  %v1497 = select i1 %v1496, i1 true, i1 %v1494
  br i1 %v1497, label %v1498, label %v1499

v1498:
  br i1 %v723, label %v1500, label %v1501

v1502:
  %v1503 = load i64, ptr %v734, align 8, !noalias !132
  %v1504 = inttoptr i64 %v1503 to ptr
  tail call void %v1504(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !132
  br label %v1501

v1500:
  %v1505 = phi i64 [ %v1506, %v1500 ], [ 1, %v1498 ]
  %v1506 = add i64 %v1505, 1
  %v1507 = add nsw i64 %v724, %v1505
  %v1508 = icmp slt i64 %v1507, 0
  %v1509 = select i1 %v1508, i64 %v7, i64 0
  %v1510 = getelementptr i64, ptr %v6, i64 %v1507
  %v1511 = getelementptr i64, ptr %v1510, i64 %v1509
  %v1512 = load i64, ptr %v1511, align 8, !noalias !138
  %v1513 = inttoptr i64 %v1512 to ptr
  tail call void %v1513(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !138
  %v1514 = add nsw i64 %v1505, 13
  %v1515 = load i64, ptr %v6, align 8, !noalias !141
  %v1516 = mul nsw i64 %v1514, %v727
  %v1517 = getelementptr double, ptr %v158, i64 %v1516
  %v1518 = inttoptr i64 %v1515 to ptr
  tail call void %v1518(ptr %v726, ptr %v729, ptr %v165, ptr %v172, ptr %v179, ptr %v1517), !noalias !141
  %v1519 = icmp eq i64 %v1505, %v12
  br i1 %v1519, label %v1502, label %v1500

v1501:
  %v1520 = load i64, ptr %v735, align 8, !noalias !144
  %v1521 = inttoptr i64 %v1520 to ptr
  tail call void %v1521(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !144
  %v1522 = select i1 %v686, i1 true, i1 %v1420
  %v1523 = or i1 %v1522, %v307
  br i1 %v1523, label %v1524, label %v1525

v1526:
  %v1527 = getelementptr double, ptr %v739, i64 %v1528
  %v1529 = load double, ptr %v1527, align 8, !noalias !147
  %v1530 = fcmp uge double %v1529, 5.000000e-01
  %v1531 = icmp slt i64 %v1532, %v93
  %v1533 = select i1 %v1530, i1 %v1531, i1 false
  br i1 %v1533, label %v1534, label %v1535

v1534:
  %v1536 = icmp slt i64 %v1532, 0
  %v1537 = select i1 %v1536, i64 %v93, i64 0
  %v1538 = getelementptr double, ptr %v92, i64 %v1532
  %v1539 = getelementptr double, ptr %v1538, i64 %v1537
  %v1540 = load double, ptr %v1539, align 8, !noalias !147
  %v1541 = getelementptr double, ptr %v741, i64 %v1528
  %v1542 = load double, ptr %v1541, align 8, !noalias !147
  %v1543 = fcmp olt double %v1540, %v1542
  br i1 %v1543, label %v1544, label %v1535

v1544:
  %v1545 = getelementptr double, ptr %v743, i64 %v1528
  %v1546 = load double, ptr %v1545, align 8, !noalias !147
  %v1547 = fcmp ogt double %v1546, 1.000000e+00
  br i1 %v1547, label %v1548, label %v1535

v1548:
  %v1549 = getelementptr double, ptr %v745, i64 %v1528
  %v1550 = load double, ptr %v1549, align 8, !noalias !147
  store double 0.000000e+00, ptr %v1527, align 8, !noalias !151
  %v1551 = getelementptr double, ptr %v747, i64 %v1528
  store double 0.000000e+00, ptr %v1551, align 8, !noalias !151
  %v1552 = getelementptr double, ptr %v748, i64 %v1528
  store double %v1550, ptr %v1552, align 8, !noalias !151
  %v1553 = load i64, ptr %v1554, align 8, !noalias !151
  %v1555 = icmp slt i64 %v1553, 0
  %v1556 = select i1 %v1555, i64 %v125, i64 0
  %v1557 = add i64 %v1556, %v1553
  %v1558 = mul i64 %v1557, %v126
  %v1559 = getelementptr i64, ptr %v124, i64 %v1558
  %v1560 = load i64, ptr %v1559, align 8, !noalias !151
  %v1561 = add nsw i64 %v1560, -1
  store i64 %v1561, ptr %v1559, align 8, !noalias !151
  %v1562 = load i64, ptr %v1554, align 8, !noalias !151
  %v1563 = icmp slt i64 %v1562, 0
  %v1564 = select i1 %v1563, i64 %v125, i64 0
  %v1565 = add i64 %v1564, %v1562
  %v1566 = mul i64 %v1565, %v126
  %v1567 = getelementptr i64, ptr %v124, i64 %v1566
  %v1568 = getelementptr i8, ptr %v1567, i64 24
  %v1569 = load i64, ptr %v1568, align 8, !noalias !151
  %v1570 = add nsw i64 %v1569, 1
  store i64 %v1570, ptr %v1568, align 8, !noalias !151
  %v1571 = load double, ptr %v1539, align 8, !noalias !147
  %v1572 = getelementptr double, ptr %v750, i64 %v1528
  store double %v1571, ptr %v1572, align 8, !noalias !147
  %v1573 = mul i64 %v1574, %v126
  %v1575 = getelementptr i64, ptr %v124, i64 %v1573
  %v1576 = getelementptr i8, ptr %v1575, i64 8
  %v1577 = load i64, ptr %v1576, align 8, !noalias !147
  %v1578 = add nsw i64 %v1577, %v12
  store i64 %v1578, ptr %v1576, align 8, !noalias !147
  br label %v1535

v1535:
  %v1579 = icmp sgt i64 %v1580, 1
  br i1 %v1579, label %v1525, label %v1524

v1525:
  %v1580 = phi i64 [ %v1581, %v1535 ], [ %v308, %v1501 ]
  %v1528 = phi i64 [ %v1582, %v1535 ], [ 0, %v1501 ]
  %v1581 = add nsw i64 %v1580, -1
  %v1582 = add nsw i64 %v1528, 1
  %v1554 = getelementptr i64, ptr %v142, i64 %v1528
  %v1574 = load i64, ptr %v1554, align 8, !noalias !147
  %v1583 = getelementptr i64, ptr %v737, i64 %v1528
  %v1532 = load i64, ptr %v1583, align 8, !noalias !147
  %v1584 = icmp slt i64 %v1574, 0
  br i1 %v1584, label %v1535, label %v1526

v1524:
  br i1 %v1494, label %v1585, label %v1586

v1585:
  call void @llvm.lifetime.start.p0(ptr nonnull %v302)
  call void @llvm.lifetime.start.p0(ptr nonnull %v303)
  store i8 0, ptr %v302, align 1, !noalias !154
  store ptr null, ptr %v303, align 8, !noalias !154
  br label %v1587

v1587:
  %v1588 = phi i64 [ 0, %v1585 ], [ %v1589, %v1590 ]
  %v1589 = add nsw i64 %v1588, 1
  %v1591 = icmp ult i64 %v1588, 9
  br i1 %v1591, label %v1592, label %v1593

v1592:
  %v1594 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v1588
  %v1595 = load double, ptr %v1594, align 8
  %v1596 = load double, ptr %v133, align 8, !noalias !158
  %v1597 = load double, ptr %v753, align 8, !noalias !158
  %v1598 = fmul double %v1595, %v1597
  %v1599 = fadd double %v1596, %v1598
  store double %v1599, ptr %v755, align 8, !noalias !158
  br i1 %v757, label %v1590, label %v1600

v1600:
  %v1601 = fsub double 1.000000e+00, %v1595
  br label %v1602

v1602:
  %v1603 = phi i64 [ 0, %v1600 ], [ %v1604, %v1602 ]
  %v1605 = mul i64 %v1603, %v196
  %v1606 = getelementptr double, ptr %v193, i64 %v1605
  %v1607 = getelementptr i8, ptr %v1606, i64 %v761
  %v1608 = load double, ptr %v1607, align 8, !noalias !165
  %v1609 = fadd double %v1608, 0.000000e+00
  %v1610 = fmul double %v1595, %v1609
  %v1611 = getelementptr i8, ptr %v1606, i64 %v762
  %v1612 = load double, ptr %v1611, align 8, !noalias !165
  %v1613 = fadd double %v1612, %v1610
  %v1614 = fmul double %v1601, %v1613
  %v1615 = getelementptr i8, ptr %v1606, i64 %v763
  %v1616 = load double, ptr %v1615, align 8, !noalias !165
  %v1617 = fadd double %v1616, %v1614
  %v1618 = fmul double %v1595, %v1617
  %v1619 = getelementptr i8, ptr %v1606, i64 %v764
  %v1620 = load double, ptr %v1619, align 8, !noalias !165
  %v1621 = fadd double %v1620, %v1618
  %v1622 = fmul double %v1601, %v1621
  %v1623 = getelementptr i8, ptr %v1606, i64 %v765
  %v1624 = load double, ptr %v1623, align 8, !noalias !165
  %v1625 = fadd double %v1624, %v1622
  %v1626 = fmul double %v1595, %v1625
  %v1627 = getelementptr i8, ptr %v1606, i64 %v766
  %v1628 = load double, ptr %v1627, align 8, !noalias !165
  %v1629 = fadd double %v1628, %v1626
  %v1630 = fmul double %v1601, %v1629
  %v1631 = getelementptr i8, ptr %v1606, i64 %v767
  %v1632 = load double, ptr %v1631, align 8, !noalias !165
  %v1633 = fadd double %v1632, %v1630
  %v1634 = fmul double %v1595, %v1633
  %v1604 = add nsw i64 %v1603, 1
  %v1635 = load double, ptr %v1606, align 8, !noalias !165
  %v1636 = fadd double %v1635, %v1634
  %v1637 = getelementptr double, ptr %v758, i64 %v1605
  store double %v1636, ptr %v1637, align 8, !noalias !158
  %v1638 = icmp eq i64 %v10, %v1604
  br i1 %v1638, label %v1590, label %v1602

v1590:
  %v1639 = icmp eq i64 %v1588, 8
  %v1640 = select i1 %v1639, i64 17, i64 16
  %v1641 = mul i64 %v1588, %v759
  %v1642 = load i64, ptr %v760, align 8, !noalias !169
  %v1643 = mul nsw i64 %v1640, %v10
  %v1644 = getelementptr double, ptr %v158, i64 %v1643
  %v1645 = getelementptr double, ptr %v186, i64 %v1641
  %v1646 = inttoptr i64 %v1642 to ptr
  tail call void %v1646(ptr nonnull %v755, ptr %v1644, ptr %v165, ptr %v172, ptr %v179, ptr %v1645), !noalias !169
  %v1647 = icmp eq i64 %v1589, 9
  br i1 %v1647, label %v1593, label %v1587

v1593:
  %v1648 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v1587 ], [ null, %v1590 ]
  %v1649 = phi i32 [ 1, %v1587 ], [ 0, %v1590 ]
  br i1 %v1591, label %v1650, label %v1651, !prof !131

v1650:
  %v1652 = load double, ptr %v769, align 8, !noalias !172
  %v1653 = load double, ptr %v92, align 8, !noalias !172
  %v1654 = fsub double %v1652, %v1653
  %v1655 = fmul double %v1654, 1.000000e-13
  %v1656 = load double, ptr %v133, align 8, !noalias !172
  %v1657 = tail call double @llvm.fabs.f64(double %v1656)
  %v1658 = fmul double %v1657, 4.000000e-15
  %v1659 = fcmp ogt double %v1658, %v1655
  %v1660 = select i1 %v1659, double %v1658, double %v1655
  %v1661 = load double, ptr %v753, align 8, !noalias !179
  %v1662 = fdiv double %v1660, %v1661
  %v1663 = fcmp olt double %v1662, 1.000000e+00
  %v1664 = select i1 %v1663, double %v1662, double 1.000000e+00
  br i1 %v770, label %v1665, label %v1666

v1667:
  %v1668 = fcmp olt double %v1669, %v1670
  %v1671 = select i1 %v1668, double %v1669, double %v1670
  %v1672 = fcmp ogt double %v1669, %v1673
  %v1674 = select i1 %v1672, double %v1669, double %v1673
  br label %v1675

v1675:
  %v1676 = phi double [ %v1674, %v1667 ], [ %v1673, %v1677 ]
  %v1678 = phi double [ %v1671, %v1667 ], [ %v1670, %v1677 ]
  %v1679 = icmp eq i64 %v1680, 9
  br i1 %v1679, label %v1681, label %v1677

v1681:
  %v1682 = fsub double %v1676, %v1678
  %v1683 = fmul double %v1664, %v1682
  %v1684 = tail call i1 @llvm.is.fpclass.f64(double %v1685, i32 543)
  %v1686 = select i1 %v1684, double 0.000000e+00, double %v1685
  %v1687 = tail call i1 @llvm.is.fpclass.f64(double %v1683, i32 543)
  %v1688 = select i1 %v1687, double -0.000000e+00, double %v1683
  %v1689 = fadd double %v1686, %v1688
  %v1690 = getelementptr double, ptr %v773, i64 %v1691
  %v1692 = load double, ptr %v1690, align 8, !noalias !179
  %v1693 = sub nsw i64 %v1694, %v18
  %v1695 = getelementptr double, ptr %v215, i64 %v1693
  %v1696 = load double, ptr %v1695, align 8, !noalias !179
  %v1697 = getelementptr double, ptr %v774, i64 %v1691
  store double %v1689, ptr %v1697, align 8, !noalias !179
  %v1698 = fcmp ule double %v1696, 5.000000e-01
  %v1699 = fcmp ule double %v1692, 0.000000e+00
  %v1700 = select i1 %v1698, i1 true, i1 %v1699
  %v1701 = select i1 %v1700, double %v1689, double 0.000000e+00
  %v1702 = getelementptr double, ptr %v1697, i64 %v771
  store double %v1701, ptr %v1702, align 8, !noalias !179
  %v1703 = getelementptr i8, ptr %v1697, i64 %v775
  store double %v1701, ptr %v1703, align 8, !noalias !179
  %v1704 = getelementptr i8, ptr %v1697, i64 %v776
  store double %v1701, ptr %v1704, align 8, !noalias !179
  %v1705 = getelementptr i8, ptr %v1697, i64 %v777
  store double %v1701, ptr %v1705, align 8, !noalias !179
  %v1706 = getelementptr i8, ptr %v1697, i64 %v778
  store double %v1701, ptr %v1706, align 8, !noalias !179
  %v1707 = getelementptr i8, ptr %v1697, i64 %v779
  store double %v1701, ptr %v1707, align 8, !noalias !179
  %v1708 = getelementptr i8, ptr %v1697, i64 %v780
  store double %v1701, ptr %v1708, align 8, !noalias !179
  %v1709 = getelementptr i8, ptr %v1697, i64 %v781
  store double %v1701, ptr %v1709, align 8, !noalias !179
  %v1710 = add nsw i64 %v1711, -1
  %v1712 = add i64 %v1694, 1
  %v1713 = icmp sgt i64 %v1711, 1
  br i1 %v1713, label %v1666, label %v1665

v1666:
  %v1711 = phi i64 [ %v1710, %v1681 ], [ %v15, %v1650 ]
  %v1694 = phi i64 [ %v1712, %v1681 ], [ %v18, %v1650 ]
  %v1714 = icmp slt i64 %v1694, 0
  %v1715 = select i1 %v1714, i64 %v207, i64 0
  %v1691 = add i64 %v1715, %v1694
  br label %v1677

v1677:
  %v1670 = phi double [ 0x7FF0000000000000, %v1666 ], [ %v1678, %v1675 ]
  %v1673 = phi double [ 0xFFF0000000000000, %v1666 ], [ %v1676, %v1675 ]
  %v1716 = phi double [ 0.000000e+00, %v1666 ], [ %v1685, %v1675 ]
  %v1717 = phi i64 [ 0, %v1666 ], [ %v1680, %v1675 ]
  %v1680 = add nsw i64 %v1717, 1
  %v1718 = mul i64 %v1717, %v771
  %v1719 = getelementptr double, ptr %v204, i64 %v1718
  %v1720 = getelementptr i8, ptr %v1719, i64 %v772
  %v1721 = getelementptr double, ptr %v1720, i64 %v1691
  %v1722 = load double, ptr %v1721, align 8, !noalias !179
  %v1723 = tail call i1 @llvm.is.fpclass.f64(double %v1722, i32 543)
  %v1724 = fadd double %v1722, 0.000000e+00
  %v1725 = select i1 %v1723, double 0.000000e+00, double %v1724
  %v1726 = fcmp ogt double %v1725, %v1716
  %v1685 = select i1 %v1726, double %v1725, double %v1716
  %v1727 = getelementptr double, ptr %v1719, i64 %v207
  %v1728 = getelementptr double, ptr %v1727, i64 %v1691
  %v1669 = load double, ptr %v1728, align 8, !noalias !179
  %v1729 = tail call double @llvm.fabs.f64(double %v1669)
  %v1730 = fcmp ueq double %v1729, 0x7FF0000000000000
  br i1 %v1730, label %v1675, label %v1667

v1665:
  store i8 0, ptr %v302, align 1, !noalias !154
  %v1731 = call fastcc i32 @_ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr %v302, ptr %v303, i64 %v14, ptr nonnull readonly %v92, i64 %v93, ptr %v124, i64 %v125, i64 %v126, ptr nonnull %v133, i64 %v135, ptr %v142, i64 %v144, ptr %v204, i64 %v205, i64 %v206, i64 %v207, double 0.000000e+00)
  %v1732 = icmp eq i32 %v1731, 0
  br i1 %v1732, label %v1733, label %v1734, !prof !131

v1734:
  %v1735 = load ptr, ptr %v303, align 8, !noalias !154
  br label %v1651

v1733:
  %v1736 = load i8, ptr %v302, align 1, !noalias !154
  %v1737 = icmp eq i8 %v1736, 0
  br label %v1651

v1651:
  %v1738 = phi i1 [ %v1737, %v1733 ], [ true, %v1734 ], [ true, %v1593 ]
  %v1739 = phi ptr [ null, %v1733 ], [ %v1735, %v1734 ], [ %v1648, %v1593 ]
  %v1740 = phi i32 [ 0, %v1733 ], [ 1, %v1734 ], [ %v1649, %v1593 ]
  call void @llvm.lifetime.end.p0(ptr nonnull %v302)
  call void @llvm.lifetime.end.p0(ptr nonnull %v303)
  %v1741 = icmp eq i32 %v1740, 0
  %v1742 = select i1 %v1741, ptr undef, ptr %v1739
  br i1 %v1741, label %v1743, label %v1499, !prof !131

v1744:
  %v1745 = load double, ptr %v783, align 8, !noalias !180
  %v1746 = load double, ptr %v753, align 8, !noalias !180
  %v1747 = load double, ptr %v785, align 8, !noalias !180
  %v1748 = load double, ptr %v92, align 8, !noalias !180
  %v1749 = fsub double %v1747, %v1748
  %v1750 = load double, ptr %v787, align 8, !noalias !180
  %v1751 = load double, ptr %v789, align 8, !noalias !180
  %v1752 = fsub double %v1750, %v1751
  %v1753 = fmul double %v1749, 5.000000e-06
  %v1754 = fcmp olt double %v1752, %v1753
  br label %v1755

v1756:
  %v1757 = sub nsw i64 45, %v1758
  %v1759 = load double, ptr %v794, align 8, !noalias !184
  %v1760 = load double, ptr %v796, align 8, !noalias !184
  br label %v1761

v1761:
  %v1762 = phi double [ %v1763, %v1761 ], [ 1.000000e+00, %v1756 ]
  %v1764 = phi double [ %v1765, %v1761 ], [ 2.000000e+00, %v1756 ]
  %v1766 = phi i64 [ %v1767, %v1761 ], [ %v1757, %v1756 ]
  %v1768 = and i64 %v1766, 1
  %v1769 = icmp eq i64 %v1768, 0
  %v1770 = fmul double %v1762, %v1764
  %v1763 = select i1 %v1769, double %v1762, double %v1770
  %v1767 = lshr i64 %v1766, 1
  %v1765 = fmul double %v1764, %v1764
  %v1771 = icmp eq i64 %v1767, 0
  br i1 %v1771, label %v1772, label %v1761

v1773:
  %v1774 = fcmp olt double %v1775, 0.000000e+00
  %v1776 = select i1 %v1774, double 0.000000e+00, double %v1775
  %v1777 = fmul double %v1778, %v1776
  %v1779 = fsub double %v1780, %v1777
  br label %v1781

v1772:
  %v1782 = fadd double %v1783, %v1784
  %v1780 = fmul double %v1782, 5.000000e-01
  %v1785 = fmul double %v1763, 1.000000e-13
  %v1786 = fsub double %v1785, %v1787
  %v1775 = fmul double %v1786, 5.000000e-01
  %v1788 = fmul double %v1784, %v1760
  %v1789 = fmul double %v1783, %v1759
  %v1790 = fsub double %v1788, %v1789
  %v1791 = fsub double %v1760, %v1759
  %v1792 = fdiv double %v1790, %v1791
  %v1793 = fcmp olt double %v1784, %v1792
  %v1794 = fcmp olt double %v1792, %v1783
  %v1795 = and i1 %v1793, %v1794
  %v1796 = select i1 %v1795, double %v1792, double %v1780
  %v1797 = fsub double %v1780, %v1796
  %v1778 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v1797)
  %v1798 = fmul double %v1787, %v1787
  %v1799 = tail call double @llvm.fabs.f64(double %v1797)
  %v1800 = fcmp olt double %v1799, %v1798
  %v1801 = select i1 %v1800, double %v1799, double %v1798
  %v1802 = fmul double %v1778, %v1801
  %v1803 = fadd double %v1796, %v1802
  %v1804 = fsub double %v1803, %v1780
  %v1805 = tail call double @llvm.fabs.f64(double %v1804)
  %v1806 = fcmp ugt double %v1805, %v1775
  br i1 %v1806, label %v1773, label %v1781

v1807:
  store double %v1808, ptr %v791, align 8, !noalias !190
  store double %v1809, ptr %v796, align 8, !noalias !190
  br label %v1810

v1811:
  store double %v1808, ptr %v783, align 8, !noalias !190
  store double %v1809, ptr %v794, align 8, !noalias !190
  br label %v1810

v1810:
  %v1812 = icmp eq i64 %v1813, 45
  br i1 %v1812, label %v1814, label %v1755

v1755:
  %v1758 = phi i64 [ 0, %v1744 ], [ %v1813, %v1810 ]
  %v1813 = add nsw i64 %v1758, 1
  %v1783 = load double, ptr %v791, align 8, !noalias !190
  %v1784 = load double, ptr %v783, align 8, !noalias !190
  %v1787 = fsub double %v1783, %v1784
  %v1815 = fcmp ugt double %v1787, 1.000000e-13
  br i1 %v1815, label %v1756, label %v1814

v1781:
  %v1808 = phi double [ %v1803, %v1772 ], [ %v1779, %v1773 ]
  %v1816 = load double, ptr %v133, align 8, !noalias !191
  %v1817 = load double, ptr %v753, align 8, !noalias !191
  %v1818 = fmul double %v1808, %v1817
  %v1819 = fadd double %v1816, %v1818
  store double %v1819, ptr %v755, align 8, !noalias !191
  br i1 %v797, label %v1820, label %v1821

v1820:
  %v1822 = fsub double 1.000000e+00, %v1808
  br label %v1823

v1823:
  %v1824 = phi i64 [ 0, %v1820 ], [ %v1825, %v1823 ]
  %v1826 = mul i64 %v1824, %v196
  %v1827 = getelementptr double, ptr %v193, i64 %v1826
  %v1828 = getelementptr i8, ptr %v1827, i64 %v761
  %v1829 = load double, ptr %v1828, align 8, !noalias !198
  %v1830 = fadd double %v1829, 0.000000e+00
  %v1831 = fmul double %v1808, %v1830
  %v1832 = getelementptr i8, ptr %v1827, i64 %v762
  %v1833 = load double, ptr %v1832, align 8, !noalias !198
  %v1834 = fadd double %v1833, %v1831
  %v1835 = fmul double %v1822, %v1834
  %v1836 = getelementptr i8, ptr %v1827, i64 %v763
  %v1837 = load double, ptr %v1836, align 8, !noalias !198
  %v1838 = fadd double %v1837, %v1835
  %v1839 = fmul double %v1808, %v1838
  %v1840 = getelementptr i8, ptr %v1827, i64 %v764
  %v1841 = load double, ptr %v1840, align 8, !noalias !198
  %v1842 = fadd double %v1841, %v1839
  %v1843 = fmul double %v1822, %v1842
  %v1844 = getelementptr i8, ptr %v1827, i64 %v765
  %v1845 = load double, ptr %v1844, align 8, !noalias !198
  %v1846 = fadd double %v1845, %v1843
  %v1847 = fmul double %v1808, %v1846
  %v1848 = getelementptr i8, ptr %v1827, i64 %v766
  %v1849 = load double, ptr %v1848, align 8, !noalias !198
  %v1850 = fadd double %v1849, %v1847
  %v1851 = fmul double %v1822, %v1850
  %v1852 = getelementptr i8, ptr %v1827, i64 %v767
  %v1853 = load double, ptr %v1852, align 8, !noalias !198
  %v1854 = fadd double %v1853, %v1851
  %v1855 = fmul double %v1808, %v1854
  %v1825 = add nsw i64 %v1824, 1
  %v1856 = load double, ptr %v1827, align 8, !noalias !198
  %v1857 = fadd double %v1856, %v1855
  %v1858 = getelementptr double, ptr %v758, i64 %v1826
  store double %v1857, ptr %v1858, align 8, !noalias !191
  %v1859 = icmp eq i64 %v10, %v1825
  br i1 %v1859, label %v1821, label %v1823

v1821:
  %v1860 = load i64, ptr %v760, align 8, !noalias !202
  %v1861 = inttoptr i64 %v1860 to ptr
  tail call void %v1861(ptr nonnull %v755, ptr %v799, ptr %v165, ptr %v172, ptr %v179, ptr %v801), !noalias !202
  br i1 %v804, label %v1862, label %v1863

v1862:
  %v1864 = phi i64 [ %v1865, %v1862 ], [ %v803, %v1821 ]
  %v1866 = phi i64 [ %v1867, %v1862 ], [ %v18, %v1821 ]
  %v1865 = add nsw i64 %v1864, -1
  %v1867 = add i64 %v1866, 1
  %v1868 = icmp slt i64 %v1866, 0
  %v1869 = select i1 %v1868, i64 %v207, i64 0
  %v1870 = add i64 %v1869, %v1866
  %v1871 = getelementptr double, ptr %v808, i64 %v1870
  %v1872 = load double, ptr %v1871, align 8, !noalias !205
  %v1873 = getelementptr double, ptr %v811, i64 %v1870
  store double %v1872, ptr %v1873, align 8, !noalias !205
  %v1874 = icmp sgt i64 %v1864, 1
  br i1 %v1874, label %v1862, label %v1863

v1863:
  br i1 %v812, label %v1875, label %v1876

v1876:
  %v1877 = phi double [ %v1878, %v1876 ], [ 0x7FF0000000000000, %v1863 ]
  %v1879 = phi i64 [ %v1880, %v1876 ], [ 0, %v1863 ]
  %v1880 = add nsw i64 %v1879, 1
  %v1881 = getelementptr double, ptr %v813, i64 %v1879
  %v1882 = load double, ptr %v1881, align 8, !noalias !206
  %v1883 = getelementptr double, ptr %v811, i64 %v1879
  %v1884 = load double, ptr %v1883, align 8, !noalias !206
  %v1885 = fadd double %v1882, %v1884
  %v1886 = fcmp olt double %v1885, %v1877
  %v1878 = select i1 %v1886, double %v1885, double %v1877
  %v1887 = icmp eq i64 %v207, %v1880
  br i1 %v1887, label %v1875, label %v1876

v1875:
  %v1809 = phi double [ 0x7FF0000000000000, %v1863 ], [ %v1878, %v1876 ]
  %v1888 = fcmp olt double %v1809, 0.000000e+00
  br i1 %v1888, label %v1807, label %v1811

v1889:
  %v1890 = load double, ptr %v791, align 8, !noalias !210
  %v1891 = load double, ptr %v133, align 8, !noalias !214
  %v1892 = load double, ptr %v753, align 8, !noalias !214
  %v1893 = fmul double %v1890, %v1892
  %v1894 = fadd double %v1891, %v1893
  store double %v1894, ptr %v755, align 8, !noalias !214
  br i1 %v797, label %v1895, label %v1896

v1895:
  %v1897 = fsub double 1.000000e+00, %v1890
  br label %v1898

v1898:
  %v1899 = phi i64 [ 0, %v1895 ], [ %v1900, %v1898 ]
  %v1901 = mul i64 %v1899, %v196
  %v1902 = getelementptr double, ptr %v193, i64 %v1901
  %v1903 = getelementptr i8, ptr %v1902, i64 %v761
  %v1904 = load double, ptr %v1903, align 8, !noalias !221
  %v1905 = fadd double %v1904, 0.000000e+00
  %v1906 = fmul double %v1890, %v1905
  %v1907 = getelementptr i8, ptr %v1902, i64 %v762
  %v1908 = load double, ptr %v1907, align 8, !noalias !221
  %v1909 = fadd double %v1908, %v1906
  %v1910 = fmul double %v1897, %v1909
  %v1911 = getelementptr i8, ptr %v1902, i64 %v763
  %v1912 = load double, ptr %v1911, align 8, !noalias !221
  %v1913 = fadd double %v1912, %v1910
  %v1914 = fmul double %v1890, %v1913
  %v1915 = getelementptr i8, ptr %v1902, i64 %v764
  %v1916 = load double, ptr %v1915, align 8, !noalias !221
  %v1917 = fadd double %v1916, %v1914
  %v1918 = fmul double %v1897, %v1917
  %v1919 = getelementptr i8, ptr %v1902, i64 %v765
  %v1920 = load double, ptr %v1919, align 8, !noalias !221
  %v1921 = fadd double %v1920, %v1918
  %v1922 = fmul double %v1890, %v1921
  %v1923 = getelementptr i8, ptr %v1902, i64 %v766
  %v1924 = load double, ptr %v1923, align 8, !noalias !221
  %v1925 = fadd double %v1924, %v1922
  %v1926 = fmul double %v1897, %v1925
  %v1927 = getelementptr i8, ptr %v1902, i64 %v767
  %v1928 = load double, ptr %v1927, align 8, !noalias !221
  %v1929 = fadd double %v1928, %v1926
  %v1930 = fmul double %v1890, %v1929
  %v1900 = add nsw i64 %v1899, 1
  %v1931 = load double, ptr %v1902, align 8, !noalias !221
  %v1932 = fadd double %v1931, %v1930
  %v1933 = getelementptr double, ptr %v758, i64 %v1901
  store double %v1932, ptr %v1933, align 8, !noalias !214
  %v1934 = icmp eq i64 %v10, %v1900
  br i1 %v1934, label %v1896, label %v1898

v1896:
  %v1935 = load i64, ptr %v760, align 8, !noalias !225
  %v1936 = inttoptr i64 %v1935 to ptr
  tail call void %v1936(ptr nonnull %v755, ptr %v799, ptr %v165, ptr %v172, ptr %v179, ptr %v801), !noalias !225
  br i1 %v804, label %v1937, label %v1938

v1938:
  br label %v1939

v1937:
  %v1940 = phi i64 [ %v1941, %v1937 ], [ %v803, %v1896 ]
  %v1942 = phi i64 [ %v1943, %v1937 ], [ %v18, %v1896 ]
  %v1941 = add nsw i64 %v1940, -1
  %v1943 = add i64 %v1942, 1
  %v1944 = icmp slt i64 %v1942, 0
  %v1945 = select i1 %v1944, i64 %v207, i64 0
  %v1946 = add i64 %v1945, %v1942
  %v1947 = getelementptr double, ptr %v808, i64 %v1946
  %v1948 = load double, ptr %v1947, align 8, !noalias !228
  %v1949 = getelementptr double, ptr %v811, i64 %v1946
  store double %v1948, ptr %v1949, align 8, !noalias !228
  %v1950 = icmp sgt i64 %v1940, 1
  br i1 %v1950, label %v1937, label %v1938

v1951:
  %v1952 = icmp slt i64 %v1953, 0
  %v1954 = select i1 %v1952, i64 %v207, i64 0
  %v1955 = add i64 %v1954, %v1953
  %v1956 = getelementptr double, ptr %v813, i64 %v1955
  %v1957 = load double, ptr %v1956, align 8, !noalias !210
  store double %v1957, ptr %v796, align 8, !noalias !210
  br label %v1958

v1959:
  %v1960 = phi i64 [ 0, %v1961 ], [ %v1962, %v1959 ]
  %v1963 = mul i64 %v1960, %v196
  %v1964 = getelementptr double, ptr %v193, i64 %v1963
  %v1965 = getelementptr i8, ptr %v1964, i64 %v761
  %v1966 = load double, ptr %v1965, align 8, !noalias !229
  %v1967 = fadd double %v1966, 0.000000e+00
  %v1968 = fmul double %v1969, %v1967
  %v1970 = getelementptr i8, ptr %v1964, i64 %v762
  %v1971 = load double, ptr %v1970, align 8, !noalias !229
  %v1972 = fadd double %v1971, %v1968
  %v1973 = fmul double %v1974, %v1972
  %v1975 = getelementptr i8, ptr %v1964, i64 %v763
  %v1976 = load double, ptr %v1975, align 8, !noalias !229
  %v1977 = fadd double %v1976, %v1973
  %v1978 = fmul double %v1969, %v1977
  %v1979 = getelementptr i8, ptr %v1964, i64 %v764
  %v1980 = load double, ptr %v1979, align 8, !noalias !229
  %v1981 = fadd double %v1980, %v1978
  %v1982 = fmul double %v1974, %v1981
  %v1983 = getelementptr i8, ptr %v1964, i64 %v765
  %v1984 = load double, ptr %v1983, align 8, !noalias !229
  %v1985 = fadd double %v1984, %v1982
  %v1986 = fmul double %v1969, %v1985
  %v1987 = getelementptr i8, ptr %v1964, i64 %v766
  %v1988 = load double, ptr %v1987, align 8, !noalias !229
  %v1989 = fadd double %v1988, %v1986
  %v1990 = fmul double %v1974, %v1989
  %v1991 = getelementptr i8, ptr %v1964, i64 %v767
  %v1992 = load double, ptr %v1991, align 8, !noalias !229
  %v1993 = fadd double %v1992, %v1990
  %v1994 = fmul double %v1969, %v1993
  %v1962 = add nsw i64 %v1960, 1
  %v1995 = load double, ptr %v1964, align 8, !noalias !229
  %v1996 = fadd double %v1995, %v1994
  %v1997 = getelementptr double, ptr %v758, i64 %v1963
  store double %v1996, ptr %v1997, align 8, !noalias !239
  %v1998 = icmp eq i64 %v10, %v1962
  br i1 %v1998, label %v1999, label %v1959

v1999:
  %v2000 = load i64, ptr %v760, align 8, !noalias !240
  %v2001 = inttoptr i64 %v2000 to ptr
  tail call void %v2001(ptr nonnull %v755, ptr %v799, ptr %v165, ptr %v172, ptr %v179, ptr %v801), !noalias !240
  br i1 %v844, label %v2002, label %v2003

v2003:
  %v2004 = phi i64 [ %v2005, %v2003 ], [ %v803, %v1999 ]
  %v2006 = phi i64 [ %v2007, %v2003 ], [ %v18, %v1999 ]
  %v2005 = add nsw i64 %v2004, -1
  %v2007 = add i64 %v2006, 1
  %v2008 = icmp slt i64 %v2006, 0
  %v2009 = select i1 %v2008, i64 %v207, i64 0
  %v2010 = add i64 %v2009, %v2006
  %v2011 = getelementptr double, ptr %v808, i64 %v2010
  %v2012 = load double, ptr %v2011, align 8, !noalias !243
  %v2013 = getelementptr double, ptr %v811, i64 %v2010
  store double %v2012, ptr %v2013, align 8, !noalias !243
  %v2014 = icmp sgt i64 %v2004, 1
  br i1 %v2014, label %v2003, label %v2002

v2015:
  br i1 %v2016, label %v2017, label %v2018

v2017:
  %v2019 = load double, ptr %v791, align 8, !noalias !210
  br label %v2018

v2018:
  %v2020 = phi double [ %v2019, %v2017 ], [ %v1969, %v2015 ]
  %v2021 = fmul double %v2020, 5.000000e-01
  %v2022 = icmp eq i64 %v2023, 45
  br i1 %v2022, label %v2024, label %v1958

v2025:
  %v2026 = getelementptr double, ptr %v808, i64 %v1955
  store double 0.000000e+00, ptr %v2026, align 8, !noalias !210
  br label %v2027

v2028:
  %v2029 = sub nsw i64 45, %v2030
  %v2031 = load double, ptr %v794, align 8, !noalias !244
  %v2032 = load double, ptr %v796, align 8, !noalias !244
  br label %v2033

v2033:
  %v2034 = phi double [ %v2035, %v2033 ], [ 1.000000e+00, %v2028 ]
  %v2036 = phi double [ %v2037, %v2033 ], [ 2.000000e+00, %v2028 ]
  %v2038 = phi i64 [ %v2039, %v2033 ], [ %v2029, %v2028 ]
  %v2040 = and i64 %v2038, 1
  %v2041 = icmp eq i64 %v2040, 0
  %v2042 = fmul double %v2034, %v2036
  %v2035 = select i1 %v2041, double %v2034, double %v2042
  %v2039 = lshr i64 %v2038, 1
  %v2037 = fmul double %v2036, %v2036
  %v2043 = icmp eq i64 %v2039, 0
  br i1 %v2043, label %v2044, label %v2033

v2045:
  %v2046 = fcmp olt double %v2047, 0.000000e+00
  %v2048 = select i1 %v2046, double 0.000000e+00, double %v2047
  %v2049 = fmul double %v2050, %v2048
  %v2051 = fsub double %v2052, %v2049
  br label %v2053

v2044:
  %v2054 = fadd double %v2055, %v2056
  %v2052 = fmul double %v2054, 5.000000e-01
  %v2057 = fmul double %v2035, 0x3D06849B86A12B9B
  %v2058 = fsub double %v2057, %v2059
  %v2047 = fmul double %v2058, 5.000000e-01
  %v2060 = fmul double %v2056, %v2032
  %v2061 = fmul double %v2055, %v2031
  %v2062 = fsub double %v2060, %v2061
  %v2063 = fsub double %v2032, %v2031
  %v2064 = fdiv double %v2062, %v2063
  %v2065 = fcmp olt double %v2056, %v2064
  %v2066 = fcmp olt double %v2064, %v2055
  %v2067 = and i1 %v2065, %v2066
  %v2068 = select i1 %v2067, double %v2064, double %v2052
  %v2069 = fsub double %v2052, %v2068
  %v2050 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v2069)
  %v2070 = fmul double %v2059, %v2059
  %v2071 = tail call double @llvm.fabs.f64(double %v2069)
  %v2072 = fcmp olt double %v2071, %v2070
  %v2073 = select i1 %v2072, double %v2071, double %v2070
  %v2074 = fmul double %v2050, %v2073
  %v2075 = fadd double %v2068, %v2074
  %v2076 = fsub double %v2075, %v2052
  %v2077 = tail call double @llvm.fabs.f64(double %v2076)
  %v2078 = fcmp ugt double %v2077, %v2047
  br i1 %v2078, label %v2045, label %v2053

v2079:
  store double %v2080, ptr %v791, align 8, !noalias !250
  store double %v2081, ptr %v796, align 8, !noalias !250
  br label %v2082

v2083:
  store double %v2080, ptr %v783, align 8, !noalias !250
  store double %v2081, ptr %v794, align 8, !noalias !250
  br label %v2082

v2082:
  %v2084 = icmp eq i64 %v2085, 45
  br i1 %v2084, label %v2086, label %v2027

v2027:
  %v2030 = phi i64 [ 0, %v2025 ], [ %v2085, %v2082 ]
  %v2085 = add nsw i64 %v2030, 1
  %v2055 = load double, ptr %v791, align 8, !noalias !250
  %v2056 = load double, ptr %v783, align 8, !noalias !250
  %v2059 = fsub double %v2055, %v2056
  %v2087 = fcmp ugt double %v2059, 0x3D06849B86A12B9B
  br i1 %v2087, label %v2028, label %v2086

v2053:
  %v2080 = phi double [ %v2075, %v2044 ], [ %v2051, %v2045 ]
  %v2088 = load double, ptr %v133, align 8, !noalias !251
  %v2089 = load double, ptr %v753, align 8, !noalias !251
  %v2090 = fmul double %v2080, %v2089
  %v2091 = fadd double %v2088, %v2090
  store double %v2091, ptr %v755, align 8, !noalias !251
  br i1 %v797, label %v2092, label %v2093

v2092:
  %v2094 = fsub double 1.000000e+00, %v2080
  br label %v2095

v2095:
  %v2096 = phi i64 [ 0, %v2092 ], [ %v2097, %v2095 ]
  %v2098 = mul i64 %v2096, %v196
  %v2099 = getelementptr double, ptr %v193, i64 %v2098
  %v2100 = getelementptr i8, ptr %v2099, i64 %v761
  %v2101 = load double, ptr %v2100, align 8, !noalias !258
  %v2102 = fadd double %v2101, 0.000000e+00
  %v2103 = fmul double %v2080, %v2102
  %v2104 = getelementptr i8, ptr %v2099, i64 %v762
  %v2105 = load double, ptr %v2104, align 8, !noalias !258
  %v2106 = fadd double %v2105, %v2103
  %v2107 = fmul double %v2094, %v2106
  %v2108 = getelementptr i8, ptr %v2099, i64 %v763
  %v2109 = load double, ptr %v2108, align 8, !noalias !258
  %v2110 = fadd double %v2109, %v2107
  %v2111 = fmul double %v2080, %v2110
  %v2112 = getelementptr i8, ptr %v2099, i64 %v764
  %v2113 = load double, ptr %v2112, align 8, !noalias !258
  %v2114 = fadd double %v2113, %v2111
  %v2115 = fmul double %v2094, %v2114
  %v2116 = getelementptr i8, ptr %v2099, i64 %v765
  %v2117 = load double, ptr %v2116, align 8, !noalias !258
  %v2118 = fadd double %v2117, %v2115
  %v2119 = fmul double %v2080, %v2118
  %v2120 = getelementptr i8, ptr %v2099, i64 %v766
  %v2121 = load double, ptr %v2120, align 8, !noalias !258
  %v2122 = fadd double %v2121, %v2119
  %v2123 = fmul double %v2094, %v2122
  %v2124 = getelementptr i8, ptr %v2099, i64 %v767
  %v2125 = load double, ptr %v2124, align 8, !noalias !258
  %v2126 = fadd double %v2125, %v2123
  %v2127 = fmul double %v2080, %v2126
  %v2097 = add nsw i64 %v2096, 1
  %v2128 = load double, ptr %v2099, align 8, !noalias !258
  %v2129 = fadd double %v2128, %v2127
  %v2130 = getelementptr double, ptr %v758, i64 %v2098
  store double %v2129, ptr %v2130, align 8, !noalias !251
  %v2131 = icmp eq i64 %v10, %v2097
  br i1 %v2131, label %v2093, label %v2095

v2093:
  %v2132 = load i64, ptr %v760, align 8, !noalias !262
  %v2133 = inttoptr i64 %v2132 to ptr
  tail call void %v2133(ptr nonnull %v755, ptr %v799, ptr %v165, ptr %v172, ptr %v179, ptr %v801), !noalias !262
  br i1 %v804, label %v2134, label %v2135

v2134:
  %v2136 = phi i64 [ %v2137, %v2134 ], [ %v803, %v2093 ]
  %v2138 = phi i64 [ %v2139, %v2134 ], [ %v18, %v2093 ]
  %v2137 = add nsw i64 %v2136, -1
  %v2139 = add i64 %v2138, 1
  %v2140 = icmp slt i64 %v2138, 0
  %v2141 = select i1 %v2140, i64 %v207, i64 0
  %v2142 = add i64 %v2141, %v2138
  %v2143 = getelementptr double, ptr %v808, i64 %v2142
  %v2144 = load double, ptr %v2143, align 8, !noalias !265
  %v2145 = getelementptr double, ptr %v811, i64 %v2142
  store double %v2144, ptr %v2145, align 8, !noalias !265
  %v2146 = icmp sgt i64 %v2136, 1
  br i1 %v2146, label %v2134, label %v2135

v2135:
  br i1 %v812, label %v2147, label %v2148

v2148:
  %v2149 = phi double [ %v2150, %v2148 ], [ 0x7FF0000000000000, %v2135 ]
  %v2151 = phi i64 [ %v2152, %v2148 ], [ 0, %v2135 ]
  %v2152 = add nsw i64 %v2151, 1
  %v2153 = getelementptr double, ptr %v813, i64 %v2151
  %v2154 = load double, ptr %v2153, align 8, !noalias !266
  %v2155 = getelementptr double, ptr %v811, i64 %v2151
  %v2156 = load double, ptr %v2155, align 8, !noalias !266
  %v2157 = fadd double %v2154, %v2156
  %v2158 = fcmp olt double %v2157, %v2149
  %v2150 = select i1 %v2158, double %v2157, double %v2149
  %v2159 = icmp eq i64 %v207, %v2152
  br i1 %v2159, label %v2147, label %v2148

v2147:
  %v2081 = phi double [ 0x7FF0000000000000, %v2135 ], [ %v2150, %v2148 ]
  %v2160 = fcmp olt double %v2081, 0.000000e+00
  br i1 %v2160, label %v2079, label %v2083

v2024:
  store double 0.000000e+00, ptr %v791, align 8, !noalias !210
  br label %v2086

v2086:
  %v2161 = load double, ptr %v133, align 8, !noalias !210
  %v2162 = load double, ptr %v791, align 8, !noalias !210
  %v2163 = load double, ptr %v753, align 8, !noalias !210
  %v2164 = fmul double %v2162, %v2163
  %v2165 = fadd double %v2161, %v2164
  %v2166 = load i64, ptr %v142, align 8, !noalias !270
  %v2167 = load i64, ptr %v846, align 8, !noalias !270
  %v2168 = icmp slt i64 %v2167, %v93
  br i1 %v2168, label %v2169, label %v2170

v2169:
  %v2171 = icmp slt i64 %v2167, 0
  %v2172 = select i1 %v2171, i64 %v93, i64 0
  %v2173 = getelementptr double, ptr %v92, i64 %v2167
  %v2174 = getelementptr double, ptr %v2173, i64 %v2172
  %v2175 = load double, ptr %v2174, align 8, !noalias !270
  %v2176 = fcmp ugt double %v2175, %v2165
  br i1 %v2176, label %v2170, label %v2177

v2177:
  %v2178 = icmp slt i64 %v2166, 0
  %v2179 = select i1 %v2178, i64 %v100, i64 0
  %v2180 = add i64 %v2179, %v2166
  %v2181 = mul i64 %v849, %v2180
  %v2182 = getelementptr double, ptr %v99, i64 %v2181
  br label %v2183

v2183:
  %v2184 = phi i64 [ %v2185, %v2186 ], [ %v2167, %v2177 ]
  %v2187 = icmp slt i64 %v2184, 0
  %v2188 = select i1 %v2187, i64 %v93, i64 0
  %v2189 = getelementptr double, ptr %v92, i64 %v2184
  %v2190 = getelementptr double, ptr %v2189, i64 %v2188
  %v2191 = load double, ptr %v2190, align 8, !noalias !270
  %v2192 = load double, ptr %v133, align 8, !noalias !270
  %v2193 = fsub double %v2191, %v2192
  %v2194 = load double, ptr %v753, align 8, !noalias !270
  %v2195 = fdiv double %v2193, %v2194
  br i1 %v757, label %v2196, label %v2197

v2197:
  %v2198 = fsub double 1.000000e+00, %v2195
  %v2199 = select i1 %v2187, i64 %v101, i64 0
  %v2200 = add i64 %v2199, %v2184
  %v2201 = mul i64 %v2200, %v102
  %v2202 = getelementptr double, ptr %v2182, i64 %v2201
  br label %v2203

v2204:
  %v2205 = getelementptr double, ptr %v851, i64 %v2206
  %v2207 = load double, ptr %v2205, align 8, !noalias !270
  br label %v2208

v2196:
  store double 0x7FF0000000000000, ptr %v848, align 8, !noalias !270
  %v2209 = icmp eq i64 %v2184, %v852
  br i1 %v2209, label %v2170, label %v2186

v2186:
  %v2185 = add i64 %v2184, 1
  %v2210 = icmp slt i64 %v2184, -1
  %v2211 = select i1 %v2210, i64 %v93, i64 0
  %v2212 = getelementptr double, ptr %v92, i64 %v2185
  %v2213 = getelementptr double, ptr %v2212, i64 %v2211
  %v2214 = load double, ptr %v2213, align 8, !noalias !270
  %v2215 = fcmp ugt double %v2214, %v2165
  br i1 %v2215, label %v2170, label %v2183

v2170:
  %v2216 = phi i64 [ %v2167, %v2169 ], [ %v2167, %v2086 ], [ %v93, %v2196 ], [ %v2185, %v2186 ]
  store i64 %v2216, ptr %v846, align 8, !noalias !270
  store i64 %v1953, ptr %v854, align 8, !noalias !210
  %v2217 = load i64, ptr %v142, align 8, !noalias !274
  %v2218 = icmp sgt i64 %v2217, -1
  br i1 %v2218, label %v2219, label %v2220

v2208:
  %v2221 = phi double [ %v2222, %v2223 ], [ %v2207, %v2204 ]
  %v2224 = getelementptr double, ptr %v2202, i64 %v2225
  store double %v2221, ptr %v2224, align 8, !noalias !270
  %v2226 = icmp eq i64 %v10, %v2227
  br i1 %v2226, label %v2196, label %v2203

v2203:
  %v2225 = phi i64 [ 0, %v2197 ], [ %v2227, %v2208 ]
  %v2227 = add nsw i64 %v2225, 1
  %v2228 = load double, ptr %v2190, align 8, !noalias !270
  %v2229 = load double, ptr %v787, align 8, !noalias !270
  %v2230 = fcmp oeq double %v2228, %v2229
  %v2206 = mul i64 %v2225, %v196
  br i1 %v2230, label %v2204, label %v2223

v2223:
  %v2231 = getelementptr double, ptr %v193, i64 %v2206
  %v2232 = getelementptr i8, ptr %v2231, i64 %v761
  %v2233 = load double, ptr %v2232, align 8, !noalias !277
  %v2234 = fadd double %v2233, 0.000000e+00
  %v2235 = fmul double %v2195, %v2234
  %v2236 = getelementptr i8, ptr %v2231, i64 %v762
  %v2237 = load double, ptr %v2236, align 8, !noalias !277
  %v2238 = fadd double %v2237, %v2235
  %v2239 = fmul double %v2198, %v2238
  %v2240 = getelementptr i8, ptr %v2231, i64 %v763
  %v2241 = load double, ptr %v2240, align 8, !noalias !277
  %v2242 = fadd double %v2241, %v2239
  %v2243 = fmul double %v2195, %v2242
  %v2244 = getelementptr i8, ptr %v2231, i64 %v764
  %v2245 = load double, ptr %v2244, align 8, !noalias !277
  %v2246 = fadd double %v2245, %v2243
  %v2247 = fmul double %v2198, %v2246
  %v2248 = getelementptr i8, ptr %v2231, i64 %v765
  %v2249 = load double, ptr %v2248, align 8, !noalias !277
  %v2250 = fadd double %v2249, %v2247
  %v2251 = fmul double %v2195, %v2250
  %v2252 = getelementptr i8, ptr %v2231, i64 %v766
  %v2253 = load double, ptr %v2252, align 8, !noalias !277
  %v2254 = fadd double %v2253, %v2251
  %v2255 = fmul double %v2198, %v2254
  %v2256 = getelementptr i8, ptr %v2231, i64 %v767
  %v2257 = load double, ptr %v2256, align 8, !noalias !277
  %v2258 = fadd double %v2257, %v2255
  %v2259 = fmul double %v2195, %v2258
  %v2260 = load double, ptr %v2231, align 8, !noalias !277
  %v2222 = fadd double %v2260, %v2259
  br label %v2208

v1939:
  %v2261 = phi i64 [ %v2262, %v2263 ], [ 0, %v1938 ]
  %v2264 = phi i64 [ %v2265, %v2263 ], [ %v843, %v1938 ]
  %v2266 = icmp sgt i64 %v2264, 0
  br i1 %v2266, label %v2263, label %v2267

v2263:
  %v2265 = add nsw i64 %v2264, -1
  %v2262 = add i64 %v2261, 1
  %v2268 = getelementptr double, ptr %v813, i64 %v2261
  %v2269 = load double, ptr %v2268, align 8, !noalias !281
  %v2270 = getelementptr double, ptr %v811, i64 %v2261
  %v2271 = load double, ptr %v2270, align 8, !noalias !281
  %v2272 = fneg double %v2271
  %v2273 = fcmp olt double %v2269, %v2272
  br i1 %v2273, label %v2267, label %v1939

v2267:
  %v1953 = phi i64 [ %v2261, %v2263 ], [ -1, %v1939 ]
  %v2274 = icmp slt i64 %v1953, %v18
  br i1 %v2274, label %v2275, label %v1951

v1958:
  %v1969 = phi double [ %v1745, %v1951 ], [ %v2021, %v2018 ]
  %v2276 = phi i64 [ 0, %v1951 ], [ %v2023, %v2018 ]
  %v2023 = add nsw i64 %v2276, 1
  %v2016 = icmp eq i64 %v2276, 0
  %v2277 = load double, ptr %v133, align 8, !noalias !239
  %v2278 = load double, ptr %v753, align 8, !noalias !239
  %v2279 = fmul double %v1969, %v2278
  %v2280 = fadd double %v2277, %v2279
  store double %v2280, ptr %v755, align 8, !noalias !239
  br i1 %v757, label %v1999, label %v1961

v1961:
  %v1974 = fsub double 1.000000e+00, %v1969
  br label %v1959

v2002:
  store double %v1969, ptr %v783, align 8, !noalias !210
  %v2281 = load double, ptr %v1956, align 8, !noalias !210
  store double %v2281, ptr %v794, align 8, !noalias !210
  %v2282 = fcmp ogt double %v2281, 0.000000e+00
  br i1 %v2282, label %v2025, label %v2015

v2219:
  %v2283 = getelementptr i64, ptr %v110, i64 %v2217
  %v2284 = load i64, ptr %v2283, align 8, !noalias !274
  %v2285 = icmp eq i64 %v2284, 0
  br i1 %v2285, label %v2286, label %v2220

v2286:
  store i64 4, ptr %v2283, align 8, !noalias !274
  br label %v2220

v2220:
  store double 0.000000e+00, ptr %v856, align 8, !noalias !210
  br label %v2287

v2288:
  br i1 %v1754, label %v2275, label %v2289

v2289:
  call void @llvm.lifetime.start.p0(ptr nonnull %v300), !noalias !180
  call void @llvm.lifetime.start.p0(ptr nonnull %v301), !noalias !180
  store i8 0, ptr %v300, align 1, !noalias !285
  store ptr null, ptr %v301, align 8, !noalias !285
  %v2290 = load double, ptr %v783, align 8, !noalias !285
  %v2291 = load double, ptr %v791, align 8, !noalias !285
  br i1 %v305, label %v2292, label %v2293

v2294:
  %v2295 = phi i64 [ %v2296, %v2297 ], [ 0, %v2298 ]
  %v2296 = add nsw i64 %v2295, 1
  %v2299 = icmp ult i64 %v2295, 9
  br i1 %v2299, label %v2300, label %v2301

v2300:
  %v2302 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v2295
  %v2303 = load double, ptr %v2302, align 8
  %v2304 = load double, ptr %v133, align 8, !noalias !289
  %v2305 = load double, ptr %v753, align 8, !noalias !289
  %v2306 = fmul double %v2303, %v2305
  %v2307 = fadd double %v2304, %v2306
  store double %v2307, ptr %v755, align 8, !noalias !289
  br i1 %v797, label %v2308, label %v2297

v2308:
  %v2309 = fsub double 1.000000e+00, %v2303
  br label %v2310

v2310:
  %v2311 = phi i64 [ 0, %v2308 ], [ %v2312, %v2310 ]
  %v2313 = mul i64 %v2311, %v196
  %v2314 = getelementptr double, ptr %v193, i64 %v2313
  %v2315 = getelementptr i8, ptr %v2314, i64 %v761
  %v2316 = load double, ptr %v2315, align 8, !noalias !296
  %v2317 = fadd double %v2316, 0.000000e+00
  %v2318 = fmul double %v2303, %v2317
  %v2319 = getelementptr i8, ptr %v2314, i64 %v762
  %v2320 = load double, ptr %v2319, align 8, !noalias !296
  %v2321 = fadd double %v2320, %v2318
  %v2322 = fmul double %v2309, %v2321
  %v2323 = getelementptr i8, ptr %v2314, i64 %v763
  %v2324 = load double, ptr %v2323, align 8, !noalias !296
  %v2325 = fadd double %v2324, %v2322
  %v2326 = fmul double %v2303, %v2325
  %v2327 = getelementptr i8, ptr %v2314, i64 %v764
  %v2328 = load double, ptr %v2327, align 8, !noalias !296
  %v2329 = fadd double %v2328, %v2326
  %v2330 = fmul double %v2309, %v2329
  %v2331 = getelementptr i8, ptr %v2314, i64 %v765
  %v2332 = load double, ptr %v2331, align 8, !noalias !296
  %v2333 = fadd double %v2332, %v2330
  %v2334 = fmul double %v2303, %v2333
  %v2335 = getelementptr i8, ptr %v2314, i64 %v766
  %v2336 = load double, ptr %v2335, align 8, !noalias !296
  %v2337 = fadd double %v2336, %v2334
  %v2338 = fmul double %v2309, %v2337
  %v2339 = getelementptr i8, ptr %v2314, i64 %v767
  %v2340 = load double, ptr %v2339, align 8, !noalias !296
  %v2341 = fadd double %v2340, %v2338
  %v2342 = fmul double %v2303, %v2341
  %v2312 = add nsw i64 %v2311, 1
  %v2343 = load double, ptr %v2314, align 8, !noalias !296
  %v2344 = fadd double %v2343, %v2342
  %v2345 = getelementptr double, ptr %v758, i64 %v2313
  store double %v2344, ptr %v2345, align 8, !noalias !289
  %v2346 = icmp eq i64 %v10, %v2312
  br i1 %v2346, label %v2297, label %v2310

v2297:
  %v2347 = icmp eq i64 %v2295, 8
  %v2348 = select i1 %v2347, i64 17, i64 16
  %v2349 = mul i64 %v2295, %v759
  %v2350 = load i64, ptr %v760, align 8, !noalias !300
  %v2351 = mul nsw i64 %v2348, %v10
  %v2352 = getelementptr double, ptr %v158, i64 %v2351
  %v2353 = getelementptr double, ptr %v186, i64 %v2349
  %v2354 = inttoptr i64 %v2350 to ptr
  tail call void %v2354(ptr nonnull %v755, ptr %v2352, ptr %v165, ptr %v172, ptr %v179, ptr %v2353), !noalias !300
  %v2355 = icmp eq i64 %v2296, 9
  br i1 %v2355, label %v2301, label %v2294

v2301:
  %v2356 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v2294 ], [ %v2357, %v2297 ]
  %v2358 = phi i32 [ 1, %v2294 ], [ 0, %v2297 ]
  br i1 %v2299, label %v2359, label %v2360, !prof !131

v2361:
  %v2362 = load double, ptr %v833, align 8, !noalias !285
  %v2363 = fcmp ogt double %v2362, 5.000000e-01
  br i1 %v2363, label %v2364, label %v2365

v2364:
  %v2366 = load i64, ptr %v6, align 8, !noalias !303
  %v2367 = inttoptr i64 %v2366 to ptr
  tail call void %v2367(ptr nonnull %v787, ptr %v838, ptr %v165, ptr %v172, ptr %v179, ptr %v840), !noalias !303
  %v2368 = load double, ptr %v787, align 8, !noalias !285
  store double %v2368, ptr %v789, align 8, !noalias !285
  br label %v2369

v2370:
  %v2371 = sub nsw i64 45, %v2372
  %v2373 = load double, ptr %v794, align 8, !noalias !306
  %v2374 = load double, ptr %v796, align 8, !noalias !306
  br label %v2375

v2375:
  %v2376 = phi double [ %v2377, %v2375 ], [ 1.000000e+00, %v2370 ]
  %v2378 = phi double [ %v2379, %v2375 ], [ 2.000000e+00, %v2370 ]
  %v2380 = phi i64 [ %v2381, %v2375 ], [ %v2371, %v2370 ]
  %v2382 = and i64 %v2380, 1
  %v2383 = icmp eq i64 %v2382, 0
  %v2384 = fmul double %v2376, %v2378
  %v2377 = select i1 %v2383, double %v2376, double %v2384
  %v2381 = lshr i64 %v2380, 1
  %v2379 = fmul double %v2378, %v2378
  %v2385 = icmp eq i64 %v2381, 0
  br i1 %v2385, label %v2386, label %v2375

v2387:
  %v2388 = fcmp olt double %v2389, 0.000000e+00
  %v2390 = select i1 %v2388, double 0.000000e+00, double %v2389
  %v2391 = fmul double %v2392, %v2390
  %v2393 = fsub double %v2394, %v2391
  br label %v2395

v2386:
  %v2396 = fadd double %v2397, %v2398
  %v2394 = fmul double %v2396, 5.000000e-01
  %v2399 = fmul double %v2377, 1.000000e-13
  %v2400 = fsub double %v2399, %v2401
  %v2389 = fmul double %v2400, 5.000000e-01
  %v2402 = fmul double %v2398, %v2374
  %v2403 = fmul double %v2397, %v2373
  %v2404 = fsub double %v2402, %v2403
  %v2405 = fsub double %v2374, %v2373
  %v2406 = fdiv double %v2404, %v2405
  %v2407 = fcmp olt double %v2398, %v2406
  %v2408 = fcmp olt double %v2406, %v2397
  %v2409 = and i1 %v2407, %v2408
  %v2410 = select i1 %v2409, double %v2406, double %v2394
  %v2411 = fsub double %v2394, %v2410
  %v2392 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v2411)
  %v2412 = fmul double %v2401, %v2401
  %v2413 = tail call double @llvm.fabs.f64(double %v2411)
  %v2414 = fcmp olt double %v2413, %v2412
  %v2415 = select i1 %v2414, double %v2413, double %v2412
  %v2416 = fmul double %v2392, %v2415
  %v2417 = fadd double %v2410, %v2416
  %v2418 = fsub double %v2417, %v2394
  %v2419 = tail call double @llvm.fabs.f64(double %v2418)
  %v2420 = fcmp ugt double %v2419, %v2389
  br i1 %v2420, label %v2387, label %v2395

v2421:
  store double %v2422, ptr %v791, align 8, !noalias !312
  store double %v2423, ptr %v796, align 8, !noalias !312
  br label %v2424

v2425:
  store double %v2422, ptr %v783, align 8, !noalias !312
  store double %v2423, ptr %v794, align 8, !noalias !312
  br label %v2424

v2424:
  %v2426 = icmp eq i64 %v2427, 45
  br i1 %v2426, label %v2428, label %v2429

v2429:
  %v2372 = phi i64 [ %v2427, %v2424 ], [ 0, %v2430 ]
  %v2427 = add nsw i64 %v2372, 1
  %v2397 = load double, ptr %v791, align 8, !noalias !312
  %v2398 = load double, ptr %v783, align 8, !noalias !312
  %v2401 = fsub double %v2397, %v2398
  %v2431 = fcmp ugt double %v2401, 1.000000e-13
  br i1 %v2431, label %v2370, label %v2428

v2395:
  %v2422 = phi double [ %v2417, %v2386 ], [ %v2393, %v2387 ]
  %v2432 = load double, ptr %v133, align 8, !noalias !313
  %v2433 = load double, ptr %v753, align 8, !noalias !313
  %v2434 = fmul double %v2422, %v2433
  %v2435 = fadd double %v2432, %v2434
  store double %v2435, ptr %v755, align 8, !noalias !313
  br i1 %v797, label %v2436, label %v2437

v2436:
  %v2438 = fsub double 1.000000e+00, %v2422
  br label %v2439

v2439:
  %v2440 = phi i64 [ 0, %v2436 ], [ %v2441, %v2439 ]
  %v2442 = mul i64 %v2440, %v196
  %v2443 = getelementptr double, ptr %v193, i64 %v2442
  %v2444 = getelementptr i8, ptr %v2443, i64 %v761
  %v2445 = load double, ptr %v2444, align 8, !noalias !320
  %v2446 = fadd double %v2445, 0.000000e+00
  %v2447 = fmul double %v2422, %v2446
  %v2448 = getelementptr i8, ptr %v2443, i64 %v762
  %v2449 = load double, ptr %v2448, align 8, !noalias !320
  %v2450 = fadd double %v2449, %v2447
  %v2451 = fmul double %v2438, %v2450
  %v2452 = getelementptr i8, ptr %v2443, i64 %v763
  %v2453 = load double, ptr %v2452, align 8, !noalias !320
  %v2454 = fadd double %v2453, %v2451
  %v2455 = fmul double %v2422, %v2454
  %v2456 = getelementptr i8, ptr %v2443, i64 %v764
  %v2457 = load double, ptr %v2456, align 8, !noalias !320
  %v2458 = fadd double %v2457, %v2455
  %v2459 = fmul double %v2438, %v2458
  %v2460 = getelementptr i8, ptr %v2443, i64 %v765
  %v2461 = load double, ptr %v2460, align 8, !noalias !320
  %v2462 = fadd double %v2461, %v2459
  %v2463 = fmul double %v2422, %v2462
  %v2464 = getelementptr i8, ptr %v2443, i64 %v766
  %v2465 = load double, ptr %v2464, align 8, !noalias !320
  %v2466 = fadd double %v2465, %v2463
  %v2467 = fmul double %v2438, %v2466
  %v2468 = getelementptr i8, ptr %v2443, i64 %v767
  %v2469 = load double, ptr %v2468, align 8, !noalias !320
  %v2470 = fadd double %v2469, %v2467
  %v2471 = fmul double %v2422, %v2470
  %v2441 = add nsw i64 %v2440, 1
  %v2472 = load double, ptr %v2443, align 8, !noalias !320
  %v2473 = fadd double %v2472, %v2471
  %v2474 = getelementptr double, ptr %v758, i64 %v2442
  store double %v2473, ptr %v2474, align 8, !noalias !313
  %v2475 = icmp eq i64 %v10, %v2441
  br i1 %v2475, label %v2437, label %v2439

v2437:
  %v2476 = load i64, ptr %v760, align 8, !noalias !324
  %v2477 = inttoptr i64 %v2476 to ptr
  tail call void %v2477(ptr nonnull %v755, ptr %v799, ptr %v165, ptr %v172, ptr %v179, ptr %v801), !noalias !324
  br i1 %v804, label %v2478, label %v2479

v2478:
  %v2480 = phi i64 [ %v2481, %v2478 ], [ %v803, %v2437 ]
  %v2482 = phi i64 [ %v2483, %v2478 ], [ %v18, %v2437 ]
  %v2481 = add nsw i64 %v2480, -1
  %v2483 = add i64 %v2482, 1
  %v2484 = icmp slt i64 %v2482, 0
  %v2485 = select i1 %v2484, i64 %v207, i64 0
  %v2486 = add i64 %v2485, %v2482
  %v2487 = getelementptr double, ptr %v808, i64 %v2486
  %v2488 = load double, ptr %v2487, align 8, !noalias !327
  %v2489 = getelementptr double, ptr %v811, i64 %v2486
  store double %v2488, ptr %v2489, align 8, !noalias !327
  %v2490 = icmp sgt i64 %v2480, 1
  br i1 %v2490, label %v2478, label %v2479

v2479:
  br i1 %v812, label %v2491, label %v2492

v2492:
  %v2493 = phi double [ %v2494, %v2492 ], [ 0x7FF0000000000000, %v2479 ]
  %v2495 = phi i64 [ %v2496, %v2492 ], [ 0, %v2479 ]
  %v2496 = add nsw i64 %v2495, 1
  %v2497 = getelementptr double, ptr %v813, i64 %v2495
  %v2498 = load double, ptr %v2497, align 8, !noalias !328
  %v2499 = getelementptr double, ptr %v811, i64 %v2495
  %v2500 = load double, ptr %v2499, align 8, !noalias !328
  %v2501 = fadd double %v2498, %v2500
  %v2502 = fcmp olt double %v2501, %v2493
  %v2494 = select i1 %v2502, double %v2501, double %v2493
  %v2503 = icmp eq i64 %v207, %v2496
  br i1 %v2503, label %v2491, label %v2492

v2491:
  %v2423 = phi double [ 0x7FF0000000000000, %v2479 ], [ %v2494, %v2492 ]
  %v2504 = fcmp olt double %v2423, 0.000000e+00
  br i1 %v2504, label %v2421, label %v2425

v2428:
  %v2505 = icmp ugt i64 %v2506, 1
  br i1 %v2505, label %v2507, label %v2365

v2365:
  br i1 %v834, label %v2508, label %v2509

v2508:
  %v2510 = load i64, ptr %v824, align 8, !noalias !332
  %v2511 = inttoptr i64 %v2510 to ptr
  tail call void %v2511(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !332
  store double %v2290, ptr %v783, align 8, !noalias !285
  store double %v2291, ptr %v791, align 8, !noalias !285
  br label %v2369

v2509:
  %v2512 = phi i64 [ %v2513, %v2509 ], [ 0, %v2365 ]
  %v2513 = add nsw i64 %v2512, 1
  %v2514 = add nsw i64 %v2512, %v17
  %v2515 = icmp slt i64 %v2514, 0
  %v2516 = select i1 %v2515, i64 %v166, i64 0
  %v2517 = getelementptr double, ptr %v165, i64 %v2514
  %v2518 = getelementptr double, ptr %v2517, i64 %v2516
  %v2519 = load double, ptr %v2518, align 8, !noalias !338
  %v2520 = getelementptr double, ptr %v836, i64 %v2512
  %v2521 = load double, ptr %v2520, align 8, !noalias !338
  store double %v2521, ptr %v2518, align 8, !noalias !338
  store double %v2519, ptr %v2520, align 8, !noalias !338
  %v2522 = icmp eq i64 %v18, %v2513
  br i1 %v2522, label %v2508, label %v2509

v2292:
  %v2523 = phi i64 [ %v2524, %v2292 ], [ 0, %v2289 ]
  %v2524 = add nsw i64 %v2523, 1
  %v2525 = add nsw i64 %v2523, %v17
  %v2526 = icmp slt i64 %v2525, 0
  %v2527 = select i1 %v2526, i64 %v166, i64 0
  %v2528 = getelementptr double, ptr %v165, i64 %v2525
  %v2529 = getelementptr double, ptr %v2528, i64 %v2527
  %v2530 = load double, ptr %v2529, align 8, !noalias !285
  %v2531 = getelementptr double, ptr %v815, i64 %v2523
  store double %v2530, ptr %v2531, align 8, !noalias !285
  %v2532 = icmp eq i64 %v18, %v2524
  br i1 %v2532, label %v2293, label %v2292

v2293:
  br label %v2507

v2507:
  %v2357 = phi ptr [ %v2356, %v2428 ], [ null, %v2293 ]
  %v2533 = phi ptr [ %v2534, %v2428 ], [ null, %v2293 ]
  %v2506 = phi i64 [ %v2535, %v2428 ], [ 32, %v2293 ]
  %v2535 = add nsw i64 %v2506, -1
  %v2536 = load double, ptr %v791, align 8, !noalias !339
  %v2537 = load double, ptr %v133, align 8, !noalias !343
  %v2538 = load double, ptr %v753, align 8, !noalias !343
  %v2539 = fmul double %v2536, %v2538
  %v2540 = fadd double %v2537, %v2539
  store double %v2540, ptr %v755, align 8, !noalias !343
  br i1 %v797, label %v2541, label %v2542

v2541:
  %v2543 = fsub double 1.000000e+00, %v2536
  br label %v2544

v2544:
  %v2545 = phi i64 [ 0, %v2541 ], [ %v2546, %v2544 ]
  %v2547 = mul i64 %v2545, %v196
  %v2548 = getelementptr double, ptr %v193, i64 %v2547
  %v2549 = getelementptr i8, ptr %v2548, i64 %v761
  %v2550 = load double, ptr %v2549, align 8, !noalias !350
  %v2551 = fadd double %v2550, 0.000000e+00
  %v2552 = fmul double %v2536, %v2551
  %v2553 = getelementptr i8, ptr %v2548, i64 %v762
  %v2554 = load double, ptr %v2553, align 8, !noalias !350
  %v2555 = fadd double %v2554, %v2552
  %v2556 = fmul double %v2543, %v2555
  %v2557 = getelementptr i8, ptr %v2548, i64 %v763
  %v2558 = load double, ptr %v2557, align 8, !noalias !350
  %v2559 = fadd double %v2558, %v2556
  %v2560 = fmul double %v2536, %v2559
  %v2561 = getelementptr i8, ptr %v2548, i64 %v764
  %v2562 = load double, ptr %v2561, align 8, !noalias !350
  %v2563 = fadd double %v2562, %v2560
  %v2564 = fmul double %v2543, %v2563
  %v2565 = getelementptr i8, ptr %v2548, i64 %v765
  %v2566 = load double, ptr %v2565, align 8, !noalias !350
  %v2567 = fadd double %v2566, %v2564
  %v2568 = fmul double %v2536, %v2567
  %v2569 = getelementptr i8, ptr %v2548, i64 %v766
  %v2570 = load double, ptr %v2569, align 8, !noalias !350
  %v2571 = fadd double %v2570, %v2568
  %v2572 = fmul double %v2543, %v2571
  %v2573 = getelementptr i8, ptr %v2548, i64 %v767
  %v2574 = load double, ptr %v2573, align 8, !noalias !350
  %v2575 = fadd double %v2574, %v2572
  %v2576 = fmul double %v2536, %v2575
  %v2546 = add nsw i64 %v2545, 1
  %v2577 = load double, ptr %v2548, align 8, !noalias !350
  %v2578 = fadd double %v2577, %v2576
  %v2579 = getelementptr double, ptr %v818, i64 %v2547
  store double %v2578, ptr %v2579, align 8, !noalias !343
  %v2580 = icmp eq i64 %v10, %v2546
  br i1 %v2580, label %v2542, label %v2544

v2542:
  %v2581 = load i64, ptr %v760, align 8, !noalias !354
  %v2582 = inttoptr i64 %v2581 to ptr
  tail call void %v2582(ptr nonnull %v755, ptr %v799, ptr %v165, ptr %v172, ptr %v179, ptr %v801), !noalias !354
  br i1 %v804, label %v2583, label %v2584

v2583:
  %v2585 = phi i64 [ %v2586, %v2583 ], [ %v802, %v2542 ]
  %v2587 = phi i64 [ %v2588, %v2583 ], [ %v18, %v2542 ]
  %v2586 = add nsw i64 %v2585, -1
  %v2588 = add i64 %v2587, 1
  %v2589 = icmp slt i64 %v2587, 0
  %v2590 = select i1 %v2589, i64 %v207, i64 0
  %v2591 = add i64 %v2590, %v2587
  %v2592 = getelementptr double, ptr %v808, i64 %v2591
  %v2593 = load double, ptr %v2592, align 8, !noalias !357
  %v2594 = getelementptr double, ptr %v811, i64 %v2591
  store double %v2593, ptr %v2594, align 8, !noalias !357
  %v2595 = icmp sgt i64 %v2585, 1
  br i1 %v2595, label %v2583, label %v2584

v2584:
  br label %v2596

v2597:
  br label %v2598

v2598:
  %v2599 = phi double [ %v2536, %v2596 ], [ 1.000000e+00, %v2600 ], [ 8.889000e-01, %v2601 ], [ 2.500000e-01, %v2602 ], [ 3.333000e-01, %v2603 ], [ 5.000000e-01, %v2604 ], [ 0x3FE50A3D70A3D70A, %v2605 ], [ 7.500000e-01, %v2606 ], [ 0x3FB48E8A71DE69AD, %v2597 ]
  %v2607 = fcmp ult double %v2599, %v2536
  br i1 %v2607, label %v2608, label %v2609

v2609:
  %v2610 = load double, ptr %v133, align 8, !noalias !358
  %v2611 = load double, ptr %v753, align 8, !noalias !358
  %v2612 = fmul double %v2599, %v2611
  %v2613 = fadd double %v2610, %v2612
  store double %v2613, ptr %v755, align 8, !noalias !358
  br i1 %v797, label %v2614, label %v2615

v2614:
  %v2616 = fsub double 1.000000e+00, %v2599
  br label %v2617

v2617:
  %v2618 = phi i64 [ 0, %v2614 ], [ %v2619, %v2617 ]
  %v2620 = mul i64 %v2618, %v196
  %v2621 = getelementptr double, ptr %v193, i64 %v2620
  %v2622 = getelementptr i8, ptr %v2621, i64 %v761
  %v2623 = load double, ptr %v2622, align 8, !noalias !362
  %v2624 = fadd double %v2623, 0.000000e+00
  %v2625 = fmul double %v2599, %v2624
  %v2626 = getelementptr i8, ptr %v2621, i64 %v762
  %v2627 = load double, ptr %v2626, align 8, !noalias !362
  %v2628 = fadd double %v2627, %v2625
  %v2629 = fmul double %v2616, %v2628
  %v2630 = getelementptr i8, ptr %v2621, i64 %v763
  %v2631 = load double, ptr %v2630, align 8, !noalias !362
  %v2632 = fadd double %v2631, %v2629
  %v2633 = fmul double %v2599, %v2632
  %v2634 = getelementptr i8, ptr %v2621, i64 %v764
  %v2635 = load double, ptr %v2634, align 8, !noalias !362
  %v2636 = fadd double %v2635, %v2633
  %v2637 = fmul double %v2616, %v2636
  %v2638 = getelementptr i8, ptr %v2621, i64 %v765
  %v2639 = load double, ptr %v2638, align 8, !noalias !362
  %v2640 = fadd double %v2639, %v2637
  %v2641 = fmul double %v2599, %v2640
  %v2642 = getelementptr i8, ptr %v2621, i64 %v766
  %v2643 = load double, ptr %v2642, align 8, !noalias !362
  %v2644 = fadd double %v2643, %v2641
  %v2645 = fmul double %v2616, %v2644
  %v2646 = getelementptr i8, ptr %v2621, i64 %v767
  %v2647 = load double, ptr %v2646, align 8, !noalias !362
  %v2648 = fadd double %v2647, %v2645
  %v2649 = fmul double %v2599, %v2648
  %v2619 = add nsw i64 %v2618, 1
  %v2650 = load double, ptr %v2621, align 8, !noalias !362
  %v2651 = fadd double %v2650, %v2649
  %v2652 = getelementptr double, ptr %v758, i64 %v2620
  store double %v2651, ptr %v2652, align 8, !noalias !358
  %v2653 = icmp eq i64 %v10, %v2619
  br i1 %v2653, label %v2615, label %v2617

v2654:
  %v2655 = load i64, ptr %v824, align 8, !noalias !366
  %v2656 = inttoptr i64 %v2655 to ptr
  tail call void %v2656(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !366
  br label %v2608

v2657:
  %v2658 = phi i64 [ %v2659, %v2657 ], [ 0, %v2660 ]
  %v2659 = add nsw i64 %v2658, 1
  %v2661 = add nsw i64 %v2658, %v17
  %v2662 = icmp slt i64 %v2661, 0
  %v2663 = select i1 %v2662, i64 %v166, i64 0
  %v2664 = getelementptr double, ptr %v165, i64 %v2661
  %v2665 = getelementptr double, ptr %v2664, i64 %v2663
  %v2666 = load double, ptr %v2665, align 8, !noalias !372
  %v2667 = getelementptr double, ptr %v810, i64 %v2658
  %v2668 = load double, ptr %v2667, align 8, !noalias !372
  store double %v2668, ptr %v2665, align 8, !noalias !372
  store double %v2666, ptr %v2667, align 8, !noalias !372
  %v2669 = icmp eq i64 %v18, %v2659
  br i1 %v2669, label %v2654, label %v2657

v2608:
  %v2670 = icmp ugt i64 %v2671, 1
  br i1 %v2670, label %v2596, label %v2672

v2672:
  br i1 %v305, label %v2673, label %v2674

v2674:
  %v2675 = load i64, ptr %v824, align 8, !noalias !373
  %v2676 = inttoptr i64 %v2675 to ptr
  tail call void %v2676(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !373
  br label %v2677

v2673:
  %v2678 = phi i64 [ %v2679, %v2673 ], [ 0, %v2672 ]
  %v2679 = add nsw i64 %v2678, 1
  %v2680 = add nsw i64 %v2678, %v17
  %v2681 = icmp slt i64 %v2680, 0
  %v2682 = select i1 %v2681, i64 %v166, i64 0
  %v2683 = getelementptr double, ptr %v165, i64 %v2680
  %v2684 = getelementptr double, ptr %v2683, i64 %v2682
  %v2685 = load double, ptr %v2684, align 8, !noalias !379
  %v2686 = getelementptr double, ptr %v810, i64 %v2678
  %v2687 = load double, ptr %v2686, align 8, !noalias !379
  store double %v2687, ptr %v2684, align 8, !noalias !379
  store double %v2685, ptr %v2686, align 8, !noalias !379
  %v2688 = icmp eq i64 %v2679, %v18
  br i1 %v2688, label %v2674, label %v2673

v2596:
  %v2671 = phi i64 [ %v2689, %v2608 ], [ 9, %v2584 ]
  %v2690 = phi i64 [ %v2691, %v2608 ], [ 8, %v2584 ]
  %v2689 = add nsw i64 %v2671, -1
  %v2691 = add nsw i64 %v2690, -1
  switch i64 %v2690, label %v2677 [
    i64 0, label %v2598
    i64 -1, label %v2600
    i64 8, label %v2600
    i64 1, label %v2597
    i64 -8, label %v2597
    i64 2, label %v2602
    i64 -7, label %v2602
    i64 3, label %v2603
    i64 -6, label %v2603
    i64 4, label %v2604
    i64 -5, label %v2604
    i64 5, label %v2605
    i64 -4, label %v2605
    i64 6, label %v2606
    i64 -3, label %v2606
    i64 7, label %v2601
    i64 -2, label %v2601
  ]

v2602:
  br label %v2598

v2603:
  br label %v2598

v2604:
  br label %v2598

v2605:
  br label %v2598

v2606:
  br label %v2598

v2601:
  br label %v2598

v2600:
  br label %v2598

v2615:
  %v2692 = load i64, ptr %v6, align 8, !noalias !380
  %v2693 = inttoptr i64 %v2692 to ptr
  tail call void %v2693(ptr nonnull %v755, ptr %v821, ptr %v165, ptr %v172, ptr %v179, ptr %v823), !noalias !380
  br i1 %v305, label %v2694, label %v2695

v2695:
  %v2696 = load i64, ptr %v824, align 8, !noalias !383
  %v2697 = inttoptr i64 %v2696 to ptr
  tail call void %v2697(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !383
  %v2698 = load i64, ptr %v6, align 8, !noalias !389
  %v2699 = inttoptr i64 %v2698 to ptr
  tail call void %v2699(ptr nonnull %v755, ptr %v821, ptr %v165, ptr %v172, ptr %v179, ptr %v826), !noalias !389
  %v2700 = load double, ptr %v23, align 8, !noalias !392
  %v2701 = load double, ptr %v827, align 8, !noalias !392
  br label %v2702

v2694:
  %v2703 = phi i64 [ %v2704, %v2694 ], [ 0, %v2615 ]
  %v2704 = add nsw i64 %v2703, 1
  %v2705 = add nsw i64 %v2703, %v17
  %v2706 = icmp slt i64 %v2705, 0
  %v2707 = select i1 %v2706, i64 %v166, i64 0
  %v2708 = getelementptr double, ptr %v165, i64 %v2705
  %v2709 = getelementptr double, ptr %v2708, i64 %v2707
  %v2710 = load double, ptr %v2709, align 8, !noalias !396
  %v2711 = getelementptr double, ptr %v810, i64 %v2703
  %v2712 = load double, ptr %v2711, align 8, !noalias !396
  store double %v2712, ptr %v2709, align 8, !noalias !396
  store double %v2710, ptr %v2711, align 8, !noalias !396
  %v2713 = icmp eq i64 %v18, %v2704
  br i1 %v2713, label %v2695, label %v2694

v2702:
  %v2714 = phi i64 [ 0, %v2695 ], [ %v2715, %v2716 ]
  %v2717 = icmp eq i64 %v2714, %v816
  br i1 %v2717, label %v2660, label %v2716

v2660:
  br i1 %v305, label %v2657, label %v2654

v2716:
  %v2715 = add i64 %v2714, 1
  %v2718 = mul i64 %v2714, %v196
  %v2719 = getelementptr double, ptr %v829, i64 %v2718
  %v2720 = load double, ptr %v2719, align 8, !noalias !392
  %v2721 = getelementptr double, ptr %v831, i64 %v2718
  %v2722 = load double, ptr %v2721, align 8, !noalias !392
  %v2723 = fsub double %v2720, %v2722
  %v2724 = tail call double @llvm.fabs.f64(double %v2723)
  %v2725 = getelementptr double, ptr %v193, i64 %v2718
  %v2726 = load double, ptr %v2725, align 8, !noalias !392
  %v2727 = tail call double @llvm.fabs.f64(double %v2726)
  %v2728 = fmul double %v2700, %v2727
  %v2729 = fadd double %v2701, %v2728
  %v2730 = load double, ptr %v753, align 8, !noalias !392
  %v2731 = fmul double %v2730, %v2724
  %v2732 = fmul double %v2729, 1.000000e-01
  %v2733 = fcmp ugt double %v2731, %v2732
  br i1 %v2733, label %v2677, label %v2702

v2677:
  %v2734 = phi i1 [ false, %v2716 ], [ true, %v2674 ], [ true, %v2596 ]
  %v2534 = phi ptr [ %v2533, %v2716 ], [ %v2533, %v2674 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.30, %v2596 ]
  %v2735 = phi i1 [ true, %v2716 ], [ true, %v2674 ], [ false, %v2596 ]
  %v2736 = phi i32 [ 0, %v2716 ], [ 0, %v2674 ], [ 1, %v2596 ]
  br i1 %v2735, label %v2298, label %v2360, !prof !131

v2298:
  br i1 %v2734, label %v2294, label %v2365

v2359:
  %v2737 = load double, ptr %v791, align 8, !noalias !285
  store i8 0, ptr %v300, align 1, !noalias !285
  %v2738 = call fastcc i32 @_ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr %v300, ptr %v301, i64 %v14, ptr nonnull readonly %v92, i64 %v93, ptr %v124, i64 %v125, i64 %v126, ptr nonnull %v133, i64 %v135, ptr %v142, i64 %v144, ptr %v204, i64 %v205, i64 %v206, i64 %v207, double %v2737)
  %v2739 = icmp eq i32 %v2738, 0
  br i1 %v2739, label %v2430, label %v2740, !prof !131

v2740:
  %v2741 = load ptr, ptr %v301, align 8, !noalias !285
  br label %v2369

v2430:
  %v2742 = load i8, ptr %v300, align 1, !noalias !285
  %v2743 = icmp eq i8 %v2742, 0
  br i1 %v2743, label %v2361, label %v2429

v2360:
  %v2744 = phi ptr [ %v2356, %v2301 ], [ %v2534, %v2677 ]
  %v2745 = phi i32 [ %v2358, %v2301 ], [ %v2736, %v2677 ]
  %v2746 = icmp ne i32 %v2745, 0
  br label %v2369

v2369:
  %v2747 = phi i1 [ true, %v2364 ], [ false, %v2508 ], [ true, %v2740 ], [ %v2746, %v2360 ]
  %v2748 = phi ptr [ null, %v2364 ], [ null, %v2508 ], [ %v2741, %v2740 ], [ %v2744, %v2360 ]
  %v2749 = phi i1 [ false, %v2364 ], [ false, %v2508 ], [ true, %v2740 ], [ %v2746, %v2360 ]
  call void @llvm.lifetime.end.p0(ptr nonnull %v300), !noalias !180
  call void @llvm.lifetime.end.p0(ptr nonnull %v301), !noalias !180
  %v2750 = select i1 %v2749, ptr %v2748, ptr null, !prof !397
  %v2751 = xor i1 %v2749, true
  br i1 %v2747, label %v2287, label %v2752, !prof !398

v2752:
  %v2753 = load double, ptr %v842, align 8, !noalias !180
  %v2754 = fcmp olt double %v2753, 5.000000e-01
  br i1 %v2754, label %v2287, label %v2275

v2275:
  store double 1.000000e+00, ptr %v858, align 8, !noalias !180
  %v2755 = load double, ptr %v785, align 8, !noalias !399
  %v2756 = load double, ptr %v92, align 8, !noalias !399
  %v2757 = fsub double %v2755, %v2756
  %v2758 = fmul double %v2757, 1.000000e-13
  %v2759 = load double, ptr %v133, align 8, !noalias !399
  %v2760 = tail call double @llvm.fabs.f64(double %v2759)
  %v2761 = fmul double %v2760, 4.000000e-15
  %v2762 = fcmp ogt double %v2761, %v2758
  %v2763 = select i1 %v2762, double %v2761, double %v2758
  %v2764 = load double, ptr %v791, align 8, !noalias !180
  %v2765 = fdiv double %v2763, %v1746
  %v2766 = fcmp ogt double %v2765, %v2764
  %v2767 = select i1 %v2766, double %v2765, double %v2764
  %v2768 = fcmp ult double %v2767, 1.000000e+00
  br i1 %v2768, label %v2769, label %v2287

v2769:
  %v2770 = fsub double 1.000000e+00, %v2767
  br i1 %v723, label %v2771, label %v2772

v2771:
  %v2773 = load double, ptr %v860, align 8, !noalias !180
  %v2774 = fmul double %v2767, 4.000000e+00
  %v2775 = fmul double %v2774, %v2770
  %v2776 = fmul double %v2775, %v2773
  %v2777 = fmul double %v2775, %v2776
  %v2778 = fcmp olt double %v2777, 5.000000e-04
  br i1 %v2778, label %v2779, label %v2772

v2779:
  %v2780 = load double, ptr %v753, align 8, !noalias !403
  %v2781 = fmul double %v2767, %v2780
  %v2782 = fadd double %v2759, %v2781
  store double %v2782, ptr %v755, align 8, !noalias !403
  br i1 %v757, label %v2783, label %v2784

v2784:
  %v2785 = phi i64 [ %v2786, %v2784 ], [ 0, %v2779 ]
  %v2787 = mul i64 %v2785, %v196
  %v2788 = getelementptr double, ptr %v193, i64 %v2787
  %v2789 = getelementptr i8, ptr %v2788, i64 %v761
  %v2790 = load double, ptr %v2789, align 8, !noalias !410
  %v2791 = fadd double %v2790, 0.000000e+00
  %v2792 = fmul double %v2767, %v2791
  %v2793 = getelementptr i8, ptr %v2788, i64 %v762
  %v2794 = load double, ptr %v2793, align 8, !noalias !410
  %v2795 = fadd double %v2794, %v2792
  %v2796 = fmul double %v2770, %v2795
  %v2797 = getelementptr i8, ptr %v2788, i64 %v763
  %v2798 = load double, ptr %v2797, align 8, !noalias !410
  %v2799 = fadd double %v2798, %v2796
  %v2800 = fmul double %v2767, %v2799
  %v2801 = getelementptr i8, ptr %v2788, i64 %v764
  %v2802 = load double, ptr %v2801, align 8, !noalias !410
  %v2803 = fadd double %v2802, %v2800
  %v2804 = fmul double %v2770, %v2803
  %v2805 = getelementptr i8, ptr %v2788, i64 %v765
  %v2806 = load double, ptr %v2805, align 8, !noalias !410
  %v2807 = fadd double %v2806, %v2804
  %v2808 = fmul double %v2767, %v2807
  %v2809 = getelementptr i8, ptr %v2788, i64 %v766
  %v2810 = load double, ptr %v2809, align 8, !noalias !410
  %v2811 = fadd double %v2810, %v2808
  %v2812 = fmul double %v2770, %v2811
  %v2813 = getelementptr i8, ptr %v2788, i64 %v767
  %v2814 = load double, ptr %v2813, align 8, !noalias !410
  %v2815 = fadd double %v2814, %v2812
  %v2816 = fmul double %v2767, %v2815
  %v2786 = add nsw i64 %v2785, 1
  %v2817 = load double, ptr %v2788, align 8, !noalias !410
  %v2818 = fadd double %v2817, %v2816
  %v2819 = getelementptr double, ptr %v758, i64 %v2787
  store double %v2818, ptr %v2819, align 8, !noalias !403
  %v2820 = icmp eq i64 %v10, %v2786
  br i1 %v2820, label %v2821, label %v2784

v2783:
  %v2822 = load double, ptr %v755, align 8, !noalias !414
  store double %v2822, ptr %v787, align 8, !noalias !414
  br label %v2823

v2823:
  %v2824 = load i64, ptr %v6, align 8, !noalias !415
  %v2825 = inttoptr i64 %v2824 to ptr
  tail call void %v2825(ptr nonnull %v755, ptr %v870, ptr %v165, ptr %v172, ptr %v179, ptr %v872), !noalias !415
  %v2826 = load i64, ptr %v760, align 8, !noalias !418
  %v2827 = inttoptr i64 %v2826 to ptr
  tail call void %v2827(ptr nonnull %v755, ptr %v874, ptr %v165, ptr %v172, ptr %v179, ptr %v876), !noalias !418
  br label %v2287

v2821:
  %v2828 = load double, ptr %v755, align 8, !noalias !414
  store double %v2828, ptr %v787, align 8, !noalias !414
  br label %v2829

v2829:
  %v2830 = phi i64 [ 0, %v2821 ], [ %v2831, %v2829 ]
  %v2831 = add nsw i64 %v2830, 1
  %v2832 = mul i64 %v2830, %v196
  %v2833 = getelementptr double, ptr %v758, i64 %v2832
  %v2834 = load double, ptr %v2833, align 8, !noalias !414
  %v2835 = getelementptr double, ptr %v867, i64 %v2832
  store double %v2834, ptr %v2835, align 8, !noalias !414
  %v2836 = icmp eq i64 %v10, %v2831
  br i1 %v2836, label %v2823, label %v2829

v2772:
  %v2837 = fmul double %v2763, 2.000000e+00
  %v2838 = fcmp ogt double %v1746, %v2837
  br i1 %v2838, label %v2839, label %v2287

v2839:
  %v2840 = load double, ptr %v787, align 8, !noalias !180
  %v2841 = tail call double @llvm.fabs.f64(double %v2840)
  %v2842 = fmul double %v2841, 4.000000e-15
  %v2843 = fmul double %v1746, 0x3D719799812DEA11
  %v2844 = fcmp ogt double %v2842, %v2843
  %v2845 = select i1 %v2844, double %v2842, double %v2843
  %v2846 = load double, ptr %v783, align 8, !noalias !180
  %v2847 = fsub double 1.000000e+00, %v2846
  %v2848 = fmul double %v1746, %v2847
  %v2849 = fcmp ogt double %v2848, %v2845
  br i1 %v2849, label %v2850, label %v2287

v2850:
  %v2851 = fmul double %v1746, %v2767
  store double 0.000000e+00, ptr %v862, align 8, !noalias !421
  store double 0.000000e+00, ptr %v864, align 8, !noalias !421
  store double %v2851, ptr %v865, align 8, !noalias !421
  %v2852 = load i64, ptr %v142, align 8, !noalias !421
  %v2853 = icmp slt i64 %v2852, 0
  %v2854 = select i1 %v2853, i64 %v125, i64 0
  %v2855 = add i64 %v2854, %v2852
  %v2856 = mul i64 %v2855, %v126
  %v2857 = getelementptr i64, ptr %v124, i64 %v2856
  %v2858 = load i64, ptr %v2857, align 8, !noalias !421
  %v2859 = add nsw i64 %v2858, -1
  store i64 %v2859, ptr %v2857, align 8, !noalias !421
  %v2860 = load i64, ptr %v142, align 8, !noalias !421
  %v2861 = icmp slt i64 %v2860, 0
  %v2862 = select i1 %v2861, i64 %v125, i64 0
  %v2863 = add i64 %v2862, %v2860
  %v2864 = mul i64 %v2863, %v126
  %v2865 = getelementptr i64, ptr %v124, i64 %v2864
  %v2866 = getelementptr i8, ptr %v2865, i64 24
  %v2867 = load i64, ptr %v2866, align 8, !noalias !421
  %v2868 = add nsw i64 %v2867, 1
  store i64 %v2868, ptr %v2866, align 8, !noalias !421
  br label %v2287

v1814:
  br i1 %v304, label %v1889, label %v2288

v2287:
  %v2869 = phi ptr [ null, %v2823 ], [ null, %v2850 ], [ null, %v2772 ], [ null, %v2275 ], [ null, %v2752 ], [ null, %v2220 ], [ null, %v2839 ], [ %v2750, %v2369 ]
  %v2870 = phi i1 [ true, %v2823 ], [ true, %v2850 ], [ true, %v2772 ], [ true, %v2275 ], [ true, %v2752 ], [ true, %v2220 ], [ true, %v2839 ], [ %v2751, %v2369 ]
  br i1 %v2870, label %v1586, label %v1499, !prof !131

v1586:
  %v2871 = select i1 %v1406, i1 true, i1 %v686
  %v2872 = select i1 %v2871, i64 0, i64 %v12
  br label %v1499

v2873:
  %v2874 = phi i64 [ 0, %v1492 ], [ %v2875, %v2876 ]
  %v2877 = phi i64 [ %v715, %v1492 ], [ %v2878, %v2876 ]
  %v2879 = icmp sgt i64 %v2877, 0
  br i1 %v2879, label %v2876, label %v1493

v1492:
  %v2880 = load double, ptr %v714, align 8, !noalias !424
  store double %v2880, ptr %v700, align 8, !noalias !424
  br label %v2873

v2876:
  %v2878 = add nsw i64 %v2877, -1
  %v2875 = add i64 %v2874, 1
  %v2881 = getelementptr double, ptr %v717, i64 %v2874
  %v2882 = icmp slt i64 %v2874, 0
  %v2883 = select i1 %v2882, i64 %v207, i64 0
  %v2884 = getelementptr double, ptr %v2881, i64 %v2883
  %v2885 = load double, ptr %v2884, align 8, !noalias !424
  %v2886 = fcmp olt double %v2885, 0x7FF0000000000000
  %v2887 = select i1 %v2886, double %v2885, double 0x7FF0000000000000
  %v2888 = fcmp ogt double %v2885, 0xFFF0000000000000
  %v2889 = select i1 %v2888, double %v2885, double 0xFFF0000000000000
  %v2890 = getelementptr double, ptr %v2884, i64 %v716
  %v2891 = load double, ptr %v2890, align 8, !noalias !424
  %v2892 = fcmp olt double %v2891, %v2887
  %v2893 = select i1 %v2892, double %v2891, double %v2887
  %v2894 = fcmp ogt double %v2891, %v2889
  %v2895 = select i1 %v2894, double %v2891, double %v2889
  %v2896 = getelementptr i8, ptr %v2884, i64 %v1047
  %v2897 = load double, ptr %v2896, align 8, !noalias !424
  %v2898 = fcmp olt double %v2897, %v2893
  %v2899 = select i1 %v2898, double %v2897, double %v2893
  %v2900 = fcmp ogt double %v2897, %v2895
  %v2901 = select i1 %v2900, double %v2897, double %v2895
  %v2902 = getelementptr i8, ptr %v2884, i64 %v1048
  %v2903 = load double, ptr %v2902, align 8, !noalias !424
  %v2904 = fcmp olt double %v2903, %v2899
  %v2905 = select i1 %v2904, double %v2903, double %v2899
  %v2906 = fcmp ogt double %v2903, %v2901
  %v2907 = select i1 %v2906, double %v2903, double %v2901
  %v2908 = getelementptr i8, ptr %v2884, i64 %v1049
  %v2909 = load double, ptr %v2908, align 8, !noalias !424
  %v2910 = fcmp olt double %v2909, %v2905
  %v2911 = select i1 %v2910, double %v2909, double %v2905
  %v2912 = fcmp ogt double %v2909, %v2907
  %v2913 = select i1 %v2912, double %v2909, double %v2907
  %v2914 = getelementptr i8, ptr %v2884, i64 %v1050
  %v2915 = load double, ptr %v2914, align 8, !noalias !424
  %v2916 = fcmp olt double %v2915, %v2911
  %v2917 = select i1 %v2916, double %v2915, double %v2911
  %v2918 = fcmp ogt double %v2915, %v2913
  %v2919 = select i1 %v2918, double %v2915, double %v2913
  %v2920 = getelementptr i8, ptr %v2884, i64 %v1051
  %v2921 = load double, ptr %v2920, align 8, !noalias !424
  %v2922 = fcmp olt double %v2921, %v2917
  %v2923 = select i1 %v2922, double %v2921, double %v2917
  %v2924 = fcmp ogt double %v2921, %v2919
  %v2925 = select i1 %v2924, double %v2921, double %v2919
  %v2926 = getelementptr i8, ptr %v2884, i64 %v1052
  %v2927 = load double, ptr %v2926, align 8, !noalias !424
  %v2928 = fcmp olt double %v2927, %v2923
  %v2929 = select i1 %v2928, double %v2927, double %v2923
  %v2930 = fcmp ogt double %v2927, %v2925
  %v2931 = select i1 %v2930, double %v2927, double %v2925
  %v2932 = getelementptr i8, ptr %v2884, i64 %v1053
  %v2933 = load double, ptr %v2932, align 8, !noalias !424
  %v2934 = fcmp olt double %v2933, %v2929
  %v2935 = select i1 %v2934, double %v2933, double %v2929
  %v2936 = fcmp ogt double %v2933, %v2931
  %v2937 = select i1 %v2936, double %v2933, double %v2931
  %v2938 = fsub double %v2937, %v2935
  %v2939 = fmul double %v2938, 2.500000e-01
  %v2940 = icmp slt i64 %v2874, 0
  %v2941 = select i1 %v2940, i64 %v207, i64 0
  %v2942 = add i64 %v2941, %v2874
  %v2943 = getelementptr double, ptr %v719, i64 %v2942
  %v2944 = getelementptr double, ptr %v720, i64 %v2942
  %v2945 = getelementptr double, ptr %v2943, i64 %v718
  %v2946 = load double, ptr %v2945, align 8, !noalias !425
  %v2947 = load double, ptr %v2944, align 8, !noalias !425
  %v2948 = fmul double %v2947, 0x3FDDF27AAAADCB3A
  %v2949 = fsub double %v2946, %v2948
  %v2950 = getelementptr i8, ptr %v2944, i64 %v1054
  %v2951 = load double, ptr %v2950, align 8, !noalias !425
  %v2952 = fmul double %v2951, 0x3FEC575F1EBC4F2F
  %v2953 = fsub double %v2949, %v2952
  %v2954 = getelementptr i8, ptr %v2944, i64 %v1055
  %v2955 = load double, ptr %v2954, align 8, !noalias !425
  %v2956 = fmul double %v2955, 0xBFE1306AA3D795F4
  %v2957 = fsub double %v2953, %v2956
  %v2958 = getelementptr i8, ptr %v2944, i64 %v1056
  %v2959 = load double, ptr %v2958, align 8, !noalias !425
  %v2960 = fmul double %v2959, 0x3FCCB9F574BDCC3A
  %v2961 = fsub double %v2957, %v2960
  %v2962 = getelementptr i8, ptr %v2944, i64 %v1057
  %v2963 = load double, ptr %v2962, align 8, !noalias !425
  %v2964 = fmul double %v2963, 0xBFA4EAF2D6B11E79
  %v2965 = fsub double %v2961, %v2964
  %v2966 = tail call double @llvm.fabs.f64(double %v2965)
  %v2967 = fcmp ogt double %v2966, 0.000000e+00
  %v2968 = select i1 %v2967, double %v2966, double 0.000000e+00
  %v2969 = getelementptr i8, ptr %v2943, i64 %v1058
  %v2970 = load double, ptr %v2969, align 8, !noalias !425
  %v2971 = load double, ptr %v2944, align 8, !noalias !425
  %v2972 = fmul double %v2971, 0xBFA5118805F8B876
  %v2973 = fsub double %v2970, %v2972
  %v2974 = getelementptr i8, ptr %v2944, i64 %v1059
  %v2975 = load double, ptr %v2974, align 8, !noalias !425
  %v2976 = fmul double %v2975, 0x3FE51326698BC5BD
  %v2977 = fsub double %v2973, %v2976
  %v2978 = getelementptr i8, ptr %v2944, i64 %v1060
  %v2979 = load double, ptr %v2978, align 8, !noalias !425
  %v2980 = fmul double %v2979, 0x3FDF97DED30D4572
  %v2981 = fsub double %v2977, %v2980
  %v2982 = getelementptr i8, ptr %v2944, i64 %v1061
  %v2983 = load double, ptr %v2982, align 8, !noalias !425
  %v2984 = fmul double %v2983, 0xBFC0DA0C684D1D67
  %v2985 = fsub double %v2981, %v2984
  %v2986 = getelementptr i8, ptr %v2944, i64 %v1062
  %v2987 = load double, ptr %v2986, align 8, !noalias !425
  %v2988 = fmul double %v2987, 0x3F9510B8EC0D4D92
  %v2989 = fsub double %v2985, %v2988
  %v2990 = tail call double @llvm.fabs.f64(double %v2989)
  %v2991 = fcmp ogt double %v2990, %v2968
  %v2992 = select i1 %v2991, double %v2990, double %v2968
  %v2993 = getelementptr i8, ptr %v2943, i64 %v1063
  %v2994 = load double, ptr %v2993, align 8, !noalias !425
  %v2995 = load double, ptr %v2944, align 8, !noalias !425
  %v2996 = fmul double %v2995, 0x3F9635A30F8F142F
  %v2997 = fsub double %v2994, %v2996
  %v2998 = getelementptr i8, ptr %v2944, i64 %v1064
  %v2999 = load double, ptr %v2998, align 8, !noalias !425
  %v3000 = fmul double %v2999, 0xBFC1EAE0FF33D241
  %v3001 = fsub double %v2997, %v3000
  %v3002 = getelementptr i8, ptr %v2944, i64 %v1065
  %v3003 = load double, ptr %v3002, align 8, !noalias !425
  %v3004 = fmul double %v3003, 0x3FE1625D59218460
  %v3005 = fsub double %v3001, %v3004
  %v3006 = getelementptr i8, ptr %v2944, i64 %v1066
  %v3007 = load double, ptr %v3006, align 8, !noalias !425
  %v3008 = fmul double %v3007, 0x3FE3BBC3E8A29641
  %v3009 = fsub double %v3005, %v3008
  %v3010 = getelementptr i8, ptr %v2944, i64 %v1067
  %v3011 = load double, ptr %v3010, align 8, !noalias !425
  %v3012 = fmul double %v3011, 0xBFA55161A739EB34
  %v3013 = fsub double %v3009, %v3012
  %v3014 = tail call double @llvm.fabs.f64(double %v3013)
  %v3015 = fcmp ogt double %v3014, %v2992
  %v3016 = select i1 %v3015, double %v3014, double %v2992
  %v3017 = getelementptr i8, ptr %v2943, i64 %v1068
  %v3018 = load double, ptr %v3017, align 8, !noalias !425
  %v3019 = load double, ptr %v2944, align 8, !noalias !425
  %v3020 = fmul double %v3019, 0xBFA4F0C0BB579409
  %v3021 = fsub double %v3018, %v3020
  %v3022 = getelementptr i8, ptr %v2944, i64 %v1069
  %v3023 = load double, ptr %v3022, align 8, !noalias !425
  %v3024 = fmul double %v3023, 0x3FCD2266FBC0D976
  %v3025 = fsub double %v3021, %v3024
  %v3026 = getelementptr i8, ptr %v2944, i64 %v1070
  %v3027 = load double, ptr %v3026, align 8, !noalias !425
  %v3028 = fmul double %v3027, 0xBFE1F2DB6FEE3151
  %v3029 = fsub double %v3025, %v3028
  %v3030 = getelementptr i8, ptr %v2944, i64 %v1071
  %v3031 = load double, ptr %v3030, align 8, !noalias !425
  %v3032 = fmul double %v3031, 0x3FF0C05015964CBE
  %v3033 = fsub double %v3029, %v3032
  %v3034 = getelementptr i8, ptr %v2944, i64 %v1072
  %v3035 = load double, ptr %v3034, align 8, !noalias !425
  %v3036 = fmul double %v3035, 0x3FD4F15B230DB570
  %v3037 = fsub double %v3033, %v3036
  %v3038 = tail call double @llvm.fabs.f64(double %v3037)
  %v3039 = fcmp ogt double %v3038, %v3016
  %v3040 = select i1 %v3039, double %v3038, double %v3016
  %v3041 = fmul double %v3040, 1.000000e+01
  %v3042 = fadd double %v2939, %v3041
  %v3043 = icmp slt i64 %v2874, 0
  %v3044 = select i1 %v3043, i64 %v207, i64 0
  %v3045 = getelementptr double, ptr %v722, i64 %v2874
  %v3046 = getelementptr double, ptr %v3045, i64 %v3044
  %v3047 = load double, ptr %v3046, align 8, !noalias !424
  %v3048 = fcmp ogt double %v3042, %v3047
  %v3049 = fneg double %v3047
  %v3050 = select i1 %v3048, double %v3042, double %v3049
  %v3051 = fcmp olt double %v2935, %v3050
  br i1 %v3051, label %v1493, label %v2873

v1493:
  %v1495 = phi i1 [ false, %v1435 ], [ %v2879, %v2876 ], [ %v2879, %v2873 ]
  %v3052 = phi ptr [ %v1490, %v1435 ], [ null, %v2876 ], [ null, %v2873 ]
  %v3053 = phi i32 [ %v1491, %v1435 ], [ 0, %v2876 ], [ 0, %v2873 ]
  %v3054 = icmp eq i32 %v3053, 0
  br i1 %v3054, label %v1425, label %v1499, !prof !131

v1743:
  br i1 %v1738, label %v1586, label %v1744

v1499:
  %v3055 = phi i64 [ 0, %v1425 ], [ %v2872, %v1586 ], [ 0, %v1493 ], [ 0, %v1651 ], [ 0, %v2287 ]
  %v3056 = phi i1 [ true, %v1425 ], [ true, %v1586 ], [ false, %v1493 ], [ false, %v1651 ], [ false, %v2287 ]
  %v3057 = phi ptr [ undef, %v1425 ], [ undef, %v1586 ], [ %v3052, %v1493 ], [ %v1742, %v1651 ], [ %v2869, %v2287 ]
  %v3058 = phi i32 [ 0, %v1425 ], [ 0, %v1586 ], [ 1, %v1493 ], [ 1, %v1651 ], [ 1, %v2287 ]
  br i1 %v3056, label %v3059, label %v3060, !prof !131

v3061:
  %v3062 = getelementptr double, ptr %v879, i64 %v3063
  %v3064 = load double, ptr %v3062, align 8, !noalias !429
  %v3065 = fcmp olt double %v3064, 5.000000e-01
  br i1 %v3065, label %v3066, label %v3067

v3067:
  %v3068 = getelementptr i64, ptr %v110, i64 %v3069
  %v3070 = load i64, ptr %v3068, align 8, !noalias !429
  %v3071 = icmp eq i64 %v3070, 0
  br i1 %v3071, label %v3072, label %v3066

v3072:
  %v3073 = mul i64 %v3069, %v126
  %v3074 = getelementptr i64, ptr %v124, i64 %v3073
  %v3075 = getelementptr i8, ptr %v3074, i64 8
  %v3076 = load i64, ptr %v3075, align 8, !noalias !429
  %v3077 = add nsw i64 %v3076, %v3055
  store i64 %v3077, ptr %v3075, align 8, !noalias !429
  %v3078 = getelementptr double, ptr %v881, i64 %v3063
  %v3079 = load double, ptr %v3078, align 8, !noalias !429
  %v3080 = load i64, ptr %v3081, align 8, !noalias !432
  %v3082 = getelementptr i64, ptr %v883, i64 %v3063
  %v3083 = load i64, ptr %v3082, align 8, !noalias !432
  %v3084 = icmp slt i64 %v3083, %v93
  br i1 %v3084, label %v3085, label %v3086

v3085:
  %v3087 = icmp slt i64 %v3083, 0
  %v3088 = select i1 %v3087, i64 %v93, i64 0
  %v3089 = getelementptr double, ptr %v92, i64 %v3083
  %v3090 = getelementptr double, ptr %v3089, i64 %v3088
  %v3091 = load double, ptr %v3090, align 8, !noalias !432
  %v3092 = fcmp ugt double %v3091, %v3079
  br i1 %v3092, label %v3086, label %v3093

v3093:
  %v3094 = getelementptr double, ptr %v133, i64 %v3063
  %v3095 = getelementptr double, ptr %v885, i64 %v3063
  %v3096 = getelementptr double, ptr %v193, i64 %v3063
  %v3097 = getelementptr double, ptr %v889, i64 %v3063
  %v3098 = icmp slt i64 %v3080, 0
  %v3099 = select i1 %v3098, i64 %v100, i64 0
  %v3100 = add i64 %v3099, %v3080
  %v3101 = mul i64 %v890, %v3100
  %v3102 = getelementptr double, ptr %v99, i64 %v3101
  %v3103 = getelementptr double, ptr %v891, i64 %v3063
  br label %v3104

v3104:
  %v3105 = phi i64 [ %v3106, %v3107 ], [ %v3083, %v3093 ]
  %v3108 = icmp slt i64 %v3105, 0
  %v3109 = select i1 %v3108, i64 %v93, i64 0
  %v3110 = getelementptr double, ptr %v92, i64 %v3105
  %v3111 = getelementptr double, ptr %v3110, i64 %v3109
  %v3112 = load double, ptr %v3111, align 8, !noalias !432
  %v3113 = load double, ptr %v3094, align 8, !noalias !432
  %v3114 = fsub double %v3112, %v3113
  %v3115 = load double, ptr %v3095, align 8, !noalias !432
  %v3116 = fdiv double %v3114, %v3115
  br i1 %v887, label %v3117, label %v3118

v3118:
  %v3119 = fsub double 1.000000e+00, %v3116
  %v3120 = select i1 %v3108, i64 %v101, i64 0
  %v3121 = add i64 %v3120, %v3105
  %v3122 = mul i64 %v3121, %v102
  %v3123 = getelementptr double, ptr %v3102, i64 %v3122
  br label %v3124

v3125:
  %v3126 = getelementptr double, ptr %v3103, i64 %v3127
  %v3128 = load double, ptr %v3126, align 8, !noalias !432
  br label %v3129

v3117:
  store double 0x7FF0000000000000, ptr %v3097, align 8, !noalias !432
  %v3130 = icmp eq i64 %v3105, %v892
  br i1 %v3130, label %v3086, label %v3107

v3107:
  %v3106 = add i64 %v3105, 1
  %v3131 = icmp slt i64 %v3105, -1
  %v3132 = select i1 %v3131, i64 %v93, i64 0
  %v3133 = getelementptr double, ptr %v92, i64 %v3106
  %v3134 = getelementptr double, ptr %v3133, i64 %v3132
  %v3135 = load double, ptr %v3134, align 8, !noalias !432
  %v3136 = fcmp ugt double %v3135, %v3079
  br i1 %v3136, label %v3086, label %v3104

v3086:
  %v3137 = phi i64 [ %v3083, %v3085 ], [ %v3083, %v3072 ], [ %v93, %v3117 ], [ %v3106, %v3107 ]
  store i64 %v3137, ptr %v3082, align 8, !noalias !432
  br label %v3066

v3129:
  %v3138 = phi double [ %v3139, %v3140 ], [ %v3128, %v3125 ]
  %v3141 = getelementptr double, ptr %v3123, i64 %v3142
  store double %v3138, ptr %v3141, align 8, !noalias !432
  %v3143 = icmp eq i64 %v10, %v3144
  br i1 %v3143, label %v3117, label %v3124

v3124:
  %v3142 = phi i64 [ 0, %v3118 ], [ %v3144, %v3129 ]
  %v3144 = add nsw i64 %v3142, 1
  %v3145 = load double, ptr %v3111, align 8, !noalias !432
  %v3146 = load double, ptr %v3078, align 8, !noalias !432
  %v3147 = fcmp oeq double %v3145, %v3146
  %v3127 = mul i64 %v3142, %v196
  br i1 %v3147, label %v3125, label %v3140

v3140:
  %v3148 = getelementptr double, ptr %v3096, i64 %v3127
  %v3149 = getelementptr i8, ptr %v3148, i64 %v893
  %v3150 = load double, ptr %v3149, align 8, !noalias !436
  %v3151 = fadd double %v3150, 0.000000e+00
  %v3152 = fmul double %v3116, %v3151
  %v3153 = getelementptr i8, ptr %v3148, i64 %v894
  %v3154 = load double, ptr %v3153, align 8, !noalias !436
  %v3155 = fadd double %v3154, %v3152
  %v3156 = fmul double %v3119, %v3155
  %v3157 = getelementptr i8, ptr %v3148, i64 %v895
  %v3158 = load double, ptr %v3157, align 8, !noalias !436
  %v3159 = fadd double %v3158, %v3156
  %v3160 = fmul double %v3116, %v3159
  %v3161 = getelementptr i8, ptr %v3148, i64 %v896
  %v3162 = load double, ptr %v3161, align 8, !noalias !436
  %v3163 = fadd double %v3162, %v3160
  %v3164 = fmul double %v3119, %v3163
  %v3165 = getelementptr i8, ptr %v3148, i64 %v897
  %v3166 = load double, ptr %v3165, align 8, !noalias !436
  %v3167 = fadd double %v3166, %v3164
  %v3168 = fmul double %v3116, %v3167
  %v3169 = getelementptr i8, ptr %v3148, i64 %v898
  %v3170 = load double, ptr %v3169, align 8, !noalias !436
  %v3171 = fadd double %v3170, %v3168
  %v3172 = fmul double %v3119, %v3171
  %v3173 = getelementptr i8, ptr %v3148, i64 %v899
  %v3174 = load double, ptr %v3173, align 8, !noalias !436
  %v3175 = fadd double %v3174, %v3172
  %v3176 = fmul double %v3116, %v3175
  %v3177 = load double, ptr %v3148, align 8, !noalias !436
  %v3139 = fadd double %v3177, %v3176
  br label %v3129

v3066:
  %v3178 = icmp eq i64 %v3179, %v9
  br i1 %v3178, label %v3180, label %v3181

v3181:
  %v3063 = phi i64 [ %v3179, %v3066 ], [ 0, %v3059 ]
  %v3179 = add nsw i64 %v3063, 1
  %v3081 = getelementptr i64, ptr %v142, i64 %v3063
  %v3069 = load i64, ptr %v3081, align 8, !noalias !429
  %v3182 = icmp slt i64 %v3069, 0
  br i1 %v3182, label %v3066, label %v3061

v3180:
  br i1 %v900, label %v3183, label %v3184

v3184:
  %v3185 = load double, ptr %v902, align 8
  %v3186 = fcmp ogt double %v3185, 5.000000e-01
  br i1 %v3186, label %v3183, label %v3187

v3183:
  %v3188 = load i64, ptr %v903, align 8, !noalias !440
  %v3189 = inttoptr i64 %v3188 to ptr
  tail call void %v3189(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !440
  br label %v3187

v3187:
  br i1 %v1421, label %v3190, label %v3191

v3190:
  %v3192 = load double, ptr %v905, align 8, !noalias !443
  %v3193 = fcmp olt double %v3192, 5.000000e-01
  br i1 %v3193, label %v3191, label %v3194

v3194:
  br i1 %v907, label %v3195, label %v3196

v3197:
  %v3198 = getelementptr double, ptr %v908, i64 %v3199
  %v3200 = load double, ptr %v3198, align 8, !noalias !443
  %v3201 = add nsw i64 %v3199, %v17
  %v3202 = icmp slt i64 %v3201, 0
  %v3203 = select i1 %v3202, i64 %v166, i64 0
  %v3204 = getelementptr double, ptr %v165, i64 %v3201
  %v3205 = getelementptr double, ptr %v3204, i64 %v3203
  %v3206 = load double, ptr %v3205, align 8, !noalias !443
  %v3207 = fcmp une double %v3200, %v3206
  br label %v3208

v3208:
  %v3209 = phi i1 [ true, %v3195 ], [ %v3207, %v3197 ]
  %v3210 = icmp eq i64 %v3211, %v18
  br i1 %v3210, label %v3196, label %v3195

v3196:
  %v3212 = phi i1 [ false, %v3194 ], [ %v3209, %v3208 ]
  %v3213 = load double, ptr %v910, align 8, !noalias !443
  %v3214 = fcmp oeq double %v3213, 1.000000e+00
  %v3215 = select i1 %v3214, i1 %v3212, i1 false
  br i1 %v3215, label %v3216, label %v3217

v3216:
  %v3218 = load double, ptr %v133, align 8, !noalias !443
  %v3219 = load double, ptr %v912, align 8, !noalias !443
  %v3220 = fsub double %v3218, %v3219
  br i1 %v913, label %v3221, label %v3222

v3223:
  %v3224 = load double, ptr %v914, align 8, !noalias !443
  %v3225 = load double, ptr %v23, align 8, !noalias !443
  %v3226 = mul i64 %v3227, %v196
  %v3228 = getelementptr double, ptr %v193, i64 %v3226
  %v3229 = load double, ptr %v3228, align 8, !noalias !443
  %v3230 = tail call double @llvm.fabs.f64(double %v3229)
  %v3231 = fmul double %v3225, %v3230
  %v3232 = fadd double %v3224, %v3231
  %v3233 = add i64 %v3227, %v195
  %v3234 = mul i64 %v3233, %v196
  %v3235 = getelementptr double, ptr %v193, i64 %v3234
  %v3236 = load double, ptr %v3235, align 8, !noalias !443
  %v3237 = tail call double @llvm.fabs.f64(double %v3236)
  %v3238 = fmul double %v3220, %v3237
  %v3239 = fcmp ogt double %v3238, %v3232
  br label %v3240

v3240:
  %v3241 = phi i1 [ true, %v3222 ], [ %v3239, %v3223 ]
  %v3242 = icmp eq i64 %v10, %v3243
  br i1 %v3242, label %v3244, label %v3222

v3244:
  %v3245 = select i1 %v3241, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  br label %v3221

v3221:
  %v3246 = phi double [ 5.000000e-06, %v3216 ], [ %v3245, %v3244 ]
  %v3247 = load double, ptr %v916, align 8, !noalias !443
  %v3248 = load double, ptr %v92, align 8, !noalias !443
  %v3249 = fsub double %v3247, %v3248
  %v3250 = fmul double %v3246, %v3249
  %v3251 = fcmp olt double %v3220, %v3250
  br i1 %v3251, label %v3252, label %v3253

v3252:
  %v3254 = load i64, ptr %v918, align 8, !noalias !443
  %v3255 = add nsw i64 %v3254, 1
  br label %v3253

v3253:
  %v3256 = phi i64 [ %v3255, %v3252 ], [ 0, %v3221 ]
  store i64 %v3256, ptr %v920, align 8, !noalias !443
  %v3257 = load double, ptr %v133, align 8, !noalias !443
  store double %v3257, ptr %v912, align 8, !noalias !443
  store double 1.000000e+00, ptr %v922, align 8, !noalias !443
  store i64 2, ptr %v496, align 8, !noalias !443
  %v3258 = load i64, ptr %v920, align 8, !noalias !443
  %v3259 = icmp sgt i64 %v3258, 1000
  br i1 %v3259, label %v3260, label %v3217

v3260:
  %v3261 = load i64, ptr %v142, align 8, !noalias !447
  %v3262 = icmp sgt i64 %v3261, -1
  br i1 %v3262, label %v3263, label %v3217

v3263:
  %v3264 = getelementptr i64, ptr %v110, i64 %v3261
  %v3265 = load i64, ptr %v3264, align 8, !noalias !447
  %v3266 = icmp eq i64 %v3265, 0
  br i1 %v3266, label %v3267, label %v3217

v3267:
  store i64 6, ptr %v3264, align 8, !noalias !447
  br label %v3217

v3217:
  store double 0.000000e+00, ptr %v910, align 8, !noalias !443
  br label %v3191

v3195:
  %v3268 = phi i1 [ %v3209, %v3208 ], [ false, %v3194 ]
  %v3199 = phi i64 [ %v3211, %v3208 ], [ 0, %v3194 ]
  %v3211 = add nsw i64 %v3199, 1
  br i1 %v3268, label %v3208, label %v3197

v3222:
  %v3269 = phi i1 [ %v3241, %v3240 ], [ false, %v3216 ]
  %v3227 = phi i64 [ %v3243, %v3240 ], [ 0, %v3216 ]
  %v3243 = add nsw i64 %v3227, 1
  br i1 %v3269, label %v3240, label %v3223

v3191:
  %v3270 = and i1 %v923, %v1307
  %v3271 = xor i1 %v3270, true
  %v3272 = or i1 %v307, %v3271
  br i1 %v3272, label %v3273, label %v3274

v3275:
  %v3276 = getelementptr i64, ptr %v110, i64 %v3277
  %v3278 = load i64, ptr %v3276, align 8, !noalias !450
  %v3279 = icmp eq i64 %v3278, 0
  br i1 %v3279, label %v3280, label %v3281

v3280:
  %v3282 = getelementptr double, ptr %v926, i64 %v3283
  %v3284 = load double, ptr %v3282, align 8, !noalias !450
  %v3285 = fcmp olt double %v3284, 5.000000e-01
  br i1 %v3285, label %v3281, label %v3286

v3286:
  %v3287 = getelementptr double, ptr %v133, i64 %v3283
  %v3288 = load double, ptr %v3287, align 8, !noalias !450
  %v3289 = getelementptr double, ptr %v928, i64 %v3283
  %v3290 = load double, ptr %v3289, align 8, !noalias !450
  %v3291 = fcmp une double %v3288, %v3290
  %v3292 = select i1 %v3291, i1 true, i1 %v930
  %v3293 = xor i1 %v3291, true
  %v3294 = select i1 %v3293, i1 true, i1 %v3295
  br i1 %v3292, label %v3281, label %v3296

v3296:
  %v3297 = getelementptr i64, ptr %v929, i64 %v3283
  %v3298 = load i64, ptr %v3297, align 8, !noalias !455
  %v3299 = add nsw i64 %v3298, 1
  %v3300 = icmp slt i64 %v3298, -1
  %v3301 = select i1 %v3300, i64 %v77, i64 0
  %v3302 = add i64 %v3299, %v3301
  %v3303 = mul i64 %v3302, %v78
  %v3304 = getelementptr double, ptr %v76, i64 %v3303
  br label %v3305

v3305:
  %v3306 = phi i64 [ 0, %v3296 ], [ %v3307, %v3305 ]
  %v3307 = add nsw i64 %v3306, 1
  %v3308 = getelementptr double, ptr %v3304, i64 %v3306
  %v3309 = load double, ptr %v3308, align 8, !noalias !456
  %v3310 = getelementptr i64, ptr %v62, i64 %v3306
  %v3311 = load i64, ptr %v3310, align 8, !noalias !456
  %v3312 = mul nsw i64 %v3311, %v9
  %v3313 = add nsw i64 %v3312, %v3283
  %v3314 = icmp slt i64 %v3313, 0
  %v3315 = select i1 %v3314, i64 %v166, i64 0
  %v3316 = getelementptr double, ptr %v165, i64 %v3313
  %v3317 = getelementptr double, ptr %v3316, i64 %v3315
  store double %v3309, ptr %v3317, align 8, !noalias !456
  %v3318 = icmp eq i64 %v63, %v3307
  br i1 %v3318, label %v3281, label %v3305

v3281:
  %v3319 = phi i1 [ %v3294, %v3286 ], [ %v3295, %v3280 ], [ %v3295, %v3274 ], [ %v3295, %v3275 ], [ true, %v3305 ]
  %v3320 = icmp eq i64 %v9, %v3321
  br i1 %v3320, label %v3322, label %v3274

v3322:
  br i1 %v3319, label %v3323, label %v3273

v3323:
  %v3324 = load i64, ptr %v931, align 8, !noalias !460
  %v3325 = inttoptr i64 %v3324 to ptr
  tail call void %v3325(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !460
  %v3326 = load i64, ptr %v933, align 8, !noalias !455
  %v3327 = inttoptr i64 %v3326 to ptr
  tail call void %v3327(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v935), !noalias !455
  br label %v3328

v3328:
  %v3329 = phi i64 [ 0, %v3323 ], [ %v3330, %v3331 ]
  %v3332 = phi i64 [ %v937, %v3323 ], [ %v3333, %v3331 ]
  %v3334 = phi i64 [ 1, %v3323 ], [ %v3335, %v3331 ]
  %v3336 = icmp slt i64 %v3329, 0
  %v3337 = select i1 %v3336, i64 %v144, i64 0
  %v3338 = add i64 %v3337, %v3329
  %v3339 = getelementptr i64, ptr %v142, i64 %v3338
  %v3340 = load i64, ptr %v3339, align 8, !noalias !463
  %v3341 = icmp slt i64 %v3340, 0
  br i1 %v3341, label %v3331, label %v3342

v3342:
  %v3343 = getelementptr i64, ptr %v110, i64 %v3340
  %v3344 = load i64, ptr %v3343, align 8, !noalias !463
  %v3345 = icmp eq i64 %v3344, 0
  br i1 %v3345, label %v3346, label %v3331

v3346:
  %v3347 = select i1 %v3336, i64 %v135, i64 0
  %v3348 = add i64 %v3347, %v3329
  %v3349 = getelementptr double, ptr %v926, i64 %v3348
  %v3350 = load double, ptr %v3349, align 8, !noalias !463
  %v3351 = fcmp olt double %v3350, 5.000000e-01
  br i1 %v3351, label %v3331, label %v3352

v3352:
  %v3353 = getelementptr double, ptr %v133, i64 %v3348
  %v3354 = load double, ptr %v3353, align 8, !noalias !463
  %v3355 = getelementptr double, ptr %v928, i64 %v3348
  %v3356 = load double, ptr %v3355, align 8, !noalias !463
  %v3357 = fcmp une double %v3354, %v3356
  br i1 %v3357, label %v3331, label %v3358

v3358:
  %v3359 = getelementptr i64, ptr %v940, i64 %v3338
  %v3360 = load i64, ptr %v3359, align 8, !noalias !466
  %v3361 = icmp sgt i64 %v3360, 0
  br i1 %v3361, label %v3362, label %v3363

v3362:
  %v3364 = getelementptr double, ptr %v92, i64 %v3360
  %v3365 = getelementptr i8, ptr %v3364, i64 -8
  %v3366 = load double, ptr %v3365, align 8, !noalias !466
  %v3367 = getelementptr double, ptr %v133, i64 %v3329
  %v3368 = getelementptr double, ptr %v3367, i64 %v3347
  %v3369 = load double, ptr %v3368, align 8, !noalias !466
  %v3370 = fcmp oeq double %v3366, %v3369
  br label %v3363

v3363:
  %v3371 = phi i1 [ %v3370, %v3362 ], [ false, %v3358 ]
  br i1 %v942, label %v3372, label %v3373

v3373:
  %v3374 = mul i64 %v936, %v3340
  %v3375 = select i1 %v3336, i64 %v196, i64 0
  %v3376 = add i64 %v3375, %v3329
  %v3377 = getelementptr double, ptr %v943, i64 %v3376
  %v3378 = getelementptr double, ptr %v193, i64 %v3376
  %v3379 = add nsw i64 %v3360, -1
  %v3380 = select i1 %v3361, i64 0, i64 %v101
  %v3381 = add i64 %v3379, %v3380
  %v3382 = mul i64 %v3381, %v102
  %v3383 = getelementptr double, ptr %v99, i64 %v3374
  %v3384 = getelementptr double, ptr %v3383, i64 %v3382
  br label %v3385

v3386:
  %v3387 = getelementptr double, ptr %v3384, i64 %v3388
  store double %v3389, ptr %v3387, align 8, !noalias !466
  br label %v3390

v3390:
  %v3391 = icmp eq i64 %v10, %v3392
  br i1 %v3391, label %v3393, label %v3385

v3393:
  %v3394 = fcmp une double %v3395, 0.000000e+00
  br i1 %v3394, label %v3396, label %v3372

v3396:
  %v3397 = load i64, ptr %v3339, align 8, !noalias !470
  %v3398 = icmp sgt i64 %v3397, -1
  br i1 %v3398, label %v3399, label %v3372

v3399:
  %v3400 = getelementptr i64, ptr %v110, i64 %v3397
  %v3401 = load i64, ptr %v3400, align 8, !noalias !470
  %v3402 = icmp eq i64 %v3401, 0
  br i1 %v3402, label %v3403, label %v3372

v3403:
  store i64 3, ptr %v3400, align 8, !noalias !470
  br label %v3372

v3372:
  br i1 %v304, label %v3404, label %v3331

v3404:
  %v3405 = load double, ptr %v945, align 8, !noalias !473
  %v3406 = load double, ptr %v92, align 8, !noalias !473
  %v3407 = fsub double %v3405, %v3406
  %v3408 = fmul double %v3407, 1.000000e-13
  %v3409 = load double, ptr %v133, align 8, !noalias !473
  %v3410 = tail call double @llvm.fabs.f64(double %v3409)
  %v3411 = fmul double %v3410, 4.000000e-15
  %v3412 = fcmp ogt double %v3411, %v3408
  %v3413 = select i1 %v3412, double %v3411, double %v3408
  %v3414 = fadd double %v3409, %v3413
  store double %v3414, ptr %v947, align 8, !noalias !483
  %v3415 = load i64, ptr %v6, align 8, !noalias !484
  %v3416 = inttoptr i64 %v3415 to ptr
  tail call void %v3416(ptr nonnull %v133, ptr %v935, ptr %v165, ptr %v172, ptr %v179, ptr %v949), !noalias !484
  br i1 %v942, label %v3417, label %v3418

v3417:
  %v3419 = load i64, ptr %v954, align 8, !noalias !487
  %v3420 = inttoptr i64 %v3419 to ptr
  tail call void %v3420(ptr nonnull %v133, ptr %v956, ptr %v165, ptr %v172, ptr %v179, ptr %v958), !noalias !487
  %v3421 = load i64, ptr %v954, align 8, !noalias !490
  %v3422 = inttoptr i64 %v3421 to ptr
  tail call void %v3422(ptr nonnull %v947, ptr %v960, ptr %v165, ptr %v172, ptr %v179, ptr %v962), !noalias !490
  br label %v3423

v3423:
  %v3424 = phi i64 [ %v18, %v3417 ], [ %v3425, %v3426 ]
  %v3427 = phi i64 [ %v964, %v3417 ], [ %v3428, %v3426 ]
  %v3429 = icmp sgt i64 %v3427, 0
  br i1 %v3429, label %v3426, label %v3430

v3426:
  %v3428 = add nsw i64 %v3427, -1
  %v3425 = add i64 %v3424, 1
  %v3431 = icmp slt i64 %v3424, 0
  %v3432 = select i1 %v3431, i64 %v207, i64 0
  %v3433 = add i64 %v3432, %v3424
  %v3434 = getelementptr double, ptr %v968, i64 %v3433
  %v3435 = load double, ptr %v3434, align 8, !noalias !483
  %v3436 = getelementptr double, ptr %v971, i64 %v3433
  %v3437 = load double, ptr %v3436, align 8, !noalias !483
  %v3438 = fsub double %v3435, %v3437
  %v3439 = tail call double @llvm.fabs.f64(double %v3438)
  %v3440 = getelementptr double, ptr %v973, i64 %v3433
  %v3441 = load double, ptr %v3440, align 8, !noalias !483
  %v3442 = tail call i1 @llvm.is.fpclass.f64(double %v3441, i32 543)
  %v3443 = select i1 %v3442, double 0.000000e+00, double %v3441
  %v3444 = fcmp ueq double %v3439, 0x7FF0000000000000
  %v3445 = select i1 %v3444, double -0.000000e+00, double %v3439
  %v3446 = fadd double %v3443, %v3445
  %v3447 = getelementptr double, ptr %v970, i64 %v3433
  %v3448 = load double, ptr %v3447, align 8, !noalias !483
  %v3449 = fneg double %v3446
  %v3450 = fcmp olt double %v3448, %v3449
  br i1 %v3450, label %v3430, label %v3423

v3418:
  %v3451 = phi i64 [ %v3452, %v3418 ], [ 0, %v3404 ]
  %v3452 = add nsw i64 %v3451, 1
  %v3453 = mul i64 %v3451, %v196
  %v3454 = getelementptr double, ptr %v943, i64 %v3453
  %v3455 = load double, ptr %v3454, align 8, !noalias !483
  %v3456 = getelementptr double, ptr %v951, i64 %v3453
  %v3457 = load double, ptr %v3456, align 8, !noalias !483
  %v3458 = fmul double %v3413, %v3457
  %v3459 = fadd double %v3455, %v3458
  %v3460 = getelementptr double, ptr %v953, i64 %v3453
  store double %v3459, ptr %v3460, align 8, !noalias !483
  %v3461 = icmp eq i64 %v10, %v3452
  br i1 %v3461, label %v3417, label %v3418

v3462:
  %v3463 = getelementptr i64, ptr %v975, i64 %v3338
  store i64 %v3464, ptr %v3463, align 8, !noalias !493
  %v3465 = load i64, ptr %v3339, align 8, !noalias !494
  %v3466 = icmp sgt i64 %v3465, -1
  br i1 %v3466, label %v3467, label %v3468

v3467:
  %v3469 = getelementptr i64, ptr %v110, i64 %v3465
  %v3470 = load i64, ptr %v3469, align 8, !noalias !494
  %v3471 = icmp eq i64 %v3470, 0
  br i1 %v3471, label %v3472, label %v3468

v3472:
  store i64 4, ptr %v3469, align 8, !noalias !494
  br label %v3468

v3468:
  %v3473 = load double, ptr %v3353, align 8, !noalias !493
  store double %v3473, ptr %v3355, align 8, !noalias !493
  %v3474 = getelementptr double, ptr %v977, i64 %v3348
  store double 0.000000e+00, ptr %v3474, align 8, !noalias !493
  br label %v3331

v3430:
  %v3464 = phi i64 [ %v3424, %v3426 ], [ -1, %v3423 ]
  %v3475 = icmp sgt i64 %v3464, -1
  br i1 %v3475, label %v3462, label %v3331

v3385:
  %v3476 = phi double [ 0.000000e+00, %v3373 ], [ %v3395, %v3390 ]
  %v3388 = phi i64 [ 0, %v3373 ], [ %v3392, %v3390 ]
  %v3392 = add nsw i64 %v3388, 1
  %v3477 = mul i64 %v3388, %v196
  %v3478 = getelementptr double, ptr %v3377, i64 %v3477
  %v3389 = load double, ptr %v3478, align 8, !noalias !466
  %v3479 = fmul double %v3389, 0.000000e+00
  %v3395 = fadd double %v3476, %v3479
  %v3480 = getelementptr double, ptr %v3378, i64 %v3477
  store double %v3389, ptr %v3480, align 8, !noalias !466
  br i1 %v3371, label %v3386, label %v3390

v3331:
  %v3481 = icmp sgt i64 %v3332, 0
  %v3482 = zext i1 %v3481 to i64
  %v3335 = add i64 %v3334, %v3482
  %v3483 = sext i1 %v3481 to i64
  %v3333 = add nsw i64 %v3332, %v3483
  %v3330 = select i1 %v3481, i64 %v3334, i64 0
  br i1 %v3481, label %v3328, label %v3273

v3274:
  %v3295 = phi i1 [ %v3319, %v3281 ], [ false, %v3191 ]
  %v3283 = phi i64 [ %v3321, %v3281 ], [ 0, %v3191 ]
  %v3321 = add nsw i64 %v3283, 1
  %v3484 = getelementptr i64, ptr %v142, i64 %v3283
  %v3277 = load i64, ptr %v3484, align 8, !noalias !450
  %v3485 = icmp slt i64 %v3277, 0
  br i1 %v3485, label %v3281, label %v3275

v3273:
  %v3486 = xor i1 %v1307, true
  %v3487 = or i1 %v307, %v3486
  %v3488 = select i1 %v1307, i64 0, i64 %v1077
  br i1 %v3487, label %v1076, label %v3489

v3490:
  %v3491 = mul i64 %v3492, %v126
  %v3493 = getelementptr i64, ptr %v124, i64 %v3491
  %v3494 = load i64, ptr %v3493, align 8, !noalias !497
  %v3495 = getelementptr i8, ptr %v3493, i64 24
  %v3496 = load i64, ptr %v3495, align 8, !noalias !497
  %v3497 = add i64 %v3494, %v3496
  %v3498 = sub i64 %v298, %v3497
  %v3499 = icmp slt i64 %v3498, 1
  br i1 %v3499, label %v3500, label %v3501

v3500:
  %v3502 = getelementptr i64, ptr %v110, i64 %v3492
  %v3503 = load i64, ptr %v3502, align 8, !noalias !501
  %v3504 = icmp eq i64 %v3503, 0
  br i1 %v3504, label %v3505, label %v3501

v3505:
  store i64 5, ptr %v3502, align 8, !noalias !501
  br label %v3501

v3501:
  %v3506 = getelementptr double, ptr %v979, i64 %v3507
  %v3508 = load double, ptr %v3506, align 8, !noalias !497
  %v3509 = fcmp ogt double %v3508, 5.000000e-01
  br i1 %v3509, label %v3510, label %v3511

v3510:
  %v3512 = getelementptr double, ptr %v133, i64 %v3507
  %v3513 = load double, ptr %v3512, align 8, !noalias !497
  %v3514 = getelementptr double, ptr %v981, i64 %v3507
  %v3515 = load double, ptr %v3514, align 8, !noalias !497
  %v3516 = fcmp oeq double %v3513, %v3515
  br i1 %v3516, label %v3517, label %v3511

v3517:
  %v3518 = getelementptr i64, ptr %v982, i64 %v3507
  %v3519 = load i64, ptr %v3518, align 8, !noalias !504
  %v3520 = add nsw i64 %v3519, 1
  store i64 %v3520, ptr %v3518, align 8, !noalias !504
  %v3521 = icmp slt i64 %v3519, -1
  %v3522 = select i1 %v3521, i64 %v70, i64 0
  %v3523 = getelementptr double, ptr %v69, i64 %v3520
  %v3524 = getelementptr double, ptr %v3523, i64 %v3522
  %v3525 = load double, ptr %v3524, align 8, !noalias !504
  %v3526 = fcmp oeq double %v3525, 0x7FF0000000000000
  br i1 %v3526, label %v3527, label %v3528

v3527:
  %v3529 = load i64, ptr %v3530, align 8, !noalias !504
  %v3531 = icmp slt i64 %v3529, 0
  %v3532 = select i1 %v3531, i64 %v111, i64 0
  %v3533 = getelementptr i64, ptr %v110, i64 %v3529
  %v3534 = getelementptr i64, ptr %v3533, i64 %v3532
  %v3535 = load i64, ptr %v3534, align 8, !noalias !504
  %v3536 = icmp eq i64 %v3535, 0
  br i1 %v3536, label %v3537, label %v3511

v3537:
  store i64 1, ptr %v3534, align 8, !noalias !504
  br label %v3511

v3528:
  store double %v3525, ptr %v3514, align 8, !noalias !504
  %v3538 = select i1 %v3521, i64 %v86, i64 0
  %v3539 = getelementptr i64, ptr %v85, i64 %v3520
  %v3540 = getelementptr i64, ptr %v3539, i64 %v3538
  %v3541 = load i64, ptr %v3540, align 8, !noalias !504
  %v3542 = icmp eq i64 %v3541, 0
  br i1 %v3542, label %v3543, label %v3544

v3543:
  %v3545 = getelementptr double, ptr %v986, i64 %v3507
  store double 1.000000e+00, ptr %v3545, align 8, !noalias !504
  br label %v3546

v3544:
  %v3547 = getelementptr double, ptr %v984, i64 %v3507
  %v3548 = load double, ptr %v3547, align 8, !noalias !504
  %v3549 = fcmp olt double %v3548, 2.500000e-01
  %v3550 = select i1 %v3549, double 2.500000e-01, double %v3548
  store double %v3550, ptr %v3547, align 8, !noalias !504
  %v3551 = load i64, ptr %v496, align 8, !noalias !504
  %v3552 = tail call i64 @llvm.smax.i64(i64 %v3551, i64 1)
  br label %v3546

v3546:
  %v3553 = phi i64 [ %v3552, %v3544 ], [ 2, %v3543 ]
  store i64 %v3553, ptr %v496, align 8, !noalias !504
  br i1 %v987, label %v3511, label %v3554

v3554:
  %v3555 = select i1 %v3521, i64 %v77, i64 0
  %v3556 = add i64 %v3555, %v3520
  %v3557 = mul i64 %v3556, %v78
  %v3558 = getelementptr double, ptr %v76, i64 %v3557
  br label %v3559

v3559:
  %v3560 = phi i64 [ 0, %v3554 ], [ %v3561, %v3559 ]
  %v3561 = add nsw i64 %v3560, 1
  %v3562 = getelementptr double, ptr %v3558, i64 %v3560
  %v3563 = load double, ptr %v3562, align 8, !noalias !508
  %v3564 = getelementptr i64, ptr %v62, i64 %v3560
  %v3565 = load i64, ptr %v3564, align 8, !noalias !508
  %v3566 = mul nsw i64 %v3565, %v9
  %v3567 = add nsw i64 %v3566, %v3507
  %v3568 = icmp slt i64 %v3567, 0
  %v3569 = select i1 %v3568, i64 %v166, i64 0
  %v3570 = getelementptr double, ptr %v165, i64 %v3567
  %v3571 = getelementptr double, ptr %v3570, i64 %v3569
  store double %v3563, ptr %v3571, align 8, !noalias !508
  %v3572 = icmp eq i64 %v63, %v3561
  br i1 %v3572, label %v3511, label %v3559

v3511:
  %v3573 = getelementptr i64, ptr %v110, i64 %v3492
  %v3574 = load i64, ptr %v3573, align 8, !noalias !497
  %v3575 = icmp eq i64 %v3574, 0
  br i1 %v3575, label %v3576, label %v3577

v3577:
  %v3578 = getelementptr i64, ptr %v989, i64 %v3507
  %v3579 = load i64, ptr %v3578, align 8, !noalias !497
  %v3580 = getelementptr i64, ptr %v117, i64 %v3492
  store i64 %v3579, ptr %v3580, align 8, !noalias !497
  store i64 -1, ptr %v3530, align 8, !noalias !497
  %v3581 = getelementptr double, ptr %v991, i64 %v3507
  store double 0.000000e+00, ptr %v3581, align 8, !noalias !512
  %v3582 = load i64, ptr %v151, align 8, !noalias !512
  %v3583 = load i64, ptr %v992, align 8, !noalias !512
  %v3584 = icmp eq i64 %v3582, %v3583
  br i1 %v3584, label %v3585, label %v3586

v3586:
  %v3587 = add nsw i64 %v3582, 1
  store i64 %v3587, ptr %v151, align 8, !noalias !512
  store i64 2, ptr %v496, align 8, !noalias !512
  store i64 %v3582, ptr %v3530, align 8, !noalias !512
  %v3588 = icmp slt i64 %v3582, 0
  %v3589 = select i1 %v3588, i64 %v49, i64 0
  %v3590 = getelementptr i64, ptr %v48, i64 %v3582
  %v3591 = getelementptr i64, ptr %v3590, i64 %v3589
  %v3592 = load i64, ptr %v3591, align 8, !noalias !512
  %v3593 = icmp slt i64 %v3592, 0
  %v3594 = select i1 %v3593, i64 %v56, i64 0
  %v3595 = getelementptr i64, ptr %v55, i64 %v3592
  %v3596 = getelementptr i64, ptr %v3595, i64 %v3594
  %v3597 = load i64, ptr %v3596, align 8, !noalias !512
  %v3598 = getelementptr i64, ptr %v993, i64 %v3507
  store i64 %v3597, ptr %v3598, align 8, !noalias !512
  store i64 1, ptr %v3578, align 8, !noalias !512
  %v3599 = getelementptr i64, ptr %v995, i64 %v3507
  store i64 0, ptr %v3599, align 8, !noalias !512
  br i1 %v996, label %v3600, label %v3601

v3601:
  %v3602 = select i1 %v3588, i64 %v40, i64 0
  %v3603 = add i64 %v3602, %v3582
  %v3604 = mul i64 %v3603, %v41
  %v3605 = getelementptr double, ptr %v39, i64 %v3604
  %v3606 = getelementptr double, ptr %v165, i64 %v3507
  br label %v3607

v3600:
  br i1 %v997, label %v3608, label %v3609

v3609:
  %v3610 = load i64, ptr %v3598, align 8, !noalias !512
  %v3611 = icmp slt i64 %v3610, 0
  %v3612 = select i1 %v3611, i64 %v77, i64 0
  %v3613 = add i64 %v3612, %v3610
  %v3614 = mul i64 %v3613, %v78
  %v3615 = getelementptr double, ptr %v76, i64 %v3614
  br label %v3616

v3616:
  %v3617 = phi i64 [ 0, %v3609 ], [ %v3618, %v3616 ]
  %v3618 = add nsw i64 %v3617, 1
  %v3619 = getelementptr double, ptr %v3615, i64 %v3617
  %v3620 = load double, ptr %v3619, align 8, !noalias !515
  %v3621 = getelementptr i64, ptr %v62, i64 %v3617
  %v3622 = load i64, ptr %v3621, align 8, !noalias !515
  %v3623 = mul nsw i64 %v3622, %v9
  %v3624 = add nsw i64 %v3623, %v3507
  %v3625 = icmp slt i64 %v3624, 0
  %v3626 = select i1 %v3625, i64 %v166, i64 0
  %v3627 = getelementptr double, ptr %v165, i64 %v3624
  %v3628 = getelementptr double, ptr %v3627, i64 %v3626
  store double %v3620, ptr %v3628, align 8, !noalias !515
  %v3629 = icmp eq i64 %v3618, %v63
  br i1 %v3629, label %v3608, label %v3616

v3630:
  %v3631 = getelementptr double, ptr %v133, i64 %v3507
  %v3632 = getelementptr double, ptr %v1000, i64 %v3507
  %v3633 = load double, ptr %v3632, align 8, !noalias !519
  %v3634 = getelementptr double, ptr %v1002, i64 %v3507
  %v3635 = load double, ptr %v3634, align 8, !noalias !519
  %v3636 = getelementptr double, ptr %v1004, i64 %v3507
  %v3637 = load double, ptr %v3636, align 8, !noalias !519
  store double 0.000000e+00, ptr %v3631, align 8, !noalias !519
  %v3638 = getelementptr double, ptr %v3631, i64 %v135
  store double 0.000000e+00, ptr %v3638, align 8, !noalias !519
  %v3639 = getelementptr i8, ptr %v3631, i64 %v1005
  store double 0.000000e+00, ptr %v3639, align 8, !noalias !519
  %v3640 = getelementptr i8, ptr %v3631, i64 %v990
  store double 0.000000e+00, ptr %v3640, align 8, !noalias !519
  %v3641 = getelementptr i8, ptr %v3631, i64 %v1006
  store double 0.000000e+00, ptr %v3641, align 8, !noalias !519
  %v3642 = getelementptr i8, ptr %v3631, i64 %v978
  store double 0.000000e+00, ptr %v3642, align 8, !noalias !519
  %v3643 = getelementptr i8, ptr %v3631, i64 %v1007
  store double 0.000000e+00, ptr %v3643, align 8, !noalias !519
  %v3644 = getelementptr i8, ptr %v3631, i64 %v1008
  store double 0.000000e+00, ptr %v3644, align 8, !noalias !519
  %v3645 = getelementptr i8, ptr %v3631, i64 %v1009
  store double 0.000000e+00, ptr %v3645, align 8, !noalias !519
  %v3646 = getelementptr i8, ptr %v3631, i64 %v1010
  store double 0.000000e+00, ptr %v3646, align 8, !noalias !519
  %v3647 = getelementptr i8, ptr %v3631, i64 %v1011
  store double 0.000000e+00, ptr %v3647, align 8, !noalias !519
  %v3648 = getelementptr i8, ptr %v3631, i64 %v1012
  store double 0.000000e+00, ptr %v3648, align 8, !noalias !519
  %v3649 = getelementptr i8, ptr %v3631, i64 %v1013
  store double 0.000000e+00, ptr %v3649, align 8, !noalias !519
  %v3650 = getelementptr i8, ptr %v3631, i64 %v1014
  store double 0.000000e+00, ptr %v3650, align 8, !noalias !519
  %v3651 = getelementptr i8, ptr %v3631, i64 %v1015
  store double 0.000000e+00, ptr %v3651, align 8, !noalias !519
  %v3652 = getelementptr i8, ptr %v3631, i64 %v1016
  store double 0.000000e+00, ptr %v3652, align 8, !noalias !519
  %v3653 = getelementptr i8, ptr %v3631, i64 %v1017
  store double 0.000000e+00, ptr %v3653, align 8, !noalias !519
  %v3654 = getelementptr i8, ptr %v3631, i64 %v1018
  store double 0.000000e+00, ptr %v3654, align 8, !noalias !519
  %v3655 = getelementptr i8, ptr %v3631, i64 %v999
  store double 0.000000e+00, ptr %v3655, align 8, !noalias !519
  %v3656 = getelementptr i8, ptr %v3631, i64 %v1019
  store double 0.000000e+00, ptr %v3656, align 8, !noalias !519
  %v3657 = getelementptr i8, ptr %v3631, i64 %v1020
  store double 0.000000e+00, ptr %v3657, align 8, !noalias !519
  %v3658 = getelementptr i8, ptr %v3631, i64 %v1021
  store double 0.000000e+00, ptr %v3658, align 8, !noalias !519
  %v3659 = getelementptr i8, ptr %v3631, i64 %v1022
  store double 0.000000e+00, ptr %v3659, align 8, !noalias !519
  %v3660 = getelementptr i8, ptr %v3631, i64 %v1023
  store double 0.000000e+00, ptr %v3660, align 8, !noalias !519
  %v3661 = getelementptr i8, ptr %v3631, i64 %v1024
  store double 0.000000e+00, ptr %v3661, align 8, !noalias !519
  %v3662 = getelementptr i8, ptr %v3631, i64 %v1025
  store double 0.000000e+00, ptr %v3662, align 8, !noalias !519
  %v3663 = getelementptr i8, ptr %v3631, i64 %v1026
  store double 0.000000e+00, ptr %v3663, align 8, !noalias !519
  %v3664 = getelementptr i8, ptr %v3631, i64 %v1027
  store double 0.000000e+00, ptr %v3664, align 8, !noalias !519
  %v3665 = getelementptr i8, ptr %v3631, i64 %v1028
  store double 0.000000e+00, ptr %v3665, align 8, !noalias !519
  %v3666 = getelementptr i8, ptr %v3631, i64 %v1003
  store double 0.000000e+00, ptr %v3666, align 8, !noalias !519
  %v3667 = getelementptr i8, ptr %v3631, i64 %v1001
  store double 0.000000e+00, ptr %v3667, align 8, !noalias !519
  %v3668 = fcmp oeq double %v3637, 0xFFF0000000000000
  %v3669 = select i1 %v3668, double 0xFFF0000000000000, double 0.000000e+00
  store double %v3669, ptr %v3636, align 8, !noalias !519
  store double %v3635, ptr %v3634, align 8, !noalias !519
  store double %v3633, ptr %v3632, align 8, !noalias !519
  store double 1.000000e+00, ptr %v3581, align 8, !noalias !519
  %v3670 = getelementptr double, ptr %v1029, i64 %v3507
  store double 0xFFF0000000000000, ptr %v3670, align 8, !noalias !519
  %v3671 = getelementptr double, ptr %v1030, i64 %v3507
  store double 0x7FF0000000000000, ptr %v3671, align 8, !noalias !519
  %v3672 = load double, ptr %v92, align 8, !noalias !512
  store double %v3672, ptr %v3631, align 8, !noalias !512
  %v3673 = load i64, ptr %v3598, align 8, !noalias !512
  %v3674 = icmp slt i64 %v3673, 0
  %v3675 = select i1 %v3674, i64 %v70, i64 0
  %v3676 = getelementptr double, ptr %v69, i64 %v3673
  %v3677 = getelementptr double, ptr %v3676, i64 %v3675
  %v3678 = load double, ptr %v3677, align 8, !noalias !512
  %v3679 = getelementptr double, ptr %v1031, i64 %v3507
  store double %v3678, ptr %v3679, align 8, !noalias !512
  br label %v3585

v3607:
  %v3680 = phi i64 [ 0, %v3601 ], [ %v3681, %v3607 ]
  %v3681 = add nsw i64 %v3680, 1
  %v3682 = getelementptr double, ptr %v3605, i64 %v3680
  %v3683 = load double, ptr %v3682, align 8, !noalias !512
  %v3684 = mul nsw i64 %v3680, %v9
  %v3685 = getelementptr double, ptr %v3606, i64 %v3684
  store double %v3683, ptr %v3685, align 8, !noalias !512
  %v3686 = icmp eq i64 %v3681, %v41
  br i1 %v3686, label %v3600, label %v3607

v3608:
  br i1 %v998, label %v3630, label %v3687

v3687:
  %v3688 = getelementptr double, ptr %v193, i64 %v3507
  %v3689 = select i1 %v3588, i64 %v31, i64 0
  %v3690 = add i64 %v3689, %v3582
  %v3691 = mul i64 %v3690, %v32
  %v3692 = getelementptr double, ptr %v30, i64 %v3691
  br label %v3693

v3693:
  %v3694 = phi i64 [ 0, %v3687 ], [ %v3695, %v3693 ]
  %v3695 = add nsw i64 %v3694, 1
  %v3696 = getelementptr double, ptr %v3692, i64 %v3694
  %v3697 = load double, ptr %v3696, align 8, !noalias !512
  %v3698 = mul i64 %v3694, %v196
  %v3699 = getelementptr double, ptr %v3688, i64 %v3698
  store double %v3697, ptr %v3699, align 8, !noalias !512
  %v3700 = icmp eq i64 %v3695, %v10
  br i1 %v3700, label %v3630, label %v3693

v3576:
  %v3701 = getelementptr double, ptr %v1033, i64 %v3507
  %v3702 = load double, ptr %v3701, align 8, !noalias !497
  %v3703 = fcmp ult double %v3702, 1.500000e+01
  br i1 %v3703, label %v3585, label %v3704

v3704:
  %v3705 = load double, ptr %v1035, align 8, !noalias !497
  %v3706 = getelementptr double, ptr %v133, i64 %v3507
  %v3707 = load double, ptr %v3706, align 8, !noalias !497
  %v3708 = fsub double %v3705, %v3707
  %v3709 = getelementptr double, ptr %v1036, i64 %v3507
  %v3710 = load double, ptr %v3709, align 8, !noalias !497
  %v3711 = fmul double %v3710, 2.500000e+02
  %v3712 = fcmp ogt double %v3708, %v3711
  br i1 %v3712, label %v3585, label %v3713

v3713:
  store double 0.000000e+00, ptr %v3701, align 8, !noalias !497
  br label %v3585

v3585:
  %v3714 = phi i1 [ %v3715, %v3576 ], [ true, %v3704 ], [ %v3715, %v3713 ], [ %v3715, %v3577 ], [ %v3715, %v3630 ]
  %v3716 = load i64, ptr %v3530, align 8, !noalias !497
  %v3717 = icmp sgt i64 %v3716, -1
  br i1 %v3717, label %v3718, label %v3719

v3718:
  %v3720 = add nsw i64 %v3721, 1
  %v3722 = getelementptr double, ptr %v1038, i64 %v3507
  %v3723 = load double, ptr %v3722, align 8, !noalias !497
  %v3724 = fcmp ogt double %v3723, 0.000000e+00
  br i1 %v3724, label %v3725, label %v3726

v3726:
  %v3727 = mul i64 %v3716, %v126
  %v3728 = getelementptr i64, ptr %v124, i64 %v3727
  %v3729 = load i64, ptr %v3728, align 8, !noalias !497
  %v3730 = and i64 %v3729, 127
  %v3731 = sub nsw i64 128, %v3730
  %v3732 = tail call i64 @llvm.smin.i64(i64 %v3731, i64 %v3498)
  %v3733 = sitofp i64 %v3732 to double
  br label %v3725

v3725:
  %v3734 = phi double [ %v3733, %v3726 ], [ 1.000000e+00, %v3718 ]
  %v3735 = getelementptr double, ptr %v1040, i64 %v3507
  store double %v3734, ptr %v3735, align 8, !noalias !497
  %v3736 = getelementptr double, ptr %v1042, i64 %v3507
  %v3737 = load double, ptr %v3736, align 8, !noalias !523
  %v3738 = getelementptr double, ptr %v1044, i64 %v3507
  store double %v3737, ptr %v3738, align 8, !noalias !523
  %v3739 = getelementptr i64, ptr %v1046, i64 %v3507
  %v3740 = load i64, ptr %v3739, align 8, !noalias !523
  %v3741 = icmp slt i64 %v3740, %v93
  br i1 %v3741, label %v3742, label %v3719

v3742:
  %v3743 = icmp slt i64 %v3740, 0
  %v3744 = select i1 %v3743, i64 %v93, i64 0
  %v3745 = getelementptr double, ptr %v92, i64 %v3740
  %v3746 = getelementptr double, ptr %v3745, i64 %v3744
  %v3747 = load double, ptr %v3746, align 8, !noalias !523
  %v3748 = load double, ptr %v3736, align 8, !noalias !523
  %v3749 = fcmp olt double %v3748, %v3747
  %v3750 = select i1 %v3749, double %v3748, double %v3747
  store double %v3750, ptr %v3738, align 8, !noalias !523
  br label %v3719

v3719:
  %v3751 = phi i64 [ %v3721, %v3489 ], [ %v3721, %v3585 ], [ %v3720, %v3725 ], [ %v3720, %v3742 ]
  %v3752 = phi i1 [ %v3715, %v3489 ], [ %v3714, %v3585 ], [ %v3714, %v3725 ], [ %v3714, %v3742 ]
  %v3753 = icmp sgt i64 %v3754, 1
  br i1 %v3753, label %v3489, label %v3755

v3489:
  %v3715 = phi i1 [ %v3752, %v3719 ], [ false, %v3273 ]
  %v3721 = phi i64 [ %v3751, %v3719 ], [ 0, %v3273 ]
  %v3507 = phi i64 [ %v3756, %v3719 ], [ 0, %v3273 ]
  %v3754 = phi i64 [ %v3757, %v3719 ], [ %v308, %v3273 ]
  %v3757 = add nsw i64 %v3754, -1
  %v3756 = add nsw i64 %v3507, 1
  %v3530 = getelementptr i64, ptr %v142, i64 %v3507
  %v3492 = load i64, ptr %v3530, align 8, !noalias !497
  %v3758 = icmp slt i64 %v3492, 0
  br i1 %v3758, label %v3719, label %v3490

v1076:
  %v1075 = phi i64 [ %v1079, %v3273 ], [ %v3759, %v3755 ]
  %v1078 = phi i64 [ %v3488, %v3273 ], [ %v3751, %v3755 ]
  %v3760 = icmp sgt i64 %v1078, 0
  %v3761 = icmp sgt i64 %v1075, 0
  %v3762 = select i1 %v3760, i1 %v3761, i1 false
  br i1 %v3762, label %v1073, label %v495

v495:
  %v3763 = phi i64 [ %v490, %v309 ], [ %v1078, %v1076 ]
  br i1 %v307, label %v3764, label %v3765

v3765:
  %v3766 = mul i64 %v135, 192
  %v3767 = getelementptr i8, ptr %v133, i64 %v3766
  %v3768 = mul i64 %v135, 200
  %v3769 = getelementptr i8, ptr %v133, i64 %v3768
  %v3770 = add nsw i64 %v11, -1
  %v3771 = mul i64 %v135, 176
  %v3772 = getelementptr i8, ptr %v133, i64 %v3771
  br label %v3773

v3774:
  %v3775 = getelementptr double, ptr %v3767, i64 %v3776
  %v3777 = load double, ptr %v3775, align 8, !noalias !527
  %v3778 = fptosi double %v3777 to i64
  %v3779 = getelementptr double, ptr %v3769, i64 %v3776
  %v3780 = load double, ptr %v3779, align 8, !noalias !527
  %v3781 = fptosi double %v3780 to i64
  %v3782 = mul i64 %v3783, %v126
  %v3784 = getelementptr i64, ptr %v124, i64 %v3782
  %v3785 = load i64, ptr %v3784, align 8, !noalias !527
  %v3786 = add nsw i64 %v3785, %v3778
  store i64 %v3786, ptr %v3784, align 8, !noalias !527
  %v3787 = getelementptr i8, ptr %v3784, i64 24
  %v3788 = load i64, ptr %v3787, align 8, !noalias !527
  %v3789 = add nsw i64 %v3788, %v3781
  store i64 %v3789, ptr %v3787, align 8, !noalias !527
  %v3790 = getelementptr i8, ptr %v3784, i64 8
  %v3791 = load i64, ptr %v3790, align 8, !noalias !527
  %v3792 = add nsw i64 %v3781, %v3778
  %v3793 = mul nsw i64 %v3792, %v3770
  %v3794 = add nsw i64 %v3793, %v3778
  %v3795 = add nsw i64 %v3794, %v3791
  store i64 %v3795, ptr %v3790, align 8, !noalias !527
  store double 0.000000e+00, ptr %v3775, align 8, !noalias !527
  store double 0.000000e+00, ptr %v3779, align 8, !noalias !527
  %v3796 = getelementptr double, ptr %v3772, i64 %v3776
  %v3797 = load double, ptr %v3796, align 8, !noalias !527
  %v3798 = sitofp i64 %v3792 to double
  %v3799 = fsub double %v3797, %v3798
  store double %v3799, ptr %v3796, align 8, !noalias !527
  br label %v3800

v3800:
  %v3801 = icmp sgt i64 %v3802, 1
  br i1 %v3801, label %v3773, label %v3764

v3773:
  %v3776 = phi i64 [ 0, %v3765 ], [ %v3803, %v3800 ]
  %v3802 = phi i64 [ %v308, %v3765 ], [ %v3804, %v3800 ]
  %v3804 = add nsw i64 %v3802, -1
  %v3803 = add nsw i64 %v3776, 1
  %v3805 = getelementptr i64, ptr %v142, i64 %v3776
  %v3783 = load i64, ptr %v3805, align 8, !noalias !527
  %v3806 = icmp sgt i64 %v3783, -1
  br i1 %v3806, label %v3774, label %v3800

v3807:
  %v3808 = phi i32 [ 0, %v3764 ], [ %v3058, %v3060 ]
  ret i32 %v3808

v357:
  %v487 = phi i64 [ 0, %v310 ], [ %v486, %v364 ]
  %v489 = phi i64 [ %v308, %v310 ], [ %v3809, %v364 ]
  %v360 = phi i64 [ 0, %v310 ], [ %v3810, %v364 ]
  %v3809 = add nsw i64 %v489, -1
  %v3810 = add nsw i64 %v360, 1
  %v483 = getelementptr i64, ptr %v142, i64 %v360
  %v3811 = load i64, ptr %v483, align 8
  %v3812 = icmp slt i64 %v3811, 0
  br i1 %v3812, label %v358, label %v364

v1285:
  %v3813 = load i64, ptr %v6, align 8, !noalias !531
  %v3814 = inttoptr i64 %v3813 to ptr
  tail call void %v3814(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v579), !noalias !531
  br label %v1286

v1286:
  br i1 %v580, label %v3815, label %v3816

v3815:
  %v3817 = load double, ptr %v582, align 8, !noalias !534
  %v3818 = fcmp olt double %v3817, 5.000000e-01
  br i1 %v3818, label %v3819, label %v3820

v3819:
  br i1 %v583, label %v3821, label %v3822

v3821:
  br i1 %v595, label %v3823, label %v3824, !prof !397

v3825:
  %v3826 = icmp eq i64 %v3827, %v628
  br i1 %v3826, label %v3820, label %v3828

v3829:
  %v3830 = load i64, ptr %v605, align 8, !noalias !538
  %v3831 = icmp eq i64 %v3830, %v3827
  br i1 %v3831, label %v3832, label %v3833

v3832:
  %v3834 = load double, ptr %v607, align 8, !noalias !538
  %v3835 = fmul double %v3834, 1.000000e-03
  br label %v3833

v3833:
  %v3836 = phi double [ %v3835, %v3832 ], [ 0.000000e+00, %v3829 ]
  store double %v3836, ptr %v3837, align 8, !noalias !538
  br i1 %v583, label %v3838, label %v3839

v3840:
  %v3841 = phi i64 [ %v3842, %v3840 ], [ 0, %v3828 ]
  %v3842 = add nsw i64 %v3841, 1
  %v3843 = mul i64 %v3841, %v196
  %v3844 = getelementptr double, ptr %v193, i64 %v3843
  %v3845 = load double, ptr %v3844, align 8, !noalias !538
  %v3846 = tail call double @llvm.fabs.f64(double %v3845)
  %v3847 = fcmp ogt double %v3848, %v3846
  %v3849 = select i1 %v3847, double %v3848, double %v3846
  %v3850 = fcmp ogt double %v3849, 0.000000e+00
  %v3851 = fmul double %v3849, 1.200000e-05
  %v3852 = select i1 %v3850, double %v3851, double 1.200000e-05
  %v3853 = getelementptr i64, ptr %v266, i64 %v3841
  %v3854 = load i64, ptr %v3853, align 8, !noalias !538
  %v3855 = icmp eq i64 %v3854, %v3827
  %v3856 = select i1 %v3855, double %v3852, double 0.000000e+00
  %v3857 = getelementptr double, ptr %v3858, i64 %v3841
  store double %v3856, ptr %v3857, align 8, !noalias !538
  %v3859 = icmp eq i64 %v10, %v3842
  br i1 %v3859, label %v3829, label %v3840

v3860:
  %v3861 = getelementptr double, ptr %v621, i64 %v3862
  store double %v3863, ptr %v3861, align 8, !noalias !544
  br label %v3864

v3865:
  %v3866 = select i1 %v3867, i64 %v295, i64 0
  %v3868 = getelementptr i64, ptr %v294, i64 %v3869
  %v3870 = getelementptr i64, ptr %v3868, i64 %v3866
  %v3871 = load i64, ptr %v3870, align 8, !noalias !544
  %v3872 = icmp slt i64 %v3871, 0
  %v3873 = select i1 %v3872, i64 %v223, i64 0
  %v3874 = getelementptr double, ptr %v222, i64 %v3871
  %v3875 = getelementptr double, ptr %v3874, i64 %v3873
  store double %v3863, ptr %v3875, align 8, !noalias !544
  br label %v3864

v3864:
  %v3876 = icmp sgt i64 %v3877, 1
  br i1 %v3876, label %v3878, label %v3825

v3822:
  %v3879 = phi i64 [ %v3880, %v3822 ], [ 0, %v3819 ]
  %v3880 = add nsw i64 %v3879, 1
  %v3881 = mul i64 %v3879, %v196
  %v3882 = getelementptr double, ptr %v193, i64 %v3881
  %v3883 = load double, ptr %v3882, align 8, !noalias !544
  %v3884 = getelementptr double, ptr %v586, i64 %v3881
  store double %v3883, ptr %v3884, align 8, !noalias !544
  %v3885 = getelementptr double, ptr %v588, i64 %v3881
  store double 0.000000e+00, ptr %v3885, align 8, !noalias !544
  %v3886 = icmp eq i64 %v10, %v3880
  br i1 %v3886, label %v3821, label %v3822

v3887:
  %v3888 = phi i64 [ %v159, %v3889 ], [ %v3890, %v3891 ]
  %v3892 = sub i64 %v3888, %v3893
  %v3894 = tail call i64 @llvm.smax.i64(i64 %v3892, i64 0)
  %v3858 = getelementptr double, ptr %v158, i64 %v3893
  br i1 %v600, label %v3895, label %v3820

v3895:
  %v3896 = select i1 %v592, i64 %v3894, i64 0
  %v3897 = getelementptr double, ptr %v3858, i64 %v10
  %v3837 = getelementptr double, ptr %v3897, i64 %v3896
  br label %v3828

v3823:
  br label %v3824

v3824:
  %v3898 = phi i64 [ 0, %v3823 ], [ %v594, %v3821 ]
  br i1 %v596, label %v3899, label %v3900, !prof !131

v3900:
  br label %v3899

v3899:
  %v3893 = phi i64 [ %v159, %v3900 ], [ %v3898, %v3824 ]
  br i1 %v598, label %v3901, label %v3891, !prof !397

v3901:
  br label %v3891

v3891:
  %v3890 = phi i64 [ 0, %v3901 ], [ %v597, %v3899 ]
  br i1 %v599, label %v3887, label %v3889, !prof !131

v3889:
  br label %v3887

v3828:
  %v3827 = phi i64 [ 0, %v3895 ], [ %v3902, %v3825 ]
  %v3902 = add nsw i64 %v3827, 1
  %v3903 = load double, ptr %v602, align 8, !noalias !538
  %v3904 = load double, ptr %v23, align 8, !noalias !538
  %v3848 = fdiv double %v3903, %v3904
  br i1 %v583, label %v3829, label %v3840

v3905:
  %v3906 = load double, ptr %v133, align 8, !noalias !545
  %v3907 = load double, ptr %v3837, align 8, !noalias !545
  %v3908 = fmul double %v3907, 5.000000e-01
  %v3909 = fadd double %v3906, %v3908
  store double %v3909, ptr %v610, align 8, !noalias !545
  %v3910 = load i64, ptr %v6, align 8, !noalias !549
  %v3911 = inttoptr i64 %v3910 to ptr
  tail call void %v3911(ptr nonnull %v610, ptr %v613, ptr %v165, ptr %v172, ptr %v179, ptr %v623), !noalias !549
  br label %v3912

v3912:
  %v3913 = phi i64 [ %v3914, %v3912 ], [ 0, %v3905 ]
  %v3914 = add nsw i64 %v3913, 1
  %v3915 = mul i64 %v3913, %v196
  %v3916 = getelementptr double, ptr %v193, i64 %v3915
  %v3917 = load double, ptr %v3916, align 8, !noalias !545
  %v3918 = getelementptr double, ptr %v3858, i64 %v3913
  %v3919 = load double, ptr %v3918, align 8, !noalias !545
  %v3920 = fmul double %v3919, 5.000000e-01
  %v3921 = fsub double %v3917, %v3920
  %v3922 = getelementptr double, ptr %v614, i64 %v3915
  store double %v3921, ptr %v3922, align 8, !noalias !545
  %v3923 = icmp eq i64 %v10, %v3914
  br i1 %v3923, label %v3924, label %v3912

v3838:
  %v3925 = load double, ptr %v133, align 8, !noalias !545
  %v3926 = fmul double %v3836, 5.000000e-01
  %v3927 = fadd double %v3926, %v3925
  store double %v3927, ptr %v610, align 8, !noalias !545
  %v3928 = load i64, ptr %v6, align 8, !noalias !549
  %v3929 = inttoptr i64 %v3928 to ptr
  tail call void %v3929(ptr nonnull %v610, ptr %v613, ptr %v165, ptr %v172, ptr %v179, ptr %v625), !noalias !549
  br label %v3924

v3924:
  %v3930 = load double, ptr %v133, align 8, !noalias !545
  %v3931 = load double, ptr %v3837, align 8, !noalias !545
  %v3932 = fmul double %v3931, 5.000000e-01
  %v3933 = fsub double %v3930, %v3932
  store double %v3933, ptr %v610, align 8, !noalias !545
  %v3934 = load i64, ptr %v6, align 8, !noalias !549
  %v3935 = inttoptr i64 %v3934 to ptr
  tail call void %v3935(ptr nonnull %v610, ptr %v613, ptr %v165, ptr %v172, ptr %v179, ptr %v627), !noalias !549
  br i1 %v583, label %v3936, label %v3937

v3938:
  %v3939 = fsub double %v3940, %v3941
  br label %v3942

v3943:
  %v3944 = getelementptr double, ptr %v619, i64 %v3945
  %v3946 = load double, ptr %v3944, align 8, !noalias !545
  %v3947 = fsub double %v3940, %v3946
  %v3948 = fmul double %v3947, 2.000000e+00
  br label %v3942

v3942:
  %v3949 = phi double [ %v3948, %v3943 ], [ %v3939, %v3938 ]
  store double %v3949, ptr %v3950, align 8, !noalias !545
  %v3951 = icmp eq i64 %v10, %v3952
  br i1 %v3951, label %v3936, label %v3937

v3839:
  %v3953 = phi i64 [ %v3954, %v3839 ], [ 0, %v3833 ]
  %v3954 = add nsw i64 %v3953, 1
  %v3955 = mul i64 %v3953, %v196
  %v3956 = getelementptr double, ptr %v193, i64 %v3955
  %v3957 = load double, ptr %v3956, align 8, !noalias !545
  %v3958 = getelementptr double, ptr %v3858, i64 %v3953
  %v3959 = load double, ptr %v3958, align 8, !noalias !545
  %v3960 = fmul double %v3959, 5.000000e-01
  %v3961 = fadd double %v3957, %v3960
  %v3962 = getelementptr double, ptr %v614, i64 %v3955
  store double %v3961, ptr %v3962, align 8, !noalias !545
  %v3963 = icmp eq i64 %v10, %v3954
  br i1 %v3963, label %v3905, label %v3839

v3937:
  %v3964 = phi i64 [ %v3952, %v3942 ], [ 0, %v3924 ]
  %v3952 = add nsw i64 %v3964, 1
  %v3945 = mul i64 %v3964, %v196
  %v3965 = getelementptr double, ptr %v193, i64 %v3945
  %v3966 = load double, ptr %v3965, align 8, !noalias !545
  %v3967 = getelementptr double, ptr %v614, i64 %v3945
  store double %v3966, ptr %v3967, align 8, !noalias !545
  %v3950 = getelementptr double, ptr %v616, i64 %v3945
  %v3940 = load double, ptr %v3950, align 8, !noalias !545
  %v3968 = getelementptr double, ptr %v618, i64 %v3945
  %v3941 = load double, ptr %v3968, align 8, !noalias !545
  %v3969 = fsub double %v3941, %v3941
  %v3970 = fcmp oeq double %v3969, 0.000000e+00
  br i1 %v3970, label %v3938, label %v3943

v3936:
  %v3971 = getelementptr i64, ptr %v273, i64 %v3827
  %v3972 = load i64, ptr %v3971, align 8, !noalias !544
  %v3973 = getelementptr i8, ptr %v3971, i64 8
  %v3974 = load i64, ptr %v3973, align 8, !noalias !544
  %v3975 = sub i64 %v3974, %v3972
  %v3976 = icmp slt i64 %v3975, 1
  br i1 %v3976, label %v3825, label %v3878

v3878:
  %v3877 = phi i64 [ %v3977, %v3864 ], [ %v3975, %v3936 ]
  %v3869 = phi i64 [ %v3978, %v3864 ], [ %v3972, %v3936 ]
  %v3977 = add nsw i64 %v3877, -1
  %v3978 = add i64 %v3869, 1
  %v3867 = icmp slt i64 %v3869, 0
  %v3979 = select i1 %v3867, i64 %v281, i64 0
  %v3980 = getelementptr i64, ptr %v280, i64 %v3869
  %v3981 = getelementptr i64, ptr %v3980, i64 %v3979
  %v3982 = load i64, ptr %v3981, align 8, !noalias !544
  %v3983 = select i1 %v3867, i64 %v288, i64 0
  %v3984 = getelementptr i64, ptr %v287, i64 %v3869
  %v3985 = getelementptr i64, ptr %v3984, i64 %v3983
  %v3986 = load i64, ptr %v3985, align 8, !noalias !544
  %v3987 = icmp slt i64 %v3982, 0
  %v3988 = select i1 %v3987, i64 %v195, i64 0
  %v3989 = add i64 %v3988, %v3982
  %v3862 = mul i64 %v3989, %v196
  %v3990 = getelementptr double, ptr %v616, i64 %v3862
  %v3991 = load double, ptr %v3990, align 8, !noalias !544
  %v3992 = icmp slt i64 %v3986, 0
  %v3993 = select i1 %v3992, i64 %v3894, i64 0
  %v3994 = getelementptr double, ptr %v3858, i64 %v3986
  %v3995 = getelementptr double, ptr %v3994, i64 %v3993
  %v3996 = load double, ptr %v3995, align 8, !noalias !544
  %v3997 = fdiv double %v3991, %v3996
  %v3998 = fsub double %v3997, %v3997
  %v3999 = fcmp oeq double %v3998, 0.000000e+00
  %v3863 = select i1 %v3999, double %v3997, double 0.000000e+00
  %v4000 = icmp eq i64 %v3986, %v10
  br i1 %v4000, label %v3860, label %v3865

v3820:
  br i1 %v629, label %v4001, label %v3816

v4002:
  %v4003 = mul i64 %v4004, %v632
  %v4005 = icmp slt i64 %v4003, 0
  %v4006 = select i1 %v4005, i64 %v230, i64 0
  %v4007 = getelementptr double, ptr %v229, i64 %v4003
  %v4008 = getelementptr double, ptr %v4007, i64 %v4006
  %v4009 = load double, ptr %v4008, align 8, !noalias !534
  %v4010 = load double, ptr %v634, align 8, !noalias !534
  %v4011 = fadd double %v4009, %v4010
  store double %v4011, ptr %v4008, align 8, !noalias !534
  %v4012 = icmp eq i64 %v10, %v4013
  br i1 %v4012, label %v4014, label %v4001

v4015:
  %v4016 = icmp eq i64 %v4017, %v10
  br i1 %v4016, label %v3816, label %v4014

v4018:
  %v4019 = phi i64 [ %v4020, %v4014 ], [ %v4021, %v4022 ]
  %v4023 = getelementptr i64, ptr %v236, i64 %v4020
  store i64 %v4019, ptr %v4023, align 8, !noalias !552
  %v4024 = add nsw i64 %v4019, %v4025
  %v4026 = icmp slt i64 %v4024, 0
  %v4027 = select i1 %v4026, i64 %v230, i64 0
  %v4028 = getelementptr double, ptr %v229, i64 %v4024
  %v4029 = getelementptr double, ptr %v4028, i64 %v4027
  %v4030 = load double, ptr %v4029, align 8, !noalias !552
  %v4031 = load double, ptr %v4032, align 8, !noalias !552
  store double %v4030, ptr %v4032, align 8, !noalias !552
  store double %v4031, ptr %v4029, align 8, !noalias !552
  br i1 %v4033, label %v4034, label %v4035

v4034:
  %v4036 = sub i64 %v4037, %v4017
  %v4038 = icmp slt i64 %v4036, 1
  br i1 %v4038, label %v4015, label %v4039

v4040:
  %v4041 = icmp sgt i64 %v4042, 1
  br i1 %v4041, label %v4039, label %v4015

v4014:
  %v4020 = phi i64 [ %v4017, %v4015 ], [ 0, %v4002 ]
  %v4017 = add nsw i64 %v4020, 1
  %v4025 = mul nsw i64 %v4020, %v10
  %v4043 = add nsw i64 %v4020, %v253
  %v4044 = add nsw i64 %v4043, 1
  %v4045 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %v4044, i64 %v10)
  %v4046 = add i64 %v635, %v4043
  %v4037 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %v4046, i64 %v10)
  %v4047 = getelementptr double, ptr %v229, i64 %v4025
  %v4032 = getelementptr double, ptr %v4047, i64 %v4020
  %v4048 = sub i64 %v4045, %v4017
  %v4049 = tail call i64 @llvm.smax.i64(i64 %v4048, i64 0)
  %v4033 = icmp slt i64 %v4048, 1
  br i1 %v4033, label %v4018, label %v4050

v4050:
  %v4051 = load double, ptr %v4032, align 8, !noalias !552
  %v4052 = tail call double @llvm.fabs.f64(double %v4051)
  br label %v4022

v4022:
  %v4053 = phi i64 [ %v4021, %v4022 ], [ %v4020, %v4050 ]
  %v4054 = phi double [ %v4055, %v4022 ], [ %v4052, %v4050 ]
  %v4056 = phi i64 [ %v4057, %v4022 ], [ %v4049, %v4050 ]
  %v4058 = phi i64 [ %v4059, %v4022 ], [ %v4017, %v4050 ]
  %v4057 = add nsw i64 %v4056, -1
  %v4059 = add i64 %v4058, 1
  %v4060 = add nsw i64 %v4058, %v4025
  %v4061 = icmp slt i64 %v4060, 0
  %v4062 = select i1 %v4061, i64 %v230, i64 0
  %v4063 = getelementptr double, ptr %v229, i64 %v4060
  %v4064 = getelementptr double, ptr %v4063, i64 %v4062
  %v4065 = load double, ptr %v4064, align 8, !noalias !552
  %v4066 = tail call double @llvm.fabs.f64(double %v4065)
  %v4067 = fcmp ogt double %v4066, %v4054
  %v4055 = select i1 %v4067, double %v4066, double %v4054
  %v4021 = select i1 %v4067, i64 %v4058, i64 %v4053
  %v4068 = icmp sgt i64 %v4056, 1
  br i1 %v4068, label %v4022, label %v4018

v4035:
  %v4069 = phi i64 [ %v4070, %v4035 ], [ %v4049, %v4018 ]
  %v4071 = phi i64 [ %v4072, %v4035 ], [ %v4017, %v4018 ]
  %v4070 = add nsw i64 %v4069, -1
  %v4072 = add i64 %v4071, 1
  %v4073 = add nsw i64 %v4071, %v4025
  %v4074 = icmp slt i64 %v4073, 0
  %v4075 = select i1 %v4074, i64 %v230, i64 0
  %v4076 = getelementptr double, ptr %v229, i64 %v4073
  %v4077 = getelementptr double, ptr %v4076, i64 %v4075
  %v4078 = load double, ptr %v4077, align 8, !noalias !552
  %v4079 = load double, ptr %v4032, align 8, !noalias !552
  %v4080 = fdiv double %v4078, %v4079
  store double %v4080, ptr %v4077, align 8, !noalias !552
  %v4081 = icmp sgt i64 %v4069, 1
  br i1 %v4081, label %v4035, label %v4034

v4039:
  %v4042 = phi i64 [ %v4082, %v4040 ], [ %v4036, %v4034 ]
  %v4083 = phi i64 [ %v4084, %v4040 ], [ %v4017, %v4034 ]
  %v4082 = add nsw i64 %v4042, -1
  %v4084 = add i64 %v4083, 1
  %v4085 = mul nsw i64 %v4083, %v10
  %v4086 = add nsw i64 %v4085, %v4019
  %v4087 = icmp slt i64 %v4086, 0
  %v4088 = select i1 %v4087, i64 %v230, i64 0
  %v4089 = getelementptr double, ptr %v229, i64 %v4086
  %v4090 = getelementptr double, ptr %v4089, i64 %v4088
  %v4091 = load double, ptr %v4090, align 8, !noalias !552
  %v4092 = add nsw i64 %v4085, %v4020
  %v4093 = icmp slt i64 %v4092, 0
  %v4094 = select i1 %v4093, i64 %v230, i64 0
  %v4095 = getelementptr double, ptr %v229, i64 %v4092
  %v4096 = getelementptr double, ptr %v4095, i64 %v4094
  %v4097 = load double, ptr %v4096, align 8, !noalias !552
  store double %v4097, ptr %v4090, align 8, !noalias !552
  store double %v4091, ptr %v4096, align 8, !noalias !552
  %v4098 = fcmp oeq double %v4091, 0.000000e+00
  %v4099 = or i1 %v4033, %v4098
  br i1 %v4099, label %v4040, label %v4100

v4100:
  %v4101 = phi i64 [ %v4102, %v4100 ], [ %v4049, %v4039 ]
  %v4103 = phi i64 [ %v4104, %v4100 ], [ %v4017, %v4039 ]
  %v4102 = add nsw i64 %v4101, -1
  %v4104 = add i64 %v4103, 1
  %v4105 = add nsw i64 %v4103, %v4085
  %v4106 = icmp slt i64 %v4105, 0
  %v4107 = select i1 %v4106, i64 %v230, i64 0
  %v4108 = getelementptr double, ptr %v229, i64 %v4105
  %v4109 = getelementptr double, ptr %v4108, i64 %v4107
  %v4110 = load double, ptr %v4109, align 8, !noalias !552
  %v4111 = add nsw i64 %v4103, %v4025
  %v4112 = icmp slt i64 %v4111, 0
  %v4113 = select i1 %v4112, i64 %v230, i64 0
  %v4114 = getelementptr double, ptr %v229, i64 %v4111
  %v4115 = getelementptr double, ptr %v4114, i64 %v4113
  %v4116 = load double, ptr %v4115, align 8, !noalias !552
  %v4117 = fmul double %v4091, %v4116
  %v4118 = fsub double %v4110, %v4117
  store double %v4118, ptr %v4109, align 8, !noalias !552
  %v4119 = icmp sgt i64 %v4101, 1
  br i1 %v4119, label %v4100, label %v4040

v4001:
  %v4004 = phi i64 [ %v4013, %v4002 ], [ 0, %v3820 ]
  %v4013 = add nsw i64 %v4004, 1
  %v4120 = sub i64 %v4004, %v630
  %v4121 = tail call i64 @llvm.smax.i64(i64 %v4120, i64 0)
  %v4122 = add i64 %v631, %v4004
  %v4123 = tail call i64 @llvm.smin.i64(i64 %v4122, i64 %v10)
  %v4124 = sub i64 %v4123, %v4121
  %v4125 = icmp slt i64 %v4124, 1
  br i1 %v4125, label %v4002, label %v4126

v4126:
  %v4127 = mul nsw i64 %v4004, %v10
  br label %v4128

v4128:
  %v4129 = phi i64 [ %v4124, %v4126 ], [ %v4130, %v4128 ]
  %v4131 = phi i64 [ %v4121, %v4126 ], [ %v4132, %v4128 ]
  %v4130 = add nsw i64 %v4129, -1
  %v4132 = add i64 %v4131, 1
  %v4133 = add nsw i64 %v4131, %v4127
  %v4134 = icmp slt i64 %v4133, 0
  %v4135 = select i1 %v4134, i64 %v223, i64 0
  %v4136 = getelementptr double, ptr %v222, i64 %v4133
  %v4137 = getelementptr double, ptr %v4136, i64 %v4135
  %v4138 = load double, ptr %v4137, align 8, !noalias !534
  %v4139 = fneg double %v4138
  %v4140 = select i1 %v4134, i64 %v230, i64 0
  %v4141 = getelementptr double, ptr %v229, i64 %v4133
  %v4142 = getelementptr double, ptr %v4141, i64 %v4140
  store double %v4139, ptr %v4142, align 8, !noalias !534
  %v4143 = icmp sgt i64 %v4129, 1
  br i1 %v4143, label %v4128, label %v4002

v3816:
  br i1 %v639, label %v1306, label %v4144

v4145:
  br i1 %v645, label %v4146, label %v4147

v4147:
  %v4148 = mul i64 %v4149, %v646
  %v4150 = getelementptr double, ptr %v193, i64 %v4148
  br label %v4151

v4152:
  %v4153 = icmp slt i64 %v4154, 0
  %v4155 = select i1 %v4153, i64 %v251, i64 0
  %v4156 = getelementptr i64, ptr %v250, i64 %v4154
  %v4157 = getelementptr i64, ptr %v4156, i64 %v4155
  store i64 %v4158, ptr %v4157, align 8, !noalias !555
  %v4159 = add nsw i64 %v4154, 1
  br label %v4160

v4160:
  %v4161 = phi i64 [ %v4159, %v4152 ], [ %v4154, %v4162 ]
  %v4163 = icmp eq i64 %v10, %v4164
  br i1 %v4163, label %v4146, label %v4162

v4146:
  %v4165 = phi i64 [ 0, %v4145 ], [ %v4161, %v4160 ]
  %v4166 = icmp sgt i64 %v4165, 0
  %v4167 = icmp slt i64 %v4165, %v10
  %v4168 = and i1 %v4166, %v4167
  br i1 %v4168, label %v4169, label %v4170

v4169:
  %v4171 = phi i64 [ %v4172, %v4173 ], [ %v4165, %v4146 ]
  %v4174 = phi i64 [ %v4175, %v4173 ], [ 0, %v4146 ]
  %v4176 = getelementptr i64, ptr %v250, i64 %v4174
  %v4177 = load i64, ptr %v4176, align 8, !noalias !555
  %v4175 = add nsw i64 %v4174, 1
  %v4178 = sub nsw i64 %v4177, %v254
  %v4179 = tail call i64 @llvm.smax.i64(i64 %v4178, i64 0)
  %v4180 = add i64 %v653, %v4177
  %v4181 = tail call i64 @llvm.smin.i64(i64 %v4180, i64 %v10)
  %v4182 = sub i64 %v4181, %v4179
  %v4183 = icmp slt i64 %v4182, 1
  br i1 %v4183, label %v4173, label %v4184

v4184:
  %v4185 = mul nsw i64 %v4177, %v10
  br label %v4186

v4187:
  %v4188 = icmp slt i64 %v4189, 0
  %v4190 = select i1 %v4188, i64 %v244, i64 0
  %v4191 = getelementptr i64, ptr %v243, i64 %v4189
  %v4192 = getelementptr i64, ptr %v4191, i64 %v4190
  %v4193 = load i64, ptr %v4192, align 8, !noalias !555
  %v4194 = icmp eq i64 %v4193, 0
  br i1 %v4194, label %v4195, label %v4196

v4195:
  store i64 1, ptr %v4192, align 8, !noalias !555
  %v4197 = getelementptr i64, ptr %v250, i64 %v4198
  store i64 %v4189, ptr %v4197, align 8, !noalias !555
  %v4199 = add nsw i64 %v4198, 1
  br label %v4196

v4196:
  %v4200 = phi i64 [ %v4198, %v4187 ], [ %v4199, %v4195 ], [ %v4198, %v4186 ]
  %v4201 = icmp sgt i64 %v4202, 1
  br i1 %v4201, label %v4186, label %v4173

v4173:
  %v4172 = phi i64 [ %v4171, %v4169 ], [ %v4200, %v4196 ]
  %v4203 = icmp slt i64 %v4175, %v4172
  %v4204 = icmp slt i64 %v4172, %v10
  %v4205 = and i1 %v4203, %v4204
  br i1 %v4205, label %v4169, label %v4170

v4162:
  %v4154 = phi i64 [ %v4161, %v4160 ], [ 0, %v4151 ]
  %v4158 = phi i64 [ %v4164, %v4160 ], [ 0, %v4151 ]
  %v4164 = add nsw i64 %v4158, 1
  %v4206 = getelementptr double, ptr %v652, i64 %v4158
  %v4207 = load double, ptr %v4206, align 8, !noalias !555
  %v4208 = fcmp une double %v4207, 0.000000e+00
  %v4209 = getelementptr i64, ptr %v243, i64 %v4158
  %v4210 = zext i1 %v4208 to i64
  store i64 %v4210, ptr %v4209, align 8, !noalias !555
  br i1 %v4208, label %v4152, label %v4160

v4186:
  %v4198 = phi i64 [ %v4171, %v4184 ], [ %v4200, %v4196 ]
  %v4202 = phi i64 [ %v4182, %v4184 ], [ %v4211, %v4196 ]
  %v4189 = phi i64 [ %v4179, %v4184 ], [ %v4212, %v4196 ]
  %v4211 = add nsw i64 %v4202, -1
  %v4212 = add i64 %v4189, 1
  %v4213 = add nsw i64 %v4189, %v4185
  %v4214 = icmp slt i64 %v4213, 0
  %v4215 = select i1 %v4214, i64 %v223, i64 0
  %v4216 = getelementptr double, ptr %v222, i64 %v4213
  %v4217 = getelementptr double, ptr %v4216, i64 %v4215
  %v4218 = load double, ptr %v4217, align 8, !noalias !555
  %v4219 = fcmp une double %v4218, 0.000000e+00
  br i1 %v4219, label %v4187, label %v4196

v4220:
  %v4221 = select i1 %v4222, i64 %v195, i64 0
  %v4223 = add i64 %v4221, %v4224
  %v4225 = mul i64 %v4223, %v196
  %v4226 = getelementptr double, ptr %v657, i64 %v4225
  %v4227 = load double, ptr %v4226, align 8, !noalias !561
  br label %v4228

v4228:
  %v4229 = phi double [ %v4227, %v4220 ], [ 0.000000e+00, %v4230 ]
  %v4231 = mul i64 %v4232, %v196
  %v4233 = getelementptr double, ptr %v4234, i64 %v4231
  store double %v4229, ptr %v4233, align 8, !noalias !561
  %v4235 = icmp eq i64 %v10, %v4236
  br i1 %v4235, label %v4237, label %v4230

v4151:
  %v4238 = phi i64 [ 0, %v4147 ], [ %v4239, %v4151 ]
  %v4239 = add nsw i64 %v4238, 1
  %v4240 = mul i64 %v4238, %v196
  %v4241 = getelementptr double, ptr %v4150, i64 %v4240
  %v4242 = load double, ptr %v4241, align 8, !noalias !561
  %v4243 = getelementptr double, ptr %v648, i64 %v4240
  %v4244 = load double, ptr %v4243, align 8, !noalias !561
  %v4245 = fadd double %v4242, %v4244
  %v4246 = getelementptr i64, ptr %v259, i64 %v4238
  %v4247 = load i64, ptr %v4246, align 8, !noalias !561
  %v4248 = icmp slt i64 %v4247, 0
  %v4249 = select i1 %v4248, i64 %v195, i64 0
  %v4250 = add i64 %v4249, %v4247
  %v4251 = mul i64 %v4250, %v196
  %v4252 = getelementptr double, ptr %v650, i64 %v4251
  store double %v4245, ptr %v4252, align 8, !noalias !561
  %v4253 = icmp eq i64 %v10, %v4239
  br i1 %v4253, label %v4162, label %v4151

v4170:
  br i1 %v645, label %v4237, label %v4254

v4255:
  %v4256 = icmp eq i64 %v10, %v4257
  br i1 %v4256, label %v4258, label %v4254

v4259:
  %v4260 = icmp sgt i64 %v4261, 1
  br i1 %v4260, label %v4258, label %v4262

v4262:
  %v4263 = mul i64 %v658, %v4149
  %v4234 = getelementptr double, ptr %v193, i64 %v4263
  br label %v4230

v4254:
  %v4264 = phi i64 [ %v4257, %v4255 ], [ 0, %v4170 ]
  %v4257 = add nsw i64 %v4264, 1
  %v4265 = getelementptr i64, ptr %v236, i64 %v4264
  %v4266 = load i64, ptr %v4265, align 8, !noalias !562
  %v4267 = add nsw i64 %v4266, %v651
  %v4268 = icmp slt i64 %v4267, 0
  %v4269 = select i1 %v4268, i64 %v159, i64 0
  %v4270 = getelementptr double, ptr %v158, i64 %v4267
  %v4271 = getelementptr double, ptr %v4270, i64 %v4269
  %v4272 = load double, ptr %v4271, align 8, !noalias !562
  %v4273 = getelementptr double, ptr %v655, i64 %v4264
  %v4274 = load double, ptr %v4273, align 8, !noalias !562
  store double %v4274, ptr %v4271, align 8, !noalias !562
  store double %v4272, ptr %v4273, align 8, !noalias !562
  %v4275 = add i64 %v654, %v4264
  %v4276 = tail call i64 @llvm.smin.i64(i64 %v4275, i64 %v10)
  %v4277 = sub i64 %v4276, %v4257
  %v4278 = icmp slt i64 %v4277, 1
  br i1 %v4278, label %v4255, label %v4279

v4279:
  %v4280 = mul nsw i64 %v4264, %v10
  br label %v4281

v4281:
  %v4282 = phi i64 [ %v4277, %v4279 ], [ %v4283, %v4281 ]
  %v4284 = phi i64 [ %v4257, %v4279 ], [ %v4285, %v4281 ]
  %v4283 = add nsw i64 %v4282, -1
  %v4285 = add i64 %v4284, 1
  %v4286 = add nsw i64 %v4284, %v651
  %v4287 = icmp slt i64 %v4286, 0
  %v4288 = select i1 %v4287, i64 %v159, i64 0
  %v4289 = getelementptr double, ptr %v158, i64 %v4286
  %v4290 = getelementptr double, ptr %v4289, i64 %v4288
  %v4291 = load double, ptr %v4290, align 8, !noalias !562
  %v4292 = add nsw i64 %v4284, %v4280
  %v4293 = icmp slt i64 %v4292, 0
  %v4294 = select i1 %v4293, i64 %v230, i64 0
  %v4295 = getelementptr double, ptr %v229, i64 %v4292
  %v4296 = getelementptr double, ptr %v4295, i64 %v4294
  %v4297 = load double, ptr %v4296, align 8, !noalias !562
  %v4298 = fmul double %v4272, %v4297
  %v4299 = fsub double %v4291, %v4298
  store double %v4299, ptr %v4290, align 8, !noalias !562
  %v4300 = icmp sgt i64 %v4282, 1
  br i1 %v4300, label %v4281, label %v4255

v4258:
  %v4261 = phi i64 [ %v4301, %v4259 ], [ %v10, %v4255 ]
  %v4301 = add nsw i64 %v4261, -1
  %v4302 = add nsw i64 %v4301, %v651
  %v4303 = icmp slt i64 %v4302, 0
  %v4304 = select i1 %v4303, i64 %v159, i64 0
  %v4305 = getelementptr double, ptr %v158, i64 %v4302
  %v4306 = getelementptr double, ptr %v4305, i64 %v4304
  %v4307 = load double, ptr %v4306, align 8, !noalias !562
  %v4308 = mul nsw i64 %v4301, %v10
  %v4309 = add nsw i64 %v4308, %v4301
  %v4310 = icmp slt i64 %v4309, 0
  %v4311 = select i1 %v4310, i64 %v230, i64 0
  %v4312 = getelementptr double, ptr %v229, i64 %v4309
  %v4313 = getelementptr double, ptr %v4312, i64 %v4311
  %v4314 = load double, ptr %v4313, align 8, !noalias !562
  %v4315 = fdiv double %v4307, %v4314
  store double %v4315, ptr %v4306, align 8, !noalias !562
  %v4316 = sub i64 %v4301, %v656
  %v4317 = tail call i64 @llvm.smax.i64(i64 %v4316, i64 0)
  %v4318 = sub i64 %v4301, %v4317
  %v4319 = icmp slt i64 %v4318, 1
  br i1 %v4319, label %v4259, label %v4320

v4320:
  %v4321 = phi i64 [ %v4322, %v4320 ], [ %v4318, %v4258 ]
  %v4323 = phi i64 [ %v4324, %v4320 ], [ %v4317, %v4258 ]
  %v4322 = add nsw i64 %v4321, -1
  %v4324 = add i64 %v4323, 1
  %v4325 = add nsw i64 %v4323, %v651
  %v4326 = icmp slt i64 %v4325, 0
  %v4327 = select i1 %v4326, i64 %v159, i64 0
  %v4328 = getelementptr double, ptr %v158, i64 %v4325
  %v4329 = getelementptr double, ptr %v4328, i64 %v4327
  %v4330 = load double, ptr %v4329, align 8, !noalias !562
  %v4331 = add nsw i64 %v4323, %v4308
  %v4332 = icmp slt i64 %v4331, 0
  %v4333 = select i1 %v4332, i64 %v230, i64 0
  %v4334 = getelementptr double, ptr %v229, i64 %v4331
  %v4335 = getelementptr double, ptr %v4334, i64 %v4333
  %v4336 = load double, ptr %v4335, align 8, !noalias !562
  %v4337 = fmul double %v4315, %v4336
  %v4338 = fsub double %v4330, %v4337
  store double %v4338, ptr %v4329, align 8, !noalias !562
  %v4339 = icmp sgt i64 %v4321, 1
  br i1 %v4339, label %v4320, label %v4259

v4230:
  %v4232 = phi i64 [ 0, %v4262 ], [ %v4236, %v4228 ]
  %v4236 = add nsw i64 %v4232, 1
  %v4340 = getelementptr i64, ptr %v259, i64 %v4232
  %v4224 = load i64, ptr %v4340, align 8, !noalias !561
  %v4222 = icmp slt i64 %v4224, 0
  %v4341 = select i1 %v4222, i64 %v244, i64 0
  %v4342 = getelementptr i64, ptr %v243, i64 %v4224
  %v4343 = getelementptr i64, ptr %v4342, i64 %v4341
  %v4344 = load i64, ptr %v4343, align 8, !noalias !561
  %v4345 = icmp eq i64 %v4344, 0
  br i1 %v4345, label %v4228, label %v4220

v4237:
  %v4346 = icmp eq i64 %v4347, %v637
  br i1 %v4346, label %v1306, label %v4144

v1306:
  %v4348 = load i64, ptr %v659, align 8, !noalias !566
  %v4349 = inttoptr i64 %v4348 to ptr
  tail call void %v4349(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !566
  br i1 %v307, label %v1304, label %v1294

v4144:
  %v4347 = phi i64 [ %v4149, %v4237 ], [ 1, %v3816 ]
  %v4149 = add i64 %v4347, 1
  %v4350 = getelementptr i64, ptr %v6, i64 %v4347
  %v4351 = getelementptr i8, ptr %v4350, i64 104
  %v4352 = load i64, ptr %v4351, align 8, !noalias !569
  %v4353 = inttoptr i64 %v4352 to ptr
  tail call void %v4353(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !569
  %v4354 = load i64, ptr %v6, align 8, !noalias !572
  %v4355 = mul nsw i64 %v4149, %v642
  %v4356 = getelementptr double, ptr %v158, i64 %v4355
  %v4357 = inttoptr i64 %v4354 to ptr
  tail call void %v4357(ptr %v641, ptr %v644, ptr %v165, ptr %v172, ptr %v179, ptr %v4356), !noalias !572
  br i1 %v580, label %v4145, label %v4237

v1294:
  %v1295 = phi i1 [ %v1301, %v1296 ], [ %v1282, %v1306 ]
  %v4358 = phi i1 [ %v1293, %v1296 ], [ false, %v1306 ]
  %v1303 = phi i64 [ %v4359, %v1296 ], [ %v308, %v1306 ]
  %v1289 = phi i64 [ %v4360, %v1296 ], [ 0, %v1306 ]
  %v4359 = add nsw i64 %v1303, -1
  %v4360 = add nsw i64 %v1289, 1
  br i1 %v4358, label %v1292, label %v1287

v1397:
  %v1407 = xor i1 %v1392, true
  %v4361 = xor i1 %v1393, true
  %v1409 = select i1 %v4361, i1 true, i1 %v686
  br label %v1310

v3060:
  store ptr %v3057, ptr %v1, align 8
  br label %v3807

v3059:
  %v4362 = select i1 %v1307, i1 %v1305, i1 false
  %v4363 = xor i1 %v4362, true
  %v4364 = or i1 %v307, %v4363
  br i1 %v4364, label %v3180, label %v3181

v3755:
  %v3759 = select i1 %v3752, i64 0, i64 %v1079
  br label %v1076

v3764:
  store i64 %v3763, ptr %v0, align 8
  br label %v3807
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc range(i32 0, 2) i32 @_ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr noalias nonnull %v0, ptr noalias nonnull %v1, i64 %v2, ptr readonly %v3, i64 %v4, ptr %v5, i64 %v6, i64 %v7, ptr %v8, i64 %v9, ptr %v10, i64 %v11, ptr readonly %v12, i64 %v13, i64 %v14, i64 %v15, double %v16) unnamed_addr {
v17:
  %v18 = icmp slt i64 %v2, 1
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

v40:
  %v41 = phi i64 [ 0, %v39 ], [ 7, %v34 ], [ 1, %v42 ], [ 4, %v43 ], [ 7, %v44 ], [ 2, %v45 ], [ 6, %v46 ], [ 3, %v47 ], [ 5, %v48 ]
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
  %v79 = phi i64 [ %v41, %v40 ], [ %v59, %v60 ], [ 8, %v70 ]
  %v80 = add nsw i64 %v79, -1
  %v81 = select i1 %v18, i64 %v80, i64 0
  %v82 = getelementptr double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v81
  %v83 = getelementptr i8, ptr %v82, i64 72
  %v84 = load double, ptr %v83, align 8
  %v85 = fcmp ogt double %v84, %v16
  %v86 = select i1 %v85, double %v84, double %v16
  %v87 = getelementptr double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v79
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
  %v321 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v293
  %v322 = load double, ptr %v321, align 8
  %v323 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v318
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
  %v330 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v325
  %v331 = load double, ptr %v330, align 8
  %v332 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v328
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

v39:
  %v381 = fcmp ult double %v16, 0x3FB48E8A71DE69AD
  br i1 %v381, label %v40, label %v42

v42:
  %v382 = fcmp ult double %v16, 2.500000e-01
  br i1 %v382, label %v40, label %v45

v45:
  %v383 = fcmp ult double %v16, 3.333000e-01
  br i1 %v383, label %v40, label %v47

v47:
  %v384 = fcmp ult double %v16, 5.000000e-01
  br i1 %v384, label %v40, label %v43

v43:
  %v385 = fcmp ult double %v16, 0x3FE50A3D70A3D70A
  br i1 %v385, label %v40, label %v48

v48:
  %v386 = fcmp ult double %v16, 7.500000e-01
  br i1 %v386, label %v40, label %v46

v46:
  %v387 = fcmp ult double %v16, 8.889000e-01
  br i1 %v387, label %v40, label %v44

v44:
  br label %v40

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
  br i1 %v18, label %v441, label %v37

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
!1 = distinct !{!1, !2, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!2 = distinct !{!2, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!3 = !{!4, !6, !1}
!4 = distinct !{!4, !5, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!5 = distinct !{!5, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!6 = distinct !{!6, !5, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!7 = !{!8, !10, !1}
!8 = distinct !{!8, !9, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!9 = distinct !{!9, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!10 = distinct !{!10, !9, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!11 = !{!12, !14}
!12 = distinct !{!12, !13, !"_ZN5pages12time_stepper14start_segmentsB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!13 = distinct !{!13, !"_ZN5pages12time_stepper14start_segmentsB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!14 = distinct !{!14, !13, !"_ZN5pages12time_stepper14start_segmentsB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!15 = !{!16, !12, !14}
!16 = distinct !{!16, !17, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!17 = distinct !{!17, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!18 = !{!19, !21, !23, !12, !14}
!19 = distinct !{!19, !20, !"_ZN5pages13solver_layout6decideB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_280_29: %retptr"}
!20 = distinct !{!20, !"_ZN5pages13solver_layout6decideB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_280_29"}
!21 = distinct !{!21, !22, !"_ZN5pages12event_checks17decisions_changedB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!22 = distinct !{!22, !"_ZN5pages12event_checks17decisions_changedB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!23 = distinct !{!23, !22, !"_ZN5pages12event_checks17decisions_changedB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!24 = !{!21, !23, !12, !14}
!25 = !{!26, !28, !30, !12, !14}
!26 = distinct !{!26, !27, !"_ZN5pages13solver_layout6decideB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_280_29: %retptr"}
!27 = distinct !{!27, !"_ZN5pages13solver_layout6decideB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_280_29"}
!28 = distinct !{!28, !29, !"_ZN5pages12event_checks14hold_decisionsB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!29 = distinct !{!29, !"_ZN5pages12event_checks14hold_decisionsB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!30 = distinct !{!30, !29, !"_ZN5pages12event_checks14hold_decisionsB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!31 = !{!28, !30, !12, !14}
!32 = !{!33, !28, !30, !12, !14}
!33 = distinct !{!33, !34, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!34 = distinct !{!34, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!35 = !{!36, !12, !14}
!36 = distinct !{!36, !37, !"_ZN5pages13solver_layout10derivativeB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29x: %retptr"}
!37 = distinct !{!37, !"_ZN5pages13solver_layout10derivativeB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29x"}
!38 = !{!39, !12, !14}
!39 = distinct !{!39, !40, !"_ZN5pages13solver_layout7formulaB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_287_29: %retptr"}
!40 = distinct !{!40, !"_ZN5pages13solver_layout7formulaB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_287_29"}
!41 = !{!42, !12, !14}
!42 = distinct !{!42, !43, !"_ZN5pages13solver_layout7formulaB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_288_29: %retptr"}
!43 = distinct !{!43, !"_ZN5pages13solver_layout7formulaB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_288_29"}
!44 = !{!45, !12, !14}
!45 = distinct !{!45, !46, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!46 = distinct !{!46, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!47 = !{!48, !12, !14}
!48 = distinct !{!48, !49, !"_ZN5pages13solver_layout7formulaB3v14B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!49 = distinct !{!49, !"_ZN5pages13solver_layout7formulaB3v14B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!50 = !{!51, !53, !12, !14}
!51 = distinct !{!51, !52, !"_ZN5pages8segments13begin_segmentB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!52 = distinct !{!52, !"_ZN5pages8segments13begin_segmentB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!53 = distinct !{!53, !52, !"_ZN5pages8segments13begin_segmentB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!54 = !{!55, !51, !53, !12, !14}
!55 = distinct !{!55, !56, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!56 = distinct !{!56, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!57 = !{!58, !60, !61, !63, !64, !66, !51, !53, !12, !14}
!58 = distinct !{!58, !59, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!59 = distinct !{!59, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!60 = distinct !{!60, !59, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!61 = distinct !{!61, !62, !"_ZN5pages8segments13first_outsideB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29: %retptr"}
!62 = distinct !{!62, !"_ZN5pages8segments13first_outsideB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29"}
!63 = distinct !{!63, !62, !"_ZN5pages8segments13first_outsideB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29: %excinfo"}
!64 = distinct !{!64, !65, !"_ZN5pages8segments12stop_outsideB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x23Literal_5bint_5d_280_29: %retptr"}
!65 = distinct !{!65, !"_ZN5pages8segments12stop_outsideB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x23Literal_5bint_5d_280_29"}
!66 = distinct !{!66, !65, !"_ZN5pages8segments12stop_outsideB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x23Literal_5bint_5d_280_29: %excinfo"}
!67 = !{!61, !63, !64, !66, !51, !53, !12, !14}
!68 = !{!69, !61, !63, !64, !66, !51, !53, !12, !14}
!69 = distinct !{!69, !70, !"_ZN5pages13solver_layout10derivativeB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2924Literal_5bint_5d_2814_29: %retptr"}
!70 = distinct !{!70, !"_ZN5pages13solver_layout10derivativeB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2924Literal_5bint_5d_2814_29"}
!71 = !{!72, !61, !63, !64, !66, !51, !53, !12, !14}
!72 = distinct !{!72, !73, !"_ZN5pages13solver_layout6decideB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_289_29: %retptr"}
!73 = distinct !{!73, !"_ZN5pages13solver_layout6decideB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_289_29"}
!74 = !{!75, !61, !63, !64, !66, !51, !53, !12, !14}
!75 = distinct !{!75, !76, !"_ZN5pages13solver_layout6decideB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29: %retptr"}
!76 = distinct !{!76, !"_ZN5pages13solver_layout6decideB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29"}
!77 = !{!64, !66, !51, !53, !12, !14}
!78 = !{!79, !64, !66, !51, !53, !12, !14}
!79 = distinct !{!79, !80, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!80 = distinct !{!80, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!81 = !{!82, !84, !51, !53, !12, !14}
!82 = distinct !{!82, !83, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!83 = distinct !{!83, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!84 = distinct !{!84, !83, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!85 = !{!86, !88, !90}
!86 = distinct !{!86, !87, !"_ZN5pages13solver_layout7formulaB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_285_29: %retptr"}
!87 = distinct !{!87, !"_ZN5pages13solver_layout7formulaB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_285_29"}
!88 = distinct !{!88, !89, !"_ZN5pages12time_stepper12attempt_stepB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!89 = distinct !{!89, !"_ZN5pages12time_stepper12attempt_stepB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!90 = distinct !{!90, !89, !"_ZN5pages12time_stepper12attempt_stepB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!91 = !{!92, !94, !95, !97}
!92 = distinct !{!92, !93, !"_ZN5pages12time_stepper11count_stepsB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!93 = distinct !{!93, !"_ZN5pages12time_stepper11count_stepsB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!94 = distinct !{!94, !93, !"_ZN5pages12time_stepper11count_stepsB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!95 = distinct !{!95, !96, !"_ZN5pages12time_stepper11check_lanesB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!96 = distinct !{!96, !"_ZN5pages12time_stepper11check_lanesB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!97 = distinct !{!97, !96, !"_ZN5pages12time_stepper11check_lanesB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!98 = !{!95, !97}
!99 = !{!100, !95, !97}
!100 = distinct !{!100, !101, !"_ZN5pages13solver_layout4failB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!101 = distinct !{!101, !"_ZN5pages13solver_layout4failB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!102 = !{!103, !105, !107}
!103 = distinct !{!103, !104, !"_ZN5pages13solver_layout10derivativeB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!104 = distinct !{!104, !"_ZN5pages13solver_layout10derivativeB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!105 = distinct !{!105, !106, !"_ZN5pages12time_stepper13handle_eventsB4v105B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb: %retptr"}
!106 = distinct !{!106, !"_ZN5pages12time_stepper13handle_eventsB4v105B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb"}
!107 = distinct !{!107, !106, !"_ZN5pages12time_stepper13handle_eventsB4v105B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb: %excinfo"}
!108 = !{!109, !105, !107}
!109 = distinct !{!109, !110, !"_ZN5pages13solver_layout7formulaB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2813_29: %retptr"}
!110 = distinct !{!110, !"_ZN5pages13solver_layout7formulaB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2813_29"}
!111 = !{!112, !105, !107}
!112 = distinct !{!112, !113, !"_ZN5pages13solver_layout7formulaB3v50B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2812_29: %retptr"}
!113 = distinct !{!113, !"_ZN5pages13solver_layout7formulaB3v50B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2812_29"}
!114 = !{!115, !117, !118, !120, !121, !123, !105, !107}
!115 = distinct !{!115, !116, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!116 = distinct !{!116, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!117 = distinct !{!117, !116, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!118 = distinct !{!118, !119, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!119 = distinct !{!119, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!120 = distinct !{!120, !119, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!121 = distinct !{!121, !122, !"_ZN5pages12event_checks10comes_nearB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!122 = distinct !{!122, !"_ZN5pages12event_checks10comes_nearB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!123 = distinct !{!123, !122, !"_ZN5pages12event_checks10comes_nearB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!124 = !{!125, !127, !115, !117, !118, !120, !121, !123, !105, !107}
!125 = distinct !{!125, !126, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!126 = distinct !{!126, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!127 = distinct !{!127, !126, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!128 = !{!129, !118, !120, !121, !123, !105, !107}
!129 = distinct !{!129, !130, !"_ZN5pages13solver_layout6decideB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!130 = distinct !{!130, !"_ZN5pages13solver_layout6decideB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!131 = !{!"branch_weights", i32 99, i32 1}
!132 = !{!133, !135, !137, !105, !107}
!133 = distinct !{!133, !134, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!134 = distinct !{!134, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!135 = distinct !{!135, !136, !"_ZN5pages12time_stepper18interpolant_stagesB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!136 = distinct !{!136, !"_ZN5pages12time_stepper18interpolant_stagesB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!137 = distinct !{!137, !136, !"_ZN5pages12time_stepper18interpolant_stagesB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!138 = !{!139, !135, !137, !105, !107}
!139 = distinct !{!139, !140, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!140 = distinct !{!140, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!141 = !{!142, !135, !137, !105, !107}
!142 = distinct !{!142, !143, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!143 = distinct !{!143, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!144 = !{!145, !105, !107}
!145 = distinct !{!145, !146, !"_ZN5pages13solver_layout7formulaB3v59B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2811_29: %retptr"}
!146 = distinct !{!146, !"_ZN5pages13solver_layout7formulaB3v59B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2811_29"}
!147 = !{!148, !150, !105, !107}
!148 = distinct !{!148, !149, !"_ZN5pages12time_stepper17check_interpolantB3v60B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!149 = distinct !{!149, !"_ZN5pages12time_stepper17check_interpolantB3v60B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!150 = distinct !{!150, !149, !"_ZN5pages12time_stepper17check_interpolantB3v60B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!151 = !{!152, !148, !150, !105, !107}
!152 = distinct !{!152, !153, !"_ZN5pages13solver_layout5retryB3v61B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd: %retptr"}
!153 = distinct !{!153, !"_ZN5pages13solver_layout5retryB3v61B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd"}
!154 = !{!155, !157, !105, !107}
!155 = distinct !{!155, !156, !"_ZN5pages12event_checks12check_eventsB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!156 = distinct !{!156, !"_ZN5pages12event_checks12check_eventsB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!157 = distinct !{!157, !156, !"_ZN5pages12event_checks12check_eventsB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!158 = !{!159, !161, !162, !164, !155, !157, !105, !107}
!159 = distinct !{!159, !160, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!160 = distinct !{!160, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!161 = distinct !{!161, !160, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!162 = distinct !{!162, !163, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!163 = distinct !{!163, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!164 = distinct !{!164, !163, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!165 = !{!166, !168, !159, !161, !162, !164, !155, !157, !105, !107}
!166 = distinct !{!166, !167, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!167 = distinct !{!167, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!168 = distinct !{!168, !167, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!169 = !{!170, !162, !164, !155, !157, !105, !107}
!170 = distinct !{!170, !171, !"_ZN5pages13solver_layout6decideB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!171 = distinct !{!171, !"_ZN5pages13solver_layout6decideB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!172 = !{!173, !175, !176, !178, !155, !157, !105, !107}
!173 = distinct !{!173, !174, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!174 = distinct !{!174, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!175 = distinct !{!175, !174, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!176 = distinct !{!176, !177, !"_ZN5pages12event_checks9set_edgesB3v63B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!177 = distinct !{!177, !"_ZN5pages12event_checks9set_edgesB3v63B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!178 = distinct !{!178, !177, !"_ZN5pages12event_checks9set_edgesB3v63B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!179 = !{!176, !178, !155, !157, !105, !107}
!180 = !{!181, !183, !105, !107}
!181 = distinct !{!181, !182, !"_ZN5pages14event_location13locate_eventsB3v71B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!182 = distinct !{!182, !"_ZN5pages14event_location13locate_eventsB3v71B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!183 = distinct !{!183, !182, !"_ZN5pages14event_location13locate_eventsB3v71B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!184 = !{!185, !187, !188, !181, !183, !105, !107}
!185 = distinct !{!185, !186, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %retptr"}
!186 = distinct !{!186, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx"}
!187 = distinct !{!187, !186, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %excinfo"}
!188 = distinct !{!188, !189, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!189 = distinct !{!189, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!190 = !{!188, !181, !183, !105, !107}
!191 = !{!192, !194, !195, !197, !188, !181, !183, !105, !107}
!192 = distinct !{!192, !193, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!193 = distinct !{!193, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!194 = distinct !{!194, !193, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!195 = distinct !{!195, !196, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!196 = distinct !{!196, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!197 = distinct !{!197, !196, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!198 = !{!199, !201, !192, !194, !195, !197, !188, !181, !183, !105, !107}
!199 = distinct !{!199, !200, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!200 = distinct !{!200, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!201 = distinct !{!201, !200, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!202 = !{!203, !195, !197, !188, !181, !183, !105, !107}
!203 = distinct !{!203, !204, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!204 = distinct !{!204, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!205 = !{!195, !197, !188, !181, !183, !105, !107}
!206 = !{!207, !209, !188, !181, !183, !105, !107}
!207 = distinct !{!207, !208, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!208 = distinct !{!208, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!209 = distinct !{!209, !208, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!210 = !{!211, !213, !181, !183, !105, !107}
!211 = distinct !{!211, !212, !"_ZN5pages14event_location9stops_runB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!212 = distinct !{!212, !"_ZN5pages14event_location9stops_runB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!213 = distinct !{!213, !212, !"_ZN5pages14event_location9stops_runB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!214 = !{!215, !217, !218, !220, !211, !213, !181, !183, !105, !107}
!215 = distinct !{!215, !216, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!216 = distinct !{!216, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!217 = distinct !{!217, !216, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!218 = distinct !{!218, !219, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!219 = distinct !{!219, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!220 = distinct !{!220, !219, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!221 = !{!222, !224, !215, !217, !218, !220, !211, !213, !181, !183, !105, !107}
!222 = distinct !{!222, !223, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!223 = distinct !{!223, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!224 = distinct !{!224, !223, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!225 = !{!226, !218, !220, !211, !213, !181, !183, !105, !107}
!226 = distinct !{!226, !227, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!227 = distinct !{!227, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!228 = !{!218, !220, !211, !213, !181, !183, !105, !107}
!229 = !{!230, !232, !233, !235, !236, !238, !211, !213, !181, !183, !105, !107}
!230 = distinct !{!230, !231, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!231 = distinct !{!231, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!232 = distinct !{!232, !231, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!233 = distinct !{!233, !234, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!234 = distinct !{!234, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!235 = distinct !{!235, !234, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!236 = distinct !{!236, !237, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!237 = distinct !{!237, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!238 = distinct !{!238, !237, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!239 = !{!233, !235, !236, !238, !211, !213, !181, !183, !105, !107}
!240 = !{!241, !236, !238, !211, !213, !181, !183, !105, !107}
!241 = distinct !{!241, !242, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!242 = distinct !{!242, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!243 = !{!236, !238, !211, !213, !181, !183, !105, !107}
!244 = !{!245, !247, !248, !211, !213, !181, !183, !105, !107}
!245 = distinct !{!245, !246, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %retptr"}
!246 = distinct !{!246, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx"}
!247 = distinct !{!247, !246, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %excinfo"}
!248 = distinct !{!248, !249, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!249 = distinct !{!249, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!250 = !{!248, !211, !213, !181, !183, !105, !107}
!251 = !{!252, !254, !255, !257, !248, !211, !213, !181, !183, !105, !107}
!252 = distinct !{!252, !253, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!253 = distinct !{!253, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!254 = distinct !{!254, !253, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!255 = distinct !{!255, !256, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!256 = distinct !{!256, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!257 = distinct !{!257, !256, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!258 = !{!259, !261, !252, !254, !255, !257, !248, !211, !213, !181, !183, !105, !107}
!259 = distinct !{!259, !260, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!260 = distinct !{!260, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!261 = distinct !{!261, !260, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!262 = !{!263, !255, !257, !248, !211, !213, !181, !183, !105, !107}
!263 = distinct !{!263, !264, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!264 = distinct !{!264, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!265 = !{!255, !257, !248, !211, !213, !181, !183, !105, !107}
!266 = !{!267, !269, !248, !211, !213, !181, !183, !105, !107}
!267 = distinct !{!267, !268, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!268 = distinct !{!268, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!269 = distinct !{!269, !268, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!270 = !{!271, !273, !211, !213, !181, !183, !105, !107}
!271 = distinct !{!271, !272, !"_ZN5pages8segments19write_samples_untilB3v80B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!272 = distinct !{!272, !"_ZN5pages8segments19write_samples_untilB3v80B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!273 = distinct !{!273, !272, !"_ZN5pages8segments19write_samples_untilB3v80B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %excinfo"}
!274 = !{!275, !211, !213, !181, !183, !105, !107}
!275 = distinct !{!275, !276, !"_ZN5pages13solver_layout4failB3v81B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29: %retptr"}
!276 = distinct !{!276, !"_ZN5pages13solver_layout4failB3v81B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29"}
!277 = !{!278, !280, !271, !273, !211, !213, !181, !183, !105, !107}
!278 = distinct !{!278, !279, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!279 = distinct !{!279, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!280 = distinct !{!280, !279, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!281 = !{!282, !284, !211, !213, !181, !183, !105, !107}
!282 = distinct !{!282, !283, !"_ZN5pages12event_checks13first_crossedB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!283 = distinct !{!283, !"_ZN5pages12event_checks13first_crossedB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!284 = distinct !{!284, !283, !"_ZN5pages12event_checks13first_crossedB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!285 = !{!286, !288, !181, !183, !105, !107}
!286 = distinct !{!286, !287, !"_ZN5pages14event_location11pass_eventsB3v82B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!287 = distinct !{!287, !"_ZN5pages14event_location11pass_eventsB3v82B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!288 = distinct !{!288, !287, !"_ZN5pages14event_location11pass_eventsB3v82B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!289 = !{!290, !292, !293, !295, !286, !288, !181, !183, !105, !107}
!290 = distinct !{!290, !291, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!291 = distinct !{!291, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!292 = distinct !{!292, !291, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!293 = distinct !{!293, !294, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!294 = distinct !{!294, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!295 = distinct !{!295, !294, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!296 = !{!297, !299, !290, !292, !293, !295, !286, !288, !181, !183, !105, !107}
!297 = distinct !{!297, !298, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!298 = distinct !{!298, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!299 = distinct !{!299, !298, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!300 = !{!301, !293, !295, !286, !288, !181, !183, !105, !107}
!301 = distinct !{!301, !302, !"_ZN5pages13solver_layout6decideB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!302 = distinct !{!302, !"_ZN5pages13solver_layout6decideB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!303 = !{!304, !286, !288, !181, !183, !105, !107}
!304 = distinct !{!304, !305, !"_ZN5pages13solver_layout10derivativeB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!305 = distinct !{!305, !"_ZN5pages13solver_layout10derivativeB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!306 = !{!307, !309, !310, !286, !288, !181, !183, !105, !107}
!307 = distinct !{!307, !308, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %retptr"}
!308 = distinct !{!308, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx"}
!309 = distinct !{!309, !308, !"_ZN5pages14event_location10next_shareB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %excinfo"}
!310 = distinct !{!310, !311, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!311 = distinct !{!311, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!312 = !{!310, !286, !288, !181, !183, !105, !107}
!313 = !{!314, !316, !317, !319, !310, !286, !288, !181, !183, !105, !107}
!314 = distinct !{!314, !315, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!315 = distinct !{!315, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!316 = distinct !{!316, !315, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!317 = distinct !{!317, !318, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!318 = distinct !{!318, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!319 = distinct !{!319, !318, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!320 = !{!321, !323, !314, !316, !317, !319, !310, !286, !288, !181, !183, !105, !107}
!321 = distinct !{!321, !322, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!322 = distinct !{!322, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!323 = distinct !{!323, !322, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!324 = !{!325, !317, !319, !310, !286, !288, !181, !183, !105, !107}
!325 = distinct !{!325, !326, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!326 = distinct !{!326, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!327 = !{!317, !319, !310, !286, !288, !181, !183, !105, !107}
!328 = !{!329, !331, !310, !286, !288, !181, !183, !105, !107}
!329 = distinct !{!329, !330, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!330 = distinct !{!330, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!331 = distinct !{!331, !330, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!332 = !{!333, !335, !337, !286, !288, !181, !183, !105, !107}
!333 = distinct !{!333, !334, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!334 = distinct !{!334, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!335 = distinct !{!335, !336, !"_ZN5pages14event_location18exchange_decisionsB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %retptr"}
!336 = distinct !{!336, !"_ZN5pages14event_location18exchange_decisionsB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29"}
!337 = distinct !{!337, !336, !"_ZN5pages14event_location18exchange_decisionsB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %excinfo"}
!338 = !{!335, !337, !286, !288, !181, !183, !105, !107}
!339 = !{!340, !342, !286, !288, !181, !183, !105, !107}
!340 = distinct !{!340, !341, !"_ZN5pages14event_location12rates_changeB3v83B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!341 = distinct !{!341, !"_ZN5pages14event_location12rates_changeB3v83B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!342 = distinct !{!342, !341, !"_ZN5pages14event_location12rates_changeB3v83B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!343 = !{!344, !346, !347, !349, !340, !342, !286, !288, !181, !183, !105, !107}
!344 = distinct !{!344, !345, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!345 = distinct !{!345, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!346 = distinct !{!346, !345, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!347 = distinct !{!347, !348, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!348 = distinct !{!348, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!349 = distinct !{!349, !348, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!350 = !{!351, !353, !344, !346, !347, !349, !340, !342, !286, !288, !181, !183, !105, !107}
!351 = distinct !{!351, !352, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!352 = distinct !{!352, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!353 = distinct !{!353, !352, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!354 = !{!355, !347, !349, !340, !342, !286, !288, !181, !183, !105, !107}
!355 = distinct !{!355, !356, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!356 = distinct !{!356, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!357 = !{!347, !349, !340, !342, !286, !288, !181, !183, !105, !107}
!358 = !{!359, !361, !340, !342, !286, !288, !181, !183, !105, !107}
!359 = distinct !{!359, !360, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!360 = distinct !{!360, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!361 = distinct !{!361, !360, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!362 = !{!363, !365, !359, !361, !340, !342, !286, !288, !181, !183, !105, !107}
!363 = distinct !{!363, !364, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!364 = distinct !{!364, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!365 = distinct !{!365, !364, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!366 = !{!367, !369, !371, !340, !342, !286, !288, !181, !183, !105, !107}
!367 = distinct !{!367, !368, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!368 = distinct !{!368, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!369 = distinct !{!369, !370, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!370 = distinct !{!370, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!371 = distinct !{!371, !370, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!372 = !{!369, !371, !340, !342, !286, !288, !181, !183, !105, !107}
!373 = !{!374, !376, !378, !340, !342, !286, !288, !181, !183, !105, !107}
!374 = distinct !{!374, !375, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!375 = distinct !{!375, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!376 = distinct !{!376, !377, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!377 = distinct !{!377, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!378 = distinct !{!378, !377, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!379 = !{!376, !378, !340, !342, !286, !288, !181, !183, !105, !107}
!380 = !{!381, !340, !342, !286, !288, !181, !183, !105, !107}
!381 = distinct !{!381, !382, !"_ZN5pages13solver_layout10derivativeB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2814_29: %retptr"}
!382 = distinct !{!382, !"_ZN5pages13solver_layout10derivativeB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2814_29"}
!383 = !{!384, !386, !388, !340, !342, !286, !288, !181, !183, !105, !107}
!384 = distinct !{!384, !385, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!385 = distinct !{!385, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!386 = distinct !{!386, !387, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!387 = distinct !{!387, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!388 = distinct !{!388, !387, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!389 = !{!390, !340, !342, !286, !288, !181, !183, !105, !107}
!390 = distinct !{!390, !391, !"_ZN5pages13solver_layout10derivativeB3v86B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2815_29: %retptr"}
!391 = distinct !{!391, !"_ZN5pages13solver_layout10derivativeB3v86B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2815_29"}
!392 = !{!393, !395, !340, !342, !286, !288, !181, !183, !105, !107}
!393 = distinct !{!393, !394, !"_ZN5pages14event_location12rates_differB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!394 = distinct !{!394, !"_ZN5pages14event_location12rates_differB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!395 = distinct !{!395, !394, !"_ZN5pages14event_location12rates_differB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!396 = !{!386, !388, !340, !342, !286, !288, !181, !183, !105, !107}
!397 = !{!"branch_weights", i32 1, i32 99}
!398 = !{!"branch_weights", i32 101, i32 99}
!399 = !{!400, !402, !181, !183, !105, !107}
!400 = distinct !{!400, !401, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!401 = distinct !{!401, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!402 = distinct !{!402, !401, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!403 = !{!404, !406, !407, !409, !181, !183, !105, !107}
!404 = distinct !{!404, !405, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!405 = distinct !{!405, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!406 = distinct !{!406, !405, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!407 = distinct !{!407, !408, !"_ZN5pages14event_location8end_stepB3v89B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!408 = distinct !{!408, !"_ZN5pages14event_location8end_stepB3v89B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!409 = distinct !{!409, !408, !"_ZN5pages14event_location8end_stepB3v89B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!410 = !{!411, !413, !404, !406, !407, !409, !181, !183, !105, !107}
!411 = distinct !{!411, !412, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!412 = distinct !{!412, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!413 = distinct !{!413, !412, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!414 = !{!407, !409, !181, !183, !105, !107}
!415 = !{!416, !407, !409, !181, !183, !105, !107}
!416 = distinct !{!416, !417, !"_ZN5pages13solver_layout10derivativeB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!417 = distinct !{!417, !"_ZN5pages13solver_layout10derivativeB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!418 = !{!419, !407, !409, !181, !183, !105, !107}
!419 = distinct !{!419, !420, !"_ZN5pages13solver_layout6decideB3v90B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_288_29: %retptr"}
!420 = distinct !{!420, !"_ZN5pages13solver_layout6decideB3v90B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_288_29"}
!421 = !{!422, !181, !183, !105, !107}
!422 = distinct !{!422, !423, !"_ZN5pages13solver_layout5retryB3v70B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!423 = distinct !{!423, !"_ZN5pages13solver_layout5retryB3v70B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!424 = !{!121, !123, !105, !107}
!425 = !{!426, !428, !121, !123, !105, !107}
!426 = distinct !{!426, !427, !"_ZN5pages12event_checks13error_betweenB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!427 = distinct !{!427, !"_ZN5pages12event_checks13error_betweenB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!428 = distinct !{!428, !427, !"_ZN5pages12event_checks13error_betweenB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!429 = !{!430}
!430 = distinct !{!430, !431, !"_ZN5pages12time_stepper13write_samplesB3v91B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29b: %retptr"}
!431 = distinct !{!431, !"_ZN5pages12time_stepper13write_samplesB3v91B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29b"}
!432 = !{!433, !435, !430}
!433 = distinct !{!433, !434, !"_ZN5pages8segments19write_samples_untilB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd: %retptr"}
!434 = distinct !{!434, !"_ZN5pages8segments19write_samples_untilB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd"}
!435 = distinct !{!435, !434, !"_ZN5pages8segments19write_samples_untilB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd: %excinfo"}
!436 = !{!437, !439, !433, !435, !430}
!437 = distinct !{!437, !438, !"_ZN5pages13solver_layout11interpolateB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd: %retptr"}
!438 = distinct !{!438, !"_ZN5pages13solver_layout11interpolateB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd"}
!439 = distinct !{!439, !438, !"_ZN5pages13solver_layout11interpolateB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd: %excinfo"}
!440 = !{!441}
!441 = distinct !{!441, !442, !"_ZN5pages13solver_layout7formulaB3v94B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %retptr"}
!442 = distinct !{!442, !"_ZN5pages13solver_layout7formulaB3v94B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29"}
!443 = !{!444, !446}
!444 = distinct !{!444, !445, !"_ZN5pages14event_location20restart_behind_eventB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!445 = distinct !{!445, !"_ZN5pages14event_location20restart_behind_eventB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!446 = distinct !{!446, !445, !"_ZN5pages14event_location20restart_behind_eventB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!447 = !{!448, !444, !446}
!448 = distinct !{!448, !449, !"_ZN5pages13solver_layout4failB3v81B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29: %retptr"}
!449 = distinct !{!449, !"_ZN5pages13solver_layout4failB3v81B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29"}
!450 = !{!451, !453}
!451 = distinct !{!451, !452, !"_ZN5pages8segments14at_segment_endB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!452 = distinct !{!452, !"_ZN5pages8segments14at_segment_endB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!453 = distinct !{!453, !454, !"_ZN5pages8segments11jump_statesB3v96B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!454 = distinct !{!454, !"_ZN5pages8segments11jump_statesB3v96B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!455 = !{!453}
!456 = !{!457, !459, !453}
!457 = distinct !{!457, !458, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!458 = distinct !{!458, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!459 = distinct !{!459, !458, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!460 = !{!461, !453}
!461 = distinct !{!461, !462, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!462 = distinct !{!462, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!463 = !{!464, !453}
!464 = distinct !{!464, !465, !"_ZN5pages8segments14at_segment_endB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!465 = distinct !{!465, !"_ZN5pages8segments14at_segment_endB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!466 = !{!467, !469, !453}
!467 = distinct !{!467, !468, !"_ZN5pages8segments11accept_jumpB3v98B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!468 = distinct !{!468, !"_ZN5pages8segments11accept_jumpB3v98B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!469 = distinct !{!469, !468, !"_ZN5pages8segments11accept_jumpB3v98B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!470 = !{!471, !467, !469, !453}
!471 = distinct !{!471, !472, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!472 = distinct !{!472, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!473 = !{!474, !476, !477, !479, !480, !482, !467, !469, !453}
!474 = distinct !{!474, !475, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!475 = distinct !{!475, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!476 = distinct !{!476, !475, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!477 = distinct !{!477, !478, !"_ZN5pages8segments13first_outsideB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2817_29: %retptr"}
!478 = distinct !{!478, !"_ZN5pages8segments13first_outsideB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2817_29"}
!479 = distinct !{!479, !478, !"_ZN5pages8segments13first_outsideB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2817_29: %excinfo"}
!480 = distinct !{!480, !481, !"_ZN5pages8segments12stop_outsideB3v99B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29: %retptr"}
!481 = distinct !{!481, !"_ZN5pages8segments12stop_outsideB3v99B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29"}
!482 = distinct !{!482, !481, !"_ZN5pages8segments12stop_outsideB3v99B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29: %excinfo"}
!483 = !{!477, !479, !480, !482, !467, !469, !453}
!484 = !{!485, !477, !479, !480, !482, !467, !469, !453}
!485 = distinct !{!485, !486, !"_ZN5pages13solver_layout10derivativeB4v101B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2814_29: %retptr"}
!486 = distinct !{!486, !"_ZN5pages13solver_layout10derivativeB4v101B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2814_29"}
!487 = !{!488, !477, !479, !480, !482, !467, !469, !453}
!488 = distinct !{!488, !489, !"_ZN5pages13solver_layout6decideB4v102B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_289_29: %retptr"}
!489 = distinct !{!489, !"_ZN5pages13solver_layout6decideB4v102B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_289_29"}
!490 = !{!491, !477, !479, !480, !482, !467, !469, !453}
!491 = distinct !{!491, !492, !"_ZN5pages13solver_layout6decideB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29: %retptr"}
!492 = distinct !{!492, !"_ZN5pages13solver_layout6decideB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29"}
!493 = !{!480, !482, !467, !469, !453}
!494 = !{!495, !480, !482, !467, !469, !453}
!495 = distinct !{!495, !496, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!496 = distinct !{!496, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!497 = !{!498, !500}
!498 = distinct !{!498, !499, !"_ZN5pages12time_stepper12end_segmentsB4v103B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!499 = distinct !{!499, !"_ZN5pages12time_stepper12end_segmentsB4v103B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!500 = distinct !{!500, !499, !"_ZN5pages12time_stepper12end_segmentsB4v103B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!501 = !{!502, !498, !500}
!502 = distinct !{!502, !503, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!503 = distinct !{!503, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!504 = !{!505, !507, !498, !500}
!505 = distinct !{!505, !506, !"_ZN5pages8segments13enter_segmentB4v104B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!506 = distinct !{!506, !"_ZN5pages8segments13enter_segmentB4v104B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!507 = distinct !{!507, !506, !"_ZN5pages8segments13enter_segmentB4v104B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!508 = !{!509, !511, !505, !507, !498, !500}
!509 = distinct !{!509, !510, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!510 = distinct !{!510, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!511 = distinct !{!511, !510, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!512 = !{!513, !498, !500}
!513 = distinct !{!513, !514, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!514 = distinct !{!514, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!515 = !{!516, !518, !513, !498, !500}
!516 = distinct !{!516, !517, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!517 = distinct !{!517, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!518 = distinct !{!518, !517, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!519 = !{!520, !522, !513, !498, !500}
!520 = distinct !{!520, !521, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!521 = distinct !{!521, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!522 = distinct !{!522, !521, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!523 = !{!524, !526, !498, !500}
!524 = distinct !{!524, !525, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!525 = distinct !{!525, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!526 = distinct !{!526, !525, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!527 = !{!528, !530}
!528 = distinct !{!528, !529, !"_ZN5pages12time_stepper11count_stepsB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!529 = distinct !{!529, !"_ZN5pages12time_stepper11count_stepsB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!530 = distinct !{!530, !529, !"_ZN5pages12time_stepper11count_stepsB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!531 = !{!532, !88, !90}
!532 = distinct !{!532, !533, !"_ZN5pages13solver_layout10derivativeB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_281_29: %retptr"}
!533 = distinct !{!533, !"_ZN5pages13solver_layout10derivativeB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_281_29"}
!534 = !{!535, !537, !88, !90}
!535 = distinct !{!535, !536, !"_ZN5pages8implicit13factor_matrixB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!536 = distinct !{!536, !"_ZN5pages8implicit13factor_matrixB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!537 = distinct !{!537, !536, !"_ZN5pages8implicit13factor_matrixB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!538 = !{!539, !541, !542, !535, !537, !88, !90}
!539 = distinct !{!539, !540, !"_ZN5pages8implicit11set_changesB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!540 = distinct !{!540, !"_ZN5pages8implicit11set_changesB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE"}
!541 = distinct !{!541, !540, !"_ZN5pages8implicit11set_changesB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!542 = distinct !{!542, !543, !"_ZN5pages8implicit13differentiateB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!543 = distinct !{!543, !"_ZN5pages8implicit13differentiateB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!544 = !{!542, !535, !537, !88, !90}
!545 = !{!546, !548, !542, !535, !537, !88, !90}
!546 = distinct !{!546, !547, !"_ZN5pages8implicit16difference_ratesB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!547 = distinct !{!547, !"_ZN5pages8implicit16difference_ratesB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!548 = distinct !{!548, !547, !"_ZN5pages8implicit16difference_ratesB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!549 = !{!550, !546, !548, !542, !535, !537, !88, !90}
!550 = distinct !{!550, !551, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!551 = distinct !{!551, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!552 = !{!553, !535, !537, !88, !90}
!553 = distinct !{!553, !554, !"_ZN5pages8implicit6factorB3v36B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!554 = distinct !{!554, !"_ZN5pages8implicit6factorB3v36B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!555 = !{!556, !558, !559, !88, !90}
!556 = distinct !{!556, !557, !"_ZN5pages8implicit12find_nonzeroB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx450Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!557 = distinct !{!557, !"_ZN5pages8implicit12find_nonzeroB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx450Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedEx"}
!558 = distinct !{!558, !557, !"_ZN5pages8implicit12find_nonzeroB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx450Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!559 = distinct !{!559, !560, !"_ZN5pages8implicit11solve_stageB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!560 = distinct !{!560, !"_ZN5pages8implicit11solve_stageB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!561 = !{!559, !88, !90}
!562 = !{!563, !565, !559, !88, !90}
!563 = distinct !{!563, !564, !"_ZN5pages8implicit5solveB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!564 = distinct !{!564, !"_ZN5pages8implicit5solveB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!565 = distinct !{!565, !564, !"_ZN5pages8implicit5solveB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!566 = !{!567, !88, !90}
!567 = distinct !{!567, !568, !"_ZN5pages13solver_layout7formulaB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_286_29: %retptr"}
!568 = distinct !{!568, !"_ZN5pages13solver_layout7formulaB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_286_29"}
!569 = !{!570, !88, !90}
!570 = distinct !{!570, !571, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!571 = distinct !{!571, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!572 = !{!573, !88, !90}
!573 = distinct !{!573, !574, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!574 = distinct !{!574, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
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
!592 = distinct !{!592, !593, !"_ZN5pages13solver_layout5retryB3v70B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!593 = distinct !{!593, !"_ZN5pages13solver_layout5retryB3v70B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!594 = !{!595, !597}
!595 = distinct !{!595, !596, !"_ZN5pages12event_checks14least_distanceB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!596 = distinct !{!596, !"_ZN5pages12event_checks14least_distanceB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!597 = distinct !{!597, !596, !"_ZN5pages12event_checks14least_distanceB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!598 = !{!599, !601}
!599 = distinct !{!599, !600, !"_ZN5pages12event_checks14least_distanceB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!600 = distinct !{!600, !"_ZN5pages12event_checks14least_distanceB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!601 = distinct !{!601, !600, !"_ZN5pages12event_checks14least_distanceB3v67B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!602 = !{!603, !605}
!603 = distinct !{!603, !604, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!604 = distinct !{!604, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!605 = distinct !{!605, !604, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}

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
  %v38 = load ptr, ptr %v37
  %v39 = getelementptr i64, ptr %v0, i64 18
  %v40 = load ptr, ptr %v39
  %v41 = getelementptr i64, ptr %v0, i64 19
  %v42 = load i64, ptr %v41
  %v43 = getelementptr i64, ptr %v0, i64 20
  %v44 = load i64, ptr %v43
  %v45 = getelementptr i64, ptr %v0, i64 21
  %v46 = load ptr, ptr %v45
  %v47 = getelementptr i64, ptr %v0, i64 22
  %v48 = load i64, ptr %v47
  %v49 = getelementptr i64, ptr %v0, i64 23
  %v50 = load i64, ptr %v49
  %v51 = getelementptr i64, ptr %v0, i64 24
  %v52 = load ptr, ptr %v51
  %v53 = getelementptr i64, ptr %v0, i64 25
  %v54 = load ptr, ptr %v53
  %v55 = getelementptr i64, ptr %v0, i64 26
  %v56 = load i64, ptr %v55
  %v57 = getelementptr i64, ptr %v0, i64 27
  %v58 = load i64, ptr %v57
  %v59 = getelementptr i64, ptr %v0, i64 28
  %v60 = load ptr, ptr %v59
  %v61 = getelementptr i64, ptr %v0, i64 29
  %v62 = load i64, ptr %v61
  %v63 = getelementptr i64, ptr %v0, i64 30
  %v64 = load i64, ptr %v63
  %v65 = getelementptr i64, ptr %v0, i64 31
  %v66 = load i64, ptr %v65
  %v67 = getelementptr i64, ptr %v0, i64 32
  %v68 = load i64, ptr %v67
  %v69 = getelementptr i64, ptr %v0, i64 33
  %v70 = load ptr, ptr %v69
  %v71 = getelementptr i64, ptr %v0, i64 34
  %v72 = load ptr, ptr %v71
  %v73 = getelementptr i64, ptr %v0, i64 35
  %v74 = load i64, ptr %v73
  %v75 = getelementptr i64, ptr %v0, i64 36
  %v76 = load i64, ptr %v75
  %v77 = getelementptr i64, ptr %v0, i64 37
  %v78 = load ptr, ptr %v77
  %v79 = getelementptr i64, ptr %v0, i64 38
  %v80 = load i64, ptr %v79
  %v81 = getelementptr i64, ptr %v0, i64 39
  %v82 = load i64, ptr %v81
  %v83 = getelementptr i64, ptr %v0, i64 40
  %v84 = load i64, ptr %v83
  %v85 = getelementptr i64, ptr %v0, i64 41
  %v86 = load i64, ptr %v85
  %v87 = getelementptr i64, ptr %v0, i64 42
  %v88 = load ptr, ptr %v87
  %v89 = getelementptr i64, ptr %v0, i64 43
  %v90 = load ptr, ptr %v89
  %v91 = getelementptr i64, ptr %v0, i64 44
  %v92 = load i64, ptr %v91
  %v93 = getelementptr i64, ptr %v0, i64 45
  %v94 = load i64, ptr %v93
  %v95 = getelementptr i64, ptr %v0, i64 46
  %v96 = load ptr, ptr %v95
  %v97 = getelementptr i64, ptr %v0, i64 47
  %v98 = load i64, ptr %v97
  %v99 = getelementptr i64, ptr %v0, i64 48
  %v100 = load i64, ptr %v99
  %v101 = getelementptr i64, ptr %v0, i64 49
  %v102 = load ptr, ptr %v101
  %v103 = getelementptr i64, ptr %v0, i64 50
  %v104 = load ptr, ptr %v103
  %v105 = getelementptr i64, ptr %v0, i64 51
  %v106 = load i64, ptr %v105
  %v107 = getelementptr i64, ptr %v0, i64 52
  %v108 = load i64, ptr %v107
  %v109 = getelementptr i64, ptr %v0, i64 53
  %v110 = load ptr, ptr %v109
  %v111 = getelementptr i64, ptr %v0, i64 54
  %v112 = load i64, ptr %v111
  %v113 = getelementptr i64, ptr %v0, i64 55
  %v114 = load i64, ptr %v113
  %v115 = getelementptr i64, ptr %v0, i64 56
  %v116 = load ptr, ptr %v115
  %v117 = getelementptr i64, ptr %v0, i64 57
  %v118 = load ptr, ptr %v117
  %v119 = getelementptr i64, ptr %v0, i64 58
  %v120 = load i64, ptr %v119
  %v121 = getelementptr i64, ptr %v0, i64 59
  %v122 = load i64, ptr %v121
  %v123 = getelementptr i64, ptr %v0, i64 60
  %v124 = load ptr, ptr %v123
  %v125 = getelementptr i64, ptr %v0, i64 61
  %v126 = load i64, ptr %v125
  %v127 = getelementptr i64, ptr %v0, i64 62
  %v128 = load i64, ptr %v127
  %v129 = getelementptr i64, ptr %v0, i64 63
  %v130 = load ptr, ptr %v129
  %v131 = getelementptr i64, ptr %v0, i64 64
  %v132 = load ptr, ptr %v131
  %v133 = getelementptr i64, ptr %v0, i64 65
  %v134 = load i64, ptr %v133
  %v135 = getelementptr i64, ptr %v0, i64 66
  %v136 = load i64, ptr %v135
  %v137 = getelementptr i64, ptr %v0, i64 67
  %v138 = load ptr, ptr %v137
  %v139 = getelementptr i64, ptr %v0, i64 68
  %v140 = load i64, ptr %v139
  %v141 = getelementptr i64, ptr %v0, i64 69
  %v142 = load i64, ptr %v141
  %v143 = getelementptr i64, ptr %v0, i64 70
  %v144 = load ptr, ptr %v143
  %v145 = getelementptr i64, ptr %v0, i64 71
  %v146 = load ptr, ptr %v145
  %v147 = getelementptr i64, ptr %v0, i64 72
  %v148 = load i64, ptr %v147
  %v149 = getelementptr i64, ptr %v0, i64 73
  %v150 = load i64, ptr %v149
  %v151 = getelementptr i64, ptr %v0, i64 74
  %v152 = load ptr, ptr %v151
  %v153 = getelementptr i64, ptr %v0, i64 75
  %v154 = load i64, ptr %v153
  %v155 = getelementptr i64, ptr %v0, i64 76
  %v156 = load i64, ptr %v155
  %v157 = getelementptr i64, ptr %v0, i64 77
  %v158 = load i64, ptr %v157
  %v159 = getelementptr i64, ptr %v0, i64 78
  %v160 = load i64, ptr %v159
  %v161 = getelementptr i64, ptr %v0, i64 79
  %v162 = load ptr, ptr %v161
  %v163 = getelementptr i64, ptr %v0, i64 80
  %v164 = load ptr, ptr %v163
  %v165 = getelementptr i64, ptr %v0, i64 81
  %v166 = load i64, ptr %v165
  %v167 = getelementptr i64, ptr %v0, i64 82
  %v168 = load i64, ptr %v167
  %v169 = getelementptr i64, ptr %v0, i64 83
  %v170 = load ptr, ptr %v169
  %v171 = getelementptr i64, ptr %v0, i64 84
  %v172 = load i64, ptr %v171
  %v173 = getelementptr i64, ptr %v0, i64 85
  %v174 = load i64, ptr %v173
  %v175 = getelementptr i64, ptr %v0, i64 86
  %v176 = load ptr, ptr %v175
  %v177 = getelementptr i64, ptr %v0, i64 87
  %v178 = load ptr, ptr %v177
  %v179 = getelementptr i64, ptr %v0, i64 88
  %v180 = load i64, ptr %v179
  %v181 = getelementptr i64, ptr %v0, i64 89
  %v182 = load i64, ptr %v181
  %v183 = getelementptr i64, ptr %v0, i64 90
  %v184 = load ptr, ptr %v183
  %v185 = getelementptr i64, ptr %v0, i64 91
  %v186 = load i64, ptr %v185
  %v187 = getelementptr i64, ptr %v0, i64 92
  %v188 = load i64, ptr %v187
  %v189 = getelementptr i64, ptr %v0, i64 93
  %v190 = load ptr, ptr %v189
  %v191 = getelementptr i64, ptr %v0, i64 94
  %v192 = load ptr, ptr %v191
  %v193 = getelementptr i64, ptr %v0, i64 95
  %v194 = load i64, ptr %v193
  %v195 = getelementptr i64, ptr %v0, i64 96
  %v196 = load i64, ptr %v195
  %v197 = getelementptr i64, ptr %v0, i64 97
  %v198 = load ptr, ptr %v197
  %v199 = getelementptr i64, ptr %v0, i64 98
  %v200 = load i64, ptr %v199
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
  %v212 = load ptr, ptr %v211
  %v213 = getelementptr i64, ptr %v0, i64 105
  %v214 = load ptr, ptr %v213
  %v215 = getelementptr i64, ptr %v0, i64 106
  %v216 = load i64, ptr %v215
  %v217 = getelementptr i64, ptr %v0, i64 107
  %v218 = load i64, ptr %v217
  %v219 = getelementptr i64, ptr %v0, i64 108
  %v220 = load ptr, ptr %v219
  %v221 = getelementptr i64, ptr %v0, i64 109
  %v222 = load i64, ptr %v221
  %v223 = getelementptr i64, ptr %v0, i64 110
  %v224 = load i64, ptr %v223
  %v225 = getelementptr i64, ptr %v0, i64 111
  %v226 = load ptr, ptr %v225
  %v227 = getelementptr i64, ptr %v0, i64 112
  %v228 = load ptr, ptr %v227
  %v229 = getelementptr i64, ptr %v0, i64 113
  %v230 = load i64, ptr %v229
  %v231 = getelementptr i64, ptr %v0, i64 114
  %v232 = load i64, ptr %v231
  %v233 = getelementptr i64, ptr %v0, i64 115
  %v234 = load ptr, ptr %v233
  %v235 = getelementptr i64, ptr %v0, i64 116
  %v236 = load i64, ptr %v235
  %v237 = getelementptr i64, ptr %v0, i64 117
  %v238 = load i64, ptr %v237
  %v239 = getelementptr i64, ptr %v0, i64 118
  %v240 = load ptr, ptr %v239
  %v241 = getelementptr i64, ptr %v0, i64 119
  %v242 = load ptr, ptr %v241
  %v243 = getelementptr i64, ptr %v0, i64 120
  %v244 = load i64, ptr %v243
  %v245 = getelementptr i64, ptr %v0, i64 121
  %v246 = load i64, ptr %v245
  %v247 = getelementptr i64, ptr %v0, i64 122
  %v248 = load ptr, ptr %v247
  %v249 = getelementptr i64, ptr %v0, i64 123
  %v250 = load i64, ptr %v249
  %v251 = getelementptr i64, ptr %v0, i64 124
  %v252 = load i64, ptr %v251
  %v253 = getelementptr i64, ptr %v0, i64 125
  %v254 = load i64, ptr %v253
  %v255 = getelementptr i64, ptr %v0, i64 126
  %v256 = load i64, ptr %v255
  %v257 = getelementptr i64, ptr %v0, i64 127
  %v258 = load ptr, ptr %v257
  %v259 = getelementptr i64, ptr %v0, i64 128
  %v260 = load ptr, ptr %v259
  %v261 = getelementptr i64, ptr %v0, i64 129
  %v262 = load i64, ptr %v261
  %v263 = getelementptr i64, ptr %v0, i64 130
  %v264 = load i64, ptr %v263
  %v265 = getelementptr i64, ptr %v0, i64 131
  %v266 = load ptr, ptr %v265
  %v267 = getelementptr i64, ptr %v0, i64 132
  %v268 = load i64, ptr %v267
  %v269 = getelementptr i64, ptr %v0, i64 133
  %v270 = load i64, ptr %v269
  %v271 = getelementptr i64, ptr %v0, i64 134
  %v272 = load i64, ptr %v271
  %v273 = getelementptr i64, ptr %v0, i64 135
  %v274 = load i64, ptr %v273
  %v275 = getelementptr i64, ptr %v0, i64 136
  %v276 = load ptr, ptr %v275
  %v277 = getelementptr i64, ptr %v0, i64 137
  %v278 = load ptr, ptr %v277
  %v279 = getelementptr i64, ptr %v0, i64 138
  %v280 = load i64, ptr %v279
  %v281 = getelementptr i64, ptr %v0, i64 139
  %v282 = load i64, ptr %v281
  %v283 = getelementptr i64, ptr %v0, i64 140
  %v284 = load ptr, ptr %v283
  %v285 = getelementptr i64, ptr %v0, i64 141
  %v286 = load i64, ptr %v285
  %v287 = getelementptr i64, ptr %v0, i64 142
  %v288 = load i64, ptr %v287
  %v289 = getelementptr i64, ptr %v0, i64 143
  %v290 = load i64, ptr %v289
  %v291 = getelementptr i64, ptr %v0, i64 144
  %v292 = load i64, ptr %v291
  %v293 = getelementptr i64, ptr %v0, i64 145
  %v294 = load ptr, ptr %v293
  %v295 = getelementptr i64, ptr %v0, i64 146
  %v296 = load ptr, ptr %v295
  %v297 = getelementptr i64, ptr %v0, i64 147
  %v298 = load i64, ptr %v297
  %v299 = getelementptr i64, ptr %v0, i64 148
  %v300 = load i64, ptr %v299
  %v301 = getelementptr i64, ptr %v0, i64 149
  %v302 = load ptr, ptr %v301
  %v303 = getelementptr i64, ptr %v0, i64 150
  %v304 = load i64, ptr %v303
  %v305 = getelementptr i64, ptr %v0, i64 151
  %v306 = load i64, ptr %v305
  %v307 = getelementptr i64, ptr %v0, i64 152
  %v308 = load ptr, ptr %v307
  %v309 = getelementptr i64, ptr %v0, i64 153
  %v310 = load ptr, ptr %v309
  %v311 = getelementptr i64, ptr %v0, i64 154
  %v312 = load i64, ptr %v311
  %v313 = getelementptr i64, ptr %v0, i64 155
  %v314 = load i64, ptr %v313
  %v315 = getelementptr i64, ptr %v0, i64 156
  %v316 = load ptr, ptr %v315
  %v317 = getelementptr i64, ptr %v0, i64 157
  %v318 = load i64, ptr %v317
  %v319 = getelementptr i64, ptr %v0, i64 158
  %v320 = load i64, ptr %v319
  %v321 = getelementptr i64, ptr %v0, i64 159
  %v322 = load ptr, ptr %v321
  %v323 = getelementptr i64, ptr %v0, i64 160
  %v324 = load ptr, ptr %v323
  %v325 = getelementptr i64, ptr %v0, i64 161
  %v326 = load i64, ptr %v325
  %v327 = getelementptr i64, ptr %v0, i64 162
  %v328 = load i64, ptr %v327
  %v329 = getelementptr i64, ptr %v0, i64 163
  %v330 = load ptr, ptr %v329
  %v331 = getelementptr i64, ptr %v0, i64 164
  %v332 = load i64, ptr %v331
  %v333 = getelementptr i64, ptr %v0, i64 165
  %v334 = load i64, ptr %v333
  %v335 = getelementptr i64, ptr %v0, i64 166
  %v336 = load ptr, ptr %v335
  %v337 = getelementptr i64, ptr %v0, i64 167
  %v338 = load ptr, ptr %v337
  %v339 = getelementptr i64, ptr %v0, i64 168
  %v340 = load i64, ptr %v339
  %v341 = getelementptr i64, ptr %v0, i64 169
  %v342 = load i64, ptr %v341
  %v343 = getelementptr i64, ptr %v0, i64 170
  %v344 = load ptr, ptr %v343
  %v345 = getelementptr i64, ptr %v0, i64 171
  %v346 = load i64, ptr %v345
  %v347 = getelementptr i64, ptr %v0, i64 172
  %v348 = load i64, ptr %v347
  %v349 = getelementptr i64, ptr %v0, i64 173
  %v350 = load ptr, ptr %v349
  %v351 = getelementptr i64, ptr %v0, i64 174
  %v352 = load ptr, ptr %v351
  %v353 = getelementptr i64, ptr %v0, i64 175
  %v354 = load i64, ptr %v353
  %v355 = getelementptr i64, ptr %v0, i64 176
  %v356 = load i64, ptr %v355
  %v357 = getelementptr i64, ptr %v0, i64 177
  %v358 = load ptr, ptr %v357
  %v359 = getelementptr i64, ptr %v0, i64 178
  %v360 = load i64, ptr %v359
  %v361 = getelementptr i64, ptr %v0, i64 179
  %v362 = load i64, ptr %v361
  %v363 = getelementptr i64, ptr %v0, i64 180
  %v364 = load ptr, ptr %v363
  %v365 = getelementptr i64, ptr %v0, i64 181
  %v366 = load ptr, ptr %v365
  %v367 = getelementptr i64, ptr %v0, i64 182
  %v368 = load i64, ptr %v367
  %v369 = getelementptr i64, ptr %v0, i64 183
  %v370 = load i64, ptr %v369
  %v371 = getelementptr i64, ptr %v0, i64 184
  %v372 = load ptr, ptr %v371
  %v373 = getelementptr i64, ptr %v0, i64 185
  %v374 = load i64, ptr %v373
  %v375 = getelementptr i64, ptr %v0, i64 186
  %v376 = load i64, ptr %v375
  %v377 = getelementptr i64, ptr %v0, i64 187
  %v378 = load ptr, ptr %v377
  %v379 = getelementptr i64, ptr %v0, i64 188
  %v380 = load ptr, ptr %v379
  %v381 = getelementptr i64, ptr %v0, i64 189
  %v382 = load i64, ptr %v381
  %v383 = getelementptr i64, ptr %v0, i64 190
  %v384 = load i64, ptr %v383
  %v385 = getelementptr i64, ptr %v0, i64 191
  %v386 = load ptr, ptr %v385
  %v387 = getelementptr i64, ptr %v0, i64 192
  %v388 = load i64, ptr %v387
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
  %v400 = load ptr, ptr %v399
  %v401 = getelementptr i64, ptr %v0, i64 199
  %v402 = load ptr, ptr %v401
  %v403 = getelementptr i64, ptr %v0, i64 200
  %v404 = load i64, ptr %v403
  %v405 = getelementptr i64, ptr %v0, i64 201
  %v406 = load i64, ptr %v405
  %v407 = getelementptr i64, ptr %v0, i64 202
  %v408 = load ptr, ptr %v407
  %v409 = getelementptr i64, ptr %v0, i64 203
  %v410 = load i64, ptr %v409
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
  %v422 = load ptr, ptr %v421
  %v423 = getelementptr i64, ptr %v0, i64 210
  %v424 = load ptr, ptr %v423
  %v425 = getelementptr i64, ptr %v0, i64 211
  %v426 = load i64, ptr %v425
  %v427 = getelementptr i64, ptr %v0, i64 212
  %v428 = load i64, ptr %v427
  %v429 = getelementptr i64, ptr %v0, i64 213
  %v430 = load ptr, ptr %v429
  %v431 = getelementptr i64, ptr %v0, i64 214
  %v432 = load i64, ptr %v431
  %v433 = getelementptr i64, ptr %v0, i64 215
  %v434 = load i64, ptr %v433
  %v435 = getelementptr i64, ptr %v0, i64 216
  %v436 = load ptr, ptr %v435
  %v437 = getelementptr i64, ptr %v0, i64 217
  %v438 = load ptr, ptr %v437
  %v439 = getelementptr i64, ptr %v0, i64 218
  %v440 = load i64, ptr %v439
  %v441 = getelementptr i64, ptr %v0, i64 219
  %v442 = load i64, ptr %v441
  %v443 = getelementptr i64, ptr %v0, i64 220
  %v444 = load ptr, ptr %v443
  %v445 = getelementptr i64, ptr %v0, i64 221
  %v446 = load i64, ptr %v445
  %v447 = getelementptr i64, ptr %v0, i64 222
  %v448 = load i64, ptr %v447
  %v449 = getelementptr i64, ptr %v0, i64 223
  %v450 = load ptr, ptr %v449
  %v451 = getelementptr i64, ptr %v0, i64 224
  %v452 = load ptr, ptr %v451
  %v453 = getelementptr i64, ptr %v0, i64 225
  %v454 = load i64, ptr %v453
  %v455 = getelementptr i64, ptr %v0, i64 226
  %v456 = load i64, ptr %v455
  %v457 = getelementptr i64, ptr %v0, i64 227
  %v458 = load ptr, ptr %v457
  %v459 = getelementptr i64, ptr %v0, i64 228
  %v460 = load i64, ptr %v459
  %v461 = getelementptr i64, ptr %v0, i64 229
  %v462 = load i64, ptr %v461
  %v463 = getelementptr i64, ptr %v0, i64 230
  %v464 = load ptr, ptr %v463
  %v465 = getelementptr i64, ptr %v0, i64 231
  %v466 = load ptr, ptr %v465
  %v467 = getelementptr i64, ptr %v0, i64 232
  %v468 = load i64, ptr %v467
  %v469 = getelementptr i64, ptr %v0, i64 233
  %v470 = load i64, ptr %v469
  %v471 = getelementptr i64, ptr %v0, i64 234
  %v472 = load ptr, ptr %v471
  %v473 = getelementptr i64, ptr %v0, i64 235
  %v474 = load i64, ptr %v473
  %v475 = getelementptr i64, ptr %v0, i64 236
  %v476 = load i64, ptr %v475
  %v477 = getelementptr i64, ptr %v0, i64 237
  %v478 = load ptr, ptr %v477
  %v479 = getelementptr i64, ptr %v0, i64 238
  %v480 = load ptr, ptr %v479
  %v481 = getelementptr i64, ptr %v0, i64 239
  %v482 = load i64, ptr %v481
  %v483 = getelementptr i64, ptr %v0, i64 240
  %v484 = load i64, ptr %v483
  %v485 = getelementptr i64, ptr %v0, i64 241
  %v486 = load ptr, ptr %v485
  %v487 = getelementptr i64, ptr %v0, i64 242
  %v488 = load i64, ptr %v487
  %v489 = getelementptr i64, ptr %v0, i64 243
  %v490 = load i64, ptr %v489
  %v491 = getelementptr i64, ptr %v0, i64 244
  %v492 = load ptr, ptr %v491
  %v493 = getelementptr i64, ptr %v0, i64 245
  %v494 = load ptr, ptr %v493
  %v495 = getelementptr i64, ptr %v0, i64 246
  %v496 = load i64, ptr %v495
  %v497 = getelementptr i64, ptr %v0, i64 247
  %v498 = load i64, ptr %v497
  %v499 = getelementptr i64, ptr %v0, i64 248
  %v500 = load ptr, ptr %v499
  %v501 = getelementptr i64, ptr %v0, i64 249
  %v502 = load i64, ptr %v501
  %v503 = getelementptr i64, ptr %v0, i64 250
  %v504 = load i64, ptr %v503
  %v505 = getelementptr i64, ptr %v0, i64 251
  %v506 = load i64, ptr %v505
  %v507 = getelementptr i64, ptr %v0, i64 252
  %v508 = load i64, ptr %v507
  %v509 = getelementptr i64, ptr %v0, i64 253
  %v510 = load ptr, ptr %v509
  %v511 = getelementptr i64, ptr %v0, i64 254
  %v512 = load ptr, ptr %v511
  %v513 = getelementptr i64, ptr %v0, i64 255
  %v514 = load i64, ptr %v513
  %v515 = getelementptr i64, ptr %v0, i64 256
  %v516 = load i64, ptr %v515
  %v517 = getelementptr i64, ptr %v0, i64 257
  %v518 = load ptr, ptr %v517
  %v519 = getelementptr i64, ptr %v0, i64 258
  %v520 = load i64, ptr %v519
  %v521 = getelementptr i64, ptr %v0, i64 259
  %v522 = load i64, ptr %v521
  %v523 = getelementptr i64, ptr %v0, i64 260
  %v524 = load ptr, ptr %v523
  %v525 = getelementptr i64, ptr %v0, i64 261
  %v526 = load ptr, ptr %v525
  %v527 = getelementptr i64, ptr %v0, i64 262
  %v528 = load i64, ptr %v527
  %v529 = getelementptr i64, ptr %v0, i64 263
  %v530 = load i64, ptr %v529
  %v531 = getelementptr i64, ptr %v0, i64 264
  %v532 = load ptr, ptr %v531
  %v533 = getelementptr i64, ptr %v0, i64 265
  %v534 = load i64, ptr %v533
  %v535 = getelementptr i64, ptr %v0, i64 266
  %v536 = load i64, ptr %v535
  %v537 = getelementptr i64, ptr %v0, i64 267
  %v538 = load ptr, ptr %v537
  %v539 = getelementptr i64, ptr %v0, i64 268
  %v540 = load ptr, ptr %v539
  %v541 = getelementptr i64, ptr %v0, i64 269
  %v542 = load i64, ptr %v541
  %v543 = getelementptr i64, ptr %v0, i64 270
  %v544 = load i64, ptr %v543
  %v545 = getelementptr i64, ptr %v0, i64 271
  %v546 = load ptr, ptr %v545
  %v547 = getelementptr i64, ptr %v0, i64 272
  %v548 = load i64, ptr %v547
  %v549 = getelementptr i64, ptr %v0, i64 273
  %v550 = load i64, ptr %v549
  %v551 = getelementptr i64, ptr %v0, i64 274
  %v552 = load ptr, ptr %v551
  %v553 = getelementptr i64, ptr %v0, i64 275
  %v554 = load ptr, ptr %v553
  %v555 = getelementptr i64, ptr %v0, i64 276
  %v556 = load i64, ptr %v555
  %v557 = getelementptr i64, ptr %v0, i64 277
  %v558 = load i64, ptr %v557
  %v559 = getelementptr i64, ptr %v0, i64 278
  %v560 = load ptr, ptr %v559
  %v561 = getelementptr i64, ptr %v0, i64 279
  %v562 = load i64, ptr %v561
  %v563 = getelementptr i64, ptr %v0, i64 280
  %v564 = load i64, ptr %v563
  %v565 = getelementptr i64, ptr %v0, i64 281
  %v566 = load ptr, ptr %v565
  %v567 = getelementptr i64, ptr %v0, i64 282
  %v568 = load ptr, ptr %v567
  %v569 = getelementptr i64, ptr %v0, i64 283
  %v570 = load i64, ptr %v569
  %v571 = getelementptr i64, ptr %v0, i64 284
  %v572 = load i64, ptr %v571
  %v573 = getelementptr i64, ptr %v0, i64 285
  %v574 = load ptr, ptr %v573
  %v575 = getelementptr i64, ptr %v0, i64 286
  %v576 = load i64, ptr %v575
  %v577 = getelementptr i64, ptr %v0, i64 287
  %v578 = load i64, ptr %v577
  %v579 = getelementptr i64, ptr %v0, i64 288
  %v580 = load ptr, ptr %v579
  %v581 = getelementptr i64, ptr %v0, i64 289
  %v582 = load ptr, ptr %v581
  %v583 = getelementptr i64, ptr %v0, i64 290
  %v584 = load i64, ptr %v583
  %v585 = getelementptr i64, ptr %v0, i64 291
  %v586 = load i64, ptr %v585
  %v587 = getelementptr i64, ptr %v0, i64 292
  %v588 = load ptr, ptr %v587
  %v589 = getelementptr i64, ptr %v0, i64 293
  %v590 = load i64, ptr %v589
  %v591 = getelementptr i64, ptr %v0, i64 294
  %v592 = load i64, ptr %v591
  %v593 = getelementptr i64, ptr %v0, i64 295
  %v594 = load i64, ptr %v593
  %v595 = getelementptr i64, ptr %v0, i64 296
  %v596 = load i64, ptr %v595
  %v597 = call i32 @advance_of_many(ptr %v1, ptr %v2, ptr %v4, ptr %v6, i64 %v8, i64 %v10, ptr %v12, i64 %v14, i64 %v16, i64 %v18, i64 %v20, i64 %v22, i64 %v24, i64 %v26, i64 %v28, i64 %v30, i64 %v32, i64 %v34, i64 %v36, ptr %v38, ptr %v40, i64 %v42, i64 %v44, ptr %v46, i64 %v48, i64 %v50, ptr %v52, ptr %v54, i64 %v56, i64 %v58, ptr %v60, i64 %v62, i64 %v64, i64 %v66, i64 %v68, ptr %v70, ptr %v72, i64 %v74, i64 %v76, ptr %v78, i64 %v80, i64 %v82, i64 %v84, i64 %v86, ptr %v88, ptr %v90, i64 %v92, i64 %v94, ptr %v96, i64 %v98, i64 %v100, ptr %v102, ptr %v104, i64 %v106, i64 %v108, ptr %v110, i64 %v112, i64 %v114, ptr %v116, ptr %v118, i64 %v120, i64 %v122, ptr %v124, i64 %v126, i64 %v128, ptr %v130, ptr %v132, i64 %v134, i64 %v136, ptr %v138, i64 %v140, i64 %v142, ptr %v144, ptr %v146, i64 %v148, i64 %v150, ptr %v152, i64 %v154, i64 %v156, i64 %v158, i64 %v160, ptr %v162, ptr %v164, i64 %v166, i64 %v168, ptr %v170, i64 %v172, i64 %v174, ptr %v176, ptr %v178, i64 %v180, i64 %v182, ptr %v184, i64 %v186, i64 %v188, ptr %v190, ptr %v192, i64 %v194, i64 %v196, ptr %v198, i64 %v200, i64 %v202, i64 %v204, i64 %v206, i64 %v208, i64 %v210, ptr %v212, ptr %v214, i64 %v216, i64 %v218, ptr %v220, i64 %v222, i64 %v224, ptr %v226, ptr %v228, i64 %v230, i64 %v232, ptr %v234, i64 %v236, i64 %v238, ptr %v240, ptr %v242, i64 %v244, i64 %v246, ptr %v248, i64 %v250, i64 %v252, i64 %v254, i64 %v256, ptr %v258, ptr %v260, i64 %v262, i64 %v264, ptr %v266, i64 %v268, i64 %v270, i64 %v272, i64 %v274, ptr %v276, ptr %v278, i64 %v280, i64 %v282, ptr %v284, i64 %v286, i64 %v288, i64 %v290, i64 %v292, ptr %v294, ptr %v296, i64 %v298, i64 %v300, ptr %v302, i64 %v304, i64 %v306, ptr %v308, ptr %v310, i64 %v312, i64 %v314, ptr %v316, i64 %v318, i64 %v320, ptr %v322, ptr %v324, i64 %v326, i64 %v328, ptr %v330, i64 %v332, i64 %v334, ptr %v336, ptr %v338, i64 %v340, i64 %v342, ptr %v344, i64 %v346, i64 %v348, ptr %v350, ptr %v352, i64 %v354, i64 %v356, ptr %v358, i64 %v360, i64 %v362, ptr %v364, ptr %v366, i64 %v368, i64 %v370, ptr %v372, i64 %v374, i64 %v376, ptr %v378, ptr %v380, i64 %v382, i64 %v384, ptr %v386, i64 %v388, i64 %v390, i64 %v392, i64 %v394, i64 %v396, i64 %v398, ptr %v400, ptr %v402, i64 %v404, i64 %v406, ptr %v408, i64 %v410, i64 %v412, i64 %v414, i64 %v416, i64 %v418, i64 %v420, ptr %v422, ptr %v424, i64 %v426, i64 %v428, ptr %v430, i64 %v432, i64 %v434, ptr %v436, ptr %v438, i64 %v440, i64 %v442, ptr %v444, i64 %v446, i64 %v448, ptr %v450, ptr %v452, i64 %v454, i64 %v456, ptr %v458, i64 %v460, i64 %v462, ptr %v464, ptr %v466, i64 %v468, i64 %v470, ptr %v472, i64 %v474, i64 %v476, ptr %v478, ptr %v480, i64 %v482, i64 %v484, ptr %v486, i64 %v488, i64 %v490, ptr %v492, ptr %v494, i64 %v496, i64 %v498, ptr %v500, i64 %v502, i64 %v504, i64 %v506, i64 %v508, ptr %v510, ptr %v512, i64 %v514, i64 %v516, ptr %v518, i64 %v520, i64 %v522, ptr %v524, ptr %v526, i64 %v528, i64 %v530, ptr %v532, i64 %v534, i64 %v536, ptr %v538, ptr %v540, i64 %v542, i64 %v544, ptr %v546, i64 %v548, i64 %v550, ptr %v552, ptr %v554, i64 %v556, i64 %v558, ptr %v560, i64 %v562, i64 %v564, ptr %v566, ptr %v568, i64 %v570, i64 %v572, ptr %v574, i64 %v576, i64 %v578, ptr %v580, ptr %v582, i64 %v584, i64 %v586, ptr %v588, i64 %v590, i64 %v592, i64 %v594, i64 %v596)
  %v598 = load i64, ptr %v1
  ret i64 %v598
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

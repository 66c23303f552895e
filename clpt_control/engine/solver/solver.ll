; sha256 d6a3c9920a0697f23a39ee5a221adde43baa2bbce34e33bce1c6bca82292ea03 6b01d44766309987d5ec53a31dd813652eb99ca4e05cc4fe5005f65c73ab1d55, Python 3.11, numba 0.68.1

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
@switch.table._ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7 = private unnamed_addr constant [18 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00, double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00], align 8

define dso_local range(i32 0, 2) i32 @advance_of_many(ptr noalias %v0, ptr noalias %v1, ptr readnone %v2, ptr readnone %v3, i64 %v4, i64 %v5, ptr readonly %v6, i64 %v7, i64 %v8, i64 %v9, i64 %v10, i64 %v11, i64 %v12, i64 %v13, i64 %v14, i64 %v15, i64 %v16, i64 %v17, i64 %v18, i64 %v19, ptr readnone %v20, ptr readnone %v21, i64 %v22, i64 %v23, ptr %v24, i64 %v25, i64 %v26, ptr readnone %v27, ptr readnone %v28, i64 %v29, i64 %v30, ptr readonly %v31, i64 %v32, i64 %v33, i64 %v34, i64 %v35, ptr readnone %v36, ptr readnone %v37, i64 %v38, i64 %v39, ptr readonly %v40, i64 %v41, i64 %v42, i64 %v43, i64 %v44, ptr readnone %v45, ptr readnone %v46, i64 %v47, i64 %v48, ptr readonly %v49, i64 %v50, i64 %v51, ptr readnone %v52, ptr readnone %v53, i64 %v54, i64 %v55, ptr readonly %v56, i64 %v57, i64 %v58, ptr readnone %v59, ptr readnone %v60, i64 %v61, i64 %v62, ptr readonly %v63, i64 %v64, i64 %v65, ptr readnone %v66, ptr readnone %v67, i64 %v68, i64 %v69, ptr readonly %v70, i64 %v71, i64 %v72, ptr readnone %v73, ptr readnone %v74, i64 %v75, i64 %v76, ptr readonly %v77, i64 %v78, i64 %v79, i64 %v80, i64 %v81, ptr readnone %v82, ptr readnone %v83, i64 %v84, i64 %v85, ptr readonly %v86, i64 %v87, i64 %v88, ptr readnone %v89, ptr readnone %v90, i64 %v91, i64 %v92, ptr readonly %v93, i64 %v94, i64 %v95, ptr readnone %v96, ptr readnone %v97, i64 %v98, i64 %v99, ptr %v100, i64 %v101, i64 %v102, i64 %v103, i64 %v104, i64 %v105, i64 %v106, ptr readnone %v107, ptr readnone %v108, i64 %v109, i64 %v110, ptr %v111, i64 %v112, i64 %v113, ptr readnone %v114, ptr readnone %v115, i64 %v116, i64 %v117, ptr %v118, i64 %v119, i64 %v120, ptr readnone %v121, ptr readnone %v122, i64 %v123, i64 %v124, ptr %v125, i64 %v126, i64 %v127, i64 %v128, i64 %v129, ptr readnone %v130, ptr readnone %v131, i64 %v132, i64 %v133, ptr %v134, i64 %v135, i64 %v136, i64 %v137, i64 %v138, ptr readnone %v139, ptr readnone %v140, i64 %v141, i64 %v142, ptr %v143, i64 %v144, i64 %v145, i64 %v146, i64 %v147, ptr readnone %v148, ptr readnone %v149, i64 %v150, i64 %v151, ptr %v152, i64 %v153, i64 %v154, ptr readnone %v155, ptr readnone %v156, i64 %v157, i64 %v158, ptr %v159, i64 %v160, i64 %v161, ptr readnone %v162, ptr readnone %v163, i64 %v164, i64 %v165, ptr %v166, i64 %v167, i64 %v168, ptr readnone %v169, ptr readnone %v170, i64 %v171, i64 %v172, ptr %v173, i64 %v174, i64 %v175, ptr readnone %v176, ptr readnone %v177, i64 %v178, i64 %v179, ptr %v180, i64 %v181, i64 %v182, ptr readnone %v183, ptr readnone %v184, i64 %v185, i64 %v186, ptr %v187, i64 %v188, i64 %v189, ptr readnone %v190, ptr readnone %v191, i64 %v192, i64 %v193, ptr %v194, i64 %v195, i64 %v196, i64 %v197, i64 %v198, i64 %v199, i64 %v200, ptr readnone %v201, ptr readnone %v202, i64 %v203, i64 %v204, ptr %v205, i64 %v206, i64 %v207, i64 %v208, i64 %v209, i64 %v210, i64 %v211, ptr readnone %v212, ptr readnone %v213, i64 %v214, i64 %v215, ptr readonly %v216, i64 %v217, i64 %v218, ptr readnone %v219, ptr readnone %v220, i64 %v221, i64 %v222, ptr %v223, i64 %v224, i64 %v225, ptr readnone %v226, ptr readnone %v227, i64 %v228, i64 %v229, ptr %v230, i64 %v231, i64 %v232, ptr readnone %v233, ptr readnone %v234, i64 %v235, i64 %v236, ptr %v237, i64 %v238, i64 %v239, i64 %v240, i64 %v241, ptr readnone %v242, ptr readnone %v243, i64 %v244, i64 %v245, ptr readonly %v246, i64 %v247, i64 %v248, ptr readnone %v249, ptr readnone %v250, i64 %v251, i64 %v252, ptr readonly %v253, i64 %v254, i64 %v255, ptr readnone %v256, ptr readnone %v257, i64 %v258, i64 %v259, ptr readonly %v260, i64 %v261, i64 %v262, ptr readnone %v263, ptr readnone %v264, i64 %v265, i64 %v266, ptr readonly %v267, i64 %v268, i64 %v269, ptr readnone %v270, ptr readnone %v271, i64 %v272, i64 %v273, ptr readonly %v274, i64 %v275, i64 %v276, ptr readnone %v277, ptr readnone %v278, i64 %v279, i64 %v280, ptr readonly %v281, i64 %v282, i64 %v283, i64 %v284, i64 %v285) local_unnamed_addr {
v286:
  %v287 = alloca i8, align 1
  %v288 = alloca ptr, align 8
  %v289 = alloca i8, align 1
  %v290 = alloca ptr, align 8
  %v291 = icmp sgt i64 %v16, 0
  %v292 = icmp sgt i64 %v19, 0
  %v293 = select i1 %v291, i1 true, i1 %v292
  %v294 = icmp slt i64 %v9, 1
  %v295 = select i1 %v294, i64 0, i64 %v9
  br i1 %v294, label %v296, label %v297

v297:
  %v298 = mul i64 %v136, 24
  %v299 = getelementptr i8, ptr %v134, i64 %v298
  %v300 = getelementptr i8, ptr %v152, i64 8
  %v301 = getelementptr i8, ptr %v152, i64 16
  %v302 = getelementptr i64, ptr %v143, i64 %v145
  %v303 = shl i64 %v145, 4
  %v304 = getelementptr i8, ptr %v143, i64 %v303
  %v305 = mul i64 %v145, 24
  %v306 = getelementptr i8, ptr %v143, i64 %v305
  %v307 = icmp slt i64 %v42, 1
  %v308 = icmp slt i64 %v64, 1
  %v309 = icmp slt i64 %v10, 1
  %v310 = mul i64 %v136, 248
  %v311 = getelementptr i8, ptr %v134, i64 %v310
  %v312 = mul i64 %v136, 240
  %v313 = getelementptr i8, ptr %v134, i64 %v312
  %v314 = mul i64 %v136, 232
  %v315 = getelementptr i8, ptr %v134, i64 %v314
  %v316 = shl i64 %v136, 4
  %v317 = shl i64 %v136, 5
  %v318 = mul i64 %v136, 40
  %v319 = mul i64 %v136, 48
  %v320 = mul i64 %v136, 56
  %v321 = shl i64 %v136, 6
  %v322 = mul i64 %v136, 72
  %v323 = mul i64 %v136, 80
  %v324 = mul i64 %v136, 88
  %v325 = mul i64 %v136, 96
  %v326 = mul i64 %v136, 104
  %v327 = mul i64 %v136, 112
  %v328 = mul i64 %v136, 120
  %v329 = shl i64 %v136, 7
  %v330 = mul i64 %v136, 136
  %v331 = mul i64 %v136, 144
  %v332 = mul i64 %v136, 152
  %v333 = mul i64 %v136, 160
  %v334 = mul i64 %v136, 168
  %v335 = mul i64 %v136, 176
  %v336 = mul i64 %v136, 184
  %v337 = mul i64 %v136, 192
  %v338 = mul i64 %v136, 200
  %v339 = mul i64 %v136, 208
  %v340 = mul i64 %v136, 216
  %v341 = mul i64 %v136, 224
  %v342 = getelementptr i8, ptr %v134, i64 %v328
  %v343 = getelementptr i8, ptr %v134, i64 %v341
  %v344 = getelementptr i8, ptr %v134, i64 %v316
  br label %v345

v346:
  %v347 = getelementptr double, ptr %v299, i64 %v348
  store double 0.000000e+00, ptr %v347, align 8, !noalias !0
  %v349 = load i64, ptr %v152, align 8, !noalias !0
  %v350 = load i64, ptr %v300, align 8, !noalias !0
  %v351 = icmp eq i64 %v349, %v350
  br i1 %v351, label %v352, label %v353

v353:
  %v354 = add nsw i64 %v349, 1
  store i64 %v354, ptr %v152, align 8, !noalias !0
  store i64 2, ptr %v301, align 8, !noalias !0
  %v355 = getelementptr i64, ptr %v143, i64 %v348
  store i64 %v349, ptr %v355, align 8, !noalias !0
  %v356 = icmp slt i64 %v349, 0
  %v357 = select i1 %v356, i64 %v50, i64 0
  %v358 = getelementptr i64, ptr %v49, i64 %v349
  %v359 = getelementptr i64, ptr %v358, i64 %v357
  %v360 = load i64, ptr %v359, align 8, !noalias !0
  %v361 = icmp slt i64 %v360, 0
  %v362 = select i1 %v361, i64 %v57, i64 0
  %v363 = getelementptr i64, ptr %v56, i64 %v360
  %v364 = getelementptr i64, ptr %v363, i64 %v362
  %v365 = load i64, ptr %v364, align 8, !noalias !0
  %v366 = getelementptr i64, ptr %v302, i64 %v348
  store i64 %v365, ptr %v366, align 8, !noalias !0
  %v367 = getelementptr i64, ptr %v304, i64 %v348
  store i64 1, ptr %v367, align 8, !noalias !0
  %v368 = getelementptr i64, ptr %v306, i64 %v348
  store i64 0, ptr %v368, align 8, !noalias !0
  br i1 %v307, label %v369, label %v370

v370:
  %v371 = select i1 %v356, i64 %v41, i64 0
  %v372 = add i64 %v371, %v349
  %v373 = mul i64 %v372, %v42
  %v374 = getelementptr double, ptr %v40, i64 %v373
  %v375 = getelementptr double, ptr %v166, i64 %v348
  br label %v376

v369:
  br i1 %v308, label %v377, label %v378

v378:
  %v379 = load i64, ptr %v366, align 8, !noalias !0
  %v380 = icmp slt i64 %v379, 0
  %v381 = select i1 %v380, i64 %v78, i64 0
  %v382 = add i64 %v381, %v379
  %v383 = mul i64 %v382, %v79
  %v384 = getelementptr double, ptr %v77, i64 %v383
  br label %v385

v385:
  %v386 = phi i64 [ 0, %v378 ], [ %v387, %v385 ]
  %v387 = add nsw i64 %v386, 1
  %v388 = getelementptr double, ptr %v384, i64 %v386
  %v389 = load double, ptr %v388, align 8, !noalias !3
  %v390 = getelementptr i64, ptr %v63, i64 %v386
  %v391 = load i64, ptr %v390, align 8, !noalias !3
  %v392 = mul nsw i64 %v391, %v9
  %v393 = add nsw i64 %v392, %v348
  %v394 = icmp slt i64 %v393, 0
  %v395 = select i1 %v394, i64 %v167, i64 0
  %v396 = getelementptr double, ptr %v166, i64 %v393
  %v397 = getelementptr double, ptr %v396, i64 %v395
  store double %v389, ptr %v397, align 8, !noalias !3
  %v398 = icmp eq i64 %v387, %v64
  br i1 %v398, label %v377, label %v385

v399:
  %v400 = getelementptr double, ptr %v134, i64 %v348
  %v401 = getelementptr double, ptr %v311, i64 %v348
  %v402 = load double, ptr %v401, align 8, !noalias !7
  %v403 = getelementptr double, ptr %v313, i64 %v348
  %v404 = load double, ptr %v403, align 8, !noalias !7
  %v405 = getelementptr double, ptr %v315, i64 %v348
  %v406 = load double, ptr %v405, align 8, !noalias !7
  store double 0.000000e+00, ptr %v400, align 8, !noalias !7
  %v407 = getelementptr double, ptr %v400, i64 %v136
  store double 0.000000e+00, ptr %v407, align 8, !noalias !7
  %v408 = getelementptr i8, ptr %v400, i64 %v316
  store double 0.000000e+00, ptr %v408, align 8, !noalias !7
  %v409 = getelementptr i8, ptr %v400, i64 %v298
  store double 0.000000e+00, ptr %v409, align 8, !noalias !7
  %v410 = getelementptr i8, ptr %v400, i64 %v317
  store double 0.000000e+00, ptr %v410, align 8, !noalias !7
  %v411 = getelementptr i8, ptr %v400, i64 %v318
  store double 0.000000e+00, ptr %v411, align 8, !noalias !7
  %v412 = getelementptr i8, ptr %v400, i64 %v319
  store double 0.000000e+00, ptr %v412, align 8, !noalias !7
  %v413 = getelementptr i8, ptr %v400, i64 %v320
  store double 0.000000e+00, ptr %v413, align 8, !noalias !7
  %v414 = getelementptr i8, ptr %v400, i64 %v321
  store double 0.000000e+00, ptr %v414, align 8, !noalias !7
  %v415 = getelementptr i8, ptr %v400, i64 %v322
  store double 0.000000e+00, ptr %v415, align 8, !noalias !7
  %v416 = getelementptr i8, ptr %v400, i64 %v323
  store double 0.000000e+00, ptr %v416, align 8, !noalias !7
  %v417 = getelementptr i8, ptr %v400, i64 %v324
  store double 0.000000e+00, ptr %v417, align 8, !noalias !7
  %v418 = getelementptr i8, ptr %v400, i64 %v325
  store double 0.000000e+00, ptr %v418, align 8, !noalias !7
  %v419 = getelementptr i8, ptr %v400, i64 %v326
  store double 0.000000e+00, ptr %v419, align 8, !noalias !7
  %v420 = getelementptr i8, ptr %v400, i64 %v327
  store double 0.000000e+00, ptr %v420, align 8, !noalias !7
  %v421 = getelementptr i8, ptr %v400, i64 %v328
  store double 0.000000e+00, ptr %v421, align 8, !noalias !7
  %v422 = getelementptr i8, ptr %v400, i64 %v329
  store double 0.000000e+00, ptr %v422, align 8, !noalias !7
  %v423 = getelementptr i8, ptr %v400, i64 %v330
  store double 0.000000e+00, ptr %v423, align 8, !noalias !7
  %v424 = getelementptr i8, ptr %v400, i64 %v331
  store double 0.000000e+00, ptr %v424, align 8, !noalias !7
  %v425 = getelementptr i8, ptr %v400, i64 %v332
  store double 0.000000e+00, ptr %v425, align 8, !noalias !7
  %v426 = getelementptr i8, ptr %v400, i64 %v333
  store double 0.000000e+00, ptr %v426, align 8, !noalias !7
  %v427 = getelementptr i8, ptr %v400, i64 %v334
  store double 0.000000e+00, ptr %v427, align 8, !noalias !7
  %v428 = getelementptr i8, ptr %v400, i64 %v335
  store double 0.000000e+00, ptr %v428, align 8, !noalias !7
  %v429 = getelementptr i8, ptr %v400, i64 %v336
  store double 0.000000e+00, ptr %v429, align 8, !noalias !7
  %v430 = getelementptr i8, ptr %v400, i64 %v337
  store double 0.000000e+00, ptr %v430, align 8, !noalias !7
  %v431 = getelementptr i8, ptr %v400, i64 %v338
  store double 0.000000e+00, ptr %v431, align 8, !noalias !7
  %v432 = getelementptr i8, ptr %v400, i64 %v339
  store double 0.000000e+00, ptr %v432, align 8, !noalias !7
  %v433 = getelementptr i8, ptr %v400, i64 %v340
  store double 0.000000e+00, ptr %v433, align 8, !noalias !7
  %v434 = getelementptr i8, ptr %v400, i64 %v341
  store double 0.000000e+00, ptr %v434, align 8, !noalias !7
  %v435 = getelementptr i8, ptr %v400, i64 %v314
  store double 0.000000e+00, ptr %v435, align 8, !noalias !7
  %v436 = getelementptr i8, ptr %v400, i64 %v312
  store double 0.000000e+00, ptr %v436, align 8, !noalias !7
  %v437 = getelementptr i8, ptr %v400, i64 %v310
  store double 0.000000e+00, ptr %v437, align 8, !noalias !7
  %v438 = fcmp oeq double %v406, 0xFFF0000000000000
  %v439 = select i1 %v438, double 0xFFF0000000000000, double 0.000000e+00
  store double %v439, ptr %v405, align 8, !noalias !7
  store double %v404, ptr %v403, align 8, !noalias !7
  store double %v402, ptr %v401, align 8, !noalias !7
  store double 1.000000e+00, ptr %v347, align 8, !noalias !7
  %v440 = getelementptr double, ptr %v342, i64 %v348
  store double 0xFFF0000000000000, ptr %v440, align 8, !noalias !7
  %v441 = getelementptr double, ptr %v343, i64 %v348
  store double 0x7FF0000000000000, ptr %v441, align 8, !noalias !7
  %v442 = load double, ptr %v93, align 8, !noalias !0
  store double %v442, ptr %v400, align 8, !noalias !0
  %v443 = load i64, ptr %v366, align 8, !noalias !0
  %v444 = icmp slt i64 %v443, 0
  %v445 = select i1 %v444, i64 %v71, i64 0
  %v446 = getelementptr double, ptr %v70, i64 %v443
  %v447 = getelementptr double, ptr %v446, i64 %v445
  %v448 = load double, ptr %v447, align 8, !noalias !0
  %v449 = getelementptr double, ptr %v344, i64 %v348
  store double %v448, ptr %v449, align 8, !noalias !0
  br label %v352

v376:
  %v450 = phi i64 [ 0, %v370 ], [ %v451, %v376 ]
  %v451 = add nsw i64 %v450, 1
  %v452 = getelementptr double, ptr %v374, i64 %v450
  %v453 = load double, ptr %v452, align 8, !noalias !0
  %v454 = mul nsw i64 %v450, %v9
  %v455 = getelementptr double, ptr %v375, i64 %v454
  store double %v453, ptr %v455, align 8, !noalias !0
  %v456 = icmp eq i64 %v451, %v42
  br i1 %v456, label %v369, label %v376

v377:
  br i1 %v309, label %v399, label %v457

v457:
  %v458 = getelementptr double, ptr %v194, i64 %v348
  %v459 = select i1 %v356, i64 %v32, i64 0
  %v460 = add i64 %v459, %v349
  %v461 = mul i64 %v460, %v33
  %v462 = getelementptr double, ptr %v31, i64 %v461
  br label %v463

v463:
  %v464 = phi i64 [ 0, %v457 ], [ %v465, %v463 ]
  %v465 = add nsw i64 %v464, 1
  %v466 = getelementptr double, ptr %v462, i64 %v464
  %v467 = load double, ptr %v466, align 8, !noalias !0
  %v468 = mul i64 %v464, %v197
  %v469 = getelementptr double, ptr %v458, i64 %v468
  store double %v467, ptr %v469, align 8, !noalias !0
  %v470 = icmp eq i64 %v465, %v10
  br i1 %v470, label %v399, label %v463

v352:
  %v471 = load i64, ptr %v472, align 8
  %v473 = icmp sgt i64 %v471, -1
  %v474 = zext i1 %v473 to i64
  %v475 = add nsw i64 %v476, %v474
  %v477 = icmp sgt i64 %v478, 1
  br i1 %v477, label %v345, label %v296

v296:
  %v479 = phi i64 [ 0, %v286 ], [ %v475, %v352 ]
  %v480 = icmp ne i64 %v479, 0
  %v481 = icmp sgt i64 %v284, 0
  %v482 = select i1 %v480, i1 %v481, i1 false
  br i1 %v482, label %v483, label %v484

v483:
  %v485 = getelementptr i8, ptr %v152, i64 16
  %v486 = mul i64 %v10, %v9
  %v487 = shl i64 %v197, 7
  %v488 = mul i64 %v208, %v207
  %v489 = getelementptr i8, ptr %v6, i64 8
  %v490 = getelementptr i8, ptr %v6, i64 32
  %v491 = mul i64 %v136, 24
  %v492 = getelementptr i8, ptr %v134, i64 %v491
  %v493 = icmp sgt i64 %v19, 0
  %v494 = getelementptr i8, ptr %v6, i64 32
  %v495 = mul i64 %v136, 24
  %v496 = getelementptr i8, ptr %v134, i64 %v495
  %v497 = icmp slt i64 %v19, 1
  %v498 = icmp sgt i64 %v13, 0
  %v499 = mul nsw i64 %v10, %v9
  %v500 = shl i64 %v499, 4
  %v501 = getelementptr i8, ptr %v159, i64 %v500
  %v502 = getelementptr i8, ptr %v6, i64 56
  %v503 = getelementptr i8, ptr %v6, i64 64
  %v504 = shl i64 %v136, 6
  %v505 = getelementptr i8, ptr %v134, i64 %v504
  %v506 = mul i64 %v499, 136
  %v507 = getelementptr i8, ptr %v159, i64 %v506
  %v508 = mul i64 %v499, 24
  %v509 = getelementptr i8, ptr %v159, i64 %v508
  %v510 = getelementptr i8, ptr %v6, i64 72
  %v511 = mul i64 %v486, 112
  %v512 = mul i64 %v136, 24
  %v513 = getelementptr i8, ptr %v134, i64 %v512
  %v514 = shl i64 %v136, 5
  %v515 = getelementptr i8, ptr %v134, i64 %v514
  %v516 = mul i64 %v136, 248
  %v517 = getelementptr i8, ptr %v134, i64 %v516
  %v518 = select i1 %v498, i64 2, i64 0
  %v519 = icmp slt i64 %v15, 1
  %v520 = zext i1 %v519 to i64
  %v521 = mul i64 %v136, 88
  %v522 = getelementptr i8, ptr %v134, i64 %v521
  %v523 = getelementptr double, ptr %v93, i64 %v94
  %v524 = getelementptr i8, ptr %v523, i64 -8
  %v525 = shl i64 %v136, 6
  %v526 = getelementptr i8, ptr %v134, i64 %v525
  %v527 = getelementptr i8, ptr %v159, i64 %v511
  %v528 = icmp slt i64 %v10, 1
  %v529 = mul i64 %v197, %v196
  %v530 = mul i64 %v529, 112
  %v531 = getelementptr i8, ptr %v194, i64 %v530
  %v532 = shl i64 %v529, 7
  %v533 = getelementptr i8, ptr %v194, i64 %v532
  %v534 = getelementptr i8, ptr %v6, i64 32
  %v535 = mul i64 %v208, 216
  %v536 = getelementptr i8, ptr %v187, i64 %v535
  %v537 = shl i64 %v10, 7
  %v538 = getelementptr i8, ptr %v159, i64 %v537
  %v539 = mul i64 %v208, 240
  %v540 = getelementptr i8, ptr %v187, i64 %v539
  %v541 = sub i64 %v208, %v19
  %v542 = tail call i64 @llvm.smax.i64(i64 %v541, i64 0)
  %v543 = getelementptr double, ptr %v205, i64 %v208
  %v544 = mul i64 %v208, %v207
  %v545 = mul i64 %v544, 80
  %v546 = getelementptr i8, ptr %v543, i64 %v545
  %v547 = mul i64 %v544, 72
  %v548 = getelementptr i8, ptr %v205, i64 %v547
  %v549 = getelementptr double, ptr %v548, i64 %v208
  %v550 = shl i64 %v208, 4
  %v551 = getelementptr i8, ptr %v548, i64 %v550
  %v552 = shl i64 %v145, 5
  %v553 = getelementptr i8, ptr %v143, i64 %v552
  %v554 = shl i64 %v136, 4
  %v555 = getelementptr i8, ptr %v134, i64 %v554
  %v556 = mul i64 %v136, 112
  %v557 = getelementptr i8, ptr %v134, i64 %v556
  %v558 = shl i64 %v136, 4
  %v559 = getelementptr i8, ptr %v134, i64 %v558
  %v560 = mul i64 %v136, 168
  %v561 = getelementptr i8, ptr %v134, i64 %v560
  %v562 = shl i64 %v145, 4
  %v563 = getelementptr i8, ptr %v143, i64 %v562
  %v564 = getelementptr i8, ptr %v6, i64 40
  %v565 = icmp eq i64 %v13, 0
  %v566 = mul nsw i64 %v10, %v9
  %v567 = getelementptr double, ptr %v159, i64 %v566
  %v568 = icmp sgt i64 %v14, 0
  %v569 = shl i64 %v136, 5
  %v570 = getelementptr i8, ptr %v134, i64 %v569
  %v571 = icmp slt i64 %v10, 1
  %v572 = mul i64 %v197, %v196
  %v573 = mul i64 %v572, 136
  %v574 = getelementptr i8, ptr %v194, i64 %v573
  %v575 = mul i64 %v572, 88
  %v576 = getelementptr i8, ptr %v194, i64 %v575
  %v577 = mul nsw i64 %v10, 19
  %v578 = add nsw i64 %v577, 1
  %v579 = mul nsw i64 %v10, 18
  %v580 = icmp slt i64 %v10, 0
  %v581 = select i1 %v580, i64 %v160, i64 0
  %v582 = add i64 %v581, %v579
  %v583 = icmp slt i64 %v582, 0
  %v584 = icmp slt i64 %v582, %v160
  %v585 = add i64 %v578, %v581
  %v586 = icmp slt i64 %v585, 0
  %v587 = icmp slt i64 %v585, %v160
  %v588 = icmp sgt i64 %v261, 1
  %v589 = mul i64 %v197, %v196
  %v590 = getelementptr i8, ptr %v24, i64 8
  %v591 = select i1 %v580, i64 %v254, i64 0
  %v592 = getelementptr i64, ptr %v253, i64 %v10
  %v593 = getelementptr i64, ptr %v592, i64 %v591
  %v594 = mul i64 %v136, 48
  %v595 = getelementptr i8, ptr %v134, i64 %v594
  %v596 = mul i64 %v589, 136
  %v597 = shl i64 %v136, 6
  %v598 = getelementptr i8, ptr %v134, i64 %v597
  %v599 = mul nsw i64 %v10, %v9
  %v600 = mul i64 %v599, 136
  %v601 = getelementptr i8, ptr %v159, i64 %v600
  %v602 = getelementptr i8, ptr %v194, i64 %v596
  %v603 = mul i64 %v589, 96
  %v604 = getelementptr i8, ptr %v194, i64 %v603
  %v605 = mul i64 %v589, 104
  %v606 = getelementptr i8, ptr %v194, i64 %v605
  %v607 = getelementptr double, ptr %v194, i64 %v589
  %v608 = mul i64 %v589, 88
  %v609 = getelementptr i8, ptr %v194, i64 %v608
  %v610 = mul i64 %v599, 96
  %v611 = getelementptr i8, ptr %v159, i64 %v610
  %v612 = mul i64 %v599, 96
  %v613 = getelementptr i8, ptr %v159, i64 %v612
  %v614 = mul i64 %v599, 104
  %v615 = getelementptr i8, ptr %v159, i64 %v614
  %v616 = add nsw i64 %v261, -2
  %v617 = icmp sgt i64 %v10, 0
  %v618 = add i64 %v241, %v240
  %v619 = add i64 %v240, 1
  %v620 = add i64 %v10, 1
  %v621 = mul i64 %v136, 160
  %v622 = getelementptr i8, ptr %v134, i64 %v621
  %v623 = add i64 %v241, 1
  %v624 = add i64 %v11, -1
  %v625 = tail call i64 @llvm.smax.i64(i64 %v624, i64 0)
  %v626 = icmp slt i64 %v624, 1
  %v627 = shl i64 %v136, 6
  %v628 = getelementptr i8, ptr %v134, i64 %v627
  %v629 = mul nsw i64 %v10, %v9
  %v630 = mul i64 %v629, 136
  %v631 = getelementptr i8, ptr %v159, i64 %v630
  %v632 = icmp sgt i64 %v10, 0
  %v633 = select i1 %v568, i1 %v632, i1 false
  %v634 = mul i64 %v197, %v196
  %v635 = mul i64 %v634, 80
  %v636 = getelementptr i8, ptr %v194, i64 %v635
  %v637 = mul i64 %v634, 136
  %v638 = getelementptr i8, ptr %v194, i64 %v637
  %v639 = mul nsw i64 %v10, 17
  %v640 = add i64 %v240, 1
  %v641 = getelementptr double, ptr %v159, i64 %v639
  %v642 = add i64 %v241, %v240
  %v643 = mul i64 %v197, %v196
  %v644 = mul i64 %v643, 136
  %v645 = getelementptr i8, ptr %v194, i64 %v644
  %v646 = getelementptr i8, ptr %v6, i64 48
  %v647 = or i1 %v568, %v293
  %v648 = mul i64 %v136, 40
  %v649 = getelementptr i8, ptr %v134, i64 %v648
  %v650 = mul i64 %v136, 184
  %v651 = getelementptr i8, ptr %v134, i64 %v650
  %v652 = mul i64 %v136, 192
  %v653 = getelementptr i8, ptr %v134, i64 %v652
  %v654 = mul i64 %v136, 200
  %v655 = getelementptr i8, ptr %v134, i64 %v654
  %v656 = mul i64 %v136, 176
  %v657 = getelementptr i8, ptr %v134, i64 %v656
  %v658 = shl i64 %v145, 4
  %v659 = getelementptr i8, ptr %v143, i64 %v658
  %v660 = mul i64 %v136, 208
  %v661 = getelementptr i8, ptr %v134, i64 %v660
  %v662 = mul i64 %v136, 72
  %v663 = getelementptr i8, ptr %v134, i64 %v662
  %v664 = mul i64 %v136, 40
  %v665 = getelementptr i8, ptr %v134, i64 %v664
  %v666 = mul i64 %v136, 56
  %v667 = getelementptr i8, ptr %v134, i64 %v666
  %v668 = mul i64 %v136, 232
  %v669 = getelementptr i8, ptr %v134, i64 %v668
  %v670 = icmp sgt i64 %v13, 0
  %v671 = icmp ne i64 %v14, 0
  %v672 = xor i1 %v670, true
  %v673 = select i1 %v672, i1 true, i1 %v671
  %v674 = shl i64 %v136, 6
  %v675 = getelementptr i8, ptr %v134, i64 %v674
  %v676 = mul nsw i64 %v10, %v9
  %v677 = mul i64 %v676, 136
  %v678 = getelementptr i8, ptr %v159, i64 %v677
  %v679 = mul i64 %v676, 104
  %v680 = getelementptr i8, ptr %v159, i64 %v679
  %v681 = getelementptr i8, ptr %v6, i64 104
  %v682 = getelementptr i8, ptr %v6, i64 96
  %v683 = mul i64 %v197, %v196
  %v684 = mul i64 %v136, 48
  %v685 = getelementptr i8, ptr %v134, i64 %v684
  %v686 = shl i64 %v136, 6
  %v687 = getelementptr i8, ptr %v134, i64 %v686
  %v688 = shl i64 %v683, 7
  %v689 = icmp slt i64 %v10, 1
  %v690 = getelementptr i8, ptr %v194, i64 %v688
  %v691 = mul i64 %v208, 3
  %v692 = getelementptr i8, ptr %v6, i64 32
  %v693 = mul i64 %v683, 192
  %v694 = mul i64 %v683, 184
  %v695 = mul i64 %v683, 176
  %v696 = mul i64 %v683, 168
  %v697 = mul i64 %v683, 160
  %v698 = mul i64 %v683, 152
  %v699 = mul i64 %v683, 144
  %v700 = mul i64 %v136, 56
  %v701 = getelementptr i8, ptr %v134, i64 %v700
  %v702 = tail call i64 @llvm.smax.i64(i64 %v208, i64 0)
  %v703 = mul i64 %v208, %v207
  %v704 = getelementptr double, ptr %v205, i64 %v208
  %v705 = mul i64 %v208, %v207
  %v706 = getelementptr double, ptr %v205, i64 %v208
  %v707 = getelementptr double, ptr %v205, i64 %v208
  %v708 = shl i64 %v208, 4
  %v709 = getelementptr i8, ptr %v205, i64 %v708
  %v710 = icmp sgt i64 %v12, 0
  %v711 = add nsw i64 %v11, 13
  %v712 = shl i64 %v136, 6
  %v713 = getelementptr i8, ptr %v134, i64 %v712
  %v714 = mul nsw i64 %v10, %v9
  %v715 = mul i64 %v714, 136
  %v716 = getelementptr i8, ptr %v159, i64 %v715
  %v717 = icmp slt i64 %v11, -13
  %v718 = select i1 %v717, i64 %v7, i64 0
  %v719 = getelementptr i64, ptr %v6, i64 %v11
  %v720 = getelementptr i8, ptr %v719, i64 104
  %v721 = getelementptr i64, ptr %v720, i64 %v718
  %v722 = getelementptr i8, ptr %v6, i64 88
  %v723 = shl i64 %v145, 4
  %v724 = getelementptr i8, ptr %v143, i64 %v723
  %v725 = mul i64 %v136, 40
  %v726 = getelementptr i8, ptr %v134, i64 %v725
  %v727 = mul i64 %v136, 56
  %v728 = getelementptr i8, ptr %v134, i64 %v727
  %v729 = mul i64 %v136, 216
  %v730 = getelementptr i8, ptr %v134, i64 %v729
  %v731 = mul i64 %v136, 48
  %v732 = getelementptr i8, ptr %v134, i64 %v731
  %v733 = shl i64 %v136, 5
  %v734 = getelementptr i8, ptr %v134, i64 %v733
  %v735 = getelementptr double, ptr %v134, i64 %v136
  %v736 = mul i64 %v136, 224
  %v737 = getelementptr i8, ptr %v134, i64 %v736
  %v738 = mul i64 %v197, %v196
  %v739 = mul i64 %v136, 48
  %v740 = getelementptr i8, ptr %v134, i64 %v739
  %v741 = shl i64 %v136, 6
  %v742 = getelementptr i8, ptr %v134, i64 %v741
  %v743 = shl i64 %v738, 7
  %v744 = icmp slt i64 %v10, 1
  %v745 = getelementptr i8, ptr %v194, i64 %v743
  %v746 = mul i64 %v208, 3
  %v747 = getelementptr i8, ptr %v6, i64 32
  %v748 = mul i64 %v738, 192
  %v749 = mul i64 %v738, 184
  %v750 = mul i64 %v738, 176
  %v751 = mul i64 %v738, 168
  %v752 = mul i64 %v738, 160
  %v753 = mul i64 %v738, 152
  %v754 = mul i64 %v738, 144
  %v755 = getelementptr double, ptr %v93, i64 %v94
  %v756 = getelementptr i8, ptr %v755, i64 -8
  %v757 = icmp slt i64 %v16, 1
  %v758 = mul i64 %v208, %v207
  %v759 = shl i64 %v208, 4
  %v760 = getelementptr double, ptr %v205, i64 %v208
  %v761 = getelementptr i8, ptr %v205, i64 %v759
  %v762 = shl i64 %v758, 4
  %v763 = mul i64 %v758, 24
  %v764 = shl i64 %v758, 5
  %v765 = mul i64 %v758, 40
  %v766 = mul i64 %v758, 48
  %v767 = mul i64 %v758, 56
  %v768 = shl i64 %v758, 6
  %v769 = mul i64 %v136, 104
  %v770 = getelementptr i8, ptr %v134, i64 %v769
  %v771 = getelementptr double, ptr %v93, i64 %v94
  %v772 = getelementptr i8, ptr %v771, i64 -8
  %v773 = mul i64 %v136, 56
  %v774 = getelementptr i8, ptr %v134, i64 %v773
  %v775 = mul i64 %v136, 120
  %v776 = getelementptr i8, ptr %v134, i64 %v775
  %v777 = mul i64 %v136, 112
  %v778 = getelementptr i8, ptr %v134, i64 %v777
  %v779 = mul i64 %v208, %v207
  %v780 = shl i64 %v136, 7
  %v781 = getelementptr i8, ptr %v134, i64 %v780
  %v782 = mul i64 %v136, 136
  %v783 = getelementptr i8, ptr %v134, i64 %v782
  %v784 = icmp sgt i64 %v10, 0
  %v785 = shl i64 %v10, 7
  %v786 = getelementptr i8, ptr %v159, i64 %v785
  %v787 = mul i64 %v208, 216
  %v788 = getelementptr i8, ptr %v187, i64 %v787
  %v789 = sub i64 %v208, %v19
  %v790 = tail call i64 @llvm.smax.i64(i64 %v789, i64 0)
  %v791 = icmp sgt i64 %v789, 0
  %v792 = shl i64 %v779, 6
  %v793 = getelementptr i8, ptr %v205, i64 %v792
  %v794 = shl i64 %v208, 4
  %v795 = getelementptr i8, ptr %v793, i64 %v794
  %v796 = mul i64 %v779, 72
  %v797 = getelementptr i8, ptr %v205, i64 %v796
  %v798 = getelementptr i8, ptr %v797, i64 %v794
  %v799 = icmp slt i64 %v208, 1
  %v800 = getelementptr double, ptr %v797, i64 %v208
  %v801 = mul i64 %v779, 80
  %v802 = getelementptr i8, ptr %v205, i64 %v801
  %v803 = tail call i64 @llvm.smax.i64(i64 %v10, i64 0)
  %v804 = mul i64 %v487, %v196
  %v805 = getelementptr i8, ptr %v194, i64 %v804
  %v806 = mul nsw i64 %v10, %v9
  %v807 = shl i64 %v806, 7
  %v808 = getelementptr i8, ptr %v159, i64 %v807
  %v809 = mul i64 %v806, 112
  %v810 = getelementptr i8, ptr %v159, i64 %v809
  %v811 = getelementptr i8, ptr %v6, i64 8
  %v812 = mul i64 %v806, 120
  %v813 = getelementptr i8, ptr %v159, i64 %v812
  %v814 = getelementptr i8, ptr %v24, i64 8
  %v815 = mul i64 %v738, 120
  %v816 = getelementptr i8, ptr %v194, i64 %v815
  %v817 = mul i64 %v738, 112
  %v818 = getelementptr i8, ptr %v194, i64 %v817
  %v819 = mul i64 %v136, 40
  %v820 = getelementptr i8, ptr %v134, i64 %v819
  %v821 = icmp slt i64 %v19, 1
  %v822 = mul i64 %v779, 80
  %v823 = getelementptr i8, ptr %v205, i64 %v822
  %v824 = mul i64 %v806, 136
  %v825 = getelementptr i8, ptr %v159, i64 %v824
  %v826 = mul i64 %v806, 104
  %v827 = getelementptr i8, ptr %v159, i64 %v826
  %v828 = mul i64 %v136, 40
  %v829 = getelementptr i8, ptr %v134, i64 %v828
  %v830 = select i1 %v799, i64 0, i64 %v208
  %v831 = icmp slt i64 %v789, 1
  %v832 = shl i64 %v145, 5
  %v833 = getelementptr i8, ptr %v143, i64 %v832
  %v834 = mul i64 %v136, 40
  %v835 = getelementptr i8, ptr %v134, i64 %v834
  %v836 = mul i64 %v136, 96
  %v837 = getelementptr i8, ptr %v134, i64 %v836
  %v838 = mul i64 %v136, 216
  %v839 = getelementptr i8, ptr %v134, i64 %v838
  %v840 = mul i64 %v136, 40
  %v841 = getelementptr i8, ptr %v134, i64 %v840
  %v842 = shl i64 %v136, 5
  %v843 = getelementptr i8, ptr %v134, i64 %v842
  %v844 = getelementptr double, ptr %v134, i64 %v136
  %v845 = mul i64 %v738, 136
  %v846 = getelementptr i8, ptr %v194, i64 %v845
  %v847 = mul nsw i64 %v10, %v9
  %v848 = mul i64 %v847, 136
  %v849 = getelementptr i8, ptr %v159, i64 %v848
  %v850 = mul i64 %v847, 104
  %v851 = getelementptr i8, ptr %v159, i64 %v850
  %v852 = mul i64 %v10, 136
  %v853 = getelementptr i8, ptr %v159, i64 %v852
  %v854 = mul i64 %v208, 192
  %v855 = getelementptr i8, ptr %v187, i64 %v854
  %v856 = mul i64 %v103, %v102
  %v857 = mul i64 %v197, %v196
  %v858 = shl i64 %v145, 4
  %v859 = getelementptr i8, ptr %v143, i64 %v858
  %v860 = mul i64 %v136, 40
  %v861 = getelementptr i8, ptr %v134, i64 %v860
  %v862 = mul i64 %v136, 56
  %v863 = getelementptr i8, ptr %v134, i64 %v862
  %v864 = mul i64 %v136, 48
  %v865 = getelementptr i8, ptr %v134, i64 %v864
  %v866 = mul i64 %v857, 136
  %v867 = icmp slt i64 %v10, 1
  %v868 = mul i64 %v136, 224
  %v869 = getelementptr i8, ptr %v134, i64 %v868
  %v870 = getelementptr i8, ptr %v194, i64 %v866
  %v871 = add i64 %v94, -1
  %v872 = mul i64 %v857, 192
  %v873 = mul i64 %v857, 184
  %v874 = mul i64 %v857, 176
  %v875 = mul i64 %v857, 168
  %v876 = mul i64 %v857, 160
  %v877 = mul i64 %v857, 152
  %v878 = mul i64 %v857, 144
  %v879 = icmp sgt i64 %v9, 1
  %v880 = mul i64 %v136, 40
  %v881 = getelementptr i8, ptr %v134, i64 %v880
  %v882 = getelementptr i8, ptr %v6, i64 80
  %v883 = mul i64 %v136, 40
  %v884 = getelementptr i8, ptr %v134, i64 %v883
  %v885 = shl i64 %v488, 6
  %v886 = icmp sgt i64 %v19, 0
  %v887 = getelementptr i8, ptr %v205, i64 %v885
  %v888 = mul i64 %v136, 96
  %v889 = getelementptr i8, ptr %v134, i64 %v888
  %v890 = mul i64 %v136, 120
  %v891 = getelementptr i8, ptr %v134, i64 %v890
  %v892 = icmp slt i64 %v10, 1
  %v893 = getelementptr i8, ptr %v24, i64 8
  %v894 = getelementptr double, ptr %v93, i64 %v94
  %v895 = getelementptr i8, ptr %v894, i64 -8
  %v896 = mul i64 %v145, 24
  %v897 = getelementptr i8, ptr %v143, i64 %v896
  %v898 = mul i64 %v145, 24
  %v899 = getelementptr i8, ptr %v143, i64 %v898
  %v900 = mul i64 %v136, 24
  %v901 = getelementptr i8, ptr %v134, i64 %v900
  %v902 = icmp ne i64 %v17, 0
  %v903 = tail call i64 @llvm.smax.i64(i64 %v9, i64 0)
  %v904 = mul i64 %v136, 40
  %v905 = getelementptr i8, ptr %v134, i64 %v904
  %v906 = shl i64 %v136, 4
  %v907 = getelementptr i8, ptr %v134, i64 %v906
  %v908 = getelementptr i64, ptr %v143, i64 %v145
  %v909 = icmp slt i64 %v64, 1
  %v910 = getelementptr i8, ptr %v6, i64 8
  %v911 = mul nsw i64 %v10, %v9
  %v912 = getelementptr i8, ptr %v6, i64 24
  %v913 = mul i64 %v911, 136
  %v914 = getelementptr i8, ptr %v159, i64 %v913
  %v915 = mul i64 %v103, %v102
  %v916 = add nsw i64 %v903, -1
  %v917 = mul i64 %v197, %v196
  %v918 = shl i64 %v145, 4
  %v919 = getelementptr i8, ptr %v143, i64 %v918
  %v920 = mul i64 %v917, 136
  %v921 = icmp slt i64 %v10, 1
  %v922 = getelementptr i8, ptr %v194, i64 %v920
  %v923 = getelementptr double, ptr %v93, i64 %v94
  %v924 = getelementptr i8, ptr %v923, i64 -8
  %v925 = shl i64 %v136, 6
  %v926 = getelementptr i8, ptr %v134, i64 %v925
  %v927 = mul i64 %v911, 112
  %v928 = getelementptr i8, ptr %v159, i64 %v927
  %v929 = mul i64 %v917, 112
  %v930 = getelementptr i8, ptr %v194, i64 %v929
  %v931 = shl i64 %v917, 7
  %v932 = getelementptr i8, ptr %v194, i64 %v931
  %v933 = getelementptr i8, ptr %v6, i64 32
  %v934 = mul i64 %v10, 136
  %v935 = getelementptr i8, ptr %v159, i64 %v934
  %v936 = mul i64 %v208, 216
  %v937 = getelementptr i8, ptr %v187, i64 %v936
  %v938 = shl i64 %v10, 7
  %v939 = getelementptr i8, ptr %v159, i64 %v938
  %v940 = mul i64 %v208, 240
  %v941 = getelementptr i8, ptr %v187, i64 %v940
  %v942 = sub i64 %v208, %v19
  %v943 = tail call i64 @llvm.smax.i64(i64 %v942, i64 0)
  %v944 = getelementptr double, ptr %v205, i64 %v208
  %v945 = mul i64 %v208, %v207
  %v946 = mul i64 %v945, 80
  %v947 = getelementptr i8, ptr %v944, i64 %v946
  %v948 = mul i64 %v945, 72
  %v949 = getelementptr i8, ptr %v205, i64 %v948
  %v950 = getelementptr double, ptr %v949, i64 %v208
  %v951 = shl i64 %v208, 4
  %v952 = getelementptr i8, ptr %v949, i64 %v951
  %v953 = shl i64 %v145, 5
  %v954 = getelementptr i8, ptr %v143, i64 %v953
  %v955 = mul i64 %v136, 112
  %v956 = getelementptr i8, ptr %v134, i64 %v955
  %v957 = mul i64 %v136, 40
  %v958 = getelementptr i8, ptr %v134, i64 %v957
  %v959 = shl i64 %v136, 4
  %v960 = getelementptr i8, ptr %v134, i64 %v959
  %v961 = getelementptr i64, ptr %v143, i64 %v145
  %v962 = mul i64 %v136, 24
  %v963 = getelementptr i8, ptr %v134, i64 %v962
  %v964 = mul i64 %v136, 24
  %v965 = getelementptr i8, ptr %v134, i64 %v964
  %v966 = icmp slt i64 %v64, 1
  %v967 = shl i64 %v145, 4
  %v968 = getelementptr i8, ptr %v143, i64 %v967
  %v969 = mul i64 %v136, 24
  %v970 = getelementptr i8, ptr %v134, i64 %v969
  %v971 = getelementptr i8, ptr %v152, i64 8
  %v972 = getelementptr i64, ptr %v143, i64 %v145
  %v973 = mul i64 %v145, 24
  %v974 = getelementptr i8, ptr %v143, i64 %v973
  %v975 = icmp slt i64 %v42, 1
  %v976 = icmp slt i64 %v64, 1
  %v977 = icmp slt i64 %v10, 1
  %v978 = mul i64 %v136, 248
  %v979 = getelementptr i8, ptr %v134, i64 %v978
  %v980 = mul i64 %v136, 240
  %v981 = getelementptr i8, ptr %v134, i64 %v980
  %v982 = mul i64 %v136, 232
  %v983 = getelementptr i8, ptr %v134, i64 %v982
  %v984 = shl i64 %v136, 4
  %v985 = shl i64 %v136, 5
  %v986 = mul i64 %v136, 48
  %v987 = mul i64 %v136, 56
  %v988 = shl i64 %v136, 6
  %v989 = mul i64 %v136, 72
  %v990 = mul i64 %v136, 80
  %v991 = mul i64 %v136, 88
  %v992 = mul i64 %v136, 96
  %v993 = mul i64 %v136, 104
  %v994 = mul i64 %v136, 112
  %v995 = mul i64 %v136, 120
  %v996 = shl i64 %v136, 7
  %v997 = mul i64 %v136, 136
  %v998 = mul i64 %v136, 144
  %v999 = mul i64 %v136, 152
  %v1000 = mul i64 %v136, 160
  %v1001 = mul i64 %v136, 168
  %v1002 = mul i64 %v136, 176
  %v1003 = mul i64 %v136, 184
  %v1004 = mul i64 %v136, 192
  %v1005 = mul i64 %v136, 200
  %v1006 = mul i64 %v136, 208
  %v1007 = mul i64 %v136, 216
  %v1008 = mul i64 %v136, 224
  %v1009 = getelementptr i8, ptr %v134, i64 %v995
  %v1010 = getelementptr i8, ptr %v134, i64 %v1008
  %v1011 = getelementptr i8, ptr %v134, i64 %v984
  %v1012 = mul i64 %v136, 232
  %v1013 = getelementptr i8, ptr %v134, i64 %v1012
  %v1014 = getelementptr double, ptr %v93, i64 %v94
  %v1015 = getelementptr i8, ptr %v1014, i64 -8
  %v1016 = getelementptr double, ptr %v134, i64 %v136
  %v1017 = mul i64 %v136, 232
  %v1018 = getelementptr i8, ptr %v134, i64 %v1017
  %v1019 = mul i64 %v136, 176
  %v1020 = getelementptr i8, ptr %v134, i64 %v1019
  %v1021 = shl i64 %v136, 4
  %v1022 = getelementptr i8, ptr %v134, i64 %v1021
  %v1023 = mul i64 %v136, 168
  %v1024 = getelementptr i8, ptr %v134, i64 %v1023
  %v1025 = shl i64 %v145, 4
  %v1026 = getelementptr i8, ptr %v143, i64 %v1025
  %v1027 = shl i64 %v703, 4
  %v1028 = mul i64 %v703, 24
  %v1029 = shl i64 %v703, 5
  %v1030 = mul i64 %v703, 40
  %v1031 = mul i64 %v703, 48
  %v1032 = mul i64 %v703, 56
  %v1033 = shl i64 %v703, 6
  %v1034 = shl i64 %v705, 4
  %v1035 = shl i64 %v705, 5
  %v1036 = mul i64 %v705, 48
  %v1037 = shl i64 %v705, 6
  %v1038 = mul i64 %v705, 24
  %v1039 = shl i64 %v705, 4
  %v1040 = shl i64 %v705, 5
  %v1041 = mul i64 %v705, 48
  %v1042 = shl i64 %v705, 6
  %v1043 = mul i64 %v705, 40
  %v1044 = shl i64 %v705, 4
  %v1045 = shl i64 %v705, 5
  %v1046 = mul i64 %v705, 48
  %v1047 = shl i64 %v705, 6
  %v1048 = mul i64 %v705, 56
  %v1049 = shl i64 %v705, 4
  %v1050 = shl i64 %v705, 5
  %v1051 = mul i64 %v705, 48
  %v1052 = shl i64 %v705, 6
  br label %v1053

v1053:
  %v1054 = phi i64 [ %v1055, %v1056 ], [ %v284, %v483 ]
  %v1057 = phi i64 [ %v1058, %v1056 ], [ %v479, %v483 ]
  %v1059 = add nsw i64 %v1054, -1
  %v1060 = load i64, ptr %v485, align 8, !noalias !11
  %v1061 = icmp eq i64 %v1060, 0
  br i1 %v1061, label %v1062, label %v1063

v1063:
  %v1064 = icmp eq i64 %v1060, 2
  store i64 0, ptr %v485, align 8, !noalias !11
  %v1065 = load i64, ptr %v489, align 8, !noalias !15
  %v1066 = inttoptr i64 %v1065 to ptr
  tail call void %v1066(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !15
  br i1 %v292, label %v1067, label %v1068

v1067:
  %v1069 = load i64, ptr %v490, align 8, !noalias !18
  %v1070 = inttoptr i64 %v1069 to ptr
  tail call void %v1070(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !18
  %v1071 = load double, ptr %v492, align 8, !noalias !24
  %v1072 = fcmp une double %v1071, 2.500000e-01
  br i1 %v1072, label %v1068, label %v1073

v1073:
  store double 0.000000e+00, ptr %v492, align 8, !noalias !24
  br i1 %v493, label %v1074, label %v1075

v1076:
  store double 1.000000e+00, ptr %v492, align 8, !noalias !24
  br label %v1077

v1077:
  %v1078 = icmp eq i64 %v1079, %v19
  br i1 %v1078, label %v1075, label %v1074

v1075:
  %v1080 = load double, ptr %v492, align 8, !noalias !24
  %v1081 = fcmp ogt double %v1080, 5.000000e-01
  %v1082 = or i1 %v1064, %v1081
  br label %v1068

v1074:
  %v1083 = phi i64 [ %v1079, %v1077 ], [ 0, %v1073 ]
  %v1079 = add nsw i64 %v1083, 1
  %v1084 = getelementptr double, ptr %v205, i64 %v1083
  %v1085 = load double, ptr %v1084, align 8, !noalias !24
  %v1086 = add nsw i64 %v1083, %v18
  %v1087 = icmp slt i64 %v1086, 0
  %v1088 = select i1 %v1087, i64 %v167, i64 0
  %v1089 = getelementptr double, ptr %v166, i64 %v1086
  %v1090 = getelementptr double, ptr %v1089, i64 %v1088
  %v1091 = load double, ptr %v1090, align 8, !noalias !24
  %v1092 = fcmp une double %v1085, %v1091
  br i1 %v1092, label %v1076, label %v1077

v1068:
  %v1093 = phi i1 [ %v1064, %v1063 ], [ %v1082, %v1075 ], [ %v1064, %v1067 ]
  br i1 %v1093, label %v1094, label %v1062

v1094:
  br i1 %v292, label %v1095, label %v1096

v1095:
  %v1097 = load i64, ptr %v494, align 8, !noalias !25
  %v1098 = inttoptr i64 %v1097 to ptr
  tail call void %v1098(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !25
  %v1099 = load double, ptr %v496, align 8, !noalias !31
  %v1100 = fcmp ule double %v1099, 5.000000e-01
  %v1101 = select i1 %v1100, i1 true, i1 %v497
  br i1 %v1101, label %v1102, label %v1103

v1102:
  %v1104 = load i64, ptr %v489, align 8, !noalias !32
  %v1105 = inttoptr i64 %v1104 to ptr
  tail call void %v1105(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !32
  br label %v1096

v1103:
  %v1106 = phi i64 [ %v1107, %v1103 ], [ 0, %v1095 ]
  %v1107 = add nsw i64 %v1106, 1
  %v1108 = getelementptr double, ptr %v205, i64 %v1106
  %v1109 = load double, ptr %v1108, align 8, !noalias !31
  %v1110 = add nsw i64 %v1106, %v18
  %v1111 = icmp slt i64 %v1110, 0
  %v1112 = select i1 %v1111, i64 %v167, i64 0
  %v1113 = getelementptr double, ptr %v166, i64 %v1110
  %v1114 = getelementptr double, ptr %v1113, i64 %v1112
  store double %v1109, ptr %v1114, align 8, !noalias !31
  %v1115 = icmp eq i64 %v1107, %v19
  br i1 %v1115, label %v1102, label %v1103

v1096:
  br i1 %v498, label %v1116, label %v1117

v1116:
  %v1118 = load i64, ptr %v6, align 8, !noalias !35
  %v1119 = inttoptr i64 %v1118 to ptr
  tail call void %v1119(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v501), !noalias !35
  %v1120 = load i64, ptr %v502, align 8, !noalias !38
  %v1121 = inttoptr i64 %v1120 to ptr
  tail call void %v1121(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !38
  %v1122 = load i64, ptr %v503, align 8, !noalias !41
  %v1123 = inttoptr i64 %v1122 to ptr
  tail call void %v1123(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !41
  %v1124 = load i64, ptr %v6, align 8, !noalias !44
  %v1125 = inttoptr i64 %v1124 to ptr
  tail call void %v1125(ptr %v505, ptr %v507, ptr %v166, ptr %v173, ptr %v180, ptr %v509), !noalias !44
  %v1126 = load i64, ptr %v510, align 8, !noalias !47
  %v1127 = inttoptr i64 %v1126 to ptr
  tail call void %v1127(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !47
  br label %v1117

v1117:
  br i1 %v294, label %v1062, label %v1128

v1129:
  store double 0.000000e+00, ptr %v1130, align 8, !noalias !50
  %v1131 = getelementptr double, ptr %v515, i64 %v1132
  store double 0.000000e+00, ptr %v1131, align 8, !noalias !50
  %v1133 = getelementptr double, ptr %v517, i64 %v1132
  store double 0.000000e+00, ptr %v1133, align 8, !noalias !50
  %v1134 = getelementptr i64, ptr %v143, i64 %v1132
  %v1135 = load i64, ptr %v1134, align 8, !noalias !50
  %v1136 = icmp slt i64 %v1135, 0
  %v1137 = select i1 %v1136, i64 %v126, i64 0
  %v1138 = add i64 %v1137, %v1135
  %v1139 = mul i64 %v1138, %v127
  %v1140 = getelementptr i64, ptr %v125, i64 %v1139
  %v1141 = getelementptr i8, ptr %v1140, i64 8
  %v1142 = load i64, ptr %v1141, align 8, !noalias !50
  %v1143 = add nsw i64 %v1142, %v518
  store i64 %v1143, ptr %v1141, align 8, !noalias !50
  %v1144 = load i64, ptr %v1134, align 8, !noalias !50
  %v1145 = icmp slt i64 %v1144, 0
  %v1146 = select i1 %v1145, i64 %v126, i64 0
  %v1147 = add i64 %v1146, %v1144
  %v1148 = mul i64 %v1147, %v127
  %v1149 = getelementptr i64, ptr %v125, i64 %v1148
  %v1150 = getelementptr i8, ptr %v1149, i64 16
  %v1151 = load i64, ptr %v1150, align 8, !noalias !50
  %v1152 = add nsw i64 %v1151, %v520
  store i64 %v1152, ptr %v1150, align 8, !noalias !50
  %v1153 = getelementptr double, ptr %v522, i64 %v1132
  %v1154 = load double, ptr %v1153, align 8, !noalias !50
  %v1155 = fcmp une double %v1154, 0.000000e+00
  br i1 %v1155, label %v1156, label %v1157

v1156:
  %v1158 = load i64, ptr %v1134, align 8, !noalias !54
  %v1159 = icmp sgt i64 %v1158, -1
  br i1 %v1159, label %v1160, label %v1157

v1160:
  %v1161 = getelementptr i64, ptr %v111, i64 %v1158
  %v1162 = load i64, ptr %v1161, align 8, !noalias !54
  %v1163 = icmp eq i64 %v1162, 0
  br i1 %v1163, label %v1164, label %v1157

v1164:
  store i64 3, ptr %v1161, align 8, !noalias !54
  br label %v1157

v1157:
  br i1 %v291, label %v1165, label %v1166

v1165:
  %v1167 = load double, ptr %v524, align 8, !noalias !57
  %v1168 = load double, ptr %v93, align 8, !noalias !57
  %v1169 = fsub double %v1167, %v1168
  %v1170 = fmul double %v1169, 1.000000e-13
  %v1171 = load double, ptr %v134, align 8, !noalias !57
  %v1172 = tail call double @llvm.fabs.f64(double %v1171)
  %v1173 = fmul double %v1172, 4.000000e-15
  %v1174 = fcmp ogt double %v1173, %v1170
  %v1175 = select i1 %v1174, double %v1173, double %v1170
  %v1176 = fadd double %v1171, %v1175
  store double %v1176, ptr %v526, align 8, !noalias !67
  %v1177 = load i64, ptr %v6, align 8, !noalias !68
  %v1178 = inttoptr i64 %v1177 to ptr
  tail call void %v1178(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v527), !noalias !68
  br i1 %v528, label %v1179, label %v1180

v1179:
  %v1181 = load i64, ptr %v534, align 8, !noalias !71
  %v1182 = inttoptr i64 %v1181 to ptr
  tail call void %v1182(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v536), !noalias !71
  %v1183 = load i64, ptr %v534, align 8, !noalias !74
  %v1184 = inttoptr i64 %v1183 to ptr
  tail call void %v1184(ptr nonnull %v526, ptr %v538, ptr %v166, ptr %v173, ptr %v180, ptr %v540), !noalias !74
  br label %v1185

v1185:
  %v1186 = phi i64 [ %v19, %v1179 ], [ %v1187, %v1188 ]
  %v1189 = phi i64 [ %v542, %v1179 ], [ %v1190, %v1188 ]
  %v1191 = icmp sgt i64 %v1189, 0
  br i1 %v1191, label %v1188, label %v1192

v1188:
  %v1190 = add nsw i64 %v1189, -1
  %v1187 = add i64 %v1186, 1
  %v1193 = icmp slt i64 %v1186, 0
  %v1194 = select i1 %v1193, i64 %v208, i64 0
  %v1195 = add i64 %v1194, %v1186
  %v1196 = getelementptr double, ptr %v546, i64 %v1195
  %v1197 = load double, ptr %v1196, align 8, !noalias !67
  %v1198 = getelementptr double, ptr %v549, i64 %v1195
  %v1199 = load double, ptr %v1198, align 8, !noalias !67
  %v1200 = fsub double %v1197, %v1199
  %v1201 = tail call double @llvm.fabs.f64(double %v1200)
  %v1202 = getelementptr double, ptr %v551, i64 %v1195
  %v1203 = load double, ptr %v1202, align 8, !noalias !67
  %v1204 = tail call i1 @llvm.is.fpclass.f64(double %v1203, i32 543)
  %v1205 = select i1 %v1204, double 0.000000e+00, double %v1203
  %v1206 = fcmp ueq double %v1201, 0x7FF0000000000000
  %v1207 = select i1 %v1206, double -0.000000e+00, double %v1201
  %v1208 = fadd double %v1205, %v1207
  %v1209 = getelementptr double, ptr %v548, i64 %v1195
  %v1210 = load double, ptr %v1209, align 8, !noalias !67
  %v1211 = fneg double %v1208
  %v1212 = fcmp olt double %v1210, %v1211
  br i1 %v1212, label %v1192, label %v1185

v1180:
  %v1213 = phi i64 [ %v1214, %v1180 ], [ 0, %v1165 ]
  %v1214 = add nsw i64 %v1213, 1
  %v1215 = mul i64 %v1213, %v197
  %v1216 = getelementptr double, ptr %v194, i64 %v1215
  %v1217 = load double, ptr %v1216, align 8, !noalias !67
  %v1218 = getelementptr double, ptr %v531, i64 %v1215
  %v1219 = load double, ptr %v1218, align 8, !noalias !67
  %v1220 = fmul double %v1175, %v1219
  %v1221 = fadd double %v1217, %v1220
  %v1222 = getelementptr double, ptr %v533, i64 %v1215
  store double %v1221, ptr %v1222, align 8, !noalias !67
  %v1223 = icmp eq i64 %v10, %v1214
  br i1 %v1223, label %v1179, label %v1180

v1224:
  %v1225 = getelementptr i64, ptr %v553, i64 %v1132
  store i64 %v1226, ptr %v1225, align 8, !noalias !77
  %v1227 = load i64, ptr %v1134, align 8, !noalias !78
  %v1228 = icmp sgt i64 %v1227, -1
  br i1 %v1228, label %v1229, label %v1230

v1229:
  %v1231 = getelementptr i64, ptr %v111, i64 %v1227
  %v1232 = load i64, ptr %v1231, align 8, !noalias !78
  %v1233 = icmp eq i64 %v1232, 0
  br i1 %v1233, label %v1234, label %v1230

v1234:
  store i64 4, ptr %v1231, align 8, !noalias !78
  br label %v1230

v1230:
  %v1235 = getelementptr double, ptr %v134, i64 %v1132
  %v1236 = load double, ptr %v1235, align 8, !noalias !77
  %v1237 = getelementptr double, ptr %v555, i64 %v1132
  store double %v1236, ptr %v1237, align 8, !noalias !77
  %v1238 = getelementptr double, ptr %v557, i64 %v1132
  store double 0.000000e+00, ptr %v1238, align 8, !noalias !77
  br label %v1166

v1192:
  %v1226 = phi i64 [ %v1186, %v1188 ], [ -1, %v1185 ]
  %v1239 = icmp sgt i64 %v1226, -1
  br i1 %v1239, label %v1224, label %v1166

v1240:
  %v1241 = icmp sgt i64 %v1242, 1
  br i1 %v1241, label %v1128, label %v1062

v1128:
  %v1242 = phi i64 [ %v1243, %v1240 ], [ %v295, %v1117 ]
  %v1132 = phi i64 [ %v1244, %v1240 ], [ 0, %v1117 ]
  %v1243 = add nsw i64 %v1242, -1
  %v1244 = add nsw i64 %v1132, 1
  %v1130 = getelementptr double, ptr %v513, i64 %v1132
  %v1245 = load double, ptr %v1130, align 8, !noalias !50
  %v1246 = fcmp olt double %v1245, 5.000000e-01
  br i1 %v1246, label %v1240, label %v1129

v1166:
  %v1247 = getelementptr double, ptr %v559, i64 %v1132
  %v1248 = load double, ptr %v1247, align 8, !noalias !81
  %v1249 = getelementptr double, ptr %v561, i64 %v1132
  store double %v1248, ptr %v1249, align 8, !noalias !81
  %v1250 = getelementptr i64, ptr %v563, i64 %v1132
  %v1251 = load i64, ptr %v1250, align 8, !noalias !81
  %v1252 = icmp slt i64 %v1251, %v94
  br i1 %v1252, label %v1253, label %v1240

v1253:
  %v1254 = icmp slt i64 %v1251, 0
  %v1255 = select i1 %v1254, i64 %v94, i64 0
  %v1256 = getelementptr double, ptr %v93, i64 %v1251
  %v1257 = getelementptr double, ptr %v1256, i64 %v1255
  %v1258 = load double, ptr %v1257, align 8, !noalias !81
  %v1259 = load double, ptr %v1247, align 8, !noalias !81
  %v1260 = fcmp olt double %v1259, %v1258
  %v1261 = select i1 %v1260, double %v1259, double %v1258
  store double %v1261, ptr %v1249, align 8, !noalias !81
  br label %v1240

v1062:
  %v1262 = phi i1 [ %v647, %v1068 ], [ %v647, %v1053 ], [ true, %v1117 ], [ true, %v1240 ]
  %v1263 = load i64, ptr %v564, align 8, !noalias !85
  %v1264 = inttoptr i64 %v1263 to ptr
  tail call void %v1264(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !85
  br i1 %v565, label %v1265, label %v1266

v1267:
  %v1268 = getelementptr double, ptr %v649, i64 %v1269
  %v1270 = load double, ptr %v1268, align 8
  %v1271 = fcmp ogt double %v1270, 5.000000e-01
  br label %v1272

v1272:
  %v1273 = phi i1 [ true, %v1274 ], [ %v1271, %v1267 ]
  br i1 %v1275, label %v1276, label %v1277

v1277:
  %v1278 = getelementptr double, ptr %v651, i64 %v1269
  %v1279 = load double, ptr %v1278, align 8
  %v1280 = fcmp ogt double %v1279, 5.000000e-01
  br label %v1276

v1276:
  %v1281 = phi i1 [ true, %v1272 ], [ %v1280, %v1277 ]
  %v1282 = icmp sgt i64 %v1283, 1
  br i1 %v1282, label %v1274, label %v1284

v1284:
  %v1285 = phi i1 [ false, %v1286 ], [ %v1273, %v1276 ]
  %v1287 = phi i1 [ %v1262, %v1286 ], [ %v1281, %v1276 ]
  %v1288 = xor i1 %v1287, true
  %v1289 = or i1 %v294, %v1288
  br i1 %v1289, label %v1290, label %v1291

v1292:
  br i1 %v294, label %v1290, label %v1293

v1294:
  %v1295 = getelementptr double, ptr %v653, i64 %v1296
  %v1297 = load double, ptr %v1295, align 8, !noalias !91
  %v1298 = fptosi double %v1297 to i64
  %v1299 = getelementptr double, ptr %v655, i64 %v1296
  %v1300 = load double, ptr %v1299, align 8, !noalias !91
  %v1301 = fptosi double %v1300 to i64
  %v1302 = mul i64 %v1303, %v127
  %v1304 = getelementptr i64, ptr %v125, i64 %v1302
  %v1305 = load i64, ptr %v1304, align 8, !noalias !91
  %v1306 = add nsw i64 %v1305, %v1298
  store i64 %v1306, ptr %v1304, align 8, !noalias !91
  %v1307 = getelementptr i8, ptr %v1304, i64 24
  %v1308 = load i64, ptr %v1307, align 8, !noalias !91
  %v1309 = add nsw i64 %v1308, %v1301
  store i64 %v1309, ptr %v1307, align 8, !noalias !91
  %v1310 = getelementptr i8, ptr %v1304, i64 8
  %v1311 = load i64, ptr %v1310, align 8, !noalias !91
  %v1312 = add nsw i64 %v1301, %v1298
  %v1313 = mul nsw i64 %v1312, %v624
  %v1314 = add nsw i64 %v1313, %v1298
  %v1315 = add nsw i64 %v1314, %v1311
  store i64 %v1315, ptr %v1310, align 8, !noalias !91
  store double 0.000000e+00, ptr %v1295, align 8, !noalias !91
  store double 0.000000e+00, ptr %v1299, align 8, !noalias !91
  %v1316 = getelementptr double, ptr %v657, i64 %v1296
  %v1317 = load double, ptr %v1316, align 8, !noalias !91
  %v1318 = sitofp i64 %v1312 to double
  %v1319 = fsub double %v1317, %v1318
  store double %v1319, ptr %v1316, align 8, !noalias !91
  br label %v1320

v1320:
  %v1321 = icmp sgt i64 %v1322, 1
  br i1 %v1321, label %v1291, label %v1292

v1291:
  %v1322 = phi i64 [ %v1323, %v1320 ], [ %v295, %v1284 ]
  %v1296 = phi i64 [ %v1324, %v1320 ], [ 0, %v1284 ]
  %v1323 = add nsw i64 %v1322, -1
  %v1324 = add nsw i64 %v1296, 1
  %v1325 = getelementptr i64, ptr %v143, i64 %v1296
  %v1303 = load i64, ptr %v1325, align 8, !noalias !91
  %v1326 = icmp sgt i64 %v1303, -1
  br i1 %v1326, label %v1294, label %v1320

v1327:
  %v1328 = getelementptr double, ptr %v663, i64 %v1329
  %v1330 = load double, ptr %v1328, align 8, !noalias !98
  %v1331 = fcmp ogt double %v1330, 5.000000e-01
  br i1 %v1331, label %v1332, label %v1333

v1332:
  %v1334 = fptosi double %v1330 to i64
  %v1335 = load i64, ptr %v1336, align 8, !noalias !99
  %v1337 = icmp sgt i64 %v1335, -1
  br i1 %v1337, label %v1338, label %v1333

v1333:
  %v1339 = getelementptr double, ptr %v665, i64 %v1329
  %v1340 = load double, ptr %v1339, align 8, !noalias !98
  %v1341 = fcmp ogt double %v1340, 5.000000e-01
  br i1 %v1341, label %v1342, label %v1343

v1342:
  %v1344 = select i1 %v1345, i1 true, i1 %v291
  %v1346 = icmp slt i64 %v1347, %v94
  br i1 %v1346, label %v1348, label %v1349

v1348:
  %v1350 = icmp slt i64 %v1347, 0
  %v1351 = select i1 %v1350, i64 %v94, i64 0
  %v1352 = getelementptr double, ptr %v93, i64 %v1347
  %v1353 = getelementptr double, ptr %v1352, i64 %v1351
  %v1354 = load double, ptr %v1353, align 8, !noalias !98
  %v1355 = getelementptr double, ptr %v667, i64 %v1329
  %v1356 = load double, ptr %v1355, align 8, !noalias !98
  %v1357 = fcmp olt double %v1354, %v1356
  br i1 %v1357, label %v1358, label %v1349

v1358:
  br label %v1349

v1349:
  %v1359 = phi i1 [ true, %v1358 ], [ %v1344, %v1348 ], [ %v1344, %v1342 ]
  %v1360 = mul i64 %v1361, %v127
  %v1362 = getelementptr i64, ptr %v125, i64 %v1360
  %v1363 = load i64, ptr %v1362, align 8, !noalias !98
  %v1364 = and i64 %v1363, 127
  %v1365 = icmp eq i64 %v1364, 0
  br i1 %v1365, label %v1366, label %v1367

v1367:
  %v1368 = getelementptr double, ptr %v669, i64 %v1329
  %v1369 = load double, ptr %v1368, align 8, !noalias !98
  %v1370 = fcmp ogt double %v1369, 0.000000e+00
  br i1 %v1370, label %v1366, label %v1343

v1366:
  store double 1.000000e+00, ptr %v1371, align 8, !noalias !98
  br label %v1343

v1343:
  %v1372 = phi i1 [ %v1359, %v1366 ], [ %v1359, %v1367 ], [ %v1345, %v1333 ], [ %v1345, %v1293 ]
  %v1373 = phi i1 [ true, %v1366 ], [ %v1374, %v1367 ], [ %v1374, %v1333 ], [ %v1374, %v1293 ]
  %v1375 = icmp sgt i64 %v1376, 1
  br i1 %v1375, label %v1293, label %v1377

v1293:
  %v1374 = phi i1 [ %v1373, %v1343 ], [ false, %v1292 ]
  %v1345 = phi i1 [ %v1372, %v1343 ], [ false, %v1292 ]
  %v1376 = phi i64 [ %v1378, %v1343 ], [ %v295, %v1292 ]
  %v1329 = phi i64 [ %v1379, %v1343 ], [ 0, %v1292 ]
  %v1378 = add nsw i64 %v1376, -1
  %v1379 = add nsw i64 %v1329, 1
  %v1336 = getelementptr i64, ptr %v143, i64 %v1329
  %v1361 = load i64, ptr %v1336, align 8, !noalias !98
  %v1380 = getelementptr i64, ptr %v659, i64 %v1329
  %v1347 = load i64, ptr %v1380, align 8, !noalias !98
  %v1371 = getelementptr double, ptr %v661, i64 %v1329
  store double 0.000000e+00, ptr %v1371, align 8, !noalias !98
  %v1381 = icmp sgt i64 %v1361, -1
  br i1 %v1381, label %v1327, label %v1343

v1338:
  %v1382 = getelementptr i64, ptr %v111, i64 %v1335
  %v1383 = load i64, ptr %v1382, align 8, !noalias !99
  %v1384 = icmp eq i64 %v1383, 0
  br i1 %v1384, label %v1385, label %v1333

v1385:
  store i64 %v1334, ptr %v1382, align 8, !noalias !99
  br label %v1333

v1290:
  %v1386 = phi i1 [ true, %v1284 ], [ true, %v1292 ], [ %v1387, %v1377 ]
  %v1388 = phi i1 [ true, %v1284 ], [ true, %v1292 ], [ %v1389, %v1377 ]
  %v1390 = and i1 %v670, %v1285
  br i1 %v1390, label %v1391, label %v1392

v1391:
  %v1393 = load i64, ptr %v6, align 8, !noalias !102
  %v1394 = inttoptr i64 %v1393 to ptr
  tail call void %v1394(ptr %v675, ptr %v678, ptr %v166, ptr %v173, ptr %v180, ptr %v680), !noalias !102
  br label %v1392

v1392:
  br i1 %v1388, label %v1395, label %v1396

v1396:
  %v1397 = load i64, ptr %v681, align 8, !noalias !108
  %v1398 = inttoptr i64 %v1397 to ptr
  tail call void %v1398(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !108
  br label %v1395

v1395:
  %v1399 = select i1 %v1285, i1 %v291, i1 false
  %v1400 = xor i1 %v1285, true
  %v1401 = select i1 %v292, i1 %v1285, i1 false
  %v1402 = xor i1 %v1401, true
  %v1403 = select i1 %v1402, i1 true, i1 %v1399
  %v1404 = select i1 %v292, i1 %v1285, i1 %v1399
  br i1 %v1403, label %v1405, label %v1406

v1406:
  %v1407 = load i64, ptr %v682, align 8, !noalias !111
  %v1408 = inttoptr i64 %v1407 to ptr
  tail call void %v1408(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !111
  br label %v1409

v1409:
  %v1410 = phi i64 [ 0, %v1406 ], [ %v1411, %v1412 ]
  %v1411 = add nsw i64 %v1410, 1
  %v1413 = icmp ult i64 %v1410, 9
  br i1 %v1413, label %v1414, label %v1415

v1414:
  %v1416 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v1410
  %v1417 = load double, ptr %v1416, align 8
  %v1418 = load double, ptr %v134, align 8, !noalias !114
  %v1419 = load double, ptr %v685, align 8, !noalias !114
  %v1420 = fmul double %v1417, %v1419
  %v1421 = fadd double %v1418, %v1420
  store double %v1421, ptr %v687, align 8, !noalias !114
  br i1 %v689, label %v1412, label %v1422

v1422:
  %v1423 = fsub double 1.000000e+00, %v1417
  br label %v1424

v1424:
  %v1425 = phi i64 [ 0, %v1422 ], [ %v1426, %v1424 ]
  %v1427 = mul i64 %v1425, %v197
  %v1428 = getelementptr double, ptr %v194, i64 %v1427
  %v1429 = getelementptr i8, ptr %v1428, i64 %v693
  %v1430 = load double, ptr %v1429, align 8, !noalias !124
  %v1431 = fadd double %v1430, 0.000000e+00
  %v1432 = fmul double %v1417, %v1431
  %v1433 = getelementptr i8, ptr %v1428, i64 %v694
  %v1434 = load double, ptr %v1433, align 8, !noalias !124
  %v1435 = fadd double %v1434, %v1432
  %v1436 = fmul double %v1423, %v1435
  %v1437 = getelementptr i8, ptr %v1428, i64 %v695
  %v1438 = load double, ptr %v1437, align 8, !noalias !124
  %v1439 = fadd double %v1438, %v1436
  %v1440 = fmul double %v1417, %v1439
  %v1441 = getelementptr i8, ptr %v1428, i64 %v696
  %v1442 = load double, ptr %v1441, align 8, !noalias !124
  %v1443 = fadd double %v1442, %v1440
  %v1444 = fmul double %v1423, %v1443
  %v1445 = getelementptr i8, ptr %v1428, i64 %v697
  %v1446 = load double, ptr %v1445, align 8, !noalias !124
  %v1447 = fadd double %v1446, %v1444
  %v1448 = fmul double %v1417, %v1447
  %v1449 = getelementptr i8, ptr %v1428, i64 %v698
  %v1450 = load double, ptr %v1449, align 8, !noalias !124
  %v1451 = fadd double %v1450, %v1448
  %v1452 = fmul double %v1423, %v1451
  %v1453 = getelementptr i8, ptr %v1428, i64 %v699
  %v1454 = load double, ptr %v1453, align 8, !noalias !124
  %v1455 = fadd double %v1454, %v1452
  %v1456 = fmul double %v1417, %v1455
  %v1426 = add nsw i64 %v1425, 1
  %v1457 = load double, ptr %v1428, align 8, !noalias !124
  %v1458 = fadd double %v1457, %v1456
  %v1459 = getelementptr double, ptr %v690, i64 %v1427
  store double %v1458, ptr %v1459, align 8, !noalias !114
  %v1460 = icmp eq i64 %v10, %v1426
  br i1 %v1460, label %v1412, label %v1424

v1412:
  %v1461 = icmp eq i64 %v1410, 8
  %v1462 = select i1 %v1461, i64 17, i64 16
  %v1463 = mul i64 %v691, %v1410
  %v1464 = load i64, ptr %v692, align 8, !noalias !128
  %v1465 = mul nsw i64 %v1462, %v10
  %v1466 = getelementptr double, ptr %v159, i64 %v1465
  %v1467 = getelementptr double, ptr %v187, i64 %v1463
  %v1468 = inttoptr i64 %v1464 to ptr
  tail call void %v1468(ptr nonnull %v687, ptr %v1466, ptr %v166, ptr %v173, ptr %v180, ptr %v1467), !noalias !128
  %v1469 = icmp eq i64 %v1411, 9
  br i1 %v1469, label %v1415, label %v1409

v1415:
  %v1470 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v1409 ], [ null, %v1412 ]
  %v1471 = phi i32 [ 1, %v1409 ], [ 0, %v1412 ]
  br i1 %v1413, label %v1472, label %v1473, !prof !131

v1405:
  %v1474 = phi i1 [ %v1404, %v1395 ], [ %v1475, %v1473 ]
  %v1476 = xor i1 %v1386, true
  %v1477 = select i1 %v1476, i1 true, i1 %v1474
  br i1 %v1477, label %v1478, label %v1479

v1478:
  br i1 %v710, label %v1480, label %v1481

v1482:
  %v1483 = load i64, ptr %v721, align 8, !noalias !132
  %v1484 = inttoptr i64 %v1483 to ptr
  tail call void %v1484(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !132
  br label %v1481

v1480:
  %v1485 = phi i64 [ %v1486, %v1480 ], [ 1, %v1478 ]
  %v1486 = add i64 %v1485, 1
  %v1487 = add nsw i64 %v711, %v1485
  %v1488 = icmp slt i64 %v1487, 0
  %v1489 = select i1 %v1488, i64 %v7, i64 0
  %v1490 = getelementptr i64, ptr %v6, i64 %v1487
  %v1491 = getelementptr i64, ptr %v1490, i64 %v1489
  %v1492 = load i64, ptr %v1491, align 8, !noalias !138
  %v1493 = inttoptr i64 %v1492 to ptr
  tail call void %v1493(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !138
  %v1494 = add nsw i64 %v1485, 13
  %v1495 = load i64, ptr %v6, align 8, !noalias !141
  %v1496 = mul nsw i64 %v1494, %v714
  %v1497 = getelementptr double, ptr %v159, i64 %v1496
  %v1498 = inttoptr i64 %v1495 to ptr
  tail call void %v1498(ptr %v713, ptr %v716, ptr %v166, ptr %v173, ptr %v180, ptr %v1497), !noalias !141
  %v1499 = icmp eq i64 %v1485, %v12
  br i1 %v1499, label %v1482, label %v1480

v1481:
  %v1500 = load i64, ptr %v722, align 8, !noalias !144
  %v1501 = inttoptr i64 %v1500 to ptr
  tail call void %v1501(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !144
  %v1502 = select i1 %v673, i1 true, i1 %v1400
  %v1503 = or i1 %v1502, %v294
  br i1 %v1503, label %v1504, label %v1505

v1506:
  %v1507 = getelementptr double, ptr %v726, i64 %v1508
  %v1509 = load double, ptr %v1507, align 8, !noalias !147
  %v1510 = fcmp uge double %v1509, 5.000000e-01
  %v1511 = icmp slt i64 %v1512, %v94
  %v1513 = select i1 %v1510, i1 %v1511, i1 false
  br i1 %v1513, label %v1514, label %v1515

v1514:
  %v1516 = icmp slt i64 %v1512, 0
  %v1517 = select i1 %v1516, i64 %v94, i64 0
  %v1518 = getelementptr double, ptr %v93, i64 %v1512
  %v1519 = getelementptr double, ptr %v1518, i64 %v1517
  %v1520 = load double, ptr %v1519, align 8, !noalias !147
  %v1521 = getelementptr double, ptr %v728, i64 %v1508
  %v1522 = load double, ptr %v1521, align 8, !noalias !147
  %v1523 = fcmp olt double %v1520, %v1522
  br i1 %v1523, label %v1524, label %v1515

v1524:
  %v1525 = getelementptr double, ptr %v730, i64 %v1508
  %v1526 = load double, ptr %v1525, align 8, !noalias !147
  %v1527 = fcmp ogt double %v1526, 1.000000e+00
  br i1 %v1527, label %v1528, label %v1515

v1528:
  %v1529 = getelementptr double, ptr %v732, i64 %v1508
  %v1530 = load double, ptr %v1529, align 8, !noalias !147
  store double 0.000000e+00, ptr %v1507, align 8, !noalias !151
  %v1531 = getelementptr double, ptr %v734, i64 %v1508
  store double 0.000000e+00, ptr %v1531, align 8, !noalias !151
  %v1532 = getelementptr double, ptr %v735, i64 %v1508
  store double %v1530, ptr %v1532, align 8, !noalias !151
  %v1533 = load i64, ptr %v1534, align 8, !noalias !151
  %v1535 = icmp slt i64 %v1533, 0
  %v1536 = select i1 %v1535, i64 %v126, i64 0
  %v1537 = add i64 %v1536, %v1533
  %v1538 = mul i64 %v1537, %v127
  %v1539 = getelementptr i64, ptr %v125, i64 %v1538
  %v1540 = load i64, ptr %v1539, align 8, !noalias !151
  %v1541 = add nsw i64 %v1540, -1
  store i64 %v1541, ptr %v1539, align 8, !noalias !151
  %v1542 = load i64, ptr %v1534, align 8, !noalias !151
  %v1543 = icmp slt i64 %v1542, 0
  %v1544 = select i1 %v1543, i64 %v126, i64 0
  %v1545 = add i64 %v1544, %v1542
  %v1546 = mul i64 %v1545, %v127
  %v1547 = getelementptr i64, ptr %v125, i64 %v1546
  %v1548 = getelementptr i8, ptr %v1547, i64 24
  %v1549 = load i64, ptr %v1548, align 8, !noalias !151
  %v1550 = add nsw i64 %v1549, 1
  store i64 %v1550, ptr %v1548, align 8, !noalias !151
  %v1551 = load double, ptr %v1519, align 8, !noalias !147
  %v1552 = getelementptr double, ptr %v737, i64 %v1508
  store double %v1551, ptr %v1552, align 8, !noalias !147
  %v1553 = mul i64 %v1554, %v127
  %v1555 = getelementptr i64, ptr %v125, i64 %v1553
  %v1556 = getelementptr i8, ptr %v1555, i64 8
  %v1557 = load i64, ptr %v1556, align 8, !noalias !147
  %v1558 = add nsw i64 %v1557, %v12
  store i64 %v1558, ptr %v1556, align 8, !noalias !147
  br label %v1515

v1515:
  %v1559 = icmp sgt i64 %v1560, 1
  br i1 %v1559, label %v1505, label %v1504

v1505:
  %v1560 = phi i64 [ %v1561, %v1515 ], [ %v295, %v1481 ]
  %v1508 = phi i64 [ %v1562, %v1515 ], [ 0, %v1481 ]
  %v1561 = add nsw i64 %v1560, -1
  %v1562 = add nsw i64 %v1508, 1
  %v1534 = getelementptr i64, ptr %v143, i64 %v1508
  %v1554 = load i64, ptr %v1534, align 8, !noalias !147
  %v1563 = getelementptr i64, ptr %v724, i64 %v1508
  %v1512 = load i64, ptr %v1563, align 8, !noalias !147
  %v1564 = icmp slt i64 %v1554, 0
  br i1 %v1564, label %v1515, label %v1506

v1504:
  br i1 %v1474, label %v1565, label %v1566

v1565:
  call void @llvm.lifetime.start.p0(ptr nonnull %v289)
  call void @llvm.lifetime.start.p0(ptr nonnull %v290)
  store i8 0, ptr %v289, align 1, !noalias !154
  store ptr null, ptr %v290, align 8, !noalias !154
  br label %v1567

v1567:
  %v1568 = phi i64 [ 0, %v1565 ], [ %v1569, %v1570 ]
  %v1569 = add nsw i64 %v1568, 1
  %v1571 = icmp ult i64 %v1568, 9
  br i1 %v1571, label %v1572, label %v1573

v1572:
  %v1574 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v1568
  %v1575 = load double, ptr %v1574, align 8
  %v1576 = load double, ptr %v134, align 8, !noalias !158
  %v1577 = load double, ptr %v740, align 8, !noalias !158
  %v1578 = fmul double %v1575, %v1577
  %v1579 = fadd double %v1576, %v1578
  store double %v1579, ptr %v742, align 8, !noalias !158
  br i1 %v744, label %v1570, label %v1580

v1580:
  %v1581 = fsub double 1.000000e+00, %v1575
  br label %v1582

v1582:
  %v1583 = phi i64 [ 0, %v1580 ], [ %v1584, %v1582 ]
  %v1585 = mul i64 %v1583, %v197
  %v1586 = getelementptr double, ptr %v194, i64 %v1585
  %v1587 = getelementptr i8, ptr %v1586, i64 %v748
  %v1588 = load double, ptr %v1587, align 8, !noalias !165
  %v1589 = fadd double %v1588, 0.000000e+00
  %v1590 = fmul double %v1575, %v1589
  %v1591 = getelementptr i8, ptr %v1586, i64 %v749
  %v1592 = load double, ptr %v1591, align 8, !noalias !165
  %v1593 = fadd double %v1592, %v1590
  %v1594 = fmul double %v1581, %v1593
  %v1595 = getelementptr i8, ptr %v1586, i64 %v750
  %v1596 = load double, ptr %v1595, align 8, !noalias !165
  %v1597 = fadd double %v1596, %v1594
  %v1598 = fmul double %v1575, %v1597
  %v1599 = getelementptr i8, ptr %v1586, i64 %v751
  %v1600 = load double, ptr %v1599, align 8, !noalias !165
  %v1601 = fadd double %v1600, %v1598
  %v1602 = fmul double %v1581, %v1601
  %v1603 = getelementptr i8, ptr %v1586, i64 %v752
  %v1604 = load double, ptr %v1603, align 8, !noalias !165
  %v1605 = fadd double %v1604, %v1602
  %v1606 = fmul double %v1575, %v1605
  %v1607 = getelementptr i8, ptr %v1586, i64 %v753
  %v1608 = load double, ptr %v1607, align 8, !noalias !165
  %v1609 = fadd double %v1608, %v1606
  %v1610 = fmul double %v1581, %v1609
  %v1611 = getelementptr i8, ptr %v1586, i64 %v754
  %v1612 = load double, ptr %v1611, align 8, !noalias !165
  %v1613 = fadd double %v1612, %v1610
  %v1614 = fmul double %v1575, %v1613
  %v1584 = add nsw i64 %v1583, 1
  %v1615 = load double, ptr %v1586, align 8, !noalias !165
  %v1616 = fadd double %v1615, %v1614
  %v1617 = getelementptr double, ptr %v745, i64 %v1585
  store double %v1616, ptr %v1617, align 8, !noalias !158
  %v1618 = icmp eq i64 %v10, %v1584
  br i1 %v1618, label %v1570, label %v1582

v1570:
  %v1619 = icmp eq i64 %v1568, 8
  %v1620 = select i1 %v1619, i64 17, i64 16
  %v1621 = mul i64 %v1568, %v746
  %v1622 = load i64, ptr %v747, align 8, !noalias !169
  %v1623 = mul nsw i64 %v1620, %v10
  %v1624 = getelementptr double, ptr %v159, i64 %v1623
  %v1625 = getelementptr double, ptr %v187, i64 %v1621
  %v1626 = inttoptr i64 %v1622 to ptr
  tail call void %v1626(ptr nonnull %v742, ptr %v1624, ptr %v166, ptr %v173, ptr %v180, ptr %v1625), !noalias !169
  %v1627 = icmp eq i64 %v1569, 9
  br i1 %v1627, label %v1573, label %v1567

v1573:
  %v1628 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v1567 ], [ null, %v1570 ]
  %v1629 = phi i32 [ 1, %v1567 ], [ 0, %v1570 ]
  br i1 %v1571, label %v1630, label %v1631, !prof !131

v1630:
  %v1632 = load double, ptr %v756, align 8, !noalias !172
  %v1633 = load double, ptr %v93, align 8, !noalias !172
  %v1634 = fsub double %v1632, %v1633
  %v1635 = fmul double %v1634, 1.000000e-13
  %v1636 = load double, ptr %v134, align 8, !noalias !172
  %v1637 = tail call double @llvm.fabs.f64(double %v1636)
  %v1638 = fmul double %v1637, 4.000000e-15
  %v1639 = fcmp ogt double %v1638, %v1635
  %v1640 = select i1 %v1639, double %v1638, double %v1635
  %v1641 = load double, ptr %v740, align 8, !noalias !179
  %v1642 = fdiv double %v1640, %v1641
  %v1643 = fcmp olt double %v1642, 1.000000e+00
  %v1644 = select i1 %v1643, double %v1642, double 1.000000e+00
  br i1 %v757, label %v1645, label %v1646

v1647:
  %v1648 = fcmp olt double %v1649, %v1650
  %v1651 = select i1 %v1648, double %v1649, double %v1650
  %v1652 = fcmp ogt double %v1649, %v1653
  %v1654 = select i1 %v1652, double %v1649, double %v1653
  br label %v1655

v1655:
  %v1656 = phi double [ %v1654, %v1647 ], [ %v1653, %v1657 ]
  %v1658 = phi double [ %v1651, %v1647 ], [ %v1650, %v1657 ]
  %v1659 = icmp eq i64 %v1660, 9
  br i1 %v1659, label %v1661, label %v1657

v1661:
  %v1662 = fsub double %v1656, %v1658
  %v1663 = fmul double %v1644, %v1662
  %v1664 = tail call i1 @llvm.is.fpclass.f64(double %v1665, i32 543)
  %v1666 = select i1 %v1664, double 0.000000e+00, double %v1665
  %v1667 = tail call i1 @llvm.is.fpclass.f64(double %v1663, i32 543)
  %v1668 = select i1 %v1667, double -0.000000e+00, double %v1663
  %v1669 = fadd double %v1666, %v1668
  %v1670 = getelementptr double, ptr %v760, i64 %v1671
  %v1672 = load double, ptr %v1670, align 8, !noalias !179
  %v1673 = sub nsw i64 %v1674, %v19
  %v1675 = getelementptr double, ptr %v216, i64 %v1673
  %v1676 = load double, ptr %v1675, align 8, !noalias !179
  %v1677 = getelementptr double, ptr %v761, i64 %v1671
  store double %v1669, ptr %v1677, align 8, !noalias !179
  %v1678 = fcmp ule double %v1676, 5.000000e-01
  %v1679 = fcmp ule double %v1672, 0.000000e+00
  %v1680 = select i1 %v1678, i1 true, i1 %v1679
  %v1681 = select i1 %v1680, double %v1669, double 0.000000e+00
  %v1682 = getelementptr double, ptr %v1677, i64 %v758
  store double %v1681, ptr %v1682, align 8, !noalias !179
  %v1683 = getelementptr i8, ptr %v1677, i64 %v762
  store double %v1681, ptr %v1683, align 8, !noalias !179
  %v1684 = getelementptr i8, ptr %v1677, i64 %v763
  store double %v1681, ptr %v1684, align 8, !noalias !179
  %v1685 = getelementptr i8, ptr %v1677, i64 %v764
  store double %v1681, ptr %v1685, align 8, !noalias !179
  %v1686 = getelementptr i8, ptr %v1677, i64 %v765
  store double %v1681, ptr %v1686, align 8, !noalias !179
  %v1687 = getelementptr i8, ptr %v1677, i64 %v766
  store double %v1681, ptr %v1687, align 8, !noalias !179
  %v1688 = getelementptr i8, ptr %v1677, i64 %v767
  store double %v1681, ptr %v1688, align 8, !noalias !179
  %v1689 = getelementptr i8, ptr %v1677, i64 %v768
  store double %v1681, ptr %v1689, align 8, !noalias !179
  %v1690 = add nsw i64 %v1691, -1
  %v1692 = add i64 %v1674, 1
  %v1693 = icmp sgt i64 %v1691, 1
  br i1 %v1693, label %v1646, label %v1645

v1646:
  %v1691 = phi i64 [ %v1690, %v1661 ], [ %v16, %v1630 ]
  %v1674 = phi i64 [ %v1692, %v1661 ], [ %v19, %v1630 ]
  %v1694 = icmp slt i64 %v1674, 0
  %v1695 = select i1 %v1694, i64 %v208, i64 0
  %v1671 = add i64 %v1695, %v1674
  br label %v1657

v1657:
  %v1650 = phi double [ 0x7FF0000000000000, %v1646 ], [ %v1658, %v1655 ]
  %v1653 = phi double [ 0xFFF0000000000000, %v1646 ], [ %v1656, %v1655 ]
  %v1696 = phi double [ 0.000000e+00, %v1646 ], [ %v1665, %v1655 ]
  %v1697 = phi i64 [ 0, %v1646 ], [ %v1660, %v1655 ]
  %v1660 = add nsw i64 %v1697, 1
  %v1698 = mul i64 %v1697, %v758
  %v1699 = getelementptr double, ptr %v205, i64 %v1698
  %v1700 = getelementptr i8, ptr %v1699, i64 %v759
  %v1701 = getelementptr double, ptr %v1700, i64 %v1671
  %v1702 = load double, ptr %v1701, align 8, !noalias !179
  %v1703 = tail call i1 @llvm.is.fpclass.f64(double %v1702, i32 543)
  %v1704 = fadd double %v1702, 0.000000e+00
  %v1705 = select i1 %v1703, double 0.000000e+00, double %v1704
  %v1706 = fcmp ogt double %v1705, %v1696
  %v1665 = select i1 %v1706, double %v1705, double %v1696
  %v1707 = getelementptr double, ptr %v1699, i64 %v208
  %v1708 = getelementptr double, ptr %v1707, i64 %v1671
  %v1649 = load double, ptr %v1708, align 8, !noalias !179
  %v1709 = tail call double @llvm.fabs.f64(double %v1649)
  %v1710 = fcmp ueq double %v1709, 0x7FF0000000000000
  br i1 %v1710, label %v1655, label %v1647

v1645:
  store i8 0, ptr %v289, align 1, !noalias !154
  %v1711 = call fastcc i32 @_ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr %v289, ptr %v290, i64 %v13, ptr nonnull readonly %v93, i64 %v94, ptr %v125, i64 %v126, i64 %v127, ptr nonnull %v134, i64 %v136, ptr %v143, i64 %v145, ptr %v205, i64 %v206, i64 %v207, i64 %v208, double 0.000000e+00)
  %v1712 = icmp eq i32 %v1711, 0
  br i1 %v1712, label %v1713, label %v1714, !prof !131

v1714:
  %v1715 = load ptr, ptr %v290, align 8, !noalias !154
  br label %v1631

v1713:
  %v1716 = load i8, ptr %v289, align 1, !noalias !154
  %v1717 = icmp eq i8 %v1716, 0
  br label %v1631

v1631:
  %v1718 = phi i1 [ %v1717, %v1713 ], [ true, %v1714 ], [ true, %v1573 ]
  %v1719 = phi ptr [ null, %v1713 ], [ %v1715, %v1714 ], [ %v1628, %v1573 ]
  %v1720 = phi i32 [ 0, %v1713 ], [ 1, %v1714 ], [ %v1629, %v1573 ]
  call void @llvm.lifetime.end.p0(ptr nonnull %v289)
  call void @llvm.lifetime.end.p0(ptr nonnull %v290)
  %v1721 = icmp eq i32 %v1720, 0
  %v1722 = select i1 %v1721, ptr undef, ptr %v1719
  br i1 %v1721, label %v1723, label %v1479, !prof !131

v1724:
  %v1725 = load double, ptr %v770, align 8, !noalias !180
  %v1726 = load double, ptr %v740, align 8, !noalias !180
  %v1727 = load double, ptr %v772, align 8, !noalias !180
  %v1728 = load double, ptr %v93, align 8, !noalias !180
  %v1729 = fsub double %v1727, %v1728
  %v1730 = load double, ptr %v774, align 8, !noalias !180
  %v1731 = load double, ptr %v776, align 8, !noalias !180
  %v1732 = fsub double %v1730, %v1731
  %v1733 = fmul double %v1729, 5.000000e-06
  %v1734 = fcmp olt double %v1732, %v1733
  br label %v1735

v1736:
  %v1737 = sub nsw i64 45, %v1738
  %v1739 = load double, ptr %v781, align 8, !noalias !184
  %v1740 = load double, ptr %v783, align 8, !noalias !184
  br label %v1741

v1741:
  %v1742 = phi double [ %v1743, %v1741 ], [ 1.000000e+00, %v1736 ]
  %v1744 = phi double [ %v1745, %v1741 ], [ 2.000000e+00, %v1736 ]
  %v1746 = phi i64 [ %v1747, %v1741 ], [ %v1737, %v1736 ]
  %v1748 = and i64 %v1746, 1
  %v1749 = icmp eq i64 %v1748, 0
  %v1750 = fmul double %v1742, %v1744
  %v1743 = select i1 %v1749, double %v1742, double %v1750
  %v1747 = lshr i64 %v1746, 1
  %v1745 = fmul double %v1744, %v1744
  %v1751 = icmp eq i64 %v1747, 0
  br i1 %v1751, label %v1752, label %v1741

v1753:
  %v1754 = fcmp olt double %v1755, 0.000000e+00
  %v1756 = select i1 %v1754, double 0.000000e+00, double %v1755
  %v1757 = fmul double %v1758, %v1756
  %v1759 = fsub double %v1760, %v1757
  br label %v1761

v1752:
  %v1762 = fadd double %v1763, %v1764
  %v1760 = fmul double %v1762, 5.000000e-01
  %v1765 = fmul double %v1743, 1.000000e-13
  %v1766 = fsub double %v1765, %v1767
  %v1755 = fmul double %v1766, 5.000000e-01
  %v1768 = fmul double %v1764, %v1740
  %v1769 = fmul double %v1763, %v1739
  %v1770 = fsub double %v1768, %v1769
  %v1771 = fsub double %v1740, %v1739
  %v1772 = fdiv double %v1770, %v1771
  %v1773 = fcmp olt double %v1764, %v1772
  %v1774 = fcmp olt double %v1772, %v1763
  %v1775 = and i1 %v1773, %v1774
  %v1776 = select i1 %v1775, double %v1772, double %v1760
  %v1777 = fsub double %v1760, %v1776
  %v1758 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v1777)
  %v1778 = fmul double %v1767, %v1767
  %v1779 = tail call double @llvm.fabs.f64(double %v1777)
  %v1780 = fcmp olt double %v1779, %v1778
  %v1781 = select i1 %v1780, double %v1779, double %v1778
  %v1782 = fmul double %v1758, %v1781
  %v1783 = fadd double %v1776, %v1782
  %v1784 = fsub double %v1783, %v1760
  %v1785 = tail call double @llvm.fabs.f64(double %v1784)
  %v1786 = fcmp ugt double %v1785, %v1755
  br i1 %v1786, label %v1753, label %v1761

v1787:
  store double %v1788, ptr %v778, align 8, !noalias !190
  store double %v1789, ptr %v783, align 8, !noalias !190
  br label %v1790

v1791:
  store double %v1788, ptr %v770, align 8, !noalias !190
  store double %v1789, ptr %v781, align 8, !noalias !190
  br label %v1790

v1790:
  %v1792 = icmp eq i64 %v1793, 45
  br i1 %v1792, label %v1794, label %v1735

v1735:
  %v1738 = phi i64 [ 0, %v1724 ], [ %v1793, %v1790 ]
  %v1793 = add nsw i64 %v1738, 1
  %v1763 = load double, ptr %v778, align 8, !noalias !190
  %v1764 = load double, ptr %v770, align 8, !noalias !190
  %v1767 = fsub double %v1763, %v1764
  %v1795 = fcmp ugt double %v1767, 1.000000e-13
  br i1 %v1795, label %v1736, label %v1794

v1761:
  %v1788 = phi double [ %v1783, %v1752 ], [ %v1759, %v1753 ]
  %v1796 = load double, ptr %v134, align 8, !noalias !191
  %v1797 = load double, ptr %v740, align 8, !noalias !191
  %v1798 = fmul double %v1788, %v1797
  %v1799 = fadd double %v1796, %v1798
  store double %v1799, ptr %v742, align 8, !noalias !191
  br i1 %v784, label %v1800, label %v1801

v1800:
  %v1802 = fsub double 1.000000e+00, %v1788
  br label %v1803

v1803:
  %v1804 = phi i64 [ 0, %v1800 ], [ %v1805, %v1803 ]
  %v1806 = mul i64 %v1804, %v197
  %v1807 = getelementptr double, ptr %v194, i64 %v1806
  %v1808 = getelementptr i8, ptr %v1807, i64 %v748
  %v1809 = load double, ptr %v1808, align 8, !noalias !198
  %v1810 = fadd double %v1809, 0.000000e+00
  %v1811 = fmul double %v1788, %v1810
  %v1812 = getelementptr i8, ptr %v1807, i64 %v749
  %v1813 = load double, ptr %v1812, align 8, !noalias !198
  %v1814 = fadd double %v1813, %v1811
  %v1815 = fmul double %v1802, %v1814
  %v1816 = getelementptr i8, ptr %v1807, i64 %v750
  %v1817 = load double, ptr %v1816, align 8, !noalias !198
  %v1818 = fadd double %v1817, %v1815
  %v1819 = fmul double %v1788, %v1818
  %v1820 = getelementptr i8, ptr %v1807, i64 %v751
  %v1821 = load double, ptr %v1820, align 8, !noalias !198
  %v1822 = fadd double %v1821, %v1819
  %v1823 = fmul double %v1802, %v1822
  %v1824 = getelementptr i8, ptr %v1807, i64 %v752
  %v1825 = load double, ptr %v1824, align 8, !noalias !198
  %v1826 = fadd double %v1825, %v1823
  %v1827 = fmul double %v1788, %v1826
  %v1828 = getelementptr i8, ptr %v1807, i64 %v753
  %v1829 = load double, ptr %v1828, align 8, !noalias !198
  %v1830 = fadd double %v1829, %v1827
  %v1831 = fmul double %v1802, %v1830
  %v1832 = getelementptr i8, ptr %v1807, i64 %v754
  %v1833 = load double, ptr %v1832, align 8, !noalias !198
  %v1834 = fadd double %v1833, %v1831
  %v1835 = fmul double %v1788, %v1834
  %v1805 = add nsw i64 %v1804, 1
  %v1836 = load double, ptr %v1807, align 8, !noalias !198
  %v1837 = fadd double %v1836, %v1835
  %v1838 = getelementptr double, ptr %v745, i64 %v1806
  store double %v1837, ptr %v1838, align 8, !noalias !191
  %v1839 = icmp eq i64 %v10, %v1805
  br i1 %v1839, label %v1801, label %v1803

v1801:
  %v1840 = load i64, ptr %v747, align 8, !noalias !202
  %v1841 = inttoptr i64 %v1840 to ptr
  tail call void %v1841(ptr nonnull %v742, ptr %v786, ptr %v166, ptr %v173, ptr %v180, ptr %v788), !noalias !202
  br i1 %v791, label %v1842, label %v1843

v1842:
  %v1844 = phi i64 [ %v1845, %v1842 ], [ %v790, %v1801 ]
  %v1846 = phi i64 [ %v1847, %v1842 ], [ %v19, %v1801 ]
  %v1845 = add nsw i64 %v1844, -1
  %v1847 = add i64 %v1846, 1
  %v1848 = icmp slt i64 %v1846, 0
  %v1849 = select i1 %v1848, i64 %v208, i64 0
  %v1850 = add i64 %v1849, %v1846
  %v1851 = getelementptr double, ptr %v795, i64 %v1850
  %v1852 = load double, ptr %v1851, align 8, !noalias !205
  %v1853 = getelementptr double, ptr %v798, i64 %v1850
  store double %v1852, ptr %v1853, align 8, !noalias !205
  %v1854 = icmp sgt i64 %v1844, 1
  br i1 %v1854, label %v1842, label %v1843

v1843:
  br i1 %v799, label %v1855, label %v1856

v1856:
  %v1857 = phi double [ %v1858, %v1856 ], [ 0x7FF0000000000000, %v1843 ]
  %v1859 = phi i64 [ %v1860, %v1856 ], [ 0, %v1843 ]
  %v1860 = add nsw i64 %v1859, 1
  %v1861 = getelementptr double, ptr %v800, i64 %v1859
  %v1862 = load double, ptr %v1861, align 8, !noalias !206
  %v1863 = getelementptr double, ptr %v798, i64 %v1859
  %v1864 = load double, ptr %v1863, align 8, !noalias !206
  %v1865 = fadd double %v1862, %v1864
  %v1866 = fcmp olt double %v1865, %v1857
  %v1858 = select i1 %v1866, double %v1865, double %v1857
  %v1867 = icmp eq i64 %v208, %v1860
  br i1 %v1867, label %v1855, label %v1856

v1855:
  %v1789 = phi double [ 0x7FF0000000000000, %v1843 ], [ %v1858, %v1856 ]
  %v1868 = fcmp olt double %v1789, 0.000000e+00
  br i1 %v1868, label %v1787, label %v1791

v1869:
  %v1870 = load double, ptr %v778, align 8, !noalias !210
  %v1871 = load double, ptr %v134, align 8, !noalias !214
  %v1872 = load double, ptr %v740, align 8, !noalias !214
  %v1873 = fmul double %v1870, %v1872
  %v1874 = fadd double %v1871, %v1873
  store double %v1874, ptr %v742, align 8, !noalias !214
  br i1 %v784, label %v1875, label %v1876

v1875:
  %v1877 = fsub double 1.000000e+00, %v1870
  br label %v1878

v1878:
  %v1879 = phi i64 [ 0, %v1875 ], [ %v1880, %v1878 ]
  %v1881 = mul i64 %v1879, %v197
  %v1882 = getelementptr double, ptr %v194, i64 %v1881
  %v1883 = getelementptr i8, ptr %v1882, i64 %v748
  %v1884 = load double, ptr %v1883, align 8, !noalias !221
  %v1885 = fadd double %v1884, 0.000000e+00
  %v1886 = fmul double %v1870, %v1885
  %v1887 = getelementptr i8, ptr %v1882, i64 %v749
  %v1888 = load double, ptr %v1887, align 8, !noalias !221
  %v1889 = fadd double %v1888, %v1886
  %v1890 = fmul double %v1877, %v1889
  %v1891 = getelementptr i8, ptr %v1882, i64 %v750
  %v1892 = load double, ptr %v1891, align 8, !noalias !221
  %v1893 = fadd double %v1892, %v1890
  %v1894 = fmul double %v1870, %v1893
  %v1895 = getelementptr i8, ptr %v1882, i64 %v751
  %v1896 = load double, ptr %v1895, align 8, !noalias !221
  %v1897 = fadd double %v1896, %v1894
  %v1898 = fmul double %v1877, %v1897
  %v1899 = getelementptr i8, ptr %v1882, i64 %v752
  %v1900 = load double, ptr %v1899, align 8, !noalias !221
  %v1901 = fadd double %v1900, %v1898
  %v1902 = fmul double %v1870, %v1901
  %v1903 = getelementptr i8, ptr %v1882, i64 %v753
  %v1904 = load double, ptr %v1903, align 8, !noalias !221
  %v1905 = fadd double %v1904, %v1902
  %v1906 = fmul double %v1877, %v1905
  %v1907 = getelementptr i8, ptr %v1882, i64 %v754
  %v1908 = load double, ptr %v1907, align 8, !noalias !221
  %v1909 = fadd double %v1908, %v1906
  %v1910 = fmul double %v1870, %v1909
  %v1880 = add nsw i64 %v1879, 1
  %v1911 = load double, ptr %v1882, align 8, !noalias !221
  %v1912 = fadd double %v1911, %v1910
  %v1913 = getelementptr double, ptr %v745, i64 %v1881
  store double %v1912, ptr %v1913, align 8, !noalias !214
  %v1914 = icmp eq i64 %v10, %v1880
  br i1 %v1914, label %v1876, label %v1878

v1876:
  %v1915 = load i64, ptr %v747, align 8, !noalias !225
  %v1916 = inttoptr i64 %v1915 to ptr
  tail call void %v1916(ptr nonnull %v742, ptr %v786, ptr %v166, ptr %v173, ptr %v180, ptr %v788), !noalias !225
  br i1 %v791, label %v1917, label %v1918

v1918:
  br label %v1919

v1917:
  %v1920 = phi i64 [ %v1921, %v1917 ], [ %v790, %v1876 ]
  %v1922 = phi i64 [ %v1923, %v1917 ], [ %v19, %v1876 ]
  %v1921 = add nsw i64 %v1920, -1
  %v1923 = add i64 %v1922, 1
  %v1924 = icmp slt i64 %v1922, 0
  %v1925 = select i1 %v1924, i64 %v208, i64 0
  %v1926 = add i64 %v1925, %v1922
  %v1927 = getelementptr double, ptr %v795, i64 %v1926
  %v1928 = load double, ptr %v1927, align 8, !noalias !228
  %v1929 = getelementptr double, ptr %v798, i64 %v1926
  store double %v1928, ptr %v1929, align 8, !noalias !228
  %v1930 = icmp sgt i64 %v1920, 1
  br i1 %v1930, label %v1917, label %v1918

v1931:
  %v1932 = icmp slt i64 %v1933, 0
  %v1934 = select i1 %v1932, i64 %v208, i64 0
  %v1935 = add i64 %v1934, %v1933
  %v1936 = getelementptr double, ptr %v800, i64 %v1935
  %v1937 = load double, ptr %v1936, align 8, !noalias !210
  store double %v1937, ptr %v783, align 8, !noalias !210
  br label %v1938

v1939:
  %v1940 = phi i64 [ 0, %v1941 ], [ %v1942, %v1939 ]
  %v1943 = mul i64 %v1940, %v197
  %v1944 = getelementptr double, ptr %v194, i64 %v1943
  %v1945 = getelementptr i8, ptr %v1944, i64 %v748
  %v1946 = load double, ptr %v1945, align 8, !noalias !229
  %v1947 = fadd double %v1946, 0.000000e+00
  %v1948 = fmul double %v1949, %v1947
  %v1950 = getelementptr i8, ptr %v1944, i64 %v749
  %v1951 = load double, ptr %v1950, align 8, !noalias !229
  %v1952 = fadd double %v1951, %v1948
  %v1953 = fmul double %v1954, %v1952
  %v1955 = getelementptr i8, ptr %v1944, i64 %v750
  %v1956 = load double, ptr %v1955, align 8, !noalias !229
  %v1957 = fadd double %v1956, %v1953
  %v1958 = fmul double %v1949, %v1957
  %v1959 = getelementptr i8, ptr %v1944, i64 %v751
  %v1960 = load double, ptr %v1959, align 8, !noalias !229
  %v1961 = fadd double %v1960, %v1958
  %v1962 = fmul double %v1954, %v1961
  %v1963 = getelementptr i8, ptr %v1944, i64 %v752
  %v1964 = load double, ptr %v1963, align 8, !noalias !229
  %v1965 = fadd double %v1964, %v1962
  %v1966 = fmul double %v1949, %v1965
  %v1967 = getelementptr i8, ptr %v1944, i64 %v753
  %v1968 = load double, ptr %v1967, align 8, !noalias !229
  %v1969 = fadd double %v1968, %v1966
  %v1970 = fmul double %v1954, %v1969
  %v1971 = getelementptr i8, ptr %v1944, i64 %v754
  %v1972 = load double, ptr %v1971, align 8, !noalias !229
  %v1973 = fadd double %v1972, %v1970
  %v1974 = fmul double %v1949, %v1973
  %v1942 = add nsw i64 %v1940, 1
  %v1975 = load double, ptr %v1944, align 8, !noalias !229
  %v1976 = fadd double %v1975, %v1974
  %v1977 = getelementptr double, ptr %v745, i64 %v1943
  store double %v1976, ptr %v1977, align 8, !noalias !239
  %v1978 = icmp eq i64 %v10, %v1942
  br i1 %v1978, label %v1979, label %v1939

v1979:
  %v1980 = load i64, ptr %v747, align 8, !noalias !240
  %v1981 = inttoptr i64 %v1980 to ptr
  tail call void %v1981(ptr nonnull %v742, ptr %v786, ptr %v166, ptr %v173, ptr %v180, ptr %v788), !noalias !240
  br i1 %v831, label %v1982, label %v1983

v1983:
  %v1984 = phi i64 [ %v1985, %v1983 ], [ %v790, %v1979 ]
  %v1986 = phi i64 [ %v1987, %v1983 ], [ %v19, %v1979 ]
  %v1985 = add nsw i64 %v1984, -1
  %v1987 = add i64 %v1986, 1
  %v1988 = icmp slt i64 %v1986, 0
  %v1989 = select i1 %v1988, i64 %v208, i64 0
  %v1990 = add i64 %v1989, %v1986
  %v1991 = getelementptr double, ptr %v795, i64 %v1990
  %v1992 = load double, ptr %v1991, align 8, !noalias !243
  %v1993 = getelementptr double, ptr %v798, i64 %v1990
  store double %v1992, ptr %v1993, align 8, !noalias !243
  %v1994 = icmp sgt i64 %v1984, 1
  br i1 %v1994, label %v1983, label %v1982

v1995:
  br i1 %v1996, label %v1997, label %v1998

v1997:
  %v1999 = load double, ptr %v778, align 8, !noalias !210
  br label %v1998

v1998:
  %v2000 = phi double [ %v1999, %v1997 ], [ %v1949, %v1995 ]
  %v2001 = fmul double %v2000, 5.000000e-01
  %v2002 = icmp eq i64 %v2003, 45
  br i1 %v2002, label %v2004, label %v1938

v2005:
  %v2006 = getelementptr double, ptr %v795, i64 %v1935
  store double 0.000000e+00, ptr %v2006, align 8, !noalias !210
  br label %v2007

v2008:
  %v2009 = sub nsw i64 45, %v2010
  %v2011 = load double, ptr %v781, align 8, !noalias !244
  %v2012 = load double, ptr %v783, align 8, !noalias !244
  br label %v2013

v2013:
  %v2014 = phi double [ %v2015, %v2013 ], [ 1.000000e+00, %v2008 ]
  %v2016 = phi double [ %v2017, %v2013 ], [ 2.000000e+00, %v2008 ]
  %v2018 = phi i64 [ %v2019, %v2013 ], [ %v2009, %v2008 ]
  %v2020 = and i64 %v2018, 1
  %v2021 = icmp eq i64 %v2020, 0
  %v2022 = fmul double %v2014, %v2016
  %v2015 = select i1 %v2021, double %v2014, double %v2022
  %v2019 = lshr i64 %v2018, 1
  %v2017 = fmul double %v2016, %v2016
  %v2023 = icmp eq i64 %v2019, 0
  br i1 %v2023, label %v2024, label %v2013

v2025:
  %v2026 = fcmp olt double %v2027, 0.000000e+00
  %v2028 = select i1 %v2026, double 0.000000e+00, double %v2027
  %v2029 = fmul double %v2030, %v2028
  %v2031 = fsub double %v2032, %v2029
  br label %v2033

v2024:
  %v2034 = fadd double %v2035, %v2036
  %v2032 = fmul double %v2034, 5.000000e-01
  %v2037 = fmul double %v2015, 0x3D06849B86A12B9B
  %v2038 = fsub double %v2037, %v2039
  %v2027 = fmul double %v2038, 5.000000e-01
  %v2040 = fmul double %v2036, %v2012
  %v2041 = fmul double %v2035, %v2011
  %v2042 = fsub double %v2040, %v2041
  %v2043 = fsub double %v2012, %v2011
  %v2044 = fdiv double %v2042, %v2043
  %v2045 = fcmp olt double %v2036, %v2044
  %v2046 = fcmp olt double %v2044, %v2035
  %v2047 = and i1 %v2045, %v2046
  %v2048 = select i1 %v2047, double %v2044, double %v2032
  %v2049 = fsub double %v2032, %v2048
  %v2030 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v2049)
  %v2050 = fmul double %v2039, %v2039
  %v2051 = tail call double @llvm.fabs.f64(double %v2049)
  %v2052 = fcmp olt double %v2051, %v2050
  %v2053 = select i1 %v2052, double %v2051, double %v2050
  %v2054 = fmul double %v2030, %v2053
  %v2055 = fadd double %v2048, %v2054
  %v2056 = fsub double %v2055, %v2032
  %v2057 = tail call double @llvm.fabs.f64(double %v2056)
  %v2058 = fcmp ugt double %v2057, %v2027
  br i1 %v2058, label %v2025, label %v2033

v2059:
  store double %v2060, ptr %v778, align 8, !noalias !250
  store double %v2061, ptr %v783, align 8, !noalias !250
  br label %v2062

v2063:
  store double %v2060, ptr %v770, align 8, !noalias !250
  store double %v2061, ptr %v781, align 8, !noalias !250
  br label %v2062

v2062:
  %v2064 = icmp eq i64 %v2065, 45
  br i1 %v2064, label %v2066, label %v2007

v2007:
  %v2010 = phi i64 [ 0, %v2005 ], [ %v2065, %v2062 ]
  %v2065 = add nsw i64 %v2010, 1
  %v2035 = load double, ptr %v778, align 8, !noalias !250
  %v2036 = load double, ptr %v770, align 8, !noalias !250
  %v2039 = fsub double %v2035, %v2036
  %v2067 = fcmp ugt double %v2039, 0x3D06849B86A12B9B
  br i1 %v2067, label %v2008, label %v2066

v2033:
  %v2060 = phi double [ %v2055, %v2024 ], [ %v2031, %v2025 ]
  %v2068 = load double, ptr %v134, align 8, !noalias !251
  %v2069 = load double, ptr %v740, align 8, !noalias !251
  %v2070 = fmul double %v2060, %v2069
  %v2071 = fadd double %v2068, %v2070
  store double %v2071, ptr %v742, align 8, !noalias !251
  br i1 %v784, label %v2072, label %v2073

v2072:
  %v2074 = fsub double 1.000000e+00, %v2060
  br label %v2075

v2075:
  %v2076 = phi i64 [ 0, %v2072 ], [ %v2077, %v2075 ]
  %v2078 = mul i64 %v2076, %v197
  %v2079 = getelementptr double, ptr %v194, i64 %v2078
  %v2080 = getelementptr i8, ptr %v2079, i64 %v748
  %v2081 = load double, ptr %v2080, align 8, !noalias !258
  %v2082 = fadd double %v2081, 0.000000e+00
  %v2083 = fmul double %v2060, %v2082
  %v2084 = getelementptr i8, ptr %v2079, i64 %v749
  %v2085 = load double, ptr %v2084, align 8, !noalias !258
  %v2086 = fadd double %v2085, %v2083
  %v2087 = fmul double %v2074, %v2086
  %v2088 = getelementptr i8, ptr %v2079, i64 %v750
  %v2089 = load double, ptr %v2088, align 8, !noalias !258
  %v2090 = fadd double %v2089, %v2087
  %v2091 = fmul double %v2060, %v2090
  %v2092 = getelementptr i8, ptr %v2079, i64 %v751
  %v2093 = load double, ptr %v2092, align 8, !noalias !258
  %v2094 = fadd double %v2093, %v2091
  %v2095 = fmul double %v2074, %v2094
  %v2096 = getelementptr i8, ptr %v2079, i64 %v752
  %v2097 = load double, ptr %v2096, align 8, !noalias !258
  %v2098 = fadd double %v2097, %v2095
  %v2099 = fmul double %v2060, %v2098
  %v2100 = getelementptr i8, ptr %v2079, i64 %v753
  %v2101 = load double, ptr %v2100, align 8, !noalias !258
  %v2102 = fadd double %v2101, %v2099
  %v2103 = fmul double %v2074, %v2102
  %v2104 = getelementptr i8, ptr %v2079, i64 %v754
  %v2105 = load double, ptr %v2104, align 8, !noalias !258
  %v2106 = fadd double %v2105, %v2103
  %v2107 = fmul double %v2060, %v2106
  %v2077 = add nsw i64 %v2076, 1
  %v2108 = load double, ptr %v2079, align 8, !noalias !258
  %v2109 = fadd double %v2108, %v2107
  %v2110 = getelementptr double, ptr %v745, i64 %v2078
  store double %v2109, ptr %v2110, align 8, !noalias !251
  %v2111 = icmp eq i64 %v10, %v2077
  br i1 %v2111, label %v2073, label %v2075

v2073:
  %v2112 = load i64, ptr %v747, align 8, !noalias !262
  %v2113 = inttoptr i64 %v2112 to ptr
  tail call void %v2113(ptr nonnull %v742, ptr %v786, ptr %v166, ptr %v173, ptr %v180, ptr %v788), !noalias !262
  br i1 %v791, label %v2114, label %v2115

v2114:
  %v2116 = phi i64 [ %v2117, %v2114 ], [ %v790, %v2073 ]
  %v2118 = phi i64 [ %v2119, %v2114 ], [ %v19, %v2073 ]
  %v2117 = add nsw i64 %v2116, -1
  %v2119 = add i64 %v2118, 1
  %v2120 = icmp slt i64 %v2118, 0
  %v2121 = select i1 %v2120, i64 %v208, i64 0
  %v2122 = add i64 %v2121, %v2118
  %v2123 = getelementptr double, ptr %v795, i64 %v2122
  %v2124 = load double, ptr %v2123, align 8, !noalias !265
  %v2125 = getelementptr double, ptr %v798, i64 %v2122
  store double %v2124, ptr %v2125, align 8, !noalias !265
  %v2126 = icmp sgt i64 %v2116, 1
  br i1 %v2126, label %v2114, label %v2115

v2115:
  br i1 %v799, label %v2127, label %v2128

v2128:
  %v2129 = phi double [ %v2130, %v2128 ], [ 0x7FF0000000000000, %v2115 ]
  %v2131 = phi i64 [ %v2132, %v2128 ], [ 0, %v2115 ]
  %v2132 = add nsw i64 %v2131, 1
  %v2133 = getelementptr double, ptr %v800, i64 %v2131
  %v2134 = load double, ptr %v2133, align 8, !noalias !266
  %v2135 = getelementptr double, ptr %v798, i64 %v2131
  %v2136 = load double, ptr %v2135, align 8, !noalias !266
  %v2137 = fadd double %v2134, %v2136
  %v2138 = fcmp olt double %v2137, %v2129
  %v2130 = select i1 %v2138, double %v2137, double %v2129
  %v2139 = icmp eq i64 %v208, %v2132
  br i1 %v2139, label %v2127, label %v2128

v2127:
  %v2061 = phi double [ 0x7FF0000000000000, %v2115 ], [ %v2130, %v2128 ]
  %v2140 = fcmp olt double %v2061, 0.000000e+00
  br i1 %v2140, label %v2059, label %v2063

v2004:
  store double 0.000000e+00, ptr %v778, align 8, !noalias !210
  br label %v2066

v2066:
  store i64 %v1933, ptr %v833, align 8, !noalias !210
  %v2141 = load i64, ptr %v143, align 8, !noalias !270
  %v2142 = icmp sgt i64 %v2141, -1
  br i1 %v2142, label %v2143, label %v2144

v2143:
  %v2145 = getelementptr i64, ptr %v111, i64 %v2141
  %v2146 = load i64, ptr %v2145, align 8, !noalias !270
  %v2147 = icmp eq i64 %v2146, 0
  br i1 %v2147, label %v2148, label %v2144

v2148:
  store i64 4, ptr %v2145, align 8, !noalias !270
  br label %v2144

v2144:
  store double 0.000000e+00, ptr %v835, align 8, !noalias !210
  br label %v2149

v1919:
  %v2150 = phi i64 [ %v2151, %v2152 ], [ 0, %v1918 ]
  %v2153 = phi i64 [ %v2154, %v2152 ], [ %v830, %v1918 ]
  %v2155 = icmp sgt i64 %v2153, 0
  br i1 %v2155, label %v2152, label %v2156

v2152:
  %v2154 = add nsw i64 %v2153, -1
  %v2151 = add i64 %v2150, 1
  %v2157 = getelementptr double, ptr %v800, i64 %v2150
  %v2158 = load double, ptr %v2157, align 8, !noalias !273
  %v2159 = getelementptr double, ptr %v798, i64 %v2150
  %v2160 = load double, ptr %v2159, align 8, !noalias !273
  %v2161 = fneg double %v2160
  %v2162 = fcmp olt double %v2158, %v2161
  br i1 %v2162, label %v2156, label %v1919

v2156:
  %v1933 = phi i64 [ %v2150, %v2152 ], [ -1, %v1919 ]
  %v2163 = icmp slt i64 %v1933, %v19
  br i1 %v2163, label %v2164, label %v1931

v1938:
  %v1949 = phi double [ %v1725, %v1931 ], [ %v2001, %v1998 ]
  %v2165 = phi i64 [ 0, %v1931 ], [ %v2003, %v1998 ]
  %v2003 = add nsw i64 %v2165, 1
  %v1996 = icmp eq i64 %v2165, 0
  %v2166 = load double, ptr %v134, align 8, !noalias !239
  %v2167 = load double, ptr %v740, align 8, !noalias !239
  %v2168 = fmul double %v1949, %v2167
  %v2169 = fadd double %v2166, %v2168
  store double %v2169, ptr %v742, align 8, !noalias !239
  br i1 %v744, label %v1979, label %v1941

v1941:
  %v1954 = fsub double 1.000000e+00, %v1949
  br label %v1939

v1982:
  store double %v1949, ptr %v770, align 8, !noalias !210
  %v2170 = load double, ptr %v1936, align 8, !noalias !210
  store double %v2170, ptr %v781, align 8, !noalias !210
  %v2171 = fcmp ogt double %v2170, 0.000000e+00
  br i1 %v2171, label %v2005, label %v1995

v2172:
  br i1 %v1734, label %v2164, label %v2173

v2173:
  call void @llvm.lifetime.start.p0(ptr nonnull %v287), !noalias !180
  call void @llvm.lifetime.start.p0(ptr nonnull %v288), !noalias !180
  store i8 0, ptr %v287, align 1, !noalias !277
  store ptr null, ptr %v288, align 8, !noalias !277
  %v2174 = load double, ptr %v770, align 8, !noalias !277
  %v2175 = load double, ptr %v778, align 8, !noalias !277
  br i1 %v292, label %v2176, label %v2177

v2178:
  %v2179 = phi i64 [ %v2180, %v2181 ], [ 0, %v2182 ]
  %v2180 = add nsw i64 %v2179, 1
  %v2183 = icmp ult i64 %v2179, 9
  br i1 %v2183, label %v2184, label %v2185

v2184:
  %v2186 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v2179
  %v2187 = load double, ptr %v2186, align 8
  %v2188 = load double, ptr %v134, align 8, !noalias !281
  %v2189 = load double, ptr %v740, align 8, !noalias !281
  %v2190 = fmul double %v2187, %v2189
  %v2191 = fadd double %v2188, %v2190
  store double %v2191, ptr %v742, align 8, !noalias !281
  br i1 %v784, label %v2192, label %v2181

v2192:
  %v2193 = fsub double 1.000000e+00, %v2187
  br label %v2194

v2194:
  %v2195 = phi i64 [ 0, %v2192 ], [ %v2196, %v2194 ]
  %v2197 = mul i64 %v2195, %v197
  %v2198 = getelementptr double, ptr %v194, i64 %v2197
  %v2199 = getelementptr i8, ptr %v2198, i64 %v748
  %v2200 = load double, ptr %v2199, align 8, !noalias !288
  %v2201 = fadd double %v2200, 0.000000e+00
  %v2202 = fmul double %v2187, %v2201
  %v2203 = getelementptr i8, ptr %v2198, i64 %v749
  %v2204 = load double, ptr %v2203, align 8, !noalias !288
  %v2205 = fadd double %v2204, %v2202
  %v2206 = fmul double %v2193, %v2205
  %v2207 = getelementptr i8, ptr %v2198, i64 %v750
  %v2208 = load double, ptr %v2207, align 8, !noalias !288
  %v2209 = fadd double %v2208, %v2206
  %v2210 = fmul double %v2187, %v2209
  %v2211 = getelementptr i8, ptr %v2198, i64 %v751
  %v2212 = load double, ptr %v2211, align 8, !noalias !288
  %v2213 = fadd double %v2212, %v2210
  %v2214 = fmul double %v2193, %v2213
  %v2215 = getelementptr i8, ptr %v2198, i64 %v752
  %v2216 = load double, ptr %v2215, align 8, !noalias !288
  %v2217 = fadd double %v2216, %v2214
  %v2218 = fmul double %v2187, %v2217
  %v2219 = getelementptr i8, ptr %v2198, i64 %v753
  %v2220 = load double, ptr %v2219, align 8, !noalias !288
  %v2221 = fadd double %v2220, %v2218
  %v2222 = fmul double %v2193, %v2221
  %v2223 = getelementptr i8, ptr %v2198, i64 %v754
  %v2224 = load double, ptr %v2223, align 8, !noalias !288
  %v2225 = fadd double %v2224, %v2222
  %v2226 = fmul double %v2187, %v2225
  %v2196 = add nsw i64 %v2195, 1
  %v2227 = load double, ptr %v2198, align 8, !noalias !288
  %v2228 = fadd double %v2227, %v2226
  %v2229 = getelementptr double, ptr %v745, i64 %v2197
  store double %v2228, ptr %v2229, align 8, !noalias !281
  %v2230 = icmp eq i64 %v10, %v2196
  br i1 %v2230, label %v2181, label %v2194

v2181:
  %v2231 = icmp eq i64 %v2179, 8
  %v2232 = select i1 %v2231, i64 17, i64 16
  %v2233 = mul i64 %v2179, %v746
  %v2234 = load i64, ptr %v747, align 8, !noalias !292
  %v2235 = mul nsw i64 %v2232, %v10
  %v2236 = getelementptr double, ptr %v159, i64 %v2235
  %v2237 = getelementptr double, ptr %v187, i64 %v2233
  %v2238 = inttoptr i64 %v2234 to ptr
  tail call void %v2238(ptr nonnull %v742, ptr %v2236, ptr %v166, ptr %v173, ptr %v180, ptr %v2237), !noalias !292
  %v2239 = icmp eq i64 %v2180, 9
  br i1 %v2239, label %v2185, label %v2178

v2185:
  %v2240 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v2178 ], [ %v2241, %v2181 ]
  %v2242 = phi i32 [ 1, %v2178 ], [ 0, %v2181 ]
  br i1 %v2183, label %v2243, label %v2244, !prof !131

v2245:
  %v2246 = load double, ptr %v820, align 8, !noalias !277
  %v2247 = fcmp ogt double %v2246, 5.000000e-01
  br i1 %v2247, label %v2248, label %v2249

v2248:
  %v2250 = load i64, ptr %v6, align 8, !noalias !295
  %v2251 = inttoptr i64 %v2250 to ptr
  tail call void %v2251(ptr nonnull %v774, ptr %v825, ptr %v166, ptr %v173, ptr %v180, ptr %v827), !noalias !295
  %v2252 = load double, ptr %v774, align 8, !noalias !277
  store double %v2252, ptr %v776, align 8, !noalias !277
  br label %v2253

v2254:
  %v2255 = sub nsw i64 45, %v2256
  %v2257 = load double, ptr %v781, align 8, !noalias !298
  %v2258 = load double, ptr %v783, align 8, !noalias !298
  br label %v2259

v2259:
  %v2260 = phi double [ %v2261, %v2259 ], [ 1.000000e+00, %v2254 ]
  %v2262 = phi double [ %v2263, %v2259 ], [ 2.000000e+00, %v2254 ]
  %v2264 = phi i64 [ %v2265, %v2259 ], [ %v2255, %v2254 ]
  %v2266 = and i64 %v2264, 1
  %v2267 = icmp eq i64 %v2266, 0
  %v2268 = fmul double %v2260, %v2262
  %v2261 = select i1 %v2267, double %v2260, double %v2268
  %v2265 = lshr i64 %v2264, 1
  %v2263 = fmul double %v2262, %v2262
  %v2269 = icmp eq i64 %v2265, 0
  br i1 %v2269, label %v2270, label %v2259

v2271:
  %v2272 = fcmp olt double %v2273, 0.000000e+00
  %v2274 = select i1 %v2272, double 0.000000e+00, double %v2273
  %v2275 = fmul double %v2276, %v2274
  %v2277 = fsub double %v2278, %v2275
  br label %v2279

v2270:
  %v2280 = fadd double %v2281, %v2282
  %v2278 = fmul double %v2280, 5.000000e-01
  %v2283 = fmul double %v2261, 1.000000e-13
  %v2284 = fsub double %v2283, %v2285
  %v2273 = fmul double %v2284, 5.000000e-01
  %v2286 = fmul double %v2282, %v2258
  %v2287 = fmul double %v2281, %v2257
  %v2288 = fsub double %v2286, %v2287
  %v2289 = fsub double %v2258, %v2257
  %v2290 = fdiv double %v2288, %v2289
  %v2291 = fcmp olt double %v2282, %v2290
  %v2292 = fcmp olt double %v2290, %v2281
  %v2293 = and i1 %v2291, %v2292
  %v2294 = select i1 %v2293, double %v2290, double %v2278
  %v2295 = fsub double %v2278, %v2294
  %v2276 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v2295)
  %v2296 = fmul double %v2285, %v2285
  %v2297 = tail call double @llvm.fabs.f64(double %v2295)
  %v2298 = fcmp olt double %v2297, %v2296
  %v2299 = select i1 %v2298, double %v2297, double %v2296
  %v2300 = fmul double %v2276, %v2299
  %v2301 = fadd double %v2294, %v2300
  %v2302 = fsub double %v2301, %v2278
  %v2303 = tail call double @llvm.fabs.f64(double %v2302)
  %v2304 = fcmp ugt double %v2303, %v2273
  br i1 %v2304, label %v2271, label %v2279

v2305:
  store double %v2306, ptr %v778, align 8, !noalias !304
  store double %v2307, ptr %v783, align 8, !noalias !304
  br label %v2308

v2309:
  store double %v2306, ptr %v770, align 8, !noalias !304
  store double %v2307, ptr %v781, align 8, !noalias !304
  br label %v2308

v2308:
  %v2310 = icmp eq i64 %v2311, 45
  br i1 %v2310, label %v2312, label %v2313

v2313:
  %v2256 = phi i64 [ %v2311, %v2308 ], [ 0, %v2314 ]
  %v2311 = add nsw i64 %v2256, 1
  %v2281 = load double, ptr %v778, align 8, !noalias !304
  %v2282 = load double, ptr %v770, align 8, !noalias !304
  %v2285 = fsub double %v2281, %v2282
  %v2315 = fcmp ugt double %v2285, 1.000000e-13
  br i1 %v2315, label %v2254, label %v2312

v2279:
  %v2306 = phi double [ %v2301, %v2270 ], [ %v2277, %v2271 ]
  %v2316 = load double, ptr %v134, align 8, !noalias !305
  %v2317 = load double, ptr %v740, align 8, !noalias !305
  %v2318 = fmul double %v2306, %v2317
  %v2319 = fadd double %v2316, %v2318
  store double %v2319, ptr %v742, align 8, !noalias !305
  br i1 %v784, label %v2320, label %v2321

v2320:
  %v2322 = fsub double 1.000000e+00, %v2306
  br label %v2323

v2323:
  %v2324 = phi i64 [ 0, %v2320 ], [ %v2325, %v2323 ]
  %v2326 = mul i64 %v2324, %v197
  %v2327 = getelementptr double, ptr %v194, i64 %v2326
  %v2328 = getelementptr i8, ptr %v2327, i64 %v748
  %v2329 = load double, ptr %v2328, align 8, !noalias !312
  %v2330 = fadd double %v2329, 0.000000e+00
  %v2331 = fmul double %v2306, %v2330
  %v2332 = getelementptr i8, ptr %v2327, i64 %v749
  %v2333 = load double, ptr %v2332, align 8, !noalias !312
  %v2334 = fadd double %v2333, %v2331
  %v2335 = fmul double %v2322, %v2334
  %v2336 = getelementptr i8, ptr %v2327, i64 %v750
  %v2337 = load double, ptr %v2336, align 8, !noalias !312
  %v2338 = fadd double %v2337, %v2335
  %v2339 = fmul double %v2306, %v2338
  %v2340 = getelementptr i8, ptr %v2327, i64 %v751
  %v2341 = load double, ptr %v2340, align 8, !noalias !312
  %v2342 = fadd double %v2341, %v2339
  %v2343 = fmul double %v2322, %v2342
  %v2344 = getelementptr i8, ptr %v2327, i64 %v752
  %v2345 = load double, ptr %v2344, align 8, !noalias !312
  %v2346 = fadd double %v2345, %v2343
  %v2347 = fmul double %v2306, %v2346
  %v2348 = getelementptr i8, ptr %v2327, i64 %v753
  %v2349 = load double, ptr %v2348, align 8, !noalias !312
  %v2350 = fadd double %v2349, %v2347
  %v2351 = fmul double %v2322, %v2350
  %v2352 = getelementptr i8, ptr %v2327, i64 %v754
  %v2353 = load double, ptr %v2352, align 8, !noalias !312
  %v2354 = fadd double %v2353, %v2351
  %v2355 = fmul double %v2306, %v2354
  %v2325 = add nsw i64 %v2324, 1
  %v2356 = load double, ptr %v2327, align 8, !noalias !312
  %v2357 = fadd double %v2356, %v2355
  %v2358 = getelementptr double, ptr %v745, i64 %v2326
  store double %v2357, ptr %v2358, align 8, !noalias !305
  %v2359 = icmp eq i64 %v10, %v2325
  br i1 %v2359, label %v2321, label %v2323

v2321:
  %v2360 = load i64, ptr %v747, align 8, !noalias !316
  %v2361 = inttoptr i64 %v2360 to ptr
  tail call void %v2361(ptr nonnull %v742, ptr %v786, ptr %v166, ptr %v173, ptr %v180, ptr %v788), !noalias !316
  br i1 %v791, label %v2362, label %v2363

v2362:
  %v2364 = phi i64 [ %v2365, %v2362 ], [ %v790, %v2321 ]
  %v2366 = phi i64 [ %v2367, %v2362 ], [ %v19, %v2321 ]
  %v2365 = add nsw i64 %v2364, -1
  %v2367 = add i64 %v2366, 1
  %v2368 = icmp slt i64 %v2366, 0
  %v2369 = select i1 %v2368, i64 %v208, i64 0
  %v2370 = add i64 %v2369, %v2366
  %v2371 = getelementptr double, ptr %v795, i64 %v2370
  %v2372 = load double, ptr %v2371, align 8, !noalias !319
  %v2373 = getelementptr double, ptr %v798, i64 %v2370
  store double %v2372, ptr %v2373, align 8, !noalias !319
  %v2374 = icmp sgt i64 %v2364, 1
  br i1 %v2374, label %v2362, label %v2363

v2363:
  br i1 %v799, label %v2375, label %v2376

v2376:
  %v2377 = phi double [ %v2378, %v2376 ], [ 0x7FF0000000000000, %v2363 ]
  %v2379 = phi i64 [ %v2380, %v2376 ], [ 0, %v2363 ]
  %v2380 = add nsw i64 %v2379, 1
  %v2381 = getelementptr double, ptr %v800, i64 %v2379
  %v2382 = load double, ptr %v2381, align 8, !noalias !320
  %v2383 = getelementptr double, ptr %v798, i64 %v2379
  %v2384 = load double, ptr %v2383, align 8, !noalias !320
  %v2385 = fadd double %v2382, %v2384
  %v2386 = fcmp olt double %v2385, %v2377
  %v2378 = select i1 %v2386, double %v2385, double %v2377
  %v2387 = icmp eq i64 %v208, %v2380
  br i1 %v2387, label %v2375, label %v2376

v2375:
  %v2307 = phi double [ 0x7FF0000000000000, %v2363 ], [ %v2378, %v2376 ]
  %v2388 = fcmp olt double %v2307, 0.000000e+00
  br i1 %v2388, label %v2305, label %v2309

v2312:
  %v2389 = icmp ugt i64 %v2390, 1
  br i1 %v2389, label %v2391, label %v2249

v2249:
  br i1 %v821, label %v2392, label %v2393

v2392:
  %v2394 = load i64, ptr %v811, align 8, !noalias !324
  %v2395 = inttoptr i64 %v2394 to ptr
  tail call void %v2395(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !324
  store double %v2174, ptr %v770, align 8, !noalias !277
  store double %v2175, ptr %v778, align 8, !noalias !277
  br label %v2253

v2393:
  %v2396 = phi i64 [ %v2397, %v2393 ], [ 0, %v2249 ]
  %v2397 = add nsw i64 %v2396, 1
  %v2398 = add nsw i64 %v2396, %v18
  %v2399 = icmp slt i64 %v2398, 0
  %v2400 = select i1 %v2399, i64 %v167, i64 0
  %v2401 = getelementptr double, ptr %v166, i64 %v2398
  %v2402 = getelementptr double, ptr %v2401, i64 %v2400
  %v2403 = load double, ptr %v2402, align 8, !noalias !330
  %v2404 = getelementptr double, ptr %v823, i64 %v2396
  %v2405 = load double, ptr %v2404, align 8, !noalias !330
  store double %v2405, ptr %v2402, align 8, !noalias !330
  store double %v2403, ptr %v2404, align 8, !noalias !330
  %v2406 = icmp eq i64 %v19, %v2397
  br i1 %v2406, label %v2392, label %v2393

v2176:
  %v2407 = phi i64 [ %v2408, %v2176 ], [ 0, %v2173 ]
  %v2408 = add nsw i64 %v2407, 1
  %v2409 = add nsw i64 %v2407, %v18
  %v2410 = icmp slt i64 %v2409, 0
  %v2411 = select i1 %v2410, i64 %v167, i64 0
  %v2412 = getelementptr double, ptr %v166, i64 %v2409
  %v2413 = getelementptr double, ptr %v2412, i64 %v2411
  %v2414 = load double, ptr %v2413, align 8, !noalias !277
  %v2415 = getelementptr double, ptr %v802, i64 %v2407
  store double %v2414, ptr %v2415, align 8, !noalias !277
  %v2416 = icmp eq i64 %v19, %v2408
  br i1 %v2416, label %v2177, label %v2176

v2177:
  br label %v2391

v2391:
  %v2241 = phi ptr [ %v2240, %v2312 ], [ null, %v2177 ]
  %v2417 = phi ptr [ %v2418, %v2312 ], [ null, %v2177 ]
  %v2390 = phi i64 [ %v2419, %v2312 ], [ 32, %v2177 ]
  %v2419 = add nsw i64 %v2390, -1
  %v2420 = load double, ptr %v778, align 8, !noalias !331
  %v2421 = load double, ptr %v134, align 8, !noalias !335
  %v2422 = load double, ptr %v740, align 8, !noalias !335
  %v2423 = fmul double %v2420, %v2422
  %v2424 = fadd double %v2421, %v2423
  store double %v2424, ptr %v742, align 8, !noalias !335
  br i1 %v784, label %v2425, label %v2426

v2425:
  %v2427 = fsub double 1.000000e+00, %v2420
  br label %v2428

v2428:
  %v2429 = phi i64 [ 0, %v2425 ], [ %v2430, %v2428 ]
  %v2431 = mul i64 %v2429, %v197
  %v2432 = getelementptr double, ptr %v194, i64 %v2431
  %v2433 = getelementptr i8, ptr %v2432, i64 %v748
  %v2434 = load double, ptr %v2433, align 8, !noalias !342
  %v2435 = fadd double %v2434, 0.000000e+00
  %v2436 = fmul double %v2420, %v2435
  %v2437 = getelementptr i8, ptr %v2432, i64 %v749
  %v2438 = load double, ptr %v2437, align 8, !noalias !342
  %v2439 = fadd double %v2438, %v2436
  %v2440 = fmul double %v2427, %v2439
  %v2441 = getelementptr i8, ptr %v2432, i64 %v750
  %v2442 = load double, ptr %v2441, align 8, !noalias !342
  %v2443 = fadd double %v2442, %v2440
  %v2444 = fmul double %v2420, %v2443
  %v2445 = getelementptr i8, ptr %v2432, i64 %v751
  %v2446 = load double, ptr %v2445, align 8, !noalias !342
  %v2447 = fadd double %v2446, %v2444
  %v2448 = fmul double %v2427, %v2447
  %v2449 = getelementptr i8, ptr %v2432, i64 %v752
  %v2450 = load double, ptr %v2449, align 8, !noalias !342
  %v2451 = fadd double %v2450, %v2448
  %v2452 = fmul double %v2420, %v2451
  %v2453 = getelementptr i8, ptr %v2432, i64 %v753
  %v2454 = load double, ptr %v2453, align 8, !noalias !342
  %v2455 = fadd double %v2454, %v2452
  %v2456 = fmul double %v2427, %v2455
  %v2457 = getelementptr i8, ptr %v2432, i64 %v754
  %v2458 = load double, ptr %v2457, align 8, !noalias !342
  %v2459 = fadd double %v2458, %v2456
  %v2460 = fmul double %v2420, %v2459
  %v2430 = add nsw i64 %v2429, 1
  %v2461 = load double, ptr %v2432, align 8, !noalias !342
  %v2462 = fadd double %v2461, %v2460
  %v2463 = getelementptr double, ptr %v805, i64 %v2431
  store double %v2462, ptr %v2463, align 8, !noalias !335
  %v2464 = icmp eq i64 %v10, %v2430
  br i1 %v2464, label %v2426, label %v2428

v2426:
  %v2465 = load i64, ptr %v747, align 8, !noalias !346
  %v2466 = inttoptr i64 %v2465 to ptr
  tail call void %v2466(ptr nonnull %v742, ptr %v786, ptr %v166, ptr %v173, ptr %v180, ptr %v788), !noalias !346
  br i1 %v791, label %v2467, label %v2468

v2467:
  %v2469 = phi i64 [ %v2470, %v2467 ], [ %v789, %v2426 ]
  %v2471 = phi i64 [ %v2472, %v2467 ], [ %v19, %v2426 ]
  %v2470 = add nsw i64 %v2469, -1
  %v2472 = add i64 %v2471, 1
  %v2473 = icmp slt i64 %v2471, 0
  %v2474 = select i1 %v2473, i64 %v208, i64 0
  %v2475 = add i64 %v2474, %v2471
  %v2476 = getelementptr double, ptr %v795, i64 %v2475
  %v2477 = load double, ptr %v2476, align 8, !noalias !349
  %v2478 = getelementptr double, ptr %v798, i64 %v2475
  store double %v2477, ptr %v2478, align 8, !noalias !349
  %v2479 = icmp sgt i64 %v2469, 1
  br i1 %v2479, label %v2467, label %v2468

v2468:
  br label %v2480

v2481:
  br label %v2482

v2482:
  %v2483 = phi double [ %v2420, %v2480 ], [ 1.000000e+00, %v2484 ], [ 8.889000e-01, %v2485 ], [ 2.500000e-01, %v2486 ], [ 3.333000e-01, %v2487 ], [ 5.000000e-01, %v2488 ], [ 0x3FE50A3D70A3D70A, %v2489 ], [ 7.500000e-01, %v2490 ], [ 0x3FB48E8A71DE69AD, %v2481 ]
  %v2491 = fcmp ult double %v2483, %v2420
  br i1 %v2491, label %v2492, label %v2493

v2493:
  %v2494 = load double, ptr %v134, align 8, !noalias !350
  %v2495 = load double, ptr %v740, align 8, !noalias !350
  %v2496 = fmul double %v2483, %v2495
  %v2497 = fadd double %v2494, %v2496
  store double %v2497, ptr %v742, align 8, !noalias !350
  br i1 %v784, label %v2498, label %v2499

v2498:
  %v2500 = fsub double 1.000000e+00, %v2483
  br label %v2501

v2501:
  %v2502 = phi i64 [ 0, %v2498 ], [ %v2503, %v2501 ]
  %v2504 = mul i64 %v2502, %v197
  %v2505 = getelementptr double, ptr %v194, i64 %v2504
  %v2506 = getelementptr i8, ptr %v2505, i64 %v748
  %v2507 = load double, ptr %v2506, align 8, !noalias !354
  %v2508 = fadd double %v2507, 0.000000e+00
  %v2509 = fmul double %v2483, %v2508
  %v2510 = getelementptr i8, ptr %v2505, i64 %v749
  %v2511 = load double, ptr %v2510, align 8, !noalias !354
  %v2512 = fadd double %v2511, %v2509
  %v2513 = fmul double %v2500, %v2512
  %v2514 = getelementptr i8, ptr %v2505, i64 %v750
  %v2515 = load double, ptr %v2514, align 8, !noalias !354
  %v2516 = fadd double %v2515, %v2513
  %v2517 = fmul double %v2483, %v2516
  %v2518 = getelementptr i8, ptr %v2505, i64 %v751
  %v2519 = load double, ptr %v2518, align 8, !noalias !354
  %v2520 = fadd double %v2519, %v2517
  %v2521 = fmul double %v2500, %v2520
  %v2522 = getelementptr i8, ptr %v2505, i64 %v752
  %v2523 = load double, ptr %v2522, align 8, !noalias !354
  %v2524 = fadd double %v2523, %v2521
  %v2525 = fmul double %v2483, %v2524
  %v2526 = getelementptr i8, ptr %v2505, i64 %v753
  %v2527 = load double, ptr %v2526, align 8, !noalias !354
  %v2528 = fadd double %v2527, %v2525
  %v2529 = fmul double %v2500, %v2528
  %v2530 = getelementptr i8, ptr %v2505, i64 %v754
  %v2531 = load double, ptr %v2530, align 8, !noalias !354
  %v2532 = fadd double %v2531, %v2529
  %v2533 = fmul double %v2483, %v2532
  %v2503 = add nsw i64 %v2502, 1
  %v2534 = load double, ptr %v2505, align 8, !noalias !354
  %v2535 = fadd double %v2534, %v2533
  %v2536 = getelementptr double, ptr %v745, i64 %v2504
  store double %v2535, ptr %v2536, align 8, !noalias !350
  %v2537 = icmp eq i64 %v10, %v2503
  br i1 %v2537, label %v2499, label %v2501

v2538:
  %v2539 = load i64, ptr %v811, align 8, !noalias !358
  %v2540 = inttoptr i64 %v2539 to ptr
  tail call void %v2540(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !358
  br label %v2492

v2541:
  %v2542 = phi i64 [ %v2543, %v2541 ], [ 0, %v2544 ]
  %v2543 = add nsw i64 %v2542, 1
  %v2545 = add nsw i64 %v2542, %v18
  %v2546 = icmp slt i64 %v2545, 0
  %v2547 = select i1 %v2546, i64 %v167, i64 0
  %v2548 = getelementptr double, ptr %v166, i64 %v2545
  %v2549 = getelementptr double, ptr %v2548, i64 %v2547
  %v2550 = load double, ptr %v2549, align 8, !noalias !364
  %v2551 = getelementptr double, ptr %v797, i64 %v2542
  %v2552 = load double, ptr %v2551, align 8, !noalias !364
  store double %v2552, ptr %v2549, align 8, !noalias !364
  store double %v2550, ptr %v2551, align 8, !noalias !364
  %v2553 = icmp eq i64 %v19, %v2543
  br i1 %v2553, label %v2538, label %v2541

v2492:
  %v2554 = icmp ugt i64 %v2555, 1
  br i1 %v2554, label %v2480, label %v2556

v2556:
  br i1 %v292, label %v2557, label %v2558

v2558:
  %v2559 = load i64, ptr %v811, align 8, !noalias !365
  %v2560 = inttoptr i64 %v2559 to ptr
  tail call void %v2560(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !365
  br label %v2561

v2557:
  %v2562 = phi i64 [ %v2563, %v2557 ], [ 0, %v2556 ]
  %v2563 = add nsw i64 %v2562, 1
  %v2564 = add nsw i64 %v2562, %v18
  %v2565 = icmp slt i64 %v2564, 0
  %v2566 = select i1 %v2565, i64 %v167, i64 0
  %v2567 = getelementptr double, ptr %v166, i64 %v2564
  %v2568 = getelementptr double, ptr %v2567, i64 %v2566
  %v2569 = load double, ptr %v2568, align 8, !noalias !371
  %v2570 = getelementptr double, ptr %v797, i64 %v2562
  %v2571 = load double, ptr %v2570, align 8, !noalias !371
  store double %v2571, ptr %v2568, align 8, !noalias !371
  store double %v2569, ptr %v2570, align 8, !noalias !371
  %v2572 = icmp eq i64 %v2563, %v19
  br i1 %v2572, label %v2558, label %v2557

v2480:
  %v2555 = phi i64 [ %v2573, %v2492 ], [ 9, %v2468 ]
  %v2574 = phi i64 [ %v2575, %v2492 ], [ 8, %v2468 ]
  %v2573 = add nsw i64 %v2555, -1
  %v2575 = add nsw i64 %v2574, -1
  switch i64 %v2574, label %v2561 [
    i64 0, label %v2482
    i64 -1, label %v2484
    i64 8, label %v2484
    i64 1, label %v2481
    i64 -8, label %v2481
    i64 2, label %v2486
    i64 -7, label %v2486
    i64 3, label %v2487
    i64 -6, label %v2487
    i64 4, label %v2488
    i64 -5, label %v2488
    i64 5, label %v2489
    i64 -4, label %v2489
    i64 6, label %v2490
    i64 -3, label %v2490
    i64 7, label %v2485
    i64 -2, label %v2485
  ]

v2486:
  br label %v2482

v2487:
  br label %v2482

v2488:
  br label %v2482

v2489:
  br label %v2482

v2490:
  br label %v2482

v2485:
  br label %v2482

v2484:
  br label %v2482

v2499:
  %v2576 = load i64, ptr %v6, align 8, !noalias !372
  %v2577 = inttoptr i64 %v2576 to ptr
  tail call void %v2577(ptr nonnull %v742, ptr %v808, ptr %v166, ptr %v173, ptr %v180, ptr %v810), !noalias !372
  br i1 %v292, label %v2578, label %v2579

v2579:
  %v2580 = load i64, ptr %v811, align 8, !noalias !375
  %v2581 = inttoptr i64 %v2580 to ptr
  tail call void %v2581(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !375
  %v2582 = load i64, ptr %v6, align 8, !noalias !381
  %v2583 = inttoptr i64 %v2582 to ptr
  tail call void %v2583(ptr nonnull %v742, ptr %v808, ptr %v166, ptr %v173, ptr %v180, ptr %v813), !noalias !381
  %v2584 = load double, ptr %v24, align 8, !noalias !384
  %v2585 = load double, ptr %v814, align 8, !noalias !384
  br label %v2586

v2578:
  %v2587 = phi i64 [ %v2588, %v2578 ], [ 0, %v2499 ]
  %v2588 = add nsw i64 %v2587, 1
  %v2589 = add nsw i64 %v2587, %v18
  %v2590 = icmp slt i64 %v2589, 0
  %v2591 = select i1 %v2590, i64 %v167, i64 0
  %v2592 = getelementptr double, ptr %v166, i64 %v2589
  %v2593 = getelementptr double, ptr %v2592, i64 %v2591
  %v2594 = load double, ptr %v2593, align 8, !noalias !388
  %v2595 = getelementptr double, ptr %v797, i64 %v2587
  %v2596 = load double, ptr %v2595, align 8, !noalias !388
  store double %v2596, ptr %v2593, align 8, !noalias !388
  store double %v2594, ptr %v2595, align 8, !noalias !388
  %v2597 = icmp eq i64 %v19, %v2588
  br i1 %v2597, label %v2579, label %v2578

v2586:
  %v2598 = phi i64 [ 0, %v2579 ], [ %v2599, %v2600 ]
  %v2601 = icmp eq i64 %v2598, %v803
  br i1 %v2601, label %v2544, label %v2600

v2544:
  br i1 %v292, label %v2541, label %v2538

v2600:
  %v2599 = add i64 %v2598, 1
  %v2602 = mul i64 %v2598, %v197
  %v2603 = getelementptr double, ptr %v816, i64 %v2602
  %v2604 = load double, ptr %v2603, align 8, !noalias !384
  %v2605 = getelementptr double, ptr %v818, i64 %v2602
  %v2606 = load double, ptr %v2605, align 8, !noalias !384
  %v2607 = fsub double %v2604, %v2606
  %v2608 = tail call double @llvm.fabs.f64(double %v2607)
  %v2609 = getelementptr double, ptr %v194, i64 %v2602
  %v2610 = load double, ptr %v2609, align 8, !noalias !384
  %v2611 = tail call double @llvm.fabs.f64(double %v2610)
  %v2612 = fmul double %v2584, %v2611
  %v2613 = fadd double %v2585, %v2612
  %v2614 = load double, ptr %v740, align 8, !noalias !384
  %v2615 = fmul double %v2614, %v2608
  %v2616 = fmul double %v2613, 1.000000e-01
  %v2617 = fcmp ugt double %v2615, %v2616
  br i1 %v2617, label %v2561, label %v2586

v2561:
  %v2618 = phi i1 [ false, %v2600 ], [ true, %v2558 ], [ true, %v2480 ]
  %v2418 = phi ptr [ %v2417, %v2600 ], [ %v2417, %v2558 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.30, %v2480 ]
  %v2619 = phi i1 [ true, %v2600 ], [ true, %v2558 ], [ false, %v2480 ]
  %v2620 = phi i32 [ 0, %v2600 ], [ 0, %v2558 ], [ 1, %v2480 ]
  br i1 %v2619, label %v2182, label %v2244, !prof !131

v2182:
  br i1 %v2618, label %v2178, label %v2249

v2243:
  %v2621 = load double, ptr %v778, align 8, !noalias !277
  store i8 0, ptr %v287, align 1, !noalias !277
  %v2622 = call fastcc i32 @_ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr %v287, ptr %v288, i64 %v13, ptr nonnull readonly %v93, i64 %v94, ptr %v125, i64 %v126, i64 %v127, ptr nonnull %v134, i64 %v136, ptr %v143, i64 %v145, ptr %v205, i64 %v206, i64 %v207, i64 %v208, double %v2621)
  %v2623 = icmp eq i32 %v2622, 0
  br i1 %v2623, label %v2314, label %v2624, !prof !131

v2624:
  %v2625 = load ptr, ptr %v288, align 8, !noalias !277
  br label %v2253

v2314:
  %v2626 = load i8, ptr %v287, align 1, !noalias !277
  %v2627 = icmp eq i8 %v2626, 0
  br i1 %v2627, label %v2245, label %v2313

v2244:
  %v2628 = phi ptr [ %v2240, %v2185 ], [ %v2418, %v2561 ]
  %v2629 = phi i32 [ %v2242, %v2185 ], [ %v2620, %v2561 ]
  %v2630 = icmp ne i32 %v2629, 0
  br label %v2253

v2253:
  %v2631 = phi i1 [ true, %v2248 ], [ false, %v2392 ], [ true, %v2624 ], [ %v2630, %v2244 ]
  %v2632 = phi ptr [ null, %v2248 ], [ null, %v2392 ], [ %v2625, %v2624 ], [ %v2628, %v2244 ]
  %v2633 = phi i1 [ false, %v2248 ], [ false, %v2392 ], [ true, %v2624 ], [ %v2630, %v2244 ]
  call void @llvm.lifetime.end.p0(ptr nonnull %v287), !noalias !180
  call void @llvm.lifetime.end.p0(ptr nonnull %v288), !noalias !180
  %v2634 = select i1 %v2633, ptr %v2632, ptr null, !prof !389
  %v2635 = xor i1 %v2633, true
  br i1 %v2631, label %v2149, label %v2636, !prof !390

v2636:
  %v2637 = load double, ptr %v829, align 8, !noalias !180
  %v2638 = fcmp olt double %v2637, 5.000000e-01
  br i1 %v2638, label %v2149, label %v2164

v2164:
  store double 1.000000e+00, ptr %v837, align 8, !noalias !180
  %v2639 = load double, ptr %v772, align 8, !noalias !391
  %v2640 = load double, ptr %v93, align 8, !noalias !391
  %v2641 = fsub double %v2639, %v2640
  %v2642 = fmul double %v2641, 1.000000e-13
  %v2643 = load double, ptr %v134, align 8, !noalias !391
  %v2644 = tail call double @llvm.fabs.f64(double %v2643)
  %v2645 = fmul double %v2644, 4.000000e-15
  %v2646 = fcmp ogt double %v2645, %v2642
  %v2647 = select i1 %v2646, double %v2645, double %v2642
  %v2648 = load double, ptr %v778, align 8, !noalias !180
  %v2649 = fdiv double %v2647, %v1726
  %v2650 = fcmp ogt double %v2649, %v2648
  %v2651 = select i1 %v2650, double %v2649, double %v2648
  %v2652 = fcmp ult double %v2651, 1.000000e+00
  br i1 %v2652, label %v2653, label %v2149

v2653:
  %v2654 = fsub double 1.000000e+00, %v2651
  br i1 %v710, label %v2655, label %v2656

v2655:
  %v2657 = load double, ptr %v839, align 8, !noalias !180
  %v2658 = fmul double %v2651, 4.000000e+00
  %v2659 = fmul double %v2658, %v2654
  %v2660 = fmul double %v2659, %v2657
  %v2661 = fmul double %v2659, %v2660
  %v2662 = fcmp olt double %v2661, 5.000000e-04
  br i1 %v2662, label %v2663, label %v2656

v2663:
  %v2664 = load double, ptr %v740, align 8, !noalias !395
  %v2665 = fmul double %v2651, %v2664
  %v2666 = fadd double %v2643, %v2665
  store double %v2666, ptr %v742, align 8, !noalias !395
  br i1 %v744, label %v2667, label %v2668

v2668:
  %v2669 = phi i64 [ %v2670, %v2668 ], [ 0, %v2663 ]
  %v2671 = mul i64 %v2669, %v197
  %v2672 = getelementptr double, ptr %v194, i64 %v2671
  %v2673 = getelementptr i8, ptr %v2672, i64 %v748
  %v2674 = load double, ptr %v2673, align 8, !noalias !402
  %v2675 = fadd double %v2674, 0.000000e+00
  %v2676 = fmul double %v2651, %v2675
  %v2677 = getelementptr i8, ptr %v2672, i64 %v749
  %v2678 = load double, ptr %v2677, align 8, !noalias !402
  %v2679 = fadd double %v2678, %v2676
  %v2680 = fmul double %v2654, %v2679
  %v2681 = getelementptr i8, ptr %v2672, i64 %v750
  %v2682 = load double, ptr %v2681, align 8, !noalias !402
  %v2683 = fadd double %v2682, %v2680
  %v2684 = fmul double %v2651, %v2683
  %v2685 = getelementptr i8, ptr %v2672, i64 %v751
  %v2686 = load double, ptr %v2685, align 8, !noalias !402
  %v2687 = fadd double %v2686, %v2684
  %v2688 = fmul double %v2654, %v2687
  %v2689 = getelementptr i8, ptr %v2672, i64 %v752
  %v2690 = load double, ptr %v2689, align 8, !noalias !402
  %v2691 = fadd double %v2690, %v2688
  %v2692 = fmul double %v2651, %v2691
  %v2693 = getelementptr i8, ptr %v2672, i64 %v753
  %v2694 = load double, ptr %v2693, align 8, !noalias !402
  %v2695 = fadd double %v2694, %v2692
  %v2696 = fmul double %v2654, %v2695
  %v2697 = getelementptr i8, ptr %v2672, i64 %v754
  %v2698 = load double, ptr %v2697, align 8, !noalias !402
  %v2699 = fadd double %v2698, %v2696
  %v2700 = fmul double %v2651, %v2699
  %v2670 = add nsw i64 %v2669, 1
  %v2701 = load double, ptr %v2672, align 8, !noalias !402
  %v2702 = fadd double %v2701, %v2700
  %v2703 = getelementptr double, ptr %v745, i64 %v2671
  store double %v2702, ptr %v2703, align 8, !noalias !395
  %v2704 = icmp eq i64 %v10, %v2670
  br i1 %v2704, label %v2705, label %v2668

v2667:
  %v2706 = load double, ptr %v742, align 8, !noalias !406
  store double %v2706, ptr %v774, align 8, !noalias !406
  br label %v2707

v2707:
  %v2708 = load i64, ptr %v6, align 8, !noalias !407
  %v2709 = inttoptr i64 %v2708 to ptr
  tail call void %v2709(ptr nonnull %v742, ptr %v849, ptr %v166, ptr %v173, ptr %v180, ptr %v851), !noalias !407
  %v2710 = load i64, ptr %v747, align 8, !noalias !410
  %v2711 = inttoptr i64 %v2710 to ptr
  tail call void %v2711(ptr nonnull %v742, ptr %v853, ptr %v166, ptr %v173, ptr %v180, ptr %v855), !noalias !410
  br label %v2149

v2705:
  %v2712 = load double, ptr %v742, align 8, !noalias !406
  store double %v2712, ptr %v774, align 8, !noalias !406
  br label %v2713

v2713:
  %v2714 = phi i64 [ 0, %v2705 ], [ %v2715, %v2713 ]
  %v2715 = add nsw i64 %v2714, 1
  %v2716 = mul i64 %v2714, %v197
  %v2717 = getelementptr double, ptr %v745, i64 %v2716
  %v2718 = load double, ptr %v2717, align 8, !noalias !406
  %v2719 = getelementptr double, ptr %v846, i64 %v2716
  store double %v2718, ptr %v2719, align 8, !noalias !406
  %v2720 = icmp eq i64 %v10, %v2715
  br i1 %v2720, label %v2707, label %v2713

v2656:
  %v2721 = fmul double %v2647, 2.000000e+00
  %v2722 = fcmp ogt double %v1726, %v2721
  br i1 %v2722, label %v2723, label %v2149

v2723:
  %v2724 = load double, ptr %v774, align 8, !noalias !180
  %v2725 = tail call double @llvm.fabs.f64(double %v2724)
  %v2726 = fmul double %v2725, 4.000000e-15
  %v2727 = fmul double %v1726, 0x3D719799812DEA11
  %v2728 = fcmp ogt double %v2726, %v2727
  %v2729 = select i1 %v2728, double %v2726, double %v2727
  %v2730 = load double, ptr %v770, align 8, !noalias !180
  %v2731 = fsub double 1.000000e+00, %v2730
  %v2732 = fmul double %v1726, %v2731
  %v2733 = fcmp ogt double %v2732, %v2729
  br i1 %v2733, label %v2734, label %v2149

v2734:
  %v2735 = fmul double %v1726, %v2651
  store double 0.000000e+00, ptr %v841, align 8, !noalias !413
  store double 0.000000e+00, ptr %v843, align 8, !noalias !413
  store double %v2735, ptr %v844, align 8, !noalias !413
  %v2736 = load i64, ptr %v143, align 8, !noalias !413
  %v2737 = icmp slt i64 %v2736, 0
  %v2738 = select i1 %v2737, i64 %v126, i64 0
  %v2739 = add i64 %v2738, %v2736
  %v2740 = mul i64 %v2739, %v127
  %v2741 = getelementptr i64, ptr %v125, i64 %v2740
  %v2742 = load i64, ptr %v2741, align 8, !noalias !413
  %v2743 = add nsw i64 %v2742, -1
  store i64 %v2743, ptr %v2741, align 8, !noalias !413
  %v2744 = load i64, ptr %v143, align 8, !noalias !413
  %v2745 = icmp slt i64 %v2744, 0
  %v2746 = select i1 %v2745, i64 %v126, i64 0
  %v2747 = add i64 %v2746, %v2744
  %v2748 = mul i64 %v2747, %v127
  %v2749 = getelementptr i64, ptr %v125, i64 %v2748
  %v2750 = getelementptr i8, ptr %v2749, i64 24
  %v2751 = load i64, ptr %v2750, align 8, !noalias !413
  %v2752 = add nsw i64 %v2751, 1
  store i64 %v2752, ptr %v2750, align 8, !noalias !413
  br label %v2149

v1794:
  br i1 %v291, label %v1869, label %v2172

v2149:
  %v2753 = phi ptr [ null, %v2707 ], [ null, %v2734 ], [ null, %v2656 ], [ null, %v2164 ], [ null, %v2636 ], [ null, %v2144 ], [ null, %v2723 ], [ %v2634, %v2253 ]
  %v2754 = phi i1 [ true, %v2707 ], [ true, %v2734 ], [ true, %v2656 ], [ true, %v2164 ], [ true, %v2636 ], [ true, %v2144 ], [ true, %v2723 ], [ %v2635, %v2253 ]
  br i1 %v2754, label %v1566, label %v1479, !prof !131

v1566:
  %v2755 = select i1 %v1386, i1 true, i1 %v673
  %v2756 = select i1 %v2755, i64 0, i64 %v12
  br label %v1479

v2757:
  %v2758 = phi i64 [ 0, %v1472 ], [ %v2759, %v2760 ]
  %v2761 = phi i64 [ %v702, %v1472 ], [ %v2762, %v2760 ]
  %v2763 = icmp sgt i64 %v2761, 0
  br i1 %v2763, label %v2760, label %v1473

v1472:
  %v2764 = load double, ptr %v701, align 8, !noalias !416
  store double %v2764, ptr %v687, align 8, !noalias !416
  br label %v2757

v2760:
  %v2762 = add nsw i64 %v2761, -1
  %v2759 = add i64 %v2758, 1
  %v2765 = getelementptr double, ptr %v704, i64 %v2758
  %v2766 = icmp slt i64 %v2758, 0
  %v2767 = select i1 %v2766, i64 %v208, i64 0
  %v2768 = getelementptr double, ptr %v2765, i64 %v2767
  %v2769 = load double, ptr %v2768, align 8, !noalias !416
  %v2770 = fcmp olt double %v2769, 0x7FF0000000000000
  %v2771 = select i1 %v2770, double %v2769, double 0x7FF0000000000000
  %v2772 = fcmp ogt double %v2769, 0xFFF0000000000000
  %v2773 = select i1 %v2772, double %v2769, double 0xFFF0000000000000
  %v2774 = getelementptr double, ptr %v2768, i64 %v703
  %v2775 = load double, ptr %v2774, align 8, !noalias !416
  %v2776 = fcmp olt double %v2775, %v2771
  %v2777 = select i1 %v2776, double %v2775, double %v2771
  %v2778 = fcmp ogt double %v2775, %v2773
  %v2779 = select i1 %v2778, double %v2775, double %v2773
  %v2780 = getelementptr i8, ptr %v2768, i64 %v1027
  %v2781 = load double, ptr %v2780, align 8, !noalias !416
  %v2782 = fcmp olt double %v2781, %v2777
  %v2783 = select i1 %v2782, double %v2781, double %v2777
  %v2784 = fcmp ogt double %v2781, %v2779
  %v2785 = select i1 %v2784, double %v2781, double %v2779
  %v2786 = getelementptr i8, ptr %v2768, i64 %v1028
  %v2787 = load double, ptr %v2786, align 8, !noalias !416
  %v2788 = fcmp olt double %v2787, %v2783
  %v2789 = select i1 %v2788, double %v2787, double %v2783
  %v2790 = fcmp ogt double %v2787, %v2785
  %v2791 = select i1 %v2790, double %v2787, double %v2785
  %v2792 = getelementptr i8, ptr %v2768, i64 %v1029
  %v2793 = load double, ptr %v2792, align 8, !noalias !416
  %v2794 = fcmp olt double %v2793, %v2789
  %v2795 = select i1 %v2794, double %v2793, double %v2789
  %v2796 = fcmp ogt double %v2793, %v2791
  %v2797 = select i1 %v2796, double %v2793, double %v2791
  %v2798 = getelementptr i8, ptr %v2768, i64 %v1030
  %v2799 = load double, ptr %v2798, align 8, !noalias !416
  %v2800 = fcmp olt double %v2799, %v2795
  %v2801 = select i1 %v2800, double %v2799, double %v2795
  %v2802 = fcmp ogt double %v2799, %v2797
  %v2803 = select i1 %v2802, double %v2799, double %v2797
  %v2804 = getelementptr i8, ptr %v2768, i64 %v1031
  %v2805 = load double, ptr %v2804, align 8, !noalias !416
  %v2806 = fcmp olt double %v2805, %v2801
  %v2807 = select i1 %v2806, double %v2805, double %v2801
  %v2808 = fcmp ogt double %v2805, %v2803
  %v2809 = select i1 %v2808, double %v2805, double %v2803
  %v2810 = getelementptr i8, ptr %v2768, i64 %v1032
  %v2811 = load double, ptr %v2810, align 8, !noalias !416
  %v2812 = fcmp olt double %v2811, %v2807
  %v2813 = select i1 %v2812, double %v2811, double %v2807
  %v2814 = fcmp ogt double %v2811, %v2809
  %v2815 = select i1 %v2814, double %v2811, double %v2809
  %v2816 = getelementptr i8, ptr %v2768, i64 %v1033
  %v2817 = load double, ptr %v2816, align 8, !noalias !416
  %v2818 = fcmp olt double %v2817, %v2813
  %v2819 = select i1 %v2818, double %v2817, double %v2813
  %v2820 = fcmp ogt double %v2817, %v2815
  %v2821 = select i1 %v2820, double %v2817, double %v2815
  %v2822 = fsub double %v2821, %v2819
  %v2823 = fmul double %v2822, 2.500000e-01
  %v2824 = icmp slt i64 %v2758, 0
  %v2825 = select i1 %v2824, i64 %v208, i64 0
  %v2826 = add i64 %v2825, %v2758
  %v2827 = getelementptr double, ptr %v706, i64 %v2826
  %v2828 = getelementptr double, ptr %v707, i64 %v2826
  %v2829 = getelementptr double, ptr %v2827, i64 %v705
  %v2830 = load double, ptr %v2829, align 8, !noalias !417
  %v2831 = load double, ptr %v2828, align 8, !noalias !417
  %v2832 = fmul double %v2831, 0x3FDDF27AAAADCB3A
  %v2833 = fsub double %v2830, %v2832
  %v2834 = getelementptr i8, ptr %v2828, i64 %v1034
  %v2835 = load double, ptr %v2834, align 8, !noalias !417
  %v2836 = fmul double %v2835, 0x3FEC575F1EBC4F2F
  %v2837 = fsub double %v2833, %v2836
  %v2838 = getelementptr i8, ptr %v2828, i64 %v1035
  %v2839 = load double, ptr %v2838, align 8, !noalias !417
  %v2840 = fmul double %v2839, 0xBFE1306AA3D795F4
  %v2841 = fsub double %v2837, %v2840
  %v2842 = getelementptr i8, ptr %v2828, i64 %v1036
  %v2843 = load double, ptr %v2842, align 8, !noalias !417
  %v2844 = fmul double %v2843, 0x3FCCB9F574BDCC3A
  %v2845 = fsub double %v2841, %v2844
  %v2846 = getelementptr i8, ptr %v2828, i64 %v1037
  %v2847 = load double, ptr %v2846, align 8, !noalias !417
  %v2848 = fmul double %v2847, 0xBFA4EAF2D6B11E79
  %v2849 = fsub double %v2845, %v2848
  %v2850 = tail call double @llvm.fabs.f64(double %v2849)
  %v2851 = fcmp ogt double %v2850, 0.000000e+00
  %v2852 = select i1 %v2851, double %v2850, double 0.000000e+00
  %v2853 = getelementptr i8, ptr %v2827, i64 %v1038
  %v2854 = load double, ptr %v2853, align 8, !noalias !417
  %v2855 = load double, ptr %v2828, align 8, !noalias !417
  %v2856 = fmul double %v2855, 0xBFA5118805F8B876
  %v2857 = fsub double %v2854, %v2856
  %v2858 = getelementptr i8, ptr %v2828, i64 %v1039
  %v2859 = load double, ptr %v2858, align 8, !noalias !417
  %v2860 = fmul double %v2859, 0x3FE51326698BC5BD
  %v2861 = fsub double %v2857, %v2860
  %v2862 = getelementptr i8, ptr %v2828, i64 %v1040
  %v2863 = load double, ptr %v2862, align 8, !noalias !417
  %v2864 = fmul double %v2863, 0x3FDF97DED30D4572
  %v2865 = fsub double %v2861, %v2864
  %v2866 = getelementptr i8, ptr %v2828, i64 %v1041
  %v2867 = load double, ptr %v2866, align 8, !noalias !417
  %v2868 = fmul double %v2867, 0xBFC0DA0C684D1D67
  %v2869 = fsub double %v2865, %v2868
  %v2870 = getelementptr i8, ptr %v2828, i64 %v1042
  %v2871 = load double, ptr %v2870, align 8, !noalias !417
  %v2872 = fmul double %v2871, 0x3F9510B8EC0D4D92
  %v2873 = fsub double %v2869, %v2872
  %v2874 = tail call double @llvm.fabs.f64(double %v2873)
  %v2875 = fcmp ogt double %v2874, %v2852
  %v2876 = select i1 %v2875, double %v2874, double %v2852
  %v2877 = getelementptr i8, ptr %v2827, i64 %v1043
  %v2878 = load double, ptr %v2877, align 8, !noalias !417
  %v2879 = load double, ptr %v2828, align 8, !noalias !417
  %v2880 = fmul double %v2879, 0x3F9635A30F8F142F
  %v2881 = fsub double %v2878, %v2880
  %v2882 = getelementptr i8, ptr %v2828, i64 %v1044
  %v2883 = load double, ptr %v2882, align 8, !noalias !417
  %v2884 = fmul double %v2883, 0xBFC1EAE0FF33D241
  %v2885 = fsub double %v2881, %v2884
  %v2886 = getelementptr i8, ptr %v2828, i64 %v1045
  %v2887 = load double, ptr %v2886, align 8, !noalias !417
  %v2888 = fmul double %v2887, 0x3FE1625D59218460
  %v2889 = fsub double %v2885, %v2888
  %v2890 = getelementptr i8, ptr %v2828, i64 %v1046
  %v2891 = load double, ptr %v2890, align 8, !noalias !417
  %v2892 = fmul double %v2891, 0x3FE3BBC3E8A29641
  %v2893 = fsub double %v2889, %v2892
  %v2894 = getelementptr i8, ptr %v2828, i64 %v1047
  %v2895 = load double, ptr %v2894, align 8, !noalias !417
  %v2896 = fmul double %v2895, 0xBFA55161A739EB34
  %v2897 = fsub double %v2893, %v2896
  %v2898 = tail call double @llvm.fabs.f64(double %v2897)
  %v2899 = fcmp ogt double %v2898, %v2876
  %v2900 = select i1 %v2899, double %v2898, double %v2876
  %v2901 = getelementptr i8, ptr %v2827, i64 %v1048
  %v2902 = load double, ptr %v2901, align 8, !noalias !417
  %v2903 = load double, ptr %v2828, align 8, !noalias !417
  %v2904 = fmul double %v2903, 0xBFA4F0C0BB579409
  %v2905 = fsub double %v2902, %v2904
  %v2906 = getelementptr i8, ptr %v2828, i64 %v1049
  %v2907 = load double, ptr %v2906, align 8, !noalias !417
  %v2908 = fmul double %v2907, 0x3FCD2266FBC0D976
  %v2909 = fsub double %v2905, %v2908
  %v2910 = getelementptr i8, ptr %v2828, i64 %v1050
  %v2911 = load double, ptr %v2910, align 8, !noalias !417
  %v2912 = fmul double %v2911, 0xBFE1F2DB6FEE3151
  %v2913 = fsub double %v2909, %v2912
  %v2914 = getelementptr i8, ptr %v2828, i64 %v1051
  %v2915 = load double, ptr %v2914, align 8, !noalias !417
  %v2916 = fmul double %v2915, 0x3FF0C05015964CBE
  %v2917 = fsub double %v2913, %v2916
  %v2918 = getelementptr i8, ptr %v2828, i64 %v1052
  %v2919 = load double, ptr %v2918, align 8, !noalias !417
  %v2920 = fmul double %v2919, 0x3FD4F15B230DB570
  %v2921 = fsub double %v2917, %v2920
  %v2922 = tail call double @llvm.fabs.f64(double %v2921)
  %v2923 = fcmp ogt double %v2922, %v2900
  %v2924 = select i1 %v2923, double %v2922, double %v2900
  %v2925 = fmul double %v2924, 1.000000e+01
  %v2926 = fadd double %v2823, %v2925
  %v2927 = icmp slt i64 %v2758, 0
  %v2928 = select i1 %v2927, i64 %v208, i64 0
  %v2929 = getelementptr double, ptr %v709, i64 %v2758
  %v2930 = getelementptr double, ptr %v2929, i64 %v2928
  %v2931 = load double, ptr %v2930, align 8, !noalias !416
  %v2932 = fcmp ogt double %v2926, %v2931
  %v2933 = fneg double %v2931
  %v2934 = select i1 %v2932, double %v2926, double %v2933
  %v2935 = fcmp olt double %v2819, %v2934
  br i1 %v2935, label %v1473, label %v2757

v1473:
  %v1475 = phi i1 [ false, %v1415 ], [ %v2763, %v2760 ], [ %v2763, %v2757 ]
  %v2936 = phi ptr [ %v1470, %v1415 ], [ null, %v2760 ], [ null, %v2757 ]
  %v2937 = phi i32 [ %v1471, %v1415 ], [ 0, %v2760 ], [ 0, %v2757 ]
  %v2938 = icmp eq i32 %v2937, 0
  br i1 %v2938, label %v1405, label %v1479, !prof !131

v1723:
  br i1 %v1718, label %v1566, label %v1724

v1479:
  %v2939 = phi i64 [ 0, %v1405 ], [ %v2756, %v1566 ], [ 0, %v1473 ], [ 0, %v1631 ], [ 0, %v2149 ]
  %v2940 = phi i1 [ true, %v1405 ], [ true, %v1566 ], [ false, %v1473 ], [ false, %v1631 ], [ false, %v2149 ]
  %v2941 = phi ptr [ undef, %v1405 ], [ undef, %v1566 ], [ %v2936, %v1473 ], [ %v1722, %v1631 ], [ %v2753, %v2149 ]
  %v2942 = phi i32 [ 0, %v1405 ], [ 0, %v1566 ], [ 1, %v1473 ], [ 1, %v1631 ], [ 1, %v2149 ]
  br i1 %v2940, label %v2943, label %v2944, !prof !131

v2945:
  %v2946 = getelementptr double, ptr %v861, i64 %v2947
  %v2948 = load double, ptr %v2946, align 8, !noalias !421
  %v2949 = fcmp olt double %v2948, 5.000000e-01
  br i1 %v2949, label %v2950, label %v2951

v2951:
  %v2952 = getelementptr i64, ptr %v111, i64 %v2953
  %v2954 = load i64, ptr %v2952, align 8, !noalias !421
  %v2955 = icmp eq i64 %v2954, 0
  br i1 %v2955, label %v2956, label %v2950

v2956:
  %v2957 = mul i64 %v2953, %v127
  %v2958 = getelementptr i64, ptr %v125, i64 %v2957
  %v2959 = getelementptr i8, ptr %v2958, i64 8
  %v2960 = load i64, ptr %v2959, align 8, !noalias !421
  %v2961 = add nsw i64 %v2960, %v2939
  store i64 %v2961, ptr %v2959, align 8, !noalias !421
  %v2962 = getelementptr double, ptr %v863, i64 %v2947
  %v2963 = load double, ptr %v2962, align 8, !noalias !421
  %v2964 = icmp slt i64 %v2965, %v94
  br i1 %v2964, label %v2966, label %v2967

v2966:
  %v2968 = icmp slt i64 %v2965, 0
  %v2969 = select i1 %v2968, i64 %v94, i64 0
  %v2970 = getelementptr double, ptr %v93, i64 %v2965
  %v2971 = getelementptr double, ptr %v2970, i64 %v2969
  %v2972 = load double, ptr %v2971, align 8, !noalias !421
  %v2973 = fcmp ugt double %v2972, %v2963
  br i1 %v2973, label %v2967, label %v2974

v2974:
  %v2975 = getelementptr double, ptr %v134, i64 %v2947
  %v2976 = getelementptr double, ptr %v865, i64 %v2947
  %v2977 = getelementptr double, ptr %v194, i64 %v2947
  %v2978 = mul i64 %v856, %v2953
  %v2979 = getelementptr double, ptr %v869, i64 %v2947
  %v2980 = getelementptr double, ptr %v100, i64 %v2978
  %v2981 = getelementptr double, ptr %v870, i64 %v2947
  br label %v2982

v2982:
  %v2983 = phi i64 [ %v2984, %v2985 ], [ %v2965, %v2974 ]
  %v2986 = icmp slt i64 %v2983, 0
  %v2987 = select i1 %v2986, i64 %v94, i64 0
  %v2988 = getelementptr double, ptr %v93, i64 %v2983
  %v2989 = getelementptr double, ptr %v2988, i64 %v2987
  %v2990 = load double, ptr %v2989, align 8, !noalias !421
  %v2991 = load double, ptr %v2975, align 8, !noalias !421
  %v2992 = fsub double %v2990, %v2991
  %v2993 = load double, ptr %v2976, align 8, !noalias !421
  %v2994 = fdiv double %v2992, %v2993
  br i1 %v867, label %v2995, label %v2996

v2996:
  %v2997 = fsub double 1.000000e+00, %v2994
  %v2998 = select i1 %v2986, i64 %v102, i64 0
  %v2999 = add i64 %v2998, %v2983
  %v3000 = mul i64 %v2999, %v103
  %v3001 = getelementptr double, ptr %v2980, i64 %v3000
  br label %v3002

v3003:
  %v3004 = getelementptr double, ptr %v2981, i64 %v3005
  %v3006 = load double, ptr %v3004, align 8, !noalias !421
  br label %v3007

v2995:
  store double 0x7FF0000000000000, ptr %v2979, align 8, !noalias !421
  %v3008 = icmp eq i64 %v2983, %v871
  br i1 %v3008, label %v2967, label %v2985

v2985:
  %v2984 = add i64 %v2983, 1
  %v3009 = icmp slt i64 %v2983, -1
  %v3010 = select i1 %v3009, i64 %v94, i64 0
  %v3011 = getelementptr double, ptr %v93, i64 %v2984
  %v3012 = getelementptr double, ptr %v3011, i64 %v3010
  %v3013 = load double, ptr %v3012, align 8, !noalias !421
  %v3014 = fcmp ugt double %v3013, %v2963
  br i1 %v3014, label %v2967, label %v2982

v2967:
  %v3015 = phi i64 [ %v2965, %v2966 ], [ %v2965, %v2956 ], [ %v94, %v2995 ], [ %v2984, %v2985 ]
  store i64 %v3015, ptr %v3016, align 8, !noalias !421
  br label %v2950

v2950:
  %v3017 = icmp eq i64 %v3018, %v9
  br i1 %v3017, label %v3019, label %v3020

v3007:
  %v3021 = phi double [ %v3022, %v3023 ], [ %v3006, %v3003 ]
  %v3024 = getelementptr double, ptr %v3001, i64 %v3025
  store double %v3021, ptr %v3024, align 8, !noalias !421
  %v3026 = icmp eq i64 %v10, %v3027
  br i1 %v3026, label %v2995, label %v3002

v3020:
  %v2947 = phi i64 [ %v3018, %v2950 ], [ 0, %v2943 ]
  %v3018 = add nsw i64 %v2947, 1
  %v3028 = getelementptr i64, ptr %v143, i64 %v2947
  %v2953 = load i64, ptr %v3028, align 8, !noalias !421
  %v3016 = getelementptr i64, ptr %v859, i64 %v2947
  %v2965 = load i64, ptr %v3016, align 8, !noalias !421
  %v3029 = icmp slt i64 %v2953, 0
  br i1 %v3029, label %v2950, label %v2945

v3002:
  %v3025 = phi i64 [ 0, %v2996 ], [ %v3027, %v3007 ]
  %v3027 = add nsw i64 %v3025, 1
  %v3030 = load double, ptr %v2989, align 8, !noalias !421
  %v3031 = fcmp oeq double %v3030, %v2963
  %v3005 = mul i64 %v3025, %v197
  br i1 %v3031, label %v3003, label %v3023

v3023:
  %v3032 = getelementptr double, ptr %v2977, i64 %v3005
  %v3033 = getelementptr i8, ptr %v3032, i64 %v872
  %v3034 = load double, ptr %v3033, align 8, !noalias !424
  %v3035 = fadd double %v3034, 0.000000e+00
  %v3036 = fmul double %v2994, %v3035
  %v3037 = getelementptr i8, ptr %v3032, i64 %v873
  %v3038 = load double, ptr %v3037, align 8, !noalias !424
  %v3039 = fadd double %v3038, %v3036
  %v3040 = fmul double %v2997, %v3039
  %v3041 = getelementptr i8, ptr %v3032, i64 %v874
  %v3042 = load double, ptr %v3041, align 8, !noalias !424
  %v3043 = fadd double %v3042, %v3040
  %v3044 = fmul double %v2994, %v3043
  %v3045 = getelementptr i8, ptr %v3032, i64 %v875
  %v3046 = load double, ptr %v3045, align 8, !noalias !424
  %v3047 = fadd double %v3046, %v3044
  %v3048 = fmul double %v2997, %v3047
  %v3049 = getelementptr i8, ptr %v3032, i64 %v876
  %v3050 = load double, ptr %v3049, align 8, !noalias !424
  %v3051 = fadd double %v3050, %v3048
  %v3052 = fmul double %v2994, %v3051
  %v3053 = getelementptr i8, ptr %v3032, i64 %v877
  %v3054 = load double, ptr %v3053, align 8, !noalias !424
  %v3055 = fadd double %v3054, %v3052
  %v3056 = fmul double %v2997, %v3055
  %v3057 = getelementptr i8, ptr %v3032, i64 %v878
  %v3058 = load double, ptr %v3057, align 8, !noalias !424
  %v3059 = fadd double %v3058, %v3056
  %v3060 = fmul double %v2994, %v3059
  %v3061 = load double, ptr %v3032, align 8, !noalias !424
  %v3022 = fadd double %v3061, %v3060
  br label %v3007

v3019:
  br i1 %v879, label %v3062, label %v3063

v3063:
  %v3064 = load double, ptr %v881, align 8
  %v3065 = fcmp ogt double %v3064, 5.000000e-01
  br i1 %v3065, label %v3062, label %v3066

v3062:
  %v3067 = load i64, ptr %v882, align 8, !noalias !428
  %v3068 = inttoptr i64 %v3067 to ptr
  tail call void %v3068(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !428
  br label %v3066

v3066:
  br i1 %v1401, label %v3069, label %v3070

v3069:
  %v3071 = load double, ptr %v884, align 8, !noalias !431
  %v3072 = fcmp olt double %v3071, 5.000000e-01
  br i1 %v3072, label %v3070, label %v3073

v3073:
  br i1 %v886, label %v3074, label %v3075

v3076:
  %v3077 = getelementptr double, ptr %v887, i64 %v3078
  %v3079 = load double, ptr %v3077, align 8, !noalias !431
  %v3080 = add nsw i64 %v3078, %v18
  %v3081 = icmp slt i64 %v3080, 0
  %v3082 = select i1 %v3081, i64 %v167, i64 0
  %v3083 = getelementptr double, ptr %v166, i64 %v3080
  %v3084 = getelementptr double, ptr %v3083, i64 %v3082
  %v3085 = load double, ptr %v3084, align 8, !noalias !431
  %v3086 = fcmp une double %v3079, %v3085
  br label %v3087

v3087:
  %v3088 = phi i1 [ true, %v3074 ], [ %v3086, %v3076 ]
  %v3089 = icmp eq i64 %v3090, %v19
  br i1 %v3089, label %v3075, label %v3074

v3075:
  %v3091 = phi i1 [ false, %v3073 ], [ %v3088, %v3087 ]
  %v3092 = load double, ptr %v889, align 8, !noalias !431
  %v3093 = fcmp oeq double %v3092, 1.000000e+00
  %v3094 = select i1 %v3093, i1 %v3091, i1 false
  br i1 %v3094, label %v3095, label %v3096

v3095:
  %v3097 = load double, ptr %v134, align 8, !noalias !431
  %v3098 = load double, ptr %v891, align 8, !noalias !431
  %v3099 = fsub double %v3097, %v3098
  br i1 %v892, label %v3100, label %v3101

v3102:
  %v3103 = load double, ptr %v893, align 8, !noalias !431
  %v3104 = load double, ptr %v24, align 8, !noalias !431
  %v3105 = mul i64 %v3106, %v197
  %v3107 = getelementptr double, ptr %v194, i64 %v3105
  %v3108 = load double, ptr %v3107, align 8, !noalias !431
  %v3109 = tail call double @llvm.fabs.f64(double %v3108)
  %v3110 = fmul double %v3104, %v3109
  %v3111 = fadd double %v3103, %v3110
  %v3112 = add i64 %v3106, %v196
  %v3113 = mul i64 %v3112, %v197
  %v3114 = getelementptr double, ptr %v194, i64 %v3113
  %v3115 = load double, ptr %v3114, align 8, !noalias !431
  %v3116 = tail call double @llvm.fabs.f64(double %v3115)
  %v3117 = fmul double %v3099, %v3116
  %v3118 = fcmp ogt double %v3117, %v3111
  br label %v3119

v3119:
  %v3120 = phi i1 [ true, %v3101 ], [ %v3118, %v3102 ]
  %v3121 = icmp eq i64 %v10, %v3122
  br i1 %v3121, label %v3123, label %v3101

v3123:
  %v3124 = select i1 %v3120, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  br label %v3100

v3100:
  %v3125 = phi double [ 5.000000e-06, %v3095 ], [ %v3124, %v3123 ]
  %v3126 = load double, ptr %v895, align 8, !noalias !431
  %v3127 = load double, ptr %v93, align 8, !noalias !431
  %v3128 = fsub double %v3126, %v3127
  %v3129 = fmul double %v3125, %v3128
  %v3130 = fcmp olt double %v3099, %v3129
  br i1 %v3130, label %v3131, label %v3132

v3131:
  %v3133 = load i64, ptr %v897, align 8, !noalias !431
  %v3134 = add nsw i64 %v3133, 1
  br label %v3132

v3132:
  %v3135 = phi i64 [ %v3134, %v3131 ], [ 0, %v3100 ]
  store i64 %v3135, ptr %v899, align 8, !noalias !431
  %v3136 = load double, ptr %v134, align 8, !noalias !431
  store double %v3136, ptr %v891, align 8, !noalias !431
  store double 1.000000e+00, ptr %v901, align 8, !noalias !431
  store i64 2, ptr %v485, align 8, !noalias !431
  %v3137 = load i64, ptr %v899, align 8, !noalias !431
  %v3138 = icmp sgt i64 %v3137, 1000
  br i1 %v3138, label %v3139, label %v3096

v3139:
  %v3140 = load i64, ptr %v143, align 8, !noalias !435
  %v3141 = icmp sgt i64 %v3140, -1
  br i1 %v3141, label %v3142, label %v3096

v3142:
  %v3143 = getelementptr i64, ptr %v111, i64 %v3140
  %v3144 = load i64, ptr %v3143, align 8, !noalias !435
  %v3145 = icmp eq i64 %v3144, 0
  br i1 %v3145, label %v3146, label %v3096

v3146:
  store i64 6, ptr %v3143, align 8, !noalias !435
  br label %v3096

v3096:
  store double 0.000000e+00, ptr %v889, align 8, !noalias !431
  br label %v3070

v3074:
  %v3147 = phi i1 [ %v3088, %v3087 ], [ false, %v3073 ]
  %v3078 = phi i64 [ %v3090, %v3087 ], [ 0, %v3073 ]
  %v3090 = add nsw i64 %v3078, 1
  br i1 %v3147, label %v3087, label %v3076

v3101:
  %v3148 = phi i1 [ %v3120, %v3119 ], [ false, %v3095 ]
  %v3106 = phi i64 [ %v3122, %v3119 ], [ 0, %v3095 ]
  %v3122 = add nsw i64 %v3106, 1
  br i1 %v3148, label %v3119, label %v3102

v3070:
  %v3149 = and i1 %v902, %v1287
  %v3150 = xor i1 %v3149, true
  %v3151 = or i1 %v294, %v3150
  br i1 %v3151, label %v3152, label %v3153

v3154:
  %v3155 = getelementptr i64, ptr %v111, i64 %v3156
  %v3157 = load i64, ptr %v3155, align 8, !noalias !438
  %v3158 = icmp eq i64 %v3157, 0
  br i1 %v3158, label %v3159, label %v3160

v3159:
  %v3161 = getelementptr double, ptr %v905, i64 %v3162
  %v3163 = load double, ptr %v3161, align 8, !noalias !438
  %v3164 = fcmp olt double %v3163, 5.000000e-01
  br i1 %v3164, label %v3160, label %v3165

v3165:
  %v3166 = getelementptr double, ptr %v134, i64 %v3162
  %v3167 = load double, ptr %v3166, align 8, !noalias !438
  %v3168 = getelementptr double, ptr %v907, i64 %v3162
  %v3169 = load double, ptr %v3168, align 8, !noalias !438
  %v3170 = fcmp une double %v3167, %v3169
  %v3171 = select i1 %v3170, i1 true, i1 %v909
  %v3172 = xor i1 %v3170, true
  %v3173 = select i1 %v3172, i1 true, i1 %v3174
  br i1 %v3171, label %v3160, label %v3175

v3175:
  %v3176 = getelementptr i64, ptr %v908, i64 %v3162
  %v3177 = load i64, ptr %v3176, align 8, !noalias !443
  %v3178 = add nsw i64 %v3177, 1
  %v3179 = icmp slt i64 %v3177, -1
  %v3180 = select i1 %v3179, i64 %v78, i64 0
  %v3181 = add i64 %v3178, %v3180
  %v3182 = mul i64 %v3181, %v79
  %v3183 = getelementptr double, ptr %v77, i64 %v3182
  br label %v3184

v3184:
  %v3185 = phi i64 [ 0, %v3175 ], [ %v3186, %v3184 ]
  %v3186 = add nsw i64 %v3185, 1
  %v3187 = getelementptr double, ptr %v3183, i64 %v3185
  %v3188 = load double, ptr %v3187, align 8, !noalias !444
  %v3189 = getelementptr i64, ptr %v63, i64 %v3185
  %v3190 = load i64, ptr %v3189, align 8, !noalias !444
  %v3191 = mul nsw i64 %v3190, %v9
  %v3192 = add nsw i64 %v3191, %v3162
  %v3193 = icmp slt i64 %v3192, 0
  %v3194 = select i1 %v3193, i64 %v167, i64 0
  %v3195 = getelementptr double, ptr %v166, i64 %v3192
  %v3196 = getelementptr double, ptr %v3195, i64 %v3194
  store double %v3188, ptr %v3196, align 8, !noalias !444
  %v3197 = icmp eq i64 %v64, %v3186
  br i1 %v3197, label %v3160, label %v3184

v3160:
  %v3198 = phi i1 [ %v3173, %v3165 ], [ %v3174, %v3159 ], [ %v3174, %v3153 ], [ %v3174, %v3154 ], [ true, %v3184 ]
  %v3199 = icmp eq i64 %v9, %v3200
  br i1 %v3199, label %v3201, label %v3153

v3201:
  br i1 %v3198, label %v3202, label %v3152

v3202:
  %v3203 = load i64, ptr %v910, align 8, !noalias !448
  %v3204 = inttoptr i64 %v3203 to ptr
  tail call void %v3204(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !448
  %v3205 = load i64, ptr %v912, align 8, !noalias !443
  %v3206 = inttoptr i64 %v3205 to ptr
  tail call void %v3206(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v914), !noalias !443
  br label %v3207

v3207:
  %v3208 = phi i64 [ 0, %v3202 ], [ %v3209, %v3210 ]
  %v3211 = phi i64 [ %v916, %v3202 ], [ %v3212, %v3210 ]
  %v3213 = phi i64 [ 1, %v3202 ], [ %v3214, %v3210 ]
  %v3215 = icmp slt i64 %v3208, 0
  %v3216 = select i1 %v3215, i64 %v145, i64 0
  %v3217 = add i64 %v3216, %v3208
  %v3218 = getelementptr i64, ptr %v143, i64 %v3217
  %v3219 = load i64, ptr %v3218, align 8, !noalias !451
  %v3220 = icmp slt i64 %v3219, 0
  br i1 %v3220, label %v3210, label %v3221

v3221:
  %v3222 = getelementptr i64, ptr %v111, i64 %v3219
  %v3223 = load i64, ptr %v3222, align 8, !noalias !451
  %v3224 = icmp eq i64 %v3223, 0
  br i1 %v3224, label %v3225, label %v3210

v3225:
  %v3226 = select i1 %v3215, i64 %v136, i64 0
  %v3227 = add i64 %v3226, %v3208
  %v3228 = getelementptr double, ptr %v905, i64 %v3227
  %v3229 = load double, ptr %v3228, align 8, !noalias !451
  %v3230 = fcmp olt double %v3229, 5.000000e-01
  br i1 %v3230, label %v3210, label %v3231

v3231:
  %v3232 = getelementptr double, ptr %v134, i64 %v3227
  %v3233 = load double, ptr %v3232, align 8, !noalias !451
  %v3234 = getelementptr double, ptr %v907, i64 %v3227
  %v3235 = load double, ptr %v3234, align 8, !noalias !451
  %v3236 = fcmp une double %v3233, %v3235
  br i1 %v3236, label %v3210, label %v3237

v3237:
  %v3238 = getelementptr i64, ptr %v919, i64 %v3217
  %v3239 = load i64, ptr %v3238, align 8, !noalias !454
  %v3240 = icmp sgt i64 %v3239, 0
  br i1 %v3240, label %v3241, label %v3242

v3241:
  %v3243 = getelementptr double, ptr %v93, i64 %v3239
  %v3244 = getelementptr i8, ptr %v3243, i64 -8
  %v3245 = load double, ptr %v3244, align 8, !noalias !454
  %v3246 = getelementptr double, ptr %v134, i64 %v3208
  %v3247 = getelementptr double, ptr %v3246, i64 %v3226
  %v3248 = load double, ptr %v3247, align 8, !noalias !454
  %v3249 = fcmp oeq double %v3245, %v3248
  br label %v3242

v3242:
  %v3250 = phi i1 [ %v3249, %v3241 ], [ false, %v3237 ]
  br i1 %v921, label %v3251, label %v3252

v3252:
  %v3253 = mul i64 %v915, %v3219
  %v3254 = select i1 %v3215, i64 %v197, i64 0
  %v3255 = add i64 %v3254, %v3208
  %v3256 = getelementptr double, ptr %v922, i64 %v3255
  %v3257 = getelementptr double, ptr %v194, i64 %v3255
  %v3258 = add nsw i64 %v3239, -1
  %v3259 = select i1 %v3240, i64 0, i64 %v102
  %v3260 = add i64 %v3258, %v3259
  %v3261 = mul i64 %v3260, %v103
  %v3262 = getelementptr double, ptr %v100, i64 %v3253
  %v3263 = getelementptr double, ptr %v3262, i64 %v3261
  br label %v3264

v3265:
  %v3266 = getelementptr double, ptr %v3263, i64 %v3267
  store double %v3268, ptr %v3266, align 8, !noalias !454
  br label %v3269

v3269:
  %v3270 = icmp eq i64 %v10, %v3271
  br i1 %v3270, label %v3272, label %v3264

v3272:
  %v3273 = fcmp une double %v3274, 0.000000e+00
  br i1 %v3273, label %v3275, label %v3251

v3275:
  %v3276 = load i64, ptr %v3218, align 8, !noalias !458
  %v3277 = icmp sgt i64 %v3276, -1
  br i1 %v3277, label %v3278, label %v3251

v3278:
  %v3279 = getelementptr i64, ptr %v111, i64 %v3276
  %v3280 = load i64, ptr %v3279, align 8, !noalias !458
  %v3281 = icmp eq i64 %v3280, 0
  br i1 %v3281, label %v3282, label %v3251

v3282:
  store i64 3, ptr %v3279, align 8, !noalias !458
  br label %v3251

v3251:
  br i1 %v291, label %v3283, label %v3210

v3283:
  %v3284 = load double, ptr %v924, align 8, !noalias !461
  %v3285 = load double, ptr %v93, align 8, !noalias !461
  %v3286 = fsub double %v3284, %v3285
  %v3287 = fmul double %v3286, 1.000000e-13
  %v3288 = load double, ptr %v134, align 8, !noalias !461
  %v3289 = tail call double @llvm.fabs.f64(double %v3288)
  %v3290 = fmul double %v3289, 4.000000e-15
  %v3291 = fcmp ogt double %v3290, %v3287
  %v3292 = select i1 %v3291, double %v3290, double %v3287
  %v3293 = fadd double %v3288, %v3292
  store double %v3293, ptr %v926, align 8, !noalias !471
  %v3294 = load i64, ptr %v6, align 8, !noalias !472
  %v3295 = inttoptr i64 %v3294 to ptr
  tail call void %v3295(ptr nonnull %v134, ptr %v914, ptr %v166, ptr %v173, ptr %v180, ptr %v928), !noalias !472
  br i1 %v921, label %v3296, label %v3297

v3296:
  %v3298 = load i64, ptr %v933, align 8, !noalias !475
  %v3299 = inttoptr i64 %v3298 to ptr
  tail call void %v3299(ptr nonnull %v134, ptr %v935, ptr %v166, ptr %v173, ptr %v180, ptr %v937), !noalias !475
  %v3300 = load i64, ptr %v933, align 8, !noalias !478
  %v3301 = inttoptr i64 %v3300 to ptr
  tail call void %v3301(ptr nonnull %v926, ptr %v939, ptr %v166, ptr %v173, ptr %v180, ptr %v941), !noalias !478
  br label %v3302

v3302:
  %v3303 = phi i64 [ %v19, %v3296 ], [ %v3304, %v3305 ]
  %v3306 = phi i64 [ %v943, %v3296 ], [ %v3307, %v3305 ]
  %v3308 = icmp sgt i64 %v3306, 0
  br i1 %v3308, label %v3305, label %v3309

v3305:
  %v3307 = add nsw i64 %v3306, -1
  %v3304 = add i64 %v3303, 1
  %v3310 = icmp slt i64 %v3303, 0
  %v3311 = select i1 %v3310, i64 %v208, i64 0
  %v3312 = add i64 %v3311, %v3303
  %v3313 = getelementptr double, ptr %v947, i64 %v3312
  %v3314 = load double, ptr %v3313, align 8, !noalias !471
  %v3315 = getelementptr double, ptr %v950, i64 %v3312
  %v3316 = load double, ptr %v3315, align 8, !noalias !471
  %v3317 = fsub double %v3314, %v3316
  %v3318 = tail call double @llvm.fabs.f64(double %v3317)
  %v3319 = getelementptr double, ptr %v952, i64 %v3312
  %v3320 = load double, ptr %v3319, align 8, !noalias !471
  %v3321 = tail call i1 @llvm.is.fpclass.f64(double %v3320, i32 543)
  %v3322 = select i1 %v3321, double 0.000000e+00, double %v3320
  %v3323 = fcmp ueq double %v3318, 0x7FF0000000000000
  %v3324 = select i1 %v3323, double -0.000000e+00, double %v3318
  %v3325 = fadd double %v3322, %v3324
  %v3326 = getelementptr double, ptr %v949, i64 %v3312
  %v3327 = load double, ptr %v3326, align 8, !noalias !471
  %v3328 = fneg double %v3325
  %v3329 = fcmp olt double %v3327, %v3328
  br i1 %v3329, label %v3309, label %v3302

v3297:
  %v3330 = phi i64 [ %v3331, %v3297 ], [ 0, %v3283 ]
  %v3331 = add nsw i64 %v3330, 1
  %v3332 = mul i64 %v3330, %v197
  %v3333 = getelementptr double, ptr %v922, i64 %v3332
  %v3334 = load double, ptr %v3333, align 8, !noalias !471
  %v3335 = getelementptr double, ptr %v930, i64 %v3332
  %v3336 = load double, ptr %v3335, align 8, !noalias !471
  %v3337 = fmul double %v3292, %v3336
  %v3338 = fadd double %v3334, %v3337
  %v3339 = getelementptr double, ptr %v932, i64 %v3332
  store double %v3338, ptr %v3339, align 8, !noalias !471
  %v3340 = icmp eq i64 %v10, %v3331
  br i1 %v3340, label %v3296, label %v3297

v3341:
  %v3342 = getelementptr i64, ptr %v954, i64 %v3217
  store i64 %v3343, ptr %v3342, align 8, !noalias !481
  %v3344 = load i64, ptr %v3218, align 8, !noalias !482
  %v3345 = icmp sgt i64 %v3344, -1
  br i1 %v3345, label %v3346, label %v3347

v3346:
  %v3348 = getelementptr i64, ptr %v111, i64 %v3344
  %v3349 = load i64, ptr %v3348, align 8, !noalias !482
  %v3350 = icmp eq i64 %v3349, 0
  br i1 %v3350, label %v3351, label %v3347

v3351:
  store i64 4, ptr %v3348, align 8, !noalias !482
  br label %v3347

v3347:
  %v3352 = load double, ptr %v3232, align 8, !noalias !481
  store double %v3352, ptr %v3234, align 8, !noalias !481
  %v3353 = getelementptr double, ptr %v956, i64 %v3227
  store double 0.000000e+00, ptr %v3353, align 8, !noalias !481
  br label %v3210

v3309:
  %v3343 = phi i64 [ %v3303, %v3305 ], [ -1, %v3302 ]
  %v3354 = icmp sgt i64 %v3343, -1
  br i1 %v3354, label %v3341, label %v3210

v3264:
  %v3355 = phi double [ 0.000000e+00, %v3252 ], [ %v3274, %v3269 ]
  %v3267 = phi i64 [ 0, %v3252 ], [ %v3271, %v3269 ]
  %v3271 = add nsw i64 %v3267, 1
  %v3356 = mul i64 %v3267, %v197
  %v3357 = getelementptr double, ptr %v3256, i64 %v3356
  %v3268 = load double, ptr %v3357, align 8, !noalias !454
  %v3358 = fmul double %v3268, 0.000000e+00
  %v3274 = fadd double %v3355, %v3358
  %v3359 = getelementptr double, ptr %v3257, i64 %v3356
  store double %v3268, ptr %v3359, align 8, !noalias !454
  br i1 %v3250, label %v3265, label %v3269

v3210:
  %v3360 = icmp sgt i64 %v3211, 0
  %v3361 = zext i1 %v3360 to i64
  %v3214 = add i64 %v3213, %v3361
  %v3362 = sext i1 %v3360 to i64
  %v3212 = add nsw i64 %v3211, %v3362
  %v3209 = select i1 %v3360, i64 %v3213, i64 0
  br i1 %v3360, label %v3207, label %v3152

v3153:
  %v3174 = phi i1 [ %v3198, %v3160 ], [ false, %v3070 ]
  %v3162 = phi i64 [ %v3200, %v3160 ], [ 0, %v3070 ]
  %v3200 = add nsw i64 %v3162, 1
  %v3363 = getelementptr i64, ptr %v143, i64 %v3162
  %v3156 = load i64, ptr %v3363, align 8, !noalias !438
  %v3364 = icmp slt i64 %v3156, 0
  br i1 %v3364, label %v3160, label %v3154

v3152:
  %v3365 = xor i1 %v1287, true
  %v3366 = or i1 %v294, %v3365
  %v3367 = select i1 %v1287, i64 0, i64 %v1057
  br i1 %v3366, label %v1056, label %v3368

v3369:
  %v3370 = mul i64 %v3371, %v127
  %v3372 = getelementptr i64, ptr %v125, i64 %v3370
  %v3373 = load i64, ptr %v3372, align 8, !noalias !485
  %v3374 = getelementptr i8, ptr %v3372, i64 24
  %v3375 = load i64, ptr %v3374, align 8, !noalias !485
  %v3376 = add i64 %v3373, %v3375
  %v3377 = sub i64 %v285, %v3376
  %v3378 = icmp slt i64 %v3377, 1
  br i1 %v3378, label %v3379, label %v3380

v3379:
  %v3381 = getelementptr i64, ptr %v111, i64 %v3371
  %v3382 = load i64, ptr %v3381, align 8, !noalias !489
  %v3383 = icmp eq i64 %v3382, 0
  br i1 %v3383, label %v3384, label %v3380

v3384:
  store i64 5, ptr %v3381, align 8, !noalias !489
  br label %v3380

v3380:
  %v3385 = getelementptr double, ptr %v958, i64 %v3386
  %v3387 = load double, ptr %v3385, align 8, !noalias !485
  %v3388 = fcmp ogt double %v3387, 5.000000e-01
  br i1 %v3388, label %v3389, label %v3390

v3389:
  %v3391 = getelementptr double, ptr %v134, i64 %v3386
  %v3392 = load double, ptr %v3391, align 8, !noalias !485
  %v3393 = getelementptr double, ptr %v960, i64 %v3386
  %v3394 = load double, ptr %v3393, align 8, !noalias !485
  %v3395 = fcmp oeq double %v3392, %v3394
  br i1 %v3395, label %v3396, label %v3390

v3396:
  %v3397 = getelementptr i64, ptr %v961, i64 %v3386
  %v3398 = load i64, ptr %v3397, align 8, !noalias !492
  %v3399 = add nsw i64 %v3398, 1
  store i64 %v3399, ptr %v3397, align 8, !noalias !492
  %v3400 = icmp slt i64 %v3398, -1
  %v3401 = select i1 %v3400, i64 %v71, i64 0
  %v3402 = getelementptr double, ptr %v70, i64 %v3399
  %v3403 = getelementptr double, ptr %v3402, i64 %v3401
  %v3404 = load double, ptr %v3403, align 8, !noalias !492
  %v3405 = fcmp oeq double %v3404, 0x7FF0000000000000
  br i1 %v3405, label %v3406, label %v3407

v3406:
  %v3408 = load i64, ptr %v3409, align 8, !noalias !492
  %v3410 = icmp slt i64 %v3408, 0
  %v3411 = select i1 %v3410, i64 %v112, i64 0
  %v3412 = getelementptr i64, ptr %v111, i64 %v3408
  %v3413 = getelementptr i64, ptr %v3412, i64 %v3411
  %v3414 = load i64, ptr %v3413, align 8, !noalias !492
  %v3415 = icmp eq i64 %v3414, 0
  br i1 %v3415, label %v3416, label %v3390

v3416:
  store i64 1, ptr %v3413, align 8, !noalias !492
  br label %v3390

v3407:
  store double %v3404, ptr %v3393, align 8, !noalias !492
  %v3417 = select i1 %v3400, i64 %v87, i64 0
  %v3418 = getelementptr i64, ptr %v86, i64 %v3399
  %v3419 = getelementptr i64, ptr %v3418, i64 %v3417
  %v3420 = load i64, ptr %v3419, align 8, !noalias !492
  %v3421 = icmp eq i64 %v3420, 0
  br i1 %v3421, label %v3422, label %v3423

v3422:
  %v3424 = getelementptr double, ptr %v965, i64 %v3386
  store double 1.000000e+00, ptr %v3424, align 8, !noalias !492
  br label %v3425

v3423:
  %v3426 = getelementptr double, ptr %v963, i64 %v3386
  %v3427 = load double, ptr %v3426, align 8, !noalias !492
  %v3428 = fcmp olt double %v3427, 2.500000e-01
  %v3429 = select i1 %v3428, double 2.500000e-01, double %v3427
  store double %v3429, ptr %v3426, align 8, !noalias !492
  %v3430 = load i64, ptr %v485, align 8, !noalias !492
  %v3431 = tail call i64 @llvm.smax.i64(i64 %v3430, i64 1)
  br label %v3425

v3425:
  %v3432 = phi i64 [ %v3431, %v3423 ], [ 2, %v3422 ]
  store i64 %v3432, ptr %v485, align 8, !noalias !492
  br i1 %v966, label %v3390, label %v3433

v3433:
  %v3434 = select i1 %v3400, i64 %v78, i64 0
  %v3435 = add i64 %v3434, %v3399
  %v3436 = mul i64 %v3435, %v79
  %v3437 = getelementptr double, ptr %v77, i64 %v3436
  br label %v3438

v3438:
  %v3439 = phi i64 [ 0, %v3433 ], [ %v3440, %v3438 ]
  %v3440 = add nsw i64 %v3439, 1
  %v3441 = getelementptr double, ptr %v3437, i64 %v3439
  %v3442 = load double, ptr %v3441, align 8, !noalias !496
  %v3443 = getelementptr i64, ptr %v63, i64 %v3439
  %v3444 = load i64, ptr %v3443, align 8, !noalias !496
  %v3445 = mul nsw i64 %v3444, %v9
  %v3446 = add nsw i64 %v3445, %v3386
  %v3447 = icmp slt i64 %v3446, 0
  %v3448 = select i1 %v3447, i64 %v167, i64 0
  %v3449 = getelementptr double, ptr %v166, i64 %v3446
  %v3450 = getelementptr double, ptr %v3449, i64 %v3448
  store double %v3442, ptr %v3450, align 8, !noalias !496
  %v3451 = icmp eq i64 %v64, %v3440
  br i1 %v3451, label %v3390, label %v3438

v3390:
  %v3452 = getelementptr i64, ptr %v111, i64 %v3371
  %v3453 = load i64, ptr %v3452, align 8, !noalias !485
  %v3454 = icmp eq i64 %v3453, 0
  br i1 %v3454, label %v3455, label %v3456

v3456:
  %v3457 = getelementptr i64, ptr %v968, i64 %v3386
  %v3458 = load i64, ptr %v3457, align 8, !noalias !485
  %v3459 = getelementptr i64, ptr %v118, i64 %v3371
  store i64 %v3458, ptr %v3459, align 8, !noalias !485
  store i64 -1, ptr %v3409, align 8, !noalias !485
  %v3460 = getelementptr double, ptr %v970, i64 %v3386
  store double 0.000000e+00, ptr %v3460, align 8, !noalias !500
  %v3461 = load i64, ptr %v152, align 8, !noalias !500
  %v3462 = load i64, ptr %v971, align 8, !noalias !500
  %v3463 = icmp eq i64 %v3461, %v3462
  br i1 %v3463, label %v3464, label %v3465

v3465:
  %v3466 = add nsw i64 %v3461, 1
  store i64 %v3466, ptr %v152, align 8, !noalias !500
  store i64 2, ptr %v485, align 8, !noalias !500
  store i64 %v3461, ptr %v3409, align 8, !noalias !500
  %v3467 = icmp slt i64 %v3461, 0
  %v3468 = select i1 %v3467, i64 %v50, i64 0
  %v3469 = getelementptr i64, ptr %v49, i64 %v3461
  %v3470 = getelementptr i64, ptr %v3469, i64 %v3468
  %v3471 = load i64, ptr %v3470, align 8, !noalias !500
  %v3472 = icmp slt i64 %v3471, 0
  %v3473 = select i1 %v3472, i64 %v57, i64 0
  %v3474 = getelementptr i64, ptr %v56, i64 %v3471
  %v3475 = getelementptr i64, ptr %v3474, i64 %v3473
  %v3476 = load i64, ptr %v3475, align 8, !noalias !500
  %v3477 = getelementptr i64, ptr %v972, i64 %v3386
  store i64 %v3476, ptr %v3477, align 8, !noalias !500
  store i64 1, ptr %v3457, align 8, !noalias !500
  %v3478 = getelementptr i64, ptr %v974, i64 %v3386
  store i64 0, ptr %v3478, align 8, !noalias !500
  br i1 %v975, label %v3479, label %v3480

v3480:
  %v3481 = select i1 %v3467, i64 %v41, i64 0
  %v3482 = add i64 %v3481, %v3461
  %v3483 = mul i64 %v3482, %v42
  %v3484 = getelementptr double, ptr %v40, i64 %v3483
  %v3485 = getelementptr double, ptr %v166, i64 %v3386
  br label %v3486

v3479:
  br i1 %v976, label %v3487, label %v3488

v3488:
  %v3489 = load i64, ptr %v3477, align 8, !noalias !500
  %v3490 = icmp slt i64 %v3489, 0
  %v3491 = select i1 %v3490, i64 %v78, i64 0
  %v3492 = add i64 %v3491, %v3489
  %v3493 = mul i64 %v3492, %v79
  %v3494 = getelementptr double, ptr %v77, i64 %v3493
  br label %v3495

v3495:
  %v3496 = phi i64 [ 0, %v3488 ], [ %v3497, %v3495 ]
  %v3497 = add nsw i64 %v3496, 1
  %v3498 = getelementptr double, ptr %v3494, i64 %v3496
  %v3499 = load double, ptr %v3498, align 8, !noalias !503
  %v3500 = getelementptr i64, ptr %v63, i64 %v3496
  %v3501 = load i64, ptr %v3500, align 8, !noalias !503
  %v3502 = mul nsw i64 %v3501, %v9
  %v3503 = add nsw i64 %v3502, %v3386
  %v3504 = icmp slt i64 %v3503, 0
  %v3505 = select i1 %v3504, i64 %v167, i64 0
  %v3506 = getelementptr double, ptr %v166, i64 %v3503
  %v3507 = getelementptr double, ptr %v3506, i64 %v3505
  store double %v3499, ptr %v3507, align 8, !noalias !503
  %v3508 = icmp eq i64 %v3497, %v64
  br i1 %v3508, label %v3487, label %v3495

v3509:
  %v3510 = getelementptr double, ptr %v134, i64 %v3386
  %v3511 = getelementptr double, ptr %v979, i64 %v3386
  %v3512 = load double, ptr %v3511, align 8, !noalias !507
  %v3513 = getelementptr double, ptr %v981, i64 %v3386
  %v3514 = load double, ptr %v3513, align 8, !noalias !507
  %v3515 = getelementptr double, ptr %v983, i64 %v3386
  %v3516 = load double, ptr %v3515, align 8, !noalias !507
  store double 0.000000e+00, ptr %v3510, align 8, !noalias !507
  %v3517 = getelementptr double, ptr %v3510, i64 %v136
  store double 0.000000e+00, ptr %v3517, align 8, !noalias !507
  %v3518 = getelementptr i8, ptr %v3510, i64 %v984
  store double 0.000000e+00, ptr %v3518, align 8, !noalias !507
  %v3519 = getelementptr i8, ptr %v3510, i64 %v969
  store double 0.000000e+00, ptr %v3519, align 8, !noalias !507
  %v3520 = getelementptr i8, ptr %v3510, i64 %v985
  store double 0.000000e+00, ptr %v3520, align 8, !noalias !507
  %v3521 = getelementptr i8, ptr %v3510, i64 %v957
  store double 0.000000e+00, ptr %v3521, align 8, !noalias !507
  %v3522 = getelementptr i8, ptr %v3510, i64 %v986
  store double 0.000000e+00, ptr %v3522, align 8, !noalias !507
  %v3523 = getelementptr i8, ptr %v3510, i64 %v987
  store double 0.000000e+00, ptr %v3523, align 8, !noalias !507
  %v3524 = getelementptr i8, ptr %v3510, i64 %v988
  store double 0.000000e+00, ptr %v3524, align 8, !noalias !507
  %v3525 = getelementptr i8, ptr %v3510, i64 %v989
  store double 0.000000e+00, ptr %v3525, align 8, !noalias !507
  %v3526 = getelementptr i8, ptr %v3510, i64 %v990
  store double 0.000000e+00, ptr %v3526, align 8, !noalias !507
  %v3527 = getelementptr i8, ptr %v3510, i64 %v991
  store double 0.000000e+00, ptr %v3527, align 8, !noalias !507
  %v3528 = getelementptr i8, ptr %v3510, i64 %v992
  store double 0.000000e+00, ptr %v3528, align 8, !noalias !507
  %v3529 = getelementptr i8, ptr %v3510, i64 %v993
  store double 0.000000e+00, ptr %v3529, align 8, !noalias !507
  %v3530 = getelementptr i8, ptr %v3510, i64 %v994
  store double 0.000000e+00, ptr %v3530, align 8, !noalias !507
  %v3531 = getelementptr i8, ptr %v3510, i64 %v995
  store double 0.000000e+00, ptr %v3531, align 8, !noalias !507
  %v3532 = getelementptr i8, ptr %v3510, i64 %v996
  store double 0.000000e+00, ptr %v3532, align 8, !noalias !507
  %v3533 = getelementptr i8, ptr %v3510, i64 %v997
  store double 0.000000e+00, ptr %v3533, align 8, !noalias !507
  %v3534 = getelementptr i8, ptr %v3510, i64 %v998
  store double 0.000000e+00, ptr %v3534, align 8, !noalias !507
  %v3535 = getelementptr i8, ptr %v3510, i64 %v999
  store double 0.000000e+00, ptr %v3535, align 8, !noalias !507
  %v3536 = getelementptr i8, ptr %v3510, i64 %v1000
  store double 0.000000e+00, ptr %v3536, align 8, !noalias !507
  %v3537 = getelementptr i8, ptr %v3510, i64 %v1001
  store double 0.000000e+00, ptr %v3537, align 8, !noalias !507
  %v3538 = getelementptr i8, ptr %v3510, i64 %v1002
  store double 0.000000e+00, ptr %v3538, align 8, !noalias !507
  %v3539 = getelementptr i8, ptr %v3510, i64 %v1003
  store double 0.000000e+00, ptr %v3539, align 8, !noalias !507
  %v3540 = getelementptr i8, ptr %v3510, i64 %v1004
  store double 0.000000e+00, ptr %v3540, align 8, !noalias !507
  %v3541 = getelementptr i8, ptr %v3510, i64 %v1005
  store double 0.000000e+00, ptr %v3541, align 8, !noalias !507
  %v3542 = getelementptr i8, ptr %v3510, i64 %v1006
  store double 0.000000e+00, ptr %v3542, align 8, !noalias !507
  %v3543 = getelementptr i8, ptr %v3510, i64 %v1007
  store double 0.000000e+00, ptr %v3543, align 8, !noalias !507
  %v3544 = getelementptr i8, ptr %v3510, i64 %v1008
  store double 0.000000e+00, ptr %v3544, align 8, !noalias !507
  %v3545 = getelementptr i8, ptr %v3510, i64 %v982
  store double 0.000000e+00, ptr %v3545, align 8, !noalias !507
  %v3546 = getelementptr i8, ptr %v3510, i64 %v980
  store double 0.000000e+00, ptr %v3546, align 8, !noalias !507
  %v3547 = getelementptr i8, ptr %v3510, i64 %v978
  store double 0.000000e+00, ptr %v3547, align 8, !noalias !507
  %v3548 = fcmp oeq double %v3516, 0xFFF0000000000000
  %v3549 = select i1 %v3548, double 0xFFF0000000000000, double 0.000000e+00
  store double %v3549, ptr %v3515, align 8, !noalias !507
  store double %v3514, ptr %v3513, align 8, !noalias !507
  store double %v3512, ptr %v3511, align 8, !noalias !507
  store double 1.000000e+00, ptr %v3460, align 8, !noalias !507
  %v3550 = getelementptr double, ptr %v1009, i64 %v3386
  store double 0xFFF0000000000000, ptr %v3550, align 8, !noalias !507
  %v3551 = getelementptr double, ptr %v1010, i64 %v3386
  store double 0x7FF0000000000000, ptr %v3551, align 8, !noalias !507
  %v3552 = load double, ptr %v93, align 8, !noalias !500
  store double %v3552, ptr %v3510, align 8, !noalias !500
  %v3553 = load i64, ptr %v3477, align 8, !noalias !500
  %v3554 = icmp slt i64 %v3553, 0
  %v3555 = select i1 %v3554, i64 %v71, i64 0
  %v3556 = getelementptr double, ptr %v70, i64 %v3553
  %v3557 = getelementptr double, ptr %v3556, i64 %v3555
  %v3558 = load double, ptr %v3557, align 8, !noalias !500
  %v3559 = getelementptr double, ptr %v1011, i64 %v3386
  store double %v3558, ptr %v3559, align 8, !noalias !500
  br label %v3464

v3486:
  %v3560 = phi i64 [ 0, %v3480 ], [ %v3561, %v3486 ]
  %v3561 = add nsw i64 %v3560, 1
  %v3562 = getelementptr double, ptr %v3484, i64 %v3560
  %v3563 = load double, ptr %v3562, align 8, !noalias !500
  %v3564 = mul nsw i64 %v3560, %v9
  %v3565 = getelementptr double, ptr %v3485, i64 %v3564
  store double %v3563, ptr %v3565, align 8, !noalias !500
  %v3566 = icmp eq i64 %v3561, %v42
  br i1 %v3566, label %v3479, label %v3486

v3487:
  br i1 %v977, label %v3509, label %v3567

v3567:
  %v3568 = getelementptr double, ptr %v194, i64 %v3386
  %v3569 = select i1 %v3467, i64 %v32, i64 0
  %v3570 = add i64 %v3569, %v3461
  %v3571 = mul i64 %v3570, %v33
  %v3572 = getelementptr double, ptr %v31, i64 %v3571
  br label %v3573

v3573:
  %v3574 = phi i64 [ 0, %v3567 ], [ %v3575, %v3573 ]
  %v3575 = add nsw i64 %v3574, 1
  %v3576 = getelementptr double, ptr %v3572, i64 %v3574
  %v3577 = load double, ptr %v3576, align 8, !noalias !500
  %v3578 = mul i64 %v3574, %v197
  %v3579 = getelementptr double, ptr %v3568, i64 %v3578
  store double %v3577, ptr %v3579, align 8, !noalias !500
  %v3580 = icmp eq i64 %v3575, %v10
  br i1 %v3580, label %v3509, label %v3573

v3455:
  %v3581 = getelementptr double, ptr %v1013, i64 %v3386
  %v3582 = load double, ptr %v3581, align 8, !noalias !485
  %v3583 = fcmp ult double %v3582, 1.500000e+01
  br i1 %v3583, label %v3464, label %v3584

v3584:
  %v3585 = load double, ptr %v1015, align 8, !noalias !485
  %v3586 = getelementptr double, ptr %v134, i64 %v3386
  %v3587 = load double, ptr %v3586, align 8, !noalias !485
  %v3588 = fsub double %v3585, %v3587
  %v3589 = getelementptr double, ptr %v1016, i64 %v3386
  %v3590 = load double, ptr %v3589, align 8, !noalias !485
  %v3591 = fmul double %v3590, 2.500000e+02
  %v3592 = fcmp ogt double %v3588, %v3591
  br i1 %v3592, label %v3464, label %v3593

v3593:
  store double 0.000000e+00, ptr %v3581, align 8, !noalias !485
  br label %v3464

v3464:
  %v3594 = phi i1 [ %v3595, %v3455 ], [ true, %v3584 ], [ %v3595, %v3593 ], [ %v3595, %v3456 ], [ %v3595, %v3509 ]
  %v3596 = load i64, ptr %v3409, align 8, !noalias !485
  %v3597 = icmp sgt i64 %v3596, -1
  br i1 %v3597, label %v3598, label %v3599

v3598:
  %v3600 = add nsw i64 %v3601, 1
  %v3602 = getelementptr double, ptr %v1018, i64 %v3386
  %v3603 = load double, ptr %v3602, align 8, !noalias !485
  %v3604 = fcmp ogt double %v3603, 0.000000e+00
  br i1 %v3604, label %v3605, label %v3606

v3606:
  %v3607 = mul i64 %v3596, %v127
  %v3608 = getelementptr i64, ptr %v125, i64 %v3607
  %v3609 = load i64, ptr %v3608, align 8, !noalias !485
  %v3610 = and i64 %v3609, 127
  %v3611 = sub nsw i64 128, %v3610
  %v3612 = tail call i64 @llvm.smin.i64(i64 %v3611, i64 %v3377)
  %v3613 = sitofp i64 %v3612 to double
  br label %v3605

v3605:
  %v3614 = phi double [ %v3613, %v3606 ], [ 1.000000e+00, %v3598 ]
  %v3615 = getelementptr double, ptr %v1020, i64 %v3386
  store double %v3614, ptr %v3615, align 8, !noalias !485
  %v3616 = getelementptr double, ptr %v1022, i64 %v3386
  %v3617 = load double, ptr %v3616, align 8, !noalias !511
  %v3618 = getelementptr double, ptr %v1024, i64 %v3386
  store double %v3617, ptr %v3618, align 8, !noalias !511
  %v3619 = getelementptr i64, ptr %v1026, i64 %v3386
  %v3620 = load i64, ptr %v3619, align 8, !noalias !511
  %v3621 = icmp slt i64 %v3620, %v94
  br i1 %v3621, label %v3622, label %v3599

v3622:
  %v3623 = icmp slt i64 %v3620, 0
  %v3624 = select i1 %v3623, i64 %v94, i64 0
  %v3625 = getelementptr double, ptr %v93, i64 %v3620
  %v3626 = getelementptr double, ptr %v3625, i64 %v3624
  %v3627 = load double, ptr %v3626, align 8, !noalias !511
  %v3628 = load double, ptr %v3616, align 8, !noalias !511
  %v3629 = fcmp olt double %v3628, %v3627
  %v3630 = select i1 %v3629, double %v3628, double %v3627
  store double %v3630, ptr %v3618, align 8, !noalias !511
  br label %v3599

v3599:
  %v3631 = phi i64 [ %v3601, %v3368 ], [ %v3601, %v3464 ], [ %v3600, %v3605 ], [ %v3600, %v3622 ]
  %v3632 = phi i1 [ %v3595, %v3368 ], [ %v3594, %v3464 ], [ %v3594, %v3605 ], [ %v3594, %v3622 ]
  %v3633 = icmp sgt i64 %v3634, 1
  br i1 %v3633, label %v3368, label %v3635

v3368:
  %v3595 = phi i1 [ %v3632, %v3599 ], [ false, %v3152 ]
  %v3601 = phi i64 [ %v3631, %v3599 ], [ 0, %v3152 ]
  %v3386 = phi i64 [ %v3636, %v3599 ], [ 0, %v3152 ]
  %v3634 = phi i64 [ %v3637, %v3599 ], [ %v295, %v3152 ]
  %v3637 = add nsw i64 %v3634, -1
  %v3636 = add nsw i64 %v3386, 1
  %v3409 = getelementptr i64, ptr %v143, i64 %v3386
  %v3371 = load i64, ptr %v3409, align 8, !noalias !485
  %v3638 = icmp slt i64 %v3371, 0
  br i1 %v3638, label %v3599, label %v3369

v1056:
  %v1055 = phi i64 [ %v1059, %v3152 ], [ %v3639, %v3635 ]
  %v1058 = phi i64 [ %v3367, %v3152 ], [ %v3631, %v3635 ]
  %v3640 = icmp sgt i64 %v1058, 0
  %v3641 = icmp sgt i64 %v1055, 0
  %v3642 = select i1 %v3640, i1 %v3641, i1 false
  br i1 %v3642, label %v1053, label %v484

v484:
  %v3643 = phi i64 [ %v479, %v296 ], [ %v1058, %v1056 ]
  br i1 %v294, label %v3644, label %v3645

v3645:
  %v3646 = mul i64 %v136, 192
  %v3647 = getelementptr i8, ptr %v134, i64 %v3646
  %v3648 = mul i64 %v136, 200
  %v3649 = getelementptr i8, ptr %v134, i64 %v3648
  %v3650 = add nsw i64 %v11, -1
  %v3651 = mul i64 %v136, 176
  %v3652 = getelementptr i8, ptr %v134, i64 %v3651
  br label %v3653

v3654:
  %v3655 = getelementptr double, ptr %v3647, i64 %v3656
  %v3657 = load double, ptr %v3655, align 8, !noalias !515
  %v3658 = fptosi double %v3657 to i64
  %v3659 = getelementptr double, ptr %v3649, i64 %v3656
  %v3660 = load double, ptr %v3659, align 8, !noalias !515
  %v3661 = fptosi double %v3660 to i64
  %v3662 = mul i64 %v3663, %v127
  %v3664 = getelementptr i64, ptr %v125, i64 %v3662
  %v3665 = load i64, ptr %v3664, align 8, !noalias !515
  %v3666 = add nsw i64 %v3665, %v3658
  store i64 %v3666, ptr %v3664, align 8, !noalias !515
  %v3667 = getelementptr i8, ptr %v3664, i64 24
  %v3668 = load i64, ptr %v3667, align 8, !noalias !515
  %v3669 = add nsw i64 %v3668, %v3661
  store i64 %v3669, ptr %v3667, align 8, !noalias !515
  %v3670 = getelementptr i8, ptr %v3664, i64 8
  %v3671 = load i64, ptr %v3670, align 8, !noalias !515
  %v3672 = add nsw i64 %v3661, %v3658
  %v3673 = mul nsw i64 %v3672, %v3650
  %v3674 = add nsw i64 %v3673, %v3658
  %v3675 = add nsw i64 %v3674, %v3671
  store i64 %v3675, ptr %v3670, align 8, !noalias !515
  store double 0.000000e+00, ptr %v3655, align 8, !noalias !515
  store double 0.000000e+00, ptr %v3659, align 8, !noalias !515
  %v3676 = getelementptr double, ptr %v3652, i64 %v3656
  %v3677 = load double, ptr %v3676, align 8, !noalias !515
  %v3678 = sitofp i64 %v3672 to double
  %v3679 = fsub double %v3677, %v3678
  store double %v3679, ptr %v3676, align 8, !noalias !515
  br label %v3680

v3680:
  %v3681 = icmp sgt i64 %v3682, 1
  br i1 %v3681, label %v3653, label %v3644

v3653:
  %v3656 = phi i64 [ 0, %v3645 ], [ %v3683, %v3680 ]
  %v3682 = phi i64 [ %v295, %v3645 ], [ %v3684, %v3680 ]
  %v3684 = add nsw i64 %v3682, -1
  %v3683 = add nsw i64 %v3656, 1
  %v3685 = getelementptr i64, ptr %v143, i64 %v3656
  %v3663 = load i64, ptr %v3685, align 8, !noalias !515
  %v3686 = icmp sgt i64 %v3663, -1
  br i1 %v3686, label %v3654, label %v3680

v3687:
  %v3688 = phi i32 [ 0, %v3644 ], [ %v2942, %v2944 ]
  ret i32 %v3688

v345:
  %v476 = phi i64 [ 0, %v297 ], [ %v475, %v352 ]
  %v478 = phi i64 [ %v295, %v297 ], [ %v3689, %v352 ]
  %v348 = phi i64 [ 0, %v297 ], [ %v3690, %v352 ]
  %v3689 = add nsw i64 %v478, -1
  %v3690 = add nsw i64 %v348, 1
  %v472 = getelementptr i64, ptr %v143, i64 %v348
  %v3691 = load i64, ptr %v472, align 8
  %v3692 = icmp slt i64 %v3691, 0
  br i1 %v3692, label %v346, label %v352

v1265:
  %v3693 = load i64, ptr %v6, align 8, !noalias !519
  %v3694 = inttoptr i64 %v3693 to ptr
  tail call void %v3694(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v567), !noalias !519
  br label %v1266

v1266:
  br i1 %v568, label %v3695, label %v3696

v3695:
  %v3697 = load double, ptr %v570, align 8, !noalias !522
  %v3698 = fcmp olt double %v3697, 5.000000e-01
  br i1 %v3698, label %v3699, label %v3700

v3699:
  br i1 %v571, label %v3701, label %v3702

v3701:
  br i1 %v583, label %v3703, label %v3704, !prof !389

v3705:
  %v3706 = icmp eq i64 %v3707, %v616
  br i1 %v3706, label %v3700, label %v3708

v3709:
  %v3710 = load i64, ptr %v593, align 8, !noalias !526
  %v3711 = icmp eq i64 %v3710, %v3707
  br i1 %v3711, label %v3712, label %v3713

v3712:
  %v3714 = load double, ptr %v595, align 8, !noalias !526
  %v3715 = fmul double %v3714, 1.000000e-03
  br label %v3713

v3713:
  %v3716 = phi double [ %v3715, %v3712 ], [ 0.000000e+00, %v3709 ]
  store double %v3716, ptr %v3717, align 8, !noalias !526
  br i1 %v571, label %v3718, label %v3719

v3720:
  %v3721 = phi i64 [ %v3722, %v3720 ], [ 0, %v3708 ]
  %v3722 = add nsw i64 %v3721, 1
  %v3723 = mul i64 %v3721, %v197
  %v3724 = getelementptr double, ptr %v194, i64 %v3723
  %v3725 = load double, ptr %v3724, align 8, !noalias !526
  %v3726 = tail call double @llvm.fabs.f64(double %v3725)
  %v3727 = fcmp ogt double %v3728, %v3726
  %v3729 = select i1 %v3727, double %v3728, double %v3726
  %v3730 = fcmp ogt double %v3729, 0.000000e+00
  %v3731 = fmul double %v3729, 1.200000e-05
  %v3732 = select i1 %v3730, double %v3731, double 1.200000e-05
  %v3733 = getelementptr i64, ptr %v253, i64 %v3721
  %v3734 = load i64, ptr %v3733, align 8, !noalias !526
  %v3735 = icmp eq i64 %v3734, %v3707
  %v3736 = select i1 %v3735, double %v3732, double 0.000000e+00
  %v3737 = getelementptr double, ptr %v3738, i64 %v3721
  store double %v3736, ptr %v3737, align 8, !noalias !526
  %v3739 = icmp eq i64 %v10, %v3722
  br i1 %v3739, label %v3709, label %v3720

v3740:
  %v3741 = getelementptr double, ptr %v609, i64 %v3742
  store double %v3743, ptr %v3741, align 8, !noalias !532
  br label %v3744

v3745:
  %v3746 = select i1 %v3747, i64 %v282, i64 0
  %v3748 = getelementptr i64, ptr %v281, i64 %v3749
  %v3750 = getelementptr i64, ptr %v3748, i64 %v3746
  %v3751 = load i64, ptr %v3750, align 8, !noalias !532
  %v3752 = icmp slt i64 %v3751, 0
  %v3753 = select i1 %v3752, i64 %v224, i64 0
  %v3754 = getelementptr double, ptr %v223, i64 %v3751
  %v3755 = getelementptr double, ptr %v3754, i64 %v3753
  store double %v3743, ptr %v3755, align 8, !noalias !532
  br label %v3744

v3744:
  %v3756 = icmp sgt i64 %v3757, 1
  br i1 %v3756, label %v3758, label %v3705

v3702:
  %v3759 = phi i64 [ %v3760, %v3702 ], [ 0, %v3699 ]
  %v3760 = add nsw i64 %v3759, 1
  %v3761 = mul i64 %v3759, %v197
  %v3762 = getelementptr double, ptr %v194, i64 %v3761
  %v3763 = load double, ptr %v3762, align 8, !noalias !532
  %v3764 = getelementptr double, ptr %v574, i64 %v3761
  store double %v3763, ptr %v3764, align 8, !noalias !532
  %v3765 = getelementptr double, ptr %v576, i64 %v3761
  store double 0.000000e+00, ptr %v3765, align 8, !noalias !532
  %v3766 = icmp eq i64 %v10, %v3760
  br i1 %v3766, label %v3701, label %v3702

v3767:
  %v3768 = phi i64 [ %v160, %v3769 ], [ %v3770, %v3771 ]
  %v3772 = sub i64 %v3768, %v3773
  %v3774 = tail call i64 @llvm.smax.i64(i64 %v3772, i64 0)
  %v3738 = getelementptr double, ptr %v159, i64 %v3773
  br i1 %v588, label %v3775, label %v3700

v3775:
  %v3776 = select i1 %v580, i64 %v3774, i64 0
  %v3777 = getelementptr double, ptr %v3738, i64 %v10
  %v3717 = getelementptr double, ptr %v3777, i64 %v3776
  br label %v3708

v3703:
  br label %v3704

v3704:
  %v3778 = phi i64 [ 0, %v3703 ], [ %v582, %v3701 ]
  br i1 %v584, label %v3779, label %v3780, !prof !131

v3780:
  br label %v3779

v3779:
  %v3773 = phi i64 [ %v160, %v3780 ], [ %v3778, %v3704 ]
  br i1 %v586, label %v3781, label %v3771, !prof !389

v3781:
  br label %v3771

v3771:
  %v3770 = phi i64 [ 0, %v3781 ], [ %v585, %v3779 ]
  br i1 %v587, label %v3767, label %v3769, !prof !131

v3769:
  br label %v3767

v3708:
  %v3707 = phi i64 [ 0, %v3775 ], [ %v3782, %v3705 ]
  %v3782 = add nsw i64 %v3707, 1
  %v3783 = load double, ptr %v590, align 8, !noalias !526
  %v3784 = load double, ptr %v24, align 8, !noalias !526
  %v3728 = fdiv double %v3783, %v3784
  br i1 %v571, label %v3709, label %v3720

v3785:
  %v3786 = load double, ptr %v134, align 8, !noalias !533
  %v3787 = load double, ptr %v3717, align 8, !noalias !533
  %v3788 = fmul double %v3787, 5.000000e-01
  %v3789 = fadd double %v3786, %v3788
  store double %v3789, ptr %v598, align 8, !noalias !533
  %v3790 = load i64, ptr %v6, align 8, !noalias !537
  %v3791 = inttoptr i64 %v3790 to ptr
  tail call void %v3791(ptr nonnull %v598, ptr %v601, ptr %v166, ptr %v173, ptr %v180, ptr %v611), !noalias !537
  br label %v3792

v3792:
  %v3793 = phi i64 [ %v3794, %v3792 ], [ 0, %v3785 ]
  %v3794 = add nsw i64 %v3793, 1
  %v3795 = mul i64 %v3793, %v197
  %v3796 = getelementptr double, ptr %v194, i64 %v3795
  %v3797 = load double, ptr %v3796, align 8, !noalias !533
  %v3798 = getelementptr double, ptr %v3738, i64 %v3793
  %v3799 = load double, ptr %v3798, align 8, !noalias !533
  %v3800 = fmul double %v3799, 5.000000e-01
  %v3801 = fsub double %v3797, %v3800
  %v3802 = getelementptr double, ptr %v602, i64 %v3795
  store double %v3801, ptr %v3802, align 8, !noalias !533
  %v3803 = icmp eq i64 %v10, %v3794
  br i1 %v3803, label %v3804, label %v3792

v3718:
  %v3805 = load double, ptr %v134, align 8, !noalias !533
  %v3806 = fmul double %v3716, 5.000000e-01
  %v3807 = fadd double %v3806, %v3805
  store double %v3807, ptr %v598, align 8, !noalias !533
  %v3808 = load i64, ptr %v6, align 8, !noalias !537
  %v3809 = inttoptr i64 %v3808 to ptr
  tail call void %v3809(ptr nonnull %v598, ptr %v601, ptr %v166, ptr %v173, ptr %v180, ptr %v613), !noalias !537
  br label %v3804

v3804:
  %v3810 = load double, ptr %v134, align 8, !noalias !533
  %v3811 = load double, ptr %v3717, align 8, !noalias !533
  %v3812 = fmul double %v3811, 5.000000e-01
  %v3813 = fsub double %v3810, %v3812
  store double %v3813, ptr %v598, align 8, !noalias !533
  %v3814 = load i64, ptr %v6, align 8, !noalias !537
  %v3815 = inttoptr i64 %v3814 to ptr
  tail call void %v3815(ptr nonnull %v598, ptr %v601, ptr %v166, ptr %v173, ptr %v180, ptr %v615), !noalias !537
  br i1 %v571, label %v3816, label %v3817

v3818:
  %v3819 = fsub double %v3820, %v3821
  br label %v3822

v3823:
  %v3824 = getelementptr double, ptr %v607, i64 %v3825
  %v3826 = load double, ptr %v3824, align 8, !noalias !533
  %v3827 = fsub double %v3820, %v3826
  %v3828 = fmul double %v3827, 2.000000e+00
  br label %v3822

v3822:
  %v3829 = phi double [ %v3828, %v3823 ], [ %v3819, %v3818 ]
  store double %v3829, ptr %v3830, align 8, !noalias !533
  %v3831 = icmp eq i64 %v10, %v3832
  br i1 %v3831, label %v3816, label %v3817

v3719:
  %v3833 = phi i64 [ %v3834, %v3719 ], [ 0, %v3713 ]
  %v3834 = add nsw i64 %v3833, 1
  %v3835 = mul i64 %v3833, %v197
  %v3836 = getelementptr double, ptr %v194, i64 %v3835
  %v3837 = load double, ptr %v3836, align 8, !noalias !533
  %v3838 = getelementptr double, ptr %v3738, i64 %v3833
  %v3839 = load double, ptr %v3838, align 8, !noalias !533
  %v3840 = fmul double %v3839, 5.000000e-01
  %v3841 = fadd double %v3837, %v3840
  %v3842 = getelementptr double, ptr %v602, i64 %v3835
  store double %v3841, ptr %v3842, align 8, !noalias !533
  %v3843 = icmp eq i64 %v10, %v3834
  br i1 %v3843, label %v3785, label %v3719

v3817:
  %v3844 = phi i64 [ %v3832, %v3822 ], [ 0, %v3804 ]
  %v3832 = add nsw i64 %v3844, 1
  %v3825 = mul i64 %v3844, %v197
  %v3845 = getelementptr double, ptr %v194, i64 %v3825
  %v3846 = load double, ptr %v3845, align 8, !noalias !533
  %v3847 = getelementptr double, ptr %v602, i64 %v3825
  store double %v3846, ptr %v3847, align 8, !noalias !533
  %v3830 = getelementptr double, ptr %v604, i64 %v3825
  %v3820 = load double, ptr %v3830, align 8, !noalias !533
  %v3848 = getelementptr double, ptr %v606, i64 %v3825
  %v3821 = load double, ptr %v3848, align 8, !noalias !533
  %v3849 = fsub double %v3821, %v3821
  %v3850 = fcmp oeq double %v3849, 0.000000e+00
  br i1 %v3850, label %v3818, label %v3823

v3816:
  %v3851 = getelementptr i64, ptr %v260, i64 %v3707
  %v3852 = load i64, ptr %v3851, align 8, !noalias !532
  %v3853 = getelementptr i8, ptr %v3851, i64 8
  %v3854 = load i64, ptr %v3853, align 8, !noalias !532
  %v3855 = sub i64 %v3854, %v3852
  %v3856 = icmp slt i64 %v3855, 1
  br i1 %v3856, label %v3705, label %v3758

v3758:
  %v3757 = phi i64 [ %v3857, %v3744 ], [ %v3855, %v3816 ]
  %v3749 = phi i64 [ %v3858, %v3744 ], [ %v3852, %v3816 ]
  %v3857 = add nsw i64 %v3757, -1
  %v3858 = add i64 %v3749, 1
  %v3747 = icmp slt i64 %v3749, 0
  %v3859 = select i1 %v3747, i64 %v268, i64 0
  %v3860 = getelementptr i64, ptr %v267, i64 %v3749
  %v3861 = getelementptr i64, ptr %v3860, i64 %v3859
  %v3862 = load i64, ptr %v3861, align 8, !noalias !532
  %v3863 = select i1 %v3747, i64 %v275, i64 0
  %v3864 = getelementptr i64, ptr %v274, i64 %v3749
  %v3865 = getelementptr i64, ptr %v3864, i64 %v3863
  %v3866 = load i64, ptr %v3865, align 8, !noalias !532
  %v3867 = icmp slt i64 %v3862, 0
  %v3868 = select i1 %v3867, i64 %v196, i64 0
  %v3869 = add i64 %v3868, %v3862
  %v3742 = mul i64 %v3869, %v197
  %v3870 = getelementptr double, ptr %v604, i64 %v3742
  %v3871 = load double, ptr %v3870, align 8, !noalias !532
  %v3872 = icmp slt i64 %v3866, 0
  %v3873 = select i1 %v3872, i64 %v3774, i64 0
  %v3874 = getelementptr double, ptr %v3738, i64 %v3866
  %v3875 = getelementptr double, ptr %v3874, i64 %v3873
  %v3876 = load double, ptr %v3875, align 8, !noalias !532
  %v3877 = fdiv double %v3871, %v3876
  %v3878 = fsub double %v3877, %v3877
  %v3879 = fcmp oeq double %v3878, 0.000000e+00
  %v3743 = select i1 %v3879, double %v3877, double 0.000000e+00
  %v3880 = icmp eq i64 %v3866, %v10
  br i1 %v3880, label %v3740, label %v3745

v3700:
  br i1 %v617, label %v3881, label %v3696

v3882:
  %v3883 = mul i64 %v3884, %v620
  %v3885 = icmp slt i64 %v3883, 0
  %v3886 = select i1 %v3885, i64 %v231, i64 0
  %v3887 = getelementptr double, ptr %v230, i64 %v3883
  %v3888 = getelementptr double, ptr %v3887, i64 %v3886
  %v3889 = load double, ptr %v3888, align 8, !noalias !522
  %v3890 = load double, ptr %v622, align 8, !noalias !522
  %v3891 = fadd double %v3889, %v3890
  store double %v3891, ptr %v3888, align 8, !noalias !522
  %v3892 = icmp eq i64 %v10, %v3893
  br i1 %v3892, label %v3894, label %v3881

v3895:
  %v3896 = icmp eq i64 %v3897, %v10
  br i1 %v3896, label %v3696, label %v3894

v3898:
  %v3899 = phi i64 [ %v3900, %v3894 ], [ %v3901, %v3902 ]
  %v3903 = getelementptr i64, ptr %v237, i64 %v3900
  store i64 %v3899, ptr %v3903, align 8, !noalias !540
  %v3904 = add nsw i64 %v3899, %v3905
  %v3906 = icmp slt i64 %v3904, 0
  %v3907 = select i1 %v3906, i64 %v231, i64 0
  %v3908 = getelementptr double, ptr %v230, i64 %v3904
  %v3909 = getelementptr double, ptr %v3908, i64 %v3907
  %v3910 = load double, ptr %v3909, align 8, !noalias !540
  %v3911 = load double, ptr %v3912, align 8, !noalias !540
  store double %v3910, ptr %v3912, align 8, !noalias !540
  store double %v3911, ptr %v3909, align 8, !noalias !540
  br i1 %v3913, label %v3914, label %v3915

v3914:
  %v3916 = sub i64 %v3917, %v3897
  %v3918 = icmp slt i64 %v3916, 1
  br i1 %v3918, label %v3895, label %v3919

v3920:
  %v3921 = icmp sgt i64 %v3922, 1
  br i1 %v3921, label %v3919, label %v3895

v3894:
  %v3900 = phi i64 [ %v3897, %v3895 ], [ 0, %v3882 ]
  %v3897 = add nsw i64 %v3900, 1
  %v3905 = mul nsw i64 %v3900, %v10
  %v3923 = add nsw i64 %v3900, %v240
  %v3924 = add nsw i64 %v3923, 1
  %v3925 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %v3924, i64 %v10)
  %v3926 = add i64 %v623, %v3923
  %v3917 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %v3926, i64 %v10)
  %v3927 = getelementptr double, ptr %v230, i64 %v3905
  %v3912 = getelementptr double, ptr %v3927, i64 %v3900
  %v3928 = sub i64 %v3925, %v3897
  %v3929 = tail call i64 @llvm.smax.i64(i64 %v3928, i64 0)
  %v3913 = icmp slt i64 %v3928, 1
  br i1 %v3913, label %v3898, label %v3930

v3930:
  %v3931 = load double, ptr %v3912, align 8, !noalias !540
  %v3932 = tail call double @llvm.fabs.f64(double %v3931)
  br label %v3902

v3902:
  %v3933 = phi i64 [ %v3901, %v3902 ], [ %v3900, %v3930 ]
  %v3934 = phi double [ %v3935, %v3902 ], [ %v3932, %v3930 ]
  %v3936 = phi i64 [ %v3937, %v3902 ], [ %v3929, %v3930 ]
  %v3938 = phi i64 [ %v3939, %v3902 ], [ %v3897, %v3930 ]
  %v3937 = add nsw i64 %v3936, -1
  %v3939 = add i64 %v3938, 1
  %v3940 = add nsw i64 %v3938, %v3905
  %v3941 = icmp slt i64 %v3940, 0
  %v3942 = select i1 %v3941, i64 %v231, i64 0
  %v3943 = getelementptr double, ptr %v230, i64 %v3940
  %v3944 = getelementptr double, ptr %v3943, i64 %v3942
  %v3945 = load double, ptr %v3944, align 8, !noalias !540
  %v3946 = tail call double @llvm.fabs.f64(double %v3945)
  %v3947 = fcmp ogt double %v3946, %v3934
  %v3935 = select i1 %v3947, double %v3946, double %v3934
  %v3901 = select i1 %v3947, i64 %v3938, i64 %v3933
  %v3948 = icmp sgt i64 %v3936, 1
  br i1 %v3948, label %v3902, label %v3898

v3915:
  %v3949 = phi i64 [ %v3950, %v3915 ], [ %v3929, %v3898 ]
  %v3951 = phi i64 [ %v3952, %v3915 ], [ %v3897, %v3898 ]
  %v3950 = add nsw i64 %v3949, -1
  %v3952 = add i64 %v3951, 1
  %v3953 = add nsw i64 %v3951, %v3905
  %v3954 = icmp slt i64 %v3953, 0
  %v3955 = select i1 %v3954, i64 %v231, i64 0
  %v3956 = getelementptr double, ptr %v230, i64 %v3953
  %v3957 = getelementptr double, ptr %v3956, i64 %v3955
  %v3958 = load double, ptr %v3957, align 8, !noalias !540
  %v3959 = load double, ptr %v3912, align 8, !noalias !540
  %v3960 = fdiv double %v3958, %v3959
  store double %v3960, ptr %v3957, align 8, !noalias !540
  %v3961 = icmp sgt i64 %v3949, 1
  br i1 %v3961, label %v3915, label %v3914

v3919:
  %v3922 = phi i64 [ %v3962, %v3920 ], [ %v3916, %v3914 ]
  %v3963 = phi i64 [ %v3964, %v3920 ], [ %v3897, %v3914 ]
  %v3962 = add nsw i64 %v3922, -1
  %v3964 = add i64 %v3963, 1
  %v3965 = mul nsw i64 %v3963, %v10
  %v3966 = add nsw i64 %v3965, %v3899
  %v3967 = icmp slt i64 %v3966, 0
  %v3968 = select i1 %v3967, i64 %v231, i64 0
  %v3969 = getelementptr double, ptr %v230, i64 %v3966
  %v3970 = getelementptr double, ptr %v3969, i64 %v3968
  %v3971 = load double, ptr %v3970, align 8, !noalias !540
  %v3972 = add nsw i64 %v3965, %v3900
  %v3973 = icmp slt i64 %v3972, 0
  %v3974 = select i1 %v3973, i64 %v231, i64 0
  %v3975 = getelementptr double, ptr %v230, i64 %v3972
  %v3976 = getelementptr double, ptr %v3975, i64 %v3974
  %v3977 = load double, ptr %v3976, align 8, !noalias !540
  store double %v3977, ptr %v3970, align 8, !noalias !540
  store double %v3971, ptr %v3976, align 8, !noalias !540
  %v3978 = fcmp oeq double %v3971, 0.000000e+00
  %v3979 = or i1 %v3913, %v3978
  br i1 %v3979, label %v3920, label %v3980

v3980:
  %v3981 = phi i64 [ %v3982, %v3980 ], [ %v3929, %v3919 ]
  %v3983 = phi i64 [ %v3984, %v3980 ], [ %v3897, %v3919 ]
  %v3982 = add nsw i64 %v3981, -1
  %v3984 = add i64 %v3983, 1
  %v3985 = add nsw i64 %v3983, %v3965
  %v3986 = icmp slt i64 %v3985, 0
  %v3987 = select i1 %v3986, i64 %v231, i64 0
  %v3988 = getelementptr double, ptr %v230, i64 %v3985
  %v3989 = getelementptr double, ptr %v3988, i64 %v3987
  %v3990 = load double, ptr %v3989, align 8, !noalias !540
  %v3991 = add nsw i64 %v3983, %v3905
  %v3992 = icmp slt i64 %v3991, 0
  %v3993 = select i1 %v3992, i64 %v231, i64 0
  %v3994 = getelementptr double, ptr %v230, i64 %v3991
  %v3995 = getelementptr double, ptr %v3994, i64 %v3993
  %v3996 = load double, ptr %v3995, align 8, !noalias !540
  %v3997 = fmul double %v3971, %v3996
  %v3998 = fsub double %v3990, %v3997
  store double %v3998, ptr %v3989, align 8, !noalias !540
  %v3999 = icmp sgt i64 %v3981, 1
  br i1 %v3999, label %v3980, label %v3920

v3881:
  %v3884 = phi i64 [ %v3893, %v3882 ], [ 0, %v3700 ]
  %v3893 = add nsw i64 %v3884, 1
  %v4000 = sub i64 %v3884, %v618
  %v4001 = tail call i64 @llvm.smax.i64(i64 %v4000, i64 0)
  %v4002 = add i64 %v619, %v3884
  %v4003 = tail call i64 @llvm.smin.i64(i64 %v4002, i64 %v10)
  %v4004 = sub i64 %v4003, %v4001
  %v4005 = icmp slt i64 %v4004, 1
  br i1 %v4005, label %v3882, label %v4006

v4006:
  %v4007 = mul nsw i64 %v3884, %v10
  br label %v4008

v4008:
  %v4009 = phi i64 [ %v4004, %v4006 ], [ %v4010, %v4008 ]
  %v4011 = phi i64 [ %v4001, %v4006 ], [ %v4012, %v4008 ]
  %v4010 = add nsw i64 %v4009, -1
  %v4012 = add i64 %v4011, 1
  %v4013 = add nsw i64 %v4011, %v4007
  %v4014 = icmp slt i64 %v4013, 0
  %v4015 = select i1 %v4014, i64 %v224, i64 0
  %v4016 = getelementptr double, ptr %v223, i64 %v4013
  %v4017 = getelementptr double, ptr %v4016, i64 %v4015
  %v4018 = load double, ptr %v4017, align 8, !noalias !522
  %v4019 = fneg double %v4018
  %v4020 = select i1 %v4014, i64 %v231, i64 0
  %v4021 = getelementptr double, ptr %v230, i64 %v4013
  %v4022 = getelementptr double, ptr %v4021, i64 %v4020
  store double %v4019, ptr %v4022, align 8, !noalias !522
  %v4023 = icmp sgt i64 %v4009, 1
  br i1 %v4023, label %v4008, label %v3882

v3696:
  br i1 %v626, label %v1286, label %v4024

v4025:
  %v4026 = mul i64 %v4027, %v634
  %v4028 = getelementptr double, ptr %v194, i64 %v4026
  br label %v4029

v4030:
  %v4031 = icmp eq i64 %v10, %v4032
  br i1 %v4031, label %v4033, label %v4034

v4035:
  %v4036 = icmp sgt i64 %v4037, 1
  br i1 %v4036, label %v4033, label %v4038

v4038:
  %v4039 = mul i64 %v4027, %v643
  %v4040 = getelementptr double, ptr %v194, i64 %v4039
  br label %v4041

v4034:
  %v4042 = phi i64 [ %v4032, %v4030 ], [ 0, %v4029 ]
  %v4032 = add nsw i64 %v4042, 1
  %v4043 = getelementptr i64, ptr %v237, i64 %v4042
  %v4044 = load i64, ptr %v4043, align 8, !noalias !543
  %v4045 = add nsw i64 %v4044, %v639
  %v4046 = icmp slt i64 %v4045, 0
  %v4047 = select i1 %v4046, i64 %v160, i64 0
  %v4048 = getelementptr double, ptr %v159, i64 %v4045
  %v4049 = getelementptr double, ptr %v4048, i64 %v4047
  %v4050 = load double, ptr %v4049, align 8, !noalias !543
  %v4051 = getelementptr double, ptr %v641, i64 %v4042
  %v4052 = load double, ptr %v4051, align 8, !noalias !543
  store double %v4052, ptr %v4049, align 8, !noalias !543
  store double %v4050, ptr %v4051, align 8, !noalias !543
  %v4053 = add i64 %v640, %v4042
  %v4054 = tail call i64 @llvm.smin.i64(i64 %v4053, i64 %v10)
  %v4055 = sub i64 %v4054, %v4032
  %v4056 = icmp slt i64 %v4055, 1
  br i1 %v4056, label %v4030, label %v4057

v4057:
  %v4058 = mul nsw i64 %v4042, %v10
  br label %v4059

v4059:
  %v4060 = phi i64 [ %v4055, %v4057 ], [ %v4061, %v4059 ]
  %v4062 = phi i64 [ %v4032, %v4057 ], [ %v4063, %v4059 ]
  %v4061 = add nsw i64 %v4060, -1
  %v4063 = add i64 %v4062, 1
  %v4064 = add nsw i64 %v4062, %v639
  %v4065 = icmp slt i64 %v4064, 0
  %v4066 = select i1 %v4065, i64 %v160, i64 0
  %v4067 = getelementptr double, ptr %v159, i64 %v4064
  %v4068 = getelementptr double, ptr %v4067, i64 %v4066
  %v4069 = load double, ptr %v4068, align 8, !noalias !543
  %v4070 = add nsw i64 %v4062, %v4058
  %v4071 = icmp slt i64 %v4070, 0
  %v4072 = select i1 %v4071, i64 %v231, i64 0
  %v4073 = getelementptr double, ptr %v230, i64 %v4070
  %v4074 = getelementptr double, ptr %v4073, i64 %v4072
  %v4075 = load double, ptr %v4074, align 8, !noalias !543
  %v4076 = fmul double %v4050, %v4075
  %v4077 = fsub double %v4069, %v4076
  store double %v4077, ptr %v4068, align 8, !noalias !543
  %v4078 = icmp sgt i64 %v4060, 1
  br i1 %v4078, label %v4059, label %v4030

v4033:
  %v4037 = phi i64 [ %v4079, %v4035 ], [ %v10, %v4030 ]
  %v4079 = add nsw i64 %v4037, -1
  %v4080 = add nsw i64 %v4079, %v639
  %v4081 = icmp slt i64 %v4080, 0
  %v4082 = select i1 %v4081, i64 %v160, i64 0
  %v4083 = getelementptr double, ptr %v159, i64 %v4080
  %v4084 = getelementptr double, ptr %v4083, i64 %v4082
  %v4085 = load double, ptr %v4084, align 8, !noalias !543
  %v4086 = mul nsw i64 %v4079, %v10
  %v4087 = add nsw i64 %v4086, %v4079
  %v4088 = icmp slt i64 %v4087, 0
  %v4089 = select i1 %v4088, i64 %v231, i64 0
  %v4090 = getelementptr double, ptr %v230, i64 %v4087
  %v4091 = getelementptr double, ptr %v4090, i64 %v4089
  %v4092 = load double, ptr %v4091, align 8, !noalias !543
  %v4093 = fdiv double %v4085, %v4092
  store double %v4093, ptr %v4084, align 8, !noalias !543
  %v4094 = sub i64 %v4079, %v642
  %v4095 = tail call i64 @llvm.smax.i64(i64 %v4094, i64 0)
  %v4096 = sub i64 %v4079, %v4095
  %v4097 = icmp slt i64 %v4096, 1
  br i1 %v4097, label %v4035, label %v4098

v4098:
  %v4099 = phi i64 [ %v4100, %v4098 ], [ %v4096, %v4033 ]
  %v4101 = phi i64 [ %v4102, %v4098 ], [ %v4095, %v4033 ]
  %v4100 = add nsw i64 %v4099, -1
  %v4102 = add i64 %v4101, 1
  %v4103 = add nsw i64 %v4101, %v639
  %v4104 = icmp slt i64 %v4103, 0
  %v4105 = select i1 %v4104, i64 %v160, i64 0
  %v4106 = getelementptr double, ptr %v159, i64 %v4103
  %v4107 = getelementptr double, ptr %v4106, i64 %v4105
  %v4108 = load double, ptr %v4107, align 8, !noalias !543
  %v4109 = add nsw i64 %v4101, %v4086
  %v4110 = icmp slt i64 %v4109, 0
  %v4111 = select i1 %v4110, i64 %v231, i64 0
  %v4112 = getelementptr double, ptr %v230, i64 %v4109
  %v4113 = getelementptr double, ptr %v4112, i64 %v4111
  %v4114 = load double, ptr %v4113, align 8, !noalias !543
  %v4115 = fmul double %v4093, %v4114
  %v4116 = fsub double %v4108, %v4115
  store double %v4116, ptr %v4107, align 8, !noalias !543
  %v4117 = icmp sgt i64 %v4099, 1
  br i1 %v4117, label %v4098, label %v4035

v4029:
  %v4118 = phi i64 [ 0, %v4025 ], [ %v4119, %v4029 ]
  %v4119 = add nsw i64 %v4118, 1
  %v4120 = mul i64 %v4118, %v197
  %v4121 = getelementptr double, ptr %v4028, i64 %v4120
  %v4122 = load double, ptr %v4121, align 8, !noalias !549
  %v4123 = getelementptr double, ptr %v636, i64 %v4120
  %v4124 = load double, ptr %v4123, align 8, !noalias !549
  %v4125 = fadd double %v4122, %v4124
  %v4126 = getelementptr i64, ptr %v246, i64 %v4118
  %v4127 = load i64, ptr %v4126, align 8, !noalias !549
  %v4128 = icmp slt i64 %v4127, 0
  %v4129 = select i1 %v4128, i64 %v196, i64 0
  %v4130 = add i64 %v4129, %v4127
  %v4131 = mul i64 %v4130, %v197
  %v4132 = getelementptr double, ptr %v638, i64 %v4131
  store double %v4125, ptr %v4132, align 8, !noalias !549
  %v4133 = icmp eq i64 %v10, %v4119
  br i1 %v4133, label %v4034, label %v4029

v4041:
  %v4134 = phi i64 [ 0, %v4038 ], [ %v4135, %v4041 ]
  %v4135 = add nsw i64 %v4134, 1
  %v4136 = getelementptr i64, ptr %v246, i64 %v4134
  %v4137 = load i64, ptr %v4136, align 8, !noalias !549
  %v4138 = icmp slt i64 %v4137, 0
  %v4139 = select i1 %v4138, i64 %v196, i64 0
  %v4140 = add i64 %v4139, %v4137
  %v4141 = mul i64 %v4140, %v197
  %v4142 = getelementptr double, ptr %v645, i64 %v4141
  %v4143 = load double, ptr %v4142, align 8, !noalias !549
  %v4144 = mul i64 %v4134, %v197
  %v4145 = getelementptr double, ptr %v4040, i64 %v4144
  store double %v4143, ptr %v4145, align 8, !noalias !549
  %v4146 = icmp eq i64 %v10, %v4135
  br i1 %v4146, label %v4147, label %v4041

v4147:
  %v4148 = icmp eq i64 %v4149, %v625
  br i1 %v4148, label %v1286, label %v4024

v1286:
  %v4150 = load i64, ptr %v646, align 8, !noalias !550
  %v4151 = inttoptr i64 %v4150 to ptr
  tail call void %v4151(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !550
  br i1 %v294, label %v1284, label %v1274

v4024:
  %v4149 = phi i64 [ %v4027, %v4147 ], [ 1, %v3696 ]
  %v4027 = add i64 %v4149, 1
  %v4152 = getelementptr i64, ptr %v6, i64 %v4149
  %v4153 = getelementptr i8, ptr %v4152, i64 104
  %v4154 = load i64, ptr %v4153, align 8, !noalias !553
  %v4155 = inttoptr i64 %v4154 to ptr
  tail call void %v4155(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !553
  %v4156 = load i64, ptr %v6, align 8, !noalias !556
  %v4157 = mul nsw i64 %v4027, %v629
  %v4158 = getelementptr double, ptr %v159, i64 %v4157
  %v4159 = inttoptr i64 %v4156 to ptr
  tail call void %v4159(ptr %v628, ptr %v631, ptr %v166, ptr %v173, ptr %v180, ptr %v4158), !noalias !556
  br i1 %v633, label %v4025, label %v4147

v1274:
  %v1275 = phi i1 [ %v1281, %v1276 ], [ %v1262, %v1286 ]
  %v4160 = phi i1 [ %v1273, %v1276 ], [ false, %v1286 ]
  %v1283 = phi i64 [ %v4161, %v1276 ], [ %v295, %v1286 ]
  %v1269 = phi i64 [ %v4162, %v1276 ], [ 0, %v1286 ]
  %v4161 = add nsw i64 %v1283, -1
  %v4162 = add nsw i64 %v1269, 1
  br i1 %v4160, label %v1272, label %v1267

v1377:
  %v1387 = xor i1 %v1372, true
  %v4163 = xor i1 %v1373, true
  %v1389 = select i1 %v4163, i1 true, i1 %v673
  br label %v1290

v2944:
  store ptr %v2941, ptr %v1, align 8
  br label %v3687

v2943:
  %v4164 = select i1 %v1287, i1 %v1285, i1 false
  %v4165 = xor i1 %v4164, true
  %v4166 = or i1 %v294, %v4165
  br i1 %v4166, label %v3019, label %v3020

v3635:
  %v3639 = select i1 %v3632, i64 0, i64 %v1059
  br label %v1056

v3644:
  store i64 %v3643, ptr %v0, align 8
  br label %v3687
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc range(i32 0, 2) i32 @_ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr noalias nonnull %v0, ptr noalias nonnull %v1, i64 %v2, ptr readonly %v3, i64 %v4, ptr %v5, i64 %v6, i64 %v7, ptr %v8, i64 %v9, ptr %v10, i64 %v11, ptr readonly %v12, i64 %v13, i64 %v14, i64 %v15, double %v16) unnamed_addr {
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
  %v72 = load double, ptr %v71, align 8, !noalias !559
  %v73 = getelementptr double, ptr %v64, i64 %v66
  %v74 = load double, ptr %v73, align 8, !noalias !559
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
  %v82 = getelementptr double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v81
  %v83 = getelementptr i8, ptr %v82, i64 72
  %v84 = load double, ptr %v83, align 8
  %v85 = fcmp ogt double %v84, %v16
  %v86 = select i1 %v85, double %v84, double %v16
  %v87 = getelementptr double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v79
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
  %v144 = load double, ptr %v143, align 8, !noalias !563
  %v145 = load double, ptr %v142, align 8, !noalias !563
  %v146 = fmul double %v145, 0x3FDDF27AAAADCB3A
  %v147 = fsub double %v144, %v146
  %v148 = getelementptr i8, ptr %v142, i64 %v119
  %v149 = load double, ptr %v148, align 8, !noalias !563
  %v150 = fmul double %v149, 0x3FEC575F1EBC4F2F
  %v151 = fsub double %v147, %v150
  %v152 = getelementptr i8, ptr %v142, i64 %v120
  %v153 = load double, ptr %v152, align 8, !noalias !563
  %v154 = fmul double %v153, 0x3FE1306AA3D795F4
  %v155 = fadd double %v151, %v154
  %v156 = getelementptr i8, ptr %v142, i64 %v121
  %v157 = load double, ptr %v156, align 8, !noalias !563
  %v158 = fmul double %v157, 0x3FCCB9F574BDCC3A
  %v159 = fsub double %v155, %v158
  %v160 = getelementptr i8, ptr %v142, i64 %v122
  %v161 = load double, ptr %v160, align 8, !noalias !563
  %v162 = fmul double %v161, 0x3FA4EAF2D6B11E79
  %v163 = fadd double %v159, %v162
  %v164 = tail call double @llvm.fabs.f64(double %v163)
  %v165 = fcmp ogt double %v164, 0.000000e+00
  %v166 = select i1 %v165, double %v164, double 0.000000e+00
  %v167 = getelementptr i8, ptr %v142, i64 %v123
  %v168 = load double, ptr %v167, align 8, !noalias !563
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
  %v183 = load double, ptr %v182, align 8, !noalias !563
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
  %v198 = load double, ptr %v197, align 8, !noalias !563
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
  %v213 = load double, ptr %v212, align 8, !noalias !570
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
  %v266 = load double, ptr %v265, align 8, !noalias !571
  %v267 = icmp slt i64 %v251, 0
  %v268 = select i1 %v267, i64 %v13, i64 0
  %v269 = add i64 %v268, %v251
  %v270 = mul i64 %v269, %v104
  %v271 = getelementptr double, ptr %v142, i64 %v270
  %v272 = load double, ptr %v271, align 8, !noalias !571
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
  %v283 = load double, ptr %v282, align 8, !noalias !571
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
  %v321 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v293
  %v322 = load double, ptr %v321, align 8
  %v323 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v318
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
  %v330 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v325
  %v331 = load double, ptr %v330, align 8
  %v332 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v328
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
  br i1 %v341, label %v138, label %v344, !prof !389

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
  store double 0.000000e+00, ptr %v31, align 8, !noalias !575
  %v358 = shl i64 %v9, 5
  %v359 = getelementptr i8, ptr %v8, i64 %v358
  store double 0.000000e+00, ptr %v359, align 8, !noalias !575
  %v360 = getelementptr double, ptr %v8, i64 %v9
  store double %v357, ptr %v360, align 8, !noalias !575
  %v361 = load i64, ptr %v10, align 8, !noalias !575
  %v362 = icmp slt i64 %v361, 0
  %v363 = select i1 %v362, i64 %v6, i64 0
  %v364 = add i64 %v363, %v361
  %v365 = mul i64 %v364, %v7
  %v366 = getelementptr i64, ptr %v5, i64 %v365
  %v367 = load i64, ptr %v366, align 8, !noalias !575
  %v368 = add nsw i64 %v367, -1
  store i64 %v368, ptr %v366, align 8, !noalias !575
  %v369 = load i64, ptr %v10, align 8, !noalias !575
  %v370 = icmp slt i64 %v369, 0
  %v371 = select i1 %v370, i64 %v6, i64 0
  %v372 = add i64 %v371, %v369
  %v373 = mul i64 %v372, %v7
  %v374 = getelementptr i64, ptr %v5, i64 %v373
  %v375 = getelementptr i8, ptr %v374, i64 24
  %v376 = load i64, ptr %v375, align 8, !noalias !575
  %v377 = add nsw i64 %v376, 1
  store i64 %v377, ptr %v375, align 8, !noalias !575
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
  %v404 = load double, ptr %v403, align 8, !noalias !578
  %v405 = getelementptr double, ptr %v397, i64 %v401
  %v406 = load double, ptr %v405, align 8, !noalias !578
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
  %v430 = load double, ptr %v429, align 8, !noalias !582
  %v431 = getelementptr double, ptr %v423, i64 %v427
  %v432 = load double, ptr %v431, align 8, !noalias !582
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
  %v442 = load double, ptr %v8, align 8, !noalias !586
  %v443 = tail call double @llvm.fabs.f64(double %v442)
  %v444 = fmul double %v443, 4.000000e-15
  %v445 = getelementptr double, ptr %v3, i64 %v4
  %v446 = getelementptr i8, ptr %v445, i64 -8
  %v447 = load double, ptr %v446, align 8, !noalias !586
  %v448 = load double, ptr %v3, align 8, !noalias !586
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
!1 = distinct !{!1, !2, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!2 = distinct !{!2, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!3 = !{!4, !6, !1}
!4 = distinct !{!4, !5, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!5 = distinct !{!5, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!6 = distinct !{!6, !5, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!7 = !{!8, !10, !1}
!8 = distinct !{!8, !9, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!9 = distinct !{!9, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!10 = distinct !{!10, !9, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!11 = !{!12, !14}
!12 = distinct !{!12, !13, !"_ZN5pages12time_stepper14start_segmentsB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!13 = distinct !{!13, !"_ZN5pages12time_stepper14start_segmentsB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!14 = distinct !{!14, !13, !"_ZN5pages12time_stepper14start_segmentsB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!15 = !{!16, !12, !14}
!16 = distinct !{!16, !17, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!17 = distinct !{!17, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!18 = !{!19, !21, !23, !12, !14}
!19 = distinct !{!19, !20, !"_ZN5pages13solver_layout6decideB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_280_29: %retptr"}
!20 = distinct !{!20, !"_ZN5pages13solver_layout6decideB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_280_29"}
!21 = distinct !{!21, !22, !"_ZN5pages12event_checks17decisions_changedB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!22 = distinct !{!22, !"_ZN5pages12event_checks17decisions_changedB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!23 = distinct !{!23, !22, !"_ZN5pages12event_checks17decisions_changedB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!24 = !{!21, !23, !12, !14}
!25 = !{!26, !28, !30, !12, !14}
!26 = distinct !{!26, !27, !"_ZN5pages13solver_layout6decideB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_280_29: %retptr"}
!27 = distinct !{!27, !"_ZN5pages13solver_layout6decideB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_280_29"}
!28 = distinct !{!28, !29, !"_ZN5pages12event_checks14hold_decisionsB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!29 = distinct !{!29, !"_ZN5pages12event_checks14hold_decisionsB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!30 = distinct !{!30, !29, !"_ZN5pages12event_checks14hold_decisionsB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!31 = !{!28, !30, !12, !14}
!32 = !{!33, !28, !30, !12, !14}
!33 = distinct !{!33, !34, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!34 = distinct !{!34, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!35 = !{!36, !12, !14}
!36 = distinct !{!36, !37, !"_ZN5pages13solver_layout10derivativeB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29x: %retptr"}
!37 = distinct !{!37, !"_ZN5pages13solver_layout10derivativeB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29x"}
!38 = !{!39, !12, !14}
!39 = distinct !{!39, !40, !"_ZN5pages13solver_layout7formulaB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_287_29: %retptr"}
!40 = distinct !{!40, !"_ZN5pages13solver_layout7formulaB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_287_29"}
!41 = !{!42, !12, !14}
!42 = distinct !{!42, !43, !"_ZN5pages13solver_layout7formulaB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_288_29: %retptr"}
!43 = distinct !{!43, !"_ZN5pages13solver_layout7formulaB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_288_29"}
!44 = !{!45, !12, !14}
!45 = distinct !{!45, !46, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!46 = distinct !{!46, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!47 = !{!48, !12, !14}
!48 = distinct !{!48, !49, !"_ZN5pages13solver_layout7formulaB3v14B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!49 = distinct !{!49, !"_ZN5pages13solver_layout7formulaB3v14B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!50 = !{!51, !53, !12, !14}
!51 = distinct !{!51, !52, !"_ZN5pages8segments13begin_segmentB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!52 = distinct !{!52, !"_ZN5pages8segments13begin_segmentB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!53 = distinct !{!53, !52, !"_ZN5pages8segments13begin_segmentB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!54 = !{!55, !51, !53, !12, !14}
!55 = distinct !{!55, !56, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!56 = distinct !{!56, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!57 = !{!58, !60, !61, !63, !64, !66, !51, !53, !12, !14}
!58 = distinct !{!58, !59, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!59 = distinct !{!59, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!60 = distinct !{!60, !59, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!61 = distinct !{!61, !62, !"_ZN5pages8segments13first_outsideB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29: %retptr"}
!62 = distinct !{!62, !"_ZN5pages8segments13first_outsideB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29"}
!63 = distinct !{!63, !62, !"_ZN5pages8segments13first_outsideB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29: %excinfo"}
!64 = distinct !{!64, !65, !"_ZN5pages8segments12stop_outsideB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x23Literal_5bint_5d_280_29: %retptr"}
!65 = distinct !{!65, !"_ZN5pages8segments12stop_outsideB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x23Literal_5bint_5d_280_29"}
!66 = distinct !{!66, !65, !"_ZN5pages8segments12stop_outsideB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x23Literal_5bint_5d_280_29: %excinfo"}
!67 = !{!61, !63, !64, !66, !51, !53, !12, !14}
!68 = !{!69, !61, !63, !64, !66, !51, !53, !12, !14}
!69 = distinct !{!69, !70, !"_ZN5pages13solver_layout10derivativeB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2924Literal_5bint_5d_2814_29: %retptr"}
!70 = distinct !{!70, !"_ZN5pages13solver_layout10derivativeB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2924Literal_5bint_5d_2814_29"}
!71 = !{!72, !61, !63, !64, !66, !51, !53, !12, !14}
!72 = distinct !{!72, !73, !"_ZN5pages13solver_layout6decideB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_289_29: %retptr"}
!73 = distinct !{!73, !"_ZN5pages13solver_layout6decideB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_289_29"}
!74 = !{!75, !61, !63, !64, !66, !51, !53, !12, !14}
!75 = distinct !{!75, !76, !"_ZN5pages13solver_layout6decideB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29: %retptr"}
!76 = distinct !{!76, !"_ZN5pages13solver_layout6decideB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29"}
!77 = !{!64, !66, !51, !53, !12, !14}
!78 = !{!79, !64, !66, !51, !53, !12, !14}
!79 = distinct !{!79, !80, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!80 = distinct !{!80, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!81 = !{!82, !84, !51, !53, !12, !14}
!82 = distinct !{!82, !83, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!83 = distinct !{!83, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!84 = distinct !{!84, !83, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!85 = !{!86, !88, !90}
!86 = distinct !{!86, !87, !"_ZN5pages13solver_layout7formulaB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_285_29: %retptr"}
!87 = distinct !{!87, !"_ZN5pages13solver_layout7formulaB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_285_29"}
!88 = distinct !{!88, !89, !"_ZN5pages12time_stepper12attempt_stepB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!89 = distinct !{!89, !"_ZN5pages12time_stepper12attempt_stepB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!90 = distinct !{!90, !89, !"_ZN5pages12time_stepper12attempt_stepB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!91 = !{!92, !94, !95, !97}
!92 = distinct !{!92, !93, !"_ZN5pages12time_stepper11count_stepsB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!93 = distinct !{!93, !"_ZN5pages12time_stepper11count_stepsB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!94 = distinct !{!94, !93, !"_ZN5pages12time_stepper11count_stepsB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!95 = distinct !{!95, !96, !"_ZN5pages12time_stepper11check_lanesB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!96 = distinct !{!96, !"_ZN5pages12time_stepper11check_lanesB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!97 = distinct !{!97, !96, !"_ZN5pages12time_stepper11check_lanesB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!98 = !{!95, !97}
!99 = !{!100, !95, !97}
!100 = distinct !{!100, !101, !"_ZN5pages13solver_layout4failB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!101 = distinct !{!101, !"_ZN5pages13solver_layout4failB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!102 = !{!103, !105, !107}
!103 = distinct !{!103, !104, !"_ZN5pages13solver_layout10derivativeB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!104 = distinct !{!104, !"_ZN5pages13solver_layout10derivativeB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!105 = distinct !{!105, !106, !"_ZN5pages12time_stepper13handle_eventsB4v102B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb: %retptr"}
!106 = distinct !{!106, !"_ZN5pages12time_stepper13handle_eventsB4v102B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb"}
!107 = distinct !{!107, !106, !"_ZN5pages12time_stepper13handle_eventsB4v102B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb: %excinfo"}
!108 = !{!109, !105, !107}
!109 = distinct !{!109, !110, !"_ZN5pages13solver_layout7formulaB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2813_29: %retptr"}
!110 = distinct !{!110, !"_ZN5pages13solver_layout7formulaB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2813_29"}
!111 = !{!112, !105, !107}
!112 = distinct !{!112, !113, !"_ZN5pages13solver_layout7formulaB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2812_29: %retptr"}
!113 = distinct !{!113, !"_ZN5pages13solver_layout7formulaB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2812_29"}
!114 = !{!115, !117, !118, !120, !121, !123, !105, !107}
!115 = distinct !{!115, !116, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!116 = distinct !{!116, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!117 = distinct !{!117, !116, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!118 = distinct !{!118, !119, !"_ZN5pages12event_checks15evaluate_pointsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!119 = distinct !{!119, !"_ZN5pages12event_checks15evaluate_pointsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!120 = distinct !{!120, !119, !"_ZN5pages12event_checks15evaluate_pointsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!121 = distinct !{!121, !122, !"_ZN5pages12event_checks10comes_nearB3v50B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!122 = distinct !{!122, !"_ZN5pages12event_checks10comes_nearB3v50B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!123 = distinct !{!123, !122, !"_ZN5pages12event_checks10comes_nearB3v50B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!124 = !{!125, !127, !115, !117, !118, !120, !121, !123, !105, !107}
!125 = distinct !{!125, !126, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!126 = distinct !{!126, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!127 = distinct !{!127, !126, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!128 = !{!129, !118, !120, !121, !123, !105, !107}
!129 = distinct !{!129, !130, !"_ZN5pages13solver_layout6decideB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!130 = distinct !{!130, !"_ZN5pages13solver_layout6decideB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!131 = !{!"branch_weights", i32 99, i32 1}
!132 = !{!133, !135, !137, !105, !107}
!133 = distinct !{!133, !134, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!134 = distinct !{!134, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!135 = distinct !{!135, !136, !"_ZN5pages12time_stepper18interpolant_stagesB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!136 = distinct !{!136, !"_ZN5pages12time_stepper18interpolant_stagesB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!137 = distinct !{!137, !136, !"_ZN5pages12time_stepper18interpolant_stagesB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!138 = !{!139, !135, !137, !105, !107}
!139 = distinct !{!139, !140, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!140 = distinct !{!140, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!141 = !{!142, !135, !137, !105, !107}
!142 = distinct !{!142, !143, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!143 = distinct !{!143, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!144 = !{!145, !105, !107}
!145 = distinct !{!145, !146, !"_ZN5pages13solver_layout7formulaB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2811_29: %retptr"}
!146 = distinct !{!146, !"_ZN5pages13solver_layout7formulaB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2811_29"}
!147 = !{!148, !150, !105, !107}
!148 = distinct !{!148, !149, !"_ZN5pages12time_stepper17check_interpolantB3v59B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!149 = distinct !{!149, !"_ZN5pages12time_stepper17check_interpolantB3v59B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!150 = distinct !{!150, !149, !"_ZN5pages12time_stepper17check_interpolantB3v59B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!151 = !{!152, !148, !150, !105, !107}
!152 = distinct !{!152, !153, !"_ZN5pages13solver_layout5retryB3v60B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd: %retptr"}
!153 = distinct !{!153, !"_ZN5pages13solver_layout5retryB3v60B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd"}
!154 = !{!155, !157, !105, !107}
!155 = distinct !{!155, !156, !"_ZN5pages12event_checks12check_eventsB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!156 = distinct !{!156, !"_ZN5pages12event_checks12check_eventsB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!157 = distinct !{!157, !156, !"_ZN5pages12event_checks12check_eventsB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!158 = !{!159, !161, !162, !164, !155, !157, !105, !107}
!159 = distinct !{!159, !160, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!160 = distinct !{!160, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!161 = distinct !{!161, !160, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!162 = distinct !{!162, !163, !"_ZN5pages12event_checks15evaluate_pointsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!163 = distinct !{!163, !"_ZN5pages12event_checks15evaluate_pointsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!164 = distinct !{!164, !163, !"_ZN5pages12event_checks15evaluate_pointsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!165 = !{!166, !168, !159, !161, !162, !164, !155, !157, !105, !107}
!166 = distinct !{!166, !167, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!167 = distinct !{!167, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!168 = distinct !{!168, !167, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!169 = !{!170, !162, !164, !155, !157, !105, !107}
!170 = distinct !{!170, !171, !"_ZN5pages13solver_layout6decideB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!171 = distinct !{!171, !"_ZN5pages13solver_layout6decideB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!172 = !{!173, !175, !176, !178, !155, !157, !105, !107}
!173 = distinct !{!173, !174, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!174 = distinct !{!174, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!175 = distinct !{!175, !174, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!176 = distinct !{!176, !177, !"_ZN5pages12event_checks9set_edgesB3v62B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!177 = distinct !{!177, !"_ZN5pages12event_checks9set_edgesB3v62B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!178 = distinct !{!178, !177, !"_ZN5pages12event_checks9set_edgesB3v62B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!179 = !{!176, !178, !155, !157, !105, !107}
!180 = !{!181, !183, !105, !107}
!181 = distinct !{!181, !182, !"_ZN5pages14event_location13locate_eventsB3v70B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!182 = distinct !{!182, !"_ZN5pages14event_location13locate_eventsB3v70B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!183 = distinct !{!183, !182, !"_ZN5pages14event_location13locate_eventsB3v70B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!184 = !{!185, !187, !188, !181, !183, !105, !107}
!185 = distinct !{!185, !186, !"_ZN5pages14event_location10next_shareB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %retptr"}
!186 = distinct !{!186, !"_ZN5pages14event_location10next_shareB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx"}
!187 = distinct !{!187, !186, !"_ZN5pages14event_location10next_shareB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %excinfo"}
!188 = distinct !{!188, !189, !"_ZN5pages14event_location6narrowB3v71B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!189 = distinct !{!189, !"_ZN5pages14event_location6narrowB3v71B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!190 = !{!188, !181, !183, !105, !107}
!191 = !{!192, !194, !195, !197, !188, !181, !183, !105, !107}
!192 = distinct !{!192, !193, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!193 = distinct !{!193, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!194 = distinct !{!194, !193, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!195 = distinct !{!195, !196, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!196 = distinct !{!196, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!197 = distinct !{!197, !196, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!198 = !{!199, !201, !192, !194, !195, !197, !188, !181, !183, !105, !107}
!199 = distinct !{!199, !200, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!200 = distinct !{!200, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!201 = distinct !{!201, !200, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!202 = !{!203, !195, !197, !188, !181, !183, !105, !107}
!203 = distinct !{!203, !204, !"_ZN5pages13solver_layout6decideB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!204 = distinct !{!204, !"_ZN5pages13solver_layout6decideB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!205 = !{!195, !197, !188, !181, !183, !105, !107}
!206 = !{!207, !209, !188, !181, !183, !105, !107}
!207 = distinct !{!207, !208, !"_ZN5pages12event_checks14least_distanceB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!208 = distinct !{!208, !"_ZN5pages12event_checks14least_distanceB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!209 = distinct !{!209, !208, !"_ZN5pages12event_checks14least_distanceB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!210 = !{!211, !213, !181, !183, !105, !107}
!211 = distinct !{!211, !212, !"_ZN5pages14event_location9stops_runB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!212 = distinct !{!212, !"_ZN5pages14event_location9stops_runB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!213 = distinct !{!213, !212, !"_ZN5pages14event_location9stops_runB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!214 = !{!215, !217, !218, !220, !211, !213, !181, !183, !105, !107}
!215 = distinct !{!215, !216, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!216 = distinct !{!216, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!217 = distinct !{!217, !216, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!218 = distinct !{!218, !219, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!219 = distinct !{!219, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!220 = distinct !{!220, !219, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!221 = !{!222, !224, !215, !217, !218, !220, !211, !213, !181, !183, !105, !107}
!222 = distinct !{!222, !223, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!223 = distinct !{!223, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!224 = distinct !{!224, !223, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!225 = !{!226, !218, !220, !211, !213, !181, !183, !105, !107}
!226 = distinct !{!226, !227, !"_ZN5pages13solver_layout6decideB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!227 = distinct !{!227, !"_ZN5pages13solver_layout6decideB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!228 = !{!218, !220, !211, !213, !181, !183, !105, !107}
!229 = !{!230, !232, !233, !235, !236, !238, !211, !213, !181, !183, !105, !107}
!230 = distinct !{!230, !231, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!231 = distinct !{!231, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!232 = distinct !{!232, !231, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!233 = distinct !{!233, !234, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!234 = distinct !{!234, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!235 = distinct !{!235, !234, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!236 = distinct !{!236, !237, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!237 = distinct !{!237, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!238 = distinct !{!238, !237, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!239 = !{!233, !235, !236, !238, !211, !213, !181, !183, !105, !107}
!240 = !{!241, !236, !238, !211, !213, !181, !183, !105, !107}
!241 = distinct !{!241, !242, !"_ZN5pages13solver_layout6decideB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!242 = distinct !{!242, !"_ZN5pages13solver_layout6decideB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!243 = !{!236, !238, !211, !213, !181, !183, !105, !107}
!244 = !{!245, !247, !248, !211, !213, !181, !183, !105, !107}
!245 = distinct !{!245, !246, !"_ZN5pages14event_location10next_shareB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %retptr"}
!246 = distinct !{!246, !"_ZN5pages14event_location10next_shareB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx"}
!247 = distinct !{!247, !246, !"_ZN5pages14event_location10next_shareB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %excinfo"}
!248 = distinct !{!248, !249, !"_ZN5pages14event_location6narrowB3v71B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!249 = distinct !{!249, !"_ZN5pages14event_location6narrowB3v71B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!250 = !{!248, !211, !213, !181, !183, !105, !107}
!251 = !{!252, !254, !255, !257, !248, !211, !213, !181, !183, !105, !107}
!252 = distinct !{!252, !253, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!253 = distinct !{!253, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!254 = distinct !{!254, !253, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!255 = distinct !{!255, !256, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!256 = distinct !{!256, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!257 = distinct !{!257, !256, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!258 = !{!259, !261, !252, !254, !255, !257, !248, !211, !213, !181, !183, !105, !107}
!259 = distinct !{!259, !260, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!260 = distinct !{!260, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!261 = distinct !{!261, !260, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!262 = !{!263, !255, !257, !248, !211, !213, !181, !183, !105, !107}
!263 = distinct !{!263, !264, !"_ZN5pages13solver_layout6decideB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!264 = distinct !{!264, !"_ZN5pages13solver_layout6decideB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!265 = !{!255, !257, !248, !211, !213, !181, !183, !105, !107}
!266 = !{!267, !269, !248, !211, !213, !181, !183, !105, !107}
!267 = distinct !{!267, !268, !"_ZN5pages12event_checks14least_distanceB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!268 = distinct !{!268, !"_ZN5pages12event_checks14least_distanceB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!269 = distinct !{!269, !268, !"_ZN5pages12event_checks14least_distanceB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!270 = !{!271, !211, !213, !181, !183, !105, !107}
!271 = distinct !{!271, !272, !"_ZN5pages13solver_layout4failB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29: %retptr"}
!272 = distinct !{!272, !"_ZN5pages13solver_layout4failB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29"}
!273 = !{!274, !276, !211, !213, !181, !183, !105, !107}
!274 = distinct !{!274, !275, !"_ZN5pages12event_checks13first_crossedB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!275 = distinct !{!275, !"_ZN5pages12event_checks13first_crossedB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!276 = distinct !{!276, !275, !"_ZN5pages12event_checks13first_crossedB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!277 = !{!278, !280, !181, !183, !105, !107}
!278 = distinct !{!278, !279, !"_ZN5pages14event_location11pass_eventsB3v80B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!279 = distinct !{!279, !"_ZN5pages14event_location11pass_eventsB3v80B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!280 = distinct !{!280, !279, !"_ZN5pages14event_location11pass_eventsB3v80B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!281 = !{!282, !284, !285, !287, !278, !280, !181, !183, !105, !107}
!282 = distinct !{!282, !283, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!283 = distinct !{!283, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!284 = distinct !{!284, !283, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!285 = distinct !{!285, !286, !"_ZN5pages12event_checks15evaluate_pointsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!286 = distinct !{!286, !"_ZN5pages12event_checks15evaluate_pointsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!287 = distinct !{!287, !286, !"_ZN5pages12event_checks15evaluate_pointsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!288 = !{!289, !291, !282, !284, !285, !287, !278, !280, !181, !183, !105, !107}
!289 = distinct !{!289, !290, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!290 = distinct !{!290, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!291 = distinct !{!291, !290, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!292 = !{!293, !285, !287, !278, !280, !181, !183, !105, !107}
!293 = distinct !{!293, !294, !"_ZN5pages13solver_layout6decideB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!294 = distinct !{!294, !"_ZN5pages13solver_layout6decideB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!295 = !{!296, !278, !280, !181, !183, !105, !107}
!296 = distinct !{!296, !297, !"_ZN5pages13solver_layout10derivativeB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!297 = distinct !{!297, !"_ZN5pages13solver_layout10derivativeB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!298 = !{!299, !301, !302, !278, !280, !181, !183, !105, !107}
!299 = distinct !{!299, !300, !"_ZN5pages14event_location10next_shareB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %retptr"}
!300 = distinct !{!300, !"_ZN5pages14event_location10next_shareB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx"}
!301 = distinct !{!301, !300, !"_ZN5pages14event_location10next_shareB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %excinfo"}
!302 = distinct !{!302, !303, !"_ZN5pages14event_location6narrowB3v71B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!303 = distinct !{!303, !"_ZN5pages14event_location6narrowB3v71B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!304 = !{!302, !278, !280, !181, !183, !105, !107}
!305 = !{!306, !308, !309, !311, !302, !278, !280, !181, !183, !105, !107}
!306 = distinct !{!306, !307, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!307 = distinct !{!307, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!308 = distinct !{!308, !307, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!309 = distinct !{!309, !310, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!310 = distinct !{!310, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!311 = distinct !{!311, !310, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!312 = !{!313, !315, !306, !308, !309, !311, !302, !278, !280, !181, !183, !105, !107}
!313 = distinct !{!313, !314, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!314 = distinct !{!314, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!315 = distinct !{!315, !314, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!316 = !{!317, !309, !311, !302, !278, !280, !181, !183, !105, !107}
!317 = distinct !{!317, !318, !"_ZN5pages13solver_layout6decideB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!318 = distinct !{!318, !"_ZN5pages13solver_layout6decideB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!319 = !{!309, !311, !302, !278, !280, !181, !183, !105, !107}
!320 = !{!321, !323, !302, !278, !280, !181, !183, !105, !107}
!321 = distinct !{!321, !322, !"_ZN5pages12event_checks14least_distanceB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!322 = distinct !{!322, !"_ZN5pages12event_checks14least_distanceB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!323 = distinct !{!323, !322, !"_ZN5pages12event_checks14least_distanceB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!324 = !{!325, !327, !329, !278, !280, !181, !183, !105, !107}
!325 = distinct !{!325, !326, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!326 = distinct !{!326, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!327 = distinct !{!327, !328, !"_ZN5pages14event_location18exchange_decisionsB3v86B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %retptr"}
!328 = distinct !{!328, !"_ZN5pages14event_location18exchange_decisionsB3v86B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29"}
!329 = distinct !{!329, !328, !"_ZN5pages14event_location18exchange_decisionsB3v86B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %excinfo"}
!330 = !{!327, !329, !278, !280, !181, !183, !105, !107}
!331 = !{!332, !334, !278, !280, !181, !183, !105, !107}
!332 = distinct !{!332, !333, !"_ZN5pages14event_location12rates_changeB3v81B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!333 = distinct !{!333, !"_ZN5pages14event_location12rates_changeB3v81B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!334 = distinct !{!334, !333, !"_ZN5pages14event_location12rates_changeB3v81B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!335 = !{!336, !338, !339, !341, !332, !334, !278, !280, !181, !183, !105, !107}
!336 = distinct !{!336, !337, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!337 = distinct !{!337, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!338 = distinct !{!338, !337, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!339 = distinct !{!339, !340, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!340 = distinct !{!340, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!341 = distinct !{!341, !340, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!342 = !{!343, !345, !336, !338, !339, !341, !332, !334, !278, !280, !181, !183, !105, !107}
!343 = distinct !{!343, !344, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!344 = distinct !{!344, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!345 = distinct !{!345, !344, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!346 = !{!347, !339, !341, !332, !334, !278, !280, !181, !183, !105, !107}
!347 = distinct !{!347, !348, !"_ZN5pages13solver_layout6decideB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!348 = distinct !{!348, !"_ZN5pages13solver_layout6decideB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!349 = !{!339, !341, !332, !334, !278, !280, !181, !183, !105, !107}
!350 = !{!351, !353, !332, !334, !278, !280, !181, !183, !105, !107}
!351 = distinct !{!351, !352, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!352 = distinct !{!352, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!353 = distinct !{!353, !352, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!354 = !{!355, !357, !351, !353, !332, !334, !278, !280, !181, !183, !105, !107}
!355 = distinct !{!355, !356, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!356 = distinct !{!356, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!357 = distinct !{!357, !356, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!358 = !{!359, !361, !363, !332, !334, !278, !280, !181, !183, !105, !107}
!359 = distinct !{!359, !360, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!360 = distinct !{!360, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!361 = distinct !{!361, !362, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!362 = distinct !{!362, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!363 = distinct !{!363, !362, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!364 = !{!361, !363, !332, !334, !278, !280, !181, !183, !105, !107}
!365 = !{!366, !368, !370, !332, !334, !278, !280, !181, !183, !105, !107}
!366 = distinct !{!366, !367, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!367 = distinct !{!367, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!368 = distinct !{!368, !369, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!369 = distinct !{!369, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!370 = distinct !{!370, !369, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!371 = !{!368, !370, !332, !334, !278, !280, !181, !183, !105, !107}
!372 = !{!373, !332, !334, !278, !280, !181, !183, !105, !107}
!373 = distinct !{!373, !374, !"_ZN5pages13solver_layout10derivativeB3v82B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2814_29: %retptr"}
!374 = distinct !{!374, !"_ZN5pages13solver_layout10derivativeB3v82B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2814_29"}
!375 = !{!376, !378, !380, !332, !334, !278, !280, !181, !183, !105, !107}
!376 = distinct !{!376, !377, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!377 = distinct !{!377, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!378 = distinct !{!378, !379, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!379 = distinct !{!379, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!380 = distinct !{!380, !379, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!381 = !{!382, !332, !334, !278, !280, !181, !183, !105, !107}
!382 = distinct !{!382, !383, !"_ZN5pages13solver_layout10derivativeB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2815_29: %retptr"}
!383 = distinct !{!383, !"_ZN5pages13solver_layout10derivativeB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2815_29"}
!384 = !{!385, !387, !332, !334, !278, !280, !181, !183, !105, !107}
!385 = distinct !{!385, !386, !"_ZN5pages14event_location12rates_differB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!386 = distinct !{!386, !"_ZN5pages14event_location12rates_differB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!387 = distinct !{!387, !386, !"_ZN5pages14event_location12rates_differB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!388 = !{!378, !380, !332, !334, !278, !280, !181, !183, !105, !107}
!389 = !{!"branch_weights", i32 1, i32 99}
!390 = !{!"branch_weights", i32 101, i32 99}
!391 = !{!392, !394, !181, !183, !105, !107}
!392 = distinct !{!392, !393, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!393 = distinct !{!393, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!394 = distinct !{!394, !393, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!395 = !{!396, !398, !399, !401, !181, !183, !105, !107}
!396 = distinct !{!396, !397, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!397 = distinct !{!397, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!398 = distinct !{!398, !397, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!399 = distinct !{!399, !400, !"_ZN5pages14event_location8end_stepB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!400 = distinct !{!400, !"_ZN5pages14event_location8end_stepB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!401 = distinct !{!401, !400, !"_ZN5pages14event_location8end_stepB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!402 = !{!403, !405, !396, !398, !399, !401, !181, !183, !105, !107}
!403 = distinct !{!403, !404, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!404 = distinct !{!404, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!405 = distinct !{!405, !404, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!406 = !{!399, !401, !181, !183, !105, !107}
!407 = !{!408, !399, !401, !181, !183, !105, !107}
!408 = distinct !{!408, !409, !"_ZN5pages13solver_layout10derivativeB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!409 = distinct !{!409, !"_ZN5pages13solver_layout10derivativeB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!410 = !{!411, !399, !401, !181, !183, !105, !107}
!411 = distinct !{!411, !412, !"_ZN5pages13solver_layout6decideB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_288_29: %retptr"}
!412 = distinct !{!412, !"_ZN5pages13solver_layout6decideB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_288_29"}
!413 = !{!414, !181, !183, !105, !107}
!414 = distinct !{!414, !415, !"_ZN5pages13solver_layout5retryB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!415 = distinct !{!415, !"_ZN5pages13solver_layout5retryB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!416 = !{!121, !123, !105, !107}
!417 = !{!418, !420, !121, !123, !105, !107}
!418 = distinct !{!418, !419, !"_ZN5pages12event_checks13error_betweenB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!419 = distinct !{!419, !"_ZN5pages12event_checks13error_betweenB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!420 = distinct !{!420, !419, !"_ZN5pages12event_checks13error_betweenB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!421 = !{!422}
!422 = distinct !{!422, !423, !"_ZN5pages12time_stepper13write_samplesB3v89B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29b: %retptr"}
!423 = distinct !{!423, !"_ZN5pages12time_stepper13write_samplesB3v89B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29b"}
!424 = !{!425, !427, !422}
!425 = distinct !{!425, !426, !"_ZN5pages13solver_layout11interpolateB3v90B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd: %retptr"}
!426 = distinct !{!426, !"_ZN5pages13solver_layout11interpolateB3v90B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd"}
!427 = distinct !{!427, !426, !"_ZN5pages13solver_layout11interpolateB3v90B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd: %excinfo"}
!428 = !{!429}
!429 = distinct !{!429, !430, !"_ZN5pages13solver_layout7formulaB3v91B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %retptr"}
!430 = distinct !{!430, !"_ZN5pages13solver_layout7formulaB3v91B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29"}
!431 = !{!432, !434}
!432 = distinct !{!432, !433, !"_ZN5pages14event_location20restart_behind_eventB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!433 = distinct !{!433, !"_ZN5pages14event_location20restart_behind_eventB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!434 = distinct !{!434, !433, !"_ZN5pages14event_location20restart_behind_eventB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!435 = !{!436, !432, !434}
!436 = distinct !{!436, !437, !"_ZN5pages13solver_layout4failB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29: %retptr"}
!437 = distinct !{!437, !"_ZN5pages13solver_layout4failB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29"}
!438 = !{!439, !441}
!439 = distinct !{!439, !440, !"_ZN5pages8segments14at_segment_endB3v94B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!440 = distinct !{!440, !"_ZN5pages8segments14at_segment_endB3v94B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!441 = distinct !{!441, !442, !"_ZN5pages8segments11jump_statesB3v93B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!442 = distinct !{!442, !"_ZN5pages8segments11jump_statesB3v93B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!443 = !{!441}
!444 = !{!445, !447, !441}
!445 = distinct !{!445, !446, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!446 = distinct !{!446, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!447 = distinct !{!447, !446, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!448 = !{!449, !441}
!449 = distinct !{!449, !450, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!450 = distinct !{!450, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!451 = !{!452, !441}
!452 = distinct !{!452, !453, !"_ZN5pages8segments14at_segment_endB3v94B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!453 = distinct !{!453, !"_ZN5pages8segments14at_segment_endB3v94B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!454 = !{!455, !457, !441}
!455 = distinct !{!455, !456, !"_ZN5pages8segments11accept_jumpB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!456 = distinct !{!456, !"_ZN5pages8segments11accept_jumpB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!457 = distinct !{!457, !456, !"_ZN5pages8segments11accept_jumpB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!458 = !{!459, !455, !457, !441}
!459 = distinct !{!459, !460, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!460 = distinct !{!460, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!461 = !{!462, !464, !465, !467, !468, !470, !455, !457, !441}
!462 = distinct !{!462, !463, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!463 = distinct !{!463, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!464 = distinct !{!464, !463, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!465 = distinct !{!465, !466, !"_ZN5pages8segments13first_outsideB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2817_29: %retptr"}
!466 = distinct !{!466, !"_ZN5pages8segments13first_outsideB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2817_29"}
!467 = distinct !{!467, !466, !"_ZN5pages8segments13first_outsideB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2817_29: %excinfo"}
!468 = distinct !{!468, !469, !"_ZN5pages8segments12stop_outsideB3v96B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29: %retptr"}
!469 = distinct !{!469, !"_ZN5pages8segments12stop_outsideB3v96B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29"}
!470 = distinct !{!470, !469, !"_ZN5pages8segments12stop_outsideB3v96B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29: %excinfo"}
!471 = !{!465, !467, !468, !470, !455, !457, !441}
!472 = !{!473, !465, !467, !468, !470, !455, !457, !441}
!473 = distinct !{!473, !474, !"_ZN5pages13solver_layout10derivativeB3v98B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2814_29: %retptr"}
!474 = distinct !{!474, !"_ZN5pages13solver_layout10derivativeB3v98B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2814_29"}
!475 = !{!476, !465, !467, !468, !470, !455, !457, !441}
!476 = distinct !{!476, !477, !"_ZN5pages13solver_layout6decideB3v99B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_289_29: %retptr"}
!477 = distinct !{!477, !"_ZN5pages13solver_layout6decideB3v99B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_289_29"}
!478 = !{!479, !465, !467, !468, !470, !455, !457, !441}
!479 = distinct !{!479, !480, !"_ZN5pages13solver_layout6decideB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29: %retptr"}
!480 = distinct !{!480, !"_ZN5pages13solver_layout6decideB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29"}
!481 = !{!468, !470, !455, !457, !441}
!482 = !{!483, !468, !470, !455, !457, !441}
!483 = distinct !{!483, !484, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!484 = distinct !{!484, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!485 = !{!486, !488}
!486 = distinct !{!486, !487, !"_ZN5pages12time_stepper12end_segmentsB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!487 = distinct !{!487, !"_ZN5pages12time_stepper12end_segmentsB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!488 = distinct !{!488, !487, !"_ZN5pages12time_stepper12end_segmentsB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!489 = !{!490, !486, !488}
!490 = distinct !{!490, !491, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!491 = distinct !{!491, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!492 = !{!493, !495, !486, !488}
!493 = distinct !{!493, !494, !"_ZN5pages8segments13enter_segmentB4v101B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!494 = distinct !{!494, !"_ZN5pages8segments13enter_segmentB4v101B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!495 = distinct !{!495, !494, !"_ZN5pages8segments13enter_segmentB4v101B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!496 = !{!497, !499, !493, !495, !486, !488}
!497 = distinct !{!497, !498, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!498 = distinct !{!498, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!499 = distinct !{!499, !498, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!500 = !{!501, !486, !488}
!501 = distinct !{!501, !502, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!502 = distinct !{!502, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!503 = !{!504, !506, !501, !486, !488}
!504 = distinct !{!504, !505, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!505 = distinct !{!505, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!506 = distinct !{!506, !505, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!507 = !{!508, !510, !501, !486, !488}
!508 = distinct !{!508, !509, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!509 = distinct !{!509, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!510 = distinct !{!510, !509, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!511 = !{!512, !514, !486, !488}
!512 = distinct !{!512, !513, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!513 = distinct !{!513, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!514 = distinct !{!514, !513, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!515 = !{!516, !518}
!516 = distinct !{!516, !517, !"_ZN5pages12time_stepper11count_stepsB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!517 = distinct !{!517, !"_ZN5pages12time_stepper11count_stepsB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!518 = distinct !{!518, !517, !"_ZN5pages12time_stepper11count_stepsB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!519 = !{!520, !88, !90}
!520 = distinct !{!520, !521, !"_ZN5pages13solver_layout10derivativeB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_281_29: %retptr"}
!521 = distinct !{!521, !"_ZN5pages13solver_layout10derivativeB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_281_29"}
!522 = !{!523, !525, !88, !90}
!523 = distinct !{!523, !524, !"_ZN5pages8implicit13factor_matrixB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!524 = distinct !{!524, !"_ZN5pages8implicit13factor_matrixB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!525 = distinct !{!525, !524, !"_ZN5pages8implicit13factor_matrixB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!526 = !{!527, !529, !530, !523, !525, !88, !90}
!527 = distinct !{!527, !528, !"_ZN5pages8implicit11set_changesB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!528 = distinct !{!528, !"_ZN5pages8implicit11set_changesB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE"}
!529 = distinct !{!529, !528, !"_ZN5pages8implicit11set_changesB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!530 = distinct !{!530, !531, !"_ZN5pages8implicit13differentiateB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!531 = distinct !{!531, !"_ZN5pages8implicit13differentiateB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!532 = !{!530, !523, !525, !88, !90}
!533 = !{!534, !536, !530, !523, !525, !88, !90}
!534 = distinct !{!534, !535, !"_ZN5pages8implicit16difference_ratesB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!535 = distinct !{!535, !"_ZN5pages8implicit16difference_ratesB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!536 = distinct !{!536, !535, !"_ZN5pages8implicit16difference_ratesB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!537 = !{!538, !534, !536, !530, !523, !525, !88, !90}
!538 = distinct !{!538, !539, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!539 = distinct !{!539, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!540 = !{!541, !523, !525, !88, !90}
!541 = distinct !{!541, !542, !"_ZN5pages8implicit6factorB3v36B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!542 = distinct !{!542, !"_ZN5pages8implicit6factorB3v36B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!543 = !{!544, !546, !547, !88, !90}
!544 = distinct !{!544, !545, !"_ZN5pages8implicit5solveB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!545 = distinct !{!545, !"_ZN5pages8implicit5solveB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!546 = distinct !{!546, !545, !"_ZN5pages8implicit5solveB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!547 = distinct !{!547, !548, !"_ZN5pages8implicit11solve_stageB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!548 = distinct !{!548, !"_ZN5pages8implicit11solve_stageB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!549 = !{!547, !88, !90}
!550 = !{!551, !88, !90}
!551 = distinct !{!551, !552, !"_ZN5pages13solver_layout7formulaB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_286_29: %retptr"}
!552 = distinct !{!552, !"_ZN5pages13solver_layout7formulaB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_286_29"}
!553 = !{!554, !88, !90}
!554 = distinct !{!554, !555, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!555 = distinct !{!555, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!556 = !{!557, !88, !90}
!557 = distinct !{!557, !558, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!558 = distinct !{!558, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!559 = !{!560, !562}
!560 = distinct !{!560, !561, !"_ZN5pages12event_checks13first_crossedB3v64B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!561 = distinct !{!561, !"_ZN5pages12event_checks13first_crossedB3v64B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!562 = distinct !{!562, !561, !"_ZN5pages12event_checks13first_crossedB3v64B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!563 = !{!564, !566, !567, !569}
!564 = distinct !{!564, !565, !"_ZN5pages12event_checks13error_betweenB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!565 = distinct !{!565, !"_ZN5pages12event_checks13error_betweenB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!566 = distinct !{!566, !565, !"_ZN5pages12event_checks13error_betweenB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!567 = distinct !{!567, !568, !"_ZN5pages12event_checks8may_hideB3v67B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd: %retptr"}
!568 = distinct !{!568, !"_ZN5pages12event_checks8may_hideB3v67B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd"}
!569 = distinct !{!569, !568, !"_ZN5pages12event_checks8may_hideB3v67B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd: %excinfo"}
!570 = !{!567, !569}
!571 = !{!572, !574, !567, !569}
!572 = distinct !{!572, !573, !"_ZN5pages12event_checks17least_distance_ofB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd: %retptr"}
!573 = distinct !{!573, !"_ZN5pages12event_checks17least_distance_ofB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd"}
!574 = distinct !{!574, !573, !"_ZN5pages12event_checks17least_distance_ofB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd: %excinfo"}
!575 = !{!576}
!576 = distinct !{!576, !577, !"_ZN5pages13solver_layout5retryB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!577 = distinct !{!577, !"_ZN5pages13solver_layout5retryB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!578 = !{!579, !581}
!579 = distinct !{!579, !580, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!580 = distinct !{!580, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!581 = distinct !{!581, !580, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!582 = !{!583, !585}
!583 = distinct !{!583, !584, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!584 = distinct !{!584, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!585 = distinct !{!585, !584, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!586 = !{!587, !589}
!587 = distinct !{!587, !588, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!588 = distinct !{!588, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!589 = distinct !{!589, !588, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}

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
  %v480 = load i64, ptr %v479
  %v481 = getelementptr i64, ptr %v0, i64 239
  %v482 = load i64, ptr %v481
  %v483 = getelementptr i64, ptr %v0, i64 240
  %v484 = load ptr, ptr %v483
  %v485 = getelementptr i64, ptr %v0, i64 241
  %v486 = load ptr, ptr %v485
  %v487 = getelementptr i64, ptr %v0, i64 242
  %v488 = load i64, ptr %v487
  %v489 = getelementptr i64, ptr %v0, i64 243
  %v490 = load i64, ptr %v489
  %v491 = getelementptr i64, ptr %v0, i64 244
  %v492 = load ptr, ptr %v491
  %v493 = getelementptr i64, ptr %v0, i64 245
  %v494 = load i64, ptr %v493
  %v495 = getelementptr i64, ptr %v0, i64 246
  %v496 = load i64, ptr %v495
  %v497 = getelementptr i64, ptr %v0, i64 247
  %v498 = load ptr, ptr %v497
  %v499 = getelementptr i64, ptr %v0, i64 248
  %v500 = load ptr, ptr %v499
  %v501 = getelementptr i64, ptr %v0, i64 249
  %v502 = load i64, ptr %v501
  %v503 = getelementptr i64, ptr %v0, i64 250
  %v504 = load i64, ptr %v503
  %v505 = getelementptr i64, ptr %v0, i64 251
  %v506 = load ptr, ptr %v505
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
  %v568 = load i64, ptr %v567
  %v569 = getelementptr i64, ptr %v0, i64 283
  %v570 = load i64, ptr %v569
  %v571 = call i32 @advance_of_many(ptr %v1, ptr %v2, ptr %v4, ptr %v6, i64 %v8, i64 %v10, ptr %v12, i64 %v14, i64 %v16, i64 %v18, i64 %v20, i64 %v22, i64 %v24, i64 %v26, i64 %v28, i64 %v30, i64 %v32, i64 %v34, i64 %v36, i64 %v38, ptr %v40, ptr %v42, i64 %v44, i64 %v46, ptr %v48, i64 %v50, i64 %v52, ptr %v54, ptr %v56, i64 %v58, i64 %v60, ptr %v62, i64 %v64, i64 %v66, i64 %v68, i64 %v70, ptr %v72, ptr %v74, i64 %v76, i64 %v78, ptr %v80, i64 %v82, i64 %v84, i64 %v86, i64 %v88, ptr %v90, ptr %v92, i64 %v94, i64 %v96, ptr %v98, i64 %v100, i64 %v102, ptr %v104, ptr %v106, i64 %v108, i64 %v110, ptr %v112, i64 %v114, i64 %v116, ptr %v118, ptr %v120, i64 %v122, i64 %v124, ptr %v126, i64 %v128, i64 %v130, ptr %v132, ptr %v134, i64 %v136, i64 %v138, ptr %v140, i64 %v142, i64 %v144, ptr %v146, ptr %v148, i64 %v150, i64 %v152, ptr %v154, i64 %v156, i64 %v158, i64 %v160, i64 %v162, ptr %v164, ptr %v166, i64 %v168, i64 %v170, ptr %v172, i64 %v174, i64 %v176, ptr %v178, ptr %v180, i64 %v182, i64 %v184, ptr %v186, i64 %v188, i64 %v190, ptr %v192, ptr %v194, i64 %v196, i64 %v198, ptr %v200, i64 %v202, i64 %v204, i64 %v206, i64 %v208, i64 %v210, i64 %v212, ptr %v214, ptr %v216, i64 %v218, i64 %v220, ptr %v222, i64 %v224, i64 %v226, ptr %v228, ptr %v230, i64 %v232, i64 %v234, ptr %v236, i64 %v238, i64 %v240, ptr %v242, ptr %v244, i64 %v246, i64 %v248, ptr %v250, i64 %v252, i64 %v254, i64 %v256, i64 %v258, ptr %v260, ptr %v262, i64 %v264, i64 %v266, ptr %v268, i64 %v270, i64 %v272, i64 %v274, i64 %v276, ptr %v278, ptr %v280, i64 %v282, i64 %v284, ptr %v286, i64 %v288, i64 %v290, i64 %v292, i64 %v294, ptr %v296, ptr %v298, i64 %v300, i64 %v302, ptr %v304, i64 %v306, i64 %v308, ptr %v310, ptr %v312, i64 %v314, i64 %v316, ptr %v318, i64 %v320, i64 %v322, ptr %v324, ptr %v326, i64 %v328, i64 %v330, ptr %v332, i64 %v334, i64 %v336, ptr %v338, ptr %v340, i64 %v342, i64 %v344, ptr %v346, i64 %v348, i64 %v350, ptr %v352, ptr %v354, i64 %v356, i64 %v358, ptr %v360, i64 %v362, i64 %v364, ptr %v366, ptr %v368, i64 %v370, i64 %v372, ptr %v374, i64 %v376, i64 %v378, ptr %v380, ptr %v382, i64 %v384, i64 %v386, ptr %v388, i64 %v390, i64 %v392, i64 %v394, i64 %v396, i64 %v398, i64 %v400, ptr %v402, ptr %v404, i64 %v406, i64 %v408, ptr %v410, i64 %v412, i64 %v414, i64 %v416, i64 %v418, i64 %v420, i64 %v422, ptr %v424, ptr %v426, i64 %v428, i64 %v430, ptr %v432, i64 %v434, i64 %v436, ptr %v438, ptr %v440, i64 %v442, i64 %v444, ptr %v446, i64 %v448, i64 %v450, ptr %v452, ptr %v454, i64 %v456, i64 %v458, ptr %v460, i64 %v462, i64 %v464, ptr %v466, ptr %v468, i64 %v470, i64 %v472, ptr %v474, i64 %v476, i64 %v478, i64 %v480, i64 %v482, ptr %v484, ptr %v486, i64 %v488, i64 %v490, ptr %v492, i64 %v494, i64 %v496, ptr %v498, ptr %v500, i64 %v502, i64 %v504, ptr %v506, i64 %v508, i64 %v510, ptr %v512, ptr %v514, i64 %v516, i64 %v518, ptr %v520, i64 %v522, i64 %v524, ptr %v526, ptr %v528, i64 %v530, i64 %v532, ptr %v534, i64 %v536, i64 %v538, ptr %v540, ptr %v542, i64 %v544, i64 %v546, ptr %v548, i64 %v550, i64 %v552, ptr %v554, ptr %v556, i64 %v558, i64 %v560, ptr %v562, i64 %v564, i64 %v566, i64 %v568, i64 %v570)
  %v572 = load i64, ptr %v1
  ret i64 %v572
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

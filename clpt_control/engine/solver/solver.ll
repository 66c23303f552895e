; sha256 b3b1f2e848c2d211fb50d2cf333a0cdab5a7a125c5bdaa33f8aefc765d69b17b 4976746b3152dfc16fce72d36c3ff81d8eb20e1cf51a5ecb29a4de4ae4606cdc, Python 3.11, numba 0.68.1

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
  %v832 = shl i64 %v145, 4
  %v833 = getelementptr i8, ptr %v143, i64 %v832
  %v834 = mul i64 %v136, 224
  %v835 = getelementptr i8, ptr %v134, i64 %v834
  %v836 = mul i64 %v103, %v102
  %v837 = mul i64 %v738, 136
  %v838 = getelementptr i8, ptr %v194, i64 %v837
  %v839 = add i64 %v94, -1
  %v840 = shl i64 %v145, 5
  %v841 = getelementptr i8, ptr %v143, i64 %v840
  %v842 = mul i64 %v136, 40
  %v843 = getelementptr i8, ptr %v134, i64 %v842
  %v844 = mul i64 %v136, 96
  %v845 = getelementptr i8, ptr %v134, i64 %v844
  %v846 = mul i64 %v136, 216
  %v847 = getelementptr i8, ptr %v134, i64 %v846
  %v848 = mul i64 %v136, 40
  %v849 = getelementptr i8, ptr %v134, i64 %v848
  %v850 = shl i64 %v136, 5
  %v851 = getelementptr i8, ptr %v134, i64 %v850
  %v852 = getelementptr double, ptr %v134, i64 %v136
  %v853 = mul i64 %v738, 136
  %v854 = getelementptr i8, ptr %v194, i64 %v853
  %v855 = mul nsw i64 %v10, %v9
  %v856 = mul i64 %v855, 136
  %v857 = getelementptr i8, ptr %v159, i64 %v856
  %v858 = mul i64 %v855, 104
  %v859 = getelementptr i8, ptr %v159, i64 %v858
  %v860 = mul i64 %v10, 136
  %v861 = getelementptr i8, ptr %v159, i64 %v860
  %v862 = mul i64 %v208, 192
  %v863 = getelementptr i8, ptr %v187, i64 %v862
  %v864 = mul i64 %v197, %v196
  %v865 = mul i64 %v136, 40
  %v866 = getelementptr i8, ptr %v134, i64 %v865
  %v867 = mul i64 %v136, 56
  %v868 = getelementptr i8, ptr %v134, i64 %v867
  %v869 = shl i64 %v145, 4
  %v870 = getelementptr i8, ptr %v143, i64 %v869
  %v871 = mul i64 %v136, 48
  %v872 = getelementptr i8, ptr %v134, i64 %v871
  %v873 = mul i64 %v864, 136
  %v874 = icmp slt i64 %v10, 1
  %v875 = mul i64 %v136, 224
  %v876 = getelementptr i8, ptr %v134, i64 %v875
  %v877 = mul i64 %v103, %v102
  %v878 = getelementptr i8, ptr %v194, i64 %v873
  %v879 = add i64 %v94, -1
  %v880 = mul i64 %v864, 192
  %v881 = mul i64 %v864, 184
  %v882 = mul i64 %v864, 176
  %v883 = mul i64 %v864, 168
  %v884 = mul i64 %v864, 160
  %v885 = mul i64 %v864, 152
  %v886 = mul i64 %v864, 144
  %v887 = icmp sgt i64 %v9, 1
  %v888 = mul i64 %v136, 40
  %v889 = getelementptr i8, ptr %v134, i64 %v888
  %v890 = getelementptr i8, ptr %v6, i64 80
  %v891 = mul i64 %v136, 40
  %v892 = getelementptr i8, ptr %v134, i64 %v891
  %v893 = shl i64 %v488, 6
  %v894 = icmp sgt i64 %v19, 0
  %v895 = getelementptr i8, ptr %v205, i64 %v893
  %v896 = mul i64 %v136, 96
  %v897 = getelementptr i8, ptr %v134, i64 %v896
  %v898 = mul i64 %v136, 120
  %v899 = getelementptr i8, ptr %v134, i64 %v898
  %v900 = icmp slt i64 %v10, 1
  %v901 = getelementptr i8, ptr %v24, i64 8
  %v902 = getelementptr double, ptr %v93, i64 %v94
  %v903 = getelementptr i8, ptr %v902, i64 -8
  %v904 = mul i64 %v145, 24
  %v905 = getelementptr i8, ptr %v143, i64 %v904
  %v906 = mul i64 %v145, 24
  %v907 = getelementptr i8, ptr %v143, i64 %v906
  %v908 = mul i64 %v136, 24
  %v909 = getelementptr i8, ptr %v134, i64 %v908
  %v910 = icmp ne i64 %v17, 0
  %v911 = tail call i64 @llvm.smax.i64(i64 %v9, i64 0)
  %v912 = mul i64 %v136, 40
  %v913 = getelementptr i8, ptr %v134, i64 %v912
  %v914 = shl i64 %v136, 4
  %v915 = getelementptr i8, ptr %v134, i64 %v914
  %v916 = getelementptr i64, ptr %v143, i64 %v145
  %v917 = icmp slt i64 %v64, 1
  %v918 = getelementptr i8, ptr %v6, i64 8
  %v919 = mul nsw i64 %v10, %v9
  %v920 = getelementptr i8, ptr %v6, i64 24
  %v921 = mul i64 %v919, 136
  %v922 = getelementptr i8, ptr %v159, i64 %v921
  %v923 = mul i64 %v103, %v102
  %v924 = add nsw i64 %v911, -1
  %v925 = mul i64 %v197, %v196
  %v926 = shl i64 %v145, 4
  %v927 = getelementptr i8, ptr %v143, i64 %v926
  %v928 = mul i64 %v925, 136
  %v929 = icmp slt i64 %v10, 1
  %v930 = getelementptr i8, ptr %v194, i64 %v928
  %v931 = getelementptr double, ptr %v93, i64 %v94
  %v932 = getelementptr i8, ptr %v931, i64 -8
  %v933 = shl i64 %v136, 6
  %v934 = getelementptr i8, ptr %v134, i64 %v933
  %v935 = mul i64 %v919, 112
  %v936 = getelementptr i8, ptr %v159, i64 %v935
  %v937 = mul i64 %v925, 112
  %v938 = getelementptr i8, ptr %v194, i64 %v937
  %v939 = shl i64 %v925, 7
  %v940 = getelementptr i8, ptr %v194, i64 %v939
  %v941 = getelementptr i8, ptr %v6, i64 32
  %v942 = mul i64 %v10, 136
  %v943 = getelementptr i8, ptr %v159, i64 %v942
  %v944 = mul i64 %v208, 216
  %v945 = getelementptr i8, ptr %v187, i64 %v944
  %v946 = shl i64 %v10, 7
  %v947 = getelementptr i8, ptr %v159, i64 %v946
  %v948 = mul i64 %v208, 240
  %v949 = getelementptr i8, ptr %v187, i64 %v948
  %v950 = sub i64 %v208, %v19
  %v951 = tail call i64 @llvm.smax.i64(i64 %v950, i64 0)
  %v952 = getelementptr double, ptr %v205, i64 %v208
  %v953 = mul i64 %v208, %v207
  %v954 = mul i64 %v953, 80
  %v955 = getelementptr i8, ptr %v952, i64 %v954
  %v956 = mul i64 %v953, 72
  %v957 = getelementptr i8, ptr %v205, i64 %v956
  %v958 = getelementptr double, ptr %v957, i64 %v208
  %v959 = shl i64 %v208, 4
  %v960 = getelementptr i8, ptr %v957, i64 %v959
  %v961 = shl i64 %v145, 5
  %v962 = getelementptr i8, ptr %v143, i64 %v961
  %v963 = mul i64 %v136, 112
  %v964 = getelementptr i8, ptr %v134, i64 %v963
  %v965 = mul i64 %v136, 40
  %v966 = getelementptr i8, ptr %v134, i64 %v965
  %v967 = shl i64 %v136, 4
  %v968 = getelementptr i8, ptr %v134, i64 %v967
  %v969 = getelementptr i64, ptr %v143, i64 %v145
  %v970 = mul i64 %v136, 24
  %v971 = getelementptr i8, ptr %v134, i64 %v970
  %v972 = mul i64 %v136, 24
  %v973 = getelementptr i8, ptr %v134, i64 %v972
  %v974 = icmp slt i64 %v64, 1
  %v975 = shl i64 %v145, 4
  %v976 = getelementptr i8, ptr %v143, i64 %v975
  %v977 = mul i64 %v136, 24
  %v978 = getelementptr i8, ptr %v134, i64 %v977
  %v979 = getelementptr i8, ptr %v152, i64 8
  %v980 = getelementptr i64, ptr %v143, i64 %v145
  %v981 = mul i64 %v145, 24
  %v982 = getelementptr i8, ptr %v143, i64 %v981
  %v983 = icmp slt i64 %v42, 1
  %v984 = icmp slt i64 %v64, 1
  %v985 = icmp slt i64 %v10, 1
  %v986 = mul i64 %v136, 248
  %v987 = getelementptr i8, ptr %v134, i64 %v986
  %v988 = mul i64 %v136, 240
  %v989 = getelementptr i8, ptr %v134, i64 %v988
  %v990 = mul i64 %v136, 232
  %v991 = getelementptr i8, ptr %v134, i64 %v990
  %v992 = shl i64 %v136, 4
  %v993 = shl i64 %v136, 5
  %v994 = mul i64 %v136, 48
  %v995 = mul i64 %v136, 56
  %v996 = shl i64 %v136, 6
  %v997 = mul i64 %v136, 72
  %v998 = mul i64 %v136, 80
  %v999 = mul i64 %v136, 88
  %v1000 = mul i64 %v136, 96
  %v1001 = mul i64 %v136, 104
  %v1002 = mul i64 %v136, 112
  %v1003 = mul i64 %v136, 120
  %v1004 = shl i64 %v136, 7
  %v1005 = mul i64 %v136, 136
  %v1006 = mul i64 %v136, 144
  %v1007 = mul i64 %v136, 152
  %v1008 = mul i64 %v136, 160
  %v1009 = mul i64 %v136, 168
  %v1010 = mul i64 %v136, 176
  %v1011 = mul i64 %v136, 184
  %v1012 = mul i64 %v136, 192
  %v1013 = mul i64 %v136, 200
  %v1014 = mul i64 %v136, 208
  %v1015 = mul i64 %v136, 216
  %v1016 = mul i64 %v136, 224
  %v1017 = getelementptr i8, ptr %v134, i64 %v1003
  %v1018 = getelementptr i8, ptr %v134, i64 %v1016
  %v1019 = getelementptr i8, ptr %v134, i64 %v992
  %v1020 = mul i64 %v136, 232
  %v1021 = getelementptr i8, ptr %v134, i64 %v1020
  %v1022 = getelementptr double, ptr %v93, i64 %v94
  %v1023 = getelementptr i8, ptr %v1022, i64 -8
  %v1024 = getelementptr double, ptr %v134, i64 %v136
  %v1025 = mul i64 %v136, 232
  %v1026 = getelementptr i8, ptr %v134, i64 %v1025
  %v1027 = mul i64 %v136, 176
  %v1028 = getelementptr i8, ptr %v134, i64 %v1027
  %v1029 = shl i64 %v136, 4
  %v1030 = getelementptr i8, ptr %v134, i64 %v1029
  %v1031 = mul i64 %v136, 168
  %v1032 = getelementptr i8, ptr %v134, i64 %v1031
  %v1033 = shl i64 %v145, 4
  %v1034 = getelementptr i8, ptr %v143, i64 %v1033
  %v1035 = shl i64 %v703, 4
  %v1036 = mul i64 %v703, 24
  %v1037 = shl i64 %v703, 5
  %v1038 = mul i64 %v703, 40
  %v1039 = mul i64 %v703, 48
  %v1040 = mul i64 %v703, 56
  %v1041 = shl i64 %v703, 6
  %v1042 = shl i64 %v705, 4
  %v1043 = shl i64 %v705, 5
  %v1044 = mul i64 %v705, 48
  %v1045 = shl i64 %v705, 6
  %v1046 = mul i64 %v705, 24
  %v1047 = shl i64 %v705, 4
  %v1048 = shl i64 %v705, 5
  %v1049 = mul i64 %v705, 48
  %v1050 = shl i64 %v705, 6
  %v1051 = mul i64 %v705, 40
  %v1052 = shl i64 %v705, 4
  %v1053 = shl i64 %v705, 5
  %v1054 = mul i64 %v705, 48
  %v1055 = shl i64 %v705, 6
  %v1056 = mul i64 %v705, 56
  %v1057 = shl i64 %v705, 4
  %v1058 = shl i64 %v705, 5
  %v1059 = mul i64 %v705, 48
  %v1060 = shl i64 %v705, 6
  br label %v1061

v1061:
  %v1062 = phi i64 [ %v1063, %v1064 ], [ %v284, %v483 ]
  %v1065 = phi i64 [ %v1066, %v1064 ], [ %v479, %v483 ]
  %v1067 = add nsw i64 %v1062, -1
  %v1068 = load i64, ptr %v485, align 8, !noalias !11
  %v1069 = icmp eq i64 %v1068, 0
  br i1 %v1069, label %v1070, label %v1071

v1071:
  %v1072 = icmp eq i64 %v1068, 2
  store i64 0, ptr %v485, align 8, !noalias !11
  %v1073 = load i64, ptr %v489, align 8, !noalias !15
  %v1074 = inttoptr i64 %v1073 to ptr
  tail call void %v1074(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !15
  br i1 %v292, label %v1075, label %v1076

v1075:
  %v1077 = load i64, ptr %v490, align 8, !noalias !18
  %v1078 = inttoptr i64 %v1077 to ptr
  tail call void %v1078(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !18
  %v1079 = load double, ptr %v492, align 8, !noalias !24
  %v1080 = fcmp une double %v1079, 2.500000e-01
  br i1 %v1080, label %v1076, label %v1081

v1081:
  store double 0.000000e+00, ptr %v492, align 8, !noalias !24
  br i1 %v493, label %v1082, label %v1083

v1084:
  store double 1.000000e+00, ptr %v492, align 8, !noalias !24
  br label %v1085

v1085:
  %v1086 = icmp eq i64 %v1087, %v19
  br i1 %v1086, label %v1083, label %v1082

v1083:
  %v1088 = load double, ptr %v492, align 8, !noalias !24
  %v1089 = fcmp ogt double %v1088, 5.000000e-01
  %v1090 = or i1 %v1072, %v1089
  br label %v1076

v1082:
  %v1091 = phi i64 [ %v1087, %v1085 ], [ 0, %v1081 ]
  %v1087 = add nsw i64 %v1091, 1
  %v1092 = getelementptr double, ptr %v205, i64 %v1091
  %v1093 = load double, ptr %v1092, align 8, !noalias !24
  %v1094 = add nsw i64 %v1091, %v18
  %v1095 = icmp slt i64 %v1094, 0
  %v1096 = select i1 %v1095, i64 %v167, i64 0
  %v1097 = getelementptr double, ptr %v166, i64 %v1094
  %v1098 = getelementptr double, ptr %v1097, i64 %v1096
  %v1099 = load double, ptr %v1098, align 8, !noalias !24
  %v1100 = fcmp une double %v1093, %v1099
  br i1 %v1100, label %v1084, label %v1085

v1076:
  %v1101 = phi i1 [ %v1072, %v1071 ], [ %v1090, %v1083 ], [ %v1072, %v1075 ]
  br i1 %v1101, label %v1102, label %v1070

v1102:
  br i1 %v292, label %v1103, label %v1104

v1103:
  %v1105 = load i64, ptr %v494, align 8, !noalias !25
  %v1106 = inttoptr i64 %v1105 to ptr
  tail call void %v1106(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !25
  %v1107 = load double, ptr %v496, align 8, !noalias !31
  %v1108 = fcmp ule double %v1107, 5.000000e-01
  %v1109 = select i1 %v1108, i1 true, i1 %v497
  br i1 %v1109, label %v1110, label %v1111

v1110:
  %v1112 = load i64, ptr %v489, align 8, !noalias !32
  %v1113 = inttoptr i64 %v1112 to ptr
  tail call void %v1113(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !32
  br label %v1104

v1111:
  %v1114 = phi i64 [ %v1115, %v1111 ], [ 0, %v1103 ]
  %v1115 = add nsw i64 %v1114, 1
  %v1116 = getelementptr double, ptr %v205, i64 %v1114
  %v1117 = load double, ptr %v1116, align 8, !noalias !31
  %v1118 = add nsw i64 %v1114, %v18
  %v1119 = icmp slt i64 %v1118, 0
  %v1120 = select i1 %v1119, i64 %v167, i64 0
  %v1121 = getelementptr double, ptr %v166, i64 %v1118
  %v1122 = getelementptr double, ptr %v1121, i64 %v1120
  store double %v1117, ptr %v1122, align 8, !noalias !31
  %v1123 = icmp eq i64 %v1115, %v19
  br i1 %v1123, label %v1110, label %v1111

v1104:
  br i1 %v498, label %v1124, label %v1125

v1124:
  %v1126 = load i64, ptr %v6, align 8, !noalias !35
  %v1127 = inttoptr i64 %v1126 to ptr
  tail call void %v1127(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v501), !noalias !35
  %v1128 = load i64, ptr %v502, align 8, !noalias !38
  %v1129 = inttoptr i64 %v1128 to ptr
  tail call void %v1129(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !38
  %v1130 = load i64, ptr %v503, align 8, !noalias !41
  %v1131 = inttoptr i64 %v1130 to ptr
  tail call void %v1131(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !41
  %v1132 = load i64, ptr %v6, align 8, !noalias !44
  %v1133 = inttoptr i64 %v1132 to ptr
  tail call void %v1133(ptr %v505, ptr %v507, ptr %v166, ptr %v173, ptr %v180, ptr %v509), !noalias !44
  %v1134 = load i64, ptr %v510, align 8, !noalias !47
  %v1135 = inttoptr i64 %v1134 to ptr
  tail call void %v1135(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !47
  br label %v1125

v1125:
  br i1 %v294, label %v1070, label %v1136

v1137:
  store double 0.000000e+00, ptr %v1138, align 8, !noalias !50
  %v1139 = getelementptr double, ptr %v515, i64 %v1140
  store double 0.000000e+00, ptr %v1139, align 8, !noalias !50
  %v1141 = getelementptr double, ptr %v517, i64 %v1140
  store double 0.000000e+00, ptr %v1141, align 8, !noalias !50
  %v1142 = getelementptr i64, ptr %v143, i64 %v1140
  %v1143 = load i64, ptr %v1142, align 8, !noalias !50
  %v1144 = icmp slt i64 %v1143, 0
  %v1145 = select i1 %v1144, i64 %v126, i64 0
  %v1146 = add i64 %v1145, %v1143
  %v1147 = mul i64 %v1146, %v127
  %v1148 = getelementptr i64, ptr %v125, i64 %v1147
  %v1149 = getelementptr i8, ptr %v1148, i64 8
  %v1150 = load i64, ptr %v1149, align 8, !noalias !50
  %v1151 = add nsw i64 %v1150, %v518
  store i64 %v1151, ptr %v1149, align 8, !noalias !50
  %v1152 = load i64, ptr %v1142, align 8, !noalias !50
  %v1153 = icmp slt i64 %v1152, 0
  %v1154 = select i1 %v1153, i64 %v126, i64 0
  %v1155 = add i64 %v1154, %v1152
  %v1156 = mul i64 %v1155, %v127
  %v1157 = getelementptr i64, ptr %v125, i64 %v1156
  %v1158 = getelementptr i8, ptr %v1157, i64 16
  %v1159 = load i64, ptr %v1158, align 8, !noalias !50
  %v1160 = add nsw i64 %v1159, %v520
  store i64 %v1160, ptr %v1158, align 8, !noalias !50
  %v1161 = getelementptr double, ptr %v522, i64 %v1140
  %v1162 = load double, ptr %v1161, align 8, !noalias !50
  %v1163 = fcmp une double %v1162, 0.000000e+00
  br i1 %v1163, label %v1164, label %v1165

v1164:
  %v1166 = load i64, ptr %v1142, align 8, !noalias !54
  %v1167 = icmp sgt i64 %v1166, -1
  br i1 %v1167, label %v1168, label %v1165

v1168:
  %v1169 = getelementptr i64, ptr %v111, i64 %v1166
  %v1170 = load i64, ptr %v1169, align 8, !noalias !54
  %v1171 = icmp eq i64 %v1170, 0
  br i1 %v1171, label %v1172, label %v1165

v1172:
  store i64 3, ptr %v1169, align 8, !noalias !54
  br label %v1165

v1165:
  br i1 %v291, label %v1173, label %v1174

v1173:
  %v1175 = load double, ptr %v524, align 8, !noalias !57
  %v1176 = load double, ptr %v93, align 8, !noalias !57
  %v1177 = fsub double %v1175, %v1176
  %v1178 = fmul double %v1177, 1.000000e-13
  %v1179 = load double, ptr %v134, align 8, !noalias !57
  %v1180 = tail call double @llvm.fabs.f64(double %v1179)
  %v1181 = fmul double %v1180, 4.000000e-15
  %v1182 = fcmp ogt double %v1181, %v1178
  %v1183 = select i1 %v1182, double %v1181, double %v1178
  %v1184 = fadd double %v1179, %v1183
  store double %v1184, ptr %v526, align 8, !noalias !67
  %v1185 = load i64, ptr %v6, align 8, !noalias !68
  %v1186 = inttoptr i64 %v1185 to ptr
  tail call void %v1186(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v527), !noalias !68
  br i1 %v528, label %v1187, label %v1188

v1187:
  %v1189 = load i64, ptr %v534, align 8, !noalias !71
  %v1190 = inttoptr i64 %v1189 to ptr
  tail call void %v1190(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v536), !noalias !71
  %v1191 = load i64, ptr %v534, align 8, !noalias !74
  %v1192 = inttoptr i64 %v1191 to ptr
  tail call void %v1192(ptr nonnull %v526, ptr %v538, ptr %v166, ptr %v173, ptr %v180, ptr %v540), !noalias !74
  br label %v1193

v1193:
  %v1194 = phi i64 [ %v19, %v1187 ], [ %v1195, %v1196 ]
  %v1197 = phi i64 [ %v542, %v1187 ], [ %v1198, %v1196 ]
  %v1199 = icmp sgt i64 %v1197, 0
  br i1 %v1199, label %v1196, label %v1200

v1196:
  %v1198 = add nsw i64 %v1197, -1
  %v1195 = add i64 %v1194, 1
  %v1201 = icmp slt i64 %v1194, 0
  %v1202 = select i1 %v1201, i64 %v208, i64 0
  %v1203 = add i64 %v1202, %v1194
  %v1204 = getelementptr double, ptr %v546, i64 %v1203
  %v1205 = load double, ptr %v1204, align 8, !noalias !67
  %v1206 = getelementptr double, ptr %v549, i64 %v1203
  %v1207 = load double, ptr %v1206, align 8, !noalias !67
  %v1208 = fsub double %v1205, %v1207
  %v1209 = tail call double @llvm.fabs.f64(double %v1208)
  %v1210 = getelementptr double, ptr %v551, i64 %v1203
  %v1211 = load double, ptr %v1210, align 8, !noalias !67
  %v1212 = tail call i1 @llvm.is.fpclass.f64(double %v1211, i32 543)
  %v1213 = select i1 %v1212, double 0.000000e+00, double %v1211
  %v1214 = fcmp ueq double %v1209, 0x7FF0000000000000
  %v1215 = select i1 %v1214, double -0.000000e+00, double %v1209
  %v1216 = fadd double %v1213, %v1215
  %v1217 = getelementptr double, ptr %v548, i64 %v1203
  %v1218 = load double, ptr %v1217, align 8, !noalias !67
  %v1219 = fneg double %v1216
  %v1220 = fcmp olt double %v1218, %v1219
  br i1 %v1220, label %v1200, label %v1193

v1188:
  %v1221 = phi i64 [ %v1222, %v1188 ], [ 0, %v1173 ]
  %v1222 = add nsw i64 %v1221, 1
  %v1223 = mul i64 %v1221, %v197
  %v1224 = getelementptr double, ptr %v194, i64 %v1223
  %v1225 = load double, ptr %v1224, align 8, !noalias !67
  %v1226 = getelementptr double, ptr %v531, i64 %v1223
  %v1227 = load double, ptr %v1226, align 8, !noalias !67
  %v1228 = fmul double %v1183, %v1227
  %v1229 = fadd double %v1225, %v1228
  %v1230 = getelementptr double, ptr %v533, i64 %v1223
  store double %v1229, ptr %v1230, align 8, !noalias !67
  %v1231 = icmp eq i64 %v10, %v1222
  br i1 %v1231, label %v1187, label %v1188

v1232:
  %v1233 = getelementptr i64, ptr %v553, i64 %v1140
  store i64 %v1234, ptr %v1233, align 8, !noalias !77
  %v1235 = load i64, ptr %v1142, align 8, !noalias !78
  %v1236 = icmp sgt i64 %v1235, -1
  br i1 %v1236, label %v1237, label %v1238

v1237:
  %v1239 = getelementptr i64, ptr %v111, i64 %v1235
  %v1240 = load i64, ptr %v1239, align 8, !noalias !78
  %v1241 = icmp eq i64 %v1240, 0
  br i1 %v1241, label %v1242, label %v1238

v1242:
  store i64 4, ptr %v1239, align 8, !noalias !78
  br label %v1238

v1238:
  %v1243 = getelementptr double, ptr %v134, i64 %v1140
  %v1244 = load double, ptr %v1243, align 8, !noalias !77
  %v1245 = getelementptr double, ptr %v555, i64 %v1140
  store double %v1244, ptr %v1245, align 8, !noalias !77
  %v1246 = getelementptr double, ptr %v557, i64 %v1140
  store double 0.000000e+00, ptr %v1246, align 8, !noalias !77
  br label %v1174

v1200:
  %v1234 = phi i64 [ %v1194, %v1196 ], [ -1, %v1193 ]
  %v1247 = icmp sgt i64 %v1234, -1
  br i1 %v1247, label %v1232, label %v1174

v1248:
  %v1249 = icmp sgt i64 %v1250, 1
  br i1 %v1249, label %v1136, label %v1070

v1136:
  %v1250 = phi i64 [ %v1251, %v1248 ], [ %v295, %v1125 ]
  %v1140 = phi i64 [ %v1252, %v1248 ], [ 0, %v1125 ]
  %v1251 = add nsw i64 %v1250, -1
  %v1252 = add nsw i64 %v1140, 1
  %v1138 = getelementptr double, ptr %v513, i64 %v1140
  %v1253 = load double, ptr %v1138, align 8, !noalias !50
  %v1254 = fcmp olt double %v1253, 5.000000e-01
  br i1 %v1254, label %v1248, label %v1137

v1174:
  %v1255 = getelementptr double, ptr %v559, i64 %v1140
  %v1256 = load double, ptr %v1255, align 8, !noalias !81
  %v1257 = getelementptr double, ptr %v561, i64 %v1140
  store double %v1256, ptr %v1257, align 8, !noalias !81
  %v1258 = getelementptr i64, ptr %v563, i64 %v1140
  %v1259 = load i64, ptr %v1258, align 8, !noalias !81
  %v1260 = icmp slt i64 %v1259, %v94
  br i1 %v1260, label %v1261, label %v1248

v1261:
  %v1262 = icmp slt i64 %v1259, 0
  %v1263 = select i1 %v1262, i64 %v94, i64 0
  %v1264 = getelementptr double, ptr %v93, i64 %v1259
  %v1265 = getelementptr double, ptr %v1264, i64 %v1263
  %v1266 = load double, ptr %v1265, align 8, !noalias !81
  %v1267 = load double, ptr %v1255, align 8, !noalias !81
  %v1268 = fcmp olt double %v1267, %v1266
  %v1269 = select i1 %v1268, double %v1267, double %v1266
  store double %v1269, ptr %v1257, align 8, !noalias !81
  br label %v1248

v1070:
  %v1270 = phi i1 [ %v647, %v1076 ], [ %v647, %v1061 ], [ true, %v1125 ], [ true, %v1248 ]
  %v1271 = load i64, ptr %v564, align 8, !noalias !85
  %v1272 = inttoptr i64 %v1271 to ptr
  tail call void %v1272(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !85
  br i1 %v565, label %v1273, label %v1274

v1275:
  %v1276 = getelementptr double, ptr %v649, i64 %v1277
  %v1278 = load double, ptr %v1276, align 8
  %v1279 = fcmp ogt double %v1278, 5.000000e-01
  br label %v1280

v1280:
  %v1281 = phi i1 [ true, %v1282 ], [ %v1279, %v1275 ]
  br i1 %v1283, label %v1284, label %v1285

v1285:
  %v1286 = getelementptr double, ptr %v651, i64 %v1277
  %v1287 = load double, ptr %v1286, align 8
  %v1288 = fcmp ogt double %v1287, 5.000000e-01
  br label %v1284

v1284:
  %v1289 = phi i1 [ true, %v1280 ], [ %v1288, %v1285 ]
  %v1290 = icmp sgt i64 %v1291, 1
  br i1 %v1290, label %v1282, label %v1292

v1292:
  %v1293 = phi i1 [ false, %v1294 ], [ %v1281, %v1284 ]
  %v1295 = phi i1 [ %v1270, %v1294 ], [ %v1289, %v1284 ]
  %v1296 = xor i1 %v1295, true
  %v1297 = or i1 %v294, %v1296
  br i1 %v1297, label %v1298, label %v1299

v1300:
  br i1 %v294, label %v1298, label %v1301

v1302:
  %v1303 = getelementptr double, ptr %v653, i64 %v1304
  %v1305 = load double, ptr %v1303, align 8, !noalias !91
  %v1306 = fptosi double %v1305 to i64
  %v1307 = getelementptr double, ptr %v655, i64 %v1304
  %v1308 = load double, ptr %v1307, align 8, !noalias !91
  %v1309 = fptosi double %v1308 to i64
  %v1310 = mul i64 %v1311, %v127
  %v1312 = getelementptr i64, ptr %v125, i64 %v1310
  %v1313 = load i64, ptr %v1312, align 8, !noalias !91
  %v1314 = add nsw i64 %v1313, %v1306
  store i64 %v1314, ptr %v1312, align 8, !noalias !91
  %v1315 = getelementptr i8, ptr %v1312, i64 24
  %v1316 = load i64, ptr %v1315, align 8, !noalias !91
  %v1317 = add nsw i64 %v1316, %v1309
  store i64 %v1317, ptr %v1315, align 8, !noalias !91
  %v1318 = getelementptr i8, ptr %v1312, i64 8
  %v1319 = load i64, ptr %v1318, align 8, !noalias !91
  %v1320 = add nsw i64 %v1309, %v1306
  %v1321 = mul nsw i64 %v1320, %v624
  %v1322 = add nsw i64 %v1321, %v1306
  %v1323 = add nsw i64 %v1322, %v1319
  store i64 %v1323, ptr %v1318, align 8, !noalias !91
  store double 0.000000e+00, ptr %v1303, align 8, !noalias !91
  store double 0.000000e+00, ptr %v1307, align 8, !noalias !91
  %v1324 = getelementptr double, ptr %v657, i64 %v1304
  %v1325 = load double, ptr %v1324, align 8, !noalias !91
  %v1326 = sitofp i64 %v1320 to double
  %v1327 = fsub double %v1325, %v1326
  store double %v1327, ptr %v1324, align 8, !noalias !91
  br label %v1328

v1328:
  %v1329 = icmp sgt i64 %v1330, 1
  br i1 %v1329, label %v1299, label %v1300

v1299:
  %v1330 = phi i64 [ %v1331, %v1328 ], [ %v295, %v1292 ]
  %v1304 = phi i64 [ %v1332, %v1328 ], [ 0, %v1292 ]
  %v1331 = add nsw i64 %v1330, -1
  %v1332 = add nsw i64 %v1304, 1
  %v1333 = getelementptr i64, ptr %v143, i64 %v1304
  %v1311 = load i64, ptr %v1333, align 8, !noalias !91
  %v1334 = icmp sgt i64 %v1311, -1
  br i1 %v1334, label %v1302, label %v1328

v1335:
  %v1336 = getelementptr double, ptr %v663, i64 %v1337
  %v1338 = load double, ptr %v1336, align 8, !noalias !98
  %v1339 = fcmp ogt double %v1338, 5.000000e-01
  br i1 %v1339, label %v1340, label %v1341

v1340:
  %v1342 = fptosi double %v1338 to i64
  %v1343 = load i64, ptr %v1344, align 8, !noalias !99
  %v1345 = icmp sgt i64 %v1343, -1
  br i1 %v1345, label %v1346, label %v1341

v1341:
  %v1347 = getelementptr double, ptr %v665, i64 %v1337
  %v1348 = load double, ptr %v1347, align 8, !noalias !98
  %v1349 = fcmp ogt double %v1348, 5.000000e-01
  br i1 %v1349, label %v1350, label %v1351

v1350:
  %v1352 = select i1 %v1353, i1 true, i1 %v291
  %v1354 = icmp slt i64 %v1355, %v94
  br i1 %v1354, label %v1356, label %v1357

v1356:
  %v1358 = icmp slt i64 %v1355, 0
  %v1359 = select i1 %v1358, i64 %v94, i64 0
  %v1360 = getelementptr double, ptr %v93, i64 %v1355
  %v1361 = getelementptr double, ptr %v1360, i64 %v1359
  %v1362 = load double, ptr %v1361, align 8, !noalias !98
  %v1363 = getelementptr double, ptr %v667, i64 %v1337
  %v1364 = load double, ptr %v1363, align 8, !noalias !98
  %v1365 = fcmp olt double %v1362, %v1364
  br i1 %v1365, label %v1366, label %v1357

v1366:
  br label %v1357

v1357:
  %v1367 = phi i1 [ true, %v1366 ], [ %v1352, %v1356 ], [ %v1352, %v1350 ]
  %v1368 = mul i64 %v1369, %v127
  %v1370 = getelementptr i64, ptr %v125, i64 %v1368
  %v1371 = load i64, ptr %v1370, align 8, !noalias !98
  %v1372 = and i64 %v1371, 127
  %v1373 = icmp eq i64 %v1372, 0
  br i1 %v1373, label %v1374, label %v1375

v1375:
  %v1376 = getelementptr double, ptr %v669, i64 %v1337
  %v1377 = load double, ptr %v1376, align 8, !noalias !98
  %v1378 = fcmp ogt double %v1377, 0.000000e+00
  br i1 %v1378, label %v1374, label %v1351

v1374:
  store double 1.000000e+00, ptr %v1379, align 8, !noalias !98
  br label %v1351

v1351:
  %v1380 = phi i1 [ %v1367, %v1374 ], [ %v1367, %v1375 ], [ %v1353, %v1341 ], [ %v1353, %v1301 ]
  %v1381 = phi i1 [ true, %v1374 ], [ %v1382, %v1375 ], [ %v1382, %v1341 ], [ %v1382, %v1301 ]
  %v1383 = icmp sgt i64 %v1384, 1
  br i1 %v1383, label %v1301, label %v1385

v1301:
  %v1382 = phi i1 [ %v1381, %v1351 ], [ false, %v1300 ]
  %v1353 = phi i1 [ %v1380, %v1351 ], [ false, %v1300 ]
  %v1384 = phi i64 [ %v1386, %v1351 ], [ %v295, %v1300 ]
  %v1337 = phi i64 [ %v1387, %v1351 ], [ 0, %v1300 ]
  %v1386 = add nsw i64 %v1384, -1
  %v1387 = add nsw i64 %v1337, 1
  %v1344 = getelementptr i64, ptr %v143, i64 %v1337
  %v1369 = load i64, ptr %v1344, align 8, !noalias !98
  %v1388 = getelementptr i64, ptr %v659, i64 %v1337
  %v1355 = load i64, ptr %v1388, align 8, !noalias !98
  %v1379 = getelementptr double, ptr %v661, i64 %v1337
  store double 0.000000e+00, ptr %v1379, align 8, !noalias !98
  %v1389 = icmp sgt i64 %v1369, -1
  br i1 %v1389, label %v1335, label %v1351

v1346:
  %v1390 = getelementptr i64, ptr %v111, i64 %v1343
  %v1391 = load i64, ptr %v1390, align 8, !noalias !99
  %v1392 = icmp eq i64 %v1391, 0
  br i1 %v1392, label %v1393, label %v1341

v1393:
  store i64 %v1342, ptr %v1390, align 8, !noalias !99
  br label %v1341

v1298:
  %v1394 = phi i1 [ true, %v1292 ], [ true, %v1300 ], [ %v1395, %v1385 ]
  %v1396 = phi i1 [ true, %v1292 ], [ true, %v1300 ], [ %v1397, %v1385 ]
  %v1398 = and i1 %v670, %v1293
  br i1 %v1398, label %v1399, label %v1400

v1399:
  %v1401 = load i64, ptr %v6, align 8, !noalias !102
  %v1402 = inttoptr i64 %v1401 to ptr
  tail call void %v1402(ptr %v675, ptr %v678, ptr %v166, ptr %v173, ptr %v180, ptr %v680), !noalias !102
  br label %v1400

v1400:
  br i1 %v1396, label %v1403, label %v1404

v1404:
  %v1405 = load i64, ptr %v681, align 8, !noalias !108
  %v1406 = inttoptr i64 %v1405 to ptr
  tail call void %v1406(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !108
  br label %v1403

v1403:
  %v1407 = select i1 %v1293, i1 %v291, i1 false
  %v1408 = xor i1 %v1293, true
  %v1409 = select i1 %v292, i1 %v1293, i1 false
  %v1410 = xor i1 %v1409, true
  %v1411 = select i1 %v1410, i1 true, i1 %v1407
  %v1412 = select i1 %v292, i1 %v1293, i1 %v1407
  br i1 %v1411, label %v1413, label %v1414

v1414:
  %v1415 = load i64, ptr %v682, align 8, !noalias !111
  %v1416 = inttoptr i64 %v1415 to ptr
  tail call void %v1416(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !111
  br label %v1417

v1417:
  %v1418 = phi i64 [ 0, %v1414 ], [ %v1419, %v1420 ]
  %v1419 = add nsw i64 %v1418, 1
  %v1421 = icmp ult i64 %v1418, 9
  br i1 %v1421, label %v1422, label %v1423

v1422:
  %v1424 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v1418
  %v1425 = load double, ptr %v1424, align 8
  %v1426 = load double, ptr %v134, align 8, !noalias !114
  %v1427 = load double, ptr %v685, align 8, !noalias !114
  %v1428 = fmul double %v1425, %v1427
  %v1429 = fadd double %v1426, %v1428
  store double %v1429, ptr %v687, align 8, !noalias !114
  br i1 %v689, label %v1420, label %v1430

v1430:
  %v1431 = fsub double 1.000000e+00, %v1425
  br label %v1432

v1432:
  %v1433 = phi i64 [ 0, %v1430 ], [ %v1434, %v1432 ]
  %v1435 = mul i64 %v1433, %v197
  %v1436 = getelementptr double, ptr %v194, i64 %v1435
  %v1437 = getelementptr i8, ptr %v1436, i64 %v693
  %v1438 = load double, ptr %v1437, align 8, !noalias !124
  %v1439 = fadd double %v1438, 0.000000e+00
  %v1440 = fmul double %v1425, %v1439
  %v1441 = getelementptr i8, ptr %v1436, i64 %v694
  %v1442 = load double, ptr %v1441, align 8, !noalias !124
  %v1443 = fadd double %v1442, %v1440
  %v1444 = fmul double %v1431, %v1443
  %v1445 = getelementptr i8, ptr %v1436, i64 %v695
  %v1446 = load double, ptr %v1445, align 8, !noalias !124
  %v1447 = fadd double %v1446, %v1444
  %v1448 = fmul double %v1425, %v1447
  %v1449 = getelementptr i8, ptr %v1436, i64 %v696
  %v1450 = load double, ptr %v1449, align 8, !noalias !124
  %v1451 = fadd double %v1450, %v1448
  %v1452 = fmul double %v1431, %v1451
  %v1453 = getelementptr i8, ptr %v1436, i64 %v697
  %v1454 = load double, ptr %v1453, align 8, !noalias !124
  %v1455 = fadd double %v1454, %v1452
  %v1456 = fmul double %v1425, %v1455
  %v1457 = getelementptr i8, ptr %v1436, i64 %v698
  %v1458 = load double, ptr %v1457, align 8, !noalias !124
  %v1459 = fadd double %v1458, %v1456
  %v1460 = fmul double %v1431, %v1459
  %v1461 = getelementptr i8, ptr %v1436, i64 %v699
  %v1462 = load double, ptr %v1461, align 8, !noalias !124
  %v1463 = fadd double %v1462, %v1460
  %v1464 = fmul double %v1425, %v1463
  %v1434 = add nsw i64 %v1433, 1
  %v1465 = load double, ptr %v1436, align 8, !noalias !124
  %v1466 = fadd double %v1465, %v1464
  %v1467 = getelementptr double, ptr %v690, i64 %v1435
  store double %v1466, ptr %v1467, align 8, !noalias !114
  %v1468 = icmp eq i64 %v10, %v1434
  br i1 %v1468, label %v1420, label %v1432

v1420:
  %v1469 = icmp eq i64 %v1418, 8
  %v1470 = select i1 %v1469, i64 17, i64 16
  %v1471 = mul i64 %v691, %v1418
  %v1472 = load i64, ptr %v692, align 8, !noalias !128
  %v1473 = mul nsw i64 %v1470, %v10
  %v1474 = getelementptr double, ptr %v159, i64 %v1473
  %v1475 = getelementptr double, ptr %v187, i64 %v1471
  %v1476 = inttoptr i64 %v1472 to ptr
  tail call void %v1476(ptr nonnull %v687, ptr %v1474, ptr %v166, ptr %v173, ptr %v180, ptr %v1475), !noalias !128
  %v1477 = icmp eq i64 %v1419, 9
  br i1 %v1477, label %v1423, label %v1417

v1423:
  %v1478 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v1417 ], [ null, %v1420 ]
  %v1479 = phi i32 [ 1, %v1417 ], [ 0, %v1420 ]
  br i1 %v1421, label %v1480, label %v1481, !prof !131

v1413:
  %v1482 = phi i1 [ %v1412, %v1403 ], [ %v1483, %v1481 ]
  %v1484 = xor i1 %v1394, true
  %v1485 = select i1 %v1484, i1 true, i1 %v1482
  br i1 %v1485, label %v1486, label %v1487

v1486:
  br i1 %v710, label %v1488, label %v1489

v1490:
  %v1491 = load i64, ptr %v721, align 8, !noalias !132
  %v1492 = inttoptr i64 %v1491 to ptr
  tail call void %v1492(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !132
  br label %v1489

v1488:
  %v1493 = phi i64 [ %v1494, %v1488 ], [ 1, %v1486 ]
  %v1494 = add i64 %v1493, 1
  %v1495 = add nsw i64 %v711, %v1493
  %v1496 = icmp slt i64 %v1495, 0
  %v1497 = select i1 %v1496, i64 %v7, i64 0
  %v1498 = getelementptr i64, ptr %v6, i64 %v1495
  %v1499 = getelementptr i64, ptr %v1498, i64 %v1497
  %v1500 = load i64, ptr %v1499, align 8, !noalias !138
  %v1501 = inttoptr i64 %v1500 to ptr
  tail call void %v1501(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !138
  %v1502 = add nsw i64 %v1493, 13
  %v1503 = load i64, ptr %v6, align 8, !noalias !141
  %v1504 = mul nsw i64 %v1502, %v714
  %v1505 = getelementptr double, ptr %v159, i64 %v1504
  %v1506 = inttoptr i64 %v1503 to ptr
  tail call void %v1506(ptr %v713, ptr %v716, ptr %v166, ptr %v173, ptr %v180, ptr %v1505), !noalias !141
  %v1507 = icmp eq i64 %v1493, %v12
  br i1 %v1507, label %v1490, label %v1488

v1489:
  %v1508 = load i64, ptr %v722, align 8, !noalias !144
  %v1509 = inttoptr i64 %v1508 to ptr
  tail call void %v1509(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !144
  %v1510 = select i1 %v673, i1 true, i1 %v1408
  %v1511 = or i1 %v1510, %v294
  br i1 %v1511, label %v1512, label %v1513

v1514:
  %v1515 = getelementptr double, ptr %v726, i64 %v1516
  %v1517 = load double, ptr %v1515, align 8, !noalias !147
  %v1518 = fcmp uge double %v1517, 5.000000e-01
  %v1519 = icmp slt i64 %v1520, %v94
  %v1521 = select i1 %v1518, i1 %v1519, i1 false
  br i1 %v1521, label %v1522, label %v1523

v1522:
  %v1524 = icmp slt i64 %v1520, 0
  %v1525 = select i1 %v1524, i64 %v94, i64 0
  %v1526 = getelementptr double, ptr %v93, i64 %v1520
  %v1527 = getelementptr double, ptr %v1526, i64 %v1525
  %v1528 = load double, ptr %v1527, align 8, !noalias !147
  %v1529 = getelementptr double, ptr %v728, i64 %v1516
  %v1530 = load double, ptr %v1529, align 8, !noalias !147
  %v1531 = fcmp olt double %v1528, %v1530
  br i1 %v1531, label %v1532, label %v1523

v1532:
  %v1533 = getelementptr double, ptr %v730, i64 %v1516
  %v1534 = load double, ptr %v1533, align 8, !noalias !147
  %v1535 = fcmp ogt double %v1534, 1.000000e+00
  br i1 %v1535, label %v1536, label %v1523

v1536:
  %v1537 = getelementptr double, ptr %v732, i64 %v1516
  %v1538 = load double, ptr %v1537, align 8, !noalias !147
  store double 0.000000e+00, ptr %v1515, align 8, !noalias !151
  %v1539 = getelementptr double, ptr %v734, i64 %v1516
  store double 0.000000e+00, ptr %v1539, align 8, !noalias !151
  %v1540 = getelementptr double, ptr %v735, i64 %v1516
  store double %v1538, ptr %v1540, align 8, !noalias !151
  %v1541 = load i64, ptr %v1542, align 8, !noalias !151
  %v1543 = icmp slt i64 %v1541, 0
  %v1544 = select i1 %v1543, i64 %v126, i64 0
  %v1545 = add i64 %v1544, %v1541
  %v1546 = mul i64 %v1545, %v127
  %v1547 = getelementptr i64, ptr %v125, i64 %v1546
  %v1548 = load i64, ptr %v1547, align 8, !noalias !151
  %v1549 = add nsw i64 %v1548, -1
  store i64 %v1549, ptr %v1547, align 8, !noalias !151
  %v1550 = load i64, ptr %v1542, align 8, !noalias !151
  %v1551 = icmp slt i64 %v1550, 0
  %v1552 = select i1 %v1551, i64 %v126, i64 0
  %v1553 = add i64 %v1552, %v1550
  %v1554 = mul i64 %v1553, %v127
  %v1555 = getelementptr i64, ptr %v125, i64 %v1554
  %v1556 = getelementptr i8, ptr %v1555, i64 24
  %v1557 = load i64, ptr %v1556, align 8, !noalias !151
  %v1558 = add nsw i64 %v1557, 1
  store i64 %v1558, ptr %v1556, align 8, !noalias !151
  %v1559 = load double, ptr %v1527, align 8, !noalias !147
  %v1560 = getelementptr double, ptr %v737, i64 %v1516
  store double %v1559, ptr %v1560, align 8, !noalias !147
  %v1561 = mul i64 %v1562, %v127
  %v1563 = getelementptr i64, ptr %v125, i64 %v1561
  %v1564 = getelementptr i8, ptr %v1563, i64 8
  %v1565 = load i64, ptr %v1564, align 8, !noalias !147
  %v1566 = add nsw i64 %v1565, %v12
  store i64 %v1566, ptr %v1564, align 8, !noalias !147
  br label %v1523

v1523:
  %v1567 = icmp sgt i64 %v1568, 1
  br i1 %v1567, label %v1513, label %v1512

v1513:
  %v1568 = phi i64 [ %v1569, %v1523 ], [ %v295, %v1489 ]
  %v1516 = phi i64 [ %v1570, %v1523 ], [ 0, %v1489 ]
  %v1569 = add nsw i64 %v1568, -1
  %v1570 = add nsw i64 %v1516, 1
  %v1542 = getelementptr i64, ptr %v143, i64 %v1516
  %v1562 = load i64, ptr %v1542, align 8, !noalias !147
  %v1571 = getelementptr i64, ptr %v724, i64 %v1516
  %v1520 = load i64, ptr %v1571, align 8, !noalias !147
  %v1572 = icmp slt i64 %v1562, 0
  br i1 %v1572, label %v1523, label %v1514

v1512:
  br i1 %v1482, label %v1573, label %v1574

v1573:
  call void @llvm.lifetime.start.p0(ptr nonnull %v289)
  call void @llvm.lifetime.start.p0(ptr nonnull %v290)
  store i8 0, ptr %v289, align 1, !noalias !154
  store ptr null, ptr %v290, align 8, !noalias !154
  br label %v1575

v1575:
  %v1576 = phi i64 [ 0, %v1573 ], [ %v1577, %v1578 ]
  %v1577 = add nsw i64 %v1576, 1
  %v1579 = icmp ult i64 %v1576, 9
  br i1 %v1579, label %v1580, label %v1581

v1580:
  %v1582 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v1576
  %v1583 = load double, ptr %v1582, align 8
  %v1584 = load double, ptr %v134, align 8, !noalias !158
  %v1585 = load double, ptr %v740, align 8, !noalias !158
  %v1586 = fmul double %v1583, %v1585
  %v1587 = fadd double %v1584, %v1586
  store double %v1587, ptr %v742, align 8, !noalias !158
  br i1 %v744, label %v1578, label %v1588

v1588:
  %v1589 = fsub double 1.000000e+00, %v1583
  br label %v1590

v1590:
  %v1591 = phi i64 [ 0, %v1588 ], [ %v1592, %v1590 ]
  %v1593 = mul i64 %v1591, %v197
  %v1594 = getelementptr double, ptr %v194, i64 %v1593
  %v1595 = getelementptr i8, ptr %v1594, i64 %v748
  %v1596 = load double, ptr %v1595, align 8, !noalias !165
  %v1597 = fadd double %v1596, 0.000000e+00
  %v1598 = fmul double %v1583, %v1597
  %v1599 = getelementptr i8, ptr %v1594, i64 %v749
  %v1600 = load double, ptr %v1599, align 8, !noalias !165
  %v1601 = fadd double %v1600, %v1598
  %v1602 = fmul double %v1589, %v1601
  %v1603 = getelementptr i8, ptr %v1594, i64 %v750
  %v1604 = load double, ptr %v1603, align 8, !noalias !165
  %v1605 = fadd double %v1604, %v1602
  %v1606 = fmul double %v1583, %v1605
  %v1607 = getelementptr i8, ptr %v1594, i64 %v751
  %v1608 = load double, ptr %v1607, align 8, !noalias !165
  %v1609 = fadd double %v1608, %v1606
  %v1610 = fmul double %v1589, %v1609
  %v1611 = getelementptr i8, ptr %v1594, i64 %v752
  %v1612 = load double, ptr %v1611, align 8, !noalias !165
  %v1613 = fadd double %v1612, %v1610
  %v1614 = fmul double %v1583, %v1613
  %v1615 = getelementptr i8, ptr %v1594, i64 %v753
  %v1616 = load double, ptr %v1615, align 8, !noalias !165
  %v1617 = fadd double %v1616, %v1614
  %v1618 = fmul double %v1589, %v1617
  %v1619 = getelementptr i8, ptr %v1594, i64 %v754
  %v1620 = load double, ptr %v1619, align 8, !noalias !165
  %v1621 = fadd double %v1620, %v1618
  %v1622 = fmul double %v1583, %v1621
  %v1592 = add nsw i64 %v1591, 1
  %v1623 = load double, ptr %v1594, align 8, !noalias !165
  %v1624 = fadd double %v1623, %v1622
  %v1625 = getelementptr double, ptr %v745, i64 %v1593
  store double %v1624, ptr %v1625, align 8, !noalias !158
  %v1626 = icmp eq i64 %v10, %v1592
  br i1 %v1626, label %v1578, label %v1590

v1578:
  %v1627 = icmp eq i64 %v1576, 8
  %v1628 = select i1 %v1627, i64 17, i64 16
  %v1629 = mul i64 %v1576, %v746
  %v1630 = load i64, ptr %v747, align 8, !noalias !169
  %v1631 = mul nsw i64 %v1628, %v10
  %v1632 = getelementptr double, ptr %v159, i64 %v1631
  %v1633 = getelementptr double, ptr %v187, i64 %v1629
  %v1634 = inttoptr i64 %v1630 to ptr
  tail call void %v1634(ptr nonnull %v742, ptr %v1632, ptr %v166, ptr %v173, ptr %v180, ptr %v1633), !noalias !169
  %v1635 = icmp eq i64 %v1577, 9
  br i1 %v1635, label %v1581, label %v1575

v1581:
  %v1636 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v1575 ], [ null, %v1578 ]
  %v1637 = phi i32 [ 1, %v1575 ], [ 0, %v1578 ]
  br i1 %v1579, label %v1638, label %v1639, !prof !131

v1638:
  %v1640 = load double, ptr %v756, align 8, !noalias !172
  %v1641 = load double, ptr %v93, align 8, !noalias !172
  %v1642 = fsub double %v1640, %v1641
  %v1643 = fmul double %v1642, 1.000000e-13
  %v1644 = load double, ptr %v134, align 8, !noalias !172
  %v1645 = tail call double @llvm.fabs.f64(double %v1644)
  %v1646 = fmul double %v1645, 4.000000e-15
  %v1647 = fcmp ogt double %v1646, %v1643
  %v1648 = select i1 %v1647, double %v1646, double %v1643
  %v1649 = load double, ptr %v740, align 8, !noalias !179
  %v1650 = fdiv double %v1648, %v1649
  %v1651 = fcmp olt double %v1650, 1.000000e+00
  %v1652 = select i1 %v1651, double %v1650, double 1.000000e+00
  br i1 %v757, label %v1653, label %v1654

v1655:
  %v1656 = fcmp olt double %v1657, %v1658
  %v1659 = select i1 %v1656, double %v1657, double %v1658
  %v1660 = fcmp ogt double %v1657, %v1661
  %v1662 = select i1 %v1660, double %v1657, double %v1661
  br label %v1663

v1663:
  %v1664 = phi double [ %v1662, %v1655 ], [ %v1661, %v1665 ]
  %v1666 = phi double [ %v1659, %v1655 ], [ %v1658, %v1665 ]
  %v1667 = icmp eq i64 %v1668, 9
  br i1 %v1667, label %v1669, label %v1665

v1669:
  %v1670 = fsub double %v1664, %v1666
  %v1671 = fmul double %v1652, %v1670
  %v1672 = tail call i1 @llvm.is.fpclass.f64(double %v1673, i32 543)
  %v1674 = select i1 %v1672, double 0.000000e+00, double %v1673
  %v1675 = tail call i1 @llvm.is.fpclass.f64(double %v1671, i32 543)
  %v1676 = select i1 %v1675, double -0.000000e+00, double %v1671
  %v1677 = fadd double %v1674, %v1676
  %v1678 = getelementptr double, ptr %v760, i64 %v1679
  %v1680 = load double, ptr %v1678, align 8, !noalias !179
  %v1681 = sub nsw i64 %v1682, %v19
  %v1683 = getelementptr double, ptr %v216, i64 %v1681
  %v1684 = load double, ptr %v1683, align 8, !noalias !179
  %v1685 = getelementptr double, ptr %v761, i64 %v1679
  store double %v1677, ptr %v1685, align 8, !noalias !179
  %v1686 = fcmp ule double %v1684, 5.000000e-01
  %v1687 = fcmp ule double %v1680, 0.000000e+00
  %v1688 = select i1 %v1686, i1 true, i1 %v1687
  %v1689 = select i1 %v1688, double %v1677, double 0.000000e+00
  %v1690 = getelementptr double, ptr %v1685, i64 %v758
  store double %v1689, ptr %v1690, align 8, !noalias !179
  %v1691 = getelementptr i8, ptr %v1685, i64 %v762
  store double %v1689, ptr %v1691, align 8, !noalias !179
  %v1692 = getelementptr i8, ptr %v1685, i64 %v763
  store double %v1689, ptr %v1692, align 8, !noalias !179
  %v1693 = getelementptr i8, ptr %v1685, i64 %v764
  store double %v1689, ptr %v1693, align 8, !noalias !179
  %v1694 = getelementptr i8, ptr %v1685, i64 %v765
  store double %v1689, ptr %v1694, align 8, !noalias !179
  %v1695 = getelementptr i8, ptr %v1685, i64 %v766
  store double %v1689, ptr %v1695, align 8, !noalias !179
  %v1696 = getelementptr i8, ptr %v1685, i64 %v767
  store double %v1689, ptr %v1696, align 8, !noalias !179
  %v1697 = getelementptr i8, ptr %v1685, i64 %v768
  store double %v1689, ptr %v1697, align 8, !noalias !179
  %v1698 = add nsw i64 %v1699, -1
  %v1700 = add i64 %v1682, 1
  %v1701 = icmp sgt i64 %v1699, 1
  br i1 %v1701, label %v1654, label %v1653

v1654:
  %v1699 = phi i64 [ %v1698, %v1669 ], [ %v16, %v1638 ]
  %v1682 = phi i64 [ %v1700, %v1669 ], [ %v19, %v1638 ]
  %v1702 = icmp slt i64 %v1682, 0
  %v1703 = select i1 %v1702, i64 %v208, i64 0
  %v1679 = add i64 %v1703, %v1682
  br label %v1665

v1665:
  %v1658 = phi double [ 0x7FF0000000000000, %v1654 ], [ %v1666, %v1663 ]
  %v1661 = phi double [ 0xFFF0000000000000, %v1654 ], [ %v1664, %v1663 ]
  %v1704 = phi double [ 0.000000e+00, %v1654 ], [ %v1673, %v1663 ]
  %v1705 = phi i64 [ 0, %v1654 ], [ %v1668, %v1663 ]
  %v1668 = add nsw i64 %v1705, 1
  %v1706 = mul i64 %v1705, %v758
  %v1707 = getelementptr double, ptr %v205, i64 %v1706
  %v1708 = getelementptr i8, ptr %v1707, i64 %v759
  %v1709 = getelementptr double, ptr %v1708, i64 %v1679
  %v1710 = load double, ptr %v1709, align 8, !noalias !179
  %v1711 = tail call i1 @llvm.is.fpclass.f64(double %v1710, i32 543)
  %v1712 = fadd double %v1710, 0.000000e+00
  %v1713 = select i1 %v1711, double 0.000000e+00, double %v1712
  %v1714 = fcmp ogt double %v1713, %v1704
  %v1673 = select i1 %v1714, double %v1713, double %v1704
  %v1715 = getelementptr double, ptr %v1707, i64 %v208
  %v1716 = getelementptr double, ptr %v1715, i64 %v1679
  %v1657 = load double, ptr %v1716, align 8, !noalias !179
  %v1717 = tail call double @llvm.fabs.f64(double %v1657)
  %v1718 = fcmp ueq double %v1717, 0x7FF0000000000000
  br i1 %v1718, label %v1663, label %v1655

v1653:
  store i8 0, ptr %v289, align 1, !noalias !154
  %v1719 = call fastcc i32 @_ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr %v289, ptr %v290, i64 %v13, ptr nonnull readonly %v93, i64 %v94, ptr %v125, i64 %v126, i64 %v127, ptr nonnull %v134, i64 %v136, ptr %v143, i64 %v145, ptr %v205, i64 %v206, i64 %v207, i64 %v208, double 0.000000e+00)
  %v1720 = icmp eq i32 %v1719, 0
  br i1 %v1720, label %v1721, label %v1722, !prof !131

v1722:
  %v1723 = load ptr, ptr %v290, align 8, !noalias !154
  br label %v1639

v1721:
  %v1724 = load i8, ptr %v289, align 1, !noalias !154
  %v1725 = icmp eq i8 %v1724, 0
  br label %v1639

v1639:
  %v1726 = phi i1 [ %v1725, %v1721 ], [ true, %v1722 ], [ true, %v1581 ]
  %v1727 = phi ptr [ null, %v1721 ], [ %v1723, %v1722 ], [ %v1636, %v1581 ]
  %v1728 = phi i32 [ 0, %v1721 ], [ 1, %v1722 ], [ %v1637, %v1581 ]
  call void @llvm.lifetime.end.p0(ptr nonnull %v289)
  call void @llvm.lifetime.end.p0(ptr nonnull %v290)
  %v1729 = icmp eq i32 %v1728, 0
  %v1730 = select i1 %v1729, ptr undef, ptr %v1727
  br i1 %v1729, label %v1731, label %v1487, !prof !131

v1732:
  %v1733 = load double, ptr %v770, align 8, !noalias !180
  %v1734 = load double, ptr %v740, align 8, !noalias !180
  %v1735 = load double, ptr %v772, align 8, !noalias !180
  %v1736 = load double, ptr %v93, align 8, !noalias !180
  %v1737 = fsub double %v1735, %v1736
  %v1738 = load double, ptr %v774, align 8, !noalias !180
  %v1739 = load double, ptr %v776, align 8, !noalias !180
  %v1740 = fsub double %v1738, %v1739
  %v1741 = fmul double %v1737, 5.000000e-06
  %v1742 = fcmp olt double %v1740, %v1741
  br label %v1743

v1744:
  %v1745 = sub nsw i64 45, %v1746
  %v1747 = load double, ptr %v781, align 8, !noalias !184
  %v1748 = load double, ptr %v783, align 8, !noalias !184
  br label %v1749

v1749:
  %v1750 = phi double [ %v1751, %v1749 ], [ 1.000000e+00, %v1744 ]
  %v1752 = phi double [ %v1753, %v1749 ], [ 2.000000e+00, %v1744 ]
  %v1754 = phi i64 [ %v1755, %v1749 ], [ %v1745, %v1744 ]
  %v1756 = and i64 %v1754, 1
  %v1757 = icmp eq i64 %v1756, 0
  %v1758 = fmul double %v1750, %v1752
  %v1751 = select i1 %v1757, double %v1750, double %v1758
  %v1755 = lshr i64 %v1754, 1
  %v1753 = fmul double %v1752, %v1752
  %v1759 = icmp eq i64 %v1755, 0
  br i1 %v1759, label %v1760, label %v1749

v1761:
  %v1762 = fcmp olt double %v1763, 0.000000e+00
  %v1764 = select i1 %v1762, double 0.000000e+00, double %v1763
  %v1765 = fmul double %v1766, %v1764
  %v1767 = fsub double %v1768, %v1765
  br label %v1769

v1760:
  %v1770 = fadd double %v1771, %v1772
  %v1768 = fmul double %v1770, 5.000000e-01
  %v1773 = fmul double %v1751, 1.000000e-13
  %v1774 = fsub double %v1773, %v1775
  %v1763 = fmul double %v1774, 5.000000e-01
  %v1776 = fmul double %v1772, %v1748
  %v1777 = fmul double %v1771, %v1747
  %v1778 = fsub double %v1776, %v1777
  %v1779 = fsub double %v1748, %v1747
  %v1780 = fdiv double %v1778, %v1779
  %v1781 = fcmp olt double %v1772, %v1780
  %v1782 = fcmp olt double %v1780, %v1771
  %v1783 = and i1 %v1781, %v1782
  %v1784 = select i1 %v1783, double %v1780, double %v1768
  %v1785 = fsub double %v1768, %v1784
  %v1766 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v1785)
  %v1786 = fmul double %v1775, %v1775
  %v1787 = tail call double @llvm.fabs.f64(double %v1785)
  %v1788 = fcmp olt double %v1787, %v1786
  %v1789 = select i1 %v1788, double %v1787, double %v1786
  %v1790 = fmul double %v1766, %v1789
  %v1791 = fadd double %v1784, %v1790
  %v1792 = fsub double %v1791, %v1768
  %v1793 = tail call double @llvm.fabs.f64(double %v1792)
  %v1794 = fcmp ugt double %v1793, %v1763
  br i1 %v1794, label %v1761, label %v1769

v1795:
  store double %v1796, ptr %v778, align 8, !noalias !190
  store double %v1797, ptr %v783, align 8, !noalias !190
  br label %v1798

v1799:
  store double %v1796, ptr %v770, align 8, !noalias !190
  store double %v1797, ptr %v781, align 8, !noalias !190
  br label %v1798

v1798:
  %v1800 = icmp eq i64 %v1801, 45
  br i1 %v1800, label %v1802, label %v1743

v1743:
  %v1746 = phi i64 [ 0, %v1732 ], [ %v1801, %v1798 ]
  %v1801 = add nsw i64 %v1746, 1
  %v1771 = load double, ptr %v778, align 8, !noalias !190
  %v1772 = load double, ptr %v770, align 8, !noalias !190
  %v1775 = fsub double %v1771, %v1772
  %v1803 = fcmp ugt double %v1775, 1.000000e-13
  br i1 %v1803, label %v1744, label %v1802

v1769:
  %v1796 = phi double [ %v1791, %v1760 ], [ %v1767, %v1761 ]
  %v1804 = load double, ptr %v134, align 8, !noalias !191
  %v1805 = load double, ptr %v740, align 8, !noalias !191
  %v1806 = fmul double %v1796, %v1805
  %v1807 = fadd double %v1804, %v1806
  store double %v1807, ptr %v742, align 8, !noalias !191
  br i1 %v784, label %v1808, label %v1809

v1808:
  %v1810 = fsub double 1.000000e+00, %v1796
  br label %v1811

v1811:
  %v1812 = phi i64 [ 0, %v1808 ], [ %v1813, %v1811 ]
  %v1814 = mul i64 %v1812, %v197
  %v1815 = getelementptr double, ptr %v194, i64 %v1814
  %v1816 = getelementptr i8, ptr %v1815, i64 %v748
  %v1817 = load double, ptr %v1816, align 8, !noalias !198
  %v1818 = fadd double %v1817, 0.000000e+00
  %v1819 = fmul double %v1796, %v1818
  %v1820 = getelementptr i8, ptr %v1815, i64 %v749
  %v1821 = load double, ptr %v1820, align 8, !noalias !198
  %v1822 = fadd double %v1821, %v1819
  %v1823 = fmul double %v1810, %v1822
  %v1824 = getelementptr i8, ptr %v1815, i64 %v750
  %v1825 = load double, ptr %v1824, align 8, !noalias !198
  %v1826 = fadd double %v1825, %v1823
  %v1827 = fmul double %v1796, %v1826
  %v1828 = getelementptr i8, ptr %v1815, i64 %v751
  %v1829 = load double, ptr %v1828, align 8, !noalias !198
  %v1830 = fadd double %v1829, %v1827
  %v1831 = fmul double %v1810, %v1830
  %v1832 = getelementptr i8, ptr %v1815, i64 %v752
  %v1833 = load double, ptr %v1832, align 8, !noalias !198
  %v1834 = fadd double %v1833, %v1831
  %v1835 = fmul double %v1796, %v1834
  %v1836 = getelementptr i8, ptr %v1815, i64 %v753
  %v1837 = load double, ptr %v1836, align 8, !noalias !198
  %v1838 = fadd double %v1837, %v1835
  %v1839 = fmul double %v1810, %v1838
  %v1840 = getelementptr i8, ptr %v1815, i64 %v754
  %v1841 = load double, ptr %v1840, align 8, !noalias !198
  %v1842 = fadd double %v1841, %v1839
  %v1843 = fmul double %v1796, %v1842
  %v1813 = add nsw i64 %v1812, 1
  %v1844 = load double, ptr %v1815, align 8, !noalias !198
  %v1845 = fadd double %v1844, %v1843
  %v1846 = getelementptr double, ptr %v745, i64 %v1814
  store double %v1845, ptr %v1846, align 8, !noalias !191
  %v1847 = icmp eq i64 %v10, %v1813
  br i1 %v1847, label %v1809, label %v1811

v1809:
  %v1848 = load i64, ptr %v747, align 8, !noalias !202
  %v1849 = inttoptr i64 %v1848 to ptr
  tail call void %v1849(ptr nonnull %v742, ptr %v786, ptr %v166, ptr %v173, ptr %v180, ptr %v788), !noalias !202
  br i1 %v791, label %v1850, label %v1851

v1850:
  %v1852 = phi i64 [ %v1853, %v1850 ], [ %v790, %v1809 ]
  %v1854 = phi i64 [ %v1855, %v1850 ], [ %v19, %v1809 ]
  %v1853 = add nsw i64 %v1852, -1
  %v1855 = add i64 %v1854, 1
  %v1856 = icmp slt i64 %v1854, 0
  %v1857 = select i1 %v1856, i64 %v208, i64 0
  %v1858 = add i64 %v1857, %v1854
  %v1859 = getelementptr double, ptr %v795, i64 %v1858
  %v1860 = load double, ptr %v1859, align 8, !noalias !205
  %v1861 = getelementptr double, ptr %v798, i64 %v1858
  store double %v1860, ptr %v1861, align 8, !noalias !205
  %v1862 = icmp sgt i64 %v1852, 1
  br i1 %v1862, label %v1850, label %v1851

v1851:
  br i1 %v799, label %v1863, label %v1864

v1864:
  %v1865 = phi double [ %v1866, %v1864 ], [ 0x7FF0000000000000, %v1851 ]
  %v1867 = phi i64 [ %v1868, %v1864 ], [ 0, %v1851 ]
  %v1868 = add nsw i64 %v1867, 1
  %v1869 = getelementptr double, ptr %v800, i64 %v1867
  %v1870 = load double, ptr %v1869, align 8, !noalias !206
  %v1871 = getelementptr double, ptr %v798, i64 %v1867
  %v1872 = load double, ptr %v1871, align 8, !noalias !206
  %v1873 = fadd double %v1870, %v1872
  %v1874 = fcmp olt double %v1873, %v1865
  %v1866 = select i1 %v1874, double %v1873, double %v1865
  %v1875 = icmp eq i64 %v208, %v1868
  br i1 %v1875, label %v1863, label %v1864

v1863:
  %v1797 = phi double [ 0x7FF0000000000000, %v1851 ], [ %v1866, %v1864 ]
  %v1876 = fcmp olt double %v1797, 0.000000e+00
  br i1 %v1876, label %v1795, label %v1799

v1877:
  %v1878 = load double, ptr %v778, align 8, !noalias !210
  %v1879 = load double, ptr %v134, align 8, !noalias !214
  %v1880 = load double, ptr %v740, align 8, !noalias !214
  %v1881 = fmul double %v1878, %v1880
  %v1882 = fadd double %v1879, %v1881
  store double %v1882, ptr %v742, align 8, !noalias !214
  br i1 %v784, label %v1883, label %v1884

v1883:
  %v1885 = fsub double 1.000000e+00, %v1878
  br label %v1886

v1886:
  %v1887 = phi i64 [ 0, %v1883 ], [ %v1888, %v1886 ]
  %v1889 = mul i64 %v1887, %v197
  %v1890 = getelementptr double, ptr %v194, i64 %v1889
  %v1891 = getelementptr i8, ptr %v1890, i64 %v748
  %v1892 = load double, ptr %v1891, align 8, !noalias !221
  %v1893 = fadd double %v1892, 0.000000e+00
  %v1894 = fmul double %v1878, %v1893
  %v1895 = getelementptr i8, ptr %v1890, i64 %v749
  %v1896 = load double, ptr %v1895, align 8, !noalias !221
  %v1897 = fadd double %v1896, %v1894
  %v1898 = fmul double %v1885, %v1897
  %v1899 = getelementptr i8, ptr %v1890, i64 %v750
  %v1900 = load double, ptr %v1899, align 8, !noalias !221
  %v1901 = fadd double %v1900, %v1898
  %v1902 = fmul double %v1878, %v1901
  %v1903 = getelementptr i8, ptr %v1890, i64 %v751
  %v1904 = load double, ptr %v1903, align 8, !noalias !221
  %v1905 = fadd double %v1904, %v1902
  %v1906 = fmul double %v1885, %v1905
  %v1907 = getelementptr i8, ptr %v1890, i64 %v752
  %v1908 = load double, ptr %v1907, align 8, !noalias !221
  %v1909 = fadd double %v1908, %v1906
  %v1910 = fmul double %v1878, %v1909
  %v1911 = getelementptr i8, ptr %v1890, i64 %v753
  %v1912 = load double, ptr %v1911, align 8, !noalias !221
  %v1913 = fadd double %v1912, %v1910
  %v1914 = fmul double %v1885, %v1913
  %v1915 = getelementptr i8, ptr %v1890, i64 %v754
  %v1916 = load double, ptr %v1915, align 8, !noalias !221
  %v1917 = fadd double %v1916, %v1914
  %v1918 = fmul double %v1878, %v1917
  %v1888 = add nsw i64 %v1887, 1
  %v1919 = load double, ptr %v1890, align 8, !noalias !221
  %v1920 = fadd double %v1919, %v1918
  %v1921 = getelementptr double, ptr %v745, i64 %v1889
  store double %v1920, ptr %v1921, align 8, !noalias !214
  %v1922 = icmp eq i64 %v10, %v1888
  br i1 %v1922, label %v1884, label %v1886

v1884:
  %v1923 = load i64, ptr %v747, align 8, !noalias !225
  %v1924 = inttoptr i64 %v1923 to ptr
  tail call void %v1924(ptr nonnull %v742, ptr %v786, ptr %v166, ptr %v173, ptr %v180, ptr %v788), !noalias !225
  br i1 %v791, label %v1925, label %v1926

v1926:
  br label %v1927

v1925:
  %v1928 = phi i64 [ %v1929, %v1925 ], [ %v790, %v1884 ]
  %v1930 = phi i64 [ %v1931, %v1925 ], [ %v19, %v1884 ]
  %v1929 = add nsw i64 %v1928, -1
  %v1931 = add i64 %v1930, 1
  %v1932 = icmp slt i64 %v1930, 0
  %v1933 = select i1 %v1932, i64 %v208, i64 0
  %v1934 = add i64 %v1933, %v1930
  %v1935 = getelementptr double, ptr %v795, i64 %v1934
  %v1936 = load double, ptr %v1935, align 8, !noalias !228
  %v1937 = getelementptr double, ptr %v798, i64 %v1934
  store double %v1936, ptr %v1937, align 8, !noalias !228
  %v1938 = icmp sgt i64 %v1928, 1
  br i1 %v1938, label %v1925, label %v1926

v1939:
  %v1940 = icmp slt i64 %v1941, 0
  %v1942 = select i1 %v1940, i64 %v208, i64 0
  %v1943 = add i64 %v1942, %v1941
  %v1944 = getelementptr double, ptr %v800, i64 %v1943
  %v1945 = load double, ptr %v1944, align 8, !noalias !210
  store double %v1945, ptr %v783, align 8, !noalias !210
  br label %v1946

v1947:
  %v1948 = phi i64 [ 0, %v1949 ], [ %v1950, %v1947 ]
  %v1951 = mul i64 %v1948, %v197
  %v1952 = getelementptr double, ptr %v194, i64 %v1951
  %v1953 = getelementptr i8, ptr %v1952, i64 %v748
  %v1954 = load double, ptr %v1953, align 8, !noalias !229
  %v1955 = fadd double %v1954, 0.000000e+00
  %v1956 = fmul double %v1957, %v1955
  %v1958 = getelementptr i8, ptr %v1952, i64 %v749
  %v1959 = load double, ptr %v1958, align 8, !noalias !229
  %v1960 = fadd double %v1959, %v1956
  %v1961 = fmul double %v1962, %v1960
  %v1963 = getelementptr i8, ptr %v1952, i64 %v750
  %v1964 = load double, ptr %v1963, align 8, !noalias !229
  %v1965 = fadd double %v1964, %v1961
  %v1966 = fmul double %v1957, %v1965
  %v1967 = getelementptr i8, ptr %v1952, i64 %v751
  %v1968 = load double, ptr %v1967, align 8, !noalias !229
  %v1969 = fadd double %v1968, %v1966
  %v1970 = fmul double %v1962, %v1969
  %v1971 = getelementptr i8, ptr %v1952, i64 %v752
  %v1972 = load double, ptr %v1971, align 8, !noalias !229
  %v1973 = fadd double %v1972, %v1970
  %v1974 = fmul double %v1957, %v1973
  %v1975 = getelementptr i8, ptr %v1952, i64 %v753
  %v1976 = load double, ptr %v1975, align 8, !noalias !229
  %v1977 = fadd double %v1976, %v1974
  %v1978 = fmul double %v1962, %v1977
  %v1979 = getelementptr i8, ptr %v1952, i64 %v754
  %v1980 = load double, ptr %v1979, align 8, !noalias !229
  %v1981 = fadd double %v1980, %v1978
  %v1982 = fmul double %v1957, %v1981
  %v1950 = add nsw i64 %v1948, 1
  %v1983 = load double, ptr %v1952, align 8, !noalias !229
  %v1984 = fadd double %v1983, %v1982
  %v1985 = getelementptr double, ptr %v745, i64 %v1951
  store double %v1984, ptr %v1985, align 8, !noalias !239
  %v1986 = icmp eq i64 %v10, %v1950
  br i1 %v1986, label %v1987, label %v1947

v1987:
  %v1988 = load i64, ptr %v747, align 8, !noalias !240
  %v1989 = inttoptr i64 %v1988 to ptr
  tail call void %v1989(ptr nonnull %v742, ptr %v786, ptr %v166, ptr %v173, ptr %v180, ptr %v788), !noalias !240
  br i1 %v831, label %v1990, label %v1991

v1991:
  %v1992 = phi i64 [ %v1993, %v1991 ], [ %v790, %v1987 ]
  %v1994 = phi i64 [ %v1995, %v1991 ], [ %v19, %v1987 ]
  %v1993 = add nsw i64 %v1992, -1
  %v1995 = add i64 %v1994, 1
  %v1996 = icmp slt i64 %v1994, 0
  %v1997 = select i1 %v1996, i64 %v208, i64 0
  %v1998 = add i64 %v1997, %v1994
  %v1999 = getelementptr double, ptr %v795, i64 %v1998
  %v2000 = load double, ptr %v1999, align 8, !noalias !243
  %v2001 = getelementptr double, ptr %v798, i64 %v1998
  store double %v2000, ptr %v2001, align 8, !noalias !243
  %v2002 = icmp sgt i64 %v1992, 1
  br i1 %v2002, label %v1991, label %v1990

v2003:
  br i1 %v2004, label %v2005, label %v2006

v2005:
  %v2007 = load double, ptr %v778, align 8, !noalias !210
  br label %v2006

v2006:
  %v2008 = phi double [ %v2007, %v2005 ], [ %v1957, %v2003 ]
  %v2009 = fmul double %v2008, 5.000000e-01
  %v2010 = icmp eq i64 %v2011, 45
  br i1 %v2010, label %v2012, label %v1946

v2013:
  %v2014 = getelementptr double, ptr %v795, i64 %v1943
  store double 0.000000e+00, ptr %v2014, align 8, !noalias !210
  br label %v2015

v2016:
  %v2017 = sub nsw i64 45, %v2018
  %v2019 = load double, ptr %v781, align 8, !noalias !244
  %v2020 = load double, ptr %v783, align 8, !noalias !244
  br label %v2021

v2021:
  %v2022 = phi double [ %v2023, %v2021 ], [ 1.000000e+00, %v2016 ]
  %v2024 = phi double [ %v2025, %v2021 ], [ 2.000000e+00, %v2016 ]
  %v2026 = phi i64 [ %v2027, %v2021 ], [ %v2017, %v2016 ]
  %v2028 = and i64 %v2026, 1
  %v2029 = icmp eq i64 %v2028, 0
  %v2030 = fmul double %v2022, %v2024
  %v2023 = select i1 %v2029, double %v2022, double %v2030
  %v2027 = lshr i64 %v2026, 1
  %v2025 = fmul double %v2024, %v2024
  %v2031 = icmp eq i64 %v2027, 0
  br i1 %v2031, label %v2032, label %v2021

v2033:
  %v2034 = fcmp olt double %v2035, 0.000000e+00
  %v2036 = select i1 %v2034, double 0.000000e+00, double %v2035
  %v2037 = fmul double %v2038, %v2036
  %v2039 = fsub double %v2040, %v2037
  br label %v2041

v2032:
  %v2042 = fadd double %v2043, %v2044
  %v2040 = fmul double %v2042, 5.000000e-01
  %v2045 = fmul double %v2023, 0x3D06849B86A12B9B
  %v2046 = fsub double %v2045, %v2047
  %v2035 = fmul double %v2046, 5.000000e-01
  %v2048 = fmul double %v2044, %v2020
  %v2049 = fmul double %v2043, %v2019
  %v2050 = fsub double %v2048, %v2049
  %v2051 = fsub double %v2020, %v2019
  %v2052 = fdiv double %v2050, %v2051
  %v2053 = fcmp olt double %v2044, %v2052
  %v2054 = fcmp olt double %v2052, %v2043
  %v2055 = and i1 %v2053, %v2054
  %v2056 = select i1 %v2055, double %v2052, double %v2040
  %v2057 = fsub double %v2040, %v2056
  %v2038 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v2057)
  %v2058 = fmul double %v2047, %v2047
  %v2059 = tail call double @llvm.fabs.f64(double %v2057)
  %v2060 = fcmp olt double %v2059, %v2058
  %v2061 = select i1 %v2060, double %v2059, double %v2058
  %v2062 = fmul double %v2038, %v2061
  %v2063 = fadd double %v2056, %v2062
  %v2064 = fsub double %v2063, %v2040
  %v2065 = tail call double @llvm.fabs.f64(double %v2064)
  %v2066 = fcmp ugt double %v2065, %v2035
  br i1 %v2066, label %v2033, label %v2041

v2067:
  store double %v2068, ptr %v778, align 8, !noalias !250
  store double %v2069, ptr %v783, align 8, !noalias !250
  br label %v2070

v2071:
  store double %v2068, ptr %v770, align 8, !noalias !250
  store double %v2069, ptr %v781, align 8, !noalias !250
  br label %v2070

v2070:
  %v2072 = icmp eq i64 %v2073, 45
  br i1 %v2072, label %v2074, label %v2015

v2015:
  %v2018 = phi i64 [ 0, %v2013 ], [ %v2073, %v2070 ]
  %v2073 = add nsw i64 %v2018, 1
  %v2043 = load double, ptr %v778, align 8, !noalias !250
  %v2044 = load double, ptr %v770, align 8, !noalias !250
  %v2047 = fsub double %v2043, %v2044
  %v2075 = fcmp ugt double %v2047, 0x3D06849B86A12B9B
  br i1 %v2075, label %v2016, label %v2074

v2041:
  %v2068 = phi double [ %v2063, %v2032 ], [ %v2039, %v2033 ]
  %v2076 = load double, ptr %v134, align 8, !noalias !251
  %v2077 = load double, ptr %v740, align 8, !noalias !251
  %v2078 = fmul double %v2068, %v2077
  %v2079 = fadd double %v2076, %v2078
  store double %v2079, ptr %v742, align 8, !noalias !251
  br i1 %v784, label %v2080, label %v2081

v2080:
  %v2082 = fsub double 1.000000e+00, %v2068
  br label %v2083

v2083:
  %v2084 = phi i64 [ 0, %v2080 ], [ %v2085, %v2083 ]
  %v2086 = mul i64 %v2084, %v197
  %v2087 = getelementptr double, ptr %v194, i64 %v2086
  %v2088 = getelementptr i8, ptr %v2087, i64 %v748
  %v2089 = load double, ptr %v2088, align 8, !noalias !258
  %v2090 = fadd double %v2089, 0.000000e+00
  %v2091 = fmul double %v2068, %v2090
  %v2092 = getelementptr i8, ptr %v2087, i64 %v749
  %v2093 = load double, ptr %v2092, align 8, !noalias !258
  %v2094 = fadd double %v2093, %v2091
  %v2095 = fmul double %v2082, %v2094
  %v2096 = getelementptr i8, ptr %v2087, i64 %v750
  %v2097 = load double, ptr %v2096, align 8, !noalias !258
  %v2098 = fadd double %v2097, %v2095
  %v2099 = fmul double %v2068, %v2098
  %v2100 = getelementptr i8, ptr %v2087, i64 %v751
  %v2101 = load double, ptr %v2100, align 8, !noalias !258
  %v2102 = fadd double %v2101, %v2099
  %v2103 = fmul double %v2082, %v2102
  %v2104 = getelementptr i8, ptr %v2087, i64 %v752
  %v2105 = load double, ptr %v2104, align 8, !noalias !258
  %v2106 = fadd double %v2105, %v2103
  %v2107 = fmul double %v2068, %v2106
  %v2108 = getelementptr i8, ptr %v2087, i64 %v753
  %v2109 = load double, ptr %v2108, align 8, !noalias !258
  %v2110 = fadd double %v2109, %v2107
  %v2111 = fmul double %v2082, %v2110
  %v2112 = getelementptr i8, ptr %v2087, i64 %v754
  %v2113 = load double, ptr %v2112, align 8, !noalias !258
  %v2114 = fadd double %v2113, %v2111
  %v2115 = fmul double %v2068, %v2114
  %v2085 = add nsw i64 %v2084, 1
  %v2116 = load double, ptr %v2087, align 8, !noalias !258
  %v2117 = fadd double %v2116, %v2115
  %v2118 = getelementptr double, ptr %v745, i64 %v2086
  store double %v2117, ptr %v2118, align 8, !noalias !251
  %v2119 = icmp eq i64 %v10, %v2085
  br i1 %v2119, label %v2081, label %v2083

v2081:
  %v2120 = load i64, ptr %v747, align 8, !noalias !262
  %v2121 = inttoptr i64 %v2120 to ptr
  tail call void %v2121(ptr nonnull %v742, ptr %v786, ptr %v166, ptr %v173, ptr %v180, ptr %v788), !noalias !262
  br i1 %v791, label %v2122, label %v2123

v2122:
  %v2124 = phi i64 [ %v2125, %v2122 ], [ %v790, %v2081 ]
  %v2126 = phi i64 [ %v2127, %v2122 ], [ %v19, %v2081 ]
  %v2125 = add nsw i64 %v2124, -1
  %v2127 = add i64 %v2126, 1
  %v2128 = icmp slt i64 %v2126, 0
  %v2129 = select i1 %v2128, i64 %v208, i64 0
  %v2130 = add i64 %v2129, %v2126
  %v2131 = getelementptr double, ptr %v795, i64 %v2130
  %v2132 = load double, ptr %v2131, align 8, !noalias !265
  %v2133 = getelementptr double, ptr %v798, i64 %v2130
  store double %v2132, ptr %v2133, align 8, !noalias !265
  %v2134 = icmp sgt i64 %v2124, 1
  br i1 %v2134, label %v2122, label %v2123

v2123:
  br i1 %v799, label %v2135, label %v2136

v2136:
  %v2137 = phi double [ %v2138, %v2136 ], [ 0x7FF0000000000000, %v2123 ]
  %v2139 = phi i64 [ %v2140, %v2136 ], [ 0, %v2123 ]
  %v2140 = add nsw i64 %v2139, 1
  %v2141 = getelementptr double, ptr %v800, i64 %v2139
  %v2142 = load double, ptr %v2141, align 8, !noalias !266
  %v2143 = getelementptr double, ptr %v798, i64 %v2139
  %v2144 = load double, ptr %v2143, align 8, !noalias !266
  %v2145 = fadd double %v2142, %v2144
  %v2146 = fcmp olt double %v2145, %v2137
  %v2138 = select i1 %v2146, double %v2145, double %v2137
  %v2147 = icmp eq i64 %v208, %v2140
  br i1 %v2147, label %v2135, label %v2136

v2135:
  %v2069 = phi double [ 0x7FF0000000000000, %v2123 ], [ %v2138, %v2136 ]
  %v2148 = fcmp olt double %v2069, 0.000000e+00
  br i1 %v2148, label %v2067, label %v2071

v2012:
  store double 0.000000e+00, ptr %v778, align 8, !noalias !210
  br label %v2074

v2074:
  %v2149 = load double, ptr %v134, align 8, !noalias !210
  %v2150 = load double, ptr %v778, align 8, !noalias !210
  %v2151 = load double, ptr %v740, align 8, !noalias !210
  %v2152 = fmul double %v2150, %v2151
  %v2153 = fadd double %v2149, %v2152
  %v2154 = load i64, ptr %v143, align 8, !noalias !270
  %v2155 = load i64, ptr %v833, align 8, !noalias !270
  %v2156 = icmp slt i64 %v2155, %v94
  br i1 %v2156, label %v2157, label %v2158

v2157:
  %v2159 = icmp slt i64 %v2155, 0
  %v2160 = select i1 %v2159, i64 %v94, i64 0
  %v2161 = getelementptr double, ptr %v93, i64 %v2155
  %v2162 = getelementptr double, ptr %v2161, i64 %v2160
  %v2163 = load double, ptr %v2162, align 8, !noalias !270
  %v2164 = fcmp ugt double %v2163, %v2153
  br i1 %v2164, label %v2158, label %v2165

v2165:
  %v2166 = icmp slt i64 %v2154, 0
  %v2167 = select i1 %v2166, i64 %v101, i64 0
  %v2168 = add i64 %v2167, %v2154
  %v2169 = mul i64 %v836, %v2168
  %v2170 = getelementptr double, ptr %v100, i64 %v2169
  br label %v2171

v2171:
  %v2172 = phi i64 [ %v2173, %v2174 ], [ %v2155, %v2165 ]
  %v2175 = icmp slt i64 %v2172, 0
  %v2176 = select i1 %v2175, i64 %v94, i64 0
  %v2177 = getelementptr double, ptr %v93, i64 %v2172
  %v2178 = getelementptr double, ptr %v2177, i64 %v2176
  %v2179 = load double, ptr %v2178, align 8, !noalias !270
  %v2180 = load double, ptr %v134, align 8, !noalias !270
  %v2181 = fsub double %v2179, %v2180
  %v2182 = load double, ptr %v740, align 8, !noalias !270
  %v2183 = fdiv double %v2181, %v2182
  br i1 %v744, label %v2184, label %v2185

v2185:
  %v2186 = fsub double 1.000000e+00, %v2183
  %v2187 = select i1 %v2175, i64 %v102, i64 0
  %v2188 = add i64 %v2187, %v2172
  %v2189 = mul i64 %v2188, %v103
  %v2190 = getelementptr double, ptr %v2170, i64 %v2189
  br label %v2191

v2192:
  %v2193 = getelementptr double, ptr %v838, i64 %v2194
  %v2195 = load double, ptr %v2193, align 8, !noalias !270
  br label %v2196

v2184:
  store double 0x7FF0000000000000, ptr %v835, align 8, !noalias !270
  %v2197 = icmp eq i64 %v2172, %v839
  br i1 %v2197, label %v2158, label %v2174

v2174:
  %v2173 = add i64 %v2172, 1
  %v2198 = icmp slt i64 %v2172, -1
  %v2199 = select i1 %v2198, i64 %v94, i64 0
  %v2200 = getelementptr double, ptr %v93, i64 %v2173
  %v2201 = getelementptr double, ptr %v2200, i64 %v2199
  %v2202 = load double, ptr %v2201, align 8, !noalias !270
  %v2203 = fcmp ugt double %v2202, %v2153
  br i1 %v2203, label %v2158, label %v2171

v2158:
  %v2204 = phi i64 [ %v2155, %v2157 ], [ %v2155, %v2074 ], [ %v94, %v2184 ], [ %v2173, %v2174 ]
  store i64 %v2204, ptr %v833, align 8, !noalias !270
  store i64 %v1941, ptr %v841, align 8, !noalias !210
  %v2205 = load i64, ptr %v143, align 8, !noalias !274
  %v2206 = icmp sgt i64 %v2205, -1
  br i1 %v2206, label %v2207, label %v2208

v2196:
  %v2209 = phi double [ %v2210, %v2211 ], [ %v2195, %v2192 ]
  %v2212 = getelementptr double, ptr %v2190, i64 %v2213
  store double %v2209, ptr %v2212, align 8, !noalias !270
  %v2214 = icmp eq i64 %v10, %v2215
  br i1 %v2214, label %v2184, label %v2191

v2191:
  %v2213 = phi i64 [ 0, %v2185 ], [ %v2215, %v2196 ]
  %v2215 = add nsw i64 %v2213, 1
  %v2216 = load double, ptr %v2178, align 8, !noalias !270
  %v2217 = load double, ptr %v774, align 8, !noalias !270
  %v2218 = fcmp oeq double %v2216, %v2217
  %v2194 = mul i64 %v2213, %v197
  br i1 %v2218, label %v2192, label %v2211

v2211:
  %v2219 = getelementptr double, ptr %v194, i64 %v2194
  %v2220 = getelementptr i8, ptr %v2219, i64 %v748
  %v2221 = load double, ptr %v2220, align 8, !noalias !277
  %v2222 = fadd double %v2221, 0.000000e+00
  %v2223 = fmul double %v2183, %v2222
  %v2224 = getelementptr i8, ptr %v2219, i64 %v749
  %v2225 = load double, ptr %v2224, align 8, !noalias !277
  %v2226 = fadd double %v2225, %v2223
  %v2227 = fmul double %v2186, %v2226
  %v2228 = getelementptr i8, ptr %v2219, i64 %v750
  %v2229 = load double, ptr %v2228, align 8, !noalias !277
  %v2230 = fadd double %v2229, %v2227
  %v2231 = fmul double %v2183, %v2230
  %v2232 = getelementptr i8, ptr %v2219, i64 %v751
  %v2233 = load double, ptr %v2232, align 8, !noalias !277
  %v2234 = fadd double %v2233, %v2231
  %v2235 = fmul double %v2186, %v2234
  %v2236 = getelementptr i8, ptr %v2219, i64 %v752
  %v2237 = load double, ptr %v2236, align 8, !noalias !277
  %v2238 = fadd double %v2237, %v2235
  %v2239 = fmul double %v2183, %v2238
  %v2240 = getelementptr i8, ptr %v2219, i64 %v753
  %v2241 = load double, ptr %v2240, align 8, !noalias !277
  %v2242 = fadd double %v2241, %v2239
  %v2243 = fmul double %v2186, %v2242
  %v2244 = getelementptr i8, ptr %v2219, i64 %v754
  %v2245 = load double, ptr %v2244, align 8, !noalias !277
  %v2246 = fadd double %v2245, %v2243
  %v2247 = fmul double %v2183, %v2246
  %v2248 = load double, ptr %v2219, align 8, !noalias !277
  %v2210 = fadd double %v2248, %v2247
  br label %v2196

v1927:
  %v2249 = phi i64 [ %v2250, %v2251 ], [ 0, %v1926 ]
  %v2252 = phi i64 [ %v2253, %v2251 ], [ %v830, %v1926 ]
  %v2254 = icmp sgt i64 %v2252, 0
  br i1 %v2254, label %v2251, label %v2255

v2251:
  %v2253 = add nsw i64 %v2252, -1
  %v2250 = add i64 %v2249, 1
  %v2256 = getelementptr double, ptr %v800, i64 %v2249
  %v2257 = load double, ptr %v2256, align 8, !noalias !281
  %v2258 = getelementptr double, ptr %v798, i64 %v2249
  %v2259 = load double, ptr %v2258, align 8, !noalias !281
  %v2260 = fneg double %v2259
  %v2261 = fcmp olt double %v2257, %v2260
  br i1 %v2261, label %v2255, label %v1927

v2255:
  %v1941 = phi i64 [ %v2249, %v2251 ], [ -1, %v1927 ]
  %v2262 = icmp slt i64 %v1941, %v19
  br i1 %v2262, label %v2263, label %v1939

v1946:
  %v1957 = phi double [ %v1733, %v1939 ], [ %v2009, %v2006 ]
  %v2264 = phi i64 [ 0, %v1939 ], [ %v2011, %v2006 ]
  %v2011 = add nsw i64 %v2264, 1
  %v2004 = icmp eq i64 %v2264, 0
  %v2265 = load double, ptr %v134, align 8, !noalias !239
  %v2266 = load double, ptr %v740, align 8, !noalias !239
  %v2267 = fmul double %v1957, %v2266
  %v2268 = fadd double %v2265, %v2267
  store double %v2268, ptr %v742, align 8, !noalias !239
  br i1 %v744, label %v1987, label %v1949

v1949:
  %v1962 = fsub double 1.000000e+00, %v1957
  br label %v1947

v1990:
  store double %v1957, ptr %v770, align 8, !noalias !210
  %v2269 = load double, ptr %v1944, align 8, !noalias !210
  store double %v2269, ptr %v781, align 8, !noalias !210
  %v2270 = fcmp ogt double %v2269, 0.000000e+00
  br i1 %v2270, label %v2013, label %v2003

v2207:
  %v2271 = getelementptr i64, ptr %v111, i64 %v2205
  %v2272 = load i64, ptr %v2271, align 8, !noalias !274
  %v2273 = icmp eq i64 %v2272, 0
  br i1 %v2273, label %v2274, label %v2208

v2274:
  store i64 4, ptr %v2271, align 8, !noalias !274
  br label %v2208

v2208:
  store double 0.000000e+00, ptr %v843, align 8, !noalias !210
  br label %v2275

v2276:
  br i1 %v1742, label %v2263, label %v2277

v2277:
  call void @llvm.lifetime.start.p0(ptr nonnull %v287), !noalias !180
  call void @llvm.lifetime.start.p0(ptr nonnull %v288), !noalias !180
  store i8 0, ptr %v287, align 1, !noalias !285
  store ptr null, ptr %v288, align 8, !noalias !285
  %v2278 = load double, ptr %v770, align 8, !noalias !285
  %v2279 = load double, ptr %v778, align 8, !noalias !285
  br i1 %v292, label %v2280, label %v2281

v2282:
  %v2283 = phi i64 [ %v2284, %v2285 ], [ 0, %v2286 ]
  %v2284 = add nsw i64 %v2283, 1
  %v2287 = icmp ult i64 %v2283, 9
  br i1 %v2287, label %v2288, label %v2289

v2288:
  %v2290 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v2283
  %v2291 = load double, ptr %v2290, align 8
  %v2292 = load double, ptr %v134, align 8, !noalias !289
  %v2293 = load double, ptr %v740, align 8, !noalias !289
  %v2294 = fmul double %v2291, %v2293
  %v2295 = fadd double %v2292, %v2294
  store double %v2295, ptr %v742, align 8, !noalias !289
  br i1 %v784, label %v2296, label %v2285

v2296:
  %v2297 = fsub double 1.000000e+00, %v2291
  br label %v2298

v2298:
  %v2299 = phi i64 [ 0, %v2296 ], [ %v2300, %v2298 ]
  %v2301 = mul i64 %v2299, %v197
  %v2302 = getelementptr double, ptr %v194, i64 %v2301
  %v2303 = getelementptr i8, ptr %v2302, i64 %v748
  %v2304 = load double, ptr %v2303, align 8, !noalias !296
  %v2305 = fadd double %v2304, 0.000000e+00
  %v2306 = fmul double %v2291, %v2305
  %v2307 = getelementptr i8, ptr %v2302, i64 %v749
  %v2308 = load double, ptr %v2307, align 8, !noalias !296
  %v2309 = fadd double %v2308, %v2306
  %v2310 = fmul double %v2297, %v2309
  %v2311 = getelementptr i8, ptr %v2302, i64 %v750
  %v2312 = load double, ptr %v2311, align 8, !noalias !296
  %v2313 = fadd double %v2312, %v2310
  %v2314 = fmul double %v2291, %v2313
  %v2315 = getelementptr i8, ptr %v2302, i64 %v751
  %v2316 = load double, ptr %v2315, align 8, !noalias !296
  %v2317 = fadd double %v2316, %v2314
  %v2318 = fmul double %v2297, %v2317
  %v2319 = getelementptr i8, ptr %v2302, i64 %v752
  %v2320 = load double, ptr %v2319, align 8, !noalias !296
  %v2321 = fadd double %v2320, %v2318
  %v2322 = fmul double %v2291, %v2321
  %v2323 = getelementptr i8, ptr %v2302, i64 %v753
  %v2324 = load double, ptr %v2323, align 8, !noalias !296
  %v2325 = fadd double %v2324, %v2322
  %v2326 = fmul double %v2297, %v2325
  %v2327 = getelementptr i8, ptr %v2302, i64 %v754
  %v2328 = load double, ptr %v2327, align 8, !noalias !296
  %v2329 = fadd double %v2328, %v2326
  %v2330 = fmul double %v2291, %v2329
  %v2300 = add nsw i64 %v2299, 1
  %v2331 = load double, ptr %v2302, align 8, !noalias !296
  %v2332 = fadd double %v2331, %v2330
  %v2333 = getelementptr double, ptr %v745, i64 %v2301
  store double %v2332, ptr %v2333, align 8, !noalias !289
  %v2334 = icmp eq i64 %v10, %v2300
  br i1 %v2334, label %v2285, label %v2298

v2285:
  %v2335 = icmp eq i64 %v2283, 8
  %v2336 = select i1 %v2335, i64 17, i64 16
  %v2337 = mul i64 %v2283, %v746
  %v2338 = load i64, ptr %v747, align 8, !noalias !300
  %v2339 = mul nsw i64 %v2336, %v10
  %v2340 = getelementptr double, ptr %v159, i64 %v2339
  %v2341 = getelementptr double, ptr %v187, i64 %v2337
  %v2342 = inttoptr i64 %v2338 to ptr
  tail call void %v2342(ptr nonnull %v742, ptr %v2340, ptr %v166, ptr %v173, ptr %v180, ptr %v2341), !noalias !300
  %v2343 = icmp eq i64 %v2284, 9
  br i1 %v2343, label %v2289, label %v2282

v2289:
  %v2344 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v2282 ], [ %v2345, %v2285 ]
  %v2346 = phi i32 [ 1, %v2282 ], [ 0, %v2285 ]
  br i1 %v2287, label %v2347, label %v2348, !prof !131

v2349:
  %v2350 = load double, ptr %v820, align 8, !noalias !285
  %v2351 = fcmp ogt double %v2350, 5.000000e-01
  br i1 %v2351, label %v2352, label %v2353

v2352:
  %v2354 = load i64, ptr %v6, align 8, !noalias !303
  %v2355 = inttoptr i64 %v2354 to ptr
  tail call void %v2355(ptr nonnull %v774, ptr %v825, ptr %v166, ptr %v173, ptr %v180, ptr %v827), !noalias !303
  %v2356 = load double, ptr %v774, align 8, !noalias !285
  store double %v2356, ptr %v776, align 8, !noalias !285
  br label %v2357

v2358:
  %v2359 = sub nsw i64 45, %v2360
  %v2361 = load double, ptr %v781, align 8, !noalias !306
  %v2362 = load double, ptr %v783, align 8, !noalias !306
  br label %v2363

v2363:
  %v2364 = phi double [ %v2365, %v2363 ], [ 1.000000e+00, %v2358 ]
  %v2366 = phi double [ %v2367, %v2363 ], [ 2.000000e+00, %v2358 ]
  %v2368 = phi i64 [ %v2369, %v2363 ], [ %v2359, %v2358 ]
  %v2370 = and i64 %v2368, 1
  %v2371 = icmp eq i64 %v2370, 0
  %v2372 = fmul double %v2364, %v2366
  %v2365 = select i1 %v2371, double %v2364, double %v2372
  %v2369 = lshr i64 %v2368, 1
  %v2367 = fmul double %v2366, %v2366
  %v2373 = icmp eq i64 %v2369, 0
  br i1 %v2373, label %v2374, label %v2363

v2375:
  %v2376 = fcmp olt double %v2377, 0.000000e+00
  %v2378 = select i1 %v2376, double 0.000000e+00, double %v2377
  %v2379 = fmul double %v2380, %v2378
  %v2381 = fsub double %v2382, %v2379
  br label %v2383

v2374:
  %v2384 = fadd double %v2385, %v2386
  %v2382 = fmul double %v2384, 5.000000e-01
  %v2387 = fmul double %v2365, 1.000000e-13
  %v2388 = fsub double %v2387, %v2389
  %v2377 = fmul double %v2388, 5.000000e-01
  %v2390 = fmul double %v2386, %v2362
  %v2391 = fmul double %v2385, %v2361
  %v2392 = fsub double %v2390, %v2391
  %v2393 = fsub double %v2362, %v2361
  %v2394 = fdiv double %v2392, %v2393
  %v2395 = fcmp olt double %v2386, %v2394
  %v2396 = fcmp olt double %v2394, %v2385
  %v2397 = and i1 %v2395, %v2396
  %v2398 = select i1 %v2397, double %v2394, double %v2382
  %v2399 = fsub double %v2382, %v2398
  %v2380 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v2399)
  %v2400 = fmul double %v2389, %v2389
  %v2401 = tail call double @llvm.fabs.f64(double %v2399)
  %v2402 = fcmp olt double %v2401, %v2400
  %v2403 = select i1 %v2402, double %v2401, double %v2400
  %v2404 = fmul double %v2380, %v2403
  %v2405 = fadd double %v2398, %v2404
  %v2406 = fsub double %v2405, %v2382
  %v2407 = tail call double @llvm.fabs.f64(double %v2406)
  %v2408 = fcmp ugt double %v2407, %v2377
  br i1 %v2408, label %v2375, label %v2383

v2409:
  store double %v2410, ptr %v778, align 8, !noalias !312
  store double %v2411, ptr %v783, align 8, !noalias !312
  br label %v2412

v2413:
  store double %v2410, ptr %v770, align 8, !noalias !312
  store double %v2411, ptr %v781, align 8, !noalias !312
  br label %v2412

v2412:
  %v2414 = icmp eq i64 %v2415, 45
  br i1 %v2414, label %v2416, label %v2417

v2417:
  %v2360 = phi i64 [ %v2415, %v2412 ], [ 0, %v2418 ]
  %v2415 = add nsw i64 %v2360, 1
  %v2385 = load double, ptr %v778, align 8, !noalias !312
  %v2386 = load double, ptr %v770, align 8, !noalias !312
  %v2389 = fsub double %v2385, %v2386
  %v2419 = fcmp ugt double %v2389, 1.000000e-13
  br i1 %v2419, label %v2358, label %v2416

v2383:
  %v2410 = phi double [ %v2405, %v2374 ], [ %v2381, %v2375 ]
  %v2420 = load double, ptr %v134, align 8, !noalias !313
  %v2421 = load double, ptr %v740, align 8, !noalias !313
  %v2422 = fmul double %v2410, %v2421
  %v2423 = fadd double %v2420, %v2422
  store double %v2423, ptr %v742, align 8, !noalias !313
  br i1 %v784, label %v2424, label %v2425

v2424:
  %v2426 = fsub double 1.000000e+00, %v2410
  br label %v2427

v2427:
  %v2428 = phi i64 [ 0, %v2424 ], [ %v2429, %v2427 ]
  %v2430 = mul i64 %v2428, %v197
  %v2431 = getelementptr double, ptr %v194, i64 %v2430
  %v2432 = getelementptr i8, ptr %v2431, i64 %v748
  %v2433 = load double, ptr %v2432, align 8, !noalias !320
  %v2434 = fadd double %v2433, 0.000000e+00
  %v2435 = fmul double %v2410, %v2434
  %v2436 = getelementptr i8, ptr %v2431, i64 %v749
  %v2437 = load double, ptr %v2436, align 8, !noalias !320
  %v2438 = fadd double %v2437, %v2435
  %v2439 = fmul double %v2426, %v2438
  %v2440 = getelementptr i8, ptr %v2431, i64 %v750
  %v2441 = load double, ptr %v2440, align 8, !noalias !320
  %v2442 = fadd double %v2441, %v2439
  %v2443 = fmul double %v2410, %v2442
  %v2444 = getelementptr i8, ptr %v2431, i64 %v751
  %v2445 = load double, ptr %v2444, align 8, !noalias !320
  %v2446 = fadd double %v2445, %v2443
  %v2447 = fmul double %v2426, %v2446
  %v2448 = getelementptr i8, ptr %v2431, i64 %v752
  %v2449 = load double, ptr %v2448, align 8, !noalias !320
  %v2450 = fadd double %v2449, %v2447
  %v2451 = fmul double %v2410, %v2450
  %v2452 = getelementptr i8, ptr %v2431, i64 %v753
  %v2453 = load double, ptr %v2452, align 8, !noalias !320
  %v2454 = fadd double %v2453, %v2451
  %v2455 = fmul double %v2426, %v2454
  %v2456 = getelementptr i8, ptr %v2431, i64 %v754
  %v2457 = load double, ptr %v2456, align 8, !noalias !320
  %v2458 = fadd double %v2457, %v2455
  %v2459 = fmul double %v2410, %v2458
  %v2429 = add nsw i64 %v2428, 1
  %v2460 = load double, ptr %v2431, align 8, !noalias !320
  %v2461 = fadd double %v2460, %v2459
  %v2462 = getelementptr double, ptr %v745, i64 %v2430
  store double %v2461, ptr %v2462, align 8, !noalias !313
  %v2463 = icmp eq i64 %v10, %v2429
  br i1 %v2463, label %v2425, label %v2427

v2425:
  %v2464 = load i64, ptr %v747, align 8, !noalias !324
  %v2465 = inttoptr i64 %v2464 to ptr
  tail call void %v2465(ptr nonnull %v742, ptr %v786, ptr %v166, ptr %v173, ptr %v180, ptr %v788), !noalias !324
  br i1 %v791, label %v2466, label %v2467

v2466:
  %v2468 = phi i64 [ %v2469, %v2466 ], [ %v790, %v2425 ]
  %v2470 = phi i64 [ %v2471, %v2466 ], [ %v19, %v2425 ]
  %v2469 = add nsw i64 %v2468, -1
  %v2471 = add i64 %v2470, 1
  %v2472 = icmp slt i64 %v2470, 0
  %v2473 = select i1 %v2472, i64 %v208, i64 0
  %v2474 = add i64 %v2473, %v2470
  %v2475 = getelementptr double, ptr %v795, i64 %v2474
  %v2476 = load double, ptr %v2475, align 8, !noalias !327
  %v2477 = getelementptr double, ptr %v798, i64 %v2474
  store double %v2476, ptr %v2477, align 8, !noalias !327
  %v2478 = icmp sgt i64 %v2468, 1
  br i1 %v2478, label %v2466, label %v2467

v2467:
  br i1 %v799, label %v2479, label %v2480

v2480:
  %v2481 = phi double [ %v2482, %v2480 ], [ 0x7FF0000000000000, %v2467 ]
  %v2483 = phi i64 [ %v2484, %v2480 ], [ 0, %v2467 ]
  %v2484 = add nsw i64 %v2483, 1
  %v2485 = getelementptr double, ptr %v800, i64 %v2483
  %v2486 = load double, ptr %v2485, align 8, !noalias !328
  %v2487 = getelementptr double, ptr %v798, i64 %v2483
  %v2488 = load double, ptr %v2487, align 8, !noalias !328
  %v2489 = fadd double %v2486, %v2488
  %v2490 = fcmp olt double %v2489, %v2481
  %v2482 = select i1 %v2490, double %v2489, double %v2481
  %v2491 = icmp eq i64 %v208, %v2484
  br i1 %v2491, label %v2479, label %v2480

v2479:
  %v2411 = phi double [ 0x7FF0000000000000, %v2467 ], [ %v2482, %v2480 ]
  %v2492 = fcmp olt double %v2411, 0.000000e+00
  br i1 %v2492, label %v2409, label %v2413

v2416:
  %v2493 = icmp ugt i64 %v2494, 1
  br i1 %v2493, label %v2495, label %v2353

v2353:
  br i1 %v821, label %v2496, label %v2497

v2496:
  %v2498 = load i64, ptr %v811, align 8, !noalias !332
  %v2499 = inttoptr i64 %v2498 to ptr
  tail call void %v2499(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !332
  store double %v2278, ptr %v770, align 8, !noalias !285
  store double %v2279, ptr %v778, align 8, !noalias !285
  br label %v2357

v2497:
  %v2500 = phi i64 [ %v2501, %v2497 ], [ 0, %v2353 ]
  %v2501 = add nsw i64 %v2500, 1
  %v2502 = add nsw i64 %v2500, %v18
  %v2503 = icmp slt i64 %v2502, 0
  %v2504 = select i1 %v2503, i64 %v167, i64 0
  %v2505 = getelementptr double, ptr %v166, i64 %v2502
  %v2506 = getelementptr double, ptr %v2505, i64 %v2504
  %v2507 = load double, ptr %v2506, align 8, !noalias !338
  %v2508 = getelementptr double, ptr %v823, i64 %v2500
  %v2509 = load double, ptr %v2508, align 8, !noalias !338
  store double %v2509, ptr %v2506, align 8, !noalias !338
  store double %v2507, ptr %v2508, align 8, !noalias !338
  %v2510 = icmp eq i64 %v19, %v2501
  br i1 %v2510, label %v2496, label %v2497

v2280:
  %v2511 = phi i64 [ %v2512, %v2280 ], [ 0, %v2277 ]
  %v2512 = add nsw i64 %v2511, 1
  %v2513 = add nsw i64 %v2511, %v18
  %v2514 = icmp slt i64 %v2513, 0
  %v2515 = select i1 %v2514, i64 %v167, i64 0
  %v2516 = getelementptr double, ptr %v166, i64 %v2513
  %v2517 = getelementptr double, ptr %v2516, i64 %v2515
  %v2518 = load double, ptr %v2517, align 8, !noalias !285
  %v2519 = getelementptr double, ptr %v802, i64 %v2511
  store double %v2518, ptr %v2519, align 8, !noalias !285
  %v2520 = icmp eq i64 %v19, %v2512
  br i1 %v2520, label %v2281, label %v2280

v2281:
  br label %v2495

v2495:
  %v2345 = phi ptr [ %v2344, %v2416 ], [ null, %v2281 ]
  %v2521 = phi ptr [ %v2522, %v2416 ], [ null, %v2281 ]
  %v2494 = phi i64 [ %v2523, %v2416 ], [ 32, %v2281 ]
  %v2523 = add nsw i64 %v2494, -1
  %v2524 = load double, ptr %v778, align 8, !noalias !339
  %v2525 = load double, ptr %v134, align 8, !noalias !343
  %v2526 = load double, ptr %v740, align 8, !noalias !343
  %v2527 = fmul double %v2524, %v2526
  %v2528 = fadd double %v2525, %v2527
  store double %v2528, ptr %v742, align 8, !noalias !343
  br i1 %v784, label %v2529, label %v2530

v2529:
  %v2531 = fsub double 1.000000e+00, %v2524
  br label %v2532

v2532:
  %v2533 = phi i64 [ 0, %v2529 ], [ %v2534, %v2532 ]
  %v2535 = mul i64 %v2533, %v197
  %v2536 = getelementptr double, ptr %v194, i64 %v2535
  %v2537 = getelementptr i8, ptr %v2536, i64 %v748
  %v2538 = load double, ptr %v2537, align 8, !noalias !350
  %v2539 = fadd double %v2538, 0.000000e+00
  %v2540 = fmul double %v2524, %v2539
  %v2541 = getelementptr i8, ptr %v2536, i64 %v749
  %v2542 = load double, ptr %v2541, align 8, !noalias !350
  %v2543 = fadd double %v2542, %v2540
  %v2544 = fmul double %v2531, %v2543
  %v2545 = getelementptr i8, ptr %v2536, i64 %v750
  %v2546 = load double, ptr %v2545, align 8, !noalias !350
  %v2547 = fadd double %v2546, %v2544
  %v2548 = fmul double %v2524, %v2547
  %v2549 = getelementptr i8, ptr %v2536, i64 %v751
  %v2550 = load double, ptr %v2549, align 8, !noalias !350
  %v2551 = fadd double %v2550, %v2548
  %v2552 = fmul double %v2531, %v2551
  %v2553 = getelementptr i8, ptr %v2536, i64 %v752
  %v2554 = load double, ptr %v2553, align 8, !noalias !350
  %v2555 = fadd double %v2554, %v2552
  %v2556 = fmul double %v2524, %v2555
  %v2557 = getelementptr i8, ptr %v2536, i64 %v753
  %v2558 = load double, ptr %v2557, align 8, !noalias !350
  %v2559 = fadd double %v2558, %v2556
  %v2560 = fmul double %v2531, %v2559
  %v2561 = getelementptr i8, ptr %v2536, i64 %v754
  %v2562 = load double, ptr %v2561, align 8, !noalias !350
  %v2563 = fadd double %v2562, %v2560
  %v2564 = fmul double %v2524, %v2563
  %v2534 = add nsw i64 %v2533, 1
  %v2565 = load double, ptr %v2536, align 8, !noalias !350
  %v2566 = fadd double %v2565, %v2564
  %v2567 = getelementptr double, ptr %v805, i64 %v2535
  store double %v2566, ptr %v2567, align 8, !noalias !343
  %v2568 = icmp eq i64 %v10, %v2534
  br i1 %v2568, label %v2530, label %v2532

v2530:
  %v2569 = load i64, ptr %v747, align 8, !noalias !354
  %v2570 = inttoptr i64 %v2569 to ptr
  tail call void %v2570(ptr nonnull %v742, ptr %v786, ptr %v166, ptr %v173, ptr %v180, ptr %v788), !noalias !354
  br i1 %v791, label %v2571, label %v2572

v2571:
  %v2573 = phi i64 [ %v2574, %v2571 ], [ %v789, %v2530 ]
  %v2575 = phi i64 [ %v2576, %v2571 ], [ %v19, %v2530 ]
  %v2574 = add nsw i64 %v2573, -1
  %v2576 = add i64 %v2575, 1
  %v2577 = icmp slt i64 %v2575, 0
  %v2578 = select i1 %v2577, i64 %v208, i64 0
  %v2579 = add i64 %v2578, %v2575
  %v2580 = getelementptr double, ptr %v795, i64 %v2579
  %v2581 = load double, ptr %v2580, align 8, !noalias !357
  %v2582 = getelementptr double, ptr %v798, i64 %v2579
  store double %v2581, ptr %v2582, align 8, !noalias !357
  %v2583 = icmp sgt i64 %v2573, 1
  br i1 %v2583, label %v2571, label %v2572

v2572:
  br label %v2584

v2585:
  br label %v2586

v2586:
  %v2587 = phi double [ %v2524, %v2584 ], [ 1.000000e+00, %v2588 ], [ 8.889000e-01, %v2589 ], [ 2.500000e-01, %v2590 ], [ 3.333000e-01, %v2591 ], [ 5.000000e-01, %v2592 ], [ 0x3FE50A3D70A3D70A, %v2593 ], [ 7.500000e-01, %v2594 ], [ 0x3FB48E8A71DE69AD, %v2585 ]
  %v2595 = fcmp ult double %v2587, %v2524
  br i1 %v2595, label %v2596, label %v2597

v2597:
  %v2598 = load double, ptr %v134, align 8, !noalias !358
  %v2599 = load double, ptr %v740, align 8, !noalias !358
  %v2600 = fmul double %v2587, %v2599
  %v2601 = fadd double %v2598, %v2600
  store double %v2601, ptr %v742, align 8, !noalias !358
  br i1 %v784, label %v2602, label %v2603

v2602:
  %v2604 = fsub double 1.000000e+00, %v2587
  br label %v2605

v2605:
  %v2606 = phi i64 [ 0, %v2602 ], [ %v2607, %v2605 ]
  %v2608 = mul i64 %v2606, %v197
  %v2609 = getelementptr double, ptr %v194, i64 %v2608
  %v2610 = getelementptr i8, ptr %v2609, i64 %v748
  %v2611 = load double, ptr %v2610, align 8, !noalias !362
  %v2612 = fadd double %v2611, 0.000000e+00
  %v2613 = fmul double %v2587, %v2612
  %v2614 = getelementptr i8, ptr %v2609, i64 %v749
  %v2615 = load double, ptr %v2614, align 8, !noalias !362
  %v2616 = fadd double %v2615, %v2613
  %v2617 = fmul double %v2604, %v2616
  %v2618 = getelementptr i8, ptr %v2609, i64 %v750
  %v2619 = load double, ptr %v2618, align 8, !noalias !362
  %v2620 = fadd double %v2619, %v2617
  %v2621 = fmul double %v2587, %v2620
  %v2622 = getelementptr i8, ptr %v2609, i64 %v751
  %v2623 = load double, ptr %v2622, align 8, !noalias !362
  %v2624 = fadd double %v2623, %v2621
  %v2625 = fmul double %v2604, %v2624
  %v2626 = getelementptr i8, ptr %v2609, i64 %v752
  %v2627 = load double, ptr %v2626, align 8, !noalias !362
  %v2628 = fadd double %v2627, %v2625
  %v2629 = fmul double %v2587, %v2628
  %v2630 = getelementptr i8, ptr %v2609, i64 %v753
  %v2631 = load double, ptr %v2630, align 8, !noalias !362
  %v2632 = fadd double %v2631, %v2629
  %v2633 = fmul double %v2604, %v2632
  %v2634 = getelementptr i8, ptr %v2609, i64 %v754
  %v2635 = load double, ptr %v2634, align 8, !noalias !362
  %v2636 = fadd double %v2635, %v2633
  %v2637 = fmul double %v2587, %v2636
  %v2607 = add nsw i64 %v2606, 1
  %v2638 = load double, ptr %v2609, align 8, !noalias !362
  %v2639 = fadd double %v2638, %v2637
  %v2640 = getelementptr double, ptr %v745, i64 %v2608
  store double %v2639, ptr %v2640, align 8, !noalias !358
  %v2641 = icmp eq i64 %v10, %v2607
  br i1 %v2641, label %v2603, label %v2605

v2642:
  %v2643 = load i64, ptr %v811, align 8, !noalias !366
  %v2644 = inttoptr i64 %v2643 to ptr
  tail call void %v2644(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !366
  br label %v2596

v2645:
  %v2646 = phi i64 [ %v2647, %v2645 ], [ 0, %v2648 ]
  %v2647 = add nsw i64 %v2646, 1
  %v2649 = add nsw i64 %v2646, %v18
  %v2650 = icmp slt i64 %v2649, 0
  %v2651 = select i1 %v2650, i64 %v167, i64 0
  %v2652 = getelementptr double, ptr %v166, i64 %v2649
  %v2653 = getelementptr double, ptr %v2652, i64 %v2651
  %v2654 = load double, ptr %v2653, align 8, !noalias !372
  %v2655 = getelementptr double, ptr %v797, i64 %v2646
  %v2656 = load double, ptr %v2655, align 8, !noalias !372
  store double %v2656, ptr %v2653, align 8, !noalias !372
  store double %v2654, ptr %v2655, align 8, !noalias !372
  %v2657 = icmp eq i64 %v19, %v2647
  br i1 %v2657, label %v2642, label %v2645

v2596:
  %v2658 = icmp ugt i64 %v2659, 1
  br i1 %v2658, label %v2584, label %v2660

v2660:
  br i1 %v292, label %v2661, label %v2662

v2662:
  %v2663 = load i64, ptr %v811, align 8, !noalias !373
  %v2664 = inttoptr i64 %v2663 to ptr
  tail call void %v2664(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !373
  br label %v2665

v2661:
  %v2666 = phi i64 [ %v2667, %v2661 ], [ 0, %v2660 ]
  %v2667 = add nsw i64 %v2666, 1
  %v2668 = add nsw i64 %v2666, %v18
  %v2669 = icmp slt i64 %v2668, 0
  %v2670 = select i1 %v2669, i64 %v167, i64 0
  %v2671 = getelementptr double, ptr %v166, i64 %v2668
  %v2672 = getelementptr double, ptr %v2671, i64 %v2670
  %v2673 = load double, ptr %v2672, align 8, !noalias !379
  %v2674 = getelementptr double, ptr %v797, i64 %v2666
  %v2675 = load double, ptr %v2674, align 8, !noalias !379
  store double %v2675, ptr %v2672, align 8, !noalias !379
  store double %v2673, ptr %v2674, align 8, !noalias !379
  %v2676 = icmp eq i64 %v2667, %v19
  br i1 %v2676, label %v2662, label %v2661

v2584:
  %v2659 = phi i64 [ %v2677, %v2596 ], [ 9, %v2572 ]
  %v2678 = phi i64 [ %v2679, %v2596 ], [ 8, %v2572 ]
  %v2677 = add nsw i64 %v2659, -1
  %v2679 = add nsw i64 %v2678, -1
  switch i64 %v2678, label %v2665 [
    i64 0, label %v2586
    i64 -1, label %v2588
    i64 8, label %v2588
    i64 1, label %v2585
    i64 -8, label %v2585
    i64 2, label %v2590
    i64 -7, label %v2590
    i64 3, label %v2591
    i64 -6, label %v2591
    i64 4, label %v2592
    i64 -5, label %v2592
    i64 5, label %v2593
    i64 -4, label %v2593
    i64 6, label %v2594
    i64 -3, label %v2594
    i64 7, label %v2589
    i64 -2, label %v2589
  ]

v2590:
  br label %v2586

v2591:
  br label %v2586

v2592:
  br label %v2586

v2593:
  br label %v2586

v2594:
  br label %v2586

v2589:
  br label %v2586

v2588:
  br label %v2586

v2603:
  %v2680 = load i64, ptr %v6, align 8, !noalias !380
  %v2681 = inttoptr i64 %v2680 to ptr
  tail call void %v2681(ptr nonnull %v742, ptr %v808, ptr %v166, ptr %v173, ptr %v180, ptr %v810), !noalias !380
  br i1 %v292, label %v2682, label %v2683

v2683:
  %v2684 = load i64, ptr %v811, align 8, !noalias !383
  %v2685 = inttoptr i64 %v2684 to ptr
  tail call void %v2685(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !383
  %v2686 = load i64, ptr %v6, align 8, !noalias !389
  %v2687 = inttoptr i64 %v2686 to ptr
  tail call void %v2687(ptr nonnull %v742, ptr %v808, ptr %v166, ptr %v173, ptr %v180, ptr %v813), !noalias !389
  %v2688 = load double, ptr %v24, align 8, !noalias !392
  %v2689 = load double, ptr %v814, align 8, !noalias !392
  br label %v2690

v2682:
  %v2691 = phi i64 [ %v2692, %v2682 ], [ 0, %v2603 ]
  %v2692 = add nsw i64 %v2691, 1
  %v2693 = add nsw i64 %v2691, %v18
  %v2694 = icmp slt i64 %v2693, 0
  %v2695 = select i1 %v2694, i64 %v167, i64 0
  %v2696 = getelementptr double, ptr %v166, i64 %v2693
  %v2697 = getelementptr double, ptr %v2696, i64 %v2695
  %v2698 = load double, ptr %v2697, align 8, !noalias !396
  %v2699 = getelementptr double, ptr %v797, i64 %v2691
  %v2700 = load double, ptr %v2699, align 8, !noalias !396
  store double %v2700, ptr %v2697, align 8, !noalias !396
  store double %v2698, ptr %v2699, align 8, !noalias !396
  %v2701 = icmp eq i64 %v19, %v2692
  br i1 %v2701, label %v2683, label %v2682

v2690:
  %v2702 = phi i64 [ 0, %v2683 ], [ %v2703, %v2704 ]
  %v2705 = icmp eq i64 %v2702, %v803
  br i1 %v2705, label %v2648, label %v2704

v2648:
  br i1 %v292, label %v2645, label %v2642

v2704:
  %v2703 = add i64 %v2702, 1
  %v2706 = mul i64 %v2702, %v197
  %v2707 = getelementptr double, ptr %v816, i64 %v2706
  %v2708 = load double, ptr %v2707, align 8, !noalias !392
  %v2709 = getelementptr double, ptr %v818, i64 %v2706
  %v2710 = load double, ptr %v2709, align 8, !noalias !392
  %v2711 = fsub double %v2708, %v2710
  %v2712 = tail call double @llvm.fabs.f64(double %v2711)
  %v2713 = getelementptr double, ptr %v194, i64 %v2706
  %v2714 = load double, ptr %v2713, align 8, !noalias !392
  %v2715 = tail call double @llvm.fabs.f64(double %v2714)
  %v2716 = fmul double %v2688, %v2715
  %v2717 = fadd double %v2689, %v2716
  %v2718 = load double, ptr %v740, align 8, !noalias !392
  %v2719 = fmul double %v2718, %v2712
  %v2720 = fmul double %v2717, 1.000000e-01
  %v2721 = fcmp ugt double %v2719, %v2720
  br i1 %v2721, label %v2665, label %v2690

v2665:
  %v2722 = phi i1 [ false, %v2704 ], [ true, %v2662 ], [ true, %v2584 ]
  %v2522 = phi ptr [ %v2521, %v2704 ], [ %v2521, %v2662 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.30, %v2584 ]
  %v2723 = phi i1 [ true, %v2704 ], [ true, %v2662 ], [ false, %v2584 ]
  %v2724 = phi i32 [ 0, %v2704 ], [ 0, %v2662 ], [ 1, %v2584 ]
  br i1 %v2723, label %v2286, label %v2348, !prof !131

v2286:
  br i1 %v2722, label %v2282, label %v2353

v2347:
  %v2725 = load double, ptr %v778, align 8, !noalias !285
  store i8 0, ptr %v287, align 1, !noalias !285
  %v2726 = call fastcc i32 @_ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr %v287, ptr %v288, i64 %v13, ptr nonnull readonly %v93, i64 %v94, ptr %v125, i64 %v126, i64 %v127, ptr nonnull %v134, i64 %v136, ptr %v143, i64 %v145, ptr %v205, i64 %v206, i64 %v207, i64 %v208, double %v2725)
  %v2727 = icmp eq i32 %v2726, 0
  br i1 %v2727, label %v2418, label %v2728, !prof !131

v2728:
  %v2729 = load ptr, ptr %v288, align 8, !noalias !285
  br label %v2357

v2418:
  %v2730 = load i8, ptr %v287, align 1, !noalias !285
  %v2731 = icmp eq i8 %v2730, 0
  br i1 %v2731, label %v2349, label %v2417

v2348:
  %v2732 = phi ptr [ %v2344, %v2289 ], [ %v2522, %v2665 ]
  %v2733 = phi i32 [ %v2346, %v2289 ], [ %v2724, %v2665 ]
  %v2734 = icmp ne i32 %v2733, 0
  br label %v2357

v2357:
  %v2735 = phi i1 [ true, %v2352 ], [ false, %v2496 ], [ true, %v2728 ], [ %v2734, %v2348 ]
  %v2736 = phi ptr [ null, %v2352 ], [ null, %v2496 ], [ %v2729, %v2728 ], [ %v2732, %v2348 ]
  %v2737 = phi i1 [ false, %v2352 ], [ false, %v2496 ], [ true, %v2728 ], [ %v2734, %v2348 ]
  call void @llvm.lifetime.end.p0(ptr nonnull %v287), !noalias !180
  call void @llvm.lifetime.end.p0(ptr nonnull %v288), !noalias !180
  %v2738 = select i1 %v2737, ptr %v2736, ptr null, !prof !397
  %v2739 = xor i1 %v2737, true
  br i1 %v2735, label %v2275, label %v2740, !prof !398

v2740:
  %v2741 = load double, ptr %v829, align 8, !noalias !180
  %v2742 = fcmp olt double %v2741, 5.000000e-01
  br i1 %v2742, label %v2275, label %v2263

v2263:
  store double 1.000000e+00, ptr %v845, align 8, !noalias !180
  %v2743 = load double, ptr %v772, align 8, !noalias !399
  %v2744 = load double, ptr %v93, align 8, !noalias !399
  %v2745 = fsub double %v2743, %v2744
  %v2746 = fmul double %v2745, 1.000000e-13
  %v2747 = load double, ptr %v134, align 8, !noalias !399
  %v2748 = tail call double @llvm.fabs.f64(double %v2747)
  %v2749 = fmul double %v2748, 4.000000e-15
  %v2750 = fcmp ogt double %v2749, %v2746
  %v2751 = select i1 %v2750, double %v2749, double %v2746
  %v2752 = load double, ptr %v778, align 8, !noalias !180
  %v2753 = fdiv double %v2751, %v1734
  %v2754 = fcmp ogt double %v2753, %v2752
  %v2755 = select i1 %v2754, double %v2753, double %v2752
  %v2756 = fcmp ult double %v2755, 1.000000e+00
  br i1 %v2756, label %v2757, label %v2275

v2757:
  %v2758 = fsub double 1.000000e+00, %v2755
  br i1 %v710, label %v2759, label %v2760

v2759:
  %v2761 = load double, ptr %v847, align 8, !noalias !180
  %v2762 = fmul double %v2755, 4.000000e+00
  %v2763 = fmul double %v2762, %v2758
  %v2764 = fmul double %v2763, %v2761
  %v2765 = fmul double %v2763, %v2764
  %v2766 = fcmp olt double %v2765, 5.000000e-04
  br i1 %v2766, label %v2767, label %v2760

v2767:
  %v2768 = load double, ptr %v740, align 8, !noalias !403
  %v2769 = fmul double %v2755, %v2768
  %v2770 = fadd double %v2747, %v2769
  store double %v2770, ptr %v742, align 8, !noalias !403
  br i1 %v744, label %v2771, label %v2772

v2772:
  %v2773 = phi i64 [ %v2774, %v2772 ], [ 0, %v2767 ]
  %v2775 = mul i64 %v2773, %v197
  %v2776 = getelementptr double, ptr %v194, i64 %v2775
  %v2777 = getelementptr i8, ptr %v2776, i64 %v748
  %v2778 = load double, ptr %v2777, align 8, !noalias !410
  %v2779 = fadd double %v2778, 0.000000e+00
  %v2780 = fmul double %v2755, %v2779
  %v2781 = getelementptr i8, ptr %v2776, i64 %v749
  %v2782 = load double, ptr %v2781, align 8, !noalias !410
  %v2783 = fadd double %v2782, %v2780
  %v2784 = fmul double %v2758, %v2783
  %v2785 = getelementptr i8, ptr %v2776, i64 %v750
  %v2786 = load double, ptr %v2785, align 8, !noalias !410
  %v2787 = fadd double %v2786, %v2784
  %v2788 = fmul double %v2755, %v2787
  %v2789 = getelementptr i8, ptr %v2776, i64 %v751
  %v2790 = load double, ptr %v2789, align 8, !noalias !410
  %v2791 = fadd double %v2790, %v2788
  %v2792 = fmul double %v2758, %v2791
  %v2793 = getelementptr i8, ptr %v2776, i64 %v752
  %v2794 = load double, ptr %v2793, align 8, !noalias !410
  %v2795 = fadd double %v2794, %v2792
  %v2796 = fmul double %v2755, %v2795
  %v2797 = getelementptr i8, ptr %v2776, i64 %v753
  %v2798 = load double, ptr %v2797, align 8, !noalias !410
  %v2799 = fadd double %v2798, %v2796
  %v2800 = fmul double %v2758, %v2799
  %v2801 = getelementptr i8, ptr %v2776, i64 %v754
  %v2802 = load double, ptr %v2801, align 8, !noalias !410
  %v2803 = fadd double %v2802, %v2800
  %v2804 = fmul double %v2755, %v2803
  %v2774 = add nsw i64 %v2773, 1
  %v2805 = load double, ptr %v2776, align 8, !noalias !410
  %v2806 = fadd double %v2805, %v2804
  %v2807 = getelementptr double, ptr %v745, i64 %v2775
  store double %v2806, ptr %v2807, align 8, !noalias !403
  %v2808 = icmp eq i64 %v10, %v2774
  br i1 %v2808, label %v2809, label %v2772

v2771:
  %v2810 = load double, ptr %v742, align 8, !noalias !414
  store double %v2810, ptr %v774, align 8, !noalias !414
  br label %v2811

v2811:
  %v2812 = load i64, ptr %v6, align 8, !noalias !415
  %v2813 = inttoptr i64 %v2812 to ptr
  tail call void %v2813(ptr nonnull %v742, ptr %v857, ptr %v166, ptr %v173, ptr %v180, ptr %v859), !noalias !415
  %v2814 = load i64, ptr %v747, align 8, !noalias !418
  %v2815 = inttoptr i64 %v2814 to ptr
  tail call void %v2815(ptr nonnull %v742, ptr %v861, ptr %v166, ptr %v173, ptr %v180, ptr %v863), !noalias !418
  br label %v2275

v2809:
  %v2816 = load double, ptr %v742, align 8, !noalias !414
  store double %v2816, ptr %v774, align 8, !noalias !414
  br label %v2817

v2817:
  %v2818 = phi i64 [ 0, %v2809 ], [ %v2819, %v2817 ]
  %v2819 = add nsw i64 %v2818, 1
  %v2820 = mul i64 %v2818, %v197
  %v2821 = getelementptr double, ptr %v745, i64 %v2820
  %v2822 = load double, ptr %v2821, align 8, !noalias !414
  %v2823 = getelementptr double, ptr %v854, i64 %v2820
  store double %v2822, ptr %v2823, align 8, !noalias !414
  %v2824 = icmp eq i64 %v10, %v2819
  br i1 %v2824, label %v2811, label %v2817

v2760:
  %v2825 = fmul double %v2751, 2.000000e+00
  %v2826 = fcmp ogt double %v1734, %v2825
  br i1 %v2826, label %v2827, label %v2275

v2827:
  %v2828 = load double, ptr %v774, align 8, !noalias !180
  %v2829 = tail call double @llvm.fabs.f64(double %v2828)
  %v2830 = fmul double %v2829, 4.000000e-15
  %v2831 = fmul double %v1734, 0x3D719799812DEA11
  %v2832 = fcmp ogt double %v2830, %v2831
  %v2833 = select i1 %v2832, double %v2830, double %v2831
  %v2834 = load double, ptr %v770, align 8, !noalias !180
  %v2835 = fsub double 1.000000e+00, %v2834
  %v2836 = fmul double %v1734, %v2835
  %v2837 = fcmp ogt double %v2836, %v2833
  br i1 %v2837, label %v2838, label %v2275

v2838:
  %v2839 = fmul double %v1734, %v2755
  store double 0.000000e+00, ptr %v849, align 8, !noalias !421
  store double 0.000000e+00, ptr %v851, align 8, !noalias !421
  store double %v2839, ptr %v852, align 8, !noalias !421
  %v2840 = load i64, ptr %v143, align 8, !noalias !421
  %v2841 = icmp slt i64 %v2840, 0
  %v2842 = select i1 %v2841, i64 %v126, i64 0
  %v2843 = add i64 %v2842, %v2840
  %v2844 = mul i64 %v2843, %v127
  %v2845 = getelementptr i64, ptr %v125, i64 %v2844
  %v2846 = load i64, ptr %v2845, align 8, !noalias !421
  %v2847 = add nsw i64 %v2846, -1
  store i64 %v2847, ptr %v2845, align 8, !noalias !421
  %v2848 = load i64, ptr %v143, align 8, !noalias !421
  %v2849 = icmp slt i64 %v2848, 0
  %v2850 = select i1 %v2849, i64 %v126, i64 0
  %v2851 = add i64 %v2850, %v2848
  %v2852 = mul i64 %v2851, %v127
  %v2853 = getelementptr i64, ptr %v125, i64 %v2852
  %v2854 = getelementptr i8, ptr %v2853, i64 24
  %v2855 = load i64, ptr %v2854, align 8, !noalias !421
  %v2856 = add nsw i64 %v2855, 1
  store i64 %v2856, ptr %v2854, align 8, !noalias !421
  br label %v2275

v1802:
  br i1 %v291, label %v1877, label %v2276

v2275:
  %v2857 = phi ptr [ null, %v2811 ], [ null, %v2838 ], [ null, %v2760 ], [ null, %v2263 ], [ null, %v2740 ], [ null, %v2208 ], [ null, %v2827 ], [ %v2738, %v2357 ]
  %v2858 = phi i1 [ true, %v2811 ], [ true, %v2838 ], [ true, %v2760 ], [ true, %v2263 ], [ true, %v2740 ], [ true, %v2208 ], [ true, %v2827 ], [ %v2739, %v2357 ]
  br i1 %v2858, label %v1574, label %v1487, !prof !131

v1574:
  %v2859 = select i1 %v1394, i1 true, i1 %v673
  %v2860 = select i1 %v2859, i64 0, i64 %v12
  br label %v1487

v2861:
  %v2862 = phi i64 [ 0, %v1480 ], [ %v2863, %v2864 ]
  %v2865 = phi i64 [ %v702, %v1480 ], [ %v2866, %v2864 ]
  %v2867 = icmp sgt i64 %v2865, 0
  br i1 %v2867, label %v2864, label %v1481

v1480:
  %v2868 = load double, ptr %v701, align 8, !noalias !424
  store double %v2868, ptr %v687, align 8, !noalias !424
  br label %v2861

v2864:
  %v2866 = add nsw i64 %v2865, -1
  %v2863 = add i64 %v2862, 1
  %v2869 = getelementptr double, ptr %v704, i64 %v2862
  %v2870 = icmp slt i64 %v2862, 0
  %v2871 = select i1 %v2870, i64 %v208, i64 0
  %v2872 = getelementptr double, ptr %v2869, i64 %v2871
  %v2873 = load double, ptr %v2872, align 8, !noalias !424
  %v2874 = fcmp olt double %v2873, 0x7FF0000000000000
  %v2875 = select i1 %v2874, double %v2873, double 0x7FF0000000000000
  %v2876 = fcmp ogt double %v2873, 0xFFF0000000000000
  %v2877 = select i1 %v2876, double %v2873, double 0xFFF0000000000000
  %v2878 = getelementptr double, ptr %v2872, i64 %v703
  %v2879 = load double, ptr %v2878, align 8, !noalias !424
  %v2880 = fcmp olt double %v2879, %v2875
  %v2881 = select i1 %v2880, double %v2879, double %v2875
  %v2882 = fcmp ogt double %v2879, %v2877
  %v2883 = select i1 %v2882, double %v2879, double %v2877
  %v2884 = getelementptr i8, ptr %v2872, i64 %v1035
  %v2885 = load double, ptr %v2884, align 8, !noalias !424
  %v2886 = fcmp olt double %v2885, %v2881
  %v2887 = select i1 %v2886, double %v2885, double %v2881
  %v2888 = fcmp ogt double %v2885, %v2883
  %v2889 = select i1 %v2888, double %v2885, double %v2883
  %v2890 = getelementptr i8, ptr %v2872, i64 %v1036
  %v2891 = load double, ptr %v2890, align 8, !noalias !424
  %v2892 = fcmp olt double %v2891, %v2887
  %v2893 = select i1 %v2892, double %v2891, double %v2887
  %v2894 = fcmp ogt double %v2891, %v2889
  %v2895 = select i1 %v2894, double %v2891, double %v2889
  %v2896 = getelementptr i8, ptr %v2872, i64 %v1037
  %v2897 = load double, ptr %v2896, align 8, !noalias !424
  %v2898 = fcmp olt double %v2897, %v2893
  %v2899 = select i1 %v2898, double %v2897, double %v2893
  %v2900 = fcmp ogt double %v2897, %v2895
  %v2901 = select i1 %v2900, double %v2897, double %v2895
  %v2902 = getelementptr i8, ptr %v2872, i64 %v1038
  %v2903 = load double, ptr %v2902, align 8, !noalias !424
  %v2904 = fcmp olt double %v2903, %v2899
  %v2905 = select i1 %v2904, double %v2903, double %v2899
  %v2906 = fcmp ogt double %v2903, %v2901
  %v2907 = select i1 %v2906, double %v2903, double %v2901
  %v2908 = getelementptr i8, ptr %v2872, i64 %v1039
  %v2909 = load double, ptr %v2908, align 8, !noalias !424
  %v2910 = fcmp olt double %v2909, %v2905
  %v2911 = select i1 %v2910, double %v2909, double %v2905
  %v2912 = fcmp ogt double %v2909, %v2907
  %v2913 = select i1 %v2912, double %v2909, double %v2907
  %v2914 = getelementptr i8, ptr %v2872, i64 %v1040
  %v2915 = load double, ptr %v2914, align 8, !noalias !424
  %v2916 = fcmp olt double %v2915, %v2911
  %v2917 = select i1 %v2916, double %v2915, double %v2911
  %v2918 = fcmp ogt double %v2915, %v2913
  %v2919 = select i1 %v2918, double %v2915, double %v2913
  %v2920 = getelementptr i8, ptr %v2872, i64 %v1041
  %v2921 = load double, ptr %v2920, align 8, !noalias !424
  %v2922 = fcmp olt double %v2921, %v2917
  %v2923 = select i1 %v2922, double %v2921, double %v2917
  %v2924 = fcmp ogt double %v2921, %v2919
  %v2925 = select i1 %v2924, double %v2921, double %v2919
  %v2926 = fsub double %v2925, %v2923
  %v2927 = fmul double %v2926, 2.500000e-01
  %v2928 = icmp slt i64 %v2862, 0
  %v2929 = select i1 %v2928, i64 %v208, i64 0
  %v2930 = add i64 %v2929, %v2862
  %v2931 = getelementptr double, ptr %v706, i64 %v2930
  %v2932 = getelementptr double, ptr %v707, i64 %v2930
  %v2933 = getelementptr double, ptr %v2931, i64 %v705
  %v2934 = load double, ptr %v2933, align 8, !noalias !425
  %v2935 = load double, ptr %v2932, align 8, !noalias !425
  %v2936 = fmul double %v2935, 0x3FDDF27AAAADCB3A
  %v2937 = fsub double %v2934, %v2936
  %v2938 = getelementptr i8, ptr %v2932, i64 %v1042
  %v2939 = load double, ptr %v2938, align 8, !noalias !425
  %v2940 = fmul double %v2939, 0x3FEC575F1EBC4F2F
  %v2941 = fsub double %v2937, %v2940
  %v2942 = getelementptr i8, ptr %v2932, i64 %v1043
  %v2943 = load double, ptr %v2942, align 8, !noalias !425
  %v2944 = fmul double %v2943, 0xBFE1306AA3D795F4
  %v2945 = fsub double %v2941, %v2944
  %v2946 = getelementptr i8, ptr %v2932, i64 %v1044
  %v2947 = load double, ptr %v2946, align 8, !noalias !425
  %v2948 = fmul double %v2947, 0x3FCCB9F574BDCC3A
  %v2949 = fsub double %v2945, %v2948
  %v2950 = getelementptr i8, ptr %v2932, i64 %v1045
  %v2951 = load double, ptr %v2950, align 8, !noalias !425
  %v2952 = fmul double %v2951, 0xBFA4EAF2D6B11E79
  %v2953 = fsub double %v2949, %v2952
  %v2954 = tail call double @llvm.fabs.f64(double %v2953)
  %v2955 = fcmp ogt double %v2954, 0.000000e+00
  %v2956 = select i1 %v2955, double %v2954, double 0.000000e+00
  %v2957 = getelementptr i8, ptr %v2931, i64 %v1046
  %v2958 = load double, ptr %v2957, align 8, !noalias !425
  %v2959 = load double, ptr %v2932, align 8, !noalias !425
  %v2960 = fmul double %v2959, 0xBFA5118805F8B876
  %v2961 = fsub double %v2958, %v2960
  %v2962 = getelementptr i8, ptr %v2932, i64 %v1047
  %v2963 = load double, ptr %v2962, align 8, !noalias !425
  %v2964 = fmul double %v2963, 0x3FE51326698BC5BD
  %v2965 = fsub double %v2961, %v2964
  %v2966 = getelementptr i8, ptr %v2932, i64 %v1048
  %v2967 = load double, ptr %v2966, align 8, !noalias !425
  %v2968 = fmul double %v2967, 0x3FDF97DED30D4572
  %v2969 = fsub double %v2965, %v2968
  %v2970 = getelementptr i8, ptr %v2932, i64 %v1049
  %v2971 = load double, ptr %v2970, align 8, !noalias !425
  %v2972 = fmul double %v2971, 0xBFC0DA0C684D1D67
  %v2973 = fsub double %v2969, %v2972
  %v2974 = getelementptr i8, ptr %v2932, i64 %v1050
  %v2975 = load double, ptr %v2974, align 8, !noalias !425
  %v2976 = fmul double %v2975, 0x3F9510B8EC0D4D92
  %v2977 = fsub double %v2973, %v2976
  %v2978 = tail call double @llvm.fabs.f64(double %v2977)
  %v2979 = fcmp ogt double %v2978, %v2956
  %v2980 = select i1 %v2979, double %v2978, double %v2956
  %v2981 = getelementptr i8, ptr %v2931, i64 %v1051
  %v2982 = load double, ptr %v2981, align 8, !noalias !425
  %v2983 = load double, ptr %v2932, align 8, !noalias !425
  %v2984 = fmul double %v2983, 0x3F9635A30F8F142F
  %v2985 = fsub double %v2982, %v2984
  %v2986 = getelementptr i8, ptr %v2932, i64 %v1052
  %v2987 = load double, ptr %v2986, align 8, !noalias !425
  %v2988 = fmul double %v2987, 0xBFC1EAE0FF33D241
  %v2989 = fsub double %v2985, %v2988
  %v2990 = getelementptr i8, ptr %v2932, i64 %v1053
  %v2991 = load double, ptr %v2990, align 8, !noalias !425
  %v2992 = fmul double %v2991, 0x3FE1625D59218460
  %v2993 = fsub double %v2989, %v2992
  %v2994 = getelementptr i8, ptr %v2932, i64 %v1054
  %v2995 = load double, ptr %v2994, align 8, !noalias !425
  %v2996 = fmul double %v2995, 0x3FE3BBC3E8A29641
  %v2997 = fsub double %v2993, %v2996
  %v2998 = getelementptr i8, ptr %v2932, i64 %v1055
  %v2999 = load double, ptr %v2998, align 8, !noalias !425
  %v3000 = fmul double %v2999, 0xBFA55161A739EB34
  %v3001 = fsub double %v2997, %v3000
  %v3002 = tail call double @llvm.fabs.f64(double %v3001)
  %v3003 = fcmp ogt double %v3002, %v2980
  %v3004 = select i1 %v3003, double %v3002, double %v2980
  %v3005 = getelementptr i8, ptr %v2931, i64 %v1056
  %v3006 = load double, ptr %v3005, align 8, !noalias !425
  %v3007 = load double, ptr %v2932, align 8, !noalias !425
  %v3008 = fmul double %v3007, 0xBFA4F0C0BB579409
  %v3009 = fsub double %v3006, %v3008
  %v3010 = getelementptr i8, ptr %v2932, i64 %v1057
  %v3011 = load double, ptr %v3010, align 8, !noalias !425
  %v3012 = fmul double %v3011, 0x3FCD2266FBC0D976
  %v3013 = fsub double %v3009, %v3012
  %v3014 = getelementptr i8, ptr %v2932, i64 %v1058
  %v3015 = load double, ptr %v3014, align 8, !noalias !425
  %v3016 = fmul double %v3015, 0xBFE1F2DB6FEE3151
  %v3017 = fsub double %v3013, %v3016
  %v3018 = getelementptr i8, ptr %v2932, i64 %v1059
  %v3019 = load double, ptr %v3018, align 8, !noalias !425
  %v3020 = fmul double %v3019, 0x3FF0C05015964CBE
  %v3021 = fsub double %v3017, %v3020
  %v3022 = getelementptr i8, ptr %v2932, i64 %v1060
  %v3023 = load double, ptr %v3022, align 8, !noalias !425
  %v3024 = fmul double %v3023, 0x3FD4F15B230DB570
  %v3025 = fsub double %v3021, %v3024
  %v3026 = tail call double @llvm.fabs.f64(double %v3025)
  %v3027 = fcmp ogt double %v3026, %v3004
  %v3028 = select i1 %v3027, double %v3026, double %v3004
  %v3029 = fmul double %v3028, 1.000000e+01
  %v3030 = fadd double %v2927, %v3029
  %v3031 = icmp slt i64 %v2862, 0
  %v3032 = select i1 %v3031, i64 %v208, i64 0
  %v3033 = getelementptr double, ptr %v709, i64 %v2862
  %v3034 = getelementptr double, ptr %v3033, i64 %v3032
  %v3035 = load double, ptr %v3034, align 8, !noalias !424
  %v3036 = fcmp ogt double %v3030, %v3035
  %v3037 = fneg double %v3035
  %v3038 = select i1 %v3036, double %v3030, double %v3037
  %v3039 = fcmp olt double %v2923, %v3038
  br i1 %v3039, label %v1481, label %v2861

v1481:
  %v1483 = phi i1 [ false, %v1423 ], [ %v2867, %v2864 ], [ %v2867, %v2861 ]
  %v3040 = phi ptr [ %v1478, %v1423 ], [ null, %v2864 ], [ null, %v2861 ]
  %v3041 = phi i32 [ %v1479, %v1423 ], [ 0, %v2864 ], [ 0, %v2861 ]
  %v3042 = icmp eq i32 %v3041, 0
  br i1 %v3042, label %v1413, label %v1487, !prof !131

v1731:
  br i1 %v1726, label %v1574, label %v1732

v1487:
  %v3043 = phi i64 [ 0, %v1413 ], [ %v2860, %v1574 ], [ 0, %v1481 ], [ 0, %v1639 ], [ 0, %v2275 ]
  %v3044 = phi i1 [ true, %v1413 ], [ true, %v1574 ], [ false, %v1481 ], [ false, %v1639 ], [ false, %v2275 ]
  %v3045 = phi ptr [ undef, %v1413 ], [ undef, %v1574 ], [ %v3040, %v1481 ], [ %v1730, %v1639 ], [ %v2857, %v2275 ]
  %v3046 = phi i32 [ 0, %v1413 ], [ 0, %v1574 ], [ 1, %v1481 ], [ 1, %v1639 ], [ 1, %v2275 ]
  br i1 %v3044, label %v3047, label %v3048, !prof !131

v3049:
  %v3050 = getelementptr double, ptr %v866, i64 %v3051
  %v3052 = load double, ptr %v3050, align 8, !noalias !429
  %v3053 = fcmp olt double %v3052, 5.000000e-01
  br i1 %v3053, label %v3054, label %v3055

v3055:
  %v3056 = getelementptr i64, ptr %v111, i64 %v3057
  %v3058 = load i64, ptr %v3056, align 8, !noalias !429
  %v3059 = icmp eq i64 %v3058, 0
  br i1 %v3059, label %v3060, label %v3054

v3060:
  %v3061 = mul i64 %v3057, %v127
  %v3062 = getelementptr i64, ptr %v125, i64 %v3061
  %v3063 = getelementptr i8, ptr %v3062, i64 8
  %v3064 = load i64, ptr %v3063, align 8, !noalias !429
  %v3065 = add nsw i64 %v3064, %v3043
  store i64 %v3065, ptr %v3063, align 8, !noalias !429
  %v3066 = getelementptr double, ptr %v868, i64 %v3051
  %v3067 = load double, ptr %v3066, align 8, !noalias !429
  %v3068 = load i64, ptr %v3069, align 8, !noalias !432
  %v3070 = getelementptr i64, ptr %v870, i64 %v3051
  %v3071 = load i64, ptr %v3070, align 8, !noalias !432
  %v3072 = icmp slt i64 %v3071, %v94
  br i1 %v3072, label %v3073, label %v3074

v3073:
  %v3075 = icmp slt i64 %v3071, 0
  %v3076 = select i1 %v3075, i64 %v94, i64 0
  %v3077 = getelementptr double, ptr %v93, i64 %v3071
  %v3078 = getelementptr double, ptr %v3077, i64 %v3076
  %v3079 = load double, ptr %v3078, align 8, !noalias !432
  %v3080 = fcmp ugt double %v3079, %v3067
  br i1 %v3080, label %v3074, label %v3081

v3081:
  %v3082 = getelementptr double, ptr %v134, i64 %v3051
  %v3083 = getelementptr double, ptr %v872, i64 %v3051
  %v3084 = getelementptr double, ptr %v194, i64 %v3051
  %v3085 = getelementptr double, ptr %v876, i64 %v3051
  %v3086 = icmp slt i64 %v3068, 0
  %v3087 = select i1 %v3086, i64 %v101, i64 0
  %v3088 = add i64 %v3087, %v3068
  %v3089 = mul i64 %v877, %v3088
  %v3090 = getelementptr double, ptr %v100, i64 %v3089
  %v3091 = getelementptr double, ptr %v878, i64 %v3051
  br label %v3092

v3092:
  %v3093 = phi i64 [ %v3094, %v3095 ], [ %v3071, %v3081 ]
  %v3096 = icmp slt i64 %v3093, 0
  %v3097 = select i1 %v3096, i64 %v94, i64 0
  %v3098 = getelementptr double, ptr %v93, i64 %v3093
  %v3099 = getelementptr double, ptr %v3098, i64 %v3097
  %v3100 = load double, ptr %v3099, align 8, !noalias !432
  %v3101 = load double, ptr %v3082, align 8, !noalias !432
  %v3102 = fsub double %v3100, %v3101
  %v3103 = load double, ptr %v3083, align 8, !noalias !432
  %v3104 = fdiv double %v3102, %v3103
  br i1 %v874, label %v3105, label %v3106

v3106:
  %v3107 = fsub double 1.000000e+00, %v3104
  %v3108 = select i1 %v3096, i64 %v102, i64 0
  %v3109 = add i64 %v3108, %v3093
  %v3110 = mul i64 %v3109, %v103
  %v3111 = getelementptr double, ptr %v3090, i64 %v3110
  br label %v3112

v3113:
  %v3114 = getelementptr double, ptr %v3091, i64 %v3115
  %v3116 = load double, ptr %v3114, align 8, !noalias !432
  br label %v3117

v3105:
  store double 0x7FF0000000000000, ptr %v3085, align 8, !noalias !432
  %v3118 = icmp eq i64 %v3093, %v879
  br i1 %v3118, label %v3074, label %v3095

v3095:
  %v3094 = add i64 %v3093, 1
  %v3119 = icmp slt i64 %v3093, -1
  %v3120 = select i1 %v3119, i64 %v94, i64 0
  %v3121 = getelementptr double, ptr %v93, i64 %v3094
  %v3122 = getelementptr double, ptr %v3121, i64 %v3120
  %v3123 = load double, ptr %v3122, align 8, !noalias !432
  %v3124 = fcmp ugt double %v3123, %v3067
  br i1 %v3124, label %v3074, label %v3092

v3074:
  %v3125 = phi i64 [ %v3071, %v3073 ], [ %v3071, %v3060 ], [ %v94, %v3105 ], [ %v3094, %v3095 ]
  store i64 %v3125, ptr %v3070, align 8, !noalias !432
  br label %v3054

v3117:
  %v3126 = phi double [ %v3127, %v3128 ], [ %v3116, %v3113 ]
  %v3129 = getelementptr double, ptr %v3111, i64 %v3130
  store double %v3126, ptr %v3129, align 8, !noalias !432
  %v3131 = icmp eq i64 %v10, %v3132
  br i1 %v3131, label %v3105, label %v3112

v3112:
  %v3130 = phi i64 [ 0, %v3106 ], [ %v3132, %v3117 ]
  %v3132 = add nsw i64 %v3130, 1
  %v3133 = load double, ptr %v3099, align 8, !noalias !432
  %v3134 = load double, ptr %v3066, align 8, !noalias !432
  %v3135 = fcmp oeq double %v3133, %v3134
  %v3115 = mul i64 %v3130, %v197
  br i1 %v3135, label %v3113, label %v3128

v3128:
  %v3136 = getelementptr double, ptr %v3084, i64 %v3115
  %v3137 = getelementptr i8, ptr %v3136, i64 %v880
  %v3138 = load double, ptr %v3137, align 8, !noalias !436
  %v3139 = fadd double %v3138, 0.000000e+00
  %v3140 = fmul double %v3104, %v3139
  %v3141 = getelementptr i8, ptr %v3136, i64 %v881
  %v3142 = load double, ptr %v3141, align 8, !noalias !436
  %v3143 = fadd double %v3142, %v3140
  %v3144 = fmul double %v3107, %v3143
  %v3145 = getelementptr i8, ptr %v3136, i64 %v882
  %v3146 = load double, ptr %v3145, align 8, !noalias !436
  %v3147 = fadd double %v3146, %v3144
  %v3148 = fmul double %v3104, %v3147
  %v3149 = getelementptr i8, ptr %v3136, i64 %v883
  %v3150 = load double, ptr %v3149, align 8, !noalias !436
  %v3151 = fadd double %v3150, %v3148
  %v3152 = fmul double %v3107, %v3151
  %v3153 = getelementptr i8, ptr %v3136, i64 %v884
  %v3154 = load double, ptr %v3153, align 8, !noalias !436
  %v3155 = fadd double %v3154, %v3152
  %v3156 = fmul double %v3104, %v3155
  %v3157 = getelementptr i8, ptr %v3136, i64 %v885
  %v3158 = load double, ptr %v3157, align 8, !noalias !436
  %v3159 = fadd double %v3158, %v3156
  %v3160 = fmul double %v3107, %v3159
  %v3161 = getelementptr i8, ptr %v3136, i64 %v886
  %v3162 = load double, ptr %v3161, align 8, !noalias !436
  %v3163 = fadd double %v3162, %v3160
  %v3164 = fmul double %v3104, %v3163
  %v3165 = load double, ptr %v3136, align 8, !noalias !436
  %v3127 = fadd double %v3165, %v3164
  br label %v3117

v3054:
  %v3166 = icmp eq i64 %v3167, %v9
  br i1 %v3166, label %v3168, label %v3169

v3169:
  %v3051 = phi i64 [ %v3167, %v3054 ], [ 0, %v3047 ]
  %v3167 = add nsw i64 %v3051, 1
  %v3069 = getelementptr i64, ptr %v143, i64 %v3051
  %v3057 = load i64, ptr %v3069, align 8, !noalias !429
  %v3170 = icmp slt i64 %v3057, 0
  br i1 %v3170, label %v3054, label %v3049

v3168:
  br i1 %v887, label %v3171, label %v3172

v3172:
  %v3173 = load double, ptr %v889, align 8
  %v3174 = fcmp ogt double %v3173, 5.000000e-01
  br i1 %v3174, label %v3171, label %v3175

v3171:
  %v3176 = load i64, ptr %v890, align 8, !noalias !440
  %v3177 = inttoptr i64 %v3176 to ptr
  tail call void %v3177(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !440
  br label %v3175

v3175:
  br i1 %v1409, label %v3178, label %v3179

v3178:
  %v3180 = load double, ptr %v892, align 8, !noalias !443
  %v3181 = fcmp olt double %v3180, 5.000000e-01
  br i1 %v3181, label %v3179, label %v3182

v3182:
  br i1 %v894, label %v3183, label %v3184

v3185:
  %v3186 = getelementptr double, ptr %v895, i64 %v3187
  %v3188 = load double, ptr %v3186, align 8, !noalias !443
  %v3189 = add nsw i64 %v3187, %v18
  %v3190 = icmp slt i64 %v3189, 0
  %v3191 = select i1 %v3190, i64 %v167, i64 0
  %v3192 = getelementptr double, ptr %v166, i64 %v3189
  %v3193 = getelementptr double, ptr %v3192, i64 %v3191
  %v3194 = load double, ptr %v3193, align 8, !noalias !443
  %v3195 = fcmp une double %v3188, %v3194
  br label %v3196

v3196:
  %v3197 = phi i1 [ true, %v3183 ], [ %v3195, %v3185 ]
  %v3198 = icmp eq i64 %v3199, %v19
  br i1 %v3198, label %v3184, label %v3183

v3184:
  %v3200 = phi i1 [ false, %v3182 ], [ %v3197, %v3196 ]
  %v3201 = load double, ptr %v897, align 8, !noalias !443
  %v3202 = fcmp oeq double %v3201, 1.000000e+00
  %v3203 = select i1 %v3202, i1 %v3200, i1 false
  br i1 %v3203, label %v3204, label %v3205

v3204:
  %v3206 = load double, ptr %v134, align 8, !noalias !443
  %v3207 = load double, ptr %v899, align 8, !noalias !443
  %v3208 = fsub double %v3206, %v3207
  br i1 %v900, label %v3209, label %v3210

v3211:
  %v3212 = load double, ptr %v901, align 8, !noalias !443
  %v3213 = load double, ptr %v24, align 8, !noalias !443
  %v3214 = mul i64 %v3215, %v197
  %v3216 = getelementptr double, ptr %v194, i64 %v3214
  %v3217 = load double, ptr %v3216, align 8, !noalias !443
  %v3218 = tail call double @llvm.fabs.f64(double %v3217)
  %v3219 = fmul double %v3213, %v3218
  %v3220 = fadd double %v3212, %v3219
  %v3221 = add i64 %v3215, %v196
  %v3222 = mul i64 %v3221, %v197
  %v3223 = getelementptr double, ptr %v194, i64 %v3222
  %v3224 = load double, ptr %v3223, align 8, !noalias !443
  %v3225 = tail call double @llvm.fabs.f64(double %v3224)
  %v3226 = fmul double %v3208, %v3225
  %v3227 = fcmp ogt double %v3226, %v3220
  br label %v3228

v3228:
  %v3229 = phi i1 [ true, %v3210 ], [ %v3227, %v3211 ]
  %v3230 = icmp eq i64 %v10, %v3231
  br i1 %v3230, label %v3232, label %v3210

v3232:
  %v3233 = select i1 %v3229, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  br label %v3209

v3209:
  %v3234 = phi double [ 5.000000e-06, %v3204 ], [ %v3233, %v3232 ]
  %v3235 = load double, ptr %v903, align 8, !noalias !443
  %v3236 = load double, ptr %v93, align 8, !noalias !443
  %v3237 = fsub double %v3235, %v3236
  %v3238 = fmul double %v3234, %v3237
  %v3239 = fcmp olt double %v3208, %v3238
  br i1 %v3239, label %v3240, label %v3241

v3240:
  %v3242 = load i64, ptr %v905, align 8, !noalias !443
  %v3243 = add nsw i64 %v3242, 1
  br label %v3241

v3241:
  %v3244 = phi i64 [ %v3243, %v3240 ], [ 0, %v3209 ]
  store i64 %v3244, ptr %v907, align 8, !noalias !443
  %v3245 = load double, ptr %v134, align 8, !noalias !443
  store double %v3245, ptr %v899, align 8, !noalias !443
  store double 1.000000e+00, ptr %v909, align 8, !noalias !443
  store i64 2, ptr %v485, align 8, !noalias !443
  %v3246 = load i64, ptr %v907, align 8, !noalias !443
  %v3247 = icmp sgt i64 %v3246, 1000
  br i1 %v3247, label %v3248, label %v3205

v3248:
  %v3249 = load i64, ptr %v143, align 8, !noalias !447
  %v3250 = icmp sgt i64 %v3249, -1
  br i1 %v3250, label %v3251, label %v3205

v3251:
  %v3252 = getelementptr i64, ptr %v111, i64 %v3249
  %v3253 = load i64, ptr %v3252, align 8, !noalias !447
  %v3254 = icmp eq i64 %v3253, 0
  br i1 %v3254, label %v3255, label %v3205

v3255:
  store i64 6, ptr %v3252, align 8, !noalias !447
  br label %v3205

v3205:
  store double 0.000000e+00, ptr %v897, align 8, !noalias !443
  br label %v3179

v3183:
  %v3256 = phi i1 [ %v3197, %v3196 ], [ false, %v3182 ]
  %v3187 = phi i64 [ %v3199, %v3196 ], [ 0, %v3182 ]
  %v3199 = add nsw i64 %v3187, 1
  br i1 %v3256, label %v3196, label %v3185

v3210:
  %v3257 = phi i1 [ %v3229, %v3228 ], [ false, %v3204 ]
  %v3215 = phi i64 [ %v3231, %v3228 ], [ 0, %v3204 ]
  %v3231 = add nsw i64 %v3215, 1
  br i1 %v3257, label %v3228, label %v3211

v3179:
  %v3258 = and i1 %v910, %v1295
  %v3259 = xor i1 %v3258, true
  %v3260 = or i1 %v294, %v3259
  br i1 %v3260, label %v3261, label %v3262

v3263:
  %v3264 = getelementptr i64, ptr %v111, i64 %v3265
  %v3266 = load i64, ptr %v3264, align 8, !noalias !450
  %v3267 = icmp eq i64 %v3266, 0
  br i1 %v3267, label %v3268, label %v3269

v3268:
  %v3270 = getelementptr double, ptr %v913, i64 %v3271
  %v3272 = load double, ptr %v3270, align 8, !noalias !450
  %v3273 = fcmp olt double %v3272, 5.000000e-01
  br i1 %v3273, label %v3269, label %v3274

v3274:
  %v3275 = getelementptr double, ptr %v134, i64 %v3271
  %v3276 = load double, ptr %v3275, align 8, !noalias !450
  %v3277 = getelementptr double, ptr %v915, i64 %v3271
  %v3278 = load double, ptr %v3277, align 8, !noalias !450
  %v3279 = fcmp une double %v3276, %v3278
  %v3280 = select i1 %v3279, i1 true, i1 %v917
  %v3281 = xor i1 %v3279, true
  %v3282 = select i1 %v3281, i1 true, i1 %v3283
  br i1 %v3280, label %v3269, label %v3284

v3284:
  %v3285 = getelementptr i64, ptr %v916, i64 %v3271
  %v3286 = load i64, ptr %v3285, align 8, !noalias !455
  %v3287 = add nsw i64 %v3286, 1
  %v3288 = icmp slt i64 %v3286, -1
  %v3289 = select i1 %v3288, i64 %v78, i64 0
  %v3290 = add i64 %v3287, %v3289
  %v3291 = mul i64 %v3290, %v79
  %v3292 = getelementptr double, ptr %v77, i64 %v3291
  br label %v3293

v3293:
  %v3294 = phi i64 [ 0, %v3284 ], [ %v3295, %v3293 ]
  %v3295 = add nsw i64 %v3294, 1
  %v3296 = getelementptr double, ptr %v3292, i64 %v3294
  %v3297 = load double, ptr %v3296, align 8, !noalias !456
  %v3298 = getelementptr i64, ptr %v63, i64 %v3294
  %v3299 = load i64, ptr %v3298, align 8, !noalias !456
  %v3300 = mul nsw i64 %v3299, %v9
  %v3301 = add nsw i64 %v3300, %v3271
  %v3302 = icmp slt i64 %v3301, 0
  %v3303 = select i1 %v3302, i64 %v167, i64 0
  %v3304 = getelementptr double, ptr %v166, i64 %v3301
  %v3305 = getelementptr double, ptr %v3304, i64 %v3303
  store double %v3297, ptr %v3305, align 8, !noalias !456
  %v3306 = icmp eq i64 %v64, %v3295
  br i1 %v3306, label %v3269, label %v3293

v3269:
  %v3307 = phi i1 [ %v3282, %v3274 ], [ %v3283, %v3268 ], [ %v3283, %v3262 ], [ %v3283, %v3263 ], [ true, %v3293 ]
  %v3308 = icmp eq i64 %v9, %v3309
  br i1 %v3308, label %v3310, label %v3262

v3310:
  br i1 %v3307, label %v3311, label %v3261

v3311:
  %v3312 = load i64, ptr %v918, align 8, !noalias !460
  %v3313 = inttoptr i64 %v3312 to ptr
  tail call void %v3313(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !460
  %v3314 = load i64, ptr %v920, align 8, !noalias !455
  %v3315 = inttoptr i64 %v3314 to ptr
  tail call void %v3315(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v922), !noalias !455
  br label %v3316

v3316:
  %v3317 = phi i64 [ 0, %v3311 ], [ %v3318, %v3319 ]
  %v3320 = phi i64 [ %v924, %v3311 ], [ %v3321, %v3319 ]
  %v3322 = phi i64 [ 1, %v3311 ], [ %v3323, %v3319 ]
  %v3324 = icmp slt i64 %v3317, 0
  %v3325 = select i1 %v3324, i64 %v145, i64 0
  %v3326 = add i64 %v3325, %v3317
  %v3327 = getelementptr i64, ptr %v143, i64 %v3326
  %v3328 = load i64, ptr %v3327, align 8, !noalias !463
  %v3329 = icmp slt i64 %v3328, 0
  br i1 %v3329, label %v3319, label %v3330

v3330:
  %v3331 = getelementptr i64, ptr %v111, i64 %v3328
  %v3332 = load i64, ptr %v3331, align 8, !noalias !463
  %v3333 = icmp eq i64 %v3332, 0
  br i1 %v3333, label %v3334, label %v3319

v3334:
  %v3335 = select i1 %v3324, i64 %v136, i64 0
  %v3336 = add i64 %v3335, %v3317
  %v3337 = getelementptr double, ptr %v913, i64 %v3336
  %v3338 = load double, ptr %v3337, align 8, !noalias !463
  %v3339 = fcmp olt double %v3338, 5.000000e-01
  br i1 %v3339, label %v3319, label %v3340

v3340:
  %v3341 = getelementptr double, ptr %v134, i64 %v3336
  %v3342 = load double, ptr %v3341, align 8, !noalias !463
  %v3343 = getelementptr double, ptr %v915, i64 %v3336
  %v3344 = load double, ptr %v3343, align 8, !noalias !463
  %v3345 = fcmp une double %v3342, %v3344
  br i1 %v3345, label %v3319, label %v3346

v3346:
  %v3347 = getelementptr i64, ptr %v927, i64 %v3326
  %v3348 = load i64, ptr %v3347, align 8, !noalias !466
  %v3349 = icmp sgt i64 %v3348, 0
  br i1 %v3349, label %v3350, label %v3351

v3350:
  %v3352 = getelementptr double, ptr %v93, i64 %v3348
  %v3353 = getelementptr i8, ptr %v3352, i64 -8
  %v3354 = load double, ptr %v3353, align 8, !noalias !466
  %v3355 = getelementptr double, ptr %v134, i64 %v3317
  %v3356 = getelementptr double, ptr %v3355, i64 %v3335
  %v3357 = load double, ptr %v3356, align 8, !noalias !466
  %v3358 = fcmp oeq double %v3354, %v3357
  br label %v3351

v3351:
  %v3359 = phi i1 [ %v3358, %v3350 ], [ false, %v3346 ]
  br i1 %v929, label %v3360, label %v3361

v3361:
  %v3362 = mul i64 %v923, %v3328
  %v3363 = select i1 %v3324, i64 %v197, i64 0
  %v3364 = add i64 %v3363, %v3317
  %v3365 = getelementptr double, ptr %v930, i64 %v3364
  %v3366 = getelementptr double, ptr %v194, i64 %v3364
  %v3367 = add nsw i64 %v3348, -1
  %v3368 = select i1 %v3349, i64 0, i64 %v102
  %v3369 = add i64 %v3367, %v3368
  %v3370 = mul i64 %v3369, %v103
  %v3371 = getelementptr double, ptr %v100, i64 %v3362
  %v3372 = getelementptr double, ptr %v3371, i64 %v3370
  br label %v3373

v3374:
  %v3375 = getelementptr double, ptr %v3372, i64 %v3376
  store double %v3377, ptr %v3375, align 8, !noalias !466
  br label %v3378

v3378:
  %v3379 = icmp eq i64 %v10, %v3380
  br i1 %v3379, label %v3381, label %v3373

v3381:
  %v3382 = fcmp une double %v3383, 0.000000e+00
  br i1 %v3382, label %v3384, label %v3360

v3384:
  %v3385 = load i64, ptr %v3327, align 8, !noalias !470
  %v3386 = icmp sgt i64 %v3385, -1
  br i1 %v3386, label %v3387, label %v3360

v3387:
  %v3388 = getelementptr i64, ptr %v111, i64 %v3385
  %v3389 = load i64, ptr %v3388, align 8, !noalias !470
  %v3390 = icmp eq i64 %v3389, 0
  br i1 %v3390, label %v3391, label %v3360

v3391:
  store i64 3, ptr %v3388, align 8, !noalias !470
  br label %v3360

v3360:
  br i1 %v291, label %v3392, label %v3319

v3392:
  %v3393 = load double, ptr %v932, align 8, !noalias !473
  %v3394 = load double, ptr %v93, align 8, !noalias !473
  %v3395 = fsub double %v3393, %v3394
  %v3396 = fmul double %v3395, 1.000000e-13
  %v3397 = load double, ptr %v134, align 8, !noalias !473
  %v3398 = tail call double @llvm.fabs.f64(double %v3397)
  %v3399 = fmul double %v3398, 4.000000e-15
  %v3400 = fcmp ogt double %v3399, %v3396
  %v3401 = select i1 %v3400, double %v3399, double %v3396
  %v3402 = fadd double %v3397, %v3401
  store double %v3402, ptr %v934, align 8, !noalias !483
  %v3403 = load i64, ptr %v6, align 8, !noalias !484
  %v3404 = inttoptr i64 %v3403 to ptr
  tail call void %v3404(ptr nonnull %v134, ptr %v922, ptr %v166, ptr %v173, ptr %v180, ptr %v936), !noalias !484
  br i1 %v929, label %v3405, label %v3406

v3405:
  %v3407 = load i64, ptr %v941, align 8, !noalias !487
  %v3408 = inttoptr i64 %v3407 to ptr
  tail call void %v3408(ptr nonnull %v134, ptr %v943, ptr %v166, ptr %v173, ptr %v180, ptr %v945), !noalias !487
  %v3409 = load i64, ptr %v941, align 8, !noalias !490
  %v3410 = inttoptr i64 %v3409 to ptr
  tail call void %v3410(ptr nonnull %v934, ptr %v947, ptr %v166, ptr %v173, ptr %v180, ptr %v949), !noalias !490
  br label %v3411

v3411:
  %v3412 = phi i64 [ %v19, %v3405 ], [ %v3413, %v3414 ]
  %v3415 = phi i64 [ %v951, %v3405 ], [ %v3416, %v3414 ]
  %v3417 = icmp sgt i64 %v3415, 0
  br i1 %v3417, label %v3414, label %v3418

v3414:
  %v3416 = add nsw i64 %v3415, -1
  %v3413 = add i64 %v3412, 1
  %v3419 = icmp slt i64 %v3412, 0
  %v3420 = select i1 %v3419, i64 %v208, i64 0
  %v3421 = add i64 %v3420, %v3412
  %v3422 = getelementptr double, ptr %v955, i64 %v3421
  %v3423 = load double, ptr %v3422, align 8, !noalias !483
  %v3424 = getelementptr double, ptr %v958, i64 %v3421
  %v3425 = load double, ptr %v3424, align 8, !noalias !483
  %v3426 = fsub double %v3423, %v3425
  %v3427 = tail call double @llvm.fabs.f64(double %v3426)
  %v3428 = getelementptr double, ptr %v960, i64 %v3421
  %v3429 = load double, ptr %v3428, align 8, !noalias !483
  %v3430 = tail call i1 @llvm.is.fpclass.f64(double %v3429, i32 543)
  %v3431 = select i1 %v3430, double 0.000000e+00, double %v3429
  %v3432 = fcmp ueq double %v3427, 0x7FF0000000000000
  %v3433 = select i1 %v3432, double -0.000000e+00, double %v3427
  %v3434 = fadd double %v3431, %v3433
  %v3435 = getelementptr double, ptr %v957, i64 %v3421
  %v3436 = load double, ptr %v3435, align 8, !noalias !483
  %v3437 = fneg double %v3434
  %v3438 = fcmp olt double %v3436, %v3437
  br i1 %v3438, label %v3418, label %v3411

v3406:
  %v3439 = phi i64 [ %v3440, %v3406 ], [ 0, %v3392 ]
  %v3440 = add nsw i64 %v3439, 1
  %v3441 = mul i64 %v3439, %v197
  %v3442 = getelementptr double, ptr %v930, i64 %v3441
  %v3443 = load double, ptr %v3442, align 8, !noalias !483
  %v3444 = getelementptr double, ptr %v938, i64 %v3441
  %v3445 = load double, ptr %v3444, align 8, !noalias !483
  %v3446 = fmul double %v3401, %v3445
  %v3447 = fadd double %v3443, %v3446
  %v3448 = getelementptr double, ptr %v940, i64 %v3441
  store double %v3447, ptr %v3448, align 8, !noalias !483
  %v3449 = icmp eq i64 %v10, %v3440
  br i1 %v3449, label %v3405, label %v3406

v3450:
  %v3451 = getelementptr i64, ptr %v962, i64 %v3326
  store i64 %v3452, ptr %v3451, align 8, !noalias !493
  %v3453 = load i64, ptr %v3327, align 8, !noalias !494
  %v3454 = icmp sgt i64 %v3453, -1
  br i1 %v3454, label %v3455, label %v3456

v3455:
  %v3457 = getelementptr i64, ptr %v111, i64 %v3453
  %v3458 = load i64, ptr %v3457, align 8, !noalias !494
  %v3459 = icmp eq i64 %v3458, 0
  br i1 %v3459, label %v3460, label %v3456

v3460:
  store i64 4, ptr %v3457, align 8, !noalias !494
  br label %v3456

v3456:
  %v3461 = load double, ptr %v3341, align 8, !noalias !493
  store double %v3461, ptr %v3343, align 8, !noalias !493
  %v3462 = getelementptr double, ptr %v964, i64 %v3336
  store double 0.000000e+00, ptr %v3462, align 8, !noalias !493
  br label %v3319

v3418:
  %v3452 = phi i64 [ %v3412, %v3414 ], [ -1, %v3411 ]
  %v3463 = icmp sgt i64 %v3452, -1
  br i1 %v3463, label %v3450, label %v3319

v3373:
  %v3464 = phi double [ 0.000000e+00, %v3361 ], [ %v3383, %v3378 ]
  %v3376 = phi i64 [ 0, %v3361 ], [ %v3380, %v3378 ]
  %v3380 = add nsw i64 %v3376, 1
  %v3465 = mul i64 %v3376, %v197
  %v3466 = getelementptr double, ptr %v3365, i64 %v3465
  %v3377 = load double, ptr %v3466, align 8, !noalias !466
  %v3467 = fmul double %v3377, 0.000000e+00
  %v3383 = fadd double %v3464, %v3467
  %v3468 = getelementptr double, ptr %v3366, i64 %v3465
  store double %v3377, ptr %v3468, align 8, !noalias !466
  br i1 %v3359, label %v3374, label %v3378

v3319:
  %v3469 = icmp sgt i64 %v3320, 0
  %v3470 = zext i1 %v3469 to i64
  %v3323 = add i64 %v3322, %v3470
  %v3471 = sext i1 %v3469 to i64
  %v3321 = add nsw i64 %v3320, %v3471
  %v3318 = select i1 %v3469, i64 %v3322, i64 0
  br i1 %v3469, label %v3316, label %v3261

v3262:
  %v3283 = phi i1 [ %v3307, %v3269 ], [ false, %v3179 ]
  %v3271 = phi i64 [ %v3309, %v3269 ], [ 0, %v3179 ]
  %v3309 = add nsw i64 %v3271, 1
  %v3472 = getelementptr i64, ptr %v143, i64 %v3271
  %v3265 = load i64, ptr %v3472, align 8, !noalias !450
  %v3473 = icmp slt i64 %v3265, 0
  br i1 %v3473, label %v3269, label %v3263

v3261:
  %v3474 = xor i1 %v1295, true
  %v3475 = or i1 %v294, %v3474
  %v3476 = select i1 %v1295, i64 0, i64 %v1065
  br i1 %v3475, label %v1064, label %v3477

v3478:
  %v3479 = mul i64 %v3480, %v127
  %v3481 = getelementptr i64, ptr %v125, i64 %v3479
  %v3482 = load i64, ptr %v3481, align 8, !noalias !497
  %v3483 = getelementptr i8, ptr %v3481, i64 24
  %v3484 = load i64, ptr %v3483, align 8, !noalias !497
  %v3485 = add i64 %v3482, %v3484
  %v3486 = sub i64 %v285, %v3485
  %v3487 = icmp slt i64 %v3486, 1
  br i1 %v3487, label %v3488, label %v3489

v3488:
  %v3490 = getelementptr i64, ptr %v111, i64 %v3480
  %v3491 = load i64, ptr %v3490, align 8, !noalias !501
  %v3492 = icmp eq i64 %v3491, 0
  br i1 %v3492, label %v3493, label %v3489

v3493:
  store i64 5, ptr %v3490, align 8, !noalias !501
  br label %v3489

v3489:
  %v3494 = getelementptr double, ptr %v966, i64 %v3495
  %v3496 = load double, ptr %v3494, align 8, !noalias !497
  %v3497 = fcmp ogt double %v3496, 5.000000e-01
  br i1 %v3497, label %v3498, label %v3499

v3498:
  %v3500 = getelementptr double, ptr %v134, i64 %v3495
  %v3501 = load double, ptr %v3500, align 8, !noalias !497
  %v3502 = getelementptr double, ptr %v968, i64 %v3495
  %v3503 = load double, ptr %v3502, align 8, !noalias !497
  %v3504 = fcmp oeq double %v3501, %v3503
  br i1 %v3504, label %v3505, label %v3499

v3505:
  %v3506 = getelementptr i64, ptr %v969, i64 %v3495
  %v3507 = load i64, ptr %v3506, align 8, !noalias !504
  %v3508 = add nsw i64 %v3507, 1
  store i64 %v3508, ptr %v3506, align 8, !noalias !504
  %v3509 = icmp slt i64 %v3507, -1
  %v3510 = select i1 %v3509, i64 %v71, i64 0
  %v3511 = getelementptr double, ptr %v70, i64 %v3508
  %v3512 = getelementptr double, ptr %v3511, i64 %v3510
  %v3513 = load double, ptr %v3512, align 8, !noalias !504
  %v3514 = fcmp oeq double %v3513, 0x7FF0000000000000
  br i1 %v3514, label %v3515, label %v3516

v3515:
  %v3517 = load i64, ptr %v3518, align 8, !noalias !504
  %v3519 = icmp slt i64 %v3517, 0
  %v3520 = select i1 %v3519, i64 %v112, i64 0
  %v3521 = getelementptr i64, ptr %v111, i64 %v3517
  %v3522 = getelementptr i64, ptr %v3521, i64 %v3520
  %v3523 = load i64, ptr %v3522, align 8, !noalias !504
  %v3524 = icmp eq i64 %v3523, 0
  br i1 %v3524, label %v3525, label %v3499

v3525:
  store i64 1, ptr %v3522, align 8, !noalias !504
  br label %v3499

v3516:
  store double %v3513, ptr %v3502, align 8, !noalias !504
  %v3526 = select i1 %v3509, i64 %v87, i64 0
  %v3527 = getelementptr i64, ptr %v86, i64 %v3508
  %v3528 = getelementptr i64, ptr %v3527, i64 %v3526
  %v3529 = load i64, ptr %v3528, align 8, !noalias !504
  %v3530 = icmp eq i64 %v3529, 0
  br i1 %v3530, label %v3531, label %v3532

v3531:
  %v3533 = getelementptr double, ptr %v973, i64 %v3495
  store double 1.000000e+00, ptr %v3533, align 8, !noalias !504
  br label %v3534

v3532:
  %v3535 = getelementptr double, ptr %v971, i64 %v3495
  %v3536 = load double, ptr %v3535, align 8, !noalias !504
  %v3537 = fcmp olt double %v3536, 2.500000e-01
  %v3538 = select i1 %v3537, double 2.500000e-01, double %v3536
  store double %v3538, ptr %v3535, align 8, !noalias !504
  %v3539 = load i64, ptr %v485, align 8, !noalias !504
  %v3540 = tail call i64 @llvm.smax.i64(i64 %v3539, i64 1)
  br label %v3534

v3534:
  %v3541 = phi i64 [ %v3540, %v3532 ], [ 2, %v3531 ]
  store i64 %v3541, ptr %v485, align 8, !noalias !504
  br i1 %v974, label %v3499, label %v3542

v3542:
  %v3543 = select i1 %v3509, i64 %v78, i64 0
  %v3544 = add i64 %v3543, %v3508
  %v3545 = mul i64 %v3544, %v79
  %v3546 = getelementptr double, ptr %v77, i64 %v3545
  br label %v3547

v3547:
  %v3548 = phi i64 [ 0, %v3542 ], [ %v3549, %v3547 ]
  %v3549 = add nsw i64 %v3548, 1
  %v3550 = getelementptr double, ptr %v3546, i64 %v3548
  %v3551 = load double, ptr %v3550, align 8, !noalias !508
  %v3552 = getelementptr i64, ptr %v63, i64 %v3548
  %v3553 = load i64, ptr %v3552, align 8, !noalias !508
  %v3554 = mul nsw i64 %v3553, %v9
  %v3555 = add nsw i64 %v3554, %v3495
  %v3556 = icmp slt i64 %v3555, 0
  %v3557 = select i1 %v3556, i64 %v167, i64 0
  %v3558 = getelementptr double, ptr %v166, i64 %v3555
  %v3559 = getelementptr double, ptr %v3558, i64 %v3557
  store double %v3551, ptr %v3559, align 8, !noalias !508
  %v3560 = icmp eq i64 %v64, %v3549
  br i1 %v3560, label %v3499, label %v3547

v3499:
  %v3561 = getelementptr i64, ptr %v111, i64 %v3480
  %v3562 = load i64, ptr %v3561, align 8, !noalias !497
  %v3563 = icmp eq i64 %v3562, 0
  br i1 %v3563, label %v3564, label %v3565

v3565:
  %v3566 = getelementptr i64, ptr %v976, i64 %v3495
  %v3567 = load i64, ptr %v3566, align 8, !noalias !497
  %v3568 = getelementptr i64, ptr %v118, i64 %v3480
  store i64 %v3567, ptr %v3568, align 8, !noalias !497
  store i64 -1, ptr %v3518, align 8, !noalias !497
  %v3569 = getelementptr double, ptr %v978, i64 %v3495
  store double 0.000000e+00, ptr %v3569, align 8, !noalias !512
  %v3570 = load i64, ptr %v152, align 8, !noalias !512
  %v3571 = load i64, ptr %v979, align 8, !noalias !512
  %v3572 = icmp eq i64 %v3570, %v3571
  br i1 %v3572, label %v3573, label %v3574

v3574:
  %v3575 = add nsw i64 %v3570, 1
  store i64 %v3575, ptr %v152, align 8, !noalias !512
  store i64 2, ptr %v485, align 8, !noalias !512
  store i64 %v3570, ptr %v3518, align 8, !noalias !512
  %v3576 = icmp slt i64 %v3570, 0
  %v3577 = select i1 %v3576, i64 %v50, i64 0
  %v3578 = getelementptr i64, ptr %v49, i64 %v3570
  %v3579 = getelementptr i64, ptr %v3578, i64 %v3577
  %v3580 = load i64, ptr %v3579, align 8, !noalias !512
  %v3581 = icmp slt i64 %v3580, 0
  %v3582 = select i1 %v3581, i64 %v57, i64 0
  %v3583 = getelementptr i64, ptr %v56, i64 %v3580
  %v3584 = getelementptr i64, ptr %v3583, i64 %v3582
  %v3585 = load i64, ptr %v3584, align 8, !noalias !512
  %v3586 = getelementptr i64, ptr %v980, i64 %v3495
  store i64 %v3585, ptr %v3586, align 8, !noalias !512
  store i64 1, ptr %v3566, align 8, !noalias !512
  %v3587 = getelementptr i64, ptr %v982, i64 %v3495
  store i64 0, ptr %v3587, align 8, !noalias !512
  br i1 %v983, label %v3588, label %v3589

v3589:
  %v3590 = select i1 %v3576, i64 %v41, i64 0
  %v3591 = add i64 %v3590, %v3570
  %v3592 = mul i64 %v3591, %v42
  %v3593 = getelementptr double, ptr %v40, i64 %v3592
  %v3594 = getelementptr double, ptr %v166, i64 %v3495
  br label %v3595

v3588:
  br i1 %v984, label %v3596, label %v3597

v3597:
  %v3598 = load i64, ptr %v3586, align 8, !noalias !512
  %v3599 = icmp slt i64 %v3598, 0
  %v3600 = select i1 %v3599, i64 %v78, i64 0
  %v3601 = add i64 %v3600, %v3598
  %v3602 = mul i64 %v3601, %v79
  %v3603 = getelementptr double, ptr %v77, i64 %v3602
  br label %v3604

v3604:
  %v3605 = phi i64 [ 0, %v3597 ], [ %v3606, %v3604 ]
  %v3606 = add nsw i64 %v3605, 1
  %v3607 = getelementptr double, ptr %v3603, i64 %v3605
  %v3608 = load double, ptr %v3607, align 8, !noalias !515
  %v3609 = getelementptr i64, ptr %v63, i64 %v3605
  %v3610 = load i64, ptr %v3609, align 8, !noalias !515
  %v3611 = mul nsw i64 %v3610, %v9
  %v3612 = add nsw i64 %v3611, %v3495
  %v3613 = icmp slt i64 %v3612, 0
  %v3614 = select i1 %v3613, i64 %v167, i64 0
  %v3615 = getelementptr double, ptr %v166, i64 %v3612
  %v3616 = getelementptr double, ptr %v3615, i64 %v3614
  store double %v3608, ptr %v3616, align 8, !noalias !515
  %v3617 = icmp eq i64 %v3606, %v64
  br i1 %v3617, label %v3596, label %v3604

v3618:
  %v3619 = getelementptr double, ptr %v134, i64 %v3495
  %v3620 = getelementptr double, ptr %v987, i64 %v3495
  %v3621 = load double, ptr %v3620, align 8, !noalias !519
  %v3622 = getelementptr double, ptr %v989, i64 %v3495
  %v3623 = load double, ptr %v3622, align 8, !noalias !519
  %v3624 = getelementptr double, ptr %v991, i64 %v3495
  %v3625 = load double, ptr %v3624, align 8, !noalias !519
  store double 0.000000e+00, ptr %v3619, align 8, !noalias !519
  %v3626 = getelementptr double, ptr %v3619, i64 %v136
  store double 0.000000e+00, ptr %v3626, align 8, !noalias !519
  %v3627 = getelementptr i8, ptr %v3619, i64 %v992
  store double 0.000000e+00, ptr %v3627, align 8, !noalias !519
  %v3628 = getelementptr i8, ptr %v3619, i64 %v977
  store double 0.000000e+00, ptr %v3628, align 8, !noalias !519
  %v3629 = getelementptr i8, ptr %v3619, i64 %v993
  store double 0.000000e+00, ptr %v3629, align 8, !noalias !519
  %v3630 = getelementptr i8, ptr %v3619, i64 %v965
  store double 0.000000e+00, ptr %v3630, align 8, !noalias !519
  %v3631 = getelementptr i8, ptr %v3619, i64 %v994
  store double 0.000000e+00, ptr %v3631, align 8, !noalias !519
  %v3632 = getelementptr i8, ptr %v3619, i64 %v995
  store double 0.000000e+00, ptr %v3632, align 8, !noalias !519
  %v3633 = getelementptr i8, ptr %v3619, i64 %v996
  store double 0.000000e+00, ptr %v3633, align 8, !noalias !519
  %v3634 = getelementptr i8, ptr %v3619, i64 %v997
  store double 0.000000e+00, ptr %v3634, align 8, !noalias !519
  %v3635 = getelementptr i8, ptr %v3619, i64 %v998
  store double 0.000000e+00, ptr %v3635, align 8, !noalias !519
  %v3636 = getelementptr i8, ptr %v3619, i64 %v999
  store double 0.000000e+00, ptr %v3636, align 8, !noalias !519
  %v3637 = getelementptr i8, ptr %v3619, i64 %v1000
  store double 0.000000e+00, ptr %v3637, align 8, !noalias !519
  %v3638 = getelementptr i8, ptr %v3619, i64 %v1001
  store double 0.000000e+00, ptr %v3638, align 8, !noalias !519
  %v3639 = getelementptr i8, ptr %v3619, i64 %v1002
  store double 0.000000e+00, ptr %v3639, align 8, !noalias !519
  %v3640 = getelementptr i8, ptr %v3619, i64 %v1003
  store double 0.000000e+00, ptr %v3640, align 8, !noalias !519
  %v3641 = getelementptr i8, ptr %v3619, i64 %v1004
  store double 0.000000e+00, ptr %v3641, align 8, !noalias !519
  %v3642 = getelementptr i8, ptr %v3619, i64 %v1005
  store double 0.000000e+00, ptr %v3642, align 8, !noalias !519
  %v3643 = getelementptr i8, ptr %v3619, i64 %v1006
  store double 0.000000e+00, ptr %v3643, align 8, !noalias !519
  %v3644 = getelementptr i8, ptr %v3619, i64 %v1007
  store double 0.000000e+00, ptr %v3644, align 8, !noalias !519
  %v3645 = getelementptr i8, ptr %v3619, i64 %v1008
  store double 0.000000e+00, ptr %v3645, align 8, !noalias !519
  %v3646 = getelementptr i8, ptr %v3619, i64 %v1009
  store double 0.000000e+00, ptr %v3646, align 8, !noalias !519
  %v3647 = getelementptr i8, ptr %v3619, i64 %v1010
  store double 0.000000e+00, ptr %v3647, align 8, !noalias !519
  %v3648 = getelementptr i8, ptr %v3619, i64 %v1011
  store double 0.000000e+00, ptr %v3648, align 8, !noalias !519
  %v3649 = getelementptr i8, ptr %v3619, i64 %v1012
  store double 0.000000e+00, ptr %v3649, align 8, !noalias !519
  %v3650 = getelementptr i8, ptr %v3619, i64 %v1013
  store double 0.000000e+00, ptr %v3650, align 8, !noalias !519
  %v3651 = getelementptr i8, ptr %v3619, i64 %v1014
  store double 0.000000e+00, ptr %v3651, align 8, !noalias !519
  %v3652 = getelementptr i8, ptr %v3619, i64 %v1015
  store double 0.000000e+00, ptr %v3652, align 8, !noalias !519
  %v3653 = getelementptr i8, ptr %v3619, i64 %v1016
  store double 0.000000e+00, ptr %v3653, align 8, !noalias !519
  %v3654 = getelementptr i8, ptr %v3619, i64 %v990
  store double 0.000000e+00, ptr %v3654, align 8, !noalias !519
  %v3655 = getelementptr i8, ptr %v3619, i64 %v988
  store double 0.000000e+00, ptr %v3655, align 8, !noalias !519
  %v3656 = getelementptr i8, ptr %v3619, i64 %v986
  store double 0.000000e+00, ptr %v3656, align 8, !noalias !519
  %v3657 = fcmp oeq double %v3625, 0xFFF0000000000000
  %v3658 = select i1 %v3657, double 0xFFF0000000000000, double 0.000000e+00
  store double %v3658, ptr %v3624, align 8, !noalias !519
  store double %v3623, ptr %v3622, align 8, !noalias !519
  store double %v3621, ptr %v3620, align 8, !noalias !519
  store double 1.000000e+00, ptr %v3569, align 8, !noalias !519
  %v3659 = getelementptr double, ptr %v1017, i64 %v3495
  store double 0xFFF0000000000000, ptr %v3659, align 8, !noalias !519
  %v3660 = getelementptr double, ptr %v1018, i64 %v3495
  store double 0x7FF0000000000000, ptr %v3660, align 8, !noalias !519
  %v3661 = load double, ptr %v93, align 8, !noalias !512
  store double %v3661, ptr %v3619, align 8, !noalias !512
  %v3662 = load i64, ptr %v3586, align 8, !noalias !512
  %v3663 = icmp slt i64 %v3662, 0
  %v3664 = select i1 %v3663, i64 %v71, i64 0
  %v3665 = getelementptr double, ptr %v70, i64 %v3662
  %v3666 = getelementptr double, ptr %v3665, i64 %v3664
  %v3667 = load double, ptr %v3666, align 8, !noalias !512
  %v3668 = getelementptr double, ptr %v1019, i64 %v3495
  store double %v3667, ptr %v3668, align 8, !noalias !512
  br label %v3573

v3595:
  %v3669 = phi i64 [ 0, %v3589 ], [ %v3670, %v3595 ]
  %v3670 = add nsw i64 %v3669, 1
  %v3671 = getelementptr double, ptr %v3593, i64 %v3669
  %v3672 = load double, ptr %v3671, align 8, !noalias !512
  %v3673 = mul nsw i64 %v3669, %v9
  %v3674 = getelementptr double, ptr %v3594, i64 %v3673
  store double %v3672, ptr %v3674, align 8, !noalias !512
  %v3675 = icmp eq i64 %v3670, %v42
  br i1 %v3675, label %v3588, label %v3595

v3596:
  br i1 %v985, label %v3618, label %v3676

v3676:
  %v3677 = getelementptr double, ptr %v194, i64 %v3495
  %v3678 = select i1 %v3576, i64 %v32, i64 0
  %v3679 = add i64 %v3678, %v3570
  %v3680 = mul i64 %v3679, %v33
  %v3681 = getelementptr double, ptr %v31, i64 %v3680
  br label %v3682

v3682:
  %v3683 = phi i64 [ 0, %v3676 ], [ %v3684, %v3682 ]
  %v3684 = add nsw i64 %v3683, 1
  %v3685 = getelementptr double, ptr %v3681, i64 %v3683
  %v3686 = load double, ptr %v3685, align 8, !noalias !512
  %v3687 = mul i64 %v3683, %v197
  %v3688 = getelementptr double, ptr %v3677, i64 %v3687
  store double %v3686, ptr %v3688, align 8, !noalias !512
  %v3689 = icmp eq i64 %v3684, %v10
  br i1 %v3689, label %v3618, label %v3682

v3564:
  %v3690 = getelementptr double, ptr %v1021, i64 %v3495
  %v3691 = load double, ptr %v3690, align 8, !noalias !497
  %v3692 = fcmp ult double %v3691, 1.500000e+01
  br i1 %v3692, label %v3573, label %v3693

v3693:
  %v3694 = load double, ptr %v1023, align 8, !noalias !497
  %v3695 = getelementptr double, ptr %v134, i64 %v3495
  %v3696 = load double, ptr %v3695, align 8, !noalias !497
  %v3697 = fsub double %v3694, %v3696
  %v3698 = getelementptr double, ptr %v1024, i64 %v3495
  %v3699 = load double, ptr %v3698, align 8, !noalias !497
  %v3700 = fmul double %v3699, 2.500000e+02
  %v3701 = fcmp ogt double %v3697, %v3700
  br i1 %v3701, label %v3573, label %v3702

v3702:
  store double 0.000000e+00, ptr %v3690, align 8, !noalias !497
  br label %v3573

v3573:
  %v3703 = phi i1 [ %v3704, %v3564 ], [ true, %v3693 ], [ %v3704, %v3702 ], [ %v3704, %v3565 ], [ %v3704, %v3618 ]
  %v3705 = load i64, ptr %v3518, align 8, !noalias !497
  %v3706 = icmp sgt i64 %v3705, -1
  br i1 %v3706, label %v3707, label %v3708

v3707:
  %v3709 = add nsw i64 %v3710, 1
  %v3711 = getelementptr double, ptr %v1026, i64 %v3495
  %v3712 = load double, ptr %v3711, align 8, !noalias !497
  %v3713 = fcmp ogt double %v3712, 0.000000e+00
  br i1 %v3713, label %v3714, label %v3715

v3715:
  %v3716 = mul i64 %v3705, %v127
  %v3717 = getelementptr i64, ptr %v125, i64 %v3716
  %v3718 = load i64, ptr %v3717, align 8, !noalias !497
  %v3719 = and i64 %v3718, 127
  %v3720 = sub nsw i64 128, %v3719
  %v3721 = tail call i64 @llvm.smin.i64(i64 %v3720, i64 %v3486)
  %v3722 = sitofp i64 %v3721 to double
  br label %v3714

v3714:
  %v3723 = phi double [ %v3722, %v3715 ], [ 1.000000e+00, %v3707 ]
  %v3724 = getelementptr double, ptr %v1028, i64 %v3495
  store double %v3723, ptr %v3724, align 8, !noalias !497
  %v3725 = getelementptr double, ptr %v1030, i64 %v3495
  %v3726 = load double, ptr %v3725, align 8, !noalias !523
  %v3727 = getelementptr double, ptr %v1032, i64 %v3495
  store double %v3726, ptr %v3727, align 8, !noalias !523
  %v3728 = getelementptr i64, ptr %v1034, i64 %v3495
  %v3729 = load i64, ptr %v3728, align 8, !noalias !523
  %v3730 = icmp slt i64 %v3729, %v94
  br i1 %v3730, label %v3731, label %v3708

v3731:
  %v3732 = icmp slt i64 %v3729, 0
  %v3733 = select i1 %v3732, i64 %v94, i64 0
  %v3734 = getelementptr double, ptr %v93, i64 %v3729
  %v3735 = getelementptr double, ptr %v3734, i64 %v3733
  %v3736 = load double, ptr %v3735, align 8, !noalias !523
  %v3737 = load double, ptr %v3725, align 8, !noalias !523
  %v3738 = fcmp olt double %v3737, %v3736
  %v3739 = select i1 %v3738, double %v3737, double %v3736
  store double %v3739, ptr %v3727, align 8, !noalias !523
  br label %v3708

v3708:
  %v3740 = phi i64 [ %v3710, %v3477 ], [ %v3710, %v3573 ], [ %v3709, %v3714 ], [ %v3709, %v3731 ]
  %v3741 = phi i1 [ %v3704, %v3477 ], [ %v3703, %v3573 ], [ %v3703, %v3714 ], [ %v3703, %v3731 ]
  %v3742 = icmp sgt i64 %v3743, 1
  br i1 %v3742, label %v3477, label %v3744

v3477:
  %v3704 = phi i1 [ %v3741, %v3708 ], [ false, %v3261 ]
  %v3710 = phi i64 [ %v3740, %v3708 ], [ 0, %v3261 ]
  %v3495 = phi i64 [ %v3745, %v3708 ], [ 0, %v3261 ]
  %v3743 = phi i64 [ %v3746, %v3708 ], [ %v295, %v3261 ]
  %v3746 = add nsw i64 %v3743, -1
  %v3745 = add nsw i64 %v3495, 1
  %v3518 = getelementptr i64, ptr %v143, i64 %v3495
  %v3480 = load i64, ptr %v3518, align 8, !noalias !497
  %v3747 = icmp slt i64 %v3480, 0
  br i1 %v3747, label %v3708, label %v3478

v1064:
  %v1063 = phi i64 [ %v1067, %v3261 ], [ %v3748, %v3744 ]
  %v1066 = phi i64 [ %v3476, %v3261 ], [ %v3740, %v3744 ]
  %v3749 = icmp sgt i64 %v1066, 0
  %v3750 = icmp sgt i64 %v1063, 0
  %v3751 = select i1 %v3749, i1 %v3750, i1 false
  br i1 %v3751, label %v1061, label %v484

v484:
  %v3752 = phi i64 [ %v479, %v296 ], [ %v1066, %v1064 ]
  br i1 %v294, label %v3753, label %v3754

v3754:
  %v3755 = mul i64 %v136, 192
  %v3756 = getelementptr i8, ptr %v134, i64 %v3755
  %v3757 = mul i64 %v136, 200
  %v3758 = getelementptr i8, ptr %v134, i64 %v3757
  %v3759 = add nsw i64 %v11, -1
  %v3760 = mul i64 %v136, 176
  %v3761 = getelementptr i8, ptr %v134, i64 %v3760
  br label %v3762

v3763:
  %v3764 = getelementptr double, ptr %v3756, i64 %v3765
  %v3766 = load double, ptr %v3764, align 8, !noalias !527
  %v3767 = fptosi double %v3766 to i64
  %v3768 = getelementptr double, ptr %v3758, i64 %v3765
  %v3769 = load double, ptr %v3768, align 8, !noalias !527
  %v3770 = fptosi double %v3769 to i64
  %v3771 = mul i64 %v3772, %v127
  %v3773 = getelementptr i64, ptr %v125, i64 %v3771
  %v3774 = load i64, ptr %v3773, align 8, !noalias !527
  %v3775 = add nsw i64 %v3774, %v3767
  store i64 %v3775, ptr %v3773, align 8, !noalias !527
  %v3776 = getelementptr i8, ptr %v3773, i64 24
  %v3777 = load i64, ptr %v3776, align 8, !noalias !527
  %v3778 = add nsw i64 %v3777, %v3770
  store i64 %v3778, ptr %v3776, align 8, !noalias !527
  %v3779 = getelementptr i8, ptr %v3773, i64 8
  %v3780 = load i64, ptr %v3779, align 8, !noalias !527
  %v3781 = add nsw i64 %v3770, %v3767
  %v3782 = mul nsw i64 %v3781, %v3759
  %v3783 = add nsw i64 %v3782, %v3767
  %v3784 = add nsw i64 %v3783, %v3780
  store i64 %v3784, ptr %v3779, align 8, !noalias !527
  store double 0.000000e+00, ptr %v3764, align 8, !noalias !527
  store double 0.000000e+00, ptr %v3768, align 8, !noalias !527
  %v3785 = getelementptr double, ptr %v3761, i64 %v3765
  %v3786 = load double, ptr %v3785, align 8, !noalias !527
  %v3787 = sitofp i64 %v3781 to double
  %v3788 = fsub double %v3786, %v3787
  store double %v3788, ptr %v3785, align 8, !noalias !527
  br label %v3789

v3789:
  %v3790 = icmp sgt i64 %v3791, 1
  br i1 %v3790, label %v3762, label %v3753

v3762:
  %v3765 = phi i64 [ 0, %v3754 ], [ %v3792, %v3789 ]
  %v3791 = phi i64 [ %v295, %v3754 ], [ %v3793, %v3789 ]
  %v3793 = add nsw i64 %v3791, -1
  %v3792 = add nsw i64 %v3765, 1
  %v3794 = getelementptr i64, ptr %v143, i64 %v3765
  %v3772 = load i64, ptr %v3794, align 8, !noalias !527
  %v3795 = icmp sgt i64 %v3772, -1
  br i1 %v3795, label %v3763, label %v3789

v3796:
  %v3797 = phi i32 [ 0, %v3753 ], [ %v3046, %v3048 ]
  ret i32 %v3797

v345:
  %v476 = phi i64 [ 0, %v297 ], [ %v475, %v352 ]
  %v478 = phi i64 [ %v295, %v297 ], [ %v3798, %v352 ]
  %v348 = phi i64 [ 0, %v297 ], [ %v3799, %v352 ]
  %v3798 = add nsw i64 %v478, -1
  %v3799 = add nsw i64 %v348, 1
  %v472 = getelementptr i64, ptr %v143, i64 %v348
  %v3800 = load i64, ptr %v472, align 8
  %v3801 = icmp slt i64 %v3800, 0
  br i1 %v3801, label %v346, label %v352

v1273:
  %v3802 = load i64, ptr %v6, align 8, !noalias !531
  %v3803 = inttoptr i64 %v3802 to ptr
  tail call void %v3803(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v567), !noalias !531
  br label %v1274

v1274:
  br i1 %v568, label %v3804, label %v3805

v3804:
  %v3806 = load double, ptr %v570, align 8, !noalias !534
  %v3807 = fcmp olt double %v3806, 5.000000e-01
  br i1 %v3807, label %v3808, label %v3809

v3808:
  br i1 %v571, label %v3810, label %v3811

v3810:
  br i1 %v583, label %v3812, label %v3813, !prof !397

v3814:
  %v3815 = icmp eq i64 %v3816, %v616
  br i1 %v3815, label %v3809, label %v3817

v3818:
  %v3819 = load i64, ptr %v593, align 8, !noalias !538
  %v3820 = icmp eq i64 %v3819, %v3816
  br i1 %v3820, label %v3821, label %v3822

v3821:
  %v3823 = load double, ptr %v595, align 8, !noalias !538
  %v3824 = fmul double %v3823, 1.000000e-03
  br label %v3822

v3822:
  %v3825 = phi double [ %v3824, %v3821 ], [ 0.000000e+00, %v3818 ]
  store double %v3825, ptr %v3826, align 8, !noalias !538
  br i1 %v571, label %v3827, label %v3828

v3829:
  %v3830 = phi i64 [ %v3831, %v3829 ], [ 0, %v3817 ]
  %v3831 = add nsw i64 %v3830, 1
  %v3832 = mul i64 %v3830, %v197
  %v3833 = getelementptr double, ptr %v194, i64 %v3832
  %v3834 = load double, ptr %v3833, align 8, !noalias !538
  %v3835 = tail call double @llvm.fabs.f64(double %v3834)
  %v3836 = fcmp ogt double %v3837, %v3835
  %v3838 = select i1 %v3836, double %v3837, double %v3835
  %v3839 = fcmp ogt double %v3838, 0.000000e+00
  %v3840 = fmul double %v3838, 1.200000e-05
  %v3841 = select i1 %v3839, double %v3840, double 1.200000e-05
  %v3842 = getelementptr i64, ptr %v253, i64 %v3830
  %v3843 = load i64, ptr %v3842, align 8, !noalias !538
  %v3844 = icmp eq i64 %v3843, %v3816
  %v3845 = select i1 %v3844, double %v3841, double 0.000000e+00
  %v3846 = getelementptr double, ptr %v3847, i64 %v3830
  store double %v3845, ptr %v3846, align 8, !noalias !538
  %v3848 = icmp eq i64 %v10, %v3831
  br i1 %v3848, label %v3818, label %v3829

v3849:
  %v3850 = getelementptr double, ptr %v609, i64 %v3851
  store double %v3852, ptr %v3850, align 8, !noalias !544
  br label %v3853

v3854:
  %v3855 = select i1 %v3856, i64 %v282, i64 0
  %v3857 = getelementptr i64, ptr %v281, i64 %v3858
  %v3859 = getelementptr i64, ptr %v3857, i64 %v3855
  %v3860 = load i64, ptr %v3859, align 8, !noalias !544
  %v3861 = icmp slt i64 %v3860, 0
  %v3862 = select i1 %v3861, i64 %v224, i64 0
  %v3863 = getelementptr double, ptr %v223, i64 %v3860
  %v3864 = getelementptr double, ptr %v3863, i64 %v3862
  store double %v3852, ptr %v3864, align 8, !noalias !544
  br label %v3853

v3853:
  %v3865 = icmp sgt i64 %v3866, 1
  br i1 %v3865, label %v3867, label %v3814

v3811:
  %v3868 = phi i64 [ %v3869, %v3811 ], [ 0, %v3808 ]
  %v3869 = add nsw i64 %v3868, 1
  %v3870 = mul i64 %v3868, %v197
  %v3871 = getelementptr double, ptr %v194, i64 %v3870
  %v3872 = load double, ptr %v3871, align 8, !noalias !544
  %v3873 = getelementptr double, ptr %v574, i64 %v3870
  store double %v3872, ptr %v3873, align 8, !noalias !544
  %v3874 = getelementptr double, ptr %v576, i64 %v3870
  store double 0.000000e+00, ptr %v3874, align 8, !noalias !544
  %v3875 = icmp eq i64 %v10, %v3869
  br i1 %v3875, label %v3810, label %v3811

v3876:
  %v3877 = phi i64 [ %v160, %v3878 ], [ %v3879, %v3880 ]
  %v3881 = sub i64 %v3877, %v3882
  %v3883 = tail call i64 @llvm.smax.i64(i64 %v3881, i64 0)
  %v3847 = getelementptr double, ptr %v159, i64 %v3882
  br i1 %v588, label %v3884, label %v3809

v3884:
  %v3885 = select i1 %v580, i64 %v3883, i64 0
  %v3886 = getelementptr double, ptr %v3847, i64 %v10
  %v3826 = getelementptr double, ptr %v3886, i64 %v3885
  br label %v3817

v3812:
  br label %v3813

v3813:
  %v3887 = phi i64 [ 0, %v3812 ], [ %v582, %v3810 ]
  br i1 %v584, label %v3888, label %v3889, !prof !131

v3889:
  br label %v3888

v3888:
  %v3882 = phi i64 [ %v160, %v3889 ], [ %v3887, %v3813 ]
  br i1 %v586, label %v3890, label %v3880, !prof !397

v3890:
  br label %v3880

v3880:
  %v3879 = phi i64 [ 0, %v3890 ], [ %v585, %v3888 ]
  br i1 %v587, label %v3876, label %v3878, !prof !131

v3878:
  br label %v3876

v3817:
  %v3816 = phi i64 [ 0, %v3884 ], [ %v3891, %v3814 ]
  %v3891 = add nsw i64 %v3816, 1
  %v3892 = load double, ptr %v590, align 8, !noalias !538
  %v3893 = load double, ptr %v24, align 8, !noalias !538
  %v3837 = fdiv double %v3892, %v3893
  br i1 %v571, label %v3818, label %v3829

v3894:
  %v3895 = load double, ptr %v134, align 8, !noalias !545
  %v3896 = load double, ptr %v3826, align 8, !noalias !545
  %v3897 = fmul double %v3896, 5.000000e-01
  %v3898 = fadd double %v3895, %v3897
  store double %v3898, ptr %v598, align 8, !noalias !545
  %v3899 = load i64, ptr %v6, align 8, !noalias !549
  %v3900 = inttoptr i64 %v3899 to ptr
  tail call void %v3900(ptr nonnull %v598, ptr %v601, ptr %v166, ptr %v173, ptr %v180, ptr %v611), !noalias !549
  br label %v3901

v3901:
  %v3902 = phi i64 [ %v3903, %v3901 ], [ 0, %v3894 ]
  %v3903 = add nsw i64 %v3902, 1
  %v3904 = mul i64 %v3902, %v197
  %v3905 = getelementptr double, ptr %v194, i64 %v3904
  %v3906 = load double, ptr %v3905, align 8, !noalias !545
  %v3907 = getelementptr double, ptr %v3847, i64 %v3902
  %v3908 = load double, ptr %v3907, align 8, !noalias !545
  %v3909 = fmul double %v3908, 5.000000e-01
  %v3910 = fsub double %v3906, %v3909
  %v3911 = getelementptr double, ptr %v602, i64 %v3904
  store double %v3910, ptr %v3911, align 8, !noalias !545
  %v3912 = icmp eq i64 %v10, %v3903
  br i1 %v3912, label %v3913, label %v3901

v3827:
  %v3914 = load double, ptr %v134, align 8, !noalias !545
  %v3915 = fmul double %v3825, 5.000000e-01
  %v3916 = fadd double %v3915, %v3914
  store double %v3916, ptr %v598, align 8, !noalias !545
  %v3917 = load i64, ptr %v6, align 8, !noalias !549
  %v3918 = inttoptr i64 %v3917 to ptr
  tail call void %v3918(ptr nonnull %v598, ptr %v601, ptr %v166, ptr %v173, ptr %v180, ptr %v613), !noalias !549
  br label %v3913

v3913:
  %v3919 = load double, ptr %v134, align 8, !noalias !545
  %v3920 = load double, ptr %v3826, align 8, !noalias !545
  %v3921 = fmul double %v3920, 5.000000e-01
  %v3922 = fsub double %v3919, %v3921
  store double %v3922, ptr %v598, align 8, !noalias !545
  %v3923 = load i64, ptr %v6, align 8, !noalias !549
  %v3924 = inttoptr i64 %v3923 to ptr
  tail call void %v3924(ptr nonnull %v598, ptr %v601, ptr %v166, ptr %v173, ptr %v180, ptr %v615), !noalias !549
  br i1 %v571, label %v3925, label %v3926

v3927:
  %v3928 = fsub double %v3929, %v3930
  br label %v3931

v3932:
  %v3933 = getelementptr double, ptr %v607, i64 %v3934
  %v3935 = load double, ptr %v3933, align 8, !noalias !545
  %v3936 = fsub double %v3929, %v3935
  %v3937 = fmul double %v3936, 2.000000e+00
  br label %v3931

v3931:
  %v3938 = phi double [ %v3937, %v3932 ], [ %v3928, %v3927 ]
  store double %v3938, ptr %v3939, align 8, !noalias !545
  %v3940 = icmp eq i64 %v10, %v3941
  br i1 %v3940, label %v3925, label %v3926

v3828:
  %v3942 = phi i64 [ %v3943, %v3828 ], [ 0, %v3822 ]
  %v3943 = add nsw i64 %v3942, 1
  %v3944 = mul i64 %v3942, %v197
  %v3945 = getelementptr double, ptr %v194, i64 %v3944
  %v3946 = load double, ptr %v3945, align 8, !noalias !545
  %v3947 = getelementptr double, ptr %v3847, i64 %v3942
  %v3948 = load double, ptr %v3947, align 8, !noalias !545
  %v3949 = fmul double %v3948, 5.000000e-01
  %v3950 = fadd double %v3946, %v3949
  %v3951 = getelementptr double, ptr %v602, i64 %v3944
  store double %v3950, ptr %v3951, align 8, !noalias !545
  %v3952 = icmp eq i64 %v10, %v3943
  br i1 %v3952, label %v3894, label %v3828

v3926:
  %v3953 = phi i64 [ %v3941, %v3931 ], [ 0, %v3913 ]
  %v3941 = add nsw i64 %v3953, 1
  %v3934 = mul i64 %v3953, %v197
  %v3954 = getelementptr double, ptr %v194, i64 %v3934
  %v3955 = load double, ptr %v3954, align 8, !noalias !545
  %v3956 = getelementptr double, ptr %v602, i64 %v3934
  store double %v3955, ptr %v3956, align 8, !noalias !545
  %v3939 = getelementptr double, ptr %v604, i64 %v3934
  %v3929 = load double, ptr %v3939, align 8, !noalias !545
  %v3957 = getelementptr double, ptr %v606, i64 %v3934
  %v3930 = load double, ptr %v3957, align 8, !noalias !545
  %v3958 = fsub double %v3930, %v3930
  %v3959 = fcmp oeq double %v3958, 0.000000e+00
  br i1 %v3959, label %v3927, label %v3932

v3925:
  %v3960 = getelementptr i64, ptr %v260, i64 %v3816
  %v3961 = load i64, ptr %v3960, align 8, !noalias !544
  %v3962 = getelementptr i8, ptr %v3960, i64 8
  %v3963 = load i64, ptr %v3962, align 8, !noalias !544
  %v3964 = sub i64 %v3963, %v3961
  %v3965 = icmp slt i64 %v3964, 1
  br i1 %v3965, label %v3814, label %v3867

v3867:
  %v3866 = phi i64 [ %v3966, %v3853 ], [ %v3964, %v3925 ]
  %v3858 = phi i64 [ %v3967, %v3853 ], [ %v3961, %v3925 ]
  %v3966 = add nsw i64 %v3866, -1
  %v3967 = add i64 %v3858, 1
  %v3856 = icmp slt i64 %v3858, 0
  %v3968 = select i1 %v3856, i64 %v268, i64 0
  %v3969 = getelementptr i64, ptr %v267, i64 %v3858
  %v3970 = getelementptr i64, ptr %v3969, i64 %v3968
  %v3971 = load i64, ptr %v3970, align 8, !noalias !544
  %v3972 = select i1 %v3856, i64 %v275, i64 0
  %v3973 = getelementptr i64, ptr %v274, i64 %v3858
  %v3974 = getelementptr i64, ptr %v3973, i64 %v3972
  %v3975 = load i64, ptr %v3974, align 8, !noalias !544
  %v3976 = icmp slt i64 %v3971, 0
  %v3977 = select i1 %v3976, i64 %v196, i64 0
  %v3978 = add i64 %v3977, %v3971
  %v3851 = mul i64 %v3978, %v197
  %v3979 = getelementptr double, ptr %v604, i64 %v3851
  %v3980 = load double, ptr %v3979, align 8, !noalias !544
  %v3981 = icmp slt i64 %v3975, 0
  %v3982 = select i1 %v3981, i64 %v3883, i64 0
  %v3983 = getelementptr double, ptr %v3847, i64 %v3975
  %v3984 = getelementptr double, ptr %v3983, i64 %v3982
  %v3985 = load double, ptr %v3984, align 8, !noalias !544
  %v3986 = fdiv double %v3980, %v3985
  %v3987 = fsub double %v3986, %v3986
  %v3988 = fcmp oeq double %v3987, 0.000000e+00
  %v3852 = select i1 %v3988, double %v3986, double 0.000000e+00
  %v3989 = icmp eq i64 %v3975, %v10
  br i1 %v3989, label %v3849, label %v3854

v3809:
  br i1 %v617, label %v3990, label %v3805

v3991:
  %v3992 = mul i64 %v3993, %v620
  %v3994 = icmp slt i64 %v3992, 0
  %v3995 = select i1 %v3994, i64 %v231, i64 0
  %v3996 = getelementptr double, ptr %v230, i64 %v3992
  %v3997 = getelementptr double, ptr %v3996, i64 %v3995
  %v3998 = load double, ptr %v3997, align 8, !noalias !534
  %v3999 = load double, ptr %v622, align 8, !noalias !534
  %v4000 = fadd double %v3998, %v3999
  store double %v4000, ptr %v3997, align 8, !noalias !534
  %v4001 = icmp eq i64 %v10, %v4002
  br i1 %v4001, label %v4003, label %v3990

v4004:
  %v4005 = icmp eq i64 %v4006, %v10
  br i1 %v4005, label %v3805, label %v4003

v4007:
  %v4008 = phi i64 [ %v4009, %v4003 ], [ %v4010, %v4011 ]
  %v4012 = getelementptr i64, ptr %v237, i64 %v4009
  store i64 %v4008, ptr %v4012, align 8, !noalias !552
  %v4013 = add nsw i64 %v4008, %v4014
  %v4015 = icmp slt i64 %v4013, 0
  %v4016 = select i1 %v4015, i64 %v231, i64 0
  %v4017 = getelementptr double, ptr %v230, i64 %v4013
  %v4018 = getelementptr double, ptr %v4017, i64 %v4016
  %v4019 = load double, ptr %v4018, align 8, !noalias !552
  %v4020 = load double, ptr %v4021, align 8, !noalias !552
  store double %v4019, ptr %v4021, align 8, !noalias !552
  store double %v4020, ptr %v4018, align 8, !noalias !552
  br i1 %v4022, label %v4023, label %v4024

v4023:
  %v4025 = sub i64 %v4026, %v4006
  %v4027 = icmp slt i64 %v4025, 1
  br i1 %v4027, label %v4004, label %v4028

v4029:
  %v4030 = icmp sgt i64 %v4031, 1
  br i1 %v4030, label %v4028, label %v4004

v4003:
  %v4009 = phi i64 [ %v4006, %v4004 ], [ 0, %v3991 ]
  %v4006 = add nsw i64 %v4009, 1
  %v4014 = mul nsw i64 %v4009, %v10
  %v4032 = add nsw i64 %v4009, %v240
  %v4033 = add nsw i64 %v4032, 1
  %v4034 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %v4033, i64 %v10)
  %v4035 = add i64 %v623, %v4032
  %v4026 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %v4035, i64 %v10)
  %v4036 = getelementptr double, ptr %v230, i64 %v4014
  %v4021 = getelementptr double, ptr %v4036, i64 %v4009
  %v4037 = sub i64 %v4034, %v4006
  %v4038 = tail call i64 @llvm.smax.i64(i64 %v4037, i64 0)
  %v4022 = icmp slt i64 %v4037, 1
  br i1 %v4022, label %v4007, label %v4039

v4039:
  %v4040 = load double, ptr %v4021, align 8, !noalias !552
  %v4041 = tail call double @llvm.fabs.f64(double %v4040)
  br label %v4011

v4011:
  %v4042 = phi i64 [ %v4010, %v4011 ], [ %v4009, %v4039 ]
  %v4043 = phi double [ %v4044, %v4011 ], [ %v4041, %v4039 ]
  %v4045 = phi i64 [ %v4046, %v4011 ], [ %v4038, %v4039 ]
  %v4047 = phi i64 [ %v4048, %v4011 ], [ %v4006, %v4039 ]
  %v4046 = add nsw i64 %v4045, -1
  %v4048 = add i64 %v4047, 1
  %v4049 = add nsw i64 %v4047, %v4014
  %v4050 = icmp slt i64 %v4049, 0
  %v4051 = select i1 %v4050, i64 %v231, i64 0
  %v4052 = getelementptr double, ptr %v230, i64 %v4049
  %v4053 = getelementptr double, ptr %v4052, i64 %v4051
  %v4054 = load double, ptr %v4053, align 8, !noalias !552
  %v4055 = tail call double @llvm.fabs.f64(double %v4054)
  %v4056 = fcmp ogt double %v4055, %v4043
  %v4044 = select i1 %v4056, double %v4055, double %v4043
  %v4010 = select i1 %v4056, i64 %v4047, i64 %v4042
  %v4057 = icmp sgt i64 %v4045, 1
  br i1 %v4057, label %v4011, label %v4007

v4024:
  %v4058 = phi i64 [ %v4059, %v4024 ], [ %v4038, %v4007 ]
  %v4060 = phi i64 [ %v4061, %v4024 ], [ %v4006, %v4007 ]
  %v4059 = add nsw i64 %v4058, -1
  %v4061 = add i64 %v4060, 1
  %v4062 = add nsw i64 %v4060, %v4014
  %v4063 = icmp slt i64 %v4062, 0
  %v4064 = select i1 %v4063, i64 %v231, i64 0
  %v4065 = getelementptr double, ptr %v230, i64 %v4062
  %v4066 = getelementptr double, ptr %v4065, i64 %v4064
  %v4067 = load double, ptr %v4066, align 8, !noalias !552
  %v4068 = load double, ptr %v4021, align 8, !noalias !552
  %v4069 = fdiv double %v4067, %v4068
  store double %v4069, ptr %v4066, align 8, !noalias !552
  %v4070 = icmp sgt i64 %v4058, 1
  br i1 %v4070, label %v4024, label %v4023

v4028:
  %v4031 = phi i64 [ %v4071, %v4029 ], [ %v4025, %v4023 ]
  %v4072 = phi i64 [ %v4073, %v4029 ], [ %v4006, %v4023 ]
  %v4071 = add nsw i64 %v4031, -1
  %v4073 = add i64 %v4072, 1
  %v4074 = mul nsw i64 %v4072, %v10
  %v4075 = add nsw i64 %v4074, %v4008
  %v4076 = icmp slt i64 %v4075, 0
  %v4077 = select i1 %v4076, i64 %v231, i64 0
  %v4078 = getelementptr double, ptr %v230, i64 %v4075
  %v4079 = getelementptr double, ptr %v4078, i64 %v4077
  %v4080 = load double, ptr %v4079, align 8, !noalias !552
  %v4081 = add nsw i64 %v4074, %v4009
  %v4082 = icmp slt i64 %v4081, 0
  %v4083 = select i1 %v4082, i64 %v231, i64 0
  %v4084 = getelementptr double, ptr %v230, i64 %v4081
  %v4085 = getelementptr double, ptr %v4084, i64 %v4083
  %v4086 = load double, ptr %v4085, align 8, !noalias !552
  store double %v4086, ptr %v4079, align 8, !noalias !552
  store double %v4080, ptr %v4085, align 8, !noalias !552
  %v4087 = fcmp oeq double %v4080, 0.000000e+00
  %v4088 = or i1 %v4022, %v4087
  br i1 %v4088, label %v4029, label %v4089

v4089:
  %v4090 = phi i64 [ %v4091, %v4089 ], [ %v4038, %v4028 ]
  %v4092 = phi i64 [ %v4093, %v4089 ], [ %v4006, %v4028 ]
  %v4091 = add nsw i64 %v4090, -1
  %v4093 = add i64 %v4092, 1
  %v4094 = add nsw i64 %v4092, %v4074
  %v4095 = icmp slt i64 %v4094, 0
  %v4096 = select i1 %v4095, i64 %v231, i64 0
  %v4097 = getelementptr double, ptr %v230, i64 %v4094
  %v4098 = getelementptr double, ptr %v4097, i64 %v4096
  %v4099 = load double, ptr %v4098, align 8, !noalias !552
  %v4100 = add nsw i64 %v4092, %v4014
  %v4101 = icmp slt i64 %v4100, 0
  %v4102 = select i1 %v4101, i64 %v231, i64 0
  %v4103 = getelementptr double, ptr %v230, i64 %v4100
  %v4104 = getelementptr double, ptr %v4103, i64 %v4102
  %v4105 = load double, ptr %v4104, align 8, !noalias !552
  %v4106 = fmul double %v4080, %v4105
  %v4107 = fsub double %v4099, %v4106
  store double %v4107, ptr %v4098, align 8, !noalias !552
  %v4108 = icmp sgt i64 %v4090, 1
  br i1 %v4108, label %v4089, label %v4029

v3990:
  %v3993 = phi i64 [ %v4002, %v3991 ], [ 0, %v3809 ]
  %v4002 = add nsw i64 %v3993, 1
  %v4109 = sub i64 %v3993, %v618
  %v4110 = tail call i64 @llvm.smax.i64(i64 %v4109, i64 0)
  %v4111 = add i64 %v619, %v3993
  %v4112 = tail call i64 @llvm.smin.i64(i64 %v4111, i64 %v10)
  %v4113 = sub i64 %v4112, %v4110
  %v4114 = icmp slt i64 %v4113, 1
  br i1 %v4114, label %v3991, label %v4115

v4115:
  %v4116 = mul nsw i64 %v3993, %v10
  br label %v4117

v4117:
  %v4118 = phi i64 [ %v4113, %v4115 ], [ %v4119, %v4117 ]
  %v4120 = phi i64 [ %v4110, %v4115 ], [ %v4121, %v4117 ]
  %v4119 = add nsw i64 %v4118, -1
  %v4121 = add i64 %v4120, 1
  %v4122 = add nsw i64 %v4120, %v4116
  %v4123 = icmp slt i64 %v4122, 0
  %v4124 = select i1 %v4123, i64 %v224, i64 0
  %v4125 = getelementptr double, ptr %v223, i64 %v4122
  %v4126 = getelementptr double, ptr %v4125, i64 %v4124
  %v4127 = load double, ptr %v4126, align 8, !noalias !534
  %v4128 = fneg double %v4127
  %v4129 = select i1 %v4123, i64 %v231, i64 0
  %v4130 = getelementptr double, ptr %v230, i64 %v4122
  %v4131 = getelementptr double, ptr %v4130, i64 %v4129
  store double %v4128, ptr %v4131, align 8, !noalias !534
  %v4132 = icmp sgt i64 %v4118, 1
  br i1 %v4132, label %v4117, label %v3991

v3805:
  br i1 %v626, label %v1294, label %v4133

v4134:
  %v4135 = mul i64 %v4136, %v634
  %v4137 = getelementptr double, ptr %v194, i64 %v4135
  br label %v4138

v4139:
  %v4140 = icmp eq i64 %v10, %v4141
  br i1 %v4140, label %v4142, label %v4143

v4144:
  %v4145 = icmp sgt i64 %v4146, 1
  br i1 %v4145, label %v4142, label %v4147

v4147:
  %v4148 = mul i64 %v4136, %v643
  %v4149 = getelementptr double, ptr %v194, i64 %v4148
  br label %v4150

v4143:
  %v4151 = phi i64 [ %v4141, %v4139 ], [ 0, %v4138 ]
  %v4141 = add nsw i64 %v4151, 1
  %v4152 = getelementptr i64, ptr %v237, i64 %v4151
  %v4153 = load i64, ptr %v4152, align 8, !noalias !555
  %v4154 = add nsw i64 %v4153, %v639
  %v4155 = icmp slt i64 %v4154, 0
  %v4156 = select i1 %v4155, i64 %v160, i64 0
  %v4157 = getelementptr double, ptr %v159, i64 %v4154
  %v4158 = getelementptr double, ptr %v4157, i64 %v4156
  %v4159 = load double, ptr %v4158, align 8, !noalias !555
  %v4160 = getelementptr double, ptr %v641, i64 %v4151
  %v4161 = load double, ptr %v4160, align 8, !noalias !555
  store double %v4161, ptr %v4158, align 8, !noalias !555
  store double %v4159, ptr %v4160, align 8, !noalias !555
  %v4162 = add i64 %v640, %v4151
  %v4163 = tail call i64 @llvm.smin.i64(i64 %v4162, i64 %v10)
  %v4164 = sub i64 %v4163, %v4141
  %v4165 = icmp slt i64 %v4164, 1
  br i1 %v4165, label %v4139, label %v4166

v4166:
  %v4167 = mul nsw i64 %v4151, %v10
  br label %v4168

v4168:
  %v4169 = phi i64 [ %v4164, %v4166 ], [ %v4170, %v4168 ]
  %v4171 = phi i64 [ %v4141, %v4166 ], [ %v4172, %v4168 ]
  %v4170 = add nsw i64 %v4169, -1
  %v4172 = add i64 %v4171, 1
  %v4173 = add nsw i64 %v4171, %v639
  %v4174 = icmp slt i64 %v4173, 0
  %v4175 = select i1 %v4174, i64 %v160, i64 0
  %v4176 = getelementptr double, ptr %v159, i64 %v4173
  %v4177 = getelementptr double, ptr %v4176, i64 %v4175
  %v4178 = load double, ptr %v4177, align 8, !noalias !555
  %v4179 = add nsw i64 %v4171, %v4167
  %v4180 = icmp slt i64 %v4179, 0
  %v4181 = select i1 %v4180, i64 %v231, i64 0
  %v4182 = getelementptr double, ptr %v230, i64 %v4179
  %v4183 = getelementptr double, ptr %v4182, i64 %v4181
  %v4184 = load double, ptr %v4183, align 8, !noalias !555
  %v4185 = fmul double %v4159, %v4184
  %v4186 = fsub double %v4178, %v4185
  store double %v4186, ptr %v4177, align 8, !noalias !555
  %v4187 = icmp sgt i64 %v4169, 1
  br i1 %v4187, label %v4168, label %v4139

v4142:
  %v4146 = phi i64 [ %v4188, %v4144 ], [ %v10, %v4139 ]
  %v4188 = add nsw i64 %v4146, -1
  %v4189 = add nsw i64 %v4188, %v639
  %v4190 = icmp slt i64 %v4189, 0
  %v4191 = select i1 %v4190, i64 %v160, i64 0
  %v4192 = getelementptr double, ptr %v159, i64 %v4189
  %v4193 = getelementptr double, ptr %v4192, i64 %v4191
  %v4194 = load double, ptr %v4193, align 8, !noalias !555
  %v4195 = mul nsw i64 %v4188, %v10
  %v4196 = add nsw i64 %v4195, %v4188
  %v4197 = icmp slt i64 %v4196, 0
  %v4198 = select i1 %v4197, i64 %v231, i64 0
  %v4199 = getelementptr double, ptr %v230, i64 %v4196
  %v4200 = getelementptr double, ptr %v4199, i64 %v4198
  %v4201 = load double, ptr %v4200, align 8, !noalias !555
  %v4202 = fdiv double %v4194, %v4201
  store double %v4202, ptr %v4193, align 8, !noalias !555
  %v4203 = sub i64 %v4188, %v642
  %v4204 = tail call i64 @llvm.smax.i64(i64 %v4203, i64 0)
  %v4205 = sub i64 %v4188, %v4204
  %v4206 = icmp slt i64 %v4205, 1
  br i1 %v4206, label %v4144, label %v4207

v4207:
  %v4208 = phi i64 [ %v4209, %v4207 ], [ %v4205, %v4142 ]
  %v4210 = phi i64 [ %v4211, %v4207 ], [ %v4204, %v4142 ]
  %v4209 = add nsw i64 %v4208, -1
  %v4211 = add i64 %v4210, 1
  %v4212 = add nsw i64 %v4210, %v639
  %v4213 = icmp slt i64 %v4212, 0
  %v4214 = select i1 %v4213, i64 %v160, i64 0
  %v4215 = getelementptr double, ptr %v159, i64 %v4212
  %v4216 = getelementptr double, ptr %v4215, i64 %v4214
  %v4217 = load double, ptr %v4216, align 8, !noalias !555
  %v4218 = add nsw i64 %v4210, %v4195
  %v4219 = icmp slt i64 %v4218, 0
  %v4220 = select i1 %v4219, i64 %v231, i64 0
  %v4221 = getelementptr double, ptr %v230, i64 %v4218
  %v4222 = getelementptr double, ptr %v4221, i64 %v4220
  %v4223 = load double, ptr %v4222, align 8, !noalias !555
  %v4224 = fmul double %v4202, %v4223
  %v4225 = fsub double %v4217, %v4224
  store double %v4225, ptr %v4216, align 8, !noalias !555
  %v4226 = icmp sgt i64 %v4208, 1
  br i1 %v4226, label %v4207, label %v4144

v4138:
  %v4227 = phi i64 [ 0, %v4134 ], [ %v4228, %v4138 ]
  %v4228 = add nsw i64 %v4227, 1
  %v4229 = mul i64 %v4227, %v197
  %v4230 = getelementptr double, ptr %v4137, i64 %v4229
  %v4231 = load double, ptr %v4230, align 8, !noalias !561
  %v4232 = getelementptr double, ptr %v636, i64 %v4229
  %v4233 = load double, ptr %v4232, align 8, !noalias !561
  %v4234 = fadd double %v4231, %v4233
  %v4235 = getelementptr i64, ptr %v246, i64 %v4227
  %v4236 = load i64, ptr %v4235, align 8, !noalias !561
  %v4237 = icmp slt i64 %v4236, 0
  %v4238 = select i1 %v4237, i64 %v196, i64 0
  %v4239 = add i64 %v4238, %v4236
  %v4240 = mul i64 %v4239, %v197
  %v4241 = getelementptr double, ptr %v638, i64 %v4240
  store double %v4234, ptr %v4241, align 8, !noalias !561
  %v4242 = icmp eq i64 %v10, %v4228
  br i1 %v4242, label %v4143, label %v4138

v4150:
  %v4243 = phi i64 [ 0, %v4147 ], [ %v4244, %v4150 ]
  %v4244 = add nsw i64 %v4243, 1
  %v4245 = getelementptr i64, ptr %v246, i64 %v4243
  %v4246 = load i64, ptr %v4245, align 8, !noalias !561
  %v4247 = icmp slt i64 %v4246, 0
  %v4248 = select i1 %v4247, i64 %v196, i64 0
  %v4249 = add i64 %v4248, %v4246
  %v4250 = mul i64 %v4249, %v197
  %v4251 = getelementptr double, ptr %v645, i64 %v4250
  %v4252 = load double, ptr %v4251, align 8, !noalias !561
  %v4253 = mul i64 %v4243, %v197
  %v4254 = getelementptr double, ptr %v4149, i64 %v4253
  store double %v4252, ptr %v4254, align 8, !noalias !561
  %v4255 = icmp eq i64 %v10, %v4244
  br i1 %v4255, label %v4256, label %v4150

v4256:
  %v4257 = icmp eq i64 %v4258, %v625
  br i1 %v4257, label %v1294, label %v4133

v1294:
  %v4259 = load i64, ptr %v646, align 8, !noalias !562
  %v4260 = inttoptr i64 %v4259 to ptr
  tail call void %v4260(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !562
  br i1 %v294, label %v1292, label %v1282

v4133:
  %v4258 = phi i64 [ %v4136, %v4256 ], [ 1, %v3805 ]
  %v4136 = add i64 %v4258, 1
  %v4261 = getelementptr i64, ptr %v6, i64 %v4258
  %v4262 = getelementptr i8, ptr %v4261, i64 104
  %v4263 = load i64, ptr %v4262, align 8, !noalias !565
  %v4264 = inttoptr i64 %v4263 to ptr
  tail call void %v4264(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !565
  %v4265 = load i64, ptr %v6, align 8, !noalias !568
  %v4266 = mul nsw i64 %v4136, %v629
  %v4267 = getelementptr double, ptr %v159, i64 %v4266
  %v4268 = inttoptr i64 %v4265 to ptr
  tail call void %v4268(ptr %v628, ptr %v631, ptr %v166, ptr %v173, ptr %v180, ptr %v4267), !noalias !568
  br i1 %v633, label %v4134, label %v4256

v1282:
  %v1283 = phi i1 [ %v1289, %v1284 ], [ %v1270, %v1294 ]
  %v4269 = phi i1 [ %v1281, %v1284 ], [ false, %v1294 ]
  %v1291 = phi i64 [ %v4270, %v1284 ], [ %v295, %v1294 ]
  %v1277 = phi i64 [ %v4271, %v1284 ], [ 0, %v1294 ]
  %v4270 = add nsw i64 %v1291, -1
  %v4271 = add nsw i64 %v1277, 1
  br i1 %v4269, label %v1280, label %v1275

v1385:
  %v1395 = xor i1 %v1380, true
  %v4272 = xor i1 %v1381, true
  %v1397 = select i1 %v4272, i1 true, i1 %v673
  br label %v1298

v3048:
  store ptr %v3045, ptr %v1, align 8
  br label %v3796

v3047:
  %v4273 = select i1 %v1295, i1 %v1293, i1 false
  %v4274 = xor i1 %v4273, true
  %v4275 = or i1 %v294, %v4274
  br i1 %v4275, label %v3168, label %v3169

v3744:
  %v3748 = select i1 %v3741, i64 0, i64 %v1067
  br label %v1064

v3753:
  store i64 %v3752, ptr %v0, align 8
  br label %v3796
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
  %v72 = load double, ptr %v71, align 8, !noalias !571
  %v73 = getelementptr double, ptr %v64, i64 %v66
  %v74 = load double, ptr %v73, align 8, !noalias !571
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
  %v144 = load double, ptr %v143, align 8, !noalias !575
  %v145 = load double, ptr %v142, align 8, !noalias !575
  %v146 = fmul double %v145, 0x3FDDF27AAAADCB3A
  %v147 = fsub double %v144, %v146
  %v148 = getelementptr i8, ptr %v142, i64 %v119
  %v149 = load double, ptr %v148, align 8, !noalias !575
  %v150 = fmul double %v149, 0x3FEC575F1EBC4F2F
  %v151 = fsub double %v147, %v150
  %v152 = getelementptr i8, ptr %v142, i64 %v120
  %v153 = load double, ptr %v152, align 8, !noalias !575
  %v154 = fmul double %v153, 0x3FE1306AA3D795F4
  %v155 = fadd double %v151, %v154
  %v156 = getelementptr i8, ptr %v142, i64 %v121
  %v157 = load double, ptr %v156, align 8, !noalias !575
  %v158 = fmul double %v157, 0x3FCCB9F574BDCC3A
  %v159 = fsub double %v155, %v158
  %v160 = getelementptr i8, ptr %v142, i64 %v122
  %v161 = load double, ptr %v160, align 8, !noalias !575
  %v162 = fmul double %v161, 0x3FA4EAF2D6B11E79
  %v163 = fadd double %v159, %v162
  %v164 = tail call double @llvm.fabs.f64(double %v163)
  %v165 = fcmp ogt double %v164, 0.000000e+00
  %v166 = select i1 %v165, double %v164, double 0.000000e+00
  %v167 = getelementptr i8, ptr %v142, i64 %v123
  %v168 = load double, ptr %v167, align 8, !noalias !575
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
  %v183 = load double, ptr %v182, align 8, !noalias !575
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
  %v198 = load double, ptr %v197, align 8, !noalias !575
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
  %v213 = load double, ptr %v212, align 8, !noalias !582
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
  %v266 = load double, ptr %v265, align 8, !noalias !583
  %v267 = icmp slt i64 %v251, 0
  %v268 = select i1 %v267, i64 %v13, i64 0
  %v269 = add i64 %v268, %v251
  %v270 = mul i64 %v269, %v104
  %v271 = getelementptr double, ptr %v142, i64 %v270
  %v272 = load double, ptr %v271, align 8, !noalias !583
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
  %v283 = load double, ptr %v282, align 8, !noalias !583
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
  store double 0.000000e+00, ptr %v31, align 8, !noalias !587
  %v358 = shl i64 %v9, 5
  %v359 = getelementptr i8, ptr %v8, i64 %v358
  store double 0.000000e+00, ptr %v359, align 8, !noalias !587
  %v360 = getelementptr double, ptr %v8, i64 %v9
  store double %v357, ptr %v360, align 8, !noalias !587
  %v361 = load i64, ptr %v10, align 8, !noalias !587
  %v362 = icmp slt i64 %v361, 0
  %v363 = select i1 %v362, i64 %v6, i64 0
  %v364 = add i64 %v363, %v361
  %v365 = mul i64 %v364, %v7
  %v366 = getelementptr i64, ptr %v5, i64 %v365
  %v367 = load i64, ptr %v366, align 8, !noalias !587
  %v368 = add nsw i64 %v367, -1
  store i64 %v368, ptr %v366, align 8, !noalias !587
  %v369 = load i64, ptr %v10, align 8, !noalias !587
  %v370 = icmp slt i64 %v369, 0
  %v371 = select i1 %v370, i64 %v6, i64 0
  %v372 = add i64 %v371, %v369
  %v373 = mul i64 %v372, %v7
  %v374 = getelementptr i64, ptr %v5, i64 %v373
  %v375 = getelementptr i8, ptr %v374, i64 24
  %v376 = load i64, ptr %v375, align 8, !noalias !587
  %v377 = add nsw i64 %v376, 1
  store i64 %v377, ptr %v375, align 8, !noalias !587
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
  %v404 = load double, ptr %v403, align 8, !noalias !590
  %v405 = getelementptr double, ptr %v397, i64 %v401
  %v406 = load double, ptr %v405, align 8, !noalias !590
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
  %v430 = load double, ptr %v429, align 8, !noalias !594
  %v431 = getelementptr double, ptr %v423, i64 %v427
  %v432 = load double, ptr %v431, align 8, !noalias !594
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
  %v442 = load double, ptr %v8, align 8, !noalias !598
  %v443 = tail call double @llvm.fabs.f64(double %v442)
  %v444 = fmul double %v443, 4.000000e-15
  %v445 = getelementptr double, ptr %v3, i64 %v4
  %v446 = getelementptr i8, ptr %v445, i64 -8
  %v447 = load double, ptr %v446, align 8, !noalias !598
  %v448 = load double, ptr %v3, align 8, !noalias !598
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
!105 = distinct !{!105, !106, !"_ZN5pages12time_stepper13handle_eventsB4v104B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb: %retptr"}
!106 = distinct !{!106, !"_ZN5pages12time_stepper13handle_eventsB4v104B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb"}
!107 = distinct !{!107, !106, !"_ZN5pages12time_stepper13handle_eventsB4v104B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb: %excinfo"}
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
!270 = !{!271, !273, !211, !213, !181, !183, !105, !107}
!271 = distinct !{!271, !272, !"_ZN5pages8segments19write_samples_untilB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!272 = distinct !{!272, !"_ZN5pages8segments19write_samples_untilB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!273 = distinct !{!273, !272, !"_ZN5pages8segments19write_samples_untilB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %excinfo"}
!274 = !{!275, !211, !213, !181, !183, !105, !107}
!275 = distinct !{!275, !276, !"_ZN5pages13solver_layout4failB3v80B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29: %retptr"}
!276 = distinct !{!276, !"_ZN5pages13solver_layout4failB3v80B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29"}
!277 = !{!278, !280, !271, !273, !211, !213, !181, !183, !105, !107}
!278 = distinct !{!278, !279, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!279 = distinct !{!279, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!280 = distinct !{!280, !279, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!281 = !{!282, !284, !211, !213, !181, !183, !105, !107}
!282 = distinct !{!282, !283, !"_ZN5pages12event_checks13first_crossedB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!283 = distinct !{!283, !"_ZN5pages12event_checks13first_crossedB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!284 = distinct !{!284, !283, !"_ZN5pages12event_checks13first_crossedB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!285 = !{!286, !288, !181, !183, !105, !107}
!286 = distinct !{!286, !287, !"_ZN5pages14event_location11pass_eventsB3v81B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!287 = distinct !{!287, !"_ZN5pages14event_location11pass_eventsB3v81B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!288 = distinct !{!288, !287, !"_ZN5pages14event_location11pass_eventsB3v81B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!289 = !{!290, !292, !293, !295, !286, !288, !181, !183, !105, !107}
!290 = distinct !{!290, !291, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!291 = distinct !{!291, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!292 = distinct !{!292, !291, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!293 = distinct !{!293, !294, !"_ZN5pages12event_checks15evaluate_pointsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!294 = distinct !{!294, !"_ZN5pages12event_checks15evaluate_pointsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!295 = distinct !{!295, !294, !"_ZN5pages12event_checks15evaluate_pointsB3v51B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!296 = !{!297, !299, !290, !292, !293, !295, !286, !288, !181, !183, !105, !107}
!297 = distinct !{!297, !298, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!298 = distinct !{!298, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!299 = distinct !{!299, !298, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!300 = !{!301, !293, !295, !286, !288, !181, !183, !105, !107}
!301 = distinct !{!301, !302, !"_ZN5pages13solver_layout6decideB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!302 = distinct !{!302, !"_ZN5pages13solver_layout6decideB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!303 = !{!304, !286, !288, !181, !183, !105, !107}
!304 = distinct !{!304, !305, !"_ZN5pages13solver_layout10derivativeB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!305 = distinct !{!305, !"_ZN5pages13solver_layout10derivativeB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!306 = !{!307, !309, !310, !286, !288, !181, !183, !105, !107}
!307 = distinct !{!307, !308, !"_ZN5pages14event_location10next_shareB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %retptr"}
!308 = distinct !{!308, !"_ZN5pages14event_location10next_shareB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx"}
!309 = distinct !{!309, !308, !"_ZN5pages14event_location10next_shareB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %excinfo"}
!310 = distinct !{!310, !311, !"_ZN5pages14event_location6narrowB3v71B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!311 = distinct !{!311, !"_ZN5pages14event_location6narrowB3v71B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!312 = !{!310, !286, !288, !181, !183, !105, !107}
!313 = !{!314, !316, !317, !319, !310, !286, !288, !181, !183, !105, !107}
!314 = distinct !{!314, !315, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!315 = distinct !{!315, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!316 = distinct !{!316, !315, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!317 = distinct !{!317, !318, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!318 = distinct !{!318, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!319 = distinct !{!319, !318, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!320 = !{!321, !323, !314, !316, !317, !319, !310, !286, !288, !181, !183, !105, !107}
!321 = distinct !{!321, !322, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!322 = distinct !{!322, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!323 = distinct !{!323, !322, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!324 = !{!325, !317, !319, !310, !286, !288, !181, !183, !105, !107}
!325 = distinct !{!325, !326, !"_ZN5pages13solver_layout6decideB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!326 = distinct !{!326, !"_ZN5pages13solver_layout6decideB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!327 = !{!317, !319, !310, !286, !288, !181, !183, !105, !107}
!328 = !{!329, !331, !310, !286, !288, !181, !183, !105, !107}
!329 = distinct !{!329, !330, !"_ZN5pages12event_checks14least_distanceB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!330 = distinct !{!330, !"_ZN5pages12event_checks14least_distanceB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!331 = distinct !{!331, !330, !"_ZN5pages12event_checks14least_distanceB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!332 = !{!333, !335, !337, !286, !288, !181, !183, !105, !107}
!333 = distinct !{!333, !334, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!334 = distinct !{!334, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!335 = distinct !{!335, !336, !"_ZN5pages14event_location18exchange_decisionsB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %retptr"}
!336 = distinct !{!336, !"_ZN5pages14event_location18exchange_decisionsB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29"}
!337 = distinct !{!337, !336, !"_ZN5pages14event_location18exchange_decisionsB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %excinfo"}
!338 = !{!335, !337, !286, !288, !181, !183, !105, !107}
!339 = !{!340, !342, !286, !288, !181, !183, !105, !107}
!340 = distinct !{!340, !341, !"_ZN5pages14event_location12rates_changeB3v82B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!341 = distinct !{!341, !"_ZN5pages14event_location12rates_changeB3v82B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!342 = distinct !{!342, !341, !"_ZN5pages14event_location12rates_changeB3v82B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!343 = !{!344, !346, !347, !349, !340, !342, !286, !288, !181, !183, !105, !107}
!344 = distinct !{!344, !345, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!345 = distinct !{!345, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!346 = distinct !{!346, !345, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!347 = distinct !{!347, !348, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!348 = distinct !{!348, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!349 = distinct !{!349, !348, !"_ZN5pages14event_location13decide_withinB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!350 = !{!351, !353, !344, !346, !347, !349, !340, !342, !286, !288, !181, !183, !105, !107}
!351 = distinct !{!351, !352, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!352 = distinct !{!352, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!353 = distinct !{!353, !352, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!354 = !{!355, !347, !349, !340, !342, !286, !288, !181, !183, !105, !107}
!355 = distinct !{!355, !356, !"_ZN5pages13solver_layout6decideB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!356 = distinct !{!356, !"_ZN5pages13solver_layout6decideB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!357 = !{!347, !349, !340, !342, !286, !288, !181, !183, !105, !107}
!358 = !{!359, !361, !340, !342, !286, !288, !181, !183, !105, !107}
!359 = distinct !{!359, !360, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!360 = distinct !{!360, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!361 = distinct !{!361, !360, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!362 = !{!363, !365, !359, !361, !340, !342, !286, !288, !181, !183, !105, !107}
!363 = distinct !{!363, !364, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!364 = distinct !{!364, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!365 = distinct !{!365, !364, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!366 = !{!367, !369, !371, !340, !342, !286, !288, !181, !183, !105, !107}
!367 = distinct !{!367, !368, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!368 = distinct !{!368, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!369 = distinct !{!369, !370, !"_ZN5pages14event_location18exchange_decisionsB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!370 = distinct !{!370, !"_ZN5pages14event_location18exchange_decisionsB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!371 = distinct !{!371, !370, !"_ZN5pages14event_location18exchange_decisionsB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!372 = !{!369, !371, !340, !342, !286, !288, !181, !183, !105, !107}
!373 = !{!374, !376, !378, !340, !342, !286, !288, !181, !183, !105, !107}
!374 = distinct !{!374, !375, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!375 = distinct !{!375, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!376 = distinct !{!376, !377, !"_ZN5pages14event_location18exchange_decisionsB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!377 = distinct !{!377, !"_ZN5pages14event_location18exchange_decisionsB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!378 = distinct !{!378, !377, !"_ZN5pages14event_location18exchange_decisionsB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!379 = !{!376, !378, !340, !342, !286, !288, !181, !183, !105, !107}
!380 = !{!381, !340, !342, !286, !288, !181, !183, !105, !107}
!381 = distinct !{!381, !382, !"_ZN5pages13solver_layout10derivativeB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2814_29: %retptr"}
!382 = distinct !{!382, !"_ZN5pages13solver_layout10derivativeB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2814_29"}
!383 = !{!384, !386, !388, !340, !342, !286, !288, !181, !183, !105, !107}
!384 = distinct !{!384, !385, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!385 = distinct !{!385, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!386 = distinct !{!386, !387, !"_ZN5pages14event_location18exchange_decisionsB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!387 = distinct !{!387, !"_ZN5pages14event_location18exchange_decisionsB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!388 = distinct !{!388, !387, !"_ZN5pages14event_location18exchange_decisionsB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!389 = !{!390, !340, !342, !286, !288, !181, !183, !105, !107}
!390 = distinct !{!390, !391, !"_ZN5pages13solver_layout10derivativeB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2815_29: %retptr"}
!391 = distinct !{!391, !"_ZN5pages13solver_layout10derivativeB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2815_29"}
!392 = !{!393, !395, !340, !342, !286, !288, !181, !183, !105, !107}
!393 = distinct !{!393, !394, !"_ZN5pages14event_location12rates_differB3v86B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!394 = distinct !{!394, !"_ZN5pages14event_location12rates_differB3v86B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!395 = distinct !{!395, !394, !"_ZN5pages14event_location12rates_differB3v86B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!396 = !{!386, !388, !340, !342, !286, !288, !181, !183, !105, !107}
!397 = !{!"branch_weights", i32 1, i32 99}
!398 = !{!"branch_weights", i32 101, i32 99}
!399 = !{!400, !402, !181, !183, !105, !107}
!400 = distinct !{!400, !401, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!401 = distinct !{!401, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!402 = distinct !{!402, !401, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!403 = !{!404, !406, !407, !409, !181, !183, !105, !107}
!404 = distinct !{!404, !405, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!405 = distinct !{!405, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!406 = distinct !{!406, !405, !"_ZN5pages13solver_layout16put_state_withinB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!407 = distinct !{!407, !408, !"_ZN5pages14event_location8end_stepB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!408 = distinct !{!408, !"_ZN5pages14event_location8end_stepB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!409 = distinct !{!409, !408, !"_ZN5pages14event_location8end_stepB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!410 = !{!411, !413, !404, !406, !407, !409, !181, !183, !105, !107}
!411 = distinct !{!411, !412, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!412 = distinct !{!412, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!413 = distinct !{!413, !412, !"_ZN5pages13solver_layout11interpolateB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!414 = !{!407, !409, !181, !183, !105, !107}
!415 = !{!416, !407, !409, !181, !183, !105, !107}
!416 = distinct !{!416, !417, !"_ZN5pages13solver_layout10derivativeB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!417 = distinct !{!417, !"_ZN5pages13solver_layout10derivativeB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!418 = !{!419, !407, !409, !181, !183, !105, !107}
!419 = distinct !{!419, !420, !"_ZN5pages13solver_layout6decideB3v89B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_288_29: %retptr"}
!420 = distinct !{!420, !"_ZN5pages13solver_layout6decideB3v89B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_288_29"}
!421 = !{!422, !181, !183, !105, !107}
!422 = distinct !{!422, !423, !"_ZN5pages13solver_layout5retryB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!423 = distinct !{!423, !"_ZN5pages13solver_layout5retryB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!424 = !{!121, !123, !105, !107}
!425 = !{!426, !428, !121, !123, !105, !107}
!426 = distinct !{!426, !427, !"_ZN5pages12event_checks13error_betweenB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!427 = distinct !{!427, !"_ZN5pages12event_checks13error_betweenB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!428 = distinct !{!428, !427, !"_ZN5pages12event_checks13error_betweenB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!429 = !{!430}
!430 = distinct !{!430, !431, !"_ZN5pages12time_stepper13write_samplesB3v90B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29b: %retptr"}
!431 = distinct !{!431, !"_ZN5pages12time_stepper13write_samplesB3v90B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29b"}
!432 = !{!433, !435, !430}
!433 = distinct !{!433, !434, !"_ZN5pages8segments19write_samples_untilB3v91B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd: %retptr"}
!434 = distinct !{!434, !"_ZN5pages8segments19write_samples_untilB3v91B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd"}
!435 = distinct !{!435, !434, !"_ZN5pages8segments19write_samples_untilB3v91B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd: %excinfo"}
!436 = !{!437, !439, !433, !435, !430}
!437 = distinct !{!437, !438, !"_ZN5pages13solver_layout11interpolateB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd: %retptr"}
!438 = distinct !{!438, !"_ZN5pages13solver_layout11interpolateB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd"}
!439 = distinct !{!439, !438, !"_ZN5pages13solver_layout11interpolateB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd: %excinfo"}
!440 = !{!441}
!441 = distinct !{!441, !442, !"_ZN5pages13solver_layout7formulaB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %retptr"}
!442 = distinct !{!442, !"_ZN5pages13solver_layout7formulaB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29"}
!443 = !{!444, !446}
!444 = distinct !{!444, !445, !"_ZN5pages14event_location20restart_behind_eventB3v94B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!445 = distinct !{!445, !"_ZN5pages14event_location20restart_behind_eventB3v94B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!446 = distinct !{!446, !445, !"_ZN5pages14event_location20restart_behind_eventB3v94B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!447 = !{!448, !444, !446}
!448 = distinct !{!448, !449, !"_ZN5pages13solver_layout4failB3v80B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29: %retptr"}
!449 = distinct !{!449, !"_ZN5pages13solver_layout4failB3v80B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29"}
!450 = !{!451, !453}
!451 = distinct !{!451, !452, !"_ZN5pages8segments14at_segment_endB3v96B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!452 = distinct !{!452, !"_ZN5pages8segments14at_segment_endB3v96B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!453 = distinct !{!453, !454, !"_ZN5pages8segments11jump_statesB3v95B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!454 = distinct !{!454, !"_ZN5pages8segments11jump_statesB3v95B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!455 = !{!453}
!456 = !{!457, !459, !453}
!457 = distinct !{!457, !458, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!458 = distinct !{!458, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!459 = distinct !{!459, !458, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!460 = !{!461, !453}
!461 = distinct !{!461, !462, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!462 = distinct !{!462, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!463 = !{!464, !453}
!464 = distinct !{!464, !465, !"_ZN5pages8segments14at_segment_endB3v96B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!465 = distinct !{!465, !"_ZN5pages8segments14at_segment_endB3v96B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!466 = !{!467, !469, !453}
!467 = distinct !{!467, !468, !"_ZN5pages8segments11accept_jumpB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!468 = distinct !{!468, !"_ZN5pages8segments11accept_jumpB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!469 = distinct !{!469, !468, !"_ZN5pages8segments11accept_jumpB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!470 = !{!471, !467, !469, !453}
!471 = distinct !{!471, !472, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!472 = distinct !{!472, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!473 = !{!474, !476, !477, !479, !480, !482, !467, !469, !453}
!474 = distinct !{!474, !475, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!475 = distinct !{!475, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!476 = distinct !{!476, !475, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!477 = distinct !{!477, !478, !"_ZN5pages8segments13first_outsideB3v99B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2817_29: %retptr"}
!478 = distinct !{!478, !"_ZN5pages8segments13first_outsideB3v99B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2817_29"}
!479 = distinct !{!479, !478, !"_ZN5pages8segments13first_outsideB3v99B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2817_29: %excinfo"}
!480 = distinct !{!480, !481, !"_ZN5pages8segments12stop_outsideB3v98B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29: %retptr"}
!481 = distinct !{!481, !"_ZN5pages8segments12stop_outsideB3v98B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29"}
!482 = distinct !{!482, !481, !"_ZN5pages8segments12stop_outsideB3v98B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29: %excinfo"}
!483 = !{!477, !479, !480, !482, !467, !469, !453}
!484 = !{!485, !477, !479, !480, !482, !467, !469, !453}
!485 = distinct !{!485, !486, !"_ZN5pages13solver_layout10derivativeB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2814_29: %retptr"}
!486 = distinct !{!486, !"_ZN5pages13solver_layout10derivativeB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2814_29"}
!487 = !{!488, !477, !479, !480, !482, !467, !469, !453}
!488 = distinct !{!488, !489, !"_ZN5pages13solver_layout6decideB4v101B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_289_29: %retptr"}
!489 = distinct !{!489, !"_ZN5pages13solver_layout6decideB4v101B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_289_29"}
!490 = !{!491, !477, !479, !480, !482, !467, !469, !453}
!491 = distinct !{!491, !492, !"_ZN5pages13solver_layout6decideB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29: %retptr"}
!492 = distinct !{!492, !"_ZN5pages13solver_layout6decideB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29"}
!493 = !{!480, !482, !467, !469, !453}
!494 = !{!495, !480, !482, !467, !469, !453}
!495 = distinct !{!495, !496, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!496 = distinct !{!496, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!497 = !{!498, !500}
!498 = distinct !{!498, !499, !"_ZN5pages12time_stepper12end_segmentsB4v102B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!499 = distinct !{!499, !"_ZN5pages12time_stepper12end_segmentsB4v102B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!500 = distinct !{!500, !499, !"_ZN5pages12time_stepper12end_segmentsB4v102B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!501 = !{!502, !498, !500}
!502 = distinct !{!502, !503, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!503 = distinct !{!503, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!504 = !{!505, !507, !498, !500}
!505 = distinct !{!505, !506, !"_ZN5pages8segments13enter_segmentB4v103B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!506 = distinct !{!506, !"_ZN5pages8segments13enter_segmentB4v103B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!507 = distinct !{!507, !506, !"_ZN5pages8segments13enter_segmentB4v103B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!508 = !{!509, !511, !505, !507, !498, !500}
!509 = distinct !{!509, !510, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!510 = distinct !{!510, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!511 = distinct !{!511, !510, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!512 = !{!513, !498, !500}
!513 = distinct !{!513, !514, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!514 = distinct !{!514, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!515 = !{!516, !518, !513, !498, !500}
!516 = distinct !{!516, !517, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!517 = distinct !{!517, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!518 = distinct !{!518, !517, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!519 = !{!520, !522, !513, !498, !500}
!520 = distinct !{!520, !521, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!521 = distinct !{!521, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!522 = distinct !{!522, !521, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!523 = !{!524, !526, !498, !500}
!524 = distinct !{!524, !525, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!525 = distinct !{!525, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!526 = distinct !{!526, !525, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!527 = !{!528, !530}
!528 = distinct !{!528, !529, !"_ZN5pages12time_stepper11count_stepsB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!529 = distinct !{!529, !"_ZN5pages12time_stepper11count_stepsB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!530 = distinct !{!530, !529, !"_ZN5pages12time_stepper11count_stepsB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!531 = !{!532, !88, !90}
!532 = distinct !{!532, !533, !"_ZN5pages13solver_layout10derivativeB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_281_29: %retptr"}
!533 = distinct !{!533, !"_ZN5pages13solver_layout10derivativeB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_281_29"}
!534 = !{!535, !537, !88, !90}
!535 = distinct !{!535, !536, !"_ZN5pages8implicit13factor_matrixB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!536 = distinct !{!536, !"_ZN5pages8implicit13factor_matrixB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!537 = distinct !{!537, !536, !"_ZN5pages8implicit13factor_matrixB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!538 = !{!539, !541, !542, !535, !537, !88, !90}
!539 = distinct !{!539, !540, !"_ZN5pages8implicit11set_changesB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!540 = distinct !{!540, !"_ZN5pages8implicit11set_changesB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE"}
!541 = distinct !{!541, !540, !"_ZN5pages8implicit11set_changesB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!542 = distinct !{!542, !543, !"_ZN5pages8implicit13differentiateB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!543 = distinct !{!543, !"_ZN5pages8implicit13differentiateB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!544 = !{!542, !535, !537, !88, !90}
!545 = !{!546, !548, !542, !535, !537, !88, !90}
!546 = distinct !{!546, !547, !"_ZN5pages8implicit16difference_ratesB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!547 = distinct !{!547, !"_ZN5pages8implicit16difference_ratesB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!548 = distinct !{!548, !547, !"_ZN5pages8implicit16difference_ratesB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!549 = !{!550, !546, !548, !542, !535, !537, !88, !90}
!550 = distinct !{!550, !551, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!551 = distinct !{!551, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!552 = !{!553, !535, !537, !88, !90}
!553 = distinct !{!553, !554, !"_ZN5pages8implicit6factorB3v36B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!554 = distinct !{!554, !"_ZN5pages8implicit6factorB3v36B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!555 = !{!556, !558, !559, !88, !90}
!556 = distinct !{!556, !557, !"_ZN5pages8implicit5solveB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!557 = distinct !{!557, !"_ZN5pages8implicit5solveB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!558 = distinct !{!558, !557, !"_ZN5pages8implicit5solveB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!559 = distinct !{!559, !560, !"_ZN5pages8implicit11solve_stageB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!560 = distinct !{!560, !"_ZN5pages8implicit11solve_stageB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!561 = !{!559, !88, !90}
!562 = !{!563, !88, !90}
!563 = distinct !{!563, !564, !"_ZN5pages13solver_layout7formulaB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_286_29: %retptr"}
!564 = distinct !{!564, !"_ZN5pages13solver_layout7formulaB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_286_29"}
!565 = !{!566, !88, !90}
!566 = distinct !{!566, !567, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!567 = distinct !{!567, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!568 = !{!569, !88, !90}
!569 = distinct !{!569, !570, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!570 = distinct !{!570, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!571 = !{!572, !574}
!572 = distinct !{!572, !573, !"_ZN5pages12event_checks13first_crossedB3v64B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!573 = distinct !{!573, !"_ZN5pages12event_checks13first_crossedB3v64B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!574 = distinct !{!574, !573, !"_ZN5pages12event_checks13first_crossedB3v64B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!575 = !{!576, !578, !579, !581}
!576 = distinct !{!576, !577, !"_ZN5pages12event_checks13error_betweenB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!577 = distinct !{!577, !"_ZN5pages12event_checks13error_betweenB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!578 = distinct !{!578, !577, !"_ZN5pages12event_checks13error_betweenB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!579 = distinct !{!579, !580, !"_ZN5pages12event_checks8may_hideB3v67B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd: %retptr"}
!580 = distinct !{!580, !"_ZN5pages12event_checks8may_hideB3v67B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd"}
!581 = distinct !{!581, !580, !"_ZN5pages12event_checks8may_hideB3v67B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd: %excinfo"}
!582 = !{!579, !581}
!583 = !{!584, !586, !579, !581}
!584 = distinct !{!584, !585, !"_ZN5pages12event_checks17least_distance_ofB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd: %retptr"}
!585 = distinct !{!585, !"_ZN5pages12event_checks17least_distance_ofB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd"}
!586 = distinct !{!586, !585, !"_ZN5pages12event_checks17least_distance_ofB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd: %excinfo"}
!587 = !{!588}
!588 = distinct !{!588, !589, !"_ZN5pages13solver_layout5retryB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!589 = distinct !{!589, !"_ZN5pages13solver_layout5retryB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!590 = !{!591, !593}
!591 = distinct !{!591, !592, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!592 = distinct !{!592, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!593 = distinct !{!593, !592, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!594 = !{!595, !597}
!595 = distinct !{!595, !596, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!596 = distinct !{!596, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!597 = distinct !{!597, !596, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!598 = !{!599, !601}
!599 = distinct !{!599, !600, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!600 = distinct !{!600, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!601 = distinct !{!601, !600, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1314Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}

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

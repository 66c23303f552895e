; sha256 2ed204633a40090da8a7d1c2b1f9a7e090efd2500a4bba5dac0f55fe41c0810a 6987f1ba4a1c369c615528f7ea701de6b67fefd4c7d0fa5414a701168537d896, Python 3.11, numba 0.68.1

@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1, ptr null, i32 0 }
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.10 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.11 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.9 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.10, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.11, ptr null, i32 0 }
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.49 = internal constant [70 x i8] c"\80\04\95;\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AIndexError\94\93\94\8C\18tuple index out of range\94\85\94N\87\94."
@.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.50 = internal constant [20 x i8] c"\A82\A7\F8\17\\%0i*\B8.X\1E$k\F5dj("
@.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.48 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.49, i32 70, ptr @.const.pickledata.a832a7f8175c2530692ab82e581e246bf5646a28.sha1.50, ptr null, i32 0 }
@switch.table.advance_of_many.2 = private unnamed_addr constant [9 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00], align 8
@switch.table._ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7 = private unnamed_addr constant [18 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00, double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00], align 8

define dso_local range(i32 0, 2) i32 @advance_of_many(ptr noalias %v0, ptr noalias %v1, ptr readnone %v2, ptr readnone %v3, i64 %v4, i64 %v5, ptr readonly %v6, i64 %v7, i64 %v8, i64 %v9, i64 %v10, i64 %v11, i64 %v12, i64 %v13, i64 %v14, i64 %v15, i64 %v16, i64 %v17, i64 %v18, ptr readnone %v19, ptr readnone %v20, i64 %v21, i64 %v22, ptr %v23, i64 %v24, i64 %v25, ptr readnone %v26, ptr readnone %v27, i64 %v28, i64 %v29, ptr readonly %v30, i64 %v31, i64 %v32, i64 %v33, i64 %v34, ptr readnone %v35, ptr readnone %v36, i64 %v37, i64 %v38, ptr readonly %v39, i64 %v40, i64 %v41, i64 %v42, i64 %v43, ptr readnone %v44, ptr readnone %v45, i64 %v46, i64 %v47, ptr readonly %v48, i64 %v49, i64 %v50, ptr readnone %v51, ptr readnone %v52, i64 %v53, i64 %v54, ptr readonly %v55, i64 %v56, i64 %v57, ptr readnone %v58, ptr readnone %v59, i64 %v60, i64 %v61, ptr readonly %v62, i64 %v63, i64 %v64, ptr readnone %v65, ptr readnone %v66, i64 %v67, i64 %v68, ptr readonly %v69, i64 %v70, i64 %v71, ptr readnone %v72, ptr readnone %v73, i64 %v74, i64 %v75, ptr readonly %v76, i64 %v77, i64 %v78, i64 %v79, i64 %v80, ptr readnone %v81, ptr readnone %v82, i64 %v83, i64 %v84, ptr readonly %v85, i64 %v86, i64 %v87, ptr readnone %v88, ptr readnone %v89, i64 %v90, i64 %v91, ptr readonly %v92, i64 %v93, i64 %v94, ptr readnone %v95, ptr readnone %v96, i64 %v97, i64 %v98, ptr %v99, i64 %v100, i64 %v101, i64 %v102, i64 %v103, i64 %v104, i64 %v105, ptr readnone %v106, ptr readnone %v107, i64 %v108, i64 %v109, ptr %v110, i64 %v111, i64 %v112, ptr readnone %v113, ptr readnone %v114, i64 %v115, i64 %v116, ptr %v117, i64 %v118, i64 %v119, ptr readnone %v120, ptr readnone %v121, i64 %v122, i64 %v123, ptr %v124, i64 %v125, i64 %v126, i64 %v127, i64 %v128, ptr readnone %v129, ptr readnone %v130, i64 %v131, i64 %v132, ptr %v133, i64 %v134, i64 %v135, i64 %v136, i64 %v137, ptr readnone %v138, ptr readnone %v139, i64 %v140, i64 %v141, ptr %v142, i64 %v143, i64 %v144, i64 %v145, i64 %v146, ptr readnone %v147, ptr readnone %v148, i64 %v149, i64 %v150, ptr %v151, i64 %v152, i64 %v153, ptr readnone %v154, ptr readnone %v155, i64 %v156, i64 %v157, ptr %v158, i64 %v159, i64 %v160, ptr readnone %v161, ptr readnone %v162, i64 %v163, i64 %v164, ptr %v165, i64 %v166, i64 %v167, ptr readnone %v168, ptr readnone %v169, i64 %v170, i64 %v171, ptr %v172, i64 %v173, i64 %v174, ptr readnone %v175, ptr readnone %v176, i64 %v177, i64 %v178, ptr %v179, i64 %v180, i64 %v181, ptr readnone %v182, ptr readnone %v183, i64 %v184, i64 %v185, ptr %v186, i64 %v187, i64 %v188, ptr readnone %v189, ptr readnone %v190, i64 %v191, i64 %v192, ptr %v193, i64 %v194, i64 %v195, i64 %v196, i64 %v197, i64 %v198, i64 %v199, ptr readnone %v200, ptr readnone %v201, i64 %v202, i64 %v203, ptr %v204, i64 %v205, i64 %v206, i64 %v207, i64 %v208, i64 %v209, i64 %v210, ptr readnone %v211, ptr readnone %v212, i64 %v213, i64 %v214, ptr readonly %v215, i64 %v216, i64 %v217, ptr readnone %v218, ptr readnone %v219, i64 %v220, i64 %v221, ptr %v222, i64 %v223, i64 %v224, ptr readnone %v225, ptr readnone %v226, i64 %v227, i64 %v228, ptr %v229, i64 %v230, i64 %v231, ptr readnone %v232, ptr readnone %v233, i64 %v234, i64 %v235, ptr %v236, i64 %v237, i64 %v238, ptr readnone %v239, ptr readnone %v240, i64 %v241, i64 %v242, ptr %v243, i64 %v244, i64 %v245, ptr readnone %v246, ptr readnone %v247, i64 %v248, i64 %v249, ptr %v250, i64 %v251, i64 %v252, i64 %v253, i64 %v254, ptr readnone %v255, ptr readnone %v256, i64 %v257, i64 %v258, ptr readonly %v259, i64 %v260, i64 %v261, ptr readnone %v262, ptr readnone %v263, i64 %v264, i64 %v265, ptr readonly %v266, i64 %v267, i64 %v268, ptr readnone %v269, ptr readnone %v270, i64 %v271, i64 %v272, ptr readonly %v273, i64 %v274, i64 %v275, ptr readnone %v276, ptr readnone %v277, i64 %v278, i64 %v279, ptr readonly %v280, i64 %v281, i64 %v282, ptr readnone %v283, ptr readnone %v284, i64 %v285, i64 %v286, ptr readonly %v287, i64 %v288, i64 %v289, ptr readnone %v290, ptr readnone %v291, i64 %v292, i64 %v293, ptr readonly %v294, i64 %v295, i64 %v296, i64 %v297, i64 %v298) local_unnamed_addr {
v299:
  %v300 = alloca [4 x double], align 8
  %v301 = alloca ptr, align 8
  %v302 = alloca [4 x double], align 8
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
  %v323 = mul i64 %v135, 208
  %v324 = getelementptr i8, ptr %v133, i64 %v323
  %v325 = mul i64 %v135, 120
  %v326 = getelementptr i8, ptr %v133, i64 %v325
  %v327 = mul i64 %v135, 200
  %v328 = getelementptr i8, ptr %v133, i64 %v327
  %v329 = mul i64 %v135, 216
  %v330 = getelementptr i8, ptr %v133, i64 %v329
  %v331 = shl i64 %v135, 4
  %v332 = getelementptr i8, ptr %v133, i64 %v331
  br label %v333

v334:
  %v335 = getelementptr double, ptr %v312, i64 %v336
  store double 0.000000e+00, ptr %v335, align 8, !noalias !0
  %v337 = load i64, ptr %v151, align 8, !noalias !0
  %v338 = load i64, ptr %v313, align 8, !noalias !0
  %v339 = icmp eq i64 %v337, %v338
  br i1 %v339, label %v340, label %v341

v341:
  %v342 = add nsw i64 %v337, 1
  store i64 %v342, ptr %v151, align 8, !noalias !0
  store i64 2, ptr %v314, align 8, !noalias !0
  %v343 = getelementptr i64, ptr %v142, i64 %v336
  store i64 %v337, ptr %v343, align 8, !noalias !0
  %v344 = icmp slt i64 %v337, 0
  %v345 = select i1 %v344, i64 %v49, i64 0
  %v346 = getelementptr i64, ptr %v48, i64 %v337
  %v347 = getelementptr i64, ptr %v346, i64 %v345
  %v348 = load i64, ptr %v347, align 8, !noalias !0
  %v349 = icmp slt i64 %v348, 0
  %v350 = select i1 %v349, i64 %v56, i64 0
  %v351 = getelementptr i64, ptr %v55, i64 %v348
  %v352 = getelementptr i64, ptr %v351, i64 %v350
  %v353 = load i64, ptr %v352, align 8, !noalias !0
  %v354 = getelementptr i64, ptr %v315, i64 %v336
  store i64 %v353, ptr %v354, align 8, !noalias !0
  %v355 = getelementptr i64, ptr %v317, i64 %v336
  store i64 1, ptr %v355, align 8, !noalias !0
  %v356 = getelementptr i64, ptr %v319, i64 %v336
  store i64 0, ptr %v356, align 8, !noalias !0
  br i1 %v320, label %v357, label %v358

v358:
  %v359 = select i1 %v344, i64 %v40, i64 0
  %v360 = add i64 %v359, %v337
  %v361 = mul i64 %v360, %v41
  %v362 = getelementptr double, ptr %v39, i64 %v361
  %v363 = getelementptr double, ptr %v165, i64 %v336
  br label %v364

v357:
  br i1 %v321, label %v365, label %v366

v366:
  %v367 = load i64, ptr %v354, align 8, !noalias !0
  %v368 = icmp slt i64 %v367, 0
  %v369 = select i1 %v368, i64 %v77, i64 0
  %v370 = add i64 %v369, %v367
  %v371 = mul i64 %v370, %v78
  %v372 = getelementptr double, ptr %v76, i64 %v371
  br label %v373

v373:
  %v374 = phi i64 [ 0, %v366 ], [ %v375, %v373 ]
  %v375 = add nsw i64 %v374, 1
  %v376 = getelementptr double, ptr %v372, i64 %v374
  %v377 = load double, ptr %v376, align 8, !noalias !3
  %v378 = getelementptr i64, ptr %v62, i64 %v374
  %v379 = load i64, ptr %v378, align 8, !noalias !3
  %v380 = mul nsw i64 %v379, %v9
  %v381 = add nsw i64 %v380, %v336
  %v382 = icmp slt i64 %v381, 0
  %v383 = select i1 %v382, i64 %v166, i64 0
  %v384 = getelementptr double, ptr %v165, i64 %v381
  %v385 = getelementptr double, ptr %v384, i64 %v383
  store double %v377, ptr %v385, align 8, !noalias !3
  %v386 = icmp eq i64 %v375, %v63
  br i1 %v386, label %v365, label %v373

v387:
  %v388 = getelementptr double, ptr %v133, i64 %v336
  br label %v389

v390:
  %v391 = mul i64 %v392, %v135
  %v393 = getelementptr double, ptr %v388, i64 %v391
  %v394 = load double, ptr %v393, align 8, !noalias !7
  %v395 = fcmp une double %v394, 0xFFF0000000000000
  br i1 %v395, label %v396, label %v397

v396:
  %v398 = mul i64 %v392, %v135
  %v399 = getelementptr double, ptr %v388, i64 %v398
  store double 0.000000e+00, ptr %v399, align 8, !noalias !7
  br label %v397

v397:
  %v400 = icmp eq i64 %v401, 32
  br i1 %v400, label %v402, label %v389

v402:
  %v403 = getelementptr double, ptr %v324, i64 %v336
  store double 5.000000e+03, ptr %v403, align 8, !noalias !7
  store double 1.000000e+00, ptr %v335, align 8, !noalias !7
  %v404 = getelementptr double, ptr %v326, i64 %v336
  store double 0xFFF0000000000000, ptr %v404, align 8, !noalias !7
  %v405 = getelementptr double, ptr %v328, i64 %v336
  store double 0x7FF0000000000000, ptr %v405, align 8, !noalias !7
  %v406 = load double, ptr %v92, align 8, !noalias !0
  store double %v406, ptr %v388, align 8, !noalias !0
  %v407 = load double, ptr %v92, align 8, !noalias !0
  %v408 = getelementptr double, ptr %v330, i64 %v336
  store double %v407, ptr %v408, align 8, !noalias !0
  %v409 = load i64, ptr %v354, align 8, !noalias !0
  %v410 = icmp slt i64 %v409, 0
  %v411 = select i1 %v410, i64 %v70, i64 0
  %v412 = getelementptr double, ptr %v69, i64 %v409
  %v413 = getelementptr double, ptr %v412, i64 %v411
  %v414 = load double, ptr %v413, align 8, !noalias !0
  %v415 = getelementptr double, ptr %v332, i64 %v336
  store double %v414, ptr %v415, align 8, !noalias !0
  br label %v340

v389:
  %v392 = phi i64 [ 0, %v387 ], [ %v401, %v397 ]
  %v401 = add nsw i64 %v392, 1
  %v416 = icmp ult i64 %v392, 30
  br i1 %v416, label %v396, label %v390

v364:
  %v417 = phi i64 [ 0, %v358 ], [ %v418, %v364 ]
  %v418 = add nsw i64 %v417, 1
  %v419 = getelementptr double, ptr %v362, i64 %v417
  %v420 = load double, ptr %v419, align 8, !noalias !0
  %v421 = mul nsw i64 %v417, %v9
  %v422 = getelementptr double, ptr %v363, i64 %v421
  store double %v420, ptr %v422, align 8, !noalias !0
  %v423 = icmp eq i64 %v418, %v41
  br i1 %v423, label %v357, label %v364

v365:
  br i1 %v322, label %v387, label %v424

v424:
  %v425 = getelementptr double, ptr %v193, i64 %v336
  %v426 = select i1 %v344, i64 %v31, i64 0
  %v427 = add i64 %v426, %v337
  %v428 = mul i64 %v427, %v32
  %v429 = getelementptr double, ptr %v30, i64 %v428
  br label %v430

v430:
  %v431 = phi i64 [ 0, %v424 ], [ %v432, %v430 ]
  %v432 = add nsw i64 %v431, 1
  %v433 = getelementptr double, ptr %v429, i64 %v431
  %v434 = load double, ptr %v433, align 8, !noalias !0
  %v435 = mul i64 %v431, %v196
  %v436 = getelementptr double, ptr %v425, i64 %v435
  store double %v434, ptr %v436, align 8, !noalias !0
  %v437 = icmp eq i64 %v432, %v10
  br i1 %v437, label %v387, label %v430

v340:
  %v438 = load i64, ptr %v439, align 8
  %v440 = icmp sgt i64 %v438, -1
  %v441 = zext i1 %v440 to i64
  %v442 = add nsw i64 %v443, %v441
  %v444 = icmp sgt i64 %v445, 1
  br i1 %v444, label %v333, label %v309

v309:
  %v446 = phi i64 [ 0, %v299 ], [ %v442, %v340 ]
  %v447 = icmp ne i64 %v446, 0
  %v448 = icmp sgt i64 %v297, 0
  %v449 = select i1 %v447, i1 %v448, i1 false
  br i1 %v449, label %v450, label %v451

v450:
  %v452 = getelementptr i8, ptr %v151, i64 16
  %v453 = mul i64 %v10, %v9
  %v454 = mul i64 %v196, %v195
  %v455 = shl i64 %v196, 7
  %v456 = mul i64 %v207, %v206
  %v457 = getelementptr i8, ptr %v6, i64 8
  %v458 = getelementptr i8, ptr %v6, i64 32
  %v459 = mul i64 %v135, 24
  %v460 = getelementptr i8, ptr %v133, i64 %v459
  %v461 = icmp sgt i64 %v18, 0
  %v462 = icmp sgt i64 %v18, 0
  %v463 = icmp eq i64 %v14, 0
  %v464 = mul nsw i64 %v10, %v9
  %v465 = shl i64 %v464, 4
  %v466 = getelementptr i8, ptr %v158, i64 %v465
  %v467 = getelementptr i8, ptr %v6, i64 56
  %v468 = getelementptr i8, ptr %v6, i64 64
  %v469 = shl i64 %v135, 6
  %v470 = getelementptr i8, ptr %v133, i64 %v469
  %v471 = mul i64 %v464, 136
  %v472 = getelementptr i8, ptr %v158, i64 %v471
  %v473 = mul i64 %v464, 24
  %v474 = getelementptr i8, ptr %v158, i64 %v473
  %v475 = getelementptr i8, ptr %v6, i64 72
  %v476 = mul i64 %v453, 112
  %v477 = mul i64 %v135, 24
  %v478 = getelementptr i8, ptr %v133, i64 %v477
  %v479 = shl i64 %v135, 5
  %v480 = getelementptr i8, ptr %v133, i64 %v479
  %v481 = shl i64 %v135, 8
  %v482 = getelementptr i8, ptr %v133, i64 %v481
  %v483 = icmp slt i64 %v14, 1
  %v484 = select i1 %v483, i64 2, i64 0
  %v485 = zext i1 %v483 to i64
  %v486 = mul i64 %v135, 88
  %v487 = getelementptr i8, ptr %v133, i64 %v486
  %v488 = icmp eq i64 %v15, 0
  %v489 = getelementptr double, ptr %v92, i64 %v93
  %v490 = getelementptr i8, ptr %v489, i64 -8
  %v491 = shl i64 %v135, 6
  %v492 = getelementptr i8, ptr %v133, i64 %v491
  %v493 = getelementptr i8, ptr %v158, i64 %v476
  %v494 = icmp slt i64 %v10, 1
  %v495 = mul i64 %v196, %v195
  %v496 = mul i64 %v495, 112
  %v497 = getelementptr i8, ptr %v193, i64 %v496
  %v498 = shl i64 %v495, 7
  %v499 = getelementptr i8, ptr %v193, i64 %v498
  %v500 = getelementptr i8, ptr %v6, i64 32
  %v501 = mul i64 %v207, 216
  %v502 = getelementptr i8, ptr %v186, i64 %v501
  %v503 = shl i64 %v10, 7
  %v504 = getelementptr i8, ptr %v158, i64 %v503
  %v505 = mul i64 %v207, 240
  %v506 = getelementptr i8, ptr %v186, i64 %v505
  %v507 = sub i64 %v207, %v18
  %v508 = tail call i64 @llvm.smax.i64(i64 %v507, i64 0)
  %v509 = getelementptr double, ptr %v204, i64 %v207
  %v510 = mul i64 %v207, %v206
  %v511 = mul i64 %v510, 80
  %v512 = getelementptr i8, ptr %v509, i64 %v511
  %v513 = mul i64 %v510, 72
  %v514 = getelementptr i8, ptr %v204, i64 %v513
  %v515 = getelementptr double, ptr %v514, i64 %v207
  %v516 = shl i64 %v207, 4
  %v517 = getelementptr i8, ptr %v514, i64 %v516
  %v518 = shl i64 %v144, 5
  %v519 = getelementptr i8, ptr %v142, i64 %v518
  %v520 = shl i64 %v135, 4
  %v521 = getelementptr i8, ptr %v133, i64 %v520
  %v522 = mul i64 %v135, 112
  %v523 = getelementptr i8, ptr %v133, i64 %v522
  %v524 = shl i64 %v135, 4
  %v525 = getelementptr i8, ptr %v133, i64 %v524
  %v526 = mul i64 %v135, 144
  %v527 = getelementptr i8, ptr %v133, i64 %v526
  %v528 = shl i64 %v144, 4
  %v529 = getelementptr i8, ptr %v142, i64 %v528
  %v530 = getelementptr i8, ptr %v6, i64 40
  %v531 = icmp sgt i64 %v14, 0
  %v532 = mul nsw i64 %v10, %v9
  %v533 = getelementptr double, ptr %v158, i64 %v532
  %v534 = icmp sgt i64 %v13, 0
  %v535 = shl i64 %v135, 5
  %v536 = getelementptr i8, ptr %v133, i64 %v535
  %v537 = icmp slt i64 %v10, 1
  %v538 = mul i64 %v196, %v195
  %v539 = mul i64 %v538, 136
  %v540 = getelementptr i8, ptr %v193, i64 %v539
  %v541 = mul i64 %v538, 88
  %v542 = getelementptr i8, ptr %v193, i64 %v541
  %v543 = mul nsw i64 %v10, 19
  %v544 = add nsw i64 %v543, 1
  %v545 = mul nsw i64 %v10, 18
  %v546 = icmp slt i64 %v10, 0
  %v547 = select i1 %v546, i64 %v159, i64 0
  %v548 = add i64 %v547, %v545
  %v549 = icmp slt i64 %v548, 0
  %v550 = icmp slt i64 %v548, %v159
  %v551 = add i64 %v544, %v547
  %v552 = icmp slt i64 %v551, 0
  %v553 = icmp slt i64 %v551, %v159
  %v554 = icmp sgt i64 %v274, 1
  %v555 = mul i64 %v196, %v195
  %v556 = getelementptr i8, ptr %v23, i64 8
  %v557 = select i1 %v546, i64 %v267, i64 0
  %v558 = getelementptr i64, ptr %v266, i64 %v10
  %v559 = getelementptr i64, ptr %v558, i64 %v557
  %v560 = mul i64 %v135, 48
  %v561 = getelementptr i8, ptr %v133, i64 %v560
  %v562 = mul i64 %v555, 136
  %v563 = shl i64 %v135, 6
  %v564 = getelementptr i8, ptr %v133, i64 %v563
  %v565 = mul nsw i64 %v10, %v9
  %v566 = mul i64 %v565, 136
  %v567 = getelementptr i8, ptr %v158, i64 %v566
  %v568 = getelementptr i8, ptr %v193, i64 %v562
  %v569 = mul i64 %v555, 96
  %v570 = getelementptr i8, ptr %v193, i64 %v569
  %v571 = mul i64 %v555, 104
  %v572 = getelementptr i8, ptr %v193, i64 %v571
  %v573 = getelementptr double, ptr %v193, i64 %v555
  %v574 = mul i64 %v555, 88
  %v575 = getelementptr i8, ptr %v193, i64 %v574
  %v576 = mul i64 %v565, 96
  %v577 = getelementptr i8, ptr %v158, i64 %v576
  %v578 = mul i64 %v565, 96
  %v579 = getelementptr i8, ptr %v158, i64 %v578
  %v580 = mul i64 %v565, 104
  %v581 = getelementptr i8, ptr %v158, i64 %v580
  %v582 = add nsw i64 %v274, -2
  %v583 = icmp sgt i64 %v10, 0
  %v584 = add i64 %v254, %v253
  %v585 = add i64 %v253, 1
  %v586 = add i64 %v10, 1
  %v587 = mul i64 %v135, 136
  %v588 = getelementptr i8, ptr %v133, i64 %v587
  %v589 = add i64 %v254, 1
  %v590 = add i64 %v11, -1
  %v591 = tail call i64 @llvm.smax.i64(i64 %v590, i64 0)
  %v592 = mul i64 %v454, 136
  %v593 = icmp slt i64 %v590, 1
  %v594 = shl i64 %v135, 6
  %v595 = getelementptr i8, ptr %v133, i64 %v594
  %v596 = mul nsw i64 %v10, %v9
  %v597 = mul i64 %v596, 136
  %v598 = getelementptr i8, ptr %v158, i64 %v597
  %v599 = icmp slt i64 %v10, 1
  %v600 = mul i64 %v196, %v195
  %v601 = mul i64 %v600, 80
  %v602 = getelementptr i8, ptr %v193, i64 %v601
  %v603 = mul i64 %v600, 136
  %v604 = getelementptr i8, ptr %v193, i64 %v603
  %v605 = mul nsw i64 %v10, 17
  %v606 = getelementptr double, ptr %v158, i64 %v605
  %v607 = add i64 %v253, 1
  %v608 = add i64 %v253, 1
  %v609 = getelementptr double, ptr %v158, i64 %v605
  %v610 = add i64 %v254, %v253
  %v611 = getelementptr i8, ptr %v193, i64 %v592
  %v612 = mul i64 %v196, %v195
  %v613 = getelementptr i8, ptr %v6, i64 48
  %v614 = or i1 %v534, %v306
  %v615 = mul i64 %v135, 40
  %v616 = getelementptr i8, ptr %v133, i64 %v615
  %v617 = mul i64 %v135, 160
  %v618 = getelementptr i8, ptr %v133, i64 %v617
  %v619 = mul i64 %v135, 168
  %v620 = getelementptr i8, ptr %v133, i64 %v619
  %v621 = mul i64 %v135, 176
  %v622 = getelementptr i8, ptr %v133, i64 %v621
  %v623 = mul i64 %v135, 152
  %v624 = getelementptr i8, ptr %v133, i64 %v623
  %v625 = shl i64 %v144, 4
  %v626 = getelementptr i8, ptr %v142, i64 %v625
  %v627 = mul i64 %v135, 184
  %v628 = getelementptr i8, ptr %v133, i64 %v627
  %v629 = mul i64 %v135, 72
  %v630 = getelementptr i8, ptr %v133, i64 %v629
  %v631 = mul i64 %v135, 40
  %v632 = getelementptr i8, ptr %v133, i64 %v631
  %v633 = mul i64 %v135, 56
  %v634 = getelementptr i8, ptr %v133, i64 %v633
  %v635 = mul i64 %v135, 240
  %v636 = getelementptr i8, ptr %v133, i64 %v635
  %v637 = icmp eq i64 %v14, 0
  %v638 = icmp ne i64 %v13, 0
  %v639 = xor i1 %v637, true
  %v640 = select i1 %v639, i1 true, i1 %v638
  %v641 = shl i64 %v135, 6
  %v642 = getelementptr i8, ptr %v133, i64 %v641
  %v643 = mul nsw i64 %v10, %v9
  %v644 = mul i64 %v643, 136
  %v645 = getelementptr i8, ptr %v158, i64 %v644
  %v646 = mul i64 %v643, 104
  %v647 = getelementptr i8, ptr %v158, i64 %v646
  %v648 = getelementptr i8, ptr %v6, i64 104
  %v649 = getelementptr i8, ptr %v6, i64 96
  %v650 = mul i64 %v196, %v195
  %v651 = mul i64 %v135, 48
  %v652 = getelementptr i8, ptr %v133, i64 %v651
  %v653 = shl i64 %v135, 6
  %v654 = getelementptr i8, ptr %v133, i64 %v653
  %v655 = shl i64 %v650, 7
  %v656 = icmp slt i64 %v10, 1
  %v657 = getelementptr i8, ptr %v193, i64 %v655
  %v658 = mul i64 %v207, 3
  %v659 = getelementptr i8, ptr %v6, i64 32
  %v660 = mul i64 %v650, 192
  %v661 = mul i64 %v650, 184
  %v662 = mul i64 %v650, 176
  %v663 = mul i64 %v650, 168
  %v664 = mul i64 %v650, 160
  %v665 = mul i64 %v650, 152
  %v666 = mul i64 %v650, 144
  %v667 = mul i64 %v135, 56
  %v668 = getelementptr i8, ptr %v133, i64 %v667
  %v669 = tail call i64 @llvm.smax.i64(i64 %v207, i64 0)
  %v670 = mul i64 %v207, %v206
  %v671 = getelementptr double, ptr %v204, i64 %v207
  %v672 = mul i64 %v207, %v206
  %v673 = getelementptr double, ptr %v204, i64 %v207
  %v674 = getelementptr double, ptr %v204, i64 %v207
  %v675 = shl i64 %v207, 4
  %v676 = getelementptr i8, ptr %v204, i64 %v675
  %v677 = icmp sgt i64 %v12, 0
  %v678 = add nsw i64 %v11, 13
  %v679 = shl i64 %v135, 6
  %v680 = getelementptr i8, ptr %v133, i64 %v679
  %v681 = mul nsw i64 %v10, %v9
  %v682 = mul i64 %v681, 136
  %v683 = getelementptr i8, ptr %v158, i64 %v682
  %v684 = icmp slt i64 %v11, -13
  %v685 = select i1 %v684, i64 %v7, i64 0
  %v686 = getelementptr i64, ptr %v6, i64 %v11
  %v687 = getelementptr i8, ptr %v686, i64 104
  %v688 = getelementptr i64, ptr %v687, i64 %v685
  %v689 = getelementptr i8, ptr %v6, i64 88
  %v690 = shl i64 %v144, 4
  %v691 = getelementptr i8, ptr %v142, i64 %v690
  %v692 = mul i64 %v135, 40
  %v693 = getelementptr i8, ptr %v133, i64 %v692
  %v694 = mul i64 %v135, 56
  %v695 = getelementptr i8, ptr %v133, i64 %v694
  %v696 = mul i64 %v135, 192
  %v697 = getelementptr i8, ptr %v133, i64 %v696
  %v698 = mul i64 %v135, 48
  %v699 = getelementptr i8, ptr %v133, i64 %v698
  %v700 = shl i64 %v135, 5
  %v701 = getelementptr i8, ptr %v133, i64 %v700
  %v702 = getelementptr double, ptr %v133, i64 %v135
  %v703 = mul i64 %v135, 200
  %v704 = getelementptr i8, ptr %v133, i64 %v703
  %v705 = getelementptr inbounds i8, ptr %v302, i64 8
  %v706 = getelementptr inbounds i8, ptr %v302, i64 16
  %v707 = getelementptr inbounds i8, ptr %v302, i64 24
  %v708 = mul i64 %v196, %v195
  %v709 = mul i64 %v135, 48
  %v710 = getelementptr i8, ptr %v133, i64 %v709
  %v711 = shl i64 %v135, 6
  %v712 = getelementptr i8, ptr %v133, i64 %v711
  %v713 = shl i64 %v708, 7
  %v714 = icmp sgt i64 %v10, 0
  %v715 = getelementptr i8, ptr %v193, i64 %v713
  %v716 = mul i64 %v207, 3
  %v717 = getelementptr i8, ptr %v6, i64 32
  %v718 = mul i64 %v708, 192
  %v719 = mul i64 %v708, 184
  %v720 = mul i64 %v708, 176
  %v721 = mul i64 %v708, 168
  %v722 = mul i64 %v708, 160
  %v723 = mul i64 %v708, 152
  %v724 = mul i64 %v708, 144
  %v725 = getelementptr double, ptr %v92, i64 %v93
  %v726 = getelementptr i8, ptr %v725, i64 -8
  %v727 = icmp slt i64 %v15, 1
  %v728 = mul i64 %v207, %v206
  %v729 = shl i64 %v207, 4
  %v730 = getelementptr double, ptr %v204, i64 %v207
  %v731 = getelementptr i8, ptr %v204, i64 %v729
  %v732 = shl i64 %v728, 4
  %v733 = mul i64 %v728, 24
  %v734 = shl i64 %v728, 5
  %v735 = mul i64 %v728, 40
  %v736 = mul i64 %v728, 48
  %v737 = mul i64 %v728, 56
  %v738 = shl i64 %v728, 6
  %v739 = shl i64 %v144, 5
  %v740 = getelementptr i8, ptr %v142, i64 %v739
  %v741 = getelementptr double, ptr %v92, i64 %v93
  %v742 = getelementptr i8, ptr %v741, i64 -8
  %v743 = mul i64 %v135, 56
  %v744 = getelementptr i8, ptr %v133, i64 %v743
  %v745 = mul i64 %v135, 120
  %v746 = getelementptr i8, ptr %v133, i64 %v745
  %v747 = mul i64 %v207, %v206
  %v748 = shl i64 %v10, 7
  %v749 = getelementptr i8, ptr %v158, i64 %v748
  %v750 = mul i64 %v207, 216
  %v751 = getelementptr i8, ptr %v186, i64 %v750
  %v752 = sub i64 %v207, %v18
  %v753 = tail call i64 @llvm.smax.i64(i64 %v752, i64 0)
  %v754 = icmp sgt i64 %v752, 0
  %v755 = shl i64 %v747, 6
  %v756 = getelementptr i8, ptr %v204, i64 %v755
  %v757 = shl i64 %v207, 4
  %v758 = getelementptr i8, ptr %v756, i64 %v757
  %v759 = mul i64 %v747, 72
  %v760 = getelementptr i8, ptr %v204, i64 %v759
  %v761 = getelementptr i8, ptr %v760, i64 %v757
  %v762 = icmp slt i64 %v207, 1
  %v763 = getelementptr double, ptr %v760, i64 %v207
  %v764 = getelementptr inbounds i8, ptr %v300, i64 8
  %v765 = getelementptr inbounds i8, ptr %v300, i64 16
  %v766 = getelementptr inbounds i8, ptr %v300, i64 24
  %v767 = mul i64 %v747, 80
  %v768 = getelementptr i8, ptr %v204, i64 %v767
  %v769 = tail call i64 @llvm.smax.i64(i64 %v10, i64 0)
  %v770 = mul i64 %v455, %v195
  %v771 = getelementptr i8, ptr %v193, i64 %v770
  %v772 = mul nsw i64 %v10, %v9
  %v773 = shl i64 %v772, 7
  %v774 = getelementptr i8, ptr %v158, i64 %v773
  %v775 = mul i64 %v772, 112
  %v776 = getelementptr i8, ptr %v158, i64 %v775
  %v777 = getelementptr i8, ptr %v6, i64 8
  %v778 = mul i64 %v772, 120
  %v779 = getelementptr i8, ptr %v158, i64 %v778
  %v780 = getelementptr i8, ptr %v23, i64 8
  %v781 = mul i64 %v708, 120
  %v782 = getelementptr i8, ptr %v193, i64 %v781
  %v783 = mul i64 %v708, 112
  %v784 = getelementptr i8, ptr %v193, i64 %v783
  %v785 = mul i64 %v135, 40
  %v786 = getelementptr i8, ptr %v133, i64 %v785
  %v787 = icmp slt i64 %v18, 1
  %v788 = mul i64 %v747, 80
  %v789 = getelementptr i8, ptr %v204, i64 %v788
  %v790 = mul i64 %v772, 136
  %v791 = getelementptr i8, ptr %v158, i64 %v790
  %v792 = mul i64 %v772, 104
  %v793 = getelementptr i8, ptr %v158, i64 %v792
  %v794 = mul i64 %v135, 40
  %v795 = getelementptr i8, ptr %v133, i64 %v794
  %v796 = select i1 %v762, i64 0, i64 %v207
  %v797 = icmp slt i64 %v10, 1
  %v798 = icmp slt i64 %v752, 1
  %v799 = mul i64 %v135, 104
  %v800 = getelementptr i8, ptr %v133, i64 %v799
  %v801 = mul i64 %v135, 112
  %v802 = getelementptr i8, ptr %v133, i64 %v801
  %v803 = shl i64 %v144, 4
  %v804 = getelementptr i8, ptr %v142, i64 %v803
  %v805 = mul i64 %v135, 200
  %v806 = getelementptr i8, ptr %v133, i64 %v805
  %v807 = mul i64 %v102, %v101
  %v808 = mul i64 %v708, 136
  %v809 = getelementptr i8, ptr %v193, i64 %v808
  %v810 = add i64 %v93, -1
  %v811 = mul i64 %v135, 40
  %v812 = getelementptr i8, ptr %v133, i64 %v811
  %v813 = mul i64 %v135, 96
  %v814 = getelementptr i8, ptr %v133, i64 %v813
  %v815 = mul i64 %v135, 192
  %v816 = getelementptr i8, ptr %v133, i64 %v815
  %v817 = mul i64 %v135, 40
  %v818 = getelementptr i8, ptr %v133, i64 %v817
  %v819 = shl i64 %v135, 5
  %v820 = getelementptr i8, ptr %v133, i64 %v819
  %v821 = getelementptr double, ptr %v133, i64 %v135
  %v822 = icmp slt i64 %v10, 1
  %v823 = mul i64 %v708, 136
  %v824 = getelementptr i8, ptr %v193, i64 %v823
  %v825 = mul nsw i64 %v10, %v9
  %v826 = mul i64 %v825, 136
  %v827 = getelementptr i8, ptr %v158, i64 %v826
  %v828 = mul i64 %v825, 104
  %v829 = getelementptr i8, ptr %v158, i64 %v828
  %v830 = mul i64 %v10, 136
  %v831 = getelementptr i8, ptr %v158, i64 %v830
  %v832 = mul i64 %v207, 192
  %v833 = getelementptr i8, ptr %v186, i64 %v832
  %v834 = mul i64 %v196, %v195
  %v835 = mul i64 %v135, 40
  %v836 = getelementptr i8, ptr %v133, i64 %v835
  %v837 = mul i64 %v135, 56
  %v838 = getelementptr i8, ptr %v133, i64 %v837
  %v839 = shl i64 %v144, 4
  %v840 = getelementptr i8, ptr %v142, i64 %v839
  %v841 = mul i64 %v135, 48
  %v842 = getelementptr i8, ptr %v133, i64 %v841
  %v843 = mul i64 %v834, 136
  %v844 = icmp slt i64 %v10, 1
  %v845 = mul i64 %v135, 200
  %v846 = getelementptr i8, ptr %v133, i64 %v845
  %v847 = mul i64 %v102, %v101
  %v848 = getelementptr i8, ptr %v193, i64 %v843
  %v849 = add i64 %v93, -1
  %v850 = mul i64 %v834, 192
  %v851 = mul i64 %v834, 184
  %v852 = mul i64 %v834, 176
  %v853 = mul i64 %v834, 168
  %v854 = mul i64 %v834, 160
  %v855 = mul i64 %v834, 152
  %v856 = mul i64 %v834, 144
  %v857 = icmp sgt i64 %v9, 1
  %v858 = mul i64 %v135, 40
  %v859 = getelementptr i8, ptr %v133, i64 %v858
  %v860 = getelementptr i8, ptr %v6, i64 80
  %v861 = mul i64 %v135, 40
  %v862 = getelementptr i8, ptr %v133, i64 %v861
  %v863 = shl i64 %v456, 6
  %v864 = icmp sgt i64 %v18, 0
  %v865 = getelementptr i8, ptr %v204, i64 %v863
  %v866 = mul i64 %v135, 96
  %v867 = getelementptr i8, ptr %v133, i64 %v866
  %v868 = mul i64 %v135, 120
  %v869 = getelementptr i8, ptr %v133, i64 %v868
  %v870 = icmp slt i64 %v10, 1
  %v871 = getelementptr i8, ptr %v23, i64 8
  %v872 = getelementptr double, ptr %v92, i64 %v93
  %v873 = getelementptr i8, ptr %v872, i64 -8
  %v874 = mul i64 %v144, 24
  %v875 = getelementptr i8, ptr %v142, i64 %v874
  %v876 = mul i64 %v144, 24
  %v877 = getelementptr i8, ptr %v142, i64 %v876
  %v878 = mul i64 %v135, 24
  %v879 = getelementptr i8, ptr %v133, i64 %v878
  %v880 = icmp ne i64 %v16, 0
  %v881 = tail call i64 @llvm.smax.i64(i64 %v9, i64 0)
  %v882 = mul i64 %v135, 40
  %v883 = getelementptr i8, ptr %v133, i64 %v882
  %v884 = shl i64 %v135, 4
  %v885 = getelementptr i8, ptr %v133, i64 %v884
  %v886 = getelementptr i64, ptr %v142, i64 %v144
  %v887 = icmp slt i64 %v63, 1
  %v888 = getelementptr i8, ptr %v6, i64 8
  %v889 = mul nsw i64 %v10, %v9
  %v890 = getelementptr i8, ptr %v6, i64 24
  %v891 = mul i64 %v889, 136
  %v892 = getelementptr i8, ptr %v158, i64 %v891
  %v893 = mul i64 %v102, %v101
  %v894 = add nsw i64 %v881, -1
  %v895 = mul i64 %v196, %v195
  %v896 = shl i64 %v144, 4
  %v897 = getelementptr i8, ptr %v142, i64 %v896
  %v898 = mul i64 %v895, 136
  %v899 = icmp slt i64 %v10, 1
  %v900 = getelementptr i8, ptr %v193, i64 %v898
  %v901 = icmp eq i64 %v15, 0
  %v902 = getelementptr double, ptr %v92, i64 %v93
  %v903 = getelementptr i8, ptr %v902, i64 -8
  %v904 = shl i64 %v135, 6
  %v905 = getelementptr i8, ptr %v133, i64 %v904
  %v906 = mul i64 %v889, 112
  %v907 = getelementptr i8, ptr %v158, i64 %v906
  %v908 = mul i64 %v895, 112
  %v909 = getelementptr i8, ptr %v193, i64 %v908
  %v910 = shl i64 %v895, 7
  %v911 = getelementptr i8, ptr %v193, i64 %v910
  %v912 = getelementptr i8, ptr %v6, i64 32
  %v913 = mul i64 %v10, 136
  %v914 = getelementptr i8, ptr %v158, i64 %v913
  %v915 = mul i64 %v207, 216
  %v916 = getelementptr i8, ptr %v186, i64 %v915
  %v917 = shl i64 %v10, 7
  %v918 = getelementptr i8, ptr %v158, i64 %v917
  %v919 = mul i64 %v207, 240
  %v920 = getelementptr i8, ptr %v186, i64 %v919
  %v921 = sub i64 %v207, %v18
  %v922 = tail call i64 @llvm.smax.i64(i64 %v921, i64 0)
  %v923 = getelementptr double, ptr %v204, i64 %v207
  %v924 = mul i64 %v207, %v206
  %v925 = mul i64 %v924, 80
  %v926 = getelementptr i8, ptr %v923, i64 %v925
  %v927 = mul i64 %v924, 72
  %v928 = getelementptr i8, ptr %v204, i64 %v927
  %v929 = getelementptr double, ptr %v928, i64 %v207
  %v930 = shl i64 %v207, 4
  %v931 = getelementptr i8, ptr %v928, i64 %v930
  %v932 = shl i64 %v144, 5
  %v933 = getelementptr i8, ptr %v142, i64 %v932
  %v934 = mul i64 %v135, 112
  %v935 = getelementptr i8, ptr %v133, i64 %v934
  %v936 = xor i1 %v307, true
  %v937 = tail call i64 @llvm.smax.i64(i64 %v9, i64 1)
  %v938 = add nsw i64 %v937, -1
  %v939 = zext i1 %v936 to i64
  %v940 = mul i64 %v135, 208
  %v941 = getelementptr i8, ptr %v133, i64 %v940
  %v942 = icmp slt i64 %v10, 1
  %v943 = mul i64 %v135, 216
  %v944 = getelementptr i8, ptr %v133, i64 %v943
  %v945 = mul i64 %v135, 248
  %v946 = getelementptr i8, ptr %v133, i64 %v945
  %v947 = mul i64 %v135, 224
  %v948 = getelementptr i8, ptr %v133, i64 %v947
  %v949 = mul i64 %v135, 232
  %v950 = getelementptr i8, ptr %v133, i64 %v949
  %v951 = shl i64 %v135, 4
  %v952 = getelementptr i8, ptr %v133, i64 %v951
  %v953 = mul i64 %v135, 232
  %v954 = getelementptr i8, ptr %v133, i64 %v953
  %v955 = mul i64 %v135, 40
  %v956 = getelementptr i8, ptr %v133, i64 %v955
  %v957 = shl i64 %v135, 4
  %v958 = getelementptr i8, ptr %v133, i64 %v957
  %v959 = getelementptr i64, ptr %v142, i64 %v144
  %v960 = mul i64 %v135, 24
  %v961 = getelementptr i8, ptr %v133, i64 %v960
  %v962 = mul i64 %v135, 24
  %v963 = getelementptr i8, ptr %v133, i64 %v962
  %v964 = icmp slt i64 %v63, 1
  %v965 = shl i64 %v144, 4
  %v966 = getelementptr i8, ptr %v142, i64 %v965
  %v967 = mul i64 %v135, 24
  %v968 = getelementptr i8, ptr %v133, i64 %v967
  %v969 = getelementptr i8, ptr %v151, i64 8
  %v970 = getelementptr i64, ptr %v142, i64 %v144
  %v971 = mul i64 %v144, 24
  %v972 = getelementptr i8, ptr %v142, i64 %v971
  %v973 = icmp slt i64 %v41, 1
  %v974 = icmp slt i64 %v63, 1
  %v975 = icmp slt i64 %v10, 1
  %v976 = mul i64 %v135, 208
  %v977 = getelementptr i8, ptr %v133, i64 %v976
  %v978 = mul i64 %v135, 120
  %v979 = getelementptr i8, ptr %v133, i64 %v978
  %v980 = mul i64 %v135, 200
  %v981 = getelementptr i8, ptr %v133, i64 %v980
  %v982 = mul i64 %v135, 216
  %v983 = getelementptr i8, ptr %v133, i64 %v982
  %v984 = shl i64 %v135, 4
  %v985 = getelementptr i8, ptr %v133, i64 %v984
  %v986 = mul i64 %v135, 240
  %v987 = getelementptr i8, ptr %v133, i64 %v986
  %v988 = getelementptr double, ptr %v92, i64 %v93
  %v989 = getelementptr i8, ptr %v988, i64 -8
  %v990 = getelementptr double, ptr %v133, i64 %v135
  %v991 = mul i64 %v135, 240
  %v992 = getelementptr i8, ptr %v133, i64 %v991
  %v993 = mul i64 %v135, 208
  %v994 = getelementptr i8, ptr %v133, i64 %v993
  %v995 = sitofp i64 %v298 to double
  %v996 = mul i64 %v135, 152
  %v997 = getelementptr i8, ptr %v133, i64 %v996
  %v998 = shl i64 %v135, 4
  %v999 = getelementptr i8, ptr %v133, i64 %v998
  %v1000 = mul i64 %v135, 144
  %v1001 = getelementptr i8, ptr %v133, i64 %v1000
  %v1002 = shl i64 %v144, 4
  %v1003 = getelementptr i8, ptr %v142, i64 %v1002
  %v1004 = shl i64 %v670, 4
  %v1005 = mul i64 %v670, 24
  %v1006 = shl i64 %v670, 5
  %v1007 = mul i64 %v670, 40
  %v1008 = mul i64 %v670, 48
  %v1009 = mul i64 %v670, 56
  %v1010 = shl i64 %v670, 6
  %v1011 = shl i64 %v672, 4
  %v1012 = shl i64 %v672, 5
  %v1013 = mul i64 %v672, 48
  %v1014 = shl i64 %v672, 6
  %v1015 = mul i64 %v672, 24
  %v1016 = shl i64 %v672, 4
  %v1017 = shl i64 %v672, 5
  %v1018 = mul i64 %v672, 48
  %v1019 = shl i64 %v672, 6
  %v1020 = mul i64 %v672, 40
  %v1021 = shl i64 %v672, 4
  %v1022 = shl i64 %v672, 5
  %v1023 = mul i64 %v672, 48
  %v1024 = shl i64 %v672, 6
  %v1025 = mul i64 %v672, 56
  %v1026 = shl i64 %v672, 4
  %v1027 = shl i64 %v672, 5
  %v1028 = mul i64 %v672, 48
  %v1029 = shl i64 %v672, 6
  br label %v1030

v1030:
  %v1031 = phi i64 [ %v1032, %v1033 ], [ %v297, %v450 ]
  %v1034 = phi i64 [ %v1035, %v1033 ], [ %v446, %v450 ]
  %v1036 = add nsw i64 %v1031, -1
  %v1037 = load i64, ptr %v452, align 8, !noalias !11
  %v1038 = icmp eq i64 %v1037, 0
  br i1 %v1038, label %v1039, label %v1040

v1040:
  %v1041 = icmp eq i64 %v1037, 2
  store i64 0, ptr %v452, align 8, !noalias !11
  %v1042 = load i64, ptr %v457, align 8, !noalias !15
  %v1043 = inttoptr i64 %v1042 to ptr
  tail call void %v1043(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !15
  br i1 %v305, label %v1044, label %v1045

v1044:
  %v1046 = load i64, ptr %v458, align 8, !noalias !18
  %v1047 = inttoptr i64 %v1046 to ptr
  tail call void %v1047(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !18
  %v1048 = load double, ptr %v460, align 8, !noalias !24
  %v1049 = fcmp oeq double %v1048, 2.500000e-01
  br i1 %v1049, label %v1050, label %v1051

v1050:
  store double 0.000000e+00, ptr %v460, align 8, !noalias !24
  br i1 %v461, label %v1052, label %v1051

v1053:
  store double 1.000000e+00, ptr %v460, align 8, !noalias !24
  br label %v1054

v1054:
  %v1055 = icmp eq i64 %v1056, %v18
  br i1 %v1055, label %v1051, label %v1052

v1051:
  %v1057 = load double, ptr %v460, align 8, !noalias !24
  %v1058 = fcmp ogt double %v1057, 5.000000e-01
  br i1 %v1058, label %v1059, label %v1060

v1059:
  br i1 %v462, label %v1061, label %v1062

v1062:
  %v1063 = load i64, ptr %v457, align 8, !noalias !25
  %v1064 = inttoptr i64 %v1063 to ptr
  tail call void %v1064(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !25
  br label %v1060

v1052:
  %v1065 = phi i64 [ %v1056, %v1054 ], [ 0, %v1050 ]
  %v1056 = add nsw i64 %v1065, 1
  %v1066 = getelementptr double, ptr %v204, i64 %v1065
  %v1067 = load double, ptr %v1066, align 8, !noalias !24
  %v1068 = add nsw i64 %v1065, %v17
  %v1069 = icmp slt i64 %v1068, 0
  %v1070 = select i1 %v1069, i64 %v166, i64 0
  %v1071 = getelementptr double, ptr %v165, i64 %v1068
  %v1072 = getelementptr double, ptr %v1071, i64 %v1070
  %v1073 = load double, ptr %v1072, align 8, !noalias !24
  %v1074 = fcmp une double %v1067, %v1073
  br i1 %v1074, label %v1053, label %v1054

v1061:
  %v1075 = phi i64 [ %v1076, %v1061 ], [ 0, %v1059 ]
  %v1076 = add nsw i64 %v1075, 1
  %v1077 = getelementptr double, ptr %v204, i64 %v1075
  %v1078 = load double, ptr %v1077, align 8, !noalias !24
  %v1079 = add nsw i64 %v1075, %v17
  %v1080 = icmp slt i64 %v1079, 0
  %v1081 = select i1 %v1080, i64 %v166, i64 0
  %v1082 = getelementptr double, ptr %v165, i64 %v1079
  %v1083 = getelementptr double, ptr %v1082, i64 %v1081
  store double %v1078, ptr %v1083, align 8, !noalias !24
  %v1084 = icmp eq i64 %v1076, %v18
  br i1 %v1084, label %v1062, label %v1061

v1085:
  %v1086 = load double, ptr %v460, align 8, !noalias !11
  %v1087 = fcmp ogt double %v1086, 5.000000e-01
  br label %v1045

v1045:
  %v1088 = phi i1 [ %v1041, %v1040 ], [ %v1087, %v1085 ]
  br i1 %v1088, label %v1089, label %v1039

v1089:
  br i1 %v463, label %v1090, label %v1091

v1090:
  %v1092 = load i64, ptr %v6, align 8, !noalias !28
  %v1093 = inttoptr i64 %v1092 to ptr
  tail call void %v1093(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v466), !noalias !28
  %v1094 = load i64, ptr %v467, align 8, !noalias !31
  %v1095 = inttoptr i64 %v1094 to ptr
  tail call void %v1095(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !31
  %v1096 = load i64, ptr %v468, align 8, !noalias !34
  %v1097 = inttoptr i64 %v1096 to ptr
  tail call void %v1097(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !34
  %v1098 = load i64, ptr %v6, align 8, !noalias !37
  %v1099 = inttoptr i64 %v1098 to ptr
  tail call void %v1099(ptr %v470, ptr %v472, ptr %v165, ptr %v172, ptr %v179, ptr %v474), !noalias !37
  %v1100 = load i64, ptr %v475, align 8, !noalias !40
  %v1101 = inttoptr i64 %v1100 to ptr
  tail call void %v1101(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !40
  br label %v1091

v1091:
  br i1 %v307, label %v1039, label %v1102

v1103:
  store double 0.000000e+00, ptr %v1104, align 8, !noalias !43
  %v1105 = getelementptr double, ptr %v480, i64 %v1106
  store double 0.000000e+00, ptr %v1105, align 8, !noalias !43
  %v1107 = getelementptr double, ptr %v482, i64 %v1106
  store double 0.000000e+00, ptr %v1107, align 8, !noalias !43
  %v1108 = getelementptr i64, ptr %v142, i64 %v1106
  %v1109 = load i64, ptr %v1108, align 8, !noalias !43
  %v1110 = icmp slt i64 %v1109, 0
  %v1111 = select i1 %v1110, i64 %v125, i64 0
  %v1112 = add i64 %v1111, %v1109
  %v1113 = mul i64 %v1112, %v126
  %v1114 = getelementptr i64, ptr %v124, i64 %v1113
  %v1115 = getelementptr i8, ptr %v1114, i64 8
  %v1116 = load i64, ptr %v1115, align 8, !noalias !43
  %v1117 = add nsw i64 %v1116, %v484
  store i64 %v1117, ptr %v1115, align 8, !noalias !43
  %v1118 = load i64, ptr %v1108, align 8, !noalias !43
  %v1119 = icmp slt i64 %v1118, 0
  %v1120 = select i1 %v1119, i64 %v125, i64 0
  %v1121 = add i64 %v1120, %v1118
  %v1122 = mul i64 %v1121, %v126
  %v1123 = getelementptr i64, ptr %v124, i64 %v1122
  %v1124 = getelementptr i8, ptr %v1123, i64 16
  %v1125 = load i64, ptr %v1124, align 8, !noalias !43
  %v1126 = add nsw i64 %v1125, %v485
  store i64 %v1126, ptr %v1124, align 8, !noalias !43
  %v1127 = getelementptr double, ptr %v487, i64 %v1106
  %v1128 = load double, ptr %v1127, align 8, !noalias !43
  %v1129 = fcmp une double %v1128, 0.000000e+00
  br i1 %v1129, label %v1130, label %v1131

v1130:
  %v1132 = load i64, ptr %v1108, align 8, !noalias !47
  %v1133 = icmp sgt i64 %v1132, -1
  br i1 %v1133, label %v1134, label %v1131

v1134:
  %v1135 = getelementptr i64, ptr %v110, i64 %v1132
  %v1136 = load i64, ptr %v1135, align 8, !noalias !47
  %v1137 = icmp eq i64 %v1136, 0
  br i1 %v1137, label %v1138, label %v1131

v1138:
  store i64 3, ptr %v1135, align 8, !noalias !47
  br label %v1131

v1131:
  br i1 %v488, label %v1139, label %v1140

v1140:
  %v1141 = load double, ptr %v490, align 8, !noalias !50
  %v1142 = load double, ptr %v92, align 8, !noalias !50
  %v1143 = fsub double %v1141, %v1142
  %v1144 = fmul double %v1143, 1.000000e-13
  %v1145 = load double, ptr %v133, align 8, !noalias !50
  %v1146 = tail call double @llvm.fabs.f64(double %v1145)
  %v1147 = fmul double %v1146, 4.000000e-15
  %v1148 = fcmp ogt double %v1147, %v1144
  %v1149 = select i1 %v1148, double %v1147, double %v1144
  %v1150 = fadd double %v1145, %v1149
  store double %v1150, ptr %v492, align 8, !noalias !57
  %v1151 = load i64, ptr %v6, align 8, !noalias !58
  %v1152 = inttoptr i64 %v1151 to ptr
  tail call void %v1152(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v493), !noalias !58
  br i1 %v494, label %v1153, label %v1154

v1153:
  %v1155 = load i64, ptr %v500, align 8, !noalias !61
  %v1156 = inttoptr i64 %v1155 to ptr
  tail call void %v1156(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v502), !noalias !61
  %v1157 = load i64, ptr %v500, align 8, !noalias !64
  %v1158 = inttoptr i64 %v1157 to ptr
  tail call void %v1158(ptr nonnull %v492, ptr %v504, ptr %v165, ptr %v172, ptr %v179, ptr %v506), !noalias !64
  br label %v1159

v1159:
  %v1160 = phi i64 [ %v18, %v1153 ], [ %v1161, %v1162 ]
  %v1163 = phi i64 [ %v508, %v1153 ], [ %v1164, %v1162 ]
  %v1165 = icmp sgt i64 %v1163, 0
  br i1 %v1165, label %v1162, label %v1139

v1166:
  %v1167 = getelementptr i64, ptr %v519, i64 %v1106
  store i64 %v1160, ptr %v1167, align 8, !noalias !57
  %v1168 = load i64, ptr %v1108, align 8, !noalias !67
  %v1169 = icmp sgt i64 %v1168, -1
  br i1 %v1169, label %v1170, label %v1171

v1170:
  %v1172 = getelementptr i64, ptr %v110, i64 %v1168
  %v1173 = load i64, ptr %v1172, align 8, !noalias !67
  %v1174 = icmp eq i64 %v1173, 0
  br i1 %v1174, label %v1175, label %v1171

v1175:
  store i64 4, ptr %v1172, align 8, !noalias !67
  br label %v1171

v1171:
  %v1176 = getelementptr double, ptr %v133, i64 %v1106
  %v1177 = load double, ptr %v1176, align 8, !noalias !57
  %v1178 = getelementptr double, ptr %v521, i64 %v1106
  store double %v1177, ptr %v1178, align 8, !noalias !57
  %v1179 = getelementptr double, ptr %v523, i64 %v1106
  store double 0.000000e+00, ptr %v1179, align 8, !noalias !57
  br label %v1139

v1154:
  %v1180 = phi i64 [ %v1181, %v1154 ], [ 0, %v1140 ]
  %v1181 = add nsw i64 %v1180, 1
  %v1182 = mul i64 %v1180, %v196
  %v1183 = getelementptr double, ptr %v193, i64 %v1182
  %v1184 = load double, ptr %v1183, align 8, !noalias !57
  %v1185 = getelementptr double, ptr %v497, i64 %v1182
  %v1186 = load double, ptr %v1185, align 8, !noalias !57
  %v1187 = fmul double %v1149, %v1186
  %v1188 = fadd double %v1184, %v1187
  %v1189 = getelementptr double, ptr %v499, i64 %v1182
  store double %v1188, ptr %v1189, align 8, !noalias !57
  %v1190 = icmp eq i64 %v10, %v1181
  br i1 %v1190, label %v1153, label %v1154

v1162:
  %v1164 = add nsw i64 %v1163, -1
  %v1161 = add i64 %v1160, 1
  %v1191 = icmp slt i64 %v1160, 0
  %v1192 = select i1 %v1191, i64 %v207, i64 0
  %v1193 = add i64 %v1192, %v1160
  %v1194 = getelementptr double, ptr %v512, i64 %v1193
  %v1195 = load double, ptr %v1194, align 8, !noalias !57
  %v1196 = getelementptr double, ptr %v515, i64 %v1193
  %v1197 = load double, ptr %v1196, align 8, !noalias !57
  %v1198 = fsub double %v1195, %v1197
  %v1199 = tail call double @llvm.fabs.f64(double %v1198)
  %v1200 = getelementptr double, ptr %v517, i64 %v1193
  %v1201 = load double, ptr %v1200, align 8, !noalias !57
  %v1202 = tail call i1 @llvm.is.fpclass.f64(double %v1201, i32 543)
  %v1203 = select i1 %v1202, double 0.000000e+00, double %v1201
  %v1204 = fcmp ueq double %v1199, 0x7FF0000000000000
  %v1205 = select i1 %v1204, double -0.000000e+00, double %v1199
  %v1206 = fadd double %v1203, %v1205
  %v1207 = getelementptr double, ptr %v514, i64 %v1193
  %v1208 = load double, ptr %v1207, align 8, !noalias !57
  %v1209 = fneg double %v1206
  %v1210 = fcmp olt double %v1208, %v1209
  br i1 %v1210, label %v1166, label %v1159

v1211:
  %v1212 = icmp sgt i64 %v1213, 1
  br i1 %v1212, label %v1102, label %v1039

v1102:
  %v1213 = phi i64 [ %v1214, %v1211 ], [ %v308, %v1091 ]
  %v1106 = phi i64 [ %v1215, %v1211 ], [ 0, %v1091 ]
  %v1214 = add nsw i64 %v1213, -1
  %v1215 = add nsw i64 %v1106, 1
  %v1104 = getelementptr double, ptr %v478, i64 %v1106
  %v1216 = load double, ptr %v1104, align 8, !noalias !43
  %v1217 = fcmp olt double %v1216, 5.000000e-01
  br i1 %v1217, label %v1211, label %v1103

v1139:
  %v1218 = getelementptr double, ptr %v525, i64 %v1106
  %v1219 = load double, ptr %v1218, align 8, !noalias !70
  %v1220 = getelementptr double, ptr %v527, i64 %v1106
  store double %v1219, ptr %v1220, align 8, !noalias !70
  %v1221 = getelementptr i64, ptr %v529, i64 %v1106
  %v1222 = load i64, ptr %v1221, align 8, !noalias !70
  %v1223 = icmp slt i64 %v1222, %v93
  br i1 %v1223, label %v1224, label %v1211

v1224:
  %v1225 = icmp slt i64 %v1222, 0
  %v1226 = select i1 %v1225, i64 %v93, i64 0
  %v1227 = getelementptr double, ptr %v92, i64 %v1222
  %v1228 = getelementptr double, ptr %v1227, i64 %v1226
  %v1229 = load double, ptr %v1228, align 8, !noalias !70
  %v1230 = load double, ptr %v1218, align 8, !noalias !70
  %v1231 = fcmp olt double %v1230, %v1229
  %v1232 = select i1 %v1231, double %v1230, double %v1229
  store double %v1232, ptr %v1220, align 8, !noalias !70
  br label %v1211

v1060:
  br i1 %v1041, label %v1089, label %v1085

v1039:
  %v1233 = phi i1 [ %v614, %v1045 ], [ %v614, %v1030 ], [ true, %v1091 ], [ true, %v1211 ]
  %v1234 = load i64, ptr %v530, align 8, !noalias !74
  %v1235 = inttoptr i64 %v1234 to ptr
  tail call void %v1235(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !74
  br i1 %v531, label %v1236, label %v1237

v1238:
  %v1239 = getelementptr double, ptr %v616, i64 %v1240
  %v1241 = load double, ptr %v1239, align 8
  %v1242 = fcmp ogt double %v1241, 5.000000e-01
  br label %v1243

v1243:
  %v1244 = phi i1 [ true, %v1245 ], [ %v1242, %v1238 ]
  br i1 %v1246, label %v1247, label %v1248

v1248:
  %v1249 = getelementptr double, ptr %v618, i64 %v1240
  %v1250 = load double, ptr %v1249, align 8
  %v1251 = fcmp ogt double %v1250, 5.000000e-01
  br label %v1247

v1247:
  %v1252 = phi i1 [ true, %v1243 ], [ %v1251, %v1248 ]
  %v1253 = icmp sgt i64 %v1254, 1
  br i1 %v1253, label %v1245, label %v1255

v1255:
  %v1256 = phi i1 [ false, %v1257 ], [ %v1244, %v1247 ]
  %v1258 = phi i1 [ %v1233, %v1257 ], [ %v1252, %v1247 ]
  %v1259 = xor i1 %v1258, true
  %v1260 = or i1 %v307, %v1259
  br i1 %v1260, label %v1261, label %v1262

v1263:
  br i1 %v307, label %v1261, label %v1264

v1265:
  %v1266 = getelementptr double, ptr %v620, i64 %v1267
  %v1268 = load double, ptr %v1266, align 8, !noalias !80
  %v1269 = fptosi double %v1268 to i64
  %v1270 = getelementptr double, ptr %v622, i64 %v1267
  %v1271 = load double, ptr %v1270, align 8, !noalias !80
  %v1272 = fptosi double %v1271 to i64
  %v1273 = mul i64 %v1274, %v126
  %v1275 = getelementptr i64, ptr %v124, i64 %v1273
  %v1276 = load i64, ptr %v1275, align 8, !noalias !80
  %v1277 = add nsw i64 %v1276, %v1269
  store i64 %v1277, ptr %v1275, align 8, !noalias !80
  %v1278 = getelementptr i8, ptr %v1275, i64 24
  %v1279 = load i64, ptr %v1278, align 8, !noalias !80
  %v1280 = add nsw i64 %v1279, %v1272
  store i64 %v1280, ptr %v1278, align 8, !noalias !80
  %v1281 = getelementptr i8, ptr %v1275, i64 8
  %v1282 = load i64, ptr %v1281, align 8, !noalias !80
  %v1283 = add nsw i64 %v1272, %v1269
  %v1284 = mul nsw i64 %v1283, %v590
  %v1285 = add nsw i64 %v1284, %v1269
  %v1286 = add nsw i64 %v1285, %v1282
  store i64 %v1286, ptr %v1281, align 8, !noalias !80
  store double 0.000000e+00, ptr %v1266, align 8, !noalias !80
  store double 0.000000e+00, ptr %v1270, align 8, !noalias !80
  %v1287 = getelementptr double, ptr %v624, i64 %v1267
  %v1288 = load double, ptr %v1287, align 8, !noalias !80
  %v1289 = sitofp i64 %v1283 to double
  %v1290 = fsub double %v1288, %v1289
  store double %v1290, ptr %v1287, align 8, !noalias !80
  br label %v1291

v1291:
  %v1292 = icmp sgt i64 %v1293, 1
  br i1 %v1292, label %v1262, label %v1263

v1262:
  %v1293 = phi i64 [ %v1294, %v1291 ], [ %v308, %v1255 ]
  %v1267 = phi i64 [ %v1295, %v1291 ], [ 0, %v1255 ]
  %v1294 = add nsw i64 %v1293, -1
  %v1295 = add nsw i64 %v1267, 1
  %v1296 = getelementptr i64, ptr %v142, i64 %v1267
  %v1274 = load i64, ptr %v1296, align 8, !noalias !80
  %v1297 = icmp sgt i64 %v1274, -1
  br i1 %v1297, label %v1265, label %v1291

v1298:
  %v1299 = getelementptr double, ptr %v630, i64 %v1300
  %v1301 = load double, ptr %v1299, align 8, !noalias !87
  %v1302 = fcmp ogt double %v1301, 5.000000e-01
  br i1 %v1302, label %v1303, label %v1304

v1303:
  %v1305 = fptosi double %v1301 to i64
  %v1306 = load i64, ptr %v1307, align 8, !noalias !88
  %v1308 = icmp sgt i64 %v1306, -1
  br i1 %v1308, label %v1309, label %v1304

v1304:
  %v1310 = getelementptr double, ptr %v632, i64 %v1300
  %v1311 = load double, ptr %v1310, align 8, !noalias !87
  %v1312 = fcmp ogt double %v1311, 5.000000e-01
  br i1 %v1312, label %v1313, label %v1314

v1313:
  %v1315 = select i1 %v1316, i1 true, i1 %v304
  %v1317 = icmp slt i64 %v1318, %v93
  br i1 %v1317, label %v1319, label %v1320

v1319:
  %v1321 = icmp slt i64 %v1318, 0
  %v1322 = select i1 %v1321, i64 %v93, i64 0
  %v1323 = getelementptr double, ptr %v92, i64 %v1318
  %v1324 = getelementptr double, ptr %v1323, i64 %v1322
  %v1325 = load double, ptr %v1324, align 8, !noalias !87
  %v1326 = getelementptr double, ptr %v634, i64 %v1300
  %v1327 = load double, ptr %v1326, align 8, !noalias !87
  %v1328 = fcmp olt double %v1325, %v1327
  br i1 %v1328, label %v1329, label %v1320

v1329:
  br label %v1320

v1320:
  %v1330 = phi i1 [ true, %v1329 ], [ %v1315, %v1319 ], [ %v1315, %v1313 ]
  %v1331 = mul i64 %v1332, %v126
  %v1333 = getelementptr i64, ptr %v124, i64 %v1331
  %v1334 = load i64, ptr %v1333, align 8, !noalias !87
  %v1335 = and i64 %v1334, 127
  %v1336 = icmp eq i64 %v1335, 0
  br i1 %v1336, label %v1337, label %v1338

v1338:
  %v1339 = getelementptr double, ptr %v636, i64 %v1300
  %v1340 = load double, ptr %v1339, align 8, !noalias !87
  %v1341 = fcmp ogt double %v1340, 0.000000e+00
  br i1 %v1341, label %v1337, label %v1314

v1337:
  store double 1.000000e+00, ptr %v1342, align 8, !noalias !87
  br label %v1314

v1314:
  %v1343 = phi i1 [ %v1330, %v1337 ], [ %v1330, %v1338 ], [ %v1316, %v1304 ], [ %v1316, %v1264 ]
  %v1344 = phi i1 [ true, %v1337 ], [ %v1345, %v1338 ], [ %v1345, %v1304 ], [ %v1345, %v1264 ]
  %v1346 = icmp sgt i64 %v1347, 1
  br i1 %v1346, label %v1264, label %v1348

v1264:
  %v1345 = phi i1 [ %v1344, %v1314 ], [ false, %v1263 ]
  %v1316 = phi i1 [ %v1343, %v1314 ], [ false, %v1263 ]
  %v1347 = phi i64 [ %v1349, %v1314 ], [ %v308, %v1263 ]
  %v1300 = phi i64 [ %v1350, %v1314 ], [ 0, %v1263 ]
  %v1349 = add nsw i64 %v1347, -1
  %v1350 = add nsw i64 %v1300, 1
  %v1307 = getelementptr i64, ptr %v142, i64 %v1300
  %v1332 = load i64, ptr %v1307, align 8, !noalias !87
  %v1351 = getelementptr i64, ptr %v626, i64 %v1300
  %v1318 = load i64, ptr %v1351, align 8, !noalias !87
  %v1342 = getelementptr double, ptr %v628, i64 %v1300
  store double 0.000000e+00, ptr %v1342, align 8, !noalias !87
  %v1352 = icmp sgt i64 %v1332, -1
  br i1 %v1352, label %v1298, label %v1314

v1309:
  %v1353 = getelementptr i64, ptr %v110, i64 %v1306
  %v1354 = load i64, ptr %v1353, align 8, !noalias !88
  %v1355 = icmp eq i64 %v1354, 0
  br i1 %v1355, label %v1356, label %v1304

v1356:
  store i64 %v1305, ptr %v1353, align 8, !noalias !88
  br label %v1304

v1261:
  %v1357 = phi i1 [ true, %v1255 ], [ true, %v1263 ], [ %v1358, %v1348 ]
  %v1359 = phi i1 [ true, %v1255 ], [ true, %v1263 ], [ %v1360, %v1348 ]
  %v1361 = and i1 %v637, %v1256
  br i1 %v1361, label %v1362, label %v1363

v1362:
  %v1364 = load i64, ptr %v6, align 8, !noalias !91
  %v1365 = inttoptr i64 %v1364 to ptr
  tail call void %v1365(ptr %v642, ptr %v645, ptr %v165, ptr %v172, ptr %v179, ptr %v647), !noalias !91
  br label %v1363

v1363:
  br i1 %v1359, label %v1366, label %v1367

v1367:
  %v1368 = load i64, ptr %v648, align 8, !noalias !97
  %v1369 = inttoptr i64 %v1368 to ptr
  tail call void %v1369(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !97
  br label %v1366

v1366:
  %v1370 = select i1 %v1256, i1 %v304, i1 false
  %v1371 = xor i1 %v1256, true
  %v1372 = select i1 %v305, i1 %v1256, i1 false
  %v1373 = xor i1 %v1372, true
  %v1374 = select i1 %v1373, i1 true, i1 %v1370
  %v1375 = select i1 %v305, i1 %v1256, i1 %v1370
  br i1 %v1374, label %v1376, label %v1377

v1377:
  %v1378 = load i64, ptr %v649, align 8, !noalias !100
  %v1379 = inttoptr i64 %v1378 to ptr
  tail call void %v1379(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !100
  br label %v1380

v1380:
  %v1381 = phi i64 [ 0, %v1377 ], [ %v1382, %v1383 ]
  %v1382 = add nsw i64 %v1381, 1
  %v1384 = icmp ult i64 %v1381, 9
  br i1 %v1384, label %v1385, label %v1386

v1385:
  %v1387 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v1381
  %v1388 = load double, ptr %v1387, align 8
  %v1389 = load double, ptr %v133, align 8, !noalias !103
  %v1390 = load double, ptr %v652, align 8, !noalias !103
  %v1391 = fmul double %v1388, %v1390
  %v1392 = fadd double %v1389, %v1391
  store double %v1392, ptr %v654, align 8, !noalias !103
  br i1 %v656, label %v1383, label %v1393

v1393:
  %v1394 = fsub double 1.000000e+00, %v1388
  br label %v1395

v1395:
  %v1396 = phi i64 [ 0, %v1393 ], [ %v1397, %v1395 ]
  %v1398 = mul i64 %v1396, %v196
  %v1399 = getelementptr double, ptr %v193, i64 %v1398
  %v1400 = getelementptr i8, ptr %v1399, i64 %v660
  %v1401 = load double, ptr %v1400, align 8, !noalias !113
  %v1402 = fadd double %v1401, 0.000000e+00
  %v1403 = fmul double %v1388, %v1402
  %v1404 = getelementptr i8, ptr %v1399, i64 %v661
  %v1405 = load double, ptr %v1404, align 8, !noalias !113
  %v1406 = fadd double %v1405, %v1403
  %v1407 = fmul double %v1394, %v1406
  %v1408 = getelementptr i8, ptr %v1399, i64 %v662
  %v1409 = load double, ptr %v1408, align 8, !noalias !113
  %v1410 = fadd double %v1409, %v1407
  %v1411 = fmul double %v1388, %v1410
  %v1412 = getelementptr i8, ptr %v1399, i64 %v663
  %v1413 = load double, ptr %v1412, align 8, !noalias !113
  %v1414 = fadd double %v1413, %v1411
  %v1415 = fmul double %v1394, %v1414
  %v1416 = getelementptr i8, ptr %v1399, i64 %v664
  %v1417 = load double, ptr %v1416, align 8, !noalias !113
  %v1418 = fadd double %v1417, %v1415
  %v1419 = fmul double %v1388, %v1418
  %v1420 = getelementptr i8, ptr %v1399, i64 %v665
  %v1421 = load double, ptr %v1420, align 8, !noalias !113
  %v1422 = fadd double %v1421, %v1419
  %v1423 = fmul double %v1394, %v1422
  %v1424 = getelementptr i8, ptr %v1399, i64 %v666
  %v1425 = load double, ptr %v1424, align 8, !noalias !113
  %v1426 = fadd double %v1425, %v1423
  %v1427 = fmul double %v1388, %v1426
  %v1397 = add nsw i64 %v1396, 1
  %v1428 = load double, ptr %v1399, align 8, !noalias !113
  %v1429 = fadd double %v1428, %v1427
  %v1430 = getelementptr double, ptr %v657, i64 %v1398
  store double %v1429, ptr %v1430, align 8, !noalias !103
  %v1431 = icmp eq i64 %v10, %v1397
  br i1 %v1431, label %v1383, label %v1395

v1383:
  %v1432 = icmp eq i64 %v1381, 8
  %v1433 = select i1 %v1432, i64 17, i64 16
  %v1434 = mul i64 %v658, %v1381
  %v1435 = load i64, ptr %v659, align 8, !noalias !117
  %v1436 = mul nsw i64 %v1433, %v10
  %v1437 = getelementptr double, ptr %v158, i64 %v1436
  %v1438 = getelementptr double, ptr %v186, i64 %v1434
  %v1439 = inttoptr i64 %v1435 to ptr
  tail call void %v1439(ptr nonnull %v654, ptr %v1437, ptr %v165, ptr %v172, ptr %v179, ptr %v1438), !noalias !117
  %v1440 = icmp eq i64 %v1382, 9
  br i1 %v1440, label %v1386, label %v1380

v1386:
  %v1441 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v1380 ], [ null, %v1383 ]
  %v1442 = phi i32 [ 1, %v1380 ], [ 0, %v1383 ]
  br i1 %v1384, label %v1443, label %v1444, !prof !120

v1376:
  %v1445 = phi i1 [ %v1375, %v1366 ], [ %v1446, %v1444 ]
  %v1447 = xor i1 %v1357, true
  %v1448 = select i1 %v1447, i1 true, i1 %v1445
  br i1 %v1448, label %v1449, label %v1450

v1449:
  br i1 %v677, label %v1451, label %v1452

v1453:
  %v1454 = load i64, ptr %v688, align 8, !noalias !121
  %v1455 = inttoptr i64 %v1454 to ptr
  tail call void %v1455(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !121
  br label %v1452

v1451:
  %v1456 = phi i64 [ %v1457, %v1451 ], [ 1, %v1449 ]
  %v1457 = add i64 %v1456, 1
  %v1458 = add nsw i64 %v678, %v1456
  %v1459 = icmp slt i64 %v1458, 0
  %v1460 = select i1 %v1459, i64 %v7, i64 0
  %v1461 = getelementptr i64, ptr %v6, i64 %v1458
  %v1462 = getelementptr i64, ptr %v1461, i64 %v1460
  %v1463 = load i64, ptr %v1462, align 8, !noalias !127
  %v1464 = inttoptr i64 %v1463 to ptr
  tail call void %v1464(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !127
  %v1465 = add nsw i64 %v1456, 13
  %v1466 = load i64, ptr %v6, align 8, !noalias !130
  %v1467 = mul nsw i64 %v1465, %v681
  %v1468 = getelementptr double, ptr %v158, i64 %v1467
  %v1469 = inttoptr i64 %v1466 to ptr
  tail call void %v1469(ptr %v680, ptr %v683, ptr %v165, ptr %v172, ptr %v179, ptr %v1468), !noalias !130
  %v1470 = icmp eq i64 %v1456, %v12
  br i1 %v1470, label %v1453, label %v1451

v1452:
  %v1471 = load i64, ptr %v689, align 8, !noalias !133
  %v1472 = inttoptr i64 %v1471 to ptr
  tail call void %v1472(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !133
  %v1473 = select i1 %v640, i1 true, i1 %v1371
  %v1474 = or i1 %v1473, %v307
  br i1 %v1474, label %v1475, label %v1476

v1477:
  %v1478 = getelementptr double, ptr %v693, i64 %v1479
  %v1480 = load double, ptr %v1478, align 8, !noalias !136
  %v1481 = fcmp uge double %v1480, 5.000000e-01
  %v1482 = icmp slt i64 %v1483, %v93
  %v1484 = select i1 %v1481, i1 %v1482, i1 false
  br i1 %v1484, label %v1485, label %v1486

v1485:
  %v1487 = icmp slt i64 %v1483, 0
  %v1488 = select i1 %v1487, i64 %v93, i64 0
  %v1489 = getelementptr double, ptr %v92, i64 %v1483
  %v1490 = getelementptr double, ptr %v1489, i64 %v1488
  %v1491 = load double, ptr %v1490, align 8, !noalias !136
  %v1492 = getelementptr double, ptr %v695, i64 %v1479
  %v1493 = load double, ptr %v1492, align 8, !noalias !136
  %v1494 = fcmp olt double %v1491, %v1493
  br i1 %v1494, label %v1495, label %v1486

v1495:
  %v1496 = getelementptr double, ptr %v697, i64 %v1479
  %v1497 = load double, ptr %v1496, align 8, !noalias !136
  %v1498 = fcmp ogt double %v1497, 1.000000e+00
  br i1 %v1498, label %v1499, label %v1486

v1499:
  %v1500 = getelementptr double, ptr %v699, i64 %v1479
  %v1501 = load double, ptr %v1500, align 8, !noalias !136
  store double 0.000000e+00, ptr %v1478, align 8, !noalias !140
  %v1502 = getelementptr double, ptr %v701, i64 %v1479
  store double 0.000000e+00, ptr %v1502, align 8, !noalias !140
  %v1503 = getelementptr double, ptr %v702, i64 %v1479
  store double %v1501, ptr %v1503, align 8, !noalias !140
  %v1504 = load i64, ptr %v1505, align 8, !noalias !140
  %v1506 = icmp slt i64 %v1504, 0
  %v1507 = select i1 %v1506, i64 %v125, i64 0
  %v1508 = add i64 %v1507, %v1504
  %v1509 = mul i64 %v1508, %v126
  %v1510 = getelementptr i64, ptr %v124, i64 %v1509
  %v1511 = load i64, ptr %v1510, align 8, !noalias !140
  %v1512 = add nsw i64 %v1511, -1
  store i64 %v1512, ptr %v1510, align 8, !noalias !140
  %v1513 = load i64, ptr %v1505, align 8, !noalias !140
  %v1514 = icmp slt i64 %v1513, 0
  %v1515 = select i1 %v1514, i64 %v125, i64 0
  %v1516 = add i64 %v1515, %v1513
  %v1517 = mul i64 %v1516, %v126
  %v1518 = getelementptr i64, ptr %v124, i64 %v1517
  %v1519 = getelementptr i8, ptr %v1518, i64 24
  %v1520 = load i64, ptr %v1519, align 8, !noalias !140
  %v1521 = add nsw i64 %v1520, 1
  store i64 %v1521, ptr %v1519, align 8, !noalias !140
  %v1522 = load double, ptr %v1490, align 8, !noalias !136
  %v1523 = getelementptr double, ptr %v704, i64 %v1479
  store double %v1522, ptr %v1523, align 8, !noalias !136
  %v1524 = mul i64 %v1525, %v126
  %v1526 = getelementptr i64, ptr %v124, i64 %v1524
  %v1527 = getelementptr i8, ptr %v1526, i64 8
  %v1528 = load i64, ptr %v1527, align 8, !noalias !136
  %v1529 = add nsw i64 %v1528, %v12
  store i64 %v1529, ptr %v1527, align 8, !noalias !136
  br label %v1486

v1486:
  %v1530 = icmp sgt i64 %v1531, 1
  br i1 %v1530, label %v1476, label %v1475

v1476:
  %v1531 = phi i64 [ %v1532, %v1486 ], [ %v308, %v1452 ]
  %v1479 = phi i64 [ %v1533, %v1486 ], [ 0, %v1452 ]
  %v1532 = add nsw i64 %v1531, -1
  %v1533 = add nsw i64 %v1479, 1
  %v1505 = getelementptr i64, ptr %v142, i64 %v1479
  %v1525 = load i64, ptr %v1505, align 8, !noalias !136
  %v1534 = getelementptr i64, ptr %v691, i64 %v1479
  %v1483 = load i64, ptr %v1534, align 8, !noalias !136
  %v1535 = icmp slt i64 %v1525, 0
  br i1 %v1535, label %v1486, label %v1477

v1475:
  br i1 %v1445, label %v1536, label %v1537

v1536:
  call void @llvm.lifetime.start.p0(ptr nonnull %v302), !noalias !143
  call void @llvm.lifetime.start.p0(ptr nonnull %v303), !noalias !143
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %v302, i8 0, i64 32, i1 false), !noalias !147
  store ptr null, ptr %v303, align 8, !noalias !147
  br label %v1538

v1538:
  %v1539 = phi i64 [ 0, %v1536 ], [ %v1540, %v1541 ]
  %v1540 = add nsw i64 %v1539, 1
  %v1542 = icmp ult i64 %v1539, 9
  br i1 %v1542, label %v1543, label %v1544

v1543:
  %v1545 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v1539
  %v1546 = load double, ptr %v1545, align 8
  %v1547 = load double, ptr %v133, align 8, !noalias !151
  %v1548 = load double, ptr %v710, align 8, !noalias !151
  %v1549 = fmul double %v1546, %v1548
  %v1550 = fadd double %v1547, %v1549
  store double %v1550, ptr %v712, align 8, !noalias !151
  br i1 %v714, label %v1551, label %v1541

v1551:
  %v1552 = fsub double 1.000000e+00, %v1546
  br label %v1553

v1553:
  %v1554 = phi i64 [ 0, %v1551 ], [ %v1555, %v1553 ]
  %v1556 = mul i64 %v1554, %v196
  %v1557 = getelementptr double, ptr %v193, i64 %v1556
  %v1558 = getelementptr i8, ptr %v1557, i64 %v718
  %v1559 = load double, ptr %v1558, align 8, !noalias !158
  %v1560 = fadd double %v1559, 0.000000e+00
  %v1561 = fmul double %v1546, %v1560
  %v1562 = getelementptr i8, ptr %v1557, i64 %v719
  %v1563 = load double, ptr %v1562, align 8, !noalias !158
  %v1564 = fadd double %v1563, %v1561
  %v1565 = fmul double %v1552, %v1564
  %v1566 = getelementptr i8, ptr %v1557, i64 %v720
  %v1567 = load double, ptr %v1566, align 8, !noalias !158
  %v1568 = fadd double %v1567, %v1565
  %v1569 = fmul double %v1546, %v1568
  %v1570 = getelementptr i8, ptr %v1557, i64 %v721
  %v1571 = load double, ptr %v1570, align 8, !noalias !158
  %v1572 = fadd double %v1571, %v1569
  %v1573 = fmul double %v1552, %v1572
  %v1574 = getelementptr i8, ptr %v1557, i64 %v722
  %v1575 = load double, ptr %v1574, align 8, !noalias !158
  %v1576 = fadd double %v1575, %v1573
  %v1577 = fmul double %v1546, %v1576
  %v1578 = getelementptr i8, ptr %v1557, i64 %v723
  %v1579 = load double, ptr %v1578, align 8, !noalias !158
  %v1580 = fadd double %v1579, %v1577
  %v1581 = fmul double %v1552, %v1580
  %v1582 = getelementptr i8, ptr %v1557, i64 %v724
  %v1583 = load double, ptr %v1582, align 8, !noalias !158
  %v1584 = fadd double %v1583, %v1581
  %v1585 = fmul double %v1546, %v1584
  %v1555 = add nsw i64 %v1554, 1
  %v1586 = load double, ptr %v1557, align 8, !noalias !158
  %v1587 = fadd double %v1586, %v1585
  %v1588 = getelementptr double, ptr %v715, i64 %v1556
  store double %v1587, ptr %v1588, align 8, !noalias !151
  %v1589 = icmp eq i64 %v10, %v1555
  br i1 %v1589, label %v1541, label %v1553

v1541:
  %v1590 = icmp eq i64 %v1539, 8
  %v1591 = select i1 %v1590, i64 17, i64 16
  %v1592 = mul i64 %v1539, %v716
  %v1593 = load i64, ptr %v717, align 8, !noalias !162
  %v1594 = mul nsw i64 %v1591, %v10
  %v1595 = getelementptr double, ptr %v158, i64 %v1594
  %v1596 = getelementptr double, ptr %v186, i64 %v1592
  %v1597 = inttoptr i64 %v1593 to ptr
  tail call void %v1597(ptr nonnull %v712, ptr %v1595, ptr %v165, ptr %v172, ptr %v179, ptr %v1596), !noalias !162
  %v1598 = icmp eq i64 %v1540, 9
  br i1 %v1598, label %v1544, label %v1538

v1544:
  %v1599 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v1538 ], [ null, %v1541 ]
  %v1600 = phi i32 [ 1, %v1538 ], [ 0, %v1541 ]
  br i1 %v1542, label %v1601, label %v1602, !prof !120

v1601:
  %v1603 = load double, ptr %v726, align 8, !noalias !165
  %v1604 = load double, ptr %v92, align 8, !noalias !165
  %v1605 = fsub double %v1603, %v1604
  %v1606 = fmul double %v1605, 1.000000e-13
  %v1607 = load double, ptr %v133, align 8, !noalias !165
  %v1608 = tail call double @llvm.fabs.f64(double %v1607)
  %v1609 = fmul double %v1608, 4.000000e-15
  %v1610 = fcmp ogt double %v1609, %v1606
  %v1611 = select i1 %v1610, double %v1609, double %v1606
  %v1612 = load double, ptr %v710, align 8, !noalias !172
  %v1613 = fdiv double %v1611, %v1612
  %v1614 = fcmp olt double %v1613, 1.000000e+00
  %v1615 = select i1 %v1614, double %v1613, double 1.000000e+00
  br i1 %v727, label %v1616, label %v1617

v1618:
  %v1619 = fcmp olt double %v1620, %v1621
  %v1622 = select i1 %v1619, double %v1620, double %v1621
  %v1623 = fcmp ogt double %v1620, %v1624
  %v1625 = select i1 %v1623, double %v1620, double %v1624
  br label %v1626

v1626:
  %v1627 = phi double [ %v1625, %v1618 ], [ %v1624, %v1628 ]
  %v1629 = phi double [ %v1622, %v1618 ], [ %v1621, %v1628 ]
  %v1630 = icmp eq i64 %v1631, 9
  br i1 %v1630, label %v1632, label %v1628

v1632:
  %v1633 = fsub double %v1627, %v1629
  %v1634 = fmul double %v1615, %v1633
  %v1635 = tail call i1 @llvm.is.fpclass.f64(double %v1636, i32 543)
  %v1637 = select i1 %v1635, double 0.000000e+00, double %v1636
  %v1638 = tail call i1 @llvm.is.fpclass.f64(double %v1634, i32 543)
  %v1639 = select i1 %v1638, double -0.000000e+00, double %v1634
  %v1640 = fadd double %v1637, %v1639
  %v1641 = getelementptr double, ptr %v730, i64 %v1642
  %v1643 = load double, ptr %v1641, align 8, !noalias !172
  %v1644 = sub nsw i64 %v1645, %v18
  %v1646 = getelementptr double, ptr %v215, i64 %v1644
  %v1647 = load double, ptr %v1646, align 8, !noalias !172
  %v1648 = getelementptr double, ptr %v731, i64 %v1642
  store double %v1640, ptr %v1648, align 8, !noalias !172
  %v1649 = fcmp ule double %v1647, 5.000000e-01
  %v1650 = fcmp ule double %v1643, 0.000000e+00
  %v1651 = select i1 %v1649, i1 true, i1 %v1650
  %v1652 = select i1 %v1651, double %v1640, double 0.000000e+00
  %v1653 = getelementptr double, ptr %v1648, i64 %v728
  store double %v1652, ptr %v1653, align 8, !noalias !172
  %v1654 = getelementptr i8, ptr %v1648, i64 %v732
  store double %v1652, ptr %v1654, align 8, !noalias !172
  %v1655 = getelementptr i8, ptr %v1648, i64 %v733
  store double %v1652, ptr %v1655, align 8, !noalias !172
  %v1656 = getelementptr i8, ptr %v1648, i64 %v734
  store double %v1652, ptr %v1656, align 8, !noalias !172
  %v1657 = getelementptr i8, ptr %v1648, i64 %v735
  store double %v1652, ptr %v1657, align 8, !noalias !172
  %v1658 = getelementptr i8, ptr %v1648, i64 %v736
  store double %v1652, ptr %v1658, align 8, !noalias !172
  %v1659 = getelementptr i8, ptr %v1648, i64 %v737
  store double %v1652, ptr %v1659, align 8, !noalias !172
  %v1660 = getelementptr i8, ptr %v1648, i64 %v738
  store double %v1652, ptr %v1660, align 8, !noalias !172
  %v1661 = add nsw i64 %v1662, -1
  %v1663 = add i64 %v1645, 1
  %v1664 = icmp sgt i64 %v1662, 1
  br i1 %v1664, label %v1617, label %v1616

v1617:
  %v1662 = phi i64 [ %v1661, %v1632 ], [ %v15, %v1601 ]
  %v1645 = phi i64 [ %v1663, %v1632 ], [ %v18, %v1601 ]
  %v1665 = icmp slt i64 %v1645, 0
  %v1666 = select i1 %v1665, i64 %v207, i64 0
  %v1642 = add i64 %v1666, %v1645
  br label %v1628

v1628:
  %v1621 = phi double [ 0x7FF0000000000000, %v1617 ], [ %v1629, %v1626 ]
  %v1624 = phi double [ 0xFFF0000000000000, %v1617 ], [ %v1627, %v1626 ]
  %v1667 = phi double [ 0.000000e+00, %v1617 ], [ %v1636, %v1626 ]
  %v1668 = phi i64 [ 0, %v1617 ], [ %v1631, %v1626 ]
  %v1631 = add nsw i64 %v1668, 1
  %v1669 = mul i64 %v1668, %v728
  %v1670 = getelementptr double, ptr %v204, i64 %v1669
  %v1671 = getelementptr i8, ptr %v1670, i64 %v729
  %v1672 = getelementptr double, ptr %v1671, i64 %v1642
  %v1673 = load double, ptr %v1672, align 8, !noalias !172
  %v1674 = tail call i1 @llvm.is.fpclass.f64(double %v1673, i32 543)
  %v1675 = fadd double %v1673, 0.000000e+00
  %v1676 = select i1 %v1674, double 0.000000e+00, double %v1675
  %v1677 = fcmp ogt double %v1676, %v1667
  %v1636 = select i1 %v1677, double %v1676, double %v1667
  %v1678 = getelementptr double, ptr %v1670, i64 %v207
  %v1679 = getelementptr double, ptr %v1678, i64 %v1642
  %v1620 = load double, ptr %v1679, align 8, !noalias !172
  %v1680 = tail call double @llvm.fabs.f64(double %v1620)
  %v1681 = fcmp ueq double %v1680, 0x7FF0000000000000
  br i1 %v1681, label %v1626, label %v1618

v1616:
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %v302, i8 0, i64 32, i1 false), !noalias !147
  %v1682 = call fastcc i32 @_ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr %v302, ptr %v303, i64 %v14, ptr nonnull readonly %v92, i64 %v93, ptr %v124, i64 %v125, i64 %v126, ptr nonnull %v133, i64 %v135, ptr %v142, i64 %v144, ptr %v204, i64 %v205, i64 %v206, i64 %v207, double 0.000000e+00)
  %v1683 = icmp eq i32 %v1682, 0
  br i1 %v1683, label %v1684, label %v1685, !prof !120

v1685:
  %v1686 = load ptr, ptr %v303, align 8, !noalias !147
  br label %v1602

v1684:
  %v1687 = load double, ptr %v302, align 8, !noalias !147
  %v1688 = load double, ptr %v705, align 8, !noalias !147
  %v1689 = load double, ptr %v706, align 8, !noalias !147
  %v1690 = load double, ptr %v707, align 8, !noalias !147
  br label %v1602

v1602:
  %v1691 = phi double [ %v1690, %v1684 ], [ 0.000000e+00, %v1685 ], [ 0.000000e+00, %v1544 ]
  %v1692 = phi double [ %v1689, %v1684 ], [ 0.000000e+00, %v1685 ], [ 0.000000e+00, %v1544 ]
  %v1693 = phi double [ %v1688, %v1684 ], [ 0.000000e+00, %v1685 ], [ 0.000000e+00, %v1544 ]
  %v1694 = phi double [ %v1687, %v1684 ], [ 0.000000e+00, %v1685 ], [ 0.000000e+00, %v1544 ]
  %v1695 = phi ptr [ null, %v1684 ], [ %v1686, %v1685 ], [ %v1599, %v1544 ]
  %v1696 = phi i32 [ 0, %v1684 ], [ 1, %v1685 ], [ %v1600, %v1544 ]
  call void @llvm.lifetime.end.p0(ptr nonnull %v302), !noalias !143
  call void @llvm.lifetime.end.p0(ptr nonnull %v303), !noalias !143
  %v1697 = icmp eq i32 %v1696, 0
  br i1 %v1697, label %v1698, label %v1699, !prof !120

v1700:
  %v1701 = load double, ptr %v710, align 8, !noalias !143
  %v1702 = load double, ptr %v742, align 8, !noalias !143
  %v1703 = load double, ptr %v92, align 8, !noalias !143
  %v1704 = fsub double %v1702, %v1703
  %v1705 = load double, ptr %v744, align 8, !noalias !143
  %v1706 = load double, ptr %v746, align 8, !noalias !143
  %v1707 = fsub double %v1705, %v1706
  %v1708 = fmul double %v1704, 5.000000e-06
  %v1709 = fcmp olt double %v1707, %v1708
  br label %v1710

v1711:
  %v1712 = sub nsw i64 45, %v1713
  br label %v1714

v1714:
  %v1715 = phi double [ %v1716, %v1714 ], [ 1.000000e+00, %v1711 ]
  %v1717 = phi double [ %v1718, %v1714 ], [ 2.000000e+00, %v1711 ]
  %v1719 = phi i64 [ %v1720, %v1714 ], [ %v1712, %v1711 ]
  %v1721 = and i64 %v1719, 1
  %v1722 = icmp eq i64 %v1721, 0
  %v1723 = fmul double %v1715, %v1717
  %v1716 = select i1 %v1722, double %v1715, double %v1723
  %v1720 = lshr i64 %v1719, 1
  %v1718 = fmul double %v1717, %v1717
  %v1724 = icmp eq i64 %v1720, 0
  br i1 %v1724, label %v1725, label %v1714

v1726:
  %v1727 = fcmp olt double %v1728, 0.000000e+00
  %v1729 = select i1 %v1727, double 0.000000e+00, double %v1728
  %v1730 = fmul double %v1731, %v1729
  %v1732 = fsub double %v1733, %v1730
  br label %v1734

v1725:
  %v1735 = fadd double %v1736, %v1737
  %v1733 = fmul double %v1735, 5.000000e-01
  %v1738 = fmul double %v1716, 1.000000e-13
  %v1739 = fsub double %v1738, %v1740
  %v1728 = fmul double %v1739, 5.000000e-01
  %v1741 = fmul double %v1742, %v1737
  %v1743 = fmul double %v1744, %v1736
  %v1745 = fsub double %v1741, %v1743
  %v1746 = fsub double %v1742, %v1744
  %v1747 = fdiv double %v1745, %v1746
  %v1748 = fcmp olt double %v1737, %v1747
  %v1749 = fcmp olt double %v1747, %v1736
  %v1750 = and i1 %v1748, %v1749
  %v1751 = select i1 %v1750, double %v1747, double %v1733
  %v1752 = fsub double %v1733, %v1751
  %v1731 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v1752)
  %v1753 = fmul double %v1740, %v1740
  %v1754 = tail call double @llvm.fabs.f64(double %v1752)
  %v1755 = fcmp olt double %v1754, %v1753
  %v1756 = select i1 %v1755, double %v1754, double %v1753
  %v1757 = fmul double %v1731, %v1756
  %v1758 = fadd double %v1751, %v1757
  %v1759 = fsub double %v1758, %v1733
  %v1760 = tail call double @llvm.fabs.f64(double %v1759)
  %v1761 = fcmp ugt double %v1760, %v1728
  br i1 %v1761, label %v1726, label %v1734

v1762:
  br label %v1763

v1763:
  %v1764 = phi double [ %v1765, %v1762 ], [ %v1737, %v1766 ]
  %v1767 = phi double [ %v1768, %v1762 ], [ %v1744, %v1766 ]
  %v1769 = phi double [ %v1742, %v1762 ], [ %v1768, %v1766 ]
  %v1770 = phi double [ %v1736, %v1762 ], [ %v1765, %v1766 ]
  %v1771 = icmp eq i64 %v1772, 45
  br i1 %v1771, label %v1773, label %v1710

v1710:
  %v1742 = phi double [ %v1691, %v1700 ], [ %v1769, %v1763 ]
  %v1744 = phi double [ %v1692, %v1700 ], [ %v1767, %v1763 ]
  %v1736 = phi double [ %v1693, %v1700 ], [ %v1770, %v1763 ]
  %v1737 = phi double [ %v1694, %v1700 ], [ %v1764, %v1763 ]
  %v1713 = phi i64 [ 0, %v1700 ], [ %v1772, %v1763 ]
  %v1772 = add nsw i64 %v1713, 1
  %v1740 = fsub double %v1736, %v1737
  %v1774 = fcmp ugt double %v1740, 1.000000e-13
  br i1 %v1774, label %v1711, label %v1773

v1734:
  %v1765 = phi double [ %v1758, %v1725 ], [ %v1732, %v1726 ]
  %v1775 = load double, ptr %v133, align 8, !noalias !173
  %v1776 = load double, ptr %v710, align 8, !noalias !173
  %v1777 = fmul double %v1765, %v1776
  %v1778 = fadd double %v1775, %v1777
  store double %v1778, ptr %v712, align 8, !noalias !173
  br i1 %v714, label %v1779, label %v1780

v1779:
  %v1781 = fsub double 1.000000e+00, %v1765
  br label %v1782

v1782:
  %v1783 = phi i64 [ 0, %v1779 ], [ %v1784, %v1782 ]
  %v1785 = mul i64 %v1783, %v196
  %v1786 = getelementptr double, ptr %v193, i64 %v1785
  %v1787 = getelementptr i8, ptr %v1786, i64 %v718
  %v1788 = load double, ptr %v1787, align 8, !noalias !182
  %v1789 = fadd double %v1788, 0.000000e+00
  %v1790 = fmul double %v1765, %v1789
  %v1791 = getelementptr i8, ptr %v1786, i64 %v719
  %v1792 = load double, ptr %v1791, align 8, !noalias !182
  %v1793 = fadd double %v1792, %v1790
  %v1794 = fmul double %v1781, %v1793
  %v1795 = getelementptr i8, ptr %v1786, i64 %v720
  %v1796 = load double, ptr %v1795, align 8, !noalias !182
  %v1797 = fadd double %v1796, %v1794
  %v1798 = fmul double %v1765, %v1797
  %v1799 = getelementptr i8, ptr %v1786, i64 %v721
  %v1800 = load double, ptr %v1799, align 8, !noalias !182
  %v1801 = fadd double %v1800, %v1798
  %v1802 = fmul double %v1781, %v1801
  %v1803 = getelementptr i8, ptr %v1786, i64 %v722
  %v1804 = load double, ptr %v1803, align 8, !noalias !182
  %v1805 = fadd double %v1804, %v1802
  %v1806 = fmul double %v1765, %v1805
  %v1807 = getelementptr i8, ptr %v1786, i64 %v723
  %v1808 = load double, ptr %v1807, align 8, !noalias !182
  %v1809 = fadd double %v1808, %v1806
  %v1810 = fmul double %v1781, %v1809
  %v1811 = getelementptr i8, ptr %v1786, i64 %v724
  %v1812 = load double, ptr %v1811, align 8, !noalias !182
  %v1813 = fadd double %v1812, %v1810
  %v1814 = fmul double %v1765, %v1813
  %v1784 = add nsw i64 %v1783, 1
  %v1815 = load double, ptr %v1786, align 8, !noalias !182
  %v1816 = fadd double %v1815, %v1814
  %v1817 = getelementptr double, ptr %v715, i64 %v1785
  store double %v1816, ptr %v1817, align 8, !noalias !173
  %v1818 = icmp eq i64 %v10, %v1784
  br i1 %v1818, label %v1780, label %v1782

v1780:
  %v1819 = load i64, ptr %v717, align 8, !noalias !186
  %v1820 = inttoptr i64 %v1819 to ptr
  tail call void %v1820(ptr nonnull %v712, ptr %v749, ptr %v165, ptr %v172, ptr %v179, ptr %v751), !noalias !186
  br i1 %v754, label %v1821, label %v1822

v1821:
  %v1823 = phi i64 [ %v1824, %v1821 ], [ %v753, %v1780 ]
  %v1825 = phi i64 [ %v1826, %v1821 ], [ %v18, %v1780 ]
  %v1824 = add nsw i64 %v1823, -1
  %v1826 = add i64 %v1825, 1
  %v1827 = icmp slt i64 %v1825, 0
  %v1828 = select i1 %v1827, i64 %v207, i64 0
  %v1829 = add i64 %v1828, %v1825
  %v1830 = getelementptr double, ptr %v758, i64 %v1829
  %v1831 = load double, ptr %v1830, align 8, !noalias !189
  %v1832 = getelementptr double, ptr %v761, i64 %v1829
  store double %v1831, ptr %v1832, align 8, !noalias !189
  %v1833 = icmp sgt i64 %v1823, 1
  br i1 %v1833, label %v1821, label %v1822

v1822:
  br i1 %v762, label %v1766, label %v1834

v1834:
  %v1835 = phi double [ %v1836, %v1834 ], [ 0x7FF0000000000000, %v1822 ]
  %v1837 = phi i64 [ %v1838, %v1834 ], [ 0, %v1822 ]
  %v1838 = add nsw i64 %v1837, 1
  %v1839 = getelementptr double, ptr %v763, i64 %v1837
  %v1840 = load double, ptr %v1839, align 8, !noalias !190
  %v1841 = getelementptr double, ptr %v761, i64 %v1837
  %v1842 = load double, ptr %v1841, align 8, !noalias !190
  %v1843 = fadd double %v1840, %v1842
  %v1844 = fcmp olt double %v1843, %v1835
  %v1836 = select i1 %v1844, double %v1843, double %v1835
  %v1845 = icmp eq i64 %v207, %v1838
  br i1 %v1845, label %v1766, label %v1834

v1766:
  %v1768 = phi double [ 0x7FF0000000000000, %v1822 ], [ %v1836, %v1834 ]
  %v1846 = fcmp olt double %v1768, 0.000000e+00
  br i1 %v1846, label %v1763, label %v1762

v1847:
  %v1848 = load double, ptr %v133, align 8, !noalias !194
  %v1849 = load double, ptr %v710, align 8, !noalias !194
  %v1850 = fmul double %v1851, %v1849
  %v1852 = fadd double %v1848, %v1850
  store double %v1852, ptr %v712, align 8, !noalias !194
  br i1 %v714, label %v1853, label %v1854

v1853:
  %v1855 = fsub double 1.000000e+00, %v1851
  br label %v1856

v1856:
  %v1857 = phi i64 [ 0, %v1853 ], [ %v1858, %v1856 ]
  %v1859 = mul i64 %v1857, %v196
  %v1860 = getelementptr double, ptr %v193, i64 %v1859
  %v1861 = getelementptr i8, ptr %v1860, i64 %v718
  %v1862 = load double, ptr %v1861, align 8, !noalias !204
  %v1863 = fadd double %v1862, 0.000000e+00
  %v1864 = fmul double %v1851, %v1863
  %v1865 = getelementptr i8, ptr %v1860, i64 %v719
  %v1866 = load double, ptr %v1865, align 8, !noalias !204
  %v1867 = fadd double %v1866, %v1864
  %v1868 = fmul double %v1855, %v1867
  %v1869 = getelementptr i8, ptr %v1860, i64 %v720
  %v1870 = load double, ptr %v1869, align 8, !noalias !204
  %v1871 = fadd double %v1870, %v1868
  %v1872 = fmul double %v1851, %v1871
  %v1873 = getelementptr i8, ptr %v1860, i64 %v721
  %v1874 = load double, ptr %v1873, align 8, !noalias !204
  %v1875 = fadd double %v1874, %v1872
  %v1876 = fmul double %v1855, %v1875
  %v1877 = getelementptr i8, ptr %v1860, i64 %v722
  %v1878 = load double, ptr %v1877, align 8, !noalias !204
  %v1879 = fadd double %v1878, %v1876
  %v1880 = fmul double %v1851, %v1879
  %v1881 = getelementptr i8, ptr %v1860, i64 %v723
  %v1882 = load double, ptr %v1881, align 8, !noalias !204
  %v1883 = fadd double %v1882, %v1880
  %v1884 = fmul double %v1855, %v1883
  %v1885 = getelementptr i8, ptr %v1860, i64 %v724
  %v1886 = load double, ptr %v1885, align 8, !noalias !204
  %v1887 = fadd double %v1886, %v1884
  %v1888 = fmul double %v1851, %v1887
  %v1858 = add nsw i64 %v1857, 1
  %v1889 = load double, ptr %v1860, align 8, !noalias !204
  %v1890 = fadd double %v1889, %v1888
  %v1891 = getelementptr double, ptr %v715, i64 %v1859
  store double %v1890, ptr %v1891, align 8, !noalias !194
  %v1892 = icmp eq i64 %v10, %v1858
  br i1 %v1892, label %v1854, label %v1856

v1854:
  %v1893 = load i64, ptr %v717, align 8, !noalias !208
  %v1894 = inttoptr i64 %v1893 to ptr
  tail call void %v1894(ptr nonnull %v712, ptr %v749, ptr %v165, ptr %v172, ptr %v179, ptr %v751), !noalias !208
  br i1 %v754, label %v1895, label %v1896

v1896:
  br label %v1897

v1895:
  %v1898 = phi i64 [ %v1899, %v1895 ], [ %v753, %v1854 ]
  %v1900 = phi i64 [ %v1901, %v1895 ], [ %v18, %v1854 ]
  %v1899 = add nsw i64 %v1898, -1
  %v1901 = add i64 %v1900, 1
  %v1902 = icmp slt i64 %v1900, 0
  %v1903 = select i1 %v1902, i64 %v207, i64 0
  %v1904 = add i64 %v1903, %v1900
  %v1905 = getelementptr double, ptr %v758, i64 %v1904
  %v1906 = load double, ptr %v1905, align 8, !noalias !211
  %v1907 = getelementptr double, ptr %v761, i64 %v1904
  store double %v1906, ptr %v1907, align 8, !noalias !211
  %v1908 = icmp sgt i64 %v1898, 1
  br i1 %v1908, label %v1895, label %v1896

v1909:
  %v1910 = icmp slt i64 %v1911, 0
  %v1912 = select i1 %v1910, i64 %v207, i64 0
  %v1913 = add i64 %v1912, %v1911
  %v1914 = getelementptr double, ptr %v763, i64 %v1913
  %v1915 = load double, ptr %v1914, align 8, !noalias !212
  br label %v1916

v1917:
  %v1918 = phi i64 [ 0, %v1919 ], [ %v1920, %v1917 ]
  %v1921 = mul i64 %v1918, %v196
  %v1922 = getelementptr double, ptr %v193, i64 %v1921
  %v1923 = getelementptr i8, ptr %v1922, i64 %v718
  %v1924 = load double, ptr %v1923, align 8, !noalias !213
  %v1925 = fadd double %v1924, 0.000000e+00
  %v1926 = fmul double %v1927, %v1925
  %v1928 = getelementptr i8, ptr %v1922, i64 %v719
  %v1929 = load double, ptr %v1928, align 8, !noalias !213
  %v1930 = fadd double %v1929, %v1926
  %v1931 = fmul double %v1932, %v1930
  %v1933 = getelementptr i8, ptr %v1922, i64 %v720
  %v1934 = load double, ptr %v1933, align 8, !noalias !213
  %v1935 = fadd double %v1934, %v1931
  %v1936 = fmul double %v1927, %v1935
  %v1937 = getelementptr i8, ptr %v1922, i64 %v721
  %v1938 = load double, ptr %v1937, align 8, !noalias !213
  %v1939 = fadd double %v1938, %v1936
  %v1940 = fmul double %v1932, %v1939
  %v1941 = getelementptr i8, ptr %v1922, i64 %v722
  %v1942 = load double, ptr %v1941, align 8, !noalias !213
  %v1943 = fadd double %v1942, %v1940
  %v1944 = fmul double %v1927, %v1943
  %v1945 = getelementptr i8, ptr %v1922, i64 %v723
  %v1946 = load double, ptr %v1945, align 8, !noalias !213
  %v1947 = fadd double %v1946, %v1944
  %v1948 = fmul double %v1932, %v1947
  %v1949 = getelementptr i8, ptr %v1922, i64 %v724
  %v1950 = load double, ptr %v1949, align 8, !noalias !213
  %v1951 = fadd double %v1950, %v1948
  %v1952 = fmul double %v1927, %v1951
  %v1920 = add nsw i64 %v1918, 1
  %v1953 = load double, ptr %v1922, align 8, !noalias !213
  %v1954 = fadd double %v1953, %v1952
  %v1955 = getelementptr double, ptr %v715, i64 %v1921
  store double %v1954, ptr %v1955, align 8, !noalias !223
  %v1956 = icmp eq i64 %v10, %v1920
  br i1 %v1956, label %v1957, label %v1917

v1957:
  %v1958 = load i64, ptr %v717, align 8, !noalias !224
  %v1959 = inttoptr i64 %v1958 to ptr
  tail call void %v1959(ptr nonnull %v712, ptr %v749, ptr %v165, ptr %v172, ptr %v179, ptr %v751), !noalias !224
  br i1 %v798, label %v1960, label %v1961

v1961:
  %v1962 = phi i64 [ %v1963, %v1961 ], [ %v753, %v1957 ]
  %v1964 = phi i64 [ %v1965, %v1961 ], [ %v18, %v1957 ]
  %v1963 = add nsw i64 %v1962, -1
  %v1965 = add i64 %v1964, 1
  %v1966 = icmp slt i64 %v1964, 0
  %v1967 = select i1 %v1966, i64 %v207, i64 0
  %v1968 = add i64 %v1967, %v1964
  %v1969 = getelementptr double, ptr %v758, i64 %v1968
  %v1970 = load double, ptr %v1969, align 8, !noalias !227
  %v1971 = getelementptr double, ptr %v761, i64 %v1968
  store double %v1970, ptr %v1971, align 8, !noalias !227
  %v1972 = icmp sgt i64 %v1962, 1
  br i1 %v1972, label %v1961, label %v1960

v1973:
  %v1974 = select i1 %v1975, double %v1851, double %v1927
  %v1976 = fmul double %v1974, 5.000000e-01
  %v1977 = icmp eq i64 %v1978, 45
  br i1 %v1977, label %v1979, label %v1916

v1980:
  %v1981 = getelementptr double, ptr %v758, i64 %v1913
  store double 0.000000e+00, ptr %v1981, align 8, !noalias !212
  br label %v1982

v1983:
  %v1984 = sub nsw i64 45, %v1985
  br label %v1986

v1986:
  %v1987 = phi double [ %v1988, %v1986 ], [ 1.000000e+00, %v1983 ]
  %v1989 = phi double [ %v1990, %v1986 ], [ 2.000000e+00, %v1983 ]
  %v1991 = phi i64 [ %v1992, %v1986 ], [ %v1984, %v1983 ]
  %v1993 = and i64 %v1991, 1
  %v1994 = icmp eq i64 %v1993, 0
  %v1995 = fmul double %v1987, %v1989
  %v1988 = select i1 %v1994, double %v1987, double %v1995
  %v1992 = lshr i64 %v1991, 1
  %v1990 = fmul double %v1989, %v1989
  %v1996 = icmp eq i64 %v1992, 0
  br i1 %v1996, label %v1997, label %v1986

v1998:
  %v1999 = fcmp olt double %v2000, 0.000000e+00
  %v2001 = select i1 %v1999, double 0.000000e+00, double %v2000
  %v2002 = fmul double %v2003, %v2001
  %v2004 = fsub double %v2005, %v2002
  br label %v2006

v1997:
  %v2007 = fadd double %v2008, %v2009
  %v2005 = fmul double %v2007, 5.000000e-01
  %v2010 = fmul double %v1988, 0x3D06849B86A12B9B
  %v2011 = fsub double %v2010, %v2012
  %v2000 = fmul double %v2011, 5.000000e-01
  %v2013 = fmul double %v2014, %v2009
  %v2015 = fmul double %v2016, %v2008
  %v2017 = fsub double %v2013, %v2015
  %v2018 = fsub double %v2014, %v2016
  %v2019 = fdiv double %v2017, %v2018
  %v2020 = fcmp olt double %v2009, %v2019
  %v2021 = fcmp olt double %v2019, %v2008
  %v2022 = and i1 %v2020, %v2021
  %v2023 = select i1 %v2022, double %v2019, double %v2005
  %v2024 = fsub double %v2005, %v2023
  %v2003 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v2024)
  %v2025 = fmul double %v2012, %v2012
  %v2026 = tail call double @llvm.fabs.f64(double %v2024)
  %v2027 = fcmp olt double %v2026, %v2025
  %v2028 = select i1 %v2027, double %v2026, double %v2025
  %v2029 = fmul double %v2003, %v2028
  %v2030 = fadd double %v2023, %v2029
  %v2031 = fsub double %v2030, %v2005
  %v2032 = tail call double @llvm.fabs.f64(double %v2031)
  %v2033 = fcmp ugt double %v2032, %v2000
  br i1 %v2033, label %v1998, label %v2006

v2034:
  br label %v2035

v2035:
  %v2036 = phi double [ %v2037, %v2034 ], [ %v2009, %v2038 ]
  %v2039 = phi double [ %v2040, %v2034 ], [ %v2016, %v2038 ]
  %v2041 = phi double [ %v2014, %v2034 ], [ %v2040, %v2038 ]
  %v2042 = phi double [ %v2008, %v2034 ], [ %v2037, %v2038 ]
  %v2043 = icmp eq i64 %v2044, 45
  br i1 %v2043, label %v1979, label %v1982

v1982:
  %v2014 = phi double [ %v1915, %v1980 ], [ %v2041, %v2035 ]
  %v2016 = phi double [ %v2045, %v1980 ], [ %v2039, %v2035 ]
  %v2008 = phi double [ %v1851, %v1980 ], [ %v2042, %v2035 ]
  %v2009 = phi double [ %v1927, %v1980 ], [ %v2036, %v2035 ]
  %v1985 = phi i64 [ 0, %v1980 ], [ %v2044, %v2035 ]
  %v2044 = add nsw i64 %v1985, 1
  %v2012 = fsub double %v2008, %v2009
  %v2046 = fcmp ugt double %v2012, 0x3D06849B86A12B9B
  br i1 %v2046, label %v1983, label %v1979

v2006:
  %v2037 = phi double [ %v2030, %v1997 ], [ %v2004, %v1998 ]
  %v2047 = load double, ptr %v133, align 8, !noalias !228
  %v2048 = load double, ptr %v710, align 8, !noalias !228
  %v2049 = fmul double %v2037, %v2048
  %v2050 = fadd double %v2047, %v2049
  store double %v2050, ptr %v712, align 8, !noalias !228
  br i1 %v714, label %v2051, label %v2052

v2051:
  %v2053 = fsub double 1.000000e+00, %v2037
  br label %v2054

v2054:
  %v2055 = phi i64 [ 0, %v2051 ], [ %v2056, %v2054 ]
  %v2057 = mul i64 %v2055, %v196
  %v2058 = getelementptr double, ptr %v193, i64 %v2057
  %v2059 = getelementptr i8, ptr %v2058, i64 %v718
  %v2060 = load double, ptr %v2059, align 8, !noalias !237
  %v2061 = fadd double %v2060, 0.000000e+00
  %v2062 = fmul double %v2037, %v2061
  %v2063 = getelementptr i8, ptr %v2058, i64 %v719
  %v2064 = load double, ptr %v2063, align 8, !noalias !237
  %v2065 = fadd double %v2064, %v2062
  %v2066 = fmul double %v2053, %v2065
  %v2067 = getelementptr i8, ptr %v2058, i64 %v720
  %v2068 = load double, ptr %v2067, align 8, !noalias !237
  %v2069 = fadd double %v2068, %v2066
  %v2070 = fmul double %v2037, %v2069
  %v2071 = getelementptr i8, ptr %v2058, i64 %v721
  %v2072 = load double, ptr %v2071, align 8, !noalias !237
  %v2073 = fadd double %v2072, %v2070
  %v2074 = fmul double %v2053, %v2073
  %v2075 = getelementptr i8, ptr %v2058, i64 %v722
  %v2076 = load double, ptr %v2075, align 8, !noalias !237
  %v2077 = fadd double %v2076, %v2074
  %v2078 = fmul double %v2037, %v2077
  %v2079 = getelementptr i8, ptr %v2058, i64 %v723
  %v2080 = load double, ptr %v2079, align 8, !noalias !237
  %v2081 = fadd double %v2080, %v2078
  %v2082 = fmul double %v2053, %v2081
  %v2083 = getelementptr i8, ptr %v2058, i64 %v724
  %v2084 = load double, ptr %v2083, align 8, !noalias !237
  %v2085 = fadd double %v2084, %v2082
  %v2086 = fmul double %v2037, %v2085
  %v2056 = add nsw i64 %v2055, 1
  %v2087 = load double, ptr %v2058, align 8, !noalias !237
  %v2088 = fadd double %v2087, %v2086
  %v2089 = getelementptr double, ptr %v715, i64 %v2057
  store double %v2088, ptr %v2089, align 8, !noalias !228
  %v2090 = icmp eq i64 %v10, %v2056
  br i1 %v2090, label %v2052, label %v2054

v2052:
  %v2091 = load i64, ptr %v717, align 8, !noalias !241
  %v2092 = inttoptr i64 %v2091 to ptr
  tail call void %v2092(ptr nonnull %v712, ptr %v749, ptr %v165, ptr %v172, ptr %v179, ptr %v751), !noalias !241
  br i1 %v754, label %v2093, label %v2094

v2093:
  %v2095 = phi i64 [ %v2096, %v2093 ], [ %v753, %v2052 ]
  %v2097 = phi i64 [ %v2098, %v2093 ], [ %v18, %v2052 ]
  %v2096 = add nsw i64 %v2095, -1
  %v2098 = add i64 %v2097, 1
  %v2099 = icmp slt i64 %v2097, 0
  %v2100 = select i1 %v2099, i64 %v207, i64 0
  %v2101 = add i64 %v2100, %v2097
  %v2102 = getelementptr double, ptr %v758, i64 %v2101
  %v2103 = load double, ptr %v2102, align 8, !noalias !244
  %v2104 = getelementptr double, ptr %v761, i64 %v2101
  store double %v2103, ptr %v2104, align 8, !noalias !244
  %v2105 = icmp sgt i64 %v2095, 1
  br i1 %v2105, label %v2093, label %v2094

v2094:
  br i1 %v762, label %v2038, label %v2106

v2106:
  %v2107 = phi double [ %v2108, %v2106 ], [ 0x7FF0000000000000, %v2094 ]
  %v2109 = phi i64 [ %v2110, %v2106 ], [ 0, %v2094 ]
  %v2110 = add nsw i64 %v2109, 1
  %v2111 = getelementptr double, ptr %v763, i64 %v2109
  %v2112 = load double, ptr %v2111, align 8, !noalias !245
  %v2113 = getelementptr double, ptr %v761, i64 %v2109
  %v2114 = load double, ptr %v2113, align 8, !noalias !245
  %v2115 = fadd double %v2112, %v2114
  %v2116 = fcmp olt double %v2115, %v2107
  %v2108 = select i1 %v2116, double %v2115, double %v2107
  %v2117 = icmp eq i64 %v207, %v2110
  br i1 %v2117, label %v2038, label %v2106

v2038:
  %v2040 = phi double [ 0x7FF0000000000000, %v2094 ], [ %v2108, %v2106 ]
  %v2118 = fcmp olt double %v2040, 0.000000e+00
  br i1 %v2118, label %v2035, label %v2034

v1979:
  %v2119 = phi double [ %v2008, %v1982 ], [ %v2042, %v2035 ], [ 0.000000e+00, %v1973 ]
  %v2120 = phi double [ %v2009, %v1982 ], [ %v2036, %v2035 ], [ %v1927, %v1973 ]
  store double %v2120, ptr %v800, align 8, !noalias !212
  store double %v2119, ptr %v802, align 8, !noalias !212
  %v2121 = load double, ptr %v133, align 8, !noalias !212
  %v2122 = load double, ptr %v710, align 8, !noalias !212
  %v2123 = fmul double %v2119, %v2122
  %v2124 = fadd double %v2121, %v2123
  %v2125 = load i64, ptr %v142, align 8, !noalias !249
  %v2126 = load i64, ptr %v804, align 8, !noalias !249
  %v2127 = icmp slt i64 %v2126, %v93
  br i1 %v2127, label %v2128, label %v2129

v2128:
  %v2130 = icmp slt i64 %v2126, 0
  %v2131 = select i1 %v2130, i64 %v93, i64 0
  %v2132 = getelementptr double, ptr %v92, i64 %v2126
  %v2133 = getelementptr double, ptr %v2132, i64 %v2131
  %v2134 = load double, ptr %v2133, align 8, !noalias !249
  %v2135 = fcmp ugt double %v2134, %v2124
  br i1 %v2135, label %v2129, label %v2136

v2136:
  %v2137 = icmp slt i64 %v2125, 0
  %v2138 = select i1 %v2137, i64 %v100, i64 0
  %v2139 = add i64 %v2138, %v2125
  %v2140 = mul i64 %v807, %v2139
  %v2141 = getelementptr double, ptr %v99, i64 %v2140
  br label %v2142

v2142:
  %v2143 = phi i64 [ %v2144, %v2145 ], [ %v2126, %v2136 ]
  %v2146 = icmp slt i64 %v2143, 0
  %v2147 = select i1 %v2146, i64 %v93, i64 0
  %v2148 = getelementptr double, ptr %v92, i64 %v2143
  %v2149 = getelementptr double, ptr %v2148, i64 %v2147
  %v2150 = load double, ptr %v2149, align 8, !noalias !249
  %v2151 = load double, ptr %v133, align 8, !noalias !249
  %v2152 = fsub double %v2150, %v2151
  %v2153 = load double, ptr %v710, align 8, !noalias !249
  %v2154 = fdiv double %v2152, %v2153
  br i1 %v797, label %v2155, label %v2156

v2156:
  %v2157 = fsub double 1.000000e+00, %v2154
  %v2158 = select i1 %v2146, i64 %v101, i64 0
  %v2159 = add i64 %v2158, %v2143
  %v2160 = mul i64 %v2159, %v102
  %v2161 = getelementptr double, ptr %v2141, i64 %v2160
  br label %v2162

v2163:
  %v2164 = getelementptr double, ptr %v809, i64 %v2165
  %v2166 = load double, ptr %v2164, align 8, !noalias !249
  br label %v2167

v2155:
  store double 0x7FF0000000000000, ptr %v806, align 8, !noalias !249
  %v2168 = icmp eq i64 %v2143, %v810
  br i1 %v2168, label %v2129, label %v2145

v2145:
  %v2144 = add i64 %v2143, 1
  %v2169 = icmp slt i64 %v2143, -1
  %v2170 = select i1 %v2169, i64 %v93, i64 0
  %v2171 = getelementptr double, ptr %v92, i64 %v2144
  %v2172 = getelementptr double, ptr %v2171, i64 %v2170
  %v2173 = load double, ptr %v2172, align 8, !noalias !249
  %v2174 = fcmp ugt double %v2173, %v2124
  br i1 %v2174, label %v2129, label %v2142

v2129:
  %v2175 = phi i64 [ %v2126, %v2128 ], [ %v2126, %v1979 ], [ %v93, %v2155 ], [ %v2144, %v2145 ]
  store i64 %v2175, ptr %v804, align 8, !noalias !249
  store i64 %v1911, ptr %v740, align 8, !noalias !212
  %v2176 = load i64, ptr %v142, align 8, !noalias !253
  %v2177 = icmp sgt i64 %v2176, -1
  br i1 %v2177, label %v2178, label %v2179

v2167:
  %v2180 = phi double [ %v2181, %v2182 ], [ %v2166, %v2163 ]
  %v2183 = getelementptr double, ptr %v2161, i64 %v2184
  store double %v2180, ptr %v2183, align 8, !noalias !249
  %v2185 = icmp eq i64 %v10, %v2186
  br i1 %v2185, label %v2155, label %v2162

v2162:
  %v2184 = phi i64 [ 0, %v2156 ], [ %v2186, %v2167 ]
  %v2186 = add nsw i64 %v2184, 1
  %v2187 = load double, ptr %v2149, align 8, !noalias !249
  %v2188 = load double, ptr %v744, align 8, !noalias !249
  %v2189 = fcmp oeq double %v2187, %v2188
  %v2165 = mul i64 %v2184, %v196
  br i1 %v2189, label %v2163, label %v2182

v2182:
  %v2190 = getelementptr double, ptr %v193, i64 %v2165
  %v2191 = getelementptr i8, ptr %v2190, i64 %v718
  %v2192 = load double, ptr %v2191, align 8, !noalias !256
  %v2193 = fadd double %v2192, 0.000000e+00
  %v2194 = fmul double %v2154, %v2193
  %v2195 = getelementptr i8, ptr %v2190, i64 %v719
  %v2196 = load double, ptr %v2195, align 8, !noalias !256
  %v2197 = fadd double %v2196, %v2194
  %v2198 = fmul double %v2157, %v2197
  %v2199 = getelementptr i8, ptr %v2190, i64 %v720
  %v2200 = load double, ptr %v2199, align 8, !noalias !256
  %v2201 = fadd double %v2200, %v2198
  %v2202 = fmul double %v2154, %v2201
  %v2203 = getelementptr i8, ptr %v2190, i64 %v721
  %v2204 = load double, ptr %v2203, align 8, !noalias !256
  %v2205 = fadd double %v2204, %v2202
  %v2206 = fmul double %v2157, %v2205
  %v2207 = getelementptr i8, ptr %v2190, i64 %v722
  %v2208 = load double, ptr %v2207, align 8, !noalias !256
  %v2209 = fadd double %v2208, %v2206
  %v2210 = fmul double %v2154, %v2209
  %v2211 = getelementptr i8, ptr %v2190, i64 %v723
  %v2212 = load double, ptr %v2211, align 8, !noalias !256
  %v2213 = fadd double %v2212, %v2210
  %v2214 = fmul double %v2157, %v2213
  %v2215 = getelementptr i8, ptr %v2190, i64 %v724
  %v2216 = load double, ptr %v2215, align 8, !noalias !256
  %v2217 = fadd double %v2216, %v2214
  %v2218 = fmul double %v2154, %v2217
  %v2219 = load double, ptr %v2190, align 8, !noalias !256
  %v2181 = fadd double %v2219, %v2218
  br label %v2167

v1897:
  %v2220 = phi i64 [ %v2221, %v2222 ], [ 0, %v1896 ]
  %v2223 = phi i64 [ %v2224, %v2222 ], [ %v796, %v1896 ]
  %v2225 = icmp sgt i64 %v2223, 0
  br i1 %v2225, label %v2222, label %v2226

v2222:
  %v2224 = add nsw i64 %v2223, -1
  %v2221 = add i64 %v2220, 1
  %v2227 = getelementptr double, ptr %v763, i64 %v2220
  %v2228 = load double, ptr %v2227, align 8, !noalias !260
  %v2229 = getelementptr double, ptr %v761, i64 %v2220
  %v2230 = load double, ptr %v2229, align 8, !noalias !260
  %v2231 = fneg double %v2230
  %v2232 = fcmp olt double %v2228, %v2231
  br i1 %v2232, label %v2226, label %v1897

v2226:
  %v1911 = phi i64 [ %v2220, %v2222 ], [ -1, %v1897 ]
  %v2233 = icmp slt i64 %v1911, %v18
  br i1 %v2233, label %v2234, label %v1909

v1916:
  %v1927 = phi double [ %v1694, %v1909 ], [ %v1976, %v1973 ]
  %v2235 = phi i64 [ 0, %v1909 ], [ %v1978, %v1973 ]
  %v1978 = add nsw i64 %v2235, 1
  %v1975 = icmp eq i64 %v2235, 0
  %v2236 = load double, ptr %v133, align 8, !noalias !223
  %v2237 = load double, ptr %v710, align 8, !noalias !223
  %v2238 = fmul double %v1927, %v2237
  %v2239 = fadd double %v2236, %v2238
  store double %v2239, ptr %v712, align 8, !noalias !223
  br i1 %v797, label %v1957, label %v1919

v1919:
  %v1932 = fsub double 1.000000e+00, %v1927
  br label %v1917

v1960:
  %v2045 = load double, ptr %v1914, align 8, !noalias !212
  %v2240 = fcmp ogt double %v2045, 0.000000e+00
  br i1 %v2240, label %v1980, label %v1973

v2178:
  %v2241 = getelementptr i64, ptr %v110, i64 %v2176
  %v2242 = load i64, ptr %v2241, align 8, !noalias !253
  %v2243 = icmp eq i64 %v2242, 0
  br i1 %v2243, label %v2244, label %v2179

v2244:
  store i64 4, ptr %v2241, align 8, !noalias !253
  br label %v2179

v2179:
  store double 0.000000e+00, ptr %v812, align 8, !noalias !212
  br label %v1699

v2245:
  br i1 %v1709, label %v2234, label %v2246

v2246:
  call void @llvm.lifetime.start.p0(ptr nonnull %v300), !noalias !143
  call void @llvm.lifetime.start.p0(ptr nonnull %v301), !noalias !143
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %v300, i8 0, i64 32, i1 false), !noalias !264
  store ptr null, ptr %v301, align 8, !noalias !264
  br i1 %v305, label %v2247, label %v2248

v2249:
  %v2250 = phi i64 [ %v2251, %v2252 ], [ 0, %v2253 ]
  %v2251 = add nsw i64 %v2250, 1
  %v2254 = icmp ult i64 %v2250, 9
  br i1 %v2254, label %v2255, label %v2256

v2255:
  %v2257 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v2250
  %v2258 = load double, ptr %v2257, align 8
  %v2259 = load double, ptr %v133, align 8, !noalias !268
  %v2260 = load double, ptr %v710, align 8, !noalias !268
  %v2261 = fmul double %v2258, %v2260
  %v2262 = fadd double %v2259, %v2261
  store double %v2262, ptr %v712, align 8, !noalias !268
  br i1 %v714, label %v2263, label %v2252

v2263:
  %v2264 = fsub double 1.000000e+00, %v2258
  br label %v2265

v2265:
  %v2266 = phi i64 [ 0, %v2263 ], [ %v2267, %v2265 ]
  %v2268 = mul i64 %v2266, %v196
  %v2269 = getelementptr double, ptr %v193, i64 %v2268
  %v2270 = getelementptr i8, ptr %v2269, i64 %v718
  %v2271 = load double, ptr %v2270, align 8, !noalias !275
  %v2272 = fadd double %v2271, 0.000000e+00
  %v2273 = fmul double %v2258, %v2272
  %v2274 = getelementptr i8, ptr %v2269, i64 %v719
  %v2275 = load double, ptr %v2274, align 8, !noalias !275
  %v2276 = fadd double %v2275, %v2273
  %v2277 = fmul double %v2264, %v2276
  %v2278 = getelementptr i8, ptr %v2269, i64 %v720
  %v2279 = load double, ptr %v2278, align 8, !noalias !275
  %v2280 = fadd double %v2279, %v2277
  %v2281 = fmul double %v2258, %v2280
  %v2282 = getelementptr i8, ptr %v2269, i64 %v721
  %v2283 = load double, ptr %v2282, align 8, !noalias !275
  %v2284 = fadd double %v2283, %v2281
  %v2285 = fmul double %v2264, %v2284
  %v2286 = getelementptr i8, ptr %v2269, i64 %v722
  %v2287 = load double, ptr %v2286, align 8, !noalias !275
  %v2288 = fadd double %v2287, %v2285
  %v2289 = fmul double %v2258, %v2288
  %v2290 = getelementptr i8, ptr %v2269, i64 %v723
  %v2291 = load double, ptr %v2290, align 8, !noalias !275
  %v2292 = fadd double %v2291, %v2289
  %v2293 = fmul double %v2264, %v2292
  %v2294 = getelementptr i8, ptr %v2269, i64 %v724
  %v2295 = load double, ptr %v2294, align 8, !noalias !275
  %v2296 = fadd double %v2295, %v2293
  %v2297 = fmul double %v2258, %v2296
  %v2267 = add nsw i64 %v2266, 1
  %v2298 = load double, ptr %v2269, align 8, !noalias !275
  %v2299 = fadd double %v2298, %v2297
  %v2300 = getelementptr double, ptr %v715, i64 %v2268
  store double %v2299, ptr %v2300, align 8, !noalias !268
  %v2301 = icmp eq i64 %v10, %v2267
  br i1 %v2301, label %v2252, label %v2265

v2252:
  %v2302 = icmp eq i64 %v2250, 8
  %v2303 = select i1 %v2302, i64 17, i64 16
  %v2304 = mul i64 %v2250, %v716
  %v2305 = load i64, ptr %v717, align 8, !noalias !279
  %v2306 = mul nsw i64 %v2303, %v10
  %v2307 = getelementptr double, ptr %v158, i64 %v2306
  %v2308 = getelementptr double, ptr %v186, i64 %v2304
  %v2309 = inttoptr i64 %v2305 to ptr
  tail call void %v2309(ptr nonnull %v712, ptr %v2307, ptr %v165, ptr %v172, ptr %v179, ptr %v2308), !noalias !279
  %v2310 = icmp eq i64 %v2251, 9
  br i1 %v2310, label %v2256, label %v2249

v2256:
  %v2311 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v2249 ], [ %v2312, %v2252 ]
  %v2313 = phi i32 [ 1, %v2249 ], [ 0, %v2252 ]
  br i1 %v2254, label %v2314, label %v2315, !prof !120

v2316:
  %v2317 = load double, ptr %v786, align 8, !noalias !264
  %v2318 = fcmp ogt double %v2317, 5.000000e-01
  br i1 %v2318, label %v2319, label %v2320

v2319:
  %v2321 = load i64, ptr %v6, align 8, !noalias !282
  %v2322 = inttoptr i64 %v2321 to ptr
  tail call void %v2322(ptr nonnull %v744, ptr %v791, ptr %v165, ptr %v172, ptr %v179, ptr %v793), !noalias !282
  %v2323 = load double, ptr %v744, align 8, !noalias !264
  store double %v2323, ptr %v746, align 8, !noalias !264
  br label %v2324

v2325:
  %v2326 = sub nsw i64 45, %v2327
  br label %v2328

v2328:
  %v2329 = phi double [ %v2330, %v2328 ], [ 1.000000e+00, %v2325 ]
  %v2331 = phi double [ %v2332, %v2328 ], [ 2.000000e+00, %v2325 ]
  %v2333 = phi i64 [ %v2334, %v2328 ], [ %v2326, %v2325 ]
  %v2335 = and i64 %v2333, 1
  %v2336 = icmp eq i64 %v2335, 0
  %v2337 = fmul double %v2329, %v2331
  %v2330 = select i1 %v2336, double %v2329, double %v2337
  %v2334 = lshr i64 %v2333, 1
  %v2332 = fmul double %v2331, %v2331
  %v2338 = icmp eq i64 %v2334, 0
  br i1 %v2338, label %v2339, label %v2328

v2340:
  %v2341 = fcmp olt double %v2342, 0.000000e+00
  %v2343 = select i1 %v2341, double 0.000000e+00, double %v2342
  %v2344 = fmul double %v2345, %v2343
  %v2346 = fsub double %v2347, %v2344
  br label %v2348

v2339:
  %v2349 = fadd double %v2350, %v2351
  %v2347 = fmul double %v2349, 5.000000e-01
  %v2352 = fmul double %v2330, 1.000000e-13
  %v2353 = fsub double %v2352, %v2354
  %v2342 = fmul double %v2353, 5.000000e-01
  %v2355 = fmul double %v2356, %v2351
  %v2357 = fmul double %v2358, %v2350
  %v2359 = fsub double %v2355, %v2357
  %v2360 = fsub double %v2356, %v2358
  %v2361 = fdiv double %v2359, %v2360
  %v2362 = fcmp olt double %v2351, %v2361
  %v2363 = fcmp olt double %v2361, %v2350
  %v2364 = and i1 %v2362, %v2363
  %v2365 = select i1 %v2364, double %v2361, double %v2347
  %v2366 = fsub double %v2347, %v2365
  %v2345 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v2366)
  %v2367 = fmul double %v2354, %v2354
  %v2368 = tail call double @llvm.fabs.f64(double %v2366)
  %v2369 = fcmp olt double %v2368, %v2367
  %v2370 = select i1 %v2369, double %v2368, double %v2367
  %v2371 = fmul double %v2345, %v2370
  %v2372 = fadd double %v2365, %v2371
  %v2373 = fsub double %v2372, %v2347
  %v2374 = tail call double @llvm.fabs.f64(double %v2373)
  %v2375 = fcmp ugt double %v2374, %v2342
  br i1 %v2375, label %v2340, label %v2348

v2376:
  br label %v2377

v2377:
  %v2378 = phi double [ %v2379, %v2376 ], [ %v2351, %v2380 ]
  %v2381 = phi double [ %v2382, %v2376 ], [ %v2358, %v2380 ]
  %v2383 = phi double [ %v2356, %v2376 ], [ %v2382, %v2380 ]
  %v2384 = phi double [ %v2350, %v2376 ], [ %v2379, %v2380 ]
  %v2385 = icmp eq i64 %v2386, 45
  br i1 %v2385, label %v2387, label %v2388

v2388:
  %v2356 = phi double [ %v2383, %v2377 ], [ %v2389, %v2390 ]
  %v2358 = phi double [ %v2381, %v2377 ], [ %v2391, %v2390 ]
  %v2350 = phi double [ %v2384, %v2377 ], [ %v2392, %v2390 ]
  %v2351 = phi double [ %v2378, %v2377 ], [ %v2393, %v2390 ]
  %v2327 = phi i64 [ %v2386, %v2377 ], [ 0, %v2390 ]
  %v2386 = add nsw i64 %v2327, 1
  %v2354 = fsub double %v2350, %v2351
  %v2394 = fcmp ugt double %v2354, 1.000000e-13
  br i1 %v2394, label %v2325, label %v2387

v2348:
  %v2379 = phi double [ %v2372, %v2339 ], [ %v2346, %v2340 ]
  %v2395 = load double, ptr %v133, align 8, !noalias !285
  %v2396 = load double, ptr %v710, align 8, !noalias !285
  %v2397 = fmul double %v2379, %v2396
  %v2398 = fadd double %v2395, %v2397
  store double %v2398, ptr %v712, align 8, !noalias !285
  br i1 %v714, label %v2399, label %v2400

v2399:
  %v2401 = fsub double 1.000000e+00, %v2379
  br label %v2402

v2402:
  %v2403 = phi i64 [ 0, %v2399 ], [ %v2404, %v2402 ]
  %v2405 = mul i64 %v2403, %v196
  %v2406 = getelementptr double, ptr %v193, i64 %v2405
  %v2407 = getelementptr i8, ptr %v2406, i64 %v718
  %v2408 = load double, ptr %v2407, align 8, !noalias !294
  %v2409 = fadd double %v2408, 0.000000e+00
  %v2410 = fmul double %v2379, %v2409
  %v2411 = getelementptr i8, ptr %v2406, i64 %v719
  %v2412 = load double, ptr %v2411, align 8, !noalias !294
  %v2413 = fadd double %v2412, %v2410
  %v2414 = fmul double %v2401, %v2413
  %v2415 = getelementptr i8, ptr %v2406, i64 %v720
  %v2416 = load double, ptr %v2415, align 8, !noalias !294
  %v2417 = fadd double %v2416, %v2414
  %v2418 = fmul double %v2379, %v2417
  %v2419 = getelementptr i8, ptr %v2406, i64 %v721
  %v2420 = load double, ptr %v2419, align 8, !noalias !294
  %v2421 = fadd double %v2420, %v2418
  %v2422 = fmul double %v2401, %v2421
  %v2423 = getelementptr i8, ptr %v2406, i64 %v722
  %v2424 = load double, ptr %v2423, align 8, !noalias !294
  %v2425 = fadd double %v2424, %v2422
  %v2426 = fmul double %v2379, %v2425
  %v2427 = getelementptr i8, ptr %v2406, i64 %v723
  %v2428 = load double, ptr %v2427, align 8, !noalias !294
  %v2429 = fadd double %v2428, %v2426
  %v2430 = fmul double %v2401, %v2429
  %v2431 = getelementptr i8, ptr %v2406, i64 %v724
  %v2432 = load double, ptr %v2431, align 8, !noalias !294
  %v2433 = fadd double %v2432, %v2430
  %v2434 = fmul double %v2379, %v2433
  %v2404 = add nsw i64 %v2403, 1
  %v2435 = load double, ptr %v2406, align 8, !noalias !294
  %v2436 = fadd double %v2435, %v2434
  %v2437 = getelementptr double, ptr %v715, i64 %v2405
  store double %v2436, ptr %v2437, align 8, !noalias !285
  %v2438 = icmp eq i64 %v10, %v2404
  br i1 %v2438, label %v2400, label %v2402

v2400:
  %v2439 = load i64, ptr %v717, align 8, !noalias !298
  %v2440 = inttoptr i64 %v2439 to ptr
  tail call void %v2440(ptr nonnull %v712, ptr %v749, ptr %v165, ptr %v172, ptr %v179, ptr %v751), !noalias !298
  br i1 %v754, label %v2441, label %v2442

v2441:
  %v2443 = phi i64 [ %v2444, %v2441 ], [ %v753, %v2400 ]
  %v2445 = phi i64 [ %v2446, %v2441 ], [ %v18, %v2400 ]
  %v2444 = add nsw i64 %v2443, -1
  %v2446 = add i64 %v2445, 1
  %v2447 = icmp slt i64 %v2445, 0
  %v2448 = select i1 %v2447, i64 %v207, i64 0
  %v2449 = add i64 %v2448, %v2445
  %v2450 = getelementptr double, ptr %v758, i64 %v2449
  %v2451 = load double, ptr %v2450, align 8, !noalias !301
  %v2452 = getelementptr double, ptr %v761, i64 %v2449
  store double %v2451, ptr %v2452, align 8, !noalias !301
  %v2453 = icmp sgt i64 %v2443, 1
  br i1 %v2453, label %v2441, label %v2442

v2442:
  br i1 %v762, label %v2380, label %v2454

v2454:
  %v2455 = phi double [ %v2456, %v2454 ], [ 0x7FF0000000000000, %v2442 ]
  %v2457 = phi i64 [ %v2458, %v2454 ], [ 0, %v2442 ]
  %v2458 = add nsw i64 %v2457, 1
  %v2459 = getelementptr double, ptr %v763, i64 %v2457
  %v2460 = load double, ptr %v2459, align 8, !noalias !302
  %v2461 = getelementptr double, ptr %v761, i64 %v2457
  %v2462 = load double, ptr %v2461, align 8, !noalias !302
  %v2463 = fadd double %v2460, %v2462
  %v2464 = fcmp olt double %v2463, %v2455
  %v2456 = select i1 %v2464, double %v2463, double %v2455
  %v2465 = icmp eq i64 %v207, %v2458
  br i1 %v2465, label %v2380, label %v2454

v2380:
  %v2382 = phi double [ 0x7FF0000000000000, %v2442 ], [ %v2456, %v2454 ]
  %v2466 = fcmp olt double %v2382, 0.000000e+00
  br i1 %v2466, label %v2377, label %v2376

v2320:
  br i1 %v787, label %v2467, label %v2468

v2467:
  %v2469 = load i64, ptr %v777, align 8, !noalias !306
  %v2470 = inttoptr i64 %v2469 to ptr
  tail call void %v2470(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !306
  br label %v2324

v2468:
  %v2471 = phi i64 [ %v2472, %v2468 ], [ 0, %v2320 ]
  %v2472 = add nsw i64 %v2471, 1
  %v2473 = add nsw i64 %v2471, %v17
  %v2474 = icmp slt i64 %v2473, 0
  %v2475 = select i1 %v2474, i64 %v166, i64 0
  %v2476 = getelementptr double, ptr %v165, i64 %v2473
  %v2477 = getelementptr double, ptr %v2476, i64 %v2475
  %v2478 = load double, ptr %v2477, align 8, !noalias !312
  %v2479 = getelementptr double, ptr %v789, i64 %v2471
  %v2480 = load double, ptr %v2479, align 8, !noalias !312
  store double %v2480, ptr %v2477, align 8, !noalias !312
  store double %v2478, ptr %v2479, align 8, !noalias !312
  %v2481 = icmp eq i64 %v18, %v2472
  br i1 %v2481, label %v2467, label %v2468

v2247:
  %v2482 = phi i64 [ %v2483, %v2247 ], [ 0, %v2246 ]
  %v2483 = add nsw i64 %v2482, 1
  %v2484 = add nsw i64 %v2482, %v17
  %v2485 = icmp slt i64 %v2484, 0
  %v2486 = select i1 %v2485, i64 %v166, i64 0
  %v2487 = getelementptr double, ptr %v165, i64 %v2484
  %v2488 = getelementptr double, ptr %v2487, i64 %v2486
  %v2489 = load double, ptr %v2488, align 8, !noalias !264
  %v2490 = getelementptr double, ptr %v768, i64 %v2482
  store double %v2489, ptr %v2490, align 8, !noalias !264
  %v2491 = icmp eq i64 %v18, %v2483
  br i1 %v2491, label %v2248, label %v2247

v2248:
  br label %v2492

v2492:
  %v2493 = phi double [ %v2494, %v2387 ], [ %v1851, %v2248 ]
  %v2312 = phi ptr [ %v2311, %v2387 ], [ null, %v2248 ]
  %v2495 = phi ptr [ %v2496, %v2387 ], [ null, %v2248 ]
  %v2497 = phi i64 [ %v2498, %v2387 ], [ 32, %v2248 ]
  %v2498 = add nsw i64 %v2497, -1
  %v2499 = load double, ptr %v133, align 8, !noalias !313
  %v2500 = load double, ptr %v710, align 8, !noalias !313
  %v2501 = fmul double %v2493, %v2500
  %v2502 = fadd double %v2499, %v2501
  store double %v2502, ptr %v712, align 8, !noalias !313
  br i1 %v714, label %v2503, label %v2504

v2503:
  %v2505 = fsub double 1.000000e+00, %v2493
  br label %v2506

v2506:
  %v2507 = phi i64 [ 0, %v2503 ], [ %v2508, %v2506 ]
  %v2509 = mul i64 %v2507, %v196
  %v2510 = getelementptr double, ptr %v193, i64 %v2509
  %v2511 = getelementptr i8, ptr %v2510, i64 %v718
  %v2512 = load double, ptr %v2511, align 8, !noalias !323
  %v2513 = fadd double %v2512, 0.000000e+00
  %v2514 = fmul double %v2493, %v2513
  %v2515 = getelementptr i8, ptr %v2510, i64 %v719
  %v2516 = load double, ptr %v2515, align 8, !noalias !323
  %v2517 = fadd double %v2516, %v2514
  %v2518 = fmul double %v2505, %v2517
  %v2519 = getelementptr i8, ptr %v2510, i64 %v720
  %v2520 = load double, ptr %v2519, align 8, !noalias !323
  %v2521 = fadd double %v2520, %v2518
  %v2522 = fmul double %v2493, %v2521
  %v2523 = getelementptr i8, ptr %v2510, i64 %v721
  %v2524 = load double, ptr %v2523, align 8, !noalias !323
  %v2525 = fadd double %v2524, %v2522
  %v2526 = fmul double %v2505, %v2525
  %v2527 = getelementptr i8, ptr %v2510, i64 %v722
  %v2528 = load double, ptr %v2527, align 8, !noalias !323
  %v2529 = fadd double %v2528, %v2526
  %v2530 = fmul double %v2493, %v2529
  %v2531 = getelementptr i8, ptr %v2510, i64 %v723
  %v2532 = load double, ptr %v2531, align 8, !noalias !323
  %v2533 = fadd double %v2532, %v2530
  %v2534 = fmul double %v2505, %v2533
  %v2535 = getelementptr i8, ptr %v2510, i64 %v724
  %v2536 = load double, ptr %v2535, align 8, !noalias !323
  %v2537 = fadd double %v2536, %v2534
  %v2538 = fmul double %v2493, %v2537
  %v2508 = add nsw i64 %v2507, 1
  %v2539 = load double, ptr %v2510, align 8, !noalias !323
  %v2540 = fadd double %v2539, %v2538
  %v2541 = getelementptr double, ptr %v771, i64 %v2509
  store double %v2540, ptr %v2541, align 8, !noalias !313
  %v2542 = icmp eq i64 %v10, %v2508
  br i1 %v2542, label %v2504, label %v2506

v2504:
  %v2543 = load i64, ptr %v717, align 8, !noalias !327
  %v2544 = inttoptr i64 %v2543 to ptr
  tail call void %v2544(ptr nonnull %v712, ptr %v749, ptr %v165, ptr %v172, ptr %v179, ptr %v751), !noalias !327
  br i1 %v754, label %v2545, label %v2546

v2545:
  %v2547 = phi i64 [ %v2548, %v2545 ], [ %v752, %v2504 ]
  %v2549 = phi i64 [ %v2550, %v2545 ], [ %v18, %v2504 ]
  %v2548 = add nsw i64 %v2547, -1
  %v2550 = add i64 %v2549, 1
  %v2551 = icmp slt i64 %v2549, 0
  %v2552 = select i1 %v2551, i64 %v207, i64 0
  %v2553 = add i64 %v2552, %v2549
  %v2554 = getelementptr double, ptr %v758, i64 %v2553
  %v2555 = load double, ptr %v2554, align 8, !noalias !330
  %v2556 = getelementptr double, ptr %v761, i64 %v2553
  store double %v2555, ptr %v2556, align 8, !noalias !330
  %v2557 = icmp sgt i64 %v2547, 1
  br i1 %v2557, label %v2545, label %v2546

v2546:
  br label %v2558

v2559:
  br label %v2560

v2560:
  %v2561 = phi double [ %v2493, %v2558 ], [ 1.000000e+00, %v2562 ], [ 8.889000e-01, %v2563 ], [ 2.500000e-01, %v2564 ], [ 3.333000e-01, %v2565 ], [ 5.000000e-01, %v2566 ], [ 0x3FE50A3D70A3D70A, %v2567 ], [ 7.500000e-01, %v2568 ], [ 0x3FB48E8A71DE69AD, %v2559 ]
  %v2569 = fcmp ult double %v2561, %v2493
  br i1 %v2569, label %v2570, label %v2571

v2571:
  %v2572 = load double, ptr %v133, align 8, !noalias !331
  %v2573 = load double, ptr %v710, align 8, !noalias !331
  %v2574 = fmul double %v2561, %v2573
  %v2575 = fadd double %v2572, %v2574
  store double %v2575, ptr %v712, align 8, !noalias !331
  br i1 %v714, label %v2576, label %v2577

v2576:
  %v2578 = fsub double 1.000000e+00, %v2561
  br label %v2579

v2579:
  %v2580 = phi i64 [ 0, %v2576 ], [ %v2581, %v2579 ]
  %v2582 = mul i64 %v2580, %v196
  %v2583 = getelementptr double, ptr %v193, i64 %v2582
  %v2584 = getelementptr i8, ptr %v2583, i64 %v718
  %v2585 = load double, ptr %v2584, align 8, !noalias !335
  %v2586 = fadd double %v2585, 0.000000e+00
  %v2587 = fmul double %v2561, %v2586
  %v2588 = getelementptr i8, ptr %v2583, i64 %v719
  %v2589 = load double, ptr %v2588, align 8, !noalias !335
  %v2590 = fadd double %v2589, %v2587
  %v2591 = fmul double %v2578, %v2590
  %v2592 = getelementptr i8, ptr %v2583, i64 %v720
  %v2593 = load double, ptr %v2592, align 8, !noalias !335
  %v2594 = fadd double %v2593, %v2591
  %v2595 = fmul double %v2561, %v2594
  %v2596 = getelementptr i8, ptr %v2583, i64 %v721
  %v2597 = load double, ptr %v2596, align 8, !noalias !335
  %v2598 = fadd double %v2597, %v2595
  %v2599 = fmul double %v2578, %v2598
  %v2600 = getelementptr i8, ptr %v2583, i64 %v722
  %v2601 = load double, ptr %v2600, align 8, !noalias !335
  %v2602 = fadd double %v2601, %v2599
  %v2603 = fmul double %v2561, %v2602
  %v2604 = getelementptr i8, ptr %v2583, i64 %v723
  %v2605 = load double, ptr %v2604, align 8, !noalias !335
  %v2606 = fadd double %v2605, %v2603
  %v2607 = fmul double %v2578, %v2606
  %v2608 = getelementptr i8, ptr %v2583, i64 %v724
  %v2609 = load double, ptr %v2608, align 8, !noalias !335
  %v2610 = fadd double %v2609, %v2607
  %v2611 = fmul double %v2561, %v2610
  %v2581 = add nsw i64 %v2580, 1
  %v2612 = load double, ptr %v2583, align 8, !noalias !335
  %v2613 = fadd double %v2612, %v2611
  %v2614 = getelementptr double, ptr %v715, i64 %v2582
  store double %v2613, ptr %v2614, align 8, !noalias !331
  %v2615 = icmp eq i64 %v10, %v2581
  br i1 %v2615, label %v2577, label %v2579

v2616:
  %v2617 = load i64, ptr %v777, align 8, !noalias !339
  %v2618 = inttoptr i64 %v2617 to ptr
  tail call void %v2618(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !339
  br label %v2570

v2619:
  %v2620 = phi i64 [ %v2621, %v2619 ], [ 0, %v2622 ]
  %v2621 = add nsw i64 %v2620, 1
  %v2623 = add nsw i64 %v2620, %v17
  %v2624 = icmp slt i64 %v2623, 0
  %v2625 = select i1 %v2624, i64 %v166, i64 0
  %v2626 = getelementptr double, ptr %v165, i64 %v2623
  %v2627 = getelementptr double, ptr %v2626, i64 %v2625
  %v2628 = load double, ptr %v2627, align 8, !noalias !345
  %v2629 = getelementptr double, ptr %v760, i64 %v2620
  %v2630 = load double, ptr %v2629, align 8, !noalias !345
  store double %v2630, ptr %v2627, align 8, !noalias !345
  store double %v2628, ptr %v2629, align 8, !noalias !345
  %v2631 = icmp eq i64 %v18, %v2621
  br i1 %v2631, label %v2616, label %v2619

v2570:
  %v2632 = icmp ugt i64 %v2633, 1
  br i1 %v2632, label %v2558, label %v2634

v2634:
  br i1 %v305, label %v2635, label %v2636

v2636:
  %v2637 = load i64, ptr %v777, align 8, !noalias !346
  %v2638 = inttoptr i64 %v2637 to ptr
  tail call void %v2638(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !346
  br label %v2639

v2635:
  %v2640 = phi i64 [ %v2641, %v2635 ], [ 0, %v2634 ]
  %v2641 = add nsw i64 %v2640, 1
  %v2642 = add nsw i64 %v2640, %v17
  %v2643 = icmp slt i64 %v2642, 0
  %v2644 = select i1 %v2643, i64 %v166, i64 0
  %v2645 = getelementptr double, ptr %v165, i64 %v2642
  %v2646 = getelementptr double, ptr %v2645, i64 %v2644
  %v2647 = load double, ptr %v2646, align 8, !noalias !352
  %v2648 = getelementptr double, ptr %v760, i64 %v2640
  %v2649 = load double, ptr %v2648, align 8, !noalias !352
  store double %v2649, ptr %v2646, align 8, !noalias !352
  store double %v2647, ptr %v2648, align 8, !noalias !352
  %v2650 = icmp eq i64 %v2641, %v18
  br i1 %v2650, label %v2636, label %v2635

v2558:
  %v2633 = phi i64 [ %v2651, %v2570 ], [ 9, %v2546 ]
  %v2652 = phi i64 [ %v2653, %v2570 ], [ 8, %v2546 ]
  %v2651 = add nsw i64 %v2633, -1
  %v2653 = add nsw i64 %v2652, -1
  switch i64 %v2652, label %v2639 [
    i64 0, label %v2560
    i64 -1, label %v2562
    i64 8, label %v2562
    i64 1, label %v2559
    i64 -8, label %v2559
    i64 2, label %v2564
    i64 -7, label %v2564
    i64 3, label %v2565
    i64 -6, label %v2565
    i64 4, label %v2566
    i64 -5, label %v2566
    i64 5, label %v2567
    i64 -4, label %v2567
    i64 6, label %v2568
    i64 -3, label %v2568
    i64 7, label %v2563
    i64 -2, label %v2563
  ]

v2564:
  br label %v2560

v2565:
  br label %v2560

v2566:
  br label %v2560

v2567:
  br label %v2560

v2568:
  br label %v2560

v2563:
  br label %v2560

v2562:
  br label %v2560

v2577:
  %v2654 = load i64, ptr %v6, align 8, !noalias !353
  %v2655 = inttoptr i64 %v2654 to ptr
  tail call void %v2655(ptr nonnull %v712, ptr %v774, ptr %v165, ptr %v172, ptr %v179, ptr %v776), !noalias !353
  br i1 %v305, label %v2656, label %v2657

v2657:
  %v2658 = load i64, ptr %v777, align 8, !noalias !356
  %v2659 = inttoptr i64 %v2658 to ptr
  tail call void %v2659(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !356
  %v2660 = load i64, ptr %v6, align 8, !noalias !362
  %v2661 = inttoptr i64 %v2660 to ptr
  tail call void %v2661(ptr nonnull %v712, ptr %v774, ptr %v165, ptr %v172, ptr %v179, ptr %v779), !noalias !362
  %v2662 = load double, ptr %v23, align 8, !noalias !365
  %v2663 = load double, ptr %v780, align 8, !noalias !365
  br label %v2664

v2656:
  %v2665 = phi i64 [ %v2666, %v2656 ], [ 0, %v2577 ]
  %v2666 = add nsw i64 %v2665, 1
  %v2667 = add nsw i64 %v2665, %v17
  %v2668 = icmp slt i64 %v2667, 0
  %v2669 = select i1 %v2668, i64 %v166, i64 0
  %v2670 = getelementptr double, ptr %v165, i64 %v2667
  %v2671 = getelementptr double, ptr %v2670, i64 %v2669
  %v2672 = load double, ptr %v2671, align 8, !noalias !369
  %v2673 = getelementptr double, ptr %v760, i64 %v2665
  %v2674 = load double, ptr %v2673, align 8, !noalias !369
  store double %v2674, ptr %v2671, align 8, !noalias !369
  store double %v2672, ptr %v2673, align 8, !noalias !369
  %v2675 = icmp eq i64 %v18, %v2666
  br i1 %v2675, label %v2657, label %v2656

v2664:
  %v2676 = phi i64 [ 0, %v2657 ], [ %v2677, %v2678 ]
  %v2679 = icmp eq i64 %v2676, %v769
  br i1 %v2679, label %v2622, label %v2678

v2622:
  br i1 %v305, label %v2619, label %v2616

v2678:
  %v2677 = add i64 %v2676, 1
  %v2680 = mul i64 %v2676, %v196
  %v2681 = getelementptr double, ptr %v782, i64 %v2680
  %v2682 = load double, ptr %v2681, align 8, !noalias !365
  %v2683 = getelementptr double, ptr %v784, i64 %v2680
  %v2684 = load double, ptr %v2683, align 8, !noalias !365
  %v2685 = fsub double %v2682, %v2684
  %v2686 = tail call double @llvm.fabs.f64(double %v2685)
  %v2687 = getelementptr double, ptr %v193, i64 %v2680
  %v2688 = load double, ptr %v2687, align 8, !noalias !365
  %v2689 = tail call double @llvm.fabs.f64(double %v2688)
  %v2690 = fmul double %v2662, %v2689
  %v2691 = fadd double %v2663, %v2690
  %v2692 = load double, ptr %v710, align 8, !noalias !365
  %v2693 = fmul double %v2692, %v2686
  %v2694 = fmul double %v2691, 1.000000e-01
  %v2695 = fcmp ugt double %v2693, %v2694
  br i1 %v2695, label %v2639, label %v2664

v2639:
  %v2696 = phi i1 [ false, %v2678 ], [ true, %v2636 ], [ true, %v2558 ]
  %v2496 = phi ptr [ %v2495, %v2678 ], [ %v2495, %v2636 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.48, %v2558 ]
  %v2697 = phi i1 [ true, %v2678 ], [ true, %v2636 ], [ false, %v2558 ]
  %v2698 = phi i32 [ 0, %v2678 ], [ 0, %v2636 ], [ 1, %v2558 ]
  br i1 %v2697, label %v2253, label %v2315, !prof !120

v2253:
  br i1 %v2696, label %v2249, label %v2320

v2314:
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %v300, i8 0, i64 32, i1 false), !noalias !264
  %v2699 = call fastcc i32 @_ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr %v300, ptr %v301, i64 %v14, ptr nonnull readonly %v92, i64 %v93, ptr %v124, i64 %v125, i64 %v126, ptr nonnull %v133, i64 %v135, ptr %v142, i64 %v144, ptr %v204, i64 %v205, i64 %v206, i64 %v207, double %v2493)
  %v2700 = icmp eq i32 %v2699, 0
  br i1 %v2700, label %v2701, label %v2702, !prof !120

v2702:
  %v2703 = load ptr, ptr %v301, align 8, !noalias !264
  br label %v2324

v2701:
  %v2704 = load i64, ptr %v740, align 8, !noalias !264
  %v2705 = icmp slt i64 %v2704, 0
  br i1 %v2705, label %v2316, label %v2390

v2390:
  %v2393 = load double, ptr %v300, align 8, !noalias !264
  %v2392 = load double, ptr %v764, align 8, !noalias !264
  %v2391 = load double, ptr %v765, align 8, !noalias !264
  %v2389 = load double, ptr %v766, align 8, !noalias !264
  br label %v2388

v2387:
  %v2494 = phi double [ %v2384, %v2377 ], [ %v2350, %v2388 ]
  %v2706 = icmp ugt i64 %v2497, 1
  br i1 %v2706, label %v2492, label %v2320

v2315:
  %v2707 = phi ptr [ %v2311, %v2256 ], [ %v2496, %v2639 ]
  %v2708 = phi i32 [ %v2313, %v2256 ], [ %v2698, %v2639 ]
  %v2709 = icmp ne i32 %v2708, 0
  br label %v2324

v2324:
  %v2710 = phi i1 [ true, %v2319 ], [ false, %v2467 ], [ true, %v2702 ], [ %v2709, %v2315 ]
  %v2711 = phi ptr [ null, %v2319 ], [ null, %v2467 ], [ %v2703, %v2702 ], [ %v2707, %v2315 ]
  %v2712 = phi i1 [ false, %v2319 ], [ false, %v2467 ], [ true, %v2702 ], [ %v2709, %v2315 ]
  call void @llvm.lifetime.end.p0(ptr nonnull %v300), !noalias !143
  call void @llvm.lifetime.end.p0(ptr nonnull %v301), !noalias !143
  %v2713 = select i1 %v2712, ptr %v2711, ptr null, !prof !370
  %v2714 = xor i1 %v2712, true
  br i1 %v2710, label %v1699, label %v2715, !prof !371

v2715:
  %v2716 = load double, ptr %v795, align 8, !noalias !143
  %v2717 = fcmp olt double %v2716, 5.000000e-01
  br i1 %v2717, label %v1699, label %v2234

v2234:
  store double 1.000000e+00, ptr %v814, align 8, !noalias !143
  %v2718 = load double, ptr %v742, align 8, !noalias !372
  %v2719 = load double, ptr %v92, align 8, !noalias !372
  %v2720 = fsub double %v2718, %v2719
  %v2721 = fmul double %v2720, 1.000000e-13
  %v2722 = load double, ptr %v133, align 8, !noalias !372
  %v2723 = tail call double @llvm.fabs.f64(double %v2722)
  %v2724 = fmul double %v2723, 4.000000e-15
  %v2725 = fcmp ogt double %v2724, %v2721
  %v2726 = select i1 %v2725, double %v2724, double %v2721
  %v2727 = fdiv double %v2726, %v1701
  %v2728 = fcmp ogt double %v2727, %v1851
  %v2729 = select i1 %v2728, double %v2727, double %v1851
  %v2730 = fcmp ult double %v2729, 1.000000e+00
  br i1 %v2730, label %v2731, label %v1699

v2731:
  %v2732 = fsub double 1.000000e+00, %v2729
  br i1 %v677, label %v2733, label %v2734

v2733:
  %v2735 = load double, ptr %v816, align 8, !noalias !143
  %v2736 = fmul double %v2729, 4.000000e+00
  %v2737 = fmul double %v2736, %v2732
  %v2738 = fmul double %v2737, %v2735
  %v2739 = fmul double %v2737, %v2738
  %v2740 = fcmp olt double %v2739, 5.000000e-04
  br i1 %v2740, label %v2741, label %v2734

v2741:
  %v2742 = load double, ptr %v710, align 8, !noalias !376
  %v2743 = fmul double %v2729, %v2742
  %v2744 = fadd double %v2722, %v2743
  store double %v2744, ptr %v712, align 8, !noalias !376
  br i1 %v822, label %v2745, label %v2746

v2746:
  %v2747 = phi i64 [ %v2748, %v2746 ], [ 0, %v2741 ]
  %v2749 = mul i64 %v2747, %v196
  %v2750 = getelementptr double, ptr %v193, i64 %v2749
  %v2751 = getelementptr i8, ptr %v2750, i64 %v718
  %v2752 = load double, ptr %v2751, align 8, !noalias !383
  %v2753 = fadd double %v2752, 0.000000e+00
  %v2754 = fmul double %v2729, %v2753
  %v2755 = getelementptr i8, ptr %v2750, i64 %v719
  %v2756 = load double, ptr %v2755, align 8, !noalias !383
  %v2757 = fadd double %v2756, %v2754
  %v2758 = fmul double %v2732, %v2757
  %v2759 = getelementptr i8, ptr %v2750, i64 %v720
  %v2760 = load double, ptr %v2759, align 8, !noalias !383
  %v2761 = fadd double %v2760, %v2758
  %v2762 = fmul double %v2729, %v2761
  %v2763 = getelementptr i8, ptr %v2750, i64 %v721
  %v2764 = load double, ptr %v2763, align 8, !noalias !383
  %v2765 = fadd double %v2764, %v2762
  %v2766 = fmul double %v2732, %v2765
  %v2767 = getelementptr i8, ptr %v2750, i64 %v722
  %v2768 = load double, ptr %v2767, align 8, !noalias !383
  %v2769 = fadd double %v2768, %v2766
  %v2770 = fmul double %v2729, %v2769
  %v2771 = getelementptr i8, ptr %v2750, i64 %v723
  %v2772 = load double, ptr %v2771, align 8, !noalias !383
  %v2773 = fadd double %v2772, %v2770
  %v2774 = fmul double %v2732, %v2773
  %v2775 = getelementptr i8, ptr %v2750, i64 %v724
  %v2776 = load double, ptr %v2775, align 8, !noalias !383
  %v2777 = fadd double %v2776, %v2774
  %v2778 = fmul double %v2729, %v2777
  %v2748 = add nsw i64 %v2747, 1
  %v2779 = load double, ptr %v2750, align 8, !noalias !383
  %v2780 = fadd double %v2779, %v2778
  %v2781 = getelementptr double, ptr %v715, i64 %v2749
  store double %v2780, ptr %v2781, align 8, !noalias !376
  %v2782 = icmp eq i64 %v10, %v2748
  br i1 %v2782, label %v2783, label %v2746

v2745:
  %v2784 = load double, ptr %v712, align 8, !noalias !387
  store double %v2784, ptr %v744, align 8, !noalias !387
  br label %v2785

v2785:
  %v2786 = load i64, ptr %v6, align 8, !noalias !388
  %v2787 = inttoptr i64 %v2786 to ptr
  tail call void %v2787(ptr nonnull %v712, ptr %v827, ptr %v165, ptr %v172, ptr %v179, ptr %v829), !noalias !388
  %v2788 = load i64, ptr %v717, align 8, !noalias !391
  %v2789 = inttoptr i64 %v2788 to ptr
  tail call void %v2789(ptr nonnull %v712, ptr %v831, ptr %v165, ptr %v172, ptr %v179, ptr %v833), !noalias !391
  br label %v1699

v2783:
  %v2790 = load double, ptr %v712, align 8, !noalias !387
  store double %v2790, ptr %v744, align 8, !noalias !387
  br label %v2791

v2791:
  %v2792 = phi i64 [ 0, %v2783 ], [ %v2793, %v2791 ]
  %v2793 = add nsw i64 %v2792, 1
  %v2794 = mul i64 %v2792, %v196
  %v2795 = getelementptr double, ptr %v715, i64 %v2794
  %v2796 = load double, ptr %v2795, align 8, !noalias !387
  %v2797 = getelementptr double, ptr %v824, i64 %v2794
  store double %v2796, ptr %v2797, align 8, !noalias !387
  %v2798 = icmp eq i64 %v10, %v2793
  br i1 %v2798, label %v2785, label %v2791

v2734:
  %v2799 = fmul double %v2726, 2.000000e+00
  %v2800 = fcmp ogt double %v1701, %v2799
  br i1 %v2800, label %v2801, label %v1699

v2801:
  %v2802 = load double, ptr %v744, align 8, !noalias !143
  %v2803 = tail call double @llvm.fabs.f64(double %v2802)
  %v2804 = fmul double %v2803, 4.000000e-15
  %v2805 = fmul double %v1701, 0x3D719799812DEA11
  %v2806 = fcmp ogt double %v2804, %v2805
  %v2807 = select i1 %v2806, double %v2804, double %v2805
  %v2808 = fsub double 1.000000e+00, %v2809
  %v2810 = fmul double %v1701, %v2808
  %v2811 = fcmp ogt double %v2810, %v2807
  br i1 %v2811, label %v2812, label %v1699

v2812:
  %v2813 = fmul double %v1701, %v2729
  store double 0.000000e+00, ptr %v818, align 8, !noalias !394
  store double 0.000000e+00, ptr %v820, align 8, !noalias !394
  store double %v2813, ptr %v821, align 8, !noalias !394
  %v2814 = load i64, ptr %v142, align 8, !noalias !394
  %v2815 = icmp slt i64 %v2814, 0
  %v2816 = select i1 %v2815, i64 %v125, i64 0
  %v2817 = add i64 %v2816, %v2814
  %v2818 = mul i64 %v2817, %v126
  %v2819 = getelementptr i64, ptr %v124, i64 %v2818
  %v2820 = load i64, ptr %v2819, align 8, !noalias !394
  %v2821 = add nsw i64 %v2820, -1
  store i64 %v2821, ptr %v2819, align 8, !noalias !394
  %v2822 = load i64, ptr %v142, align 8, !noalias !394
  %v2823 = icmp slt i64 %v2822, 0
  %v2824 = select i1 %v2823, i64 %v125, i64 0
  %v2825 = add i64 %v2824, %v2822
  %v2826 = mul i64 %v2825, %v126
  %v2827 = getelementptr i64, ptr %v124, i64 %v2826
  %v2828 = getelementptr i8, ptr %v2827, i64 24
  %v2829 = load i64, ptr %v2828, align 8, !noalias !394
  %v2830 = add nsw i64 %v2829, 1
  store i64 %v2830, ptr %v2828, align 8, !noalias !394
  br label %v1699

v1698:
  %v2831 = load i64, ptr %v740, align 8, !noalias !143
  %v2832 = icmp slt i64 %v2831, 0
  br i1 %v2832, label %v1699, label %v1700

v1773:
  %v2809 = phi double [ %v1764, %v1763 ], [ %v1737, %v1710 ]
  %v1851 = phi double [ %v1770, %v1763 ], [ %v1736, %v1710 ]
  br i1 %v304, label %v1847, label %v2245

v1699:
  %v2833 = phi ptr [ null, %v2801 ], [ null, %v2785 ], [ null, %v2812 ], [ null, %v2734 ], [ null, %v2234 ], [ null, %v2715 ], [ null, %v2179 ], [ null, %v1698 ], [ %v1695, %v1602 ], [ %v2713, %v2324 ]
  %v2834 = phi i1 [ true, %v2801 ], [ true, %v2785 ], [ true, %v2812 ], [ true, %v2734 ], [ true, %v2234 ], [ true, %v2715 ], [ true, %v2179 ], [ true, %v1698 ], [ false, %v1602 ], [ %v2714, %v2324 ]
  br i1 %v2834, label %v1537, label %v1450, !prof !120

v1537:
  %v2835 = select i1 %v1357, i1 true, i1 %v640
  %v2836 = select i1 %v2835, i64 0, i64 %v12
  br label %v1450

v2837:
  %v2838 = phi i64 [ 0, %v1443 ], [ %v2839, %v2840 ]
  %v2841 = phi i64 [ %v669, %v1443 ], [ %v2842, %v2840 ]
  %v2843 = icmp sgt i64 %v2841, 0
  br i1 %v2843, label %v2840, label %v1444

v1443:
  %v2844 = load double, ptr %v668, align 8, !noalias !397
  store double %v2844, ptr %v654, align 8, !noalias !397
  br label %v2837

v2840:
  %v2842 = add nsw i64 %v2841, -1
  %v2839 = add i64 %v2838, 1
  %v2845 = getelementptr double, ptr %v671, i64 %v2838
  %v2846 = icmp slt i64 %v2838, 0
  %v2847 = select i1 %v2846, i64 %v207, i64 0
  %v2848 = getelementptr double, ptr %v2845, i64 %v2847
  %v2849 = load double, ptr %v2848, align 8, !noalias !397
  %v2850 = fcmp olt double %v2849, 0x7FF0000000000000
  %v2851 = select i1 %v2850, double %v2849, double 0x7FF0000000000000
  %v2852 = fcmp ogt double %v2849, 0xFFF0000000000000
  %v2853 = select i1 %v2852, double %v2849, double 0xFFF0000000000000
  %v2854 = getelementptr double, ptr %v2848, i64 %v670
  %v2855 = load double, ptr %v2854, align 8, !noalias !397
  %v2856 = fcmp olt double %v2855, %v2851
  %v2857 = select i1 %v2856, double %v2855, double %v2851
  %v2858 = fcmp ogt double %v2855, %v2853
  %v2859 = select i1 %v2858, double %v2855, double %v2853
  %v2860 = getelementptr i8, ptr %v2848, i64 %v1004
  %v2861 = load double, ptr %v2860, align 8, !noalias !397
  %v2862 = fcmp olt double %v2861, %v2857
  %v2863 = select i1 %v2862, double %v2861, double %v2857
  %v2864 = fcmp ogt double %v2861, %v2859
  %v2865 = select i1 %v2864, double %v2861, double %v2859
  %v2866 = getelementptr i8, ptr %v2848, i64 %v1005
  %v2867 = load double, ptr %v2866, align 8, !noalias !397
  %v2868 = fcmp olt double %v2867, %v2863
  %v2869 = select i1 %v2868, double %v2867, double %v2863
  %v2870 = fcmp ogt double %v2867, %v2865
  %v2871 = select i1 %v2870, double %v2867, double %v2865
  %v2872 = getelementptr i8, ptr %v2848, i64 %v1006
  %v2873 = load double, ptr %v2872, align 8, !noalias !397
  %v2874 = fcmp olt double %v2873, %v2869
  %v2875 = select i1 %v2874, double %v2873, double %v2869
  %v2876 = fcmp ogt double %v2873, %v2871
  %v2877 = select i1 %v2876, double %v2873, double %v2871
  %v2878 = getelementptr i8, ptr %v2848, i64 %v1007
  %v2879 = load double, ptr %v2878, align 8, !noalias !397
  %v2880 = fcmp olt double %v2879, %v2875
  %v2881 = select i1 %v2880, double %v2879, double %v2875
  %v2882 = fcmp ogt double %v2879, %v2877
  %v2883 = select i1 %v2882, double %v2879, double %v2877
  %v2884 = getelementptr i8, ptr %v2848, i64 %v1008
  %v2885 = load double, ptr %v2884, align 8, !noalias !397
  %v2886 = fcmp olt double %v2885, %v2881
  %v2887 = select i1 %v2886, double %v2885, double %v2881
  %v2888 = fcmp ogt double %v2885, %v2883
  %v2889 = select i1 %v2888, double %v2885, double %v2883
  %v2890 = getelementptr i8, ptr %v2848, i64 %v1009
  %v2891 = load double, ptr %v2890, align 8, !noalias !397
  %v2892 = fcmp olt double %v2891, %v2887
  %v2893 = select i1 %v2892, double %v2891, double %v2887
  %v2894 = fcmp ogt double %v2891, %v2889
  %v2895 = select i1 %v2894, double %v2891, double %v2889
  %v2896 = getelementptr i8, ptr %v2848, i64 %v1010
  %v2897 = load double, ptr %v2896, align 8, !noalias !397
  %v2898 = fcmp olt double %v2897, %v2893
  %v2899 = select i1 %v2898, double %v2897, double %v2893
  %v2900 = fcmp ogt double %v2897, %v2895
  %v2901 = select i1 %v2900, double %v2897, double %v2895
  %v2902 = fsub double %v2901, %v2899
  %v2903 = fmul double %v2902, 2.500000e-01
  %v2904 = icmp slt i64 %v2838, 0
  %v2905 = select i1 %v2904, i64 %v207, i64 0
  %v2906 = add i64 %v2905, %v2838
  %v2907 = getelementptr double, ptr %v673, i64 %v2906
  %v2908 = getelementptr double, ptr %v674, i64 %v2906
  %v2909 = getelementptr double, ptr %v2907, i64 %v672
  %v2910 = load double, ptr %v2909, align 8, !noalias !398
  %v2911 = load double, ptr %v2908, align 8, !noalias !398
  %v2912 = fmul double %v2911, 0x3FDDF27AAAADCB3A
  %v2913 = fsub double %v2910, %v2912
  %v2914 = getelementptr i8, ptr %v2908, i64 %v1011
  %v2915 = load double, ptr %v2914, align 8, !noalias !398
  %v2916 = fmul double %v2915, 0x3FEC575F1EBC4F2F
  %v2917 = fsub double %v2913, %v2916
  %v2918 = getelementptr i8, ptr %v2908, i64 %v1012
  %v2919 = load double, ptr %v2918, align 8, !noalias !398
  %v2920 = fmul double %v2919, 0xBFE1306AA3D795F4
  %v2921 = fsub double %v2917, %v2920
  %v2922 = getelementptr i8, ptr %v2908, i64 %v1013
  %v2923 = load double, ptr %v2922, align 8, !noalias !398
  %v2924 = fmul double %v2923, 0x3FCCB9F574BDCC3A
  %v2925 = fsub double %v2921, %v2924
  %v2926 = getelementptr i8, ptr %v2908, i64 %v1014
  %v2927 = load double, ptr %v2926, align 8, !noalias !398
  %v2928 = fmul double %v2927, 0xBFA4EAF2D6B11E79
  %v2929 = fsub double %v2925, %v2928
  %v2930 = tail call double @llvm.fabs.f64(double %v2929)
  %v2931 = fcmp ogt double %v2930, 0.000000e+00
  %v2932 = select i1 %v2931, double %v2930, double 0.000000e+00
  %v2933 = getelementptr i8, ptr %v2907, i64 %v1015
  %v2934 = load double, ptr %v2933, align 8, !noalias !398
  %v2935 = load double, ptr %v2908, align 8, !noalias !398
  %v2936 = fmul double %v2935, 0xBFA5118805F8B876
  %v2937 = fsub double %v2934, %v2936
  %v2938 = getelementptr i8, ptr %v2908, i64 %v1016
  %v2939 = load double, ptr %v2938, align 8, !noalias !398
  %v2940 = fmul double %v2939, 0x3FE51326698BC5BD
  %v2941 = fsub double %v2937, %v2940
  %v2942 = getelementptr i8, ptr %v2908, i64 %v1017
  %v2943 = load double, ptr %v2942, align 8, !noalias !398
  %v2944 = fmul double %v2943, 0x3FDF97DED30D4572
  %v2945 = fsub double %v2941, %v2944
  %v2946 = getelementptr i8, ptr %v2908, i64 %v1018
  %v2947 = load double, ptr %v2946, align 8, !noalias !398
  %v2948 = fmul double %v2947, 0xBFC0DA0C684D1D67
  %v2949 = fsub double %v2945, %v2948
  %v2950 = getelementptr i8, ptr %v2908, i64 %v1019
  %v2951 = load double, ptr %v2950, align 8, !noalias !398
  %v2952 = fmul double %v2951, 0x3F9510B8EC0D4D92
  %v2953 = fsub double %v2949, %v2952
  %v2954 = tail call double @llvm.fabs.f64(double %v2953)
  %v2955 = fcmp ogt double %v2954, %v2932
  %v2956 = select i1 %v2955, double %v2954, double %v2932
  %v2957 = getelementptr i8, ptr %v2907, i64 %v1020
  %v2958 = load double, ptr %v2957, align 8, !noalias !398
  %v2959 = load double, ptr %v2908, align 8, !noalias !398
  %v2960 = fmul double %v2959, 0x3F9635A30F8F142F
  %v2961 = fsub double %v2958, %v2960
  %v2962 = getelementptr i8, ptr %v2908, i64 %v1021
  %v2963 = load double, ptr %v2962, align 8, !noalias !398
  %v2964 = fmul double %v2963, 0xBFC1EAE0FF33D241
  %v2965 = fsub double %v2961, %v2964
  %v2966 = getelementptr i8, ptr %v2908, i64 %v1022
  %v2967 = load double, ptr %v2966, align 8, !noalias !398
  %v2968 = fmul double %v2967, 0x3FE1625D59218460
  %v2969 = fsub double %v2965, %v2968
  %v2970 = getelementptr i8, ptr %v2908, i64 %v1023
  %v2971 = load double, ptr %v2970, align 8, !noalias !398
  %v2972 = fmul double %v2971, 0x3FE3BBC3E8A29641
  %v2973 = fsub double %v2969, %v2972
  %v2974 = getelementptr i8, ptr %v2908, i64 %v1024
  %v2975 = load double, ptr %v2974, align 8, !noalias !398
  %v2976 = fmul double %v2975, 0xBFA55161A739EB34
  %v2977 = fsub double %v2973, %v2976
  %v2978 = tail call double @llvm.fabs.f64(double %v2977)
  %v2979 = fcmp ogt double %v2978, %v2956
  %v2980 = select i1 %v2979, double %v2978, double %v2956
  %v2981 = getelementptr i8, ptr %v2907, i64 %v1025
  %v2982 = load double, ptr %v2981, align 8, !noalias !398
  %v2983 = load double, ptr %v2908, align 8, !noalias !398
  %v2984 = fmul double %v2983, 0xBFA4F0C0BB579409
  %v2985 = fsub double %v2982, %v2984
  %v2986 = getelementptr i8, ptr %v2908, i64 %v1026
  %v2987 = load double, ptr %v2986, align 8, !noalias !398
  %v2988 = fmul double %v2987, 0x3FCD2266FBC0D976
  %v2989 = fsub double %v2985, %v2988
  %v2990 = getelementptr i8, ptr %v2908, i64 %v1027
  %v2991 = load double, ptr %v2990, align 8, !noalias !398
  %v2992 = fmul double %v2991, 0xBFE1F2DB6FEE3151
  %v2993 = fsub double %v2989, %v2992
  %v2994 = getelementptr i8, ptr %v2908, i64 %v1028
  %v2995 = load double, ptr %v2994, align 8, !noalias !398
  %v2996 = fmul double %v2995, 0x3FF0C05015964CBE
  %v2997 = fsub double %v2993, %v2996
  %v2998 = getelementptr i8, ptr %v2908, i64 %v1029
  %v2999 = load double, ptr %v2998, align 8, !noalias !398
  %v3000 = fmul double %v2999, 0x3FD4F15B230DB570
  %v3001 = fsub double %v2997, %v3000
  %v3002 = tail call double @llvm.fabs.f64(double %v3001)
  %v3003 = fcmp ogt double %v3002, %v2980
  %v3004 = select i1 %v3003, double %v3002, double %v2980
  %v3005 = fmul double %v3004, 1.000000e+01
  %v3006 = fadd double %v2903, %v3005
  %v3007 = icmp slt i64 %v2838, 0
  %v3008 = select i1 %v3007, i64 %v207, i64 0
  %v3009 = getelementptr double, ptr %v676, i64 %v2838
  %v3010 = getelementptr double, ptr %v3009, i64 %v3008
  %v3011 = load double, ptr %v3010, align 8, !noalias !397
  %v3012 = fcmp ogt double %v3006, %v3011
  %v3013 = fneg double %v3011
  %v3014 = select i1 %v3012, double %v3006, double %v3013
  %v3015 = fcmp olt double %v2899, %v3014
  br i1 %v3015, label %v1444, label %v2837

v1444:
  %v1446 = phi i1 [ false, %v1386 ], [ %v2843, %v2840 ], [ %v2843, %v2837 ]
  %v3016 = phi ptr [ %v1441, %v1386 ], [ null, %v2840 ], [ null, %v2837 ]
  %v3017 = phi i32 [ %v1442, %v1386 ], [ 0, %v2840 ], [ 0, %v2837 ]
  %v3018 = icmp eq i32 %v3017, 0
  br i1 %v3018, label %v1376, label %v1450, !prof !120

v1450:
  %v3019 = phi i64 [ 0, %v1376 ], [ %v2836, %v1537 ], [ 0, %v1444 ], [ 0, %v1699 ]
  %v3020 = phi i1 [ true, %v1376 ], [ true, %v1537 ], [ false, %v1444 ], [ false, %v1699 ]
  %v3021 = phi ptr [ undef, %v1376 ], [ undef, %v1537 ], [ %v3016, %v1444 ], [ %v2833, %v1699 ]
  %v3022 = phi i32 [ 0, %v1376 ], [ 0, %v1537 ], [ 1, %v1444 ], [ 1, %v1699 ]
  br i1 %v3020, label %v3023, label %v3024, !prof !120

v3025:
  %v3026 = getelementptr double, ptr %v836, i64 %v3027
  %v3028 = load double, ptr %v3026, align 8, !noalias !402
  %v3029 = fcmp olt double %v3028, 5.000000e-01
  br i1 %v3029, label %v3030, label %v3031

v3031:
  %v3032 = getelementptr i64, ptr %v110, i64 %v3033
  %v3034 = load i64, ptr %v3032, align 8, !noalias !402
  %v3035 = icmp eq i64 %v3034, 0
  br i1 %v3035, label %v3036, label %v3030

v3036:
  %v3037 = mul i64 %v3033, %v126
  %v3038 = getelementptr i64, ptr %v124, i64 %v3037
  %v3039 = getelementptr i8, ptr %v3038, i64 8
  %v3040 = load i64, ptr %v3039, align 8, !noalias !402
  %v3041 = add nsw i64 %v3040, %v3019
  store i64 %v3041, ptr %v3039, align 8, !noalias !402
  %v3042 = getelementptr double, ptr %v838, i64 %v3027
  %v3043 = load double, ptr %v3042, align 8, !noalias !402
  %v3044 = load i64, ptr %v3045, align 8, !noalias !405
  %v3046 = getelementptr i64, ptr %v840, i64 %v3027
  %v3047 = load i64, ptr %v3046, align 8, !noalias !405
  %v3048 = icmp slt i64 %v3047, %v93
  br i1 %v3048, label %v3049, label %v3050

v3049:
  %v3051 = icmp slt i64 %v3047, 0
  %v3052 = select i1 %v3051, i64 %v93, i64 0
  %v3053 = getelementptr double, ptr %v92, i64 %v3047
  %v3054 = getelementptr double, ptr %v3053, i64 %v3052
  %v3055 = load double, ptr %v3054, align 8, !noalias !405
  %v3056 = fcmp ugt double %v3055, %v3043
  br i1 %v3056, label %v3050, label %v3057

v3057:
  %v3058 = getelementptr double, ptr %v133, i64 %v3027
  %v3059 = getelementptr double, ptr %v842, i64 %v3027
  %v3060 = getelementptr double, ptr %v193, i64 %v3027
  %v3061 = getelementptr double, ptr %v846, i64 %v3027
  %v3062 = icmp slt i64 %v3044, 0
  %v3063 = select i1 %v3062, i64 %v100, i64 0
  %v3064 = add i64 %v3063, %v3044
  %v3065 = mul i64 %v847, %v3064
  %v3066 = getelementptr double, ptr %v99, i64 %v3065
  %v3067 = getelementptr double, ptr %v848, i64 %v3027
  br label %v3068

v3068:
  %v3069 = phi i64 [ %v3070, %v3071 ], [ %v3047, %v3057 ]
  %v3072 = icmp slt i64 %v3069, 0
  %v3073 = select i1 %v3072, i64 %v93, i64 0
  %v3074 = getelementptr double, ptr %v92, i64 %v3069
  %v3075 = getelementptr double, ptr %v3074, i64 %v3073
  %v3076 = load double, ptr %v3075, align 8, !noalias !405
  %v3077 = load double, ptr %v3058, align 8, !noalias !405
  %v3078 = fsub double %v3076, %v3077
  %v3079 = load double, ptr %v3059, align 8, !noalias !405
  %v3080 = fdiv double %v3078, %v3079
  br i1 %v844, label %v3081, label %v3082

v3082:
  %v3083 = fsub double 1.000000e+00, %v3080
  %v3084 = select i1 %v3072, i64 %v101, i64 0
  %v3085 = add i64 %v3084, %v3069
  %v3086 = mul i64 %v3085, %v102
  %v3087 = getelementptr double, ptr %v3066, i64 %v3086
  br label %v3088

v3089:
  %v3090 = getelementptr double, ptr %v3067, i64 %v3091
  %v3092 = load double, ptr %v3090, align 8, !noalias !405
  br label %v3093

v3081:
  store double 0x7FF0000000000000, ptr %v3061, align 8, !noalias !405
  %v3094 = icmp eq i64 %v3069, %v849
  br i1 %v3094, label %v3050, label %v3071

v3071:
  %v3070 = add i64 %v3069, 1
  %v3095 = icmp slt i64 %v3069, -1
  %v3096 = select i1 %v3095, i64 %v93, i64 0
  %v3097 = getelementptr double, ptr %v92, i64 %v3070
  %v3098 = getelementptr double, ptr %v3097, i64 %v3096
  %v3099 = load double, ptr %v3098, align 8, !noalias !405
  %v3100 = fcmp ugt double %v3099, %v3043
  br i1 %v3100, label %v3050, label %v3068

v3050:
  %v3101 = phi i64 [ %v3047, %v3049 ], [ %v3047, %v3036 ], [ %v93, %v3081 ], [ %v3070, %v3071 ]
  store i64 %v3101, ptr %v3046, align 8, !noalias !405
  br label %v3030

v3093:
  %v3102 = phi double [ %v3103, %v3104 ], [ %v3092, %v3089 ]
  %v3105 = getelementptr double, ptr %v3087, i64 %v3106
  store double %v3102, ptr %v3105, align 8, !noalias !405
  %v3107 = icmp eq i64 %v10, %v3108
  br i1 %v3107, label %v3081, label %v3088

v3088:
  %v3106 = phi i64 [ 0, %v3082 ], [ %v3108, %v3093 ]
  %v3108 = add nsw i64 %v3106, 1
  %v3109 = load double, ptr %v3075, align 8, !noalias !405
  %v3110 = load double, ptr %v3042, align 8, !noalias !405
  %v3111 = fcmp oeq double %v3109, %v3110
  %v3091 = mul i64 %v3106, %v196
  br i1 %v3111, label %v3089, label %v3104

v3104:
  %v3112 = getelementptr double, ptr %v3060, i64 %v3091
  %v3113 = getelementptr i8, ptr %v3112, i64 %v850
  %v3114 = load double, ptr %v3113, align 8, !noalias !409
  %v3115 = fadd double %v3114, 0.000000e+00
  %v3116 = fmul double %v3080, %v3115
  %v3117 = getelementptr i8, ptr %v3112, i64 %v851
  %v3118 = load double, ptr %v3117, align 8, !noalias !409
  %v3119 = fadd double %v3118, %v3116
  %v3120 = fmul double %v3083, %v3119
  %v3121 = getelementptr i8, ptr %v3112, i64 %v852
  %v3122 = load double, ptr %v3121, align 8, !noalias !409
  %v3123 = fadd double %v3122, %v3120
  %v3124 = fmul double %v3080, %v3123
  %v3125 = getelementptr i8, ptr %v3112, i64 %v853
  %v3126 = load double, ptr %v3125, align 8, !noalias !409
  %v3127 = fadd double %v3126, %v3124
  %v3128 = fmul double %v3083, %v3127
  %v3129 = getelementptr i8, ptr %v3112, i64 %v854
  %v3130 = load double, ptr %v3129, align 8, !noalias !409
  %v3131 = fadd double %v3130, %v3128
  %v3132 = fmul double %v3080, %v3131
  %v3133 = getelementptr i8, ptr %v3112, i64 %v855
  %v3134 = load double, ptr %v3133, align 8, !noalias !409
  %v3135 = fadd double %v3134, %v3132
  %v3136 = fmul double %v3083, %v3135
  %v3137 = getelementptr i8, ptr %v3112, i64 %v856
  %v3138 = load double, ptr %v3137, align 8, !noalias !409
  %v3139 = fadd double %v3138, %v3136
  %v3140 = fmul double %v3080, %v3139
  %v3141 = load double, ptr %v3112, align 8, !noalias !409
  %v3103 = fadd double %v3141, %v3140
  br label %v3093

v3030:
  %v3142 = icmp eq i64 %v3143, %v9
  br i1 %v3142, label %v3144, label %v3145

v3145:
  %v3027 = phi i64 [ %v3143, %v3030 ], [ 0, %v3023 ]
  %v3143 = add nsw i64 %v3027, 1
  %v3045 = getelementptr i64, ptr %v142, i64 %v3027
  %v3033 = load i64, ptr %v3045, align 8, !noalias !402
  %v3146 = icmp slt i64 %v3033, 0
  br i1 %v3146, label %v3030, label %v3025

v3144:
  br i1 %v857, label %v3147, label %v3148

v3148:
  %v3149 = load double, ptr %v859, align 8
  %v3150 = fcmp ogt double %v3149, 5.000000e-01
  br i1 %v3150, label %v3147, label %v3151

v3147:
  %v3152 = load i64, ptr %v860, align 8, !noalias !413
  %v3153 = inttoptr i64 %v3152 to ptr
  tail call void %v3153(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !413
  br label %v3151

v3151:
  br i1 %v1372, label %v3154, label %v3155

v3154:
  %v3156 = load double, ptr %v862, align 8, !noalias !416
  %v3157 = fcmp olt double %v3156, 5.000000e-01
  br i1 %v3157, label %v3155, label %v3158

v3158:
  br i1 %v864, label %v3159, label %v3160

v3161:
  %v3162 = getelementptr double, ptr %v865, i64 %v3163
  %v3164 = load double, ptr %v3162, align 8, !noalias !416
  %v3165 = add nsw i64 %v3163, %v17
  %v3166 = icmp slt i64 %v3165, 0
  %v3167 = select i1 %v3166, i64 %v166, i64 0
  %v3168 = getelementptr double, ptr %v165, i64 %v3165
  %v3169 = getelementptr double, ptr %v3168, i64 %v3167
  %v3170 = load double, ptr %v3169, align 8, !noalias !416
  %v3171 = fcmp une double %v3164, %v3170
  br label %v3172

v3172:
  %v3173 = phi i1 [ true, %v3159 ], [ %v3171, %v3161 ]
  %v3174 = icmp eq i64 %v3175, %v18
  br i1 %v3174, label %v3160, label %v3159

v3160:
  %v3176 = phi i1 [ false, %v3158 ], [ %v3173, %v3172 ]
  %v3177 = load double, ptr %v867, align 8, !noalias !416
  %v3178 = fcmp oeq double %v3177, 1.000000e+00
  %v3179 = select i1 %v3178, i1 %v3176, i1 false
  br i1 %v3179, label %v3180, label %v3181

v3180:
  %v3182 = load double, ptr %v133, align 8, !noalias !416
  %v3183 = load double, ptr %v869, align 8, !noalias !416
  %v3184 = fsub double %v3182, %v3183
  br i1 %v870, label %v3185, label %v3186

v3187:
  %v3188 = load double, ptr %v871, align 8, !noalias !416
  %v3189 = load double, ptr %v23, align 8, !noalias !416
  %v3190 = mul i64 %v3191, %v196
  %v3192 = getelementptr double, ptr %v193, i64 %v3190
  %v3193 = load double, ptr %v3192, align 8, !noalias !416
  %v3194 = tail call double @llvm.fabs.f64(double %v3193)
  %v3195 = fmul double %v3189, %v3194
  %v3196 = fadd double %v3188, %v3195
  %v3197 = add i64 %v3191, %v195
  %v3198 = mul i64 %v3197, %v196
  %v3199 = getelementptr double, ptr %v193, i64 %v3198
  %v3200 = load double, ptr %v3199, align 8, !noalias !416
  %v3201 = tail call double @llvm.fabs.f64(double %v3200)
  %v3202 = fmul double %v3184, %v3201
  %v3203 = fcmp ogt double %v3202, %v3196
  br label %v3204

v3204:
  %v3205 = phi i1 [ true, %v3186 ], [ %v3203, %v3187 ]
  %v3206 = icmp eq i64 %v10, %v3207
  br i1 %v3206, label %v3208, label %v3186

v3208:
  %v3209 = select i1 %v3205, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  br label %v3185

v3185:
  %v3210 = phi double [ 5.000000e-06, %v3180 ], [ %v3209, %v3208 ]
  %v3211 = load double, ptr %v873, align 8, !noalias !416
  %v3212 = load double, ptr %v92, align 8, !noalias !416
  %v3213 = fsub double %v3211, %v3212
  %v3214 = fmul double %v3210, %v3213
  %v3215 = fcmp olt double %v3184, %v3214
  br i1 %v3215, label %v3216, label %v3217

v3216:
  %v3218 = load i64, ptr %v875, align 8, !noalias !416
  %v3219 = add nsw i64 %v3218, 1
  br label %v3217

v3217:
  %v3220 = phi i64 [ %v3219, %v3216 ], [ 0, %v3185 ]
  store i64 %v3220, ptr %v877, align 8, !noalias !416
  %v3221 = load double, ptr %v133, align 8, !noalias !416
  store double %v3221, ptr %v869, align 8, !noalias !416
  store double 1.000000e+00, ptr %v879, align 8, !noalias !416
  store i64 2, ptr %v452, align 8, !noalias !416
  %v3222 = load i64, ptr %v877, align 8, !noalias !416
  %v3223 = icmp sgt i64 %v3222, 1000
  br i1 %v3223, label %v3224, label %v3181

v3224:
  %v3225 = load i64, ptr %v142, align 8, !noalias !420
  %v3226 = icmp sgt i64 %v3225, -1
  br i1 %v3226, label %v3227, label %v3181

v3227:
  %v3228 = getelementptr i64, ptr %v110, i64 %v3225
  %v3229 = load i64, ptr %v3228, align 8, !noalias !420
  %v3230 = icmp eq i64 %v3229, 0
  br i1 %v3230, label %v3231, label %v3181

v3231:
  store i64 6, ptr %v3228, align 8, !noalias !420
  br label %v3181

v3181:
  store double 0.000000e+00, ptr %v867, align 8, !noalias !416
  br label %v3155

v3159:
  %v3232 = phi i1 [ %v3173, %v3172 ], [ false, %v3158 ]
  %v3163 = phi i64 [ %v3175, %v3172 ], [ 0, %v3158 ]
  %v3175 = add nsw i64 %v3163, 1
  br i1 %v3232, label %v3172, label %v3161

v3186:
  %v3233 = phi i1 [ %v3205, %v3204 ], [ false, %v3180 ]
  %v3191 = phi i64 [ %v3207, %v3204 ], [ 0, %v3180 ]
  %v3207 = add nsw i64 %v3191, 1
  br i1 %v3233, label %v3204, label %v3187

v3155:
  %v3234 = and i1 %v880, %v1258
  %v3235 = xor i1 %v3234, true
  %v3236 = or i1 %v307, %v3235
  br i1 %v3236, label %v3237, label %v3238

v3239:
  %v3240 = getelementptr i64, ptr %v110, i64 %v3241
  %v3242 = load i64, ptr %v3240, align 8, !noalias !423
  %v3243 = icmp eq i64 %v3242, 0
  br i1 %v3243, label %v3244, label %v3245

v3244:
  %v3246 = getelementptr double, ptr %v883, i64 %v3247
  %v3248 = load double, ptr %v3246, align 8, !noalias !423
  %v3249 = fcmp olt double %v3248, 5.000000e-01
  br i1 %v3249, label %v3245, label %v3250

v3250:
  %v3251 = getelementptr double, ptr %v133, i64 %v3247
  %v3252 = load double, ptr %v3251, align 8, !noalias !423
  %v3253 = getelementptr double, ptr %v885, i64 %v3247
  %v3254 = load double, ptr %v3253, align 8, !noalias !423
  %v3255 = fcmp une double %v3252, %v3254
  %v3256 = select i1 %v3255, i1 true, i1 %v887
  %v3257 = xor i1 %v3255, true
  %v3258 = select i1 %v3257, i1 true, i1 %v3259
  br i1 %v3256, label %v3245, label %v3260

v3260:
  %v3261 = getelementptr i64, ptr %v886, i64 %v3247
  %v3262 = load i64, ptr %v3261, align 8, !noalias !428
  %v3263 = add nsw i64 %v3262, 1
  %v3264 = icmp slt i64 %v3262, -1
  %v3265 = select i1 %v3264, i64 %v77, i64 0
  %v3266 = add i64 %v3263, %v3265
  %v3267 = mul i64 %v3266, %v78
  %v3268 = getelementptr double, ptr %v76, i64 %v3267
  br label %v3269

v3269:
  %v3270 = phi i64 [ 0, %v3260 ], [ %v3271, %v3269 ]
  %v3271 = add nsw i64 %v3270, 1
  %v3272 = getelementptr double, ptr %v3268, i64 %v3270
  %v3273 = load double, ptr %v3272, align 8, !noalias !429
  %v3274 = getelementptr i64, ptr %v62, i64 %v3270
  %v3275 = load i64, ptr %v3274, align 8, !noalias !429
  %v3276 = mul nsw i64 %v3275, %v9
  %v3277 = add nsw i64 %v3276, %v3247
  %v3278 = icmp slt i64 %v3277, 0
  %v3279 = select i1 %v3278, i64 %v166, i64 0
  %v3280 = getelementptr double, ptr %v165, i64 %v3277
  %v3281 = getelementptr double, ptr %v3280, i64 %v3279
  store double %v3273, ptr %v3281, align 8, !noalias !429
  %v3282 = icmp eq i64 %v63, %v3271
  br i1 %v3282, label %v3245, label %v3269

v3245:
  %v3283 = phi i1 [ %v3258, %v3250 ], [ %v3259, %v3244 ], [ %v3259, %v3238 ], [ %v3259, %v3239 ], [ true, %v3269 ]
  %v3284 = icmp eq i64 %v9, %v3285
  br i1 %v3284, label %v3286, label %v3238

v3286:
  br i1 %v3283, label %v3287, label %v3237

v3287:
  %v3288 = load i64, ptr %v888, align 8, !noalias !433
  %v3289 = inttoptr i64 %v3288 to ptr
  tail call void %v3289(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !433
  %v3290 = load i64, ptr %v890, align 8, !noalias !428
  %v3291 = inttoptr i64 %v3290 to ptr
  tail call void %v3291(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v892), !noalias !428
  br label %v3292

v3292:
  %v3293 = phi i64 [ 0, %v3287 ], [ %v3294, %v3295 ]
  %v3296 = phi i64 [ %v894, %v3287 ], [ %v3297, %v3295 ]
  %v3298 = phi i64 [ 1, %v3287 ], [ %v3299, %v3295 ]
  %v3300 = icmp slt i64 %v3293, 0
  %v3301 = select i1 %v3300, i64 %v144, i64 0
  %v3302 = add i64 %v3301, %v3293
  %v3303 = getelementptr i64, ptr %v142, i64 %v3302
  %v3304 = load i64, ptr %v3303, align 8, !noalias !436
  %v3305 = icmp slt i64 %v3304, 0
  br i1 %v3305, label %v3295, label %v3306

v3306:
  %v3307 = getelementptr i64, ptr %v110, i64 %v3304
  %v3308 = load i64, ptr %v3307, align 8, !noalias !436
  %v3309 = icmp eq i64 %v3308, 0
  br i1 %v3309, label %v3310, label %v3295

v3310:
  %v3311 = select i1 %v3300, i64 %v135, i64 0
  %v3312 = add i64 %v3311, %v3293
  %v3313 = getelementptr double, ptr %v883, i64 %v3312
  %v3314 = load double, ptr %v3313, align 8, !noalias !436
  %v3315 = fcmp olt double %v3314, 5.000000e-01
  br i1 %v3315, label %v3295, label %v3316

v3316:
  %v3317 = getelementptr double, ptr %v133, i64 %v3312
  %v3318 = load double, ptr %v3317, align 8, !noalias !436
  %v3319 = getelementptr double, ptr %v885, i64 %v3312
  %v3320 = load double, ptr %v3319, align 8, !noalias !436
  %v3321 = fcmp une double %v3318, %v3320
  br i1 %v3321, label %v3295, label %v3322

v3322:
  %v3323 = getelementptr i64, ptr %v897, i64 %v3302
  %v3324 = load i64, ptr %v3323, align 8, !noalias !439
  %v3325 = icmp sgt i64 %v3324, 0
  br i1 %v3325, label %v3326, label %v3327

v3326:
  %v3328 = getelementptr double, ptr %v92, i64 %v3324
  %v3329 = getelementptr i8, ptr %v3328, i64 -8
  %v3330 = load double, ptr %v3329, align 8, !noalias !439
  %v3331 = getelementptr double, ptr %v133, i64 %v3293
  %v3332 = getelementptr double, ptr %v3331, i64 %v3311
  %v3333 = load double, ptr %v3332, align 8, !noalias !439
  %v3334 = fcmp oeq double %v3330, %v3333
  br label %v3327

v3327:
  %v3335 = phi i1 [ %v3334, %v3326 ], [ false, %v3322 ]
  br i1 %v899, label %v3336, label %v3337

v3337:
  %v3338 = mul i64 %v893, %v3304
  %v3339 = select i1 %v3300, i64 %v196, i64 0
  %v3340 = add i64 %v3339, %v3293
  %v3341 = getelementptr double, ptr %v900, i64 %v3340
  %v3342 = getelementptr double, ptr %v193, i64 %v3340
  %v3343 = add nsw i64 %v3324, -1
  %v3344 = select i1 %v3325, i64 0, i64 %v101
  %v3345 = add i64 %v3343, %v3344
  %v3346 = mul i64 %v3345, %v102
  %v3347 = getelementptr double, ptr %v99, i64 %v3338
  %v3348 = getelementptr double, ptr %v3347, i64 %v3346
  br label %v3349

v3350:
  %v3351 = getelementptr double, ptr %v3348, i64 %v3352
  store double %v3353, ptr %v3351, align 8, !noalias !439
  br label %v3354

v3354:
  %v3355 = icmp eq i64 %v10, %v3356
  br i1 %v3355, label %v3357, label %v3349

v3357:
  %v3358 = fcmp une double %v3359, 0.000000e+00
  br i1 %v3358, label %v3360, label %v3336

v3360:
  %v3361 = load i64, ptr %v3303, align 8, !noalias !443
  %v3362 = icmp sgt i64 %v3361, -1
  br i1 %v3362, label %v3363, label %v3336

v3363:
  %v3364 = getelementptr i64, ptr %v110, i64 %v3361
  %v3365 = load i64, ptr %v3364, align 8, !noalias !443
  %v3366 = icmp eq i64 %v3365, 0
  br i1 %v3366, label %v3367, label %v3336

v3367:
  store i64 3, ptr %v3364, align 8, !noalias !443
  br label %v3336

v3336:
  br i1 %v901, label %v3295, label %v3368

v3368:
  %v3369 = load double, ptr %v903, align 8, !noalias !446
  %v3370 = load double, ptr %v92, align 8, !noalias !446
  %v3371 = fsub double %v3369, %v3370
  %v3372 = fmul double %v3371, 1.000000e-13
  %v3373 = load double, ptr %v133, align 8, !noalias !446
  %v3374 = tail call double @llvm.fabs.f64(double %v3373)
  %v3375 = fmul double %v3374, 4.000000e-15
  %v3376 = fcmp ogt double %v3375, %v3372
  %v3377 = select i1 %v3376, double %v3375, double %v3372
  %v3378 = fadd double %v3373, %v3377
  store double %v3378, ptr %v905, align 8, !noalias !453
  %v3379 = load i64, ptr %v6, align 8, !noalias !454
  %v3380 = inttoptr i64 %v3379 to ptr
  tail call void %v3380(ptr nonnull %v133, ptr %v892, ptr %v165, ptr %v172, ptr %v179, ptr %v907), !noalias !454
  br i1 %v899, label %v3381, label %v3382

v3381:
  %v3383 = load i64, ptr %v912, align 8, !noalias !457
  %v3384 = inttoptr i64 %v3383 to ptr
  tail call void %v3384(ptr nonnull %v133, ptr %v914, ptr %v165, ptr %v172, ptr %v179, ptr %v916), !noalias !457
  %v3385 = load i64, ptr %v912, align 8, !noalias !460
  %v3386 = inttoptr i64 %v3385 to ptr
  tail call void %v3386(ptr nonnull %v905, ptr %v918, ptr %v165, ptr %v172, ptr %v179, ptr %v920), !noalias !460
  br label %v3387

v3387:
  %v3388 = phi i64 [ %v18, %v3381 ], [ %v3389, %v3390 ]
  %v3391 = phi i64 [ %v922, %v3381 ], [ %v3392, %v3390 ]
  %v3393 = icmp sgt i64 %v3391, 0
  br i1 %v3393, label %v3390, label %v3295

v3394:
  %v3395 = getelementptr i64, ptr %v933, i64 %v3302
  store i64 %v3388, ptr %v3395, align 8, !noalias !453
  %v3396 = load i64, ptr %v3303, align 8, !noalias !463
  %v3397 = icmp sgt i64 %v3396, -1
  br i1 %v3397, label %v3398, label %v3399

v3398:
  %v3400 = getelementptr i64, ptr %v110, i64 %v3396
  %v3401 = load i64, ptr %v3400, align 8, !noalias !463
  %v3402 = icmp eq i64 %v3401, 0
  br i1 %v3402, label %v3403, label %v3399

v3403:
  store i64 4, ptr %v3400, align 8, !noalias !463
  br label %v3399

v3399:
  %v3404 = load double, ptr %v3317, align 8, !noalias !453
  store double %v3404, ptr %v3319, align 8, !noalias !453
  %v3405 = getelementptr double, ptr %v935, i64 %v3312
  store double 0.000000e+00, ptr %v3405, align 8, !noalias !453
  br label %v3295

v3382:
  %v3406 = phi i64 [ %v3407, %v3382 ], [ 0, %v3368 ]
  %v3407 = add nsw i64 %v3406, 1
  %v3408 = mul i64 %v3406, %v196
  %v3409 = getelementptr double, ptr %v900, i64 %v3408
  %v3410 = load double, ptr %v3409, align 8, !noalias !453
  %v3411 = getelementptr double, ptr %v909, i64 %v3408
  %v3412 = load double, ptr %v3411, align 8, !noalias !453
  %v3413 = fmul double %v3377, %v3412
  %v3414 = fadd double %v3410, %v3413
  %v3415 = getelementptr double, ptr %v911, i64 %v3408
  store double %v3414, ptr %v3415, align 8, !noalias !453
  %v3416 = icmp eq i64 %v10, %v3407
  br i1 %v3416, label %v3381, label %v3382

v3390:
  %v3392 = add nsw i64 %v3391, -1
  %v3389 = add i64 %v3388, 1
  %v3417 = icmp slt i64 %v3388, 0
  %v3418 = select i1 %v3417, i64 %v207, i64 0
  %v3419 = add i64 %v3418, %v3388
  %v3420 = getelementptr double, ptr %v926, i64 %v3419
  %v3421 = load double, ptr %v3420, align 8, !noalias !453
  %v3422 = getelementptr double, ptr %v929, i64 %v3419
  %v3423 = load double, ptr %v3422, align 8, !noalias !453
  %v3424 = fsub double %v3421, %v3423
  %v3425 = tail call double @llvm.fabs.f64(double %v3424)
  %v3426 = getelementptr double, ptr %v931, i64 %v3419
  %v3427 = load double, ptr %v3426, align 8, !noalias !453
  %v3428 = tail call i1 @llvm.is.fpclass.f64(double %v3427, i32 543)
  %v3429 = select i1 %v3428, double 0.000000e+00, double %v3427
  %v3430 = fcmp ueq double %v3425, 0x7FF0000000000000
  %v3431 = select i1 %v3430, double -0.000000e+00, double %v3425
  %v3432 = fadd double %v3429, %v3431
  %v3433 = getelementptr double, ptr %v928, i64 %v3419
  %v3434 = load double, ptr %v3433, align 8, !noalias !453
  %v3435 = fneg double %v3432
  %v3436 = fcmp olt double %v3434, %v3435
  br i1 %v3436, label %v3394, label %v3387

v3349:
  %v3437 = phi double [ 0.000000e+00, %v3337 ], [ %v3359, %v3354 ]
  %v3352 = phi i64 [ 0, %v3337 ], [ %v3356, %v3354 ]
  %v3356 = add nsw i64 %v3352, 1
  %v3438 = mul i64 %v3352, %v196
  %v3439 = getelementptr double, ptr %v3341, i64 %v3438
  %v3353 = load double, ptr %v3439, align 8, !noalias !439
  %v3440 = fmul double %v3353, 0.000000e+00
  %v3359 = fadd double %v3437, %v3440
  %v3441 = getelementptr double, ptr %v3342, i64 %v3438
  store double %v3353, ptr %v3441, align 8, !noalias !439
  br i1 %v3335, label %v3350, label %v3354

v3295:
  %v3442 = icmp sgt i64 %v3296, 0
  %v3443 = zext i1 %v3442 to i64
  %v3299 = add i64 %v3298, %v3443
  %v3444 = sext i1 %v3442 to i64
  %v3297 = add nsw i64 %v3296, %v3444
  %v3294 = select i1 %v3442, i64 %v3298, i64 0
  br i1 %v3442, label %v3292, label %v3237

v3238:
  %v3259 = phi i1 [ %v3283, %v3245 ], [ false, %v3155 ]
  %v3247 = phi i64 [ %v3285, %v3245 ], [ 0, %v3155 ]
  %v3285 = add nsw i64 %v3247, 1
  %v3445 = getelementptr i64, ptr %v142, i64 %v3247
  %v3241 = load i64, ptr %v3445, align 8, !noalias !423
  %v3446 = icmp slt i64 %v3241, 0
  br i1 %v3446, label %v3245, label %v3239

v3237:
  %v3447 = xor i1 %v1258, true
  %v3448 = or i1 %v307, %v3447
  %v3449 = select i1 %v1258, i64 0, i64 %v1034
  br i1 %v3448, label %v1033, label %v3450

v3450:
  %v3451 = phi i64 [ %v3452, %v3453 ], [ 0, %v3237 ]
  %v3454 = phi i64 [ %v3455, %v3453 ], [ %v939, %v3237 ]
  %v3456 = phi i64 [ %v3457, %v3453 ], [ %v938, %v3237 ]
  %v3458 = phi i1 [ %v3459, %v3453 ], [ false, %v3237 ]
  %v3460 = phi i64 [ %v3461, %v3453 ], [ 0, %v3237 ]
  %v3462 = icmp slt i64 %v3451, 0
  %v3463 = select i1 %v3462, i64 %v144, i64 0
  %v3464 = add i64 %v3463, %v3451
  %v3465 = getelementptr i64, ptr %v142, i64 %v3464
  %v3466 = load i64, ptr %v3465, align 8, !noalias !466
  %v3467 = icmp slt i64 %v3466, 0
  br i1 %v3467, label %v3453, label %v3468

v3468:
  %v3469 = mul i64 %v3466, %v126
  %v3470 = getelementptr i64, ptr %v124, i64 %v3469
  %v3471 = load i64, ptr %v3470, align 8, !noalias !466
  %v3472 = getelementptr i8, ptr %v3470, i64 24
  %v3473 = load i64, ptr %v3472, align 8, !noalias !466
  %v3474 = add nsw i64 %v3473, %v3471
  %v3475 = icmp slt i64 %v3474, %v298
  br i1 %v3475, label %v3476, label %v3477

v3477:
  %v3478 = getelementptr i64, ptr %v110, i64 %v3466
  %v3479 = load i64, ptr %v3478, align 8, !noalias !470
  %v3480 = icmp eq i64 %v3479, 0
  br i1 %v3480, label %v3481, label %v3482

v3481:
  store i64 5, ptr %v3478, align 8, !noalias !470
  br label %v3482

v3476:
  %v3483 = select i1 %v3462, i64 %v135, i64 0
  %v3484 = add i64 %v3483, %v3451
  %v3485 = getelementptr double, ptr %v941, i64 %v3484
  %v3486 = load double, ptr %v3485, align 8, !noalias !466
  %v3487 = sitofp i64 %v3474 to double
  %v3488 = fcmp ugt double %v3486, %v3487
  br i1 %v3488, label %v3482, label %v3489

v3489:
  br i1 %v942, label %v3490, label %v3491

v3491:
  %v3492 = getelementptr double, ptr %v193, i64 %v3451
  %v3493 = select i1 %v3462, i64 %v196, i64 0
  %v3494 = getelementptr double, ptr %v3492, i64 %v3493
  br label %v3495

v3490:
  %v3496 = phi double [ 0.000000e+00, %v3489 ], [ %v3497, %v3495 ]
  %v3498 = getelementptr double, ptr %v133, i64 %v3484
  %v3499 = load double, ptr %v3498, align 8, !noalias !473
  %v3500 = getelementptr double, ptr %v944, i64 %v3484
  %v3501 = load double, ptr %v3500, align 8, !noalias !473
  %v3502 = fsub double %v3499, %v3501
  %v3503 = getelementptr double, ptr %v946, i64 %v3484
  %v3504 = load double, ptr %v3503, align 8, !noalias !473
  %v3505 = fadd double %v3504, 1.000000e+00
  store double %v3505, ptr %v3503, align 8, !noalias !473
  %v3506 = getelementptr double, ptr %v948, i64 %v3484
  %v3507 = load double, ptr %v3506, align 8, !noalias !473
  %v3508 = fmul double %v3507, 1.050000e+00
  %v3509 = fcmp ogt double %v3502, %v3508
  br i1 %v3509, label %v3510, label %v3511

v3510:
  %v3512 = fcmp ogt double %v3505, 0.000000e+00
  %v3513 = select i1 %v3512, double 0.000000e+00, double %v3505
  store double %v3513, ptr %v3503, align 8, !noalias !473
  %v3514 = getelementptr double, ptr %v950, i64 %v3484
  store double %v3496, ptr %v3514, align 8, !noalias !473
  br label %v3511

v3511:
  %v3515 = load double, ptr %v3498, align 8, !noalias !473
  store double %v3515, ptr %v3500, align 8, !noalias !473
  store double %v3502, ptr %v3506, align 8, !noalias !473
  %v3516 = fmul double %v3487, 2.000000e+00
  store double %v3516, ptr %v3485, align 8, !noalias !473
  %v3517 = getelementptr double, ptr %v952, i64 %v3484
  %v3518 = load double, ptr %v3517, align 8, !noalias !473
  %v3519 = load double, ptr %v3498, align 8, !noalias !473
  %v3520 = fsub double %v3518, %v3519
  %v3521 = fmul double %v3487, 5.000000e-01
  %v3522 = fmul double %v3521, %v3520
  %v3523 = fdiv double %v3522, %v3502
  %v3524 = load double, ptr %v3503, align 8, !noalias !473
  %v3525 = fcmp olt double %v3524, 0.000000e+00
  %v3526 = select i1 %v3525, double 1.000000e+15, double 1.000000e+11
  %v3527 = icmp sgt i64 %v3474, 499999
  %v3528 = fcmp ogt double %v3523, %v3526
  %v3529 = select i1 %v3527, i1 %v3528, i1 false
  br i1 %v3529, label %v3530, label %v3531

v3530:
  %v3532 = load i64, ptr %v3465, align 8, !noalias !477
  %v3533 = icmp sgt i64 %v3532, -1
  br i1 %v3533, label %v3534, label %v3531

v3534:
  %v3535 = getelementptr i64, ptr %v110, i64 %v3532
  %v3536 = load i64, ptr %v3535, align 8, !noalias !477
  %v3537 = icmp eq i64 %v3536, 0
  br i1 %v3537, label %v3538, label %v3531

v3538:
  store i64 5, ptr %v3535, align 8, !noalias !477
  br label %v3531

v3531:
  %v3539 = load double, ptr %v3503, align 8, !noalias !473
  %v3540 = fcmp ult double %v3539, 5.000000e+00
  br i1 %v3540, label %v3482, label %v3541

v3541:
  %v3542 = getelementptr double, ptr %v954, i64 %v3484
  %v3543 = load double, ptr %v3542, align 8, !noalias !473
  %v3544 = fmul double %v3543, 2.000000e+00
  %v3545 = fcmp ogt double %v3496, %v3544
  br i1 %v3545, label %v3546, label %v3482

v3546:
  %v3547 = sub nsw i64 %v298, %v3474
  %v3548 = sitofp i64 %v3547 to double
  %v3549 = fmul double %v3548, 2.000000e+00
  %v3550 = fcmp ogt double %v3523, %v3549
  br i1 %v3550, label %v3551, label %v3482

v3551:
  %v3552 = load i64, ptr %v3465, align 8, !noalias !480
  %v3553 = icmp sgt i64 %v3552, -1
  br i1 %v3553, label %v3554, label %v3482

v3554:
  %v3555 = getelementptr i64, ptr %v110, i64 %v3552
  %v3556 = load i64, ptr %v3555, align 8, !noalias !480
  %v3557 = icmp eq i64 %v3556, 0
  br i1 %v3557, label %v3558, label %v3482

v3558:
  store i64 8, ptr %v3555, align 8, !noalias !480
  br label %v3482

v3495:
  %v3559 = phi double [ 0.000000e+00, %v3491 ], [ %v3497, %v3495 ]
  %v3560 = phi i64 [ 0, %v3491 ], [ %v3561, %v3495 ]
  %v3561 = add nsw i64 %v3560, 1
  %v3562 = mul i64 %v3560, %v196
  %v3563 = getelementptr double, ptr %v3494, i64 %v3562
  %v3564 = load double, ptr %v3563, align 8, !noalias !473
  %v3565 = tail call double @llvm.fabs.f64(double %v3564)
  %v3566 = fcmp ogt double %v3565, %v3559
  %v3497 = select i1 %v3566, double %v3565, double %v3559
  %v3567 = icmp eq i64 %v10, %v3561
  br i1 %v3567, label %v3490, label %v3495

v3482:
  %v3568 = select i1 %v3462, i64 %v135, i64 0
  %v3569 = add i64 %v3568, %v3451
  %v3570 = getelementptr double, ptr %v956, i64 %v3569
  %v3571 = load double, ptr %v3570, align 8, !noalias !466
  %v3572 = fcmp ogt double %v3571, 5.000000e-01
  br i1 %v3572, label %v3573, label %v3574

v3573:
  %v3575 = getelementptr double, ptr %v133, i64 %v3569
  %v3576 = load double, ptr %v3575, align 8, !noalias !466
  %v3577 = getelementptr double, ptr %v958, i64 %v3569
  %v3578 = load double, ptr %v3577, align 8, !noalias !466
  %v3579 = fcmp oeq double %v3576, %v3578
  br i1 %v3579, label %v3580, label %v3574

v3580:
  %v3581 = getelementptr i64, ptr %v959, i64 %v3464
  %v3582 = load i64, ptr %v3581, align 8, !noalias !483
  %v3583 = add nsw i64 %v3582, 1
  store i64 %v3583, ptr %v3581, align 8, !noalias !483
  %v3584 = icmp slt i64 %v3582, -1
  %v3585 = select i1 %v3584, i64 %v70, i64 0
  %v3586 = getelementptr double, ptr %v69, i64 %v3583
  %v3587 = getelementptr double, ptr %v3586, i64 %v3585
  %v3588 = load double, ptr %v3587, align 8, !noalias !483
  %v3589 = fcmp oeq double %v3588, 0x7FF0000000000000
  br i1 %v3589, label %v3590, label %v3591

v3590:
  %v3592 = load i64, ptr %v3465, align 8, !noalias !483
  %v3593 = icmp slt i64 %v3592, 0
  %v3594 = select i1 %v3593, i64 %v111, i64 0
  %v3595 = getelementptr i64, ptr %v110, i64 %v3592
  %v3596 = getelementptr i64, ptr %v3595, i64 %v3594
  %v3597 = load i64, ptr %v3596, align 8, !noalias !483
  %v3598 = icmp eq i64 %v3597, 0
  br i1 %v3598, label %v3599, label %v3574

v3599:
  store i64 1, ptr %v3596, align 8, !noalias !483
  br label %v3574

v3591:
  store double %v3588, ptr %v3577, align 8, !noalias !483
  %v3600 = select i1 %v3584, i64 %v86, i64 0
  %v3601 = getelementptr i64, ptr %v85, i64 %v3583
  %v3602 = getelementptr i64, ptr %v3601, i64 %v3600
  %v3603 = load i64, ptr %v3602, align 8, !noalias !483
  %v3604 = icmp eq i64 %v3603, 0
  br i1 %v3604, label %v3605, label %v3606

v3605:
  %v3607 = getelementptr double, ptr %v963, i64 %v3569
  store double 1.000000e+00, ptr %v3607, align 8, !noalias !483
  br label %v3608

v3606:
  %v3609 = getelementptr double, ptr %v961, i64 %v3569
  %v3610 = load double, ptr %v3609, align 8, !noalias !483
  %v3611 = fcmp olt double %v3610, 2.500000e-01
  %v3612 = select i1 %v3611, double 2.500000e-01, double %v3610
  store double %v3612, ptr %v3609, align 8, !noalias !483
  %v3613 = load i64, ptr %v452, align 8, !noalias !483
  %v3614 = tail call i64 @llvm.smax.i64(i64 %v3613, i64 1)
  br label %v3608

v3608:
  %v3615 = phi i64 [ %v3614, %v3606 ], [ 2, %v3605 ]
  store i64 %v3615, ptr %v452, align 8, !noalias !483
  br i1 %v964, label %v3574, label %v3616

v3616:
  %v3617 = select i1 %v3584, i64 %v77, i64 0
  %v3618 = add i64 %v3617, %v3583
  %v3619 = mul i64 %v3618, %v78
  %v3620 = getelementptr double, ptr %v76, i64 %v3619
  br label %v3621

v3621:
  %v3622 = phi i64 [ 0, %v3616 ], [ %v3623, %v3621 ]
  %v3623 = add nsw i64 %v3622, 1
  %v3624 = getelementptr double, ptr %v3620, i64 %v3622
  %v3625 = load double, ptr %v3624, align 8, !noalias !487
  %v3626 = getelementptr i64, ptr %v62, i64 %v3622
  %v3627 = load i64, ptr %v3626, align 8, !noalias !487
  %v3628 = mul nsw i64 %v3627, %v9
  %v3629 = add nsw i64 %v3628, %v3451
  %v3630 = icmp slt i64 %v3629, 0
  %v3631 = select i1 %v3630, i64 %v166, i64 0
  %v3632 = getelementptr double, ptr %v165, i64 %v3629
  %v3633 = getelementptr double, ptr %v3632, i64 %v3631
  store double %v3625, ptr %v3633, align 8, !noalias !487
  %v3634 = icmp eq i64 %v63, %v3623
  br i1 %v3634, label %v3574, label %v3621

v3574:
  %v3635 = getelementptr i64, ptr %v110, i64 %v3466
  %v3636 = load i64, ptr %v3635, align 8, !noalias !466
  %v3637 = icmp eq i64 %v3636, 0
  br i1 %v3637, label %v3638, label %v3639

v3639:
  %v3640 = getelementptr i64, ptr %v966, i64 %v3464
  %v3641 = load i64, ptr %v3640, align 8, !noalias !466
  %v3642 = getelementptr i64, ptr %v117, i64 %v3466
  store i64 %v3641, ptr %v3642, align 8, !noalias !466
  store i64 -1, ptr %v3465, align 8, !noalias !466
  %v3643 = getelementptr double, ptr %v968, i64 %v3569
  store double 0.000000e+00, ptr %v3643, align 8, !noalias !491
  %v3644 = load i64, ptr %v151, align 8, !noalias !491
  %v3645 = load i64, ptr %v969, align 8, !noalias !491
  %v3646 = icmp eq i64 %v3644, %v3645
  br i1 %v3646, label %v3647, label %v3648

v3648:
  %v3649 = add nsw i64 %v3644, 1
  store i64 %v3649, ptr %v151, align 8, !noalias !491
  store i64 2, ptr %v452, align 8, !noalias !491
  store i64 %v3644, ptr %v3465, align 8, !noalias !491
  %v3650 = icmp slt i64 %v3644, 0
  %v3651 = select i1 %v3650, i64 %v49, i64 0
  %v3652 = getelementptr i64, ptr %v48, i64 %v3644
  %v3653 = getelementptr i64, ptr %v3652, i64 %v3651
  %v3654 = load i64, ptr %v3653, align 8, !noalias !491
  %v3655 = icmp slt i64 %v3654, 0
  %v3656 = select i1 %v3655, i64 %v56, i64 0
  %v3657 = getelementptr i64, ptr %v55, i64 %v3654
  %v3658 = getelementptr i64, ptr %v3657, i64 %v3656
  %v3659 = load i64, ptr %v3658, align 8, !noalias !491
  %v3660 = getelementptr i64, ptr %v970, i64 %v3464
  store i64 %v3659, ptr %v3660, align 8, !noalias !491
  store i64 1, ptr %v3640, align 8, !noalias !491
  %v3661 = getelementptr i64, ptr %v972, i64 %v3464
  store i64 0, ptr %v3661, align 8, !noalias !491
  br i1 %v973, label %v3662, label %v3663

v3663:
  %v3664 = select i1 %v3650, i64 %v40, i64 0
  %v3665 = add i64 %v3664, %v3644
  %v3666 = mul i64 %v3665, %v41
  %v3667 = getelementptr double, ptr %v39, i64 %v3666
  br label %v3668

v3662:
  br i1 %v974, label %v3669, label %v3670

v3670:
  %v3671 = load i64, ptr %v3660, align 8, !noalias !491
  %v3672 = icmp slt i64 %v3671, 0
  %v3673 = select i1 %v3672, i64 %v77, i64 0
  %v3674 = add i64 %v3673, %v3671
  %v3675 = mul i64 %v3674, %v78
  %v3676 = getelementptr double, ptr %v76, i64 %v3675
  br label %v3677

v3677:
  %v3678 = phi i64 [ 0, %v3670 ], [ %v3679, %v3677 ]
  %v3679 = add nsw i64 %v3678, 1
  %v3680 = getelementptr double, ptr %v3676, i64 %v3678
  %v3681 = load double, ptr %v3680, align 8, !noalias !494
  %v3682 = getelementptr i64, ptr %v62, i64 %v3678
  %v3683 = load i64, ptr %v3682, align 8, !noalias !494
  %v3684 = mul nsw i64 %v3683, %v9
  %v3685 = add nsw i64 %v3684, %v3451
  %v3686 = icmp slt i64 %v3685, 0
  %v3687 = select i1 %v3686, i64 %v166, i64 0
  %v3688 = getelementptr double, ptr %v165, i64 %v3685
  %v3689 = getelementptr double, ptr %v3688, i64 %v3687
  store double %v3681, ptr %v3689, align 8, !noalias !494
  %v3690 = icmp eq i64 %v3679, %v63
  br i1 %v3690, label %v3669, label %v3677

v3691:
  %v3692 = getelementptr double, ptr %v133, i64 %v3569
  br label %v3693

v3694:
  %v3695 = mul i64 %v3696, %v135
  %v3697 = getelementptr double, ptr %v3692, i64 %v3695
  %v3698 = load double, ptr %v3697, align 8, !noalias !498
  %v3699 = fcmp une double %v3698, 0xFFF0000000000000
  br i1 %v3699, label %v3700, label %v3701

v3700:
  %v3702 = mul i64 %v3696, %v135
  %v3703 = getelementptr double, ptr %v3692, i64 %v3702
  store double 0.000000e+00, ptr %v3703, align 8, !noalias !498
  br label %v3701

v3701:
  %v3704 = icmp eq i64 %v3705, 32
  br i1 %v3704, label %v3706, label %v3693

v3706:
  %v3707 = getelementptr double, ptr %v977, i64 %v3569
  store double 5.000000e+03, ptr %v3707, align 8, !noalias !498
  store double 1.000000e+00, ptr %v3643, align 8, !noalias !498
  %v3708 = getelementptr double, ptr %v979, i64 %v3569
  store double 0xFFF0000000000000, ptr %v3708, align 8, !noalias !498
  %v3709 = getelementptr double, ptr %v981, i64 %v3569
  store double 0x7FF0000000000000, ptr %v3709, align 8, !noalias !498
  %v3710 = load double, ptr %v92, align 8, !noalias !491
  store double %v3710, ptr %v3692, align 8, !noalias !491
  %v3711 = load double, ptr %v92, align 8, !noalias !491
  %v3712 = getelementptr double, ptr %v983, i64 %v3569
  store double %v3711, ptr %v3712, align 8, !noalias !491
  %v3713 = load i64, ptr %v3660, align 8, !noalias !491
  %v3714 = icmp slt i64 %v3713, 0
  %v3715 = select i1 %v3714, i64 %v70, i64 0
  %v3716 = getelementptr double, ptr %v69, i64 %v3713
  %v3717 = getelementptr double, ptr %v3716, i64 %v3715
  %v3718 = load double, ptr %v3717, align 8, !noalias !491
  %v3719 = getelementptr double, ptr %v985, i64 %v3569
  store double %v3718, ptr %v3719, align 8, !noalias !491
  br label %v3647

v3693:
  %v3696 = phi i64 [ 0, %v3691 ], [ %v3705, %v3701 ]
  %v3705 = add nsw i64 %v3696, 1
  %v3720 = icmp ult i64 %v3696, 30
  br i1 %v3720, label %v3700, label %v3694

v3668:
  %v3721 = phi i64 [ 0, %v3663 ], [ %v3722, %v3668 ]
  %v3722 = add nsw i64 %v3721, 1
  %v3723 = getelementptr double, ptr %v3667, i64 %v3721
  %v3724 = load double, ptr %v3723, align 8, !noalias !491
  %v3725 = mul nsw i64 %v3721, %v9
  %v3726 = add nsw i64 %v3725, %v3451
  %v3727 = icmp slt i64 %v3726, 0
  %v3728 = select i1 %v3727, i64 %v166, i64 0
  %v3729 = getelementptr double, ptr %v165, i64 %v3726
  %v3730 = getelementptr double, ptr %v3729, i64 %v3728
  store double %v3724, ptr %v3730, align 8, !noalias !491
  %v3731 = icmp eq i64 %v3722, %v41
  br i1 %v3731, label %v3662, label %v3668

v3669:
  br i1 %v975, label %v3691, label %v3732

v3732:
  %v3733 = getelementptr double, ptr %v193, i64 %v3451
  %v3734 = select i1 %v3650, i64 %v31, i64 0
  %v3735 = add i64 %v3734, %v3644
  %v3736 = mul i64 %v3735, %v32
  %v3737 = getelementptr double, ptr %v30, i64 %v3736
  %v3738 = select i1 %v3462, i64 %v196, i64 0
  %v3739 = getelementptr double, ptr %v3733, i64 %v3738
  br label %v3740

v3740:
  %v3741 = phi i64 [ 0, %v3732 ], [ %v3742, %v3740 ]
  %v3742 = add nsw i64 %v3741, 1
  %v3743 = getelementptr double, ptr %v3737, i64 %v3741
  %v3744 = load double, ptr %v3743, align 8, !noalias !491
  %v3745 = mul i64 %v3741, %v196
  %v3746 = getelementptr double, ptr %v3739, i64 %v3745
  store double %v3744, ptr %v3746, align 8, !noalias !491
  %v3747 = icmp eq i64 %v3742, %v10
  br i1 %v3747, label %v3691, label %v3740

v3638:
  %v3748 = getelementptr double, ptr %v987, i64 %v3569
  %v3749 = load double, ptr %v3748, align 8, !noalias !466
  %v3750 = fcmp ult double %v3749, 1.500000e+01
  br i1 %v3750, label %v3647, label %v3751

v3751:
  %v3752 = load double, ptr %v989, align 8, !noalias !466
  %v3753 = getelementptr double, ptr %v133, i64 %v3569
  %v3754 = load double, ptr %v3753, align 8, !noalias !466
  %v3755 = fsub double %v3752, %v3754
  %v3756 = getelementptr double, ptr %v990, i64 %v3569
  %v3757 = load double, ptr %v3756, align 8, !noalias !466
  %v3758 = fmul double %v3757, 2.500000e+02
  %v3759 = fcmp ogt double %v3755, %v3758
  br i1 %v3759, label %v3647, label %v3760

v3760:
  store double 0.000000e+00, ptr %v3748, align 8, !noalias !466
  br label %v3647

v3647:
  %v3761 = phi i1 [ %v3458, %v3638 ], [ true, %v3751 ], [ %v3458, %v3760 ], [ %v3458, %v3639 ], [ %v3458, %v3706 ]
  %v3762 = load i64, ptr %v3465, align 8, !noalias !466
  %v3763 = icmp sgt i64 %v3762, -1
  br i1 %v3763, label %v3764, label %v3453

v3764:
  %v3765 = add nsw i64 %v3460, 1
  %v3766 = getelementptr double, ptr %v992, i64 %v3569
  %v3767 = load double, ptr %v3766, align 8, !noalias !466
  %v3768 = fcmp ogt double %v3767, 0.000000e+00
  br i1 %v3768, label %v3769, label %v3770

v3770:
  %v3771 = mul i64 %v3762, %v126
  %v3772 = getelementptr i64, ptr %v124, i64 %v3771
  %v3773 = load i64, ptr %v3772, align 8, !noalias !466
  %v3774 = and i64 %v3773, 127
  %v3775 = getelementptr double, ptr %v994, i64 %v3569
  %v3776 = load double, ptr %v3775, align 8, !noalias !466
  %v3777 = fcmp olt double %v3776, %v995
  %v3778 = select i1 %v3777, double %v3776, double %v995
  %v3779 = sitofp i64 %v3474 to double
  %v3780 = fsub double %v3778, %v3779
  %v3781 = sub nsw i64 128, %v3774
  %v3782 = uitofp i64 %v3781 to double
  %v3783 = fcmp ogt double %v3780, %v3782
  %v3784 = select i1 %v3783, double %v3782, double %v3780
  br label %v3769

v3769:
  %v3785 = phi double [ %v3784, %v3770 ], [ 1.000000e+00, %v3764 ]
  %v3786 = getelementptr double, ptr %v997, i64 %v3569
  store double %v3785, ptr %v3786, align 8, !noalias !466
  %v3787 = getelementptr double, ptr %v999, i64 %v3569
  %v3788 = load double, ptr %v3787, align 8, !noalias !502
  %v3789 = getelementptr double, ptr %v1001, i64 %v3569
  store double %v3788, ptr %v3789, align 8, !noalias !502
  %v3790 = getelementptr i64, ptr %v1003, i64 %v3464
  %v3791 = load i64, ptr %v3790, align 8, !noalias !502
  %v3792 = icmp slt i64 %v3791, %v93
  br i1 %v3792, label %v3793, label %v3453

v3793:
  %v3794 = icmp slt i64 %v3791, 0
  %v3795 = select i1 %v3794, i64 %v93, i64 0
  %v3796 = getelementptr double, ptr %v92, i64 %v3791
  %v3797 = getelementptr double, ptr %v3796, i64 %v3795
  %v3798 = load double, ptr %v3797, align 8, !noalias !502
  %v3799 = load double, ptr %v3787, align 8, !noalias !502
  %v3800 = fcmp olt double %v3799, %v3798
  %v3801 = select i1 %v3800, double %v3799, double %v3798
  store double %v3801, ptr %v3789, align 8, !noalias !502
  br label %v3453

v3453:
  %v3461 = phi i64 [ %v3460, %v3450 ], [ %v3460, %v3647 ], [ %v3765, %v3769 ], [ %v3765, %v3793 ]
  %v3459 = phi i1 [ %v3458, %v3450 ], [ %v3761, %v3647 ], [ %v3761, %v3769 ], [ %v3761, %v3793 ]
  %v3802 = icmp sgt i64 %v3456, 0
  %v3803 = sext i1 %v3802 to i64
  %v3457 = add nsw i64 %v3456, %v3803
  %v3804 = zext i1 %v3802 to i64
  %v3455 = add i64 %v3454, %v3804
  %v3452 = select i1 %v3802, i64 %v3454, i64 0
  br i1 %v3802, label %v3450, label %v3805

v1033:
  %v1032 = phi i64 [ %v1036, %v3237 ], [ %v3806, %v3805 ]
  %v1035 = phi i64 [ %v3449, %v3237 ], [ %v3461, %v3805 ]
  %v3807 = icmp sgt i64 %v1035, 0
  %v3808 = icmp sgt i64 %v1032, 0
  %v3809 = select i1 %v3807, i1 %v3808, i1 false
  br i1 %v3809, label %v1030, label %v451

v451:
  %v3810 = phi i64 [ %v446, %v309 ], [ %v1035, %v1033 ]
  br i1 %v307, label %v3811, label %v3812

v3812:
  %v3813 = mul i64 %v135, 168
  %v3814 = getelementptr i8, ptr %v133, i64 %v3813
  %v3815 = mul i64 %v135, 176
  %v3816 = getelementptr i8, ptr %v133, i64 %v3815
  %v3817 = add nsw i64 %v11, -1
  %v3818 = mul i64 %v135, 152
  %v3819 = getelementptr i8, ptr %v133, i64 %v3818
  br label %v3820

v3821:
  %v3822 = getelementptr double, ptr %v3814, i64 %v3823
  %v3824 = load double, ptr %v3822, align 8, !noalias !506
  %v3825 = fptosi double %v3824 to i64
  %v3826 = getelementptr double, ptr %v3816, i64 %v3823
  %v3827 = load double, ptr %v3826, align 8, !noalias !506
  %v3828 = fptosi double %v3827 to i64
  %v3829 = mul i64 %v3830, %v126
  %v3831 = getelementptr i64, ptr %v124, i64 %v3829
  %v3832 = load i64, ptr %v3831, align 8, !noalias !506
  %v3833 = add nsw i64 %v3832, %v3825
  store i64 %v3833, ptr %v3831, align 8, !noalias !506
  %v3834 = getelementptr i8, ptr %v3831, i64 24
  %v3835 = load i64, ptr %v3834, align 8, !noalias !506
  %v3836 = add nsw i64 %v3835, %v3828
  store i64 %v3836, ptr %v3834, align 8, !noalias !506
  %v3837 = getelementptr i8, ptr %v3831, i64 8
  %v3838 = load i64, ptr %v3837, align 8, !noalias !506
  %v3839 = add nsw i64 %v3828, %v3825
  %v3840 = mul nsw i64 %v3839, %v3817
  %v3841 = add nsw i64 %v3840, %v3825
  %v3842 = add nsw i64 %v3841, %v3838
  store i64 %v3842, ptr %v3837, align 8, !noalias !506
  store double 0.000000e+00, ptr %v3822, align 8, !noalias !506
  store double 0.000000e+00, ptr %v3826, align 8, !noalias !506
  %v3843 = getelementptr double, ptr %v3819, i64 %v3823
  %v3844 = load double, ptr %v3843, align 8, !noalias !506
  %v3845 = sitofp i64 %v3839 to double
  %v3846 = fsub double %v3844, %v3845
  store double %v3846, ptr %v3843, align 8, !noalias !506
  br label %v3847

v3847:
  %v3848 = icmp sgt i64 %v3849, 1
  br i1 %v3848, label %v3820, label %v3811

v3820:
  %v3823 = phi i64 [ 0, %v3812 ], [ %v3850, %v3847 ]
  %v3849 = phi i64 [ %v308, %v3812 ], [ %v3851, %v3847 ]
  %v3851 = add nsw i64 %v3849, -1
  %v3850 = add nsw i64 %v3823, 1
  %v3852 = getelementptr i64, ptr %v142, i64 %v3823
  %v3830 = load i64, ptr %v3852, align 8, !noalias !506
  %v3853 = icmp sgt i64 %v3830, -1
  br i1 %v3853, label %v3821, label %v3847

v3854:
  %v3855 = phi i32 [ 0, %v3811 ], [ %v3022, %v3024 ]
  ret i32 %v3855

v333:
  %v443 = phi i64 [ 0, %v310 ], [ %v442, %v340 ]
  %v445 = phi i64 [ %v308, %v310 ], [ %v3856, %v340 ]
  %v336 = phi i64 [ 0, %v310 ], [ %v3857, %v340 ]
  %v3856 = add nsw i64 %v445, -1
  %v3857 = add nsw i64 %v336, 1
  %v439 = getelementptr i64, ptr %v142, i64 %v336
  %v3858 = load i64, ptr %v439, align 8
  %v3859 = icmp slt i64 %v3858, 0
  br i1 %v3859, label %v334, label %v340

v1236:
  %v3860 = load i64, ptr %v6, align 8, !noalias !510
  %v3861 = inttoptr i64 %v3860 to ptr
  tail call void %v3861(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v533), !noalias !510
  br label %v1237

v1237:
  br i1 %v534, label %v3862, label %v3863

v3862:
  %v3864 = load double, ptr %v536, align 8, !noalias !513
  %v3865 = fcmp olt double %v3864, 5.000000e-01
  br i1 %v3865, label %v3866, label %v3867

v3866:
  br i1 %v537, label %v3868, label %v3869

v3868:
  br i1 %v549, label %v3870, label %v3871, !prof !370

v3872:
  %v3873 = icmp eq i64 %v3874, %v582
  br i1 %v3873, label %v3867, label %v3875

v3876:
  %v3877 = load i64, ptr %v559, align 8, !noalias !517
  %v3878 = icmp eq i64 %v3877, %v3874
  br i1 %v3878, label %v3879, label %v3880

v3879:
  %v3881 = load double, ptr %v561, align 8, !noalias !517
  %v3882 = fmul double %v3881, 1.000000e-03
  br label %v3880

v3880:
  %v3883 = phi double [ %v3882, %v3879 ], [ 0.000000e+00, %v3876 ]
  store double %v3883, ptr %v3884, align 8, !noalias !517
  br i1 %v537, label %v3885, label %v3886

v3887:
  %v3888 = phi i64 [ %v3889, %v3887 ], [ 0, %v3875 ]
  %v3889 = add nsw i64 %v3888, 1
  %v3890 = mul i64 %v3888, %v196
  %v3891 = getelementptr double, ptr %v193, i64 %v3890
  %v3892 = load double, ptr %v3891, align 8, !noalias !517
  %v3893 = tail call double @llvm.fabs.f64(double %v3892)
  %v3894 = fcmp ogt double %v3895, %v3893
  %v3896 = select i1 %v3894, double %v3895, double %v3893
  %v3897 = fcmp ogt double %v3896, 0.000000e+00
  %v3898 = fmul double %v3896, 1.200000e-05
  %v3899 = select i1 %v3897, double %v3898, double 1.200000e-05
  %v3900 = getelementptr i64, ptr %v266, i64 %v3888
  %v3901 = load i64, ptr %v3900, align 8, !noalias !517
  %v3902 = icmp eq i64 %v3901, %v3874
  %v3903 = select i1 %v3902, double %v3899, double 0.000000e+00
  %v3904 = getelementptr double, ptr %v3905, i64 %v3888
  store double %v3903, ptr %v3904, align 8, !noalias !517
  %v3906 = icmp eq i64 %v10, %v3889
  br i1 %v3906, label %v3876, label %v3887

v3907:
  %v3908 = getelementptr double, ptr %v575, i64 %v3909
  store double %v3910, ptr %v3908, align 8, !noalias !523
  br label %v3911

v3912:
  %v3913 = select i1 %v3914, i64 %v295, i64 0
  %v3915 = getelementptr i64, ptr %v294, i64 %v3916
  %v3917 = getelementptr i64, ptr %v3915, i64 %v3913
  %v3918 = load i64, ptr %v3917, align 8, !noalias !523
  %v3919 = icmp slt i64 %v3918, 0
  %v3920 = select i1 %v3919, i64 %v223, i64 0
  %v3921 = getelementptr double, ptr %v222, i64 %v3918
  %v3922 = getelementptr double, ptr %v3921, i64 %v3920
  store double %v3910, ptr %v3922, align 8, !noalias !523
  br label %v3911

v3911:
  %v3923 = icmp sgt i64 %v3924, 1
  br i1 %v3923, label %v3925, label %v3872

v3869:
  %v3926 = phi i64 [ %v3927, %v3869 ], [ 0, %v3866 ]
  %v3927 = add nsw i64 %v3926, 1
  %v3928 = mul i64 %v3926, %v196
  %v3929 = getelementptr double, ptr %v193, i64 %v3928
  %v3930 = load double, ptr %v3929, align 8, !noalias !523
  %v3931 = getelementptr double, ptr %v540, i64 %v3928
  store double %v3930, ptr %v3931, align 8, !noalias !523
  %v3932 = getelementptr double, ptr %v542, i64 %v3928
  store double 0.000000e+00, ptr %v3932, align 8, !noalias !523
  %v3933 = icmp eq i64 %v10, %v3927
  br i1 %v3933, label %v3868, label %v3869

v3934:
  %v3935 = phi i64 [ %v159, %v3936 ], [ %v3937, %v3938 ]
  %v3939 = sub i64 %v3935, %v3940
  %v3941 = tail call i64 @llvm.smax.i64(i64 %v3939, i64 0)
  %v3905 = getelementptr double, ptr %v158, i64 %v3940
  br i1 %v554, label %v3942, label %v3867

v3942:
  %v3943 = select i1 %v546, i64 %v3941, i64 0
  %v3944 = getelementptr double, ptr %v3905, i64 %v10
  %v3884 = getelementptr double, ptr %v3944, i64 %v3943
  br label %v3875

v3870:
  br label %v3871

v3871:
  %v3945 = phi i64 [ 0, %v3870 ], [ %v548, %v3868 ]
  br i1 %v550, label %v3946, label %v3947, !prof !120

v3947:
  br label %v3946

v3946:
  %v3940 = phi i64 [ %v159, %v3947 ], [ %v3945, %v3871 ]
  br i1 %v552, label %v3948, label %v3938, !prof !370

v3948:
  br label %v3938

v3938:
  %v3937 = phi i64 [ 0, %v3948 ], [ %v551, %v3946 ]
  br i1 %v553, label %v3934, label %v3936, !prof !120

v3936:
  br label %v3934

v3875:
  %v3874 = phi i64 [ 0, %v3942 ], [ %v3949, %v3872 ]
  %v3949 = add nsw i64 %v3874, 1
  %v3950 = load double, ptr %v556, align 8, !noalias !517
  %v3951 = load double, ptr %v23, align 8, !noalias !517
  %v3895 = fdiv double %v3950, %v3951
  br i1 %v537, label %v3876, label %v3887

v3952:
  %v3953 = load double, ptr %v133, align 8, !noalias !524
  %v3954 = load double, ptr %v3884, align 8, !noalias !524
  %v3955 = fmul double %v3954, 5.000000e-01
  %v3956 = fadd double %v3953, %v3955
  store double %v3956, ptr %v564, align 8, !noalias !524
  %v3957 = load i64, ptr %v6, align 8, !noalias !528
  %v3958 = inttoptr i64 %v3957 to ptr
  tail call void %v3958(ptr nonnull %v564, ptr %v567, ptr %v165, ptr %v172, ptr %v179, ptr %v577), !noalias !528
  br label %v3959

v3959:
  %v3960 = phi i64 [ %v3961, %v3959 ], [ 0, %v3952 ]
  %v3961 = add nsw i64 %v3960, 1
  %v3962 = mul i64 %v3960, %v196
  %v3963 = getelementptr double, ptr %v193, i64 %v3962
  %v3964 = load double, ptr %v3963, align 8, !noalias !524
  %v3965 = getelementptr double, ptr %v3905, i64 %v3960
  %v3966 = load double, ptr %v3965, align 8, !noalias !524
  %v3967 = fmul double %v3966, 5.000000e-01
  %v3968 = fsub double %v3964, %v3967
  %v3969 = getelementptr double, ptr %v568, i64 %v3962
  store double %v3968, ptr %v3969, align 8, !noalias !524
  %v3970 = icmp eq i64 %v10, %v3961
  br i1 %v3970, label %v3971, label %v3959

v3885:
  %v3972 = load double, ptr %v133, align 8, !noalias !524
  %v3973 = fmul double %v3883, 5.000000e-01
  %v3974 = fadd double %v3973, %v3972
  store double %v3974, ptr %v564, align 8, !noalias !524
  %v3975 = load i64, ptr %v6, align 8, !noalias !528
  %v3976 = inttoptr i64 %v3975 to ptr
  tail call void %v3976(ptr nonnull %v564, ptr %v567, ptr %v165, ptr %v172, ptr %v179, ptr %v579), !noalias !528
  br label %v3971

v3971:
  %v3977 = load double, ptr %v133, align 8, !noalias !524
  %v3978 = load double, ptr %v3884, align 8, !noalias !524
  %v3979 = fmul double %v3978, 5.000000e-01
  %v3980 = fsub double %v3977, %v3979
  store double %v3980, ptr %v564, align 8, !noalias !524
  %v3981 = load i64, ptr %v6, align 8, !noalias !528
  %v3982 = inttoptr i64 %v3981 to ptr
  tail call void %v3982(ptr nonnull %v564, ptr %v567, ptr %v165, ptr %v172, ptr %v179, ptr %v581), !noalias !528
  br i1 %v537, label %v3983, label %v3984

v3985:
  %v3986 = fsub double %v3987, %v3988
  br label %v3989

v3990:
  %v3991 = getelementptr double, ptr %v573, i64 %v3992
  %v3993 = load double, ptr %v3991, align 8, !noalias !524
  %v3994 = fsub double %v3987, %v3993
  %v3995 = fmul double %v3994, 2.000000e+00
  br label %v3989

v3989:
  %v3996 = phi double [ %v3995, %v3990 ], [ %v3986, %v3985 ]
  store double %v3996, ptr %v3997, align 8, !noalias !524
  %v3998 = icmp eq i64 %v10, %v3999
  br i1 %v3998, label %v3983, label %v3984

v3886:
  %v4000 = phi i64 [ %v4001, %v3886 ], [ 0, %v3880 ]
  %v4001 = add nsw i64 %v4000, 1
  %v4002 = mul i64 %v4000, %v196
  %v4003 = getelementptr double, ptr %v193, i64 %v4002
  %v4004 = load double, ptr %v4003, align 8, !noalias !524
  %v4005 = getelementptr double, ptr %v3905, i64 %v4000
  %v4006 = load double, ptr %v4005, align 8, !noalias !524
  %v4007 = fmul double %v4006, 5.000000e-01
  %v4008 = fadd double %v4004, %v4007
  %v4009 = getelementptr double, ptr %v568, i64 %v4002
  store double %v4008, ptr %v4009, align 8, !noalias !524
  %v4010 = icmp eq i64 %v10, %v4001
  br i1 %v4010, label %v3952, label %v3886

v3984:
  %v4011 = phi i64 [ %v3999, %v3989 ], [ 0, %v3971 ]
  %v3999 = add nsw i64 %v4011, 1
  %v3992 = mul i64 %v4011, %v196
  %v4012 = getelementptr double, ptr %v193, i64 %v3992
  %v4013 = load double, ptr %v4012, align 8, !noalias !524
  %v4014 = getelementptr double, ptr %v568, i64 %v3992
  store double %v4013, ptr %v4014, align 8, !noalias !524
  %v3997 = getelementptr double, ptr %v570, i64 %v3992
  %v3987 = load double, ptr %v3997, align 8, !noalias !524
  %v4015 = getelementptr double, ptr %v572, i64 %v3992
  %v3988 = load double, ptr %v4015, align 8, !noalias !524
  %v4016 = fsub double %v3988, %v3988
  %v4017 = fcmp oeq double %v4016, 0.000000e+00
  br i1 %v4017, label %v3985, label %v3990

v3983:
  %v4018 = getelementptr i64, ptr %v273, i64 %v3874
  %v4019 = load i64, ptr %v4018, align 8, !noalias !523
  %v4020 = getelementptr i8, ptr %v4018, i64 8
  %v4021 = load i64, ptr %v4020, align 8, !noalias !523
  %v4022 = sub i64 %v4021, %v4019
  %v4023 = icmp slt i64 %v4022, 1
  br i1 %v4023, label %v3872, label %v3925

v3925:
  %v3924 = phi i64 [ %v4024, %v3911 ], [ %v4022, %v3983 ]
  %v3916 = phi i64 [ %v4025, %v3911 ], [ %v4019, %v3983 ]
  %v4024 = add nsw i64 %v3924, -1
  %v4025 = add i64 %v3916, 1
  %v3914 = icmp slt i64 %v3916, 0
  %v4026 = select i1 %v3914, i64 %v281, i64 0
  %v4027 = getelementptr i64, ptr %v280, i64 %v3916
  %v4028 = getelementptr i64, ptr %v4027, i64 %v4026
  %v4029 = load i64, ptr %v4028, align 8, !noalias !523
  %v4030 = select i1 %v3914, i64 %v288, i64 0
  %v4031 = getelementptr i64, ptr %v287, i64 %v3916
  %v4032 = getelementptr i64, ptr %v4031, i64 %v4030
  %v4033 = load i64, ptr %v4032, align 8, !noalias !523
  %v4034 = icmp slt i64 %v4029, 0
  %v4035 = select i1 %v4034, i64 %v195, i64 0
  %v4036 = add i64 %v4035, %v4029
  %v3909 = mul i64 %v4036, %v196
  %v4037 = getelementptr double, ptr %v570, i64 %v3909
  %v4038 = load double, ptr %v4037, align 8, !noalias !523
  %v4039 = icmp slt i64 %v4033, 0
  %v4040 = select i1 %v4039, i64 %v3941, i64 0
  %v4041 = getelementptr double, ptr %v3905, i64 %v4033
  %v4042 = getelementptr double, ptr %v4041, i64 %v4040
  %v4043 = load double, ptr %v4042, align 8, !noalias !523
  %v4044 = fdiv double %v4038, %v4043
  %v4045 = fsub double %v4044, %v4044
  %v4046 = fcmp oeq double %v4045, 0.000000e+00
  %v3910 = select i1 %v4046, double %v4044, double 0.000000e+00
  %v4047 = icmp eq i64 %v4033, %v10
  br i1 %v4047, label %v3907, label %v3912

v3867:
  br i1 %v583, label %v4048, label %v3863

v4049:
  %v4050 = mul i64 %v4051, %v586
  %v4052 = icmp slt i64 %v4050, 0
  %v4053 = select i1 %v4052, i64 %v230, i64 0
  %v4054 = getelementptr double, ptr %v229, i64 %v4050
  %v4055 = getelementptr double, ptr %v4054, i64 %v4053
  %v4056 = load double, ptr %v4055, align 8, !noalias !513
  %v4057 = load double, ptr %v588, align 8, !noalias !513
  %v4058 = fadd double %v4056, %v4057
  store double %v4058, ptr %v4055, align 8, !noalias !513
  %v4059 = icmp eq i64 %v10, %v4060
  br i1 %v4059, label %v4061, label %v4048

v4062:
  %v4063 = icmp eq i64 %v4064, %v10
  br i1 %v4063, label %v3863, label %v4061

v4065:
  %v4066 = phi i64 [ %v4067, %v4061 ], [ %v4068, %v4069 ]
  %v4070 = getelementptr i64, ptr %v236, i64 %v4067
  store i64 %v4066, ptr %v4070, align 8, !noalias !531
  %v4071 = add nsw i64 %v4066, %v4072
  %v4073 = icmp slt i64 %v4071, 0
  %v4074 = select i1 %v4073, i64 %v230, i64 0
  %v4075 = getelementptr double, ptr %v229, i64 %v4071
  %v4076 = getelementptr double, ptr %v4075, i64 %v4074
  %v4077 = load double, ptr %v4076, align 8, !noalias !531
  %v4078 = load double, ptr %v4079, align 8, !noalias !531
  store double %v4077, ptr %v4079, align 8, !noalias !531
  store double %v4078, ptr %v4076, align 8, !noalias !531
  br i1 %v4080, label %v4081, label %v4082

v4081:
  %v4083 = sub i64 %v4084, %v4064
  %v4085 = icmp slt i64 %v4083, 1
  br i1 %v4085, label %v4062, label %v4086

v4087:
  %v4088 = icmp sgt i64 %v4089, 1
  br i1 %v4088, label %v4086, label %v4062

v4061:
  %v4067 = phi i64 [ %v4064, %v4062 ], [ 0, %v4049 ]
  %v4064 = add nsw i64 %v4067, 1
  %v4072 = mul nsw i64 %v4067, %v10
  %v4090 = add nsw i64 %v4067, %v253
  %v4091 = add nsw i64 %v4090, 1
  %v4092 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %v4091, i64 %v10)
  %v4093 = add i64 %v589, %v4090
  %v4084 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %v4093, i64 %v10)
  %v4094 = getelementptr double, ptr %v229, i64 %v4072
  %v4079 = getelementptr double, ptr %v4094, i64 %v4067
  %v4095 = sub i64 %v4092, %v4064
  %v4096 = tail call i64 @llvm.smax.i64(i64 %v4095, i64 0)
  %v4080 = icmp slt i64 %v4095, 1
  br i1 %v4080, label %v4065, label %v4097

v4097:
  %v4098 = load double, ptr %v4079, align 8, !noalias !531
  %v4099 = tail call double @llvm.fabs.f64(double %v4098)
  br label %v4069

v4069:
  %v4100 = phi i64 [ %v4068, %v4069 ], [ %v4067, %v4097 ]
  %v4101 = phi double [ %v4102, %v4069 ], [ %v4099, %v4097 ]
  %v4103 = phi i64 [ %v4104, %v4069 ], [ %v4096, %v4097 ]
  %v4105 = phi i64 [ %v4106, %v4069 ], [ %v4064, %v4097 ]
  %v4104 = add nsw i64 %v4103, -1
  %v4106 = add i64 %v4105, 1
  %v4107 = add nsw i64 %v4105, %v4072
  %v4108 = icmp slt i64 %v4107, 0
  %v4109 = select i1 %v4108, i64 %v230, i64 0
  %v4110 = getelementptr double, ptr %v229, i64 %v4107
  %v4111 = getelementptr double, ptr %v4110, i64 %v4109
  %v4112 = load double, ptr %v4111, align 8, !noalias !531
  %v4113 = tail call double @llvm.fabs.f64(double %v4112)
  %v4114 = fcmp ogt double %v4113, %v4101
  %v4102 = select i1 %v4114, double %v4113, double %v4101
  %v4068 = select i1 %v4114, i64 %v4105, i64 %v4100
  %v4115 = icmp sgt i64 %v4103, 1
  br i1 %v4115, label %v4069, label %v4065

v4082:
  %v4116 = phi i64 [ %v4117, %v4082 ], [ %v4096, %v4065 ]
  %v4118 = phi i64 [ %v4119, %v4082 ], [ %v4064, %v4065 ]
  %v4117 = add nsw i64 %v4116, -1
  %v4119 = add i64 %v4118, 1
  %v4120 = add nsw i64 %v4118, %v4072
  %v4121 = icmp slt i64 %v4120, 0
  %v4122 = select i1 %v4121, i64 %v230, i64 0
  %v4123 = getelementptr double, ptr %v229, i64 %v4120
  %v4124 = getelementptr double, ptr %v4123, i64 %v4122
  %v4125 = load double, ptr %v4124, align 8, !noalias !531
  %v4126 = load double, ptr %v4079, align 8, !noalias !531
  %v4127 = fdiv double %v4125, %v4126
  store double %v4127, ptr %v4124, align 8, !noalias !531
  %v4128 = icmp sgt i64 %v4116, 1
  br i1 %v4128, label %v4082, label %v4081

v4086:
  %v4089 = phi i64 [ %v4129, %v4087 ], [ %v4083, %v4081 ]
  %v4130 = phi i64 [ %v4131, %v4087 ], [ %v4064, %v4081 ]
  %v4129 = add nsw i64 %v4089, -1
  %v4131 = add i64 %v4130, 1
  %v4132 = mul nsw i64 %v4130, %v10
  %v4133 = add nsw i64 %v4132, %v4066
  %v4134 = icmp slt i64 %v4133, 0
  %v4135 = select i1 %v4134, i64 %v230, i64 0
  %v4136 = getelementptr double, ptr %v229, i64 %v4133
  %v4137 = getelementptr double, ptr %v4136, i64 %v4135
  %v4138 = load double, ptr %v4137, align 8, !noalias !531
  %v4139 = add nsw i64 %v4132, %v4067
  %v4140 = icmp slt i64 %v4139, 0
  %v4141 = select i1 %v4140, i64 %v230, i64 0
  %v4142 = getelementptr double, ptr %v229, i64 %v4139
  %v4143 = getelementptr double, ptr %v4142, i64 %v4141
  %v4144 = load double, ptr %v4143, align 8, !noalias !531
  store double %v4144, ptr %v4137, align 8, !noalias !531
  store double %v4138, ptr %v4143, align 8, !noalias !531
  %v4145 = fcmp oeq double %v4138, 0.000000e+00
  %v4146 = or i1 %v4080, %v4145
  br i1 %v4146, label %v4087, label %v4147

v4147:
  %v4148 = phi i64 [ %v4149, %v4147 ], [ %v4096, %v4086 ]
  %v4150 = phi i64 [ %v4151, %v4147 ], [ %v4064, %v4086 ]
  %v4149 = add nsw i64 %v4148, -1
  %v4151 = add i64 %v4150, 1
  %v4152 = add nsw i64 %v4150, %v4132
  %v4153 = icmp slt i64 %v4152, 0
  %v4154 = select i1 %v4153, i64 %v230, i64 0
  %v4155 = getelementptr double, ptr %v229, i64 %v4152
  %v4156 = getelementptr double, ptr %v4155, i64 %v4154
  %v4157 = load double, ptr %v4156, align 8, !noalias !531
  %v4158 = add nsw i64 %v4150, %v4072
  %v4159 = icmp slt i64 %v4158, 0
  %v4160 = select i1 %v4159, i64 %v230, i64 0
  %v4161 = getelementptr double, ptr %v229, i64 %v4158
  %v4162 = getelementptr double, ptr %v4161, i64 %v4160
  %v4163 = load double, ptr %v4162, align 8, !noalias !531
  %v4164 = fmul double %v4138, %v4163
  %v4165 = fsub double %v4157, %v4164
  store double %v4165, ptr %v4156, align 8, !noalias !531
  %v4166 = icmp sgt i64 %v4148, 1
  br i1 %v4166, label %v4147, label %v4087

v4048:
  %v4051 = phi i64 [ %v4060, %v4049 ], [ 0, %v3867 ]
  %v4060 = add nsw i64 %v4051, 1
  %v4167 = sub i64 %v4051, %v584
  %v4168 = tail call i64 @llvm.smax.i64(i64 %v4167, i64 0)
  %v4169 = add i64 %v585, %v4051
  %v4170 = tail call i64 @llvm.smin.i64(i64 %v4169, i64 %v10)
  %v4171 = sub i64 %v4170, %v4168
  %v4172 = icmp slt i64 %v4171, 1
  br i1 %v4172, label %v4049, label %v4173

v4173:
  %v4174 = mul nsw i64 %v4051, %v10
  br label %v4175

v4175:
  %v4176 = phi i64 [ %v4171, %v4173 ], [ %v4177, %v4175 ]
  %v4178 = phi i64 [ %v4168, %v4173 ], [ %v4179, %v4175 ]
  %v4177 = add nsw i64 %v4176, -1
  %v4179 = add i64 %v4178, 1
  %v4180 = add nsw i64 %v4178, %v4174
  %v4181 = icmp slt i64 %v4180, 0
  %v4182 = select i1 %v4181, i64 %v223, i64 0
  %v4183 = getelementptr double, ptr %v222, i64 %v4180
  %v4184 = getelementptr double, ptr %v4183, i64 %v4182
  %v4185 = load double, ptr %v4184, align 8, !noalias !513
  %v4186 = fneg double %v4185
  %v4187 = select i1 %v4181, i64 %v230, i64 0
  %v4188 = getelementptr double, ptr %v229, i64 %v4180
  %v4189 = getelementptr double, ptr %v4188, i64 %v4187
  store double %v4186, ptr %v4189, align 8, !noalias !513
  %v4190 = icmp sgt i64 %v4176, 1
  br i1 %v4190, label %v4175, label %v4049

v3863:
  br i1 %v593, label %v1257, label %v4191

v4192:
  br i1 %v599, label %v4193, label %v4194

v4194:
  %v4195 = mul i64 %v4196, %v600
  %v4197 = getelementptr double, ptr %v193, i64 %v4195
  br label %v4198

v4199:
  %v4200 = icmp slt i64 %v4201, 0
  %v4202 = select i1 %v4200, i64 %v251, i64 0
  %v4203 = getelementptr i64, ptr %v250, i64 %v4201
  %v4204 = getelementptr i64, ptr %v4203, i64 %v4202
  store i64 %v4205, ptr %v4204, align 8, !noalias !534
  %v4206 = add nsw i64 %v4201, 1
  br label %v4207

v4207:
  %v4208 = phi i64 [ %v4206, %v4199 ], [ %v4201, %v4209 ]
  %v4210 = icmp eq i64 %v10, %v4211
  br i1 %v4210, label %v4193, label %v4209

v4193:
  %v4212 = phi i64 [ 0, %v4192 ], [ %v4208, %v4207 ]
  %v4213 = icmp sgt i64 %v4212, 0
  %v4214 = icmp slt i64 %v4212, %v10
  %v4215 = and i1 %v4213, %v4214
  br i1 %v4215, label %v4216, label %v4217

v4216:
  %v4218 = phi i64 [ %v4219, %v4220 ], [ %v4212, %v4193 ]
  %v4221 = phi i64 [ %v4222, %v4220 ], [ 0, %v4193 ]
  %v4223 = getelementptr i64, ptr %v250, i64 %v4221
  %v4224 = load i64, ptr %v4223, align 8, !noalias !534
  %v4222 = add nsw i64 %v4221, 1
  %v4225 = sub nsw i64 %v4224, %v254
  %v4226 = tail call i64 @llvm.smax.i64(i64 %v4225, i64 0)
  %v4227 = add i64 %v607, %v4224
  %v4228 = tail call i64 @llvm.smin.i64(i64 %v4227, i64 %v10)
  %v4229 = sub i64 %v4228, %v4226
  %v4230 = icmp slt i64 %v4229, 1
  br i1 %v4230, label %v4220, label %v4231

v4231:
  %v4232 = mul nsw i64 %v4224, %v10
  br label %v4233

v4234:
  %v4235 = icmp slt i64 %v4236, 0
  %v4237 = select i1 %v4235, i64 %v244, i64 0
  %v4238 = getelementptr i64, ptr %v243, i64 %v4236
  %v4239 = getelementptr i64, ptr %v4238, i64 %v4237
  %v4240 = load i64, ptr %v4239, align 8, !noalias !534
  %v4241 = icmp eq i64 %v4240, 0
  br i1 %v4241, label %v4242, label %v4243

v4242:
  store i64 1, ptr %v4239, align 8, !noalias !534
  %v4244 = getelementptr i64, ptr %v250, i64 %v4245
  store i64 %v4236, ptr %v4244, align 8, !noalias !534
  %v4246 = add nsw i64 %v4245, 1
  br label %v4243

v4243:
  %v4247 = phi i64 [ %v4245, %v4234 ], [ %v4246, %v4242 ], [ %v4245, %v4233 ]
  %v4248 = icmp sgt i64 %v4249, 1
  br i1 %v4248, label %v4233, label %v4220

v4220:
  %v4219 = phi i64 [ %v4218, %v4216 ], [ %v4247, %v4243 ]
  %v4250 = icmp slt i64 %v4222, %v4219
  %v4251 = icmp slt i64 %v4219, %v10
  %v4252 = and i1 %v4250, %v4251
  br i1 %v4252, label %v4216, label %v4217

v4209:
  %v4201 = phi i64 [ %v4208, %v4207 ], [ 0, %v4198 ]
  %v4205 = phi i64 [ %v4211, %v4207 ], [ 0, %v4198 ]
  %v4211 = add nsw i64 %v4205, 1
  %v4253 = getelementptr double, ptr %v606, i64 %v4205
  %v4254 = load double, ptr %v4253, align 8, !noalias !534
  %v4255 = fcmp une double %v4254, 0.000000e+00
  %v4256 = getelementptr i64, ptr %v243, i64 %v4205
  %v4257 = zext i1 %v4255 to i64
  store i64 %v4257, ptr %v4256, align 8, !noalias !534
  br i1 %v4255, label %v4199, label %v4207

v4233:
  %v4245 = phi i64 [ %v4218, %v4231 ], [ %v4247, %v4243 ]
  %v4249 = phi i64 [ %v4229, %v4231 ], [ %v4258, %v4243 ]
  %v4236 = phi i64 [ %v4226, %v4231 ], [ %v4259, %v4243 ]
  %v4258 = add nsw i64 %v4249, -1
  %v4259 = add i64 %v4236, 1
  %v4260 = add nsw i64 %v4236, %v4232
  %v4261 = icmp slt i64 %v4260, 0
  %v4262 = select i1 %v4261, i64 %v223, i64 0
  %v4263 = getelementptr double, ptr %v222, i64 %v4260
  %v4264 = getelementptr double, ptr %v4263, i64 %v4262
  %v4265 = load double, ptr %v4264, align 8, !noalias !534
  %v4266 = fcmp une double %v4265, 0.000000e+00
  br i1 %v4266, label %v4234, label %v4243

v4267:
  %v4268 = select i1 %v4269, i64 %v195, i64 0
  %v4270 = add i64 %v4268, %v4271
  %v4272 = mul i64 %v4270, %v196
  %v4273 = getelementptr double, ptr %v611, i64 %v4272
  %v4274 = load double, ptr %v4273, align 8, !noalias !540
  br label %v4275

v4275:
  %v4276 = phi double [ %v4274, %v4267 ], [ 0.000000e+00, %v4277 ]
  %v4278 = mul i64 %v4279, %v196
  %v4280 = getelementptr double, ptr %v4281, i64 %v4278
  store double %v4276, ptr %v4280, align 8, !noalias !540
  %v4282 = icmp eq i64 %v10, %v4283
  br i1 %v4282, label %v4284, label %v4277

v4198:
  %v4285 = phi i64 [ 0, %v4194 ], [ %v4286, %v4198 ]
  %v4286 = add nsw i64 %v4285, 1
  %v4287 = mul i64 %v4285, %v196
  %v4288 = getelementptr double, ptr %v4197, i64 %v4287
  %v4289 = load double, ptr %v4288, align 8, !noalias !540
  %v4290 = getelementptr double, ptr %v602, i64 %v4287
  %v4291 = load double, ptr %v4290, align 8, !noalias !540
  %v4292 = fadd double %v4289, %v4291
  %v4293 = getelementptr i64, ptr %v259, i64 %v4285
  %v4294 = load i64, ptr %v4293, align 8, !noalias !540
  %v4295 = icmp slt i64 %v4294, 0
  %v4296 = select i1 %v4295, i64 %v195, i64 0
  %v4297 = add i64 %v4296, %v4294
  %v4298 = mul i64 %v4297, %v196
  %v4299 = getelementptr double, ptr %v604, i64 %v4298
  store double %v4292, ptr %v4299, align 8, !noalias !540
  %v4300 = icmp eq i64 %v10, %v4286
  br i1 %v4300, label %v4209, label %v4198

v4217:
  br i1 %v599, label %v4284, label %v4301

v4302:
  %v4303 = icmp eq i64 %v10, %v4304
  br i1 %v4303, label %v4305, label %v4301

v4306:
  %v4307 = icmp sgt i64 %v4308, 1
  br i1 %v4307, label %v4305, label %v4309

v4309:
  %v4310 = mul i64 %v612, %v4196
  %v4281 = getelementptr double, ptr %v193, i64 %v4310
  br label %v4277

v4301:
  %v4311 = phi i64 [ %v4304, %v4302 ], [ 0, %v4217 ]
  %v4304 = add nsw i64 %v4311, 1
  %v4312 = getelementptr i64, ptr %v236, i64 %v4311
  %v4313 = load i64, ptr %v4312, align 8, !noalias !541
  %v4314 = add nsw i64 %v4313, %v605
  %v4315 = icmp slt i64 %v4314, 0
  %v4316 = select i1 %v4315, i64 %v159, i64 0
  %v4317 = getelementptr double, ptr %v158, i64 %v4314
  %v4318 = getelementptr double, ptr %v4317, i64 %v4316
  %v4319 = load double, ptr %v4318, align 8, !noalias !541
  %v4320 = getelementptr double, ptr %v609, i64 %v4311
  %v4321 = load double, ptr %v4320, align 8, !noalias !541
  store double %v4321, ptr %v4318, align 8, !noalias !541
  store double %v4319, ptr %v4320, align 8, !noalias !541
  %v4322 = add i64 %v608, %v4311
  %v4323 = tail call i64 @llvm.smin.i64(i64 %v4322, i64 %v10)
  %v4324 = sub i64 %v4323, %v4304
  %v4325 = icmp slt i64 %v4324, 1
  br i1 %v4325, label %v4302, label %v4326

v4326:
  %v4327 = mul nsw i64 %v4311, %v10
  br label %v4328

v4328:
  %v4329 = phi i64 [ %v4324, %v4326 ], [ %v4330, %v4328 ]
  %v4331 = phi i64 [ %v4304, %v4326 ], [ %v4332, %v4328 ]
  %v4330 = add nsw i64 %v4329, -1
  %v4332 = add i64 %v4331, 1
  %v4333 = add nsw i64 %v4331, %v605
  %v4334 = icmp slt i64 %v4333, 0
  %v4335 = select i1 %v4334, i64 %v159, i64 0
  %v4336 = getelementptr double, ptr %v158, i64 %v4333
  %v4337 = getelementptr double, ptr %v4336, i64 %v4335
  %v4338 = load double, ptr %v4337, align 8, !noalias !541
  %v4339 = add nsw i64 %v4331, %v4327
  %v4340 = icmp slt i64 %v4339, 0
  %v4341 = select i1 %v4340, i64 %v230, i64 0
  %v4342 = getelementptr double, ptr %v229, i64 %v4339
  %v4343 = getelementptr double, ptr %v4342, i64 %v4341
  %v4344 = load double, ptr %v4343, align 8, !noalias !541
  %v4345 = fmul double %v4319, %v4344
  %v4346 = fsub double %v4338, %v4345
  store double %v4346, ptr %v4337, align 8, !noalias !541
  %v4347 = icmp sgt i64 %v4329, 1
  br i1 %v4347, label %v4328, label %v4302

v4305:
  %v4308 = phi i64 [ %v4348, %v4306 ], [ %v10, %v4302 ]
  %v4348 = add nsw i64 %v4308, -1
  %v4349 = add nsw i64 %v4348, %v605
  %v4350 = icmp slt i64 %v4349, 0
  %v4351 = select i1 %v4350, i64 %v159, i64 0
  %v4352 = getelementptr double, ptr %v158, i64 %v4349
  %v4353 = getelementptr double, ptr %v4352, i64 %v4351
  %v4354 = load double, ptr %v4353, align 8, !noalias !541
  %v4355 = mul nsw i64 %v4348, %v10
  %v4356 = add nsw i64 %v4355, %v4348
  %v4357 = icmp slt i64 %v4356, 0
  %v4358 = select i1 %v4357, i64 %v230, i64 0
  %v4359 = getelementptr double, ptr %v229, i64 %v4356
  %v4360 = getelementptr double, ptr %v4359, i64 %v4358
  %v4361 = load double, ptr %v4360, align 8, !noalias !541
  %v4362 = fdiv double %v4354, %v4361
  store double %v4362, ptr %v4353, align 8, !noalias !541
  %v4363 = sub i64 %v4348, %v610
  %v4364 = tail call i64 @llvm.smax.i64(i64 %v4363, i64 0)
  %v4365 = sub i64 %v4348, %v4364
  %v4366 = icmp slt i64 %v4365, 1
  br i1 %v4366, label %v4306, label %v4367

v4367:
  %v4368 = phi i64 [ %v4369, %v4367 ], [ %v4365, %v4305 ]
  %v4370 = phi i64 [ %v4371, %v4367 ], [ %v4364, %v4305 ]
  %v4369 = add nsw i64 %v4368, -1
  %v4371 = add i64 %v4370, 1
  %v4372 = add nsw i64 %v4370, %v605
  %v4373 = icmp slt i64 %v4372, 0
  %v4374 = select i1 %v4373, i64 %v159, i64 0
  %v4375 = getelementptr double, ptr %v158, i64 %v4372
  %v4376 = getelementptr double, ptr %v4375, i64 %v4374
  %v4377 = load double, ptr %v4376, align 8, !noalias !541
  %v4378 = add nsw i64 %v4370, %v4355
  %v4379 = icmp slt i64 %v4378, 0
  %v4380 = select i1 %v4379, i64 %v230, i64 0
  %v4381 = getelementptr double, ptr %v229, i64 %v4378
  %v4382 = getelementptr double, ptr %v4381, i64 %v4380
  %v4383 = load double, ptr %v4382, align 8, !noalias !541
  %v4384 = fmul double %v4362, %v4383
  %v4385 = fsub double %v4377, %v4384
  store double %v4385, ptr %v4376, align 8, !noalias !541
  %v4386 = icmp sgt i64 %v4368, 1
  br i1 %v4386, label %v4367, label %v4306

v4277:
  %v4279 = phi i64 [ 0, %v4309 ], [ %v4283, %v4275 ]
  %v4283 = add nsw i64 %v4279, 1
  %v4387 = getelementptr i64, ptr %v259, i64 %v4279
  %v4271 = load i64, ptr %v4387, align 8, !noalias !540
  %v4269 = icmp slt i64 %v4271, 0
  %v4388 = select i1 %v4269, i64 %v244, i64 0
  %v4389 = getelementptr i64, ptr %v243, i64 %v4271
  %v4390 = getelementptr i64, ptr %v4389, i64 %v4388
  %v4391 = load i64, ptr %v4390, align 8, !noalias !540
  %v4392 = icmp eq i64 %v4391, 0
  br i1 %v4392, label %v4275, label %v4267

v4284:
  %v4393 = icmp eq i64 %v4394, %v591
  br i1 %v4393, label %v1257, label %v4191

v1257:
  %v4395 = load i64, ptr %v613, align 8, !noalias !545
  %v4396 = inttoptr i64 %v4395 to ptr
  tail call void %v4396(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !545
  br i1 %v307, label %v1255, label %v1245

v4191:
  %v4394 = phi i64 [ %v4196, %v4284 ], [ 1, %v3863 ]
  %v4196 = add i64 %v4394, 1
  %v4397 = getelementptr i64, ptr %v6, i64 %v4394
  %v4398 = getelementptr i8, ptr %v4397, i64 104
  %v4399 = load i64, ptr %v4398, align 8, !noalias !548
  %v4400 = inttoptr i64 %v4399 to ptr
  tail call void %v4400(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !548
  %v4401 = load i64, ptr %v6, align 8, !noalias !551
  %v4402 = mul nsw i64 %v4196, %v596
  %v4403 = getelementptr double, ptr %v158, i64 %v4402
  %v4404 = inttoptr i64 %v4401 to ptr
  tail call void %v4404(ptr %v595, ptr %v598, ptr %v165, ptr %v172, ptr %v179, ptr %v4403), !noalias !551
  br i1 %v534, label %v4192, label %v4284

v1245:
  %v1246 = phi i1 [ %v1252, %v1247 ], [ %v1233, %v1257 ]
  %v4405 = phi i1 [ %v1244, %v1247 ], [ false, %v1257 ]
  %v1254 = phi i64 [ %v4406, %v1247 ], [ %v308, %v1257 ]
  %v1240 = phi i64 [ %v4407, %v1247 ], [ 0, %v1257 ]
  %v4406 = add nsw i64 %v1254, -1
  %v4407 = add nsw i64 %v1240, 1
  br i1 %v4405, label %v1243, label %v1238

v1348:
  %v1358 = xor i1 %v1343, true
  %v4408 = xor i1 %v1344, true
  %v1360 = select i1 %v4408, i1 true, i1 %v640
  br label %v1261

v3024:
  store ptr %v3021, ptr %v1, align 8
  br label %v3854

v3023:
  %v4409 = select i1 %v1258, i1 %v1256, i1 false
  %v4410 = xor i1 %v4409, true
  %v4411 = or i1 %v307, %v4410
  br i1 %v4411, label %v3144, label %v3145

v3805:
  %v3806 = select i1 %v3459, i64 0, i64 %v1036
  br label %v1033

v3811:
  store i64 %v3810, ptr %v0, align 8
  br label %v3854
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc range(i32 0, 2) i32 @_ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr noalias nonnull %v0, ptr noalias nonnull %v1, i64 %v2, ptr readonly %v3, i64 %v4, ptr %v5, i64 %v6, i64 %v7, ptr %v8, i64 %v9, ptr %v10, i64 %v11, ptr readonly %v12, i64 %v13, i64 %v14, i64 %v15, double %v16) unnamed_addr {
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
  tail call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %v0, i8 0, i64 32, i1 false)
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
  %v72 = load double, ptr %v71, align 8, !noalias !554
  %v73 = getelementptr double, ptr %v64, i64 %v66
  %v74 = load double, ptr %v73, align 8, !noalias !554
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
  %v82 = getelementptr double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v81
  %v83 = getelementptr i8, ptr %v82, i64 72
  %v84 = load double, ptr %v83, align 8
  %v85 = fcmp ogt double %v84, %v16
  %v86 = select i1 %v85, double %v84, double %v16
  %v87 = getelementptr double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v79
  %v88 = getelementptr i8, ptr %v87, i64 72
  %v89 = load double, ptr %v88, align 8
  %v90 = icmp slt i64 %v15, 1
  br i1 %v90, label %v91, label %v92

v93:
  %v94 = load double, ptr %v22, align 8
  %v95 = tail call double @llvm.fabs.f64(double %v94)
  %v96 = fmul double %v95, 1.000000e-15
  %v97 = fdiv double %v96, %v98
  %v99 = tail call i64 @llvm.smax.i64(i64 %v15, i64 0)
  %v100 = mul i64 %v15, %v14
  %v101 = getelementptr double, ptr %v12, i64 %v15
  %v102 = shl i64 %v15, 4
  %v103 = getelementptr i8, ptr %v12, i64 %v102
  %v104 = tail call i64 @llvm.smin.i64(i64 range(i64 -1, 9) %v105, i64 7)
  %v106 = sub nsw i64 %v104, %v49
  %v107 = tail call i64 @llvm.smax.i64(i64 %v106, i64 -1)
  %v108 = add nsw i64 %v107, 1
  %v109 = icmp ult i64 %v106, 9223372036854775807
  %v110 = zext i1 %v109 to i64
  %v111 = add nsw i64 %v49, %v110
  %v112 = sext i1 %v109 to i64
  %v113 = add nsw i64 %v108, %v112
  %v114 = select i1 %v109, i64 %v49, i64 0
  %v115 = shl i64 %v100, 4
  %v116 = shl i64 %v100, 5
  %v117 = mul i64 %v100, 48
  %v118 = shl i64 %v100, 6
  %v119 = mul i64 %v100, 24
  %v120 = mul i64 %v100, 40
  %v121 = mul i64 %v100, 56
  br label %v122

v122:
  %v123 = phi i64 [ 0, %v93 ], [ %v124, %v125 ]
  %v126 = phi i64 [ %v99, %v93 ], [ %v127, %v125 ]
  %v128 = phi ptr [ null, %v93 ], [ %v129, %v125 ]
  %v130 = icmp sgt i64 %v126, 0
  %v131 = zext i1 %v130 to i64
  %v124 = add i64 %v123, %v131
  %v132 = sext i1 %v130 to i64
  %v127 = add nsw i64 %v126, %v132
  br i1 %v130, label %v133, label %v134

v133:
  %v135 = icmp slt i64 %v123, 0
  %v136 = select i1 %v135, i64 %v15, i64 0
  %v137 = add i64 %v136, %v123
  %v138 = getelementptr double, ptr %v101, i64 %v137
  %v139 = getelementptr double, ptr %v138, i64 %v100
  %v140 = load double, ptr %v139, align 8, !noalias !558
  %v141 = load double, ptr %v138, align 8, !noalias !558
  %v142 = fmul double %v141, 0x3FDDF27AAAADCB3A
  %v143 = fsub double %v140, %v142
  %v144 = getelementptr i8, ptr %v138, i64 %v115
  %v145 = load double, ptr %v144, align 8, !noalias !558
  %v146 = fmul double %v145, 0x3FEC575F1EBC4F2F
  %v147 = fsub double %v143, %v146
  %v148 = getelementptr i8, ptr %v138, i64 %v116
  %v149 = load double, ptr %v148, align 8, !noalias !558
  %v150 = fmul double %v149, 0x3FE1306AA3D795F4
  %v151 = fadd double %v147, %v150
  %v152 = getelementptr i8, ptr %v138, i64 %v117
  %v153 = load double, ptr %v152, align 8, !noalias !558
  %v154 = fmul double %v153, 0x3FCCB9F574BDCC3A
  %v155 = fsub double %v151, %v154
  %v156 = getelementptr i8, ptr %v138, i64 %v118
  %v157 = load double, ptr %v156, align 8, !noalias !558
  %v158 = fmul double %v157, 0x3FA4EAF2D6B11E79
  %v159 = fadd double %v155, %v158
  %v160 = tail call double @llvm.fabs.f64(double %v159)
  %v161 = fcmp ogt double %v160, 0.000000e+00
  %v162 = select i1 %v161, double %v160, double 0.000000e+00
  %v163 = getelementptr i8, ptr %v138, i64 %v119
  %v164 = load double, ptr %v163, align 8, !noalias !558
  %v165 = fmul double %v141, 0x3FA5118805F8B876
  %v166 = fadd double %v164, %v165
  %v167 = fmul double %v145, 0x3FE51326698BC5BD
  %v168 = fsub double %v166, %v167
  %v169 = fmul double %v149, 0x3FDF97DED30D4572
  %v170 = fsub double %v168, %v169
  %v171 = fmul double %v153, 0x3FC0DA0C684D1D67
  %v172 = fadd double %v170, %v171
  %v173 = fmul double %v157, 0x3F9510B8EC0D4D92
  %v174 = fsub double %v172, %v173
  %v175 = tail call double @llvm.fabs.f64(double %v174)
  %v176 = fcmp ogt double %v175, %v162
  %v177 = select i1 %v176, double %v175, double %v162
  %v178 = getelementptr i8, ptr %v138, i64 %v120
  %v179 = load double, ptr %v178, align 8, !noalias !558
  %v180 = fmul double %v141, 0x3F9635A30F8F142F
  %v181 = fsub double %v179, %v180
  %v182 = fmul double %v145, 0x3FC1EAE0FF33D241
  %v183 = fadd double %v181, %v182
  %v184 = fmul double %v149, 0x3FE1625D59218460
  %v185 = fsub double %v183, %v184
  %v186 = fmul double %v153, 0x3FE3BBC3E8A29641
  %v187 = fsub double %v185, %v186
  %v188 = fmul double %v157, 0x3FA55161A739EB34
  %v189 = fadd double %v187, %v188
  %v190 = tail call double @llvm.fabs.f64(double %v189)
  %v191 = fcmp ogt double %v190, %v177
  %v192 = select i1 %v191, double %v190, double %v177
  %v193 = getelementptr i8, ptr %v138, i64 %v121
  %v194 = load double, ptr %v193, align 8, !noalias !558
  %v195 = fmul double %v141, 0x3FA4F0C0BB579409
  %v196 = fadd double %v194, %v195
  %v197 = fmul double %v145, 0x3FCD2266FBC0D976
  %v198 = fsub double %v196, %v197
  %v199 = fmul double %v149, 0x3FE1F2DB6FEE3151
  %v200 = fadd double %v198, %v199
  %v201 = fmul double %v153, 0x3FF0C05015964CBE
  %v202 = fsub double %v200, %v201
  %v203 = fmul double %v157, 0x3FD4F15B230DB570
  %v204 = fsub double %v202, %v203
  %v205 = tail call double @llvm.fabs.f64(double %v204)
  %v206 = fcmp ogt double %v205, %v192
  %v207 = select i1 %v206, double %v205, double %v192
  %v208 = getelementptr double, ptr %v103, i64 %v137
  %v209 = load double, ptr %v208, align 8, !noalias !565
  %v210 = tail call double @llvm.fabs.f64(double %v209)
  %v211 = fsub double %v140, %v141
  %v212 = tail call double @llvm.fabs.f64(double %v211)
  %v213 = fmul double %v97, %v212
  %v214 = fadd double %v213, %v210
  %v215 = fsub double %v145, %v140
  %v216 = tail call double @llvm.fabs.f64(double %v215)
  %v217 = fmul double %v97, %v216
  %v218 = fadd double %v217, %v214
  %v219 = fsub double %v164, %v145
  %v220 = tail call double @llvm.fabs.f64(double %v219)
  %v221 = fmul double %v97, %v220
  %v222 = fadd double %v221, %v218
  %v223 = fsub double %v149, %v164
  %v224 = tail call double @llvm.fabs.f64(double %v223)
  %v225 = fmul double %v97, %v224
  %v226 = fadd double %v225, %v222
  %v227 = fsub double %v179, %v149
  %v228 = tail call double @llvm.fabs.f64(double %v227)
  %v229 = fmul double %v97, %v228
  %v230 = fadd double %v229, %v226
  %v231 = fsub double %v153, %v179
  %v232 = tail call double @llvm.fabs.f64(double %v231)
  %v233 = fmul double %v97, %v232
  %v234 = fadd double %v233, %v230
  %v235 = fsub double %v194, %v153
  %v236 = tail call double @llvm.fabs.f64(double %v235)
  %v237 = fmul double %v97, %v236
  %v238 = fadd double %v237, %v234
  %v239 = fsub double %v157, %v194
  %v240 = tail call double @llvm.fabs.f64(double %v239)
  %v241 = fmul double %v97, %v240
  %v242 = fadd double %v241, %v238
  br i1 %v109, label %v243, label %v244

v243:
  %v245 = fmul double %v207, 1.000000e+01
  br label %v246

v246:
  %v247 = phi i64 [ %v114, %v243 ], [ %v248, %v249 ]
  %v250 = phi i64 [ %v113, %v243 ], [ %v251, %v249 ]
  %v252 = phi i64 [ %v111, %v243 ], [ %v253, %v249 ]
  %v254 = phi double [ 0x7FF0000000000000, %v243 ], [ %v255, %v249 ]
  %v256 = add nsw i64 %v247, -1
  %v257 = icmp sgt i64 %v247, 0
  %v258 = select i1 %v257, i64 0, i64 %v13
  %v259 = add i64 %v256, %v258
  %v260 = mul i64 %v259, %v100
  %v261 = getelementptr double, ptr %v138, i64 %v260
  %v262 = load double, ptr %v261, align 8, !noalias !566
  %v263 = icmp slt i64 %v247, 0
  %v264 = select i1 %v263, i64 %v13, i64 0
  %v265 = add i64 %v264, %v247
  %v266 = mul i64 %v265, %v100
  %v267 = getelementptr double, ptr %v138, i64 %v266
  %v268 = load double, ptr %v267, align 8, !noalias !566
  %v269 = fcmp olt double %v268, %v254
  %v270 = select i1 %v269, double %v268, double %v254
  %v271 = icmp slt i64 %v247, %v105
  br i1 %v271, label %v272, label %v249

v272:
  %v273 = add nsw i64 %v247, 1
  %v274 = icmp slt i64 %v247, -1
  %v275 = select i1 %v274, i64 %v13, i64 0
  %v276 = add i64 %v273, %v275
  %v277 = mul i64 %v276, %v100
  %v278 = getelementptr double, ptr %v138, i64 %v277
  %v279 = load double, ptr %v278, align 8, !noalias !566
  %v280 = fsub double %v262, %v268
  %v281 = tail call double @llvm.fabs.f64(double %v280)
  %v282 = fsub double %v279, %v268
  %v283 = tail call double @llvm.fabs.f64(double %v282)
  %v284 = fadd double %v281, %v283
  %v285 = fmul double %v284, 3.000000e+00
  %v286 = fadd double %v245, %v285
  %v287 = fcmp olt double %v268, %v286
  br i1 %v287, label %v288, label %v249

v288:
  %v289 = add i64 %v247, 9
  %v290 = icmp ult i64 %v289, 18
  br i1 %v290, label %v291, label %v244

v292:
  %v293 = fneg double %v294
  %v295 = fmul double %v296, 5.000000e-01
  %v297 = fdiv double %v295, %v298
  %v299 = fcmp ogt double %v297, %v293
  %v300 = fcmp olt double %v297, %v301
  %v302 = and i1 %v299, %v300
  br i1 %v302, label %v303, label %v249

v303:
  %v304 = fmul double %v296, 3.750000e-01
  %v305 = fmul double %v296, %v304
  %v306 = fdiv double %v305, %v298
  %v307 = fsub double %v268, %v306
  %v308 = fcmp olt double %v307, %v270
  %v309 = select i1 %v308, double %v307, double %v270
  br label %v249

v249:
  %v255 = phi double [ %v270, %v292 ], [ %v309, %v303 ], [ %v270, %v246 ], [ %v270, %v310 ], [ %v270, %v272 ]
  %v311 = icmp sgt i64 %v250, 0
  %v312 = zext i1 %v311 to i64
  %v253 = add i64 %v252, %v312
  %v313 = sext i1 %v311 to i64
  %v251 = add nsw i64 %v250, %v313
  %v248 = select i1 %v311, i64 %v252, i64 0
  br i1 %v311, label %v246, label %v244

v291:
  %v314 = add i64 %v247, 8
  %v315 = icmp ult i64 %v314, 18
  br i1 %v315, label %v316, label %v244

v316:
  %v317 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v289
  %v318 = load double, ptr %v317, align 8
  %v319 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v314
  %v320 = load double, ptr %v319, align 8
  %v301 = fsub double %v318, %v320
  %v321 = add i64 %v247, 10
  %v322 = icmp ult i64 %v321, 18
  br i1 %v322, label %v323, label %v244

v323:
  %v324 = add i64 %v247, 9
  %v325 = icmp ult i64 %v324, 18
  br i1 %v325, label %v310, label %v244

v310:
  %v326 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v321
  %v327 = load double, ptr %v326, align 8
  %v328 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v324
  %v329 = load double, ptr %v328, align 8
  %v294 = fsub double %v327, %v329
  %v330 = fdiv double %v282, %v294
  %v331 = fsub double %v268, %v262
  %v332 = fdiv double %v331, %v301
  %v333 = fsub double %v330, %v332
  %v334 = fadd double %v301, %v294
  %v298 = fdiv double %v333, %v334
  %v335 = fmul double %v301, %v298
  %v296 = fadd double %v332, %v335
  %v336 = fcmp ogt double %v298, 0.000000e+00
  br i1 %v336, label %v292, label %v249

v244:
  %v337 = phi i1 [ false, %v133 ], [ false, %v249 ], [ true, %v288 ], [ true, %v291 ], [ true, %v316 ], [ true, %v323 ]
  %v338 = phi double [ 0x7FF0000000000000, %v133 ], [ %v255, %v249 ], [ 0.000000e+00, %v288 ], [ 0.000000e+00, %v291 ], [ 0.000000e+00, %v316 ], [ 0.000000e+00, %v323 ]
  %v129 = phi ptr [ %v128, %v133 ], [ %v128, %v249 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.9, %v288 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.9, %v291 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.9, %v316 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.9, %v323 ]
  %v339 = phi i32 [ 0, %v133 ], [ 0, %v249 ], [ 1, %v288 ], [ 1, %v291 ], [ 1, %v316 ], [ 1, %v323 ]
  br i1 %v337, label %v134, label %v340, !prof !370

v125:
  %v341 = fcmp ule double %v207, %v242
  %v342 = fmul double %v207, 1.000000e+01
  %v343 = fcmp ugt double %v338, %v342
  %v344 = select i1 %v341, i1 true, i1 %v343
  br i1 %v344, label %v122, label %v134

v340:
  %v345 = fneg double %v242
  %v346 = fcmp olt double %v338, %v345
  br i1 %v346, label %v134, label %v125

v134:
  %v347 = phi i1 [ true, %v122 ], [ false, %v125 ], [ false, %v340 ], [ true, %v244 ]
  %v348 = phi ptr [ null, %v122 ], [ null, %v125 ], [ null, %v340 ], [ %v129, %v244 ]
  %v349 = phi i32 [ 0, %v122 ], [ 0, %v125 ], [ 0, %v340 ], [ %v339, %v244 ]
  %v350 = icmp eq i32 %v349, 0
  br i1 %v350, label %v351, label %v38, !prof !120

v352:
  %v353 = fmul double %v98, 5.000000e-01
  store double 0.000000e+00, ptr %v31, align 8, !noalias !570
  %v354 = shl i64 %v9, 5
  %v355 = getelementptr i8, ptr %v8, i64 %v354
  store double 0.000000e+00, ptr %v355, align 8, !noalias !570
  %v356 = getelementptr double, ptr %v8, i64 %v9
  store double %v353, ptr %v356, align 8, !noalias !570
  %v357 = load i64, ptr %v10, align 8, !noalias !570
  %v358 = icmp slt i64 %v357, 0
  %v359 = select i1 %v358, i64 %v6, i64 0
  %v360 = add i64 %v359, %v357
  %v361 = mul i64 %v360, %v7
  %v362 = getelementptr i64, ptr %v5, i64 %v361
  %v363 = load i64, ptr %v362, align 8, !noalias !570
  %v364 = add nsw i64 %v363, -1
  store i64 %v364, ptr %v362, align 8, !noalias !570
  %v365 = load i64, ptr %v10, align 8, !noalias !570
  %v366 = icmp slt i64 %v365, 0
  %v367 = select i1 %v366, i64 %v6, i64 0
  %v368 = add i64 %v367, %v365
  %v369 = mul i64 %v368, %v7
  %v370 = getelementptr i64, ptr %v5, i64 %v369
  %v371 = getelementptr i8, ptr %v370, i64 24
  %v372 = load i64, ptr %v371, align 8, !noalias !570
  %v373 = add nsw i64 %v372, 1
  store i64 %v373, ptr %v371, align 8, !noalias !570
  store i64 -1, ptr %v20, align 8
  br label %v37

v37:
  store double %v86, ptr %v0, align 8
  %v374 = getelementptr inbounds i8, ptr %v0, i64 8
  store double %v89, ptr %v374, align 8
  %v375 = getelementptr inbounds i8, ptr %v0, i64 16
  store double %v376, ptr %v375, align 8
  %v377 = getelementptr inbounds i8, ptr %v0, i64 24
  store double %v378, ptr %v377, align 8
  br label %v35

v39:
  %v379 = fcmp ult double %v16, 0x3FB48E8A71DE69AD
  br i1 %v379, label %v40, label %v42

v42:
  %v380 = fcmp ult double %v16, 2.500000e-01
  br i1 %v380, label %v40, label %v45

v45:
  %v381 = fcmp ult double %v16, 3.333000e-01
  br i1 %v381, label %v40, label %v47

v47:
  %v382 = fcmp ult double %v16, 5.000000e-01
  br i1 %v382, label %v40, label %v43

v43:
  %v383 = fcmp ult double %v16, 0x3FE50A3D70A3D70A
  br i1 %v383, label %v40, label %v48

v48:
  %v384 = fcmp ult double %v16, 7.500000e-01
  br i1 %v384, label %v40, label %v46

v46:
  %v385 = fcmp ult double %v16, 8.889000e-01
  br i1 %v385, label %v40, label %v44

v44:
  br label %v40

v70:
  %v78 = phi i64 [ %v66, %v68 ], [ -1, %v65 ]
  store i64 %v78, ptr %v20, align 8
  %v386 = icmp eq i64 %v58, 7
  br i1 %v386, label %v53, label %v60

v92:
  %v387 = icmp slt i64 %v81, 0
  %v388 = select i1 %v387, i64 %v13, i64 0
  %v389 = add i64 %v388, %v81
  %v390 = mul i64 %v15, %v14
  %v391 = mul i64 %v390, %v389
  %v392 = getelementptr double, ptr %v12, i64 %v391
  %v393 = getelementptr double, ptr %v392, i64 %v15
  %v394 = shl i64 %v15, 4
  %v395 = getelementptr i8, ptr %v392, i64 %v394
  br label %v396

v396:
  %v397 = phi double [ 0x7FF0000000000000, %v92 ], [ %v398, %v396 ]
  %v399 = phi i64 [ 0, %v92 ], [ %v400, %v396 ]
  %v400 = add nsw i64 %v399, 1
  %v401 = getelementptr double, ptr %v393, i64 %v399
  %v402 = load double, ptr %v401, align 8, !noalias !573
  %v403 = getelementptr double, ptr %v395, i64 %v399
  %v404 = load double, ptr %v403, align 8, !noalias !573
  %v405 = fadd double %v402, %v404
  %v406 = fcmp olt double %v405, %v397
  %v398 = select i1 %v406, double %v405, double %v397
  %v407 = icmp eq i64 %v15, %v400
  br i1 %v407, label %v91, label %v396

v91:
  %v408 = phi double [ 0x7FF0000000000000, %v53 ], [ %v398, %v396 ]
  %v409 = fcmp olt double %v408, 0.000000e+00
  %v376 = select i1 %v409, double 0.000000e+00, double %v408
  %v410 = icmp slt i64 %v15, 1
  br i1 %v410, label %v411, label %v412

v412:
  %v413 = mul i64 %v15, %v79
  %v414 = mul i64 %v413, %v14
  %v415 = getelementptr double, ptr %v12, i64 %v414
  %v416 = getelementptr double, ptr %v415, i64 %v15
  %v417 = shl i64 %v15, 4
  %v418 = getelementptr i8, ptr %v415, i64 %v417
  br label %v419

v419:
  %v420 = phi double [ 0x7FF0000000000000, %v412 ], [ %v421, %v419 ]
  %v422 = phi i64 [ 0, %v412 ], [ %v423, %v419 ]
  %v423 = add nsw i64 %v422, 1
  %v424 = getelementptr double, ptr %v416, i64 %v422
  %v425 = load double, ptr %v424, align 8, !noalias !577
  %v426 = getelementptr double, ptr %v418, i64 %v422
  %v427 = load double, ptr %v426, align 8, !noalias !577
  %v428 = fadd double %v425, %v427
  %v429 = fcmp olt double %v428, %v420
  %v421 = select i1 %v429, double %v428, double %v420
  %v430 = icmp eq i64 %v15, %v423
  br i1 %v430, label %v411, label %v419

v411:
  %v378 = phi double [ 0x7FF0000000000000, %v91 ], [ %v421, %v419 ]
  %v431 = load i64, ptr %v20, align 8
  %v432 = icmp slt i64 %v431, 0
  %v105 = select i1 %v432, i64 %v79, i64 %v80
  br i1 %v18, label %v433, label %v37

v433:
  %v434 = load double, ptr %v8, align 8, !noalias !581
  %v435 = tail call double @llvm.fabs.f64(double %v434)
  %v436 = fmul double %v435, 4.000000e-15
  %v437 = getelementptr double, ptr %v3, i64 %v4
  %v438 = getelementptr i8, ptr %v437, i64 -8
  %v439 = load double, ptr %v438, align 8, !noalias !581
  %v440 = load double, ptr %v3, align 8, !noalias !581
  %v441 = fsub double %v439, %v440
  %v442 = fmul double %v441, 1.000000e-13
  %v443 = fcmp ogt double %v436, %v442
  %v444 = select i1 %v443, double %v436, double %v442
  %v445 = mul i64 %v9, 48
  %v446 = getelementptr i8, ptr %v8, i64 %v445
  %v98 = load double, ptr %v446, align 8
  %v447 = fmul double %v444, 2.000000e+00
  %v448 = fcmp ogt double %v98, %v447
  br i1 %v448, label %v93, label %v37

v38:
  store ptr %v348, ptr %v1, align 8
  br label %v35

v351:
  br i1 %v347, label %v37, label %v352
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.copysign.f64(double, double)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64)

; Function Attrs: nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr, i8, i64, i1)

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
!21 = distinct !{!21, !22, !"_ZN5pages12event_checks14hold_decisionsB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!22 = distinct !{!22, !"_ZN5pages12event_checks14hold_decisionsB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!23 = distinct !{!23, !22, !"_ZN5pages12event_checks14hold_decisionsB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!24 = !{!21, !23, !12, !14}
!25 = !{!26, !21, !23, !12, !14}
!26 = distinct !{!26, !27, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!27 = distinct !{!27, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!28 = !{!29, !12, !14}
!29 = distinct !{!29, !30, !"_ZN5pages13solver_layout10derivativeB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29x: %retptr"}
!30 = distinct !{!30, !"_ZN5pages13solver_layout10derivativeB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29x"}
!31 = !{!32, !12, !14}
!32 = distinct !{!32, !33, !"_ZN5pages13solver_layout7formulaB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_287_29: %retptr"}
!33 = distinct !{!33, !"_ZN5pages13solver_layout7formulaB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_287_29"}
!34 = !{!35, !12, !14}
!35 = distinct !{!35, !36, !"_ZN5pages13solver_layout7formulaB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_288_29: %retptr"}
!36 = distinct !{!36, !"_ZN5pages13solver_layout7formulaB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_288_29"}
!37 = !{!38, !12, !14}
!38 = distinct !{!38, !39, !"_ZN5pages13solver_layout10derivativeB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!39 = distinct !{!39, !"_ZN5pages13solver_layout10derivativeB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!40 = !{!41, !12, !14}
!41 = distinct !{!41, !42, !"_ZN5pages13solver_layout7formulaB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!42 = distinct !{!42, !"_ZN5pages13solver_layout7formulaB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!43 = !{!44, !46, !12, !14}
!44 = distinct !{!44, !45, !"_ZN5pages8segments13begin_segmentB3v14B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!45 = distinct !{!45, !"_ZN5pages8segments13begin_segmentB3v14B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!46 = distinct !{!46, !45, !"_ZN5pages8segments13begin_segmentB3v14B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!47 = !{!48, !44, !46, !12, !14}
!48 = distinct !{!48, !49, !"_ZN5pages13solver_layout4failB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!49 = distinct !{!49, !"_ZN5pages13solver_layout4failB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!50 = !{!51, !53, !54, !56, !44, !46, !12, !14}
!51 = distinct !{!51, !52, !"_ZN5pages12event_checks13shortest_stepB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!52 = distinct !{!52, !"_ZN5pages12event_checks13shortest_stepB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!53 = distinct !{!53, !52, !"_ZN5pages12event_checks13shortest_stepB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!54 = distinct !{!54, !55, !"_ZN5pages8segments12stop_outsideB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x23Literal_5bint_5d_280_29: %retptr"}
!55 = distinct !{!55, !"_ZN5pages8segments12stop_outsideB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x23Literal_5bint_5d_280_29"}
!56 = distinct !{!56, !55, !"_ZN5pages8segments12stop_outsideB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x23Literal_5bint_5d_280_29: %excinfo"}
!57 = !{!54, !56, !44, !46, !12, !14}
!58 = !{!59, !54, !56, !44, !46, !12, !14}
!59 = distinct !{!59, !60, !"_ZN5pages13solver_layout10derivativeB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2924Literal_5bint_5d_2814_29: %retptr"}
!60 = distinct !{!60, !"_ZN5pages13solver_layout10derivativeB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2924Literal_5bint_5d_2814_29"}
!61 = !{!62, !54, !56, !44, !46, !12, !14}
!62 = distinct !{!62, !63, !"_ZN5pages13solver_layout6decideB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_289_29: %retptr"}
!63 = distinct !{!63, !"_ZN5pages13solver_layout6decideB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_289_29"}
!64 = !{!65, !54, !56, !44, !46, !12, !14}
!65 = distinct !{!65, !66, !"_ZN5pages13solver_layout6decideB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29: %retptr"}
!66 = distinct !{!66, !"_ZN5pages13solver_layout6decideB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29"}
!67 = !{!68, !54, !56, !44, !46, !12, !14}
!68 = distinct !{!68, !69, !"_ZN5pages13solver_layout4failB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!69 = distinct !{!69, !"_ZN5pages13solver_layout4failB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!70 = !{!71, !73, !44, !46, !12, !14}
!71 = distinct !{!71, !72, !"_ZN5pages8segments14note_next_stopB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!72 = distinct !{!72, !"_ZN5pages8segments14note_next_stopB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!73 = distinct !{!73, !72, !"_ZN5pages8segments14note_next_stopB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!74 = !{!75, !77, !79}
!75 = distinct !{!75, !76, !"_ZN5pages13solver_layout7formulaB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_285_29: %retptr"}
!76 = distinct !{!76, !"_ZN5pages13solver_layout7formulaB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_285_29"}
!77 = distinct !{!77, !78, !"_ZN5pages12time_stepper12attempt_stepB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!78 = distinct !{!78, !"_ZN5pages12time_stepper12attempt_stepB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!79 = distinct !{!79, !78, !"_ZN5pages12time_stepper12attempt_stepB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!80 = !{!81, !83, !84, !86}
!81 = distinct !{!81, !82, !"_ZN5pages12time_stepper11count_stepsB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!82 = distinct !{!82, !"_ZN5pages12time_stepper11count_stepsB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!83 = distinct !{!83, !82, !"_ZN5pages12time_stepper11count_stepsB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!84 = distinct !{!84, !85, !"_ZN5pages12time_stepper11check_lanesB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!85 = distinct !{!85, !"_ZN5pages12time_stepper11check_lanesB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!86 = distinct !{!86, !85, !"_ZN5pages12time_stepper11check_lanesB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!87 = !{!84, !86}
!88 = !{!89, !84, !86}
!89 = distinct !{!89, !90, !"_ZN5pages13solver_layout4failB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!90 = distinct !{!90, !"_ZN5pages13solver_layout4failB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!91 = !{!92, !94, !96}
!92 = distinct !{!92, !93, !"_ZN5pages13solver_layout10derivativeB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!93 = distinct !{!93, !"_ZN5pages13solver_layout10derivativeB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!94 = distinct !{!94, !95, !"_ZN5pages12time_stepper13handle_eventsB4v105B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb: %retptr"}
!95 = distinct !{!95, !"_ZN5pages12time_stepper13handle_eventsB4v105B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb"}
!96 = distinct !{!96, !95, !"_ZN5pages12time_stepper13handle_eventsB4v105B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb: %excinfo"}
!97 = !{!98, !94, !96}
!98 = distinct !{!98, !99, !"_ZN5pages13solver_layout7formulaB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2813_29: %retptr"}
!99 = distinct !{!99, !"_ZN5pages13solver_layout7formulaB3v47B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2813_29"}
!100 = !{!101, !94, !96}
!101 = distinct !{!101, !102, !"_ZN5pages13solver_layout7formulaB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2812_29: %retptr"}
!102 = distinct !{!102, !"_ZN5pages13solver_layout7formulaB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2812_29"}
!103 = !{!104, !106, !107, !109, !110, !112, !94, !96}
!104 = distinct !{!104, !105, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!105 = distinct !{!105, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!106 = distinct !{!106, !105, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!107 = distinct !{!107, !108, !"_ZN5pages12event_checks15evaluate_pointsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!108 = distinct !{!108, !"_ZN5pages12event_checks15evaluate_pointsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!109 = distinct !{!109, !108, !"_ZN5pages12event_checks15evaluate_pointsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!110 = distinct !{!110, !111, !"_ZN5pages12event_checks10comes_nearB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!111 = distinct !{!111, !"_ZN5pages12event_checks10comes_nearB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!112 = distinct !{!112, !111, !"_ZN5pages12event_checks10comes_nearB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!113 = !{!114, !116, !104, !106, !107, !109, !110, !112, !94, !96}
!114 = distinct !{!114, !115, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!115 = distinct !{!115, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!116 = distinct !{!116, !115, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!117 = !{!118, !107, !109, !110, !112, !94, !96}
!118 = distinct !{!118, !119, !"_ZN5pages13solver_layout6decideB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!119 = distinct !{!119, !"_ZN5pages13solver_layout6decideB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!120 = !{!"branch_weights", i32 99, i32 1}
!121 = !{!122, !124, !126, !94, !96}
!122 = distinct !{!122, !123, !"_ZN5pages13solver_layout7formulaB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!123 = distinct !{!123, !"_ZN5pages13solver_layout7formulaB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!124 = distinct !{!124, !125, !"_ZN5pages12time_stepper18interpolant_stagesB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!125 = distinct !{!125, !"_ZN5pages12time_stepper18interpolant_stagesB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!126 = distinct !{!126, !125, !"_ZN5pages12time_stepper18interpolant_stagesB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!127 = !{!128, !124, !126, !94, !96}
!128 = distinct !{!128, !129, !"_ZN5pages13solver_layout7formulaB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!129 = distinct !{!129, !"_ZN5pages13solver_layout7formulaB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!130 = !{!131, !124, !126, !94, !96}
!131 = distinct !{!131, !132, !"_ZN5pages13solver_layout10derivativeB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!132 = distinct !{!132, !"_ZN5pages13solver_layout10derivativeB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!133 = !{!134, !94, !96}
!134 = distinct !{!134, !135, !"_ZN5pages13solver_layout7formulaB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2811_29: %retptr"}
!135 = distinct !{!135, !"_ZN5pages13solver_layout7formulaB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2811_29"}
!136 = !{!137, !139, !94, !96}
!137 = distinct !{!137, !138, !"_ZN5pages12time_stepper17check_interpolantB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!138 = distinct !{!138, !"_ZN5pages12time_stepper17check_interpolantB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!139 = distinct !{!139, !138, !"_ZN5pages12time_stepper17check_interpolantB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!140 = !{!141, !137, !139, !94, !96}
!141 = distinct !{!141, !142, !"_ZN5pages13solver_layout5retryB3v59B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd: %retptr"}
!142 = distinct !{!142, !"_ZN5pages13solver_layout5retryB3v59B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd"}
!143 = !{!144, !146, !94, !96}
!144 = distinct !{!144, !145, !"_ZN5pages14event_location13locate_eventsB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!145 = distinct !{!145, !"_ZN5pages14event_location13locate_eventsB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!146 = distinct !{!146, !145, !"_ZN5pages14event_location13locate_eventsB3v60B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!147 = !{!148, !150, !144, !146, !94, !96}
!148 = distinct !{!148, !149, !"_ZN5pages12event_checks12check_eventsB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!149 = distinct !{!149, !"_ZN5pages12event_checks12check_eventsB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!150 = distinct !{!150, !149, !"_ZN5pages12event_checks12check_eventsB3v61B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!151 = !{!152, !154, !155, !157, !148, !150, !144, !146, !94, !96}
!152 = distinct !{!152, !153, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!153 = distinct !{!153, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!154 = distinct !{!154, !153, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!155 = distinct !{!155, !156, !"_ZN5pages12event_checks15evaluate_pointsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!156 = distinct !{!156, !"_ZN5pages12event_checks15evaluate_pointsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!157 = distinct !{!157, !156, !"_ZN5pages12event_checks15evaluate_pointsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!158 = !{!159, !161, !152, !154, !155, !157, !148, !150, !144, !146, !94, !96}
!159 = distinct !{!159, !160, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!160 = distinct !{!160, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!161 = distinct !{!161, !160, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!162 = !{!163, !155, !157, !148, !150, !144, !146, !94, !96}
!163 = distinct !{!163, !164, !"_ZN5pages13solver_layout6decideB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!164 = distinct !{!164, !"_ZN5pages13solver_layout6decideB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!165 = !{!166, !168, !169, !171, !148, !150, !144, !146, !94, !96}
!166 = distinct !{!166, !167, !"_ZN5pages12event_checks13shortest_stepB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!167 = distinct !{!167, !"_ZN5pages12event_checks13shortest_stepB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!168 = distinct !{!168, !167, !"_ZN5pages12event_checks13shortest_stepB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!169 = distinct !{!169, !170, !"_ZN5pages12event_checks9set_edgesB3v62B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!170 = distinct !{!170, !"_ZN5pages12event_checks9set_edgesB3v62B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!171 = distinct !{!171, !170, !"_ZN5pages12event_checks9set_edgesB3v62B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!172 = !{!169, !171, !148, !150, !144, !146, !94, !96}
!173 = !{!174, !176, !177, !179, !180, !144, !146, !94, !96}
!174 = distinct !{!174, !175, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!175 = distinct !{!175, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!176 = distinct !{!176, !175, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!177 = distinct !{!177, !178, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!178 = distinct !{!178, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!179 = distinct !{!179, !178, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!180 = distinct !{!180, !181, !"_ZN5pages14event_location6narrowB3v70B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29d: %retptr"}
!181 = distinct !{!181, !"_ZN5pages14event_location6narrowB3v70B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29d"}
!182 = !{!183, !185, !174, !176, !177, !179, !180, !144, !146, !94, !96}
!183 = distinct !{!183, !184, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!184 = distinct !{!184, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!185 = distinct !{!185, !184, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!186 = !{!187, !177, !179, !180, !144, !146, !94, !96}
!187 = distinct !{!187, !188, !"_ZN5pages13solver_layout6decideB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!188 = distinct !{!188, !"_ZN5pages13solver_layout6decideB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!189 = !{!177, !179, !180, !144, !146, !94, !96}
!190 = !{!191, !193, !180, !144, !146, !94, !96}
!191 = distinct !{!191, !192, !"_ZN5pages12event_checks14least_distanceB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!192 = distinct !{!192, !"_ZN5pages12event_checks14least_distanceB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!193 = distinct !{!193, !192, !"_ZN5pages12event_checks14least_distanceB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!194 = !{!195, !197, !198, !200, !201, !203, !144, !146, !94, !96}
!195 = distinct !{!195, !196, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!196 = distinct !{!196, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!197 = distinct !{!197, !196, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!198 = distinct !{!198, !199, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!199 = distinct !{!199, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!200 = distinct !{!200, !199, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!201 = distinct !{!201, !202, !"_ZN5pages14event_location9stops_runB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d28Bracket_28float64_20x_204_29: %retptr"}
!202 = distinct !{!202, !"_ZN5pages14event_location9stops_runB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d28Bracket_28float64_20x_204_29"}
!203 = distinct !{!203, !202, !"_ZN5pages14event_location9stops_runB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d28Bracket_28float64_20x_204_29: %excinfo"}
!204 = !{!205, !207, !195, !197, !198, !200, !201, !203, !144, !146, !94, !96}
!205 = distinct !{!205, !206, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!206 = distinct !{!206, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!207 = distinct !{!207, !206, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!208 = !{!209, !198, !200, !201, !203, !144, !146, !94, !96}
!209 = distinct !{!209, !210, !"_ZN5pages13solver_layout6decideB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!210 = distinct !{!210, !"_ZN5pages13solver_layout6decideB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!211 = !{!198, !200, !201, !203, !144, !146, !94, !96}
!212 = !{!201, !203, !144, !146, !94, !96}
!213 = !{!214, !216, !217, !219, !220, !222, !201, !203, !144, !146, !94, !96}
!214 = distinct !{!214, !215, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!215 = distinct !{!215, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!216 = distinct !{!216, !215, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!217 = distinct !{!217, !218, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!218 = distinct !{!218, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!219 = distinct !{!219, !218, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!220 = distinct !{!220, !221, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!221 = distinct !{!221, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!222 = distinct !{!222, !221, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!223 = !{!217, !219, !220, !222, !201, !203, !144, !146, !94, !96}
!224 = !{!225, !220, !222, !201, !203, !144, !146, !94, !96}
!225 = distinct !{!225, !226, !"_ZN5pages13solver_layout6decideB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!226 = distinct !{!226, !"_ZN5pages13solver_layout6decideB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!227 = !{!220, !222, !201, !203, !144, !146, !94, !96}
!228 = !{!229, !231, !232, !234, !235, !201, !203, !144, !146, !94, !96}
!229 = distinct !{!229, !230, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!230 = distinct !{!230, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!231 = distinct !{!231, !230, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!232 = distinct !{!232, !233, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!233 = distinct !{!233, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!234 = distinct !{!234, !233, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!235 = distinct !{!235, !236, !"_ZN5pages14event_location6narrowB3v70B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29d: %retptr"}
!236 = distinct !{!236, !"_ZN5pages14event_location6narrowB3v70B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29d"}
!237 = !{!238, !240, !229, !231, !232, !234, !235, !201, !203, !144, !146, !94, !96}
!238 = distinct !{!238, !239, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!239 = distinct !{!239, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!240 = distinct !{!240, !239, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!241 = !{!242, !232, !234, !235, !201, !203, !144, !146, !94, !96}
!242 = distinct !{!242, !243, !"_ZN5pages13solver_layout6decideB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!243 = distinct !{!243, !"_ZN5pages13solver_layout6decideB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!244 = !{!232, !234, !235, !201, !203, !144, !146, !94, !96}
!245 = !{!246, !248, !235, !201, !203, !144, !146, !94, !96}
!246 = distinct !{!246, !247, !"_ZN5pages12event_checks14least_distanceB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!247 = distinct !{!247, !"_ZN5pages12event_checks14least_distanceB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!248 = distinct !{!248, !247, !"_ZN5pages12event_checks14least_distanceB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!249 = !{!250, !252, !201, !203, !144, !146, !94, !96}
!250 = distinct !{!250, !251, !"_ZN5pages8segments19write_samples_untilB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!251 = distinct !{!251, !"_ZN5pages8segments19write_samples_untilB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!252 = distinct !{!252, !251, !"_ZN5pages8segments19write_samples_untilB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %excinfo"}
!253 = !{!254, !201, !203, !144, !146, !94, !96}
!254 = distinct !{!254, !255, !"_ZN5pages13solver_layout4failB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29: %retptr"}
!255 = distinct !{!255, !"_ZN5pages13solver_layout4failB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29"}
!256 = !{!257, !259, !250, !252, !201, !203, !144, !146, !94, !96}
!257 = distinct !{!257, !258, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!258 = distinct !{!258, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!259 = distinct !{!259, !258, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!260 = !{!261, !263, !201, !203, !144, !146, !94, !96}
!261 = distinct !{!261, !262, !"_ZN5pages12event_checks13first_crossedB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!262 = distinct !{!262, !"_ZN5pages12event_checks13first_crossedB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!263 = distinct !{!263, !262, !"_ZN5pages12event_checks13first_crossedB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!264 = !{!265, !267, !144, !146, !94, !96}
!265 = distinct !{!265, !266, !"_ZN5pages14event_location11pass_eventsB3v80B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29: %retptr"}
!266 = distinct !{!266, !"_ZN5pages14event_location11pass_eventsB3v80B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29"}
!267 = distinct !{!267, !266, !"_ZN5pages14event_location11pass_eventsB3v80B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29: %excinfo"}
!268 = !{!269, !271, !272, !274, !265, !267, !144, !146, !94, !96}
!269 = distinct !{!269, !270, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!270 = distinct !{!270, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!271 = distinct !{!271, !270, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!272 = distinct !{!272, !273, !"_ZN5pages12event_checks15evaluate_pointsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!273 = distinct !{!273, !"_ZN5pages12event_checks15evaluate_pointsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!274 = distinct !{!274, !273, !"_ZN5pages12event_checks15evaluate_pointsB3v50B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!275 = !{!276, !278, !269, !271, !272, !274, !265, !267, !144, !146, !94, !96}
!276 = distinct !{!276, !277, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!277 = distinct !{!277, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!278 = distinct !{!278, !277, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!279 = !{!280, !272, !274, !265, !267, !144, !146, !94, !96}
!280 = distinct !{!280, !281, !"_ZN5pages13solver_layout6decideB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!281 = distinct !{!281, !"_ZN5pages13solver_layout6decideB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!282 = !{!283, !265, !267, !144, !146, !94, !96}
!283 = distinct !{!283, !284, !"_ZN5pages13solver_layout10derivativeB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!284 = distinct !{!284, !"_ZN5pages13solver_layout10derivativeB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!285 = !{!286, !288, !289, !291, !292, !265, !267, !144, !146, !94, !96}
!286 = distinct !{!286, !287, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!287 = distinct !{!287, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!288 = distinct !{!288, !287, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!289 = distinct !{!289, !290, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!290 = distinct !{!290, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!291 = distinct !{!291, !290, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!292 = distinct !{!292, !293, !"_ZN5pages14event_location6narrowB3v70B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29d: %retptr"}
!293 = distinct !{!293, !"_ZN5pages14event_location6narrowB3v70B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29d"}
!294 = !{!295, !297, !286, !288, !289, !291, !292, !265, !267, !144, !146, !94, !96}
!295 = distinct !{!295, !296, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!296 = distinct !{!296, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!297 = distinct !{!297, !296, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!298 = !{!299, !289, !291, !292, !265, !267, !144, !146, !94, !96}
!299 = distinct !{!299, !300, !"_ZN5pages13solver_layout6decideB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!300 = distinct !{!300, !"_ZN5pages13solver_layout6decideB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!301 = !{!289, !291, !292, !265, !267, !144, !146, !94, !96}
!302 = !{!303, !305, !292, !265, !267, !144, !146, !94, !96}
!303 = distinct !{!303, !304, !"_ZN5pages12event_checks14least_distanceB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!304 = distinct !{!304, !"_ZN5pages12event_checks14least_distanceB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!305 = distinct !{!305, !304, !"_ZN5pages12event_checks14least_distanceB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!306 = !{!307, !309, !311, !265, !267, !144, !146, !94, !96}
!307 = distinct !{!307, !308, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!308 = distinct !{!308, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!309 = distinct !{!309, !310, !"_ZN5pages14event_location18exchange_decisionsB3v86B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %retptr"}
!310 = distinct !{!310, !"_ZN5pages14event_location18exchange_decisionsB3v86B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29"}
!311 = distinct !{!311, !310, !"_ZN5pages14event_location18exchange_decisionsB3v86B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %excinfo"}
!312 = !{!309, !311, !265, !267, !144, !146, !94, !96}
!313 = !{!314, !316, !317, !319, !320, !322, !265, !267, !144, !146, !94, !96}
!314 = distinct !{!314, !315, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!315 = distinct !{!315, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!316 = distinct !{!316, !315, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!317 = distinct !{!317, !318, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!318 = distinct !{!318, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!319 = distinct !{!319, !318, !"_ZN5pages14event_location13decide_withinB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!320 = distinct !{!320, !321, !"_ZN5pages14event_location12rates_changeB3v81B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!321 = distinct !{!321, !"_ZN5pages14event_location12rates_changeB3v81B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!322 = distinct !{!322, !321, !"_ZN5pages14event_location12rates_changeB3v81B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!323 = !{!324, !326, !314, !316, !317, !319, !320, !322, !265, !267, !144, !146, !94, !96}
!324 = distinct !{!324, !325, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!325 = distinct !{!325, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!326 = distinct !{!326, !325, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!327 = !{!328, !317, !319, !320, !322, !265, !267, !144, !146, !94, !96}
!328 = distinct !{!328, !329, !"_ZN5pages13solver_layout6decideB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!329 = distinct !{!329, !"_ZN5pages13solver_layout6decideB3v74B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!330 = !{!317, !319, !320, !322, !265, !267, !144, !146, !94, !96}
!331 = !{!332, !334, !320, !322, !265, !267, !144, !146, !94, !96}
!332 = distinct !{!332, !333, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!333 = distinct !{!333, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!334 = distinct !{!334, !333, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!335 = !{!336, !338, !332, !334, !320, !322, !265, !267, !144, !146, !94, !96}
!336 = distinct !{!336, !337, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!337 = distinct !{!337, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!338 = distinct !{!338, !337, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!339 = !{!340, !342, !344, !320, !322, !265, !267, !144, !146, !94, !96}
!340 = distinct !{!340, !341, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!341 = distinct !{!341, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!342 = distinct !{!342, !343, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!343 = distinct !{!343, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!344 = distinct !{!344, !343, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!345 = !{!342, !344, !320, !322, !265, !267, !144, !146, !94, !96}
!346 = !{!347, !349, !351, !320, !322, !265, !267, !144, !146, !94, !96}
!347 = distinct !{!347, !348, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!348 = distinct !{!348, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!349 = distinct !{!349, !350, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!350 = distinct !{!350, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!351 = distinct !{!351, !350, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!352 = !{!349, !351, !320, !322, !265, !267, !144, !146, !94, !96}
!353 = !{!354, !320, !322, !265, !267, !144, !146, !94, !96}
!354 = distinct !{!354, !355, !"_ZN5pages13solver_layout10derivativeB3v82B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2814_29: %retptr"}
!355 = distinct !{!355, !"_ZN5pages13solver_layout10derivativeB3v82B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2814_29"}
!356 = !{!357, !359, !361, !320, !322, !265, !267, !144, !146, !94, !96}
!357 = distinct !{!357, !358, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!358 = distinct !{!358, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!359 = distinct !{!359, !360, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!360 = distinct !{!360, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!361 = distinct !{!361, !360, !"_ZN5pages14event_location18exchange_decisionsB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!362 = !{!363, !320, !322, !265, !267, !144, !146, !94, !96}
!363 = distinct !{!363, !364, !"_ZN5pages13solver_layout10derivativeB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2815_29: %retptr"}
!364 = distinct !{!364, !"_ZN5pages13solver_layout10derivativeB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2815_29"}
!365 = !{!366, !368, !320, !322, !265, !267, !144, !146, !94, !96}
!366 = distinct !{!366, !367, !"_ZN5pages14event_location12rates_differB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!367 = distinct !{!367, !"_ZN5pages14event_location12rates_differB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!368 = distinct !{!368, !367, !"_ZN5pages14event_location12rates_differB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!369 = !{!359, !361, !320, !322, !265, !267, !144, !146, !94, !96}
!370 = !{!"branch_weights", i32 1, i32 99}
!371 = !{!"branch_weights", i32 101, i32 99}
!372 = !{!373, !375, !144, !146, !94, !96}
!373 = distinct !{!373, !374, !"_ZN5pages12event_checks13shortest_stepB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!374 = distinct !{!374, !"_ZN5pages12event_checks13shortest_stepB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!375 = distinct !{!375, !374, !"_ZN5pages12event_checks13shortest_stepB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!376 = !{!377, !379, !380, !382, !144, !146, !94, !96}
!377 = distinct !{!377, !378, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!378 = distinct !{!378, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!379 = distinct !{!379, !378, !"_ZN5pages13solver_layout16put_state_withinB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!380 = distinct !{!380, !381, !"_ZN5pages14event_location8end_stepB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!381 = distinct !{!381, !"_ZN5pages14event_location8end_stepB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!382 = distinct !{!382, !381, !"_ZN5pages14event_location8end_stepB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!383 = !{!384, !386, !377, !379, !380, !382, !144, !146, !94, !96}
!384 = distinct !{!384, !385, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!385 = distinct !{!385, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!386 = distinct !{!386, !385, !"_ZN5pages13solver_layout11interpolateB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!387 = !{!380, !382, !144, !146, !94, !96}
!388 = !{!389, !380, !382, !144, !146, !94, !96}
!389 = distinct !{!389, !390, !"_ZN5pages13solver_layout10derivativeB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!390 = distinct !{!390, !"_ZN5pages13solver_layout10derivativeB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!391 = !{!392, !380, !382, !144, !146, !94, !96}
!392 = distinct !{!392, !393, !"_ZN5pages13solver_layout6decideB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_288_29: %retptr"}
!393 = distinct !{!393, !"_ZN5pages13solver_layout6decideB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_288_29"}
!394 = !{!395, !144, !146, !94, !96}
!395 = distinct !{!395, !396, !"_ZN5pages13solver_layout5retryB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!396 = distinct !{!396, !"_ZN5pages13solver_layout5retryB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!397 = !{!110, !112, !94, !96}
!398 = !{!399, !401, !110, !112, !94, !96}
!399 = distinct !{!399, !400, !"_ZN5pages12event_checks13error_betweenB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!400 = distinct !{!400, !"_ZN5pages12event_checks13error_betweenB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!401 = distinct !{!401, !400, !"_ZN5pages12event_checks13error_betweenB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!402 = !{!403}
!403 = distinct !{!403, !404, !"_ZN5pages12time_stepper13write_samplesB3v89B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29b: %retptr"}
!404 = distinct !{!404, !"_ZN5pages12time_stepper13write_samplesB3v89B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29b"}
!405 = !{!406, !408, !403}
!406 = distinct !{!406, !407, !"_ZN5pages8segments19write_samples_untilB3v90B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd: %retptr"}
!407 = distinct !{!407, !"_ZN5pages8segments19write_samples_untilB3v90B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd"}
!408 = distinct !{!408, !407, !"_ZN5pages8segments19write_samples_untilB3v90B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd: %excinfo"}
!409 = !{!410, !412, !406, !408, !403}
!410 = distinct !{!410, !411, !"_ZN5pages13solver_layout11interpolateB3v91B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd: %retptr"}
!411 = distinct !{!411, !"_ZN5pages13solver_layout11interpolateB3v91B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd"}
!412 = distinct !{!412, !411, !"_ZN5pages13solver_layout11interpolateB3v91B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd: %excinfo"}
!413 = !{!414}
!414 = distinct !{!414, !415, !"_ZN5pages13solver_layout7formulaB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %retptr"}
!415 = distinct !{!415, !"_ZN5pages13solver_layout7formulaB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29"}
!416 = !{!417, !419}
!417 = distinct !{!417, !418, !"_ZN5pages14event_location20restart_behind_eventB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!418 = distinct !{!418, !"_ZN5pages14event_location20restart_behind_eventB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!419 = distinct !{!419, !418, !"_ZN5pages14event_location20restart_behind_eventB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!420 = !{!421, !417, !419}
!421 = distinct !{!421, !422, !"_ZN5pages13solver_layout4failB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29: %retptr"}
!422 = distinct !{!422, !"_ZN5pages13solver_layout4failB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29"}
!423 = !{!424, !426}
!424 = distinct !{!424, !425, !"_ZN5pages8segments14at_segment_endB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!425 = distinct !{!425, !"_ZN5pages8segments14at_segment_endB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!426 = distinct !{!426, !427, !"_ZN5pages8segments11jump_statesB3v94B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!427 = distinct !{!427, !"_ZN5pages8segments11jump_statesB3v94B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!428 = !{!426}
!429 = !{!430, !432, !426}
!430 = distinct !{!430, !431, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!431 = distinct !{!431, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!432 = distinct !{!432, !431, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!433 = !{!434, !426}
!434 = distinct !{!434, !435, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!435 = distinct !{!435, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!436 = !{!437, !426}
!437 = distinct !{!437, !438, !"_ZN5pages8segments14at_segment_endB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!438 = distinct !{!438, !"_ZN5pages8segments14at_segment_endB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!439 = !{!440, !442, !426}
!440 = distinct !{!440, !441, !"_ZN5pages8segments11accept_jumpB3v96B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!441 = distinct !{!441, !"_ZN5pages8segments11accept_jumpB3v96B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!442 = distinct !{!442, !441, !"_ZN5pages8segments11accept_jumpB3v96B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!443 = !{!444, !440, !442, !426}
!444 = distinct !{!444, !445, !"_ZN5pages13solver_layout4failB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!445 = distinct !{!445, !"_ZN5pages13solver_layout4failB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!446 = !{!447, !449, !450, !452, !440, !442, !426}
!447 = distinct !{!447, !448, !"_ZN5pages12event_checks13shortest_stepB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!448 = distinct !{!448, !"_ZN5pages12event_checks13shortest_stepB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!449 = distinct !{!449, !448, !"_ZN5pages12event_checks13shortest_stepB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!450 = distinct !{!450, !451, !"_ZN5pages8segments12stop_outsideB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29: %retptr"}
!451 = distinct !{!451, !"_ZN5pages8segments12stop_outsideB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29"}
!452 = distinct !{!452, !451, !"_ZN5pages8segments12stop_outsideB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29: %excinfo"}
!453 = !{!450, !452, !440, !442, !426}
!454 = !{!455, !450, !452, !440, !442, !426}
!455 = distinct !{!455, !456, !"_ZN5pages13solver_layout10derivativeB3v98B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2814_29: %retptr"}
!456 = distinct !{!456, !"_ZN5pages13solver_layout10derivativeB3v98B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2814_29"}
!457 = !{!458, !450, !452, !440, !442, !426}
!458 = distinct !{!458, !459, !"_ZN5pages13solver_layout6decideB3v99B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_289_29: %retptr"}
!459 = distinct !{!459, !"_ZN5pages13solver_layout6decideB3v99B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_289_29"}
!460 = !{!461, !450, !452, !440, !442, !426}
!461 = distinct !{!461, !462, !"_ZN5pages13solver_layout6decideB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29: %retptr"}
!462 = distinct !{!462, !"_ZN5pages13solver_layout6decideB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29"}
!463 = !{!464, !450, !452, !440, !442, !426}
!464 = distinct !{!464, !465, !"_ZN5pages13solver_layout4failB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!465 = distinct !{!465, !"_ZN5pages13solver_layout4failB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!466 = !{!467, !469}
!467 = distinct !{!467, !468, !"_ZN5pages12time_stepper12end_segmentsB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!468 = distinct !{!468, !"_ZN5pages12time_stepper12end_segmentsB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!469 = distinct !{!469, !468, !"_ZN5pages12time_stepper12end_segmentsB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!470 = !{!471, !467, !469}
!471 = distinct !{!471, !472, !"_ZN5pages13solver_layout4failB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!472 = distinct !{!472, !"_ZN5pages13solver_layout4failB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!473 = !{!474, !476, !467, !469}
!474 = distinct !{!474, !475, !"_ZN5pages12time_stepper10check_paceB4v101B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xxx: %retptr"}
!475 = distinct !{!475, !"_ZN5pages12time_stepper10check_paceB4v101B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xxx"}
!476 = distinct !{!476, !475, !"_ZN5pages12time_stepper10check_paceB4v101B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xxx: %excinfo"}
!477 = !{!478, !474, !476, !467, !469}
!478 = distinct !{!478, !479, !"_ZN5pages13solver_layout4failB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!479 = distinct !{!479, !"_ZN5pages13solver_layout4failB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!480 = !{!481, !474, !476, !467, !469}
!481 = distinct !{!481, !482, !"_ZN5pages13solver_layout4failB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!482 = distinct !{!482, !"_ZN5pages13solver_layout4failB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!483 = !{!484, !486, !467, !469}
!484 = distinct !{!484, !485, !"_ZN5pages8segments13enter_segmentB4v102B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!485 = distinct !{!485, !"_ZN5pages8segments13enter_segmentB4v102B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!486 = distinct !{!486, !485, !"_ZN5pages8segments13enter_segmentB4v102B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!487 = !{!488, !490, !484, !486, !467, !469}
!488 = distinct !{!488, !489, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!489 = distinct !{!489, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!490 = distinct !{!490, !489, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!491 = !{!492, !467, !469}
!492 = distinct !{!492, !493, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!493 = distinct !{!493, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!494 = !{!495, !497, !492, !467, !469}
!495 = distinct !{!495, !496, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!496 = distinct !{!496, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!497 = distinct !{!497, !496, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!498 = !{!499, !501, !492, !467, !469}
!499 = distinct !{!499, !500, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!500 = distinct !{!500, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!501 = distinct !{!501, !500, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!502 = !{!503, !505, !467, !469}
!503 = distinct !{!503, !504, !"_ZN5pages8segments14note_next_stopB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!504 = distinct !{!504, !"_ZN5pages8segments14note_next_stopB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!505 = distinct !{!505, !504, !"_ZN5pages8segments14note_next_stopB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!506 = !{!507, !509}
!507 = distinct !{!507, !508, !"_ZN5pages12time_stepper11count_stepsB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!508 = distinct !{!508, !"_ZN5pages12time_stepper11count_stepsB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!509 = distinct !{!509, !508, !"_ZN5pages12time_stepper11count_stepsB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!510 = !{!511, !77, !79}
!511 = distinct !{!511, !512, !"_ZN5pages13solver_layout10derivativeB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_281_29: %retptr"}
!512 = distinct !{!512, !"_ZN5pages13solver_layout10derivativeB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_281_29"}
!513 = !{!514, !516, !77, !79}
!514 = distinct !{!514, !515, !"_ZN5pages8implicit13factor_matrixB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!515 = distinct !{!515, !"_ZN5pages8implicit13factor_matrixB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!516 = distinct !{!516, !515, !"_ZN5pages8implicit13factor_matrixB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!517 = !{!518, !520, !521, !514, !516, !77, !79}
!518 = distinct !{!518, !519, !"_ZN5pages8implicit11set_changesB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!519 = distinct !{!519, !"_ZN5pages8implicit11set_changesB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE"}
!520 = distinct !{!520, !519, !"_ZN5pages8implicit11set_changesB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!521 = distinct !{!521, !522, !"_ZN5pages8implicit13differentiateB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!522 = distinct !{!522, !"_ZN5pages8implicit13differentiateB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!523 = !{!521, !514, !516, !77, !79}
!524 = !{!525, !527, !521, !514, !516, !77, !79}
!525 = distinct !{!525, !526, !"_ZN5pages8implicit16difference_ratesB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!526 = distinct !{!526, !"_ZN5pages8implicit16difference_ratesB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!527 = distinct !{!527, !526, !"_ZN5pages8implicit16difference_ratesB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!528 = !{!529, !525, !527, !521, !514, !516, !77, !79}
!529 = distinct !{!529, !530, !"_ZN5pages13solver_layout10derivativeB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!530 = distinct !{!530, !"_ZN5pages13solver_layout10derivativeB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!531 = !{!532, !514, !516, !77, !79}
!532 = distinct !{!532, !533, !"_ZN5pages8implicit6factorB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!533 = distinct !{!533, !"_ZN5pages8implicit6factorB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!534 = !{!535, !537, !538, !77, !79}
!535 = distinct !{!535, !536, !"_ZN5pages8implicit12find_nonzeroB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx450Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!536 = distinct !{!536, !"_ZN5pages8implicit12find_nonzeroB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx450Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedEx"}
!537 = distinct !{!537, !536, !"_ZN5pages8implicit12find_nonzeroB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx450Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!538 = distinct !{!538, !539, !"_ZN5pages8implicit11solve_stageB3v37B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!539 = distinct !{!539, !"_ZN5pages8implicit11solve_stageB3v37B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!540 = !{!538, !77, !79}
!541 = !{!542, !544, !538, !77, !79}
!542 = distinct !{!542, !543, !"_ZN5pages8implicit5solveB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!543 = distinct !{!543, !"_ZN5pages8implicit5solveB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!544 = distinct !{!544, !543, !"_ZN5pages8implicit5solveB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!545 = !{!546, !77, !79}
!546 = distinct !{!546, !547, !"_ZN5pages13solver_layout7formulaB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_286_29: %retptr"}
!547 = distinct !{!547, !"_ZN5pages13solver_layout7formulaB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_286_29"}
!548 = !{!549, !77, !79}
!549 = distinct !{!549, !550, !"_ZN5pages13solver_layout7formulaB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!550 = distinct !{!550, !"_ZN5pages13solver_layout7formulaB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!551 = !{!552, !77, !79}
!552 = distinct !{!552, !553, !"_ZN5pages13solver_layout10derivativeB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!553 = distinct !{!553, !"_ZN5pages13solver_layout10derivativeB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!554 = !{!555, !557}
!555 = distinct !{!555, !556, !"_ZN5pages12event_checks13first_crossedB3v64B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!556 = distinct !{!556, !"_ZN5pages12event_checks13first_crossedB3v64B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!557 = distinct !{!557, !556, !"_ZN5pages12event_checks13first_crossedB3v64B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!558 = !{!559, !561, !562, !564}
!559 = distinct !{!559, !560, !"_ZN5pages12event_checks13error_betweenB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!560 = distinct !{!560, !"_ZN5pages12event_checks13error_betweenB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!561 = distinct !{!561, !560, !"_ZN5pages12event_checks13error_betweenB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!562 = distinct !{!562, !563, !"_ZN5pages12event_checks8may_hideB3v67B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd: %retptr"}
!563 = distinct !{!563, !"_ZN5pages12event_checks8may_hideB3v67B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd"}
!564 = distinct !{!564, !563, !"_ZN5pages12event_checks8may_hideB3v67B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd: %excinfo"}
!565 = !{!562, !564}
!566 = !{!567, !569, !562, !564}
!567 = distinct !{!567, !568, !"_ZN5pages12event_checks17least_distance_ofB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd: %retptr"}
!568 = distinct !{!568, !"_ZN5pages12event_checks17least_distance_ofB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd"}
!569 = distinct !{!569, !568, !"_ZN5pages12event_checks17least_distance_ofB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd: %excinfo"}
!570 = !{!571}
!571 = distinct !{!571, !572, !"_ZN5pages13solver_layout5retryB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!572 = distinct !{!572, !"_ZN5pages13solver_layout5retryB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!573 = !{!574, !576}
!574 = distinct !{!574, !575, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!575 = distinct !{!575, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!576 = distinct !{!576, !575, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!577 = !{!578, !580}
!578 = distinct !{!578, !579, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!579 = distinct !{!579, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!580 = distinct !{!580, !579, !"_ZN5pages12event_checks14least_distanceB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!581 = !{!582, !584}
!582 = distinct !{!582, !583, !"_ZN5pages12event_checks13shortest_stepB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!583 = distinct !{!583, !"_ZN5pages12event_checks13shortest_stepB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!584 = distinct !{!584, !583, !"_ZN5pages12event_checks13shortest_stepB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}

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

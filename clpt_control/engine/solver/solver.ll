; sha256 0a8bf35003ffe431036d0c08496f7681362572b962b0795575d7110b944bac6a 02de2e692005d3b64e14abfd806a4c1fce7510a02d0df3f03ec54a2915daed8e, Python 3.11, numba 0.68.1

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
@switch.table._ZN5pages12event_checks13find_crossingB3v65B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7 = private unnamed_addr constant [18 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00, double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00], align 8

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
  %v323 = mul i64 %v135, 264
  %v324 = getelementptr i8, ptr %v133, i64 %v323
  %v325 = shl i64 %v135, 7
  %v326 = getelementptr i8, ptr %v133, i64 %v325
  %v327 = mul i64 %v135, 224
  %v328 = getelementptr i8, ptr %v133, i64 %v327
  %v329 = mul i64 %v135, 216
  %v330 = getelementptr i8, ptr %v133, i64 %v329
  %v331 = shl i64 %v135, 4
  %v332 = shl i64 %v135, 5
  %v333 = mul i64 %v135, 40
  %v334 = mul i64 %v135, 48
  %v335 = mul i64 %v135, 56
  %v336 = shl i64 %v135, 6
  %v337 = mul i64 %v135, 72
  %v338 = mul i64 %v135, 80
  %v339 = mul i64 %v135, 88
  %v340 = mul i64 %v135, 96
  %v341 = mul i64 %v135, 104
  %v342 = mul i64 %v135, 112
  %v343 = mul i64 %v135, 120
  %v344 = mul i64 %v135, 136
  %v345 = mul i64 %v135, 144
  %v346 = mul i64 %v135, 152
  %v347 = mul i64 %v135, 160
  %v348 = mul i64 %v135, 168
  %v349 = mul i64 %v135, 176
  %v350 = mul i64 %v135, 184
  %v351 = mul i64 %v135, 192
  %v352 = mul i64 %v135, 200
  %v353 = mul i64 %v135, 208
  %v354 = mul i64 %v135, 232
  %v355 = mul i64 %v135, 240
  %v356 = mul i64 %v135, 248
  %v357 = shl i64 %v135, 8
  %v358 = getelementptr i8, ptr %v133, i64 %v354
  %v359 = getelementptr i8, ptr %v133, i64 %v343
  %v360 = getelementptr i8, ptr %v133, i64 %v353
  %v361 = getelementptr i8, ptr %v133, i64 %v355
  %v362 = getelementptr i8, ptr %v133, i64 %v331
  br label %v363

v364:
  %v365 = getelementptr double, ptr %v312, i64 %v366
  store double 0.000000e+00, ptr %v365, align 8, !noalias !0
  %v367 = load i64, ptr %v151, align 8, !noalias !0
  %v368 = load i64, ptr %v313, align 8, !noalias !0
  %v369 = icmp eq i64 %v367, %v368
  br i1 %v369, label %v370, label %v371

v371:
  %v372 = add nsw i64 %v367, 1
  store i64 %v372, ptr %v151, align 8, !noalias !0
  store i64 2, ptr %v314, align 8, !noalias !0
  %v373 = getelementptr i64, ptr %v142, i64 %v366
  store i64 %v367, ptr %v373, align 8, !noalias !0
  %v374 = icmp slt i64 %v367, 0
  %v375 = select i1 %v374, i64 %v49, i64 0
  %v376 = getelementptr i64, ptr %v48, i64 %v367
  %v377 = getelementptr i64, ptr %v376, i64 %v375
  %v378 = load i64, ptr %v377, align 8, !noalias !0
  %v379 = icmp slt i64 %v378, 0
  %v380 = select i1 %v379, i64 %v56, i64 0
  %v381 = getelementptr i64, ptr %v55, i64 %v378
  %v382 = getelementptr i64, ptr %v381, i64 %v380
  %v383 = load i64, ptr %v382, align 8, !noalias !0
  %v384 = getelementptr i64, ptr %v315, i64 %v366
  store i64 %v383, ptr %v384, align 8, !noalias !0
  %v385 = getelementptr i64, ptr %v317, i64 %v366
  store i64 1, ptr %v385, align 8, !noalias !0
  %v386 = getelementptr i64, ptr %v319, i64 %v366
  store i64 0, ptr %v386, align 8, !noalias !0
  br i1 %v320, label %v387, label %v388

v388:
  %v389 = select i1 %v374, i64 %v40, i64 0
  %v390 = add i64 %v389, %v367
  %v391 = mul i64 %v390, %v41
  %v392 = getelementptr double, ptr %v39, i64 %v391
  %v393 = getelementptr double, ptr %v165, i64 %v366
  br label %v394

v387:
  br i1 %v321, label %v395, label %v396

v396:
  %v397 = load i64, ptr %v384, align 8, !noalias !0
  %v398 = icmp slt i64 %v397, 0
  %v399 = select i1 %v398, i64 %v77, i64 0
  %v400 = add i64 %v399, %v397
  %v401 = mul i64 %v400, %v78
  %v402 = getelementptr double, ptr %v76, i64 %v401
  br label %v403

v403:
  %v404 = phi i64 [ 0, %v396 ], [ %v405, %v403 ]
  %v405 = add nsw i64 %v404, 1
  %v406 = getelementptr double, ptr %v402, i64 %v404
  %v407 = load double, ptr %v406, align 8, !noalias !3
  %v408 = getelementptr i64, ptr %v62, i64 %v404
  %v409 = load i64, ptr %v408, align 8, !noalias !3
  %v410 = mul nsw i64 %v409, %v9
  %v411 = add nsw i64 %v410, %v366
  %v412 = icmp slt i64 %v411, 0
  %v413 = select i1 %v412, i64 %v166, i64 0
  %v414 = getelementptr double, ptr %v165, i64 %v411
  %v415 = getelementptr double, ptr %v414, i64 %v413
  store double %v407, ptr %v415, align 8, !noalias !3
  %v416 = icmp eq i64 %v405, %v63
  br i1 %v416, label %v395, label %v403

v417:
  %v418 = getelementptr double, ptr %v133, i64 %v366
  %v419 = getelementptr double, ptr %v324, i64 %v366
  %v420 = load double, ptr %v419, align 8, !noalias !7
  %v421 = getelementptr double, ptr %v326, i64 %v366
  %v422 = load double, ptr %v421, align 8, !noalias !7
  %v423 = getelementptr double, ptr %v328, i64 %v366
  %v424 = load double, ptr %v423, align 8, !noalias !7
  %v425 = getelementptr double, ptr %v330, i64 %v366
  %v426 = load double, ptr %v425, align 8, !noalias !7
  store double 0.000000e+00, ptr %v418, align 8, !noalias !7
  %v427 = getelementptr double, ptr %v418, i64 %v135
  store double 0.000000e+00, ptr %v427, align 8, !noalias !7
  %v428 = getelementptr i8, ptr %v418, i64 %v331
  store double 0.000000e+00, ptr %v428, align 8, !noalias !7
  %v429 = getelementptr i8, ptr %v418, i64 %v311
  store double 0.000000e+00, ptr %v429, align 8, !noalias !7
  %v430 = getelementptr i8, ptr %v418, i64 %v332
  store double 0.000000e+00, ptr %v430, align 8, !noalias !7
  %v431 = getelementptr i8, ptr %v418, i64 %v333
  store double 0.000000e+00, ptr %v431, align 8, !noalias !7
  %v432 = getelementptr i8, ptr %v418, i64 %v334
  store double 0.000000e+00, ptr %v432, align 8, !noalias !7
  %v433 = getelementptr i8, ptr %v418, i64 %v335
  store double 0.000000e+00, ptr %v433, align 8, !noalias !7
  %v434 = getelementptr i8, ptr %v418, i64 %v336
  store double 0.000000e+00, ptr %v434, align 8, !noalias !7
  %v435 = getelementptr i8, ptr %v418, i64 %v337
  store double 0.000000e+00, ptr %v435, align 8, !noalias !7
  %v436 = getelementptr i8, ptr %v418, i64 %v338
  store double 0.000000e+00, ptr %v436, align 8, !noalias !7
  %v437 = getelementptr i8, ptr %v418, i64 %v339
  store double 0.000000e+00, ptr %v437, align 8, !noalias !7
  %v438 = getelementptr i8, ptr %v418, i64 %v340
  store double 0.000000e+00, ptr %v438, align 8, !noalias !7
  %v439 = getelementptr i8, ptr %v418, i64 %v341
  store double 0.000000e+00, ptr %v439, align 8, !noalias !7
  %v440 = getelementptr i8, ptr %v418, i64 %v342
  store double 0.000000e+00, ptr %v440, align 8, !noalias !7
  %v441 = getelementptr i8, ptr %v418, i64 %v343
  store double 0.000000e+00, ptr %v441, align 8, !noalias !7
  %v442 = getelementptr i8, ptr %v418, i64 %v325
  store double 0.000000e+00, ptr %v442, align 8, !noalias !7
  %v443 = getelementptr i8, ptr %v418, i64 %v344
  store double 0.000000e+00, ptr %v443, align 8, !noalias !7
  %v444 = getelementptr i8, ptr %v418, i64 %v345
  store double 0.000000e+00, ptr %v444, align 8, !noalias !7
  %v445 = getelementptr i8, ptr %v418, i64 %v346
  store double 0.000000e+00, ptr %v445, align 8, !noalias !7
  %v446 = getelementptr i8, ptr %v418, i64 %v347
  store double 0.000000e+00, ptr %v446, align 8, !noalias !7
  %v447 = getelementptr i8, ptr %v418, i64 %v348
  store double 0.000000e+00, ptr %v447, align 8, !noalias !7
  %v448 = getelementptr i8, ptr %v418, i64 %v349
  store double 0.000000e+00, ptr %v448, align 8, !noalias !7
  %v449 = getelementptr i8, ptr %v418, i64 %v350
  store double 0.000000e+00, ptr %v449, align 8, !noalias !7
  %v450 = getelementptr i8, ptr %v418, i64 %v351
  store double 0.000000e+00, ptr %v450, align 8, !noalias !7
  %v451 = getelementptr i8, ptr %v418, i64 %v352
  store double 0.000000e+00, ptr %v451, align 8, !noalias !7
  %v452 = getelementptr i8, ptr %v418, i64 %v353
  store double 0.000000e+00, ptr %v452, align 8, !noalias !7
  %v453 = getelementptr i8, ptr %v418, i64 %v329
  store double 0.000000e+00, ptr %v453, align 8, !noalias !7
  %v454 = getelementptr i8, ptr %v418, i64 %v327
  store double 0.000000e+00, ptr %v454, align 8, !noalias !7
  %v455 = getelementptr i8, ptr %v418, i64 %v354
  store double 0.000000e+00, ptr %v455, align 8, !noalias !7
  %v456 = getelementptr i8, ptr %v418, i64 %v355
  store double 0.000000e+00, ptr %v456, align 8, !noalias !7
  %v457 = getelementptr i8, ptr %v418, i64 %v356
  store double 0.000000e+00, ptr %v457, align 8, !noalias !7
  %v458 = getelementptr i8, ptr %v418, i64 %v357
  store double 0.000000e+00, ptr %v458, align 8, !noalias !7
  %v459 = getelementptr i8, ptr %v418, i64 %v323
  store double 0.000000e+00, ptr %v459, align 8, !noalias !7
  %v460 = fcmp oeq double %v426, 0xFFF0000000000000
  %v461 = select i1 %v460, double 0xFFF0000000000000, double 0.000000e+00
  store double %v461, ptr %v425, align 8, !noalias !7
  store double %v424, ptr %v423, align 8, !noalias !7
  store double %v422, ptr %v421, align 8, !noalias !7
  %v462 = fcmp oeq double %v420, 0xFFF0000000000000
  %v463 = select i1 %v462, double 0xFFF0000000000000, double 0.000000e+00
  store double %v463, ptr %v419, align 8, !noalias !7
  %v464 = getelementptr double, ptr %v358, i64 %v366
  store double 5.000000e+03, ptr %v464, align 8, !noalias !7
  store double 1.000000e+00, ptr %v365, align 8, !noalias !7
  %v465 = getelementptr double, ptr %v359, i64 %v366
  store double 0xFFF0000000000000, ptr %v465, align 8, !noalias !7
  %v466 = getelementptr double, ptr %v360, i64 %v366
  store double 0x7FF0000000000000, ptr %v466, align 8, !noalias !7
  %v467 = load double, ptr %v92, align 8, !noalias !0
  store double %v467, ptr %v418, align 8, !noalias !0
  %v468 = load double, ptr %v92, align 8, !noalias !0
  %v469 = getelementptr double, ptr %v361, i64 %v366
  store double %v468, ptr %v469, align 8, !noalias !0
  %v470 = load i64, ptr %v384, align 8, !noalias !0
  %v471 = icmp slt i64 %v470, 0
  %v472 = select i1 %v471, i64 %v70, i64 0
  %v473 = getelementptr double, ptr %v69, i64 %v470
  %v474 = getelementptr double, ptr %v473, i64 %v472
  %v475 = load double, ptr %v474, align 8, !noalias !0
  %v476 = getelementptr double, ptr %v362, i64 %v366
  store double %v475, ptr %v476, align 8, !noalias !0
  br label %v370

v394:
  %v477 = phi i64 [ 0, %v388 ], [ %v478, %v394 ]
  %v478 = add nsw i64 %v477, 1
  %v479 = getelementptr double, ptr %v392, i64 %v477
  %v480 = load double, ptr %v479, align 8, !noalias !0
  %v481 = mul nsw i64 %v477, %v9
  %v482 = getelementptr double, ptr %v393, i64 %v481
  store double %v480, ptr %v482, align 8, !noalias !0
  %v483 = icmp eq i64 %v478, %v41
  br i1 %v483, label %v387, label %v394

v395:
  br i1 %v322, label %v417, label %v484

v484:
  %v485 = getelementptr double, ptr %v193, i64 %v366
  %v486 = select i1 %v374, i64 %v31, i64 0
  %v487 = add i64 %v486, %v367
  %v488 = mul i64 %v487, %v32
  %v489 = getelementptr double, ptr %v30, i64 %v488
  br label %v490

v490:
  %v491 = phi i64 [ 0, %v484 ], [ %v492, %v490 ]
  %v492 = add nsw i64 %v491, 1
  %v493 = getelementptr double, ptr %v489, i64 %v491
  %v494 = load double, ptr %v493, align 8, !noalias !0
  %v495 = mul i64 %v491, %v196
  %v496 = getelementptr double, ptr %v485, i64 %v495
  store double %v494, ptr %v496, align 8, !noalias !0
  %v497 = icmp eq i64 %v492, %v10
  br i1 %v497, label %v417, label %v490

v370:
  %v498 = load i64, ptr %v499, align 8
  %v500 = icmp sgt i64 %v498, -1
  %v501 = zext i1 %v500 to i64
  %v502 = add nsw i64 %v503, %v501
  %v504 = icmp sgt i64 %v505, 1
  br i1 %v504, label %v363, label %v309

v309:
  %v506 = phi i64 [ 0, %v299 ], [ %v502, %v370 ]
  %v507 = icmp ne i64 %v506, 0
  %v508 = icmp sgt i64 %v297, 0
  %v509 = select i1 %v507, i1 %v508, i1 false
  br i1 %v509, label %v510, label %v511

v510:
  %v512 = getelementptr i8, ptr %v151, i64 16
  %v513 = mul i64 %v10, %v9
  %v514 = mul i64 %v196, %v195
  %v515 = shl i64 %v196, 7
  %v516 = mul i64 %v207, %v206
  %v517 = getelementptr i8, ptr %v6, i64 8
  %v518 = getelementptr i8, ptr %v6, i64 32
  %v519 = mul i64 %v135, 24
  %v520 = getelementptr i8, ptr %v133, i64 %v519
  %v521 = icmp sgt i64 %v18, 0
  %v522 = getelementptr i8, ptr %v6, i64 32
  %v523 = mul i64 %v135, 24
  %v524 = getelementptr i8, ptr %v133, i64 %v523
  %v525 = icmp slt i64 %v18, 1
  %v526 = icmp eq i64 %v14, 0
  %v527 = mul nsw i64 %v10, %v9
  %v528 = shl i64 %v527, 4
  %v529 = getelementptr i8, ptr %v158, i64 %v528
  %v530 = getelementptr i8, ptr %v6, i64 56
  %v531 = getelementptr i8, ptr %v6, i64 64
  %v532 = shl i64 %v135, 6
  %v533 = getelementptr i8, ptr %v133, i64 %v532
  %v534 = mul i64 %v527, 136
  %v535 = getelementptr i8, ptr %v158, i64 %v534
  %v536 = mul i64 %v527, 24
  %v537 = getelementptr i8, ptr %v158, i64 %v536
  %v538 = getelementptr i8, ptr %v6, i64 72
  %v539 = mul i64 %v513, 112
  %v540 = mul i64 %v135, 24
  %v541 = getelementptr i8, ptr %v133, i64 %v540
  %v542 = shl i64 %v135, 5
  %v543 = getelementptr i8, ptr %v133, i64 %v542
  %v544 = shl i64 %v135, 7
  %v545 = getelementptr i8, ptr %v133, i64 %v544
  %v546 = icmp slt i64 %v14, 1
  %v547 = select i1 %v546, i64 2, i64 0
  %v548 = zext i1 %v546 to i64
  %v549 = mul i64 %v135, 88
  %v550 = getelementptr i8, ptr %v133, i64 %v549
  %v551 = getelementptr double, ptr %v92, i64 %v93
  %v552 = getelementptr i8, ptr %v551, i64 -8
  %v553 = shl i64 %v135, 6
  %v554 = getelementptr i8, ptr %v133, i64 %v553
  %v555 = getelementptr i8, ptr %v158, i64 %v539
  %v556 = icmp slt i64 %v10, 1
  %v557 = mul i64 %v196, %v195
  %v558 = mul i64 %v557, 112
  %v559 = getelementptr i8, ptr %v193, i64 %v558
  %v560 = shl i64 %v557, 7
  %v561 = getelementptr i8, ptr %v193, i64 %v560
  %v562 = getelementptr i8, ptr %v6, i64 32
  %v563 = mul i64 %v207, 216
  %v564 = getelementptr i8, ptr %v186, i64 %v563
  %v565 = shl i64 %v10, 7
  %v566 = getelementptr i8, ptr %v158, i64 %v565
  %v567 = mul i64 %v207, 240
  %v568 = getelementptr i8, ptr %v186, i64 %v567
  %v569 = sub i64 %v207, %v18
  %v570 = tail call i64 @llvm.smax.i64(i64 %v569, i64 0)
  %v571 = getelementptr double, ptr %v204, i64 %v207
  %v572 = mul i64 %v207, %v206
  %v573 = mul i64 %v572, 80
  %v574 = getelementptr i8, ptr %v571, i64 %v573
  %v575 = mul i64 %v572, 72
  %v576 = getelementptr i8, ptr %v204, i64 %v575
  %v577 = getelementptr double, ptr %v576, i64 %v207
  %v578 = shl i64 %v207, 4
  %v579 = getelementptr i8, ptr %v576, i64 %v578
  %v580 = shl i64 %v144, 5
  %v581 = getelementptr i8, ptr %v142, i64 %v580
  %v582 = shl i64 %v135, 4
  %v583 = getelementptr i8, ptr %v133, i64 %v582
  %v584 = mul i64 %v135, 112
  %v585 = getelementptr i8, ptr %v133, i64 %v584
  %v586 = shl i64 %v135, 4
  %v587 = getelementptr i8, ptr %v133, i64 %v586
  %v588 = mul i64 %v135, 152
  %v589 = getelementptr i8, ptr %v133, i64 %v588
  %v590 = shl i64 %v144, 4
  %v591 = getelementptr i8, ptr %v142, i64 %v590
  %v592 = getelementptr i8, ptr %v6, i64 40
  %v593 = icmp sgt i64 %v14, 0
  %v594 = mul nsw i64 %v10, %v9
  %v595 = getelementptr double, ptr %v158, i64 %v594
  %v596 = icmp sgt i64 %v13, 0
  %v597 = shl i64 %v135, 5
  %v598 = getelementptr i8, ptr %v133, i64 %v597
  %v599 = icmp slt i64 %v10, 1
  %v600 = mul i64 %v196, %v195
  %v601 = mul i64 %v600, 136
  %v602 = getelementptr i8, ptr %v193, i64 %v601
  %v603 = mul i64 %v600, 88
  %v604 = getelementptr i8, ptr %v193, i64 %v603
  %v605 = mul nsw i64 %v10, 19
  %v606 = add nsw i64 %v605, 1
  %v607 = mul nsw i64 %v10, 18
  %v608 = icmp slt i64 %v10, 0
  %v609 = select i1 %v608, i64 %v159, i64 0
  %v610 = add i64 %v609, %v607
  %v611 = icmp slt i64 %v610, 0
  %v612 = icmp slt i64 %v610, %v159
  %v613 = add i64 %v606, %v609
  %v614 = icmp slt i64 %v613, 0
  %v615 = icmp slt i64 %v613, %v159
  %v616 = icmp sgt i64 %v274, 1
  %v617 = mul i64 %v196, %v195
  %v618 = getelementptr i8, ptr %v23, i64 8
  %v619 = select i1 %v608, i64 %v267, i64 0
  %v620 = getelementptr i64, ptr %v266, i64 %v10
  %v621 = getelementptr i64, ptr %v620, i64 %v619
  %v622 = mul i64 %v135, 48
  %v623 = getelementptr i8, ptr %v133, i64 %v622
  %v624 = mul i64 %v617, 136
  %v625 = shl i64 %v135, 6
  %v626 = getelementptr i8, ptr %v133, i64 %v625
  %v627 = mul nsw i64 %v10, %v9
  %v628 = mul i64 %v627, 136
  %v629 = getelementptr i8, ptr %v158, i64 %v628
  %v630 = getelementptr i8, ptr %v193, i64 %v624
  %v631 = mul i64 %v617, 96
  %v632 = getelementptr i8, ptr %v193, i64 %v631
  %v633 = mul i64 %v617, 104
  %v634 = getelementptr i8, ptr %v193, i64 %v633
  %v635 = getelementptr double, ptr %v193, i64 %v617
  %v636 = mul i64 %v617, 88
  %v637 = getelementptr i8, ptr %v193, i64 %v636
  %v638 = mul i64 %v627, 96
  %v639 = getelementptr i8, ptr %v158, i64 %v638
  %v640 = mul i64 %v627, 96
  %v641 = getelementptr i8, ptr %v158, i64 %v640
  %v642 = mul i64 %v627, 104
  %v643 = getelementptr i8, ptr %v158, i64 %v642
  %v644 = add nsw i64 %v274, -2
  %v645 = icmp sgt i64 %v10, 0
  %v646 = add i64 %v254, %v253
  %v647 = add i64 %v253, 1
  %v648 = add i64 %v10, 1
  %v649 = mul i64 %v135, 144
  %v650 = getelementptr i8, ptr %v133, i64 %v649
  %v651 = add i64 %v254, 1
  %v652 = add i64 %v11, -1
  %v653 = tail call i64 @llvm.smax.i64(i64 %v652, i64 0)
  %v654 = mul i64 %v514, 136
  %v655 = icmp slt i64 %v652, 1
  %v656 = shl i64 %v135, 6
  %v657 = getelementptr i8, ptr %v133, i64 %v656
  %v658 = mul nsw i64 %v10, %v9
  %v659 = mul i64 %v658, 136
  %v660 = getelementptr i8, ptr %v158, i64 %v659
  %v661 = icmp slt i64 %v10, 1
  %v662 = mul i64 %v196, %v195
  %v663 = mul i64 %v662, 80
  %v664 = getelementptr i8, ptr %v193, i64 %v663
  %v665 = mul i64 %v662, 136
  %v666 = getelementptr i8, ptr %v193, i64 %v665
  %v667 = mul nsw i64 %v10, 17
  %v668 = getelementptr double, ptr %v158, i64 %v667
  %v669 = add i64 %v253, 1
  %v670 = add i64 %v253, 1
  %v671 = getelementptr double, ptr %v158, i64 %v667
  %v672 = add i64 %v254, %v253
  %v673 = getelementptr i8, ptr %v193, i64 %v654
  %v674 = mul i64 %v196, %v195
  %v675 = getelementptr i8, ptr %v6, i64 48
  %v676 = or i1 %v596, %v306
  %v677 = mul i64 %v135, 40
  %v678 = getelementptr i8, ptr %v133, i64 %v677
  %v679 = mul i64 %v135, 168
  %v680 = getelementptr i8, ptr %v133, i64 %v679
  %v681 = mul i64 %v135, 176
  %v682 = getelementptr i8, ptr %v133, i64 %v681
  %v683 = mul i64 %v135, 184
  %v684 = getelementptr i8, ptr %v133, i64 %v683
  %v685 = mul i64 %v135, 160
  %v686 = getelementptr i8, ptr %v133, i64 %v685
  %v687 = shl i64 %v144, 4
  %v688 = getelementptr i8, ptr %v142, i64 %v687
  %v689 = mul i64 %v135, 192
  %v690 = getelementptr i8, ptr %v133, i64 %v689
  %v691 = mul i64 %v135, 72
  %v692 = getelementptr i8, ptr %v133, i64 %v691
  %v693 = mul i64 %v135, 40
  %v694 = getelementptr i8, ptr %v133, i64 %v693
  %v695 = mul i64 %v135, 56
  %v696 = getelementptr i8, ptr %v133, i64 %v695
  %v697 = mul i64 %v135, 216
  %v698 = getelementptr i8, ptr %v133, i64 %v697
  %v699 = icmp eq i64 %v14, 0
  %v700 = icmp ne i64 %v13, 0
  %v701 = xor i1 %v699, true
  %v702 = select i1 %v701, i1 true, i1 %v700
  %v703 = shl i64 %v135, 6
  %v704 = getelementptr i8, ptr %v133, i64 %v703
  %v705 = mul nsw i64 %v10, %v9
  %v706 = mul i64 %v705, 136
  %v707 = getelementptr i8, ptr %v158, i64 %v706
  %v708 = mul i64 %v705, 104
  %v709 = getelementptr i8, ptr %v158, i64 %v708
  %v710 = getelementptr i8, ptr %v6, i64 104
  %v711 = getelementptr i8, ptr %v6, i64 96
  %v712 = mul i64 %v196, %v195
  %v713 = mul i64 %v135, 48
  %v714 = getelementptr i8, ptr %v133, i64 %v713
  %v715 = shl i64 %v135, 6
  %v716 = getelementptr i8, ptr %v133, i64 %v715
  %v717 = shl i64 %v712, 7
  %v718 = icmp slt i64 %v10, 1
  %v719 = getelementptr i8, ptr %v193, i64 %v717
  %v720 = mul i64 %v207, 3
  %v721 = getelementptr i8, ptr %v6, i64 32
  %v722 = mul i64 %v712, 192
  %v723 = mul i64 %v712, 184
  %v724 = mul i64 %v712, 176
  %v725 = mul i64 %v712, 168
  %v726 = mul i64 %v712, 160
  %v727 = mul i64 %v712, 152
  %v728 = mul i64 %v712, 144
  %v729 = mul i64 %v135, 56
  %v730 = getelementptr i8, ptr %v133, i64 %v729
  %v731 = tail call i64 @llvm.smax.i64(i64 %v207, i64 0)
  %v732 = mul i64 %v207, %v206
  %v733 = getelementptr double, ptr %v204, i64 %v207
  %v734 = mul i64 %v207, %v206
  %v735 = getelementptr double, ptr %v204, i64 %v207
  %v736 = getelementptr double, ptr %v204, i64 %v207
  %v737 = shl i64 %v207, 4
  %v738 = getelementptr i8, ptr %v204, i64 %v737
  %v739 = icmp sgt i64 %v12, 0
  %v740 = add nsw i64 %v11, 13
  %v741 = shl i64 %v135, 6
  %v742 = getelementptr i8, ptr %v133, i64 %v741
  %v743 = mul nsw i64 %v10, %v9
  %v744 = mul i64 %v743, 136
  %v745 = getelementptr i8, ptr %v158, i64 %v744
  %v746 = icmp slt i64 %v11, -13
  %v747 = select i1 %v746, i64 %v7, i64 0
  %v748 = getelementptr i64, ptr %v6, i64 %v11
  %v749 = getelementptr i8, ptr %v748, i64 104
  %v750 = getelementptr i64, ptr %v749, i64 %v747
  %v751 = getelementptr i8, ptr %v6, i64 88
  %v752 = shl i64 %v144, 4
  %v753 = getelementptr i8, ptr %v142, i64 %v752
  %v754 = mul i64 %v135, 40
  %v755 = getelementptr i8, ptr %v133, i64 %v754
  %v756 = mul i64 %v135, 56
  %v757 = getelementptr i8, ptr %v133, i64 %v756
  %v758 = mul i64 %v135, 200
  %v759 = getelementptr i8, ptr %v133, i64 %v758
  %v760 = mul i64 %v135, 48
  %v761 = getelementptr i8, ptr %v133, i64 %v760
  %v762 = shl i64 %v135, 5
  %v763 = getelementptr i8, ptr %v133, i64 %v762
  %v764 = getelementptr double, ptr %v133, i64 %v135
  %v765 = mul i64 %v135, 208
  %v766 = getelementptr i8, ptr %v133, i64 %v765
  %v767 = getelementptr inbounds i8, ptr %v302, i64 8
  %v768 = getelementptr inbounds i8, ptr %v302, i64 16
  %v769 = getelementptr inbounds i8, ptr %v302, i64 24
  %v770 = mul i64 %v196, %v195
  %v771 = mul i64 %v135, 48
  %v772 = getelementptr i8, ptr %v133, i64 %v771
  %v773 = shl i64 %v135, 6
  %v774 = getelementptr i8, ptr %v133, i64 %v773
  %v775 = shl i64 %v770, 7
  %v776 = icmp sgt i64 %v10, 0
  %v777 = getelementptr i8, ptr %v193, i64 %v775
  %v778 = mul i64 %v207, 3
  %v779 = getelementptr i8, ptr %v6, i64 32
  %v780 = mul i64 %v770, 192
  %v781 = mul i64 %v770, 184
  %v782 = mul i64 %v770, 176
  %v783 = mul i64 %v770, 168
  %v784 = mul i64 %v770, 160
  %v785 = mul i64 %v770, 152
  %v786 = mul i64 %v770, 144
  %v787 = getelementptr double, ptr %v92, i64 %v93
  %v788 = getelementptr i8, ptr %v787, i64 -8
  %v789 = icmp slt i64 %v15, 1
  %v790 = mul i64 %v207, %v206
  %v791 = shl i64 %v207, 4
  %v792 = getelementptr double, ptr %v204, i64 %v207
  %v793 = getelementptr i8, ptr %v204, i64 %v791
  %v794 = shl i64 %v790, 4
  %v795 = mul i64 %v790, 24
  %v796 = shl i64 %v790, 5
  %v797 = mul i64 %v790, 40
  %v798 = mul i64 %v790, 48
  %v799 = mul i64 %v790, 56
  %v800 = shl i64 %v790, 6
  %v801 = shl i64 %v144, 5
  %v802 = getelementptr i8, ptr %v142, i64 %v801
  %v803 = getelementptr double, ptr %v92, i64 %v93
  %v804 = getelementptr i8, ptr %v803, i64 -8
  %v805 = mul i64 %v135, 56
  %v806 = getelementptr i8, ptr %v133, i64 %v805
  %v807 = mul i64 %v135, 120
  %v808 = getelementptr i8, ptr %v133, i64 %v807
  %v809 = mul i64 %v207, %v206
  %v810 = shl i64 %v10, 7
  %v811 = getelementptr i8, ptr %v158, i64 %v810
  %v812 = mul i64 %v207, 216
  %v813 = getelementptr i8, ptr %v186, i64 %v812
  %v814 = sub i64 %v207, %v18
  %v815 = tail call i64 @llvm.smax.i64(i64 %v814, i64 0)
  %v816 = icmp sgt i64 %v814, 0
  %v817 = shl i64 %v809, 6
  %v818 = getelementptr i8, ptr %v204, i64 %v817
  %v819 = shl i64 %v207, 4
  %v820 = getelementptr i8, ptr %v818, i64 %v819
  %v821 = mul i64 %v809, 72
  %v822 = getelementptr i8, ptr %v204, i64 %v821
  %v823 = getelementptr i8, ptr %v822, i64 %v819
  %v824 = icmp slt i64 %v207, 1
  %v825 = getelementptr double, ptr %v822, i64 %v207
  %v826 = getelementptr inbounds i8, ptr %v300, i64 8
  %v827 = getelementptr inbounds i8, ptr %v300, i64 16
  %v828 = getelementptr inbounds i8, ptr %v300, i64 24
  %v829 = mul i64 %v809, 80
  %v830 = getelementptr i8, ptr %v204, i64 %v829
  %v831 = tail call i64 @llvm.smax.i64(i64 %v10, i64 0)
  %v832 = mul i64 %v515, %v195
  %v833 = getelementptr i8, ptr %v193, i64 %v832
  %v834 = mul nsw i64 %v10, %v9
  %v835 = shl i64 %v834, 7
  %v836 = getelementptr i8, ptr %v158, i64 %v835
  %v837 = mul i64 %v834, 112
  %v838 = getelementptr i8, ptr %v158, i64 %v837
  %v839 = getelementptr i8, ptr %v6, i64 8
  %v840 = mul i64 %v834, 120
  %v841 = getelementptr i8, ptr %v158, i64 %v840
  %v842 = getelementptr i8, ptr %v23, i64 8
  %v843 = mul i64 %v770, 120
  %v844 = getelementptr i8, ptr %v193, i64 %v843
  %v845 = mul i64 %v770, 112
  %v846 = getelementptr i8, ptr %v193, i64 %v845
  %v847 = mul i64 %v135, 40
  %v848 = getelementptr i8, ptr %v133, i64 %v847
  %v849 = icmp slt i64 %v18, 1
  %v850 = mul i64 %v809, 80
  %v851 = getelementptr i8, ptr %v204, i64 %v850
  %v852 = mul i64 %v834, 136
  %v853 = getelementptr i8, ptr %v158, i64 %v852
  %v854 = mul i64 %v834, 104
  %v855 = getelementptr i8, ptr %v158, i64 %v854
  %v856 = mul i64 %v135, 40
  %v857 = getelementptr i8, ptr %v133, i64 %v856
  %v858 = select i1 %v824, i64 0, i64 %v207
  %v859 = icmp slt i64 %v10, 1
  %v860 = icmp slt i64 %v814, 1
  %v861 = mul i64 %v135, 104
  %v862 = getelementptr i8, ptr %v133, i64 %v861
  %v863 = mul i64 %v135, 112
  %v864 = getelementptr i8, ptr %v133, i64 %v863
  %v865 = shl i64 %v144, 4
  %v866 = getelementptr i8, ptr %v142, i64 %v865
  %v867 = mul i64 %v135, 208
  %v868 = getelementptr i8, ptr %v133, i64 %v867
  %v869 = mul i64 %v102, %v101
  %v870 = mul i64 %v770, 136
  %v871 = getelementptr i8, ptr %v193, i64 %v870
  %v872 = add i64 %v93, -1
  %v873 = mul i64 %v135, 40
  %v874 = getelementptr i8, ptr %v133, i64 %v873
  %v875 = mul i64 %v135, 96
  %v876 = getelementptr i8, ptr %v133, i64 %v875
  %v877 = mul i64 %v135, 200
  %v878 = getelementptr i8, ptr %v133, i64 %v877
  %v879 = mul i64 %v135, 40
  %v880 = getelementptr i8, ptr %v133, i64 %v879
  %v881 = shl i64 %v135, 5
  %v882 = getelementptr i8, ptr %v133, i64 %v881
  %v883 = getelementptr double, ptr %v133, i64 %v135
  %v884 = icmp slt i64 %v10, 1
  %v885 = mul i64 %v770, 136
  %v886 = getelementptr i8, ptr %v193, i64 %v885
  %v887 = mul nsw i64 %v10, %v9
  %v888 = mul i64 %v887, 136
  %v889 = getelementptr i8, ptr %v158, i64 %v888
  %v890 = mul i64 %v887, 104
  %v891 = getelementptr i8, ptr %v158, i64 %v890
  %v892 = mul i64 %v10, 136
  %v893 = getelementptr i8, ptr %v158, i64 %v892
  %v894 = mul i64 %v207, 192
  %v895 = getelementptr i8, ptr %v186, i64 %v894
  %v896 = mul i64 %v196, %v195
  %v897 = mul i64 %v135, 40
  %v898 = getelementptr i8, ptr %v133, i64 %v897
  %v899 = mul i64 %v135, 56
  %v900 = getelementptr i8, ptr %v133, i64 %v899
  %v901 = shl i64 %v144, 4
  %v902 = getelementptr i8, ptr %v142, i64 %v901
  %v903 = mul i64 %v135, 48
  %v904 = getelementptr i8, ptr %v133, i64 %v903
  %v905 = mul i64 %v896, 136
  %v906 = icmp slt i64 %v10, 1
  %v907 = mul i64 %v135, 208
  %v908 = getelementptr i8, ptr %v133, i64 %v907
  %v909 = mul i64 %v102, %v101
  %v910 = getelementptr i8, ptr %v193, i64 %v905
  %v911 = add i64 %v93, -1
  %v912 = mul i64 %v896, 192
  %v913 = mul i64 %v896, 184
  %v914 = mul i64 %v896, 176
  %v915 = mul i64 %v896, 168
  %v916 = mul i64 %v896, 160
  %v917 = mul i64 %v896, 152
  %v918 = mul i64 %v896, 144
  %v919 = icmp sgt i64 %v9, 1
  %v920 = mul i64 %v135, 40
  %v921 = getelementptr i8, ptr %v133, i64 %v920
  %v922 = getelementptr i8, ptr %v6, i64 80
  %v923 = mul i64 %v135, 40
  %v924 = getelementptr i8, ptr %v133, i64 %v923
  %v925 = shl i64 %v516, 6
  %v926 = icmp sgt i64 %v18, 0
  %v927 = getelementptr i8, ptr %v204, i64 %v925
  %v928 = mul i64 %v135, 96
  %v929 = getelementptr i8, ptr %v133, i64 %v928
  %v930 = mul i64 %v135, 120
  %v931 = getelementptr i8, ptr %v133, i64 %v930
  %v932 = icmp slt i64 %v10, 1
  %v933 = getelementptr i8, ptr %v23, i64 8
  %v934 = getelementptr double, ptr %v92, i64 %v93
  %v935 = getelementptr i8, ptr %v934, i64 -8
  %v936 = mul i64 %v144, 24
  %v937 = getelementptr i8, ptr %v142, i64 %v936
  %v938 = mul i64 %v144, 24
  %v939 = getelementptr i8, ptr %v142, i64 %v938
  %v940 = mul i64 %v135, 24
  %v941 = getelementptr i8, ptr %v133, i64 %v940
  %v942 = icmp ne i64 %v16, 0
  %v943 = tail call i64 @llvm.smax.i64(i64 %v9, i64 0)
  %v944 = mul i64 %v135, 40
  %v945 = getelementptr i8, ptr %v133, i64 %v944
  %v946 = shl i64 %v135, 4
  %v947 = getelementptr i8, ptr %v133, i64 %v946
  %v948 = getelementptr i64, ptr %v142, i64 %v144
  %v949 = icmp slt i64 %v63, 1
  %v950 = getelementptr i8, ptr %v6, i64 8
  %v951 = mul nsw i64 %v10, %v9
  %v952 = getelementptr i8, ptr %v6, i64 24
  %v953 = mul i64 %v951, 136
  %v954 = getelementptr i8, ptr %v158, i64 %v953
  %v955 = mul i64 %v102, %v101
  %v956 = add nsw i64 %v943, -1
  %v957 = mul i64 %v196, %v195
  %v958 = shl i64 %v144, 4
  %v959 = getelementptr i8, ptr %v142, i64 %v958
  %v960 = mul i64 %v957, 136
  %v961 = icmp slt i64 %v10, 1
  %v962 = getelementptr i8, ptr %v193, i64 %v960
  %v963 = getelementptr double, ptr %v92, i64 %v93
  %v964 = getelementptr i8, ptr %v963, i64 -8
  %v965 = shl i64 %v135, 6
  %v966 = getelementptr i8, ptr %v133, i64 %v965
  %v967 = mul i64 %v951, 112
  %v968 = getelementptr i8, ptr %v158, i64 %v967
  %v969 = mul i64 %v957, 112
  %v970 = getelementptr i8, ptr %v193, i64 %v969
  %v971 = shl i64 %v957, 7
  %v972 = getelementptr i8, ptr %v193, i64 %v971
  %v973 = getelementptr i8, ptr %v6, i64 32
  %v974 = mul i64 %v10, 136
  %v975 = getelementptr i8, ptr %v158, i64 %v974
  %v976 = mul i64 %v207, 216
  %v977 = getelementptr i8, ptr %v186, i64 %v976
  %v978 = shl i64 %v10, 7
  %v979 = getelementptr i8, ptr %v158, i64 %v978
  %v980 = mul i64 %v207, 240
  %v981 = getelementptr i8, ptr %v186, i64 %v980
  %v982 = sub i64 %v207, %v18
  %v983 = tail call i64 @llvm.smax.i64(i64 %v982, i64 0)
  %v984 = getelementptr double, ptr %v204, i64 %v207
  %v985 = mul i64 %v207, %v206
  %v986 = mul i64 %v985, 80
  %v987 = getelementptr i8, ptr %v984, i64 %v986
  %v988 = mul i64 %v985, 72
  %v989 = getelementptr i8, ptr %v204, i64 %v988
  %v990 = getelementptr double, ptr %v989, i64 %v207
  %v991 = shl i64 %v207, 4
  %v992 = getelementptr i8, ptr %v989, i64 %v991
  %v993 = shl i64 %v144, 5
  %v994 = getelementptr i8, ptr %v142, i64 %v993
  %v995 = mul i64 %v135, 112
  %v996 = getelementptr i8, ptr %v133, i64 %v995
  %v997 = xor i1 %v307, true
  %v998 = tail call i64 @llvm.smax.i64(i64 %v9, i64 1)
  %v999 = add nsw i64 %v998, -1
  %v1000 = zext i1 %v997 to i64
  %v1001 = mul i64 %v135, 232
  %v1002 = getelementptr i8, ptr %v133, i64 %v1001
  %v1003 = icmp slt i64 %v10, 1
  %v1004 = mul i64 %v135, 240
  %v1005 = getelementptr i8, ptr %v133, i64 %v1004
  %v1006 = mul i64 %v135, 264
  %v1007 = getelementptr i8, ptr %v133, i64 %v1006
  %v1008 = mul i64 %v135, 248
  %v1009 = getelementptr i8, ptr %v133, i64 %v1008
  %v1010 = shl i64 %v135, 8
  %v1011 = getelementptr i8, ptr %v133, i64 %v1010
  %v1012 = shl i64 %v135, 4
  %v1013 = getelementptr i8, ptr %v133, i64 %v1012
  %v1014 = shl i64 %v135, 8
  %v1015 = getelementptr i8, ptr %v133, i64 %v1014
  %v1016 = mul i64 %v135, 40
  %v1017 = getelementptr i8, ptr %v133, i64 %v1016
  %v1018 = shl i64 %v135, 4
  %v1019 = getelementptr i8, ptr %v133, i64 %v1018
  %v1020 = getelementptr i64, ptr %v142, i64 %v144
  %v1021 = mul i64 %v135, 24
  %v1022 = getelementptr i8, ptr %v133, i64 %v1021
  %v1023 = mul i64 %v135, 24
  %v1024 = getelementptr i8, ptr %v133, i64 %v1023
  %v1025 = icmp slt i64 %v63, 1
  %v1026 = shl i64 %v144, 4
  %v1027 = getelementptr i8, ptr %v142, i64 %v1026
  %v1028 = mul i64 %v135, 24
  %v1029 = getelementptr i8, ptr %v133, i64 %v1028
  %v1030 = getelementptr i8, ptr %v151, i64 8
  %v1031 = getelementptr i64, ptr %v142, i64 %v144
  %v1032 = mul i64 %v144, 24
  %v1033 = getelementptr i8, ptr %v142, i64 %v1032
  %v1034 = icmp slt i64 %v41, 1
  %v1035 = icmp slt i64 %v63, 1
  %v1036 = icmp slt i64 %v10, 1
  %v1037 = mul i64 %v135, 264
  %v1038 = getelementptr i8, ptr %v133, i64 %v1037
  %v1039 = shl i64 %v135, 7
  %v1040 = getelementptr i8, ptr %v133, i64 %v1039
  %v1041 = mul i64 %v135, 224
  %v1042 = getelementptr i8, ptr %v133, i64 %v1041
  %v1043 = mul i64 %v135, 216
  %v1044 = getelementptr i8, ptr %v133, i64 %v1043
  %v1045 = shl i64 %v135, 4
  %v1046 = shl i64 %v135, 5
  %v1047 = mul i64 %v135, 48
  %v1048 = mul i64 %v135, 56
  %v1049 = shl i64 %v135, 6
  %v1050 = mul i64 %v135, 72
  %v1051 = mul i64 %v135, 80
  %v1052 = mul i64 %v135, 88
  %v1053 = mul i64 %v135, 96
  %v1054 = mul i64 %v135, 104
  %v1055 = mul i64 %v135, 112
  %v1056 = mul i64 %v135, 120
  %v1057 = mul i64 %v135, 136
  %v1058 = mul i64 %v135, 144
  %v1059 = mul i64 %v135, 152
  %v1060 = mul i64 %v135, 160
  %v1061 = mul i64 %v135, 168
  %v1062 = mul i64 %v135, 176
  %v1063 = mul i64 %v135, 184
  %v1064 = mul i64 %v135, 192
  %v1065 = mul i64 %v135, 200
  %v1066 = mul i64 %v135, 208
  %v1067 = mul i64 %v135, 232
  %v1068 = mul i64 %v135, 240
  %v1069 = mul i64 %v135, 248
  %v1070 = shl i64 %v135, 8
  %v1071 = getelementptr i8, ptr %v133, i64 %v1067
  %v1072 = getelementptr i8, ptr %v133, i64 %v1056
  %v1073 = getelementptr i8, ptr %v133, i64 %v1066
  %v1074 = getelementptr i8, ptr %v133, i64 %v1068
  %v1075 = getelementptr i8, ptr %v133, i64 %v1045
  %v1076 = mul i64 %v135, 216
  %v1077 = getelementptr i8, ptr %v133, i64 %v1076
  %v1078 = getelementptr double, ptr %v92, i64 %v93
  %v1079 = getelementptr i8, ptr %v1078, i64 -8
  %v1080 = getelementptr double, ptr %v133, i64 %v135
  %v1081 = mul i64 %v135, 216
  %v1082 = getelementptr i8, ptr %v133, i64 %v1081
  %v1083 = mul i64 %v135, 232
  %v1084 = getelementptr i8, ptr %v133, i64 %v1083
  %v1085 = sitofp i64 %v298 to double
  %v1086 = mul i64 %v135, 160
  %v1087 = getelementptr i8, ptr %v133, i64 %v1086
  %v1088 = shl i64 %v135, 4
  %v1089 = getelementptr i8, ptr %v133, i64 %v1088
  %v1090 = mul i64 %v135, 152
  %v1091 = getelementptr i8, ptr %v133, i64 %v1090
  %v1092 = shl i64 %v144, 4
  %v1093 = getelementptr i8, ptr %v142, i64 %v1092
  %v1094 = shl i64 %v732, 4
  %v1095 = mul i64 %v732, 24
  %v1096 = shl i64 %v732, 5
  %v1097 = mul i64 %v732, 40
  %v1098 = mul i64 %v732, 48
  %v1099 = mul i64 %v732, 56
  %v1100 = shl i64 %v732, 6
  %v1101 = shl i64 %v734, 4
  %v1102 = shl i64 %v734, 5
  %v1103 = mul i64 %v734, 48
  %v1104 = shl i64 %v734, 6
  %v1105 = mul i64 %v734, 24
  %v1106 = shl i64 %v734, 4
  %v1107 = shl i64 %v734, 5
  %v1108 = mul i64 %v734, 48
  %v1109 = shl i64 %v734, 6
  %v1110 = mul i64 %v734, 40
  %v1111 = shl i64 %v734, 4
  %v1112 = shl i64 %v734, 5
  %v1113 = mul i64 %v734, 48
  %v1114 = shl i64 %v734, 6
  %v1115 = mul i64 %v734, 56
  %v1116 = shl i64 %v734, 4
  %v1117 = shl i64 %v734, 5
  %v1118 = mul i64 %v734, 48
  %v1119 = shl i64 %v734, 6
  br label %v1120

v1120:
  %v1121 = phi i64 [ %v1122, %v1123 ], [ %v297, %v510 ]
  %v1124 = phi i64 [ %v1125, %v1123 ], [ %v506, %v510 ]
  %v1126 = add nsw i64 %v1121, -1
  %v1127 = load i64, ptr %v512, align 8, !noalias !11
  %v1128 = icmp eq i64 %v1127, 0
  br i1 %v1128, label %v1129, label %v1130

v1130:
  %v1131 = icmp eq i64 %v1127, 2
  store i64 0, ptr %v512, align 8, !noalias !11
  %v1132 = load i64, ptr %v517, align 8, !noalias !15
  %v1133 = inttoptr i64 %v1132 to ptr
  tail call void %v1133(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !15
  br i1 %v305, label %v1134, label %v1135

v1134:
  %v1136 = load i64, ptr %v518, align 8, !noalias !18
  %v1137 = inttoptr i64 %v1136 to ptr
  tail call void %v1137(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !18
  %v1138 = load double, ptr %v520, align 8, !noalias !24
  %v1139 = fcmp une double %v1138, 2.500000e-01
  br i1 %v1139, label %v1135, label %v1140

v1140:
  store double 0.000000e+00, ptr %v520, align 8, !noalias !24
  br i1 %v521, label %v1141, label %v1142

v1143:
  store double 1.000000e+00, ptr %v520, align 8, !noalias !24
  br label %v1144

v1144:
  %v1145 = icmp eq i64 %v1146, %v18
  br i1 %v1145, label %v1142, label %v1141

v1142:
  %v1147 = load double, ptr %v520, align 8, !noalias !24
  %v1148 = fcmp ogt double %v1147, 5.000000e-01
  %v1149 = or i1 %v1131, %v1148
  br label %v1135

v1141:
  %v1150 = phi i64 [ %v1146, %v1144 ], [ 0, %v1140 ]
  %v1146 = add nsw i64 %v1150, 1
  %v1151 = getelementptr double, ptr %v204, i64 %v1150
  %v1152 = load double, ptr %v1151, align 8, !noalias !24
  %v1153 = add nsw i64 %v1150, %v17
  %v1154 = icmp slt i64 %v1153, 0
  %v1155 = select i1 %v1154, i64 %v166, i64 0
  %v1156 = getelementptr double, ptr %v165, i64 %v1153
  %v1157 = getelementptr double, ptr %v1156, i64 %v1155
  %v1158 = load double, ptr %v1157, align 8, !noalias !24
  %v1159 = fcmp une double %v1152, %v1158
  br i1 %v1159, label %v1143, label %v1144

v1135:
  %v1160 = phi i1 [ %v1131, %v1130 ], [ %v1149, %v1142 ], [ %v1131, %v1134 ]
  br i1 %v1160, label %v1161, label %v1129

v1161:
  br i1 %v305, label %v1162, label %v1163

v1162:
  %v1164 = load i64, ptr %v522, align 8, !noalias !25
  %v1165 = inttoptr i64 %v1164 to ptr
  tail call void %v1165(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !25
  %v1166 = load double, ptr %v524, align 8, !noalias !31
  %v1167 = fcmp ule double %v1166, 5.000000e-01
  %v1168 = select i1 %v1167, i1 true, i1 %v525
  br i1 %v1168, label %v1169, label %v1170

v1169:
  %v1171 = load i64, ptr %v517, align 8, !noalias !32
  %v1172 = inttoptr i64 %v1171 to ptr
  tail call void %v1172(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !32
  br label %v1163

v1170:
  %v1173 = phi i64 [ %v1174, %v1170 ], [ 0, %v1162 ]
  %v1174 = add nsw i64 %v1173, 1
  %v1175 = getelementptr double, ptr %v204, i64 %v1173
  %v1176 = load double, ptr %v1175, align 8, !noalias !31
  %v1177 = add nsw i64 %v1173, %v17
  %v1178 = icmp slt i64 %v1177, 0
  %v1179 = select i1 %v1178, i64 %v166, i64 0
  %v1180 = getelementptr double, ptr %v165, i64 %v1177
  %v1181 = getelementptr double, ptr %v1180, i64 %v1179
  store double %v1176, ptr %v1181, align 8, !noalias !31
  %v1182 = icmp eq i64 %v1174, %v18
  br i1 %v1182, label %v1169, label %v1170

v1163:
  br i1 %v526, label %v1183, label %v1184

v1183:
  %v1185 = load i64, ptr %v6, align 8, !noalias !35
  %v1186 = inttoptr i64 %v1185 to ptr
  tail call void %v1186(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v529), !noalias !35
  %v1187 = load i64, ptr %v530, align 8, !noalias !38
  %v1188 = inttoptr i64 %v1187 to ptr
  tail call void %v1188(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !38
  %v1189 = load i64, ptr %v531, align 8, !noalias !41
  %v1190 = inttoptr i64 %v1189 to ptr
  tail call void %v1190(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !41
  %v1191 = load i64, ptr %v6, align 8, !noalias !44
  %v1192 = inttoptr i64 %v1191 to ptr
  tail call void %v1192(ptr %v533, ptr %v535, ptr %v165, ptr %v172, ptr %v179, ptr %v537), !noalias !44
  %v1193 = load i64, ptr %v538, align 8, !noalias !47
  %v1194 = inttoptr i64 %v1193 to ptr
  tail call void %v1194(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !47
  br label %v1184

v1184:
  br i1 %v307, label %v1129, label %v1195

v1196:
  store double 0.000000e+00, ptr %v1197, align 8, !noalias !50
  %v1198 = getelementptr double, ptr %v543, i64 %v1199
  store double 0.000000e+00, ptr %v1198, align 8, !noalias !50
  %v1200 = getelementptr double, ptr %v545, i64 %v1199
  store double 0.000000e+00, ptr %v1200, align 8, !noalias !50
  %v1201 = getelementptr i64, ptr %v142, i64 %v1199
  %v1202 = load i64, ptr %v1201, align 8, !noalias !50
  %v1203 = icmp slt i64 %v1202, 0
  %v1204 = select i1 %v1203, i64 %v125, i64 0
  %v1205 = add i64 %v1204, %v1202
  %v1206 = mul i64 %v1205, %v126
  %v1207 = getelementptr i64, ptr %v124, i64 %v1206
  %v1208 = getelementptr i8, ptr %v1207, i64 8
  %v1209 = load i64, ptr %v1208, align 8, !noalias !50
  %v1210 = add nsw i64 %v1209, %v547
  store i64 %v1210, ptr %v1208, align 8, !noalias !50
  %v1211 = load i64, ptr %v1201, align 8, !noalias !50
  %v1212 = icmp slt i64 %v1211, 0
  %v1213 = select i1 %v1212, i64 %v125, i64 0
  %v1214 = add i64 %v1213, %v1211
  %v1215 = mul i64 %v1214, %v126
  %v1216 = getelementptr i64, ptr %v124, i64 %v1215
  %v1217 = getelementptr i8, ptr %v1216, i64 16
  %v1218 = load i64, ptr %v1217, align 8, !noalias !50
  %v1219 = add nsw i64 %v1218, %v548
  store i64 %v1219, ptr %v1217, align 8, !noalias !50
  %v1220 = getelementptr double, ptr %v550, i64 %v1199
  %v1221 = load double, ptr %v1220, align 8, !noalias !50
  %v1222 = fcmp une double %v1221, 0.000000e+00
  br i1 %v1222, label %v1223, label %v1224

v1223:
  %v1225 = load i64, ptr %v1201, align 8, !noalias !54
  %v1226 = icmp sgt i64 %v1225, -1
  br i1 %v1226, label %v1227, label %v1224

v1227:
  %v1228 = getelementptr i64, ptr %v110, i64 %v1225
  %v1229 = load i64, ptr %v1228, align 8, !noalias !54
  %v1230 = icmp eq i64 %v1229, 0
  br i1 %v1230, label %v1231, label %v1224

v1231:
  store i64 3, ptr %v1228, align 8, !noalias !54
  br label %v1224

v1224:
  br i1 %v304, label %v1232, label %v1233

v1232:
  %v1234 = load double, ptr %v552, align 8, !noalias !57
  %v1235 = load double, ptr %v92, align 8, !noalias !57
  %v1236 = fsub double %v1234, %v1235
  %v1237 = fmul double %v1236, 1.000000e-13
  %v1238 = load double, ptr %v133, align 8, !noalias !57
  %v1239 = tail call double @llvm.fabs.f64(double %v1238)
  %v1240 = fmul double %v1239, 4.000000e-15
  %v1241 = fcmp ogt double %v1240, %v1237
  %v1242 = select i1 %v1241, double %v1240, double %v1237
  %v1243 = fadd double %v1238, %v1242
  store double %v1243, ptr %v554, align 8, !noalias !67
  %v1244 = load i64, ptr %v6, align 8, !noalias !68
  %v1245 = inttoptr i64 %v1244 to ptr
  tail call void %v1245(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v555), !noalias !68
  br i1 %v556, label %v1246, label %v1247

v1246:
  %v1248 = load i64, ptr %v562, align 8, !noalias !71
  %v1249 = inttoptr i64 %v1248 to ptr
  tail call void %v1249(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v564), !noalias !71
  %v1250 = load i64, ptr %v562, align 8, !noalias !74
  %v1251 = inttoptr i64 %v1250 to ptr
  tail call void %v1251(ptr nonnull %v554, ptr %v566, ptr %v165, ptr %v172, ptr %v179, ptr %v568), !noalias !74
  br label %v1252

v1252:
  %v1253 = phi i64 [ %v18, %v1246 ], [ %v1254, %v1255 ]
  %v1256 = phi i64 [ %v570, %v1246 ], [ %v1257, %v1255 ]
  %v1258 = icmp sgt i64 %v1256, 0
  br i1 %v1258, label %v1255, label %v1259

v1255:
  %v1257 = add nsw i64 %v1256, -1
  %v1254 = add i64 %v1253, 1
  %v1260 = icmp slt i64 %v1253, 0
  %v1261 = select i1 %v1260, i64 %v207, i64 0
  %v1262 = add i64 %v1261, %v1253
  %v1263 = getelementptr double, ptr %v574, i64 %v1262
  %v1264 = load double, ptr %v1263, align 8, !noalias !67
  %v1265 = getelementptr double, ptr %v577, i64 %v1262
  %v1266 = load double, ptr %v1265, align 8, !noalias !67
  %v1267 = fsub double %v1264, %v1266
  %v1268 = tail call double @llvm.fabs.f64(double %v1267)
  %v1269 = getelementptr double, ptr %v579, i64 %v1262
  %v1270 = load double, ptr %v1269, align 8, !noalias !67
  %v1271 = tail call i1 @llvm.is.fpclass.f64(double %v1270, i32 543)
  %v1272 = select i1 %v1271, double 0.000000e+00, double %v1270
  %v1273 = fcmp ueq double %v1268, 0x7FF0000000000000
  %v1274 = select i1 %v1273, double -0.000000e+00, double %v1268
  %v1275 = fadd double %v1272, %v1274
  %v1276 = getelementptr double, ptr %v576, i64 %v1262
  %v1277 = load double, ptr %v1276, align 8, !noalias !67
  %v1278 = fneg double %v1275
  %v1279 = fcmp olt double %v1277, %v1278
  br i1 %v1279, label %v1259, label %v1252

v1247:
  %v1280 = phi i64 [ %v1281, %v1247 ], [ 0, %v1232 ]
  %v1281 = add nsw i64 %v1280, 1
  %v1282 = mul i64 %v1280, %v196
  %v1283 = getelementptr double, ptr %v193, i64 %v1282
  %v1284 = load double, ptr %v1283, align 8, !noalias !67
  %v1285 = getelementptr double, ptr %v559, i64 %v1282
  %v1286 = load double, ptr %v1285, align 8, !noalias !67
  %v1287 = fmul double %v1242, %v1286
  %v1288 = fadd double %v1284, %v1287
  %v1289 = getelementptr double, ptr %v561, i64 %v1282
  store double %v1288, ptr %v1289, align 8, !noalias !67
  %v1290 = icmp eq i64 %v10, %v1281
  br i1 %v1290, label %v1246, label %v1247

v1291:
  %v1292 = getelementptr i64, ptr %v581, i64 %v1199
  store i64 %v1293, ptr %v1292, align 8, !noalias !77
  %v1294 = load i64, ptr %v1201, align 8, !noalias !78
  %v1295 = icmp sgt i64 %v1294, -1
  br i1 %v1295, label %v1296, label %v1297

v1296:
  %v1298 = getelementptr i64, ptr %v110, i64 %v1294
  %v1299 = load i64, ptr %v1298, align 8, !noalias !78
  %v1300 = icmp eq i64 %v1299, 0
  br i1 %v1300, label %v1301, label %v1297

v1301:
  store i64 4, ptr %v1298, align 8, !noalias !78
  br label %v1297

v1297:
  %v1302 = getelementptr double, ptr %v133, i64 %v1199
  %v1303 = load double, ptr %v1302, align 8, !noalias !77
  %v1304 = getelementptr double, ptr %v583, i64 %v1199
  store double %v1303, ptr %v1304, align 8, !noalias !77
  %v1305 = getelementptr double, ptr %v585, i64 %v1199
  store double 0.000000e+00, ptr %v1305, align 8, !noalias !77
  br label %v1233

v1259:
  %v1293 = phi i64 [ %v1253, %v1255 ], [ -1, %v1252 ]
  %v1306 = icmp sgt i64 %v1293, -1
  br i1 %v1306, label %v1291, label %v1233

v1307:
  %v1308 = icmp sgt i64 %v1309, 1
  br i1 %v1308, label %v1195, label %v1129

v1195:
  %v1309 = phi i64 [ %v1310, %v1307 ], [ %v308, %v1184 ]
  %v1199 = phi i64 [ %v1311, %v1307 ], [ 0, %v1184 ]
  %v1310 = add nsw i64 %v1309, -1
  %v1311 = add nsw i64 %v1199, 1
  %v1197 = getelementptr double, ptr %v541, i64 %v1199
  %v1312 = load double, ptr %v1197, align 8, !noalias !50
  %v1313 = fcmp olt double %v1312, 5.000000e-01
  br i1 %v1313, label %v1307, label %v1196

v1233:
  %v1314 = getelementptr double, ptr %v587, i64 %v1199
  %v1315 = load double, ptr %v1314, align 8, !noalias !81
  %v1316 = getelementptr double, ptr %v589, i64 %v1199
  store double %v1315, ptr %v1316, align 8, !noalias !81
  %v1317 = getelementptr i64, ptr %v591, i64 %v1199
  %v1318 = load i64, ptr %v1317, align 8, !noalias !81
  %v1319 = icmp slt i64 %v1318, %v93
  br i1 %v1319, label %v1320, label %v1307

v1320:
  %v1321 = icmp slt i64 %v1318, 0
  %v1322 = select i1 %v1321, i64 %v93, i64 0
  %v1323 = getelementptr double, ptr %v92, i64 %v1318
  %v1324 = getelementptr double, ptr %v1323, i64 %v1322
  %v1325 = load double, ptr %v1324, align 8, !noalias !81
  %v1326 = load double, ptr %v1314, align 8, !noalias !81
  %v1327 = fcmp olt double %v1326, %v1325
  %v1328 = select i1 %v1327, double %v1326, double %v1325
  store double %v1328, ptr %v1316, align 8, !noalias !81
  br label %v1307

v1129:
  %v1329 = phi i1 [ %v676, %v1135 ], [ %v676, %v1120 ], [ true, %v1184 ], [ true, %v1307 ]
  %v1330 = load i64, ptr %v592, align 8, !noalias !85
  %v1331 = inttoptr i64 %v1330 to ptr
  tail call void %v1331(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !85
  br i1 %v593, label %v1332, label %v1333

v1334:
  %v1335 = getelementptr double, ptr %v678, i64 %v1336
  %v1337 = load double, ptr %v1335, align 8
  %v1338 = fcmp ogt double %v1337, 5.000000e-01
  br label %v1339

v1339:
  %v1340 = phi i1 [ true, %v1341 ], [ %v1338, %v1334 ]
  br i1 %v1342, label %v1343, label %v1344

v1344:
  %v1345 = getelementptr double, ptr %v680, i64 %v1336
  %v1346 = load double, ptr %v1345, align 8
  %v1347 = fcmp ogt double %v1346, 5.000000e-01
  br label %v1343

v1343:
  %v1348 = phi i1 [ true, %v1339 ], [ %v1347, %v1344 ]
  %v1349 = icmp sgt i64 %v1350, 1
  br i1 %v1349, label %v1341, label %v1351

v1351:
  %v1352 = phi i1 [ false, %v1353 ], [ %v1340, %v1343 ]
  %v1354 = phi i1 [ %v1329, %v1353 ], [ %v1348, %v1343 ]
  %v1355 = xor i1 %v1354, true
  %v1356 = or i1 %v307, %v1355
  br i1 %v1356, label %v1357, label %v1358

v1359:
  br i1 %v307, label %v1357, label %v1360

v1361:
  %v1362 = getelementptr double, ptr %v682, i64 %v1363
  %v1364 = load double, ptr %v1362, align 8, !noalias !91
  %v1365 = fptosi double %v1364 to i64
  %v1366 = getelementptr double, ptr %v684, i64 %v1363
  %v1367 = load double, ptr %v1366, align 8, !noalias !91
  %v1368 = fptosi double %v1367 to i64
  %v1369 = mul i64 %v1370, %v126
  %v1371 = getelementptr i64, ptr %v124, i64 %v1369
  %v1372 = load i64, ptr %v1371, align 8, !noalias !91
  %v1373 = add nsw i64 %v1372, %v1365
  store i64 %v1373, ptr %v1371, align 8, !noalias !91
  %v1374 = getelementptr i8, ptr %v1371, i64 24
  %v1375 = load i64, ptr %v1374, align 8, !noalias !91
  %v1376 = add nsw i64 %v1375, %v1368
  store i64 %v1376, ptr %v1374, align 8, !noalias !91
  %v1377 = getelementptr i8, ptr %v1371, i64 8
  %v1378 = load i64, ptr %v1377, align 8, !noalias !91
  %v1379 = add nsw i64 %v1368, %v1365
  %v1380 = mul nsw i64 %v1379, %v652
  %v1381 = add nsw i64 %v1380, %v1365
  %v1382 = add nsw i64 %v1381, %v1378
  store i64 %v1382, ptr %v1377, align 8, !noalias !91
  store double 0.000000e+00, ptr %v1362, align 8, !noalias !91
  store double 0.000000e+00, ptr %v1366, align 8, !noalias !91
  %v1383 = getelementptr double, ptr %v686, i64 %v1363
  %v1384 = load double, ptr %v1383, align 8, !noalias !91
  %v1385 = sitofp i64 %v1379 to double
  %v1386 = fsub double %v1384, %v1385
  store double %v1386, ptr %v1383, align 8, !noalias !91
  br label %v1387

v1387:
  %v1388 = icmp sgt i64 %v1389, 1
  br i1 %v1388, label %v1358, label %v1359

v1358:
  %v1389 = phi i64 [ %v1390, %v1387 ], [ %v308, %v1351 ]
  %v1363 = phi i64 [ %v1391, %v1387 ], [ 0, %v1351 ]
  %v1390 = add nsw i64 %v1389, -1
  %v1391 = add nsw i64 %v1363, 1
  %v1392 = getelementptr i64, ptr %v142, i64 %v1363
  %v1370 = load i64, ptr %v1392, align 8, !noalias !91
  %v1393 = icmp sgt i64 %v1370, -1
  br i1 %v1393, label %v1361, label %v1387

v1394:
  %v1395 = getelementptr double, ptr %v692, i64 %v1396
  %v1397 = load double, ptr %v1395, align 8, !noalias !98
  %v1398 = fcmp ogt double %v1397, 5.000000e-01
  br i1 %v1398, label %v1399, label %v1400

v1399:
  %v1401 = fptosi double %v1397 to i64
  %v1402 = load i64, ptr %v1403, align 8, !noalias !99
  %v1404 = icmp sgt i64 %v1402, -1
  br i1 %v1404, label %v1405, label %v1400

v1400:
  %v1406 = getelementptr double, ptr %v694, i64 %v1396
  %v1407 = load double, ptr %v1406, align 8, !noalias !98
  %v1408 = fcmp ogt double %v1407, 5.000000e-01
  br i1 %v1408, label %v1409, label %v1410

v1409:
  %v1411 = select i1 %v1412, i1 true, i1 %v304
  %v1413 = icmp slt i64 %v1414, %v93
  br i1 %v1413, label %v1415, label %v1416

v1415:
  %v1417 = icmp slt i64 %v1414, 0
  %v1418 = select i1 %v1417, i64 %v93, i64 0
  %v1419 = getelementptr double, ptr %v92, i64 %v1414
  %v1420 = getelementptr double, ptr %v1419, i64 %v1418
  %v1421 = load double, ptr %v1420, align 8, !noalias !98
  %v1422 = getelementptr double, ptr %v696, i64 %v1396
  %v1423 = load double, ptr %v1422, align 8, !noalias !98
  %v1424 = fcmp olt double %v1421, %v1423
  br i1 %v1424, label %v1425, label %v1416

v1425:
  br label %v1416

v1416:
  %v1426 = phi i1 [ true, %v1425 ], [ %v1411, %v1415 ], [ %v1411, %v1409 ]
  %v1427 = mul i64 %v1428, %v126
  %v1429 = getelementptr i64, ptr %v124, i64 %v1427
  %v1430 = load i64, ptr %v1429, align 8, !noalias !98
  %v1431 = and i64 %v1430, 127
  %v1432 = icmp eq i64 %v1431, 0
  br i1 %v1432, label %v1433, label %v1434

v1434:
  %v1435 = getelementptr double, ptr %v698, i64 %v1396
  %v1436 = load double, ptr %v1435, align 8, !noalias !98
  %v1437 = fcmp ogt double %v1436, 0.000000e+00
  br i1 %v1437, label %v1433, label %v1410

v1433:
  store double 1.000000e+00, ptr %v1438, align 8, !noalias !98
  br label %v1410

v1410:
  %v1439 = phi i1 [ %v1426, %v1433 ], [ %v1426, %v1434 ], [ %v1412, %v1400 ], [ %v1412, %v1360 ]
  %v1440 = phi i1 [ true, %v1433 ], [ %v1441, %v1434 ], [ %v1441, %v1400 ], [ %v1441, %v1360 ]
  %v1442 = icmp sgt i64 %v1443, 1
  br i1 %v1442, label %v1360, label %v1444

v1360:
  %v1441 = phi i1 [ %v1440, %v1410 ], [ false, %v1359 ]
  %v1412 = phi i1 [ %v1439, %v1410 ], [ false, %v1359 ]
  %v1443 = phi i64 [ %v1445, %v1410 ], [ %v308, %v1359 ]
  %v1396 = phi i64 [ %v1446, %v1410 ], [ 0, %v1359 ]
  %v1445 = add nsw i64 %v1443, -1
  %v1446 = add nsw i64 %v1396, 1
  %v1403 = getelementptr i64, ptr %v142, i64 %v1396
  %v1428 = load i64, ptr %v1403, align 8, !noalias !98
  %v1447 = getelementptr i64, ptr %v688, i64 %v1396
  %v1414 = load i64, ptr %v1447, align 8, !noalias !98
  %v1438 = getelementptr double, ptr %v690, i64 %v1396
  store double 0.000000e+00, ptr %v1438, align 8, !noalias !98
  %v1448 = icmp sgt i64 %v1428, -1
  br i1 %v1448, label %v1394, label %v1410

v1405:
  %v1449 = getelementptr i64, ptr %v110, i64 %v1402
  %v1450 = load i64, ptr %v1449, align 8, !noalias !99
  %v1451 = icmp eq i64 %v1450, 0
  br i1 %v1451, label %v1452, label %v1400

v1452:
  store i64 %v1401, ptr %v1449, align 8, !noalias !99
  br label %v1400

v1357:
  %v1453 = phi i1 [ true, %v1351 ], [ true, %v1359 ], [ %v1454, %v1444 ]
  %v1455 = phi i1 [ true, %v1351 ], [ true, %v1359 ], [ %v1456, %v1444 ]
  %v1457 = and i1 %v699, %v1352
  br i1 %v1457, label %v1458, label %v1459

v1458:
  %v1460 = load i64, ptr %v6, align 8, !noalias !102
  %v1461 = inttoptr i64 %v1460 to ptr
  tail call void %v1461(ptr %v704, ptr %v707, ptr %v165, ptr %v172, ptr %v179, ptr %v709), !noalias !102
  br label %v1459

v1459:
  br i1 %v1455, label %v1462, label %v1463

v1463:
  %v1464 = load i64, ptr %v710, align 8, !noalias !108
  %v1465 = inttoptr i64 %v1464 to ptr
  tail call void %v1465(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !108
  br label %v1462

v1462:
  %v1466 = select i1 %v1352, i1 %v304, i1 false
  %v1467 = xor i1 %v1352, true
  %v1468 = select i1 %v305, i1 %v1352, i1 false
  %v1469 = xor i1 %v1468, true
  %v1470 = select i1 %v1469, i1 true, i1 %v1466
  %v1471 = select i1 %v305, i1 %v1352, i1 %v1466
  br i1 %v1470, label %v1472, label %v1473

v1473:
  %v1474 = load i64, ptr %v711, align 8, !noalias !111
  %v1475 = inttoptr i64 %v1474 to ptr
  tail call void %v1475(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !111
  br label %v1476

v1476:
  %v1477 = phi i64 [ 0, %v1473 ], [ %v1478, %v1479 ]
  %v1478 = add nsw i64 %v1477, 1
  %v1480 = icmp ult i64 %v1477, 9
  br i1 %v1480, label %v1481, label %v1482

v1481:
  %v1483 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v1477
  %v1484 = load double, ptr %v1483, align 8
  %v1485 = load double, ptr %v133, align 8, !noalias !114
  %v1486 = load double, ptr %v714, align 8, !noalias !114
  %v1487 = fmul double %v1484, %v1486
  %v1488 = fadd double %v1485, %v1487
  store double %v1488, ptr %v716, align 8, !noalias !114
  br i1 %v718, label %v1479, label %v1489

v1489:
  %v1490 = fsub double 1.000000e+00, %v1484
  br label %v1491

v1491:
  %v1492 = phi i64 [ 0, %v1489 ], [ %v1493, %v1491 ]
  %v1494 = mul i64 %v1492, %v196
  %v1495 = getelementptr double, ptr %v193, i64 %v1494
  %v1496 = getelementptr i8, ptr %v1495, i64 %v722
  %v1497 = load double, ptr %v1496, align 8, !noalias !124
  %v1498 = fadd double %v1497, 0.000000e+00
  %v1499 = fmul double %v1484, %v1498
  %v1500 = getelementptr i8, ptr %v1495, i64 %v723
  %v1501 = load double, ptr %v1500, align 8, !noalias !124
  %v1502 = fadd double %v1501, %v1499
  %v1503 = fmul double %v1490, %v1502
  %v1504 = getelementptr i8, ptr %v1495, i64 %v724
  %v1505 = load double, ptr %v1504, align 8, !noalias !124
  %v1506 = fadd double %v1505, %v1503
  %v1507 = fmul double %v1484, %v1506
  %v1508 = getelementptr i8, ptr %v1495, i64 %v725
  %v1509 = load double, ptr %v1508, align 8, !noalias !124
  %v1510 = fadd double %v1509, %v1507
  %v1511 = fmul double %v1490, %v1510
  %v1512 = getelementptr i8, ptr %v1495, i64 %v726
  %v1513 = load double, ptr %v1512, align 8, !noalias !124
  %v1514 = fadd double %v1513, %v1511
  %v1515 = fmul double %v1484, %v1514
  %v1516 = getelementptr i8, ptr %v1495, i64 %v727
  %v1517 = load double, ptr %v1516, align 8, !noalias !124
  %v1518 = fadd double %v1517, %v1515
  %v1519 = fmul double %v1490, %v1518
  %v1520 = getelementptr i8, ptr %v1495, i64 %v728
  %v1521 = load double, ptr %v1520, align 8, !noalias !124
  %v1522 = fadd double %v1521, %v1519
  %v1523 = fmul double %v1484, %v1522
  %v1493 = add nsw i64 %v1492, 1
  %v1524 = load double, ptr %v1495, align 8, !noalias !124
  %v1525 = fadd double %v1524, %v1523
  %v1526 = getelementptr double, ptr %v719, i64 %v1494
  store double %v1525, ptr %v1526, align 8, !noalias !114
  %v1527 = icmp eq i64 %v10, %v1493
  br i1 %v1527, label %v1479, label %v1491

v1479:
  %v1528 = icmp eq i64 %v1477, 8
  %v1529 = select i1 %v1528, i64 17, i64 16
  %v1530 = mul i64 %v720, %v1477
  %v1531 = load i64, ptr %v721, align 8, !noalias !128
  %v1532 = mul nsw i64 %v1529, %v10
  %v1533 = getelementptr double, ptr %v158, i64 %v1532
  %v1534 = getelementptr double, ptr %v186, i64 %v1530
  %v1535 = inttoptr i64 %v1531 to ptr
  tail call void %v1535(ptr nonnull %v716, ptr %v1533, ptr %v165, ptr %v172, ptr %v179, ptr %v1534), !noalias !128
  %v1536 = icmp eq i64 %v1478, 9
  br i1 %v1536, label %v1482, label %v1476

v1482:
  %v1537 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v1476 ], [ null, %v1479 ]
  %v1538 = phi i32 [ 1, %v1476 ], [ 0, %v1479 ]
  br i1 %v1480, label %v1539, label %v1540, !prof !131

v1472:
  %v1541 = phi i1 [ %v1471, %v1462 ], [ %v1542, %v1540 ]
  %v1543 = xor i1 %v1453, true
  %v1544 = select i1 %v1543, i1 true, i1 %v1541
  br i1 %v1544, label %v1545, label %v1546

v1545:
  br i1 %v739, label %v1547, label %v1548

v1549:
  %v1550 = load i64, ptr %v750, align 8, !noalias !132
  %v1551 = inttoptr i64 %v1550 to ptr
  tail call void %v1551(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !132
  br label %v1548

v1547:
  %v1552 = phi i64 [ %v1553, %v1547 ], [ 1, %v1545 ]
  %v1553 = add i64 %v1552, 1
  %v1554 = add nsw i64 %v740, %v1552
  %v1555 = icmp slt i64 %v1554, 0
  %v1556 = select i1 %v1555, i64 %v7, i64 0
  %v1557 = getelementptr i64, ptr %v6, i64 %v1554
  %v1558 = getelementptr i64, ptr %v1557, i64 %v1556
  %v1559 = load i64, ptr %v1558, align 8, !noalias !138
  %v1560 = inttoptr i64 %v1559 to ptr
  tail call void %v1560(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !138
  %v1561 = add nsw i64 %v1552, 13
  %v1562 = load i64, ptr %v6, align 8, !noalias !141
  %v1563 = mul nsw i64 %v1561, %v743
  %v1564 = getelementptr double, ptr %v158, i64 %v1563
  %v1565 = inttoptr i64 %v1562 to ptr
  tail call void %v1565(ptr %v742, ptr %v745, ptr %v165, ptr %v172, ptr %v179, ptr %v1564), !noalias !141
  %v1566 = icmp eq i64 %v1552, %v12
  br i1 %v1566, label %v1549, label %v1547

v1548:
  %v1567 = load i64, ptr %v751, align 8, !noalias !144
  %v1568 = inttoptr i64 %v1567 to ptr
  tail call void %v1568(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !144
  %v1569 = select i1 %v702, i1 true, i1 %v1467
  %v1570 = or i1 %v1569, %v307
  br i1 %v1570, label %v1571, label %v1572

v1573:
  %v1574 = getelementptr double, ptr %v755, i64 %v1575
  %v1576 = load double, ptr %v1574, align 8, !noalias !147
  %v1577 = fcmp uge double %v1576, 5.000000e-01
  %v1578 = icmp slt i64 %v1579, %v93
  %v1580 = select i1 %v1577, i1 %v1578, i1 false
  br i1 %v1580, label %v1581, label %v1582

v1581:
  %v1583 = icmp slt i64 %v1579, 0
  %v1584 = select i1 %v1583, i64 %v93, i64 0
  %v1585 = getelementptr double, ptr %v92, i64 %v1579
  %v1586 = getelementptr double, ptr %v1585, i64 %v1584
  %v1587 = load double, ptr %v1586, align 8, !noalias !147
  %v1588 = getelementptr double, ptr %v757, i64 %v1575
  %v1589 = load double, ptr %v1588, align 8, !noalias !147
  %v1590 = fcmp olt double %v1587, %v1589
  br i1 %v1590, label %v1591, label %v1582

v1591:
  %v1592 = getelementptr double, ptr %v759, i64 %v1575
  %v1593 = load double, ptr %v1592, align 8, !noalias !147
  %v1594 = fcmp ogt double %v1593, 1.000000e+00
  br i1 %v1594, label %v1595, label %v1582

v1595:
  %v1596 = getelementptr double, ptr %v761, i64 %v1575
  %v1597 = load double, ptr %v1596, align 8, !noalias !147
  store double 0.000000e+00, ptr %v1574, align 8, !noalias !151
  %v1598 = getelementptr double, ptr %v763, i64 %v1575
  store double 0.000000e+00, ptr %v1598, align 8, !noalias !151
  %v1599 = getelementptr double, ptr %v764, i64 %v1575
  store double %v1597, ptr %v1599, align 8, !noalias !151
  %v1600 = load i64, ptr %v1601, align 8, !noalias !151
  %v1602 = icmp slt i64 %v1600, 0
  %v1603 = select i1 %v1602, i64 %v125, i64 0
  %v1604 = add i64 %v1603, %v1600
  %v1605 = mul i64 %v1604, %v126
  %v1606 = getelementptr i64, ptr %v124, i64 %v1605
  %v1607 = load i64, ptr %v1606, align 8, !noalias !151
  %v1608 = add nsw i64 %v1607, -1
  store i64 %v1608, ptr %v1606, align 8, !noalias !151
  %v1609 = load i64, ptr %v1601, align 8, !noalias !151
  %v1610 = icmp slt i64 %v1609, 0
  %v1611 = select i1 %v1610, i64 %v125, i64 0
  %v1612 = add i64 %v1611, %v1609
  %v1613 = mul i64 %v1612, %v126
  %v1614 = getelementptr i64, ptr %v124, i64 %v1613
  %v1615 = getelementptr i8, ptr %v1614, i64 24
  %v1616 = load i64, ptr %v1615, align 8, !noalias !151
  %v1617 = add nsw i64 %v1616, 1
  store i64 %v1617, ptr %v1615, align 8, !noalias !151
  %v1618 = load double, ptr %v1586, align 8, !noalias !147
  %v1619 = getelementptr double, ptr %v766, i64 %v1575
  store double %v1618, ptr %v1619, align 8, !noalias !147
  %v1620 = mul i64 %v1621, %v126
  %v1622 = getelementptr i64, ptr %v124, i64 %v1620
  %v1623 = getelementptr i8, ptr %v1622, i64 8
  %v1624 = load i64, ptr %v1623, align 8, !noalias !147
  %v1625 = add nsw i64 %v1624, %v12
  store i64 %v1625, ptr %v1623, align 8, !noalias !147
  br label %v1582

v1582:
  %v1626 = icmp sgt i64 %v1627, 1
  br i1 %v1626, label %v1572, label %v1571

v1572:
  %v1627 = phi i64 [ %v1628, %v1582 ], [ %v308, %v1548 ]
  %v1575 = phi i64 [ %v1629, %v1582 ], [ 0, %v1548 ]
  %v1628 = add nsw i64 %v1627, -1
  %v1629 = add nsw i64 %v1575, 1
  %v1601 = getelementptr i64, ptr %v142, i64 %v1575
  %v1621 = load i64, ptr %v1601, align 8, !noalias !147
  %v1630 = getelementptr i64, ptr %v753, i64 %v1575
  %v1579 = load i64, ptr %v1630, align 8, !noalias !147
  %v1631 = icmp slt i64 %v1621, 0
  br i1 %v1631, label %v1582, label %v1573

v1571:
  br i1 %v1541, label %v1632, label %v1633

v1632:
  call void @llvm.lifetime.start.p0(ptr nonnull %v302), !noalias !154
  call void @llvm.lifetime.start.p0(ptr nonnull %v303), !noalias !154
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %v302, i8 0, i64 32, i1 false), !noalias !158
  store ptr null, ptr %v303, align 8, !noalias !158
  br label %v1634

v1634:
  %v1635 = phi i64 [ 0, %v1632 ], [ %v1636, %v1637 ]
  %v1636 = add nsw i64 %v1635, 1
  %v1638 = icmp ult i64 %v1635, 9
  br i1 %v1638, label %v1639, label %v1640

v1639:
  %v1641 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v1635
  %v1642 = load double, ptr %v1641, align 8
  %v1643 = load double, ptr %v133, align 8, !noalias !162
  %v1644 = load double, ptr %v772, align 8, !noalias !162
  %v1645 = fmul double %v1642, %v1644
  %v1646 = fadd double %v1643, %v1645
  store double %v1646, ptr %v774, align 8, !noalias !162
  br i1 %v776, label %v1647, label %v1637

v1647:
  %v1648 = fsub double 1.000000e+00, %v1642
  br label %v1649

v1649:
  %v1650 = phi i64 [ 0, %v1647 ], [ %v1651, %v1649 ]
  %v1652 = mul i64 %v1650, %v196
  %v1653 = getelementptr double, ptr %v193, i64 %v1652
  %v1654 = getelementptr i8, ptr %v1653, i64 %v780
  %v1655 = load double, ptr %v1654, align 8, !noalias !169
  %v1656 = fadd double %v1655, 0.000000e+00
  %v1657 = fmul double %v1642, %v1656
  %v1658 = getelementptr i8, ptr %v1653, i64 %v781
  %v1659 = load double, ptr %v1658, align 8, !noalias !169
  %v1660 = fadd double %v1659, %v1657
  %v1661 = fmul double %v1648, %v1660
  %v1662 = getelementptr i8, ptr %v1653, i64 %v782
  %v1663 = load double, ptr %v1662, align 8, !noalias !169
  %v1664 = fadd double %v1663, %v1661
  %v1665 = fmul double %v1642, %v1664
  %v1666 = getelementptr i8, ptr %v1653, i64 %v783
  %v1667 = load double, ptr %v1666, align 8, !noalias !169
  %v1668 = fadd double %v1667, %v1665
  %v1669 = fmul double %v1648, %v1668
  %v1670 = getelementptr i8, ptr %v1653, i64 %v784
  %v1671 = load double, ptr %v1670, align 8, !noalias !169
  %v1672 = fadd double %v1671, %v1669
  %v1673 = fmul double %v1642, %v1672
  %v1674 = getelementptr i8, ptr %v1653, i64 %v785
  %v1675 = load double, ptr %v1674, align 8, !noalias !169
  %v1676 = fadd double %v1675, %v1673
  %v1677 = fmul double %v1648, %v1676
  %v1678 = getelementptr i8, ptr %v1653, i64 %v786
  %v1679 = load double, ptr %v1678, align 8, !noalias !169
  %v1680 = fadd double %v1679, %v1677
  %v1681 = fmul double %v1642, %v1680
  %v1651 = add nsw i64 %v1650, 1
  %v1682 = load double, ptr %v1653, align 8, !noalias !169
  %v1683 = fadd double %v1682, %v1681
  %v1684 = getelementptr double, ptr %v777, i64 %v1652
  store double %v1683, ptr %v1684, align 8, !noalias !162
  %v1685 = icmp eq i64 %v10, %v1651
  br i1 %v1685, label %v1637, label %v1649

v1637:
  %v1686 = icmp eq i64 %v1635, 8
  %v1687 = select i1 %v1686, i64 17, i64 16
  %v1688 = mul i64 %v1635, %v778
  %v1689 = load i64, ptr %v779, align 8, !noalias !173
  %v1690 = mul nsw i64 %v1687, %v10
  %v1691 = getelementptr double, ptr %v158, i64 %v1690
  %v1692 = getelementptr double, ptr %v186, i64 %v1688
  %v1693 = inttoptr i64 %v1689 to ptr
  tail call void %v1693(ptr nonnull %v774, ptr %v1691, ptr %v165, ptr %v172, ptr %v179, ptr %v1692), !noalias !173
  %v1694 = icmp eq i64 %v1636, 9
  br i1 %v1694, label %v1640, label %v1634

v1640:
  %v1695 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v1634 ], [ null, %v1637 ]
  %v1696 = phi i32 [ 1, %v1634 ], [ 0, %v1637 ]
  br i1 %v1638, label %v1697, label %v1698, !prof !131

v1697:
  %v1699 = load double, ptr %v788, align 8, !noalias !176
  %v1700 = load double, ptr %v92, align 8, !noalias !176
  %v1701 = fsub double %v1699, %v1700
  %v1702 = fmul double %v1701, 1.000000e-13
  %v1703 = load double, ptr %v133, align 8, !noalias !176
  %v1704 = tail call double @llvm.fabs.f64(double %v1703)
  %v1705 = fmul double %v1704, 4.000000e-15
  %v1706 = fcmp ogt double %v1705, %v1702
  %v1707 = select i1 %v1706, double %v1705, double %v1702
  %v1708 = load double, ptr %v772, align 8, !noalias !183
  %v1709 = fdiv double %v1707, %v1708
  %v1710 = fcmp olt double %v1709, 1.000000e+00
  %v1711 = select i1 %v1710, double %v1709, double 1.000000e+00
  br i1 %v789, label %v1712, label %v1713

v1714:
  %v1715 = fcmp olt double %v1716, %v1717
  %v1718 = select i1 %v1715, double %v1716, double %v1717
  %v1719 = fcmp ogt double %v1716, %v1720
  %v1721 = select i1 %v1719, double %v1716, double %v1720
  br label %v1722

v1722:
  %v1723 = phi double [ %v1721, %v1714 ], [ %v1720, %v1724 ]
  %v1725 = phi double [ %v1718, %v1714 ], [ %v1717, %v1724 ]
  %v1726 = icmp eq i64 %v1727, 9
  br i1 %v1726, label %v1728, label %v1724

v1728:
  %v1729 = fsub double %v1723, %v1725
  %v1730 = fmul double %v1711, %v1729
  %v1731 = tail call i1 @llvm.is.fpclass.f64(double %v1732, i32 543)
  %v1733 = select i1 %v1731, double 0.000000e+00, double %v1732
  %v1734 = tail call i1 @llvm.is.fpclass.f64(double %v1730, i32 543)
  %v1735 = select i1 %v1734, double -0.000000e+00, double %v1730
  %v1736 = fadd double %v1733, %v1735
  %v1737 = getelementptr double, ptr %v792, i64 %v1738
  %v1739 = load double, ptr %v1737, align 8, !noalias !183
  %v1740 = sub nsw i64 %v1741, %v18
  %v1742 = getelementptr double, ptr %v215, i64 %v1740
  %v1743 = load double, ptr %v1742, align 8, !noalias !183
  %v1744 = getelementptr double, ptr %v793, i64 %v1738
  store double %v1736, ptr %v1744, align 8, !noalias !183
  %v1745 = fcmp ule double %v1743, 5.000000e-01
  %v1746 = fcmp ule double %v1739, 0.000000e+00
  %v1747 = select i1 %v1745, i1 true, i1 %v1746
  %v1748 = select i1 %v1747, double %v1736, double 0.000000e+00
  %v1749 = getelementptr double, ptr %v1744, i64 %v790
  store double %v1748, ptr %v1749, align 8, !noalias !183
  %v1750 = getelementptr i8, ptr %v1744, i64 %v794
  store double %v1748, ptr %v1750, align 8, !noalias !183
  %v1751 = getelementptr i8, ptr %v1744, i64 %v795
  store double %v1748, ptr %v1751, align 8, !noalias !183
  %v1752 = getelementptr i8, ptr %v1744, i64 %v796
  store double %v1748, ptr %v1752, align 8, !noalias !183
  %v1753 = getelementptr i8, ptr %v1744, i64 %v797
  store double %v1748, ptr %v1753, align 8, !noalias !183
  %v1754 = getelementptr i8, ptr %v1744, i64 %v798
  store double %v1748, ptr %v1754, align 8, !noalias !183
  %v1755 = getelementptr i8, ptr %v1744, i64 %v799
  store double %v1748, ptr %v1755, align 8, !noalias !183
  %v1756 = getelementptr i8, ptr %v1744, i64 %v800
  store double %v1748, ptr %v1756, align 8, !noalias !183
  %v1757 = add nsw i64 %v1758, -1
  %v1759 = add i64 %v1741, 1
  %v1760 = icmp sgt i64 %v1758, 1
  br i1 %v1760, label %v1713, label %v1712

v1713:
  %v1758 = phi i64 [ %v1757, %v1728 ], [ %v15, %v1697 ]
  %v1741 = phi i64 [ %v1759, %v1728 ], [ %v18, %v1697 ]
  %v1761 = icmp slt i64 %v1741, 0
  %v1762 = select i1 %v1761, i64 %v207, i64 0
  %v1738 = add i64 %v1762, %v1741
  br label %v1724

v1724:
  %v1717 = phi double [ 0x7FF0000000000000, %v1713 ], [ %v1725, %v1722 ]
  %v1720 = phi double [ 0xFFF0000000000000, %v1713 ], [ %v1723, %v1722 ]
  %v1763 = phi double [ 0.000000e+00, %v1713 ], [ %v1732, %v1722 ]
  %v1764 = phi i64 [ 0, %v1713 ], [ %v1727, %v1722 ]
  %v1727 = add nsw i64 %v1764, 1
  %v1765 = mul i64 %v1764, %v790
  %v1766 = getelementptr double, ptr %v204, i64 %v1765
  %v1767 = getelementptr i8, ptr %v1766, i64 %v791
  %v1768 = getelementptr double, ptr %v1767, i64 %v1738
  %v1769 = load double, ptr %v1768, align 8, !noalias !183
  %v1770 = tail call i1 @llvm.is.fpclass.f64(double %v1769, i32 543)
  %v1771 = fadd double %v1769, 0.000000e+00
  %v1772 = select i1 %v1770, double 0.000000e+00, double %v1771
  %v1773 = fcmp ogt double %v1772, %v1763
  %v1732 = select i1 %v1773, double %v1772, double %v1763
  %v1774 = getelementptr double, ptr %v1766, i64 %v207
  %v1775 = getelementptr double, ptr %v1774, i64 %v1738
  %v1716 = load double, ptr %v1775, align 8, !noalias !183
  %v1776 = tail call double @llvm.fabs.f64(double %v1716)
  %v1777 = fcmp ueq double %v1776, 0x7FF0000000000000
  br i1 %v1777, label %v1722, label %v1714

v1712:
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %v302, i8 0, i64 32, i1 false), !noalias !158
  %v1778 = call fastcc i32 @_ZN5pages12event_checks13find_crossingB3v65B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr %v302, ptr %v303, i64 %v14, ptr nonnull readonly %v92, i64 %v93, ptr %v124, i64 %v125, i64 %v126, ptr nonnull %v133, i64 %v135, ptr %v142, i64 %v144, ptr %v204, i64 %v205, i64 %v206, i64 %v207, double 0.000000e+00)
  %v1779 = icmp eq i32 %v1778, 0
  br i1 %v1779, label %v1780, label %v1781, !prof !131

v1781:
  %v1782 = load ptr, ptr %v303, align 8, !noalias !158
  br label %v1698

v1780:
  %v1783 = load double, ptr %v302, align 8, !noalias !158
  %v1784 = load double, ptr %v767, align 8, !noalias !158
  %v1785 = load double, ptr %v768, align 8, !noalias !158
  %v1786 = load double, ptr %v769, align 8, !noalias !158
  br label %v1698

v1698:
  %v1787 = phi double [ %v1786, %v1780 ], [ 0.000000e+00, %v1781 ], [ 0.000000e+00, %v1640 ]
  %v1788 = phi double [ %v1785, %v1780 ], [ 0.000000e+00, %v1781 ], [ 0.000000e+00, %v1640 ]
  %v1789 = phi double [ %v1784, %v1780 ], [ 0.000000e+00, %v1781 ], [ 0.000000e+00, %v1640 ]
  %v1790 = phi double [ %v1783, %v1780 ], [ 0.000000e+00, %v1781 ], [ 0.000000e+00, %v1640 ]
  %v1791 = phi ptr [ null, %v1780 ], [ %v1782, %v1781 ], [ %v1695, %v1640 ]
  %v1792 = phi i32 [ 0, %v1780 ], [ 1, %v1781 ], [ %v1696, %v1640 ]
  call void @llvm.lifetime.end.p0(ptr nonnull %v302), !noalias !154
  call void @llvm.lifetime.end.p0(ptr nonnull %v303), !noalias !154
  %v1793 = icmp eq i32 %v1792, 0
  br i1 %v1793, label %v1794, label %v1795, !prof !131

v1796:
  %v1797 = load double, ptr %v772, align 8, !noalias !154
  %v1798 = load double, ptr %v804, align 8, !noalias !154
  %v1799 = load double, ptr %v92, align 8, !noalias !154
  %v1800 = fsub double %v1798, %v1799
  %v1801 = load double, ptr %v806, align 8, !noalias !154
  %v1802 = load double, ptr %v808, align 8, !noalias !154
  %v1803 = fsub double %v1801, %v1802
  %v1804 = fmul double %v1800, 5.000000e-06
  %v1805 = fcmp olt double %v1803, %v1804
  br label %v1806

v1807:
  %v1808 = sub nsw i64 45, %v1809
  br label %v1810

v1810:
  %v1811 = phi double [ %v1812, %v1810 ], [ 1.000000e+00, %v1807 ]
  %v1813 = phi double [ %v1814, %v1810 ], [ 2.000000e+00, %v1807 ]
  %v1815 = phi i64 [ %v1816, %v1810 ], [ %v1808, %v1807 ]
  %v1817 = and i64 %v1815, 1
  %v1818 = icmp eq i64 %v1817, 0
  %v1819 = fmul double %v1811, %v1813
  %v1812 = select i1 %v1818, double %v1811, double %v1819
  %v1816 = lshr i64 %v1815, 1
  %v1814 = fmul double %v1813, %v1813
  %v1820 = icmp eq i64 %v1816, 0
  br i1 %v1820, label %v1821, label %v1810

v1822:
  %v1823 = fcmp olt double %v1824, 0.000000e+00
  %v1825 = select i1 %v1823, double 0.000000e+00, double %v1824
  %v1826 = fmul double %v1827, %v1825
  %v1828 = fsub double %v1829, %v1826
  br label %v1830

v1821:
  %v1831 = fadd double %v1832, %v1833
  %v1829 = fmul double %v1831, 5.000000e-01
  %v1834 = fmul double %v1812, 1.000000e-13
  %v1835 = fsub double %v1834, %v1836
  %v1824 = fmul double %v1835, 5.000000e-01
  %v1837 = fmul double %v1838, %v1833
  %v1839 = fmul double %v1840, %v1832
  %v1841 = fsub double %v1837, %v1839
  %v1842 = fsub double %v1838, %v1840
  %v1843 = fdiv double %v1841, %v1842
  %v1844 = fcmp olt double %v1833, %v1843
  %v1845 = fcmp olt double %v1843, %v1832
  %v1846 = and i1 %v1844, %v1845
  %v1847 = select i1 %v1846, double %v1843, double %v1829
  %v1848 = fsub double %v1829, %v1847
  %v1827 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v1848)
  %v1849 = fmul double %v1836, %v1836
  %v1850 = tail call double @llvm.fabs.f64(double %v1848)
  %v1851 = fcmp olt double %v1850, %v1849
  %v1852 = select i1 %v1851, double %v1850, double %v1849
  %v1853 = fmul double %v1827, %v1852
  %v1854 = fadd double %v1847, %v1853
  %v1855 = fsub double %v1854, %v1829
  %v1856 = tail call double @llvm.fabs.f64(double %v1855)
  %v1857 = fcmp ugt double %v1856, %v1824
  br i1 %v1857, label %v1822, label %v1830

v1858:
  br label %v1859

v1859:
  %v1860 = phi double [ %v1861, %v1858 ], [ %v1833, %v1862 ]
  %v1863 = phi double [ %v1864, %v1858 ], [ %v1840, %v1862 ]
  %v1865 = phi double [ %v1838, %v1858 ], [ %v1864, %v1862 ]
  %v1866 = phi double [ %v1832, %v1858 ], [ %v1861, %v1862 ]
  %v1867 = icmp eq i64 %v1868, 45
  br i1 %v1867, label %v1869, label %v1806

v1806:
  %v1838 = phi double [ %v1787, %v1796 ], [ %v1865, %v1859 ]
  %v1840 = phi double [ %v1788, %v1796 ], [ %v1863, %v1859 ]
  %v1832 = phi double [ %v1789, %v1796 ], [ %v1866, %v1859 ]
  %v1833 = phi double [ %v1790, %v1796 ], [ %v1860, %v1859 ]
  %v1809 = phi i64 [ 0, %v1796 ], [ %v1868, %v1859 ]
  %v1868 = add nsw i64 %v1809, 1
  %v1836 = fsub double %v1832, %v1833
  %v1870 = fcmp ugt double %v1836, 1.000000e-13
  br i1 %v1870, label %v1807, label %v1869

v1830:
  %v1861 = phi double [ %v1854, %v1821 ], [ %v1828, %v1822 ]
  %v1871 = load double, ptr %v133, align 8, !noalias !184
  %v1872 = load double, ptr %v772, align 8, !noalias !184
  %v1873 = fmul double %v1861, %v1872
  %v1874 = fadd double %v1871, %v1873
  store double %v1874, ptr %v774, align 8, !noalias !184
  br i1 %v776, label %v1875, label %v1876

v1875:
  %v1877 = fsub double 1.000000e+00, %v1861
  br label %v1878

v1878:
  %v1879 = phi i64 [ 0, %v1875 ], [ %v1880, %v1878 ]
  %v1881 = mul i64 %v1879, %v196
  %v1882 = getelementptr double, ptr %v193, i64 %v1881
  %v1883 = getelementptr i8, ptr %v1882, i64 %v780
  %v1884 = load double, ptr %v1883, align 8, !noalias !193
  %v1885 = fadd double %v1884, 0.000000e+00
  %v1886 = fmul double %v1861, %v1885
  %v1887 = getelementptr i8, ptr %v1882, i64 %v781
  %v1888 = load double, ptr %v1887, align 8, !noalias !193
  %v1889 = fadd double %v1888, %v1886
  %v1890 = fmul double %v1877, %v1889
  %v1891 = getelementptr i8, ptr %v1882, i64 %v782
  %v1892 = load double, ptr %v1891, align 8, !noalias !193
  %v1893 = fadd double %v1892, %v1890
  %v1894 = fmul double %v1861, %v1893
  %v1895 = getelementptr i8, ptr %v1882, i64 %v783
  %v1896 = load double, ptr %v1895, align 8, !noalias !193
  %v1897 = fadd double %v1896, %v1894
  %v1898 = fmul double %v1877, %v1897
  %v1899 = getelementptr i8, ptr %v1882, i64 %v784
  %v1900 = load double, ptr %v1899, align 8, !noalias !193
  %v1901 = fadd double %v1900, %v1898
  %v1902 = fmul double %v1861, %v1901
  %v1903 = getelementptr i8, ptr %v1882, i64 %v785
  %v1904 = load double, ptr %v1903, align 8, !noalias !193
  %v1905 = fadd double %v1904, %v1902
  %v1906 = fmul double %v1877, %v1905
  %v1907 = getelementptr i8, ptr %v1882, i64 %v786
  %v1908 = load double, ptr %v1907, align 8, !noalias !193
  %v1909 = fadd double %v1908, %v1906
  %v1910 = fmul double %v1861, %v1909
  %v1880 = add nsw i64 %v1879, 1
  %v1911 = load double, ptr %v1882, align 8, !noalias !193
  %v1912 = fadd double %v1911, %v1910
  %v1913 = getelementptr double, ptr %v777, i64 %v1881
  store double %v1912, ptr %v1913, align 8, !noalias !184
  %v1914 = icmp eq i64 %v10, %v1880
  br i1 %v1914, label %v1876, label %v1878

v1876:
  %v1915 = load i64, ptr %v779, align 8, !noalias !197
  %v1916 = inttoptr i64 %v1915 to ptr
  tail call void %v1916(ptr nonnull %v774, ptr %v811, ptr %v165, ptr %v172, ptr %v179, ptr %v813), !noalias !197
  br i1 %v816, label %v1917, label %v1918

v1917:
  %v1919 = phi i64 [ %v1920, %v1917 ], [ %v815, %v1876 ]
  %v1921 = phi i64 [ %v1922, %v1917 ], [ %v18, %v1876 ]
  %v1920 = add nsw i64 %v1919, -1
  %v1922 = add i64 %v1921, 1
  %v1923 = icmp slt i64 %v1921, 0
  %v1924 = select i1 %v1923, i64 %v207, i64 0
  %v1925 = add i64 %v1924, %v1921
  %v1926 = getelementptr double, ptr %v820, i64 %v1925
  %v1927 = load double, ptr %v1926, align 8, !noalias !200
  %v1928 = getelementptr double, ptr %v823, i64 %v1925
  store double %v1927, ptr %v1928, align 8, !noalias !200
  %v1929 = icmp sgt i64 %v1919, 1
  br i1 %v1929, label %v1917, label %v1918

v1918:
  br i1 %v824, label %v1862, label %v1930

v1930:
  %v1931 = phi double [ %v1932, %v1930 ], [ 0x7FF0000000000000, %v1918 ]
  %v1933 = phi i64 [ %v1934, %v1930 ], [ 0, %v1918 ]
  %v1934 = add nsw i64 %v1933, 1
  %v1935 = getelementptr double, ptr %v825, i64 %v1933
  %v1936 = load double, ptr %v1935, align 8, !noalias !201
  %v1937 = getelementptr double, ptr %v823, i64 %v1933
  %v1938 = load double, ptr %v1937, align 8, !noalias !201
  %v1939 = fadd double %v1936, %v1938
  %v1940 = fcmp olt double %v1939, %v1931
  %v1932 = select i1 %v1940, double %v1939, double %v1931
  %v1941 = icmp eq i64 %v207, %v1934
  br i1 %v1941, label %v1862, label %v1930

v1862:
  %v1864 = phi double [ 0x7FF0000000000000, %v1918 ], [ %v1932, %v1930 ]
  %v1942 = fcmp olt double %v1864, 0.000000e+00
  br i1 %v1942, label %v1859, label %v1858

v1943:
  %v1944 = load double, ptr %v133, align 8, !noalias !205
  %v1945 = load double, ptr %v772, align 8, !noalias !205
  %v1946 = fmul double %v1947, %v1945
  %v1948 = fadd double %v1944, %v1946
  store double %v1948, ptr %v774, align 8, !noalias !205
  br i1 %v776, label %v1949, label %v1950

v1949:
  %v1951 = fsub double 1.000000e+00, %v1947
  br label %v1952

v1952:
  %v1953 = phi i64 [ 0, %v1949 ], [ %v1954, %v1952 ]
  %v1955 = mul i64 %v1953, %v196
  %v1956 = getelementptr double, ptr %v193, i64 %v1955
  %v1957 = getelementptr i8, ptr %v1956, i64 %v780
  %v1958 = load double, ptr %v1957, align 8, !noalias !215
  %v1959 = fadd double %v1958, 0.000000e+00
  %v1960 = fmul double %v1947, %v1959
  %v1961 = getelementptr i8, ptr %v1956, i64 %v781
  %v1962 = load double, ptr %v1961, align 8, !noalias !215
  %v1963 = fadd double %v1962, %v1960
  %v1964 = fmul double %v1951, %v1963
  %v1965 = getelementptr i8, ptr %v1956, i64 %v782
  %v1966 = load double, ptr %v1965, align 8, !noalias !215
  %v1967 = fadd double %v1966, %v1964
  %v1968 = fmul double %v1947, %v1967
  %v1969 = getelementptr i8, ptr %v1956, i64 %v783
  %v1970 = load double, ptr %v1969, align 8, !noalias !215
  %v1971 = fadd double %v1970, %v1968
  %v1972 = fmul double %v1951, %v1971
  %v1973 = getelementptr i8, ptr %v1956, i64 %v784
  %v1974 = load double, ptr %v1973, align 8, !noalias !215
  %v1975 = fadd double %v1974, %v1972
  %v1976 = fmul double %v1947, %v1975
  %v1977 = getelementptr i8, ptr %v1956, i64 %v785
  %v1978 = load double, ptr %v1977, align 8, !noalias !215
  %v1979 = fadd double %v1978, %v1976
  %v1980 = fmul double %v1951, %v1979
  %v1981 = getelementptr i8, ptr %v1956, i64 %v786
  %v1982 = load double, ptr %v1981, align 8, !noalias !215
  %v1983 = fadd double %v1982, %v1980
  %v1984 = fmul double %v1947, %v1983
  %v1954 = add nsw i64 %v1953, 1
  %v1985 = load double, ptr %v1956, align 8, !noalias !215
  %v1986 = fadd double %v1985, %v1984
  %v1987 = getelementptr double, ptr %v777, i64 %v1955
  store double %v1986, ptr %v1987, align 8, !noalias !205
  %v1988 = icmp eq i64 %v10, %v1954
  br i1 %v1988, label %v1950, label %v1952

v1950:
  %v1989 = load i64, ptr %v779, align 8, !noalias !219
  %v1990 = inttoptr i64 %v1989 to ptr
  tail call void %v1990(ptr nonnull %v774, ptr %v811, ptr %v165, ptr %v172, ptr %v179, ptr %v813), !noalias !219
  br i1 %v816, label %v1991, label %v1992

v1992:
  br label %v1993

v1991:
  %v1994 = phi i64 [ %v1995, %v1991 ], [ %v815, %v1950 ]
  %v1996 = phi i64 [ %v1997, %v1991 ], [ %v18, %v1950 ]
  %v1995 = add nsw i64 %v1994, -1
  %v1997 = add i64 %v1996, 1
  %v1998 = icmp slt i64 %v1996, 0
  %v1999 = select i1 %v1998, i64 %v207, i64 0
  %v2000 = add i64 %v1999, %v1996
  %v2001 = getelementptr double, ptr %v820, i64 %v2000
  %v2002 = load double, ptr %v2001, align 8, !noalias !222
  %v2003 = getelementptr double, ptr %v823, i64 %v2000
  store double %v2002, ptr %v2003, align 8, !noalias !222
  %v2004 = icmp sgt i64 %v1994, 1
  br i1 %v2004, label %v1991, label %v1992

v2005:
  %v2006 = icmp slt i64 %v2007, 0
  %v2008 = select i1 %v2006, i64 %v207, i64 0
  %v2009 = add i64 %v2008, %v2007
  %v2010 = getelementptr double, ptr %v825, i64 %v2009
  %v2011 = load double, ptr %v2010, align 8, !noalias !223
  br label %v2012

v2013:
  %v2014 = phi i64 [ 0, %v2015 ], [ %v2016, %v2013 ]
  %v2017 = mul i64 %v2014, %v196
  %v2018 = getelementptr double, ptr %v193, i64 %v2017
  %v2019 = getelementptr i8, ptr %v2018, i64 %v780
  %v2020 = load double, ptr %v2019, align 8, !noalias !224
  %v2021 = fadd double %v2020, 0.000000e+00
  %v2022 = fmul double %v2023, %v2021
  %v2024 = getelementptr i8, ptr %v2018, i64 %v781
  %v2025 = load double, ptr %v2024, align 8, !noalias !224
  %v2026 = fadd double %v2025, %v2022
  %v2027 = fmul double %v2028, %v2026
  %v2029 = getelementptr i8, ptr %v2018, i64 %v782
  %v2030 = load double, ptr %v2029, align 8, !noalias !224
  %v2031 = fadd double %v2030, %v2027
  %v2032 = fmul double %v2023, %v2031
  %v2033 = getelementptr i8, ptr %v2018, i64 %v783
  %v2034 = load double, ptr %v2033, align 8, !noalias !224
  %v2035 = fadd double %v2034, %v2032
  %v2036 = fmul double %v2028, %v2035
  %v2037 = getelementptr i8, ptr %v2018, i64 %v784
  %v2038 = load double, ptr %v2037, align 8, !noalias !224
  %v2039 = fadd double %v2038, %v2036
  %v2040 = fmul double %v2023, %v2039
  %v2041 = getelementptr i8, ptr %v2018, i64 %v785
  %v2042 = load double, ptr %v2041, align 8, !noalias !224
  %v2043 = fadd double %v2042, %v2040
  %v2044 = fmul double %v2028, %v2043
  %v2045 = getelementptr i8, ptr %v2018, i64 %v786
  %v2046 = load double, ptr %v2045, align 8, !noalias !224
  %v2047 = fadd double %v2046, %v2044
  %v2048 = fmul double %v2023, %v2047
  %v2016 = add nsw i64 %v2014, 1
  %v2049 = load double, ptr %v2018, align 8, !noalias !224
  %v2050 = fadd double %v2049, %v2048
  %v2051 = getelementptr double, ptr %v777, i64 %v2017
  store double %v2050, ptr %v2051, align 8, !noalias !234
  %v2052 = icmp eq i64 %v10, %v2016
  br i1 %v2052, label %v2053, label %v2013

v2053:
  %v2054 = load i64, ptr %v779, align 8, !noalias !235
  %v2055 = inttoptr i64 %v2054 to ptr
  tail call void %v2055(ptr nonnull %v774, ptr %v811, ptr %v165, ptr %v172, ptr %v179, ptr %v813), !noalias !235
  br i1 %v860, label %v2056, label %v2057

v2057:
  %v2058 = phi i64 [ %v2059, %v2057 ], [ %v815, %v2053 ]
  %v2060 = phi i64 [ %v2061, %v2057 ], [ %v18, %v2053 ]
  %v2059 = add nsw i64 %v2058, -1
  %v2061 = add i64 %v2060, 1
  %v2062 = icmp slt i64 %v2060, 0
  %v2063 = select i1 %v2062, i64 %v207, i64 0
  %v2064 = add i64 %v2063, %v2060
  %v2065 = getelementptr double, ptr %v820, i64 %v2064
  %v2066 = load double, ptr %v2065, align 8, !noalias !238
  %v2067 = getelementptr double, ptr %v823, i64 %v2064
  store double %v2066, ptr %v2067, align 8, !noalias !238
  %v2068 = icmp sgt i64 %v2058, 1
  br i1 %v2068, label %v2057, label %v2056

v2069:
  %v2070 = select i1 %v2071, double %v1947, double %v2023
  %v2072 = fmul double %v2070, 5.000000e-01
  %v2073 = icmp eq i64 %v2074, 45
  br i1 %v2073, label %v2075, label %v2012

v2076:
  %v2077 = getelementptr double, ptr %v820, i64 %v2009
  store double 0.000000e+00, ptr %v2077, align 8, !noalias !223
  br label %v2078

v2079:
  %v2080 = sub nsw i64 45, %v2081
  br label %v2082

v2082:
  %v2083 = phi double [ %v2084, %v2082 ], [ 1.000000e+00, %v2079 ]
  %v2085 = phi double [ %v2086, %v2082 ], [ 2.000000e+00, %v2079 ]
  %v2087 = phi i64 [ %v2088, %v2082 ], [ %v2080, %v2079 ]
  %v2089 = and i64 %v2087, 1
  %v2090 = icmp eq i64 %v2089, 0
  %v2091 = fmul double %v2083, %v2085
  %v2084 = select i1 %v2090, double %v2083, double %v2091
  %v2088 = lshr i64 %v2087, 1
  %v2086 = fmul double %v2085, %v2085
  %v2092 = icmp eq i64 %v2088, 0
  br i1 %v2092, label %v2093, label %v2082

v2094:
  %v2095 = fcmp olt double %v2096, 0.000000e+00
  %v2097 = select i1 %v2095, double 0.000000e+00, double %v2096
  %v2098 = fmul double %v2099, %v2097
  %v2100 = fsub double %v2101, %v2098
  br label %v2102

v2093:
  %v2103 = fadd double %v2104, %v2105
  %v2101 = fmul double %v2103, 5.000000e-01
  %v2106 = fmul double %v2084, 0x3D06849B86A12B9B
  %v2107 = fsub double %v2106, %v2108
  %v2096 = fmul double %v2107, 5.000000e-01
  %v2109 = fmul double %v2110, %v2105
  %v2111 = fmul double %v2112, %v2104
  %v2113 = fsub double %v2109, %v2111
  %v2114 = fsub double %v2110, %v2112
  %v2115 = fdiv double %v2113, %v2114
  %v2116 = fcmp olt double %v2105, %v2115
  %v2117 = fcmp olt double %v2115, %v2104
  %v2118 = and i1 %v2116, %v2117
  %v2119 = select i1 %v2118, double %v2115, double %v2101
  %v2120 = fsub double %v2101, %v2119
  %v2099 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v2120)
  %v2121 = fmul double %v2108, %v2108
  %v2122 = tail call double @llvm.fabs.f64(double %v2120)
  %v2123 = fcmp olt double %v2122, %v2121
  %v2124 = select i1 %v2123, double %v2122, double %v2121
  %v2125 = fmul double %v2099, %v2124
  %v2126 = fadd double %v2119, %v2125
  %v2127 = fsub double %v2126, %v2101
  %v2128 = tail call double @llvm.fabs.f64(double %v2127)
  %v2129 = fcmp ugt double %v2128, %v2096
  br i1 %v2129, label %v2094, label %v2102

v2130:
  br label %v2131

v2131:
  %v2132 = phi double [ %v2133, %v2130 ], [ %v2105, %v2134 ]
  %v2135 = phi double [ %v2136, %v2130 ], [ %v2112, %v2134 ]
  %v2137 = phi double [ %v2110, %v2130 ], [ %v2136, %v2134 ]
  %v2138 = phi double [ %v2104, %v2130 ], [ %v2133, %v2134 ]
  %v2139 = icmp eq i64 %v2140, 45
  br i1 %v2139, label %v2075, label %v2078

v2078:
  %v2110 = phi double [ %v2011, %v2076 ], [ %v2137, %v2131 ]
  %v2112 = phi double [ %v2141, %v2076 ], [ %v2135, %v2131 ]
  %v2104 = phi double [ %v1947, %v2076 ], [ %v2138, %v2131 ]
  %v2105 = phi double [ %v2023, %v2076 ], [ %v2132, %v2131 ]
  %v2081 = phi i64 [ 0, %v2076 ], [ %v2140, %v2131 ]
  %v2140 = add nsw i64 %v2081, 1
  %v2108 = fsub double %v2104, %v2105
  %v2142 = fcmp ugt double %v2108, 0x3D06849B86A12B9B
  br i1 %v2142, label %v2079, label %v2075

v2102:
  %v2133 = phi double [ %v2126, %v2093 ], [ %v2100, %v2094 ]
  %v2143 = load double, ptr %v133, align 8, !noalias !239
  %v2144 = load double, ptr %v772, align 8, !noalias !239
  %v2145 = fmul double %v2133, %v2144
  %v2146 = fadd double %v2143, %v2145
  store double %v2146, ptr %v774, align 8, !noalias !239
  br i1 %v776, label %v2147, label %v2148

v2147:
  %v2149 = fsub double 1.000000e+00, %v2133
  br label %v2150

v2150:
  %v2151 = phi i64 [ 0, %v2147 ], [ %v2152, %v2150 ]
  %v2153 = mul i64 %v2151, %v196
  %v2154 = getelementptr double, ptr %v193, i64 %v2153
  %v2155 = getelementptr i8, ptr %v2154, i64 %v780
  %v2156 = load double, ptr %v2155, align 8, !noalias !248
  %v2157 = fadd double %v2156, 0.000000e+00
  %v2158 = fmul double %v2133, %v2157
  %v2159 = getelementptr i8, ptr %v2154, i64 %v781
  %v2160 = load double, ptr %v2159, align 8, !noalias !248
  %v2161 = fadd double %v2160, %v2158
  %v2162 = fmul double %v2149, %v2161
  %v2163 = getelementptr i8, ptr %v2154, i64 %v782
  %v2164 = load double, ptr %v2163, align 8, !noalias !248
  %v2165 = fadd double %v2164, %v2162
  %v2166 = fmul double %v2133, %v2165
  %v2167 = getelementptr i8, ptr %v2154, i64 %v783
  %v2168 = load double, ptr %v2167, align 8, !noalias !248
  %v2169 = fadd double %v2168, %v2166
  %v2170 = fmul double %v2149, %v2169
  %v2171 = getelementptr i8, ptr %v2154, i64 %v784
  %v2172 = load double, ptr %v2171, align 8, !noalias !248
  %v2173 = fadd double %v2172, %v2170
  %v2174 = fmul double %v2133, %v2173
  %v2175 = getelementptr i8, ptr %v2154, i64 %v785
  %v2176 = load double, ptr %v2175, align 8, !noalias !248
  %v2177 = fadd double %v2176, %v2174
  %v2178 = fmul double %v2149, %v2177
  %v2179 = getelementptr i8, ptr %v2154, i64 %v786
  %v2180 = load double, ptr %v2179, align 8, !noalias !248
  %v2181 = fadd double %v2180, %v2178
  %v2182 = fmul double %v2133, %v2181
  %v2152 = add nsw i64 %v2151, 1
  %v2183 = load double, ptr %v2154, align 8, !noalias !248
  %v2184 = fadd double %v2183, %v2182
  %v2185 = getelementptr double, ptr %v777, i64 %v2153
  store double %v2184, ptr %v2185, align 8, !noalias !239
  %v2186 = icmp eq i64 %v10, %v2152
  br i1 %v2186, label %v2148, label %v2150

v2148:
  %v2187 = load i64, ptr %v779, align 8, !noalias !252
  %v2188 = inttoptr i64 %v2187 to ptr
  tail call void %v2188(ptr nonnull %v774, ptr %v811, ptr %v165, ptr %v172, ptr %v179, ptr %v813), !noalias !252
  br i1 %v816, label %v2189, label %v2190

v2189:
  %v2191 = phi i64 [ %v2192, %v2189 ], [ %v815, %v2148 ]
  %v2193 = phi i64 [ %v2194, %v2189 ], [ %v18, %v2148 ]
  %v2192 = add nsw i64 %v2191, -1
  %v2194 = add i64 %v2193, 1
  %v2195 = icmp slt i64 %v2193, 0
  %v2196 = select i1 %v2195, i64 %v207, i64 0
  %v2197 = add i64 %v2196, %v2193
  %v2198 = getelementptr double, ptr %v820, i64 %v2197
  %v2199 = load double, ptr %v2198, align 8, !noalias !255
  %v2200 = getelementptr double, ptr %v823, i64 %v2197
  store double %v2199, ptr %v2200, align 8, !noalias !255
  %v2201 = icmp sgt i64 %v2191, 1
  br i1 %v2201, label %v2189, label %v2190

v2190:
  br i1 %v824, label %v2134, label %v2202

v2202:
  %v2203 = phi double [ %v2204, %v2202 ], [ 0x7FF0000000000000, %v2190 ]
  %v2205 = phi i64 [ %v2206, %v2202 ], [ 0, %v2190 ]
  %v2206 = add nsw i64 %v2205, 1
  %v2207 = getelementptr double, ptr %v825, i64 %v2205
  %v2208 = load double, ptr %v2207, align 8, !noalias !256
  %v2209 = getelementptr double, ptr %v823, i64 %v2205
  %v2210 = load double, ptr %v2209, align 8, !noalias !256
  %v2211 = fadd double %v2208, %v2210
  %v2212 = fcmp olt double %v2211, %v2203
  %v2204 = select i1 %v2212, double %v2211, double %v2203
  %v2213 = icmp eq i64 %v207, %v2206
  br i1 %v2213, label %v2134, label %v2202

v2134:
  %v2136 = phi double [ 0x7FF0000000000000, %v2190 ], [ %v2204, %v2202 ]
  %v2214 = fcmp olt double %v2136, 0.000000e+00
  br i1 %v2214, label %v2131, label %v2130

v2075:
  %v2215 = phi double [ %v2104, %v2078 ], [ %v2138, %v2131 ], [ 0.000000e+00, %v2069 ]
  %v2216 = phi double [ %v2105, %v2078 ], [ %v2132, %v2131 ], [ %v2023, %v2069 ]
  store double %v2216, ptr %v862, align 8, !noalias !223
  store double %v2215, ptr %v864, align 8, !noalias !223
  %v2217 = load double, ptr %v133, align 8, !noalias !223
  %v2218 = load double, ptr %v772, align 8, !noalias !223
  %v2219 = fmul double %v2215, %v2218
  %v2220 = fadd double %v2217, %v2219
  %v2221 = load i64, ptr %v142, align 8, !noalias !260
  %v2222 = load i64, ptr %v866, align 8, !noalias !260
  %v2223 = icmp slt i64 %v2222, %v93
  br i1 %v2223, label %v2224, label %v2225

v2224:
  %v2226 = icmp slt i64 %v2222, 0
  %v2227 = select i1 %v2226, i64 %v93, i64 0
  %v2228 = getelementptr double, ptr %v92, i64 %v2222
  %v2229 = getelementptr double, ptr %v2228, i64 %v2227
  %v2230 = load double, ptr %v2229, align 8, !noalias !260
  %v2231 = fcmp ugt double %v2230, %v2220
  br i1 %v2231, label %v2225, label %v2232

v2232:
  %v2233 = icmp slt i64 %v2221, 0
  %v2234 = select i1 %v2233, i64 %v100, i64 0
  %v2235 = add i64 %v2234, %v2221
  %v2236 = mul i64 %v869, %v2235
  %v2237 = getelementptr double, ptr %v99, i64 %v2236
  br label %v2238

v2238:
  %v2239 = phi i64 [ %v2240, %v2241 ], [ %v2222, %v2232 ]
  %v2242 = icmp slt i64 %v2239, 0
  %v2243 = select i1 %v2242, i64 %v93, i64 0
  %v2244 = getelementptr double, ptr %v92, i64 %v2239
  %v2245 = getelementptr double, ptr %v2244, i64 %v2243
  %v2246 = load double, ptr %v2245, align 8, !noalias !260
  %v2247 = load double, ptr %v133, align 8, !noalias !260
  %v2248 = fsub double %v2246, %v2247
  %v2249 = load double, ptr %v772, align 8, !noalias !260
  %v2250 = fdiv double %v2248, %v2249
  br i1 %v859, label %v2251, label %v2252

v2252:
  %v2253 = fsub double 1.000000e+00, %v2250
  %v2254 = select i1 %v2242, i64 %v101, i64 0
  %v2255 = add i64 %v2254, %v2239
  %v2256 = mul i64 %v2255, %v102
  %v2257 = getelementptr double, ptr %v2237, i64 %v2256
  br label %v2258

v2259:
  %v2260 = getelementptr double, ptr %v871, i64 %v2261
  %v2262 = load double, ptr %v2260, align 8, !noalias !260
  br label %v2263

v2251:
  store double 0x7FF0000000000000, ptr %v868, align 8, !noalias !260
  %v2264 = icmp eq i64 %v2239, %v872
  br i1 %v2264, label %v2225, label %v2241

v2241:
  %v2240 = add i64 %v2239, 1
  %v2265 = icmp slt i64 %v2239, -1
  %v2266 = select i1 %v2265, i64 %v93, i64 0
  %v2267 = getelementptr double, ptr %v92, i64 %v2240
  %v2268 = getelementptr double, ptr %v2267, i64 %v2266
  %v2269 = load double, ptr %v2268, align 8, !noalias !260
  %v2270 = fcmp ugt double %v2269, %v2220
  br i1 %v2270, label %v2225, label %v2238

v2225:
  %v2271 = phi i64 [ %v2222, %v2224 ], [ %v2222, %v2075 ], [ %v93, %v2251 ], [ %v2240, %v2241 ]
  store i64 %v2271, ptr %v866, align 8, !noalias !260
  store i64 %v2007, ptr %v802, align 8, !noalias !223
  %v2272 = load i64, ptr %v142, align 8, !noalias !264
  %v2273 = icmp sgt i64 %v2272, -1
  br i1 %v2273, label %v2274, label %v2275

v2263:
  %v2276 = phi double [ %v2277, %v2278 ], [ %v2262, %v2259 ]
  %v2279 = getelementptr double, ptr %v2257, i64 %v2280
  store double %v2276, ptr %v2279, align 8, !noalias !260
  %v2281 = icmp eq i64 %v10, %v2282
  br i1 %v2281, label %v2251, label %v2258

v2258:
  %v2280 = phi i64 [ 0, %v2252 ], [ %v2282, %v2263 ]
  %v2282 = add nsw i64 %v2280, 1
  %v2283 = load double, ptr %v2245, align 8, !noalias !260
  %v2284 = load double, ptr %v806, align 8, !noalias !260
  %v2285 = fcmp oeq double %v2283, %v2284
  %v2261 = mul i64 %v2280, %v196
  br i1 %v2285, label %v2259, label %v2278

v2278:
  %v2286 = getelementptr double, ptr %v193, i64 %v2261
  %v2287 = getelementptr i8, ptr %v2286, i64 %v780
  %v2288 = load double, ptr %v2287, align 8, !noalias !267
  %v2289 = fadd double %v2288, 0.000000e+00
  %v2290 = fmul double %v2250, %v2289
  %v2291 = getelementptr i8, ptr %v2286, i64 %v781
  %v2292 = load double, ptr %v2291, align 8, !noalias !267
  %v2293 = fadd double %v2292, %v2290
  %v2294 = fmul double %v2253, %v2293
  %v2295 = getelementptr i8, ptr %v2286, i64 %v782
  %v2296 = load double, ptr %v2295, align 8, !noalias !267
  %v2297 = fadd double %v2296, %v2294
  %v2298 = fmul double %v2250, %v2297
  %v2299 = getelementptr i8, ptr %v2286, i64 %v783
  %v2300 = load double, ptr %v2299, align 8, !noalias !267
  %v2301 = fadd double %v2300, %v2298
  %v2302 = fmul double %v2253, %v2301
  %v2303 = getelementptr i8, ptr %v2286, i64 %v784
  %v2304 = load double, ptr %v2303, align 8, !noalias !267
  %v2305 = fadd double %v2304, %v2302
  %v2306 = fmul double %v2250, %v2305
  %v2307 = getelementptr i8, ptr %v2286, i64 %v785
  %v2308 = load double, ptr %v2307, align 8, !noalias !267
  %v2309 = fadd double %v2308, %v2306
  %v2310 = fmul double %v2253, %v2309
  %v2311 = getelementptr i8, ptr %v2286, i64 %v786
  %v2312 = load double, ptr %v2311, align 8, !noalias !267
  %v2313 = fadd double %v2312, %v2310
  %v2314 = fmul double %v2250, %v2313
  %v2315 = load double, ptr %v2286, align 8, !noalias !267
  %v2277 = fadd double %v2315, %v2314
  br label %v2263

v1993:
  %v2316 = phi i64 [ %v2317, %v2318 ], [ 0, %v1992 ]
  %v2319 = phi i64 [ %v2320, %v2318 ], [ %v858, %v1992 ]
  %v2321 = icmp sgt i64 %v2319, 0
  br i1 %v2321, label %v2318, label %v2322

v2318:
  %v2320 = add nsw i64 %v2319, -1
  %v2317 = add i64 %v2316, 1
  %v2323 = getelementptr double, ptr %v825, i64 %v2316
  %v2324 = load double, ptr %v2323, align 8, !noalias !271
  %v2325 = getelementptr double, ptr %v823, i64 %v2316
  %v2326 = load double, ptr %v2325, align 8, !noalias !271
  %v2327 = fneg double %v2326
  %v2328 = fcmp olt double %v2324, %v2327
  br i1 %v2328, label %v2322, label %v1993

v2322:
  %v2007 = phi i64 [ %v2316, %v2318 ], [ -1, %v1993 ]
  %v2329 = icmp slt i64 %v2007, %v18
  br i1 %v2329, label %v2330, label %v2005

v2012:
  %v2023 = phi double [ %v1790, %v2005 ], [ %v2072, %v2069 ]
  %v2331 = phi i64 [ 0, %v2005 ], [ %v2074, %v2069 ]
  %v2074 = add nsw i64 %v2331, 1
  %v2071 = icmp eq i64 %v2331, 0
  %v2332 = load double, ptr %v133, align 8, !noalias !234
  %v2333 = load double, ptr %v772, align 8, !noalias !234
  %v2334 = fmul double %v2023, %v2333
  %v2335 = fadd double %v2332, %v2334
  store double %v2335, ptr %v774, align 8, !noalias !234
  br i1 %v859, label %v2053, label %v2015

v2015:
  %v2028 = fsub double 1.000000e+00, %v2023
  br label %v2013

v2056:
  %v2141 = load double, ptr %v2010, align 8, !noalias !223
  %v2336 = fcmp ogt double %v2141, 0.000000e+00
  br i1 %v2336, label %v2076, label %v2069

v2274:
  %v2337 = getelementptr i64, ptr %v110, i64 %v2272
  %v2338 = load i64, ptr %v2337, align 8, !noalias !264
  %v2339 = icmp eq i64 %v2338, 0
  br i1 %v2339, label %v2340, label %v2275

v2340:
  store i64 4, ptr %v2337, align 8, !noalias !264
  br label %v2275

v2275:
  store double 0.000000e+00, ptr %v874, align 8, !noalias !223
  br label %v1795

v2341:
  br i1 %v1805, label %v2330, label %v2342

v2342:
  call void @llvm.lifetime.start.p0(ptr nonnull %v300), !noalias !154
  call void @llvm.lifetime.start.p0(ptr nonnull %v301), !noalias !154
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %v300, i8 0, i64 32, i1 false), !noalias !275
  store ptr null, ptr %v301, align 8, !noalias !275
  br i1 %v305, label %v2343, label %v2344

v2345:
  %v2346 = phi i64 [ %v2347, %v2348 ], [ 0, %v2349 ]
  %v2347 = add nsw i64 %v2346, 1
  %v2350 = icmp ult i64 %v2346, 9
  br i1 %v2350, label %v2351, label %v2352

v2351:
  %v2353 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v2346
  %v2354 = load double, ptr %v2353, align 8
  %v2355 = load double, ptr %v133, align 8, !noalias !279
  %v2356 = load double, ptr %v772, align 8, !noalias !279
  %v2357 = fmul double %v2354, %v2356
  %v2358 = fadd double %v2355, %v2357
  store double %v2358, ptr %v774, align 8, !noalias !279
  br i1 %v776, label %v2359, label %v2348

v2359:
  %v2360 = fsub double 1.000000e+00, %v2354
  br label %v2361

v2361:
  %v2362 = phi i64 [ 0, %v2359 ], [ %v2363, %v2361 ]
  %v2364 = mul i64 %v2362, %v196
  %v2365 = getelementptr double, ptr %v193, i64 %v2364
  %v2366 = getelementptr i8, ptr %v2365, i64 %v780
  %v2367 = load double, ptr %v2366, align 8, !noalias !286
  %v2368 = fadd double %v2367, 0.000000e+00
  %v2369 = fmul double %v2354, %v2368
  %v2370 = getelementptr i8, ptr %v2365, i64 %v781
  %v2371 = load double, ptr %v2370, align 8, !noalias !286
  %v2372 = fadd double %v2371, %v2369
  %v2373 = fmul double %v2360, %v2372
  %v2374 = getelementptr i8, ptr %v2365, i64 %v782
  %v2375 = load double, ptr %v2374, align 8, !noalias !286
  %v2376 = fadd double %v2375, %v2373
  %v2377 = fmul double %v2354, %v2376
  %v2378 = getelementptr i8, ptr %v2365, i64 %v783
  %v2379 = load double, ptr %v2378, align 8, !noalias !286
  %v2380 = fadd double %v2379, %v2377
  %v2381 = fmul double %v2360, %v2380
  %v2382 = getelementptr i8, ptr %v2365, i64 %v784
  %v2383 = load double, ptr %v2382, align 8, !noalias !286
  %v2384 = fadd double %v2383, %v2381
  %v2385 = fmul double %v2354, %v2384
  %v2386 = getelementptr i8, ptr %v2365, i64 %v785
  %v2387 = load double, ptr %v2386, align 8, !noalias !286
  %v2388 = fadd double %v2387, %v2385
  %v2389 = fmul double %v2360, %v2388
  %v2390 = getelementptr i8, ptr %v2365, i64 %v786
  %v2391 = load double, ptr %v2390, align 8, !noalias !286
  %v2392 = fadd double %v2391, %v2389
  %v2393 = fmul double %v2354, %v2392
  %v2363 = add nsw i64 %v2362, 1
  %v2394 = load double, ptr %v2365, align 8, !noalias !286
  %v2395 = fadd double %v2394, %v2393
  %v2396 = getelementptr double, ptr %v777, i64 %v2364
  store double %v2395, ptr %v2396, align 8, !noalias !279
  %v2397 = icmp eq i64 %v10, %v2363
  br i1 %v2397, label %v2348, label %v2361

v2348:
  %v2398 = icmp eq i64 %v2346, 8
  %v2399 = select i1 %v2398, i64 17, i64 16
  %v2400 = mul i64 %v2346, %v778
  %v2401 = load i64, ptr %v779, align 8, !noalias !290
  %v2402 = mul nsw i64 %v2399, %v10
  %v2403 = getelementptr double, ptr %v158, i64 %v2402
  %v2404 = getelementptr double, ptr %v186, i64 %v2400
  %v2405 = inttoptr i64 %v2401 to ptr
  tail call void %v2405(ptr nonnull %v774, ptr %v2403, ptr %v165, ptr %v172, ptr %v179, ptr %v2404), !noalias !290
  %v2406 = icmp eq i64 %v2347, 9
  br i1 %v2406, label %v2352, label %v2345

v2352:
  %v2407 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v2345 ], [ %v2408, %v2348 ]
  %v2409 = phi i32 [ 1, %v2345 ], [ 0, %v2348 ]
  br i1 %v2350, label %v2410, label %v2411, !prof !131

v2412:
  %v2413 = load double, ptr %v848, align 8, !noalias !275
  %v2414 = fcmp ogt double %v2413, 5.000000e-01
  br i1 %v2414, label %v2415, label %v2416

v2415:
  %v2417 = load i64, ptr %v6, align 8, !noalias !293
  %v2418 = inttoptr i64 %v2417 to ptr
  tail call void %v2418(ptr nonnull %v806, ptr %v853, ptr %v165, ptr %v172, ptr %v179, ptr %v855), !noalias !293
  %v2419 = load double, ptr %v806, align 8, !noalias !275
  store double %v2419, ptr %v808, align 8, !noalias !275
  br label %v2420

v2421:
  %v2422 = sub nsw i64 45, %v2423
  br label %v2424

v2424:
  %v2425 = phi double [ %v2426, %v2424 ], [ 1.000000e+00, %v2421 ]
  %v2427 = phi double [ %v2428, %v2424 ], [ 2.000000e+00, %v2421 ]
  %v2429 = phi i64 [ %v2430, %v2424 ], [ %v2422, %v2421 ]
  %v2431 = and i64 %v2429, 1
  %v2432 = icmp eq i64 %v2431, 0
  %v2433 = fmul double %v2425, %v2427
  %v2426 = select i1 %v2432, double %v2425, double %v2433
  %v2430 = lshr i64 %v2429, 1
  %v2428 = fmul double %v2427, %v2427
  %v2434 = icmp eq i64 %v2430, 0
  br i1 %v2434, label %v2435, label %v2424

v2436:
  %v2437 = fcmp olt double %v2438, 0.000000e+00
  %v2439 = select i1 %v2437, double 0.000000e+00, double %v2438
  %v2440 = fmul double %v2441, %v2439
  %v2442 = fsub double %v2443, %v2440
  br label %v2444

v2435:
  %v2445 = fadd double %v2446, %v2447
  %v2443 = fmul double %v2445, 5.000000e-01
  %v2448 = fmul double %v2426, 1.000000e-13
  %v2449 = fsub double %v2448, %v2450
  %v2438 = fmul double %v2449, 5.000000e-01
  %v2451 = fmul double %v2452, %v2447
  %v2453 = fmul double %v2454, %v2446
  %v2455 = fsub double %v2451, %v2453
  %v2456 = fsub double %v2452, %v2454
  %v2457 = fdiv double %v2455, %v2456
  %v2458 = fcmp olt double %v2447, %v2457
  %v2459 = fcmp olt double %v2457, %v2446
  %v2460 = and i1 %v2458, %v2459
  %v2461 = select i1 %v2460, double %v2457, double %v2443
  %v2462 = fsub double %v2443, %v2461
  %v2441 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v2462)
  %v2463 = fmul double %v2450, %v2450
  %v2464 = tail call double @llvm.fabs.f64(double %v2462)
  %v2465 = fcmp olt double %v2464, %v2463
  %v2466 = select i1 %v2465, double %v2464, double %v2463
  %v2467 = fmul double %v2441, %v2466
  %v2468 = fadd double %v2461, %v2467
  %v2469 = fsub double %v2468, %v2443
  %v2470 = tail call double @llvm.fabs.f64(double %v2469)
  %v2471 = fcmp ugt double %v2470, %v2438
  br i1 %v2471, label %v2436, label %v2444

v2472:
  br label %v2473

v2473:
  %v2474 = phi double [ %v2475, %v2472 ], [ %v2447, %v2476 ]
  %v2477 = phi double [ %v2478, %v2472 ], [ %v2454, %v2476 ]
  %v2479 = phi double [ %v2452, %v2472 ], [ %v2478, %v2476 ]
  %v2480 = phi double [ %v2446, %v2472 ], [ %v2475, %v2476 ]
  %v2481 = icmp eq i64 %v2482, 45
  br i1 %v2481, label %v2483, label %v2484

v2484:
  %v2452 = phi double [ %v2479, %v2473 ], [ %v2485, %v2486 ]
  %v2454 = phi double [ %v2477, %v2473 ], [ %v2487, %v2486 ]
  %v2446 = phi double [ %v2480, %v2473 ], [ %v2488, %v2486 ]
  %v2447 = phi double [ %v2474, %v2473 ], [ %v2489, %v2486 ]
  %v2423 = phi i64 [ %v2482, %v2473 ], [ 0, %v2486 ]
  %v2482 = add nsw i64 %v2423, 1
  %v2450 = fsub double %v2446, %v2447
  %v2490 = fcmp ugt double %v2450, 1.000000e-13
  br i1 %v2490, label %v2421, label %v2483

v2444:
  %v2475 = phi double [ %v2468, %v2435 ], [ %v2442, %v2436 ]
  %v2491 = load double, ptr %v133, align 8, !noalias !296
  %v2492 = load double, ptr %v772, align 8, !noalias !296
  %v2493 = fmul double %v2475, %v2492
  %v2494 = fadd double %v2491, %v2493
  store double %v2494, ptr %v774, align 8, !noalias !296
  br i1 %v776, label %v2495, label %v2496

v2495:
  %v2497 = fsub double 1.000000e+00, %v2475
  br label %v2498

v2498:
  %v2499 = phi i64 [ 0, %v2495 ], [ %v2500, %v2498 ]
  %v2501 = mul i64 %v2499, %v196
  %v2502 = getelementptr double, ptr %v193, i64 %v2501
  %v2503 = getelementptr i8, ptr %v2502, i64 %v780
  %v2504 = load double, ptr %v2503, align 8, !noalias !305
  %v2505 = fadd double %v2504, 0.000000e+00
  %v2506 = fmul double %v2475, %v2505
  %v2507 = getelementptr i8, ptr %v2502, i64 %v781
  %v2508 = load double, ptr %v2507, align 8, !noalias !305
  %v2509 = fadd double %v2508, %v2506
  %v2510 = fmul double %v2497, %v2509
  %v2511 = getelementptr i8, ptr %v2502, i64 %v782
  %v2512 = load double, ptr %v2511, align 8, !noalias !305
  %v2513 = fadd double %v2512, %v2510
  %v2514 = fmul double %v2475, %v2513
  %v2515 = getelementptr i8, ptr %v2502, i64 %v783
  %v2516 = load double, ptr %v2515, align 8, !noalias !305
  %v2517 = fadd double %v2516, %v2514
  %v2518 = fmul double %v2497, %v2517
  %v2519 = getelementptr i8, ptr %v2502, i64 %v784
  %v2520 = load double, ptr %v2519, align 8, !noalias !305
  %v2521 = fadd double %v2520, %v2518
  %v2522 = fmul double %v2475, %v2521
  %v2523 = getelementptr i8, ptr %v2502, i64 %v785
  %v2524 = load double, ptr %v2523, align 8, !noalias !305
  %v2525 = fadd double %v2524, %v2522
  %v2526 = fmul double %v2497, %v2525
  %v2527 = getelementptr i8, ptr %v2502, i64 %v786
  %v2528 = load double, ptr %v2527, align 8, !noalias !305
  %v2529 = fadd double %v2528, %v2526
  %v2530 = fmul double %v2475, %v2529
  %v2500 = add nsw i64 %v2499, 1
  %v2531 = load double, ptr %v2502, align 8, !noalias !305
  %v2532 = fadd double %v2531, %v2530
  %v2533 = getelementptr double, ptr %v777, i64 %v2501
  store double %v2532, ptr %v2533, align 8, !noalias !296
  %v2534 = icmp eq i64 %v10, %v2500
  br i1 %v2534, label %v2496, label %v2498

v2496:
  %v2535 = load i64, ptr %v779, align 8, !noalias !309
  %v2536 = inttoptr i64 %v2535 to ptr
  tail call void %v2536(ptr nonnull %v774, ptr %v811, ptr %v165, ptr %v172, ptr %v179, ptr %v813), !noalias !309
  br i1 %v816, label %v2537, label %v2538

v2537:
  %v2539 = phi i64 [ %v2540, %v2537 ], [ %v815, %v2496 ]
  %v2541 = phi i64 [ %v2542, %v2537 ], [ %v18, %v2496 ]
  %v2540 = add nsw i64 %v2539, -1
  %v2542 = add i64 %v2541, 1
  %v2543 = icmp slt i64 %v2541, 0
  %v2544 = select i1 %v2543, i64 %v207, i64 0
  %v2545 = add i64 %v2544, %v2541
  %v2546 = getelementptr double, ptr %v820, i64 %v2545
  %v2547 = load double, ptr %v2546, align 8, !noalias !312
  %v2548 = getelementptr double, ptr %v823, i64 %v2545
  store double %v2547, ptr %v2548, align 8, !noalias !312
  %v2549 = icmp sgt i64 %v2539, 1
  br i1 %v2549, label %v2537, label %v2538

v2538:
  br i1 %v824, label %v2476, label %v2550

v2550:
  %v2551 = phi double [ %v2552, %v2550 ], [ 0x7FF0000000000000, %v2538 ]
  %v2553 = phi i64 [ %v2554, %v2550 ], [ 0, %v2538 ]
  %v2554 = add nsw i64 %v2553, 1
  %v2555 = getelementptr double, ptr %v825, i64 %v2553
  %v2556 = load double, ptr %v2555, align 8, !noalias !313
  %v2557 = getelementptr double, ptr %v823, i64 %v2553
  %v2558 = load double, ptr %v2557, align 8, !noalias !313
  %v2559 = fadd double %v2556, %v2558
  %v2560 = fcmp olt double %v2559, %v2551
  %v2552 = select i1 %v2560, double %v2559, double %v2551
  %v2561 = icmp eq i64 %v207, %v2554
  br i1 %v2561, label %v2476, label %v2550

v2476:
  %v2478 = phi double [ 0x7FF0000000000000, %v2538 ], [ %v2552, %v2550 ]
  %v2562 = fcmp olt double %v2478, 0.000000e+00
  br i1 %v2562, label %v2473, label %v2472

v2416:
  br i1 %v849, label %v2563, label %v2564

v2563:
  %v2565 = load i64, ptr %v839, align 8, !noalias !317
  %v2566 = inttoptr i64 %v2565 to ptr
  tail call void %v2566(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !317
  br label %v2420

v2564:
  %v2567 = phi i64 [ %v2568, %v2564 ], [ 0, %v2416 ]
  %v2568 = add nsw i64 %v2567, 1
  %v2569 = add nsw i64 %v2567, %v17
  %v2570 = icmp slt i64 %v2569, 0
  %v2571 = select i1 %v2570, i64 %v166, i64 0
  %v2572 = getelementptr double, ptr %v165, i64 %v2569
  %v2573 = getelementptr double, ptr %v2572, i64 %v2571
  %v2574 = load double, ptr %v2573, align 8, !noalias !323
  %v2575 = getelementptr double, ptr %v851, i64 %v2567
  %v2576 = load double, ptr %v2575, align 8, !noalias !323
  store double %v2576, ptr %v2573, align 8, !noalias !323
  store double %v2574, ptr %v2575, align 8, !noalias !323
  %v2577 = icmp eq i64 %v18, %v2568
  br i1 %v2577, label %v2563, label %v2564

v2343:
  %v2578 = phi i64 [ %v2579, %v2343 ], [ 0, %v2342 ]
  %v2579 = add nsw i64 %v2578, 1
  %v2580 = add nsw i64 %v2578, %v17
  %v2581 = icmp slt i64 %v2580, 0
  %v2582 = select i1 %v2581, i64 %v166, i64 0
  %v2583 = getelementptr double, ptr %v165, i64 %v2580
  %v2584 = getelementptr double, ptr %v2583, i64 %v2582
  %v2585 = load double, ptr %v2584, align 8, !noalias !275
  %v2586 = getelementptr double, ptr %v830, i64 %v2578
  store double %v2585, ptr %v2586, align 8, !noalias !275
  %v2587 = icmp eq i64 %v18, %v2579
  br i1 %v2587, label %v2344, label %v2343

v2344:
  br label %v2588

v2588:
  %v2589 = phi double [ %v2590, %v2483 ], [ %v1947, %v2344 ]
  %v2408 = phi ptr [ %v2407, %v2483 ], [ null, %v2344 ]
  %v2591 = phi ptr [ %v2592, %v2483 ], [ null, %v2344 ]
  %v2593 = phi i64 [ %v2594, %v2483 ], [ 32, %v2344 ]
  %v2594 = add nsw i64 %v2593, -1
  %v2595 = load double, ptr %v133, align 8, !noalias !324
  %v2596 = load double, ptr %v772, align 8, !noalias !324
  %v2597 = fmul double %v2589, %v2596
  %v2598 = fadd double %v2595, %v2597
  store double %v2598, ptr %v774, align 8, !noalias !324
  br i1 %v776, label %v2599, label %v2600

v2599:
  %v2601 = fsub double 1.000000e+00, %v2589
  br label %v2602

v2602:
  %v2603 = phi i64 [ 0, %v2599 ], [ %v2604, %v2602 ]
  %v2605 = mul i64 %v2603, %v196
  %v2606 = getelementptr double, ptr %v193, i64 %v2605
  %v2607 = getelementptr i8, ptr %v2606, i64 %v780
  %v2608 = load double, ptr %v2607, align 8, !noalias !334
  %v2609 = fadd double %v2608, 0.000000e+00
  %v2610 = fmul double %v2589, %v2609
  %v2611 = getelementptr i8, ptr %v2606, i64 %v781
  %v2612 = load double, ptr %v2611, align 8, !noalias !334
  %v2613 = fadd double %v2612, %v2610
  %v2614 = fmul double %v2601, %v2613
  %v2615 = getelementptr i8, ptr %v2606, i64 %v782
  %v2616 = load double, ptr %v2615, align 8, !noalias !334
  %v2617 = fadd double %v2616, %v2614
  %v2618 = fmul double %v2589, %v2617
  %v2619 = getelementptr i8, ptr %v2606, i64 %v783
  %v2620 = load double, ptr %v2619, align 8, !noalias !334
  %v2621 = fadd double %v2620, %v2618
  %v2622 = fmul double %v2601, %v2621
  %v2623 = getelementptr i8, ptr %v2606, i64 %v784
  %v2624 = load double, ptr %v2623, align 8, !noalias !334
  %v2625 = fadd double %v2624, %v2622
  %v2626 = fmul double %v2589, %v2625
  %v2627 = getelementptr i8, ptr %v2606, i64 %v785
  %v2628 = load double, ptr %v2627, align 8, !noalias !334
  %v2629 = fadd double %v2628, %v2626
  %v2630 = fmul double %v2601, %v2629
  %v2631 = getelementptr i8, ptr %v2606, i64 %v786
  %v2632 = load double, ptr %v2631, align 8, !noalias !334
  %v2633 = fadd double %v2632, %v2630
  %v2634 = fmul double %v2589, %v2633
  %v2604 = add nsw i64 %v2603, 1
  %v2635 = load double, ptr %v2606, align 8, !noalias !334
  %v2636 = fadd double %v2635, %v2634
  %v2637 = getelementptr double, ptr %v833, i64 %v2605
  store double %v2636, ptr %v2637, align 8, !noalias !324
  %v2638 = icmp eq i64 %v10, %v2604
  br i1 %v2638, label %v2600, label %v2602

v2600:
  %v2639 = load i64, ptr %v779, align 8, !noalias !338
  %v2640 = inttoptr i64 %v2639 to ptr
  tail call void %v2640(ptr nonnull %v774, ptr %v811, ptr %v165, ptr %v172, ptr %v179, ptr %v813), !noalias !338
  br i1 %v816, label %v2641, label %v2642

v2641:
  %v2643 = phi i64 [ %v2644, %v2641 ], [ %v814, %v2600 ]
  %v2645 = phi i64 [ %v2646, %v2641 ], [ %v18, %v2600 ]
  %v2644 = add nsw i64 %v2643, -1
  %v2646 = add i64 %v2645, 1
  %v2647 = icmp slt i64 %v2645, 0
  %v2648 = select i1 %v2647, i64 %v207, i64 0
  %v2649 = add i64 %v2648, %v2645
  %v2650 = getelementptr double, ptr %v820, i64 %v2649
  %v2651 = load double, ptr %v2650, align 8, !noalias !341
  %v2652 = getelementptr double, ptr %v823, i64 %v2649
  store double %v2651, ptr %v2652, align 8, !noalias !341
  %v2653 = icmp sgt i64 %v2643, 1
  br i1 %v2653, label %v2641, label %v2642

v2642:
  br label %v2654

v2655:
  br label %v2656

v2656:
  %v2657 = phi double [ %v2589, %v2654 ], [ 1.000000e+00, %v2658 ], [ 8.889000e-01, %v2659 ], [ 2.500000e-01, %v2660 ], [ 3.333000e-01, %v2661 ], [ 5.000000e-01, %v2662 ], [ 0x3FE50A3D70A3D70A, %v2663 ], [ 7.500000e-01, %v2664 ], [ 0x3FB48E8A71DE69AD, %v2655 ]
  %v2665 = fcmp ult double %v2657, %v2589
  br i1 %v2665, label %v2666, label %v2667

v2667:
  %v2668 = load double, ptr %v133, align 8, !noalias !342
  %v2669 = load double, ptr %v772, align 8, !noalias !342
  %v2670 = fmul double %v2657, %v2669
  %v2671 = fadd double %v2668, %v2670
  store double %v2671, ptr %v774, align 8, !noalias !342
  br i1 %v776, label %v2672, label %v2673

v2672:
  %v2674 = fsub double 1.000000e+00, %v2657
  br label %v2675

v2675:
  %v2676 = phi i64 [ 0, %v2672 ], [ %v2677, %v2675 ]
  %v2678 = mul i64 %v2676, %v196
  %v2679 = getelementptr double, ptr %v193, i64 %v2678
  %v2680 = getelementptr i8, ptr %v2679, i64 %v780
  %v2681 = load double, ptr %v2680, align 8, !noalias !346
  %v2682 = fadd double %v2681, 0.000000e+00
  %v2683 = fmul double %v2657, %v2682
  %v2684 = getelementptr i8, ptr %v2679, i64 %v781
  %v2685 = load double, ptr %v2684, align 8, !noalias !346
  %v2686 = fadd double %v2685, %v2683
  %v2687 = fmul double %v2674, %v2686
  %v2688 = getelementptr i8, ptr %v2679, i64 %v782
  %v2689 = load double, ptr %v2688, align 8, !noalias !346
  %v2690 = fadd double %v2689, %v2687
  %v2691 = fmul double %v2657, %v2690
  %v2692 = getelementptr i8, ptr %v2679, i64 %v783
  %v2693 = load double, ptr %v2692, align 8, !noalias !346
  %v2694 = fadd double %v2693, %v2691
  %v2695 = fmul double %v2674, %v2694
  %v2696 = getelementptr i8, ptr %v2679, i64 %v784
  %v2697 = load double, ptr %v2696, align 8, !noalias !346
  %v2698 = fadd double %v2697, %v2695
  %v2699 = fmul double %v2657, %v2698
  %v2700 = getelementptr i8, ptr %v2679, i64 %v785
  %v2701 = load double, ptr %v2700, align 8, !noalias !346
  %v2702 = fadd double %v2701, %v2699
  %v2703 = fmul double %v2674, %v2702
  %v2704 = getelementptr i8, ptr %v2679, i64 %v786
  %v2705 = load double, ptr %v2704, align 8, !noalias !346
  %v2706 = fadd double %v2705, %v2703
  %v2707 = fmul double %v2657, %v2706
  %v2677 = add nsw i64 %v2676, 1
  %v2708 = load double, ptr %v2679, align 8, !noalias !346
  %v2709 = fadd double %v2708, %v2707
  %v2710 = getelementptr double, ptr %v777, i64 %v2678
  store double %v2709, ptr %v2710, align 8, !noalias !342
  %v2711 = icmp eq i64 %v10, %v2677
  br i1 %v2711, label %v2673, label %v2675

v2712:
  %v2713 = load i64, ptr %v839, align 8, !noalias !350
  %v2714 = inttoptr i64 %v2713 to ptr
  tail call void %v2714(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !350
  br label %v2666

v2715:
  %v2716 = phi i64 [ %v2717, %v2715 ], [ 0, %v2718 ]
  %v2717 = add nsw i64 %v2716, 1
  %v2719 = add nsw i64 %v2716, %v17
  %v2720 = icmp slt i64 %v2719, 0
  %v2721 = select i1 %v2720, i64 %v166, i64 0
  %v2722 = getelementptr double, ptr %v165, i64 %v2719
  %v2723 = getelementptr double, ptr %v2722, i64 %v2721
  %v2724 = load double, ptr %v2723, align 8, !noalias !356
  %v2725 = getelementptr double, ptr %v822, i64 %v2716
  %v2726 = load double, ptr %v2725, align 8, !noalias !356
  store double %v2726, ptr %v2723, align 8, !noalias !356
  store double %v2724, ptr %v2725, align 8, !noalias !356
  %v2727 = icmp eq i64 %v18, %v2717
  br i1 %v2727, label %v2712, label %v2715

v2666:
  %v2728 = icmp ugt i64 %v2729, 1
  br i1 %v2728, label %v2654, label %v2730

v2730:
  br i1 %v305, label %v2731, label %v2732

v2732:
  %v2733 = load i64, ptr %v839, align 8, !noalias !357
  %v2734 = inttoptr i64 %v2733 to ptr
  tail call void %v2734(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !357
  br label %v2735

v2731:
  %v2736 = phi i64 [ %v2737, %v2731 ], [ 0, %v2730 ]
  %v2737 = add nsw i64 %v2736, 1
  %v2738 = add nsw i64 %v2736, %v17
  %v2739 = icmp slt i64 %v2738, 0
  %v2740 = select i1 %v2739, i64 %v166, i64 0
  %v2741 = getelementptr double, ptr %v165, i64 %v2738
  %v2742 = getelementptr double, ptr %v2741, i64 %v2740
  %v2743 = load double, ptr %v2742, align 8, !noalias !363
  %v2744 = getelementptr double, ptr %v822, i64 %v2736
  %v2745 = load double, ptr %v2744, align 8, !noalias !363
  store double %v2745, ptr %v2742, align 8, !noalias !363
  store double %v2743, ptr %v2744, align 8, !noalias !363
  %v2746 = icmp eq i64 %v2737, %v18
  br i1 %v2746, label %v2732, label %v2731

v2654:
  %v2729 = phi i64 [ %v2747, %v2666 ], [ 9, %v2642 ]
  %v2748 = phi i64 [ %v2749, %v2666 ], [ 8, %v2642 ]
  %v2747 = add nsw i64 %v2729, -1
  %v2749 = add nsw i64 %v2748, -1
  switch i64 %v2748, label %v2735 [
    i64 0, label %v2656
    i64 -1, label %v2658
    i64 8, label %v2658
    i64 1, label %v2655
    i64 -8, label %v2655
    i64 2, label %v2660
    i64 -7, label %v2660
    i64 3, label %v2661
    i64 -6, label %v2661
    i64 4, label %v2662
    i64 -5, label %v2662
    i64 5, label %v2663
    i64 -4, label %v2663
    i64 6, label %v2664
    i64 -3, label %v2664
    i64 7, label %v2659
    i64 -2, label %v2659
  ]

v2660:
  br label %v2656

v2661:
  br label %v2656

v2662:
  br label %v2656

v2663:
  br label %v2656

v2664:
  br label %v2656

v2659:
  br label %v2656

v2658:
  br label %v2656

v2673:
  %v2750 = load i64, ptr %v6, align 8, !noalias !364
  %v2751 = inttoptr i64 %v2750 to ptr
  tail call void %v2751(ptr nonnull %v774, ptr %v836, ptr %v165, ptr %v172, ptr %v179, ptr %v838), !noalias !364
  br i1 %v305, label %v2752, label %v2753

v2753:
  %v2754 = load i64, ptr %v839, align 8, !noalias !367
  %v2755 = inttoptr i64 %v2754 to ptr
  tail call void %v2755(ptr nonnull %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !367
  %v2756 = load i64, ptr %v6, align 8, !noalias !373
  %v2757 = inttoptr i64 %v2756 to ptr
  tail call void %v2757(ptr nonnull %v774, ptr %v836, ptr %v165, ptr %v172, ptr %v179, ptr %v841), !noalias !373
  %v2758 = load double, ptr %v23, align 8, !noalias !376
  %v2759 = load double, ptr %v842, align 8, !noalias !376
  br label %v2760

v2752:
  %v2761 = phi i64 [ %v2762, %v2752 ], [ 0, %v2673 ]
  %v2762 = add nsw i64 %v2761, 1
  %v2763 = add nsw i64 %v2761, %v17
  %v2764 = icmp slt i64 %v2763, 0
  %v2765 = select i1 %v2764, i64 %v166, i64 0
  %v2766 = getelementptr double, ptr %v165, i64 %v2763
  %v2767 = getelementptr double, ptr %v2766, i64 %v2765
  %v2768 = load double, ptr %v2767, align 8, !noalias !380
  %v2769 = getelementptr double, ptr %v822, i64 %v2761
  %v2770 = load double, ptr %v2769, align 8, !noalias !380
  store double %v2770, ptr %v2767, align 8, !noalias !380
  store double %v2768, ptr %v2769, align 8, !noalias !380
  %v2771 = icmp eq i64 %v18, %v2762
  br i1 %v2771, label %v2753, label %v2752

v2760:
  %v2772 = phi i64 [ 0, %v2753 ], [ %v2773, %v2774 ]
  %v2775 = icmp eq i64 %v2772, %v831
  br i1 %v2775, label %v2718, label %v2774

v2718:
  br i1 %v305, label %v2715, label %v2712

v2774:
  %v2773 = add i64 %v2772, 1
  %v2776 = mul i64 %v2772, %v196
  %v2777 = getelementptr double, ptr %v844, i64 %v2776
  %v2778 = load double, ptr %v2777, align 8, !noalias !376
  %v2779 = getelementptr double, ptr %v846, i64 %v2776
  %v2780 = load double, ptr %v2779, align 8, !noalias !376
  %v2781 = fsub double %v2778, %v2780
  %v2782 = tail call double @llvm.fabs.f64(double %v2781)
  %v2783 = getelementptr double, ptr %v193, i64 %v2776
  %v2784 = load double, ptr %v2783, align 8, !noalias !376
  %v2785 = tail call double @llvm.fabs.f64(double %v2784)
  %v2786 = fmul double %v2758, %v2785
  %v2787 = fadd double %v2759, %v2786
  %v2788 = load double, ptr %v772, align 8, !noalias !376
  %v2789 = fmul double %v2788, %v2782
  %v2790 = fmul double %v2787, 1.000000e-01
  %v2791 = fcmp ugt double %v2789, %v2790
  br i1 %v2791, label %v2735, label %v2760

v2735:
  %v2792 = phi i1 [ false, %v2774 ], [ true, %v2732 ], [ true, %v2654 ]
  %v2592 = phi ptr [ %v2591, %v2774 ], [ %v2591, %v2732 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.48, %v2654 ]
  %v2793 = phi i1 [ true, %v2774 ], [ true, %v2732 ], [ false, %v2654 ]
  %v2794 = phi i32 [ 0, %v2774 ], [ 0, %v2732 ], [ 1, %v2654 ]
  br i1 %v2793, label %v2349, label %v2411, !prof !131

v2349:
  br i1 %v2792, label %v2345, label %v2416

v2410:
  call void @llvm.memset.p0.i64(ptr noundef nonnull align 8 dereferenceable(32) %v300, i8 0, i64 32, i1 false), !noalias !275
  %v2795 = call fastcc i32 @_ZN5pages12event_checks13find_crossingB3v65B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr %v300, ptr %v301, i64 %v14, ptr nonnull readonly %v92, i64 %v93, ptr %v124, i64 %v125, i64 %v126, ptr nonnull %v133, i64 %v135, ptr %v142, i64 %v144, ptr %v204, i64 %v205, i64 %v206, i64 %v207, double %v2589)
  %v2796 = icmp eq i32 %v2795, 0
  br i1 %v2796, label %v2797, label %v2798, !prof !131

v2798:
  %v2799 = load ptr, ptr %v301, align 8, !noalias !275
  br label %v2420

v2797:
  %v2800 = load i64, ptr %v802, align 8, !noalias !275
  %v2801 = icmp slt i64 %v2800, 0
  br i1 %v2801, label %v2412, label %v2486

v2486:
  %v2489 = load double, ptr %v300, align 8, !noalias !275
  %v2488 = load double, ptr %v826, align 8, !noalias !275
  %v2487 = load double, ptr %v827, align 8, !noalias !275
  %v2485 = load double, ptr %v828, align 8, !noalias !275
  br label %v2484

v2483:
  %v2590 = phi double [ %v2480, %v2473 ], [ %v2446, %v2484 ]
  %v2802 = icmp ugt i64 %v2593, 1
  br i1 %v2802, label %v2588, label %v2416

v2411:
  %v2803 = phi ptr [ %v2407, %v2352 ], [ %v2592, %v2735 ]
  %v2804 = phi i32 [ %v2409, %v2352 ], [ %v2794, %v2735 ]
  %v2805 = icmp ne i32 %v2804, 0
  br label %v2420

v2420:
  %v2806 = phi i1 [ true, %v2415 ], [ false, %v2563 ], [ true, %v2798 ], [ %v2805, %v2411 ]
  %v2807 = phi ptr [ null, %v2415 ], [ null, %v2563 ], [ %v2799, %v2798 ], [ %v2803, %v2411 ]
  %v2808 = phi i1 [ false, %v2415 ], [ false, %v2563 ], [ true, %v2798 ], [ %v2805, %v2411 ]
  call void @llvm.lifetime.end.p0(ptr nonnull %v300), !noalias !154
  call void @llvm.lifetime.end.p0(ptr nonnull %v301), !noalias !154
  %v2809 = select i1 %v2808, ptr %v2807, ptr null, !prof !381
  %v2810 = xor i1 %v2808, true
  br i1 %v2806, label %v1795, label %v2811, !prof !382

v2811:
  %v2812 = load double, ptr %v857, align 8, !noalias !154
  %v2813 = fcmp olt double %v2812, 5.000000e-01
  br i1 %v2813, label %v1795, label %v2330

v2330:
  store double 1.000000e+00, ptr %v876, align 8, !noalias !154
  %v2814 = load double, ptr %v804, align 8, !noalias !383
  %v2815 = load double, ptr %v92, align 8, !noalias !383
  %v2816 = fsub double %v2814, %v2815
  %v2817 = fmul double %v2816, 1.000000e-13
  %v2818 = load double, ptr %v133, align 8, !noalias !383
  %v2819 = tail call double @llvm.fabs.f64(double %v2818)
  %v2820 = fmul double %v2819, 4.000000e-15
  %v2821 = fcmp ogt double %v2820, %v2817
  %v2822 = select i1 %v2821, double %v2820, double %v2817
  %v2823 = fdiv double %v2822, %v1797
  %v2824 = fcmp ogt double %v2823, %v1947
  %v2825 = select i1 %v2824, double %v2823, double %v1947
  %v2826 = fcmp ult double %v2825, 1.000000e+00
  br i1 %v2826, label %v2827, label %v1795

v2827:
  %v2828 = fsub double 1.000000e+00, %v2825
  br i1 %v739, label %v2829, label %v2830

v2829:
  %v2831 = load double, ptr %v878, align 8, !noalias !154
  %v2832 = fmul double %v2825, 4.000000e+00
  %v2833 = fmul double %v2832, %v2828
  %v2834 = fmul double %v2833, %v2831
  %v2835 = fmul double %v2833, %v2834
  %v2836 = fcmp olt double %v2835, 5.000000e-04
  br i1 %v2836, label %v2837, label %v2830

v2837:
  %v2838 = load double, ptr %v772, align 8, !noalias !387
  %v2839 = fmul double %v2825, %v2838
  %v2840 = fadd double %v2818, %v2839
  store double %v2840, ptr %v774, align 8, !noalias !387
  br i1 %v884, label %v2841, label %v2842

v2842:
  %v2843 = phi i64 [ %v2844, %v2842 ], [ 0, %v2837 ]
  %v2845 = mul i64 %v2843, %v196
  %v2846 = getelementptr double, ptr %v193, i64 %v2845
  %v2847 = getelementptr i8, ptr %v2846, i64 %v780
  %v2848 = load double, ptr %v2847, align 8, !noalias !394
  %v2849 = fadd double %v2848, 0.000000e+00
  %v2850 = fmul double %v2825, %v2849
  %v2851 = getelementptr i8, ptr %v2846, i64 %v781
  %v2852 = load double, ptr %v2851, align 8, !noalias !394
  %v2853 = fadd double %v2852, %v2850
  %v2854 = fmul double %v2828, %v2853
  %v2855 = getelementptr i8, ptr %v2846, i64 %v782
  %v2856 = load double, ptr %v2855, align 8, !noalias !394
  %v2857 = fadd double %v2856, %v2854
  %v2858 = fmul double %v2825, %v2857
  %v2859 = getelementptr i8, ptr %v2846, i64 %v783
  %v2860 = load double, ptr %v2859, align 8, !noalias !394
  %v2861 = fadd double %v2860, %v2858
  %v2862 = fmul double %v2828, %v2861
  %v2863 = getelementptr i8, ptr %v2846, i64 %v784
  %v2864 = load double, ptr %v2863, align 8, !noalias !394
  %v2865 = fadd double %v2864, %v2862
  %v2866 = fmul double %v2825, %v2865
  %v2867 = getelementptr i8, ptr %v2846, i64 %v785
  %v2868 = load double, ptr %v2867, align 8, !noalias !394
  %v2869 = fadd double %v2868, %v2866
  %v2870 = fmul double %v2828, %v2869
  %v2871 = getelementptr i8, ptr %v2846, i64 %v786
  %v2872 = load double, ptr %v2871, align 8, !noalias !394
  %v2873 = fadd double %v2872, %v2870
  %v2874 = fmul double %v2825, %v2873
  %v2844 = add nsw i64 %v2843, 1
  %v2875 = load double, ptr %v2846, align 8, !noalias !394
  %v2876 = fadd double %v2875, %v2874
  %v2877 = getelementptr double, ptr %v777, i64 %v2845
  store double %v2876, ptr %v2877, align 8, !noalias !387
  %v2878 = icmp eq i64 %v10, %v2844
  br i1 %v2878, label %v2879, label %v2842

v2841:
  %v2880 = load double, ptr %v774, align 8, !noalias !398
  store double %v2880, ptr %v806, align 8, !noalias !398
  br label %v2881

v2881:
  %v2882 = load i64, ptr %v6, align 8, !noalias !399
  %v2883 = inttoptr i64 %v2882 to ptr
  tail call void %v2883(ptr nonnull %v774, ptr %v889, ptr %v165, ptr %v172, ptr %v179, ptr %v891), !noalias !399
  %v2884 = load i64, ptr %v779, align 8, !noalias !402
  %v2885 = inttoptr i64 %v2884 to ptr
  tail call void %v2885(ptr nonnull %v774, ptr %v893, ptr %v165, ptr %v172, ptr %v179, ptr %v895), !noalias !402
  br label %v1795

v2879:
  %v2886 = load double, ptr %v774, align 8, !noalias !398
  store double %v2886, ptr %v806, align 8, !noalias !398
  br label %v2887

v2887:
  %v2888 = phi i64 [ 0, %v2879 ], [ %v2889, %v2887 ]
  %v2889 = add nsw i64 %v2888, 1
  %v2890 = mul i64 %v2888, %v196
  %v2891 = getelementptr double, ptr %v777, i64 %v2890
  %v2892 = load double, ptr %v2891, align 8, !noalias !398
  %v2893 = getelementptr double, ptr %v886, i64 %v2890
  store double %v2892, ptr %v2893, align 8, !noalias !398
  %v2894 = icmp eq i64 %v10, %v2889
  br i1 %v2894, label %v2881, label %v2887

v2830:
  %v2895 = fmul double %v2822, 2.000000e+00
  %v2896 = fcmp ogt double %v1797, %v2895
  br i1 %v2896, label %v2897, label %v1795

v2897:
  %v2898 = load double, ptr %v806, align 8, !noalias !154
  %v2899 = tail call double @llvm.fabs.f64(double %v2898)
  %v2900 = fmul double %v2899, 4.000000e-15
  %v2901 = fmul double %v1797, 0x3D719799812DEA11
  %v2902 = fcmp ogt double %v2900, %v2901
  %v2903 = select i1 %v2902, double %v2900, double %v2901
  %v2904 = fsub double 1.000000e+00, %v2905
  %v2906 = fmul double %v1797, %v2904
  %v2907 = fcmp ogt double %v2906, %v2903
  br i1 %v2907, label %v2908, label %v1795

v2908:
  %v2909 = fmul double %v1797, %v2825
  store double 0.000000e+00, ptr %v880, align 8, !noalias !405
  store double 0.000000e+00, ptr %v882, align 8, !noalias !405
  store double %v2909, ptr %v883, align 8, !noalias !405
  %v2910 = load i64, ptr %v142, align 8, !noalias !405
  %v2911 = icmp slt i64 %v2910, 0
  %v2912 = select i1 %v2911, i64 %v125, i64 0
  %v2913 = add i64 %v2912, %v2910
  %v2914 = mul i64 %v2913, %v126
  %v2915 = getelementptr i64, ptr %v124, i64 %v2914
  %v2916 = load i64, ptr %v2915, align 8, !noalias !405
  %v2917 = add nsw i64 %v2916, -1
  store i64 %v2917, ptr %v2915, align 8, !noalias !405
  %v2918 = load i64, ptr %v142, align 8, !noalias !405
  %v2919 = icmp slt i64 %v2918, 0
  %v2920 = select i1 %v2919, i64 %v125, i64 0
  %v2921 = add i64 %v2920, %v2918
  %v2922 = mul i64 %v2921, %v126
  %v2923 = getelementptr i64, ptr %v124, i64 %v2922
  %v2924 = getelementptr i8, ptr %v2923, i64 24
  %v2925 = load i64, ptr %v2924, align 8, !noalias !405
  %v2926 = add nsw i64 %v2925, 1
  store i64 %v2926, ptr %v2924, align 8, !noalias !405
  br label %v1795

v1794:
  %v2927 = load i64, ptr %v802, align 8, !noalias !154
  %v2928 = icmp slt i64 %v2927, 0
  br i1 %v2928, label %v1795, label %v1796

v1869:
  %v2905 = phi double [ %v1860, %v1859 ], [ %v1833, %v1806 ]
  %v1947 = phi double [ %v1866, %v1859 ], [ %v1832, %v1806 ]
  br i1 %v304, label %v1943, label %v2341

v1795:
  %v2929 = phi ptr [ null, %v2897 ], [ null, %v2881 ], [ null, %v2908 ], [ null, %v2830 ], [ null, %v2330 ], [ null, %v2811 ], [ null, %v2275 ], [ null, %v1794 ], [ %v1791, %v1698 ], [ %v2809, %v2420 ]
  %v2930 = phi i1 [ true, %v2897 ], [ true, %v2881 ], [ true, %v2908 ], [ true, %v2830 ], [ true, %v2330 ], [ true, %v2811 ], [ true, %v2275 ], [ true, %v1794 ], [ false, %v1698 ], [ %v2810, %v2420 ]
  br i1 %v2930, label %v1633, label %v1546, !prof !131

v1633:
  %v2931 = select i1 %v1453, i1 true, i1 %v702
  %v2932 = select i1 %v2931, i64 0, i64 %v12
  br label %v1546

v2933:
  %v2934 = phi i64 [ 0, %v1539 ], [ %v2935, %v2936 ]
  %v2937 = phi i64 [ %v731, %v1539 ], [ %v2938, %v2936 ]
  %v2939 = icmp sgt i64 %v2937, 0
  br i1 %v2939, label %v2936, label %v1540

v1539:
  %v2940 = load double, ptr %v730, align 8, !noalias !408
  store double %v2940, ptr %v716, align 8, !noalias !408
  br label %v2933

v2936:
  %v2938 = add nsw i64 %v2937, -1
  %v2935 = add i64 %v2934, 1
  %v2941 = getelementptr double, ptr %v733, i64 %v2934
  %v2942 = icmp slt i64 %v2934, 0
  %v2943 = select i1 %v2942, i64 %v207, i64 0
  %v2944 = getelementptr double, ptr %v2941, i64 %v2943
  %v2945 = load double, ptr %v2944, align 8, !noalias !408
  %v2946 = fcmp olt double %v2945, 0x7FF0000000000000
  %v2947 = select i1 %v2946, double %v2945, double 0x7FF0000000000000
  %v2948 = fcmp ogt double %v2945, 0xFFF0000000000000
  %v2949 = select i1 %v2948, double %v2945, double 0xFFF0000000000000
  %v2950 = getelementptr double, ptr %v2944, i64 %v732
  %v2951 = load double, ptr %v2950, align 8, !noalias !408
  %v2952 = fcmp olt double %v2951, %v2947
  %v2953 = select i1 %v2952, double %v2951, double %v2947
  %v2954 = fcmp ogt double %v2951, %v2949
  %v2955 = select i1 %v2954, double %v2951, double %v2949
  %v2956 = getelementptr i8, ptr %v2944, i64 %v1094
  %v2957 = load double, ptr %v2956, align 8, !noalias !408
  %v2958 = fcmp olt double %v2957, %v2953
  %v2959 = select i1 %v2958, double %v2957, double %v2953
  %v2960 = fcmp ogt double %v2957, %v2955
  %v2961 = select i1 %v2960, double %v2957, double %v2955
  %v2962 = getelementptr i8, ptr %v2944, i64 %v1095
  %v2963 = load double, ptr %v2962, align 8, !noalias !408
  %v2964 = fcmp olt double %v2963, %v2959
  %v2965 = select i1 %v2964, double %v2963, double %v2959
  %v2966 = fcmp ogt double %v2963, %v2961
  %v2967 = select i1 %v2966, double %v2963, double %v2961
  %v2968 = getelementptr i8, ptr %v2944, i64 %v1096
  %v2969 = load double, ptr %v2968, align 8, !noalias !408
  %v2970 = fcmp olt double %v2969, %v2965
  %v2971 = select i1 %v2970, double %v2969, double %v2965
  %v2972 = fcmp ogt double %v2969, %v2967
  %v2973 = select i1 %v2972, double %v2969, double %v2967
  %v2974 = getelementptr i8, ptr %v2944, i64 %v1097
  %v2975 = load double, ptr %v2974, align 8, !noalias !408
  %v2976 = fcmp olt double %v2975, %v2971
  %v2977 = select i1 %v2976, double %v2975, double %v2971
  %v2978 = fcmp ogt double %v2975, %v2973
  %v2979 = select i1 %v2978, double %v2975, double %v2973
  %v2980 = getelementptr i8, ptr %v2944, i64 %v1098
  %v2981 = load double, ptr %v2980, align 8, !noalias !408
  %v2982 = fcmp olt double %v2981, %v2977
  %v2983 = select i1 %v2982, double %v2981, double %v2977
  %v2984 = fcmp ogt double %v2981, %v2979
  %v2985 = select i1 %v2984, double %v2981, double %v2979
  %v2986 = getelementptr i8, ptr %v2944, i64 %v1099
  %v2987 = load double, ptr %v2986, align 8, !noalias !408
  %v2988 = fcmp olt double %v2987, %v2983
  %v2989 = select i1 %v2988, double %v2987, double %v2983
  %v2990 = fcmp ogt double %v2987, %v2985
  %v2991 = select i1 %v2990, double %v2987, double %v2985
  %v2992 = getelementptr i8, ptr %v2944, i64 %v1100
  %v2993 = load double, ptr %v2992, align 8, !noalias !408
  %v2994 = fcmp olt double %v2993, %v2989
  %v2995 = select i1 %v2994, double %v2993, double %v2989
  %v2996 = fcmp ogt double %v2993, %v2991
  %v2997 = select i1 %v2996, double %v2993, double %v2991
  %v2998 = fsub double %v2997, %v2995
  %v2999 = fmul double %v2998, 2.500000e-01
  %v3000 = icmp slt i64 %v2934, 0
  %v3001 = select i1 %v3000, i64 %v207, i64 0
  %v3002 = add i64 %v3001, %v2934
  %v3003 = getelementptr double, ptr %v735, i64 %v3002
  %v3004 = getelementptr double, ptr %v736, i64 %v3002
  %v3005 = getelementptr double, ptr %v3003, i64 %v734
  %v3006 = load double, ptr %v3005, align 8, !noalias !409
  %v3007 = load double, ptr %v3004, align 8, !noalias !409
  %v3008 = fmul double %v3007, 0x3FDDF27AAAADCB3A
  %v3009 = fsub double %v3006, %v3008
  %v3010 = getelementptr i8, ptr %v3004, i64 %v1101
  %v3011 = load double, ptr %v3010, align 8, !noalias !409
  %v3012 = fmul double %v3011, 0x3FEC575F1EBC4F2F
  %v3013 = fsub double %v3009, %v3012
  %v3014 = getelementptr i8, ptr %v3004, i64 %v1102
  %v3015 = load double, ptr %v3014, align 8, !noalias !409
  %v3016 = fmul double %v3015, 0xBFE1306AA3D795F4
  %v3017 = fsub double %v3013, %v3016
  %v3018 = getelementptr i8, ptr %v3004, i64 %v1103
  %v3019 = load double, ptr %v3018, align 8, !noalias !409
  %v3020 = fmul double %v3019, 0x3FCCB9F574BDCC3A
  %v3021 = fsub double %v3017, %v3020
  %v3022 = getelementptr i8, ptr %v3004, i64 %v1104
  %v3023 = load double, ptr %v3022, align 8, !noalias !409
  %v3024 = fmul double %v3023, 0xBFA4EAF2D6B11E79
  %v3025 = fsub double %v3021, %v3024
  %v3026 = tail call double @llvm.fabs.f64(double %v3025)
  %v3027 = fcmp ogt double %v3026, 0.000000e+00
  %v3028 = select i1 %v3027, double %v3026, double 0.000000e+00
  %v3029 = getelementptr i8, ptr %v3003, i64 %v1105
  %v3030 = load double, ptr %v3029, align 8, !noalias !409
  %v3031 = load double, ptr %v3004, align 8, !noalias !409
  %v3032 = fmul double %v3031, 0xBFA5118805F8B876
  %v3033 = fsub double %v3030, %v3032
  %v3034 = getelementptr i8, ptr %v3004, i64 %v1106
  %v3035 = load double, ptr %v3034, align 8, !noalias !409
  %v3036 = fmul double %v3035, 0x3FE51326698BC5BD
  %v3037 = fsub double %v3033, %v3036
  %v3038 = getelementptr i8, ptr %v3004, i64 %v1107
  %v3039 = load double, ptr %v3038, align 8, !noalias !409
  %v3040 = fmul double %v3039, 0x3FDF97DED30D4572
  %v3041 = fsub double %v3037, %v3040
  %v3042 = getelementptr i8, ptr %v3004, i64 %v1108
  %v3043 = load double, ptr %v3042, align 8, !noalias !409
  %v3044 = fmul double %v3043, 0xBFC0DA0C684D1D67
  %v3045 = fsub double %v3041, %v3044
  %v3046 = getelementptr i8, ptr %v3004, i64 %v1109
  %v3047 = load double, ptr %v3046, align 8, !noalias !409
  %v3048 = fmul double %v3047, 0x3F9510B8EC0D4D92
  %v3049 = fsub double %v3045, %v3048
  %v3050 = tail call double @llvm.fabs.f64(double %v3049)
  %v3051 = fcmp ogt double %v3050, %v3028
  %v3052 = select i1 %v3051, double %v3050, double %v3028
  %v3053 = getelementptr i8, ptr %v3003, i64 %v1110
  %v3054 = load double, ptr %v3053, align 8, !noalias !409
  %v3055 = load double, ptr %v3004, align 8, !noalias !409
  %v3056 = fmul double %v3055, 0x3F9635A30F8F142F
  %v3057 = fsub double %v3054, %v3056
  %v3058 = getelementptr i8, ptr %v3004, i64 %v1111
  %v3059 = load double, ptr %v3058, align 8, !noalias !409
  %v3060 = fmul double %v3059, 0xBFC1EAE0FF33D241
  %v3061 = fsub double %v3057, %v3060
  %v3062 = getelementptr i8, ptr %v3004, i64 %v1112
  %v3063 = load double, ptr %v3062, align 8, !noalias !409
  %v3064 = fmul double %v3063, 0x3FE1625D59218460
  %v3065 = fsub double %v3061, %v3064
  %v3066 = getelementptr i8, ptr %v3004, i64 %v1113
  %v3067 = load double, ptr %v3066, align 8, !noalias !409
  %v3068 = fmul double %v3067, 0x3FE3BBC3E8A29641
  %v3069 = fsub double %v3065, %v3068
  %v3070 = getelementptr i8, ptr %v3004, i64 %v1114
  %v3071 = load double, ptr %v3070, align 8, !noalias !409
  %v3072 = fmul double %v3071, 0xBFA55161A739EB34
  %v3073 = fsub double %v3069, %v3072
  %v3074 = tail call double @llvm.fabs.f64(double %v3073)
  %v3075 = fcmp ogt double %v3074, %v3052
  %v3076 = select i1 %v3075, double %v3074, double %v3052
  %v3077 = getelementptr i8, ptr %v3003, i64 %v1115
  %v3078 = load double, ptr %v3077, align 8, !noalias !409
  %v3079 = load double, ptr %v3004, align 8, !noalias !409
  %v3080 = fmul double %v3079, 0xBFA4F0C0BB579409
  %v3081 = fsub double %v3078, %v3080
  %v3082 = getelementptr i8, ptr %v3004, i64 %v1116
  %v3083 = load double, ptr %v3082, align 8, !noalias !409
  %v3084 = fmul double %v3083, 0x3FCD2266FBC0D976
  %v3085 = fsub double %v3081, %v3084
  %v3086 = getelementptr i8, ptr %v3004, i64 %v1117
  %v3087 = load double, ptr %v3086, align 8, !noalias !409
  %v3088 = fmul double %v3087, 0xBFE1F2DB6FEE3151
  %v3089 = fsub double %v3085, %v3088
  %v3090 = getelementptr i8, ptr %v3004, i64 %v1118
  %v3091 = load double, ptr %v3090, align 8, !noalias !409
  %v3092 = fmul double %v3091, 0x3FF0C05015964CBE
  %v3093 = fsub double %v3089, %v3092
  %v3094 = getelementptr i8, ptr %v3004, i64 %v1119
  %v3095 = load double, ptr %v3094, align 8, !noalias !409
  %v3096 = fmul double %v3095, 0x3FD4F15B230DB570
  %v3097 = fsub double %v3093, %v3096
  %v3098 = tail call double @llvm.fabs.f64(double %v3097)
  %v3099 = fcmp ogt double %v3098, %v3076
  %v3100 = select i1 %v3099, double %v3098, double %v3076
  %v3101 = fmul double %v3100, 1.000000e+01
  %v3102 = fadd double %v2999, %v3101
  %v3103 = icmp slt i64 %v2934, 0
  %v3104 = select i1 %v3103, i64 %v207, i64 0
  %v3105 = getelementptr double, ptr %v738, i64 %v2934
  %v3106 = getelementptr double, ptr %v3105, i64 %v3104
  %v3107 = load double, ptr %v3106, align 8, !noalias !408
  %v3108 = fcmp ogt double %v3102, %v3107
  %v3109 = fneg double %v3107
  %v3110 = select i1 %v3108, double %v3102, double %v3109
  %v3111 = fcmp olt double %v2995, %v3110
  br i1 %v3111, label %v1540, label %v2933

v1540:
  %v1542 = phi i1 [ false, %v1482 ], [ %v2939, %v2936 ], [ %v2939, %v2933 ]
  %v3112 = phi ptr [ %v1537, %v1482 ], [ null, %v2936 ], [ null, %v2933 ]
  %v3113 = phi i32 [ %v1538, %v1482 ], [ 0, %v2936 ], [ 0, %v2933 ]
  %v3114 = icmp eq i32 %v3113, 0
  br i1 %v3114, label %v1472, label %v1546, !prof !131

v1546:
  %v3115 = phi i64 [ 0, %v1472 ], [ %v2932, %v1633 ], [ 0, %v1540 ], [ 0, %v1795 ]
  %v3116 = phi i1 [ true, %v1472 ], [ true, %v1633 ], [ false, %v1540 ], [ false, %v1795 ]
  %v3117 = phi ptr [ undef, %v1472 ], [ undef, %v1633 ], [ %v3112, %v1540 ], [ %v2929, %v1795 ]
  %v3118 = phi i32 [ 0, %v1472 ], [ 0, %v1633 ], [ 1, %v1540 ], [ 1, %v1795 ]
  br i1 %v3116, label %v3119, label %v3120, !prof !131

v3121:
  %v3122 = getelementptr double, ptr %v898, i64 %v3123
  %v3124 = load double, ptr %v3122, align 8, !noalias !413
  %v3125 = fcmp olt double %v3124, 5.000000e-01
  br i1 %v3125, label %v3126, label %v3127

v3127:
  %v3128 = getelementptr i64, ptr %v110, i64 %v3129
  %v3130 = load i64, ptr %v3128, align 8, !noalias !413
  %v3131 = icmp eq i64 %v3130, 0
  br i1 %v3131, label %v3132, label %v3126

v3132:
  %v3133 = mul i64 %v3129, %v126
  %v3134 = getelementptr i64, ptr %v124, i64 %v3133
  %v3135 = getelementptr i8, ptr %v3134, i64 8
  %v3136 = load i64, ptr %v3135, align 8, !noalias !413
  %v3137 = add nsw i64 %v3136, %v3115
  store i64 %v3137, ptr %v3135, align 8, !noalias !413
  %v3138 = getelementptr double, ptr %v900, i64 %v3123
  %v3139 = load double, ptr %v3138, align 8, !noalias !413
  %v3140 = load i64, ptr %v3141, align 8, !noalias !416
  %v3142 = getelementptr i64, ptr %v902, i64 %v3123
  %v3143 = load i64, ptr %v3142, align 8, !noalias !416
  %v3144 = icmp slt i64 %v3143, %v93
  br i1 %v3144, label %v3145, label %v3146

v3145:
  %v3147 = icmp slt i64 %v3143, 0
  %v3148 = select i1 %v3147, i64 %v93, i64 0
  %v3149 = getelementptr double, ptr %v92, i64 %v3143
  %v3150 = getelementptr double, ptr %v3149, i64 %v3148
  %v3151 = load double, ptr %v3150, align 8, !noalias !416
  %v3152 = fcmp ugt double %v3151, %v3139
  br i1 %v3152, label %v3146, label %v3153

v3153:
  %v3154 = getelementptr double, ptr %v133, i64 %v3123
  %v3155 = getelementptr double, ptr %v904, i64 %v3123
  %v3156 = getelementptr double, ptr %v193, i64 %v3123
  %v3157 = getelementptr double, ptr %v908, i64 %v3123
  %v3158 = icmp slt i64 %v3140, 0
  %v3159 = select i1 %v3158, i64 %v100, i64 0
  %v3160 = add i64 %v3159, %v3140
  %v3161 = mul i64 %v909, %v3160
  %v3162 = getelementptr double, ptr %v99, i64 %v3161
  %v3163 = getelementptr double, ptr %v910, i64 %v3123
  br label %v3164

v3164:
  %v3165 = phi i64 [ %v3166, %v3167 ], [ %v3143, %v3153 ]
  %v3168 = icmp slt i64 %v3165, 0
  %v3169 = select i1 %v3168, i64 %v93, i64 0
  %v3170 = getelementptr double, ptr %v92, i64 %v3165
  %v3171 = getelementptr double, ptr %v3170, i64 %v3169
  %v3172 = load double, ptr %v3171, align 8, !noalias !416
  %v3173 = load double, ptr %v3154, align 8, !noalias !416
  %v3174 = fsub double %v3172, %v3173
  %v3175 = load double, ptr %v3155, align 8, !noalias !416
  %v3176 = fdiv double %v3174, %v3175
  br i1 %v906, label %v3177, label %v3178

v3178:
  %v3179 = fsub double 1.000000e+00, %v3176
  %v3180 = select i1 %v3168, i64 %v101, i64 0
  %v3181 = add i64 %v3180, %v3165
  %v3182 = mul i64 %v3181, %v102
  %v3183 = getelementptr double, ptr %v3162, i64 %v3182
  br label %v3184

v3185:
  %v3186 = getelementptr double, ptr %v3163, i64 %v3187
  %v3188 = load double, ptr %v3186, align 8, !noalias !416
  br label %v3189

v3177:
  store double 0x7FF0000000000000, ptr %v3157, align 8, !noalias !416
  %v3190 = icmp eq i64 %v3165, %v911
  br i1 %v3190, label %v3146, label %v3167

v3167:
  %v3166 = add i64 %v3165, 1
  %v3191 = icmp slt i64 %v3165, -1
  %v3192 = select i1 %v3191, i64 %v93, i64 0
  %v3193 = getelementptr double, ptr %v92, i64 %v3166
  %v3194 = getelementptr double, ptr %v3193, i64 %v3192
  %v3195 = load double, ptr %v3194, align 8, !noalias !416
  %v3196 = fcmp ugt double %v3195, %v3139
  br i1 %v3196, label %v3146, label %v3164

v3146:
  %v3197 = phi i64 [ %v3143, %v3145 ], [ %v3143, %v3132 ], [ %v93, %v3177 ], [ %v3166, %v3167 ]
  store i64 %v3197, ptr %v3142, align 8, !noalias !416
  br label %v3126

v3189:
  %v3198 = phi double [ %v3199, %v3200 ], [ %v3188, %v3185 ]
  %v3201 = getelementptr double, ptr %v3183, i64 %v3202
  store double %v3198, ptr %v3201, align 8, !noalias !416
  %v3203 = icmp eq i64 %v10, %v3204
  br i1 %v3203, label %v3177, label %v3184

v3184:
  %v3202 = phi i64 [ 0, %v3178 ], [ %v3204, %v3189 ]
  %v3204 = add nsw i64 %v3202, 1
  %v3205 = load double, ptr %v3171, align 8, !noalias !416
  %v3206 = load double, ptr %v3138, align 8, !noalias !416
  %v3207 = fcmp oeq double %v3205, %v3206
  %v3187 = mul i64 %v3202, %v196
  br i1 %v3207, label %v3185, label %v3200

v3200:
  %v3208 = getelementptr double, ptr %v3156, i64 %v3187
  %v3209 = getelementptr i8, ptr %v3208, i64 %v912
  %v3210 = load double, ptr %v3209, align 8, !noalias !420
  %v3211 = fadd double %v3210, 0.000000e+00
  %v3212 = fmul double %v3176, %v3211
  %v3213 = getelementptr i8, ptr %v3208, i64 %v913
  %v3214 = load double, ptr %v3213, align 8, !noalias !420
  %v3215 = fadd double %v3214, %v3212
  %v3216 = fmul double %v3179, %v3215
  %v3217 = getelementptr i8, ptr %v3208, i64 %v914
  %v3218 = load double, ptr %v3217, align 8, !noalias !420
  %v3219 = fadd double %v3218, %v3216
  %v3220 = fmul double %v3176, %v3219
  %v3221 = getelementptr i8, ptr %v3208, i64 %v915
  %v3222 = load double, ptr %v3221, align 8, !noalias !420
  %v3223 = fadd double %v3222, %v3220
  %v3224 = fmul double %v3179, %v3223
  %v3225 = getelementptr i8, ptr %v3208, i64 %v916
  %v3226 = load double, ptr %v3225, align 8, !noalias !420
  %v3227 = fadd double %v3226, %v3224
  %v3228 = fmul double %v3176, %v3227
  %v3229 = getelementptr i8, ptr %v3208, i64 %v917
  %v3230 = load double, ptr %v3229, align 8, !noalias !420
  %v3231 = fadd double %v3230, %v3228
  %v3232 = fmul double %v3179, %v3231
  %v3233 = getelementptr i8, ptr %v3208, i64 %v918
  %v3234 = load double, ptr %v3233, align 8, !noalias !420
  %v3235 = fadd double %v3234, %v3232
  %v3236 = fmul double %v3176, %v3235
  %v3237 = load double, ptr %v3208, align 8, !noalias !420
  %v3199 = fadd double %v3237, %v3236
  br label %v3189

v3126:
  %v3238 = icmp eq i64 %v3239, %v9
  br i1 %v3238, label %v3240, label %v3241

v3241:
  %v3123 = phi i64 [ %v3239, %v3126 ], [ 0, %v3119 ]
  %v3239 = add nsw i64 %v3123, 1
  %v3141 = getelementptr i64, ptr %v142, i64 %v3123
  %v3129 = load i64, ptr %v3141, align 8, !noalias !413
  %v3242 = icmp slt i64 %v3129, 0
  br i1 %v3242, label %v3126, label %v3121

v3240:
  br i1 %v919, label %v3243, label %v3244

v3244:
  %v3245 = load double, ptr %v921, align 8
  %v3246 = fcmp ogt double %v3245, 5.000000e-01
  br i1 %v3246, label %v3243, label %v3247

v3243:
  %v3248 = load i64, ptr %v922, align 8, !noalias !424
  %v3249 = inttoptr i64 %v3248 to ptr
  tail call void %v3249(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !424
  br label %v3247

v3247:
  br i1 %v1468, label %v3250, label %v3251

v3250:
  %v3252 = load double, ptr %v924, align 8, !noalias !427
  %v3253 = fcmp olt double %v3252, 5.000000e-01
  br i1 %v3253, label %v3251, label %v3254

v3254:
  br i1 %v926, label %v3255, label %v3256

v3257:
  %v3258 = getelementptr double, ptr %v927, i64 %v3259
  %v3260 = load double, ptr %v3258, align 8, !noalias !427
  %v3261 = add nsw i64 %v3259, %v17
  %v3262 = icmp slt i64 %v3261, 0
  %v3263 = select i1 %v3262, i64 %v166, i64 0
  %v3264 = getelementptr double, ptr %v165, i64 %v3261
  %v3265 = getelementptr double, ptr %v3264, i64 %v3263
  %v3266 = load double, ptr %v3265, align 8, !noalias !427
  %v3267 = fcmp une double %v3260, %v3266
  br label %v3268

v3268:
  %v3269 = phi i1 [ true, %v3255 ], [ %v3267, %v3257 ]
  %v3270 = icmp eq i64 %v3271, %v18
  br i1 %v3270, label %v3256, label %v3255

v3256:
  %v3272 = phi i1 [ false, %v3254 ], [ %v3269, %v3268 ]
  %v3273 = load double, ptr %v929, align 8, !noalias !427
  %v3274 = fcmp oeq double %v3273, 1.000000e+00
  %v3275 = select i1 %v3274, i1 %v3272, i1 false
  br i1 %v3275, label %v3276, label %v3277

v3276:
  %v3278 = load double, ptr %v133, align 8, !noalias !427
  %v3279 = load double, ptr %v931, align 8, !noalias !427
  %v3280 = fsub double %v3278, %v3279
  br i1 %v932, label %v3281, label %v3282

v3283:
  %v3284 = load double, ptr %v933, align 8, !noalias !427
  %v3285 = load double, ptr %v23, align 8, !noalias !427
  %v3286 = mul i64 %v3287, %v196
  %v3288 = getelementptr double, ptr %v193, i64 %v3286
  %v3289 = load double, ptr %v3288, align 8, !noalias !427
  %v3290 = tail call double @llvm.fabs.f64(double %v3289)
  %v3291 = fmul double %v3285, %v3290
  %v3292 = fadd double %v3284, %v3291
  %v3293 = add i64 %v3287, %v195
  %v3294 = mul i64 %v3293, %v196
  %v3295 = getelementptr double, ptr %v193, i64 %v3294
  %v3296 = load double, ptr %v3295, align 8, !noalias !427
  %v3297 = tail call double @llvm.fabs.f64(double %v3296)
  %v3298 = fmul double %v3280, %v3297
  %v3299 = fcmp ogt double %v3298, %v3292
  br label %v3300

v3300:
  %v3301 = phi i1 [ true, %v3282 ], [ %v3299, %v3283 ]
  %v3302 = icmp eq i64 %v10, %v3303
  br i1 %v3302, label %v3304, label %v3282

v3304:
  %v3305 = select i1 %v3301, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  br label %v3281

v3281:
  %v3306 = phi double [ 5.000000e-06, %v3276 ], [ %v3305, %v3304 ]
  %v3307 = load double, ptr %v935, align 8, !noalias !427
  %v3308 = load double, ptr %v92, align 8, !noalias !427
  %v3309 = fsub double %v3307, %v3308
  %v3310 = fmul double %v3306, %v3309
  %v3311 = fcmp olt double %v3280, %v3310
  br i1 %v3311, label %v3312, label %v3313

v3312:
  %v3314 = load i64, ptr %v937, align 8, !noalias !427
  %v3315 = add nsw i64 %v3314, 1
  br label %v3313

v3313:
  %v3316 = phi i64 [ %v3315, %v3312 ], [ 0, %v3281 ]
  store i64 %v3316, ptr %v939, align 8, !noalias !427
  %v3317 = load double, ptr %v133, align 8, !noalias !427
  store double %v3317, ptr %v931, align 8, !noalias !427
  store double 1.000000e+00, ptr %v941, align 8, !noalias !427
  store i64 2, ptr %v512, align 8, !noalias !427
  %v3318 = load i64, ptr %v939, align 8, !noalias !427
  %v3319 = icmp sgt i64 %v3318, 1000
  br i1 %v3319, label %v3320, label %v3277

v3320:
  %v3321 = load i64, ptr %v142, align 8, !noalias !431
  %v3322 = icmp sgt i64 %v3321, -1
  br i1 %v3322, label %v3323, label %v3277

v3323:
  %v3324 = getelementptr i64, ptr %v110, i64 %v3321
  %v3325 = load i64, ptr %v3324, align 8, !noalias !431
  %v3326 = icmp eq i64 %v3325, 0
  br i1 %v3326, label %v3327, label %v3277

v3327:
  store i64 6, ptr %v3324, align 8, !noalias !431
  br label %v3277

v3277:
  store double 0.000000e+00, ptr %v929, align 8, !noalias !427
  br label %v3251

v3255:
  %v3328 = phi i1 [ %v3269, %v3268 ], [ false, %v3254 ]
  %v3259 = phi i64 [ %v3271, %v3268 ], [ 0, %v3254 ]
  %v3271 = add nsw i64 %v3259, 1
  br i1 %v3328, label %v3268, label %v3257

v3282:
  %v3329 = phi i1 [ %v3301, %v3300 ], [ false, %v3276 ]
  %v3287 = phi i64 [ %v3303, %v3300 ], [ 0, %v3276 ]
  %v3303 = add nsw i64 %v3287, 1
  br i1 %v3329, label %v3300, label %v3283

v3251:
  %v3330 = and i1 %v942, %v1354
  %v3331 = xor i1 %v3330, true
  %v3332 = or i1 %v307, %v3331
  br i1 %v3332, label %v3333, label %v3334

v3335:
  %v3336 = getelementptr i64, ptr %v110, i64 %v3337
  %v3338 = load i64, ptr %v3336, align 8, !noalias !434
  %v3339 = icmp eq i64 %v3338, 0
  br i1 %v3339, label %v3340, label %v3341

v3340:
  %v3342 = getelementptr double, ptr %v945, i64 %v3343
  %v3344 = load double, ptr %v3342, align 8, !noalias !434
  %v3345 = fcmp olt double %v3344, 5.000000e-01
  br i1 %v3345, label %v3341, label %v3346

v3346:
  %v3347 = getelementptr double, ptr %v133, i64 %v3343
  %v3348 = load double, ptr %v3347, align 8, !noalias !434
  %v3349 = getelementptr double, ptr %v947, i64 %v3343
  %v3350 = load double, ptr %v3349, align 8, !noalias !434
  %v3351 = fcmp une double %v3348, %v3350
  %v3352 = select i1 %v3351, i1 true, i1 %v949
  %v3353 = xor i1 %v3351, true
  %v3354 = select i1 %v3353, i1 true, i1 %v3355
  br i1 %v3352, label %v3341, label %v3356

v3356:
  %v3357 = getelementptr i64, ptr %v948, i64 %v3343
  %v3358 = load i64, ptr %v3357, align 8, !noalias !439
  %v3359 = add nsw i64 %v3358, 1
  %v3360 = icmp slt i64 %v3358, -1
  %v3361 = select i1 %v3360, i64 %v77, i64 0
  %v3362 = add i64 %v3359, %v3361
  %v3363 = mul i64 %v3362, %v78
  %v3364 = getelementptr double, ptr %v76, i64 %v3363
  br label %v3365

v3365:
  %v3366 = phi i64 [ 0, %v3356 ], [ %v3367, %v3365 ]
  %v3367 = add nsw i64 %v3366, 1
  %v3368 = getelementptr double, ptr %v3364, i64 %v3366
  %v3369 = load double, ptr %v3368, align 8, !noalias !440
  %v3370 = getelementptr i64, ptr %v62, i64 %v3366
  %v3371 = load i64, ptr %v3370, align 8, !noalias !440
  %v3372 = mul nsw i64 %v3371, %v9
  %v3373 = add nsw i64 %v3372, %v3343
  %v3374 = icmp slt i64 %v3373, 0
  %v3375 = select i1 %v3374, i64 %v166, i64 0
  %v3376 = getelementptr double, ptr %v165, i64 %v3373
  %v3377 = getelementptr double, ptr %v3376, i64 %v3375
  store double %v3369, ptr %v3377, align 8, !noalias !440
  %v3378 = icmp eq i64 %v63, %v3367
  br i1 %v3378, label %v3341, label %v3365

v3341:
  %v3379 = phi i1 [ %v3354, %v3346 ], [ %v3355, %v3340 ], [ %v3355, %v3334 ], [ %v3355, %v3335 ], [ true, %v3365 ]
  %v3380 = icmp eq i64 %v9, %v3381
  br i1 %v3380, label %v3382, label %v3334

v3382:
  br i1 %v3379, label %v3383, label %v3333

v3383:
  %v3384 = load i64, ptr %v950, align 8, !noalias !444
  %v3385 = inttoptr i64 %v3384 to ptr
  tail call void %v3385(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v186), !noalias !444
  %v3386 = load i64, ptr %v952, align 8, !noalias !439
  %v3387 = inttoptr i64 %v3386 to ptr
  tail call void %v3387(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v954), !noalias !439
  br label %v3388

v3388:
  %v3389 = phi i64 [ 0, %v3383 ], [ %v3390, %v3391 ]
  %v3392 = phi i64 [ %v956, %v3383 ], [ %v3393, %v3391 ]
  %v3394 = phi i64 [ 1, %v3383 ], [ %v3395, %v3391 ]
  %v3396 = icmp slt i64 %v3389, 0
  %v3397 = select i1 %v3396, i64 %v144, i64 0
  %v3398 = add i64 %v3397, %v3389
  %v3399 = getelementptr i64, ptr %v142, i64 %v3398
  %v3400 = load i64, ptr %v3399, align 8, !noalias !447
  %v3401 = icmp slt i64 %v3400, 0
  br i1 %v3401, label %v3391, label %v3402

v3402:
  %v3403 = getelementptr i64, ptr %v110, i64 %v3400
  %v3404 = load i64, ptr %v3403, align 8, !noalias !447
  %v3405 = icmp eq i64 %v3404, 0
  br i1 %v3405, label %v3406, label %v3391

v3406:
  %v3407 = select i1 %v3396, i64 %v135, i64 0
  %v3408 = add i64 %v3407, %v3389
  %v3409 = getelementptr double, ptr %v945, i64 %v3408
  %v3410 = load double, ptr %v3409, align 8, !noalias !447
  %v3411 = fcmp olt double %v3410, 5.000000e-01
  br i1 %v3411, label %v3391, label %v3412

v3412:
  %v3413 = getelementptr double, ptr %v133, i64 %v3408
  %v3414 = load double, ptr %v3413, align 8, !noalias !447
  %v3415 = getelementptr double, ptr %v947, i64 %v3408
  %v3416 = load double, ptr %v3415, align 8, !noalias !447
  %v3417 = fcmp une double %v3414, %v3416
  br i1 %v3417, label %v3391, label %v3418

v3418:
  %v3419 = getelementptr i64, ptr %v959, i64 %v3398
  %v3420 = load i64, ptr %v3419, align 8, !noalias !450
  %v3421 = icmp sgt i64 %v3420, 0
  br i1 %v3421, label %v3422, label %v3423

v3422:
  %v3424 = getelementptr double, ptr %v92, i64 %v3420
  %v3425 = getelementptr i8, ptr %v3424, i64 -8
  %v3426 = load double, ptr %v3425, align 8, !noalias !450
  %v3427 = getelementptr double, ptr %v133, i64 %v3389
  %v3428 = getelementptr double, ptr %v3427, i64 %v3407
  %v3429 = load double, ptr %v3428, align 8, !noalias !450
  %v3430 = fcmp oeq double %v3426, %v3429
  br label %v3423

v3423:
  %v3431 = phi i1 [ %v3430, %v3422 ], [ false, %v3418 ]
  br i1 %v961, label %v3432, label %v3433

v3433:
  %v3434 = mul i64 %v955, %v3400
  %v3435 = select i1 %v3396, i64 %v196, i64 0
  %v3436 = add i64 %v3435, %v3389
  %v3437 = getelementptr double, ptr %v962, i64 %v3436
  %v3438 = getelementptr double, ptr %v193, i64 %v3436
  %v3439 = add nsw i64 %v3420, -1
  %v3440 = select i1 %v3421, i64 0, i64 %v101
  %v3441 = add i64 %v3439, %v3440
  %v3442 = mul i64 %v3441, %v102
  %v3443 = getelementptr double, ptr %v99, i64 %v3434
  %v3444 = getelementptr double, ptr %v3443, i64 %v3442
  br label %v3445

v3446:
  %v3447 = getelementptr double, ptr %v3444, i64 %v3448
  store double %v3449, ptr %v3447, align 8, !noalias !450
  br label %v3450

v3450:
  %v3451 = icmp eq i64 %v10, %v3452
  br i1 %v3451, label %v3453, label %v3445

v3453:
  %v3454 = fcmp une double %v3455, 0.000000e+00
  br i1 %v3454, label %v3456, label %v3432

v3456:
  %v3457 = load i64, ptr %v3399, align 8, !noalias !454
  %v3458 = icmp sgt i64 %v3457, -1
  br i1 %v3458, label %v3459, label %v3432

v3459:
  %v3460 = getelementptr i64, ptr %v110, i64 %v3457
  %v3461 = load i64, ptr %v3460, align 8, !noalias !454
  %v3462 = icmp eq i64 %v3461, 0
  br i1 %v3462, label %v3463, label %v3432

v3463:
  store i64 3, ptr %v3460, align 8, !noalias !454
  br label %v3432

v3432:
  br i1 %v304, label %v3464, label %v3391

v3464:
  %v3465 = load double, ptr %v964, align 8, !noalias !457
  %v3466 = load double, ptr %v92, align 8, !noalias !457
  %v3467 = fsub double %v3465, %v3466
  %v3468 = fmul double %v3467, 1.000000e-13
  %v3469 = load double, ptr %v133, align 8, !noalias !457
  %v3470 = tail call double @llvm.fabs.f64(double %v3469)
  %v3471 = fmul double %v3470, 4.000000e-15
  %v3472 = fcmp ogt double %v3471, %v3468
  %v3473 = select i1 %v3472, double %v3471, double %v3468
  %v3474 = fadd double %v3469, %v3473
  store double %v3474, ptr %v966, align 8, !noalias !467
  %v3475 = load i64, ptr %v6, align 8, !noalias !468
  %v3476 = inttoptr i64 %v3475 to ptr
  tail call void %v3476(ptr nonnull %v133, ptr %v954, ptr %v165, ptr %v172, ptr %v179, ptr %v968), !noalias !468
  br i1 %v961, label %v3477, label %v3478

v3477:
  %v3479 = load i64, ptr %v973, align 8, !noalias !471
  %v3480 = inttoptr i64 %v3479 to ptr
  tail call void %v3480(ptr nonnull %v133, ptr %v975, ptr %v165, ptr %v172, ptr %v179, ptr %v977), !noalias !471
  %v3481 = load i64, ptr %v973, align 8, !noalias !474
  %v3482 = inttoptr i64 %v3481 to ptr
  tail call void %v3482(ptr nonnull %v966, ptr %v979, ptr %v165, ptr %v172, ptr %v179, ptr %v981), !noalias !474
  br label %v3483

v3483:
  %v3484 = phi i64 [ %v18, %v3477 ], [ %v3485, %v3486 ]
  %v3487 = phi i64 [ %v983, %v3477 ], [ %v3488, %v3486 ]
  %v3489 = icmp sgt i64 %v3487, 0
  br i1 %v3489, label %v3486, label %v3490

v3486:
  %v3488 = add nsw i64 %v3487, -1
  %v3485 = add i64 %v3484, 1
  %v3491 = icmp slt i64 %v3484, 0
  %v3492 = select i1 %v3491, i64 %v207, i64 0
  %v3493 = add i64 %v3492, %v3484
  %v3494 = getelementptr double, ptr %v987, i64 %v3493
  %v3495 = load double, ptr %v3494, align 8, !noalias !467
  %v3496 = getelementptr double, ptr %v990, i64 %v3493
  %v3497 = load double, ptr %v3496, align 8, !noalias !467
  %v3498 = fsub double %v3495, %v3497
  %v3499 = tail call double @llvm.fabs.f64(double %v3498)
  %v3500 = getelementptr double, ptr %v992, i64 %v3493
  %v3501 = load double, ptr %v3500, align 8, !noalias !467
  %v3502 = tail call i1 @llvm.is.fpclass.f64(double %v3501, i32 543)
  %v3503 = select i1 %v3502, double 0.000000e+00, double %v3501
  %v3504 = fcmp ueq double %v3499, 0x7FF0000000000000
  %v3505 = select i1 %v3504, double -0.000000e+00, double %v3499
  %v3506 = fadd double %v3503, %v3505
  %v3507 = getelementptr double, ptr %v989, i64 %v3493
  %v3508 = load double, ptr %v3507, align 8, !noalias !467
  %v3509 = fneg double %v3506
  %v3510 = fcmp olt double %v3508, %v3509
  br i1 %v3510, label %v3490, label %v3483

v3478:
  %v3511 = phi i64 [ %v3512, %v3478 ], [ 0, %v3464 ]
  %v3512 = add nsw i64 %v3511, 1
  %v3513 = mul i64 %v3511, %v196
  %v3514 = getelementptr double, ptr %v962, i64 %v3513
  %v3515 = load double, ptr %v3514, align 8, !noalias !467
  %v3516 = getelementptr double, ptr %v970, i64 %v3513
  %v3517 = load double, ptr %v3516, align 8, !noalias !467
  %v3518 = fmul double %v3473, %v3517
  %v3519 = fadd double %v3515, %v3518
  %v3520 = getelementptr double, ptr %v972, i64 %v3513
  store double %v3519, ptr %v3520, align 8, !noalias !467
  %v3521 = icmp eq i64 %v10, %v3512
  br i1 %v3521, label %v3477, label %v3478

v3522:
  %v3523 = getelementptr i64, ptr %v994, i64 %v3398
  store i64 %v3524, ptr %v3523, align 8, !noalias !477
  %v3525 = load i64, ptr %v3399, align 8, !noalias !478
  %v3526 = icmp sgt i64 %v3525, -1
  br i1 %v3526, label %v3527, label %v3528

v3527:
  %v3529 = getelementptr i64, ptr %v110, i64 %v3525
  %v3530 = load i64, ptr %v3529, align 8, !noalias !478
  %v3531 = icmp eq i64 %v3530, 0
  br i1 %v3531, label %v3532, label %v3528

v3532:
  store i64 4, ptr %v3529, align 8, !noalias !478
  br label %v3528

v3528:
  %v3533 = load double, ptr %v3413, align 8, !noalias !477
  store double %v3533, ptr %v3415, align 8, !noalias !477
  %v3534 = getelementptr double, ptr %v996, i64 %v3408
  store double 0.000000e+00, ptr %v3534, align 8, !noalias !477
  br label %v3391

v3490:
  %v3524 = phi i64 [ %v3484, %v3486 ], [ -1, %v3483 ]
  %v3535 = icmp sgt i64 %v3524, -1
  br i1 %v3535, label %v3522, label %v3391

v3445:
  %v3536 = phi double [ 0.000000e+00, %v3433 ], [ %v3455, %v3450 ]
  %v3448 = phi i64 [ 0, %v3433 ], [ %v3452, %v3450 ]
  %v3452 = add nsw i64 %v3448, 1
  %v3537 = mul i64 %v3448, %v196
  %v3538 = getelementptr double, ptr %v3437, i64 %v3537
  %v3449 = load double, ptr %v3538, align 8, !noalias !450
  %v3539 = fmul double %v3449, 0.000000e+00
  %v3455 = fadd double %v3536, %v3539
  %v3540 = getelementptr double, ptr %v3438, i64 %v3537
  store double %v3449, ptr %v3540, align 8, !noalias !450
  br i1 %v3431, label %v3446, label %v3450

v3391:
  %v3541 = icmp sgt i64 %v3392, 0
  %v3542 = zext i1 %v3541 to i64
  %v3395 = add i64 %v3394, %v3542
  %v3543 = sext i1 %v3541 to i64
  %v3393 = add nsw i64 %v3392, %v3543
  %v3390 = select i1 %v3541, i64 %v3394, i64 0
  br i1 %v3541, label %v3388, label %v3333

v3334:
  %v3355 = phi i1 [ %v3379, %v3341 ], [ false, %v3251 ]
  %v3343 = phi i64 [ %v3381, %v3341 ], [ 0, %v3251 ]
  %v3381 = add nsw i64 %v3343, 1
  %v3544 = getelementptr i64, ptr %v142, i64 %v3343
  %v3337 = load i64, ptr %v3544, align 8, !noalias !434
  %v3545 = icmp slt i64 %v3337, 0
  br i1 %v3545, label %v3341, label %v3335

v3333:
  %v3546 = xor i1 %v1354, true
  %v3547 = or i1 %v307, %v3546
  %v3548 = select i1 %v1354, i64 0, i64 %v1124
  br i1 %v3547, label %v1123, label %v3549

v3549:
  %v3550 = phi i64 [ %v3551, %v3552 ], [ 0, %v3333 ]
  %v3553 = phi i64 [ %v3554, %v3552 ], [ %v1000, %v3333 ]
  %v3555 = phi i64 [ %v3556, %v3552 ], [ %v999, %v3333 ]
  %v3557 = phi i1 [ %v3558, %v3552 ], [ false, %v3333 ]
  %v3559 = phi i64 [ %v3560, %v3552 ], [ 0, %v3333 ]
  %v3561 = icmp slt i64 %v3550, 0
  %v3562 = select i1 %v3561, i64 %v144, i64 0
  %v3563 = add i64 %v3562, %v3550
  %v3564 = getelementptr i64, ptr %v142, i64 %v3563
  %v3565 = load i64, ptr %v3564, align 8, !noalias !481
  %v3566 = icmp slt i64 %v3565, 0
  br i1 %v3566, label %v3552, label %v3567

v3567:
  %v3568 = mul i64 %v3565, %v126
  %v3569 = getelementptr i64, ptr %v124, i64 %v3568
  %v3570 = load i64, ptr %v3569, align 8, !noalias !481
  %v3571 = getelementptr i8, ptr %v3569, i64 24
  %v3572 = load i64, ptr %v3571, align 8, !noalias !481
  %v3573 = add nsw i64 %v3572, %v3570
  %v3574 = icmp slt i64 %v3573, %v298
  br i1 %v3574, label %v3575, label %v3576

v3576:
  %v3577 = getelementptr i64, ptr %v110, i64 %v3565
  %v3578 = load i64, ptr %v3577, align 8, !noalias !485
  %v3579 = icmp eq i64 %v3578, 0
  br i1 %v3579, label %v3580, label %v3581

v3580:
  store i64 5, ptr %v3577, align 8, !noalias !485
  br label %v3581

v3575:
  %v3582 = select i1 %v3561, i64 %v135, i64 0
  %v3583 = add i64 %v3582, %v3550
  %v3584 = getelementptr double, ptr %v1002, i64 %v3583
  %v3585 = load double, ptr %v3584, align 8, !noalias !481
  %v3586 = sitofp i64 %v3573 to double
  %v3587 = fcmp ugt double %v3585, %v3586
  br i1 %v3587, label %v3581, label %v3588

v3588:
  br i1 %v1003, label %v3589, label %v3590

v3590:
  %v3591 = getelementptr double, ptr %v193, i64 %v3550
  %v3592 = select i1 %v3561, i64 %v196, i64 0
  %v3593 = getelementptr double, ptr %v3591, i64 %v3592
  br label %v3594

v3589:
  %v3595 = phi double [ 0.000000e+00, %v3588 ], [ %v3596, %v3594 ]
  %v3597 = getelementptr double, ptr %v133, i64 %v3583
  %v3598 = load double, ptr %v3597, align 8, !noalias !488
  %v3599 = getelementptr double, ptr %v1005, i64 %v3583
  %v3600 = load double, ptr %v3599, align 8, !noalias !488
  %v3601 = fsub double %v3598, %v3600
  %v3602 = getelementptr double, ptr %v1007, i64 %v3583
  %v3603 = load double, ptr %v3602, align 8, !noalias !488
  %v3604 = fadd double %v3603, 1.000000e+00
  store double %v3604, ptr %v3602, align 8, !noalias !488
  %v3605 = getelementptr double, ptr %v1009, i64 %v3583
  %v3606 = load double, ptr %v3605, align 8, !noalias !488
  %v3607 = fmul double %v3606, 1.050000e+00
  %v3608 = fcmp ogt double %v3601, %v3607
  br i1 %v3608, label %v3609, label %v3610

v3609:
  %v3611 = fcmp ogt double %v3604, 0.000000e+00
  %v3612 = select i1 %v3611, double 0.000000e+00, double %v3604
  store double %v3612, ptr %v3602, align 8, !noalias !488
  %v3613 = getelementptr double, ptr %v1011, i64 %v3583
  store double %v3595, ptr %v3613, align 8, !noalias !488
  br label %v3610

v3610:
  %v3614 = load double, ptr %v3597, align 8, !noalias !488
  store double %v3614, ptr %v3599, align 8, !noalias !488
  store double %v3601, ptr %v3605, align 8, !noalias !488
  %v3615 = fmul double %v3586, 2.000000e+00
  store double %v3615, ptr %v3584, align 8, !noalias !488
  %v3616 = getelementptr double, ptr %v1013, i64 %v3583
  %v3617 = load double, ptr %v3616, align 8, !noalias !488
  %v3618 = load double, ptr %v3597, align 8, !noalias !488
  %v3619 = fsub double %v3617, %v3618
  %v3620 = fmul double %v3586, 5.000000e-01
  %v3621 = fmul double %v3620, %v3619
  %v3622 = fdiv double %v3621, %v3601
  %v3623 = load double, ptr %v3602, align 8, !noalias !488
  %v3624 = fcmp olt double %v3623, 0.000000e+00
  %v3625 = select i1 %v3624, double 1.000000e+15, double 1.000000e+11
  %v3626 = icmp sgt i64 %v3573, 499999
  %v3627 = fcmp ogt double %v3622, %v3625
  %v3628 = select i1 %v3626, i1 %v3627, i1 false
  br i1 %v3628, label %v3629, label %v3630

v3629:
  %v3631 = load i64, ptr %v3564, align 8, !noalias !492
  %v3632 = icmp sgt i64 %v3631, -1
  br i1 %v3632, label %v3633, label %v3630

v3633:
  %v3634 = getelementptr i64, ptr %v110, i64 %v3631
  %v3635 = load i64, ptr %v3634, align 8, !noalias !492
  %v3636 = icmp eq i64 %v3635, 0
  br i1 %v3636, label %v3637, label %v3630

v3637:
  store i64 5, ptr %v3634, align 8, !noalias !492
  br label %v3630

v3630:
  %v3638 = load double, ptr %v3602, align 8, !noalias !488
  %v3639 = fcmp ult double %v3638, 5.000000e+00
  br i1 %v3639, label %v3581, label %v3640

v3640:
  %v3641 = getelementptr double, ptr %v1015, i64 %v3583
  %v3642 = load double, ptr %v3641, align 8, !noalias !488
  %v3643 = fmul double %v3642, 2.000000e+00
  %v3644 = fcmp ogt double %v3595, %v3643
  br i1 %v3644, label %v3645, label %v3581

v3645:
  %v3646 = sub nsw i64 %v298, %v3573
  %v3647 = sitofp i64 %v3646 to double
  %v3648 = fmul double %v3647, 2.000000e+00
  %v3649 = fcmp ogt double %v3622, %v3648
  br i1 %v3649, label %v3650, label %v3581

v3650:
  %v3651 = load i64, ptr %v3564, align 8, !noalias !495
  %v3652 = icmp sgt i64 %v3651, -1
  br i1 %v3652, label %v3653, label %v3581

v3653:
  %v3654 = getelementptr i64, ptr %v110, i64 %v3651
  %v3655 = load i64, ptr %v3654, align 8, !noalias !495
  %v3656 = icmp eq i64 %v3655, 0
  br i1 %v3656, label %v3657, label %v3581

v3657:
  store i64 8, ptr %v3654, align 8, !noalias !495
  br label %v3581

v3594:
  %v3658 = phi double [ 0.000000e+00, %v3590 ], [ %v3596, %v3594 ]
  %v3659 = phi i64 [ 0, %v3590 ], [ %v3660, %v3594 ]
  %v3660 = add nsw i64 %v3659, 1
  %v3661 = mul i64 %v3659, %v196
  %v3662 = getelementptr double, ptr %v3593, i64 %v3661
  %v3663 = load double, ptr %v3662, align 8, !noalias !488
  %v3664 = tail call double @llvm.fabs.f64(double %v3663)
  %v3665 = fcmp ogt double %v3664, %v3658
  %v3596 = select i1 %v3665, double %v3664, double %v3658
  %v3666 = icmp eq i64 %v10, %v3660
  br i1 %v3666, label %v3589, label %v3594

v3581:
  %v3667 = select i1 %v3561, i64 %v135, i64 0
  %v3668 = add i64 %v3667, %v3550
  %v3669 = getelementptr double, ptr %v1017, i64 %v3668
  %v3670 = load double, ptr %v3669, align 8, !noalias !481
  %v3671 = fcmp ogt double %v3670, 5.000000e-01
  br i1 %v3671, label %v3672, label %v3673

v3672:
  %v3674 = getelementptr double, ptr %v133, i64 %v3668
  %v3675 = load double, ptr %v3674, align 8, !noalias !481
  %v3676 = getelementptr double, ptr %v1019, i64 %v3668
  %v3677 = load double, ptr %v3676, align 8, !noalias !481
  %v3678 = fcmp oeq double %v3675, %v3677
  br i1 %v3678, label %v3679, label %v3673

v3679:
  %v3680 = getelementptr i64, ptr %v1020, i64 %v3563
  %v3681 = load i64, ptr %v3680, align 8, !noalias !498
  %v3682 = add nsw i64 %v3681, 1
  store i64 %v3682, ptr %v3680, align 8, !noalias !498
  %v3683 = icmp slt i64 %v3681, -1
  %v3684 = select i1 %v3683, i64 %v70, i64 0
  %v3685 = getelementptr double, ptr %v69, i64 %v3682
  %v3686 = getelementptr double, ptr %v3685, i64 %v3684
  %v3687 = load double, ptr %v3686, align 8, !noalias !498
  %v3688 = fcmp oeq double %v3687, 0x7FF0000000000000
  br i1 %v3688, label %v3689, label %v3690

v3689:
  %v3691 = load i64, ptr %v3564, align 8, !noalias !498
  %v3692 = icmp slt i64 %v3691, 0
  %v3693 = select i1 %v3692, i64 %v111, i64 0
  %v3694 = getelementptr i64, ptr %v110, i64 %v3691
  %v3695 = getelementptr i64, ptr %v3694, i64 %v3693
  %v3696 = load i64, ptr %v3695, align 8, !noalias !498
  %v3697 = icmp eq i64 %v3696, 0
  br i1 %v3697, label %v3698, label %v3673

v3698:
  store i64 1, ptr %v3695, align 8, !noalias !498
  br label %v3673

v3690:
  store double %v3687, ptr %v3676, align 8, !noalias !498
  %v3699 = select i1 %v3683, i64 %v86, i64 0
  %v3700 = getelementptr i64, ptr %v85, i64 %v3682
  %v3701 = getelementptr i64, ptr %v3700, i64 %v3699
  %v3702 = load i64, ptr %v3701, align 8, !noalias !498
  %v3703 = icmp eq i64 %v3702, 0
  br i1 %v3703, label %v3704, label %v3705

v3704:
  %v3706 = getelementptr double, ptr %v1024, i64 %v3668
  store double 1.000000e+00, ptr %v3706, align 8, !noalias !498
  br label %v3707

v3705:
  %v3708 = getelementptr double, ptr %v1022, i64 %v3668
  %v3709 = load double, ptr %v3708, align 8, !noalias !498
  %v3710 = fcmp olt double %v3709, 2.500000e-01
  %v3711 = select i1 %v3710, double 2.500000e-01, double %v3709
  store double %v3711, ptr %v3708, align 8, !noalias !498
  %v3712 = load i64, ptr %v512, align 8, !noalias !498
  %v3713 = tail call i64 @llvm.smax.i64(i64 %v3712, i64 1)
  br label %v3707

v3707:
  %v3714 = phi i64 [ %v3713, %v3705 ], [ 2, %v3704 ]
  store i64 %v3714, ptr %v512, align 8, !noalias !498
  br i1 %v1025, label %v3673, label %v3715

v3715:
  %v3716 = select i1 %v3683, i64 %v77, i64 0
  %v3717 = add i64 %v3716, %v3682
  %v3718 = mul i64 %v3717, %v78
  %v3719 = getelementptr double, ptr %v76, i64 %v3718
  br label %v3720

v3720:
  %v3721 = phi i64 [ 0, %v3715 ], [ %v3722, %v3720 ]
  %v3722 = add nsw i64 %v3721, 1
  %v3723 = getelementptr double, ptr %v3719, i64 %v3721
  %v3724 = load double, ptr %v3723, align 8, !noalias !502
  %v3725 = getelementptr i64, ptr %v62, i64 %v3721
  %v3726 = load i64, ptr %v3725, align 8, !noalias !502
  %v3727 = mul nsw i64 %v3726, %v9
  %v3728 = add nsw i64 %v3727, %v3550
  %v3729 = icmp slt i64 %v3728, 0
  %v3730 = select i1 %v3729, i64 %v166, i64 0
  %v3731 = getelementptr double, ptr %v165, i64 %v3728
  %v3732 = getelementptr double, ptr %v3731, i64 %v3730
  store double %v3724, ptr %v3732, align 8, !noalias !502
  %v3733 = icmp eq i64 %v63, %v3722
  br i1 %v3733, label %v3673, label %v3720

v3673:
  %v3734 = getelementptr i64, ptr %v110, i64 %v3565
  %v3735 = load i64, ptr %v3734, align 8, !noalias !481
  %v3736 = icmp eq i64 %v3735, 0
  br i1 %v3736, label %v3737, label %v3738

v3738:
  %v3739 = getelementptr i64, ptr %v1027, i64 %v3563
  %v3740 = load i64, ptr %v3739, align 8, !noalias !481
  %v3741 = getelementptr i64, ptr %v117, i64 %v3565
  store i64 %v3740, ptr %v3741, align 8, !noalias !481
  store i64 -1, ptr %v3564, align 8, !noalias !481
  %v3742 = getelementptr double, ptr %v1029, i64 %v3668
  store double 0.000000e+00, ptr %v3742, align 8, !noalias !506
  %v3743 = load i64, ptr %v151, align 8, !noalias !506
  %v3744 = load i64, ptr %v1030, align 8, !noalias !506
  %v3745 = icmp eq i64 %v3743, %v3744
  br i1 %v3745, label %v3746, label %v3747

v3747:
  %v3748 = add nsw i64 %v3743, 1
  store i64 %v3748, ptr %v151, align 8, !noalias !506
  store i64 2, ptr %v512, align 8, !noalias !506
  store i64 %v3743, ptr %v3564, align 8, !noalias !506
  %v3749 = icmp slt i64 %v3743, 0
  %v3750 = select i1 %v3749, i64 %v49, i64 0
  %v3751 = getelementptr i64, ptr %v48, i64 %v3743
  %v3752 = getelementptr i64, ptr %v3751, i64 %v3750
  %v3753 = load i64, ptr %v3752, align 8, !noalias !506
  %v3754 = icmp slt i64 %v3753, 0
  %v3755 = select i1 %v3754, i64 %v56, i64 0
  %v3756 = getelementptr i64, ptr %v55, i64 %v3753
  %v3757 = getelementptr i64, ptr %v3756, i64 %v3755
  %v3758 = load i64, ptr %v3757, align 8, !noalias !506
  %v3759 = getelementptr i64, ptr %v1031, i64 %v3563
  store i64 %v3758, ptr %v3759, align 8, !noalias !506
  store i64 1, ptr %v3739, align 8, !noalias !506
  %v3760 = getelementptr i64, ptr %v1033, i64 %v3563
  store i64 0, ptr %v3760, align 8, !noalias !506
  br i1 %v1034, label %v3761, label %v3762

v3762:
  %v3763 = select i1 %v3749, i64 %v40, i64 0
  %v3764 = add i64 %v3763, %v3743
  %v3765 = mul i64 %v3764, %v41
  %v3766 = getelementptr double, ptr %v39, i64 %v3765
  br label %v3767

v3761:
  br i1 %v1035, label %v3768, label %v3769

v3769:
  %v3770 = load i64, ptr %v3759, align 8, !noalias !506
  %v3771 = icmp slt i64 %v3770, 0
  %v3772 = select i1 %v3771, i64 %v77, i64 0
  %v3773 = add i64 %v3772, %v3770
  %v3774 = mul i64 %v3773, %v78
  %v3775 = getelementptr double, ptr %v76, i64 %v3774
  br label %v3776

v3776:
  %v3777 = phi i64 [ 0, %v3769 ], [ %v3778, %v3776 ]
  %v3778 = add nsw i64 %v3777, 1
  %v3779 = getelementptr double, ptr %v3775, i64 %v3777
  %v3780 = load double, ptr %v3779, align 8, !noalias !509
  %v3781 = getelementptr i64, ptr %v62, i64 %v3777
  %v3782 = load i64, ptr %v3781, align 8, !noalias !509
  %v3783 = mul nsw i64 %v3782, %v9
  %v3784 = add nsw i64 %v3783, %v3550
  %v3785 = icmp slt i64 %v3784, 0
  %v3786 = select i1 %v3785, i64 %v166, i64 0
  %v3787 = getelementptr double, ptr %v165, i64 %v3784
  %v3788 = getelementptr double, ptr %v3787, i64 %v3786
  store double %v3780, ptr %v3788, align 8, !noalias !509
  %v3789 = icmp eq i64 %v3778, %v63
  br i1 %v3789, label %v3768, label %v3776

v3790:
  %v3791 = getelementptr double, ptr %v133, i64 %v3668
  %v3792 = getelementptr double, ptr %v1038, i64 %v3668
  %v3793 = load double, ptr %v3792, align 8, !noalias !513
  %v3794 = getelementptr double, ptr %v1040, i64 %v3668
  %v3795 = load double, ptr %v3794, align 8, !noalias !513
  %v3796 = getelementptr double, ptr %v1042, i64 %v3668
  %v3797 = load double, ptr %v3796, align 8, !noalias !513
  %v3798 = getelementptr double, ptr %v1044, i64 %v3668
  %v3799 = load double, ptr %v3798, align 8, !noalias !513
  store double 0.000000e+00, ptr %v3791, align 8, !noalias !513
  %v3800 = getelementptr double, ptr %v3791, i64 %v135
  store double 0.000000e+00, ptr %v3800, align 8, !noalias !513
  %v3801 = getelementptr i8, ptr %v3791, i64 %v1045
  store double 0.000000e+00, ptr %v3801, align 8, !noalias !513
  %v3802 = getelementptr i8, ptr %v3791, i64 %v1028
  store double 0.000000e+00, ptr %v3802, align 8, !noalias !513
  %v3803 = getelementptr i8, ptr %v3791, i64 %v1046
  store double 0.000000e+00, ptr %v3803, align 8, !noalias !513
  %v3804 = getelementptr i8, ptr %v3791, i64 %v1016
  store double 0.000000e+00, ptr %v3804, align 8, !noalias !513
  %v3805 = getelementptr i8, ptr %v3791, i64 %v1047
  store double 0.000000e+00, ptr %v3805, align 8, !noalias !513
  %v3806 = getelementptr i8, ptr %v3791, i64 %v1048
  store double 0.000000e+00, ptr %v3806, align 8, !noalias !513
  %v3807 = getelementptr i8, ptr %v3791, i64 %v1049
  store double 0.000000e+00, ptr %v3807, align 8, !noalias !513
  %v3808 = getelementptr i8, ptr %v3791, i64 %v1050
  store double 0.000000e+00, ptr %v3808, align 8, !noalias !513
  %v3809 = getelementptr i8, ptr %v3791, i64 %v1051
  store double 0.000000e+00, ptr %v3809, align 8, !noalias !513
  %v3810 = getelementptr i8, ptr %v3791, i64 %v1052
  store double 0.000000e+00, ptr %v3810, align 8, !noalias !513
  %v3811 = getelementptr i8, ptr %v3791, i64 %v1053
  store double 0.000000e+00, ptr %v3811, align 8, !noalias !513
  %v3812 = getelementptr i8, ptr %v3791, i64 %v1054
  store double 0.000000e+00, ptr %v3812, align 8, !noalias !513
  %v3813 = getelementptr i8, ptr %v3791, i64 %v1055
  store double 0.000000e+00, ptr %v3813, align 8, !noalias !513
  %v3814 = getelementptr i8, ptr %v3791, i64 %v1056
  store double 0.000000e+00, ptr %v3814, align 8, !noalias !513
  %v3815 = getelementptr i8, ptr %v3791, i64 %v1039
  store double 0.000000e+00, ptr %v3815, align 8, !noalias !513
  %v3816 = getelementptr i8, ptr %v3791, i64 %v1057
  store double 0.000000e+00, ptr %v3816, align 8, !noalias !513
  %v3817 = getelementptr i8, ptr %v3791, i64 %v1058
  store double 0.000000e+00, ptr %v3817, align 8, !noalias !513
  %v3818 = getelementptr i8, ptr %v3791, i64 %v1059
  store double 0.000000e+00, ptr %v3818, align 8, !noalias !513
  %v3819 = getelementptr i8, ptr %v3791, i64 %v1060
  store double 0.000000e+00, ptr %v3819, align 8, !noalias !513
  %v3820 = getelementptr i8, ptr %v3791, i64 %v1061
  store double 0.000000e+00, ptr %v3820, align 8, !noalias !513
  %v3821 = getelementptr i8, ptr %v3791, i64 %v1062
  store double 0.000000e+00, ptr %v3821, align 8, !noalias !513
  %v3822 = getelementptr i8, ptr %v3791, i64 %v1063
  store double 0.000000e+00, ptr %v3822, align 8, !noalias !513
  %v3823 = getelementptr i8, ptr %v3791, i64 %v1064
  store double 0.000000e+00, ptr %v3823, align 8, !noalias !513
  %v3824 = getelementptr i8, ptr %v3791, i64 %v1065
  store double 0.000000e+00, ptr %v3824, align 8, !noalias !513
  %v3825 = getelementptr i8, ptr %v3791, i64 %v1066
  store double 0.000000e+00, ptr %v3825, align 8, !noalias !513
  %v3826 = getelementptr i8, ptr %v3791, i64 %v1043
  store double 0.000000e+00, ptr %v3826, align 8, !noalias !513
  %v3827 = getelementptr i8, ptr %v3791, i64 %v1041
  store double 0.000000e+00, ptr %v3827, align 8, !noalias !513
  %v3828 = getelementptr i8, ptr %v3791, i64 %v1067
  store double 0.000000e+00, ptr %v3828, align 8, !noalias !513
  %v3829 = getelementptr i8, ptr %v3791, i64 %v1068
  store double 0.000000e+00, ptr %v3829, align 8, !noalias !513
  %v3830 = getelementptr i8, ptr %v3791, i64 %v1069
  store double 0.000000e+00, ptr %v3830, align 8, !noalias !513
  %v3831 = getelementptr i8, ptr %v3791, i64 %v1070
  store double 0.000000e+00, ptr %v3831, align 8, !noalias !513
  %v3832 = getelementptr i8, ptr %v3791, i64 %v1037
  store double 0.000000e+00, ptr %v3832, align 8, !noalias !513
  %v3833 = fcmp oeq double %v3799, 0xFFF0000000000000
  %v3834 = select i1 %v3833, double 0xFFF0000000000000, double 0.000000e+00
  store double %v3834, ptr %v3798, align 8, !noalias !513
  store double %v3797, ptr %v3796, align 8, !noalias !513
  store double %v3795, ptr %v3794, align 8, !noalias !513
  %v3835 = fcmp oeq double %v3793, 0xFFF0000000000000
  %v3836 = select i1 %v3835, double 0xFFF0000000000000, double 0.000000e+00
  store double %v3836, ptr %v3792, align 8, !noalias !513
  %v3837 = getelementptr double, ptr %v1071, i64 %v3668
  store double 5.000000e+03, ptr %v3837, align 8, !noalias !513
  store double 1.000000e+00, ptr %v3742, align 8, !noalias !513
  %v3838 = getelementptr double, ptr %v1072, i64 %v3668
  store double 0xFFF0000000000000, ptr %v3838, align 8, !noalias !513
  %v3839 = getelementptr double, ptr %v1073, i64 %v3668
  store double 0x7FF0000000000000, ptr %v3839, align 8, !noalias !513
  %v3840 = load double, ptr %v92, align 8, !noalias !506
  store double %v3840, ptr %v3791, align 8, !noalias !506
  %v3841 = load double, ptr %v92, align 8, !noalias !506
  %v3842 = getelementptr double, ptr %v1074, i64 %v3668
  store double %v3841, ptr %v3842, align 8, !noalias !506
  %v3843 = load i64, ptr %v3759, align 8, !noalias !506
  %v3844 = icmp slt i64 %v3843, 0
  %v3845 = select i1 %v3844, i64 %v70, i64 0
  %v3846 = getelementptr double, ptr %v69, i64 %v3843
  %v3847 = getelementptr double, ptr %v3846, i64 %v3845
  %v3848 = load double, ptr %v3847, align 8, !noalias !506
  %v3849 = getelementptr double, ptr %v1075, i64 %v3668
  store double %v3848, ptr %v3849, align 8, !noalias !506
  br label %v3746

v3767:
  %v3850 = phi i64 [ 0, %v3762 ], [ %v3851, %v3767 ]
  %v3851 = add nsw i64 %v3850, 1
  %v3852 = getelementptr double, ptr %v3766, i64 %v3850
  %v3853 = load double, ptr %v3852, align 8, !noalias !506
  %v3854 = mul nsw i64 %v3850, %v9
  %v3855 = add nsw i64 %v3854, %v3550
  %v3856 = icmp slt i64 %v3855, 0
  %v3857 = select i1 %v3856, i64 %v166, i64 0
  %v3858 = getelementptr double, ptr %v165, i64 %v3855
  %v3859 = getelementptr double, ptr %v3858, i64 %v3857
  store double %v3853, ptr %v3859, align 8, !noalias !506
  %v3860 = icmp eq i64 %v3851, %v41
  br i1 %v3860, label %v3761, label %v3767

v3768:
  br i1 %v1036, label %v3790, label %v3861

v3861:
  %v3862 = getelementptr double, ptr %v193, i64 %v3550
  %v3863 = select i1 %v3749, i64 %v31, i64 0
  %v3864 = add i64 %v3863, %v3743
  %v3865 = mul i64 %v3864, %v32
  %v3866 = getelementptr double, ptr %v30, i64 %v3865
  %v3867 = select i1 %v3561, i64 %v196, i64 0
  %v3868 = getelementptr double, ptr %v3862, i64 %v3867
  br label %v3869

v3869:
  %v3870 = phi i64 [ 0, %v3861 ], [ %v3871, %v3869 ]
  %v3871 = add nsw i64 %v3870, 1
  %v3872 = getelementptr double, ptr %v3866, i64 %v3870
  %v3873 = load double, ptr %v3872, align 8, !noalias !506
  %v3874 = mul i64 %v3870, %v196
  %v3875 = getelementptr double, ptr %v3868, i64 %v3874
  store double %v3873, ptr %v3875, align 8, !noalias !506
  %v3876 = icmp eq i64 %v3871, %v10
  br i1 %v3876, label %v3790, label %v3869

v3737:
  %v3877 = getelementptr double, ptr %v1077, i64 %v3668
  %v3878 = load double, ptr %v3877, align 8, !noalias !481
  %v3879 = fcmp ult double %v3878, 1.500000e+01
  br i1 %v3879, label %v3746, label %v3880

v3880:
  %v3881 = load double, ptr %v1079, align 8, !noalias !481
  %v3882 = getelementptr double, ptr %v133, i64 %v3668
  %v3883 = load double, ptr %v3882, align 8, !noalias !481
  %v3884 = fsub double %v3881, %v3883
  %v3885 = getelementptr double, ptr %v1080, i64 %v3668
  %v3886 = load double, ptr %v3885, align 8, !noalias !481
  %v3887 = fmul double %v3886, 2.500000e+02
  %v3888 = fcmp ogt double %v3884, %v3887
  br i1 %v3888, label %v3746, label %v3889

v3889:
  store double 0.000000e+00, ptr %v3877, align 8, !noalias !481
  br label %v3746

v3746:
  %v3890 = phi i1 [ %v3557, %v3737 ], [ true, %v3880 ], [ %v3557, %v3889 ], [ %v3557, %v3738 ], [ %v3557, %v3790 ]
  %v3891 = load i64, ptr %v3564, align 8, !noalias !481
  %v3892 = icmp sgt i64 %v3891, -1
  br i1 %v3892, label %v3893, label %v3552

v3893:
  %v3894 = add nsw i64 %v3559, 1
  %v3895 = getelementptr double, ptr %v1082, i64 %v3668
  %v3896 = load double, ptr %v3895, align 8, !noalias !481
  %v3897 = fcmp ogt double %v3896, 0.000000e+00
  br i1 %v3897, label %v3898, label %v3899

v3899:
  %v3900 = mul i64 %v3891, %v126
  %v3901 = getelementptr i64, ptr %v124, i64 %v3900
  %v3902 = load i64, ptr %v3901, align 8, !noalias !481
  %v3903 = and i64 %v3902, 127
  %v3904 = getelementptr double, ptr %v1084, i64 %v3668
  %v3905 = load double, ptr %v3904, align 8, !noalias !481
  %v3906 = fcmp olt double %v3905, %v1085
  %v3907 = select i1 %v3906, double %v3905, double %v1085
  %v3908 = sitofp i64 %v3573 to double
  %v3909 = fsub double %v3907, %v3908
  %v3910 = sub nsw i64 128, %v3903
  %v3911 = uitofp i64 %v3910 to double
  %v3912 = fcmp ogt double %v3909, %v3911
  %v3913 = select i1 %v3912, double %v3911, double %v3909
  br label %v3898

v3898:
  %v3914 = phi double [ %v3913, %v3899 ], [ 1.000000e+00, %v3893 ]
  %v3915 = getelementptr double, ptr %v1087, i64 %v3668
  store double %v3914, ptr %v3915, align 8, !noalias !481
  %v3916 = getelementptr double, ptr %v1089, i64 %v3668
  %v3917 = load double, ptr %v3916, align 8, !noalias !517
  %v3918 = getelementptr double, ptr %v1091, i64 %v3668
  store double %v3917, ptr %v3918, align 8, !noalias !517
  %v3919 = getelementptr i64, ptr %v1093, i64 %v3563
  %v3920 = load i64, ptr %v3919, align 8, !noalias !517
  %v3921 = icmp slt i64 %v3920, %v93
  br i1 %v3921, label %v3922, label %v3552

v3922:
  %v3923 = icmp slt i64 %v3920, 0
  %v3924 = select i1 %v3923, i64 %v93, i64 0
  %v3925 = getelementptr double, ptr %v92, i64 %v3920
  %v3926 = getelementptr double, ptr %v3925, i64 %v3924
  %v3927 = load double, ptr %v3926, align 8, !noalias !517
  %v3928 = load double, ptr %v3916, align 8, !noalias !517
  %v3929 = fcmp olt double %v3928, %v3927
  %v3930 = select i1 %v3929, double %v3928, double %v3927
  store double %v3930, ptr %v3918, align 8, !noalias !517
  br label %v3552

v3552:
  %v3560 = phi i64 [ %v3559, %v3549 ], [ %v3559, %v3746 ], [ %v3894, %v3898 ], [ %v3894, %v3922 ]
  %v3558 = phi i1 [ %v3557, %v3549 ], [ %v3890, %v3746 ], [ %v3890, %v3898 ], [ %v3890, %v3922 ]
  %v3931 = icmp sgt i64 %v3555, 0
  %v3932 = sext i1 %v3931 to i64
  %v3556 = add nsw i64 %v3555, %v3932
  %v3933 = zext i1 %v3931 to i64
  %v3554 = add i64 %v3553, %v3933
  %v3551 = select i1 %v3931, i64 %v3553, i64 0
  br i1 %v3931, label %v3549, label %v3934

v1123:
  %v1122 = phi i64 [ %v1126, %v3333 ], [ %v3935, %v3934 ]
  %v1125 = phi i64 [ %v3548, %v3333 ], [ %v3560, %v3934 ]
  %v3936 = icmp sgt i64 %v1125, 0
  %v3937 = icmp sgt i64 %v1122, 0
  %v3938 = select i1 %v3936, i1 %v3937, i1 false
  br i1 %v3938, label %v1120, label %v511

v511:
  %v3939 = phi i64 [ %v506, %v309 ], [ %v1125, %v1123 ]
  br i1 %v307, label %v3940, label %v3941

v3941:
  %v3942 = mul i64 %v135, 176
  %v3943 = getelementptr i8, ptr %v133, i64 %v3942
  %v3944 = mul i64 %v135, 184
  %v3945 = getelementptr i8, ptr %v133, i64 %v3944
  %v3946 = add nsw i64 %v11, -1
  %v3947 = mul i64 %v135, 160
  %v3948 = getelementptr i8, ptr %v133, i64 %v3947
  br label %v3949

v3950:
  %v3951 = getelementptr double, ptr %v3943, i64 %v3952
  %v3953 = load double, ptr %v3951, align 8, !noalias !521
  %v3954 = fptosi double %v3953 to i64
  %v3955 = getelementptr double, ptr %v3945, i64 %v3952
  %v3956 = load double, ptr %v3955, align 8, !noalias !521
  %v3957 = fptosi double %v3956 to i64
  %v3958 = mul i64 %v3959, %v126
  %v3960 = getelementptr i64, ptr %v124, i64 %v3958
  %v3961 = load i64, ptr %v3960, align 8, !noalias !521
  %v3962 = add nsw i64 %v3961, %v3954
  store i64 %v3962, ptr %v3960, align 8, !noalias !521
  %v3963 = getelementptr i8, ptr %v3960, i64 24
  %v3964 = load i64, ptr %v3963, align 8, !noalias !521
  %v3965 = add nsw i64 %v3964, %v3957
  store i64 %v3965, ptr %v3963, align 8, !noalias !521
  %v3966 = getelementptr i8, ptr %v3960, i64 8
  %v3967 = load i64, ptr %v3966, align 8, !noalias !521
  %v3968 = add nsw i64 %v3957, %v3954
  %v3969 = mul nsw i64 %v3968, %v3946
  %v3970 = add nsw i64 %v3969, %v3954
  %v3971 = add nsw i64 %v3970, %v3967
  store i64 %v3971, ptr %v3966, align 8, !noalias !521
  store double 0.000000e+00, ptr %v3951, align 8, !noalias !521
  store double 0.000000e+00, ptr %v3955, align 8, !noalias !521
  %v3972 = getelementptr double, ptr %v3948, i64 %v3952
  %v3973 = load double, ptr %v3972, align 8, !noalias !521
  %v3974 = sitofp i64 %v3968 to double
  %v3975 = fsub double %v3973, %v3974
  store double %v3975, ptr %v3972, align 8, !noalias !521
  br label %v3976

v3976:
  %v3977 = icmp sgt i64 %v3978, 1
  br i1 %v3977, label %v3949, label %v3940

v3949:
  %v3952 = phi i64 [ 0, %v3941 ], [ %v3979, %v3976 ]
  %v3978 = phi i64 [ %v308, %v3941 ], [ %v3980, %v3976 ]
  %v3980 = add nsw i64 %v3978, -1
  %v3979 = add nsw i64 %v3952, 1
  %v3981 = getelementptr i64, ptr %v142, i64 %v3952
  %v3959 = load i64, ptr %v3981, align 8, !noalias !521
  %v3982 = icmp sgt i64 %v3959, -1
  br i1 %v3982, label %v3950, label %v3976

v3983:
  %v3984 = phi i32 [ 0, %v3940 ], [ %v3118, %v3120 ]
  ret i32 %v3984

v363:
  %v503 = phi i64 [ 0, %v310 ], [ %v502, %v370 ]
  %v505 = phi i64 [ %v308, %v310 ], [ %v3985, %v370 ]
  %v366 = phi i64 [ 0, %v310 ], [ %v3986, %v370 ]
  %v3985 = add nsw i64 %v505, -1
  %v3986 = add nsw i64 %v366, 1
  %v499 = getelementptr i64, ptr %v142, i64 %v366
  %v3987 = load i64, ptr %v499, align 8
  %v3988 = icmp slt i64 %v3987, 0
  br i1 %v3988, label %v364, label %v370

v1332:
  %v3989 = load i64, ptr %v6, align 8, !noalias !525
  %v3990 = inttoptr i64 %v3989 to ptr
  tail call void %v3990(ptr %v133, ptr %v158, ptr %v165, ptr %v172, ptr %v179, ptr %v595), !noalias !525
  br label %v1333

v1333:
  br i1 %v596, label %v3991, label %v3992

v3991:
  %v3993 = load double, ptr %v598, align 8, !noalias !528
  %v3994 = fcmp olt double %v3993, 5.000000e-01
  br i1 %v3994, label %v3995, label %v3996

v3995:
  br i1 %v599, label %v3997, label %v3998

v3997:
  br i1 %v611, label %v3999, label %v4000, !prof !381

v4001:
  %v4002 = icmp eq i64 %v4003, %v644
  br i1 %v4002, label %v3996, label %v4004

v4005:
  %v4006 = load i64, ptr %v621, align 8, !noalias !532
  %v4007 = icmp eq i64 %v4006, %v4003
  br i1 %v4007, label %v4008, label %v4009

v4008:
  %v4010 = load double, ptr %v623, align 8, !noalias !532
  %v4011 = fmul double %v4010, 1.000000e-03
  br label %v4009

v4009:
  %v4012 = phi double [ %v4011, %v4008 ], [ 0.000000e+00, %v4005 ]
  store double %v4012, ptr %v4013, align 8, !noalias !532
  br i1 %v599, label %v4014, label %v4015

v4016:
  %v4017 = phi i64 [ %v4018, %v4016 ], [ 0, %v4004 ]
  %v4018 = add nsw i64 %v4017, 1
  %v4019 = mul i64 %v4017, %v196
  %v4020 = getelementptr double, ptr %v193, i64 %v4019
  %v4021 = load double, ptr %v4020, align 8, !noalias !532
  %v4022 = tail call double @llvm.fabs.f64(double %v4021)
  %v4023 = fcmp ogt double %v4024, %v4022
  %v4025 = select i1 %v4023, double %v4024, double %v4022
  %v4026 = fcmp ogt double %v4025, 0.000000e+00
  %v4027 = fmul double %v4025, 1.200000e-05
  %v4028 = select i1 %v4026, double %v4027, double 1.200000e-05
  %v4029 = getelementptr i64, ptr %v266, i64 %v4017
  %v4030 = load i64, ptr %v4029, align 8, !noalias !532
  %v4031 = icmp eq i64 %v4030, %v4003
  %v4032 = select i1 %v4031, double %v4028, double 0.000000e+00
  %v4033 = getelementptr double, ptr %v4034, i64 %v4017
  store double %v4032, ptr %v4033, align 8, !noalias !532
  %v4035 = icmp eq i64 %v10, %v4018
  br i1 %v4035, label %v4005, label %v4016

v4036:
  %v4037 = getelementptr double, ptr %v637, i64 %v4038
  store double %v4039, ptr %v4037, align 8, !noalias !538
  br label %v4040

v4041:
  %v4042 = select i1 %v4043, i64 %v295, i64 0
  %v4044 = getelementptr i64, ptr %v294, i64 %v4045
  %v4046 = getelementptr i64, ptr %v4044, i64 %v4042
  %v4047 = load i64, ptr %v4046, align 8, !noalias !538
  %v4048 = icmp slt i64 %v4047, 0
  %v4049 = select i1 %v4048, i64 %v223, i64 0
  %v4050 = getelementptr double, ptr %v222, i64 %v4047
  %v4051 = getelementptr double, ptr %v4050, i64 %v4049
  store double %v4039, ptr %v4051, align 8, !noalias !538
  br label %v4040

v4040:
  %v4052 = icmp sgt i64 %v4053, 1
  br i1 %v4052, label %v4054, label %v4001

v3998:
  %v4055 = phi i64 [ %v4056, %v3998 ], [ 0, %v3995 ]
  %v4056 = add nsw i64 %v4055, 1
  %v4057 = mul i64 %v4055, %v196
  %v4058 = getelementptr double, ptr %v193, i64 %v4057
  %v4059 = load double, ptr %v4058, align 8, !noalias !538
  %v4060 = getelementptr double, ptr %v602, i64 %v4057
  store double %v4059, ptr %v4060, align 8, !noalias !538
  %v4061 = getelementptr double, ptr %v604, i64 %v4057
  store double 0.000000e+00, ptr %v4061, align 8, !noalias !538
  %v4062 = icmp eq i64 %v10, %v4056
  br i1 %v4062, label %v3997, label %v3998

v4063:
  %v4064 = phi i64 [ %v159, %v4065 ], [ %v4066, %v4067 ]
  %v4068 = sub i64 %v4064, %v4069
  %v4070 = tail call i64 @llvm.smax.i64(i64 %v4068, i64 0)
  %v4034 = getelementptr double, ptr %v158, i64 %v4069
  br i1 %v616, label %v4071, label %v3996

v4071:
  %v4072 = select i1 %v608, i64 %v4070, i64 0
  %v4073 = getelementptr double, ptr %v4034, i64 %v10
  %v4013 = getelementptr double, ptr %v4073, i64 %v4072
  br label %v4004

v3999:
  br label %v4000

v4000:
  %v4074 = phi i64 [ 0, %v3999 ], [ %v610, %v3997 ]
  br i1 %v612, label %v4075, label %v4076, !prof !131

v4076:
  br label %v4075

v4075:
  %v4069 = phi i64 [ %v159, %v4076 ], [ %v4074, %v4000 ]
  br i1 %v614, label %v4077, label %v4067, !prof !381

v4077:
  br label %v4067

v4067:
  %v4066 = phi i64 [ 0, %v4077 ], [ %v613, %v4075 ]
  br i1 %v615, label %v4063, label %v4065, !prof !131

v4065:
  br label %v4063

v4004:
  %v4003 = phi i64 [ 0, %v4071 ], [ %v4078, %v4001 ]
  %v4078 = add nsw i64 %v4003, 1
  %v4079 = load double, ptr %v618, align 8, !noalias !532
  %v4080 = load double, ptr %v23, align 8, !noalias !532
  %v4024 = fdiv double %v4079, %v4080
  br i1 %v599, label %v4005, label %v4016

v4081:
  %v4082 = load double, ptr %v133, align 8, !noalias !539
  %v4083 = load double, ptr %v4013, align 8, !noalias !539
  %v4084 = fmul double %v4083, 5.000000e-01
  %v4085 = fadd double %v4082, %v4084
  store double %v4085, ptr %v626, align 8, !noalias !539
  %v4086 = load i64, ptr %v6, align 8, !noalias !543
  %v4087 = inttoptr i64 %v4086 to ptr
  tail call void %v4087(ptr nonnull %v626, ptr %v629, ptr %v165, ptr %v172, ptr %v179, ptr %v639), !noalias !543
  br label %v4088

v4088:
  %v4089 = phi i64 [ %v4090, %v4088 ], [ 0, %v4081 ]
  %v4090 = add nsw i64 %v4089, 1
  %v4091 = mul i64 %v4089, %v196
  %v4092 = getelementptr double, ptr %v193, i64 %v4091
  %v4093 = load double, ptr %v4092, align 8, !noalias !539
  %v4094 = getelementptr double, ptr %v4034, i64 %v4089
  %v4095 = load double, ptr %v4094, align 8, !noalias !539
  %v4096 = fmul double %v4095, 5.000000e-01
  %v4097 = fsub double %v4093, %v4096
  %v4098 = getelementptr double, ptr %v630, i64 %v4091
  store double %v4097, ptr %v4098, align 8, !noalias !539
  %v4099 = icmp eq i64 %v10, %v4090
  br i1 %v4099, label %v4100, label %v4088

v4014:
  %v4101 = load double, ptr %v133, align 8, !noalias !539
  %v4102 = fmul double %v4012, 5.000000e-01
  %v4103 = fadd double %v4102, %v4101
  store double %v4103, ptr %v626, align 8, !noalias !539
  %v4104 = load i64, ptr %v6, align 8, !noalias !543
  %v4105 = inttoptr i64 %v4104 to ptr
  tail call void %v4105(ptr nonnull %v626, ptr %v629, ptr %v165, ptr %v172, ptr %v179, ptr %v641), !noalias !543
  br label %v4100

v4100:
  %v4106 = load double, ptr %v133, align 8, !noalias !539
  %v4107 = load double, ptr %v4013, align 8, !noalias !539
  %v4108 = fmul double %v4107, 5.000000e-01
  %v4109 = fsub double %v4106, %v4108
  store double %v4109, ptr %v626, align 8, !noalias !539
  %v4110 = load i64, ptr %v6, align 8, !noalias !543
  %v4111 = inttoptr i64 %v4110 to ptr
  tail call void %v4111(ptr nonnull %v626, ptr %v629, ptr %v165, ptr %v172, ptr %v179, ptr %v643), !noalias !543
  br i1 %v599, label %v4112, label %v4113

v4114:
  %v4115 = fsub double %v4116, %v4117
  br label %v4118

v4119:
  %v4120 = getelementptr double, ptr %v635, i64 %v4121
  %v4122 = load double, ptr %v4120, align 8, !noalias !539
  %v4123 = fsub double %v4116, %v4122
  %v4124 = fmul double %v4123, 2.000000e+00
  br label %v4118

v4118:
  %v4125 = phi double [ %v4124, %v4119 ], [ %v4115, %v4114 ]
  store double %v4125, ptr %v4126, align 8, !noalias !539
  %v4127 = icmp eq i64 %v10, %v4128
  br i1 %v4127, label %v4112, label %v4113

v4015:
  %v4129 = phi i64 [ %v4130, %v4015 ], [ 0, %v4009 ]
  %v4130 = add nsw i64 %v4129, 1
  %v4131 = mul i64 %v4129, %v196
  %v4132 = getelementptr double, ptr %v193, i64 %v4131
  %v4133 = load double, ptr %v4132, align 8, !noalias !539
  %v4134 = getelementptr double, ptr %v4034, i64 %v4129
  %v4135 = load double, ptr %v4134, align 8, !noalias !539
  %v4136 = fmul double %v4135, 5.000000e-01
  %v4137 = fadd double %v4133, %v4136
  %v4138 = getelementptr double, ptr %v630, i64 %v4131
  store double %v4137, ptr %v4138, align 8, !noalias !539
  %v4139 = icmp eq i64 %v10, %v4130
  br i1 %v4139, label %v4081, label %v4015

v4113:
  %v4140 = phi i64 [ %v4128, %v4118 ], [ 0, %v4100 ]
  %v4128 = add nsw i64 %v4140, 1
  %v4121 = mul i64 %v4140, %v196
  %v4141 = getelementptr double, ptr %v193, i64 %v4121
  %v4142 = load double, ptr %v4141, align 8, !noalias !539
  %v4143 = getelementptr double, ptr %v630, i64 %v4121
  store double %v4142, ptr %v4143, align 8, !noalias !539
  %v4126 = getelementptr double, ptr %v632, i64 %v4121
  %v4116 = load double, ptr %v4126, align 8, !noalias !539
  %v4144 = getelementptr double, ptr %v634, i64 %v4121
  %v4117 = load double, ptr %v4144, align 8, !noalias !539
  %v4145 = fsub double %v4117, %v4117
  %v4146 = fcmp oeq double %v4145, 0.000000e+00
  br i1 %v4146, label %v4114, label %v4119

v4112:
  %v4147 = getelementptr i64, ptr %v273, i64 %v4003
  %v4148 = load i64, ptr %v4147, align 8, !noalias !538
  %v4149 = getelementptr i8, ptr %v4147, i64 8
  %v4150 = load i64, ptr %v4149, align 8, !noalias !538
  %v4151 = sub i64 %v4150, %v4148
  %v4152 = icmp slt i64 %v4151, 1
  br i1 %v4152, label %v4001, label %v4054

v4054:
  %v4053 = phi i64 [ %v4153, %v4040 ], [ %v4151, %v4112 ]
  %v4045 = phi i64 [ %v4154, %v4040 ], [ %v4148, %v4112 ]
  %v4153 = add nsw i64 %v4053, -1
  %v4154 = add i64 %v4045, 1
  %v4043 = icmp slt i64 %v4045, 0
  %v4155 = select i1 %v4043, i64 %v281, i64 0
  %v4156 = getelementptr i64, ptr %v280, i64 %v4045
  %v4157 = getelementptr i64, ptr %v4156, i64 %v4155
  %v4158 = load i64, ptr %v4157, align 8, !noalias !538
  %v4159 = select i1 %v4043, i64 %v288, i64 0
  %v4160 = getelementptr i64, ptr %v287, i64 %v4045
  %v4161 = getelementptr i64, ptr %v4160, i64 %v4159
  %v4162 = load i64, ptr %v4161, align 8, !noalias !538
  %v4163 = icmp slt i64 %v4158, 0
  %v4164 = select i1 %v4163, i64 %v195, i64 0
  %v4165 = add i64 %v4164, %v4158
  %v4038 = mul i64 %v4165, %v196
  %v4166 = getelementptr double, ptr %v632, i64 %v4038
  %v4167 = load double, ptr %v4166, align 8, !noalias !538
  %v4168 = icmp slt i64 %v4162, 0
  %v4169 = select i1 %v4168, i64 %v4070, i64 0
  %v4170 = getelementptr double, ptr %v4034, i64 %v4162
  %v4171 = getelementptr double, ptr %v4170, i64 %v4169
  %v4172 = load double, ptr %v4171, align 8, !noalias !538
  %v4173 = fdiv double %v4167, %v4172
  %v4174 = fsub double %v4173, %v4173
  %v4175 = fcmp oeq double %v4174, 0.000000e+00
  %v4039 = select i1 %v4175, double %v4173, double 0.000000e+00
  %v4176 = icmp eq i64 %v4162, %v10
  br i1 %v4176, label %v4036, label %v4041

v3996:
  br i1 %v645, label %v4177, label %v3992

v4178:
  %v4179 = mul i64 %v4180, %v648
  %v4181 = icmp slt i64 %v4179, 0
  %v4182 = select i1 %v4181, i64 %v230, i64 0
  %v4183 = getelementptr double, ptr %v229, i64 %v4179
  %v4184 = getelementptr double, ptr %v4183, i64 %v4182
  %v4185 = load double, ptr %v4184, align 8, !noalias !528
  %v4186 = load double, ptr %v650, align 8, !noalias !528
  %v4187 = fadd double %v4185, %v4186
  store double %v4187, ptr %v4184, align 8, !noalias !528
  %v4188 = icmp eq i64 %v10, %v4189
  br i1 %v4188, label %v4190, label %v4177

v4191:
  %v4192 = icmp eq i64 %v4193, %v10
  br i1 %v4192, label %v3992, label %v4190

v4194:
  %v4195 = phi i64 [ %v4196, %v4190 ], [ %v4197, %v4198 ]
  %v4199 = getelementptr i64, ptr %v236, i64 %v4196
  store i64 %v4195, ptr %v4199, align 8, !noalias !546
  %v4200 = add nsw i64 %v4195, %v4201
  %v4202 = icmp slt i64 %v4200, 0
  %v4203 = select i1 %v4202, i64 %v230, i64 0
  %v4204 = getelementptr double, ptr %v229, i64 %v4200
  %v4205 = getelementptr double, ptr %v4204, i64 %v4203
  %v4206 = load double, ptr %v4205, align 8, !noalias !546
  %v4207 = load double, ptr %v4208, align 8, !noalias !546
  store double %v4206, ptr %v4208, align 8, !noalias !546
  store double %v4207, ptr %v4205, align 8, !noalias !546
  br i1 %v4209, label %v4210, label %v4211

v4210:
  %v4212 = sub i64 %v4213, %v4193
  %v4214 = icmp slt i64 %v4212, 1
  br i1 %v4214, label %v4191, label %v4215

v4216:
  %v4217 = icmp sgt i64 %v4218, 1
  br i1 %v4217, label %v4215, label %v4191

v4190:
  %v4196 = phi i64 [ %v4193, %v4191 ], [ 0, %v4178 ]
  %v4193 = add nsw i64 %v4196, 1
  %v4201 = mul nsw i64 %v4196, %v10
  %v4219 = add nsw i64 %v4196, %v253
  %v4220 = add nsw i64 %v4219, 1
  %v4221 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %v4220, i64 %v10)
  %v4222 = add i64 %v651, %v4219
  %v4213 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %v4222, i64 %v10)
  %v4223 = getelementptr double, ptr %v229, i64 %v4201
  %v4208 = getelementptr double, ptr %v4223, i64 %v4196
  %v4224 = sub i64 %v4221, %v4193
  %v4225 = tail call i64 @llvm.smax.i64(i64 %v4224, i64 0)
  %v4209 = icmp slt i64 %v4224, 1
  br i1 %v4209, label %v4194, label %v4226

v4226:
  %v4227 = load double, ptr %v4208, align 8, !noalias !546
  %v4228 = tail call double @llvm.fabs.f64(double %v4227)
  br label %v4198

v4198:
  %v4229 = phi i64 [ %v4197, %v4198 ], [ %v4196, %v4226 ]
  %v4230 = phi double [ %v4231, %v4198 ], [ %v4228, %v4226 ]
  %v4232 = phi i64 [ %v4233, %v4198 ], [ %v4225, %v4226 ]
  %v4234 = phi i64 [ %v4235, %v4198 ], [ %v4193, %v4226 ]
  %v4233 = add nsw i64 %v4232, -1
  %v4235 = add i64 %v4234, 1
  %v4236 = add nsw i64 %v4234, %v4201
  %v4237 = icmp slt i64 %v4236, 0
  %v4238 = select i1 %v4237, i64 %v230, i64 0
  %v4239 = getelementptr double, ptr %v229, i64 %v4236
  %v4240 = getelementptr double, ptr %v4239, i64 %v4238
  %v4241 = load double, ptr %v4240, align 8, !noalias !546
  %v4242 = tail call double @llvm.fabs.f64(double %v4241)
  %v4243 = fcmp ogt double %v4242, %v4230
  %v4231 = select i1 %v4243, double %v4242, double %v4230
  %v4197 = select i1 %v4243, i64 %v4234, i64 %v4229
  %v4244 = icmp sgt i64 %v4232, 1
  br i1 %v4244, label %v4198, label %v4194

v4211:
  %v4245 = phi i64 [ %v4246, %v4211 ], [ %v4225, %v4194 ]
  %v4247 = phi i64 [ %v4248, %v4211 ], [ %v4193, %v4194 ]
  %v4246 = add nsw i64 %v4245, -1
  %v4248 = add i64 %v4247, 1
  %v4249 = add nsw i64 %v4247, %v4201
  %v4250 = icmp slt i64 %v4249, 0
  %v4251 = select i1 %v4250, i64 %v230, i64 0
  %v4252 = getelementptr double, ptr %v229, i64 %v4249
  %v4253 = getelementptr double, ptr %v4252, i64 %v4251
  %v4254 = load double, ptr %v4253, align 8, !noalias !546
  %v4255 = load double, ptr %v4208, align 8, !noalias !546
  %v4256 = fdiv double %v4254, %v4255
  store double %v4256, ptr %v4253, align 8, !noalias !546
  %v4257 = icmp sgt i64 %v4245, 1
  br i1 %v4257, label %v4211, label %v4210

v4215:
  %v4218 = phi i64 [ %v4258, %v4216 ], [ %v4212, %v4210 ]
  %v4259 = phi i64 [ %v4260, %v4216 ], [ %v4193, %v4210 ]
  %v4258 = add nsw i64 %v4218, -1
  %v4260 = add i64 %v4259, 1
  %v4261 = mul nsw i64 %v4259, %v10
  %v4262 = add nsw i64 %v4261, %v4195
  %v4263 = icmp slt i64 %v4262, 0
  %v4264 = select i1 %v4263, i64 %v230, i64 0
  %v4265 = getelementptr double, ptr %v229, i64 %v4262
  %v4266 = getelementptr double, ptr %v4265, i64 %v4264
  %v4267 = load double, ptr %v4266, align 8, !noalias !546
  %v4268 = add nsw i64 %v4261, %v4196
  %v4269 = icmp slt i64 %v4268, 0
  %v4270 = select i1 %v4269, i64 %v230, i64 0
  %v4271 = getelementptr double, ptr %v229, i64 %v4268
  %v4272 = getelementptr double, ptr %v4271, i64 %v4270
  %v4273 = load double, ptr %v4272, align 8, !noalias !546
  store double %v4273, ptr %v4266, align 8, !noalias !546
  store double %v4267, ptr %v4272, align 8, !noalias !546
  %v4274 = fcmp oeq double %v4267, 0.000000e+00
  %v4275 = or i1 %v4209, %v4274
  br i1 %v4275, label %v4216, label %v4276

v4276:
  %v4277 = phi i64 [ %v4278, %v4276 ], [ %v4225, %v4215 ]
  %v4279 = phi i64 [ %v4280, %v4276 ], [ %v4193, %v4215 ]
  %v4278 = add nsw i64 %v4277, -1
  %v4280 = add i64 %v4279, 1
  %v4281 = add nsw i64 %v4279, %v4261
  %v4282 = icmp slt i64 %v4281, 0
  %v4283 = select i1 %v4282, i64 %v230, i64 0
  %v4284 = getelementptr double, ptr %v229, i64 %v4281
  %v4285 = getelementptr double, ptr %v4284, i64 %v4283
  %v4286 = load double, ptr %v4285, align 8, !noalias !546
  %v4287 = add nsw i64 %v4279, %v4201
  %v4288 = icmp slt i64 %v4287, 0
  %v4289 = select i1 %v4288, i64 %v230, i64 0
  %v4290 = getelementptr double, ptr %v229, i64 %v4287
  %v4291 = getelementptr double, ptr %v4290, i64 %v4289
  %v4292 = load double, ptr %v4291, align 8, !noalias !546
  %v4293 = fmul double %v4267, %v4292
  %v4294 = fsub double %v4286, %v4293
  store double %v4294, ptr %v4285, align 8, !noalias !546
  %v4295 = icmp sgt i64 %v4277, 1
  br i1 %v4295, label %v4276, label %v4216

v4177:
  %v4180 = phi i64 [ %v4189, %v4178 ], [ 0, %v3996 ]
  %v4189 = add nsw i64 %v4180, 1
  %v4296 = sub i64 %v4180, %v646
  %v4297 = tail call i64 @llvm.smax.i64(i64 %v4296, i64 0)
  %v4298 = add i64 %v647, %v4180
  %v4299 = tail call i64 @llvm.smin.i64(i64 %v4298, i64 %v10)
  %v4300 = sub i64 %v4299, %v4297
  %v4301 = icmp slt i64 %v4300, 1
  br i1 %v4301, label %v4178, label %v4302

v4302:
  %v4303 = mul nsw i64 %v4180, %v10
  br label %v4304

v4304:
  %v4305 = phi i64 [ %v4300, %v4302 ], [ %v4306, %v4304 ]
  %v4307 = phi i64 [ %v4297, %v4302 ], [ %v4308, %v4304 ]
  %v4306 = add nsw i64 %v4305, -1
  %v4308 = add i64 %v4307, 1
  %v4309 = add nsw i64 %v4307, %v4303
  %v4310 = icmp slt i64 %v4309, 0
  %v4311 = select i1 %v4310, i64 %v223, i64 0
  %v4312 = getelementptr double, ptr %v222, i64 %v4309
  %v4313 = getelementptr double, ptr %v4312, i64 %v4311
  %v4314 = load double, ptr %v4313, align 8, !noalias !528
  %v4315 = fneg double %v4314
  %v4316 = select i1 %v4310, i64 %v230, i64 0
  %v4317 = getelementptr double, ptr %v229, i64 %v4309
  %v4318 = getelementptr double, ptr %v4317, i64 %v4316
  store double %v4315, ptr %v4318, align 8, !noalias !528
  %v4319 = icmp sgt i64 %v4305, 1
  br i1 %v4319, label %v4304, label %v4178

v3992:
  br i1 %v655, label %v1353, label %v4320

v4321:
  br i1 %v661, label %v4322, label %v4323

v4323:
  %v4324 = mul i64 %v4325, %v662
  %v4326 = getelementptr double, ptr %v193, i64 %v4324
  br label %v4327

v4328:
  %v4329 = icmp slt i64 %v4330, 0
  %v4331 = select i1 %v4329, i64 %v251, i64 0
  %v4332 = getelementptr i64, ptr %v250, i64 %v4330
  %v4333 = getelementptr i64, ptr %v4332, i64 %v4331
  store i64 %v4334, ptr %v4333, align 8, !noalias !549
  %v4335 = add nsw i64 %v4330, 1
  br label %v4336

v4336:
  %v4337 = phi i64 [ %v4335, %v4328 ], [ %v4330, %v4338 ]
  %v4339 = icmp eq i64 %v10, %v4340
  br i1 %v4339, label %v4322, label %v4338

v4322:
  %v4341 = phi i64 [ 0, %v4321 ], [ %v4337, %v4336 ]
  %v4342 = icmp sgt i64 %v4341, 0
  %v4343 = icmp slt i64 %v4341, %v10
  %v4344 = and i1 %v4342, %v4343
  br i1 %v4344, label %v4345, label %v4346

v4345:
  %v4347 = phi i64 [ %v4348, %v4349 ], [ %v4341, %v4322 ]
  %v4350 = phi i64 [ %v4351, %v4349 ], [ 0, %v4322 ]
  %v4352 = getelementptr i64, ptr %v250, i64 %v4350
  %v4353 = load i64, ptr %v4352, align 8, !noalias !549
  %v4351 = add nsw i64 %v4350, 1
  %v4354 = sub nsw i64 %v4353, %v254
  %v4355 = tail call i64 @llvm.smax.i64(i64 %v4354, i64 0)
  %v4356 = add i64 %v669, %v4353
  %v4357 = tail call i64 @llvm.smin.i64(i64 %v4356, i64 %v10)
  %v4358 = sub i64 %v4357, %v4355
  %v4359 = icmp slt i64 %v4358, 1
  br i1 %v4359, label %v4349, label %v4360

v4360:
  %v4361 = mul nsw i64 %v4353, %v10
  br label %v4362

v4363:
  %v4364 = icmp slt i64 %v4365, 0
  %v4366 = select i1 %v4364, i64 %v244, i64 0
  %v4367 = getelementptr i64, ptr %v243, i64 %v4365
  %v4368 = getelementptr i64, ptr %v4367, i64 %v4366
  %v4369 = load i64, ptr %v4368, align 8, !noalias !549
  %v4370 = icmp eq i64 %v4369, 0
  br i1 %v4370, label %v4371, label %v4372

v4371:
  store i64 1, ptr %v4368, align 8, !noalias !549
  %v4373 = getelementptr i64, ptr %v250, i64 %v4374
  store i64 %v4365, ptr %v4373, align 8, !noalias !549
  %v4375 = add nsw i64 %v4374, 1
  br label %v4372

v4372:
  %v4376 = phi i64 [ %v4374, %v4363 ], [ %v4375, %v4371 ], [ %v4374, %v4362 ]
  %v4377 = icmp sgt i64 %v4378, 1
  br i1 %v4377, label %v4362, label %v4349

v4349:
  %v4348 = phi i64 [ %v4347, %v4345 ], [ %v4376, %v4372 ]
  %v4379 = icmp slt i64 %v4351, %v4348
  %v4380 = icmp slt i64 %v4348, %v10
  %v4381 = and i1 %v4379, %v4380
  br i1 %v4381, label %v4345, label %v4346

v4338:
  %v4330 = phi i64 [ %v4337, %v4336 ], [ 0, %v4327 ]
  %v4334 = phi i64 [ %v4340, %v4336 ], [ 0, %v4327 ]
  %v4340 = add nsw i64 %v4334, 1
  %v4382 = getelementptr double, ptr %v668, i64 %v4334
  %v4383 = load double, ptr %v4382, align 8, !noalias !549
  %v4384 = fcmp une double %v4383, 0.000000e+00
  %v4385 = getelementptr i64, ptr %v243, i64 %v4334
  %v4386 = zext i1 %v4384 to i64
  store i64 %v4386, ptr %v4385, align 8, !noalias !549
  br i1 %v4384, label %v4328, label %v4336

v4362:
  %v4374 = phi i64 [ %v4347, %v4360 ], [ %v4376, %v4372 ]
  %v4378 = phi i64 [ %v4358, %v4360 ], [ %v4387, %v4372 ]
  %v4365 = phi i64 [ %v4355, %v4360 ], [ %v4388, %v4372 ]
  %v4387 = add nsw i64 %v4378, -1
  %v4388 = add i64 %v4365, 1
  %v4389 = add nsw i64 %v4365, %v4361
  %v4390 = icmp slt i64 %v4389, 0
  %v4391 = select i1 %v4390, i64 %v223, i64 0
  %v4392 = getelementptr double, ptr %v222, i64 %v4389
  %v4393 = getelementptr double, ptr %v4392, i64 %v4391
  %v4394 = load double, ptr %v4393, align 8, !noalias !549
  %v4395 = fcmp une double %v4394, 0.000000e+00
  br i1 %v4395, label %v4363, label %v4372

v4396:
  %v4397 = select i1 %v4398, i64 %v195, i64 0
  %v4399 = add i64 %v4397, %v4400
  %v4401 = mul i64 %v4399, %v196
  %v4402 = getelementptr double, ptr %v673, i64 %v4401
  %v4403 = load double, ptr %v4402, align 8, !noalias !555
  br label %v4404

v4404:
  %v4405 = phi double [ %v4403, %v4396 ], [ 0.000000e+00, %v4406 ]
  %v4407 = mul i64 %v4408, %v196
  %v4409 = getelementptr double, ptr %v4410, i64 %v4407
  store double %v4405, ptr %v4409, align 8, !noalias !555
  %v4411 = icmp eq i64 %v10, %v4412
  br i1 %v4411, label %v4413, label %v4406

v4327:
  %v4414 = phi i64 [ 0, %v4323 ], [ %v4415, %v4327 ]
  %v4415 = add nsw i64 %v4414, 1
  %v4416 = mul i64 %v4414, %v196
  %v4417 = getelementptr double, ptr %v4326, i64 %v4416
  %v4418 = load double, ptr %v4417, align 8, !noalias !555
  %v4419 = getelementptr double, ptr %v664, i64 %v4416
  %v4420 = load double, ptr %v4419, align 8, !noalias !555
  %v4421 = fadd double %v4418, %v4420
  %v4422 = getelementptr i64, ptr %v259, i64 %v4414
  %v4423 = load i64, ptr %v4422, align 8, !noalias !555
  %v4424 = icmp slt i64 %v4423, 0
  %v4425 = select i1 %v4424, i64 %v195, i64 0
  %v4426 = add i64 %v4425, %v4423
  %v4427 = mul i64 %v4426, %v196
  %v4428 = getelementptr double, ptr %v666, i64 %v4427
  store double %v4421, ptr %v4428, align 8, !noalias !555
  %v4429 = icmp eq i64 %v10, %v4415
  br i1 %v4429, label %v4338, label %v4327

v4346:
  br i1 %v661, label %v4413, label %v4430

v4431:
  %v4432 = icmp eq i64 %v10, %v4433
  br i1 %v4432, label %v4434, label %v4430

v4435:
  %v4436 = icmp sgt i64 %v4437, 1
  br i1 %v4436, label %v4434, label %v4438

v4438:
  %v4439 = mul i64 %v674, %v4325
  %v4410 = getelementptr double, ptr %v193, i64 %v4439
  br label %v4406

v4430:
  %v4440 = phi i64 [ %v4433, %v4431 ], [ 0, %v4346 ]
  %v4433 = add nsw i64 %v4440, 1
  %v4441 = getelementptr i64, ptr %v236, i64 %v4440
  %v4442 = load i64, ptr %v4441, align 8, !noalias !556
  %v4443 = add nsw i64 %v4442, %v667
  %v4444 = icmp slt i64 %v4443, 0
  %v4445 = select i1 %v4444, i64 %v159, i64 0
  %v4446 = getelementptr double, ptr %v158, i64 %v4443
  %v4447 = getelementptr double, ptr %v4446, i64 %v4445
  %v4448 = load double, ptr %v4447, align 8, !noalias !556
  %v4449 = getelementptr double, ptr %v671, i64 %v4440
  %v4450 = load double, ptr %v4449, align 8, !noalias !556
  store double %v4450, ptr %v4447, align 8, !noalias !556
  store double %v4448, ptr %v4449, align 8, !noalias !556
  %v4451 = add i64 %v670, %v4440
  %v4452 = tail call i64 @llvm.smin.i64(i64 %v4451, i64 %v10)
  %v4453 = sub i64 %v4452, %v4433
  %v4454 = icmp slt i64 %v4453, 1
  br i1 %v4454, label %v4431, label %v4455

v4455:
  %v4456 = mul nsw i64 %v4440, %v10
  br label %v4457

v4457:
  %v4458 = phi i64 [ %v4453, %v4455 ], [ %v4459, %v4457 ]
  %v4460 = phi i64 [ %v4433, %v4455 ], [ %v4461, %v4457 ]
  %v4459 = add nsw i64 %v4458, -1
  %v4461 = add i64 %v4460, 1
  %v4462 = add nsw i64 %v4460, %v667
  %v4463 = icmp slt i64 %v4462, 0
  %v4464 = select i1 %v4463, i64 %v159, i64 0
  %v4465 = getelementptr double, ptr %v158, i64 %v4462
  %v4466 = getelementptr double, ptr %v4465, i64 %v4464
  %v4467 = load double, ptr %v4466, align 8, !noalias !556
  %v4468 = add nsw i64 %v4460, %v4456
  %v4469 = icmp slt i64 %v4468, 0
  %v4470 = select i1 %v4469, i64 %v230, i64 0
  %v4471 = getelementptr double, ptr %v229, i64 %v4468
  %v4472 = getelementptr double, ptr %v4471, i64 %v4470
  %v4473 = load double, ptr %v4472, align 8, !noalias !556
  %v4474 = fmul double %v4448, %v4473
  %v4475 = fsub double %v4467, %v4474
  store double %v4475, ptr %v4466, align 8, !noalias !556
  %v4476 = icmp sgt i64 %v4458, 1
  br i1 %v4476, label %v4457, label %v4431

v4434:
  %v4437 = phi i64 [ %v4477, %v4435 ], [ %v10, %v4431 ]
  %v4477 = add nsw i64 %v4437, -1
  %v4478 = add nsw i64 %v4477, %v667
  %v4479 = icmp slt i64 %v4478, 0
  %v4480 = select i1 %v4479, i64 %v159, i64 0
  %v4481 = getelementptr double, ptr %v158, i64 %v4478
  %v4482 = getelementptr double, ptr %v4481, i64 %v4480
  %v4483 = load double, ptr %v4482, align 8, !noalias !556
  %v4484 = mul nsw i64 %v4477, %v10
  %v4485 = add nsw i64 %v4484, %v4477
  %v4486 = icmp slt i64 %v4485, 0
  %v4487 = select i1 %v4486, i64 %v230, i64 0
  %v4488 = getelementptr double, ptr %v229, i64 %v4485
  %v4489 = getelementptr double, ptr %v4488, i64 %v4487
  %v4490 = load double, ptr %v4489, align 8, !noalias !556
  %v4491 = fdiv double %v4483, %v4490
  store double %v4491, ptr %v4482, align 8, !noalias !556
  %v4492 = sub i64 %v4477, %v672
  %v4493 = tail call i64 @llvm.smax.i64(i64 %v4492, i64 0)
  %v4494 = sub i64 %v4477, %v4493
  %v4495 = icmp slt i64 %v4494, 1
  br i1 %v4495, label %v4435, label %v4496

v4496:
  %v4497 = phi i64 [ %v4498, %v4496 ], [ %v4494, %v4434 ]
  %v4499 = phi i64 [ %v4500, %v4496 ], [ %v4493, %v4434 ]
  %v4498 = add nsw i64 %v4497, -1
  %v4500 = add i64 %v4499, 1
  %v4501 = add nsw i64 %v4499, %v667
  %v4502 = icmp slt i64 %v4501, 0
  %v4503 = select i1 %v4502, i64 %v159, i64 0
  %v4504 = getelementptr double, ptr %v158, i64 %v4501
  %v4505 = getelementptr double, ptr %v4504, i64 %v4503
  %v4506 = load double, ptr %v4505, align 8, !noalias !556
  %v4507 = add nsw i64 %v4499, %v4484
  %v4508 = icmp slt i64 %v4507, 0
  %v4509 = select i1 %v4508, i64 %v230, i64 0
  %v4510 = getelementptr double, ptr %v229, i64 %v4507
  %v4511 = getelementptr double, ptr %v4510, i64 %v4509
  %v4512 = load double, ptr %v4511, align 8, !noalias !556
  %v4513 = fmul double %v4491, %v4512
  %v4514 = fsub double %v4506, %v4513
  store double %v4514, ptr %v4505, align 8, !noalias !556
  %v4515 = icmp sgt i64 %v4497, 1
  br i1 %v4515, label %v4496, label %v4435

v4406:
  %v4408 = phi i64 [ 0, %v4438 ], [ %v4412, %v4404 ]
  %v4412 = add nsw i64 %v4408, 1
  %v4516 = getelementptr i64, ptr %v259, i64 %v4408
  %v4400 = load i64, ptr %v4516, align 8, !noalias !555
  %v4398 = icmp slt i64 %v4400, 0
  %v4517 = select i1 %v4398, i64 %v244, i64 0
  %v4518 = getelementptr i64, ptr %v243, i64 %v4400
  %v4519 = getelementptr i64, ptr %v4518, i64 %v4517
  %v4520 = load i64, ptr %v4519, align 8, !noalias !555
  %v4521 = icmp eq i64 %v4520, 0
  br i1 %v4521, label %v4404, label %v4396

v4413:
  %v4522 = icmp eq i64 %v4523, %v653
  br i1 %v4522, label %v1353, label %v4320

v1353:
  %v4524 = load i64, ptr %v675, align 8, !noalias !560
  %v4525 = inttoptr i64 %v4524 to ptr
  tail call void %v4525(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !560
  br i1 %v307, label %v1351, label %v1341

v4320:
  %v4523 = phi i64 [ %v4325, %v4413 ], [ 1, %v3992 ]
  %v4325 = add i64 %v4523, 1
  %v4526 = getelementptr i64, ptr %v6, i64 %v4523
  %v4527 = getelementptr i8, ptr %v4526, i64 104
  %v4528 = load i64, ptr %v4527, align 8, !noalias !563
  %v4529 = inttoptr i64 %v4528 to ptr
  tail call void %v4529(ptr %v133, ptr %v158, ptr %v165, ptr %v23, ptr %v179, ptr %v186), !noalias !563
  %v4530 = load i64, ptr %v6, align 8, !noalias !566
  %v4531 = mul nsw i64 %v4325, %v658
  %v4532 = getelementptr double, ptr %v158, i64 %v4531
  %v4533 = inttoptr i64 %v4530 to ptr
  tail call void %v4533(ptr %v657, ptr %v660, ptr %v165, ptr %v172, ptr %v179, ptr %v4532), !noalias !566
  br i1 %v596, label %v4321, label %v4413

v1341:
  %v1342 = phi i1 [ %v1348, %v1343 ], [ %v1329, %v1353 ]
  %v4534 = phi i1 [ %v1340, %v1343 ], [ false, %v1353 ]
  %v1350 = phi i64 [ %v4535, %v1343 ], [ %v308, %v1353 ]
  %v1336 = phi i64 [ %v4536, %v1343 ], [ 0, %v1353 ]
  %v4535 = add nsw i64 %v1350, -1
  %v4536 = add nsw i64 %v1336, 1
  br i1 %v4534, label %v1339, label %v1334

v1444:
  %v1454 = xor i1 %v1439, true
  %v4537 = xor i1 %v1440, true
  %v1456 = select i1 %v4537, i1 true, i1 %v702
  br label %v1357

v3120:
  store ptr %v3117, ptr %v1, align 8
  br label %v3983

v3119:
  %v4538 = select i1 %v1354, i1 %v1352, i1 false
  %v4539 = xor i1 %v4538, true
  %v4540 = or i1 %v307, %v4539
  br i1 %v4540, label %v3240, label %v3241

v3934:
  %v3935 = select i1 %v3558, i64 0, i64 %v1126
  br label %v1123

v3940:
  store i64 %v3939, ptr %v0, align 8
  br label %v3983
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc range(i32 0, 2) i32 @_ZN5pages12event_checks13find_crossingB3v65B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr noalias nonnull %v0, ptr noalias nonnull %v1, i64 %v2, ptr readonly %v3, i64 %v4, ptr %v5, i64 %v6, i64 %v7, ptr %v8, i64 %v9, ptr %v10, i64 %v11, ptr readonly %v12, i64 %v13, i64 %v14, i64 %v15, double %v16) unnamed_addr {
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
  %v72 = load double, ptr %v71, align 8, !noalias !569
  %v73 = getelementptr double, ptr %v64, i64 %v66
  %v74 = load double, ptr %v73, align 8, !noalias !569
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
  %v82 = getelementptr double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v65B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v81
  %v83 = getelementptr i8, ptr %v82, i64 72
  %v84 = load double, ptr %v83, align 8
  %v85 = fcmp ogt double %v84, %v16
  %v86 = select i1 %v85, double %v84, double %v16
  %v87 = getelementptr double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v65B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v79
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
  %v140 = load double, ptr %v139, align 8, !noalias !573
  %v141 = load double, ptr %v138, align 8, !noalias !573
  %v142 = fmul double %v141, 0x3FDDF27AAAADCB3A
  %v143 = fsub double %v140, %v142
  %v144 = getelementptr i8, ptr %v138, i64 %v115
  %v145 = load double, ptr %v144, align 8, !noalias !573
  %v146 = fmul double %v145, 0x3FEC575F1EBC4F2F
  %v147 = fsub double %v143, %v146
  %v148 = getelementptr i8, ptr %v138, i64 %v116
  %v149 = load double, ptr %v148, align 8, !noalias !573
  %v150 = fmul double %v149, 0x3FE1306AA3D795F4
  %v151 = fadd double %v147, %v150
  %v152 = getelementptr i8, ptr %v138, i64 %v117
  %v153 = load double, ptr %v152, align 8, !noalias !573
  %v154 = fmul double %v153, 0x3FCCB9F574BDCC3A
  %v155 = fsub double %v151, %v154
  %v156 = getelementptr i8, ptr %v138, i64 %v118
  %v157 = load double, ptr %v156, align 8, !noalias !573
  %v158 = fmul double %v157, 0x3FA4EAF2D6B11E79
  %v159 = fadd double %v155, %v158
  %v160 = tail call double @llvm.fabs.f64(double %v159)
  %v161 = fcmp ogt double %v160, 0.000000e+00
  %v162 = select i1 %v161, double %v160, double 0.000000e+00
  %v163 = getelementptr i8, ptr %v138, i64 %v119
  %v164 = load double, ptr %v163, align 8, !noalias !573
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
  %v179 = load double, ptr %v178, align 8, !noalias !573
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
  %v194 = load double, ptr %v193, align 8, !noalias !573
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
  %v209 = load double, ptr %v208, align 8, !noalias !580
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
  %v262 = load double, ptr %v261, align 8, !noalias !581
  %v263 = icmp slt i64 %v247, 0
  %v264 = select i1 %v263, i64 %v13, i64 0
  %v265 = add i64 %v264, %v247
  %v266 = mul i64 %v265, %v100
  %v267 = getelementptr double, ptr %v138, i64 %v266
  %v268 = load double, ptr %v267, align 8, !noalias !581
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
  %v279 = load double, ptr %v278, align 8, !noalias !581
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
  %v317 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v65B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v289
  %v318 = load double, ptr %v317, align 8
  %v319 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v65B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v314
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
  %v326 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v65B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v321
  %v327 = load double, ptr %v326, align 8
  %v328 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v65B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v324
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
  br i1 %v337, label %v134, label %v340, !prof !381

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
  br i1 %v350, label %v351, label %v38, !prof !131

v352:
  %v353 = fmul double %v98, 5.000000e-01
  store double 0.000000e+00, ptr %v31, align 8, !noalias !585
  %v354 = shl i64 %v9, 5
  %v355 = getelementptr i8, ptr %v8, i64 %v354
  store double 0.000000e+00, ptr %v355, align 8, !noalias !585
  %v356 = getelementptr double, ptr %v8, i64 %v9
  store double %v353, ptr %v356, align 8, !noalias !585
  %v357 = load i64, ptr %v10, align 8, !noalias !585
  %v358 = icmp slt i64 %v357, 0
  %v359 = select i1 %v358, i64 %v6, i64 0
  %v360 = add i64 %v359, %v357
  %v361 = mul i64 %v360, %v7
  %v362 = getelementptr i64, ptr %v5, i64 %v361
  %v363 = load i64, ptr %v362, align 8, !noalias !585
  %v364 = add nsw i64 %v363, -1
  store i64 %v364, ptr %v362, align 8, !noalias !585
  %v365 = load i64, ptr %v10, align 8, !noalias !585
  %v366 = icmp slt i64 %v365, 0
  %v367 = select i1 %v366, i64 %v6, i64 0
  %v368 = add i64 %v367, %v365
  %v369 = mul i64 %v368, %v7
  %v370 = getelementptr i64, ptr %v5, i64 %v369
  %v371 = getelementptr i8, ptr %v370, i64 24
  %v372 = load i64, ptr %v371, align 8, !noalias !585
  %v373 = add nsw i64 %v372, 1
  store i64 %v373, ptr %v371, align 8, !noalias !585
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
  %v402 = load double, ptr %v401, align 8, !noalias !588
  %v403 = getelementptr double, ptr %v395, i64 %v399
  %v404 = load double, ptr %v403, align 8, !noalias !588
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
  %v425 = load double, ptr %v424, align 8, !noalias !592
  %v426 = getelementptr double, ptr %v418, i64 %v422
  %v427 = load double, ptr %v426, align 8, !noalias !592
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
  %v434 = load double, ptr %v8, align 8, !noalias !596
  %v435 = tail call double @llvm.fabs.f64(double %v434)
  %v436 = fmul double %v435, 4.000000e-15
  %v437 = getelementptr double, ptr %v3, i64 %v4
  %v438 = getelementptr i8, ptr %v437, i64 -8
  %v439 = load double, ptr %v438, align 8, !noalias !596
  %v440 = load double, ptr %v3, align 8, !noalias !596
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
!105 = distinct !{!105, !106, !"_ZN5pages12time_stepper13handle_eventsB4v108B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb: %retptr"}
!106 = distinct !{!106, !"_ZN5pages12time_stepper13handle_eventsB4v108B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb"}
!107 = distinct !{!107, !106, !"_ZN5pages12time_stepper13handle_eventsB4v108B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb: %excinfo"}
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
!155 = distinct !{!155, !156, !"_ZN5pages14event_location13locate_eventsB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!156 = distinct !{!156, !"_ZN5pages14event_location13locate_eventsB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!157 = distinct !{!157, !156, !"_ZN5pages14event_location13locate_eventsB3v62B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!158 = !{!159, !161, !155, !157, !105, !107}
!159 = distinct !{!159, !160, !"_ZN5pages12event_checks12check_eventsB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!160 = distinct !{!160, !"_ZN5pages12event_checks12check_eventsB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!161 = distinct !{!161, !160, !"_ZN5pages12event_checks12check_eventsB3v63B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!162 = !{!163, !165, !166, !168, !159, !161, !155, !157, !105, !107}
!163 = distinct !{!163, !164, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!164 = distinct !{!164, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!165 = distinct !{!165, !164, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!166 = distinct !{!166, !167, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!167 = distinct !{!167, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!168 = distinct !{!168, !167, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!169 = !{!170, !172, !163, !165, !166, !168, !159, !161, !155, !157, !105, !107}
!170 = distinct !{!170, !171, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!171 = distinct !{!171, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!172 = distinct !{!172, !171, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!173 = !{!174, !166, !168, !159, !161, !155, !157, !105, !107}
!174 = distinct !{!174, !175, !"_ZN5pages13solver_layout6decideB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!175 = distinct !{!175, !"_ZN5pages13solver_layout6decideB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!176 = !{!177, !179, !180, !182, !159, !161, !155, !157, !105, !107}
!177 = distinct !{!177, !178, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!178 = distinct !{!178, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!179 = distinct !{!179, !178, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!180 = distinct !{!180, !181, !"_ZN5pages12event_checks9set_edgesB3v64B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!181 = distinct !{!181, !"_ZN5pages12event_checks9set_edgesB3v64B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!182 = distinct !{!182, !181, !"_ZN5pages12event_checks9set_edgesB3v64B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!183 = !{!180, !182, !159, !161, !155, !157, !105, !107}
!184 = !{!185, !187, !188, !190, !191, !155, !157, !105, !107}
!185 = distinct !{!185, !186, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!186 = distinct !{!186, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!187 = distinct !{!187, !186, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!188 = distinct !{!188, !189, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!189 = distinct !{!189, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!190 = distinct !{!190, !189, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!191 = distinct !{!191, !192, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29d: %retptr"}
!192 = distinct !{!192, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29d"}
!193 = !{!194, !196, !185, !187, !188, !190, !191, !155, !157, !105, !107}
!194 = distinct !{!194, !195, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!195 = distinct !{!195, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!196 = distinct !{!196, !195, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!197 = !{!198, !188, !190, !191, !155, !157, !105, !107}
!198 = distinct !{!198, !199, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!199 = distinct !{!199, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!200 = !{!188, !190, !191, !155, !157, !105, !107}
!201 = !{!202, !204, !191, !155, !157, !105, !107}
!202 = distinct !{!202, !203, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!203 = distinct !{!203, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!204 = distinct !{!204, !203, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!205 = !{!206, !208, !209, !211, !212, !214, !155, !157, !105, !107}
!206 = distinct !{!206, !207, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!207 = distinct !{!207, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!208 = distinct !{!208, !207, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!209 = distinct !{!209, !210, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!210 = distinct !{!210, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!211 = distinct !{!211, !210, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!212 = distinct !{!212, !213, !"_ZN5pages14event_location9stops_runB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d28Bracket_28float64_20x_204_29: %retptr"}
!213 = distinct !{!213, !"_ZN5pages14event_location9stops_runB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d28Bracket_28float64_20x_204_29"}
!214 = distinct !{!214, !213, !"_ZN5pages14event_location9stops_runB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d28Bracket_28float64_20x_204_29: %excinfo"}
!215 = !{!216, !218, !206, !208, !209, !211, !212, !214, !155, !157, !105, !107}
!216 = distinct !{!216, !217, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!217 = distinct !{!217, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!218 = distinct !{!218, !217, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!219 = !{!220, !209, !211, !212, !214, !155, !157, !105, !107}
!220 = distinct !{!220, !221, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!221 = distinct !{!221, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!222 = !{!209, !211, !212, !214, !155, !157, !105, !107}
!223 = !{!212, !214, !155, !157, !105, !107}
!224 = !{!225, !227, !228, !230, !231, !233, !212, !214, !155, !157, !105, !107}
!225 = distinct !{!225, !226, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!226 = distinct !{!226, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!227 = distinct !{!227, !226, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!228 = distinct !{!228, !229, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!229 = distinct !{!229, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!230 = distinct !{!230, !229, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!231 = distinct !{!231, !232, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!232 = distinct !{!232, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!233 = distinct !{!233, !232, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!234 = !{!228, !230, !231, !233, !212, !214, !155, !157, !105, !107}
!235 = !{!236, !231, !233, !212, !214, !155, !157, !105, !107}
!236 = distinct !{!236, !237, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!237 = distinct !{!237, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!238 = !{!231, !233, !212, !214, !155, !157, !105, !107}
!239 = !{!240, !242, !243, !245, !246, !212, !214, !155, !157, !105, !107}
!240 = distinct !{!240, !241, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!241 = distinct !{!241, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!242 = distinct !{!242, !241, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!243 = distinct !{!243, !244, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!244 = distinct !{!244, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!245 = distinct !{!245, !244, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!246 = distinct !{!246, !247, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29d: %retptr"}
!247 = distinct !{!247, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29d"}
!248 = !{!249, !251, !240, !242, !243, !245, !246, !212, !214, !155, !157, !105, !107}
!249 = distinct !{!249, !250, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!250 = distinct !{!250, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!251 = distinct !{!251, !250, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!252 = !{!253, !243, !245, !246, !212, !214, !155, !157, !105, !107}
!253 = distinct !{!253, !254, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!254 = distinct !{!254, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!255 = !{!243, !245, !246, !212, !214, !155, !157, !105, !107}
!256 = !{!257, !259, !246, !212, !214, !155, !157, !105, !107}
!257 = distinct !{!257, !258, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!258 = distinct !{!258, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!259 = distinct !{!259, !258, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!260 = !{!261, !263, !212, !214, !155, !157, !105, !107}
!261 = distinct !{!261, !262, !"_ZN5pages8segments19write_samples_untilB3v80B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!262 = distinct !{!262, !"_ZN5pages8segments19write_samples_untilB3v80B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!263 = distinct !{!263, !262, !"_ZN5pages8segments19write_samples_untilB3v80B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %excinfo"}
!264 = !{!265, !212, !214, !155, !157, !105, !107}
!265 = distinct !{!265, !266, !"_ZN5pages13solver_layout4failB3v81B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29: %retptr"}
!266 = distinct !{!266, !"_ZN5pages13solver_layout4failB3v81B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29"}
!267 = !{!268, !270, !261, !263, !212, !214, !155, !157, !105, !107}
!268 = distinct !{!268, !269, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!269 = distinct !{!269, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!270 = distinct !{!270, !269, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!271 = !{!272, !274, !212, !214, !155, !157, !105, !107}
!272 = distinct !{!272, !273, !"_ZN5pages12event_checks13first_crossedB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!273 = distinct !{!273, !"_ZN5pages12event_checks13first_crossedB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!274 = distinct !{!274, !273, !"_ZN5pages12event_checks13first_crossedB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!275 = !{!276, !278, !155, !157, !105, !107}
!276 = distinct !{!276, !277, !"_ZN5pages14event_location11pass_eventsB3v82B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29: %retptr"}
!277 = distinct !{!277, !"_ZN5pages14event_location11pass_eventsB3v82B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29"}
!278 = distinct !{!278, !277, !"_ZN5pages14event_location11pass_eventsB3v82B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29: %excinfo"}
!279 = !{!280, !282, !283, !285, !276, !278, !155, !157, !105, !107}
!280 = distinct !{!280, !281, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!281 = distinct !{!281, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!282 = distinct !{!282, !281, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!283 = distinct !{!283, !284, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!284 = distinct !{!284, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!285 = distinct !{!285, !284, !"_ZN5pages12event_checks15evaluate_pointsB3v52B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!286 = !{!287, !289, !280, !282, !283, !285, !276, !278, !155, !157, !105, !107}
!287 = distinct !{!287, !288, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!288 = distinct !{!288, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!289 = distinct !{!289, !288, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!290 = !{!291, !283, !285, !276, !278, !155, !157, !105, !107}
!291 = distinct !{!291, !292, !"_ZN5pages13solver_layout6decideB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!292 = distinct !{!292, !"_ZN5pages13solver_layout6decideB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!293 = !{!294, !276, !278, !155, !157, !105, !107}
!294 = distinct !{!294, !295, !"_ZN5pages13solver_layout10derivativeB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!295 = distinct !{!295, !"_ZN5pages13solver_layout10derivativeB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!296 = !{!297, !299, !300, !302, !303, !276, !278, !155, !157, !105, !107}
!297 = distinct !{!297, !298, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!298 = distinct !{!298, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!299 = distinct !{!299, !298, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!300 = distinct !{!300, !301, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!301 = distinct !{!301, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!302 = distinct !{!302, !301, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!303 = distinct !{!303, !304, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29d: %retptr"}
!304 = distinct !{!304, !"_ZN5pages14event_location6narrowB3v72B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2928Bracket_28float64_20x_204_29d"}
!305 = !{!306, !308, !297, !299, !300, !302, !303, !276, !278, !155, !157, !105, !107}
!306 = distinct !{!306, !307, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!307 = distinct !{!307, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!308 = distinct !{!308, !307, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!309 = !{!310, !300, !302, !303, !276, !278, !155, !157, !105, !107}
!310 = distinct !{!310, !311, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!311 = distinct !{!311, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!312 = !{!300, !302, !303, !276, !278, !155, !157, !105, !107}
!313 = !{!314, !316, !303, !276, !278, !155, !157, !105, !107}
!314 = distinct !{!314, !315, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!315 = distinct !{!315, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!316 = distinct !{!316, !315, !"_ZN5pages12event_checks14least_distanceB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!317 = !{!318, !320, !322, !276, !278, !155, !157, !105, !107}
!318 = distinct !{!318, !319, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!319 = distinct !{!319, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!320 = distinct !{!320, !321, !"_ZN5pages14event_location18exchange_decisionsB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %retptr"}
!321 = distinct !{!321, !"_ZN5pages14event_location18exchange_decisionsB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29"}
!322 = distinct !{!322, !321, !"_ZN5pages14event_location18exchange_decisionsB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %excinfo"}
!323 = !{!320, !322, !276, !278, !155, !157, !105, !107}
!324 = !{!325, !327, !328, !330, !331, !333, !276, !278, !155, !157, !105, !107}
!325 = distinct !{!325, !326, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!326 = distinct !{!326, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!327 = distinct !{!327, !326, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!328 = distinct !{!328, !329, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!329 = distinct !{!329, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!330 = distinct !{!330, !329, !"_ZN5pages14event_location13decide_withinB3v75B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!331 = distinct !{!331, !332, !"_ZN5pages14event_location12rates_changeB3v83B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!332 = distinct !{!332, !"_ZN5pages14event_location12rates_changeB3v83B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!333 = distinct !{!333, !332, !"_ZN5pages14event_location12rates_changeB3v83B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!334 = !{!335, !337, !325, !327, !328, !330, !331, !333, !276, !278, !155, !157, !105, !107}
!335 = distinct !{!335, !336, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!336 = distinct !{!336, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!337 = distinct !{!337, !336, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!338 = !{!339, !328, !330, !331, !333, !276, !278, !155, !157, !105, !107}
!339 = distinct !{!339, !340, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!340 = distinct !{!340, !"_ZN5pages13solver_layout6decideB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!341 = !{!328, !330, !331, !333, !276, !278, !155, !157, !105, !107}
!342 = !{!343, !345, !331, !333, !276, !278, !155, !157, !105, !107}
!343 = distinct !{!343, !344, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!344 = distinct !{!344, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!345 = distinct !{!345, !344, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!346 = !{!347, !349, !343, !345, !331, !333, !276, !278, !155, !157, !105, !107}
!347 = distinct !{!347, !348, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!348 = distinct !{!348, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!349 = distinct !{!349, !348, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!350 = !{!351, !353, !355, !331, !333, !276, !278, !155, !157, !105, !107}
!351 = distinct !{!351, !352, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!352 = distinct !{!352, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!353 = distinct !{!353, !354, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!354 = distinct !{!354, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!355 = distinct !{!355, !354, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!356 = !{!353, !355, !331, !333, !276, !278, !155, !157, !105, !107}
!357 = !{!358, !360, !362, !331, !333, !276, !278, !155, !157, !105, !107}
!358 = distinct !{!358, !359, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!359 = distinct !{!359, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!360 = distinct !{!360, !361, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!361 = distinct !{!361, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!362 = distinct !{!362, !361, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!363 = !{!360, !362, !331, !333, !276, !278, !155, !157, !105, !107}
!364 = !{!365, !331, !333, !276, !278, !155, !157, !105, !107}
!365 = distinct !{!365, !366, !"_ZN5pages13solver_layout10derivativeB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2814_29: %retptr"}
!366 = distinct !{!366, !"_ZN5pages13solver_layout10derivativeB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2814_29"}
!367 = !{!368, !370, !372, !331, !333, !276, !278, !155, !157, !105, !107}
!368 = distinct !{!368, !369, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!369 = distinct !{!369, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!370 = distinct !{!370, !371, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!371 = distinct !{!371, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!372 = distinct !{!372, !371, !"_ZN5pages14event_location18exchange_decisionsB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!373 = !{!374, !331, !333, !276, !278, !155, !157, !105, !107}
!374 = distinct !{!374, !375, !"_ZN5pages13solver_layout10derivativeB3v86B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2815_29: %retptr"}
!375 = distinct !{!375, !"_ZN5pages13solver_layout10derivativeB3v86B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2815_29"}
!376 = !{!377, !379, !331, !333, !276, !278, !155, !157, !105, !107}
!377 = distinct !{!377, !378, !"_ZN5pages14event_location12rates_differB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!378 = distinct !{!378, !"_ZN5pages14event_location12rates_differB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!379 = distinct !{!379, !378, !"_ZN5pages14event_location12rates_differB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!380 = !{!370, !372, !331, !333, !276, !278, !155, !157, !105, !107}
!381 = !{!"branch_weights", i32 1, i32 99}
!382 = !{!"branch_weights", i32 101, i32 99}
!383 = !{!384, !386, !155, !157, !105, !107}
!384 = distinct !{!384, !385, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!385 = distinct !{!385, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!386 = distinct !{!386, !385, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!387 = !{!388, !390, !391, !393, !155, !157, !105, !107}
!388 = distinct !{!388, !389, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!389 = distinct !{!389, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!390 = distinct !{!390, !389, !"_ZN5pages13solver_layout16put_state_withinB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!391 = distinct !{!391, !392, !"_ZN5pages14event_location8end_stepB3v89B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!392 = distinct !{!392, !"_ZN5pages14event_location8end_stepB3v89B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!393 = distinct !{!393, !392, !"_ZN5pages14event_location8end_stepB3v89B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!394 = !{!395, !397, !388, !390, !391, !393, !155, !157, !105, !107}
!395 = distinct !{!395, !396, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!396 = distinct !{!396, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!397 = distinct !{!397, !396, !"_ZN5pages13solver_layout11interpolateB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!398 = !{!391, !393, !155, !157, !105, !107}
!399 = !{!400, !391, !393, !155, !157, !105, !107}
!400 = distinct !{!400, !401, !"_ZN5pages13solver_layout10derivativeB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!401 = distinct !{!401, !"_ZN5pages13solver_layout10derivativeB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!402 = !{!403, !391, !393, !155, !157, !105, !107}
!403 = distinct !{!403, !404, !"_ZN5pages13solver_layout6decideB3v90B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_288_29: %retptr"}
!404 = distinct !{!404, !"_ZN5pages13solver_layout6decideB3v90B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_288_29"}
!405 = !{!406, !155, !157, !105, !107}
!406 = distinct !{!406, !407, !"_ZN5pages13solver_layout5retryB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!407 = distinct !{!407, !"_ZN5pages13solver_layout5retryB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!408 = !{!121, !123, !105, !107}
!409 = !{!410, !412, !121, !123, !105, !107}
!410 = distinct !{!410, !411, !"_ZN5pages12event_checks13error_betweenB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!411 = distinct !{!411, !"_ZN5pages12event_checks13error_betweenB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!412 = distinct !{!412, !411, !"_ZN5pages12event_checks13error_betweenB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!413 = !{!414}
!414 = distinct !{!414, !415, !"_ZN5pages12time_stepper13write_samplesB3v91B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29b: %retptr"}
!415 = distinct !{!415, !"_ZN5pages12time_stepper13write_samplesB3v91B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29b"}
!416 = !{!417, !419, !414}
!417 = distinct !{!417, !418, !"_ZN5pages8segments19write_samples_untilB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd: %retptr"}
!418 = distinct !{!418, !"_ZN5pages8segments19write_samples_untilB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd"}
!419 = distinct !{!419, !418, !"_ZN5pages8segments19write_samples_untilB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd: %excinfo"}
!420 = !{!421, !423, !417, !419, !414}
!421 = distinct !{!421, !422, !"_ZN5pages13solver_layout11interpolateB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd: %retptr"}
!422 = distinct !{!422, !"_ZN5pages13solver_layout11interpolateB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd"}
!423 = distinct !{!423, !422, !"_ZN5pages13solver_layout11interpolateB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd: %excinfo"}
!424 = !{!425}
!425 = distinct !{!425, !426, !"_ZN5pages13solver_layout7formulaB3v94B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %retptr"}
!426 = distinct !{!426, !"_ZN5pages13solver_layout7formulaB3v94B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29"}
!427 = !{!428, !430}
!428 = distinct !{!428, !429, !"_ZN5pages14event_location20restart_behind_eventB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!429 = distinct !{!429, !"_ZN5pages14event_location20restart_behind_eventB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!430 = distinct !{!430, !429, !"_ZN5pages14event_location20restart_behind_eventB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!431 = !{!432, !428, !430}
!432 = distinct !{!432, !433, !"_ZN5pages13solver_layout4failB3v81B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29: %retptr"}
!433 = distinct !{!433, !"_ZN5pages13solver_layout4failB3v81B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29"}
!434 = !{!435, !437}
!435 = distinct !{!435, !436, !"_ZN5pages8segments14at_segment_endB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!436 = distinct !{!436, !"_ZN5pages8segments14at_segment_endB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!437 = distinct !{!437, !438, !"_ZN5pages8segments11jump_statesB3v96B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!438 = distinct !{!438, !"_ZN5pages8segments11jump_statesB3v96B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!439 = !{!437}
!440 = !{!441, !443, !437}
!441 = distinct !{!441, !442, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!442 = distinct !{!442, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!443 = distinct !{!443, !442, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!444 = !{!445, !437}
!445 = distinct !{!445, !446, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!446 = distinct !{!446, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!447 = !{!448, !437}
!448 = distinct !{!448, !449, !"_ZN5pages8segments14at_segment_endB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!449 = distinct !{!449, !"_ZN5pages8segments14at_segment_endB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!450 = !{!451, !453, !437}
!451 = distinct !{!451, !452, !"_ZN5pages8segments11accept_jumpB3v98B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!452 = distinct !{!452, !"_ZN5pages8segments11accept_jumpB3v98B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!453 = distinct !{!453, !452, !"_ZN5pages8segments11accept_jumpB3v98B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!454 = !{!455, !451, !453, !437}
!455 = distinct !{!455, !456, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!456 = distinct !{!456, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!457 = !{!458, !460, !461, !463, !464, !466, !451, !453, !437}
!458 = distinct !{!458, !459, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!459 = distinct !{!459, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!460 = distinct !{!460, !459, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!461 = distinct !{!461, !462, !"_ZN5pages8segments13first_outsideB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2817_29: %retptr"}
!462 = distinct !{!462, !"_ZN5pages8segments13first_outsideB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2817_29"}
!463 = distinct !{!463, !462, !"_ZN5pages8segments13first_outsideB4v100B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2817_29: %excinfo"}
!464 = distinct !{!464, !465, !"_ZN5pages8segments12stop_outsideB3v99B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29: %retptr"}
!465 = distinct !{!465, !"_ZN5pages8segments12stop_outsideB3v99B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29"}
!466 = distinct !{!466, !465, !"_ZN5pages8segments12stop_outsideB3v99B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29: %excinfo"}
!467 = !{!461, !463, !464, !466, !451, !453, !437}
!468 = !{!469, !461, !463, !464, !466, !451, !453, !437}
!469 = distinct !{!469, !470, !"_ZN5pages13solver_layout10derivativeB4v101B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2814_29: %retptr"}
!470 = distinct !{!470, !"_ZN5pages13solver_layout10derivativeB4v101B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2814_29"}
!471 = !{!472, !461, !463, !464, !466, !451, !453, !437}
!472 = distinct !{!472, !473, !"_ZN5pages13solver_layout6decideB4v102B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_289_29: %retptr"}
!473 = distinct !{!473, !"_ZN5pages13solver_layout6decideB4v102B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_289_29"}
!474 = !{!475, !461, !463, !464, !466, !451, !453, !437}
!475 = distinct !{!475, !476, !"_ZN5pages13solver_layout6decideB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29: %retptr"}
!476 = distinct !{!476, !"_ZN5pages13solver_layout6decideB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2810_29"}
!477 = !{!464, !466, !451, !453, !437}
!478 = !{!479, !464, !466, !451, !453, !437}
!479 = distinct !{!479, !480, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!480 = distinct !{!480, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!481 = !{!482, !484}
!482 = distinct !{!482, !483, !"_ZN5pages12time_stepper12end_segmentsB4v103B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!483 = distinct !{!483, !"_ZN5pages12time_stepper12end_segmentsB4v103B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!484 = distinct !{!484, !483, !"_ZN5pages12time_stepper12end_segmentsB4v103B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!485 = !{!486, !482, !484}
!486 = distinct !{!486, !487, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!487 = distinct !{!487, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!488 = !{!489, !491, !482, !484}
!489 = distinct !{!489, !490, !"_ZN5pages12time_stepper10check_paceB4v104B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xxx: %retptr"}
!490 = distinct !{!490, !"_ZN5pages12time_stepper10check_paceB4v104B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xxx"}
!491 = distinct !{!491, !490, !"_ZN5pages12time_stepper10check_paceB4v104B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xxx: %excinfo"}
!492 = !{!493, !489, !491, !482, !484}
!493 = distinct !{!493, !494, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!494 = distinct !{!494, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!495 = !{!496, !489, !491, !482, !484}
!496 = distinct !{!496, !497, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!497 = distinct !{!497, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!498 = !{!499, !501, !482, !484}
!499 = distinct !{!499, !500, !"_ZN5pages8segments13enter_segmentB4v105B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!500 = distinct !{!500, !"_ZN5pages8segments13enter_segmentB4v105B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!501 = distinct !{!501, !500, !"_ZN5pages8segments13enter_segmentB4v105B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!502 = !{!503, !505, !499, !501, !482, !484}
!503 = distinct !{!503, !504, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!504 = distinct !{!504, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!505 = distinct !{!505, !504, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!506 = !{!507, !482, !484}
!507 = distinct !{!507, !508, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!508 = distinct !{!508, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!509 = !{!510, !512, !507, !482, !484}
!510 = distinct !{!510, !511, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!511 = distinct !{!511, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!512 = distinct !{!512, !511, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!513 = !{!514, !516, !507, !482, !484}
!514 = distinct !{!514, !515, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!515 = distinct !{!515, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!516 = distinct !{!516, !515, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!517 = !{!518, !520, !482, !484}
!518 = distinct !{!518, !519, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!519 = distinct !{!519, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!520 = distinct !{!520, !519, !"_ZN5pages8segments14note_next_stopB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!521 = !{!522, !524}
!522 = distinct !{!522, !523, !"_ZN5pages12time_stepper11count_stepsB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!523 = distinct !{!523, !"_ZN5pages12time_stepper11count_stepsB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!524 = distinct !{!524, !523, !"_ZN5pages12time_stepper11count_stepsB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!525 = !{!526, !88, !90}
!526 = distinct !{!526, !527, !"_ZN5pages13solver_layout10derivativeB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_281_29: %retptr"}
!527 = distinct !{!527, !"_ZN5pages13solver_layout10derivativeB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_281_29"}
!528 = !{!529, !531, !88, !90}
!529 = distinct !{!529, !530, !"_ZN5pages8implicit13factor_matrixB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!530 = distinct !{!530, !"_ZN5pages8implicit13factor_matrixB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!531 = distinct !{!531, !530, !"_ZN5pages8implicit13factor_matrixB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!532 = !{!533, !535, !536, !529, !531, !88, !90}
!533 = distinct !{!533, !534, !"_ZN5pages8implicit11set_changesB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!534 = distinct !{!534, !"_ZN5pages8implicit11set_changesB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE"}
!535 = distinct !{!535, !534, !"_ZN5pages8implicit11set_changesB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!536 = distinct !{!536, !537, !"_ZN5pages8implicit13differentiateB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!537 = distinct !{!537, !"_ZN5pages8implicit13differentiateB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!538 = !{!536, !529, !531, !88, !90}
!539 = !{!540, !542, !536, !529, !531, !88, !90}
!540 = distinct !{!540, !541, !"_ZN5pages8implicit16difference_ratesB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!541 = distinct !{!541, !"_ZN5pages8implicit16difference_ratesB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!542 = distinct !{!542, !541, !"_ZN5pages8implicit16difference_ratesB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!543 = !{!544, !540, !542, !536, !529, !531, !88, !90}
!544 = distinct !{!544, !545, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!545 = distinct !{!545, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!546 = !{!547, !529, !531, !88, !90}
!547 = distinct !{!547, !548, !"_ZN5pages8implicit6factorB3v36B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!548 = distinct !{!548, !"_ZN5pages8implicit6factorB3v36B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!549 = !{!550, !552, !553, !88, !90}
!550 = distinct !{!550, !551, !"_ZN5pages8implicit12find_nonzeroB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx450Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!551 = distinct !{!551, !"_ZN5pages8implicit12find_nonzeroB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx450Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedEx"}
!552 = distinct !{!552, !551, !"_ZN5pages8implicit12find_nonzeroB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx450Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_295ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!553 = distinct !{!553, !554, !"_ZN5pages8implicit11solve_stageB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!554 = distinct !{!554, !"_ZN5pages8implicit11solve_stageB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!555 = !{!553, !88, !90}
!556 = !{!557, !559, !553, !88, !90}
!557 = distinct !{!557, !558, !"_ZN5pages8implicit5solveB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!558 = distinct !{!558, !"_ZN5pages8implicit5solveB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!559 = distinct !{!559, !558, !"_ZN5pages8implicit5solveB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!560 = !{!561, !88, !90}
!561 = distinct !{!561, !562, !"_ZN5pages13solver_layout7formulaB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_286_29: %retptr"}
!562 = distinct !{!562, !"_ZN5pages13solver_layout7formulaB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_286_29"}
!563 = !{!564, !88, !90}
!564 = distinct !{!564, !565, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!565 = distinct !{!565, !"_ZN5pages13solver_layout7formulaB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!566 = !{!567, !88, !90}
!567 = distinct !{!567, !568, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!568 = distinct !{!568, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!569 = !{!570, !572}
!570 = distinct !{!570, !571, !"_ZN5pages12event_checks13first_crossedB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!571 = distinct !{!571, !"_ZN5pages12event_checks13first_crossedB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!572 = distinct !{!572, !571, !"_ZN5pages12event_checks13first_crossedB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!573 = !{!574, !576, !577, !579}
!574 = distinct !{!574, !575, !"_ZN5pages12event_checks13error_betweenB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!575 = distinct !{!575, !"_ZN5pages12event_checks13error_betweenB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!576 = distinct !{!576, !575, !"_ZN5pages12event_checks13error_betweenB3v57B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!577 = distinct !{!577, !578, !"_ZN5pages12event_checks8may_hideB3v69B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd: %retptr"}
!578 = distinct !{!578, !"_ZN5pages12event_checks8may_hideB3v69B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd"}
!579 = distinct !{!579, !578, !"_ZN5pages12event_checks8may_hideB3v69B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd: %excinfo"}
!580 = !{!577, !579}
!581 = !{!582, !584, !577, !579}
!582 = distinct !{!582, !583, !"_ZN5pages12event_checks17least_distance_ofB3v70B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd: %retptr"}
!583 = distinct !{!583, !"_ZN5pages12event_checks17least_distance_ofB3v70B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd"}
!584 = distinct !{!584, !583, !"_ZN5pages12event_checks17least_distance_ofB3v70B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd: %excinfo"}
!585 = !{!586}
!586 = distinct !{!586, !587, !"_ZN5pages13solver_layout5retryB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!587 = distinct !{!587, !"_ZN5pages13solver_layout5retryB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!588 = !{!589, !591}
!589 = distinct !{!589, !590, !"_ZN5pages12event_checks14least_distanceB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!590 = distinct !{!590, !"_ZN5pages12event_checks14least_distanceB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!591 = distinct !{!591, !590, !"_ZN5pages12event_checks14least_distanceB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!592 = !{!593, !595}
!593 = distinct !{!593, !594, !"_ZN5pages12event_checks14least_distanceB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!594 = distinct !{!594, !"_ZN5pages12event_checks14least_distanceB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!595 = distinct !{!595, !594, !"_ZN5pages12event_checks14least_distanceB3v68B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!596 = !{!597, !599}
!597 = distinct !{!597, !598, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!598 = distinct !{!598, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!599 = distinct !{!599, !598, !"_ZN5pages12event_checks13shortest_stepB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1388Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2010_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}

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

; sha256 58ac77e6de8b15ae46cf36bd2d7f1965522ff3fcf253d4f009090ca212791a18 1121b504935a190685b7018490a5c83a2bc330084ae555caeed5caf33e3e38d5, Python 3.11, numba 0.68.1

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
@switch.table._ZN5pages12event_checks13find_crossingB3v59B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7 = private unnamed_addr constant [18 x double] [double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00, double 0.000000e+00, double 0x3FB48E8A71DE69AD, double 2.500000e-01, double 3.333000e-01, double 5.000000e-01, double 0x3FE50A3D70A3D70A, double 7.500000e-01, double 8.889000e-01, double 1.000000e+00], align 8

define dso_local range(i32 0, 2) i32 @advance_of_many(ptr noalias %v0, ptr noalias %v1, ptr readnone %v2, ptr readnone %v3, i64 %v4, i64 %v5, ptr readonly %v6, i64 %v7, i64 %v8, i64 %v9, i64 %v10, i64 %v11, i64 %v12, i64 %v13, i64 %v14, i64 %v15, i64 %v16, i64 %v17, i64 %v18, i64 %v19, ptr readnone %v20, ptr readnone %v21, i64 %v22, i64 %v23, ptr %v24, i64 %v25, i64 %v26, ptr readnone %v27, ptr readnone %v28, i64 %v29, i64 %v30, ptr readonly %v31, i64 %v32, i64 %v33, i64 %v34, i64 %v35, ptr readnone %v36, ptr readnone %v37, i64 %v38, i64 %v39, ptr readonly %v40, i64 %v41, i64 %v42, i64 %v43, i64 %v44, ptr readnone %v45, ptr readnone %v46, i64 %v47, i64 %v48, ptr readonly %v49, i64 %v50, i64 %v51, ptr readnone %v52, ptr readnone %v53, i64 %v54, i64 %v55, ptr readonly %v56, i64 %v57, i64 %v58, ptr readnone %v59, ptr readnone %v60, i64 %v61, i64 %v62, ptr readonly %v63, i64 %v64, i64 %v65, ptr readnone %v66, ptr readnone %v67, i64 %v68, i64 %v69, ptr readonly %v70, i64 %v71, i64 %v72, ptr readnone %v73, ptr readnone %v74, i64 %v75, i64 %v76, ptr readonly %v77, i64 %v78, i64 %v79, i64 %v80, i64 %v81, ptr readnone %v82, ptr readnone %v83, i64 %v84, i64 %v85, ptr readonly %v86, i64 %v87, i64 %v88, ptr readnone %v89, ptr readnone %v90, i64 %v91, i64 %v92, ptr readonly %v93, i64 %v94, i64 %v95, ptr readnone %v96, ptr readnone %v97, i64 %v98, i64 %v99, ptr %v100, i64 %v101, i64 %v102, i64 %v103, i64 %v104, i64 %v105, i64 %v106, ptr readnone %v107, ptr readnone %v108, i64 %v109, i64 %v110, ptr %v111, i64 %v112, i64 %v113, ptr readnone %v114, ptr readnone %v115, i64 %v116, i64 %v117, ptr %v118, i64 %v119, i64 %v120, ptr readnone %v121, ptr readnone %v122, i64 %v123, i64 %v124, ptr %v125, i64 %v126, i64 %v127, i64 %v128, i64 %v129, ptr readnone %v130, ptr readnone %v131, i64 %v132, i64 %v133, ptr %v134, i64 %v135, i64 %v136, i64 %v137, i64 %v138, ptr readnone %v139, ptr readnone %v140, i64 %v141, i64 %v142, ptr %v143, i64 %v144, i64 %v145, i64 %v146, i64 %v147, ptr readnone %v148, ptr readnone %v149, i64 %v150, i64 %v151, ptr %v152, i64 %v153, i64 %v154, ptr readnone %v155, ptr readnone %v156, i64 %v157, i64 %v158, ptr %v159, i64 %v160, i64 %v161, ptr readnone %v162, ptr readnone %v163, i64 %v164, i64 %v165, ptr %v166, i64 %v167, i64 %v168, ptr readnone %v169, ptr readnone %v170, i64 %v171, i64 %v172, ptr %v173, i64 %v174, i64 %v175, ptr readnone %v176, ptr readnone %v177, i64 %v178, i64 %v179, ptr %v180, i64 %v181, i64 %v182, ptr readnone %v183, ptr readnone %v184, i64 %v185, i64 %v186, ptr %v187, i64 %v188, i64 %v189, ptr readnone %v190, ptr readnone %v191, i64 %v192, i64 %v193, ptr %v194, i64 %v195, i64 %v196, i64 %v197, i64 %v198, i64 %v199, i64 %v200, ptr readnone %v201, ptr readnone %v202, i64 %v203, i64 %v204, ptr %v205, i64 %v206, i64 %v207, i64 %v208, i64 %v209, i64 %v210, i64 %v211, ptr readnone %v212, ptr readnone %v213, i64 %v214, i64 %v215, ptr %v216, i64 %v217, i64 %v218, ptr readnone %v219, ptr readnone %v220, i64 %v221, i64 %v222, ptr %v223, i64 %v224, i64 %v225, ptr readnone %v226, ptr readnone %v227, i64 %v228, i64 %v229, ptr %v230, i64 %v231, i64 %v232, i64 %v233, i64 %v234, ptr readnone %v235, ptr readnone %v236, i64 %v237, i64 %v238, ptr readonly %v239, i64 %v240, i64 %v241, ptr readnone %v242, ptr readnone %v243, i64 %v244, i64 %v245, ptr readonly %v246, i64 %v247, i64 %v248, ptr readnone %v249, ptr readnone %v250, i64 %v251, i64 %v252, ptr readonly %v253, i64 %v254, i64 %v255, ptr readnone %v256, ptr readnone %v257, i64 %v258, i64 %v259, ptr readonly %v260, i64 %v261, i64 %v262, ptr readnone %v263, ptr readnone %v264, i64 %v265, i64 %v266, ptr readonly %v267, i64 %v268, i64 %v269, ptr readnone %v270, ptr readnone %v271, i64 %v272, i64 %v273, ptr readonly %v274, i64 %v275, i64 %v276, i64 %v277, i64 %v278) local_unnamed_addr {
v279:
  %v280 = alloca i8, align 1
  %v281 = alloca ptr, align 8
  %v282 = alloca i8, align 1
  %v283 = alloca ptr, align 8
  %v284 = icmp sgt i64 %v16, 0
  %v285 = icmp sgt i64 %v19, 0
  %v286 = select i1 %v284, i1 true, i1 %v285
  %v287 = icmp slt i64 %v9, 1
  %v288 = select i1 %v287, i64 0, i64 %v9
  br i1 %v287, label %v289, label %v290

v290:
  %v291 = mul i64 %v136, 24
  %v292 = getelementptr i8, ptr %v134, i64 %v291
  %v293 = getelementptr i8, ptr %v152, i64 8
  %v294 = getelementptr i8, ptr %v152, i64 16
  %v295 = getelementptr i64, ptr %v143, i64 %v145
  %v296 = shl i64 %v145, 4
  %v297 = getelementptr i8, ptr %v143, i64 %v296
  %v298 = mul i64 %v145, 24
  %v299 = getelementptr i8, ptr %v143, i64 %v298
  %v300 = icmp slt i64 %v42, 1
  %v301 = icmp slt i64 %v64, 1
  %v302 = icmp slt i64 %v10, 1
  %v303 = mul i64 %v136, 248
  %v304 = getelementptr i8, ptr %v134, i64 %v303
  %v305 = mul i64 %v136, 240
  %v306 = getelementptr i8, ptr %v134, i64 %v305
  %v307 = mul i64 %v136, 232
  %v308 = getelementptr i8, ptr %v134, i64 %v307
  %v309 = shl i64 %v136, 4
  %v310 = shl i64 %v136, 5
  %v311 = mul i64 %v136, 40
  %v312 = mul i64 %v136, 48
  %v313 = mul i64 %v136, 56
  %v314 = shl i64 %v136, 6
  %v315 = mul i64 %v136, 72
  %v316 = mul i64 %v136, 80
  %v317 = mul i64 %v136, 88
  %v318 = mul i64 %v136, 96
  %v319 = mul i64 %v136, 104
  %v320 = mul i64 %v136, 112
  %v321 = mul i64 %v136, 120
  %v322 = shl i64 %v136, 7
  %v323 = mul i64 %v136, 136
  %v324 = mul i64 %v136, 144
  %v325 = mul i64 %v136, 152
  %v326 = mul i64 %v136, 160
  %v327 = mul i64 %v136, 168
  %v328 = mul i64 %v136, 176
  %v329 = mul i64 %v136, 184
  %v330 = mul i64 %v136, 192
  %v331 = mul i64 %v136, 200
  %v332 = mul i64 %v136, 208
  %v333 = mul i64 %v136, 216
  %v334 = mul i64 %v136, 224
  %v335 = getelementptr i8, ptr %v134, i64 %v321
  %v336 = getelementptr i8, ptr %v134, i64 %v334
  %v337 = getelementptr i8, ptr %v134, i64 %v309
  br label %v338

v339:
  %v340 = getelementptr double, ptr %v292, i64 %v341
  store double 0.000000e+00, ptr %v340, align 8, !noalias !0
  %v342 = load i64, ptr %v152, align 8, !noalias !0
  %v343 = load i64, ptr %v293, align 8, !noalias !0
  %v344 = icmp eq i64 %v342, %v343
  br i1 %v344, label %v345, label %v346

v346:
  %v347 = add nsw i64 %v342, 1
  store i64 %v347, ptr %v152, align 8, !noalias !0
  store i64 2, ptr %v294, align 8, !noalias !0
  %v348 = getelementptr i64, ptr %v143, i64 %v341
  store i64 %v342, ptr %v348, align 8, !noalias !0
  %v349 = icmp slt i64 %v342, 0
  %v350 = select i1 %v349, i64 %v50, i64 0
  %v351 = getelementptr i64, ptr %v49, i64 %v342
  %v352 = getelementptr i64, ptr %v351, i64 %v350
  %v353 = load i64, ptr %v352, align 8, !noalias !0
  %v354 = icmp slt i64 %v353, 0
  %v355 = select i1 %v354, i64 %v57, i64 0
  %v356 = getelementptr i64, ptr %v56, i64 %v353
  %v357 = getelementptr i64, ptr %v356, i64 %v355
  %v358 = load i64, ptr %v357, align 8, !noalias !0
  %v359 = getelementptr i64, ptr %v295, i64 %v341
  store i64 %v358, ptr %v359, align 8, !noalias !0
  %v360 = getelementptr i64, ptr %v297, i64 %v341
  store i64 1, ptr %v360, align 8, !noalias !0
  %v361 = getelementptr i64, ptr %v299, i64 %v341
  store i64 0, ptr %v361, align 8, !noalias !0
  br i1 %v300, label %v362, label %v363

v363:
  %v364 = select i1 %v349, i64 %v41, i64 0
  %v365 = add i64 %v364, %v342
  %v366 = mul i64 %v365, %v42
  %v367 = getelementptr double, ptr %v40, i64 %v366
  %v368 = getelementptr double, ptr %v166, i64 %v341
  br label %v369

v362:
  br i1 %v301, label %v370, label %v371

v371:
  %v372 = load i64, ptr %v359, align 8, !noalias !0
  %v373 = icmp slt i64 %v372, 0
  %v374 = select i1 %v373, i64 %v78, i64 0
  %v375 = add i64 %v374, %v372
  %v376 = mul i64 %v375, %v79
  %v377 = getelementptr double, ptr %v77, i64 %v376
  br label %v378

v378:
  %v379 = phi i64 [ 0, %v371 ], [ %v380, %v378 ]
  %v380 = add nsw i64 %v379, 1
  %v381 = getelementptr double, ptr %v377, i64 %v379
  %v382 = load double, ptr %v381, align 8, !noalias !3
  %v383 = getelementptr i64, ptr %v63, i64 %v379
  %v384 = load i64, ptr %v383, align 8, !noalias !3
  %v385 = mul nsw i64 %v384, %v9
  %v386 = add nsw i64 %v385, %v341
  %v387 = icmp slt i64 %v386, 0
  %v388 = select i1 %v387, i64 %v167, i64 0
  %v389 = getelementptr double, ptr %v166, i64 %v386
  %v390 = getelementptr double, ptr %v389, i64 %v388
  store double %v382, ptr %v390, align 8, !noalias !3
  %v391 = icmp eq i64 %v380, %v64
  br i1 %v391, label %v370, label %v378

v392:
  %v393 = getelementptr double, ptr %v134, i64 %v341
  %v394 = getelementptr double, ptr %v304, i64 %v341
  %v395 = load double, ptr %v394, align 8, !noalias !7
  %v396 = getelementptr double, ptr %v306, i64 %v341
  %v397 = load double, ptr %v396, align 8, !noalias !7
  %v398 = getelementptr double, ptr %v308, i64 %v341
  %v399 = load double, ptr %v398, align 8, !noalias !7
  store double 0.000000e+00, ptr %v393, align 8, !noalias !7
  %v400 = getelementptr double, ptr %v393, i64 %v136
  store double 0.000000e+00, ptr %v400, align 8, !noalias !7
  %v401 = getelementptr i8, ptr %v393, i64 %v309
  store double 0.000000e+00, ptr %v401, align 8, !noalias !7
  %v402 = getelementptr i8, ptr %v393, i64 %v291
  store double 0.000000e+00, ptr %v402, align 8, !noalias !7
  %v403 = getelementptr i8, ptr %v393, i64 %v310
  store double 0.000000e+00, ptr %v403, align 8, !noalias !7
  %v404 = getelementptr i8, ptr %v393, i64 %v311
  store double 0.000000e+00, ptr %v404, align 8, !noalias !7
  %v405 = getelementptr i8, ptr %v393, i64 %v312
  store double 0.000000e+00, ptr %v405, align 8, !noalias !7
  %v406 = getelementptr i8, ptr %v393, i64 %v313
  store double 0.000000e+00, ptr %v406, align 8, !noalias !7
  %v407 = getelementptr i8, ptr %v393, i64 %v314
  store double 0.000000e+00, ptr %v407, align 8, !noalias !7
  %v408 = getelementptr i8, ptr %v393, i64 %v315
  store double 0.000000e+00, ptr %v408, align 8, !noalias !7
  %v409 = getelementptr i8, ptr %v393, i64 %v316
  store double 0.000000e+00, ptr %v409, align 8, !noalias !7
  %v410 = getelementptr i8, ptr %v393, i64 %v317
  store double 0.000000e+00, ptr %v410, align 8, !noalias !7
  %v411 = getelementptr i8, ptr %v393, i64 %v318
  store double 0.000000e+00, ptr %v411, align 8, !noalias !7
  %v412 = getelementptr i8, ptr %v393, i64 %v319
  store double 0.000000e+00, ptr %v412, align 8, !noalias !7
  %v413 = getelementptr i8, ptr %v393, i64 %v320
  store double 0.000000e+00, ptr %v413, align 8, !noalias !7
  %v414 = getelementptr i8, ptr %v393, i64 %v321
  store double 0.000000e+00, ptr %v414, align 8, !noalias !7
  %v415 = getelementptr i8, ptr %v393, i64 %v322
  store double 0.000000e+00, ptr %v415, align 8, !noalias !7
  %v416 = getelementptr i8, ptr %v393, i64 %v323
  store double 0.000000e+00, ptr %v416, align 8, !noalias !7
  %v417 = getelementptr i8, ptr %v393, i64 %v324
  store double 0.000000e+00, ptr %v417, align 8, !noalias !7
  %v418 = getelementptr i8, ptr %v393, i64 %v325
  store double 0.000000e+00, ptr %v418, align 8, !noalias !7
  %v419 = getelementptr i8, ptr %v393, i64 %v326
  store double 0.000000e+00, ptr %v419, align 8, !noalias !7
  %v420 = getelementptr i8, ptr %v393, i64 %v327
  store double 0.000000e+00, ptr %v420, align 8, !noalias !7
  %v421 = getelementptr i8, ptr %v393, i64 %v328
  store double 0.000000e+00, ptr %v421, align 8, !noalias !7
  %v422 = getelementptr i8, ptr %v393, i64 %v329
  store double 0.000000e+00, ptr %v422, align 8, !noalias !7
  %v423 = getelementptr i8, ptr %v393, i64 %v330
  store double 0.000000e+00, ptr %v423, align 8, !noalias !7
  %v424 = getelementptr i8, ptr %v393, i64 %v331
  store double 0.000000e+00, ptr %v424, align 8, !noalias !7
  %v425 = getelementptr i8, ptr %v393, i64 %v332
  store double 0.000000e+00, ptr %v425, align 8, !noalias !7
  %v426 = getelementptr i8, ptr %v393, i64 %v333
  store double 0.000000e+00, ptr %v426, align 8, !noalias !7
  %v427 = getelementptr i8, ptr %v393, i64 %v334
  store double 0.000000e+00, ptr %v427, align 8, !noalias !7
  %v428 = getelementptr i8, ptr %v393, i64 %v307
  store double 0.000000e+00, ptr %v428, align 8, !noalias !7
  %v429 = getelementptr i8, ptr %v393, i64 %v305
  store double 0.000000e+00, ptr %v429, align 8, !noalias !7
  %v430 = getelementptr i8, ptr %v393, i64 %v303
  store double 0.000000e+00, ptr %v430, align 8, !noalias !7
  %v431 = fcmp oeq double %v399, 0xFFF0000000000000
  %v432 = select i1 %v431, double 0xFFF0000000000000, double 0.000000e+00
  store double %v432, ptr %v398, align 8, !noalias !7
  store double %v397, ptr %v396, align 8, !noalias !7
  store double %v395, ptr %v394, align 8, !noalias !7
  store double 1.000000e+00, ptr %v340, align 8, !noalias !7
  %v433 = getelementptr double, ptr %v335, i64 %v341
  store double 0xFFF0000000000000, ptr %v433, align 8, !noalias !7
  %v434 = getelementptr double, ptr %v336, i64 %v341
  store double 0x7FF0000000000000, ptr %v434, align 8, !noalias !7
  %v435 = load double, ptr %v93, align 8, !noalias !0
  store double %v435, ptr %v393, align 8, !noalias !0
  %v436 = load i64, ptr %v359, align 8, !noalias !0
  %v437 = icmp slt i64 %v436, 0
  %v438 = select i1 %v437, i64 %v71, i64 0
  %v439 = getelementptr double, ptr %v70, i64 %v436
  %v440 = getelementptr double, ptr %v439, i64 %v438
  %v441 = load double, ptr %v440, align 8, !noalias !0
  %v442 = getelementptr double, ptr %v337, i64 %v341
  store double %v441, ptr %v442, align 8, !noalias !0
  br label %v345

v369:
  %v443 = phi i64 [ 0, %v363 ], [ %v444, %v369 ]
  %v444 = add nsw i64 %v443, 1
  %v445 = getelementptr double, ptr %v367, i64 %v443
  %v446 = load double, ptr %v445, align 8, !noalias !0
  %v447 = mul nsw i64 %v443, %v9
  %v448 = getelementptr double, ptr %v368, i64 %v447
  store double %v446, ptr %v448, align 8, !noalias !0
  %v449 = icmp eq i64 %v444, %v42
  br i1 %v449, label %v362, label %v369

v370:
  br i1 %v302, label %v392, label %v450

v450:
  %v451 = getelementptr double, ptr %v194, i64 %v341
  %v452 = select i1 %v349, i64 %v32, i64 0
  %v453 = add i64 %v452, %v342
  %v454 = mul i64 %v453, %v33
  %v455 = getelementptr double, ptr %v31, i64 %v454
  br label %v456

v456:
  %v457 = phi i64 [ 0, %v450 ], [ %v458, %v456 ]
  %v458 = add nsw i64 %v457, 1
  %v459 = getelementptr double, ptr %v455, i64 %v457
  %v460 = load double, ptr %v459, align 8, !noalias !0
  %v461 = mul i64 %v457, %v197
  %v462 = getelementptr double, ptr %v451, i64 %v461
  store double %v460, ptr %v462, align 8, !noalias !0
  %v463 = icmp eq i64 %v458, %v10
  br i1 %v463, label %v392, label %v456

v345:
  %v464 = load i64, ptr %v465, align 8
  %v466 = icmp sgt i64 %v464, -1
  %v467 = zext i1 %v466 to i64
  %v468 = add nsw i64 %v469, %v467
  %v470 = icmp sgt i64 %v471, 1
  br i1 %v470, label %v338, label %v289

v289:
  %v472 = phi i64 [ 0, %v279 ], [ %v468, %v345 ]
  %v473 = icmp ne i64 %v472, 0
  %v474 = icmp sgt i64 %v277, 0
  %v475 = select i1 %v473, i1 %v474, i1 false
  br i1 %v475, label %v476, label %v477

v476:
  %v478 = getelementptr i8, ptr %v152, i64 16
  %v479 = mul i64 %v208, 72
  %v480 = mul i64 %v208, 72
  %v481 = mul i64 %v208, 72
  %v482 = mul i64 %v208, %v207
  %v483 = mul i64 %v197, 136
  %v484 = mul i64 %v208, 72
  %v485 = getelementptr i8, ptr %v6, i64 8
  %v486 = getelementptr i8, ptr %v6, i64 32
  %v487 = mul i64 %v136, 24
  %v488 = getelementptr i8, ptr %v134, i64 %v487
  %v489 = icmp sgt i64 %v19, 0
  %v490 = getelementptr i8, ptr %v6, i64 32
  %v491 = mul i64 %v136, 24
  %v492 = getelementptr i8, ptr %v134, i64 %v491
  %v493 = icmp slt i64 %v19, 1
  %v494 = icmp sgt i64 %v13, 0
  %v495 = mul nsw i64 %v10, %v9
  %v496 = shl i64 %v495, 4
  %v497 = getelementptr i8, ptr %v159, i64 %v496
  %v498 = getelementptr i8, ptr %v6, i64 56
  %v499 = getelementptr i8, ptr %v6, i64 64
  %v500 = shl i64 %v136, 6
  %v501 = getelementptr i8, ptr %v134, i64 %v500
  %v502 = mul i64 %v495, 136
  %v503 = getelementptr i8, ptr %v159, i64 %v502
  %v504 = mul i64 %v495, 24
  %v505 = getelementptr i8, ptr %v159, i64 %v504
  %v506 = getelementptr i8, ptr %v6, i64 72
  %v507 = mul i64 %v479, %v207
  %v508 = mul i64 %v136, 24
  %v509 = getelementptr i8, ptr %v134, i64 %v508
  %v510 = shl i64 %v136, 5
  %v511 = getelementptr i8, ptr %v134, i64 %v510
  %v512 = mul i64 %v136, 248
  %v513 = getelementptr i8, ptr %v134, i64 %v512
  %v514 = select i1 %v494, i64 2, i64 0
  %v515 = icmp slt i64 %v15, 1
  %v516 = zext i1 %v515 to i64
  %v517 = mul i64 %v136, 88
  %v518 = getelementptr i8, ptr %v134, i64 %v517
  %v519 = getelementptr i8, ptr %v6, i64 32
  %v520 = mul i64 %v208, 216
  %v521 = getelementptr i8, ptr %v187, i64 %v520
  %v522 = getelementptr i8, ptr %v205, i64 %v507
  %v523 = shl i64 %v145, 5
  %v524 = getelementptr i8, ptr %v143, i64 %v523
  %v525 = shl i64 %v136, 4
  %v526 = getelementptr i8, ptr %v134, i64 %v525
  %v527 = mul i64 %v136, 112
  %v528 = getelementptr i8, ptr %v134, i64 %v527
  %v529 = shl i64 %v136, 4
  %v530 = getelementptr i8, ptr %v134, i64 %v529
  %v531 = mul i64 %v136, 168
  %v532 = getelementptr i8, ptr %v134, i64 %v531
  %v533 = shl i64 %v145, 4
  %v534 = getelementptr i8, ptr %v143, i64 %v533
  %v535 = getelementptr i8, ptr %v6, i64 40
  %v536 = icmp eq i64 %v13, 0
  %v537 = mul nsw i64 %v10, %v9
  %v538 = getelementptr double, ptr %v159, i64 %v537
  %v539 = icmp sgt i64 %v14, 0
  %v540 = shl i64 %v136, 5
  %v541 = getelementptr i8, ptr %v134, i64 %v540
  %v542 = icmp slt i64 %v10, 1
  %v543 = mul i64 %v197, %v196
  %v544 = mul i64 %v543, 136
  %v545 = getelementptr i8, ptr %v194, i64 %v544
  %v546 = mul i64 %v543, 88
  %v547 = getelementptr i8, ptr %v194, i64 %v546
  %v548 = mul nsw i64 %v10, 19
  %v549 = add nsw i64 %v548, 1
  %v550 = mul nsw i64 %v10, 18
  %v551 = icmp slt i64 %v10, 0
  %v552 = select i1 %v551, i64 %v160, i64 0
  %v553 = add i64 %v552, %v550
  %v554 = icmp slt i64 %v553, 0
  %v555 = icmp slt i64 %v553, %v160
  %v556 = add i64 %v549, %v552
  %v557 = icmp slt i64 %v556, 0
  %v558 = icmp slt i64 %v556, %v160
  %v559 = icmp sgt i64 %v254, 1
  %v560 = mul i64 %v197, %v196
  %v561 = getelementptr i8, ptr %v24, i64 8
  %v562 = select i1 %v551, i64 %v247, i64 0
  %v563 = getelementptr i64, ptr %v246, i64 %v10
  %v564 = getelementptr i64, ptr %v563, i64 %v562
  %v565 = mul i64 %v136, 48
  %v566 = getelementptr i8, ptr %v134, i64 %v565
  %v567 = mul i64 %v560, 136
  %v568 = shl i64 %v136, 6
  %v569 = getelementptr i8, ptr %v134, i64 %v568
  %v570 = mul nsw i64 %v10, %v9
  %v571 = mul i64 %v570, 136
  %v572 = getelementptr i8, ptr %v159, i64 %v571
  %v573 = getelementptr i8, ptr %v194, i64 %v567
  %v574 = mul i64 %v560, 96
  %v575 = getelementptr i8, ptr %v194, i64 %v574
  %v576 = mul i64 %v560, 104
  %v577 = getelementptr i8, ptr %v194, i64 %v576
  %v578 = getelementptr double, ptr %v194, i64 %v560
  %v579 = mul i64 %v560, 88
  %v580 = getelementptr i8, ptr %v194, i64 %v579
  %v581 = mul i64 %v570, 96
  %v582 = getelementptr i8, ptr %v159, i64 %v581
  %v583 = mul i64 %v570, 96
  %v584 = getelementptr i8, ptr %v159, i64 %v583
  %v585 = mul i64 %v570, 104
  %v586 = getelementptr i8, ptr %v159, i64 %v585
  %v587 = add nsw i64 %v254, -2
  %v588 = icmp sgt i64 %v10, 0
  %v589 = add i64 %v234, %v233
  %v590 = add i64 %v233, 1
  %v591 = add i64 %v10, 1
  %v592 = mul i64 %v136, 160
  %v593 = getelementptr i8, ptr %v134, i64 %v592
  %v594 = add i64 %v234, 1
  %v595 = add i64 %v11, -1
  %v596 = tail call i64 @llvm.smax.i64(i64 %v595, i64 0)
  %v597 = icmp slt i64 %v595, 1
  %v598 = shl i64 %v136, 6
  %v599 = getelementptr i8, ptr %v134, i64 %v598
  %v600 = mul nsw i64 %v10, %v9
  %v601 = mul i64 %v600, 136
  %v602 = getelementptr i8, ptr %v159, i64 %v601
  %v603 = icmp sgt i64 %v10, 0
  %v604 = select i1 %v539, i1 %v603, i1 false
  %v605 = mul i64 %v197, %v196
  %v606 = mul i64 %v605, 80
  %v607 = getelementptr i8, ptr %v194, i64 %v606
  %v608 = mul i64 %v605, 136
  %v609 = getelementptr i8, ptr %v194, i64 %v608
  %v610 = mul nsw i64 %v10, 17
  %v611 = add i64 %v233, 1
  %v612 = getelementptr double, ptr %v159, i64 %v610
  %v613 = add i64 %v234, %v233
  %v614 = mul i64 %v197, %v196
  %v615 = mul i64 %v614, 136
  %v616 = getelementptr i8, ptr %v194, i64 %v615
  %v617 = getelementptr i8, ptr %v6, i64 48
  %v618 = or i1 %v539, %v286
  %v619 = mul i64 %v136, 40
  %v620 = getelementptr i8, ptr %v134, i64 %v619
  %v621 = mul i64 %v136, 184
  %v622 = getelementptr i8, ptr %v134, i64 %v621
  %v623 = mul i64 %v136, 192
  %v624 = getelementptr i8, ptr %v134, i64 %v623
  %v625 = mul i64 %v136, 200
  %v626 = getelementptr i8, ptr %v134, i64 %v625
  %v627 = mul i64 %v136, 176
  %v628 = getelementptr i8, ptr %v134, i64 %v627
  %v629 = shl i64 %v145, 4
  %v630 = getelementptr i8, ptr %v143, i64 %v629
  %v631 = mul i64 %v136, 208
  %v632 = getelementptr i8, ptr %v134, i64 %v631
  %v633 = mul i64 %v136, 72
  %v634 = getelementptr i8, ptr %v134, i64 %v633
  %v635 = mul i64 %v136, 40
  %v636 = getelementptr i8, ptr %v134, i64 %v635
  %v637 = mul i64 %v136, 56
  %v638 = getelementptr i8, ptr %v134, i64 %v637
  %v639 = mul i64 %v136, 232
  %v640 = getelementptr i8, ptr %v134, i64 %v639
  %v641 = icmp sgt i64 %v13, 0
  %v642 = icmp ne i64 %v14, 0
  %v643 = xor i1 %v641, true
  %v644 = select i1 %v643, i1 true, i1 %v642
  %v645 = shl i64 %v136, 6
  %v646 = getelementptr i8, ptr %v134, i64 %v645
  %v647 = mul nsw i64 %v10, %v9
  %v648 = mul i64 %v647, 136
  %v649 = getelementptr i8, ptr %v159, i64 %v648
  %v650 = mul i64 %v647, 104
  %v651 = getelementptr i8, ptr %v159, i64 %v650
  %v652 = getelementptr i8, ptr %v6, i64 104
  %v653 = getelementptr i8, ptr %v6, i64 96
  %v654 = mul i64 %v197, %v196
  %v655 = mul i64 %v136, 48
  %v656 = getelementptr i8, ptr %v134, i64 %v655
  %v657 = shl i64 %v136, 6
  %v658 = getelementptr i8, ptr %v134, i64 %v657
  %v659 = shl i64 %v654, 7
  %v660 = icmp slt i64 %v10, 1
  %v661 = getelementptr i8, ptr %v194, i64 %v659
  %v662 = mul i64 %v208, 3
  %v663 = getelementptr i8, ptr %v6, i64 32
  %v664 = mul i64 %v654, 192
  %v665 = mul i64 %v654, 184
  %v666 = mul i64 %v654, 176
  %v667 = mul i64 %v654, 168
  %v668 = mul i64 %v654, 160
  %v669 = mul i64 %v654, 152
  %v670 = mul i64 %v654, 144
  %v671 = mul i64 %v136, 56
  %v672 = getelementptr i8, ptr %v134, i64 %v671
  %v673 = tail call i64 @llvm.smax.i64(i64 %v208, i64 0)
  %v674 = mul i64 %v208, %v207
  %v675 = getelementptr double, ptr %v205, i64 %v208
  %v676 = mul i64 %v208, %v207
  %v677 = getelementptr double, ptr %v205, i64 %v208
  %v678 = getelementptr double, ptr %v205, i64 %v208
  %v679 = shl i64 %v208, 4
  %v680 = getelementptr i8, ptr %v205, i64 %v679
  %v681 = icmp sgt i64 %v12, 0
  %v682 = add nsw i64 %v11, 13
  %v683 = shl i64 %v136, 6
  %v684 = getelementptr i8, ptr %v134, i64 %v683
  %v685 = mul nsw i64 %v10, %v9
  %v686 = mul i64 %v685, 136
  %v687 = getelementptr i8, ptr %v159, i64 %v686
  %v688 = icmp slt i64 %v11, -13
  %v689 = select i1 %v688, i64 %v7, i64 0
  %v690 = getelementptr i64, ptr %v6, i64 %v11
  %v691 = getelementptr i8, ptr %v690, i64 104
  %v692 = getelementptr i64, ptr %v691, i64 %v689
  %v693 = getelementptr i8, ptr %v6, i64 88
  %v694 = shl i64 %v145, 4
  %v695 = getelementptr i8, ptr %v143, i64 %v694
  %v696 = mul i64 %v136, 40
  %v697 = getelementptr i8, ptr %v134, i64 %v696
  %v698 = mul i64 %v136, 56
  %v699 = getelementptr i8, ptr %v134, i64 %v698
  %v700 = mul i64 %v136, 216
  %v701 = getelementptr i8, ptr %v134, i64 %v700
  %v702 = mul i64 %v136, 48
  %v703 = getelementptr i8, ptr %v134, i64 %v702
  %v704 = shl i64 %v136, 5
  %v705 = getelementptr i8, ptr %v134, i64 %v704
  %v706 = getelementptr double, ptr %v134, i64 %v136
  %v707 = mul i64 %v136, 224
  %v708 = getelementptr i8, ptr %v134, i64 %v707
  %v709 = mul i64 %v197, %v196
  %v710 = mul i64 %v136, 48
  %v711 = getelementptr i8, ptr %v134, i64 %v710
  %v712 = shl i64 %v136, 6
  %v713 = getelementptr i8, ptr %v134, i64 %v712
  %v714 = shl i64 %v709, 7
  %v715 = icmp slt i64 %v10, 1
  %v716 = getelementptr i8, ptr %v194, i64 %v714
  %v717 = mul i64 %v208, 3
  %v718 = getelementptr i8, ptr %v6, i64 32
  %v719 = mul i64 %v709, 192
  %v720 = mul i64 %v709, 184
  %v721 = mul i64 %v709, 176
  %v722 = mul i64 %v709, 168
  %v723 = mul i64 %v709, 160
  %v724 = mul i64 %v709, 152
  %v725 = mul i64 %v709, 144
  %v726 = icmp slt i64 %v16, 1
  %v727 = mul i64 %v208, %v207
  %v728 = shl i64 %v208, 4
  %v729 = getelementptr i8, ptr %v205, i64 %v728
  %v730 = getelementptr double, ptr %v205, i64 %v208
  %v731 = shl i64 %v727, 4
  %v732 = mul i64 %v727, 24
  %v733 = shl i64 %v727, 5
  %v734 = mul i64 %v727, 40
  %v735 = mul i64 %v727, 48
  %v736 = mul i64 %v727, 56
  %v737 = shl i64 %v727, 6
  %v738 = mul i64 %v727, 72
  %v739 = mul i64 %v727, 80
  %v740 = mul i64 %v136, 104
  %v741 = getelementptr i8, ptr %v134, i64 %v740
  %v742 = getelementptr double, ptr %v93, i64 %v94
  %v743 = getelementptr i8, ptr %v742, i64 -8
  %v744 = mul i64 %v136, 56
  %v745 = getelementptr i8, ptr %v134, i64 %v744
  %v746 = icmp eq i64 %v16, 0
  %v747 = mul i64 %v136, 120
  %v748 = getelementptr i8, ptr %v134, i64 %v747
  %v749 = mul i64 %v136, 112
  %v750 = getelementptr i8, ptr %v134, i64 %v749
  %v751 = shl i64 %v136, 7
  %v752 = getelementptr i8, ptr %v134, i64 %v751
  %v753 = mul i64 %v136, 136
  %v754 = getelementptr i8, ptr %v134, i64 %v753
  %v755 = shl i64 %v10, 7
  %v756 = getelementptr i8, ptr %v159, i64 %v755
  %v757 = mul i64 %v208, 216
  %v758 = getelementptr i8, ptr %v187, i64 %v757
  %v759 = mul i64 %v208, %v207
  %v760 = mul i64 %v759, 72
  %v761 = icmp slt i64 %v208, 1
  %v762 = getelementptr i8, ptr %v205, i64 %v760
  %v763 = getelementptr double, ptr %v762, i64 %v208
  %v764 = shl i64 %v208, 4
  %v765 = getelementptr i8, ptr %v762, i64 %v764
  %v766 = mul i64 %v759, 80
  %v767 = getelementptr i8, ptr %v205, i64 %v766
  %v768 = tail call i64 @llvm.smax.i64(i64 %v10, i64 0)
  %v769 = mul nsw i64 %v10, %v9
  %v770 = shl i64 %v769, 7
  %v771 = getelementptr i8, ptr %v159, i64 %v770
  %v772 = mul i64 %v769, 112
  %v773 = getelementptr i8, ptr %v159, i64 %v772
  %v774 = getelementptr i8, ptr %v6, i64 8
  %v775 = mul i64 %v769, 120
  %v776 = getelementptr i8, ptr %v159, i64 %v775
  %v777 = getelementptr i8, ptr %v24, i64 8
  %v778 = mul i64 %v709, 120
  %v779 = getelementptr i8, ptr %v194, i64 %v778
  %v780 = mul i64 %v709, 112
  %v781 = getelementptr i8, ptr %v194, i64 %v780
  %v782 = mul i64 %v136, 40
  %v783 = getelementptr i8, ptr %v134, i64 %v782
  %v784 = icmp slt i64 %v19, 1
  %v785 = mul i64 %v759, 80
  %v786 = getelementptr i8, ptr %v205, i64 %v785
  %v787 = mul i64 %v769, 136
  %v788 = getelementptr i8, ptr %v159, i64 %v787
  %v789 = mul i64 %v769, 104
  %v790 = getelementptr i8, ptr %v159, i64 %v789
  %v791 = mul i64 %v136, 40
  %v792 = getelementptr i8, ptr %v134, i64 %v791
  %v793 = mul i64 %v136, 112
  %v794 = getelementptr i8, ptr %v134, i64 %v793
  %v795 = shl i64 %v136, 7
  %v796 = getelementptr i8, ptr %v134, i64 %v795
  %v797 = mul i64 %v136, 136
  %v798 = getelementptr i8, ptr %v134, i64 %v797
  %v799 = icmp sgt i64 %v10, 0
  %v800 = shl i64 %v10, 7
  %v801 = getelementptr i8, ptr %v159, i64 %v800
  %v802 = mul i64 %v208, 216
  %v803 = getelementptr i8, ptr %v187, i64 %v802
  %v804 = mul i64 %v480, %v207
  %v805 = icmp slt i64 %v208, 1
  %v806 = getelementptr i8, ptr %v205, i64 %v804
  %v807 = getelementptr double, ptr %v806, i64 %v208
  %v808 = shl i64 %v208, 4
  %v809 = getelementptr i8, ptr %v806, i64 %v808
  %v810 = select i1 %v805, i64 0, i64 %v208
  %v811 = mul i64 %v481, %v207
  %v812 = getelementptr i8, ptr %v205, i64 %v811
  %v813 = getelementptr double, ptr %v812, i64 %v208
  %v814 = getelementptr i8, ptr %v812, i64 %v808
  %v815 = shl i64 %v145, 5
  %v816 = getelementptr i8, ptr %v143, i64 %v815
  %v817 = mul i64 %v136, 40
  %v818 = getelementptr i8, ptr %v134, i64 %v817
  %v819 = mul i64 %v136, 96
  %v820 = getelementptr i8, ptr %v134, i64 %v819
  %v821 = mul i64 %v136, 216
  %v822 = getelementptr i8, ptr %v134, i64 %v821
  %v823 = mul i64 %v136, 40
  %v824 = getelementptr i8, ptr %v134, i64 %v823
  %v825 = shl i64 %v136, 5
  %v826 = getelementptr i8, ptr %v134, i64 %v825
  %v827 = getelementptr double, ptr %v134, i64 %v136
  %v828 = mul i64 %v709, 136
  %v829 = getelementptr i8, ptr %v194, i64 %v828
  %v830 = mul nsw i64 %v10, %v9
  %v831 = mul i64 %v830, 136
  %v832 = getelementptr i8, ptr %v159, i64 %v831
  %v833 = mul i64 %v830, 104
  %v834 = getelementptr i8, ptr %v159, i64 %v833
  %v835 = mul i64 %v10, 136
  %v836 = getelementptr i8, ptr %v159, i64 %v835
  %v837 = mul i64 %v208, 192
  %v838 = getelementptr i8, ptr %v187, i64 %v837
  %v839 = mul i64 %v103, %v102
  %v840 = mul i64 %v197, %v196
  %v841 = shl i64 %v145, 4
  %v842 = getelementptr i8, ptr %v143, i64 %v841
  %v843 = mul i64 %v136, 40
  %v844 = getelementptr i8, ptr %v134, i64 %v843
  %v845 = mul i64 %v136, 56
  %v846 = getelementptr i8, ptr %v134, i64 %v845
  %v847 = mul i64 %v136, 48
  %v848 = getelementptr i8, ptr %v134, i64 %v847
  %v849 = mul i64 %v840, 136
  %v850 = icmp slt i64 %v10, 1
  %v851 = mul i64 %v136, 224
  %v852 = getelementptr i8, ptr %v134, i64 %v851
  %v853 = getelementptr i8, ptr %v194, i64 %v849
  %v854 = add i64 %v94, -1
  %v855 = mul i64 %v840, 192
  %v856 = mul i64 %v840, 184
  %v857 = mul i64 %v840, 176
  %v858 = mul i64 %v840, 168
  %v859 = mul i64 %v840, 160
  %v860 = mul i64 %v840, 152
  %v861 = mul i64 %v840, 144
  %v862 = icmp sgt i64 %v9, 1
  %v863 = mul i64 %v136, 40
  %v864 = getelementptr i8, ptr %v134, i64 %v863
  %v865 = getelementptr i8, ptr %v6, i64 80
  %v866 = mul i64 %v136, 40
  %v867 = getelementptr i8, ptr %v134, i64 %v866
  %v868 = shl i64 %v482, 6
  %v869 = icmp sgt i64 %v19, 0
  %v870 = getelementptr i8, ptr %v205, i64 %v868
  %v871 = mul i64 %v136, 96
  %v872 = getelementptr i8, ptr %v134, i64 %v871
  %v873 = mul i64 %v136, 120
  %v874 = getelementptr i8, ptr %v134, i64 %v873
  %v875 = icmp slt i64 %v10, 1
  %v876 = getelementptr i8, ptr %v24, i64 8
  %v877 = getelementptr double, ptr %v93, i64 %v94
  %v878 = getelementptr i8, ptr %v877, i64 -8
  %v879 = mul i64 %v145, 24
  %v880 = getelementptr i8, ptr %v143, i64 %v879
  %v881 = mul i64 %v145, 24
  %v882 = getelementptr i8, ptr %v143, i64 %v881
  %v883 = mul i64 %v136, 24
  %v884 = getelementptr i8, ptr %v134, i64 %v883
  %v885 = icmp ne i64 %v17, 0
  %v886 = tail call i64 @llvm.smax.i64(i64 %v9, i64 0)
  %v887 = mul i64 %v136, 40
  %v888 = getelementptr i8, ptr %v134, i64 %v887
  %v889 = shl i64 %v136, 4
  %v890 = getelementptr i8, ptr %v134, i64 %v889
  %v891 = getelementptr i64, ptr %v143, i64 %v145
  %v892 = icmp slt i64 %v64, 1
  %v893 = getelementptr i8, ptr %v6, i64 8
  %v894 = getelementptr i8, ptr %v6, i64 24
  %v895 = mul i64 %v10, 136
  %v896 = mul i64 %v895, %v9
  %v897 = getelementptr i8, ptr %v159, i64 %v896
  %v898 = mul i64 %v103, %v102
  %v899 = add nsw i64 %v886, -1
  %v900 = shl i64 %v145, 4
  %v901 = getelementptr i8, ptr %v143, i64 %v900
  %v902 = mul i64 %v483, %v196
  %v903 = icmp slt i64 %v10, 1
  %v904 = getelementptr i8, ptr %v194, i64 %v902
  %v905 = getelementptr i8, ptr %v6, i64 32
  %v906 = getelementptr i8, ptr %v159, i64 %v895
  %v907 = mul i64 %v208, 216
  %v908 = getelementptr i8, ptr %v187, i64 %v907
  %v909 = mul i64 %v484, %v207
  %v910 = getelementptr i8, ptr %v205, i64 %v909
  %v911 = shl i64 %v145, 5
  %v912 = getelementptr i8, ptr %v143, i64 %v911
  %v913 = mul i64 %v136, 112
  %v914 = getelementptr i8, ptr %v134, i64 %v913
  %v915 = mul i64 %v136, 40
  %v916 = getelementptr i8, ptr %v134, i64 %v915
  %v917 = shl i64 %v136, 4
  %v918 = getelementptr i8, ptr %v134, i64 %v917
  %v919 = getelementptr i64, ptr %v143, i64 %v145
  %v920 = mul i64 %v136, 24
  %v921 = getelementptr i8, ptr %v134, i64 %v920
  %v922 = mul i64 %v136, 24
  %v923 = getelementptr i8, ptr %v134, i64 %v922
  %v924 = icmp slt i64 %v64, 1
  %v925 = shl i64 %v145, 4
  %v926 = getelementptr i8, ptr %v143, i64 %v925
  %v927 = mul i64 %v136, 24
  %v928 = getelementptr i8, ptr %v134, i64 %v927
  %v929 = getelementptr i8, ptr %v152, i64 8
  %v930 = getelementptr i64, ptr %v143, i64 %v145
  %v931 = mul i64 %v145, 24
  %v932 = getelementptr i8, ptr %v143, i64 %v931
  %v933 = icmp slt i64 %v42, 1
  %v934 = icmp slt i64 %v64, 1
  %v935 = icmp slt i64 %v10, 1
  %v936 = mul i64 %v136, 248
  %v937 = getelementptr i8, ptr %v134, i64 %v936
  %v938 = mul i64 %v136, 240
  %v939 = getelementptr i8, ptr %v134, i64 %v938
  %v940 = mul i64 %v136, 232
  %v941 = getelementptr i8, ptr %v134, i64 %v940
  %v942 = shl i64 %v136, 4
  %v943 = shl i64 %v136, 5
  %v944 = mul i64 %v136, 48
  %v945 = mul i64 %v136, 56
  %v946 = shl i64 %v136, 6
  %v947 = mul i64 %v136, 72
  %v948 = mul i64 %v136, 80
  %v949 = mul i64 %v136, 88
  %v950 = mul i64 %v136, 96
  %v951 = mul i64 %v136, 104
  %v952 = mul i64 %v136, 112
  %v953 = mul i64 %v136, 120
  %v954 = shl i64 %v136, 7
  %v955 = mul i64 %v136, 136
  %v956 = mul i64 %v136, 144
  %v957 = mul i64 %v136, 152
  %v958 = mul i64 %v136, 160
  %v959 = mul i64 %v136, 168
  %v960 = mul i64 %v136, 176
  %v961 = mul i64 %v136, 184
  %v962 = mul i64 %v136, 192
  %v963 = mul i64 %v136, 200
  %v964 = mul i64 %v136, 208
  %v965 = mul i64 %v136, 216
  %v966 = mul i64 %v136, 224
  %v967 = getelementptr i8, ptr %v134, i64 %v953
  %v968 = getelementptr i8, ptr %v134, i64 %v966
  %v969 = getelementptr i8, ptr %v134, i64 %v942
  %v970 = mul i64 %v136, 232
  %v971 = getelementptr i8, ptr %v134, i64 %v970
  %v972 = getelementptr double, ptr %v93, i64 %v94
  %v973 = getelementptr i8, ptr %v972, i64 -8
  %v974 = getelementptr double, ptr %v134, i64 %v136
  %v975 = mul i64 %v136, 232
  %v976 = getelementptr i8, ptr %v134, i64 %v975
  %v977 = mul i64 %v136, 176
  %v978 = getelementptr i8, ptr %v134, i64 %v977
  %v979 = shl i64 %v136, 4
  %v980 = getelementptr i8, ptr %v134, i64 %v979
  %v981 = mul i64 %v136, 168
  %v982 = getelementptr i8, ptr %v134, i64 %v981
  %v983 = shl i64 %v145, 4
  %v984 = getelementptr i8, ptr %v143, i64 %v983
  %v985 = shl i64 %v674, 4
  %v986 = mul i64 %v674, 24
  %v987 = shl i64 %v674, 5
  %v988 = mul i64 %v674, 40
  %v989 = mul i64 %v674, 48
  %v990 = mul i64 %v674, 56
  %v991 = shl i64 %v674, 6
  %v992 = shl i64 %v676, 4
  %v993 = shl i64 %v676, 5
  %v994 = mul i64 %v676, 48
  %v995 = shl i64 %v676, 6
  %v996 = mul i64 %v676, 24
  %v997 = shl i64 %v676, 4
  %v998 = shl i64 %v676, 5
  %v999 = mul i64 %v676, 48
  %v1000 = shl i64 %v676, 6
  %v1001 = mul i64 %v676, 40
  %v1002 = shl i64 %v676, 4
  %v1003 = shl i64 %v676, 5
  %v1004 = mul i64 %v676, 48
  %v1005 = shl i64 %v676, 6
  %v1006 = mul i64 %v676, 56
  %v1007 = shl i64 %v676, 4
  %v1008 = shl i64 %v676, 5
  %v1009 = mul i64 %v676, 48
  %v1010 = shl i64 %v676, 6
  br label %v1011

v1011:
  %v1012 = phi i64 [ %v1013, %v1014 ], [ %v277, %v476 ]
  %v1015 = phi i64 [ %v1016, %v1014 ], [ %v472, %v476 ]
  %v1017 = add nsw i64 %v1012, -1
  %v1018 = load i64, ptr %v478, align 8, !noalias !11
  %v1019 = icmp eq i64 %v1018, 0
  br i1 %v1019, label %v1020, label %v1021

v1021:
  %v1022 = icmp eq i64 %v1018, 2
  store i64 0, ptr %v478, align 8, !noalias !11
  %v1023 = load i64, ptr %v485, align 8, !noalias !15
  %v1024 = inttoptr i64 %v1023 to ptr
  tail call void %v1024(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !15
  br i1 %v285, label %v1025, label %v1026

v1025:
  %v1027 = load i64, ptr %v486, align 8, !noalias !18
  %v1028 = inttoptr i64 %v1027 to ptr
  tail call void %v1028(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !18
  %v1029 = load double, ptr %v488, align 8, !noalias !24
  %v1030 = fcmp une double %v1029, 2.500000e-01
  br i1 %v1030, label %v1026, label %v1031

v1031:
  store double 0.000000e+00, ptr %v488, align 8, !noalias !24
  br i1 %v489, label %v1032, label %v1033

v1034:
  store double 1.000000e+00, ptr %v488, align 8, !noalias !24
  br label %v1035

v1035:
  %v1036 = icmp eq i64 %v1037, %v19
  br i1 %v1036, label %v1033, label %v1032

v1033:
  %v1038 = load double, ptr %v488, align 8, !noalias !24
  %v1039 = fcmp ogt double %v1038, 5.000000e-01
  %v1040 = or i1 %v1022, %v1039
  br label %v1026

v1032:
  %v1041 = phi i64 [ %v1037, %v1035 ], [ 0, %v1031 ]
  %v1037 = add nsw i64 %v1041, 1
  %v1042 = getelementptr double, ptr %v205, i64 %v1041
  %v1043 = load double, ptr %v1042, align 8, !noalias !24
  %v1044 = add nsw i64 %v1041, %v18
  %v1045 = icmp slt i64 %v1044, 0
  %v1046 = select i1 %v1045, i64 %v167, i64 0
  %v1047 = getelementptr double, ptr %v166, i64 %v1044
  %v1048 = getelementptr double, ptr %v1047, i64 %v1046
  %v1049 = load double, ptr %v1048, align 8, !noalias !24
  %v1050 = fcmp une double %v1043, %v1049
  br i1 %v1050, label %v1034, label %v1035

v1026:
  %v1051 = phi i1 [ %v1022, %v1021 ], [ %v1040, %v1033 ], [ %v1022, %v1025 ]
  br i1 %v1051, label %v1052, label %v1020

v1052:
  br i1 %v285, label %v1053, label %v1054

v1053:
  %v1055 = load i64, ptr %v490, align 8, !noalias !25
  %v1056 = inttoptr i64 %v1055 to ptr
  tail call void %v1056(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !25
  %v1057 = load double, ptr %v492, align 8, !noalias !31
  %v1058 = fcmp ule double %v1057, 5.000000e-01
  %v1059 = select i1 %v1058, i1 true, i1 %v493
  br i1 %v1059, label %v1060, label %v1061

v1060:
  %v1062 = load i64, ptr %v485, align 8, !noalias !32
  %v1063 = inttoptr i64 %v1062 to ptr
  tail call void %v1063(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !32
  br label %v1054

v1061:
  %v1064 = phi i64 [ %v1065, %v1061 ], [ 0, %v1053 ]
  %v1065 = add nsw i64 %v1064, 1
  %v1066 = getelementptr double, ptr %v205, i64 %v1064
  %v1067 = load double, ptr %v1066, align 8, !noalias !31
  %v1068 = add nsw i64 %v1064, %v18
  %v1069 = icmp slt i64 %v1068, 0
  %v1070 = select i1 %v1069, i64 %v167, i64 0
  %v1071 = getelementptr double, ptr %v166, i64 %v1068
  %v1072 = getelementptr double, ptr %v1071, i64 %v1070
  store double %v1067, ptr %v1072, align 8, !noalias !31
  %v1073 = icmp eq i64 %v1065, %v19
  br i1 %v1073, label %v1060, label %v1061

v1054:
  br i1 %v494, label %v1074, label %v1075

v1074:
  %v1076 = load i64, ptr %v6, align 8, !noalias !35
  %v1077 = inttoptr i64 %v1076 to ptr
  tail call void %v1077(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v497), !noalias !35
  %v1078 = load i64, ptr %v498, align 8, !noalias !38
  %v1079 = inttoptr i64 %v1078 to ptr
  tail call void %v1079(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !38
  %v1080 = load i64, ptr %v499, align 8, !noalias !41
  %v1081 = inttoptr i64 %v1080 to ptr
  tail call void %v1081(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !41
  %v1082 = load i64, ptr %v6, align 8, !noalias !44
  %v1083 = inttoptr i64 %v1082 to ptr
  tail call void %v1083(ptr %v501, ptr %v503, ptr %v166, ptr %v173, ptr %v180, ptr %v505), !noalias !44
  %v1084 = load i64, ptr %v506, align 8, !noalias !47
  %v1085 = inttoptr i64 %v1084 to ptr
  tail call void %v1085(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !47
  br label %v1075

v1075:
  br i1 %v287, label %v1020, label %v1086

v1087:
  store double 0.000000e+00, ptr %v1088, align 8, !noalias !50
  %v1089 = getelementptr double, ptr %v511, i64 %v1090
  store double 0.000000e+00, ptr %v1089, align 8, !noalias !50
  %v1091 = getelementptr double, ptr %v513, i64 %v1090
  store double 0.000000e+00, ptr %v1091, align 8, !noalias !50
  %v1092 = getelementptr i64, ptr %v143, i64 %v1090
  %v1093 = load i64, ptr %v1092, align 8, !noalias !50
  %v1094 = icmp slt i64 %v1093, 0
  %v1095 = select i1 %v1094, i64 %v126, i64 0
  %v1096 = add i64 %v1095, %v1093
  %v1097 = mul i64 %v1096, %v127
  %v1098 = getelementptr i64, ptr %v125, i64 %v1097
  %v1099 = getelementptr i8, ptr %v1098, i64 8
  %v1100 = load i64, ptr %v1099, align 8, !noalias !50
  %v1101 = add nsw i64 %v1100, %v514
  store i64 %v1101, ptr %v1099, align 8, !noalias !50
  %v1102 = load i64, ptr %v1092, align 8, !noalias !50
  %v1103 = icmp slt i64 %v1102, 0
  %v1104 = select i1 %v1103, i64 %v126, i64 0
  %v1105 = add i64 %v1104, %v1102
  %v1106 = mul i64 %v1105, %v127
  %v1107 = getelementptr i64, ptr %v125, i64 %v1106
  %v1108 = getelementptr i8, ptr %v1107, i64 16
  %v1109 = load i64, ptr %v1108, align 8, !noalias !50
  %v1110 = add nsw i64 %v1109, %v516
  store i64 %v1110, ptr %v1108, align 8, !noalias !50
  %v1111 = getelementptr double, ptr %v518, i64 %v1090
  %v1112 = load double, ptr %v1111, align 8, !noalias !50
  %v1113 = fcmp une double %v1112, 0.000000e+00
  br i1 %v1113, label %v1114, label %v1115

v1114:
  %v1116 = load i64, ptr %v1092, align 8, !noalias !54
  %v1117 = icmp sgt i64 %v1116, -1
  br i1 %v1117, label %v1118, label %v1115

v1118:
  %v1119 = getelementptr i64, ptr %v111, i64 %v1116
  %v1120 = load i64, ptr %v1119, align 8, !noalias !54
  %v1121 = icmp eq i64 %v1120, 0
  br i1 %v1121, label %v1122, label %v1115

v1122:
  store i64 3, ptr %v1119, align 8, !noalias !54
  br label %v1115

v1115:
  br i1 %v284, label %v1123, label %v1124

v1123:
  %v1125 = load i64, ptr %v519, align 8, !noalias !57
  %v1126 = inttoptr i64 %v1125 to ptr
  tail call void %v1126(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v521), !noalias !57
  br label %v1127

v1128:
  %v1129 = getelementptr i64, ptr %v524, i64 %v1090
  store i64 %v1130, ptr %v1129, align 8, !noalias !63
  %v1131 = load i64, ptr %v1092, align 8, !noalias !64
  %v1132 = icmp sgt i64 %v1131, -1
  br i1 %v1132, label %v1133, label %v1134

v1133:
  %v1135 = getelementptr i64, ptr %v111, i64 %v1131
  %v1136 = load i64, ptr %v1135, align 8, !noalias !64
  %v1137 = icmp eq i64 %v1136, 0
  br i1 %v1137, label %v1138, label %v1134

v1138:
  store i64 4, ptr %v1135, align 8, !noalias !64
  br label %v1134

v1134:
  %v1139 = getelementptr double, ptr %v134, i64 %v1090
  %v1140 = load double, ptr %v1139, align 8, !noalias !63
  %v1141 = getelementptr double, ptr %v526, i64 %v1090
  store double %v1140, ptr %v1141, align 8, !noalias !63
  %v1142 = getelementptr double, ptr %v528, i64 %v1090
  store double 0.000000e+00, ptr %v1142, align 8, !noalias !63
  br label %v1124

v1127:
  %v1143 = phi i64 [ %v19, %v1123 ], [ %v1144, %v1145 ]
  %v1146 = phi i64 [ %v16, %v1123 ], [ %v1147, %v1145 ]
  %v1148 = icmp sgt i64 %v1146, 0
  br i1 %v1148, label %v1145, label %v1149

v1145:
  %v1147 = add nsw i64 %v1146, -1
  %v1144 = add i64 %v1143, 1
  %v1150 = icmp slt i64 %v1143, 0
  %v1151 = select i1 %v1150, i64 %v208, i64 0
  %v1152 = getelementptr double, ptr %v522, i64 %v1143
  %v1153 = getelementptr double, ptr %v1152, i64 %v1151
  %v1154 = load double, ptr %v1153, align 8, !noalias !67
  %v1155 = fcmp olt double %v1154, -1.000000e-09
  br i1 %v1155, label %v1149, label %v1127

v1149:
  %v1130 = phi i64 [ %v1143, %v1145 ], [ -1, %v1127 ]
  %v1156 = icmp sgt i64 %v1130, -1
  br i1 %v1156, label %v1128, label %v1124

v1157:
  %v1158 = icmp sgt i64 %v1159, 1
  br i1 %v1158, label %v1086, label %v1020

v1086:
  %v1159 = phi i64 [ %v1160, %v1157 ], [ %v288, %v1075 ]
  %v1090 = phi i64 [ %v1161, %v1157 ], [ 0, %v1075 ]
  %v1160 = add nsw i64 %v1159, -1
  %v1161 = add nsw i64 %v1090, 1
  %v1088 = getelementptr double, ptr %v509, i64 %v1090
  %v1162 = load double, ptr %v1088, align 8, !noalias !50
  %v1163 = fcmp olt double %v1162, 5.000000e-01
  br i1 %v1163, label %v1157, label %v1087

v1124:
  %v1164 = getelementptr double, ptr %v530, i64 %v1090
  %v1165 = load double, ptr %v1164, align 8, !noalias !71
  %v1166 = getelementptr double, ptr %v532, i64 %v1090
  store double %v1165, ptr %v1166, align 8, !noalias !71
  %v1167 = getelementptr i64, ptr %v534, i64 %v1090
  %v1168 = load i64, ptr %v1167, align 8, !noalias !71
  %v1169 = icmp slt i64 %v1168, %v94
  br i1 %v1169, label %v1170, label %v1157

v1170:
  %v1171 = icmp slt i64 %v1168, 0
  %v1172 = select i1 %v1171, i64 %v94, i64 0
  %v1173 = getelementptr double, ptr %v93, i64 %v1168
  %v1174 = getelementptr double, ptr %v1173, i64 %v1172
  %v1175 = load double, ptr %v1174, align 8, !noalias !71
  %v1176 = load double, ptr %v1164, align 8, !noalias !71
  %v1177 = fcmp olt double %v1176, %v1175
  %v1178 = select i1 %v1177, double %v1176, double %v1175
  store double %v1178, ptr %v1166, align 8, !noalias !71
  br label %v1157

v1020:
  %v1179 = phi i1 [ %v618, %v1026 ], [ %v618, %v1011 ], [ true, %v1075 ], [ true, %v1157 ]
  %v1180 = load i64, ptr %v535, align 8, !noalias !75
  %v1181 = inttoptr i64 %v1180 to ptr
  tail call void %v1181(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !75
  br i1 %v536, label %v1182, label %v1183

v1184:
  %v1185 = getelementptr double, ptr %v620, i64 %v1186
  %v1187 = load double, ptr %v1185, align 8
  %v1188 = fcmp ogt double %v1187, 5.000000e-01
  br label %v1189

v1189:
  %v1190 = phi i1 [ true, %v1191 ], [ %v1188, %v1184 ]
  br i1 %v1192, label %v1193, label %v1194

v1194:
  %v1195 = getelementptr double, ptr %v622, i64 %v1186
  %v1196 = load double, ptr %v1195, align 8
  %v1197 = fcmp ogt double %v1196, 5.000000e-01
  br label %v1193

v1193:
  %v1198 = phi i1 [ true, %v1189 ], [ %v1197, %v1194 ]
  %v1199 = icmp sgt i64 %v1200, 1
  br i1 %v1199, label %v1191, label %v1201

v1201:
  %v1202 = phi i1 [ false, %v1203 ], [ %v1190, %v1193 ]
  %v1204 = phi i1 [ %v1179, %v1203 ], [ %v1198, %v1193 ]
  %v1205 = xor i1 %v1204, true
  %v1206 = or i1 %v287, %v1205
  br i1 %v1206, label %v1207, label %v1208

v1209:
  br i1 %v287, label %v1207, label %v1210

v1211:
  %v1212 = getelementptr double, ptr %v624, i64 %v1213
  %v1214 = load double, ptr %v1212, align 8, !noalias !81
  %v1215 = fptosi double %v1214 to i64
  %v1216 = getelementptr double, ptr %v626, i64 %v1213
  %v1217 = load double, ptr %v1216, align 8, !noalias !81
  %v1218 = fptosi double %v1217 to i64
  %v1219 = mul i64 %v1220, %v127
  %v1221 = getelementptr i64, ptr %v125, i64 %v1219
  %v1222 = load i64, ptr %v1221, align 8, !noalias !81
  %v1223 = add nsw i64 %v1222, %v1215
  store i64 %v1223, ptr %v1221, align 8, !noalias !81
  %v1224 = getelementptr i8, ptr %v1221, i64 24
  %v1225 = load i64, ptr %v1224, align 8, !noalias !81
  %v1226 = add nsw i64 %v1225, %v1218
  store i64 %v1226, ptr %v1224, align 8, !noalias !81
  %v1227 = getelementptr i8, ptr %v1221, i64 8
  %v1228 = load i64, ptr %v1227, align 8, !noalias !81
  %v1229 = add nsw i64 %v1218, %v1215
  %v1230 = mul nsw i64 %v1229, %v595
  %v1231 = add nsw i64 %v1230, %v1215
  %v1232 = add nsw i64 %v1231, %v1228
  store i64 %v1232, ptr %v1227, align 8, !noalias !81
  store double 0.000000e+00, ptr %v1212, align 8, !noalias !81
  store double 0.000000e+00, ptr %v1216, align 8, !noalias !81
  %v1233 = getelementptr double, ptr %v628, i64 %v1213
  %v1234 = load double, ptr %v1233, align 8, !noalias !81
  %v1235 = sitofp i64 %v1229 to double
  %v1236 = fsub double %v1234, %v1235
  store double %v1236, ptr %v1233, align 8, !noalias !81
  br label %v1237

v1237:
  %v1238 = icmp sgt i64 %v1239, 1
  br i1 %v1238, label %v1208, label %v1209

v1208:
  %v1239 = phi i64 [ %v1240, %v1237 ], [ %v288, %v1201 ]
  %v1213 = phi i64 [ %v1241, %v1237 ], [ 0, %v1201 ]
  %v1240 = add nsw i64 %v1239, -1
  %v1241 = add nsw i64 %v1213, 1
  %v1242 = getelementptr i64, ptr %v143, i64 %v1213
  %v1220 = load i64, ptr %v1242, align 8, !noalias !81
  %v1243 = icmp sgt i64 %v1220, -1
  br i1 %v1243, label %v1211, label %v1237

v1244:
  %v1245 = getelementptr double, ptr %v634, i64 %v1246
  %v1247 = load double, ptr %v1245, align 8, !noalias !88
  %v1248 = fcmp ogt double %v1247, 5.000000e-01
  br i1 %v1248, label %v1249, label %v1250

v1249:
  %v1251 = fptosi double %v1247 to i64
  %v1252 = load i64, ptr %v1253, align 8, !noalias !89
  %v1254 = icmp sgt i64 %v1252, -1
  br i1 %v1254, label %v1255, label %v1250

v1250:
  %v1256 = getelementptr double, ptr %v636, i64 %v1246
  %v1257 = load double, ptr %v1256, align 8, !noalias !88
  %v1258 = fcmp ogt double %v1257, 5.000000e-01
  br i1 %v1258, label %v1259, label %v1260

v1259:
  %v1261 = select i1 %v1262, i1 true, i1 %v284
  %v1263 = icmp slt i64 %v1264, %v94
  br i1 %v1263, label %v1265, label %v1266

v1265:
  %v1267 = icmp slt i64 %v1264, 0
  %v1268 = select i1 %v1267, i64 %v94, i64 0
  %v1269 = getelementptr double, ptr %v93, i64 %v1264
  %v1270 = getelementptr double, ptr %v1269, i64 %v1268
  %v1271 = load double, ptr %v1270, align 8, !noalias !88
  %v1272 = getelementptr double, ptr %v638, i64 %v1246
  %v1273 = load double, ptr %v1272, align 8, !noalias !88
  %v1274 = fcmp olt double %v1271, %v1273
  br i1 %v1274, label %v1275, label %v1266

v1275:
  br label %v1266

v1266:
  %v1276 = phi i1 [ true, %v1275 ], [ %v1261, %v1265 ], [ %v1261, %v1259 ]
  %v1277 = mul i64 %v1278, %v127
  %v1279 = getelementptr i64, ptr %v125, i64 %v1277
  %v1280 = load i64, ptr %v1279, align 8, !noalias !88
  %v1281 = and i64 %v1280, 127
  %v1282 = icmp eq i64 %v1281, 0
  br i1 %v1282, label %v1283, label %v1284

v1284:
  %v1285 = getelementptr double, ptr %v640, i64 %v1246
  %v1286 = load double, ptr %v1285, align 8, !noalias !88
  %v1287 = fcmp ogt double %v1286, 0.000000e+00
  br i1 %v1287, label %v1283, label %v1260

v1283:
  store double 1.000000e+00, ptr %v1288, align 8, !noalias !88
  br label %v1260

v1260:
  %v1289 = phi i1 [ %v1276, %v1283 ], [ %v1276, %v1284 ], [ %v1262, %v1250 ], [ %v1262, %v1210 ]
  %v1290 = phi i1 [ true, %v1283 ], [ %v1291, %v1284 ], [ %v1291, %v1250 ], [ %v1291, %v1210 ]
  %v1292 = icmp sgt i64 %v1293, 1
  br i1 %v1292, label %v1210, label %v1294

v1210:
  %v1291 = phi i1 [ %v1290, %v1260 ], [ false, %v1209 ]
  %v1262 = phi i1 [ %v1289, %v1260 ], [ false, %v1209 ]
  %v1293 = phi i64 [ %v1295, %v1260 ], [ %v288, %v1209 ]
  %v1246 = phi i64 [ %v1296, %v1260 ], [ 0, %v1209 ]
  %v1295 = add nsw i64 %v1293, -1
  %v1296 = add nsw i64 %v1246, 1
  %v1253 = getelementptr i64, ptr %v143, i64 %v1246
  %v1278 = load i64, ptr %v1253, align 8, !noalias !88
  %v1297 = getelementptr i64, ptr %v630, i64 %v1246
  %v1264 = load i64, ptr %v1297, align 8, !noalias !88
  %v1288 = getelementptr double, ptr %v632, i64 %v1246
  store double 0.000000e+00, ptr %v1288, align 8, !noalias !88
  %v1298 = icmp sgt i64 %v1278, -1
  br i1 %v1298, label %v1244, label %v1260

v1255:
  %v1299 = getelementptr i64, ptr %v111, i64 %v1252
  %v1300 = load i64, ptr %v1299, align 8, !noalias !89
  %v1301 = icmp eq i64 %v1300, 0
  br i1 %v1301, label %v1302, label %v1250

v1302:
  store i64 %v1251, ptr %v1299, align 8, !noalias !89
  br label %v1250

v1207:
  %v1303 = phi i1 [ true, %v1201 ], [ true, %v1209 ], [ %v1304, %v1294 ]
  %v1305 = phi i1 [ true, %v1201 ], [ true, %v1209 ], [ %v1306, %v1294 ]
  %v1307 = and i1 %v641, %v1202
  br i1 %v1307, label %v1308, label %v1309

v1308:
  %v1310 = load i64, ptr %v6, align 8, !noalias !92
  %v1311 = inttoptr i64 %v1310 to ptr
  tail call void %v1311(ptr %v646, ptr %v649, ptr %v166, ptr %v173, ptr %v180, ptr %v651), !noalias !92
  br label %v1309

v1309:
  br i1 %v1305, label %v1312, label %v1313

v1313:
  %v1314 = load i64, ptr %v652, align 8, !noalias !98
  %v1315 = inttoptr i64 %v1314 to ptr
  tail call void %v1315(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !98
  br label %v1312

v1312:
  %v1316 = select i1 %v1202, i1 %v284, i1 false
  %v1317 = xor i1 %v1202, true
  %v1318 = select i1 %v285, i1 %v1202, i1 false
  %v1319 = xor i1 %v1318, true
  %v1320 = select i1 %v1319, i1 true, i1 %v1316
  %v1321 = select i1 %v285, i1 %v1202, i1 %v1316
  br i1 %v1320, label %v1322, label %v1323

v1323:
  %v1324 = load i64, ptr %v653, align 8, !noalias !101
  %v1325 = inttoptr i64 %v1324 to ptr
  tail call void %v1325(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !101
  br label %v1326

v1326:
  %v1327 = phi i64 [ 0, %v1323 ], [ %v1328, %v1329 ]
  %v1328 = add nsw i64 %v1327, 1
  %v1330 = icmp ult i64 %v1327, 9
  br i1 %v1330, label %v1331, label %v1332

v1331:
  %v1333 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v1327
  %v1334 = load double, ptr %v1333, align 8
  %v1335 = load double, ptr %v134, align 8, !noalias !104
  %v1336 = load double, ptr %v656, align 8, !noalias !104
  %v1337 = fmul double %v1334, %v1336
  %v1338 = fadd double %v1335, %v1337
  store double %v1338, ptr %v658, align 8, !noalias !104
  br i1 %v660, label %v1329, label %v1339

v1339:
  %v1340 = fsub double 1.000000e+00, %v1334
  br label %v1341

v1341:
  %v1342 = phi i64 [ 0, %v1339 ], [ %v1343, %v1341 ]
  %v1344 = mul i64 %v1342, %v197
  %v1345 = getelementptr double, ptr %v194, i64 %v1344
  %v1346 = getelementptr i8, ptr %v1345, i64 %v664
  %v1347 = load double, ptr %v1346, align 8, !noalias !114
  %v1348 = fadd double %v1347, 0.000000e+00
  %v1349 = fmul double %v1334, %v1348
  %v1350 = getelementptr i8, ptr %v1345, i64 %v665
  %v1351 = load double, ptr %v1350, align 8, !noalias !114
  %v1352 = fadd double %v1351, %v1349
  %v1353 = fmul double %v1340, %v1352
  %v1354 = getelementptr i8, ptr %v1345, i64 %v666
  %v1355 = load double, ptr %v1354, align 8, !noalias !114
  %v1356 = fadd double %v1355, %v1353
  %v1357 = fmul double %v1334, %v1356
  %v1358 = getelementptr i8, ptr %v1345, i64 %v667
  %v1359 = load double, ptr %v1358, align 8, !noalias !114
  %v1360 = fadd double %v1359, %v1357
  %v1361 = fmul double %v1340, %v1360
  %v1362 = getelementptr i8, ptr %v1345, i64 %v668
  %v1363 = load double, ptr %v1362, align 8, !noalias !114
  %v1364 = fadd double %v1363, %v1361
  %v1365 = fmul double %v1334, %v1364
  %v1366 = getelementptr i8, ptr %v1345, i64 %v669
  %v1367 = load double, ptr %v1366, align 8, !noalias !114
  %v1368 = fadd double %v1367, %v1365
  %v1369 = fmul double %v1340, %v1368
  %v1370 = getelementptr i8, ptr %v1345, i64 %v670
  %v1371 = load double, ptr %v1370, align 8, !noalias !114
  %v1372 = fadd double %v1371, %v1369
  %v1373 = fmul double %v1334, %v1372
  %v1343 = add nsw i64 %v1342, 1
  %v1374 = load double, ptr %v1345, align 8, !noalias !114
  %v1375 = fadd double %v1374, %v1373
  %v1376 = getelementptr double, ptr %v661, i64 %v1344
  store double %v1375, ptr %v1376, align 8, !noalias !104
  %v1377 = icmp eq i64 %v10, %v1343
  br i1 %v1377, label %v1329, label %v1341

v1329:
  %v1378 = icmp eq i64 %v1327, 8
  %v1379 = select i1 %v1378, i64 17, i64 16
  %v1380 = mul i64 %v662, %v1327
  %v1381 = load i64, ptr %v663, align 8, !noalias !118
  %v1382 = mul nsw i64 %v1379, %v10
  %v1383 = getelementptr double, ptr %v159, i64 %v1382
  %v1384 = getelementptr double, ptr %v187, i64 %v1380
  %v1385 = inttoptr i64 %v1381 to ptr
  tail call void %v1385(ptr nonnull %v658, ptr %v1383, ptr %v166, ptr %v173, ptr %v180, ptr %v1384), !noalias !118
  %v1386 = icmp eq i64 %v1328, 9
  br i1 %v1386, label %v1332, label %v1326

v1332:
  %v1387 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v1326 ], [ null, %v1329 ]
  %v1388 = phi i32 [ 1, %v1326 ], [ 0, %v1329 ]
  br i1 %v1330, label %v1389, label %v1390, !prof !121

v1322:
  %v1391 = phi i1 [ %v1321, %v1312 ], [ %v1392, %v1390 ]
  %v1393 = xor i1 %v1303, true
  %v1394 = select i1 %v1393, i1 true, i1 %v1391
  br i1 %v1394, label %v1395, label %v1396

v1395:
  br i1 %v681, label %v1397, label %v1398

v1399:
  %v1400 = load i64, ptr %v692, align 8, !noalias !122
  %v1401 = inttoptr i64 %v1400 to ptr
  tail call void %v1401(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !122
  br label %v1398

v1397:
  %v1402 = phi i64 [ %v1403, %v1397 ], [ 1, %v1395 ]
  %v1403 = add i64 %v1402, 1
  %v1404 = add nsw i64 %v682, %v1402
  %v1405 = icmp slt i64 %v1404, 0
  %v1406 = select i1 %v1405, i64 %v7, i64 0
  %v1407 = getelementptr i64, ptr %v6, i64 %v1404
  %v1408 = getelementptr i64, ptr %v1407, i64 %v1406
  %v1409 = load i64, ptr %v1408, align 8, !noalias !128
  %v1410 = inttoptr i64 %v1409 to ptr
  tail call void %v1410(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !128
  %v1411 = add nsw i64 %v1402, 13
  %v1412 = load i64, ptr %v6, align 8, !noalias !131
  %v1413 = mul nsw i64 %v1411, %v685
  %v1414 = getelementptr double, ptr %v159, i64 %v1413
  %v1415 = inttoptr i64 %v1412 to ptr
  tail call void %v1415(ptr %v684, ptr %v687, ptr %v166, ptr %v173, ptr %v180, ptr %v1414), !noalias !131
  %v1416 = icmp eq i64 %v1402, %v12
  br i1 %v1416, label %v1399, label %v1397

v1398:
  %v1417 = load i64, ptr %v693, align 8, !noalias !134
  %v1418 = inttoptr i64 %v1417 to ptr
  tail call void %v1418(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !134
  %v1419 = select i1 %v644, i1 true, i1 %v1317
  %v1420 = or i1 %v1419, %v287
  br i1 %v1420, label %v1421, label %v1422

v1423:
  %v1424 = getelementptr double, ptr %v697, i64 %v1425
  %v1426 = load double, ptr %v1424, align 8, !noalias !137
  %v1427 = fcmp uge double %v1426, 5.000000e-01
  %v1428 = icmp slt i64 %v1429, %v94
  %v1430 = select i1 %v1427, i1 %v1428, i1 false
  br i1 %v1430, label %v1431, label %v1432

v1431:
  %v1433 = icmp slt i64 %v1429, 0
  %v1434 = select i1 %v1433, i64 %v94, i64 0
  %v1435 = getelementptr double, ptr %v93, i64 %v1429
  %v1436 = getelementptr double, ptr %v1435, i64 %v1434
  %v1437 = load double, ptr %v1436, align 8, !noalias !137
  %v1438 = getelementptr double, ptr %v699, i64 %v1425
  %v1439 = load double, ptr %v1438, align 8, !noalias !137
  %v1440 = fcmp olt double %v1437, %v1439
  br i1 %v1440, label %v1441, label %v1432

v1441:
  %v1442 = getelementptr double, ptr %v701, i64 %v1425
  %v1443 = load double, ptr %v1442, align 8, !noalias !137
  %v1444 = fcmp ogt double %v1443, 1.000000e+00
  br i1 %v1444, label %v1445, label %v1432

v1445:
  %v1446 = getelementptr double, ptr %v703, i64 %v1425
  %v1447 = load double, ptr %v1446, align 8, !noalias !137
  store double 0.000000e+00, ptr %v1424, align 8, !noalias !141
  %v1448 = getelementptr double, ptr %v705, i64 %v1425
  store double 0.000000e+00, ptr %v1448, align 8, !noalias !141
  %v1449 = getelementptr double, ptr %v706, i64 %v1425
  store double %v1447, ptr %v1449, align 8, !noalias !141
  %v1450 = load i64, ptr %v1451, align 8, !noalias !141
  %v1452 = icmp slt i64 %v1450, 0
  %v1453 = select i1 %v1452, i64 %v126, i64 0
  %v1454 = add i64 %v1453, %v1450
  %v1455 = mul i64 %v1454, %v127
  %v1456 = getelementptr i64, ptr %v125, i64 %v1455
  %v1457 = load i64, ptr %v1456, align 8, !noalias !141
  %v1458 = add nsw i64 %v1457, -1
  store i64 %v1458, ptr %v1456, align 8, !noalias !141
  %v1459 = load i64, ptr %v1451, align 8, !noalias !141
  %v1460 = icmp slt i64 %v1459, 0
  %v1461 = select i1 %v1460, i64 %v126, i64 0
  %v1462 = add i64 %v1461, %v1459
  %v1463 = mul i64 %v1462, %v127
  %v1464 = getelementptr i64, ptr %v125, i64 %v1463
  %v1465 = getelementptr i8, ptr %v1464, i64 24
  %v1466 = load i64, ptr %v1465, align 8, !noalias !141
  %v1467 = add nsw i64 %v1466, 1
  store i64 %v1467, ptr %v1465, align 8, !noalias !141
  %v1468 = load double, ptr %v1436, align 8, !noalias !137
  %v1469 = getelementptr double, ptr %v708, i64 %v1425
  store double %v1468, ptr %v1469, align 8, !noalias !137
  %v1470 = mul i64 %v1471, %v127
  %v1472 = getelementptr i64, ptr %v125, i64 %v1470
  %v1473 = getelementptr i8, ptr %v1472, i64 8
  %v1474 = load i64, ptr %v1473, align 8, !noalias !137
  %v1475 = add nsw i64 %v1474, %v12
  store i64 %v1475, ptr %v1473, align 8, !noalias !137
  br label %v1432

v1432:
  %v1476 = icmp sgt i64 %v1477, 1
  br i1 %v1476, label %v1422, label %v1421

v1422:
  %v1477 = phi i64 [ %v1478, %v1432 ], [ %v288, %v1398 ]
  %v1425 = phi i64 [ %v1479, %v1432 ], [ 0, %v1398 ]
  %v1478 = add nsw i64 %v1477, -1
  %v1479 = add nsw i64 %v1425, 1
  %v1451 = getelementptr i64, ptr %v143, i64 %v1425
  %v1471 = load i64, ptr %v1451, align 8, !noalias !137
  %v1480 = getelementptr i64, ptr %v695, i64 %v1425
  %v1429 = load i64, ptr %v1480, align 8, !noalias !137
  %v1481 = icmp slt i64 %v1471, 0
  br i1 %v1481, label %v1432, label %v1423

v1421:
  br i1 %v1391, label %v1482, label %v1483

v1482:
  call void @llvm.lifetime.start.p0(ptr nonnull %v282)
  call void @llvm.lifetime.start.p0(ptr nonnull %v283)
  store i8 0, ptr %v282, align 1, !noalias !144
  store ptr null, ptr %v283, align 8, !noalias !144
  br label %v1484

v1484:
  %v1485 = phi i64 [ 0, %v1482 ], [ %v1486, %v1487 ]
  %v1486 = add nsw i64 %v1485, 1
  %v1488 = icmp ult i64 %v1485, 9
  br i1 %v1488, label %v1489, label %v1490

v1489:
  %v1491 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v1485
  %v1492 = load double, ptr %v1491, align 8
  %v1493 = load double, ptr %v134, align 8, !noalias !148
  %v1494 = load double, ptr %v711, align 8, !noalias !148
  %v1495 = fmul double %v1492, %v1494
  %v1496 = fadd double %v1493, %v1495
  store double %v1496, ptr %v713, align 8, !noalias !148
  br i1 %v715, label %v1487, label %v1497

v1497:
  %v1498 = fsub double 1.000000e+00, %v1492
  br label %v1499

v1499:
  %v1500 = phi i64 [ 0, %v1497 ], [ %v1501, %v1499 ]
  %v1502 = mul i64 %v1500, %v197
  %v1503 = getelementptr double, ptr %v194, i64 %v1502
  %v1504 = getelementptr i8, ptr %v1503, i64 %v719
  %v1505 = load double, ptr %v1504, align 8, !noalias !155
  %v1506 = fadd double %v1505, 0.000000e+00
  %v1507 = fmul double %v1492, %v1506
  %v1508 = getelementptr i8, ptr %v1503, i64 %v720
  %v1509 = load double, ptr %v1508, align 8, !noalias !155
  %v1510 = fadd double %v1509, %v1507
  %v1511 = fmul double %v1498, %v1510
  %v1512 = getelementptr i8, ptr %v1503, i64 %v721
  %v1513 = load double, ptr %v1512, align 8, !noalias !155
  %v1514 = fadd double %v1513, %v1511
  %v1515 = fmul double %v1492, %v1514
  %v1516 = getelementptr i8, ptr %v1503, i64 %v722
  %v1517 = load double, ptr %v1516, align 8, !noalias !155
  %v1518 = fadd double %v1517, %v1515
  %v1519 = fmul double %v1498, %v1518
  %v1520 = getelementptr i8, ptr %v1503, i64 %v723
  %v1521 = load double, ptr %v1520, align 8, !noalias !155
  %v1522 = fadd double %v1521, %v1519
  %v1523 = fmul double %v1492, %v1522
  %v1524 = getelementptr i8, ptr %v1503, i64 %v724
  %v1525 = load double, ptr %v1524, align 8, !noalias !155
  %v1526 = fadd double %v1525, %v1523
  %v1527 = fmul double %v1498, %v1526
  %v1528 = getelementptr i8, ptr %v1503, i64 %v725
  %v1529 = load double, ptr %v1528, align 8, !noalias !155
  %v1530 = fadd double %v1529, %v1527
  %v1531 = fmul double %v1492, %v1530
  %v1501 = add nsw i64 %v1500, 1
  %v1532 = load double, ptr %v1503, align 8, !noalias !155
  %v1533 = fadd double %v1532, %v1531
  %v1534 = getelementptr double, ptr %v716, i64 %v1502
  store double %v1533, ptr %v1534, align 8, !noalias !148
  %v1535 = icmp eq i64 %v10, %v1501
  br i1 %v1535, label %v1487, label %v1499

v1487:
  %v1536 = icmp eq i64 %v1485, 8
  %v1537 = select i1 %v1536, i64 17, i64 16
  %v1538 = mul i64 %v1485, %v717
  %v1539 = load i64, ptr %v718, align 8, !noalias !159
  %v1540 = mul nsw i64 %v1537, %v10
  %v1541 = getelementptr double, ptr %v159, i64 %v1540
  %v1542 = getelementptr double, ptr %v187, i64 %v1538
  %v1543 = inttoptr i64 %v1539 to ptr
  tail call void %v1543(ptr nonnull %v713, ptr %v1541, ptr %v166, ptr %v173, ptr %v180, ptr %v1542), !noalias !159
  %v1544 = icmp eq i64 %v1486, 9
  br i1 %v1544, label %v1490, label %v1484

v1490:
  %v1545 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v1484 ], [ null, %v1487 ]
  %v1546 = phi i32 [ 1, %v1484 ], [ 0, %v1487 ]
  br i1 %v1488, label %v1547, label %v1548, !prof !121

v1547:
  br i1 %v726, label %v1549, label %v1550

v1550:
  %v1551 = phi i64 [ %v1552, %v1550 ], [ %v16, %v1547 ]
  %v1553 = phi i64 [ %v1554, %v1550 ], [ %v19, %v1547 ]
  %v1555 = icmp slt i64 %v1553, 0
  %v1556 = select i1 %v1555, i64 %v208, i64 0
  %v1557 = add i64 %v1556, %v1553
  %v1558 = getelementptr double, ptr %v729, i64 %v1557
  %v1559 = load double, ptr %v1558, align 8, !noalias !162
  %v1560 = fcmp uge double %v1559, 0.000000e+00
  %v1561 = getelementptr double, ptr %v730, i64 %v1557
  %v1562 = load double, ptr %v1561, align 8, !noalias !162
  %v1563 = fcmp ule double %v1562, 0.000000e+00
  %v1564 = select i1 %v1560, i1 true, i1 %v1563
  %v1565 = select i1 %v1564, double 1.000000e-09, double 0.000000e+00
  %v1566 = getelementptr double, ptr %v1558, i64 %v727
  store double %v1565, ptr %v1566, align 8, !noalias !162
  %v1567 = getelementptr i8, ptr %v1558, i64 %v731
  store double %v1565, ptr %v1567, align 8, !noalias !162
  %v1568 = getelementptr i8, ptr %v1558, i64 %v732
  store double %v1565, ptr %v1568, align 8, !noalias !162
  %v1569 = getelementptr i8, ptr %v1558, i64 %v733
  store double %v1565, ptr %v1569, align 8, !noalias !162
  %v1570 = getelementptr i8, ptr %v1558, i64 %v734
  store double %v1565, ptr %v1570, align 8, !noalias !162
  %v1571 = getelementptr i8, ptr %v1558, i64 %v735
  store double %v1565, ptr %v1571, align 8, !noalias !162
  %v1572 = getelementptr i8, ptr %v1558, i64 %v736
  store double %v1565, ptr %v1572, align 8, !noalias !162
  %v1573 = getelementptr i8, ptr %v1558, i64 %v737
  store double %v1565, ptr %v1573, align 8, !noalias !162
  %v1574 = getelementptr i8, ptr %v1558, i64 %v738
  store double %v1565, ptr %v1574, align 8, !noalias !162
  %v1575 = getelementptr i8, ptr %v1558, i64 %v739
  store double %v1565, ptr %v1575, align 8, !noalias !162
  %v1552 = add nsw i64 %v1551, -1
  %v1554 = add i64 %v1553, 1
  %v1576 = icmp sgt i64 %v1551, 1
  br i1 %v1576, label %v1550, label %v1549

v1549:
  store i8 0, ptr %v282, align 1, !noalias !144
  %v1577 = call fastcc i32 @_ZN5pages12event_checks13find_crossingB3v59B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr %v282, ptr %v283, i64 %v13, ptr readonly %v93, i64 %v94, ptr %v125, i64 %v126, i64 %v127, ptr %v134, i64 %v136, ptr %v143, i64 %v145, ptr %v205, i64 %v206, i64 %v207, i64 %v208, double 0.000000e+00)
  %v1578 = icmp eq i32 %v1577, 0
  br i1 %v1578, label %v1579, label %v1580, !prof !121

v1580:
  %v1581 = load ptr, ptr %v283, align 8, !noalias !144
  br label %v1548

v1579:
  %v1582 = load i8, ptr %v282, align 1, !noalias !144
  %v1583 = icmp eq i8 %v1582, 0
  br label %v1548

v1548:
  %v1584 = phi i1 [ %v1583, %v1579 ], [ true, %v1580 ], [ true, %v1490 ]
  %v1585 = phi ptr [ null, %v1579 ], [ %v1581, %v1580 ], [ %v1545, %v1490 ]
  %v1586 = phi i32 [ 0, %v1579 ], [ 1, %v1580 ], [ %v1546, %v1490 ]
  call void @llvm.lifetime.end.p0(ptr nonnull %v282)
  call void @llvm.lifetime.end.p0(ptr nonnull %v283)
  %v1587 = icmp eq i32 %v1586, 0
  %v1588 = select i1 %v1587, ptr undef, ptr %v1585
  br i1 %v1587, label %v1589, label %v1396, !prof !121

v1590:
  %v1591 = load double, ptr %v741, align 8, !noalias !166
  %v1592 = load double, ptr %v711, align 8, !noalias !166
  br i1 %v746, label %v1593, label %v1594

v1593:
  %v1595 = load double, ptr %v745, align 8, !noalias !166
  %v1596 = load double, ptr %v748, align 8, !noalias !166
  %v1597 = fsub double %v1595, %v1596
  %v1598 = load double, ptr %v743, align 8, !noalias !166
  %v1599 = load double, ptr %v93, align 8, !noalias !166
  %v1600 = fsub double %v1598, %v1599
  %v1601 = fmul double %v1600, 5.000000e-06
  %v1602 = fcmp olt double %v1597, %v1601
  br i1 %v1602, label %v1594, label %v1603

v1604:
  %v1605 = sub nsw i64 45, %v1606
  %v1607 = load double, ptr %v752, align 8, !noalias !170
  %v1608 = load double, ptr %v754, align 8, !noalias !170
  br label %v1609

v1609:
  %v1610 = phi double [ %v1611, %v1609 ], [ 1.000000e+00, %v1604 ]
  %v1612 = phi double [ %v1613, %v1609 ], [ 2.000000e+00, %v1604 ]
  %v1614 = phi i64 [ %v1615, %v1609 ], [ %v1605, %v1604 ]
  %v1616 = and i64 %v1614, 1
  %v1617 = icmp eq i64 %v1616, 0
  %v1618 = fmul double %v1610, %v1612
  %v1611 = select i1 %v1617, double %v1610, double %v1618
  %v1615 = lshr i64 %v1614, 1
  %v1613 = fmul double %v1612, %v1612
  %v1619 = icmp eq i64 %v1615, 0
  br i1 %v1619, label %v1620, label %v1609

v1621:
  %v1622 = fcmp olt double %v1623, 0.000000e+00
  %v1624 = select i1 %v1622, double 0.000000e+00, double %v1623
  %v1625 = fmul double %v1626, %v1624
  %v1627 = fsub double %v1628, %v1625
  br label %v1629

v1620:
  %v1630 = fadd double %v1631, %v1632
  %v1628 = fmul double %v1630, 5.000000e-01
  %v1633 = fmul double %v1611, 1.000000e-05
  %v1634 = fsub double %v1633, %v1635
  %v1623 = fmul double %v1634, 5.000000e-01
  %v1636 = fmul double %v1632, %v1608
  %v1637 = fmul double %v1631, %v1607
  %v1638 = fsub double %v1636, %v1637
  %v1639 = fsub double %v1608, %v1607
  %v1640 = fdiv double %v1638, %v1639
  %v1641 = fcmp olt double %v1632, %v1640
  %v1642 = fcmp olt double %v1640, %v1631
  %v1643 = and i1 %v1641, %v1642
  %v1644 = select i1 %v1643, double %v1640, double %v1628
  %v1645 = fsub double %v1628, %v1644
  %v1626 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v1645)
  %v1646 = fmul double %v1635, %v1635
  %v1647 = tail call double @llvm.fabs.f64(double %v1645)
  %v1648 = fcmp olt double %v1647, %v1646
  %v1649 = select i1 %v1648, double %v1647, double %v1646
  %v1650 = fmul double %v1626, %v1649
  %v1651 = fadd double %v1644, %v1650
  %v1652 = fsub double %v1651, %v1628
  %v1653 = tail call double @llvm.fabs.f64(double %v1652)
  %v1654 = fcmp ugt double %v1653, %v1623
  br i1 %v1654, label %v1621, label %v1629

v1655:
  store double %v1656, ptr %v750, align 8, !noalias !176
  store double %v1657, ptr %v754, align 8, !noalias !176
  br label %v1658

v1659:
  store double %v1656, ptr %v741, align 8, !noalias !176
  store double %v1657, ptr %v752, align 8, !noalias !176
  br label %v1658

v1658:
  %v1660 = icmp eq i64 %v1661, 45
  br i1 %v1660, label %v1662, label %v1603

v1603:
  %v1606 = phi i64 [ %v1661, %v1658 ], [ 0, %v1593 ]
  %v1661 = add nsw i64 %v1606, 1
  %v1631 = load double, ptr %v750, align 8, !noalias !176
  %v1632 = load double, ptr %v741, align 8, !noalias !176
  %v1635 = fsub double %v1631, %v1632
  %v1663 = fcmp ugt double %v1635, 1.000000e-05
  br i1 %v1663, label %v1604, label %v1662

v1629:
  %v1656 = phi double [ %v1651, %v1620 ], [ %v1627, %v1621 ]
  %v1664 = load double, ptr %v134, align 8, !noalias !177
  %v1665 = load double, ptr %v711, align 8, !noalias !177
  %v1666 = fmul double %v1656, %v1665
  %v1667 = fadd double %v1664, %v1666
  store double %v1667, ptr %v713, align 8, !noalias !177
  br i1 %v715, label %v1668, label %v1669

v1669:
  %v1670 = fsub double 1.000000e+00, %v1656
  br label %v1671

v1671:
  %v1672 = phi i64 [ 0, %v1669 ], [ %v1673, %v1671 ]
  %v1674 = mul i64 %v1672, %v197
  %v1675 = getelementptr double, ptr %v194, i64 %v1674
  %v1676 = getelementptr i8, ptr %v1675, i64 %v719
  %v1677 = load double, ptr %v1676, align 8, !noalias !184
  %v1678 = fadd double %v1677, 0.000000e+00
  %v1679 = fmul double %v1656, %v1678
  %v1680 = getelementptr i8, ptr %v1675, i64 %v720
  %v1681 = load double, ptr %v1680, align 8, !noalias !184
  %v1682 = fadd double %v1681, %v1679
  %v1683 = fmul double %v1670, %v1682
  %v1684 = getelementptr i8, ptr %v1675, i64 %v721
  %v1685 = load double, ptr %v1684, align 8, !noalias !184
  %v1686 = fadd double %v1685, %v1683
  %v1687 = fmul double %v1656, %v1686
  %v1688 = getelementptr i8, ptr %v1675, i64 %v722
  %v1689 = load double, ptr %v1688, align 8, !noalias !184
  %v1690 = fadd double %v1689, %v1687
  %v1691 = fmul double %v1670, %v1690
  %v1692 = getelementptr i8, ptr %v1675, i64 %v723
  %v1693 = load double, ptr %v1692, align 8, !noalias !184
  %v1694 = fadd double %v1693, %v1691
  %v1695 = fmul double %v1656, %v1694
  %v1696 = getelementptr i8, ptr %v1675, i64 %v724
  %v1697 = load double, ptr %v1696, align 8, !noalias !184
  %v1698 = fadd double %v1697, %v1695
  %v1699 = fmul double %v1670, %v1698
  %v1700 = getelementptr i8, ptr %v1675, i64 %v725
  %v1701 = load double, ptr %v1700, align 8, !noalias !184
  %v1702 = fadd double %v1701, %v1699
  %v1703 = fmul double %v1656, %v1702
  %v1673 = add nsw i64 %v1672, 1
  %v1704 = load double, ptr %v1675, align 8, !noalias !184
  %v1705 = fadd double %v1704, %v1703
  %v1706 = getelementptr double, ptr %v716, i64 %v1674
  store double %v1705, ptr %v1706, align 8, !noalias !177
  %v1707 = icmp eq i64 %v10, %v1673
  br i1 %v1707, label %v1668, label %v1671

v1668:
  %v1708 = load i64, ptr %v718, align 8, !noalias !188
  %v1709 = inttoptr i64 %v1708 to ptr
  tail call void %v1709(ptr nonnull %v713, ptr %v756, ptr %v166, ptr %v173, ptr %v180, ptr %v758), !noalias !188
  br i1 %v761, label %v1710, label %v1711

v1711:
  %v1712 = phi double [ %v1713, %v1711 ], [ 0x7FF0000000000000, %v1668 ]
  %v1714 = phi i64 [ %v1715, %v1711 ], [ 0, %v1668 ]
  %v1715 = add nsw i64 %v1714, 1
  %v1716 = getelementptr double, ptr %v763, i64 %v1714
  %v1717 = load double, ptr %v1716, align 8, !noalias !191
  %v1718 = getelementptr double, ptr %v765, i64 %v1714
  %v1719 = load double, ptr %v1718, align 8, !noalias !191
  %v1720 = fadd double %v1717, %v1719
  %v1721 = fcmp olt double %v1720, %v1712
  %v1713 = select i1 %v1721, double %v1720, double %v1712
  %v1722 = icmp eq i64 %v208, %v1715
  br i1 %v1722, label %v1710, label %v1711

v1710:
  %v1657 = phi double [ 0x7FF0000000000000, %v1668 ], [ %v1713, %v1711 ]
  %v1723 = fcmp olt double %v1657, 0.000000e+00
  br i1 %v1723, label %v1655, label %v1659

v1724:
  %v1725 = load double, ptr %v792, align 8, !noalias !166
  %v1726 = fcmp olt double %v1725, 5.000000e-01
  br i1 %v1726, label %v1727, label %v1594

v1594:
  br label %v1728

v1729:
  %v1730 = sub nsw i64 45, %v1731
  %v1732 = load double, ptr %v796, align 8, !noalias !195
  %v1733 = load double, ptr %v798, align 8, !noalias !195
  br label %v1734

v1734:
  %v1735 = phi double [ %v1736, %v1734 ], [ 1.000000e+00, %v1729 ]
  %v1737 = phi double [ %v1738, %v1734 ], [ 2.000000e+00, %v1729 ]
  %v1739 = phi i64 [ %v1740, %v1734 ], [ %v1730, %v1729 ]
  %v1741 = and i64 %v1739, 1
  %v1742 = icmp eq i64 %v1741, 0
  %v1743 = fmul double %v1735, %v1737
  %v1736 = select i1 %v1742, double %v1735, double %v1743
  %v1740 = lshr i64 %v1739, 1
  %v1738 = fmul double %v1737, %v1737
  %v1744 = icmp eq i64 %v1740, 0
  br i1 %v1744, label %v1745, label %v1734

v1746:
  %v1747 = fcmp olt double %v1748, 0.000000e+00
  %v1749 = select i1 %v1747, double 0.000000e+00, double %v1748
  %v1750 = fmul double %v1751, %v1749
  %v1752 = fsub double %v1753, %v1750
  br label %v1754

v1745:
  %v1755 = fadd double %v1756, %v1757
  %v1753 = fmul double %v1755, 5.000000e-01
  %v1758 = fmul double %v1736, 1.000000e-13
  %v1759 = fsub double %v1758, %v1760
  %v1748 = fmul double %v1759, 5.000000e-01
  %v1761 = fmul double %v1757, %v1733
  %v1762 = fmul double %v1756, %v1732
  %v1763 = fsub double %v1761, %v1762
  %v1764 = fsub double %v1733, %v1732
  %v1765 = fdiv double %v1763, %v1764
  %v1766 = fcmp olt double %v1757, %v1765
  %v1767 = fcmp olt double %v1765, %v1756
  %v1768 = and i1 %v1766, %v1767
  %v1769 = select i1 %v1768, double %v1765, double %v1753
  %v1770 = fsub double %v1753, %v1769
  %v1751 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v1770)
  %v1771 = fmul double %v1760, %v1760
  %v1772 = tail call double @llvm.fabs.f64(double %v1770)
  %v1773 = fcmp olt double %v1772, %v1771
  %v1774 = select i1 %v1773, double %v1772, double %v1771
  %v1775 = fmul double %v1751, %v1774
  %v1776 = fadd double %v1769, %v1775
  %v1777 = fsub double %v1776, %v1753
  %v1778 = tail call double @llvm.fabs.f64(double %v1777)
  %v1779 = fcmp ugt double %v1778, %v1748
  br i1 %v1779, label %v1746, label %v1754

v1780:
  store double %v1781, ptr %v794, align 8, !noalias !201
  store double %v1782, ptr %v798, align 8, !noalias !201
  br label %v1783

v1784:
  store double %v1781, ptr %v741, align 8, !noalias !201
  store double %v1782, ptr %v796, align 8, !noalias !201
  br label %v1783

v1783:
  %v1785 = icmp eq i64 %v1786, 45
  br i1 %v1785, label %v1787, label %v1728

v1728:
  %v1731 = phi i64 [ %v1786, %v1783 ], [ 0, %v1594 ]
  %v1786 = add nsw i64 %v1731, 1
  %v1756 = load double, ptr %v794, align 8, !noalias !201
  %v1757 = load double, ptr %v741, align 8, !noalias !201
  %v1760 = fsub double %v1756, %v1757
  %v1788 = fcmp ugt double %v1760, 1.000000e-13
  br i1 %v1788, label %v1729, label %v1787

v1754:
  %v1781 = phi double [ %v1776, %v1745 ], [ %v1752, %v1746 ]
  %v1789 = load double, ptr %v134, align 8, !noalias !202
  %v1790 = load double, ptr %v711, align 8, !noalias !202
  %v1791 = fmul double %v1781, %v1790
  %v1792 = fadd double %v1789, %v1791
  store double %v1792, ptr %v713, align 8, !noalias !202
  br i1 %v799, label %v1793, label %v1794

v1793:
  %v1795 = fsub double 1.000000e+00, %v1781
  br label %v1796

v1796:
  %v1797 = phi i64 [ 0, %v1793 ], [ %v1798, %v1796 ]
  %v1799 = mul i64 %v1797, %v197
  %v1800 = getelementptr double, ptr %v194, i64 %v1799
  %v1801 = getelementptr i8, ptr %v1800, i64 %v719
  %v1802 = load double, ptr %v1801, align 8, !noalias !209
  %v1803 = fadd double %v1802, 0.000000e+00
  %v1804 = fmul double %v1781, %v1803
  %v1805 = getelementptr i8, ptr %v1800, i64 %v720
  %v1806 = load double, ptr %v1805, align 8, !noalias !209
  %v1807 = fadd double %v1806, %v1804
  %v1808 = fmul double %v1795, %v1807
  %v1809 = getelementptr i8, ptr %v1800, i64 %v721
  %v1810 = load double, ptr %v1809, align 8, !noalias !209
  %v1811 = fadd double %v1810, %v1808
  %v1812 = fmul double %v1781, %v1811
  %v1813 = getelementptr i8, ptr %v1800, i64 %v722
  %v1814 = load double, ptr %v1813, align 8, !noalias !209
  %v1815 = fadd double %v1814, %v1812
  %v1816 = fmul double %v1795, %v1815
  %v1817 = getelementptr i8, ptr %v1800, i64 %v723
  %v1818 = load double, ptr %v1817, align 8, !noalias !209
  %v1819 = fadd double %v1818, %v1816
  %v1820 = fmul double %v1781, %v1819
  %v1821 = getelementptr i8, ptr %v1800, i64 %v724
  %v1822 = load double, ptr %v1821, align 8, !noalias !209
  %v1823 = fadd double %v1822, %v1820
  %v1824 = fmul double %v1795, %v1823
  %v1825 = getelementptr i8, ptr %v1800, i64 %v725
  %v1826 = load double, ptr %v1825, align 8, !noalias !209
  %v1827 = fadd double %v1826, %v1824
  %v1828 = fmul double %v1781, %v1827
  %v1798 = add nsw i64 %v1797, 1
  %v1829 = load double, ptr %v1800, align 8, !noalias !209
  %v1830 = fadd double %v1829, %v1828
  %v1831 = getelementptr double, ptr %v716, i64 %v1799
  store double %v1830, ptr %v1831, align 8, !noalias !202
  %v1832 = icmp eq i64 %v10, %v1798
  br i1 %v1832, label %v1794, label %v1796

v1794:
  %v1833 = load i64, ptr %v718, align 8, !noalias !213
  %v1834 = inttoptr i64 %v1833 to ptr
  tail call void %v1834(ptr nonnull %v713, ptr %v801, ptr %v166, ptr %v173, ptr %v180, ptr %v803), !noalias !213
  br i1 %v805, label %v1835, label %v1836

v1836:
  %v1837 = phi double [ %v1838, %v1836 ], [ 0x7FF0000000000000, %v1794 ]
  %v1839 = phi i64 [ %v1840, %v1836 ], [ 0, %v1794 ]
  %v1840 = add nsw i64 %v1839, 1
  %v1841 = getelementptr double, ptr %v807, i64 %v1839
  %v1842 = load double, ptr %v1841, align 8, !noalias !216
  %v1843 = getelementptr double, ptr %v809, i64 %v1839
  %v1844 = load double, ptr %v1843, align 8, !noalias !216
  %v1845 = fadd double %v1842, %v1844
  %v1846 = fcmp olt double %v1845, %v1837
  %v1838 = select i1 %v1846, double %v1845, double %v1837
  %v1847 = icmp eq i64 %v208, %v1840
  br i1 %v1847, label %v1835, label %v1836

v1835:
  %v1782 = phi double [ 0x7FF0000000000000, %v1794 ], [ %v1838, %v1836 ]
  %v1848 = fcmp olt double %v1782, 0.000000e+00
  br i1 %v1848, label %v1780, label %v1784

v1849:
  %v1850 = load double, ptr %v794, align 8, !noalias !220
  %v1851 = load double, ptr %v134, align 8, !noalias !224
  %v1852 = load double, ptr %v711, align 8, !noalias !224
  %v1853 = fmul double %v1850, %v1852
  %v1854 = fadd double %v1851, %v1853
  store double %v1854, ptr %v713, align 8, !noalias !224
  br i1 %v799, label %v1855, label %v1856

v1855:
  %v1857 = fsub double 1.000000e+00, %v1850
  br label %v1858

v1858:
  %v1859 = phi i64 [ 0, %v1855 ], [ %v1860, %v1858 ]
  %v1861 = mul i64 %v1859, %v197
  %v1862 = getelementptr double, ptr %v194, i64 %v1861
  %v1863 = getelementptr i8, ptr %v1862, i64 %v719
  %v1864 = load double, ptr %v1863, align 8, !noalias !231
  %v1865 = fadd double %v1864, 0.000000e+00
  %v1866 = fmul double %v1850, %v1865
  %v1867 = getelementptr i8, ptr %v1862, i64 %v720
  %v1868 = load double, ptr %v1867, align 8, !noalias !231
  %v1869 = fadd double %v1868, %v1866
  %v1870 = fmul double %v1857, %v1869
  %v1871 = getelementptr i8, ptr %v1862, i64 %v721
  %v1872 = load double, ptr %v1871, align 8, !noalias !231
  %v1873 = fadd double %v1872, %v1870
  %v1874 = fmul double %v1850, %v1873
  %v1875 = getelementptr i8, ptr %v1862, i64 %v722
  %v1876 = load double, ptr %v1875, align 8, !noalias !231
  %v1877 = fadd double %v1876, %v1874
  %v1878 = fmul double %v1857, %v1877
  %v1879 = getelementptr i8, ptr %v1862, i64 %v723
  %v1880 = load double, ptr %v1879, align 8, !noalias !231
  %v1881 = fadd double %v1880, %v1878
  %v1882 = fmul double %v1850, %v1881
  %v1883 = getelementptr i8, ptr %v1862, i64 %v724
  %v1884 = load double, ptr %v1883, align 8, !noalias !231
  %v1885 = fadd double %v1884, %v1882
  %v1886 = fmul double %v1857, %v1885
  %v1887 = getelementptr i8, ptr %v1862, i64 %v725
  %v1888 = load double, ptr %v1887, align 8, !noalias !231
  %v1889 = fadd double %v1888, %v1886
  %v1890 = fmul double %v1850, %v1889
  %v1860 = add nsw i64 %v1859, 1
  %v1891 = load double, ptr %v1862, align 8, !noalias !231
  %v1892 = fadd double %v1891, %v1890
  %v1893 = getelementptr double, ptr %v716, i64 %v1861
  store double %v1892, ptr %v1893, align 8, !noalias !224
  %v1894 = icmp eq i64 %v10, %v1860
  br i1 %v1894, label %v1856, label %v1858

v1856:
  %v1895 = load i64, ptr %v718, align 8, !noalias !235
  %v1896 = inttoptr i64 %v1895 to ptr
  tail call void %v1896(ptr nonnull %v713, ptr %v801, ptr %v166, ptr %v173, ptr %v180, ptr %v803), !noalias !235
  br label %v1897

v1898:
  %v1899 = icmp slt i64 %v1900, 0
  %v1901 = select i1 %v1899, i64 %v208, i64 0
  %v1902 = add i64 %v1901, %v1900
  %v1903 = getelementptr double, ptr %v807, i64 %v1902
  %v1904 = load double, ptr %v1903, align 8, !noalias !220
  store double %v1904, ptr %v798, align 8, !noalias !220
  br label %v1905

v1906:
  %v1907 = phi i64 [ 0, %v1908 ], [ %v1909, %v1906 ]
  %v1910 = mul i64 %v1907, %v197
  %v1911 = getelementptr double, ptr %v194, i64 %v1910
  %v1912 = getelementptr i8, ptr %v1911, i64 %v719
  %v1913 = load double, ptr %v1912, align 8, !noalias !238
  %v1914 = fadd double %v1913, 0.000000e+00
  %v1915 = fmul double %v1916, %v1914
  %v1917 = getelementptr i8, ptr %v1911, i64 %v720
  %v1918 = load double, ptr %v1917, align 8, !noalias !238
  %v1919 = fadd double %v1918, %v1915
  %v1920 = fmul double %v1921, %v1919
  %v1922 = getelementptr i8, ptr %v1911, i64 %v721
  %v1923 = load double, ptr %v1922, align 8, !noalias !238
  %v1924 = fadd double %v1923, %v1920
  %v1925 = fmul double %v1916, %v1924
  %v1926 = getelementptr i8, ptr %v1911, i64 %v722
  %v1927 = load double, ptr %v1926, align 8, !noalias !238
  %v1928 = fadd double %v1927, %v1925
  %v1929 = fmul double %v1921, %v1928
  %v1930 = getelementptr i8, ptr %v1911, i64 %v723
  %v1931 = load double, ptr %v1930, align 8, !noalias !238
  %v1932 = fadd double %v1931, %v1929
  %v1933 = fmul double %v1916, %v1932
  %v1934 = getelementptr i8, ptr %v1911, i64 %v724
  %v1935 = load double, ptr %v1934, align 8, !noalias !238
  %v1936 = fadd double %v1935, %v1933
  %v1937 = fmul double %v1921, %v1936
  %v1938 = getelementptr i8, ptr %v1911, i64 %v725
  %v1939 = load double, ptr %v1938, align 8, !noalias !238
  %v1940 = fadd double %v1939, %v1937
  %v1941 = fmul double %v1916, %v1940
  %v1909 = add nsw i64 %v1907, 1
  %v1942 = load double, ptr %v1911, align 8, !noalias !238
  %v1943 = fadd double %v1942, %v1941
  %v1944 = getelementptr double, ptr %v716, i64 %v1910
  store double %v1943, ptr %v1944, align 8, !noalias !248
  %v1945 = icmp eq i64 %v10, %v1909
  br i1 %v1945, label %v1946, label %v1906

v1946:
  %v1947 = load i64, ptr %v718, align 8, !noalias !249
  %v1948 = inttoptr i64 %v1947 to ptr
  tail call void %v1948(ptr nonnull %v713, ptr %v801, ptr %v166, ptr %v173, ptr %v180, ptr %v803), !noalias !249
  store double %v1916, ptr %v741, align 8, !noalias !220
  %v1949 = load double, ptr %v1903, align 8, !noalias !220
  store double %v1949, ptr %v796, align 8, !noalias !220
  %v1950 = fcmp ogt double %v1949, 0.000000e+00
  br i1 %v1950, label %v1951, label %v1952

v1952:
  br i1 %v1953, label %v1954, label %v1955

v1954:
  %v1956 = load double, ptr %v794, align 8, !noalias !220
  br label %v1955

v1955:
  %v1957 = phi double [ %v1956, %v1954 ], [ %v1916, %v1952 ]
  %v1958 = fmul double %v1957, 5.000000e-01
  %v1959 = icmp eq i64 %v1960, 45
  br i1 %v1959, label %v1961, label %v1905

v1951:
  %v1962 = getelementptr double, ptr %v809, i64 %v1902
  store double 0.000000e+00, ptr %v1962, align 8, !noalias !220
  br label %v1963

v1964:
  %v1965 = sub nsw i64 45, %v1966
  %v1967 = load double, ptr %v796, align 8, !noalias !252
  %v1968 = load double, ptr %v798, align 8, !noalias !252
  br label %v1969

v1969:
  %v1970 = phi double [ %v1971, %v1969 ], [ 1.000000e+00, %v1964 ]
  %v1972 = phi double [ %v1973, %v1969 ], [ 2.000000e+00, %v1964 ]
  %v1974 = phi i64 [ %v1975, %v1969 ], [ %v1965, %v1964 ]
  %v1976 = and i64 %v1974, 1
  %v1977 = icmp eq i64 %v1976, 0
  %v1978 = fmul double %v1970, %v1972
  %v1971 = select i1 %v1977, double %v1970, double %v1978
  %v1975 = lshr i64 %v1974, 1
  %v1973 = fmul double %v1972, %v1972
  %v1979 = icmp eq i64 %v1975, 0
  br i1 %v1979, label %v1980, label %v1969

v1981:
  %v1982 = fcmp olt double %v1983, 0.000000e+00
  %v1984 = select i1 %v1982, double 0.000000e+00, double %v1983
  %v1985 = fmul double %v1986, %v1984
  %v1987 = fsub double %v1988, %v1985
  br label %v1989

v1980:
  %v1990 = fadd double %v1991, %v1992
  %v1988 = fmul double %v1990, 5.000000e-01
  %v1993 = fmul double %v1971, 0x3D06849B86A12B9B
  %v1994 = fsub double %v1993, %v1995
  %v1983 = fmul double %v1994, 5.000000e-01
  %v1996 = fmul double %v1992, %v1968
  %v1997 = fmul double %v1991, %v1967
  %v1998 = fsub double %v1996, %v1997
  %v1999 = fsub double %v1968, %v1967
  %v2000 = fdiv double %v1998, %v1999
  %v2001 = fcmp olt double %v1992, %v2000
  %v2002 = fcmp olt double %v2000, %v1991
  %v2003 = and i1 %v2001, %v2002
  %v2004 = select i1 %v2003, double %v2000, double %v1988
  %v2005 = fsub double %v1988, %v2004
  %v1986 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v2005)
  %v2006 = fmul double %v1995, %v1995
  %v2007 = tail call double @llvm.fabs.f64(double %v2005)
  %v2008 = fcmp olt double %v2007, %v2006
  %v2009 = select i1 %v2008, double %v2007, double %v2006
  %v2010 = fmul double %v1986, %v2009
  %v2011 = fadd double %v2004, %v2010
  %v2012 = fsub double %v2011, %v1988
  %v2013 = tail call double @llvm.fabs.f64(double %v2012)
  %v2014 = fcmp ugt double %v2013, %v1983
  br i1 %v2014, label %v1981, label %v1989

v2015:
  store double %v2016, ptr %v794, align 8, !noalias !258
  store double %v2017, ptr %v798, align 8, !noalias !258
  br label %v2018

v2019:
  store double %v2016, ptr %v741, align 8, !noalias !258
  store double %v2017, ptr %v796, align 8, !noalias !258
  br label %v2018

v2018:
  %v2020 = icmp eq i64 %v2021, 45
  br i1 %v2020, label %v2022, label %v1963

v1963:
  %v1966 = phi i64 [ 0, %v1951 ], [ %v2021, %v2018 ]
  %v2021 = add nsw i64 %v1966, 1
  %v1991 = load double, ptr %v794, align 8, !noalias !258
  %v1992 = load double, ptr %v741, align 8, !noalias !258
  %v1995 = fsub double %v1991, %v1992
  %v2023 = fcmp ugt double %v1995, 0x3D06849B86A12B9B
  br i1 %v2023, label %v1964, label %v2022

v1989:
  %v2016 = phi double [ %v2011, %v1980 ], [ %v1987, %v1981 ]
  %v2024 = load double, ptr %v134, align 8, !noalias !259
  %v2025 = load double, ptr %v711, align 8, !noalias !259
  %v2026 = fmul double %v2016, %v2025
  %v2027 = fadd double %v2024, %v2026
  store double %v2027, ptr %v713, align 8, !noalias !259
  br i1 %v799, label %v2028, label %v2029

v2028:
  %v2030 = fsub double 1.000000e+00, %v2016
  br label %v2031

v2031:
  %v2032 = phi i64 [ 0, %v2028 ], [ %v2033, %v2031 ]
  %v2034 = mul i64 %v2032, %v197
  %v2035 = getelementptr double, ptr %v194, i64 %v2034
  %v2036 = getelementptr i8, ptr %v2035, i64 %v719
  %v2037 = load double, ptr %v2036, align 8, !noalias !266
  %v2038 = fadd double %v2037, 0.000000e+00
  %v2039 = fmul double %v2016, %v2038
  %v2040 = getelementptr i8, ptr %v2035, i64 %v720
  %v2041 = load double, ptr %v2040, align 8, !noalias !266
  %v2042 = fadd double %v2041, %v2039
  %v2043 = fmul double %v2030, %v2042
  %v2044 = getelementptr i8, ptr %v2035, i64 %v721
  %v2045 = load double, ptr %v2044, align 8, !noalias !266
  %v2046 = fadd double %v2045, %v2043
  %v2047 = fmul double %v2016, %v2046
  %v2048 = getelementptr i8, ptr %v2035, i64 %v722
  %v2049 = load double, ptr %v2048, align 8, !noalias !266
  %v2050 = fadd double %v2049, %v2047
  %v2051 = fmul double %v2030, %v2050
  %v2052 = getelementptr i8, ptr %v2035, i64 %v723
  %v2053 = load double, ptr %v2052, align 8, !noalias !266
  %v2054 = fadd double %v2053, %v2051
  %v2055 = fmul double %v2016, %v2054
  %v2056 = getelementptr i8, ptr %v2035, i64 %v724
  %v2057 = load double, ptr %v2056, align 8, !noalias !266
  %v2058 = fadd double %v2057, %v2055
  %v2059 = fmul double %v2030, %v2058
  %v2060 = getelementptr i8, ptr %v2035, i64 %v725
  %v2061 = load double, ptr %v2060, align 8, !noalias !266
  %v2062 = fadd double %v2061, %v2059
  %v2063 = fmul double %v2016, %v2062
  %v2033 = add nsw i64 %v2032, 1
  %v2064 = load double, ptr %v2035, align 8, !noalias !266
  %v2065 = fadd double %v2064, %v2063
  %v2066 = getelementptr double, ptr %v716, i64 %v2034
  store double %v2065, ptr %v2066, align 8, !noalias !259
  %v2067 = icmp eq i64 %v10, %v2033
  br i1 %v2067, label %v2029, label %v2031

v2029:
  %v2068 = load i64, ptr %v718, align 8, !noalias !270
  %v2069 = inttoptr i64 %v2068 to ptr
  tail call void %v2069(ptr nonnull %v713, ptr %v801, ptr %v166, ptr %v173, ptr %v180, ptr %v803), !noalias !270
  br i1 %v805, label %v2070, label %v2071

v2071:
  %v2072 = phi double [ %v2073, %v2071 ], [ 0x7FF0000000000000, %v2029 ]
  %v2074 = phi i64 [ %v2075, %v2071 ], [ 0, %v2029 ]
  %v2075 = add nsw i64 %v2074, 1
  %v2076 = getelementptr double, ptr %v807, i64 %v2074
  %v2077 = load double, ptr %v2076, align 8, !noalias !273
  %v2078 = getelementptr double, ptr %v809, i64 %v2074
  %v2079 = load double, ptr %v2078, align 8, !noalias !273
  %v2080 = fadd double %v2077, %v2079
  %v2081 = fcmp olt double %v2080, %v2072
  %v2073 = select i1 %v2081, double %v2080, double %v2072
  %v2082 = icmp eq i64 %v208, %v2075
  br i1 %v2082, label %v2070, label %v2071

v2070:
  %v2017 = phi double [ 0x7FF0000000000000, %v2029 ], [ %v2073, %v2071 ]
  %v2083 = fcmp olt double %v2017, 0.000000e+00
  br i1 %v2083, label %v2015, label %v2019

v1961:
  store double 0.000000e+00, ptr %v794, align 8, !noalias !220
  br label %v2084

v2084:
  store i64 %v1900, ptr %v816, align 8, !noalias !220
  %v2085 = load i64, ptr %v143, align 8, !noalias !277
  %v2086 = icmp sgt i64 %v2085, -1
  br i1 %v2086, label %v2087, label %v2088

v2087:
  %v2089 = getelementptr i64, ptr %v111, i64 %v2085
  %v2090 = load i64, ptr %v2089, align 8, !noalias !277
  %v2091 = icmp eq i64 %v2090, 0
  br i1 %v2091, label %v2092, label %v2088

v2092:
  store i64 4, ptr %v2089, align 8, !noalias !277
  br label %v2088

v2088:
  store double 0.000000e+00, ptr %v818, align 8, !noalias !220
  br label %v1727

v1897:
  %v2093 = phi i64 [ 0, %v1856 ], [ %v2094, %v2095 ]
  %v2096 = phi i64 [ %v810, %v1856 ], [ %v2097, %v2095 ]
  %v2098 = icmp sgt i64 %v2096, 0
  br i1 %v2098, label %v2095, label %v2099

v2095:
  %v2097 = add nsw i64 %v2096, -1
  %v2094 = add i64 %v2093, 1
  %v2100 = getelementptr double, ptr %v813, i64 %v2093
  %v2101 = load double, ptr %v2100, align 8, !noalias !280
  %v2102 = getelementptr double, ptr %v814, i64 %v2093
  %v2103 = load double, ptr %v2102, align 8, !noalias !280
  %v2104 = fneg double %v2103
  %v2105 = fcmp olt double %v2101, %v2104
  br i1 %v2105, label %v2099, label %v1897

v2099:
  %v1900 = phi i64 [ %v2093, %v2095 ], [ -1, %v1897 ]
  %v2106 = icmp slt i64 %v1900, %v19
  br i1 %v2106, label %v2107, label %v1898

v1905:
  %v1916 = phi double [ %v1591, %v1898 ], [ %v1958, %v1955 ]
  %v2108 = phi i64 [ 0, %v1898 ], [ %v1960, %v1955 ]
  %v1960 = add nsw i64 %v2108, 1
  %v1953 = icmp eq i64 %v2108, 0
  %v2109 = load double, ptr %v134, align 8, !noalias !248
  %v2110 = load double, ptr %v711, align 8, !noalias !248
  %v2111 = fmul double %v1916, %v2110
  %v2112 = fadd double %v2109, %v2111
  store double %v2112, ptr %v713, align 8, !noalias !248
  br i1 %v715, label %v1946, label %v1908

v1908:
  %v1921 = fsub double 1.000000e+00, %v1916
  br label %v1906

v2022:
  store double 1.000000e-09, ptr %v1962, align 8, !noalias !220
  br label %v2084

v2107:
  store double 1.000000e+00, ptr %v820, align 8, !noalias !166
  %v2113 = load double, ptr %v743, align 8, !noalias !284
  %v2114 = load double, ptr %v93, align 8, !noalias !284
  %v2115 = fsub double %v2113, %v2114
  %v2116 = fmul double %v2115, 1.000000e-13
  %v2117 = load double, ptr %v134, align 8, !noalias !284
  %v2118 = tail call double @llvm.fabs.f64(double %v2117)
  %v2119 = fmul double %v2118, 4.000000e-15
  %v2120 = fcmp ogt double %v2119, %v2116
  %v2121 = select i1 %v2120, double %v2119, double %v2116
  %v2122 = load double, ptr %v794, align 8, !noalias !166
  %v2123 = fdiv double %v2121, %v1592
  %v2124 = fcmp ogt double %v2123, %v2122
  %v2125 = select i1 %v2124, double %v2123, double %v2122
  %v2126 = fcmp ult double %v2125, 1.000000e+00
  br i1 %v2126, label %v2127, label %v1727

v2127:
  %v2128 = fsub double 1.000000e+00, %v2125
  br i1 %v681, label %v2129, label %v2130

v2129:
  %v2131 = load double, ptr %v822, align 8, !noalias !166
  %v2132 = fmul double %v2125, 4.000000e+00
  %v2133 = fmul double %v2132, %v2128
  %v2134 = fmul double %v2133, %v2131
  %v2135 = fmul double %v2133, %v2134
  %v2136 = fcmp olt double %v2135, 5.000000e-04
  br i1 %v2136, label %v2137, label %v2130

v2137:
  %v2138 = load double, ptr %v711, align 8, !noalias !288
  %v2139 = fmul double %v2125, %v2138
  %v2140 = fadd double %v2117, %v2139
  store double %v2140, ptr %v713, align 8, !noalias !288
  br i1 %v715, label %v2141, label %v2142

v2142:
  %v2143 = phi i64 [ %v2144, %v2142 ], [ 0, %v2137 ]
  %v2145 = mul i64 %v2143, %v197
  %v2146 = getelementptr double, ptr %v194, i64 %v2145
  %v2147 = getelementptr i8, ptr %v2146, i64 %v719
  %v2148 = load double, ptr %v2147, align 8, !noalias !295
  %v2149 = fadd double %v2148, 0.000000e+00
  %v2150 = fmul double %v2125, %v2149
  %v2151 = getelementptr i8, ptr %v2146, i64 %v720
  %v2152 = load double, ptr %v2151, align 8, !noalias !295
  %v2153 = fadd double %v2152, %v2150
  %v2154 = fmul double %v2128, %v2153
  %v2155 = getelementptr i8, ptr %v2146, i64 %v721
  %v2156 = load double, ptr %v2155, align 8, !noalias !295
  %v2157 = fadd double %v2156, %v2154
  %v2158 = fmul double %v2125, %v2157
  %v2159 = getelementptr i8, ptr %v2146, i64 %v722
  %v2160 = load double, ptr %v2159, align 8, !noalias !295
  %v2161 = fadd double %v2160, %v2158
  %v2162 = fmul double %v2128, %v2161
  %v2163 = getelementptr i8, ptr %v2146, i64 %v723
  %v2164 = load double, ptr %v2163, align 8, !noalias !295
  %v2165 = fadd double %v2164, %v2162
  %v2166 = fmul double %v2125, %v2165
  %v2167 = getelementptr i8, ptr %v2146, i64 %v724
  %v2168 = load double, ptr %v2167, align 8, !noalias !295
  %v2169 = fadd double %v2168, %v2166
  %v2170 = fmul double %v2128, %v2169
  %v2171 = getelementptr i8, ptr %v2146, i64 %v725
  %v2172 = load double, ptr %v2171, align 8, !noalias !295
  %v2173 = fadd double %v2172, %v2170
  %v2174 = fmul double %v2125, %v2173
  %v2144 = add nsw i64 %v2143, 1
  %v2175 = load double, ptr %v2146, align 8, !noalias !295
  %v2176 = fadd double %v2175, %v2174
  %v2177 = getelementptr double, ptr %v716, i64 %v2145
  store double %v2176, ptr %v2177, align 8, !noalias !288
  %v2178 = icmp eq i64 %v10, %v2144
  br i1 %v2178, label %v2179, label %v2142

v2141:
  %v2180 = load double, ptr %v713, align 8, !noalias !299
  store double %v2180, ptr %v745, align 8, !noalias !299
  br label %v2181

v2181:
  %v2182 = load i64, ptr %v6, align 8, !noalias !300
  %v2183 = inttoptr i64 %v2182 to ptr
  tail call void %v2183(ptr nonnull %v713, ptr %v832, ptr %v166, ptr %v173, ptr %v180, ptr %v834), !noalias !300
  %v2184 = load i64, ptr %v718, align 8, !noalias !303
  %v2185 = inttoptr i64 %v2184 to ptr
  tail call void %v2185(ptr nonnull %v713, ptr %v836, ptr %v166, ptr %v173, ptr %v180, ptr %v838), !noalias !303
  br label %v1727

v2179:
  %v2186 = load double, ptr %v713, align 8, !noalias !299
  store double %v2186, ptr %v745, align 8, !noalias !299
  br label %v2187

v2187:
  %v2188 = phi i64 [ 0, %v2179 ], [ %v2189, %v2187 ]
  %v2189 = add nsw i64 %v2188, 1
  %v2190 = mul i64 %v2188, %v197
  %v2191 = getelementptr double, ptr %v716, i64 %v2190
  %v2192 = load double, ptr %v2191, align 8, !noalias !299
  %v2193 = getelementptr double, ptr %v829, i64 %v2190
  store double %v2192, ptr %v2193, align 8, !noalias !299
  %v2194 = icmp eq i64 %v10, %v2189
  br i1 %v2194, label %v2181, label %v2187

v2130:
  %v2195 = fmul double %v2121, 2.000000e+00
  %v2196 = fcmp ogt double %v1592, %v2195
  br i1 %v2196, label %v2197, label %v1727

v2197:
  %v2198 = load double, ptr %v745, align 8, !noalias !166
  %v2199 = tail call double @llvm.fabs.f64(double %v2198)
  %v2200 = fmul double %v2199, 4.000000e-15
  %v2201 = fmul double %v1592, 0x3D719799812DEA11
  %v2202 = fcmp ogt double %v2200, %v2201
  %v2203 = select i1 %v2202, double %v2200, double %v2201
  %v2204 = load double, ptr %v741, align 8, !noalias !166
  %v2205 = fsub double 1.000000e+00, %v2204
  %v2206 = fmul double %v1592, %v2205
  %v2207 = fcmp ogt double %v2206, %v2203
  br i1 %v2207, label %v2208, label %v1727

v2208:
  %v2209 = fmul double %v1592, %v2125
  store double 0.000000e+00, ptr %v824, align 8, !noalias !306
  store double 0.000000e+00, ptr %v826, align 8, !noalias !306
  store double %v2209, ptr %v827, align 8, !noalias !306
  %v2210 = load i64, ptr %v143, align 8, !noalias !306
  %v2211 = icmp slt i64 %v2210, 0
  %v2212 = select i1 %v2211, i64 %v126, i64 0
  %v2213 = add i64 %v2212, %v2210
  %v2214 = mul i64 %v2213, %v127
  %v2215 = getelementptr i64, ptr %v125, i64 %v2214
  %v2216 = load i64, ptr %v2215, align 8, !noalias !306
  %v2217 = add nsw i64 %v2216, -1
  store i64 %v2217, ptr %v2215, align 8, !noalias !306
  %v2218 = load i64, ptr %v143, align 8, !noalias !306
  %v2219 = icmp slt i64 %v2218, 0
  %v2220 = select i1 %v2219, i64 %v126, i64 0
  %v2221 = add i64 %v2220, %v2218
  %v2222 = mul i64 %v2221, %v127
  %v2223 = getelementptr i64, ptr %v125, i64 %v2222
  %v2224 = getelementptr i8, ptr %v2223, i64 24
  %v2225 = load i64, ptr %v2224, align 8, !noalias !306
  %v2226 = add nsw i64 %v2225, 1
  store i64 %v2226, ptr %v2224, align 8, !noalias !306
  br label %v1727

v1662:
  call void @llvm.lifetime.start.p0(ptr nonnull %v280), !noalias !166
  call void @llvm.lifetime.start.p0(ptr nonnull %v281), !noalias !166
  store i8 0, ptr %v280, align 1, !noalias !309
  store ptr null, ptr %v281, align 8, !noalias !309
  %v2227 = load double, ptr %v741, align 8, !noalias !309
  %v2228 = load double, ptr %v750, align 8, !noalias !309
  %v2229 = load double, ptr %v752, align 8, !noalias !309
  %v2230 = load double, ptr %v754, align 8, !noalias !309
  br i1 %v285, label %v2231, label %v2232

v2233:
  %v2234 = phi i64 [ %v2235, %v2236 ], [ 0, %v2237 ]
  %v2235 = add nsw i64 %v2234, 1
  %v2238 = icmp ult i64 %v2234, 9
  br i1 %v2238, label %v2239, label %v2240

v2239:
  %v2241 = getelementptr inbounds double, ptr @switch.table.advance_of_many.2, i64 %v2234
  %v2242 = load double, ptr %v2241, align 8
  %v2243 = load double, ptr %v134, align 8, !noalias !313
  %v2244 = load double, ptr %v711, align 8, !noalias !313
  %v2245 = fmul double %v2242, %v2244
  %v2246 = fadd double %v2243, %v2245
  store double %v2246, ptr %v713, align 8, !noalias !313
  br i1 %v715, label %v2236, label %v2247

v2247:
  %v2248 = fsub double 1.000000e+00, %v2242
  br label %v2249

v2249:
  %v2250 = phi i64 [ 0, %v2247 ], [ %v2251, %v2249 ]
  %v2252 = mul i64 %v2250, %v197
  %v2253 = getelementptr double, ptr %v194, i64 %v2252
  %v2254 = getelementptr i8, ptr %v2253, i64 %v719
  %v2255 = load double, ptr %v2254, align 8, !noalias !320
  %v2256 = fadd double %v2255, 0.000000e+00
  %v2257 = fmul double %v2242, %v2256
  %v2258 = getelementptr i8, ptr %v2253, i64 %v720
  %v2259 = load double, ptr %v2258, align 8, !noalias !320
  %v2260 = fadd double %v2259, %v2257
  %v2261 = fmul double %v2248, %v2260
  %v2262 = getelementptr i8, ptr %v2253, i64 %v721
  %v2263 = load double, ptr %v2262, align 8, !noalias !320
  %v2264 = fadd double %v2263, %v2261
  %v2265 = fmul double %v2242, %v2264
  %v2266 = getelementptr i8, ptr %v2253, i64 %v722
  %v2267 = load double, ptr %v2266, align 8, !noalias !320
  %v2268 = fadd double %v2267, %v2265
  %v2269 = fmul double %v2248, %v2268
  %v2270 = getelementptr i8, ptr %v2253, i64 %v723
  %v2271 = load double, ptr %v2270, align 8, !noalias !320
  %v2272 = fadd double %v2271, %v2269
  %v2273 = fmul double %v2242, %v2272
  %v2274 = getelementptr i8, ptr %v2253, i64 %v724
  %v2275 = load double, ptr %v2274, align 8, !noalias !320
  %v2276 = fadd double %v2275, %v2273
  %v2277 = fmul double %v2248, %v2276
  %v2278 = getelementptr i8, ptr %v2253, i64 %v725
  %v2279 = load double, ptr %v2278, align 8, !noalias !320
  %v2280 = fadd double %v2279, %v2277
  %v2281 = fmul double %v2242, %v2280
  %v2251 = add nsw i64 %v2250, 1
  %v2282 = load double, ptr %v2253, align 8, !noalias !320
  %v2283 = fadd double %v2282, %v2281
  %v2284 = getelementptr double, ptr %v716, i64 %v2252
  store double %v2283, ptr %v2284, align 8, !noalias !313
  %v2285 = icmp eq i64 %v10, %v2251
  br i1 %v2285, label %v2236, label %v2249

v2236:
  %v2286 = icmp eq i64 %v2234, 8
  %v2287 = select i1 %v2286, i64 17, i64 16
  %v2288 = mul i64 %v2234, %v717
  %v2289 = load i64, ptr %v718, align 8, !noalias !324
  %v2290 = mul nsw i64 %v2287, %v10
  %v2291 = getelementptr double, ptr %v159, i64 %v2290
  %v2292 = getelementptr double, ptr %v187, i64 %v2288
  %v2293 = inttoptr i64 %v2289 to ptr
  tail call void %v2293(ptr nonnull %v713, ptr %v2291, ptr %v166, ptr %v173, ptr %v180, ptr %v2292), !noalias !324
  %v2294 = icmp eq i64 %v2235, 9
  br i1 %v2294, label %v2240, label %v2233

v2240:
  %v2295 = phi ptr [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28, %v2233 ], [ %v2296, %v2236 ]
  %v2297 = phi i32 [ 1, %v2233 ], [ 0, %v2236 ]
  br i1 %v2238, label %v2298, label %v2299, !prof !121

v2300:
  %v2301 = load double, ptr %v783, align 8, !noalias !309
  %v2302 = fcmp ogt double %v2301, 5.000000e-01
  br i1 %v2302, label %v2303, label %v2304

v2303:
  %v2305 = load i64, ptr %v6, align 8, !noalias !327
  %v2306 = inttoptr i64 %v2305 to ptr
  tail call void %v2306(ptr nonnull %v745, ptr %v788, ptr %v166, ptr %v173, ptr %v180, ptr %v790), !noalias !327
  %v2307 = load double, ptr %v745, align 8, !noalias !309
  store double %v2307, ptr %v748, align 8, !noalias !309
  br label %v2308

v2309:
  %v2310 = sub nsw i64 45, %v2311
  %v2312 = load double, ptr %v752, align 8, !noalias !330
  %v2313 = load double, ptr %v754, align 8, !noalias !330
  br label %v2314

v2314:
  %v2315 = phi double [ %v2316, %v2314 ], [ 1.000000e+00, %v2309 ]
  %v2317 = phi double [ %v2318, %v2314 ], [ 2.000000e+00, %v2309 ]
  %v2319 = phi i64 [ %v2320, %v2314 ], [ %v2310, %v2309 ]
  %v2321 = and i64 %v2319, 1
  %v2322 = icmp eq i64 %v2321, 0
  %v2323 = fmul double %v2315, %v2317
  %v2316 = select i1 %v2322, double %v2315, double %v2323
  %v2320 = lshr i64 %v2319, 1
  %v2318 = fmul double %v2317, %v2317
  %v2324 = icmp eq i64 %v2320, 0
  br i1 %v2324, label %v2325, label %v2314

v2326:
  %v2327 = fcmp olt double %v2328, 0.000000e+00
  %v2329 = select i1 %v2327, double 0.000000e+00, double %v2328
  %v2330 = fmul double %v2331, %v2329
  %v2332 = fsub double %v2333, %v2330
  br label %v2334

v2325:
  %v2335 = fadd double %v2336, %v2337
  %v2333 = fmul double %v2335, 5.000000e-01
  %v2338 = fmul double %v2316, 1.000000e-05
  %v2339 = fsub double %v2338, %v2340
  %v2328 = fmul double %v2339, 5.000000e-01
  %v2341 = fmul double %v2337, %v2313
  %v2342 = fmul double %v2336, %v2312
  %v2343 = fsub double %v2341, %v2342
  %v2344 = fsub double %v2313, %v2312
  %v2345 = fdiv double %v2343, %v2344
  %v2346 = fcmp olt double %v2337, %v2345
  %v2347 = fcmp olt double %v2345, %v2336
  %v2348 = and i1 %v2346, %v2347
  %v2349 = select i1 %v2348, double %v2345, double %v2333
  %v2350 = fsub double %v2333, %v2349
  %v2331 = tail call double @llvm.copysign.f64(double 1.000000e+00, double %v2350)
  %v2351 = fmul double %v2340, %v2340
  %v2352 = tail call double @llvm.fabs.f64(double %v2350)
  %v2353 = fcmp olt double %v2352, %v2351
  %v2354 = select i1 %v2353, double %v2352, double %v2351
  %v2355 = fmul double %v2331, %v2354
  %v2356 = fadd double %v2349, %v2355
  %v2357 = fsub double %v2356, %v2333
  %v2358 = tail call double @llvm.fabs.f64(double %v2357)
  %v2359 = fcmp ugt double %v2358, %v2328
  br i1 %v2359, label %v2326, label %v2334

v2360:
  store double %v2361, ptr %v750, align 8, !noalias !336
  store double %v2362, ptr %v754, align 8, !noalias !336
  br label %v2363

v2364:
  store double %v2361, ptr %v741, align 8, !noalias !336
  store double %v2362, ptr %v752, align 8, !noalias !336
  br label %v2363

v2363:
  %v2365 = icmp eq i64 %v2366, 45
  br i1 %v2365, label %v2367, label %v2368

v2368:
  %v2311 = phi i64 [ %v2366, %v2363 ], [ 0, %v2369 ]
  %v2366 = add nsw i64 %v2311, 1
  %v2336 = load double, ptr %v750, align 8, !noalias !336
  %v2337 = load double, ptr %v741, align 8, !noalias !336
  %v2340 = fsub double %v2336, %v2337
  %v2370 = fcmp ugt double %v2340, 1.000000e-05
  br i1 %v2370, label %v2309, label %v2367

v2334:
  %v2361 = phi double [ %v2356, %v2325 ], [ %v2332, %v2326 ]
  %v2371 = load double, ptr %v134, align 8, !noalias !337
  %v2372 = load double, ptr %v711, align 8, !noalias !337
  %v2373 = fmul double %v2361, %v2372
  %v2374 = fadd double %v2371, %v2373
  store double %v2374, ptr %v713, align 8, !noalias !337
  br i1 %v715, label %v2375, label %v2376

v2376:
  %v2377 = fsub double 1.000000e+00, %v2361
  br label %v2378

v2378:
  %v2379 = phi i64 [ 0, %v2376 ], [ %v2380, %v2378 ]
  %v2381 = mul i64 %v2379, %v197
  %v2382 = getelementptr double, ptr %v194, i64 %v2381
  %v2383 = getelementptr i8, ptr %v2382, i64 %v719
  %v2384 = load double, ptr %v2383, align 8, !noalias !344
  %v2385 = fadd double %v2384, 0.000000e+00
  %v2386 = fmul double %v2361, %v2385
  %v2387 = getelementptr i8, ptr %v2382, i64 %v720
  %v2388 = load double, ptr %v2387, align 8, !noalias !344
  %v2389 = fadd double %v2388, %v2386
  %v2390 = fmul double %v2377, %v2389
  %v2391 = getelementptr i8, ptr %v2382, i64 %v721
  %v2392 = load double, ptr %v2391, align 8, !noalias !344
  %v2393 = fadd double %v2392, %v2390
  %v2394 = fmul double %v2361, %v2393
  %v2395 = getelementptr i8, ptr %v2382, i64 %v722
  %v2396 = load double, ptr %v2395, align 8, !noalias !344
  %v2397 = fadd double %v2396, %v2394
  %v2398 = fmul double %v2377, %v2397
  %v2399 = getelementptr i8, ptr %v2382, i64 %v723
  %v2400 = load double, ptr %v2399, align 8, !noalias !344
  %v2401 = fadd double %v2400, %v2398
  %v2402 = fmul double %v2361, %v2401
  %v2403 = getelementptr i8, ptr %v2382, i64 %v724
  %v2404 = load double, ptr %v2403, align 8, !noalias !344
  %v2405 = fadd double %v2404, %v2402
  %v2406 = fmul double %v2377, %v2405
  %v2407 = getelementptr i8, ptr %v2382, i64 %v725
  %v2408 = load double, ptr %v2407, align 8, !noalias !344
  %v2409 = fadd double %v2408, %v2406
  %v2410 = fmul double %v2361, %v2409
  %v2380 = add nsw i64 %v2379, 1
  %v2411 = load double, ptr %v2382, align 8, !noalias !344
  %v2412 = fadd double %v2411, %v2410
  %v2413 = getelementptr double, ptr %v716, i64 %v2381
  store double %v2412, ptr %v2413, align 8, !noalias !337
  %v2414 = icmp eq i64 %v10, %v2380
  br i1 %v2414, label %v2375, label %v2378

v2375:
  %v2415 = load i64, ptr %v718, align 8, !noalias !348
  %v2416 = inttoptr i64 %v2415 to ptr
  tail call void %v2416(ptr nonnull %v713, ptr %v756, ptr %v166, ptr %v173, ptr %v180, ptr %v758), !noalias !348
  br i1 %v761, label %v2417, label %v2418

v2418:
  %v2419 = phi double [ %v2420, %v2418 ], [ 0x7FF0000000000000, %v2375 ]
  %v2421 = phi i64 [ %v2422, %v2418 ], [ 0, %v2375 ]
  %v2422 = add nsw i64 %v2421, 1
  %v2423 = getelementptr double, ptr %v763, i64 %v2421
  %v2424 = load double, ptr %v2423, align 8, !noalias !351
  %v2425 = getelementptr double, ptr %v765, i64 %v2421
  %v2426 = load double, ptr %v2425, align 8, !noalias !351
  %v2427 = fadd double %v2424, %v2426
  %v2428 = fcmp olt double %v2427, %v2419
  %v2420 = select i1 %v2428, double %v2427, double %v2419
  %v2429 = icmp eq i64 %v208, %v2422
  br i1 %v2429, label %v2417, label %v2418

v2417:
  %v2362 = phi double [ 0x7FF0000000000000, %v2375 ], [ %v2420, %v2418 ]
  %v2430 = fcmp olt double %v2362, 0.000000e+00
  br i1 %v2430, label %v2360, label %v2364

v2367:
  %v2431 = icmp ugt i64 %v2432, 1
  br i1 %v2431, label %v2433, label %v2304

v2304:
  br i1 %v784, label %v2434, label %v2435

v2434:
  %v2436 = load i64, ptr %v774, align 8, !noalias !355
  %v2437 = inttoptr i64 %v2436 to ptr
  tail call void %v2437(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !355
  store double %v2227, ptr %v741, align 8, !noalias !309
  store double %v2228, ptr %v750, align 8, !noalias !309
  store double %v2229, ptr %v752, align 8, !noalias !309
  store double %v2230, ptr %v754, align 8, !noalias !309
  br label %v2308

v2435:
  %v2438 = phi i64 [ %v2439, %v2435 ], [ 0, %v2304 ]
  %v2439 = add nsw i64 %v2438, 1
  %v2440 = add nsw i64 %v2438, %v18
  %v2441 = icmp slt i64 %v2440, 0
  %v2442 = select i1 %v2441, i64 %v167, i64 0
  %v2443 = getelementptr double, ptr %v166, i64 %v2440
  %v2444 = getelementptr double, ptr %v2443, i64 %v2442
  %v2445 = load double, ptr %v2444, align 8, !noalias !361
  %v2446 = getelementptr double, ptr %v786, i64 %v2438
  %v2447 = load double, ptr %v2446, align 8, !noalias !361
  store double %v2447, ptr %v2444, align 8, !noalias !361
  store double %v2445, ptr %v2446, align 8, !noalias !361
  %v2448 = icmp eq i64 %v19, %v2439
  br i1 %v2448, label %v2434, label %v2435

v2231:
  %v2449 = phi i64 [ %v2450, %v2231 ], [ 0, %v1662 ]
  %v2450 = add nsw i64 %v2449, 1
  %v2451 = add nsw i64 %v2449, %v18
  %v2452 = icmp slt i64 %v2451, 0
  %v2453 = select i1 %v2452, i64 %v167, i64 0
  %v2454 = getelementptr double, ptr %v166, i64 %v2451
  %v2455 = getelementptr double, ptr %v2454, i64 %v2453
  %v2456 = load double, ptr %v2455, align 8, !noalias !309
  %v2457 = getelementptr double, ptr %v767, i64 %v2449
  store double %v2456, ptr %v2457, align 8, !noalias !309
  %v2458 = icmp eq i64 %v19, %v2450
  br i1 %v2458, label %v2232, label %v2231

v2232:
  br label %v2433

v2433:
  %v2296 = phi ptr [ %v2295, %v2367 ], [ null, %v2232 ]
  %v2459 = phi ptr [ %v2460, %v2367 ], [ null, %v2232 ]
  %v2432 = phi i64 [ %v2461, %v2367 ], [ 32, %v2232 ]
  %v2461 = add nsw i64 %v2432, -1
  %v2462 = load double, ptr %v750, align 8, !noalias !362
  %v2463 = load double, ptr %v134, align 8, !noalias !366
  %v2464 = load double, ptr %v711, align 8, !noalias !366
  %v2465 = fmul double %v2462, %v2464
  %v2466 = fadd double %v2463, %v2465
  store double %v2466, ptr %v713, align 8, !noalias !366
  br i1 %v715, label %v2467, label %v2468

v2468:
  %v2469 = fsub double 1.000000e+00, %v2462
  br label %v2470

v2470:
  %v2471 = phi i64 [ 0, %v2468 ], [ %v2472, %v2470 ]
  %v2473 = mul i64 %v2471, %v197
  %v2474 = getelementptr double, ptr %v194, i64 %v2473
  %v2475 = getelementptr i8, ptr %v2474, i64 %v719
  %v2476 = load double, ptr %v2475, align 8, !noalias !373
  %v2477 = fadd double %v2476, 0.000000e+00
  %v2478 = fmul double %v2462, %v2477
  %v2479 = getelementptr i8, ptr %v2474, i64 %v720
  %v2480 = load double, ptr %v2479, align 8, !noalias !373
  %v2481 = fadd double %v2480, %v2478
  %v2482 = fmul double %v2469, %v2481
  %v2483 = getelementptr i8, ptr %v2474, i64 %v721
  %v2484 = load double, ptr %v2483, align 8, !noalias !373
  %v2485 = fadd double %v2484, %v2482
  %v2486 = fmul double %v2462, %v2485
  %v2487 = getelementptr i8, ptr %v2474, i64 %v722
  %v2488 = load double, ptr %v2487, align 8, !noalias !373
  %v2489 = fadd double %v2488, %v2486
  %v2490 = fmul double %v2469, %v2489
  %v2491 = getelementptr i8, ptr %v2474, i64 %v723
  %v2492 = load double, ptr %v2491, align 8, !noalias !373
  %v2493 = fadd double %v2492, %v2490
  %v2494 = fmul double %v2462, %v2493
  %v2495 = getelementptr i8, ptr %v2474, i64 %v724
  %v2496 = load double, ptr %v2495, align 8, !noalias !373
  %v2497 = fadd double %v2496, %v2494
  %v2498 = fmul double %v2469, %v2497
  %v2499 = getelementptr i8, ptr %v2474, i64 %v725
  %v2500 = load double, ptr %v2499, align 8, !noalias !373
  %v2501 = fadd double %v2500, %v2498
  %v2502 = fmul double %v2462, %v2501
  %v2472 = add nsw i64 %v2471, 1
  %v2503 = load double, ptr %v2474, align 8, !noalias !373
  %v2504 = fadd double %v2503, %v2502
  %v2505 = getelementptr double, ptr %v716, i64 %v2473
  store double %v2504, ptr %v2505, align 8, !noalias !366
  %v2506 = icmp eq i64 %v10, %v2472
  br i1 %v2506, label %v2467, label %v2470

v2467:
  %v2507 = load i64, ptr %v718, align 8, !noalias !377
  %v2508 = inttoptr i64 %v2507 to ptr
  tail call void %v2508(ptr nonnull %v713, ptr %v756, ptr %v166, ptr %v173, ptr %v180, ptr %v758), !noalias !377
  br label %v2509

v2510:
  br label %v2511

v2511:
  %v2512 = phi double [ %v2462, %v2509 ], [ 1.000000e+00, %v2513 ], [ 8.889000e-01, %v2514 ], [ 2.500000e-01, %v2515 ], [ 3.333000e-01, %v2516 ], [ 5.000000e-01, %v2517 ], [ 0x3FE50A3D70A3D70A, %v2518 ], [ 7.500000e-01, %v2519 ], [ 0x3FB48E8A71DE69AD, %v2510 ]
  %v2520 = fcmp ult double %v2512, %v2462
  br i1 %v2520, label %v2521, label %v2522

v2522:
  %v2523 = load double, ptr %v134, align 8, !noalias !380
  %v2524 = load double, ptr %v711, align 8, !noalias !380
  %v2525 = fmul double %v2512, %v2524
  %v2526 = fadd double %v2523, %v2525
  store double %v2526, ptr %v713, align 8, !noalias !380
  br i1 %v715, label %v2527, label %v2528

v2528:
  %v2529 = fsub double 1.000000e+00, %v2512
  br label %v2530

v2530:
  %v2531 = phi i64 [ 0, %v2528 ], [ %v2532, %v2530 ]
  %v2533 = mul i64 %v2531, %v197
  %v2534 = getelementptr double, ptr %v194, i64 %v2533
  %v2535 = getelementptr i8, ptr %v2534, i64 %v719
  %v2536 = load double, ptr %v2535, align 8, !noalias !384
  %v2537 = fadd double %v2536, 0.000000e+00
  %v2538 = fmul double %v2512, %v2537
  %v2539 = getelementptr i8, ptr %v2534, i64 %v720
  %v2540 = load double, ptr %v2539, align 8, !noalias !384
  %v2541 = fadd double %v2540, %v2538
  %v2542 = fmul double %v2529, %v2541
  %v2543 = getelementptr i8, ptr %v2534, i64 %v721
  %v2544 = load double, ptr %v2543, align 8, !noalias !384
  %v2545 = fadd double %v2544, %v2542
  %v2546 = fmul double %v2512, %v2545
  %v2547 = getelementptr i8, ptr %v2534, i64 %v722
  %v2548 = load double, ptr %v2547, align 8, !noalias !384
  %v2549 = fadd double %v2548, %v2546
  %v2550 = fmul double %v2529, %v2549
  %v2551 = getelementptr i8, ptr %v2534, i64 %v723
  %v2552 = load double, ptr %v2551, align 8, !noalias !384
  %v2553 = fadd double %v2552, %v2550
  %v2554 = fmul double %v2512, %v2553
  %v2555 = getelementptr i8, ptr %v2534, i64 %v724
  %v2556 = load double, ptr %v2555, align 8, !noalias !384
  %v2557 = fadd double %v2556, %v2554
  %v2558 = fmul double %v2529, %v2557
  %v2559 = getelementptr i8, ptr %v2534, i64 %v725
  %v2560 = load double, ptr %v2559, align 8, !noalias !384
  %v2561 = fadd double %v2560, %v2558
  %v2562 = fmul double %v2512, %v2561
  %v2532 = add nsw i64 %v2531, 1
  %v2563 = load double, ptr %v2534, align 8, !noalias !384
  %v2564 = fadd double %v2563, %v2562
  %v2565 = getelementptr double, ptr %v716, i64 %v2533
  store double %v2564, ptr %v2565, align 8, !noalias !380
  %v2566 = icmp eq i64 %v10, %v2532
  br i1 %v2566, label %v2527, label %v2530

v2567:
  %v2568 = load i64, ptr %v774, align 8, !noalias !388
  %v2569 = inttoptr i64 %v2568 to ptr
  tail call void %v2569(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !388
  br label %v2521

v2570:
  %v2571 = phi i64 [ %v2572, %v2570 ], [ 0, %v2573 ]
  %v2572 = add nsw i64 %v2571, 1
  %v2574 = add nsw i64 %v2571, %v18
  %v2575 = icmp slt i64 %v2574, 0
  %v2576 = select i1 %v2575, i64 %v167, i64 0
  %v2577 = getelementptr double, ptr %v166, i64 %v2574
  %v2578 = getelementptr double, ptr %v2577, i64 %v2576
  %v2579 = load double, ptr %v2578, align 8, !noalias !394
  %v2580 = getelementptr double, ptr %v762, i64 %v2571
  %v2581 = load double, ptr %v2580, align 8, !noalias !394
  store double %v2581, ptr %v2578, align 8, !noalias !394
  store double %v2579, ptr %v2580, align 8, !noalias !394
  %v2582 = icmp eq i64 %v19, %v2572
  br i1 %v2582, label %v2567, label %v2570

v2521:
  %v2583 = icmp ugt i64 %v2584, 1
  br i1 %v2583, label %v2509, label %v2585

v2585:
  br i1 %v285, label %v2586, label %v2587

v2587:
  %v2588 = load i64, ptr %v774, align 8, !noalias !395
  %v2589 = inttoptr i64 %v2588 to ptr
  tail call void %v2589(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !395
  br label %v2590

v2586:
  %v2591 = phi i64 [ %v2592, %v2586 ], [ 0, %v2585 ]
  %v2592 = add nsw i64 %v2591, 1
  %v2593 = add nsw i64 %v2591, %v18
  %v2594 = icmp slt i64 %v2593, 0
  %v2595 = select i1 %v2594, i64 %v167, i64 0
  %v2596 = getelementptr double, ptr %v166, i64 %v2593
  %v2597 = getelementptr double, ptr %v2596, i64 %v2595
  %v2598 = load double, ptr %v2597, align 8, !noalias !401
  %v2599 = getelementptr double, ptr %v762, i64 %v2591
  %v2600 = load double, ptr %v2599, align 8, !noalias !401
  store double %v2600, ptr %v2597, align 8, !noalias !401
  store double %v2598, ptr %v2599, align 8, !noalias !401
  %v2601 = icmp eq i64 %v2592, %v19
  br i1 %v2601, label %v2587, label %v2586

v2509:
  %v2584 = phi i64 [ 9, %v2467 ], [ %v2602, %v2521 ]
  %v2603 = phi i64 [ 8, %v2467 ], [ %v2604, %v2521 ]
  %v2602 = add nsw i64 %v2584, -1
  %v2604 = add nsw i64 %v2603, -1
  switch i64 %v2603, label %v2590 [
    i64 0, label %v2511
    i64 -1, label %v2513
    i64 8, label %v2513
    i64 1, label %v2510
    i64 -8, label %v2510
    i64 2, label %v2515
    i64 -7, label %v2515
    i64 3, label %v2516
    i64 -6, label %v2516
    i64 4, label %v2517
    i64 -5, label %v2517
    i64 5, label %v2518
    i64 -4, label %v2518
    i64 6, label %v2519
    i64 -3, label %v2519
    i64 7, label %v2514
    i64 -2, label %v2514
  ]

v2515:
  br label %v2511

v2516:
  br label %v2511

v2517:
  br label %v2511

v2518:
  br label %v2511

v2519:
  br label %v2511

v2514:
  br label %v2511

v2513:
  br label %v2511

v2527:
  %v2605 = load i64, ptr %v6, align 8, !noalias !402
  %v2606 = inttoptr i64 %v2605 to ptr
  tail call void %v2606(ptr nonnull %v713, ptr %v771, ptr %v166, ptr %v173, ptr %v180, ptr %v773), !noalias !402
  br i1 %v285, label %v2607, label %v2608

v2608:
  %v2609 = load i64, ptr %v774, align 8, !noalias !405
  %v2610 = inttoptr i64 %v2609 to ptr
  tail call void %v2610(ptr nonnull %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !405
  %v2611 = load i64, ptr %v6, align 8, !noalias !411
  %v2612 = inttoptr i64 %v2611 to ptr
  tail call void %v2612(ptr nonnull %v713, ptr %v771, ptr %v166, ptr %v173, ptr %v180, ptr %v776), !noalias !411
  %v2613 = load double, ptr %v24, align 8, !noalias !414
  %v2614 = load double, ptr %v777, align 8, !noalias !414
  br label %v2615

v2607:
  %v2616 = phi i64 [ %v2617, %v2607 ], [ 0, %v2527 ]
  %v2617 = add nsw i64 %v2616, 1
  %v2618 = add nsw i64 %v2616, %v18
  %v2619 = icmp slt i64 %v2618, 0
  %v2620 = select i1 %v2619, i64 %v167, i64 0
  %v2621 = getelementptr double, ptr %v166, i64 %v2618
  %v2622 = getelementptr double, ptr %v2621, i64 %v2620
  %v2623 = load double, ptr %v2622, align 8, !noalias !418
  %v2624 = getelementptr double, ptr %v762, i64 %v2616
  %v2625 = load double, ptr %v2624, align 8, !noalias !418
  store double %v2625, ptr %v2622, align 8, !noalias !418
  store double %v2623, ptr %v2624, align 8, !noalias !418
  %v2626 = icmp eq i64 %v19, %v2617
  br i1 %v2626, label %v2608, label %v2607

v2615:
  %v2627 = phi i64 [ 0, %v2608 ], [ %v2628, %v2629 ]
  %v2630 = icmp eq i64 %v2627, %v768
  br i1 %v2630, label %v2573, label %v2629

v2573:
  br i1 %v285, label %v2570, label %v2567

v2629:
  %v2628 = add i64 %v2627, 1
  %v2631 = mul i64 %v2627, %v197
  %v2632 = getelementptr double, ptr %v779, i64 %v2631
  %v2633 = load double, ptr %v2632, align 8, !noalias !414
  %v2634 = getelementptr double, ptr %v781, i64 %v2631
  %v2635 = load double, ptr %v2634, align 8, !noalias !414
  %v2636 = fsub double %v2633, %v2635
  %v2637 = tail call double @llvm.fabs.f64(double %v2636)
  %v2638 = getelementptr double, ptr %v194, i64 %v2631
  %v2639 = load double, ptr %v2638, align 8, !noalias !414
  %v2640 = tail call double @llvm.fabs.f64(double %v2639)
  %v2641 = fmul double %v2613, %v2640
  %v2642 = fadd double %v2614, %v2641
  %v2643 = load double, ptr %v711, align 8, !noalias !414
  %v2644 = fmul double %v2643, %v2637
  %v2645 = fmul double %v2642, 1.000000e-01
  %v2646 = fcmp ugt double %v2644, %v2645
  br i1 %v2646, label %v2590, label %v2615

v2590:
  %v2647 = phi i1 [ false, %v2629 ], [ true, %v2587 ], [ true, %v2509 ]
  %v2460 = phi ptr [ %v2459, %v2629 ], [ %v2459, %v2587 ], [ @.const.picklebuf.a832a7f8175c2530692ab82e581e246bf5646a28.30, %v2509 ]
  %v2648 = phi i1 [ true, %v2629 ], [ true, %v2587 ], [ false, %v2509 ]
  %v2649 = phi i32 [ 0, %v2629 ], [ 0, %v2587 ], [ 1, %v2509 ]
  br i1 %v2648, label %v2237, label %v2299, !prof !121

v2237:
  br i1 %v2647, label %v2233, label %v2304

v2298:
  %v2650 = load double, ptr %v750, align 8, !noalias !309
  store i8 0, ptr %v280, align 1, !noalias !309
  %v2651 = call fastcc i32 @_ZN5pages12event_checks13find_crossingB3v59B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr %v280, ptr %v281, i64 %v13, ptr nonnull readonly %v93, i64 %v94, ptr %v125, i64 %v126, i64 %v127, ptr nonnull %v134, i64 %v136, ptr %v143, i64 %v145, ptr %v205, i64 %v206, i64 %v207, i64 %v208, double %v2650)
  %v2652 = icmp eq i32 %v2651, 0
  br i1 %v2652, label %v2369, label %v2653, !prof !121

v2653:
  %v2654 = load ptr, ptr %v281, align 8, !noalias !309
  br label %v2308

v2369:
  %v2655 = load i8, ptr %v280, align 1, !noalias !309
  %v2656 = icmp eq i8 %v2655, 0
  br i1 %v2656, label %v2300, label %v2368

v2299:
  %v2657 = phi ptr [ %v2295, %v2240 ], [ %v2460, %v2590 ]
  %v2658 = phi i32 [ %v2297, %v2240 ], [ %v2649, %v2590 ]
  %v2659 = icmp ne i32 %v2658, 0
  br label %v2308

v2308:
  %v2660 = phi i1 [ true, %v2303 ], [ false, %v2434 ], [ true, %v2653 ], [ %v2659, %v2299 ]
  %v2661 = phi ptr [ null, %v2303 ], [ null, %v2434 ], [ %v2654, %v2653 ], [ %v2657, %v2299 ]
  %v2662 = phi i1 [ false, %v2303 ], [ false, %v2434 ], [ true, %v2653 ], [ %v2659, %v2299 ]
  call void @llvm.lifetime.end.p0(ptr nonnull %v280), !noalias !166
  call void @llvm.lifetime.end.p0(ptr nonnull %v281), !noalias !166
  %v2663 = select i1 %v2662, ptr %v2661, ptr null, !prof !419
  %v2664 = xor i1 %v2662, true
  br i1 %v2660, label %v1727, label %v1724, !prof !420

v1787:
  br i1 %v284, label %v1849, label %v2107

v1727:
  %v2665 = phi ptr [ null, %v2181 ], [ null, %v2208 ], [ null, %v2130 ], [ null, %v2107 ], [ null, %v1724 ], [ null, %v2088 ], [ null, %v2197 ], [ %v2663, %v2308 ]
  %v2666 = phi i1 [ true, %v2181 ], [ true, %v2208 ], [ true, %v2130 ], [ true, %v2107 ], [ true, %v1724 ], [ true, %v2088 ], [ true, %v2197 ], [ %v2664, %v2308 ]
  br i1 %v2666, label %v1483, label %v1396, !prof !121

v1483:
  %v2667 = select i1 %v1303, i1 true, i1 %v644
  %v2668 = select i1 %v2667, i64 0, i64 %v12
  br label %v1396

v2669:
  %v2670 = phi i64 [ 0, %v1389 ], [ %v2671, %v2672 ]
  %v2673 = phi i64 [ %v673, %v1389 ], [ %v2674, %v2672 ]
  %v2675 = icmp sgt i64 %v2673, 0
  br i1 %v2675, label %v2672, label %v1390

v1389:
  %v2676 = load double, ptr %v672, align 8, !noalias !421
  store double %v2676, ptr %v658, align 8, !noalias !421
  br label %v2669

v2672:
  %v2674 = add nsw i64 %v2673, -1
  %v2671 = add i64 %v2670, 1
  %v2677 = getelementptr double, ptr %v675, i64 %v2670
  %v2678 = icmp slt i64 %v2670, 0
  %v2679 = select i1 %v2678, i64 %v208, i64 0
  %v2680 = getelementptr double, ptr %v2677, i64 %v2679
  %v2681 = load double, ptr %v2680, align 8, !noalias !421
  %v2682 = fcmp olt double %v2681, 0x7FF0000000000000
  %v2683 = select i1 %v2682, double %v2681, double 0x7FF0000000000000
  %v2684 = fcmp ogt double %v2681, 0xFFF0000000000000
  %v2685 = select i1 %v2684, double %v2681, double 0xFFF0000000000000
  %v2686 = getelementptr double, ptr %v2680, i64 %v674
  %v2687 = load double, ptr %v2686, align 8, !noalias !421
  %v2688 = fcmp olt double %v2687, %v2683
  %v2689 = select i1 %v2688, double %v2687, double %v2683
  %v2690 = fcmp ogt double %v2687, %v2685
  %v2691 = select i1 %v2690, double %v2687, double %v2685
  %v2692 = getelementptr i8, ptr %v2680, i64 %v985
  %v2693 = load double, ptr %v2692, align 8, !noalias !421
  %v2694 = fcmp olt double %v2693, %v2689
  %v2695 = select i1 %v2694, double %v2693, double %v2689
  %v2696 = fcmp ogt double %v2693, %v2691
  %v2697 = select i1 %v2696, double %v2693, double %v2691
  %v2698 = getelementptr i8, ptr %v2680, i64 %v986
  %v2699 = load double, ptr %v2698, align 8, !noalias !421
  %v2700 = fcmp olt double %v2699, %v2695
  %v2701 = select i1 %v2700, double %v2699, double %v2695
  %v2702 = fcmp ogt double %v2699, %v2697
  %v2703 = select i1 %v2702, double %v2699, double %v2697
  %v2704 = getelementptr i8, ptr %v2680, i64 %v987
  %v2705 = load double, ptr %v2704, align 8, !noalias !421
  %v2706 = fcmp olt double %v2705, %v2701
  %v2707 = select i1 %v2706, double %v2705, double %v2701
  %v2708 = fcmp ogt double %v2705, %v2703
  %v2709 = select i1 %v2708, double %v2705, double %v2703
  %v2710 = getelementptr i8, ptr %v2680, i64 %v988
  %v2711 = load double, ptr %v2710, align 8, !noalias !421
  %v2712 = fcmp olt double %v2711, %v2707
  %v2713 = select i1 %v2712, double %v2711, double %v2707
  %v2714 = fcmp ogt double %v2711, %v2709
  %v2715 = select i1 %v2714, double %v2711, double %v2709
  %v2716 = getelementptr i8, ptr %v2680, i64 %v989
  %v2717 = load double, ptr %v2716, align 8, !noalias !421
  %v2718 = fcmp olt double %v2717, %v2713
  %v2719 = select i1 %v2718, double %v2717, double %v2713
  %v2720 = fcmp ogt double %v2717, %v2715
  %v2721 = select i1 %v2720, double %v2717, double %v2715
  %v2722 = getelementptr i8, ptr %v2680, i64 %v990
  %v2723 = load double, ptr %v2722, align 8, !noalias !421
  %v2724 = fcmp olt double %v2723, %v2719
  %v2725 = select i1 %v2724, double %v2723, double %v2719
  %v2726 = fcmp ogt double %v2723, %v2721
  %v2727 = select i1 %v2726, double %v2723, double %v2721
  %v2728 = getelementptr i8, ptr %v2680, i64 %v991
  %v2729 = load double, ptr %v2728, align 8, !noalias !421
  %v2730 = fcmp olt double %v2729, %v2725
  %v2731 = select i1 %v2730, double %v2729, double %v2725
  %v2732 = fcmp ogt double %v2729, %v2727
  %v2733 = select i1 %v2732, double %v2729, double %v2727
  %v2734 = fsub double %v2733, %v2731
  %v2735 = fmul double %v2734, 2.500000e-01
  %v2736 = icmp slt i64 %v2670, 0
  %v2737 = select i1 %v2736, i64 %v208, i64 0
  %v2738 = add i64 %v2737, %v2670
  %v2739 = getelementptr double, ptr %v677, i64 %v2738
  %v2740 = getelementptr double, ptr %v678, i64 %v2738
  %v2741 = getelementptr double, ptr %v2739, i64 %v676
  %v2742 = load double, ptr %v2741, align 8, !noalias !422
  %v2743 = load double, ptr %v2740, align 8, !noalias !422
  %v2744 = fmul double %v2743, 0x3FDDF27AAAADCB3A
  %v2745 = fsub double %v2742, %v2744
  %v2746 = getelementptr i8, ptr %v2740, i64 %v992
  %v2747 = load double, ptr %v2746, align 8, !noalias !422
  %v2748 = fmul double %v2747, 0x3FEC575F1EBC4F2F
  %v2749 = fsub double %v2745, %v2748
  %v2750 = getelementptr i8, ptr %v2740, i64 %v993
  %v2751 = load double, ptr %v2750, align 8, !noalias !422
  %v2752 = fmul double %v2751, 0xBFE1306AA3D795F4
  %v2753 = fsub double %v2749, %v2752
  %v2754 = getelementptr i8, ptr %v2740, i64 %v994
  %v2755 = load double, ptr %v2754, align 8, !noalias !422
  %v2756 = fmul double %v2755, 0x3FCCB9F574BDCC3A
  %v2757 = fsub double %v2753, %v2756
  %v2758 = getelementptr i8, ptr %v2740, i64 %v995
  %v2759 = load double, ptr %v2758, align 8, !noalias !422
  %v2760 = fmul double %v2759, 0xBFA4EAF2D6B11E79
  %v2761 = fsub double %v2757, %v2760
  %v2762 = tail call double @llvm.fabs.f64(double %v2761)
  %v2763 = fcmp ogt double %v2762, 0.000000e+00
  %v2764 = select i1 %v2763, double %v2762, double 0.000000e+00
  %v2765 = getelementptr i8, ptr %v2739, i64 %v996
  %v2766 = load double, ptr %v2765, align 8, !noalias !422
  %v2767 = load double, ptr %v2740, align 8, !noalias !422
  %v2768 = fmul double %v2767, 0xBFA5118805F8B876
  %v2769 = fsub double %v2766, %v2768
  %v2770 = getelementptr i8, ptr %v2740, i64 %v997
  %v2771 = load double, ptr %v2770, align 8, !noalias !422
  %v2772 = fmul double %v2771, 0x3FE51326698BC5BD
  %v2773 = fsub double %v2769, %v2772
  %v2774 = getelementptr i8, ptr %v2740, i64 %v998
  %v2775 = load double, ptr %v2774, align 8, !noalias !422
  %v2776 = fmul double %v2775, 0x3FDF97DED30D4572
  %v2777 = fsub double %v2773, %v2776
  %v2778 = getelementptr i8, ptr %v2740, i64 %v999
  %v2779 = load double, ptr %v2778, align 8, !noalias !422
  %v2780 = fmul double %v2779, 0xBFC0DA0C684D1D67
  %v2781 = fsub double %v2777, %v2780
  %v2782 = getelementptr i8, ptr %v2740, i64 %v1000
  %v2783 = load double, ptr %v2782, align 8, !noalias !422
  %v2784 = fmul double %v2783, 0x3F9510B8EC0D4D92
  %v2785 = fsub double %v2781, %v2784
  %v2786 = tail call double @llvm.fabs.f64(double %v2785)
  %v2787 = fcmp ogt double %v2786, %v2764
  %v2788 = select i1 %v2787, double %v2786, double %v2764
  %v2789 = getelementptr i8, ptr %v2739, i64 %v1001
  %v2790 = load double, ptr %v2789, align 8, !noalias !422
  %v2791 = load double, ptr %v2740, align 8, !noalias !422
  %v2792 = fmul double %v2791, 0x3F9635A30F8F142F
  %v2793 = fsub double %v2790, %v2792
  %v2794 = getelementptr i8, ptr %v2740, i64 %v1002
  %v2795 = load double, ptr %v2794, align 8, !noalias !422
  %v2796 = fmul double %v2795, 0xBFC1EAE0FF33D241
  %v2797 = fsub double %v2793, %v2796
  %v2798 = getelementptr i8, ptr %v2740, i64 %v1003
  %v2799 = load double, ptr %v2798, align 8, !noalias !422
  %v2800 = fmul double %v2799, 0x3FE1625D59218460
  %v2801 = fsub double %v2797, %v2800
  %v2802 = getelementptr i8, ptr %v2740, i64 %v1004
  %v2803 = load double, ptr %v2802, align 8, !noalias !422
  %v2804 = fmul double %v2803, 0x3FE3BBC3E8A29641
  %v2805 = fsub double %v2801, %v2804
  %v2806 = getelementptr i8, ptr %v2740, i64 %v1005
  %v2807 = load double, ptr %v2806, align 8, !noalias !422
  %v2808 = fmul double %v2807, 0xBFA55161A739EB34
  %v2809 = fsub double %v2805, %v2808
  %v2810 = tail call double @llvm.fabs.f64(double %v2809)
  %v2811 = fcmp ogt double %v2810, %v2788
  %v2812 = select i1 %v2811, double %v2810, double %v2788
  %v2813 = getelementptr i8, ptr %v2739, i64 %v1006
  %v2814 = load double, ptr %v2813, align 8, !noalias !422
  %v2815 = load double, ptr %v2740, align 8, !noalias !422
  %v2816 = fmul double %v2815, 0xBFA4F0C0BB579409
  %v2817 = fsub double %v2814, %v2816
  %v2818 = getelementptr i8, ptr %v2740, i64 %v1007
  %v2819 = load double, ptr %v2818, align 8, !noalias !422
  %v2820 = fmul double %v2819, 0x3FCD2266FBC0D976
  %v2821 = fsub double %v2817, %v2820
  %v2822 = getelementptr i8, ptr %v2740, i64 %v1008
  %v2823 = load double, ptr %v2822, align 8, !noalias !422
  %v2824 = fmul double %v2823, 0xBFE1F2DB6FEE3151
  %v2825 = fsub double %v2821, %v2824
  %v2826 = getelementptr i8, ptr %v2740, i64 %v1009
  %v2827 = load double, ptr %v2826, align 8, !noalias !422
  %v2828 = fmul double %v2827, 0x3FF0C05015964CBE
  %v2829 = fsub double %v2825, %v2828
  %v2830 = getelementptr i8, ptr %v2740, i64 %v1010
  %v2831 = load double, ptr %v2830, align 8, !noalias !422
  %v2832 = fmul double %v2831, 0x3FD4F15B230DB570
  %v2833 = fsub double %v2829, %v2832
  %v2834 = tail call double @llvm.fabs.f64(double %v2833)
  %v2835 = fcmp ogt double %v2834, %v2812
  %v2836 = select i1 %v2835, double %v2834, double %v2812
  %v2837 = fmul double %v2836, 1.000000e+01
  %v2838 = fadd double %v2735, %v2837
  %v2839 = icmp slt i64 %v2670, 0
  %v2840 = select i1 %v2839, i64 %v208, i64 0
  %v2841 = getelementptr double, ptr %v680, i64 %v2670
  %v2842 = getelementptr double, ptr %v2841, i64 %v2840
  %v2843 = load double, ptr %v2842, align 8, !noalias !421
  %v2844 = fcmp ogt double %v2838, %v2843
  %v2845 = fneg double %v2843
  %v2846 = select i1 %v2844, double %v2838, double %v2845
  %v2847 = fcmp olt double %v2731, %v2846
  br i1 %v2847, label %v1390, label %v2669

v1390:
  %v1392 = phi i1 [ false, %v1332 ], [ %v2675, %v2672 ], [ %v2675, %v2669 ]
  %v2848 = phi ptr [ %v1387, %v1332 ], [ null, %v2672 ], [ null, %v2669 ]
  %v2849 = phi i32 [ %v1388, %v1332 ], [ 0, %v2672 ], [ 0, %v2669 ]
  %v2850 = icmp eq i32 %v2849, 0
  br i1 %v2850, label %v1322, label %v1396, !prof !121

v1589:
  br i1 %v1584, label %v1483, label %v1590

v1396:
  %v2851 = phi i64 [ 0, %v1322 ], [ %v2668, %v1483 ], [ 0, %v1390 ], [ 0, %v1548 ], [ 0, %v1727 ]
  %v2852 = phi i1 [ true, %v1322 ], [ true, %v1483 ], [ false, %v1390 ], [ false, %v1548 ], [ false, %v1727 ]
  %v2853 = phi ptr [ undef, %v1322 ], [ undef, %v1483 ], [ %v2848, %v1390 ], [ %v1588, %v1548 ], [ %v2665, %v1727 ]
  %v2854 = phi i32 [ 0, %v1322 ], [ 0, %v1483 ], [ 1, %v1390 ], [ 1, %v1548 ], [ 1, %v1727 ]
  br i1 %v2852, label %v2855, label %v2856, !prof !121

v2857:
  %v2858 = getelementptr double, ptr %v844, i64 %v2859
  %v2860 = load double, ptr %v2858, align 8, !noalias !426
  %v2861 = fcmp olt double %v2860, 5.000000e-01
  br i1 %v2861, label %v2862, label %v2863

v2863:
  %v2864 = getelementptr i64, ptr %v111, i64 %v2865
  %v2866 = load i64, ptr %v2864, align 8, !noalias !426
  %v2867 = icmp eq i64 %v2866, 0
  br i1 %v2867, label %v2868, label %v2862

v2868:
  %v2869 = mul i64 %v2865, %v127
  %v2870 = getelementptr i64, ptr %v125, i64 %v2869
  %v2871 = getelementptr i8, ptr %v2870, i64 8
  %v2872 = load i64, ptr %v2871, align 8, !noalias !426
  %v2873 = add nsw i64 %v2872, %v2851
  store i64 %v2873, ptr %v2871, align 8, !noalias !426
  %v2874 = getelementptr double, ptr %v846, i64 %v2859
  %v2875 = load double, ptr %v2874, align 8, !noalias !426
  %v2876 = icmp slt i64 %v2877, %v94
  br i1 %v2876, label %v2878, label %v2879

v2878:
  %v2880 = icmp slt i64 %v2877, 0
  %v2881 = select i1 %v2880, i64 %v94, i64 0
  %v2882 = getelementptr double, ptr %v93, i64 %v2877
  %v2883 = getelementptr double, ptr %v2882, i64 %v2881
  %v2884 = load double, ptr %v2883, align 8, !noalias !426
  %v2885 = fcmp ugt double %v2884, %v2875
  br i1 %v2885, label %v2879, label %v2886

v2886:
  %v2887 = getelementptr double, ptr %v134, i64 %v2859
  %v2888 = getelementptr double, ptr %v848, i64 %v2859
  %v2889 = getelementptr double, ptr %v194, i64 %v2859
  %v2890 = mul i64 %v839, %v2865
  %v2891 = getelementptr double, ptr %v852, i64 %v2859
  %v2892 = getelementptr double, ptr %v100, i64 %v2890
  %v2893 = getelementptr double, ptr %v853, i64 %v2859
  br label %v2894

v2894:
  %v2895 = phi i64 [ %v2896, %v2897 ], [ %v2877, %v2886 ]
  %v2898 = icmp slt i64 %v2895, 0
  %v2899 = select i1 %v2898, i64 %v94, i64 0
  %v2900 = getelementptr double, ptr %v93, i64 %v2895
  %v2901 = getelementptr double, ptr %v2900, i64 %v2899
  %v2902 = load double, ptr %v2901, align 8, !noalias !426
  %v2903 = load double, ptr %v2887, align 8, !noalias !426
  %v2904 = fsub double %v2902, %v2903
  %v2905 = load double, ptr %v2888, align 8, !noalias !426
  %v2906 = fdiv double %v2904, %v2905
  br i1 %v850, label %v2907, label %v2908

v2908:
  %v2909 = fsub double 1.000000e+00, %v2906
  %v2910 = select i1 %v2898, i64 %v102, i64 0
  %v2911 = add i64 %v2910, %v2895
  %v2912 = mul i64 %v2911, %v103
  %v2913 = getelementptr double, ptr %v2892, i64 %v2912
  br label %v2914

v2915:
  %v2916 = getelementptr double, ptr %v2893, i64 %v2917
  %v2918 = load double, ptr %v2916, align 8, !noalias !426
  br label %v2919

v2907:
  store double 0x7FF0000000000000, ptr %v2891, align 8, !noalias !426
  %v2920 = icmp eq i64 %v2895, %v854
  br i1 %v2920, label %v2879, label %v2897

v2897:
  %v2896 = add i64 %v2895, 1
  %v2921 = icmp slt i64 %v2895, -1
  %v2922 = select i1 %v2921, i64 %v94, i64 0
  %v2923 = getelementptr double, ptr %v93, i64 %v2896
  %v2924 = getelementptr double, ptr %v2923, i64 %v2922
  %v2925 = load double, ptr %v2924, align 8, !noalias !426
  %v2926 = fcmp ugt double %v2925, %v2875
  br i1 %v2926, label %v2879, label %v2894

v2879:
  %v2927 = phi i64 [ %v2877, %v2878 ], [ %v2877, %v2868 ], [ %v94, %v2907 ], [ %v2896, %v2897 ]
  store i64 %v2927, ptr %v2928, align 8, !noalias !426
  br label %v2862

v2862:
  %v2929 = icmp eq i64 %v2930, %v9
  br i1 %v2929, label %v2931, label %v2932

v2919:
  %v2933 = phi double [ %v2934, %v2935 ], [ %v2918, %v2915 ]
  %v2936 = getelementptr double, ptr %v2913, i64 %v2937
  store double %v2933, ptr %v2936, align 8, !noalias !426
  %v2938 = icmp eq i64 %v10, %v2939
  br i1 %v2938, label %v2907, label %v2914

v2932:
  %v2859 = phi i64 [ %v2930, %v2862 ], [ 0, %v2855 ]
  %v2930 = add nsw i64 %v2859, 1
  %v2940 = getelementptr i64, ptr %v143, i64 %v2859
  %v2865 = load i64, ptr %v2940, align 8, !noalias !426
  %v2928 = getelementptr i64, ptr %v842, i64 %v2859
  %v2877 = load i64, ptr %v2928, align 8, !noalias !426
  %v2941 = icmp slt i64 %v2865, 0
  br i1 %v2941, label %v2862, label %v2857

v2914:
  %v2937 = phi i64 [ 0, %v2908 ], [ %v2939, %v2919 ]
  %v2939 = add nsw i64 %v2937, 1
  %v2942 = load double, ptr %v2901, align 8, !noalias !426
  %v2943 = fcmp oeq double %v2942, %v2875
  %v2917 = mul i64 %v2937, %v197
  br i1 %v2943, label %v2915, label %v2935

v2935:
  %v2944 = getelementptr double, ptr %v2889, i64 %v2917
  %v2945 = getelementptr i8, ptr %v2944, i64 %v855
  %v2946 = load double, ptr %v2945, align 8, !noalias !429
  %v2947 = fadd double %v2946, 0.000000e+00
  %v2948 = fmul double %v2906, %v2947
  %v2949 = getelementptr i8, ptr %v2944, i64 %v856
  %v2950 = load double, ptr %v2949, align 8, !noalias !429
  %v2951 = fadd double %v2950, %v2948
  %v2952 = fmul double %v2909, %v2951
  %v2953 = getelementptr i8, ptr %v2944, i64 %v857
  %v2954 = load double, ptr %v2953, align 8, !noalias !429
  %v2955 = fadd double %v2954, %v2952
  %v2956 = fmul double %v2906, %v2955
  %v2957 = getelementptr i8, ptr %v2944, i64 %v858
  %v2958 = load double, ptr %v2957, align 8, !noalias !429
  %v2959 = fadd double %v2958, %v2956
  %v2960 = fmul double %v2909, %v2959
  %v2961 = getelementptr i8, ptr %v2944, i64 %v859
  %v2962 = load double, ptr %v2961, align 8, !noalias !429
  %v2963 = fadd double %v2962, %v2960
  %v2964 = fmul double %v2906, %v2963
  %v2965 = getelementptr i8, ptr %v2944, i64 %v860
  %v2966 = load double, ptr %v2965, align 8, !noalias !429
  %v2967 = fadd double %v2966, %v2964
  %v2968 = fmul double %v2909, %v2967
  %v2969 = getelementptr i8, ptr %v2944, i64 %v861
  %v2970 = load double, ptr %v2969, align 8, !noalias !429
  %v2971 = fadd double %v2970, %v2968
  %v2972 = fmul double %v2906, %v2971
  %v2973 = load double, ptr %v2944, align 8, !noalias !429
  %v2934 = fadd double %v2973, %v2972
  br label %v2919

v2931:
  br i1 %v862, label %v2974, label %v2975

v2975:
  %v2976 = load double, ptr %v864, align 8
  %v2977 = fcmp ogt double %v2976, 5.000000e-01
  br i1 %v2977, label %v2974, label %v2978

v2974:
  %v2979 = load i64, ptr %v865, align 8, !noalias !433
  %v2980 = inttoptr i64 %v2979 to ptr
  tail call void %v2980(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !433
  br label %v2978

v2978:
  br i1 %v1318, label %v2981, label %v2982

v2981:
  %v2983 = load double, ptr %v867, align 8, !noalias !436
  %v2984 = fcmp olt double %v2983, 5.000000e-01
  br i1 %v2984, label %v2982, label %v2985

v2985:
  br i1 %v869, label %v2986, label %v2987

v2988:
  %v2989 = getelementptr double, ptr %v870, i64 %v2990
  %v2991 = load double, ptr %v2989, align 8, !noalias !436
  %v2992 = add nsw i64 %v2990, %v18
  %v2993 = icmp slt i64 %v2992, 0
  %v2994 = select i1 %v2993, i64 %v167, i64 0
  %v2995 = getelementptr double, ptr %v166, i64 %v2992
  %v2996 = getelementptr double, ptr %v2995, i64 %v2994
  %v2997 = load double, ptr %v2996, align 8, !noalias !436
  %v2998 = fcmp une double %v2991, %v2997
  br label %v2999

v2999:
  %v3000 = phi i1 [ true, %v2986 ], [ %v2998, %v2988 ]
  %v3001 = icmp eq i64 %v3002, %v19
  br i1 %v3001, label %v2987, label %v2986

v2987:
  %v3003 = phi i1 [ false, %v2985 ], [ %v3000, %v2999 ]
  %v3004 = load double, ptr %v872, align 8, !noalias !436
  %v3005 = fcmp oeq double %v3004, 1.000000e+00
  %v3006 = select i1 %v3005, i1 %v3003, i1 false
  br i1 %v3006, label %v3007, label %v3008

v3007:
  %v3009 = load double, ptr %v134, align 8, !noalias !436
  %v3010 = load double, ptr %v874, align 8, !noalias !436
  %v3011 = fsub double %v3009, %v3010
  br i1 %v875, label %v3012, label %v3013

v3014:
  %v3015 = load double, ptr %v876, align 8, !noalias !436
  %v3016 = load double, ptr %v24, align 8, !noalias !436
  %v3017 = mul i64 %v3018, %v197
  %v3019 = getelementptr double, ptr %v194, i64 %v3017
  %v3020 = load double, ptr %v3019, align 8, !noalias !436
  %v3021 = tail call double @llvm.fabs.f64(double %v3020)
  %v3022 = fmul double %v3016, %v3021
  %v3023 = fadd double %v3015, %v3022
  %v3024 = add i64 %v3018, %v196
  %v3025 = mul i64 %v3024, %v197
  %v3026 = getelementptr double, ptr %v194, i64 %v3025
  %v3027 = load double, ptr %v3026, align 8, !noalias !436
  %v3028 = tail call double @llvm.fabs.f64(double %v3027)
  %v3029 = fmul double %v3011, %v3028
  %v3030 = fcmp ogt double %v3029, %v3023
  br label %v3031

v3031:
  %v3032 = phi i1 [ true, %v3013 ], [ %v3030, %v3014 ]
  %v3033 = icmp eq i64 %v10, %v3034
  br i1 %v3033, label %v3035, label %v3013

v3035:
  %v3036 = select i1 %v3032, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  br label %v3012

v3012:
  %v3037 = phi double [ 5.000000e-06, %v3007 ], [ %v3036, %v3035 ]
  %v3038 = load double, ptr %v878, align 8, !noalias !436
  %v3039 = load double, ptr %v93, align 8, !noalias !436
  %v3040 = fsub double %v3038, %v3039
  %v3041 = fmul double %v3037, %v3040
  %v3042 = fcmp olt double %v3011, %v3041
  br i1 %v3042, label %v3043, label %v3044

v3043:
  %v3045 = load i64, ptr %v880, align 8, !noalias !436
  %v3046 = add nsw i64 %v3045, 1
  br label %v3044

v3044:
  %v3047 = phi i64 [ %v3046, %v3043 ], [ 0, %v3012 ]
  store i64 %v3047, ptr %v882, align 8, !noalias !436
  %v3048 = load double, ptr %v134, align 8, !noalias !436
  store double %v3048, ptr %v874, align 8, !noalias !436
  store double 1.000000e+00, ptr %v884, align 8, !noalias !436
  store i64 2, ptr %v478, align 8, !noalias !436
  %v3049 = load i64, ptr %v882, align 8, !noalias !436
  %v3050 = icmp sgt i64 %v3049, 1000
  br i1 %v3050, label %v3051, label %v3008

v3051:
  %v3052 = load i64, ptr %v143, align 8, !noalias !440
  %v3053 = icmp sgt i64 %v3052, -1
  br i1 %v3053, label %v3054, label %v3008

v3054:
  %v3055 = getelementptr i64, ptr %v111, i64 %v3052
  %v3056 = load i64, ptr %v3055, align 8, !noalias !440
  %v3057 = icmp eq i64 %v3056, 0
  br i1 %v3057, label %v3058, label %v3008

v3058:
  store i64 6, ptr %v3055, align 8, !noalias !440
  br label %v3008

v3008:
  store double 0.000000e+00, ptr %v872, align 8, !noalias !436
  br label %v2982

v2986:
  %v3059 = phi i1 [ %v3000, %v2999 ], [ false, %v2985 ]
  %v2990 = phi i64 [ %v3002, %v2999 ], [ 0, %v2985 ]
  %v3002 = add nsw i64 %v2990, 1
  br i1 %v3059, label %v2999, label %v2988

v3013:
  %v3060 = phi i1 [ %v3032, %v3031 ], [ false, %v3007 ]
  %v3018 = phi i64 [ %v3034, %v3031 ], [ 0, %v3007 ]
  %v3034 = add nsw i64 %v3018, 1
  br i1 %v3060, label %v3031, label %v3014

v2982:
  %v3061 = and i1 %v885, %v1204
  %v3062 = xor i1 %v3061, true
  %v3063 = or i1 %v287, %v3062
  br i1 %v3063, label %v3064, label %v3065

v3066:
  %v3067 = getelementptr i64, ptr %v111, i64 %v3068
  %v3069 = load i64, ptr %v3067, align 8, !noalias !443
  %v3070 = icmp eq i64 %v3069, 0
  br i1 %v3070, label %v3071, label %v3072

v3071:
  %v3073 = getelementptr double, ptr %v888, i64 %v3074
  %v3075 = load double, ptr %v3073, align 8, !noalias !443
  %v3076 = fcmp olt double %v3075, 5.000000e-01
  br i1 %v3076, label %v3072, label %v3077

v3077:
  %v3078 = getelementptr double, ptr %v134, i64 %v3074
  %v3079 = load double, ptr %v3078, align 8, !noalias !443
  %v3080 = getelementptr double, ptr %v890, i64 %v3074
  %v3081 = load double, ptr %v3080, align 8, !noalias !443
  %v3082 = fcmp une double %v3079, %v3081
  %v3083 = select i1 %v3082, i1 true, i1 %v892
  %v3084 = xor i1 %v3082, true
  %v3085 = select i1 %v3084, i1 true, i1 %v3086
  br i1 %v3083, label %v3072, label %v3087

v3087:
  %v3088 = getelementptr i64, ptr %v891, i64 %v3074
  %v3089 = load i64, ptr %v3088, align 8, !noalias !448
  %v3090 = add nsw i64 %v3089, 1
  %v3091 = icmp slt i64 %v3089, -1
  %v3092 = select i1 %v3091, i64 %v78, i64 0
  %v3093 = add i64 %v3090, %v3092
  %v3094 = mul i64 %v3093, %v79
  %v3095 = getelementptr double, ptr %v77, i64 %v3094
  br label %v3096

v3096:
  %v3097 = phi i64 [ 0, %v3087 ], [ %v3098, %v3096 ]
  %v3098 = add nsw i64 %v3097, 1
  %v3099 = getelementptr double, ptr %v3095, i64 %v3097
  %v3100 = load double, ptr %v3099, align 8, !noalias !449
  %v3101 = getelementptr i64, ptr %v63, i64 %v3097
  %v3102 = load i64, ptr %v3101, align 8, !noalias !449
  %v3103 = mul nsw i64 %v3102, %v9
  %v3104 = add nsw i64 %v3103, %v3074
  %v3105 = icmp slt i64 %v3104, 0
  %v3106 = select i1 %v3105, i64 %v167, i64 0
  %v3107 = getelementptr double, ptr %v166, i64 %v3104
  %v3108 = getelementptr double, ptr %v3107, i64 %v3106
  store double %v3100, ptr %v3108, align 8, !noalias !449
  %v3109 = icmp eq i64 %v64, %v3098
  br i1 %v3109, label %v3072, label %v3096

v3072:
  %v3110 = phi i1 [ %v3085, %v3077 ], [ %v3086, %v3071 ], [ %v3086, %v3065 ], [ %v3086, %v3066 ], [ true, %v3096 ]
  %v3111 = icmp eq i64 %v9, %v3112
  br i1 %v3111, label %v3113, label %v3065

v3113:
  br i1 %v3110, label %v3114, label %v3064

v3114:
  %v3115 = load i64, ptr %v893, align 8, !noalias !453
  %v3116 = inttoptr i64 %v3115 to ptr
  tail call void %v3116(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v187), !noalias !453
  %v3117 = load i64, ptr %v894, align 8, !noalias !448
  %v3118 = inttoptr i64 %v3117 to ptr
  tail call void %v3118(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v897), !noalias !448
  br label %v3119

v3119:
  %v3120 = phi i64 [ 0, %v3114 ], [ %v3121, %v3122 ]
  %v3123 = phi i64 [ %v899, %v3114 ], [ %v3124, %v3122 ]
  %v3125 = phi i64 [ 1, %v3114 ], [ %v3126, %v3122 ]
  %v3127 = icmp slt i64 %v3120, 0
  %v3128 = select i1 %v3127, i64 %v145, i64 0
  %v3129 = add i64 %v3128, %v3120
  %v3130 = getelementptr i64, ptr %v143, i64 %v3129
  %v3131 = load i64, ptr %v3130, align 8, !noalias !456
  %v3132 = icmp slt i64 %v3131, 0
  br i1 %v3132, label %v3122, label %v3133

v3133:
  %v3134 = getelementptr i64, ptr %v111, i64 %v3131
  %v3135 = load i64, ptr %v3134, align 8, !noalias !456
  %v3136 = icmp eq i64 %v3135, 0
  br i1 %v3136, label %v3137, label %v3122

v3137:
  %v3138 = select i1 %v3127, i64 %v136, i64 0
  %v3139 = add i64 %v3138, %v3120
  %v3140 = getelementptr double, ptr %v888, i64 %v3139
  %v3141 = load double, ptr %v3140, align 8, !noalias !456
  %v3142 = fcmp olt double %v3141, 5.000000e-01
  br i1 %v3142, label %v3122, label %v3143

v3143:
  %v3144 = getelementptr double, ptr %v134, i64 %v3139
  %v3145 = load double, ptr %v3144, align 8, !noalias !456
  %v3146 = getelementptr double, ptr %v890, i64 %v3139
  %v3147 = load double, ptr %v3146, align 8, !noalias !456
  %v3148 = fcmp une double %v3145, %v3147
  br i1 %v3148, label %v3122, label %v3149

v3149:
  %v3150 = getelementptr i64, ptr %v901, i64 %v3129
  %v3151 = load i64, ptr %v3150, align 8, !noalias !459
  %v3152 = icmp sgt i64 %v3151, 0
  br i1 %v3152, label %v3153, label %v3154

v3153:
  %v3155 = getelementptr double, ptr %v93, i64 %v3151
  %v3156 = getelementptr i8, ptr %v3155, i64 -8
  %v3157 = load double, ptr %v3156, align 8, !noalias !459
  %v3158 = getelementptr double, ptr %v134, i64 %v3120
  %v3159 = getelementptr double, ptr %v3158, i64 %v3138
  %v3160 = load double, ptr %v3159, align 8, !noalias !459
  %v3161 = fcmp oeq double %v3157, %v3160
  br label %v3154

v3154:
  %v3162 = phi i1 [ %v3161, %v3153 ], [ false, %v3149 ]
  br i1 %v903, label %v3163, label %v3164

v3164:
  %v3165 = mul i64 %v898, %v3131
  %v3166 = select i1 %v3127, i64 %v197, i64 0
  %v3167 = add i64 %v3166, %v3120
  %v3168 = getelementptr double, ptr %v904, i64 %v3167
  %v3169 = getelementptr double, ptr %v194, i64 %v3167
  %v3170 = add nsw i64 %v3151, -1
  %v3171 = select i1 %v3152, i64 0, i64 %v102
  %v3172 = add i64 %v3170, %v3171
  %v3173 = mul i64 %v3172, %v103
  %v3174 = getelementptr double, ptr %v100, i64 %v3165
  %v3175 = getelementptr double, ptr %v3174, i64 %v3173
  br label %v3176

v3177:
  %v3178 = getelementptr double, ptr %v3175, i64 %v3179
  store double %v3180, ptr %v3178, align 8, !noalias !459
  br label %v3181

v3181:
  %v3182 = icmp eq i64 %v10, %v3183
  br i1 %v3182, label %v3184, label %v3176

v3184:
  %v3185 = fcmp une double %v3186, 0.000000e+00
  br i1 %v3185, label %v3187, label %v3163

v3187:
  %v3188 = load i64, ptr %v3130, align 8, !noalias !463
  %v3189 = icmp sgt i64 %v3188, -1
  br i1 %v3189, label %v3190, label %v3163

v3190:
  %v3191 = getelementptr i64, ptr %v111, i64 %v3188
  %v3192 = load i64, ptr %v3191, align 8, !noalias !463
  %v3193 = icmp eq i64 %v3192, 0
  br i1 %v3193, label %v3194, label %v3163

v3194:
  store i64 3, ptr %v3191, align 8, !noalias !463
  br label %v3163

v3163:
  br i1 %v284, label %v3195, label %v3122

v3195:
  %v3196 = load i64, ptr %v905, align 8, !noalias !466
  %v3197 = inttoptr i64 %v3196 to ptr
  tail call void %v3197(ptr %v134, ptr %v906, ptr %v166, ptr %v173, ptr %v180, ptr %v908), !noalias !466
  br label %v3198

v3199:
  %v3200 = getelementptr i64, ptr %v912, i64 %v3129
  store i64 %v3201, ptr %v3200, align 8, !noalias !472
  %v3202 = load i64, ptr %v3130, align 8, !noalias !473
  %v3203 = icmp sgt i64 %v3202, -1
  br i1 %v3203, label %v3204, label %v3205

v3204:
  %v3206 = getelementptr i64, ptr %v111, i64 %v3202
  %v3207 = load i64, ptr %v3206, align 8, !noalias !473
  %v3208 = icmp eq i64 %v3207, 0
  br i1 %v3208, label %v3209, label %v3205

v3209:
  store i64 4, ptr %v3206, align 8, !noalias !473
  br label %v3205

v3205:
  %v3210 = load double, ptr %v3144, align 8, !noalias !472
  store double %v3210, ptr %v3146, align 8, !noalias !472
  %v3211 = getelementptr double, ptr %v914, i64 %v3139
  store double 0.000000e+00, ptr %v3211, align 8, !noalias !472
  br label %v3122

v3198:
  %v3212 = phi i64 [ %v19, %v3195 ], [ %v3213, %v3214 ]
  %v3215 = phi i64 [ %v16, %v3195 ], [ %v3216, %v3214 ]
  %v3217 = icmp sgt i64 %v3215, 0
  br i1 %v3217, label %v3214, label %v3218

v3214:
  %v3216 = add nsw i64 %v3215, -1
  %v3213 = add i64 %v3212, 1
  %v3219 = icmp slt i64 %v3212, 0
  %v3220 = select i1 %v3219, i64 %v208, i64 0
  %v3221 = getelementptr double, ptr %v910, i64 %v3212
  %v3222 = getelementptr double, ptr %v3221, i64 %v3220
  %v3223 = load double, ptr %v3222, align 8, !noalias !476
  %v3224 = fcmp olt double %v3223, -1.000000e-09
  br i1 %v3224, label %v3218, label %v3198

v3218:
  %v3201 = phi i64 [ %v3212, %v3214 ], [ -1, %v3198 ]
  %v3225 = icmp sgt i64 %v3201, -1
  br i1 %v3225, label %v3199, label %v3122

v3176:
  %v3226 = phi double [ 0.000000e+00, %v3164 ], [ %v3186, %v3181 ]
  %v3179 = phi i64 [ 0, %v3164 ], [ %v3183, %v3181 ]
  %v3183 = add nsw i64 %v3179, 1
  %v3227 = mul i64 %v3179, %v197
  %v3228 = getelementptr double, ptr %v3168, i64 %v3227
  %v3180 = load double, ptr %v3228, align 8, !noalias !459
  %v3229 = fmul double %v3180, 0.000000e+00
  %v3186 = fadd double %v3226, %v3229
  %v3230 = getelementptr double, ptr %v3169, i64 %v3227
  store double %v3180, ptr %v3230, align 8, !noalias !459
  br i1 %v3162, label %v3177, label %v3181

v3122:
  %v3231 = icmp sgt i64 %v3123, 0
  %v3232 = zext i1 %v3231 to i64
  %v3126 = add i64 %v3125, %v3232
  %v3233 = sext i1 %v3231 to i64
  %v3124 = add nsw i64 %v3123, %v3233
  %v3121 = select i1 %v3231, i64 %v3125, i64 0
  br i1 %v3231, label %v3119, label %v3064

v3065:
  %v3086 = phi i1 [ %v3110, %v3072 ], [ false, %v2982 ]
  %v3074 = phi i64 [ %v3112, %v3072 ], [ 0, %v2982 ]
  %v3112 = add nsw i64 %v3074, 1
  %v3234 = getelementptr i64, ptr %v143, i64 %v3074
  %v3068 = load i64, ptr %v3234, align 8, !noalias !443
  %v3235 = icmp slt i64 %v3068, 0
  br i1 %v3235, label %v3072, label %v3066

v3064:
  %v3236 = xor i1 %v1204, true
  %v3237 = or i1 %v287, %v3236
  %v3238 = select i1 %v1204, i64 0, i64 %v1015
  br i1 %v3237, label %v1014, label %v3239

v3240:
  %v3241 = mul i64 %v3242, %v127
  %v3243 = getelementptr i64, ptr %v125, i64 %v3241
  %v3244 = load i64, ptr %v3243, align 8, !noalias !480
  %v3245 = getelementptr i8, ptr %v3243, i64 24
  %v3246 = load i64, ptr %v3245, align 8, !noalias !480
  %v3247 = add i64 %v3244, %v3246
  %v3248 = sub i64 %v278, %v3247
  %v3249 = icmp slt i64 %v3248, 1
  br i1 %v3249, label %v3250, label %v3251

v3250:
  %v3252 = getelementptr i64, ptr %v111, i64 %v3242
  %v3253 = load i64, ptr %v3252, align 8, !noalias !484
  %v3254 = icmp eq i64 %v3253, 0
  br i1 %v3254, label %v3255, label %v3251

v3255:
  store i64 5, ptr %v3252, align 8, !noalias !484
  br label %v3251

v3251:
  %v3256 = getelementptr double, ptr %v916, i64 %v3257
  %v3258 = load double, ptr %v3256, align 8, !noalias !480
  %v3259 = fcmp ogt double %v3258, 5.000000e-01
  br i1 %v3259, label %v3260, label %v3261

v3260:
  %v3262 = getelementptr double, ptr %v134, i64 %v3257
  %v3263 = load double, ptr %v3262, align 8, !noalias !480
  %v3264 = getelementptr double, ptr %v918, i64 %v3257
  %v3265 = load double, ptr %v3264, align 8, !noalias !480
  %v3266 = fcmp oeq double %v3263, %v3265
  br i1 %v3266, label %v3267, label %v3261

v3267:
  %v3268 = getelementptr i64, ptr %v919, i64 %v3257
  %v3269 = load i64, ptr %v3268, align 8, !noalias !487
  %v3270 = add nsw i64 %v3269, 1
  store i64 %v3270, ptr %v3268, align 8, !noalias !487
  %v3271 = icmp slt i64 %v3269, -1
  %v3272 = select i1 %v3271, i64 %v71, i64 0
  %v3273 = getelementptr double, ptr %v70, i64 %v3270
  %v3274 = getelementptr double, ptr %v3273, i64 %v3272
  %v3275 = load double, ptr %v3274, align 8, !noalias !487
  %v3276 = fcmp oeq double %v3275, 0x7FF0000000000000
  br i1 %v3276, label %v3277, label %v3278

v3277:
  %v3279 = load i64, ptr %v3280, align 8, !noalias !487
  %v3281 = icmp slt i64 %v3279, 0
  %v3282 = select i1 %v3281, i64 %v112, i64 0
  %v3283 = getelementptr i64, ptr %v111, i64 %v3279
  %v3284 = getelementptr i64, ptr %v3283, i64 %v3282
  %v3285 = load i64, ptr %v3284, align 8, !noalias !487
  %v3286 = icmp eq i64 %v3285, 0
  br i1 %v3286, label %v3287, label %v3261

v3287:
  store i64 1, ptr %v3284, align 8, !noalias !487
  br label %v3261

v3278:
  store double %v3275, ptr %v3264, align 8, !noalias !487
  %v3288 = select i1 %v3271, i64 %v87, i64 0
  %v3289 = getelementptr i64, ptr %v86, i64 %v3270
  %v3290 = getelementptr i64, ptr %v3289, i64 %v3288
  %v3291 = load i64, ptr %v3290, align 8, !noalias !487
  %v3292 = icmp eq i64 %v3291, 0
  br i1 %v3292, label %v3293, label %v3294

v3293:
  %v3295 = getelementptr double, ptr %v923, i64 %v3257
  store double 1.000000e+00, ptr %v3295, align 8, !noalias !487
  br label %v3296

v3294:
  %v3297 = getelementptr double, ptr %v921, i64 %v3257
  %v3298 = load double, ptr %v3297, align 8, !noalias !487
  %v3299 = fcmp olt double %v3298, 2.500000e-01
  %v3300 = select i1 %v3299, double 2.500000e-01, double %v3298
  store double %v3300, ptr %v3297, align 8, !noalias !487
  %v3301 = load i64, ptr %v478, align 8, !noalias !487
  %v3302 = tail call i64 @llvm.smax.i64(i64 %v3301, i64 1)
  br label %v3296

v3296:
  %v3303 = phi i64 [ %v3302, %v3294 ], [ 2, %v3293 ]
  store i64 %v3303, ptr %v478, align 8, !noalias !487
  br i1 %v924, label %v3261, label %v3304

v3304:
  %v3305 = select i1 %v3271, i64 %v78, i64 0
  %v3306 = add i64 %v3305, %v3270
  %v3307 = mul i64 %v3306, %v79
  %v3308 = getelementptr double, ptr %v77, i64 %v3307
  br label %v3309

v3309:
  %v3310 = phi i64 [ 0, %v3304 ], [ %v3311, %v3309 ]
  %v3311 = add nsw i64 %v3310, 1
  %v3312 = getelementptr double, ptr %v3308, i64 %v3310
  %v3313 = load double, ptr %v3312, align 8, !noalias !491
  %v3314 = getelementptr i64, ptr %v63, i64 %v3310
  %v3315 = load i64, ptr %v3314, align 8, !noalias !491
  %v3316 = mul nsw i64 %v3315, %v9
  %v3317 = add nsw i64 %v3316, %v3257
  %v3318 = icmp slt i64 %v3317, 0
  %v3319 = select i1 %v3318, i64 %v167, i64 0
  %v3320 = getelementptr double, ptr %v166, i64 %v3317
  %v3321 = getelementptr double, ptr %v3320, i64 %v3319
  store double %v3313, ptr %v3321, align 8, !noalias !491
  %v3322 = icmp eq i64 %v64, %v3311
  br i1 %v3322, label %v3261, label %v3309

v3261:
  %v3323 = getelementptr i64, ptr %v111, i64 %v3242
  %v3324 = load i64, ptr %v3323, align 8, !noalias !480
  %v3325 = icmp eq i64 %v3324, 0
  br i1 %v3325, label %v3326, label %v3327

v3327:
  %v3328 = getelementptr i64, ptr %v926, i64 %v3257
  %v3329 = load i64, ptr %v3328, align 8, !noalias !480
  %v3330 = getelementptr i64, ptr %v118, i64 %v3242
  store i64 %v3329, ptr %v3330, align 8, !noalias !480
  store i64 -1, ptr %v3280, align 8, !noalias !480
  %v3331 = getelementptr double, ptr %v928, i64 %v3257
  store double 0.000000e+00, ptr %v3331, align 8, !noalias !495
  %v3332 = load i64, ptr %v152, align 8, !noalias !495
  %v3333 = load i64, ptr %v929, align 8, !noalias !495
  %v3334 = icmp eq i64 %v3332, %v3333
  br i1 %v3334, label %v3335, label %v3336

v3336:
  %v3337 = add nsw i64 %v3332, 1
  store i64 %v3337, ptr %v152, align 8, !noalias !495
  store i64 2, ptr %v478, align 8, !noalias !495
  store i64 %v3332, ptr %v3280, align 8, !noalias !495
  %v3338 = icmp slt i64 %v3332, 0
  %v3339 = select i1 %v3338, i64 %v50, i64 0
  %v3340 = getelementptr i64, ptr %v49, i64 %v3332
  %v3341 = getelementptr i64, ptr %v3340, i64 %v3339
  %v3342 = load i64, ptr %v3341, align 8, !noalias !495
  %v3343 = icmp slt i64 %v3342, 0
  %v3344 = select i1 %v3343, i64 %v57, i64 0
  %v3345 = getelementptr i64, ptr %v56, i64 %v3342
  %v3346 = getelementptr i64, ptr %v3345, i64 %v3344
  %v3347 = load i64, ptr %v3346, align 8, !noalias !495
  %v3348 = getelementptr i64, ptr %v930, i64 %v3257
  store i64 %v3347, ptr %v3348, align 8, !noalias !495
  store i64 1, ptr %v3328, align 8, !noalias !495
  %v3349 = getelementptr i64, ptr %v932, i64 %v3257
  store i64 0, ptr %v3349, align 8, !noalias !495
  br i1 %v933, label %v3350, label %v3351

v3351:
  %v3352 = select i1 %v3338, i64 %v41, i64 0
  %v3353 = add i64 %v3352, %v3332
  %v3354 = mul i64 %v3353, %v42
  %v3355 = getelementptr double, ptr %v40, i64 %v3354
  %v3356 = getelementptr double, ptr %v166, i64 %v3257
  br label %v3357

v3350:
  br i1 %v934, label %v3358, label %v3359

v3359:
  %v3360 = load i64, ptr %v3348, align 8, !noalias !495
  %v3361 = icmp slt i64 %v3360, 0
  %v3362 = select i1 %v3361, i64 %v78, i64 0
  %v3363 = add i64 %v3362, %v3360
  %v3364 = mul i64 %v3363, %v79
  %v3365 = getelementptr double, ptr %v77, i64 %v3364
  br label %v3366

v3366:
  %v3367 = phi i64 [ 0, %v3359 ], [ %v3368, %v3366 ]
  %v3368 = add nsw i64 %v3367, 1
  %v3369 = getelementptr double, ptr %v3365, i64 %v3367
  %v3370 = load double, ptr %v3369, align 8, !noalias !498
  %v3371 = getelementptr i64, ptr %v63, i64 %v3367
  %v3372 = load i64, ptr %v3371, align 8, !noalias !498
  %v3373 = mul nsw i64 %v3372, %v9
  %v3374 = add nsw i64 %v3373, %v3257
  %v3375 = icmp slt i64 %v3374, 0
  %v3376 = select i1 %v3375, i64 %v167, i64 0
  %v3377 = getelementptr double, ptr %v166, i64 %v3374
  %v3378 = getelementptr double, ptr %v3377, i64 %v3376
  store double %v3370, ptr %v3378, align 8, !noalias !498
  %v3379 = icmp eq i64 %v3368, %v64
  br i1 %v3379, label %v3358, label %v3366

v3380:
  %v3381 = getelementptr double, ptr %v134, i64 %v3257
  %v3382 = getelementptr double, ptr %v937, i64 %v3257
  %v3383 = load double, ptr %v3382, align 8, !noalias !502
  %v3384 = getelementptr double, ptr %v939, i64 %v3257
  %v3385 = load double, ptr %v3384, align 8, !noalias !502
  %v3386 = getelementptr double, ptr %v941, i64 %v3257
  %v3387 = load double, ptr %v3386, align 8, !noalias !502
  store double 0.000000e+00, ptr %v3381, align 8, !noalias !502
  %v3388 = getelementptr double, ptr %v3381, i64 %v136
  store double 0.000000e+00, ptr %v3388, align 8, !noalias !502
  %v3389 = getelementptr i8, ptr %v3381, i64 %v942
  store double 0.000000e+00, ptr %v3389, align 8, !noalias !502
  %v3390 = getelementptr i8, ptr %v3381, i64 %v927
  store double 0.000000e+00, ptr %v3390, align 8, !noalias !502
  %v3391 = getelementptr i8, ptr %v3381, i64 %v943
  store double 0.000000e+00, ptr %v3391, align 8, !noalias !502
  %v3392 = getelementptr i8, ptr %v3381, i64 %v915
  store double 0.000000e+00, ptr %v3392, align 8, !noalias !502
  %v3393 = getelementptr i8, ptr %v3381, i64 %v944
  store double 0.000000e+00, ptr %v3393, align 8, !noalias !502
  %v3394 = getelementptr i8, ptr %v3381, i64 %v945
  store double 0.000000e+00, ptr %v3394, align 8, !noalias !502
  %v3395 = getelementptr i8, ptr %v3381, i64 %v946
  store double 0.000000e+00, ptr %v3395, align 8, !noalias !502
  %v3396 = getelementptr i8, ptr %v3381, i64 %v947
  store double 0.000000e+00, ptr %v3396, align 8, !noalias !502
  %v3397 = getelementptr i8, ptr %v3381, i64 %v948
  store double 0.000000e+00, ptr %v3397, align 8, !noalias !502
  %v3398 = getelementptr i8, ptr %v3381, i64 %v949
  store double 0.000000e+00, ptr %v3398, align 8, !noalias !502
  %v3399 = getelementptr i8, ptr %v3381, i64 %v950
  store double 0.000000e+00, ptr %v3399, align 8, !noalias !502
  %v3400 = getelementptr i8, ptr %v3381, i64 %v951
  store double 0.000000e+00, ptr %v3400, align 8, !noalias !502
  %v3401 = getelementptr i8, ptr %v3381, i64 %v952
  store double 0.000000e+00, ptr %v3401, align 8, !noalias !502
  %v3402 = getelementptr i8, ptr %v3381, i64 %v953
  store double 0.000000e+00, ptr %v3402, align 8, !noalias !502
  %v3403 = getelementptr i8, ptr %v3381, i64 %v954
  store double 0.000000e+00, ptr %v3403, align 8, !noalias !502
  %v3404 = getelementptr i8, ptr %v3381, i64 %v955
  store double 0.000000e+00, ptr %v3404, align 8, !noalias !502
  %v3405 = getelementptr i8, ptr %v3381, i64 %v956
  store double 0.000000e+00, ptr %v3405, align 8, !noalias !502
  %v3406 = getelementptr i8, ptr %v3381, i64 %v957
  store double 0.000000e+00, ptr %v3406, align 8, !noalias !502
  %v3407 = getelementptr i8, ptr %v3381, i64 %v958
  store double 0.000000e+00, ptr %v3407, align 8, !noalias !502
  %v3408 = getelementptr i8, ptr %v3381, i64 %v959
  store double 0.000000e+00, ptr %v3408, align 8, !noalias !502
  %v3409 = getelementptr i8, ptr %v3381, i64 %v960
  store double 0.000000e+00, ptr %v3409, align 8, !noalias !502
  %v3410 = getelementptr i8, ptr %v3381, i64 %v961
  store double 0.000000e+00, ptr %v3410, align 8, !noalias !502
  %v3411 = getelementptr i8, ptr %v3381, i64 %v962
  store double 0.000000e+00, ptr %v3411, align 8, !noalias !502
  %v3412 = getelementptr i8, ptr %v3381, i64 %v963
  store double 0.000000e+00, ptr %v3412, align 8, !noalias !502
  %v3413 = getelementptr i8, ptr %v3381, i64 %v964
  store double 0.000000e+00, ptr %v3413, align 8, !noalias !502
  %v3414 = getelementptr i8, ptr %v3381, i64 %v965
  store double 0.000000e+00, ptr %v3414, align 8, !noalias !502
  %v3415 = getelementptr i8, ptr %v3381, i64 %v966
  store double 0.000000e+00, ptr %v3415, align 8, !noalias !502
  %v3416 = getelementptr i8, ptr %v3381, i64 %v940
  store double 0.000000e+00, ptr %v3416, align 8, !noalias !502
  %v3417 = getelementptr i8, ptr %v3381, i64 %v938
  store double 0.000000e+00, ptr %v3417, align 8, !noalias !502
  %v3418 = getelementptr i8, ptr %v3381, i64 %v936
  store double 0.000000e+00, ptr %v3418, align 8, !noalias !502
  %v3419 = fcmp oeq double %v3387, 0xFFF0000000000000
  %v3420 = select i1 %v3419, double 0xFFF0000000000000, double 0.000000e+00
  store double %v3420, ptr %v3386, align 8, !noalias !502
  store double %v3385, ptr %v3384, align 8, !noalias !502
  store double %v3383, ptr %v3382, align 8, !noalias !502
  store double 1.000000e+00, ptr %v3331, align 8, !noalias !502
  %v3421 = getelementptr double, ptr %v967, i64 %v3257
  store double 0xFFF0000000000000, ptr %v3421, align 8, !noalias !502
  %v3422 = getelementptr double, ptr %v968, i64 %v3257
  store double 0x7FF0000000000000, ptr %v3422, align 8, !noalias !502
  %v3423 = load double, ptr %v93, align 8, !noalias !495
  store double %v3423, ptr %v3381, align 8, !noalias !495
  %v3424 = load i64, ptr %v3348, align 8, !noalias !495
  %v3425 = icmp slt i64 %v3424, 0
  %v3426 = select i1 %v3425, i64 %v71, i64 0
  %v3427 = getelementptr double, ptr %v70, i64 %v3424
  %v3428 = getelementptr double, ptr %v3427, i64 %v3426
  %v3429 = load double, ptr %v3428, align 8, !noalias !495
  %v3430 = getelementptr double, ptr %v969, i64 %v3257
  store double %v3429, ptr %v3430, align 8, !noalias !495
  br label %v3335

v3357:
  %v3431 = phi i64 [ 0, %v3351 ], [ %v3432, %v3357 ]
  %v3432 = add nsw i64 %v3431, 1
  %v3433 = getelementptr double, ptr %v3355, i64 %v3431
  %v3434 = load double, ptr %v3433, align 8, !noalias !495
  %v3435 = mul nsw i64 %v3431, %v9
  %v3436 = getelementptr double, ptr %v3356, i64 %v3435
  store double %v3434, ptr %v3436, align 8, !noalias !495
  %v3437 = icmp eq i64 %v3432, %v42
  br i1 %v3437, label %v3350, label %v3357

v3358:
  br i1 %v935, label %v3380, label %v3438

v3438:
  %v3439 = getelementptr double, ptr %v194, i64 %v3257
  %v3440 = select i1 %v3338, i64 %v32, i64 0
  %v3441 = add i64 %v3440, %v3332
  %v3442 = mul i64 %v3441, %v33
  %v3443 = getelementptr double, ptr %v31, i64 %v3442
  br label %v3444

v3444:
  %v3445 = phi i64 [ 0, %v3438 ], [ %v3446, %v3444 ]
  %v3446 = add nsw i64 %v3445, 1
  %v3447 = getelementptr double, ptr %v3443, i64 %v3445
  %v3448 = load double, ptr %v3447, align 8, !noalias !495
  %v3449 = mul i64 %v3445, %v197
  %v3450 = getelementptr double, ptr %v3439, i64 %v3449
  store double %v3448, ptr %v3450, align 8, !noalias !495
  %v3451 = icmp eq i64 %v3446, %v10
  br i1 %v3451, label %v3380, label %v3444

v3326:
  %v3452 = getelementptr double, ptr %v971, i64 %v3257
  %v3453 = load double, ptr %v3452, align 8, !noalias !480
  %v3454 = fcmp ult double %v3453, 1.500000e+01
  br i1 %v3454, label %v3335, label %v3455

v3455:
  %v3456 = load double, ptr %v973, align 8, !noalias !480
  %v3457 = getelementptr double, ptr %v134, i64 %v3257
  %v3458 = load double, ptr %v3457, align 8, !noalias !480
  %v3459 = fsub double %v3456, %v3458
  %v3460 = getelementptr double, ptr %v974, i64 %v3257
  %v3461 = load double, ptr %v3460, align 8, !noalias !480
  %v3462 = fmul double %v3461, 2.500000e+02
  %v3463 = fcmp ogt double %v3459, %v3462
  br i1 %v3463, label %v3335, label %v3464

v3464:
  store double 0.000000e+00, ptr %v3452, align 8, !noalias !480
  br label %v3335

v3335:
  %v3465 = phi i1 [ %v3466, %v3326 ], [ true, %v3455 ], [ %v3466, %v3464 ], [ %v3466, %v3327 ], [ %v3466, %v3380 ]
  %v3467 = load i64, ptr %v3280, align 8, !noalias !480
  %v3468 = icmp sgt i64 %v3467, -1
  br i1 %v3468, label %v3469, label %v3470

v3469:
  %v3471 = add nsw i64 %v3472, 1
  %v3473 = getelementptr double, ptr %v976, i64 %v3257
  %v3474 = load double, ptr %v3473, align 8, !noalias !480
  %v3475 = fcmp ogt double %v3474, 0.000000e+00
  br i1 %v3475, label %v3476, label %v3477

v3477:
  %v3478 = mul i64 %v3467, %v127
  %v3479 = getelementptr i64, ptr %v125, i64 %v3478
  %v3480 = load i64, ptr %v3479, align 8, !noalias !480
  %v3481 = and i64 %v3480, 127
  %v3482 = sub nsw i64 128, %v3481
  %v3483 = tail call i64 @llvm.smin.i64(i64 %v3482, i64 %v3248)
  %v3484 = sitofp i64 %v3483 to double
  br label %v3476

v3476:
  %v3485 = phi double [ %v3484, %v3477 ], [ 1.000000e+00, %v3469 ]
  %v3486 = getelementptr double, ptr %v978, i64 %v3257
  store double %v3485, ptr %v3486, align 8, !noalias !480
  %v3487 = getelementptr double, ptr %v980, i64 %v3257
  %v3488 = load double, ptr %v3487, align 8, !noalias !506
  %v3489 = getelementptr double, ptr %v982, i64 %v3257
  store double %v3488, ptr %v3489, align 8, !noalias !506
  %v3490 = getelementptr i64, ptr %v984, i64 %v3257
  %v3491 = load i64, ptr %v3490, align 8, !noalias !506
  %v3492 = icmp slt i64 %v3491, %v94
  br i1 %v3492, label %v3493, label %v3470

v3493:
  %v3494 = icmp slt i64 %v3491, 0
  %v3495 = select i1 %v3494, i64 %v94, i64 0
  %v3496 = getelementptr double, ptr %v93, i64 %v3491
  %v3497 = getelementptr double, ptr %v3496, i64 %v3495
  %v3498 = load double, ptr %v3497, align 8, !noalias !506
  %v3499 = load double, ptr %v3487, align 8, !noalias !506
  %v3500 = fcmp olt double %v3499, %v3498
  %v3501 = select i1 %v3500, double %v3499, double %v3498
  store double %v3501, ptr %v3489, align 8, !noalias !506
  br label %v3470

v3470:
  %v3502 = phi i64 [ %v3472, %v3239 ], [ %v3472, %v3335 ], [ %v3471, %v3476 ], [ %v3471, %v3493 ]
  %v3503 = phi i1 [ %v3466, %v3239 ], [ %v3465, %v3335 ], [ %v3465, %v3476 ], [ %v3465, %v3493 ]
  %v3504 = icmp sgt i64 %v3505, 1
  br i1 %v3504, label %v3239, label %v3506

v3239:
  %v3466 = phi i1 [ %v3503, %v3470 ], [ false, %v3064 ]
  %v3472 = phi i64 [ %v3502, %v3470 ], [ 0, %v3064 ]
  %v3257 = phi i64 [ %v3507, %v3470 ], [ 0, %v3064 ]
  %v3505 = phi i64 [ %v3508, %v3470 ], [ %v288, %v3064 ]
  %v3508 = add nsw i64 %v3505, -1
  %v3507 = add nsw i64 %v3257, 1
  %v3280 = getelementptr i64, ptr %v143, i64 %v3257
  %v3242 = load i64, ptr %v3280, align 8, !noalias !480
  %v3509 = icmp slt i64 %v3242, 0
  br i1 %v3509, label %v3470, label %v3240

v1014:
  %v1013 = phi i64 [ %v1017, %v3064 ], [ %v3510, %v3506 ]
  %v1016 = phi i64 [ %v3238, %v3064 ], [ %v3502, %v3506 ]
  %v3511 = icmp sgt i64 %v1016, 0
  %v3512 = icmp sgt i64 %v1013, 0
  %v3513 = select i1 %v3511, i1 %v3512, i1 false
  br i1 %v3513, label %v1011, label %v477

v477:
  %v3514 = phi i64 [ %v472, %v289 ], [ %v1016, %v1014 ]
  br i1 %v287, label %v3515, label %v3516

v3516:
  %v3517 = mul i64 %v136, 192
  %v3518 = getelementptr i8, ptr %v134, i64 %v3517
  %v3519 = mul i64 %v136, 200
  %v3520 = getelementptr i8, ptr %v134, i64 %v3519
  %v3521 = add nsw i64 %v11, -1
  %v3522 = mul i64 %v136, 176
  %v3523 = getelementptr i8, ptr %v134, i64 %v3522
  br label %v3524

v3525:
  %v3526 = getelementptr double, ptr %v3518, i64 %v3527
  %v3528 = load double, ptr %v3526, align 8, !noalias !510
  %v3529 = fptosi double %v3528 to i64
  %v3530 = getelementptr double, ptr %v3520, i64 %v3527
  %v3531 = load double, ptr %v3530, align 8, !noalias !510
  %v3532 = fptosi double %v3531 to i64
  %v3533 = mul i64 %v3534, %v127
  %v3535 = getelementptr i64, ptr %v125, i64 %v3533
  %v3536 = load i64, ptr %v3535, align 8, !noalias !510
  %v3537 = add nsw i64 %v3536, %v3529
  store i64 %v3537, ptr %v3535, align 8, !noalias !510
  %v3538 = getelementptr i8, ptr %v3535, i64 24
  %v3539 = load i64, ptr %v3538, align 8, !noalias !510
  %v3540 = add nsw i64 %v3539, %v3532
  store i64 %v3540, ptr %v3538, align 8, !noalias !510
  %v3541 = getelementptr i8, ptr %v3535, i64 8
  %v3542 = load i64, ptr %v3541, align 8, !noalias !510
  %v3543 = add nsw i64 %v3532, %v3529
  %v3544 = mul nsw i64 %v3543, %v3521
  %v3545 = add nsw i64 %v3544, %v3529
  %v3546 = add nsw i64 %v3545, %v3542
  store i64 %v3546, ptr %v3541, align 8, !noalias !510
  store double 0.000000e+00, ptr %v3526, align 8, !noalias !510
  store double 0.000000e+00, ptr %v3530, align 8, !noalias !510
  %v3547 = getelementptr double, ptr %v3523, i64 %v3527
  %v3548 = load double, ptr %v3547, align 8, !noalias !510
  %v3549 = sitofp i64 %v3543 to double
  %v3550 = fsub double %v3548, %v3549
  store double %v3550, ptr %v3547, align 8, !noalias !510
  br label %v3551

v3551:
  %v3552 = icmp sgt i64 %v3553, 1
  br i1 %v3552, label %v3524, label %v3515

v3524:
  %v3527 = phi i64 [ 0, %v3516 ], [ %v3554, %v3551 ]
  %v3553 = phi i64 [ %v288, %v3516 ], [ %v3555, %v3551 ]
  %v3555 = add nsw i64 %v3553, -1
  %v3554 = add nsw i64 %v3527, 1
  %v3556 = getelementptr i64, ptr %v143, i64 %v3527
  %v3534 = load i64, ptr %v3556, align 8, !noalias !510
  %v3557 = icmp sgt i64 %v3534, -1
  br i1 %v3557, label %v3525, label %v3551

v3558:
  %v3559 = phi i32 [ 0, %v3515 ], [ %v2854, %v2856 ]
  ret i32 %v3559

v338:
  %v469 = phi i64 [ 0, %v290 ], [ %v468, %v345 ]
  %v471 = phi i64 [ %v288, %v290 ], [ %v3560, %v345 ]
  %v341 = phi i64 [ 0, %v290 ], [ %v3561, %v345 ]
  %v3560 = add nsw i64 %v471, -1
  %v3561 = add nsw i64 %v341, 1
  %v465 = getelementptr i64, ptr %v143, i64 %v341
  %v3562 = load i64, ptr %v465, align 8
  %v3563 = icmp slt i64 %v3562, 0
  br i1 %v3563, label %v339, label %v345

v1182:
  %v3564 = load i64, ptr %v6, align 8, !noalias !514
  %v3565 = inttoptr i64 %v3564 to ptr
  tail call void %v3565(ptr %v134, ptr %v159, ptr %v166, ptr %v173, ptr %v180, ptr %v538), !noalias !514
  br label %v1183

v1183:
  br i1 %v539, label %v3566, label %v3567

v3566:
  %v3568 = load double, ptr %v541, align 8, !noalias !517
  %v3569 = fcmp olt double %v3568, 5.000000e-01
  br i1 %v3569, label %v3570, label %v3571

v3570:
  br i1 %v542, label %v3572, label %v3573

v3572:
  br i1 %v554, label %v3574, label %v3575, !prof !419

v3576:
  %v3577 = icmp eq i64 %v3578, %v587
  br i1 %v3577, label %v3571, label %v3579

v3580:
  %v3581 = load i64, ptr %v564, align 8, !noalias !521
  %v3582 = icmp eq i64 %v3581, %v3578
  br i1 %v3582, label %v3583, label %v3584

v3583:
  %v3585 = load double, ptr %v566, align 8, !noalias !521
  %v3586 = fmul double %v3585, 1.000000e-03
  br label %v3584

v3584:
  %v3587 = phi double [ %v3586, %v3583 ], [ 0.000000e+00, %v3580 ]
  store double %v3587, ptr %v3588, align 8, !noalias !521
  br i1 %v542, label %v3589, label %v3590

v3591:
  %v3592 = phi i64 [ %v3593, %v3591 ], [ 0, %v3579 ]
  %v3593 = add nsw i64 %v3592, 1
  %v3594 = mul i64 %v3592, %v197
  %v3595 = getelementptr double, ptr %v194, i64 %v3594
  %v3596 = load double, ptr %v3595, align 8, !noalias !521
  %v3597 = tail call double @llvm.fabs.f64(double %v3596)
  %v3598 = fcmp ogt double %v3599, %v3597
  %v3600 = select i1 %v3598, double %v3599, double %v3597
  %v3601 = fcmp ogt double %v3600, 0.000000e+00
  %v3602 = fmul double %v3600, 1.200000e-05
  %v3603 = select i1 %v3601, double %v3602, double 1.200000e-05
  %v3604 = getelementptr i64, ptr %v246, i64 %v3592
  %v3605 = load i64, ptr %v3604, align 8, !noalias !521
  %v3606 = icmp eq i64 %v3605, %v3578
  %v3607 = select i1 %v3606, double %v3603, double 0.000000e+00
  %v3608 = getelementptr double, ptr %v3609, i64 %v3592
  store double %v3607, ptr %v3608, align 8, !noalias !521
  %v3610 = icmp eq i64 %v10, %v3593
  br i1 %v3610, label %v3580, label %v3591

v3611:
  %v3612 = getelementptr double, ptr %v580, i64 %v3613
  store double %v3614, ptr %v3612, align 8, !noalias !527
  br label %v3615

v3616:
  %v3617 = select i1 %v3618, i64 %v275, i64 0
  %v3619 = getelementptr i64, ptr %v274, i64 %v3620
  %v3621 = getelementptr i64, ptr %v3619, i64 %v3617
  %v3622 = load i64, ptr %v3621, align 8, !noalias !527
  %v3623 = icmp slt i64 %v3622, 0
  %v3624 = select i1 %v3623, i64 %v217, i64 0
  %v3625 = getelementptr double, ptr %v216, i64 %v3622
  %v3626 = getelementptr double, ptr %v3625, i64 %v3624
  store double %v3614, ptr %v3626, align 8, !noalias !527
  br label %v3615

v3615:
  %v3627 = icmp sgt i64 %v3628, 1
  br i1 %v3627, label %v3629, label %v3576

v3573:
  %v3630 = phi i64 [ %v3631, %v3573 ], [ 0, %v3570 ]
  %v3631 = add nsw i64 %v3630, 1
  %v3632 = mul i64 %v3630, %v197
  %v3633 = getelementptr double, ptr %v194, i64 %v3632
  %v3634 = load double, ptr %v3633, align 8, !noalias !527
  %v3635 = getelementptr double, ptr %v545, i64 %v3632
  store double %v3634, ptr %v3635, align 8, !noalias !527
  %v3636 = getelementptr double, ptr %v547, i64 %v3632
  store double 0.000000e+00, ptr %v3636, align 8, !noalias !527
  %v3637 = icmp eq i64 %v10, %v3631
  br i1 %v3637, label %v3572, label %v3573

v3638:
  %v3639 = phi i64 [ %v160, %v3640 ], [ %v3641, %v3642 ]
  %v3643 = sub i64 %v3639, %v3644
  %v3645 = tail call i64 @llvm.smax.i64(i64 %v3643, i64 0)
  %v3609 = getelementptr double, ptr %v159, i64 %v3644
  br i1 %v559, label %v3646, label %v3571

v3646:
  %v3647 = select i1 %v551, i64 %v3645, i64 0
  %v3648 = getelementptr double, ptr %v3609, i64 %v10
  %v3588 = getelementptr double, ptr %v3648, i64 %v3647
  br label %v3579

v3574:
  br label %v3575

v3575:
  %v3649 = phi i64 [ 0, %v3574 ], [ %v553, %v3572 ]
  br i1 %v555, label %v3650, label %v3651, !prof !121

v3651:
  br label %v3650

v3650:
  %v3644 = phi i64 [ %v160, %v3651 ], [ %v3649, %v3575 ]
  br i1 %v557, label %v3652, label %v3642, !prof !419

v3652:
  br label %v3642

v3642:
  %v3641 = phi i64 [ 0, %v3652 ], [ %v556, %v3650 ]
  br i1 %v558, label %v3638, label %v3640, !prof !121

v3640:
  br label %v3638

v3579:
  %v3578 = phi i64 [ 0, %v3646 ], [ %v3653, %v3576 ]
  %v3653 = add nsw i64 %v3578, 1
  %v3654 = load double, ptr %v561, align 8, !noalias !521
  %v3655 = load double, ptr %v24, align 8, !noalias !521
  %v3599 = fdiv double %v3654, %v3655
  br i1 %v542, label %v3580, label %v3591

v3656:
  %v3657 = load double, ptr %v134, align 8, !noalias !528
  %v3658 = load double, ptr %v3588, align 8, !noalias !528
  %v3659 = fmul double %v3658, 5.000000e-01
  %v3660 = fadd double %v3657, %v3659
  store double %v3660, ptr %v569, align 8, !noalias !528
  %v3661 = load i64, ptr %v6, align 8, !noalias !532
  %v3662 = inttoptr i64 %v3661 to ptr
  tail call void %v3662(ptr nonnull %v569, ptr %v572, ptr %v166, ptr %v173, ptr %v180, ptr %v582), !noalias !532
  br label %v3663

v3663:
  %v3664 = phi i64 [ %v3665, %v3663 ], [ 0, %v3656 ]
  %v3665 = add nsw i64 %v3664, 1
  %v3666 = mul i64 %v3664, %v197
  %v3667 = getelementptr double, ptr %v194, i64 %v3666
  %v3668 = load double, ptr %v3667, align 8, !noalias !528
  %v3669 = getelementptr double, ptr %v3609, i64 %v3664
  %v3670 = load double, ptr %v3669, align 8, !noalias !528
  %v3671 = fmul double %v3670, 5.000000e-01
  %v3672 = fsub double %v3668, %v3671
  %v3673 = getelementptr double, ptr %v573, i64 %v3666
  store double %v3672, ptr %v3673, align 8, !noalias !528
  %v3674 = icmp eq i64 %v10, %v3665
  br i1 %v3674, label %v3675, label %v3663

v3589:
  %v3676 = load double, ptr %v134, align 8, !noalias !528
  %v3677 = fmul double %v3587, 5.000000e-01
  %v3678 = fadd double %v3677, %v3676
  store double %v3678, ptr %v569, align 8, !noalias !528
  %v3679 = load i64, ptr %v6, align 8, !noalias !532
  %v3680 = inttoptr i64 %v3679 to ptr
  tail call void %v3680(ptr nonnull %v569, ptr %v572, ptr %v166, ptr %v173, ptr %v180, ptr %v584), !noalias !532
  br label %v3675

v3675:
  %v3681 = load double, ptr %v134, align 8, !noalias !528
  %v3682 = load double, ptr %v3588, align 8, !noalias !528
  %v3683 = fmul double %v3682, 5.000000e-01
  %v3684 = fsub double %v3681, %v3683
  store double %v3684, ptr %v569, align 8, !noalias !528
  %v3685 = load i64, ptr %v6, align 8, !noalias !532
  %v3686 = inttoptr i64 %v3685 to ptr
  tail call void %v3686(ptr nonnull %v569, ptr %v572, ptr %v166, ptr %v173, ptr %v180, ptr %v586), !noalias !532
  br i1 %v542, label %v3687, label %v3688

v3689:
  %v3690 = fsub double %v3691, %v3692
  br label %v3693

v3694:
  %v3695 = getelementptr double, ptr %v578, i64 %v3696
  %v3697 = load double, ptr %v3695, align 8, !noalias !528
  %v3698 = fsub double %v3691, %v3697
  %v3699 = fmul double %v3698, 2.000000e+00
  br label %v3693

v3693:
  %v3700 = phi double [ %v3699, %v3694 ], [ %v3690, %v3689 ]
  store double %v3700, ptr %v3701, align 8, !noalias !528
  %v3702 = icmp eq i64 %v10, %v3703
  br i1 %v3702, label %v3687, label %v3688

v3590:
  %v3704 = phi i64 [ %v3705, %v3590 ], [ 0, %v3584 ]
  %v3705 = add nsw i64 %v3704, 1
  %v3706 = mul i64 %v3704, %v197
  %v3707 = getelementptr double, ptr %v194, i64 %v3706
  %v3708 = load double, ptr %v3707, align 8, !noalias !528
  %v3709 = getelementptr double, ptr %v3609, i64 %v3704
  %v3710 = load double, ptr %v3709, align 8, !noalias !528
  %v3711 = fmul double %v3710, 5.000000e-01
  %v3712 = fadd double %v3708, %v3711
  %v3713 = getelementptr double, ptr %v573, i64 %v3706
  store double %v3712, ptr %v3713, align 8, !noalias !528
  %v3714 = icmp eq i64 %v10, %v3705
  br i1 %v3714, label %v3656, label %v3590

v3688:
  %v3715 = phi i64 [ %v3703, %v3693 ], [ 0, %v3675 ]
  %v3703 = add nsw i64 %v3715, 1
  %v3696 = mul i64 %v3715, %v197
  %v3716 = getelementptr double, ptr %v194, i64 %v3696
  %v3717 = load double, ptr %v3716, align 8, !noalias !528
  %v3718 = getelementptr double, ptr %v573, i64 %v3696
  store double %v3717, ptr %v3718, align 8, !noalias !528
  %v3701 = getelementptr double, ptr %v575, i64 %v3696
  %v3691 = load double, ptr %v3701, align 8, !noalias !528
  %v3719 = getelementptr double, ptr %v577, i64 %v3696
  %v3692 = load double, ptr %v3719, align 8, !noalias !528
  %v3720 = fsub double %v3692, %v3692
  %v3721 = fcmp oeq double %v3720, 0.000000e+00
  br i1 %v3721, label %v3689, label %v3694

v3687:
  %v3722 = getelementptr i64, ptr %v253, i64 %v3578
  %v3723 = load i64, ptr %v3722, align 8, !noalias !527
  %v3724 = getelementptr i8, ptr %v3722, i64 8
  %v3725 = load i64, ptr %v3724, align 8, !noalias !527
  %v3726 = sub i64 %v3725, %v3723
  %v3727 = icmp slt i64 %v3726, 1
  br i1 %v3727, label %v3576, label %v3629

v3629:
  %v3628 = phi i64 [ %v3728, %v3615 ], [ %v3726, %v3687 ]
  %v3620 = phi i64 [ %v3729, %v3615 ], [ %v3723, %v3687 ]
  %v3728 = add nsw i64 %v3628, -1
  %v3729 = add i64 %v3620, 1
  %v3618 = icmp slt i64 %v3620, 0
  %v3730 = select i1 %v3618, i64 %v261, i64 0
  %v3731 = getelementptr i64, ptr %v260, i64 %v3620
  %v3732 = getelementptr i64, ptr %v3731, i64 %v3730
  %v3733 = load i64, ptr %v3732, align 8, !noalias !527
  %v3734 = select i1 %v3618, i64 %v268, i64 0
  %v3735 = getelementptr i64, ptr %v267, i64 %v3620
  %v3736 = getelementptr i64, ptr %v3735, i64 %v3734
  %v3737 = load i64, ptr %v3736, align 8, !noalias !527
  %v3738 = icmp slt i64 %v3733, 0
  %v3739 = select i1 %v3738, i64 %v196, i64 0
  %v3740 = add i64 %v3739, %v3733
  %v3613 = mul i64 %v3740, %v197
  %v3741 = getelementptr double, ptr %v575, i64 %v3613
  %v3742 = load double, ptr %v3741, align 8, !noalias !527
  %v3743 = icmp slt i64 %v3737, 0
  %v3744 = select i1 %v3743, i64 %v3645, i64 0
  %v3745 = getelementptr double, ptr %v3609, i64 %v3737
  %v3746 = getelementptr double, ptr %v3745, i64 %v3744
  %v3747 = load double, ptr %v3746, align 8, !noalias !527
  %v3748 = fdiv double %v3742, %v3747
  %v3749 = fsub double %v3748, %v3748
  %v3750 = fcmp oeq double %v3749, 0.000000e+00
  %v3614 = select i1 %v3750, double %v3748, double 0.000000e+00
  %v3751 = icmp eq i64 %v3737, %v10
  br i1 %v3751, label %v3611, label %v3616

v3571:
  br i1 %v588, label %v3752, label %v3567

v3753:
  %v3754 = mul i64 %v3755, %v591
  %v3756 = icmp slt i64 %v3754, 0
  %v3757 = select i1 %v3756, i64 %v224, i64 0
  %v3758 = getelementptr double, ptr %v223, i64 %v3754
  %v3759 = getelementptr double, ptr %v3758, i64 %v3757
  %v3760 = load double, ptr %v3759, align 8, !noalias !517
  %v3761 = load double, ptr %v593, align 8, !noalias !517
  %v3762 = fadd double %v3760, %v3761
  store double %v3762, ptr %v3759, align 8, !noalias !517
  %v3763 = icmp eq i64 %v10, %v3764
  br i1 %v3763, label %v3765, label %v3752

v3766:
  %v3767 = icmp eq i64 %v3768, %v10
  br i1 %v3767, label %v3567, label %v3765

v3769:
  %v3770 = phi i64 [ %v3771, %v3765 ], [ %v3772, %v3773 ]
  %v3774 = getelementptr i64, ptr %v230, i64 %v3771
  store i64 %v3770, ptr %v3774, align 8, !noalias !535
  %v3775 = add nsw i64 %v3770, %v3776
  %v3777 = icmp slt i64 %v3775, 0
  %v3778 = select i1 %v3777, i64 %v224, i64 0
  %v3779 = getelementptr double, ptr %v223, i64 %v3775
  %v3780 = getelementptr double, ptr %v3779, i64 %v3778
  %v3781 = load double, ptr %v3780, align 8, !noalias !535
  %v3782 = load double, ptr %v3783, align 8, !noalias !535
  store double %v3781, ptr %v3783, align 8, !noalias !535
  store double %v3782, ptr %v3780, align 8, !noalias !535
  br i1 %v3784, label %v3785, label %v3786

v3785:
  %v3787 = sub i64 %v3788, %v3768
  %v3789 = icmp slt i64 %v3787, 1
  br i1 %v3789, label %v3766, label %v3790

v3791:
  %v3792 = icmp sgt i64 %v3793, 1
  br i1 %v3792, label %v3790, label %v3766

v3765:
  %v3771 = phi i64 [ %v3768, %v3766 ], [ 0, %v3753 ]
  %v3768 = add nsw i64 %v3771, 1
  %v3776 = mul nsw i64 %v3771, %v10
  %v3794 = add nsw i64 %v3771, %v233
  %v3795 = add nsw i64 %v3794, 1
  %v3796 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %v3795, i64 %v10)
  %v3797 = add i64 %v594, %v3794
  %v3788 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %v3797, i64 %v10)
  %v3798 = getelementptr double, ptr %v223, i64 %v3776
  %v3783 = getelementptr double, ptr %v3798, i64 %v3771
  %v3799 = sub i64 %v3796, %v3768
  %v3800 = tail call i64 @llvm.smax.i64(i64 %v3799, i64 0)
  %v3784 = icmp slt i64 %v3799, 1
  br i1 %v3784, label %v3769, label %v3801

v3801:
  %v3802 = load double, ptr %v3783, align 8, !noalias !535
  %v3803 = tail call double @llvm.fabs.f64(double %v3802)
  br label %v3773

v3773:
  %v3804 = phi i64 [ %v3772, %v3773 ], [ %v3771, %v3801 ]
  %v3805 = phi double [ %v3806, %v3773 ], [ %v3803, %v3801 ]
  %v3807 = phi i64 [ %v3808, %v3773 ], [ %v3800, %v3801 ]
  %v3809 = phi i64 [ %v3810, %v3773 ], [ %v3768, %v3801 ]
  %v3808 = add nsw i64 %v3807, -1
  %v3810 = add i64 %v3809, 1
  %v3811 = add nsw i64 %v3809, %v3776
  %v3812 = icmp slt i64 %v3811, 0
  %v3813 = select i1 %v3812, i64 %v224, i64 0
  %v3814 = getelementptr double, ptr %v223, i64 %v3811
  %v3815 = getelementptr double, ptr %v3814, i64 %v3813
  %v3816 = load double, ptr %v3815, align 8, !noalias !535
  %v3817 = tail call double @llvm.fabs.f64(double %v3816)
  %v3818 = fcmp ogt double %v3817, %v3805
  %v3806 = select i1 %v3818, double %v3817, double %v3805
  %v3772 = select i1 %v3818, i64 %v3809, i64 %v3804
  %v3819 = icmp sgt i64 %v3807, 1
  br i1 %v3819, label %v3773, label %v3769

v3786:
  %v3820 = phi i64 [ %v3821, %v3786 ], [ %v3800, %v3769 ]
  %v3822 = phi i64 [ %v3823, %v3786 ], [ %v3768, %v3769 ]
  %v3821 = add nsw i64 %v3820, -1
  %v3823 = add i64 %v3822, 1
  %v3824 = add nsw i64 %v3822, %v3776
  %v3825 = icmp slt i64 %v3824, 0
  %v3826 = select i1 %v3825, i64 %v224, i64 0
  %v3827 = getelementptr double, ptr %v223, i64 %v3824
  %v3828 = getelementptr double, ptr %v3827, i64 %v3826
  %v3829 = load double, ptr %v3828, align 8, !noalias !535
  %v3830 = load double, ptr %v3783, align 8, !noalias !535
  %v3831 = fdiv double %v3829, %v3830
  store double %v3831, ptr %v3828, align 8, !noalias !535
  %v3832 = icmp sgt i64 %v3820, 1
  br i1 %v3832, label %v3786, label %v3785

v3790:
  %v3793 = phi i64 [ %v3833, %v3791 ], [ %v3787, %v3785 ]
  %v3834 = phi i64 [ %v3835, %v3791 ], [ %v3768, %v3785 ]
  %v3833 = add nsw i64 %v3793, -1
  %v3835 = add i64 %v3834, 1
  %v3836 = mul nsw i64 %v3834, %v10
  %v3837 = add nsw i64 %v3836, %v3770
  %v3838 = icmp slt i64 %v3837, 0
  %v3839 = select i1 %v3838, i64 %v224, i64 0
  %v3840 = getelementptr double, ptr %v223, i64 %v3837
  %v3841 = getelementptr double, ptr %v3840, i64 %v3839
  %v3842 = load double, ptr %v3841, align 8, !noalias !535
  %v3843 = add nsw i64 %v3836, %v3771
  %v3844 = icmp slt i64 %v3843, 0
  %v3845 = select i1 %v3844, i64 %v224, i64 0
  %v3846 = getelementptr double, ptr %v223, i64 %v3843
  %v3847 = getelementptr double, ptr %v3846, i64 %v3845
  %v3848 = load double, ptr %v3847, align 8, !noalias !535
  store double %v3848, ptr %v3841, align 8, !noalias !535
  store double %v3842, ptr %v3847, align 8, !noalias !535
  %v3849 = fcmp oeq double %v3842, 0.000000e+00
  %v3850 = or i1 %v3784, %v3849
  br i1 %v3850, label %v3791, label %v3851

v3851:
  %v3852 = phi i64 [ %v3853, %v3851 ], [ %v3800, %v3790 ]
  %v3854 = phi i64 [ %v3855, %v3851 ], [ %v3768, %v3790 ]
  %v3853 = add nsw i64 %v3852, -1
  %v3855 = add i64 %v3854, 1
  %v3856 = add nsw i64 %v3854, %v3836
  %v3857 = icmp slt i64 %v3856, 0
  %v3858 = select i1 %v3857, i64 %v224, i64 0
  %v3859 = getelementptr double, ptr %v223, i64 %v3856
  %v3860 = getelementptr double, ptr %v3859, i64 %v3858
  %v3861 = load double, ptr %v3860, align 8, !noalias !535
  %v3862 = add nsw i64 %v3854, %v3776
  %v3863 = icmp slt i64 %v3862, 0
  %v3864 = select i1 %v3863, i64 %v224, i64 0
  %v3865 = getelementptr double, ptr %v223, i64 %v3862
  %v3866 = getelementptr double, ptr %v3865, i64 %v3864
  %v3867 = load double, ptr %v3866, align 8, !noalias !535
  %v3868 = fmul double %v3842, %v3867
  %v3869 = fsub double %v3861, %v3868
  store double %v3869, ptr %v3860, align 8, !noalias !535
  %v3870 = icmp sgt i64 %v3852, 1
  br i1 %v3870, label %v3851, label %v3791

v3752:
  %v3755 = phi i64 [ %v3764, %v3753 ], [ 0, %v3571 ]
  %v3764 = add nsw i64 %v3755, 1
  %v3871 = sub i64 %v3755, %v589
  %v3872 = tail call i64 @llvm.smax.i64(i64 %v3871, i64 0)
  %v3873 = add i64 %v590, %v3755
  %v3874 = tail call i64 @llvm.smin.i64(i64 %v3873, i64 %v10)
  %v3875 = sub i64 %v3874, %v3872
  %v3876 = icmp slt i64 %v3875, 1
  br i1 %v3876, label %v3753, label %v3877

v3877:
  %v3878 = mul nsw i64 %v3755, %v10
  br label %v3879

v3879:
  %v3880 = phi i64 [ %v3875, %v3877 ], [ %v3881, %v3879 ]
  %v3882 = phi i64 [ %v3872, %v3877 ], [ %v3883, %v3879 ]
  %v3881 = add nsw i64 %v3880, -1
  %v3883 = add i64 %v3882, 1
  %v3884 = add nsw i64 %v3882, %v3878
  %v3885 = icmp slt i64 %v3884, 0
  %v3886 = select i1 %v3885, i64 %v217, i64 0
  %v3887 = getelementptr double, ptr %v216, i64 %v3884
  %v3888 = getelementptr double, ptr %v3887, i64 %v3886
  %v3889 = load double, ptr %v3888, align 8, !noalias !517
  %v3890 = fneg double %v3889
  %v3891 = select i1 %v3885, i64 %v224, i64 0
  %v3892 = getelementptr double, ptr %v223, i64 %v3884
  %v3893 = getelementptr double, ptr %v3892, i64 %v3891
  store double %v3890, ptr %v3893, align 8, !noalias !517
  %v3894 = icmp sgt i64 %v3880, 1
  br i1 %v3894, label %v3879, label %v3753

v3567:
  br i1 %v597, label %v1203, label %v3895

v3896:
  %v3897 = mul i64 %v3898, %v605
  %v3899 = getelementptr double, ptr %v194, i64 %v3897
  br label %v3900

v3901:
  %v3902 = icmp eq i64 %v10, %v3903
  br i1 %v3902, label %v3904, label %v3905

v3906:
  %v3907 = icmp sgt i64 %v3908, 1
  br i1 %v3907, label %v3904, label %v3909

v3909:
  %v3910 = mul i64 %v3898, %v614
  %v3911 = getelementptr double, ptr %v194, i64 %v3910
  br label %v3912

v3905:
  %v3913 = phi i64 [ %v3903, %v3901 ], [ 0, %v3900 ]
  %v3903 = add nsw i64 %v3913, 1
  %v3914 = getelementptr i64, ptr %v230, i64 %v3913
  %v3915 = load i64, ptr %v3914, align 8, !noalias !538
  %v3916 = add nsw i64 %v3915, %v610
  %v3917 = icmp slt i64 %v3916, 0
  %v3918 = select i1 %v3917, i64 %v160, i64 0
  %v3919 = getelementptr double, ptr %v159, i64 %v3916
  %v3920 = getelementptr double, ptr %v3919, i64 %v3918
  %v3921 = load double, ptr %v3920, align 8, !noalias !538
  %v3922 = getelementptr double, ptr %v612, i64 %v3913
  %v3923 = load double, ptr %v3922, align 8, !noalias !538
  store double %v3923, ptr %v3920, align 8, !noalias !538
  store double %v3921, ptr %v3922, align 8, !noalias !538
  %v3924 = add i64 %v611, %v3913
  %v3925 = tail call i64 @llvm.smin.i64(i64 %v3924, i64 %v10)
  %v3926 = sub i64 %v3925, %v3903
  %v3927 = icmp slt i64 %v3926, 1
  br i1 %v3927, label %v3901, label %v3928

v3928:
  %v3929 = mul nsw i64 %v3913, %v10
  br label %v3930

v3930:
  %v3931 = phi i64 [ %v3926, %v3928 ], [ %v3932, %v3930 ]
  %v3933 = phi i64 [ %v3903, %v3928 ], [ %v3934, %v3930 ]
  %v3932 = add nsw i64 %v3931, -1
  %v3934 = add i64 %v3933, 1
  %v3935 = add nsw i64 %v3933, %v610
  %v3936 = icmp slt i64 %v3935, 0
  %v3937 = select i1 %v3936, i64 %v160, i64 0
  %v3938 = getelementptr double, ptr %v159, i64 %v3935
  %v3939 = getelementptr double, ptr %v3938, i64 %v3937
  %v3940 = load double, ptr %v3939, align 8, !noalias !538
  %v3941 = add nsw i64 %v3933, %v3929
  %v3942 = icmp slt i64 %v3941, 0
  %v3943 = select i1 %v3942, i64 %v224, i64 0
  %v3944 = getelementptr double, ptr %v223, i64 %v3941
  %v3945 = getelementptr double, ptr %v3944, i64 %v3943
  %v3946 = load double, ptr %v3945, align 8, !noalias !538
  %v3947 = fmul double %v3921, %v3946
  %v3948 = fsub double %v3940, %v3947
  store double %v3948, ptr %v3939, align 8, !noalias !538
  %v3949 = icmp sgt i64 %v3931, 1
  br i1 %v3949, label %v3930, label %v3901

v3904:
  %v3908 = phi i64 [ %v3950, %v3906 ], [ %v10, %v3901 ]
  %v3950 = add nsw i64 %v3908, -1
  %v3951 = add nsw i64 %v3950, %v610
  %v3952 = icmp slt i64 %v3951, 0
  %v3953 = select i1 %v3952, i64 %v160, i64 0
  %v3954 = getelementptr double, ptr %v159, i64 %v3951
  %v3955 = getelementptr double, ptr %v3954, i64 %v3953
  %v3956 = load double, ptr %v3955, align 8, !noalias !538
  %v3957 = mul nsw i64 %v3950, %v10
  %v3958 = add nsw i64 %v3957, %v3950
  %v3959 = icmp slt i64 %v3958, 0
  %v3960 = select i1 %v3959, i64 %v224, i64 0
  %v3961 = getelementptr double, ptr %v223, i64 %v3958
  %v3962 = getelementptr double, ptr %v3961, i64 %v3960
  %v3963 = load double, ptr %v3962, align 8, !noalias !538
  %v3964 = fdiv double %v3956, %v3963
  store double %v3964, ptr %v3955, align 8, !noalias !538
  %v3965 = sub i64 %v3950, %v613
  %v3966 = tail call i64 @llvm.smax.i64(i64 %v3965, i64 0)
  %v3967 = sub i64 %v3950, %v3966
  %v3968 = icmp slt i64 %v3967, 1
  br i1 %v3968, label %v3906, label %v3969

v3969:
  %v3970 = phi i64 [ %v3971, %v3969 ], [ %v3967, %v3904 ]
  %v3972 = phi i64 [ %v3973, %v3969 ], [ %v3966, %v3904 ]
  %v3971 = add nsw i64 %v3970, -1
  %v3973 = add i64 %v3972, 1
  %v3974 = add nsw i64 %v3972, %v610
  %v3975 = icmp slt i64 %v3974, 0
  %v3976 = select i1 %v3975, i64 %v160, i64 0
  %v3977 = getelementptr double, ptr %v159, i64 %v3974
  %v3978 = getelementptr double, ptr %v3977, i64 %v3976
  %v3979 = load double, ptr %v3978, align 8, !noalias !538
  %v3980 = add nsw i64 %v3972, %v3957
  %v3981 = icmp slt i64 %v3980, 0
  %v3982 = select i1 %v3981, i64 %v224, i64 0
  %v3983 = getelementptr double, ptr %v223, i64 %v3980
  %v3984 = getelementptr double, ptr %v3983, i64 %v3982
  %v3985 = load double, ptr %v3984, align 8, !noalias !538
  %v3986 = fmul double %v3964, %v3985
  %v3987 = fsub double %v3979, %v3986
  store double %v3987, ptr %v3978, align 8, !noalias !538
  %v3988 = icmp sgt i64 %v3970, 1
  br i1 %v3988, label %v3969, label %v3906

v3900:
  %v3989 = phi i64 [ 0, %v3896 ], [ %v3990, %v3900 ]
  %v3990 = add nsw i64 %v3989, 1
  %v3991 = mul i64 %v3989, %v197
  %v3992 = getelementptr double, ptr %v3899, i64 %v3991
  %v3993 = load double, ptr %v3992, align 8, !noalias !544
  %v3994 = getelementptr double, ptr %v607, i64 %v3991
  %v3995 = load double, ptr %v3994, align 8, !noalias !544
  %v3996 = fadd double %v3993, %v3995
  %v3997 = getelementptr i64, ptr %v239, i64 %v3989
  %v3998 = load i64, ptr %v3997, align 8, !noalias !544
  %v3999 = icmp slt i64 %v3998, 0
  %v4000 = select i1 %v3999, i64 %v196, i64 0
  %v4001 = add i64 %v4000, %v3998
  %v4002 = mul i64 %v4001, %v197
  %v4003 = getelementptr double, ptr %v609, i64 %v4002
  store double %v3996, ptr %v4003, align 8, !noalias !544
  %v4004 = icmp eq i64 %v10, %v3990
  br i1 %v4004, label %v3905, label %v3900

v3912:
  %v4005 = phi i64 [ 0, %v3909 ], [ %v4006, %v3912 ]
  %v4006 = add nsw i64 %v4005, 1
  %v4007 = getelementptr i64, ptr %v239, i64 %v4005
  %v4008 = load i64, ptr %v4007, align 8, !noalias !544
  %v4009 = icmp slt i64 %v4008, 0
  %v4010 = select i1 %v4009, i64 %v196, i64 0
  %v4011 = add i64 %v4010, %v4008
  %v4012 = mul i64 %v4011, %v197
  %v4013 = getelementptr double, ptr %v616, i64 %v4012
  %v4014 = load double, ptr %v4013, align 8, !noalias !544
  %v4015 = mul i64 %v4005, %v197
  %v4016 = getelementptr double, ptr %v3911, i64 %v4015
  store double %v4014, ptr %v4016, align 8, !noalias !544
  %v4017 = icmp eq i64 %v10, %v4006
  br i1 %v4017, label %v4018, label %v3912

v4018:
  %v4019 = icmp eq i64 %v4020, %v596
  br i1 %v4019, label %v1203, label %v3895

v1203:
  %v4021 = load i64, ptr %v617, align 8, !noalias !545
  %v4022 = inttoptr i64 %v4021 to ptr
  tail call void %v4022(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !545
  br i1 %v287, label %v1201, label %v1191

v3895:
  %v4020 = phi i64 [ %v3898, %v4018 ], [ 1, %v3567 ]
  %v3898 = add i64 %v4020, 1
  %v4023 = getelementptr i64, ptr %v6, i64 %v4020
  %v4024 = getelementptr i8, ptr %v4023, i64 104
  %v4025 = load i64, ptr %v4024, align 8, !noalias !548
  %v4026 = inttoptr i64 %v4025 to ptr
  tail call void %v4026(ptr %v134, ptr %v159, ptr %v166, ptr %v24, ptr %v180, ptr %v187), !noalias !548
  %v4027 = load i64, ptr %v6, align 8, !noalias !551
  %v4028 = mul nsw i64 %v3898, %v600
  %v4029 = getelementptr double, ptr %v159, i64 %v4028
  %v4030 = inttoptr i64 %v4027 to ptr
  tail call void %v4030(ptr %v599, ptr %v602, ptr %v166, ptr %v173, ptr %v180, ptr %v4029), !noalias !551
  br i1 %v604, label %v3896, label %v4018

v1191:
  %v1192 = phi i1 [ %v1198, %v1193 ], [ %v1179, %v1203 ]
  %v4031 = phi i1 [ %v1190, %v1193 ], [ false, %v1203 ]
  %v1200 = phi i64 [ %v4032, %v1193 ], [ %v288, %v1203 ]
  %v1186 = phi i64 [ %v4033, %v1193 ], [ 0, %v1203 ]
  %v4032 = add nsw i64 %v1200, -1
  %v4033 = add nsw i64 %v1186, 1
  br i1 %v4031, label %v1189, label %v1184

v1294:
  %v1304 = xor i1 %v1289, true
  %v4034 = xor i1 %v1290, true
  %v1306 = select i1 %v4034, i1 true, i1 %v644
  br label %v1207

v2856:
  store ptr %v2853, ptr %v1, align 8
  br label %v3558

v2855:
  %v4035 = select i1 %v1204, i1 %v1202, i1 false
  %v4036 = xor i1 %v4035, true
  %v4037 = or i1 %v287, %v4036
  br i1 %v4037, label %v2931, label %v2932

v3506:
  %v3510 = select i1 %v3503, i64 0, i64 %v1017
  br label %v1014

v3515:
  store i64 %v3514, ptr %v0, align 8
  br label %v3558
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define internal fastcc range(i32 0, 2) i32 @_ZN5pages12event_checks13find_crossingB3v59B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d(ptr noalias nonnull %v0, ptr noalias nonnull %v1, i64 %v2, ptr readonly %v3, i64 %v4, ptr %v5, i64 %v6, i64 %v7, ptr %v8, i64 %v9, ptr %v10, i64 %v11, ptr readonly %v12, i64 %v13, i64 %v14, i64 %v15, double %v16) unnamed_addr {
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
  %v79 = phi i64 [ %v41, %v39 ], [ %v59, %v60 ], [ 8, %v70 ]
  %v80 = add nsw i64 %v79, -1
  %v81 = select i1 %v18, i64 0, i64 %v80
  %v82 = getelementptr double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v59B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v81
  %v83 = getelementptr i8, ptr %v82, i64 72
  %v84 = load double, ptr %v83, align 8
  %v85 = fcmp ogt double %v84, %v16
  %v86 = select i1 %v85, double %v84, double %v16
  %v87 = getelementptr double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v59B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v79
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
  %v144 = load double, ptr %v143, align 8, !noalias !558
  %v145 = load double, ptr %v142, align 8, !noalias !558
  %v146 = fmul double %v145, 0x3FDDF27AAAADCB3A
  %v147 = fsub double %v144, %v146
  %v148 = getelementptr i8, ptr %v142, i64 %v119
  %v149 = load double, ptr %v148, align 8, !noalias !558
  %v150 = fmul double %v149, 0x3FEC575F1EBC4F2F
  %v151 = fsub double %v147, %v150
  %v152 = getelementptr i8, ptr %v142, i64 %v120
  %v153 = load double, ptr %v152, align 8, !noalias !558
  %v154 = fmul double %v153, 0x3FE1306AA3D795F4
  %v155 = fadd double %v151, %v154
  %v156 = getelementptr i8, ptr %v142, i64 %v121
  %v157 = load double, ptr %v156, align 8, !noalias !558
  %v158 = fmul double %v157, 0x3FCCB9F574BDCC3A
  %v159 = fsub double %v155, %v158
  %v160 = getelementptr i8, ptr %v142, i64 %v122
  %v161 = load double, ptr %v160, align 8, !noalias !558
  %v162 = fmul double %v161, 0x3FA4EAF2D6B11E79
  %v163 = fadd double %v159, %v162
  %v164 = tail call double @llvm.fabs.f64(double %v163)
  %v165 = fcmp ogt double %v164, 0.000000e+00
  %v166 = select i1 %v165, double %v164, double 0.000000e+00
  %v167 = getelementptr i8, ptr %v142, i64 %v123
  %v168 = load double, ptr %v167, align 8, !noalias !558
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
  %v183 = load double, ptr %v182, align 8, !noalias !558
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
  %v198 = load double, ptr %v197, align 8, !noalias !558
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
  %v213 = load double, ptr %v212, align 8, !noalias !565
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
  %v266 = load double, ptr %v265, align 8, !noalias !566
  %v267 = icmp slt i64 %v251, 0
  %v268 = select i1 %v267, i64 %v13, i64 0
  %v269 = add i64 %v268, %v251
  %v270 = mul i64 %v269, %v104
  %v271 = getelementptr double, ptr %v142, i64 %v270
  %v272 = load double, ptr %v271, align 8, !noalias !566
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
  %v283 = load double, ptr %v282, align 8, !noalias !566
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
  %v321 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v59B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v293
  %v322 = load double, ptr %v321, align 8
  %v323 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v59B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v318
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
  %v330 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v59B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v325
  %v331 = load double, ptr %v330, align 8
  %v332 = getelementptr inbounds double, ptr @switch.table._ZN5pages12event_checks13find_crossingB3v59B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d.7, i64 %v328
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
  br i1 %v341, label %v138, label %v344, !prof !419

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
  br i1 %v354, label %v355, label %v38, !prof !121

v356:
  %v357 = fmul double %v102, 5.000000e-01
  store double 0.000000e+00, ptr %v31, align 8, !noalias !570
  %v358 = shl i64 %v9, 5
  %v359 = getelementptr i8, ptr %v8, i64 %v358
  store double 0.000000e+00, ptr %v359, align 8, !noalias !570
  %v360 = getelementptr double, ptr %v8, i64 %v9
  store double %v357, ptr %v360, align 8, !noalias !570
  %v361 = load i64, ptr %v10, align 8, !noalias !570
  %v362 = icmp slt i64 %v361, 0
  %v363 = select i1 %v362, i64 %v6, i64 0
  %v364 = add i64 %v363, %v361
  %v365 = mul i64 %v364, %v7
  %v366 = getelementptr i64, ptr %v5, i64 %v365
  %v367 = load i64, ptr %v366, align 8, !noalias !570
  %v368 = add nsw i64 %v367, -1
  store i64 %v368, ptr %v366, align 8, !noalias !570
  %v369 = load i64, ptr %v10, align 8, !noalias !570
  %v370 = icmp slt i64 %v369, 0
  %v371 = select i1 %v370, i64 %v6, i64 0
  %v372 = add i64 %v371, %v369
  %v373 = mul i64 %v372, %v7
  %v374 = getelementptr i64, ptr %v5, i64 %v373
  %v375 = getelementptr i8, ptr %v374, i64 24
  %v376 = load i64, ptr %v375, align 8, !noalias !570
  %v377 = add nsw i64 %v376, 1
  store i64 %v377, ptr %v375, align 8, !noalias !570
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
  %v404 = load double, ptr %v403, align 8, !noalias !573
  %v405 = getelementptr double, ptr %v397, i64 %v401
  %v406 = load double, ptr %v405, align 8, !noalias !573
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
  %v430 = load double, ptr %v429, align 8, !noalias !577
  %v431 = getelementptr double, ptr %v423, i64 %v427
  %v432 = load double, ptr %v431, align 8, !noalias !577
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
  %v442 = load double, ptr %v8, align 8, !noalias !581
  %v443 = tail call double @llvm.fabs.f64(double %v442)
  %v444 = fmul double %v443, 4.000000e-15
  %v445 = getelementptr double, ptr %v3, i64 %v4
  %v446 = getelementptr i8, ptr %v445, i64 -8
  %v447 = load double, ptr %v446, align 8, !noalias !581
  %v448 = load double, ptr %v3, align 8, !noalias !581
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
!1 = distinct !{!1, !2, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!2 = distinct !{!2, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!3 = !{!4, !6, !1}
!4 = distinct !{!4, !5, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!5 = distinct !{!5, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!6 = distinct !{!6, !5, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!7 = !{!8, !10, !1}
!8 = distinct !{!8, !9, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!9 = distinct !{!9, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!10 = distinct !{!10, !9, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!11 = !{!12, !14}
!12 = distinct !{!12, !13, !"_ZN5pages12time_stepper14start_segmentsB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!13 = distinct !{!13, !"_ZN5pages12time_stepper14start_segmentsB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!14 = distinct !{!14, !13, !"_ZN5pages12time_stepper14start_segmentsB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!15 = !{!16, !12, !14}
!16 = distinct !{!16, !17, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!17 = distinct !{!17, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!18 = !{!19, !21, !23, !12, !14}
!19 = distinct !{!19, !20, !"_ZN5pages13solver_layout6decideB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_280_29: %retptr"}
!20 = distinct !{!20, !"_ZN5pages13solver_layout6decideB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_280_29"}
!21 = distinct !{!21, !22, !"_ZN5pages12event_checks17decisions_changedB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!22 = distinct !{!22, !"_ZN5pages12event_checks17decisions_changedB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!23 = distinct !{!23, !22, !"_ZN5pages12event_checks17decisions_changedB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!24 = !{!21, !23, !12, !14}
!25 = !{!26, !28, !30, !12, !14}
!26 = distinct !{!26, !27, !"_ZN5pages13solver_layout6decideB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_280_29: %retptr"}
!27 = distinct !{!27, !"_ZN5pages13solver_layout6decideB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedEx23Literal_5bint_5d_280_29"}
!28 = distinct !{!28, !29, !"_ZN5pages12event_checks14hold_decisionsB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!29 = distinct !{!29, !"_ZN5pages12event_checks14hold_decisionsB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!30 = distinct !{!30, !29, !"_ZN5pages12event_checks14hold_decisionsB2v9B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!31 = !{!28, !30, !12, !14}
!32 = !{!33, !28, !30, !12, !14}
!33 = distinct !{!33, !34, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!34 = distinct !{!34, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!35 = !{!36, !12, !14}
!36 = distinct !{!36, !37, !"_ZN5pages13solver_layout10derivativeB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29x: %retptr"}
!37 = distinct !{!37, !"_ZN5pages13solver_layout10derivativeB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29x"}
!38 = !{!39, !12, !14}
!39 = distinct !{!39, !40, !"_ZN5pages13solver_layout7formulaB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_287_29: %retptr"}
!40 = distinct !{!40, !"_ZN5pages13solver_layout7formulaB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_287_29"}
!41 = !{!42, !12, !14}
!42 = distinct !{!42, !43, !"_ZN5pages13solver_layout7formulaB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_288_29: %retptr"}
!43 = distinct !{!43, !"_ZN5pages13solver_layout7formulaB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_288_29"}
!44 = !{!45, !12, !14}
!45 = distinct !{!45, !46, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!46 = distinct !{!46, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!47 = !{!48, !12, !14}
!48 = distinct !{!48, !49, !"_ZN5pages13solver_layout7formulaB3v14B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!49 = distinct !{!49, !"_ZN5pages13solver_layout7formulaB3v14B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!50 = !{!51, !53, !12, !14}
!51 = distinct !{!51, !52, !"_ZN5pages8segments13begin_segmentB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!52 = distinct !{!52, !"_ZN5pages8segments13begin_segmentB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!53 = distinct !{!53, !52, !"_ZN5pages8segments13begin_segmentB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!54 = !{!55, !51, !53, !12, !14}
!55 = distinct !{!55, !56, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!56 = distinct !{!56, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!57 = !{!58, !60, !62, !51, !53, !12, !14}
!58 = distinct !{!58, !59, !"_ZN5pages13solver_layout6decideB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_289_29: %retptr"}
!59 = distinct !{!59, !"_ZN5pages13solver_layout6decideB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_289_29"}
!60 = distinct !{!60, !61, !"_ZN5pages8segments12stop_outsideB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x23Literal_5bint_5d_280_29: %retptr"}
!61 = distinct !{!61, !"_ZN5pages8segments12stop_outsideB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x23Literal_5bint_5d_280_29"}
!62 = distinct !{!62, !61, !"_ZN5pages8segments12stop_outsideB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x23Literal_5bint_5d_280_29: %excinfo"}
!63 = !{!60, !62, !51, !53, !12, !14}
!64 = !{!65, !60, !62, !51, !53, !12, !14}
!65 = distinct !{!65, !66, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!66 = distinct !{!66, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!67 = !{!68, !70, !60, !62, !51, !53, !12, !14}
!68 = distinct !{!68, !69, !"_ZN5pages13solver_layout13first_outsideB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!69 = distinct !{!69, !"_ZN5pages13solver_layout13first_outsideB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!70 = distinct !{!70, !69, !"_ZN5pages13solver_layout13first_outsideB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!71 = !{!72, !74, !51, !53, !12, !14}
!72 = distinct !{!72, !73, !"_ZN5pages8segments14note_next_stopB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!73 = distinct !{!73, !"_ZN5pages8segments14note_next_stopB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!74 = distinct !{!74, !73, !"_ZN5pages8segments14note_next_stopB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!75 = !{!76, !78, !80}
!76 = distinct !{!76, !77, !"_ZN5pages13solver_layout7formulaB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_285_29: %retptr"}
!77 = distinct !{!77, !"_ZN5pages13solver_layout7formulaB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_285_29"}
!78 = distinct !{!78, !79, !"_ZN5pages12time_stepper12attempt_stepB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!79 = distinct !{!79, !"_ZN5pages12time_stepper12attempt_stepB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!80 = distinct !{!80, !79, !"_ZN5pages12time_stepper12attempt_stepB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!81 = !{!82, !84, !85, !87}
!82 = distinct !{!82, !83, !"_ZN5pages12time_stepper11count_stepsB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!83 = distinct !{!83, !"_ZN5pages12time_stepper11count_stepsB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!84 = distinct !{!84, !83, !"_ZN5pages12time_stepper11count_stepsB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!85 = distinct !{!85, !86, !"_ZN5pages12time_stepper11check_lanesB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!86 = distinct !{!86, !"_ZN5pages12time_stepper11check_lanesB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!87 = distinct !{!87, !86, !"_ZN5pages12time_stepper11check_lanesB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!88 = !{!85, !87}
!89 = !{!90, !85, !87}
!90 = distinct !{!90, !91, !"_ZN5pages13solver_layout4failB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!91 = distinct !{!91, !"_ZN5pages13solver_layout4failB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!92 = !{!93, !95, !97}
!93 = distinct !{!93, !94, !"_ZN5pages13solver_layout10derivativeB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!94 = distinct !{!94, !"_ZN5pages13solver_layout10derivativeB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!95 = distinct !{!95, !96, !"_ZN5pages12time_stepper13handle_eventsB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb: %retptr"}
!96 = distinct !{!96, !"_ZN5pages12time_stepper13handle_eventsB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb"}
!97 = distinct !{!97, !96, !"_ZN5pages12time_stepper13handle_eventsB3v97B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29bbb: %excinfo"}
!98 = !{!99, !95, !97}
!99 = distinct !{!99, !100, !"_ZN5pages13solver_layout7formulaB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2813_29: %retptr"}
!100 = distinct !{!100, !"_ZN5pages13solver_layout7formulaB3v44B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2813_29"}
!101 = !{!102, !95, !97}
!102 = distinct !{!102, !103, !"_ZN5pages13solver_layout7formulaB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2812_29: %retptr"}
!103 = distinct !{!103, !"_ZN5pages13solver_layout7formulaB3v45B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2812_29"}
!104 = !{!105, !107, !108, !110, !111, !113, !95, !97}
!105 = distinct !{!105, !106, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!106 = distinct !{!106, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!107 = distinct !{!107, !106, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!108 = distinct !{!108, !109, !"_ZN5pages12event_checks15evaluate_pointsB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!109 = distinct !{!109, !"_ZN5pages12event_checks15evaluate_pointsB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!110 = distinct !{!110, !109, !"_ZN5pages12event_checks15evaluate_pointsB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!111 = distinct !{!111, !112, !"_ZN5pages12event_checks10comes_nearB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!112 = distinct !{!112, !"_ZN5pages12event_checks10comes_nearB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!113 = distinct !{!113, !112, !"_ZN5pages12event_checks10comes_nearB3v46B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!114 = !{!115, !117, !105, !107, !108, !110, !111, !113, !95, !97}
!115 = distinct !{!115, !116, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!116 = distinct !{!116, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!117 = distinct !{!117, !116, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!118 = !{!119, !108, !110, !111, !113, !95, !97}
!119 = distinct !{!119, !120, !"_ZN5pages13solver_layout6decideB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!120 = distinct !{!120, !"_ZN5pages13solver_layout6decideB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!121 = !{!"branch_weights", i32 99, i32 1}
!122 = !{!123, !125, !127, !95, !97}
!123 = distinct !{!123, !124, !"_ZN5pages13solver_layout7formulaB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!124 = distinct !{!124, !"_ZN5pages13solver_layout7formulaB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!125 = distinct !{!125, !126, !"_ZN5pages12time_stepper18interpolant_stagesB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!126 = distinct !{!126, !"_ZN5pages12time_stepper18interpolant_stagesB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!127 = distinct !{!127, !126, !"_ZN5pages12time_stepper18interpolant_stagesB3v53B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!128 = !{!129, !125, !127, !95, !97}
!129 = distinct !{!129, !130, !"_ZN5pages13solver_layout7formulaB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!130 = distinct !{!130, !"_ZN5pages13solver_layout7formulaB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!131 = !{!132, !125, !127, !95, !97}
!132 = distinct !{!132, !133, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!133 = distinct !{!133, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!134 = !{!135, !95, !97}
!135 = distinct !{!135, !136, !"_ZN5pages13solver_layout7formulaB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2811_29: %retptr"}
!136 = distinct !{!136, !"_ZN5pages13solver_layout7formulaB3v54B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2811_29"}
!137 = !{!138, !140, !95, !97}
!138 = distinct !{!138, !139, !"_ZN5pages12time_stepper17check_interpolantB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!139 = distinct !{!139, !"_ZN5pages12time_stepper17check_interpolantB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!140 = distinct !{!140, !139, !"_ZN5pages12time_stepper17check_interpolantB3v55B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!141 = !{!142, !138, !140, !95, !97}
!142 = distinct !{!142, !143, !"_ZN5pages13solver_layout5retryB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd: %retptr"}
!143 = distinct !{!143, !"_ZN5pages13solver_layout5retryB3v56B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xd"}
!144 = !{!145, !147, !95, !97}
!145 = distinct !{!145, !146, !"_ZN5pages12event_checks12check_eventsB3v57B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!146 = distinct !{!146, !"_ZN5pages12event_checks12check_eventsB3v57B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!147 = distinct !{!147, !146, !"_ZN5pages12event_checks12check_eventsB3v57B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!148 = !{!149, !151, !152, !154, !145, !147, !95, !97}
!149 = distinct !{!149, !150, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!150 = distinct !{!150, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!151 = distinct !{!151, !150, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!152 = distinct !{!152, !153, !"_ZN5pages12event_checks15evaluate_pointsB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!153 = distinct !{!153, !"_ZN5pages12event_checks15evaluate_pointsB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!154 = distinct !{!154, !153, !"_ZN5pages12event_checks15evaluate_pointsB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!155 = !{!156, !158, !149, !151, !152, !154, !145, !147, !95, !97}
!156 = distinct !{!156, !157, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!157 = distinct !{!157, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!158 = distinct !{!158, !157, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!159 = !{!160, !152, !154, !145, !147, !95, !97}
!160 = distinct !{!160, !161, !"_ZN5pages13solver_layout6decideB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!161 = distinct !{!161, !"_ZN5pages13solver_layout6decideB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!162 = !{!163, !165, !145, !147, !95, !97}
!163 = distinct !{!163, !164, !"_ZN5pages12event_checks9set_edgesB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!164 = distinct !{!164, !"_ZN5pages12event_checks9set_edgesB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!165 = distinct !{!165, !164, !"_ZN5pages12event_checks9set_edgesB3v58B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!166 = !{!167, !169, !95, !97}
!167 = distinct !{!167, !168, !"_ZN5pages14event_location13locate_eventsB3v67B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!168 = distinct !{!168, !"_ZN5pages14event_location13locate_eventsB3v67B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!169 = distinct !{!169, !168, !"_ZN5pages14event_location13locate_eventsB3v67B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!170 = !{!171, !173, !174, !167, !169, !95, !97}
!171 = distinct !{!171, !172, !"_ZN5pages14event_location10next_shareB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %retptr"}
!172 = distinct !{!172, !"_ZN5pages14event_location10next_shareB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx"}
!173 = distinct !{!173, !172, !"_ZN5pages14event_location10next_shareB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %excinfo"}
!174 = distinct !{!174, !175, !"_ZN5pages14event_location6narrowB3v68B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!175 = distinct !{!175, !"_ZN5pages14event_location6narrowB3v68B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!176 = !{!174, !167, !169, !95, !97}
!177 = !{!178, !180, !181, !183, !174, !167, !169, !95, !97}
!178 = distinct !{!178, !179, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!179 = distinct !{!179, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!180 = distinct !{!180, !179, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!181 = distinct !{!181, !182, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!182 = distinct !{!182, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!183 = distinct !{!183, !182, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!184 = !{!185, !187, !178, !180, !181, !183, !174, !167, !169, !95, !97}
!185 = distinct !{!185, !186, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!186 = distinct !{!186, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!187 = distinct !{!187, !186, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!188 = !{!189, !181, !183, !174, !167, !169, !95, !97}
!189 = distinct !{!189, !190, !"_ZN5pages13solver_layout6decideB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!190 = distinct !{!190, !"_ZN5pages13solver_layout6decideB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!191 = !{!192, !194, !174, !167, !169, !95, !97}
!192 = distinct !{!192, !193, !"_ZN5pages12event_checks14least_distanceB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!193 = distinct !{!193, !"_ZN5pages12event_checks14least_distanceB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!194 = distinct !{!194, !193, !"_ZN5pages12event_checks14least_distanceB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!195 = !{!196, !198, !199, !167, !169, !95, !97}
!196 = distinct !{!196, !197, !"_ZN5pages14event_location10next_shareB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %retptr"}
!197 = distinct !{!197, !"_ZN5pages14event_location10next_shareB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx"}
!198 = distinct !{!198, !197, !"_ZN5pages14event_location10next_shareB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %excinfo"}
!199 = distinct !{!199, !200, !"_ZN5pages14event_location6narrowB3v68B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!200 = distinct !{!200, !"_ZN5pages14event_location6narrowB3v68B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!201 = !{!199, !167, !169, !95, !97}
!202 = !{!203, !205, !206, !208, !199, !167, !169, !95, !97}
!203 = distinct !{!203, !204, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!204 = distinct !{!204, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!205 = distinct !{!205, !204, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!206 = distinct !{!206, !207, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!207 = distinct !{!207, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!208 = distinct !{!208, !207, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!209 = !{!210, !212, !203, !205, !206, !208, !199, !167, !169, !95, !97}
!210 = distinct !{!210, !211, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!211 = distinct !{!211, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!212 = distinct !{!212, !211, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!213 = !{!214, !206, !208, !199, !167, !169, !95, !97}
!214 = distinct !{!214, !215, !"_ZN5pages13solver_layout6decideB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!215 = distinct !{!215, !"_ZN5pages13solver_layout6decideB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!216 = !{!217, !219, !199, !167, !169, !95, !97}
!217 = distinct !{!217, !218, !"_ZN5pages12event_checks14least_distanceB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!218 = distinct !{!218, !"_ZN5pages12event_checks14least_distanceB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!219 = distinct !{!219, !218, !"_ZN5pages12event_checks14least_distanceB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!220 = !{!221, !223, !167, !169, !95, !97}
!221 = distinct !{!221, !222, !"_ZN5pages14event_location9stops_runB3v81B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!222 = distinct !{!222, !"_ZN5pages14event_location9stops_runB3v81B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!223 = distinct !{!223, !222, !"_ZN5pages14event_location9stops_runB3v81B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!224 = !{!225, !227, !228, !230, !221, !223, !167, !169, !95, !97}
!225 = distinct !{!225, !226, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!226 = distinct !{!226, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!227 = distinct !{!227, !226, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!228 = distinct !{!228, !229, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!229 = distinct !{!229, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!230 = distinct !{!230, !229, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!231 = !{!232, !234, !225, !227, !228, !230, !221, !223, !167, !169, !95, !97}
!232 = distinct !{!232, !233, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!233 = distinct !{!233, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!234 = distinct !{!234, !233, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!235 = !{!236, !228, !230, !221, !223, !167, !169, !95, !97}
!236 = distinct !{!236, !237, !"_ZN5pages13solver_layout6decideB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!237 = distinct !{!237, !"_ZN5pages13solver_layout6decideB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!238 = !{!239, !241, !242, !244, !245, !247, !221, !223, !167, !169, !95, !97}
!239 = distinct !{!239, !240, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!240 = distinct !{!240, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!241 = distinct !{!241, !240, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!242 = distinct !{!242, !243, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!243 = distinct !{!243, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!244 = distinct !{!244, !243, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!245 = distinct !{!245, !246, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!246 = distinct !{!246, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!247 = distinct !{!247, !246, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!248 = !{!242, !244, !245, !247, !221, !223, !167, !169, !95, !97}
!249 = !{!250, !245, !247, !221, !223, !167, !169, !95, !97}
!250 = distinct !{!250, !251, !"_ZN5pages13solver_layout6decideB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!251 = distinct !{!251, !"_ZN5pages13solver_layout6decideB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!252 = !{!253, !255, !256, !221, !223, !167, !169, !95, !97}
!253 = distinct !{!253, !254, !"_ZN5pages14event_location10next_shareB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %retptr"}
!254 = distinct !{!254, !"_ZN5pages14event_location10next_shareB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx"}
!255 = distinct !{!255, !254, !"_ZN5pages14event_location10next_shareB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %excinfo"}
!256 = distinct !{!256, !257, !"_ZN5pages14event_location6narrowB3v68B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!257 = distinct !{!257, !"_ZN5pages14event_location6narrowB3v68B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!258 = !{!256, !221, !223, !167, !169, !95, !97}
!259 = !{!260, !262, !263, !265, !256, !221, !223, !167, !169, !95, !97}
!260 = distinct !{!260, !261, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!261 = distinct !{!261, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!262 = distinct !{!262, !261, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!263 = distinct !{!263, !264, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!264 = distinct !{!264, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!265 = distinct !{!265, !264, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!266 = !{!267, !269, !260, !262, !263, !265, !256, !221, !223, !167, !169, !95, !97}
!267 = distinct !{!267, !268, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!268 = distinct !{!268, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!269 = distinct !{!269, !268, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!270 = !{!271, !263, !265, !256, !221, !223, !167, !169, !95, !97}
!271 = distinct !{!271, !272, !"_ZN5pages13solver_layout6decideB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!272 = distinct !{!272, !"_ZN5pages13solver_layout6decideB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!273 = !{!274, !276, !256, !221, !223, !167, !169, !95, !97}
!274 = distinct !{!274, !275, !"_ZN5pages12event_checks14least_distanceB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!275 = distinct !{!275, !"_ZN5pages12event_checks14least_distanceB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!276 = distinct !{!276, !275, !"_ZN5pages12event_checks14least_distanceB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!277 = !{!278, !221, !223, !167, !169, !95, !97}
!278 = distinct !{!278, !279, !"_ZN5pages13solver_layout4failB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29: %retptr"}
!279 = distinct !{!279, !"_ZN5pages13solver_layout4failB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29"}
!280 = !{!281, !283, !221, !223, !167, !169, !95, !97}
!281 = distinct !{!281, !282, !"_ZN5pages12event_checks13first_crossedB3v82B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!282 = distinct !{!282, !"_ZN5pages12event_checks13first_crossedB3v82B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!283 = distinct !{!283, !282, !"_ZN5pages12event_checks13first_crossedB3v82B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!284 = !{!285, !287, !167, !169, !95, !97}
!285 = distinct !{!285, !286, !"_ZN5pages12event_checks13shortest_stepB3v63B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!286 = distinct !{!286, !"_ZN5pages12event_checks13shortest_stepB3v63B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!287 = distinct !{!287, !286, !"_ZN5pages12event_checks13shortest_stepB3v63B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!288 = !{!289, !291, !292, !294, !167, !169, !95, !97}
!289 = distinct !{!289, !290, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!290 = distinct !{!290, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!291 = distinct !{!291, !290, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!292 = distinct !{!292, !293, !"_ZN5pages14event_location8end_stepB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!293 = distinct !{!293, !"_ZN5pages14event_location8end_stepB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!294 = distinct !{!294, !293, !"_ZN5pages14event_location8end_stepB3v84B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!295 = !{!296, !298, !289, !291, !292, !294, !167, !169, !95, !97}
!296 = distinct !{!296, !297, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!297 = distinct !{!297, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!298 = distinct !{!298, !297, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!299 = !{!292, !294, !167, !169, !95, !97}
!300 = !{!301, !292, !294, !167, !169, !95, !97}
!301 = distinct !{!301, !302, !"_ZN5pages13solver_layout10derivativeB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!302 = distinct !{!302, !"_ZN5pages13solver_layout10derivativeB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!303 = !{!304, !292, !294, !167, !169, !95, !97}
!304 = distinct !{!304, !305, !"_ZN5pages13solver_layout6decideB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_288_29: %retptr"}
!305 = distinct !{!305, !"_ZN5pages13solver_layout6decideB3v85B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_288_29"}
!306 = !{!307, !167, !169, !95, !97}
!307 = distinct !{!307, !308, !"_ZN5pages13solver_layout5retryB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!308 = distinct !{!308, !"_ZN5pages13solver_layout5retryB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!309 = !{!310, !312, !167, !169, !95, !97}
!310 = distinct !{!310, !311, !"_ZN5pages14event_location11pass_eventsB3v74B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!311 = distinct !{!311, !"_ZN5pages14event_location11pass_eventsB3v74B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!312 = distinct !{!312, !311, !"_ZN5pages14event_location11pass_eventsB3v74B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!313 = !{!314, !316, !317, !319, !310, !312, !167, !169, !95, !97}
!314 = distinct !{!314, !315, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!315 = distinct !{!315, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!316 = distinct !{!316, !315, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!317 = distinct !{!317, !318, !"_ZN5pages12event_checks15evaluate_pointsB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!318 = distinct !{!318, !"_ZN5pages12event_checks15evaluate_pointsB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!319 = distinct !{!319, !318, !"_ZN5pages12event_checks15evaluate_pointsB3v47B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!320 = !{!321, !323, !314, !316, !317, !319, !310, !312, !167, !169, !95, !97}
!321 = distinct !{!321, !322, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!322 = distinct !{!322, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!323 = distinct !{!323, !322, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!324 = !{!325, !317, !319, !310, !312, !167, !169, !95, !97}
!325 = distinct !{!325, !326, !"_ZN5pages13solver_layout6decideB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx: %retptr"}
!326 = distinct !{!326, !"_ZN5pages13solver_layout6decideB3v51B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedExx"}
!327 = !{!328, !310, !312, !167, !169, !95, !97}
!328 = distinct !{!328, !329, !"_ZN5pages13solver_layout10derivativeB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29: %retptr"}
!329 = distinct !{!329, !"_ZN5pages13solver_layout10derivativeB3v43B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2924Literal_5bint_5d_2813_29"}
!330 = !{!331, !333, !334, !310, !312, !167, !169, !95, !97}
!331 = distinct !{!331, !332, !"_ZN5pages14event_location10next_shareB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %retptr"}
!332 = distinct !{!332, !"_ZN5pages14event_location10next_shareB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx"}
!333 = distinct !{!333, !332, !"_ZN5pages14event_location10next_shareB3v69B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29dx: %excinfo"}
!334 = distinct !{!334, !335, !"_ZN5pages14event_location6narrowB3v68B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!335 = distinct !{!335, !"_ZN5pages14event_location6narrowB3v68B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!336 = !{!334, !310, !312, !167, !169, !95, !97}
!337 = !{!338, !340, !341, !343, !334, !310, !312, !167, !169, !95, !97}
!338 = distinct !{!338, !339, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!339 = distinct !{!339, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!340 = distinct !{!340, !339, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!341 = distinct !{!341, !342, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!342 = distinct !{!342, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!343 = distinct !{!343, !342, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!344 = !{!345, !347, !338, !340, !341, !343, !334, !310, !312, !167, !169, !95, !97}
!345 = distinct !{!345, !346, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!346 = distinct !{!346, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!347 = distinct !{!347, !346, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!348 = !{!349, !341, !343, !334, !310, !312, !167, !169, !95, !97}
!349 = distinct !{!349, !350, !"_ZN5pages13solver_layout6decideB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!350 = distinct !{!350, !"_ZN5pages13solver_layout6decideB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!351 = !{!352, !354, !334, !310, !312, !167, !169, !95, !97}
!352 = distinct !{!352, !353, !"_ZN5pages12event_checks14least_distanceB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %retptr"}
!353 = distinct !{!353, !"_ZN5pages12event_checks14least_distanceB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29"}
!354 = distinct !{!354, !353, !"_ZN5pages12event_checks14least_distanceB3v73B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedE23Literal_5bint_5d_289_29: %excinfo"}
!355 = !{!356, !358, !360, !310, !312, !167, !169, !95, !97}
!356 = distinct !{!356, !357, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!357 = distinct !{!357, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!358 = distinct !{!358, !359, !"_ZN5pages14event_location18exchange_decisionsB3v80B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %retptr"}
!359 = distinct !{!359, !"_ZN5pages14event_location18exchange_decisionsB3v80B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29"}
!360 = distinct !{!360, !359, !"_ZN5pages14event_location18exchange_decisionsB3v80B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %excinfo"}
!361 = !{!358, !360, !310, !312, !167, !169, !95, !97}
!362 = !{!363, !365, !310, !312, !167, !169, !95, !97}
!363 = distinct !{!363, !364, !"_ZN5pages14event_location12rates_changeB3v75B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!364 = distinct !{!364, !"_ZN5pages14event_location12rates_changeB3v75B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!365 = distinct !{!365, !364, !"_ZN5pages14event_location12rates_changeB3v75B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!366 = !{!367, !369, !370, !372, !363, !365, !310, !312, !167, !169, !95, !97}
!367 = distinct !{!367, !368, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!368 = distinct !{!368, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!369 = distinct !{!369, !368, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!370 = distinct !{!370, !371, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!371 = distinct !{!371, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!372 = distinct !{!372, !371, !"_ZN5pages14event_location13decide_withinB3v71B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!373 = !{!374, !376, !367, !369, !370, !372, !363, !365, !310, !312, !167, !169, !95, !97}
!374 = distinct !{!374, !375, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!375 = distinct !{!375, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!376 = distinct !{!376, !375, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!377 = !{!378, !370, !372, !363, !365, !310, !312, !167, !169, !95, !97}
!378 = distinct !{!378, !379, !"_ZN5pages13solver_layout6decideB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29: %retptr"}
!379 = distinct !{!379, !"_ZN5pages13solver_layout6decideB3v72B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2923Literal_5bint_5d_289_29"}
!380 = !{!381, !383, !363, !365, !310, !312, !167, !169, !95, !97}
!381 = distinct !{!381, !382, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %retptr"}
!382 = distinct !{!382, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d"}
!383 = distinct !{!383, !382, !"_ZN5pages13solver_layout16put_state_withinB3v48B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29d: %excinfo"}
!384 = !{!385, !387, !381, !383, !363, !365, !310, !312, !167, !169, !95, !97}
!385 = distinct !{!385, !386, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %retptr"}
!386 = distinct !{!386, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d"}
!387 = distinct !{!387, !386, !"_ZN5pages13solver_layout11interpolateB3v49B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx23Literal_5bint_5d_280_29d: %excinfo"}
!388 = !{!389, !391, !393, !363, !365, !310, !312, !167, !169, !95, !97}
!389 = distinct !{!389, !390, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!390 = distinct !{!390, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!391 = distinct !{!391, !392, !"_ZN5pages14event_location18exchange_decisionsB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!392 = distinct !{!392, !"_ZN5pages14event_location18exchange_decisionsB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!393 = distinct !{!393, !392, !"_ZN5pages14event_location18exchange_decisionsB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!394 = !{!391, !393, !363, !365, !310, !312, !167, !169, !95, !97}
!395 = !{!396, !398, !400, !363, !365, !310, !312, !167, !169, !95, !97}
!396 = distinct !{!396, !397, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!397 = distinct !{!397, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!398 = distinct !{!398, !399, !"_ZN5pages14event_location18exchange_decisionsB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!399 = distinct !{!399, !"_ZN5pages14event_location18exchange_decisionsB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!400 = distinct !{!400, !399, !"_ZN5pages14event_location18exchange_decisionsB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!401 = !{!398, !400, !363, !365, !310, !312, !167, !169, !95, !97}
!402 = !{!403, !363, !365, !310, !312, !167, !169, !95, !97}
!403 = distinct !{!403, !404, !"_ZN5pages13solver_layout10derivativeB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2814_29: %retptr"}
!404 = distinct !{!404, !"_ZN5pages13solver_layout10derivativeB3v76B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2814_29"}
!405 = !{!406, !408, !410, !363, !365, !310, !312, !167, !169, !95, !97}
!406 = distinct !{!406, !407, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!407 = distinct !{!407, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!408 = distinct !{!408, !409, !"_ZN5pages14event_location18exchange_decisionsB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!409 = distinct !{!409, !"_ZN5pages14event_location18exchange_decisionsB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!410 = distinct !{!410, !409, !"_ZN5pages14event_location18exchange_decisionsB3v77B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!411 = !{!412, !363, !365, !310, !312, !167, !169, !95, !97}
!412 = distinct !{!412, !413, !"_ZN5pages13solver_layout10derivativeB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2815_29: %retptr"}
!413 = distinct !{!413, !"_ZN5pages13solver_layout10derivativeB3v78B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2816_2924Literal_5bint_5d_2815_29"}
!414 = !{!415, !417, !363, !365, !310, !312, !167, !169, !95, !97}
!415 = distinct !{!415, !416, !"_ZN5pages14event_location12rates_differB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!416 = distinct !{!416, !"_ZN5pages14event_location12rates_differB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!417 = distinct !{!417, !416, !"_ZN5pages14event_location12rates_differB3v79B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!418 = !{!408, !410, !363, !365, !310, !312, !167, !169, !95, !97}
!419 = !{!"branch_weights", i32 1, i32 99}
!420 = !{!"branch_weights", i32 101, i32 99}
!421 = !{!111, !113, !95, !97}
!422 = !{!423, !425, !111, !113, !95, !97}
!423 = distinct !{!423, !424, !"_ZN5pages12event_checks13error_betweenB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!424 = distinct !{!424, !"_ZN5pages12event_checks13error_betweenB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!425 = distinct !{!425, !424, !"_ZN5pages12event_checks13error_betweenB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!426 = !{!427}
!427 = distinct !{!427, !428, !"_ZN5pages12time_stepper13write_samplesB3v86B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29b: %retptr"}
!428 = distinct !{!428, !"_ZN5pages12time_stepper13write_samplesB3v86B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29b"}
!429 = !{!430, !432, !427}
!430 = distinct !{!430, !431, !"_ZN5pages13solver_layout11interpolateB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd: %retptr"}
!431 = distinct !{!431, !"_ZN5pages13solver_layout11interpolateB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd"}
!432 = distinct !{!432, !431, !"_ZN5pages13solver_layout11interpolateB3v87B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxd: %excinfo"}
!433 = !{!434}
!434 = distinct !{!434, !435, !"_ZN5pages13solver_layout7formulaB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29: %retptr"}
!435 = distinct !{!435, !"_ZN5pages13solver_layout7formulaB3v88B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2924Literal_5bint_5d_2810_29"}
!436 = !{!437, !439}
!437 = distinct !{!437, !438, !"_ZN5pages14event_location20restart_behind_eventB3v89B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!438 = distinct !{!438, !"_ZN5pages14event_location20restart_behind_eventB3v89B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!439 = distinct !{!439, !438, !"_ZN5pages14event_location20restart_behind_eventB3v89B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!440 = !{!441, !437, !439}
!441 = distinct !{!441, !442, !"_ZN5pages13solver_layout4failB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29: %retptr"}
!442 = distinct !{!442, !"_ZN5pages13solver_layout4failB3v83B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_2930IntEnum_3cint64_3e_28Status_29"}
!443 = !{!444, !446}
!444 = distinct !{!444, !445, !"_ZN5pages8segments14at_segment_endB3v91B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!445 = distinct !{!445, !"_ZN5pages8segments14at_segment_endB3v91B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!446 = distinct !{!446, !447, !"_ZN5pages8segments11jump_statesB3v90B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!447 = distinct !{!447, !"_ZN5pages8segments11jump_statesB3v90B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!448 = !{!446}
!449 = !{!450, !452, !446}
!450 = distinct !{!450, !451, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!451 = distinct !{!451, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!452 = distinct !{!452, !451, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!453 = !{!454, !446}
!454 = distinct !{!454, !455, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!455 = distinct !{!455, !"_ZN5pages13solver_layout7prepareB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!456 = !{!457, !446}
!457 = distinct !{!457, !458, !"_ZN5pages8segments14at_segment_endB3v91B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!458 = distinct !{!458, !"_ZN5pages8segments14at_segment_endB3v91B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!459 = !{!460, !462, !446}
!460 = distinct !{!460, !461, !"_ZN5pages8segments11accept_jumpB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!461 = distinct !{!461, !"_ZN5pages8segments11accept_jumpB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!462 = distinct !{!462, !461, !"_ZN5pages8segments11accept_jumpB3v92B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!463 = !{!464, !460, !462, !446}
!464 = distinct !{!464, !465, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!465 = distinct !{!465, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!466 = !{!467, !469, !471, !460, !462, !446}
!467 = distinct !{!467, !468, !"_ZN5pages13solver_layout6decideB3v94B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_289_29: %retptr"}
!468 = distinct !{!468, !"_ZN5pages13solver_layout6decideB3v94B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_2923Literal_5bint_5d_289_29"}
!469 = distinct !{!469, !470, !"_ZN5pages8segments12stop_outsideB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29: %retptr"}
!470 = distinct !{!470, !"_ZN5pages8segments12stop_outsideB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29"}
!471 = distinct !{!471, !470, !"_ZN5pages8segments12stop_outsideB3v93B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x24Literal_5bint_5d_2817_29: %excinfo"}
!472 = !{!469, !471, !460, !462, !446}
!473 = !{!474, !469, !471, !460, !462, !446}
!474 = distinct !{!474, !475, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!475 = distinct !{!475, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!476 = !{!477, !479, !469, !471, !460, !462, !446}
!477 = distinct !{!477, !478, !"_ZN5pages13solver_layout13first_outsideB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %retptr"}
!478 = distinct !{!478, !"_ZN5pages13solver_layout13first_outsideB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29"}
!479 = distinct !{!479, !478, !"_ZN5pages13solver_layout13first_outsideB3v19B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_289_29: %excinfo"}
!480 = !{!481, !483}
!481 = distinct !{!481, !482, !"_ZN5pages12time_stepper12end_segmentsB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!482 = distinct !{!482, !"_ZN5pages12time_stepper12end_segmentsB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!483 = distinct !{!483, !482, !"_ZN5pages12time_stepper12end_segmentsB3v95B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!484 = !{!485, !481, !483}
!485 = distinct !{!485, !486, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29: %retptr"}
!486 = distinct !{!486, !"_ZN5pages13solver_layout4failB3v16B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x30IntEnum_3cint64_3e_28Status_29"}
!487 = !{!488, !490, !481, !483}
!488 = distinct !{!488, !489, !"_ZN5pages8segments13enter_segmentB3v96B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!489 = distinct !{!489, !"_ZN5pages8segments13enter_segmentB3v96B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!490 = distinct !{!490, !489, !"_ZN5pages8segments13enter_segmentB3v96B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!491 = !{!492, !494, !488, !490, !481, !483}
!492 = distinct !{!492, !493, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!493 = distinct !{!493, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!494 = distinct !{!494, !493, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!495 = !{!496, !481, !483}
!496 = distinct !{!496, !497, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!497 = distinct !{!497, !"_ZN5pages8segments8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!498 = !{!499, !501, !496, !481, !483}
!499 = distinct !{!499, !500, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %retptr"}
!500 = distinct !{!500, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx"}
!501 = distinct !{!501, !500, !"_ZN5pages8segments11set_segmentB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29xx: %excinfo"}
!502 = !{!503, !505, !496, !481, !483}
!503 = distinct !{!503, !504, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!504 = distinct !{!504, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!505 = distinct !{!505, !504, !"_ZN5pages8segments10clear_laneB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!506 = !{!507, !509, !481, !483}
!507 = distinct !{!507, !508, !"_ZN5pages8segments14note_next_stopB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!508 = distinct !{!508, !"_ZN5pages8segments14note_next_stopB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!509 = distinct !{!509, !508, !"_ZN5pages8segments14note_next_stopB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %excinfo"}
!510 = !{!511, !513}
!511 = distinct !{!511, !512, !"_ZN5pages12time_stepper11count_stepsB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!512 = distinct !{!512, !"_ZN5pages12time_stepper11count_stepsB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!513 = distinct !{!513, !512, !"_ZN5pages12time_stepper11count_stepsB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!514 = !{!515, !78, !80}
!515 = distinct !{!515, !516, !"_ZN5pages13solver_layout10derivativeB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_281_29: %retptr"}
!516 = distinct !{!516, !"_ZN5pages13solver_layout10derivativeB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_2923Literal_5bint_5d_281_29"}
!517 = !{!518, !520, !78, !80}
!518 = distinct !{!518, !519, !"_ZN5pages8implicit13factor_matrixB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!519 = distinct !{!519, !"_ZN5pages8implicit13factor_matrixB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!520 = distinct !{!520, !519, !"_ZN5pages8implicit13factor_matrixB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}
!521 = !{!522, !524, !525, !518, !520, !78, !80}
!522 = distinct !{!522, !523, !"_ZN5pages8implicit11set_changesB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!523 = distinct !{!523, !"_ZN5pages8implicit11set_changesB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE"}
!524 = distinct !{!524, !523, !"_ZN5pages8implicit11set_changesB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!525 = distinct !{!525, !526, !"_ZN5pages8implicit13differentiateB3v26B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!526 = distinct !{!526, !"_ZN5pages8implicit13differentiateB3v26B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!527 = !{!525, !518, !520, !78, !80}
!528 = !{!529, !531, !525, !518, !520, !78, !80}
!529 = distinct !{!529, !530, !"_ZN5pages8implicit16difference_ratesB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!530 = distinct !{!530, !"_ZN5pages8implicit16difference_ratesB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE"}
!531 = distinct !{!531, !530, !"_ZN5pages8implicit16difference_ratesB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!532 = !{!533, !529, !531, !525, !518, !520, !78, !80}
!533 = distinct !{!533, !534, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!534 = distinct !{!534, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!535 = !{!536, !518, !520, !78, !80}
!536 = distinct !{!536, !537, !"_ZN5pages8implicit6factorB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!537 = distinct !{!537, !"_ZN5pages8implicit6factorB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!538 = !{!539, !541, !542, !78, !80}
!539 = distinct !{!539, !540, !"_ZN5pages8implicit5solveB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!540 = distinct !{!540, !"_ZN5pages8implicit5solveB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!541 = distinct !{!541, !540, !"_ZN5pages8implicit5solveB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!542 = distinct !{!542, !543, !"_ZN5pages8implicit11solve_stageB3v35B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!543 = distinct !{!543, !"_ZN5pages8implicit11solve_stageB3v35B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!544 = !{!542, !78, !80}
!545 = !{!546, !78, !80}
!546 = distinct !{!546, !547, !"_ZN5pages13solver_layout7formulaB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_286_29: %retptr"}
!547 = distinct !{!547, !"_ZN5pages13solver_layout7formulaB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_286_29"}
!548 = !{!549, !78, !80}
!549 = distinct !{!549, !550, !"_ZN5pages13solver_layout7formulaB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x: %retptr"}
!550 = distinct !{!550, !"_ZN5pages13solver_layout7formulaB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29x"}
!551 = !{!552, !78, !80}
!552 = distinct !{!552, !553, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x: %retptr"}
!553 = distinct !{!553, !"_ZN5pages13solver_layout10derivativeB3v13B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_295ArrayIdLi1E1C7mutable7alignedE24Literal_5bint_5d_2817_29x"}
!554 = !{!555, !557}
!555 = distinct !{!555, !556, !"_ZN5pages12event_checks13first_crossedB3v60B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!556 = distinct !{!556, !"_ZN5pages12event_checks13first_crossedB3v60B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!557 = distinct !{!557, !556, !"_ZN5pages12event_checks13first_crossedB3v60B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!558 = !{!559, !561, !562, !564}
!559 = distinct !{!559, !560, !"_ZN5pages12event_checks13error_betweenB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!560 = distinct !{!560, !"_ZN5pages12event_checks13error_betweenB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!561 = distinct !{!561, !560, !"_ZN5pages12event_checks13error_betweenB3v52B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!562 = distinct !{!562, !563, !"_ZN5pages12event_checks8may_hideB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd: %retptr"}
!563 = distinct !{!563, !"_ZN5pages12event_checks8may_hideB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd"}
!564 = distinct !{!564, !563, !"_ZN5pages12event_checks8may_hideB3v64B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIdLi3E1C7mutable7alignedExxdd: %excinfo"}
!565 = !{!562, !564}
!566 = !{!567, !569, !562, !564}
!567 = distinct !{!567, !568, !"_ZN5pages12event_checks17least_distance_ofB3v65B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd: %retptr"}
!568 = distinct !{!568, !"_ZN5pages12event_checks17least_distance_ofB3v65B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd"}
!569 = distinct !{!569, !568, !"_ZN5pages12event_checks17least_distance_ofB3v65B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedExxxd: %excinfo"}
!570 = !{!571}
!571 = distinct !{!571, !572, !"_ZN5pages13solver_layout5retryB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d: %retptr"}
!572 = distinct !{!572, !"_ZN5pages13solver_layout5retryB3v66B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2923Literal_5bint_5d_280_29d"}
!573 = !{!574, !576}
!574 = distinct !{!574, !575, !"_ZN5pages12event_checks14least_distanceB3v62B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!575 = distinct !{!575, !"_ZN5pages12event_checks14least_distanceB3v62B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!576 = distinct !{!576, !575, !"_ZN5pages12event_checks14least_distanceB3v62B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!577 = !{!578, !580}
!578 = distinct !{!578, !579, !"_ZN5pages12event_checks14least_distanceB3v62B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %retptr"}
!579 = distinct !{!579, !"_ZN5pages12event_checks14least_distanceB3v62B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx"}
!580 = distinct !{!580, !579, !"_ZN5pages12event_checks14least_distanceB3v62B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi3E1C7mutable7alignedEx: %excinfo"}
!581 = !{!582, !584}
!582 = distinct !{!582, !583, !"_ZN5pages12event_checks13shortest_stepB3v63B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %retptr"}
!583 = distinct !{!583, !"_ZN5pages12event_checks13shortest_stepB3v63B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29"}
!584 = distinct !{!584, !583, !"_ZN5pages12event_checks13shortest_stepB3v63B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE1275Solver_28array_28int64_2c_201d_2c_20C_29_2c_20Shape_28int64_20x_2011_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Runs_28array_28float64_2c_202d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20Segments_28array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20Results_28array_28float64_2c_203d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_29_2c_20array_28float64_2c_202d_2c_20C_29_2c_20array_28int64_2c_202d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20Memory_28array_28float64_2c_201d_2c_20C_29_20x_205_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20array_28float64_2c_203d_2c_20C_29_2c_20Linear_28array_28float64_2c_201d_2c_20C_29_2c_20array_28float64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20UniTuple_28int64_20x_202_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_2c_20array_28int64_2c_201d_2c_20C_29_29_29: %excinfo"}

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
  %v466 = load i64, ptr %v465
  %v467 = getelementptr i64, ptr %v0, i64 232
  %v468 = load i64, ptr %v467
  %v469 = getelementptr i64, ptr %v0, i64 233
  %v470 = load ptr, ptr %v469
  %v471 = getelementptr i64, ptr %v0, i64 234
  %v472 = load ptr, ptr %v471
  %v473 = getelementptr i64, ptr %v0, i64 235
  %v474 = load i64, ptr %v473
  %v475 = getelementptr i64, ptr %v0, i64 236
  %v476 = load i64, ptr %v475
  %v477 = getelementptr i64, ptr %v0, i64 237
  %v478 = load ptr, ptr %v477
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
  %v554 = load i64, ptr %v553
  %v555 = getelementptr i64, ptr %v0, i64 276
  %v556 = load i64, ptr %v555
  %v557 = call i32 @advance_of_many(ptr %v1, ptr %v2, ptr %v4, ptr %v6, i64 %v8, i64 %v10, ptr %v12, i64 %v14, i64 %v16, i64 %v18, i64 %v20, i64 %v22, i64 %v24, i64 %v26, i64 %v28, i64 %v30, i64 %v32, i64 %v34, i64 %v36, i64 %v38, ptr %v40, ptr %v42, i64 %v44, i64 %v46, ptr %v48, i64 %v50, i64 %v52, ptr %v54, ptr %v56, i64 %v58, i64 %v60, ptr %v62, i64 %v64, i64 %v66, i64 %v68, i64 %v70, ptr %v72, ptr %v74, i64 %v76, i64 %v78, ptr %v80, i64 %v82, i64 %v84, i64 %v86, i64 %v88, ptr %v90, ptr %v92, i64 %v94, i64 %v96, ptr %v98, i64 %v100, i64 %v102, ptr %v104, ptr %v106, i64 %v108, i64 %v110, ptr %v112, i64 %v114, i64 %v116, ptr %v118, ptr %v120, i64 %v122, i64 %v124, ptr %v126, i64 %v128, i64 %v130, ptr %v132, ptr %v134, i64 %v136, i64 %v138, ptr %v140, i64 %v142, i64 %v144, ptr %v146, ptr %v148, i64 %v150, i64 %v152, ptr %v154, i64 %v156, i64 %v158, i64 %v160, i64 %v162, ptr %v164, ptr %v166, i64 %v168, i64 %v170, ptr %v172, i64 %v174, i64 %v176, ptr %v178, ptr %v180, i64 %v182, i64 %v184, ptr %v186, i64 %v188, i64 %v190, ptr %v192, ptr %v194, i64 %v196, i64 %v198, ptr %v200, i64 %v202, i64 %v204, i64 %v206, i64 %v208, i64 %v210, i64 %v212, ptr %v214, ptr %v216, i64 %v218, i64 %v220, ptr %v222, i64 %v224, i64 %v226, ptr %v228, ptr %v230, i64 %v232, i64 %v234, ptr %v236, i64 %v238, i64 %v240, ptr %v242, ptr %v244, i64 %v246, i64 %v248, ptr %v250, i64 %v252, i64 %v254, i64 %v256, i64 %v258, ptr %v260, ptr %v262, i64 %v264, i64 %v266, ptr %v268, i64 %v270, i64 %v272, i64 %v274, i64 %v276, ptr %v278, ptr %v280, i64 %v282, i64 %v284, ptr %v286, i64 %v288, i64 %v290, i64 %v292, i64 %v294, ptr %v296, ptr %v298, i64 %v300, i64 %v302, ptr %v304, i64 %v306, i64 %v308, ptr %v310, ptr %v312, i64 %v314, i64 %v316, ptr %v318, i64 %v320, i64 %v322, ptr %v324, ptr %v326, i64 %v328, i64 %v330, ptr %v332, i64 %v334, i64 %v336, ptr %v338, ptr %v340, i64 %v342, i64 %v344, ptr %v346, i64 %v348, i64 %v350, ptr %v352, ptr %v354, i64 %v356, i64 %v358, ptr %v360, i64 %v362, i64 %v364, ptr %v366, ptr %v368, i64 %v370, i64 %v372, ptr %v374, i64 %v376, i64 %v378, ptr %v380, ptr %v382, i64 %v384, i64 %v386, ptr %v388, i64 %v390, i64 %v392, i64 %v394, i64 %v396, i64 %v398, i64 %v400, ptr %v402, ptr %v404, i64 %v406, i64 %v408, ptr %v410, i64 %v412, i64 %v414, i64 %v416, i64 %v418, i64 %v420, i64 %v422, ptr %v424, ptr %v426, i64 %v428, i64 %v430, ptr %v432, i64 %v434, i64 %v436, ptr %v438, ptr %v440, i64 %v442, i64 %v444, ptr %v446, i64 %v448, i64 %v450, ptr %v452, ptr %v454, i64 %v456, i64 %v458, ptr %v460, i64 %v462, i64 %v464, i64 %v466, i64 %v468, ptr %v470, ptr %v472, i64 %v474, i64 %v476, ptr %v478, i64 %v480, i64 %v482, ptr %v484, ptr %v486, i64 %v488, i64 %v490, ptr %v492, i64 %v494, i64 %v496, ptr %v498, ptr %v500, i64 %v502, i64 %v504, ptr %v506, i64 %v508, i64 %v510, ptr %v512, ptr %v514, i64 %v516, i64 %v518, ptr %v520, i64 %v522, i64 %v524, ptr %v526, ptr %v528, i64 %v530, i64 %v532, ptr %v534, i64 %v536, i64 %v538, ptr %v540, ptr %v542, i64 %v544, i64 %v546, ptr %v548, i64 %v550, i64 %v552, i64 %v554, i64 %v556)
  %v558 = load i64, ptr %v1
  ret i64 %v558
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

; sha256 f21f1814cacd1e6d1cffa5ce0859203eb9be6a81a0ee6e0349d3eac5a6b12be0 31be26a722ff8d1d0c7ad7bd7fbf79633dbefac021431ebbc64dcf9e19acb011, Python 3.11, numba 0.68.1

; Function Attrs: nofree norecurse nosync nounwind memory(argmem: readwrite)
define dso_local noundef i32 @coefficients_of_many(ptr noalias %v0, ptr noalias readnone %v1, ptr readnone %v2, ptr readnone %v3, i64 %v4, i64 %v5, ptr %v6, i64 %v7, i64 %v8, i64 %v9, i64 %v10, i64 %v11, i64 %v12, ptr readnone %v13, ptr readnone %v14, i64 %v15, i64 %v16, ptr %v17, i64 %v18, i64 %v19, i64 %v20, i64 %v21, i64 %v22, i64 %v23, ptr readnone %v24, ptr readnone %v25, i64 %v26, i64 %v27, ptr readonly %v28, i64 %v29, i64 %v30, i64 %v31, i64 %v32, ptr readnone %v33, ptr readnone %v34, i64 %v35, i64 %v36, ptr readonly %v37, i64 %v38, i64 %v39, i64 %v40, i64 %v41, ptr readnone %v42, ptr readnone %v43, i64 %v44, i64 %v45, ptr readonly %v46, i64 %v47, i64 %v48, i64 %v49, i64 %v50, ptr readnone %v51, ptr readnone %v52, i64 %v53, i64 %v54, ptr readonly %v55, i64 %v56, i64 %v57, i64 %v58, i64 %v59, i64 %v60, i64 %v61, i64 %v62, i64 %v63) local_unnamed_addr {
v64:
  %v65 = sub i64 %v61, %v60
  %v66 = icmp ult i64 %v65, 9223372036854775807
  br i1 %v66, label %v67, label %v68

v67:
  %v69 = add i64 %v60, 1
  %v70 = icmp slt i64 %v47, 1
  %v71 = sub i64 %v63, %v62
  %v72 = tail call i64 @llvm.smax.i64(i64 %v71, i64 0)
  %v73 = icmp slt i64 %v71, 1
  %v74 = mul i64 %v9, %v8
  %v75 = mul i64 %v20, %v19
  %v76 = sub i64 %v59, %v58
  %v77 = tail call i64 @llvm.smax.i64(i64 %v76, i64 0)
  %v78 = mul i64 %v9, %v8
  %v79 = mul i64 %v20, %v19
  %v80 = mul i64 %v9, %v8
  %v81 = mul i64 %v20, %v19
  %v82 = mul i64 %v9, %v8
  %v83 = mul i64 %v20, %v19
  %v84 = icmp sgt i64 %v76, 0
  %v85 = zext i1 %v84 to i64
  %v86 = add i64 %v58, %v85
  %v87 = sext i1 %v84 to i64
  %v88 = add nsw i64 %v77, %v87
  %v89 = select i1 %v84, i64 %v58, i64 0
  %v90 = sub i64 %v63, %v62
  %v91 = tail call i64 @llvm.smax.i64(i64 %v90, i64 0)
  %v92 = icmp sgt i64 %v90, 0
  %v93 = zext i1 %v92 to i64
  %v94 = add i64 %v62, %v93
  %v95 = sext i1 %v92 to i64
  %v96 = add nsw i64 %v91, %v95
  %v97 = select i1 %v92, i64 %v62, i64 0
  %v98 = mul i64 %v9, %v8
  %v99 = mul i64 %v20, %v19
  %v100 = mul i64 %v9, %v8
  %v101 = mul i64 %v20, %v19
  %v102 = mul i64 %v9, %v8
  %v103 = mul i64 %v20, %v19
  %v104 = mul i64 %v9, %v8
  %v105 = mul i64 %v20, %v19
  br label %v106

v107:
  %v108 = icmp sgt i64 %v109, 0
  %v110 = sext i1 %v108 to i64
  %v111 = add nsw i64 %v109, %v110
  %v112 = zext i1 %v108 to i64
  %v113 = add i64 %v114, %v112
  %v115 = select i1 %v108, i64 %v114, i64 0
  br i1 %v108, label %v106, label %v68

v106:
  %v116 = phi i64 [ %v60, %v67 ], [ %v115, %v107 ]
  %v114 = phi i64 [ %v69, %v67 ], [ %v113, %v107 ]
  %v109 = phi i64 [ %v65, %v67 ], [ %v111, %v107 ]
  %v117 = icmp sgt i64 %v116, 0
  br i1 %v117, label %v118, label %v119

v118:
  br i1 %v70, label %v120, label %v121

v121:
  %v122 = add nsw i64 %v116, -1
  %v123 = mul i64 %v122, %v9
  %v124 = getelementptr double, ptr %v6, i64 %v123
  %v125 = uitofp i64 %v116 to double
  %v126 = mul i64 %v116, %v9
  %v127 = getelementptr double, ptr %v6, i64 %v126
  %v128 = mul i64 %v122, %v20
  %v129 = getelementptr double, ptr %v17, i64 %v128
  %v130 = mul i64 %v116, %v20
  %v131 = getelementptr double, ptr %v17, i64 %v130
  br label %v132

v133:
  %v134 = icmp eq i64 %v47, %v135
  br i1 %v134, label %v120, label %v132

v120:
  %v136 = icmp eq i64 %v116, %v61
  br i1 %v136, label %v68, label %v119

v119:
  br i1 %v84, label %v137, label %v107

v137:
  %v138 = icmp slt i64 %v116, 0
  %v139 = select i1 %v138, i64 %v8, i64 0
  %v140 = add i64 %v139, %v116
  %v141 = mul i64 %v140, %v9
  %v142 = getelementptr double, ptr %v6, i64 %v141
  %v143 = select i1 %v138, i64 %v19, i64 0
  %v144 = add i64 %v143, %v116
  %v145 = mul i64 %v144, %v20
  %v146 = getelementptr double, ptr %v17, i64 %v145
  %v147 = icmp slt i64 %v116, 0
  %v148 = select i1 %v147, i64 %v8, i64 0
  %v149 = add i64 %v148, %v116
  %v150 = mul i64 %v149, %v9
  %v151 = getelementptr double, ptr %v6, i64 %v150
  %v152 = select i1 %v147, i64 %v19, i64 0
  %v153 = add i64 %v152, %v116
  %v154 = mul i64 %v153, %v20
  %v155 = getelementptr double, ptr %v17, i64 %v154
  %v156 = icmp eq i64 %v116, 0
  %v157 = icmp sgt i64 %v116, 1
  %v158 = uitofp i64 %v116 to double
  %v159 = icmp slt i64 %v116, 0
  %v160 = select i1 %v159, i64 %v8, i64 0
  %v161 = add i64 %v160, %v116
  %v162 = mul i64 %v161, %v9
  %v163 = getelementptr double, ptr %v6, i64 %v162
  %v164 = select i1 %v159, i64 %v19, i64 0
  %v165 = add i64 %v164, %v116
  %v166 = mul i64 %v165, %v20
  %v167 = getelementptr double, ptr %v17, i64 %v166
  %v168 = icmp slt i64 %v116, 0
  %v169 = select i1 %v168, i64 %v8, i64 0
  %v170 = add i64 %v169, %v116
  %v171 = mul i64 %v170, %v9
  %v172 = getelementptr double, ptr %v6, i64 %v171
  %v173 = select i1 %v168, i64 %v19, i64 0
  %v174 = add i64 %v173, %v116
  %v175 = mul i64 %v174, %v20
  %v176 = getelementptr double, ptr %v17, i64 %v175
  %v177 = icmp eq i64 %v116, 0
  br label %v178

v178:
  %v179 = phi i64 [ %v89, %v137 ], [ %v180, %v181 ]
  %v182 = phi i64 [ %v88, %v137 ], [ %v183, %v181 ]
  %v184 = phi i64 [ %v86, %v137 ], [ %v185, %v181 ]
  %v186 = icmp slt i64 %v179, 0
  %v187 = select i1 %v186, i64 %v29, i64 0
  %v188 = add i64 %v187, %v179
  %v189 = mul i64 %v188, %v30
  %v190 = getelementptr i64, ptr %v28, i64 %v189
  %v191 = load i64, ptr %v190, align 8
  br i1 %v117, label %v192, label %v193

v192:
  %v194 = icmp slt i64 %v191, 0
  %v195 = select i1 %v194, i64 %v56, i64 0
  %v196 = getelementptr i64, ptr %v55, i64 %v191
  %v197 = getelementptr i64, ptr %v196, i64 %v195
  %v198 = load i64, ptr %v197, align 8
  %v199 = icmp eq i64 %v198, 1
  br i1 %v199, label %v181, label %v193

v193:
  %v200 = getelementptr i8, ptr %v190, i64 8
  %v201 = load i64, ptr %v200, align 8
  %v202 = getelementptr i8, ptr %v190, i64 16
  %v203 = load i64, ptr %v202, align 8
  %v204 = getelementptr i8, ptr %v190, i64 24
  %v205 = load i64, ptr %v204, align 8
  %v206 = getelementptr i8, ptr %v190, i64 32
  %v207 = load i64, ptr %v206, align 8
  %v208 = getelementptr i8, ptr %v190, i64 64
  %v209 = load i64, ptr %v208, align 8
  %v210 = getelementptr i8, ptr %v190, i64 40
  %v211 = load i64, ptr %v210, align 8
  %v212 = getelementptr i8, ptr %v190, i64 48
  %v213 = load i64, ptr %v212, align 8
  %v214 = sub nsw i64 %v116, %v213
  %v215 = icmp sgt i64 %v205, -1
  br i1 %v215, label %v216, label %v217

v216:
  %v218 = getelementptr i64, ptr %v55, i64 %v205
  %v219 = load i64, ptr %v218, align 8
  %v220 = icmp eq i64 %v219, 1
  %v221 = tail call i64 @llvm.smin.i64(i64 %v214, i64 0)
  %v222 = select i1 %v220, i64 %v221, i64 %v214
  %v223 = icmp slt i64 %v207, 0
  %v224 = select i1 %v223, i64 %v56, i64 0
  %v225 = getelementptr i64, ptr %v55, i64 %v207
  %v226 = getelementptr i64, ptr %v225, i64 %v224
  %v227 = load i64, ptr %v226, align 8
  %v228 = icmp eq i64 %v227, 1
  br i1 %v228, label %v229, label %v217

v229:
  %v230 = tail call i64 @llvm.smax.i64(i64 %v116, i64 %v211)
  br label %v217

v217:
  %v231 = phi i64 [ %v222, %v229 ], [ %v222, %v216 ], [ %v214, %v193 ]
  %v232 = phi i64 [ %v230, %v229 ], [ %v211, %v216 ], [ %v211, %v193 ]
  br i1 %v92, label %v233, label %v181

v233:
  %v234 = mul i64 %v83, %v205
  %v235 = mul i64 %v82, %v205
  %v236 = mul i64 %v81, %v203
  %v237 = mul i64 %v80, %v203
  %v238 = mul i64 %v79, %v201
  %v239 = mul i64 %v78, %v201
  %v240 = icmp sgt i64 %v201, -1
  %v241 = select i1 %v186, i64 %v38, i64 0
  %v242 = add i64 %v241, %v179
  %v243 = mul i64 %v242, %v39
  %v244 = getelementptr double, ptr %v37, i64 %v243
  %v245 = getelementptr double, ptr %v142, i64 %v239
  %v246 = getelementptr double, ptr %v146, i64 %v238
  %v247 = icmp sgt i64 %v203, -1
  %v248 = select i1 %v186, i64 %v38, i64 0
  %v249 = add i64 %v248, %v179
  %v250 = mul i64 %v249, %v39
  %v251 = getelementptr double, ptr %v37, i64 %v250
  %v252 = getelementptr i8, ptr %v251, i64 8
  %v253 = getelementptr double, ptr %v151, i64 %v237
  %v254 = getelementptr double, ptr %v155, i64 %v236
  %v255 = icmp eq i64 %v209, 1
  %v256 = and i1 %v255, %v156
  %v257 = and i1 %v117, %v255
  %v258 = mul i64 %v205, %v98
  %v259 = getelementptr double, ptr %v6, i64 %v258
  %v260 = mul i64 %v205, %v99
  %v261 = getelementptr double, ptr %v17, i64 %v260
  %v262 = icmp slt i64 %v207, 0
  %v263 = select i1 %v262, i64 %v7, i64 0
  %v264 = add i64 %v263, %v207
  %v265 = mul i64 %v264, %v98
  %v266 = getelementptr double, ptr %v6, i64 %v265
  %v267 = select i1 %v262, i64 %v18, i64 0
  %v268 = add i64 %v267, %v207
  %v269 = mul i64 %v268, %v99
  %v270 = getelementptr double, ptr %v17, i64 %v269
  %v271 = sitofp i64 %v209 to double
  %v272 = fadd double %v271, 1.000000e+00
  %v273 = select i1 %v186, i64 %v38, i64 0
  %v274 = add i64 %v273, %v179
  %v275 = mul i64 %v274, %v39
  %v276 = getelementptr double, ptr %v37, i64 %v275
  %v277 = getelementptr i8, ptr %v276, i64 16
  %v278 = icmp eq i64 %v205, %v207
  %v279 = and i1 %v278, %v156
  %v280 = icmp eq i64 %v209, 0
  %v281 = getelementptr double, ptr %v6, i64 %v235
  %v282 = getelementptr double, ptr %v17, i64 %v234
  %v283 = and i1 %v255, %v157
  %v284 = getelementptr i8, ptr %v190, i64 56
  %v285 = select i1 %v186, i64 %v38, i64 0
  %v286 = add i64 %v285, %v179
  %v287 = mul i64 %v286, %v39
  %v288 = getelementptr double, ptr %v37, i64 %v287
  %v289 = getelementptr i8, ptr %v288, i64 24
  %v290 = icmp slt i64 %v191, 0
  %v291 = select i1 %v290, i64 %v7, i64 0
  %v292 = add i64 %v291, %v191
  %v293 = mul i64 %v292, %v100
  %v294 = getelementptr double, ptr %v163, i64 %v293
  %v295 = select i1 %v290, i64 %v18, i64 0
  %v296 = add i64 %v295, %v191
  %v297 = mul i64 %v296, %v101
  %v298 = getelementptr double, ptr %v167, i64 %v297
  %v299 = icmp slt i64 %v191, 0
  %v300 = select i1 %v299, i64 %v7, i64 0
  %v301 = add i64 %v300, %v191
  %v302 = mul i64 %v104, %v301
  %v303 = getelementptr double, ptr %v172, i64 %v302
  %v304 = select i1 %v299, i64 %v18, i64 0
  %v305 = add i64 %v304, %v191
  %v306 = mul i64 %v105, %v305
  %v307 = getelementptr double, ptr %v176, i64 %v306
  %v308 = and i1 %v255, %v177
  br label %v309

v309:
  %v310 = phi i64 [ %v97, %v233 ], [ %v311, %v312 ]
  %v313 = phi i64 [ %v96, %v233 ], [ %v314, %v312 ]
  %v315 = phi i64 [ %v94, %v233 ], [ %v316, %v312 ]
  %v317 = phi i64 [ %v232, %v233 ], [ %v318, %v312 ]
  %v319 = phi i64 [ %v231, %v233 ], [ %v320, %v312 ]
  br i1 %v240, label %v321, label %v322

v321:
  %v323 = load double, ptr %v244, align 8
  %v324 = icmp slt i64 %v310, 0
  %v325 = select i1 %v324, i64 %v9, i64 0
  %v326 = getelementptr double, ptr %v245, i64 %v310
  %v327 = getelementptr double, ptr %v326, i64 %v325
  %v328 = load double, ptr %v327, align 8
  %v329 = fmul double %v323, %v328
  %v330 = select i1 %v324, i64 %v20, i64 0
  %v331 = getelementptr double, ptr %v246, i64 %v310
  %v332 = getelementptr double, ptr %v331, i64 %v330
  %v333 = load double, ptr %v332, align 8
  br label %v322

v322:
  %v334 = phi double [ %v329, %v321 ], [ 0.000000e+00, %v309 ]
  %v335 = phi double [ %v333, %v321 ], [ 0.000000e+00, %v309 ]
  br i1 %v247, label %v336, label %v337

v336:
  %v338 = load double, ptr %v252, align 8
  %v339 = icmp slt i64 %v310, 0
  %v340 = select i1 %v339, i64 %v9, i64 0
  %v341 = getelementptr double, ptr %v253, i64 %v310
  %v342 = getelementptr double, ptr %v341, i64 %v340
  %v343 = load double, ptr %v342, align 8
  %v344 = fmul double %v338, %v343
  %v345 = fadd double %v334, %v344
  %v346 = tail call double @llvm.fabs.f64(double %v338)
  %v347 = select i1 %v339, i64 %v20, i64 0
  %v348 = getelementptr double, ptr %v254, i64 %v310
  %v349 = getelementptr double, ptr %v348, i64 %v347
  %v350 = load double, ptr %v349, align 8
  %v351 = fmul double %v346, %v350
  %v352 = fadd double %v335, %v351
  %v353 = tail call double @llvm.fabs.f64(double %v344)
  %v354 = tail call double @llvm.fabs.f64(double %v345)
  %v355 = fadd double %v353, %v354
  br label %v337

v337:
  %v356 = phi double [ %v345, %v336 ], [ %v334, %v322 ]
  %v357 = phi double [ %v352, %v336 ], [ %v335, %v322 ]
  %v358 = phi double [ %v355, %v336 ], [ 0.000000e+00, %v322 ]
  %v320 = select i1 %v256, i64 0, i64 %v319
  %v318 = select i1 %v256, i64 0, i64 %v317
  br i1 %v215, label %v359, label %v360

v359:
  %v361 = add nsw i64 %v320, 1
  %v362 = sub i64 %v361, %v318
  %v363 = icmp slt i64 %v362, 1
  br i1 %v363, label %v364, label %v365

v365:
  %v366 = icmp sgt i64 %v310, 0
  %v367 = icmp slt i64 %v310, 0
  %v368 = select i1 %v367, i64 %v9, i64 0
  %v369 = select i1 %v367, i64 %v20, i64 0
  br label %v370

v371:
  %v372 = load double, ptr %v373, align 8
  %v374 = fmul double %v375, %v372
  %v376 = load double, ptr %v377, align 8
  %v378 = fmul double %v375, %v376
  %v379 = getelementptr double, ptr %v380, i64 %v310
  %v381 = getelementptr double, ptr %v379, i64 %v368
  %v382 = load double, ptr %v381, align 8
  %v383 = getelementptr double, ptr %v384, i64 %v310
  %v385 = getelementptr double, ptr %v383, i64 %v369
  %v386 = load double, ptr %v385, align 8
  %v387 = fmul double %v374, %v382
  %v388 = fadd double %v389, %v387
  %v390 = tail call double @llvm.fabs.f64(double %v374)
  %v391 = fmul double %v390, %v386
  %v392 = tail call double @llvm.fabs.f64(double %v382)
  %v393 = fadd double %v392, %v386
  %v394 = fmul double %v378, %v393
  %v395 = fadd double %v391, %v394
  %v396 = fadd double %v397, %v395
  %v398 = tail call double @llvm.fabs.f64(double %v387)
  %v399 = fmul double %v272, %v398
  %v400 = fadd double %v401, %v399
  %v402 = tail call double @llvm.fabs.f64(double %v388)
  %v403 = fadd double %v402, %v400
  br label %v404

v364:
  %v405 = phi double [ %v357, %v359 ], [ %v406, %v407 ]
  %v408 = phi double [ %v358, %v359 ], [ %v409, %v407 ]
  %v410 = phi double [ 0.000000e+00, %v359 ], [ %v411, %v407 ]
  %v412 = load double, ptr %v277, align 8
  %v413 = fmul double %v410, %v412
  %v414 = fadd double %v356, %v413
  %v415 = tail call double @llvm.fabs.f64(double %v414)
  %v416 = fadd double %v408, %v415
  %v417 = icmp eq i64 %v310, 0
  %v418 = select i1 %v279, i1 %v417, i1 false
  %v419 = icmp eq i64 %v320, 0
  %v420 = select i1 %v418, i1 %v419, i1 false
  %v421 = select i1 %v420, i1 %v280, i1 false
  br i1 %v421, label %v422, label %v360

v422:
  %v423 = load double, ptr %v281, align 8
  %v424 = tail call double @llvm.fabs.f64(double %v423)
  %v425 = load double, ptr %v282, align 8
  %v426 = fcmp olt double %v424, %v425
  br i1 %v426, label %v427, label %v428

v427:
  %v429 = fadd double %v424, %v425
  %v430 = fmul double %v429, 5.000000e-01
  %v431 = fmul double %v429, %v430
  %v432 = fmul double %v431, 4.000000e+00
  br label %v360

v428:
  %v433 = fmul double %v423, %v423
  %v434 = fmul double %v425, %v425
  %v435 = fadd double %v433, %v434
  %v436 = fmul double %v424, 2.000000e+00
  %v437 = fmul double %v425, %v436
  %v438 = fmul double %v435, 3.000000e+00
  br label %v360

v360:
  %v439 = phi double [ %v431, %v427 ], [ %v435, %v428 ], [ %v414, %v364 ], [ %v356, %v337 ]
  %v440 = phi double [ %v431, %v427 ], [ %v437, %v428 ], [ %v405, %v364 ], [ %v357, %v337 ]
  %v441 = phi double [ %v432, %v427 ], [ %v438, %v428 ], [ %v416, %v364 ], [ %v358, %v337 ]
  br i1 %v283, label %v442, label %v443

v442:
  %v444 = fdiv double %v439, %v158
  %v445 = fdiv double %v440, %v158
  %v446 = fdiv double %v441, %v158
  %v447 = tail call double @llvm.fabs.f64(double %v444)
  %v448 = fadd double %v447, %v446
  br label %v443

v443:
  %v449 = phi double [ %v444, %v442 ], [ %v439, %v360 ]
  %v450 = phi double [ %v445, %v442 ], [ %v440, %v360 ]
  %v451 = phi double [ %v448, %v442 ], [ %v441, %v360 ]
  %v452 = load i64, ptr %v284, align 8
  %v453 = icmp sgt i64 %v452, -1
  br i1 %v453, label %v454, label %v312

v454:
  %v455 = load double, ptr %v289, align 8
  %v456 = icmp slt i64 %v310, 1
  %v457 = icmp eq i64 %v452, %v191
  %v458 = select i1 %v156, i1 %v457, i1 false
  %v459 = select i1 %v456, i1 true, i1 %v458
  br i1 %v459, label %v460, label %v461

v461:
  %v462 = load double, ptr %v294, align 8
  %v463 = load double, ptr %v298, align 8
  %v464 = mul i64 %v452, %v100
  %v465 = getelementptr double, ptr %v6, i64 %v464
  %v466 = getelementptr double, ptr %v465, i64 %v310
  %v467 = load double, ptr %v466, align 8
  %v468 = fmul double %v455, %v467
  %v469 = mul i64 %v452, %v101
  %v470 = getelementptr double, ptr %v17, i64 %v469
  %v471 = getelementptr double, ptr %v470, i64 %v310
  %v472 = load double, ptr %v471, align 8
  %v473 = fmul double %v455, %v472
  %v474 = fmul double %v462, %v468
  %v475 = fsub double %v449, %v474
  %v476 = tail call double @llvm.fabs.f64(double %v462)
  %v477 = fmul double %v476, %v473
  %v478 = tail call double @llvm.fabs.f64(double %v468)
  %v479 = fadd double %v478, %v473
  %v480 = fmul double %v463, %v479
  %v481 = fadd double %v477, %v480
  %v482 = fadd double %v450, %v481
  %v483 = tail call double @llvm.fabs.f64(double %v474)
  %v484 = fadd double %v451, %v483
  %v485 = tail call double @llvm.fabs.f64(double %v475)
  %v486 = fadd double %v484, %v485
  br label %v460

v460:
  %v487 = phi double [ %v449, %v454 ], [ %v475, %v461 ]
  %v488 = phi double [ %v450, %v454 ], [ %v482, %v461 ]
  %v489 = phi double [ %v451, %v454 ], [ %v486, %v461 ]
  %v490 = mul i64 %v102, %v452
  %v491 = getelementptr double, ptr %v6, i64 %v490
  %v492 = load double, ptr %v491, align 8
  %v493 = fmul double %v455, %v492
  %v494 = mul i64 %v103, %v452
  %v495 = getelementptr double, ptr %v17, i64 %v494
  %v496 = load double, ptr %v495, align 8
  %v497 = fmul double %v455, %v496
  %v498 = fdiv double %v487, %v493
  %v499 = tail call double @llvm.fabs.f64(double %v493)
  %v500 = fsub double %v499, %v497
  %v501 = fcmp ogt double %v500, 0.000000e+00
  br i1 %v501, label %v502, label %v503

v502:
  %v504 = fmul double %v489, 0x3CA0000000000000
  %v505 = fadd double %v488, %v504
  %v506 = fadd double %v505, 0x20B0000000000000
  %v507 = tail call double @llvm.fabs.f64(double %v498)
  %v508 = fmul double %v497, %v507
  %v509 = fadd double %v506, %v508
  %v510 = fdiv double %v509, %v500
  br label %v503

v503:
  %v511 = phi double [ %v510, %v502 ], [ 0x7FF0000000000000, %v460 ]
  %v512 = tail call double @llvm.fabs.f64(double %v498)
  br label %v312

v312:
  %v513 = phi double [ %v498, %v503 ], [ %v449, %v443 ]
  %v514 = phi double [ %v511, %v503 ], [ %v450, %v443 ]
  %v515 = phi double [ %v512, %v503 ], [ %v451, %v443 ]
  %v516 = icmp slt i64 %v310, 0
  %v517 = select i1 %v516, i64 %v9, i64 0
  %v518 = getelementptr double, ptr %v303, i64 %v310
  %v519 = getelementptr double, ptr %v518, i64 %v517
  store double %v513, ptr %v519, align 8
  %v520 = fmul double %v515, 0x3CA0000000000000
  %v521 = fadd double %v514, %v520
  %v522 = fmul double %v521, 0x3FF0000000000200
  %v523 = fadd double %v522, 0x20B0000000000000
  %v524 = select i1 %v516, i64 %v20, i64 0
  %v525 = getelementptr double, ptr %v307, i64 %v310
  %v526 = getelementptr double, ptr %v525, i64 %v524
  store double %v523, ptr %v526, align 8
  %v527 = icmp sgt i64 %v313, 0
  %v528 = zext i1 %v527 to i64
  %v316 = add i64 %v315, %v528
  %v529 = sext i1 %v527 to i64
  %v314 = add nsw i64 %v313, %v529
  %v311 = select i1 %v527, i64 %v315, i64 0
  br i1 %v527, label %v309, label %v181

v68:
  store i64 0, ptr %v0, align 8
  ret i32 0

v404:
  %v530 = phi double [ %v397, %v370 ], [ %v396, %v371 ]
  %v531 = phi double [ %v401, %v370 ], [ %v403, %v371 ]
  %v532 = phi double [ %v389, %v370 ], [ %v388, %v371 ]
  br i1 %v366, label %v533, label %v407

v533:
  %v534 = getelementptr double, ptr %v373, i64 %v310
  %v535 = load double, ptr %v534, align 8
  %v536 = fmul double %v375, %v535
  %v537 = getelementptr double, ptr %v377, i64 %v310
  %v538 = load double, ptr %v537, align 8
  %v539 = fmul double %v375, %v538
  %v540 = load double, ptr %v380, align 8
  %v541 = load double, ptr %v384, align 8
  %v542 = fmul double %v536, %v540
  %v543 = fadd double %v532, %v542
  %v544 = tail call double @llvm.fabs.f64(double %v536)
  %v545 = fmul double %v544, %v541
  %v546 = tail call double @llvm.fabs.f64(double %v540)
  %v547 = fadd double %v546, %v541
  %v548 = fmul double %v539, %v547
  %v549 = fadd double %v545, %v548
  %v550 = fadd double %v530, %v549
  %v551 = tail call double @llvm.fabs.f64(double %v542)
  %v552 = fmul double %v272, %v551
  %v553 = fadd double %v531, %v552
  %v554 = tail call double @llvm.fabs.f64(double %v543)
  %v555 = fadd double %v554, %v553
  br label %v407

v407:
  %v406 = phi double [ %v530, %v404 ], [ %v550, %v533 ]
  %v409 = phi double [ %v531, %v404 ], [ %v555, %v533 ]
  %v411 = phi double [ %v532, %v404 ], [ %v543, %v533 ]
  %v556 = add nsw i64 %v557, -1
  %v558 = add i64 %v559, 1
  %v560 = icmp sgt i64 %v557, 1
  br i1 %v560, label %v370, label %v364

v181:
  %v561 = icmp sgt i64 %v182, 0
  %v562 = zext i1 %v561 to i64
  %v185 = add i64 %v184, %v562
  %v563 = sext i1 %v561 to i64
  %v183 = add nsw i64 %v182, %v563
  %v180 = select i1 %v561, i64 %v184, i64 0
  br i1 %v561, label %v178, label %v107

v132:
  %v564 = phi i64 [ 0, %v121 ], [ %v135, %v133 ]
  %v135 = add nsw i64 %v564, 1
  br i1 %v73, label %v133, label %v565

v565:
  %v566 = mul i64 %v564, %v48
  %v567 = getelementptr i64, ptr %v46, i64 %v566
  %v568 = getelementptr i8, ptr %v567, i64 8
  %v569 = load i64, ptr %v568, align 8
  %v570 = load i64, ptr %v567, align 8
  %v571 = icmp slt i64 %v569, 0
  %v572 = select i1 %v571, i64 %v7, i64 0
  %v573 = add i64 %v572, %v569
  %v574 = mul i64 %v573, %v74
  %v575 = getelementptr double, ptr %v124, i64 %v574
  %v576 = icmp slt i64 %v570, 0
  %v577 = select i1 %v576, i64 %v7, i64 0
  %v578 = add i64 %v577, %v570
  %v579 = mul i64 %v578, %v74
  %v580 = getelementptr double, ptr %v127, i64 %v579
  %v581 = select i1 %v571, i64 %v18, i64 0
  %v582 = add i64 %v581, %v569
  %v583 = mul i64 %v582, %v75
  %v584 = getelementptr double, ptr %v129, i64 %v583
  %v585 = select i1 %v576, i64 %v18, i64 0
  %v586 = add i64 %v585, %v570
  %v587 = mul i64 %v586, %v75
  %v588 = getelementptr double, ptr %v131, i64 %v587
  br label %v589

v589:
  %v590 = phi i64 [ %v72, %v565 ], [ %v591, %v589 ]
  %v592 = phi i64 [ %v62, %v565 ], [ %v593, %v589 ]
  %v591 = add nsw i64 %v590, -1
  %v593 = add i64 %v592, 1
  %v594 = icmp slt i64 %v592, 0
  %v595 = select i1 %v594, i64 %v9, i64 0
  %v596 = add i64 %v595, %v592
  %v597 = getelementptr double, ptr %v575, i64 %v596
  %v598 = load double, ptr %v597, align 8
  %v599 = fdiv double %v598, %v125
  %v600 = getelementptr double, ptr %v580, i64 %v596
  store double %v599, ptr %v600, align 8
  %v601 = select i1 %v594, i64 %v20, i64 0
  %v602 = add i64 %v601, %v592
  %v603 = getelementptr double, ptr %v584, i64 %v602
  %v604 = load double, ptr %v603, align 8
  %v605 = fdiv double %v604, %v125
  %v606 = tail call double @llvm.fabs.f64(double %v599)
  %v607 = fmul double %v606, 0x3CA0000000000000
  %v608 = fadd double %v605, %v607
  %v609 = fmul double %v608, 0x3FF0000000000200
  %v610 = fadd double %v609, 0x20B0000000000000
  %v611 = getelementptr double, ptr %v588, i64 %v602
  store double %v610, ptr %v611, align 8
  %v612 = icmp sgt i64 %v590, 1
  br i1 %v612, label %v589, label %v133

v370:
  %v389 = phi double [ 0.000000e+00, %v365 ], [ %v411, %v407 ]
  %v401 = phi double [ %v358, %v365 ], [ %v409, %v407 ]
  %v397 = phi double [ %v357, %v365 ], [ %v406, %v407 ]
  %v557 = phi i64 [ %v362, %v365 ], [ %v556, %v407 ]
  %v559 = phi i64 [ %v318, %v365 ], [ %v558, %v407 ]
  %v613 = sitofp i64 %v559 to double
  %v375 = select i1 %v257, double %v613, double 1.000000e+00
  %v614 = icmp slt i64 %v559, 0
  %v615 = select i1 %v614, i64 %v8, i64 0
  %v616 = add i64 %v615, %v559
  %v617 = mul i64 %v616, %v9
  %v373 = getelementptr double, ptr %v259, i64 %v617
  %v618 = select i1 %v614, i64 %v19, i64 0
  %v619 = add i64 %v618, %v559
  %v620 = mul i64 %v619, %v20
  %v377 = getelementptr double, ptr %v261, i64 %v620
  %v621 = sub nsw i64 %v116, %v559
  %v622 = icmp slt i64 %v621, 0
  %v623 = select i1 %v622, i64 %v8, i64 0
  %v624 = add i64 %v623, %v621
  %v625 = mul i64 %v624, %v9
  %v380 = getelementptr double, ptr %v266, i64 %v625
  %v626 = select i1 %v622, i64 %v19, i64 0
  %v627 = add i64 %v626, %v621
  %v628 = mul i64 %v627, %v20
  %v384 = getelementptr double, ptr %v270, i64 %v628
  br i1 %v308, label %v404, label %v371
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64)


define i64 @coefficients(ptr %v0) {
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
  %v40 = load i64, ptr %v39
  %v41 = getelementptr i64, ptr %v0, i64 19
  %v42 = load i64, ptr %v41
  %v43 = getelementptr i64, ptr %v0, i64 20
  %v44 = load i64, ptr %v43
  %v45 = getelementptr i64, ptr %v0, i64 21
  %v46 = load i64, ptr %v45
  %v47 = getelementptr i64, ptr %v0, i64 22
  %v48 = load ptr, ptr %v47
  %v49 = getelementptr i64, ptr %v0, i64 23
  %v50 = load ptr, ptr %v49
  %v51 = getelementptr i64, ptr %v0, i64 24
  %v52 = load i64, ptr %v51
  %v53 = getelementptr i64, ptr %v0, i64 25
  %v54 = load i64, ptr %v53
  %v55 = getelementptr i64, ptr %v0, i64 26
  %v56 = load ptr, ptr %v55
  %v57 = getelementptr i64, ptr %v0, i64 27
  %v58 = load i64, ptr %v57
  %v59 = getelementptr i64, ptr %v0, i64 28
  %v60 = load i64, ptr %v59
  %v61 = getelementptr i64, ptr %v0, i64 29
  %v62 = load i64, ptr %v61
  %v63 = getelementptr i64, ptr %v0, i64 30
  %v64 = load i64, ptr %v63
  %v65 = getelementptr i64, ptr %v0, i64 31
  %v66 = load ptr, ptr %v65
  %v67 = getelementptr i64, ptr %v0, i64 32
  %v68 = load ptr, ptr %v67
  %v69 = getelementptr i64, ptr %v0, i64 33
  %v70 = load i64, ptr %v69
  %v71 = getelementptr i64, ptr %v0, i64 34
  %v72 = load i64, ptr %v71
  %v73 = getelementptr i64, ptr %v0, i64 35
  %v74 = load ptr, ptr %v73
  %v75 = getelementptr i64, ptr %v0, i64 36
  %v76 = load i64, ptr %v75
  %v77 = getelementptr i64, ptr %v0, i64 37
  %v78 = load i64, ptr %v77
  %v79 = getelementptr i64, ptr %v0, i64 38
  %v80 = load i64, ptr %v79
  %v81 = getelementptr i64, ptr %v0, i64 39
  %v82 = load i64, ptr %v81
  %v83 = getelementptr i64, ptr %v0, i64 40
  %v84 = load ptr, ptr %v83
  %v85 = getelementptr i64, ptr %v0, i64 41
  %v86 = load ptr, ptr %v85
  %v87 = getelementptr i64, ptr %v0, i64 42
  %v88 = load i64, ptr %v87
  %v89 = getelementptr i64, ptr %v0, i64 43
  %v90 = load i64, ptr %v89
  %v91 = getelementptr i64, ptr %v0, i64 44
  %v92 = load ptr, ptr %v91
  %v93 = getelementptr i64, ptr %v0, i64 45
  %v94 = load i64, ptr %v93
  %v95 = getelementptr i64, ptr %v0, i64 46
  %v96 = load i64, ptr %v95
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
  %v116 = load i64, ptr %v115
  %v117 = getelementptr i64, ptr %v0, i64 57
  %v118 = load i64, ptr %v117
  %v119 = getelementptr i64, ptr %v0, i64 58
  %v120 = load i64, ptr %v119
  %v121 = getelementptr i64, ptr %v0, i64 59
  %v122 = load i64, ptr %v121
  %v123 = getelementptr i64, ptr %v0, i64 60
  %v124 = load i64, ptr %v123
  %v125 = getelementptr i64, ptr %v0, i64 61
  %v126 = load i64, ptr %v125
  %v127 = call i32 @coefficients_of_many(ptr %v1, ptr %v2, ptr %v4, ptr %v6, i64 %v8, i64 %v10, ptr %v12, i64 %v14, i64 %v16, i64 %v18, i64 %v20, i64 %v22, i64 %v24, ptr %v26, ptr %v28, i64 %v30, i64 %v32, ptr %v34, i64 %v36, i64 %v38, i64 %v40, i64 %v42, i64 %v44, i64 %v46, ptr %v48, ptr %v50, i64 %v52, i64 %v54, ptr %v56, i64 %v58, i64 %v60, i64 %v62, i64 %v64, ptr %v66, ptr %v68, i64 %v70, i64 %v72, ptr %v74, i64 %v76, i64 %v78, i64 %v80, i64 %v82, ptr %v84, ptr %v86, i64 %v88, i64 %v90, ptr %v92, i64 %v94, i64 %v96, i64 %v98, i64 %v100, ptr %v102, ptr %v104, i64 %v106, i64 %v108, ptr %v110, i64 %v112, i64 %v114, i64 %v116, i64 %v118, i64 %v120, i64 %v122, i64 %v124, i64 %v126)
  %v128 = load i64, ptr %v1
  ret i64 %v128
}

; sha256 1c93631cc5a7996cd7084a167317109c093fc7c6aee71ef20811975f46d1c240 7571a52ba09cc5026d3e18cc69b9ae0a774dc7986e890ff5818e4fea5b16257c, Python 3.11, numba 0.68.1

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
  %v330 = tail call double @llvm.fabs.f64(double %v323)
  %v331 = select i1 %v324, i64 %v20, i64 0
  %v332 = getelementptr double, ptr %v246, i64 %v310
  %v333 = getelementptr double, ptr %v332, i64 %v331
  %v334 = load double, ptr %v333, align 8
  %v335 = fmul double %v330, %v334
  %v336 = fcmp une double %v330, 1.000000e+00
  %v337 = tail call double @llvm.fabs.f64(double %v329)
  %v338 = select i1 %v336, double %v337, double 0.000000e+00
  br label %v322

v322:
  %v339 = phi double [ %v329, %v321 ], [ 0.000000e+00, %v309 ]
  %v340 = phi double [ %v335, %v321 ], [ 0.000000e+00, %v309 ]
  %v341 = phi double [ %v338, %v321 ], [ 0.000000e+00, %v309 ]
  br i1 %v247, label %v342, label %v343

v342:
  %v344 = load double, ptr %v252, align 8
  %v345 = icmp slt i64 %v310, 0
  %v346 = select i1 %v345, i64 %v9, i64 0
  %v347 = getelementptr double, ptr %v253, i64 %v310
  %v348 = getelementptr double, ptr %v347, i64 %v346
  %v349 = load double, ptr %v348, align 8
  %v350 = fmul double %v344, %v349
  %v351 = fadd double %v339, %v350
  %v352 = tail call double @llvm.fabs.f64(double %v344)
  %v353 = select i1 %v345, i64 %v20, i64 0
  %v354 = getelementptr double, ptr %v254, i64 %v310
  %v355 = getelementptr double, ptr %v354, i64 %v353
  %v356 = load double, ptr %v355, align 8
  %v357 = fmul double %v352, %v356
  %v358 = fadd double %v340, %v357
  %v359 = tail call double @llvm.fabs.f64(double %v350)
  %v360 = fadd double %v341, %v359
  %v361 = tail call double @llvm.fabs.f64(double %v351)
  %v362 = fadd double %v360, %v361
  br label %v343

v343:
  %v363 = phi double [ %v351, %v342 ], [ %v339, %v322 ]
  %v364 = phi double [ %v358, %v342 ], [ %v340, %v322 ]
  %v365 = phi double [ %v362, %v342 ], [ %v341, %v322 ]
  %v320 = select i1 %v256, i64 0, i64 %v319
  %v318 = select i1 %v256, i64 0, i64 %v317
  br i1 %v215, label %v366, label %v367

v366:
  %v368 = add nsw i64 %v320, 1
  %v369 = sub i64 %v368, %v318
  %v370 = icmp slt i64 %v369, 1
  br i1 %v370, label %v371, label %v372

v372:
  %v373 = icmp sgt i64 %v310, 0
  %v374 = icmp slt i64 %v310, 0
  %v375 = select i1 %v374, i64 %v9, i64 0
  %v376 = select i1 %v374, i64 %v20, i64 0
  br label %v377

v378:
  %v379 = load double, ptr %v380, align 8
  %v381 = fmul double %v382, %v379
  %v383 = load double, ptr %v384, align 8
  %v385 = fmul double %v382, %v383
  %v386 = getelementptr double, ptr %v387, i64 %v310
  %v388 = getelementptr double, ptr %v386, i64 %v375
  %v389 = load double, ptr %v388, align 8
  %v390 = getelementptr double, ptr %v391, i64 %v310
  %v392 = getelementptr double, ptr %v390, i64 %v376
  %v393 = load double, ptr %v392, align 8
  %v394 = fmul double %v381, %v389
  %v395 = fadd double %v396, %v394
  %v397 = tail call double @llvm.fabs.f64(double %v381)
  %v398 = fmul double %v397, %v393
  %v399 = tail call double @llvm.fabs.f64(double %v389)
  %v400 = fadd double %v399, %v393
  %v401 = fmul double %v385, %v400
  %v402 = fadd double %v398, %v401
  %v403 = fadd double %v404, %v402
  %v405 = tail call double @llvm.fabs.f64(double %v394)
  %v406 = fmul double %v272, %v405
  %v407 = fadd double %v408, %v406
  %v409 = tail call double @llvm.fabs.f64(double %v395)
  %v410 = fadd double %v409, %v407
  br label %v411

v371:
  %v412 = phi double [ %v364, %v366 ], [ %v413, %v414 ]
  %v415 = phi double [ %v365, %v366 ], [ %v416, %v414 ]
  %v417 = phi double [ 0.000000e+00, %v366 ], [ %v418, %v414 ]
  %v419 = load double, ptr %v277, align 8
  %v420 = fmul double %v417, %v419
  %v421 = fadd double %v363, %v420
  %v422 = tail call double @llvm.fabs.f64(double %v421)
  %v423 = fadd double %v415, %v422
  %v424 = icmp eq i64 %v310, 0
  %v425 = select i1 %v279, i1 %v424, i1 false
  %v426 = icmp eq i64 %v320, 0
  %v427 = select i1 %v425, i1 %v426, i1 false
  %v428 = select i1 %v427, i1 %v280, i1 false
  br i1 %v428, label %v429, label %v367

v429:
  %v430 = load double, ptr %v281, align 8
  %v431 = tail call double @llvm.fabs.f64(double %v430)
  %v432 = load double, ptr %v282, align 8
  %v433 = fcmp olt double %v431, %v432
  br i1 %v433, label %v434, label %v435

v434:
  %v436 = fadd double %v431, %v432
  %v437 = fmul double %v436, 5.000000e-01
  %v438 = fmul double %v436, %v437
  %v439 = fmul double %v438, 4.000000e+00
  br label %v367

v435:
  %v440 = fmul double %v430, %v430
  %v441 = fmul double %v432, %v432
  %v442 = fadd double %v440, %v441
  %v443 = fmul double %v431, 2.000000e+00
  %v444 = fmul double %v432, %v443
  %v445 = fmul double %v442, 3.000000e+00
  br label %v367

v367:
  %v446 = phi double [ %v438, %v434 ], [ %v442, %v435 ], [ %v421, %v371 ], [ %v363, %v343 ]
  %v447 = phi double [ %v438, %v434 ], [ %v444, %v435 ], [ %v412, %v371 ], [ %v364, %v343 ]
  %v448 = phi double [ %v439, %v434 ], [ %v445, %v435 ], [ %v423, %v371 ], [ %v365, %v343 ]
  br i1 %v283, label %v449, label %v450

v449:
  %v451 = fdiv double %v446, %v158
  %v452 = fdiv double %v447, %v158
  %v453 = fdiv double %v448, %v158
  %v454 = tail call double @llvm.fabs.f64(double %v451)
  %v455 = fadd double %v454, %v453
  br label %v450

v450:
  %v456 = phi double [ %v451, %v449 ], [ %v446, %v367 ]
  %v457 = phi double [ %v452, %v449 ], [ %v447, %v367 ]
  %v458 = phi double [ %v455, %v449 ], [ %v448, %v367 ]
  %v459 = load i64, ptr %v284, align 8
  %v460 = icmp sgt i64 %v459, -1
  br i1 %v460, label %v461, label %v312

v461:
  %v462 = load double, ptr %v289, align 8
  %v463 = icmp slt i64 %v310, 1
  %v464 = icmp eq i64 %v459, %v191
  %v465 = select i1 %v156, i1 %v464, i1 false
  %v466 = select i1 %v463, i1 true, i1 %v465
  br i1 %v466, label %v467, label %v468

v468:
  %v469 = load double, ptr %v294, align 8
  %v470 = load double, ptr %v298, align 8
  %v471 = mul i64 %v459, %v100
  %v472 = getelementptr double, ptr %v6, i64 %v471
  %v473 = getelementptr double, ptr %v472, i64 %v310
  %v474 = load double, ptr %v473, align 8
  %v475 = fmul double %v462, %v474
  %v476 = mul i64 %v459, %v101
  %v477 = getelementptr double, ptr %v17, i64 %v476
  %v478 = getelementptr double, ptr %v477, i64 %v310
  %v479 = load double, ptr %v478, align 8
  %v480 = fmul double %v462, %v479
  %v481 = fmul double %v469, %v475
  %v482 = fsub double %v456, %v481
  %v483 = tail call double @llvm.fabs.f64(double %v469)
  %v484 = fmul double %v483, %v480
  %v485 = tail call double @llvm.fabs.f64(double %v475)
  %v486 = fadd double %v485, %v480
  %v487 = fmul double %v470, %v486
  %v488 = fadd double %v484, %v487
  %v489 = fadd double %v457, %v488
  %v490 = tail call double @llvm.fabs.f64(double %v481)
  %v491 = fadd double %v458, %v490
  %v492 = tail call double @llvm.fabs.f64(double %v482)
  %v493 = fadd double %v491, %v492
  br label %v467

v467:
  %v494 = phi double [ %v456, %v461 ], [ %v482, %v468 ]
  %v495 = phi double [ %v457, %v461 ], [ %v489, %v468 ]
  %v496 = phi double [ %v458, %v461 ], [ %v493, %v468 ]
  %v497 = mul i64 %v102, %v459
  %v498 = getelementptr double, ptr %v6, i64 %v497
  %v499 = load double, ptr %v498, align 8
  %v500 = fmul double %v462, %v499
  %v501 = mul i64 %v103, %v459
  %v502 = getelementptr double, ptr %v17, i64 %v501
  %v503 = load double, ptr %v502, align 8
  %v504 = fmul double %v462, %v503
  %v505 = fdiv double %v494, %v500
  %v506 = tail call double @llvm.fabs.f64(double %v500)
  %v507 = fsub double %v506, %v504
  %v508 = fcmp ogt double %v507, 0.000000e+00
  br i1 %v508, label %v509, label %v510

v509:
  %v511 = fmul double %v496, 0x3CA0000000000000
  %v512 = fadd double %v495, %v511
  %v513 = fadd double %v512, 0x20B0000000000000
  %v514 = tail call double @llvm.fabs.f64(double %v505)
  %v515 = fmul double %v504, %v514
  %v516 = fadd double %v513, %v515
  %v517 = fdiv double %v516, %v507
  br label %v510

v510:
  %v518 = phi double [ %v517, %v509 ], [ 0x7FF0000000000000, %v467 ]
  %v519 = tail call double @llvm.fabs.f64(double %v505)
  br label %v312

v312:
  %v520 = phi double [ %v505, %v510 ], [ %v456, %v450 ]
  %v521 = phi double [ %v518, %v510 ], [ %v457, %v450 ]
  %v522 = phi double [ %v519, %v510 ], [ %v458, %v450 ]
  %v523 = icmp slt i64 %v310, 0
  %v524 = select i1 %v523, i64 %v9, i64 0
  %v525 = getelementptr double, ptr %v303, i64 %v310
  %v526 = getelementptr double, ptr %v525, i64 %v524
  store double %v520, ptr %v526, align 8
  %v527 = fmul double %v522, 0x3CA0000000000000
  %v528 = fadd double %v521, %v527
  %v529 = fmul double %v528, 0x3FF0000000000200
  %v530 = fadd double %v529, 0x20B0000000000000
  %v531 = select i1 %v523, i64 %v20, i64 0
  %v532 = getelementptr double, ptr %v307, i64 %v310
  %v533 = getelementptr double, ptr %v532, i64 %v531
  store double %v530, ptr %v533, align 8
  %v534 = icmp sgt i64 %v313, 0
  %v535 = zext i1 %v534 to i64
  %v316 = add i64 %v315, %v535
  %v536 = sext i1 %v534 to i64
  %v314 = add nsw i64 %v313, %v536
  %v311 = select i1 %v534, i64 %v315, i64 0
  br i1 %v534, label %v309, label %v181

v68:
  store i64 0, ptr %v0, align 8
  ret i32 0

v411:
  %v537 = phi double [ %v404, %v377 ], [ %v403, %v378 ]
  %v538 = phi double [ %v408, %v377 ], [ %v410, %v378 ]
  %v539 = phi double [ %v396, %v377 ], [ %v395, %v378 ]
  br i1 %v373, label %v540, label %v414

v540:
  %v541 = getelementptr double, ptr %v380, i64 %v310
  %v542 = load double, ptr %v541, align 8
  %v543 = fmul double %v382, %v542
  %v544 = getelementptr double, ptr %v384, i64 %v310
  %v545 = load double, ptr %v544, align 8
  %v546 = fmul double %v382, %v545
  %v547 = load double, ptr %v387, align 8
  %v548 = load double, ptr %v391, align 8
  %v549 = fmul double %v543, %v547
  %v550 = fadd double %v539, %v549
  %v551 = tail call double @llvm.fabs.f64(double %v543)
  %v552 = fmul double %v551, %v548
  %v553 = tail call double @llvm.fabs.f64(double %v547)
  %v554 = fadd double %v553, %v548
  %v555 = fmul double %v546, %v554
  %v556 = fadd double %v552, %v555
  %v557 = fadd double %v537, %v556
  %v558 = tail call double @llvm.fabs.f64(double %v549)
  %v559 = fmul double %v272, %v558
  %v560 = fadd double %v538, %v559
  %v561 = tail call double @llvm.fabs.f64(double %v550)
  %v562 = fadd double %v561, %v560
  br label %v414

v414:
  %v413 = phi double [ %v537, %v411 ], [ %v557, %v540 ]
  %v416 = phi double [ %v538, %v411 ], [ %v562, %v540 ]
  %v418 = phi double [ %v539, %v411 ], [ %v550, %v540 ]
  %v563 = add nsw i64 %v564, -1
  %v565 = add i64 %v566, 1
  %v567 = icmp sgt i64 %v564, 1
  br i1 %v567, label %v377, label %v371

v181:
  %v568 = icmp sgt i64 %v182, 0
  %v569 = zext i1 %v568 to i64
  %v185 = add i64 %v184, %v569
  %v570 = sext i1 %v568 to i64
  %v183 = add nsw i64 %v182, %v570
  %v180 = select i1 %v568, i64 %v184, i64 0
  br i1 %v568, label %v178, label %v107

v132:
  %v571 = phi i64 [ 0, %v121 ], [ %v135, %v133 ]
  %v135 = add nsw i64 %v571, 1
  br i1 %v73, label %v133, label %v572

v572:
  %v573 = mul i64 %v571, %v48
  %v574 = getelementptr i64, ptr %v46, i64 %v573
  %v575 = getelementptr i8, ptr %v574, i64 8
  %v576 = load i64, ptr %v575, align 8
  %v577 = load i64, ptr %v574, align 8
  %v578 = icmp slt i64 %v576, 0
  %v579 = select i1 %v578, i64 %v7, i64 0
  %v580 = add i64 %v579, %v576
  %v581 = mul i64 %v580, %v74
  %v582 = getelementptr double, ptr %v124, i64 %v581
  %v583 = icmp slt i64 %v577, 0
  %v584 = select i1 %v583, i64 %v7, i64 0
  %v585 = add i64 %v584, %v577
  %v586 = mul i64 %v585, %v74
  %v587 = getelementptr double, ptr %v127, i64 %v586
  %v588 = select i1 %v578, i64 %v18, i64 0
  %v589 = add i64 %v588, %v576
  %v590 = mul i64 %v589, %v75
  %v591 = getelementptr double, ptr %v129, i64 %v590
  %v592 = select i1 %v583, i64 %v18, i64 0
  %v593 = add i64 %v592, %v577
  %v594 = mul i64 %v593, %v75
  %v595 = getelementptr double, ptr %v131, i64 %v594
  br label %v596

v596:
  %v597 = phi i64 [ %v72, %v572 ], [ %v598, %v596 ]
  %v599 = phi i64 [ %v62, %v572 ], [ %v600, %v596 ]
  %v598 = add nsw i64 %v597, -1
  %v600 = add i64 %v599, 1
  %v601 = icmp slt i64 %v599, 0
  %v602 = select i1 %v601, i64 %v9, i64 0
  %v603 = add i64 %v602, %v599
  %v604 = getelementptr double, ptr %v582, i64 %v603
  %v605 = load double, ptr %v604, align 8
  %v606 = fdiv double %v605, %v125
  %v607 = getelementptr double, ptr %v587, i64 %v603
  store double %v606, ptr %v607, align 8
  %v608 = select i1 %v601, i64 %v20, i64 0
  %v609 = add i64 %v608, %v599
  %v610 = getelementptr double, ptr %v591, i64 %v609
  %v611 = load double, ptr %v610, align 8
  %v612 = fdiv double %v611, %v125
  %v613 = tail call double @llvm.fabs.f64(double %v606)
  %v614 = fmul double %v613, 0x3CA0000000000000
  %v615 = fadd double %v612, %v614
  %v616 = fmul double %v615, 0x3FF0000000000200
  %v617 = fadd double %v616, 0x20B0000000000000
  %v618 = getelementptr double, ptr %v595, i64 %v609
  store double %v617, ptr %v618, align 8
  %v619 = icmp sgt i64 %v597, 1
  br i1 %v619, label %v596, label %v133

v377:
  %v396 = phi double [ 0.000000e+00, %v372 ], [ %v418, %v414 ]
  %v408 = phi double [ %v365, %v372 ], [ %v416, %v414 ]
  %v404 = phi double [ %v364, %v372 ], [ %v413, %v414 ]
  %v564 = phi i64 [ %v369, %v372 ], [ %v563, %v414 ]
  %v566 = phi i64 [ %v318, %v372 ], [ %v565, %v414 ]
  %v620 = sitofp i64 %v566 to double
  %v382 = select i1 %v257, double %v620, double 1.000000e+00
  %v621 = icmp slt i64 %v566, 0
  %v622 = select i1 %v621, i64 %v8, i64 0
  %v623 = add i64 %v622, %v566
  %v624 = mul i64 %v623, %v9
  %v380 = getelementptr double, ptr %v259, i64 %v624
  %v625 = select i1 %v621, i64 %v19, i64 0
  %v626 = add i64 %v625, %v566
  %v627 = mul i64 %v626, %v20
  %v384 = getelementptr double, ptr %v261, i64 %v627
  %v628 = sub nsw i64 %v116, %v566
  %v629 = icmp slt i64 %v628, 0
  %v630 = select i1 %v629, i64 %v8, i64 0
  %v631 = add i64 %v630, %v628
  %v632 = mul i64 %v631, %v9
  %v387 = getelementptr double, ptr %v266, i64 %v632
  %v633 = select i1 %v629, i64 %v19, i64 0
  %v634 = add i64 %v633, %v628
  %v635 = mul i64 %v634, %v20
  %v391 = getelementptr double, ptr %v270, i64 %v635
  br i1 %v308, label %v411, label %v378
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

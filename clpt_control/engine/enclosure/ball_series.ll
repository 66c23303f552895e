; sha256 654bf7d88b859825cd4f2c4e939c340ca3491a52f785b73e303883e4e8514756 5556f5018a19b5f83e5fd21c29ea03cda085ca5aa2e5e249dd9e49609626e8ed, Python 3.11, numba 0.68.1

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
  %v82 = icmp sgt i64 %v76, 0
  %v83 = zext i1 %v82 to i64
  %v84 = add i64 %v58, %v83
  %v85 = sext i1 %v82 to i64
  %v86 = add nsw i64 %v77, %v85
  %v87 = select i1 %v82, i64 %v58, i64 0
  %v88 = sub i64 %v63, %v62
  %v89 = tail call i64 @llvm.smax.i64(i64 %v88, i64 0)
  %v90 = icmp sgt i64 %v88, 0
  %v91 = zext i1 %v90 to i64
  %v92 = add i64 %v62, %v91
  %v93 = sext i1 %v90 to i64
  %v94 = add nsw i64 %v89, %v93
  %v95 = select i1 %v90, i64 %v62, i64 0
  %v96 = mul i64 %v9, %v8
  %v97 = mul i64 %v20, %v19
  %v98 = mul i64 %v9, %v8
  %v99 = mul i64 %v20, %v19
  %v100 = mul i64 %v9, %v8
  %v101 = mul i64 %v20, %v19
  %v102 = mul i64 %v9, %v8
  %v103 = mul i64 %v20, %v19
  br label %v104

v105:
  %v106 = icmp sgt i64 %v107, 0
  %v108 = sext i1 %v106 to i64
  %v109 = add nsw i64 %v107, %v108
  %v110 = zext i1 %v106 to i64
  %v111 = add i64 %v112, %v110
  %v113 = select i1 %v106, i64 %v112, i64 0
  br i1 %v106, label %v104, label %v68

v104:
  %v114 = phi i64 [ %v60, %v67 ], [ %v113, %v105 ]
  %v112 = phi i64 [ %v69, %v67 ], [ %v111, %v105 ]
  %v107 = phi i64 [ %v65, %v67 ], [ %v109, %v105 ]
  %v115 = icmp sgt i64 %v114, 0
  br i1 %v115, label %v116, label %v117

v116:
  br i1 %v70, label %v118, label %v119

v119:
  %v120 = add nsw i64 %v114, -1
  %v121 = mul i64 %v120, %v9
  %v122 = getelementptr double, ptr %v6, i64 %v121
  %v123 = uitofp i64 %v114 to double
  %v124 = mul i64 %v114, %v9
  %v125 = getelementptr double, ptr %v6, i64 %v124
  %v126 = mul i64 %v120, %v20
  %v127 = getelementptr double, ptr %v17, i64 %v126
  %v128 = mul i64 %v114, %v20
  %v129 = getelementptr double, ptr %v17, i64 %v128
  br label %v130

v131:
  %v132 = icmp eq i64 %v47, %v133
  br i1 %v132, label %v118, label %v130

v118:
  %v134 = icmp eq i64 %v114, %v61
  br i1 %v134, label %v68, label %v117

v117:
  br i1 %v82, label %v135, label %v105

v135:
  %v136 = icmp slt i64 %v114, 0
  %v137 = select i1 %v136, i64 %v8, i64 0
  %v138 = add i64 %v137, %v114
  %v139 = mul i64 %v138, %v9
  %v140 = getelementptr double, ptr %v6, i64 %v139
  %v141 = select i1 %v136, i64 %v19, i64 0
  %v142 = add i64 %v141, %v114
  %v143 = mul i64 %v142, %v20
  %v144 = getelementptr double, ptr %v17, i64 %v143
  %v145 = icmp slt i64 %v114, 0
  %v146 = select i1 %v145, i64 %v8, i64 0
  %v147 = add i64 %v146, %v114
  %v148 = mul i64 %v147, %v9
  %v149 = getelementptr double, ptr %v6, i64 %v148
  %v150 = select i1 %v145, i64 %v19, i64 0
  %v151 = add i64 %v150, %v114
  %v152 = mul i64 %v151, %v20
  %v153 = getelementptr double, ptr %v17, i64 %v152
  %v154 = icmp eq i64 %v114, 0
  %v155 = icmp sgt i64 %v114, 1
  %v156 = uitofp i64 %v114 to double
  %v157 = icmp slt i64 %v114, 0
  %v158 = select i1 %v157, i64 %v8, i64 0
  %v159 = add i64 %v158, %v114
  %v160 = mul i64 %v159, %v9
  %v161 = getelementptr double, ptr %v6, i64 %v160
  %v162 = select i1 %v157, i64 %v19, i64 0
  %v163 = add i64 %v162, %v114
  %v164 = mul i64 %v163, %v20
  %v165 = getelementptr double, ptr %v17, i64 %v164
  %v166 = icmp slt i64 %v114, 0
  %v167 = select i1 %v166, i64 %v8, i64 0
  %v168 = add i64 %v167, %v114
  %v169 = mul i64 %v168, %v9
  %v170 = getelementptr double, ptr %v6, i64 %v169
  %v171 = select i1 %v166, i64 %v19, i64 0
  %v172 = add i64 %v171, %v114
  %v173 = mul i64 %v172, %v20
  %v174 = getelementptr double, ptr %v17, i64 %v173
  %v175 = icmp eq i64 %v114, 0
  br label %v176

v176:
  %v177 = phi i64 [ %v87, %v135 ], [ %v178, %v179 ]
  %v180 = phi i64 [ %v86, %v135 ], [ %v181, %v179 ]
  %v182 = phi i64 [ %v84, %v135 ], [ %v183, %v179 ]
  %v184 = icmp slt i64 %v177, 0
  %v185 = select i1 %v184, i64 %v29, i64 0
  %v186 = add i64 %v185, %v177
  %v187 = mul i64 %v186, %v30
  %v188 = getelementptr i64, ptr %v28, i64 %v187
  %v189 = load i64, ptr %v188, align 8
  br i1 %v115, label %v190, label %v191

v190:
  %v192 = icmp slt i64 %v189, 0
  %v193 = select i1 %v192, i64 %v56, i64 0
  %v194 = getelementptr i64, ptr %v55, i64 %v189
  %v195 = getelementptr i64, ptr %v194, i64 %v193
  %v196 = load i64, ptr %v195, align 8
  %v197 = icmp eq i64 %v196, 1
  br i1 %v197, label %v179, label %v191

v191:
  %v198 = getelementptr i8, ptr %v188, i64 8
  %v199 = load i64, ptr %v198, align 8
  %v200 = getelementptr i8, ptr %v188, i64 16
  %v201 = load i64, ptr %v200, align 8
  %v202 = getelementptr i8, ptr %v188, i64 24
  %v203 = load i64, ptr %v202, align 8
  %v204 = getelementptr i8, ptr %v188, i64 32
  %v205 = load i64, ptr %v204, align 8
  %v206 = getelementptr i8, ptr %v188, i64 64
  %v207 = load i64, ptr %v206, align 8
  %v208 = getelementptr i8, ptr %v188, i64 40
  %v209 = load i64, ptr %v208, align 8
  %v210 = getelementptr i8, ptr %v188, i64 48
  %v211 = load i64, ptr %v210, align 8
  %v212 = sub nsw i64 %v114, %v211
  %v213 = icmp sgt i64 %v203, -1
  br i1 %v213, label %v214, label %v215

v214:
  %v216 = getelementptr i64, ptr %v55, i64 %v203
  %v217 = load i64, ptr %v216, align 8
  %v218 = icmp eq i64 %v217, 1
  %v219 = tail call i64 @llvm.smin.i64(i64 %v212, i64 0)
  %v220 = select i1 %v218, i64 %v219, i64 %v212
  %v221 = icmp slt i64 %v205, 0
  %v222 = select i1 %v221, i64 %v56, i64 0
  %v223 = getelementptr i64, ptr %v55, i64 %v205
  %v224 = getelementptr i64, ptr %v223, i64 %v222
  %v225 = load i64, ptr %v224, align 8
  %v226 = icmp eq i64 %v225, 1
  br i1 %v226, label %v227, label %v215

v227:
  %v228 = tail call i64 @llvm.smax.i64(i64 %v114, i64 %v209)
  br label %v215

v215:
  %v229 = phi i64 [ %v220, %v227 ], [ %v220, %v214 ], [ %v212, %v191 ]
  %v230 = phi i64 [ %v228, %v227 ], [ %v209, %v214 ], [ %v209, %v191 ]
  br i1 %v90, label %v231, label %v179

v231:
  %v232 = mul i64 %v81, %v201
  %v233 = mul i64 %v80, %v201
  %v234 = mul i64 %v79, %v199
  %v235 = mul i64 %v78, %v199
  %v236 = icmp sgt i64 %v199, -1
  %v237 = select i1 %v184, i64 %v38, i64 0
  %v238 = add i64 %v237, %v177
  %v239 = mul i64 %v238, %v39
  %v240 = getelementptr double, ptr %v37, i64 %v239
  %v241 = getelementptr double, ptr %v140, i64 %v235
  %v242 = getelementptr double, ptr %v144, i64 %v234
  %v243 = icmp sgt i64 %v201, -1
  %v244 = select i1 %v184, i64 %v38, i64 0
  %v245 = add i64 %v244, %v177
  %v246 = mul i64 %v245, %v39
  %v247 = getelementptr double, ptr %v37, i64 %v246
  %v248 = getelementptr i8, ptr %v247, i64 8
  %v249 = getelementptr double, ptr %v149, i64 %v233
  %v250 = getelementptr double, ptr %v153, i64 %v232
  %v251 = icmp eq i64 %v207, 1
  %v252 = and i1 %v251, %v154
  %v253 = and i1 %v115, %v251
  %v254 = mul i64 %v203, %v96
  %v255 = getelementptr double, ptr %v6, i64 %v254
  %v256 = mul i64 %v203, %v97
  %v257 = getelementptr double, ptr %v17, i64 %v256
  %v258 = icmp slt i64 %v205, 0
  %v259 = select i1 %v258, i64 %v7, i64 0
  %v260 = add i64 %v259, %v205
  %v261 = mul i64 %v260, %v96
  %v262 = getelementptr double, ptr %v6, i64 %v261
  %v263 = select i1 %v258, i64 %v18, i64 0
  %v264 = add i64 %v263, %v205
  %v265 = mul i64 %v264, %v97
  %v266 = getelementptr double, ptr %v17, i64 %v265
  %v267 = sitofp i64 %v207 to double
  %v268 = fadd double %v267, 1.000000e+00
  %v269 = select i1 %v184, i64 %v38, i64 0
  %v270 = add i64 %v269, %v177
  %v271 = mul i64 %v270, %v39
  %v272 = getelementptr double, ptr %v37, i64 %v271
  %v273 = getelementptr i8, ptr %v272, i64 16
  %v274 = and i1 %v251, %v155
  %v275 = getelementptr i8, ptr %v188, i64 56
  %v276 = select i1 %v184, i64 %v38, i64 0
  %v277 = add i64 %v276, %v177
  %v278 = mul i64 %v277, %v39
  %v279 = getelementptr double, ptr %v37, i64 %v278
  %v280 = getelementptr i8, ptr %v279, i64 24
  %v281 = icmp slt i64 %v189, 0
  %v282 = select i1 %v281, i64 %v7, i64 0
  %v283 = add i64 %v282, %v189
  %v284 = mul i64 %v283, %v98
  %v285 = getelementptr double, ptr %v161, i64 %v284
  %v286 = select i1 %v281, i64 %v18, i64 0
  %v287 = add i64 %v286, %v189
  %v288 = mul i64 %v287, %v99
  %v289 = getelementptr double, ptr %v165, i64 %v288
  %v290 = icmp slt i64 %v189, 0
  %v291 = select i1 %v290, i64 %v7, i64 0
  %v292 = add i64 %v291, %v189
  %v293 = mul i64 %v102, %v292
  %v294 = getelementptr double, ptr %v170, i64 %v293
  %v295 = select i1 %v290, i64 %v18, i64 0
  %v296 = add i64 %v295, %v189
  %v297 = mul i64 %v103, %v296
  %v298 = getelementptr double, ptr %v174, i64 %v297
  %v299 = and i1 %v251, %v175
  br label %v300

v300:
  %v301 = phi i64 [ %v95, %v231 ], [ %v302, %v303 ]
  %v304 = phi i64 [ %v94, %v231 ], [ %v305, %v303 ]
  %v306 = phi i64 [ %v92, %v231 ], [ %v307, %v303 ]
  %v308 = phi i64 [ %v230, %v231 ], [ %v309, %v303 ]
  %v310 = phi i64 [ %v229, %v231 ], [ %v311, %v303 ]
  br i1 %v236, label %v312, label %v313

v312:
  %v314 = load double, ptr %v240, align 8
  %v315 = icmp slt i64 %v301, 0
  %v316 = select i1 %v315, i64 %v9, i64 0
  %v317 = getelementptr double, ptr %v241, i64 %v301
  %v318 = getelementptr double, ptr %v317, i64 %v316
  %v319 = load double, ptr %v318, align 8
  %v320 = fmul double %v314, %v319
  %v321 = select i1 %v315, i64 %v20, i64 0
  %v322 = getelementptr double, ptr %v242, i64 %v301
  %v323 = getelementptr double, ptr %v322, i64 %v321
  %v324 = load double, ptr %v323, align 8
  br label %v313

v313:
  %v325 = phi double [ %v320, %v312 ], [ 0.000000e+00, %v300 ]
  %v326 = phi double [ %v324, %v312 ], [ 0.000000e+00, %v300 ]
  br i1 %v243, label %v327, label %v328

v327:
  %v329 = load double, ptr %v248, align 8
  %v330 = icmp slt i64 %v301, 0
  %v331 = select i1 %v330, i64 %v9, i64 0
  %v332 = getelementptr double, ptr %v249, i64 %v301
  %v333 = getelementptr double, ptr %v332, i64 %v331
  %v334 = load double, ptr %v333, align 8
  %v335 = fmul double %v329, %v334
  %v336 = fadd double %v325, %v335
  %v337 = tail call double @llvm.fabs.f64(double %v329)
  %v338 = select i1 %v330, i64 %v20, i64 0
  %v339 = getelementptr double, ptr %v250, i64 %v301
  %v340 = getelementptr double, ptr %v339, i64 %v338
  %v341 = load double, ptr %v340, align 8
  %v342 = fmul double %v337, %v341
  %v343 = fadd double %v326, %v342
  %v344 = tail call double @llvm.fabs.f64(double %v335)
  %v345 = tail call double @llvm.fabs.f64(double %v336)
  %v346 = fadd double %v344, %v345
  br label %v328

v328:
  %v347 = phi double [ %v336, %v327 ], [ %v325, %v313 ]
  %v348 = phi double [ %v343, %v327 ], [ %v326, %v313 ]
  %v349 = phi double [ %v346, %v327 ], [ 0.000000e+00, %v313 ]
  %v311 = select i1 %v252, i64 0, i64 %v310
  %v309 = select i1 %v252, i64 0, i64 %v308
  br i1 %v213, label %v350, label %v351

v350:
  %v352 = add nsw i64 %v311, 1
  %v353 = sub i64 %v352, %v309
  %v354 = icmp slt i64 %v353, 1
  br i1 %v354, label %v355, label %v356

v356:
  %v357 = icmp sgt i64 %v301, 0
  %v358 = icmp slt i64 %v301, 0
  %v359 = select i1 %v358, i64 %v9, i64 0
  %v360 = select i1 %v358, i64 %v20, i64 0
  br label %v361

v362:
  %v363 = load double, ptr %v364, align 8
  %v365 = fmul double %v366, %v363
  %v367 = load double, ptr %v368, align 8
  %v369 = fmul double %v366, %v367
  %v370 = getelementptr double, ptr %v371, i64 %v301
  %v372 = getelementptr double, ptr %v370, i64 %v359
  %v373 = load double, ptr %v372, align 8
  %v374 = getelementptr double, ptr %v375, i64 %v301
  %v376 = getelementptr double, ptr %v374, i64 %v360
  %v377 = load double, ptr %v376, align 8
  %v378 = fmul double %v365, %v373
  %v379 = fadd double %v380, %v378
  %v381 = tail call double @llvm.fabs.f64(double %v365)
  %v382 = fmul double %v381, %v377
  %v383 = tail call double @llvm.fabs.f64(double %v373)
  %v384 = fadd double %v383, %v377
  %v385 = fmul double %v369, %v384
  %v386 = fadd double %v382, %v385
  %v387 = fadd double %v388, %v386
  %v389 = tail call double @llvm.fabs.f64(double %v378)
  %v390 = fmul double %v268, %v389
  %v391 = fadd double %v392, %v390
  %v393 = tail call double @llvm.fabs.f64(double %v379)
  %v394 = fadd double %v393, %v391
  br label %v395

v355:
  %v396 = phi double [ %v348, %v350 ], [ %v397, %v398 ]
  %v399 = phi double [ %v349, %v350 ], [ %v400, %v398 ]
  %v401 = phi double [ 0.000000e+00, %v350 ], [ %v402, %v398 ]
  %v403 = load double, ptr %v273, align 8
  %v404 = fmul double %v401, %v403
  %v405 = fadd double %v347, %v404
  %v406 = tail call double @llvm.fabs.f64(double %v405)
  %v407 = fadd double %v399, %v406
  br label %v351

v351:
  %v408 = phi double [ %v405, %v355 ], [ %v347, %v328 ]
  %v409 = phi double [ %v396, %v355 ], [ %v348, %v328 ]
  %v410 = phi double [ %v407, %v355 ], [ %v349, %v328 ]
  br i1 %v274, label %v411, label %v412

v411:
  %v413 = fdiv double %v408, %v156
  %v414 = fdiv double %v409, %v156
  %v415 = fdiv double %v410, %v156
  %v416 = tail call double @llvm.fabs.f64(double %v413)
  %v417 = fadd double %v416, %v415
  br label %v412

v412:
  %v418 = phi double [ %v413, %v411 ], [ %v408, %v351 ]
  %v419 = phi double [ %v414, %v411 ], [ %v409, %v351 ]
  %v420 = phi double [ %v417, %v411 ], [ %v410, %v351 ]
  %v421 = load i64, ptr %v275, align 8
  %v422 = icmp sgt i64 %v421, -1
  br i1 %v422, label %v423, label %v303

v423:
  %v424 = load double, ptr %v280, align 8
  %v425 = icmp slt i64 %v301, 1
  %v426 = icmp eq i64 %v421, %v189
  %v427 = select i1 %v154, i1 %v426, i1 false
  %v428 = select i1 %v425, i1 true, i1 %v427
  br i1 %v428, label %v429, label %v430

v430:
  %v431 = load double, ptr %v285, align 8
  %v432 = load double, ptr %v289, align 8
  %v433 = mul i64 %v421, %v98
  %v434 = getelementptr double, ptr %v6, i64 %v433
  %v435 = getelementptr double, ptr %v434, i64 %v301
  %v436 = load double, ptr %v435, align 8
  %v437 = fmul double %v424, %v436
  %v438 = mul i64 %v421, %v99
  %v439 = getelementptr double, ptr %v17, i64 %v438
  %v440 = getelementptr double, ptr %v439, i64 %v301
  %v441 = load double, ptr %v440, align 8
  %v442 = fmul double %v424, %v441
  %v443 = fmul double %v431, %v437
  %v444 = fsub double %v418, %v443
  %v445 = tail call double @llvm.fabs.f64(double %v431)
  %v446 = fmul double %v445, %v442
  %v447 = tail call double @llvm.fabs.f64(double %v437)
  %v448 = fadd double %v447, %v442
  %v449 = fmul double %v432, %v448
  %v450 = fadd double %v446, %v449
  %v451 = fadd double %v419, %v450
  %v452 = tail call double @llvm.fabs.f64(double %v443)
  %v453 = fadd double %v420, %v452
  %v454 = tail call double @llvm.fabs.f64(double %v444)
  %v455 = fadd double %v453, %v454
  br label %v429

v429:
  %v456 = phi double [ %v418, %v423 ], [ %v444, %v430 ]
  %v457 = phi double [ %v419, %v423 ], [ %v451, %v430 ]
  %v458 = phi double [ %v420, %v423 ], [ %v455, %v430 ]
  %v459 = mul i64 %v100, %v421
  %v460 = getelementptr double, ptr %v6, i64 %v459
  %v461 = load double, ptr %v460, align 8
  %v462 = fmul double %v424, %v461
  %v463 = mul i64 %v101, %v421
  %v464 = getelementptr double, ptr %v17, i64 %v463
  %v465 = load double, ptr %v464, align 8
  %v466 = fmul double %v424, %v465
  %v467 = fdiv double %v456, %v462
  %v468 = tail call double @llvm.fabs.f64(double %v462)
  %v469 = fsub double %v468, %v466
  %v470 = fcmp ogt double %v469, 0.000000e+00
  br i1 %v470, label %v471, label %v472

v471:
  %v473 = fmul double %v458, 0x3CA0000000000000
  %v474 = fadd double %v457, %v473
  %v475 = fadd double %v474, 0x20B0000000000000
  %v476 = tail call double @llvm.fabs.f64(double %v467)
  %v477 = fmul double %v466, %v476
  %v478 = fadd double %v475, %v477
  %v479 = fdiv double %v478, %v469
  br label %v472

v472:
  %v480 = phi double [ %v479, %v471 ], [ 0x7FF0000000000000, %v429 ]
  %v481 = tail call double @llvm.fabs.f64(double %v467)
  br label %v303

v303:
  %v482 = phi double [ %v467, %v472 ], [ %v418, %v412 ]
  %v483 = phi double [ %v480, %v472 ], [ %v419, %v412 ]
  %v484 = phi double [ %v481, %v472 ], [ %v420, %v412 ]
  %v485 = icmp slt i64 %v301, 0
  %v486 = select i1 %v485, i64 %v9, i64 0
  %v487 = getelementptr double, ptr %v294, i64 %v301
  %v488 = getelementptr double, ptr %v487, i64 %v486
  store double %v482, ptr %v488, align 8
  %v489 = fmul double %v484, 0x3CA0000000000000
  %v490 = fadd double %v483, %v489
  %v491 = fmul double %v490, 0x3FF0000000000200
  %v492 = fadd double %v491, 0x20B0000000000000
  %v493 = select i1 %v485, i64 %v20, i64 0
  %v494 = getelementptr double, ptr %v298, i64 %v301
  %v495 = getelementptr double, ptr %v494, i64 %v493
  store double %v492, ptr %v495, align 8
  %v496 = icmp sgt i64 %v304, 0
  %v497 = zext i1 %v496 to i64
  %v307 = add i64 %v306, %v497
  %v498 = sext i1 %v496 to i64
  %v305 = add nsw i64 %v304, %v498
  %v302 = select i1 %v496, i64 %v306, i64 0
  br i1 %v496, label %v300, label %v179

v68:
  store i64 0, ptr %v0, align 8
  ret i32 0

v395:
  %v499 = phi double [ %v388, %v361 ], [ %v387, %v362 ]
  %v500 = phi double [ %v392, %v361 ], [ %v394, %v362 ]
  %v501 = phi double [ %v380, %v361 ], [ %v379, %v362 ]
  br i1 %v357, label %v502, label %v398

v502:
  %v503 = getelementptr double, ptr %v364, i64 %v301
  %v504 = load double, ptr %v503, align 8
  %v505 = fmul double %v366, %v504
  %v506 = getelementptr double, ptr %v368, i64 %v301
  %v507 = load double, ptr %v506, align 8
  %v508 = fmul double %v366, %v507
  %v509 = load double, ptr %v371, align 8
  %v510 = load double, ptr %v375, align 8
  %v511 = fmul double %v505, %v509
  %v512 = fadd double %v501, %v511
  %v513 = tail call double @llvm.fabs.f64(double %v505)
  %v514 = fmul double %v513, %v510
  %v515 = tail call double @llvm.fabs.f64(double %v509)
  %v516 = fadd double %v515, %v510
  %v517 = fmul double %v508, %v516
  %v518 = fadd double %v514, %v517
  %v519 = fadd double %v499, %v518
  %v520 = tail call double @llvm.fabs.f64(double %v511)
  %v521 = fmul double %v268, %v520
  %v522 = fadd double %v500, %v521
  %v523 = tail call double @llvm.fabs.f64(double %v512)
  %v524 = fadd double %v523, %v522
  br label %v398

v398:
  %v397 = phi double [ %v499, %v395 ], [ %v519, %v502 ]
  %v400 = phi double [ %v500, %v395 ], [ %v524, %v502 ]
  %v402 = phi double [ %v501, %v395 ], [ %v512, %v502 ]
  %v525 = add nsw i64 %v526, -1
  %v527 = add i64 %v528, 1
  %v529 = icmp sgt i64 %v526, 1
  br i1 %v529, label %v361, label %v355

v179:
  %v530 = icmp sgt i64 %v180, 0
  %v531 = zext i1 %v530 to i64
  %v183 = add i64 %v182, %v531
  %v532 = sext i1 %v530 to i64
  %v181 = add nsw i64 %v180, %v532
  %v178 = select i1 %v530, i64 %v182, i64 0
  br i1 %v530, label %v176, label %v105

v130:
  %v533 = phi i64 [ 0, %v119 ], [ %v133, %v131 ]
  %v133 = add nsw i64 %v533, 1
  br i1 %v73, label %v131, label %v534

v534:
  %v535 = mul i64 %v533, %v48
  %v536 = getelementptr i64, ptr %v46, i64 %v535
  %v537 = getelementptr i8, ptr %v536, i64 8
  %v538 = load i64, ptr %v537, align 8
  %v539 = load i64, ptr %v536, align 8
  %v540 = icmp slt i64 %v538, 0
  %v541 = select i1 %v540, i64 %v7, i64 0
  %v542 = add i64 %v541, %v538
  %v543 = mul i64 %v542, %v74
  %v544 = getelementptr double, ptr %v122, i64 %v543
  %v545 = icmp slt i64 %v539, 0
  %v546 = select i1 %v545, i64 %v7, i64 0
  %v547 = add i64 %v546, %v539
  %v548 = mul i64 %v547, %v74
  %v549 = getelementptr double, ptr %v125, i64 %v548
  %v550 = select i1 %v540, i64 %v18, i64 0
  %v551 = add i64 %v550, %v538
  %v552 = mul i64 %v551, %v75
  %v553 = getelementptr double, ptr %v127, i64 %v552
  %v554 = select i1 %v545, i64 %v18, i64 0
  %v555 = add i64 %v554, %v539
  %v556 = mul i64 %v555, %v75
  %v557 = getelementptr double, ptr %v129, i64 %v556
  br label %v558

v558:
  %v559 = phi i64 [ %v72, %v534 ], [ %v560, %v558 ]
  %v561 = phi i64 [ %v62, %v534 ], [ %v562, %v558 ]
  %v560 = add nsw i64 %v559, -1
  %v562 = add i64 %v561, 1
  %v563 = icmp slt i64 %v561, 0
  %v564 = select i1 %v563, i64 %v9, i64 0
  %v565 = add i64 %v564, %v561
  %v566 = getelementptr double, ptr %v544, i64 %v565
  %v567 = load double, ptr %v566, align 8
  %v568 = fdiv double %v567, %v123
  %v569 = getelementptr double, ptr %v549, i64 %v565
  store double %v568, ptr %v569, align 8
  %v570 = select i1 %v563, i64 %v20, i64 0
  %v571 = add i64 %v570, %v561
  %v572 = getelementptr double, ptr %v553, i64 %v571
  %v573 = load double, ptr %v572, align 8
  %v574 = fdiv double %v573, %v123
  %v575 = tail call double @llvm.fabs.f64(double %v568)
  %v576 = fmul double %v575, 0x3CA0000000000000
  %v577 = fadd double %v574, %v576
  %v578 = fmul double %v577, 0x3FF0000000000200
  %v579 = fadd double %v578, 0x20B0000000000000
  %v580 = getelementptr double, ptr %v557, i64 %v571
  store double %v579, ptr %v580, align 8
  %v581 = icmp sgt i64 %v559, 1
  br i1 %v581, label %v558, label %v131

v361:
  %v380 = phi double [ 0.000000e+00, %v356 ], [ %v402, %v398 ]
  %v392 = phi double [ %v349, %v356 ], [ %v400, %v398 ]
  %v388 = phi double [ %v348, %v356 ], [ %v397, %v398 ]
  %v526 = phi i64 [ %v353, %v356 ], [ %v525, %v398 ]
  %v528 = phi i64 [ %v309, %v356 ], [ %v527, %v398 ]
  %v582 = sitofp i64 %v528 to double
  %v366 = select i1 %v253, double %v582, double 1.000000e+00
  %v583 = icmp slt i64 %v528, 0
  %v584 = select i1 %v583, i64 %v8, i64 0
  %v585 = add i64 %v584, %v528
  %v586 = mul i64 %v585, %v9
  %v364 = getelementptr double, ptr %v255, i64 %v586
  %v587 = select i1 %v583, i64 %v19, i64 0
  %v588 = add i64 %v587, %v528
  %v589 = mul i64 %v588, %v20
  %v368 = getelementptr double, ptr %v257, i64 %v589
  %v590 = sub nsw i64 %v114, %v528
  %v591 = icmp slt i64 %v590, 0
  %v592 = select i1 %v591, i64 %v8, i64 0
  %v593 = add i64 %v592, %v590
  %v594 = mul i64 %v593, %v9
  %v371 = getelementptr double, ptr %v262, i64 %v594
  %v595 = select i1 %v591, i64 %v19, i64 0
  %v596 = add i64 %v595, %v590
  %v597 = mul i64 %v596, %v20
  %v375 = getelementptr double, ptr %v266, i64 %v597
  br i1 %v299, label %v395, label %v362
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

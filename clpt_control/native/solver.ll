; sha256 71b1bb858ef3e81bdfd16f1ef90912f365b48a74fc769cf6498c916719cba58f

define dso_local noundef i32 @advance(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.shape.3, i64 %arg.shape.4, i64 %arg.shape.5, i64 %arg.shape.6, ptr readnone %arg.tolerances.0, ptr readnone %arg.tolerances.1, i64 %arg.tolerances.2, i64 %arg.tolerances.3, ptr %arg.tolerances.4, i64 %arg.tolerances.5.0, i64 %arg.tolerances.6.0, ptr readnone %arg.batch.0.0.0, ptr readnone %arg.batch.0.0.1, i64 %arg.batch.0.0.2, i64 %arg.batch.0.0.3, ptr readonly %arg.batch.0.0.4, i64 %arg.batch.0.0.5.0, i64 %arg.batch.0.0.5.1, i64 %arg.batch.0.0.6.0, i64 %arg.batch.0.0.6.1, ptr readnone %arg.batch.0.1.0, ptr readnone %arg.batch.0.1.1, i64 %arg.batch.0.1.2, i64 %arg.batch.0.1.3, ptr readonly %arg.batch.0.1.4, i64 %arg.batch.0.1.5.0, i64 %arg.batch.0.1.5.1, i64 %arg.batch.0.1.6.0, i64 %arg.batch.0.1.6.1, ptr readnone %arg.batch.0.2.0, ptr readnone %arg.batch.0.2.1, i64 %arg.batch.0.2.2, i64 %arg.batch.0.2.3, ptr readonly %arg.batch.0.2.4, i64 %arg.batch.0.2.5.0, i64 %arg.batch.0.2.6.0, ptr readnone %arg.batch.1.0.0, ptr readnone %arg.batch.1.0.1, i64 %arg.batch.1.0.2, i64 %arg.batch.1.0.3, ptr readonly %arg.batch.1.0.4, i64 %arg.batch.1.0.5.0, i64 %arg.batch.1.0.6.0, ptr readnone %arg.batch.1.1.0, ptr readnone %arg.batch.1.1.1, i64 %arg.batch.1.1.2, i64 %arg.batch.1.1.3, ptr readonly %arg.batch.1.1.4, i64 %arg.batch.1.1.5.0, i64 %arg.batch.1.1.6.0, ptr readnone %arg.batch.1.2.0, ptr readnone %arg.batch.1.2.1, i64 %arg.batch.1.2.2, i64 %arg.batch.1.2.3, ptr readonly %arg.batch.1.2.4, i64 %arg.batch.1.2.5.0, i64 %arg.batch.1.2.6.0, ptr readnone %arg.batch.1.3.0, ptr readnone %arg.batch.1.3.1, i64 %arg.batch.1.3.2, i64 %arg.batch.1.3.3, ptr readonly %arg.batch.1.3.4, i64 %arg.batch.1.3.5.0, i64 %arg.batch.1.3.5.1, i64 %arg.batch.1.3.6.0, i64 %arg.batch.1.3.6.1, ptr readnone %arg.batch.1.4.0, ptr readnone %arg.batch.1.4.1, i64 %arg.batch.1.4.2, i64 %arg.batch.1.4.3, ptr readonly %arg.batch.1.4.4, i64 %arg.batch.1.4.5.0, i64 %arg.batch.1.4.6.0, ptr readnone %arg.batch.2.0, ptr readnone %arg.batch.2.1, i64 %arg.batch.2.2, i64 %arg.batch.2.3, ptr readonly %arg.batch.2.4, i64 %arg.batch.2.5.0, i64 %arg.batch.2.6.0, ptr readnone %arg.batch.3.0.0, ptr readnone %arg.batch.3.0.1, i64 %arg.batch.3.0.2, i64 %arg.batch.3.0.3, ptr %arg.batch.3.0.4, i64 %arg.batch.3.0.5.0, i64 %arg.batch.3.0.5.1, i64 %arg.batch.3.0.5.2, i64 %arg.batch.3.0.6.0, i64 %arg.batch.3.0.6.1, i64 %arg.batch.3.0.6.2, ptr readnone %arg.batch.3.1.0, ptr readnone %arg.batch.3.1.1, i64 %arg.batch.3.1.2, i64 %arg.batch.3.1.3, ptr %arg.batch.3.1.4, i64 %arg.batch.3.1.5.0, i64 %arg.batch.3.1.6.0, ptr readnone %arg.batch.3.2.0, ptr readnone %arg.batch.3.2.1, i64 %arg.batch.3.2.2, i64 %arg.batch.3.2.3, ptr %arg.batch.3.2.4, i64 %arg.batch.3.2.5.0, i64 %arg.batch.3.2.6.0, ptr readnone %arg.batch.3.3.0, ptr readnone %arg.batch.3.3.1, i64 %arg.batch.3.3.2, i64 %arg.batch.3.3.3, ptr %arg.batch.3.3.4, i64 %arg.batch.3.3.5.0, i64 %arg.batch.3.3.5.1, i64 %arg.batch.3.3.6.0, i64 %arg.batch.3.3.6.1, ptr readnone %arg.batch.4.0.0, ptr readnone %arg.batch.4.0.1, i64 %arg.batch.4.0.2, i64 %arg.batch.4.0.3, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.0, i64 %arg.batch.4.0.5.1, i64 %arg.batch.4.0.6.0, i64 %arg.batch.4.0.6.1, ptr readnone %arg.batch.4.1.0, ptr readnone %arg.batch.4.1.1, i64 %arg.batch.4.1.2, i64 %arg.batch.4.1.3, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.0, i64 %arg.batch.4.1.5.1, i64 %arg.batch.4.1.6.0, i64 %arg.batch.4.1.6.1, ptr readnone %arg.batch.4.2.0, ptr readnone %arg.batch.4.2.1, i64 %arg.batch.4.2.2, i64 %arg.batch.4.2.3, ptr %arg.batch.4.2.4, i64 %arg.batch.4.2.5.0, i64 %arg.batch.4.2.6.0, ptr readnone %arg.batch.5.0.0, ptr readnone %arg.batch.5.0.1, i64 %arg.batch.5.0.2, i64 %arg.batch.5.0.3, ptr %arg.batch.5.0.4, i64 %arg.batch.5.0.5.0, i64 %arg.batch.5.0.6.0, ptr readnone %arg.batch.5.1.0, ptr readnone %arg.batch.5.1.1, i64 %arg.batch.5.1.2, i64 %arg.batch.5.1.3, ptr %arg.batch.5.1.4, i64 %arg.batch.5.1.5.0, i64 %arg.batch.5.1.6.0, ptr readnone %arg.batch.5.2.0, ptr readnone %arg.batch.5.2.1, i64 %arg.batch.5.2.2, i64 %arg.batch.5.2.3, ptr %arg.batch.5.2.4, i64 %arg.batch.5.2.5.0, i64 %arg.batch.5.2.6.0, ptr readnone %arg.batch.5.3.0, ptr readnone %arg.batch.5.3.1, i64 %arg.batch.5.3.2, i64 %arg.batch.5.3.3, ptr %arg.batch.5.3.4, i64 %arg.batch.5.3.5.0, i64 %arg.batch.5.3.6.0, ptr readnone %arg.batch.5.4.0, ptr readnone %arg.batch.5.4.1, i64 %arg.batch.5.4.2, i64 %arg.batch.5.4.3, ptr %arg.batch.5.4.4, i64 %arg.batch.5.4.5.0, i64 %arg.batch.5.4.6.0, ptr readnone %arg.linear.0.0, ptr readnone %arg.linear.0.1, i64 %arg.linear.0.2, i64 %arg.linear.0.3, ptr %arg.linear.0.4, i64 %arg.linear.0.5.0, i64 %arg.linear.0.6.0, ptr readnone %arg.linear.1.0, ptr readnone %arg.linear.1.1, i64 %arg.linear.1.2, i64 %arg.linear.1.3, ptr %arg.linear.1.4, i64 %arg.linear.1.5.0, i64 %arg.linear.1.6.0, i64 %arg.budget, i64 %arg.most) local_unnamed_addr {
entry:
  %.394 = mul nsw i64 %arg.shape.1, %arg.shape.0
  %.502.idx = shl i64 %arg.batch.4.0.5.1, 6
  %.502 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.502.idx
  %.541 = icmp eq i64 %arg.shape.2, 9
  %.543.not = icmp ne i64 %arg.shape.2, 4
  %.545 = icmp ne i64 %arg.shape.2, 12
  %.603 = icmp slt i64 %arg.shape.0, 1
  %storemerge = select i1 %.603, i64 0, i64 %arg.shape.0
  br i1 %.603, label %B394, label %B254.if.lr.ph

B254.if.lr.ph:                                    ; preds = %entry
  %.idx.i = mul i64 %arg.batch.4.0.5.1, 24
  %0 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i
  %.323.i = getelementptr i8, ptr %arg.batch.4.2.4, i64 8
  %.418.i = getelementptr i8, ptr %arg.batch.4.2.4, i64 16
  %1 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx1123.i = shl i64 %arg.batch.4.1.5.1, 4
  %2 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1123.i
  %.idx1124.i = mul i64 %arg.batch.4.1.5.1, 24
  %3 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1124.i
  %.8051131.not.i = icmp slt i64 %arg.batch.0.1.5.1, 1
  %.175.i1134.not.i = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.11171137.not.i = icmp slt i64 %arg.shape.1, 1
  %gep.2.idx.i = shl i64 %arg.batch.4.0.5.1, 4
  %gep.4.idx.i = shl i64 %arg.batch.4.0.5.1, 5
  %gep.5.idx.i = mul i64 %arg.batch.4.0.5.1, 40
  %gep.6.idx.i = mul i64 %arg.batch.4.0.5.1, 48
  %gep.7.idx.i = mul i64 %arg.batch.4.0.5.1, 56
  %gep.9.idx.i = mul i64 %arg.batch.4.0.5.1, 72
  %gep.10.idx.i = mul i64 %arg.batch.4.0.5.1, 80
  %gep.11.idx.i = mul i64 %arg.batch.4.0.5.1, 88
  %gep.12.idx.i = mul i64 %arg.batch.4.0.5.1, 96
  %gep.13.idx.i = mul i64 %arg.batch.4.0.5.1, 104
  %gep.14.idx.i = mul i64 %arg.batch.4.0.5.1, 112
  %gep.15.idx.i = mul i64 %arg.batch.4.0.5.1, 120
  %gep.16.idx.i = shl i64 %arg.batch.4.0.5.1, 7
  %gep.17.idx.i = mul i64 %arg.batch.4.0.5.1, 136
  %gep.18.idx.i = mul i64 %arg.batch.4.0.5.1, 144
  %gep.19.idx.i = mul i64 %arg.batch.4.0.5.1, 152
  %gep.20.idx.i = mul i64 %arg.batch.4.0.5.1, 160
  %gep.21.idx.i = mul i64 %arg.batch.4.0.5.1, 168
  %gep.22.idx.i = mul i64 %arg.batch.4.0.5.1, 176
  %gep.23.idx.i = mul i64 %arg.batch.4.0.5.1, 184
  %gep.24.idx.i = mul i64 %arg.batch.4.0.5.1, 192
  %gep.25.idx.i = mul i64 %arg.batch.4.0.5.1, 200
  %gep.26.idx.i = mul i64 %arg.batch.4.0.5.1, 208
  %gep.27.idx.i = mul i64 %arg.batch.4.0.5.1, 216
  %gep.28.idx.i = mul i64 %arg.batch.4.0.5.1, 224
  %gep.29.idx.i = mul i64 %arg.batch.4.0.5.1, 232
  %4 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i
  %5 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.15.idx.i
  %6 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.29.idx.i
  %.idx1130.i = mul i64 %arg.batch.4.0.5.1, 240
  %7 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i
  br label %B254.if

B296:                                             ; preds = %B254.if
  %.236.i = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !0
  %.293.i = getelementptr double, ptr %0, i64 %.589.010691
  store double 0.000000e+00, ptr %.293.i, align 8, !noalias !0
  %.324.i = load i64, ptr %.323.i, align 8, !noalias !0
  %.326.i = icmp eq i64 %.236.i, %.324.i
  br i1 %.326.i, label %B340, label %B132.i

B132.i:                                           ; preds = %B296
  %.359.i10346 = add nsw i64 %.236.i, 1
  store i64 %.359.i10346, ptr %arg.batch.4.2.4, align 8, !noalias !0
  store i64 1, ptr %.418.i, align 8, !noalias !0
  %.438.i = icmp slt i64 %.236.i, 0
  %.439.i = select i1 %.438.i, i64 %arg.batch.0.2.5.0, i64 0
  %8 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i
  %.453.i10347 = getelementptr i64, ptr %8, i64 %.439.i
  %.454.i10348 = load i64, ptr %.453.i10347, align 8, !noalias !0
  %.469.i = icmp slt i64 %.454.i10348, 0
  %.470.i = select i1 %.469.i, i64 %arg.batch.1.0.5.0, i64 0
  %9 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i10348
  %.484.i10349 = getelementptr i64, ptr %9, i64 %.470.i
  %.485.i = load i64, ptr %.484.i10349, align 8, !noalias !0
  %.540.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.589.010691
  store i64 %.236.i, ptr %.540.i, align 8, !noalias !0
  %.595.i = getelementptr i64, ptr %1, i64 %.589.010691
  store i64 %.485.i, ptr %.595.i, align 8, !noalias !0
  %.654.i = getelementptr i64, ptr %2, i64 %.589.010691
  store i64 1, ptr %.654.i, align 8, !noalias !0
  %.709.i = getelementptr i64, ptr %3, i64 %.589.010691
  store i64 0, ptr %.709.i, align 8, !noalias !0
  br i1 %.8051131.not.i, label %B402.i, label %B358.if.lr.ph.i

B358.if.lr.ph.i:                                  ; preds = %B132.i
  %.867.i = select i1 %.438.i, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i = add i64 %.867.i, %.236.i
  %.888.i = mul i64 %.868.i, %arg.batch.0.1.5.1
  %10 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i
  %invariant.gep10894 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.589.010691
  br label %B358.if.i

B402.i:                                           ; preds = %B358.if.i, %B132.i
  br i1 %.175.i1134.not.i, label %B402.endif.i, label %B76.if.i.lr.ph.i

B76.if.i.lr.ph.i:                                 ; preds = %B402.i
  %.990.i = load i64, ptr %.595.i, align 8, !noalias !0
  %.236.i.i = icmp slt i64 %.990.i, 0
  %.237.i.i10351 = select i1 %.236.i.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i = add i64 %.237.i.i10351, %.990.i
  %.258.i.i = mul i64 %.238.i.i, %arg.batch.1.3.5.1
  %11 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i
  br label %B76.if.i.i10352

B76.if.i.i10352:                                  ; preds = %B76.if.i.i10352, %B76.if.i.lr.ph.i
  %.117.i.01135.i = phi i64 [ 0, %B76.if.i.lr.ph.i ], [ %.188.i.i, %B76.if.i.i10352 ]
  %.188.i.i = add nsw i64 %.117.i.01135.i, 1
  %12 = getelementptr double, ptr %11, i64 %.117.i.01135.i
  %.263.i.i = load double, ptr %12, align 8, !noalias !3
  %13 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i
  %.293.i.i = load i64, ptr %13, align 8, !noalias !3
  %.295.i.i10353 = mul nsw i64 %.293.i.i, %arg.shape.0
  %.297.i.i = add nsw i64 %.295.i.i10353, %.589.010691
  %.311.i.i = icmp slt i64 %.297.i.i, 0
  %.312.i.i = select i1 %.311.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %14 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i
  %.326.i.i = getelementptr double, ptr %14, i64 %.312.i.i
  store double %.263.i.i, ptr %.326.i.i, align 8, !noalias !3
  %exitcond1142.not.i = icmp eq i64 %.188.i.i, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i, label %B402.endif.i, label %B76.if.i.i10352

B888.i:                                           ; preds = %B580.if.i
  store double 0.000000e+00, ptr %.1877.i, align 8, !noalias !0
  br label %B340

B358.if.i:                                        ; preds = %B358.if.i, %B358.if.lr.ph.i
  %.747.01132.i = phi i64 [ 0, %B358.if.lr.ph.i ], [ %.818.i, %B358.if.i ]
  %.818.i = add nsw i64 %.747.01132.i, 1
  %15 = getelementptr double, ptr %10, i64 %.747.01132.i
  %.893.i = load double, ptr %15, align 8, !noalias !0
  %.895.i = mul nsw i64 %.747.01132.i, %arg.shape.0
  %gep10895 = getelementptr double, ptr %invariant.gep10894, i64 %.895.i
  store double %.893.i, ptr %gep10895, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.818.i, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i, label %B402.i, label %B358.if.i

B402.endif.i:                                     ; preds = %B76.if.i.i10352, %B402.i
  br i1 %.11171137.not.i, label %B580.if.i, label %B496.if.lr.ph.i

B496.if.lr.ph.i:                                  ; preds = %B402.endif.i
  %.1179.i = select i1 %.438.i, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i = add i64 %.1179.i, %.236.i
  %.1200.i = mul i64 %.1180.i, %arg.batch.0.0.5.1
  %16 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i
  %invariant.gep10896 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.589.010691
  br label %B496.if.i

B496.if.i:                                        ; preds = %B496.if.i, %B496.if.lr.ph.i
  %.1061.01138.i = phi i64 [ 0, %B496.if.lr.ph.i ], [ %.1130.i, %B496.if.i ]
  %.1130.i = add nsw i64 %.1061.01138.i, 1
  %17 = getelementptr double, ptr %16, i64 %.1061.01138.i
  %.1205.i = load double, ptr %17, align 8, !noalias !0
  %.1207.i = mul nsw i64 %.1061.01138.i, %arg.shape.0
  %gep10897 = getelementptr double, ptr %invariant.gep10896, i64 %.1207.i
  store double %.1205.i, ptr %gep10897, align 8, !noalias !0
  %exitcond1143.not.i = icmp eq i64 %.1130.i, %arg.shape.1
  br i1 %exitcond1143.not.i, label %B580.if.i, label %B496.if.i

B580.if.i:                                        ; preds = %B496.if.i, %B402.endif.i
  %invariant.gep.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.589.010691
  store double 0.000000e+00, ptr %invariant.gep.i, align 8, !noalias !0
  %gep.1.i = getelementptr double, ptr %invariant.gep.i, i64 %arg.batch.4.0.5.1
  store double 0.000000e+00, ptr %gep.1.i, align 8, !noalias !0
  %gep.2.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.2.idx.i
  store double 0.000000e+00, ptr %gep.2.i, align 8, !noalias !0
  %gep.3.i = getelementptr i8, ptr %invariant.gep.i, i64 %.idx.i
  store double 0.000000e+00, ptr %gep.3.i, align 8, !noalias !0
  %gep.4.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.4.idx.i
  store double 0.000000e+00, ptr %gep.4.i, align 8, !noalias !0
  %gep.5.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.5.idx.i
  store double 0.000000e+00, ptr %gep.5.i, align 8, !noalias !0
  %gep.6.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.6.idx.i
  store double 0.000000e+00, ptr %gep.6.i, align 8, !noalias !0
  %gep.7.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.7.idx.i
  store double 0.000000e+00, ptr %gep.7.i, align 8, !noalias !0
  %gep.8.i = getelementptr i8, ptr %invariant.gep.i, i64 %.502.idx
  store double 0.000000e+00, ptr %gep.8.i, align 8, !noalias !0
  %gep.9.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.9.idx.i
  store double 0.000000e+00, ptr %gep.9.i, align 8, !noalias !0
  %gep.10.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.10.idx.i
  store double 0.000000e+00, ptr %gep.10.i, align 8, !noalias !0
  %gep.11.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.11.idx.i
  store double 0.000000e+00, ptr %gep.11.i, align 8, !noalias !0
  %gep.12.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.12.idx.i
  store double 0.000000e+00, ptr %gep.12.i, align 8, !noalias !0
  %gep.13.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.13.idx.i
  store double 0.000000e+00, ptr %gep.13.i, align 8, !noalias !0
  %gep.14.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.14.idx.i
  store double 0.000000e+00, ptr %gep.14.i, align 8, !noalias !0
  %gep.15.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.15.idx.i
  store double 0.000000e+00, ptr %gep.15.i, align 8, !noalias !0
  %gep.16.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.16.idx.i
  store double 0.000000e+00, ptr %gep.16.i, align 8, !noalias !0
  %gep.17.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.17.idx.i
  store double 0.000000e+00, ptr %gep.17.i, align 8, !noalias !0
  %gep.18.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.18.idx.i
  store double 0.000000e+00, ptr %gep.18.i, align 8, !noalias !0
  %gep.19.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.19.idx.i
  store double 0.000000e+00, ptr %gep.19.i, align 8, !noalias !0
  %gep.20.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.20.idx.i
  store double 0.000000e+00, ptr %gep.20.i, align 8, !noalias !0
  %gep.21.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.21.idx.i
  store double 0.000000e+00, ptr %gep.21.i, align 8, !noalias !0
  %gep.22.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.22.idx.i
  store double 0.000000e+00, ptr %gep.22.i, align 8, !noalias !0
  %gep.23.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.23.idx.i
  store double 0.000000e+00, ptr %gep.23.i, align 8, !noalias !0
  %gep.24.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.24.idx.i
  store double 0.000000e+00, ptr %gep.24.i, align 8, !noalias !0
  %gep.25.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.25.idx.i
  store double 0.000000e+00, ptr %gep.25.i, align 8, !noalias !0
  %gep.26.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.26.idx.i
  store double 0.000000e+00, ptr %gep.26.i, align 8, !noalias !0
  %gep.27.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.27.idx.i
  store double 0.000000e+00, ptr %gep.27.i, align 8, !noalias !0
  %gep.28.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.28.idx.i
  store double 0.000000e+00, ptr %gep.28.i, align 8, !noalias !0
  %gep.29.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.29.idx.i
  store double 0.000000e+00, ptr %gep.29.i, align 8, !noalias !0
  %.1455.i = load double, ptr %arg.batch.2.4, align 8, !noalias !0
  %.1516.i = load i64, ptr %.595.i, align 8, !noalias !0
  %.1531.i = icmp slt i64 %.1516.i, 0
  %.1532.i = select i1 %.1531.i, i64 %arg.batch.1.2.5.0, i64 0
  %18 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i
  %.1546.i = getelementptr double, ptr %18, i64 %.1532.i
  %.1547.i = load double, ptr %.1546.i, align 8, !noalias !0
  store double %.1455.i, ptr %invariant.gep.i, align 8, !noalias !0
  %.1656.i = getelementptr double, ptr %4, i64 %.589.010691
  store double %.1547.i, ptr %.1656.i, align 8, !noalias !0
  store double 1.000000e+00, ptr %.293.i, align 8, !noalias !0
  %.1767.i = getelementptr double, ptr %5, i64 %.589.010691
  store double 0xFFF0000000000000, ptr %.1767.i, align 8, !noalias !0
  %.1822.i = getelementptr double, ptr %6, i64 %.589.010691
  store double 0x7FF0000000000000, ptr %.1822.i, align 8, !noalias !0
  %.1877.i = getelementptr double, ptr %7, i64 %.589.010691
  %.1878.i = load double, ptr %.1877.i, align 8, !noalias !0
  %.1880.i = fcmp ueq double %.1878.i, 0xFFF0000000000000
  br i1 %.1880.i, label %B340, label %B888.i

B340:                                             ; preds = %B888.i, %B296, %B580.if.i, %B254.if
  %.880 = load i64, ptr %270, align 8
  %.881 = icmp sgt i64 %.880, -1
  %. = zext i1 %.881 to i64
  %.898 = add nsw i64 %active.4.010693, %.
  %.647 = icmp sgt i64 %.592.010692, 1
  br i1 %.647, label %B254.if, label %B394

B394:                                             ; preds = %B340, %entry
  %active.4.0.lcssa = phi i64 [ 0, %entry ], [ %.898, %B340 ]
  %.915.not = icmp ne i64 %active.4.0.lcssa, 0
  %.937 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.915.not, i1 %.937, i1 false
  br i1 %or.cond, label %B422.preheader, label %B4600

B422.preheader:                                   ; preds = %B394
  %.981 = getelementptr i8, ptr %arg.batch.4.2.4, i64 16
  %factor.op.mul = shl i64 %arg.shape.1, 4
  %factor.op.mul10854 = shl i64 %arg.shape.1, 4
  %.1077 = getelementptr i8, ptr %arg.code.4, i64 8
  %.1129 = icmp sgt i64 %arg.shape.6, 0
  %.162.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx10320 = mul i64 %arg.batch.4.0.5.1, 24
  %19 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10320
  %.537.i10694 = icmp slt i64 %arg.shape.6, 1
  %.691.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.1190.not = icmp eq i64 %arg.shape.3, 0
  %.1220 = getelementptr i8, ptr %arg.code.4, i64 16
  %.1347.idx = shl i64 %.394, 4
  %.1347 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1347.idx
  %.1378 = getelementptr i8, ptr %arg.code.4, i64 72
  %.1454 = getelementptr i8, ptr %arg.code.4, i64 80
  %.1555.idx = mul i64 %.394, 136
  %.1555 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1555.idx
  %.1580.idx = mul i64 %.394, 24
  %.1580 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1580.idx
  %.1611 = getelementptr i8, ptr %arg.code.4, i64 88
  %.idx10312 = mul i64 %arg.batch.4.0.5.1, 24
  %20 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10312
  %.idx10313 = shl i64 %arg.batch.4.0.5.1, 5
  %21 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10313
  %.idx10314 = shl i64 %arg.batch.4.0.5.1, 8
  %22 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10314
  %.10321 = select i1 %.543.not, i64 2, i64 0
  %.idx10315 = mul i64 %arg.batch.4.0.5.1, 88
  %23 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10315
  %.idx10316 = shl i64 %arg.batch.4.0.5.1, 4
  %24 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10316
  %.idx10317 = shl i64 %arg.batch.4.1.5.1, 4
  %25 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10317
  %.idx10318 = shl i64 %arg.batch.4.0.5.1, 4
  %26 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10318
  %.idx10319 = mul i64 %arg.batch.4.0.5.1, 152
  %27 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10319
  %.1756 = getelementptr i8, ptr %arg.code.4, i64 56
  %.1882 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.394
  %.127.i = mul nsw i64 %arg.shape.1, %arg.shape.1
  %.174.not.i = icmp slt i64 %.127.i, %arg.linear.0.5.0
  %.344.i = icmp slt i64 %arg.linear.1.5.0, 6
  %.524.idx.i = shl i64 %arg.batch.4.0.5.1, 5
  %.524.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.524.idx.i
  %.123.i.i = shl nsw i64 %arg.shape.1, 1
  %.124.i.i = add nsw i64 %.123.i.i, 5
  %.153.i.i = getelementptr i8, ptr %arg.linear.1.4, i64 24
  %.183.i.i = getelementptr i8, ptr %arg.linear.1.4, i64 32
  %.186.i.i = add nsw i64 %.124.i.i, %arg.shape.1
  %.187.i.i = add nsw i64 %.186.i.i, 1
  %.224.i.i10362 = icmp slt i64 %arg.shape.1, -2
  %.225.i.i = select i1 %.224.i.i10362, i64 %arg.linear.1.5.0, i64 0
  %.226.i.i = add i64 %.225.i.i, %.124.i.i
  %.229.i.i10363 = icmp slt i64 %.226.i.i, 0
  %.234.i.i = icmp sge i64 %.226.i.i, %arg.linear.1.5.0
  %28 = or i1 %.229.i.i10363, %.234.i.i
  %.241.i.i = icmp slt i64 %.186.i.i, -1
  %.242.i.i = select i1 %.241.i.i, i64 %arg.linear.1.5.0, i64 0
  %.243.i.i10364 = add i64 %.242.i.i, %.187.i.i
  %.246.i.i = icmp slt i64 %.243.i.i10364, 0
  %.251.i.not.i = icmp slt i64 %.243.i.i10364, %arg.linear.1.5.0
  %.409.i.i = icmp sge i64 %.243.i.i10364, %arg.linear.1.5.0
  %29 = or i1 %.246.i.i, %.409.i.i
  %.538.i.i = add nsw i64 %arg.shape.1, 1
  %.539.i.i = add i64 %.124.i.i, %.538.i.i
  %.1162.i2263.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx2305.i = mul i64 %arg.shape.1, 136
  %.idx2306.i = mul i64 %arg.shape.1, 88
  %.1461.i.i = getelementptr i8, ptr %arg.linear.1.4, i64 16
  %storemerge2243.i = tail call i64 @llvm.smax.i64(i64 %.538.i.i, i64 0)
  %.1556.i2266.not.i = icmp slt i64 %arg.shape.1, 0
  %.1716.i.i = getelementptr i8, ptr %arg.code.4, i64 48
  %.1789.i.i = mul nsw i64 %arg.shape.1, 12
  %.1807.i.idx.i = mul i64 %arg.shape.1, 136
  %.1807.i.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1807.i.idx.i
  %.1832.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1789.i.i
  %.150.i.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.586.i.i.idx.i = mul i64 %arg.batch.4.0.5.1, 48
  %.586.i.i.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.586.i.i.idx.i
  %.597.i.i.i = mul nsw i64 %arg.shape.1, 18
  %.615.i.i.i = select i1 %.1556.i2266.not.i, i64 %arg.batch.5.0.5.0, i64 0
  %.idx.i10367 = mul i64 %arg.shape.1, 152
  %30 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i10367
  %.629.i.i.i = getelementptr double, ptr %30, i64 %.615.i.i.i
  %.944.i.i.i = mul nsw i64 %arg.shape.1, 17
  %.2622.i.i = mul nsw i64 %arg.shape.1, 11
  %.idx2307.i = mul i64 %arg.shape.1, 144
  %invariant.gep = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx2307.i
  %.idx2308.i = mul i64 %arg.shape.1, 144
  %.1276.i.i.idx.i = mul i64 %arg.shape.1, 96
  %.1276.i.i.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1276.i.i.idx.i
  %.1276.i.i.idx.c.i = mul i64 %arg.shape.1, 96
  %.1276.i.i.c.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1276.i.i.idx.c.i
  %.1276.i.i.1.idx.i = mul i64 %arg.shape.1, 104
  %.1276.i.i.1.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1276.i.i.1.idx.i
  %.idx2310.i = mul i64 %arg.shape.1, 96
  %.663.i = getelementptr i8, ptr %arg.linear.1.4, i64 8
  %.711.i = icmp sgt i64 %arg.shape.1, 0
  %.743.sroa.0.02242.i = add i64 %arg.shape.1, 1
  %.1140.idx.i = mul i64 %arg.batch.4.0.5.1, 144
  %.1140.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.1140.idx.i
  %.1984 = add i64 %arg.shape.2, -1
  %storemerge10235 = tail call i64 @llvm.smax.i64(i64 %.1984, i64 0)
  %.202710707.not = icmp slt i64 %.1984, 1
  %.2200.idx = mul i64 %.394, 136
  %.2200 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.2200.idx
  %.42.i = mul nsw i64 %arg.shape.1, %arg.shape.1
  %.88.not.i = icmp slt i64 %.42.i, %arg.linear.0.5.0
  %.218.i = add nsw i64 %arg.shape.1, 5
  %.265.i = icmp slt i64 %arg.linear.1.5.0, 6
  %.272.i10371 = icmp slt i64 %arg.shape.1, -5
  %.273.i = select i1 %.272.i10371, i64 %arg.linear.1.5.0, i64 0
  %.274.i = add i64 %.218.i, %.273.i
  %.277.i = icmp slt i64 %.274.i, 0
  %.282.not.i = icmp slt i64 %.274.i, %arg.linear.1.5.0
  %.648747.not.i = icmp slt i64 %arg.shape.1, 1
  %.756.i = mul nsw i64 %arg.shape.1, 17
  %.idx.i10373 = mul i64 %arg.shape.1, 80
  %invariant.gep10703 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i10373
  %.882.i = getelementptr i8, ptr %arg.linear.1.4, i64 8
  %.887.i = mul nsw i64 %arg.shape.1, 17
  %invariant.gep10705 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.887.i
  %.2303 = getelementptr i8, ptr %arg.code.4, i64 64
  %.2380 = icmp sgt i64 %arg.shape.3, 0
  %.2385 = icmp sgt i64 %arg.shape.6, 0
  %.idx10310 = mul i64 %arg.batch.4.0.5.1, 40
  %31 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10310
  %.idx10311 = mul i64 %arg.batch.4.0.5.1, 168
  %32 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10311
  %.idx10307 = mul i64 %arg.batch.4.0.5.1, 176
  %33 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10307
  %.idx10308 = mul i64 %arg.batch.4.0.5.1, 184
  %34 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10308
  %.idx10309 = mul i64 %arg.batch.4.0.5.1, 160
  %35 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10309
  %.idx10301 = shl i64 %arg.batch.4.1.5.1, 4
  %36 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10301
  %.idx10302 = mul i64 %arg.batch.4.0.5.1, 192
  %37 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10302
  %.idx10303 = mul i64 %arg.batch.4.0.5.1, 72
  %38 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10303
  %.idx10304 = mul i64 %arg.batch.4.0.5.1, 40
  %39 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10304
  %.idx10305 = mul i64 %arg.batch.4.0.5.1, 240
  %40 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10305
  %.idx10306 = mul i64 %arg.batch.4.0.5.1, 56
  %41 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10306
  %.3773.idx = mul i64 %.394, 136
  %.3773 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3773.idx
  %.3798.idx = mul i64 %.394, 104
  %.3798 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3798.idx
  %.3836 = getelementptr i8, ptr %arg.code.4, i64 240
  %.3930 = getelementptr i8, ptr %arg.code.4, i64 112
  %.idx10300 = shl i64 %arg.batch.4.1.5.1, 5
  %42 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10300
  %.671.i2337 = getelementptr i8, ptr %arg.code.4, i64 40
  %.742.i2391 = mul i64 %arg.shape.1, %arg.shape.0
  %.idx10297 = mul i64 %arg.batch.4.0.5.1, 48
  %43 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10297
  %.287.i.i10733.not = icmp slt i64 %arg.shape.1, 1
  %.358.i.i = shl nsw i64 %arg.shape.1, 4
  %.idx10293 = mul i64 %arg.batch.4.0.5.1, 40
  %44 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10293
  %.idx10294 = shl i64 %arg.batch.4.1.5.1, 5
  %45 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10294
  %.idx10295 = mul i64 %arg.batch.4.0.5.1, 104
  %46 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10295
  %.idx10296 = mul i64 %arg.batch.4.0.5.1, 112
  %47 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10296
  %.idx10289 = mul i64 %arg.batch.4.0.5.1, 56
  %48 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10289
  %.4311.idx = mul i64 %.394, 136
  %.4311 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4311.idx
  %.4374 = getelementptr i8, ptr %arg.code.4, i64 208
  %.4451 = getelementptr i8, ptr %arg.code.4, i64 104
  %.idx10282 = shl i64 %arg.batch.4.1.5.1, 4
  %49 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10282
  %.idx10283 = mul i64 %arg.batch.4.0.5.1, 40
  %50 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10283
  %.idx10284 = mul i64 %arg.batch.4.0.5.1, 56
  %51 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10284
  %.idx10285 = mul i64 %arg.batch.4.0.5.1, 224
  %52 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10285
  %.idx10286 = mul i64 %arg.batch.4.0.5.1, 48
  %53 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10286
  %.idx10287 = shl i64 %arg.batch.4.0.5.1, 5
  %54 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10287
  %55 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx10288 = mul i64 %arg.batch.4.0.5.1, 232
  %56 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10288
  %.4451.c = getelementptr i8, ptr %arg.code.4, i64 104
  %.idx10281 = shl i64 %arg.batch.4.1.5.1, 5
  %57 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10281
  %.671.i3587 = getelementptr i8, ptr %arg.code.4, i64 40
  %.742.i3643 = mul i64 %arg.shape.1, %arg.shape.0
  %.idx10278 = mul i64 %arg.batch.4.0.5.1, 48
  %58 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10278
  %.287.i.i441810761.not = icmp slt i64 %arg.shape.1, 1
  %.358.i.i4572 = shl nsw i64 %arg.shape.1, 4
  %.idx10273 = mul i64 %arg.batch.4.0.5.1, 40
  %59 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10273
  %.idx10274 = shl i64 %arg.batch.4.1.5.1, 5
  %60 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10274
  %storemerge10275 = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.idx10276 = mul i64 %arg.batch.4.0.5.1, 104
  %61 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10276
  %.idx10277 = mul i64 %arg.batch.4.0.5.1, 112
  %62 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10277
  %.idx10269 = mul i64 %arg.batch.4.0.5.1, 56
  %63 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10269
  %64 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.223.i = getelementptr i8, ptr %64, i64 -8
  %.708.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.779.i.reass = mul i64 %factor.op.mul, %arg.shape.0
  %.799.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.779.i.reass
  %.idx1472.i = mul i64 %arg.batch.4.0.5.1, 104
  %65 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1472.i
  %.idx1473.i = mul i64 %arg.batch.4.0.5.1, 112
  %66 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1473.i
  %.idx1474.i = mul i64 %arg.batch.4.0.5.1, 48
  %67 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1474.i
  %storemerge1476.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.1, i64 0)
  %.287.i1483.not.i = icmp slt i64 %arg.shape.1, 1
  %.358.i.i10384 = shl nsw i64 %arg.shape.1, 4
  %.idx1468.i = shl i64 %arg.batch.4.1.5.1, 5
  %68 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1468.i
  %storemerge1471.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.155.i.i.i10388 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx.i10400 = mul i64 %arg.batch.4.0.5.1, 56
  %69 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i10400
  %.idx1459.i = shl i64 %arg.batch.4.0.5.1, 7
  %70 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1459.i
  %.190.i211.i = mul nsw i64 %arg.shape.1, 17
  %.254.i.i10401 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.idx1461.i = mul i64 %arg.batch.4.0.5.1, 96
  %71 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1461.i
  %.idx1463.i = mul i64 %arg.batch.4.0.5.1, 40
  %72 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1463.i
  %.idx1464.i = shl i64 %arg.batch.4.0.5.1, 5
  %73 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1464.i
  %74 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.4719.not = icmp eq i64 %arg.shape.3, 0
  %.10332 = select i1 %.543.not, i64 16, i64 1
  %.526.i10424 = getelementptr i8, ptr %arg.code.4, i64 16
  %.597.i.reass = mul i64 %factor.op.mul10854, %arg.shape.0
  %.617.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.597.i.reass
  %.452.i = uitofp i64 %.10332 to double
  %.idx673.i = mul i64 %arg.batch.4.0.5.1, 48
  %75 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx673.i
  %.287.i679.not.i = icmp slt i64 %arg.shape.1, 1
  %.358.i.i10425 = shl nsw i64 %arg.shape.1, 4
  %.idx.i10426 = mul i64 %arg.batch.4.0.5.1, 40
  %76 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i10426
  %.155.i.i.i10436 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i10443 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i10449 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i10455 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i10461 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i10467 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i10473 = mul nsw i64 %arg.shape.1, 18
  %factor.op.mul652.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx.i10491 = shl i64 %arg.batch.4.1.5.1, 4
  %77 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx.i10491
  %.idx640.i = mul i64 %arg.batch.4.0.5.1, 40
  %78 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx640.i
  %.idx641.i = mul i64 %arg.batch.4.0.5.1, 48
  %79 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx641.i
  %.idx642.i = mul i64 %arg.batch.4.0.5.1, 56
  %80 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx642.i
  %.924649.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx644.i = mul i64 %arg.batch.4.0.5.1, 232
  %81 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx644.i
  %.1000.i = mul nsw i64 %arg.shape.1, 17
  %82 = add i64 %arg.batch.2.5.0, -1
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.4955 = icmp sgt i64 %arg.shape.0, 1
  %.5009.idx = mul i64 %arg.batch.4.0.5.1, 40
  %.5009 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.5009.idx
  %.5041 = getelementptr i8, ptr %arg.code.4, i64 96
  %.idx10260 = mul i64 %arg.batch.4.0.5.1, 40
  %83 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10260
  %.idx10261 = mul i64 %arg.batch.4.0.5.1, 96
  %84 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10261
  %.idx10262 = mul i64 %arg.batch.4.0.5.1, 120
  %85 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10262
  %.555.i638110832.not = icmp slt i64 %arg.shape.1, 1
  %.700.i6418 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %86 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.745.i6447 = getelementptr i8, ptr %86, i64 -8
  %.idx10264 = mul i64 %arg.batch.4.1.5.1, 24
  %87 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10264
  %.idx10265 = mul i64 %arg.batch.4.1.5.1, 24
  %88 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10265
  %.idx10266 = mul i64 %arg.batch.4.0.5.1, 24
  %89 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10266
  %.idx10267 = shl i64 %arg.batch.4.0.5.1, 7
  %90 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10267
  %.idx10268 = shl i64 %arg.batch.4.0.5.1, 7
  %91 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10268
  %.5157.not = icmp ne i64 %arg.shape.4, 0
  %storemerge.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.0, i64 0)
  %.idx1632.i = mul i64 %arg.batch.4.0.5.1, 40
  %92 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1632.i
  %.idx1633.i = shl i64 %arg.batch.4.0.5.1, 4
  %93 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1633.i
  %94 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.175.i3061635.not.i = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.636.i10516 = getelementptr i8, ptr %arg.code.4, i64 8
  %.779.i10519 = getelementptr i8, ptr %arg.code.4, i64 32
  %.850.i = mul nsw i64 %arg.shape.1, 17
  %.852.i = mul nsw i64 %.850.i, %arg.shape.0
  %.895.i10520 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.852.i
  %.900.not.i = icmp eq i64 %arg.shape.3, 0
  %.930.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx1630.i = shl i64 %arg.batch.4.1.5.1, 4
  %95 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1630.i
  %.15441642.not.i = icmp slt i64 %arg.shape.1, 1
  %.1739.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx10249 = mul i64 %arg.batch.4.0.5.1, 40
  %96 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10249
  %.idx10250 = shl i64 %arg.batch.4.0.5.1, 4
  %97 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10250
  %98 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx10251 = mul i64 %arg.batch.4.0.5.1, 24
  %99 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10251
  %.175.i.i779710844.not = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.idx10254 = shl i64 %arg.batch.4.1.5.1, 4
  %100 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10254
  %.idx.i10532 = mul i64 %arg.batch.4.0.5.1, 24
  %101 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i10532
  %.323.i10534 = getelementptr i8, ptr %arg.batch.4.2.4, i64 8
  %102 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx1124.i10554 = mul i64 %arg.batch.4.1.5.1, 24
  %103 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1124.i10554
  %.8051131.not.i10556 = icmp slt i64 %arg.batch.0.1.5.1, 1
  %.175.i1134.not.i10572 = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.11171137.not.i10591 = icmp slt i64 %arg.shape.1, 1
  %gep.2.idx.i10609 = shl i64 %arg.batch.4.0.5.1, 4
  %gep.4.idx.i10613 = shl i64 %arg.batch.4.0.5.1, 5
  %gep.6.idx.i10617 = mul i64 %arg.batch.4.0.5.1, 48
  %gep.7.idx.i10619 = mul i64 %arg.batch.4.0.5.1, 56
  %gep.9.idx.i10623 = mul i64 %arg.batch.4.0.5.1, 72
  %gep.10.idx.i10625 = mul i64 %arg.batch.4.0.5.1, 80
  %gep.11.idx.i10627 = mul i64 %arg.batch.4.0.5.1, 88
  %gep.12.idx.i10629 = mul i64 %arg.batch.4.0.5.1, 96
  %gep.13.idx.i10631 = mul i64 %arg.batch.4.0.5.1, 104
  %gep.14.idx.i10633 = mul i64 %arg.batch.4.0.5.1, 112
  %gep.15.idx.i10635 = mul i64 %arg.batch.4.0.5.1, 120
  %gep.16.idx.i10637 = shl i64 %arg.batch.4.0.5.1, 7
  %gep.17.idx.i10639 = mul i64 %arg.batch.4.0.5.1, 136
  %gep.18.idx.i10641 = mul i64 %arg.batch.4.0.5.1, 144
  %gep.19.idx.i10643 = mul i64 %arg.batch.4.0.5.1, 152
  %gep.20.idx.i10645 = mul i64 %arg.batch.4.0.5.1, 160
  %gep.21.idx.i10647 = mul i64 %arg.batch.4.0.5.1, 168
  %gep.22.idx.i10649 = mul i64 %arg.batch.4.0.5.1, 176
  %gep.23.idx.i10651 = mul i64 %arg.batch.4.0.5.1, 184
  %gep.24.idx.i10653 = mul i64 %arg.batch.4.0.5.1, 192
  %gep.25.idx.i10655 = mul i64 %arg.batch.4.0.5.1, 200
  %gep.26.idx.i10657 = mul i64 %arg.batch.4.0.5.1, 208
  %gep.27.idx.i10659 = mul i64 %arg.batch.4.0.5.1, 216
  %gep.28.idx.i10661 = mul i64 %arg.batch.4.0.5.1, 224
  %gep.29.idx.i10663 = mul i64 %arg.batch.4.0.5.1, 232
  %104 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i10609
  %105 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.15.idx.i10635
  %106 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.29.idx.i10663
  %.idx1130.i10678 = mul i64 %arg.batch.4.0.5.1, 240
  %107 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i10678
  %.idx10253 = mul i64 %arg.batch.4.0.5.1, 240
  %108 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10253
  %.6223 = tail call i64 @llvm.smin.i64(i64 %arg.batch.2.5.0, i64 0)
  %109 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %110 = getelementptr i8, ptr %109, i64 -8
  %.6237 = getelementptr double, ptr %110, i64 %.6223
  %111 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx10255 = mul i64 %arg.batch.4.0.5.1, 240
  %112 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10255
  %.idx10256 = mul i64 %arg.batch.4.0.5.1, 160
  %113 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10256
  %.idx10257 = shl i64 %arg.batch.4.1.5.1, 4
  %114 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10257
  %.idx10258 = shl i64 %arg.batch.4.0.5.1, 4
  %115 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10258
  %.idx10259 = mul i64 %arg.batch.4.0.5.1, 152
  %116 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10259
  %.155.i.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.i.1 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.i.2 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.i.3 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.i.4 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.i.5 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.i.6 = mul nsw i64 %arg.shape.1, 18
  %117 = getelementptr i8, ptr %arg.code.4, i64 216
  %.4336.idx = mul i64 %.394, 112
  %.4336 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4336.idx
  %118 = getelementptr i8, ptr %arg.code.4, i64 224
  %.4336.1.idx = mul i64 %.394, 120
  %.4336.1 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4336.1.idx
  %119 = getelementptr i8, ptr %arg.code.4, i64 232
  %.4336.2.idx = shl i64 %.394, 7
  %.4336.2 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4336.2.idx
  %.155.i.i.i4609 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.i4609.1 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.i4609.2 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.i4609.3 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.i4609.4 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.i4609.5 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.i4609.6 = mul nsw i64 %arg.shape.1, 18
  br label %B422

B422:                                             ; preds = %B422.preheader, %B4574
  %budget.3.1 = phi i64 [ %budget.4.2, %B4574 ], [ %arg.budget, %B422.preheader ]
  %looked.3.1 = phi i1 [ %looked.4.2.lcssa, %B4574 ], [ true, %B422.preheader ]
  %active.9.1 = phi i64 [ %active.8.2, %B4574 ], [ %active.4.0.lcssa, %B422.preheader ]
  %.947 = add nsw i64 %budget.3.1, -1
  %.982 = load i64, ptr %.981, align 8
  %.983 = icmp eq i64 %.982, 1
  %.1017 = icmp sgt i64 %.982, 0
  br i1 %.1017, label %B490, label %B568

B490:                                             ; preds = %B422
  store i64 0, ptr %.981, align 8
  %.1078 = load i64, ptr %.1077, align 8
  %.1123 = inttoptr i64 %.1078 to ptr
  tail call void %.1123(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B568

B568:                                             ; preds = %B490, %B422
  br i1 %.983, label %B574, label %B1140

B574:                                             ; preds = %B568
  br i1 %.1129, label %B586, label %B622

B586:                                             ; preds = %B574
  %.163.i = load i64, ptr %.162.i, align 8, !noalias !7
  %.275.i = inttoptr i64 %.163.i to ptr
  tail call void %.275.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br i1 %.603, label %B326.i, label %B194.if.i

B324.i:                                           ; preds = %B266.if.i, %B194.if.i
  %.359.i = icmp sgt i64 %.304.i.010699, 1
  br i1 %.359.i, label %B194.if.i, label %B326.i

B326.i:                                           ; preds = %B324.i, %B586
  %.692.i = load i64, ptr %.691.i, align 8, !noalias !7
  %.808.i = inttoptr i64 %.692.i to ptr
  tail call void %.808.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br label %B622

B194.if.i:                                        ; preds = %B586, %B324.i
  %.304.i.010699 = phi i64 [ %.368.i, %B324.i ], [ %storemerge, %B586 ]
  %.301.i.010698 = phi i64 [ %.372.i, %B324.i ], [ 0, %B586 ]
  %.368.i = add nsw i64 %.304.i.010699, -1
  %.372.i = add nsw i64 %.301.i.010698, 1
  %120 = getelementptr double, ptr %19, i64 %.301.i.010698
  %.454.i = load double, ptr %120, align 8, !noalias !7
  %.455.i = fcmp ule double %.454.i, 5.000000e-01
  %brmerge10858 = select i1 %.455.i, i1 true, i1 %.537.i10694
  br i1 %brmerge10858, label %B324.i, label %B266.if.i.preheader

B266.if.i.preheader:                              ; preds = %B194.if.i
  %invariant.gep10898 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.301.i.010698
  br label %B266.if.i

B266.if.i:                                        ; preds = %B266.if.i.preheader, %B266.if.i
  %.481.i.010695 = phi i64 [ %.550.i, %B266.if.i ], [ 0, %B266.if.i.preheader ]
  %.550.i = add nsw i64 %.481.i.010695, 1
  %.576.i = mul nsw i64 %.481.i.010695, %arg.shape.0
  %gep10899 = getelementptr double, ptr %invariant.gep10898, i64 %.576.i
  %.608.i = load double, ptr %gep10899, align 8, !noalias !7
  %.610.i = add nsw i64 %.481.i.010695, %arg.shape.5
  %.612.i = mul nsw i64 %.610.i, %arg.shape.0
  %.614.i = add nsw i64 %.612.i, %.301.i.010698
  %.628.i = icmp slt i64 %.614.i, 0
  %.629.i = select i1 %.628.i, i64 %arg.batch.5.1.5.0, i64 0
  %121 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.614.i
  %.643.i = getelementptr double, ptr %121, i64 %.629.i
  store double %.608.i, ptr %.643.i, align 8, !noalias !7
  %exitcond.not = icmp eq i64 %.550.i, %arg.shape.6
  br i1 %exitcond.not, label %B324.i, label %B266.if.i

B622:                                             ; preds = %B326.i, %B574
  br i1 %.1190.not, label %B694, label %B626

B626:                                             ; preds = %B622
  %.1221 = load i64, ptr %.1220, align 8
  %.1266 = inttoptr i64 %.1221 to ptr
  tail call void %.1266(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B694

B694:                                             ; preds = %B626, %B622
  br i1 %.543.not, label %B698, label %B1098

B698:                                             ; preds = %B694
  %.1300 = load i64, ptr %arg.code.4, align 8
  %.1348 = inttoptr i64 %.1300 to ptr
  tail call void %.1348(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1347)
  %.1379 = load i64, ptr %.1378, align 8
  %.1424 = inttoptr i64 %.1379 to ptr
  tail call void %.1424(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.1455 = load i64, ptr %.1454, align 8
  %.1500 = inttoptr i64 %.1455 to ptr
  tail call void %.1500(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.1531 = load i64, ptr %arg.code.4, align 8
  %.1581 = inttoptr i64 %.1531 to ptr
  tail call void %.1581(ptr %.502, ptr %.1555, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1580)
  %.1612 = load i64, ptr %.1611, align 8
  %.1657 = inttoptr i64 %.1612 to ptr
  tail call void %.1657(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B1098

B1098:                                            ; preds = %B698, %B694
  br i1 %.603, label %B1140, label %B64.if.i

B106.i:                                           ; preds = %B64.if.i
  store double 0.000000e+00, ptr %.323.i132, align 8, !noalias !11
  %.441.i = getelementptr double, ptr %21, i64 %.170.i.010701
  store double 0.000000e+00, ptr %.441.i, align 8, !noalias !11
  %.496.i215 = getelementptr double, ptr %22, i64 %.170.i.010701
  store double 0.000000e+00, ptr %.496.i215, align 8, !noalias !11
  %.551.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.170.i.010701
  %.552.i245 = load i64, ptr %.551.i, align 8, !noalias !11
  %.579.i257 = icmp slt i64 %.552.i245, 0
  %.580.i258 = select i1 %.579.i257, i64 %arg.batch.3.3.5.0, i64 0
  %.581.i = add i64 %.580.i258, %.552.i245
  %.601.i272 = mul i64 %.581.i, %arg.batch.3.3.5.1
  %122 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.601.i272
  %.605.i = getelementptr i8, ptr %122, i64 8
  %.606.i = load i64, ptr %.605.i, align 8, !noalias !11
  %.628.i284 = add nsw i64 %.606.i, %.10321
  store i64 %.628.i284, ptr %.605.i, align 8, !noalias !11
  %.744.i347 = load i64, ptr %.551.i, align 8, !noalias !11
  %.771.i = icmp slt i64 %.744.i347, 0
  %.772.i = select i1 %.771.i, i64 %arg.batch.3.3.5.0, i64 0
  %.773.i = add i64 %.772.i, %.744.i347
  %.793.i370 = mul i64 %.773.i, %arg.batch.3.3.5.1
  %123 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.793.i370
  %.797.i = getelementptr i8, ptr %123, i64 16
  %.798.i = load i64, ptr %.797.i, align 8, !noalias !11
  %.799.i373 = add nsw i64 %.798.i, 1
  store i64 %.799.i373, ptr %.797.i, align 8, !noalias !11
  %.905.i = getelementptr double, ptr %23, i64 %.170.i.010701
  %.906.i = load double, ptr %.905.i, align 8, !noalias !11
  %.907.i = fcmp une double %.906.i, 0.000000e+00
  br i1 %.907.i, label %B368.i, label %B414.i

B368.i:                                           ; preds = %B106.i
  %124 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.170.i.010701
  %.84.i.i = load i64, ptr %124, align 8, !noalias !15
  %.89.i.i = icmp sgt i64 %.84.i.i, -1
  br i1 %.89.i.i, label %B46.i.i, label %B414.i

B46.i.i:                                          ; preds = %B368.i
  %.120.i.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i
  %.121.i.i = load i64, ptr %.120.i.i, align 8, !noalias !15
  %.122.i.i = icmp eq i64 %.121.i.i, 0
  br i1 %.122.i.i, label %B80.i.i, label %B414.i

B80.i.i:                                          ; preds = %B46.i.i
  store i64 3, ptr %.120.i.i, align 8, !noalias !15
  br label %B414.i

B414.i:                                           ; preds = %B80.i.i, %B368.i, %B46.i.i, %B106.i
  br i1 %.1190.not, label %B550.i, label %B418.i

B418.i:                                           ; preds = %B414.i
  %125 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.170.i.010701
  %.977.i = load double, ptr %125, align 8, !noalias !11
  %.979.i = fcmp olt double %.977.i, -1.000000e-09
  br i1 %.979.i, label %B454.i, label %B550.i

B454.i:                                           ; preds = %B418.i
  %126 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.170.i.010701
  %.84.i63.i = load i64, ptr %126, align 8, !noalias !18
  %.89.i66.i = icmp sgt i64 %.84.i63.i, -1
  br i1 %.89.i66.i, label %B46.i71.i, label %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

B46.i71.i:                                        ; preds = %B454.i
  %.120.i91.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i63.i
  %.121.i92.i = load i64, ptr %.120.i91.i, align 8, !noalias !18
  %.122.i93.i = icmp eq i64 %.121.i92.i, 0
  br i1 %.122.i93.i, label %B80.i98.i, label %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

B80.i98.i:                                        ; preds = %B46.i71.i
  store i64 4, ptr %.120.i91.i, align 8, !noalias !18
  br label %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i: ; preds = %B46.i71.i, %B454.i, %B80.i98.i
  %.1068.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.170.i.010701
  %.1069.i = load double, ptr %.1068.i, align 8, !noalias !11
  %.1123.i = getelementptr double, ptr %24, i64 %.170.i.010701
  store double %.1069.i, ptr %.1123.i, align 8, !noalias !11
  br label %B550.i

B550.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i, %B418.i, %B414.i
  %.111.i183.i = getelementptr i64, ptr %25, i64 %.170.i.010701
  %.112.i.i = load i64, ptr %.111.i183.i, align 8, !noalias !21
  %.169.i.i = getelementptr double, ptr %26, i64 %.170.i.010701
  %.170.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.224.i.i = getelementptr double, ptr %27, i64 %.170.i.010701
  store double %.170.i.i, ptr %.224.i.i, align 8, !noalias !21
  %.237.i.i = icmp slt i64 %.112.i.i, %arg.batch.2.5.0
  br i1 %.237.i.i, label %B134.i.i, label %B584.i

B134.i.i:                                         ; preds = %B550.i
  %.253.i.i = icmp slt i64 %.112.i.i, 0
  %.254.i.i = select i1 %.253.i.i, i64 %arg.batch.2.5.0, i64 0
  %127 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i.i
  %.268.i.i = getelementptr double, ptr %127, i64 %.254.i.i
  %.269.i.i = load double, ptr %.268.i.i, align 8, !noalias !21
  %.328.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.10.i.i.i = fcmp olt double %.328.i.i, %.269.i.i
  %.11.i.i.i = select i1 %.10.i.i.i, double %.328.i.i, double %.269.i.i
  store double %.11.i.i.i, ptr %.224.i.i, align 8, !noalias !21
  br label %B584.i

B584.i:                                           ; preds = %B134.i.i, %B550.i, %B64.if.i
  %.229.i103 = icmp sgt i64 %.173.i7.010702, 1
  br i1 %.229.i103, label %B64.if.i, label %B1140

B64.if.i:                                         ; preds = %B1098, %B584.i
  %.173.i7.010702 = phi i64 [ %.238.i, %B584.i ], [ %storemerge, %B1098 ]
  %.170.i.010701 = phi i64 [ %.242.i388, %B584.i ], [ 0, %B1098 ]
  %.238.i = add nsw i64 %.173.i7.010702, -1
  %.242.i388 = add nsw i64 %.170.i.010701, 1
  %.323.i132 = getelementptr double, ptr %20, i64 %.170.i.010701
  %.324.i133 = load double, ptr %.323.i132, align 8, !noalias !11
  %.325.i134 = fcmp ogt double %.324.i133, 5.000000e-01
  br i1 %.325.i134, label %B106.i, label %B584.i

B1140:                                            ; preds = %B584.i, %B1098, %B568
  %brmerge = select i1 %looked.3.1, i1 true, i1 %.543.not
  br i1 %brmerge, label %B1148, label %B1216

B1148:                                            ; preds = %B1140
  %.1757 = load i64, ptr %.1756, align 8
  %.1802 = inttoptr i64 %.1757 to ptr
  tail call void %.1802(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B1216

B1216:                                            ; preds = %B1140, %B1148
  br i1 %.543.not, label %B1304, label %B1220

B1220:                                            ; preds = %B1216
  %.1836 = load i64, ptr %arg.code.4, align 8
  %.1883 = inttoptr i64 %.1836 to ptr
  tail call void %.1883(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1882)
  br label %B1304

B1304:                                            ; preds = %B1220, %B1216
  br i1 %.541, label %B1308, label %B1348

B1308:                                            ; preds = %B1304
  br i1 %.174.not.i, label %B0.else.endif.endif.endif.if.i, label %B0.else.endif.if.i, !prof !25

B124.i10359:                                      ; preds = %B0.endif.else.endif.endif.i
  %.154.i.i10360 = load i64, ptr %.153.i.i, align 8, !noalias !26
  %.184.i.i10361 = load i64, ptr %.183.i.i, align 8, !noalias !26
  br i1 %.234.i.i, label %B0.else.endif.if.i.i, label %B0.else.endif.endif.i.i, !prof !32

B412.i.i:                                         ; preds = %B330.if.i.i, %B0.endif.endif.endif.endif.endif.i.i
  %.1311.i.i = add nsw i64 %.486.i.i, -1
  %.1349.i.i = icmp slt i64 %.477.i.i, 2
  %storemerge2239.i = select i1 %.1349.i.i, i64 0, i64 %.1311.i.i
  %.1392.i2287.i = icmp sgt i64 %storemerge2239.i, 0
  br i1 %.1392.i2287.i, label %B478.i.lr.ph.i, label %B164.i

B478.i.lr.ph.i:                                   ; preds = %B412.i.i
  %.1338.i.12290.i = add nsw i64 %storemerge2239.i, -1
  %.511.i.i.i = select i1 %.1556.i2266.not.i, i64 %.311.i.i10365, i64 0
  %128 = getelementptr i64, ptr %.327.i.i, i64 %arg.shape.1
  %.525.i.i.i = getelementptr i64, ptr %128, i64 %.511.i.i.i
  br label %B478.i.i

B474.i.loopexit.i:                                ; preds = %B1253.i.i, %B960.i.i
  %.1392.i.i = icmp sgt i64 %.1338.i.12292.i, 0
  %.1405.i.i = zext i1 %.1392.i.i to i64
  %.1335.i.1.i = add i64 %.1335.i.12291.i, %.1405.i.i
  %.1401.i.i = sext i1 %.1392.i.i to i64
  %.1338.i.1.i = add nsw i64 %.1338.i.12292.i, %.1401.i.i
  %.1382.i.sroa.0.0.i = select i1 %.1392.i.i, i64 %.1335.i.12291.i, i64 0
  br i1 %.1392.i.i, label %B478.i.i, label %B164.i

B478.i.i:                                         ; preds = %B474.i.loopexit.i, %B478.i.lr.ph.i
  %.1382.i.sroa.0.02293.i = phi i64 [ 0, %B478.i.lr.ph.i ], [ %.1382.i.sroa.0.0.i, %B474.i.loopexit.i ]
  %.1338.i.12292.i = phi i64 [ %.1338.i.12290.i, %B478.i.lr.ph.i ], [ %.1338.i.1.i, %B474.i.loopexit.i ]
  %.1335.i.12291.i = phi i64 [ 1, %B478.i.lr.ph.i ], [ %.1335.i.1.i, %B474.i.loopexit.i ]
  %.1462.i.i = load i64, ptr %.1461.i.i, align 8, !noalias !26
  %.1463.i.i = icmp sgt i64 %.1462.i.i, 0
  br i1 %.1463.i.i, label %B508.i.i, label %B918.i.i

B508.i.i:                                         ; preds = %B478.i.i
  br i1 %.1556.i2266.not.i, label %B610.i.i, label %B544.if.i.i

B610.i.i:                                         ; preds = %B544.if.i.i, %B508.i.i
  %.1717.i.i = load i64, ptr %.1716.i.i, align 8, !noalias !26
  %.1833.i.i = inttoptr i64 %.1717.i.i to ptr
  tail call void %.1833.i.i(ptr %arg.batch.4.0.4, ptr %.1807.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1832.i.i), !noalias !26
  %.1849.i.i = icmp slt i64 %.1382.i.sroa.0.02293.i, 0
  %.1850.i.i = select i1 %.1849.i.i, i64 %.486.i.i, i64 0
  %129 = getelementptr i64, ptr %.502.i.i, i64 %.1382.i.sroa.0.02293.i
  %.1864.i.i = getelementptr i64, ptr %129, i64 %.1850.i.i
  %.1865.i.i = load i64, ptr %.1864.i.i, align 8, !noalias !26
  %.1881.i.i = icmp slt i64 %.1382.i.sroa.0.02293.i, -1
  %.1882.i.i = select i1 %.1881.i.i, i64 %.486.i.i, i64 0
  %130 = getelementptr i8, ptr %129, i64 8
  %.1896.i.i = getelementptr i64, ptr %130, i64 %.1882.i.i
  %.1897.i.i = load i64, ptr %.1896.i.i, align 8, !noalias !26
  %.1934.i.i = sub i64 %.1897.i.i, %.1865.i.i
  %.1980.i2269.not.i = icmp slt i64 %.1934.i.i, 1
  br i1 %.1980.i2269.not.i, label %B960.i.i, label %B794.if.i.i

B802.i.i:                                         ; preds = %B794.if.i.i
  %.2047.i.i = icmp slt i64 %.1921.i.02270.i, 0
  %.2048.i.i = select i1 %.2047.i.i, i64 %.665.i.i, i64 0
  %131 = getelementptr i64, ptr %.681.i.i, i64 %.1921.i.02270.i
  %.2062.i.i = getelementptr i64, ptr %131, i64 %.2048.i.i
  %.2063.i.i = load i64, ptr %.2062.i.i, align 8, !noalias !26
  %.2064.i.i = add nsw i64 %.2063.i.i, %.1789.i.i
  %.2078.i.i = icmp slt i64 %.2064.i.i, 0
  %.2079.i.i = select i1 %.2078.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %132 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2064.i.i
  %.2093.i.i = getelementptr double, ptr %132, i64 %.2079.i.i
  %.2094.i.i = load double, ptr %.2093.i.i, align 8, !noalias !26
  %.2161.i.i = fsub double %.2094.i.i, %.2094.i.i
  %.2162.i.i = fcmp oeq double %.2161.i.i, 0.000000e+00
  br label %B910.i.i

B910.i.i:                                         ; preds = %B794.if.i.i, %B802.i.i
  %"$phi910.2.2.i.3.i" = phi i1 [ %.2162.i.i, %B802.i.i ], [ false, %B794.if.i.i ]
  %.1980.i.i = icmp sgt i64 %.1924.i.02271.i, 1
  br i1 %.1980.i.i, label %B794.if.i.i, label %B914.i.i

B914.i.i:                                         ; preds = %B910.i.i
  br i1 %"$phi910.2.2.i.3.i", label %B960.i.i, label %B918.i.i

B918.i.i:                                         ; preds = %B914.i.i, %B478.i.i
  %.151.i.i.i = load double, ptr %.150.i.i.i, align 8, !noalias !33
  %.180.i.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !33
  %.184.i.i.i = fdiv double %.151.i.i.i, %.180.i.i.i
  br i1 %.1162.i2263.not.i, label %B262.i.i.i, label %B84.if.i.i.i

B262.i.i.i:                                       ; preds = %B84.if.i.i.i, %B918.i.i
  %.526.i.i.i = load i64, ptr %.525.i.i.i, align 8, !noalias !33
  %.530.i.i.i = icmp eq i64 %.526.i.i.i, %.1382.i.sroa.0.02293.i
  br i1 %.530.i.i.i, label %B286.i.i.i, label %B324.i.i.i

B286.i.i.i:                                       ; preds = %B262.i.i.i
  %.587.i.i.i = load double, ptr %.586.i.i.i, align 8, !noalias !33
  %.588.i.i.i = fmul double %.587.i.i.i, 1.000000e-03
  br label %B324.i.i.i

B324.i.i.i:                                       ; preds = %B286.i.i.i, %B262.i.i.i
  %"$phi324.0.2.i.i.0.i" = phi double [ %.588.i.i.i, %B286.i.i.i ], [ 0.000000e+00, %B262.i.i.i ]
  store double %"$phi324.0.2.i.i.0.i", ptr %.629.i.i.i, align 8, !noalias !33
  br i1 %.1162.i2263.not.i, label %B524.i.i.1.critedge.i, label %B428.if.i.i.i

B524.i.i.i:                                       ; preds = %B428.if.i.i.i
  %.1034.i.i.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !33
  %.1068.i.i.i = load double, ptr %.629.i.i.i, align 8, !noalias !33
  %.1070.i.i.i = fmul double %.1068.i.i.i, 5.000000e-01
  %.1073.i.i.i = fadd double %.1034.i.i.i, %.1070.i.i.i
  store double %.1073.i.i.i, ptr %.502, align 8, !noalias !33
  %.1157.i.i.i = load i64, ptr %arg.code.4, align 8, !noalias !33
  %.1277.i.i.i = inttoptr i64 %.1157.i.i.i to ptr
  tail call void %.1277.i.i.i(ptr nonnull %.502, ptr %.1807.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.i), !noalias !33
  br label %B428.if.i.i.1.i

B428.if.i.i.1.i:                                  ; preds = %B428.if.i.i.1.i, %B524.i.i.i
  %.783.i.i.02277.1.i = phi i64 [ %.852.i.i.1.i, %B428.if.i.i.1.i ], [ 0, %B524.i.i.i ]
  %.852.i.i.1.i = add nsw i64 %.783.i.i.02277.1.i, 1
  %133 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02277.1.i
  %.906.i.i.1.i = load double, ptr %133, align 8, !noalias !33
  %134 = getelementptr double, ptr %133, i64 %.597.i.i.i
  %.939.i.i.1.i = load double, ptr %134, align 8, !noalias !33
  %.941.i.i.1.i = fmul double %.939.i.i.1.i, 5.000000e-01
  %135 = fsub double %.906.i.i.1.i, %.941.i.i.1.i
  %136 = getelementptr double, ptr %133, i64 %.944.i.i.i
  store double %135, ptr %136, align 8, !noalias !33
  %exitcond2301.1.not.i = icmp eq i64 %arg.shape.1, %.852.i.i.1.i
  br i1 %exitcond2301.1.not.i, label %B524.i.i.1.i, label %B428.if.i.i.1.i

B524.i.i.1.critedge.i:                            ; preds = %B324.i.i.i
  %.1034.i.i.c.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !33
  %.1070.i.i.c.i = fmul double %"$phi324.0.2.i.i.0.i", 5.000000e-01
  %.1073.i.i.c.i = fadd double %.1070.i.i.c.i, %.1034.i.i.c.i
  store double %.1073.i.i.c.i, ptr %.502, align 8, !noalias !33
  %.1157.i.i.c.i = load i64, ptr %arg.code.4, align 8, !noalias !33
  %.1277.i.i.c.i = inttoptr i64 %.1157.i.i.c.i to ptr
  tail call void %.1277.i.i.c.i(ptr nonnull %.502, ptr %.1807.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.c.i), !noalias !33
  br label %B524.i.i.1.i

B524.i.i.1.i:                                     ; preds = %B428.if.i.i.1.i, %B524.i.i.1.critedge.i
  %.1034.i.i.1.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !33
  %.1068.i.i.1.i = load double, ptr %.629.i.i.i, align 8, !noalias !33
  %.1070.i.i.1.i = fmul double %.1068.i.i.1.i, 5.000000e-01
  %137 = fsub double %.1034.i.i.1.i, %.1070.i.i.1.i
  store double %137, ptr %.502, align 8, !noalias !33
  %.1157.i.i.1.i = load i64, ptr %arg.code.4, align 8, !noalias !33
  %.1277.i.i.1.i = inttoptr i64 %.1157.i.i.1.i to ptr
  tail call void %.1277.i.i.1.i(ptr nonnull %.502, ptr %.1807.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.1.i), !noalias !33
  br i1 %.1162.i2263.not.i, label %B960.i.i, label %B780.if.i.i.i

B966.i.i.i:                                       ; preds = %B780.if.i.i.i
  %.1601.i.i.i = fsub double %.1513.i.i.i, %.1548.i.i.i
  br label %B1053.i.i.i

B1006.i.i.i:                                      ; preds = %B780.if.i.i.i
  %138 = getelementptr double, ptr %146, i64 %arg.shape.1
  %.1582.i.i.i = load double, ptr %138, align 8, !noalias !33
  %.1647.i.i.i = fsub double %.1513.i.i.i, %.1582.i.i.i
  %.1652.i.i.i = fmul double %.1647.i.i.i, 2.000000e+00
  br label %B1053.i.i.i

B1053.i.i.i:                                      ; preds = %B1006.i.i.i, %B966.i.i.i
  %storemerge2247.i = phi double [ %.1652.i.i.i, %B1006.i.i.i ], [ %.1601.i.i.i, %B966.i.i.i ]
  store double %storemerge2247.i, ptr %148, align 8, !noalias !33
  %exitcond2303.not.i = icmp eq i64 %arg.shape.1, %.1387.i.i.i
  br i1 %exitcond2303.not.i, label %B960.i.i, label %B780.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B918.i.i, %B84.if.i.i.i
  %.212.i.i.02275.i = phi i64 [ %.283.i.i.i, %B84.if.i.i.i ], [ 0, %B918.i.i ]
  %.283.i.i.i = add nsw i64 %.212.i.i.02275.i, 1
  %139 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.212.i.i.02275.i
  %.341.i.i.i = load double, ptr %139, align 8, !noalias !33
  %.342.i.i.i = tail call double @llvm.fabs.f64(double %.341.i.i.i)
  %.10.i.i.i.i = fcmp ogt double %.184.i.i.i, %.342.i.i.i
  %.11.i.i.i.i = select i1 %.10.i.i.i.i, double %.184.i.i.i, double %.342.i.i.i
  %.377.i.i.i = fcmp ogt double %.11.i.i.i.i, 0.000000e+00
  %140 = fmul double %.11.i.i.i.i, 1.200000e-05
  %"$phi194.2.2.i.i.1.i" = select i1 %.377.i.i.i, double %140, double 1.200000e-05
  %141 = getelementptr i64, ptr %.327.i.i, i64 %.212.i.i.02275.i
  %.434.i.i.i = load i64, ptr %141, align 8, !noalias !33
  %.436.i.i.i = icmp eq i64 %.434.i.i.i, %.1382.i.sroa.0.02293.i
  %"$phi230.1.2.i.i.1.i" = select i1 %.436.i.i.i, double %"$phi194.2.2.i.i.1.i", double 0.000000e+00
  %142 = getelementptr i8, ptr %139, i64 %.idx2308.i
  store double %"$phi230.1.2.i.i.1.i", ptr %142, align 8, !noalias !33
  %exitcond2300.not.i = icmp eq i64 %arg.shape.1, %.283.i.i.i
  br i1 %exitcond2300.not.i, label %B262.i.i.i, label %B84.if.i.i.i

B428.if.i.i.i:                                    ; preds = %B324.i.i.i, %B428.if.i.i.i
  %.783.i.i.02277.i = phi i64 [ %.852.i.i.i, %B428.if.i.i.i ], [ 0, %B324.i.i.i ]
  %.852.i.i.i = add nsw i64 %.783.i.i.02277.i, 1
  %143 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02277.i
  %.906.i.i.i = load double, ptr %143, align 8, !noalias !33
  %144 = getelementptr double, ptr %143, i64 %.597.i.i.i
  %.939.i.i.i = load double, ptr %144, align 8, !noalias !33
  %.941.i.i.i = fmul double %.939.i.i.i, 5.000000e-01
  %.942.i.i.i = fadd double %.906.i.i.i, %.941.i.i.i
  %145 = getelementptr double, ptr %143, i64 %.944.i.i.i
  store double %.942.i.i.i, ptr %145, align 8, !noalias !33
  %exitcond2301.not.i = icmp eq i64 %arg.shape.1, %.852.i.i.i
  br i1 %exitcond2301.not.i, label %B524.i.i.i, label %B428.if.i.i.i

B780.if.i.i.i:                                    ; preds = %B524.i.i.1.i, %B1053.i.i.i
  %.1318.i.i.02282.i = phi i64 [ %.1387.i.i.i, %B1053.i.i.i ], [ 0, %B524.i.i.1.i ]
  %.1387.i.i.i = add nsw i64 %.1318.i.i.02282.i, 1
  %146 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1318.i.i.02282.i
  %.1445.i.i.i = load double, ptr %146, align 8, !noalias !33
  %147 = getelementptr i8, ptr %146, i64 %.1807.i.idx.i
  store double %.1445.i.i.i, ptr %147, align 8, !noalias !33
  %148 = getelementptr i8, ptr %146, i64 %.idx2310.i
  %.1513.i.i.i = load double, ptr %148, align 8, !noalias !33
  %149 = getelementptr i8, ptr %146, i64 %.1276.i.i.1.idx.i
  %.1548.i.i.i = load double, ptr %149, align 8, !noalias !33
  %.1594.i.i.i = fsub double %.1548.i.i.i, %.1548.i.i.i
  %.1595.i.i.i = fcmp oeq double %.1594.i.i.i, 0.000000e+00
  br i1 %.1595.i.i.i, label %B966.i.i.i, label %B1006.i.i.i

B960.i.i:                                         ; preds = %B1053.i.i.i, %B524.i.i.1.i, %B914.i.i, %B610.i.i
  %.2258.i.i = icmp slt i64 %.1382.i.sroa.0.02293.i, 0
  %.2259.i.i = select i1 %.2258.i.i, i64 %.486.i.i, i64 0
  %150 = getelementptr i64, ptr %.502.i.i, i64 %.1382.i.sroa.0.02293.i
  %.2273.i.i = getelementptr i64, ptr %150, i64 %.2259.i.i
  %.2274.i.i = load i64, ptr %.2273.i.i, align 8, !noalias !26
  %.2292.i.i = icmp slt i64 %.1382.i.sroa.0.02293.i, -1
  %.2293.i.i = select i1 %.2292.i.i, i64 %.486.i.i, i64 0
  %151 = getelementptr i8, ptr %150, i64 8
  %.2307.i.i = getelementptr i64, ptr %151, i64 %.2293.i.i
  %.2308.i.i = load i64, ptr %.2307.i.i, align 8, !noalias !26
  %.2345.i.i = sub i64 %.2308.i.i, %.2274.i.i
  %.2388.i2284.not.i = icmp slt i64 %.2345.i.i, 1
  br i1 %.2388.i2284.not.i, label %B474.i.loopexit.i, label %B1022.if.i.i

B1178.i.i:                                        ; preds = %B1022.if.i.i
  %.2656.i.i = add nsw i64 %.2461.i.i, %.2622.i.i
  %.2671.i.i = icmp slt i64 %.2656.i.i, 0
  %.2672.i.i = select i1 %.2671.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %152 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2656.i.i
  %.2686.i.i = getelementptr double, ptr %152, i64 %.2672.i.i
  store double %.2560.i..i, ptr %.2686.i.i, align 8, !noalias !26
  br label %B1253.i.i

B1224.i.i:                                        ; preds = %B1022.if.i.i
  %.2706.i.i = select i1 %.2445.i.i, i64 %.1014.i.i, i64 0
  %153 = getelementptr i64, ptr %.1030.i.i, i64 %.2332.i.02285.i
  %.2720.i.i = getelementptr i64, ptr %153, i64 %.2706.i.i
  %.2721.i.i = load i64, ptr %.2720.i.i, align 8, !noalias !26
  %.2738.i.i = icmp slt i64 %.2721.i.i, 0
  %.2739.i.i = select i1 %.2738.i.i, i64 %arg.linear.0.5.0, i64 0
  %154 = getelementptr double, ptr %arg.linear.0.4, i64 %.2721.i.i
  %.2753.i.i = getelementptr double, ptr %154, i64 %.2739.i.i
  store double %.2560.i..i, ptr %.2753.i.i, align 8, !noalias !26
  br label %B1253.i.i

B1253.i.i:                                        ; preds = %B1224.i.i, %B1178.i.i
  %.2388.i.i = icmp sgt i64 %.2335.i.02286.i, 1
  br i1 %.2388.i.i, label %B1022.if.i.i, label %B474.i.loopexit.i

B0.endif.i.i:                                     ; preds = %B0.else.endif.endif.endif.if.i.i, %B0.else.endif.endif.endif.i.i
  %.214.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.else.endif.endif.endif.if.i.i ], [ %.214.i.sroa.11.1.i, %B0.else.endif.endif.endif.i.i ]
  %.302.i.i = sub i64 %.214.i.sroa.11.0.i, %spec.select.i
  %.311.i.i10365 = tail call i64 @llvm.smax.i64(i64 %.302.i.i, i64 0)
  %.327.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select.i
  %.362.i.i = add nsw i64 %.154.i.i10360, %.187.i.i
  br i1 %.409.i.i, label %B0.endif.else.endif.if.i.i, label %B0.endif.else.endif.endif.i.i, !prof !32

B0.else.endif.if.i.i:                             ; preds = %B124.i10359
  br label %B0.else.endif.endif.i.i

B0.else.endif.endif.i.i:                          ; preds = %B0.else.endif.if.i.i, %B124.i10359
  %simplifycfg.merge.i = phi i64 [ %arg.linear.1.5.0, %B0.else.endif.if.i.i ], [ 0, %B124.i10359 ]
  %spec.select.i = select i1 %28, i64 %simplifycfg.merge.i, i64 %.226.i.i, !prof !37
  br i1 %.246.i.i, label %B0.else.endif.endif.if.i.i, label %B0.else.endif.endif.endif.i.i, !prof !32

B0.else.endif.endif.if.i.i:                       ; preds = %B0.else.endif.endif.i.i
  br label %B0.else.endif.endif.endif.i.i

B0.else.endif.endif.endif.i.i:                    ; preds = %B0.else.endif.endif.if.i.i, %B0.else.endif.endif.i.i
  %.214.i.sroa.11.1.i = phi i64 [ 0, %B0.else.endif.endif.if.i.i ], [ %.243.i.i10364, %B0.else.endif.endif.i.i ]
  br i1 %.251.i.not.i, label %B0.endif.i.i, label %B0.else.endif.endif.endif.if.i.i, !prof !25

B0.else.endif.endif.endif.if.i.i:                 ; preds = %B0.else.endif.endif.endif.i.i
  br label %B0.endif.i.i

B0.endif.endif.i.i:                               ; preds = %B0.endif.else.endif.endif.endif.if.i.i, %B0.endif.else.endif.endif.endif.i.i
  %.389.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.endif.endif.if.i.i ], [ %.389.i.sroa.11.1.i, %B0.endif.else.endif.endif.endif.i.i ]
  %.477.i.i = sub i64 %.389.i.sroa.11.0.i, %spec.select2250.i
  %.486.i.i = tail call i64 @llvm.smax.i64(i64 %.477.i.i, i64 0)
  %.502.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2250.i
  %.540.i.i = add i64 %.539.i.i, %.154.i.i10360
  %.541.i.i = add nsw i64 %.540.i.i, %.184.i.i10361
  %.578.i.i = icmp slt i64 %.540.i.i, 0
  %.579.i.i = select i1 %.578.i.i, i64 %arg.linear.1.5.0, i64 0
  %.580.i.i = add i64 %.579.i.i, %.540.i.i
  %.583.i.i = icmp slt i64 %.580.i.i, 0
  %.588.i.i = icmp sge i64 %.580.i.i, %arg.linear.1.5.0
  br i1 %.588.i.i, label %B0.endif.endif.else.endif.if.i.i, label %B0.endif.endif.else.endif.endif.i.i, !prof !32

B0.endif.else.endif.if.i.i:                       ; preds = %B0.endif.i.i
  br label %B0.endif.else.endif.endif.i.i

B0.endif.else.endif.endif.i.i:                    ; preds = %B0.endif.else.endif.if.i.i, %B0.endif.i.i
  %simplifycfg.merge2.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.if.i.i ], [ 0, %B0.endif.i.i ]
  %spec.select2250.i = select i1 %29, i64 %simplifycfg.merge2.i, i64 %.243.i.i10364, !prof !37
  %.416.i.i = icmp slt i64 %.362.i.i, 0
  %.417.i.i = select i1 %.416.i.i, i64 %arg.linear.1.5.0, i64 0
  %.418.i.i = add i64 %.417.i.i, %.362.i.i
  %.421.i.i = icmp slt i64 %.418.i.i, 0
  br i1 %.421.i.i, label %B0.endif.else.endif.endif.if.i.i, label %B0.endif.else.endif.endif.endif.i.i, !prof !32

B0.endif.else.endif.endif.if.i.i:                 ; preds = %B0.endif.else.endif.endif.i.i
  br label %B0.endif.else.endif.endif.endif.i.i

B0.endif.else.endif.endif.endif.i.i:              ; preds = %B0.endif.else.endif.endif.if.i.i, %B0.endif.else.endif.endif.i.i
  %.389.i.sroa.11.1.i = phi i64 [ 0, %B0.endif.else.endif.endif.if.i.i ], [ %.418.i.i, %B0.endif.else.endif.endif.i.i ]
  %.426.i.not.i = icmp slt i64 %.418.i.i, %arg.linear.1.5.0
  br i1 %.426.i.not.i, label %B0.endif.endif.i.i, label %B0.endif.else.endif.endif.endif.if.i.i, !prof !25

B0.endif.else.endif.endif.endif.if.i.i:           ; preds = %B0.endif.else.endif.endif.endif.i.i
  br label %B0.endif.endif.i.i

B0.endif.endif.endif.i.i:                         ; preds = %B0.endif.endif.else.endif.endif.endif.if.i.i, %B0.endif.endif.else.endif.endif.endif.i.i
  %.568.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.endif.endif.if.i.i ], [ %.568.i.sroa.11.1.i, %B0.endif.endif.else.endif.endif.endif.i.i ]
  %.656.i.i = sub i64 %.568.i.sroa.11.0.i, %spec.select2251.i
  %.665.i.i = tail call i64 @llvm.smax.i64(i64 %.656.i.i, i64 0)
  %.681.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2251.i
  %.711.i.i = shl nsw i64 %.184.i.i10361, 1
  %.712.i.i = add nsw i64 %.711.i.i, %.540.i.i
  %.759.i.i = icmp sge i64 %.597.i.i, %arg.linear.1.5.0
  br i1 %.759.i.i, label %B0.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.else.endif.endif.i.i, !prof !32

B0.endif.endif.else.endif.if.i.i:                 ; preds = %B0.endif.endif.i.i
  br label %B0.endif.endif.else.endif.endif.i.i

B0.endif.endif.else.endif.endif.i.i:              ; preds = %B0.endif.endif.else.endif.if.i.i, %B0.endif.endif.i.i
  %simplifycfg.merge4.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.i.i ]
  %155 = or i1 %.583.i.i, %.588.i.i
  %spec.select2251.i = select i1 %155, i64 %simplifycfg.merge4.i, i64 %.580.i.i, !prof !37
  %.595.i.i = icmp slt i64 %.541.i.i, 0
  %.596.i.i = select i1 %.595.i.i, i64 %arg.linear.1.5.0, i64 0
  %.597.i.i = add i64 %.596.i.i, %.541.i.i
  %.600.i.i = icmp slt i64 %.597.i.i, 0
  br i1 %.600.i.i, label %B0.endif.endif.else.endif.endif.if.i.i, label %B0.endif.endif.else.endif.endif.endif.i.i, !prof !32

B0.endif.endif.else.endif.endif.if.i.i:           ; preds = %B0.endif.endif.else.endif.endif.i.i
  br label %B0.endif.endif.else.endif.endif.endif.i.i

B0.endif.endif.else.endif.endif.endif.i.i:        ; preds = %B0.endif.endif.else.endif.endif.if.i.i, %B0.endif.endif.else.endif.endif.i.i
  %.568.i.sroa.11.1.i = phi i64 [ 0, %B0.endif.endif.else.endif.endif.if.i.i ], [ %.597.i.i, %B0.endif.endif.else.endif.endif.i.i ]
  %.605.i.not.i = icmp slt i64 %.597.i.i, %arg.linear.1.5.0
  br i1 %.605.i.not.i, label %B0.endif.endif.endif.i.i, label %B0.endif.endif.else.endif.endif.endif.if.i.i, !prof !25

B0.endif.endif.else.endif.endif.endif.if.i.i:     ; preds = %B0.endif.endif.else.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.i.i

B0.endif.endif.endif.endif.i.i:                   ; preds = %B0.endif.endif.endif.else.endif.endif.endif.if.i.i, %B0.endif.endif.endif.else.endif.endif.endif.i.i
  %.739.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.else.endif.endif.endif.if.i.i ], [ %.739.i.sroa.11.1.i, %B0.endif.endif.endif.else.endif.endif.endif.i.i ]
  %.827.i.i = sub i64 %.739.i.sroa.11.0.i, %spec.select2252.i
  %.836.i.i = tail call i64 @llvm.smax.i64(i64 %.827.i.i, i64 0)
  %.852.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2252.i
  %.889.i.i = mul nsw i64 %.184.i.i10361, 3
  %.890.i.i = add nsw i64 %.889.i.i, %.540.i.i
  %.937.i.i = icmp sge i64 %.768.i.i, %arg.linear.1.5.0
  br i1 %.937.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.i.i, !prof !32

B0.endif.endif.endif.else.endif.if.i.i:           ; preds = %B0.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.else.endif.endif.i.i:        ; preds = %B0.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.i.i
  %simplifycfg.merge6.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.i.i ]
  %156 = or i1 %.600.i.i, %.759.i.i
  %spec.select2252.i = select i1 %156, i64 %simplifycfg.merge6.i, i64 %.597.i.i, !prof !37
  %.766.i.i = icmp slt i64 %.712.i.i, 0
  %.767.i.i = select i1 %.766.i.i, i64 %arg.linear.1.5.0, i64 0
  %.768.i.i = add i64 %.767.i.i, %.712.i.i
  %.771.i.i = icmp slt i64 %.768.i.i, 0
  br i1 %.771.i.i, label %B0.endif.endif.endif.else.endif.endif.if.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.i.i, !prof !32

B0.endif.endif.endif.else.endif.endif.if.i.i:     ; preds = %B0.endif.endif.endif.else.endif.endif.i.i
  br label %B0.endif.endif.endif.else.endif.endif.endif.i.i

B0.endif.endif.endif.else.endif.endif.endif.i.i:  ; preds = %B0.endif.endif.endif.else.endif.endif.if.i.i, %B0.endif.endif.endif.else.endif.endif.i.i
  %.739.i.sroa.11.1.i = phi i64 [ 0, %B0.endif.endif.endif.else.endif.endif.if.i.i ], [ %.768.i.i, %B0.endif.endif.endif.else.endif.endif.i.i ]
  %.776.i.not.i = icmp slt i64 %.768.i.i, %arg.linear.1.5.0
  br i1 %.776.i.not.i, label %B0.endif.endif.endif.endif.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.if.i.i, !prof !25

B0.endif.endif.endif.else.endif.endif.endif.if.i.i: ; preds = %B0.endif.endif.endif.else.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.i.i

B0.endif.endif.endif.endif.endif.i.i:             ; preds = %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i
  %.917.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i ], [ %.917.i.sroa.11.1.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i ]
  %.1005.i.i = sub i64 %.917.i.sroa.11.0.i, %spec.select2253.i
  %.1014.i.i = tail call i64 @llvm.smax.i64(i64 %.1005.i.i, i64 0)
  %.1030.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2253.i
  br i1 %.1162.i2263.not.i, label %B412.i.i, label %B330.if.i.i

B0.endif.endif.endif.endif.else.endif.if.i.i:     ; preds = %B0.endif.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.endif.else.endif.endif.i.i:  ; preds = %B0.endif.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.endif.i.i
  %simplifycfg.merge8.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.endif.i.i ]
  %157 = or i1 %.771.i.i, %.937.i.i
  %spec.select2253.i = select i1 %157, i64 %simplifycfg.merge8.i, i64 %.768.i.i, !prof !37
  %.944.i.i = icmp slt i64 %.890.i.i, 0
  %.945.i.i = select i1 %.944.i.i, i64 %arg.linear.1.5.0, i64 0
  %.946.i.i = add i64 %.945.i.i, %.890.i.i
  %.949.i.i = icmp slt i64 %.946.i.i, 0
  br i1 %.949.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.if.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i, !prof !32

B0.endif.endif.endif.endif.else.endif.endif.if.i.i: ; preds = %B0.endif.endif.endif.endif.else.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i

B0.endif.endif.endif.endif.else.endif.endif.endif.i.i: ; preds = %B0.endif.endif.endif.endif.else.endif.endif.if.i.i, %B0.endif.endif.endif.endif.else.endif.endif.i.i
  %.917.i.sroa.11.1.i = phi i64 [ 0, %B0.endif.endif.endif.endif.else.endif.endif.if.i.i ], [ %.946.i.i, %B0.endif.endif.endif.endif.else.endif.endif.i.i ]
  %.954.i.not.i = icmp slt i64 %.946.i.i, %arg.linear.1.5.0
  br i1 %.954.i.not.i, label %B0.endif.endif.endif.endif.endif.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i, !prof !25

B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i: ; preds = %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.endif.i.i

B330.if.i.i:                                      ; preds = %B0.endif.endif.endif.endif.endif.i.i, %B330.if.i.i
  %.1104.i.02264.i = phi i64 [ %.1175.i.i, %B330.if.i.i ], [ 0, %B0.endif.endif.endif.endif.endif.i.i ]
  %.1175.i.i = add nsw i64 %.1104.i.02264.i, 1
  %158 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1104.i.02264.i
  %.1229.i.i = load double, ptr %158, align 8, !noalias !26
  %159 = getelementptr i8, ptr %158, i64 %.idx2305.i
  store double %.1229.i.i, ptr %159, align 8, !noalias !26
  %160 = getelementptr i8, ptr %158, i64 %.idx2306.i
  store double 0.000000e+00, ptr %160, align 8, !noalias !26
  %exitcond.not.i10366 = icmp eq i64 %arg.shape.1, %.1175.i.i
  br i1 %exitcond.not.i10366, label %B412.i.i, label %B330.if.i.i

B544.if.i.i:                                      ; preds = %B508.i.i, %B544.if.i.i
  %.1503.i.02268.i = phi i64 [ %.1565.i.i, %B544.if.i.i ], [ %storemerge2243.i, %B508.i.i ]
  %.1500.i.02267.i = phi i64 [ %.1569.i.i, %B544.if.i.i ], [ 0, %B508.i.i ]
  %.1565.i.i = add nsw i64 %.1503.i.02268.i, -1
  %.1569.i.i = add nsw i64 %.1500.i.02267.i, 1
  %161 = getelementptr i64, ptr %.327.i.i, i64 %.1500.i.02267.i
  %.1627.i.i = load i64, ptr %161, align 8, !noalias !26
  %.1629.i.i = icmp eq i64 %.1627.i.i, %.1382.i.sroa.0.02293.i
  %..i = select i1 %.1629.i.i, double 1.000000e+00, double 0.000000e+00
  %gep = getelementptr double, ptr %invariant.gep, i64 %.1500.i.02267.i
  store double %..i, ptr %gep, align 8, !noalias !26
  %.1556.i.i = icmp sgt i64 %.1503.i.02268.i, 1
  br i1 %.1556.i.i, label %B544.if.i.i, label %B610.i.i

B794.if.i.i:                                      ; preds = %B610.i.i, %B910.i.i
  %found.2.i.22272.i = phi i1 [ %"$phi910.2.2.i.3.i", %B910.i.i ], [ true, %B610.i.i ]
  %.1924.i.02271.i = phi i64 [ %.1989.i.i, %B910.i.i ], [ %.1934.i.i, %B610.i.i ]
  %.1921.i.02270.i = phi i64 [ %.1993.i.i, %B910.i.i ], [ %.1865.i.i, %B610.i.i ]
  %.1989.i.i = add nsw i64 %.1924.i.02271.i, -1
  %.1993.i.i = add i64 %.1921.i.02270.i, 1
  br i1 %found.2.i.22272.i, label %B802.i.i, label %B910.i.i

B1022.if.i.i:                                     ; preds = %B960.i.i, %B1253.i.i
  %.2335.i.02286.i = phi i64 [ %.2397.i.i, %B1253.i.i ], [ %.2345.i.i, %B960.i.i ]
  %.2332.i.02285.i = phi i64 [ %.2401.i.i, %B1253.i.i ], [ %.2274.i.i, %B960.i.i ]
  %.2397.i.i = add nsw i64 %.2335.i.02286.i, -1
  %.2401.i.i = add i64 %.2332.i.02285.i, 1
  %.2445.i.i = icmp slt i64 %.2332.i.02285.i, 0
  %.2446.i.i = select i1 %.2445.i.i, i64 %.665.i.i, i64 0
  %162 = getelementptr i64, ptr %.681.i.i, i64 %.2332.i.02285.i
  %.2460.i.i = getelementptr i64, ptr %162, i64 %.2446.i.i
  %.2461.i.i = load i64, ptr %.2460.i.i, align 8, !noalias !26
  %.2462.i.i = add nsw i64 %.2461.i.i, %.1789.i.i
  %.2476.i.i = icmp slt i64 %.2462.i.i, 0
  %.2477.i.i = select i1 %.2476.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %163 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2462.i.i
  %.2491.i.i = getelementptr double, ptr %163, i64 %.2477.i.i
  %.2492.i.i = load double, ptr %.2491.i.i, align 8, !noalias !26
  %.2510.i.i = select i1 %.2445.i.i, i64 %.836.i.i, i64 0
  %164 = getelementptr i64, ptr %.852.i.i, i64 %.2332.i.02285.i
  %.2524.i.i = getelementptr i64, ptr %164, i64 %.2510.i.i
  %.2525.i.i = load i64, ptr %.2524.i.i, align 8, !noalias !26
  %.2526.i.i = add nsw i64 %.2525.i.i, %.597.i.i.i
  %.2540.i.i = icmp slt i64 %.2526.i.i, 0
  %.2541.i.i = select i1 %.2540.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %165 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2526.i.i
  %.2555.i.i = getelementptr double, ptr %165, i64 %.2541.i.i
  %.2556.i.i = load double, ptr %.2555.i.i, align 8, !noalias !26
  %.2560.i.i = fdiv double %.2492.i.i, %.2556.i.i
  %.2566.i.i = fsub double %.2560.i.i, %.2560.i.i
  %.2567.i.i = fcmp oeq double %.2566.i.i, 0.000000e+00
  %.2560.i..i = select i1 %.2567.i.i, double %.2560.i.i, double 0.000000e+00
  %.2619.i.i = icmp eq i64 %.2525.i.i, %arg.shape.1
  br i1 %.2619.i.i, label %B1178.i.i, label %B1224.i.i

B164.i:                                           ; preds = %B474.i.loopexit.i, %B0.endif.else.endif.endif.i, %B412.i.i
  %.634.i = load i64, ptr %arg.linear.1.4, align 8, !noalias !38
  %.664.i = load i64, ptr %.663.i, align 8, !noalias !38
  br i1 %.711.i, label %B226.if.lr.ph.i, label %B1348

B226.if.lr.ph.i:                                  ; preds = %B164.i
  %.829.i = add i64 %.634.i, 1
  %166 = add i64 %.664.i, %.634.i
  br label %B226.if.i

B396.i:                                           ; preds = %B342.if.i, %B226.if.i
  %.1055.i = mul i64 %.697.02298.i, %.743.sroa.0.02242.i
  %.1071.i = icmp slt i64 %.1055.i, 0
  %.1072.i = select i1 %.1071.i, i64 %.251.i, i64 0
  %167 = getelementptr double, ptr %.267.i, i64 %.1055.i
  %.1086.i = getelementptr double, ptr %167, i64 %.1072.i
  %.1087.i = load double, ptr %.1086.i, align 8, !noalias !38
  %.1141.i = load double, ptr %.1140.i, align 8, !noalias !38
  %.1142.i = fadd double %.1087.i, %.1141.i
  store double %.1142.i, ptr %.1086.i, align 8, !noalias !38
  %exitcond2304.not.i = icmp eq i64 %.766.i, %arg.shape.1
  br i1 %exitcond2304.not.i, label %B468.i, label %B226.if.i

B468.i:                                           ; preds = %B396.i
  %.199.i.i = add i64 %.664.i, 1
  br label %B36.if.i.i

B34.loopexit.i.i:                                 ; preds = %B790.i.i, %B528.i.i
  %exitcond.not.i.i = icmp eq i64 %.131.i.i, %arg.shape.1
  br i1 %exitcond.not.i.i, label %B1348, label %B36.if.i.i

B348.i.i:                                         ; preds = %B234.if.i.i, %B36.if.i.i
  %p.2.1.lcssa.i.i = phi i64 [ %.59.0509.i.i, %B36.if.i.i ], [ %p.3.2.i.i, %B234.if.i.i ]
  %168 = getelementptr i64, ptr %.437.i, i64 %.59.0509.i.i
  store i64 %p.2.1.lcssa.i.i, ptr %168, align 8, !noalias !39
  %.547.i.i = add nsw i64 %p.2.1.lcssa.i.i, %.161.i.i
  %.561.i.i = icmp slt i64 %.547.i.i, 0
  %.562.i.i = select i1 %.561.i.i, i64 %.251.i, i64 0
  %169 = getelementptr double, ptr %.267.i, i64 %.547.i.i
  %.576.i.i = getelementptr double, ptr %169, i64 %.562.i.i
  %.577.i.i = load double, ptr %.576.i.i, align 8, !noalias !39
  %.610.i.i = load double, ptr %171, align 8, !noalias !39
  store double %.577.i.i, ptr %171, align 8, !noalias !39
  store double %.610.i.i, ptr %.576.i.i, align 8, !noalias !39
  br i1 %.362493.not.i.i, label %B528.i.i, label %B466.if.i.i

B528.i.i:                                         ; preds = %B466.if.i.i, %B348.i.i
  %.942.i.i = sub i64 %.11.i492.i.i, %.131.i.i
  %.985504.not.i.i = icmp slt i64 %.942.i.i, 1
  br i1 %.985504.not.i.i, label %B34.loopexit.i.i, label %B566.if.i.i

B790.i.i:                                         ; preds = %B716.if.i.i, %B566.if.i.i
  %.985.i.i = icmp sgt i64 %.932.0506.i.i, 1
  br i1 %.985.i.i, label %B566.if.i.i, label %B34.loopexit.i.i

B36.if.i.i:                                       ; preds = %B34.loopexit.i.i, %B468.i
  %.59.0509.i.i = phi i64 [ 0, %B468.i ], [ %.131.i.i, %B34.loopexit.i.i ]
  %.131.i.i = add nsw i64 %.59.0509.i.i, 1
  %.161.i.i = mul nsw i64 %.59.0509.i.i, %arg.shape.1
  %.164.i.i = add nsw i64 %.59.0509.i.i, %.634.i
  %.165.i.i = add nsw i64 %.164.i.i, 1
  %.11.i.i.i10358 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.165.i.i, i64 %arg.shape.1)
  %.200.i.i = add i64 %.199.i.i, %.164.i.i
  %.11.i492.i.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.200.i.i, i64 %arg.shape.1)
  %170 = getelementptr double, ptr %.267.i, i64 %.161.i.i
  %171 = getelementptr double, ptr %170, i64 %.59.0509.i.i
  %.319.i.i = sub i64 %.11.i.i.i10358, %.131.i.i
  %storemerge488.i.i = tail call i64 @llvm.smax.i64(i64 %.319.i.i, i64 0)
  %.362493.not.i.i = icmp slt i64 %.319.i.i, 1
  br i1 %.362493.not.i.i, label %B348.i.i, label %B234.if.preheader.i.i

B234.if.preheader.i.i:                            ; preds = %B36.if.i.i
  %.271.i.i = load double, ptr %171, align 8, !noalias !39
  %.272.i.i = tail call double @llvm.fabs.f64(double %.271.i.i)
  br label %B234.if.i.i

B234.if.i.i:                                      ; preds = %B234.if.i.i, %B234.if.preheader.i.i
  %p.2.1497.i.i = phi i64 [ %p.3.2.i.i, %B234.if.i.i ], [ %.59.0509.i.i, %B234.if.preheader.i.i ]
  %largest.2.1496.i.i = phi double [ %largest.3.2.i.i, %B234.if.i.i ], [ %.272.i.i, %B234.if.preheader.i.i ]
  %.309.0495.i.i = phi i64 [ %.371.i.i, %B234.if.i.i ], [ %storemerge488.i.i, %B234.if.preheader.i.i ]
  %.306.0494.i.i = phi i64 [ %.375.i.i, %B234.if.i.i ], [ %.131.i.i, %B234.if.preheader.i.i ]
  %.371.i.i = add nsw i64 %.309.0495.i.i, -1
  %.375.i.i = add i64 %.306.0494.i.i, 1
  %.415.i.i = add nsw i64 %.306.0494.i.i, %.161.i.i
  %.429.i.i = icmp slt i64 %.415.i.i, 0
  %.430.i.i = select i1 %.429.i.i, i64 %.251.i, i64 0
  %172 = getelementptr double, ptr %.267.i, i64 %.415.i.i
  %.444.i.i = getelementptr double, ptr %172, i64 %.430.i.i
  %.445.i.i = load double, ptr %.444.i.i, align 8, !noalias !39
  %.446.i.i = tail call double @llvm.fabs.f64(double %.445.i.i)
  %.448.i.i = fcmp ogt double %.446.i.i, %largest.2.1496.i.i
  %largest.3.2.i.i = select i1 %.448.i.i, double %.446.i.i, double %largest.2.1496.i.i
  %p.3.2.i.i = select i1 %.448.i.i, i64 %.306.0494.i.i, i64 %p.2.1497.i.i
  %.362.i2254.i = icmp sgt i64 %.309.0495.i.i, 1
  br i1 %.362.i2254.i, label %B234.if.i.i, label %B348.i.i

B466.if.i.i:                                      ; preds = %B348.i.i, %B466.if.i.i
  %.706.0500.i.i = phi i64 [ %.768.i2255.i, %B466.if.i.i ], [ %storemerge488.i.i, %B348.i.i ]
  %.703.0499.i.i = phi i64 [ %.772.i.i, %B466.if.i.i ], [ %.131.i.i, %B348.i.i ]
  %.768.i2255.i = add nsw i64 %.706.0500.i.i, -1
  %.772.i.i = add i64 %.703.0499.i.i, 1
  %.798.i.i = add nsw i64 %.703.0499.i.i, %.161.i.i
  %.812.i.i = icmp slt i64 %.798.i.i, 0
  %.813.i.i = select i1 %.812.i.i, i64 %.251.i, i64 0
  %173 = getelementptr double, ptr %.267.i, i64 %.798.i.i
  %.827.i2256.i = getelementptr double, ptr %173, i64 %.813.i.i
  %.828.i.i = load double, ptr %.827.i2256.i, align 8, !noalias !39
  %.861.i.i = load double, ptr %171, align 8, !noalias !39
  %.865.i.i = fdiv double %.828.i.i, %.861.i.i
  store double %.865.i.i, ptr %.827.i2256.i, align 8, !noalias !39
  %.759.i2257.i = icmp sgt i64 %.706.0500.i.i, 1
  br i1 %.759.i2257.i, label %B466.if.i.i, label %B528.i.i

B566.if.i.i:                                      ; preds = %B528.i.i, %B790.i.i
  %.932.0506.i.i = phi i64 [ %.994.i.i, %B790.i.i ], [ %.942.i.i, %B528.i.i ]
  %.929.0505.i.i = phi i64 [ %.998.i.i, %B790.i.i ], [ %.131.i.i, %B528.i.i ]
  %.994.i.i = add nsw i64 %.932.0506.i.i, -1
  %.998.i.i = add i64 %.929.0505.i.i, 1
  %174 = mul nsw i64 %.929.0505.i.i, %arg.shape.1
  %.1030.i2258.i = add nsw i64 %174, %p.2.1.lcssa.i.i
  %.1044.i.i = icmp slt i64 %.1030.i2258.i, 0
  %.1045.i.i = select i1 %.1044.i.i, i64 %.251.i, i64 0
  %175 = getelementptr double, ptr %.267.i, i64 %.1030.i2258.i
  %.1059.i.i = getelementptr double, ptr %175, i64 %.1045.i.i
  %.1060.i.i = load double, ptr %.1059.i.i, align 8, !noalias !39
  %.1068.i.i = add nsw i64 %174, %.59.0509.i.i
  %.1082.i.i = icmp slt i64 %.1068.i.i, 0
  %.1083.i.i = select i1 %.1082.i.i, i64 %.251.i, i64 0
  %176 = getelementptr double, ptr %.267.i, i64 %.1068.i.i
  %.1097.i.i = getelementptr double, ptr %176, i64 %.1083.i.i
  %.1098.i.i = load double, ptr %.1097.i.i, align 8, !noalias !39
  store double %.1098.i.i, ptr %.1059.i.i, align 8, !noalias !39
  store double %.1060.i.i, ptr %.1097.i.i, align 8, !noalias !39
  %.1171.i2259.i = fcmp oeq double %.1060.i.i, 0.000000e+00
  %brmerge.i.i = or i1 %.362493.not.i.i, %.1171.i2259.i
  br i1 %brmerge.i.i, label %B790.i.i, label %B716.if.i.i

B716.if.i.i:                                      ; preds = %B566.if.i.i, %B716.if.i.i
  %.1202.0503.i.i = phi i64 [ %.1264.i2260.i, %B716.if.i.i ], [ %storemerge488.i.i, %B566.if.i.i ]
  %.1199.0502.i.i = phi i64 [ %.1268.i.i, %B716.if.i.i ], [ %.131.i.i, %B566.if.i.i ]
  %.1264.i2260.i = add nsw i64 %.1202.0503.i.i, -1
  %.1268.i.i = add i64 %.1199.0502.i.i, 1
  %.1296.i.i = add nsw i64 %.1199.0502.i.i, %174
  %.1310.i.i = icmp slt i64 %.1296.i.i, 0
  %.1311.i2261.i = select i1 %.1310.i.i, i64 %.251.i, i64 0
  %177 = getelementptr double, ptr %.267.i, i64 %.1296.i.i
  %.1325.i.i = getelementptr double, ptr %177, i64 %.1311.i2261.i
  %.1326.i.i = load double, ptr %.1325.i.i, align 8, !noalias !39
  %.1328.i.i = add nsw i64 %.1199.0502.i.i, %.161.i.i
  %.1342.i.i = icmp slt i64 %.1328.i.i, 0
  %.1343.i.i = select i1 %.1342.i.i, i64 %.251.i, i64 0
  %178 = getelementptr double, ptr %.267.i, i64 %.1328.i.i
  %.1357.i.i = getelementptr double, ptr %178, i64 %.1343.i.i
  %.1358.i.i = load double, ptr %.1357.i.i, align 8, !noalias !39
  %.1360.i.i = fmul double %.1060.i.i, %.1358.i.i
  %.1361.i.i = fsub double %.1326.i.i, %.1360.i.i
  store double %.1361.i.i, ptr %.1325.i.i, align 8, !noalias !39
  %.1255.i.i = icmp sgt i64 %.1202.0503.i.i, 1
  br i1 %.1255.i.i, label %B716.if.i.i, label %B790.i.i

B0.else.endif.if.i:                               ; preds = %B1308
  br label %B0.else.endif.endif.endif.if.i

B0.else.endif.endif.endif.if.i:                   ; preds = %B0.else.endif.if.i, %B1308
  %.154.sroa.0.3.i = phi i64 [ %arg.linear.0.5.0, %B0.else.endif.if.i ], [ %.127.i, %B1308 ]
  %.242.i = sub i64 %arg.linear.0.5.0, %.154.sroa.0.3.i
  %.251.i = tail call i64 @llvm.smax.i64(i64 %.242.i, i64 0)
  %.267.i = getelementptr double, ptr %arg.linear.0.4, i64 %.154.sroa.0.3.i
  br i1 %.344.i, label %B0.endif.else.endif.if.i, label %B0.endif.else.endif.endif.i, !prof !32

B0.endif.else.endif.if.i:                         ; preds = %B0.else.endif.endif.endif.if.i
  br label %B0.endif.else.endif.endif.i

B0.endif.else.endif.endif.i:                      ; preds = %B0.endif.else.endif.if.i, %B0.else.endif.endif.endif.if.i
  %.324.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.if.i ], [ 5, %B0.else.endif.endif.endif.if.i ]
  %.437.i = getelementptr i64, ptr %arg.linear.1.4, i64 %.324.sroa.0.3.i
  %.525.i = load double, ptr %.524.i, align 8, !noalias !38
  %.526.i = fcmp olt double %.525.i, 5.000000e-01
  br i1 %.526.i, label %B124.i10359, label %B164.i

B226.if.i:                                        ; preds = %B396.i, %B226.if.lr.ph.i
  %.697.02298.i = phi i64 [ 0, %B226.if.lr.ph.i ], [ %.766.i, %B396.i ]
  %.766.i = add nsw i64 %.697.02298.i, 1
  %.798.i10354 = sub i64 %.697.02298.i, %166
  %.11.i.i10355 = tail call i64 @llvm.smax.i64(i64 %.798.i10354, i64 0)
  %.830.i = add i64 %.829.i, %.697.02298.i
  %.11.i2262.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.830.i, i64 %arg.shape.1)
  %.896.i = sub i64 %.11.i2262.i, %.11.i.i10355
  %.9392294.not.i = icmp slt i64 %.896.i, 1
  br i1 %.9392294.not.i, label %B396.i, label %B342.if.lr.ph.i

B342.if.lr.ph.i:                                  ; preds = %B226.if.i
  %.979.i10356 = mul nsw i64 %.697.02298.i, %arg.shape.1
  br label %B342.if.i

B342.if.i:                                        ; preds = %B342.if.i, %B342.if.lr.ph.i
  %.886.02296.i = phi i64 [ %.896.i, %B342.if.lr.ph.i ], [ %.948.i, %B342.if.i ]
  %.883.02295.i = phi i64 [ %.11.i.i10355, %B342.if.lr.ph.i ], [ %.952.i, %B342.if.i ]
  %.948.i = add nsw i64 %.886.02296.i, -1
  %.952.i = add i64 %.883.02295.i, 1
  %.980.i = add nsw i64 %.883.02295.i, %.979.i10356
  %.994.i = icmp slt i64 %.980.i, 0
  %.995.i = select i1 %.994.i, i64 %arg.linear.0.5.0, i64 0
  %179 = getelementptr double, ptr %arg.linear.0.4, i64 %.980.i
  %.1009.i = getelementptr double, ptr %179, i64 %.995.i
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !38
  %.1011.i = fneg double %.1010.i
  %.1030.i10357 = select i1 %.994.i, i64 %.251.i, i64 0
  %180 = getelementptr double, ptr %.267.i, i64 %.980.i
  %.1044.i = getelementptr double, ptr %180, i64 %.1030.i10357
  store double %.1011.i, ptr %.1044.i, align 8, !noalias !38
  %.939.i = icmp sgt i64 %.886.02296.i, 1
  br i1 %.939.i, label %B342.if.i, label %B396.i

B1348:                                            ; preds = %B34.loopexit.i.i, %B164.i, %B1304
  br i1 %.202710707.not, label %B1606, label %B1380.if

B1568:                                            ; preds = %B1380.if
  br i1 %.88.not.i, label %B0.else.endif.endif.endif.if.i10369, label %B0.else.endif.if.i10368, !prof !25

B322.i:                                           ; preds = %B192.if.i
  %.853.i = load i64, ptr %arg.linear.1.4, align 8, !noalias !42
  %.883.i = load i64, ptr %.882.i, align 8, !noalias !42
  %.339.i.i = add i64 %.853.i, 1
  br label %B34.if.i.i10375

B34.i.loopexit.i:                                 ; preds = %B198.if.i.i, %B34.if.i.i10375
  %exitcond766.not.i = icmp eq i64 %arg.shape.1, %.144.i.i
  br i1 %exitcond766.not.i, label %B314.if.i.lr.ph.i, label %B34.if.i.i10375

B314.if.i.lr.ph.i:                                ; preds = %B34.i.loopexit.i
  %181 = add i64 %.883.i, %.853.i
  br label %B314.if.i.i

B314.i.loopexit.i:                                ; preds = %B474.if.i.i, %B314.if.i.i
  %.683.i.i = icmp sgt i64 %.627.i.0762.in.i, 1
  br i1 %.683.i.i, label %B314.if.i.i, label %B434.if.lr.ph.i

B434.if.lr.ph.i:                                  ; preds = %B314.i.loopexit.i
  %.1110.i = mul nsw i64 %.2040, %arg.shape.1
  br label %B434.if.i

B34.if.i.i10375:                                  ; preds = %B34.i.loopexit.i, %B322.i
  %.73.i.0754.i = phi i64 [ 0, %B322.i ], [ %.144.i.i, %B34.i.loopexit.i ]
  %.144.i.i = add nsw i64 %.73.i.0754.i, 1
  %182 = getelementptr i64, ptr %.358.i10372, i64 %.73.i.0754.i
  %.202.i.i = load i64, ptr %182, align 8, !noalias !45
  %.204.i.i = add nsw i64 %.202.i.i, %.887.i
  %.218.i.i = icmp slt i64 %.204.i.i, 0
  %.219.i.i = select i1 %.218.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %183 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.204.i.i
  %.233.i.i = getelementptr double, ptr %183, i64 %.219.i.i
  %.234.i.i10376 = load double, ptr %.233.i.i, align 8, !noalias !45
  %gep10706 = getelementptr double, ptr %invariant.gep10705, i64 %.73.i.0754.i
  %.270.i.i = load double, ptr %gep10706, align 8, !noalias !45
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !45
  store double %.234.i.i10376, ptr %gep10706, align 8, !noalias !45
  %.340.i.i = add i64 %.339.i.i, %.73.i.0754.i
  %.11.i.i.i10377 = tail call i64 @llvm.smin.i64(i64 %.340.i.i, i64 %arg.shape.1)
  %.406.i.i = sub i64 %.11.i.i.i10377, %.144.i.i
  %.449.i750.not.i = icmp slt i64 %.406.i.i, 1
  br i1 %.449.i750.not.i, label %B34.i.loopexit.i, label %B198.if.i.lr.ph.i

B198.if.i.lr.ph.i:                                ; preds = %B34.if.i.i10375
  %.521.i.i = mul nsw i64 %.73.i.0754.i, %arg.shape.1
  br label %B198.if.i.i

B198.if.i.i:                                      ; preds = %B198.if.i.i, %B198.if.i.lr.ph.i
  %.396.i.0752.i = phi i64 [ %.406.i.i, %B198.if.i.lr.ph.i ], [ %.458.i.i, %B198.if.i.i ]
  %.393.i.0751.i = phi i64 [ %.144.i.i, %B198.if.i.lr.ph.i ], [ %.462.i.i, %B198.if.i.i ]
  %.458.i.i = add nsw i64 %.396.i.0752.i, -1
  %.462.i.i = add i64 %.393.i.0751.i, 1
  %.488.i.i = add nsw i64 %.393.i.0751.i, %.887.i
  %.502.i.i10378 = icmp slt i64 %.488.i.i, 0
  %.503.i.i = select i1 %.502.i.i10378, i64 %arg.batch.5.0.5.0, i64 0
  %184 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.488.i.i
  %.517.i.i = getelementptr double, ptr %184, i64 %.503.i.i
  %.518.i.i = load double, ptr %.517.i.i, align 8, !noalias !45
  %.522.i.i = add nsw i64 %.393.i.0751.i, %.521.i.i
  %.536.i.i = icmp slt i64 %.522.i.i, 0
  %.537.i.i = select i1 %.536.i.i, i64 %.165.i, i64 0
  %185 = getelementptr double, ptr %.181.i, i64 %.522.i.i
  %.551.i.i = getelementptr double, ptr %185, i64 %.537.i.i
  %.552.i.i = load double, ptr %.551.i.i, align 8, !noalias !45
  %.554.i.i = fmul double %.234.i.i10376, %.552.i.i
  %.555.i.i = fsub double %.518.i.i, %.554.i.i
  store double %.555.i.i, ptr %.517.i.i, align 8, !noalias !45
  %.449.i.i = icmp sgt i64 %.396.i.0752.i, 1
  br i1 %.449.i.i, label %B198.if.i.i, label %B34.i.loopexit.i

B314.if.i.i:                                      ; preds = %B314.i.loopexit.i, %B314.if.i.lr.ph.i
  %.627.i.0762.in.i = phi i64 [ %arg.shape.1, %B314.if.i.lr.ph.i ], [ %.627.i.0762.i, %B314.i.loopexit.i ]
  %.627.i.0762.i = add nsw i64 %.627.i.0762.in.i, -1
  %.726.i.i = add nsw i64 %.627.i.0762.i, %.887.i
  %.740.i.i = icmp slt i64 %.726.i.i, 0
  %.741.i.i = select i1 %.740.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %186 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.726.i.i
  %.755.i.i = getelementptr double, ptr %186, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i, align 8, !noalias !45
  %.759.i.i10379 = mul nsw i64 %.627.i.0762.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i10379, %.627.i.0762.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %.165.i, i64 0
  %187 = getelementptr double, ptr %.181.i, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %187, i64 %.776.i.i
  %.791.i.i = load double, ptr %.790.i.i, align 8, !noalias !45
  %.795.i.i = fdiv double %.756.i.i, %.791.i.i
  store double %.795.i.i, ptr %.755.i.i, align 8, !noalias !45
  %.866.i.i = sub i64 %.627.i.0762.i, %181
  %.11.i4.i.i = tail call i64 @llvm.smax.i64(i64 %.866.i.i, i64 0)
  %.932.i.i = sub i64 %.627.i.0762.i, %.11.i4.i.i
  %.975.i756.not.i = icmp slt i64 %.932.i.i, 1
  br i1 %.975.i756.not.i, label %B314.i.loopexit.i, label %B474.if.i.i

B474.if.i.i:                                      ; preds = %B314.if.i.i, %B474.if.i.i
  %.922.i.0758.i = phi i64 [ %.984.i.i, %B474.if.i.i ], [ %.932.i.i, %B314.if.i.i ]
  %.919.i.0757.i = phi i64 [ %.988.i.i, %B474.if.i.i ], [ %.11.i4.i.i, %B314.if.i.i ]
  %.984.i.i = add nsw i64 %.922.i.0758.i, -1
  %.988.i.i = add i64 %.919.i.0757.i, 1
  %.1014.i.i10380 = add nsw i64 %.919.i.0757.i, %.887.i
  %.1028.i.i = icmp slt i64 %.1014.i.i10380, 0
  %.1029.i.i = select i1 %.1028.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %188 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1014.i.i10380
  %.1043.i.i = getelementptr double, ptr %188, i64 %.1029.i.i
  %.1044.i.i10381 = load double, ptr %.1043.i.i, align 8, !noalias !45
  %.1048.i.i = add nsw i64 %.919.i.0757.i, %.759.i.i10379
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %.165.i, i64 0
  %189 = getelementptr double, ptr %.181.i, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %189, i64 %.1063.i.i
  %.1078.i.i = load double, ptr %.1077.i.i, align 8, !noalias !45
  %.1080.i.i = fmul double %.795.i.i, %.1078.i.i
  %.1081.i.i = fsub double %.1044.i.i10381, %.1080.i.i
  store double %.1081.i.i, ptr %.1043.i.i, align 8, !noalias !45
  %.975.i.i = icmp sgt i64 %.922.i.0758.i, 1
  br i1 %.975.i.i, label %B474.if.i.i, label %B314.i.loopexit.i

B0.else.endif.if.i10368:                          ; preds = %B1568
  br label %B0.else.endif.endif.endif.if.i10369

B0.else.endif.endif.endif.if.i10369:              ; preds = %B0.else.endif.if.i10368, %B1568
  %.68.sroa.0.3.i = phi i64 [ %arg.linear.0.5.0, %B0.else.endif.if.i10368 ], [ %.42.i, %B1568 ]
  %.156.i = sub i64 %arg.linear.0.5.0, %.68.sroa.0.3.i
  %.165.i = tail call i64 @llvm.smax.i64(i64 %.156.i, i64 0)
  %.181.i = getelementptr double, ptr %arg.linear.0.4, i64 %.68.sroa.0.3.i
  br i1 %.265.i, label %B0.endif.else.endif.if.i10383, label %B0.endif.else.endif.endif.i10370, !prof !32

B0.endif.else.endif.if.i10383:                    ; preds = %B0.else.endif.endif.endif.if.i10369
  br label %B0.endif.else.endif.endif.i10370

B0.endif.else.endif.endif.i10370:                 ; preds = %B0.endif.else.endif.if.i10383, %B0.else.endif.endif.endif.if.i10369
  %.245.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.if.i10383 ], [ 5, %B0.else.endif.endif.endif.if.i10369 ]
  %.358.i10372 = getelementptr i64, ptr %arg.linear.1.4, i64 %.245.sroa.0.3.i
  br i1 %.277.i, label %B0.endif.endif.else.if.i, label %B0.endif.endif.else.endif.i, !prof !32

B192.if.lr.ph.i:                                  ; preds = %B0.endif.endif.else.endif.endif.endif.i
  %.689.i = mul nsw i64 %.2040, %arg.shape.1
  br label %B192.if.i

B0.endif.endif.else.if.i:                         ; preds = %B0.endif.else.endif.endif.i10370
  br label %B0.endif.endif.else.endif.i

B0.endif.endif.else.endif.i:                      ; preds = %B0.endif.endif.else.if.i, %B0.endif.else.endif.endif.i10370
  %.418.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.else.if.i ], [ %.274.i, %B0.endif.else.endif.endif.i10370 ]
  br i1 %.282.not.i, label %B0.endif.endif.else.endif.endif.endif.i, label %B0.endif.endif.else.endif.if.i, !prof !25

B0.endif.endif.else.endif.if.i:                   ; preds = %B0.endif.endif.else.endif.i
  br label %B0.endif.endif.else.endif.endif.endif.i

B0.endif.endif.else.endif.endif.endif.i:          ; preds = %B0.endif.endif.else.endif.if.i, %B0.endif.endif.else.endif.i
  %.418.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.if.i ], [ %.418.sroa.0.1.i, %B0.endif.endif.else.endif.i ]
  %.531.i = getelementptr i64, ptr %arg.linear.1.4, i64 %.418.sroa.0.3.i
  br i1 %.648747.not.i, label %B1604, label %B192.if.lr.ph.i

B192.if.i:                                        ; preds = %B192.if.i, %B192.if.lr.ph.i
  %.590.0748.i = phi i64 [ 0, %B192.if.lr.ph.i ], [ %.661.i, %B192.if.i ]
  %.661.i = add nsw i64 %.590.0748.i, 1
  %.690.i = add nsw i64 %.590.0748.i, %.689.i
  %.704.i = icmp slt i64 %.690.i, 0
  %.705.i = select i1 %.704.i, i64 %arg.batch.5.0.5.0, i64 0
  %190 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.690.i
  %.719.i = getelementptr double, ptr %190, i64 %.705.i
  %.720.i = load double, ptr %.719.i, align 8, !noalias !42
  %gep10704 = getelementptr double, ptr %invariant.gep10703, i64 %.590.0748.i
  %.753.i = load double, ptr %gep10704, align 8, !noalias !42
  %.754.i = fadd double %.720.i, %.753.i
  %191 = getelementptr i64, ptr %.531.i, i64 %.590.0748.i
  %.786.i = load i64, ptr %191, align 8, !noalias !42
  %.787.i = add nsw i64 %.786.i, %.756.i
  %.801.i = icmp slt i64 %.787.i, 0
  %.802.i = select i1 %.801.i, i64 %arg.batch.5.0.5.0, i64 0
  %192 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.787.i
  %.816.i = getelementptr double, ptr %192, i64 %.802.i
  store double %.754.i, ptr %.816.i, align 8, !noalias !42
  %exitcond.not.i10374 = icmp eq i64 %arg.shape.1, %.661.i
  br i1 %exitcond.not.i10374, label %B322.i, label %B192.if.i

B434.if.i:                                        ; preds = %B434.if.i, %B434.if.lr.ph.i
  %.950.0764.i = phi i64 [ 0, %B434.if.lr.ph.i ], [ %.1019.i, %B434.if.i ]
  %.1019.i = add nsw i64 %.950.0764.i, 1
  %193 = getelementptr i64, ptr %.531.i, i64 %.950.0764.i
  %.1075.i = load i64, ptr %193, align 8, !noalias !42
  %.1076.i = add nsw i64 %.1075.i, %.887.i
  %.1090.i = icmp slt i64 %.1076.i, 0
  %.1091.i = select i1 %.1090.i, i64 %arg.batch.5.0.5.0, i64 0
  %194 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1076.i
  %.1105.i = getelementptr double, ptr %194, i64 %.1091.i
  %.1106.i = load double, ptr %.1105.i, align 8, !noalias !42
  %.1111.i = add nsw i64 %.950.0764.i, %.1110.i
  %.1125.i = icmp slt i64 %.1111.i, 0
  %.1126.i = select i1 %.1125.i, i64 %arg.batch.5.0.5.0, i64 0
  %195 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1111.i
  %.1140.i10382 = getelementptr double, ptr %195, i64 %.1126.i
  store double %.1106.i, ptr %.1140.i10382, align 8, !noalias !42
  %exitcond767.not.i = icmp eq i64 %arg.shape.1, %.1019.i
  br i1 %exitcond767.not.i, label %B1604, label %B434.if.i

B1604:                                            ; preds = %B434.if.i, %B0.endif.endif.else.endif.endif.endif.i, %B1380.if
  %exitcond10878.not = icmp eq i64 %.1971.010708, %storemerge10235
  br i1 %exitcond10878.not, label %B1606, label %B1380.if

B1606:                                            ; preds = %B1604, %B1348
  %.2304 = load i64, ptr %.2303, align 8
  %.2349 = inttoptr i64 %.2304 to ptr
  tail call void %.2349(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %brmerge10322 = select i1 %.983, i1 true, i1 %.541
  %or.cond10323 = select i1 %brmerge10322, i1 true, i1 %.2380
  %spec.select10344 = select i1 %or.cond10323, i1 true, i1 %.2385
  br i1 %.603, label %B1838, label %B1748.if

B1756:                                            ; preds = %B1748.if
  %196 = getelementptr double, ptr %31, i64 %.2425.010711
  %.2584 = load double, ptr %196, align 8
  %.2585 = fcmp ogt double %.2584, 5.000000e-01
  br label %B1792

B1792:                                            ; preds = %B1756, %B1748.if
  %"$phi1792.1.2.2" = phi i1 [ true, %B1748.if ], [ %.2585, %B1756 ]
  br i1 %looked.4.210714, label %B1834, label %B1798

B1798:                                            ; preds = %B1792
  %197 = getelementptr double, ptr %32, i64 %.2425.010711
  %.2659 = load double, ptr %197, align 8
  %.2660 = fcmp ogt double %.2659, 5.000000e-01
  br label %B1834

B1834:                                            ; preds = %B1798, %B1792
  %"$phi1834.1.2.2" = phi i1 [ true, %B1792 ], [ %.2660, %B1798 ]
  %.2481 = icmp sgt i64 %.2428.010712, 1
  br i1 %.2481, label %B1748.if, label %B1838

B1838:                                            ; preds = %B1834, %B1606
  %good.2.1.lcssa = phi i1 [ false, %B1606 ], [ %"$phi1792.1.2.2", %B1834 ]
  %looked.4.2.lcssa = phi i1 [ %spec.select10344, %B1606 ], [ %"$phi1834.1.2.2", %B1834 ]
  %looked.4.2.lcssa.not10889 = xor i1 %looked.4.2.lcssa, true
  %brmerge10890 = or i1 %.603, %looked.4.2.lcssa.not10889
  br i1 %brmerge10890, label %B2416, label %B80.if.i

B1908.preheader:                                  ; preds = %B502.i
  br i1 %.603, label %B2416, label %B1908.if

B126.i:                                           ; preds = %B80.if.i
  %.318.i590 = getelementptr double, ptr %33, i64 %.105.i437.010718
  %.319.i591 = load double, ptr %.318.i590, align 8, !noalias !49
  %.5.i.i = fptosi double %.319.i591 to i64
  %.397.i = getelementptr double, ptr %34, i64 %.105.i437.010718
  %.398.i635 = load double, ptr %.397.i, align 8, !noalias !49
  %.5.i1.i = fptosi double %.398.i635 to i64
  %.472.i681 = mul i64 %.258.i545, %arg.batch.3.3.5.1
  %.476.i685 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.472.i681
  %.477.i686 = load i64, ptr %.476.i685, align 8, !noalias !49
  %.478.i687 = add nsw i64 %.477.i686, %.5.i.i
  store i64 %.478.i687, ptr %.476.i685, align 8, !noalias !49
  %.584.i768 = getelementptr i8, ptr %.476.i685, i64 24
  %.585.i769 = load i64, ptr %.584.i768, align 8, !noalias !49
  %.586.i770 = add nsw i64 %.585.i769, %.5.i1.i
  store i64 %.586.i770, ptr %.584.i768, align 8, !noalias !49
  %.694.i857 = getelementptr i8, ptr %.476.i685, i64 8
  %.695.i858 = load i64, ptr %.694.i857, align 8, !noalias !49
  %.698.i861 = add nsw i64 %.5.i1.i, %.5.i.i
  %.699.i = mul nsw i64 %.698.i861, %.1984
  %.700.i862 = add nsw i64 %.699.i, %.5.i.i
  %.701.i = add nsw i64 %.700.i862, %.695.i858
  store i64 %.701.i, ptr %.694.i857, align 8, !noalias !49
  store double 0.000000e+00, ptr %.318.i590, align 8, !noalias !49
  store double 0.000000e+00, ptr %.397.i, align 8, !noalias !49
  %.923.i = getelementptr double, ptr %35, i64 %.105.i437.010718
  %.924.i1016 = load double, ptr %.923.i, align 8, !noalias !49
  %.926.i = sitofp i64 %.698.i861 to double
  %.927.i = fsub double %.924.i1016, %.926.i
  store double %.927.i, ptr %.923.i, align 8, !noalias !49
  br label %B502.i

B502.i:                                           ; preds = %B126.i, %B80.if.i
  %.163.i494 = icmp sgt i64 %.108.i438.010719, 1
  br i1 %.163.i494, label %B80.if.i, label %B1908.preheader

B80.if.i:                                         ; preds = %B1838, %B502.i
  %.108.i438.010719 = phi i64 [ %.172.i1046, %B502.i ], [ %storemerge, %B1838 ]
  %.105.i437.010718 = phi i64 [ %.176.i, %B502.i ], [ 0, %B1838 ]
  %.172.i1046 = add nsw i64 %.108.i438.010719, -1
  %.176.i = add nsw i64 %.105.i437.010718, 1
  %198 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i437.010718
  %.258.i545 = load i64, ptr %198, align 8, !noalias !49
  %.263.i = icmp sgt i64 %.258.i545, -1
  br i1 %.263.i, label %B126.i, label %B502.i

B2008:                                            ; preds = %B1908.if
  %.3114 = getelementptr double, ptr %38, i64 %.2780.010721
  %.3115 = load double, ptr %.3114, align 8
  %.3116 = fcmp ogt double %.3115, 5.000000e-01
  br i1 %.3116, label %B2046, label %B2146

B2046:                                            ; preds = %B2008
  %.5.i = fptosi double %.3115 to i64
  %199 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2780.010721
  %.84.i1916 = load i64, ptr %199, align 8, !noalias !53
  %.89.i1919 = icmp sgt i64 %.84.i1916, -1
  br i1 %.89.i1919, label %B46.i, label %B2146

B2146:                                            ; preds = %B2008, %B46.i, %B2046, %B80.i1953
  %.3302 = getelementptr double, ptr %39, i64 %.2780.010721
  %.3303 = load double, ptr %.3302, align 8
  %.3304 = fcmp ogt double %.3303, 5.000000e-01
  br i1 %.3304, label %B2184, label %B2414

B2184:                                            ; preds = %B2146
  %spec.select = select i1 %within.3.210723, i1 true, i1 %.2380
  %.3380 = mul i64 %.2941, %arg.batch.3.3.5.1
  %.3384 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.3380
  %.3385 = load i64, ptr %.3384, align 8
  %.3396.0 = and i64 %.3385, 127
  %.3426 = icmp eq i64 %.3396.0, 0
  br i1 %.3426, label %B2292, label %B2254

B2254:                                            ; preds = %B2184
  %.3487 = getelementptr double, ptr %40, i64 %.2780.010721
  %.3488 = load double, ptr %.3487, align 8
  %.3490 = fcmp ogt double %.3488, 0.000000e+00
  br i1 %.3490, label %B2292, label %B2322

B2292:                                            ; preds = %B2184, %B2254
  store double 1.000000e+00, ptr %.3056, align 8
  br label %B2322

B2322:                                            ; preds = %B2292, %B2254
  %doubted.5.5 = phi i1 [ true, %B2292 ], [ %doubted.3.210724, %B2254 ]
  %.3573 = icmp slt i64 %.2996, %arg.batch.2.5.0
  br i1 %.3573, label %B2360, label %B2414

B2360:                                            ; preds = %B2322
  %.3597 = icmp slt i64 %.2996, 0
  %.3598 = select i1 %.3597, i64 %arg.batch.2.5.0, i64 0
  %200 = getelementptr double, ptr %arg.batch.2.4, i64 %.2996
  %.3612 = getelementptr double, ptr %200, i64 %.3598
  %.3613 = load double, ptr %.3612, align 8
  %.3671 = getelementptr double, ptr %41, i64 %.2780.010721
  %.3672 = load double, ptr %.3671, align 8
  %.3673 = fcmp olt double %.3613, %.3672
  br i1 %.3673, label %B2410, label %B2414

B2410:                                            ; preds = %B2360
  br label %B2414

B2414:                                            ; preds = %B1908.if, %B2410, %B2360, %B2322, %B2146
  %within.4.3 = phi i1 [ true, %B2410 ], [ %spec.select, %B2360 ], [ %spec.select, %B2322 ], [ %within.3.210723, %B2146 ], [ %within.3.210723, %B1908.if ]
  %doubted.4.3 = phi i1 [ %doubted.5.5, %B2410 ], [ %doubted.5.5, %B2360 ], [ %doubted.5.5, %B2322 ], [ %doubted.3.210724, %B2146 ], [ %doubted.3.210724, %B1908.if ]
  %.2842 = icmp sgt i64 %.2783.010722, 1
  br i1 %.2842, label %B1908.if, label %B2416.loopexit

B2416.loopexit:                                   ; preds = %B2414
  %201 = xor i1 %doubted.4.3, true
  %202 = select i1 %201, i1 true, i1 %.545
  br label %B2416

B2416:                                            ; preds = %B1838, %B2416.loopexit, %B1908.preheader
  %within.5.1 = phi i1 [ false, %B1838 ], [ false, %B1908.preheader ], [ %within.4.3, %B2416.loopexit ]
  %doubted.2.1 = phi i1 [ true, %B1838 ], [ true, %B1908.preheader ], [ %202, %B2416.loopexit ]
  %brmerge10324.not = select i1 %good.2.1.lcssa, i1 %.543.not, i1 false
  br i1 %brmerge10324.not, label %B2424, label %B2540

B2424:                                            ; preds = %B2416
  %.3749 = load i64, ptr %arg.code.4, align 8
  %.3799 = inttoptr i64 %.3749 to ptr
  tail call void %.3799(ptr %.502, ptr %.3773, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.3798)
  br label %B2540

B2540:                                            ; preds = %B2416, %B2424
  br i1 %doubted.2.1, label %B2616, label %B2548

B2548:                                            ; preds = %B2540
  %.3837 = load i64, ptr %.3836, align 8
  %.3882 = inttoptr i64 %.3837 to ptr
  tail call void %.3882(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B2616

B2616:                                            ; preds = %B2540, %B2548
  %203 = select i1 %.2385, i1 %good.2.1.lcssa, i1 false
  br i1 %203, label %B2636, label %B2742

B2636:                                            ; preds = %B2616
  %.3931 = load i64, ptr %.3930, align 8
  %.3976 = inttoptr i64 %.3931 to ptr
  tail call void %.3976(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.603, label %B188.if.i.preheader, label %B108.if.i

B186.i.loopexit.critedge:                         ; preds = %B188.if.i
  %.625.i2308.c = icmp ult i64 %.361.i2111.010744, 8
  %.10328.c = select i1 %.625.i2308.c, i64 16, i64 17
  %.672.i2338.c = load i64, ptr %.671.i2337, align 8, !noalias !56
  %.744.i2393.c = mul i64 %.742.i2391, %.10328.c
  %.762.i2401.c = getelementptr double, ptr %arg.batch.5.0.4, i64 %.744.i2393.c
  %.788.i2411.c = inttoptr i64 %.672.i2338.c to ptr
  tail call void %.788.i2411.c(ptr %.502, ptr %.762.i2401.c, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !56
  br label %B186.i.loopexit

B186.i.loopexit:                                  ; preds = %B770.i, %B186.i.loopexit.critedge
  %some.2.i.1.lcssa = phi i1 [ %some.4.i.010746, %B186.i.loopexit.critedge ], [ %some.3.i.2, %B770.i ]
  %exitcond10881.not = icmp eq i64 %.431.i2895, 9
  br i1 %exitcond10881.not, label %B806.i.preheader, label %B188.if.i

B806.i.preheader:                                 ; preds = %B186.i.loopexit
  br i1 %.603, label %B2742, label %B806.if.i

B222.i.loopexit:                                  ; preds = %B122.if.i.i, %B222.if.i
  %.539.i2299 = icmp sgt i64 %.486.i2121.010738, 1
  br i1 %.539.i2299, label %B222.if.i, label %B284.i

B284.i:                                           ; preds = %B222.i.loopexit
  %.625.i2308 = icmp ult i64 %.361.i2111.010744, 8
  %.10328 = select i1 %.625.i2308, i64 16, i64 17
  %.672.i2338 = load i64, ptr %.671.i2337, align 8, !noalias !56
  %.744.i2393 = mul i64 %.742.i2391, %.10328
  %.762.i2401 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.744.i2393
  %.788.i2411 = inttoptr i64 %.672.i2338 to ptr
  tail call void %.788.i2411(ptr %.502, ptr %.762.i2401, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !56
  %.1181.i = add nsw i64 %.361.i2111.010744, -1
  %.1182.i2620 = sitofp i64 %.1181.i to double
  %.1187.i = fmul double %.1182.i2620, 1.250000e-01
  %.1189.i = uitofp i64 %.361.i2111.010744 to double
  %.1194.i = fmul double %.1189.i, 1.250000e-01
  br label %B466.if.i

B508.i:                                           ; preds = %B466.if.i
  %.1028.i = getelementptr double, ptr %44, i64 %.814.i2139.010740
  %.1029.i2519 = load double, ptr %.1028.i, align 8, !noalias !56
  %.1030.i = fcmp ogt double %.1029.i2519, 5.000000e-01
  br i1 %.1030.i, label %B546.i, label %B770.i

B546.i:                                           ; preds = %B508.i
  %.1088.i2554 = getelementptr i64, ptr %45, i64 %.814.i2139.010740
  %.1089.i2555 = load i64, ptr %.1088.i2554, align 8, !noalias !56
  %.1090.i2556 = icmp slt i64 %.1089.i2555, 0
  br i1 %.1090.i2556, label %B34.i.i, label %B770.i

B34.i.i:                                          ; preds = %B546.i, %B36.i.i
  %.48.i.i1982.0 = phi i64 [ %.119.i88.i, %B36.i.i ], [ 0, %B546.i ]
  %.51.i12.i.0 = phi i64 [ %.115.i.i2635, %B36.i.i ], [ %arg.shape.6, %B546.i ]
  %.106.i.i2586 = icmp sgt i64 %.51.i12.i.0, 0
  br i1 %.106.i.i2586, label %B36.i.i, label %B584.endif.i

B36.i.i:                                          ; preds = %B34.i.i
  %.115.i.i2635 = add nsw i64 %.51.i12.i.0, -1
  %.119.i88.i = add i64 %.48.i.i1982.0, 1
  %.149.i53.i = add nsw i64 %.48.i.i1982.0, %arg.shape.6
  %.151.i55.i = mul nsw i64 %.149.i53.i, %arg.shape.0
  %.153.i56.i = add nsw i64 %.151.i55.i, %.814.i2139.010740
  %.167.i61.i = icmp slt i64 %.153.i56.i, 0
  %.168.i62.i = select i1 %.167.i61.i, i64 %arg.batch.5.4.5.0, i64 0
  %204 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i56.i
  %.182.i74.i = getelementptr double, ptr %204, i64 %.168.i62.i
  %.183.i75.i = load double, ptr %.182.i74.i, align 8, !noalias !60
  %.184.i.i = fcmp ogt double %.183.i75.i, 5.000000e-01
  br i1 %.184.i.i, label %B584.endif.i, label %B34.i.i

B732.i:                                           ; preds = %B584.endif.i
  %.1369.i = load i64, ptr %.1088.i2554, align 8, !noalias !56
  %.1370.i = icmp sgt i64 %.1369.i, -1
  br label %B770.i

B770.i:                                           ; preds = %B732.i, %B584.endif.i, %B546.i, %B508.i, %B466.if.i
  %some.3.i.2 = phi i1 [ %some.2.i.110742, %B466.if.i ], [ %some.2.i.110742, %B546.i ], [ %some.2.i.110742, %B508.i ], [ true, %B584.endif.i ], [ %.1370.i, %B732.i ]
  %.870.i2443 = icmp sgt i64 %.817.i2140.010741, 1
  br i1 %.870.i2443, label %B466.if.i, label %B186.i.loopexit

B108.if.i:                                        ; preds = %B2636, %B108.if.i
  %.179.i2101.010729 = phi i64 [ %.243.i2953, %B108.if.i ], [ %storemerge, %B2636 ]
  %.176.i2100.010728 = phi i64 [ %.247.i2955, %B108.if.i ], [ 0, %B2636 ]
  %.243.i2953 = add nsw i64 %.179.i2101.010729, -1
  %.247.i2955 = add nsw i64 %.176.i2100.010728, 1
  %205 = getelementptr i64, ptr %42, i64 %.176.i2100.010728
  store i64 -1, ptr %205, align 8, !noalias !56
  %.234.i2211 = icmp sgt i64 %.179.i2101.010729, 1
  br i1 %.234.i2211, label %B108.if.i, label %B188.if.i.preheader

B188.if.i.preheader:                              ; preds = %B108.if.i, %B2636
  br label %B188.if.i

B188.if.i:                                        ; preds = %B188.if.i.preheader, %B186.i.loopexit
  %some.4.i.010746 = phi i1 [ %some.2.i.1.lcssa, %B186.i.loopexit ], [ false, %B188.if.i.preheader ]
  %.361.i2111.010744 = phi i64 [ %.431.i2895, %B186.i.loopexit ], [ 1, %B188.if.i.preheader ]
  %.431.i2895 = add nsw i64 %.361.i2111.010744, 1
  br i1 %.603, label %B186.i.loopexit.critedge, label %B222.if.i.lr.ph

B222.if.i.lr.ph:                                  ; preds = %B188.if.i
  %.579.i2656 = uitofp i64 %.361.i2111.010744 to double
  %.584.i2657 = fmul double %.579.i2656, 1.250000e-01
  %.247.i.i.i = fsub double 1.000000e+00, %.584.i2657
  br label %B222.if.i

B222.if.i:                                        ; preds = %B222.if.i.lr.ph, %B222.i.loopexit
  %.486.i2121.010738 = phi i64 [ %storemerge, %B222.if.i.lr.ph ], [ %.548.i2879, %B222.i.loopexit ]
  %.483.i2120.010737 = phi i64 [ 0, %B222.if.i.lr.ph ], [ %.552.i2882, %B222.i.loopexit ]
  %.548.i2879 = add nsw i64 %.486.i2121.010738, -1
  %.552.i2882 = add nsw i64 %.483.i2120.010737, 1
  %.92.i.i2732 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.483.i2120.010737
  %.93.i.i2733 = load double, ptr %.92.i.i2732, align 8, !noalias !64
  %.146.i.i2767 = getelementptr double, ptr %43, i64 %.483.i2120.010737
  %.147.i.i2768 = load double, ptr %.146.i.i2767, align 8, !noalias !64
  %.149.i.i2770 = fmul double %.584.i2657, %.147.i.i2768
  %.150.i.i2771 = fadd double %.93.i.i2733, %.149.i.i2770
  %.203.i.i2798 = getelementptr double, ptr %.502, i64 %.483.i2120.010737
  store double %.150.i.i2771, ptr %.203.i.i2798, align 8, !noalias !64
  br i1 %.287.i.i10733.not, label %B222.i.loopexit, label %B122.if.i.i.preheader

B122.if.i.i.preheader:                            ; preds = %B222.if.i
  %invariant.gep10900 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010737
  %invariant.gep10902 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010737
  %invariant.gep10904 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010737
  %invariant.gep10906 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010737
  %invariant.gep10908 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010737
  %invariant.gep10910 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010737
  %invariant.gep10912 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010737
  %invariant.gep10914 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010737
  %invariant.gep10916 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010737
  br label %B122.if.i.i

B122.if.i.i:                                      ; preds = %B122.if.i.i.preheader, %B122.if.i.i
  %.229.i.i.010734 = phi i64 [ %.300.i.i2869, %B122.if.i.i ], [ 0, %B122.if.i.i.preheader ]
  %.157.i.i.i = add nsw i64 %.155.i.i.i, %.229.i.i.010734
  %.159.i.i.i = mul nsw i64 %.157.i.i.i, %arg.shape.0
  %gep10901 = getelementptr double, ptr %invariant.gep10900, i64 %.159.i.i.i
  %.191.i.i.i = load double, ptr %gep10901, align 8, !noalias !68
  %.193.i.i.i = fadd double %.191.i.i.i, 0.000000e+00
  %.253.i.i.i = fmul double %.584.i2657, %.193.i.i.i
  %.157.i.i.i.1 = add nsw i64 %.155.i.i.i.1, %.229.i.i.010734
  %.159.i.i.i.1 = mul nsw i64 %.157.i.i.i.1, %arg.shape.0
  %gep10903 = getelementptr double, ptr %invariant.gep10902, i64 %.159.i.i.i.1
  %.191.i.i.i.1 = load double, ptr %gep10903, align 8, !noalias !68
  %.193.i.i.i.1 = fadd double %.253.i.i.i, %.191.i.i.i.1
  %.253.i.i.i.1 = fmul double %.247.i.i.i, %.193.i.i.i.1
  %.157.i.i.i.2 = add nsw i64 %.155.i.i.i.2, %.229.i.i.010734
  %.159.i.i.i.2 = mul nsw i64 %.157.i.i.i.2, %arg.shape.0
  %gep10905 = getelementptr double, ptr %invariant.gep10904, i64 %.159.i.i.i.2
  %.191.i.i.i.2 = load double, ptr %gep10905, align 8, !noalias !68
  %.193.i.i.i.2 = fadd double %.253.i.i.i.1, %.191.i.i.i.2
  %.253.i.i.i.2 = fmul double %.584.i2657, %.193.i.i.i.2
  %.157.i.i.i.3 = add nsw i64 %.155.i.i.i.3, %.229.i.i.010734
  %.159.i.i.i.3 = mul nsw i64 %.157.i.i.i.3, %arg.shape.0
  %gep10907 = getelementptr double, ptr %invariant.gep10906, i64 %.159.i.i.i.3
  %.191.i.i.i.3 = load double, ptr %gep10907, align 8, !noalias !68
  %.193.i.i.i.3 = fadd double %.253.i.i.i.2, %.191.i.i.i.3
  %.253.i.i.i.3 = fmul double %.247.i.i.i, %.193.i.i.i.3
  %.157.i.i.i.4 = add nsw i64 %.155.i.i.i.4, %.229.i.i.010734
  %.159.i.i.i.4 = mul nsw i64 %.157.i.i.i.4, %arg.shape.0
  %gep10909 = getelementptr double, ptr %invariant.gep10908, i64 %.159.i.i.i.4
  %.191.i.i.i.4 = load double, ptr %gep10909, align 8, !noalias !68
  %.193.i.i.i.4 = fadd double %.253.i.i.i.3, %.191.i.i.i.4
  %.253.i.i.i.4 = fmul double %.584.i2657, %.193.i.i.i.4
  %.157.i.i.i.5 = add nsw i64 %.155.i.i.i.5, %.229.i.i.010734
  %.159.i.i.i.5 = mul nsw i64 %.157.i.i.i.5, %arg.shape.0
  %gep10911 = getelementptr double, ptr %invariant.gep10910, i64 %.159.i.i.i.5
  %.191.i.i.i.5 = load double, ptr %gep10911, align 8, !noalias !68
  %.193.i.i.i.5 = fadd double %.253.i.i.i.4, %.191.i.i.i.5
  %.253.i.i.i.5 = fmul double %.247.i.i.i, %.193.i.i.i.5
  %.157.i.i.i.6 = add nsw i64 %.155.i.i.i.6, %.229.i.i.010734
  %.159.i.i.i.6 = mul nsw i64 %.157.i.i.i.6, %arg.shape.0
  %gep10913 = getelementptr double, ptr %invariant.gep10912, i64 %.159.i.i.i.6
  %.191.i.i.i.6 = load double, ptr %gep10913, align 8, !noalias !68
  %.193.i.i.i.6 = fadd double %.253.i.i.i.5, %.191.i.i.i.6
  %.253.i.i.i.6 = fmul double %.584.i2657, %.193.i.i.i.6
  %.300.i.i2869 = add nsw i64 %.229.i.i.010734, 1
  %.271.i.i.i = mul nsw i64 %.229.i.i.010734, %arg.shape.0
  %gep10915 = getelementptr double, ptr %invariant.gep10914, i64 %.271.i.i.i
  %.309.i.i.i = load double, ptr %gep10915, align 8, !noalias !68
  %.313.i.i.i = fadd double %.253.i.i.i.6, %.309.i.i.i
  %.359.i.i2848 = add nsw i64 %.229.i.i.010734, %.358.i.i
  %.361.i.i2849 = mul nsw i64 %.359.i.i2848, %arg.shape.0
  %gep10917 = getelementptr double, ptr %invariant.gep10916, i64 %.361.i.i2849
  store double %.313.i.i.i, ptr %gep10917, align 8, !noalias !64
  %exitcond10880.not = icmp eq i64 %arg.shape.1, %.300.i.i2869
  br i1 %exitcond10880.not, label %B222.i.loopexit, label %B122.if.i.i

B466.if.i:                                        ; preds = %B284.i, %B770.i
  %some.2.i.110742 = phi i1 [ %some.4.i.010746, %B284.i ], [ %some.3.i.2, %B770.i ]
  %.817.i2140.010741 = phi i64 [ %storemerge, %B284.i ], [ %.879.i2640, %B770.i ]
  %.814.i2139.010740 = phi i64 [ 0, %B284.i ], [ %.883.i2643, %B770.i ]
  %.879.i2640 = add nsw i64 %.817.i2140.010741, -1
  %.883.i2643 = add nsw i64 %.814.i2139.010740, 1
  %.968.i2494 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.814.i2139.010740
  %.969.i2495 = load i64, ptr %.968.i2494, align 8, !noalias !56
  %.970.i2496 = icmp sgt i64 %.969.i2495, -1
  br i1 %.970.i2496, label %B508.i, label %B770.i

B584.endif.i:                                     ; preds = %B36.i.i, %B34.i.i
  %.1099.i2147.0 = phi i64 [ %.48.i.i1982.0, %B36.i.i ], [ -1, %B34.i.i ]
  store i64 %.1099.i2147.0, ptr %.1088.i2554, align 8, !noalias !56
  %.1248.i = getelementptr double, ptr %46, i64 %.814.i2139.010740
  store double %.1187.i, ptr %.1248.i, align 8, !noalias !56
  %.1303.i = getelementptr double, ptr %47, i64 %.814.i2139.010740
  store double %.1194.i, ptr %.1303.i, align 8, !noalias !56
  br i1 %some.2.i.110742, label %B770.i, label %B732.i

B806.if.i:                                        ; preds = %B806.i.preheader, %B806.if.i
  %.1453.i.010749 = phi i64 [ %.1515.i, %B806.if.i ], [ %storemerge, %B806.i.preheader ]
  %.1450.i.010748 = phi i64 [ %.1519.i, %B806.if.i ], [ 0, %B806.i.preheader ]
  %.1515.i = add nsw i64 %.1453.i.010749, -1
  %.1519.i = add nsw i64 %.1450.i.010748, 1
  %.1596.i = getelementptr double, ptr %48, i64 %.1450.i.010748
  %.1597.i = load double, ptr %.1596.i, align 8, !noalias !56
  %.1650.i = getelementptr double, ptr %.502, i64 %.1450.i.010748
  store double %.1597.i, ptr %.1650.i, align 8, !noalias !56
  %.1506.i = icmp sgt i64 %.1453.i.010749, 1
  br i1 %.1506.i, label %B806.if.i, label %B2742

B2742:                                            ; preds = %B806.if.i, %B806.i.preheader, %B2616
  %beyond.2.1 = phi i1 [ false, %B2616 ], [ %some.2.i.1.lcssa, %B806.i.preheader ], [ %some.2.i.1.lcssa, %B806.if.i ]
  %brmerge10329 = select i1 %within.5.1, i1 true, i1 %beyond.2.1
  br i1 %brmerge10329, label %B2752, label %B3314

B2752:                                            ; preds = %B2742
  br i1 %.545, label %B3168.critedge, label %B2800.if

B140.i:                                           ; preds = %B64.if.i5797
  %.409.i = getelementptr double, ptr %50, i64 %.138.i4903.010754
  %.410.i = load double, ptr %.409.i, align 8, !noalias !72
  %.411.i5133 = fcmp uge double %.410.i, 5.000000e-01
  %.424.i5140.not = icmp slt i64 %.346.i5082, %arg.batch.2.5.0
  %or.cond10330 = select i1 %.411.i5133, i1 %.424.i5140.not, i1 false
  br i1 %or.cond10330, label %B216.i, label %B453.i

B216.i:                                           ; preds = %B140.i
  %.440.i5151 = icmp slt i64 %.346.i5082, 0
  %.441.i5152 = select i1 %.440.i5151, i64 %arg.batch.2.5.0, i64 0
  %206 = getelementptr double, ptr %arg.batch.2.4, i64 %.346.i5082
  %.455.i5166 = getelementptr double, ptr %206, i64 %.441.i5152
  %.456.i5167 = load double, ptr %.455.i5166, align 8, !noalias !72
  %.510.i5213 = getelementptr double, ptr %51, i64 %.138.i4903.010754
  %.511.i5214 = load double, ptr %.510.i5213, align 8, !noalias !72
  %.512.i5215 = fcmp ult double %.456.i5167, %.511.i5214
  br i1 %.512.i5215, label %B268.i5216, label %B453.i

B268.i5216:                                       ; preds = %B216.i
  %.574.i5263 = getelementptr double, ptr %52, i64 %.138.i4903.010754
  %.575.i5264 = load double, ptr %.574.i5263, align 8, !noalias !72
  %.576.i5265 = fcmp ogt double %.575.i5264, 1.000000e+00
  br i1 %.576.i5265, label %B306.i5269, label %B453.i

B306.i5269:                                       ; preds = %B268.i5216
  %.632.i = getelementptr double, ptr %53, i64 %.138.i4903.010754
  %.633.i5316 = load double, ptr %.632.i, align 8, !noalias !72
  store double 0.000000e+00, ptr %.409.i, align 8, !noalias !76
  %.161.i.i5476 = getelementptr double, ptr %54, i64 %.138.i4903.010754
  store double 0.000000e+00, ptr %.161.i.i5476, align 8, !noalias !76
  %.214.i.i5511 = getelementptr double, ptr %55, i64 %.138.i4903.010754
  store double %.633.i5316, ptr %.214.i.i5511, align 8, !noalias !76
  %.268.i.i5544 = load i64, ptr %.290.i5036, align 8, !noalias !76
  %.294.i.i5558 = icmp slt i64 %.268.i.i5544, 0
  %.295.i.i = select i1 %.294.i.i5558, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i.i5559 = add i64 %.295.i.i, %.268.i.i5544
  %.316.i.i5571 = mul i64 %.296.i.i5559, %arg.batch.3.3.5.1
  %.320.i.i5572 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i.i5571
  %.321.i.i5573 = load i64, ptr %.320.i.i5572, align 8, !noalias !76
  %.322.i.i5574 = add nsw i64 %.321.i.i5573, -1
  store i64 %.322.i.i5574, ptr %.320.i.i5572, align 8, !noalias !76
  %.426.i.i5620 = load i64, ptr %.290.i5036, align 8, !noalias !76
  %.452.i.i = icmp slt i64 %.426.i.i5620, 0
  %.453.i.i = select i1 %.452.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i = add i64 %.453.i.i, %.426.i.i5620
  %.474.i.i = mul i64 %.454.i.i, %arg.batch.3.3.5.1
  %207 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i
  %.478.i.i = getelementptr i8, ptr %207, i64 24
  %.479.i.i = load i64, ptr %.478.i.i, align 8, !noalias !76
  %.480.i.i = add nsw i64 %.479.i.i, 1
  store i64 %.480.i.i, ptr %.478.i.i, align 8, !noalias !76
  %.705.i5650 = load double, ptr %.455.i5166, align 8, !noalias !72
  %.763.i5696 = getelementptr double, ptr %56, i64 %.138.i4903.010754
  store double %.705.i5650, ptr %.763.i5696, align 8, !noalias !72
  %.816.i5742 = mul i64 %.291.i5037, %arg.batch.3.3.5.1
  %208 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.816.i5742
  %.820.i5745 = getelementptr i8, ptr %208, i64 8
  %.821.i5746 = load i64, ptr %.820.i5745, align 8, !noalias !72
  %.822.i5747 = add nsw i64 %.821.i5746, 3
  store i64 %.822.i5747, ptr %.820.i5745, align 8, !noalias !72
  br label %B453.i

B453.i:                                           ; preds = %B268.i5216, %B306.i5269, %B64.if.i5797, %B140.i, %B216.i
  %.196.i4973 = icmp sgt i64 %.141.i4904.010753, 1
  br i1 %.196.i4973, label %B64.if.i5797, label %B3168

B64.if.i5797:                                     ; preds = %B2800.if, %B453.i
  %.138.i4903.010754 = phi i64 [ %.209.i5805, %B453.i ], [ 0, %B2800.if ]
  %.141.i4904.010753 = phi i64 [ %.205.i5802, %B453.i ], [ %storemerge, %B2800.if ]
  %.205.i5802 = add nsw i64 %.141.i4904.010753, -1
  %.209.i5805 = add nsw i64 %.138.i4903.010754, 1
  %.290.i5036 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.138.i4903.010754
  %.291.i5037 = load i64, ptr %.290.i5036, align 8, !noalias !72
  %.345.i5081 = getelementptr i64, ptr %49, i64 %.138.i4903.010754
  %.346.i5082 = load i64, ptr %.345.i5081, align 8, !noalias !72
  %.354.i = icmp slt i64 %.291.i5037, 0
  br i1 %.354.i, label %B453.i, label %B140.i

B3168.critedge:                                   ; preds = %B2752
  %.4452.c = load i64, ptr %.4451.c, align 8
  %.4497.c = inttoptr i64 %.4452.c to ptr
  tail call void %.4497.c(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3168

B3168:                                            ; preds = %B453.i, %B2800.if, %B3168.critedge
  br i1 %beyond.2.1, label %B108.i3279.preheader, label %B3252

B108.i3279.preheader:                             ; preds = %B3168
  br i1 %.603, label %B188.if.i4717.preheader, label %B108.if.i4781

B186.i3331.loopexit.critedge:                     ; preds = %B188.if.i4717
  %.625.i3556.c = icmp ult i64 %.361.i3151.010772, 8
  %.10331.c = select i1 %.625.i3556.c, i64 16, i64 17
  %.672.i3588.c = load i64, ptr %.671.i3587, align 8, !noalias !79
  %.744.i3645.c = mul i64 %.742.i3643, %.10331.c
  %.762.i3655.c = getelementptr double, ptr %arg.batch.5.0.4, i64 %.744.i3645.c
  %.788.i3665.c = inttoptr i64 %.672.i3588.c to ptr
  tail call void %.788.i3665.c(ptr %.502, ptr %.762.i3655.c, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !79
  br label %B186.i3331.loopexit

B186.i3331.loopexit:                              ; preds = %B770.i3772, %B186.i3331.loopexit.critedge
  %some.2.i3174.1.lcssa = phi i1 [ %some.4.i3147.010774, %B186.i3331.loopexit.critedge ], [ %some.3.i3195.2, %B770.i3772 ]
  %exitcond10886.not = icmp eq i64 %.431.i4724, 9
  br i1 %exitcond10886.not, label %B806.i3389.preheader, label %B188.if.i4717

B806.i3389.preheader:                             ; preds = %B186.i3331.loopexit
  br i1 %.603, label %B3172.endif.endif, label %B806.if.i3485

B222.i3538.loopexit:                              ; preds = %B122.if.i.i4684, %B222.if.i4699
  %.539.i3543 = icmp sgt i64 %.486.i3164.010766, 1
  br i1 %.539.i3543, label %B222.if.i4699, label %B284.i3552

B284.i3552:                                       ; preds = %B222.i3538.loopexit
  %.625.i3556 = icmp ult i64 %.361.i3151.010772, 8
  %.10331 = select i1 %.625.i3556, i64 16, i64 17
  %.672.i3588 = load i64, ptr %.671.i3587, align 8, !noalias !79
  %.744.i3645 = mul i64 %.742.i3643, %.10331
  %.762.i3655 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.744.i3645
  %.788.i3665 = inttoptr i64 %.672.i3588 to ptr
  tail call void %.788.i3665(ptr %.502, ptr %.762.i3655, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !79
  %.1181.i4003 = add nsw i64 %.361.i3151.010772, -1
  %.1182.i4004 = sitofp i64 %.1181.i4003 to double
  %.1187.i4005 = fmul double %.1182.i4004, 1.250000e-01
  %.1189.i4007 = uitofp i64 %.361.i3151.010772 to double
  %.1194.i4008 = fmul double %.1189.i4007, 1.250000e-01
  br label %B466.if.i4198

B508.i3777:                                       ; preds = %B466.if.i4198
  %.1028.i3821 = getelementptr double, ptr %59, i64 %.814.i3187.010768
  %.1029.i3822 = load double, ptr %.1028.i3821, align 8, !noalias !79
  %.1030.i3823 = fcmp ogt double %.1029.i3822, 5.000000e-01
  br i1 %.1030.i3823, label %B546.i3824, label %B770.i3772

B546.i3824:                                       ; preds = %B508.i3777
  %.1088.i3869 = getelementptr i64, ptr %60, i64 %.814.i3187.010768
  %.1089.i3870 = load i64, ptr %.1088.i3869, align 8, !noalias !79
  %.1090.i3871 = icmp slt i64 %.1089.i3870, 0
  br i1 %.1090.i3871, label %B34.i.i3928, label %B770.i3772

B34.i.i3928:                                      ; preds = %B546.i3824, %B36.i.i4141
  %.48.i.i2973.0 = phi i64 [ %.119.i88.i4189, %B36.i.i4141 ], [ 0, %B546.i3824 ]
  %exitcond10885.not = icmp eq i64 %.48.i.i2973.0, %storemerge10275
  br i1 %exitcond10885.not, label %B584.endif.i3958, label %B36.i.i4141

B36.i.i4141:                                      ; preds = %B34.i.i3928
  %.119.i88.i4189 = add i64 %.48.i.i2973.0, 1
  %.149.i53.i4147 = add nsw i64 %.48.i.i2973.0, %arg.shape.6
  %.151.i55.i4149 = mul nsw i64 %.149.i53.i4147, %arg.shape.0
  %.153.i56.i4151 = add nsw i64 %.151.i55.i4149, %.814.i3187.010768
  %.167.i61.i4159 = icmp slt i64 %.153.i56.i4151, 0
  %.168.i62.i4160 = select i1 %.167.i61.i4159, i64 %arg.batch.5.4.5.0, i64 0
  %209 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i56.i4151
  %.182.i74.i4170 = getelementptr double, ptr %209, i64 %.168.i62.i4160
  %.183.i75.i4171 = load double, ptr %.182.i74.i4170, align 8, !noalias !83
  %.184.i.i4172 = fcmp ogt double %.183.i75.i4171, 5.000000e-01
  br i1 %.184.i.i4172, label %B584.endif.i3958, label %B34.i.i3928

B732.i4087:                                       ; preds = %B584.endif.i3958
  %.1369.i4126 = load i64, ptr %.1088.i3869, align 8, !noalias !79
  %.1370.i4127 = icmp sgt i64 %.1369.i4126, -1
  br label %B770.i3772

B770.i3772:                                       ; preds = %B732.i4087, %B584.endif.i3958, %B546.i3824, %B508.i3777, %B466.if.i4198
  %some.3.i3195.2 = phi i1 [ %some.2.i3174.110770, %B466.if.i4198 ], [ %some.2.i3174.110770, %B546.i3824 ], [ %some.2.i3174.110770, %B508.i3777 ], [ true, %B584.endif.i3958 ], [ %.1370.i4127, %B732.i4087 ]
  %.870.i3704 = icmp sgt i64 %.817.i3188.010769, 1
  br i1 %.870.i3704, label %B466.if.i4198, label %B186.i3331.loopexit

B108.if.i4781:                                    ; preds = %B108.i3279.preheader, %B108.if.i4781
  %.179.i3138.010757 = phi i64 [ %.243.i4786, %B108.if.i4781 ], [ %storemerge, %B108.i3279.preheader ]
  %.176.i3137.010756 = phi i64 [ %.247.i4789, %B108.if.i4781 ], [ 0, %B108.i3279.preheader ]
  %.243.i4786 = add nsw i64 %.179.i3138.010757, -1
  %.247.i4789 = add nsw i64 %.176.i3137.010756, 1
  %210 = getelementptr i64, ptr %57, i64 %.176.i3137.010756
  store i64 -1, ptr %210, align 8, !noalias !79
  %.234.i3284 = icmp sgt i64 %.179.i3138.010757, 1
  br i1 %.234.i3284, label %B108.if.i4781, label %B188.if.i4717.preheader

B188.if.i4717.preheader:                          ; preds = %B108.if.i4781, %B108.i3279.preheader
  br label %B188.if.i4717

B188.if.i4717:                                    ; preds = %B188.if.i4717.preheader, %B186.i3331.loopexit
  %some.4.i3147.010774 = phi i1 [ %some.2.i3174.1.lcssa, %B186.i3331.loopexit ], [ false, %B188.if.i4717.preheader ]
  %.361.i3151.010772 = phi i64 [ %.431.i4724, %B186.i3331.loopexit ], [ 1, %B188.if.i4717.preheader ]
  %.431.i4724 = add nsw i64 %.361.i3151.010772, 1
  br i1 %.603, label %B186.i3331.loopexit.critedge, label %B222.if.i4699.lr.ph

B222.if.i4699.lr.ph:                              ; preds = %B188.if.i4717
  %.579.i4223 = uitofp i64 %.361.i3151.010772 to double
  %.584.i4224 = fmul double %.579.i4223, 1.250000e-01
  %.247.i.i.i4654 = fsub double 1.000000e+00, %.584.i4224
  br label %B222.if.i4699

B222.if.i4699:                                    ; preds = %B222.if.i4699.lr.ph, %B222.i3538.loopexit
  %.486.i3164.010766 = phi i64 [ %storemerge, %B222.if.i4699.lr.ph ], [ %.548.i4704, %B222.i3538.loopexit ]
  %.483.i3163.010765 = phi i64 [ 0, %B222.if.i4699.lr.ph ], [ %.552.i4707, %B222.i3538.loopexit ]
  %.548.i4704 = add nsw i64 %.486.i3164.010766, -1
  %.552.i4707 = add nsw i64 %.483.i3163.010765, 1
  %.92.i.i4304 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.483.i3163.010765
  %.93.i.i4305 = load double, ptr %.92.i.i4304, align 8, !noalias !87
  %.146.i.i4341 = getelementptr double, ptr %58, i64 %.483.i3163.010765
  %.147.i.i4342 = load double, ptr %.146.i.i4341, align 8, !noalias !87
  %.149.i.i4344 = fmul double %.584.i4224, %.147.i.i4342
  %.150.i.i4345 = fadd double %.93.i.i4305, %.149.i.i4344
  %.203.i.i4381 = getelementptr double, ptr %.502, i64 %.483.i3163.010765
  store double %.150.i.i4345, ptr %.203.i.i4381, align 8, !noalias !87
  br i1 %.287.i.i441810761.not, label %B222.i3538.loopexit, label %B122.if.i.i4684.preheader

B122.if.i.i4684.preheader:                        ; preds = %B222.if.i4699
  %invariant.gep10918 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010765
  %invariant.gep10920 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010765
  %invariant.gep10922 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010765
  %invariant.gep10924 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010765
  %invariant.gep10926 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010765
  %invariant.gep10928 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010765
  %invariant.gep10930 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010765
  %invariant.gep10932 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010765
  %invariant.gep10934 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010765
  br label %B122.if.i.i4684

B122.if.i.i4684:                                  ; preds = %B122.if.i.i4684.preheader, %B122.if.i.i4684
  %.229.i.i3022.010762 = phi i64 [ %.300.i.i4690, %B122.if.i.i4684 ], [ 0, %B122.if.i.i4684.preheader ]
  %.157.i.i.i4611 = add nsw i64 %.155.i.i.i4609, %.229.i.i3022.010762
  %.159.i.i.i4613 = mul nsw i64 %.157.i.i.i4611, %arg.shape.0
  %gep10919 = getelementptr double, ptr %invariant.gep10918, i64 %.159.i.i.i4613
  %.191.i.i.i4635 = load double, ptr %gep10919, align 8, !noalias !91
  %.193.i.i.i4637 = fadd double %.191.i.i.i4635, 0.000000e+00
  %.253.i.i.i4659 = fmul double %.584.i4224, %.193.i.i.i4637
  %.157.i.i.i4611.1 = add nsw i64 %.155.i.i.i4609.1, %.229.i.i3022.010762
  %.159.i.i.i4613.1 = mul nsw i64 %.157.i.i.i4611.1, %arg.shape.0
  %gep10921 = getelementptr double, ptr %invariant.gep10920, i64 %.159.i.i.i4613.1
  %.191.i.i.i4635.1 = load double, ptr %gep10921, align 8, !noalias !91
  %.193.i.i.i4637.1 = fadd double %.253.i.i.i4659, %.191.i.i.i4635.1
  %.253.i.i.i4659.1 = fmul double %.247.i.i.i4654, %.193.i.i.i4637.1
  %.157.i.i.i4611.2 = add nsw i64 %.155.i.i.i4609.2, %.229.i.i3022.010762
  %.159.i.i.i4613.2 = mul nsw i64 %.157.i.i.i4611.2, %arg.shape.0
  %gep10923 = getelementptr double, ptr %invariant.gep10922, i64 %.159.i.i.i4613.2
  %.191.i.i.i4635.2 = load double, ptr %gep10923, align 8, !noalias !91
  %.193.i.i.i4637.2 = fadd double %.253.i.i.i4659.1, %.191.i.i.i4635.2
  %.253.i.i.i4659.2 = fmul double %.584.i4224, %.193.i.i.i4637.2
  %.157.i.i.i4611.3 = add nsw i64 %.155.i.i.i4609.3, %.229.i.i3022.010762
  %.159.i.i.i4613.3 = mul nsw i64 %.157.i.i.i4611.3, %arg.shape.0
  %gep10925 = getelementptr double, ptr %invariant.gep10924, i64 %.159.i.i.i4613.3
  %.191.i.i.i4635.3 = load double, ptr %gep10925, align 8, !noalias !91
  %.193.i.i.i4637.3 = fadd double %.253.i.i.i4659.2, %.191.i.i.i4635.3
  %.253.i.i.i4659.3 = fmul double %.247.i.i.i4654, %.193.i.i.i4637.3
  %.157.i.i.i4611.4 = add nsw i64 %.155.i.i.i4609.4, %.229.i.i3022.010762
  %.159.i.i.i4613.4 = mul nsw i64 %.157.i.i.i4611.4, %arg.shape.0
  %gep10927 = getelementptr double, ptr %invariant.gep10926, i64 %.159.i.i.i4613.4
  %.191.i.i.i4635.4 = load double, ptr %gep10927, align 8, !noalias !91
  %.193.i.i.i4637.4 = fadd double %.253.i.i.i4659.3, %.191.i.i.i4635.4
  %.253.i.i.i4659.4 = fmul double %.584.i4224, %.193.i.i.i4637.4
  %.157.i.i.i4611.5 = add nsw i64 %.155.i.i.i4609.5, %.229.i.i3022.010762
  %.159.i.i.i4613.5 = mul nsw i64 %.157.i.i.i4611.5, %arg.shape.0
  %gep10929 = getelementptr double, ptr %invariant.gep10928, i64 %.159.i.i.i4613.5
  %.191.i.i.i4635.5 = load double, ptr %gep10929, align 8, !noalias !91
  %.193.i.i.i4637.5 = fadd double %.253.i.i.i4659.4, %.191.i.i.i4635.5
  %.253.i.i.i4659.5 = fmul double %.247.i.i.i4654, %.193.i.i.i4637.5
  %.157.i.i.i4611.6 = add nsw i64 %.155.i.i.i4609.6, %.229.i.i3022.010762
  %.159.i.i.i4613.6 = mul nsw i64 %.157.i.i.i4611.6, %arg.shape.0
  %gep10931 = getelementptr double, ptr %invariant.gep10930, i64 %.159.i.i.i4613.6
  %.191.i.i.i4635.6 = load double, ptr %gep10931, align 8, !noalias !91
  %.193.i.i.i4637.6 = fadd double %.253.i.i.i4659.5, %.191.i.i.i4635.6
  %.253.i.i.i4659.6 = fmul double %.584.i4224, %.193.i.i.i4637.6
  %.300.i.i4690 = add nsw i64 %.229.i.i3022.010762, 1
  %.271.i.i.i4532 = mul nsw i64 %.229.i.i3022.010762, %arg.shape.0
  %gep10933 = getelementptr double, ptr %invariant.gep10932, i64 %.271.i.i.i4532
  %.309.i.i.i4557 = load double, ptr %gep10933, align 8, !noalias !91
  %.313.i.i.i4560 = fadd double %.253.i.i.i4659.6, %.309.i.i.i4557
  %.359.i.i4573 = add nsw i64 %.229.i.i3022.010762, %.358.i.i4572
  %.361.i.i4575 = mul nsw i64 %.359.i.i4573, %arg.shape.0
  %gep10935 = getelementptr double, ptr %invariant.gep10934, i64 %.361.i.i4575
  store double %.313.i.i.i4560, ptr %gep10935, align 8, !noalias !87
  %exitcond10884.not = icmp eq i64 %arg.shape.1, %.300.i.i4690
  br i1 %exitcond10884.not, label %B222.i3538.loopexit, label %B122.if.i.i4684

B466.if.i4198:                                    ; preds = %B284.i3552, %B770.i3772
  %some.2.i3174.110770 = phi i1 [ %some.4.i3147.010774, %B284.i3552 ], [ %some.3.i3195.2, %B770.i3772 ]
  %.817.i3188.010769 = phi i64 [ %storemerge, %B284.i3552 ], [ %.879.i4203, %B770.i3772 ]
  %.814.i3187.010768 = phi i64 [ 0, %B284.i3552 ], [ %.883.i4206, %B770.i3772 ]
  %.879.i4203 = add nsw i64 %.817.i3188.010769, -1
  %.883.i4206 = add nsw i64 %.814.i3187.010768, 1
  %.968.i3769 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.814.i3187.010768
  %.969.i3770 = load i64, ptr %.968.i3769, align 8, !noalias !79
  %.970.i3771 = icmp sgt i64 %.969.i3770, -1
  br i1 %.970.i3771, label %B508.i3777, label %B770.i3772

B584.endif.i3958:                                 ; preds = %B36.i.i4141, %B34.i.i3928
  %.1099.i3200.0 = phi i64 [ %.48.i.i2973.0, %B36.i.i4141 ], [ -1, %B34.i.i3928 ]
  store i64 %.1099.i3200.0, ptr %.1088.i3869, align 8, !noalias !79
  %.1248.i4045 = getelementptr double, ptr %61, i64 %.814.i3187.010768
  store double %.1187.i4005, ptr %.1248.i4045, align 8, !noalias !79
  %.1303.i4082 = getelementptr double, ptr %62, i64 %.814.i3187.010768
  store double %.1194.i4008, ptr %.1303.i4082, align 8, !noalias !79
  br i1 %some.2.i3174.110770, label %B770.i3772, label %B732.i4087

B806.if.i3485:                                    ; preds = %B806.i3389.preheader, %B806.if.i3485
  %.1453.i3211.010777 = phi i64 [ %.1515.i3488, %B806.if.i3485 ], [ %storemerge, %B806.i3389.preheader ]
  %.1450.i3210.010776 = phi i64 [ %.1519.i3491, %B806.if.i3485 ], [ 0, %B806.i3389.preheader ]
  %.1515.i3488 = add nsw i64 %.1453.i3211.010777, -1
  %.1519.i3491 = add nsw i64 %.1450.i3210.010776, 1
  %.1596.i3447 = getelementptr double, ptr %63, i64 %.1450.i3210.010776
  %.1597.i3448 = load double, ptr %.1596.i3447, align 8, !noalias !79
  %.1650.i3484 = getelementptr double, ptr %.502, i64 %.1450.i3210.010776
  store double %.1597.i3448, ptr %.1650.i3484, align 8, !noalias !79
  %.1506.i3394 = icmp sgt i64 %.1453.i3211.010777, 1
  br i1 %.1506.i3394, label %B806.if.i3485, label %B3172.endif.endif

B3210:                                            ; preds = %B3172.endif.endif
  %.224.i = load double, ptr %.223.i, align 8, !noalias !95
  %.253.i = load double, ptr %arg.batch.2.4, align 8, !noalias !95
  br label %B188.if.i10385

B188.loopexit.i.critedge:                         ; preds = %B188.if.i10385
  %.709.i10399.c = load i64, ptr %.708.i, align 8, !noalias !95
  %.825.i.c = inttoptr i64 %.709.i10399.c to ptr
  tail call void %.825.i.c(ptr %.502, ptr %.799.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !95
  br label %B188.loopexit.i

B188.loopexit.i:                                  ; preds = %B1356.i, %B188.loopexit.i.critedge
  %.374.i = icmp ugt i64 %.319.01492.i, 1
  br i1 %.374.i, label %B188.if.i10385, label %B686.i

B222.loopexit.i:                                  ; preds = %B122.if.i.i10389, %B222.if.i10386
  %exitcond1497.not.i = icmp eq i64 %arg.shape.0, %.505.i
  br i1 %exitcond1497.not.i, label %B336.i, label %B222.if.i10386

B122.if.i.i10389:                                 ; preds = %B122.if.i.lr.ph.i, %B122.if.i.i10389
  %.229.i.01484.i = phi i64 [ 0, %B122.if.i.lr.ph.i ], [ %.300.i.i, %B122.if.i.i10389 ]
  %.157.i.i.i10390 = add nsw i64 %.229.i.01484.i, %.155.i.i.i10388
  %.159.i.i.i10391 = mul nsw i64 %.157.i.i.i10390, %arg.shape.0
  %gep10779 = getelementptr double, ptr %invariant.gep10778, i64 %.159.i.i.i10391
  %.191.i.i.i10392 = load double, ptr %gep10779, align 8, !noalias !98
  %.193.i.i.i10393 = fadd double %.191.i.i.i10392, 0.000000e+00
  %.253.i.i.i10394 = fmul double %.639.i, %.193.i.i.i10393
  %.157.i.i.1.i = add nsw i64 %.229.i.01484.i, %.155.i.i.1.i
  %.159.i.i.1.i = mul nsw i64 %.157.i.i.1.i, %arg.shape.0
  %gep10781 = getelementptr double, ptr %invariant.gep10780, i64 %.159.i.i.1.i
  %.191.i.i.1.i = load double, ptr %gep10781, align 8, !noalias !98
  %.193.i.i.1.i = fadd double %.191.i.i.1.i, %.253.i.i.i10394
  %.253.i.i.1.i = fmul double %.247.i.i.i10387, %.193.i.i.1.i
  %.157.i.i.2.i = add nsw i64 %.229.i.01484.i, %.155.i.i.2.i
  %.159.i.i.2.i = mul nsw i64 %.157.i.i.2.i, %arg.shape.0
  %gep10783 = getelementptr double, ptr %invariant.gep10782, i64 %.159.i.i.2.i
  %.191.i.i.2.i = load double, ptr %gep10783, align 8, !noalias !98
  %.193.i.i.2.i = fadd double %.191.i.i.2.i, %.253.i.i.1.i
  %.253.i.i.2.i = fmul double %.639.i, %.193.i.i.2.i
  %.157.i.i.3.i = add nsw i64 %.229.i.01484.i, %.155.i.i.3.i
  %.159.i.i.3.i = mul nsw i64 %.157.i.i.3.i, %arg.shape.0
  %gep10785 = getelementptr double, ptr %invariant.gep10784, i64 %.159.i.i.3.i
  %.191.i.i.3.i = load double, ptr %gep10785, align 8, !noalias !98
  %.193.i.i.3.i = fadd double %.191.i.i.3.i, %.253.i.i.2.i
  %.253.i.i.3.i = fmul double %.247.i.i.i10387, %.193.i.i.3.i
  %.157.i.i.4.i = add nsw i64 %.229.i.01484.i, %.155.i.i.4.i
  %.159.i.i.4.i = mul nsw i64 %.157.i.i.4.i, %arg.shape.0
  %gep10787 = getelementptr double, ptr %invariant.gep10786, i64 %.159.i.i.4.i
  %.191.i.i.4.i = load double, ptr %gep10787, align 8, !noalias !98
  %.193.i.i.4.i = fadd double %.191.i.i.4.i, %.253.i.i.3.i
  %.253.i.i.4.i = fmul double %.639.i, %.193.i.i.4.i
  %.157.i.i.5.i = add nsw i64 %.229.i.01484.i, %.155.i.i.5.i
  %.159.i.i.5.i = mul nsw i64 %.157.i.i.5.i, %arg.shape.0
  %gep10789 = getelementptr double, ptr %invariant.gep10788, i64 %.159.i.i.5.i
  %.191.i.i.5.i = load double, ptr %gep10789, align 8, !noalias !98
  %.193.i.i.5.i = fadd double %.191.i.i.5.i, %.253.i.i.4.i
  %.253.i.i.5.i = fmul double %.247.i.i.i10387, %.193.i.i.5.i
  %.157.i.i.6.i = add nsw i64 %.229.i.01484.i, %.155.i.i.6.i
  %.159.i.i.6.i = mul nsw i64 %.157.i.i.6.i, %arg.shape.0
  %gep10791 = getelementptr double, ptr %invariant.gep10790, i64 %.159.i.i.6.i
  %.191.i.i.6.i = load double, ptr %gep10791, align 8, !noalias !98
  %.193.i.i.6.i = fadd double %.191.i.i.6.i, %.253.i.i.5.i
  %.253.i.i.6.i = fmul double %.639.i, %.193.i.i.6.i
  %.300.i.i = add nsw i64 %.229.i.01484.i, 1
  %.271.i.i.i10395 = mul nsw i64 %.229.i.01484.i, %arg.shape.0
  %gep10793 = getelementptr double, ptr %invariant.gep10792, i64 %.271.i.i.i10395
  %.309.i.i.i10396 = load double, ptr %gep10793, align 8, !noalias !98
  %.313.i.i.i10397 = fadd double %.309.i.i.i10396, %.253.i.i.6.i
  %.359.i.i = add nsw i64 %.229.i.01484.i, %.358.i.i10384
  %.361.i.i = mul nsw i64 %.359.i.i, %arg.shape.0
  %gep10795 = getelementptr double, ptr %invariant.gep10794, i64 %.361.i.i
  store double %.313.i.i.i10397, ptr %gep10795, align 8, !noalias !105
  %exitcond.not.i10398 = icmp eq i64 %arg.shape.1, %.300.i.i
  br i1 %exitcond.not.i10398, label %B222.loopexit.i, label %B122.if.i.i10389

B336.i:                                           ; preds = %B222.loopexit.i
  %.709.i10399 = load i64, ptr %.708.i, align 8, !noalias !95
  %.825.i = inttoptr i64 %.709.i10399 to ptr
  tail call void %.825.i(ptr %.502, ptr %.799.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !95
  br label %B478.if.i

B520.i:                                           ; preds = %B478.if.i
  %.1058.i = getelementptr double, ptr %65, i64 %.851.01490.i
  %.1059.i = load double, ptr %.1058.i, align 8, !noalias !95
  %.1113.i = getelementptr double, ptr %66, i64 %.851.01490.i
  %.1114.i = load double, ptr %.1113.i, align 8, !noalias !95
  %.1115.i = fadd double %.1059.i, %.1114.i
  %.1116.i = fmul double %.1115.i, 5.000000e-01
  br label %B34.i.i10412

B34.i.i10412:                                     ; preds = %B34.if.i.i10413, %B520.i
  %.48.i.0.i = phi i64 [ 0, %B520.i ], [ %.119.i88.i10414, %B34.if.i.i10413 ]
  %exitcond1498.not.i = icmp eq i64 %.48.i.0.i, %storemerge1471.i
  br i1 %exitcond1498.not.i, label %B658.i, label %B34.if.i.i10413

B80.i.i10423:                                     ; preds = %B34.if.i.i10413
  %211 = icmp sgt i64 %.48.i.0.i, -1
  br i1 %211, label %B632.i, label %B658.i

B34.if.i.i10413:                                  ; preds = %B34.i.i10412
  %.119.i88.i10414 = add i64 %.48.i.0.i, 1
  %.149.i53.i10415 = add nsw i64 %.48.i.0.i, %arg.shape.6
  %.151.i55.i10416 = mul nsw i64 %.149.i53.i10415, %arg.shape.0
  %.153.i56.i10417 = add nsw i64 %.151.i55.i10416, %.851.01490.i
  %.167.i61.i10418 = icmp slt i64 %.153.i56.i10417, 0
  %.168.i62.i10419 = select i1 %.167.i61.i10418, i64 %arg.batch.5.4.5.0, i64 0
  %212 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i56.i10417
  %.182.i74.i10420 = getelementptr double, ptr %212, i64 %.168.i62.i10419
  %.183.i75.i10421 = load double, ptr %.182.i74.i10420, align 8, !noalias !106
  %.184.i.i10422 = fcmp ogt double %.183.i75.i10421, 5.000000e-01
  br i1 %.184.i.i10422, label %B80.i.i10423, label %B34.i.i10412

B632.i:                                           ; preds = %B80.i.i10423
  store double %.1116.i, ptr %.1113.i, align 8, !noalias !95
  br label %B1356.i

B658.i:                                           ; preds = %B34.i.i10412, %B80.i.i10423
  store double %.1116.i, ptr %.1058.i, align 8, !noalias !95
  br label %B1356.i

B686.i:                                           ; preds = %B188.loopexit.i
  %.254.i = fsub double %.224.i, %.253.i
  %.255.i = fmul double %.254.i, 1.000000e-13
  br i1 %.603, label %B3252, label %B718.if.lr.ph.i

B718.if.lr.ph.i:                                  ; preds = %B686.i
  %.1927.i = fmul double %.255.i, 2.000000e+00
  br label %B718.if.i

B812.i:                                           ; preds = %B718.if.i
  %.1641.i = getelementptr double, ptr %67, i64 %.1323.01494.i
  %.1642.i = load double, ptr %.1641.i, align 8, !noalias !95
  %.1698.i = load double, ptr %.1474.i, align 8, !noalias !95
  %.1699.i = tail call double @llvm.fabs.f64(double %.1698.i)
  %.1700.i = fmul double %.1699.i, 2.000000e-12
  %.1757.i = getelementptr double, ptr %65, i64 %.1323.01494.i
  %.1758.i = load double, ptr %.1757.i, align 8, !noalias !95
  %.1763.i = fmul double %.1642.i, 0x3D719799812DEA11
  %.10.i.i10402 = fcmp ogt double %.1700.i, %.1763.i
  %.11.i.i10403 = select i1 %.10.i.i10402, double %.1700.i, double %.1763.i
  %.1759.i = fsub double 1.000000e+00, %.1758.i
  %.1761.i = fmul double %.1642.i, %.1759.i
  %.1792.i = fcmp ole double %.1761.i, %.11.i.i10403
  %.1853.i = getelementptr double, ptr %70, i64 %.1323.01494.i
  %.1854.i = load double, ptr %.1853.i, align 8, !noalias !95
  %.1856.i = fcmp ult double %.1854.i, 8.000000e+00
  br i1 %.1856.i, label %B1104.i, label %B1062.i

B1062.i:                                          ; preds = %B812.i
  br i1 %.1792.i, label %B1126.i, label %B34.i162.i

B34.i162.i:                                       ; preds = %B1062.i, %B34.if.i270.i
  %.59.i119.0.i = phi i64 [ %.130.i278.i, %B34.if.i270.i ], [ 0, %B1062.i ]
  %exitcond1500.i = icmp eq i64 %.59.i119.0.i, %storemerge1476.i
  br i1 %exitcond1500.i, label %B1104.i, label %B34.if.i270.i

B34.if.i270.i:                                    ; preds = %B34.i162.i
  %.130.i278.i = add i64 %.59.i119.0.i, 1
  %.156.i.i = mul nsw i64 %.59.i119.0.i, %arg.shape.0
  %.158.i184.i = add nsw i64 %.156.i.i, %.1323.01494.i
  %.172.i193.i = icmp slt i64 %.158.i184.i, 0
  %.173.i194.i = select i1 %.172.i193.i, i64 %arg.batch.5.0.5.0, i64 0
  %213 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.158.i184.i
  %.187.i208.i = getelementptr double, ptr %213, i64 %.173.i194.i
  %.188.i209.i = load double, ptr %.187.i208.i, align 8, !noalias !110
  %.191.i.i = add nsw i64 %.59.i119.0.i, %.190.i211.i
  %.193.i213.i = mul nsw i64 %.191.i.i, %arg.shape.0
  %.195.i215.i = add nsw i64 %.193.i213.i, %.1323.01494.i
  %.209.i.i = icmp slt i64 %.195.i215.i, 0
  %.210.i224.i = select i1 %.209.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %214 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.195.i215.i
  %.224.i232.i = getelementptr double, ptr %214, i64 %.210.i224.i
  %.225.i233.i = load double, ptr %.224.i232.i, align 8, !noalias !110
  %.255.i.i = load double, ptr %.254.i.i10401, align 8, !noalias !110
  %.285.i262.i = load double, ptr %arg.tolerances.4, align 8, !noalias !110
  %.286.i263.i = tail call double @llvm.fabs.f64(double %.188.i209.i)
  %.287.i264.i = fmul double %.286.i263.i, %.285.i262.i
  %.288.i265.i = fadd double %.255.i.i, %.287.i264.i
  %.290.i.i = fsub double %.225.i233.i, %.188.i209.i
  %.291.i.i = tail call double @llvm.fabs.f64(double %.290.i.i)
  %.293.i267.i = fmul double %.286.i263.i, 0x3D06849B86A12B9B
  %.294.i.i = fadd double %.293.i267.i, %.288.i265.i
  %.295.i.i10404 = fcmp ogt double %.291.i.i, %.294.i.i
  br i1 %.295.i.i10404, label %B1104.i, label %B34.i162.i

B1104.i:                                          ; preds = %B34.if.i270.i, %B34.i162.i, %B812.i
  %met.2.2.i = phi i1 [ %.1792.i, %B812.i ], [ %exitcond1500.i, %B34.i162.i ], [ %exitcond1500.i, %B34.if.i270.i ]
  %.1929.i = fcmp ole double %.1642.i, %.1927.i
  %or.cond.not.i = select i1 %met.2.2.i, i1 true, i1 %.1929.i
  br i1 %or.cond.not.i, label %B1126.i, label %B1162.i

B1126.i:                                          ; preds = %B1104.i, %B1062.i
  %.1988.i = getelementptr double, ptr %71, i64 %.1323.01494.i
  store double 1.000000e+00, ptr %.1988.i, align 8, !noalias !95
  br label %B1355.i

B1162.i:                                          ; preds = %B1104.i
  %.2046.i = fadd double %.1854.i, 1.000000e+00
  %.2100.i = getelementptr double, ptr %71, i64 %.1323.01494.i
  store double 2.000000e+00, ptr %.2100.i, align 8, !noalias !95
  store double %.2046.i, ptr %.1853.i, align 8, !noalias !95
  %.2211.i = getelementptr double, ptr %66, i64 %.1323.01494.i
  %.2212.i = load double, ptr %.2211.i, align 8, !noalias !95
  %.2214.i = fmul double %.1642.i, %.2212.i
  %.10.i1477.i = fcmp ogt double %.255.i, %.2214.i
  %.11.i1478.i = select i1 %.10.i1477.i, double %.255.i, double %.2214.i
  %.108.i.i = getelementptr double, ptr %72, i64 %.1323.01494.i
  store double 0.000000e+00, ptr %.108.i.i, align 8, !noalias !114
  %.161.i407.i = getelementptr double, ptr %73, i64 %.1323.01494.i
  store double 0.000000e+00, ptr %.161.i407.i, align 8, !noalias !114
  %.214.i451.i = getelementptr double, ptr %74, i64 %.1323.01494.i
  store double %.11.i1478.i, ptr %.214.i451.i, align 8, !noalias !114
  %.267.i491.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1323.01494.i
  %.268.i492.i = load i64, ptr %.267.i491.i, align 8, !noalias !114
  %.294.i509.i = icmp slt i64 %.268.i492.i, 0
  %.295.i510.i = select i1 %.294.i509.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i511.i = add i64 %.295.i510.i, %.268.i492.i
  %.316.i526.i = mul i64 %.296.i511.i, %arg.batch.3.3.5.1
  %.320.i.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i526.i
  %.321.i529.i = load i64, ptr %.320.i.i, align 8, !noalias !114
  %.322.i530.i = add nsw i64 %.321.i529.i, -1
  store i64 %.322.i530.i, ptr %.320.i.i, align 8, !noalias !114
  %.426.i.i = load i64, ptr %.267.i491.i, align 8, !noalias !114
  %.452.i.i10405 = icmp slt i64 %.426.i.i, 0
  %.453.i.i10406 = select i1 %.452.i.i10405, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i10407 = add i64 %.453.i.i10406, %.426.i.i
  %.474.i.i10408 = mul i64 %.454.i.i10407, %arg.batch.3.3.5.1
  %215 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i10408
  %.478.i.i10409 = getelementptr i8, ptr %215, i64 24
  %.479.i.i10410 = load i64, ptr %.478.i.i10409, align 8, !noalias !114
  %.480.i.i10411 = add nsw i64 %.479.i.i10410, 1
  store i64 %.480.i.i10411, ptr %.478.i.i10409, align 8, !noalias !114
  br label %B1355.i

B1355.i:                                          ; preds = %B718.if.i, %B1162.i, %B1126.i
  %exitcond1501.not.i = icmp eq i64 %.1393.i, %arg.shape.0
  br i1 %exitcond1501.not.i, label %B3252, label %B718.if.i

B1356.i:                                          ; preds = %B478.if.i, %B658.i, %B632.i
  %exitcond1499.not.i = icmp eq i64 %arg.shape.0, %.920.i
  br i1 %exitcond1499.not.i, label %B188.loopexit.i, label %B478.if.i

B188.if.i10385:                                   ; preds = %B188.loopexit.i, %B3210
  %.319.01492.i = phi i64 [ 50, %B3210 ], [ %.383.i, %B188.loopexit.i ]
  %.383.i = add nsw i64 %.319.01492.i, -1
  br i1 %.603, label %B188.loopexit.i.critedge, label %B222.if.i10386

B222.if.i10386:                                   ; preds = %B188.if.i10385, %B222.loopexit.i
  %.436.01487.i = phi i64 [ %.505.i, %B222.loopexit.i ], [ 0, %B188.if.i10385 ]
  %.505.i = add nsw i64 %.436.01487.i, 1
  %.582.i = getelementptr double, ptr %65, i64 %.436.01487.i
  %.583.i = load double, ptr %.582.i, align 8, !noalias !95
  %.636.i = getelementptr double, ptr %66, i64 %.436.01487.i
  %.637.i = load double, ptr %.636.i, align 8, !noalias !95
  %.638.i = fadd double %.583.i, %.637.i
  %.639.i = fmul double %.638.i, 5.000000e-01
  %.92.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.436.01487.i
  %.93.i.i = load double, ptr %.92.i.i, align 8, !noalias !105
  %.146.i.i = getelementptr double, ptr %67, i64 %.436.01487.i
  %.147.i.i = load double, ptr %.146.i.i, align 8, !noalias !105
  %.149.i.i = fmul double %.639.i, %.147.i.i
  %.150.i.i = fadd double %.93.i.i, %.149.i.i
  %.203.i.i = getelementptr double, ptr %.502, i64 %.436.01487.i
  store double %.150.i.i, ptr %.203.i.i, align 8, !noalias !105
  br i1 %.287.i1483.not.i, label %B222.loopexit.i, label %B122.if.i.lr.ph.i

B122.if.i.lr.ph.i:                                ; preds = %B222.if.i10386
  %.247.i.i.i10387 = fsub double 1.000000e+00, %.639.i
  %invariant.gep10778 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.436.01487.i
  %invariant.gep10780 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.436.01487.i
  %invariant.gep10782 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.436.01487.i
  %invariant.gep10784 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.436.01487.i
  %invariant.gep10786 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.436.01487.i
  %invariant.gep10788 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.436.01487.i
  %invariant.gep10790 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.436.01487.i
  %invariant.gep10792 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.436.01487.i
  %invariant.gep10794 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.436.01487.i
  br label %B122.if.i.i10389

B478.if.i:                                        ; preds = %B336.i, %B1356.i
  %.851.01490.i = phi i64 [ %.920.i, %B1356.i ], [ 0, %B336.i ]
  %.920.i = add nsw i64 %.851.01490.i, 1
  %216 = getelementptr i64, ptr %68, i64 %.851.01490.i
  %.1002.i = load i64, ptr %216, align 8, !noalias !95
  %.1003.i = icmp sgt i64 %.1002.i, -1
  br i1 %.1003.i, label %B520.i, label %B1356.i

B718.if.i:                                        ; preds = %B1355.i, %B718.if.lr.ph.i
  %.1323.01494.i = phi i64 [ 0, %B718.if.lr.ph.i ], [ %.1393.i, %B1355.i ]
  %.1393.i = add nsw i64 %.1323.01494.i, 1
  %.1474.i = getelementptr double, ptr %69, i64 %.1323.01494.i
  %.1475.i = load double, ptr %.1474.i, align 8, !noalias !95
  %.1529.i = getelementptr double, ptr %.502, i64 %.1323.01494.i
  store double %.1475.i, ptr %.1529.i, align 8, !noalias !95
  %.1584.i = getelementptr i64, ptr %68, i64 %.1323.01494.i
  %.1585.i = load i64, ptr %.1584.i, align 8, !noalias !95
  %.1586.i = icmp sgt i64 %.1585.i, -1
  br i1 %.1586.i, label %B812.i, label %B1355.i

B3252:                                            ; preds = %B1355.i, %B686.i, %B3172.endif.endif, %B3168
  br i1 %.4719.not, label %B3314, label %B120.if.i

B120.loopexit.i.critedge:                         ; preds = %B120.if.i
  %.527.i.c = load i64, ptr %.526.i10424, align 8, !noalias !117
  %.643.i10486.c = inttoptr i64 %.527.i.c to ptr
  tail call void %.643.i10486.c(ptr %.502, ptr %.617.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !117
  br label %B120.loopexit.i

B120.loopexit.i:                                  ; preds = %B496.i, %B120.loopexit.i.critedge
  %exitcond692.not.i = icmp eq i64 %.231.0688.i, %.10332
  br i1 %exitcond692.not.i, label %B3314, label %B120.if.i

B154.loopexit.i:                                  ; preds = %B122.if.i.i10437, %B154.if.i
  %exitcond690.not.i = icmp eq i64 %arg.shape.0, %.423.i
  br i1 %exitcond690.not.i, label %B206.i, label %B154.if.i

B206.i:                                           ; preds = %B154.loopexit.i
  %.527.i = load i64, ptr %.526.i10424, align 8, !noalias !117
  %.643.i10486 = inttoptr i64 %.527.i to ptr
  tail call void %.643.i10486(ptr %.502, ptr %.617.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !117
  br label %B348.if.i

B390.i:                                           ; preds = %B348.if.i
  %217 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.669.0686.i
  %.853.i10487 = load double, ptr %217, align 8, !noalias !117
  %.855.i = fcmp olt double %.853.i10487, -1.000000e-09
  br i1 %.855.i, label %B426.i, label %B496.i

B426.i:                                           ; preds = %B390.i
  %218 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.669.0686.i
  %.84.i51.i = load i64, ptr %218, align 8, !noalias !120
  %.89.i.i10488 = icmp sgt i64 %.84.i51.i, -1
  br i1 %.89.i.i10488, label %B46.i.i10489, label %B426.endif.i

B46.i.i10489:                                     ; preds = %B426.i
  %.120.i73.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i51.i
  %.121.i74.i = load i64, ptr %.120.i73.i, align 8, !noalias !120
  %.122.i75.i = icmp eq i64 %.121.i74.i, 0
  br i1 %.122.i75.i, label %B80.i.i10490, label %B426.endif.i

B80.i.i10490:                                     ; preds = %B46.i.i10489
  store i64 4, ptr %.120.i73.i, align 8, !noalias !120
  br label %B426.endif.i

B496.i:                                           ; preds = %B426.endif.i, %B348.if.i, %B390.i
  %exitcond691.not.i = icmp eq i64 %arg.shape.0, %.738.i
  br i1 %exitcond691.not.i, label %B120.loopexit.i, label %B348.if.i

B120.if.i:                                        ; preds = %B3252, %B120.loopexit.i
  %.231.0688.i = phi i64 [ %.302.i10427, %B120.loopexit.i ], [ 1, %B3252 ]
  %.302.i10427 = add nsw i64 %.231.0688.i, 1
  br i1 %.603, label %B120.loopexit.i.critedge, label %B154.if.lr.ph.i

B154.if.lr.ph.i:                                  ; preds = %B120.if.i
  %219 = uitofp i64 %.231.0688.i to double
  %.456.i = fdiv double %219, %.452.i
  %.247.i.i.i10428 = fsub double 1.000000e+00, %.456.i
  br label %B154.if.i

B154.if.i:                                        ; preds = %B154.if.lr.ph.i, %B154.loopexit.i
  %.354.0683.i = phi i64 [ 0, %B154.if.lr.ph.i ], [ %.423.i, %B154.loopexit.i ]
  %.423.i = add nsw i64 %.354.0683.i, 1
  %.92.i.i10429 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.354.0683.i
  %.93.i.i10430 = load double, ptr %.92.i.i10429, align 8, !noalias !123
  %.146.i.i10431 = getelementptr double, ptr %75, i64 %.354.0683.i
  %.147.i.i10432 = load double, ptr %.146.i.i10431, align 8, !noalias !123
  %.149.i.i10433 = fmul double %.456.i, %.147.i.i10432
  %.150.i.i10434 = fadd double %.93.i.i10430, %.149.i.i10433
  %.203.i.i10435 = getelementptr double, ptr %.502, i64 %.354.0683.i
  store double %.150.i.i10434, ptr %.203.i.i10435, align 8, !noalias !123
  br i1 %.287.i679.not.i, label %B154.loopexit.i, label %B122.if.i.preheader.i

B122.if.i.preheader.i:                            ; preds = %B154.if.i
  %invariant.gep10796 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep10798 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep10800 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep10802 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep10804 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep10806 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep10808 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep10810 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep10812 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  br label %B122.if.i.i10437

B122.if.i.i10437:                                 ; preds = %B122.if.i.i10437, %B122.if.i.preheader.i
  %.229.i.0680.i = phi i64 [ %.300.i.i10479, %B122.if.i.i10437 ], [ 0, %B122.if.i.preheader.i ]
  %.157.i.i.i10438 = add nsw i64 %.229.i.0680.i, %.155.i.i.i10436
  %.159.i.i.i10439 = mul nsw i64 %.157.i.i.i10438, %arg.shape.0
  %gep10797 = getelementptr double, ptr %invariant.gep10796, i64 %.159.i.i.i10439
  %.191.i.i.i10440 = load double, ptr %gep10797, align 8, !noalias !127
  %.193.i.i.i10441 = fadd double %.191.i.i.i10440, 0.000000e+00
  %.253.i.i.i10442 = fmul double %.456.i, %.193.i.i.i10441
  %.157.i.i.1.i10444 = add nsw i64 %.229.i.0680.i, %.155.i.i.1.i10443
  %.159.i.i.1.i10445 = mul nsw i64 %.157.i.i.1.i10444, %arg.shape.0
  %gep10799 = getelementptr double, ptr %invariant.gep10798, i64 %.159.i.i.1.i10445
  %.191.i.i.1.i10446 = load double, ptr %gep10799, align 8, !noalias !127
  %.193.i.i.1.i10447 = fadd double %.191.i.i.1.i10446, %.253.i.i.i10442
  %.253.i.i.1.i10448 = fmul double %.247.i.i.i10428, %.193.i.i.1.i10447
  %.157.i.i.2.i10450 = add nsw i64 %.229.i.0680.i, %.155.i.i.2.i10449
  %.159.i.i.2.i10451 = mul nsw i64 %.157.i.i.2.i10450, %arg.shape.0
  %gep10801 = getelementptr double, ptr %invariant.gep10800, i64 %.159.i.i.2.i10451
  %.191.i.i.2.i10452 = load double, ptr %gep10801, align 8, !noalias !127
  %.193.i.i.2.i10453 = fadd double %.191.i.i.2.i10452, %.253.i.i.1.i10448
  %.253.i.i.2.i10454 = fmul double %.456.i, %.193.i.i.2.i10453
  %.157.i.i.3.i10456 = add nsw i64 %.229.i.0680.i, %.155.i.i.3.i10455
  %.159.i.i.3.i10457 = mul nsw i64 %.157.i.i.3.i10456, %arg.shape.0
  %gep10803 = getelementptr double, ptr %invariant.gep10802, i64 %.159.i.i.3.i10457
  %.191.i.i.3.i10458 = load double, ptr %gep10803, align 8, !noalias !127
  %.193.i.i.3.i10459 = fadd double %.191.i.i.3.i10458, %.253.i.i.2.i10454
  %.253.i.i.3.i10460 = fmul double %.247.i.i.i10428, %.193.i.i.3.i10459
  %.157.i.i.4.i10462 = add nsw i64 %.229.i.0680.i, %.155.i.i.4.i10461
  %.159.i.i.4.i10463 = mul nsw i64 %.157.i.i.4.i10462, %arg.shape.0
  %gep10805 = getelementptr double, ptr %invariant.gep10804, i64 %.159.i.i.4.i10463
  %.191.i.i.4.i10464 = load double, ptr %gep10805, align 8, !noalias !127
  %.193.i.i.4.i10465 = fadd double %.191.i.i.4.i10464, %.253.i.i.3.i10460
  %.253.i.i.4.i10466 = fmul double %.456.i, %.193.i.i.4.i10465
  %.157.i.i.5.i10468 = add nsw i64 %.229.i.0680.i, %.155.i.i.5.i10467
  %.159.i.i.5.i10469 = mul nsw i64 %.157.i.i.5.i10468, %arg.shape.0
  %gep10807 = getelementptr double, ptr %invariant.gep10806, i64 %.159.i.i.5.i10469
  %.191.i.i.5.i10470 = load double, ptr %gep10807, align 8, !noalias !127
  %.193.i.i.5.i10471 = fadd double %.191.i.i.5.i10470, %.253.i.i.4.i10466
  %.253.i.i.5.i10472 = fmul double %.247.i.i.i10428, %.193.i.i.5.i10471
  %.157.i.i.6.i10474 = add nsw i64 %.229.i.0680.i, %.155.i.i.6.i10473
  %.159.i.i.6.i10475 = mul nsw i64 %.157.i.i.6.i10474, %arg.shape.0
  %gep10809 = getelementptr double, ptr %invariant.gep10808, i64 %.159.i.i.6.i10475
  %.191.i.i.6.i10476 = load double, ptr %gep10809, align 8, !noalias !127
  %.193.i.i.6.i10477 = fadd double %.191.i.i.6.i10476, %.253.i.i.5.i10472
  %.253.i.i.6.i10478 = fmul double %.456.i, %.193.i.i.6.i10477
  %.300.i.i10479 = add nsw i64 %.229.i.0680.i, 1
  %.271.i.i.i10480 = mul nsw i64 %.229.i.0680.i, %arg.shape.0
  %gep10811 = getelementptr double, ptr %invariant.gep10810, i64 %.271.i.i.i10480
  %.309.i.i.i10481 = load double, ptr %gep10811, align 8, !noalias !127
  %.313.i.i.i10482 = fadd double %.309.i.i.i10481, %.253.i.i.6.i10478
  %.359.i.i10483 = add nsw i64 %.229.i.0680.i, %.358.i.i10425
  %.361.i.i10484 = mul nsw i64 %.359.i.i10483, %arg.shape.0
  %gep10813 = getelementptr double, ptr %invariant.gep10812, i64 %.361.i.i10484
  store double %.313.i.i.i10482, ptr %gep10813, align 8, !noalias !123
  %exitcond.not.i10485 = icmp eq i64 %arg.shape.1, %.300.i.i10479
  br i1 %exitcond.not.i10485, label %B154.loopexit.i, label %B122.if.i.i10437

B348.if.i:                                        ; preds = %B206.i, %B496.i
  %.669.0686.i = phi i64 [ %.738.i, %B496.i ], [ 0, %B206.i ]
  %.738.i = add nsw i64 %.669.0686.i, 1
  %220 = getelementptr double, ptr %76, i64 %.669.0686.i
  %.820.i = load double, ptr %220, align 8, !noalias !117
  %.821.i = fcmp ogt double %.820.i, 5.000000e-01
  br i1 %.821.i, label %B390.i, label %B496.i

B426.endif.i:                                     ; preds = %B80.i.i10490, %B46.i.i10489, %B426.i
  store double 0.000000e+00, ptr %220, align 8, !noalias !117
  br label %B496.i

B3314:                                            ; preds = %B120.loopexit.i, %B2742, %B3252
  %221 = select i1 %looked.4.2.lcssa, i1 %good.2.1.lcssa, i1 false
  br i1 %221, label %B3322, label %B3374

B3322:                                            ; preds = %B3314
  %within.5.1.not = xor i1 %within.5.1, true
  %brmerge10336 = select i1 %within.5.1.not, i1 true, i1 %.545
  %"$phi3358.7.2.2" = select i1 %brmerge10336, i64 0, i64 3
  br i1 %.603, label %B3374, label %B96.if.i

B172.i:                                           ; preds = %B96.if.i
  %.452.i10493 = getelementptr double, ptr %78, i64 %.180.0654.i
  %.453.i10494 = load double, ptr %.452.i10493, align 8, !noalias !131
  %.454.i10495 = fcmp olt double %.453.i10494, 5.000000e-01
  br i1 %.454.i10495, label %B789.i, label %B210.i

B210.i:                                           ; preds = %B172.i
  %.485.i10496 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.334.i
  %.486.i = load i64, ptr %.485.i10496, align 8, !noalias !131
  %.487.not.i = icmp eq i64 %.486.i, 0
  br i1 %.487.not.i, label %B246.i, label %B789.i

B246.i:                                           ; preds = %B210.i
  %.549.i = mul i64 %.334.i, %arg.batch.3.3.5.1
  %222 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.549.i
  %.553.i = getelementptr i8, ptr %222, i64 8
  %.554.i = load i64, ptr %.553.i, align 8, !noalias !131
  %.556.i = add nsw i64 %.554.i, %"$phi3358.7.2.2"
  store i64 %.556.i, ptr %.553.i, align 8, !noalias !131
  %.662.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.180.0654.i
  %.663.i10498 = load double, ptr %.662.i, align 8, !noalias !131
  %.717.i = getelementptr double, ptr %79, i64 %.180.0654.i
  %.718.i = load double, ptr %.717.i, align 8, !noalias !131
  %.772.i10499 = getelementptr double, ptr %80, i64 %.180.0654.i
  %.773.i10500 = load double, ptr %.772.i10499, align 8, !noalias !131
  %.794.i = icmp slt i64 %.389.i, %arg.batch.2.5.0
  br i1 %.794.i, label %B420.i, label %B760.i

B420.i:                                           ; preds = %B246.i
  %.817.i = icmp slt i64 %.389.i, 0
  %.818.i10501 = select i1 %.817.i, i64 %arg.batch.2.5.0, i64 0
  %223 = getelementptr double, ptr %arg.batch.2.4, i64 %.389.i
  %.832.i = getelementptr double, ptr %223, i64 %.818.i10501
  %.833.i = load double, ptr %.832.i, align 8, !noalias !131
  %.837.i = fcmp ugt double %.833.i, %.773.i10500
  br i1 %.837.i, label %B760.i, label %B444.preheader.i

B444.preheader.i:                                 ; preds = %B420.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul652.i, %.334.i
  %.1324.i = getelementptr double, ptr %81, i64 %.180.0654.i
  %224 = getelementptr double, ptr %arg.batch.3.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep10814 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep10816 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep10818 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep10820 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep10822 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep10824 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep10826 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep10828 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep10830 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  br label %B444.i

B444.i:                                           ; preds = %B736.i, %B444.preheader.i
  %done.2.3.i = phi i64 [ %.1262.i, %B736.i ], [ %.389.i, %B444.preheader.i ]
  br i1 %.924649.not.i, label %B644.i, label %B474.if.lr.ph.i

B474.if.lr.ph.i:                                  ; preds = %B444.i
  %.979.i10502 = icmp slt i64 %done.2.3.i, 0
  %.980.i10503 = select i1 %.979.i10502, i64 %arg.batch.2.5.0, i64 0
  %225 = getelementptr double, ptr %arg.batch.2.4, i64 %done.2.3.i
  %.994.i10504 = getelementptr double, ptr %225, i64 %.980.i10503
  %.1220.i = select i1 %.979.i10502, i64 %arg.batch.3.0.5.1, i64 0
  %.1221.i = add i64 %.1220.i, %done.2.3.i
  %.1250.i = mul i64 %.1221.i, %arg.batch.3.0.5.2
  %226 = getelementptr double, ptr %224, i64 %.1250.i
  br label %B474.if.i

B502.i10513:                                      ; preds = %B474.if.i
  %.1002.i10514 = add nsw i64 %.868.0650.i, %.1000.i
  %.1004.i = mul nsw i64 %.1002.i10514, %arg.shape.0
  %gep10831 = getelementptr double, ptr %invariant.gep10830, i64 %.1004.i
  %.1036.i = load double, ptr %gep10831, align 8, !noalias !131
  br label %B790.i

B644.i:                                           ; preds = %B790.i, %B444.i
  store double 0x7FF0000000000000, ptr %.1324.i, align 8, !noalias !131
  %exitcond656.not.i = icmp eq i64 %done.2.3.i, %82
  br i1 %exitcond656.not.i, label %B760.i, label %B736.i

B736.i:                                           ; preds = %B644.i
  %.1262.i = add i64 %done.2.3.i, 1
  %.1359.i = icmp slt i64 %done.2.3.i, -1
  %.1360.i = select i1 %.1359.i, i64 %arg.batch.2.5.0, i64 0
  %227 = getelementptr double, ptr %arg.batch.2.4, i64 %.1262.i
  %.1374.i = getelementptr double, ptr %227, i64 %.1360.i
  %.1375.i = load double, ptr %.1374.i, align 8, !noalias !131
  %.1379.i = fcmp ugt double %.1375.i, %.773.i10500
  br i1 %.1379.i, label %B760.i, label %B444.i

B760.i:                                           ; preds = %B736.i, %B644.i, %B420.i, %B246.i
  %done.3.2.i = phi i64 [ %.389.i, %B420.i ], [ %.389.i, %B246.i ], [ %arg.batch.2.5.0, %B644.i ], [ %.1262.i, %B736.i ]
  store i64 %done.3.2.i, ptr %.388.i, align 8, !noalias !131
  br label %B789.i

B789.i:                                           ; preds = %B96.if.i, %B760.i, %B210.i, %B172.i
  %exitcond657.not.i = icmp eq i64 %.252.i, %arg.shape.0
  br i1 %exitcond657.not.i, label %B3374, label %B96.if.i

B790.i:                                           ; preds = %B38.if.i.i, %B502.i10513
  %.313.i.i.sink = phi double [ %.313.i.i, %B38.if.i.i ], [ %.1036.i, %B502.i10513 ]
  %228 = getelementptr double, ptr %226, i64 %.868.0650.i
  store double %.313.i.i.sink, ptr %228, align 8, !noalias !131
  %exitcond.not.i10512 = icmp eq i64 %arg.shape.1, %.937.i
  br i1 %exitcond.not.i10512, label %B644.i, label %B474.if.i

B96.if.i:                                         ; preds = %B3322, %B789.i
  %.180.0654.i = phi i64 [ %.252.i, %B789.i ], [ 0, %B3322 ]
  %.252.i = add nsw i64 %.180.0654.i, 1
  %.333.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.180.0654.i
  %.334.i = load i64, ptr %.333.i, align 8, !noalias !131
  %.388.i = getelementptr i64, ptr %77, i64 %.180.0654.i
  %.389.i = load i64, ptr %.388.i, align 8, !noalias !131
  %.397.i10492 = icmp slt i64 %.334.i, 0
  br i1 %.397.i10492, label %B789.i, label %B172.i

B474.if.i:                                        ; preds = %B790.i, %B474.if.lr.ph.i
  %.868.0650.i = phi i64 [ 0, %B474.if.lr.ph.i ], [ %.937.i, %B790.i ]
  %.937.i = add nsw i64 %.868.0650.i, 1
  %.995.i10508 = load double, ptr %.994.i10504, align 8, !noalias !131
  %.997.i = fcmp oeq double %.995.i10508, %.773.i10500
  br i1 %.997.i, label %B502.i10513, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B474.if.i
  %.1145.i = fsub double %.995.i10508, %.663.i10498
  %.1150.i = fdiv double %.1145.i, %.718.i
  %.247.i.i = fsub double 1.000000e+00, %.1150.i
  %.157.i.i = add nsw i64 %.868.0650.i, %.155.i.i
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep10815 = getelementptr double, ptr %invariant.gep10814, i64 %.159.i.i
  %.191.i.i10509 = load double, ptr %gep10815, align 8, !noalias !134
  %.193.i.i = fadd double %.191.i.i10509, 0.000000e+00
  %.253.i.i10510 = fmul double %.1150.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.868.0650.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep10817 = getelementptr double, ptr %invariant.gep10816, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep10817, align 8, !noalias !134
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i10510
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.868.0650.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep10819 = getelementptr double, ptr %invariant.gep10818, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep10819, align 8, !noalias !134
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %.1150.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.868.0650.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep10821 = getelementptr double, ptr %invariant.gep10820, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep10821, align 8, !noalias !134
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.868.0650.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep10823 = getelementptr double, ptr %invariant.gep10822, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep10823, align 8, !noalias !134
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %.1150.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.868.0650.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep10825 = getelementptr double, ptr %invariant.gep10824, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep10825, align 8, !noalias !134
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.868.0650.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep10827 = getelementptr double, ptr %invariant.gep10826, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep10827, align 8, !noalias !134
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %.1150.i, %.193.i.6.i
  %.271.i.i10511 = mul nsw i64 %.868.0650.i, %arg.shape.0
  %gep10829 = getelementptr double, ptr %invariant.gep10828, i64 %.271.i.i10511
  %.309.i.i = load double, ptr %gep10829, align 8, !noalias !134
  %.313.i.i = fadd double %.309.i.i, %.253.i.6.i
  br label %B790.i

B3374:                                            ; preds = %B789.i, %B3322, %B3314
  br i1 %.4955, label %B3424, label %B3386

B3386:                                            ; preds = %B3374
  %.5010 = load double, ptr %.5009, align 8
  %.5011 = fcmp ogt double %.5010, 5.000000e-01
  br i1 %.5011, label %B3424, label %B3492

B3424:                                            ; preds = %B3386, %B3374
  %.5042 = load i64, ptr %.5041, align 8
  %.5087 = inttoptr i64 %.5042 to ptr
  tail call void %.5087(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3492

B3492:                                            ; preds = %B3424, %B3386
  %.not = xor i1 %203, true
  %brmerge10860 = or i1 %.603, %.not
  br i1 %brmerge10860, label %B3548, label %B80.if.i6982

B124.i:                                           ; preds = %B80.if.i6982
  %.354.i6110 = getelementptr double, ptr %84, i64 %.141.i5909.010839
  %.355.i = load double, ptr %.354.i6110, align 8, !noalias !138
  %.356.i6111 = fcmp oeq double %.355.i, 1.000000e+00
  br i1 %.356.i6111, label %B174.i, label %B740.i

B174.i:                                           ; preds = %B124.i
  %.411.i6292 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.141.i5909.010839
  %.412.i6293 = load double, ptr %.411.i6292, align 8, !noalias !138
  %.466.i6341 = getelementptr double, ptr %85, i64 %.141.i5909.010839
  %.467.i6342 = load double, ptr %.466.i6341, align 8, !noalias !138
  %.468.i6343 = fsub double %.412.i6293, %.467.i6342
  br i1 %.555.i638110832.not, label %B380.i, label %B270.if.i.preheader

B270.if.i.preheader:                              ; preds = %B174.i
  %invariant.gep10936 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.141.i5909.010839
  br label %B270.if.i

B380.i:                                           ; preds = %B270.if.i, %B174.i
  %fastest.2.i.3.lcssa = phi double [ 0.000000e+00, %B174.i ], [ %.11.i.i, %B270.if.i ]
  %.669.i6393 = fmul double %.468.i6343, %fastest.2.i.3.lcssa
  %.701.i6419 = load double, ptr %.700.i6418, align 8, !noalias !138
  %.702.i6420 = fcmp ogt double %.669.i6393, %.701.i6419
  %.10340 = select i1 %.702.i6420, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  %.746.i6448 = load double, ptr %.745.i6447, align 8, !noalias !138
  %.776.i6473 = load double, ptr %arg.batch.2.4, align 8, !noalias !138
  %.777.i6474 = fsub double %.746.i6448, %.776.i6473
  %.779.i6476 = fmul double %.10340, %.777.i6474
  %.783.i6479 = fcmp olt double %.468.i6343, %.779.i6476
  br i1 %.783.i6479, label %B490.i, label %B528.i

B490.i:                                           ; preds = %B380.i
  %229 = getelementptr i64, ptr %87, i64 %.141.i5909.010839
  %.841.i6917 = load i64, ptr %229, align 8, !noalias !138
  %.842.i6918 = add nsw i64 %.841.i6917, 1
  br label %B528.i

B528.i:                                           ; preds = %B380.i, %B490.i
  %"$phi528.1.2.i.3" = phi i64 [ %.842.i6918, %B490.i ], [ 0, %B380.i ]
  %230 = getelementptr i64, ptr %88, i64 %.141.i5909.010839
  store i64 %"$phi528.1.2.i.3", ptr %230, align 8, !noalias !138
  %.962.i6576 = load double, ptr %.411.i6292, align 8, !noalias !138
  store double %.962.i6576, ptr %.466.i6341, align 8, !noalias !138
  %.1071.i6663 = getelementptr double, ptr %89, i64 %.141.i5909.010839
  store double 1.000000e+00, ptr %.1071.i6663, align 8, !noalias !138
  store i64 1, ptr %.981, align 8, !noalias !138
  %.1157.i6728 = load i64, ptr %230, align 8, !noalias !138
  %.1158.i6729 = icmp sgt i64 %.1157.i6728, 1000
  br i1 %.1158.i6729, label %B694.i, label %B740.i

B694.i:                                           ; preds = %B528.i
  %231 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.141.i5909.010839
  %.84.i.i6808 = load i64, ptr %231, align 8, !noalias !142
  %.89.i.i6811 = icmp sgt i64 %.84.i.i6808, -1
  br i1 %.89.i.i6811, label %B46.i.i6817, label %B740.i

B46.i.i6817:                                      ; preds = %B694.i
  %.120.i.i6837 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i6808
  %.121.i.i6838 = load i64, ptr %.120.i.i6837, align 8, !noalias !142
  %.122.i.i6839 = icmp eq i64 %.121.i.i6838, 0
  br i1 %.122.i.i6839, label %B80.i.i6844, label %B740.i

B80.i.i6844:                                      ; preds = %B46.i.i6817
  store i64 6, ptr %.120.i.i6837, align 8, !noalias !142
  br label %B740.i

B740.i:                                           ; preds = %B80.i.i6844, %B694.i, %B46.i.i6817, %B528.i, %B124.i
  %.1249.i = load double, ptr %.354.i6110, align 8, !noalias !138
  %.1250.i6148 = fcmp oeq double %.1249.i, 2.000000e+00
  br i1 %.1250.i6148, label %B788.i, label %B820.i

B788.i:                                           ; preds = %B740.i
  %.1305.i6243 = getelementptr double, ptr %90, i64 %.141.i5909.010839
  %.1306.i6244 = load double, ptr %.1305.i6243, align 8, !noalias !138
  br label %B820.i

B820.i:                                           ; preds = %B740.i, %B788.i
  %"$phi820.1.2.i.2" = phi double [ %.1306.i6244, %B788.i ], [ 0.000000e+00, %B740.i ]
  %.1368.i6184 = getelementptr double, ptr %91, i64 %.141.i5909.010839
  store double %"$phi820.1.2.i.2", ptr %.1368.i6184, align 8, !noalias !138
  store double 0.000000e+00, ptr %.354.i6110, align 8, !noalias !138
  br label %B871.i

B871.i:                                           ; preds = %B80.if.i6982, %B820.i
  %.200.i5997 = icmp sgt i64 %.144.i5910.010838, 1
  br i1 %.200.i5997, label %B80.if.i6982, label %B3548

B80.if.i6982:                                     ; preds = %B3492, %B871.i
  %.141.i5909.010839 = phi i64 [ %.213.i6990, %B871.i ], [ 0, %B3492 ]
  %.144.i5910.010838 = phi i64 [ %.209.i6987, %B871.i ], [ %storemerge, %B3492 ]
  %.209.i6987 = add nsw i64 %.144.i5910.010838, -1
  %.213.i6990 = add nsw i64 %.141.i5909.010839, 1
  %.294.i6062 = getelementptr double, ptr %83, i64 %.141.i5909.010839
  %.295.i6063 = load double, ptr %.294.i6062, align 8, !noalias !138
  %.296.i6064 = fcmp olt double %.295.i6063, 5.000000e-01
  br i1 %.296.i6064, label %B871.i, label %B124.i

B270.if.i:                                        ; preds = %B270.if.i.preheader, %B270.if.i
  %fastest.2.i.310835 = phi double [ %.11.i.i, %B270.if.i ], [ 0.000000e+00, %B270.if.i.preheader ]
  %.499.i5926.010834 = phi i64 [ %.568.i6973, %B270.if.i ], [ 0, %B270.if.i.preheader ]
  %.568.i6973 = add nsw i64 %.499.i5926.010834, 1
  %.595.i6925 = add nsw i64 %.499.i5926.010834, %arg.shape.1
  %.597.i6927 = mul nsw i64 %.595.i6925, %arg.shape.0
  %gep10937 = getelementptr double, ptr %invariant.gep10936, i64 %.597.i6927
  %.629.i6955 = load double, ptr %gep10937, align 8, !noalias !138
  %.630.i6956 = tail call double @llvm.fabs.f64(double %.629.i6955)
  %.10.i.i = fcmp ogt double %.630.i6956, %fastest.2.i.310835
  %.11.i.i = select i1 %.10.i.i, double %.630.i6956, double %fastest.2.i.310835
  %exitcond10887.not = icmp eq i64 %arg.shape.1, %.568.i6973
  br i1 %exitcond10887.not, label %B380.i, label %B270.if.i

B3548:                                            ; preds = %B871.i, %B3492
  %brmerge10342.not = and i1 %.5157.not, %looked.4.2.lcssa
  %brmerge10342.not.not = xor i1 %brmerge10342.not, true
  %brmerge10859 = or i1 %.603, %brmerge10342.not.not
  br i1 %brmerge10859, label %B3598, label %B114.if.i

B46.i.i10515:                                     ; preds = %B114.if.i
  %.135.i.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !145
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i10523, label %B228.i

B80.i.i10523:                                     ; preds = %B46.i.i10515
  %.196.i.i = getelementptr double, ptr %92, i64 %.302.01639.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !145
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B228.i, label %B122.i.i10524

B122.i.i10524:                                    ; preds = %B80.i.i10523
  %.264.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.302.01639.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !145
  %.321.i.i = getelementptr double, ptr %93, i64 %.302.01639.i
  %.322.i.i = load double, ptr %.321.i.i, align 8, !noalias !145
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.175.i3061635.not.i
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01641.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01641.i
  br i1 %brmerge.i, label %B228.i, label %B76.if.i.lr.ph.i10525

B76.if.i.lr.ph.i10525:                            ; preds = %B122.i.i10524
  %232 = getelementptr i64, ptr %94, i64 %.302.01639.i
  %.513.i = load i64, ptr %232, align 8, !noalias !150
  %.514.i = add nsw i64 %.513.i, 1
  %.236.i323.i = icmp slt i64 %.513.i, -1
  %.237.i324.i = select i1 %.236.i323.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i325.i = add i64 %.514.i, %.237.i324.i
  %.258.i342.i = mul i64 %.238.i325.i, %arg.batch.1.3.5.1
  %233 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i342.i
  br label %B76.if.i.i10526

B76.if.i.i10526:                                  ; preds = %B76.if.i.i10526, %B76.if.i.lr.ph.i10525
  %.117.i268.01636.i = phi i64 [ 0, %B76.if.i.lr.ph.i10525 ], [ %.188.i390.i, %B76.if.i.i10526 ]
  %.188.i390.i = add nsw i64 %.117.i268.01636.i, 1
  %234 = getelementptr double, ptr %233, i64 %.117.i268.01636.i
  %.263.i344.i = load double, ptr %234, align 8, !noalias !151
  %235 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i268.01636.i
  %.293.i360.i = load i64, ptr %235, align 8, !noalias !151
  %.295.i362.i = mul nsw i64 %.293.i360.i, %arg.shape.0
  %.297.i364.i = add nsw i64 %.295.i362.i, %.302.01639.i
  %.311.i372.i = icmp slt i64 %.297.i364.i, 0
  %.312.i373.i = select i1 %.311.i372.i, i64 %arg.batch.5.1.5.0, i64 0
  %236 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i364.i
  %.326.i383.i = getelementptr double, ptr %236, i64 %.312.i373.i
  store double %.263.i344.i, ptr %.326.i383.i, align 8, !noalias !151
  %exitcond.not.i10527 = icmp eq i64 %arg.batch.1.1.5.0, %.188.i390.i
  br i1 %exitcond.not.i10527, label %B228.i, label %B76.if.i.i10526

B228.i:                                           ; preds = %B76.if.i.i10526, %B114.if.i, %B122.i.i10524, %B80.i.i10523, %B46.i.i10515
  %some.3.1.i = phi i1 [ %some.2.01641.mux.i, %B122.i.i10524 ], [ %some.2.01641.i, %B80.i.i10523 ], [ %some.2.01641.i, %B114.if.i ], [ %some.2.01641.i, %B46.i.i10515 ], [ true, %B76.if.i.i10526 ]
  %exitcond1650.not.i = icmp eq i64 %arg.shape.0, %.373.i
  br i1 %exitcond1650.not.i, label %B230.i, label %B114.if.i

B230.i:                                           ; preds = %B228.i
  br i1 %some.3.1.i, label %B238.i, label %B3598

B238.i:                                           ; preds = %B230.i
  %.637.i10517 = load i64, ptr %.636.i10516, align 8, !noalias !150
  %.749.i10518 = inttoptr i64 %.637.i10517 to ptr
  tail call void %.749.i10518(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !150
  %.780.i = load i64, ptr %.779.i10519, align 8, !noalias !150
  %.896.i10521 = inttoptr i64 %.780.i to ptr
  tail call void %.896.i10521(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.895.i10520), !noalias !150
  br i1 %.900.not.i, label %B598.if.i.preheader, label %B456.i

B456.i:                                           ; preds = %B238.i
  %.931.i = load i64, ptr %.930.i, align 8, !noalias !150
  %.1049.i = inttoptr i64 %.931.i to ptr
  tail call void %.1049.i(ptr %arg.batch.4.0.4, ptr %.895.i10520, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !150
  br label %B598.if.i.preheader

B598.if.i.preheader:                              ; preds = %B456.i, %B238.i
  br label %B598.if.i

B46.i82.i:                                        ; preds = %B598.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !155
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B1076.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %92, i64 %.1090.01648.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !155
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B1076.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.1090.01648.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !155
  %.321.i223.i = getelementptr double, ptr %93, i64 %.1090.01648.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !155
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B1076.i, label %B638.i

B638.i:                                           ; preds = %B122.i147.i
  %.1344.i = getelementptr i64, ptr %95, i64 %.1090.01648.i
  %.1345.i = load i64, ptr %.1344.i, align 8, !noalias !150
  %.1356.i = icmp sgt i64 %.1345.i, 0
  br i1 %.1356.i, label %B714.i, label %B768.i

B714.i:                                           ; preds = %B638.i
  %237 = getelementptr double, ptr %arg.batch.2.4, i64 %.1345.i
  %.1391.i = getelementptr i8, ptr %237, i64 -8
  %.1392.i = load double, ptr %.1391.i, align 8, !noalias !150
  %.1448.i = fcmp oeq double %.1392.i, %.265.i185.i
  br label %B768.i

B768.i:                                           ; preds = %B714.i, %B638.i
  %"$phi768.1.2.1.i" = phi i1 [ %.1448.i, %B714.i ], [ false, %B638.i ]
  br i1 %.15441642.not.i, label %B978.i, label %B800.if.lr.ph.i

B800.if.lr.ph.i:                                  ; preds = %B768.i
  %.1674.i = add nsw i64 %.1345.i, -1
  %.1713.i = select i1 %.1356.i, i64 0, i64 %arg.batch.3.0.5.1
  %.1714.i = add i64 %.1674.i, %.1713.i
  %.1741.i = mul i64 %.1739.i, %.99.i78.i
  %.1743.i = mul i64 %.1714.i, %arg.batch.3.0.5.2
  %238 = getelementptr double, ptr %arg.batch.3.0.4, i64 %.1741.i
  %239 = getelementptr double, ptr %238, i64 %.1743.i
  %invariant.gep10840 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  %invariant.gep10842 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  br label %B800.if.i

B896.i:                                           ; preds = %B800.if.i
  %240 = getelementptr double, ptr %239, i64 %.1488.01643.i
  store double %.1622.i, ptr %240, align 8, !noalias !150
  br label %B918.i

B918.i:                                           ; preds = %B800.if.i, %B896.i
  %exitcond1651.not.i = icmp eq i64 %arg.shape.1, %.1557.i
  br i1 %exitcond1651.not.i, label %B920.loopexit.i, label %B800.if.i

B920.loopexit.i:                                  ; preds = %B918.i
  %241 = fcmp une double %.1629.i, 0.000000e+00
  br i1 %241, label %B932.i, label %B978.i

B932.i:                                           ; preds = %B920.loopexit.i
  %.84.i452.i = load i64, ptr %244, align 8, !noalias !158
  %.89.i454.i = icmp sgt i64 %.84.i452.i, -1
  br i1 %.89.i454.i, label %B46.i458.i, label %B978.i

B46.i458.i:                                       ; preds = %B932.i
  %.120.i478.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i452.i
  %.121.i479.i = load i64, ptr %.120.i478.i, align 8, !noalias !158
  %.122.i480.i = icmp eq i64 %.121.i479.i, 0
  br i1 %.122.i480.i, label %B80.i484.i, label %B978.i

B80.i484.i:                                       ; preds = %B46.i458.i
  store i64 3, ptr %.120.i478.i, align 8, !noalias !158
  br label %B978.i

B978.i:                                           ; preds = %B80.i484.i, %B46.i458.i, %B932.i, %B920.loopexit.i, %B768.i
  br i1 %.900.not.i, label %B1076.i, label %B994.i

B994.i:                                           ; preds = %B978.i
  %242 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.1090.01648.i
  %.1846.i = load double, ptr %242, align 8, !noalias !150
  %.1848.i = fcmp olt double %.1846.i, -1.000000e-09
  br i1 %.1848.i, label %B1030.i, label %B1076.i

B1030.i:                                          ; preds = %B994.i
  %.84.i583.i = load i64, ptr %244, align 8, !noalias !161
  %.89.i586.i = icmp sgt i64 %.84.i583.i, -1
  br i1 %.89.i586.i, label %B46.i591.i, label %B1076.i

B46.i591.i:                                       ; preds = %B1030.i
  %.120.i616.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i583.i
  %.121.i617.i = load i64, ptr %.120.i616.i, align 8, !noalias !161
  %.122.i618.i = icmp eq i64 %.121.i617.i, 0
  br i1 %.122.i618.i, label %B80.i623.i, label %B1076.i

B80.i623.i:                                       ; preds = %B46.i591.i
  store i64 4, ptr %.120.i616.i, align 8, !noalias !161
  br label %B1076.i

B1076.i:                                          ; preds = %B598.if.i, %B80.i623.i, %B46.i591.i, %B1030.i, %B994.i, %B978.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %.1146.i = icmp sgt i64 %.1093.01649.i, 1
  br i1 %.1146.i, label %B598.if.i, label %B3598

B114.if.i:                                        ; preds = %B3548, %B228.i
  %some.2.01641.i = phi i1 [ %some.3.1.i, %B228.i ], [ false, %B3548 ]
  %.302.01639.i = phi i64 [ %.373.i, %B228.i ], [ 0, %B3548 ]
  %.373.i = add nsw i64 %.302.01639.i, 1
  %243 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.302.01639.i
  %.99.i.i = load i64, ptr %243, align 8, !noalias !145
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B228.i, label %B46.i.i10515

B598.if.i:                                        ; preds = %B598.if.i.preheader, %B1076.i
  %.1093.01649.i = phi i64 [ %.1155.i, %B1076.i ], [ %storemerge.i, %B598.if.i.preheader ]
  %.1090.01648.i = phi i64 [ %.1159.i, %B1076.i ], [ 0, %B598.if.i.preheader ]
  %.1155.i = add nsw i64 %.1093.01649.i, -1
  %.1159.i = add nsw i64 %.1090.01648.i, 1
  %244 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1090.01648.i
  %.99.i78.i = load i64, ptr %244, align 8, !noalias !155
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B1076.i, label %B46.i82.i

B800.if.i:                                        ; preds = %B918.i, %B800.if.lr.ph.i
  %trouble.2.11645.i = phi double [ 0.000000e+00, %B800.if.lr.ph.i ], [ %.1629.i, %B918.i ]
  %.1488.01643.i = phi i64 [ 0, %B800.if.lr.ph.i ], [ %.1557.i, %B918.i ]
  %.1557.i = add nsw i64 %.1488.01643.i, 1
  %.1588.i = add nsw i64 %.1488.01643.i, %.850.i
  %.1590.i = mul nsw i64 %.1588.i, %arg.shape.0
  %gep10841 = getelementptr double, ptr %invariant.gep10840, i64 %.1590.i
  %.1622.i = load double, ptr %gep10841, align 8, !noalias !150
  %.1627.i = fmul double %.1622.i, 0.000000e+00
  %.1629.i = fadd double %trouble.2.11645.i, %.1627.i
  %.1637.i = mul nsw i64 %.1488.01643.i, %arg.shape.0
  %gep10843 = getelementptr double, ptr %invariant.gep10842, i64 %.1637.i
  store double %.1622.i, ptr %gep10843, align 8, !noalias !150
  br i1 %"$phi768.1.2.1.i", label %B896.i, label %B918.i

B3598:                                            ; preds = %B1076.i, %B3548, %B230.i
  %looked.4.2.lcssa.not = xor i1 %looked.4.2.lcssa, true
  %brmerge10861 = or i1 %.603, %looked.4.2.lcssa.not
  %active.9.1.mux = select i1 %looked.4.2.lcssa, i64 0, i64 %active.9.1
  br i1 %brmerge10861, label %B4574, label %B3640.if

B3688:                                            ; preds = %B3640.if
  %.5540 = mul i64 %.5467, %arg.batch.3.3.5.1
  %.5544 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.5540
  %.5545 = load i64, ptr %.5544, align 8
  %.5601 = getelementptr i8, ptr %.5544, i64 24
  %.5602 = load i64, ptr %.5601, align 8
  %245 = add i64 %.5545, %.5602
  %.5603 = sub i64 %arg.most, %245
  %.5608 = icmp slt i64 %.5603, 1
  br i1 %.5608, label %B3768, label %B3814

B3768:                                            ; preds = %B3688
  %246 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5305.010848
  %.84.i7071 = load i64, ptr %246, align 8, !noalias !164
  %.89.i7074 = icmp sgt i64 %.84.i7071, -1
  br i1 %.89.i7074, label %B46.i7079, label %B3814

B46.i7079:                                        ; preds = %B3768
  %.120.i7105 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i7071
  %.121.i7106 = load i64, ptr %.120.i7105, align 8, !noalias !164
  %.122.i7107 = icmp eq i64 %.121.i7106, 0
  br i1 %.122.i7107, label %B80.i7112, label %B3814

B80.i7112:                                        ; preds = %B46.i7079
  store i64 5, ptr %.120.i7105, align 8, !noalias !164
  br label %B3814

B3814:                                            ; preds = %B80.i7112, %B3768, %B46.i7079, %B3688
  %.5698 = getelementptr double, ptr %96, i64 %.5305.010848
  %.5699 = load double, ptr %.5698, align 8
  %.5700 = fcmp ogt double %.5699, 5.000000e-01
  br i1 %.5700, label %B3852, label %B3956

B3852:                                            ; preds = %B3814
  %.5755 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5305.010848
  %.5756 = load double, ptr %.5755, align 8
  %.5810 = getelementptr double, ptr %97, i64 %.5305.010848
  %.5811 = load double, ptr %.5810, align 8
  %.5812 = fcmp oeq double %.5756, %.5811
  br i1 %.5812, label %B3916, label %B3956

B3916:                                            ; preds = %B3852
  %.192.i7339 = load i64, ptr %.5466, align 8, !noalias !167
  %.248.i7387 = getelementptr i64, ptr %98, i64 %.5305.010848
  %.249.i7388 = load i64, ptr %.248.i7387, align 8, !noalias !167
  %.250.i7389 = add nsw i64 %.249.i7388, 1
  store i64 %.250.i7389, ptr %.248.i7387, align 8, !noalias !167
  %.373.i7493 = icmp slt i64 %.249.i7388, -1
  %.374.i7494 = select i1 %.373.i7493, i64 %arg.batch.1.2.5.0, i64 0
  %247 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.250.i7389
  %.388.i7508 = getelementptr double, ptr %247, i64 %.374.i7494
  %.389.i7509 = load double, ptr %.388.i7508, align 8, !noalias !167
  %.390.i7510 = fcmp oeq double %.389.i7509, 0x7FF0000000000000
  br i1 %.390.i7510, label %B182.i, label %B240.i7511

B182.i:                                           ; preds = %B3916
  %.424.i8038 = icmp slt i64 %.192.i7339, 0
  %.425.i8039 = select i1 %.424.i8038, i64 %arg.batch.3.1.5.0, i64 0
  %248 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.192.i7339
  %.439.i8053 = getelementptr i64, ptr %248, i64 %.425.i8039
  %.440.i8054 = load i64, ptr %.439.i8053, align 8, !noalias !167
  %.441.i8055 = icmp eq i64 %.440.i8054, 0
  br i1 %.441.i8055, label %B216.i8059, label %B3956

B216.i8059:                                       ; preds = %B182.i
  store i64 1, ptr %.439.i8053, align 8, !noalias !167
  br label %B3956

B240.i7511:                                       ; preds = %B3916
  store double %.389.i7509, ptr %.5810, align 8, !noalias !167
  %.592.i7601 = select i1 %.373.i7493, i64 %arg.batch.1.4.5.0, i64 0
  %249 = getelementptr i64, ptr %arg.batch.1.4.4, i64 %.250.i7389
  %.606.i7615 = getelementptr i64, ptr %249, i64 %.592.i7601
  %.607.i7616 = load i64, ptr %.606.i7615, align 8, !noalias !167
  %.610.i7618 = icmp eq i64 %.607.i7616, 0
  br i1 %.610.i7618, label %B300.i, label %B348.i

B300.i:                                           ; preds = %B240.i7511
  %.665.i7993 = getelementptr double, ptr %99, i64 %.5305.010848
  store double 1.000000e+00, ptr %.665.i7993, align 8, !noalias !167
  br label %B392.i.sink.split

B348.i:                                           ; preds = %B240.i7511
  %.733.i7644 = load i64, ptr %.981, align 8, !noalias !167
  %.734.i7645 = icmp eq i64 %.733.i7644, 0
  br i1 %.734.i7645, label %B392.i.sink.split, label %B392.i

B392.i.sink.split:                                ; preds = %B348.i, %B300.i
  %.sink = phi i64 [ 1, %B300.i ], [ 2, %B348.i ]
  store i64 %.sink, ptr %.981, align 8, !noalias !167
  br label %B392.i

B392.i:                                           ; preds = %B392.i.sink.split, %B348.i
  br i1 %.175.i.i779710844.not, label %B3956, label %B76.if.i.i.lr.ph

B76.if.i.i.lr.ph:                                 ; preds = %B392.i
  %.237.i.i7846 = select i1 %.373.i7493, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i7847 = add i64 %.237.i.i7846, %.250.i7389
  %.258.i.i7863 = mul i64 %.238.i.i7847, %arg.batch.1.3.5.1
  %250 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i7863
  br label %B76.if.i.i

B76.if.i.i:                                       ; preds = %B76.if.i.i.lr.ph, %B76.if.i.i
  %.117.i.i7150.010846 = phi i64 [ 0, %B76.if.i.i.lr.ph ], [ %.188.i.i7912, %B76.if.i.i ]
  %.188.i.i7912 = add nsw i64 %.117.i.i7150.010846, 1
  %251 = getelementptr double, ptr %250, i64 %.117.i.i7150.010846
  %.263.i.i7866 = load double, ptr %251, align 8, !noalias !171
  %252 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.i7150.010846
  %.293.i.i7884 = load i64, ptr %252, align 8, !noalias !171
  %.295.i.i7886 = mul nsw i64 %.293.i.i7884, %arg.shape.0
  %.297.i.i7888 = add nsw i64 %.295.i.i7886, %.5305.010848
  %.311.i.i7895 = icmp slt i64 %.297.i.i7888, 0
  %.312.i.i7896 = select i1 %.311.i.i7895, i64 %arg.batch.5.1.5.0, i64 0
  %253 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i7888
  %.326.i.i7906 = getelementptr double, ptr %253, i64 %.312.i.i7896
  store double %.263.i.i7866, ptr %.326.i.i7906, align 8, !noalias !171
  %exitcond10888.not = icmp eq i64 %arg.batch.1.1.5.0, %.188.i.i7912
  br i1 %exitcond10888.not, label %B3956, label %B76.if.i.i

B3956:                                            ; preds = %B76.if.i.i, %B392.i, %B216.i8059, %B182.i, %B3852, %B3814
  %.5901 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.5467
  %.5902 = load i64, ptr %.5901, align 8
  %.5903.not = icmp eq i64 %.5902, 0
  br i1 %.5903.not, label %B4098, label %B3990

B3990:                                            ; preds = %B3956
  %.5964 = getelementptr i64, ptr %100, i64 %.5305.010848
  %.5965 = load i64, ptr %.5964, align 8
  %.5995 = getelementptr i64, ptr %arg.batch.3.2.4, i64 %.5467
  store i64 %.5965, ptr %.5995, align 8
  store i64 -1, ptr %.5466, align 8
  %.236.i10528 = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !175
  %.293.i10533 = getelementptr double, ptr %101, i64 %.5305.010848
  store double 0.000000e+00, ptr %.293.i10533, align 8, !noalias !175
  %.324.i10535 = load i64, ptr %.323.i10534, align 8, !noalias !175
  %.326.i10536 = icmp eq i64 %.236.i10528, %.324.i10535
  br i1 %.326.i10536, label %B4306, label %B132.i10537

B132.i10537:                                      ; preds = %B3990
  %.359.i10538 = add nsw i64 %.236.i10528, 1
  store i64 %.359.i10538, ptr %arg.batch.4.2.4, align 8, !noalias !175
  store i64 1, ptr %.981, align 8, !noalias !175
  %.438.i10540 = icmp slt i64 %.236.i10528, 0
  %.439.i10541 = select i1 %.438.i10540, i64 %arg.batch.0.2.5.0, i64 0
  %254 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i10528
  %.453.i10542 = getelementptr i64, ptr %254, i64 %.439.i10541
  %.454.i10543 = load i64, ptr %.453.i10542, align 8, !noalias !175
  %.469.i10544 = icmp slt i64 %.454.i10543, 0
  %.470.i10545 = select i1 %.469.i10544, i64 %arg.batch.1.0.5.0, i64 0
  %255 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i10543
  %.484.i10546 = getelementptr i64, ptr %255, i64 %.470.i10545
  %.485.i10547 = load i64, ptr %.484.i10546, align 8, !noalias !175
  store i64 %.236.i10528, ptr %.5466, align 8, !noalias !175
  %.595.i10551 = getelementptr i64, ptr %102, i64 %.5305.010848
  store i64 %.485.i10547, ptr %.595.i10551, align 8, !noalias !175
  store i64 1, ptr %.5964, align 8, !noalias !175
  %.709.i10555 = getelementptr i64, ptr %103, i64 %.5305.010848
  store i64 0, ptr %.709.i10555, align 8, !noalias !175
  br i1 %.8051131.not.i10556, label %B402.i10571, label %B358.if.lr.ph.i10557

B358.if.lr.ph.i10557:                             ; preds = %B132.i10537
  %.867.i10558 = select i1 %.438.i10540, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i10559 = add i64 %.867.i10558, %.236.i10528
  %.888.i10560 = mul i64 %.868.i10559, %arg.batch.0.1.5.1
  %256 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i10560
  %invariant.gep10938 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.5305.010848
  br label %B358.if.i10561

B402.i10571:                                      ; preds = %B358.if.i10561, %B132.i10537
  br i1 %.175.i1134.not.i10572, label %B402.endif.i10590, label %B76.if.i.lr.ph.i10573

B76.if.i.lr.ph.i10573:                            ; preds = %B402.i10571
  %.990.i10574 = load i64, ptr %.595.i10551, align 8, !noalias !175
  %.236.i.i10575 = icmp slt i64 %.990.i10574, 0
  %.237.i.i10576 = select i1 %.236.i.i10575, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i10577 = add i64 %.237.i.i10576, %.990.i10574
  %.258.i.i10578 = mul i64 %.238.i.i10577, %arg.batch.1.3.5.1
  %257 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i10578
  br label %B76.if.i.i10579

B76.if.i.i10579:                                  ; preds = %B76.if.i.i10579, %B76.if.i.lr.ph.i10573
  %.117.i.01135.i10580 = phi i64 [ 0, %B76.if.i.lr.ph.i10573 ], [ %.188.i.i10581, %B76.if.i.i10579 ]
  %.188.i.i10581 = add nsw i64 %.117.i.01135.i10580, 1
  %258 = getelementptr double, ptr %257, i64 %.117.i.01135.i10580
  %.263.i.i10582 = load double, ptr %258, align 8, !noalias !178
  %259 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i10580
  %.293.i.i10583 = load i64, ptr %259, align 8, !noalias !178
  %.295.i.i10584 = mul nsw i64 %.293.i.i10583, %arg.shape.0
  %.297.i.i10585 = add nsw i64 %.295.i.i10584, %.5305.010848
  %.311.i.i10586 = icmp slt i64 %.297.i.i10585, 0
  %.312.i.i10587 = select i1 %.311.i.i10586, i64 %arg.batch.5.1.5.0, i64 0
  %260 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i10585
  %.326.i.i10588 = getelementptr double, ptr %260, i64 %.312.i.i10587
  store double %.263.i.i10582, ptr %.326.i.i10588, align 8, !noalias !178
  %exitcond1142.not.i10589 = icmp eq i64 %.188.i.i10581, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i10589, label %B402.endif.i10590, label %B76.if.i.i10579

B888.i10682:                                      ; preds = %B580.if.i10606
  store double 0.000000e+00, ptr %.1877.i10679, align 8, !noalias !175
  br label %B4306

B358.if.i10561:                                   ; preds = %B358.if.i10561, %B358.if.lr.ph.i10557
  %.747.01132.i10562 = phi i64 [ 0, %B358.if.lr.ph.i10557 ], [ %.818.i10563, %B358.if.i10561 ]
  %.818.i10563 = add nsw i64 %.747.01132.i10562, 1
  %261 = getelementptr double, ptr %256, i64 %.747.01132.i10562
  %.893.i10564 = load double, ptr %261, align 8, !noalias !175
  %.895.i10565 = mul nsw i64 %.747.01132.i10562, %arg.shape.0
  %gep10939 = getelementptr double, ptr %invariant.gep10938, i64 %.895.i10565
  store double %.893.i10564, ptr %gep10939, align 8, !noalias !175
  %exitcond.not.i10570 = icmp eq i64 %.818.i10563, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i10570, label %B402.i10571, label %B358.if.i10561

B402.endif.i10590:                                ; preds = %B76.if.i.i10579, %B402.i10571
  br i1 %.11171137.not.i10591, label %B580.if.i10606, label %B496.if.lr.ph.i10592

B496.if.lr.ph.i10592:                             ; preds = %B402.endif.i10590
  %.1179.i10593 = select i1 %.438.i10540, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i10594 = add i64 %.1179.i10593, %.236.i10528
  %.1200.i10595 = mul i64 %.1180.i10594, %arg.batch.0.0.5.1
  %262 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i10595
  %invariant.gep10940 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.5305.010848
  br label %B496.if.i10596

B496.if.i10596:                                   ; preds = %B496.if.i10596, %B496.if.lr.ph.i10592
  %.1061.01138.i10597 = phi i64 [ 0, %B496.if.lr.ph.i10592 ], [ %.1130.i10598, %B496.if.i10596 ]
  %.1130.i10598 = add nsw i64 %.1061.01138.i10597, 1
  %263 = getelementptr double, ptr %262, i64 %.1061.01138.i10597
  %.1205.i10599 = load double, ptr %263, align 8, !noalias !175
  %.1207.i10600 = mul nsw i64 %.1061.01138.i10597, %arg.shape.0
  %gep10941 = getelementptr double, ptr %invariant.gep10940, i64 %.1207.i10600
  store double %.1205.i10599, ptr %gep10941, align 8, !noalias !175
  %exitcond1143.not.i10605 = icmp eq i64 %.1130.i10598, %arg.shape.1
  br i1 %exitcond1143.not.i10605, label %B580.if.i10606, label %B496.if.i10596

B580.if.i10606:                                   ; preds = %B496.if.i10596, %B402.endif.i10590
  %invariant.gep.i10607 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5305.010848
  store double 0.000000e+00, ptr %invariant.gep.i10607, align 8, !noalias !175
  %gep.1.i10608 = getelementptr double, ptr %invariant.gep.i10607, i64 %arg.batch.4.0.5.1
  store double 0.000000e+00, ptr %gep.1.i10608, align 8, !noalias !175
  %gep.2.i10610 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.2.idx.i10609
  store double 0.000000e+00, ptr %gep.2.i10610, align 8, !noalias !175
  %gep.3.i10612 = getelementptr i8, ptr %invariant.gep.i10607, i64 %.idx.i10532
  store double 0.000000e+00, ptr %gep.3.i10612, align 8, !noalias !175
  %gep.4.i10614 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.4.idx.i10613
  store double 0.000000e+00, ptr %gep.4.i10614, align 8, !noalias !175
  %gep.5.i10616 = getelementptr i8, ptr %invariant.gep.i10607, i64 %.idx10249
  store double 0.000000e+00, ptr %gep.5.i10616, align 8, !noalias !175
  %gep.6.i10618 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.6.idx.i10617
  store double 0.000000e+00, ptr %gep.6.i10618, align 8, !noalias !175
  %gep.7.i10620 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.7.idx.i10619
  store double 0.000000e+00, ptr %gep.7.i10620, align 8, !noalias !175
  %gep.8.i10622 = getelementptr i8, ptr %invariant.gep.i10607, i64 %.502.idx
  store double 0.000000e+00, ptr %gep.8.i10622, align 8, !noalias !175
  %gep.9.i10624 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.9.idx.i10623
  store double 0.000000e+00, ptr %gep.9.i10624, align 8, !noalias !175
  %gep.10.i10626 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.10.idx.i10625
  store double 0.000000e+00, ptr %gep.10.i10626, align 8, !noalias !175
  %gep.11.i10628 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.11.idx.i10627
  store double 0.000000e+00, ptr %gep.11.i10628, align 8, !noalias !175
  %gep.12.i10630 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.12.idx.i10629
  store double 0.000000e+00, ptr %gep.12.i10630, align 8, !noalias !175
  %gep.13.i10632 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.13.idx.i10631
  store double 0.000000e+00, ptr %gep.13.i10632, align 8, !noalias !175
  %gep.14.i10634 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.14.idx.i10633
  store double 0.000000e+00, ptr %gep.14.i10634, align 8, !noalias !175
  %gep.15.i10636 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.15.idx.i10635
  store double 0.000000e+00, ptr %gep.15.i10636, align 8, !noalias !175
  %gep.16.i10638 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.16.idx.i10637
  store double 0.000000e+00, ptr %gep.16.i10638, align 8, !noalias !175
  %gep.17.i10640 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.17.idx.i10639
  store double 0.000000e+00, ptr %gep.17.i10640, align 8, !noalias !175
  %gep.18.i10642 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.18.idx.i10641
  store double 0.000000e+00, ptr %gep.18.i10642, align 8, !noalias !175
  %gep.19.i10644 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.19.idx.i10643
  store double 0.000000e+00, ptr %gep.19.i10644, align 8, !noalias !175
  %gep.20.i10646 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.20.idx.i10645
  store double 0.000000e+00, ptr %gep.20.i10646, align 8, !noalias !175
  %gep.21.i10648 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.21.idx.i10647
  store double 0.000000e+00, ptr %gep.21.i10648, align 8, !noalias !175
  %gep.22.i10650 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.22.idx.i10649
  store double 0.000000e+00, ptr %gep.22.i10650, align 8, !noalias !175
  %gep.23.i10652 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.23.idx.i10651
  store double 0.000000e+00, ptr %gep.23.i10652, align 8, !noalias !175
  %gep.24.i10654 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.24.idx.i10653
  store double 0.000000e+00, ptr %gep.24.i10654, align 8, !noalias !175
  %gep.25.i10656 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.25.idx.i10655
  store double 0.000000e+00, ptr %gep.25.i10656, align 8, !noalias !175
  %gep.26.i10658 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.26.idx.i10657
  store double 0.000000e+00, ptr %gep.26.i10658, align 8, !noalias !175
  %gep.27.i10660 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.27.idx.i10659
  store double 0.000000e+00, ptr %gep.27.i10660, align 8, !noalias !175
  %gep.28.i10662 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.28.idx.i10661
  store double 0.000000e+00, ptr %gep.28.i10662, align 8, !noalias !175
  %gep.29.i10664 = getelementptr i8, ptr %invariant.gep.i10607, i64 %gep.29.idx.i10663
  store double 0.000000e+00, ptr %gep.29.i10664, align 8, !noalias !175
  %.1455.i10665 = load double, ptr %arg.batch.2.4, align 8, !noalias !175
  %.1516.i10666 = load i64, ptr %.595.i10551, align 8, !noalias !175
  %.1531.i10667 = icmp slt i64 %.1516.i10666, 0
  %.1532.i10668 = select i1 %.1531.i10667, i64 %arg.batch.1.2.5.0, i64 0
  %264 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i10666
  %.1546.i10669 = getelementptr double, ptr %264, i64 %.1532.i10668
  %.1547.i10670 = load double, ptr %.1546.i10669, align 8, !noalias !175
  store double %.1455.i10665, ptr %invariant.gep.i10607, align 8, !noalias !175
  %.1656.i10673 = getelementptr double, ptr %104, i64 %.5305.010848
  store double %.1547.i10670, ptr %.1656.i10673, align 8, !noalias !175
  store double 1.000000e+00, ptr %.293.i10533, align 8, !noalias !175
  %.1767.i10675 = getelementptr double, ptr %105, i64 %.5305.010848
  store double 0xFFF0000000000000, ptr %.1767.i10675, align 8, !noalias !175
  %.1822.i10677 = getelementptr double, ptr %106, i64 %.5305.010848
  store double 0x7FF0000000000000, ptr %.1822.i10677, align 8, !noalias !175
  %.1877.i10679 = getelementptr double, ptr %107, i64 %.5305.010848
  %.1878.i10680 = load double, ptr %.1877.i10679, align 8, !noalias !175
  %.1880.i10681 = fcmp ueq double %.1878.i10680, 0xFFF0000000000000
  br i1 %.1880.i10681, label %B4306, label %B888.i10682

B4098:                                            ; preds = %B3956
  %.6191 = getelementptr double, ptr %108, i64 %.5305.010848
  %.6192 = load double, ptr %.6191, align 8
  %.6194 = fcmp ult double %.6192, 1.500000e+01
  br i1 %.6194, label %B4306, label %B4146

B4146:                                            ; preds = %B4098
  %.6238 = load double, ptr %.6237, align 8
  %.6292 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5305.010848
  %.6293 = load double, ptr %.6292, align 8
  %.6294 = fsub double %.6238, %.6293
  %.6348 = getelementptr double, ptr %111, i64 %.5305.010848
  %.6349 = load double, ptr %.6348, align 8
  %.6351 = fmul double %.6349, 5.000000e+03
  %.6352 = fcmp ogt double %.6294, %.6351
  br i1 %.6352, label %B4306, label %B4282

B4282:                                            ; preds = %B4146
  store double 0.000000e+00, ptr %.6191, align 8
  br label %B4306

B4306:                                            ; preds = %B888.i10682, %B3990, %B580.if.i10606, %B4146, %B4282, %B4098
  %budget.7.4 = phi i64 [ %budget.5.210850, %B4098 ], [ 0, %B4146 ], [ %budget.5.210850, %B4282 ], [ %budget.5.210850, %B580.if.i10606 ], [ %budget.5.210850, %B3990 ], [ %budget.5.210850, %B888.i10682 ]
  %.6480 = load i64, ptr %.5466, align 8
  %.6481 = icmp sgt i64 %.6480, -1
  br i1 %.6481, label %B4344, label %B4601

B4344:                                            ; preds = %B4306
  %.6486 = add nsw i64 %active.5.210851, 1
  %.6595 = mul i64 %.6480, %arg.batch.3.3.5.1
  %.6599 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.6595
  %.6600 = load i64, ptr %.6599, align 8
  %.6611.0 = and i64 %.6600, 127
  %.6641 = sub nsw i64 128, %.6611.0
  %.11.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.6641, i64 %.5603)
  %.6729 = getelementptr double, ptr %112, i64 %.5305.010848
  %.6730 = load double, ptr %.6729, align 8
  %.6732 = fcmp ogt double %.6730, 0.000000e+00
  %.6743 = sitofp i64 %.11.i to double
  %"$phi4514.1.2.5" = select i1 %.6732, double 1.000000e+00, double %.6743
  %.6806 = getelementptr double, ptr %113, i64 %.5305.010848
  store double %"$phi4514.1.2.5", ptr %.6806, align 8
  %.111.i8192 = getelementptr i64, ptr %114, i64 %.5305.010848
  %.112.i8193 = load i64, ptr %.111.i8192, align 8, !noalias !182
  %.169.i8242 = getelementptr double, ptr %115, i64 %.5305.010848
  %.170.i8243 = load double, ptr %.169.i8242, align 8, !noalias !182
  %.224.i8291 = getelementptr double, ptr %116, i64 %.5305.010848
  store double %.170.i8243, ptr %.224.i8291, align 8, !noalias !182
  %.237.i8299 = icmp slt i64 %.112.i8193, %arg.batch.2.5.0
  br i1 %.237.i8299, label %B134.i, label %B4601

B134.i:                                           ; preds = %B4344
  %.253.i8314 = icmp slt i64 %.112.i8193, 0
  %.254.i8315 = select i1 %.253.i8314, i64 %arg.batch.2.5.0, i64 0
  %265 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i8193
  %.268.i8329 = getelementptr double, ptr %265, i64 %.254.i8315
  %.269.i8330 = load double, ptr %.268.i8329, align 8, !noalias !182
  %.328.i8381 = load double, ptr %.169.i8242, align 8, !noalias !182
  %.10.i.i8388 = fcmp olt double %.328.i8381, %.269.i8330
  %.11.i.i8389 = select i1 %.10.i.i8388, double %.328.i8381, double %.269.i8330
  store double %.11.i.i8389, ptr %.224.i8291, align 8, !noalias !182
  br label %B4601

B4574:                                            ; preds = %B4601, %B3598
  %budget.4.2 = phi i64 [ %.947, %B3598 ], [ %budget.6.3, %B4601 ]
  %active.8.2 = phi i64 [ %active.9.1.mux, %B3598 ], [ %active.6.3, %B4601 ]
  %.6884 = icmp sgt i64 %active.8.2, 0
  %.6903 = icmp sgt i64 %budget.4.2, 0
  %or.cond10343 = select i1 %.6884, i1 %.6903, i1 false
  br i1 %or.cond10343, label %B422, label %B4600

B4600:                                            ; preds = %B4574, %B394
  %active.10.0 = phi i64 [ %active.4.0.lcssa, %B394 ], [ %active.8.2, %B4574 ]
  br i1 %.603, label %B4600.endif, label %B80.if.i1839.lr.ph

B80.if.i1839.lr.ph:                               ; preds = %B4600
  %.idx = mul i64 %arg.batch.4.0.5.1, 176
  %266 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx
  %.idx10247 = mul i64 %arg.batch.4.0.5.1, 184
  %267 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10247
  %.697.i1608 = add nsw i64 %arg.shape.2, -1
  %.idx10248 = mul i64 %arg.batch.4.0.5.1, 160
  %268 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10248
  br label %B80.if.i1839

B126.i1261:                                       ; preds = %B80.if.i1839
  %.318.i1308 = getelementptr double, ptr %266, i64 %.105.i1115.010856
  %.319.i1309 = load double, ptr %.318.i1308, align 8, !noalias !186
  %.5.i.i1310 = fptosi double %.319.i1309 to i64
  %.397.i1361 = getelementptr double, ptr %267, i64 %.105.i1115.010856
  %.398.i1362 = load double, ptr %.397.i1361, align 8, !noalias !186
  %.5.i1.i1363 = fptosi double %.398.i1362 to i64
  %.472.i1411 = mul i64 %.258.i1254, %arg.batch.3.3.5.1
  %.476.i1415 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.472.i1411
  %.477.i1416 = load i64, ptr %.476.i1415, align 8, !noalias !186
  %.478.i1417 = add nsw i64 %.477.i1416, %.5.i.i1310
  store i64 %.478.i1417, ptr %.476.i1415, align 8, !noalias !186
  %.584.i1509 = getelementptr i8, ptr %.476.i1415, i64 24
  %.585.i1510 = load i64, ptr %.584.i1509, align 8, !noalias !186
  %.586.i1511 = add nsw i64 %.585.i1510, %.5.i1.i1363
  store i64 %.586.i1511, ptr %.584.i1509, align 8, !noalias !186
  %.694.i1605 = getelementptr i8, ptr %.476.i1415, i64 8
  %.695.i1606 = load i64, ptr %.694.i1605, align 8, !noalias !186
  %.698.i1609 = add nsw i64 %.5.i1.i1363, %.5.i.i1310
  %.699.i1610 = mul nsw i64 %.698.i1609, %.697.i1608
  %.700.i1611 = add nsw i64 %.699.i1610, %.5.i.i1310
  %.701.i1612 = add nsw i64 %.700.i1611, %.695.i1606
  store i64 %.701.i1612, ptr %.694.i1605, align 8, !noalias !186
  store double 0.000000e+00, ptr %.318.i1308, align 8, !noalias !186
  store double 0.000000e+00, ptr %.397.i1361, align 8, !noalias !186
  %.923.i1794 = getelementptr double, ptr %268, i64 %.105.i1115.010856
  %.924.i1795 = load double, ptr %.923.i1794, align 8, !noalias !186
  %.926.i1797 = sitofp i64 %.698.i1609 to double
  %.927.i1798 = fsub double %.924.i1795, %.926.i1797
  store double %.927.i1798, ptr %.923.i1794, align 8, !noalias !186
  br label %B502.i1258

B502.i1258:                                       ; preds = %B126.i1261, %B80.if.i1839
  %.163.i1189 = icmp sgt i64 %.108.i1116.010857, 1
  br i1 %.163.i1189, label %B80.if.i1839, label %B4600.endif

B80.if.i1839:                                     ; preds = %B80.if.i1839.lr.ph, %B502.i1258
  %.108.i1116.010857 = phi i64 [ %storemerge, %B80.if.i1839.lr.ph ], [ %.172.i1844, %B502.i1258 ]
  %.105.i1115.010856 = phi i64 [ 0, %B80.if.i1839.lr.ph ], [ %.176.i1847, %B502.i1258 ]
  %.172.i1844 = add nsw i64 %.108.i1116.010857, -1
  %.176.i1847 = add nsw i64 %.105.i1115.010856, 1
  %269 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i1115.010856
  %.258.i1254 = load i64, ptr %269, align 8, !noalias !186
  %.263.i1257 = icmp sgt i64 %.258.i1254, -1
  br i1 %.263.i1257, label %B126.i1261, label %B502.i1258

B4601:                                            ; preds = %B4344, %B134.i, %B4306, %B3640.if
  %budget.6.3 = phi i64 [ %budget.5.210850, %B3640.if ], [ %budget.7.4, %B4306 ], [ %budget.7.4, %B134.i ], [ %budget.7.4, %B4344 ]
  %active.6.3 = phi i64 [ %active.5.210851, %B3640.if ], [ %active.5.210851, %B4306 ], [ %.6486, %B134.i ], [ %.6486, %B4344 ]
  %.5368 = icmp sgt i64 %.5308.010849, 1
  br i1 %.5368, label %B3640.if, label %B4574

B254.if:                                          ; preds = %B254.if.lr.ph, %B340
  %active.4.010693 = phi i64 [ 0, %B254.if.lr.ph ], [ %.898, %B340 ]
  %.592.010692 = phi i64 [ %storemerge, %B254.if.lr.ph ], [ %.656, %B340 ]
  %.589.010691 = phi i64 [ 0, %B254.if.lr.ph ], [ %.660, %B340 ]
  %.656 = add nsw i64 %.592.010692, -1
  %.660 = add nsw i64 %.589.010691, 1
  %270 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.589.010691
  %.742 = load i64, ptr %270, align 8
  %.743 = icmp slt i64 %.742, 0
  br i1 %.743, label %B296, label %B340

B1380.if:                                         ; preds = %B1348, %B1604
  %.1971.010708 = phi i64 [ %.2040, %B1604 ], [ 1, %B1348 ]
  %.2040 = add i64 %.1971.010708, 1
  %271 = getelementptr i64, ptr %arg.code.4, i64 %.1971.010708
  %272 = getelementptr i8, ptr %271, i64 112
  %.2099 = load i64, ptr %272, align 8
  %.2144 = inttoptr i64 %.2099 to ptr
  tail call void %.2144(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.2175 = load i64, ptr %arg.code.4, align 8
  %.2181 = mul nsw i64 %.2040, %.394
  %.2225 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2181
  %.2226 = inttoptr i64 %.2175 to ptr
  tail call void %.2226(ptr %.502, ptr %.2200, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.2225)
  br i1 %.541, label %B1568, label %B1604

B1748.if:                                         ; preds = %B1606, %B1834
  %looked.4.210714 = phi i1 [ %"$phi1834.1.2.2", %B1834 ], [ %spec.select10344, %B1606 ]
  %good.2.110713 = phi i1 [ %"$phi1792.1.2.2", %B1834 ], [ false, %B1606 ]
  %.2428.010712 = phi i64 [ %.2490, %B1834 ], [ %storemerge, %B1606 ]
  %.2425.010711 = phi i64 [ %.2494, %B1834 ], [ 0, %B1606 ]
  %.2490 = add nsw i64 %.2428.010712, -1
  %.2494 = add nsw i64 %.2425.010711, 1
  br i1 %good.2.110713, label %B1792, label %B1756

B1908.if:                                         ; preds = %B1908.preheader, %B2414
  %doubted.3.210724 = phi i1 [ %doubted.4.3, %B2414 ], [ false, %B1908.preheader ]
  %within.3.210723 = phi i1 [ %within.4.3, %B2414 ], [ false, %B1908.preheader ]
  %.2783.010722 = phi i64 [ %.2851, %B2414 ], [ %storemerge, %B1908.preheader ]
  %.2780.010721 = phi i64 [ %.2855, %B2414 ], [ 0, %B1908.preheader ]
  %.2851 = add nsw i64 %.2783.010722, -1
  %.2855 = add nsw i64 %.2780.010721, 1
  %.2940 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2780.010721
  %.2941 = load i64, ptr %.2940, align 8
  %.2995 = getelementptr i64, ptr %36, i64 %.2780.010721
  %.2996 = load i64, ptr %.2995, align 8
  %.3056 = getelementptr double, ptr %37, i64 %.2780.010721
  store double 0.000000e+00, ptr %.3056, align 8
  %.3059 = icmp sgt i64 %.2941, -1
  br i1 %.3059, label %B2008, label %B2414

B46.i:                                            ; preds = %B2046
  %.120.i1947 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i1916
  %.121.i1948 = load i64, ptr %.120.i1947, align 8, !noalias !53
  %.122.i1949 = icmp eq i64 %.121.i1948, 0
  br i1 %.122.i1949, label %B80.i1953, label %B2146

B80.i1953:                                        ; preds = %B46.i
  store i64 %.5.i, ptr %.120.i1947, align 8, !noalias !53
  br label %B2146

B2800.if:                                         ; preds = %B2752
  %.4211 = load i64, ptr %117, align 8
  %.4256 = inttoptr i64 %.4211 to ptr
  tail call void %.4256(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4287 = load i64, ptr %arg.code.4, align 8
  %.4337 = inttoptr i64 %.4287 to ptr
  tail call void %.4337(ptr %.502, ptr %.4311, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4336)
  %.4211.1 = load i64, ptr %118, align 8
  %.4256.1 = inttoptr i64 %.4211.1 to ptr
  tail call void %.4256.1(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4287.1 = load i64, ptr %arg.code.4, align 8
  %.4337.1 = inttoptr i64 %.4287.1 to ptr
  tail call void %.4337.1(ptr %.502, ptr %.4311, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4336.1)
  %.4211.2 = load i64, ptr %119, align 8
  %.4256.2 = inttoptr i64 %.4211.2 to ptr
  tail call void %.4256.2(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4287.2 = load i64, ptr %arg.code.4, align 8
  %.4337.2 = inttoptr i64 %.4287.2 to ptr
  tail call void %.4337.2(ptr %.502, ptr %.4311, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4336.2)
  %.4375 = load i64, ptr %.4374, align 8
  %.4420 = inttoptr i64 %.4375 to ptr
  tail call void %.4420(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4452 = load i64, ptr %.4451, align 8
  %.4497 = inttoptr i64 %.4452 to ptr
  tail call void %.4497(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.603, label %B3168, label %B64.if.i5797

B3172.endif.endif:                                ; preds = %B806.if.i3485, %B806.i3389.preheader
  br i1 %some.2.i3174.1.lcssa, label %B3210, label %B3252

B3640.if:                                         ; preds = %B3598, %B4601
  %active.5.210851 = phi i64 [ %active.6.3, %B4601 ], [ 0, %B3598 ]
  %budget.5.210850 = phi i64 [ %budget.6.3, %B4601 ], [ %.947, %B3598 ]
  %.5308.010849 = phi i64 [ %.5377, %B4601 ], [ %storemerge, %B3598 ]
  %.5305.010848 = phi i64 [ %.5381, %B4601 ], [ 0, %B3598 ]
  %.5377 = add nsw i64 %.5308.010849, -1
  %.5381 = add nsw i64 %.5305.010848, 1
  %.5466 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5305.010848
  %.5467 = load i64, ptr %.5466, align 8
  %.5472 = icmp slt i64 %.5467, 0
  br i1 %.5472, label %B4601, label %B3688

B4600.endif:                                      ; preds = %B502.i1258, %B4600
  store i64 %active.10.0, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64)

define dso_local noundef i32 @ask(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.role, i64 %arg.n, i64 %arg.locked.0, i64 %arg.locked.1, ptr readnone %arg.given.0.0, ptr readnone %arg.given.0.1, i64 %arg.given.0.2, i64 %arg.given.0.3, ptr readonly %arg.given.0.4, i64 %arg.given.0.5.0, i64 %arg.given.0.6.0, ptr readnone %arg.given.1.0, ptr readnone %arg.given.1.1, i64 %arg.given.1.2, i64 %arg.given.1.3, ptr readonly %arg.given.1.4, i64 %arg.given.1.5.0, i64 %arg.given.1.6.0, ptr readnone %arg.given.2.0, ptr readnone %arg.given.2.1, i64 %arg.given.2.2, i64 %arg.given.2.3, ptr %arg.given.2.4, i64 %arg.given.2.5.0, i64 %arg.given.2.6.0, ptr readnone %arg.given.3.0, ptr readnone %arg.given.3.1, i64 %arg.given.3.2, i64 %arg.given.3.3, ptr %arg.given.3.4, i64 %arg.given.3.5.0, i64 %arg.given.3.6.0, ptr readnone %arg.pieces.0.0, ptr readnone %arg.pieces.0.1, i64 %arg.pieces.0.2, i64 %arg.pieces.0.3, ptr readonly %arg.pieces.0.4, i64 %arg.pieces.0.5.0, i64 %arg.pieces.0.6.0, ptr readnone %arg.pieces.1.0, ptr readnone %arg.pieces.1.1, i64 %arg.pieces.1.2, i64 %arg.pieces.1.3, ptr readonly %arg.pieces.1.4, i64 %arg.pieces.1.5.0, i64 %arg.pieces.1.5.1, i64 %arg.pieces.1.6.0, i64 %arg.pieces.1.6.1, ptr readnone %arg.arrays.0.0, ptr readnone %arg.arrays.0.1, i64 %arg.arrays.0.2, i64 %arg.arrays.0.3, ptr %arg.arrays.0.4, i64 %arg.arrays.0.5.0, i64 %arg.arrays.0.6.0, ptr readnone %arg.arrays.1.0, ptr readnone %arg.arrays.1.1, i64 %arg.arrays.1.2, i64 %arg.arrays.1.3, ptr %arg.arrays.1.4, i64 %arg.arrays.1.5.0, i64 %arg.arrays.1.6.0, ptr readnone %arg.arrays.2.0, ptr readnone %arg.arrays.2.1, i64 %arg.arrays.2.2, i64 %arg.arrays.2.3, ptr %arg.arrays.2.4, i64 %arg.arrays.2.5.0, i64 %arg.arrays.2.6.0, ptr readnone %arg.arrays.3.0, ptr readnone %arg.arrays.3.1, i64 %arg.arrays.3.2, i64 %arg.arrays.3.3, ptr %arg.arrays.3.4, i64 %arg.arrays.3.5.0, i64 %arg.arrays.3.6.0, ptr readnone %arg.out.0, ptr readnone %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.5.1, i64 %arg.out.6.0, i64 %arg.out.6.1) local_unnamed_addr {
entry:
  %.281834.not = icmp slt i64 %arg.given.0.5.0, 1
  br i1 %.281834.not, label %B794, label %B118.if.lr.ph

B118.if.lr.ph:                                    ; preds = %entry
  %.548826.not = icmp slt i64 %arg.pieces.0.5.0, 1
  %.735 = getelementptr i8, ptr %arg.code.4, i64 8
  %.788 = icmp eq i64 %arg.role, 0
  %.791 = icmp sgt i64 %arg.locked.1, 0
  %or.cond = select i1 %.788, i1 %.791, i1 false
  %.821 = getelementptr i8, ptr %arg.code.4, i64 40
  %.1085 = getelementptr i8, ptr %arg.code.4, i64 8
  %.1151 = icmp slt i64 %arg.role, 0
  %.1152 = select i1 %.1151, i64 %arg.code.5.0, i64 0
  %0 = getelementptr i64, ptr %arg.code.4, i64 %arg.role
  %.1166 = getelementptr i64, ptr %0, i64 %.1152
  %.1309831.not = icmp slt i64 %arg.out.5.1, 1
  %.1351 = icmp eq i64 %arg.role, 3
  %"$phi776.2.2.2.in.v" = select i1 %.1351, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4
  br label %B118.if

B116.loopexit:                                    ; preds = %B720.if, %B604
  %exitcond840.not = icmp eq i64 %.294, %arg.given.0.5.0
  br i1 %exitcond840.not, label %B794, label %B118.if

B168:                                             ; preds = %B118.if
  br i1 %.548826.not, label %B284, label %B240.if.lr.ph

B240.if.lr.ph:                                    ; preds = %B168
  %.609 = icmp slt i64 %.417, 0
  %.610 = select i1 %.609, i64 %arg.pieces.1.5.0, i64 0
  %.611 = add i64 %.610, %.417
  %.631 = mul i64 %.611, %arg.pieces.1.5.1
  %1 = getelementptr double, ptr %arg.pieces.1.4, i64 %.631
  br label %B240.if

B284:                                             ; preds = %B240.if, %B168
  %.736 = load i64, ptr %.735, align 8
  %.739 = mul nsw i64 %.222.0835, %arg.n
  %.758 = getelementptr double, ptr %arg.given.3.4, i64 %.739
  %.784 = inttoptr i64 %.736 to ptr
  tail call void %.784(ptr nonnull %arg.given.2.4, ptr %.758, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.2.4)
  br label %B358

B358:                                             ; preds = %B284, %B118.if
  %piece.3.1 = phi i64 [ %.417, %B284 ], [ %piece.2.0837, %B118.if ]
  br i1 %or.cond, label %B392, label %B604

B392:                                             ; preds = %B358
  %.822 = load i64, ptr %.821, align 8
  %.825 = mul nsw i64 %.222.0835, %arg.n
  %.844 = getelementptr double, ptr %arg.given.3.4, i64 %.825
  %.870 = inttoptr i64 %.822 to ptr
  tail call void %.870(ptr nonnull %arg.given.2.4, ptr %.844, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4)
  br label %B496.if

B530:                                             ; preds = %B496.if
  %.1086 = load i64, ptr %.1085, align 8
  %.1134 = inttoptr i64 %.1086 to ptr
  tail call void %.1134(ptr nonnull %arg.given.2.4, ptr %.844, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.2.4)
  br label %B604

B604:                                             ; preds = %B530, %B358
  %.1167 = load i64, ptr %.1166, align 8
  %.1170 = mul nsw i64 %.222.0835, %arg.n
  %.1189 = getelementptr double, ptr %arg.given.3.4, i64 %.1170
  %.1215 = inttoptr i64 %.1167 to ptr
  tail call void %.1215(ptr nonnull %arg.given.2.4, ptr %.1189, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4)
  br i1 %.1309831.not, label %B116.loopexit, label %B720.if.lr.ph

B720.if.lr.ph:                                    ; preds = %B604
  %.1471 = mul i64 %.222.0835, %arg.out.5.1
  %2 = getelementptr double, ptr %arg.out.4, i64 %.1471
  br label %B720.if

B794:                                             ; preds = %B116.loopexit, %entry
  store ptr null, ptr %retptr, align 8
  ret i32 0

B118.if:                                          ; preds = %B118.if.lr.ph, %B116.loopexit
  %piece.2.0837 = phi i64 [ -1, %B118.if.lr.ph ], [ %piece.3.1, %B116.loopexit ]
  %.222.0835 = phi i64 [ 0, %B118.if.lr.ph ], [ %.294, %B116.loopexit ]
  %.294 = add nsw i64 %.222.0835, 1
  %3 = getelementptr double, ptr %arg.given.0.4, i64 %.222.0835
  %.356 = load double, ptr %3, align 8
  store double %.356, ptr %arg.given.2.4, align 8
  %4 = getelementptr i64, ptr %arg.given.1.4, i64 %.222.0835
  %.417 = load i64, ptr %4, align 8
  %.419.not = icmp eq i64 %.417, %piece.2.0837
  br i1 %.419.not, label %B358, label %B168

B240.if:                                          ; preds = %B240.if.lr.ph, %B240.if
  %.492.0827 = phi i64 [ 0, %B240.if.lr.ph ], [ %.561, %B240.if ]
  %.561 = add nsw i64 %.492.0827, 1
  %5 = getelementptr double, ptr %1, i64 %.492.0827
  %.636 = load double, ptr %5, align 8
  %6 = getelementptr i64, ptr %arg.pieces.0.4, i64 %.492.0827
  %.666 = load i64, ptr %6, align 8
  %.680 = icmp slt i64 %.666, 0
  %.681 = select i1 %.680, i64 %arg.arrays.0.5.0, i64 0
  %7 = getelementptr double, ptr %arg.arrays.0.4, i64 %.666
  %.695 = getelementptr double, ptr %7, i64 %.681
  store double %.636, ptr %.695, align 8
  %exitcond.not = icmp eq i64 %arg.pieces.0.5.0, %.561
  br i1 %exitcond.not, label %B284, label %B240.if

B496.if:                                          ; preds = %B392, %B496.if
  %.896.0829 = phi i64 [ 0, %B392 ], [ %.965, %B496.if ]
  %.965 = add nsw i64 %.896.0829, 1
  %8 = getelementptr double, ptr %arg.arrays.3.4, i64 %.896.0829
  %.1019 = load double, ptr %8, align 8
  %.1021 = add nsw i64 %.896.0829, %arg.locked.0
  %.1035 = icmp slt i64 %.1021, 0
  %.1036 = select i1 %.1035, i64 %arg.arrays.0.5.0, i64 0
  %9 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1021
  %.1050 = getelementptr double, ptr %9, i64 %.1036
  store double %.1019, ptr %.1050, align 8
  %exitcond838.not = icmp eq i64 %.965, %arg.locked.1
  br i1 %exitcond838.not, label %B530, label %B496.if

B720.if:                                          ; preds = %B720.if.lr.ph, %B720.if
  %.1253.0832 = phi i64 [ 0, %B720.if.lr.ph ], [ %.1322, %B720.if ]
  %.1322 = add nsw i64 %.1253.0832, 1
  %"$phi776.2.2.2.in" = getelementptr double, ptr %"$phi776.2.2.2.in.v", i64 %.1253.0832
  %"$phi776.2.2.2" = load double, ptr %"$phi776.2.2.2.in", align 8
  %10 = getelementptr double, ptr %2, i64 %.1253.0832
  store double %"$phi776.2.2.2", ptr %10, align 8
  %exitcond839.not = icmp eq i64 %arg.out.5.1, %.1322
  br i1 %exitcond839.not, label %B116.loopexit, label %B720.if
}


!0 = !{!1}
!1 = distinct !{!1, !2, !"_ZN12clpt_control6native9for_numba4takeB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN12clpt_control6native9for_numba4takeB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!3 = !{!4, !6, !1}
!4 = distinct !{!4, !5, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!5 = distinct !{!5, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!6 = distinct !{!6, !5, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!7 = !{!8, !10}
!8 = distinct !{!8, !9, !"_ZN12clpt_control6native9for_numba6decideB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!9 = distinct !{!9, !"_ZN12clpt_control6native9for_numba6decideB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!10 = distinct !{!10, !9, !"_ZN12clpt_control6native9for_numba6decideB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!11 = !{!12, !14}
!12 = distinct !{!12, !13, !"_ZN12clpt_control6native9for_numba5beginB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExb5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!13 = distinct !{!13, !"_ZN12clpt_control6native9for_numba5beginB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExb5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!14 = distinct !{!14, !13, !"_ZN12clpt_control6native9for_numba5beginB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExb5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!15 = !{!16, !12, !14}
!16 = distinct !{!16, !17, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!17 = distinct !{!17, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!18 = !{!19, !12, !14}
!19 = distinct !{!19, !20, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!20 = distinct !{!20, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!21 = !{!22, !24, !12, !14}
!22 = distinct !{!22, !23, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!23 = distinct !{!23, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!24 = distinct !{!24, !23, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!25 = !{!"branch_weights", i32 99, i32 1}
!26 = !{!27, !29, !30}
!27 = distinct !{!27, !28, !"_ZN12clpt_control6native9for_numba13differentiateB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!28 = distinct !{!28, !"_ZN12clpt_control6native9for_numba13differentiateB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!29 = distinct !{!29, !28, !"_ZN12clpt_control6native9for_numba13differentiateB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!30 = distinct !{!30, !31, !"_ZN12clpt_control6native9for_numba9lineariseB3v10B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!31 = distinct !{!31, !"_ZN12clpt_control6native9for_numba9lineariseB3v10B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!32 = !{!"branch_weights", i32 1, i32 99}
!33 = !{!34, !36, !27, !29, !30}
!34 = distinct !{!34, !35, !"_ZN12clpt_control6native9for_numba14by_differencesB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!35 = distinct !{!35, !"_ZN12clpt_control6native9for_numba14by_differencesB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!36 = distinct !{!36, !35, !"_ZN12clpt_control6native9for_numba14by_differencesB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!37 = !{!"branch_weights", i32 199, i32 9801}
!38 = !{!30}
!39 = !{!40, !30}
!40 = distinct !{!40, !41, !"_ZN12clpt_control6native16linear_equations6factorB3v16B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!41 = distinct !{!41, !"_ZN12clpt_control6native16linear_equations6factorB3v16B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!42 = !{!43}
!43 = distinct !{!43, !44, !"_ZN12clpt_control6native9for_numba11solve_stageB3v17B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!44 = distinct !{!44, !"_ZN12clpt_control6native9for_numba11solve_stageB3v17B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!45 = !{!46, !48, !43}
!46 = distinct !{!46, !47, !"_ZN12clpt_control6native16linear_equations5solveB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!47 = distinct !{!47, !"_ZN12clpt_control6native16linear_equations5solveB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!48 = distinct !{!48, !47, !"_ZN12clpt_control6native16linear_equations5solveB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!49 = !{!50, !52}
!50 = distinct !{!50, !51, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!51 = distinct !{!51, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!52 = distinct !{!52, !51, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!53 = !{!54}
!54 = distinct !{!54, !55, !"_ZN12clpt_control6native9for_numba4failB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!55 = distinct !{!55, !"_ZN12clpt_control6native9for_numba4failB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!56 = !{!57, !59}
!57 = distinct !{!57, !58, !"_ZN12clpt_control6native9for_numba6passesB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!58 = distinct !{!58, !"_ZN12clpt_control6native9for_numba6passesB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!59 = distinct !{!59, !58, !"_ZN12clpt_control6native9for_numba6passesB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!60 = !{!61, !63, !57, !59}
!61 = distinct !{!61, !62, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!62 = distinct !{!62, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!63 = distinct !{!63, !62, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!64 = !{!65, !67, !57, !59}
!65 = distinct !{!65, !66, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!66 = distinct !{!66, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!67 = distinct !{!67, !66, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!68 = !{!69, !71, !65, !67, !57, !59}
!69 = distinct !{!69, !70, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!70 = distinct !{!70, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!71 = distinct !{!71, !70, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!72 = !{!73, !75}
!73 = distinct !{!73, !74, !"_ZN12clpt_control6native9for_numba5doubtB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!74 = distinct !{!74, !"_ZN12clpt_control6native9for_numba5doubtB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!75 = distinct !{!75, !74, !"_ZN12clpt_control6native9for_numba5doubtB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!76 = !{!77, !73, !75}
!77 = distinct !{!77, !78, !"_ZN12clpt_control6native9for_numba5againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!78 = distinct !{!78, !"_ZN12clpt_control6native9for_numba5againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!79 = !{!80, !82}
!80 = distinct !{!80, !81, !"_ZN12clpt_control6native9for_numba6passesB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!81 = distinct !{!81, !"_ZN12clpt_control6native9for_numba6passesB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!82 = distinct !{!82, !81, !"_ZN12clpt_control6native9for_numba6passesB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!83 = !{!84, !86, !80, !82}
!84 = distinct !{!84, !85, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!85 = distinct !{!85, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!86 = distinct !{!86, !85, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!87 = !{!88, !90, !80, !82}
!88 = distinct !{!88, !89, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!89 = distinct !{!89, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!90 = distinct !{!90, !89, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!91 = !{!92, !94, !88, !90, !80, !82}
!92 = distinct !{!92, !93, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!93 = distinct !{!93, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!94 = distinct !{!94, !93, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!95 = !{!96}
!96 = distinct !{!96, !97, !"_ZN12clpt_control6native9for_numba5crossB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!97 = distinct !{!97, !"_ZN12clpt_control6native9for_numba5crossB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!98 = !{!99, !101, !102, !104, !96}
!99 = distinct !{!99, !100, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!100 = distinct !{!100, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!101 = distinct !{!101, !100, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!102 = distinct !{!102, !103, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!103 = distinct !{!103, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!104 = distinct !{!104, !103, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!105 = !{!102, !104, !96}
!106 = !{!107, !109, !96}
!107 = distinct !{!107, !108, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!108 = distinct !{!108, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!109 = distinct !{!109, !108, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!110 = !{!111, !113, !96}
!111 = distinct !{!111, !112, !"_ZN12clpt_control6native9for_numba7unmovedB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!112 = distinct !{!112, !"_ZN12clpt_control6native9for_numba7unmovedB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!113 = distinct !{!113, !112, !"_ZN12clpt_control6native9for_numba7unmovedB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!114 = !{!115, !96}
!115 = distinct !{!115, !116, !"_ZN12clpt_control6native9for_numba5againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!116 = distinct !{!116, !"_ZN12clpt_control6native9for_numba5againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!117 = !{!118}
!118 = distinct !{!118, !119, !"_ZN12clpt_control6native9for_numba5watchB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!119 = distinct !{!119, !"_ZN12clpt_control6native9for_numba5watchB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!120 = !{!121, !118}
!121 = distinct !{!121, !122, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!122 = distinct !{!122, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!123 = !{!124, !126, !118}
!124 = distinct !{!124, !125, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!125 = distinct !{!125, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!126 = distinct !{!126, !125, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!127 = !{!128, !130, !124, !126, !118}
!128 = distinct !{!128, !129, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!129 = distinct !{!129, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!130 = distinct !{!130, !129, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!131 = !{!132}
!132 = distinct !{!132, !133, !"_ZN12clpt_control6native9for_numba6sampleB3v35B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!133 = distinct !{!133, !"_ZN12clpt_control6native9for_numba6sampleB3v35B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!134 = !{!135, !137, !132}
!135 = distinct !{!135, !136, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!136 = distinct !{!136, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!137 = distinct !{!137, !136, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!138 = !{!139, !141}
!139 = distinct !{!139, !140, !"_ZN12clpt_control6native9for_numba11decide_anewB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!140 = distinct !{!140, !"_ZN12clpt_control6native9for_numba11decide_anewB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!141 = distinct !{!141, !140, !"_ZN12clpt_control6native9for_numba11decide_anewB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!142 = !{!143, !139, !141}
!143 = distinct !{!143, !144, !"_ZN12clpt_control6native9for_numba4failB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29: %retptr"}
!144 = distinct !{!144, !"_ZN12clpt_control6native9for_numba4failB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29"}
!145 = !{!146, !148}
!146 = distinct !{!146, !147, !"_ZN12clpt_control6native9for_numba6at_endB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!147 = distinct !{!147, !"_ZN12clpt_control6native9for_numba6at_endB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!148 = distinct !{!148, !149, !"_ZN12clpt_control6native9for_numba4leapB3v38B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!149 = distinct !{!149, !"_ZN12clpt_control6native9for_numba4leapB3v38B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!150 = !{!148}
!151 = !{!152, !154, !148}
!152 = distinct !{!152, !153, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!153 = distinct !{!153, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!154 = distinct !{!154, !153, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!155 = !{!156, !148}
!156 = distinct !{!156, !157, !"_ZN12clpt_control6native9for_numba6at_endB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!157 = distinct !{!157, !"_ZN12clpt_control6native9for_numba6at_endB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!158 = !{!159, !148}
!159 = distinct !{!159, !160, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!160 = distinct !{!160, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!161 = !{!162, !148}
!162 = distinct !{!162, !163, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!163 = distinct !{!163, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!164 = !{!165}
!165 = distinct !{!165, !166, !"_ZN12clpt_control6native9for_numba4failB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29: %retptr"}
!166 = distinct !{!166, !"_ZN12clpt_control6native9for_numba4failB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29"}
!167 = !{!168, !170}
!168 = distinct !{!168, !169, !"_ZN12clpt_control6native9for_numba5enterB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!169 = distinct !{!169, !"_ZN12clpt_control6native9for_numba5enterB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!170 = distinct !{!170, !169, !"_ZN12clpt_control6native9for_numba5enterB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!171 = !{!172, !174, !168, !170}
!172 = distinct !{!172, !173, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!173 = distinct !{!173, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!174 = distinct !{!174, !173, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!175 = !{!176}
!176 = distinct !{!176, !177, !"_ZN12clpt_control6native9for_numba4takeB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!177 = distinct !{!177, !"_ZN12clpt_control6native9for_numba4takeB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!178 = !{!179, !181, !176}
!179 = distinct !{!179, !180, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!180 = distinct !{!180, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!181 = distinct !{!181, !180, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!182 = !{!183, !185}
!183 = distinct !{!183, !184, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!184 = distinct !{!184, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!185 = distinct !{!185, !184, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!186 = !{!187, !189}
!187 = distinct !{!187, !188, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!188 = distinct !{!188, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!189 = distinct !{!189, !188, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}

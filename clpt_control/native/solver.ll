; sha256 2e3a7098053b037dd04964b8097719d984926a702ca8fea9dfd56216df606db5

define dso_local noundef i32 @advance(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.shape.3, i64 %arg.shape.4, i64 %arg.shape.5, i64 %arg.shape.6, ptr readnone %arg.tolerances.0, ptr readnone %arg.tolerances.1, i64 %arg.tolerances.2, i64 %arg.tolerances.3, ptr %arg.tolerances.4, i64 %arg.tolerances.5.0, i64 %arg.tolerances.6.0, ptr readnone %arg.batch.0.0.0, ptr readnone %arg.batch.0.0.1, i64 %arg.batch.0.0.2, i64 %arg.batch.0.0.3, ptr readonly %arg.batch.0.0.4, i64 %arg.batch.0.0.5.0, i64 %arg.batch.0.0.5.1, i64 %arg.batch.0.0.6.0, i64 %arg.batch.0.0.6.1, ptr readnone %arg.batch.0.1.0, ptr readnone %arg.batch.0.1.1, i64 %arg.batch.0.1.2, i64 %arg.batch.0.1.3, ptr readonly %arg.batch.0.1.4, i64 %arg.batch.0.1.5.0, i64 %arg.batch.0.1.5.1, i64 %arg.batch.0.1.6.0, i64 %arg.batch.0.1.6.1, ptr readnone %arg.batch.0.2.0, ptr readnone %arg.batch.0.2.1, i64 %arg.batch.0.2.2, i64 %arg.batch.0.2.3, ptr readonly %arg.batch.0.2.4, i64 %arg.batch.0.2.5.0, i64 %arg.batch.0.2.6.0, ptr readnone %arg.batch.1.0.0, ptr readnone %arg.batch.1.0.1, i64 %arg.batch.1.0.2, i64 %arg.batch.1.0.3, ptr readonly %arg.batch.1.0.4, i64 %arg.batch.1.0.5.0, i64 %arg.batch.1.0.6.0, ptr readnone %arg.batch.1.1.0, ptr readnone %arg.batch.1.1.1, i64 %arg.batch.1.1.2, i64 %arg.batch.1.1.3, ptr readonly %arg.batch.1.1.4, i64 %arg.batch.1.1.5.0, i64 %arg.batch.1.1.6.0, ptr readnone %arg.batch.1.2.0, ptr readnone %arg.batch.1.2.1, i64 %arg.batch.1.2.2, i64 %arg.batch.1.2.3, ptr readonly %arg.batch.1.2.4, i64 %arg.batch.1.2.5.0, i64 %arg.batch.1.2.6.0, ptr readnone %arg.batch.1.3.0, ptr readnone %arg.batch.1.3.1, i64 %arg.batch.1.3.2, i64 %arg.batch.1.3.3, ptr readonly %arg.batch.1.3.4, i64 %arg.batch.1.3.5.0, i64 %arg.batch.1.3.5.1, i64 %arg.batch.1.3.6.0, i64 %arg.batch.1.3.6.1, ptr readnone %arg.batch.1.4.0, ptr readnone %arg.batch.1.4.1, i64 %arg.batch.1.4.2, i64 %arg.batch.1.4.3, ptr readonly %arg.batch.1.4.4, i64 %arg.batch.1.4.5.0, i64 %arg.batch.1.4.6.0, ptr readnone %arg.batch.2.0, ptr readnone %arg.batch.2.1, i64 %arg.batch.2.2, i64 %arg.batch.2.3, ptr readonly %arg.batch.2.4, i64 %arg.batch.2.5.0, i64 %arg.batch.2.6.0, ptr readnone %arg.batch.3.0.0, ptr readnone %arg.batch.3.0.1, i64 %arg.batch.3.0.2, i64 %arg.batch.3.0.3, ptr %arg.batch.3.0.4, i64 %arg.batch.3.0.5.0, i64 %arg.batch.3.0.5.1, i64 %arg.batch.3.0.5.2, i64 %arg.batch.3.0.6.0, i64 %arg.batch.3.0.6.1, i64 %arg.batch.3.0.6.2, ptr readnone %arg.batch.3.1.0, ptr readnone %arg.batch.3.1.1, i64 %arg.batch.3.1.2, i64 %arg.batch.3.1.3, ptr %arg.batch.3.1.4, i64 %arg.batch.3.1.5.0, i64 %arg.batch.3.1.6.0, ptr readnone %arg.batch.3.2.0, ptr readnone %arg.batch.3.2.1, i64 %arg.batch.3.2.2, i64 %arg.batch.3.2.3, ptr %arg.batch.3.2.4, i64 %arg.batch.3.2.5.0, i64 %arg.batch.3.2.6.0, ptr readnone %arg.batch.3.3.0, ptr readnone %arg.batch.3.3.1, i64 %arg.batch.3.3.2, i64 %arg.batch.3.3.3, ptr %arg.batch.3.3.4, i64 %arg.batch.3.3.5.0, i64 %arg.batch.3.3.5.1, i64 %arg.batch.3.3.6.0, i64 %arg.batch.3.3.6.1, ptr readnone %arg.batch.4.0.0, ptr readnone %arg.batch.4.0.1, i64 %arg.batch.4.0.2, i64 %arg.batch.4.0.3, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.0, i64 %arg.batch.4.0.5.1, i64 %arg.batch.4.0.6.0, i64 %arg.batch.4.0.6.1, ptr readnone %arg.batch.4.1.0, ptr readnone %arg.batch.4.1.1, i64 %arg.batch.4.1.2, i64 %arg.batch.4.1.3, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.0, i64 %arg.batch.4.1.5.1, i64 %arg.batch.4.1.6.0, i64 %arg.batch.4.1.6.1, ptr readnone %arg.batch.4.2.0, ptr readnone %arg.batch.4.2.1, i64 %arg.batch.4.2.2, i64 %arg.batch.4.2.3, ptr %arg.batch.4.2.4, i64 %arg.batch.4.2.5.0, i64 %arg.batch.4.2.6.0, ptr readnone %arg.batch.5.0.0, ptr readnone %arg.batch.5.0.1, i64 %arg.batch.5.0.2, i64 %arg.batch.5.0.3, ptr %arg.batch.5.0.4, i64 %arg.batch.5.0.5.0, i64 %arg.batch.5.0.6.0, ptr readnone %arg.batch.5.1.0, ptr readnone %arg.batch.5.1.1, i64 %arg.batch.5.1.2, i64 %arg.batch.5.1.3, ptr %arg.batch.5.1.4, i64 %arg.batch.5.1.5.0, i64 %arg.batch.5.1.6.0, ptr readnone %arg.batch.5.2.0, ptr readnone %arg.batch.5.2.1, i64 %arg.batch.5.2.2, i64 %arg.batch.5.2.3, ptr %arg.batch.5.2.4, i64 %arg.batch.5.2.5.0, i64 %arg.batch.5.2.6.0, ptr readnone %arg.batch.5.3.0, ptr readnone %arg.batch.5.3.1, i64 %arg.batch.5.3.2, i64 %arg.batch.5.3.3, ptr %arg.batch.5.3.4, i64 %arg.batch.5.3.5.0, i64 %arg.batch.5.3.6.0, ptr readnone %arg.batch.5.4.0, ptr readnone %arg.batch.5.4.1, i64 %arg.batch.5.4.2, i64 %arg.batch.5.4.3, ptr %arg.batch.5.4.4, i64 %arg.batch.5.4.5.0, i64 %arg.batch.5.4.6.0, ptr readnone %arg.linear.0.0, ptr readnone %arg.linear.0.1, i64 %arg.linear.0.2, i64 %arg.linear.0.3, ptr %arg.linear.0.4, i64 %arg.linear.0.5.0, i64 %arg.linear.0.6.0, ptr readnone %arg.linear.1.0, ptr readnone %arg.linear.1.1, i64 %arg.linear.1.2, i64 %arg.linear.1.3, ptr %arg.linear.1.4, i64 %arg.linear.1.5.0, i64 %arg.linear.1.6.0, ptr readnone %arg.linear.2.0, ptr readnone %arg.linear.2.1, i64 %arg.linear.2.2, i64 %arg.linear.2.3, ptr %arg.linear.2.4, i64 %arg.linear.2.5.0, i64 %arg.linear.2.6.0, i64 %arg.linear.3.0, i64 %arg.linear.3.1, i64 %arg.linear.3.2, ptr readnone %arg.linear.4.0, ptr readnone %arg.linear.4.1, i64 %arg.linear.4.2, i64 %arg.linear.4.3, ptr readonly %arg.linear.4.4, i64 %arg.linear.4.5.0, i64 %arg.linear.4.6.0, ptr readnone %arg.linear.5.0, ptr readnone %arg.linear.5.1, i64 %arg.linear.5.2, i64 %arg.linear.5.3, ptr readonly %arg.linear.5.4, i64 %arg.linear.5.5.0, i64 %arg.linear.5.6.0, ptr readnone %arg.linear.6.0, ptr readnone %arg.linear.6.1, i64 %arg.linear.6.2, i64 %arg.linear.6.3, ptr readonly %arg.linear.6.4, i64 %arg.linear.6.5.0, i64 %arg.linear.6.6.0, ptr readnone %arg.linear.7.0, ptr readnone %arg.linear.7.1, i64 %arg.linear.7.2, i64 %arg.linear.7.3, ptr readonly %arg.linear.7.4, i64 %arg.linear.7.5.0, i64 %arg.linear.7.6.0, ptr readnone %arg.linear.8.0, ptr readnone %arg.linear.8.1, i64 %arg.linear.8.2, i64 %arg.linear.8.3, ptr readonly %arg.linear.8.4, i64 %arg.linear.8.5.0, i64 %arg.linear.8.6.0, ptr readnone %arg.linear.9.0, ptr readnone %arg.linear.9.1, i64 %arg.linear.9.2, i64 %arg.linear.9.3, ptr readonly %arg.linear.9.4, i64 %arg.linear.9.5.0, i64 %arg.linear.9.6.0, i64 %arg.budget, i64 %arg.most) local_unnamed_addr {
entry:
  %.463 = mul i64 %arg.shape.1, %arg.shape.0
  %.571.idx = shl i64 %arg.batch.4.0.5.1, 6
  %.571 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.571.idx
  %.610 = icmp eq i64 %arg.shape.2, 9
  %.612.not = icmp ne i64 %arg.shape.2, 4
  %.614 = icmp ne i64 %arg.shape.2, 12
  %.665 = icmp slt i64 %arg.shape.0, 1
  %storemerge = select i1 %.665, i64 0, i64 %arg.shape.0
  br i1 %.665, label %B388, label %B248.if.lr.ph

B248.if.lr.ph:                                    ; preds = %entry
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
  %4 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i
  %5 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.15.idx.i
  %6 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.26.idx.i
  %.idx1130.i = mul i64 %arg.batch.4.0.5.1, 216
  %7 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i
  br label %B248.if

B290:                                             ; preds = %B248.if
  %.236.i = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !0
  %.293.i = getelementptr double, ptr %0, i64 %.651.010668
  store double 0.000000e+00, ptr %.293.i, align 8, !noalias !0
  %.324.i = load i64, ptr %.323.i, align 8, !noalias !0
  %.326.i = icmp eq i64 %.236.i, %.324.i
  br i1 %.326.i, label %B334, label %B132.i

B132.i:                                           ; preds = %B290
  %.359.i10396 = add nsw i64 %.236.i, 1
  store i64 %.359.i10396, ptr %arg.batch.4.2.4, align 8, !noalias !0
  store i64 1, ptr %.418.i, align 8, !noalias !0
  %.438.i = icmp slt i64 %.236.i, 0
  %.439.i = select i1 %.438.i, i64 %arg.batch.0.2.5.0, i64 0
  %8 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i
  %.453.i10397 = getelementptr i64, ptr %8, i64 %.439.i
  %.454.i10398 = load i64, ptr %.453.i10397, align 8, !noalias !0
  %.469.i = icmp slt i64 %.454.i10398, 0
  %.470.i = select i1 %.469.i, i64 %arg.batch.1.0.5.0, i64 0
  %9 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i10398
  %.484.i10399 = getelementptr i64, ptr %9, i64 %.470.i
  %.485.i = load i64, ptr %.484.i10399, align 8, !noalias !0
  %.540.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.651.010668
  store i64 %.236.i, ptr %.540.i, align 8, !noalias !0
  %.595.i = getelementptr i64, ptr %1, i64 %.651.010668
  store i64 %.485.i, ptr %.595.i, align 8, !noalias !0
  %.654.i = getelementptr i64, ptr %2, i64 %.651.010668
  store i64 1, ptr %.654.i, align 8, !noalias !0
  %.709.i = getelementptr i64, ptr %3, i64 %.651.010668
  store i64 0, ptr %.709.i, align 8, !noalias !0
  br i1 %.8051131.not.i, label %B402.i, label %B358.if.lr.ph.i

B358.if.lr.ph.i:                                  ; preds = %B132.i
  %.867.i = select i1 %.438.i, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i = add i64 %.867.i, %.236.i
  %.888.i = mul i64 %.868.i, %arg.batch.0.1.5.1
  %10 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i
  %invariant.gep10894 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.651.010668
  br label %B358.if.i

B402.i:                                           ; preds = %B358.if.i, %B132.i
  br i1 %.175.i1134.not.i, label %B402.endif.i, label %B76.if.i.lr.ph.i

B76.if.i.lr.ph.i:                                 ; preds = %B402.i
  %.990.i = load i64, ptr %.595.i, align 8, !noalias !0
  %.236.i.i = icmp slt i64 %.990.i, 0
  %.237.i.i10401 = select i1 %.236.i.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i = add i64 %.237.i.i10401, %.990.i
  %.258.i.i = mul i64 %.238.i.i, %arg.batch.1.3.5.1
  %11 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i
  br label %B76.if.i.i10402

B76.if.i.i10402:                                  ; preds = %B76.if.i.i10402, %B76.if.i.lr.ph.i
  %.117.i.01135.i = phi i64 [ 0, %B76.if.i.lr.ph.i ], [ %.188.i.i, %B76.if.i.i10402 ]
  %.188.i.i = add nsw i64 %.117.i.01135.i, 1
  %12 = getelementptr double, ptr %11, i64 %.117.i.01135.i
  %.263.i.i = load double, ptr %12, align 8, !noalias !3
  %13 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i
  %.293.i.i = load i64, ptr %13, align 8, !noalias !3
  %.295.i.i10403 = mul nsw i64 %.293.i.i, %arg.shape.0
  %.297.i.i = add nsw i64 %.295.i.i10403, %.651.010668
  %.311.i.i = icmp slt i64 %.297.i.i, 0
  %.312.i.i = select i1 %.311.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %14 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i
  %.326.i.i = getelementptr double, ptr %14, i64 %.312.i.i
  store double %.263.i.i, ptr %.326.i.i, align 8, !noalias !3
  %exitcond1142.not.i = icmp eq i64 %.188.i.i, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i, label %B402.endif.i, label %B76.if.i.i10402

B888.i:                                           ; preds = %B580.if.i
  store double 0.000000e+00, ptr %.1877.i, align 8, !noalias !0
  br label %B334

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

B402.endif.i:                                     ; preds = %B76.if.i.i10402, %B402.i
  br i1 %.11171137.not.i, label %B580.if.i, label %B496.if.lr.ph.i

B496.if.lr.ph.i:                                  ; preds = %B402.endif.i
  %.1179.i = select i1 %.438.i, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i = add i64 %.1179.i, %.236.i
  %.1200.i = mul i64 %.1180.i, %arg.batch.0.0.5.1
  %16 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i
  %invariant.gep10896 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.651.010668
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
  %invariant.gep.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.651.010668
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
  %gep.8.i = getelementptr i8, ptr %invariant.gep.i, i64 %.571.idx
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
  %.1455.i = load double, ptr %arg.batch.2.4, align 8, !noalias !0
  %.1516.i = load i64, ptr %.595.i, align 8, !noalias !0
  %.1531.i = icmp slt i64 %.1516.i, 0
  %.1532.i = select i1 %.1531.i, i64 %arg.batch.1.2.5.0, i64 0
  %18 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i
  %.1546.i = getelementptr double, ptr %18, i64 %.1532.i
  %.1547.i = load double, ptr %.1546.i, align 8, !noalias !0
  store double %.1455.i, ptr %invariant.gep.i, align 8, !noalias !0
  %.1656.i = getelementptr double, ptr %4, i64 %.651.010668
  store double %.1547.i, ptr %.1656.i, align 8, !noalias !0
  store double 1.000000e+00, ptr %.293.i, align 8, !noalias !0
  %.1767.i = getelementptr double, ptr %5, i64 %.651.010668
  store double 0xFFF0000000000000, ptr %.1767.i, align 8, !noalias !0
  %.1822.i = getelementptr double, ptr %6, i64 %.651.010668
  store double 0x7FF0000000000000, ptr %.1822.i, align 8, !noalias !0
  %.1877.i = getelementptr double, ptr %7, i64 %.651.010668
  %.1878.i = load double, ptr %.1877.i, align 8, !noalias !0
  %.1880.i = fcmp ueq double %.1878.i, 0xFFF0000000000000
  br i1 %.1880.i, label %B334, label %B888.i

B334:                                             ; preds = %B888.i, %B290, %B580.if.i, %B248.if
  %.942 = load i64, ptr %283, align 8
  %.943 = icmp sgt i64 %.942, -1
  %. = zext i1 %.943 to i64
  %.960 = add nsw i64 %active.4.010670, %.
  %.709 = icmp sgt i64 %.654.010669, 1
  br i1 %.709, label %B248.if, label %B388

B388:                                             ; preds = %B334, %entry
  %active.4.0.lcssa = phi i64 [ 0, %entry ], [ %.960, %B334 ]
  %.977.not = icmp ne i64 %active.4.0.lcssa, 0
  %.993 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.977.not, i1 %.993, i1 false
  br i1 %or.cond, label %B416.preheader, label %B4586

B416.preheader:                                   ; preds = %B388
  %.1037 = getelementptr i8, ptr %arg.batch.4.2.4, i64 16
  %factor.op.mul = mul i64 %arg.shape.1, 14
  %factor.op.mul10849 = mul i64 %arg.shape.1, 15
  %factor.op.mul10850 = shl i64 %arg.shape.1, 4
  %.1133 = getelementptr i8, ptr %arg.code.4, i64 8
  %.1185 = icmp sgt i64 %arg.shape.6, 0
  %.162.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx10371 = mul i64 %arg.batch.4.0.5.1, 24
  %19 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10371
  %.537.i10671 = icmp slt i64 %arg.shape.6, 1
  %.691.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.1246.not = icmp eq i64 %arg.shape.3, 0
  %.1276 = getelementptr i8, ptr %arg.code.4, i64 16
  %.1403.idx = shl i64 %.463, 4
  %.1403 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1403.idx
  %.1434 = getelementptr i8, ptr %arg.code.4, i64 72
  %.1510 = getelementptr i8, ptr %arg.code.4, i64 80
  %.1611.idx = mul i64 %.463, 136
  %.1611 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1611.idx
  %.1636.idx = mul i64 %.463, 24
  %.1636 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1636.idx
  %.1667 = getelementptr i8, ptr %arg.code.4, i64 88
  %.idx10363 = mul i64 %arg.batch.4.0.5.1, 24
  %20 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10363
  %.idx10364 = shl i64 %arg.batch.4.0.5.1, 5
  %21 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10364
  %.idx10365 = mul i64 %arg.batch.4.0.5.1, 232
  %22 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10365
  %.10372 = select i1 %.612.not, i64 2, i64 0
  %.idx10366 = mul i64 %arg.batch.4.0.5.1, 88
  %23 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10366
  %.idx10367 = shl i64 %arg.batch.4.0.5.1, 4
  %24 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10367
  %.idx10368 = shl i64 %arg.batch.4.1.5.1, 4
  %25 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10368
  %.idx10369 = shl i64 %arg.batch.4.0.5.1, 4
  %26 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10369
  %.idx10370 = mul i64 %arg.batch.4.0.5.1, 152
  %27 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10370
  %.1806 = getelementptr i8, ptr %arg.code.4, i64 56
  %.1931 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.463
  %.266.idx.i = shl i64 %arg.batch.4.0.5.1, 5
  %.266.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.266.idx.i
  %.317.i2117.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx2159.i = mul i64 %arg.shape.1, 136
  %.idx2160.i = mul i64 %arg.shape.1, 88
  %.547.i2141.i = icmp sgt i64 %arg.linear.6.5.0, 1
  %.493.i.12144.i = add nsw i64 %arg.linear.6.5.0, -2
  %.589.i.i = icmp sgt i64 %arg.linear.3.2, 0
  %28 = tail call i64 @llvm.smax.i64(i64 %arg.shape.1, i64 -1)
  %storemerge2107.i = add nsw i64 %28, 1
  %.682.i2120.i = icmp sgt i64 %arg.shape.1, -1
  %.842.i.i = getelementptr i8, ptr %arg.code.4, i64 48
  %.915.i.i = mul nsw i64 %arg.shape.1, 12
  %.933.i.idx.i = mul i64 %arg.shape.1, 136
  %.933.i.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.933.i.idx.i
  %.958.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.915.i.i
  %.150.i.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.510.i.i.i = icmp slt i64 %arg.shape.1, 0
  %.511.i.i.i = select i1 %.510.i.i.i, i64 %arg.linear.5.5.0, i64 0
  %29 = getelementptr i64, ptr %arg.linear.5.4, i64 %arg.shape.1
  %.525.i.i.i = getelementptr i64, ptr %29, i64 %.511.i.i.i
  %.586.i.i.idx.i = mul i64 %arg.batch.4.0.5.1, 48
  %.586.i.i.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.586.i.i.idx.i
  %.597.i.i.i = mul nsw i64 %arg.shape.1, 18
  %.615.i.i.i = select i1 %.510.i.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %.idx.i10409 = mul i64 %arg.shape.1, 152
  %30 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i10409
  %.629.i.i.i = getelementptr double, ptr %30, i64 %.615.i.i.i
  %.944.i.i.i = mul nsw i64 %arg.shape.1, 17
  %.1748.i.i = mul nsw i64 %arg.shape.1, 11
  %.idx2161.i = mul i64 %arg.shape.1, 144
  %invariant.gep = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx2161.i
  %.idx2162.i = mul i64 %arg.shape.1, 144
  %.1276.i.i.idx.i = mul i64 %arg.shape.1, 96
  %.1276.i.i.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1276.i.i.idx.i
  %.1276.i.i.idx.c.i = mul i64 %arg.shape.1, 96
  %.1276.i.i.c.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1276.i.i.idx.c.i
  %.1276.i.i.1.idx.i = mul i64 %arg.shape.1, 104
  %.1276.i.i.1.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1276.i.i.1.idx.i
  %.idx2164.i = mul i64 %arg.shape.1, 96
  %.402.i = icmp sgt i64 %arg.shape.1, 0
  %.520.i = add i64 %arg.linear.3.0, 1
  %.434.sroa.0.02106.i = add i64 %arg.shape.1, 1
  %.831.idx.i = mul i64 %arg.batch.4.0.5.1, 144
  %.831.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.831.idx.i
  %31 = add i64 %arg.linear.3.1, %arg.linear.3.0
  %.199.i.i = add i64 %arg.linear.3.1, 1
  %.2050 = add i64 %arg.shape.2, -1
  %storemerge10288 = tail call i64 @llvm.smax.i64(i64 %.2050, i64 0)
  %.209310684.not = icmp slt i64 %.2050, 1
  %.2266.idx = mul i64 %.463, 136
  %.2266 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.2266.idx
  %.218614.not.i = icmp sgt i64 %arg.shape.1, 0
  %or.cond10662.not = select i1 %.610, i1 %.218614.not.i, i1 false
  %.326.i10411 = mul nsw i64 %arg.shape.1, 17
  %.idx.i10413 = mul i64 %arg.shape.1, 80
  %invariant.gep10680 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i10413
  %.395.i = mul nsw i64 %arg.shape.1, 17
  %.339.i.i = add i64 %arg.linear.3.0, 1
  %invariant.gep10682 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.395.i
  %32 = add i64 %arg.linear.3.1, %arg.linear.3.0
  %.2386 = getelementptr i8, ptr %arg.code.4, i64 64
  %.2463 = icmp sgt i64 %arg.shape.3, 0
  %.2468 = icmp sgt i64 %arg.shape.6, 0
  %.idx10361 = mul i64 %arg.batch.4.0.5.1, 40
  %33 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10361
  %.idx10362 = mul i64 %arg.batch.4.0.5.1, 168
  %34 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10362
  %.idx10358 = mul i64 %arg.batch.4.0.5.1, 176
  %35 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10358
  %.idx10359 = mul i64 %arg.batch.4.0.5.1, 184
  %36 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10359
  %.idx10360 = mul i64 %arg.batch.4.0.5.1, 160
  %37 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10360
  %.idx10352 = shl i64 %arg.batch.4.1.5.1, 4
  %38 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10352
  %.idx10353 = mul i64 %arg.batch.4.0.5.1, 192
  %39 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10353
  %.idx10354 = mul i64 %arg.batch.4.0.5.1, 72
  %40 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10354
  %.idx10355 = mul i64 %arg.batch.4.0.5.1, 40
  %41 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10355
  %.idx10356 = mul i64 %arg.batch.4.0.5.1, 216
  %42 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10356
  %.idx10357 = mul i64 %arg.batch.4.0.5.1, 56
  %43 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10357
  %.3856.idx = mul i64 %.463, 136
  %.3856 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3856.idx
  %.3881.idx = mul i64 %.463, 104
  %.3881 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3881.idx
  %.3919 = getelementptr i8, ptr %arg.code.4, i64 240
  %.4013 = getelementptr i8, ptr %arg.code.4, i64 112
  %.idx10351 = shl i64 %arg.batch.4.1.5.1, 5
  %44 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10351
  %.671.i2337 = getelementptr i8, ptr %arg.code.4, i64 40
  %.742.i2391 = mul i64 %arg.shape.1, %arg.shape.0
  %.idx10348 = mul i64 %arg.batch.4.0.5.1, 48
  %45 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10348
  %.287.i.i10710.not = icmp slt i64 %arg.shape.1, 1
  %.358.i.i = shl nsw i64 %arg.shape.1, 4
  %.idx10344 = mul i64 %arg.batch.4.0.5.1, 40
  %46 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10344
  %.idx10345 = shl i64 %arg.batch.4.1.5.1, 5
  %47 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10345
  %.idx10346 = mul i64 %arg.batch.4.0.5.1, 104
  %48 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10346
  %.idx10347 = mul i64 %arg.batch.4.0.5.1, 112
  %49 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10347
  %.idx10340 = mul i64 %arg.batch.4.0.5.1, 56
  %50 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10340
  %.4394.idx = mul i64 %.463, 136
  %.4394 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4394.idx
  %.4457 = getelementptr i8, ptr %arg.code.4, i64 208
  %.4534 = getelementptr i8, ptr %arg.code.4, i64 104
  %.idx10333 = shl i64 %arg.batch.4.1.5.1, 4
  %51 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10333
  %.idx10334 = mul i64 %arg.batch.4.0.5.1, 40
  %52 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10334
  %.idx10335 = mul i64 %arg.batch.4.0.5.1, 56
  %53 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10335
  %.idx10336 = mul i64 %arg.batch.4.0.5.1, 200
  %54 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10336
  %.idx10337 = mul i64 %arg.batch.4.0.5.1, 48
  %55 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10337
  %.idx10338 = shl i64 %arg.batch.4.0.5.1, 5
  %56 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10338
  %57 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx10339 = mul i64 %arg.batch.4.0.5.1, 208
  %58 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10339
  %.4534.c = getelementptr i8, ptr %arg.code.4, i64 104
  %.idx10332 = shl i64 %arg.batch.4.1.5.1, 5
  %59 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10332
  %.671.i3587 = getelementptr i8, ptr %arg.code.4, i64 40
  %.742.i3643 = mul i64 %arg.shape.1, %arg.shape.0
  %.idx10329 = mul i64 %arg.batch.4.0.5.1, 48
  %60 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10329
  %.287.i.i441810738.not = icmp slt i64 %arg.shape.1, 1
  %.358.i.i4572 = shl nsw i64 %arg.shape.1, 4
  %.idx10324 = mul i64 %arg.batch.4.0.5.1, 40
  %61 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10324
  %.idx10325 = shl i64 %arg.batch.4.1.5.1, 5
  %62 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10325
  %storemerge10326 = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.idx10327 = mul i64 %arg.batch.4.0.5.1, 104
  %63 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10327
  %.idx10328 = mul i64 %arg.batch.4.0.5.1, 112
  %64 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10328
  %.idx10320 = mul i64 %arg.batch.4.0.5.1, 56
  %65 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10320
  %66 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.221.i = getelementptr i8, ptr %66, i64 -8
  %.idx2889.i = shl i64 %arg.batch.4.0.5.1, 7
  %67 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2889.i
  %.657.i.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx2886.i = mul i64 %arg.batch.4.0.5.1, 48
  %68 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2886.i
  %.287.i.i2900.not.i = icmp slt i64 %arg.shape.1, 1
  %.358.i.i.i = shl i64 %arg.shape.1, 4
  %factor.op.mul.i.reass = mul i64 %factor.op.mul, %arg.shape.0
  %.916.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %factor.op.mul.i.reass
  %.922.i.i = mul nsw i64 %arg.shape.5, %arg.shape.0
  %.925.i.i = mul i64 %arg.shape.6, %arg.shape.0
  %.111.i49.i2906.not.i = icmp slt i64 %.925.i.i, 1
  %.984.i.i10428 = getelementptr i8, ptr %arg.code.4, i64 8
  %factor.op.mul2918.i.reass = mul i64 %factor.op.mul10849, %arg.shape.0
  %.1243.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %factor.op.mul2918.i.reass
  %.1803.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.idx2885.i = shl i64 %arg.batch.4.0.5.1, 7
  %69 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2885.i
  %.155.i.i.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx2875.i = shl i64 %arg.batch.4.1.5.1, 5
  %70 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx2875.i
  %storemerge2877.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.idx2878.i = mul i64 %arg.batch.4.0.5.1, 96
  %71 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2878.i
  %.idx2870.i = mul i64 %arg.batch.4.0.5.1, 104
  %72 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2870.i
  %.idx2871.i = mul i64 %arg.batch.4.0.5.1, 112
  %73 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2871.i
  %.1254.reass.i = mul i64 %.358.i.i.i, %arg.shape.0
  %.1274.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1254.reass.i
  %.idx2865.i = shl i64 %arg.batch.4.1.5.1, 5
  %74 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx2865.i
  %storemerge2869.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.155.i.i.i10445 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx.i10436 = mul i64 %arg.batch.4.0.5.1, 56
  %75 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i10436
  %.idx2855.i = shl i64 %arg.batch.4.1.5.1, 5
  %76 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx2855.i
  %.idx2858.i = mul i64 %arg.batch.4.0.5.1, 104
  %77 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2858.i
  %.idx2862.i = mul i64 %arg.batch.4.0.5.1, 96
  %78 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2862.i
  %.idx2859.i = mul i64 %arg.batch.4.0.5.1, 112
  %79 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2859.i
  %.idx2860.i = mul i64 %arg.batch.4.0.5.1, 40
  %80 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2860.i
  %.idx2861.i = shl i64 %arg.batch.4.0.5.1, 5
  %81 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2861.i
  %82 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.4802.not = icmp eq i64 %arg.shape.3, 0
  %.10382 = select i1 %.612.not, i64 16, i64 1
  %.524.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.595.i10452.reass = mul i64 %factor.op.mul10850, %arg.shape.0
  %.615.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.595.i10452.reass
  %.452.i = uitofp i64 %.10382 to double
  %.idx719.i = mul i64 %arg.batch.4.0.5.1, 48
  %83 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx719.i
  %.287.i725.not.i = icmp slt i64 %arg.shape.1, 1
  %.358.i.i10453 = shl nsw i64 %arg.shape.1, 4
  %.idx.i10454 = mul i64 %arg.batch.4.0.5.1, 40
  %84 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i10454
  %.idx717.i = mul i64 %arg.batch.4.0.5.1, 104
  %85 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx717.i
  %.idx718.i = mul i64 %arg.batch.4.0.5.1, 112
  %86 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx718.i
  %.155.i.i.i10459 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i10466 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i10467 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i10468 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i10469 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i10470 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i10471 = mul nsw i64 %arg.shape.1, 18
  %factor.op.mul652.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx.i10482 = shl i64 %arg.batch.4.1.5.1, 4
  %87 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx.i10482
  %.idx640.i = mul i64 %arg.batch.4.0.5.1, 40
  %88 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx640.i
  %.idx641.i = mul i64 %arg.batch.4.0.5.1, 48
  %89 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx641.i
  %.idx642.i = mul i64 %arg.batch.4.0.5.1, 56
  %90 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx642.i
  %.924649.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx644.i = mul i64 %arg.batch.4.0.5.1, 208
  %91 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx644.i
  %.1000.i = mul nsw i64 %arg.shape.1, 17
  %92 = add i64 %arg.batch.2.5.0, -1
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.5038 = icmp sgt i64 %arg.shape.0, 1
  %.5092.idx = mul i64 %arg.batch.4.0.5.1, 40
  %.5092 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.5092.idx
  %.5124 = getelementptr i8, ptr %arg.code.4, i64 96
  %.idx10313 = mul i64 %arg.batch.4.0.5.1, 96
  %93 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10313
  %.idx10314 = mul i64 %arg.batch.4.0.5.1, 40
  %94 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10314
  %.idx10315 = mul i64 %arg.batch.4.0.5.1, 120
  %95 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10315
  %.552.i628610827.not = icmp slt i64 %arg.shape.1, 1
  %.697.i6323 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %96 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.742.i6352 = getelementptr i8, ptr %96, i64 -8
  %.idx10317 = mul i64 %arg.batch.4.1.5.1, 24
  %97 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10317
  %.idx10318 = mul i64 %arg.batch.4.1.5.1, 24
  %98 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10318
  %.idx10319 = mul i64 %arg.batch.4.0.5.1, 24
  %99 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10319
  %.5240.not = icmp ne i64 %arg.shape.4, 0
  %storemerge.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.0, i64 0)
  %.idx1632.i = mul i64 %arg.batch.4.0.5.1, 40
  %100 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1632.i
  %.idx1633.i = shl i64 %arg.batch.4.0.5.1, 4
  %101 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1633.i
  %102 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.175.i3061635.not.i = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.636.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.779.i = getelementptr i8, ptr %arg.code.4, i64 32
  %.850.i = mul nsw i64 %arg.shape.1, 17
  %.852.i = mul nsw i64 %.850.i, %arg.shape.0
  %.895.i10502 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.852.i
  %.900.not.i = icmp eq i64 %arg.shape.3, 0
  %.930.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx1630.i = shl i64 %arg.batch.4.1.5.1, 4
  %103 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1630.i
  %.15441642.not.i = icmp slt i64 %arg.shape.1, 1
  %.1739.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx10302 = mul i64 %arg.batch.4.0.5.1, 40
  %104 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10302
  %.idx10303 = shl i64 %arg.batch.4.0.5.1, 4
  %105 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10303
  %106 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx10304 = mul i64 %arg.batch.4.0.5.1, 24
  %107 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10304
  %.175.i.i770610839.not = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.idx10307 = shl i64 %arg.batch.4.1.5.1, 4
  %108 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10307
  %.idx.i10514 = mul i64 %arg.batch.4.0.5.1, 24
  %109 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i10514
  %.323.i10516 = getelementptr i8, ptr %arg.batch.4.2.4, i64 8
  %110 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx1124.i10536 = mul i64 %arg.batch.4.1.5.1, 24
  %111 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1124.i10536
  %.8051131.not.i10538 = icmp slt i64 %arg.batch.0.1.5.1, 1
  %.175.i1134.not.i10554 = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.11171137.not.i10573 = icmp slt i64 %arg.shape.1, 1
  %gep.2.idx.i10591 = shl i64 %arg.batch.4.0.5.1, 4
  %gep.4.idx.i10595 = shl i64 %arg.batch.4.0.5.1, 5
  %gep.6.idx.i10599 = mul i64 %arg.batch.4.0.5.1, 48
  %gep.7.idx.i10601 = mul i64 %arg.batch.4.0.5.1, 56
  %gep.9.idx.i10605 = mul i64 %arg.batch.4.0.5.1, 72
  %gep.10.idx.i10607 = mul i64 %arg.batch.4.0.5.1, 80
  %gep.11.idx.i10609 = mul i64 %arg.batch.4.0.5.1, 88
  %gep.12.idx.i10611 = mul i64 %arg.batch.4.0.5.1, 96
  %gep.13.idx.i10613 = mul i64 %arg.batch.4.0.5.1, 104
  %gep.14.idx.i10615 = mul i64 %arg.batch.4.0.5.1, 112
  %gep.15.idx.i10617 = mul i64 %arg.batch.4.0.5.1, 120
  %gep.16.idx.i10619 = shl i64 %arg.batch.4.0.5.1, 7
  %gep.17.idx.i10621 = mul i64 %arg.batch.4.0.5.1, 136
  %gep.18.idx.i10623 = mul i64 %arg.batch.4.0.5.1, 144
  %gep.19.idx.i10625 = mul i64 %arg.batch.4.0.5.1, 152
  %gep.20.idx.i10627 = mul i64 %arg.batch.4.0.5.1, 160
  %gep.21.idx.i10629 = mul i64 %arg.batch.4.0.5.1, 168
  %gep.22.idx.i10631 = mul i64 %arg.batch.4.0.5.1, 176
  %gep.23.idx.i10633 = mul i64 %arg.batch.4.0.5.1, 184
  %gep.24.idx.i10635 = mul i64 %arg.batch.4.0.5.1, 192
  %gep.25.idx.i10637 = mul i64 %arg.batch.4.0.5.1, 200
  %gep.26.idx.i10639 = mul i64 %arg.batch.4.0.5.1, 208
  %112 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i10591
  %113 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.15.idx.i10617
  %114 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.26.idx.i10639
  %.idx1130.i10654 = mul i64 %arg.batch.4.0.5.1, 216
  %115 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i10654
  %.idx10306 = mul i64 %arg.batch.4.0.5.1, 216
  %116 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10306
  %.6308 = tail call i64 @llvm.smin.i64(i64 %arg.batch.2.5.0, i64 0)
  %117 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %118 = getelementptr i8, ptr %117, i64 -8
  %.6322 = getelementptr double, ptr %118, i64 %.6308
  %119 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx10308 = mul i64 %arg.batch.4.0.5.1, 216
  %120 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10308
  %.idx10309 = mul i64 %arg.batch.4.0.5.1, 160
  %121 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10309
  %.idx10310 = shl i64 %arg.batch.4.1.5.1, 4
  %122 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10310
  %.idx10311 = shl i64 %arg.batch.4.0.5.1, 4
  %123 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10311
  %.idx10312 = mul i64 %arg.batch.4.0.5.1, 152
  %124 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10312
  %125 = shl i64 %arg.shape.0, 3
  %.155.i.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.i.1 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.i.2 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.i.3 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.i.4 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.i.5 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.i.6 = mul nsw i64 %arg.shape.1, 18
  %126 = getelementptr i8, ptr %arg.code.4, i64 216
  %.4419.idx = mul i64 %.463, 112
  %.4419 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4419.idx
  %127 = getelementptr i8, ptr %arg.code.4, i64 224
  %.4419.1.idx = mul i64 %.463, 120
  %.4419.1 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4419.1.idx
  %128 = getelementptr i8, ptr %arg.code.4, i64 232
  %.4419.2.idx = shl i64 %.463, 7
  %.4419.2 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4419.2.idx
  %.155.i.i.i4609 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.i4609.1 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.i4609.2 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.i4609.3 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.i4609.4 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.i4609.5 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.i4609.6 = mul nsw i64 %arg.shape.1, 18
  br label %B416

B416:                                             ; preds = %B416.preheader, %B4560
  %budget.3.1 = phi i64 [ %budget.4.2, %B4560 ], [ %arg.budget, %B416.preheader ]
  %active.9.1 = phi i64 [ %active.8.2, %B4560 ], [ %active.4.0.lcssa, %B416.preheader ]
  %.1003 = add nsw i64 %budget.3.1, -1
  %.1038 = load i64, ptr %.1037, align 8
  %.1039 = icmp eq i64 %.1038, 1
  %.1073 = icmp sgt i64 %.1038, 0
  br i1 %.1073, label %B484, label %B562

B484:                                             ; preds = %B416
  store i64 0, ptr %.1037, align 8
  %.1134 = load i64, ptr %.1133, align 8
  %.1179 = inttoptr i64 %.1134 to ptr
  tail call void %.1179(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B562

B562:                                             ; preds = %B484, %B416
  br i1 %.1039, label %B568, label %B1134

B568:                                             ; preds = %B562
  br i1 %.1185, label %B580, label %B616

B580:                                             ; preds = %B568
  %.163.i = load i64, ptr %.162.i, align 8, !noalias !7
  %.275.i = inttoptr i64 %.163.i to ptr
  tail call void %.275.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br i1 %.665, label %B326.i, label %B194.if.i

B324.i:                                           ; preds = %B266.if.i, %B194.if.i
  %.359.i = icmp sgt i64 %.304.i.010676, 1
  br i1 %.359.i, label %B194.if.i, label %B326.i

B326.i:                                           ; preds = %B324.i, %B580
  %.692.i = load i64, ptr %.691.i, align 8, !noalias !7
  %.808.i = inttoptr i64 %.692.i to ptr
  tail call void %.808.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br label %B616

B194.if.i:                                        ; preds = %B580, %B324.i
  %.304.i.010676 = phi i64 [ %.368.i, %B324.i ], [ %storemerge, %B580 ]
  %.301.i.010675 = phi i64 [ %.372.i, %B324.i ], [ 0, %B580 ]
  %.368.i = add nsw i64 %.304.i.010676, -1
  %.372.i = add nsw i64 %.301.i.010675, 1
  %129 = getelementptr double, ptr %19, i64 %.301.i.010675
  %.454.i = load double, ptr %129, align 8, !noalias !7
  %.455.i = fcmp ule double %.454.i, 5.000000e-01
  %brmerge10854 = select i1 %.455.i, i1 true, i1 %.537.i10671
  br i1 %brmerge10854, label %B324.i, label %B266.if.i.preheader

B266.if.i.preheader:                              ; preds = %B194.if.i
  %invariant.gep10898 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.301.i.010675
  br label %B266.if.i

B266.if.i:                                        ; preds = %B266.if.i.preheader, %B266.if.i
  %.481.i.010672 = phi i64 [ %.550.i, %B266.if.i ], [ 0, %B266.if.i.preheader ]
  %.550.i = add nsw i64 %.481.i.010672, 1
  %.576.i = mul nsw i64 %.481.i.010672, %arg.shape.0
  %gep10899 = getelementptr double, ptr %invariant.gep10898, i64 %.576.i
  %.608.i = load double, ptr %gep10899, align 8, !noalias !7
  %.610.i = add nsw i64 %.481.i.010672, %arg.shape.5
  %.612.i = mul nsw i64 %.610.i, %arg.shape.0
  %.614.i = add nsw i64 %.612.i, %.301.i.010675
  %.628.i = icmp slt i64 %.614.i, 0
  %.629.i = select i1 %.628.i, i64 %arg.batch.5.1.5.0, i64 0
  %130 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.614.i
  %.643.i = getelementptr double, ptr %130, i64 %.629.i
  store double %.608.i, ptr %.643.i, align 8, !noalias !7
  %exitcond.not = icmp eq i64 %.550.i, %arg.shape.6
  br i1 %exitcond.not, label %B324.i, label %B266.if.i

B616:                                             ; preds = %B326.i, %B568
  br i1 %.1246.not, label %B688, label %B620

B620:                                             ; preds = %B616
  %.1277 = load i64, ptr %.1276, align 8
  %.1322 = inttoptr i64 %.1277 to ptr
  tail call void %.1322(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B688

B688:                                             ; preds = %B620, %B616
  br i1 %.612.not, label %B692, label %B1092

B692:                                             ; preds = %B688
  %.1356 = load i64, ptr %arg.code.4, align 8
  %.1404 = inttoptr i64 %.1356 to ptr
  tail call void %.1404(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1403)
  %.1435 = load i64, ptr %.1434, align 8
  %.1480 = inttoptr i64 %.1435 to ptr
  tail call void %.1480(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.1511 = load i64, ptr %.1510, align 8
  %.1556 = inttoptr i64 %.1511 to ptr
  tail call void %.1556(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.1587 = load i64, ptr %arg.code.4, align 8
  %.1637 = inttoptr i64 %.1587 to ptr
  tail call void %.1637(ptr %.571, ptr %.1611, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1636)
  %.1668 = load i64, ptr %.1667, align 8
  %.1713 = inttoptr i64 %.1668 to ptr
  tail call void %.1713(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B1092

B1092:                                            ; preds = %B692, %B688
  br i1 %.665, label %B1134, label %B64.if.i

B106.i:                                           ; preds = %B64.if.i
  store double 0.000000e+00, ptr %.323.i132, align 8, !noalias !11
  %.441.i = getelementptr double, ptr %21, i64 %.170.i.010678
  store double 0.000000e+00, ptr %.441.i, align 8, !noalias !11
  %.496.i215 = getelementptr double, ptr %22, i64 %.170.i.010678
  store double 0.000000e+00, ptr %.496.i215, align 8, !noalias !11
  %.551.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.170.i.010678
  %.552.i245 = load i64, ptr %.551.i, align 8, !noalias !11
  %.579.i257 = icmp slt i64 %.552.i245, 0
  %.580.i258 = select i1 %.579.i257, i64 %arg.batch.3.3.5.0, i64 0
  %.581.i = add i64 %.580.i258, %.552.i245
  %.601.i272 = mul i64 %.581.i, %arg.batch.3.3.5.1
  %131 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.601.i272
  %.605.i = getelementptr i8, ptr %131, i64 8
  %.606.i = load i64, ptr %.605.i, align 8, !noalias !11
  %.628.i284 = add nsw i64 %.606.i, %.10372
  store i64 %.628.i284, ptr %.605.i, align 8, !noalias !11
  %.744.i347 = load i64, ptr %.551.i, align 8, !noalias !11
  %.771.i = icmp slt i64 %.744.i347, 0
  %.772.i = select i1 %.771.i, i64 %arg.batch.3.3.5.0, i64 0
  %.773.i = add i64 %.772.i, %.744.i347
  %.793.i370 = mul i64 %.773.i, %arg.batch.3.3.5.1
  %132 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.793.i370
  %.797.i = getelementptr i8, ptr %132, i64 16
  %.798.i = load i64, ptr %.797.i, align 8, !noalias !11
  %.799.i373 = add nsw i64 %.798.i, 1
  store i64 %.799.i373, ptr %.797.i, align 8, !noalias !11
  %.905.i = getelementptr double, ptr %23, i64 %.170.i.010678
  %.906.i = load double, ptr %.905.i, align 8, !noalias !11
  %.907.i = fcmp une double %.906.i, 0.000000e+00
  br i1 %.907.i, label %B368.i, label %B414.i

B368.i:                                           ; preds = %B106.i
  %133 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.170.i.010678
  %.84.i.i = load i64, ptr %133, align 8, !noalias !15
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
  br i1 %.1246.not, label %B550.i, label %B418.i

B418.i:                                           ; preds = %B414.i
  %134 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.170.i.010678
  %.977.i = load double, ptr %134, align 8, !noalias !11
  %.979.i = fcmp olt double %.977.i, -1.000000e-09
  br i1 %.979.i, label %B454.i, label %B550.i

B454.i:                                           ; preds = %B418.i
  %135 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.170.i.010678
  %.84.i63.i = load i64, ptr %135, align 8, !noalias !18
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
  %.1068.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.170.i.010678
  %.1069.i = load double, ptr %.1068.i, align 8, !noalias !11
  %.1123.i = getelementptr double, ptr %24, i64 %.170.i.010678
  store double %.1069.i, ptr %.1123.i, align 8, !noalias !11
  br label %B550.i

B550.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i, %B418.i, %B414.i
  %.111.i183.i = getelementptr i64, ptr %25, i64 %.170.i.010678
  %.112.i.i = load i64, ptr %.111.i183.i, align 8, !noalias !21
  %.169.i.i = getelementptr double, ptr %26, i64 %.170.i.010678
  %.170.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.224.i.i = getelementptr double, ptr %27, i64 %.170.i.010678
  store double %.170.i.i, ptr %.224.i.i, align 8, !noalias !21
  %.237.i.i = icmp slt i64 %.112.i.i, %arg.batch.2.5.0
  br i1 %.237.i.i, label %B134.i.i, label %B584.i

B134.i.i:                                         ; preds = %B550.i
  %.253.i.i = icmp slt i64 %.112.i.i, 0
  %.254.i.i = select i1 %.253.i.i, i64 %arg.batch.2.5.0, i64 0
  %136 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i.i
  %.268.i.i = getelementptr double, ptr %136, i64 %.254.i.i
  %.269.i.i = load double, ptr %.268.i.i, align 8, !noalias !21
  %.328.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.10.i.i.i = fcmp olt double %.328.i.i, %.269.i.i
  %.11.i.i.i = select i1 %.10.i.i.i, double %.328.i.i, double %.269.i.i
  store double %.11.i.i.i, ptr %.224.i.i, align 8, !noalias !21
  br label %B584.i

B584.i:                                           ; preds = %B134.i.i, %B550.i, %B64.if.i
  %.229.i103 = icmp sgt i64 %.173.i7.010679, 1
  br i1 %.229.i103, label %B64.if.i, label %B1134

B64.if.i:                                         ; preds = %B1092, %B584.i
  %.173.i7.010679 = phi i64 [ %.238.i, %B584.i ], [ %storemerge, %B1092 ]
  %.170.i.010678 = phi i64 [ %.242.i388, %B584.i ], [ 0, %B1092 ]
  %.238.i = add nsw i64 %.173.i7.010679, -1
  %.242.i388 = add nsw i64 %.170.i.010678, 1
  %.323.i132 = getelementptr double, ptr %20, i64 %.170.i.010678
  %.324.i133 = load double, ptr %.323.i132, align 8, !noalias !11
  %.325.i134 = fcmp ogt double %.324.i133, 5.000000e-01
  br i1 %.325.i134, label %B106.i, label %B584.i

B1134:                                            ; preds = %B584.i, %B1092, %B562
  %.1807 = load i64, ptr %.1806, align 8
  %.1852 = inttoptr i64 %.1807 to ptr
  tail call void %.1852(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.612.not, label %B1290, label %B1206

B1206:                                            ; preds = %B1134
  %.1885 = load i64, ptr %arg.code.4, align 8
  %.1932 = inttoptr i64 %.1885 to ptr
  tail call void %.1932(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1931)
  br label %B1290

B1290:                                            ; preds = %B1206, %B1134
  br i1 %.610, label %B1294, label %B1334

B1294:                                            ; preds = %B1290
  %.267.i = load double, ptr %.266.i, align 8, !noalias !25
  %.268.i = fcmp olt double %.267.i, 5.000000e-01
  br i1 %.268.i, label %B76.i, label %B116.i

B76.i:                                            ; preds = %B1294
  br i1 %.317.i2117.not.i, label %B166.i.i, label %B84.if.i.i

B166.i.i:                                         ; preds = %B84.if.i.i, %B76.i
  br i1 %.547.i2141.i, label %B232.i.i, label %B116.i

B228.i.loopexit.i:                                ; preds = %B995.i.i, %B702.i.i
  %.547.i.i = icmp sgt i64 %.493.i.12146.i, 0
  %.560.i.i = zext i1 %.547.i.i to i64
  %.490.i.1.i = add i64 %.490.i.12145.i, %.560.i.i
  %.556.i.i = sext i1 %.547.i.i to i64
  %.493.i.1.i = add nsw i64 %.493.i.12146.i, %.556.i.i
  %.537.i.sroa.0.0.i = select i1 %.547.i.i, i64 %.490.i.12145.i, i64 0
  br i1 %.547.i.i, label %B232.i.i, label %B116.i

B232.i.i:                                         ; preds = %B166.i.i, %B228.i.loopexit.i
  %.537.i.sroa.0.02147.i = phi i64 [ %.537.i.sroa.0.0.i, %B228.i.loopexit.i ], [ 0, %B166.i.i ]
  %.493.i.12146.i = phi i64 [ %.493.i.1.i, %B228.i.loopexit.i ], [ %.493.i.12144.i, %B166.i.i ]
  %.490.i.12145.i = phi i64 [ %.490.i.1.i, %B228.i.loopexit.i ], [ 1, %B166.i.i ]
  br i1 %.589.i.i, label %B250.i.i, label %B660.i.i

B250.i.i:                                         ; preds = %B232.i.i
  br i1 %.682.i2120.i, label %B286.if.i.i, label %B352.i.i

B352.i.i:                                         ; preds = %B286.if.i.i, %B250.i.i
  %.843.i.i = load i64, ptr %.842.i.i, align 8, !noalias !28
  %.959.i.i = inttoptr i64 %.843.i.i to ptr
  tail call void %.959.i.i(ptr %arg.batch.4.0.4, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.958.i.i), !noalias !28
  %.975.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, 0
  %.976.i.i = select i1 %.975.i.i, i64 %arg.linear.6.5.0, i64 0
  %137 = getelementptr i64, ptr %arg.linear.6.4, i64 %.537.i.sroa.0.02147.i
  %.990.i.i = getelementptr i64, ptr %137, i64 %.976.i.i
  %.991.i.i = load i64, ptr %.990.i.i, align 8, !noalias !28
  %.1007.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, -1
  %.1008.i.i = select i1 %.1007.i.i, i64 %arg.linear.6.5.0, i64 0
  %138 = getelementptr i8, ptr %137, i64 8
  %.1022.i.i = getelementptr i64, ptr %138, i64 %.1008.i.i
  %.1023.i.i = load i64, ptr %.1022.i.i, align 8, !noalias !28
  %.1060.i.i = sub i64 %.1023.i.i, %.991.i.i
  %.1106.i2123.not.i = icmp slt i64 %.1060.i.i, 1
  br i1 %.1106.i2123.not.i, label %B702.i.i, label %B536.if.i.i

B544.i.i:                                         ; preds = %B536.if.i.i
  %.1173.i.i = icmp slt i64 %.1047.i.02124.i, 0
  %.1174.i.i = select i1 %.1173.i.i, i64 %arg.linear.7.5.0, i64 0
  %139 = getelementptr i64, ptr %arg.linear.7.4, i64 %.1047.i.02124.i
  %.1188.i.i = getelementptr i64, ptr %139, i64 %.1174.i.i
  %.1189.i.i = load i64, ptr %.1188.i.i, align 8, !noalias !28
  %.1190.i.i = add nsw i64 %.1189.i.i, %.915.i.i
  %.1204.i.i = icmp slt i64 %.1190.i.i, 0
  %.1205.i.i = select i1 %.1204.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %140 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1190.i.i
  %.1219.i.i = getelementptr double, ptr %140, i64 %.1205.i.i
  %.1220.i.i = load double, ptr %.1219.i.i, align 8, !noalias !28
  %.1287.i.i = fsub double %.1220.i.i, %.1220.i.i
  %.1288.i.i = fcmp oeq double %.1287.i.i, 0.000000e+00
  br label %B652.i.i

B652.i.i:                                         ; preds = %B536.if.i.i, %B544.i.i
  %"$phi652.2.2.i.3.i" = phi i1 [ %.1288.i.i, %B544.i.i ], [ false, %B536.if.i.i ]
  %.1106.i.i = icmp sgt i64 %.1050.i.02125.i, 1
  br i1 %.1106.i.i, label %B536.if.i.i, label %B656.i.i

B656.i.i:                                         ; preds = %B652.i.i
  br i1 %"$phi652.2.2.i.3.i", label %B702.i.i, label %B660.i.i

B660.i.i:                                         ; preds = %B656.i.i, %B232.i.i
  %.151.i.i.i = load double, ptr %.150.i.i.i, align 8, !noalias !32
  %.180.i.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !32
  %.184.i.i.i = fdiv double %.151.i.i.i, %.180.i.i.i
  br i1 %.317.i2117.not.i, label %B262.i.i.i, label %B84.if.i.i.i

B262.i.i.i:                                       ; preds = %B84.if.i.i.i, %B660.i.i
  %.526.i.i.i = load i64, ptr %.525.i.i.i, align 8, !noalias !32
  %.530.i.i.i = icmp eq i64 %.526.i.i.i, %.537.i.sroa.0.02147.i
  br i1 %.530.i.i.i, label %B286.i.i.i, label %B324.i.i.i

B286.i.i.i:                                       ; preds = %B262.i.i.i
  %.587.i.i.i = load double, ptr %.586.i.i.i, align 8, !noalias !32
  %.588.i.i.i = fmul double %.587.i.i.i, 1.000000e-03
  br label %B324.i.i.i

B324.i.i.i:                                       ; preds = %B286.i.i.i, %B262.i.i.i
  %"$phi324.0.2.i.i.0.i" = phi double [ %.588.i.i.i, %B286.i.i.i ], [ 0.000000e+00, %B262.i.i.i ]
  store double %"$phi324.0.2.i.i.0.i", ptr %.629.i.i.i, align 8, !noalias !32
  br i1 %.317.i2117.not.i, label %B524.i.i.1.critedge.i, label %B428.if.i.i.i

B524.i.i.i:                                       ; preds = %B428.if.i.i.i
  %.1034.i.i.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !32
  %.1068.i.i.i = load double, ptr %.629.i.i.i, align 8, !noalias !32
  %.1070.i.i.i = fmul double %.1068.i.i.i, 5.000000e-01
  %.1073.i.i.i = fadd double %.1034.i.i.i, %.1070.i.i.i
  store double %.1073.i.i.i, ptr %.571, align 8, !noalias !32
  %.1157.i.i.i = load i64, ptr %arg.code.4, align 8, !noalias !32
  %.1277.i.i.i = inttoptr i64 %.1157.i.i.i to ptr
  tail call void %.1277.i.i.i(ptr nonnull %.571, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.i), !noalias !32
  br label %B428.if.i.i.1.i

B428.if.i.i.1.i:                                  ; preds = %B428.if.i.i.1.i, %B524.i.i.i
  %.783.i.i.02131.1.i = phi i64 [ %.852.i.i.1.i, %B428.if.i.i.1.i ], [ 0, %B524.i.i.i ]
  %.852.i.i.1.i = add nsw i64 %.783.i.i.02131.1.i, 1
  %141 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02131.1.i
  %.906.i.i.1.i = load double, ptr %141, align 8, !noalias !32
  %142 = getelementptr double, ptr %141, i64 %.597.i.i.i
  %.939.i.i.1.i = load double, ptr %142, align 8, !noalias !32
  %.941.i.i.1.i = fmul double %.939.i.i.1.i, 5.000000e-01
  %143 = fsub double %.906.i.i.1.i, %.941.i.i.1.i
  %144 = getelementptr double, ptr %141, i64 %.944.i.i.i
  store double %143, ptr %144, align 8, !noalias !32
  %exitcond2155.1.not.i = icmp eq i64 %arg.shape.1, %.852.i.i.1.i
  br i1 %exitcond2155.1.not.i, label %B524.i.i.1.i, label %B428.if.i.i.1.i

B524.i.i.1.critedge.i:                            ; preds = %B324.i.i.i
  %.1034.i.i.c.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !32
  %.1070.i.i.c.i = fmul double %"$phi324.0.2.i.i.0.i", 5.000000e-01
  %.1073.i.i.c.i = fadd double %.1070.i.i.c.i, %.1034.i.i.c.i
  store double %.1073.i.i.c.i, ptr %.571, align 8, !noalias !32
  %.1157.i.i.c.i = load i64, ptr %arg.code.4, align 8, !noalias !32
  %.1277.i.i.c.i = inttoptr i64 %.1157.i.i.c.i to ptr
  tail call void %.1277.i.i.c.i(ptr nonnull %.571, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.c.i), !noalias !32
  br label %B524.i.i.1.i

B524.i.i.1.i:                                     ; preds = %B428.if.i.i.1.i, %B524.i.i.1.critedge.i
  %.1034.i.i.1.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !32
  %.1068.i.i.1.i = load double, ptr %.629.i.i.i, align 8, !noalias !32
  %.1070.i.i.1.i = fmul double %.1068.i.i.1.i, 5.000000e-01
  %145 = fsub double %.1034.i.i.1.i, %.1070.i.i.1.i
  store double %145, ptr %.571, align 8, !noalias !32
  %.1157.i.i.1.i = load i64, ptr %arg.code.4, align 8, !noalias !32
  %.1277.i.i.1.i = inttoptr i64 %.1157.i.i.1.i to ptr
  tail call void %.1277.i.i.1.i(ptr nonnull %.571, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.1.i), !noalias !32
  br i1 %.317.i2117.not.i, label %B702.i.i, label %B780.if.i.i.i

B966.i.i.i:                                       ; preds = %B780.if.i.i.i
  %.1601.i.i.i = fsub double %.1513.i.i.i, %.1548.i.i.i
  br label %B1053.i.i.i

B1006.i.i.i:                                      ; preds = %B780.if.i.i.i
  %146 = getelementptr double, ptr %154, i64 %arg.shape.1
  %.1582.i.i.i = load double, ptr %146, align 8, !noalias !32
  %.1647.i.i.i = fsub double %.1513.i.i.i, %.1582.i.i.i
  %.1652.i.i.i = fmul double %.1647.i.i.i, 2.000000e+00
  br label %B1053.i.i.i

B1053.i.i.i:                                      ; preds = %B1006.i.i.i, %B966.i.i.i
  %storemerge2111.i = phi double [ %.1652.i.i.i, %B1006.i.i.i ], [ %.1601.i.i.i, %B966.i.i.i ]
  store double %storemerge2111.i, ptr %156, align 8, !noalias !32
  %exitcond2157.not.i = icmp eq i64 %arg.shape.1, %.1387.i.i.i
  br i1 %exitcond2157.not.i, label %B702.i.i, label %B780.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B660.i.i, %B84.if.i.i.i
  %.212.i.i.02129.i = phi i64 [ %.283.i.i.i, %B84.if.i.i.i ], [ 0, %B660.i.i ]
  %.283.i.i.i = add nsw i64 %.212.i.i.02129.i, 1
  %147 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.212.i.i.02129.i
  %.341.i.i.i = load double, ptr %147, align 8, !noalias !32
  %.342.i.i.i = tail call double @llvm.fabs.f64(double %.341.i.i.i)
  %.10.i.i.i.i = fcmp ogt double %.184.i.i.i, %.342.i.i.i
  %.11.i.i.i.i = select i1 %.10.i.i.i.i, double %.184.i.i.i, double %.342.i.i.i
  %.377.i.i.i = fcmp ogt double %.11.i.i.i.i, 0.000000e+00
  %148 = fmul double %.11.i.i.i.i, 1.200000e-05
  %"$phi194.2.2.i.i.1.i" = select i1 %.377.i.i.i, double %148, double 1.200000e-05
  %149 = getelementptr i64, ptr %arg.linear.5.4, i64 %.212.i.i.02129.i
  %.434.i.i.i = load i64, ptr %149, align 8, !noalias !32
  %.436.i.i.i = icmp eq i64 %.434.i.i.i, %.537.i.sroa.0.02147.i
  %"$phi230.1.2.i.i.1.i" = select i1 %.436.i.i.i, double %"$phi194.2.2.i.i.1.i", double 0.000000e+00
  %150 = getelementptr i8, ptr %147, i64 %.idx2162.i
  store double %"$phi230.1.2.i.i.1.i", ptr %150, align 8, !noalias !32
  %exitcond2154.not.i = icmp eq i64 %arg.shape.1, %.283.i.i.i
  br i1 %exitcond2154.not.i, label %B262.i.i.i, label %B84.if.i.i.i

B428.if.i.i.i:                                    ; preds = %B324.i.i.i, %B428.if.i.i.i
  %.783.i.i.02131.i = phi i64 [ %.852.i.i.i, %B428.if.i.i.i ], [ 0, %B324.i.i.i ]
  %.852.i.i.i = add nsw i64 %.783.i.i.02131.i, 1
  %151 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02131.i
  %.906.i.i.i = load double, ptr %151, align 8, !noalias !32
  %152 = getelementptr double, ptr %151, i64 %.597.i.i.i
  %.939.i.i.i = load double, ptr %152, align 8, !noalias !32
  %.941.i.i.i = fmul double %.939.i.i.i, 5.000000e-01
  %.942.i.i.i = fadd double %.906.i.i.i, %.941.i.i.i
  %153 = getelementptr double, ptr %151, i64 %.944.i.i.i
  store double %.942.i.i.i, ptr %153, align 8, !noalias !32
  %exitcond2155.not.i = icmp eq i64 %arg.shape.1, %.852.i.i.i
  br i1 %exitcond2155.not.i, label %B524.i.i.i, label %B428.if.i.i.i

B780.if.i.i.i:                                    ; preds = %B524.i.i.1.i, %B1053.i.i.i
  %.1318.i.i.02136.i = phi i64 [ %.1387.i.i.i, %B1053.i.i.i ], [ 0, %B524.i.i.1.i ]
  %.1387.i.i.i = add nsw i64 %.1318.i.i.02136.i, 1
  %154 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1318.i.i.02136.i
  %.1445.i.i.i = load double, ptr %154, align 8, !noalias !32
  %155 = getelementptr i8, ptr %154, i64 %.933.i.idx.i
  store double %.1445.i.i.i, ptr %155, align 8, !noalias !32
  %156 = getelementptr i8, ptr %154, i64 %.idx2164.i
  %.1513.i.i.i = load double, ptr %156, align 8, !noalias !32
  %157 = getelementptr i8, ptr %154, i64 %.1276.i.i.1.idx.i
  %.1548.i.i.i = load double, ptr %157, align 8, !noalias !32
  %.1594.i.i.i = fsub double %.1548.i.i.i, %.1548.i.i.i
  %.1595.i.i.i = fcmp oeq double %.1594.i.i.i, 0.000000e+00
  br i1 %.1595.i.i.i, label %B966.i.i.i, label %B1006.i.i.i

B702.i.i:                                         ; preds = %B1053.i.i.i, %B524.i.i.1.i, %B656.i.i, %B352.i.i
  %.1384.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, 0
  %.1385.i.i = select i1 %.1384.i.i, i64 %arg.linear.6.5.0, i64 0
  %158 = getelementptr i64, ptr %arg.linear.6.4, i64 %.537.i.sroa.0.02147.i
  %.1399.i.i = getelementptr i64, ptr %158, i64 %.1385.i.i
  %.1400.i.i = load i64, ptr %.1399.i.i, align 8, !noalias !28
  %.1418.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, -1
  %.1419.i.i = select i1 %.1418.i.i, i64 %arg.linear.6.5.0, i64 0
  %159 = getelementptr i8, ptr %158, i64 8
  %.1433.i.i = getelementptr i64, ptr %159, i64 %.1419.i.i
  %.1434.i.i = load i64, ptr %.1433.i.i, align 8, !noalias !28
  %.1471.i.i = sub i64 %.1434.i.i, %.1400.i.i
  %.1514.i2138.not.i = icmp slt i64 %.1471.i.i, 1
  br i1 %.1514.i2138.not.i, label %B228.i.loopexit.i, label %B764.if.i.i

B920.i.i:                                         ; preds = %B764.if.i.i
  %.1782.i.i = add nsw i64 %.1587.i.i, %.1748.i.i
  %.1797.i.i = icmp slt i64 %.1782.i.i, 0
  %.1798.i.i = select i1 %.1797.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %160 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1782.i.i
  %.1812.i.i = getelementptr double, ptr %160, i64 %.1798.i.i
  store double %.1686.i..i, ptr %.1812.i.i, align 8, !noalias !28
  br label %B995.i.i

B966.i.i:                                         ; preds = %B764.if.i.i
  %.1832.i.i = select i1 %.1571.i.i, i64 %arg.linear.9.5.0, i64 0
  %161 = getelementptr i64, ptr %arg.linear.9.4, i64 %.1458.i.02139.i
  %.1846.i.i = getelementptr i64, ptr %161, i64 %.1832.i.i
  %.1847.i.i = load i64, ptr %.1846.i.i, align 8, !noalias !28
  %.1864.i.i = icmp slt i64 %.1847.i.i, 0
  %.1865.i.i = select i1 %.1864.i.i, i64 %arg.linear.0.5.0, i64 0
  %162 = getelementptr double, ptr %arg.linear.0.4, i64 %.1847.i.i
  %.1879.i.i = getelementptr double, ptr %162, i64 %.1865.i.i
  store double %.1686.i..i, ptr %.1879.i.i, align 8, !noalias !28
  br label %B995.i.i

B995.i.i:                                         ; preds = %B966.i.i, %B920.i.i
  %.1514.i.i = icmp sgt i64 %.1461.i.02140.i, 1
  br i1 %.1514.i.i, label %B764.if.i.i, label %B228.i.loopexit.i

B84.if.i.i:                                       ; preds = %B76.i, %B84.if.i.i
  %.259.i.02118.i = phi i64 [ %.330.i.i, %B84.if.i.i ], [ 0, %B76.i ]
  %.330.i.i = add nsw i64 %.259.i.02118.i, 1
  %163 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.259.i.02118.i
  %.384.i.i = load double, ptr %163, align 8, !noalias !28
  %164 = getelementptr i8, ptr %163, i64 %.idx2159.i
  store double %.384.i.i, ptr %164, align 8, !noalias !28
  %165 = getelementptr i8, ptr %163, i64 %.idx2160.i
  store double 0.000000e+00, ptr %165, align 8, !noalias !28
  %exitcond.not.i10408 = icmp eq i64 %arg.shape.1, %.330.i.i
  br i1 %exitcond.not.i10408, label %B166.i.i, label %B84.if.i.i

B286.if.i.i:                                      ; preds = %B250.i.i, %B286.if.i.i
  %.629.i.02122.i = phi i64 [ %.691.i.i, %B286.if.i.i ], [ %storemerge2107.i, %B250.i.i ]
  %.626.i.02121.i = phi i64 [ %.695.i.i, %B286.if.i.i ], [ 0, %B250.i.i ]
  %.691.i.i = add nsw i64 %.629.i.02122.i, -1
  %.695.i.i = add nsw i64 %.626.i.02121.i, 1
  %166 = getelementptr i64, ptr %arg.linear.5.4, i64 %.626.i.02121.i
  %.753.i.i = load i64, ptr %166, align 8, !noalias !28
  %.755.i.i = icmp eq i64 %.753.i.i, %.537.i.sroa.0.02147.i
  %..i = select i1 %.755.i.i, double 1.000000e+00, double 0.000000e+00
  %gep = getelementptr double, ptr %invariant.gep, i64 %.626.i.02121.i
  store double %..i, ptr %gep, align 8, !noalias !28
  %.682.i.i = icmp sgt i64 %.629.i.02122.i, 1
  br i1 %.682.i.i, label %B286.if.i.i, label %B352.i.i

B536.if.i.i:                                      ; preds = %B352.i.i, %B652.i.i
  %found.2.i.22126.i = phi i1 [ %"$phi652.2.2.i.3.i", %B652.i.i ], [ true, %B352.i.i ]
  %.1050.i.02125.i = phi i64 [ %.1115.i.i, %B652.i.i ], [ %.1060.i.i, %B352.i.i ]
  %.1047.i.02124.i = phi i64 [ %.1119.i.i, %B652.i.i ], [ %.991.i.i, %B352.i.i ]
  %.1115.i.i = add nsw i64 %.1050.i.02125.i, -1
  %.1119.i.i = add i64 %.1047.i.02124.i, 1
  br i1 %found.2.i.22126.i, label %B544.i.i, label %B652.i.i

B764.if.i.i:                                      ; preds = %B702.i.i, %B995.i.i
  %.1461.i.02140.i = phi i64 [ %.1523.i.i, %B995.i.i ], [ %.1471.i.i, %B702.i.i ]
  %.1458.i.02139.i = phi i64 [ %.1527.i.i, %B995.i.i ], [ %.1400.i.i, %B702.i.i ]
  %.1523.i.i = add nsw i64 %.1461.i.02140.i, -1
  %.1527.i.i = add i64 %.1458.i.02139.i, 1
  %.1571.i.i = icmp slt i64 %.1458.i.02139.i, 0
  %.1572.i.i = select i1 %.1571.i.i, i64 %arg.linear.7.5.0, i64 0
  %167 = getelementptr i64, ptr %arg.linear.7.4, i64 %.1458.i.02139.i
  %.1586.i.i = getelementptr i64, ptr %167, i64 %.1572.i.i
  %.1587.i.i = load i64, ptr %.1586.i.i, align 8, !noalias !28
  %.1588.i.i = add nsw i64 %.1587.i.i, %.915.i.i
  %.1602.i.i = icmp slt i64 %.1588.i.i, 0
  %.1603.i.i = select i1 %.1602.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %168 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1588.i.i
  %.1617.i.i = getelementptr double, ptr %168, i64 %.1603.i.i
  %.1618.i.i = load double, ptr %.1617.i.i, align 8, !noalias !28
  %.1636.i.i = select i1 %.1571.i.i, i64 %arg.linear.8.5.0, i64 0
  %169 = getelementptr i64, ptr %arg.linear.8.4, i64 %.1458.i.02139.i
  %.1650.i.i = getelementptr i64, ptr %169, i64 %.1636.i.i
  %.1651.i.i = load i64, ptr %.1650.i.i, align 8, !noalias !28
  %.1652.i.i = add nsw i64 %.1651.i.i, %.597.i.i.i
  %.1666.i.i = icmp slt i64 %.1652.i.i, 0
  %.1667.i.i = select i1 %.1666.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %170 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1652.i.i
  %.1681.i.i = getelementptr double, ptr %170, i64 %.1667.i.i
  %.1682.i.i = load double, ptr %.1681.i.i, align 8, !noalias !28
  %.1686.i.i = fdiv double %.1618.i.i, %.1682.i.i
  %.1692.i.i = fsub double %.1686.i.i, %.1686.i.i
  %.1693.i.i = fcmp oeq double %.1692.i.i, 0.000000e+00
  %.1686.i..i = select i1 %.1693.i.i, double %.1686.i.i, double 0.000000e+00
  %.1745.i.i = icmp eq i64 %.1651.i.i, %arg.shape.1
  br i1 %.1745.i.i, label %B920.i.i, label %B966.i.i

B116.i:                                           ; preds = %B228.i.loopexit.i, %B166.i.i, %B1294
  br i1 %.402.i, label %B146.if.i, label %B1334

B316.i:                                           ; preds = %B262.if.i, %B146.if.i
  %.746.i = mul i64 %.388.02152.i, %.434.sroa.0.02106.i
  %.762.i = icmp slt i64 %.746.i, 0
  %.763.i = select i1 %.762.i, i64 %arg.linear.1.5.0, i64 0
  %171 = getelementptr double, ptr %arg.linear.1.4, i64 %.746.i
  %.777.i = getelementptr double, ptr %171, i64 %.763.i
  %.778.i = load double, ptr %.777.i, align 8, !noalias !25
  %.832.i = load double, ptr %.831.i, align 8, !noalias !25
  %.833.i = fadd double %.778.i, %.832.i
  store double %.833.i, ptr %.777.i, align 8, !noalias !25
  %exitcond2158.not.i = icmp eq i64 %.457.i, %arg.shape.1
  br i1 %exitcond2158.not.i, label %B36.if.i.i, label %B146.if.i

B34.loopexit.i.i:                                 ; preds = %B790.i.i, %B528.i.i
  %exitcond.not.i.i = icmp eq i64 %.131.i.i, %arg.shape.1
  br i1 %exitcond.not.i.i, label %B1334, label %B36.if.i.i

B348.i.i:                                         ; preds = %B234.if.i.i, %B36.if.i.i
  %p.2.1.lcssa.i.i = phi i64 [ %.59.0509.i.i, %B36.if.i.i ], [ %p.3.2.i.i, %B234.if.i.i ]
  %172 = getelementptr i64, ptr %arg.linear.2.4, i64 %.59.0509.i.i
  store i64 %p.2.1.lcssa.i.i, ptr %172, align 8, !noalias !36
  %.547.i2114.i = add nsw i64 %p.2.1.lcssa.i.i, %.161.i.i
  %.561.i.i = icmp slt i64 %.547.i2114.i, 0
  %.562.i.i = select i1 %.561.i.i, i64 %arg.linear.1.5.0, i64 0
  %173 = getelementptr double, ptr %arg.linear.1.4, i64 %.547.i2114.i
  %.576.i.i = getelementptr double, ptr %173, i64 %.562.i.i
  %.577.i.i = load double, ptr %.576.i.i, align 8, !noalias !36
  %.610.i.i = load double, ptr %175, align 8, !noalias !36
  store double %.577.i.i, ptr %175, align 8, !noalias !36
  store double %.610.i.i, ptr %.576.i.i, align 8, !noalias !36
  br i1 %.362493.not.i.i, label %B528.i.i, label %B466.if.i.i

B528.i.i:                                         ; preds = %B466.if.i.i, %B348.i.i
  %.942.i.i = sub i64 %.11.i492.i.i, %.131.i.i
  %.985504.not.i.i = icmp slt i64 %.942.i.i, 1
  br i1 %.985504.not.i.i, label %B34.loopexit.i.i, label %B566.if.i.i

B790.i.i:                                         ; preds = %B716.if.i.i, %B566.if.i.i
  %.985.i.i = icmp sgt i64 %.932.0506.i.i, 1
  br i1 %.985.i.i, label %B566.if.i.i, label %B34.loopexit.i.i

B36.if.i.i:                                       ; preds = %B316.i, %B34.loopexit.i.i
  %.59.0509.i.i = phi i64 [ %.131.i.i, %B34.loopexit.i.i ], [ 0, %B316.i ]
  %.131.i.i = add nsw i64 %.59.0509.i.i, 1
  %.161.i.i = mul nsw i64 %.59.0509.i.i, %arg.shape.1
  %.164.i.i = add nsw i64 %.59.0509.i.i, %arg.linear.3.0
  %.165.i.i = add nsw i64 %.164.i.i, 1
  %.11.i.i.i10407 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.165.i.i, i64 %arg.shape.1)
  %.200.i.i = add i64 %.199.i.i, %.164.i.i
  %.11.i492.i.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.200.i.i, i64 %arg.shape.1)
  %174 = getelementptr double, ptr %arg.linear.1.4, i64 %.161.i.i
  %175 = getelementptr double, ptr %174, i64 %.59.0509.i.i
  %.319.i.i = sub i64 %.11.i.i.i10407, %.131.i.i
  %storemerge488.i.i = tail call i64 @llvm.smax.i64(i64 %.319.i.i, i64 0)
  %.362493.not.i.i = icmp slt i64 %.319.i.i, 1
  br i1 %.362493.not.i.i, label %B348.i.i, label %B234.if.preheader.i.i

B234.if.preheader.i.i:                            ; preds = %B36.if.i.i
  %.271.i.i = load double, ptr %175, align 8, !noalias !36
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
  %.430.i.i = select i1 %.429.i.i, i64 %arg.linear.1.5.0, i64 0
  %176 = getelementptr double, ptr %arg.linear.1.4, i64 %.415.i.i
  %.444.i.i = getelementptr double, ptr %176, i64 %.430.i.i
  %.445.i.i = load double, ptr %.444.i.i, align 8, !noalias !36
  %.446.i.i = tail call double @llvm.fabs.f64(double %.445.i.i)
  %.448.i.i = fcmp ogt double %.446.i.i, %largest.2.1496.i.i
  %largest.3.2.i.i = select i1 %.448.i.i, double %.446.i.i, double %largest.2.1496.i.i
  %p.3.2.i.i = select i1 %.448.i.i, i64 %.306.0494.i.i, i64 %p.2.1497.i.i
  %.362.i.i = icmp sgt i64 %.309.0495.i.i, 1
  br i1 %.362.i.i, label %B234.if.i.i, label %B348.i.i

B466.if.i.i:                                      ; preds = %B348.i.i, %B466.if.i.i
  %.706.0500.i.i = phi i64 [ %.768.i.i, %B466.if.i.i ], [ %storemerge488.i.i, %B348.i.i ]
  %.703.0499.i.i = phi i64 [ %.772.i.i, %B466.if.i.i ], [ %.131.i.i, %B348.i.i ]
  %.768.i.i = add nsw i64 %.706.0500.i.i, -1
  %.772.i.i = add i64 %.703.0499.i.i, 1
  %.798.i.i = add nsw i64 %.703.0499.i.i, %.161.i.i
  %.812.i.i = icmp slt i64 %.798.i.i, 0
  %.813.i.i = select i1 %.812.i.i, i64 %arg.linear.1.5.0, i64 0
  %177 = getelementptr double, ptr %arg.linear.1.4, i64 %.798.i.i
  %.827.i.i = getelementptr double, ptr %177, i64 %.813.i.i
  %.828.i.i = load double, ptr %.827.i.i, align 8, !noalias !36
  %.861.i.i = load double, ptr %175, align 8, !noalias !36
  %.865.i.i = fdiv double %.828.i.i, %.861.i.i
  store double %.865.i.i, ptr %.827.i.i, align 8, !noalias !36
  %.759.i.i = icmp sgt i64 %.706.0500.i.i, 1
  br i1 %.759.i.i, label %B466.if.i.i, label %B528.i.i

B566.if.i.i:                                      ; preds = %B528.i.i, %B790.i.i
  %.932.0506.i.i = phi i64 [ %.994.i.i, %B790.i.i ], [ %.942.i.i, %B528.i.i ]
  %.929.0505.i.i = phi i64 [ %.998.i.i, %B790.i.i ], [ %.131.i.i, %B528.i.i ]
  %.994.i.i = add nsw i64 %.932.0506.i.i, -1
  %.998.i.i = add i64 %.929.0505.i.i, 1
  %178 = mul nsw i64 %.929.0505.i.i, %arg.shape.1
  %.1030.i.i = add nsw i64 %178, %p.2.1.lcssa.i.i
  %.1044.i.i = icmp slt i64 %.1030.i.i, 0
  %.1045.i.i = select i1 %.1044.i.i, i64 %arg.linear.1.5.0, i64 0
  %179 = getelementptr double, ptr %arg.linear.1.4, i64 %.1030.i.i
  %.1059.i.i = getelementptr double, ptr %179, i64 %.1045.i.i
  %.1060.i2115.i = load double, ptr %.1059.i.i, align 8, !noalias !36
  %.1068.i.i = add nsw i64 %178, %.59.0509.i.i
  %.1082.i.i = icmp slt i64 %.1068.i.i, 0
  %.1083.i.i = select i1 %.1082.i.i, i64 %arg.linear.1.5.0, i64 0
  %180 = getelementptr double, ptr %arg.linear.1.4, i64 %.1068.i.i
  %.1097.i.i = getelementptr double, ptr %180, i64 %.1083.i.i
  %.1098.i.i = load double, ptr %.1097.i.i, align 8, !noalias !36
  store double %.1098.i.i, ptr %.1059.i.i, align 8, !noalias !36
  store double %.1060.i2115.i, ptr %.1097.i.i, align 8, !noalias !36
  %.1171.i.i = fcmp oeq double %.1060.i2115.i, 0.000000e+00
  %brmerge.i.i = or i1 %.362493.not.i.i, %.1171.i.i
  br i1 %brmerge.i.i, label %B790.i.i, label %B716.if.i.i

B716.if.i.i:                                      ; preds = %B566.if.i.i, %B716.if.i.i
  %.1202.0503.i.i = phi i64 [ %.1264.i.i, %B716.if.i.i ], [ %storemerge488.i.i, %B566.if.i.i ]
  %.1199.0502.i.i = phi i64 [ %.1268.i.i, %B716.if.i.i ], [ %.131.i.i, %B566.if.i.i ]
  %.1264.i.i = add nsw i64 %.1202.0503.i.i, -1
  %.1268.i.i = add i64 %.1199.0502.i.i, 1
  %.1296.i.i = add nsw i64 %.1199.0502.i.i, %178
  %.1310.i.i = icmp slt i64 %.1296.i.i, 0
  %.1311.i.i = select i1 %.1310.i.i, i64 %arg.linear.1.5.0, i64 0
  %181 = getelementptr double, ptr %arg.linear.1.4, i64 %.1296.i.i
  %.1325.i.i = getelementptr double, ptr %181, i64 %.1311.i.i
  %.1326.i.i = load double, ptr %.1325.i.i, align 8, !noalias !36
  %.1328.i.i = add nsw i64 %.1199.0502.i.i, %.161.i.i
  %.1342.i.i = icmp slt i64 %.1328.i.i, 0
  %.1343.i.i = select i1 %.1342.i.i, i64 %arg.linear.1.5.0, i64 0
  %182 = getelementptr double, ptr %arg.linear.1.4, i64 %.1328.i.i
  %.1357.i.i = getelementptr double, ptr %182, i64 %.1343.i.i
  %.1358.i.i = load double, ptr %.1357.i.i, align 8, !noalias !36
  %.1360.i.i = fmul double %.1060.i2115.i, %.1358.i.i
  %.1361.i.i = fsub double %.1326.i.i, %.1360.i.i
  store double %.1361.i.i, ptr %.1325.i.i, align 8, !noalias !36
  %.1255.i.i = icmp sgt i64 %.1202.0503.i.i, 1
  br i1 %.1255.i.i, label %B716.if.i.i, label %B790.i.i

B146.if.i:                                        ; preds = %B116.i, %B316.i
  %.388.02152.i = phi i64 [ %.457.i, %B316.i ], [ 0, %B116.i ]
  %.457.i = add nsw i64 %.388.02152.i, 1
  %.489.i = sub i64 %.388.02152.i, %31
  %.11.i.i10404 = tail call i64 @llvm.smax.i64(i64 %.489.i, i64 0)
  %.521.i = add i64 %.520.i, %.388.02152.i
  %.11.i2116.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.521.i, i64 %arg.shape.1)
  %.587.i = sub i64 %.11.i2116.i, %.11.i.i10404
  %.6302148.not.i = icmp slt i64 %.587.i, 1
  br i1 %.6302148.not.i, label %B316.i, label %B262.if.lr.ph.i

B262.if.lr.ph.i:                                  ; preds = %B146.if.i
  %.670.i = mul nsw i64 %.388.02152.i, %arg.shape.1
  br label %B262.if.i

B262.if.i:                                        ; preds = %B262.if.i, %B262.if.lr.ph.i
  %.577.02150.i = phi i64 [ %.587.i, %B262.if.lr.ph.i ], [ %.639.i, %B262.if.i ]
  %.574.02149.i = phi i64 [ %.11.i.i10404, %B262.if.lr.ph.i ], [ %.643.i10405, %B262.if.i ]
  %.639.i = add nsw i64 %.577.02150.i, -1
  %.643.i10405 = add i64 %.574.02149.i, 1
  %.671.i = add nsw i64 %.574.02149.i, %.670.i
  %.685.i = icmp slt i64 %.671.i, 0
  %.686.i = select i1 %.685.i, i64 %arg.linear.0.5.0, i64 0
  %183 = getelementptr double, ptr %arg.linear.0.4, i64 %.671.i
  %.700.i = getelementptr double, ptr %183, i64 %.686.i
  %.701.i10406 = load double, ptr %.700.i, align 8, !noalias !25
  %.702.i = fneg double %.701.i10406
  %.721.i = select i1 %.685.i, i64 %arg.linear.1.5.0, i64 0
  %184 = getelementptr double, ptr %arg.linear.1.4, i64 %.671.i
  %.735.i = getelementptr double, ptr %184, i64 %.721.i
  store double %.702.i, ptr %.735.i, align 8, !noalias !25
  %.630.i = icmp sgt i64 %.577.02150.i, 1
  br i1 %.630.i, label %B262.if.i, label %B316.i

B1334:                                            ; preds = %B34.loopexit.i.i, %B116.i, %B1290
  br i1 %.209310684.not, label %B1592, label %B1366.if

B68.if.lr.ph.i:                                   ; preds = %B1366.if
  %.259.i = mul nsw i64 %.2106, %arg.shape.1
  br label %B68.if.i

B34.i.loopexit.i:                                 ; preds = %B198.if.i.i, %B34.if.i.i10418
  %exitcond633.not.i = icmp eq i64 %arg.shape.1, %.144.i.i
  br i1 %exitcond633.not.i, label %B314.if.i.i, label %B34.if.i.i10418

B314.i.loopexit.i:                                ; preds = %B474.if.i.i, %B314.if.i.i
  %.683.i.i = icmp sgt i64 %.627.i.0629.in.i, 1
  br i1 %.683.i.i, label %B314.if.i.i, label %B286.if.lr.ph.i

B286.if.lr.ph.i:                                  ; preds = %B314.i.loopexit.i
  %.624.i = mul nsw i64 %.2106, %arg.shape.1
  br label %B286.if.i

B34.if.i.i10418:                                  ; preds = %B68.if.i, %B34.i.loopexit.i
  %.73.i.0621.i = phi i64 [ %.144.i.i, %B34.i.loopexit.i ], [ 0, %B68.if.i ]
  %.144.i.i = add nsw i64 %.73.i.0621.i, 1
  %185 = getelementptr i64, ptr %arg.linear.2.4, i64 %.73.i.0621.i
  %.202.i.i = load i64, ptr %185, align 8, !noalias !39
  %.204.i.i = add nsw i64 %.202.i.i, %.395.i
  %.218.i.i = icmp slt i64 %.204.i.i, 0
  %.219.i.i = select i1 %.218.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %186 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.204.i.i
  %.233.i.i = getelementptr double, ptr %186, i64 %.219.i.i
  %.234.i.i = load double, ptr %.233.i.i, align 8, !noalias !39
  %gep10683 = getelementptr double, ptr %invariant.gep10682, i64 %.73.i.0621.i
  %.270.i.i = load double, ptr %gep10683, align 8, !noalias !39
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !39
  store double %.234.i.i, ptr %gep10683, align 8, !noalias !39
  %.340.i.i = add i64 %.339.i.i, %.73.i.0621.i
  %.11.i.i.i10419 = tail call i64 @llvm.smin.i64(i64 %.340.i.i, i64 %arg.shape.1)
  %.406.i.i = sub i64 %.11.i.i.i10419, %.144.i.i
  %.449.i617.not.i = icmp slt i64 %.406.i.i, 1
  br i1 %.449.i617.not.i, label %B34.i.loopexit.i, label %B198.if.i.lr.ph.i

B198.if.i.lr.ph.i:                                ; preds = %B34.if.i.i10418
  %.521.i.i = mul nsw i64 %.73.i.0621.i, %arg.shape.1
  br label %B198.if.i.i

B198.if.i.i:                                      ; preds = %B198.if.i.i, %B198.if.i.lr.ph.i
  %.396.i.0619.i = phi i64 [ %.406.i.i, %B198.if.i.lr.ph.i ], [ %.458.i.i, %B198.if.i.i ]
  %.393.i.0618.i = phi i64 [ %.144.i.i, %B198.if.i.lr.ph.i ], [ %.462.i.i, %B198.if.i.i ]
  %.458.i.i = add nsw i64 %.396.i.0619.i, -1
  %.462.i.i = add i64 %.393.i.0618.i, 1
  %.488.i.i = add nsw i64 %.393.i.0618.i, %.395.i
  %.502.i.i = icmp slt i64 %.488.i.i, 0
  %.503.i.i = select i1 %.502.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %187 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.488.i.i
  %.517.i.i = getelementptr double, ptr %187, i64 %.503.i.i
  %.518.i.i = load double, ptr %.517.i.i, align 8, !noalias !39
  %.522.i.i = add nsw i64 %.393.i.0618.i, %.521.i.i
  %.536.i.i = icmp slt i64 %.522.i.i, 0
  %.537.i.i = select i1 %.536.i.i, i64 %arg.linear.1.5.0, i64 0
  %188 = getelementptr double, ptr %arg.linear.1.4, i64 %.522.i.i
  %.551.i.i = getelementptr double, ptr %188, i64 %.537.i.i
  %.552.i.i = load double, ptr %.551.i.i, align 8, !noalias !39
  %.554.i.i = fmul double %.234.i.i, %.552.i.i
  %.555.i.i = fsub double %.518.i.i, %.554.i.i
  store double %.555.i.i, ptr %.517.i.i, align 8, !noalias !39
  %.449.i.i = icmp sgt i64 %.396.i.0619.i, 1
  br i1 %.449.i.i, label %B198.if.i.i, label %B34.i.loopexit.i

B314.if.i.i:                                      ; preds = %B34.i.loopexit.i, %B314.i.loopexit.i
  %.627.i.0629.in.i = phi i64 [ %.627.i.0629.i, %B314.i.loopexit.i ], [ %arg.shape.1, %B34.i.loopexit.i ]
  %.627.i.0629.i = add nsw i64 %.627.i.0629.in.i, -1
  %.726.i.i = add nsw i64 %.627.i.0629.i, %.395.i
  %.740.i.i = icmp slt i64 %.726.i.i, 0
  %.741.i.i = select i1 %.740.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %189 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.726.i.i
  %.755.i.i10420 = getelementptr double, ptr %189, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i10420, align 8, !noalias !39
  %.759.i.i10421 = mul nsw i64 %.627.i.0629.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i10421, %.627.i.0629.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %arg.linear.1.5.0, i64 0
  %190 = getelementptr double, ptr %arg.linear.1.4, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %190, i64 %.776.i.i
  %.791.i.i = load double, ptr %.790.i.i, align 8, !noalias !39
  %.795.i.i = fdiv double %.756.i.i, %.791.i.i
  store double %.795.i.i, ptr %.755.i.i10420, align 8, !noalias !39
  %.866.i.i = sub i64 %.627.i.0629.i, %32
  %.11.i4.i.i = tail call i64 @llvm.smax.i64(i64 %.866.i.i, i64 0)
  %.932.i.i = sub i64 %.627.i.0629.i, %.11.i4.i.i
  %.975.i623.not.i = icmp slt i64 %.932.i.i, 1
  br i1 %.975.i623.not.i, label %B314.i.loopexit.i, label %B474.if.i.i

B474.if.i.i:                                      ; preds = %B314.if.i.i, %B474.if.i.i
  %.922.i.0625.i = phi i64 [ %.984.i.i, %B474.if.i.i ], [ %.932.i.i, %B314.if.i.i ]
  %.919.i.0624.i = phi i64 [ %.988.i.i, %B474.if.i.i ], [ %.11.i4.i.i, %B314.if.i.i ]
  %.984.i.i = add nsw i64 %.922.i.0625.i, -1
  %.988.i.i = add i64 %.919.i.0624.i, 1
  %.1014.i.i = add nsw i64 %.919.i.0624.i, %.395.i
  %.1028.i.i = icmp slt i64 %.1014.i.i, 0
  %.1029.i.i = select i1 %.1028.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %191 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1014.i.i
  %.1043.i.i = getelementptr double, ptr %191, i64 %.1029.i.i
  %.1044.i.i10422 = load double, ptr %.1043.i.i, align 8, !noalias !39
  %.1048.i.i = add nsw i64 %.919.i.0624.i, %.759.i.i10421
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %arg.linear.1.5.0, i64 0
  %192 = getelementptr double, ptr %arg.linear.1.4, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %192, i64 %.1063.i.i
  %.1078.i.i = load double, ptr %.1077.i.i, align 8, !noalias !39
  %.1080.i.i = fmul double %.795.i.i, %.1078.i.i
  %.1081.i.i = fsub double %.1044.i.i10422, %.1080.i.i
  store double %.1081.i.i, ptr %.1043.i.i, align 8, !noalias !39
  %.975.i.i10423 = icmp sgt i64 %.922.i.0625.i, 1
  br i1 %.975.i.i10423, label %B474.if.i.i, label %B314.i.loopexit.i

B68.if.i:                                         ; preds = %B68.if.i, %B68.if.lr.ph.i
  %.160.0615.i = phi i64 [ 0, %B68.if.lr.ph.i ], [ %.231.i, %B68.if.i ]
  %.231.i = add nsw i64 %.160.0615.i, 1
  %.260.i = add nsw i64 %.160.0615.i, %.259.i
  %.274.i = icmp slt i64 %.260.i, 0
  %.275.i10412 = select i1 %.274.i, i64 %arg.batch.5.0.5.0, i64 0
  %193 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.260.i
  %.289.i = getelementptr double, ptr %193, i64 %.275.i10412
  %.290.i = load double, ptr %.289.i, align 8, !noalias !45
  %gep10681 = getelementptr double, ptr %invariant.gep10680, i64 %.160.0615.i
  %.323.i10414 = load double, ptr %gep10681, align 8, !noalias !45
  %.324.i10415 = fadd double %.290.i, %.323.i10414
  %194 = getelementptr i64, ptr %arg.linear.4.4, i64 %.160.0615.i
  %.356.i = load i64, ptr %194, align 8, !noalias !45
  %.357.i = add nsw i64 %.356.i, %.326.i10411
  %.371.i = icmp slt i64 %.357.i, 0
  %.372.i10416 = select i1 %.371.i, i64 %arg.batch.5.0.5.0, i64 0
  %195 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.357.i
  %.386.i = getelementptr double, ptr %195, i64 %.372.i10416
  store double %.324.i10415, ptr %.386.i, align 8, !noalias !45
  %exitcond.not.i10417 = icmp eq i64 %arg.shape.1, %.231.i
  br i1 %exitcond.not.i10417, label %B34.if.i.i10418, label %B68.if.i

B286.if.i:                                        ; preds = %B286.if.i, %B286.if.lr.ph.i
  %.464.0631.i = phi i64 [ 0, %B286.if.lr.ph.i ], [ %.533.i, %B286.if.i ]
  %.533.i = add nsw i64 %.464.0631.i, 1
  %196 = getelementptr i64, ptr %arg.linear.4.4, i64 %.464.0631.i
  %.589.i = load i64, ptr %196, align 8, !noalias !45
  %.590.i = add nsw i64 %.589.i, %.395.i
  %.604.i = icmp slt i64 %.590.i, 0
  %.605.i10424 = select i1 %.604.i, i64 %arg.batch.5.0.5.0, i64 0
  %197 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.590.i
  %.619.i = getelementptr double, ptr %197, i64 %.605.i10424
  %.620.i = load double, ptr %.619.i, align 8, !noalias !45
  %.625.i = add nsw i64 %.464.0631.i, %.624.i
  %.639.i10425 = icmp slt i64 %.625.i, 0
  %.640.i = select i1 %.639.i10425, i64 %arg.batch.5.0.5.0, i64 0
  %198 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.i
  %.654.i10426 = getelementptr double, ptr %198, i64 %.640.i
  store double %.620.i, ptr %.654.i10426, align 8, !noalias !45
  %exitcond634.not.i = icmp eq i64 %arg.shape.1, %.533.i
  br i1 %exitcond634.not.i, label %B1590, label %B286.if.i

B1590:                                            ; preds = %B286.if.i, %B1366.if
  %exitcond10875.not = icmp eq i64 %.2037.010685, %storemerge10288
  br i1 %exitcond10875.not, label %B1592, label %B1366.if

B1592:                                            ; preds = %B1590, %B1334
  %.2387 = load i64, ptr %.2386, align 8
  %.2432 = inttoptr i64 %.2387 to ptr
  tail call void %.2432(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %brmerge = select i1 %.1039, i1 true, i1 %.610
  %or.cond10373 = select i1 %brmerge, i1 true, i1 %.2463
  %spec.select10394 = select i1 %or.cond10373, i1 true, i1 %.2468
  br i1 %.665, label %B1824, label %B1734.if

B1742:                                            ; preds = %B1734.if
  %199 = getelementptr double, ptr %33, i64 %.2508.010688
  %.2667 = load double, ptr %199, align 8
  %.2668 = fcmp ogt double %.2667, 5.000000e-01
  br label %B1778

B1778:                                            ; preds = %B1742, %B1734.if
  %"$phi1778.1.2.2" = phi i1 [ true, %B1734.if ], [ %.2668, %B1742 ]
  br i1 %looked.2.110691, label %B1820, label %B1784

B1784:                                            ; preds = %B1778
  %200 = getelementptr double, ptr %34, i64 %.2508.010688
  %.2742 = load double, ptr %200, align 8
  %.2743 = fcmp ogt double %.2742, 5.000000e-01
  br label %B1820

B1820:                                            ; preds = %B1784, %B1778
  %"$phi1820.1.2.2" = phi i1 [ true, %B1778 ], [ %.2743, %B1784 ]
  %.2564 = icmp sgt i64 %.2511.010689, 1
  br i1 %.2564, label %B1734.if, label %B1824

B1824:                                            ; preds = %B1820, %B1592
  %good.2.1.lcssa = phi i1 [ false, %B1592 ], [ %"$phi1778.1.2.2", %B1820 ]
  %looked.2.1.lcssa = phi i1 [ %spec.select10394, %B1592 ], [ %"$phi1820.1.2.2", %B1820 ]
  %looked.2.1.lcssa.not10886 = xor i1 %looked.2.1.lcssa, true
  %brmerge10887 = or i1 %.665, %looked.2.1.lcssa.not10886
  br i1 %brmerge10887, label %B2402, label %B80.if.i

B1894.preheader:                                  ; preds = %B502.i
  br i1 %.665, label %B2402, label %B1894.if

B126.i:                                           ; preds = %B80.if.i
  %.318.i590 = getelementptr double, ptr %35, i64 %.105.i437.010695
  %.319.i591 = load double, ptr %.318.i590, align 8, !noalias !46
  %.5.i.i = fptosi double %.319.i591 to i64
  %.397.i = getelementptr double, ptr %36, i64 %.105.i437.010695
  %.398.i635 = load double, ptr %.397.i, align 8, !noalias !46
  %.5.i1.i = fptosi double %.398.i635 to i64
  %.472.i681 = mul i64 %.258.i545, %arg.batch.3.3.5.1
  %.476.i685 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.472.i681
  %.477.i686 = load i64, ptr %.476.i685, align 8, !noalias !46
  %.478.i687 = add nsw i64 %.477.i686, %.5.i.i
  store i64 %.478.i687, ptr %.476.i685, align 8, !noalias !46
  %.584.i768 = getelementptr i8, ptr %.476.i685, i64 24
  %.585.i769 = load i64, ptr %.584.i768, align 8, !noalias !46
  %.586.i770 = add nsw i64 %.585.i769, %.5.i1.i
  store i64 %.586.i770, ptr %.584.i768, align 8, !noalias !46
  %.694.i857 = getelementptr i8, ptr %.476.i685, i64 8
  %.695.i858 = load i64, ptr %.694.i857, align 8, !noalias !46
  %.698.i861 = add nsw i64 %.5.i1.i, %.5.i.i
  %.699.i = mul nsw i64 %.698.i861, %.2050
  %.700.i862 = add nsw i64 %.699.i, %.5.i.i
  %.701.i = add nsw i64 %.700.i862, %.695.i858
  store i64 %.701.i, ptr %.694.i857, align 8, !noalias !46
  store double 0.000000e+00, ptr %.318.i590, align 8, !noalias !46
  store double 0.000000e+00, ptr %.397.i, align 8, !noalias !46
  %.923.i = getelementptr double, ptr %37, i64 %.105.i437.010695
  %.924.i1016 = load double, ptr %.923.i, align 8, !noalias !46
  %.926.i = sitofp i64 %.698.i861 to double
  %.927.i = fsub double %.924.i1016, %.926.i
  store double %.927.i, ptr %.923.i, align 8, !noalias !46
  br label %B502.i

B502.i:                                           ; preds = %B126.i, %B80.if.i
  %.163.i494 = icmp sgt i64 %.108.i438.010696, 1
  br i1 %.163.i494, label %B80.if.i, label %B1894.preheader

B80.if.i:                                         ; preds = %B1824, %B502.i
  %.108.i438.010696 = phi i64 [ %.172.i1046, %B502.i ], [ %storemerge, %B1824 ]
  %.105.i437.010695 = phi i64 [ %.176.i, %B502.i ], [ 0, %B1824 ]
  %.172.i1046 = add nsw i64 %.108.i438.010696, -1
  %.176.i = add nsw i64 %.105.i437.010695, 1
  %201 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i437.010695
  %.258.i545 = load i64, ptr %201, align 8, !noalias !46
  %.263.i = icmp sgt i64 %.258.i545, -1
  br i1 %.263.i, label %B126.i, label %B502.i

B1994:                                            ; preds = %B1894.if
  %.3197 = getelementptr double, ptr %40, i64 %.2863.010698
  %.3198 = load double, ptr %.3197, align 8
  %.3199 = fcmp ogt double %.3198, 5.000000e-01
  br i1 %.3199, label %B2032, label %B2132

B2032:                                            ; preds = %B1994
  %.5.i = fptosi double %.3198 to i64
  %202 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2863.010698
  %.84.i1916 = load i64, ptr %202, align 8, !noalias !50
  %.89.i1919 = icmp sgt i64 %.84.i1916, -1
  br i1 %.89.i1919, label %B46.i, label %B2132

B2132:                                            ; preds = %B1994, %B46.i, %B2032, %B80.i1953
  %.3385 = getelementptr double, ptr %41, i64 %.2863.010698
  %.3386 = load double, ptr %.3385, align 8
  %.3387 = fcmp ogt double %.3386, 5.000000e-01
  br i1 %.3387, label %B2170, label %B2400

B2170:                                            ; preds = %B2132
  %spec.select = select i1 %within.3.210700, i1 true, i1 %.2463
  %.3463 = mul i64 %.3024, %arg.batch.3.3.5.1
  %.3467 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.3463
  %.3468 = load i64, ptr %.3467, align 8
  %.3479.0 = and i64 %.3468, 127
  %.3509 = icmp eq i64 %.3479.0, 0
  br i1 %.3509, label %B2278, label %B2240

B2240:                                            ; preds = %B2170
  %.3570 = getelementptr double, ptr %42, i64 %.2863.010698
  %.3571 = load double, ptr %.3570, align 8
  %.3573 = fcmp ogt double %.3571, 0.000000e+00
  br i1 %.3573, label %B2278, label %B2308

B2278:                                            ; preds = %B2170, %B2240
  store double 1.000000e+00, ptr %.3139, align 8
  br label %B2308

B2308:                                            ; preds = %B2278, %B2240
  %doubted.5.5 = phi i1 [ true, %B2278 ], [ %doubted.3.210701, %B2240 ]
  %.3656 = icmp slt i64 %.3079, %arg.batch.2.5.0
  br i1 %.3656, label %B2346, label %B2400

B2346:                                            ; preds = %B2308
  %.3680 = icmp slt i64 %.3079, 0
  %.3681 = select i1 %.3680, i64 %arg.batch.2.5.0, i64 0
  %203 = getelementptr double, ptr %arg.batch.2.4, i64 %.3079
  %.3695 = getelementptr double, ptr %203, i64 %.3681
  %.3696 = load double, ptr %.3695, align 8
  %.3754 = getelementptr double, ptr %43, i64 %.2863.010698
  %.3755 = load double, ptr %.3754, align 8
  %.3756 = fcmp olt double %.3696, %.3755
  br i1 %.3756, label %B2396, label %B2400

B2396:                                            ; preds = %B2346
  br label %B2400

B2400:                                            ; preds = %B1894.if, %B2396, %B2346, %B2308, %B2132
  %within.4.3 = phi i1 [ true, %B2396 ], [ %spec.select, %B2346 ], [ %spec.select, %B2308 ], [ %within.3.210700, %B2132 ], [ %within.3.210700, %B1894.if ]
  %doubted.4.3 = phi i1 [ %doubted.5.5, %B2396 ], [ %doubted.5.5, %B2346 ], [ %doubted.5.5, %B2308 ], [ %doubted.3.210701, %B2132 ], [ %doubted.3.210701, %B1894.if ]
  %.2925 = icmp sgt i64 %.2866.010699, 1
  br i1 %.2925, label %B1894.if, label %B2402.loopexit

B2402.loopexit:                                   ; preds = %B2400
  %204 = xor i1 %doubted.4.3, true
  %205 = select i1 %204, i1 true, i1 %.614
  br label %B2402

B2402:                                            ; preds = %B1824, %B2402.loopexit, %B1894.preheader
  %within.5.1 = phi i1 [ false, %B1824 ], [ false, %B1894.preheader ], [ %within.4.3, %B2402.loopexit ]
  %doubted.2.1 = phi i1 [ true, %B1824 ], [ true, %B1894.preheader ], [ %205, %B2402.loopexit ]
  %brmerge10374.not = select i1 %good.2.1.lcssa, i1 %.612.not, i1 false
  br i1 %brmerge10374.not, label %B2410, label %B2526

B2410:                                            ; preds = %B2402
  %.3832 = load i64, ptr %arg.code.4, align 8
  %.3882 = inttoptr i64 %.3832 to ptr
  tail call void %.3882(ptr %.571, ptr %.3856, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.3881)
  br label %B2526

B2526:                                            ; preds = %B2402, %B2410
  br i1 %doubted.2.1, label %B2602, label %B2534

B2534:                                            ; preds = %B2526
  %.3920 = load i64, ptr %.3919, align 8
  %.3965 = inttoptr i64 %.3920 to ptr
  tail call void %.3965(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B2602

B2602:                                            ; preds = %B2526, %B2534
  %206 = select i1 %.2468, i1 %good.2.1.lcssa, i1 false
  br i1 %206, label %B2622, label %B2728

B2622:                                            ; preds = %B2602
  %.4014 = load i64, ptr %.4013, align 8
  %.4059 = inttoptr i64 %.4014 to ptr
  tail call void %.4059(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.665, label %B188.if.i.preheader, label %B108.if.i

B186.i.loopexit.critedge:                         ; preds = %B188.if.i
  %.625.i2308.c = icmp ult i64 %.361.i2111.010721, 8
  %.10378.c = select i1 %.625.i2308.c, i64 16, i64 17
  %.672.i2338.c = load i64, ptr %.671.i2337, align 8, !noalias !53
  %.744.i2393.c = mul i64 %.742.i2391, %.10378.c
  %.762.i2401.c = getelementptr double, ptr %arg.batch.5.0.4, i64 %.744.i2393.c
  %.788.i2411.c = inttoptr i64 %.672.i2338.c to ptr
  tail call void %.788.i2411.c(ptr %.571, ptr %.762.i2401.c, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !53
  br label %B186.i.loopexit

B186.i.loopexit:                                  ; preds = %B770.i, %B186.i.loopexit.critedge
  %some.2.i.1.lcssa = phi i1 [ %some.4.i.010723, %B186.i.loopexit.critedge ], [ %some.3.i.2, %B770.i ]
  %exitcond10878.not = icmp eq i64 %.431.i2895, 9
  br i1 %exitcond10878.not, label %B806.i.preheader, label %B188.if.i

B806.i.preheader:                                 ; preds = %B186.i.loopexit
  br i1 %.665, label %B2728, label %B806.if.i

B222.i.loopexit:                                  ; preds = %B122.if.i.i, %B222.if.i
  %.539.i2299 = icmp sgt i64 %.486.i2121.010715, 1
  br i1 %.539.i2299, label %B222.if.i, label %B284.i

B284.i:                                           ; preds = %B222.i.loopexit
  %.625.i2308 = icmp ult i64 %.361.i2111.010721, 8
  %.10378 = select i1 %.625.i2308, i64 16, i64 17
  %.672.i2338 = load i64, ptr %.671.i2337, align 8, !noalias !53
  %.744.i2393 = mul i64 %.742.i2391, %.10378
  %.762.i2401 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.744.i2393
  %.788.i2411 = inttoptr i64 %.672.i2338 to ptr
  tail call void %.788.i2411(ptr %.571, ptr %.762.i2401, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !53
  %.1181.i = add nsw i64 %.361.i2111.010721, -1
  %.1182.i2620 = sitofp i64 %.1181.i to double
  %.1187.i = fmul double %.1182.i2620, 1.250000e-01
  %.1189.i = uitofp i64 %.361.i2111.010721 to double
  %.1194.i = fmul double %.1189.i, 1.250000e-01
  br label %B466.if.i

B508.i:                                           ; preds = %B466.if.i
  %.1028.i = getelementptr double, ptr %46, i64 %.814.i2139.010717
  %.1029.i2519 = load double, ptr %.1028.i, align 8, !noalias !53
  %.1030.i = fcmp ogt double %.1029.i2519, 5.000000e-01
  br i1 %.1030.i, label %B546.i, label %B770.i

B546.i:                                           ; preds = %B508.i
  %.1088.i2554 = getelementptr i64, ptr %47, i64 %.814.i2139.010717
  %.1089.i2555 = load i64, ptr %.1088.i2554, align 8, !noalias !53
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
  %.153.i56.i = add nsw i64 %.151.i55.i, %.814.i2139.010717
  %.167.i61.i = icmp slt i64 %.153.i56.i, 0
  %.168.i62.i = select i1 %.167.i61.i, i64 %arg.batch.5.4.5.0, i64 0
  %207 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i56.i
  %.182.i74.i = getelementptr double, ptr %207, i64 %.168.i62.i
  %.183.i75.i = load double, ptr %.182.i74.i, align 8, !noalias !57
  %.184.i.i = fcmp ogt double %.183.i75.i, 5.000000e-01
  br i1 %.184.i.i, label %B584.endif.i, label %B34.i.i

B732.i:                                           ; preds = %B584.endif.i
  %.1369.i = load i64, ptr %.1088.i2554, align 8, !noalias !53
  %.1370.i = icmp sgt i64 %.1369.i, -1
  br label %B770.i

B770.i:                                           ; preds = %B732.i, %B584.endif.i, %B546.i, %B508.i, %B466.if.i
  %some.3.i.2 = phi i1 [ %some.2.i.110719, %B466.if.i ], [ %some.2.i.110719, %B546.i ], [ %some.2.i.110719, %B508.i ], [ true, %B584.endif.i ], [ %.1370.i, %B732.i ]
  %.870.i2443 = icmp sgt i64 %.817.i2140.010718, 1
  br i1 %.870.i2443, label %B466.if.i, label %B186.i.loopexit

B108.if.i:                                        ; preds = %B2622, %B108.if.i
  %.179.i2101.010706 = phi i64 [ %.243.i2953, %B108.if.i ], [ %storemerge, %B2622 ]
  %.176.i2100.010705 = phi i64 [ %.247.i2955, %B108.if.i ], [ 0, %B2622 ]
  %.243.i2953 = add nsw i64 %.179.i2101.010706, -1
  %.247.i2955 = add nsw i64 %.176.i2100.010705, 1
  %208 = getelementptr i64, ptr %44, i64 %.176.i2100.010705
  store i64 -1, ptr %208, align 8, !noalias !53
  %.234.i2211 = icmp sgt i64 %.179.i2101.010706, 1
  br i1 %.234.i2211, label %B108.if.i, label %B188.if.i.preheader

B188.if.i.preheader:                              ; preds = %B108.if.i, %B2622
  br label %B188.if.i

B188.if.i:                                        ; preds = %B188.if.i.preheader, %B186.i.loopexit
  %some.4.i.010723 = phi i1 [ %some.2.i.1.lcssa, %B186.i.loopexit ], [ false, %B188.if.i.preheader ]
  %.361.i2111.010721 = phi i64 [ %.431.i2895, %B186.i.loopexit ], [ 1, %B188.if.i.preheader ]
  %.431.i2895 = add nsw i64 %.361.i2111.010721, 1
  br i1 %.665, label %B186.i.loopexit.critedge, label %B222.if.i.lr.ph

B222.if.i.lr.ph:                                  ; preds = %B188.if.i
  %.579.i2656 = uitofp i64 %.361.i2111.010721 to double
  %.584.i2657 = fmul double %.579.i2656, 1.250000e-01
  %.247.i.i.i = fsub double 1.000000e+00, %.584.i2657
  br label %B222.if.i

B222.if.i:                                        ; preds = %B222.if.i.lr.ph, %B222.i.loopexit
  %.486.i2121.010715 = phi i64 [ %storemerge, %B222.if.i.lr.ph ], [ %.548.i2879, %B222.i.loopexit ]
  %.483.i2120.010714 = phi i64 [ 0, %B222.if.i.lr.ph ], [ %.552.i2882, %B222.i.loopexit ]
  %.548.i2879 = add nsw i64 %.486.i2121.010715, -1
  %.552.i2882 = add nsw i64 %.483.i2120.010714, 1
  %.92.i.i2732 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.483.i2120.010714
  %.93.i.i2733 = load double, ptr %.92.i.i2732, align 8, !noalias !61
  %.146.i.i2767 = getelementptr double, ptr %45, i64 %.483.i2120.010714
  %.147.i.i2768 = load double, ptr %.146.i.i2767, align 8, !noalias !61
  %.149.i.i2770 = fmul double %.584.i2657, %.147.i.i2768
  %.150.i.i2771 = fadd double %.93.i.i2733, %.149.i.i2770
  %.203.i.i2798 = getelementptr double, ptr %.571, i64 %.483.i2120.010714
  store double %.150.i.i2771, ptr %.203.i.i2798, align 8, !noalias !61
  br i1 %.287.i.i10710.not, label %B222.i.loopexit, label %B122.if.i.i.preheader

B122.if.i.i.preheader:                            ; preds = %B222.if.i
  %invariant.gep10900 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010714
  %invariant.gep10902 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010714
  %invariant.gep10904 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010714
  %invariant.gep10906 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010714
  %invariant.gep10908 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010714
  %invariant.gep10910 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010714
  %invariant.gep10912 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010714
  %invariant.gep10914 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010714
  %invariant.gep10916 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2120.010714
  br label %B122.if.i.i

B122.if.i.i:                                      ; preds = %B122.if.i.i.preheader, %B122.if.i.i
  %.229.i.i.010711 = phi i64 [ %.300.i.i2869, %B122.if.i.i ], [ 0, %B122.if.i.i.preheader ]
  %.157.i.i.i = add nsw i64 %.155.i.i.i, %.229.i.i.010711
  %.159.i.i.i = mul nsw i64 %.157.i.i.i, %arg.shape.0
  %gep10901 = getelementptr double, ptr %invariant.gep10900, i64 %.159.i.i.i
  %.191.i.i.i = load double, ptr %gep10901, align 8, !noalias !65
  %.193.i.i.i = fadd double %.191.i.i.i, 0.000000e+00
  %.253.i.i.i = fmul double %.584.i2657, %.193.i.i.i
  %.157.i.i.i.1 = add nsw i64 %.155.i.i.i.1, %.229.i.i.010711
  %.159.i.i.i.1 = mul nsw i64 %.157.i.i.i.1, %arg.shape.0
  %gep10903 = getelementptr double, ptr %invariant.gep10902, i64 %.159.i.i.i.1
  %.191.i.i.i.1 = load double, ptr %gep10903, align 8, !noalias !65
  %.193.i.i.i.1 = fadd double %.253.i.i.i, %.191.i.i.i.1
  %.253.i.i.i.1 = fmul double %.247.i.i.i, %.193.i.i.i.1
  %.157.i.i.i.2 = add nsw i64 %.155.i.i.i.2, %.229.i.i.010711
  %.159.i.i.i.2 = mul nsw i64 %.157.i.i.i.2, %arg.shape.0
  %gep10905 = getelementptr double, ptr %invariant.gep10904, i64 %.159.i.i.i.2
  %.191.i.i.i.2 = load double, ptr %gep10905, align 8, !noalias !65
  %.193.i.i.i.2 = fadd double %.253.i.i.i.1, %.191.i.i.i.2
  %.253.i.i.i.2 = fmul double %.584.i2657, %.193.i.i.i.2
  %.157.i.i.i.3 = add nsw i64 %.155.i.i.i.3, %.229.i.i.010711
  %.159.i.i.i.3 = mul nsw i64 %.157.i.i.i.3, %arg.shape.0
  %gep10907 = getelementptr double, ptr %invariant.gep10906, i64 %.159.i.i.i.3
  %.191.i.i.i.3 = load double, ptr %gep10907, align 8, !noalias !65
  %.193.i.i.i.3 = fadd double %.253.i.i.i.2, %.191.i.i.i.3
  %.253.i.i.i.3 = fmul double %.247.i.i.i, %.193.i.i.i.3
  %.157.i.i.i.4 = add nsw i64 %.155.i.i.i.4, %.229.i.i.010711
  %.159.i.i.i.4 = mul nsw i64 %.157.i.i.i.4, %arg.shape.0
  %gep10909 = getelementptr double, ptr %invariant.gep10908, i64 %.159.i.i.i.4
  %.191.i.i.i.4 = load double, ptr %gep10909, align 8, !noalias !65
  %.193.i.i.i.4 = fadd double %.253.i.i.i.3, %.191.i.i.i.4
  %.253.i.i.i.4 = fmul double %.584.i2657, %.193.i.i.i.4
  %.157.i.i.i.5 = add nsw i64 %.155.i.i.i.5, %.229.i.i.010711
  %.159.i.i.i.5 = mul nsw i64 %.157.i.i.i.5, %arg.shape.0
  %gep10911 = getelementptr double, ptr %invariant.gep10910, i64 %.159.i.i.i.5
  %.191.i.i.i.5 = load double, ptr %gep10911, align 8, !noalias !65
  %.193.i.i.i.5 = fadd double %.253.i.i.i.4, %.191.i.i.i.5
  %.253.i.i.i.5 = fmul double %.247.i.i.i, %.193.i.i.i.5
  %.157.i.i.i.6 = add nsw i64 %.155.i.i.i.6, %.229.i.i.010711
  %.159.i.i.i.6 = mul nsw i64 %.157.i.i.i.6, %arg.shape.0
  %gep10913 = getelementptr double, ptr %invariant.gep10912, i64 %.159.i.i.i.6
  %.191.i.i.i.6 = load double, ptr %gep10913, align 8, !noalias !65
  %.193.i.i.i.6 = fadd double %.253.i.i.i.5, %.191.i.i.i.6
  %.253.i.i.i.6 = fmul double %.584.i2657, %.193.i.i.i.6
  %.300.i.i2869 = add nsw i64 %.229.i.i.010711, 1
  %.271.i.i.i = mul nsw i64 %.229.i.i.010711, %arg.shape.0
  %gep10915 = getelementptr double, ptr %invariant.gep10914, i64 %.271.i.i.i
  %.309.i.i.i = load double, ptr %gep10915, align 8, !noalias !65
  %.313.i.i.i = fadd double %.253.i.i.i.6, %.309.i.i.i
  %.359.i.i2848 = add nsw i64 %.229.i.i.010711, %.358.i.i
  %.361.i.i2849 = mul nsw i64 %.359.i.i2848, %arg.shape.0
  %gep10917 = getelementptr double, ptr %invariant.gep10916, i64 %.361.i.i2849
  store double %.313.i.i.i, ptr %gep10917, align 8, !noalias !61
  %exitcond10877.not = icmp eq i64 %arg.shape.1, %.300.i.i2869
  br i1 %exitcond10877.not, label %B222.i.loopexit, label %B122.if.i.i

B466.if.i:                                        ; preds = %B284.i, %B770.i
  %some.2.i.110719 = phi i1 [ %some.4.i.010723, %B284.i ], [ %some.3.i.2, %B770.i ]
  %.817.i2140.010718 = phi i64 [ %storemerge, %B284.i ], [ %.879.i2640, %B770.i ]
  %.814.i2139.010717 = phi i64 [ 0, %B284.i ], [ %.883.i2643, %B770.i ]
  %.879.i2640 = add nsw i64 %.817.i2140.010718, -1
  %.883.i2643 = add nsw i64 %.814.i2139.010717, 1
  %.968.i2494 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.814.i2139.010717
  %.969.i2495 = load i64, ptr %.968.i2494, align 8, !noalias !53
  %.970.i2496 = icmp sgt i64 %.969.i2495, -1
  br i1 %.970.i2496, label %B508.i, label %B770.i

B584.endif.i:                                     ; preds = %B36.i.i, %B34.i.i
  %.1099.i2147.0 = phi i64 [ %.48.i.i1982.0, %B36.i.i ], [ -1, %B34.i.i ]
  store i64 %.1099.i2147.0, ptr %.1088.i2554, align 8, !noalias !53
  %.1248.i = getelementptr double, ptr %48, i64 %.814.i2139.010717
  store double %.1187.i, ptr %.1248.i, align 8, !noalias !53
  %.1303.i = getelementptr double, ptr %49, i64 %.814.i2139.010717
  store double %.1194.i, ptr %.1303.i, align 8, !noalias !53
  br i1 %some.2.i.110719, label %B770.i, label %B732.i

B806.if.i:                                        ; preds = %B806.i.preheader, %B806.if.i
  %.1453.i.010726 = phi i64 [ %.1515.i, %B806.if.i ], [ %storemerge, %B806.i.preheader ]
  %.1450.i.010725 = phi i64 [ %.1519.i, %B806.if.i ], [ 0, %B806.i.preheader ]
  %.1515.i = add nsw i64 %.1453.i.010726, -1
  %.1519.i = add nsw i64 %.1450.i.010725, 1
  %.1596.i = getelementptr double, ptr %50, i64 %.1450.i.010725
  %.1597.i = load double, ptr %.1596.i, align 8, !noalias !53
  %.1650.i = getelementptr double, ptr %.571, i64 %.1450.i.010725
  store double %.1597.i, ptr %.1650.i, align 8, !noalias !53
  %.1506.i = icmp sgt i64 %.1453.i.010726, 1
  br i1 %.1506.i, label %B806.if.i, label %B2728

B2728:                                            ; preds = %B806.if.i, %B806.i.preheader, %B2602
  %beyond.2.1 = phi i1 [ false, %B2602 ], [ %some.2.i.1.lcssa, %B806.i.preheader ], [ %some.2.i.1.lcssa, %B806.if.i ]
  %brmerge10379 = select i1 %within.5.1, i1 true, i1 %beyond.2.1
  br i1 %brmerge10379, label %B2738, label %B3300

B2738:                                            ; preds = %B2728
  br i1 %.614, label %B3154.critedge, label %B2786.if

B140.i:                                           ; preds = %B64.if.i5797
  %.409.i = getelementptr double, ptr %52, i64 %.138.i4903.010731
  %.410.i = load double, ptr %.409.i, align 8, !noalias !69
  %.411.i5133 = fcmp uge double %.410.i, 5.000000e-01
  %.424.i5140.not = icmp slt i64 %.346.i5082, %arg.batch.2.5.0
  %or.cond10380 = select i1 %.411.i5133, i1 %.424.i5140.not, i1 false
  br i1 %or.cond10380, label %B216.i, label %B453.i

B216.i:                                           ; preds = %B140.i
  %.440.i5151 = icmp slt i64 %.346.i5082, 0
  %.441.i5152 = select i1 %.440.i5151, i64 %arg.batch.2.5.0, i64 0
  %209 = getelementptr double, ptr %arg.batch.2.4, i64 %.346.i5082
  %.455.i5166 = getelementptr double, ptr %209, i64 %.441.i5152
  %.456.i5167 = load double, ptr %.455.i5166, align 8, !noalias !69
  %.510.i5213 = getelementptr double, ptr %53, i64 %.138.i4903.010731
  %.511.i5214 = load double, ptr %.510.i5213, align 8, !noalias !69
  %.512.i5215 = fcmp ult double %.456.i5167, %.511.i5214
  br i1 %.512.i5215, label %B268.i5216, label %B453.i

B268.i5216:                                       ; preds = %B216.i
  %.574.i5263 = getelementptr double, ptr %54, i64 %.138.i4903.010731
  %.575.i5264 = load double, ptr %.574.i5263, align 8, !noalias !69
  %.576.i5265 = fcmp ogt double %.575.i5264, 1.000000e+00
  br i1 %.576.i5265, label %B306.i5269, label %B453.i

B306.i5269:                                       ; preds = %B268.i5216
  %.632.i = getelementptr double, ptr %55, i64 %.138.i4903.010731
  %.633.i5316 = load double, ptr %.632.i, align 8, !noalias !69
  store double 0.000000e+00, ptr %.409.i, align 8, !noalias !73
  %.161.i.i5476 = getelementptr double, ptr %56, i64 %.138.i4903.010731
  store double 0.000000e+00, ptr %.161.i.i5476, align 8, !noalias !73
  %.214.i.i5511 = getelementptr double, ptr %57, i64 %.138.i4903.010731
  store double %.633.i5316, ptr %.214.i.i5511, align 8, !noalias !73
  %.268.i.i5544 = load i64, ptr %.290.i5036, align 8, !noalias !73
  %.294.i.i5558 = icmp slt i64 %.268.i.i5544, 0
  %.295.i.i = select i1 %.294.i.i5558, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i.i5559 = add i64 %.295.i.i, %.268.i.i5544
  %.316.i.i5571 = mul i64 %.296.i.i5559, %arg.batch.3.3.5.1
  %.320.i.i5572 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i.i5571
  %.321.i.i5573 = load i64, ptr %.320.i.i5572, align 8, !noalias !73
  %.322.i.i5574 = add nsw i64 %.321.i.i5573, -1
  store i64 %.322.i.i5574, ptr %.320.i.i5572, align 8, !noalias !73
  %.426.i.i5620 = load i64, ptr %.290.i5036, align 8, !noalias !73
  %.452.i.i = icmp slt i64 %.426.i.i5620, 0
  %.453.i.i = select i1 %.452.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i = add i64 %.453.i.i, %.426.i.i5620
  %.474.i.i = mul i64 %.454.i.i, %arg.batch.3.3.5.1
  %210 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i
  %.478.i.i = getelementptr i8, ptr %210, i64 24
  %.479.i.i = load i64, ptr %.478.i.i, align 8, !noalias !73
  %.480.i.i = add nsw i64 %.479.i.i, 1
  store i64 %.480.i.i, ptr %.478.i.i, align 8, !noalias !73
  %.705.i5650 = load double, ptr %.455.i5166, align 8, !noalias !69
  %.763.i5696 = getelementptr double, ptr %58, i64 %.138.i4903.010731
  store double %.705.i5650, ptr %.763.i5696, align 8, !noalias !69
  %.816.i5742 = mul i64 %.291.i5037, %arg.batch.3.3.5.1
  %211 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.816.i5742
  %.820.i5745 = getelementptr i8, ptr %211, i64 8
  %.821.i5746 = load i64, ptr %.820.i5745, align 8, !noalias !69
  %.822.i5747 = add nsw i64 %.821.i5746, 3
  store i64 %.822.i5747, ptr %.820.i5745, align 8, !noalias !69
  br label %B453.i

B453.i:                                           ; preds = %B268.i5216, %B306.i5269, %B64.if.i5797, %B140.i, %B216.i
  %.196.i4973 = icmp sgt i64 %.141.i4904.010730, 1
  br i1 %.196.i4973, label %B64.if.i5797, label %B3154

B64.if.i5797:                                     ; preds = %B2786.if, %B453.i
  %.138.i4903.010731 = phi i64 [ %.209.i5805, %B453.i ], [ 0, %B2786.if ]
  %.141.i4904.010730 = phi i64 [ %.205.i5802, %B453.i ], [ %storemerge, %B2786.if ]
  %.205.i5802 = add nsw i64 %.141.i4904.010730, -1
  %.209.i5805 = add nsw i64 %.138.i4903.010731, 1
  %.290.i5036 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.138.i4903.010731
  %.291.i5037 = load i64, ptr %.290.i5036, align 8, !noalias !69
  %.345.i5081 = getelementptr i64, ptr %51, i64 %.138.i4903.010731
  %.346.i5082 = load i64, ptr %.345.i5081, align 8, !noalias !69
  %.354.i = icmp slt i64 %.291.i5037, 0
  br i1 %.354.i, label %B453.i, label %B140.i

B3154.critedge:                                   ; preds = %B2738
  %.4535.c = load i64, ptr %.4534.c, align 8
  %.4580.c = inttoptr i64 %.4535.c to ptr
  tail call void %.4580.c(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3154

B3154:                                            ; preds = %B453.i, %B2786.if, %B3154.critedge
  br i1 %beyond.2.1, label %B108.i3279.preheader, label %B3238

B108.i3279.preheader:                             ; preds = %B3154
  br i1 %.665, label %B188.if.i4717.preheader, label %B108.if.i4781

B186.i3331.loopexit.critedge:                     ; preds = %B188.if.i4717
  %.625.i3556.c = icmp ult i64 %.361.i3151.010749, 8
  %.10381.c = select i1 %.625.i3556.c, i64 16, i64 17
  %.672.i3588.c = load i64, ptr %.671.i3587, align 8, !noalias !76
  %.744.i3645.c = mul i64 %.742.i3643, %.10381.c
  %.762.i3655.c = getelementptr double, ptr %arg.batch.5.0.4, i64 %.744.i3645.c
  %.788.i3665.c = inttoptr i64 %.672.i3588.c to ptr
  tail call void %.788.i3665.c(ptr %.571, ptr %.762.i3655.c, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !76
  br label %B186.i3331.loopexit

B186.i3331.loopexit:                              ; preds = %B770.i3772, %B186.i3331.loopexit.critedge
  %some.2.i3174.1.lcssa = phi i1 [ %some.4.i3147.010751, %B186.i3331.loopexit.critedge ], [ %some.3.i3195.2, %B770.i3772 ]
  %exitcond10883.not = icmp eq i64 %.431.i4724, 9
  br i1 %exitcond10883.not, label %B806.i3389.preheader, label %B188.if.i4717

B806.i3389.preheader:                             ; preds = %B186.i3331.loopexit
  br i1 %.665, label %B3158.endif.endif, label %B806.if.i3485

B222.i3538.loopexit:                              ; preds = %B122.if.i.i4684, %B222.if.i4699
  %.539.i3543 = icmp sgt i64 %.486.i3164.010743, 1
  br i1 %.539.i3543, label %B222.if.i4699, label %B284.i3552

B284.i3552:                                       ; preds = %B222.i3538.loopexit
  %.625.i3556 = icmp ult i64 %.361.i3151.010749, 8
  %.10381 = select i1 %.625.i3556, i64 16, i64 17
  %.672.i3588 = load i64, ptr %.671.i3587, align 8, !noalias !76
  %.744.i3645 = mul i64 %.742.i3643, %.10381
  %.762.i3655 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.744.i3645
  %.788.i3665 = inttoptr i64 %.672.i3588 to ptr
  tail call void %.788.i3665(ptr %.571, ptr %.762.i3655, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !76
  %.1181.i4003 = add nsw i64 %.361.i3151.010749, -1
  %.1182.i4004 = sitofp i64 %.1181.i4003 to double
  %.1187.i4005 = fmul double %.1182.i4004, 1.250000e-01
  %.1189.i4007 = uitofp i64 %.361.i3151.010749 to double
  %.1194.i4008 = fmul double %.1189.i4007, 1.250000e-01
  br label %B466.if.i4198

B508.i3777:                                       ; preds = %B466.if.i4198
  %.1028.i3821 = getelementptr double, ptr %61, i64 %.814.i3187.010745
  %.1029.i3822 = load double, ptr %.1028.i3821, align 8, !noalias !76
  %.1030.i3823 = fcmp ogt double %.1029.i3822, 5.000000e-01
  br i1 %.1030.i3823, label %B546.i3824, label %B770.i3772

B546.i3824:                                       ; preds = %B508.i3777
  %.1088.i3869 = getelementptr i64, ptr %62, i64 %.814.i3187.010745
  %.1089.i3870 = load i64, ptr %.1088.i3869, align 8, !noalias !76
  %.1090.i3871 = icmp slt i64 %.1089.i3870, 0
  br i1 %.1090.i3871, label %B34.i.i3928, label %B770.i3772

B34.i.i3928:                                      ; preds = %B546.i3824, %B36.i.i4141
  %.48.i.i2973.0 = phi i64 [ %.119.i88.i4189, %B36.i.i4141 ], [ 0, %B546.i3824 ]
  %exitcond10882.not = icmp eq i64 %.48.i.i2973.0, %storemerge10326
  br i1 %exitcond10882.not, label %B584.endif.i3958, label %B36.i.i4141

B36.i.i4141:                                      ; preds = %B34.i.i3928
  %.119.i88.i4189 = add i64 %.48.i.i2973.0, 1
  %.149.i53.i4147 = add nsw i64 %.48.i.i2973.0, %arg.shape.6
  %.151.i55.i4149 = mul nsw i64 %.149.i53.i4147, %arg.shape.0
  %.153.i56.i4151 = add nsw i64 %.151.i55.i4149, %.814.i3187.010745
  %.167.i61.i4159 = icmp slt i64 %.153.i56.i4151, 0
  %.168.i62.i4160 = select i1 %.167.i61.i4159, i64 %arg.batch.5.4.5.0, i64 0
  %212 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i56.i4151
  %.182.i74.i4170 = getelementptr double, ptr %212, i64 %.168.i62.i4160
  %.183.i75.i4171 = load double, ptr %.182.i74.i4170, align 8, !noalias !80
  %.184.i.i4172 = fcmp ogt double %.183.i75.i4171, 5.000000e-01
  br i1 %.184.i.i4172, label %B584.endif.i3958, label %B34.i.i3928

B732.i4087:                                       ; preds = %B584.endif.i3958
  %.1369.i4126 = load i64, ptr %.1088.i3869, align 8, !noalias !76
  %.1370.i4127 = icmp sgt i64 %.1369.i4126, -1
  br label %B770.i3772

B770.i3772:                                       ; preds = %B732.i4087, %B584.endif.i3958, %B546.i3824, %B508.i3777, %B466.if.i4198
  %some.3.i3195.2 = phi i1 [ %some.2.i3174.110747, %B466.if.i4198 ], [ %some.2.i3174.110747, %B546.i3824 ], [ %some.2.i3174.110747, %B508.i3777 ], [ true, %B584.endif.i3958 ], [ %.1370.i4127, %B732.i4087 ]
  %.870.i3704 = icmp sgt i64 %.817.i3188.010746, 1
  br i1 %.870.i3704, label %B466.if.i4198, label %B186.i3331.loopexit

B108.if.i4781:                                    ; preds = %B108.i3279.preheader, %B108.if.i4781
  %.179.i3138.010734 = phi i64 [ %.243.i4786, %B108.if.i4781 ], [ %storemerge, %B108.i3279.preheader ]
  %.176.i3137.010733 = phi i64 [ %.247.i4789, %B108.if.i4781 ], [ 0, %B108.i3279.preheader ]
  %.243.i4786 = add nsw i64 %.179.i3138.010734, -1
  %.247.i4789 = add nsw i64 %.176.i3137.010733, 1
  %213 = getelementptr i64, ptr %59, i64 %.176.i3137.010733
  store i64 -1, ptr %213, align 8, !noalias !76
  %.234.i3284 = icmp sgt i64 %.179.i3138.010734, 1
  br i1 %.234.i3284, label %B108.if.i4781, label %B188.if.i4717.preheader

B188.if.i4717.preheader:                          ; preds = %B108.if.i4781, %B108.i3279.preheader
  br label %B188.if.i4717

B188.if.i4717:                                    ; preds = %B188.if.i4717.preheader, %B186.i3331.loopexit
  %some.4.i3147.010751 = phi i1 [ %some.2.i3174.1.lcssa, %B186.i3331.loopexit ], [ false, %B188.if.i4717.preheader ]
  %.361.i3151.010749 = phi i64 [ %.431.i4724, %B186.i3331.loopexit ], [ 1, %B188.if.i4717.preheader ]
  %.431.i4724 = add nsw i64 %.361.i3151.010749, 1
  br i1 %.665, label %B186.i3331.loopexit.critedge, label %B222.if.i4699.lr.ph

B222.if.i4699.lr.ph:                              ; preds = %B188.if.i4717
  %.579.i4223 = uitofp i64 %.361.i3151.010749 to double
  %.584.i4224 = fmul double %.579.i4223, 1.250000e-01
  %.247.i.i.i4654 = fsub double 1.000000e+00, %.584.i4224
  br label %B222.if.i4699

B222.if.i4699:                                    ; preds = %B222.if.i4699.lr.ph, %B222.i3538.loopexit
  %.486.i3164.010743 = phi i64 [ %storemerge, %B222.if.i4699.lr.ph ], [ %.548.i4704, %B222.i3538.loopexit ]
  %.483.i3163.010742 = phi i64 [ 0, %B222.if.i4699.lr.ph ], [ %.552.i4707, %B222.i3538.loopexit ]
  %.548.i4704 = add nsw i64 %.486.i3164.010743, -1
  %.552.i4707 = add nsw i64 %.483.i3163.010742, 1
  %.92.i.i4304 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.483.i3163.010742
  %.93.i.i4305 = load double, ptr %.92.i.i4304, align 8, !noalias !84
  %.146.i.i4341 = getelementptr double, ptr %60, i64 %.483.i3163.010742
  %.147.i.i4342 = load double, ptr %.146.i.i4341, align 8, !noalias !84
  %.149.i.i4344 = fmul double %.584.i4224, %.147.i.i4342
  %.150.i.i4345 = fadd double %.93.i.i4305, %.149.i.i4344
  %.203.i.i4381 = getelementptr double, ptr %.571, i64 %.483.i3163.010742
  store double %.150.i.i4345, ptr %.203.i.i4381, align 8, !noalias !84
  br i1 %.287.i.i441810738.not, label %B222.i3538.loopexit, label %B122.if.i.i4684.preheader

B122.if.i.i4684.preheader:                        ; preds = %B222.if.i4699
  %invariant.gep10918 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010742
  %invariant.gep10920 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010742
  %invariant.gep10922 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010742
  %invariant.gep10924 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010742
  %invariant.gep10926 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010742
  %invariant.gep10928 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010742
  %invariant.gep10930 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010742
  %invariant.gep10932 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010742
  %invariant.gep10934 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3163.010742
  br label %B122.if.i.i4684

B122.if.i.i4684:                                  ; preds = %B122.if.i.i4684.preheader, %B122.if.i.i4684
  %.229.i.i3022.010739 = phi i64 [ %.300.i.i4690, %B122.if.i.i4684 ], [ 0, %B122.if.i.i4684.preheader ]
  %.157.i.i.i4611 = add nsw i64 %.155.i.i.i4609, %.229.i.i3022.010739
  %.159.i.i.i4613 = mul nsw i64 %.157.i.i.i4611, %arg.shape.0
  %gep10919 = getelementptr double, ptr %invariant.gep10918, i64 %.159.i.i.i4613
  %.191.i.i.i4635 = load double, ptr %gep10919, align 8, !noalias !88
  %.193.i.i.i4637 = fadd double %.191.i.i.i4635, 0.000000e+00
  %.253.i.i.i4659 = fmul double %.584.i4224, %.193.i.i.i4637
  %.157.i.i.i4611.1 = add nsw i64 %.155.i.i.i4609.1, %.229.i.i3022.010739
  %.159.i.i.i4613.1 = mul nsw i64 %.157.i.i.i4611.1, %arg.shape.0
  %gep10921 = getelementptr double, ptr %invariant.gep10920, i64 %.159.i.i.i4613.1
  %.191.i.i.i4635.1 = load double, ptr %gep10921, align 8, !noalias !88
  %.193.i.i.i4637.1 = fadd double %.253.i.i.i4659, %.191.i.i.i4635.1
  %.253.i.i.i4659.1 = fmul double %.247.i.i.i4654, %.193.i.i.i4637.1
  %.157.i.i.i4611.2 = add nsw i64 %.155.i.i.i4609.2, %.229.i.i3022.010739
  %.159.i.i.i4613.2 = mul nsw i64 %.157.i.i.i4611.2, %arg.shape.0
  %gep10923 = getelementptr double, ptr %invariant.gep10922, i64 %.159.i.i.i4613.2
  %.191.i.i.i4635.2 = load double, ptr %gep10923, align 8, !noalias !88
  %.193.i.i.i4637.2 = fadd double %.253.i.i.i4659.1, %.191.i.i.i4635.2
  %.253.i.i.i4659.2 = fmul double %.584.i4224, %.193.i.i.i4637.2
  %.157.i.i.i4611.3 = add nsw i64 %.155.i.i.i4609.3, %.229.i.i3022.010739
  %.159.i.i.i4613.3 = mul nsw i64 %.157.i.i.i4611.3, %arg.shape.0
  %gep10925 = getelementptr double, ptr %invariant.gep10924, i64 %.159.i.i.i4613.3
  %.191.i.i.i4635.3 = load double, ptr %gep10925, align 8, !noalias !88
  %.193.i.i.i4637.3 = fadd double %.253.i.i.i4659.2, %.191.i.i.i4635.3
  %.253.i.i.i4659.3 = fmul double %.247.i.i.i4654, %.193.i.i.i4637.3
  %.157.i.i.i4611.4 = add nsw i64 %.155.i.i.i4609.4, %.229.i.i3022.010739
  %.159.i.i.i4613.4 = mul nsw i64 %.157.i.i.i4611.4, %arg.shape.0
  %gep10927 = getelementptr double, ptr %invariant.gep10926, i64 %.159.i.i.i4613.4
  %.191.i.i.i4635.4 = load double, ptr %gep10927, align 8, !noalias !88
  %.193.i.i.i4637.4 = fadd double %.253.i.i.i4659.3, %.191.i.i.i4635.4
  %.253.i.i.i4659.4 = fmul double %.584.i4224, %.193.i.i.i4637.4
  %.157.i.i.i4611.5 = add nsw i64 %.155.i.i.i4609.5, %.229.i.i3022.010739
  %.159.i.i.i4613.5 = mul nsw i64 %.157.i.i.i4611.5, %arg.shape.0
  %gep10929 = getelementptr double, ptr %invariant.gep10928, i64 %.159.i.i.i4613.5
  %.191.i.i.i4635.5 = load double, ptr %gep10929, align 8, !noalias !88
  %.193.i.i.i4637.5 = fadd double %.253.i.i.i4659.4, %.191.i.i.i4635.5
  %.253.i.i.i4659.5 = fmul double %.247.i.i.i4654, %.193.i.i.i4637.5
  %.157.i.i.i4611.6 = add nsw i64 %.155.i.i.i4609.6, %.229.i.i3022.010739
  %.159.i.i.i4613.6 = mul nsw i64 %.157.i.i.i4611.6, %arg.shape.0
  %gep10931 = getelementptr double, ptr %invariant.gep10930, i64 %.159.i.i.i4613.6
  %.191.i.i.i4635.6 = load double, ptr %gep10931, align 8, !noalias !88
  %.193.i.i.i4637.6 = fadd double %.253.i.i.i4659.5, %.191.i.i.i4635.6
  %.253.i.i.i4659.6 = fmul double %.584.i4224, %.193.i.i.i4637.6
  %.300.i.i4690 = add nsw i64 %.229.i.i3022.010739, 1
  %.271.i.i.i4532 = mul nsw i64 %.229.i.i3022.010739, %arg.shape.0
  %gep10933 = getelementptr double, ptr %invariant.gep10932, i64 %.271.i.i.i4532
  %.309.i.i.i4557 = load double, ptr %gep10933, align 8, !noalias !88
  %.313.i.i.i4560 = fadd double %.253.i.i.i4659.6, %.309.i.i.i4557
  %.359.i.i4573 = add nsw i64 %.229.i.i3022.010739, %.358.i.i4572
  %.361.i.i4575 = mul nsw i64 %.359.i.i4573, %arg.shape.0
  %gep10935 = getelementptr double, ptr %invariant.gep10934, i64 %.361.i.i4575
  store double %.313.i.i.i4560, ptr %gep10935, align 8, !noalias !84
  %exitcond10881.not = icmp eq i64 %arg.shape.1, %.300.i.i4690
  br i1 %exitcond10881.not, label %B222.i3538.loopexit, label %B122.if.i.i4684

B466.if.i4198:                                    ; preds = %B284.i3552, %B770.i3772
  %some.2.i3174.110747 = phi i1 [ %some.4.i3147.010751, %B284.i3552 ], [ %some.3.i3195.2, %B770.i3772 ]
  %.817.i3188.010746 = phi i64 [ %storemerge, %B284.i3552 ], [ %.879.i4203, %B770.i3772 ]
  %.814.i3187.010745 = phi i64 [ 0, %B284.i3552 ], [ %.883.i4206, %B770.i3772 ]
  %.879.i4203 = add nsw i64 %.817.i3188.010746, -1
  %.883.i4206 = add nsw i64 %.814.i3187.010745, 1
  %.968.i3769 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.814.i3187.010745
  %.969.i3770 = load i64, ptr %.968.i3769, align 8, !noalias !76
  %.970.i3771 = icmp sgt i64 %.969.i3770, -1
  br i1 %.970.i3771, label %B508.i3777, label %B770.i3772

B584.endif.i3958:                                 ; preds = %B36.i.i4141, %B34.i.i3928
  %.1099.i3200.0 = phi i64 [ %.48.i.i2973.0, %B36.i.i4141 ], [ -1, %B34.i.i3928 ]
  store i64 %.1099.i3200.0, ptr %.1088.i3869, align 8, !noalias !76
  %.1248.i4045 = getelementptr double, ptr %63, i64 %.814.i3187.010745
  store double %.1187.i4005, ptr %.1248.i4045, align 8, !noalias !76
  %.1303.i4082 = getelementptr double, ptr %64, i64 %.814.i3187.010745
  store double %.1194.i4008, ptr %.1303.i4082, align 8, !noalias !76
  br i1 %some.2.i3174.110747, label %B770.i3772, label %B732.i4087

B806.if.i3485:                                    ; preds = %B806.i3389.preheader, %B806.if.i3485
  %.1453.i3211.010754 = phi i64 [ %.1515.i3488, %B806.if.i3485 ], [ %storemerge, %B806.i3389.preheader ]
  %.1450.i3210.010753 = phi i64 [ %.1519.i3491, %B806.if.i3485 ], [ 0, %B806.i3389.preheader ]
  %.1515.i3488 = add nsw i64 %.1453.i3211.010754, -1
  %.1519.i3491 = add nsw i64 %.1450.i3210.010753, 1
  %.1596.i3447 = getelementptr double, ptr %65, i64 %.1450.i3210.010753
  %.1597.i3448 = load double, ptr %.1596.i3447, align 8, !noalias !76
  %.1650.i3484 = getelementptr double, ptr %.571, i64 %.1450.i3210.010753
  store double %.1597.i3448, ptr %.1650.i3484, align 8, !noalias !76
  %.1506.i3394 = icmp sgt i64 %.1453.i3211.010754, 1
  br i1 %.1506.i3394, label %B806.if.i3485, label %B3158.endif.endif

B3196:                                            ; preds = %B3158.endif.endif
  %.222.i = load double, ptr %.221.i, align 8, !noalias !92
  %.251.i = load double, ptr %arg.batch.2.4, align 8, !noalias !92
  %.252.i = fsub double %.222.i, %.251.i
  %.253.i = fmul double %.252.i, 1.000000e-13
  br i1 %.665, label %B150.if.i.i.preheader, label %B70.if.i.i.preheader

B70.if.i.i.preheader:                             ; preds = %B3196
  tail call void @llvm.memset.p0.i64(ptr align 8 %67, i8 0, i64 %125, i1 false), !noalias !95
  br label %B150.if.i.i.preheader

B150.if.i.i.preheader:                            ; preds = %B70.if.i.i.preheader, %B3196
  br label %B150.if.i.i

B148.i.loopexit.i:                                ; preds = %B928.i.loopexit.i, %B294.endif.endif.i.i
  %exitcond2952.not.i = icmp eq i64 %.417.i.i, 9
  br i1 %exitcond2952.not.i, label %B220.preheader.i, label %B150.if.i.i

B220.preheader.i:                                 ; preds = %B148.i.loopexit.i
  br i1 %.665, label %B478.preheader.i, label %B220.if.i

B184.i.loopexit.i:                                ; preds = %B122.if.i.i.i, %B184.if.i.i
  %exitcond2947.not.i = icmp eq i64 %arg.shape.0, %.538.i.i
  br i1 %exitcond2947.not.i, label %B246.i.i, label %B184.if.i.i

B246.i.i:                                         ; preds = %B184.i.loopexit.i, %B150.if.i.i
  %.611.i.i = icmp ult i64 %.347.i.02919.i, 8
  %..i10430 = select i1 %.611.i.i, i64 16, i64 17
  %.628.i.i = mul i64 %..i10430, %.463
  %.658.i.i = load i64, ptr %.657.i.i, align 8, !noalias !95
  %.744.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.628.i.i
  %.770.i.i = inttoptr i64 %.658.i.i to ptr
  tail call void %.770.i.i(ptr %.571, ptr %.744.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !95
  %.801.i.i = load i64, ptr %arg.code.4, align 8, !noalias !95
  %.917.i.i = inttoptr i64 %.801.i.i to ptr
  tail call void %.917.i.i(ptr %.571, ptr %.744.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.916.i.i), !noalias !95
  br i1 %.111.i49.i2906.not.i, label %B294.endif.endif.i.i.critedge, label %B34.if.i.i.i

B34.if.i.i.i:                                     ; preds = %B246.i.i, %B34.if.i.i.i
  %.53.i17.i.02907.i = phi i64 [ %.124.i128.i.i, %B34.if.i.i.i ], [ 0, %B246.i.i ]
  %.124.i128.i.i = add nsw i64 %.53.i17.i.02907.i, 1
  %214 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.53.i17.i.02907.i
  %.178.i74.i.i = load double, ptr %214, align 8, !noalias !99
  %.180.i76.i.i = add nsw i64 %.53.i17.i.02907.i, %.922.i.i
  %.194.i84.i.i = icmp slt i64 %.180.i76.i.i, 0
  %.195.i85.i.i = select i1 %.194.i84.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %215 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.180.i76.i.i
  %.209.i.i.i = getelementptr double, ptr %215, i64 %.195.i85.i.i
  %.210.i.i.i = load double, ptr %.209.i.i.i, align 8, !noalias !99
  store double %.178.i74.i.i, ptr %.209.i.i.i, align 8, !noalias !99
  store double %.210.i.i.i, ptr %214, align 8, !noalias !99
  %exitcond2948.not.i = icmp eq i64 %.925.i.i, %.124.i128.i.i
  br i1 %exitcond2948.not.i, label %B294.endif.i.i, label %B34.if.i.i.i

B928.i.loopexit.i:                                ; preds = %B962.if.i.i, %B928.if.i.i
  %exitcond2951.not.i = icmp eq i64 %arg.shape.0, %.1519.i.i
  br i1 %exitcond2951.not.i, label %B148.i.loopexit.i, label %B928.if.i.i

B150.if.i.i:                                      ; preds = %B150.if.i.i.preheader, %B148.i.loopexit.i
  %.347.i.02919.i = phi i64 [ %.417.i.i, %B148.i.loopexit.i ], [ 1, %B150.if.i.i.preheader ]
  %.417.i.i = add nsw i64 %.347.i.02919.i, 1
  br i1 %.665, label %B246.i.i, label %B184.if.i.lr.ph.i

B184.if.i.lr.ph.i:                                ; preds = %B150.if.i.i
  %.565.i.i = uitofp i64 %.347.i.02919.i to double
  %.570.i.i = fmul double %.565.i.i, 1.250000e-01
  %.247.i.i.i.i = fsub double 1.000000e+00, %.570.i.i
  br label %B184.if.i.i

B184.if.i.i:                                      ; preds = %B184.if.i.lr.ph.i, %B184.i.loopexit.i
  %.469.i.02904.i = phi i64 [ 0, %B184.if.i.lr.ph.i ], [ %.538.i.i, %B184.i.loopexit.i ]
  %.538.i.i = add nsw i64 %.469.i.02904.i, 1
  %.92.i.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.469.i.02904.i
  %.93.i.i.i = load double, ptr %.92.i.i.i, align 8, !noalias !103
  %.146.i.i.i = getelementptr double, ptr %68, i64 %.469.i.02904.i
  %.147.i.i.i = load double, ptr %.146.i.i.i, align 8, !noalias !103
  %.149.i.i.i = fmul double %.570.i.i, %.147.i.i.i
  %.150.i.i.i10429 = fadd double %.93.i.i.i, %.149.i.i.i
  %.203.i.i.i = getelementptr double, ptr %.571, i64 %.469.i.02904.i
  store double %.150.i.i.i10429, ptr %.203.i.i.i, align 8, !noalias !103
  br i1 %.287.i.i2900.not.i, label %B184.i.loopexit.i, label %B122.if.i.i.preheader.i

B122.if.i.i.preheader.i:                          ; preds = %B184.if.i.i
  %invariant.gep10755 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10757 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10759 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10761 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10763 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10765 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10767 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10769 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10771 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  br label %B122.if.i.i.i

B122.if.i.i.i:                                    ; preds = %B122.if.i.i.i, %B122.if.i.i.preheader.i
  %.229.i.i.02901.i = phi i64 [ %.300.i.i.i, %B122.if.i.i.i ], [ 0, %B122.if.i.i.preheader.i ]
  %.157.i.i.i.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.i
  %.159.i.i.i.i = mul nsw i64 %.157.i.i.i.i, %arg.shape.0
  %gep10756 = getelementptr double, ptr %invariant.gep10755, i64 %.159.i.i.i.i
  %.191.i.i.i.i = load double, ptr %gep10756, align 8, !noalias !107
  %.193.i.i.i.i = fadd double %.191.i.i.i.i, 0.000000e+00
  %.253.i.i.i.i = fmul double %.570.i.i, %.193.i.i.i.i
  %.157.i.i.i.1.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.1.i
  %.159.i.i.i.1.i = mul nsw i64 %.157.i.i.i.1.i, %arg.shape.0
  %gep10758 = getelementptr double, ptr %invariant.gep10757, i64 %.159.i.i.i.1.i
  %.191.i.i.i.1.i = load double, ptr %gep10758, align 8, !noalias !107
  %.193.i.i.i.1.i = fadd double %.191.i.i.i.1.i, %.253.i.i.i.i
  %.253.i.i.i.1.i = fmul double %.247.i.i.i.i, %.193.i.i.i.1.i
  %.157.i.i.i.2.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.2.i
  %.159.i.i.i.2.i = mul nsw i64 %.157.i.i.i.2.i, %arg.shape.0
  %gep10760 = getelementptr double, ptr %invariant.gep10759, i64 %.159.i.i.i.2.i
  %.191.i.i.i.2.i = load double, ptr %gep10760, align 8, !noalias !107
  %.193.i.i.i.2.i = fadd double %.191.i.i.i.2.i, %.253.i.i.i.1.i
  %.253.i.i.i.2.i = fmul double %.570.i.i, %.193.i.i.i.2.i
  %.157.i.i.i.3.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.3.i
  %.159.i.i.i.3.i = mul nsw i64 %.157.i.i.i.3.i, %arg.shape.0
  %gep10762 = getelementptr double, ptr %invariant.gep10761, i64 %.159.i.i.i.3.i
  %.191.i.i.i.3.i = load double, ptr %gep10762, align 8, !noalias !107
  %.193.i.i.i.3.i = fadd double %.191.i.i.i.3.i, %.253.i.i.i.2.i
  %.253.i.i.i.3.i = fmul double %.247.i.i.i.i, %.193.i.i.i.3.i
  %.157.i.i.i.4.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.4.i
  %.159.i.i.i.4.i = mul nsw i64 %.157.i.i.i.4.i, %arg.shape.0
  %gep10764 = getelementptr double, ptr %invariant.gep10763, i64 %.159.i.i.i.4.i
  %.191.i.i.i.4.i = load double, ptr %gep10764, align 8, !noalias !107
  %.193.i.i.i.4.i = fadd double %.191.i.i.i.4.i, %.253.i.i.i.3.i
  %.253.i.i.i.4.i = fmul double %.570.i.i, %.193.i.i.i.4.i
  %.157.i.i.i.5.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.5.i
  %.159.i.i.i.5.i = mul nsw i64 %.157.i.i.i.5.i, %arg.shape.0
  %gep10766 = getelementptr double, ptr %invariant.gep10765, i64 %.159.i.i.i.5.i
  %.191.i.i.i.5.i = load double, ptr %gep10766, align 8, !noalias !107
  %.193.i.i.i.5.i = fadd double %.191.i.i.i.5.i, %.253.i.i.i.4.i
  %.253.i.i.i.5.i = fmul double %.247.i.i.i.i, %.193.i.i.i.5.i
  %.157.i.i.i.6.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.6.i
  %.159.i.i.i.6.i = mul nsw i64 %.157.i.i.i.6.i, %arg.shape.0
  %gep10768 = getelementptr double, ptr %invariant.gep10767, i64 %.159.i.i.i.6.i
  %.191.i.i.i.6.i = load double, ptr %gep10768, align 8, !noalias !107
  %.193.i.i.i.6.i = fadd double %.191.i.i.i.6.i, %.253.i.i.i.5.i
  %.253.i.i.i.6.i = fmul double %.570.i.i, %.193.i.i.i.6.i
  %.300.i.i.i = add nsw i64 %.229.i.i.02901.i, 1
  %.271.i.i.i.i = mul nsw i64 %.229.i.i.02901.i, %arg.shape.0
  %gep10770 = getelementptr double, ptr %invariant.gep10769, i64 %.271.i.i.i.i
  %.309.i.i.i.i = load double, ptr %gep10770, align 8, !noalias !107
  %.313.i.i.i.i = fadd double %.309.i.i.i.i, %.253.i.i.i.6.i
  %.359.i.i.i = add nsw i64 %.229.i.i.02901.i, %.358.i.i.i
  %.361.i.i.i = mul nsw i64 %.359.i.i.i, %arg.shape.0
  %gep10772 = getelementptr double, ptr %invariant.gep10771, i64 %.361.i.i.i
  store double %.313.i.i.i.i, ptr %gep10772, align 8, !noalias !103
  %exitcond2946.not.i = icmp eq i64 %arg.shape.1, %.300.i.i.i
  br i1 %exitcond2946.not.i, label %B184.i.loopexit.i, label %B122.if.i.i.i

B294.endif.i.i:                                   ; preds = %B34.if.i.i.i
  %.985.i.i10431 = load i64, ptr %.984.i.i10428, align 8, !noalias !95
  %.1097.i.i10432 = inttoptr i64 %.985.i.i10431 to ptr
  tail call void %.1097.i.i10432(ptr %.571, ptr %.744.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !95
  %.1128.i.i = load i64, ptr %arg.code.4, align 8, !noalias !95
  %.1244.i.i = inttoptr i64 %.1128.i.i to ptr
  tail call void %.1244.i.i(ptr %.571, ptr %.744.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1243.i.i), !noalias !95
  br label %B34.if.i321.i.i

B34.if.i321.i.i:                                  ; preds = %B294.endif.i.i, %B34.if.i321.i.i
  %.53.i162.i.02910.i = phi i64 [ %.124.i328.i.i, %B34.if.i321.i.i ], [ 0, %B294.endif.i.i ]
  %.124.i328.i.i = add nsw i64 %.53.i162.i.02910.i, 1
  %216 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.53.i162.i.02910.i
  %.178.i253.i.i = load double, ptr %216, align 8, !noalias !111
  %.180.i255.i.i = add nsw i64 %.53.i162.i.02910.i, %.922.i.i
  %.194.i264.i.i = icmp slt i64 %.180.i255.i.i, 0
  %.195.i265.i.i = select i1 %.194.i264.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %217 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.180.i255.i.i
  %.209.i275.i.i = getelementptr double, ptr %217, i64 %.195.i265.i.i
  %.210.i276.i.i = load double, ptr %.209.i275.i.i, align 8, !noalias !111
  store double %.178.i253.i.i, ptr %.209.i275.i.i, align 8, !noalias !111
  store double %.210.i276.i.i, ptr %216, align 8, !noalias !111
  %exitcond2949.not.i = icmp eq i64 %.925.i.i, %.124.i328.i.i
  br i1 %exitcond2949.not.i, label %B294.endif.endif.i.i, label %B34.if.i321.i.i

B294.endif.endif.i.i.critedge:                    ; preds = %B246.i.i
  %.985.i.i10431.c = load i64, ptr %.984.i.i10428, align 8, !noalias !95
  %.1097.i.i10432.c = inttoptr i64 %.985.i.i10431.c to ptr
  tail call void %.1097.i.i10432.c(ptr %.571, ptr %.744.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !95
  %.1128.i.i.c = load i64, ptr %arg.code.4, align 8, !noalias !95
  %.1244.i.i.c = inttoptr i64 %.1128.i.i.c to ptr
  tail call void %.1244.i.i.c(ptr %.571, ptr %.744.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1243.i.i), !noalias !95
  br label %B294.endif.endif.i.i

B294.endif.endif.i.i:                             ; preds = %B34.if.i321.i.i, %B294.endif.endif.i.i.critedge
  %.1312.i.i = load i64, ptr %.984.i.i10428, align 8, !noalias !95
  %.1424.i.i = inttoptr i64 %.1312.i.i to ptr
  tail call void %.1424.i.i(ptr %.571, ptr %.744.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !95
  br i1 %.665, label %B148.i.loopexit.i, label %B928.if.i.i

B928.if.i.i:                                      ; preds = %B294.endif.endif.i.i, %B928.i.loopexit.i
  %.1450.i.02916.i = phi i64 [ %.1519.i.i, %B928.i.loopexit.i ], [ 0, %B294.endif.endif.i.i ]
  %.1519.i.i = add nsw i64 %.1450.i.02916.i, 1
  br i1 %.287.i.i2900.not.i, label %B928.i.loopexit.i, label %B962.if.i.lr.ph.i

B962.if.i.lr.ph.i:                                ; preds = %B928.if.i.i
  %.1891.i.i = getelementptr double, ptr %68, i64 %.1450.i.02916.i
  %.1974.i.i = getelementptr double, ptr %69, i64 %.1450.i.02916.i
  br label %B962.if.i.i

B962.if.i.i:                                      ; preds = %B962.if.i.i, %B962.if.i.lr.ph.i
  %.1571.i.02913.i = phi i64 [ 0, %B962.if.i.lr.ph.i ], [ %.1640.i.i, %B962.if.i.i ]
  %.1640.i.i = add nsw i64 %.1571.i.02913.i, 1
  %218 = mul nsw i64 %.1571.i.02913.i, %arg.shape.0
  %.1668.i.i = add nsw i64 %218, %.1450.i.02916.i
  %219 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1668.i.i
  %.1698.i.i = load double, ptr %219, align 8, !noalias !95
  %.1707.i.i = add nsw i64 %.1668.i.i, %factor.op.mul2918.i.reass
  %.1721.i.i = icmp slt i64 %.1707.i.i, 0
  %.1722.i.i = select i1 %.1721.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %220 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1707.i.i
  %.1736.i.i = getelementptr double, ptr %220, i64 %.1722.i.i
  %.1737.i.i = load double, ptr %.1736.i.i, align 8, !noalias !95
  %.1742.i.i = add nsw i64 %.1668.i.i, %factor.op.mul.i.reass
  %.1756.i.i = icmp slt i64 %.1742.i.i, 0
  %.1757.i.i = select i1 %.1756.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %221 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1742.i.i
  %.1771.i.i = getelementptr double, ptr %221, i64 %.1757.i.i
  %.1772.i.i = load double, ptr %.1771.i.i, align 8, !noalias !95
  %.1773.i.i = fsub double %.1737.i.i, %.1772.i.i
  %.1774.i.i = tail call double @llvm.fabs.f64(double %.1773.i.i)
  %.1804.i.i = load double, ptr %.1803.i.i, align 8, !noalias !95
  %.1834.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !95
  %.1835.i.i = tail call double @llvm.fabs.f64(double %.1698.i.i)
  %.1836.i.i = fmul double %.1835.i.i, %.1834.i.i
  %.1837.i.i = fadd double %.1804.i.i, %.1836.i.i
  %.1892.i.i = load double, ptr %.1891.i.i, align 8, !noalias !95
  %.1893.i.i = fmul double %.1774.i.i, %.1892.i.i
  %.1897.i.i = fdiv double %.1893.i.i, %.1837.i.i
  %.1903.i.i = fsub double %.1897.i.i, %.1897.i.i
  %.1904.i.i = fcmp oeq double %.1903.i.i, 0.000000e+00
  %.1897.i..i = select i1 %.1904.i.i, double %.1897.i.i, double 0x7FF0000000000000
  %.1975.i.i = load double, ptr %.1974.i.i, align 8, !noalias !95
  %.10.i.i.i10433 = fcmp ogt double %.1897.i..i, %.1975.i.i
  %.11.i.i.i10434 = select i1 %.10.i.i.i10433, double %.1897.i..i, double %.1975.i.i
  store double %.11.i.i.i10434, ptr %.1974.i.i, align 8, !noalias !95
  %exitcond2950.not.i = icmp eq i64 %arg.shape.1, %.1640.i.i
  br i1 %exitcond2950.not.i, label %B928.i.loopexit.i, label %B962.if.i.i

B478.preheader.i:                                 ; preds = %B1557.i, %B220.preheader.i
  %halvings.2.0.lcssa.i = phi i64 [ 0, %B220.preheader.i ], [ %halvings.3.1.i, %B1557.i ]
  %.8492938.i = icmp sgt i64 %halvings.2.0.lcssa.i, 0
  br i1 %.8492938.i, label %B480.if.i, label %B1058.preheader.i

B262.i:                                           ; preds = %B220.if.i
  %222 = getelementptr double, ptr %69, i64 %.377.02922.i
  %.585.i = load double, ptr %222, align 8, !noalias !92
  %.586.i = fcmp ogt double %.585.i, 1.000000e-01
  %.mux.i = select i1 %.586.i, i64 50, i64 %halvings.2.02924.i
  br i1 %.586.i, label %B1557.i, label %B34.i.i10449

B34.i.i10449:                                     ; preds = %B262.i, %B34.if.i.i10450
  %.48.i.0.i = phi i64 [ %.119.i60.i, %B34.if.i.i10450 ], [ 0, %B262.i ]
  %exitcond2953.not.i = icmp eq i64 %.48.i.0.i, %storemerge2877.i
  br i1 %exitcond2953.not.i, label %B364.endif.i, label %B34.if.i.i10450

B80.i.i10451:                                     ; preds = %B34.if.i.i10450
  %223 = icmp sgt i64 %.48.i.0.i, -1
  %224 = select i1 %223, double 1.000000e+00, double 0.000000e+00
  br label %B364.endif.i

B34.if.i.i10450:                                  ; preds = %B34.i.i10449
  %.119.i60.i = add i64 %.48.i.0.i, 1
  %.149.i.i = add nsw i64 %.48.i.0.i, %arg.shape.6
  %.151.i.i = mul nsw i64 %.149.i.i, %arg.shape.0
  %.153.i.i = add nsw i64 %.151.i.i, %.377.02922.i
  %.167.i45.i = icmp slt i64 %.153.i.i, 0
  %.168.i46.i = select i1 %.167.i45.i, i64 %arg.batch.5.4.5.0, i64 0
  %225 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i.i
  %.182.i52.i = getelementptr double, ptr %225, i64 %.168.i46.i
  %.183.i53.i = load double, ptr %.182.i52.i, align 8, !noalias !115
  %.184.i54.i = fcmp ogt double %.183.i53.i, 5.000000e-01
  br i1 %.184.i54.i, label %B80.i.i10451, label %B34.i.i10449

B478.loopexit.i.critedge:                         ; preds = %B480.if.i
  %.1184.i.c = load i64, ptr %.657.i.i, align 8, !noalias !92
  %.1300.i.c = inttoptr i64 %.1184.i.c to ptr
  tail call void %.1300.i.c(ptr %.571, ptr %.1274.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !92
  br label %B478.loopexit.i

B478.loopexit.i:                                  ; preds = %B1559.i, %B478.loopexit.i.critedge
  %.849.i = icmp sgt i64 %.795.02939.i, 1
  br i1 %.849.i, label %B480.if.i, label %B1058.preheader.i

B1058.preheader.i:                                ; preds = %B478.loopexit.i, %B478.preheader.i
  br i1 %.665, label %B3238, label %B1058.if.lr.ph.i

B1058.if.lr.ph.i:                                 ; preds = %B1058.preheader.i
  %.2389.i = fmul double %.253.i, 2.000000e+00
  br label %B1058.if.i

B514.loopexit.i:                                  ; preds = %B122.if.i.i10446, %B514.if.i
  %exitcond2957.not.i = icmp eq i64 %arg.shape.0, %.980.i
  br i1 %exitcond2957.not.i, label %B628.i, label %B514.if.i

B122.if.i.i10446:                                 ; preds = %B122.if.i.lr.ph.i, %B122.if.i.i10446
  %.229.i.02929.i = phi i64 [ 0, %B122.if.i.lr.ph.i ], [ %.300.i567.i, %B122.if.i.i10446 ]
  %.157.i.i501.i = add nsw i64 %.229.i.02929.i, %.155.i.i.i10445
  %.159.i.i503.i = mul nsw i64 %.157.i.i501.i, %arg.shape.0
  %gep10774 = getelementptr double, ptr %invariant.gep10773, i64 %.159.i.i503.i
  %.191.i.i523.i = load double, ptr %gep10774, align 8, !noalias !119
  %.193.i.i525.i = fadd double %.191.i.i523.i, 0.000000e+00
  %.253.i.i540.i = fmul double %.1114.i, %.193.i.i525.i
  %.157.i.i501.1.i = add nsw i64 %.229.i.02929.i, %.155.i.i.1.i
  %.159.i.i503.1.i = mul nsw i64 %.157.i.i501.1.i, %arg.shape.0
  %gep10776 = getelementptr double, ptr %invariant.gep10775, i64 %.159.i.i503.1.i
  %.191.i.i523.1.i = load double, ptr %gep10776, align 8, !noalias !119
  %.193.i.i525.1.i = fadd double %.191.i.i523.1.i, %.253.i.i540.i
  %.253.i.i540.1.i = fmul double %.247.i.i.i10444, %.193.i.i525.1.i
  %.157.i.i501.2.i = add nsw i64 %.229.i.02929.i, %.155.i.i.2.i
  %.159.i.i503.2.i = mul nsw i64 %.157.i.i501.2.i, %arg.shape.0
  %gep10778 = getelementptr double, ptr %invariant.gep10777, i64 %.159.i.i503.2.i
  %.191.i.i523.2.i = load double, ptr %gep10778, align 8, !noalias !119
  %.193.i.i525.2.i = fadd double %.191.i.i523.2.i, %.253.i.i540.1.i
  %.253.i.i540.2.i = fmul double %.1114.i, %.193.i.i525.2.i
  %.157.i.i501.3.i = add nsw i64 %.229.i.02929.i, %.155.i.i.3.i
  %.159.i.i503.3.i = mul nsw i64 %.157.i.i501.3.i, %arg.shape.0
  %gep10780 = getelementptr double, ptr %invariant.gep10779, i64 %.159.i.i503.3.i
  %.191.i.i523.3.i = load double, ptr %gep10780, align 8, !noalias !119
  %.193.i.i525.3.i = fadd double %.191.i.i523.3.i, %.253.i.i540.2.i
  %.253.i.i540.3.i = fmul double %.247.i.i.i10444, %.193.i.i525.3.i
  %.157.i.i501.4.i = add nsw i64 %.229.i.02929.i, %.155.i.i.4.i
  %.159.i.i503.4.i = mul nsw i64 %.157.i.i501.4.i, %arg.shape.0
  %gep10782 = getelementptr double, ptr %invariant.gep10781, i64 %.159.i.i503.4.i
  %.191.i.i523.4.i = load double, ptr %gep10782, align 8, !noalias !119
  %.193.i.i525.4.i = fadd double %.191.i.i523.4.i, %.253.i.i540.3.i
  %.253.i.i540.4.i = fmul double %.1114.i, %.193.i.i525.4.i
  %.157.i.i501.5.i = add nsw i64 %.229.i.02929.i, %.155.i.i.5.i
  %.159.i.i503.5.i = mul nsw i64 %.157.i.i501.5.i, %arg.shape.0
  %gep10784 = getelementptr double, ptr %invariant.gep10783, i64 %.159.i.i503.5.i
  %.191.i.i523.5.i = load double, ptr %gep10784, align 8, !noalias !119
  %.193.i.i525.5.i = fadd double %.191.i.i523.5.i, %.253.i.i540.4.i
  %.253.i.i540.5.i = fmul double %.247.i.i.i10444, %.193.i.i525.5.i
  %.157.i.i501.6.i = add nsw i64 %.229.i.02929.i, %.155.i.i.6.i
  %.159.i.i503.6.i = mul nsw i64 %.157.i.i501.6.i, %arg.shape.0
  %gep10786 = getelementptr double, ptr %invariant.gep10785, i64 %.159.i.i503.6.i
  %.191.i.i523.6.i = load double, ptr %gep10786, align 8, !noalias !119
  %.193.i.i525.6.i = fadd double %.191.i.i523.6.i, %.253.i.i540.5.i
  %.253.i.i540.6.i = fmul double %.1114.i, %.193.i.i525.6.i
  %.300.i567.i = add nsw i64 %.229.i.02929.i, 1
  %.271.i.i451.i = mul nsw i64 %.229.i.02929.i, %arg.shape.0
  %gep10788 = getelementptr double, ptr %invariant.gep10787, i64 %.271.i.i451.i
  %.309.i.i.i10447 = load double, ptr %gep10788, align 8, !noalias !119
  %.313.i.i.i10448 = fadd double %.309.i.i.i10447, %.253.i.i540.6.i
  %.359.i.i = add nsw i64 %.229.i.02929.i, %.358.i.i.i
  %.361.i477.i = mul nsw i64 %.359.i.i, %arg.shape.0
  %gep10790 = getelementptr double, ptr %invariant.gep10789, i64 %.361.i477.i
  store double %.313.i.i.i10448, ptr %gep10790, align 8, !noalias !126
  %exitcond2956.not.i = icmp eq i64 %arg.shape.1, %.300.i567.i
  br i1 %exitcond2956.not.i, label %B514.loopexit.i, label %B122.if.i.i10446

B628.i:                                           ; preds = %B514.loopexit.i
  %.1184.i = load i64, ptr %.657.i.i, align 8, !noalias !92
  %.1300.i = inttoptr i64 %.1184.i to ptr
  tail call void %.1300.i(ptr %.571, ptr %.1274.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !92
  br label %B770.if.i

B812.i:                                           ; preds = %B770.if.i
  %.1533.i = getelementptr double, ptr %69, i64 %.1326.02935.i
  %.1534.i = load double, ptr %.1533.i, align 8, !noalias !92
  %.1535.i = fcmp ogt double %.1534.i, 1.000000e-01
  br i1 %.1535.i, label %B860.i, label %B1559.i

B860.i:                                           ; preds = %B812.i
  %.1590.i = getelementptr double, ptr %72, i64 %.1326.02935.i
  %.1591.i = load double, ptr %.1590.i, align 8, !noalias !92
  %.1645.i = getelementptr double, ptr %73, i64 %.1326.02935.i
  %.1646.i = load double, ptr %.1645.i, align 8, !noalias !92
  %.1647.i = fadd double %.1591.i, %.1646.i
  %.1648.i = fmul double %.1647.i, 5.000000e-01
  br label %B34.i127.i

B34.i127.i:                                       ; preds = %B34.if.i192.i, %B860.i
  %.48.i85.0.i = phi i64 [ 0, %B860.i ], [ %.119.i199.i, %B34.if.i192.i ]
  %exitcond2958.not.i = icmp eq i64 %.48.i85.0.i, %storemerge2869.i
  br i1 %exitcond2958.not.i, label %B998.i, label %B34.if.i192.i

B80.i184.i:                                       ; preds = %B34.if.i192.i
  %226 = icmp sgt i64 %.48.i85.0.i, -1
  br i1 %226, label %B972.i, label %B998.i

B34.if.i192.i:                                    ; preds = %B34.i127.i
  %.119.i199.i = add i64 %.48.i85.0.i, 1
  %.149.i153.i = add nsw i64 %.48.i85.0.i, %arg.shape.6
  %.151.i155.i = mul nsw i64 %.149.i153.i, %arg.shape.0
  %.153.i157.i = add nsw i64 %.151.i155.i, %.1326.02935.i
  %.167.i166.i = icmp slt i64 %.153.i157.i, 0
  %.168.i167.i = select i1 %.167.i166.i, i64 %arg.batch.5.4.5.0, i64 0
  %227 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i157.i
  %.182.i179.i = getelementptr double, ptr %227, i64 %.168.i167.i
  %.183.i180.i = load double, ptr %.182.i179.i, align 8, !noalias !127
  %.184.i181.i = fcmp ogt double %.183.i180.i, 5.000000e-01
  br i1 %.184.i181.i, label %B80.i184.i, label %B34.i127.i

B972.i:                                           ; preds = %B80.i184.i
  store double %.1648.i, ptr %.1645.i, align 8, !noalias !92
  br label %B1559.i

B998.i:                                           ; preds = %B34.i127.i, %B80.i184.i
  store double %.1648.i, ptr %.1590.i, align 8, !noalias !92
  br label %B1559.i

B1150.i:                                          ; preds = %B1058.if.i
  %.2178.i = getelementptr double, ptr %69, i64 %.1861.02941.i
  %.2179.i = load double, ptr %.2178.i, align 8, !noalias !92
  %.2180.i = fcmp ogt double %.2179.i, 1.000000e-01
  br i1 %.2180.i, label %B1198.i, label %B1558.i

B1198.i:                                          ; preds = %B1150.i
  %.2235.i = getelementptr double, ptr %68, i64 %.1861.02941.i
  %.2236.i = load double, ptr %.2235.i, align 8, !noalias !92
  %.2292.i = load double, ptr %.2011.i, align 8, !noalias !92
  %.2293.i = tail call double @llvm.fabs.f64(double %.2292.i)
  %.2294.i = fmul double %.2293.i, 2.000000e-12
  %.2351.i = getelementptr double, ptr %77, i64 %.1861.02941.i
  %.2352.i = load double, ptr %.2351.i, align 8, !noalias !92
  %.2357.i = fmul double %.2236.i, 0x3D719799812DEA11
  %.10.i.i10437 = fcmp ogt double %.2294.i, %.2357.i
  %.11.i.i10438 = select i1 %.10.i.i10437, double %.2294.i, double %.2357.i
  %.2353.i = fsub double 1.000000e+00, %.2352.i
  %.2355.i = fmul double %.2236.i, %.2353.i
  %.2386.i = fcmp ugt double %.2355.i, %.11.i.i10438
  %.2391.i = fcmp ugt double %.2236.i, %.2389.i
  %or.cond.i = select i1 %.2386.i, i1 %.2391.i, i1 false
  br i1 %or.cond.i, label %B1458.i, label %B1422.i

B1422.i:                                          ; preds = %B1198.i
  %.2450.i = getelementptr double, ptr %78, i64 %.1861.02941.i
  store double 1.000000e+00, ptr %.2450.i, align 8, !noalias !92
  br label %B1558.i

B1458.i:                                          ; preds = %B1198.i
  %.2507.i = getelementptr double, ptr %79, i64 %.1861.02941.i
  %.2508.i = load double, ptr %.2507.i, align 8, !noalias !92
  %.2510.i = fmul double %.2236.i, %.2508.i
  %.10.i2890.i = fcmp ogt double %.253.i, %.2510.i
  %.11.i2891.i = select i1 %.10.i2890.i, double %.253.i, double %.2510.i
  %.108.i.i = getelementptr double, ptr %80, i64 %.1861.02941.i
  store double 0.000000e+00, ptr %.108.i.i, align 8, !noalias !131
  %.161.i706.i = getelementptr double, ptr %81, i64 %.1861.02941.i
  store double 0.000000e+00, ptr %.161.i706.i, align 8, !noalias !131
  %.214.i750.i = getelementptr double, ptr %82, i64 %.1861.02941.i
  store double %.11.i2891.i, ptr %.214.i750.i, align 8, !noalias !131
  %.267.i785.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1861.02941.i
  %.268.i786.i = load i64, ptr %.267.i785.i, align 8, !noalias !131
  %.294.i805.i = icmp slt i64 %.268.i786.i, 0
  %.295.i806.i = select i1 %.294.i805.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i807.i = add i64 %.295.i806.i, %.268.i786.i
  %.316.i822.i = mul i64 %.296.i807.i, %arg.batch.3.3.5.1
  %.320.i.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i822.i
  %.321.i825.i = load i64, ptr %.320.i.i, align 8, !noalias !131
  %.322.i826.i = add nsw i64 %.321.i825.i, -1
  store i64 %.322.i826.i, ptr %.320.i.i, align 8, !noalias !131
  %.426.i.i = load i64, ptr %.267.i785.i, align 8, !noalias !131
  %.452.i.i10439 = icmp slt i64 %.426.i.i, 0
  %.453.i904.i = select i1 %.452.i.i10439, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i10440 = add i64 %.453.i904.i, %.426.i.i
  %.474.i.i10441 = mul i64 %.454.i.i10440, %arg.batch.3.3.5.1
  %228 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i10441
  %.478.i916.i = getelementptr i8, ptr %228, i64 24
  %.479.i.i10442 = load i64, ptr %.478.i916.i, align 8, !noalias !131
  %.480.i917.i = add nsw i64 %.479.i.i10442, 1
  store i64 %.480.i917.i, ptr %.478.i916.i, align 8, !noalias !131
  br label %B1558.i

B1557.i:                                          ; preds = %B364.endif.i, %B220.if.i, %B262.i
  %halvings.3.1.i = phi i64 [ %.mux.i, %B262.i ], [ %halvings.2.02924.i, %B364.endif.i ], [ %halvings.2.02924.i, %B220.if.i ]
  %exitcond2954.not.i = icmp eq i64 %arg.shape.0, %.446.i
  br i1 %exitcond2954.not.i, label %B478.preheader.i, label %B220.if.i

B1558.i:                                          ; preds = %B1058.if.i, %B1458.i, %B1422.i, %B1150.i
  %exitcond2960.not.i = icmp eq i64 %arg.shape.0, %.1930.i
  br i1 %exitcond2960.not.i, label %B3238, label %B1058.if.i

B1559.i:                                          ; preds = %B770.if.i, %B998.i, %B972.i, %B812.i
  %exitcond2959.not.i = icmp eq i64 %arg.shape.0, %.1395.i
  br i1 %exitcond2959.not.i, label %B478.loopexit.i, label %B770.if.i

B220.if.i:                                        ; preds = %B220.preheader.i, %B1557.i
  %halvings.2.02924.i = phi i64 [ %halvings.3.1.i, %B1557.i ], [ 0, %B220.preheader.i ]
  %.377.02922.i = phi i64 [ %.446.i, %B1557.i ], [ 0, %B220.preheader.i ]
  %.446.i = add nsw i64 %.377.02922.i, 1
  %229 = getelementptr i64, ptr %70, i64 %.377.02922.i
  %.528.i = load i64, ptr %229, align 8, !noalias !92
  %.529.i10435 = icmp sgt i64 %.528.i, -1
  br i1 %.529.i10435, label %B262.i, label %B1557.i

B364.endif.i:                                     ; preds = %B34.i.i10449, %B80.i.i10451
  %.658.0.i = phi double [ %224, %B80.i.i10451 ], [ 0.000000e+00, %B34.i.i10449 ]
  %230 = getelementptr double, ptr %71, i64 %.377.02922.i
  store double %.658.0.i, ptr %230, align 8, !noalias !92
  br label %B1557.i

B480.if.i:                                        ; preds = %B478.preheader.i, %B478.loopexit.i
  %.795.02939.i = phi i64 [ %.858.i, %B478.loopexit.i ], [ %halvings.2.0.lcssa.i, %B478.preheader.i ]
  %.858.i = add nsw i64 %.795.02939.i, -1
  br i1 %.665, label %B478.loopexit.i.critedge, label %B514.if.i

B514.if.i:                                        ; preds = %B480.if.i, %B514.loopexit.i
  %.911.02932.i = phi i64 [ %.980.i, %B514.loopexit.i ], [ 0, %B480.if.i ]
  %.980.i = add nsw i64 %.911.02932.i, 1
  %.1057.i = getelementptr double, ptr %72, i64 %.911.02932.i
  %.1058.i = load double, ptr %.1057.i, align 8, !noalias !92
  %.1111.i = getelementptr double, ptr %73, i64 %.911.02932.i
  %.1112.i = load double, ptr %.1111.i, align 8, !noalias !92
  %.1113.i = fadd double %.1058.i, %.1112.i
  %.1114.i = fmul double %.1113.i, 5.000000e-01
  %.92.i292.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.911.02932.i
  %.93.i293.i = load double, ptr %.92.i292.i, align 8, !noalias !126
  %.146.i.i = getelementptr double, ptr %68, i64 %.911.02932.i
  %.147.i325.i = load double, ptr %.146.i.i, align 8, !noalias !126
  %.149.i327.i = fmul double %.1114.i, %.147.i325.i
  %.150.i328.i = fadd double %.93.i293.i, %.149.i327.i
  %.203.i367.i = getelementptr double, ptr %.571, i64 %.911.02932.i
  store double %.150.i328.i, ptr %.203.i367.i, align 8, !noalias !126
  br i1 %.287.i.i2900.not.i, label %B514.loopexit.i, label %B122.if.i.lr.ph.i

B122.if.i.lr.ph.i:                                ; preds = %B514.if.i
  %.247.i.i.i10444 = fsub double 1.000000e+00, %.1114.i
  %invariant.gep10773 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep10775 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep10777 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep10779 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep10781 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep10783 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep10785 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep10787 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep10789 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  br label %B122.if.i.i10446

B770.if.i:                                        ; preds = %B628.i, %B1559.i
  %.1326.02935.i = phi i64 [ %.1395.i, %B1559.i ], [ 0, %B628.i ]
  %.1395.i = add nsw i64 %.1326.02935.i, 1
  %231 = getelementptr i64, ptr %74, i64 %.1326.02935.i
  %.1477.i = load i64, ptr %231, align 8, !noalias !92
  %.1478.i = icmp sgt i64 %.1477.i, -1
  br i1 %.1478.i, label %B812.i, label %B1559.i

B1058.if.i:                                       ; preds = %B1558.i, %B1058.if.lr.ph.i
  %.1861.02941.i = phi i64 [ 0, %B1058.if.lr.ph.i ], [ %.1930.i, %B1558.i ]
  %.1930.i = add nsw i64 %.1861.02941.i, 1
  %.2011.i = getelementptr double, ptr %75, i64 %.1861.02941.i
  %.2012.i = load double, ptr %.2011.i, align 8, !noalias !92
  %.2066.i = getelementptr double, ptr %.571, i64 %.1861.02941.i
  store double %.2012.i, ptr %.2066.i, align 8, !noalias !92
  %.2121.i = getelementptr i64, ptr %76, i64 %.1861.02941.i
  %.2122.i = load i64, ptr %.2121.i, align 8, !noalias !92
  %.2123.i = icmp sgt i64 %.2122.i, -1
  br i1 %.2123.i, label %B1150.i, label %B1558.i

B3238:                                            ; preds = %B1558.i, %B1058.preheader.i, %B3158.endif.endif, %B3154
  br i1 %.4802.not, label %B3300, label %B120.if.i

B120.loopexit.i.critedge:                         ; preds = %B120.if.i
  %.525.i.c = load i64, ptr %.524.i, align 8, !noalias !134
  %.641.i.c = inttoptr i64 %.525.i.c to ptr
  tail call void %.641.i.c(ptr %.571, ptr %.615.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !134
  br label %B120.loopexit.i

B120.loopexit.i:                                  ; preds = %B564.i, %B120.loopexit.i.critedge
  %exitcond738.not.i = icmp eq i64 %.231.0734.i, %.10382
  br i1 %exitcond738.not.i, label %B3300, label %B120.if.i

B154.loopexit.i:                                  ; preds = %B122.if.i.i10460, %B154.if.i
  %exitcond736.not.i = icmp eq i64 %arg.shape.0, %.423.i
  br i1 %exitcond736.not.i, label %B206.i, label %B154.if.i

B206.i:                                           ; preds = %B154.loopexit.i
  %.525.i = load i64, ptr %.524.i, align 8, !noalias !134
  %.641.i = inttoptr i64 %.525.i to ptr
  tail call void %.641.i(ptr %.571, ptr %.615.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !134
  %.945.i = add nsw i64 %.231.0734.i, -1
  %.947.i = sitofp i64 %.945.i to double
  %.952.i = fdiv double %.947.i, %.452.i
  %.955.i = uitofp i64 %.231.0734.i to double
  %.960.i = fdiv double %.955.i, %.452.i
  br label %B348.if.i

B390.i:                                           ; preds = %B348.if.i
  %232 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.667.0732.i
  %.851.i = load double, ptr %232, align 8, !noalias !134
  %.853.i = fcmp olt double %.851.i, -1.000000e-09
  br i1 %.853.i, label %B426.i, label %B564.i

B426.i:                                           ; preds = %B390.i
  %233 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.667.0732.i
  %.84.i51.i = load i64, ptr %233, align 8, !noalias !137
  %.89.i.i10478 = icmp sgt i64 %.84.i51.i, -1
  br i1 %.89.i.i10478, label %B46.i.i10479, label %B426.endif.i

B46.i.i10479:                                     ; preds = %B426.i
  %.120.i73.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i51.i
  %.121.i74.i = load i64, ptr %.120.i73.i, align 8, !noalias !137
  %.122.i75.i = icmp eq i64 %.121.i74.i, 0
  br i1 %.122.i75.i, label %B80.i.i10480, label %B426.endif.i

B80.i.i10480:                                     ; preds = %B46.i.i10479
  store i64 4, ptr %.120.i73.i, align 8, !noalias !137
  br label %B426.endif.i

B564.i:                                           ; preds = %B426.endif.i, %B348.if.i, %B390.i
  %exitcond737.not.i = icmp eq i64 %arg.shape.0, %.736.i
  br i1 %exitcond737.not.i, label %B120.loopexit.i, label %B348.if.i

B120.if.i:                                        ; preds = %B3238, %B120.loopexit.i
  %.231.0734.i = phi i64 [ %.302.i10455, %B120.loopexit.i ], [ 1, %B3238 ]
  %.302.i10455 = add nsw i64 %.231.0734.i, 1
  br i1 %.665, label %B120.loopexit.i.critedge, label %B154.if.lr.ph.i

B154.if.lr.ph.i:                                  ; preds = %B120.if.i
  %.451.i = uitofp i64 %.231.0734.i to double
  %.456.i = fdiv double %.451.i, %.452.i
  %.247.i.i.i10456 = fsub double 1.000000e+00, %.456.i
  br label %B154.if.i

B154.if.i:                                        ; preds = %B154.if.lr.ph.i, %B154.loopexit.i
  %.354.0729.i = phi i64 [ 0, %B154.if.lr.ph.i ], [ %.423.i, %B154.loopexit.i ]
  %.423.i = add nsw i64 %.354.0729.i, 1
  %.92.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.354.0729.i
  %.93.i.i = load double, ptr %.92.i.i, align 8, !noalias !140
  %.146.i.i10457 = getelementptr double, ptr %83, i64 %.354.0729.i
  %.147.i.i = load double, ptr %.146.i.i10457, align 8, !noalias !140
  %.149.i.i10458 = fmul double %.456.i, %.147.i.i
  %.150.i.i = fadd double %.93.i.i, %.149.i.i10458
  %.203.i.i = getelementptr double, ptr %.571, i64 %.354.0729.i
  store double %.150.i.i, ptr %.203.i.i, align 8, !noalias !140
  br i1 %.287.i725.not.i, label %B154.loopexit.i, label %B122.if.i.preheader.i

B122.if.i.preheader.i:                            ; preds = %B154.if.i
  %invariant.gep10791 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep10793 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep10795 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep10797 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep10799 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep10801 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep10803 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep10805 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep10807 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  br label %B122.if.i.i10460

B122.if.i.i10460:                                 ; preds = %B122.if.i.i10460, %B122.if.i.preheader.i
  %.229.i.0726.i = phi i64 [ %.300.i.i, %B122.if.i.i10460 ], [ 0, %B122.if.i.preheader.i ]
  %.157.i.i.i10461 = add nsw i64 %.229.i.0726.i, %.155.i.i.i10459
  %.159.i.i.i10462 = mul nsw i64 %.157.i.i.i10461, %arg.shape.0
  %gep10792 = getelementptr double, ptr %invariant.gep10791, i64 %.159.i.i.i10462
  %.191.i.i.i10463 = load double, ptr %gep10792, align 8, !noalias !144
  %.193.i.i.i10464 = fadd double %.191.i.i.i10463, 0.000000e+00
  %.253.i.i.i10465 = fmul double %.456.i, %.193.i.i.i10464
  %.157.i.i.1.i = add nsw i64 %.229.i.0726.i, %.155.i.i.1.i10466
  %.159.i.i.1.i = mul nsw i64 %.157.i.i.1.i, %arg.shape.0
  %gep10794 = getelementptr double, ptr %invariant.gep10793, i64 %.159.i.i.1.i
  %.191.i.i.1.i = load double, ptr %gep10794, align 8, !noalias !144
  %.193.i.i.1.i = fadd double %.191.i.i.1.i, %.253.i.i.i10465
  %.253.i.i.1.i = fmul double %.247.i.i.i10456, %.193.i.i.1.i
  %.157.i.i.2.i = add nsw i64 %.229.i.0726.i, %.155.i.i.2.i10467
  %.159.i.i.2.i = mul nsw i64 %.157.i.i.2.i, %arg.shape.0
  %gep10796 = getelementptr double, ptr %invariant.gep10795, i64 %.159.i.i.2.i
  %.191.i.i.2.i = load double, ptr %gep10796, align 8, !noalias !144
  %.193.i.i.2.i = fadd double %.191.i.i.2.i, %.253.i.i.1.i
  %.253.i.i.2.i = fmul double %.456.i, %.193.i.i.2.i
  %.157.i.i.3.i = add nsw i64 %.229.i.0726.i, %.155.i.i.3.i10468
  %.159.i.i.3.i = mul nsw i64 %.157.i.i.3.i, %arg.shape.0
  %gep10798 = getelementptr double, ptr %invariant.gep10797, i64 %.159.i.i.3.i
  %.191.i.i.3.i = load double, ptr %gep10798, align 8, !noalias !144
  %.193.i.i.3.i = fadd double %.191.i.i.3.i, %.253.i.i.2.i
  %.253.i.i.3.i = fmul double %.247.i.i.i10456, %.193.i.i.3.i
  %.157.i.i.4.i = add nsw i64 %.229.i.0726.i, %.155.i.i.4.i10469
  %.159.i.i.4.i = mul nsw i64 %.157.i.i.4.i, %arg.shape.0
  %gep10800 = getelementptr double, ptr %invariant.gep10799, i64 %.159.i.i.4.i
  %.191.i.i.4.i = load double, ptr %gep10800, align 8, !noalias !144
  %.193.i.i.4.i = fadd double %.191.i.i.4.i, %.253.i.i.3.i
  %.253.i.i.4.i = fmul double %.456.i, %.193.i.i.4.i
  %.157.i.i.5.i = add nsw i64 %.229.i.0726.i, %.155.i.i.5.i10470
  %.159.i.i.5.i = mul nsw i64 %.157.i.i.5.i, %arg.shape.0
  %gep10802 = getelementptr double, ptr %invariant.gep10801, i64 %.159.i.i.5.i
  %.191.i.i.5.i = load double, ptr %gep10802, align 8, !noalias !144
  %.193.i.i.5.i = fadd double %.191.i.i.5.i, %.253.i.i.4.i
  %.253.i.i.5.i = fmul double %.247.i.i.i10456, %.193.i.i.5.i
  %.157.i.i.6.i = add nsw i64 %.229.i.0726.i, %.155.i.i.6.i10471
  %.159.i.i.6.i = mul nsw i64 %.157.i.i.6.i, %arg.shape.0
  %gep10804 = getelementptr double, ptr %invariant.gep10803, i64 %.159.i.i.6.i
  %.191.i.i.6.i = load double, ptr %gep10804, align 8, !noalias !144
  %.193.i.i.6.i = fadd double %.191.i.i.6.i, %.253.i.i.5.i
  %.253.i.i.6.i = fmul double %.456.i, %.193.i.i.6.i
  %.300.i.i = add nsw i64 %.229.i.0726.i, 1
  %.271.i.i.i10472 = mul nsw i64 %.229.i.0726.i, %arg.shape.0
  %gep10806 = getelementptr double, ptr %invariant.gep10805, i64 %.271.i.i.i10472
  %.309.i.i.i10473 = load double, ptr %gep10806, align 8, !noalias !144
  %.313.i.i.i10474 = fadd double %.309.i.i.i10473, %.253.i.i.6.i
  %.359.i.i10475 = add nsw i64 %.229.i.0726.i, %.358.i.i10453
  %.361.i.i = mul nsw i64 %.359.i.i10475, %arg.shape.0
  %gep10808 = getelementptr double, ptr %invariant.gep10807, i64 %.361.i.i
  store double %.313.i.i.i10474, ptr %gep10808, align 8, !noalias !140
  %exitcond.not.i10476 = icmp eq i64 %arg.shape.1, %.300.i.i
  br i1 %exitcond.not.i10476, label %B154.loopexit.i, label %B122.if.i.i10460

B348.if.i:                                        ; preds = %B564.i, %B206.i
  %.667.0732.i = phi i64 [ 0, %B206.i ], [ %.736.i, %B564.i ]
  %.736.i = add nsw i64 %.667.0732.i, 1
  %.817.i = getelementptr double, ptr %84, i64 %.667.0732.i
  %.818.i10477 = load double, ptr %.817.i, align 8, !noalias !134
  %.819.i = fcmp ogt double %.818.i10477, 5.000000e-01
  br i1 %.819.i, label %B390.i, label %B564.i

B426.endif.i:                                     ; preds = %B80.i.i10480, %B46.i.i10479, %B426.i
  store double 0.000000e+00, ptr %.817.i, align 8, !noalias !134
  %.1014.i = getelementptr double, ptr %85, i64 %.667.0732.i
  store double %.952.i, ptr %.1014.i, align 8, !noalias !134
  %.1071.i = getelementptr double, ptr %86, i64 %.667.0732.i
  store double %.960.i, ptr %.1071.i, align 8, !noalias !134
  br label %B564.i

B3300:                                            ; preds = %B120.loopexit.i, %B2728, %B3238
  %234 = select i1 %looked.2.1.lcssa, i1 %good.2.1.lcssa, i1 false
  br i1 %234, label %B3308, label %B3360

B3308:                                            ; preds = %B3300
  %within.5.1.not = xor i1 %within.5.1, true
  %brmerge10386 = select i1 %within.5.1.not, i1 true, i1 %.614
  %"$phi3344.7.2.2" = select i1 %brmerge10386, i64 0, i64 3
  br i1 %.665, label %B3360, label %B96.if.i

B172.i:                                           ; preds = %B96.if.i
  %.452.i10485 = getelementptr double, ptr %88, i64 %.180.0654.i
  %.453.i10486 = load double, ptr %.452.i10485, align 8, !noalias !148
  %.454.i10487 = fcmp olt double %.453.i10486, 5.000000e-01
  br i1 %.454.i10487, label %B789.i, label %B210.i

B210.i:                                           ; preds = %B172.i
  %.485.i10488 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.334.i
  %.486.i = load i64, ptr %.485.i10488, align 8, !noalias !148
  %.487.not.i = icmp eq i64 %.486.i, 0
  br i1 %.487.not.i, label %B246.i, label %B789.i

B246.i:                                           ; preds = %B210.i
  %.549.i = mul i64 %.334.i, %arg.batch.3.3.5.1
  %235 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.549.i
  %.553.i = getelementptr i8, ptr %235, i64 8
  %.554.i = load i64, ptr %.553.i, align 8, !noalias !148
  %.556.i = add nsw i64 %.554.i, %"$phi3344.7.2.2"
  store i64 %.556.i, ptr %.553.i, align 8, !noalias !148
  %.662.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.180.0654.i
  %.663.i = load double, ptr %.662.i, align 8, !noalias !148
  %.717.i = getelementptr double, ptr %89, i64 %.180.0654.i
  %.718.i = load double, ptr %.717.i, align 8, !noalias !148
  %.772.i10489 = getelementptr double, ptr %90, i64 %.180.0654.i
  %.773.i10490 = load double, ptr %.772.i10489, align 8, !noalias !148
  %.794.i = icmp slt i64 %.389.i, %arg.batch.2.5.0
  br i1 %.794.i, label %B420.i, label %B760.i

B420.i:                                           ; preds = %B246.i
  %.817.i10491 = icmp slt i64 %.389.i, 0
  %.818.i10492 = select i1 %.817.i10491, i64 %arg.batch.2.5.0, i64 0
  %236 = getelementptr double, ptr %arg.batch.2.4, i64 %.389.i
  %.832.i10493 = getelementptr double, ptr %236, i64 %.818.i10492
  %.833.i10494 = load double, ptr %.832.i10493, align 8, !noalias !148
  %.837.i = fcmp ugt double %.833.i10494, %.773.i10490
  br i1 %.837.i, label %B760.i, label %B444.preheader.i

B444.preheader.i:                                 ; preds = %B420.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul652.i, %.334.i
  %.1324.i = getelementptr double, ptr %91, i64 %.180.0654.i
  %237 = getelementptr double, ptr %arg.batch.3.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep10809 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep10811 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep10813 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep10815 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep10817 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep10819 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep10821 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep10823 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep10825 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  br label %B444.i

B444.i:                                           ; preds = %B736.i, %B444.preheader.i
  %done.2.3.i = phi i64 [ %.1262.i, %B736.i ], [ %.389.i, %B444.preheader.i ]
  br i1 %.924649.not.i, label %B644.i, label %B474.if.lr.ph.i

B474.if.lr.ph.i:                                  ; preds = %B444.i
  %.979.i10495 = icmp slt i64 %done.2.3.i, 0
  %.980.i10496 = select i1 %.979.i10495, i64 %arg.batch.2.5.0, i64 0
  %238 = getelementptr double, ptr %arg.batch.2.4, i64 %done.2.3.i
  %.994.i = getelementptr double, ptr %238, i64 %.980.i10496
  %.1220.i = select i1 %.979.i10495, i64 %arg.batch.3.0.5.1, i64 0
  %.1221.i = add i64 %.1220.i, %done.2.3.i
  %.1250.i = mul i64 %.1221.i, %arg.batch.3.0.5.2
  %239 = getelementptr double, ptr %237, i64 %.1250.i
  br label %B474.if.i

B502.i10500:                                      ; preds = %B474.if.i
  %.1002.i = add nsw i64 %.868.0650.i, %.1000.i
  %.1004.i = mul nsw i64 %.1002.i, %arg.shape.0
  %gep10826 = getelementptr double, ptr %invariant.gep10825, i64 %.1004.i
  %.1036.i = load double, ptr %gep10826, align 8, !noalias !148
  br label %B790.i

B644.i:                                           ; preds = %B790.i, %B444.i
  store double 0x7FF0000000000000, ptr %.1324.i, align 8, !noalias !148
  %exitcond656.not.i = icmp eq i64 %done.2.3.i, %92
  br i1 %exitcond656.not.i, label %B760.i, label %B736.i

B736.i:                                           ; preds = %B644.i
  %.1262.i = add i64 %done.2.3.i, 1
  %.1359.i = icmp slt i64 %done.2.3.i, -1
  %.1360.i = select i1 %.1359.i, i64 %arg.batch.2.5.0, i64 0
  %240 = getelementptr double, ptr %arg.batch.2.4, i64 %.1262.i
  %.1374.i = getelementptr double, ptr %240, i64 %.1360.i
  %.1375.i = load double, ptr %.1374.i, align 8, !noalias !148
  %.1379.i = fcmp ugt double %.1375.i, %.773.i10490
  br i1 %.1379.i, label %B760.i, label %B444.i

B760.i:                                           ; preds = %B736.i, %B644.i, %B420.i, %B246.i
  %done.3.2.i = phi i64 [ %.389.i, %B420.i ], [ %.389.i, %B246.i ], [ %arg.batch.2.5.0, %B644.i ], [ %.1262.i, %B736.i ]
  store i64 %done.3.2.i, ptr %.388.i, align 8, !noalias !148
  br label %B789.i

B789.i:                                           ; preds = %B96.if.i, %B760.i, %B210.i, %B172.i
  %exitcond657.not.i = icmp eq i64 %.252.i10483, %arg.shape.0
  br i1 %exitcond657.not.i, label %B3360, label %B96.if.i

B790.i:                                           ; preds = %B38.if.i.i, %B502.i10500
  %.313.i.i.sink = phi double [ %.313.i.i, %B38.if.i.i ], [ %.1036.i, %B502.i10500 ]
  %241 = getelementptr double, ptr %239, i64 %.868.0650.i
  store double %.313.i.i.sink, ptr %241, align 8, !noalias !148
  %exitcond.not.i10499 = icmp eq i64 %arg.shape.1, %.937.i
  br i1 %exitcond.not.i10499, label %B644.i, label %B474.if.i

B96.if.i:                                         ; preds = %B3308, %B789.i
  %.180.0654.i = phi i64 [ %.252.i10483, %B789.i ], [ 0, %B3308 ]
  %.252.i10483 = add nsw i64 %.180.0654.i, 1
  %.333.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.180.0654.i
  %.334.i = load i64, ptr %.333.i, align 8, !noalias !148
  %.388.i = getelementptr i64, ptr %87, i64 %.180.0654.i
  %.389.i = load i64, ptr %.388.i, align 8, !noalias !148
  %.397.i10484 = icmp slt i64 %.334.i, 0
  br i1 %.397.i10484, label %B789.i, label %B172.i

B474.if.i:                                        ; preds = %B790.i, %B474.if.lr.ph.i
  %.868.0650.i = phi i64 [ 0, %B474.if.lr.ph.i ], [ %.937.i, %B790.i ]
  %.937.i = add nsw i64 %.868.0650.i, 1
  %.995.i = load double, ptr %.994.i, align 8, !noalias !148
  %.997.i = fcmp oeq double %.995.i, %.773.i10490
  br i1 %.997.i, label %B502.i10500, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B474.if.i
  %.1145.i = fsub double %.995.i, %.663.i
  %.1150.i = fdiv double %.1145.i, %.718.i
  %.247.i.i = fsub double 1.000000e+00, %.1150.i
  %.157.i.i = add nsw i64 %.868.0650.i, %.155.i.i
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep10810 = getelementptr double, ptr %invariant.gep10809, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep10810, align 8, !noalias !151
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i10497 = fmul double %.1150.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.868.0650.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep10812 = getelementptr double, ptr %invariant.gep10811, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep10812, align 8, !noalias !151
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i10497
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.868.0650.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep10814 = getelementptr double, ptr %invariant.gep10813, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep10814, align 8, !noalias !151
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %.1150.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.868.0650.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep10816 = getelementptr double, ptr %invariant.gep10815, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep10816, align 8, !noalias !151
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.868.0650.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep10818 = getelementptr double, ptr %invariant.gep10817, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep10818, align 8, !noalias !151
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %.1150.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.868.0650.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep10820 = getelementptr double, ptr %invariant.gep10819, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep10820, align 8, !noalias !151
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.868.0650.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep10822 = getelementptr double, ptr %invariant.gep10821, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep10822, align 8, !noalias !151
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %.1150.i, %.193.i.6.i
  %.271.i.i10498 = mul nsw i64 %.868.0650.i, %arg.shape.0
  %gep10824 = getelementptr double, ptr %invariant.gep10823, i64 %.271.i.i10498
  %.309.i.i = load double, ptr %gep10824, align 8, !noalias !151
  %.313.i.i = fadd double %.309.i.i, %.253.i.6.i
  br label %B790.i

B3360:                                            ; preds = %B789.i, %B3308, %B3300
  br i1 %.5038, label %B3410, label %B3372

B3372:                                            ; preds = %B3360
  %.5093 = load double, ptr %.5092, align 8
  %.5094 = fcmp ogt double %.5093, 5.000000e-01
  br i1 %.5094, label %B3410, label %B3478

B3410:                                            ; preds = %B3372, %B3360
  %.5125 = load i64, ptr %.5124, align 8
  %.5170 = inttoptr i64 %.5125 to ptr
  tail call void %.5170(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3478

B3478:                                            ; preds = %B3410, %B3372
  %.not = xor i1 %206, true
  %brmerge10856 = or i1 %.665, %.not
  br i1 %brmerge10856, label %B3534, label %B80.if.i6890

B134.i:                                           ; preds = %B80.if.i6890
  %.351.i6150 = getelementptr double, ptr %94, i64 %.141.i5909.010834
  %.352.i6151 = load double, ptr %.351.i6150, align 8, !noalias !155
  %.353.i6152 = fcmp ogt double %.352.i6151, 5.000000e-01
  br i1 %.353.i6152, label %B174.i, label %B740.i

B174.i:                                           ; preds = %B134.i
  %.408.i6199 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.141.i5909.010834
  %.409.i6200 = load double, ptr %.408.i6199, align 8, !noalias !155
  %.463.i6247 = getelementptr double, ptr %95, i64 %.141.i5909.010834
  %.464.i6248 = load double, ptr %.463.i6247, align 8, !noalias !155
  %.465.i6249 = fsub double %.409.i6200, %.464.i6248
  br i1 %.552.i628610827.not, label %B380.i, label %B270.if.i.preheader

B270.if.i.preheader:                              ; preds = %B174.i
  %invariant.gep10936 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.141.i5909.010834
  br label %B270.if.i

B380.i:                                           ; preds = %B270.if.i, %B174.i
  %fastest.2.i.2.lcssa = phi double [ 0.000000e+00, %B174.i ], [ %.11.i.i, %B270.if.i ]
  %.666.i6298 = fmul double %.465.i6249, %fastest.2.i.2.lcssa
  %.698.i6324 = load double, ptr %.697.i6323, align 8, !noalias !155
  %.699.i6325 = fcmp ogt double %.666.i6298, %.698.i6324
  %.10390 = select i1 %.699.i6325, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  %.743.i6353 = load double, ptr %.742.i6352, align 8, !noalias !155
  %.773.i6378 = load double, ptr %arg.batch.2.4, align 8, !noalias !155
  %.774.i6379 = fsub double %.743.i6353, %.773.i6378
  %.776.i6381 = fmul double %.10390, %.774.i6379
  %.780.i6384 = fcmp olt double %.465.i6249, %.776.i6381
  br i1 %.780.i6384, label %B490.i, label %B528.i

B490.i:                                           ; preds = %B380.i
  %242 = getelementptr i64, ptr %97, i64 %.141.i5909.010834
  %.838.i6826 = load i64, ptr %242, align 8, !noalias !155
  %.839.i6827 = add nsw i64 %.838.i6826, 1
  br label %B528.i

B528.i:                                           ; preds = %B380.i, %B490.i
  %"$phi528.1.2.i.2" = phi i64 [ %.839.i6827, %B490.i ], [ 0, %B380.i ]
  %243 = getelementptr i64, ptr %98, i64 %.141.i5909.010834
  store i64 %"$phi528.1.2.i.2", ptr %243, align 8, !noalias !155
  %.959.i6481 = load double, ptr %.408.i6199, align 8, !noalias !155
  store double %.959.i6481, ptr %.463.i6247, align 8, !noalias !155
  %.1068.i6571 = getelementptr double, ptr %99, i64 %.141.i5909.010834
  store double 1.000000e+00, ptr %.1068.i6571, align 8, !noalias !155
  store i64 1, ptr %.1037, align 8, !noalias !155
  %.1154.i6636 = load i64, ptr %243, align 8, !noalias !155
  %.1155.i6637 = icmp sgt i64 %.1154.i6636, 1000
  br i1 %.1155.i6637, label %B694.i, label %B740.i

B694.i:                                           ; preds = %B528.i
  %244 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.141.i5909.010834
  %.84.i.i6715 = load i64, ptr %244, align 8, !noalias !159
  %.89.i.i6718 = icmp sgt i64 %.84.i.i6715, -1
  br i1 %.89.i.i6718, label %B46.i.i6726, label %B740.i

B46.i.i6726:                                      ; preds = %B694.i
  %.120.i.i6746 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i6715
  %.121.i.i6747 = load i64, ptr %.120.i.i6746, align 8, !noalias !159
  %.122.i.i6748 = icmp eq i64 %.121.i.i6747, 0
  br i1 %.122.i.i6748, label %B80.i.i6753, label %B740.i

B80.i.i6753:                                      ; preds = %B46.i.i6726
  store i64 6, ptr %.120.i.i6746, align 8, !noalias !159
  br label %B740.i

B740.i:                                           ; preds = %B80.i.i6753, %B694.i, %B46.i.i6726, %B528.i, %B134.i, %B80.if.i6890
  store double 0.000000e+00, ptr %.294.i6064, align 8, !noalias !155
  %.200.i5995 = icmp sgt i64 %.144.i5910.010833, 1
  br i1 %.200.i5995, label %B80.if.i6890, label %B3534

B80.if.i6890:                                     ; preds = %B3478, %B740.i
  %.141.i5909.010834 = phi i64 [ %.213.i6898, %B740.i ], [ 0, %B3478 ]
  %.144.i5910.010833 = phi i64 [ %.209.i6895, %B740.i ], [ %storemerge, %B3478 ]
  %.209.i6895 = add nsw i64 %.144.i5910.010833, -1
  %.213.i6898 = add nsw i64 %.141.i5909.010834, 1
  %.294.i6064 = getelementptr double, ptr %93, i64 %.141.i5909.010834
  %.295.i6065 = load double, ptr %.294.i6064, align 8, !noalias !155
  %.296.i6066 = fcmp oeq double %.295.i6065, 1.000000e+00
  br i1 %.296.i6066, label %B134.i, label %B740.i

B270.if.i:                                        ; preds = %B270.if.i.preheader, %B270.if.i
  %fastest.2.i.210830 = phi double [ %.11.i.i, %B270.if.i ], [ 0.000000e+00, %B270.if.i.preheader ]
  %.496.i5926.010829 = phi i64 [ %.565.i6882, %B270.if.i ], [ 0, %B270.if.i.preheader ]
  %.565.i6882 = add nsw i64 %.496.i5926.010829, 1
  %.592.i6834 = add nsw i64 %.496.i5926.010829, %arg.shape.1
  %.594.i6836 = mul nsw i64 %.592.i6834, %arg.shape.0
  %gep10937 = getelementptr double, ptr %invariant.gep10936, i64 %.594.i6836
  %.626.i6864 = load double, ptr %gep10937, align 8, !noalias !155
  %.627.i6865 = tail call double @llvm.fabs.f64(double %.626.i6864)
  %.10.i.i = fcmp ogt double %.627.i6865, %fastest.2.i.210830
  %.11.i.i = select i1 %.10.i.i, double %.627.i6865, double %fastest.2.i.210830
  %exitcond10884.not = icmp eq i64 %arg.shape.1, %.565.i6882
  br i1 %exitcond10884.not, label %B380.i, label %B270.if.i

B3534:                                            ; preds = %B740.i, %B3478
  %brmerge10392.not = and i1 %.5240.not, %looked.2.1.lcssa
  %brmerge10392.not.not = xor i1 %brmerge10392.not, true
  %brmerge10855 = or i1 %.665, %brmerge10392.not.not
  br i1 %brmerge10855, label %B3584, label %B114.if.i

B46.i.i10501:                                     ; preds = %B114.if.i
  %.135.i.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !162
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i10505, label %B228.i

B80.i.i10505:                                     ; preds = %B46.i.i10501
  %.196.i.i = getelementptr double, ptr %100, i64 %.302.01639.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !162
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B228.i, label %B122.i.i10506

B122.i.i10506:                                    ; preds = %B80.i.i10505
  %.264.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.302.01639.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !162
  %.321.i.i = getelementptr double, ptr %101, i64 %.302.01639.i
  %.322.i.i = load double, ptr %.321.i.i, align 8, !noalias !162
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.175.i3061635.not.i
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01641.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01641.i
  br i1 %brmerge.i, label %B228.i, label %B76.if.i.lr.ph.i10507

B76.if.i.lr.ph.i10507:                            ; preds = %B122.i.i10506
  %245 = getelementptr i64, ptr %102, i64 %.302.01639.i
  %.513.i = load i64, ptr %245, align 8, !noalias !167
  %.514.i = add nsw i64 %.513.i, 1
  %.236.i323.i = icmp slt i64 %.513.i, -1
  %.237.i324.i = select i1 %.236.i323.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i325.i = add i64 %.514.i, %.237.i324.i
  %.258.i342.i = mul i64 %.238.i325.i, %arg.batch.1.3.5.1
  %246 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i342.i
  br label %B76.if.i.i10508

B76.if.i.i10508:                                  ; preds = %B76.if.i.i10508, %B76.if.i.lr.ph.i10507
  %.117.i268.01636.i = phi i64 [ 0, %B76.if.i.lr.ph.i10507 ], [ %.188.i390.i, %B76.if.i.i10508 ]
  %.188.i390.i = add nsw i64 %.117.i268.01636.i, 1
  %247 = getelementptr double, ptr %246, i64 %.117.i268.01636.i
  %.263.i344.i = load double, ptr %247, align 8, !noalias !168
  %248 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i268.01636.i
  %.293.i360.i = load i64, ptr %248, align 8, !noalias !168
  %.295.i362.i = mul nsw i64 %.293.i360.i, %arg.shape.0
  %.297.i364.i = add nsw i64 %.295.i362.i, %.302.01639.i
  %.311.i372.i = icmp slt i64 %.297.i364.i, 0
  %.312.i373.i = select i1 %.311.i372.i, i64 %arg.batch.5.1.5.0, i64 0
  %249 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i364.i
  %.326.i383.i = getelementptr double, ptr %249, i64 %.312.i373.i
  store double %.263.i344.i, ptr %.326.i383.i, align 8, !noalias !168
  %exitcond.not.i10509 = icmp eq i64 %arg.batch.1.1.5.0, %.188.i390.i
  br i1 %exitcond.not.i10509, label %B228.i, label %B76.if.i.i10508

B228.i:                                           ; preds = %B76.if.i.i10508, %B114.if.i, %B122.i.i10506, %B80.i.i10505, %B46.i.i10501
  %some.3.1.i = phi i1 [ %some.2.01641.mux.i, %B122.i.i10506 ], [ %some.2.01641.i, %B80.i.i10505 ], [ %some.2.01641.i, %B114.if.i ], [ %some.2.01641.i, %B46.i.i10501 ], [ true, %B76.if.i.i10508 ]
  %exitcond1650.not.i = icmp eq i64 %arg.shape.0, %.373.i
  br i1 %exitcond1650.not.i, label %B230.i, label %B114.if.i

B230.i:                                           ; preds = %B228.i
  br i1 %some.3.1.i, label %B238.i, label %B3584

B238.i:                                           ; preds = %B230.i
  %.637.i = load i64, ptr %.636.i, align 8, !noalias !167
  %.749.i = inttoptr i64 %.637.i to ptr
  tail call void %.749.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !167
  %.780.i = load i64, ptr %.779.i, align 8, !noalias !167
  %.896.i = inttoptr i64 %.780.i to ptr
  tail call void %.896.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.895.i10502), !noalias !167
  br i1 %.900.not.i, label %B598.if.i.preheader, label %B456.i

B456.i:                                           ; preds = %B238.i
  %.931.i = load i64, ptr %.930.i, align 8, !noalias !167
  %.1049.i = inttoptr i64 %.931.i to ptr
  tail call void %.1049.i(ptr %arg.batch.4.0.4, ptr %.895.i10502, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !167
  br label %B598.if.i.preheader

B598.if.i.preheader:                              ; preds = %B456.i, %B238.i
  br label %B598.if.i

B46.i82.i:                                        ; preds = %B598.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !172
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B1076.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %100, i64 %.1090.01648.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !172
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B1076.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.1090.01648.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !172
  %.321.i223.i = getelementptr double, ptr %101, i64 %.1090.01648.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !172
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B1076.i, label %B638.i

B638.i:                                           ; preds = %B122.i147.i
  %.1344.i = getelementptr i64, ptr %103, i64 %.1090.01648.i
  %.1345.i = load i64, ptr %.1344.i, align 8, !noalias !167
  %.1356.i = icmp sgt i64 %.1345.i, 0
  br i1 %.1356.i, label %B714.i, label %B768.i

B714.i:                                           ; preds = %B638.i
  %250 = getelementptr double, ptr %arg.batch.2.4, i64 %.1345.i
  %.1391.i = getelementptr i8, ptr %250, i64 -8
  %.1392.i = load double, ptr %.1391.i, align 8, !noalias !167
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
  %251 = getelementptr double, ptr %arg.batch.3.0.4, i64 %.1741.i
  %252 = getelementptr double, ptr %251, i64 %.1743.i
  %invariant.gep10835 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  %invariant.gep10837 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  br label %B800.if.i

B896.i:                                           ; preds = %B800.if.i
  %253 = getelementptr double, ptr %252, i64 %.1488.01643.i
  store double %.1622.i, ptr %253, align 8, !noalias !167
  br label %B918.i

B918.i:                                           ; preds = %B800.if.i, %B896.i
  %exitcond1651.not.i = icmp eq i64 %arg.shape.1, %.1557.i
  br i1 %exitcond1651.not.i, label %B920.loopexit.i, label %B800.if.i

B920.loopexit.i:                                  ; preds = %B918.i
  %254 = fcmp une double %.1629.i, 0.000000e+00
  br i1 %254, label %B932.i, label %B978.i

B932.i:                                           ; preds = %B920.loopexit.i
  %.84.i452.i = load i64, ptr %257, align 8, !noalias !175
  %.89.i454.i = icmp sgt i64 %.84.i452.i, -1
  br i1 %.89.i454.i, label %B46.i458.i, label %B978.i

B46.i458.i:                                       ; preds = %B932.i
  %.120.i478.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i452.i
  %.121.i479.i = load i64, ptr %.120.i478.i, align 8, !noalias !175
  %.122.i480.i = icmp eq i64 %.121.i479.i, 0
  br i1 %.122.i480.i, label %B80.i484.i, label %B978.i

B80.i484.i:                                       ; preds = %B46.i458.i
  store i64 3, ptr %.120.i478.i, align 8, !noalias !175
  br label %B978.i

B978.i:                                           ; preds = %B80.i484.i, %B46.i458.i, %B932.i, %B920.loopexit.i, %B768.i
  br i1 %.900.not.i, label %B1076.i, label %B994.i

B994.i:                                           ; preds = %B978.i
  %255 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.1090.01648.i
  %.1846.i = load double, ptr %255, align 8, !noalias !167
  %.1848.i = fcmp olt double %.1846.i, -1.000000e-09
  br i1 %.1848.i, label %B1030.i, label %B1076.i

B1030.i:                                          ; preds = %B994.i
  %.84.i583.i = load i64, ptr %257, align 8, !noalias !178
  %.89.i586.i = icmp sgt i64 %.84.i583.i, -1
  br i1 %.89.i586.i, label %B46.i591.i, label %B1076.i

B46.i591.i:                                       ; preds = %B1030.i
  %.120.i616.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i583.i
  %.121.i617.i = load i64, ptr %.120.i616.i, align 8, !noalias !178
  %.122.i618.i = icmp eq i64 %.121.i617.i, 0
  br i1 %.122.i618.i, label %B80.i623.i, label %B1076.i

B80.i623.i:                                       ; preds = %B46.i591.i
  store i64 4, ptr %.120.i616.i, align 8, !noalias !178
  br label %B1076.i

B1076.i:                                          ; preds = %B598.if.i, %B80.i623.i, %B46.i591.i, %B1030.i, %B994.i, %B978.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %.1146.i = icmp sgt i64 %.1093.01649.i, 1
  br i1 %.1146.i, label %B598.if.i, label %B3584

B114.if.i:                                        ; preds = %B3534, %B228.i
  %some.2.01641.i = phi i1 [ %some.3.1.i, %B228.i ], [ false, %B3534 ]
  %.302.01639.i = phi i64 [ %.373.i, %B228.i ], [ 0, %B3534 ]
  %.373.i = add nsw i64 %.302.01639.i, 1
  %256 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.302.01639.i
  %.99.i.i = load i64, ptr %256, align 8, !noalias !162
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B228.i, label %B46.i.i10501

B598.if.i:                                        ; preds = %B598.if.i.preheader, %B1076.i
  %.1093.01649.i = phi i64 [ %.1155.i, %B1076.i ], [ %storemerge.i, %B598.if.i.preheader ]
  %.1090.01648.i = phi i64 [ %.1159.i, %B1076.i ], [ 0, %B598.if.i.preheader ]
  %.1155.i = add nsw i64 %.1093.01649.i, -1
  %.1159.i = add nsw i64 %.1090.01648.i, 1
  %257 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1090.01648.i
  %.99.i78.i = load i64, ptr %257, align 8, !noalias !172
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B1076.i, label %B46.i82.i

B800.if.i:                                        ; preds = %B918.i, %B800.if.lr.ph.i
  %trouble.2.11645.i = phi double [ 0.000000e+00, %B800.if.lr.ph.i ], [ %.1629.i, %B918.i ]
  %.1488.01643.i = phi i64 [ 0, %B800.if.lr.ph.i ], [ %.1557.i, %B918.i ]
  %.1557.i = add nsw i64 %.1488.01643.i, 1
  %.1588.i = add nsw i64 %.1488.01643.i, %.850.i
  %.1590.i10504 = mul nsw i64 %.1588.i, %arg.shape.0
  %gep10836 = getelementptr double, ptr %invariant.gep10835, i64 %.1590.i10504
  %.1622.i = load double, ptr %gep10836, align 8, !noalias !167
  %.1627.i = fmul double %.1622.i, 0.000000e+00
  %.1629.i = fadd double %trouble.2.11645.i, %.1627.i
  %.1637.i = mul nsw i64 %.1488.01643.i, %arg.shape.0
  %gep10838 = getelementptr double, ptr %invariant.gep10837, i64 %.1637.i
  store double %.1622.i, ptr %gep10838, align 8, !noalias !167
  br i1 %"$phi768.1.2.1.i", label %B896.i, label %B918.i

B3584:                                            ; preds = %B1076.i, %B3534, %B230.i
  %looked.2.1.lcssa.not = xor i1 %looked.2.1.lcssa, true
  %brmerge10857 = or i1 %.665, %looked.2.1.lcssa.not
  %active.9.1.mux = select i1 %looked.2.1.lcssa, i64 0, i64 %active.9.1
  br i1 %brmerge10857, label %B4560, label %B3626.if

B3674:                                            ; preds = %B3626.if
  %.5625 = mul i64 %.5552, %arg.batch.3.3.5.1
  %.5629 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.5625
  %.5630 = load i64, ptr %.5629, align 8
  %.5686 = getelementptr i8, ptr %.5629, i64 24
  %.5687 = load i64, ptr %.5686, align 8
  %258 = add i64 %.5630, %.5687
  %.5688 = sub i64 %arg.most, %258
  %.5693 = icmp slt i64 %.5688, 1
  br i1 %.5693, label %B3754, label %B3800

B3754:                                            ; preds = %B3674
  %259 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5390.010843
  %.84.i6979 = load i64, ptr %259, align 8, !noalias !181
  %.89.i6982 = icmp sgt i64 %.84.i6979, -1
  br i1 %.89.i6982, label %B46.i6987, label %B3800

B46.i6987:                                        ; preds = %B3754
  %.120.i7013 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i6979
  %.121.i7014 = load i64, ptr %.120.i7013, align 8, !noalias !181
  %.122.i7015 = icmp eq i64 %.121.i7014, 0
  br i1 %.122.i7015, label %B80.i7020, label %B3800

B80.i7020:                                        ; preds = %B46.i6987
  store i64 5, ptr %.120.i7013, align 8, !noalias !181
  br label %B3800

B3800:                                            ; preds = %B80.i7020, %B3754, %B46.i6987, %B3674
  %.5783 = getelementptr double, ptr %104, i64 %.5390.010843
  %.5784 = load double, ptr %.5783, align 8
  %.5785 = fcmp ogt double %.5784, 5.000000e-01
  br i1 %.5785, label %B3838, label %B3942

B3838:                                            ; preds = %B3800
  %.5840 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5390.010843
  %.5841 = load double, ptr %.5840, align 8
  %.5895 = getelementptr double, ptr %105, i64 %.5390.010843
  %.5896 = load double, ptr %.5895, align 8
  %.5897 = fcmp oeq double %.5841, %.5896
  br i1 %.5897, label %B3902, label %B3942

B3902:                                            ; preds = %B3838
  %.192.i7248 = load i64, ptr %.5551, align 8, !noalias !184
  %.248.i7296 = getelementptr i64, ptr %106, i64 %.5390.010843
  %.249.i7297 = load i64, ptr %.248.i7296, align 8, !noalias !184
  %.250.i7298 = add nsw i64 %.249.i7297, 1
  store i64 %.250.i7298, ptr %.248.i7296, align 8, !noalias !184
  %.373.i7403 = icmp slt i64 %.249.i7297, -1
  %.374.i7404 = select i1 %.373.i7403, i64 %arg.batch.1.2.5.0, i64 0
  %260 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.250.i7298
  %.388.i7418 = getelementptr double, ptr %260, i64 %.374.i7404
  %.389.i7419 = load double, ptr %.388.i7418, align 8, !noalias !184
  %.390.i7420 = fcmp oeq double %.389.i7419, 0x7FF0000000000000
  br i1 %.390.i7420, label %B182.i, label %B240.i7421

B182.i:                                           ; preds = %B3902
  %.424.i7948 = icmp slt i64 %.192.i7248, 0
  %.425.i7949 = select i1 %.424.i7948, i64 %arg.batch.3.1.5.0, i64 0
  %261 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.192.i7248
  %.439.i7963 = getelementptr i64, ptr %261, i64 %.425.i7949
  %.440.i7964 = load i64, ptr %.439.i7963, align 8, !noalias !184
  %.441.i7965 = icmp eq i64 %.440.i7964, 0
  br i1 %.441.i7965, label %B216.i7969, label %B3942

B216.i7969:                                       ; preds = %B182.i
  store i64 1, ptr %.439.i7963, align 8, !noalias !184
  br label %B3942

B240.i7421:                                       ; preds = %B3902
  store double %.389.i7419, ptr %.5895, align 8, !noalias !184
  %.592.i7511 = select i1 %.373.i7403, i64 %arg.batch.1.4.5.0, i64 0
  %262 = getelementptr i64, ptr %arg.batch.1.4.4, i64 %.250.i7298
  %.606.i7525 = getelementptr i64, ptr %262, i64 %.592.i7511
  %.607.i7526 = load i64, ptr %.606.i7525, align 8, !noalias !184
  %.610.i7528 = icmp eq i64 %.607.i7526, 0
  br i1 %.610.i7528, label %B300.i, label %B348.i

B300.i:                                           ; preds = %B240.i7421
  %.665.i7902 = getelementptr double, ptr %107, i64 %.5390.010843
  store double 1.000000e+00, ptr %.665.i7902, align 8, !noalias !184
  br label %B392.i.sink.split

B348.i:                                           ; preds = %B240.i7421
  %.733.i7553 = load i64, ptr %.1037, align 8, !noalias !184
  %.734.i7554 = icmp eq i64 %.733.i7553, 0
  br i1 %.734.i7554, label %B392.i.sink.split, label %B392.i

B392.i.sink.split:                                ; preds = %B348.i, %B300.i
  %.sink = phi i64 [ 1, %B300.i ], [ 2, %B348.i ]
  store i64 %.sink, ptr %.1037, align 8, !noalias !184
  br label %B392.i

B392.i:                                           ; preds = %B392.i.sink.split, %B348.i
  br i1 %.175.i.i770610839.not, label %B3942, label %B76.if.i.i.lr.ph

B76.if.i.i.lr.ph:                                 ; preds = %B392.i
  %.237.i.i7755 = select i1 %.373.i7403, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i7756 = add i64 %.237.i.i7755, %.250.i7298
  %.258.i.i7772 = mul i64 %.238.i.i7756, %arg.batch.1.3.5.1
  %263 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i7772
  br label %B76.if.i.i

B76.if.i.i:                                       ; preds = %B76.if.i.i.lr.ph, %B76.if.i.i
  %.117.i.i7058.010841 = phi i64 [ 0, %B76.if.i.i.lr.ph ], [ %.188.i.i7821, %B76.if.i.i ]
  %.188.i.i7821 = add nsw i64 %.117.i.i7058.010841, 1
  %264 = getelementptr double, ptr %263, i64 %.117.i.i7058.010841
  %.263.i.i7775 = load double, ptr %264, align 8, !noalias !188
  %265 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.i7058.010841
  %.293.i.i7793 = load i64, ptr %265, align 8, !noalias !188
  %.295.i.i7795 = mul nsw i64 %.293.i.i7793, %arg.shape.0
  %.297.i.i7797 = add nsw i64 %.295.i.i7795, %.5390.010843
  %.311.i.i7804 = icmp slt i64 %.297.i.i7797, 0
  %.312.i.i7805 = select i1 %.311.i.i7804, i64 %arg.batch.5.1.5.0, i64 0
  %266 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i7797
  %.326.i.i7815 = getelementptr double, ptr %266, i64 %.312.i.i7805
  store double %.263.i.i7775, ptr %.326.i.i7815, align 8, !noalias !188
  %exitcond10885.not = icmp eq i64 %arg.batch.1.1.5.0, %.188.i.i7821
  br i1 %exitcond10885.not, label %B3942, label %B76.if.i.i

B3942:                                            ; preds = %B76.if.i.i, %B392.i, %B216.i7969, %B182.i, %B3838, %B3800
  %.5986 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.5552
  %.5987 = load i64, ptr %.5986, align 8
  %.5988.not = icmp eq i64 %.5987, 0
  br i1 %.5988.not, label %B4084, label %B3976

B3976:                                            ; preds = %B3942
  %.6049 = getelementptr i64, ptr %108, i64 %.5390.010843
  %.6050 = load i64, ptr %.6049, align 8
  %.6080 = getelementptr i64, ptr %arg.batch.3.2.4, i64 %.5552
  store i64 %.6050, ptr %.6080, align 8
  store i64 -1, ptr %.5551, align 8
  %.236.i10510 = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !192
  %.293.i10515 = getelementptr double, ptr %109, i64 %.5390.010843
  store double 0.000000e+00, ptr %.293.i10515, align 8, !noalias !192
  %.324.i10517 = load i64, ptr %.323.i10516, align 8, !noalias !192
  %.326.i10518 = icmp eq i64 %.236.i10510, %.324.i10517
  br i1 %.326.i10518, label %B4292, label %B132.i10519

B132.i10519:                                      ; preds = %B3976
  %.359.i10520 = add nsw i64 %.236.i10510, 1
  store i64 %.359.i10520, ptr %arg.batch.4.2.4, align 8, !noalias !192
  store i64 1, ptr %.1037, align 8, !noalias !192
  %.438.i10522 = icmp slt i64 %.236.i10510, 0
  %.439.i10523 = select i1 %.438.i10522, i64 %arg.batch.0.2.5.0, i64 0
  %267 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i10510
  %.453.i10524 = getelementptr i64, ptr %267, i64 %.439.i10523
  %.454.i10525 = load i64, ptr %.453.i10524, align 8, !noalias !192
  %.469.i10526 = icmp slt i64 %.454.i10525, 0
  %.470.i10527 = select i1 %.469.i10526, i64 %arg.batch.1.0.5.0, i64 0
  %268 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i10525
  %.484.i10528 = getelementptr i64, ptr %268, i64 %.470.i10527
  %.485.i10529 = load i64, ptr %.484.i10528, align 8, !noalias !192
  store i64 %.236.i10510, ptr %.5551, align 8, !noalias !192
  %.595.i10533 = getelementptr i64, ptr %110, i64 %.5390.010843
  store i64 %.485.i10529, ptr %.595.i10533, align 8, !noalias !192
  store i64 1, ptr %.6049, align 8, !noalias !192
  %.709.i10537 = getelementptr i64, ptr %111, i64 %.5390.010843
  store i64 0, ptr %.709.i10537, align 8, !noalias !192
  br i1 %.8051131.not.i10538, label %B402.i10553, label %B358.if.lr.ph.i10539

B358.if.lr.ph.i10539:                             ; preds = %B132.i10519
  %.867.i10540 = select i1 %.438.i10522, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i10541 = add i64 %.867.i10540, %.236.i10510
  %.888.i10542 = mul i64 %.868.i10541, %arg.batch.0.1.5.1
  %269 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i10542
  %invariant.gep10938 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.5390.010843
  br label %B358.if.i10543

B402.i10553:                                      ; preds = %B358.if.i10543, %B132.i10519
  br i1 %.175.i1134.not.i10554, label %B402.endif.i10572, label %B76.if.i.lr.ph.i10555

B76.if.i.lr.ph.i10555:                            ; preds = %B402.i10553
  %.990.i10556 = load i64, ptr %.595.i10533, align 8, !noalias !192
  %.236.i.i10557 = icmp slt i64 %.990.i10556, 0
  %.237.i.i10558 = select i1 %.236.i.i10557, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i10559 = add i64 %.237.i.i10558, %.990.i10556
  %.258.i.i10560 = mul i64 %.238.i.i10559, %arg.batch.1.3.5.1
  %270 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i10560
  br label %B76.if.i.i10561

B76.if.i.i10561:                                  ; preds = %B76.if.i.i10561, %B76.if.i.lr.ph.i10555
  %.117.i.01135.i10562 = phi i64 [ 0, %B76.if.i.lr.ph.i10555 ], [ %.188.i.i10563, %B76.if.i.i10561 ]
  %.188.i.i10563 = add nsw i64 %.117.i.01135.i10562, 1
  %271 = getelementptr double, ptr %270, i64 %.117.i.01135.i10562
  %.263.i.i10564 = load double, ptr %271, align 8, !noalias !195
  %272 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i10562
  %.293.i.i10565 = load i64, ptr %272, align 8, !noalias !195
  %.295.i.i10566 = mul nsw i64 %.293.i.i10565, %arg.shape.0
  %.297.i.i10567 = add nsw i64 %.295.i.i10566, %.5390.010843
  %.311.i.i10568 = icmp slt i64 %.297.i.i10567, 0
  %.312.i.i10569 = select i1 %.311.i.i10568, i64 %arg.batch.5.1.5.0, i64 0
  %273 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i10567
  %.326.i.i10570 = getelementptr double, ptr %273, i64 %.312.i.i10569
  store double %.263.i.i10564, ptr %.326.i.i10570, align 8, !noalias !195
  %exitcond1142.not.i10571 = icmp eq i64 %.188.i.i10563, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i10571, label %B402.endif.i10572, label %B76.if.i.i10561

B888.i10658:                                      ; preds = %B580.if.i10588
  store double 0.000000e+00, ptr %.1877.i10655, align 8, !noalias !192
  br label %B4292

B358.if.i10543:                                   ; preds = %B358.if.i10543, %B358.if.lr.ph.i10539
  %.747.01132.i10544 = phi i64 [ 0, %B358.if.lr.ph.i10539 ], [ %.818.i10545, %B358.if.i10543 ]
  %.818.i10545 = add nsw i64 %.747.01132.i10544, 1
  %274 = getelementptr double, ptr %269, i64 %.747.01132.i10544
  %.893.i10546 = load double, ptr %274, align 8, !noalias !192
  %.895.i10547 = mul nsw i64 %.747.01132.i10544, %arg.shape.0
  %gep10939 = getelementptr double, ptr %invariant.gep10938, i64 %.895.i10547
  store double %.893.i10546, ptr %gep10939, align 8, !noalias !192
  %exitcond.not.i10552 = icmp eq i64 %.818.i10545, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i10552, label %B402.i10553, label %B358.if.i10543

B402.endif.i10572:                                ; preds = %B76.if.i.i10561, %B402.i10553
  br i1 %.11171137.not.i10573, label %B580.if.i10588, label %B496.if.lr.ph.i10574

B496.if.lr.ph.i10574:                             ; preds = %B402.endif.i10572
  %.1179.i10575 = select i1 %.438.i10522, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i10576 = add i64 %.1179.i10575, %.236.i10510
  %.1200.i10577 = mul i64 %.1180.i10576, %arg.batch.0.0.5.1
  %275 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i10577
  %invariant.gep10940 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.5390.010843
  br label %B496.if.i10578

B496.if.i10578:                                   ; preds = %B496.if.i10578, %B496.if.lr.ph.i10574
  %.1061.01138.i10579 = phi i64 [ 0, %B496.if.lr.ph.i10574 ], [ %.1130.i10580, %B496.if.i10578 ]
  %.1130.i10580 = add nsw i64 %.1061.01138.i10579, 1
  %276 = getelementptr double, ptr %275, i64 %.1061.01138.i10579
  %.1205.i10581 = load double, ptr %276, align 8, !noalias !192
  %.1207.i10582 = mul nsw i64 %.1061.01138.i10579, %arg.shape.0
  %gep10941 = getelementptr double, ptr %invariant.gep10940, i64 %.1207.i10582
  store double %.1205.i10581, ptr %gep10941, align 8, !noalias !192
  %exitcond1143.not.i10587 = icmp eq i64 %.1130.i10580, %arg.shape.1
  br i1 %exitcond1143.not.i10587, label %B580.if.i10588, label %B496.if.i10578

B580.if.i10588:                                   ; preds = %B496.if.i10578, %B402.endif.i10572
  %invariant.gep.i10589 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5390.010843
  store double 0.000000e+00, ptr %invariant.gep.i10589, align 8, !noalias !192
  %gep.1.i10590 = getelementptr double, ptr %invariant.gep.i10589, i64 %arg.batch.4.0.5.1
  store double 0.000000e+00, ptr %gep.1.i10590, align 8, !noalias !192
  %gep.2.i10592 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.2.idx.i10591
  store double 0.000000e+00, ptr %gep.2.i10592, align 8, !noalias !192
  %gep.3.i10594 = getelementptr i8, ptr %invariant.gep.i10589, i64 %.idx.i10514
  store double 0.000000e+00, ptr %gep.3.i10594, align 8, !noalias !192
  %gep.4.i10596 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.4.idx.i10595
  store double 0.000000e+00, ptr %gep.4.i10596, align 8, !noalias !192
  %gep.5.i10598 = getelementptr i8, ptr %invariant.gep.i10589, i64 %.idx10302
  store double 0.000000e+00, ptr %gep.5.i10598, align 8, !noalias !192
  %gep.6.i10600 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.6.idx.i10599
  store double 0.000000e+00, ptr %gep.6.i10600, align 8, !noalias !192
  %gep.7.i10602 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.7.idx.i10601
  store double 0.000000e+00, ptr %gep.7.i10602, align 8, !noalias !192
  %gep.8.i10604 = getelementptr i8, ptr %invariant.gep.i10589, i64 %.571.idx
  store double 0.000000e+00, ptr %gep.8.i10604, align 8, !noalias !192
  %gep.9.i10606 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.9.idx.i10605
  store double 0.000000e+00, ptr %gep.9.i10606, align 8, !noalias !192
  %gep.10.i10608 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.10.idx.i10607
  store double 0.000000e+00, ptr %gep.10.i10608, align 8, !noalias !192
  %gep.11.i10610 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.11.idx.i10609
  store double 0.000000e+00, ptr %gep.11.i10610, align 8, !noalias !192
  %gep.12.i10612 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.12.idx.i10611
  store double 0.000000e+00, ptr %gep.12.i10612, align 8, !noalias !192
  %gep.13.i10614 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.13.idx.i10613
  store double 0.000000e+00, ptr %gep.13.i10614, align 8, !noalias !192
  %gep.14.i10616 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.14.idx.i10615
  store double 0.000000e+00, ptr %gep.14.i10616, align 8, !noalias !192
  %gep.15.i10618 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.15.idx.i10617
  store double 0.000000e+00, ptr %gep.15.i10618, align 8, !noalias !192
  %gep.16.i10620 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.16.idx.i10619
  store double 0.000000e+00, ptr %gep.16.i10620, align 8, !noalias !192
  %gep.17.i10622 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.17.idx.i10621
  store double 0.000000e+00, ptr %gep.17.i10622, align 8, !noalias !192
  %gep.18.i10624 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.18.idx.i10623
  store double 0.000000e+00, ptr %gep.18.i10624, align 8, !noalias !192
  %gep.19.i10626 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.19.idx.i10625
  store double 0.000000e+00, ptr %gep.19.i10626, align 8, !noalias !192
  %gep.20.i10628 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.20.idx.i10627
  store double 0.000000e+00, ptr %gep.20.i10628, align 8, !noalias !192
  %gep.21.i10630 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.21.idx.i10629
  store double 0.000000e+00, ptr %gep.21.i10630, align 8, !noalias !192
  %gep.22.i10632 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.22.idx.i10631
  store double 0.000000e+00, ptr %gep.22.i10632, align 8, !noalias !192
  %gep.23.i10634 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.23.idx.i10633
  store double 0.000000e+00, ptr %gep.23.i10634, align 8, !noalias !192
  %gep.24.i10636 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.24.idx.i10635
  store double 0.000000e+00, ptr %gep.24.i10636, align 8, !noalias !192
  %gep.25.i10638 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.25.idx.i10637
  store double 0.000000e+00, ptr %gep.25.i10638, align 8, !noalias !192
  %gep.26.i10640 = getelementptr i8, ptr %invariant.gep.i10589, i64 %gep.26.idx.i10639
  store double 0.000000e+00, ptr %gep.26.i10640, align 8, !noalias !192
  %.1455.i10641 = load double, ptr %arg.batch.2.4, align 8, !noalias !192
  %.1516.i10642 = load i64, ptr %.595.i10533, align 8, !noalias !192
  %.1531.i10643 = icmp slt i64 %.1516.i10642, 0
  %.1532.i10644 = select i1 %.1531.i10643, i64 %arg.batch.1.2.5.0, i64 0
  %277 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i10642
  %.1546.i10645 = getelementptr double, ptr %277, i64 %.1532.i10644
  %.1547.i10646 = load double, ptr %.1546.i10645, align 8, !noalias !192
  store double %.1455.i10641, ptr %invariant.gep.i10589, align 8, !noalias !192
  %.1656.i10649 = getelementptr double, ptr %112, i64 %.5390.010843
  store double %.1547.i10646, ptr %.1656.i10649, align 8, !noalias !192
  store double 1.000000e+00, ptr %.293.i10515, align 8, !noalias !192
  %.1767.i10651 = getelementptr double, ptr %113, i64 %.5390.010843
  store double 0xFFF0000000000000, ptr %.1767.i10651, align 8, !noalias !192
  %.1822.i10653 = getelementptr double, ptr %114, i64 %.5390.010843
  store double 0x7FF0000000000000, ptr %.1822.i10653, align 8, !noalias !192
  %.1877.i10655 = getelementptr double, ptr %115, i64 %.5390.010843
  %.1878.i10656 = load double, ptr %.1877.i10655, align 8, !noalias !192
  %.1880.i10657 = fcmp ueq double %.1878.i10656, 0xFFF0000000000000
  br i1 %.1880.i10657, label %B4292, label %B888.i10658

B4084:                                            ; preds = %B3942
  %.6276 = getelementptr double, ptr %116, i64 %.5390.010843
  %.6277 = load double, ptr %.6276, align 8
  %.6279 = fcmp ult double %.6277, 1.500000e+01
  br i1 %.6279, label %B4292, label %B4132

B4132:                                            ; preds = %B4084
  %.6323 = load double, ptr %.6322, align 8
  %.6377 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5390.010843
  %.6378 = load double, ptr %.6377, align 8
  %.6379 = fsub double %.6323, %.6378
  %.6433 = getelementptr double, ptr %119, i64 %.5390.010843
  %.6434 = load double, ptr %.6433, align 8
  %.6436 = fmul double %.6434, 5.000000e+03
  %.6437 = fcmp ogt double %.6379, %.6436
  br i1 %.6437, label %B4292, label %B4268

B4268:                                            ; preds = %B4132
  store double 0.000000e+00, ptr %.6276, align 8
  br label %B4292

B4292:                                            ; preds = %B888.i10658, %B3976, %B580.if.i10588, %B4132, %B4268, %B4084
  %budget.7.4 = phi i64 [ %budget.5.210845, %B4084 ], [ 0, %B4132 ], [ %budget.5.210845, %B4268 ], [ %budget.5.210845, %B580.if.i10588 ], [ %budget.5.210845, %B3976 ], [ %budget.5.210845, %B888.i10658 ]
  %.6565 = load i64, ptr %.5551, align 8
  %.6566 = icmp sgt i64 %.6565, -1
  br i1 %.6566, label %B4330, label %B4587

B4330:                                            ; preds = %B4292
  %.6571 = add nsw i64 %active.5.210846, 1
  %.6680 = mul i64 %.6565, %arg.batch.3.3.5.1
  %.6684 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.6680
  %.6685 = load i64, ptr %.6684, align 8
  %.6696.0 = and i64 %.6685, 127
  %.6726 = sub nsw i64 128, %.6696.0
  %.11.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.6726, i64 %.5688)
  %.6814 = getelementptr double, ptr %120, i64 %.5390.010843
  %.6815 = load double, ptr %.6814, align 8
  %.6817 = fcmp ogt double %.6815, 0.000000e+00
  %.6828 = sitofp i64 %.11.i to double
  %"$phi4500.1.2.5" = select i1 %.6817, double 1.000000e+00, double %.6828
  %.6891 = getelementptr double, ptr %121, i64 %.5390.010843
  store double %"$phi4500.1.2.5", ptr %.6891, align 8
  %.111.i8102 = getelementptr i64, ptr %122, i64 %.5390.010843
  %.112.i8103 = load i64, ptr %.111.i8102, align 8, !noalias !199
  %.169.i8152 = getelementptr double, ptr %123, i64 %.5390.010843
  %.170.i8153 = load double, ptr %.169.i8152, align 8, !noalias !199
  %.224.i8201 = getelementptr double, ptr %124, i64 %.5390.010843
  store double %.170.i8153, ptr %.224.i8201, align 8, !noalias !199
  %.237.i8209 = icmp slt i64 %.112.i8103, %arg.batch.2.5.0
  br i1 %.237.i8209, label %B134.i8214, label %B4587

B134.i8214:                                       ; preds = %B4330
  %.253.i8225 = icmp slt i64 %.112.i8103, 0
  %.254.i8226 = select i1 %.253.i8225, i64 %arg.batch.2.5.0, i64 0
  %278 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i8103
  %.268.i8240 = getelementptr double, ptr %278, i64 %.254.i8226
  %.269.i8241 = load double, ptr %.268.i8240, align 8, !noalias !199
  %.328.i8292 = load double, ptr %.169.i8152, align 8, !noalias !199
  %.10.i.i8299 = fcmp olt double %.328.i8292, %.269.i8241
  %.11.i.i8300 = select i1 %.10.i.i8299, double %.328.i8292, double %.269.i8241
  store double %.11.i.i8300, ptr %.224.i8201, align 8, !noalias !199
  br label %B4587

B4560:                                            ; preds = %B4587, %B3584
  %budget.4.2 = phi i64 [ %.1003, %B3584 ], [ %budget.6.3, %B4587 ]
  %active.8.2 = phi i64 [ %active.9.1.mux, %B3584 ], [ %active.6.3, %B4587 ]
  %.6969 = icmp sgt i64 %active.8.2, 0
  %.6983 = icmp sgt i64 %budget.4.2, 0
  %or.cond10393 = select i1 %.6969, i1 %.6983, i1 false
  br i1 %or.cond10393, label %B416, label %B4586

B4586:                                            ; preds = %B4560, %B388
  %active.10.0 = phi i64 [ %active.4.0.lcssa, %B388 ], [ %active.8.2, %B4560 ]
  br i1 %.665, label %B4586.endif, label %B80.if.i1839.lr.ph

B80.if.i1839.lr.ph:                               ; preds = %B4586
  %.idx = mul i64 %arg.batch.4.0.5.1, 176
  %279 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx
  %.idx10300 = mul i64 %arg.batch.4.0.5.1, 184
  %280 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10300
  %.697.i1608 = add nsw i64 %arg.shape.2, -1
  %.idx10301 = mul i64 %arg.batch.4.0.5.1, 160
  %281 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10301
  br label %B80.if.i1839

B126.i1261:                                       ; preds = %B80.if.i1839
  %.318.i1308 = getelementptr double, ptr %279, i64 %.105.i1115.010852
  %.319.i1309 = load double, ptr %.318.i1308, align 8, !noalias !203
  %.5.i.i1310 = fptosi double %.319.i1309 to i64
  %.397.i1361 = getelementptr double, ptr %280, i64 %.105.i1115.010852
  %.398.i1362 = load double, ptr %.397.i1361, align 8, !noalias !203
  %.5.i1.i1363 = fptosi double %.398.i1362 to i64
  %.472.i1411 = mul i64 %.258.i1254, %arg.batch.3.3.5.1
  %.476.i1415 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.472.i1411
  %.477.i1416 = load i64, ptr %.476.i1415, align 8, !noalias !203
  %.478.i1417 = add nsw i64 %.477.i1416, %.5.i.i1310
  store i64 %.478.i1417, ptr %.476.i1415, align 8, !noalias !203
  %.584.i1509 = getelementptr i8, ptr %.476.i1415, i64 24
  %.585.i1510 = load i64, ptr %.584.i1509, align 8, !noalias !203
  %.586.i1511 = add nsw i64 %.585.i1510, %.5.i1.i1363
  store i64 %.586.i1511, ptr %.584.i1509, align 8, !noalias !203
  %.694.i1605 = getelementptr i8, ptr %.476.i1415, i64 8
  %.695.i1606 = load i64, ptr %.694.i1605, align 8, !noalias !203
  %.698.i1609 = add nsw i64 %.5.i1.i1363, %.5.i.i1310
  %.699.i1610 = mul nsw i64 %.698.i1609, %.697.i1608
  %.700.i1611 = add nsw i64 %.699.i1610, %.5.i.i1310
  %.701.i1612 = add nsw i64 %.700.i1611, %.695.i1606
  store i64 %.701.i1612, ptr %.694.i1605, align 8, !noalias !203
  store double 0.000000e+00, ptr %.318.i1308, align 8, !noalias !203
  store double 0.000000e+00, ptr %.397.i1361, align 8, !noalias !203
  %.923.i1794 = getelementptr double, ptr %281, i64 %.105.i1115.010852
  %.924.i1795 = load double, ptr %.923.i1794, align 8, !noalias !203
  %.926.i1797 = sitofp i64 %.698.i1609 to double
  %.927.i1798 = fsub double %.924.i1795, %.926.i1797
  store double %.927.i1798, ptr %.923.i1794, align 8, !noalias !203
  br label %B502.i1258

B502.i1258:                                       ; preds = %B126.i1261, %B80.if.i1839
  %.163.i1189 = icmp sgt i64 %.108.i1116.010853, 1
  br i1 %.163.i1189, label %B80.if.i1839, label %B4586.endif

B80.if.i1839:                                     ; preds = %B80.if.i1839.lr.ph, %B502.i1258
  %.108.i1116.010853 = phi i64 [ %storemerge, %B80.if.i1839.lr.ph ], [ %.172.i1844, %B502.i1258 ]
  %.105.i1115.010852 = phi i64 [ 0, %B80.if.i1839.lr.ph ], [ %.176.i1847, %B502.i1258 ]
  %.172.i1844 = add nsw i64 %.108.i1116.010853, -1
  %.176.i1847 = add nsw i64 %.105.i1115.010852, 1
  %282 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i1115.010852
  %.258.i1254 = load i64, ptr %282, align 8, !noalias !203
  %.263.i1257 = icmp sgt i64 %.258.i1254, -1
  br i1 %.263.i1257, label %B126.i1261, label %B502.i1258

B4587:                                            ; preds = %B4330, %B134.i8214, %B4292, %B3626.if
  %budget.6.3 = phi i64 [ %budget.5.210845, %B3626.if ], [ %budget.7.4, %B4292 ], [ %budget.7.4, %B134.i8214 ], [ %budget.7.4, %B4330 ]
  %active.6.3 = phi i64 [ %active.5.210846, %B3626.if ], [ %active.5.210846, %B4292 ], [ %.6571, %B134.i8214 ], [ %.6571, %B4330 ]
  %.5453 = icmp sgt i64 %.5393.010844, 1
  br i1 %.5453, label %B3626.if, label %B4560

B248.if:                                          ; preds = %B248.if.lr.ph, %B334
  %active.4.010670 = phi i64 [ 0, %B248.if.lr.ph ], [ %.960, %B334 ]
  %.654.010669 = phi i64 [ %storemerge, %B248.if.lr.ph ], [ %.718, %B334 ]
  %.651.010668 = phi i64 [ 0, %B248.if.lr.ph ], [ %.722, %B334 ]
  %.718 = add nsw i64 %.654.010669, -1
  %.722 = add nsw i64 %.651.010668, 1
  %283 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.651.010668
  %.804 = load i64, ptr %283, align 8
  %.805 = icmp slt i64 %.804, 0
  br i1 %.805, label %B290, label %B334

B1366.if:                                         ; preds = %B1334, %B1590
  %.2037.010685 = phi i64 [ %.2106, %B1590 ], [ 1, %B1334 ]
  %.2106 = add i64 %.2037.010685, 1
  %284 = getelementptr i64, ptr %arg.code.4, i64 %.2037.010685
  %285 = getelementptr i8, ptr %284, i64 112
  %.2165 = load i64, ptr %285, align 8
  %.2210 = inttoptr i64 %.2165 to ptr
  tail call void %.2210(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.2241 = load i64, ptr %arg.code.4, align 8
  %.2247 = mul nsw i64 %.2106, %.463
  %.2291 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2247
  %.2292 = inttoptr i64 %.2241 to ptr
  tail call void %.2292(ptr %.571, ptr %.2266, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.2291)
  br i1 %or.cond10662.not, label %B68.if.lr.ph.i, label %B1590

B1734.if:                                         ; preds = %B1592, %B1820
  %looked.2.110691 = phi i1 [ %"$phi1820.1.2.2", %B1820 ], [ %spec.select10394, %B1592 ]
  %good.2.110690 = phi i1 [ %"$phi1778.1.2.2", %B1820 ], [ false, %B1592 ]
  %.2511.010689 = phi i64 [ %.2573, %B1820 ], [ %storemerge, %B1592 ]
  %.2508.010688 = phi i64 [ %.2577, %B1820 ], [ 0, %B1592 ]
  %.2573 = add nsw i64 %.2511.010689, -1
  %.2577 = add nsw i64 %.2508.010688, 1
  br i1 %good.2.110690, label %B1778, label %B1742

B1894.if:                                         ; preds = %B1894.preheader, %B2400
  %doubted.3.210701 = phi i1 [ %doubted.4.3, %B2400 ], [ false, %B1894.preheader ]
  %within.3.210700 = phi i1 [ %within.4.3, %B2400 ], [ false, %B1894.preheader ]
  %.2866.010699 = phi i64 [ %.2934, %B2400 ], [ %storemerge, %B1894.preheader ]
  %.2863.010698 = phi i64 [ %.2938, %B2400 ], [ 0, %B1894.preheader ]
  %.2934 = add nsw i64 %.2866.010699, -1
  %.2938 = add nsw i64 %.2863.010698, 1
  %.3023 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2863.010698
  %.3024 = load i64, ptr %.3023, align 8
  %.3078 = getelementptr i64, ptr %38, i64 %.2863.010698
  %.3079 = load i64, ptr %.3078, align 8
  %.3139 = getelementptr double, ptr %39, i64 %.2863.010698
  store double 0.000000e+00, ptr %.3139, align 8
  %.3142 = icmp sgt i64 %.3024, -1
  br i1 %.3142, label %B1994, label %B2400

B46.i:                                            ; preds = %B2032
  %.120.i1947 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i1916
  %.121.i1948 = load i64, ptr %.120.i1947, align 8, !noalias !50
  %.122.i1949 = icmp eq i64 %.121.i1948, 0
  br i1 %.122.i1949, label %B80.i1953, label %B2132

B80.i1953:                                        ; preds = %B46.i
  store i64 %.5.i, ptr %.120.i1947, align 8, !noalias !50
  br label %B2132

B2786.if:                                         ; preds = %B2738
  %.4294 = load i64, ptr %126, align 8
  %.4339 = inttoptr i64 %.4294 to ptr
  tail call void %.4339(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4370 = load i64, ptr %arg.code.4, align 8
  %.4420 = inttoptr i64 %.4370 to ptr
  tail call void %.4420(ptr %.571, ptr %.4394, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4419)
  %.4294.1 = load i64, ptr %127, align 8
  %.4339.1 = inttoptr i64 %.4294.1 to ptr
  tail call void %.4339.1(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4370.1 = load i64, ptr %arg.code.4, align 8
  %.4420.1 = inttoptr i64 %.4370.1 to ptr
  tail call void %.4420.1(ptr %.571, ptr %.4394, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4419.1)
  %.4294.2 = load i64, ptr %128, align 8
  %.4339.2 = inttoptr i64 %.4294.2 to ptr
  tail call void %.4339.2(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4370.2 = load i64, ptr %arg.code.4, align 8
  %.4420.2 = inttoptr i64 %.4370.2 to ptr
  tail call void %.4420.2(ptr %.571, ptr %.4394, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4419.2)
  %.4458 = load i64, ptr %.4457, align 8
  %.4503 = inttoptr i64 %.4458 to ptr
  tail call void %.4503(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4535 = load i64, ptr %.4534, align 8
  %.4580 = inttoptr i64 %.4535 to ptr
  tail call void %.4580(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.665, label %B3154, label %B64.if.i5797

B3158.endif.endif:                                ; preds = %B806.if.i3485, %B806.i3389.preheader
  br i1 %some.2.i3174.1.lcssa, label %B3196, label %B3238

B3626.if:                                         ; preds = %B3584, %B4587
  %active.5.210846 = phi i64 [ %active.6.3, %B4587 ], [ 0, %B3584 ]
  %budget.5.210845 = phi i64 [ %budget.6.3, %B4587 ], [ %.1003, %B3584 ]
  %.5393.010844 = phi i64 [ %.5462, %B4587 ], [ %storemerge, %B3584 ]
  %.5390.010843 = phi i64 [ %.5466, %B4587 ], [ 0, %B3584 ]
  %.5462 = add nsw i64 %.5393.010844, -1
  %.5466 = add nsw i64 %.5390.010843, 1
  %.5551 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5390.010843
  %.5552 = load i64, ptr %.5551, align 8
  %.5557 = icmp slt i64 %.5552, 0
  br i1 %.5557, label %B4587, label %B3674

B4586.endif:                                      ; preds = %B502.i1258, %B4586
  store i64 %active.10.0, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64)

; Function Attrs: nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr, i8, i64, i1)

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
!25 = !{!26}
!26 = distinct !{!26, !27, !"_ZN12clpt_control6native9for_numba9lineariseB3v10B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!27 = distinct !{!27, !"_ZN12clpt_control6native9for_numba9lineariseB3v10B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!28 = !{!29, !31, !26}
!29 = distinct !{!29, !30, !"_ZN12clpt_control6native9for_numba13differentiateB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!30 = distinct !{!30, !"_ZN12clpt_control6native9for_numba13differentiateB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!31 = distinct !{!31, !30, !"_ZN12clpt_control6native9for_numba13differentiateB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!32 = !{!33, !35, !29, !31, !26}
!33 = distinct !{!33, !34, !"_ZN12clpt_control6native9for_numba14by_differencesB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!34 = distinct !{!34, !"_ZN12clpt_control6native9for_numba14by_differencesB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!35 = distinct !{!35, !34, !"_ZN12clpt_control6native9for_numba14by_differencesB3v12B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!36 = !{!37, !26}
!37 = distinct !{!37, !38, !"_ZN12clpt_control6native9for_numba6factorB3v16B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!38 = distinct !{!38, !"_ZN12clpt_control6native9for_numba6factorB3v16B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!39 = !{!40, !42, !43}
!40 = distinct !{!40, !41, !"_ZN12clpt_control6native9for_numba5solveB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!41 = distinct !{!41, !"_ZN12clpt_control6native9for_numba5solveB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!42 = distinct !{!42, !41, !"_ZN12clpt_control6native9for_numba5solveB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!43 = distinct !{!43, !44, !"_ZN12clpt_control6native9for_numba11solve_stageB3v17B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!44 = distinct !{!44, !"_ZN12clpt_control6native9for_numba11solve_stageB3v17B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!45 = !{!43}
!46 = !{!47, !49}
!47 = distinct !{!47, !48, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!48 = distinct !{!48, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!49 = distinct !{!49, !48, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!50 = !{!51}
!51 = distinct !{!51, !52, !"_ZN12clpt_control6native9for_numba4failB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!52 = distinct !{!52, !"_ZN12clpt_control6native9for_numba4failB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!53 = !{!54, !56}
!54 = distinct !{!54, !55, !"_ZN12clpt_control6native9for_numba6passesB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!55 = distinct !{!55, !"_ZN12clpt_control6native9for_numba6passesB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!56 = distinct !{!56, !55, !"_ZN12clpt_control6native9for_numba6passesB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!57 = !{!58, !60, !54, !56}
!58 = distinct !{!58, !59, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!59 = distinct !{!59, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!60 = distinct !{!60, !59, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!61 = !{!62, !64, !54, !56}
!62 = distinct !{!62, !63, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!63 = distinct !{!63, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!64 = distinct !{!64, !63, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!65 = !{!66, !68, !62, !64, !54, !56}
!66 = distinct !{!66, !67, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!67 = distinct !{!67, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!68 = distinct !{!68, !67, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!69 = !{!70, !72}
!70 = distinct !{!70, !71, !"_ZN12clpt_control6native9for_numba5doubtB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!71 = distinct !{!71, !"_ZN12clpt_control6native9for_numba5doubtB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!72 = distinct !{!72, !71, !"_ZN12clpt_control6native9for_numba5doubtB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!73 = !{!74, !70, !72}
!74 = distinct !{!74, !75, !"_ZN12clpt_control6native9for_numba5againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!75 = distinct !{!75, !"_ZN12clpt_control6native9for_numba5againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!76 = !{!77, !79}
!77 = distinct !{!77, !78, !"_ZN12clpt_control6native9for_numba6passesB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!78 = distinct !{!78, !"_ZN12clpt_control6native9for_numba6passesB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!79 = distinct !{!79, !78, !"_ZN12clpt_control6native9for_numba6passesB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!80 = !{!81, !83, !77, !79}
!81 = distinct !{!81, !82, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!82 = distinct !{!82, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!83 = distinct !{!83, !82, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!84 = !{!85, !87, !77, !79}
!85 = distinct !{!85, !86, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!86 = distinct !{!86, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!87 = distinct !{!87, !86, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!88 = !{!89, !91, !85, !87, !77, !79}
!89 = distinct !{!89, !90, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!90 = distinct !{!90, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!91 = distinct !{!91, !90, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!92 = !{!93}
!93 = distinct !{!93, !94, !"_ZN12clpt_control6native9for_numba5crossB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!94 = distinct !{!94, !"_ZN12clpt_control6native9for_numba5crossB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!95 = !{!96, !98, !93}
!96 = distinct !{!96, !97, !"_ZN12clpt_control6native9for_numba5weighB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!97 = distinct !{!97, !"_ZN12clpt_control6native9for_numba5weighB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!98 = distinct !{!98, !97, !"_ZN12clpt_control6native9for_numba5weighB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!99 = !{!100, !102, !96, !98, !93}
!100 = distinct !{!100, !101, !"_ZN12clpt_control6native9for_numba8exchangeB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!101 = distinct !{!101, !"_ZN12clpt_control6native9for_numba8exchangeB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!102 = distinct !{!102, !101, !"_ZN12clpt_control6native9for_numba8exchangeB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!103 = !{!104, !106, !96, !98, !93}
!104 = distinct !{!104, !105, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!105 = distinct !{!105, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!106 = distinct !{!106, !105, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!107 = !{!108, !110, !104, !106, !96, !98, !93}
!108 = distinct !{!108, !109, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!109 = distinct !{!109, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!110 = distinct !{!110, !109, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!111 = !{!112, !114, !96, !98, !93}
!112 = distinct !{!112, !113, !"_ZN12clpt_control6native9for_numba8exchangeB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!113 = distinct !{!113, !"_ZN12clpt_control6native9for_numba8exchangeB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!114 = distinct !{!114, !113, !"_ZN12clpt_control6native9for_numba8exchangeB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!115 = !{!116, !118, !93}
!116 = distinct !{!116, !117, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!117 = distinct !{!117, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!118 = distinct !{!118, !117, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!119 = !{!120, !122, !123, !125, !93}
!120 = distinct !{!120, !121, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!121 = distinct !{!121, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!122 = distinct !{!122, !121, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!123 = distinct !{!123, !124, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!124 = distinct !{!124, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!125 = distinct !{!125, !124, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!126 = !{!123, !125, !93}
!127 = !{!128, !130, !93}
!128 = distinct !{!128, !129, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!129 = distinct !{!129, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!130 = distinct !{!130, !129, !"_ZN12clpt_control6native9for_numba6passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!131 = !{!132, !93}
!132 = distinct !{!132, !133, !"_ZN12clpt_control6native9for_numba5againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!133 = distinct !{!133, !"_ZN12clpt_control6native9for_numba5againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!134 = !{!135}
!135 = distinct !{!135, !136, !"_ZN12clpt_control6native9for_numba5watchB3v35B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!136 = distinct !{!136, !"_ZN12clpt_control6native9for_numba5watchB3v35B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!137 = !{!138, !135}
!138 = distinct !{!138, !139, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!139 = distinct !{!139, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!140 = !{!141, !143, !135}
!141 = distinct !{!141, !142, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!142 = distinct !{!142, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!143 = distinct !{!143, !142, !"_ZN12clpt_control6native9for_numba11look_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!144 = !{!145, !147, !141, !143, !135}
!145 = distinct !{!145, !146, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!146 = distinct !{!146, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!147 = distinct !{!147, !146, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!148 = !{!149}
!149 = distinct !{!149, !150, !"_ZN12clpt_control6native9for_numba6sampleB3v36B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!150 = distinct !{!150, !"_ZN12clpt_control6native9for_numba6sampleB3v36B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!151 = !{!152, !154, !149}
!152 = distinct !{!152, !153, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!153 = distinct !{!153, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!154 = distinct !{!154, !153, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!155 = !{!156, !158}
!156 = distinct !{!156, !157, !"_ZN12clpt_control6native9for_numba11decide_anewB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!157 = distinct !{!157, !"_ZN12clpt_control6native9for_numba11decide_anewB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!158 = distinct !{!158, !157, !"_ZN12clpt_control6native9for_numba11decide_anewB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!159 = !{!160, !156, !158}
!160 = distinct !{!160, !161, !"_ZN12clpt_control6native9for_numba4failB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29: %retptr"}
!161 = distinct !{!161, !"_ZN12clpt_control6native9for_numba4failB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29"}
!162 = !{!163, !165}
!163 = distinct !{!163, !164, !"_ZN12clpt_control6native9for_numba6at_endB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!164 = distinct !{!164, !"_ZN12clpt_control6native9for_numba6at_endB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!165 = distinct !{!165, !166, !"_ZN12clpt_control6native9for_numba4leapB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!166 = distinct !{!166, !"_ZN12clpt_control6native9for_numba4leapB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!167 = !{!165}
!168 = !{!169, !171, !165}
!169 = distinct !{!169, !170, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!170 = distinct !{!170, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!171 = distinct !{!171, !170, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!172 = !{!173, !165}
!173 = distinct !{!173, !174, !"_ZN12clpt_control6native9for_numba6at_endB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!174 = distinct !{!174, !"_ZN12clpt_control6native9for_numba6at_endB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!175 = !{!176, !165}
!176 = distinct !{!176, !177, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!177 = distinct !{!177, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!178 = !{!179, !165}
!179 = distinct !{!179, !180, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!180 = distinct !{!180, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!181 = !{!182}
!182 = distinct !{!182, !183, !"_ZN12clpt_control6native9for_numba4failB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29: %retptr"}
!183 = distinct !{!183, !"_ZN12clpt_control6native9for_numba4failB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29"}
!184 = !{!185, !187}
!185 = distinct !{!185, !186, !"_ZN12clpt_control6native9for_numba5enterB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!186 = distinct !{!186, !"_ZN12clpt_control6native9for_numba5enterB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!187 = distinct !{!187, !186, !"_ZN12clpt_control6native9for_numba5enterB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!188 = !{!189, !191, !185, !187}
!189 = distinct !{!189, !190, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!190 = distinct !{!190, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!191 = distinct !{!191, !190, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!192 = !{!193}
!193 = distinct !{!193, !194, !"_ZN12clpt_control6native9for_numba4takeB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!194 = distinct !{!194, !"_ZN12clpt_control6native9for_numba4takeB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!195 = !{!196, !198, !193}
!196 = distinct !{!196, !197, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!197 = distinct !{!197, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!198 = distinct !{!198, !197, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!199 = !{!200, !202}
!200 = distinct !{!200, !201, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!201 = distinct !{!201, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!202 = distinct !{!202, !201, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!203 = !{!204, !206}
!204 = distinct !{!204, !205, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!205 = distinct !{!205, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!206 = distinct !{!206, !205, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}

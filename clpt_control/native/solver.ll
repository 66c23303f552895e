; sha256 c473d13caa8c37cb929104320972404cef2e24a3a525dbec069490cfc1d606f6

define dso_local noundef i32 @advance(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.shape.3, i64 %arg.shape.4, i64 %arg.shape.5, i64 %arg.shape.6, ptr readnone %arg.tolerances.0, ptr readnone %arg.tolerances.1, i64 %arg.tolerances.2, i64 %arg.tolerances.3, ptr %arg.tolerances.4, i64 %arg.tolerances.5.0, i64 %arg.tolerances.6.0, ptr readnone %arg.batch.0.0.0, ptr readnone %arg.batch.0.0.1, i64 %arg.batch.0.0.2, i64 %arg.batch.0.0.3, ptr readonly %arg.batch.0.0.4, i64 %arg.batch.0.0.5.0, i64 %arg.batch.0.0.5.1, i64 %arg.batch.0.0.6.0, i64 %arg.batch.0.0.6.1, ptr readnone %arg.batch.0.1.0, ptr readnone %arg.batch.0.1.1, i64 %arg.batch.0.1.2, i64 %arg.batch.0.1.3, ptr readonly %arg.batch.0.1.4, i64 %arg.batch.0.1.5.0, i64 %arg.batch.0.1.5.1, i64 %arg.batch.0.1.6.0, i64 %arg.batch.0.1.6.1, ptr readnone %arg.batch.0.2.0, ptr readnone %arg.batch.0.2.1, i64 %arg.batch.0.2.2, i64 %arg.batch.0.2.3, ptr readonly %arg.batch.0.2.4, i64 %arg.batch.0.2.5.0, i64 %arg.batch.0.2.6.0, ptr readnone %arg.batch.1.0.0, ptr readnone %arg.batch.1.0.1, i64 %arg.batch.1.0.2, i64 %arg.batch.1.0.3, ptr readonly %arg.batch.1.0.4, i64 %arg.batch.1.0.5.0, i64 %arg.batch.1.0.6.0, ptr readnone %arg.batch.1.1.0, ptr readnone %arg.batch.1.1.1, i64 %arg.batch.1.1.2, i64 %arg.batch.1.1.3, ptr readonly %arg.batch.1.1.4, i64 %arg.batch.1.1.5.0, i64 %arg.batch.1.1.6.0, ptr readnone %arg.batch.1.2.0, ptr readnone %arg.batch.1.2.1, i64 %arg.batch.1.2.2, i64 %arg.batch.1.2.3, ptr readonly %arg.batch.1.2.4, i64 %arg.batch.1.2.5.0, i64 %arg.batch.1.2.6.0, ptr readnone %arg.batch.1.3.0, ptr readnone %arg.batch.1.3.1, i64 %arg.batch.1.3.2, i64 %arg.batch.1.3.3, ptr readonly %arg.batch.1.3.4, i64 %arg.batch.1.3.5.0, i64 %arg.batch.1.3.5.1, i64 %arg.batch.1.3.6.0, i64 %arg.batch.1.3.6.1, ptr readnone %arg.batch.1.4.0, ptr readnone %arg.batch.1.4.1, i64 %arg.batch.1.4.2, i64 %arg.batch.1.4.3, ptr readonly %arg.batch.1.4.4, i64 %arg.batch.1.4.5.0, i64 %arg.batch.1.4.6.0, ptr readnone %arg.batch.2.0, ptr readnone %arg.batch.2.1, i64 %arg.batch.2.2, i64 %arg.batch.2.3, ptr readonly %arg.batch.2.4, i64 %arg.batch.2.5.0, i64 %arg.batch.2.6.0, ptr readnone %arg.batch.3.0.0, ptr readnone %arg.batch.3.0.1, i64 %arg.batch.3.0.2, i64 %arg.batch.3.0.3, ptr %arg.batch.3.0.4, i64 %arg.batch.3.0.5.0, i64 %arg.batch.3.0.5.1, i64 %arg.batch.3.0.5.2, i64 %arg.batch.3.0.6.0, i64 %arg.batch.3.0.6.1, i64 %arg.batch.3.0.6.2, ptr readnone %arg.batch.3.1.0, ptr readnone %arg.batch.3.1.1, i64 %arg.batch.3.1.2, i64 %arg.batch.3.1.3, ptr %arg.batch.3.1.4, i64 %arg.batch.3.1.5.0, i64 %arg.batch.3.1.6.0, ptr readnone %arg.batch.3.2.0, ptr readnone %arg.batch.3.2.1, i64 %arg.batch.3.2.2, i64 %arg.batch.3.2.3, ptr %arg.batch.3.2.4, i64 %arg.batch.3.2.5.0, i64 %arg.batch.3.2.6.0, ptr readnone %arg.batch.3.3.0, ptr readnone %arg.batch.3.3.1, i64 %arg.batch.3.3.2, i64 %arg.batch.3.3.3, ptr %arg.batch.3.3.4, i64 %arg.batch.3.3.5.0, i64 %arg.batch.3.3.5.1, i64 %arg.batch.3.3.6.0, i64 %arg.batch.3.3.6.1, ptr readnone %arg.batch.4.0.0, ptr readnone %arg.batch.4.0.1, i64 %arg.batch.4.0.2, i64 %arg.batch.4.0.3, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.0, i64 %arg.batch.4.0.5.1, i64 %arg.batch.4.0.6.0, i64 %arg.batch.4.0.6.1, ptr readnone %arg.batch.4.1.0, ptr readnone %arg.batch.4.1.1, i64 %arg.batch.4.1.2, i64 %arg.batch.4.1.3, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.0, i64 %arg.batch.4.1.5.1, i64 %arg.batch.4.1.6.0, i64 %arg.batch.4.1.6.1, ptr readnone %arg.batch.4.2.0, ptr readnone %arg.batch.4.2.1, i64 %arg.batch.4.2.2, i64 %arg.batch.4.2.3, ptr %arg.batch.4.2.4, i64 %arg.batch.4.2.5.0, i64 %arg.batch.4.2.6.0, ptr readnone %arg.batch.5.0.0, ptr readnone %arg.batch.5.0.1, i64 %arg.batch.5.0.2, i64 %arg.batch.5.0.3, ptr %arg.batch.5.0.4, i64 %arg.batch.5.0.5.0, i64 %arg.batch.5.0.6.0, ptr readnone %arg.batch.5.1.0, ptr readnone %arg.batch.5.1.1, i64 %arg.batch.5.1.2, i64 %arg.batch.5.1.3, ptr %arg.batch.5.1.4, i64 %arg.batch.5.1.5.0, i64 %arg.batch.5.1.6.0, ptr readnone %arg.batch.5.2.0, ptr readnone %arg.batch.5.2.1, i64 %arg.batch.5.2.2, i64 %arg.batch.5.2.3, ptr %arg.batch.5.2.4, i64 %arg.batch.5.2.5.0, i64 %arg.batch.5.2.6.0, ptr readnone %arg.batch.5.3.0, ptr readnone %arg.batch.5.3.1, i64 %arg.batch.5.3.2, i64 %arg.batch.5.3.3, ptr %arg.batch.5.3.4, i64 %arg.batch.5.3.5.0, i64 %arg.batch.5.3.6.0, ptr readnone %arg.batch.5.4.0, ptr readnone %arg.batch.5.4.1, i64 %arg.batch.5.4.2, i64 %arg.batch.5.4.3, ptr %arg.batch.5.4.4, i64 %arg.batch.5.4.5.0, i64 %arg.batch.5.4.6.0, ptr readnone %arg.linear.0.0, ptr readnone %arg.linear.0.1, i64 %arg.linear.0.2, i64 %arg.linear.0.3, ptr %arg.linear.0.4, i64 %arg.linear.0.5.0, i64 %arg.linear.0.6.0, ptr readnone %arg.linear.1.0, ptr readnone %arg.linear.1.1, i64 %arg.linear.1.2, i64 %arg.linear.1.3, ptr %arg.linear.1.4, i64 %arg.linear.1.5.0, i64 %arg.linear.1.6.0, i64 %arg.budget, i64 %arg.most) local_unnamed_addr {
entry:
  %.397 = mul nsw i64 %arg.shape.1, %arg.shape.0
  %.505.idx = shl i64 %arg.batch.4.0.5.1, 6
  %.505 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.505.idx
  %.544 = icmp eq i64 %arg.shape.2, 9
  %.546.not = icmp ne i64 %arg.shape.2, 4
  %.548 = icmp ne i64 %arg.shape.2, 12
  %.606 = icmp slt i64 %arg.shape.0, 1
  %storemerge = select i1 %.606, i64 0, i64 %arg.shape.0
  br i1 %.606, label %B394, label %B254.if.lr.ph

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
  %4 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i
  %5 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.15.idx.i
  %6 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.28.idx.i
  %.idx1130.i = mul i64 %arg.batch.4.0.5.1, 232
  %7 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i
  br label %B254.if

B296:                                             ; preds = %B254.if
  %.236.i = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !0
  %.293.i = getelementptr double, ptr %0, i64 %.592.09133
  store double 0.000000e+00, ptr %.293.i, align 8, !noalias !0
  %.324.i = load i64, ptr %.323.i, align 8, !noalias !0
  %.326.i = icmp eq i64 %.236.i, %.324.i
  br i1 %.326.i, label %B340, label %B132.i

B132.i:                                           ; preds = %B296
  %.359.i = add nsw i64 %.236.i, 1
  store i64 %.359.i, ptr %arg.batch.4.2.4, align 8, !noalias !0
  store i64 1, ptr %.418.i, align 8, !noalias !0
  %.438.i = icmp slt i64 %.236.i, 0
  %.439.i = select i1 %.438.i, i64 %arg.batch.0.2.5.0, i64 0
  %8 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i
  %.453.i = getelementptr i64, ptr %8, i64 %.439.i
  %.454.i = load i64, ptr %.453.i, align 8, !noalias !0
  %.469.i = icmp slt i64 %.454.i, 0
  %.470.i8806 = select i1 %.469.i, i64 %arg.batch.1.0.5.0, i64 0
  %9 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i
  %.484.i = getelementptr i64, ptr %9, i64 %.470.i8806
  %.485.i = load i64, ptr %.484.i, align 8, !noalias !0
  %.540.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.592.09133
  store i64 %.236.i, ptr %.540.i, align 8, !noalias !0
  %.595.i = getelementptr i64, ptr %1, i64 %.592.09133
  store i64 %.485.i, ptr %.595.i, align 8, !noalias !0
  %.654.i = getelementptr i64, ptr %2, i64 %.592.09133
  store i64 1, ptr %.654.i, align 8, !noalias !0
  %.709.i = getelementptr i64, ptr %3, i64 %.592.09133
  store i64 0, ptr %.709.i, align 8, !noalias !0
  br i1 %.8051131.not.i, label %B402.i, label %B358.if.lr.ph.i

B358.if.lr.ph.i:                                  ; preds = %B132.i
  %.867.i = select i1 %.438.i, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i = add i64 %.867.i, %.236.i
  %.888.i = mul i64 %.868.i, %arg.batch.0.1.5.1
  %10 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i
  %invariant.gep9289 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.592.09133
  br label %B358.if.i

B402.i:                                           ; preds = %B358.if.i, %B132.i
  br i1 %.175.i1134.not.i, label %B402.endif.i, label %B76.if.i.lr.ph.i

B76.if.i.lr.ph.i:                                 ; preds = %B402.i
  %.990.i = load i64, ptr %.595.i, align 8, !noalias !0
  %.236.i.i = icmp slt i64 %.990.i, 0
  %.237.i.i8809 = select i1 %.236.i.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i = add i64 %.237.i.i8809, %.990.i
  %.258.i.i = mul i64 %.238.i.i, %arg.batch.1.3.5.1
  %11 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i
  br label %B76.if.i.i8810

B76.if.i.i8810:                                   ; preds = %B76.if.i.i8810, %B76.if.i.lr.ph.i
  %.117.i.01135.i = phi i64 [ 0, %B76.if.i.lr.ph.i ], [ %.188.i.i, %B76.if.i.i8810 ]
  %.188.i.i = add nsw i64 %.117.i.01135.i, 1
  %12 = getelementptr double, ptr %11, i64 %.117.i.01135.i
  %.263.i.i = load double, ptr %12, align 8, !noalias !3
  %13 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i
  %.293.i.i = load i64, ptr %13, align 8, !noalias !3
  %.295.i.i8811 = mul nsw i64 %.293.i.i, %arg.shape.0
  %.297.i.i = add nsw i64 %.295.i.i8811, %.592.09133
  %.311.i.i = icmp slt i64 %.297.i.i, 0
  %.312.i.i = select i1 %.311.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %14 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i
  %.326.i.i = getelementptr double, ptr %14, i64 %.312.i.i
  store double %.263.i.i, ptr %.326.i.i, align 8, !noalias !3
  %exitcond1142.not.i = icmp eq i64 %.188.i.i, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i, label %B402.endif.i, label %B76.if.i.i8810

B888.i:                                           ; preds = %B580.if.i
  store double 0.000000e+00, ptr %.1877.i, align 8, !noalias !0
  br label %B340

B358.if.i:                                        ; preds = %B358.if.i, %B358.if.lr.ph.i
  %.747.01132.i = phi i64 [ 0, %B358.if.lr.ph.i ], [ %.818.i8807, %B358.if.i ]
  %.818.i8807 = add nsw i64 %.747.01132.i, 1
  %15 = getelementptr double, ptr %10, i64 %.747.01132.i
  %.893.i = load double, ptr %15, align 8, !noalias !0
  %.895.i = mul nsw i64 %.747.01132.i, %arg.shape.0
  %gep9290 = getelementptr double, ptr %invariant.gep9289, i64 %.895.i
  store double %.893.i, ptr %gep9290, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.818.i8807, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i, label %B402.i, label %B358.if.i

B402.endif.i:                                     ; preds = %B76.if.i.i8810, %B402.i
  br i1 %.11171137.not.i, label %B580.if.i, label %B496.if.lr.ph.i

B496.if.lr.ph.i:                                  ; preds = %B402.endif.i
  %.1179.i = select i1 %.438.i, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i = add i64 %.1179.i, %.236.i
  %.1200.i = mul i64 %.1180.i, %arg.batch.0.0.5.1
  %16 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i
  %invariant.gep9291 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.592.09133
  br label %B496.if.i

B496.if.i:                                        ; preds = %B496.if.i, %B496.if.lr.ph.i
  %.1061.01138.i = phi i64 [ 0, %B496.if.lr.ph.i ], [ %.1130.i, %B496.if.i ]
  %.1130.i = add nsw i64 %.1061.01138.i, 1
  %17 = getelementptr double, ptr %16, i64 %.1061.01138.i
  %.1205.i = load double, ptr %17, align 8, !noalias !0
  %.1207.i = mul nsw i64 %.1061.01138.i, %arg.shape.0
  %gep9292 = getelementptr double, ptr %invariant.gep9291, i64 %.1207.i
  store double %.1205.i, ptr %gep9292, align 8, !noalias !0
  %exitcond1143.not.i = icmp eq i64 %.1130.i, %arg.shape.1
  br i1 %exitcond1143.not.i, label %B580.if.i, label %B496.if.i

B580.if.i:                                        ; preds = %B496.if.i, %B402.endif.i
  %invariant.gep.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.592.09133
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
  %gep.8.i = getelementptr i8, ptr %invariant.gep.i, i64 %.505.idx
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
  %.1455.i = load double, ptr %arg.batch.2.4, align 8, !noalias !0
  %.1516.i = load i64, ptr %.595.i, align 8, !noalias !0
  %.1531.i = icmp slt i64 %.1516.i, 0
  %.1532.i = select i1 %.1531.i, i64 %arg.batch.1.2.5.0, i64 0
  %18 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i
  %.1546.i = getelementptr double, ptr %18, i64 %.1532.i
  %.1547.i = load double, ptr %.1546.i, align 8, !noalias !0
  store double %.1455.i, ptr %invariant.gep.i, align 8, !noalias !0
  %.1656.i = getelementptr double, ptr %4, i64 %.592.09133
  store double %.1547.i, ptr %.1656.i, align 8, !noalias !0
  store double 1.000000e+00, ptr %.293.i, align 8, !noalias !0
  %.1767.i = getelementptr double, ptr %5, i64 %.592.09133
  store double 0xFFF0000000000000, ptr %.1767.i, align 8, !noalias !0
  %.1822.i = getelementptr double, ptr %6, i64 %.592.09133
  store double 0x7FF0000000000000, ptr %.1822.i, align 8, !noalias !0
  %.1877.i = getelementptr double, ptr %7, i64 %.592.09133
  %.1878.i = load double, ptr %.1877.i, align 8, !noalias !0
  %.1880.i = fcmp ueq double %.1878.i, 0xFFF0000000000000
  br i1 %.1880.i, label %B340, label %B888.i

B340:                                             ; preds = %B888.i, %B296, %B580.if.i, %B254.if
  %.883 = load i64, ptr %250, align 8
  %.884 = icmp sgt i64 %.883, -1
  %. = zext i1 %.884 to i64
  %.901 = add nsw i64 %active.4.09135, %.
  %.650 = icmp sgt i64 %.595.09134, 1
  br i1 %.650, label %B254.if, label %B394

B394:                                             ; preds = %B340, %entry
  %active.4.0.lcssa = phi i64 [ 0, %entry ], [ %.901, %B340 ]
  %.918.not = icmp ne i64 %active.4.0.lcssa, 0
  %.940 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.918.not, i1 %.940, i1 false
  br i1 %or.cond, label %B422.preheader, label %B4452

B422.preheader:                                   ; preds = %B394
  %.984 = getelementptr i8, ptr %arg.batch.4.2.4, i64 16
  %factor.op.mul = mul i64 %arg.shape.0, %arg.shape.1
  %factor.op.mul9261 = mul i64 %arg.shape.0, %arg.shape.1
  %.1080 = getelementptr i8, ptr %arg.code.4, i64 8
  %.1132 = icmp sgt i64 %arg.shape.6, 0
  %.149.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx8787 = mul i64 %arg.batch.4.0.5.1, 24
  %19 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8787
  %.457.i9136 = icmp slt i64 %arg.shape.6, 1
  %.613.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.1191.not = icmp eq i64 %arg.shape.3, 0
  %.1221 = getelementptr i8, ptr %arg.code.4, i64 16
  %.1348.idx = shl i64 %.397, 4
  %.1348 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1348.idx
  %.1379 = getelementptr i8, ptr %arg.code.4, i64 72
  %.1455 = getelementptr i8, ptr %arg.code.4, i64 80
  %.1556.idx = mul i64 %.397, 136
  %.1556 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1556.idx
  %.1581.idx = mul i64 %.397, 24
  %.1581 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1581.idx
  %.1612 = getelementptr i8, ptr %arg.code.4, i64 88
  %.idx8779 = mul i64 %arg.batch.4.0.5.1, 24
  %20 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8779
  %.idx8780 = shl i64 %arg.batch.4.0.5.1, 5
  %21 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8780
  %.idx8781 = mul i64 %arg.batch.4.0.5.1, 248
  %22 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8781
  %.8788 = select i1 %.546.not, i64 2, i64 0
  %.idx8782 = mul i64 %arg.batch.4.0.5.1, 88
  %23 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8782
  %.idx8783 = shl i64 %arg.batch.4.0.5.1, 4
  %24 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8783
  %.idx8784 = shl i64 %arg.batch.4.1.5.1, 4
  %25 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8784
  %.idx8785 = shl i64 %arg.batch.4.0.5.1, 4
  %26 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8785
  %.idx8786 = mul i64 %arg.batch.4.0.5.1, 144
  %27 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8786
  %.1757 = getelementptr i8, ptr %arg.code.4, i64 56
  %.1883 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.397
  %.127.i = mul nsw i64 %arg.shape.1, %arg.shape.1
  %.174.not.i = icmp slt i64 %.127.i, %arg.linear.0.5.0
  %.344.i = icmp slt i64 %arg.linear.1.5.0, 6
  %.524.idx.i = shl i64 %arg.batch.4.0.5.1, 5
  %.524.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.524.idx.i
  %.123.i.i = shl nsw i64 %arg.shape.1, 1
  %.124.i.i = add nsw i64 %.123.i.i, 5
  %.153.i.i = getelementptr i8, ptr %arg.linear.1.4, i64 24
  %.183.i.i8818 = getelementptr i8, ptr %arg.linear.1.4, i64 32
  %.186.i.i = add nsw i64 %.124.i.i, %arg.shape.1
  %.187.i.i = add nsw i64 %.186.i.i, 1
  %.224.i.i8820 = icmp slt i64 %arg.shape.1, -2
  %.225.i.i = select i1 %.224.i.i8820, i64 %arg.linear.1.5.0, i64 0
  %.226.i.i = add i64 %.225.i.i, %.124.i.i
  %.229.i.i = icmp slt i64 %.226.i.i, 0
  %.234.i.i = icmp sge i64 %.226.i.i, %arg.linear.1.5.0
  %28 = or i1 %.229.i.i, %.234.i.i
  %.241.i.i = icmp slt i64 %.186.i.i, -1
  %.242.i.i = select i1 %.241.i.i, i64 %arg.linear.1.5.0, i64 0
  %.243.i.i = add i64 %.242.i.i, %.187.i.i
  %.246.i.i = icmp slt i64 %.243.i.i, 0
  %.251.i.not.i = icmp slt i64 %.243.i.i, %arg.linear.1.5.0
  %.409.i.i = icmp sge i64 %.243.i.i, %arg.linear.1.5.0
  %29 = or i1 %.246.i.i, %.409.i.i
  %.538.i.i = add nsw i64 %arg.shape.1, 1
  %.539.i.i = add i64 %.124.i.i, %.538.i.i
  %.1162.i2379.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx2421.i = mul i64 %arg.shape.1, 136
  %.idx2422.i = mul i64 %arg.shape.1, 88
  %.1461.i.i = getelementptr i8, ptr %arg.linear.1.4, i64 16
  %storemerge2359.i = tail call i64 @llvm.smax.i64(i64 %.538.i.i, i64 0)
  %.1556.i2382.not.i = icmp slt i64 %arg.shape.1, 0
  %.1716.i.i = getelementptr i8, ptr %arg.code.4, i64 48
  %.1789.i.i = mul nsw i64 %arg.shape.1, 12
  %.1807.i.idx.i = mul i64 %arg.shape.1, 136
  %.1807.i.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1807.i.idx.i
  %.1832.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1789.i.i
  %.153.i.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.499.i.i.idx.i = mul i64 %arg.batch.4.0.5.1, 48
  %.499.i.i.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.499.i.i.idx.i
  %.503.i.i.i = mul nsw i64 %arg.shape.1, 18
  %.520.i.i.i = select i1 %.1556.i2382.not.i, i64 %arg.batch.5.0.5.0, i64 0
  %.idx.i8823 = mul i64 %arg.shape.1, 152
  %30 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i8823
  %.534.i.i.i = getelementptr double, ptr %30, i64 %.520.i.i.i
  %.897.i.i.i = mul nsw i64 %arg.shape.1, 17
  %.1279.i.i.idx.i = mul i64 %arg.shape.1, 96
  %.1279.i.i.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1279.i.i.idx.i
  %.2622.i.i = mul nsw i64 %arg.shape.1, 11
  %.idx2423.i = mul i64 %arg.shape.1, 144
  %invariant.gep = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx2423.i
  %.idx2424.i = mul i64 %arg.shape.1, 144
  %invariant.gep9145 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.503.i.i.i
  %invariant.gep9147 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.503.i.i.i
  %.663.i = getelementptr i8, ptr %arg.linear.1.4, i64 8
  %.711.i = icmp sgt i64 %arg.shape.1, 0
  %.743.sroa.0.02358.i = add i64 %arg.shape.1, 1
  %.1140.idx.i = mul i64 %arg.batch.4.0.5.1, 136
  %.1140.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.1140.idx.i
  %.1985 = add i64 %arg.shape.2, -1
  %storemerge8726 = tail call i64 @llvm.smax.i64(i64 %.1985, i64 0)
  %.20289153.not = icmp slt i64 %.1985, 1
  %.2201.idx = mul i64 %.397, 136
  %.2201 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.2201.idx
  %.42.i = mul nsw i64 %arg.shape.1, %arg.shape.1
  %.88.not.i = icmp slt i64 %.42.i, %arg.linear.0.5.0
  %.218.i = add nsw i64 %arg.shape.1, 5
  %.265.i = icmp slt i64 %arg.linear.1.5.0, 6
  %.272.i8827 = icmp slt i64 %arg.shape.1, -5
  %.273.i = select i1 %.272.i8827, i64 %arg.linear.1.5.0, i64 0
  %.274.i = add i64 %.218.i, %.273.i
  %.277.i = icmp slt i64 %.274.i, 0
  %.282.not.i = icmp slt i64 %.274.i, %arg.linear.1.5.0
  %.648747.not.i = icmp slt i64 %arg.shape.1, 1
  %.756.i = mul nsw i64 %arg.shape.1, 17
  %.idx.i8829 = mul i64 %arg.shape.1, 80
  %invariant.gep9149 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i8829
  %.882.i = getelementptr i8, ptr %arg.linear.1.4, i64 8
  %.887.i = mul nsw i64 %arg.shape.1, 17
  %invariant.gep9151 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.887.i
  %.2304 = getelementptr i8, ptr %arg.code.4, i64 64
  %.2386 = icmp sgt i64 %arg.shape.3, 0
  %.2391 = icmp sgt i64 %arg.shape.6, 0
  %.idx8777 = mul i64 %arg.batch.4.0.5.1, 40
  %31 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8777
  %.idx8778 = mul i64 %arg.batch.4.0.5.1, 160
  %32 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8778
  %.idx8774 = mul i64 %arg.batch.4.0.5.1, 168
  %33 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8774
  %.idx8775 = mul i64 %arg.batch.4.0.5.1, 176
  %34 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8775
  %.idx8776 = mul i64 %arg.batch.4.0.5.1, 152
  %35 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8776
  %.idx8768 = shl i64 %arg.batch.4.1.5.1, 4
  %36 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8768
  %.idx8769 = mul i64 %arg.batch.4.0.5.1, 184
  %37 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8769
  %.idx8770 = mul i64 %arg.batch.4.0.5.1, 72
  %38 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8770
  %.idx8771 = mul i64 %arg.batch.4.0.5.1, 40
  %39 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8771
  %.idx8772 = mul i64 %arg.batch.4.0.5.1, 232
  %40 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8772
  %.idx8773 = mul i64 %arg.batch.4.0.5.1, 56
  %41 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8773
  %.3940.idx = mul i64 %.397, 136
  %.3940 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3940.idx
  %.3965.idx = mul i64 %.397, 104
  %.3965 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3965.idx
  %.4003 = getelementptr i8, ptr %arg.code.4, i64 232
  %.4099 = getelementptr i8, ptr %arg.code.4, i64 40
  %.4121.idx = mul i64 %.397, 136
  %.4121 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4121.idx
  %.idx8763 = mul i64 %arg.batch.4.0.5.1, 96
  %42 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8763
  %.idx8764 = mul i64 %arg.batch.4.0.5.1, 40
  %43 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8764
  %.idx8765 = mul i64 %arg.batch.4.0.5.1, 104
  %44 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8765
  %.idx8766 = mul i64 %arg.batch.4.0.5.1, 112
  %45 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8766
  %.idx8767 = shl i64 %arg.batch.4.1.5.1, 5
  %46 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8767
  %.4462.idx = mul i64 %.397, 136
  %.4462 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4462.idx
  %.4525 = getelementptr i8, ptr %arg.code.4, i64 200
  %.4602 = getelementptr i8, ptr %arg.code.4, i64 104
  %.idx8755 = shl i64 %arg.batch.4.1.5.1, 4
  %47 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8755
  %.idx8756 = mul i64 %arg.batch.4.0.5.1, 40
  %48 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8756
  %.idx8757 = mul i64 %arg.batch.4.0.5.1, 56
  %49 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8757
  %.idx8758 = mul i64 %arg.batch.4.0.5.1, 216
  %50 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8758
  %.idx8759 = mul i64 %arg.batch.4.0.5.1, 48
  %51 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8759
  %.idx8760 = shl i64 %arg.batch.4.0.5.1, 5
  %52 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8760
  %53 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx8761 = mul i64 %arg.batch.4.0.5.1, 96
  %54 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8761
  %.idx8762 = mul i64 %arg.batch.4.0.5.1, 224
  %55 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8762
  %.4602.c = getelementptr i8, ptr %arg.code.4, i64 104
  %.695.i8840 = getelementptr i8, ptr %arg.code.4, i64 40
  %.787.i8841.idx = shl i64 %factor.op.mul, 4
  %.787.i8841 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.787.i8841.idx
  %.idx1216.i = mul i64 %arg.batch.4.0.5.1, 104
  %56 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1216.i
  %.idx1217.i = mul i64 %arg.batch.4.0.5.1, 112
  %57 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1217.i
  %.idx1218.i = mul i64 %arg.batch.4.0.5.1, 96
  %58 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1218.i
  %.idx1219.i = mul i64 %arg.batch.4.0.5.1, 48
  %59 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1219.i
  %.287.i1226.not.i = icmp slt i64 %arg.shape.1, 1
  %.359.i.i = shl nsw i64 %arg.shape.1, 1
  %storemerge1215.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.155.i.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx.i8847 = mul i64 %arg.batch.4.0.5.1, 56
  %60 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i8847
  %.idx1208.i = mul i64 %arg.batch.4.0.5.1, 40
  %61 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1208.i
  %.idx1209.i = shl i64 %arg.batch.4.0.5.1, 5
  %62 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1209.i
  %63 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.4790.not = icmp eq i64 %arg.shape.3, 0
  %.8798 = select i1 %.546.not, i64 16, i64 1
  %.526.i8862 = getelementptr i8, ptr %arg.code.4, i64 16
  %.618.i.idx = shl i64 %factor.op.mul9261, 4
  %.618.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.618.i.idx
  %.452.i = uitofp i64 %.8798 to double
  %.idx673.i = mul i64 %arg.batch.4.0.5.1, 48
  %64 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx673.i
  %.287.i679.not.i = icmp slt i64 %arg.shape.1, 1
  %.359.i.i8863 = shl nsw i64 %arg.shape.1, 1
  %.idx.i8864 = mul i64 %arg.batch.4.0.5.1, 40
  %65 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i8864
  %.155.i.i.i8875 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i8882 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i8888 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i8894 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i8900 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i8906 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i8912 = mul nsw i64 %arg.shape.1, 18
  %factor.op.mul652.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx.i8931 = shl i64 %arg.batch.4.1.5.1, 4
  %66 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx.i8931
  %.idx640.i = mul i64 %arg.batch.4.0.5.1, 40
  %67 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx640.i
  %.idx641.i = mul i64 %arg.batch.4.0.5.1, 48
  %68 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx641.i
  %.idx642.i = mul i64 %arg.batch.4.0.5.1, 56
  %69 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx642.i
  %.924649.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx644.i = mul i64 %arg.batch.4.0.5.1, 224
  %70 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx644.i
  %.1000.i = mul nsw i64 %arg.shape.1, 17
  %71 = add i64 %arg.batch.2.5.0, -1
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.5026 = icmp sgt i64 %arg.shape.0, 1
  %.5080.idx = mul i64 %arg.batch.4.0.5.1, 40
  %.5080 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.5080.idx
  %.5112 = getelementptr i8, ptr %arg.code.4, i64 96
  %.idx8748 = mul i64 %arg.batch.4.0.5.1, 96
  %72 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8748
  %.idx8749 = mul i64 %arg.batch.4.0.5.1, 40
  %73 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8749
  %.idx8750 = mul i64 %arg.batch.4.0.5.1, 120
  %74 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8750
  %.552.i38949239.not = icmp slt i64 %arg.shape.1, 1
  %.697.i3931 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %75 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.742.i3961 = getelementptr i8, ptr %75, i64 -8
  %.idx8752 = mul i64 %arg.batch.4.1.5.1, 24
  %76 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8752
  %.idx8753 = mul i64 %arg.batch.4.1.5.1, 24
  %77 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8753
  %.idx8754 = mul i64 %arg.batch.4.0.5.1, 24
  %78 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8754
  %.5223.not = icmp ne i64 %arg.shape.4, 0
  %.idx1879.i = mul i64 %arg.batch.4.0.5.1, 40
  %79 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1879.i
  %.idx1880.i = shl i64 %arg.batch.4.0.5.1, 4
  %80 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1880.i
  %81 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.175.i5391882.not.i = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.636.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.779.i = getelementptr i8, ptr %arg.code.4, i64 32
  %.850.i = mul nsw i64 %arg.shape.1, 17
  %.852.i = mul nsw i64 %.850.i, %arg.shape.0
  %.895.i8956 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.852.i
  %.idx1877.i = shl i64 %arg.batch.4.1.5.1, 4
  %82 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1877.i
  %.13761889.not.i = icmp slt i64 %arg.shape.1, 1
  %.1571.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.1663.not.i = icmp eq i64 %arg.shape.3, 0
  %.1693.i8959 = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx8737 = mul i64 %arg.batch.4.0.5.1, 40
  %83 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8737
  %.idx8738 = shl i64 %arg.batch.4.0.5.1, 4
  %84 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8738
  %85 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx8739 = mul i64 %arg.batch.4.0.5.1, 24
  %86 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8739
  %.175.i.i52579251.not = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.idx8742 = shl i64 %arg.batch.4.1.5.1, 4
  %87 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8742
  %.idx.i8976 = mul i64 %arg.batch.4.0.5.1, 24
  %88 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i8976
  %.323.i8978 = getelementptr i8, ptr %arg.batch.4.2.4, i64 8
  %89 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx1124.i8998 = mul i64 %arg.batch.4.1.5.1, 24
  %90 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1124.i8998
  %.8051131.not.i9000 = icmp slt i64 %arg.batch.0.1.5.1, 1
  %.175.i1134.not.i9016 = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.11171137.not.i9035 = icmp slt i64 %arg.shape.1, 1
  %gep.2.idx.i9053 = shl i64 %arg.batch.4.0.5.1, 4
  %gep.4.idx.i9057 = shl i64 %arg.batch.4.0.5.1, 5
  %gep.6.idx.i9061 = mul i64 %arg.batch.4.0.5.1, 48
  %gep.7.idx.i9063 = mul i64 %arg.batch.4.0.5.1, 56
  %gep.9.idx.i9067 = mul i64 %arg.batch.4.0.5.1, 72
  %gep.10.idx.i9069 = mul i64 %arg.batch.4.0.5.1, 80
  %gep.11.idx.i9071 = mul i64 %arg.batch.4.0.5.1, 88
  %gep.12.idx.i9073 = mul i64 %arg.batch.4.0.5.1, 96
  %gep.13.idx.i9075 = mul i64 %arg.batch.4.0.5.1, 104
  %gep.14.idx.i9077 = mul i64 %arg.batch.4.0.5.1, 112
  %gep.15.idx.i9079 = mul i64 %arg.batch.4.0.5.1, 120
  %gep.16.idx.i9081 = shl i64 %arg.batch.4.0.5.1, 7
  %gep.17.idx.i9083 = mul i64 %arg.batch.4.0.5.1, 136
  %gep.18.idx.i9085 = mul i64 %arg.batch.4.0.5.1, 144
  %gep.19.idx.i9087 = mul i64 %arg.batch.4.0.5.1, 152
  %gep.20.idx.i9089 = mul i64 %arg.batch.4.0.5.1, 160
  %gep.21.idx.i9091 = mul i64 %arg.batch.4.0.5.1, 168
  %gep.22.idx.i9093 = mul i64 %arg.batch.4.0.5.1, 176
  %gep.23.idx.i9095 = mul i64 %arg.batch.4.0.5.1, 184
  %gep.24.idx.i9097 = mul i64 %arg.batch.4.0.5.1, 192
  %gep.25.idx.i9099 = mul i64 %arg.batch.4.0.5.1, 200
  %gep.26.idx.i9101 = mul i64 %arg.batch.4.0.5.1, 208
  %gep.27.idx.i9103 = mul i64 %arg.batch.4.0.5.1, 216
  %gep.28.idx.i9105 = mul i64 %arg.batch.4.0.5.1, 224
  %91 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i9053
  %92 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.15.idx.i9079
  %93 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.28.idx.i9105
  %.idx1130.i9120 = mul i64 %arg.batch.4.0.5.1, 232
  %94 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i9120
  %.idx8741 = mul i64 %arg.batch.4.0.5.1, 232
  %95 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8741
  %.6289 = tail call i64 @llvm.smin.i64(i64 %arg.batch.2.5.0, i64 0)
  %96 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %97 = getelementptr i8, ptr %96, i64 -8
  %.6303 = getelementptr double, ptr %97, i64 %.6289
  %98 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx8743 = mul i64 %arg.batch.4.0.5.1, 232
  %99 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8743
  %.idx8744 = mul i64 %arg.batch.4.0.5.1, 152
  %100 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8744
  %.idx8745 = shl i64 %arg.batch.4.1.5.1, 4
  %101 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8745
  %.idx8746 = shl i64 %arg.batch.4.0.5.1, 4
  %102 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8746
  %.idx8747 = mul i64 %arg.batch.4.0.5.1, 144
  %103 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8747
  %104 = getelementptr i8, ptr %arg.code.4, i64 208
  %.4487.idx = mul i64 %.397, 112
  %.4487 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4487.idx
  %105 = getelementptr i8, ptr %arg.code.4, i64 216
  %.4487.1.idx = mul i64 %.397, 120
  %.4487.1 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4487.1.idx
  %106 = getelementptr i8, ptr %arg.code.4, i64 224
  %.4487.2.idx = shl i64 %.397, 7
  %.4487.2 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4487.2.idx
  br label %B422

B422:                                             ; preds = %B422.preheader, %B4426
  %budget.3.1 = phi i64 [ %budget.4.2, %B4426 ], [ %arg.budget, %B422.preheader ]
  %looked.3.1 = phi i1 [ %looked.4.2.lcssa, %B4426 ], [ true, %B422.preheader ]
  %active.9.1 = phi i64 [ %active.8.2, %B4426 ], [ %active.4.0.lcssa, %B422.preheader ]
  %.950 = add nsw i64 %budget.3.1, -1
  %.985 = load i64, ptr %.984, align 8
  %.986 = icmp eq i64 %.985, 1
  %.1020 = icmp sgt i64 %.985, 0
  br i1 %.1020, label %B490, label %B568

B490:                                             ; preds = %B422
  store i64 0, ptr %.984, align 8
  %.1081 = load i64, ptr %.1080, align 8
  %.1126 = inttoptr i64 %.1081 to ptr
  tail call void %.1126(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B568

B568:                                             ; preds = %B490, %B422
  br i1 %.986, label %B574, label %B1148

B574:                                             ; preds = %B568
  br i1 %.1132, label %B586, label %B630

B586:                                             ; preds = %B574
  %.150.i = load i64, ptr %.149.i, align 8, !noalias !7
  %.195.i = inttoptr i64 %.150.i to ptr
  tail call void %.195.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br i1 %.606, label %B250.i, label %B118.if.i

B248.i:                                           ; preds = %B190.if.i, %B118.if.i
  %.279.i = icmp sgt i64 %.224.i.09141, 1
  br i1 %.279.i, label %B118.if.i, label %B250.i

B250.i:                                           ; preds = %B248.i, %B586
  %.614.i = load i64, ptr %.613.i, align 8, !noalias !7
  %.661.i = inttoptr i64 %.614.i to ptr
  tail call void %.661.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br label %B630

B118.if.i:                                        ; preds = %B586, %B248.i
  %.224.i.09141 = phi i64 [ %.288.i, %B248.i ], [ %storemerge, %B586 ]
  %.221.i.09140 = phi i64 [ %.292.i, %B248.i ], [ 0, %B586 ]
  %.288.i = add nsw i64 %.224.i.09141, -1
  %.292.i = add nsw i64 %.221.i.09140, 1
  %107 = getelementptr double, ptr %19, i64 %.221.i.09140
  %.374.i = load double, ptr %107, align 8, !noalias !7
  %.375.i = fcmp ule double %.374.i, 5.000000e-01
  %brmerge9265 = select i1 %.375.i, i1 true, i1 %.457.i9136
  br i1 %brmerge9265, label %B248.i, label %B190.if.i.preheader

B190.if.i.preheader:                              ; preds = %B118.if.i
  %invariant.gep9293 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.221.i.09140
  br label %B190.if.i

B190.if.i:                                        ; preds = %B190.if.i.preheader, %B190.if.i
  %.401.i.09137 = phi i64 [ %.470.i, %B190.if.i ], [ 0, %B190.if.i.preheader ]
  %.470.i = add nsw i64 %.401.i.09137, 1
  %.496.i = mul nsw i64 %.401.i.09137, %arg.shape.0
  %gep9294 = getelementptr double, ptr %invariant.gep9293, i64 %.496.i
  %.528.i = load double, ptr %gep9294, align 8, !noalias !7
  %.530.i = add nsw i64 %.401.i.09137, %arg.shape.5
  %.532.i = mul nsw i64 %.530.i, %arg.shape.0
  %.534.i = add nsw i64 %.532.i, %.221.i.09140
  %.548.i = icmp slt i64 %.534.i, 0
  %.549.i = select i1 %.548.i, i64 %arg.batch.5.1.5.0, i64 0
  %108 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.534.i
  %.563.i = getelementptr double, ptr %108, i64 %.549.i
  store double %.528.i, ptr %.563.i, align 8, !noalias !7
  %exitcond.not = icmp eq i64 %.470.i, %arg.shape.6
  br i1 %exitcond.not, label %B248.i, label %B190.if.i

B630:                                             ; preds = %B250.i, %B574
  br i1 %.1191.not, label %B702, label %B634

B634:                                             ; preds = %B630
  %.1222 = load i64, ptr %.1221, align 8
  %.1267 = inttoptr i64 %.1222 to ptr
  tail call void %.1267(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B702

B702:                                             ; preds = %B634, %B630
  br i1 %.546.not, label %B706, label %B1106

B706:                                             ; preds = %B702
  %.1301 = load i64, ptr %arg.code.4, align 8
  %.1349 = inttoptr i64 %.1301 to ptr
  tail call void %.1349(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1348)
  %.1380 = load i64, ptr %.1379, align 8
  %.1425 = inttoptr i64 %.1380 to ptr
  tail call void %.1425(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.1456 = load i64, ptr %.1455, align 8
  %.1501 = inttoptr i64 %.1456 to ptr
  tail call void %.1501(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.1532 = load i64, ptr %arg.code.4, align 8
  %.1582 = inttoptr i64 %.1532 to ptr
  tail call void %.1582(ptr %.505, ptr %.1556, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1581)
  %.1613 = load i64, ptr %.1612, align 8
  %.1658 = inttoptr i64 %.1613 to ptr
  tail call void %.1658(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B1106

B1106:                                            ; preds = %B706, %B702
  br i1 %.606, label %B1148, label %B64.if.i

B106.i:                                           ; preds = %B64.if.i
  store double 0.000000e+00, ptr %.323.i137, align 8, !noalias !11
  %.441.i197 = getelementptr double, ptr %21, i64 %.170.i8.09143
  store double 0.000000e+00, ptr %.441.i197, align 8, !noalias !11
  %.496.i221 = getelementptr double, ptr %22, i64 %.170.i8.09143
  store double 0.000000e+00, ptr %.496.i221, align 8, !noalias !11
  %.551.i256 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.170.i8.09143
  %.552.i = load i64, ptr %.551.i256, align 8, !noalias !11
  %.579.i269 = icmp slt i64 %.552.i, 0
  %.580.i = select i1 %.579.i269, i64 %arg.batch.3.3.5.0, i64 0
  %.581.i270 = add i64 %.580.i, %.552.i
  %.601.i281 = mul i64 %.581.i270, %arg.batch.3.3.5.1
  %109 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.601.i281
  %.605.i = getelementptr i8, ptr %109, i64 8
  %.606.i284 = load i64, ptr %.605.i, align 8, !noalias !11
  %.628.i290 = add nsw i64 %.606.i284, %.8788
  store i64 %.628.i290, ptr %.605.i, align 8, !noalias !11
  %.744.i = load i64, ptr %.551.i256, align 8, !noalias !11
  %.771.i = icmp slt i64 %.744.i, 0
  %.772.i = select i1 %.771.i, i64 %arg.batch.3.3.5.0, i64 0
  %.773.i = add i64 %.772.i, %.744.i
  %.793.i = mul i64 %.773.i, %arg.batch.3.3.5.1
  %110 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.793.i
  %.797.i = getelementptr i8, ptr %110, i64 16
  %.798.i = load i64, ptr %.797.i, align 8, !noalias !11
  %.799.i = add nsw i64 %.798.i, 1
  store i64 %.799.i, ptr %.797.i, align 8, !noalias !11
  %.905.i = getelementptr double, ptr %23, i64 %.170.i8.09143
  %.906.i = load double, ptr %.905.i, align 8, !noalias !11
  %.907.i = fcmp une double %.906.i, 0.000000e+00
  br i1 %.907.i, label %B368.i, label %B414.i

B368.i:                                           ; preds = %B106.i
  %111 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.170.i8.09143
  %.84.i.i = load i64, ptr %111, align 8, !noalias !15
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
  br i1 %.1191.not, label %B550.i, label %B418.i

B418.i:                                           ; preds = %B414.i
  %112 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.170.i8.09143
  %.977.i = load double, ptr %112, align 8, !noalias !11
  %.979.i = fcmp olt double %.977.i, -1.000000e-09
  br i1 %.979.i, label %B454.i, label %B550.i

B454.i:                                           ; preds = %B418.i
  %113 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.170.i8.09143
  %.84.i63.i = load i64, ptr %113, align 8, !noalias !18
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
  %.1068.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.170.i8.09143
  %.1069.i = load double, ptr %.1068.i, align 8, !noalias !11
  %.1123.i = getelementptr double, ptr %24, i64 %.170.i8.09143
  store double %.1069.i, ptr %.1123.i, align 8, !noalias !11
  br label %B550.i

B550.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i, %B418.i, %B414.i
  %.111.i183.i = getelementptr i64, ptr %25, i64 %.170.i8.09143
  %.112.i.i = load i64, ptr %.111.i183.i, align 8, !noalias !21
  %.169.i.i = getelementptr double, ptr %26, i64 %.170.i8.09143
  %.170.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.224.i.i = getelementptr double, ptr %27, i64 %.170.i8.09143
  store double %.170.i.i, ptr %.224.i.i, align 8, !noalias !21
  %.237.i.i = icmp slt i64 %.112.i.i, %arg.batch.2.5.0
  br i1 %.237.i.i, label %B134.i.i, label %B584.i

B134.i.i:                                         ; preds = %B550.i
  %.253.i.i = icmp slt i64 %.112.i.i, 0
  %.254.i.i = select i1 %.253.i.i, i64 %arg.batch.2.5.0, i64 0
  %114 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i.i
  %.268.i.i = getelementptr double, ptr %114, i64 %.254.i.i
  %.269.i.i = load double, ptr %.268.i.i, align 8, !noalias !21
  %.328.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.10.i.i.i = fcmp olt double %.328.i.i, %.269.i.i
  %.11.i.i.i = select i1 %.10.i.i.i, double %.328.i.i, double %.269.i.i
  store double %.11.i.i.i, ptr %.224.i.i, align 8, !noalias !21
  br label %B584.i

B584.i:                                           ; preds = %B134.i.i, %B550.i, %B64.if.i
  %.229.i = icmp sgt i64 %.173.i.09144, 1
  br i1 %.229.i, label %B64.if.i, label %B1148

B64.if.i:                                         ; preds = %B1106, %B584.i
  %.173.i.09144 = phi i64 [ %.238.i315, %B584.i ], [ %storemerge, %B1106 ]
  %.170.i8.09143 = phi i64 [ %.242.i, %B584.i ], [ 0, %B1106 ]
  %.238.i315 = add nsw i64 %.173.i.09144, -1
  %.242.i = add nsw i64 %.170.i8.09143, 1
  %.323.i137 = getelementptr double, ptr %20, i64 %.170.i8.09143
  %.324.i138 = load double, ptr %.323.i137, align 8, !noalias !11
  %.325.i = fcmp ogt double %.324.i138, 5.000000e-01
  br i1 %.325.i, label %B106.i, label %B584.i

B1148:                                            ; preds = %B584.i, %B1106, %B568
  %brmerge = select i1 %looked.3.1, i1 true, i1 %.546.not
  br i1 %brmerge, label %B1156, label %B1224

B1156:                                            ; preds = %B1148
  %.1758 = load i64, ptr %.1757, align 8
  %.1803 = inttoptr i64 %.1758 to ptr
  tail call void %.1803(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B1224

B1224:                                            ; preds = %B1148, %B1156
  br i1 %.546.not, label %B1312, label %B1228

B1228:                                            ; preds = %B1224
  %.1837 = load i64, ptr %arg.code.4, align 8
  %.1884 = inttoptr i64 %.1837 to ptr
  tail call void %.1884(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1883)
  br label %B1312

B1312:                                            ; preds = %B1228, %B1224
  br i1 %.544, label %B1316, label %B1356

B1316:                                            ; preds = %B1312
  br i1 %.174.not.i, label %B0.else.endif.endif.endif.if.i, label %B0.else.endif.if.i, !prof !25

B124.i:                                           ; preds = %B0.endif.else.endif.endif.i
  %.154.i.i8817 = load i64, ptr %.153.i.i, align 8, !noalias !26
  %.184.i.i8819 = load i64, ptr %.183.i.i8818, align 8, !noalias !26
  br i1 %.234.i.i, label %B0.else.endif.if.i.i, label %B0.else.endif.endif.i.i, !prof !32

B412.i.i:                                         ; preds = %B330.if.i.i, %B0.endif.endif.endif.endif.endif.i.i
  %.1311.i.i = add nsw i64 %.486.i.i, -1
  %.1349.i.i = icmp slt i64 %.477.i.i, 2
  %storemerge2355.i = select i1 %.1349.i.i, i64 0, i64 %.1311.i.i
  %.1392.i2403.i = icmp sgt i64 %storemerge2355.i, 0
  br i1 %.1392.i2403.i, label %B478.i.lr.ph.i, label %B164.i

B478.i.lr.ph.i:                                   ; preds = %B412.i.i
  %.1338.i.12406.i = add nsw i64 %storemerge2355.i, -1
  %.952.i.i.i = select i1 %.1556.i2382.not.i, i64 %.311.i.i8821, i64 0
  %115 = getelementptr i64, ptr %.327.i.i, i64 %arg.shape.1
  %.966.i.i.i = getelementptr i64, ptr %115, i64 %.952.i.i.i
  br label %B478.i.i

B474.i.loopexit.i:                                ; preds = %B1253.i.i, %B960.i.i
  %.1392.i.i = icmp sgt i64 %.1338.i.12408.i, 0
  %.1405.i.i = zext i1 %.1392.i.i to i64
  %.1335.i.1.i = add i64 %.1335.i.12407.i, %.1405.i.i
  %.1401.i.i = sext i1 %.1392.i.i to i64
  %.1338.i.1.i = add nsw i64 %.1338.i.12408.i, %.1401.i.i
  %.1382.i.sroa.0.0.i = select i1 %.1392.i.i, i64 %.1335.i.12407.i, i64 0
  br i1 %.1392.i.i, label %B478.i.i, label %B164.i

B478.i.i:                                         ; preds = %B474.i.loopexit.i, %B478.i.lr.ph.i
  %.1382.i.sroa.0.02409.i = phi i64 [ 0, %B478.i.lr.ph.i ], [ %.1382.i.sroa.0.0.i, %B474.i.loopexit.i ]
  %.1338.i.12408.i = phi i64 [ %.1338.i.12406.i, %B478.i.lr.ph.i ], [ %.1338.i.1.i, %B474.i.loopexit.i ]
  %.1335.i.12407.i = phi i64 [ 1, %B478.i.lr.ph.i ], [ %.1335.i.1.i, %B474.i.loopexit.i ]
  %.1462.i.i = load i64, ptr %.1461.i.i, align 8, !noalias !26
  %.1463.i.i = icmp sgt i64 %.1462.i.i, 0
  br i1 %.1463.i.i, label %B508.i.i, label %B918.i.i

B508.i.i:                                         ; preds = %B478.i.i
  br i1 %.1556.i2382.not.i, label %B610.i.i, label %B544.if.i.i

B610.i.i:                                         ; preds = %B544.if.i.i, %B508.i.i
  %.1717.i.i = load i64, ptr %.1716.i.i, align 8, !noalias !26
  %.1833.i.i = inttoptr i64 %.1717.i.i to ptr
  tail call void %.1833.i.i(ptr %arg.batch.4.0.4, ptr %.1807.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1832.i.i), !noalias !26
  %.1849.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, 0
  %.1850.i.i = select i1 %.1849.i.i, i64 %.486.i.i, i64 0
  %116 = getelementptr i64, ptr %.502.i.i, i64 %.1382.i.sroa.0.02409.i
  %.1864.i.i = getelementptr i64, ptr %116, i64 %.1850.i.i
  %.1865.i.i = load i64, ptr %.1864.i.i, align 8, !noalias !26
  %.1881.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, -1
  %.1882.i.i = select i1 %.1881.i.i, i64 %.486.i.i, i64 0
  %117 = getelementptr i8, ptr %116, i64 8
  %.1896.i.i = getelementptr i64, ptr %117, i64 %.1882.i.i
  %.1897.i.i = load i64, ptr %.1896.i.i, align 8, !noalias !26
  %.1934.i.i = sub i64 %.1897.i.i, %.1865.i.i
  %.1980.i2385.not.i = icmp slt i64 %.1934.i.i, 1
  br i1 %.1980.i2385.not.i, label %B960.i.i, label %B794.if.i.i

B802.i.i:                                         ; preds = %B794.if.i.i
  %.2047.i.i = icmp slt i64 %.1921.i.02386.i, 0
  %.2048.i.i = select i1 %.2047.i.i, i64 %.665.i.i, i64 0
  %118 = getelementptr i64, ptr %.681.i.i, i64 %.1921.i.02386.i
  %.2062.i.i = getelementptr i64, ptr %118, i64 %.2048.i.i
  %.2063.i.i = load i64, ptr %.2062.i.i, align 8, !noalias !26
  %.2064.i.i = add nsw i64 %.2063.i.i, %.1789.i.i
  %.2078.i.i = icmp slt i64 %.2064.i.i, 0
  %.2079.i.i = select i1 %.2078.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %119 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2064.i.i
  %.2093.i.i = getelementptr double, ptr %119, i64 %.2079.i.i
  %.2094.i.i = load double, ptr %.2093.i.i, align 8, !noalias !26
  %.2161.i.i = fsub double %.2094.i.i, %.2094.i.i
  %.2162.i.i = fcmp oeq double %.2161.i.i, 0.000000e+00
  br label %B910.i.i

B910.i.i:                                         ; preds = %B794.if.i.i, %B802.i.i
  %"$phi910.2.2.i.3.i" = phi i1 [ %.2162.i.i, %B802.i.i ], [ false, %B794.if.i.i ]
  %.1980.i.i = icmp sgt i64 %.1924.i.02387.i, 1
  br i1 %.1980.i.i, label %B794.if.i.i, label %B914.i.i

B914.i.i:                                         ; preds = %B910.i.i
  br i1 %"$phi910.2.2.i.3.i", label %B960.i.i, label %B918.i.i

B918.i.i:                                         ; preds = %B914.i.i, %B478.i.i
  %.154.i.i.i = load double, ptr %.153.i.i.i, align 8, !noalias !33
  %.183.i.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !33
  %.187.i.i.i = fdiv double %.154.i.i.i, %.183.i.i.i
  br i1 %.1162.i2379.not.i, label %B498.i.i.i.critedge, label %B84.if.i.i.i

B230.i.i.i:                                       ; preds = %B84.if.i.i.i
  %.500.i.i.i = load double, ptr %.499.i.i.i, align 8, !noalias !33
  %.501.i.i.i = fmul double %.500.i.i.i, 1.000000e-03
  store double %.501.i.i.i, ptr %.534.i.i.i, align 8, !noalias !33
  br label %B370.if.i.i.i

B398.i.i.i:                                       ; preds = %B370.if.i.i.i
  %gep9146 = getelementptr double, ptr %invariant.gep9145, i64 %.687.i.i.02393.i
  %.851.i.i.i = load double, ptr %gep9146, align 8, !noalias !33
  %.853.i.i.i = fmul double %.851.i.i.i, 5.000000e-01
  br label %B444.i.i.i

B444.i.i.i:                                       ; preds = %B370.if.i.i.i, %B398.i.i.i
  %"$phi444.2.2.i.i.2.i" = phi double [ %.853.i.i.i, %B398.i.i.i ], [ 0.000000e+00, %B370.if.i.i.i ]
  %120 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.687.i.i.02393.i
  %.894.i.i.i = load double, ptr %120, align 8, !noalias !33
  %.895.i.i.i = fadd double %"$phi444.2.2.i.i.2.i", %.894.i.i.i
  %121 = getelementptr double, ptr %120, i64 %.897.i.i.i
  store double %.895.i.i.i, ptr %121, align 8, !noalias !33
  %exitcond2417.not.i = icmp eq i64 %arg.shape.1, %.756.i.i.i
  br i1 %exitcond2417.not.i, label %B498.i.i.i, label %B370.if.i.i.i

B498.i.i.i.critedge:                              ; preds = %B918.i.i
  %.500.i.i.i.c = load double, ptr %.499.i.i.i, align 8, !noalias !33
  %.501.i.i.i.c = fmul double %.500.i.i.i.c, 1.000000e-03
  store double %.501.i.i.i.c, ptr %.534.i.i.i, align 8, !noalias !33
  br label %B498.i.i.i

B498.i.i.i:                                       ; preds = %B444.i.i.i, %B498.i.i.i.critedge
  %.967.i.i.i = load i64, ptr %.966.i.i.i, align 8, !noalias !33
  %.969.i.i.i = icmp eq i64 %.967.i.i.i, %.1382.i.sroa.0.02409.i
  br i1 %.969.i.i.i, label %B522.i.i.i, label %B568.i.i.i

B522.i.i.i:                                       ; preds = %B498.i.i.i
  %.1004.i.i.i = load double, ptr %.534.i.i.i, align 8, !noalias !33
  %.1006.i.i.i = fmul double %.1004.i.i.i, 5.000000e-01
  br label %B568.i.i.i

B568.i.i.i:                                       ; preds = %B522.i.i.i, %B498.i.i.i
  %"$phi568.1.2.i.i.1.i" = phi double [ %.1006.i.i.i, %B522.i.i.i ], [ 0.000000e+00, %B498.i.i.i ]
  %.1074.i.i.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !33
  %.1075.i.i.i = fadd double %"$phi568.1.2.i.i.1.i", %.1074.i.i.i
  store double %.1075.i.i.i, ptr %.505, align 8, !noalias !33
  %.1164.i.i.i = load i64, ptr %arg.code.4, align 8, !noalias !33
  %.1280.i.i.i = inttoptr i64 %.1164.i.i.i to ptr
  tail call void %.1280.i.i.i(ptr nonnull %.505, ptr %.1807.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1279.i.i.i), !noalias !33
  br i1 %.1162.i2379.not.i, label %B498.i.i.1.i, label %B370.if.i.i.1.i

B1060.i.i.i:                                      ; preds = %B902.if.i.i.i
  %.1750.i.i.i = fsub double %.1666.i.i.i, %.1697.i.i.i
  br label %B1148.i.i.i

B1100.i.i.i:                                      ; preds = %B902.if.i.i.i
  %122 = getelementptr double, ptr %130, i64 %arg.shape.1
  %.1731.i.i.i = load double, ptr %122, align 8, !noalias !33
  %.1796.i.i.i = fsub double %.1666.i.i.i, %.1731.i.i.i
  %.1801.i.i.i = fmul double %.1796.i.i.i, 2.000000e+00
  br label %B1148.i.i.i

B370.if.i.i.1.i:                                  ; preds = %B568.i.i.i, %B444.i.i.1.i
  %.687.i.i.02393.1.i = phi i64 [ %.756.i.i.1.i, %B444.i.i.1.i ], [ 0, %B568.i.i.i ]
  %.756.i.i.1.i = add nsw i64 %.687.i.i.02393.1.i, 1
  %123 = getelementptr i64, ptr %.327.i.i, i64 %.687.i.i.02393.1.i
  %.814.i.i.1.i = load i64, ptr %123, align 8, !noalias !33
  %.816.i.i.1.i = icmp eq i64 %.814.i.i.1.i, %.1382.i.sroa.0.02409.i
  br i1 %.816.i.i.1.i, label %B398.i.i.1.i, label %B444.i.i.1.i

B398.i.i.1.i:                                     ; preds = %B370.if.i.i.1.i
  %gep9148 = getelementptr double, ptr %invariant.gep9147, i64 %.687.i.i.02393.1.i
  %.851.i.i.1.i = load double, ptr %gep9148, align 8, !noalias !33
  %.853.i.i.1.i = fmul double %.851.i.i.1.i, -5.000000e-01
  br label %B444.i.i.1.i

B444.i.i.1.i:                                     ; preds = %B398.i.i.1.i, %B370.if.i.i.1.i
  %"$phi444.2.2.i.i.2.1.i" = phi double [ %.853.i.i.1.i, %B398.i.i.1.i ], [ 0.000000e+00, %B370.if.i.i.1.i ]
  %124 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.687.i.i.02393.1.i
  %.894.i.i.1.i = load double, ptr %124, align 8, !noalias !33
  %.895.i.i.1.i = fadd double %"$phi444.2.2.i.i.2.1.i", %.894.i.i.1.i
  %125 = getelementptr double, ptr %124, i64 %.897.i.i.i
  store double %.895.i.i.1.i, ptr %125, align 8, !noalias !33
  %exitcond2417.1.not.i = icmp eq i64 %arg.shape.1, %.756.i.i.1.i
  br i1 %exitcond2417.1.not.i, label %B498.i.i.1.i, label %B370.if.i.i.1.i

B498.i.i.1.i:                                     ; preds = %B444.i.i.1.i, %B568.i.i.i
  %.967.i.i.1.i = load i64, ptr %.966.i.i.i, align 8, !noalias !33
  %.969.i.i.1.i = icmp eq i64 %.967.i.i.1.i, %.1382.i.sroa.0.02409.i
  br i1 %.969.i.i.1.i, label %B522.i.i.1.i, label %B568.i.i.1.i

B522.i.i.1.i:                                     ; preds = %B498.i.i.1.i
  %.1004.i.i.1.i = load double, ptr %.534.i.i.i, align 8, !noalias !33
  %.1006.i.i.1.i = fmul double %.1004.i.i.1.i, -5.000000e-01
  br label %B568.i.i.1.i

B568.i.i.1.i:                                     ; preds = %B522.i.i.1.i, %B498.i.i.1.i
  %"$phi568.1.2.i.i.1.1.i" = phi double [ %.1006.i.i.1.i, %B522.i.i.1.i ], [ 0.000000e+00, %B498.i.i.1.i ]
  %.1074.i.i.1.i = load double, ptr %arg.batch.4.0.4, align 8, !noalias !33
  %.1075.i.i.1.i = fadd double %"$phi568.1.2.i.i.1.1.i", %.1074.i.i.1.i
  store double %.1075.i.i.1.i, ptr %.505, align 8, !noalias !33
  %.1312.i.i.1.i = load i64, ptr %arg.code.4, align 8, !noalias !33
  %.1426.i.i.1.i = inttoptr i64 %.1312.i.i.1.i to ptr
  tail call void %.1426.i.i.1.i(ptr nonnull %.505, ptr %.1807.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !33
  br i1 %.1162.i2379.not.i, label %B960.i.i, label %B902.if.i.i.i

B1148.i.i.i:                                      ; preds = %B1100.i.i.i, %B1060.i.i.i
  %storemerge2363.i = phi double [ %.1801.i.i.i, %B1100.i.i.i ], [ %.1750.i.i.i, %B1060.i.i.i ]
  store double %storemerge2363.i, ptr %132, align 8, !noalias !33
  %exitcond2419.not.i = icmp eq i64 %arg.shape.1, %.1540.i.i.i
  br i1 %exitcond2419.not.i, label %B960.i.i, label %B902.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B918.i.i, %B84.if.i.i.i
  %.215.i.i.02391.i = phi i64 [ %.286.i.i.i, %B84.if.i.i.i ], [ 0, %B918.i.i ]
  %.286.i.i.i = add nsw i64 %.215.i.i.02391.i, 1
  %126 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.215.i.i.02391.i
  %.344.i.i.i = load double, ptr %126, align 8, !noalias !33
  %.345.i.i.i = tail call double @llvm.fabs.f64(double %.344.i.i.i)
  %.10.i.i.i.i = fcmp ogt double %.187.i.i.i, %.345.i.i.i
  %.11.i.i.i.i = select i1 %.10.i.i.i.i, double %.187.i.i.i, double %.345.i.i.i
  %.380.i.i.i = fcmp ogt double %.11.i.i.i.i, 0.000000e+00
  %127 = fmul double %.11.i.i.i.i, 1.200000e-05
  %"$phi194.2.2.i.i.1.i" = select i1 %.380.i.i.i, double %127, double 1.200000e-05
  %128 = getelementptr i8, ptr %126, i64 %.idx2424.i
  store double %"$phi194.2.2.i.i.1.i", ptr %128, align 8, !noalias !33
  %exitcond2416.not.i = icmp eq i64 %arg.shape.1, %.286.i.i.i
  br i1 %exitcond2416.not.i, label %B230.i.i.i, label %B84.if.i.i.i

B370.if.i.i.i:                                    ; preds = %B230.i.i.i, %B444.i.i.i
  %.687.i.i.02393.i = phi i64 [ %.756.i.i.i, %B444.i.i.i ], [ 0, %B230.i.i.i ]
  %.756.i.i.i = add nsw i64 %.687.i.i.02393.i, 1
  %129 = getelementptr i64, ptr %.327.i.i, i64 %.687.i.i.02393.i
  %.814.i.i.i = load i64, ptr %129, align 8, !noalias !33
  %.816.i.i.i = icmp eq i64 %.814.i.i.i, %.1382.i.sroa.0.02409.i
  br i1 %.816.i.i.i, label %B398.i.i.i, label %B444.i.i.i

B902.if.i.i.i:                                    ; preds = %B568.i.i.1.i, %B1148.i.i.i
  %.1471.i.i.02398.i = phi i64 [ %.1540.i.i.i, %B1148.i.i.i ], [ 0, %B568.i.i.1.i ]
  %.1540.i.i.i = add nsw i64 %.1471.i.i.02398.i, 1
  %130 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1471.i.i.02398.i
  %.1598.i.i.i = load double, ptr %130, align 8, !noalias !33
  %131 = getelementptr i8, ptr %130, i64 %.1807.i.idx.i
  store double %.1598.i.i.i, ptr %131, align 8, !noalias !33
  %132 = getelementptr i8, ptr %130, i64 %.1279.i.i.idx.i
  %.1666.i.i.i = load double, ptr %132, align 8, !noalias !33
  %133 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.1471.i.i.02398.i
  %.1697.i.i.i = load double, ptr %133, align 8, !noalias !33
  %.1743.i.i.i = fsub double %.1697.i.i.i, %.1697.i.i.i
  %.1744.i.i.i = fcmp oeq double %.1743.i.i.i, 0.000000e+00
  br i1 %.1744.i.i.i, label %B1060.i.i.i, label %B1100.i.i.i

B960.i.i:                                         ; preds = %B1148.i.i.i, %B568.i.i.1.i, %B914.i.i, %B610.i.i
  %.2258.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, 0
  %.2259.i.i = select i1 %.2258.i.i, i64 %.486.i.i, i64 0
  %134 = getelementptr i64, ptr %.502.i.i, i64 %.1382.i.sroa.0.02409.i
  %.2273.i.i = getelementptr i64, ptr %134, i64 %.2259.i.i
  %.2274.i.i = load i64, ptr %.2273.i.i, align 8, !noalias !26
  %.2292.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, -1
  %.2293.i.i = select i1 %.2292.i.i, i64 %.486.i.i, i64 0
  %135 = getelementptr i8, ptr %134, i64 8
  %.2307.i.i = getelementptr i64, ptr %135, i64 %.2293.i.i
  %.2308.i.i = load i64, ptr %.2307.i.i, align 8, !noalias !26
  %.2345.i.i = sub i64 %.2308.i.i, %.2274.i.i
  %.2388.i2400.not.i = icmp slt i64 %.2345.i.i, 1
  br i1 %.2388.i2400.not.i, label %B474.i.loopexit.i, label %B1022.if.i.i

B1178.i.i:                                        ; preds = %B1022.if.i.i
  %.2656.i.i = add nsw i64 %.2461.i.i, %.2622.i.i
  %.2671.i.i = icmp slt i64 %.2656.i.i, 0
  %.2672.i.i = select i1 %.2671.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %136 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2656.i.i
  %.2686.i.i = getelementptr double, ptr %136, i64 %.2672.i.i
  store double %.2560.i..i, ptr %.2686.i.i, align 8, !noalias !26
  br label %B1253.i.i

B1224.i.i:                                        ; preds = %B1022.if.i.i
  %.2706.i.i = select i1 %.2445.i.i, i64 %.1014.i.i, i64 0
  %137 = getelementptr i64, ptr %.1030.i.i, i64 %.2332.i.02401.i
  %.2720.i.i = getelementptr i64, ptr %137, i64 %.2706.i.i
  %.2721.i.i = load i64, ptr %.2720.i.i, align 8, !noalias !26
  %.2738.i.i = icmp slt i64 %.2721.i.i, 0
  %.2739.i.i = select i1 %.2738.i.i, i64 %arg.linear.0.5.0, i64 0
  %138 = getelementptr double, ptr %arg.linear.0.4, i64 %.2721.i.i
  %.2753.i.i = getelementptr double, ptr %138, i64 %.2739.i.i
  store double %.2560.i..i, ptr %.2753.i.i, align 8, !noalias !26
  br label %B1253.i.i

B1253.i.i:                                        ; preds = %B1224.i.i, %B1178.i.i
  %.2388.i.i = icmp sgt i64 %.2335.i.02402.i, 1
  br i1 %.2388.i.i, label %B1022.if.i.i, label %B474.i.loopexit.i

B0.endif.i.i:                                     ; preds = %B0.else.endif.endif.endif.if.i.i, %B0.else.endif.endif.endif.i.i
  %.214.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.else.endif.endif.endif.if.i.i ], [ %.214.i.sroa.11.1.i, %B0.else.endif.endif.endif.i.i ]
  %.302.i.i = sub i64 %.214.i.sroa.11.0.i, %spec.select.i
  %.311.i.i8821 = tail call i64 @llvm.smax.i64(i64 %.302.i.i, i64 0)
  %.327.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select.i
  %.362.i.i = add nsw i64 %.154.i.i8817, %.187.i.i
  br i1 %.409.i.i, label %B0.endif.else.endif.if.i.i, label %B0.endif.else.endif.endif.i.i, !prof !32

B0.else.endif.if.i.i:                             ; preds = %B124.i
  br label %B0.else.endif.endif.i.i

B0.else.endif.endif.i.i:                          ; preds = %B0.else.endif.if.i.i, %B124.i
  %simplifycfg.merge.i = phi i64 [ %arg.linear.1.5.0, %B0.else.endif.if.i.i ], [ 0, %B124.i ]
  %spec.select.i = select i1 %28, i64 %simplifycfg.merge.i, i64 %.226.i.i, !prof !37
  br i1 %.246.i.i, label %B0.else.endif.endif.if.i.i, label %B0.else.endif.endif.endif.i.i, !prof !32

B0.else.endif.endif.if.i.i:                       ; preds = %B0.else.endif.endif.i.i
  br label %B0.else.endif.endif.endif.i.i

B0.else.endif.endif.endif.i.i:                    ; preds = %B0.else.endif.endif.if.i.i, %B0.else.endif.endif.i.i
  %.214.i.sroa.11.1.i = phi i64 [ 0, %B0.else.endif.endif.if.i.i ], [ %.243.i.i, %B0.else.endif.endif.i.i ]
  br i1 %.251.i.not.i, label %B0.endif.i.i, label %B0.else.endif.endif.endif.if.i.i, !prof !25

B0.else.endif.endif.endif.if.i.i:                 ; preds = %B0.else.endif.endif.endif.i.i
  br label %B0.endif.i.i

B0.endif.endif.i.i:                               ; preds = %B0.endif.else.endif.endif.endif.if.i.i, %B0.endif.else.endif.endif.endif.i.i
  %.389.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.endif.endif.if.i.i ], [ %.389.i.sroa.11.1.i, %B0.endif.else.endif.endif.endif.i.i ]
  %.477.i.i = sub i64 %.389.i.sroa.11.0.i, %spec.select2366.i
  %.486.i.i = tail call i64 @llvm.smax.i64(i64 %.477.i.i, i64 0)
  %.502.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2366.i
  %.540.i.i = add i64 %.539.i.i, %.154.i.i8817
  %.541.i.i = add nsw i64 %.540.i.i, %.184.i.i8819
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
  %spec.select2366.i = select i1 %29, i64 %simplifycfg.merge2.i, i64 %.243.i.i, !prof !37
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
  %.656.i.i = sub i64 %.568.i.sroa.11.0.i, %spec.select2367.i
  %.665.i.i = tail call i64 @llvm.smax.i64(i64 %.656.i.i, i64 0)
  %.681.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2367.i
  %.711.i.i = shl nsw i64 %.184.i.i8819, 1
  %.712.i.i = add nsw i64 %.711.i.i, %.540.i.i
  %.759.i.i = icmp sge i64 %.597.i.i, %arg.linear.1.5.0
  br i1 %.759.i.i, label %B0.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.else.endif.endif.i.i, !prof !32

B0.endif.endif.else.endif.if.i.i:                 ; preds = %B0.endif.endif.i.i
  br label %B0.endif.endif.else.endif.endif.i.i

B0.endif.endif.else.endif.endif.i.i:              ; preds = %B0.endif.endif.else.endif.if.i.i, %B0.endif.endif.i.i
  %simplifycfg.merge4.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.i.i ]
  %139 = or i1 %.583.i.i, %.588.i.i
  %spec.select2367.i = select i1 %139, i64 %simplifycfg.merge4.i, i64 %.580.i.i, !prof !37
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
  %.827.i.i = sub i64 %.739.i.sroa.11.0.i, %spec.select2368.i
  %.836.i.i = tail call i64 @llvm.smax.i64(i64 %.827.i.i, i64 0)
  %.852.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2368.i
  %.889.i.i = mul nsw i64 %.184.i.i8819, 3
  %.890.i.i = add nsw i64 %.889.i.i, %.540.i.i
  %.937.i.i = icmp sge i64 %.768.i.i, %arg.linear.1.5.0
  br i1 %.937.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.i.i, !prof !32

B0.endif.endif.endif.else.endif.if.i.i:           ; preds = %B0.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.else.endif.endif.i.i:        ; preds = %B0.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.i.i
  %simplifycfg.merge6.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.i.i ]
  %140 = or i1 %.600.i.i, %.759.i.i
  %spec.select2368.i = select i1 %140, i64 %simplifycfg.merge6.i, i64 %.597.i.i, !prof !37
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
  %.1005.i.i = sub i64 %.917.i.sroa.11.0.i, %spec.select2369.i
  %.1014.i.i = tail call i64 @llvm.smax.i64(i64 %.1005.i.i, i64 0)
  %.1030.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2369.i
  br i1 %.1162.i2379.not.i, label %B412.i.i, label %B330.if.i.i

B0.endif.endif.endif.endif.else.endif.if.i.i:     ; preds = %B0.endif.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.endif.else.endif.endif.i.i:  ; preds = %B0.endif.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.endif.i.i
  %simplifycfg.merge8.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.endif.i.i ]
  %141 = or i1 %.771.i.i, %.937.i.i
  %spec.select2369.i = select i1 %141, i64 %simplifycfg.merge8.i, i64 %.768.i.i, !prof !37
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
  %.1104.i.02380.i = phi i64 [ %.1175.i.i, %B330.if.i.i ], [ 0, %B0.endif.endif.endif.endif.endif.i.i ]
  %.1175.i.i = add nsw i64 %.1104.i.02380.i, 1
  %142 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1104.i.02380.i
  %.1229.i.i = load double, ptr %142, align 8, !noalias !26
  %143 = getelementptr i8, ptr %142, i64 %.idx2421.i
  store double %.1229.i.i, ptr %143, align 8, !noalias !26
  %144 = getelementptr i8, ptr %142, i64 %.idx2422.i
  store double 0.000000e+00, ptr %144, align 8, !noalias !26
  %exitcond.not.i8822 = icmp eq i64 %arg.shape.1, %.1175.i.i
  br i1 %exitcond.not.i8822, label %B412.i.i, label %B330.if.i.i

B544.if.i.i:                                      ; preds = %B508.i.i, %B544.if.i.i
  %.1503.i.02384.i = phi i64 [ %.1565.i.i, %B544.if.i.i ], [ %storemerge2359.i, %B508.i.i ]
  %.1500.i.02383.i = phi i64 [ %.1569.i.i, %B544.if.i.i ], [ 0, %B508.i.i ]
  %.1565.i.i = add nsw i64 %.1503.i.02384.i, -1
  %.1569.i.i = add nsw i64 %.1500.i.02383.i, 1
  %145 = getelementptr i64, ptr %.327.i.i, i64 %.1500.i.02383.i
  %.1627.i.i = load i64, ptr %145, align 8, !noalias !26
  %.1629.i.i = icmp eq i64 %.1627.i.i, %.1382.i.sroa.0.02409.i
  %..i = select i1 %.1629.i.i, double 1.000000e+00, double 0.000000e+00
  %gep = getelementptr double, ptr %invariant.gep, i64 %.1500.i.02383.i
  store double %..i, ptr %gep, align 8, !noalias !26
  %.1556.i.i = icmp sgt i64 %.1503.i.02384.i, 1
  br i1 %.1556.i.i, label %B544.if.i.i, label %B610.i.i

B794.if.i.i:                                      ; preds = %B610.i.i, %B910.i.i
  %found.2.i.22388.i = phi i1 [ %"$phi910.2.2.i.3.i", %B910.i.i ], [ true, %B610.i.i ]
  %.1924.i.02387.i = phi i64 [ %.1989.i.i, %B910.i.i ], [ %.1934.i.i, %B610.i.i ]
  %.1921.i.02386.i = phi i64 [ %.1993.i.i, %B910.i.i ], [ %.1865.i.i, %B610.i.i ]
  %.1989.i.i = add nsw i64 %.1924.i.02387.i, -1
  %.1993.i.i = add i64 %.1921.i.02386.i, 1
  br i1 %found.2.i.22388.i, label %B802.i.i, label %B910.i.i

B1022.if.i.i:                                     ; preds = %B960.i.i, %B1253.i.i
  %.2335.i.02402.i = phi i64 [ %.2397.i.i, %B1253.i.i ], [ %.2345.i.i, %B960.i.i ]
  %.2332.i.02401.i = phi i64 [ %.2401.i.i, %B1253.i.i ], [ %.2274.i.i, %B960.i.i ]
  %.2397.i.i = add nsw i64 %.2335.i.02402.i, -1
  %.2401.i.i = add i64 %.2332.i.02401.i, 1
  %.2445.i.i = icmp slt i64 %.2332.i.02401.i, 0
  %.2446.i.i = select i1 %.2445.i.i, i64 %.665.i.i, i64 0
  %146 = getelementptr i64, ptr %.681.i.i, i64 %.2332.i.02401.i
  %.2460.i.i = getelementptr i64, ptr %146, i64 %.2446.i.i
  %.2461.i.i = load i64, ptr %.2460.i.i, align 8, !noalias !26
  %.2462.i.i = add nsw i64 %.2461.i.i, %.1789.i.i
  %.2476.i.i = icmp slt i64 %.2462.i.i, 0
  %.2477.i.i = select i1 %.2476.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %147 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2462.i.i
  %.2491.i.i = getelementptr double, ptr %147, i64 %.2477.i.i
  %.2492.i.i = load double, ptr %.2491.i.i, align 8, !noalias !26
  %.2510.i.i = select i1 %.2445.i.i, i64 %.836.i.i, i64 0
  %148 = getelementptr i64, ptr %.852.i.i, i64 %.2332.i.02401.i
  %.2524.i.i = getelementptr i64, ptr %148, i64 %.2510.i.i
  %.2525.i.i = load i64, ptr %.2524.i.i, align 8, !noalias !26
  %.2526.i.i = add nsw i64 %.2525.i.i, %.503.i.i.i
  %.2540.i.i = icmp slt i64 %.2526.i.i, 0
  %.2541.i.i = select i1 %.2540.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %149 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2526.i.i
  %.2555.i.i = getelementptr double, ptr %149, i64 %.2541.i.i
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
  br i1 %.711.i, label %B226.if.lr.ph.i, label %B1356

B226.if.lr.ph.i:                                  ; preds = %B164.i
  %.829.i = add i64 %.634.i, 1
  %150 = add i64 %.664.i, %.634.i
  br label %B226.if.i

B396.i:                                           ; preds = %B342.if.i, %B226.if.i
  %.1055.i = mul i64 %.697.02414.i, %.743.sroa.0.02358.i
  %.1071.i = icmp slt i64 %.1055.i, 0
  %.1072.i = select i1 %.1071.i, i64 %.251.i, i64 0
  %151 = getelementptr double, ptr %.267.i, i64 %.1055.i
  %.1086.i = getelementptr double, ptr %151, i64 %.1072.i
  %.1087.i = load double, ptr %.1086.i, align 8, !noalias !38
  %.1141.i = load double, ptr %.1140.i, align 8, !noalias !38
  %.1142.i = fadd double %.1087.i, %.1141.i
  store double %.1142.i, ptr %.1086.i, align 8, !noalias !38
  %exitcond2420.not.i = icmp eq i64 %.766.i, %arg.shape.1
  br i1 %exitcond2420.not.i, label %B468.i, label %B226.if.i

B468.i:                                           ; preds = %B396.i
  %.199.i.i = add i64 %.664.i, 1
  br label %B36.if.i.i

B34.loopexit.i.i:                                 ; preds = %B790.i.i, %B528.i.i
  %exitcond.not.i.i = icmp eq i64 %.131.i.i, %arg.shape.1
  br i1 %exitcond.not.i.i, label %B1356, label %B36.if.i.i

B348.i.i:                                         ; preds = %B234.if.i.i, %B36.if.i.i
  %p.2.1.lcssa.i.i = phi i64 [ %.59.0509.i.i, %B36.if.i.i ], [ %p.3.2.i.i, %B234.if.i.i ]
  %152 = getelementptr i64, ptr %.437.i, i64 %.59.0509.i.i
  store i64 %p.2.1.lcssa.i.i, ptr %152, align 8, !noalias !39
  %.547.i.i = add nsw i64 %p.2.1.lcssa.i.i, %.161.i.i
  %.561.i.i = icmp slt i64 %.547.i.i, 0
  %.562.i.i = select i1 %.561.i.i, i64 %.251.i, i64 0
  %153 = getelementptr double, ptr %.267.i, i64 %.547.i.i
  %.576.i.i = getelementptr double, ptr %153, i64 %.562.i.i
  %.577.i.i = load double, ptr %.576.i.i, align 8, !noalias !39
  %.610.i.i = load double, ptr %155, align 8, !noalias !39
  store double %.577.i.i, ptr %155, align 8, !noalias !39
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
  %.11.i.i.i8816 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.165.i.i, i64 %arg.shape.1)
  %.200.i.i = add i64 %.199.i.i, %.164.i.i
  %.11.i492.i.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.200.i.i, i64 %arg.shape.1)
  %154 = getelementptr double, ptr %.267.i, i64 %.161.i.i
  %155 = getelementptr double, ptr %154, i64 %.59.0509.i.i
  %.319.i.i = sub i64 %.11.i.i.i8816, %.131.i.i
  %storemerge488.i.i = tail call i64 @llvm.smax.i64(i64 %.319.i.i, i64 0)
  %.362493.not.i.i = icmp slt i64 %.319.i.i, 1
  br i1 %.362493.not.i.i, label %B348.i.i, label %B234.if.preheader.i.i

B234.if.preheader.i.i:                            ; preds = %B36.if.i.i
  %.271.i.i = load double, ptr %155, align 8, !noalias !39
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
  %156 = getelementptr double, ptr %.267.i, i64 %.415.i.i
  %.444.i.i = getelementptr double, ptr %156, i64 %.430.i.i
  %.445.i.i = load double, ptr %.444.i.i, align 8, !noalias !39
  %.446.i.i = tail call double @llvm.fabs.f64(double %.445.i.i)
  %.448.i.i = fcmp ogt double %.446.i.i, %largest.2.1496.i.i
  %largest.3.2.i.i = select i1 %.448.i.i, double %.446.i.i, double %largest.2.1496.i.i
  %p.3.2.i.i = select i1 %.448.i.i, i64 %.306.0494.i.i, i64 %p.2.1497.i.i
  %.362.i2370.i = icmp sgt i64 %.309.0495.i.i, 1
  br i1 %.362.i2370.i, label %B234.if.i.i, label %B348.i.i

B466.if.i.i:                                      ; preds = %B348.i.i, %B466.if.i.i
  %.706.0500.i.i = phi i64 [ %.768.i2371.i, %B466.if.i.i ], [ %storemerge488.i.i, %B348.i.i ]
  %.703.0499.i.i = phi i64 [ %.772.i.i, %B466.if.i.i ], [ %.131.i.i, %B348.i.i ]
  %.768.i2371.i = add nsw i64 %.706.0500.i.i, -1
  %.772.i.i = add i64 %.703.0499.i.i, 1
  %.798.i.i = add nsw i64 %.703.0499.i.i, %.161.i.i
  %.812.i.i = icmp slt i64 %.798.i.i, 0
  %.813.i.i = select i1 %.812.i.i, i64 %.251.i, i64 0
  %157 = getelementptr double, ptr %.267.i, i64 %.798.i.i
  %.827.i2372.i = getelementptr double, ptr %157, i64 %.813.i.i
  %.828.i.i = load double, ptr %.827.i2372.i, align 8, !noalias !39
  %.861.i.i = load double, ptr %155, align 8, !noalias !39
  %.865.i.i = fdiv double %.828.i.i, %.861.i.i
  store double %.865.i.i, ptr %.827.i2372.i, align 8, !noalias !39
  %.759.i2373.i = icmp sgt i64 %.706.0500.i.i, 1
  br i1 %.759.i2373.i, label %B466.if.i.i, label %B528.i.i

B566.if.i.i:                                      ; preds = %B528.i.i, %B790.i.i
  %.932.0506.i.i = phi i64 [ %.994.i.i, %B790.i.i ], [ %.942.i.i, %B528.i.i ]
  %.929.0505.i.i = phi i64 [ %.998.i.i, %B790.i.i ], [ %.131.i.i, %B528.i.i ]
  %.994.i.i = add nsw i64 %.932.0506.i.i, -1
  %.998.i.i = add i64 %.929.0505.i.i, 1
  %158 = mul nsw i64 %.929.0505.i.i, %arg.shape.1
  %.1030.i2374.i = add nsw i64 %158, %p.2.1.lcssa.i.i
  %.1044.i.i = icmp slt i64 %.1030.i2374.i, 0
  %.1045.i.i = select i1 %.1044.i.i, i64 %.251.i, i64 0
  %159 = getelementptr double, ptr %.267.i, i64 %.1030.i2374.i
  %.1059.i.i = getelementptr double, ptr %159, i64 %.1045.i.i
  %.1060.i.i = load double, ptr %.1059.i.i, align 8, !noalias !39
  %.1068.i.i = add nsw i64 %158, %.59.0509.i.i
  %.1082.i.i = icmp slt i64 %.1068.i.i, 0
  %.1083.i.i = select i1 %.1082.i.i, i64 %.251.i, i64 0
  %160 = getelementptr double, ptr %.267.i, i64 %.1068.i.i
  %.1097.i.i = getelementptr double, ptr %160, i64 %.1083.i.i
  %.1098.i.i = load double, ptr %.1097.i.i, align 8, !noalias !39
  store double %.1098.i.i, ptr %.1059.i.i, align 8, !noalias !39
  store double %.1060.i.i, ptr %.1097.i.i, align 8, !noalias !39
  %.1171.i2375.i = fcmp oeq double %.1060.i.i, 0.000000e+00
  %brmerge.i.i = or i1 %.362493.not.i.i, %.1171.i2375.i
  br i1 %brmerge.i.i, label %B790.i.i, label %B716.if.i.i

B716.if.i.i:                                      ; preds = %B566.if.i.i, %B716.if.i.i
  %.1202.0503.i.i = phi i64 [ %.1264.i2376.i, %B716.if.i.i ], [ %storemerge488.i.i, %B566.if.i.i ]
  %.1199.0502.i.i = phi i64 [ %.1268.i.i, %B716.if.i.i ], [ %.131.i.i, %B566.if.i.i ]
  %.1264.i2376.i = add nsw i64 %.1202.0503.i.i, -1
  %.1268.i.i = add i64 %.1199.0502.i.i, 1
  %.1296.i.i = add nsw i64 %.1199.0502.i.i, %158
  %.1310.i.i = icmp slt i64 %.1296.i.i, 0
  %.1311.i2377.i = select i1 %.1310.i.i, i64 %.251.i, i64 0
  %161 = getelementptr double, ptr %.267.i, i64 %.1296.i.i
  %.1325.i.i = getelementptr double, ptr %161, i64 %.1311.i2377.i
  %.1326.i.i = load double, ptr %.1325.i.i, align 8, !noalias !39
  %.1328.i.i = add nsw i64 %.1199.0502.i.i, %.161.i.i
  %.1342.i.i = icmp slt i64 %.1328.i.i, 0
  %.1343.i.i = select i1 %.1342.i.i, i64 %.251.i, i64 0
  %162 = getelementptr double, ptr %.267.i, i64 %.1328.i.i
  %.1357.i.i = getelementptr double, ptr %162, i64 %.1343.i.i
  %.1358.i.i = load double, ptr %.1357.i.i, align 8, !noalias !39
  %.1360.i.i = fmul double %.1060.i.i, %.1358.i.i
  %.1361.i.i = fsub double %.1326.i.i, %.1360.i.i
  store double %.1361.i.i, ptr %.1325.i.i, align 8, !noalias !39
  %.1255.i.i = icmp sgt i64 %.1202.0503.i.i, 1
  br i1 %.1255.i.i, label %B716.if.i.i, label %B790.i.i

B0.else.endif.if.i:                               ; preds = %B1316
  br label %B0.else.endif.endif.endif.if.i

B0.else.endif.endif.endif.if.i:                   ; preds = %B0.else.endif.if.i, %B1316
  %.154.sroa.0.3.i = phi i64 [ %arg.linear.0.5.0, %B0.else.endif.if.i ], [ %.127.i, %B1316 ]
  %.242.i8812 = sub i64 %arg.linear.0.5.0, %.154.sroa.0.3.i
  %.251.i = tail call i64 @llvm.smax.i64(i64 %.242.i8812, i64 0)
  %.267.i = getelementptr double, ptr %arg.linear.0.4, i64 %.154.sroa.0.3.i
  br i1 %.344.i, label %B0.endif.else.endif.if.i, label %B0.endif.else.endif.endif.i, !prof !32

B0.endif.else.endif.if.i:                         ; preds = %B0.else.endif.endif.endif.if.i
  br label %B0.endif.else.endif.endif.i

B0.endif.else.endif.endif.i:                      ; preds = %B0.endif.else.endif.if.i, %B0.else.endif.endif.endif.if.i
  %.324.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.if.i ], [ 5, %B0.else.endif.endif.endif.if.i ]
  %.437.i = getelementptr i64, ptr %arg.linear.1.4, i64 %.324.sroa.0.3.i
  %.525.i = load double, ptr %.524.i, align 8, !noalias !38
  %.526.i = fcmp olt double %.525.i, 5.000000e-01
  br i1 %.526.i, label %B124.i, label %B164.i

B226.if.i:                                        ; preds = %B396.i, %B226.if.lr.ph.i
  %.697.02414.i = phi i64 [ 0, %B226.if.lr.ph.i ], [ %.766.i, %B396.i ]
  %.766.i = add nsw i64 %.697.02414.i, 1
  %.798.i8813 = sub i64 %.697.02414.i, %150
  %.11.i.i8814 = tail call i64 @llvm.smax.i64(i64 %.798.i8813, i64 0)
  %.830.i = add i64 %.829.i, %.697.02414.i
  %.11.i2378.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.830.i, i64 %arg.shape.1)
  %.896.i = sub i64 %.11.i2378.i, %.11.i.i8814
  %.9392410.not.i = icmp slt i64 %.896.i, 1
  br i1 %.9392410.not.i, label %B396.i, label %B342.if.lr.ph.i

B342.if.lr.ph.i:                                  ; preds = %B226.if.i
  %.979.i8815 = mul nsw i64 %.697.02414.i, %arg.shape.1
  br label %B342.if.i

B342.if.i:                                        ; preds = %B342.if.i, %B342.if.lr.ph.i
  %.886.02412.i = phi i64 [ %.896.i, %B342.if.lr.ph.i ], [ %.948.i, %B342.if.i ]
  %.883.02411.i = phi i64 [ %.11.i.i8814, %B342.if.lr.ph.i ], [ %.952.i, %B342.if.i ]
  %.948.i = add nsw i64 %.886.02412.i, -1
  %.952.i = add i64 %.883.02411.i, 1
  %.980.i = add nsw i64 %.883.02411.i, %.979.i8815
  %.994.i = icmp slt i64 %.980.i, 0
  %.995.i = select i1 %.994.i, i64 %arg.linear.0.5.0, i64 0
  %163 = getelementptr double, ptr %arg.linear.0.4, i64 %.980.i
  %.1009.i = getelementptr double, ptr %163, i64 %.995.i
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !38
  %.1011.i = fneg double %.1010.i
  %.1030.i = select i1 %.994.i, i64 %.251.i, i64 0
  %164 = getelementptr double, ptr %.267.i, i64 %.980.i
  %.1044.i = getelementptr double, ptr %164, i64 %.1030.i
  store double %.1011.i, ptr %.1044.i, align 8, !noalias !38
  %.939.i = icmp sgt i64 %.886.02412.i, 1
  br i1 %.939.i, label %B342.if.i, label %B396.i

B1356:                                            ; preds = %B34.loopexit.i.i, %B164.i, %B1312
  br i1 %.20289153.not, label %B1614, label %B1388.if

B1576:                                            ; preds = %B1388.if
  br i1 %.88.not.i, label %B0.else.endif.endif.endif.if.i8825, label %B0.else.endif.if.i8824, !prof !25

B322.i:                                           ; preds = %B192.if.i
  %.853.i = load i64, ptr %arg.linear.1.4, align 8, !noalias !42
  %.883.i = load i64, ptr %.882.i, align 8, !noalias !42
  %.339.i.i = add i64 %.853.i, 1
  br label %B34.if.i.i8831

B34.i.loopexit.i:                                 ; preds = %B198.if.i.i, %B34.if.i.i8831
  %exitcond766.not.i = icmp eq i64 %arg.shape.1, %.144.i.i
  br i1 %exitcond766.not.i, label %B314.if.i.lr.ph.i, label %B34.if.i.i8831

B314.if.i.lr.ph.i:                                ; preds = %B34.i.loopexit.i
  %165 = add i64 %.883.i, %.853.i
  br label %B314.if.i.i

B314.i.loopexit.i:                                ; preds = %B474.if.i.i, %B314.if.i.i
  %.683.i.i = icmp sgt i64 %.627.i.0762.in.i, 1
  br i1 %.683.i.i, label %B314.if.i.i, label %B434.if.lr.ph.i

B434.if.lr.ph.i:                                  ; preds = %B314.i.loopexit.i
  %.1110.i = mul nsw i64 %.2041, %arg.shape.1
  br label %B434.if.i

B34.if.i.i8831:                                   ; preds = %B34.i.loopexit.i, %B322.i
  %.73.i.0754.i = phi i64 [ 0, %B322.i ], [ %.144.i.i, %B34.i.loopexit.i ]
  %.144.i.i = add nsw i64 %.73.i.0754.i, 1
  %166 = getelementptr i64, ptr %.358.i, i64 %.73.i.0754.i
  %.202.i.i = load i64, ptr %166, align 8, !noalias !45
  %.204.i.i = add nsw i64 %.202.i.i, %.887.i
  %.218.i.i = icmp slt i64 %.204.i.i, 0
  %.219.i.i = select i1 %.218.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %167 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.204.i.i
  %.233.i.i = getelementptr double, ptr %167, i64 %.219.i.i
  %.234.i.i8832 = load double, ptr %.233.i.i, align 8, !noalias !45
  %gep9152 = getelementptr double, ptr %invariant.gep9151, i64 %.73.i.0754.i
  %.270.i.i = load double, ptr %gep9152, align 8, !noalias !45
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !45
  store double %.234.i.i8832, ptr %gep9152, align 8, !noalias !45
  %.340.i.i = add i64 %.339.i.i, %.73.i.0754.i
  %.11.i.i.i8833 = tail call i64 @llvm.smin.i64(i64 %.340.i.i, i64 %arg.shape.1)
  %.406.i.i = sub i64 %.11.i.i.i8833, %.144.i.i
  %.449.i750.not.i = icmp slt i64 %.406.i.i, 1
  br i1 %.449.i750.not.i, label %B34.i.loopexit.i, label %B198.if.i.lr.ph.i

B198.if.i.lr.ph.i:                                ; preds = %B34.if.i.i8831
  %.521.i.i = mul nsw i64 %.73.i.0754.i, %arg.shape.1
  br label %B198.if.i.i

B198.if.i.i:                                      ; preds = %B198.if.i.i, %B198.if.i.lr.ph.i
  %.396.i.0752.i = phi i64 [ %.406.i.i, %B198.if.i.lr.ph.i ], [ %.458.i.i, %B198.if.i.i ]
  %.393.i.0751.i = phi i64 [ %.144.i.i, %B198.if.i.lr.ph.i ], [ %.462.i.i, %B198.if.i.i ]
  %.458.i.i = add nsw i64 %.396.i.0752.i, -1
  %.462.i.i = add i64 %.393.i.0751.i, 1
  %.488.i.i = add nsw i64 %.393.i.0751.i, %.887.i
  %.502.i.i8834 = icmp slt i64 %.488.i.i, 0
  %.503.i.i = select i1 %.502.i.i8834, i64 %arg.batch.5.0.5.0, i64 0
  %168 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.488.i.i
  %.517.i.i = getelementptr double, ptr %168, i64 %.503.i.i
  %.518.i.i = load double, ptr %.517.i.i, align 8, !noalias !45
  %.522.i.i = add nsw i64 %.393.i.0751.i, %.521.i.i
  %.536.i.i = icmp slt i64 %.522.i.i, 0
  %.537.i.i = select i1 %.536.i.i, i64 %.165.i, i64 0
  %169 = getelementptr double, ptr %.181.i, i64 %.522.i.i
  %.551.i.i = getelementptr double, ptr %169, i64 %.537.i.i
  %.552.i.i = load double, ptr %.551.i.i, align 8, !noalias !45
  %.554.i.i = fmul double %.234.i.i8832, %.552.i.i
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
  %170 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.726.i.i
  %.755.i.i = getelementptr double, ptr %170, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i, align 8, !noalias !45
  %.759.i.i8835 = mul nsw i64 %.627.i.0762.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i8835, %.627.i.0762.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %.165.i, i64 0
  %171 = getelementptr double, ptr %.181.i, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %171, i64 %.776.i.i
  %.791.i.i = load double, ptr %.790.i.i, align 8, !noalias !45
  %.795.i.i = fdiv double %.756.i.i, %.791.i.i
  store double %.795.i.i, ptr %.755.i.i, align 8, !noalias !45
  %.866.i.i = sub i64 %.627.i.0762.i, %165
  %.11.i4.i.i = tail call i64 @llvm.smax.i64(i64 %.866.i.i, i64 0)
  %.932.i.i = sub i64 %.627.i.0762.i, %.11.i4.i.i
  %.975.i756.not.i = icmp slt i64 %.932.i.i, 1
  br i1 %.975.i756.not.i, label %B314.i.loopexit.i, label %B474.if.i.i

B474.if.i.i:                                      ; preds = %B314.if.i.i, %B474.if.i.i
  %.922.i.0758.i = phi i64 [ %.984.i.i, %B474.if.i.i ], [ %.932.i.i, %B314.if.i.i ]
  %.919.i.0757.i = phi i64 [ %.988.i.i, %B474.if.i.i ], [ %.11.i4.i.i, %B314.if.i.i ]
  %.984.i.i = add nsw i64 %.922.i.0758.i, -1
  %.988.i.i = add i64 %.919.i.0757.i, 1
  %.1014.i.i8836 = add nsw i64 %.919.i.0757.i, %.887.i
  %.1028.i.i = icmp slt i64 %.1014.i.i8836, 0
  %.1029.i.i = select i1 %.1028.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %172 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1014.i.i8836
  %.1043.i.i = getelementptr double, ptr %172, i64 %.1029.i.i
  %.1044.i.i8837 = load double, ptr %.1043.i.i, align 8, !noalias !45
  %.1048.i.i = add nsw i64 %.919.i.0757.i, %.759.i.i8835
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %.165.i, i64 0
  %173 = getelementptr double, ptr %.181.i, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %173, i64 %.1063.i.i
  %.1078.i.i = load double, ptr %.1077.i.i, align 8, !noalias !45
  %.1080.i.i = fmul double %.795.i.i, %.1078.i.i
  %.1081.i.i = fsub double %.1044.i.i8837, %.1080.i.i
  store double %.1081.i.i, ptr %.1043.i.i, align 8, !noalias !45
  %.975.i.i = icmp sgt i64 %.922.i.0758.i, 1
  br i1 %.975.i.i, label %B474.if.i.i, label %B314.i.loopexit.i

B0.else.endif.if.i8824:                           ; preds = %B1576
  br label %B0.else.endif.endif.endif.if.i8825

B0.else.endif.endif.endif.if.i8825:               ; preds = %B0.else.endif.if.i8824, %B1576
  %.68.sroa.0.3.i = phi i64 [ %arg.linear.0.5.0, %B0.else.endif.if.i8824 ], [ %.42.i, %B1576 ]
  %.156.i = sub i64 %arg.linear.0.5.0, %.68.sroa.0.3.i
  %.165.i = tail call i64 @llvm.smax.i64(i64 %.156.i, i64 0)
  %.181.i = getelementptr double, ptr %arg.linear.0.4, i64 %.68.sroa.0.3.i
  br i1 %.265.i, label %B0.endif.else.endif.if.i8839, label %B0.endif.else.endif.endif.i8826, !prof !32

B0.endif.else.endif.if.i8839:                     ; preds = %B0.else.endif.endif.endif.if.i8825
  br label %B0.endif.else.endif.endif.i8826

B0.endif.else.endif.endif.i8826:                  ; preds = %B0.endif.else.endif.if.i8839, %B0.else.endif.endif.endif.if.i8825
  %.245.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.if.i8839 ], [ 5, %B0.else.endif.endif.endif.if.i8825 ]
  %.358.i = getelementptr i64, ptr %arg.linear.1.4, i64 %.245.sroa.0.3.i
  br i1 %.277.i, label %B0.endif.endif.else.if.i, label %B0.endif.endif.else.endif.i, !prof !32

B192.if.lr.ph.i:                                  ; preds = %B0.endif.endif.else.endif.endif.endif.i
  %.689.i = mul nsw i64 %.2041, %arg.shape.1
  br label %B192.if.i

B0.endif.endif.else.if.i:                         ; preds = %B0.endif.else.endif.endif.i8826
  br label %B0.endif.endif.else.endif.i

B0.endif.endif.else.endif.i:                      ; preds = %B0.endif.endif.else.if.i, %B0.endif.else.endif.endif.i8826
  %.418.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.else.if.i ], [ %.274.i, %B0.endif.else.endif.endif.i8826 ]
  br i1 %.282.not.i, label %B0.endif.endif.else.endif.endif.endif.i, label %B0.endif.endif.else.endif.if.i, !prof !25

B0.endif.endif.else.endif.if.i:                   ; preds = %B0.endif.endif.else.endif.i
  br label %B0.endif.endif.else.endif.endif.endif.i

B0.endif.endif.else.endif.endif.endif.i:          ; preds = %B0.endif.endif.else.endif.if.i, %B0.endif.endif.else.endif.i
  %.418.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.if.i ], [ %.418.sroa.0.1.i, %B0.endif.endif.else.endif.i ]
  %.531.i = getelementptr i64, ptr %arg.linear.1.4, i64 %.418.sroa.0.3.i
  br i1 %.648747.not.i, label %B1612, label %B192.if.lr.ph.i

B192.if.i:                                        ; preds = %B192.if.i, %B192.if.lr.ph.i
  %.590.0748.i = phi i64 [ 0, %B192.if.lr.ph.i ], [ %.661.i8828, %B192.if.i ]
  %.661.i8828 = add nsw i64 %.590.0748.i, 1
  %.690.i = add nsw i64 %.590.0748.i, %.689.i
  %.704.i = icmp slt i64 %.690.i, 0
  %.705.i = select i1 %.704.i, i64 %arg.batch.5.0.5.0, i64 0
  %174 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.690.i
  %.719.i = getelementptr double, ptr %174, i64 %.705.i
  %.720.i = load double, ptr %.719.i, align 8, !noalias !42
  %gep9150 = getelementptr double, ptr %invariant.gep9149, i64 %.590.0748.i
  %.753.i = load double, ptr %gep9150, align 8, !noalias !42
  %.754.i = fadd double %.720.i, %.753.i
  %175 = getelementptr i64, ptr %.531.i, i64 %.590.0748.i
  %.786.i = load i64, ptr %175, align 8, !noalias !42
  %.787.i = add nsw i64 %.786.i, %.756.i
  %.801.i = icmp slt i64 %.787.i, 0
  %.802.i = select i1 %.801.i, i64 %arg.batch.5.0.5.0, i64 0
  %176 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.787.i
  %.816.i = getelementptr double, ptr %176, i64 %.802.i
  store double %.754.i, ptr %.816.i, align 8, !noalias !42
  %exitcond.not.i8830 = icmp eq i64 %arg.shape.1, %.661.i8828
  br i1 %exitcond.not.i8830, label %B322.i, label %B192.if.i

B434.if.i:                                        ; preds = %B434.if.i, %B434.if.lr.ph.i
  %.950.0764.i = phi i64 [ 0, %B434.if.lr.ph.i ], [ %.1019.i, %B434.if.i ]
  %.1019.i = add nsw i64 %.950.0764.i, 1
  %177 = getelementptr i64, ptr %.531.i, i64 %.950.0764.i
  %.1075.i = load i64, ptr %177, align 8, !noalias !42
  %.1076.i = add nsw i64 %.1075.i, %.887.i
  %.1090.i = icmp slt i64 %.1076.i, 0
  %.1091.i = select i1 %.1090.i, i64 %arg.batch.5.0.5.0, i64 0
  %178 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1076.i
  %.1105.i = getelementptr double, ptr %178, i64 %.1091.i
  %.1106.i = load double, ptr %.1105.i, align 8, !noalias !42
  %.1111.i = add nsw i64 %.950.0764.i, %.1110.i
  %.1125.i = icmp slt i64 %.1111.i, 0
  %.1126.i = select i1 %.1125.i, i64 %arg.batch.5.0.5.0, i64 0
  %179 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1111.i
  %.1140.i8838 = getelementptr double, ptr %179, i64 %.1126.i
  store double %.1106.i, ptr %.1140.i8838, align 8, !noalias !42
  %exitcond767.not.i = icmp eq i64 %arg.shape.1, %.1019.i
  br i1 %exitcond767.not.i, label %B1612, label %B434.if.i

B1612:                                            ; preds = %B434.if.i, %B0.endif.endif.else.endif.endif.endif.i, %B1388.if
  %exitcond9278.not = icmp eq i64 %.1972.09154, %storemerge8726
  br i1 %exitcond9278.not, label %B1614, label %B1388.if

B1614:                                            ; preds = %B1612, %B1356
  %.2305 = load i64, ptr %.2304, align 8
  %.2350 = inttoptr i64 %.2305 to ptr
  tail call void %.2350(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %brmerge8789 = select i1 %.986, i1 true, i1 %.544
  %or.cond8790 = select i1 %brmerge8789, i1 true, i1 %.2386
  %spec.select8805 = select i1 %or.cond8790, i1 true, i1 %.2391
  br i1 %.606, label %B1848, label %B1758.if

B1766:                                            ; preds = %B1758.if
  %180 = getelementptr double, ptr %31, i64 %.2431.09157
  %.2590 = load double, ptr %180, align 8
  %.2591 = fcmp ogt double %.2590, 5.000000e-01
  br label %B1802

B1802:                                            ; preds = %B1766, %B1758.if
  %"$phi1802.1.2.2" = phi i1 [ true, %B1758.if ], [ %.2591, %B1766 ]
  br i1 %looked.4.29160, label %B1844, label %B1808

B1808:                                            ; preds = %B1802
  %181 = getelementptr double, ptr %32, i64 %.2431.09157
  %.2665 = load double, ptr %181, align 8
  %.2666 = fcmp ogt double %.2665, 5.000000e-01
  br label %B1844

B1844:                                            ; preds = %B1808, %B1802
  %"$phi1844.1.2.2" = phi i1 [ true, %B1802 ], [ %.2666, %B1808 ]
  %.2487 = icmp sgt i64 %.2434.09158, 1
  br i1 %.2487, label %B1758.if, label %B1848

B1848:                                            ; preds = %B1844, %B1614
  %good.2.1.lcssa = phi i1 [ false, %B1614 ], [ %"$phi1802.1.2.2", %B1844 ]
  %looked.4.2.lcssa = phi i1 [ %spec.select8805, %B1614 ], [ %"$phi1844.1.2.2", %B1844 ]
  %looked.4.2.lcssa.not9284 = xor i1 %looked.4.2.lcssa, true
  %brmerge9285 = or i1 %.606, %looked.4.2.lcssa.not9284
  br i1 %brmerge9285, label %B2484, label %B80.if.i

B1918.preheader:                                  ; preds = %B502.i
  br i1 %.606, label %B2484, label %B1920.if

B126.i:                                           ; preds = %B80.if.i
  %.318.i525 = getelementptr double, ptr %33, i64 %.105.i362.09164
  %.319.i526 = load double, ptr %.318.i525, align 8, !noalias !49
  %.5.i.i = fptosi double %.319.i526 to i64
  %.397.i572 = getelementptr double, ptr %34, i64 %.105.i362.09164
  %.398.i573 = load double, ptr %.397.i572, align 8, !noalias !49
  %.5.i1.i = fptosi double %.398.i573 to i64
  %.472.i612 = mul i64 %.258.i477, %arg.batch.3.3.5.1
  %.476.i616 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.472.i612
  %.477.i = load i64, ptr %.476.i616, align 8, !noalias !49
  %.478.i617 = add nsw i64 %.477.i, %.5.i.i
  store i64 %.478.i617, ptr %.476.i616, align 8, !noalias !49
  %.584.i = getelementptr i8, ptr %.476.i616, i64 24
  %.585.i699 = load i64, ptr %.584.i, align 8, !noalias !49
  %.586.i700 = add nsw i64 %.585.i699, %.5.i1.i
  store i64 %.586.i700, ptr %.584.i, align 8, !noalias !49
  %.694.i781 = getelementptr i8, ptr %.476.i616, i64 8
  %.695.i = load i64, ptr %.694.i781, align 8, !noalias !49
  %.698.i783 = add nsw i64 %.5.i1.i, %.5.i.i
  %.699.i = mul nsw i64 %.698.i783, %.1985
  %.700.i = add nsw i64 %.699.i, %.5.i.i
  %.701.i = add nsw i64 %.700.i, %.695.i
  store i64 %.701.i, ptr %.694.i781, align 8, !noalias !49
  store double 0.000000e+00, ptr %.318.i525, align 8, !noalias !49
  store double 0.000000e+00, ptr %.397.i572, align 8, !noalias !49
  %.923.i = getelementptr double, ptr %35, i64 %.105.i362.09164
  %.924.i919 = load double, ptr %.923.i, align 8, !noalias !49
  %.926.i = sitofp i64 %.698.i783 to double
  %.927.i = fsub double %.924.i919, %.926.i
  store double %.927.i, ptr %.923.i, align 8, !noalias !49
  br label %B502.i

B502.i:                                           ; preds = %B126.i, %B80.if.i
  %.163.i425 = icmp sgt i64 %.108.i363.09165, 1
  br i1 %.163.i425, label %B80.if.i, label %B1918.preheader

B80.if.i:                                         ; preds = %B1848, %B502.i
  %.108.i363.09165 = phi i64 [ %.172.i, %B502.i ], [ %storemerge, %B1848 ]
  %.105.i362.09164 = phi i64 [ %.176.i951, %B502.i ], [ 0, %B1848 ]
  %.172.i = add nsw i64 %.108.i363.09165, -1
  %.176.i951 = add nsw i64 %.105.i362.09164, 1
  %182 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i362.09164
  %.258.i477 = load i64, ptr %182, align 8, !noalias !49
  %.263.i479 = icmp sgt i64 %.258.i477, -1
  br i1 %.263.i479, label %B126.i, label %B502.i

B2020:                                            ; preds = %B1920.if
  %.3138 = getelementptr double, ptr %38, i64 %.2798.09167
  %.3139 = load double, ptr %.3138, align 8
  %.3140 = fcmp ogt double %.3139, 5.000000e-01
  br i1 %.3140, label %B2058, label %B2158

B2058:                                            ; preds = %B2020
  %.5.i = fptosi double %.3139 to i64
  %183 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2798.09167
  %.84.i1811 = load i64, ptr %183, align 8, !noalias !53
  %.89.i1814 = icmp sgt i64 %.84.i1811, -1
  br i1 %.89.i1814, label %B46.i, label %B2158

B2158:                                            ; preds = %B2020, %B46.i, %B2058, %B80.i1848
  %.3333 = getelementptr double, ptr %39, i64 %.2798.09167
  %.3334 = load double, ptr %.3333, align 8
  %.3335 = fcmp ogt double %.3334, 5.000000e-01
  br i1 %.3335, label %B2196, label %B2480

B2196:                                            ; preds = %B2158
  %spec.select = select i1 %within.3.29170, i1 true, i1 %.2386
  %.3413 = mul i64 %.2965, %arg.batch.3.3.5.1
  %.3417 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.3413
  %.3418 = load i64, ptr %.3417, align 8
  %.3429.0 = and i64 %.3418, 127
  %.3459 = icmp eq i64 %.3429.0, 0
  br i1 %.3459, label %B2304, label %B2266

B2266:                                            ; preds = %B2196
  %.3520 = getelementptr double, ptr %40, i64 %.2798.09167
  %.3521 = load double, ptr %.3520, align 8
  %.3523 = fcmp ogt double %.3521, 0.000000e+00
  br i1 %.3523, label %B2304, label %B2334

B2304:                                            ; preds = %B2196, %B2266
  store double 1.000000e+00, ptr %.3080, align 8
  br label %B2334

B2334:                                            ; preds = %B2304, %B2266
  %doubted.5.5 = phi i1 [ true, %B2304 ], [ %doubted.3.29171, %B2266 ]
  %.3609 = icmp slt i64 %.3020, %arg.batch.2.5.0
  br i1 %.3609, label %B2372, label %B2480

B2372:                                            ; preds = %B2334
  %.3636 = icmp slt i64 %.3020, 0
  %.3637 = select i1 %.3636, i64 %arg.batch.2.5.0, i64 0
  %184 = getelementptr double, ptr %arg.batch.2.4, i64 %.3020
  %.3651 = getelementptr double, ptr %184, i64 %.3637
  %.3652 = load double, ptr %.3651, align 8
  %.3706 = getelementptr double, ptr %41, i64 %.2798.09167
  %.3707 = load double, ptr %.3706, align 8
  %.3708 = fcmp ugt double %.3652, %.3707
  br i1 %.3708, label %B2480, label %B2422

B2422:                                            ; preds = %B2372
  %.3817 = fcmp olt double %.3652, %.3707
  %spec.select8791 = or i1 %spec.select, %.3817
  br label %B2480

B2480:                                            ; preds = %B1920.if, %B2422, %B2372, %B2334, %B2158
  %wanted.4.3 = phi i1 [ true, %B2422 ], [ %wanted.3.29169, %B2372 ], [ %wanted.3.29169, %B2334 ], [ %wanted.3.29169, %B2158 ], [ %wanted.3.29169, %B1920.if ]
  %within.4.3 = phi i1 [ %spec.select8791, %B2422 ], [ %spec.select, %B2372 ], [ %spec.select, %B2334 ], [ %within.3.29170, %B2158 ], [ %within.3.29170, %B1920.if ]
  %doubted.4.3 = phi i1 [ %doubted.5.5, %B2422 ], [ %doubted.5.5, %B2372 ], [ %doubted.5.5, %B2334 ], [ %doubted.3.29171, %B2158 ], [ %doubted.3.29171, %B1920.if ]
  %.2864 = icmp sgt i64 %.2801.09168, 1
  br i1 %.2864, label %B1920.if, label %B2484.loopexit

B2484.loopexit:                                   ; preds = %B2480
  %185 = xor i1 %doubted.4.3, true
  %186 = select i1 %185, i1 true, i1 %.548
  %187 = select i1 %wanted.4.3, i1 true, i1 %within.4.3
  br label %B2484

B2484:                                            ; preds = %B1848, %B2484.loopexit, %B1918.preheader
  %wanted.2.1 = phi i1 [ false, %B1848 ], [ false, %B1918.preheader ], [ %187, %B2484.loopexit ]
  %within.5.1 = phi i1 [ false, %B1848 ], [ false, %B1918.preheader ], [ %within.4.3, %B2484.loopexit ]
  %doubted.2.1 = phi i1 [ true, %B1848 ], [ true, %B1918.preheader ], [ %186, %B2484.loopexit ]
  %brmerge8792.not = select i1 %good.2.1.lcssa, i1 %.546.not, i1 false
  br i1 %brmerge8792.not, label %B2492, label %B2608

B2492:                                            ; preds = %B2484
  %.3916 = load i64, ptr %arg.code.4, align 8
  %.3966 = inttoptr i64 %.3916 to ptr
  tail call void %.3966(ptr %.505, ptr %.3940, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.3965)
  br label %B2608

B2608:                                            ; preds = %B2484, %B2492
  br i1 %doubted.2.1, label %B2684, label %B2616

B2616:                                            ; preds = %B2608
  %.4004 = load i64, ptr %.4003, align 8
  %.4049 = inttoptr i64 %.4004 to ptr
  tail call void %.4049(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B2684

B2684:                                            ; preds = %B2608, %B2616
  %188 = select i1 %.2391, i1 %good.2.1.lcssa, i1 false
  br i1 %188, label %B2704, label %B2826

B2704:                                            ; preds = %B2684
  %.4100 = load i64, ptr %.4099, align 8
  %.4147 = inttoptr i64 %.4100 to ptr
  tail call void %.4147(ptr %.505, ptr %.4121, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.606, label %B2826, label %B38.if.i

B104.i:                                           ; preds = %B38.if.i
  %.349.i2128 = getelementptr double, ptr %43, i64 %.78.i1918.09176
  %.350.i2129 = load double, ptr %.349.i2128, align 8, !noalias !56
  %.351.i2130 = fcmp ogt double %.350.i2129, 5.000000e-01
  br i1 %.351.i2130, label %B34.i.i, label %B304.i

B34.i.i:                                          ; preds = %B104.i, %B36.i.i
  %.48.i.i1878.0 = phi i64 [ %.119.i.i2436, %B36.i.i ], [ 0, %B104.i ]
  %exitcond9279.not = icmp eq i64 %.48.i.i1878.0, %arg.shape.6
  br i1 %exitcond9279.not, label %B142.endif.i, label %B36.i.i

B36.i.i:                                          ; preds = %B34.i.i
  %.119.i.i2436 = add i64 %.48.i.i1878.0, 1
  %.149.i.i2403 = add nsw i64 %.48.i.i1878.0, %arg.shape.6
  %.151.i.i2405 = mul nsw i64 %.149.i.i2403, %arg.shape.0
  %.153.i.i2407 = add nsw i64 %.151.i.i2405, %.78.i1918.09176
  %.167.i.i = icmp slt i64 %.153.i.i2407, 0
  %.168.i.i2415 = select i1 %.167.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %189 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i.i2407
  %.182.i.i = getelementptr double, ptr %189, i64 %.168.i.i2415
  %.183.i.i = load double, ptr %.182.i.i, align 8, !noalias !60
  %.184.i.i = fcmp ogt double %.183.i.i, 5.000000e-01
  br i1 %.184.i.i, label %B142.endif.i, label %B34.i.i

B190.i2207:                                       ; preds = %B142.endif.i
  store double 1.000000e+00, ptr %.234.i2032, align 8, !noalias !56
  %.503.i2296 = getelementptr double, ptr %44, i64 %.78.i1918.09176
  store double 0.000000e+00, ptr %.503.i2296, align 8, !noalias !56
  %.558.i2343 = getelementptr double, ptr %45, i64 %.78.i1918.09176
  store double 1.000000e+00, ptr %.558.i2343, align 8, !noalias !56
  %.616.i2391 = getelementptr i64, ptr %46, i64 %.78.i1918.09176
  store i64 %.363.i1928.0, ptr %.616.i2391, align 8, !noalias !56
  br label %B304.i

B304.i:                                           ; preds = %B142.endif.i, %B190.i2207, %B104.i, %B38.if.i
  %some.3.i.1 = phi i1 [ true, %B190.i2207 ], [ %some.2.i.09178, %B142.endif.i ], [ %some.2.i.09178, %B104.i ], [ %some.2.i.09178, %B38.if.i ]
  %.136.i1973 = icmp sgt i64 %.81.i1919.09177, 1
  br i1 %.136.i1973, label %B38.if.i, label %B2826

B38.if.i:                                         ; preds = %B2704, %B304.i
  %some.2.i.09178 = phi i1 [ %some.3.i.1, %B304.i ], [ false, %B2704 ]
  %.81.i1919.09177 = phi i64 [ %.145.i2446, %B304.i ], [ %storemerge, %B2704 ]
  %.78.i1918.09176 = phi i64 [ %.149.i2449, %B304.i ], [ 0, %B2704 ]
  %.145.i2446 = add nsw i64 %.81.i1919.09177, -1
  %.149.i2449 = add nsw i64 %.78.i1918.09176, 1
  %.234.i2032 = getelementptr double, ptr %42, i64 %.78.i1918.09176
  store double 0.000000e+00, ptr %.234.i2032, align 8, !noalias !56
  %.289.i2078 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.78.i1918.09176
  %.290.i2079 = load i64, ptr %.289.i2078, align 8, !noalias !56
  %.291.i2080 = icmp sgt i64 %.290.i2079, -1
  br i1 %.291.i2080, label %B104.i, label %B304.i

B142.endif.i:                                     ; preds = %B36.i.i, %B34.i.i
  %.363.i1928.0 = phi i64 [ %.48.i.i1878.0, %B36.i.i ], [ -1, %B34.i.i ]
  %.393.i2206 = icmp sgt i64 %.363.i1928.0, -1
  br i1 %.393.i2206, label %B190.i2207, label %B304.i

B2826:                                            ; preds = %B304.i, %B2704, %B2684
  %beyond.2.1 = phi i1 [ false, %B2684 ], [ false, %B2704 ], [ %some.3.i.1, %B304.i ]
  %brmerge8796 = select i1 %within.5.1, i1 true, i1 %beyond.2.1
  br i1 %brmerge8796, label %B2836, label %B3356

B2836:                                            ; preds = %B2826
  br i1 %.548, label %B3252.critedge, label %B2884.if

B140.i:                                           ; preds = %B64.if.i3453
  %.409.i2794 = getelementptr double, ptr %48, i64 %.138.i2562.09184
  %.410.i2795 = load double, ptr %.409.i2794, align 8, !noalias !64
  %.411.i2796 = fcmp uge double %.410.i2795, 5.000000e-01
  %.424.i2804.not = icmp slt i64 %.346.i2744, %arg.batch.2.5.0
  %or.cond8797 = select i1 %.411.i2796, i1 %.424.i2804.not, i1 false
  br i1 %or.cond8797, label %B216.i, label %B479.i

B216.i:                                           ; preds = %B140.i
  %.440.i2815 = icmp slt i64 %.346.i2744, 0
  %.441.i2816 = select i1 %.440.i2815, i64 %arg.batch.2.5.0, i64 0
  %190 = getelementptr double, ptr %arg.batch.2.4, i64 %.346.i2744
  %.455.i2830 = getelementptr double, ptr %190, i64 %.441.i2816
  %.456.i2831 = load double, ptr %.455.i2830, align 8, !noalias !64
  %.510.i2877 = getelementptr double, ptr %49, i64 %.138.i2562.09184
  %.511.i2878 = load double, ptr %.510.i2877, align 8, !noalias !64
  %.512.i2879 = fcmp ult double %.456.i2831, %.511.i2878
  br i1 %.512.i2879, label %B268.i, label %B479.i

B268.i:                                           ; preds = %B216.i
  %.574.i2926 = getelementptr double, ptr %50, i64 %.138.i2562.09184
  %.575.i2927 = load double, ptr %.574.i2926, align 8, !noalias !64
  %.576.i2928 = fcmp ogt double %.575.i2927, 1.000000e+00
  br i1 %.576.i2928, label %B306.i2931, label %B479.i

B306.i2931:                                       ; preds = %B268.i
  %.632.i = getelementptr double, ptr %51, i64 %.138.i2562.09184
  %.633.i2979 = load double, ptr %.632.i, align 8, !noalias !64
  store double 0.000000e+00, ptr %.409.i2794, align 8, !noalias !68
  %.161.i.i3139 = getelementptr double, ptr %52, i64 %.138.i2562.09184
  store double 0.000000e+00, ptr %.161.i.i3139, align 8, !noalias !68
  %.214.i.i3171 = getelementptr double, ptr %53, i64 %.138.i2562.09184
  store double %.633.i2979, ptr %.214.i.i3171, align 8, !noalias !68
  %.268.i.i3193 = load i64, ptr %.290.i2695, align 8, !noalias !68
  %.294.i.i3203 = icmp slt i64 %.268.i.i3193, 0
  %.295.i.i = select i1 %.294.i.i3203, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i.i = add i64 %.295.i.i, %.268.i.i3193
  %.316.i.i3215 = mul i64 %.296.i.i, %arg.batch.3.3.5.1
  %.320.i.i3216 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i.i3215
  %.321.i.i3217 = load i64, ptr %.320.i.i3216, align 8, !noalias !68
  %.322.i.i = add nsw i64 %.321.i.i3217, -1
  store i64 %.322.i.i, ptr %.320.i.i3216, align 8, !noalias !68
  %.426.i.i3249 = load i64, ptr %.290.i2695, align 8, !noalias !68
  %.452.i.i = icmp slt i64 %.426.i.i3249, 0
  %.453.i.i = select i1 %.452.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i = add i64 %.453.i.i, %.426.i.i3249
  %.474.i.i = mul i64 %.454.i.i, %arg.batch.3.3.5.1
  %191 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i
  %.478.i.i = getelementptr i8, ptr %191, i64 24
  %.479.i.i = load i64, ptr %.478.i.i, align 8, !noalias !68
  %.480.i.i = add nsw i64 %.479.i.i, 1
  store i64 %.480.i.i, ptr %.478.i.i, align 8, !noalias !68
  %.705.i3274 = load double, ptr %.455.i2830, align 8, !noalias !64
  %.761.i3312 = getelementptr double, ptr %54, i64 %.138.i2562.09184
  store double 0.000000e+00, ptr %.761.i3312, align 8, !noalias !64
  %.818.i = getelementptr double, ptr %55, i64 %.138.i2562.09184
  store double %.705.i3274, ptr %.818.i, align 8, !noalias !64
  %.871.i3397 = mul i64 %.291.i2696, %arg.batch.3.3.5.1
  %192 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.871.i3397
  %.875.i3401 = getelementptr i8, ptr %192, i64 8
  %.876.i3402 = load i64, ptr %.875.i3401, align 8, !noalias !64
  %.877.i3403 = add nsw i64 %.876.i3402, 3
  store i64 %.877.i3403, ptr %.875.i3401, align 8, !noalias !64
  br label %B479.i

B479.i:                                           ; preds = %B268.i, %B306.i2931, %B64.if.i3453, %B140.i, %B216.i
  %.196.i = icmp sgt i64 %.141.i2563.09183, 1
  br i1 %.196.i, label %B64.if.i3453, label %B3252

B64.if.i3453:                                     ; preds = %B2884.if, %B479.i
  %.138.i2562.09184 = phi i64 [ %.209.i3461, %B479.i ], [ 0, %B2884.if ]
  %.141.i2563.09183 = phi i64 [ %.205.i3458, %B479.i ], [ %storemerge, %B2884.if ]
  %.205.i3458 = add nsw i64 %.141.i2563.09183, -1
  %.209.i3461 = add nsw i64 %.138.i2562.09184, 1
  %.290.i2695 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.138.i2562.09184
  %.291.i2696 = load i64, ptr %.290.i2695, align 8, !noalias !64
  %.345.i2743 = getelementptr i64, ptr %47, i64 %.138.i2562.09184
  %.346.i2744 = load i64, ptr %.345.i2743, align 8, !noalias !64
  %.354.i2748 = icmp slt i64 %.291.i2696, 0
  br i1 %.354.i2748, label %B479.i, label %B140.i

B3252.critedge:                                   ; preds = %B2836
  %.4603.c = load i64, ptr %.4602.c, align 8
  %.4648.c = inttoptr i64 %.4603.c to ptr
  tail call void %.4648.c(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3252

B3252:                                            ; preds = %B479.i, %B2884.if, %B3252.critedge
  br i1 %beyond.2.1, label %B144.if.i, label %B3294

B142.loopexit.i.critedge:                         ; preds = %B144.if.i
  %.696.i.c = load i64, ptr %.695.i8840, align 8, !noalias !71
  %.813.i.c = inttoptr i64 %.696.i.c to ptr
  tail call void %.813.i.c(ptr %.505, ptr %.787.i8841, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !71
  br label %B142.loopexit.i

B142.loopexit.i:                                  ; preds = %B1153.i, %B142.loopexit.i.critedge
  %.287.i = icmp ugt i64 %.231.01235.i, 1
  br i1 %.287.i, label %B144.if.i, label %B712.i

B178.loopexit.i:                                  ; preds = %B122.if.i.i, %B178.if.i
  %exitcond1240.not.i = icmp eq i64 %arg.shape.0, %.418.i8842
  br i1 %exitcond1240.not.i, label %B344.i, label %B178.if.i

B122.if.i.i:                                      ; preds = %B122.if.i.lr.ph.i, %B122.if.i.i
  %.229.i.01227.i = phi i64 [ 0, %B122.if.i.lr.ph.i ], [ %.300.i.i, %B122.if.i.i ]
  %.157.i.i.i = add nsw i64 %.229.i.01227.i, %.155.i.i.i
  %.159.i.i.i = mul nsw i64 %.157.i.i.i, %arg.shape.0
  %gep9186 = getelementptr double, ptr %invariant.gep9185, i64 %.159.i.i.i
  %.191.i.i.i = load double, ptr %gep9186, align 8, !noalias !74
  %.193.i.i.i = fadd double %.191.i.i.i, 0.000000e+00
  %.253.i.i.i = fmul double %share.3.2.i, %.193.i.i.i
  %.157.i.i.1.i = add nsw i64 %.229.i.01227.i, %.155.i.i.1.i
  %.159.i.i.1.i = mul nsw i64 %.157.i.i.1.i, %arg.shape.0
  %gep9188 = getelementptr double, ptr %invariant.gep9187, i64 %.159.i.i.1.i
  %.191.i.i.1.i = load double, ptr %gep9188, align 8, !noalias !74
  %.193.i.i.1.i = fadd double %.191.i.i.1.i, %.253.i.i.i
  %.253.i.i.1.i = fmul double %.247.i.i.i, %.193.i.i.1.i
  %.157.i.i.2.i = add nsw i64 %.229.i.01227.i, %.155.i.i.2.i
  %.159.i.i.2.i = mul nsw i64 %.157.i.i.2.i, %arg.shape.0
  %gep9190 = getelementptr double, ptr %invariant.gep9189, i64 %.159.i.i.2.i
  %.191.i.i.2.i = load double, ptr %gep9190, align 8, !noalias !74
  %.193.i.i.2.i = fadd double %.191.i.i.2.i, %.253.i.i.1.i
  %.253.i.i.2.i = fmul double %share.3.2.i, %.193.i.i.2.i
  %.157.i.i.3.i = add nsw i64 %.229.i.01227.i, %.155.i.i.3.i
  %.159.i.i.3.i = mul nsw i64 %.157.i.i.3.i, %arg.shape.0
  %gep9192 = getelementptr double, ptr %invariant.gep9191, i64 %.159.i.i.3.i
  %.191.i.i.3.i = load double, ptr %gep9192, align 8, !noalias !74
  %.193.i.i.3.i = fadd double %.191.i.i.3.i, %.253.i.i.2.i
  %.253.i.i.3.i = fmul double %.247.i.i.i, %.193.i.i.3.i
  %.157.i.i.4.i = add nsw i64 %.229.i.01227.i, %.155.i.i.4.i
  %.159.i.i.4.i = mul nsw i64 %.157.i.i.4.i, %arg.shape.0
  %gep9194 = getelementptr double, ptr %invariant.gep9193, i64 %.159.i.i.4.i
  %.191.i.i.4.i = load double, ptr %gep9194, align 8, !noalias !74
  %.193.i.i.4.i = fadd double %.191.i.i.4.i, %.253.i.i.3.i
  %.253.i.i.4.i = fmul double %share.3.2.i, %.193.i.i.4.i
  %.157.i.i.5.i = add nsw i64 %.229.i.01227.i, %.155.i.i.5.i
  %.159.i.i.5.i = mul nsw i64 %.157.i.i.5.i, %arg.shape.0
  %gep9196 = getelementptr double, ptr %invariant.gep9195, i64 %.159.i.i.5.i
  %.191.i.i.5.i = load double, ptr %gep9196, align 8, !noalias !74
  %.193.i.i.5.i = fadd double %.191.i.i.5.i, %.253.i.i.4.i
  %.253.i.i.5.i = fmul double %.247.i.i.i, %.193.i.i.5.i
  %.157.i.i.6.i = add nsw i64 %.229.i.01227.i, %.155.i.i.6.i
  %.159.i.i.6.i = mul nsw i64 %.157.i.i.6.i, %arg.shape.0
  %gep9198 = getelementptr double, ptr %invariant.gep9197, i64 %.159.i.i.6.i
  %.191.i.i.6.i = load double, ptr %gep9198, align 8, !noalias !74
  %.193.i.i.6.i = fadd double %.191.i.i.6.i, %.253.i.i.5.i
  %.253.i.i.6.i = fmul double %share.3.2.i, %.193.i.i.6.i
  %.300.i.i = add nsw i64 %.229.i.01227.i, 1
  %.271.i.i.i = mul nsw i64 %.229.i.01227.i, %arg.shape.0
  %gep9200 = getelementptr double, ptr %invariant.gep9199, i64 %.271.i.i.i
  %.309.i.i.i = load double, ptr %gep9200, align 8, !noalias !74
  %.313.i.i.i = fadd double %.309.i.i.i, %.253.i.i.6.i
  %.360.i.i = add nsw i64 %.229.i.01227.i, %.359.i.i
  %.362.i.i8844 = mul nsw i64 %.360.i.i, %arg.shape.0
  %gep9202 = getelementptr double, ptr %invariant.gep9201, i64 %.362.i.i8844
  store double %.313.i.i.i, ptr %gep9202, align 8, !noalias !81
  %exitcond.not.i8845 = icmp eq i64 %arg.shape.1, %.300.i.i
  br i1 %exitcond.not.i8845, label %B178.loopexit.i, label %B122.if.i.i

B344.i:                                           ; preds = %B178.loopexit.i
  %.696.i = load i64, ptr %.695.i8840, align 8, !noalias !71
  %.813.i = inttoptr i64 %.696.i to ptr
  tail call void %.813.i(ptr %.505, ptr %.787.i8841, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !71
  br label %B492.if.i

B544.i:                                           ; preds = %B492.if.i
  %.1046.i = getelementptr double, ptr %56, i64 %.839.01233.i
  %.1047.i = load double, ptr %.1046.i, align 8, !noalias !71
  %.1101.i = getelementptr double, ptr %57, i64 %.839.01233.i
  %.1102.i = load double, ptr %.1101.i, align 8, !noalias !71
  %.1103.i = fadd double %.1047.i, %.1102.i
  %.1104.i = fmul double %.1103.i, 5.000000e-01
  br label %B34.i.i8858

B34.i.i8858:                                      ; preds = %B34.if.i.i8859, %B544.i
  %.48.i.0.i = phi i64 [ 0, %B544.i ], [ %.119.i88.i, %B34.if.i.i8859 ]
  %exitcond1241.not.i = icmp eq i64 %.48.i.0.i, %storemerge1215.i
  br i1 %exitcond1241.not.i, label %B682.i, label %B34.if.i.i8859

B80.i.i8861:                                      ; preds = %B34.if.i.i8859
  %193 = icmp sgt i64 %.48.i.0.i, -1
  br i1 %193, label %B656.i, label %B682.i

B34.if.i.i8859:                                   ; preds = %B34.i.i8858
  %.119.i88.i = add i64 %.48.i.0.i, 1
  %.149.i53.i = add nsw i64 %.48.i.0.i, %arg.shape.6
  %.151.i55.i = mul nsw i64 %.149.i53.i, %arg.shape.0
  %.153.i56.i = add nsw i64 %.151.i55.i, %.839.01233.i
  %.167.i61.i = icmp slt i64 %.153.i56.i, 0
  %.168.i62.i = select i1 %.167.i61.i, i64 %arg.batch.5.4.5.0, i64 0
  %194 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i56.i
  %.182.i74.i = getelementptr double, ptr %194, i64 %.168.i62.i
  %.183.i75.i = load double, ptr %.182.i74.i, align 8, !noalias !82
  %.184.i.i8860 = fcmp ogt double %.183.i75.i, 5.000000e-01
  br i1 %.184.i.i8860, label %B80.i.i8861, label %B34.i.i8858

B656.i:                                           ; preds = %B80.i.i8861
  store double %.1104.i, ptr %.1101.i, align 8, !noalias !71
  br label %B1153.i

B682.i:                                           ; preds = %B34.i.i8858, %B80.i.i8861
  store double %.1104.i, ptr %.1046.i, align 8, !noalias !71
  br label %B1153.i

B712.i:                                           ; preds = %B142.loopexit.i
  br i1 %.606, label %B3294, label %B742.if.i

B844.i:                                           ; preds = %B742.if.i
  %.1634.i = getelementptr double, ptr %59, i64 %.1317.01237.i
  %.1635.i = load double, ptr %.1634.i, align 8, !noalias !71
  %.1691.i = load double, ptr %.1467.i, align 8, !noalias !71
  %.1692.i = tail call double @llvm.fabs.f64(double %.1691.i)
  %.1693.i = fmul double %.1692.i, 2.000000e-12
  %.1750.i = getelementptr double, ptr %56, i64 %.1317.01237.i
  %.1751.i = load double, ptr %.1750.i, align 8, !noalias !71
  %.1756.i = fmul double %.1635.i, 0x3D719799812DEA11
  %.10.i.i8848 = fcmp ogt double %.1693.i, %.1756.i
  %.11.i.i8849 = select i1 %.10.i.i8848, double %.1693.i, double %.1756.i
  %.1752.i = fsub double 1.000000e+00, %.1751.i
  %.1754.i = fmul double %.1635.i, %.1752.i
  %.1785.i = fcmp ugt double %.1754.i, %.11.i.i8849
  br i1 %.1785.i, label %B1082.i, label %B1046.i

B1046.i:                                          ; preds = %B844.i
  store double 2.000000e+00, ptr %.1577.i, align 8, !noalias !71
  br label %B1154.i

B1082.i:                                          ; preds = %B844.i
  %.1901.i = getelementptr double, ptr %57, i64 %.1317.01237.i
  %.1902.i = load double, ptr %.1901.i, align 8, !noalias !71
  %.1904.i = fmul double %.1635.i, %.1902.i
  %.108.i.i = getelementptr double, ptr %61, i64 %.1317.01237.i
  store double 0.000000e+00, ptr %.108.i.i, align 8, !noalias !86
  %.161.i209.i = getelementptr double, ptr %62, i64 %.1317.01237.i
  store double 0.000000e+00, ptr %.161.i209.i, align 8, !noalias !86
  %.214.i250.i = getelementptr double, ptr %63, i64 %.1317.01237.i
  store double %.1904.i, ptr %.214.i250.i, align 8, !noalias !86
  %195 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1317.01237.i
  %.268.i277.i = load i64, ptr %195, align 8, !noalias !86
  %.294.i.i = icmp slt i64 %.268.i277.i, 0
  %.295.i.i8850 = select i1 %.294.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i288.i = add i64 %.295.i.i8850, %.268.i277.i
  %.316.i297.i = mul i64 %.296.i288.i, %arg.batch.3.3.5.1
  %.320.i.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i297.i
  %.321.i.i = load i64, ptr %.320.i.i, align 8, !noalias !86
  %.322.i300.i = add nsw i64 %.321.i.i, -1
  store i64 %.322.i300.i, ptr %.320.i.i, align 8, !noalias !86
  %.426.i.i = load i64, ptr %195, align 8, !noalias !86
  %.452.i.i8851 = icmp slt i64 %.426.i.i, 0
  %.453.i.i8852 = select i1 %.452.i.i8851, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i8853 = add i64 %.453.i.i8852, %.426.i.i
  %.474.i.i8854 = mul i64 %.454.i.i8853, %arg.batch.3.3.5.1
  %196 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i8854
  %.478.i.i8855 = getelementptr i8, ptr %196, i64 24
  %.479.i.i8856 = load i64, ptr %.478.i.i8855, align 8, !noalias !86
  %.480.i.i8857 = add nsw i64 %.479.i.i8856, 1
  store i64 %.480.i.i8857, ptr %.478.i.i8855, align 8, !noalias !86
  br label %B1154.i

B1153.i:                                          ; preds = %B492.if.i, %B682.i, %B656.i
  %exitcond1242.not.i = icmp eq i64 %arg.shape.0, %.908.i
  br i1 %exitcond1242.not.i, label %B142.loopexit.i, label %B492.if.i

B1154.i:                                          ; preds = %B742.if.i, %B1082.i, %B1046.i
  %exitcond1243.not.i = icmp eq i64 %.1386.i, %arg.shape.0
  br i1 %exitcond1243.not.i, label %B3294, label %B742.if.i

B144.if.i:                                        ; preds = %B3252, %B142.loopexit.i
  %.231.01235.i = phi i64 [ %.296.i, %B142.loopexit.i ], [ 50, %B3252 ]
  %.296.i = add nsw i64 %.231.01235.i, -1
  br i1 %.606, label %B142.loopexit.i.critedge, label %B178.if.i

B178.if.i:                                        ; preds = %B144.if.i, %B178.loopexit.i
  %.349.01230.i = phi i64 [ %.418.i8842, %B178.loopexit.i ], [ 0, %B144.if.i ]
  %.418.i8842 = add nsw i64 %.349.01230.i, 1
  %.499.i = getelementptr double, ptr %56, i64 %.349.01230.i
  %.500.i = load double, ptr %.499.i, align 8, !noalias !71
  %.554.i = getelementptr double, ptr %57, i64 %.349.01230.i
  %.555.i = load double, ptr %.554.i, align 8, !noalias !71
  %.556.i = fadd double %.500.i, %.555.i
  %.557.i = fmul double %.556.i, 5.000000e-01
  %.614.i8843 = getelementptr double, ptr %58, i64 %.349.01230.i
  %.615.i = load double, ptr %.614.i8843, align 8, !noalias !71
  %.616.i = fcmp une double %.615.i, 1.000000e+00
  %share.3.2.i = select i1 %.616.i, double 1.000000e+00, double %.557.i
  %.92.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.349.01230.i
  %.93.i.i = load double, ptr %.92.i.i, align 8, !noalias !81
  %.146.i.i = getelementptr double, ptr %59, i64 %.349.01230.i
  %.147.i.i = load double, ptr %.146.i.i, align 8, !noalias !81
  %.149.i.i = fmul double %share.3.2.i, %.147.i.i
  %.150.i.i = fadd double %.93.i.i, %.149.i.i
  %.203.i.i = getelementptr double, ptr %.505, i64 %.349.01230.i
  store double %.150.i.i, ptr %.203.i.i, align 8, !noalias !81
  br i1 %.287.i1226.not.i, label %B178.loopexit.i, label %B122.if.i.lr.ph.i

B122.if.i.lr.ph.i:                                ; preds = %B178.if.i
  %.247.i.i.i = fsub double 1.000000e+00, %share.3.2.i
  %invariant.gep9185 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.349.01230.i
  %invariant.gep9187 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.349.01230.i
  %invariant.gep9189 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.349.01230.i
  %invariant.gep9191 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.349.01230.i
  %invariant.gep9193 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.349.01230.i
  %invariant.gep9195 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.349.01230.i
  %invariant.gep9197 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.349.01230.i
  %invariant.gep9199 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.349.01230.i
  %invariant.gep9201 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.349.01230.i
  br label %B122.if.i.i

B492.if.i:                                        ; preds = %B344.i, %B1153.i
  %.839.01233.i = phi i64 [ %.908.i, %B1153.i ], [ 0, %B344.i ]
  %.908.i = add nsw i64 %.839.01233.i, 1
  %.989.i = getelementptr double, ptr %58, i64 %.839.01233.i
  %.990.i8846 = load double, ptr %.989.i, align 8, !noalias !71
  %.991.i = fcmp oeq double %.990.i8846, 1.000000e+00
  br i1 %.991.i, label %B544.i, label %B1153.i

B742.if.i:                                        ; preds = %B712.i, %B1154.i
  %.1317.01237.i = phi i64 [ %.1386.i, %B1154.i ], [ 0, %B712.i ]
  %.1386.i = add nsw i64 %.1317.01237.i, 1
  %.1467.i = getelementptr double, ptr %60, i64 %.1317.01237.i
  %.1468.i = load double, ptr %.1467.i, align 8, !noalias !71
  %.1522.i = getelementptr double, ptr %.505, i64 %.1317.01237.i
  store double %.1468.i, ptr %.1522.i, align 8, !noalias !71
  %.1577.i = getelementptr double, ptr %58, i64 %.1317.01237.i
  %.1578.i = load double, ptr %.1577.i, align 8, !noalias !71
  %.1579.i = fcmp oeq double %.1578.i, 1.000000e+00
  br i1 %.1579.i, label %B844.i, label %B1154.i

B3294:                                            ; preds = %B1154.i, %B712.i, %B3252
  br i1 %.4790.not, label %B3356, label %B120.if.i

B120.loopexit.i.critedge:                         ; preds = %B120.if.i
  %.527.i8925.c = load i64, ptr %.526.i8862, align 8, !noalias !89
  %.644.i.c = inttoptr i64 %.527.i8925.c to ptr
  tail call void %.644.i.c(ptr %.505, ptr %.618.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !89
  br label %B120.loopexit.i

B120.loopexit.i:                                  ; preds = %B502.i8926, %B120.loopexit.i.critedge
  %exitcond692.not.i = icmp eq i64 %.231.0688.i, %.8798
  br i1 %exitcond692.not.i, label %B3356, label %B120.if.i

B154.loopexit.i:                                  ; preds = %B122.if.i.i8876, %B154.if.i
  %exitcond690.not.i = icmp eq i64 %arg.shape.0, %.423.i
  br i1 %exitcond690.not.i, label %B206.i, label %B154.if.i

B206.i:                                           ; preds = %B154.loopexit.i
  %.527.i8925 = load i64, ptr %.526.i8862, align 8, !noalias !89
  %.644.i = inttoptr i64 %.527.i8925 to ptr
  tail call void %.644.i(ptr %.505, ptr %.618.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !89
  br label %B354.if.i

B396.i8927:                                       ; preds = %B354.if.i
  %197 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.670.0686.i
  %.854.i = load double, ptr %197, align 8, !noalias !89
  %.856.i = fcmp olt double %.854.i, -1.000000e-09
  br i1 %.856.i, label %B432.i, label %B502.i8926

B432.i:                                           ; preds = %B396.i8927
  %198 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.670.0686.i
  %.84.i51.i = load i64, ptr %198, align 8, !noalias !92
  %.89.i.i8928 = icmp sgt i64 %.84.i51.i, -1
  br i1 %.89.i.i8928, label %B46.i.i8929, label %B432.endif.i

B46.i.i8929:                                      ; preds = %B432.i
  %.120.i73.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i51.i
  %.121.i74.i = load i64, ptr %.120.i73.i, align 8, !noalias !92
  %.122.i75.i = icmp eq i64 %.121.i74.i, 0
  br i1 %.122.i75.i, label %B80.i.i8930, label %B432.endif.i

B80.i.i8930:                                      ; preds = %B46.i.i8929
  store i64 4, ptr %.120.i73.i, align 8, !noalias !92
  br label %B432.endif.i

B502.i8926:                                       ; preds = %B432.endif.i, %B354.if.i, %B396.i8927
  %exitcond691.not.i = icmp eq i64 %arg.shape.0, %.739.i
  br i1 %exitcond691.not.i, label %B120.loopexit.i, label %B354.if.i

B120.if.i:                                        ; preds = %B3294, %B120.loopexit.i
  %.231.0688.i = phi i64 [ %.302.i8865, %B120.loopexit.i ], [ 1, %B3294 ]
  %.302.i8865 = add nsw i64 %.231.0688.i, 1
  br i1 %.606, label %B120.loopexit.i.critedge, label %B154.if.lr.ph.i

B154.if.lr.ph.i:                                  ; preds = %B120.if.i
  %199 = uitofp i64 %.231.0688.i to double
  %.456.i8866 = fdiv double %199, %.452.i
  %.247.i.i.i8867 = fsub double 1.000000e+00, %.456.i8866
  br label %B154.if.i

B154.if.i:                                        ; preds = %B154.if.lr.ph.i, %B154.loopexit.i
  %.354.0683.i = phi i64 [ 0, %B154.if.lr.ph.i ], [ %.423.i, %B154.loopexit.i ]
  %.423.i = add nsw i64 %.354.0683.i, 1
  %.92.i.i8868 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.354.0683.i
  %.93.i.i8869 = load double, ptr %.92.i.i8868, align 8, !noalias !95
  %.146.i.i8870 = getelementptr double, ptr %64, i64 %.354.0683.i
  %.147.i.i8871 = load double, ptr %.146.i.i8870, align 8, !noalias !95
  %.149.i.i8872 = fmul double %.456.i8866, %.147.i.i8871
  %.150.i.i8873 = fadd double %.93.i.i8869, %.149.i.i8872
  %.203.i.i8874 = getelementptr double, ptr %.505, i64 %.354.0683.i
  store double %.150.i.i8873, ptr %.203.i.i8874, align 8, !noalias !95
  br i1 %.287.i679.not.i, label %B154.loopexit.i, label %B122.if.i.preheader.i

B122.if.i.preheader.i:                            ; preds = %B154.if.i
  %invariant.gep9203 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9205 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9207 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9209 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9211 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9213 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9215 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9217 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9219 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  br label %B122.if.i.i8876

B122.if.i.i8876:                                  ; preds = %B122.if.i.i8876, %B122.if.i.preheader.i
  %.229.i.0680.i = phi i64 [ %.300.i.i8918, %B122.if.i.i8876 ], [ 0, %B122.if.i.preheader.i ]
  %.157.i.i.i8877 = add nsw i64 %.229.i.0680.i, %.155.i.i.i8875
  %.159.i.i.i8878 = mul nsw i64 %.157.i.i.i8877, %arg.shape.0
  %gep9204 = getelementptr double, ptr %invariant.gep9203, i64 %.159.i.i.i8878
  %.191.i.i.i8879 = load double, ptr %gep9204, align 8, !noalias !99
  %.193.i.i.i8880 = fadd double %.191.i.i.i8879, 0.000000e+00
  %.253.i.i.i8881 = fmul double %.456.i8866, %.193.i.i.i8880
  %.157.i.i.1.i8883 = add nsw i64 %.229.i.0680.i, %.155.i.i.1.i8882
  %.159.i.i.1.i8884 = mul nsw i64 %.157.i.i.1.i8883, %arg.shape.0
  %gep9206 = getelementptr double, ptr %invariant.gep9205, i64 %.159.i.i.1.i8884
  %.191.i.i.1.i8885 = load double, ptr %gep9206, align 8, !noalias !99
  %.193.i.i.1.i8886 = fadd double %.191.i.i.1.i8885, %.253.i.i.i8881
  %.253.i.i.1.i8887 = fmul double %.247.i.i.i8867, %.193.i.i.1.i8886
  %.157.i.i.2.i8889 = add nsw i64 %.229.i.0680.i, %.155.i.i.2.i8888
  %.159.i.i.2.i8890 = mul nsw i64 %.157.i.i.2.i8889, %arg.shape.0
  %gep9208 = getelementptr double, ptr %invariant.gep9207, i64 %.159.i.i.2.i8890
  %.191.i.i.2.i8891 = load double, ptr %gep9208, align 8, !noalias !99
  %.193.i.i.2.i8892 = fadd double %.191.i.i.2.i8891, %.253.i.i.1.i8887
  %.253.i.i.2.i8893 = fmul double %.456.i8866, %.193.i.i.2.i8892
  %.157.i.i.3.i8895 = add nsw i64 %.229.i.0680.i, %.155.i.i.3.i8894
  %.159.i.i.3.i8896 = mul nsw i64 %.157.i.i.3.i8895, %arg.shape.0
  %gep9210 = getelementptr double, ptr %invariant.gep9209, i64 %.159.i.i.3.i8896
  %.191.i.i.3.i8897 = load double, ptr %gep9210, align 8, !noalias !99
  %.193.i.i.3.i8898 = fadd double %.191.i.i.3.i8897, %.253.i.i.2.i8893
  %.253.i.i.3.i8899 = fmul double %.247.i.i.i8867, %.193.i.i.3.i8898
  %.157.i.i.4.i8901 = add nsw i64 %.229.i.0680.i, %.155.i.i.4.i8900
  %.159.i.i.4.i8902 = mul nsw i64 %.157.i.i.4.i8901, %arg.shape.0
  %gep9212 = getelementptr double, ptr %invariant.gep9211, i64 %.159.i.i.4.i8902
  %.191.i.i.4.i8903 = load double, ptr %gep9212, align 8, !noalias !99
  %.193.i.i.4.i8904 = fadd double %.191.i.i.4.i8903, %.253.i.i.3.i8899
  %.253.i.i.4.i8905 = fmul double %.456.i8866, %.193.i.i.4.i8904
  %.157.i.i.5.i8907 = add nsw i64 %.229.i.0680.i, %.155.i.i.5.i8906
  %.159.i.i.5.i8908 = mul nsw i64 %.157.i.i.5.i8907, %arg.shape.0
  %gep9214 = getelementptr double, ptr %invariant.gep9213, i64 %.159.i.i.5.i8908
  %.191.i.i.5.i8909 = load double, ptr %gep9214, align 8, !noalias !99
  %.193.i.i.5.i8910 = fadd double %.191.i.i.5.i8909, %.253.i.i.4.i8905
  %.253.i.i.5.i8911 = fmul double %.247.i.i.i8867, %.193.i.i.5.i8910
  %.157.i.i.6.i8913 = add nsw i64 %.229.i.0680.i, %.155.i.i.6.i8912
  %.159.i.i.6.i8914 = mul nsw i64 %.157.i.i.6.i8913, %arg.shape.0
  %gep9216 = getelementptr double, ptr %invariant.gep9215, i64 %.159.i.i.6.i8914
  %.191.i.i.6.i8915 = load double, ptr %gep9216, align 8, !noalias !99
  %.193.i.i.6.i8916 = fadd double %.191.i.i.6.i8915, %.253.i.i.5.i8911
  %.253.i.i.6.i8917 = fmul double %.456.i8866, %.193.i.i.6.i8916
  %.300.i.i8918 = add nsw i64 %.229.i.0680.i, 1
  %.271.i.i.i8919 = mul nsw i64 %.229.i.0680.i, %arg.shape.0
  %gep9218 = getelementptr double, ptr %invariant.gep9217, i64 %.271.i.i.i8919
  %.309.i.i.i8920 = load double, ptr %gep9218, align 8, !noalias !99
  %.313.i.i.i8921 = fadd double %.309.i.i.i8920, %.253.i.i.6.i8917
  %.360.i.i8922 = add nsw i64 %.229.i.0680.i, %.359.i.i8863
  %.362.i.i8923 = mul nsw i64 %.360.i.i8922, %arg.shape.0
  %gep9220 = getelementptr double, ptr %invariant.gep9219, i64 %.362.i.i8923
  store double %.313.i.i.i8921, ptr %gep9220, align 8, !noalias !95
  %exitcond.not.i8924 = icmp eq i64 %arg.shape.1, %.300.i.i8918
  br i1 %exitcond.not.i8924, label %B154.loopexit.i, label %B122.if.i.i8876

B354.if.i:                                        ; preds = %B206.i, %B502.i8926
  %.670.0686.i = phi i64 [ %.739.i, %B502.i8926 ], [ 0, %B206.i ]
  %.739.i = add nsw i64 %.670.0686.i, 1
  %200 = getelementptr double, ptr %65, i64 %.670.0686.i
  %.821.i = load double, ptr %200, align 8, !noalias !89
  %.822.i = fcmp ogt double %.821.i, 5.000000e-01
  br i1 %.822.i, label %B396.i8927, label %B502.i8926

B432.endif.i:                                     ; preds = %B80.i.i8930, %B46.i.i8929, %B432.i
  store double 0.000000e+00, ptr %200, align 8, !noalias !89
  br label %B502.i8926

B3356:                                            ; preds = %B120.loopexit.i, %B2826, %B3294
  br i1 %wanted.2.1, label %B3364, label %B3416

B3364:                                            ; preds = %B3356
  %within.5.1.not = xor i1 %within.5.1, true
  %brmerge8801 = select i1 %within.5.1.not, i1 true, i1 %.548
  %"$phi3400.7.2.2" = select i1 %brmerge8801, i64 0, i64 3
  br i1 %.606, label %B3416, label %B96.if.i

B172.i:                                           ; preds = %B96.if.i
  %.452.i8932 = getelementptr double, ptr %67, i64 %.180.0654.i
  %.453.i8933 = load double, ptr %.452.i8932, align 8, !noalias !103
  %.454.i8934 = fcmp olt double %.453.i8933, 5.000000e-01
  br i1 %.454.i8934, label %B789.i, label %B210.i

B210.i:                                           ; preds = %B172.i
  %.485.i8935 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.334.i
  %.486.i = load i64, ptr %.485.i8935, align 8, !noalias !103
  %.487.not.i = icmp eq i64 %.486.i, 0
  br i1 %.487.not.i, label %B246.i, label %B789.i

B246.i:                                           ; preds = %B210.i
  %.549.i8936 = mul i64 %.334.i, %arg.batch.3.3.5.1
  %201 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.549.i8936
  %.553.i = getelementptr i8, ptr %201, i64 8
  %.554.i8937 = load i64, ptr %.553.i, align 8, !noalias !103
  %.556.i8938 = add nsw i64 %.554.i8937, %"$phi3400.7.2.2"
  store i64 %.556.i8938, ptr %.553.i, align 8, !noalias !103
  %.662.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.180.0654.i
  %.663.i8939 = load double, ptr %.662.i, align 8, !noalias !103
  %.717.i = getelementptr double, ptr %68, i64 %.180.0654.i
  %.718.i = load double, ptr %.717.i, align 8, !noalias !103
  %.772.i8940 = getelementptr double, ptr %69, i64 %.180.0654.i
  %.773.i8941 = load double, ptr %.772.i8940, align 8, !noalias !103
  %.794.i = icmp slt i64 %.389.i, %arg.batch.2.5.0
  br i1 %.794.i, label %B420.i, label %B760.i

B420.i:                                           ; preds = %B246.i
  %.817.i = icmp slt i64 %.389.i, 0
  %.818.i8942 = select i1 %.817.i, i64 %arg.batch.2.5.0, i64 0
  %202 = getelementptr double, ptr %arg.batch.2.4, i64 %.389.i
  %.832.i = getelementptr double, ptr %202, i64 %.818.i8942
  %.833.i = load double, ptr %.832.i, align 8, !noalias !103
  %.837.i = fcmp ugt double %.833.i, %.773.i8941
  br i1 %.837.i, label %B760.i, label %B444.preheader.i

B444.preheader.i:                                 ; preds = %B420.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul652.i, %.334.i
  %.1324.i = getelementptr double, ptr %70, i64 %.180.0654.i
  %203 = getelementptr double, ptr %arg.batch.3.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep9221 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9223 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9225 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9227 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9229 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9231 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9233 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9235 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9237 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  br label %B444.i

B444.i:                                           ; preds = %B736.i, %B444.preheader.i
  %done.2.3.i = phi i64 [ %.1262.i, %B736.i ], [ %.389.i, %B444.preheader.i ]
  br i1 %.924649.not.i, label %B644.i, label %B474.if.lr.ph.i

B474.if.lr.ph.i:                                  ; preds = %B444.i
  %.979.i8943 = icmp slt i64 %done.2.3.i, 0
  %.980.i8944 = select i1 %.979.i8943, i64 %arg.batch.2.5.0, i64 0
  %204 = getelementptr double, ptr %arg.batch.2.4, i64 %done.2.3.i
  %.994.i8945 = getelementptr double, ptr %204, i64 %.980.i8944
  %.1220.i = select i1 %.979.i8943, i64 %arg.batch.3.0.5.1, i64 0
  %.1221.i = add i64 %.1220.i, %done.2.3.i
  %.1250.i = mul i64 %.1221.i, %arg.batch.3.0.5.2
  %205 = getelementptr double, ptr %203, i64 %.1250.i
  br label %B474.if.i

B502.i8953:                                       ; preds = %B474.if.i
  %.1002.i = add nsw i64 %.868.0650.i, %.1000.i
  %.1004.i = mul nsw i64 %.1002.i, %arg.shape.0
  %gep9238 = getelementptr double, ptr %invariant.gep9237, i64 %.1004.i
  %.1036.i = load double, ptr %gep9238, align 8, !noalias !103
  br label %B790.i

B644.i:                                           ; preds = %B790.i, %B444.i
  store double 0x7FF0000000000000, ptr %.1324.i, align 8, !noalias !103
  %exitcond656.not.i = icmp eq i64 %done.2.3.i, %71
  br i1 %exitcond656.not.i, label %B760.i, label %B736.i

B736.i:                                           ; preds = %B644.i
  %.1262.i = add i64 %done.2.3.i, 1
  %.1359.i = icmp slt i64 %done.2.3.i, -1
  %.1360.i = select i1 %.1359.i, i64 %arg.batch.2.5.0, i64 0
  %206 = getelementptr double, ptr %arg.batch.2.4, i64 %.1262.i
  %.1374.i = getelementptr double, ptr %206, i64 %.1360.i
  %.1375.i = load double, ptr %.1374.i, align 8, !noalias !103
  %.1379.i = fcmp ugt double %.1375.i, %.773.i8941
  br i1 %.1379.i, label %B760.i, label %B444.i

B760.i:                                           ; preds = %B736.i, %B644.i, %B420.i, %B246.i
  %done.3.2.i = phi i64 [ %.389.i, %B420.i ], [ %.389.i, %B246.i ], [ %arg.batch.2.5.0, %B644.i ], [ %.1262.i, %B736.i ]
  store i64 %done.3.2.i, ptr %.388.i, align 8, !noalias !103
  br label %B789.i

B789.i:                                           ; preds = %B96.if.i, %B760.i, %B210.i, %B172.i
  %exitcond657.not.i = icmp eq i64 %.252.i, %arg.shape.0
  br i1 %exitcond657.not.i, label %B3416, label %B96.if.i

B790.i:                                           ; preds = %B38.if.i.i, %B502.i8953
  %.313.i.i.sink = phi double [ %.313.i.i, %B38.if.i.i ], [ %.1036.i, %B502.i8953 ]
  %207 = getelementptr double, ptr %205, i64 %.868.0650.i
  store double %.313.i.i.sink, ptr %207, align 8, !noalias !103
  %exitcond.not.i8952 = icmp eq i64 %arg.shape.1, %.937.i
  br i1 %exitcond.not.i8952, label %B644.i, label %B474.if.i

B96.if.i:                                         ; preds = %B3364, %B789.i
  %.180.0654.i = phi i64 [ %.252.i, %B789.i ], [ 0, %B3364 ]
  %.252.i = add nsw i64 %.180.0654.i, 1
  %.333.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.180.0654.i
  %.334.i = load i64, ptr %.333.i, align 8, !noalias !103
  %.388.i = getelementptr i64, ptr %66, i64 %.180.0654.i
  %.389.i = load i64, ptr %.388.i, align 8, !noalias !103
  %.397.i = icmp slt i64 %.334.i, 0
  br i1 %.397.i, label %B789.i, label %B172.i

B474.if.i:                                        ; preds = %B790.i, %B474.if.lr.ph.i
  %.868.0650.i = phi i64 [ 0, %B474.if.lr.ph.i ], [ %.937.i, %B790.i ]
  %.937.i = add nsw i64 %.868.0650.i, 1
  %.995.i8949 = load double, ptr %.994.i8945, align 8, !noalias !103
  %.997.i = fcmp oeq double %.995.i8949, %.773.i8941
  br i1 %.997.i, label %B502.i8953, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B474.if.i
  %.1145.i = fsub double %.995.i8949, %.663.i8939
  %.1150.i = fdiv double %.1145.i, %.718.i
  %.247.i.i = fsub double 1.000000e+00, %.1150.i
  %.157.i.i = add nsw i64 %.868.0650.i, %.155.i.i
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep9222 = getelementptr double, ptr %invariant.gep9221, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep9222, align 8, !noalias !106
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i8950 = fmul double %.1150.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.868.0650.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep9224 = getelementptr double, ptr %invariant.gep9223, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep9224, align 8, !noalias !106
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i8950
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.868.0650.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep9226 = getelementptr double, ptr %invariant.gep9225, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep9226, align 8, !noalias !106
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %.1150.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.868.0650.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep9228 = getelementptr double, ptr %invariant.gep9227, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep9228, align 8, !noalias !106
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.868.0650.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep9230 = getelementptr double, ptr %invariant.gep9229, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep9230, align 8, !noalias !106
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %.1150.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.868.0650.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep9232 = getelementptr double, ptr %invariant.gep9231, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep9232, align 8, !noalias !106
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.868.0650.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep9234 = getelementptr double, ptr %invariant.gep9233, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep9234, align 8, !noalias !106
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %.1150.i, %.193.i.6.i
  %.271.i.i8951 = mul nsw i64 %.868.0650.i, %arg.shape.0
  %gep9236 = getelementptr double, ptr %invariant.gep9235, i64 %.271.i.i8951
  %.309.i.i = load double, ptr %gep9236, align 8, !noalias !106
  %.313.i.i = fadd double %.309.i.i, %.253.i.6.i
  br label %B790.i

B3416:                                            ; preds = %B789.i, %B3364, %B3356
  br i1 %.5026, label %B3466, label %B3428

B3428:                                            ; preds = %B3416
  %.5081 = load double, ptr %.5080, align 8
  %.5082 = fcmp ogt double %.5081, 5.000000e-01
  br i1 %.5082, label %B3466, label %B3534

B3466:                                            ; preds = %B3428, %B3416
  %.5113 = load i64, ptr %.5112, align 8
  %.5158 = inttoptr i64 %.5113 to ptr
  tail call void %.5158(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3534

B3534:                                            ; preds = %B3466, %B3428
  %beyond.2.1.not = xor i1 %beyond.2.1, true
  %brmerge9267 = or i1 %.606, %beyond.2.1.not
  br i1 %brmerge9267, label %B3578, label %B80.if.i4441

B134.i:                                           ; preds = %B80.if.i4441
  %.351.i3756 = getelementptr double, ptr %73, i64 %.141.i3564.09246
  %.352.i3757 = load double, ptr %.351.i3756, align 8, !noalias !110
  %.353.i3758 = fcmp ogt double %.352.i3757, 5.000000e-01
  br i1 %.353.i3758, label %B174.i, label %B740.i

B174.i:                                           ; preds = %B134.i
  %.408.i3806 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.141.i3564.09246
  %.409.i3807 = load double, ptr %.408.i3806, align 8, !noalias !110
  %.463.i3855 = getelementptr double, ptr %74, i64 %.141.i3564.09246
  %.464.i3856 = load double, ptr %.463.i3855, align 8, !noalias !110
  %.465.i3857 = fsub double %.409.i3807, %.464.i3856
  br i1 %.552.i38949239.not, label %B380.i, label %B270.if.i.preheader

B270.if.i.preheader:                              ; preds = %B174.i
  %invariant.gep9295 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.141.i3564.09246
  br label %B270.if.i

B380.i:                                           ; preds = %B270.if.i, %B174.i
  %fastest.2.i.2.lcssa = phi double [ 0.000000e+00, %B174.i ], [ %.11.i.i, %B270.if.i ]
  %.666.i3906 = fmul double %.465.i3857, %fastest.2.i.2.lcssa
  %.698.i3932 = load double, ptr %.697.i3931, align 8, !noalias !110
  %.699.i3933 = fcmp ogt double %.666.i3906, %.698.i3932
  %.8802 = select i1 %.699.i3933, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  %.743.i3962 = load double, ptr %.742.i3961, align 8, !noalias !110
  %.773.i3984 = load double, ptr %arg.batch.2.4, align 8, !noalias !110
  %.774.i3985 = fsub double %.743.i3962, %.773.i3984
  %.776.i3987 = fmul double %.8802, %.774.i3985
  %.780.i3990 = fcmp olt double %.465.i3857, %.776.i3987
  br i1 %.780.i3990, label %B490.i, label %B528.i

B490.i:                                           ; preds = %B380.i
  %208 = getelementptr i64, ptr %76, i64 %.141.i3564.09246
  %.838.i4378 = load i64, ptr %208, align 8, !noalias !110
  %.839.i4379 = add nsw i64 %.838.i4378, 1
  br label %B528.i

B528.i:                                           ; preds = %B380.i, %B490.i
  %"$phi528.1.2.i.2" = phi i64 [ %.839.i4379, %B490.i ], [ 0, %B380.i ]
  %209 = getelementptr i64, ptr %77, i64 %.141.i3564.09246
  store i64 %"$phi528.1.2.i.2", ptr %209, align 8, !noalias !110
  %.959.i4086 = load double, ptr %.408.i3806, align 8, !noalias !110
  store double %.959.i4086, ptr %.463.i3855, align 8, !noalias !110
  %.1068.i4150 = getelementptr double, ptr %78, i64 %.141.i3564.09246
  store double 1.000000e+00, ptr %.1068.i4150, align 8, !noalias !110
  store i64 1, ptr %.984, align 8, !noalias !110
  %.1154.i = load i64, ptr %209, align 8, !noalias !110
  %.1155.i = icmp sgt i64 %.1154.i, 1000
  br i1 %.1155.i, label %B694.i, label %B740.i

B694.i:                                           ; preds = %B528.i
  %210 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.141.i3564.09246
  %.84.i.i4270 = load i64, ptr %210, align 8, !noalias !114
  %.89.i.i4273 = icmp sgt i64 %.84.i.i4270, -1
  br i1 %.89.i.i4273, label %B46.i.i4280, label %B740.i

B46.i.i4280:                                      ; preds = %B694.i
  %.120.i.i4300 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i4270
  %.121.i.i4301 = load i64, ptr %.120.i.i4300, align 8, !noalias !114
  %.122.i.i4302 = icmp eq i64 %.121.i.i4301, 0
  br i1 %.122.i.i4302, label %B80.i.i4307, label %B740.i

B80.i.i4307:                                      ; preds = %B46.i.i4280
  store i64 6, ptr %.120.i.i4300, align 8, !noalias !114
  br label %B740.i

B740.i:                                           ; preds = %B80.i.i4307, %B694.i, %B46.i.i4280, %B528.i, %B134.i, %B80.if.i4441
  %.200.i3646 = icmp sgt i64 %.144.i3565.09245, 1
  br i1 %.200.i3646, label %B80.if.i4441, label %B3578

B80.if.i4441:                                     ; preds = %B3534, %B740.i
  %.141.i3564.09246 = phi i64 [ %.213.i4449, %B740.i ], [ 0, %B3534 ]
  %.144.i3565.09245 = phi i64 [ %.209.i4446, %B740.i ], [ %storemerge, %B3534 ]
  %.209.i4446 = add nsw i64 %.144.i3565.09245, -1
  %.213.i4449 = add nsw i64 %.141.i3564.09246, 1
  %.294.i3706 = getelementptr double, ptr %72, i64 %.141.i3564.09246
  %.295.i3707 = load double, ptr %.294.i3706, align 8, !noalias !110
  %.296.i3708 = fcmp oeq double %.295.i3707, 2.000000e+00
  br i1 %.296.i3708, label %B134.i, label %B740.i

B270.if.i:                                        ; preds = %B270.if.i.preheader, %B270.if.i
  %fastest.2.i.29242 = phi double [ %.11.i.i, %B270.if.i ], [ 0.000000e+00, %B270.if.i.preheader ]
  %.496.i3580.09241 = phi i64 [ %.565.i4433, %B270.if.i ], [ 0, %B270.if.i.preheader ]
  %.565.i4433 = add nsw i64 %.496.i3580.09241, 1
  %.592.i4386 = add nsw i64 %.496.i3580.09241, %arg.shape.1
  %.594.i4388 = mul nsw i64 %.592.i4386, %arg.shape.0
  %gep9296 = getelementptr double, ptr %invariant.gep9295, i64 %.594.i4388
  %.626.i4416 = load double, ptr %gep9296, align 8, !noalias !110
  %.627.i4417 = tail call double @llvm.fabs.f64(double %.626.i4416)
  %.10.i.i = fcmp ogt double %.627.i4417, %fastest.2.i.29242
  %.11.i.i = select i1 %.10.i.i, double %.627.i4417, double %fastest.2.i.29242
  %exitcond9281.not = icmp eq i64 %arg.shape.1, %.565.i4433
  br i1 %exitcond9281.not, label %B380.i, label %B270.if.i

B3578:                                            ; preds = %B740.i, %B3534
  %brmerge8803.not = and i1 %.5223.not, %looked.4.2.lcssa
  %brmerge8803.not.not = xor i1 %brmerge8803.not, true
  %brmerge9266 = or i1 %.606, %brmerge8803.not.not
  br i1 %brmerge9266, label %B3628, label %B114.if.i

B46.i.i8955:                                      ; preds = %B114.if.i
  %.135.i.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !117
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i8965, label %B228.i

B80.i.i8965:                                      ; preds = %B46.i.i8955
  %.196.i.i = getelementptr double, ptr %79, i64 %.302.01886.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !117
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B228.i, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i8965
  %.264.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.302.01886.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !117
  %.321.i.i8966 = getelementptr double, ptr %80, i64 %.302.01886.i
  %.322.i.i8967 = load double, ptr %.321.i.i8966, align 8, !noalias !117
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i8967
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.175.i5391882.not.i
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01888.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01888.i
  br i1 %brmerge.i, label %B228.i, label %B76.if.i.lr.ph.i8968

B76.if.i.lr.ph.i8968:                             ; preds = %B122.i.i
  %211 = getelementptr i64, ptr %81, i64 %.302.01886.i
  %.513.i8969 = load i64, ptr %211, align 8, !noalias !122
  %.514.i = add nsw i64 %.513.i8969, 1
  %.236.i556.i = icmp slt i64 %.513.i8969, -1
  %.237.i557.i = select i1 %.236.i556.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i558.i = add i64 %.514.i, %.237.i557.i
  %.258.i575.i = mul i64 %.238.i558.i, %arg.batch.1.3.5.1
  %212 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i575.i
  br label %B76.if.i.i8970

B76.if.i.i8970:                                   ; preds = %B76.if.i.i8970, %B76.if.i.lr.ph.i8968
  %.117.i501.01883.i = phi i64 [ 0, %B76.if.i.lr.ph.i8968 ], [ %.188.i623.i, %B76.if.i.i8970 ]
  %.188.i623.i = add nsw i64 %.117.i501.01883.i, 1
  %213 = getelementptr double, ptr %212, i64 %.117.i501.01883.i
  %.263.i577.i = load double, ptr %213, align 8, !noalias !123
  %214 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i501.01883.i
  %.293.i593.i = load i64, ptr %214, align 8, !noalias !123
  %.295.i595.i = mul nsw i64 %.293.i593.i, %arg.shape.0
  %.297.i597.i = add nsw i64 %.295.i595.i, %.302.01886.i
  %.311.i605.i = icmp slt i64 %.297.i597.i, 0
  %.312.i606.i = select i1 %.311.i605.i, i64 %arg.batch.5.1.5.0, i64 0
  %215 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i597.i
  %.326.i616.i = getelementptr double, ptr %215, i64 %.312.i606.i
  store double %.263.i577.i, ptr %.326.i616.i, align 8, !noalias !123
  %exitcond.not.i8971 = icmp eq i64 %arg.batch.1.1.5.0, %.188.i623.i
  br i1 %exitcond.not.i8971, label %B228.i, label %B76.if.i.i8970

B228.i:                                           ; preds = %B76.if.i.i8970, %B114.if.i, %B122.i.i, %B80.i.i8965, %B46.i.i8955
  %some.3.1.i = phi i1 [ %some.2.01888.mux.i, %B122.i.i ], [ %some.2.01888.i, %B80.i.i8965 ], [ %some.2.01888.i, %B114.if.i ], [ %some.2.01888.i, %B46.i.i8955 ], [ true, %B76.if.i.i8970 ]
  %exitcond1900.not.i = icmp eq i64 %arg.shape.0, %.373.i8954
  br i1 %exitcond1900.not.i, label %B230.i, label %B114.if.i

B230.i:                                           ; preds = %B228.i
  br i1 %some.3.1.i, label %B238.i, label %B3628

B238.i:                                           ; preds = %B230.i
  %.637.i = load i64, ptr %.636.i, align 8, !noalias !122
  %.749.i = inttoptr i64 %.637.i to ptr
  tail call void %.749.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !122
  %.780.i = load i64, ptr %.779.i, align 8, !noalias !122
  %.896.i8957 = inttoptr i64 %.780.i to ptr
  tail call void %.896.i8957(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.895.i8956), !noalias !122
  br label %B470.if.i

B46.i82.i:                                        ; preds = %B470.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !127
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B850.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %79, i64 %.922.01895.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !127
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B850.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.922.01895.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !127
  %.321.i223.i = getelementptr double, ptr %80, i64 %.922.01895.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !127
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B850.i, label %B510.i

B510.i:                                           ; preds = %B122.i147.i
  %.1176.i = getelementptr i64, ptr %82, i64 %.922.01895.i
  %.1177.i = load i64, ptr %.1176.i, align 8, !noalias !122
  %.1188.i = icmp sgt i64 %.1177.i, 0
  br i1 %.1188.i, label %B586.i, label %B640.i

B586.i:                                           ; preds = %B510.i
  %216 = getelementptr double, ptr %arg.batch.2.4, i64 %.1177.i
  %.1223.i8963 = getelementptr i8, ptr %216, i64 -8
  %.1224.i8964 = load double, ptr %.1223.i8963, align 8, !noalias !122
  %.1280.i = fcmp oeq double %.1224.i8964, %.265.i185.i
  br label %B640.i

B640.i:                                           ; preds = %B586.i, %B510.i
  %"$phi640.1.2.1.i" = phi i1 [ %.1280.i, %B586.i ], [ false, %B510.i ]
  br i1 %.13761889.not.i, label %B850.i, label %B672.if.lr.ph.i

B672.if.lr.ph.i:                                  ; preds = %B640.i
  %.1506.i = add nsw i64 %.1177.i, -1
  %.1545.i = select i1 %.1188.i, i64 0, i64 %arg.batch.3.0.5.1
  %.1546.i8961 = add i64 %.1506.i, %.1545.i
  %.1573.i = mul i64 %.1571.i, %.99.i78.i
  %.1575.i = mul i64 %.1546.i8961, %arg.batch.3.0.5.2
  %217 = getelementptr double, ptr %arg.batch.3.0.4, i64 %.1573.i
  %218 = getelementptr double, ptr %217, i64 %.1575.i
  %invariant.gep9247 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.922.01895.i
  %invariant.gep9249 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.922.01895.i
  br label %B672.if.i

B768.i:                                           ; preds = %B672.if.i
  %219 = getelementptr double, ptr %218, i64 %.1320.01890.i
  store double %.1454.i, ptr %219, align 8, !noalias !122
  br label %B790.i8962

B790.i8962:                                       ; preds = %B672.if.i, %B768.i
  %exitcond1901.not.i = icmp eq i64 %arg.shape.1, %.1389.i
  br i1 %exitcond1901.not.i, label %B792.loopexit.i, label %B672.if.i

B792.loopexit.i:                                  ; preds = %B790.i8962
  %220 = fcmp une double %.1461.i, 0.000000e+00
  br i1 %220, label %B804.i, label %B850.i

B804.i:                                           ; preds = %B792.loopexit.i
  %.84.i685.i = load i64, ptr %223, align 8, !noalias !130
  %.89.i687.i = icmp sgt i64 %.84.i685.i, -1
  br i1 %.89.i687.i, label %B46.i691.i, label %B850.i

B46.i691.i:                                       ; preds = %B804.i
  %.120.i711.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i685.i
  %.121.i712.i = load i64, ptr %.120.i711.i, align 8, !noalias !130
  %.122.i713.i = icmp eq i64 %.121.i712.i, 0
  br i1 %.122.i713.i, label %B80.i717.i, label %B850.i

B80.i717.i:                                       ; preds = %B46.i691.i
  store i64 3, ptr %.120.i711.i, align 8, !noalias !130
  br label %B850.i

B850.i:                                           ; preds = %B470.if.i, %B80.i717.i, %B46.i691.i, %B804.i, %B792.loopexit.i, %B640.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %exitcond1902.not.i = icmp eq i64 %arg.shape.0, %.991.i8958
  br i1 %exitcond1902.not.i, label %B852.i, label %B470.if.i

B852.i:                                           ; preds = %B850.i
  br i1 %.1663.not.i, label %B3628, label %B868.i

B868.i:                                           ; preds = %B852.i
  %.1694.i = load i64, ptr %.1693.i8959, align 8, !noalias !122
  %.1808.i = inttoptr i64 %.1694.i to ptr
  tail call void %.1808.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !122
  br label %B988.if.i

B46.i315.i:                                       ; preds = %B988.if.i
  %.135.i335.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i311.i
  %.136.i336.i = load i64, ptr %.135.i335.i, align 8, !noalias !133
  %.141.i339.not.i = icmp eq i64 %.136.i336.i, 0
  br i1 %.141.i339.not.i, label %B80.i340.i, label %B1110.i

B80.i340.i:                                       ; preds = %B46.i315.i
  %.196.i377.i = getelementptr double, ptr %79, i64 %.1844.01898.i
  %.197.i378.i = load double, ptr %.196.i377.i, align 8, !noalias !133
  %.198.i379.i = fcmp olt double %.197.i378.i, 5.000000e-01
  br i1 %.198.i379.i, label %B1110.i, label %B122.i380.i

B122.i380.i:                                      ; preds = %B80.i340.i
  %.264.i417.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.1844.01898.i
  %.265.i418.i = load double, ptr %.264.i417.i, align 8, !noalias !133
  %.321.i456.i = getelementptr double, ptr %80, i64 %.1844.01898.i
  %.322.i457.i = load double, ptr %.321.i456.i, align 8, !noalias !133
  %.325.i459.i = fcmp une double %.265.i418.i, %.322.i457.i
  br i1 %.325.i459.i, label %B1110.i, label %B1028.i

B1028.i:                                          ; preds = %B122.i380.i
  %221 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.1844.01898.i
  %.2020.i = load double, ptr %221, align 8, !noalias !122
  %.2022.i = fcmp olt double %.2020.i, -1.000000e-09
  br i1 %.2022.i, label %B80.i856.i, label %B1110.i

B80.i856.i:                                       ; preds = %B1028.i
  store i64 4, ptr %.135.i335.i, align 8, !noalias !136
  br label %B1110.i

B1110.i:                                          ; preds = %B988.if.i, %B80.i856.i, %B1028.i, %B122.i380.i, %B80.i340.i, %B46.i315.i
  %exitcond9282.not = icmp eq i64 %arg.shape.0, %.1913.i
  br i1 %exitcond9282.not, label %B3628, label %B988.if.i

B114.if.i:                                        ; preds = %B3578, %B228.i
  %some.2.01888.i = phi i1 [ %some.3.1.i, %B228.i ], [ false, %B3578 ]
  %.302.01886.i = phi i64 [ %.373.i8954, %B228.i ], [ 0, %B3578 ]
  %.373.i8954 = add nsw i64 %.302.01886.i, 1
  %222 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.302.01886.i
  %.99.i.i = load i64, ptr %222, align 8, !noalias !117
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B228.i, label %B46.i.i8955

B470.if.i:                                        ; preds = %B850.i, %B238.i
  %.922.01895.i = phi i64 [ 0, %B238.i ], [ %.991.i8958, %B850.i ]
  %.991.i8958 = add nsw i64 %.922.01895.i, 1
  %223 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.922.01895.i
  %.99.i78.i = load i64, ptr %223, align 8, !noalias !127
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B850.i, label %B46.i82.i

B672.if.i:                                        ; preds = %B790.i8962, %B672.if.lr.ph.i
  %trouble.2.11892.i = phi double [ 0.000000e+00, %B672.if.lr.ph.i ], [ %.1461.i, %B790.i8962 ]
  %.1320.01890.i = phi i64 [ 0, %B672.if.lr.ph.i ], [ %.1389.i, %B790.i8962 ]
  %.1389.i = add nsw i64 %.1320.01890.i, 1
  %.1420.i = add nsw i64 %.1320.01890.i, %.850.i
  %.1422.i = mul nsw i64 %.1420.i, %arg.shape.0
  %gep9248 = getelementptr double, ptr %invariant.gep9247, i64 %.1422.i
  %.1454.i = load double, ptr %gep9248, align 8, !noalias !122
  %.1459.i = fmul double %.1454.i, 0.000000e+00
  %.1461.i = fadd double %trouble.2.11892.i, %.1459.i
  %.1469.i = mul nsw i64 %.1320.01890.i, %arg.shape.0
  %gep9250 = getelementptr double, ptr %invariant.gep9249, i64 %.1469.i
  store double %.1454.i, ptr %gep9250, align 8, !noalias !122
  br i1 %"$phi640.1.2.1.i", label %B768.i, label %B790.i8962

B988.if.i:                                        ; preds = %B1110.i, %B868.i
  %.1844.01898.i = phi i64 [ 0, %B868.i ], [ %.1913.i, %B1110.i ]
  %.1913.i = add nsw i64 %.1844.01898.i, 1
  %224 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1844.01898.i
  %.99.i311.i = load i64, ptr %224, align 8, !noalias !133
  %.104.i314.i = icmp slt i64 %.99.i311.i, 0
  br i1 %.104.i314.i, label %B1110.i, label %B46.i315.i

B3628:                                            ; preds = %B1110.i, %B3578, %B230.i, %B852.i
  %looked.4.2.lcssa.not = xor i1 %looked.4.2.lcssa, true
  %brmerge9268 = or i1 %.606, %looked.4.2.lcssa.not
  %active.9.1.mux = select i1 %looked.4.2.lcssa, i64 0, i64 %active.9.1
  br i1 %brmerge9268, label %B4426, label %B3670.if

B3718:                                            ; preds = %B3670.if
  %.5606 = mul i64 %.5533, %arg.batch.3.3.5.1
  %.5610 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.5606
  %.5611 = load i64, ptr %.5610, align 8
  %.5667 = getelementptr i8, ptr %.5610, i64 24
  %.5668 = load i64, ptr %.5667, align 8
  %225 = add i64 %.5611, %.5668
  %.5669 = sub i64 %arg.most, %225
  %.5674 = icmp slt i64 %.5669, 1
  br i1 %.5674, label %B3798, label %B3844

B3798:                                            ; preds = %B3718
  %226 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5371.09255
  %.84.i4531 = load i64, ptr %226, align 8, !noalias !139
  %.89.i4534 = icmp sgt i64 %.84.i4531, -1
  br i1 %.89.i4534, label %B46.i4539, label %B3844

B46.i4539:                                        ; preds = %B3798
  %.120.i4565 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i4531
  %.121.i4566 = load i64, ptr %.120.i4565, align 8, !noalias !139
  %.122.i4567 = icmp eq i64 %.121.i4566, 0
  br i1 %.122.i4567, label %B80.i4572, label %B3844

B80.i4572:                                        ; preds = %B46.i4539
  store i64 5, ptr %.120.i4565, align 8, !noalias !139
  br label %B3844

B3844:                                            ; preds = %B80.i4572, %B3798, %B46.i4539, %B3718
  %.5764 = getelementptr double, ptr %83, i64 %.5371.09255
  %.5765 = load double, ptr %.5764, align 8
  %.5766 = fcmp ogt double %.5765, 5.000000e-01
  br i1 %.5766, label %B3882, label %B3986

B3882:                                            ; preds = %B3844
  %.5821 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5371.09255
  %.5822 = load double, ptr %.5821, align 8
  %.5876 = getelementptr double, ptr %84, i64 %.5371.09255
  %.5877 = load double, ptr %.5876, align 8
  %.5878 = fcmp oeq double %.5822, %.5877
  br i1 %.5878, label %B3946, label %B3986

B3946:                                            ; preds = %B3882
  %.192.i4798 = load i64, ptr %.5532, align 8, !noalias !142
  %.248.i4846 = getelementptr i64, ptr %85, i64 %.5371.09255
  %.249.i4847 = load i64, ptr %.248.i4846, align 8, !noalias !142
  %.250.i4848 = add nsw i64 %.249.i4847, 1
  store i64 %.250.i4848, ptr %.248.i4846, align 8, !noalias !142
  %.373.i4953 = icmp slt i64 %.249.i4847, -1
  %.374.i4954 = select i1 %.373.i4953, i64 %arg.batch.1.2.5.0, i64 0
  %227 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.250.i4848
  %.388.i4968 = getelementptr double, ptr %227, i64 %.374.i4954
  %.389.i4969 = load double, ptr %.388.i4968, align 8, !noalias !142
  %.390.i4970 = fcmp oeq double %.389.i4969, 0x7FF0000000000000
  br i1 %.390.i4970, label %B182.i, label %B240.i4971

B182.i:                                           ; preds = %B3946
  %.424.i5493 = icmp slt i64 %.192.i4798, 0
  %.425.i5494 = select i1 %.424.i5493, i64 %arg.batch.3.1.5.0, i64 0
  %228 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.192.i4798
  %.439.i5508 = getelementptr i64, ptr %228, i64 %.425.i5494
  %.440.i5509 = load i64, ptr %.439.i5508, align 8, !noalias !142
  %.441.i5510 = icmp eq i64 %.440.i5509, 0
  br i1 %.441.i5510, label %B216.i5513, label %B3986

B216.i5513:                                       ; preds = %B182.i
  store i64 1, ptr %.439.i5508, align 8, !noalias !142
  br label %B3986

B240.i4971:                                       ; preds = %B3946
  store double %.389.i4969, ptr %.5876, align 8, !noalias !142
  %.592.i5061 = select i1 %.373.i4953, i64 %arg.batch.1.4.5.0, i64 0
  %229 = getelementptr i64, ptr %arg.batch.1.4.4, i64 %.250.i4848
  %.606.i5075 = getelementptr i64, ptr %229, i64 %.592.i5061
  %.607.i5076 = load i64, ptr %.606.i5075, align 8, !noalias !142
  %.610.i5078 = icmp eq i64 %.607.i5076, 0
  br i1 %.610.i5078, label %B300.i, label %B348.i

B300.i:                                           ; preds = %B240.i4971
  %.665.i5447 = getelementptr double, ptr %86, i64 %.5371.09255
  store double 1.000000e+00, ptr %.665.i5447, align 8, !noalias !142
  br label %B392.i.sink.split

B348.i:                                           ; preds = %B240.i4971
  %.733.i5104 = load i64, ptr %.984, align 8, !noalias !142
  %.734.i5105 = icmp eq i64 %.733.i5104, 0
  br i1 %.734.i5105, label %B392.i.sink.split, label %B392.i

B392.i.sink.split:                                ; preds = %B348.i, %B300.i
  %.sink = phi i64 [ 1, %B300.i ], [ 2, %B348.i ]
  store i64 %.sink, ptr %.984, align 8, !noalias !142
  br label %B392.i

B392.i:                                           ; preds = %B392.i.sink.split, %B348.i
  br i1 %.175.i.i52579251.not, label %B3986, label %B76.if.i.i.lr.ph

B76.if.i.i.lr.ph:                                 ; preds = %B392.i
  %.237.i.i5303 = select i1 %.373.i4953, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i5304 = add i64 %.237.i.i5303, %.250.i4848
  %.258.i.i5320 = mul i64 %.238.i.i5304, %arg.batch.1.3.5.1
  %230 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i5320
  br label %B76.if.i.i

B76.if.i.i:                                       ; preds = %B76.if.i.i.lr.ph, %B76.if.i.i
  %.117.i.i4610.09253 = phi i64 [ 0, %B76.if.i.i.lr.ph ], [ %.188.i.i5367, %B76.if.i.i ]
  %.188.i.i5367 = add nsw i64 %.117.i.i4610.09253, 1
  %231 = getelementptr double, ptr %230, i64 %.117.i.i4610.09253
  %.263.i.i5323 = load double, ptr %231, align 8, !noalias !146
  %232 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.i4610.09253
  %.293.i.i5339 = load i64, ptr %232, align 8, !noalias !146
  %.295.i.i5341 = mul nsw i64 %.293.i.i5339, %arg.shape.0
  %.297.i.i5343 = add nsw i64 %.295.i.i5341, %.5371.09255
  %.311.i.i5350 = icmp slt i64 %.297.i.i5343, 0
  %.312.i.i5351 = select i1 %.311.i.i5350, i64 %arg.batch.5.1.5.0, i64 0
  %233 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i5343
  %.326.i.i5361 = getelementptr double, ptr %233, i64 %.312.i.i5351
  store double %.263.i.i5323, ptr %.326.i.i5361, align 8, !noalias !146
  %exitcond9283.not = icmp eq i64 %arg.batch.1.1.5.0, %.188.i.i5367
  br i1 %exitcond9283.not, label %B3986, label %B76.if.i.i

B3986:                                            ; preds = %B76.if.i.i, %B392.i, %B216.i5513, %B182.i, %B3882, %B3844
  %.5967 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.5533
  %.5968 = load i64, ptr %.5967, align 8
  %.5969.not = icmp eq i64 %.5968, 0
  br i1 %.5969.not, label %B4128, label %B4020

B4020:                                            ; preds = %B3986
  %.6030 = getelementptr i64, ptr %87, i64 %.5371.09255
  %.6031 = load i64, ptr %.6030, align 8
  %.6061 = getelementptr i64, ptr %arg.batch.3.2.4, i64 %.5533
  store i64 %.6031, ptr %.6061, align 8
  store i64 -1, ptr %.5532, align 8
  %.236.i8972 = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !150
  %.293.i8977 = getelementptr double, ptr %88, i64 %.5371.09255
  store double 0.000000e+00, ptr %.293.i8977, align 8, !noalias !150
  %.324.i8979 = load i64, ptr %.323.i8978, align 8, !noalias !150
  %.326.i8980 = icmp eq i64 %.236.i8972, %.324.i8979
  br i1 %.326.i8980, label %B4336, label %B132.i8981

B132.i8981:                                       ; preds = %B4020
  %.359.i8982 = add nsw i64 %.236.i8972, 1
  store i64 %.359.i8982, ptr %arg.batch.4.2.4, align 8, !noalias !150
  store i64 1, ptr %.984, align 8, !noalias !150
  %.438.i8984 = icmp slt i64 %.236.i8972, 0
  %.439.i8985 = select i1 %.438.i8984, i64 %arg.batch.0.2.5.0, i64 0
  %234 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i8972
  %.453.i8986 = getelementptr i64, ptr %234, i64 %.439.i8985
  %.454.i8987 = load i64, ptr %.453.i8986, align 8, !noalias !150
  %.469.i8988 = icmp slt i64 %.454.i8987, 0
  %.470.i8989 = select i1 %.469.i8988, i64 %arg.batch.1.0.5.0, i64 0
  %235 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i8987
  %.484.i8990 = getelementptr i64, ptr %235, i64 %.470.i8989
  %.485.i8991 = load i64, ptr %.484.i8990, align 8, !noalias !150
  store i64 %.236.i8972, ptr %.5532, align 8, !noalias !150
  %.595.i8995 = getelementptr i64, ptr %89, i64 %.5371.09255
  store i64 %.485.i8991, ptr %.595.i8995, align 8, !noalias !150
  store i64 1, ptr %.6030, align 8, !noalias !150
  %.709.i8999 = getelementptr i64, ptr %90, i64 %.5371.09255
  store i64 0, ptr %.709.i8999, align 8, !noalias !150
  br i1 %.8051131.not.i9000, label %B402.i9015, label %B358.if.lr.ph.i9001

B358.if.lr.ph.i9001:                              ; preds = %B132.i8981
  %.867.i9002 = select i1 %.438.i8984, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i9003 = add i64 %.867.i9002, %.236.i8972
  %.888.i9004 = mul i64 %.868.i9003, %arg.batch.0.1.5.1
  %236 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i9004
  %invariant.gep9297 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.5371.09255
  br label %B358.if.i9005

B402.i9015:                                       ; preds = %B358.if.i9005, %B132.i8981
  br i1 %.175.i1134.not.i9016, label %B402.endif.i9034, label %B76.if.i.lr.ph.i9017

B76.if.i.lr.ph.i9017:                             ; preds = %B402.i9015
  %.990.i9018 = load i64, ptr %.595.i8995, align 8, !noalias !150
  %.236.i.i9019 = icmp slt i64 %.990.i9018, 0
  %.237.i.i9020 = select i1 %.236.i.i9019, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i9021 = add i64 %.237.i.i9020, %.990.i9018
  %.258.i.i9022 = mul i64 %.238.i.i9021, %arg.batch.1.3.5.1
  %237 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i9022
  br label %B76.if.i.i9023

B76.if.i.i9023:                                   ; preds = %B76.if.i.i9023, %B76.if.i.lr.ph.i9017
  %.117.i.01135.i9024 = phi i64 [ 0, %B76.if.i.lr.ph.i9017 ], [ %.188.i.i9025, %B76.if.i.i9023 ]
  %.188.i.i9025 = add nsw i64 %.117.i.01135.i9024, 1
  %238 = getelementptr double, ptr %237, i64 %.117.i.01135.i9024
  %.263.i.i9026 = load double, ptr %238, align 8, !noalias !153
  %239 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i9024
  %.293.i.i9027 = load i64, ptr %239, align 8, !noalias !153
  %.295.i.i9028 = mul nsw i64 %.293.i.i9027, %arg.shape.0
  %.297.i.i9029 = add nsw i64 %.295.i.i9028, %.5371.09255
  %.311.i.i9030 = icmp slt i64 %.297.i.i9029, 0
  %.312.i.i9031 = select i1 %.311.i.i9030, i64 %arg.batch.5.1.5.0, i64 0
  %240 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i9029
  %.326.i.i9032 = getelementptr double, ptr %240, i64 %.312.i.i9031
  store double %.263.i.i9026, ptr %.326.i.i9032, align 8, !noalias !153
  %exitcond1142.not.i9033 = icmp eq i64 %.188.i.i9025, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i9033, label %B402.endif.i9034, label %B76.if.i.i9023

B888.i9124:                                       ; preds = %B580.if.i9050
  store double 0.000000e+00, ptr %.1877.i9121, align 8, !noalias !150
  br label %B4336

B358.if.i9005:                                    ; preds = %B358.if.i9005, %B358.if.lr.ph.i9001
  %.747.01132.i9006 = phi i64 [ 0, %B358.if.lr.ph.i9001 ], [ %.818.i9007, %B358.if.i9005 ]
  %.818.i9007 = add nsw i64 %.747.01132.i9006, 1
  %241 = getelementptr double, ptr %236, i64 %.747.01132.i9006
  %.893.i9008 = load double, ptr %241, align 8, !noalias !150
  %.895.i9009 = mul nsw i64 %.747.01132.i9006, %arg.shape.0
  %gep9298 = getelementptr double, ptr %invariant.gep9297, i64 %.895.i9009
  store double %.893.i9008, ptr %gep9298, align 8, !noalias !150
  %exitcond.not.i9014 = icmp eq i64 %.818.i9007, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i9014, label %B402.i9015, label %B358.if.i9005

B402.endif.i9034:                                 ; preds = %B76.if.i.i9023, %B402.i9015
  br i1 %.11171137.not.i9035, label %B580.if.i9050, label %B496.if.lr.ph.i9036

B496.if.lr.ph.i9036:                              ; preds = %B402.endif.i9034
  %.1179.i9037 = select i1 %.438.i8984, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i9038 = add i64 %.1179.i9037, %.236.i8972
  %.1200.i9039 = mul i64 %.1180.i9038, %arg.batch.0.0.5.1
  %242 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i9039
  %invariant.gep9299 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.5371.09255
  br label %B496.if.i9040

B496.if.i9040:                                    ; preds = %B496.if.i9040, %B496.if.lr.ph.i9036
  %.1061.01138.i9041 = phi i64 [ 0, %B496.if.lr.ph.i9036 ], [ %.1130.i9042, %B496.if.i9040 ]
  %.1130.i9042 = add nsw i64 %.1061.01138.i9041, 1
  %243 = getelementptr double, ptr %242, i64 %.1061.01138.i9041
  %.1205.i9043 = load double, ptr %243, align 8, !noalias !150
  %.1207.i9044 = mul nsw i64 %.1061.01138.i9041, %arg.shape.0
  %gep9300 = getelementptr double, ptr %invariant.gep9299, i64 %.1207.i9044
  store double %.1205.i9043, ptr %gep9300, align 8, !noalias !150
  %exitcond1143.not.i9049 = icmp eq i64 %.1130.i9042, %arg.shape.1
  br i1 %exitcond1143.not.i9049, label %B580.if.i9050, label %B496.if.i9040

B580.if.i9050:                                    ; preds = %B496.if.i9040, %B402.endif.i9034
  %invariant.gep.i9051 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5371.09255
  store double 0.000000e+00, ptr %invariant.gep.i9051, align 8, !noalias !150
  %gep.1.i9052 = getelementptr double, ptr %invariant.gep.i9051, i64 %arg.batch.4.0.5.1
  store double 0.000000e+00, ptr %gep.1.i9052, align 8, !noalias !150
  %gep.2.i9054 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.2.idx.i9053
  store double 0.000000e+00, ptr %gep.2.i9054, align 8, !noalias !150
  %gep.3.i9056 = getelementptr i8, ptr %invariant.gep.i9051, i64 %.idx.i8976
  store double 0.000000e+00, ptr %gep.3.i9056, align 8, !noalias !150
  %gep.4.i9058 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.4.idx.i9057
  store double 0.000000e+00, ptr %gep.4.i9058, align 8, !noalias !150
  %gep.5.i9060 = getelementptr i8, ptr %invariant.gep.i9051, i64 %.idx8737
  store double 0.000000e+00, ptr %gep.5.i9060, align 8, !noalias !150
  %gep.6.i9062 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.6.idx.i9061
  store double 0.000000e+00, ptr %gep.6.i9062, align 8, !noalias !150
  %gep.7.i9064 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.7.idx.i9063
  store double 0.000000e+00, ptr %gep.7.i9064, align 8, !noalias !150
  %gep.8.i9066 = getelementptr i8, ptr %invariant.gep.i9051, i64 %.505.idx
  store double 0.000000e+00, ptr %gep.8.i9066, align 8, !noalias !150
  %gep.9.i9068 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.9.idx.i9067
  store double 0.000000e+00, ptr %gep.9.i9068, align 8, !noalias !150
  %gep.10.i9070 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.10.idx.i9069
  store double 0.000000e+00, ptr %gep.10.i9070, align 8, !noalias !150
  %gep.11.i9072 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.11.idx.i9071
  store double 0.000000e+00, ptr %gep.11.i9072, align 8, !noalias !150
  %gep.12.i9074 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.12.idx.i9073
  store double 0.000000e+00, ptr %gep.12.i9074, align 8, !noalias !150
  %gep.13.i9076 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.13.idx.i9075
  store double 0.000000e+00, ptr %gep.13.i9076, align 8, !noalias !150
  %gep.14.i9078 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.14.idx.i9077
  store double 0.000000e+00, ptr %gep.14.i9078, align 8, !noalias !150
  %gep.15.i9080 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.15.idx.i9079
  store double 0.000000e+00, ptr %gep.15.i9080, align 8, !noalias !150
  %gep.16.i9082 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.16.idx.i9081
  store double 0.000000e+00, ptr %gep.16.i9082, align 8, !noalias !150
  %gep.17.i9084 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.17.idx.i9083
  store double 0.000000e+00, ptr %gep.17.i9084, align 8, !noalias !150
  %gep.18.i9086 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.18.idx.i9085
  store double 0.000000e+00, ptr %gep.18.i9086, align 8, !noalias !150
  %gep.19.i9088 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.19.idx.i9087
  store double 0.000000e+00, ptr %gep.19.i9088, align 8, !noalias !150
  %gep.20.i9090 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.20.idx.i9089
  store double 0.000000e+00, ptr %gep.20.i9090, align 8, !noalias !150
  %gep.21.i9092 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.21.idx.i9091
  store double 0.000000e+00, ptr %gep.21.i9092, align 8, !noalias !150
  %gep.22.i9094 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.22.idx.i9093
  store double 0.000000e+00, ptr %gep.22.i9094, align 8, !noalias !150
  %gep.23.i9096 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.23.idx.i9095
  store double 0.000000e+00, ptr %gep.23.i9096, align 8, !noalias !150
  %gep.24.i9098 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.24.idx.i9097
  store double 0.000000e+00, ptr %gep.24.i9098, align 8, !noalias !150
  %gep.25.i9100 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.25.idx.i9099
  store double 0.000000e+00, ptr %gep.25.i9100, align 8, !noalias !150
  %gep.26.i9102 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.26.idx.i9101
  store double 0.000000e+00, ptr %gep.26.i9102, align 8, !noalias !150
  %gep.27.i9104 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.27.idx.i9103
  store double 0.000000e+00, ptr %gep.27.i9104, align 8, !noalias !150
  %gep.28.i9106 = getelementptr i8, ptr %invariant.gep.i9051, i64 %gep.28.idx.i9105
  store double 0.000000e+00, ptr %gep.28.i9106, align 8, !noalias !150
  %.1455.i9107 = load double, ptr %arg.batch.2.4, align 8, !noalias !150
  %.1516.i9108 = load i64, ptr %.595.i8995, align 8, !noalias !150
  %.1531.i9109 = icmp slt i64 %.1516.i9108, 0
  %.1532.i9110 = select i1 %.1531.i9109, i64 %arg.batch.1.2.5.0, i64 0
  %244 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i9108
  %.1546.i9111 = getelementptr double, ptr %244, i64 %.1532.i9110
  %.1547.i9112 = load double, ptr %.1546.i9111, align 8, !noalias !150
  store double %.1455.i9107, ptr %invariant.gep.i9051, align 8, !noalias !150
  %.1656.i9115 = getelementptr double, ptr %91, i64 %.5371.09255
  store double %.1547.i9112, ptr %.1656.i9115, align 8, !noalias !150
  store double 1.000000e+00, ptr %.293.i8977, align 8, !noalias !150
  %.1767.i9117 = getelementptr double, ptr %92, i64 %.5371.09255
  store double 0xFFF0000000000000, ptr %.1767.i9117, align 8, !noalias !150
  %.1822.i9119 = getelementptr double, ptr %93, i64 %.5371.09255
  store double 0x7FF0000000000000, ptr %.1822.i9119, align 8, !noalias !150
  %.1877.i9121 = getelementptr double, ptr %94, i64 %.5371.09255
  %.1878.i9122 = load double, ptr %.1877.i9121, align 8, !noalias !150
  %.1880.i9123 = fcmp ueq double %.1878.i9122, 0xFFF0000000000000
  br i1 %.1880.i9123, label %B4336, label %B888.i9124

B4128:                                            ; preds = %B3986
  %.6257 = getelementptr double, ptr %95, i64 %.5371.09255
  %.6258 = load double, ptr %.6257, align 8
  %.6260 = fcmp ult double %.6258, 1.500000e+01
  br i1 %.6260, label %B4336, label %B4176

B4176:                                            ; preds = %B4128
  %.6304 = load double, ptr %.6303, align 8
  %.6358 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5371.09255
  %.6359 = load double, ptr %.6358, align 8
  %.6360 = fsub double %.6304, %.6359
  %.6414 = getelementptr double, ptr %98, i64 %.5371.09255
  %.6415 = load double, ptr %.6414, align 8
  %.6417 = fmul double %.6415, 5.000000e+03
  %.6418 = fcmp ogt double %.6360, %.6417
  br i1 %.6418, label %B4336, label %B4312

B4312:                                            ; preds = %B4176
  store double 0.000000e+00, ptr %.6257, align 8
  br label %B4336

B4336:                                            ; preds = %B888.i9124, %B4020, %B580.if.i9050, %B4176, %B4312, %B4128
  %budget.7.4 = phi i64 [ %budget.5.29257, %B4128 ], [ 0, %B4176 ], [ %budget.5.29257, %B4312 ], [ %budget.5.29257, %B580.if.i9050 ], [ %budget.5.29257, %B4020 ], [ %budget.5.29257, %B888.i9124 ]
  %.6546 = load i64, ptr %.5532, align 8
  %.6547 = icmp sgt i64 %.6546, -1
  br i1 %.6547, label %B4374, label %B4453

B4374:                                            ; preds = %B4336
  %.6550 = add nsw i64 %active.5.29258, 1
  %.310.i5794 = getelementptr double, ptr %99, i64 %.5371.09255
  %.311.i5795 = load double, ptr %.310.i5794, align 8, !noalias !157
  %.313.i5796 = fcmp ogt double %.311.i5795, 0.000000e+00
  br i1 %.313.i5796, label %B176.i, label %B174.i5797

B174.i5797:                                       ; preds = %B4374
  %.177.i5720 = mul i64 %.6546, %arg.batch.3.3.5.1
  %.181.i5724 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.177.i5720
  %.182.i5725 = load i64, ptr %.181.i5724, align 8, !noalias !157
  %.193.i5618.0 = and i64 %.182.i5725, 127
  %.223.i5733 = sub nsw i64 128, %.193.i5618.0
  %.11.i.i5741 = tail call i64 @llvm.smin.i64(i64 %.223.i5733, i64 %.5669)
  %.324.i5800 = sitofp i64 %.11.i.i5741 to double
  br label %B176.i

B176.i:                                           ; preds = %B4374, %B174.i5797
  %"$phi176.0.2.i.0" = phi double [ %.324.i5800, %B174.i5797 ], [ 1.000000e+00, %B4374 ]
  %.382.i5850 = getelementptr double, ptr %100, i64 %.5371.09255
  store double %"$phi176.0.2.i.0", ptr %.382.i5850, align 8, !noalias !157
  %.111.i.i5979 = getelementptr i64, ptr %101, i64 %.5371.09255
  %.112.i.i5980 = load i64, ptr %.111.i.i5979, align 8, !noalias !161
  %.169.i.i6018 = getelementptr double, ptr %102, i64 %.5371.09255
  %.170.i.i6019 = load double, ptr %.169.i.i6018, align 8, !noalias !161
  %.224.i.i6056 = getelementptr double, ptr %103, i64 %.5371.09255
  store double %.170.i.i6019, ptr %.224.i.i6056, align 8, !noalias !161
  %.237.i.i6062 = icmp slt i64 %.112.i.i5980, %arg.batch.2.5.0
  br i1 %.237.i.i6062, label %B134.i.i6075, label %B4453

B134.i.i6075:                                     ; preds = %B176.i
  %.253.i.i6084 = icmp slt i64 %.112.i.i5980, 0
  %.254.i.i6085 = select i1 %.253.i.i6084, i64 %arg.batch.2.5.0, i64 0
  %245 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i.i5980
  %.268.i.i6095 = getelementptr double, ptr %245, i64 %.254.i.i6085
  %.269.i.i6096 = load double, ptr %.268.i.i6095, align 8, !noalias !161
  %.328.i.i6136 = load double, ptr %.169.i.i6018, align 8, !noalias !161
  %.10.i.i.i6141 = fcmp olt double %.328.i.i6136, %.269.i.i6096
  %.11.i.i.i6142 = select i1 %.10.i.i.i6141, double %.328.i.i6136, double %.269.i.i6096
  store double %.11.i.i.i6142, ptr %.224.i.i6056, align 8, !noalias !161
  br label %B4453

B4426:                                            ; preds = %B4453, %B3628
  %budget.4.2 = phi i64 [ %.950, %B3628 ], [ %budget.6.3, %B4453 ]
  %active.8.2 = phi i64 [ %active.9.1.mux, %B3628 ], [ %active.6.3, %B4453 ]
  %.6637 = icmp sgt i64 %active.8.2, 0
  %.6656 = icmp sgt i64 %budget.4.2, 0
  %or.cond8804 = select i1 %.6637, i1 %.6656, i1 false
  br i1 %or.cond8804, label %B422, label %B4452

B4452:                                            ; preds = %B4426, %B394
  %active.10.0 = phi i64 [ %active.4.0.lcssa, %B394 ], [ %active.8.2, %B4426 ]
  br i1 %.606, label %B4452.endif, label %B80.if.i1734.lr.ph

B80.if.i1734.lr.ph:                               ; preds = %B4452
  %.idx = mul i64 %arg.batch.4.0.5.1, 168
  %246 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx
  %.idx8735 = mul i64 %arg.batch.4.0.5.1, 176
  %247 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8735
  %.697.i1507 = add nsw i64 %arg.shape.2, -1
  %.idx8736 = mul i64 %arg.batch.4.0.5.1, 152
  %248 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8736
  br label %B80.if.i1734

B126.i1167:                                       ; preds = %B80.if.i1734
  %.318.i1215 = getelementptr double, ptr %246, i64 %.105.i1019.09263
  %.319.i1216 = load double, ptr %.318.i1215, align 8, !noalias !165
  %.5.i.i1217 = fptosi double %.319.i1216 to i64
  %.397.i1266 = getelementptr double, ptr %247, i64 %.105.i1019.09263
  %.398.i1267 = load double, ptr %.397.i1266, align 8, !noalias !165
  %.5.i1.i1268 = fptosi double %.398.i1267 to i64
  %.472.i1314 = mul i64 %.258.i1160, %arg.batch.3.3.5.1
  %.476.i1318 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.472.i1314
  %.477.i1319 = load i64, ptr %.476.i1318, align 8, !noalias !165
  %.478.i1320 = add nsw i64 %.477.i1319, %.5.i.i1217
  store i64 %.478.i1320, ptr %.476.i1318, align 8, !noalias !165
  %.584.i1411 = getelementptr i8, ptr %.476.i1318, i64 24
  %.585.i1412 = load i64, ptr %.584.i1411, align 8, !noalias !165
  %.586.i1413 = add nsw i64 %.585.i1412, %.5.i1.i1268
  store i64 %.586.i1413, ptr %.584.i1411, align 8, !noalias !165
  %.694.i1504 = getelementptr i8, ptr %.476.i1318, i64 8
  %.695.i1505 = load i64, ptr %.694.i1504, align 8, !noalias !165
  %.698.i1508 = add nsw i64 %.5.i1.i1268, %.5.i.i1217
  %.699.i1509 = mul nsw i64 %.698.i1508, %.697.i1507
  %.700.i1510 = add nsw i64 %.699.i1509, %.5.i.i1217
  %.701.i1511 = add nsw i64 %.700.i1510, %.695.i1505
  store i64 %.701.i1511, ptr %.694.i1504, align 8, !noalias !165
  store double 0.000000e+00, ptr %.318.i1215, align 8, !noalias !165
  store double 0.000000e+00, ptr %.397.i1266, align 8, !noalias !165
  %.923.i1689 = getelementptr double, ptr %248, i64 %.105.i1019.09263
  %.924.i1690 = load double, ptr %.923.i1689, align 8, !noalias !165
  %.926.i1692 = sitofp i64 %.698.i1508 to double
  %.927.i1693 = fsub double %.924.i1690, %.926.i1692
  store double %.927.i1693, ptr %.923.i1689, align 8, !noalias !165
  br label %B502.i1164

B502.i1164:                                       ; preds = %B126.i1167, %B80.if.i1734
  %.163.i1093 = icmp sgt i64 %.108.i1020.09264, 1
  br i1 %.163.i1093, label %B80.if.i1734, label %B4452.endif

B80.if.i1734:                                     ; preds = %B80.if.i1734.lr.ph, %B502.i1164
  %.108.i1020.09264 = phi i64 [ %storemerge, %B80.if.i1734.lr.ph ], [ %.172.i1739, %B502.i1164 ]
  %.105.i1019.09263 = phi i64 [ 0, %B80.if.i1734.lr.ph ], [ %.176.i1742, %B502.i1164 ]
  %.172.i1739 = add nsw i64 %.108.i1020.09264, -1
  %.176.i1742 = add nsw i64 %.105.i1019.09263, 1
  %249 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i1019.09263
  %.258.i1160 = load i64, ptr %249, align 8, !noalias !165
  %.263.i1163 = icmp sgt i64 %.258.i1160, -1
  br i1 %.263.i1163, label %B126.i1167, label %B502.i1164

B4453:                                            ; preds = %B176.i, %B134.i.i6075, %B4336, %B3670.if
  %budget.6.3 = phi i64 [ %budget.5.29257, %B3670.if ], [ %budget.7.4, %B4336 ], [ %budget.7.4, %B134.i.i6075 ], [ %budget.7.4, %B176.i ]
  %active.6.3 = phi i64 [ %active.5.29258, %B3670.if ], [ %active.5.29258, %B4336 ], [ %.6550, %B134.i.i6075 ], [ %.6550, %B176.i ]
  %.5434 = icmp sgt i64 %.5374.09256, 1
  br i1 %.5434, label %B3670.if, label %B4426

B254.if:                                          ; preds = %B254.if.lr.ph, %B340
  %active.4.09135 = phi i64 [ 0, %B254.if.lr.ph ], [ %.901, %B340 ]
  %.595.09134 = phi i64 [ %storemerge, %B254.if.lr.ph ], [ %.659, %B340 ]
  %.592.09133 = phi i64 [ 0, %B254.if.lr.ph ], [ %.663, %B340 ]
  %.659 = add nsw i64 %.595.09134, -1
  %.663 = add nsw i64 %.592.09133, 1
  %250 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.592.09133
  %.745 = load i64, ptr %250, align 8
  %.746 = icmp slt i64 %.745, 0
  br i1 %.746, label %B296, label %B340

B1388.if:                                         ; preds = %B1356, %B1612
  %.1972.09154 = phi i64 [ %.2041, %B1612 ], [ 1, %B1356 ]
  %.2041 = add i64 %.1972.09154, 1
  %251 = getelementptr i64, ptr %arg.code.4, i64 %.1972.09154
  %252 = getelementptr i8, ptr %251, i64 104
  %.2100 = load i64, ptr %252, align 8
  %.2145 = inttoptr i64 %.2100 to ptr
  tail call void %.2145(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.2176 = load i64, ptr %arg.code.4, align 8
  %.2182 = mul nsw i64 %.2041, %.397
  %.2226 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2182
  %.2227 = inttoptr i64 %.2176 to ptr
  tail call void %.2227(ptr %.505, ptr %.2201, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.2226)
  br i1 %.544, label %B1576, label %B1612

B1758.if:                                         ; preds = %B1614, %B1844
  %looked.4.29160 = phi i1 [ %"$phi1844.1.2.2", %B1844 ], [ %spec.select8805, %B1614 ]
  %good.2.19159 = phi i1 [ %"$phi1802.1.2.2", %B1844 ], [ false, %B1614 ]
  %.2434.09158 = phi i64 [ %.2496, %B1844 ], [ %storemerge, %B1614 ]
  %.2431.09157 = phi i64 [ %.2500, %B1844 ], [ 0, %B1614 ]
  %.2496 = add nsw i64 %.2434.09158, -1
  %.2500 = add nsw i64 %.2431.09157, 1
  br i1 %good.2.19159, label %B1802, label %B1766

B1920.if:                                         ; preds = %B1918.preheader, %B2480
  %doubted.3.29171 = phi i1 [ %doubted.4.3, %B2480 ], [ false, %B1918.preheader ]
  %within.3.29170 = phi i1 [ %within.4.3, %B2480 ], [ false, %B1918.preheader ]
  %wanted.3.29169 = phi i1 [ %wanted.4.3, %B2480 ], [ false, %B1918.preheader ]
  %.2801.09168 = phi i64 [ %.2873, %B2480 ], [ %storemerge, %B1918.preheader ]
  %.2798.09167 = phi i64 [ %.2877, %B2480 ], [ 0, %B1918.preheader ]
  %.2873 = add nsw i64 %.2801.09168, -1
  %.2877 = add nsw i64 %.2798.09167, 1
  %.2964 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2798.09167
  %.2965 = load i64, ptr %.2964, align 8
  %.3019 = getelementptr i64, ptr %36, i64 %.2798.09167
  %.3020 = load i64, ptr %.3019, align 8
  %.3080 = getelementptr double, ptr %37, i64 %.2798.09167
  store double 0.000000e+00, ptr %.3080, align 8
  %.3083 = icmp sgt i64 %.2965, -1
  br i1 %.3083, label %B2020, label %B2480

B46.i:                                            ; preds = %B2058
  %.120.i1842 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i1811
  %.121.i1843 = load i64, ptr %.120.i1842, align 8, !noalias !53
  %.122.i1844 = icmp eq i64 %.121.i1843, 0
  br i1 %.122.i1844, label %B80.i1848, label %B2158

B80.i1848:                                        ; preds = %B46.i
  store i64 %.5.i, ptr %.120.i1842, align 8, !noalias !53
  br label %B2158

B2884.if:                                         ; preds = %B2836
  %.4362 = load i64, ptr %104, align 8
  %.4407 = inttoptr i64 %.4362 to ptr
  tail call void %.4407(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4438 = load i64, ptr %arg.code.4, align 8
  %.4488 = inttoptr i64 %.4438 to ptr
  tail call void %.4488(ptr %.505, ptr %.4462, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4487)
  %.4362.1 = load i64, ptr %105, align 8
  %.4407.1 = inttoptr i64 %.4362.1 to ptr
  tail call void %.4407.1(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4438.1 = load i64, ptr %arg.code.4, align 8
  %.4488.1 = inttoptr i64 %.4438.1 to ptr
  tail call void %.4488.1(ptr %.505, ptr %.4462, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4487.1)
  %.4362.2 = load i64, ptr %106, align 8
  %.4407.2 = inttoptr i64 %.4362.2 to ptr
  tail call void %.4407.2(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4438.2 = load i64, ptr %arg.code.4, align 8
  %.4488.2 = inttoptr i64 %.4438.2 to ptr
  tail call void %.4488.2(ptr %.505, ptr %.4462, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4487.2)
  %.4526 = load i64, ptr %.4525, align 8
  %.4571 = inttoptr i64 %.4526 to ptr
  tail call void %.4571(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4603 = load i64, ptr %.4602, align 8
  %.4648 = inttoptr i64 %.4603 to ptr
  tail call void %.4648(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.606, label %B3252, label %B64.if.i3453

B3670.if:                                         ; preds = %B3628, %B4453
  %active.5.29258 = phi i64 [ %active.6.3, %B4453 ], [ 0, %B3628 ]
  %budget.5.29257 = phi i64 [ %budget.6.3, %B4453 ], [ %.950, %B3628 ]
  %.5374.09256 = phi i64 [ %.5443, %B4453 ], [ %storemerge, %B3628 ]
  %.5371.09255 = phi i64 [ %.5447, %B4453 ], [ 0, %B3628 ]
  %.5443 = add nsw i64 %.5374.09256, -1
  %.5447 = add nsw i64 %.5371.09255, 1
  %.5532 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5371.09255
  %.5533 = load i64, ptr %.5532, align 8
  %.5538 = icmp slt i64 %.5533, 0
  br i1 %.5538, label %B4453, label %B3718

B4452.endif:                                      ; preds = %B502.i1164, %B4452
  store i64 %active.10.0, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64)

define dso_local noundef i32 @ask(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.role, i64 %arg.n, ptr readnone %arg.given.0.0, ptr readnone %arg.given.0.1, i64 %arg.given.0.2, i64 %arg.given.0.3, ptr readonly %arg.given.0.4, i64 %arg.given.0.5.0, i64 %arg.given.0.6.0, ptr readnone %arg.given.1.0, ptr readnone %arg.given.1.1, i64 %arg.given.1.2, i64 %arg.given.1.3, ptr readonly %arg.given.1.4, i64 %arg.given.1.5.0, i64 %arg.given.1.6.0, ptr readnone %arg.given.2.0, ptr readnone %arg.given.2.1, i64 %arg.given.2.2, i64 %arg.given.2.3, ptr %arg.given.2.4, i64 %arg.given.2.5.0, i64 %arg.given.2.6.0, ptr readnone %arg.given.3.0, ptr readnone %arg.given.3.1, i64 %arg.given.3.2, i64 %arg.given.3.3, ptr %arg.given.3.4, i64 %arg.given.3.5.0, i64 %arg.given.3.6.0, ptr readnone %arg.pieces.0.0, ptr readnone %arg.pieces.0.1, i64 %arg.pieces.0.2, i64 %arg.pieces.0.3, ptr readonly %arg.pieces.0.4, i64 %arg.pieces.0.5.0, i64 %arg.pieces.0.6.0, ptr readnone %arg.pieces.1.0, ptr readnone %arg.pieces.1.1, i64 %arg.pieces.1.2, i64 %arg.pieces.1.3, ptr readonly %arg.pieces.1.4, i64 %arg.pieces.1.5.0, i64 %arg.pieces.1.5.1, i64 %arg.pieces.1.6.0, i64 %arg.pieces.1.6.1, ptr readnone %arg.arrays.0.0, ptr readnone %arg.arrays.0.1, i64 %arg.arrays.0.2, i64 %arg.arrays.0.3, ptr %arg.arrays.0.4, i64 %arg.arrays.0.5.0, i64 %arg.arrays.0.6.0, ptr readnone %arg.arrays.1.0, ptr readnone %arg.arrays.1.1, i64 %arg.arrays.1.2, i64 %arg.arrays.1.3, ptr %arg.arrays.1.4, i64 %arg.arrays.1.5.0, i64 %arg.arrays.1.6.0, ptr readnone %arg.arrays.2.0, ptr readnone %arg.arrays.2.1, i64 %arg.arrays.2.2, i64 %arg.arrays.2.3, ptr %arg.arrays.2.4, i64 %arg.arrays.2.5.0, i64 %arg.arrays.2.6.0, ptr readnone %arg.arrays.3.0, ptr readnone %arg.arrays.3.1, i64 %arg.arrays.3.2, i64 %arg.arrays.3.3, ptr %arg.arrays.3.4, i64 %arg.arrays.3.5.0, i64 %arg.arrays.3.6.0, ptr readnone %arg.out.0, ptr readnone %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.5.1, i64 %arg.out.6.0, i64 %arg.out.6.1) local_unnamed_addr {
entry:
  %.268604.not = icmp slt i64 %arg.given.0.5.0, 1
  br i1 %.268604.not, label %B532, label %B104.if.lr.ph

B104.if.lr.ph:                                    ; preds = %entry
  %.535598.not = icmp slt i64 %arg.pieces.0.5.0, 1
  %.722 = getelementptr i8, ptr %arg.code.4, i64 8
  %.788 = icmp slt i64 %arg.role, 0
  %.789 = select i1 %.788, i64 %arg.code.5.0, i64 0
  %0 = getelementptr i64, ptr %arg.code.4, i64 %arg.role
  %.803 = getelementptr i64, ptr %0, i64 %.789
  %.946601.not = icmp slt i64 %arg.out.5.1, 1
  %.988 = icmp eq i64 %arg.role, 3
  %"$phi516.2.2.2.in.v" = select i1 %.988, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4
  br label %B104.if

B104.loopexit:                                    ; preds = %B460.if, %B344
  %exitcond609.not = icmp eq i64 %.281, %arg.given.0.5.0
  br i1 %exitcond609.not, label %B532, label %B104.if

B154:                                             ; preds = %B104.if
  br i1 %.535598.not, label %B270, label %B226.if.lr.ph

B226.if.lr.ph:                                    ; preds = %B154
  %.596 = icmp slt i64 %.404, 0
  %.597 = select i1 %.596, i64 %arg.pieces.1.5.0, i64 0
  %.598 = add i64 %.597, %.404
  %.618 = mul i64 %.598, %arg.pieces.1.5.1
  %1 = getelementptr double, ptr %arg.pieces.1.4, i64 %.618
  br label %B226.if

B270:                                             ; preds = %B226.if, %B154
  %.723 = load i64, ptr %.722, align 8
  %.726 = mul nsw i64 %.210.0605, %arg.n
  %.745 = getelementptr double, ptr %arg.given.3.4, i64 %.726
  %.771 = inttoptr i64 %.723 to ptr
  tail call void %.771(ptr nonnull %arg.given.2.4, ptr %.745, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.2.4)
  br label %B344

B344:                                             ; preds = %B270, %B104.if
  %piece.3.1 = phi i64 [ %.404, %B270 ], [ %piece.2.0607, %B104.if ]
  %.804 = load i64, ptr %.803, align 8
  %.807 = mul nsw i64 %.210.0605, %arg.n
  %.826 = getelementptr double, ptr %arg.given.3.4, i64 %.807
  %.852 = inttoptr i64 %.804 to ptr
  tail call void %.852(ptr nonnull %arg.given.2.4, ptr %.826, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4)
  br i1 %.946601.not, label %B104.loopexit, label %B460.if.lr.ph

B460.if.lr.ph:                                    ; preds = %B344
  %.1108 = mul i64 %.210.0605, %arg.out.5.1
  %2 = getelementptr double, ptr %arg.out.4, i64 %.1108
  br label %B460.if

B532:                                             ; preds = %B104.loopexit, %entry
  store ptr null, ptr %retptr, align 8
  ret i32 0

B104.if:                                          ; preds = %B104.if.lr.ph, %B104.loopexit
  %piece.2.0607 = phi i64 [ -1, %B104.if.lr.ph ], [ %piece.3.1, %B104.loopexit ]
  %.210.0605 = phi i64 [ 0, %B104.if.lr.ph ], [ %.281, %B104.loopexit ]
  %.281 = add nsw i64 %.210.0605, 1
  %3 = getelementptr double, ptr %arg.given.0.4, i64 %.210.0605
  %.343 = load double, ptr %3, align 8
  store double %.343, ptr %arg.given.2.4, align 8
  %4 = getelementptr i64, ptr %arg.given.1.4, i64 %.210.0605
  %.404 = load i64, ptr %4, align 8
  %.406.not = icmp eq i64 %.404, %piece.2.0607
  br i1 %.406.not, label %B344, label %B154

B226.if:                                          ; preds = %B226.if.lr.ph, %B226.if
  %.479.0599 = phi i64 [ 0, %B226.if.lr.ph ], [ %.548, %B226.if ]
  %.548 = add nsw i64 %.479.0599, 1
  %5 = getelementptr double, ptr %1, i64 %.479.0599
  %.623 = load double, ptr %5, align 8
  %6 = getelementptr i64, ptr %arg.pieces.0.4, i64 %.479.0599
  %.653 = load i64, ptr %6, align 8
  %.667 = icmp slt i64 %.653, 0
  %.668 = select i1 %.667, i64 %arg.arrays.0.5.0, i64 0
  %7 = getelementptr double, ptr %arg.arrays.0.4, i64 %.653
  %.682 = getelementptr double, ptr %7, i64 %.668
  store double %.623, ptr %.682, align 8
  %exitcond.not = icmp eq i64 %arg.pieces.0.5.0, %.548
  br i1 %exitcond.not, label %B270, label %B226.if

B460.if:                                          ; preds = %B460.if.lr.ph, %B460.if
  %.890.0602 = phi i64 [ 0, %B460.if.lr.ph ], [ %.959, %B460.if ]
  %.959 = add nsw i64 %.890.0602, 1
  %"$phi516.2.2.2.in" = getelementptr double, ptr %"$phi516.2.2.2.in.v", i64 %.890.0602
  %"$phi516.2.2.2" = load double, ptr %"$phi516.2.2.2.in", align 8
  %8 = getelementptr double, ptr %2, i64 %.890.0602
  store double %"$phi516.2.2.2", ptr %8, align 8
  %exitcond608.not = icmp eq i64 %arg.out.5.1, %.959
  br i1 %exitcond608.not, label %B104.loopexit, label %B460.if
}


!0 = !{!1}
!1 = distinct !{!1, !2, !"_ZN12clpt_control6native9for_numba4takeB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN12clpt_control6native9for_numba4takeB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!3 = !{!4, !6, !1}
!4 = distinct !{!4, !5, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!5 = distinct !{!5, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!6 = distinct !{!6, !5, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!7 = !{!8, !10}
!8 = distinct !{!8, !9, !"_ZN12clpt_control6native9for_numba6decideB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!9 = distinct !{!9, !"_ZN12clpt_control6native9for_numba6decideB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!10 = distinct !{!10, !9, !"_ZN12clpt_control6native9for_numba6decideB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
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
!57 = distinct !{!57, !58, !"_ZN12clpt_control6native9for_numba6passesB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!58 = distinct !{!58, !"_ZN12clpt_control6native9for_numba6passesB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!59 = distinct !{!59, !58, !"_ZN12clpt_control6native9for_numba6passesB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!60 = !{!61, !63, !57, !59}
!61 = distinct !{!61, !62, !"_ZN12clpt_control6native9for_numba6passedB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!62 = distinct !{!62, !"_ZN12clpt_control6native9for_numba6passedB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!63 = distinct !{!63, !62, !"_ZN12clpt_control6native9for_numba6passedB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!64 = !{!65, !67}
!65 = distinct !{!65, !66, !"_ZN12clpt_control6native9for_numba5doubtB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!66 = distinct !{!66, !"_ZN12clpt_control6native9for_numba5doubtB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!67 = distinct !{!67, !66, !"_ZN12clpt_control6native9for_numba5doubtB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!68 = !{!69, !65, !67}
!69 = distinct !{!69, !70, !"_ZN12clpt_control6native9for_numba5againB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!70 = distinct !{!70, !"_ZN12clpt_control6native9for_numba5againB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!71 = !{!72}
!72 = distinct !{!72, !73, !"_ZN12clpt_control6native9for_numba5crossB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!73 = distinct !{!73, !"_ZN12clpt_control6native9for_numba5crossB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!74 = !{!75, !77, !78, !80, !72}
!75 = distinct !{!75, !76, !"_ZN12clpt_control6native9for_numba7betweenB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!76 = distinct !{!76, !"_ZN12clpt_control6native9for_numba7betweenB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!77 = distinct !{!77, !76, !"_ZN12clpt_control6native9for_numba7betweenB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!78 = distinct !{!78, !79, !"_ZN12clpt_control6native9for_numba11look_withinB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!79 = distinct !{!79, !"_ZN12clpt_control6native9for_numba11look_withinB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!80 = distinct !{!80, !79, !"_ZN12clpt_control6native9for_numba11look_withinB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!81 = !{!78, !80, !72}
!82 = !{!83, !85, !72}
!83 = distinct !{!83, !84, !"_ZN12clpt_control6native9for_numba6passedB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!84 = distinct !{!84, !"_ZN12clpt_control6native9for_numba6passedB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!85 = distinct !{!85, !84, !"_ZN12clpt_control6native9for_numba6passedB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!86 = !{!87, !72}
!87 = distinct !{!87, !88, !"_ZN12clpt_control6native9for_numba5againB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!88 = distinct !{!88, !"_ZN12clpt_control6native9for_numba5againB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!89 = !{!90}
!90 = distinct !{!90, !91, !"_ZN12clpt_control6native9for_numba5watchB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!91 = distinct !{!91, !"_ZN12clpt_control6native9for_numba5watchB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!92 = !{!93, !90}
!93 = distinct !{!93, !94, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!94 = distinct !{!94, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!95 = !{!96, !98, !90}
!96 = distinct !{!96, !97, !"_ZN12clpt_control6native9for_numba11look_withinB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!97 = distinct !{!97, !"_ZN12clpt_control6native9for_numba11look_withinB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!98 = distinct !{!98, !97, !"_ZN12clpt_control6native9for_numba11look_withinB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!99 = !{!100, !102, !96, !98, !90}
!100 = distinct !{!100, !101, !"_ZN12clpt_control6native9for_numba7betweenB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!101 = distinct !{!101, !"_ZN12clpt_control6native9for_numba7betweenB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!102 = distinct !{!102, !101, !"_ZN12clpt_control6native9for_numba7betweenB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!103 = !{!104}
!104 = distinct !{!104, !105, !"_ZN12clpt_control6native9for_numba6sampleB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!105 = distinct !{!105, !"_ZN12clpt_control6native9for_numba6sampleB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!106 = !{!107, !109, !104}
!107 = distinct !{!107, !108, !"_ZN12clpt_control6native9for_numba7betweenB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!108 = distinct !{!108, !"_ZN12clpt_control6native9for_numba7betweenB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!109 = distinct !{!109, !108, !"_ZN12clpt_control6native9for_numba7betweenB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!110 = !{!111, !113}
!111 = distinct !{!111, !112, !"_ZN12clpt_control6native9for_numba11decide_anewB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!112 = distinct !{!112, !"_ZN12clpt_control6native9for_numba11decide_anewB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!113 = distinct !{!113, !112, !"_ZN12clpt_control6native9for_numba11decide_anewB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!114 = !{!115, !111, !113}
!115 = distinct !{!115, !116, !"_ZN12clpt_control6native9for_numba4failB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29: %retptr"}
!116 = distinct !{!116, !"_ZN12clpt_control6native9for_numba4failB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29"}
!117 = !{!118, !120}
!118 = distinct !{!118, !119, !"_ZN12clpt_control6native9for_numba6at_endB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!119 = distinct !{!119, !"_ZN12clpt_control6native9for_numba6at_endB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!120 = distinct !{!120, !121, !"_ZN12clpt_control6native9for_numba4leapB3v37B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!121 = distinct !{!121, !"_ZN12clpt_control6native9for_numba4leapB3v37B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!122 = !{!120}
!123 = !{!124, !126, !120}
!124 = distinct !{!124, !125, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!125 = distinct !{!125, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!126 = distinct !{!126, !125, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!127 = !{!128, !120}
!128 = distinct !{!128, !129, !"_ZN12clpt_control6native9for_numba6at_endB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!129 = distinct !{!129, !"_ZN12clpt_control6native9for_numba6at_endB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!130 = !{!131, !120}
!131 = distinct !{!131, !132, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!132 = distinct !{!132, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!133 = !{!134, !120}
!134 = distinct !{!134, !135, !"_ZN12clpt_control6native9for_numba6at_endB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!135 = distinct !{!135, !"_ZN12clpt_control6native9for_numba6at_endB3v38B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!136 = !{!137, !120}
!137 = distinct !{!137, !138, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!138 = distinct !{!138, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!139 = !{!140}
!140 = distinct !{!140, !141, !"_ZN12clpt_control6native9for_numba4failB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29: %retptr"}
!141 = distinct !{!141, !"_ZN12clpt_control6native9for_numba4failB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29"}
!142 = !{!143, !145}
!143 = distinct !{!143, !144, !"_ZN12clpt_control6native9for_numba5enterB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!144 = distinct !{!144, !"_ZN12clpt_control6native9for_numba5enterB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!145 = distinct !{!145, !144, !"_ZN12clpt_control6native9for_numba5enterB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!146 = !{!147, !149, !143, !145}
!147 = distinct !{!147, !148, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!148 = distinct !{!148, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!149 = distinct !{!149, !148, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!150 = !{!151}
!151 = distinct !{!151, !152, !"_ZN12clpt_control6native9for_numba4takeB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!152 = distinct !{!152, !"_ZN12clpt_control6native9for_numba4takeB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!153 = !{!154, !156, !151}
!154 = distinct !{!154, !155, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!155 = distinct !{!155, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!156 = distinct !{!156, !155, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!157 = !{!158, !160}
!158 = distinct !{!158, !159, !"_ZN12clpt_control6native9for_numba10look_againB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!159 = distinct !{!159, !"_ZN12clpt_control6native9for_numba10look_againB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!160 = distinct !{!160, !159, !"_ZN12clpt_control6native9for_numba10look_againB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!161 = !{!162, !164, !158, !160}
!162 = distinct !{!162, !163, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!163 = distinct !{!163, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!164 = distinct !{!164, !163, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!165 = !{!166, !168}
!166 = distinct !{!166, !167, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!167 = distinct !{!167, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!168 = distinct !{!168, !167, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}

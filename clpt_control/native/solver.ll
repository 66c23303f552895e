; sha256 dfb009208939f4c0f15264649b376c7c26c5f225f16671e79ca8d7a95cea39c5

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
  %.293.i = getelementptr double, ptr %0, i64 %.589.09176
  store double 0.000000e+00, ptr %.293.i, align 8, !noalias !0
  %.324.i = load i64, ptr %.323.i, align 8, !noalias !0
  %.326.i8847 = icmp eq i64 %.236.i, %.324.i
  br i1 %.326.i8847, label %B340, label %B132.i

B132.i:                                           ; preds = %B296
  %.359.i8848 = add nsw i64 %.236.i, 1
  store i64 %.359.i8848, ptr %arg.batch.4.2.4, align 8, !noalias !0
  store i64 1, ptr %.418.i, align 8, !noalias !0
  %.438.i = icmp slt i64 %.236.i, 0
  %.439.i = select i1 %.438.i, i64 %arg.batch.0.2.5.0, i64 0
  %8 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i
  %.453.i8849 = getelementptr i64, ptr %8, i64 %.439.i
  %.454.i8850 = load i64, ptr %.453.i8849, align 8, !noalias !0
  %.469.i = icmp slt i64 %.454.i8850, 0
  %.470.i = select i1 %.469.i, i64 %arg.batch.1.0.5.0, i64 0
  %9 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i8850
  %.484.i8851 = getelementptr i64, ptr %9, i64 %.470.i
  %.485.i = load i64, ptr %.484.i8851, align 8, !noalias !0
  %.540.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.589.09176
  store i64 %.236.i, ptr %.540.i, align 8, !noalias !0
  %.595.i = getelementptr i64, ptr %1, i64 %.589.09176
  store i64 %.485.i, ptr %.595.i, align 8, !noalias !0
  %.654.i = getelementptr i64, ptr %2, i64 %.589.09176
  store i64 1, ptr %.654.i, align 8, !noalias !0
  %.709.i = getelementptr i64, ptr %3, i64 %.589.09176
  store i64 0, ptr %.709.i, align 8, !noalias !0
  br i1 %.8051131.not.i, label %B402.i, label %B358.if.lr.ph.i

B358.if.lr.ph.i:                                  ; preds = %B132.i
  %.867.i = select i1 %.438.i, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i = add i64 %.867.i, %.236.i
  %.888.i = mul i64 %.868.i, %arg.batch.0.1.5.1
  %10 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i
  %invariant.gep9325 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.589.09176
  br label %B358.if.i

B402.i:                                           ; preds = %B358.if.i, %B132.i
  br i1 %.175.i1134.not.i, label %B402.endif.i, label %B76.if.i.lr.ph.i

B76.if.i.lr.ph.i:                                 ; preds = %B402.i
  %.990.i = load i64, ptr %.595.i, align 8, !noalias !0
  %.236.i.i = icmp slt i64 %.990.i, 0
  %.237.i.i8853 = select i1 %.236.i.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i = add i64 %.237.i.i8853, %.990.i
  %.258.i.i = mul i64 %.238.i.i, %arg.batch.1.3.5.1
  %11 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i
  br label %B76.if.i.i8854

B76.if.i.i8854:                                   ; preds = %B76.if.i.i8854, %B76.if.i.lr.ph.i
  %.117.i.01135.i = phi i64 [ 0, %B76.if.i.lr.ph.i ], [ %.188.i.i, %B76.if.i.i8854 ]
  %.188.i.i = add nsw i64 %.117.i.01135.i, 1
  %12 = getelementptr double, ptr %11, i64 %.117.i.01135.i
  %.263.i.i = load double, ptr %12, align 8, !noalias !3
  %13 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i
  %.293.i.i = load i64, ptr %13, align 8, !noalias !3
  %.295.i.i8855 = mul nsw i64 %.293.i.i, %arg.shape.0
  %.297.i.i = add nsw i64 %.295.i.i8855, %.589.09176
  %.311.i.i = icmp slt i64 %.297.i.i, 0
  %.312.i.i = select i1 %.311.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %14 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i
  %.326.i.i = getelementptr double, ptr %14, i64 %.312.i.i
  store double %.263.i.i, ptr %.326.i.i, align 8, !noalias !3
  %exitcond1142.not.i = icmp eq i64 %.188.i.i, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i, label %B402.endif.i, label %B76.if.i.i8854

B888.i:                                           ; preds = %B580.if.i
  store double 0.000000e+00, ptr %.1877.i, align 8, !noalias !0
  br label %B340

B358.if.i:                                        ; preds = %B358.if.i, %B358.if.lr.ph.i
  %.747.01132.i = phi i64 [ 0, %B358.if.lr.ph.i ], [ %.818.i, %B358.if.i ]
  %.818.i = add nsw i64 %.747.01132.i, 1
  %15 = getelementptr double, ptr %10, i64 %.747.01132.i
  %.893.i = load double, ptr %15, align 8, !noalias !0
  %.895.i = mul nsw i64 %.747.01132.i, %arg.shape.0
  %gep9326 = getelementptr double, ptr %invariant.gep9325, i64 %.895.i
  store double %.893.i, ptr %gep9326, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.818.i, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i, label %B402.i, label %B358.if.i

B402.endif.i:                                     ; preds = %B76.if.i.i8854, %B402.i
  br i1 %.11171137.not.i, label %B580.if.i, label %B496.if.lr.ph.i

B496.if.lr.ph.i:                                  ; preds = %B402.endif.i
  %.1179.i = select i1 %.438.i, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i = add i64 %.1179.i, %.236.i
  %.1200.i = mul i64 %.1180.i, %arg.batch.0.0.5.1
  %16 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i
  %invariant.gep9327 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.589.09176
  br label %B496.if.i

B496.if.i:                                        ; preds = %B496.if.i, %B496.if.lr.ph.i
  %.1061.01138.i = phi i64 [ 0, %B496.if.lr.ph.i ], [ %.1130.i, %B496.if.i ]
  %.1130.i = add nsw i64 %.1061.01138.i, 1
  %17 = getelementptr double, ptr %16, i64 %.1061.01138.i
  %.1205.i = load double, ptr %17, align 8, !noalias !0
  %.1207.i = mul nsw i64 %.1061.01138.i, %arg.shape.0
  %gep9328 = getelementptr double, ptr %invariant.gep9327, i64 %.1207.i
  store double %.1205.i, ptr %gep9328, align 8, !noalias !0
  %exitcond1143.not.i = icmp eq i64 %.1130.i, %arg.shape.1
  br i1 %exitcond1143.not.i, label %B580.if.i, label %B496.if.i

B580.if.i:                                        ; preds = %B496.if.i, %B402.endif.i
  %invariant.gep.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.589.09176
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
  %.1656.i = getelementptr double, ptr %4, i64 %.589.09176
  store double %.1547.i, ptr %.1656.i, align 8, !noalias !0
  store double 1.000000e+00, ptr %.293.i, align 8, !noalias !0
  %.1767.i = getelementptr double, ptr %5, i64 %.589.09176
  store double 0xFFF0000000000000, ptr %.1767.i, align 8, !noalias !0
  %.1822.i = getelementptr double, ptr %6, i64 %.589.09176
  store double 0x7FF0000000000000, ptr %.1822.i, align 8, !noalias !0
  %.1877.i = getelementptr double, ptr %7, i64 %.589.09176
  %.1878.i = load double, ptr %.1877.i, align 8, !noalias !0
  %.1880.i = fcmp ueq double %.1878.i, 0xFFF0000000000000
  br i1 %.1880.i, label %B340, label %B888.i

B340:                                             ; preds = %B888.i, %B296, %B580.if.i, %B254.if
  %.880 = load i64, ptr %260, align 8
  %.881 = icmp sgt i64 %.880, -1
  %. = zext i1 %.881 to i64
  %.898 = add nsw i64 %active.4.09178, %.
  %.647 = icmp sgt i64 %.592.09177, 1
  br i1 %.647, label %B254.if, label %B394

B394:                                             ; preds = %B340, %entry
  %active.4.0.lcssa = phi i64 [ 0, %entry ], [ %.898, %B340 ]
  %.915.not = icmp ne i64 %active.4.0.lcssa, 0
  %.937 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.915.not, i1 %.937, i1 false
  br i1 %or.cond, label %B422.preheader, label %B4566

B422.preheader:                                   ; preds = %B394
  %.981 = getelementptr i8, ptr %arg.batch.4.2.4, i64 16
  %factor.op.mul = mul i64 %arg.shape.0, %arg.shape.1
  %factor.op.mul9298 = mul i64 %arg.shape.0, %arg.shape.1
  %.1077 = getelementptr i8, ptr %arg.code.4, i64 8
  %.1129 = icmp sgt i64 %arg.shape.6, 0
  %.162.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx8827 = mul i64 %arg.batch.4.0.5.1, 24
  %19 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8827
  %.537.i9179 = icmp slt i64 %arg.shape.6, 1
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
  %.idx8819 = mul i64 %arg.batch.4.0.5.1, 24
  %20 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8819
  %.idx8820 = shl i64 %arg.batch.4.0.5.1, 5
  %21 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8820
  %.idx8821 = shl i64 %arg.batch.4.0.5.1, 8
  %22 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8821
  %.8828 = select i1 %.543.not, i64 2, i64 0
  %.idx8822 = mul i64 %arg.batch.4.0.5.1, 88
  %23 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8822
  %.idx8823 = shl i64 %arg.batch.4.0.5.1, 4
  %24 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8823
  %.idx8824 = shl i64 %arg.batch.4.1.5.1, 4
  %25 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8824
  %.idx8825 = shl i64 %arg.batch.4.0.5.1, 4
  %26 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8825
  %.idx8826 = mul i64 %arg.batch.4.0.5.1, 152
  %27 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8826
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
  %.183.i.i8861 = getelementptr i8, ptr %arg.linear.1.4, i64 32
  %.186.i.i = add nsw i64 %.124.i.i, %arg.shape.1
  %.187.i.i = add nsw i64 %.186.i.i, 1
  %.224.i.i8863 = icmp slt i64 %arg.shape.1, -2
  %.225.i.i = select i1 %.224.i.i8863, i64 %arg.linear.1.5.0, i64 0
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
  %.idx.i8866 = mul i64 %arg.shape.1, 152
  %30 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i8866
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
  %storemerge8762 = tail call i64 @llvm.smax.i64(i64 %.1984, i64 0)
  %.20279192.not = icmp slt i64 %.1984, 1
  %.2200.idx = mul i64 %.394, 136
  %.2200 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.2200.idx
  %.42.i = mul nsw i64 %arg.shape.1, %arg.shape.1
  %.88.not.i = icmp slt i64 %.42.i, %arg.linear.0.5.0
  %.218.i = add nsw i64 %arg.shape.1, 5
  %.265.i = icmp slt i64 %arg.linear.1.5.0, 6
  %.272.i8870 = icmp slt i64 %arg.shape.1, -5
  %.273.i = select i1 %.272.i8870, i64 %arg.linear.1.5.0, i64 0
  %.274.i = add i64 %.218.i, %.273.i
  %.277.i = icmp slt i64 %.274.i, 0
  %.282.not.i = icmp slt i64 %.274.i, %arg.linear.1.5.0
  %.648747.not.i = icmp slt i64 %arg.shape.1, 1
  %.756.i = mul nsw i64 %arg.shape.1, 17
  %.idx.i8872 = mul i64 %arg.shape.1, 80
  %invariant.gep9188 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i8872
  %.882.i = getelementptr i8, ptr %arg.linear.1.4, i64 8
  %.887.i = mul nsw i64 %arg.shape.1, 17
  %invariant.gep9190 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.887.i
  %.2303 = getelementptr i8, ptr %arg.code.4, i64 64
  %.2380 = icmp sgt i64 %arg.shape.3, 0
  %.2385 = icmp sgt i64 %arg.shape.6, 0
  %.idx8817 = mul i64 %arg.batch.4.0.5.1, 40
  %31 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8817
  %.idx8818 = mul i64 %arg.batch.4.0.5.1, 168
  %32 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8818
  %.idx8814 = mul i64 %arg.batch.4.0.5.1, 176
  %33 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8814
  %.idx8815 = mul i64 %arg.batch.4.0.5.1, 184
  %34 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8815
  %.idx8816 = mul i64 %arg.batch.4.0.5.1, 160
  %35 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8816
  %.idx8808 = shl i64 %arg.batch.4.1.5.1, 4
  %36 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8808
  %.idx8809 = mul i64 %arg.batch.4.0.5.1, 192
  %37 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8809
  %.idx8810 = mul i64 %arg.batch.4.0.5.1, 72
  %38 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8810
  %.idx8811 = mul i64 %arg.batch.4.0.5.1, 40
  %39 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8811
  %.idx8812 = mul i64 %arg.batch.4.0.5.1, 240
  %40 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8812
  %.idx8813 = mul i64 %arg.batch.4.0.5.1, 56
  %41 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8813
  %.3773.idx = mul i64 %.394, 136
  %.3773 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3773.idx
  %.3798.idx = mul i64 %.394, 104
  %.3798 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3798.idx
  %.3836 = getelementptr i8, ptr %arg.code.4, i64 232
  %.3930 = getelementptr i8, ptr %arg.code.4, i64 40
  %.3952.idx = mul i64 %.394, 136
  %.3952 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3952.idx
  %.idx8799 = mul i64 %arg.batch.4.0.5.1, 40
  %42 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8799
  %.idx8800 = mul i64 %arg.batch.4.0.5.1, 96
  %43 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8800
  %.idx8801 = shl i64 %arg.batch.4.0.5.1, 7
  %44 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8801
  %.idx8802 = shl i64 %arg.batch.4.0.5.1, 7
  %45 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8802
  %.idx8803 = shl i64 %arg.batch.4.0.5.1, 7
  %46 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8803
  %.idx8804 = mul i64 %arg.batch.4.0.5.1, 96
  %47 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8804
  %.idx8805 = mul i64 %arg.batch.4.0.5.1, 104
  %48 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8805
  %.idx8806 = mul i64 %arg.batch.4.0.5.1, 112
  %49 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8806
  %.idx8807 = shl i64 %arg.batch.4.1.5.1, 5
  %50 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8807
  %.4291.idx = mul i64 %.394, 136
  %.4291 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4291.idx
  %.4354 = getelementptr i8, ptr %arg.code.4, i64 200
  %.4431 = getelementptr i8, ptr %arg.code.4, i64 104
  %.idx8791 = shl i64 %arg.batch.4.1.5.1, 4
  %51 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8791
  %.idx8792 = mul i64 %arg.batch.4.0.5.1, 40
  %52 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8792
  %.idx8793 = mul i64 %arg.batch.4.0.5.1, 56
  %53 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8793
  %.idx8794 = mul i64 %arg.batch.4.0.5.1, 224
  %54 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8794
  %.idx8795 = mul i64 %arg.batch.4.0.5.1, 48
  %55 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8795
  %.idx8796 = shl i64 %arg.batch.4.0.5.1, 5
  %56 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8796
  %57 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx8797 = mul i64 %arg.batch.4.0.5.1, 96
  %58 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8797
  %.idx8798 = mul i64 %arg.batch.4.0.5.1, 232
  %59 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8798
  %.4431.c = getelementptr i8, ptr %arg.code.4, i64 104
  %60 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.223.i = getelementptr i8, ptr %60, i64 -8
  %.778.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.870.i.idx = shl i64 %factor.op.mul, 4
  %.870.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.870.i.idx
  %.idx1460.i = mul i64 %arg.batch.4.0.5.1, 104
  %61 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1460.i
  %.idx1461.i = mul i64 %arg.batch.4.0.5.1, 112
  %62 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1461.i
  %.idx1462.i = mul i64 %arg.batch.4.0.5.1, 96
  %63 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1462.i
  %.idx1463.i = mul i64 %arg.batch.4.0.5.1, 48
  %64 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1463.i
  %storemerge1465.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.1, i64 0)
  %.287.i1472.not.i = icmp slt i64 %arg.shape.1, 1
  %.359.i.i = shl nsw i64 %arg.shape.1, 1
  %storemerge1459.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.155.i.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx.i8889 = mul i64 %arg.batch.4.0.5.1, 56
  %65 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i8889
  %.idx1449.i = shl i64 %arg.batch.4.0.5.1, 7
  %66 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1449.i
  %.190.i211.i = mul nsw i64 %arg.shape.1, 17
  %.254.i.i8890 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.idx1452.i = mul i64 %arg.batch.4.0.5.1, 40
  %67 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1452.i
  %.idx1453.i = shl i64 %arg.batch.4.0.5.1, 5
  %68 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1453.i
  %69 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.4625.not = icmp eq i64 %arg.shape.3, 0
  %.8837 = select i1 %.543.not, i64 16, i64 1
  %.526.i8908 = getelementptr i8, ptr %arg.code.4, i64 16
  %.618.i.idx = shl i64 %factor.op.mul9298, 4
  %.618.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.618.i.idx
  %.452.i = uitofp i64 %.8837 to double
  %.idx673.i = mul i64 %arg.batch.4.0.5.1, 48
  %70 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx673.i
  %.287.i679.not.i = icmp slt i64 %arg.shape.1, 1
  %.359.i.i8909 = shl nsw i64 %arg.shape.1, 1
  %.idx.i8910 = mul i64 %arg.batch.4.0.5.1, 40
  %71 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i8910
  %.155.i.i.i8920 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i8927 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i8933 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i8939 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i8945 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i8951 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i8957 = mul nsw i64 %arg.shape.1, 18
  %factor.op.mul652.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx.i8975 = shl i64 %arg.batch.4.1.5.1, 4
  %72 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx.i8975
  %.idx640.i = mul i64 %arg.batch.4.0.5.1, 40
  %73 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx640.i
  %.idx641.i = mul i64 %arg.batch.4.0.5.1, 48
  %74 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx641.i
  %.idx642.i = mul i64 %arg.batch.4.0.5.1, 56
  %75 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx642.i
  %.924649.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx644.i = mul i64 %arg.batch.4.0.5.1, 232
  %76 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx644.i
  %.1000.i = mul nsw i64 %arg.shape.1, 17
  %77 = add i64 %arg.batch.2.5.0, -1
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.4863 = icmp sgt i64 %arg.shape.0, 1
  %.4917.idx = mul i64 %arg.batch.4.0.5.1, 40
  %.4917 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.4917.idx
  %.4949 = getelementptr i8, ptr %arg.code.4, i64 96
  %.idx8784 = mul i64 %arg.batch.4.0.5.1, 96
  %78 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8784
  %.idx8785 = mul i64 %arg.batch.4.0.5.1, 40
  %79 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8785
  %.idx8786 = mul i64 %arg.batch.4.0.5.1, 120
  %80 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8786
  %.552.i42719276.not = icmp slt i64 %arg.shape.1, 1
  %.697.i4308 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %81 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.742.i4338 = getelementptr i8, ptr %81, i64 -8
  %.idx8788 = mul i64 %arg.batch.4.1.5.1, 24
  %82 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8788
  %.idx8789 = mul i64 %arg.batch.4.1.5.1, 24
  %83 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8789
  %.idx8790 = mul i64 %arg.batch.4.0.5.1, 24
  %84 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8790
  %.5060.not = icmp ne i64 %arg.shape.4, 0
  %storemerge.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.0, i64 0)
  %.idx1632.i = mul i64 %arg.batch.4.0.5.1, 40
  %85 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1632.i
  %.idx1633.i = shl i64 %arg.batch.4.0.5.1, 4
  %86 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1633.i
  %87 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.175.i3061635.not.i = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.636.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.779.i8999 = getelementptr i8, ptr %arg.code.4, i64 32
  %.850.i9000 = mul nsw i64 %arg.shape.1, 17
  %.852.i9001 = mul nsw i64 %.850.i9000, %arg.shape.0
  %.895.i9002 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.852.i9001
  %.900.not.i = icmp eq i64 %arg.shape.3, 0
  %.930.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx1630.i = shl i64 %arg.batch.4.1.5.1, 4
  %88 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1630.i
  %.15441642.not.i = icmp slt i64 %arg.shape.1, 1
  %.1739.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx8773 = mul i64 %arg.batch.4.0.5.1, 40
  %89 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8773
  %.idx8774 = shl i64 %arg.batch.4.0.5.1, 4
  %90 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8774
  %91 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx8775 = mul i64 %arg.batch.4.0.5.1, 24
  %92 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8775
  %.175.i.i56409288.not = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.idx8778 = shl i64 %arg.batch.4.1.5.1, 4
  %93 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8778
  %.idx.i9017 = mul i64 %arg.batch.4.0.5.1, 24
  %94 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i9017
  %.323.i9019 = getelementptr i8, ptr %arg.batch.4.2.4, i64 8
  %95 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx1124.i9039 = mul i64 %arg.batch.4.1.5.1, 24
  %96 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1124.i9039
  %.8051131.not.i9041 = icmp slt i64 %arg.batch.0.1.5.1, 1
  %.175.i1134.not.i9057 = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.11171137.not.i9076 = icmp slt i64 %arg.shape.1, 1
  %gep.2.idx.i9094 = shl i64 %arg.batch.4.0.5.1, 4
  %gep.4.idx.i9098 = shl i64 %arg.batch.4.0.5.1, 5
  %gep.6.idx.i9102 = mul i64 %arg.batch.4.0.5.1, 48
  %gep.7.idx.i9104 = mul i64 %arg.batch.4.0.5.1, 56
  %gep.9.idx.i9108 = mul i64 %arg.batch.4.0.5.1, 72
  %gep.10.idx.i9110 = mul i64 %arg.batch.4.0.5.1, 80
  %gep.11.idx.i9112 = mul i64 %arg.batch.4.0.5.1, 88
  %gep.12.idx.i9114 = mul i64 %arg.batch.4.0.5.1, 96
  %gep.13.idx.i9116 = mul i64 %arg.batch.4.0.5.1, 104
  %gep.14.idx.i9118 = mul i64 %arg.batch.4.0.5.1, 112
  %gep.15.idx.i9120 = mul i64 %arg.batch.4.0.5.1, 120
  %gep.16.idx.i9122 = shl i64 %arg.batch.4.0.5.1, 7
  %gep.17.idx.i9124 = mul i64 %arg.batch.4.0.5.1, 136
  %gep.18.idx.i9126 = mul i64 %arg.batch.4.0.5.1, 144
  %gep.19.idx.i9128 = mul i64 %arg.batch.4.0.5.1, 152
  %gep.20.idx.i9130 = mul i64 %arg.batch.4.0.5.1, 160
  %gep.21.idx.i9132 = mul i64 %arg.batch.4.0.5.1, 168
  %gep.22.idx.i9134 = mul i64 %arg.batch.4.0.5.1, 176
  %gep.23.idx.i9136 = mul i64 %arg.batch.4.0.5.1, 184
  %gep.24.idx.i9138 = mul i64 %arg.batch.4.0.5.1, 192
  %gep.25.idx.i9140 = mul i64 %arg.batch.4.0.5.1, 200
  %gep.26.idx.i9142 = mul i64 %arg.batch.4.0.5.1, 208
  %gep.27.idx.i9144 = mul i64 %arg.batch.4.0.5.1, 216
  %gep.28.idx.i9146 = mul i64 %arg.batch.4.0.5.1, 224
  %gep.29.idx.i9148 = mul i64 %arg.batch.4.0.5.1, 232
  %97 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i9094
  %98 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.15.idx.i9120
  %99 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.29.idx.i9148
  %.idx1130.i9163 = mul i64 %arg.batch.4.0.5.1, 240
  %100 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i9163
  %.idx8777 = mul i64 %arg.batch.4.0.5.1, 240
  %101 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8777
  %.6126 = tail call i64 @llvm.smin.i64(i64 %arg.batch.2.5.0, i64 0)
  %102 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %103 = getelementptr i8, ptr %102, i64 -8
  %.6140 = getelementptr double, ptr %103, i64 %.6126
  %104 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx8779 = mul i64 %arg.batch.4.0.5.1, 240
  %105 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8779
  %.idx8780 = mul i64 %arg.batch.4.0.5.1, 160
  %106 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8780
  %.idx8781 = shl i64 %arg.batch.4.1.5.1, 4
  %107 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8781
  %.idx8782 = shl i64 %arg.batch.4.0.5.1, 4
  %108 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8782
  %.idx8783 = mul i64 %arg.batch.4.0.5.1, 152
  %109 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8783
  %110 = getelementptr i8, ptr %arg.code.4, i64 208
  %.4316.idx = mul i64 %.394, 112
  %.4316 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4316.idx
  %111 = getelementptr i8, ptr %arg.code.4, i64 216
  %.4316.1.idx = mul i64 %.394, 120
  %.4316.1 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4316.1.idx
  %112 = getelementptr i8, ptr %arg.code.4, i64 224
  %.4316.2.idx = shl i64 %.394, 7
  %.4316.2 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4316.2.idx
  br label %B422

B422:                                             ; preds = %B422.preheader, %B4540
  %budget.3.1 = phi i64 [ %budget.4.2, %B4540 ], [ %arg.budget, %B422.preheader ]
  %looked.3.1 = phi i1 [ %looked.4.2.lcssa, %B4540 ], [ true, %B422.preheader ]
  %active.9.1 = phi i64 [ %active.8.2, %B4540 ], [ %active.4.0.lcssa, %B422.preheader ]
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
  %.359.i = icmp sgt i64 %.304.i.09184, 1
  br i1 %.359.i, label %B194.if.i, label %B326.i

B326.i:                                           ; preds = %B324.i, %B586
  %.692.i = load i64, ptr %.691.i, align 8, !noalias !7
  %.808.i = inttoptr i64 %.692.i to ptr
  tail call void %.808.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br label %B622

B194.if.i:                                        ; preds = %B586, %B324.i
  %.304.i.09184 = phi i64 [ %.368.i, %B324.i ], [ %storemerge, %B586 ]
  %.301.i.09183 = phi i64 [ %.372.i, %B324.i ], [ 0, %B586 ]
  %.368.i = add nsw i64 %.304.i.09184, -1
  %.372.i = add nsw i64 %.301.i.09183, 1
  %113 = getelementptr double, ptr %19, i64 %.301.i.09183
  %.454.i = load double, ptr %113, align 8, !noalias !7
  %.455.i = fcmp ule double %.454.i, 5.000000e-01
  %brmerge9302 = select i1 %.455.i, i1 true, i1 %.537.i9179
  br i1 %brmerge9302, label %B324.i, label %B266.if.i.preheader

B266.if.i.preheader:                              ; preds = %B194.if.i
  %invariant.gep9329 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.301.i.09183
  br label %B266.if.i

B266.if.i:                                        ; preds = %B266.if.i.preheader, %B266.if.i
  %.481.i.09180 = phi i64 [ %.550.i, %B266.if.i ], [ 0, %B266.if.i.preheader ]
  %.550.i = add nsw i64 %.481.i.09180, 1
  %.576.i = mul nsw i64 %.481.i.09180, %arg.shape.0
  %gep9330 = getelementptr double, ptr %invariant.gep9329, i64 %.576.i
  %.608.i = load double, ptr %gep9330, align 8, !noalias !7
  %.610.i = add nsw i64 %.481.i.09180, %arg.shape.5
  %.612.i = mul nsw i64 %.610.i, %arg.shape.0
  %.614.i = add nsw i64 %.612.i, %.301.i.09183
  %.628.i = icmp slt i64 %.614.i, 0
  %.629.i = select i1 %.628.i, i64 %arg.batch.5.1.5.0, i64 0
  %114 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.614.i
  %.643.i = getelementptr double, ptr %114, i64 %.629.i
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
  %.441.i = getelementptr double, ptr %21, i64 %.170.i.09186
  store double 0.000000e+00, ptr %.441.i, align 8, !noalias !11
  %.496.i215 = getelementptr double, ptr %22, i64 %.170.i.09186
  store double 0.000000e+00, ptr %.496.i215, align 8, !noalias !11
  %.551.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.170.i.09186
  %.552.i245 = load i64, ptr %.551.i, align 8, !noalias !11
  %.579.i257 = icmp slt i64 %.552.i245, 0
  %.580.i258 = select i1 %.579.i257, i64 %arg.batch.3.3.5.0, i64 0
  %.581.i = add i64 %.580.i258, %.552.i245
  %.601.i272 = mul i64 %.581.i, %arg.batch.3.3.5.1
  %115 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.601.i272
  %.605.i = getelementptr i8, ptr %115, i64 8
  %.606.i = load i64, ptr %.605.i, align 8, !noalias !11
  %.628.i284 = add nsw i64 %.606.i, %.8828
  store i64 %.628.i284, ptr %.605.i, align 8, !noalias !11
  %.744.i347 = load i64, ptr %.551.i, align 8, !noalias !11
  %.771.i = icmp slt i64 %.744.i347, 0
  %.772.i = select i1 %.771.i, i64 %arg.batch.3.3.5.0, i64 0
  %.773.i = add i64 %.772.i, %.744.i347
  %.793.i370 = mul i64 %.773.i, %arg.batch.3.3.5.1
  %116 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.793.i370
  %.797.i = getelementptr i8, ptr %116, i64 16
  %.798.i = load i64, ptr %.797.i, align 8, !noalias !11
  %.799.i373 = add nsw i64 %.798.i, 1
  store i64 %.799.i373, ptr %.797.i, align 8, !noalias !11
  %.905.i = getelementptr double, ptr %23, i64 %.170.i.09186
  %.906.i = load double, ptr %.905.i, align 8, !noalias !11
  %.907.i = fcmp une double %.906.i, 0.000000e+00
  br i1 %.907.i, label %B368.i, label %B414.i

B368.i:                                           ; preds = %B106.i
  %117 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.170.i.09186
  %.84.i.i = load i64, ptr %117, align 8, !noalias !15
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
  %118 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.170.i.09186
  %.977.i = load double, ptr %118, align 8, !noalias !11
  %.979.i = fcmp olt double %.977.i, -1.000000e-09
  br i1 %.979.i, label %B454.i, label %B550.i

B454.i:                                           ; preds = %B418.i
  %119 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.170.i.09186
  %.84.i63.i = load i64, ptr %119, align 8, !noalias !18
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
  %.1068.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.170.i.09186
  %.1069.i = load double, ptr %.1068.i, align 8, !noalias !11
  %.1123.i = getelementptr double, ptr %24, i64 %.170.i.09186
  store double %.1069.i, ptr %.1123.i, align 8, !noalias !11
  br label %B550.i

B550.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i, %B418.i, %B414.i
  %.111.i183.i = getelementptr i64, ptr %25, i64 %.170.i.09186
  %.112.i.i = load i64, ptr %.111.i183.i, align 8, !noalias !21
  %.169.i.i = getelementptr double, ptr %26, i64 %.170.i.09186
  %.170.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.224.i.i = getelementptr double, ptr %27, i64 %.170.i.09186
  store double %.170.i.i, ptr %.224.i.i, align 8, !noalias !21
  %.237.i.i = icmp slt i64 %.112.i.i, %arg.batch.2.5.0
  br i1 %.237.i.i, label %B134.i.i, label %B584.i

B134.i.i:                                         ; preds = %B550.i
  %.253.i.i = icmp slt i64 %.112.i.i, 0
  %.254.i.i = select i1 %.253.i.i, i64 %arg.batch.2.5.0, i64 0
  %120 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i.i
  %.268.i.i = getelementptr double, ptr %120, i64 %.254.i.i
  %.269.i.i = load double, ptr %.268.i.i, align 8, !noalias !21
  %.328.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.10.i.i.i = fcmp olt double %.328.i.i, %.269.i.i
  %.11.i.i.i = select i1 %.10.i.i.i, double %.328.i.i, double %.269.i.i
  store double %.11.i.i.i, ptr %.224.i.i, align 8, !noalias !21
  br label %B584.i

B584.i:                                           ; preds = %B134.i.i, %B550.i, %B64.if.i
  %.229.i103 = icmp sgt i64 %.173.i7.09187, 1
  br i1 %.229.i103, label %B64.if.i, label %B1140

B64.if.i:                                         ; preds = %B1098, %B584.i
  %.173.i7.09187 = phi i64 [ %.238.i, %B584.i ], [ %storemerge, %B1098 ]
  %.170.i.09186 = phi i64 [ %.242.i388, %B584.i ], [ 0, %B1098 ]
  %.238.i = add nsw i64 %.173.i7.09187, -1
  %.242.i388 = add nsw i64 %.170.i.09186, 1
  %.323.i132 = getelementptr double, ptr %20, i64 %.170.i.09186
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

B124.i:                                           ; preds = %B0.endif.else.endif.endif.i
  %.154.i.i8860 = load i64, ptr %.153.i.i, align 8, !noalias !26
  %.184.i.i8862 = load i64, ptr %.183.i.i8861, align 8, !noalias !26
  br i1 %.234.i.i, label %B0.else.endif.if.i.i, label %B0.else.endif.endif.i.i, !prof !32

B412.i.i:                                         ; preds = %B330.if.i.i, %B0.endif.endif.endif.endif.endif.i.i
  %.1311.i.i = add nsw i64 %.486.i.i, -1
  %.1349.i.i = icmp slt i64 %.477.i.i, 2
  %storemerge2239.i = select i1 %.1349.i.i, i64 0, i64 %.1311.i.i
  %.1392.i2287.i = icmp sgt i64 %storemerge2239.i, 0
  br i1 %.1392.i2287.i, label %B478.i.lr.ph.i, label %B164.i

B478.i.lr.ph.i:                                   ; preds = %B412.i.i
  %.1338.i.12290.i = add nsw i64 %storemerge2239.i, -1
  %.511.i.i.i = select i1 %.1556.i2266.not.i, i64 %.311.i.i8864, i64 0
  %121 = getelementptr i64, ptr %.327.i.i, i64 %arg.shape.1
  %.525.i.i.i = getelementptr i64, ptr %121, i64 %.511.i.i.i
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
  %122 = getelementptr i64, ptr %.502.i.i, i64 %.1382.i.sroa.0.02293.i
  %.1864.i.i = getelementptr i64, ptr %122, i64 %.1850.i.i
  %.1865.i.i = load i64, ptr %.1864.i.i, align 8, !noalias !26
  %.1881.i.i = icmp slt i64 %.1382.i.sroa.0.02293.i, -1
  %.1882.i.i = select i1 %.1881.i.i, i64 %.486.i.i, i64 0
  %123 = getelementptr i8, ptr %122, i64 8
  %.1896.i.i = getelementptr i64, ptr %123, i64 %.1882.i.i
  %.1897.i.i = load i64, ptr %.1896.i.i, align 8, !noalias !26
  %.1934.i.i = sub i64 %.1897.i.i, %.1865.i.i
  %.1980.i2269.not.i = icmp slt i64 %.1934.i.i, 1
  br i1 %.1980.i2269.not.i, label %B960.i.i, label %B794.if.i.i

B802.i.i:                                         ; preds = %B794.if.i.i
  %.2047.i.i = icmp slt i64 %.1921.i.02270.i, 0
  %.2048.i.i = select i1 %.2047.i.i, i64 %.665.i.i, i64 0
  %124 = getelementptr i64, ptr %.681.i.i, i64 %.1921.i.02270.i
  %.2062.i.i = getelementptr i64, ptr %124, i64 %.2048.i.i
  %.2063.i.i = load i64, ptr %.2062.i.i, align 8, !noalias !26
  %.2064.i.i = add nsw i64 %.2063.i.i, %.1789.i.i
  %.2078.i.i = icmp slt i64 %.2064.i.i, 0
  %.2079.i.i = select i1 %.2078.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %125 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2064.i.i
  %.2093.i.i = getelementptr double, ptr %125, i64 %.2079.i.i
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
  %126 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02277.1.i
  %.906.i.i.1.i = load double, ptr %126, align 8, !noalias !33
  %127 = getelementptr double, ptr %126, i64 %.597.i.i.i
  %.939.i.i.1.i = load double, ptr %127, align 8, !noalias !33
  %.941.i.i.1.i = fmul double %.939.i.i.1.i, 5.000000e-01
  %128 = fsub double %.906.i.i.1.i, %.941.i.i.1.i
  %129 = getelementptr double, ptr %126, i64 %.944.i.i.i
  store double %128, ptr %129, align 8, !noalias !33
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
  %130 = fsub double %.1034.i.i.1.i, %.1070.i.i.1.i
  store double %130, ptr %.502, align 8, !noalias !33
  %.1157.i.i.1.i = load i64, ptr %arg.code.4, align 8, !noalias !33
  %.1277.i.i.1.i = inttoptr i64 %.1157.i.i.1.i to ptr
  tail call void %.1277.i.i.1.i(ptr nonnull %.502, ptr %.1807.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.1.i), !noalias !33
  br i1 %.1162.i2263.not.i, label %B960.i.i, label %B780.if.i.i.i

B966.i.i.i:                                       ; preds = %B780.if.i.i.i
  %.1601.i.i.i = fsub double %.1513.i.i.i, %.1548.i.i.i
  br label %B1053.i.i.i

B1006.i.i.i:                                      ; preds = %B780.if.i.i.i
  %131 = getelementptr double, ptr %139, i64 %arg.shape.1
  %.1582.i.i.i = load double, ptr %131, align 8, !noalias !33
  %.1647.i.i.i = fsub double %.1513.i.i.i, %.1582.i.i.i
  %.1652.i.i.i = fmul double %.1647.i.i.i, 2.000000e+00
  br label %B1053.i.i.i

B1053.i.i.i:                                      ; preds = %B1006.i.i.i, %B966.i.i.i
  %storemerge2247.i = phi double [ %.1652.i.i.i, %B1006.i.i.i ], [ %.1601.i.i.i, %B966.i.i.i ]
  store double %storemerge2247.i, ptr %141, align 8, !noalias !33
  %exitcond2303.not.i = icmp eq i64 %arg.shape.1, %.1387.i.i.i
  br i1 %exitcond2303.not.i, label %B960.i.i, label %B780.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B918.i.i, %B84.if.i.i.i
  %.212.i.i.02275.i = phi i64 [ %.283.i.i.i, %B84.if.i.i.i ], [ 0, %B918.i.i ]
  %.283.i.i.i = add nsw i64 %.212.i.i.02275.i, 1
  %132 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.212.i.i.02275.i
  %.341.i.i.i = load double, ptr %132, align 8, !noalias !33
  %.342.i.i.i = tail call double @llvm.fabs.f64(double %.341.i.i.i)
  %.10.i.i.i.i = fcmp ogt double %.184.i.i.i, %.342.i.i.i
  %.11.i.i.i.i = select i1 %.10.i.i.i.i, double %.184.i.i.i, double %.342.i.i.i
  %.377.i.i.i = fcmp ogt double %.11.i.i.i.i, 0.000000e+00
  %133 = fmul double %.11.i.i.i.i, 1.200000e-05
  %"$phi194.2.2.i.i.1.i" = select i1 %.377.i.i.i, double %133, double 1.200000e-05
  %134 = getelementptr i64, ptr %.327.i.i, i64 %.212.i.i.02275.i
  %.434.i.i.i = load i64, ptr %134, align 8, !noalias !33
  %.436.i.i.i = icmp eq i64 %.434.i.i.i, %.1382.i.sroa.0.02293.i
  %"$phi230.1.2.i.i.1.i" = select i1 %.436.i.i.i, double %"$phi194.2.2.i.i.1.i", double 0.000000e+00
  %135 = getelementptr i8, ptr %132, i64 %.idx2308.i
  store double %"$phi230.1.2.i.i.1.i", ptr %135, align 8, !noalias !33
  %exitcond2300.not.i = icmp eq i64 %arg.shape.1, %.283.i.i.i
  br i1 %exitcond2300.not.i, label %B262.i.i.i, label %B84.if.i.i.i

B428.if.i.i.i:                                    ; preds = %B324.i.i.i, %B428.if.i.i.i
  %.783.i.i.02277.i = phi i64 [ %.852.i.i.i, %B428.if.i.i.i ], [ 0, %B324.i.i.i ]
  %.852.i.i.i = add nsw i64 %.783.i.i.02277.i, 1
  %136 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02277.i
  %.906.i.i.i = load double, ptr %136, align 8, !noalias !33
  %137 = getelementptr double, ptr %136, i64 %.597.i.i.i
  %.939.i.i.i = load double, ptr %137, align 8, !noalias !33
  %.941.i.i.i = fmul double %.939.i.i.i, 5.000000e-01
  %.942.i.i.i = fadd double %.906.i.i.i, %.941.i.i.i
  %138 = getelementptr double, ptr %136, i64 %.944.i.i.i
  store double %.942.i.i.i, ptr %138, align 8, !noalias !33
  %exitcond2301.not.i = icmp eq i64 %arg.shape.1, %.852.i.i.i
  br i1 %exitcond2301.not.i, label %B524.i.i.i, label %B428.if.i.i.i

B780.if.i.i.i:                                    ; preds = %B524.i.i.1.i, %B1053.i.i.i
  %.1318.i.i.02282.i = phi i64 [ %.1387.i.i.i, %B1053.i.i.i ], [ 0, %B524.i.i.1.i ]
  %.1387.i.i.i = add nsw i64 %.1318.i.i.02282.i, 1
  %139 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1318.i.i.02282.i
  %.1445.i.i.i = load double, ptr %139, align 8, !noalias !33
  %140 = getelementptr i8, ptr %139, i64 %.1807.i.idx.i
  store double %.1445.i.i.i, ptr %140, align 8, !noalias !33
  %141 = getelementptr i8, ptr %139, i64 %.idx2310.i
  %.1513.i.i.i = load double, ptr %141, align 8, !noalias !33
  %142 = getelementptr i8, ptr %139, i64 %.1276.i.i.1.idx.i
  %.1548.i.i.i = load double, ptr %142, align 8, !noalias !33
  %.1594.i.i.i = fsub double %.1548.i.i.i, %.1548.i.i.i
  %.1595.i.i.i = fcmp oeq double %.1594.i.i.i, 0.000000e+00
  br i1 %.1595.i.i.i, label %B966.i.i.i, label %B1006.i.i.i

B960.i.i:                                         ; preds = %B1053.i.i.i, %B524.i.i.1.i, %B914.i.i, %B610.i.i
  %.2258.i.i = icmp slt i64 %.1382.i.sroa.0.02293.i, 0
  %.2259.i.i = select i1 %.2258.i.i, i64 %.486.i.i, i64 0
  %143 = getelementptr i64, ptr %.502.i.i, i64 %.1382.i.sroa.0.02293.i
  %.2273.i.i = getelementptr i64, ptr %143, i64 %.2259.i.i
  %.2274.i.i = load i64, ptr %.2273.i.i, align 8, !noalias !26
  %.2292.i.i = icmp slt i64 %.1382.i.sroa.0.02293.i, -1
  %.2293.i.i = select i1 %.2292.i.i, i64 %.486.i.i, i64 0
  %144 = getelementptr i8, ptr %143, i64 8
  %.2307.i.i = getelementptr i64, ptr %144, i64 %.2293.i.i
  %.2308.i.i = load i64, ptr %.2307.i.i, align 8, !noalias !26
  %.2345.i.i = sub i64 %.2308.i.i, %.2274.i.i
  %.2388.i2284.not.i = icmp slt i64 %.2345.i.i, 1
  br i1 %.2388.i2284.not.i, label %B474.i.loopexit.i, label %B1022.if.i.i

B1178.i.i:                                        ; preds = %B1022.if.i.i
  %.2656.i.i = add nsw i64 %.2461.i.i, %.2622.i.i
  %.2671.i.i = icmp slt i64 %.2656.i.i, 0
  %.2672.i.i = select i1 %.2671.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %145 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2656.i.i
  %.2686.i.i = getelementptr double, ptr %145, i64 %.2672.i.i
  store double %.2560.i..i, ptr %.2686.i.i, align 8, !noalias !26
  br label %B1253.i.i

B1224.i.i:                                        ; preds = %B1022.if.i.i
  %.2706.i.i = select i1 %.2445.i.i, i64 %.1014.i.i, i64 0
  %146 = getelementptr i64, ptr %.1030.i.i, i64 %.2332.i.02285.i
  %.2720.i.i = getelementptr i64, ptr %146, i64 %.2706.i.i
  %.2721.i.i = load i64, ptr %.2720.i.i, align 8, !noalias !26
  %.2738.i.i = icmp slt i64 %.2721.i.i, 0
  %.2739.i.i = select i1 %.2738.i.i, i64 %arg.linear.0.5.0, i64 0
  %147 = getelementptr double, ptr %arg.linear.0.4, i64 %.2721.i.i
  %.2753.i.i = getelementptr double, ptr %147, i64 %.2739.i.i
  store double %.2560.i..i, ptr %.2753.i.i, align 8, !noalias !26
  br label %B1253.i.i

B1253.i.i:                                        ; preds = %B1224.i.i, %B1178.i.i
  %.2388.i.i = icmp sgt i64 %.2335.i.02286.i, 1
  br i1 %.2388.i.i, label %B1022.if.i.i, label %B474.i.loopexit.i

B0.endif.i.i:                                     ; preds = %B0.else.endif.endif.endif.if.i.i, %B0.else.endif.endif.endif.i.i
  %.214.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.else.endif.endif.endif.if.i.i ], [ %.214.i.sroa.11.1.i, %B0.else.endif.endif.endif.i.i ]
  %.302.i.i = sub i64 %.214.i.sroa.11.0.i, %spec.select.i
  %.311.i.i8864 = tail call i64 @llvm.smax.i64(i64 %.302.i.i, i64 0)
  %.327.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select.i
  %.362.i.i = add nsw i64 %.154.i.i8860, %.187.i.i
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
  %.477.i.i = sub i64 %.389.i.sroa.11.0.i, %spec.select2250.i
  %.486.i.i = tail call i64 @llvm.smax.i64(i64 %.477.i.i, i64 0)
  %.502.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2250.i
  %.540.i.i = add i64 %.539.i.i, %.154.i.i8860
  %.541.i.i = add nsw i64 %.540.i.i, %.184.i.i8862
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
  %spec.select2250.i = select i1 %29, i64 %simplifycfg.merge2.i, i64 %.243.i.i, !prof !37
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
  %.711.i.i = shl nsw i64 %.184.i.i8862, 1
  %.712.i.i = add nsw i64 %.711.i.i, %.540.i.i
  %.759.i.i = icmp sge i64 %.597.i.i, %arg.linear.1.5.0
  br i1 %.759.i.i, label %B0.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.else.endif.endif.i.i, !prof !32

B0.endif.endif.else.endif.if.i.i:                 ; preds = %B0.endif.endif.i.i
  br label %B0.endif.endif.else.endif.endif.i.i

B0.endif.endif.else.endif.endif.i.i:              ; preds = %B0.endif.endif.else.endif.if.i.i, %B0.endif.endif.i.i
  %simplifycfg.merge4.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.i.i ]
  %148 = or i1 %.583.i.i, %.588.i.i
  %spec.select2251.i = select i1 %148, i64 %simplifycfg.merge4.i, i64 %.580.i.i, !prof !37
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
  %.889.i.i = mul nsw i64 %.184.i.i8862, 3
  %.890.i.i = add nsw i64 %.889.i.i, %.540.i.i
  %.937.i.i = icmp sge i64 %.768.i.i, %arg.linear.1.5.0
  br i1 %.937.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.i.i, !prof !32

B0.endif.endif.endif.else.endif.if.i.i:           ; preds = %B0.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.else.endif.endif.i.i:        ; preds = %B0.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.i.i
  %simplifycfg.merge6.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.i.i ]
  %149 = or i1 %.600.i.i, %.759.i.i
  %spec.select2252.i = select i1 %149, i64 %simplifycfg.merge6.i, i64 %.597.i.i, !prof !37
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
  %150 = or i1 %.771.i.i, %.937.i.i
  %spec.select2253.i = select i1 %150, i64 %simplifycfg.merge8.i, i64 %.768.i.i, !prof !37
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
  %151 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1104.i.02264.i
  %.1229.i.i = load double, ptr %151, align 8, !noalias !26
  %152 = getelementptr i8, ptr %151, i64 %.idx2305.i
  store double %.1229.i.i, ptr %152, align 8, !noalias !26
  %153 = getelementptr i8, ptr %151, i64 %.idx2306.i
  store double 0.000000e+00, ptr %153, align 8, !noalias !26
  %exitcond.not.i8865 = icmp eq i64 %arg.shape.1, %.1175.i.i
  br i1 %exitcond.not.i8865, label %B412.i.i, label %B330.if.i.i

B544.if.i.i:                                      ; preds = %B508.i.i, %B544.if.i.i
  %.1503.i.02268.i = phi i64 [ %.1565.i.i, %B544.if.i.i ], [ %storemerge2243.i, %B508.i.i ]
  %.1500.i.02267.i = phi i64 [ %.1569.i.i, %B544.if.i.i ], [ 0, %B508.i.i ]
  %.1565.i.i = add nsw i64 %.1503.i.02268.i, -1
  %.1569.i.i = add nsw i64 %.1500.i.02267.i, 1
  %154 = getelementptr i64, ptr %.327.i.i, i64 %.1500.i.02267.i
  %.1627.i.i = load i64, ptr %154, align 8, !noalias !26
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
  %155 = getelementptr i64, ptr %.681.i.i, i64 %.2332.i.02285.i
  %.2460.i.i = getelementptr i64, ptr %155, i64 %.2446.i.i
  %.2461.i.i = load i64, ptr %.2460.i.i, align 8, !noalias !26
  %.2462.i.i = add nsw i64 %.2461.i.i, %.1789.i.i
  %.2476.i.i = icmp slt i64 %.2462.i.i, 0
  %.2477.i.i = select i1 %.2476.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %156 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2462.i.i
  %.2491.i.i = getelementptr double, ptr %156, i64 %.2477.i.i
  %.2492.i.i = load double, ptr %.2491.i.i, align 8, !noalias !26
  %.2510.i.i = select i1 %.2445.i.i, i64 %.836.i.i, i64 0
  %157 = getelementptr i64, ptr %.852.i.i, i64 %.2332.i.02285.i
  %.2524.i.i = getelementptr i64, ptr %157, i64 %.2510.i.i
  %.2525.i.i = load i64, ptr %.2524.i.i, align 8, !noalias !26
  %.2526.i.i = add nsw i64 %.2525.i.i, %.597.i.i.i
  %.2540.i.i = icmp slt i64 %.2526.i.i, 0
  %.2541.i.i = select i1 %.2540.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %158 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2526.i.i
  %.2555.i.i = getelementptr double, ptr %158, i64 %.2541.i.i
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
  %159 = add i64 %.664.i, %.634.i
  br label %B226.if.i

B396.i:                                           ; preds = %B342.if.i, %B226.if.i
  %.1055.i = mul i64 %.697.02298.i, %.743.sroa.0.02242.i
  %.1071.i = icmp slt i64 %.1055.i, 0
  %.1072.i = select i1 %.1071.i, i64 %.251.i, i64 0
  %160 = getelementptr double, ptr %.267.i, i64 %.1055.i
  %.1086.i = getelementptr double, ptr %160, i64 %.1072.i
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
  %161 = getelementptr i64, ptr %.437.i, i64 %.59.0509.i.i
  store i64 %p.2.1.lcssa.i.i, ptr %161, align 8, !noalias !39
  %.547.i.i = add nsw i64 %p.2.1.lcssa.i.i, %.161.i.i
  %.561.i.i = icmp slt i64 %.547.i.i, 0
  %.562.i.i = select i1 %.561.i.i, i64 %.251.i, i64 0
  %162 = getelementptr double, ptr %.267.i, i64 %.547.i.i
  %.576.i.i = getelementptr double, ptr %162, i64 %.562.i.i
  %.577.i.i = load double, ptr %.576.i.i, align 8, !noalias !39
  %.610.i.i = load double, ptr %164, align 8, !noalias !39
  store double %.577.i.i, ptr %164, align 8, !noalias !39
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
  %.11.i.i.i8859 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.165.i.i, i64 %arg.shape.1)
  %.200.i.i = add i64 %.199.i.i, %.164.i.i
  %.11.i492.i.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.200.i.i, i64 %arg.shape.1)
  %163 = getelementptr double, ptr %.267.i, i64 %.161.i.i
  %164 = getelementptr double, ptr %163, i64 %.59.0509.i.i
  %.319.i.i = sub i64 %.11.i.i.i8859, %.131.i.i
  %storemerge488.i.i = tail call i64 @llvm.smax.i64(i64 %.319.i.i, i64 0)
  %.362493.not.i.i = icmp slt i64 %.319.i.i, 1
  br i1 %.362493.not.i.i, label %B348.i.i, label %B234.if.preheader.i.i

B234.if.preheader.i.i:                            ; preds = %B36.if.i.i
  %.271.i.i = load double, ptr %164, align 8, !noalias !39
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
  %165 = getelementptr double, ptr %.267.i, i64 %.415.i.i
  %.444.i.i = getelementptr double, ptr %165, i64 %.430.i.i
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
  %166 = getelementptr double, ptr %.267.i, i64 %.798.i.i
  %.827.i2256.i = getelementptr double, ptr %166, i64 %.813.i.i
  %.828.i.i = load double, ptr %.827.i2256.i, align 8, !noalias !39
  %.861.i.i = load double, ptr %164, align 8, !noalias !39
  %.865.i.i = fdiv double %.828.i.i, %.861.i.i
  store double %.865.i.i, ptr %.827.i2256.i, align 8, !noalias !39
  %.759.i2257.i = icmp sgt i64 %.706.0500.i.i, 1
  br i1 %.759.i2257.i, label %B466.if.i.i, label %B528.i.i

B566.if.i.i:                                      ; preds = %B528.i.i, %B790.i.i
  %.932.0506.i.i = phi i64 [ %.994.i.i, %B790.i.i ], [ %.942.i.i, %B528.i.i ]
  %.929.0505.i.i = phi i64 [ %.998.i.i, %B790.i.i ], [ %.131.i.i, %B528.i.i ]
  %.994.i.i = add nsw i64 %.932.0506.i.i, -1
  %.998.i.i = add i64 %.929.0505.i.i, 1
  %167 = mul nsw i64 %.929.0505.i.i, %arg.shape.1
  %.1030.i2258.i = add nsw i64 %167, %p.2.1.lcssa.i.i
  %.1044.i.i = icmp slt i64 %.1030.i2258.i, 0
  %.1045.i.i = select i1 %.1044.i.i, i64 %.251.i, i64 0
  %168 = getelementptr double, ptr %.267.i, i64 %.1030.i2258.i
  %.1059.i.i = getelementptr double, ptr %168, i64 %.1045.i.i
  %.1060.i.i = load double, ptr %.1059.i.i, align 8, !noalias !39
  %.1068.i.i = add nsw i64 %167, %.59.0509.i.i
  %.1082.i.i = icmp slt i64 %.1068.i.i, 0
  %.1083.i.i = select i1 %.1082.i.i, i64 %.251.i, i64 0
  %169 = getelementptr double, ptr %.267.i, i64 %.1068.i.i
  %.1097.i.i = getelementptr double, ptr %169, i64 %.1083.i.i
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
  %.1296.i.i = add nsw i64 %.1199.0502.i.i, %167
  %.1310.i.i = icmp slt i64 %.1296.i.i, 0
  %.1311.i2261.i = select i1 %.1310.i.i, i64 %.251.i, i64 0
  %170 = getelementptr double, ptr %.267.i, i64 %.1296.i.i
  %.1325.i.i = getelementptr double, ptr %170, i64 %.1311.i2261.i
  %.1326.i.i = load double, ptr %.1325.i.i, align 8, !noalias !39
  %.1328.i.i = add nsw i64 %.1199.0502.i.i, %.161.i.i
  %.1342.i.i = icmp slt i64 %.1328.i.i, 0
  %.1343.i.i = select i1 %.1342.i.i, i64 %.251.i, i64 0
  %171 = getelementptr double, ptr %.267.i, i64 %.1328.i.i
  %.1357.i.i = getelementptr double, ptr %171, i64 %.1343.i.i
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
  br i1 %.526.i, label %B124.i, label %B164.i

B226.if.i:                                        ; preds = %B396.i, %B226.if.lr.ph.i
  %.697.02298.i = phi i64 [ 0, %B226.if.lr.ph.i ], [ %.766.i, %B396.i ]
  %.766.i = add nsw i64 %.697.02298.i, 1
  %.798.i8856 = sub i64 %.697.02298.i, %159
  %.11.i.i8857 = tail call i64 @llvm.smax.i64(i64 %.798.i8856, i64 0)
  %.830.i = add i64 %.829.i, %.697.02298.i
  %.11.i2262.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.830.i, i64 %arg.shape.1)
  %.896.i = sub i64 %.11.i2262.i, %.11.i.i8857
  %.9392294.not.i = icmp slt i64 %.896.i, 1
  br i1 %.9392294.not.i, label %B396.i, label %B342.if.lr.ph.i

B342.if.lr.ph.i:                                  ; preds = %B226.if.i
  %.979.i8858 = mul nsw i64 %.697.02298.i, %arg.shape.1
  br label %B342.if.i

B342.if.i:                                        ; preds = %B342.if.i, %B342.if.lr.ph.i
  %.886.02296.i = phi i64 [ %.896.i, %B342.if.lr.ph.i ], [ %.948.i, %B342.if.i ]
  %.883.02295.i = phi i64 [ %.11.i.i8857, %B342.if.lr.ph.i ], [ %.952.i, %B342.if.i ]
  %.948.i = add nsw i64 %.886.02296.i, -1
  %.952.i = add i64 %.883.02295.i, 1
  %.980.i = add nsw i64 %.883.02295.i, %.979.i8858
  %.994.i = icmp slt i64 %.980.i, 0
  %.995.i = select i1 %.994.i, i64 %arg.linear.0.5.0, i64 0
  %172 = getelementptr double, ptr %arg.linear.0.4, i64 %.980.i
  %.1009.i = getelementptr double, ptr %172, i64 %.995.i
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !38
  %.1011.i = fneg double %.1010.i
  %.1030.i = select i1 %.994.i, i64 %.251.i, i64 0
  %173 = getelementptr double, ptr %.267.i, i64 %.980.i
  %.1044.i = getelementptr double, ptr %173, i64 %.1030.i
  store double %.1011.i, ptr %.1044.i, align 8, !noalias !38
  %.939.i = icmp sgt i64 %.886.02296.i, 1
  br i1 %.939.i, label %B342.if.i, label %B396.i

B1348:                                            ; preds = %B34.loopexit.i.i, %B164.i, %B1304
  br i1 %.20279192.not, label %B1606, label %B1380.if

B1568:                                            ; preds = %B1380.if
  br i1 %.88.not.i, label %B0.else.endif.endif.endif.if.i8868, label %B0.else.endif.if.i8867, !prof !25

B322.i:                                           ; preds = %B192.if.i
  %.853.i = load i64, ptr %arg.linear.1.4, align 8, !noalias !42
  %.883.i = load i64, ptr %.882.i, align 8, !noalias !42
  %.339.i.i = add i64 %.853.i, 1
  br label %B34.if.i.i8874

B34.i.loopexit.i:                                 ; preds = %B198.if.i.i, %B34.if.i.i8874
  %exitcond766.not.i = icmp eq i64 %arg.shape.1, %.144.i.i
  br i1 %exitcond766.not.i, label %B314.if.i.lr.ph.i, label %B34.if.i.i8874

B314.if.i.lr.ph.i:                                ; preds = %B34.i.loopexit.i
  %174 = add i64 %.883.i, %.853.i
  br label %B314.if.i.i

B314.i.loopexit.i:                                ; preds = %B474.if.i.i, %B314.if.i.i
  %.683.i.i = icmp sgt i64 %.627.i.0762.in.i, 1
  br i1 %.683.i.i, label %B314.if.i.i, label %B434.if.lr.ph.i

B434.if.lr.ph.i:                                  ; preds = %B314.i.loopexit.i
  %.1110.i = mul nsw i64 %.2040, %arg.shape.1
  br label %B434.if.i

B34.if.i.i8874:                                   ; preds = %B34.i.loopexit.i, %B322.i
  %.73.i.0754.i = phi i64 [ 0, %B322.i ], [ %.144.i.i, %B34.i.loopexit.i ]
  %.144.i.i = add nsw i64 %.73.i.0754.i, 1
  %175 = getelementptr i64, ptr %.358.i8871, i64 %.73.i.0754.i
  %.202.i.i = load i64, ptr %175, align 8, !noalias !45
  %.204.i.i = add nsw i64 %.202.i.i, %.887.i
  %.218.i.i = icmp slt i64 %.204.i.i, 0
  %.219.i.i = select i1 %.218.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %176 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.204.i.i
  %.233.i.i = getelementptr double, ptr %176, i64 %.219.i.i
  %.234.i.i8875 = load double, ptr %.233.i.i, align 8, !noalias !45
  %gep9191 = getelementptr double, ptr %invariant.gep9190, i64 %.73.i.0754.i
  %.270.i.i = load double, ptr %gep9191, align 8, !noalias !45
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !45
  store double %.234.i.i8875, ptr %gep9191, align 8, !noalias !45
  %.340.i.i = add i64 %.339.i.i, %.73.i.0754.i
  %.11.i.i.i8876 = tail call i64 @llvm.smin.i64(i64 %.340.i.i, i64 %arg.shape.1)
  %.406.i.i = sub i64 %.11.i.i.i8876, %.144.i.i
  %.449.i750.not.i = icmp slt i64 %.406.i.i, 1
  br i1 %.449.i750.not.i, label %B34.i.loopexit.i, label %B198.if.i.lr.ph.i

B198.if.i.lr.ph.i:                                ; preds = %B34.if.i.i8874
  %.521.i.i = mul nsw i64 %.73.i.0754.i, %arg.shape.1
  br label %B198.if.i.i

B198.if.i.i:                                      ; preds = %B198.if.i.i, %B198.if.i.lr.ph.i
  %.396.i.0752.i = phi i64 [ %.406.i.i, %B198.if.i.lr.ph.i ], [ %.458.i.i, %B198.if.i.i ]
  %.393.i.0751.i = phi i64 [ %.144.i.i, %B198.if.i.lr.ph.i ], [ %.462.i.i, %B198.if.i.i ]
  %.458.i.i = add nsw i64 %.396.i.0752.i, -1
  %.462.i.i = add i64 %.393.i.0751.i, 1
  %.488.i.i = add nsw i64 %.393.i.0751.i, %.887.i
  %.502.i.i8877 = icmp slt i64 %.488.i.i, 0
  %.503.i.i = select i1 %.502.i.i8877, i64 %arg.batch.5.0.5.0, i64 0
  %177 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.488.i.i
  %.517.i.i = getelementptr double, ptr %177, i64 %.503.i.i
  %.518.i.i = load double, ptr %.517.i.i, align 8, !noalias !45
  %.522.i.i = add nsw i64 %.393.i.0751.i, %.521.i.i
  %.536.i.i = icmp slt i64 %.522.i.i, 0
  %.537.i.i = select i1 %.536.i.i, i64 %.165.i, i64 0
  %178 = getelementptr double, ptr %.181.i, i64 %.522.i.i
  %.551.i.i = getelementptr double, ptr %178, i64 %.537.i.i
  %.552.i.i = load double, ptr %.551.i.i, align 8, !noalias !45
  %.554.i.i = fmul double %.234.i.i8875, %.552.i.i
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
  %179 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.726.i.i
  %.755.i.i = getelementptr double, ptr %179, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i, align 8, !noalias !45
  %.759.i.i8878 = mul nsw i64 %.627.i.0762.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i8878, %.627.i.0762.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %.165.i, i64 0
  %180 = getelementptr double, ptr %.181.i, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %180, i64 %.776.i.i
  %.791.i.i = load double, ptr %.790.i.i, align 8, !noalias !45
  %.795.i.i = fdiv double %.756.i.i, %.791.i.i
  store double %.795.i.i, ptr %.755.i.i, align 8, !noalias !45
  %.866.i.i = sub i64 %.627.i.0762.i, %174
  %.11.i4.i.i = tail call i64 @llvm.smax.i64(i64 %.866.i.i, i64 0)
  %.932.i.i = sub i64 %.627.i.0762.i, %.11.i4.i.i
  %.975.i756.not.i = icmp slt i64 %.932.i.i, 1
  br i1 %.975.i756.not.i, label %B314.i.loopexit.i, label %B474.if.i.i

B474.if.i.i:                                      ; preds = %B314.if.i.i, %B474.if.i.i
  %.922.i.0758.i = phi i64 [ %.984.i.i, %B474.if.i.i ], [ %.932.i.i, %B314.if.i.i ]
  %.919.i.0757.i = phi i64 [ %.988.i.i, %B474.if.i.i ], [ %.11.i4.i.i, %B314.if.i.i ]
  %.984.i.i = add nsw i64 %.922.i.0758.i, -1
  %.988.i.i = add i64 %.919.i.0757.i, 1
  %.1014.i.i8879 = add nsw i64 %.919.i.0757.i, %.887.i
  %.1028.i.i = icmp slt i64 %.1014.i.i8879, 0
  %.1029.i.i = select i1 %.1028.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %181 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1014.i.i8879
  %.1043.i.i = getelementptr double, ptr %181, i64 %.1029.i.i
  %.1044.i.i8880 = load double, ptr %.1043.i.i, align 8, !noalias !45
  %.1048.i.i = add nsw i64 %.919.i.0757.i, %.759.i.i8878
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %.165.i, i64 0
  %182 = getelementptr double, ptr %.181.i, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %182, i64 %.1063.i.i
  %.1078.i.i = load double, ptr %.1077.i.i, align 8, !noalias !45
  %.1080.i.i = fmul double %.795.i.i, %.1078.i.i
  %.1081.i.i = fsub double %.1044.i.i8880, %.1080.i.i
  store double %.1081.i.i, ptr %.1043.i.i, align 8, !noalias !45
  %.975.i.i = icmp sgt i64 %.922.i.0758.i, 1
  br i1 %.975.i.i, label %B474.if.i.i, label %B314.i.loopexit.i

B0.else.endif.if.i8867:                           ; preds = %B1568
  br label %B0.else.endif.endif.endif.if.i8868

B0.else.endif.endif.endif.if.i8868:               ; preds = %B0.else.endif.if.i8867, %B1568
  %.68.sroa.0.3.i = phi i64 [ %arg.linear.0.5.0, %B0.else.endif.if.i8867 ], [ %.42.i, %B1568 ]
  %.156.i = sub i64 %arg.linear.0.5.0, %.68.sroa.0.3.i
  %.165.i = tail call i64 @llvm.smax.i64(i64 %.156.i, i64 0)
  %.181.i = getelementptr double, ptr %arg.linear.0.4, i64 %.68.sroa.0.3.i
  br i1 %.265.i, label %B0.endif.else.endif.if.i8882, label %B0.endif.else.endif.endif.i8869, !prof !32

B0.endif.else.endif.if.i8882:                     ; preds = %B0.else.endif.endif.endif.if.i8868
  br label %B0.endif.else.endif.endif.i8869

B0.endif.else.endif.endif.i8869:                  ; preds = %B0.endif.else.endif.if.i8882, %B0.else.endif.endif.endif.if.i8868
  %.245.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.if.i8882 ], [ 5, %B0.else.endif.endif.endif.if.i8868 ]
  %.358.i8871 = getelementptr i64, ptr %arg.linear.1.4, i64 %.245.sroa.0.3.i
  br i1 %.277.i, label %B0.endif.endif.else.if.i, label %B0.endif.endif.else.endif.i, !prof !32

B192.if.lr.ph.i:                                  ; preds = %B0.endif.endif.else.endif.endif.endif.i
  %.689.i = mul nsw i64 %.2040, %arg.shape.1
  br label %B192.if.i

B0.endif.endif.else.if.i:                         ; preds = %B0.endif.else.endif.endif.i8869
  br label %B0.endif.endif.else.endif.i

B0.endif.endif.else.endif.i:                      ; preds = %B0.endif.endif.else.if.i, %B0.endif.else.endif.endif.i8869
  %.418.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.else.if.i ], [ %.274.i, %B0.endif.else.endif.endif.i8869 ]
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
  %183 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.690.i
  %.719.i = getelementptr double, ptr %183, i64 %.705.i
  %.720.i = load double, ptr %.719.i, align 8, !noalias !42
  %gep9189 = getelementptr double, ptr %invariant.gep9188, i64 %.590.0748.i
  %.753.i = load double, ptr %gep9189, align 8, !noalias !42
  %.754.i = fadd double %.720.i, %.753.i
  %184 = getelementptr i64, ptr %.531.i, i64 %.590.0748.i
  %.786.i = load i64, ptr %184, align 8, !noalias !42
  %.787.i = add nsw i64 %.786.i, %.756.i
  %.801.i = icmp slt i64 %.787.i, 0
  %.802.i = select i1 %.801.i, i64 %arg.batch.5.0.5.0, i64 0
  %185 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.787.i
  %.816.i = getelementptr double, ptr %185, i64 %.802.i
  store double %.754.i, ptr %.816.i, align 8, !noalias !42
  %exitcond.not.i8873 = icmp eq i64 %arg.shape.1, %.661.i
  br i1 %exitcond.not.i8873, label %B322.i, label %B192.if.i

B434.if.i:                                        ; preds = %B434.if.i, %B434.if.lr.ph.i
  %.950.0764.i = phi i64 [ 0, %B434.if.lr.ph.i ], [ %.1019.i, %B434.if.i ]
  %.1019.i = add nsw i64 %.950.0764.i, 1
  %186 = getelementptr i64, ptr %.531.i, i64 %.950.0764.i
  %.1075.i = load i64, ptr %186, align 8, !noalias !42
  %.1076.i = add nsw i64 %.1075.i, %.887.i
  %.1090.i = icmp slt i64 %.1076.i, 0
  %.1091.i = select i1 %.1090.i, i64 %arg.batch.5.0.5.0, i64 0
  %187 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1076.i
  %.1105.i = getelementptr double, ptr %187, i64 %.1091.i
  %.1106.i = load double, ptr %.1105.i, align 8, !noalias !42
  %.1111.i = add nsw i64 %.950.0764.i, %.1110.i
  %.1125.i = icmp slt i64 %.1111.i, 0
  %.1126.i = select i1 %.1125.i, i64 %arg.batch.5.0.5.0, i64 0
  %188 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1111.i
  %.1140.i8881 = getelementptr double, ptr %188, i64 %.1126.i
  store double %.1106.i, ptr %.1140.i8881, align 8, !noalias !42
  %exitcond767.not.i = icmp eq i64 %arg.shape.1, %.1019.i
  br i1 %exitcond767.not.i, label %B1604, label %B434.if.i

B1604:                                            ; preds = %B434.if.i, %B0.endif.endif.else.endif.endif.endif.i, %B1380.if
  %exitcond9315.not = icmp eq i64 %.1971.09193, %storemerge8762
  br i1 %exitcond9315.not, label %B1606, label %B1380.if

B1606:                                            ; preds = %B1604, %B1348
  %.2304 = load i64, ptr %.2303, align 8
  %.2349 = inttoptr i64 %.2304 to ptr
  tail call void %.2349(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %brmerge8829 = select i1 %.983, i1 true, i1 %.541
  %or.cond8830 = select i1 %brmerge8829, i1 true, i1 %.2380
  %spec.select8846 = select i1 %or.cond8830, i1 true, i1 %.2385
  br i1 %.603, label %B1838, label %B1748.if

B1756:                                            ; preds = %B1748.if
  %189 = getelementptr double, ptr %31, i64 %.2425.09196
  %.2584 = load double, ptr %189, align 8
  %.2585 = fcmp ogt double %.2584, 5.000000e-01
  br label %B1792

B1792:                                            ; preds = %B1756, %B1748.if
  %"$phi1792.1.2.2" = phi i1 [ true, %B1748.if ], [ %.2585, %B1756 ]
  br i1 %looked.4.29199, label %B1834, label %B1798

B1798:                                            ; preds = %B1792
  %190 = getelementptr double, ptr %32, i64 %.2425.09196
  %.2659 = load double, ptr %190, align 8
  %.2660 = fcmp ogt double %.2659, 5.000000e-01
  br label %B1834

B1834:                                            ; preds = %B1798, %B1792
  %"$phi1834.1.2.2" = phi i1 [ true, %B1792 ], [ %.2660, %B1798 ]
  %.2481 = icmp sgt i64 %.2428.09197, 1
  br i1 %.2481, label %B1748.if, label %B1838

B1838:                                            ; preds = %B1834, %B1606
  %good.2.1.lcssa = phi i1 [ false, %B1606 ], [ %"$phi1792.1.2.2", %B1834 ]
  %looked.4.2.lcssa = phi i1 [ %spec.select8846, %B1606 ], [ %"$phi1834.1.2.2", %B1834 ]
  %looked.4.2.lcssa.not9320 = xor i1 %looked.4.2.lcssa, true
  %brmerge9321 = or i1 %.603, %looked.4.2.lcssa.not9320
  br i1 %brmerge9321, label %B2416, label %B80.if.i

B1908.preheader:                                  ; preds = %B502.i
  br i1 %.603, label %B2416, label %B1908.if

B126.i:                                           ; preds = %B80.if.i
  %.318.i590 = getelementptr double, ptr %33, i64 %.105.i437.09203
  %.319.i591 = load double, ptr %.318.i590, align 8, !noalias !49
  %.5.i.i = fptosi double %.319.i591 to i64
  %.397.i = getelementptr double, ptr %34, i64 %.105.i437.09203
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
  %.923.i = getelementptr double, ptr %35, i64 %.105.i437.09203
  %.924.i1016 = load double, ptr %.923.i, align 8, !noalias !49
  %.926.i = sitofp i64 %.698.i861 to double
  %.927.i = fsub double %.924.i1016, %.926.i
  store double %.927.i, ptr %.923.i, align 8, !noalias !49
  br label %B502.i

B502.i:                                           ; preds = %B126.i, %B80.if.i
  %.163.i494 = icmp sgt i64 %.108.i438.09204, 1
  br i1 %.163.i494, label %B80.if.i, label %B1908.preheader

B80.if.i:                                         ; preds = %B1838, %B502.i
  %.108.i438.09204 = phi i64 [ %.172.i1046, %B502.i ], [ %storemerge, %B1838 ]
  %.105.i437.09203 = phi i64 [ %.176.i, %B502.i ], [ 0, %B1838 ]
  %.172.i1046 = add nsw i64 %.108.i438.09204, -1
  %.176.i = add nsw i64 %.105.i437.09203, 1
  %191 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i437.09203
  %.258.i545 = load i64, ptr %191, align 8, !noalias !49
  %.263.i = icmp sgt i64 %.258.i545, -1
  br i1 %.263.i, label %B126.i, label %B502.i

B2008:                                            ; preds = %B1908.if
  %.3114 = getelementptr double, ptr %38, i64 %.2780.09206
  %.3115 = load double, ptr %.3114, align 8
  %.3116 = fcmp ogt double %.3115, 5.000000e-01
  br i1 %.3116, label %B2046, label %B2146

B2046:                                            ; preds = %B2008
  %.5.i = fptosi double %.3115 to i64
  %192 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2780.09206
  %.84.i1916 = load i64, ptr %192, align 8, !noalias !53
  %.89.i1919 = icmp sgt i64 %.84.i1916, -1
  br i1 %.89.i1919, label %B46.i, label %B2146

B2146:                                            ; preds = %B2008, %B46.i, %B2046, %B80.i1953
  %.3302 = getelementptr double, ptr %39, i64 %.2780.09206
  %.3303 = load double, ptr %.3302, align 8
  %.3304 = fcmp ogt double %.3303, 5.000000e-01
  br i1 %.3304, label %B2184, label %B2414

B2184:                                            ; preds = %B2146
  %spec.select = select i1 %within.3.29208, i1 true, i1 %.2380
  %.3380 = mul i64 %.2941, %arg.batch.3.3.5.1
  %.3384 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.3380
  %.3385 = load i64, ptr %.3384, align 8
  %.3396.0 = and i64 %.3385, 127
  %.3426 = icmp eq i64 %.3396.0, 0
  br i1 %.3426, label %B2292, label %B2254

B2254:                                            ; preds = %B2184
  %.3487 = getelementptr double, ptr %40, i64 %.2780.09206
  %.3488 = load double, ptr %.3487, align 8
  %.3490 = fcmp ogt double %.3488, 0.000000e+00
  br i1 %.3490, label %B2292, label %B2322

B2292:                                            ; preds = %B2184, %B2254
  store double 1.000000e+00, ptr %.3056, align 8
  br label %B2322

B2322:                                            ; preds = %B2292, %B2254
  %doubted.5.5 = phi i1 [ true, %B2292 ], [ %doubted.3.29209, %B2254 ]
  %.3573 = icmp slt i64 %.2996, %arg.batch.2.5.0
  br i1 %.3573, label %B2360, label %B2414

B2360:                                            ; preds = %B2322
  %.3597 = icmp slt i64 %.2996, 0
  %.3598 = select i1 %.3597, i64 %arg.batch.2.5.0, i64 0
  %193 = getelementptr double, ptr %arg.batch.2.4, i64 %.2996
  %.3612 = getelementptr double, ptr %193, i64 %.3598
  %.3613 = load double, ptr %.3612, align 8
  %.3671 = getelementptr double, ptr %41, i64 %.2780.09206
  %.3672 = load double, ptr %.3671, align 8
  %.3673 = fcmp olt double %.3613, %.3672
  br i1 %.3673, label %B2410, label %B2414

B2410:                                            ; preds = %B2360
  br label %B2414

B2414:                                            ; preds = %B1908.if, %B2410, %B2360, %B2322, %B2146
  %within.4.3 = phi i1 [ true, %B2410 ], [ %spec.select, %B2360 ], [ %spec.select, %B2322 ], [ %within.3.29208, %B2146 ], [ %within.3.29208, %B1908.if ]
  %doubted.4.3 = phi i1 [ %doubted.5.5, %B2410 ], [ %doubted.5.5, %B2360 ], [ %doubted.5.5, %B2322 ], [ %doubted.3.29209, %B2146 ], [ %doubted.3.29209, %B1908.if ]
  %.2842 = icmp sgt i64 %.2783.09207, 1
  br i1 %.2842, label %B1908.if, label %B2416.loopexit

B2416.loopexit:                                   ; preds = %B2414
  %194 = xor i1 %doubted.4.3, true
  %195 = select i1 %194, i1 true, i1 %.545
  br label %B2416

B2416:                                            ; preds = %B1838, %B2416.loopexit, %B1908.preheader
  %within.5.1 = phi i1 [ false, %B1838 ], [ false, %B1908.preheader ], [ %within.4.3, %B2416.loopexit ]
  %doubted.2.1 = phi i1 [ true, %B1838 ], [ true, %B1908.preheader ], [ %195, %B2416.loopexit ]
  %brmerge8831.not = select i1 %good.2.1.lcssa, i1 %.543.not, i1 false
  br i1 %brmerge8831.not, label %B2424, label %B2540

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
  %196 = select i1 %.2385, i1 %good.2.1.lcssa, i1 false
  br i1 %196, label %B2636, label %B2758

B2636:                                            ; preds = %B2616
  %.3931 = load i64, ptr %.3930, align 8
  %.3978 = inttoptr i64 %.3931 to ptr
  tail call void %.3978(ptr %.502, ptr %.3952, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.603, label %B2758, label %B38.if.i

B80.i2162:                                        ; preds = %B38.if.i
  %.287.i2206 = getelementptr double, ptr %42, i64 %.78.i2024.09213
  %.288.i2207 = load double, ptr %.287.i2206, align 8, !noalias !56
  %.289.i2208 = fcmp ogt double %.288.i2207, 5.000000e-01
  br i1 %.289.i2208, label %B34.i.i, label %B457.i

B34.i.i:                                          ; preds = %B80.i2162, %B36.i.i
  %.48.i.i1984.0 = phi i64 [ %.119.i.i2785, %B36.i.i ], [ 0, %B80.i2162 ]
  %exitcond9316.not = icmp eq i64 %.48.i.i1984.0, %arg.shape.6
  br i1 %exitcond9316.not, label %B118.endif.i, label %B36.i.i

B36.i.i:                                          ; preds = %B34.i.i
  %.119.i.i2785 = add i64 %.48.i.i1984.0, 1
  %.149.i.i2752 = add nsw i64 %.48.i.i1984.0, %arg.shape.6
  %.151.i.i2754 = mul nsw i64 %.149.i.i2752, %arg.shape.0
  %.153.i.i2756 = add nsw i64 %.151.i.i2754, %.78.i2024.09213
  %.167.i.i = icmp slt i64 %.153.i.i2756, 0
  %.168.i.i2764 = select i1 %.167.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %197 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i.i2756
  %.182.i.i = getelementptr double, ptr %197, i64 %.168.i.i2764
  %.183.i.i = load double, ptr %.182.i.i, align 8, !noalias !60
  %.184.i.i = fcmp ogt double %.183.i.i, 5.000000e-01
  br i1 %.184.i.i, label %B118.endif.i, label %B34.i.i

B166.i:                                           ; preds = %B118.endif.i
  %.383.i2511 = getelementptr double, ptr %46, i64 %.78.i2024.09213
  %.384.i2512 = load double, ptr %.383.i2511, align 8, !noalias !56
  %.385.i2513 = fadd double %.384.i2512, 1.000000e+00
  store double %.385.i2513, ptr %.383.i2511, align 8, !noalias !56
  %.491.i = getelementptr double, ptr %47, i64 %.78.i2024.09213
  store double 1.000000e+00, ptr %.491.i, align 8, !noalias !56
  %.546.i2648 = getelementptr double, ptr %48, i64 %.78.i2024.09213
  store double 0.000000e+00, ptr %.546.i2648, align 8, !noalias !56
  %.601.i2693 = getelementptr double, ptr %49, i64 %.78.i2024.09213
  store double 1.000000e+00, ptr %.601.i2693, align 8, !noalias !56
  %.659.i2740 = getelementptr i64, ptr %50, i64 %.78.i2024.09213
  store i64 %.296.i2034.0, ptr %.659.i2740, align 8, !noalias !56
  br label %B457.i

B328.i:                                           ; preds = %B118.endif.i
  %.722.i2329 = getelementptr double, ptr %43, i64 %.78.i2024.09213
  %.723.i2330 = load double, ptr %.722.i2329, align 8, !noalias !56
  %.724.i2331 = fcmp oeq double %.723.i2330, 3.000000e+00
  br i1 %.724.i2331, label %B376.i, label %B408.i

B376.i:                                           ; preds = %B328.i
  %.779.i2464 = getelementptr double, ptr %44, i64 %.78.i2024.09213
  %.780.i2465 = load double, ptr %.779.i2464, align 8, !noalias !56
  br label %B408.i

B408.i:                                           ; preds = %B328.i, %B376.i
  %"$phi408.1.2.i.3" = phi double [ %.780.i2465, %B376.i ], [ 0.000000e+00, %B328.i ]
  %.842.i2378 = getelementptr double, ptr %45, i64 %.78.i2024.09213
  store double %"$phi408.1.2.i.3", ptr %.842.i2378, align 8, !noalias !56
  store double 0.000000e+00, ptr %.722.i2329, align 8, !noalias !56
  br label %B457.i

B457.i:                                           ; preds = %B38.if.i, %B80.i2162, %B408.i, %B166.i
  %some.3.i.1 = phi i1 [ true, %B166.i ], [ %some.2.i.09215, %B408.i ], [ %some.2.i.09215, %B80.i2162 ], [ %some.2.i.09215, %B38.if.i ]
  %.136.i2085 = icmp sgt i64 %.81.i2025.09214, 1
  br i1 %.136.i2085, label %B38.if.i, label %B2758

B38.if.i:                                         ; preds = %B2636, %B457.i
  %some.2.i.09215 = phi i1 [ %some.3.i.1, %B457.i ], [ false, %B2636 ]
  %.81.i2025.09214 = phi i64 [ %.145.i2795, %B457.i ], [ %storemerge, %B2636 ]
  %.78.i2024.09213 = phi i64 [ %.149.i2798, %B457.i ], [ 0, %B2636 ]
  %.145.i2795 = add nsw i64 %.81.i2025.09214, -1
  %.149.i2798 = add nsw i64 %.78.i2024.09213, 1
  %.230.i2151 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.78.i2024.09213
  %.231.i2152 = load i64, ptr %.230.i2151, align 8, !noalias !56
  %.232.i2153 = icmp sgt i64 %.231.i2152, -1
  br i1 %.232.i2153, label %B80.i2162, label %B457.i

B118.endif.i:                                     ; preds = %B36.i.i, %B34.i.i
  %.296.i2034.0 = phi i64 [ %.48.i.i1984.0, %B36.i.i ], [ -1, %B34.i.i ]
  %.326.i = icmp sgt i64 %.296.i2034.0, -1
  br i1 %.326.i, label %B166.i, label %B328.i

B2758:                                            ; preds = %B457.i, %B2636, %B2616
  %beyond.2.1 = phi i1 [ false, %B2616 ], [ false, %B2636 ], [ %some.3.i.1, %B457.i ]
  %brmerge8835 = select i1 %within.5.1, i1 true, i1 %beyond.2.1
  br i1 %brmerge8835, label %B2768, label %B3292

B2768:                                            ; preds = %B2758
  br i1 %.545, label %B3184.critedge, label %B2816.if

B140.i:                                           ; preds = %B64.if.i3827
  %.409.i3143 = getelementptr double, ptr %52, i64 %.138.i2911.09221
  %.410.i3144 = load double, ptr %.409.i3143, align 8, !noalias !64
  %.411.i3145 = fcmp uge double %.410.i3144, 5.000000e-01
  %.424.i3153.not = icmp slt i64 %.346.i3091, %arg.batch.2.5.0
  %or.cond8836 = select i1 %.411.i3145, i1 %.424.i3153.not, i1 false
  br i1 %or.cond8836, label %B216.i, label %B479.i

B216.i:                                           ; preds = %B140.i
  %.440.i3164 = icmp slt i64 %.346.i3091, 0
  %.441.i3165 = select i1 %.440.i3164, i64 %arg.batch.2.5.0, i64 0
  %198 = getelementptr double, ptr %arg.batch.2.4, i64 %.346.i3091
  %.455.i3179 = getelementptr double, ptr %198, i64 %.441.i3165
  %.456.i3180 = load double, ptr %.455.i3179, align 8, !noalias !64
  %.510.i3227 = getelementptr double, ptr %53, i64 %.138.i2911.09221
  %.511.i3228 = load double, ptr %.510.i3227, align 8, !noalias !64
  %.512.i3229 = fcmp ult double %.456.i3180, %.511.i3228
  br i1 %.512.i3229, label %B268.i3230, label %B479.i

B268.i3230:                                       ; preds = %B216.i
  %.574.i3277 = getelementptr double, ptr %54, i64 %.138.i2911.09221
  %.575.i3278 = load double, ptr %.574.i3277, align 8, !noalias !64
  %.576.i3279 = fcmp ogt double %.575.i3278, 1.000000e+00
  br i1 %.576.i3279, label %B306.i, label %B479.i

B306.i:                                           ; preds = %B268.i3230
  %.632.i3328 = getelementptr double, ptr %55, i64 %.138.i2911.09221
  %.633.i3329 = load double, ptr %.632.i3328, align 8, !noalias !64
  store double 0.000000e+00, ptr %.409.i3143, align 8, !noalias !68
  %.161.i.i3489 = getelementptr double, ptr %56, i64 %.138.i2911.09221
  store double 0.000000e+00, ptr %.161.i.i3489, align 8, !noalias !68
  %.214.i.i3521 = getelementptr double, ptr %57, i64 %.138.i2911.09221
  store double %.633.i3329, ptr %.214.i.i3521, align 8, !noalias !68
  %.268.i.i3543 = load i64, ptr %.290.i3044, align 8, !noalias !68
  %.294.i.i3553 = icmp slt i64 %.268.i.i3543, 0
  %.295.i.i = select i1 %.294.i.i3553, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i.i = add i64 %.295.i.i, %.268.i.i3543
  %.316.i.i3565 = mul i64 %.296.i.i, %arg.batch.3.3.5.1
  %.320.i.i3566 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i.i3565
  %.321.i.i3567 = load i64, ptr %.320.i.i3566, align 8, !noalias !68
  %.322.i.i = add nsw i64 %.321.i.i3567, -1
  store i64 %.322.i.i, ptr %.320.i.i3566, align 8, !noalias !68
  %.426.i.i3599 = load i64, ptr %.290.i3044, align 8, !noalias !68
  %.452.i.i = icmp slt i64 %.426.i.i3599, 0
  %.453.i.i = select i1 %.452.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i = add i64 %.453.i.i, %.426.i.i3599
  %.474.i.i = mul i64 %.454.i.i, %arg.batch.3.3.5.1
  %199 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i
  %.478.i.i = getelementptr i8, ptr %199, i64 24
  %.479.i.i = load i64, ptr %.478.i.i, align 8, !noalias !68
  %.480.i.i = add nsw i64 %.479.i.i, 1
  store i64 %.480.i.i, ptr %.478.i.i, align 8, !noalias !68
  %.705.i3629 = load double, ptr %.455.i3179, align 8, !noalias !64
  %.761.i3677 = getelementptr double, ptr %58, i64 %.138.i2911.09221
  store double 0.000000e+00, ptr %.761.i3677, align 8, !noalias !64
  %.818.i3726 = getelementptr double, ptr %59, i64 %.138.i2911.09221
  store double %.705.i3629, ptr %.818.i3726, align 8, !noalias !64
  %.871.i3769 = mul i64 %.291.i3045, %arg.batch.3.3.5.1
  %200 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.871.i3769
  %.875.i3773 = getelementptr i8, ptr %200, i64 8
  %.876.i3774 = load i64, ptr %.875.i3773, align 8, !noalias !64
  %.877.i3775 = add nsw i64 %.876.i3774, 3
  store i64 %.877.i3775, ptr %.875.i3773, align 8, !noalias !64
  br label %B479.i

B479.i:                                           ; preds = %B268.i3230, %B306.i, %B64.if.i3827, %B140.i, %B216.i
  %.196.i2981 = icmp sgt i64 %.141.i2912.09220, 1
  br i1 %.196.i2981, label %B64.if.i3827, label %B3184

B64.if.i3827:                                     ; preds = %B2816.if, %B479.i
  %.138.i2911.09221 = phi i64 [ %.209.i3835, %B479.i ], [ 0, %B2816.if ]
  %.141.i2912.09220 = phi i64 [ %.205.i3832, %B479.i ], [ %storemerge, %B2816.if ]
  %.205.i3832 = add nsw i64 %.141.i2912.09220, -1
  %.209.i3835 = add nsw i64 %.138.i2911.09221, 1
  %.290.i3044 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.138.i2911.09221
  %.291.i3045 = load i64, ptr %.290.i3044, align 8, !noalias !64
  %.345.i3090 = getelementptr i64, ptr %51, i64 %.138.i2911.09221
  %.346.i3091 = load i64, ptr %.345.i3090, align 8, !noalias !64
  %.354.i3095 = icmp slt i64 %.291.i3045, 0
  br i1 %.354.i3095, label %B479.i, label %B140.i

B3184.critedge:                                   ; preds = %B2768
  %.4432.c = load i64, ptr %.4431.c, align 8
  %.4477.c = inttoptr i64 %.4432.c to ptr
  tail call void %.4477.c(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3184

B3184:                                            ; preds = %B479.i, %B2816.if, %B3184.critedge
  br i1 %beyond.2.1, label %B3188, label %B3230

B3188:                                            ; preds = %B3184
  %.224.i = load double, ptr %.223.i, align 8, !noalias !71
  %.253.i = load double, ptr %arg.batch.2.4, align 8, !noalias !71
  br label %B194.if.i8883

B192.loopexit.i.critedge:                         ; preds = %B194.if.i8883
  %.779.i.c = load i64, ptr %.778.i, align 8, !noalias !71
  %.896.i8887.c = inttoptr i64 %.779.i.c to ptr
  tail call void %.896.i8887.c(ptr %.502, ptr %.870.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !71
  br label %B192.loopexit.i

B192.loopexit.i:                                  ; preds = %B1407.i, %B192.loopexit.i.critedge
  %.370.i = icmp ugt i64 %.314.01481.i, 1
  br i1 %.370.i, label %B194.if.i8883, label %B762.i

B228.loopexit.i:                                  ; preds = %B122.if.i.i, %B228.if.i
  %exitcond1487.not.i = icmp eq i64 %arg.shape.0, %.501.i
  br i1 %exitcond1487.not.i, label %B394.i, label %B228.if.i

B122.if.i.i:                                      ; preds = %B122.if.i.lr.ph.i, %B122.if.i.i
  %.229.i.01473.i = phi i64 [ 0, %B122.if.i.lr.ph.i ], [ %.300.i.i, %B122.if.i.i ]
  %.157.i.i.i = add nsw i64 %.229.i.01473.i, %.155.i.i.i
  %.159.i.i.i = mul nsw i64 %.157.i.i.i, %arg.shape.0
  %gep9223 = getelementptr double, ptr %invariant.gep9222, i64 %.159.i.i.i
  %.191.i.i.i = load double, ptr %gep9223, align 8, !noalias !74
  %.193.i.i.i = fadd double %.191.i.i.i, 0.000000e+00
  %.253.i.i.i = fmul double %share.3.2.i, %.193.i.i.i
  %.157.i.i.1.i = add nsw i64 %.229.i.01473.i, %.155.i.i.1.i
  %.159.i.i.1.i = mul nsw i64 %.157.i.i.1.i, %arg.shape.0
  %gep9225 = getelementptr double, ptr %invariant.gep9224, i64 %.159.i.i.1.i
  %.191.i.i.1.i = load double, ptr %gep9225, align 8, !noalias !74
  %.193.i.i.1.i = fadd double %.191.i.i.1.i, %.253.i.i.i
  %.253.i.i.1.i = fmul double %.247.i.i.i, %.193.i.i.1.i
  %.157.i.i.2.i = add nsw i64 %.229.i.01473.i, %.155.i.i.2.i
  %.159.i.i.2.i = mul nsw i64 %.157.i.i.2.i, %arg.shape.0
  %gep9227 = getelementptr double, ptr %invariant.gep9226, i64 %.159.i.i.2.i
  %.191.i.i.2.i = load double, ptr %gep9227, align 8, !noalias !74
  %.193.i.i.2.i = fadd double %.191.i.i.2.i, %.253.i.i.1.i
  %.253.i.i.2.i = fmul double %share.3.2.i, %.193.i.i.2.i
  %.157.i.i.3.i = add nsw i64 %.229.i.01473.i, %.155.i.i.3.i
  %.159.i.i.3.i = mul nsw i64 %.157.i.i.3.i, %arg.shape.0
  %gep9229 = getelementptr double, ptr %invariant.gep9228, i64 %.159.i.i.3.i
  %.191.i.i.3.i = load double, ptr %gep9229, align 8, !noalias !74
  %.193.i.i.3.i = fadd double %.191.i.i.3.i, %.253.i.i.2.i
  %.253.i.i.3.i = fmul double %.247.i.i.i, %.193.i.i.3.i
  %.157.i.i.4.i = add nsw i64 %.229.i.01473.i, %.155.i.i.4.i
  %.159.i.i.4.i = mul nsw i64 %.157.i.i.4.i, %arg.shape.0
  %gep9231 = getelementptr double, ptr %invariant.gep9230, i64 %.159.i.i.4.i
  %.191.i.i.4.i = load double, ptr %gep9231, align 8, !noalias !74
  %.193.i.i.4.i = fadd double %.191.i.i.4.i, %.253.i.i.3.i
  %.253.i.i.4.i = fmul double %share.3.2.i, %.193.i.i.4.i
  %.157.i.i.5.i = add nsw i64 %.229.i.01473.i, %.155.i.i.5.i
  %.159.i.i.5.i = mul nsw i64 %.157.i.i.5.i, %arg.shape.0
  %gep9233 = getelementptr double, ptr %invariant.gep9232, i64 %.159.i.i.5.i
  %.191.i.i.5.i = load double, ptr %gep9233, align 8, !noalias !74
  %.193.i.i.5.i = fadd double %.191.i.i.5.i, %.253.i.i.4.i
  %.253.i.i.5.i = fmul double %.247.i.i.i, %.193.i.i.5.i
  %.157.i.i.6.i = add nsw i64 %.229.i.01473.i, %.155.i.i.6.i
  %.159.i.i.6.i = mul nsw i64 %.157.i.i.6.i, %arg.shape.0
  %gep9235 = getelementptr double, ptr %invariant.gep9234, i64 %.159.i.i.6.i
  %.191.i.i.6.i = load double, ptr %gep9235, align 8, !noalias !74
  %.193.i.i.6.i = fadd double %.191.i.i.6.i, %.253.i.i.5.i
  %.253.i.i.6.i = fmul double %share.3.2.i, %.193.i.i.6.i
  %.300.i.i = add nsw i64 %.229.i.01473.i, 1
  %.271.i.i.i = mul nsw i64 %.229.i.01473.i, %arg.shape.0
  %gep9237 = getelementptr double, ptr %invariant.gep9236, i64 %.271.i.i.i
  %.309.i.i.i = load double, ptr %gep9237, align 8, !noalias !74
  %.313.i.i.i = fadd double %.309.i.i.i, %.253.i.i.6.i
  %.360.i.i = add nsw i64 %.229.i.01473.i, %.359.i.i
  %.362.i.i8885 = mul nsw i64 %.360.i.i, %arg.shape.0
  %gep9239 = getelementptr double, ptr %invariant.gep9238, i64 %.362.i.i8885
  store double %.313.i.i.i, ptr %gep9239, align 8, !noalias !81
  %exitcond.not.i8886 = icmp eq i64 %arg.shape.1, %.300.i.i
  br i1 %exitcond.not.i8886, label %B228.loopexit.i, label %B122.if.i.i

B394.i:                                           ; preds = %B228.loopexit.i
  %.779.i = load i64, ptr %.778.i, align 8, !noalias !71
  %.896.i8887 = inttoptr i64 %.779.i to ptr
  tail call void %.896.i8887(ptr %.502, ptr %.870.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !71
  br label %B542.if.i

B594.i:                                           ; preds = %B542.if.i
  %.1129.i = getelementptr double, ptr %61, i64 %.922.01479.i
  %.1130.i8903 = load double, ptr %.1129.i, align 8, !noalias !71
  %.1184.i = getelementptr double, ptr %62, i64 %.922.01479.i
  %.1185.i = load double, ptr %.1184.i, align 8, !noalias !71
  %.1186.i = fadd double %.1130.i8903, %.1185.i
  %.1187.i = fmul double %.1186.i, 5.000000e-01
  br label %B34.i.i8904

B34.i.i8904:                                      ; preds = %B34.if.i.i8905, %B594.i
  %.48.i.0.i = phi i64 [ 0, %B594.i ], [ %.119.i88.i, %B34.if.i.i8905 ]
  %exitcond1488.not.i = icmp eq i64 %.48.i.0.i, %storemerge1459.i
  br i1 %exitcond1488.not.i, label %B732.i, label %B34.if.i.i8905

B80.i.i8907:                                      ; preds = %B34.if.i.i8905
  %201 = icmp sgt i64 %.48.i.0.i, -1
  br i1 %201, label %B706.i, label %B732.i

B34.if.i.i8905:                                   ; preds = %B34.i.i8904
  %.119.i88.i = add i64 %.48.i.0.i, 1
  %.149.i53.i = add nsw i64 %.48.i.0.i, %arg.shape.6
  %.151.i55.i = mul nsw i64 %.149.i53.i, %arg.shape.0
  %.153.i56.i = add nsw i64 %.151.i55.i, %.922.01479.i
  %.167.i61.i = icmp slt i64 %.153.i56.i, 0
  %.168.i62.i = select i1 %.167.i61.i, i64 %arg.batch.5.4.5.0, i64 0
  %202 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i56.i
  %.182.i74.i = getelementptr double, ptr %202, i64 %.168.i62.i
  %.183.i75.i = load double, ptr %.182.i74.i, align 8, !noalias !82
  %.184.i.i8906 = fcmp ogt double %.183.i75.i, 5.000000e-01
  br i1 %.184.i.i8906, label %B80.i.i8907, label %B34.i.i8904

B706.i:                                           ; preds = %B80.i.i8907
  store double %.1187.i, ptr %.1184.i, align 8, !noalias !71
  br label %B1407.i

B732.i:                                           ; preds = %B34.i.i8904, %B80.i.i8907
  store double %.1187.i, ptr %.1129.i, align 8, !noalias !71
  br label %B1407.i

B762.i:                                           ; preds = %B192.loopexit.i
  %.254.i = fsub double %.224.i, %.253.i
  %.255.i = fmul double %.254.i, 1.000000e-13
  br i1 %.603, label %B3230, label %B794.if.lr.ph.i

B794.if.lr.ph.i:                                  ; preds = %B762.i
  %.1998.i = fmul double %.255.i, 2.000000e+00
  br label %B794.if.i

B896.i:                                           ; preds = %B794.if.i
  %.1712.i = getelementptr double, ptr %64, i64 %.1394.01483.i
  %.1713.i = load double, ptr %.1712.i, align 8, !noalias !71
  %.1769.i = load double, ptr %.1545.i, align 8, !noalias !71
  %.1770.i = tail call double @llvm.fabs.f64(double %.1769.i)
  %.1771.i = fmul double %.1770.i, 2.000000e-12
  %.1828.i = getelementptr double, ptr %61, i64 %.1394.01483.i
  %.1829.i = load double, ptr %.1828.i, align 8, !noalias !71
  %.1834.i = fmul double %.1713.i, 0x3D719799812DEA11
  %.10.i.i8893 = fcmp ogt double %.1771.i, %.1834.i
  %.11.i.i8894 = select i1 %.10.i.i8893, double %.1771.i, double %.1834.i
  %.1830.i = fsub double 1.000000e+00, %.1829.i
  %.1832.i = fmul double %.1713.i, %.1830.i
  %.1863.i = fcmp ole double %.1832.i, %.11.i.i8894
  %.1924.i = getelementptr double, ptr %66, i64 %.1394.01483.i
  %.1925.i = load double, ptr %.1924.i, align 8, !noalias !71
  %.1927.i = fcmp ogt double %.1925.i, 8.000000e+00
  br i1 %.1927.i, label %B1146.i, label %B1188.i

B1146.i:                                          ; preds = %B896.i
  br i1 %.1863.i, label %B1210.i, label %B34.i162.i

B34.i162.i:                                       ; preds = %B1146.i, %B34.if.i270.i
  %.59.i119.0.i = phi i64 [ %.130.i278.i, %B34.if.i270.i ], [ 0, %B1146.i ]
  %exitcond1490.i = icmp eq i64 %.59.i119.0.i, %storemerge1465.i
  br i1 %exitcond1490.i, label %B1188.i, label %B34.if.i270.i

B34.if.i270.i:                                    ; preds = %B34.i162.i
  %.130.i278.i = add i64 %.59.i119.0.i, 1
  %.156.i.i = mul nsw i64 %.59.i119.0.i, %arg.shape.0
  %.158.i184.i = add nsw i64 %.156.i.i, %.1394.01483.i
  %.172.i193.i = icmp slt i64 %.158.i184.i, 0
  %.173.i194.i = select i1 %.172.i193.i, i64 %arg.batch.5.0.5.0, i64 0
  %203 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.158.i184.i
  %.187.i208.i = getelementptr double, ptr %203, i64 %.173.i194.i
  %.188.i209.i = load double, ptr %.187.i208.i, align 8, !noalias !86
  %.191.i.i = add nsw i64 %.59.i119.0.i, %.190.i211.i
  %.193.i213.i = mul nsw i64 %.191.i.i, %arg.shape.0
  %.195.i215.i = add nsw i64 %.193.i213.i, %.1394.01483.i
  %.209.i.i = icmp slt i64 %.195.i215.i, 0
  %.210.i224.i = select i1 %.209.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %204 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.195.i215.i
  %.224.i232.i = getelementptr double, ptr %204, i64 %.210.i224.i
  %.225.i233.i = load double, ptr %.224.i232.i, align 8, !noalias !86
  %.255.i.i = load double, ptr %.254.i.i8890, align 8, !noalias !86
  %.285.i262.i = load double, ptr %arg.tolerances.4, align 8, !noalias !86
  %.286.i263.i = tail call double @llvm.fabs.f64(double %.188.i209.i)
  %.287.i264.i = fmul double %.286.i263.i, %.285.i262.i
  %.288.i265.i = fadd double %.255.i.i, %.287.i264.i
  %.290.i.i = fsub double %.225.i233.i, %.188.i209.i
  %.291.i.i = tail call double @llvm.fabs.f64(double %.290.i.i)
  %.293.i267.i = fmul double %.286.i263.i, 0x3D06849B86A12B9B
  %.294.i.i = fadd double %.293.i267.i, %.288.i265.i
  %.295.i.i8902 = fcmp ogt double %.291.i.i, %.294.i.i
  br i1 %.295.i.i8902, label %B1188.i, label %B34.i162.i

B1188.i:                                          ; preds = %B34.if.i270.i, %B34.i162.i, %B896.i
  %met.2.2.i = phi i1 [ %.1863.i, %B896.i ], [ %exitcond1490.i, %B34.i162.i ], [ %exitcond1490.i, %B34.if.i270.i ]
  %.2000.i = fcmp ole double %.1713.i, %.1998.i
  %or.cond.not.i = select i1 %met.2.2.i, i1 true, i1 %.2000.i
  br i1 %or.cond.not.i, label %B1210.i, label %B1272.i

B1210.i:                                          ; preds = %B1188.i, %B1146.i
  store double 2.000000e+00, ptr %.1655.i, align 8, !noalias !71
  store double 0.000000e+00, ptr %.1924.i, align 8, !noalias !71
  br label %B1408.i

B1272.i:                                          ; preds = %B1188.i
  store double 3.000000e+00, ptr %.1655.i, align 8, !noalias !71
  %.2226.i = getelementptr double, ptr %62, i64 %.1394.01483.i
  %.2227.i = load double, ptr %.2226.i, align 8, !noalias !71
  %.2229.i = fmul double %.1713.i, %.2227.i
  %.10.i1466.i = fcmp ogt double %.255.i, %.2229.i
  %.11.i1467.i = select i1 %.10.i1466.i, double %.255.i, double %.2229.i
  %.108.i.i = getelementptr double, ptr %67, i64 %.1394.01483.i
  store double 0.000000e+00, ptr %.108.i.i, align 8, !noalias !90
  %.161.i407.i = getelementptr double, ptr %68, i64 %.1394.01483.i
  store double 0.000000e+00, ptr %.161.i407.i, align 8, !noalias !90
  %.214.i451.i = getelementptr double, ptr %69, i64 %.1394.01483.i
  store double %.11.i1467.i, ptr %.214.i451.i, align 8, !noalias !90
  %205 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1394.01483.i
  %.268.i492.i = load i64, ptr %205, align 8, !noalias !90
  %.294.i509.i = icmp slt i64 %.268.i492.i, 0
  %.295.i510.i = select i1 %.294.i509.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i511.i = add i64 %.295.i510.i, %.268.i492.i
  %.316.i526.i = mul i64 %.296.i511.i, %arg.batch.3.3.5.1
  %.320.i.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i526.i
  %.321.i529.i = load i64, ptr %.320.i.i, align 8, !noalias !90
  %.322.i530.i = add nsw i64 %.321.i529.i, -1
  store i64 %.322.i530.i, ptr %.320.i.i, align 8, !noalias !90
  %.426.i.i = load i64, ptr %205, align 8, !noalias !90
  %.452.i.i8895 = icmp slt i64 %.426.i.i, 0
  %.453.i.i8896 = select i1 %.452.i.i8895, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i8897 = add i64 %.453.i.i8896, %.426.i.i
  %.474.i.i8898 = mul i64 %.454.i.i8897, %arg.batch.3.3.5.1
  %206 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i8898
  %.478.i.i8899 = getelementptr i8, ptr %206, i64 24
  %.479.i.i8900 = load i64, ptr %.478.i.i8899, align 8, !noalias !90
  %.480.i.i8901 = add nsw i64 %.479.i.i8900, 1
  store i64 %.480.i.i8901, ptr %.478.i.i8899, align 8, !noalias !90
  br label %B1408.i

B1407.i:                                          ; preds = %B542.if.i, %B732.i, %B706.i
  %exitcond1489.not.i = icmp eq i64 %arg.shape.0, %.991.i
  br i1 %exitcond1489.not.i, label %B192.loopexit.i, label %B542.if.i

B1408.i:                                          ; preds = %B794.if.i, %B1272.i, %B1210.i
  %exitcond1491.not.i = icmp eq i64 %.1464.i, %arg.shape.0
  br i1 %exitcond1491.not.i, label %B3230, label %B794.if.i

B194.if.i8883:                                    ; preds = %B192.loopexit.i, %B3188
  %.314.01481.i = phi i64 [ 50, %B3188 ], [ %.379.i, %B192.loopexit.i ]
  %.379.i = add nsw i64 %.314.01481.i, -1
  br i1 %.603, label %B192.loopexit.i.critedge, label %B228.if.i

B228.if.i:                                        ; preds = %B194.if.i8883, %B228.loopexit.i
  %.432.01476.i = phi i64 [ %.501.i, %B228.loopexit.i ], [ 0, %B194.if.i8883 ]
  %.501.i = add nsw i64 %.432.01476.i, 1
  %.582.i = getelementptr double, ptr %61, i64 %.432.01476.i
  %.583.i = load double, ptr %.582.i, align 8, !noalias !71
  %.637.i = getelementptr double, ptr %62, i64 %.432.01476.i
  %.638.i = load double, ptr %.637.i, align 8, !noalias !71
  %.639.i = fadd double %.583.i, %.638.i
  %.640.i = fmul double %.639.i, 5.000000e-01
  %.697.i = getelementptr double, ptr %63, i64 %.432.01476.i
  %.698.i = load double, ptr %.697.i, align 8, !noalias !71
  %.699.i8884 = fcmp une double %.698.i, 1.000000e+00
  %share.3.2.i = select i1 %.699.i8884, double 1.000000e+00, double %.640.i
  %.92.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.432.01476.i
  %.93.i.i = load double, ptr %.92.i.i, align 8, !noalias !81
  %.146.i.i = getelementptr double, ptr %64, i64 %.432.01476.i
  %.147.i.i = load double, ptr %.146.i.i, align 8, !noalias !81
  %.149.i.i = fmul double %share.3.2.i, %.147.i.i
  %.150.i.i = fadd double %.93.i.i, %.149.i.i
  %.203.i.i = getelementptr double, ptr %.502, i64 %.432.01476.i
  store double %.150.i.i, ptr %.203.i.i, align 8, !noalias !81
  br i1 %.287.i1472.not.i, label %B228.loopexit.i, label %B122.if.i.lr.ph.i

B122.if.i.lr.ph.i:                                ; preds = %B228.if.i
  %.247.i.i.i = fsub double 1.000000e+00, %share.3.2.i
  %invariant.gep9222 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.432.01476.i
  %invariant.gep9224 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.432.01476.i
  %invariant.gep9226 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.432.01476.i
  %invariant.gep9228 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.432.01476.i
  %invariant.gep9230 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.432.01476.i
  %invariant.gep9232 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.432.01476.i
  %invariant.gep9234 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.432.01476.i
  %invariant.gep9236 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.432.01476.i
  %invariant.gep9238 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.432.01476.i
  br label %B122.if.i.i

B542.if.i:                                        ; preds = %B394.i, %B1407.i
  %.922.01479.i = phi i64 [ %.991.i, %B1407.i ], [ 0, %B394.i ]
  %.991.i = add nsw i64 %.922.01479.i, 1
  %.1072.i8888 = getelementptr double, ptr %63, i64 %.922.01479.i
  %.1073.i = load double, ptr %.1072.i8888, align 8, !noalias !71
  %.1074.i = fcmp oeq double %.1073.i, 1.000000e+00
  br i1 %.1074.i, label %B594.i, label %B1407.i

B794.if.i:                                        ; preds = %B1408.i, %B794.if.lr.ph.i
  %.1394.01483.i = phi i64 [ 0, %B794.if.lr.ph.i ], [ %.1464.i, %B1408.i ]
  %.1464.i = add nsw i64 %.1394.01483.i, 1
  %.1545.i = getelementptr double, ptr %65, i64 %.1394.01483.i
  %.1546.i8891 = load double, ptr %.1545.i, align 8, !noalias !71
  %.1600.i = getelementptr double, ptr %.502, i64 %.1394.01483.i
  store double %.1546.i8891, ptr %.1600.i, align 8, !noalias !71
  %.1655.i = getelementptr double, ptr %63, i64 %.1394.01483.i
  %.1656.i8892 = load double, ptr %.1655.i, align 8, !noalias !71
  %.1657.i = fcmp oeq double %.1656.i8892, 1.000000e+00
  br i1 %.1657.i, label %B896.i, label %B1408.i

B3230:                                            ; preds = %B1408.i, %B762.i, %B3184
  br i1 %.4625.not, label %B3292, label %B120.if.i

B120.loopexit.i.critedge:                         ; preds = %B120.if.i
  %.527.i.c = load i64, ptr %.526.i8908, align 8, !noalias !93
  %.644.i.c = inttoptr i64 %.527.i.c to ptr
  tail call void %.644.i.c(ptr %.502, ptr %.618.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !93
  br label %B120.loopexit.i

B120.loopexit.i:                                  ; preds = %B502.i8970, %B120.loopexit.i.critedge
  %exitcond692.not.i = icmp eq i64 %.231.0688.i, %.8837
  br i1 %exitcond692.not.i, label %B3292, label %B120.if.i

B154.loopexit.i:                                  ; preds = %B122.if.i.i8921, %B154.if.i
  %exitcond690.not.i = icmp eq i64 %arg.shape.0, %.423.i
  br i1 %exitcond690.not.i, label %B206.i, label %B154.if.i

B206.i:                                           ; preds = %B154.loopexit.i
  %.527.i = load i64, ptr %.526.i8908, align 8, !noalias !93
  %.644.i = inttoptr i64 %.527.i to ptr
  tail call void %.644.i(ptr %.502, ptr %.618.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !93
  br label %B354.if.i

B396.i8971:                                       ; preds = %B354.if.i
  %207 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.670.0686.i
  %.854.i = load double, ptr %207, align 8, !noalias !93
  %.856.i = fcmp olt double %.854.i, -1.000000e-09
  br i1 %.856.i, label %B432.i, label %B502.i8970

B432.i:                                           ; preds = %B396.i8971
  %208 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.670.0686.i
  %.84.i51.i = load i64, ptr %208, align 8, !noalias !96
  %.89.i.i8972 = icmp sgt i64 %.84.i51.i, -1
  br i1 %.89.i.i8972, label %B46.i.i8973, label %B432.endif.i

B46.i.i8973:                                      ; preds = %B432.i
  %.120.i73.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i51.i
  %.121.i74.i = load i64, ptr %.120.i73.i, align 8, !noalias !96
  %.122.i75.i = icmp eq i64 %.121.i74.i, 0
  br i1 %.122.i75.i, label %B80.i.i8974, label %B432.endif.i

B80.i.i8974:                                      ; preds = %B46.i.i8973
  store i64 4, ptr %.120.i73.i, align 8, !noalias !96
  br label %B432.endif.i

B502.i8970:                                       ; preds = %B432.endif.i, %B354.if.i, %B396.i8971
  %exitcond691.not.i = icmp eq i64 %arg.shape.0, %.739.i
  br i1 %exitcond691.not.i, label %B120.loopexit.i, label %B354.if.i

B120.if.i:                                        ; preds = %B3230, %B120.loopexit.i
  %.231.0688.i = phi i64 [ %.302.i8911, %B120.loopexit.i ], [ 1, %B3230 ]
  %.302.i8911 = add nsw i64 %.231.0688.i, 1
  br i1 %.603, label %B120.loopexit.i.critedge, label %B154.if.lr.ph.i

B154.if.lr.ph.i:                                  ; preds = %B120.if.i
  %209 = uitofp i64 %.231.0688.i to double
  %.456.i = fdiv double %209, %.452.i
  %.247.i.i.i8912 = fsub double 1.000000e+00, %.456.i
  br label %B154.if.i

B154.if.i:                                        ; preds = %B154.if.lr.ph.i, %B154.loopexit.i
  %.354.0683.i = phi i64 [ 0, %B154.if.lr.ph.i ], [ %.423.i, %B154.loopexit.i ]
  %.423.i = add nsw i64 %.354.0683.i, 1
  %.92.i.i8913 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.354.0683.i
  %.93.i.i8914 = load double, ptr %.92.i.i8913, align 8, !noalias !99
  %.146.i.i8915 = getelementptr double, ptr %70, i64 %.354.0683.i
  %.147.i.i8916 = load double, ptr %.146.i.i8915, align 8, !noalias !99
  %.149.i.i8917 = fmul double %.456.i, %.147.i.i8916
  %.150.i.i8918 = fadd double %.93.i.i8914, %.149.i.i8917
  %.203.i.i8919 = getelementptr double, ptr %.502, i64 %.354.0683.i
  store double %.150.i.i8918, ptr %.203.i.i8919, align 8, !noalias !99
  br i1 %.287.i679.not.i, label %B154.loopexit.i, label %B122.if.i.preheader.i

B122.if.i.preheader.i:                            ; preds = %B154.if.i
  %invariant.gep9240 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9242 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9244 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9246 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9248 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9250 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9252 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9254 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9256 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  br label %B122.if.i.i8921

B122.if.i.i8921:                                  ; preds = %B122.if.i.i8921, %B122.if.i.preheader.i
  %.229.i.0680.i = phi i64 [ %.300.i.i8963, %B122.if.i.i8921 ], [ 0, %B122.if.i.preheader.i ]
  %.157.i.i.i8922 = add nsw i64 %.229.i.0680.i, %.155.i.i.i8920
  %.159.i.i.i8923 = mul nsw i64 %.157.i.i.i8922, %arg.shape.0
  %gep9241 = getelementptr double, ptr %invariant.gep9240, i64 %.159.i.i.i8923
  %.191.i.i.i8924 = load double, ptr %gep9241, align 8, !noalias !103
  %.193.i.i.i8925 = fadd double %.191.i.i.i8924, 0.000000e+00
  %.253.i.i.i8926 = fmul double %.456.i, %.193.i.i.i8925
  %.157.i.i.1.i8928 = add nsw i64 %.229.i.0680.i, %.155.i.i.1.i8927
  %.159.i.i.1.i8929 = mul nsw i64 %.157.i.i.1.i8928, %arg.shape.0
  %gep9243 = getelementptr double, ptr %invariant.gep9242, i64 %.159.i.i.1.i8929
  %.191.i.i.1.i8930 = load double, ptr %gep9243, align 8, !noalias !103
  %.193.i.i.1.i8931 = fadd double %.191.i.i.1.i8930, %.253.i.i.i8926
  %.253.i.i.1.i8932 = fmul double %.247.i.i.i8912, %.193.i.i.1.i8931
  %.157.i.i.2.i8934 = add nsw i64 %.229.i.0680.i, %.155.i.i.2.i8933
  %.159.i.i.2.i8935 = mul nsw i64 %.157.i.i.2.i8934, %arg.shape.0
  %gep9245 = getelementptr double, ptr %invariant.gep9244, i64 %.159.i.i.2.i8935
  %.191.i.i.2.i8936 = load double, ptr %gep9245, align 8, !noalias !103
  %.193.i.i.2.i8937 = fadd double %.191.i.i.2.i8936, %.253.i.i.1.i8932
  %.253.i.i.2.i8938 = fmul double %.456.i, %.193.i.i.2.i8937
  %.157.i.i.3.i8940 = add nsw i64 %.229.i.0680.i, %.155.i.i.3.i8939
  %.159.i.i.3.i8941 = mul nsw i64 %.157.i.i.3.i8940, %arg.shape.0
  %gep9247 = getelementptr double, ptr %invariant.gep9246, i64 %.159.i.i.3.i8941
  %.191.i.i.3.i8942 = load double, ptr %gep9247, align 8, !noalias !103
  %.193.i.i.3.i8943 = fadd double %.191.i.i.3.i8942, %.253.i.i.2.i8938
  %.253.i.i.3.i8944 = fmul double %.247.i.i.i8912, %.193.i.i.3.i8943
  %.157.i.i.4.i8946 = add nsw i64 %.229.i.0680.i, %.155.i.i.4.i8945
  %.159.i.i.4.i8947 = mul nsw i64 %.157.i.i.4.i8946, %arg.shape.0
  %gep9249 = getelementptr double, ptr %invariant.gep9248, i64 %.159.i.i.4.i8947
  %.191.i.i.4.i8948 = load double, ptr %gep9249, align 8, !noalias !103
  %.193.i.i.4.i8949 = fadd double %.191.i.i.4.i8948, %.253.i.i.3.i8944
  %.253.i.i.4.i8950 = fmul double %.456.i, %.193.i.i.4.i8949
  %.157.i.i.5.i8952 = add nsw i64 %.229.i.0680.i, %.155.i.i.5.i8951
  %.159.i.i.5.i8953 = mul nsw i64 %.157.i.i.5.i8952, %arg.shape.0
  %gep9251 = getelementptr double, ptr %invariant.gep9250, i64 %.159.i.i.5.i8953
  %.191.i.i.5.i8954 = load double, ptr %gep9251, align 8, !noalias !103
  %.193.i.i.5.i8955 = fadd double %.191.i.i.5.i8954, %.253.i.i.4.i8950
  %.253.i.i.5.i8956 = fmul double %.247.i.i.i8912, %.193.i.i.5.i8955
  %.157.i.i.6.i8958 = add nsw i64 %.229.i.0680.i, %.155.i.i.6.i8957
  %.159.i.i.6.i8959 = mul nsw i64 %.157.i.i.6.i8958, %arg.shape.0
  %gep9253 = getelementptr double, ptr %invariant.gep9252, i64 %.159.i.i.6.i8959
  %.191.i.i.6.i8960 = load double, ptr %gep9253, align 8, !noalias !103
  %.193.i.i.6.i8961 = fadd double %.191.i.i.6.i8960, %.253.i.i.5.i8956
  %.253.i.i.6.i8962 = fmul double %.456.i, %.193.i.i.6.i8961
  %.300.i.i8963 = add nsw i64 %.229.i.0680.i, 1
  %.271.i.i.i8964 = mul nsw i64 %.229.i.0680.i, %arg.shape.0
  %gep9255 = getelementptr double, ptr %invariant.gep9254, i64 %.271.i.i.i8964
  %.309.i.i.i8965 = load double, ptr %gep9255, align 8, !noalias !103
  %.313.i.i.i8966 = fadd double %.309.i.i.i8965, %.253.i.i.6.i8962
  %.360.i.i8967 = add nsw i64 %.229.i.0680.i, %.359.i.i8909
  %.362.i.i8968 = mul nsw i64 %.360.i.i8967, %arg.shape.0
  %gep9257 = getelementptr double, ptr %invariant.gep9256, i64 %.362.i.i8968
  store double %.313.i.i.i8966, ptr %gep9257, align 8, !noalias !99
  %exitcond.not.i8969 = icmp eq i64 %arg.shape.1, %.300.i.i8963
  br i1 %exitcond.not.i8969, label %B154.loopexit.i, label %B122.if.i.i8921

B354.if.i:                                        ; preds = %B206.i, %B502.i8970
  %.670.0686.i = phi i64 [ %.739.i, %B502.i8970 ], [ 0, %B206.i ]
  %.739.i = add nsw i64 %.670.0686.i, 1
  %210 = getelementptr double, ptr %71, i64 %.670.0686.i
  %.821.i = load double, ptr %210, align 8, !noalias !93
  %.822.i = fcmp ogt double %.821.i, 5.000000e-01
  br i1 %.822.i, label %B396.i8971, label %B502.i8970

B432.endif.i:                                     ; preds = %B80.i.i8974, %B46.i.i8973, %B432.i
  store double 0.000000e+00, ptr %210, align 8, !noalias !93
  br label %B502.i8970

B3292:                                            ; preds = %B120.loopexit.i, %B2758, %B3230
  %211 = select i1 %looked.4.2.lcssa, i1 %good.2.1.lcssa, i1 false
  br i1 %211, label %B3300, label %B3352

B3300:                                            ; preds = %B3292
  %within.5.1.not = xor i1 %within.5.1, true
  %brmerge8841 = select i1 %within.5.1.not, i1 true, i1 %.545
  %"$phi3336.7.2.2" = select i1 %brmerge8841, i64 0, i64 3
  br i1 %.603, label %B3352, label %B96.if.i

B172.i:                                           ; preds = %B96.if.i
  %.452.i8977 = getelementptr double, ptr %73, i64 %.180.0654.i
  %.453.i8978 = load double, ptr %.452.i8977, align 8, !noalias !107
  %.454.i8979 = fcmp olt double %.453.i8978, 5.000000e-01
  br i1 %.454.i8979, label %B789.i, label %B210.i

B210.i:                                           ; preds = %B172.i
  %.485.i8980 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.334.i
  %.486.i = load i64, ptr %.485.i8980, align 8, !noalias !107
  %.487.not.i = icmp eq i64 %.486.i, 0
  br i1 %.487.not.i, label %B246.i, label %B789.i

B246.i:                                           ; preds = %B210.i
  %.549.i = mul i64 %.334.i, %arg.batch.3.3.5.1
  %212 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.549.i
  %.553.i = getelementptr i8, ptr %212, i64 8
  %.554.i = load i64, ptr %.553.i, align 8, !noalias !107
  %.556.i = add nsw i64 %.554.i, %"$phi3336.7.2.2"
  store i64 %.556.i, ptr %.553.i, align 8, !noalias !107
  %.662.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.180.0654.i
  %.663.i8981 = load double, ptr %.662.i, align 8, !noalias !107
  %.717.i = getelementptr double, ptr %74, i64 %.180.0654.i
  %.718.i = load double, ptr %.717.i, align 8, !noalias !107
  %.772.i8982 = getelementptr double, ptr %75, i64 %.180.0654.i
  %.773.i8983 = load double, ptr %.772.i8982, align 8, !noalias !107
  %.794.i = icmp slt i64 %.389.i, %arg.batch.2.5.0
  br i1 %.794.i, label %B420.i, label %B760.i

B420.i:                                           ; preds = %B246.i
  %.817.i = icmp slt i64 %.389.i, 0
  %.818.i8984 = select i1 %.817.i, i64 %arg.batch.2.5.0, i64 0
  %213 = getelementptr double, ptr %arg.batch.2.4, i64 %.389.i
  %.832.i = getelementptr double, ptr %213, i64 %.818.i8984
  %.833.i = load double, ptr %.832.i, align 8, !noalias !107
  %.837.i = fcmp ugt double %.833.i, %.773.i8983
  br i1 %.837.i, label %B760.i, label %B444.preheader.i

B444.preheader.i:                                 ; preds = %B420.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul652.i, %.334.i
  %.1324.i = getelementptr double, ptr %76, i64 %.180.0654.i
  %214 = getelementptr double, ptr %arg.batch.3.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep9258 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9260 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9262 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9264 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9266 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9268 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9270 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9272 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9274 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  br label %B444.i

B444.i:                                           ; preds = %B736.i, %B444.preheader.i
  %done.2.3.i = phi i64 [ %.1262.i, %B736.i ], [ %.389.i, %B444.preheader.i ]
  br i1 %.924649.not.i, label %B644.i, label %B474.if.lr.ph.i

B474.if.lr.ph.i:                                  ; preds = %B444.i
  %.979.i8985 = icmp slt i64 %done.2.3.i, 0
  %.980.i8986 = select i1 %.979.i8985, i64 %arg.batch.2.5.0, i64 0
  %215 = getelementptr double, ptr %arg.batch.2.4, i64 %done.2.3.i
  %.994.i8987 = getelementptr double, ptr %215, i64 %.980.i8986
  %.1220.i = select i1 %.979.i8985, i64 %arg.batch.3.0.5.1, i64 0
  %.1221.i = add i64 %.1220.i, %done.2.3.i
  %.1250.i = mul i64 %.1221.i, %arg.batch.3.0.5.2
  %216 = getelementptr double, ptr %214, i64 %.1250.i
  br label %B474.if.i

B502.i8996:                                       ; preds = %B474.if.i
  %.1002.i = add nsw i64 %.868.0650.i, %.1000.i
  %.1004.i = mul nsw i64 %.1002.i, %arg.shape.0
  %gep9275 = getelementptr double, ptr %invariant.gep9274, i64 %.1004.i
  %.1036.i = load double, ptr %gep9275, align 8, !noalias !107
  br label %B790.i

B644.i:                                           ; preds = %B790.i, %B444.i
  store double 0x7FF0000000000000, ptr %.1324.i, align 8, !noalias !107
  %exitcond656.not.i = icmp eq i64 %done.2.3.i, %77
  br i1 %exitcond656.not.i, label %B760.i, label %B736.i

B736.i:                                           ; preds = %B644.i
  %.1262.i = add i64 %done.2.3.i, 1
  %.1359.i = icmp slt i64 %done.2.3.i, -1
  %.1360.i = select i1 %.1359.i, i64 %arg.batch.2.5.0, i64 0
  %217 = getelementptr double, ptr %arg.batch.2.4, i64 %.1262.i
  %.1374.i = getelementptr double, ptr %217, i64 %.1360.i
  %.1375.i = load double, ptr %.1374.i, align 8, !noalias !107
  %.1379.i = fcmp ugt double %.1375.i, %.773.i8983
  br i1 %.1379.i, label %B760.i, label %B444.i

B760.i:                                           ; preds = %B736.i, %B644.i, %B420.i, %B246.i
  %done.3.2.i = phi i64 [ %.389.i, %B420.i ], [ %.389.i, %B246.i ], [ %arg.batch.2.5.0, %B644.i ], [ %.1262.i, %B736.i ]
  store i64 %done.3.2.i, ptr %.388.i, align 8, !noalias !107
  br label %B789.i

B789.i:                                           ; preds = %B96.if.i, %B760.i, %B210.i, %B172.i
  %exitcond657.not.i = icmp eq i64 %.252.i, %arg.shape.0
  br i1 %exitcond657.not.i, label %B3352, label %B96.if.i

B790.i:                                           ; preds = %B38.if.i.i, %B502.i8996
  %.313.i.i.sink = phi double [ %.313.i.i, %B38.if.i.i ], [ %.1036.i, %B502.i8996 ]
  %218 = getelementptr double, ptr %216, i64 %.868.0650.i
  store double %.313.i.i.sink, ptr %218, align 8, !noalias !107
  %exitcond.not.i8995 = icmp eq i64 %arg.shape.1, %.937.i
  br i1 %exitcond.not.i8995, label %B644.i, label %B474.if.i

B96.if.i:                                         ; preds = %B3300, %B789.i
  %.180.0654.i = phi i64 [ %.252.i, %B789.i ], [ 0, %B3300 ]
  %.252.i = add nsw i64 %.180.0654.i, 1
  %.333.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.180.0654.i
  %.334.i = load i64, ptr %.333.i, align 8, !noalias !107
  %.388.i = getelementptr i64, ptr %72, i64 %.180.0654.i
  %.389.i = load i64, ptr %.388.i, align 8, !noalias !107
  %.397.i8976 = icmp slt i64 %.334.i, 0
  br i1 %.397.i8976, label %B789.i, label %B172.i

B474.if.i:                                        ; preds = %B790.i, %B474.if.lr.ph.i
  %.868.0650.i = phi i64 [ 0, %B474.if.lr.ph.i ], [ %.937.i, %B790.i ]
  %.937.i = add nsw i64 %.868.0650.i, 1
  %.995.i8991 = load double, ptr %.994.i8987, align 8, !noalias !107
  %.997.i = fcmp oeq double %.995.i8991, %.773.i8983
  br i1 %.997.i, label %B502.i8996, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B474.if.i
  %.1145.i = fsub double %.995.i8991, %.663.i8981
  %.1150.i = fdiv double %.1145.i, %.718.i
  %.247.i.i = fsub double 1.000000e+00, %.1150.i
  %.157.i.i = add nsw i64 %.868.0650.i, %.155.i.i
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep9259 = getelementptr double, ptr %invariant.gep9258, i64 %.159.i.i
  %.191.i.i8992 = load double, ptr %gep9259, align 8, !noalias !110
  %.193.i.i = fadd double %.191.i.i8992, 0.000000e+00
  %.253.i.i8993 = fmul double %.1150.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.868.0650.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep9261 = getelementptr double, ptr %invariant.gep9260, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep9261, align 8, !noalias !110
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i8993
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.868.0650.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep9263 = getelementptr double, ptr %invariant.gep9262, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep9263, align 8, !noalias !110
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %.1150.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.868.0650.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep9265 = getelementptr double, ptr %invariant.gep9264, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep9265, align 8, !noalias !110
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.868.0650.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep9267 = getelementptr double, ptr %invariant.gep9266, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep9267, align 8, !noalias !110
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %.1150.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.868.0650.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep9269 = getelementptr double, ptr %invariant.gep9268, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep9269, align 8, !noalias !110
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.868.0650.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep9271 = getelementptr double, ptr %invariant.gep9270, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep9271, align 8, !noalias !110
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %.1150.i, %.193.i.6.i
  %.271.i.i8994 = mul nsw i64 %.868.0650.i, %arg.shape.0
  %gep9273 = getelementptr double, ptr %invariant.gep9272, i64 %.271.i.i8994
  %.309.i.i = load double, ptr %gep9273, align 8, !noalias !110
  %.313.i.i = fadd double %.309.i.i, %.253.i.6.i
  br label %B790.i

B3352:                                            ; preds = %B789.i, %B3300, %B3292
  br i1 %.4863, label %B3402, label %B3364

B3364:                                            ; preds = %B3352
  %.4918 = load double, ptr %.4917, align 8
  %.4919 = fcmp ogt double %.4918, 5.000000e-01
  br i1 %.4919, label %B3402, label %B3470

B3402:                                            ; preds = %B3364, %B3352
  %.4950 = load i64, ptr %.4949, align 8
  %.4995 = inttoptr i64 %.4950 to ptr
  tail call void %.4995(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3470

B3470:                                            ; preds = %B3402, %B3364
  %beyond.2.1.not = xor i1 %beyond.2.1, true
  %brmerge9304 = or i1 %.603, %beyond.2.1.not
  br i1 %brmerge9304, label %B3514, label %B80.if.i4824

B134.i:                                           ; preds = %B80.if.i4824
  %.351.i4132 = getelementptr double, ptr %79, i64 %.141.i3938.09283
  %.352.i4133 = load double, ptr %.351.i4132, align 8, !noalias !114
  %.353.i4134 = fcmp ogt double %.352.i4133, 5.000000e-01
  br i1 %.353.i4134, label %B174.i, label %B740.i

B174.i:                                           ; preds = %B134.i
  %.408.i4182 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.141.i3938.09283
  %.409.i4183 = load double, ptr %.408.i4182, align 8, !noalias !114
  %.463.i4231 = getelementptr double, ptr %80, i64 %.141.i3938.09283
  %.464.i4232 = load double, ptr %.463.i4231, align 8, !noalias !114
  %.465.i4233 = fsub double %.409.i4183, %.464.i4232
  br i1 %.552.i42719276.not, label %B380.i, label %B270.if.i.preheader

B270.if.i.preheader:                              ; preds = %B174.i
  %invariant.gep9331 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.141.i3938.09283
  br label %B270.if.i

B380.i:                                           ; preds = %B270.if.i, %B174.i
  %fastest.2.i.2.lcssa = phi double [ 0.000000e+00, %B174.i ], [ %.11.i.i, %B270.if.i ]
  %.666.i4283 = fmul double %.465.i4233, %fastest.2.i.2.lcssa
  %.698.i4309 = load double, ptr %.697.i4308, align 8, !noalias !114
  %.699.i4310 = fcmp ogt double %.666.i4283, %.698.i4309
  %.8842 = select i1 %.699.i4310, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  %.743.i4339 = load double, ptr %.742.i4338, align 8, !noalias !114
  %.773.i4364 = load double, ptr %arg.batch.2.4, align 8, !noalias !114
  %.774.i4365 = fsub double %.743.i4339, %.773.i4364
  %.776.i4367 = fmul double %.8842, %.774.i4365
  %.780.i4370 = fcmp olt double %.465.i4233, %.776.i4367
  br i1 %.780.i4370, label %B490.i, label %B528.i

B490.i:                                           ; preds = %B380.i
  %219 = getelementptr i64, ptr %82, i64 %.141.i3938.09283
  %.838.i4760 = load i64, ptr %219, align 8, !noalias !114
  %.839.i4761 = add nsw i64 %.838.i4760, 1
  br label %B528.i

B528.i:                                           ; preds = %B380.i, %B490.i
  %"$phi528.1.2.i.2" = phi i64 [ %.839.i4761, %B490.i ], [ 0, %B380.i ]
  %220 = getelementptr i64, ptr %83, i64 %.141.i3938.09283
  store i64 %"$phi528.1.2.i.2", ptr %220, align 8, !noalias !114
  %.959.i4466 = load double, ptr %.408.i4182, align 8, !noalias !114
  store double %.959.i4466, ptr %.463.i4231, align 8, !noalias !114
  %.1068.i4530 = getelementptr double, ptr %84, i64 %.141.i3938.09283
  store double 1.000000e+00, ptr %.1068.i4530, align 8, !noalias !114
  store i64 1, ptr %.981, align 8, !noalias !114
  %.1154.i = load i64, ptr %220, align 8, !noalias !114
  %.1155.i = icmp sgt i64 %.1154.i, 1000
  br i1 %.1155.i, label %B694.i, label %B740.i

B694.i:                                           ; preds = %B528.i
  %221 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.141.i3938.09283
  %.84.i.i4650 = load i64, ptr %221, align 8, !noalias !118
  %.89.i.i4653 = icmp sgt i64 %.84.i.i4650, -1
  br i1 %.89.i.i4653, label %B46.i.i4660, label %B740.i

B46.i.i4660:                                      ; preds = %B694.i
  %.120.i.i4680 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i4650
  %.121.i.i4681 = load i64, ptr %.120.i.i4680, align 8, !noalias !118
  %.122.i.i4682 = icmp eq i64 %.121.i.i4681, 0
  br i1 %.122.i.i4682, label %B80.i.i4687, label %B740.i

B80.i.i4687:                                      ; preds = %B46.i.i4660
  store i64 6, ptr %.120.i.i4680, align 8, !noalias !118
  br label %B740.i

B740.i:                                           ; preds = %B80.i.i4687, %B694.i, %B46.i.i4660, %B528.i, %B134.i, %B80.if.i4824
  %.200.i4022 = icmp sgt i64 %.144.i3939.09282, 1
  br i1 %.200.i4022, label %B80.if.i4824, label %B3514

B80.if.i4824:                                     ; preds = %B3470, %B740.i
  %.141.i3938.09283 = phi i64 [ %.213.i4832, %B740.i ], [ 0, %B3470 ]
  %.144.i3939.09282 = phi i64 [ %.209.i4829, %B740.i ], [ %storemerge, %B3470 ]
  %.209.i4829 = add nsw i64 %.144.i3939.09282, -1
  %.213.i4832 = add nsw i64 %.141.i3938.09283, 1
  %.294.i4082 = getelementptr double, ptr %78, i64 %.141.i3938.09283
  %.295.i4083 = load double, ptr %.294.i4082, align 8, !noalias !114
  %.296.i4084 = fcmp oeq double %.295.i4083, 2.000000e+00
  br i1 %.296.i4084, label %B134.i, label %B740.i

B270.if.i:                                        ; preds = %B270.if.i.preheader, %B270.if.i
  %fastest.2.i.29279 = phi double [ %.11.i.i, %B270.if.i ], [ 0.000000e+00, %B270.if.i.preheader ]
  %.496.i3955.09278 = phi i64 [ %.565.i4816, %B270.if.i ], [ 0, %B270.if.i.preheader ]
  %.565.i4816 = add nsw i64 %.496.i3955.09278, 1
  %.592.i4768 = add nsw i64 %.496.i3955.09278, %arg.shape.1
  %.594.i4770 = mul nsw i64 %.592.i4768, %arg.shape.0
  %gep9332 = getelementptr double, ptr %invariant.gep9331, i64 %.594.i4770
  %.626.i4798 = load double, ptr %gep9332, align 8, !noalias !114
  %.627.i4799 = tail call double @llvm.fabs.f64(double %.626.i4798)
  %.10.i.i = fcmp ogt double %.627.i4799, %fastest.2.i.29279
  %.11.i.i = select i1 %.10.i.i, double %.627.i4799, double %fastest.2.i.29279
  %exitcond9318.not = icmp eq i64 %arg.shape.1, %.565.i4816
  br i1 %exitcond9318.not, label %B380.i, label %B270.if.i

B3514:                                            ; preds = %B740.i, %B3470
  %brmerge8844.not = and i1 %.5060.not, %looked.4.2.lcssa
  %brmerge8844.not.not = xor i1 %brmerge8844.not, true
  %brmerge9303 = or i1 %.603, %brmerge8844.not.not
  br i1 %brmerge9303, label %B3564, label %B114.if.i

B46.i.i8997:                                      ; preds = %B114.if.i
  %.135.i.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !121
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i9008, label %B228.i

B80.i.i9008:                                      ; preds = %B46.i.i8997
  %.196.i.i = getelementptr double, ptr %85, i64 %.302.01639.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !121
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B228.i, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i9008
  %.264.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.302.01639.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !121
  %.321.i.i = getelementptr double, ptr %86, i64 %.302.01639.i
  %.322.i.i9009 = load double, ptr %.321.i.i, align 8, !noalias !121
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i9009
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.175.i3061635.not.i
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01641.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01641.i
  br i1 %brmerge.i, label %B228.i, label %B76.if.i.lr.ph.i9010

B76.if.i.lr.ph.i9010:                             ; preds = %B122.i.i
  %222 = getelementptr i64, ptr %87, i64 %.302.01639.i
  %.513.i = load i64, ptr %222, align 8, !noalias !126
  %.514.i = add nsw i64 %.513.i, 1
  %.236.i323.i = icmp slt i64 %.513.i, -1
  %.237.i324.i = select i1 %.236.i323.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i325.i = add i64 %.514.i, %.237.i324.i
  %.258.i342.i = mul i64 %.238.i325.i, %arg.batch.1.3.5.1
  %223 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i342.i
  br label %B76.if.i.i9011

B76.if.i.i9011:                                   ; preds = %B76.if.i.i9011, %B76.if.i.lr.ph.i9010
  %.117.i268.01636.i = phi i64 [ 0, %B76.if.i.lr.ph.i9010 ], [ %.188.i390.i, %B76.if.i.i9011 ]
  %.188.i390.i = add nsw i64 %.117.i268.01636.i, 1
  %224 = getelementptr double, ptr %223, i64 %.117.i268.01636.i
  %.263.i344.i = load double, ptr %224, align 8, !noalias !127
  %225 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i268.01636.i
  %.293.i360.i = load i64, ptr %225, align 8, !noalias !127
  %.295.i362.i = mul nsw i64 %.293.i360.i, %arg.shape.0
  %.297.i364.i = add nsw i64 %.295.i362.i, %.302.01639.i
  %.311.i372.i = icmp slt i64 %.297.i364.i, 0
  %.312.i373.i = select i1 %.311.i372.i, i64 %arg.batch.5.1.5.0, i64 0
  %226 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i364.i
  %.326.i383.i = getelementptr double, ptr %226, i64 %.312.i373.i
  store double %.263.i344.i, ptr %.326.i383.i, align 8, !noalias !127
  %exitcond.not.i9012 = icmp eq i64 %arg.batch.1.1.5.0, %.188.i390.i
  br i1 %exitcond.not.i9012, label %B228.i, label %B76.if.i.i9011

B228.i:                                           ; preds = %B76.if.i.i9011, %B114.if.i, %B122.i.i, %B80.i.i9008, %B46.i.i8997
  %some.3.1.i = phi i1 [ %some.2.01641.mux.i, %B122.i.i ], [ %some.2.01641.i, %B80.i.i9008 ], [ %some.2.01641.i, %B114.if.i ], [ %some.2.01641.i, %B46.i.i8997 ], [ true, %B76.if.i.i9011 ]
  %exitcond1650.not.i = icmp eq i64 %arg.shape.0, %.373.i
  br i1 %exitcond1650.not.i, label %B230.i, label %B114.if.i

B230.i:                                           ; preds = %B228.i
  br i1 %some.3.1.i, label %B238.i, label %B3564

B238.i:                                           ; preds = %B230.i
  %.637.i8998 = load i64, ptr %.636.i, align 8, !noalias !126
  %.749.i = inttoptr i64 %.637.i8998 to ptr
  tail call void %.749.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !126
  %.780.i = load i64, ptr %.779.i8999, align 8, !noalias !126
  %.896.i9003 = inttoptr i64 %.780.i to ptr
  tail call void %.896.i9003(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.895.i9002), !noalias !126
  br i1 %.900.not.i, label %B598.if.i.preheader, label %B456.i

B456.i:                                           ; preds = %B238.i
  %.931.i = load i64, ptr %.930.i, align 8, !noalias !126
  %.1049.i = inttoptr i64 %.931.i to ptr
  tail call void %.1049.i(ptr %arg.batch.4.0.4, ptr %.895.i9002, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !126
  br label %B598.if.i.preheader

B598.if.i.preheader:                              ; preds = %B456.i, %B238.i
  br label %B598.if.i

B46.i82.i:                                        ; preds = %B598.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !131
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B1076.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %85, i64 %.1090.01648.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !131
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B1076.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.1090.01648.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !131
  %.321.i223.i = getelementptr double, ptr %86, i64 %.1090.01648.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !131
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B1076.i, label %B638.i

B638.i:                                           ; preds = %B122.i147.i
  %.1344.i = getelementptr i64, ptr %88, i64 %.1090.01648.i
  %.1345.i = load i64, ptr %.1344.i, align 8, !noalias !126
  %.1356.i = icmp sgt i64 %.1345.i, 0
  br i1 %.1356.i, label %B714.i, label %B768.i

B714.i:                                           ; preds = %B638.i
  %227 = getelementptr double, ptr %arg.batch.2.4, i64 %.1345.i
  %.1391.i = getelementptr i8, ptr %227, i64 -8
  %.1392.i = load double, ptr %.1391.i, align 8, !noalias !126
  %.1448.i = fcmp oeq double %.1392.i, %.265.i185.i
  br label %B768.i

B768.i:                                           ; preds = %B714.i, %B638.i
  %"$phi768.1.2.1.i" = phi i1 [ %.1448.i, %B714.i ], [ false, %B638.i ]
  br i1 %.15441642.not.i, label %B978.i, label %B800.if.lr.ph.i

B800.if.lr.ph.i:                                  ; preds = %B768.i
  %.1674.i = add nsw i64 %.1345.i, -1
  %.1713.i9006 = select i1 %.1356.i, i64 0, i64 %arg.batch.3.0.5.1
  %.1714.i = add i64 %.1674.i, %.1713.i9006
  %.1741.i = mul i64 %.1739.i, %.99.i78.i
  %.1743.i = mul i64 %.1714.i, %arg.batch.3.0.5.2
  %228 = getelementptr double, ptr %arg.batch.3.0.4, i64 %.1741.i
  %229 = getelementptr double, ptr %228, i64 %.1743.i
  %invariant.gep9284 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  %invariant.gep9286 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  br label %B800.if.i

B896.i9007:                                       ; preds = %B800.if.i
  %230 = getelementptr double, ptr %229, i64 %.1488.01643.i
  store double %.1622.i, ptr %230, align 8, !noalias !126
  br label %B918.i

B918.i:                                           ; preds = %B800.if.i, %B896.i9007
  %exitcond1651.not.i = icmp eq i64 %arg.shape.1, %.1557.i
  br i1 %exitcond1651.not.i, label %B920.loopexit.i, label %B800.if.i

B920.loopexit.i:                                  ; preds = %B918.i
  %231 = fcmp une double %.1629.i, 0.000000e+00
  br i1 %231, label %B932.i, label %B978.i

B932.i:                                           ; preds = %B920.loopexit.i
  %.84.i452.i = load i64, ptr %234, align 8, !noalias !134
  %.89.i454.i = icmp sgt i64 %.84.i452.i, -1
  br i1 %.89.i454.i, label %B46.i458.i, label %B978.i

B46.i458.i:                                       ; preds = %B932.i
  %.120.i478.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i452.i
  %.121.i479.i = load i64, ptr %.120.i478.i, align 8, !noalias !134
  %.122.i480.i = icmp eq i64 %.121.i479.i, 0
  br i1 %.122.i480.i, label %B80.i484.i, label %B978.i

B80.i484.i:                                       ; preds = %B46.i458.i
  store i64 3, ptr %.120.i478.i, align 8, !noalias !134
  br label %B978.i

B978.i:                                           ; preds = %B80.i484.i, %B46.i458.i, %B932.i, %B920.loopexit.i, %B768.i
  br i1 %.900.not.i, label %B1076.i, label %B994.i

B994.i:                                           ; preds = %B978.i
  %232 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.1090.01648.i
  %.1846.i = load double, ptr %232, align 8, !noalias !126
  %.1848.i = fcmp olt double %.1846.i, -1.000000e-09
  br i1 %.1848.i, label %B1030.i, label %B1076.i

B1030.i:                                          ; preds = %B994.i
  %.84.i583.i = load i64, ptr %234, align 8, !noalias !137
  %.89.i586.i = icmp sgt i64 %.84.i583.i, -1
  br i1 %.89.i586.i, label %B46.i591.i, label %B1076.i

B46.i591.i:                                       ; preds = %B1030.i
  %.120.i616.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i583.i
  %.121.i617.i = load i64, ptr %.120.i616.i, align 8, !noalias !137
  %.122.i618.i = icmp eq i64 %.121.i617.i, 0
  br i1 %.122.i618.i, label %B80.i623.i, label %B1076.i

B80.i623.i:                                       ; preds = %B46.i591.i
  store i64 4, ptr %.120.i616.i, align 8, !noalias !137
  br label %B1076.i

B1076.i:                                          ; preds = %B598.if.i, %B80.i623.i, %B46.i591.i, %B1030.i, %B994.i, %B978.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %.1146.i = icmp sgt i64 %.1093.01649.i, 1
  br i1 %.1146.i, label %B598.if.i, label %B3564

B114.if.i:                                        ; preds = %B3514, %B228.i
  %some.2.01641.i = phi i1 [ %some.3.1.i, %B228.i ], [ false, %B3514 ]
  %.302.01639.i = phi i64 [ %.373.i, %B228.i ], [ 0, %B3514 ]
  %.373.i = add nsw i64 %.302.01639.i, 1
  %233 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.302.01639.i
  %.99.i.i = load i64, ptr %233, align 8, !noalias !121
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B228.i, label %B46.i.i8997

B598.if.i:                                        ; preds = %B598.if.i.preheader, %B1076.i
  %.1093.01649.i = phi i64 [ %.1155.i9005, %B1076.i ], [ %storemerge.i, %B598.if.i.preheader ]
  %.1090.01648.i = phi i64 [ %.1159.i, %B1076.i ], [ 0, %B598.if.i.preheader ]
  %.1155.i9005 = add nsw i64 %.1093.01649.i, -1
  %.1159.i = add nsw i64 %.1090.01648.i, 1
  %234 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1090.01648.i
  %.99.i78.i = load i64, ptr %234, align 8, !noalias !131
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B1076.i, label %B46.i82.i

B800.if.i:                                        ; preds = %B918.i, %B800.if.lr.ph.i
  %trouble.2.11645.i = phi double [ 0.000000e+00, %B800.if.lr.ph.i ], [ %.1629.i, %B918.i ]
  %.1488.01643.i = phi i64 [ 0, %B800.if.lr.ph.i ], [ %.1557.i, %B918.i ]
  %.1557.i = add nsw i64 %.1488.01643.i, 1
  %.1588.i = add nsw i64 %.1488.01643.i, %.850.i9000
  %.1590.i = mul nsw i64 %.1588.i, %arg.shape.0
  %gep9285 = getelementptr double, ptr %invariant.gep9284, i64 %.1590.i
  %.1622.i = load double, ptr %gep9285, align 8, !noalias !126
  %.1627.i = fmul double %.1622.i, 0.000000e+00
  %.1629.i = fadd double %trouble.2.11645.i, %.1627.i
  %.1637.i = mul nsw i64 %.1488.01643.i, %arg.shape.0
  %gep9287 = getelementptr double, ptr %invariant.gep9286, i64 %.1637.i
  store double %.1622.i, ptr %gep9287, align 8, !noalias !126
  br i1 %"$phi768.1.2.1.i", label %B896.i9007, label %B918.i

B3564:                                            ; preds = %B1076.i, %B3514, %B230.i
  %looked.4.2.lcssa.not = xor i1 %looked.4.2.lcssa, true
  %brmerge9305 = or i1 %.603, %looked.4.2.lcssa.not
  %active.9.1.mux = select i1 %looked.4.2.lcssa, i64 0, i64 %active.9.1
  br i1 %brmerge9305, label %B4540, label %B3606.if

B3654:                                            ; preds = %B3606.if
  %.5443 = mul i64 %.5370, %arg.batch.3.3.5.1
  %.5447 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.5443
  %.5448 = load i64, ptr %.5447, align 8
  %.5504 = getelementptr i8, ptr %.5447, i64 24
  %.5505 = load i64, ptr %.5504, align 8
  %235 = add i64 %.5448, %.5505
  %.5506 = sub i64 %arg.most, %235
  %.5511 = icmp slt i64 %.5506, 1
  br i1 %.5511, label %B3734, label %B3780

B3734:                                            ; preds = %B3654
  %236 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5208.09292
  %.84.i4914 = load i64, ptr %236, align 8, !noalias !140
  %.89.i4917 = icmp sgt i64 %.84.i4914, -1
  br i1 %.89.i4917, label %B46.i4922, label %B3780

B46.i4922:                                        ; preds = %B3734
  %.120.i4948 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i4914
  %.121.i4949 = load i64, ptr %.120.i4948, align 8, !noalias !140
  %.122.i4950 = icmp eq i64 %.121.i4949, 0
  br i1 %.122.i4950, label %B80.i4955, label %B3780

B80.i4955:                                        ; preds = %B46.i4922
  store i64 5, ptr %.120.i4948, align 8, !noalias !140
  br label %B3780

B3780:                                            ; preds = %B80.i4955, %B3734, %B46.i4922, %B3654
  %.5601 = getelementptr double, ptr %89, i64 %.5208.09292
  %.5602 = load double, ptr %.5601, align 8
  %.5603 = fcmp ogt double %.5602, 5.000000e-01
  br i1 %.5603, label %B3818, label %B3922

B3818:                                            ; preds = %B3780
  %.5658 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5208.09292
  %.5659 = load double, ptr %.5658, align 8
  %.5713 = getelementptr double, ptr %90, i64 %.5208.09292
  %.5714 = load double, ptr %.5713, align 8
  %.5715 = fcmp oeq double %.5659, %.5714
  br i1 %.5715, label %B3882, label %B3922

B3882:                                            ; preds = %B3818
  %.192.i5182 = load i64, ptr %.5369, align 8, !noalias !143
  %.248.i5230 = getelementptr i64, ptr %91, i64 %.5208.09292
  %.249.i5231 = load i64, ptr %.248.i5230, align 8, !noalias !143
  %.250.i5232 = add nsw i64 %.249.i5231, 1
  store i64 %.250.i5232, ptr %.248.i5230, align 8, !noalias !143
  %.373.i5337 = icmp slt i64 %.249.i5231, -1
  %.374.i5338 = select i1 %.373.i5337, i64 %arg.batch.1.2.5.0, i64 0
  %237 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.250.i5232
  %.388.i5352 = getelementptr double, ptr %237, i64 %.374.i5338
  %.389.i5353 = load double, ptr %.388.i5352, align 8, !noalias !143
  %.390.i5354 = fcmp oeq double %.389.i5353, 0x7FF0000000000000
  br i1 %.390.i5354, label %B182.i, label %B240.i5355

B182.i:                                           ; preds = %B3882
  %.424.i5877 = icmp slt i64 %.192.i5182, 0
  %.425.i5878 = select i1 %.424.i5877, i64 %arg.batch.3.1.5.0, i64 0
  %238 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.192.i5182
  %.439.i5892 = getelementptr i64, ptr %238, i64 %.425.i5878
  %.440.i5893 = load i64, ptr %.439.i5892, align 8, !noalias !143
  %.441.i5894 = icmp eq i64 %.440.i5893, 0
  br i1 %.441.i5894, label %B216.i5898, label %B3922

B216.i5898:                                       ; preds = %B182.i
  store i64 1, ptr %.439.i5892, align 8, !noalias !143
  br label %B3922

B240.i5355:                                       ; preds = %B3882
  store double %.389.i5353, ptr %.5713, align 8, !noalias !143
  %.592.i5444 = select i1 %.373.i5337, i64 %arg.batch.1.4.5.0, i64 0
  %239 = getelementptr i64, ptr %arg.batch.1.4.4, i64 %.250.i5232
  %.606.i5458 = getelementptr i64, ptr %239, i64 %.592.i5444
  %.607.i5459 = load i64, ptr %.606.i5458, align 8, !noalias !143
  %.610.i5461 = icmp eq i64 %.607.i5459, 0
  br i1 %.610.i5461, label %B300.i, label %B348.i

B300.i:                                           ; preds = %B240.i5355
  %.665.i5831 = getelementptr double, ptr %92, i64 %.5208.09292
  store double 1.000000e+00, ptr %.665.i5831, align 8, !noalias !143
  br label %B392.i.sink.split

B348.i:                                           ; preds = %B240.i5355
  %.733.i5487 = load i64, ptr %.981, align 8, !noalias !143
  %.734.i5488 = icmp eq i64 %.733.i5487, 0
  br i1 %.734.i5488, label %B392.i.sink.split, label %B392.i

B392.i.sink.split:                                ; preds = %B348.i, %B300.i
  %.sink = phi i64 [ 1, %B300.i ], [ 2, %B348.i ]
  store i64 %.sink, ptr %.981, align 8, !noalias !143
  br label %B392.i

B392.i:                                           ; preds = %B392.i.sink.split, %B348.i
  br i1 %.175.i.i56409288.not, label %B3922, label %B76.if.i.i.lr.ph

B76.if.i.i.lr.ph:                                 ; preds = %B392.i
  %.237.i.i5686 = select i1 %.373.i5337, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i5687 = add i64 %.237.i.i5686, %.250.i5232
  %.258.i.i5703 = mul i64 %.238.i.i5687, %arg.batch.1.3.5.1
  %240 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i5703
  br label %B76.if.i.i

B76.if.i.i:                                       ; preds = %B76.if.i.i.lr.ph, %B76.if.i.i
  %.117.i.i4993.09290 = phi i64 [ 0, %B76.if.i.i.lr.ph ], [ %.188.i.i5750, %B76.if.i.i ]
  %.188.i.i5750 = add nsw i64 %.117.i.i4993.09290, 1
  %241 = getelementptr double, ptr %240, i64 %.117.i.i4993.09290
  %.263.i.i5706 = load double, ptr %241, align 8, !noalias !147
  %242 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.i4993.09290
  %.293.i.i5722 = load i64, ptr %242, align 8, !noalias !147
  %.295.i.i5724 = mul nsw i64 %.293.i.i5722, %arg.shape.0
  %.297.i.i5726 = add nsw i64 %.295.i.i5724, %.5208.09292
  %.311.i.i5733 = icmp slt i64 %.297.i.i5726, 0
  %.312.i.i5734 = select i1 %.311.i.i5733, i64 %arg.batch.5.1.5.0, i64 0
  %243 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i5726
  %.326.i.i5744 = getelementptr double, ptr %243, i64 %.312.i.i5734
  store double %.263.i.i5706, ptr %.326.i.i5744, align 8, !noalias !147
  %exitcond9319.not = icmp eq i64 %arg.batch.1.1.5.0, %.188.i.i5750
  br i1 %exitcond9319.not, label %B3922, label %B76.if.i.i

B3922:                                            ; preds = %B76.if.i.i, %B392.i, %B216.i5898, %B182.i, %B3818, %B3780
  %.5804 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.5370
  %.5805 = load i64, ptr %.5804, align 8
  %.5806.not = icmp eq i64 %.5805, 0
  br i1 %.5806.not, label %B4064, label %B3956

B3956:                                            ; preds = %B3922
  %.5867 = getelementptr i64, ptr %93, i64 %.5208.09292
  %.5868 = load i64, ptr %.5867, align 8
  %.5898 = getelementptr i64, ptr %arg.batch.3.2.4, i64 %.5370
  store i64 %.5868, ptr %.5898, align 8
  store i64 -1, ptr %.5369, align 8
  %.236.i9013 = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !151
  %.293.i9018 = getelementptr double, ptr %94, i64 %.5208.09292
  store double 0.000000e+00, ptr %.293.i9018, align 8, !noalias !151
  %.324.i9020 = load i64, ptr %.323.i9019, align 8, !noalias !151
  %.326.i9021 = icmp eq i64 %.236.i9013, %.324.i9020
  br i1 %.326.i9021, label %B4272, label %B132.i9022

B132.i9022:                                       ; preds = %B3956
  %.359.i9023 = add nsw i64 %.236.i9013, 1
  store i64 %.359.i9023, ptr %arg.batch.4.2.4, align 8, !noalias !151
  store i64 1, ptr %.981, align 8, !noalias !151
  %.438.i9025 = icmp slt i64 %.236.i9013, 0
  %.439.i9026 = select i1 %.438.i9025, i64 %arg.batch.0.2.5.0, i64 0
  %244 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i9013
  %.453.i9027 = getelementptr i64, ptr %244, i64 %.439.i9026
  %.454.i9028 = load i64, ptr %.453.i9027, align 8, !noalias !151
  %.469.i9029 = icmp slt i64 %.454.i9028, 0
  %.470.i9030 = select i1 %.469.i9029, i64 %arg.batch.1.0.5.0, i64 0
  %245 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i9028
  %.484.i9031 = getelementptr i64, ptr %245, i64 %.470.i9030
  %.485.i9032 = load i64, ptr %.484.i9031, align 8, !noalias !151
  store i64 %.236.i9013, ptr %.5369, align 8, !noalias !151
  %.595.i9036 = getelementptr i64, ptr %95, i64 %.5208.09292
  store i64 %.485.i9032, ptr %.595.i9036, align 8, !noalias !151
  store i64 1, ptr %.5867, align 8, !noalias !151
  %.709.i9040 = getelementptr i64, ptr %96, i64 %.5208.09292
  store i64 0, ptr %.709.i9040, align 8, !noalias !151
  br i1 %.8051131.not.i9041, label %B402.i9056, label %B358.if.lr.ph.i9042

B358.if.lr.ph.i9042:                              ; preds = %B132.i9022
  %.867.i9043 = select i1 %.438.i9025, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i9044 = add i64 %.867.i9043, %.236.i9013
  %.888.i9045 = mul i64 %.868.i9044, %arg.batch.0.1.5.1
  %246 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i9045
  %invariant.gep9333 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.5208.09292
  br label %B358.if.i9046

B402.i9056:                                       ; preds = %B358.if.i9046, %B132.i9022
  br i1 %.175.i1134.not.i9057, label %B402.endif.i9075, label %B76.if.i.lr.ph.i9058

B76.if.i.lr.ph.i9058:                             ; preds = %B402.i9056
  %.990.i9059 = load i64, ptr %.595.i9036, align 8, !noalias !151
  %.236.i.i9060 = icmp slt i64 %.990.i9059, 0
  %.237.i.i9061 = select i1 %.236.i.i9060, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i9062 = add i64 %.237.i.i9061, %.990.i9059
  %.258.i.i9063 = mul i64 %.238.i.i9062, %arg.batch.1.3.5.1
  %247 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i9063
  br label %B76.if.i.i9064

B76.if.i.i9064:                                   ; preds = %B76.if.i.i9064, %B76.if.i.lr.ph.i9058
  %.117.i.01135.i9065 = phi i64 [ 0, %B76.if.i.lr.ph.i9058 ], [ %.188.i.i9066, %B76.if.i.i9064 ]
  %.188.i.i9066 = add nsw i64 %.117.i.01135.i9065, 1
  %248 = getelementptr double, ptr %247, i64 %.117.i.01135.i9065
  %.263.i.i9067 = load double, ptr %248, align 8, !noalias !154
  %249 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i9065
  %.293.i.i9068 = load i64, ptr %249, align 8, !noalias !154
  %.295.i.i9069 = mul nsw i64 %.293.i.i9068, %arg.shape.0
  %.297.i.i9070 = add nsw i64 %.295.i.i9069, %.5208.09292
  %.311.i.i9071 = icmp slt i64 %.297.i.i9070, 0
  %.312.i.i9072 = select i1 %.311.i.i9071, i64 %arg.batch.5.1.5.0, i64 0
  %250 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i9070
  %.326.i.i9073 = getelementptr double, ptr %250, i64 %.312.i.i9072
  store double %.263.i.i9067, ptr %.326.i.i9073, align 8, !noalias !154
  %exitcond1142.not.i9074 = icmp eq i64 %.188.i.i9066, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i9074, label %B402.endif.i9075, label %B76.if.i.i9064

B888.i9167:                                       ; preds = %B580.if.i9091
  store double 0.000000e+00, ptr %.1877.i9164, align 8, !noalias !151
  br label %B4272

B358.if.i9046:                                    ; preds = %B358.if.i9046, %B358.if.lr.ph.i9042
  %.747.01132.i9047 = phi i64 [ 0, %B358.if.lr.ph.i9042 ], [ %.818.i9048, %B358.if.i9046 ]
  %.818.i9048 = add nsw i64 %.747.01132.i9047, 1
  %251 = getelementptr double, ptr %246, i64 %.747.01132.i9047
  %.893.i9049 = load double, ptr %251, align 8, !noalias !151
  %.895.i9050 = mul nsw i64 %.747.01132.i9047, %arg.shape.0
  %gep9334 = getelementptr double, ptr %invariant.gep9333, i64 %.895.i9050
  store double %.893.i9049, ptr %gep9334, align 8, !noalias !151
  %exitcond.not.i9055 = icmp eq i64 %.818.i9048, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i9055, label %B402.i9056, label %B358.if.i9046

B402.endif.i9075:                                 ; preds = %B76.if.i.i9064, %B402.i9056
  br i1 %.11171137.not.i9076, label %B580.if.i9091, label %B496.if.lr.ph.i9077

B496.if.lr.ph.i9077:                              ; preds = %B402.endif.i9075
  %.1179.i9078 = select i1 %.438.i9025, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i9079 = add i64 %.1179.i9078, %.236.i9013
  %.1200.i9080 = mul i64 %.1180.i9079, %arg.batch.0.0.5.1
  %252 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i9080
  %invariant.gep9335 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.5208.09292
  br label %B496.if.i9081

B496.if.i9081:                                    ; preds = %B496.if.i9081, %B496.if.lr.ph.i9077
  %.1061.01138.i9082 = phi i64 [ 0, %B496.if.lr.ph.i9077 ], [ %.1130.i9083, %B496.if.i9081 ]
  %.1130.i9083 = add nsw i64 %.1061.01138.i9082, 1
  %253 = getelementptr double, ptr %252, i64 %.1061.01138.i9082
  %.1205.i9084 = load double, ptr %253, align 8, !noalias !151
  %.1207.i9085 = mul nsw i64 %.1061.01138.i9082, %arg.shape.0
  %gep9336 = getelementptr double, ptr %invariant.gep9335, i64 %.1207.i9085
  store double %.1205.i9084, ptr %gep9336, align 8, !noalias !151
  %exitcond1143.not.i9090 = icmp eq i64 %.1130.i9083, %arg.shape.1
  br i1 %exitcond1143.not.i9090, label %B580.if.i9091, label %B496.if.i9081

B580.if.i9091:                                    ; preds = %B496.if.i9081, %B402.endif.i9075
  %invariant.gep.i9092 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5208.09292
  store double 0.000000e+00, ptr %invariant.gep.i9092, align 8, !noalias !151
  %gep.1.i9093 = getelementptr double, ptr %invariant.gep.i9092, i64 %arg.batch.4.0.5.1
  store double 0.000000e+00, ptr %gep.1.i9093, align 8, !noalias !151
  %gep.2.i9095 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.2.idx.i9094
  store double 0.000000e+00, ptr %gep.2.i9095, align 8, !noalias !151
  %gep.3.i9097 = getelementptr i8, ptr %invariant.gep.i9092, i64 %.idx.i9017
  store double 0.000000e+00, ptr %gep.3.i9097, align 8, !noalias !151
  %gep.4.i9099 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.4.idx.i9098
  store double 0.000000e+00, ptr %gep.4.i9099, align 8, !noalias !151
  %gep.5.i9101 = getelementptr i8, ptr %invariant.gep.i9092, i64 %.idx8773
  store double 0.000000e+00, ptr %gep.5.i9101, align 8, !noalias !151
  %gep.6.i9103 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.6.idx.i9102
  store double 0.000000e+00, ptr %gep.6.i9103, align 8, !noalias !151
  %gep.7.i9105 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.7.idx.i9104
  store double 0.000000e+00, ptr %gep.7.i9105, align 8, !noalias !151
  %gep.8.i9107 = getelementptr i8, ptr %invariant.gep.i9092, i64 %.502.idx
  store double 0.000000e+00, ptr %gep.8.i9107, align 8, !noalias !151
  %gep.9.i9109 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.9.idx.i9108
  store double 0.000000e+00, ptr %gep.9.i9109, align 8, !noalias !151
  %gep.10.i9111 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.10.idx.i9110
  store double 0.000000e+00, ptr %gep.10.i9111, align 8, !noalias !151
  %gep.11.i9113 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.11.idx.i9112
  store double 0.000000e+00, ptr %gep.11.i9113, align 8, !noalias !151
  %gep.12.i9115 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.12.idx.i9114
  store double 0.000000e+00, ptr %gep.12.i9115, align 8, !noalias !151
  %gep.13.i9117 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.13.idx.i9116
  store double 0.000000e+00, ptr %gep.13.i9117, align 8, !noalias !151
  %gep.14.i9119 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.14.idx.i9118
  store double 0.000000e+00, ptr %gep.14.i9119, align 8, !noalias !151
  %gep.15.i9121 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.15.idx.i9120
  store double 0.000000e+00, ptr %gep.15.i9121, align 8, !noalias !151
  %gep.16.i9123 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.16.idx.i9122
  store double 0.000000e+00, ptr %gep.16.i9123, align 8, !noalias !151
  %gep.17.i9125 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.17.idx.i9124
  store double 0.000000e+00, ptr %gep.17.i9125, align 8, !noalias !151
  %gep.18.i9127 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.18.idx.i9126
  store double 0.000000e+00, ptr %gep.18.i9127, align 8, !noalias !151
  %gep.19.i9129 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.19.idx.i9128
  store double 0.000000e+00, ptr %gep.19.i9129, align 8, !noalias !151
  %gep.20.i9131 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.20.idx.i9130
  store double 0.000000e+00, ptr %gep.20.i9131, align 8, !noalias !151
  %gep.21.i9133 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.21.idx.i9132
  store double 0.000000e+00, ptr %gep.21.i9133, align 8, !noalias !151
  %gep.22.i9135 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.22.idx.i9134
  store double 0.000000e+00, ptr %gep.22.i9135, align 8, !noalias !151
  %gep.23.i9137 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.23.idx.i9136
  store double 0.000000e+00, ptr %gep.23.i9137, align 8, !noalias !151
  %gep.24.i9139 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.24.idx.i9138
  store double 0.000000e+00, ptr %gep.24.i9139, align 8, !noalias !151
  %gep.25.i9141 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.25.idx.i9140
  store double 0.000000e+00, ptr %gep.25.i9141, align 8, !noalias !151
  %gep.26.i9143 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.26.idx.i9142
  store double 0.000000e+00, ptr %gep.26.i9143, align 8, !noalias !151
  %gep.27.i9145 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.27.idx.i9144
  store double 0.000000e+00, ptr %gep.27.i9145, align 8, !noalias !151
  %gep.28.i9147 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.28.idx.i9146
  store double 0.000000e+00, ptr %gep.28.i9147, align 8, !noalias !151
  %gep.29.i9149 = getelementptr i8, ptr %invariant.gep.i9092, i64 %gep.29.idx.i9148
  store double 0.000000e+00, ptr %gep.29.i9149, align 8, !noalias !151
  %.1455.i9150 = load double, ptr %arg.batch.2.4, align 8, !noalias !151
  %.1516.i9151 = load i64, ptr %.595.i9036, align 8, !noalias !151
  %.1531.i9152 = icmp slt i64 %.1516.i9151, 0
  %.1532.i9153 = select i1 %.1531.i9152, i64 %arg.batch.1.2.5.0, i64 0
  %254 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i9151
  %.1546.i9154 = getelementptr double, ptr %254, i64 %.1532.i9153
  %.1547.i9155 = load double, ptr %.1546.i9154, align 8, !noalias !151
  store double %.1455.i9150, ptr %invariant.gep.i9092, align 8, !noalias !151
  %.1656.i9158 = getelementptr double, ptr %97, i64 %.5208.09292
  store double %.1547.i9155, ptr %.1656.i9158, align 8, !noalias !151
  store double 1.000000e+00, ptr %.293.i9018, align 8, !noalias !151
  %.1767.i9160 = getelementptr double, ptr %98, i64 %.5208.09292
  store double 0xFFF0000000000000, ptr %.1767.i9160, align 8, !noalias !151
  %.1822.i9162 = getelementptr double, ptr %99, i64 %.5208.09292
  store double 0x7FF0000000000000, ptr %.1822.i9162, align 8, !noalias !151
  %.1877.i9164 = getelementptr double, ptr %100, i64 %.5208.09292
  %.1878.i9165 = load double, ptr %.1877.i9164, align 8, !noalias !151
  %.1880.i9166 = fcmp ueq double %.1878.i9165, 0xFFF0000000000000
  br i1 %.1880.i9166, label %B4272, label %B888.i9167

B4064:                                            ; preds = %B3922
  %.6094 = getelementptr double, ptr %101, i64 %.5208.09292
  %.6095 = load double, ptr %.6094, align 8
  %.6097 = fcmp ult double %.6095, 1.500000e+01
  br i1 %.6097, label %B4272, label %B4112

B4112:                                            ; preds = %B4064
  %.6141 = load double, ptr %.6140, align 8
  %.6195 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5208.09292
  %.6196 = load double, ptr %.6195, align 8
  %.6197 = fsub double %.6141, %.6196
  %.6251 = getelementptr double, ptr %104, i64 %.5208.09292
  %.6252 = load double, ptr %.6251, align 8
  %.6254 = fmul double %.6252, 5.000000e+03
  %.6255 = fcmp ogt double %.6197, %.6254
  br i1 %.6255, label %B4272, label %B4248

B4248:                                            ; preds = %B4112
  store double 0.000000e+00, ptr %.6094, align 8
  br label %B4272

B4272:                                            ; preds = %B888.i9167, %B3956, %B580.if.i9091, %B4112, %B4248, %B4064
  %budget.7.4 = phi i64 [ %budget.5.29294, %B4064 ], [ 0, %B4112 ], [ %budget.5.29294, %B4248 ], [ %budget.5.29294, %B580.if.i9091 ], [ %budget.5.29294, %B3956 ], [ %budget.5.29294, %B888.i9167 ]
  %.6383 = load i64, ptr %.5369, align 8
  %.6384 = icmp sgt i64 %.6383, -1
  br i1 %.6384, label %B4310, label %B4567

B4310:                                            ; preds = %B4272
  %.6389 = add nsw i64 %active.5.29295, 1
  %.6498 = mul i64 %.6383, %arg.batch.3.3.5.1
  %.6502 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.6498
  %.6503 = load i64, ptr %.6502, align 8
  %.6514.0 = and i64 %.6503, 127
  %.6544 = sub nsw i64 128, %.6514.0
  %.11.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.6544, i64 %.5506)
  %.6632 = getelementptr double, ptr %105, i64 %.5208.09292
  %.6633 = load double, ptr %.6632, align 8
  %.6635 = fcmp ogt double %.6633, 0.000000e+00
  %.6646 = sitofp i64 %.11.i to double
  %"$phi4480.1.2.5" = select i1 %.6635, double 1.000000e+00, double %.6646
  %.6709 = getelementptr double, ptr %106, i64 %.5208.09292
  store double %"$phi4480.1.2.5", ptr %.6709, align 8
  %.111.i6033 = getelementptr i64, ptr %107, i64 %.5208.09292
  %.112.i6034 = load i64, ptr %.111.i6033, align 8, !noalias !158
  %.169.i6082 = getelementptr double, ptr %108, i64 %.5208.09292
  %.170.i6083 = load double, ptr %.169.i6082, align 8, !noalias !158
  %.224.i6131 = getelementptr double, ptr %109, i64 %.5208.09292
  store double %.170.i6083, ptr %.224.i6131, align 8, !noalias !158
  %.237.i6139 = icmp slt i64 %.112.i6034, %arg.batch.2.5.0
  br i1 %.237.i6139, label %B134.i6144, label %B4567

B134.i6144:                                       ; preds = %B4310
  %.253.i6155 = icmp slt i64 %.112.i6034, 0
  %.254.i6156 = select i1 %.253.i6155, i64 %arg.batch.2.5.0, i64 0
  %255 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i6034
  %.268.i6170 = getelementptr double, ptr %255, i64 %.254.i6156
  %.269.i6171 = load double, ptr %.268.i6170, align 8, !noalias !158
  %.328.i6222 = load double, ptr %.169.i6082, align 8, !noalias !158
  %.10.i.i6229 = fcmp olt double %.328.i6222, %.269.i6171
  %.11.i.i6230 = select i1 %.10.i.i6229, double %.328.i6222, double %.269.i6171
  store double %.11.i.i6230, ptr %.224.i6131, align 8, !noalias !158
  br label %B4567

B4540:                                            ; preds = %B4567, %B3564
  %budget.4.2 = phi i64 [ %.947, %B3564 ], [ %budget.6.3, %B4567 ]
  %active.8.2 = phi i64 [ %active.9.1.mux, %B3564 ], [ %active.6.3, %B4567 ]
  %.6787 = icmp sgt i64 %active.8.2, 0
  %.6806 = icmp sgt i64 %budget.4.2, 0
  %or.cond8845 = select i1 %.6787, i1 %.6806, i1 false
  br i1 %or.cond8845, label %B422, label %B4566

B4566:                                            ; preds = %B4540, %B394
  %active.10.0 = phi i64 [ %active.4.0.lcssa, %B394 ], [ %active.8.2, %B4540 ]
  br i1 %.603, label %B4566.endif, label %B80.if.i1839.lr.ph

B80.if.i1839.lr.ph:                               ; preds = %B4566
  %.idx = mul i64 %arg.batch.4.0.5.1, 176
  %256 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx
  %.idx8771 = mul i64 %arg.batch.4.0.5.1, 184
  %257 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8771
  %.697.i1608 = add nsw i64 %arg.shape.2, -1
  %.idx8772 = mul i64 %arg.batch.4.0.5.1, 160
  %258 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8772
  br label %B80.if.i1839

B126.i1261:                                       ; preds = %B80.if.i1839
  %.318.i1308 = getelementptr double, ptr %256, i64 %.105.i1115.09300
  %.319.i1309 = load double, ptr %.318.i1308, align 8, !noalias !162
  %.5.i.i1310 = fptosi double %.319.i1309 to i64
  %.397.i1361 = getelementptr double, ptr %257, i64 %.105.i1115.09300
  %.398.i1362 = load double, ptr %.397.i1361, align 8, !noalias !162
  %.5.i1.i1363 = fptosi double %.398.i1362 to i64
  %.472.i1411 = mul i64 %.258.i1254, %arg.batch.3.3.5.1
  %.476.i1415 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.472.i1411
  %.477.i1416 = load i64, ptr %.476.i1415, align 8, !noalias !162
  %.478.i1417 = add nsw i64 %.477.i1416, %.5.i.i1310
  store i64 %.478.i1417, ptr %.476.i1415, align 8, !noalias !162
  %.584.i1509 = getelementptr i8, ptr %.476.i1415, i64 24
  %.585.i1510 = load i64, ptr %.584.i1509, align 8, !noalias !162
  %.586.i1511 = add nsw i64 %.585.i1510, %.5.i1.i1363
  store i64 %.586.i1511, ptr %.584.i1509, align 8, !noalias !162
  %.694.i1605 = getelementptr i8, ptr %.476.i1415, i64 8
  %.695.i1606 = load i64, ptr %.694.i1605, align 8, !noalias !162
  %.698.i1609 = add nsw i64 %.5.i1.i1363, %.5.i.i1310
  %.699.i1610 = mul nsw i64 %.698.i1609, %.697.i1608
  %.700.i1611 = add nsw i64 %.699.i1610, %.5.i.i1310
  %.701.i1612 = add nsw i64 %.700.i1611, %.695.i1606
  store i64 %.701.i1612, ptr %.694.i1605, align 8, !noalias !162
  store double 0.000000e+00, ptr %.318.i1308, align 8, !noalias !162
  store double 0.000000e+00, ptr %.397.i1361, align 8, !noalias !162
  %.923.i1794 = getelementptr double, ptr %258, i64 %.105.i1115.09300
  %.924.i1795 = load double, ptr %.923.i1794, align 8, !noalias !162
  %.926.i1797 = sitofp i64 %.698.i1609 to double
  %.927.i1798 = fsub double %.924.i1795, %.926.i1797
  store double %.927.i1798, ptr %.923.i1794, align 8, !noalias !162
  br label %B502.i1258

B502.i1258:                                       ; preds = %B126.i1261, %B80.if.i1839
  %.163.i1189 = icmp sgt i64 %.108.i1116.09301, 1
  br i1 %.163.i1189, label %B80.if.i1839, label %B4566.endif

B80.if.i1839:                                     ; preds = %B80.if.i1839.lr.ph, %B502.i1258
  %.108.i1116.09301 = phi i64 [ %storemerge, %B80.if.i1839.lr.ph ], [ %.172.i1844, %B502.i1258 ]
  %.105.i1115.09300 = phi i64 [ 0, %B80.if.i1839.lr.ph ], [ %.176.i1847, %B502.i1258 ]
  %.172.i1844 = add nsw i64 %.108.i1116.09301, -1
  %.176.i1847 = add nsw i64 %.105.i1115.09300, 1
  %259 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i1115.09300
  %.258.i1254 = load i64, ptr %259, align 8, !noalias !162
  %.263.i1257 = icmp sgt i64 %.258.i1254, -1
  br i1 %.263.i1257, label %B126.i1261, label %B502.i1258

B4567:                                            ; preds = %B4310, %B134.i6144, %B4272, %B3606.if
  %budget.6.3 = phi i64 [ %budget.5.29294, %B3606.if ], [ %budget.7.4, %B4272 ], [ %budget.7.4, %B134.i6144 ], [ %budget.7.4, %B4310 ]
  %active.6.3 = phi i64 [ %active.5.29295, %B3606.if ], [ %active.5.29295, %B4272 ], [ %.6389, %B134.i6144 ], [ %.6389, %B4310 ]
  %.5271 = icmp sgt i64 %.5211.09293, 1
  br i1 %.5271, label %B3606.if, label %B4540

B254.if:                                          ; preds = %B254.if.lr.ph, %B340
  %active.4.09178 = phi i64 [ 0, %B254.if.lr.ph ], [ %.898, %B340 ]
  %.592.09177 = phi i64 [ %storemerge, %B254.if.lr.ph ], [ %.656, %B340 ]
  %.589.09176 = phi i64 [ 0, %B254.if.lr.ph ], [ %.660, %B340 ]
  %.656 = add nsw i64 %.592.09177, -1
  %.660 = add nsw i64 %.589.09176, 1
  %260 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.589.09176
  %.742 = load i64, ptr %260, align 8
  %.743 = icmp slt i64 %.742, 0
  br i1 %.743, label %B296, label %B340

B1380.if:                                         ; preds = %B1348, %B1604
  %.1971.09193 = phi i64 [ %.2040, %B1604 ], [ 1, %B1348 ]
  %.2040 = add i64 %.1971.09193, 1
  %261 = getelementptr i64, ptr %arg.code.4, i64 %.1971.09193
  %262 = getelementptr i8, ptr %261, i64 104
  %.2099 = load i64, ptr %262, align 8
  %.2144 = inttoptr i64 %.2099 to ptr
  tail call void %.2144(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.2175 = load i64, ptr %arg.code.4, align 8
  %.2181 = mul nsw i64 %.2040, %.394
  %.2225 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2181
  %.2226 = inttoptr i64 %.2175 to ptr
  tail call void %.2226(ptr %.502, ptr %.2200, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.2225)
  br i1 %.541, label %B1568, label %B1604

B1748.if:                                         ; preds = %B1606, %B1834
  %looked.4.29199 = phi i1 [ %"$phi1834.1.2.2", %B1834 ], [ %spec.select8846, %B1606 ]
  %good.2.19198 = phi i1 [ %"$phi1792.1.2.2", %B1834 ], [ false, %B1606 ]
  %.2428.09197 = phi i64 [ %.2490, %B1834 ], [ %storemerge, %B1606 ]
  %.2425.09196 = phi i64 [ %.2494, %B1834 ], [ 0, %B1606 ]
  %.2490 = add nsw i64 %.2428.09197, -1
  %.2494 = add nsw i64 %.2425.09196, 1
  br i1 %good.2.19198, label %B1792, label %B1756

B1908.if:                                         ; preds = %B1908.preheader, %B2414
  %doubted.3.29209 = phi i1 [ %doubted.4.3, %B2414 ], [ false, %B1908.preheader ]
  %within.3.29208 = phi i1 [ %within.4.3, %B2414 ], [ false, %B1908.preheader ]
  %.2783.09207 = phi i64 [ %.2851, %B2414 ], [ %storemerge, %B1908.preheader ]
  %.2780.09206 = phi i64 [ %.2855, %B2414 ], [ 0, %B1908.preheader ]
  %.2851 = add nsw i64 %.2783.09207, -1
  %.2855 = add nsw i64 %.2780.09206, 1
  %.2940 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2780.09206
  %.2941 = load i64, ptr %.2940, align 8
  %.2995 = getelementptr i64, ptr %36, i64 %.2780.09206
  %.2996 = load i64, ptr %.2995, align 8
  %.3056 = getelementptr double, ptr %37, i64 %.2780.09206
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

B2816.if:                                         ; preds = %B2768
  %.4191 = load i64, ptr %110, align 8
  %.4236 = inttoptr i64 %.4191 to ptr
  tail call void %.4236(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4267 = load i64, ptr %arg.code.4, align 8
  %.4317 = inttoptr i64 %.4267 to ptr
  tail call void %.4317(ptr %.502, ptr %.4291, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4316)
  %.4191.1 = load i64, ptr %111, align 8
  %.4236.1 = inttoptr i64 %.4191.1 to ptr
  tail call void %.4236.1(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4267.1 = load i64, ptr %arg.code.4, align 8
  %.4317.1 = inttoptr i64 %.4267.1 to ptr
  tail call void %.4317.1(ptr %.502, ptr %.4291, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4316.1)
  %.4191.2 = load i64, ptr %112, align 8
  %.4236.2 = inttoptr i64 %.4191.2 to ptr
  tail call void %.4236.2(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4267.2 = load i64, ptr %arg.code.4, align 8
  %.4317.2 = inttoptr i64 %.4267.2 to ptr
  tail call void %.4317.2(ptr %.502, ptr %.4291, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4316.2)
  %.4355 = load i64, ptr %.4354, align 8
  %.4400 = inttoptr i64 %.4355 to ptr
  tail call void %.4400(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4432 = load i64, ptr %.4431, align 8
  %.4477 = inttoptr i64 %.4432 to ptr
  tail call void %.4477(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.603, label %B3184, label %B64.if.i3827

B3606.if:                                         ; preds = %B3564, %B4567
  %active.5.29295 = phi i64 [ %active.6.3, %B4567 ], [ 0, %B3564 ]
  %budget.5.29294 = phi i64 [ %budget.6.3, %B4567 ], [ %.947, %B3564 ]
  %.5211.09293 = phi i64 [ %.5280, %B4567 ], [ %storemerge, %B3564 ]
  %.5208.09292 = phi i64 [ %.5284, %B4567 ], [ 0, %B3564 ]
  %.5280 = add nsw i64 %.5211.09293, -1
  %.5284 = add nsw i64 %.5208.09292, 1
  %.5369 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5208.09292
  %.5370 = load i64, ptr %.5369, align 8
  %.5375 = icmp slt i64 %.5370, 0
  br i1 %.5375, label %B4567, label %B3654

B4566.endif:                                      ; preds = %B502.i1258, %B4566
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
!72 = distinct !{!72, !73, !"_ZN12clpt_control6native9for_numba5crossB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!73 = distinct !{!73, !"_ZN12clpt_control6native9for_numba5crossB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
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
!86 = !{!87, !89, !72}
!87 = distinct !{!87, !88, !"_ZN12clpt_control6native9for_numba7unmovedB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!88 = distinct !{!88, !"_ZN12clpt_control6native9for_numba7unmovedB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!89 = distinct !{!89, !88, !"_ZN12clpt_control6native9for_numba7unmovedB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!90 = !{!91, !72}
!91 = distinct !{!91, !92, !"_ZN12clpt_control6native9for_numba5againB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!92 = distinct !{!92, !"_ZN12clpt_control6native9for_numba5againB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!93 = !{!94}
!94 = distinct !{!94, !95, !"_ZN12clpt_control6native9for_numba5watchB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!95 = distinct !{!95, !"_ZN12clpt_control6native9for_numba5watchB3v34B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!96 = !{!97, !94}
!97 = distinct !{!97, !98, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!98 = distinct !{!98, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!99 = !{!100, !102, !94}
!100 = distinct !{!100, !101, !"_ZN12clpt_control6native9for_numba11look_withinB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!101 = distinct !{!101, !"_ZN12clpt_control6native9for_numba11look_withinB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!102 = distinct !{!102, !101, !"_ZN12clpt_control6native9for_numba11look_withinB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!103 = !{!104, !106, !100, !102, !94}
!104 = distinct !{!104, !105, !"_ZN12clpt_control6native9for_numba7betweenB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!105 = distinct !{!105, !"_ZN12clpt_control6native9for_numba7betweenB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!106 = distinct !{!106, !105, !"_ZN12clpt_control6native9for_numba7betweenB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!107 = !{!108}
!108 = distinct !{!108, !109, !"_ZN12clpt_control6native9for_numba6sampleB3v35B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!109 = distinct !{!109, !"_ZN12clpt_control6native9for_numba6sampleB3v35B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!110 = !{!111, !113, !108}
!111 = distinct !{!111, !112, !"_ZN12clpt_control6native9for_numba7betweenB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!112 = distinct !{!112, !"_ZN12clpt_control6native9for_numba7betweenB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!113 = distinct !{!113, !112, !"_ZN12clpt_control6native9for_numba7betweenB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!114 = !{!115, !117}
!115 = distinct !{!115, !116, !"_ZN12clpt_control6native9for_numba11decide_anewB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!116 = distinct !{!116, !"_ZN12clpt_control6native9for_numba11decide_anewB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!117 = distinct !{!117, !116, !"_ZN12clpt_control6native9for_numba11decide_anewB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!118 = !{!119, !115, !117}
!119 = distinct !{!119, !120, !"_ZN12clpt_control6native9for_numba4failB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29: %retptr"}
!120 = distinct !{!120, !"_ZN12clpt_control6native9for_numba4failB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29"}
!121 = !{!122, !124}
!122 = distinct !{!122, !123, !"_ZN12clpt_control6native9for_numba6at_endB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!123 = distinct !{!123, !"_ZN12clpt_control6native9for_numba6at_endB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!124 = distinct !{!124, !125, !"_ZN12clpt_control6native9for_numba4leapB3v38B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!125 = distinct !{!125, !"_ZN12clpt_control6native9for_numba4leapB3v38B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!126 = !{!124}
!127 = !{!128, !130, !124}
!128 = distinct !{!128, !129, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!129 = distinct !{!129, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!130 = distinct !{!130, !129, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!131 = !{!132, !124}
!132 = distinct !{!132, !133, !"_ZN12clpt_control6native9for_numba6at_endB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!133 = distinct !{!133, !"_ZN12clpt_control6native9for_numba6at_endB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!134 = !{!135, !124}
!135 = distinct !{!135, !136, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!136 = distinct !{!136, !"_ZN12clpt_control6native9for_numba4failB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!137 = !{!138, !124}
!138 = distinct !{!138, !139, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!139 = distinct !{!139, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!140 = !{!141}
!141 = distinct !{!141, !142, !"_ZN12clpt_control6native9for_numba4failB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29: %retptr"}
!142 = distinct !{!142, !"_ZN12clpt_control6native9for_numba4failB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29"}
!143 = !{!144, !146}
!144 = distinct !{!144, !145, !"_ZN12clpt_control6native9for_numba5enterB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!145 = distinct !{!145, !"_ZN12clpt_control6native9for_numba5enterB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!146 = distinct !{!146, !145, !"_ZN12clpt_control6native9for_numba5enterB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!147 = !{!148, !150, !144, !146}
!148 = distinct !{!148, !149, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!149 = distinct !{!149, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!150 = distinct !{!150, !149, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!151 = !{!152}
!152 = distinct !{!152, !153, !"_ZN12clpt_control6native9for_numba4takeB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!153 = distinct !{!153, !"_ZN12clpt_control6native9for_numba4takeB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!154 = !{!155, !157, !152}
!155 = distinct !{!155, !156, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!156 = distinct !{!156, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!157 = distinct !{!157, !156, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!158 = !{!159, !161}
!159 = distinct !{!159, !160, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!160 = distinct !{!160, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!161 = distinct !{!161, !160, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!162 = !{!163, !165}
!163 = distinct !{!163, !164, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!164 = distinct !{!164, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!165 = distinct !{!165, !164, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}

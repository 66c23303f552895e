; sha256 80d14b0cfbe3fab29a4077fac530694bdbcfed58c4597a10898e43fef1309e1c

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
  %4 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i
  %5 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.15.idx.i
  %6 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.28.idx.i
  %.idx1130.i = mul i64 %arg.batch.4.0.5.1, 232
  %7 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i
  br label %B254.if

B296:                                             ; preds = %B254.if
  %.236.i = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !0
  %.293.i = getelementptr double, ptr %0, i64 %.589.09061
  store double 0.000000e+00, ptr %.293.i, align 8, !noalias !0
  %.324.i = load i64, ptr %.323.i, align 8, !noalias !0
  %.326.i = icmp eq i64 %.236.i, %.324.i
  br i1 %.326.i, label %B340, label %B132.i

B132.i:                                           ; preds = %B296
  %.359.i8739 = add nsw i64 %.236.i, 1
  store i64 %.359.i8739, ptr %arg.batch.4.2.4, align 8, !noalias !0
  store i64 1, ptr %.418.i, align 8, !noalias !0
  %.438.i = icmp slt i64 %.236.i, 0
  %.439.i = select i1 %.438.i, i64 %arg.batch.0.2.5.0, i64 0
  %8 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i
  %.453.i8740 = getelementptr i64, ptr %8, i64 %.439.i
  %.454.i8741 = load i64, ptr %.453.i8740, align 8, !noalias !0
  %.469.i = icmp slt i64 %.454.i8741, 0
  %.470.i = select i1 %.469.i, i64 %arg.batch.1.0.5.0, i64 0
  %9 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i8741
  %.484.i8742 = getelementptr i64, ptr %9, i64 %.470.i
  %.485.i = load i64, ptr %.484.i8742, align 8, !noalias !0
  %.540.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.589.09061
  store i64 %.236.i, ptr %.540.i, align 8, !noalias !0
  %.595.i = getelementptr i64, ptr %1, i64 %.589.09061
  store i64 %.485.i, ptr %.595.i, align 8, !noalias !0
  %.654.i = getelementptr i64, ptr %2, i64 %.589.09061
  store i64 1, ptr %.654.i, align 8, !noalias !0
  %.709.i = getelementptr i64, ptr %3, i64 %.589.09061
  store i64 0, ptr %.709.i, align 8, !noalias !0
  br i1 %.8051131.not.i, label %B402.i, label %B358.if.lr.ph.i

B358.if.lr.ph.i:                                  ; preds = %B132.i
  %.867.i = select i1 %.438.i, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i = add i64 %.867.i, %.236.i
  %.888.i = mul i64 %.868.i, %arg.batch.0.1.5.1
  %10 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i
  %invariant.gep9210 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.589.09061
  br label %B358.if.i

B402.i:                                           ; preds = %B358.if.i, %B132.i
  br i1 %.175.i1134.not.i, label %B402.endif.i, label %B76.if.i.lr.ph.i

B76.if.i.lr.ph.i:                                 ; preds = %B402.i
  %.990.i = load i64, ptr %.595.i, align 8, !noalias !0
  %.236.i.i = icmp slt i64 %.990.i, 0
  %.237.i.i8744 = select i1 %.236.i.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i = add i64 %.237.i.i8744, %.990.i
  %.258.i.i = mul i64 %.238.i.i, %arg.batch.1.3.5.1
  %11 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i
  br label %B76.if.i.i8745

B76.if.i.i8745:                                   ; preds = %B76.if.i.i8745, %B76.if.i.lr.ph.i
  %.117.i.01135.i = phi i64 [ 0, %B76.if.i.lr.ph.i ], [ %.188.i.i, %B76.if.i.i8745 ]
  %.188.i.i = add nsw i64 %.117.i.01135.i, 1
  %12 = getelementptr double, ptr %11, i64 %.117.i.01135.i
  %.263.i.i = load double, ptr %12, align 8, !noalias !3
  %13 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i
  %.293.i.i = load i64, ptr %13, align 8, !noalias !3
  %.295.i.i8746 = mul nsw i64 %.293.i.i, %arg.shape.0
  %.297.i.i = add nsw i64 %.295.i.i8746, %.589.09061
  %.311.i.i = icmp slt i64 %.297.i.i, 0
  %.312.i.i = select i1 %.311.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %14 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i
  %.326.i.i = getelementptr double, ptr %14, i64 %.312.i.i
  store double %.263.i.i, ptr %.326.i.i, align 8, !noalias !3
  %exitcond1142.not.i = icmp eq i64 %.188.i.i, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i, label %B402.endif.i, label %B76.if.i.i8745

B888.i:                                           ; preds = %B580.if.i
  store double 0.000000e+00, ptr %.1877.i, align 8, !noalias !0
  br label %B340

B358.if.i:                                        ; preds = %B358.if.i, %B358.if.lr.ph.i
  %.747.01132.i = phi i64 [ 0, %B358.if.lr.ph.i ], [ %.818.i, %B358.if.i ]
  %.818.i = add nsw i64 %.747.01132.i, 1
  %15 = getelementptr double, ptr %10, i64 %.747.01132.i
  %.893.i = load double, ptr %15, align 8, !noalias !0
  %.895.i = mul nsw i64 %.747.01132.i, %arg.shape.0
  %gep9211 = getelementptr double, ptr %invariant.gep9210, i64 %.895.i
  store double %.893.i, ptr %gep9211, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.818.i, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i, label %B402.i, label %B358.if.i

B402.endif.i:                                     ; preds = %B76.if.i.i8745, %B402.i
  br i1 %.11171137.not.i, label %B580.if.i, label %B496.if.lr.ph.i

B496.if.lr.ph.i:                                  ; preds = %B402.endif.i
  %.1179.i = select i1 %.438.i, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i = add i64 %.1179.i, %.236.i
  %.1200.i = mul i64 %.1180.i, %arg.batch.0.0.5.1
  %16 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i
  %invariant.gep9212 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.589.09061
  br label %B496.if.i

B496.if.i:                                        ; preds = %B496.if.i, %B496.if.lr.ph.i
  %.1061.01138.i = phi i64 [ 0, %B496.if.lr.ph.i ], [ %.1130.i, %B496.if.i ]
  %.1130.i = add nsw i64 %.1061.01138.i, 1
  %17 = getelementptr double, ptr %16, i64 %.1061.01138.i
  %.1205.i = load double, ptr %17, align 8, !noalias !0
  %.1207.i = mul nsw i64 %.1061.01138.i, %arg.shape.0
  %gep9213 = getelementptr double, ptr %invariant.gep9212, i64 %.1207.i
  store double %.1205.i, ptr %gep9213, align 8, !noalias !0
  %exitcond1143.not.i = icmp eq i64 %.1130.i, %arg.shape.1
  br i1 %exitcond1143.not.i, label %B580.if.i, label %B496.if.i

B580.if.i:                                        ; preds = %B496.if.i, %B402.endif.i
  %invariant.gep.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.589.09061
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
  %.1455.i = load double, ptr %arg.batch.2.4, align 8, !noalias !0
  %.1516.i = load i64, ptr %.595.i, align 8, !noalias !0
  %.1531.i = icmp slt i64 %.1516.i, 0
  %.1532.i = select i1 %.1531.i, i64 %arg.batch.1.2.5.0, i64 0
  %18 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i
  %.1546.i = getelementptr double, ptr %18, i64 %.1532.i
  %.1547.i = load double, ptr %.1546.i, align 8, !noalias !0
  store double %.1455.i, ptr %invariant.gep.i, align 8, !noalias !0
  %.1656.i = getelementptr double, ptr %4, i64 %.589.09061
  store double %.1547.i, ptr %.1656.i, align 8, !noalias !0
  store double 1.000000e+00, ptr %.293.i, align 8, !noalias !0
  %.1767.i = getelementptr double, ptr %5, i64 %.589.09061
  store double 0xFFF0000000000000, ptr %.1767.i, align 8, !noalias !0
  %.1822.i = getelementptr double, ptr %6, i64 %.589.09061
  store double 0x7FF0000000000000, ptr %.1822.i, align 8, !noalias !0
  %.1877.i = getelementptr double, ptr %7, i64 %.589.09061
  %.1878.i = load double, ptr %.1877.i, align 8, !noalias !0
  %.1880.i = fcmp ueq double %.1878.i, 0xFFF0000000000000
  br i1 %.1880.i, label %B340, label %B888.i

B340:                                             ; preds = %B888.i, %B296, %B580.if.i, %B254.if
  %.880 = load i64, ptr %253, align 8
  %.881 = icmp sgt i64 %.880, -1
  %. = zext i1 %.881 to i64
  %.898 = add nsw i64 %active.4.09063, %.
  %.647 = icmp sgt i64 %.592.09062, 1
  br i1 %.647, label %B254.if, label %B394

B394:                                             ; preds = %B340, %entry
  %active.4.0.lcssa = phi i64 [ 0, %entry ], [ %.898, %B340 ]
  %.915.not = icmp ne i64 %active.4.0.lcssa, 0
  %.937 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.915.not, i1 %.937, i1 false
  br i1 %or.cond, label %B422.preheader, label %B4564

B422.preheader:                                   ; preds = %B394
  %.981 = getelementptr i8, ptr %arg.batch.4.2.4, i64 16
  %factor.op.mul = mul i64 %arg.shape.0, %arg.shape.1
  %factor.op.mul9183 = mul i64 %arg.shape.0, %arg.shape.1
  %.1077 = getelementptr i8, ptr %arg.code.4, i64 8
  %.1129 = icmp sgt i64 %arg.shape.6, 0
  %.162.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx8719 = mul i64 %arg.batch.4.0.5.1, 24
  %19 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8719
  %.537.i9064 = icmp slt i64 %arg.shape.6, 1
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
  %.idx8711 = mul i64 %arg.batch.4.0.5.1, 24
  %20 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8711
  %.idx8712 = shl i64 %arg.batch.4.0.5.1, 5
  %21 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8712
  %.idx8713 = mul i64 %arg.batch.4.0.5.1, 248
  %22 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8713
  %.8720 = select i1 %.543.not, i64 2, i64 0
  %.idx8714 = mul i64 %arg.batch.4.0.5.1, 88
  %23 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8714
  %.idx8715 = shl i64 %arg.batch.4.0.5.1, 4
  %24 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8715
  %.idx8716 = shl i64 %arg.batch.4.1.5.1, 4
  %25 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8716
  %.idx8717 = shl i64 %arg.batch.4.0.5.1, 4
  %26 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8717
  %.idx8718 = mul i64 %arg.batch.4.0.5.1, 144
  %27 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8718
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
  %.183.i.i8752 = getelementptr i8, ptr %arg.linear.1.4, i64 32
  %.186.i.i = add nsw i64 %.124.i.i, %arg.shape.1
  %.187.i.i = add nsw i64 %.186.i.i, 1
  %.224.i.i8754 = icmp slt i64 %arg.shape.1, -2
  %.225.i.i = select i1 %.224.i.i8754, i64 %arg.linear.1.5.0, i64 0
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
  %.idx.i8757 = mul i64 %arg.shape.1, 152
  %30 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i8757
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
  %.1140.idx.i = mul i64 %arg.batch.4.0.5.1, 136
  %.1140.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.1140.idx.i
  %.1984 = add i64 %arg.shape.2, -1
  %storemerge8658 = tail call i64 @llvm.smax.i64(i64 %.1984, i64 0)
  %.20279077.not = icmp slt i64 %.1984, 1
  %.2200.idx = mul i64 %.394, 136
  %.2200 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.2200.idx
  %.42.i = mul nsw i64 %arg.shape.1, %arg.shape.1
  %.88.not.i = icmp slt i64 %.42.i, %arg.linear.0.5.0
  %.218.i = add nsw i64 %arg.shape.1, 5
  %.265.i = icmp slt i64 %arg.linear.1.5.0, 6
  %.272.i8761 = icmp slt i64 %arg.shape.1, -5
  %.273.i = select i1 %.272.i8761, i64 %arg.linear.1.5.0, i64 0
  %.274.i = add i64 %.218.i, %.273.i
  %.277.i = icmp slt i64 %.274.i, 0
  %.282.not.i = icmp slt i64 %.274.i, %arg.linear.1.5.0
  %.648747.not.i = icmp slt i64 %arg.shape.1, 1
  %.756.i = mul nsw i64 %arg.shape.1, 17
  %.idx.i8763 = mul i64 %arg.shape.1, 80
  %invariant.gep9073 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i8763
  %.882.i = getelementptr i8, ptr %arg.linear.1.4, i64 8
  %.887.i = mul nsw i64 %arg.shape.1, 17
  %invariant.gep9075 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.887.i
  %.2303 = getelementptr i8, ptr %arg.code.4, i64 64
  %.2380 = icmp sgt i64 %arg.shape.3, 0
  %.2385 = icmp sgt i64 %arg.shape.6, 0
  %.idx8709 = mul i64 %arg.batch.4.0.5.1, 40
  %31 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8709
  %.idx8710 = mul i64 %arg.batch.4.0.5.1, 160
  %32 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8710
  %.idx8706 = mul i64 %arg.batch.4.0.5.1, 168
  %33 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8706
  %.idx8707 = mul i64 %arg.batch.4.0.5.1, 176
  %34 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8707
  %.idx8708 = mul i64 %arg.batch.4.0.5.1, 152
  %35 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8708
  %.idx8700 = shl i64 %arg.batch.4.1.5.1, 4
  %36 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8700
  %.idx8701 = mul i64 %arg.batch.4.0.5.1, 184
  %37 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8701
  %.idx8702 = mul i64 %arg.batch.4.0.5.1, 72
  %38 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8702
  %.idx8703 = mul i64 %arg.batch.4.0.5.1, 40
  %39 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8703
  %.idx8704 = mul i64 %arg.batch.4.0.5.1, 232
  %40 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8704
  %.idx8705 = mul i64 %arg.batch.4.0.5.1, 56
  %41 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8705
  %.3773.idx = mul i64 %.394, 136
  %.3773 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3773.idx
  %.3798.idx = mul i64 %.394, 104
  %.3798 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3798.idx
  %.3836 = getelementptr i8, ptr %arg.code.4, i64 232
  %.3930 = getelementptr i8, ptr %arg.code.4, i64 40
  %.3952.idx = mul i64 %.394, 136
  %.3952 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3952.idx
  %.idx8695 = mul i64 %arg.batch.4.0.5.1, 96
  %42 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8695
  %.idx8696 = mul i64 %arg.batch.4.0.5.1, 40
  %43 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8696
  %.idx8697 = mul i64 %arg.batch.4.0.5.1, 104
  %44 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8697
  %.idx8698 = mul i64 %arg.batch.4.0.5.1, 112
  %45 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8698
  %.idx8699 = shl i64 %arg.batch.4.1.5.1, 5
  %46 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8699
  %.4291.idx = mul i64 %.394, 136
  %.4291 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4291.idx
  %.4354 = getelementptr i8, ptr %arg.code.4, i64 200
  %.4431 = getelementptr i8, ptr %arg.code.4, i64 104
  %.idx8687 = shl i64 %arg.batch.4.1.5.1, 4
  %47 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8687
  %.idx8688 = mul i64 %arg.batch.4.0.5.1, 40
  %48 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8688
  %.idx8689 = mul i64 %arg.batch.4.0.5.1, 56
  %49 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8689
  %.idx8690 = mul i64 %arg.batch.4.0.5.1, 216
  %50 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8690
  %.idx8691 = mul i64 %arg.batch.4.0.5.1, 48
  %51 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8691
  %.idx8692 = shl i64 %arg.batch.4.0.5.1, 5
  %52 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8692
  %53 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx8693 = mul i64 %arg.batch.4.0.5.1, 96
  %54 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8693
  %.idx8694 = mul i64 %arg.batch.4.0.5.1, 224
  %55 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8694
  %.4431.c = getelementptr i8, ptr %arg.code.4, i64 104
  %56 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.212.i = getelementptr i8, ptr %56, i64 -8
  %.767.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.859.i.idx = shl i64 %factor.op.mul, 4
  %.859.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.859.i.idx
  %.idx1242.i = mul i64 %arg.batch.4.0.5.1, 104
  %57 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1242.i
  %.idx1243.i = mul i64 %arg.batch.4.0.5.1, 112
  %58 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1243.i
  %.idx1244.i = mul i64 %arg.batch.4.0.5.1, 96
  %59 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1244.i
  %.idx1245.i = mul i64 %arg.batch.4.0.5.1, 48
  %60 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1245.i
  %.287.i1254.not.i = icmp slt i64 %arg.shape.1, 1
  %.359.i.i = shl nsw i64 %arg.shape.1, 1
  %storemerge1241.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.155.i.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx.i8785 = mul i64 %arg.batch.4.0.5.1, 56
  %61 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i8785
  %.idx1234.i = mul i64 %arg.batch.4.0.5.1, 40
  %62 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1234.i
  %.idx1235.i = shl i64 %arg.batch.4.0.5.1, 5
  %63 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1235.i
  %64 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.4622.not = icmp eq i64 %arg.shape.3, 0
  %.8729 = select i1 %.543.not, i64 16, i64 1
  %.526.i8801 = getelementptr i8, ptr %arg.code.4, i64 16
  %.618.i.idx = shl i64 %factor.op.mul9183, 4
  %.618.i = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.618.i.idx
  %.452.i = uitofp i64 %.8729 to double
  %.idx673.i = mul i64 %arg.batch.4.0.5.1, 48
  %65 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx673.i
  %.287.i679.not.i = icmp slt i64 %arg.shape.1, 1
  %.359.i.i8802 = shl nsw i64 %arg.shape.1, 1
  %.idx.i8803 = mul i64 %arg.batch.4.0.5.1, 40
  %66 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i8803
  %.155.i.i.i8813 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i8820 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i8826 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i8832 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i8838 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i8844 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i8850 = mul nsw i64 %arg.shape.1, 18
  %factor.op.mul652.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx.i8868 = shl i64 %arg.batch.4.1.5.1, 4
  %67 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx.i8868
  %.idx640.i = mul i64 %arg.batch.4.0.5.1, 40
  %68 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx640.i
  %.idx641.i = mul i64 %arg.batch.4.0.5.1, 48
  %69 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx641.i
  %.idx642.i = mul i64 %arg.batch.4.0.5.1, 56
  %70 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx642.i
  %.924649.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx644.i = mul i64 %arg.batch.4.0.5.1, 224
  %71 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx644.i
  %.1000.i = mul nsw i64 %arg.shape.1, 17
  %72 = add i64 %arg.batch.2.5.0, -1
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.4860 = icmp sgt i64 %arg.shape.0, 1
  %.4914.idx = mul i64 %arg.batch.4.0.5.1, 40
  %.4914 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.4914.idx
  %.4946 = getelementptr i8, ptr %arg.code.4, i64 96
  %.idx8680 = mul i64 %arg.batch.4.0.5.1, 96
  %73 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8680
  %.idx8681 = mul i64 %arg.batch.4.0.5.1, 40
  %74 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8681
  %.idx8682 = mul i64 %arg.batch.4.0.5.1, 120
  %75 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8682
  %.552.i40229161.not = icmp slt i64 %arg.shape.1, 1
  %.697.i4059 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %76 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.742.i4089 = getelementptr i8, ptr %76, i64 -8
  %.idx8684 = mul i64 %arg.batch.4.1.5.1, 24
  %77 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8684
  %.idx8685 = mul i64 %arg.batch.4.1.5.1, 24
  %78 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8685
  %.idx8686 = mul i64 %arg.batch.4.0.5.1, 24
  %79 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8686
  %.5057.not = icmp ne i64 %arg.shape.4, 0
  %storemerge.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.0, i64 0)
  %.idx1632.i = mul i64 %arg.batch.4.0.5.1, 40
  %80 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1632.i
  %.idx1633.i = shl i64 %arg.batch.4.0.5.1, 4
  %81 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1633.i
  %82 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.175.i3061635.not.i = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.636.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.779.i = getelementptr i8, ptr %arg.code.4, i64 32
  %.850.i = mul nsw i64 %arg.shape.1, 17
  %.852.i = mul nsw i64 %.850.i, %arg.shape.0
  %.895.i8890 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.852.i
  %.900.not.i = icmp eq i64 %arg.shape.3, 0
  %.930.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx1630.i = shl i64 %arg.batch.4.1.5.1, 4
  %83 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1630.i
  %.15441642.not.i = icmp slt i64 %arg.shape.1, 1
  %.1739.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx8669 = mul i64 %arg.batch.4.0.5.1, 40
  %84 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8669
  %.idx8670 = shl i64 %arg.batch.4.0.5.1, 4
  %85 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8670
  %86 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx8671 = mul i64 %arg.batch.4.0.5.1, 24
  %87 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8671
  %.175.i.i53889173.not = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.idx8674 = shl i64 %arg.batch.4.1.5.1, 4
  %88 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8674
  %.idx.i8904 = mul i64 %arg.batch.4.0.5.1, 24
  %89 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i8904
  %.323.i8906 = getelementptr i8, ptr %arg.batch.4.2.4, i64 8
  %90 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx1124.i8926 = mul i64 %arg.batch.4.1.5.1, 24
  %91 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1124.i8926
  %.8051131.not.i8928 = icmp slt i64 %arg.batch.0.1.5.1, 1
  %.175.i1134.not.i8944 = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.11171137.not.i8963 = icmp slt i64 %arg.shape.1, 1
  %gep.2.idx.i8981 = shl i64 %arg.batch.4.0.5.1, 4
  %gep.4.idx.i8985 = shl i64 %arg.batch.4.0.5.1, 5
  %gep.6.idx.i8989 = mul i64 %arg.batch.4.0.5.1, 48
  %gep.7.idx.i8991 = mul i64 %arg.batch.4.0.5.1, 56
  %gep.9.idx.i8995 = mul i64 %arg.batch.4.0.5.1, 72
  %gep.10.idx.i8997 = mul i64 %arg.batch.4.0.5.1, 80
  %gep.11.idx.i8999 = mul i64 %arg.batch.4.0.5.1, 88
  %gep.12.idx.i9001 = mul i64 %arg.batch.4.0.5.1, 96
  %gep.13.idx.i9003 = mul i64 %arg.batch.4.0.5.1, 104
  %gep.14.idx.i9005 = mul i64 %arg.batch.4.0.5.1, 112
  %gep.15.idx.i9007 = mul i64 %arg.batch.4.0.5.1, 120
  %gep.16.idx.i9009 = shl i64 %arg.batch.4.0.5.1, 7
  %gep.17.idx.i9011 = mul i64 %arg.batch.4.0.5.1, 136
  %gep.18.idx.i9013 = mul i64 %arg.batch.4.0.5.1, 144
  %gep.19.idx.i9015 = mul i64 %arg.batch.4.0.5.1, 152
  %gep.20.idx.i9017 = mul i64 %arg.batch.4.0.5.1, 160
  %gep.21.idx.i9019 = mul i64 %arg.batch.4.0.5.1, 168
  %gep.22.idx.i9021 = mul i64 %arg.batch.4.0.5.1, 176
  %gep.23.idx.i9023 = mul i64 %arg.batch.4.0.5.1, 184
  %gep.24.idx.i9025 = mul i64 %arg.batch.4.0.5.1, 192
  %gep.25.idx.i9027 = mul i64 %arg.batch.4.0.5.1, 200
  %gep.26.idx.i9029 = mul i64 %arg.batch.4.0.5.1, 208
  %gep.27.idx.i9031 = mul i64 %arg.batch.4.0.5.1, 216
  %gep.28.idx.i9033 = mul i64 %arg.batch.4.0.5.1, 224
  %92 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i8981
  %93 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.15.idx.i9007
  %94 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.28.idx.i9033
  %.idx1130.i9048 = mul i64 %arg.batch.4.0.5.1, 232
  %95 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i9048
  %.idx8673 = mul i64 %arg.batch.4.0.5.1, 232
  %96 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8673
  %.6123 = tail call i64 @llvm.smin.i64(i64 %arg.batch.2.5.0, i64 0)
  %97 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %98 = getelementptr i8, ptr %97, i64 -8
  %.6137 = getelementptr double, ptr %98, i64 %.6123
  %99 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx8675 = mul i64 %arg.batch.4.0.5.1, 232
  %100 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8675
  %.idx8676 = mul i64 %arg.batch.4.0.5.1, 152
  %101 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8676
  %.idx8677 = shl i64 %arg.batch.4.1.5.1, 4
  %102 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx8677
  %.idx8678 = shl i64 %arg.batch.4.0.5.1, 4
  %103 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8678
  %.idx8679 = mul i64 %arg.batch.4.0.5.1, 144
  %104 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8679
  %105 = getelementptr i8, ptr %arg.code.4, i64 208
  %.4316.idx = mul i64 %.394, 112
  %.4316 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4316.idx
  %106 = getelementptr i8, ptr %arg.code.4, i64 216
  %.4316.1.idx = mul i64 %.394, 120
  %.4316.1 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4316.1.idx
  %107 = getelementptr i8, ptr %arg.code.4, i64 224
  %.4316.2.idx = shl i64 %.394, 7
  %.4316.2 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4316.2.idx
  br label %B422

B422:                                             ; preds = %B422.preheader, %B4538
  %budget.3.1 = phi i64 [ %budget.4.2, %B4538 ], [ %arg.budget, %B422.preheader ]
  %looked.3.1 = phi i1 [ %looked.4.2.lcssa, %B4538 ], [ true, %B422.preheader ]
  %active.9.1 = phi i64 [ %active.8.2, %B4538 ], [ %active.4.0.lcssa, %B422.preheader ]
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
  %.359.i = icmp sgt i64 %.304.i.09069, 1
  br i1 %.359.i, label %B194.if.i, label %B326.i

B326.i:                                           ; preds = %B324.i, %B586
  %.692.i = load i64, ptr %.691.i, align 8, !noalias !7
  %.808.i = inttoptr i64 %.692.i to ptr
  tail call void %.808.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br label %B622

B194.if.i:                                        ; preds = %B586, %B324.i
  %.304.i.09069 = phi i64 [ %.368.i, %B324.i ], [ %storemerge, %B586 ]
  %.301.i.09068 = phi i64 [ %.372.i, %B324.i ], [ 0, %B586 ]
  %.368.i = add nsw i64 %.304.i.09069, -1
  %.372.i = add nsw i64 %.301.i.09068, 1
  %108 = getelementptr double, ptr %19, i64 %.301.i.09068
  %.454.i = load double, ptr %108, align 8, !noalias !7
  %.455.i = fcmp ule double %.454.i, 5.000000e-01
  %brmerge9187 = select i1 %.455.i, i1 true, i1 %.537.i9064
  br i1 %brmerge9187, label %B324.i, label %B266.if.i.preheader

B266.if.i.preheader:                              ; preds = %B194.if.i
  %invariant.gep9214 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.301.i.09068
  br label %B266.if.i

B266.if.i:                                        ; preds = %B266.if.i.preheader, %B266.if.i
  %.481.i.09065 = phi i64 [ %.550.i, %B266.if.i ], [ 0, %B266.if.i.preheader ]
  %.550.i = add nsw i64 %.481.i.09065, 1
  %.576.i = mul nsw i64 %.481.i.09065, %arg.shape.0
  %gep9215 = getelementptr double, ptr %invariant.gep9214, i64 %.576.i
  %.608.i = load double, ptr %gep9215, align 8, !noalias !7
  %.610.i = add nsw i64 %.481.i.09065, %arg.shape.5
  %.612.i = mul nsw i64 %.610.i, %arg.shape.0
  %.614.i = add nsw i64 %.612.i, %.301.i.09068
  %.628.i = icmp slt i64 %.614.i, 0
  %.629.i = select i1 %.628.i, i64 %arg.batch.5.1.5.0, i64 0
  %109 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.614.i
  %.643.i = getelementptr double, ptr %109, i64 %.629.i
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
  %.441.i = getelementptr double, ptr %21, i64 %.170.i.09071
  store double 0.000000e+00, ptr %.441.i, align 8, !noalias !11
  %.496.i215 = getelementptr double, ptr %22, i64 %.170.i.09071
  store double 0.000000e+00, ptr %.496.i215, align 8, !noalias !11
  %.551.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.170.i.09071
  %.552.i245 = load i64, ptr %.551.i, align 8, !noalias !11
  %.579.i257 = icmp slt i64 %.552.i245, 0
  %.580.i258 = select i1 %.579.i257, i64 %arg.batch.3.3.5.0, i64 0
  %.581.i = add i64 %.580.i258, %.552.i245
  %.601.i272 = mul i64 %.581.i, %arg.batch.3.3.5.1
  %110 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.601.i272
  %.605.i = getelementptr i8, ptr %110, i64 8
  %.606.i = load i64, ptr %.605.i, align 8, !noalias !11
  %.628.i284 = add nsw i64 %.606.i, %.8720
  store i64 %.628.i284, ptr %.605.i, align 8, !noalias !11
  %.744.i347 = load i64, ptr %.551.i, align 8, !noalias !11
  %.771.i = icmp slt i64 %.744.i347, 0
  %.772.i = select i1 %.771.i, i64 %arg.batch.3.3.5.0, i64 0
  %.773.i = add i64 %.772.i, %.744.i347
  %.793.i370 = mul i64 %.773.i, %arg.batch.3.3.5.1
  %111 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.793.i370
  %.797.i = getelementptr i8, ptr %111, i64 16
  %.798.i = load i64, ptr %.797.i, align 8, !noalias !11
  %.799.i373 = add nsw i64 %.798.i, 1
  store i64 %.799.i373, ptr %.797.i, align 8, !noalias !11
  %.905.i = getelementptr double, ptr %23, i64 %.170.i.09071
  %.906.i = load double, ptr %.905.i, align 8, !noalias !11
  %.907.i = fcmp une double %.906.i, 0.000000e+00
  br i1 %.907.i, label %B368.i, label %B414.i

B368.i:                                           ; preds = %B106.i
  %112 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.170.i.09071
  %.84.i.i = load i64, ptr %112, align 8, !noalias !15
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
  %113 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.170.i.09071
  %.977.i = load double, ptr %113, align 8, !noalias !11
  %.979.i = fcmp olt double %.977.i, -1.000000e-09
  br i1 %.979.i, label %B454.i, label %B550.i

B454.i:                                           ; preds = %B418.i
  %114 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.170.i.09071
  %.84.i63.i = load i64, ptr %114, align 8, !noalias !18
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
  %.1068.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.170.i.09071
  %.1069.i = load double, ptr %.1068.i, align 8, !noalias !11
  %.1123.i = getelementptr double, ptr %24, i64 %.170.i.09071
  store double %.1069.i, ptr %.1123.i, align 8, !noalias !11
  br label %B550.i

B550.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i, %B418.i, %B414.i
  %.111.i183.i = getelementptr i64, ptr %25, i64 %.170.i.09071
  %.112.i.i = load i64, ptr %.111.i183.i, align 8, !noalias !21
  %.169.i.i = getelementptr double, ptr %26, i64 %.170.i.09071
  %.170.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.224.i.i = getelementptr double, ptr %27, i64 %.170.i.09071
  store double %.170.i.i, ptr %.224.i.i, align 8, !noalias !21
  %.237.i.i = icmp slt i64 %.112.i.i, %arg.batch.2.5.0
  br i1 %.237.i.i, label %B134.i.i, label %B584.i

B134.i.i:                                         ; preds = %B550.i
  %.253.i.i = icmp slt i64 %.112.i.i, 0
  %.254.i.i = select i1 %.253.i.i, i64 %arg.batch.2.5.0, i64 0
  %115 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i.i
  %.268.i.i = getelementptr double, ptr %115, i64 %.254.i.i
  %.269.i.i = load double, ptr %.268.i.i, align 8, !noalias !21
  %.328.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.10.i.i.i = fcmp olt double %.328.i.i, %.269.i.i
  %.11.i.i.i = select i1 %.10.i.i.i, double %.328.i.i, double %.269.i.i
  store double %.11.i.i.i, ptr %.224.i.i, align 8, !noalias !21
  br label %B584.i

B584.i:                                           ; preds = %B134.i.i, %B550.i, %B64.if.i
  %.229.i103 = icmp sgt i64 %.173.i7.09072, 1
  br i1 %.229.i103, label %B64.if.i, label %B1140

B64.if.i:                                         ; preds = %B1098, %B584.i
  %.173.i7.09072 = phi i64 [ %.238.i, %B584.i ], [ %storemerge, %B1098 ]
  %.170.i.09071 = phi i64 [ %.242.i388, %B584.i ], [ 0, %B1098 ]
  %.238.i = add nsw i64 %.173.i7.09072, -1
  %.242.i388 = add nsw i64 %.170.i.09071, 1
  %.323.i132 = getelementptr double, ptr %20, i64 %.170.i.09071
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
  %.154.i.i8751 = load i64, ptr %.153.i.i, align 8, !noalias !26
  %.184.i.i8753 = load i64, ptr %.183.i.i8752, align 8, !noalias !26
  br i1 %.234.i.i, label %B0.else.endif.if.i.i, label %B0.else.endif.endif.i.i, !prof !32

B412.i.i:                                         ; preds = %B330.if.i.i, %B0.endif.endif.endif.endif.endif.i.i
  %.1311.i.i = add nsw i64 %.486.i.i, -1
  %.1349.i.i = icmp slt i64 %.477.i.i, 2
  %storemerge2239.i = select i1 %.1349.i.i, i64 0, i64 %.1311.i.i
  %.1392.i2287.i = icmp sgt i64 %storemerge2239.i, 0
  br i1 %.1392.i2287.i, label %B478.i.lr.ph.i, label %B164.i

B478.i.lr.ph.i:                                   ; preds = %B412.i.i
  %.1338.i.12290.i = add nsw i64 %storemerge2239.i, -1
  %.511.i.i.i = select i1 %.1556.i2266.not.i, i64 %.311.i.i8755, i64 0
  %116 = getelementptr i64, ptr %.327.i.i, i64 %arg.shape.1
  %.525.i.i.i = getelementptr i64, ptr %116, i64 %.511.i.i.i
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
  %117 = getelementptr i64, ptr %.502.i.i, i64 %.1382.i.sroa.0.02293.i
  %.1864.i.i = getelementptr i64, ptr %117, i64 %.1850.i.i
  %.1865.i.i = load i64, ptr %.1864.i.i, align 8, !noalias !26
  %.1881.i.i = icmp slt i64 %.1382.i.sroa.0.02293.i, -1
  %.1882.i.i = select i1 %.1881.i.i, i64 %.486.i.i, i64 0
  %118 = getelementptr i8, ptr %117, i64 8
  %.1896.i.i = getelementptr i64, ptr %118, i64 %.1882.i.i
  %.1897.i.i = load i64, ptr %.1896.i.i, align 8, !noalias !26
  %.1934.i.i = sub i64 %.1897.i.i, %.1865.i.i
  %.1980.i2269.not.i = icmp slt i64 %.1934.i.i, 1
  br i1 %.1980.i2269.not.i, label %B960.i.i, label %B794.if.i.i

B802.i.i:                                         ; preds = %B794.if.i.i
  %.2047.i.i = icmp slt i64 %.1921.i.02270.i, 0
  %.2048.i.i = select i1 %.2047.i.i, i64 %.665.i.i, i64 0
  %119 = getelementptr i64, ptr %.681.i.i, i64 %.1921.i.02270.i
  %.2062.i.i = getelementptr i64, ptr %119, i64 %.2048.i.i
  %.2063.i.i = load i64, ptr %.2062.i.i, align 8, !noalias !26
  %.2064.i.i = add nsw i64 %.2063.i.i, %.1789.i.i
  %.2078.i.i = icmp slt i64 %.2064.i.i, 0
  %.2079.i.i = select i1 %.2078.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %120 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2064.i.i
  %.2093.i.i = getelementptr double, ptr %120, i64 %.2079.i.i
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
  %121 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02277.1.i
  %.906.i.i.1.i = load double, ptr %121, align 8, !noalias !33
  %122 = getelementptr double, ptr %121, i64 %.597.i.i.i
  %.939.i.i.1.i = load double, ptr %122, align 8, !noalias !33
  %.941.i.i.1.i = fmul double %.939.i.i.1.i, 5.000000e-01
  %123 = fsub double %.906.i.i.1.i, %.941.i.i.1.i
  %124 = getelementptr double, ptr %121, i64 %.944.i.i.i
  store double %123, ptr %124, align 8, !noalias !33
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
  %125 = fsub double %.1034.i.i.1.i, %.1070.i.i.1.i
  store double %125, ptr %.502, align 8, !noalias !33
  %.1157.i.i.1.i = load i64, ptr %arg.code.4, align 8, !noalias !33
  %.1277.i.i.1.i = inttoptr i64 %.1157.i.i.1.i to ptr
  tail call void %.1277.i.i.1.i(ptr nonnull %.502, ptr %.1807.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.1.i), !noalias !33
  br i1 %.1162.i2263.not.i, label %B960.i.i, label %B780.if.i.i.i

B966.i.i.i:                                       ; preds = %B780.if.i.i.i
  %.1601.i.i.i = fsub double %.1513.i.i.i, %.1548.i.i.i
  br label %B1053.i.i.i

B1006.i.i.i:                                      ; preds = %B780.if.i.i.i
  %126 = getelementptr double, ptr %134, i64 %arg.shape.1
  %.1582.i.i.i = load double, ptr %126, align 8, !noalias !33
  %.1647.i.i.i = fsub double %.1513.i.i.i, %.1582.i.i.i
  %.1652.i.i.i = fmul double %.1647.i.i.i, 2.000000e+00
  br label %B1053.i.i.i

B1053.i.i.i:                                      ; preds = %B1006.i.i.i, %B966.i.i.i
  %storemerge2247.i = phi double [ %.1652.i.i.i, %B1006.i.i.i ], [ %.1601.i.i.i, %B966.i.i.i ]
  store double %storemerge2247.i, ptr %136, align 8, !noalias !33
  %exitcond2303.not.i = icmp eq i64 %arg.shape.1, %.1387.i.i.i
  br i1 %exitcond2303.not.i, label %B960.i.i, label %B780.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B918.i.i, %B84.if.i.i.i
  %.212.i.i.02275.i = phi i64 [ %.283.i.i.i, %B84.if.i.i.i ], [ 0, %B918.i.i ]
  %.283.i.i.i = add nsw i64 %.212.i.i.02275.i, 1
  %127 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.212.i.i.02275.i
  %.341.i.i.i = load double, ptr %127, align 8, !noalias !33
  %.342.i.i.i = tail call double @llvm.fabs.f64(double %.341.i.i.i)
  %.10.i.i.i.i = fcmp ogt double %.184.i.i.i, %.342.i.i.i
  %.11.i.i.i.i = select i1 %.10.i.i.i.i, double %.184.i.i.i, double %.342.i.i.i
  %.377.i.i.i = fcmp ogt double %.11.i.i.i.i, 0.000000e+00
  %128 = fmul double %.11.i.i.i.i, 1.200000e-05
  %"$phi194.2.2.i.i.1.i" = select i1 %.377.i.i.i, double %128, double 1.200000e-05
  %129 = getelementptr i64, ptr %.327.i.i, i64 %.212.i.i.02275.i
  %.434.i.i.i = load i64, ptr %129, align 8, !noalias !33
  %.436.i.i.i = icmp eq i64 %.434.i.i.i, %.1382.i.sroa.0.02293.i
  %"$phi230.1.2.i.i.1.i" = select i1 %.436.i.i.i, double %"$phi194.2.2.i.i.1.i", double 0.000000e+00
  %130 = getelementptr i8, ptr %127, i64 %.idx2308.i
  store double %"$phi230.1.2.i.i.1.i", ptr %130, align 8, !noalias !33
  %exitcond2300.not.i = icmp eq i64 %arg.shape.1, %.283.i.i.i
  br i1 %exitcond2300.not.i, label %B262.i.i.i, label %B84.if.i.i.i

B428.if.i.i.i:                                    ; preds = %B324.i.i.i, %B428.if.i.i.i
  %.783.i.i.02277.i = phi i64 [ %.852.i.i.i, %B428.if.i.i.i ], [ 0, %B324.i.i.i ]
  %.852.i.i.i = add nsw i64 %.783.i.i.02277.i, 1
  %131 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02277.i
  %.906.i.i.i = load double, ptr %131, align 8, !noalias !33
  %132 = getelementptr double, ptr %131, i64 %.597.i.i.i
  %.939.i.i.i = load double, ptr %132, align 8, !noalias !33
  %.941.i.i.i = fmul double %.939.i.i.i, 5.000000e-01
  %.942.i.i.i = fadd double %.906.i.i.i, %.941.i.i.i
  %133 = getelementptr double, ptr %131, i64 %.944.i.i.i
  store double %.942.i.i.i, ptr %133, align 8, !noalias !33
  %exitcond2301.not.i = icmp eq i64 %arg.shape.1, %.852.i.i.i
  br i1 %exitcond2301.not.i, label %B524.i.i.i, label %B428.if.i.i.i

B780.if.i.i.i:                                    ; preds = %B524.i.i.1.i, %B1053.i.i.i
  %.1318.i.i.02282.i = phi i64 [ %.1387.i.i.i, %B1053.i.i.i ], [ 0, %B524.i.i.1.i ]
  %.1387.i.i.i = add nsw i64 %.1318.i.i.02282.i, 1
  %134 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1318.i.i.02282.i
  %.1445.i.i.i = load double, ptr %134, align 8, !noalias !33
  %135 = getelementptr i8, ptr %134, i64 %.1807.i.idx.i
  store double %.1445.i.i.i, ptr %135, align 8, !noalias !33
  %136 = getelementptr i8, ptr %134, i64 %.idx2310.i
  %.1513.i.i.i = load double, ptr %136, align 8, !noalias !33
  %137 = getelementptr i8, ptr %134, i64 %.1276.i.i.1.idx.i
  %.1548.i.i.i = load double, ptr %137, align 8, !noalias !33
  %.1594.i.i.i = fsub double %.1548.i.i.i, %.1548.i.i.i
  %.1595.i.i.i = fcmp oeq double %.1594.i.i.i, 0.000000e+00
  br i1 %.1595.i.i.i, label %B966.i.i.i, label %B1006.i.i.i

B960.i.i:                                         ; preds = %B1053.i.i.i, %B524.i.i.1.i, %B914.i.i, %B610.i.i
  %.2258.i.i = icmp slt i64 %.1382.i.sroa.0.02293.i, 0
  %.2259.i.i = select i1 %.2258.i.i, i64 %.486.i.i, i64 0
  %138 = getelementptr i64, ptr %.502.i.i, i64 %.1382.i.sroa.0.02293.i
  %.2273.i.i = getelementptr i64, ptr %138, i64 %.2259.i.i
  %.2274.i.i = load i64, ptr %.2273.i.i, align 8, !noalias !26
  %.2292.i.i = icmp slt i64 %.1382.i.sroa.0.02293.i, -1
  %.2293.i.i = select i1 %.2292.i.i, i64 %.486.i.i, i64 0
  %139 = getelementptr i8, ptr %138, i64 8
  %.2307.i.i = getelementptr i64, ptr %139, i64 %.2293.i.i
  %.2308.i.i = load i64, ptr %.2307.i.i, align 8, !noalias !26
  %.2345.i.i = sub i64 %.2308.i.i, %.2274.i.i
  %.2388.i2284.not.i = icmp slt i64 %.2345.i.i, 1
  br i1 %.2388.i2284.not.i, label %B474.i.loopexit.i, label %B1022.if.i.i

B1178.i.i:                                        ; preds = %B1022.if.i.i
  %.2656.i.i = add nsw i64 %.2461.i.i, %.2622.i.i
  %.2671.i.i = icmp slt i64 %.2656.i.i, 0
  %.2672.i.i = select i1 %.2671.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %140 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2656.i.i
  %.2686.i.i = getelementptr double, ptr %140, i64 %.2672.i.i
  store double %.2560.i..i, ptr %.2686.i.i, align 8, !noalias !26
  br label %B1253.i.i

B1224.i.i:                                        ; preds = %B1022.if.i.i
  %.2706.i.i = select i1 %.2445.i.i, i64 %.1014.i.i, i64 0
  %141 = getelementptr i64, ptr %.1030.i.i, i64 %.2332.i.02285.i
  %.2720.i.i = getelementptr i64, ptr %141, i64 %.2706.i.i
  %.2721.i.i = load i64, ptr %.2720.i.i, align 8, !noalias !26
  %.2738.i.i = icmp slt i64 %.2721.i.i, 0
  %.2739.i.i = select i1 %.2738.i.i, i64 %arg.linear.0.5.0, i64 0
  %142 = getelementptr double, ptr %arg.linear.0.4, i64 %.2721.i.i
  %.2753.i.i = getelementptr double, ptr %142, i64 %.2739.i.i
  store double %.2560.i..i, ptr %.2753.i.i, align 8, !noalias !26
  br label %B1253.i.i

B1253.i.i:                                        ; preds = %B1224.i.i, %B1178.i.i
  %.2388.i.i = icmp sgt i64 %.2335.i.02286.i, 1
  br i1 %.2388.i.i, label %B1022.if.i.i, label %B474.i.loopexit.i

B0.endif.i.i:                                     ; preds = %B0.else.endif.endif.endif.if.i.i, %B0.else.endif.endif.endif.i.i
  %.214.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.else.endif.endif.endif.if.i.i ], [ %.214.i.sroa.11.1.i, %B0.else.endif.endif.endif.i.i ]
  %.302.i.i = sub i64 %.214.i.sroa.11.0.i, %spec.select.i
  %.311.i.i8755 = tail call i64 @llvm.smax.i64(i64 %.302.i.i, i64 0)
  %.327.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select.i
  %.362.i.i = add nsw i64 %.154.i.i8751, %.187.i.i
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
  %.540.i.i = add i64 %.539.i.i, %.154.i.i8751
  %.541.i.i = add nsw i64 %.540.i.i, %.184.i.i8753
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
  %.711.i.i = shl nsw i64 %.184.i.i8753, 1
  %.712.i.i = add nsw i64 %.711.i.i, %.540.i.i
  %.759.i.i = icmp sge i64 %.597.i.i, %arg.linear.1.5.0
  br i1 %.759.i.i, label %B0.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.else.endif.endif.i.i, !prof !32

B0.endif.endif.else.endif.if.i.i:                 ; preds = %B0.endif.endif.i.i
  br label %B0.endif.endif.else.endif.endif.i.i

B0.endif.endif.else.endif.endif.i.i:              ; preds = %B0.endif.endif.else.endif.if.i.i, %B0.endif.endif.i.i
  %simplifycfg.merge4.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.i.i ]
  %143 = or i1 %.583.i.i, %.588.i.i
  %spec.select2251.i = select i1 %143, i64 %simplifycfg.merge4.i, i64 %.580.i.i, !prof !37
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
  %.889.i.i = mul nsw i64 %.184.i.i8753, 3
  %.890.i.i = add nsw i64 %.889.i.i, %.540.i.i
  %.937.i.i = icmp sge i64 %.768.i.i, %arg.linear.1.5.0
  br i1 %.937.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.i.i, !prof !32

B0.endif.endif.endif.else.endif.if.i.i:           ; preds = %B0.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.else.endif.endif.i.i:        ; preds = %B0.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.i.i
  %simplifycfg.merge6.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.i.i ]
  %144 = or i1 %.600.i.i, %.759.i.i
  %spec.select2252.i = select i1 %144, i64 %simplifycfg.merge6.i, i64 %.597.i.i, !prof !37
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
  %145 = or i1 %.771.i.i, %.937.i.i
  %spec.select2253.i = select i1 %145, i64 %simplifycfg.merge8.i, i64 %.768.i.i, !prof !37
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
  %146 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1104.i.02264.i
  %.1229.i.i = load double, ptr %146, align 8, !noalias !26
  %147 = getelementptr i8, ptr %146, i64 %.idx2305.i
  store double %.1229.i.i, ptr %147, align 8, !noalias !26
  %148 = getelementptr i8, ptr %146, i64 %.idx2306.i
  store double 0.000000e+00, ptr %148, align 8, !noalias !26
  %exitcond.not.i8756 = icmp eq i64 %arg.shape.1, %.1175.i.i
  br i1 %exitcond.not.i8756, label %B412.i.i, label %B330.if.i.i

B544.if.i.i:                                      ; preds = %B508.i.i, %B544.if.i.i
  %.1503.i.02268.i = phi i64 [ %.1565.i.i, %B544.if.i.i ], [ %storemerge2243.i, %B508.i.i ]
  %.1500.i.02267.i = phi i64 [ %.1569.i.i, %B544.if.i.i ], [ 0, %B508.i.i ]
  %.1565.i.i = add nsw i64 %.1503.i.02268.i, -1
  %.1569.i.i = add nsw i64 %.1500.i.02267.i, 1
  %149 = getelementptr i64, ptr %.327.i.i, i64 %.1500.i.02267.i
  %.1627.i.i = load i64, ptr %149, align 8, !noalias !26
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
  %150 = getelementptr i64, ptr %.681.i.i, i64 %.2332.i.02285.i
  %.2460.i.i = getelementptr i64, ptr %150, i64 %.2446.i.i
  %.2461.i.i = load i64, ptr %.2460.i.i, align 8, !noalias !26
  %.2462.i.i = add nsw i64 %.2461.i.i, %.1789.i.i
  %.2476.i.i = icmp slt i64 %.2462.i.i, 0
  %.2477.i.i = select i1 %.2476.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %151 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2462.i.i
  %.2491.i.i = getelementptr double, ptr %151, i64 %.2477.i.i
  %.2492.i.i = load double, ptr %.2491.i.i, align 8, !noalias !26
  %.2510.i.i = select i1 %.2445.i.i, i64 %.836.i.i, i64 0
  %152 = getelementptr i64, ptr %.852.i.i, i64 %.2332.i.02285.i
  %.2524.i.i = getelementptr i64, ptr %152, i64 %.2510.i.i
  %.2525.i.i = load i64, ptr %.2524.i.i, align 8, !noalias !26
  %.2526.i.i = add nsw i64 %.2525.i.i, %.597.i.i.i
  %.2540.i.i = icmp slt i64 %.2526.i.i, 0
  %.2541.i.i = select i1 %.2540.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %153 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2526.i.i
  %.2555.i.i = getelementptr double, ptr %153, i64 %.2541.i.i
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
  %154 = add i64 %.664.i, %.634.i
  br label %B226.if.i

B396.i:                                           ; preds = %B342.if.i, %B226.if.i
  %.1055.i = mul i64 %.697.02298.i, %.743.sroa.0.02242.i
  %.1071.i = icmp slt i64 %.1055.i, 0
  %.1072.i = select i1 %.1071.i, i64 %.251.i, i64 0
  %155 = getelementptr double, ptr %.267.i, i64 %.1055.i
  %.1086.i = getelementptr double, ptr %155, i64 %.1072.i
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
  %156 = getelementptr i64, ptr %.437.i, i64 %.59.0509.i.i
  store i64 %p.2.1.lcssa.i.i, ptr %156, align 8, !noalias !39
  %.547.i.i = add nsw i64 %p.2.1.lcssa.i.i, %.161.i.i
  %.561.i.i = icmp slt i64 %.547.i.i, 0
  %.562.i.i = select i1 %.561.i.i, i64 %.251.i, i64 0
  %157 = getelementptr double, ptr %.267.i, i64 %.547.i.i
  %.576.i.i = getelementptr double, ptr %157, i64 %.562.i.i
  %.577.i.i = load double, ptr %.576.i.i, align 8, !noalias !39
  %.610.i.i = load double, ptr %159, align 8, !noalias !39
  store double %.577.i.i, ptr %159, align 8, !noalias !39
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
  %.11.i.i.i8750 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.165.i.i, i64 %arg.shape.1)
  %.200.i.i = add i64 %.199.i.i, %.164.i.i
  %.11.i492.i.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.200.i.i, i64 %arg.shape.1)
  %158 = getelementptr double, ptr %.267.i, i64 %.161.i.i
  %159 = getelementptr double, ptr %158, i64 %.59.0509.i.i
  %.319.i.i = sub i64 %.11.i.i.i8750, %.131.i.i
  %storemerge488.i.i = tail call i64 @llvm.smax.i64(i64 %.319.i.i, i64 0)
  %.362493.not.i.i = icmp slt i64 %.319.i.i, 1
  br i1 %.362493.not.i.i, label %B348.i.i, label %B234.if.preheader.i.i

B234.if.preheader.i.i:                            ; preds = %B36.if.i.i
  %.271.i.i = load double, ptr %159, align 8, !noalias !39
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
  %160 = getelementptr double, ptr %.267.i, i64 %.415.i.i
  %.444.i.i = getelementptr double, ptr %160, i64 %.430.i.i
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
  %161 = getelementptr double, ptr %.267.i, i64 %.798.i.i
  %.827.i2256.i = getelementptr double, ptr %161, i64 %.813.i.i
  %.828.i.i = load double, ptr %.827.i2256.i, align 8, !noalias !39
  %.861.i.i = load double, ptr %159, align 8, !noalias !39
  %.865.i.i = fdiv double %.828.i.i, %.861.i.i
  store double %.865.i.i, ptr %.827.i2256.i, align 8, !noalias !39
  %.759.i2257.i = icmp sgt i64 %.706.0500.i.i, 1
  br i1 %.759.i2257.i, label %B466.if.i.i, label %B528.i.i

B566.if.i.i:                                      ; preds = %B528.i.i, %B790.i.i
  %.932.0506.i.i = phi i64 [ %.994.i.i, %B790.i.i ], [ %.942.i.i, %B528.i.i ]
  %.929.0505.i.i = phi i64 [ %.998.i.i, %B790.i.i ], [ %.131.i.i, %B528.i.i ]
  %.994.i.i = add nsw i64 %.932.0506.i.i, -1
  %.998.i.i = add i64 %.929.0505.i.i, 1
  %162 = mul nsw i64 %.929.0505.i.i, %arg.shape.1
  %.1030.i2258.i = add nsw i64 %162, %p.2.1.lcssa.i.i
  %.1044.i.i = icmp slt i64 %.1030.i2258.i, 0
  %.1045.i.i = select i1 %.1044.i.i, i64 %.251.i, i64 0
  %163 = getelementptr double, ptr %.267.i, i64 %.1030.i2258.i
  %.1059.i.i = getelementptr double, ptr %163, i64 %.1045.i.i
  %.1060.i.i = load double, ptr %.1059.i.i, align 8, !noalias !39
  %.1068.i.i = add nsw i64 %162, %.59.0509.i.i
  %.1082.i.i = icmp slt i64 %.1068.i.i, 0
  %.1083.i.i = select i1 %.1082.i.i, i64 %.251.i, i64 0
  %164 = getelementptr double, ptr %.267.i, i64 %.1068.i.i
  %.1097.i.i = getelementptr double, ptr %164, i64 %.1083.i.i
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
  %.1296.i.i = add nsw i64 %.1199.0502.i.i, %162
  %.1310.i.i = icmp slt i64 %.1296.i.i, 0
  %.1311.i2261.i = select i1 %.1310.i.i, i64 %.251.i, i64 0
  %165 = getelementptr double, ptr %.267.i, i64 %.1296.i.i
  %.1325.i.i = getelementptr double, ptr %165, i64 %.1311.i2261.i
  %.1326.i.i = load double, ptr %.1325.i.i, align 8, !noalias !39
  %.1328.i.i = add nsw i64 %.1199.0502.i.i, %.161.i.i
  %.1342.i.i = icmp slt i64 %.1328.i.i, 0
  %.1343.i.i = select i1 %.1342.i.i, i64 %.251.i, i64 0
  %166 = getelementptr double, ptr %.267.i, i64 %.1328.i.i
  %.1357.i.i = getelementptr double, ptr %166, i64 %.1343.i.i
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
  %.798.i8747 = sub i64 %.697.02298.i, %154
  %.11.i.i8748 = tail call i64 @llvm.smax.i64(i64 %.798.i8747, i64 0)
  %.830.i = add i64 %.829.i, %.697.02298.i
  %.11.i2262.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.830.i, i64 %arg.shape.1)
  %.896.i = sub i64 %.11.i2262.i, %.11.i.i8748
  %.9392294.not.i = icmp slt i64 %.896.i, 1
  br i1 %.9392294.not.i, label %B396.i, label %B342.if.lr.ph.i

B342.if.lr.ph.i:                                  ; preds = %B226.if.i
  %.979.i8749 = mul nsw i64 %.697.02298.i, %arg.shape.1
  br label %B342.if.i

B342.if.i:                                        ; preds = %B342.if.i, %B342.if.lr.ph.i
  %.886.02296.i = phi i64 [ %.896.i, %B342.if.lr.ph.i ], [ %.948.i, %B342.if.i ]
  %.883.02295.i = phi i64 [ %.11.i.i8748, %B342.if.lr.ph.i ], [ %.952.i, %B342.if.i ]
  %.948.i = add nsw i64 %.886.02296.i, -1
  %.952.i = add i64 %.883.02295.i, 1
  %.980.i = add nsw i64 %.883.02295.i, %.979.i8749
  %.994.i = icmp slt i64 %.980.i, 0
  %.995.i = select i1 %.994.i, i64 %arg.linear.0.5.0, i64 0
  %167 = getelementptr double, ptr %arg.linear.0.4, i64 %.980.i
  %.1009.i = getelementptr double, ptr %167, i64 %.995.i
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !38
  %.1011.i = fneg double %.1010.i
  %.1030.i = select i1 %.994.i, i64 %.251.i, i64 0
  %168 = getelementptr double, ptr %.267.i, i64 %.980.i
  %.1044.i = getelementptr double, ptr %168, i64 %.1030.i
  store double %.1011.i, ptr %.1044.i, align 8, !noalias !38
  %.939.i = icmp sgt i64 %.886.02296.i, 1
  br i1 %.939.i, label %B342.if.i, label %B396.i

B1348:                                            ; preds = %B34.loopexit.i.i, %B164.i, %B1304
  br i1 %.20279077.not, label %B1606, label %B1380.if

B1568:                                            ; preds = %B1380.if
  br i1 %.88.not.i, label %B0.else.endif.endif.endif.if.i8759, label %B0.else.endif.if.i8758, !prof !25

B322.i:                                           ; preds = %B192.if.i
  %.853.i = load i64, ptr %arg.linear.1.4, align 8, !noalias !42
  %.883.i = load i64, ptr %.882.i, align 8, !noalias !42
  %.339.i.i = add i64 %.853.i, 1
  br label %B34.if.i.i8765

B34.i.loopexit.i:                                 ; preds = %B198.if.i.i, %B34.if.i.i8765
  %exitcond766.not.i = icmp eq i64 %arg.shape.1, %.144.i.i
  br i1 %exitcond766.not.i, label %B314.if.i.lr.ph.i, label %B34.if.i.i8765

B314.if.i.lr.ph.i:                                ; preds = %B34.i.loopexit.i
  %169 = add i64 %.883.i, %.853.i
  br label %B314.if.i.i

B314.i.loopexit.i:                                ; preds = %B474.if.i.i, %B314.if.i.i
  %.683.i.i = icmp sgt i64 %.627.i.0762.in.i, 1
  br i1 %.683.i.i, label %B314.if.i.i, label %B434.if.lr.ph.i

B434.if.lr.ph.i:                                  ; preds = %B314.i.loopexit.i
  %.1110.i = mul nsw i64 %.2040, %arg.shape.1
  br label %B434.if.i

B34.if.i.i8765:                                   ; preds = %B34.i.loopexit.i, %B322.i
  %.73.i.0754.i = phi i64 [ 0, %B322.i ], [ %.144.i.i, %B34.i.loopexit.i ]
  %.144.i.i = add nsw i64 %.73.i.0754.i, 1
  %170 = getelementptr i64, ptr %.358.i8762, i64 %.73.i.0754.i
  %.202.i.i = load i64, ptr %170, align 8, !noalias !45
  %.204.i.i = add nsw i64 %.202.i.i, %.887.i
  %.218.i.i = icmp slt i64 %.204.i.i, 0
  %.219.i.i = select i1 %.218.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %171 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.204.i.i
  %.233.i.i = getelementptr double, ptr %171, i64 %.219.i.i
  %.234.i.i8766 = load double, ptr %.233.i.i, align 8, !noalias !45
  %gep9076 = getelementptr double, ptr %invariant.gep9075, i64 %.73.i.0754.i
  %.270.i.i = load double, ptr %gep9076, align 8, !noalias !45
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !45
  store double %.234.i.i8766, ptr %gep9076, align 8, !noalias !45
  %.340.i.i = add i64 %.339.i.i, %.73.i.0754.i
  %.11.i.i.i8767 = tail call i64 @llvm.smin.i64(i64 %.340.i.i, i64 %arg.shape.1)
  %.406.i.i = sub i64 %.11.i.i.i8767, %.144.i.i
  %.449.i750.not.i = icmp slt i64 %.406.i.i, 1
  br i1 %.449.i750.not.i, label %B34.i.loopexit.i, label %B198.if.i.lr.ph.i

B198.if.i.lr.ph.i:                                ; preds = %B34.if.i.i8765
  %.521.i.i = mul nsw i64 %.73.i.0754.i, %arg.shape.1
  br label %B198.if.i.i

B198.if.i.i:                                      ; preds = %B198.if.i.i, %B198.if.i.lr.ph.i
  %.396.i.0752.i = phi i64 [ %.406.i.i, %B198.if.i.lr.ph.i ], [ %.458.i.i, %B198.if.i.i ]
  %.393.i.0751.i = phi i64 [ %.144.i.i, %B198.if.i.lr.ph.i ], [ %.462.i.i, %B198.if.i.i ]
  %.458.i.i = add nsw i64 %.396.i.0752.i, -1
  %.462.i.i = add i64 %.393.i.0751.i, 1
  %.488.i.i = add nsw i64 %.393.i.0751.i, %.887.i
  %.502.i.i8768 = icmp slt i64 %.488.i.i, 0
  %.503.i.i = select i1 %.502.i.i8768, i64 %arg.batch.5.0.5.0, i64 0
  %172 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.488.i.i
  %.517.i.i = getelementptr double, ptr %172, i64 %.503.i.i
  %.518.i.i = load double, ptr %.517.i.i, align 8, !noalias !45
  %.522.i.i = add nsw i64 %.393.i.0751.i, %.521.i.i
  %.536.i.i = icmp slt i64 %.522.i.i, 0
  %.537.i.i = select i1 %.536.i.i, i64 %.165.i, i64 0
  %173 = getelementptr double, ptr %.181.i, i64 %.522.i.i
  %.551.i.i = getelementptr double, ptr %173, i64 %.537.i.i
  %.552.i.i = load double, ptr %.551.i.i, align 8, !noalias !45
  %.554.i.i = fmul double %.234.i.i8766, %.552.i.i
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
  %174 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.726.i.i
  %.755.i.i = getelementptr double, ptr %174, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i, align 8, !noalias !45
  %.759.i.i8769 = mul nsw i64 %.627.i.0762.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i8769, %.627.i.0762.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %.165.i, i64 0
  %175 = getelementptr double, ptr %.181.i, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %175, i64 %.776.i.i
  %.791.i.i = load double, ptr %.790.i.i, align 8, !noalias !45
  %.795.i.i = fdiv double %.756.i.i, %.791.i.i
  store double %.795.i.i, ptr %.755.i.i, align 8, !noalias !45
  %.866.i.i = sub i64 %.627.i.0762.i, %169
  %.11.i4.i.i = tail call i64 @llvm.smax.i64(i64 %.866.i.i, i64 0)
  %.932.i.i = sub i64 %.627.i.0762.i, %.11.i4.i.i
  %.975.i756.not.i = icmp slt i64 %.932.i.i, 1
  br i1 %.975.i756.not.i, label %B314.i.loopexit.i, label %B474.if.i.i

B474.if.i.i:                                      ; preds = %B314.if.i.i, %B474.if.i.i
  %.922.i.0758.i = phi i64 [ %.984.i.i, %B474.if.i.i ], [ %.932.i.i, %B314.if.i.i ]
  %.919.i.0757.i = phi i64 [ %.988.i.i, %B474.if.i.i ], [ %.11.i4.i.i, %B314.if.i.i ]
  %.984.i.i = add nsw i64 %.922.i.0758.i, -1
  %.988.i.i = add i64 %.919.i.0757.i, 1
  %.1014.i.i8770 = add nsw i64 %.919.i.0757.i, %.887.i
  %.1028.i.i = icmp slt i64 %.1014.i.i8770, 0
  %.1029.i.i = select i1 %.1028.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %176 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1014.i.i8770
  %.1043.i.i = getelementptr double, ptr %176, i64 %.1029.i.i
  %.1044.i.i8771 = load double, ptr %.1043.i.i, align 8, !noalias !45
  %.1048.i.i = add nsw i64 %.919.i.0757.i, %.759.i.i8769
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %.165.i, i64 0
  %177 = getelementptr double, ptr %.181.i, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %177, i64 %.1063.i.i
  %.1078.i.i = load double, ptr %.1077.i.i, align 8, !noalias !45
  %.1080.i.i = fmul double %.795.i.i, %.1078.i.i
  %.1081.i.i = fsub double %.1044.i.i8771, %.1080.i.i
  store double %.1081.i.i, ptr %.1043.i.i, align 8, !noalias !45
  %.975.i.i = icmp sgt i64 %.922.i.0758.i, 1
  br i1 %.975.i.i, label %B474.if.i.i, label %B314.i.loopexit.i

B0.else.endif.if.i8758:                           ; preds = %B1568
  br label %B0.else.endif.endif.endif.if.i8759

B0.else.endif.endif.endif.if.i8759:               ; preds = %B0.else.endif.if.i8758, %B1568
  %.68.sroa.0.3.i = phi i64 [ %arg.linear.0.5.0, %B0.else.endif.if.i8758 ], [ %.42.i, %B1568 ]
  %.156.i = sub i64 %arg.linear.0.5.0, %.68.sroa.0.3.i
  %.165.i = tail call i64 @llvm.smax.i64(i64 %.156.i, i64 0)
  %.181.i = getelementptr double, ptr %arg.linear.0.4, i64 %.68.sroa.0.3.i
  br i1 %.265.i, label %B0.endif.else.endif.if.i8773, label %B0.endif.else.endif.endif.i8760, !prof !32

B0.endif.else.endif.if.i8773:                     ; preds = %B0.else.endif.endif.endif.if.i8759
  br label %B0.endif.else.endif.endif.i8760

B0.endif.else.endif.endif.i8760:                  ; preds = %B0.endif.else.endif.if.i8773, %B0.else.endif.endif.endif.if.i8759
  %.245.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.if.i8773 ], [ 5, %B0.else.endif.endif.endif.if.i8759 ]
  %.358.i8762 = getelementptr i64, ptr %arg.linear.1.4, i64 %.245.sroa.0.3.i
  br i1 %.277.i, label %B0.endif.endif.else.if.i, label %B0.endif.endif.else.endif.i, !prof !32

B192.if.lr.ph.i:                                  ; preds = %B0.endif.endif.else.endif.endif.endif.i
  %.689.i = mul nsw i64 %.2040, %arg.shape.1
  br label %B192.if.i

B0.endif.endif.else.if.i:                         ; preds = %B0.endif.else.endif.endif.i8760
  br label %B0.endif.endif.else.endif.i

B0.endif.endif.else.endif.i:                      ; preds = %B0.endif.endif.else.if.i, %B0.endif.else.endif.endif.i8760
  %.418.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.else.if.i ], [ %.274.i, %B0.endif.else.endif.endif.i8760 ]
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
  %178 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.690.i
  %.719.i = getelementptr double, ptr %178, i64 %.705.i
  %.720.i = load double, ptr %.719.i, align 8, !noalias !42
  %gep9074 = getelementptr double, ptr %invariant.gep9073, i64 %.590.0748.i
  %.753.i = load double, ptr %gep9074, align 8, !noalias !42
  %.754.i = fadd double %.720.i, %.753.i
  %179 = getelementptr i64, ptr %.531.i, i64 %.590.0748.i
  %.786.i = load i64, ptr %179, align 8, !noalias !42
  %.787.i = add nsw i64 %.786.i, %.756.i
  %.801.i = icmp slt i64 %.787.i, 0
  %.802.i = select i1 %.801.i, i64 %arg.batch.5.0.5.0, i64 0
  %180 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.787.i
  %.816.i = getelementptr double, ptr %180, i64 %.802.i
  store double %.754.i, ptr %.816.i, align 8, !noalias !42
  %exitcond.not.i8764 = icmp eq i64 %arg.shape.1, %.661.i
  br i1 %exitcond.not.i8764, label %B322.i, label %B192.if.i

B434.if.i:                                        ; preds = %B434.if.i, %B434.if.lr.ph.i
  %.950.0764.i = phi i64 [ 0, %B434.if.lr.ph.i ], [ %.1019.i, %B434.if.i ]
  %.1019.i = add nsw i64 %.950.0764.i, 1
  %181 = getelementptr i64, ptr %.531.i, i64 %.950.0764.i
  %.1075.i = load i64, ptr %181, align 8, !noalias !42
  %.1076.i = add nsw i64 %.1075.i, %.887.i
  %.1090.i = icmp slt i64 %.1076.i, 0
  %.1091.i = select i1 %.1090.i, i64 %arg.batch.5.0.5.0, i64 0
  %182 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1076.i
  %.1105.i = getelementptr double, ptr %182, i64 %.1091.i
  %.1106.i = load double, ptr %.1105.i, align 8, !noalias !42
  %.1111.i = add nsw i64 %.950.0764.i, %.1110.i
  %.1125.i = icmp slt i64 %.1111.i, 0
  %.1126.i = select i1 %.1125.i, i64 %arg.batch.5.0.5.0, i64 0
  %183 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1111.i
  %.1140.i8772 = getelementptr double, ptr %183, i64 %.1126.i
  store double %.1106.i, ptr %.1140.i8772, align 8, !noalias !42
  %exitcond767.not.i = icmp eq i64 %arg.shape.1, %.1019.i
  br i1 %exitcond767.not.i, label %B1604, label %B434.if.i

B1604:                                            ; preds = %B434.if.i, %B0.endif.endif.else.endif.endif.endif.i, %B1380.if
  %exitcond9200.not = icmp eq i64 %.1971.09078, %storemerge8658
  br i1 %exitcond9200.not, label %B1606, label %B1380.if

B1606:                                            ; preds = %B1604, %B1348
  %.2304 = load i64, ptr %.2303, align 8
  %.2349 = inttoptr i64 %.2304 to ptr
  tail call void %.2349(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %brmerge8721 = select i1 %.983, i1 true, i1 %.541
  %or.cond8722 = select i1 %brmerge8721, i1 true, i1 %.2380
  %spec.select8738 = select i1 %or.cond8722, i1 true, i1 %.2385
  br i1 %.603, label %B1838, label %B1748.if

B1756:                                            ; preds = %B1748.if
  %184 = getelementptr double, ptr %31, i64 %.2425.09081
  %.2584 = load double, ptr %184, align 8
  %.2585 = fcmp ogt double %.2584, 5.000000e-01
  br label %B1792

B1792:                                            ; preds = %B1756, %B1748.if
  %"$phi1792.1.2.2" = phi i1 [ true, %B1748.if ], [ %.2585, %B1756 ]
  br i1 %looked.4.29084, label %B1834, label %B1798

B1798:                                            ; preds = %B1792
  %185 = getelementptr double, ptr %32, i64 %.2425.09081
  %.2659 = load double, ptr %185, align 8
  %.2660 = fcmp ogt double %.2659, 5.000000e-01
  br label %B1834

B1834:                                            ; preds = %B1798, %B1792
  %"$phi1834.1.2.2" = phi i1 [ true, %B1792 ], [ %.2660, %B1798 ]
  %.2481 = icmp sgt i64 %.2428.09082, 1
  br i1 %.2481, label %B1748.if, label %B1838

B1838:                                            ; preds = %B1834, %B1606
  %good.2.1.lcssa = phi i1 [ false, %B1606 ], [ %"$phi1792.1.2.2", %B1834 ]
  %looked.4.2.lcssa = phi i1 [ %spec.select8738, %B1606 ], [ %"$phi1834.1.2.2", %B1834 ]
  %looked.4.2.lcssa.not9205 = xor i1 %looked.4.2.lcssa, true
  %brmerge9206 = or i1 %.603, %looked.4.2.lcssa.not9205
  br i1 %brmerge9206, label %B2416, label %B80.if.i

B1908.preheader:                                  ; preds = %B502.i
  br i1 %.603, label %B2416, label %B1908.if

B126.i:                                           ; preds = %B80.if.i
  %.318.i590 = getelementptr double, ptr %33, i64 %.105.i437.09088
  %.319.i591 = load double, ptr %.318.i590, align 8, !noalias !49
  %.5.i.i = fptosi double %.319.i591 to i64
  %.397.i = getelementptr double, ptr %34, i64 %.105.i437.09088
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
  %.923.i = getelementptr double, ptr %35, i64 %.105.i437.09088
  %.924.i1016 = load double, ptr %.923.i, align 8, !noalias !49
  %.926.i = sitofp i64 %.698.i861 to double
  %.927.i = fsub double %.924.i1016, %.926.i
  store double %.927.i, ptr %.923.i, align 8, !noalias !49
  br label %B502.i

B502.i:                                           ; preds = %B126.i, %B80.if.i
  %.163.i494 = icmp sgt i64 %.108.i438.09089, 1
  br i1 %.163.i494, label %B80.if.i, label %B1908.preheader

B80.if.i:                                         ; preds = %B1838, %B502.i
  %.108.i438.09089 = phi i64 [ %.172.i1046, %B502.i ], [ %storemerge, %B1838 ]
  %.105.i437.09088 = phi i64 [ %.176.i, %B502.i ], [ 0, %B1838 ]
  %.172.i1046 = add nsw i64 %.108.i438.09089, -1
  %.176.i = add nsw i64 %.105.i437.09088, 1
  %186 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i437.09088
  %.258.i545 = load i64, ptr %186, align 8, !noalias !49
  %.263.i = icmp sgt i64 %.258.i545, -1
  br i1 %.263.i, label %B126.i, label %B502.i

B2008:                                            ; preds = %B1908.if
  %.3114 = getelementptr double, ptr %38, i64 %.2780.09091
  %.3115 = load double, ptr %.3114, align 8
  %.3116 = fcmp ogt double %.3115, 5.000000e-01
  br i1 %.3116, label %B2046, label %B2146

B2046:                                            ; preds = %B2008
  %.5.i = fptosi double %.3115 to i64
  %187 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2780.09091
  %.84.i1916 = load i64, ptr %187, align 8, !noalias !53
  %.89.i1919 = icmp sgt i64 %.84.i1916, -1
  br i1 %.89.i1919, label %B46.i, label %B2146

B2146:                                            ; preds = %B2008, %B46.i, %B2046, %B80.i1953
  %.3302 = getelementptr double, ptr %39, i64 %.2780.09091
  %.3303 = load double, ptr %.3302, align 8
  %.3304 = fcmp ogt double %.3303, 5.000000e-01
  br i1 %.3304, label %B2184, label %B2414

B2184:                                            ; preds = %B2146
  %spec.select = select i1 %within.3.29093, i1 true, i1 %.2380
  %.3380 = mul i64 %.2941, %arg.batch.3.3.5.1
  %.3384 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.3380
  %.3385 = load i64, ptr %.3384, align 8
  %.3396.0 = and i64 %.3385, 127
  %.3426 = icmp eq i64 %.3396.0, 0
  br i1 %.3426, label %B2292, label %B2254

B2254:                                            ; preds = %B2184
  %.3487 = getelementptr double, ptr %40, i64 %.2780.09091
  %.3488 = load double, ptr %.3487, align 8
  %.3490 = fcmp ogt double %.3488, 0.000000e+00
  br i1 %.3490, label %B2292, label %B2322

B2292:                                            ; preds = %B2184, %B2254
  store double 1.000000e+00, ptr %.3056, align 8
  br label %B2322

B2322:                                            ; preds = %B2292, %B2254
  %doubted.5.5 = phi i1 [ true, %B2292 ], [ %doubted.3.29094, %B2254 ]
  %.3573 = icmp slt i64 %.2996, %arg.batch.2.5.0
  br i1 %.3573, label %B2360, label %B2414

B2360:                                            ; preds = %B2322
  %.3597 = icmp slt i64 %.2996, 0
  %.3598 = select i1 %.3597, i64 %arg.batch.2.5.0, i64 0
  %188 = getelementptr double, ptr %arg.batch.2.4, i64 %.2996
  %.3612 = getelementptr double, ptr %188, i64 %.3598
  %.3613 = load double, ptr %.3612, align 8
  %.3671 = getelementptr double, ptr %41, i64 %.2780.09091
  %.3672 = load double, ptr %.3671, align 8
  %.3673 = fcmp olt double %.3613, %.3672
  br i1 %.3673, label %B2410, label %B2414

B2410:                                            ; preds = %B2360
  br label %B2414

B2414:                                            ; preds = %B1908.if, %B2410, %B2360, %B2322, %B2146
  %within.4.3 = phi i1 [ true, %B2410 ], [ %spec.select, %B2360 ], [ %spec.select, %B2322 ], [ %within.3.29093, %B2146 ], [ %within.3.29093, %B1908.if ]
  %doubted.4.3 = phi i1 [ %doubted.5.5, %B2410 ], [ %doubted.5.5, %B2360 ], [ %doubted.5.5, %B2322 ], [ %doubted.3.29094, %B2146 ], [ %doubted.3.29094, %B1908.if ]
  %.2842 = icmp sgt i64 %.2783.09092, 1
  br i1 %.2842, label %B1908.if, label %B2416.loopexit

B2416.loopexit:                                   ; preds = %B2414
  %189 = xor i1 %doubted.4.3, true
  %190 = select i1 %189, i1 true, i1 %.545
  br label %B2416

B2416:                                            ; preds = %B1838, %B2416.loopexit, %B1908.preheader
  %within.5.1 = phi i1 [ false, %B1838 ], [ false, %B1908.preheader ], [ %within.4.3, %B2416.loopexit ]
  %doubted.2.1 = phi i1 [ true, %B1838 ], [ true, %B1908.preheader ], [ %190, %B2416.loopexit ]
  %brmerge8723.not = select i1 %good.2.1.lcssa, i1 %.543.not, i1 false
  br i1 %brmerge8723.not, label %B2424, label %B2540

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
  %191 = select i1 %.2385, i1 %good.2.1.lcssa, i1 false
  br i1 %191, label %B2636, label %B2758

B2636:                                            ; preds = %B2616
  %.3931 = load i64, ptr %.3930, align 8
  %.3978 = inttoptr i64 %.3931 to ptr
  tail call void %.3978(ptr %.502, ptr %.3952, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.603, label %B2758, label %B38.if.i

B104.i:                                           ; preds = %B38.if.i
  %.349.i2243 = getelementptr double, ptr %43, i64 %.78.i2024.09098
  %.350.i2244 = load double, ptr %.349.i2243, align 8, !noalias !56
  %.351.i2245 = fcmp ogt double %.350.i2244, 5.000000e-01
  br i1 %.351.i2245, label %B34.i.i, label %B304.i

B34.i.i:                                          ; preds = %B104.i, %B36.i.i
  %.48.i.i1984.0 = phi i64 [ %.119.i.i2550, %B36.i.i ], [ 0, %B104.i ]
  %exitcond9201.not = icmp eq i64 %.48.i.i1984.0, %arg.shape.6
  br i1 %exitcond9201.not, label %B142.endif.i, label %B36.i.i

B36.i.i:                                          ; preds = %B34.i.i
  %.119.i.i2550 = add i64 %.48.i.i1984.0, 1
  %.149.i.i2517 = add nsw i64 %.48.i.i1984.0, %arg.shape.6
  %.151.i.i2519 = mul nsw i64 %.149.i.i2517, %arg.shape.0
  %.153.i.i2521 = add nsw i64 %.151.i.i2519, %.78.i2024.09098
  %.167.i.i = icmp slt i64 %.153.i.i2521, 0
  %.168.i.i2529 = select i1 %.167.i.i, i64 %arg.batch.5.4.5.0, i64 0
  %192 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i.i2521
  %.182.i.i = getelementptr double, ptr %192, i64 %.168.i.i2529
  %.183.i.i = load double, ptr %.182.i.i, align 8, !noalias !60
  %.184.i.i = fcmp ogt double %.183.i.i, 5.000000e-01
  br i1 %.184.i.i, label %B142.endif.i, label %B34.i.i

B190.i:                                           ; preds = %B142.endif.i
  store double 1.000000e+00, ptr %.234.i2148, align 8, !noalias !56
  %.503.i2412 = getelementptr double, ptr %44, i64 %.78.i2024.09098
  store double 0.000000e+00, ptr %.503.i2412, align 8, !noalias !56
  %.558.i2459 = getelementptr double, ptr %45, i64 %.78.i2024.09098
  store double 1.000000e+00, ptr %.558.i2459, align 8, !noalias !56
  %.616.i2506 = getelementptr i64, ptr %46, i64 %.78.i2024.09098
  store i64 %.363.i2035.0, ptr %.616.i2506, align 8, !noalias !56
  br label %B304.i

B304.i:                                           ; preds = %B142.endif.i, %B190.i, %B104.i, %B38.if.i
  %some.3.i.1 = phi i1 [ true, %B190.i ], [ %some.2.i.09100, %B142.endif.i ], [ %some.2.i.09100, %B104.i ], [ %some.2.i.09100, %B38.if.i ]
  %.136.i2080 = icmp sgt i64 %.81.i2025.09099, 1
  br i1 %.136.i2080, label %B38.if.i, label %B2758

B38.if.i:                                         ; preds = %B2636, %B304.i
  %some.2.i.09100 = phi i1 [ %some.3.i.1, %B304.i ], [ false, %B2636 ]
  %.81.i2025.09099 = phi i64 [ %.145.i2560, %B304.i ], [ %storemerge, %B2636 ]
  %.78.i2024.09098 = phi i64 [ %.149.i2563, %B304.i ], [ 0, %B2636 ]
  %.145.i2560 = add nsw i64 %.81.i2025.09099, -1
  %.149.i2563 = add nsw i64 %.78.i2024.09098, 1
  %.234.i2148 = getelementptr double, ptr %42, i64 %.78.i2024.09098
  store double 0.000000e+00, ptr %.234.i2148, align 8, !noalias !56
  %.289.i2192 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.78.i2024.09098
  %.290.i2193 = load i64, ptr %.289.i2192, align 8, !noalias !56
  %.291.i2194 = icmp sgt i64 %.290.i2193, -1
  br i1 %.291.i2194, label %B104.i, label %B304.i

B142.endif.i:                                     ; preds = %B36.i.i, %B34.i.i
  %.363.i2035.0 = phi i64 [ %.48.i.i1984.0, %B36.i.i ], [ -1, %B34.i.i ]
  %.393.i2321 = icmp sgt i64 %.363.i2035.0, -1
  br i1 %.393.i2321, label %B190.i, label %B304.i

B2758:                                            ; preds = %B304.i, %B2636, %B2616
  %beyond.2.1 = phi i1 [ false, %B2616 ], [ false, %B2636 ], [ %some.3.i.1, %B304.i ]
  %brmerge8727 = select i1 %within.5.1, i1 true, i1 %beyond.2.1
  br i1 %brmerge8727, label %B2768, label %B3290

B2768:                                            ; preds = %B2758
  br i1 %.545, label %B3184.critedge, label %B2816.if

B140.i:                                           ; preds = %B64.if.i3580
  %.409.i2908 = getelementptr double, ptr %48, i64 %.138.i2676.09106
  %.410.i = load double, ptr %.409.i2908, align 8, !noalias !64
  %.411.i2909 = fcmp uge double %.410.i, 5.000000e-01
  %.424.i2917.not = icmp slt i64 %.346.i2857, %arg.batch.2.5.0
  %or.cond8728 = select i1 %.411.i2909, i1 %.424.i2917.not, i1 false
  br i1 %or.cond8728, label %B216.i, label %B479.i

B216.i:                                           ; preds = %B140.i
  %.440.i2928 = icmp slt i64 %.346.i2857, 0
  %.441.i2929 = select i1 %.440.i2928, i64 %arg.batch.2.5.0, i64 0
  %193 = getelementptr double, ptr %arg.batch.2.4, i64 %.346.i2857
  %.455.i2943 = getelementptr double, ptr %193, i64 %.441.i2929
  %.456.i2944 = load double, ptr %.455.i2943, align 8, !noalias !64
  %.510.i2991 = getelementptr double, ptr %49, i64 %.138.i2676.09106
  %.511.i2992 = load double, ptr %.510.i2991, align 8, !noalias !64
  %.512.i2993 = fcmp ult double %.456.i2944, %.511.i2992
  br i1 %.512.i2993, label %B268.i2994, label %B479.i

B268.i2994:                                       ; preds = %B216.i
  %.574.i3042 = getelementptr double, ptr %50, i64 %.138.i2676.09106
  %.575.i3043 = load double, ptr %.574.i3042, align 8, !noalias !64
  %.576.i3044 = fcmp ogt double %.575.i3043, 1.000000e+00
  br i1 %.576.i3044, label %B306.i3047, label %B479.i

B306.i3047:                                       ; preds = %B268.i2994
  %.632.i = getelementptr double, ptr %51, i64 %.138.i2676.09106
  %.633.i3095 = load double, ptr %.632.i, align 8, !noalias !64
  store double 0.000000e+00, ptr %.409.i2908, align 8, !noalias !68
  %.161.i.i3254 = getelementptr double, ptr %52, i64 %.138.i2676.09106
  store double 0.000000e+00, ptr %.161.i.i3254, align 8, !noalias !68
  %.214.i.i3286 = getelementptr double, ptr %53, i64 %.138.i2676.09106
  store double %.633.i3095, ptr %.214.i.i3286, align 8, !noalias !68
  %.268.i.i3308 = load i64, ptr %.290.i2808, align 8, !noalias !68
  %.294.i.i3318 = icmp slt i64 %.268.i.i3308, 0
  %.295.i.i = select i1 %.294.i.i3318, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i.i = add i64 %.295.i.i, %.268.i.i3308
  %.316.i.i3330 = mul i64 %.296.i.i, %arg.batch.3.3.5.1
  %.320.i.i3331 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i.i3330
  %.321.i.i3332 = load i64, ptr %.320.i.i3331, align 8, !noalias !68
  %.322.i.i = add nsw i64 %.321.i.i3332, -1
  store i64 %.322.i.i, ptr %.320.i.i3331, align 8, !noalias !68
  %.426.i.i3364 = load i64, ptr %.290.i2808, align 8, !noalias !68
  %.452.i.i = icmp slt i64 %.426.i.i3364, 0
  %.453.i.i = select i1 %.452.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i = add i64 %.453.i.i, %.426.i.i3364
  %.474.i.i = mul i64 %.454.i.i, %arg.batch.3.3.5.1
  %194 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i
  %.478.i.i = getelementptr i8, ptr %194, i64 24
  %.479.i.i = load i64, ptr %.478.i.i, align 8, !noalias !68
  %.480.i.i = add nsw i64 %.479.i.i, 1
  store i64 %.480.i.i, ptr %.478.i.i, align 8, !noalias !68
  %.705.i3393 = load double, ptr %.455.i2943, align 8, !noalias !64
  %.761.i3434 = getelementptr double, ptr %54, i64 %.138.i2676.09106
  store double 0.000000e+00, ptr %.761.i3434, align 8, !noalias !64
  %.818.i3481 = getelementptr double, ptr %55, i64 %.138.i2676.09106
  store double %.705.i3393, ptr %.818.i3481, align 8, !noalias !64
  %.871.i3523 = mul i64 %.291.i2809, %arg.batch.3.3.5.1
  %195 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.871.i3523
  %.875.i3527 = getelementptr i8, ptr %195, i64 8
  %.876.i3528 = load i64, ptr %.875.i3527, align 8, !noalias !64
  %.877.i3529 = add nsw i64 %.876.i3528, 3
  store i64 %.877.i3529, ptr %.875.i3527, align 8, !noalias !64
  br label %B479.i

B479.i:                                           ; preds = %B268.i2994, %B306.i3047, %B64.if.i3580, %B140.i, %B216.i
  %.196.i2745 = icmp sgt i64 %.141.i2677.09105, 1
  br i1 %.196.i2745, label %B64.if.i3580, label %B3184

B64.if.i3580:                                     ; preds = %B2816.if, %B479.i
  %.138.i2676.09106 = phi i64 [ %.209.i3588, %B479.i ], [ 0, %B2816.if ]
  %.141.i2677.09105 = phi i64 [ %.205.i3585, %B479.i ], [ %storemerge, %B2816.if ]
  %.205.i3585 = add nsw i64 %.141.i2677.09105, -1
  %.209.i3588 = add nsw i64 %.138.i2676.09106, 1
  %.290.i2808 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.138.i2676.09106
  %.291.i2809 = load i64, ptr %.290.i2808, align 8, !noalias !64
  %.345.i2856 = getelementptr i64, ptr %47, i64 %.138.i2676.09106
  %.346.i2857 = load i64, ptr %.345.i2856, align 8, !noalias !64
  %.354.i2861 = icmp slt i64 %.291.i2809, 0
  br i1 %.354.i2861, label %B479.i, label %B140.i

B3184.critedge:                                   ; preds = %B2768
  %.4432.c = load i64, ptr %.4431.c, align 8
  %.4477.c = inttoptr i64 %.4432.c to ptr
  tail call void %.4477.c(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3184

B3184:                                            ; preds = %B479.i, %B2816.if, %B3184.critedge
  br i1 %beyond.2.1, label %B3188, label %B3228

B3188:                                            ; preds = %B3184
  %.213.i = load double, ptr %.212.i, align 8, !noalias !71
  %.242.i8774 = load double, ptr %arg.batch.2.4, align 8, !noalias !71
  br label %B194.if.i8776

B192.loopexit.i.critedge:                         ; preds = %B194.if.i8776
  %.768.i.c = load i64, ptr %.767.i, align 8, !noalias !71
  %.885.i.c = inttoptr i64 %.768.i.c to ptr
  tail call void %.885.i.c(ptr %.502, ptr %.859.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !71
  br label %B192.loopexit.i

B192.loopexit.i:                                  ; preds = %B1249.i, %B192.loopexit.i.critedge
  %.359.i8784 = icmp ugt i64 %.303.01263.i, 1
  br i1 %.359.i8784, label %B194.if.i8776, label %B762.i

B228.loopexit.i:                                  ; preds = %B122.if.i.i, %B228.if.i
  %exitcond1268.not.i = icmp eq i64 %arg.shape.0, %.490.i
  br i1 %exitcond1268.not.i, label %B394.i, label %B228.if.i

B122.if.i.i:                                      ; preds = %B122.if.i.lr.ph.i, %B122.if.i.i
  %.229.i.01255.i = phi i64 [ 0, %B122.if.i.lr.ph.i ], [ %.300.i.i, %B122.if.i.i ]
  %.157.i.i.i = add nsw i64 %.229.i.01255.i, %.155.i.i.i
  %.159.i.i.i = mul nsw i64 %.157.i.i.i, %arg.shape.0
  %gep9108 = getelementptr double, ptr %invariant.gep9107, i64 %.159.i.i.i
  %.191.i.i.i = load double, ptr %gep9108, align 8, !noalias !74
  %.193.i.i.i = fadd double %.191.i.i.i, 0.000000e+00
  %.253.i.i.i = fmul double %share.3.2.i, %.193.i.i.i
  %.157.i.i.1.i = add nsw i64 %.229.i.01255.i, %.155.i.i.1.i
  %.159.i.i.1.i = mul nsw i64 %.157.i.i.1.i, %arg.shape.0
  %gep9110 = getelementptr double, ptr %invariant.gep9109, i64 %.159.i.i.1.i
  %.191.i.i.1.i = load double, ptr %gep9110, align 8, !noalias !74
  %.193.i.i.1.i = fadd double %.191.i.i.1.i, %.253.i.i.i
  %.253.i.i.1.i = fmul double %.247.i.i.i, %.193.i.i.1.i
  %.157.i.i.2.i = add nsw i64 %.229.i.01255.i, %.155.i.i.2.i
  %.159.i.i.2.i = mul nsw i64 %.157.i.i.2.i, %arg.shape.0
  %gep9112 = getelementptr double, ptr %invariant.gep9111, i64 %.159.i.i.2.i
  %.191.i.i.2.i = load double, ptr %gep9112, align 8, !noalias !74
  %.193.i.i.2.i = fadd double %.191.i.i.2.i, %.253.i.i.1.i
  %.253.i.i.2.i = fmul double %share.3.2.i, %.193.i.i.2.i
  %.157.i.i.3.i = add nsw i64 %.229.i.01255.i, %.155.i.i.3.i
  %.159.i.i.3.i = mul nsw i64 %.157.i.i.3.i, %arg.shape.0
  %gep9114 = getelementptr double, ptr %invariant.gep9113, i64 %.159.i.i.3.i
  %.191.i.i.3.i = load double, ptr %gep9114, align 8, !noalias !74
  %.193.i.i.3.i = fadd double %.191.i.i.3.i, %.253.i.i.2.i
  %.253.i.i.3.i = fmul double %.247.i.i.i, %.193.i.i.3.i
  %.157.i.i.4.i = add nsw i64 %.229.i.01255.i, %.155.i.i.4.i
  %.159.i.i.4.i = mul nsw i64 %.157.i.i.4.i, %arg.shape.0
  %gep9116 = getelementptr double, ptr %invariant.gep9115, i64 %.159.i.i.4.i
  %.191.i.i.4.i = load double, ptr %gep9116, align 8, !noalias !74
  %.193.i.i.4.i = fadd double %.191.i.i.4.i, %.253.i.i.3.i
  %.253.i.i.4.i = fmul double %share.3.2.i, %.193.i.i.4.i
  %.157.i.i.5.i = add nsw i64 %.229.i.01255.i, %.155.i.i.5.i
  %.159.i.i.5.i = mul nsw i64 %.157.i.i.5.i, %arg.shape.0
  %gep9118 = getelementptr double, ptr %invariant.gep9117, i64 %.159.i.i.5.i
  %.191.i.i.5.i = load double, ptr %gep9118, align 8, !noalias !74
  %.193.i.i.5.i = fadd double %.191.i.i.5.i, %.253.i.i.4.i
  %.253.i.i.5.i = fmul double %.247.i.i.i, %.193.i.i.5.i
  %.157.i.i.6.i = add nsw i64 %.229.i.01255.i, %.155.i.i.6.i
  %.159.i.i.6.i = mul nsw i64 %.157.i.i.6.i, %arg.shape.0
  %gep9120 = getelementptr double, ptr %invariant.gep9119, i64 %.159.i.i.6.i
  %.191.i.i.6.i = load double, ptr %gep9120, align 8, !noalias !74
  %.193.i.i.6.i = fadd double %.191.i.i.6.i, %.253.i.i.5.i
  %.253.i.i.6.i = fmul double %share.3.2.i, %.193.i.i.6.i
  %.300.i.i = add nsw i64 %.229.i.01255.i, 1
  %.271.i.i.i = mul nsw i64 %.229.i.01255.i, %arg.shape.0
  %gep9122 = getelementptr double, ptr %invariant.gep9121, i64 %.271.i.i.i
  %.309.i.i.i = load double, ptr %gep9122, align 8, !noalias !74
  %.313.i.i.i = fadd double %.309.i.i.i, %.253.i.i.6.i
  %.360.i.i = add nsw i64 %.229.i.01255.i, %.359.i.i
  %.362.i.i8781 = mul nsw i64 %.360.i.i, %arg.shape.0
  %gep9124 = getelementptr double, ptr %invariant.gep9123, i64 %.362.i.i8781
  store double %.313.i.i.i, ptr %gep9124, align 8, !noalias !81
  %exitcond.not.i8782 = icmp eq i64 %arg.shape.1, %.300.i.i
  br i1 %exitcond.not.i8782, label %B228.loopexit.i, label %B122.if.i.i

B394.i:                                           ; preds = %B228.loopexit.i
  %.768.i = load i64, ptr %.767.i, align 8, !noalias !71
  %.885.i = inttoptr i64 %.768.i to ptr
  tail call void %.885.i(ptr %.502, ptr %.859.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !71
  br label %B542.if.i

B594.i:                                           ; preds = %B542.if.i
  %.1118.i = getelementptr double, ptr %57, i64 %.911.01261.i
  %.1119.i = load double, ptr %.1118.i, align 8, !noalias !71
  %.1173.i = getelementptr double, ptr %58, i64 %.911.01261.i
  %.1174.i = load double, ptr %.1173.i, align 8, !noalias !71
  %.1175.i = fadd double %.1119.i, %.1174.i
  %.1176.i = fmul double %.1175.i, 5.000000e-01
  br label %B34.i.i8797

B34.i.i8797:                                      ; preds = %B34.if.i.i8798, %B594.i
  %.48.i.0.i = phi i64 [ 0, %B594.i ], [ %.119.i88.i, %B34.if.i.i8798 ]
  %exitcond1269.not.i = icmp eq i64 %.48.i.0.i, %storemerge1241.i
  br i1 %exitcond1269.not.i, label %B732.i, label %B34.if.i.i8798

B80.i.i8800:                                      ; preds = %B34.if.i.i8798
  %196 = icmp sgt i64 %.48.i.0.i, -1
  br i1 %196, label %B706.i, label %B732.i

B34.if.i.i8798:                                   ; preds = %B34.i.i8797
  %.119.i88.i = add i64 %.48.i.0.i, 1
  %.149.i53.i = add nsw i64 %.48.i.0.i, %arg.shape.6
  %.151.i55.i = mul nsw i64 %.149.i53.i, %arg.shape.0
  %.153.i56.i = add nsw i64 %.151.i55.i, %.911.01261.i
  %.167.i61.i = icmp slt i64 %.153.i56.i, 0
  %.168.i62.i = select i1 %.167.i61.i, i64 %arg.batch.5.4.5.0, i64 0
  %197 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i56.i
  %.182.i74.i = getelementptr double, ptr %197, i64 %.168.i62.i
  %.183.i75.i = load double, ptr %.182.i74.i, align 8, !noalias !82
  %.184.i.i8799 = fcmp ogt double %.183.i75.i, 5.000000e-01
  br i1 %.184.i.i8799, label %B80.i.i8800, label %B34.i.i8797

B706.i:                                           ; preds = %B80.i.i8800
  store double %.1176.i, ptr %.1173.i, align 8, !noalias !71
  br label %B1249.i

B732.i:                                           ; preds = %B34.i.i8797, %B80.i.i8800
  store double %.1176.i, ptr %.1118.i, align 8, !noalias !71
  br label %B1249.i

B762.i:                                           ; preds = %B192.loopexit.i
  %.243.i = fsub double %.213.i, %.242.i8774
  %.244.i = fmul double %.243.i, 1.000000e-13
  br i1 %.603, label %B3228, label %B792.if.lr.ph.i

B792.if.lr.ph.i:                                  ; preds = %B762.i
  %.1860.i = fmul double %.244.i, 2.000000e+00
  br label %B792.if.i

B894.i:                                           ; preds = %B792.if.i
  %.1706.i = getelementptr double, ptr %60, i64 %.1389.01265.i
  %.1707.i = load double, ptr %.1706.i, align 8, !noalias !71
  %.1763.i = load double, ptr %.1539.i, align 8, !noalias !71
  %.1764.i = tail call double @llvm.fabs.f64(double %.1763.i)
  %.1765.i = fmul double %.1764.i, 2.000000e-12
  %.1822.i8786 = getelementptr double, ptr %57, i64 %.1389.01265.i
  %.1823.i = load double, ptr %.1822.i8786, align 8, !noalias !71
  %.1828.i = fmul double %.1707.i, 0x3D719799812DEA11
  %.10.i.i8787 = fcmp ogt double %.1765.i, %.1828.i
  %.11.i.i8788 = select i1 %.10.i.i8787, double %.1765.i, double %.1828.i
  %.1824.i = fsub double 1.000000e+00, %.1823.i
  %.1826.i = fmul double %.1707.i, %.1824.i
  %.1857.i = fcmp ugt double %.1826.i, %.11.i.i8788
  %.1862.i = fcmp ugt double %.1707.i, %.1860.i
  %or.cond.i = select i1 %.1857.i, i1 %.1862.i, i1 false
  br i1 %or.cond.i, label %B1150.i, label %B1114.i

B1114.i:                                          ; preds = %B894.i
  store double 2.000000e+00, ptr %.1649.i, align 8, !noalias !71
  br label %B1250.i

B1150.i:                                          ; preds = %B894.i
  %.1978.i = getelementptr double, ptr %58, i64 %.1389.01265.i
  %.1979.i = load double, ptr %.1978.i, align 8, !noalias !71
  %.1981.i = fmul double %.1707.i, %.1979.i
  %.10.i1248.i = fcmp ogt double %.244.i, %.1981.i
  %.11.i1249.i = select i1 %.10.i1248.i, double %.244.i, double %.1981.i
  %.108.i.i = getelementptr double, ptr %62, i64 %.1389.01265.i
  store double 0.000000e+00, ptr %.108.i.i, align 8, !noalias !86
  %.161.i209.i = getelementptr double, ptr %63, i64 %.1389.01265.i
  store double 0.000000e+00, ptr %.161.i209.i, align 8, !noalias !86
  %.214.i250.i = getelementptr double, ptr %64, i64 %.1389.01265.i
  store double %.11.i1249.i, ptr %.214.i250.i, align 8, !noalias !86
  %198 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1389.01265.i
  %.268.i277.i = load i64, ptr %198, align 8, !noalias !86
  %.294.i.i = icmp slt i64 %.268.i277.i, 0
  %.295.i.i8789 = select i1 %.294.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i288.i = add i64 %.295.i.i8789, %.268.i277.i
  %.316.i297.i = mul i64 %.296.i288.i, %arg.batch.3.3.5.1
  %.320.i.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i297.i
  %.321.i.i = load i64, ptr %.320.i.i, align 8, !noalias !86
  %.322.i300.i = add nsw i64 %.321.i.i, -1
  store i64 %.322.i300.i, ptr %.320.i.i, align 8, !noalias !86
  %.426.i.i = load i64, ptr %198, align 8, !noalias !86
  %.452.i.i8790 = icmp slt i64 %.426.i.i, 0
  %.453.i.i8791 = select i1 %.452.i.i8790, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i8792 = add i64 %.453.i.i8791, %.426.i.i
  %.474.i.i8793 = mul i64 %.454.i.i8792, %arg.batch.3.3.5.1
  %199 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i8793
  %.478.i.i8794 = getelementptr i8, ptr %199, i64 24
  %.479.i.i8795 = load i64, ptr %.478.i.i8794, align 8, !noalias !86
  %.480.i.i8796 = add nsw i64 %.479.i.i8795, 1
  store i64 %.480.i.i8796, ptr %.478.i.i8794, align 8, !noalias !86
  br label %B1250.i

B1249.i:                                          ; preds = %B542.if.i, %B732.i, %B706.i
  %exitcond1270.not.i = icmp eq i64 %arg.shape.0, %.980.i8783
  br i1 %exitcond1270.not.i, label %B192.loopexit.i, label %B542.if.i

B1250.i:                                          ; preds = %B792.if.i, %B1150.i, %B1114.i
  %exitcond1271.not.i = icmp eq i64 %.1458.i, %arg.shape.0
  br i1 %exitcond1271.not.i, label %B3228, label %B792.if.i

B194.if.i8776:                                    ; preds = %B192.loopexit.i, %B3188
  %.303.01263.i = phi i64 [ 50, %B3188 ], [ %.368.i8777, %B192.loopexit.i ]
  %.368.i8777 = add nsw i64 %.303.01263.i, -1
  br i1 %.603, label %B192.loopexit.i.critedge, label %B228.if.i

B228.if.i:                                        ; preds = %B194.if.i8776, %B228.loopexit.i
  %.421.01258.i = phi i64 [ %.490.i, %B228.loopexit.i ], [ 0, %B194.if.i8776 ]
  %.490.i = add nsw i64 %.421.01258.i, 1
  %.571.i = getelementptr double, ptr %57, i64 %.421.01258.i
  %.572.i = load double, ptr %.571.i, align 8, !noalias !71
  %.626.i = getelementptr double, ptr %58, i64 %.421.01258.i
  %.627.i = load double, ptr %.626.i, align 8, !noalias !71
  %.628.i8778 = fadd double %.572.i, %.627.i
  %.629.i8779 = fmul double %.628.i8778, 5.000000e-01
  %.686.i = getelementptr double, ptr %59, i64 %.421.01258.i
  %.687.i8780 = load double, ptr %.686.i, align 8, !noalias !71
  %.688.i = fcmp une double %.687.i8780, 1.000000e+00
  %share.3.2.i = select i1 %.688.i, double 1.000000e+00, double %.629.i8779
  %.92.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.421.01258.i
  %.93.i.i = load double, ptr %.92.i.i, align 8, !noalias !81
  %.146.i.i = getelementptr double, ptr %60, i64 %.421.01258.i
  %.147.i.i = load double, ptr %.146.i.i, align 8, !noalias !81
  %.149.i.i = fmul double %share.3.2.i, %.147.i.i
  %.150.i.i = fadd double %.93.i.i, %.149.i.i
  %.203.i.i = getelementptr double, ptr %.502, i64 %.421.01258.i
  store double %.150.i.i, ptr %.203.i.i, align 8, !noalias !81
  br i1 %.287.i1254.not.i, label %B228.loopexit.i, label %B122.if.i.lr.ph.i

B122.if.i.lr.ph.i:                                ; preds = %B228.if.i
  %.247.i.i.i = fsub double 1.000000e+00, %share.3.2.i
  %invariant.gep9107 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.421.01258.i
  %invariant.gep9109 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.421.01258.i
  %invariant.gep9111 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.421.01258.i
  %invariant.gep9113 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.421.01258.i
  %invariant.gep9115 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.421.01258.i
  %invariant.gep9117 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.421.01258.i
  %invariant.gep9119 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.421.01258.i
  %invariant.gep9121 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.421.01258.i
  %invariant.gep9123 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.421.01258.i
  br label %B122.if.i.i

B542.if.i:                                        ; preds = %B394.i, %B1249.i
  %.911.01261.i = phi i64 [ %.980.i8783, %B1249.i ], [ 0, %B394.i ]
  %.980.i8783 = add nsw i64 %.911.01261.i, 1
  %.1061.i = getelementptr double, ptr %59, i64 %.911.01261.i
  %.1062.i = load double, ptr %.1061.i, align 8, !noalias !71
  %.1063.i = fcmp oeq double %.1062.i, 1.000000e+00
  br i1 %.1063.i, label %B594.i, label %B1249.i

B792.if.i:                                        ; preds = %B1250.i, %B792.if.lr.ph.i
  %.1389.01265.i = phi i64 [ 0, %B792.if.lr.ph.i ], [ %.1458.i, %B1250.i ]
  %.1458.i = add nsw i64 %.1389.01265.i, 1
  %.1539.i = getelementptr double, ptr %61, i64 %.1389.01265.i
  %.1540.i = load double, ptr %.1539.i, align 8, !noalias !71
  %.1594.i = getelementptr double, ptr %.502, i64 %.1389.01265.i
  store double %.1540.i, ptr %.1594.i, align 8, !noalias !71
  %.1649.i = getelementptr double, ptr %59, i64 %.1389.01265.i
  %.1650.i = load double, ptr %.1649.i, align 8, !noalias !71
  %.1651.i = fcmp oeq double %.1650.i, 1.000000e+00
  br i1 %.1651.i, label %B894.i, label %B1250.i

B3228:                                            ; preds = %B1250.i, %B762.i, %B3184
  br i1 %.4622.not, label %B3290, label %B120.if.i

B120.loopexit.i.critedge:                         ; preds = %B120.if.i
  %.527.i.c = load i64, ptr %.526.i8801, align 8, !noalias !89
  %.644.i.c = inttoptr i64 %.527.i.c to ptr
  tail call void %.644.i.c(ptr %.502, ptr %.618.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !89
  br label %B120.loopexit.i

B120.loopexit.i:                                  ; preds = %B502.i8863, %B120.loopexit.i.critedge
  %exitcond692.not.i = icmp eq i64 %.231.0688.i, %.8729
  br i1 %exitcond692.not.i, label %B3290, label %B120.if.i

B154.loopexit.i:                                  ; preds = %B122.if.i.i8814, %B154.if.i
  %exitcond690.not.i = icmp eq i64 %arg.shape.0, %.423.i
  br i1 %exitcond690.not.i, label %B206.i, label %B154.if.i

B206.i:                                           ; preds = %B154.loopexit.i
  %.527.i = load i64, ptr %.526.i8801, align 8, !noalias !89
  %.644.i = inttoptr i64 %.527.i to ptr
  tail call void %.644.i(ptr %.502, ptr %.618.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !89
  br label %B354.if.i

B396.i8864:                                       ; preds = %B354.if.i
  %200 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.670.0686.i
  %.854.i = load double, ptr %200, align 8, !noalias !89
  %.856.i = fcmp olt double %.854.i, -1.000000e-09
  br i1 %.856.i, label %B432.i, label %B502.i8863

B432.i:                                           ; preds = %B396.i8864
  %201 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.670.0686.i
  %.84.i51.i = load i64, ptr %201, align 8, !noalias !92
  %.89.i.i8865 = icmp sgt i64 %.84.i51.i, -1
  br i1 %.89.i.i8865, label %B46.i.i8866, label %B432.endif.i

B46.i.i8866:                                      ; preds = %B432.i
  %.120.i73.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i51.i
  %.121.i74.i = load i64, ptr %.120.i73.i, align 8, !noalias !92
  %.122.i75.i = icmp eq i64 %.121.i74.i, 0
  br i1 %.122.i75.i, label %B80.i.i8867, label %B432.endif.i

B80.i.i8867:                                      ; preds = %B46.i.i8866
  store i64 4, ptr %.120.i73.i, align 8, !noalias !92
  br label %B432.endif.i

B502.i8863:                                       ; preds = %B432.endif.i, %B354.if.i, %B396.i8864
  %exitcond691.not.i = icmp eq i64 %arg.shape.0, %.739.i
  br i1 %exitcond691.not.i, label %B120.loopexit.i, label %B354.if.i

B120.if.i:                                        ; preds = %B3228, %B120.loopexit.i
  %.231.0688.i = phi i64 [ %.302.i8804, %B120.loopexit.i ], [ 1, %B3228 ]
  %.302.i8804 = add nsw i64 %.231.0688.i, 1
  br i1 %.603, label %B120.loopexit.i.critedge, label %B154.if.lr.ph.i

B154.if.lr.ph.i:                                  ; preds = %B120.if.i
  %202 = uitofp i64 %.231.0688.i to double
  %.456.i = fdiv double %202, %.452.i
  %.247.i.i.i8805 = fsub double 1.000000e+00, %.456.i
  br label %B154.if.i

B154.if.i:                                        ; preds = %B154.if.lr.ph.i, %B154.loopexit.i
  %.354.0683.i = phi i64 [ 0, %B154.if.lr.ph.i ], [ %.423.i, %B154.loopexit.i ]
  %.423.i = add nsw i64 %.354.0683.i, 1
  %.92.i.i8806 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.354.0683.i
  %.93.i.i8807 = load double, ptr %.92.i.i8806, align 8, !noalias !95
  %.146.i.i8808 = getelementptr double, ptr %65, i64 %.354.0683.i
  %.147.i.i8809 = load double, ptr %.146.i.i8808, align 8, !noalias !95
  %.149.i.i8810 = fmul double %.456.i, %.147.i.i8809
  %.150.i.i8811 = fadd double %.93.i.i8807, %.149.i.i8810
  %.203.i.i8812 = getelementptr double, ptr %.502, i64 %.354.0683.i
  store double %.150.i.i8811, ptr %.203.i.i8812, align 8, !noalias !95
  br i1 %.287.i679.not.i, label %B154.loopexit.i, label %B122.if.i.preheader.i

B122.if.i.preheader.i:                            ; preds = %B154.if.i
  %invariant.gep9125 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9127 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9129 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9131 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9133 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9135 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9137 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9139 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  %invariant.gep9141 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0683.i
  br label %B122.if.i.i8814

B122.if.i.i8814:                                  ; preds = %B122.if.i.i8814, %B122.if.i.preheader.i
  %.229.i.0680.i = phi i64 [ %.300.i.i8856, %B122.if.i.i8814 ], [ 0, %B122.if.i.preheader.i ]
  %.157.i.i.i8815 = add nsw i64 %.229.i.0680.i, %.155.i.i.i8813
  %.159.i.i.i8816 = mul nsw i64 %.157.i.i.i8815, %arg.shape.0
  %gep9126 = getelementptr double, ptr %invariant.gep9125, i64 %.159.i.i.i8816
  %.191.i.i.i8817 = load double, ptr %gep9126, align 8, !noalias !99
  %.193.i.i.i8818 = fadd double %.191.i.i.i8817, 0.000000e+00
  %.253.i.i.i8819 = fmul double %.456.i, %.193.i.i.i8818
  %.157.i.i.1.i8821 = add nsw i64 %.229.i.0680.i, %.155.i.i.1.i8820
  %.159.i.i.1.i8822 = mul nsw i64 %.157.i.i.1.i8821, %arg.shape.0
  %gep9128 = getelementptr double, ptr %invariant.gep9127, i64 %.159.i.i.1.i8822
  %.191.i.i.1.i8823 = load double, ptr %gep9128, align 8, !noalias !99
  %.193.i.i.1.i8824 = fadd double %.191.i.i.1.i8823, %.253.i.i.i8819
  %.253.i.i.1.i8825 = fmul double %.247.i.i.i8805, %.193.i.i.1.i8824
  %.157.i.i.2.i8827 = add nsw i64 %.229.i.0680.i, %.155.i.i.2.i8826
  %.159.i.i.2.i8828 = mul nsw i64 %.157.i.i.2.i8827, %arg.shape.0
  %gep9130 = getelementptr double, ptr %invariant.gep9129, i64 %.159.i.i.2.i8828
  %.191.i.i.2.i8829 = load double, ptr %gep9130, align 8, !noalias !99
  %.193.i.i.2.i8830 = fadd double %.191.i.i.2.i8829, %.253.i.i.1.i8825
  %.253.i.i.2.i8831 = fmul double %.456.i, %.193.i.i.2.i8830
  %.157.i.i.3.i8833 = add nsw i64 %.229.i.0680.i, %.155.i.i.3.i8832
  %.159.i.i.3.i8834 = mul nsw i64 %.157.i.i.3.i8833, %arg.shape.0
  %gep9132 = getelementptr double, ptr %invariant.gep9131, i64 %.159.i.i.3.i8834
  %.191.i.i.3.i8835 = load double, ptr %gep9132, align 8, !noalias !99
  %.193.i.i.3.i8836 = fadd double %.191.i.i.3.i8835, %.253.i.i.2.i8831
  %.253.i.i.3.i8837 = fmul double %.247.i.i.i8805, %.193.i.i.3.i8836
  %.157.i.i.4.i8839 = add nsw i64 %.229.i.0680.i, %.155.i.i.4.i8838
  %.159.i.i.4.i8840 = mul nsw i64 %.157.i.i.4.i8839, %arg.shape.0
  %gep9134 = getelementptr double, ptr %invariant.gep9133, i64 %.159.i.i.4.i8840
  %.191.i.i.4.i8841 = load double, ptr %gep9134, align 8, !noalias !99
  %.193.i.i.4.i8842 = fadd double %.191.i.i.4.i8841, %.253.i.i.3.i8837
  %.253.i.i.4.i8843 = fmul double %.456.i, %.193.i.i.4.i8842
  %.157.i.i.5.i8845 = add nsw i64 %.229.i.0680.i, %.155.i.i.5.i8844
  %.159.i.i.5.i8846 = mul nsw i64 %.157.i.i.5.i8845, %arg.shape.0
  %gep9136 = getelementptr double, ptr %invariant.gep9135, i64 %.159.i.i.5.i8846
  %.191.i.i.5.i8847 = load double, ptr %gep9136, align 8, !noalias !99
  %.193.i.i.5.i8848 = fadd double %.191.i.i.5.i8847, %.253.i.i.4.i8843
  %.253.i.i.5.i8849 = fmul double %.247.i.i.i8805, %.193.i.i.5.i8848
  %.157.i.i.6.i8851 = add nsw i64 %.229.i.0680.i, %.155.i.i.6.i8850
  %.159.i.i.6.i8852 = mul nsw i64 %.157.i.i.6.i8851, %arg.shape.0
  %gep9138 = getelementptr double, ptr %invariant.gep9137, i64 %.159.i.i.6.i8852
  %.191.i.i.6.i8853 = load double, ptr %gep9138, align 8, !noalias !99
  %.193.i.i.6.i8854 = fadd double %.191.i.i.6.i8853, %.253.i.i.5.i8849
  %.253.i.i.6.i8855 = fmul double %.456.i, %.193.i.i.6.i8854
  %.300.i.i8856 = add nsw i64 %.229.i.0680.i, 1
  %.271.i.i.i8857 = mul nsw i64 %.229.i.0680.i, %arg.shape.0
  %gep9140 = getelementptr double, ptr %invariant.gep9139, i64 %.271.i.i.i8857
  %.309.i.i.i8858 = load double, ptr %gep9140, align 8, !noalias !99
  %.313.i.i.i8859 = fadd double %.309.i.i.i8858, %.253.i.i.6.i8855
  %.360.i.i8860 = add nsw i64 %.229.i.0680.i, %.359.i.i8802
  %.362.i.i8861 = mul nsw i64 %.360.i.i8860, %arg.shape.0
  %gep9142 = getelementptr double, ptr %invariant.gep9141, i64 %.362.i.i8861
  store double %.313.i.i.i8859, ptr %gep9142, align 8, !noalias !95
  %exitcond.not.i8862 = icmp eq i64 %arg.shape.1, %.300.i.i8856
  br i1 %exitcond.not.i8862, label %B154.loopexit.i, label %B122.if.i.i8814

B354.if.i:                                        ; preds = %B206.i, %B502.i8863
  %.670.0686.i = phi i64 [ %.739.i, %B502.i8863 ], [ 0, %B206.i ]
  %.739.i = add nsw i64 %.670.0686.i, 1
  %203 = getelementptr double, ptr %66, i64 %.670.0686.i
  %.821.i = load double, ptr %203, align 8, !noalias !89
  %.822.i = fcmp ogt double %.821.i, 5.000000e-01
  br i1 %.822.i, label %B396.i8864, label %B502.i8863

B432.endif.i:                                     ; preds = %B80.i.i8867, %B46.i.i8866, %B432.i
  store double 0.000000e+00, ptr %203, align 8, !noalias !89
  br label %B502.i8863

B3290:                                            ; preds = %B120.loopexit.i, %B2758, %B3228
  %204 = select i1 %looked.4.2.lcssa, i1 %good.2.1.lcssa, i1 false
  br i1 %204, label %B3298, label %B3350

B3298:                                            ; preds = %B3290
  %within.5.1.not = xor i1 %within.5.1, true
  %brmerge8733 = select i1 %within.5.1.not, i1 true, i1 %.545
  %"$phi3334.7.2.2" = select i1 %brmerge8733, i64 0, i64 3
  br i1 %.603, label %B3350, label %B96.if.i

B172.i:                                           ; preds = %B96.if.i
  %.452.i8870 = getelementptr double, ptr %68, i64 %.180.0654.i
  %.453.i8871 = load double, ptr %.452.i8870, align 8, !noalias !103
  %.454.i8872 = fcmp olt double %.453.i8871, 5.000000e-01
  br i1 %.454.i8872, label %B789.i, label %B210.i

B210.i:                                           ; preds = %B172.i
  %.485.i8873 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.334.i
  %.486.i = load i64, ptr %.485.i8873, align 8, !noalias !103
  %.487.not.i = icmp eq i64 %.486.i, 0
  br i1 %.487.not.i, label %B246.i, label %B789.i

B246.i:                                           ; preds = %B210.i
  %.549.i = mul i64 %.334.i, %arg.batch.3.3.5.1
  %205 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.549.i
  %.553.i = getelementptr i8, ptr %205, i64 8
  %.554.i = load i64, ptr %.553.i, align 8, !noalias !103
  %.556.i = add nsw i64 %.554.i, %"$phi3334.7.2.2"
  store i64 %.556.i, ptr %.553.i, align 8, !noalias !103
  %.662.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.180.0654.i
  %.663.i8874 = load double, ptr %.662.i, align 8, !noalias !103
  %.717.i = getelementptr double, ptr %69, i64 %.180.0654.i
  %.718.i = load double, ptr %.717.i, align 8, !noalias !103
  %.772.i8875 = getelementptr double, ptr %70, i64 %.180.0654.i
  %.773.i8876 = load double, ptr %.772.i8875, align 8, !noalias !103
  %.794.i = icmp slt i64 %.389.i, %arg.batch.2.5.0
  br i1 %.794.i, label %B420.i, label %B760.i

B420.i:                                           ; preds = %B246.i
  %.817.i = icmp slt i64 %.389.i, 0
  %.818.i8877 = select i1 %.817.i, i64 %arg.batch.2.5.0, i64 0
  %206 = getelementptr double, ptr %arg.batch.2.4, i64 %.389.i
  %.832.i = getelementptr double, ptr %206, i64 %.818.i8877
  %.833.i = load double, ptr %.832.i, align 8, !noalias !103
  %.837.i = fcmp ugt double %.833.i, %.773.i8876
  br i1 %.837.i, label %B760.i, label %B444.preheader.i

B444.preheader.i:                                 ; preds = %B420.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul652.i, %.334.i
  %.1324.i = getelementptr double, ptr %71, i64 %.180.0654.i
  %207 = getelementptr double, ptr %arg.batch.3.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep9143 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9145 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9147 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9149 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9151 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9153 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9155 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9157 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep9159 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  br label %B444.i

B444.i:                                           ; preds = %B736.i, %B444.preheader.i
  %done.2.3.i = phi i64 [ %.1262.i, %B736.i ], [ %.389.i, %B444.preheader.i ]
  br i1 %.924649.not.i, label %B644.i, label %B474.if.lr.ph.i

B474.if.lr.ph.i:                                  ; preds = %B444.i
  %.979.i8878 = icmp slt i64 %done.2.3.i, 0
  %.980.i8879 = select i1 %.979.i8878, i64 %arg.batch.2.5.0, i64 0
  %208 = getelementptr double, ptr %arg.batch.2.4, i64 %done.2.3.i
  %.994.i8880 = getelementptr double, ptr %208, i64 %.980.i8879
  %.1220.i = select i1 %.979.i8878, i64 %arg.batch.3.0.5.1, i64 0
  %.1221.i = add i64 %.1220.i, %done.2.3.i
  %.1250.i = mul i64 %.1221.i, %arg.batch.3.0.5.2
  %209 = getelementptr double, ptr %207, i64 %.1250.i
  br label %B474.if.i

B502.i8888:                                       ; preds = %B474.if.i
  %.1002.i = add nsw i64 %.868.0650.i, %.1000.i
  %.1004.i = mul nsw i64 %.1002.i, %arg.shape.0
  %gep9160 = getelementptr double, ptr %invariant.gep9159, i64 %.1004.i
  %.1036.i = load double, ptr %gep9160, align 8, !noalias !103
  br label %B790.i

B644.i:                                           ; preds = %B790.i, %B444.i
  store double 0x7FF0000000000000, ptr %.1324.i, align 8, !noalias !103
  %exitcond656.not.i = icmp eq i64 %done.2.3.i, %72
  br i1 %exitcond656.not.i, label %B760.i, label %B736.i

B736.i:                                           ; preds = %B644.i
  %.1262.i = add i64 %done.2.3.i, 1
  %.1359.i = icmp slt i64 %done.2.3.i, -1
  %.1360.i = select i1 %.1359.i, i64 %arg.batch.2.5.0, i64 0
  %210 = getelementptr double, ptr %arg.batch.2.4, i64 %.1262.i
  %.1374.i = getelementptr double, ptr %210, i64 %.1360.i
  %.1375.i = load double, ptr %.1374.i, align 8, !noalias !103
  %.1379.i = fcmp ugt double %.1375.i, %.773.i8876
  br i1 %.1379.i, label %B760.i, label %B444.i

B760.i:                                           ; preds = %B736.i, %B644.i, %B420.i, %B246.i
  %done.3.2.i = phi i64 [ %.389.i, %B420.i ], [ %.389.i, %B246.i ], [ %arg.batch.2.5.0, %B644.i ], [ %.1262.i, %B736.i ]
  store i64 %done.3.2.i, ptr %.388.i, align 8, !noalias !103
  br label %B789.i

B789.i:                                           ; preds = %B96.if.i, %B760.i, %B210.i, %B172.i
  %exitcond657.not.i = icmp eq i64 %.252.i, %arg.shape.0
  br i1 %exitcond657.not.i, label %B3350, label %B96.if.i

B790.i:                                           ; preds = %B38.if.i.i, %B502.i8888
  %.313.i.i.sink = phi double [ %.313.i.i, %B38.if.i.i ], [ %.1036.i, %B502.i8888 ]
  %211 = getelementptr double, ptr %209, i64 %.868.0650.i
  store double %.313.i.i.sink, ptr %211, align 8, !noalias !103
  %exitcond.not.i8887 = icmp eq i64 %arg.shape.1, %.937.i
  br i1 %exitcond.not.i8887, label %B644.i, label %B474.if.i

B96.if.i:                                         ; preds = %B3298, %B789.i
  %.180.0654.i = phi i64 [ %.252.i, %B789.i ], [ 0, %B3298 ]
  %.252.i = add nsw i64 %.180.0654.i, 1
  %.333.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.180.0654.i
  %.334.i = load i64, ptr %.333.i, align 8, !noalias !103
  %.388.i = getelementptr i64, ptr %67, i64 %.180.0654.i
  %.389.i = load i64, ptr %.388.i, align 8, !noalias !103
  %.397.i8869 = icmp slt i64 %.334.i, 0
  br i1 %.397.i8869, label %B789.i, label %B172.i

B474.if.i:                                        ; preds = %B790.i, %B474.if.lr.ph.i
  %.868.0650.i = phi i64 [ 0, %B474.if.lr.ph.i ], [ %.937.i, %B790.i ]
  %.937.i = add nsw i64 %.868.0650.i, 1
  %.995.i8884 = load double, ptr %.994.i8880, align 8, !noalias !103
  %.997.i = fcmp oeq double %.995.i8884, %.773.i8876
  br i1 %.997.i, label %B502.i8888, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B474.if.i
  %.1145.i = fsub double %.995.i8884, %.663.i8874
  %.1150.i = fdiv double %.1145.i, %.718.i
  %.247.i.i = fsub double 1.000000e+00, %.1150.i
  %.157.i.i = add nsw i64 %.868.0650.i, %.155.i.i
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep9144 = getelementptr double, ptr %invariant.gep9143, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep9144, align 8, !noalias !106
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i8885 = fmul double %.1150.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.868.0650.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep9146 = getelementptr double, ptr %invariant.gep9145, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep9146, align 8, !noalias !106
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i8885
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.868.0650.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep9148 = getelementptr double, ptr %invariant.gep9147, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep9148, align 8, !noalias !106
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %.1150.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.868.0650.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep9150 = getelementptr double, ptr %invariant.gep9149, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep9150, align 8, !noalias !106
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.868.0650.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep9152 = getelementptr double, ptr %invariant.gep9151, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep9152, align 8, !noalias !106
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %.1150.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.868.0650.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep9154 = getelementptr double, ptr %invariant.gep9153, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep9154, align 8, !noalias !106
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.868.0650.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep9156 = getelementptr double, ptr %invariant.gep9155, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep9156, align 8, !noalias !106
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %.1150.i, %.193.i.6.i
  %.271.i.i8886 = mul nsw i64 %.868.0650.i, %arg.shape.0
  %gep9158 = getelementptr double, ptr %invariant.gep9157, i64 %.271.i.i8886
  %.309.i.i = load double, ptr %gep9158, align 8, !noalias !106
  %.313.i.i = fadd double %.309.i.i, %.253.i.6.i
  br label %B790.i

B3350:                                            ; preds = %B789.i, %B3298, %B3290
  br i1 %.4860, label %B3400, label %B3362

B3362:                                            ; preds = %B3350
  %.4915 = load double, ptr %.4914, align 8
  %.4916 = fcmp ogt double %.4915, 5.000000e-01
  br i1 %.4916, label %B3400, label %B3468

B3400:                                            ; preds = %B3362, %B3350
  %.4947 = load i64, ptr %.4946, align 8
  %.4992 = inttoptr i64 %.4947 to ptr
  tail call void %.4992(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3468

B3468:                                            ; preds = %B3400, %B3362
  %beyond.2.1.not = xor i1 %beyond.2.1, true
  %brmerge9189 = or i1 %.603, %beyond.2.1.not
  br i1 %brmerge9189, label %B3512, label %B80.if.i4571

B134.i:                                           ; preds = %B80.if.i4571
  %.351.i3885 = getelementptr double, ptr %74, i64 %.141.i3691.09168
  %.352.i3886 = load double, ptr %.351.i3885, align 8, !noalias !110
  %.353.i3887 = fcmp ogt double %.352.i3886, 5.000000e-01
  br i1 %.353.i3887, label %B174.i, label %B740.i

B174.i:                                           ; preds = %B134.i
  %.408.i3934 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.141.i3691.09168
  %.409.i3935 = load double, ptr %.408.i3934, align 8, !noalias !110
  %.463.i3983 = getelementptr double, ptr %75, i64 %.141.i3691.09168
  %.464.i3984 = load double, ptr %.463.i3983, align 8, !noalias !110
  %.465.i3985 = fsub double %.409.i3935, %.464.i3984
  br i1 %.552.i40229161.not, label %B380.i, label %B270.if.i.preheader

B270.if.i.preheader:                              ; preds = %B174.i
  %invariant.gep9216 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.141.i3691.09168
  br label %B270.if.i

B380.i:                                           ; preds = %B270.if.i, %B174.i
  %fastest.2.i.2.lcssa = phi double [ 0.000000e+00, %B174.i ], [ %.11.i.i, %B270.if.i ]
  %.666.i4034 = fmul double %.465.i3985, %fastest.2.i.2.lcssa
  %.698.i4060 = load double, ptr %.697.i4059, align 8, !noalias !110
  %.699.i4061 = fcmp ogt double %.666.i4034, %.698.i4060
  %.8734 = select i1 %.699.i4061, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  %.743.i4090 = load double, ptr %.742.i4089, align 8, !noalias !110
  %.773.i4112 = load double, ptr %arg.batch.2.4, align 8, !noalias !110
  %.774.i4113 = fsub double %.743.i4090, %.773.i4112
  %.776.i4115 = fmul double %.8734, %.774.i4113
  %.780.i4118 = fcmp olt double %.465.i3985, %.776.i4115
  br i1 %.780.i4118, label %B490.i, label %B528.i

B490.i:                                           ; preds = %B380.i
  %212 = getelementptr i64, ptr %77, i64 %.141.i3691.09168
  %.838.i4507 = load i64, ptr %212, align 8, !noalias !110
  %.839.i4508 = add nsw i64 %.838.i4507, 1
  br label %B528.i

B528.i:                                           ; preds = %B380.i, %B490.i
  %"$phi528.1.2.i.2" = phi i64 [ %.839.i4508, %B490.i ], [ 0, %B380.i ]
  %213 = getelementptr i64, ptr %78, i64 %.141.i3691.09168
  store i64 %"$phi528.1.2.i.2", ptr %213, align 8, !noalias !110
  %.959.i4214 = load double, ptr %.408.i3934, align 8, !noalias !110
  store double %.959.i4214, ptr %.463.i3983, align 8, !noalias !110
  %.1068.i4278 = getelementptr double, ptr %79, i64 %.141.i3691.09168
  store double 1.000000e+00, ptr %.1068.i4278, align 8, !noalias !110
  store i64 1, ptr %.981, align 8, !noalias !110
  %.1154.i = load i64, ptr %213, align 8, !noalias !110
  %.1155.i = icmp sgt i64 %.1154.i, 1000
  br i1 %.1155.i, label %B694.i, label %B740.i

B694.i:                                           ; preds = %B528.i
  %214 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.141.i3691.09168
  %.84.i.i4398 = load i64, ptr %214, align 8, !noalias !114
  %.89.i.i4401 = icmp sgt i64 %.84.i.i4398, -1
  br i1 %.89.i.i4401, label %B46.i.i4408, label %B740.i

B46.i.i4408:                                      ; preds = %B694.i
  %.120.i.i4428 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i4398
  %.121.i.i4429 = load i64, ptr %.120.i.i4428, align 8, !noalias !114
  %.122.i.i4430 = icmp eq i64 %.121.i.i4429, 0
  br i1 %.122.i.i4430, label %B80.i.i4435, label %B740.i

B80.i.i4435:                                      ; preds = %B46.i.i4408
  store i64 6, ptr %.120.i.i4428, align 8, !noalias !114
  br label %B740.i

B740.i:                                           ; preds = %B80.i.i4435, %B694.i, %B46.i.i4408, %B528.i, %B134.i, %B80.if.i4571
  %.200.i3775 = icmp sgt i64 %.144.i3692.09167, 1
  br i1 %.200.i3775, label %B80.if.i4571, label %B3512

B80.if.i4571:                                     ; preds = %B3468, %B740.i
  %.141.i3691.09168 = phi i64 [ %.213.i4579, %B740.i ], [ 0, %B3468 ]
  %.144.i3692.09167 = phi i64 [ %.209.i4576, %B740.i ], [ %storemerge, %B3468 ]
  %.209.i4576 = add nsw i64 %.144.i3692.09167, -1
  %.213.i4579 = add nsw i64 %.141.i3691.09168, 1
  %.294.i3835 = getelementptr double, ptr %73, i64 %.141.i3691.09168
  %.295.i3836 = load double, ptr %.294.i3835, align 8, !noalias !110
  %.296.i3837 = fcmp oeq double %.295.i3836, 2.000000e+00
  br i1 %.296.i3837, label %B134.i, label %B740.i

B270.if.i:                                        ; preds = %B270.if.i.preheader, %B270.if.i
  %fastest.2.i.29164 = phi double [ %.11.i.i, %B270.if.i ], [ 0.000000e+00, %B270.if.i.preheader ]
  %.496.i3708.09163 = phi i64 [ %.565.i4563, %B270.if.i ], [ 0, %B270.if.i.preheader ]
  %.565.i4563 = add nsw i64 %.496.i3708.09163, 1
  %.592.i4515 = add nsw i64 %.496.i3708.09163, %arg.shape.1
  %.594.i4517 = mul nsw i64 %.592.i4515, %arg.shape.0
  %gep9217 = getelementptr double, ptr %invariant.gep9216, i64 %.594.i4517
  %.626.i4545 = load double, ptr %gep9217, align 8, !noalias !110
  %.627.i4546 = tail call double @llvm.fabs.f64(double %.626.i4545)
  %.10.i.i = fcmp ogt double %.627.i4546, %fastest.2.i.29164
  %.11.i.i = select i1 %.10.i.i, double %.627.i4546, double %fastest.2.i.29164
  %exitcond9203.not = icmp eq i64 %arg.shape.1, %.565.i4563
  br i1 %exitcond9203.not, label %B380.i, label %B270.if.i

B3512:                                            ; preds = %B740.i, %B3468
  %brmerge8736.not = and i1 %.5057.not, %looked.4.2.lcssa
  %brmerge8736.not.not = xor i1 %brmerge8736.not, true
  %brmerge9188 = or i1 %.603, %brmerge8736.not.not
  br i1 %brmerge9188, label %B3562, label %B114.if.i

B46.i.i8889:                                      ; preds = %B114.if.i
  %.135.i.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !117
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i8894, label %B228.i

B80.i.i8894:                                      ; preds = %B46.i.i8889
  %.196.i.i = getelementptr double, ptr %80, i64 %.302.01639.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !117
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B228.i, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i8894
  %.264.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.302.01639.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !117
  %.321.i.i8895 = getelementptr double, ptr %81, i64 %.302.01639.i
  %.322.i.i8896 = load double, ptr %.321.i.i8895, align 8, !noalias !117
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i8896
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.175.i3061635.not.i
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01641.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01641.i
  br i1 %brmerge.i, label %B228.i, label %B76.if.i.lr.ph.i8897

B76.if.i.lr.ph.i8897:                             ; preds = %B122.i.i
  %215 = getelementptr i64, ptr %82, i64 %.302.01639.i
  %.513.i = load i64, ptr %215, align 8, !noalias !122
  %.514.i = add nsw i64 %.513.i, 1
  %.236.i323.i = icmp slt i64 %.513.i, -1
  %.237.i324.i = select i1 %.236.i323.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i325.i = add i64 %.514.i, %.237.i324.i
  %.258.i342.i = mul i64 %.238.i325.i, %arg.batch.1.3.5.1
  %216 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i342.i
  br label %B76.if.i.i8898

B76.if.i.i8898:                                   ; preds = %B76.if.i.i8898, %B76.if.i.lr.ph.i8897
  %.117.i268.01636.i = phi i64 [ 0, %B76.if.i.lr.ph.i8897 ], [ %.188.i390.i, %B76.if.i.i8898 ]
  %.188.i390.i = add nsw i64 %.117.i268.01636.i, 1
  %217 = getelementptr double, ptr %216, i64 %.117.i268.01636.i
  %.263.i344.i = load double, ptr %217, align 8, !noalias !123
  %218 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i268.01636.i
  %.293.i360.i = load i64, ptr %218, align 8, !noalias !123
  %.295.i362.i = mul nsw i64 %.293.i360.i, %arg.shape.0
  %.297.i364.i = add nsw i64 %.295.i362.i, %.302.01639.i
  %.311.i372.i = icmp slt i64 %.297.i364.i, 0
  %.312.i373.i = select i1 %.311.i372.i, i64 %arg.batch.5.1.5.0, i64 0
  %219 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i364.i
  %.326.i383.i = getelementptr double, ptr %219, i64 %.312.i373.i
  store double %.263.i344.i, ptr %.326.i383.i, align 8, !noalias !123
  %exitcond.not.i8899 = icmp eq i64 %arg.batch.1.1.5.0, %.188.i390.i
  br i1 %exitcond.not.i8899, label %B228.i, label %B76.if.i.i8898

B228.i:                                           ; preds = %B76.if.i.i8898, %B114.if.i, %B122.i.i, %B80.i.i8894, %B46.i.i8889
  %some.3.1.i = phi i1 [ %some.2.01641.mux.i, %B122.i.i ], [ %some.2.01641.i, %B80.i.i8894 ], [ %some.2.01641.i, %B114.if.i ], [ %some.2.01641.i, %B46.i.i8889 ], [ true, %B76.if.i.i8898 ]
  %exitcond1650.not.i = icmp eq i64 %arg.shape.0, %.373.i
  br i1 %exitcond1650.not.i, label %B230.i, label %B114.if.i

B230.i:                                           ; preds = %B228.i
  br i1 %some.3.1.i, label %B238.i, label %B3562

B238.i:                                           ; preds = %B230.i
  %.637.i = load i64, ptr %.636.i, align 8, !noalias !122
  %.749.i = inttoptr i64 %.637.i to ptr
  tail call void %.749.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !122
  %.780.i = load i64, ptr %.779.i, align 8, !noalias !122
  %.896.i8891 = inttoptr i64 %.780.i to ptr
  tail call void %.896.i8891(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.895.i8890), !noalias !122
  br i1 %.900.not.i, label %B598.if.i.preheader, label %B456.i

B456.i:                                           ; preds = %B238.i
  %.931.i = load i64, ptr %.930.i, align 8, !noalias !122
  %.1049.i = inttoptr i64 %.931.i to ptr
  tail call void %.1049.i(ptr %arg.batch.4.0.4, ptr %.895.i8890, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !122
  br label %B598.if.i.preheader

B598.if.i.preheader:                              ; preds = %B456.i, %B238.i
  br label %B598.if.i

B46.i82.i:                                        ; preds = %B598.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !127
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B1076.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %80, i64 %.1090.01648.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !127
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B1076.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.1090.01648.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !127
  %.321.i223.i = getelementptr double, ptr %81, i64 %.1090.01648.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !127
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B1076.i, label %B638.i

B638.i:                                           ; preds = %B122.i147.i
  %.1344.i = getelementptr i64, ptr %83, i64 %.1090.01648.i
  %.1345.i = load i64, ptr %.1344.i, align 8, !noalias !122
  %.1356.i = icmp sgt i64 %.1345.i, 0
  br i1 %.1356.i, label %B714.i, label %B768.i

B714.i:                                           ; preds = %B638.i
  %220 = getelementptr double, ptr %arg.batch.2.4, i64 %.1345.i
  %.1391.i = getelementptr i8, ptr %220, i64 -8
  %.1392.i = load double, ptr %.1391.i, align 8, !noalias !122
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
  %221 = getelementptr double, ptr %arg.batch.3.0.4, i64 %.1741.i
  %222 = getelementptr double, ptr %221, i64 %.1743.i
  %invariant.gep9169 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  %invariant.gep9171 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  br label %B800.if.i

B896.i:                                           ; preds = %B800.if.i
  %223 = getelementptr double, ptr %222, i64 %.1488.01643.i
  store double %.1622.i, ptr %223, align 8, !noalias !122
  br label %B918.i

B918.i:                                           ; preds = %B800.if.i, %B896.i
  %exitcond1651.not.i = icmp eq i64 %arg.shape.1, %.1557.i
  br i1 %exitcond1651.not.i, label %B920.loopexit.i, label %B800.if.i

B920.loopexit.i:                                  ; preds = %B918.i
  %224 = fcmp une double %.1629.i, 0.000000e+00
  br i1 %224, label %B932.i, label %B978.i

B932.i:                                           ; preds = %B920.loopexit.i
  %.84.i452.i = load i64, ptr %227, align 8, !noalias !130
  %.89.i454.i = icmp sgt i64 %.84.i452.i, -1
  br i1 %.89.i454.i, label %B46.i458.i, label %B978.i

B46.i458.i:                                       ; preds = %B932.i
  %.120.i478.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i452.i
  %.121.i479.i = load i64, ptr %.120.i478.i, align 8, !noalias !130
  %.122.i480.i = icmp eq i64 %.121.i479.i, 0
  br i1 %.122.i480.i, label %B80.i484.i, label %B978.i

B80.i484.i:                                       ; preds = %B46.i458.i
  store i64 3, ptr %.120.i478.i, align 8, !noalias !130
  br label %B978.i

B978.i:                                           ; preds = %B80.i484.i, %B46.i458.i, %B932.i, %B920.loopexit.i, %B768.i
  br i1 %.900.not.i, label %B1076.i, label %B994.i

B994.i:                                           ; preds = %B978.i
  %225 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.1090.01648.i
  %.1846.i = load double, ptr %225, align 8, !noalias !122
  %.1848.i = fcmp olt double %.1846.i, -1.000000e-09
  br i1 %.1848.i, label %B1030.i, label %B1076.i

B1030.i:                                          ; preds = %B994.i
  %.84.i583.i = load i64, ptr %227, align 8, !noalias !133
  %.89.i586.i = icmp sgt i64 %.84.i583.i, -1
  br i1 %.89.i586.i, label %B46.i591.i, label %B1076.i

B46.i591.i:                                       ; preds = %B1030.i
  %.120.i616.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i583.i
  %.121.i617.i = load i64, ptr %.120.i616.i, align 8, !noalias !133
  %.122.i618.i = icmp eq i64 %.121.i617.i, 0
  br i1 %.122.i618.i, label %B80.i623.i, label %B1076.i

B80.i623.i:                                       ; preds = %B46.i591.i
  store i64 4, ptr %.120.i616.i, align 8, !noalias !133
  br label %B1076.i

B1076.i:                                          ; preds = %B598.if.i, %B80.i623.i, %B46.i591.i, %B1030.i, %B994.i, %B978.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %.1146.i = icmp sgt i64 %.1093.01649.i, 1
  br i1 %.1146.i, label %B598.if.i, label %B3562

B114.if.i:                                        ; preds = %B3512, %B228.i
  %some.2.01641.i = phi i1 [ %some.3.1.i, %B228.i ], [ false, %B3512 ]
  %.302.01639.i = phi i64 [ %.373.i, %B228.i ], [ 0, %B3512 ]
  %.373.i = add nsw i64 %.302.01639.i, 1
  %226 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.302.01639.i
  %.99.i.i = load i64, ptr %226, align 8, !noalias !117
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B228.i, label %B46.i.i8889

B598.if.i:                                        ; preds = %B598.if.i.preheader, %B1076.i
  %.1093.01649.i = phi i64 [ %.1155.i8893, %B1076.i ], [ %storemerge.i, %B598.if.i.preheader ]
  %.1090.01648.i = phi i64 [ %.1159.i, %B1076.i ], [ 0, %B598.if.i.preheader ]
  %.1155.i8893 = add nsw i64 %.1093.01649.i, -1
  %.1159.i = add nsw i64 %.1090.01648.i, 1
  %227 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1090.01648.i
  %.99.i78.i = load i64, ptr %227, align 8, !noalias !127
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B1076.i, label %B46.i82.i

B800.if.i:                                        ; preds = %B918.i, %B800.if.lr.ph.i
  %trouble.2.11645.i = phi double [ 0.000000e+00, %B800.if.lr.ph.i ], [ %.1629.i, %B918.i ]
  %.1488.01643.i = phi i64 [ 0, %B800.if.lr.ph.i ], [ %.1557.i, %B918.i ]
  %.1557.i = add nsw i64 %.1488.01643.i, 1
  %.1588.i = add nsw i64 %.1488.01643.i, %.850.i
  %.1590.i = mul nsw i64 %.1588.i, %arg.shape.0
  %gep9170 = getelementptr double, ptr %invariant.gep9169, i64 %.1590.i
  %.1622.i = load double, ptr %gep9170, align 8, !noalias !122
  %.1627.i = fmul double %.1622.i, 0.000000e+00
  %.1629.i = fadd double %trouble.2.11645.i, %.1627.i
  %.1637.i = mul nsw i64 %.1488.01643.i, %arg.shape.0
  %gep9172 = getelementptr double, ptr %invariant.gep9171, i64 %.1637.i
  store double %.1622.i, ptr %gep9172, align 8, !noalias !122
  br i1 %"$phi768.1.2.1.i", label %B896.i, label %B918.i

B3562:                                            ; preds = %B1076.i, %B3512, %B230.i
  %looked.4.2.lcssa.not = xor i1 %looked.4.2.lcssa, true
  %brmerge9190 = or i1 %.603, %looked.4.2.lcssa.not
  %active.9.1.mux = select i1 %looked.4.2.lcssa, i64 0, i64 %active.9.1
  br i1 %brmerge9190, label %B4538, label %B3604.if

B3652:                                            ; preds = %B3604.if
  %.5440 = mul i64 %.5367, %arg.batch.3.3.5.1
  %.5444 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.5440
  %.5445 = load i64, ptr %.5444, align 8
  %.5501 = getelementptr i8, ptr %.5444, i64 24
  %.5502 = load i64, ptr %.5501, align 8
  %228 = add i64 %.5445, %.5502
  %.5503 = sub i64 %arg.most, %228
  %.5508 = icmp slt i64 %.5503, 1
  br i1 %.5508, label %B3732, label %B3778

B3732:                                            ; preds = %B3652
  %229 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5205.09177
  %.84.i4661 = load i64, ptr %229, align 8, !noalias !136
  %.89.i4664 = icmp sgt i64 %.84.i4661, -1
  br i1 %.89.i4664, label %B46.i4669, label %B3778

B46.i4669:                                        ; preds = %B3732
  %.120.i4695 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i4661
  %.121.i4696 = load i64, ptr %.120.i4695, align 8, !noalias !136
  %.122.i4697 = icmp eq i64 %.121.i4696, 0
  br i1 %.122.i4697, label %B80.i4702, label %B3778

B80.i4702:                                        ; preds = %B46.i4669
  store i64 5, ptr %.120.i4695, align 8, !noalias !136
  br label %B3778

B3778:                                            ; preds = %B80.i4702, %B3732, %B46.i4669, %B3652
  %.5598 = getelementptr double, ptr %84, i64 %.5205.09177
  %.5599 = load double, ptr %.5598, align 8
  %.5600 = fcmp ogt double %.5599, 5.000000e-01
  br i1 %.5600, label %B3816, label %B3920

B3816:                                            ; preds = %B3778
  %.5655 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5205.09177
  %.5656 = load double, ptr %.5655, align 8
  %.5710 = getelementptr double, ptr %85, i64 %.5205.09177
  %.5711 = load double, ptr %.5710, align 8
  %.5712 = fcmp oeq double %.5656, %.5711
  br i1 %.5712, label %B3880, label %B3920

B3880:                                            ; preds = %B3816
  %.192.i4929 = load i64, ptr %.5366, align 8, !noalias !139
  %.248.i4977 = getelementptr i64, ptr %86, i64 %.5205.09177
  %.249.i4978 = load i64, ptr %.248.i4977, align 8, !noalias !139
  %.250.i4979 = add nsw i64 %.249.i4978, 1
  store i64 %.250.i4979, ptr %.248.i4977, align 8, !noalias !139
  %.373.i5084 = icmp slt i64 %.249.i4978, -1
  %.374.i5085 = select i1 %.373.i5084, i64 %arg.batch.1.2.5.0, i64 0
  %230 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.250.i4979
  %.388.i5099 = getelementptr double, ptr %230, i64 %.374.i5085
  %.389.i5100 = load double, ptr %.388.i5099, align 8, !noalias !139
  %.390.i5101 = fcmp oeq double %.389.i5100, 0x7FF0000000000000
  br i1 %.390.i5101, label %B182.i, label %B240.i5102

B182.i:                                           ; preds = %B3880
  %.424.i5624 = icmp slt i64 %.192.i4929, 0
  %.425.i5625 = select i1 %.424.i5624, i64 %arg.batch.3.1.5.0, i64 0
  %231 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.192.i4929
  %.439.i5639 = getelementptr i64, ptr %231, i64 %.425.i5625
  %.440.i5640 = load i64, ptr %.439.i5639, align 8, !noalias !139
  %.441.i5641 = icmp eq i64 %.440.i5640, 0
  br i1 %.441.i5641, label %B216.i5645, label %B3920

B216.i5645:                                       ; preds = %B182.i
  store i64 1, ptr %.439.i5639, align 8, !noalias !139
  br label %B3920

B240.i5102:                                       ; preds = %B3880
  store double %.389.i5100, ptr %.5710, align 8, !noalias !139
  %.592.i5192 = select i1 %.373.i5084, i64 %arg.batch.1.4.5.0, i64 0
  %232 = getelementptr i64, ptr %arg.batch.1.4.4, i64 %.250.i4979
  %.606.i5206 = getelementptr i64, ptr %232, i64 %.592.i5192
  %.607.i5207 = load i64, ptr %.606.i5206, align 8, !noalias !139
  %.610.i5209 = icmp eq i64 %.607.i5207, 0
  br i1 %.610.i5209, label %B300.i, label %B348.i

B300.i:                                           ; preds = %B240.i5102
  %.665.i5578 = getelementptr double, ptr %87, i64 %.5205.09177
  store double 1.000000e+00, ptr %.665.i5578, align 8, !noalias !139
  br label %B392.i.sink.split

B348.i:                                           ; preds = %B240.i5102
  %.733.i5235 = load i64, ptr %.981, align 8, !noalias !139
  %.734.i5236 = icmp eq i64 %.733.i5235, 0
  br i1 %.734.i5236, label %B392.i.sink.split, label %B392.i

B392.i.sink.split:                                ; preds = %B348.i, %B300.i
  %.sink = phi i64 [ 1, %B300.i ], [ 2, %B348.i ]
  store i64 %.sink, ptr %.981, align 8, !noalias !139
  br label %B392.i

B392.i:                                           ; preds = %B392.i.sink.split, %B348.i
  br i1 %.175.i.i53889173.not, label %B3920, label %B76.if.i.i.lr.ph

B76.if.i.i.lr.ph:                                 ; preds = %B392.i
  %.237.i.i5434 = select i1 %.373.i5084, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i5435 = add i64 %.237.i.i5434, %.250.i4979
  %.258.i.i5451 = mul i64 %.238.i.i5435, %arg.batch.1.3.5.1
  %233 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i5451
  br label %B76.if.i.i

B76.if.i.i:                                       ; preds = %B76.if.i.i.lr.ph, %B76.if.i.i
  %.117.i.i4740.09175 = phi i64 [ 0, %B76.if.i.i.lr.ph ], [ %.188.i.i5498, %B76.if.i.i ]
  %.188.i.i5498 = add nsw i64 %.117.i.i4740.09175, 1
  %234 = getelementptr double, ptr %233, i64 %.117.i.i4740.09175
  %.263.i.i5454 = load double, ptr %234, align 8, !noalias !143
  %235 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.i4740.09175
  %.293.i.i5470 = load i64, ptr %235, align 8, !noalias !143
  %.295.i.i5472 = mul nsw i64 %.293.i.i5470, %arg.shape.0
  %.297.i.i5474 = add nsw i64 %.295.i.i5472, %.5205.09177
  %.311.i.i5481 = icmp slt i64 %.297.i.i5474, 0
  %.312.i.i5482 = select i1 %.311.i.i5481, i64 %arg.batch.5.1.5.0, i64 0
  %236 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i5474
  %.326.i.i5492 = getelementptr double, ptr %236, i64 %.312.i.i5482
  store double %.263.i.i5454, ptr %.326.i.i5492, align 8, !noalias !143
  %exitcond9204.not = icmp eq i64 %arg.batch.1.1.5.0, %.188.i.i5498
  br i1 %exitcond9204.not, label %B3920, label %B76.if.i.i

B3920:                                            ; preds = %B76.if.i.i, %B392.i, %B216.i5645, %B182.i, %B3816, %B3778
  %.5801 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.5367
  %.5802 = load i64, ptr %.5801, align 8
  %.5803.not = icmp eq i64 %.5802, 0
  br i1 %.5803.not, label %B4062, label %B3954

B3954:                                            ; preds = %B3920
  %.5864 = getelementptr i64, ptr %88, i64 %.5205.09177
  %.5865 = load i64, ptr %.5864, align 8
  %.5895 = getelementptr i64, ptr %arg.batch.3.2.4, i64 %.5367
  store i64 %.5865, ptr %.5895, align 8
  store i64 -1, ptr %.5366, align 8
  %.236.i8900 = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !147
  %.293.i8905 = getelementptr double, ptr %89, i64 %.5205.09177
  store double 0.000000e+00, ptr %.293.i8905, align 8, !noalias !147
  %.324.i8907 = load i64, ptr %.323.i8906, align 8, !noalias !147
  %.326.i8908 = icmp eq i64 %.236.i8900, %.324.i8907
  br i1 %.326.i8908, label %B4270, label %B132.i8909

B132.i8909:                                       ; preds = %B3954
  %.359.i8910 = add nsw i64 %.236.i8900, 1
  store i64 %.359.i8910, ptr %arg.batch.4.2.4, align 8, !noalias !147
  store i64 1, ptr %.981, align 8, !noalias !147
  %.438.i8912 = icmp slt i64 %.236.i8900, 0
  %.439.i8913 = select i1 %.438.i8912, i64 %arg.batch.0.2.5.0, i64 0
  %237 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i8900
  %.453.i8914 = getelementptr i64, ptr %237, i64 %.439.i8913
  %.454.i8915 = load i64, ptr %.453.i8914, align 8, !noalias !147
  %.469.i8916 = icmp slt i64 %.454.i8915, 0
  %.470.i8917 = select i1 %.469.i8916, i64 %arg.batch.1.0.5.0, i64 0
  %238 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i8915
  %.484.i8918 = getelementptr i64, ptr %238, i64 %.470.i8917
  %.485.i8919 = load i64, ptr %.484.i8918, align 8, !noalias !147
  store i64 %.236.i8900, ptr %.5366, align 8, !noalias !147
  %.595.i8923 = getelementptr i64, ptr %90, i64 %.5205.09177
  store i64 %.485.i8919, ptr %.595.i8923, align 8, !noalias !147
  store i64 1, ptr %.5864, align 8, !noalias !147
  %.709.i8927 = getelementptr i64, ptr %91, i64 %.5205.09177
  store i64 0, ptr %.709.i8927, align 8, !noalias !147
  br i1 %.8051131.not.i8928, label %B402.i8943, label %B358.if.lr.ph.i8929

B358.if.lr.ph.i8929:                              ; preds = %B132.i8909
  %.867.i8930 = select i1 %.438.i8912, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i8931 = add i64 %.867.i8930, %.236.i8900
  %.888.i8932 = mul i64 %.868.i8931, %arg.batch.0.1.5.1
  %239 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i8932
  %invariant.gep9218 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.5205.09177
  br label %B358.if.i8933

B402.i8943:                                       ; preds = %B358.if.i8933, %B132.i8909
  br i1 %.175.i1134.not.i8944, label %B402.endif.i8962, label %B76.if.i.lr.ph.i8945

B76.if.i.lr.ph.i8945:                             ; preds = %B402.i8943
  %.990.i8946 = load i64, ptr %.595.i8923, align 8, !noalias !147
  %.236.i.i8947 = icmp slt i64 %.990.i8946, 0
  %.237.i.i8948 = select i1 %.236.i.i8947, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i8949 = add i64 %.237.i.i8948, %.990.i8946
  %.258.i.i8950 = mul i64 %.238.i.i8949, %arg.batch.1.3.5.1
  %240 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i8950
  br label %B76.if.i.i8951

B76.if.i.i8951:                                   ; preds = %B76.if.i.i8951, %B76.if.i.lr.ph.i8945
  %.117.i.01135.i8952 = phi i64 [ 0, %B76.if.i.lr.ph.i8945 ], [ %.188.i.i8953, %B76.if.i.i8951 ]
  %.188.i.i8953 = add nsw i64 %.117.i.01135.i8952, 1
  %241 = getelementptr double, ptr %240, i64 %.117.i.01135.i8952
  %.263.i.i8954 = load double, ptr %241, align 8, !noalias !150
  %242 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i8952
  %.293.i.i8955 = load i64, ptr %242, align 8, !noalias !150
  %.295.i.i8956 = mul nsw i64 %.293.i.i8955, %arg.shape.0
  %.297.i.i8957 = add nsw i64 %.295.i.i8956, %.5205.09177
  %.311.i.i8958 = icmp slt i64 %.297.i.i8957, 0
  %.312.i.i8959 = select i1 %.311.i.i8958, i64 %arg.batch.5.1.5.0, i64 0
  %243 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i8957
  %.326.i.i8960 = getelementptr double, ptr %243, i64 %.312.i.i8959
  store double %.263.i.i8954, ptr %.326.i.i8960, align 8, !noalias !150
  %exitcond1142.not.i8961 = icmp eq i64 %.188.i.i8953, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i8961, label %B402.endif.i8962, label %B76.if.i.i8951

B888.i9052:                                       ; preds = %B580.if.i8978
  store double 0.000000e+00, ptr %.1877.i9049, align 8, !noalias !147
  br label %B4270

B358.if.i8933:                                    ; preds = %B358.if.i8933, %B358.if.lr.ph.i8929
  %.747.01132.i8934 = phi i64 [ 0, %B358.if.lr.ph.i8929 ], [ %.818.i8935, %B358.if.i8933 ]
  %.818.i8935 = add nsw i64 %.747.01132.i8934, 1
  %244 = getelementptr double, ptr %239, i64 %.747.01132.i8934
  %.893.i8936 = load double, ptr %244, align 8, !noalias !147
  %.895.i8937 = mul nsw i64 %.747.01132.i8934, %arg.shape.0
  %gep9219 = getelementptr double, ptr %invariant.gep9218, i64 %.895.i8937
  store double %.893.i8936, ptr %gep9219, align 8, !noalias !147
  %exitcond.not.i8942 = icmp eq i64 %.818.i8935, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i8942, label %B402.i8943, label %B358.if.i8933

B402.endif.i8962:                                 ; preds = %B76.if.i.i8951, %B402.i8943
  br i1 %.11171137.not.i8963, label %B580.if.i8978, label %B496.if.lr.ph.i8964

B496.if.lr.ph.i8964:                              ; preds = %B402.endif.i8962
  %.1179.i8965 = select i1 %.438.i8912, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i8966 = add i64 %.1179.i8965, %.236.i8900
  %.1200.i8967 = mul i64 %.1180.i8966, %arg.batch.0.0.5.1
  %245 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i8967
  %invariant.gep9220 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.5205.09177
  br label %B496.if.i8968

B496.if.i8968:                                    ; preds = %B496.if.i8968, %B496.if.lr.ph.i8964
  %.1061.01138.i8969 = phi i64 [ 0, %B496.if.lr.ph.i8964 ], [ %.1130.i8970, %B496.if.i8968 ]
  %.1130.i8970 = add nsw i64 %.1061.01138.i8969, 1
  %246 = getelementptr double, ptr %245, i64 %.1061.01138.i8969
  %.1205.i8971 = load double, ptr %246, align 8, !noalias !147
  %.1207.i8972 = mul nsw i64 %.1061.01138.i8969, %arg.shape.0
  %gep9221 = getelementptr double, ptr %invariant.gep9220, i64 %.1207.i8972
  store double %.1205.i8971, ptr %gep9221, align 8, !noalias !147
  %exitcond1143.not.i8977 = icmp eq i64 %.1130.i8970, %arg.shape.1
  br i1 %exitcond1143.not.i8977, label %B580.if.i8978, label %B496.if.i8968

B580.if.i8978:                                    ; preds = %B496.if.i8968, %B402.endif.i8962
  %invariant.gep.i8979 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5205.09177
  store double 0.000000e+00, ptr %invariant.gep.i8979, align 8, !noalias !147
  %gep.1.i8980 = getelementptr double, ptr %invariant.gep.i8979, i64 %arg.batch.4.0.5.1
  store double 0.000000e+00, ptr %gep.1.i8980, align 8, !noalias !147
  %gep.2.i8982 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.2.idx.i8981
  store double 0.000000e+00, ptr %gep.2.i8982, align 8, !noalias !147
  %gep.3.i8984 = getelementptr i8, ptr %invariant.gep.i8979, i64 %.idx.i8904
  store double 0.000000e+00, ptr %gep.3.i8984, align 8, !noalias !147
  %gep.4.i8986 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.4.idx.i8985
  store double 0.000000e+00, ptr %gep.4.i8986, align 8, !noalias !147
  %gep.5.i8988 = getelementptr i8, ptr %invariant.gep.i8979, i64 %.idx8669
  store double 0.000000e+00, ptr %gep.5.i8988, align 8, !noalias !147
  %gep.6.i8990 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.6.idx.i8989
  store double 0.000000e+00, ptr %gep.6.i8990, align 8, !noalias !147
  %gep.7.i8992 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.7.idx.i8991
  store double 0.000000e+00, ptr %gep.7.i8992, align 8, !noalias !147
  %gep.8.i8994 = getelementptr i8, ptr %invariant.gep.i8979, i64 %.502.idx
  store double 0.000000e+00, ptr %gep.8.i8994, align 8, !noalias !147
  %gep.9.i8996 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.9.idx.i8995
  store double 0.000000e+00, ptr %gep.9.i8996, align 8, !noalias !147
  %gep.10.i8998 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.10.idx.i8997
  store double 0.000000e+00, ptr %gep.10.i8998, align 8, !noalias !147
  %gep.11.i9000 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.11.idx.i8999
  store double 0.000000e+00, ptr %gep.11.i9000, align 8, !noalias !147
  %gep.12.i9002 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.12.idx.i9001
  store double 0.000000e+00, ptr %gep.12.i9002, align 8, !noalias !147
  %gep.13.i9004 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.13.idx.i9003
  store double 0.000000e+00, ptr %gep.13.i9004, align 8, !noalias !147
  %gep.14.i9006 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.14.idx.i9005
  store double 0.000000e+00, ptr %gep.14.i9006, align 8, !noalias !147
  %gep.15.i9008 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.15.idx.i9007
  store double 0.000000e+00, ptr %gep.15.i9008, align 8, !noalias !147
  %gep.16.i9010 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.16.idx.i9009
  store double 0.000000e+00, ptr %gep.16.i9010, align 8, !noalias !147
  %gep.17.i9012 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.17.idx.i9011
  store double 0.000000e+00, ptr %gep.17.i9012, align 8, !noalias !147
  %gep.18.i9014 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.18.idx.i9013
  store double 0.000000e+00, ptr %gep.18.i9014, align 8, !noalias !147
  %gep.19.i9016 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.19.idx.i9015
  store double 0.000000e+00, ptr %gep.19.i9016, align 8, !noalias !147
  %gep.20.i9018 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.20.idx.i9017
  store double 0.000000e+00, ptr %gep.20.i9018, align 8, !noalias !147
  %gep.21.i9020 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.21.idx.i9019
  store double 0.000000e+00, ptr %gep.21.i9020, align 8, !noalias !147
  %gep.22.i9022 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.22.idx.i9021
  store double 0.000000e+00, ptr %gep.22.i9022, align 8, !noalias !147
  %gep.23.i9024 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.23.idx.i9023
  store double 0.000000e+00, ptr %gep.23.i9024, align 8, !noalias !147
  %gep.24.i9026 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.24.idx.i9025
  store double 0.000000e+00, ptr %gep.24.i9026, align 8, !noalias !147
  %gep.25.i9028 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.25.idx.i9027
  store double 0.000000e+00, ptr %gep.25.i9028, align 8, !noalias !147
  %gep.26.i9030 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.26.idx.i9029
  store double 0.000000e+00, ptr %gep.26.i9030, align 8, !noalias !147
  %gep.27.i9032 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.27.idx.i9031
  store double 0.000000e+00, ptr %gep.27.i9032, align 8, !noalias !147
  %gep.28.i9034 = getelementptr i8, ptr %invariant.gep.i8979, i64 %gep.28.idx.i9033
  store double 0.000000e+00, ptr %gep.28.i9034, align 8, !noalias !147
  %.1455.i9035 = load double, ptr %arg.batch.2.4, align 8, !noalias !147
  %.1516.i9036 = load i64, ptr %.595.i8923, align 8, !noalias !147
  %.1531.i9037 = icmp slt i64 %.1516.i9036, 0
  %.1532.i9038 = select i1 %.1531.i9037, i64 %arg.batch.1.2.5.0, i64 0
  %247 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i9036
  %.1546.i9039 = getelementptr double, ptr %247, i64 %.1532.i9038
  %.1547.i9040 = load double, ptr %.1546.i9039, align 8, !noalias !147
  store double %.1455.i9035, ptr %invariant.gep.i8979, align 8, !noalias !147
  %.1656.i9043 = getelementptr double, ptr %92, i64 %.5205.09177
  store double %.1547.i9040, ptr %.1656.i9043, align 8, !noalias !147
  store double 1.000000e+00, ptr %.293.i8905, align 8, !noalias !147
  %.1767.i9045 = getelementptr double, ptr %93, i64 %.5205.09177
  store double 0xFFF0000000000000, ptr %.1767.i9045, align 8, !noalias !147
  %.1822.i9047 = getelementptr double, ptr %94, i64 %.5205.09177
  store double 0x7FF0000000000000, ptr %.1822.i9047, align 8, !noalias !147
  %.1877.i9049 = getelementptr double, ptr %95, i64 %.5205.09177
  %.1878.i9050 = load double, ptr %.1877.i9049, align 8, !noalias !147
  %.1880.i9051 = fcmp ueq double %.1878.i9050, 0xFFF0000000000000
  br i1 %.1880.i9051, label %B4270, label %B888.i9052

B4062:                                            ; preds = %B3920
  %.6091 = getelementptr double, ptr %96, i64 %.5205.09177
  %.6092 = load double, ptr %.6091, align 8
  %.6094 = fcmp ult double %.6092, 1.500000e+01
  br i1 %.6094, label %B4270, label %B4110

B4110:                                            ; preds = %B4062
  %.6138 = load double, ptr %.6137, align 8
  %.6192 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5205.09177
  %.6193 = load double, ptr %.6192, align 8
  %.6194 = fsub double %.6138, %.6193
  %.6248 = getelementptr double, ptr %99, i64 %.5205.09177
  %.6249 = load double, ptr %.6248, align 8
  %.6251 = fmul double %.6249, 5.000000e+03
  %.6252 = fcmp ogt double %.6194, %.6251
  br i1 %.6252, label %B4270, label %B4246

B4246:                                            ; preds = %B4110
  store double 0.000000e+00, ptr %.6091, align 8
  br label %B4270

B4270:                                            ; preds = %B888.i9052, %B3954, %B580.if.i8978, %B4110, %B4246, %B4062
  %budget.7.4 = phi i64 [ %budget.5.29179, %B4062 ], [ 0, %B4110 ], [ %budget.5.29179, %B4246 ], [ %budget.5.29179, %B580.if.i8978 ], [ %budget.5.29179, %B3954 ], [ %budget.5.29179, %B888.i9052 ]
  %.6380 = load i64, ptr %.5366, align 8
  %.6381 = icmp sgt i64 %.6380, -1
  br i1 %.6381, label %B4308, label %B4565

B4308:                                            ; preds = %B4270
  %.6386 = add nsw i64 %active.5.29180, 1
  %.6495 = mul i64 %.6380, %arg.batch.3.3.5.1
  %.6499 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.6495
  %.6500 = load i64, ptr %.6499, align 8
  %.6511.0 = and i64 %.6500, 127
  %.6541 = sub nsw i64 128, %.6511.0
  %.11.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.6541, i64 %.5503)
  %.6629 = getelementptr double, ptr %100, i64 %.5205.09177
  %.6630 = load double, ptr %.6629, align 8
  %.6632 = fcmp ogt double %.6630, 0.000000e+00
  %.6643 = sitofp i64 %.11.i to double
  %"$phi4478.1.2.5" = select i1 %.6632, double 1.000000e+00, double %.6643
  %.6706 = getelementptr double, ptr %101, i64 %.5205.09177
  store double %"$phi4478.1.2.5", ptr %.6706, align 8
  %.111.i5780 = getelementptr i64, ptr %102, i64 %.5205.09177
  %.112.i5781 = load i64, ptr %.111.i5780, align 8, !noalias !154
  %.169.i5829 = getelementptr double, ptr %103, i64 %.5205.09177
  %.170.i5830 = load double, ptr %.169.i5829, align 8, !noalias !154
  %.224.i5878 = getelementptr double, ptr %104, i64 %.5205.09177
  store double %.170.i5830, ptr %.224.i5878, align 8, !noalias !154
  %.237.i5886 = icmp slt i64 %.112.i5781, %arg.batch.2.5.0
  br i1 %.237.i5886, label %B134.i5891, label %B4565

B134.i5891:                                       ; preds = %B4308
  %.253.i5902 = icmp slt i64 %.112.i5781, 0
  %.254.i5903 = select i1 %.253.i5902, i64 %arg.batch.2.5.0, i64 0
  %248 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i5781
  %.268.i5917 = getelementptr double, ptr %248, i64 %.254.i5903
  %.269.i5918 = load double, ptr %.268.i5917, align 8, !noalias !154
  %.328.i5969 = load double, ptr %.169.i5829, align 8, !noalias !154
  %.10.i.i5976 = fcmp olt double %.328.i5969, %.269.i5918
  %.11.i.i5977 = select i1 %.10.i.i5976, double %.328.i5969, double %.269.i5918
  store double %.11.i.i5977, ptr %.224.i5878, align 8, !noalias !154
  br label %B4565

B4538:                                            ; preds = %B4565, %B3562
  %budget.4.2 = phi i64 [ %.947, %B3562 ], [ %budget.6.3, %B4565 ]
  %active.8.2 = phi i64 [ %active.9.1.mux, %B3562 ], [ %active.6.3, %B4565 ]
  %.6784 = icmp sgt i64 %active.8.2, 0
  %.6803 = icmp sgt i64 %budget.4.2, 0
  %or.cond8737 = select i1 %.6784, i1 %.6803, i1 false
  br i1 %or.cond8737, label %B422, label %B4564

B4564:                                            ; preds = %B4538, %B394
  %active.10.0 = phi i64 [ %active.4.0.lcssa, %B394 ], [ %active.8.2, %B4538 ]
  br i1 %.603, label %B4564.endif, label %B80.if.i1839.lr.ph

B80.if.i1839.lr.ph:                               ; preds = %B4564
  %.idx = mul i64 %arg.batch.4.0.5.1, 168
  %249 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx
  %.idx8667 = mul i64 %arg.batch.4.0.5.1, 176
  %250 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8667
  %.697.i1608 = add nsw i64 %arg.shape.2, -1
  %.idx8668 = mul i64 %arg.batch.4.0.5.1, 152
  %251 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx8668
  br label %B80.if.i1839

B126.i1261:                                       ; preds = %B80.if.i1839
  %.318.i1308 = getelementptr double, ptr %249, i64 %.105.i1115.09185
  %.319.i1309 = load double, ptr %.318.i1308, align 8, !noalias !158
  %.5.i.i1310 = fptosi double %.319.i1309 to i64
  %.397.i1361 = getelementptr double, ptr %250, i64 %.105.i1115.09185
  %.398.i1362 = load double, ptr %.397.i1361, align 8, !noalias !158
  %.5.i1.i1363 = fptosi double %.398.i1362 to i64
  %.472.i1411 = mul i64 %.258.i1254, %arg.batch.3.3.5.1
  %.476.i1415 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.472.i1411
  %.477.i1416 = load i64, ptr %.476.i1415, align 8, !noalias !158
  %.478.i1417 = add nsw i64 %.477.i1416, %.5.i.i1310
  store i64 %.478.i1417, ptr %.476.i1415, align 8, !noalias !158
  %.584.i1509 = getelementptr i8, ptr %.476.i1415, i64 24
  %.585.i1510 = load i64, ptr %.584.i1509, align 8, !noalias !158
  %.586.i1511 = add nsw i64 %.585.i1510, %.5.i1.i1363
  store i64 %.586.i1511, ptr %.584.i1509, align 8, !noalias !158
  %.694.i1605 = getelementptr i8, ptr %.476.i1415, i64 8
  %.695.i1606 = load i64, ptr %.694.i1605, align 8, !noalias !158
  %.698.i1609 = add nsw i64 %.5.i1.i1363, %.5.i.i1310
  %.699.i1610 = mul nsw i64 %.698.i1609, %.697.i1608
  %.700.i1611 = add nsw i64 %.699.i1610, %.5.i.i1310
  %.701.i1612 = add nsw i64 %.700.i1611, %.695.i1606
  store i64 %.701.i1612, ptr %.694.i1605, align 8, !noalias !158
  store double 0.000000e+00, ptr %.318.i1308, align 8, !noalias !158
  store double 0.000000e+00, ptr %.397.i1361, align 8, !noalias !158
  %.923.i1794 = getelementptr double, ptr %251, i64 %.105.i1115.09185
  %.924.i1795 = load double, ptr %.923.i1794, align 8, !noalias !158
  %.926.i1797 = sitofp i64 %.698.i1609 to double
  %.927.i1798 = fsub double %.924.i1795, %.926.i1797
  store double %.927.i1798, ptr %.923.i1794, align 8, !noalias !158
  br label %B502.i1258

B502.i1258:                                       ; preds = %B126.i1261, %B80.if.i1839
  %.163.i1189 = icmp sgt i64 %.108.i1116.09186, 1
  br i1 %.163.i1189, label %B80.if.i1839, label %B4564.endif

B80.if.i1839:                                     ; preds = %B80.if.i1839.lr.ph, %B502.i1258
  %.108.i1116.09186 = phi i64 [ %storemerge, %B80.if.i1839.lr.ph ], [ %.172.i1844, %B502.i1258 ]
  %.105.i1115.09185 = phi i64 [ 0, %B80.if.i1839.lr.ph ], [ %.176.i1847, %B502.i1258 ]
  %.172.i1844 = add nsw i64 %.108.i1116.09186, -1
  %.176.i1847 = add nsw i64 %.105.i1115.09185, 1
  %252 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i1115.09185
  %.258.i1254 = load i64, ptr %252, align 8, !noalias !158
  %.263.i1257 = icmp sgt i64 %.258.i1254, -1
  br i1 %.263.i1257, label %B126.i1261, label %B502.i1258

B4565:                                            ; preds = %B4308, %B134.i5891, %B4270, %B3604.if
  %budget.6.3 = phi i64 [ %budget.5.29179, %B3604.if ], [ %budget.7.4, %B4270 ], [ %budget.7.4, %B134.i5891 ], [ %budget.7.4, %B4308 ]
  %active.6.3 = phi i64 [ %active.5.29180, %B3604.if ], [ %active.5.29180, %B4270 ], [ %.6386, %B134.i5891 ], [ %.6386, %B4308 ]
  %.5268 = icmp sgt i64 %.5208.09178, 1
  br i1 %.5268, label %B3604.if, label %B4538

B254.if:                                          ; preds = %B254.if.lr.ph, %B340
  %active.4.09063 = phi i64 [ 0, %B254.if.lr.ph ], [ %.898, %B340 ]
  %.592.09062 = phi i64 [ %storemerge, %B254.if.lr.ph ], [ %.656, %B340 ]
  %.589.09061 = phi i64 [ 0, %B254.if.lr.ph ], [ %.660, %B340 ]
  %.656 = add nsw i64 %.592.09062, -1
  %.660 = add nsw i64 %.589.09061, 1
  %253 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.589.09061
  %.742 = load i64, ptr %253, align 8
  %.743 = icmp slt i64 %.742, 0
  br i1 %.743, label %B296, label %B340

B1380.if:                                         ; preds = %B1348, %B1604
  %.1971.09078 = phi i64 [ %.2040, %B1604 ], [ 1, %B1348 ]
  %.2040 = add i64 %.1971.09078, 1
  %254 = getelementptr i64, ptr %arg.code.4, i64 %.1971.09078
  %255 = getelementptr i8, ptr %254, i64 104
  %.2099 = load i64, ptr %255, align 8
  %.2144 = inttoptr i64 %.2099 to ptr
  tail call void %.2144(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.2175 = load i64, ptr %arg.code.4, align 8
  %.2181 = mul nsw i64 %.2040, %.394
  %.2225 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2181
  %.2226 = inttoptr i64 %.2175 to ptr
  tail call void %.2226(ptr %.502, ptr %.2200, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.2225)
  br i1 %.541, label %B1568, label %B1604

B1748.if:                                         ; preds = %B1606, %B1834
  %looked.4.29084 = phi i1 [ %"$phi1834.1.2.2", %B1834 ], [ %spec.select8738, %B1606 ]
  %good.2.19083 = phi i1 [ %"$phi1792.1.2.2", %B1834 ], [ false, %B1606 ]
  %.2428.09082 = phi i64 [ %.2490, %B1834 ], [ %storemerge, %B1606 ]
  %.2425.09081 = phi i64 [ %.2494, %B1834 ], [ 0, %B1606 ]
  %.2490 = add nsw i64 %.2428.09082, -1
  %.2494 = add nsw i64 %.2425.09081, 1
  br i1 %good.2.19083, label %B1792, label %B1756

B1908.if:                                         ; preds = %B1908.preheader, %B2414
  %doubted.3.29094 = phi i1 [ %doubted.4.3, %B2414 ], [ false, %B1908.preheader ]
  %within.3.29093 = phi i1 [ %within.4.3, %B2414 ], [ false, %B1908.preheader ]
  %.2783.09092 = phi i64 [ %.2851, %B2414 ], [ %storemerge, %B1908.preheader ]
  %.2780.09091 = phi i64 [ %.2855, %B2414 ], [ 0, %B1908.preheader ]
  %.2851 = add nsw i64 %.2783.09092, -1
  %.2855 = add nsw i64 %.2780.09091, 1
  %.2940 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2780.09091
  %.2941 = load i64, ptr %.2940, align 8
  %.2995 = getelementptr i64, ptr %36, i64 %.2780.09091
  %.2996 = load i64, ptr %.2995, align 8
  %.3056 = getelementptr double, ptr %37, i64 %.2780.09091
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
  %.4191 = load i64, ptr %105, align 8
  %.4236 = inttoptr i64 %.4191 to ptr
  tail call void %.4236(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4267 = load i64, ptr %arg.code.4, align 8
  %.4317 = inttoptr i64 %.4267 to ptr
  tail call void %.4317(ptr %.502, ptr %.4291, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4316)
  %.4191.1 = load i64, ptr %106, align 8
  %.4236.1 = inttoptr i64 %.4191.1 to ptr
  tail call void %.4236.1(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4267.1 = load i64, ptr %arg.code.4, align 8
  %.4317.1 = inttoptr i64 %.4267.1 to ptr
  tail call void %.4317.1(ptr %.502, ptr %.4291, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4316.1)
  %.4191.2 = load i64, ptr %107, align 8
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
  br i1 %.603, label %B3184, label %B64.if.i3580

B3604.if:                                         ; preds = %B3562, %B4565
  %active.5.29180 = phi i64 [ %active.6.3, %B4565 ], [ 0, %B3562 ]
  %budget.5.29179 = phi i64 [ %budget.6.3, %B4565 ], [ %.947, %B3562 ]
  %.5208.09178 = phi i64 [ %.5277, %B4565 ], [ %storemerge, %B3562 ]
  %.5205.09177 = phi i64 [ %.5281, %B4565 ], [ 0, %B3562 ]
  %.5277 = add nsw i64 %.5208.09178, -1
  %.5281 = add nsw i64 %.5205.09177, 1
  %.5366 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5205.09177
  %.5367 = load i64, ptr %.5366, align 8
  %.5372 = icmp slt i64 %.5367, 0
  br i1 %.5372, label %B4565, label %B3652

B4564.endif:                                      ; preds = %B502.i1258, %B4564
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
!72 = distinct !{!72, !73, !"_ZN12clpt_control6native9for_numba5crossB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!73 = distinct !{!73, !"_ZN12clpt_control6native9for_numba5crossB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
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
!134 = distinct !{!134, !135, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!135 = distinct !{!135, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!136 = !{!137}
!137 = distinct !{!137, !138, !"_ZN12clpt_control6native9for_numba4failB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29: %retptr"}
!138 = distinct !{!138, !"_ZN12clpt_control6native9for_numba4failB3v39B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29"}
!139 = !{!140, !142}
!140 = distinct !{!140, !141, !"_ZN12clpt_control6native9for_numba5enterB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!141 = distinct !{!141, !"_ZN12clpt_control6native9for_numba5enterB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!142 = distinct !{!142, !141, !"_ZN12clpt_control6native9for_numba5enterB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!143 = !{!144, !146, !140, !142}
!144 = distinct !{!144, !145, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!145 = distinct !{!145, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!146 = distinct !{!146, !145, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!147 = !{!148}
!148 = distinct !{!148, !149, !"_ZN12clpt_control6native9for_numba4takeB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!149 = distinct !{!149, !"_ZN12clpt_control6native9for_numba4takeB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!150 = !{!151, !153, !148}
!151 = distinct !{!151, !152, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!152 = distinct !{!152, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!153 = distinct !{!153, !152, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!154 = !{!155, !157}
!155 = distinct !{!155, !156, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!156 = distinct !{!156, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!157 = distinct !{!157, !156, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!158 = !{!159, !161}
!159 = distinct !{!159, !160, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!160 = distinct !{!160, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!161 = distinct !{!161, !160, !"_ZN12clpt_control6native9for_numba5countB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}

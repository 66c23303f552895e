; sha256 38be35809a11197e8bb0526e6fabd28f29391acfc4bf7c992ee6cf5d98c0e8b2

define dso_local noundef i32 @advance_of_many(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, i64 %arg.shape.3, i64 %arg.shape.4, i64 %arg.shape.5, i64 %arg.shape.6, ptr readnone %arg.tolerances.0, ptr readnone %arg.tolerances.1, i64 %arg.tolerances.2, i64 %arg.tolerances.3, ptr %arg.tolerances.4, i64 %arg.tolerances.5.0, i64 %arg.tolerances.6.0, ptr readnone %arg.batch.0.0.0, ptr readnone %arg.batch.0.0.1, i64 %arg.batch.0.0.2, i64 %arg.batch.0.0.3, ptr readonly %arg.batch.0.0.4, i64 %arg.batch.0.0.5.0, i64 %arg.batch.0.0.5.1, i64 %arg.batch.0.0.6.0, i64 %arg.batch.0.0.6.1, ptr readnone %arg.batch.0.1.0, ptr readnone %arg.batch.0.1.1, i64 %arg.batch.0.1.2, i64 %arg.batch.0.1.3, ptr readonly %arg.batch.0.1.4, i64 %arg.batch.0.1.5.0, i64 %arg.batch.0.1.5.1, i64 %arg.batch.0.1.6.0, i64 %arg.batch.0.1.6.1, ptr readnone %arg.batch.0.2.0, ptr readnone %arg.batch.0.2.1, i64 %arg.batch.0.2.2, i64 %arg.batch.0.2.3, ptr readonly %arg.batch.0.2.4, i64 %arg.batch.0.2.5.0, i64 %arg.batch.0.2.6.0, ptr readnone %arg.batch.1.0.0, ptr readnone %arg.batch.1.0.1, i64 %arg.batch.1.0.2, i64 %arg.batch.1.0.3, ptr readonly %arg.batch.1.0.4, i64 %arg.batch.1.0.5.0, i64 %arg.batch.1.0.6.0, ptr readnone %arg.batch.1.1.0, ptr readnone %arg.batch.1.1.1, i64 %arg.batch.1.1.2, i64 %arg.batch.1.1.3, ptr readonly %arg.batch.1.1.4, i64 %arg.batch.1.1.5.0, i64 %arg.batch.1.1.6.0, ptr readnone %arg.batch.1.2.0, ptr readnone %arg.batch.1.2.1, i64 %arg.batch.1.2.2, i64 %arg.batch.1.2.3, ptr readonly %arg.batch.1.2.4, i64 %arg.batch.1.2.5.0, i64 %arg.batch.1.2.6.0, ptr readnone %arg.batch.1.3.0, ptr readnone %arg.batch.1.3.1, i64 %arg.batch.1.3.2, i64 %arg.batch.1.3.3, ptr readonly %arg.batch.1.3.4, i64 %arg.batch.1.3.5.0, i64 %arg.batch.1.3.5.1, i64 %arg.batch.1.3.6.0, i64 %arg.batch.1.3.6.1, ptr readnone %arg.batch.1.4.0, ptr readnone %arg.batch.1.4.1, i64 %arg.batch.1.4.2, i64 %arg.batch.1.4.3, ptr readonly %arg.batch.1.4.4, i64 %arg.batch.1.4.5.0, i64 %arg.batch.1.4.6.0, ptr readnone %arg.batch.2.0, ptr readnone %arg.batch.2.1, i64 %arg.batch.2.2, i64 %arg.batch.2.3, ptr readonly %arg.batch.2.4, i64 %arg.batch.2.5.0, i64 %arg.batch.2.6.0, ptr readnone %arg.batch.3.0.0, ptr readnone %arg.batch.3.0.1, i64 %arg.batch.3.0.2, i64 %arg.batch.3.0.3, ptr %arg.batch.3.0.4, i64 %arg.batch.3.0.5.0, i64 %arg.batch.3.0.5.1, i64 %arg.batch.3.0.5.2, i64 %arg.batch.3.0.6.0, i64 %arg.batch.3.0.6.1, i64 %arg.batch.3.0.6.2, ptr readnone %arg.batch.3.1.0, ptr readnone %arg.batch.3.1.1, i64 %arg.batch.3.1.2, i64 %arg.batch.3.1.3, ptr %arg.batch.3.1.4, i64 %arg.batch.3.1.5.0, i64 %arg.batch.3.1.6.0, ptr readnone %arg.batch.3.2.0, ptr readnone %arg.batch.3.2.1, i64 %arg.batch.3.2.2, i64 %arg.batch.3.2.3, ptr %arg.batch.3.2.4, i64 %arg.batch.3.2.5.0, i64 %arg.batch.3.2.6.0, ptr readnone %arg.batch.3.3.0, ptr readnone %arg.batch.3.3.1, i64 %arg.batch.3.3.2, i64 %arg.batch.3.3.3, ptr %arg.batch.3.3.4, i64 %arg.batch.3.3.5.0, i64 %arg.batch.3.3.5.1, i64 %arg.batch.3.3.6.0, i64 %arg.batch.3.3.6.1, ptr readnone %arg.batch.4.0.0, ptr readnone %arg.batch.4.0.1, i64 %arg.batch.4.0.2, i64 %arg.batch.4.0.3, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.0, i64 %arg.batch.4.0.5.1, i64 %arg.batch.4.0.6.0, i64 %arg.batch.4.0.6.1, ptr readnone %arg.batch.4.1.0, ptr readnone %arg.batch.4.1.1, i64 %arg.batch.4.1.2, i64 %arg.batch.4.1.3, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.0, i64 %arg.batch.4.1.5.1, i64 %arg.batch.4.1.6.0, i64 %arg.batch.4.1.6.1, ptr readnone %arg.batch.4.2.0, ptr readnone %arg.batch.4.2.1, i64 %arg.batch.4.2.2, i64 %arg.batch.4.2.3, ptr %arg.batch.4.2.4, i64 %arg.batch.4.2.5.0, i64 %arg.batch.4.2.6.0, ptr readnone %arg.batch.5.0.0, ptr readnone %arg.batch.5.0.1, i64 %arg.batch.5.0.2, i64 %arg.batch.5.0.3, ptr %arg.batch.5.0.4, i64 %arg.batch.5.0.5.0, i64 %arg.batch.5.0.6.0, ptr readnone %arg.batch.5.1.0, ptr readnone %arg.batch.5.1.1, i64 %arg.batch.5.1.2, i64 %arg.batch.5.1.3, ptr %arg.batch.5.1.4, i64 %arg.batch.5.1.5.0, i64 %arg.batch.5.1.6.0, ptr readnone %arg.batch.5.2.0, ptr readnone %arg.batch.5.2.1, i64 %arg.batch.5.2.2, i64 %arg.batch.5.2.3, ptr %arg.batch.5.2.4, i64 %arg.batch.5.2.5.0, i64 %arg.batch.5.2.6.0, ptr readnone %arg.batch.5.3.0, ptr readnone %arg.batch.5.3.1, i64 %arg.batch.5.3.2, i64 %arg.batch.5.3.3, ptr %arg.batch.5.3.4, i64 %arg.batch.5.3.5.0, i64 %arg.batch.5.3.6.0, ptr readnone %arg.batch.5.4.0, ptr readnone %arg.batch.5.4.1, i64 %arg.batch.5.4.2, i64 %arg.batch.5.4.3, ptr %arg.batch.5.4.4, i64 %arg.batch.5.4.5.0, i64 %arg.batch.5.4.6.0, ptr readnone %arg.linear.0.0, ptr readnone %arg.linear.0.1, i64 %arg.linear.0.2, i64 %arg.linear.0.3, ptr %arg.linear.0.4, i64 %arg.linear.0.5.0, i64 %arg.linear.0.6.0, ptr readnone %arg.linear.1.0, ptr readnone %arg.linear.1.1, i64 %arg.linear.1.2, i64 %arg.linear.1.3, ptr %arg.linear.1.4, i64 %arg.linear.1.5.0, i64 %arg.linear.1.6.0, ptr readnone %arg.linear.2.0, ptr readnone %arg.linear.2.1, i64 %arg.linear.2.2, i64 %arg.linear.2.3, ptr %arg.linear.2.4, i64 %arg.linear.2.5.0, i64 %arg.linear.2.6.0, i64 %arg.linear.3.0, i64 %arg.linear.3.1, i64 %arg.linear.3.2, ptr readnone %arg.linear.4.0, ptr readnone %arg.linear.4.1, i64 %arg.linear.4.2, i64 %arg.linear.4.3, ptr readonly %arg.linear.4.4, i64 %arg.linear.4.5.0, i64 %arg.linear.4.6.0, ptr readnone %arg.linear.5.0, ptr readnone %arg.linear.5.1, i64 %arg.linear.5.2, i64 %arg.linear.5.3, ptr readonly %arg.linear.5.4, i64 %arg.linear.5.5.0, i64 %arg.linear.5.6.0, ptr readnone %arg.linear.6.0, ptr readnone %arg.linear.6.1, i64 %arg.linear.6.2, i64 %arg.linear.6.3, ptr readonly %arg.linear.6.4, i64 %arg.linear.6.5.0, i64 %arg.linear.6.6.0, ptr readnone %arg.linear.7.0, ptr readnone %arg.linear.7.1, i64 %arg.linear.7.2, i64 %arg.linear.7.3, ptr readonly %arg.linear.7.4, i64 %arg.linear.7.5.0, i64 %arg.linear.7.6.0, ptr readnone %arg.linear.8.0, ptr readnone %arg.linear.8.1, i64 %arg.linear.8.2, i64 %arg.linear.8.3, ptr readonly %arg.linear.8.4, i64 %arg.linear.8.5.0, i64 %arg.linear.8.6.0, ptr readnone %arg.linear.9.0, ptr readnone %arg.linear.9.1, i64 %arg.linear.9.2, i64 %arg.linear.9.3, ptr readonly %arg.linear.9.4, i64 %arg.linear.9.5.0, i64 %arg.linear.9.6.0, i64 %arg.budget, i64 %arg.most) local_unnamed_addr {
entry:
  %.463 = mul i64 %arg.shape.1, %arg.shape.0
  %.571.idx = shl i64 %arg.batch.4.0.5.1, 6
  %.571 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.571.idx
  %.610 = icmp eq i64 %arg.shape.2, 9
  %.612 = icmp slt i64 %arg.shape.2, 5
  %.614 = icmp eq i64 %arg.shape.2, 12
  %.625 = icmp eq i64 %arg.shape.2, 7
  %. = select i1 %.625, i64 7, i64 1
  %.676 = getelementptr i8, ptr %arg.code.4, i64 56
  %.677 = load i64, ptr %.676, align 8
  %.678.not = icmp eq i64 %.677, 0
  br i1 %.678.not, label %B356, label %B380

B356:                                             ; preds = %entry
  %.743 = load i64, ptr %arg.code.4, align 8
  br label %B380

B380:                                             ; preds = %entry, %B356
  %"$phi380.0.2.0" = phi i64 [ %.743, %B356 ], [ %.677, %entry ]
  %.794 = icmp slt i64 %arg.shape.0, 1
  %storemerge = select i1 %.794, i64 0, i64 %arg.shape.0
  br i1 %.794, label %B556, label %B416.if.lr.ph

B416.if.lr.ph:                                    ; preds = %B380
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
  %4 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i
  %5 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.16.idx.i
  %6 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.27.idx.i
  %.idx1130.i = mul i64 %arg.batch.4.0.5.1, 224
  %7 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i
  br label %B416.if

B458:                                             ; preds = %B416.if
  %.236.i = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !0
  %.293.i10632 = getelementptr double, ptr %0, i64 %.780.010905
  store double 0.000000e+00, ptr %.293.i10632, align 8, !noalias !0
  %.324.i = load i64, ptr %.323.i, align 8, !noalias !0
  %.326.i = icmp eq i64 %.236.i, %.324.i
  br i1 %.326.i, label %B502, label %B132.i

B132.i:                                           ; preds = %B458
  %.359.i10633 = add nsw i64 %.236.i, 1
  store i64 %.359.i10633, ptr %arg.batch.4.2.4, align 8, !noalias !0
  store i64 1, ptr %.418.i, align 8, !noalias !0
  %.438.i = icmp slt i64 %.236.i, 0
  %.439.i = select i1 %.438.i, i64 %arg.batch.0.2.5.0, i64 0
  %8 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i
  %.453.i10634 = getelementptr i64, ptr %8, i64 %.439.i
  %.454.i10635 = load i64, ptr %.453.i10634, align 8, !noalias !0
  %.469.i = icmp slt i64 %.454.i10635, 0
  %.470.i = select i1 %.469.i, i64 %arg.batch.1.0.5.0, i64 0
  %9 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i10635
  %.484.i10636 = getelementptr i64, ptr %9, i64 %.470.i
  %.485.i10637 = load i64, ptr %.484.i10636, align 8, !noalias !0
  %.540.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.780.010905
  store i64 %.236.i, ptr %.540.i, align 8, !noalias !0
  %.595.i = getelementptr i64, ptr %1, i64 %.780.010905
  store i64 %.485.i10637, ptr %.595.i, align 8, !noalias !0
  %.654.i = getelementptr i64, ptr %2, i64 %.780.010905
  store i64 1, ptr %.654.i, align 8, !noalias !0
  %.709.i = getelementptr i64, ptr %3, i64 %.780.010905
  store i64 0, ptr %.709.i, align 8, !noalias !0
  br i1 %.8051131.not.i, label %B402.i, label %B358.if.lr.ph.i

B358.if.lr.ph.i:                                  ; preds = %B132.i
  %.867.i = select i1 %.438.i, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i = add i64 %.867.i, %.236.i
  %.888.i = mul i64 %.868.i, %arg.batch.0.1.5.1
  %10 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i
  %invariant.gep11131 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.780.010905
  br label %B358.if.i

B402.i:                                           ; preds = %B358.if.i, %B132.i
  br i1 %.175.i1134.not.i, label %B402.endif.i, label %B76.if.i.lr.ph.i

B76.if.i.lr.ph.i:                                 ; preds = %B402.i
  %.990.i = load i64, ptr %.595.i, align 8, !noalias !0
  %.236.i.i = icmp slt i64 %.990.i, 0
  %.237.i.i10639 = select i1 %.236.i.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i = add i64 %.237.i.i10639, %.990.i
  %.258.i.i = mul i64 %.238.i.i, %arg.batch.1.3.5.1
  %11 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i
  br label %B76.if.i.i10640

B76.if.i.i10640:                                  ; preds = %B76.if.i.i10640, %B76.if.i.lr.ph.i
  %.117.i.01135.i = phi i64 [ 0, %B76.if.i.lr.ph.i ], [ %.188.i.i, %B76.if.i.i10640 ]
  %.188.i.i = add nsw i64 %.117.i.01135.i, 1
  %12 = getelementptr double, ptr %11, i64 %.117.i.01135.i
  %.263.i.i = load double, ptr %12, align 8, !noalias !3
  %13 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i
  %.293.i.i = load i64, ptr %13, align 8, !noalias !3
  %.295.i.i10641 = mul nsw i64 %.293.i.i, %arg.shape.0
  %.297.i.i = add nsw i64 %.295.i.i10641, %.780.010905
  %.311.i.i = icmp slt i64 %.297.i.i, 0
  %.312.i.i = select i1 %.311.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %14 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i
  %.326.i.i = getelementptr double, ptr %14, i64 %.312.i.i
  store double %.263.i.i, ptr %.326.i.i, align 8, !noalias !3
  %exitcond1142.not.i = icmp eq i64 %.188.i.i, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i, label %B402.endif.i, label %B76.if.i.i10640

B888.i:                                           ; preds = %B580.if.i
  store double 0.000000e+00, ptr %.1877.i, align 8, !noalias !0
  br label %B502

B358.if.i:                                        ; preds = %B358.if.i, %B358.if.lr.ph.i
  %.747.01132.i = phi i64 [ 0, %B358.if.lr.ph.i ], [ %.818.i, %B358.if.i ]
  %.818.i = add nsw i64 %.747.01132.i, 1
  %15 = getelementptr double, ptr %10, i64 %.747.01132.i
  %.893.i = load double, ptr %15, align 8, !noalias !0
  %.895.i = mul nsw i64 %.747.01132.i, %arg.shape.0
  %gep11132 = getelementptr double, ptr %invariant.gep11131, i64 %.895.i
  store double %.893.i, ptr %gep11132, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.818.i, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i, label %B402.i, label %B358.if.i

B402.endif.i:                                     ; preds = %B76.if.i.i10640, %B402.i
  br i1 %.11171137.not.i, label %B580.if.i, label %B496.if.lr.ph.i

B496.if.lr.ph.i:                                  ; preds = %B402.endif.i
  %.1179.i = select i1 %.438.i, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i = add i64 %.1179.i, %.236.i
  %.1200.i = mul i64 %.1180.i, %arg.batch.0.0.5.1
  %16 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i
  %invariant.gep11133 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.780.010905
  br label %B496.if.i

B496.if.i:                                        ; preds = %B496.if.i, %B496.if.lr.ph.i
  %.1061.01138.i = phi i64 [ 0, %B496.if.lr.ph.i ], [ %.1130.i, %B496.if.i ]
  %.1130.i = add nsw i64 %.1061.01138.i, 1
  %17 = getelementptr double, ptr %16, i64 %.1061.01138.i
  %.1205.i = load double, ptr %17, align 8, !noalias !0
  %.1207.i = mul nsw i64 %.1061.01138.i, %arg.shape.0
  %gep11134 = getelementptr double, ptr %invariant.gep11133, i64 %.1207.i
  store double %.1205.i, ptr %gep11134, align 8, !noalias !0
  %exitcond1143.not.i = icmp eq i64 %.1130.i, %arg.shape.1
  br i1 %exitcond1143.not.i, label %B580.if.i, label %B496.if.i

B580.if.i:                                        ; preds = %B496.if.i, %B402.endif.i
  %invariant.gep.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.780.010905
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
  %gep.27.i = getelementptr i8, ptr %invariant.gep.i, i64 %gep.27.idx.i
  store double 0.000000e+00, ptr %gep.27.i, align 8, !noalias !0
  %.1455.i = load double, ptr %arg.batch.2.4, align 8, !noalias !0
  %.1516.i = load i64, ptr %.595.i, align 8, !noalias !0
  %.1531.i = icmp slt i64 %.1516.i, 0
  %.1532.i = select i1 %.1531.i, i64 %arg.batch.1.2.5.0, i64 0
  %18 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i
  %.1546.i = getelementptr double, ptr %18, i64 %.1532.i
  %.1547.i = load double, ptr %.1546.i, align 8, !noalias !0
  store double %.1455.i, ptr %invariant.gep.i, align 8, !noalias !0
  %.1656.i = getelementptr double, ptr %4, i64 %.780.010905
  store double %.1547.i, ptr %.1656.i, align 8, !noalias !0
  store double 1.000000e+00, ptr %.293.i10632, align 8, !noalias !0
  %.1767.i = getelementptr double, ptr %5, i64 %.780.010905
  store double 0xFFF0000000000000, ptr %.1767.i, align 8, !noalias !0
  %.1822.i = getelementptr double, ptr %6, i64 %.780.010905
  store double 0x7FF0000000000000, ptr %.1822.i, align 8, !noalias !0
  %.1877.i = getelementptr double, ptr %7, i64 %.780.010905
  %.1878.i = load double, ptr %.1877.i, align 8, !noalias !0
  %.1880.i = fcmp ueq double %.1878.i, 0xFFF0000000000000
  br i1 %.1880.i, label %B502, label %B888.i

B502:                                             ; preds = %B888.i, %B458, %B580.if.i, %B416.if
  %.1071 = load i64, ptr %280, align 8
  %.1072 = icmp sgt i64 %.1071, -1
  %.10607 = zext i1 %.1072 to i64
  %.1089 = add nsw i64 %active.4.010907, %.10607
  %.838 = icmp sgt i64 %.783.010906, 1
  br i1 %.838, label %B416.if, label %B556

B556:                                             ; preds = %B502, %B380
  %active.4.0.lcssa = phi i64 [ 0, %B380 ], [ %.1089, %B502 ]
  %.1106.not = icmp ne i64 %active.4.0.lcssa, 0
  %.1122 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.1106.not, i1 %.1122, i1 false
  br i1 %or.cond, label %B584.preheader, label %B4730

B584.preheader:                                   ; preds = %B556
  %.1166 = getelementptr i8, ptr %arg.batch.4.2.4, i64 16
  %factor.op.mul = mul i64 %arg.shape.1, 14
  %factor.op.mul11086 = mul i64 %arg.shape.1, 15
  %factor.op.mul11087 = shl i64 %arg.shape.1, 4
  %.1262 = getelementptr i8, ptr %arg.code.4, i64 8
  %.1314 = icmp sgt i64 %arg.shape.6, 0
  %.162.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx10606 = mul i64 %arg.batch.4.0.5.1, 24
  %19 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10606
  %.537.i10908 = icmp slt i64 %arg.shape.6, 1
  %.691.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.1375.not = icmp eq i64 %arg.shape.3, 0
  %.1405 = getelementptr i8, ptr %arg.code.4, i64 16
  %.1532.idx = shl i64 %.463, 4
  %.1532 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1532.idx
  %.1563 = getelementptr i8, ptr %arg.code.4, i64 80
  %.1639 = getelementptr i8, ptr %arg.code.4, i64 88
  %.1740.idx = mul i64 %.463, 136
  %.1740 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1740.idx
  %.1765.idx = mul i64 %.463, 24
  %.1765 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1765.idx
  %.1796 = getelementptr i8, ptr %arg.code.4, i64 96
  %.idx10598 = mul i64 %arg.batch.4.0.5.1, 24
  %20 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10598
  %.idx10599 = shl i64 %arg.batch.4.0.5.1, 5
  %21 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10599
  %.idx10600 = mul i64 %arg.batch.4.0.5.1, 240
  %22 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10600
  %.10608 = select i1 %.612, i64 0, i64 2
  %.792.i = icmp ne i64 %arg.shape.2, 1
  %"$phi364.4.2.i.2" = zext i1 %.792.i to i64
  %.idx10601 = mul i64 %arg.batch.4.0.5.1, 96
  %23 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10601
  %.idx10602 = shl i64 %arg.batch.4.0.5.1, 4
  %24 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10602
  %.idx10603 = shl i64 %arg.batch.4.1.5.1, 4
  %25 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10603
  %.idx10604 = shl i64 %arg.batch.4.0.5.1, 4
  %26 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10604
  %.idx10605 = mul i64 %arg.batch.4.0.5.1, 160
  %27 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10605
  %.1934 = getelementptr i8, ptr %arg.code.4, i64 64
  %.2059 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.463
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
  %.idx.i10647 = mul i64 %arg.shape.1, 152
  %30 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i10647
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
  %.520.i10642 = add i64 %arg.linear.3.0, 1
  %.434.sroa.0.02106.i = add i64 %arg.shape.1, 1
  %.831.idx.i = mul i64 %arg.batch.4.0.5.1, 152
  %.831.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.831.idx.i
  %31 = add i64 %arg.linear.3.1, %arg.linear.3.0
  %.199.i.i = add i64 %arg.linear.3.1, 1
  %.2178 = add i64 %arg.shape.2, -1
  %storemerge10523 = tail call i64 @llvm.smax.i64(i64 %.2178, i64 0)
  %.222110921.not = icmp slt i64 %.2178, 1
  %.2366.idx = mul i64 %.463, 136
  %.2366 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.2366.idx
  %.2392 = inttoptr i64 %"$phi380.0.2.0" to ptr
  %.218614.not.i = icmp sgt i64 %arg.shape.1, 0
  %or.cond10899.not = select i1 %.610, i1 %.218614.not.i, i1 false
  %.326.i10648 = mul nsw i64 %arg.shape.1, 17
  %.idx.i10650 = mul i64 %arg.shape.1, 80
  %invariant.gep10917 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i10650
  %.395.i = mul nsw i64 %arg.shape.1, 17
  %.339.i.i = add i64 %arg.linear.3.0, 1
  %invariant.gep10919 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.395.i
  %32 = add i64 %arg.linear.3.1, %arg.linear.3.0
  %.2486 = getelementptr i8, ptr %arg.code.4, i64 72
  %.2563 = icmp sgt i64 %arg.shape.3, 0
  %.2568 = icmp sgt i64 %arg.shape.6, 0
  %.idx10596 = mul i64 %arg.batch.4.0.5.1, 40
  %33 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10596
  %.idx10597 = mul i64 %arg.batch.4.0.5.1, 176
  %34 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10597
  %.idx10593 = mul i64 %arg.batch.4.0.5.1, 184
  %35 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10593
  %.idx10594 = mul i64 %arg.batch.4.0.5.1, 192
  %36 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10594
  %.idx10595 = mul i64 %arg.batch.4.0.5.1, 168
  %37 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10595
  %.idx10587 = shl i64 %arg.batch.4.1.5.1, 4
  %38 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10587
  %.idx10588 = mul i64 %arg.batch.4.0.5.1, 200
  %39 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10588
  %.idx10589 = mul i64 %arg.batch.4.0.5.1, 80
  %40 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10589
  %.idx10590 = mul i64 %arg.batch.4.0.5.1, 40
  %41 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10590
  %.idx10591 = mul i64 %arg.batch.4.0.5.1, 224
  %42 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10591
  %.idx10592 = mul i64 %arg.batch.4.0.5.1, 56
  %43 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10592
  %44 = or i1 %.612, %.625
  %.3958.idx = mul i64 %.463, 136
  %.3958 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3958.idx
  %.3983.idx = mul i64 %.463, 104
  %.3983 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3983.idx
  %.4023 = getelementptr i8, ptr %arg.code.4, i64 128
  %.4117 = getelementptr i8, ptr %arg.code.4, i64 120
  %.idx10586 = shl i64 %arg.batch.4.1.5.1, 5
  %45 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10586
  %.671.i2540 = getelementptr i8, ptr %arg.code.4, i64 40
  %.742.i2594 = mul i64 %arg.shape.1, %arg.shape.0
  %.idx10583 = mul i64 %arg.batch.4.0.5.1, 48
  %46 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10583
  %.287.i.i10947.not = icmp slt i64 %arg.shape.1, 1
  %.358.i.i = shl nsw i64 %arg.shape.1, 4
  %.idx10579 = mul i64 %arg.batch.4.0.5.1, 40
  %47 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10579
  %.idx10580 = shl i64 %arg.batch.4.1.5.1, 5
  %48 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10580
  %.idx10581 = mul i64 %arg.batch.4.0.5.1, 112
  %49 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10581
  %.idx10582 = mul i64 %arg.batch.4.0.5.1, 120
  %50 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10582
  %.idx10575 = mul i64 %arg.batch.4.0.5.1, 56
  %51 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10575
  %.4638.c = getelementptr i8, ptr %arg.code.4, i64 112
  %.4498.idx = mul i64 %.463, 136
  %.4498 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4498.idx
  %.4561 = getelementptr i8, ptr %arg.code.4, i64 224
  %.4638 = getelementptr i8, ptr %arg.code.4, i64 112
  %.idx10568 = shl i64 %arg.batch.4.1.5.1, 4
  %52 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10568
  %.idx10569 = mul i64 %arg.batch.4.0.5.1, 40
  %53 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10569
  %.idx10570 = mul i64 %arg.batch.4.0.5.1, 56
  %54 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10570
  %.idx10571 = mul i64 %arg.batch.4.0.5.1, 208
  %55 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10571
  %.idx10572 = mul i64 %arg.batch.4.0.5.1, 48
  %56 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10572
  %.idx10573 = shl i64 %arg.batch.4.0.5.1, 5
  %57 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10573
  %58 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx10574 = mul i64 %arg.batch.4.0.5.1, 216
  %59 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10574
  %.idx10567 = shl i64 %arg.batch.4.1.5.1, 5
  %60 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10567
  %.671.i3838 = getelementptr i8, ptr %arg.code.4, i64 40
  %.742.i3894 = mul i64 %arg.shape.1, %arg.shape.0
  %.idx10564 = mul i64 %arg.batch.4.0.5.1, 48
  %61 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10564
  %.287.i.i468210975.not = icmp slt i64 %arg.shape.1, 1
  %.358.i.i4836 = shl nsw i64 %arg.shape.1, 4
  %.idx10559 = mul i64 %arg.batch.4.0.5.1, 40
  %62 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10559
  %.idx10560 = shl i64 %arg.batch.4.1.5.1, 5
  %63 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10560
  %storemerge10561 = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.idx10562 = mul i64 %arg.batch.4.0.5.1, 112
  %64 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10562
  %.idx10563 = mul i64 %arg.batch.4.0.5.1, 120
  %65 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10563
  %.idx10555 = mul i64 %arg.batch.4.0.5.1, 56
  %66 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10555
  %67 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.221.i = getelementptr i8, ptr %67, i64 -8
  %.idx2889.i = mul i64 %arg.batch.4.0.5.1, 136
  %68 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2889.i
  %.657.i.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx2886.i = mul i64 %arg.batch.4.0.5.1, 48
  %69 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2886.i
  %.287.i.i2900.not.i = icmp slt i64 %arg.shape.1, 1
  %.358.i.i.i = shl i64 %arg.shape.1, 4
  %factor.op.mul.i.reass = mul i64 %factor.op.mul, %arg.shape.0
  %.916.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %factor.op.mul.i.reass
  %.922.i.i = mul nsw i64 %arg.shape.5, %arg.shape.0
  %.925.i.i = mul i64 %arg.shape.6, %arg.shape.0
  %.111.i49.i2906.not.i = icmp slt i64 %.925.i.i, 1
  %.984.i.i10664 = getelementptr i8, ptr %arg.code.4, i64 8
  %factor.op.mul2918.i.reass = mul i64 %factor.op.mul11086, %arg.shape.0
  %.1243.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %factor.op.mul2918.i.reass
  %.1803.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.idx2885.i = mul i64 %arg.batch.4.0.5.1, 136
  %70 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2885.i
  %.155.i.i.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx2875.i = shl i64 %arg.batch.4.1.5.1, 5
  %71 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx2875.i
  %storemerge2877.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.idx2878.i = mul i64 %arg.batch.4.0.5.1, 104
  %72 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2878.i
  %.idx2870.i = mul i64 %arg.batch.4.0.5.1, 112
  %73 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2870.i
  %.idx2871.i = mul i64 %arg.batch.4.0.5.1, 120
  %74 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2871.i
  %.1254.reass.i = mul i64 %.358.i.i.i, %arg.shape.0
  %.1274.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1254.reass.i
  %.idx2865.i = shl i64 %arg.batch.4.1.5.1, 5
  %75 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx2865.i
  %storemerge2869.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.155.i.i.i10680 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx.i10671 = mul i64 %arg.batch.4.0.5.1, 56
  %76 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i10671
  %.idx2855.i = shl i64 %arg.batch.4.1.5.1, 5
  %77 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx2855.i
  %.idx2858.i = mul i64 %arg.batch.4.0.5.1, 112
  %78 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2858.i
  %.idx2862.i = mul i64 %arg.batch.4.0.5.1, 104
  %79 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2862.i
  %.idx2859.i = mul i64 %arg.batch.4.0.5.1, 120
  %80 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2859.i
  %.idx2860.i = mul i64 %arg.batch.4.0.5.1, 40
  %81 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2860.i
  %.idx2861.i = shl i64 %arg.batch.4.0.5.1, 5
  %82 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2861.i
  %83 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.4906.not = icmp eq i64 %arg.shape.3, 0
  %.10619 = select i1 %.612, i64 1, i64 16
  %.524.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.595.i10687.reass = mul i64 %factor.op.mul11087, %arg.shape.0
  %.615.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.595.i10687.reass
  %.452.i = uitofp i64 %.10619 to double
  %.idx719.i = mul i64 %arg.batch.4.0.5.1, 48
  %84 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx719.i
  %.287.i725.not.i = icmp slt i64 %arg.shape.1, 1
  %.358.i.i10688 = shl nsw i64 %arg.shape.1, 4
  %.idx.i10689 = mul i64 %arg.batch.4.0.5.1, 40
  %85 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i10689
  %.idx717.i = mul i64 %arg.batch.4.0.5.1, 112
  %86 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx717.i
  %.idx718.i = mul i64 %arg.batch.4.0.5.1, 120
  %87 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx718.i
  %.155.i.i.i10693 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i10700 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i10701 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i10702 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i10703 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i10704 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i10705 = mul nsw i64 %arg.shape.1, 18
  %factor.op.mul652.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx.i10718 = shl i64 %arg.batch.4.1.5.1, 4
  %88 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx.i10718
  %.idx640.i = mul i64 %arg.batch.4.0.5.1, 40
  %89 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx640.i
  %.idx641.i = mul i64 %arg.batch.4.0.5.1, 48
  %90 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx641.i
  %.idx642.i = mul i64 %arg.batch.4.0.5.1, 56
  %91 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx642.i
  %.924649.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx644.i = mul i64 %arg.batch.4.0.5.1, 216
  %92 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx644.i
  %.1000.i10719 = mul nsw i64 %arg.shape.1, 17
  %93 = add i64 %arg.batch.2.5.0, -1
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.5142 = icmp sgt i64 %arg.shape.0, 1
  %.5196.idx = mul i64 %arg.batch.4.0.5.1, 40
  %.5196 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.5196.idx
  %.5228 = getelementptr i8, ptr %arg.code.4, i64 104
  %.idx10548 = mul i64 %arg.batch.4.0.5.1, 104
  %94 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10548
  %.idx10549 = mul i64 %arg.batch.4.0.5.1, 40
  %95 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10549
  %.idx10550 = shl i64 %arg.batch.4.0.5.1, 7
  %96 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10550
  %.552.i656311064.not = icmp slt i64 %arg.shape.1, 1
  %.697.i6600 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %97 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.742.i6630 = getelementptr i8, ptr %97, i64 -8
  %.idx10552 = mul i64 %arg.batch.4.1.5.1, 24
  %98 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10552
  %.idx10553 = mul i64 %arg.batch.4.1.5.1, 24
  %99 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10553
  %.idx10554 = mul i64 %arg.batch.4.0.5.1, 24
  %100 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10554
  %.5344.not = icmp ne i64 %arg.shape.4, 0
  %storemerge.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.0, i64 0)
  %.idx1632.i = mul i64 %arg.batch.4.0.5.1, 40
  %101 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1632.i
  %.idx1633.i = shl i64 %arg.batch.4.0.5.1, 4
  %102 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1633.i
  %103 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.175.i3061635.not.i = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.636.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.779.i = getelementptr i8, ptr %arg.code.4, i64 32
  %.850.i = mul nsw i64 %arg.shape.1, 17
  %.852.i = mul nsw i64 %.850.i, %arg.shape.0
  %.895.i10735 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.852.i
  %.900.not.i = icmp eq i64 %arg.shape.3, 0
  %.930.i10736 = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx1630.i = shl i64 %arg.batch.4.1.5.1, 4
  %104 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1630.i
  %.15441642.not.i = icmp slt i64 %arg.shape.1, 1
  %.1739.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx10537 = mul i64 %arg.batch.4.0.5.1, 40
  %105 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10537
  %.idx10538 = shl i64 %arg.batch.4.0.5.1, 4
  %106 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10538
  %107 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx10539 = mul i64 %arg.batch.4.0.5.1, 24
  %108 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10539
  %.175.i.i799411076.not = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.idx10542 = shl i64 %arg.batch.4.1.5.1, 4
  %109 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10542
  %.idx.i10749 = mul i64 %arg.batch.4.0.5.1, 24
  %110 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i10749
  %.323.i10751 = getelementptr i8, ptr %arg.batch.4.2.4, i64 8
  %111 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx1124.i10771 = mul i64 %arg.batch.4.1.5.1, 24
  %112 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1124.i10771
  %.8051131.not.i10773 = icmp slt i64 %arg.batch.0.1.5.1, 1
  %.175.i1134.not.i10789 = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.11171137.not.i10808 = icmp slt i64 %arg.shape.1, 1
  %gep.2.idx.i10826 = shl i64 %arg.batch.4.0.5.1, 4
  %gep.4.idx.i10830 = shl i64 %arg.batch.4.0.5.1, 5
  %gep.6.idx.i10834 = mul i64 %arg.batch.4.0.5.1, 48
  %gep.7.idx.i10836 = mul i64 %arg.batch.4.0.5.1, 56
  %gep.9.idx.i10840 = mul i64 %arg.batch.4.0.5.1, 72
  %gep.10.idx.i10842 = mul i64 %arg.batch.4.0.5.1, 80
  %gep.11.idx.i10844 = mul i64 %arg.batch.4.0.5.1, 88
  %gep.12.idx.i10846 = mul i64 %arg.batch.4.0.5.1, 96
  %gep.13.idx.i10848 = mul i64 %arg.batch.4.0.5.1, 104
  %gep.14.idx.i10850 = mul i64 %arg.batch.4.0.5.1, 112
  %gep.15.idx.i10852 = mul i64 %arg.batch.4.0.5.1, 120
  %gep.16.idx.i10854 = shl i64 %arg.batch.4.0.5.1, 7
  %gep.17.idx.i10856 = mul i64 %arg.batch.4.0.5.1, 136
  %gep.18.idx.i10858 = mul i64 %arg.batch.4.0.5.1, 144
  %gep.19.idx.i10860 = mul i64 %arg.batch.4.0.5.1, 152
  %gep.20.idx.i10862 = mul i64 %arg.batch.4.0.5.1, 160
  %gep.21.idx.i10864 = mul i64 %arg.batch.4.0.5.1, 168
  %gep.22.idx.i10866 = mul i64 %arg.batch.4.0.5.1, 176
  %gep.23.idx.i10868 = mul i64 %arg.batch.4.0.5.1, 184
  %gep.24.idx.i10870 = mul i64 %arg.batch.4.0.5.1, 192
  %gep.25.idx.i10872 = mul i64 %arg.batch.4.0.5.1, 200
  %gep.26.idx.i10874 = mul i64 %arg.batch.4.0.5.1, 208
  %gep.27.idx.i10876 = mul i64 %arg.batch.4.0.5.1, 216
  %113 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i10826
  %114 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.16.idx.i10854
  %115 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.27.idx.i10876
  %.idx1130.i10891 = mul i64 %arg.batch.4.0.5.1, 224
  %116 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i10891
  %.idx10541 = mul i64 %arg.batch.4.0.5.1, 224
  %117 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10541
  %.6412 = tail call i64 @llvm.smin.i64(i64 %arg.batch.2.5.0, i64 0)
  %118 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %119 = getelementptr i8, ptr %118, i64 -8
  %.6426 = getelementptr double, ptr %119, i64 %.6412
  %120 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx10543 = mul i64 %arg.batch.4.0.5.1, 224
  %121 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10543
  %.idx10544 = mul i64 %arg.batch.4.0.5.1, 168
  %122 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10544
  %.idx10545 = shl i64 %arg.batch.4.1.5.1, 4
  %123 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10545
  %.idx10546 = shl i64 %arg.batch.4.0.5.1, 4
  %124 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10546
  %.idx10547 = mul i64 %arg.batch.4.0.5.1, 160
  %125 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10547
  %126 = shl i64 %arg.shape.0, 3
  %.155.i.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.i.1 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.i.2 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.i.3 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.i.4 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.i.5 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.i.6 = mul nsw i64 %arg.shape.1, 18
  %127 = getelementptr i8, ptr %arg.code.4, i64 232
  %.4523.idx = mul i64 %.463, 112
  %.4523 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4523.idx
  %128 = getelementptr i8, ptr %arg.code.4, i64 240
  %.4523.1.idx = mul i64 %.463, 120
  %.4523.1 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4523.1.idx
  %129 = getelementptr i8, ptr %arg.code.4, i64 248
  %.4523.2.idx = shl i64 %.463, 7
  %.4523.2 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4523.2.idx
  %.155.i.i.i4873 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.i4873.1 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.i4873.2 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.i4873.3 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.i4873.4 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.i4873.5 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.i4873.6 = mul nsw i64 %arg.shape.1, 18
  br label %B584

B584:                                             ; preds = %B584.preheader, %B4704
  %budget.3.1 = phi i64 [ %budget.4.2, %B4704 ], [ %arg.budget, %B584.preheader ]
  %active.9.1 = phi i64 [ %active.8.2, %B4704 ], [ %active.4.0.lcssa, %B584.preheader ]
  %.1132 = add nsw i64 %budget.3.1, -1
  %.1167 = load i64, ptr %.1166, align 8
  %.1168 = icmp eq i64 %.1167, 1
  %.1202 = icmp sgt i64 %.1167, 0
  br i1 %.1202, label %B652, label %B730

B652:                                             ; preds = %B584
  store i64 0, ptr %.1166, align 8
  %.1263 = load i64, ptr %.1262, align 8
  %.1308 = inttoptr i64 %.1263 to ptr
  tail call void %.1308(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B730

B730:                                             ; preds = %B652, %B584
  br i1 %.1168, label %B736, label %B1302

B736:                                             ; preds = %B730
  br i1 %.1314, label %B748, label %B784

B748:                                             ; preds = %B736
  %.163.i = load i64, ptr %.162.i, align 8, !noalias !7
  %.275.i = inttoptr i64 %.163.i to ptr
  tail call void %.275.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br i1 %.794, label %B326.i, label %B194.if.i

B324.i:                                           ; preds = %B266.if.i, %B194.if.i
  %.359.i = icmp sgt i64 %.304.i.010913, 1
  br i1 %.359.i, label %B194.if.i, label %B326.i

B326.i:                                           ; preds = %B324.i, %B748
  %.692.i = load i64, ptr %.691.i, align 8, !noalias !7
  %.808.i = inttoptr i64 %.692.i to ptr
  tail call void %.808.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br label %B784

B194.if.i:                                        ; preds = %B748, %B324.i
  %.304.i.010913 = phi i64 [ %.368.i, %B324.i ], [ %storemerge, %B748 ]
  %.301.i.010912 = phi i64 [ %.372.i, %B324.i ], [ 0, %B748 ]
  %.368.i = add nsw i64 %.304.i.010913, -1
  %.372.i = add nsw i64 %.301.i.010912, 1
  %130 = getelementptr double, ptr %19, i64 %.301.i.010912
  %.454.i = load double, ptr %130, align 8, !noalias !7
  %.455.i = fcmp ule double %.454.i, 5.000000e-01
  %brmerge11091 = select i1 %.455.i, i1 true, i1 %.537.i10908
  br i1 %brmerge11091, label %B324.i, label %B266.if.i.preheader

B266.if.i.preheader:                              ; preds = %B194.if.i
  %invariant.gep11135 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.301.i.010912
  br label %B266.if.i

B266.if.i:                                        ; preds = %B266.if.i.preheader, %B266.if.i
  %.481.i.010909 = phi i64 [ %.550.i, %B266.if.i ], [ 0, %B266.if.i.preheader ]
  %.550.i = add nsw i64 %.481.i.010909, 1
  %.576.i = mul nsw i64 %.481.i.010909, %arg.shape.0
  %gep11136 = getelementptr double, ptr %invariant.gep11135, i64 %.576.i
  %.608.i = load double, ptr %gep11136, align 8, !noalias !7
  %.610.i = add nsw i64 %.481.i.010909, %arg.shape.5
  %.612.i = mul nsw i64 %.610.i, %arg.shape.0
  %.614.i = add nsw i64 %.612.i, %.301.i.010912
  %.628.i = icmp slt i64 %.614.i, 0
  %.629.i = select i1 %.628.i, i64 %arg.batch.5.1.5.0, i64 0
  %131 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.614.i
  %.643.i = getelementptr double, ptr %131, i64 %.629.i
  store double %.608.i, ptr %.643.i, align 8, !noalias !7
  %exitcond.not = icmp eq i64 %.550.i, %arg.shape.6
  br i1 %exitcond.not, label %B324.i, label %B266.if.i

B784:                                             ; preds = %B326.i, %B736
  br i1 %.1375.not, label %B856, label %B788

B788:                                             ; preds = %B784
  %.1406 = load i64, ptr %.1405, align 8
  %.1451 = inttoptr i64 %.1406 to ptr
  tail call void %.1451(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B856

B856:                                             ; preds = %B788, %B784
  br i1 %.612, label %B1260, label %B860

B860:                                             ; preds = %B856
  %.1485 = load i64, ptr %arg.code.4, align 8
  %.1533 = inttoptr i64 %.1485 to ptr
  tail call void %.1533(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1532)
  %.1564 = load i64, ptr %.1563, align 8
  %.1609 = inttoptr i64 %.1564 to ptr
  tail call void %.1609(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.1640 = load i64, ptr %.1639, align 8
  %.1685 = inttoptr i64 %.1640 to ptr
  tail call void %.1685(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.1716 = load i64, ptr %arg.code.4, align 8
  %.1766 = inttoptr i64 %.1716 to ptr
  tail call void %.1766(ptr %.571, ptr %.1740, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1765)
  %.1797 = load i64, ptr %.1796, align 8
  %.1842 = inttoptr i64 %.1797 to ptr
  tail call void %.1842(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B1260

B1260:                                            ; preds = %B860, %B856
  br i1 %.794, label %B1302, label %B64.if.i

B108.i:                                           ; preds = %B64.if.i
  store double 0.000000e+00, ptr %.314.i134, align 8, !noalias !11
  %.432.i191 = getelementptr double, ptr %21, i64 %.161.i.010915
  store double 0.000000e+00, ptr %.432.i191, align 8, !noalias !11
  %.487.i = getelementptr double, ptr %22, i64 %.161.i.010915
  store double 0.000000e+00, ptr %.487.i, align 8, !noalias !11
  %.542.i244 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.010915
  %.543.i245 = load i64, ptr %.542.i244, align 8, !noalias !11
  %.570.i = icmp slt i64 %.543.i245, 0
  %.571.i = select i1 %.570.i, i64 %arg.batch.3.3.5.0, i64 0
  %.572.i257 = add i64 %.571.i, %.543.i245
  %.592.i271 = mul i64 %.572.i257, %arg.batch.3.3.5.1
  %132 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.592.i271
  %.596.i = getelementptr i8, ptr %132, i64 8
  %.597.i275 = load i64, ptr %.596.i, align 8, !noalias !11
  %.620.i282 = add nsw i64 %.597.i275, %.10608
  store i64 %.620.i282, ptr %.596.i, align 8, !noalias !11
  %.736.i = load i64, ptr %.542.i244, align 8, !noalias !11
  %.763.i354 = icmp slt i64 %.736.i, 0
  %.764.i = select i1 %.763.i354, i64 %arg.batch.3.3.5.0, i64 0
  %.765.i355 = add i64 %.764.i, %.736.i
  %.785.i = mul i64 %.765.i355, %arg.batch.3.3.5.1
  %133 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.785.i
  %.789.i369 = getelementptr i8, ptr %133, i64 16
  %.790.i = load i64, ptr %.789.i369, align 8, !noalias !11
  %.813.i = add nsw i64 %.790.i, %"$phi364.4.2.i.2"
  store i64 %.813.i, ptr %.789.i369, align 8, !noalias !11
  %.928.i = getelementptr double, ptr %23, i64 %.161.i.010915
  %.929.i = load double, ptr %.928.i, align 8, !noalias !11
  %.930.i = fcmp une double %.929.i, 0.000000e+00
  br i1 %.930.i, label %B414.i, label %B460.i

B414.i:                                           ; preds = %B108.i
  %134 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.010915
  %.84.i.i = load i64, ptr %134, align 8, !noalias !15
  %.89.i.i = icmp sgt i64 %.84.i.i, -1
  br i1 %.89.i.i, label %B46.i.i, label %B460.i

B46.i.i:                                          ; preds = %B414.i
  %.120.i.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i
  %.121.i.i = load i64, ptr %.120.i.i, align 8, !noalias !15
  %.122.i.i = icmp eq i64 %.121.i.i, 0
  br i1 %.122.i.i, label %B80.i.i, label %B460.i

B80.i.i:                                          ; preds = %B46.i.i
  store i64 3, ptr %.120.i.i, align 8, !noalias !15
  br label %B460.i

B460.i:                                           ; preds = %B80.i.i, %B414.i, %B46.i.i, %B108.i
  br i1 %.1375.not, label %B596.i, label %B464.i

B464.i:                                           ; preds = %B460.i
  %135 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.010915
  %.1000.i = load double, ptr %135, align 8, !noalias !11
  %.1002.i = fcmp olt double %.1000.i, -1.000000e-09
  br i1 %.1002.i, label %B500.i, label %B596.i

B500.i:                                           ; preds = %B464.i
  %136 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.010915
  %.84.i63.i = load i64, ptr %136, align 8, !noalias !18
  %.89.i66.i = icmp sgt i64 %.84.i63.i, -1
  br i1 %.89.i66.i, label %B46.i71.i, label %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

B46.i71.i:                                        ; preds = %B500.i
  %.120.i91.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i63.i
  %.121.i92.i = load i64, ptr %.120.i91.i, align 8, !noalias !18
  %.122.i93.i = icmp eq i64 %.121.i92.i, 0
  br i1 %.122.i93.i, label %B80.i98.i, label %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

B80.i98.i:                                        ; preds = %B46.i71.i
  store i64 4, ptr %.120.i91.i, align 8, !noalias !18
  br label %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i: ; preds = %B46.i71.i, %B500.i, %B80.i98.i
  %.1091.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.161.i.010915
  %.1092.i = load double, ptr %.1091.i, align 8, !noalias !11
  %.1146.i = getelementptr double, ptr %24, i64 %.161.i.010915
  store double %.1092.i, ptr %.1146.i, align 8, !noalias !11
  br label %B596.i

B596.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i, %B464.i, %B460.i
  %.111.i183.i = getelementptr i64, ptr %25, i64 %.161.i.010915
  %.112.i.i = load i64, ptr %.111.i183.i, align 8, !noalias !21
  %.169.i.i = getelementptr double, ptr %26, i64 %.161.i.010915
  %.170.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.224.i.i = getelementptr double, ptr %27, i64 %.161.i.010915
  store double %.170.i.i, ptr %.224.i.i, align 8, !noalias !21
  %.237.i.i = icmp slt i64 %.112.i.i, %arg.batch.2.5.0
  br i1 %.237.i.i, label %B134.i.i, label %B630.i

B134.i.i:                                         ; preds = %B596.i
  %.253.i.i = icmp slt i64 %.112.i.i, 0
  %.254.i.i = select i1 %.253.i.i, i64 %arg.batch.2.5.0, i64 0
  %137 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i.i
  %.268.i.i = getelementptr double, ptr %137, i64 %.254.i.i
  %.269.i.i = load double, ptr %.268.i.i, align 8, !noalias !21
  %.328.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.10.i.i.i = fcmp olt double %.328.i.i, %.269.i.i
  %.11.i.i.i = select i1 %.10.i.i.i, double %.328.i.i, double %.269.i.i
  store double %.11.i.i.i, ptr %.224.i.i, align 8, !noalias !21
  br label %B630.i

B630.i:                                           ; preds = %B134.i.i, %B596.i, %B64.if.i
  %.220.i = icmp sgt i64 %.164.i70.010916, 1
  br i1 %.220.i, label %B64.if.i, label %B1302

B64.if.i:                                         ; preds = %B1260, %B630.i
  %.164.i70.010916 = phi i64 [ %.229.i381, %B630.i ], [ %storemerge, %B1260 ]
  %.161.i.010915 = phi i64 [ %.233.i384, %B630.i ], [ 0, %B1260 ]
  %.229.i381 = add nsw i64 %.164.i70.010916, -1
  %.233.i384 = add nsw i64 %.161.i.010915, 1
  %.314.i134 = getelementptr double, ptr %20, i64 %.161.i.010915
  %.315.i135 = load double, ptr %.314.i134, align 8, !noalias !11
  %.316.i136 = fcmp ogt double %.315.i135, 5.000000e-01
  br i1 %.316.i136, label %B108.i, label %B630.i

B1302:                                            ; preds = %B630.i, %B1260, %B730
  %.1935 = load i64, ptr %.1934, align 8
  %.1980 = inttoptr i64 %.1935 to ptr
  tail call void %.1980(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.612, label %B1374, label %B1458

B1374:                                            ; preds = %B1302
  %.2013 = load i64, ptr %arg.code.4, align 8
  %.2060 = inttoptr i64 %.2013 to ptr
  tail call void %.2060(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.2059)
  br label %B1458

B1458:                                            ; preds = %B1374, %B1302
  br i1 %.610, label %B1462, label %B1502

B1462:                                            ; preds = %B1458
  %.267.i = load double, ptr %.266.i, align 8, !noalias !25
  %.268.i = fcmp olt double %.267.i, 5.000000e-01
  br i1 %.268.i, label %B76.i, label %B116.i

B76.i:                                            ; preds = %B1462
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
  %138 = getelementptr i64, ptr %arg.linear.6.4, i64 %.537.i.sroa.0.02147.i
  %.990.i.i = getelementptr i64, ptr %138, i64 %.976.i.i
  %.991.i.i = load i64, ptr %.990.i.i, align 8, !noalias !28
  %.1007.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, -1
  %.1008.i.i = select i1 %.1007.i.i, i64 %arg.linear.6.5.0, i64 0
  %139 = getelementptr i8, ptr %138, i64 8
  %.1022.i.i = getelementptr i64, ptr %139, i64 %.1008.i.i
  %.1023.i.i = load i64, ptr %.1022.i.i, align 8, !noalias !28
  %.1060.i.i = sub i64 %.1023.i.i, %.991.i.i
  %.1106.i2123.not.i = icmp slt i64 %.1060.i.i, 1
  br i1 %.1106.i2123.not.i, label %B702.i.i, label %B536.if.i.i

B544.i.i:                                         ; preds = %B536.if.i.i
  %.1173.i.i = icmp slt i64 %.1047.i.02124.i, 0
  %.1174.i.i = select i1 %.1173.i.i, i64 %arg.linear.7.5.0, i64 0
  %140 = getelementptr i64, ptr %arg.linear.7.4, i64 %.1047.i.02124.i
  %.1188.i.i = getelementptr i64, ptr %140, i64 %.1174.i.i
  %.1189.i.i = load i64, ptr %.1188.i.i, align 8, !noalias !28
  %.1190.i.i = add nsw i64 %.1189.i.i, %.915.i.i
  %.1204.i.i = icmp slt i64 %.1190.i.i, 0
  %.1205.i.i = select i1 %.1204.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %141 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1190.i.i
  %.1219.i.i = getelementptr double, ptr %141, i64 %.1205.i.i
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
  %142 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02131.1.i
  %.906.i.i.1.i = load double, ptr %142, align 8, !noalias !32
  %143 = getelementptr double, ptr %142, i64 %.597.i.i.i
  %.939.i.i.1.i = load double, ptr %143, align 8, !noalias !32
  %.941.i.i.1.i = fmul double %.939.i.i.1.i, 5.000000e-01
  %144 = fsub double %.906.i.i.1.i, %.941.i.i.1.i
  %145 = getelementptr double, ptr %142, i64 %.944.i.i.i
  store double %144, ptr %145, align 8, !noalias !32
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
  %146 = fsub double %.1034.i.i.1.i, %.1070.i.i.1.i
  store double %146, ptr %.571, align 8, !noalias !32
  %.1157.i.i.1.i = load i64, ptr %arg.code.4, align 8, !noalias !32
  %.1277.i.i.1.i = inttoptr i64 %.1157.i.i.1.i to ptr
  tail call void %.1277.i.i.1.i(ptr nonnull %.571, ptr %.933.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1276.i.i.1.i), !noalias !32
  br i1 %.317.i2117.not.i, label %B702.i.i, label %B780.if.i.i.i

B966.i.i.i:                                       ; preds = %B780.if.i.i.i
  %.1601.i.i.i = fsub double %.1513.i.i.i, %.1548.i.i.i
  br label %B1053.i.i.i

B1006.i.i.i:                                      ; preds = %B780.if.i.i.i
  %147 = getelementptr double, ptr %155, i64 %arg.shape.1
  %.1582.i.i.i = load double, ptr %147, align 8, !noalias !32
  %.1647.i.i.i = fsub double %.1513.i.i.i, %.1582.i.i.i
  %.1652.i.i.i = fmul double %.1647.i.i.i, 2.000000e+00
  br label %B1053.i.i.i

B1053.i.i.i:                                      ; preds = %B1006.i.i.i, %B966.i.i.i
  %storemerge2111.i = phi double [ %.1652.i.i.i, %B1006.i.i.i ], [ %.1601.i.i.i, %B966.i.i.i ]
  store double %storemerge2111.i, ptr %157, align 8, !noalias !32
  %exitcond2157.not.i = icmp eq i64 %arg.shape.1, %.1387.i.i.i
  br i1 %exitcond2157.not.i, label %B702.i.i, label %B780.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B660.i.i, %B84.if.i.i.i
  %.212.i.i.02129.i = phi i64 [ %.283.i.i.i, %B84.if.i.i.i ], [ 0, %B660.i.i ]
  %.283.i.i.i = add nsw i64 %.212.i.i.02129.i, 1
  %148 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.212.i.i.02129.i
  %.341.i.i.i = load double, ptr %148, align 8, !noalias !32
  %.342.i.i.i = tail call double @llvm.fabs.f64(double %.341.i.i.i)
  %.10.i.i.i.i = fcmp ogt double %.184.i.i.i, %.342.i.i.i
  %.11.i.i.i.i = select i1 %.10.i.i.i.i, double %.184.i.i.i, double %.342.i.i.i
  %.377.i.i.i = fcmp ogt double %.11.i.i.i.i, 0.000000e+00
  %149 = fmul double %.11.i.i.i.i, 1.200000e-05
  %"$phi194.2.2.i.i.1.i" = select i1 %.377.i.i.i, double %149, double 1.200000e-05
  %150 = getelementptr i64, ptr %arg.linear.5.4, i64 %.212.i.i.02129.i
  %.434.i.i.i = load i64, ptr %150, align 8, !noalias !32
  %.436.i.i.i = icmp eq i64 %.434.i.i.i, %.537.i.sroa.0.02147.i
  %"$phi230.1.2.i.i.1.i" = select i1 %.436.i.i.i, double %"$phi194.2.2.i.i.1.i", double 0.000000e+00
  %151 = getelementptr i8, ptr %148, i64 %.idx2162.i
  store double %"$phi230.1.2.i.i.1.i", ptr %151, align 8, !noalias !32
  %exitcond2154.not.i = icmp eq i64 %arg.shape.1, %.283.i.i.i
  br i1 %exitcond2154.not.i, label %B262.i.i.i, label %B84.if.i.i.i

B428.if.i.i.i:                                    ; preds = %B324.i.i.i, %B428.if.i.i.i
  %.783.i.i.02131.i = phi i64 [ %.852.i.i.i, %B428.if.i.i.i ], [ 0, %B324.i.i.i ]
  %.852.i.i.i = add nsw i64 %.783.i.i.02131.i, 1
  %152 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.783.i.i.02131.i
  %.906.i.i.i = load double, ptr %152, align 8, !noalias !32
  %153 = getelementptr double, ptr %152, i64 %.597.i.i.i
  %.939.i.i.i = load double, ptr %153, align 8, !noalias !32
  %.941.i.i.i = fmul double %.939.i.i.i, 5.000000e-01
  %.942.i.i.i = fadd double %.906.i.i.i, %.941.i.i.i
  %154 = getelementptr double, ptr %152, i64 %.944.i.i.i
  store double %.942.i.i.i, ptr %154, align 8, !noalias !32
  %exitcond2155.not.i = icmp eq i64 %arg.shape.1, %.852.i.i.i
  br i1 %exitcond2155.not.i, label %B524.i.i.i, label %B428.if.i.i.i

B780.if.i.i.i:                                    ; preds = %B524.i.i.1.i, %B1053.i.i.i
  %.1318.i.i.02136.i = phi i64 [ %.1387.i.i.i, %B1053.i.i.i ], [ 0, %B524.i.i.1.i ]
  %.1387.i.i.i = add nsw i64 %.1318.i.i.02136.i, 1
  %155 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1318.i.i.02136.i
  %.1445.i.i.i = load double, ptr %155, align 8, !noalias !32
  %156 = getelementptr i8, ptr %155, i64 %.933.i.idx.i
  store double %.1445.i.i.i, ptr %156, align 8, !noalias !32
  %157 = getelementptr i8, ptr %155, i64 %.idx2164.i
  %.1513.i.i.i = load double, ptr %157, align 8, !noalias !32
  %158 = getelementptr i8, ptr %155, i64 %.1276.i.i.1.idx.i
  %.1548.i.i.i = load double, ptr %158, align 8, !noalias !32
  %.1594.i.i.i = fsub double %.1548.i.i.i, %.1548.i.i.i
  %.1595.i.i.i = fcmp oeq double %.1594.i.i.i, 0.000000e+00
  br i1 %.1595.i.i.i, label %B966.i.i.i, label %B1006.i.i.i

B702.i.i:                                         ; preds = %B1053.i.i.i, %B524.i.i.1.i, %B656.i.i, %B352.i.i
  %.1384.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, 0
  %.1385.i.i = select i1 %.1384.i.i, i64 %arg.linear.6.5.0, i64 0
  %159 = getelementptr i64, ptr %arg.linear.6.4, i64 %.537.i.sroa.0.02147.i
  %.1399.i.i = getelementptr i64, ptr %159, i64 %.1385.i.i
  %.1400.i.i = load i64, ptr %.1399.i.i, align 8, !noalias !28
  %.1418.i.i = icmp slt i64 %.537.i.sroa.0.02147.i, -1
  %.1419.i.i = select i1 %.1418.i.i, i64 %arg.linear.6.5.0, i64 0
  %160 = getelementptr i8, ptr %159, i64 8
  %.1433.i.i = getelementptr i64, ptr %160, i64 %.1419.i.i
  %.1434.i.i = load i64, ptr %.1433.i.i, align 8, !noalias !28
  %.1471.i.i = sub i64 %.1434.i.i, %.1400.i.i
  %.1514.i2138.not.i = icmp slt i64 %.1471.i.i, 1
  br i1 %.1514.i2138.not.i, label %B228.i.loopexit.i, label %B764.if.i.i

B920.i.i:                                         ; preds = %B764.if.i.i
  %.1782.i.i = add nsw i64 %.1587.i.i, %.1748.i.i
  %.1797.i.i = icmp slt i64 %.1782.i.i, 0
  %.1798.i.i = select i1 %.1797.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %161 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1782.i.i
  %.1812.i.i = getelementptr double, ptr %161, i64 %.1798.i.i
  store double %.1686.i..i, ptr %.1812.i.i, align 8, !noalias !28
  br label %B995.i.i

B966.i.i:                                         ; preds = %B764.if.i.i
  %.1832.i.i = select i1 %.1571.i.i, i64 %arg.linear.9.5.0, i64 0
  %162 = getelementptr i64, ptr %arg.linear.9.4, i64 %.1458.i.02139.i
  %.1846.i.i = getelementptr i64, ptr %162, i64 %.1832.i.i
  %.1847.i.i = load i64, ptr %.1846.i.i, align 8, !noalias !28
  %.1864.i.i = icmp slt i64 %.1847.i.i, 0
  %.1865.i.i = select i1 %.1864.i.i, i64 %arg.linear.0.5.0, i64 0
  %163 = getelementptr double, ptr %arg.linear.0.4, i64 %.1847.i.i
  %.1879.i.i = getelementptr double, ptr %163, i64 %.1865.i.i
  store double %.1686.i..i, ptr %.1879.i.i, align 8, !noalias !28
  br label %B995.i.i

B995.i.i:                                         ; preds = %B966.i.i, %B920.i.i
  %.1514.i.i = icmp sgt i64 %.1461.i.02140.i, 1
  br i1 %.1514.i.i, label %B764.if.i.i, label %B228.i.loopexit.i

B84.if.i.i:                                       ; preds = %B76.i, %B84.if.i.i
  %.259.i.02118.i = phi i64 [ %.330.i.i, %B84.if.i.i ], [ 0, %B76.i ]
  %.330.i.i = add nsw i64 %.259.i.02118.i, 1
  %164 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.259.i.02118.i
  %.384.i.i = load double, ptr %164, align 8, !noalias !28
  %165 = getelementptr i8, ptr %164, i64 %.idx2159.i
  store double %.384.i.i, ptr %165, align 8, !noalias !28
  %166 = getelementptr i8, ptr %164, i64 %.idx2160.i
  store double 0.000000e+00, ptr %166, align 8, !noalias !28
  %exitcond.not.i10646 = icmp eq i64 %arg.shape.1, %.330.i.i
  br i1 %exitcond.not.i10646, label %B166.i.i, label %B84.if.i.i

B286.if.i.i:                                      ; preds = %B250.i.i, %B286.if.i.i
  %.629.i.02122.i = phi i64 [ %.691.i.i, %B286.if.i.i ], [ %storemerge2107.i, %B250.i.i ]
  %.626.i.02121.i = phi i64 [ %.695.i.i, %B286.if.i.i ], [ 0, %B250.i.i ]
  %.691.i.i = add nsw i64 %.629.i.02122.i, -1
  %.695.i.i = add nsw i64 %.626.i.02121.i, 1
  %167 = getelementptr i64, ptr %arg.linear.5.4, i64 %.626.i.02121.i
  %.753.i.i = load i64, ptr %167, align 8, !noalias !28
  %.755.i.i = icmp eq i64 %.753.i.i, %.537.i.sroa.0.02147.i
  %..i = select i1 %.755.i.i, double 1.000000e+00, double 0.000000e+00
  %gep = getelementptr double, ptr %invariant.gep, i64 %.626.i.02121.i
  store double %..i, ptr %gep, align 8, !noalias !28
  %.682.i.i = icmp sgt i64 %.629.i.02122.i, 1
  br i1 %.682.i.i, label %B286.if.i.i, label %B352.i.i

B536.if.i.i:                                      ; preds = %B352.i.i, %B652.i.i
  %known.2.i.22126.i = phi i1 [ %"$phi652.2.2.i.3.i", %B652.i.i ], [ true, %B352.i.i ]
  %.1050.i.02125.i = phi i64 [ %.1115.i.i, %B652.i.i ], [ %.1060.i.i, %B352.i.i ]
  %.1047.i.02124.i = phi i64 [ %.1119.i.i, %B652.i.i ], [ %.991.i.i, %B352.i.i ]
  %.1115.i.i = add nsw i64 %.1050.i.02125.i, -1
  %.1119.i.i = add i64 %.1047.i.02124.i, 1
  br i1 %known.2.i.22126.i, label %B544.i.i, label %B652.i.i

B764.if.i.i:                                      ; preds = %B702.i.i, %B995.i.i
  %.1461.i.02140.i = phi i64 [ %.1523.i.i, %B995.i.i ], [ %.1471.i.i, %B702.i.i ]
  %.1458.i.02139.i = phi i64 [ %.1527.i.i, %B995.i.i ], [ %.1400.i.i, %B702.i.i ]
  %.1523.i.i = add nsw i64 %.1461.i.02140.i, -1
  %.1527.i.i = add i64 %.1458.i.02139.i, 1
  %.1571.i.i = icmp slt i64 %.1458.i.02139.i, 0
  %.1572.i.i = select i1 %.1571.i.i, i64 %arg.linear.7.5.0, i64 0
  %168 = getelementptr i64, ptr %arg.linear.7.4, i64 %.1458.i.02139.i
  %.1586.i.i = getelementptr i64, ptr %168, i64 %.1572.i.i
  %.1587.i.i = load i64, ptr %.1586.i.i, align 8, !noalias !28
  %.1588.i.i = add nsw i64 %.1587.i.i, %.915.i.i
  %.1602.i.i = icmp slt i64 %.1588.i.i, 0
  %.1603.i.i = select i1 %.1602.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %169 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1588.i.i
  %.1617.i.i = getelementptr double, ptr %169, i64 %.1603.i.i
  %.1618.i.i = load double, ptr %.1617.i.i, align 8, !noalias !28
  %.1636.i.i = select i1 %.1571.i.i, i64 %arg.linear.8.5.0, i64 0
  %170 = getelementptr i64, ptr %arg.linear.8.4, i64 %.1458.i.02139.i
  %.1650.i.i = getelementptr i64, ptr %170, i64 %.1636.i.i
  %.1651.i.i = load i64, ptr %.1650.i.i, align 8, !noalias !28
  %.1652.i.i = add nsw i64 %.1651.i.i, %.597.i.i.i
  %.1666.i.i = icmp slt i64 %.1652.i.i, 0
  %.1667.i.i = select i1 %.1666.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %171 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1652.i.i
  %.1681.i.i = getelementptr double, ptr %171, i64 %.1667.i.i
  %.1682.i.i = load double, ptr %.1681.i.i, align 8, !noalias !28
  %.1686.i.i = fdiv double %.1618.i.i, %.1682.i.i
  %.1692.i.i = fsub double %.1686.i.i, %.1686.i.i
  %.1693.i.i = fcmp oeq double %.1692.i.i, 0.000000e+00
  %.1686.i..i = select i1 %.1693.i.i, double %.1686.i.i, double 0.000000e+00
  %.1745.i.i = icmp eq i64 %.1651.i.i, %arg.shape.1
  br i1 %.1745.i.i, label %B920.i.i, label %B966.i.i

B116.i:                                           ; preds = %B228.i.loopexit.i, %B166.i.i, %B1462
  br i1 %.402.i, label %B146.if.i, label %B1502

B316.i:                                           ; preds = %B262.if.i, %B146.if.i
  %.746.i = mul i64 %.388.02152.i, %.434.sroa.0.02106.i
  %.762.i = icmp slt i64 %.746.i, 0
  %.763.i = select i1 %.762.i, i64 %arg.linear.1.5.0, i64 0
  %172 = getelementptr double, ptr %arg.linear.1.4, i64 %.746.i
  %.777.i = getelementptr double, ptr %172, i64 %.763.i
  %.778.i = load double, ptr %.777.i, align 8, !noalias !25
  %.832.i = load double, ptr %.831.i, align 8, !noalias !25
  %.833.i = fadd double %.778.i, %.832.i
  store double %.833.i, ptr %.777.i, align 8, !noalias !25
  %exitcond2158.not.i = icmp eq i64 %.457.i, %arg.shape.1
  br i1 %exitcond2158.not.i, label %B36.if.i.i, label %B146.if.i

B34.loopexit.i.i:                                 ; preds = %B790.i.i, %B528.i.i
  %exitcond.not.i.i = icmp eq i64 %.131.i.i, %arg.shape.1
  br i1 %exitcond.not.i.i, label %B1502, label %B36.if.i.i

B348.i.i:                                         ; preds = %B234.if.i.i, %B36.if.i.i
  %p.2.1.lcssa.i.i = phi i64 [ %.59.0509.i.i, %B36.if.i.i ], [ %p.3.2.i.i, %B234.if.i.i ]
  %173 = getelementptr i64, ptr %arg.linear.2.4, i64 %.59.0509.i.i
  store i64 %p.2.1.lcssa.i.i, ptr %173, align 8, !noalias !36
  %.547.i2114.i = add nsw i64 %p.2.1.lcssa.i.i, %.161.i.i
  %.561.i.i = icmp slt i64 %.547.i2114.i, 0
  %.562.i.i = select i1 %.561.i.i, i64 %arg.linear.1.5.0, i64 0
  %174 = getelementptr double, ptr %arg.linear.1.4, i64 %.547.i2114.i
  %.576.i.i = getelementptr double, ptr %174, i64 %.562.i.i
  %.577.i.i = load double, ptr %.576.i.i, align 8, !noalias !36
  %.610.i.i = load double, ptr %176, align 8, !noalias !36
  store double %.577.i.i, ptr %176, align 8, !noalias !36
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
  %.11.i.i.i10645 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.165.i.i, i64 %arg.shape.1)
  %.200.i.i = add i64 %.199.i.i, %.164.i.i
  %.11.i492.i.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.200.i.i, i64 %arg.shape.1)
  %175 = getelementptr double, ptr %arg.linear.1.4, i64 %.161.i.i
  %176 = getelementptr double, ptr %175, i64 %.59.0509.i.i
  %.319.i.i = sub i64 %.11.i.i.i10645, %.131.i.i
  %storemerge488.i.i = tail call i64 @llvm.smax.i64(i64 %.319.i.i, i64 0)
  %.362493.not.i.i = icmp slt i64 %.319.i.i, 1
  br i1 %.362493.not.i.i, label %B348.i.i, label %B234.if.preheader.i.i

B234.if.preheader.i.i:                            ; preds = %B36.if.i.i
  %.271.i.i = load double, ptr %176, align 8, !noalias !36
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
  %177 = getelementptr double, ptr %arg.linear.1.4, i64 %.415.i.i
  %.444.i.i = getelementptr double, ptr %177, i64 %.430.i.i
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
  %178 = getelementptr double, ptr %arg.linear.1.4, i64 %.798.i.i
  %.827.i.i = getelementptr double, ptr %178, i64 %.813.i.i
  %.828.i.i = load double, ptr %.827.i.i, align 8, !noalias !36
  %.861.i.i = load double, ptr %176, align 8, !noalias !36
  %.865.i.i = fdiv double %.828.i.i, %.861.i.i
  store double %.865.i.i, ptr %.827.i.i, align 8, !noalias !36
  %.759.i.i = icmp sgt i64 %.706.0500.i.i, 1
  br i1 %.759.i.i, label %B466.if.i.i, label %B528.i.i

B566.if.i.i:                                      ; preds = %B528.i.i, %B790.i.i
  %.932.0506.i.i = phi i64 [ %.994.i.i, %B790.i.i ], [ %.942.i.i, %B528.i.i ]
  %.929.0505.i.i = phi i64 [ %.998.i.i, %B790.i.i ], [ %.131.i.i, %B528.i.i ]
  %.994.i.i = add nsw i64 %.932.0506.i.i, -1
  %.998.i.i = add i64 %.929.0505.i.i, 1
  %179 = mul nsw i64 %.929.0505.i.i, %arg.shape.1
  %.1030.i.i = add nsw i64 %179, %p.2.1.lcssa.i.i
  %.1044.i.i = icmp slt i64 %.1030.i.i, 0
  %.1045.i.i = select i1 %.1044.i.i, i64 %arg.linear.1.5.0, i64 0
  %180 = getelementptr double, ptr %arg.linear.1.4, i64 %.1030.i.i
  %.1059.i.i = getelementptr double, ptr %180, i64 %.1045.i.i
  %.1060.i2115.i = load double, ptr %.1059.i.i, align 8, !noalias !36
  %.1068.i.i = add nsw i64 %179, %.59.0509.i.i
  %.1082.i.i = icmp slt i64 %.1068.i.i, 0
  %.1083.i.i = select i1 %.1082.i.i, i64 %arg.linear.1.5.0, i64 0
  %181 = getelementptr double, ptr %arg.linear.1.4, i64 %.1068.i.i
  %.1097.i.i = getelementptr double, ptr %181, i64 %.1083.i.i
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
  %.1296.i.i = add nsw i64 %.1199.0502.i.i, %179
  %.1310.i.i = icmp slt i64 %.1296.i.i, 0
  %.1311.i.i = select i1 %.1310.i.i, i64 %arg.linear.1.5.0, i64 0
  %182 = getelementptr double, ptr %arg.linear.1.4, i64 %.1296.i.i
  %.1325.i.i = getelementptr double, ptr %182, i64 %.1311.i.i
  %.1326.i.i = load double, ptr %.1325.i.i, align 8, !noalias !36
  %.1328.i.i = add nsw i64 %.1199.0502.i.i, %.161.i.i
  %.1342.i.i = icmp slt i64 %.1328.i.i, 0
  %.1343.i.i = select i1 %.1342.i.i, i64 %arg.linear.1.5.0, i64 0
  %183 = getelementptr double, ptr %arg.linear.1.4, i64 %.1328.i.i
  %.1357.i.i = getelementptr double, ptr %183, i64 %.1343.i.i
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
  %.11.i.i10643 = tail call i64 @llvm.smax.i64(i64 %.489.i, i64 0)
  %.521.i = add i64 %.520.i10642, %.388.02152.i
  %.11.i2116.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.521.i, i64 %arg.shape.1)
  %.587.i = sub i64 %.11.i2116.i, %.11.i.i10643
  %.6302148.not.i = icmp slt i64 %.587.i, 1
  br i1 %.6302148.not.i, label %B316.i, label %B262.if.lr.ph.i

B262.if.lr.ph.i:                                  ; preds = %B146.if.i
  %.670.i = mul nsw i64 %.388.02152.i, %arg.shape.1
  br label %B262.if.i

B262.if.i:                                        ; preds = %B262.if.i, %B262.if.lr.ph.i
  %.577.02150.i = phi i64 [ %.587.i, %B262.if.lr.ph.i ], [ %.639.i, %B262.if.i ]
  %.574.02149.i = phi i64 [ %.11.i.i10643, %B262.if.lr.ph.i ], [ %.643.i10644, %B262.if.i ]
  %.639.i = add nsw i64 %.577.02150.i, -1
  %.643.i10644 = add i64 %.574.02149.i, 1
  %.671.i = add nsw i64 %.574.02149.i, %.670.i
  %.685.i = icmp slt i64 %.671.i, 0
  %.686.i = select i1 %.685.i, i64 %arg.linear.0.5.0, i64 0
  %184 = getelementptr double, ptr %arg.linear.0.4, i64 %.671.i
  %.700.i = getelementptr double, ptr %184, i64 %.686.i
  %.701.i = load double, ptr %.700.i, align 8, !noalias !25
  %.702.i = fneg double %.701.i
  %.721.i = select i1 %.685.i, i64 %arg.linear.1.5.0, i64 0
  %185 = getelementptr double, ptr %arg.linear.1.4, i64 %.671.i
  %.735.i = getelementptr double, ptr %185, i64 %.721.i
  store double %.702.i, ptr %.735.i, align 8, !noalias !25
  %.630.i = icmp sgt i64 %.577.02150.i, 1
  br i1 %.630.i, label %B262.if.i, label %B316.i

B1502:                                            ; preds = %B34.loopexit.i.i, %B116.i, %B1458
  br i1 %.222110921.not, label %B1728, label %B1534.if

B68.if.lr.ph.i:                                   ; preds = %B1534.if
  %.259.i = mul nsw i64 %.2234, %arg.shape.1
  br label %B68.if.i

B34.i.loopexit.i:                                 ; preds = %B198.if.i.i, %B34.if.i.i10655
  %exitcond633.not.i = icmp eq i64 %arg.shape.1, %.144.i.i
  br i1 %exitcond633.not.i, label %B314.if.i.i, label %B34.if.i.i10655

B314.i.loopexit.i:                                ; preds = %B474.if.i.i, %B314.if.i.i
  %.683.i.i = icmp sgt i64 %.627.i.0629.in.i, 1
  br i1 %.683.i.i, label %B314.if.i.i, label %B286.if.lr.ph.i

B286.if.lr.ph.i:                                  ; preds = %B314.i.loopexit.i
  %.624.i = mul nsw i64 %.2234, %arg.shape.1
  br label %B286.if.i

B34.if.i.i10655:                                  ; preds = %B68.if.i, %B34.i.loopexit.i
  %.73.i.0621.i = phi i64 [ %.144.i.i, %B34.i.loopexit.i ], [ 0, %B68.if.i ]
  %.144.i.i = add nsw i64 %.73.i.0621.i, 1
  %186 = getelementptr i64, ptr %arg.linear.2.4, i64 %.73.i.0621.i
  %.202.i.i = load i64, ptr %186, align 8, !noalias !39
  %.204.i.i = add nsw i64 %.202.i.i, %.395.i
  %.218.i.i = icmp slt i64 %.204.i.i, 0
  %.219.i.i = select i1 %.218.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %187 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.204.i.i
  %.233.i.i = getelementptr double, ptr %187, i64 %.219.i.i
  %.234.i.i = load double, ptr %.233.i.i, align 8, !noalias !39
  %gep10920 = getelementptr double, ptr %invariant.gep10919, i64 %.73.i.0621.i
  %.270.i.i = load double, ptr %gep10920, align 8, !noalias !39
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !39
  store double %.234.i.i, ptr %gep10920, align 8, !noalias !39
  %.340.i.i = add i64 %.339.i.i, %.73.i.0621.i
  %.11.i.i.i10656 = tail call i64 @llvm.smin.i64(i64 %.340.i.i, i64 %arg.shape.1)
  %.406.i.i = sub i64 %.11.i.i.i10656, %.144.i.i
  %.449.i617.not.i = icmp slt i64 %.406.i.i, 1
  br i1 %.449.i617.not.i, label %B34.i.loopexit.i, label %B198.if.i.lr.ph.i

B198.if.i.lr.ph.i:                                ; preds = %B34.if.i.i10655
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
  %188 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.488.i.i
  %.517.i.i = getelementptr double, ptr %188, i64 %.503.i.i
  %.518.i.i = load double, ptr %.517.i.i, align 8, !noalias !39
  %.522.i.i = add nsw i64 %.393.i.0618.i, %.521.i.i
  %.536.i.i = icmp slt i64 %.522.i.i, 0
  %.537.i.i = select i1 %.536.i.i, i64 %arg.linear.1.5.0, i64 0
  %189 = getelementptr double, ptr %arg.linear.1.4, i64 %.522.i.i
  %.551.i.i = getelementptr double, ptr %189, i64 %.537.i.i
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
  %190 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.726.i.i
  %.755.i.i10657 = getelementptr double, ptr %190, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i10657, align 8, !noalias !39
  %.759.i.i10658 = mul nsw i64 %.627.i.0629.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i10658, %.627.i.0629.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %arg.linear.1.5.0, i64 0
  %191 = getelementptr double, ptr %arg.linear.1.4, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %191, i64 %.776.i.i
  %.791.i.i = load double, ptr %.790.i.i, align 8, !noalias !39
  %.795.i.i = fdiv double %.756.i.i, %.791.i.i
  store double %.795.i.i, ptr %.755.i.i10657, align 8, !noalias !39
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
  %192 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1014.i.i
  %.1043.i.i = getelementptr double, ptr %192, i64 %.1029.i.i
  %.1044.i.i10659 = load double, ptr %.1043.i.i, align 8, !noalias !39
  %.1048.i.i = add nsw i64 %.919.i.0624.i, %.759.i.i10658
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %arg.linear.1.5.0, i64 0
  %193 = getelementptr double, ptr %arg.linear.1.4, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %193, i64 %.1063.i.i
  %.1078.i.i = load double, ptr %.1077.i.i, align 8, !noalias !39
  %.1080.i.i = fmul double %.795.i.i, %.1078.i.i
  %.1081.i.i = fsub double %.1044.i.i10659, %.1080.i.i
  store double %.1081.i.i, ptr %.1043.i.i, align 8, !noalias !39
  %.975.i.i10660 = icmp sgt i64 %.922.i.0625.i, 1
  br i1 %.975.i.i10660, label %B474.if.i.i, label %B314.i.loopexit.i

B68.if.i:                                         ; preds = %B68.if.i, %B68.if.lr.ph.i
  %.160.0615.i = phi i64 [ 0, %B68.if.lr.ph.i ], [ %.231.i, %B68.if.i ]
  %.231.i = add nsw i64 %.160.0615.i, 1
  %.260.i = add nsw i64 %.160.0615.i, %.259.i
  %.274.i = icmp slt i64 %.260.i, 0
  %.275.i10649 = select i1 %.274.i, i64 %arg.batch.5.0.5.0, i64 0
  %194 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.260.i
  %.289.i = getelementptr double, ptr %194, i64 %.275.i10649
  %.290.i = load double, ptr %.289.i, align 8, !noalias !45
  %gep10918 = getelementptr double, ptr %invariant.gep10917, i64 %.160.0615.i
  %.323.i10651 = load double, ptr %gep10918, align 8, !noalias !45
  %.324.i10652 = fadd double %.290.i, %.323.i10651
  %195 = getelementptr i64, ptr %arg.linear.4.4, i64 %.160.0615.i
  %.356.i = load i64, ptr %195, align 8, !noalias !45
  %.357.i = add nsw i64 %.356.i, %.326.i10648
  %.371.i = icmp slt i64 %.357.i, 0
  %.372.i10653 = select i1 %.371.i, i64 %arg.batch.5.0.5.0, i64 0
  %196 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.357.i
  %.386.i = getelementptr double, ptr %196, i64 %.372.i10653
  store double %.324.i10652, ptr %.386.i, align 8, !noalias !45
  %exitcond.not.i10654 = icmp eq i64 %arg.shape.1, %.231.i
  br i1 %exitcond.not.i10654, label %B34.if.i.i10655, label %B68.if.i

B286.if.i:                                        ; preds = %B286.if.i, %B286.if.lr.ph.i
  %.464.0631.i = phi i64 [ 0, %B286.if.lr.ph.i ], [ %.533.i, %B286.if.i ]
  %.533.i = add nsw i64 %.464.0631.i, 1
  %197 = getelementptr i64, ptr %arg.linear.4.4, i64 %.464.0631.i
  %.589.i = load i64, ptr %197, align 8, !noalias !45
  %.590.i = add nsw i64 %.589.i, %.395.i
  %.604.i = icmp slt i64 %.590.i, 0
  %.605.i = select i1 %.604.i, i64 %arg.batch.5.0.5.0, i64 0
  %198 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.590.i
  %.619.i = getelementptr double, ptr %198, i64 %.605.i
  %.620.i = load double, ptr %.619.i, align 8, !noalias !45
  %.625.i = add nsw i64 %.464.0631.i, %.624.i
  %.639.i10661 = icmp slt i64 %.625.i, 0
  %.640.i = select i1 %.639.i10661, i64 %arg.batch.5.0.5.0, i64 0
  %199 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.i
  %.654.i10662 = getelementptr double, ptr %199, i64 %.640.i
  store double %.620.i, ptr %.654.i10662, align 8, !noalias !45
  %exitcond634.not.i = icmp eq i64 %arg.shape.1, %.533.i
  br i1 %exitcond634.not.i, label %B1726, label %B286.if.i

B1726:                                            ; preds = %B286.if.i, %B1534.if
  %exitcond11112.not = icmp eq i64 %.2165.010922, %storemerge10523
  br i1 %exitcond11112.not, label %B1728, label %B1534.if

B1728:                                            ; preds = %B1726, %B1502
  %.2487 = load i64, ptr %.2486, align 8
  %.2532 = inttoptr i64 %.2487 to ptr
  tail call void %.2532(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %brmerge = select i1 %.1168, i1 true, i1 %.610
  %or.cond10609 = select i1 %brmerge, i1 true, i1 %.2563
  %spec.select10630 = select i1 %or.cond10609, i1 true, i1 %.2568
  br i1 %.794, label %B1960, label %B1870.if

B1878:                                            ; preds = %B1870.if
  %200 = getelementptr double, ptr %33, i64 %.2608.010925
  %.2767 = load double, ptr %200, align 8
  %.2768 = fcmp ogt double %.2767, 5.000000e-01
  br label %B1914

B1914:                                            ; preds = %B1878, %B1870.if
  %"$phi1914.1.2.2" = phi i1 [ true, %B1870.if ], [ %.2768, %B1878 ]
  br i1 %looked.2.110928, label %B1956, label %B1920

B1920:                                            ; preds = %B1914
  %201 = getelementptr double, ptr %34, i64 %.2608.010925
  %.2842 = load double, ptr %201, align 8
  %.2843 = fcmp ogt double %.2842, 5.000000e-01
  br label %B1956

B1956:                                            ; preds = %B1920, %B1914
  %"$phi1956.1.2.2" = phi i1 [ true, %B1914 ], [ %.2843, %B1920 ]
  %.2664 = icmp sgt i64 %.2611.010926, 1
  br i1 %.2664, label %B1870.if, label %B1960

B1960:                                            ; preds = %B1956, %B1728
  %good.2.1.lcssa = phi i1 [ false, %B1728 ], [ %"$phi1914.1.2.2", %B1956 ]
  %looked.2.1.lcssa = phi i1 [ %spec.select10630, %B1728 ], [ %"$phi1956.1.2.2", %B1956 ]
  %looked.2.1.lcssa.not11123 = xor i1 %looked.2.1.lcssa, true
  %brmerge11124 = or i1 %.794, %looked.2.1.lcssa.not11123
  br i1 %brmerge11124, label %B2538, label %B80.if.i

B2030.preheader:                                  ; preds = %B568.i
  br i1 %.794, label %B2538, label %B2030.if

B126.i:                                           ; preds = %B80.if.i
  %.318.i589 = getelementptr double, ptr %35, i64 %.105.i435.010932
  %.319.i = load double, ptr %.318.i589, align 8, !noalias !46
  %.5.i.i = fptosi double %.319.i to i64
  %.397.i634 = getelementptr double, ptr %36, i64 %.105.i435.010932
  %.398.i635 = load double, ptr %.397.i634, align 8, !noalias !46
  %.5.i1.i = fptosi double %.398.i635 to i64
  %.478.i682 = mul i64 %.258.i, %arg.batch.3.3.5.1
  %.482.i = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.478.i682
  %.483.i686 = load i64, ptr %.482.i, align 8, !noalias !46
  %.485.i = add nsw i64 %.483.i686, %.5.i.i
  store i64 %.485.i, ptr %.482.i, align 8, !noalias !46
  %.591.i772 = getelementptr i8, ptr %.482.i, i64 24
  %.592.i773 = load i64, ptr %.591.i772, align 8, !noalias !46
  %.594.i775 = add nsw i64 %.592.i773, %.5.i1.i
  store i64 %.594.i775, ptr %.591.i772, align 8, !noalias !46
  %.700.i863 = getelementptr i8, ptr %.482.i, i64 8
  %.701.i864 = load i64, ptr %.700.i863, align 8, !noalias !46
  %.706.i869 = add nsw i64 %.5.i1.i, %.5.i.i
  %.707.i870 = mul nsw i64 %.706.i869, %.2178
  %..5.i.i = select i1 %.625, i64 0, i64 %.5.i.i
  %.708.i871 = add i64 %.707.i870, %..5.i.i
  %.841.i958 = add i64 %.708.i871, %.701.i864
  store i64 %.841.i958, ptr %.700.i863, align 8, !noalias !46
  store double 0.000000e+00, ptr %.318.i589, align 8, !noalias !46
  store double 0.000000e+00, ptr %.397.i634, align 8, !noalias !46
  %.1072.i = getelementptr double, ptr %37, i64 %.105.i435.010932
  %.1073.i1075 = load double, ptr %.1072.i, align 8, !noalias !46
  %.1081.i1080 = sitofp i64 %.706.i869 to double
  %.1082.i1081 = fsub double %.1073.i1075, %.1081.i1080
  store double %.1082.i1081, ptr %.1072.i, align 8, !noalias !46
  br label %B568.i

B568.i:                                           ; preds = %B126.i, %B80.if.i
  %.163.i493 = icmp sgt i64 %.108.i.010933, 1
  br i1 %.163.i493, label %B80.if.i, label %B2030.preheader

B80.if.i:                                         ; preds = %B1960, %B568.i
  %.108.i.010933 = phi i64 [ %.172.i1118, %B568.i ], [ %storemerge, %B1960 ]
  %.105.i435.010932 = phi i64 [ %.176.i1121, %B568.i ], [ 0, %B1960 ]
  %.172.i1118 = add nsw i64 %.108.i.010933, -1
  %.176.i1121 = add nsw i64 %.105.i435.010932, 1
  %202 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i435.010932
  %.258.i = load i64, ptr %202, align 8, !noalias !46
  %.263.i545 = icmp sgt i64 %.258.i, -1
  br i1 %.263.i545, label %B126.i, label %B568.i

B2130:                                            ; preds = %B2030.if
  %.3297 = getelementptr double, ptr %40, i64 %.2963.010935
  %.3298 = load double, ptr %.3297, align 8
  %.3299 = fcmp ogt double %.3298, 5.000000e-01
  br i1 %.3299, label %B2168, label %B2268

B2168:                                            ; preds = %B2130
  %.5.i = fptosi double %.3298 to i64
  %203 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2963.010935
  %.84.i2115 = load i64, ptr %203, align 8, !noalias !50
  %.89.i2118 = icmp sgt i64 %.84.i2115, -1
  br i1 %.89.i2118, label %B46.i, label %B2268

B2268:                                            ; preds = %B2130, %B46.i, %B2168, %B80.i2147
  %.3485 = getelementptr double, ptr %41, i64 %.2963.010935
  %.3486 = load double, ptr %.3485, align 8
  %.3487 = fcmp ogt double %.3486, 5.000000e-01
  br i1 %.3487, label %B2306, label %B2536

B2306:                                            ; preds = %B2268
  %spec.select = select i1 %within.3.210937, i1 true, i1 %.2563
  %.3563 = mul i64 %.3124, %arg.batch.3.3.5.1
  %.3567 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.3563
  %.3568 = load i64, ptr %.3567, align 8
  %.3579.0 = and i64 %.3568, 127
  %.3609 = icmp eq i64 %.3579.0, 0
  br i1 %.3609, label %B2414, label %B2376

B2376:                                            ; preds = %B2306
  %.3670 = getelementptr double, ptr %42, i64 %.2963.010935
  %.3671 = load double, ptr %.3670, align 8
  %.3673 = fcmp ogt double %.3671, 0.000000e+00
  br i1 %.3673, label %B2414, label %B2444

B2414:                                            ; preds = %B2306, %B2376
  store double 1.000000e+00, ptr %.3239, align 8
  br label %B2444

B2444:                                            ; preds = %B2414, %B2376
  %checked.5.5 = phi i1 [ true, %B2414 ], [ %checked.3.210938, %B2376 ]
  %.3756 = icmp slt i64 %.3179, %arg.batch.2.5.0
  br i1 %.3756, label %B2482, label %B2536

B2482:                                            ; preds = %B2444
  %.3780 = icmp slt i64 %.3179, 0
  %.3781 = select i1 %.3780, i64 %arg.batch.2.5.0, i64 0
  %204 = getelementptr double, ptr %arg.batch.2.4, i64 %.3179
  %.3795 = getelementptr double, ptr %204, i64 %.3781
  %.3796 = load double, ptr %.3795, align 8
  %.3854 = getelementptr double, ptr %43, i64 %.2963.010935
  %.3855 = load double, ptr %.3854, align 8
  %.3856 = fcmp olt double %.3796, %.3855
  br i1 %.3856, label %B2532, label %B2536

B2532:                                            ; preds = %B2482
  br label %B2536

B2536:                                            ; preds = %B2030.if, %B2532, %B2482, %B2444, %B2268
  %within.4.3 = phi i1 [ true, %B2532 ], [ %spec.select, %B2482 ], [ %spec.select, %B2444 ], [ %within.3.210937, %B2268 ], [ %within.3.210937, %B2030.if ]
  %checked.4.3 = phi i1 [ %checked.5.5, %B2532 ], [ %checked.5.5, %B2482 ], [ %checked.5.5, %B2444 ], [ %checked.3.210938, %B2268 ], [ %checked.3.210938, %B2030.if ]
  %.3025 = icmp sgt i64 %.2966.010936, 1
  br i1 %.3025, label %B2030.if, label %B2538

B2538:                                            ; preds = %B2536, %B1960, %B2030.preheader
  %within.5.1 = phi i1 [ false, %B1960 ], [ false, %B2030.preheader ], [ %within.4.3, %B2536 ]
  %checked.2.1 = phi i1 [ false, %B1960 ], [ false, %B2030.preheader ], [ %checked.4.3, %B2536 ]
  %good.2.1.not = xor i1 %good.2.1.lcssa, true
  %brmerge10611 = select i1 %good.2.1.not, i1 true, i1 %44
  br i1 %brmerge10611, label %B2666, label %B2550

B2550:                                            ; preds = %B2538
  %.3934 = load i64, ptr %arg.code.4, align 8
  %.3984 = inttoptr i64 %.3934 to ptr
  tail call void %.3984(ptr %.571, ptr %.3958, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.3983)
  br label %B2666

B2666:                                            ; preds = %B2538, %B2550
  br i1 %checked.2.1, label %B2670, label %B2746

B2670:                                            ; preds = %B2666
  switch i64 %arg.shape.2, label %B2746 [
    i64 12, label %B2678
    i64 7, label %B2678
  ]

B2678:                                            ; preds = %B2670, %B2670
  %.4024 = load i64, ptr %.4023, align 8
  %.4069 = inttoptr i64 %.4024 to ptr
  tail call void %.4069(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B2746

B2746:                                            ; preds = %B2670, %B2678, %B2666
  %brmerge10614.not = and i1 %.2568, %good.2.1.lcssa
  br i1 %brmerge10614.not, label %B2766, label %B2872

B2766:                                            ; preds = %B2746
  %.4118 = load i64, ptr %.4117, align 8
  %.4163 = inttoptr i64 %.4118 to ptr
  tail call void %.4163(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.794, label %B188.if.i.preheader, label %B108.if.i

B186.i.loopexit.critedge:                         ; preds = %B188.if.i
  %.625.i2510.c = icmp ult i64 %.361.i2304.010958, 8
  %.10615.c = select i1 %.625.i2510.c, i64 16, i64 17
  %.672.i2541.c = load i64, ptr %.671.i2540, align 8, !noalias !53
  %.744.i2596.c = mul i64 %.742.i2594, %.10615.c
  %.762.i2604.c = getelementptr double, ptr %arg.batch.5.0.4, i64 %.744.i2596.c
  %.788.i2614.c = inttoptr i64 %.672.i2541.c to ptr
  tail call void %.788.i2614.c(ptr %.571, ptr %.762.i2604.c, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !53
  br label %B186.i.loopexit

B186.i.loopexit:                                  ; preds = %B770.i, %B186.i.loopexit.critedge
  %some.2.i.1.lcssa = phi i1 [ %some.4.i.010960, %B186.i.loopexit.critedge ], [ %some.3.i.2, %B770.i ]
  %exitcond11115.not = icmp eq i64 %.431.i3145, 9
  br i1 %exitcond11115.not, label %B806.i.preheader, label %B188.if.i

B806.i.preheader:                                 ; preds = %B186.i.loopexit
  br i1 %.794, label %B2872, label %B806.if.i

B222.i.loopexit:                                  ; preds = %B122.if.i.i, %B222.if.i
  %.539.i2500 = icmp sgt i64 %.486.i2314.010952, 1
  br i1 %.539.i2500, label %B222.if.i, label %B284.i

B284.i:                                           ; preds = %B222.i.loopexit
  %.625.i2510 = icmp ult i64 %.361.i2304.010958, 8
  %.10615 = select i1 %.625.i2510, i64 16, i64 17
  %.672.i2541 = load i64, ptr %.671.i2540, align 8, !noalias !53
  %.744.i2596 = mul i64 %.742.i2594, %.10615
  %.762.i2604 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.744.i2596
  %.788.i2614 = inttoptr i64 %.672.i2541 to ptr
  tail call void %.788.i2614(ptr %.571, ptr %.762.i2604, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !53
  %.1181.i = add nsw i64 %.361.i2304.010958, -1
  %.1182.i = sitofp i64 %.1181.i to double
  %.1187.i = fmul double %.1182.i, 1.250000e-01
  %.1189.i2865 = uitofp i64 %.361.i2304.010958 to double
  %.1194.i = fmul double %.1189.i2865, 1.250000e-01
  br label %B466.if.i

B508.i:                                           ; preds = %B466.if.i
  %.1028.i2742 = getelementptr double, ptr %47, i64 %.814.i2333.010954
  %.1029.i = load double, ptr %.1028.i2742, align 8, !noalias !53
  %.1030.i = fcmp ogt double %.1029.i, 5.000000e-01
  br i1 %.1030.i, label %B546.i, label %B770.i

B546.i:                                           ; preds = %B508.i
  %.1088.i2786 = getelementptr i64, ptr %48, i64 %.814.i2333.010954
  %.1089.i = load i64, ptr %.1088.i2786, align 8, !noalias !53
  %.1090.i2787 = icmp slt i64 %.1089.i, 0
  br i1 %.1090.i2787, label %B34.i.i, label %B770.i

B34.i.i:                                          ; preds = %B546.i, %B36.i.i
  %.48.i.i2176.0 = phi i64 [ %.119.i88.i, %B36.i.i ], [ 0, %B546.i ]
  %.51.i12.i.0 = phi i64 [ %.115.i.i2889, %B36.i.i ], [ %arg.shape.6, %B546.i ]
  %.106.i.i2818 = icmp sgt i64 %.51.i12.i.0, 0
  br i1 %.106.i.i2818, label %B36.i.i, label %B584.endif.i

B36.i.i:                                          ; preds = %B34.i.i
  %.115.i.i2889 = add nsw i64 %.51.i12.i.0, -1
  %.119.i88.i = add i64 %.48.i.i2176.0, 1
  %.149.i53.i = add nsw i64 %.48.i.i2176.0, %arg.shape.6
  %.151.i55.i = mul nsw i64 %.149.i53.i, %arg.shape.0
  %.153.i56.i = add nsw i64 %.151.i55.i, %.814.i2333.010954
  %.167.i61.i = icmp slt i64 %.153.i56.i, 0
  %.168.i62.i = select i1 %.167.i61.i, i64 %arg.batch.5.4.5.0, i64 0
  %205 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i56.i
  %.182.i74.i = getelementptr double, ptr %205, i64 %.168.i62.i
  %.183.i75.i = load double, ptr %.182.i74.i, align 8, !noalias !57
  %.184.i.i = fcmp ogt double %.183.i75.i, 5.000000e-01
  br i1 %.184.i.i, label %B584.endif.i, label %B34.i.i

B732.i:                                           ; preds = %B584.endif.i
  %.1369.i = load i64, ptr %.1088.i2786, align 8, !noalias !53
  %.1370.i = icmp sgt i64 %.1369.i, -1
  br label %B770.i

B770.i:                                           ; preds = %B732.i, %B584.endif.i, %B546.i, %B508.i, %B466.if.i
  %some.3.i.2 = phi i1 [ %some.2.i.110956, %B466.if.i ], [ %some.2.i.110956, %B546.i ], [ %some.2.i.110956, %B508.i ], [ true, %B584.endif.i ], [ %.1370.i, %B732.i ]
  %.870.i2645 = icmp sgt i64 %.817.i2334.010955, 1
  br i1 %.870.i2645, label %B466.if.i, label %B186.i.loopexit

B108.if.i:                                        ; preds = %B2766, %B108.if.i
  %.179.i2294.010943 = phi i64 [ %.243.i3201, %B108.if.i ], [ %storemerge, %B2766 ]
  %.176.i2293.010942 = phi i64 [ %.247.i3204, %B108.if.i ], [ 0, %B2766 ]
  %.243.i3201 = add nsw i64 %.179.i2294.010943, -1
  %.247.i3204 = add nsw i64 %.176.i2293.010942, 1
  %206 = getelementptr i64, ptr %45, i64 %.176.i2293.010942
  store i64 -1, ptr %206, align 8, !noalias !53
  %.234.i2409 = icmp sgt i64 %.179.i2294.010943, 1
  br i1 %.234.i2409, label %B108.if.i, label %B188.if.i.preheader

B188.if.i.preheader:                              ; preds = %B108.if.i, %B2766
  br label %B188.if.i

B188.if.i:                                        ; preds = %B188.if.i.preheader, %B186.i.loopexit
  %some.4.i.010960 = phi i1 [ %some.2.i.1.lcssa, %B186.i.loopexit ], [ false, %B188.if.i.preheader ]
  %.361.i2304.010958 = phi i64 [ %.431.i3145, %B186.i.loopexit ], [ 1, %B188.if.i.preheader ]
  %.431.i3145 = add nsw i64 %.361.i2304.010958, 1
  br i1 %.794, label %B186.i.loopexit.critedge, label %B222.if.i.lr.ph

B222.if.i.lr.ph:                                  ; preds = %B188.if.i
  %.579.i2906 = uitofp i64 %.361.i2304.010958 to double
  %.584.i2907 = fmul double %.579.i2906, 1.250000e-01
  %.247.i.i.i = fsub double 1.000000e+00, %.584.i2907
  br label %B222.if.i

B222.if.i:                                        ; preds = %B222.if.i.lr.ph, %B222.i.loopexit
  %.486.i2314.010952 = phi i64 [ %storemerge, %B222.if.i.lr.ph ], [ %.548.i3129, %B222.i.loopexit ]
  %.483.i2313.010951 = phi i64 [ 0, %B222.if.i.lr.ph ], [ %.552.i3132, %B222.i.loopexit ]
  %.548.i3129 = add nsw i64 %.486.i2314.010952, -1
  %.552.i3132 = add nsw i64 %.483.i2313.010951, 1
  %.92.i.i2982 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.483.i2313.010951
  %.93.i.i2983 = load double, ptr %.92.i.i2982, align 8, !noalias !61
  %.146.i.i3017 = getelementptr double, ptr %46, i64 %.483.i2313.010951
  %.147.i.i3018 = load double, ptr %.146.i.i3017, align 8, !noalias !61
  %.149.i.i3020 = fmul double %.584.i2907, %.147.i.i3018
  %.150.i.i3021 = fadd double %.93.i.i2983, %.149.i.i3020
  %.203.i.i3048 = getelementptr double, ptr %.571, i64 %.483.i2313.010951
  store double %.150.i.i3021, ptr %.203.i.i3048, align 8, !noalias !61
  br i1 %.287.i.i10947.not, label %B222.i.loopexit, label %B122.if.i.i.preheader

B122.if.i.i.preheader:                            ; preds = %B222.if.i
  %invariant.gep11137 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2313.010951
  %invariant.gep11139 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2313.010951
  %invariant.gep11141 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2313.010951
  %invariant.gep11143 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2313.010951
  %invariant.gep11145 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2313.010951
  %invariant.gep11147 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2313.010951
  %invariant.gep11149 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2313.010951
  %invariant.gep11151 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2313.010951
  %invariant.gep11153 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2313.010951
  br label %B122.if.i.i

B122.if.i.i:                                      ; preds = %B122.if.i.i.preheader, %B122.if.i.i
  %.229.i.i.010948 = phi i64 [ %.300.i.i3119, %B122.if.i.i ], [ 0, %B122.if.i.i.preheader ]
  %.157.i.i.i = add nsw i64 %.155.i.i.i, %.229.i.i.010948
  %.159.i.i.i = mul nsw i64 %.157.i.i.i, %arg.shape.0
  %gep11138 = getelementptr double, ptr %invariant.gep11137, i64 %.159.i.i.i
  %.191.i.i.i = load double, ptr %gep11138, align 8, !noalias !65
  %.193.i.i.i = fadd double %.191.i.i.i, 0.000000e+00
  %.253.i.i.i = fmul double %.584.i2907, %.193.i.i.i
  %.157.i.i.i.1 = add nsw i64 %.155.i.i.i.1, %.229.i.i.010948
  %.159.i.i.i.1 = mul nsw i64 %.157.i.i.i.1, %arg.shape.0
  %gep11140 = getelementptr double, ptr %invariant.gep11139, i64 %.159.i.i.i.1
  %.191.i.i.i.1 = load double, ptr %gep11140, align 8, !noalias !65
  %.193.i.i.i.1 = fadd double %.253.i.i.i, %.191.i.i.i.1
  %.253.i.i.i.1 = fmul double %.247.i.i.i, %.193.i.i.i.1
  %.157.i.i.i.2 = add nsw i64 %.155.i.i.i.2, %.229.i.i.010948
  %.159.i.i.i.2 = mul nsw i64 %.157.i.i.i.2, %arg.shape.0
  %gep11142 = getelementptr double, ptr %invariant.gep11141, i64 %.159.i.i.i.2
  %.191.i.i.i.2 = load double, ptr %gep11142, align 8, !noalias !65
  %.193.i.i.i.2 = fadd double %.253.i.i.i.1, %.191.i.i.i.2
  %.253.i.i.i.2 = fmul double %.584.i2907, %.193.i.i.i.2
  %.157.i.i.i.3 = add nsw i64 %.155.i.i.i.3, %.229.i.i.010948
  %.159.i.i.i.3 = mul nsw i64 %.157.i.i.i.3, %arg.shape.0
  %gep11144 = getelementptr double, ptr %invariant.gep11143, i64 %.159.i.i.i.3
  %.191.i.i.i.3 = load double, ptr %gep11144, align 8, !noalias !65
  %.193.i.i.i.3 = fadd double %.253.i.i.i.2, %.191.i.i.i.3
  %.253.i.i.i.3 = fmul double %.247.i.i.i, %.193.i.i.i.3
  %.157.i.i.i.4 = add nsw i64 %.155.i.i.i.4, %.229.i.i.010948
  %.159.i.i.i.4 = mul nsw i64 %.157.i.i.i.4, %arg.shape.0
  %gep11146 = getelementptr double, ptr %invariant.gep11145, i64 %.159.i.i.i.4
  %.191.i.i.i.4 = load double, ptr %gep11146, align 8, !noalias !65
  %.193.i.i.i.4 = fadd double %.253.i.i.i.3, %.191.i.i.i.4
  %.253.i.i.i.4 = fmul double %.584.i2907, %.193.i.i.i.4
  %.157.i.i.i.5 = add nsw i64 %.155.i.i.i.5, %.229.i.i.010948
  %.159.i.i.i.5 = mul nsw i64 %.157.i.i.i.5, %arg.shape.0
  %gep11148 = getelementptr double, ptr %invariant.gep11147, i64 %.159.i.i.i.5
  %.191.i.i.i.5 = load double, ptr %gep11148, align 8, !noalias !65
  %.193.i.i.i.5 = fadd double %.253.i.i.i.4, %.191.i.i.i.5
  %.253.i.i.i.5 = fmul double %.247.i.i.i, %.193.i.i.i.5
  %.157.i.i.i.6 = add nsw i64 %.155.i.i.i.6, %.229.i.i.010948
  %.159.i.i.i.6 = mul nsw i64 %.157.i.i.i.6, %arg.shape.0
  %gep11150 = getelementptr double, ptr %invariant.gep11149, i64 %.159.i.i.i.6
  %.191.i.i.i.6 = load double, ptr %gep11150, align 8, !noalias !65
  %.193.i.i.i.6 = fadd double %.253.i.i.i.5, %.191.i.i.i.6
  %.253.i.i.i.6 = fmul double %.584.i2907, %.193.i.i.i.6
  %.300.i.i3119 = add nsw i64 %.229.i.i.010948, 1
  %.271.i.i.i = mul nsw i64 %.229.i.i.010948, %arg.shape.0
  %gep11152 = getelementptr double, ptr %invariant.gep11151, i64 %.271.i.i.i
  %.309.i.i.i = load double, ptr %gep11152, align 8, !noalias !65
  %.313.i.i.i = fadd double %.253.i.i.i.6, %.309.i.i.i
  %.359.i.i3098 = add nsw i64 %.229.i.i.010948, %.358.i.i
  %.361.i.i3099 = mul nsw i64 %.359.i.i3098, %arg.shape.0
  %gep11154 = getelementptr double, ptr %invariant.gep11153, i64 %.361.i.i3099
  store double %.313.i.i.i, ptr %gep11154, align 8, !noalias !61
  %exitcond11114.not = icmp eq i64 %arg.shape.1, %.300.i.i3119
  br i1 %exitcond11114.not, label %B222.i.loopexit, label %B122.if.i.i

B466.if.i:                                        ; preds = %B284.i, %B770.i
  %some.2.i.110956 = phi i1 [ %some.4.i.010960, %B284.i ], [ %some.3.i.2, %B770.i ]
  %.817.i2334.010955 = phi i64 [ %storemerge, %B284.i ], [ %.879.i2892, %B770.i ]
  %.814.i2333.010954 = phi i64 [ 0, %B284.i ], [ %.883.i2895, %B770.i ]
  %.879.i2892 = add nsw i64 %.817.i2334.010955, -1
  %.883.i2895 = add nsw i64 %.814.i2333.010954, 1
  %.968.i2699 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.814.i2333.010954
  %.969.i2700 = load i64, ptr %.968.i2699, align 8, !noalias !53
  %.970.i2701 = icmp sgt i64 %.969.i2700, -1
  br i1 %.970.i2701, label %B508.i, label %B770.i

B584.endif.i:                                     ; preds = %B36.i.i, %B34.i.i
  %.1099.i2342.0 = phi i64 [ %.48.i.i2176.0, %B36.i.i ], [ -1, %B34.i.i ]
  store i64 %.1099.i2342.0, ptr %.1088.i2786, align 8, !noalias !53
  %.1248.i = getelementptr double, ptr %49, i64 %.814.i2333.010954
  store double %.1187.i, ptr %.1248.i, align 8, !noalias !53
  %.1303.i = getelementptr double, ptr %50, i64 %.814.i2333.010954
  store double %.1194.i, ptr %.1303.i, align 8, !noalias !53
  br i1 %some.2.i.110956, label %B770.i, label %B732.i

B806.if.i:                                        ; preds = %B806.i.preheader, %B806.if.i
  %.1453.i.010963 = phi i64 [ %.1515.i, %B806.if.i ], [ %storemerge, %B806.i.preheader ]
  %.1450.i.010962 = phi i64 [ %.1519.i, %B806.if.i ], [ 0, %B806.i.preheader ]
  %.1515.i = add nsw i64 %.1453.i.010963, -1
  %.1519.i = add nsw i64 %.1450.i.010962, 1
  %.1596.i = getelementptr double, ptr %51, i64 %.1450.i.010962
  %.1597.i = load double, ptr %.1596.i, align 8, !noalias !53
  %.1650.i = getelementptr double, ptr %.571, i64 %.1450.i.010962
  store double %.1597.i, ptr %.1650.i, align 8, !noalias !53
  %.1506.i = icmp sgt i64 %.1453.i.010963, 1
  br i1 %.1506.i, label %B806.if.i, label %B2872

B2872:                                            ; preds = %B806.if.i, %B806.i.preheader, %B2746
  %beyond.2.1 = phi i1 [ false, %B2746 ], [ %some.2.i.1.lcssa, %B806.i.preheader ], [ %some.2.i.1.lcssa, %B806.if.i ]
  %brmerge10616 = select i1 %within.5.1, i1 true, i1 %beyond.2.1
  br i1 %brmerge10616, label %B2882, label %B3444

B2882:                                            ; preds = %B2872
  br i1 %.614, label %B2930.if, label %B3298.critedge

B140.i:                                           ; preds = %B64.if.i6069
  %.409.i5400 = getelementptr double, ptr %53, i64 %.138.i5167.010968
  %.410.i5401 = load double, ptr %.409.i5400, align 8, !noalias !69
  %.411.i5402 = fcmp uge double %.410.i5401, 5.000000e-01
  %.424.i5410.not = icmp slt i64 %.346.i5349, %arg.batch.2.5.0
  %or.cond10617 = select i1 %.411.i5402, i1 %.424.i5410.not, i1 false
  br i1 %or.cond10617, label %B216.i, label %B453.i

B216.i:                                           ; preds = %B140.i
  %.440.i = icmp slt i64 %.346.i5349, 0
  %.441.i5421 = select i1 %.440.i, i64 %arg.batch.2.5.0, i64 0
  %207 = getelementptr double, ptr %arg.batch.2.4, i64 %.346.i5349
  %.455.i5435 = getelementptr double, ptr %207, i64 %.441.i5421
  %.456.i5436 = load double, ptr %.455.i5435, align 8, !noalias !69
  %.510.i5484 = getelementptr double, ptr %54, i64 %.138.i5167.010968
  %.511.i5485 = load double, ptr %.510.i5484, align 8, !noalias !69
  %.512.i5486 = fcmp ult double %.456.i5436, %.511.i5485
  br i1 %.512.i5486, label %B268.i5487, label %B453.i

B268.i5487:                                       ; preds = %B216.i
  %.574.i5533 = getelementptr double, ptr %55, i64 %.138.i5167.010968
  %.575.i5534 = load double, ptr %.574.i5533, align 8, !noalias !69
  %.576.i5535 = fcmp ogt double %.575.i5534, 1.000000e+00
  br i1 %.576.i5535, label %B306.i5539, label %B453.i

B306.i5539:                                       ; preds = %B268.i5487
  %.632.i = getelementptr double, ptr %56, i64 %.138.i5167.010968
  %.633.i5588 = load double, ptr %.632.i, align 8, !noalias !69
  store double 0.000000e+00, ptr %.409.i5400, align 8, !noalias !73
  %.161.i.i5749 = getelementptr double, ptr %57, i64 %.138.i5167.010968
  store double 0.000000e+00, ptr %.161.i.i5749, align 8, !noalias !73
  %.214.i.i5784 = getelementptr double, ptr %58, i64 %.138.i5167.010968
  store double %.633.i5588, ptr %.214.i.i5784, align 8, !noalias !73
  %.268.i.i5817 = load i64, ptr %.290.i5302, align 8, !noalias !73
  %.294.i.i5831 = icmp slt i64 %.268.i.i5817, 0
  %.295.i.i = select i1 %.294.i.i5831, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i.i5832 = add i64 %.295.i.i, %.268.i.i5817
  %.316.i.i5844 = mul i64 %.296.i.i5832, %arg.batch.3.3.5.1
  %.320.i.i5845 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i.i5844
  %.321.i.i5846 = load i64, ptr %.320.i.i5845, align 8, !noalias !73
  %.322.i.i5847 = add nsw i64 %.321.i.i5846, -1
  store i64 %.322.i.i5847, ptr %.320.i.i5845, align 8, !noalias !73
  %.426.i.i5893 = load i64, ptr %.290.i5302, align 8, !noalias !73
  %.452.i.i = icmp slt i64 %.426.i.i5893, 0
  %.453.i.i = select i1 %.452.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i = add i64 %.453.i.i, %.426.i.i5893
  %.474.i.i = mul i64 %.454.i.i, %arg.batch.3.3.5.1
  %208 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i
  %.478.i.i = getelementptr i8, ptr %208, i64 24
  %.479.i.i = load i64, ptr %.478.i.i, align 8, !noalias !73
  %.480.i.i = add nsw i64 %.479.i.i, 1
  store i64 %.480.i.i, ptr %.478.i.i, align 8, !noalias !73
  %.705.i5923 = load double, ptr %.455.i5435, align 8, !noalias !69
  %.763.i5972 = getelementptr double, ptr %59, i64 %.138.i5167.010968
  store double %.705.i5923, ptr %.763.i5972, align 8, !noalias !69
  %.816.i6015 = mul i64 %.291.i5303, %arg.batch.3.3.5.1
  %209 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.816.i6015
  %.820.i6019 = getelementptr i8, ptr %209, i64 8
  %.821.i6020 = load i64, ptr %.820.i6019, align 8, !noalias !69
  %.822.i6021 = add nsw i64 %.821.i6020, 3
  store i64 %.822.i6021, ptr %.820.i6019, align 8, !noalias !69
  br label %B453.i

B453.i:                                           ; preds = %B268.i5487, %B306.i5539, %B64.if.i6069, %B140.i, %B216.i
  %.196.i5236 = icmp sgt i64 %.141.i5168.010967, 1
  br i1 %.196.i5236, label %B64.if.i6069, label %B3298

B64.if.i6069:                                     ; preds = %B2930.if, %B453.i
  %.138.i5167.010968 = phi i64 [ %.209.i6076, %B453.i ], [ 0, %B2930.if ]
  %.141.i5168.010967 = phi i64 [ %.205.i6073, %B453.i ], [ %storemerge, %B2930.if ]
  %.205.i6073 = add nsw i64 %.141.i5168.010967, -1
  %.209.i6076 = add nsw i64 %.138.i5167.010968, 1
  %.290.i5302 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.138.i5167.010968
  %.291.i5303 = load i64, ptr %.290.i5302, align 8, !noalias !69
  %.345.i5348 = getelementptr i64, ptr %52, i64 %.138.i5167.010968
  %.346.i5349 = load i64, ptr %.345.i5348, align 8, !noalias !69
  %.354.i5353 = icmp slt i64 %.291.i5303, 0
  br i1 %.354.i5353, label %B453.i, label %B140.i

B3298.critedge:                                   ; preds = %B2882
  %.4639.c = load i64, ptr %.4638.c, align 8
  %.4684.c = inttoptr i64 %.4639.c to ptr
  tail call void %.4684.c(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3298

B3298:                                            ; preds = %B453.i, %B2930.if, %B3298.critedge
  br i1 %beyond.2.1, label %B108.i3528.preheader, label %B3382

B108.i3528.preheader:                             ; preds = %B3298
  br i1 %.794, label %B188.if.i4980.preheader, label %B108.if.i5045

B186.i3581.loopexit.critedge:                     ; preds = %B188.if.i4980
  %.625.i3806.c = icmp ult i64 %.361.i3400.010986, 8
  %.10618.c = select i1 %.625.i3806.c, i64 16, i64 17
  %.672.i3839.c = load i64, ptr %.671.i3838, align 8, !noalias !76
  %.744.i3896.c = mul i64 %.742.i3894, %.10618.c
  %.762.i3906.c = getelementptr double, ptr %arg.batch.5.0.4, i64 %.744.i3896.c
  %.788.i3916.c = inttoptr i64 %.672.i3839.c to ptr
  tail call void %.788.i3916.c(ptr %.571, ptr %.762.i3906.c, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !76
  br label %B186.i3581.loopexit

B186.i3581.loopexit:                              ; preds = %B770.i4026, %B186.i3581.loopexit.critedge
  %some.2.i3423.1.lcssa = phi i1 [ %some.4.i3396.010988, %B186.i3581.loopexit.critedge ], [ %some.3.i3444.2, %B770.i4026 ]
  %exitcond11120.not = icmp eq i64 %.431.i4988, 9
  br i1 %exitcond11120.not, label %B806.i3639.preheader, label %B188.if.i4980

B806.i3639.preheader:                             ; preds = %B186.i3581.loopexit
  br i1 %.794, label %B3302.endif.endif, label %B806.if.i3735

B222.i3788.loopexit:                              ; preds = %B122.if.i.i4948, %B222.if.i4963
  %.539.i3793 = icmp sgt i64 %.486.i3413.010980, 1
  br i1 %.539.i3793, label %B222.if.i4963, label %B284.i3802

B284.i3802:                                       ; preds = %B222.i3788.loopexit
  %.625.i3806 = icmp ult i64 %.361.i3400.010986, 8
  %.10618 = select i1 %.625.i3806, i64 16, i64 17
  %.672.i3839 = load i64, ptr %.671.i3838, align 8, !noalias !76
  %.744.i3896 = mul i64 %.742.i3894, %.10618
  %.762.i3906 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.744.i3896
  %.788.i3916 = inttoptr i64 %.672.i3839 to ptr
  tail call void %.788.i3916(ptr %.571, ptr %.762.i3906, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !76
  %.1181.i4269 = add nsw i64 %.361.i3400.010986, -1
  %.1182.i4270 = sitofp i64 %.1181.i4269 to double
  %.1187.i4271 = fmul double %.1182.i4270, 1.250000e-01
  %.1189.i4273 = uitofp i64 %.361.i3400.010986 to double
  %.1194.i4274 = fmul double %.1189.i4273, 1.250000e-01
  br label %B466.if.i4464

B508.i4031:                                       ; preds = %B466.if.i4464
  %.1028.i4080 = getelementptr double, ptr %62, i64 %.814.i3436.010982
  %.1029.i4081 = load double, ptr %.1028.i4080, align 8, !noalias !76
  %.1030.i4082 = fcmp ogt double %.1029.i4081, 5.000000e-01
  br i1 %.1030.i4082, label %B546.i4083, label %B770.i4026

B546.i4083:                                       ; preds = %B508.i4031
  %.1088.i4132 = getelementptr i64, ptr %63, i64 %.814.i3436.010982
  %.1089.i4133 = load i64, ptr %.1088.i4132, align 8, !noalias !76
  %.1090.i4134 = icmp slt i64 %.1089.i4133, 0
  br i1 %.1090.i4134, label %B34.i.i4191, label %B770.i4026

B34.i.i4191:                                      ; preds = %B546.i4083, %B36.i.i4407
  %.48.i.i3222.0 = phi i64 [ %.119.i88.i4455, %B36.i.i4407 ], [ 0, %B546.i4083 ]
  %exitcond11119.not = icmp eq i64 %.48.i.i3222.0, %storemerge10561
  br i1 %exitcond11119.not, label %B584.endif.i4223, label %B36.i.i4407

B36.i.i4407:                                      ; preds = %B34.i.i4191
  %.119.i88.i4455 = add i64 %.48.i.i3222.0, 1
  %.149.i53.i4413 = add nsw i64 %.48.i.i3222.0, %arg.shape.6
  %.151.i55.i4415 = mul nsw i64 %.149.i53.i4413, %arg.shape.0
  %.153.i56.i4417 = add nsw i64 %.151.i55.i4415, %.814.i3436.010982
  %.167.i61.i4425 = icmp slt i64 %.153.i56.i4417, 0
  %.168.i62.i4426 = select i1 %.167.i61.i4425, i64 %arg.batch.5.4.5.0, i64 0
  %210 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i56.i4417
  %.182.i74.i4436 = getelementptr double, ptr %210, i64 %.168.i62.i4426
  %.183.i75.i4437 = load double, ptr %.182.i74.i4436, align 8, !noalias !80
  %.184.i.i4438 = fcmp ogt double %.183.i75.i4437, 5.000000e-01
  br i1 %.184.i.i4438, label %B584.endif.i4223, label %B34.i.i4191

B732.i4353:                                       ; preds = %B584.endif.i4223
  %.1369.i4392 = load i64, ptr %.1088.i4132, align 8, !noalias !76
  %.1370.i4393 = icmp sgt i64 %.1369.i4392, -1
  br label %B770.i4026

B770.i4026:                                       ; preds = %B732.i4353, %B584.endif.i4223, %B546.i4083, %B508.i4031, %B466.if.i4464
  %some.3.i3444.2 = phi i1 [ %some.2.i3423.110984, %B466.if.i4464 ], [ %some.2.i3423.110984, %B546.i4083 ], [ %some.2.i3423.110984, %B508.i4031 ], [ true, %B584.endif.i4223 ], [ %.1370.i4393, %B732.i4353 ]
  %.870.i3956 = icmp sgt i64 %.817.i3437.010983, 1
  br i1 %.870.i3956, label %B466.if.i4464, label %B186.i3581.loopexit

B108.if.i5045:                                    ; preds = %B108.i3528.preheader, %B108.if.i5045
  %.179.i3387.010971 = phi i64 [ %.243.i5050, %B108.if.i5045 ], [ %storemerge, %B108.i3528.preheader ]
  %.176.i3386.010970 = phi i64 [ %.247.i5053, %B108.if.i5045 ], [ 0, %B108.i3528.preheader ]
  %.243.i5050 = add nsw i64 %.179.i3387.010971, -1
  %.247.i5053 = add nsw i64 %.176.i3386.010970, 1
  %211 = getelementptr i64, ptr %60, i64 %.176.i3386.010970
  store i64 -1, ptr %211, align 8, !noalias !76
  %.234.i3533 = icmp sgt i64 %.179.i3387.010971, 1
  br i1 %.234.i3533, label %B108.if.i5045, label %B188.if.i4980.preheader

B188.if.i4980.preheader:                          ; preds = %B108.if.i5045, %B108.i3528.preheader
  br label %B188.if.i4980

B188.if.i4980:                                    ; preds = %B188.if.i4980.preheader, %B186.i3581.loopexit
  %some.4.i3396.010988 = phi i1 [ %some.2.i3423.1.lcssa, %B186.i3581.loopexit ], [ false, %B188.if.i4980.preheader ]
  %.361.i3400.010986 = phi i64 [ %.431.i4988, %B186.i3581.loopexit ], [ 1, %B188.if.i4980.preheader ]
  %.431.i4988 = add nsw i64 %.361.i3400.010986, 1
  br i1 %.794, label %B186.i3581.loopexit.critedge, label %B222.if.i4963.lr.ph

B222.if.i4963.lr.ph:                              ; preds = %B188.if.i4980
  %.579.i4487 = uitofp i64 %.361.i3400.010986 to double
  %.584.i4488 = fmul double %.579.i4487, 1.250000e-01
  %.247.i.i.i4918 = fsub double 1.000000e+00, %.584.i4488
  br label %B222.if.i4963

B222.if.i4963:                                    ; preds = %B222.if.i4963.lr.ph, %B222.i3788.loopexit
  %.486.i3413.010980 = phi i64 [ %storemerge, %B222.if.i4963.lr.ph ], [ %.548.i4968, %B222.i3788.loopexit ]
  %.483.i3412.010979 = phi i64 [ 0, %B222.if.i4963.lr.ph ], [ %.552.i4971, %B222.i3788.loopexit ]
  %.548.i4968 = add nsw i64 %.486.i3413.010980, -1
  %.552.i4971 = add nsw i64 %.483.i3412.010979, 1
  %.92.i.i4568 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.483.i3412.010979
  %.93.i.i4569 = load double, ptr %.92.i.i4568, align 8, !noalias !84
  %.146.i.i4605 = getelementptr double, ptr %61, i64 %.483.i3412.010979
  %.147.i.i4606 = load double, ptr %.146.i.i4605, align 8, !noalias !84
  %.149.i.i4608 = fmul double %.584.i4488, %.147.i.i4606
  %.150.i.i4609 = fadd double %.93.i.i4569, %.149.i.i4608
  %.203.i.i4645 = getelementptr double, ptr %.571, i64 %.483.i3412.010979
  store double %.150.i.i4609, ptr %.203.i.i4645, align 8, !noalias !84
  br i1 %.287.i.i468210975.not, label %B222.i3788.loopexit, label %B122.if.i.i4948.preheader

B122.if.i.i4948.preheader:                        ; preds = %B222.if.i4963
  %invariant.gep11155 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3412.010979
  %invariant.gep11157 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3412.010979
  %invariant.gep11159 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3412.010979
  %invariant.gep11161 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3412.010979
  %invariant.gep11163 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3412.010979
  %invariant.gep11165 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3412.010979
  %invariant.gep11167 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3412.010979
  %invariant.gep11169 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3412.010979
  %invariant.gep11171 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3412.010979
  br label %B122.if.i.i4948

B122.if.i.i4948:                                  ; preds = %B122.if.i.i4948.preheader, %B122.if.i.i4948
  %.229.i.i3271.010976 = phi i64 [ %.300.i.i4954, %B122.if.i.i4948 ], [ 0, %B122.if.i.i4948.preheader ]
  %.157.i.i.i4875 = add nsw i64 %.155.i.i.i4873, %.229.i.i3271.010976
  %.159.i.i.i4877 = mul nsw i64 %.157.i.i.i4875, %arg.shape.0
  %gep11156 = getelementptr double, ptr %invariant.gep11155, i64 %.159.i.i.i4877
  %.191.i.i.i4899 = load double, ptr %gep11156, align 8, !noalias !88
  %.193.i.i.i4901 = fadd double %.191.i.i.i4899, 0.000000e+00
  %.253.i.i.i4923 = fmul double %.584.i4488, %.193.i.i.i4901
  %.157.i.i.i4875.1 = add nsw i64 %.155.i.i.i4873.1, %.229.i.i3271.010976
  %.159.i.i.i4877.1 = mul nsw i64 %.157.i.i.i4875.1, %arg.shape.0
  %gep11158 = getelementptr double, ptr %invariant.gep11157, i64 %.159.i.i.i4877.1
  %.191.i.i.i4899.1 = load double, ptr %gep11158, align 8, !noalias !88
  %.193.i.i.i4901.1 = fadd double %.253.i.i.i4923, %.191.i.i.i4899.1
  %.253.i.i.i4923.1 = fmul double %.247.i.i.i4918, %.193.i.i.i4901.1
  %.157.i.i.i4875.2 = add nsw i64 %.155.i.i.i4873.2, %.229.i.i3271.010976
  %.159.i.i.i4877.2 = mul nsw i64 %.157.i.i.i4875.2, %arg.shape.0
  %gep11160 = getelementptr double, ptr %invariant.gep11159, i64 %.159.i.i.i4877.2
  %.191.i.i.i4899.2 = load double, ptr %gep11160, align 8, !noalias !88
  %.193.i.i.i4901.2 = fadd double %.253.i.i.i4923.1, %.191.i.i.i4899.2
  %.253.i.i.i4923.2 = fmul double %.584.i4488, %.193.i.i.i4901.2
  %.157.i.i.i4875.3 = add nsw i64 %.155.i.i.i4873.3, %.229.i.i3271.010976
  %.159.i.i.i4877.3 = mul nsw i64 %.157.i.i.i4875.3, %arg.shape.0
  %gep11162 = getelementptr double, ptr %invariant.gep11161, i64 %.159.i.i.i4877.3
  %.191.i.i.i4899.3 = load double, ptr %gep11162, align 8, !noalias !88
  %.193.i.i.i4901.3 = fadd double %.253.i.i.i4923.2, %.191.i.i.i4899.3
  %.253.i.i.i4923.3 = fmul double %.247.i.i.i4918, %.193.i.i.i4901.3
  %.157.i.i.i4875.4 = add nsw i64 %.155.i.i.i4873.4, %.229.i.i3271.010976
  %.159.i.i.i4877.4 = mul nsw i64 %.157.i.i.i4875.4, %arg.shape.0
  %gep11164 = getelementptr double, ptr %invariant.gep11163, i64 %.159.i.i.i4877.4
  %.191.i.i.i4899.4 = load double, ptr %gep11164, align 8, !noalias !88
  %.193.i.i.i4901.4 = fadd double %.253.i.i.i4923.3, %.191.i.i.i4899.4
  %.253.i.i.i4923.4 = fmul double %.584.i4488, %.193.i.i.i4901.4
  %.157.i.i.i4875.5 = add nsw i64 %.155.i.i.i4873.5, %.229.i.i3271.010976
  %.159.i.i.i4877.5 = mul nsw i64 %.157.i.i.i4875.5, %arg.shape.0
  %gep11166 = getelementptr double, ptr %invariant.gep11165, i64 %.159.i.i.i4877.5
  %.191.i.i.i4899.5 = load double, ptr %gep11166, align 8, !noalias !88
  %.193.i.i.i4901.5 = fadd double %.253.i.i.i4923.4, %.191.i.i.i4899.5
  %.253.i.i.i4923.5 = fmul double %.247.i.i.i4918, %.193.i.i.i4901.5
  %.157.i.i.i4875.6 = add nsw i64 %.155.i.i.i4873.6, %.229.i.i3271.010976
  %.159.i.i.i4877.6 = mul nsw i64 %.157.i.i.i4875.6, %arg.shape.0
  %gep11168 = getelementptr double, ptr %invariant.gep11167, i64 %.159.i.i.i4877.6
  %.191.i.i.i4899.6 = load double, ptr %gep11168, align 8, !noalias !88
  %.193.i.i.i4901.6 = fadd double %.253.i.i.i4923.5, %.191.i.i.i4899.6
  %.253.i.i.i4923.6 = fmul double %.584.i4488, %.193.i.i.i4901.6
  %.300.i.i4954 = add nsw i64 %.229.i.i3271.010976, 1
  %.271.i.i.i4796 = mul nsw i64 %.229.i.i3271.010976, %arg.shape.0
  %gep11170 = getelementptr double, ptr %invariant.gep11169, i64 %.271.i.i.i4796
  %.309.i.i.i4821 = load double, ptr %gep11170, align 8, !noalias !88
  %.313.i.i.i4824 = fadd double %.253.i.i.i4923.6, %.309.i.i.i4821
  %.359.i.i4837 = add nsw i64 %.229.i.i3271.010976, %.358.i.i4836
  %.361.i.i4839 = mul nsw i64 %.359.i.i4837, %arg.shape.0
  %gep11172 = getelementptr double, ptr %invariant.gep11171, i64 %.361.i.i4839
  store double %.313.i.i.i4824, ptr %gep11172, align 8, !noalias !84
  %exitcond11118.not = icmp eq i64 %arg.shape.1, %.300.i.i4954
  br i1 %exitcond11118.not, label %B222.i3788.loopexit, label %B122.if.i.i4948

B466.if.i4464:                                    ; preds = %B284.i3802, %B770.i4026
  %some.2.i3423.110984 = phi i1 [ %some.4.i3396.010988, %B284.i3802 ], [ %some.3.i3444.2, %B770.i4026 ]
  %.817.i3437.010983 = phi i64 [ %storemerge, %B284.i3802 ], [ %.879.i4468, %B770.i4026 ]
  %.814.i3436.010982 = phi i64 [ 0, %B284.i3802 ], [ %.883.i4471, %B770.i4026 ]
  %.879.i4468 = add nsw i64 %.817.i3437.010983, -1
  %.883.i4471 = add nsw i64 %.814.i3436.010982, 1
  %.968.i4023 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.814.i3436.010982
  %.969.i4024 = load i64, ptr %.968.i4023, align 8, !noalias !76
  %.970.i4025 = icmp sgt i64 %.969.i4024, -1
  br i1 %.970.i4025, label %B508.i4031, label %B770.i4026

B584.endif.i4223:                                 ; preds = %B36.i.i4407, %B34.i.i4191
  %.1099.i3449.0 = phi i64 [ %.48.i.i3222.0, %B36.i.i4407 ], [ -1, %B34.i.i4191 ]
  store i64 %.1099.i3449.0, ptr %.1088.i4132, align 8, !noalias !76
  %.1248.i4311 = getelementptr double, ptr %64, i64 %.814.i3436.010982
  store double %.1187.i4271, ptr %.1248.i4311, align 8, !noalias !76
  %.1303.i4348 = getelementptr double, ptr %65, i64 %.814.i3436.010982
  store double %.1194.i4274, ptr %.1303.i4348, align 8, !noalias !76
  br i1 %some.2.i3423.110984, label %B770.i4026, label %B732.i4353

B806.if.i3735:                                    ; preds = %B806.i3639.preheader, %B806.if.i3735
  %.1453.i3460.010991 = phi i64 [ %.1515.i3738, %B806.if.i3735 ], [ %storemerge, %B806.i3639.preheader ]
  %.1450.i3459.010990 = phi i64 [ %.1519.i3741, %B806.if.i3735 ], [ 0, %B806.i3639.preheader ]
  %.1515.i3738 = add nsw i64 %.1453.i3460.010991, -1
  %.1519.i3741 = add nsw i64 %.1450.i3459.010990, 1
  %.1596.i3697 = getelementptr double, ptr %66, i64 %.1450.i3459.010990
  %.1597.i3698 = load double, ptr %.1596.i3697, align 8, !noalias !76
  %.1650.i3734 = getelementptr double, ptr %.571, i64 %.1450.i3459.010990
  store double %.1597.i3698, ptr %.1650.i3734, align 8, !noalias !76
  %.1506.i3644 = icmp sgt i64 %.1453.i3460.010991, 1
  br i1 %.1506.i3644, label %B806.if.i3735, label %B3302.endif.endif

B3340:                                            ; preds = %B3302.endif.endif
  %.222.i = load double, ptr %.221.i, align 8, !noalias !92
  %.251.i = load double, ptr %arg.batch.2.4, align 8, !noalias !92
  %.252.i = fsub double %.222.i, %.251.i
  %.253.i = fmul double %.252.i, 1.000000e-13
  br i1 %.794, label %B150.if.i.i.preheader, label %B70.if.i.i.preheader

B70.if.i.i.preheader:                             ; preds = %B3340
  tail call void @llvm.memset.p0.i64(ptr align 8 %68, i8 0, i64 %126, i1 false), !noalias !95
  br label %B150.if.i.i.preheader

B150.if.i.i.preheader:                            ; preds = %B70.if.i.i.preheader, %B3340
  br label %B150.if.i.i

B148.i.loopexit.i:                                ; preds = %B928.i.loopexit.i, %B294.endif.endif.i.i
  %exitcond2952.not.i = icmp eq i64 %.417.i.i, 9
  br i1 %exitcond2952.not.i, label %B220.preheader.i, label %B150.if.i.i

B220.preheader.i:                                 ; preds = %B148.i.loopexit.i
  br i1 %.794, label %B478.preheader.i, label %B220.if.i

B184.i.loopexit.i:                                ; preds = %B122.if.i.i.i, %B184.if.i.i
  %exitcond2947.not.i = icmp eq i64 %arg.shape.0, %.538.i.i
  br i1 %exitcond2947.not.i, label %B246.i.i, label %B184.if.i.i

B246.i.i:                                         ; preds = %B184.i.loopexit.i, %B150.if.i.i
  %.611.i.i = icmp ult i64 %.347.i.02919.i, 8
  %..i10666 = select i1 %.611.i.i, i64 16, i64 17
  %.628.i.i = mul i64 %..i10666, %.463
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
  %212 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.53.i17.i.02907.i
  %.178.i74.i.i = load double, ptr %212, align 8, !noalias !99
  %.180.i76.i.i = add nsw i64 %.53.i17.i.02907.i, %.922.i.i
  %.194.i84.i.i = icmp slt i64 %.180.i76.i.i, 0
  %.195.i85.i.i = select i1 %.194.i84.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %213 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.180.i76.i.i
  %.209.i.i.i = getelementptr double, ptr %213, i64 %.195.i85.i.i
  %.210.i.i.i = load double, ptr %.209.i.i.i, align 8, !noalias !99
  store double %.178.i74.i.i, ptr %.209.i.i.i, align 8, !noalias !99
  store double %.210.i.i.i, ptr %212, align 8, !noalias !99
  %exitcond2948.not.i = icmp eq i64 %.925.i.i, %.124.i128.i.i
  br i1 %exitcond2948.not.i, label %B294.endif.i.i, label %B34.if.i.i.i

B928.i.loopexit.i:                                ; preds = %B962.if.i.i, %B928.if.i.i
  %exitcond2951.not.i = icmp eq i64 %arg.shape.0, %.1519.i.i
  br i1 %exitcond2951.not.i, label %B148.i.loopexit.i, label %B928.if.i.i

B150.if.i.i:                                      ; preds = %B150.if.i.i.preheader, %B148.i.loopexit.i
  %.347.i.02919.i = phi i64 [ %.417.i.i, %B148.i.loopexit.i ], [ 1, %B150.if.i.i.preheader ]
  %.417.i.i = add nsw i64 %.347.i.02919.i, 1
  br i1 %.794, label %B246.i.i, label %B184.if.i.lr.ph.i

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
  %.146.i.i.i = getelementptr double, ptr %69, i64 %.469.i.02904.i
  %.147.i.i.i = load double, ptr %.146.i.i.i, align 8, !noalias !103
  %.149.i.i.i = fmul double %.570.i.i, %.147.i.i.i
  %.150.i.i.i10665 = fadd double %.93.i.i.i, %.149.i.i.i
  %.203.i.i.i = getelementptr double, ptr %.571, i64 %.469.i.02904.i
  store double %.150.i.i.i10665, ptr %.203.i.i.i, align 8, !noalias !103
  br i1 %.287.i.i2900.not.i, label %B184.i.loopexit.i, label %B122.if.i.i.preheader.i

B122.if.i.i.preheader.i:                          ; preds = %B184.if.i.i
  %invariant.gep10992 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10994 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10996 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10998 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep11000 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep11002 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep11004 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep11006 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep11008 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  br label %B122.if.i.i.i

B122.if.i.i.i:                                    ; preds = %B122.if.i.i.i, %B122.if.i.i.preheader.i
  %.229.i.i.02901.i = phi i64 [ %.300.i.i.i, %B122.if.i.i.i ], [ 0, %B122.if.i.i.preheader.i ]
  %.157.i.i.i.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.i
  %.159.i.i.i.i = mul nsw i64 %.157.i.i.i.i, %arg.shape.0
  %gep10993 = getelementptr double, ptr %invariant.gep10992, i64 %.159.i.i.i.i
  %.191.i.i.i.i = load double, ptr %gep10993, align 8, !noalias !107
  %.193.i.i.i.i = fadd double %.191.i.i.i.i, 0.000000e+00
  %.253.i.i.i.i = fmul double %.570.i.i, %.193.i.i.i.i
  %.157.i.i.i.1.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.1.i
  %.159.i.i.i.1.i = mul nsw i64 %.157.i.i.i.1.i, %arg.shape.0
  %gep10995 = getelementptr double, ptr %invariant.gep10994, i64 %.159.i.i.i.1.i
  %.191.i.i.i.1.i = load double, ptr %gep10995, align 8, !noalias !107
  %.193.i.i.i.1.i = fadd double %.191.i.i.i.1.i, %.253.i.i.i.i
  %.253.i.i.i.1.i = fmul double %.247.i.i.i.i, %.193.i.i.i.1.i
  %.157.i.i.i.2.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.2.i
  %.159.i.i.i.2.i = mul nsw i64 %.157.i.i.i.2.i, %arg.shape.0
  %gep10997 = getelementptr double, ptr %invariant.gep10996, i64 %.159.i.i.i.2.i
  %.191.i.i.i.2.i = load double, ptr %gep10997, align 8, !noalias !107
  %.193.i.i.i.2.i = fadd double %.191.i.i.i.2.i, %.253.i.i.i.1.i
  %.253.i.i.i.2.i = fmul double %.570.i.i, %.193.i.i.i.2.i
  %.157.i.i.i.3.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.3.i
  %.159.i.i.i.3.i = mul nsw i64 %.157.i.i.i.3.i, %arg.shape.0
  %gep10999 = getelementptr double, ptr %invariant.gep10998, i64 %.159.i.i.i.3.i
  %.191.i.i.i.3.i = load double, ptr %gep10999, align 8, !noalias !107
  %.193.i.i.i.3.i = fadd double %.191.i.i.i.3.i, %.253.i.i.i.2.i
  %.253.i.i.i.3.i = fmul double %.247.i.i.i.i, %.193.i.i.i.3.i
  %.157.i.i.i.4.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.4.i
  %.159.i.i.i.4.i = mul nsw i64 %.157.i.i.i.4.i, %arg.shape.0
  %gep11001 = getelementptr double, ptr %invariant.gep11000, i64 %.159.i.i.i.4.i
  %.191.i.i.i.4.i = load double, ptr %gep11001, align 8, !noalias !107
  %.193.i.i.i.4.i = fadd double %.191.i.i.i.4.i, %.253.i.i.i.3.i
  %.253.i.i.i.4.i = fmul double %.570.i.i, %.193.i.i.i.4.i
  %.157.i.i.i.5.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.5.i
  %.159.i.i.i.5.i = mul nsw i64 %.157.i.i.i.5.i, %arg.shape.0
  %gep11003 = getelementptr double, ptr %invariant.gep11002, i64 %.159.i.i.i.5.i
  %.191.i.i.i.5.i = load double, ptr %gep11003, align 8, !noalias !107
  %.193.i.i.i.5.i = fadd double %.191.i.i.i.5.i, %.253.i.i.i.4.i
  %.253.i.i.i.5.i = fmul double %.247.i.i.i.i, %.193.i.i.i.5.i
  %.157.i.i.i.6.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.6.i
  %.159.i.i.i.6.i = mul nsw i64 %.157.i.i.i.6.i, %arg.shape.0
  %gep11005 = getelementptr double, ptr %invariant.gep11004, i64 %.159.i.i.i.6.i
  %.191.i.i.i.6.i = load double, ptr %gep11005, align 8, !noalias !107
  %.193.i.i.i.6.i = fadd double %.191.i.i.i.6.i, %.253.i.i.i.5.i
  %.253.i.i.i.6.i = fmul double %.570.i.i, %.193.i.i.i.6.i
  %.300.i.i.i = add nsw i64 %.229.i.i.02901.i, 1
  %.271.i.i.i.i = mul nsw i64 %.229.i.i.02901.i, %arg.shape.0
  %gep11007 = getelementptr double, ptr %invariant.gep11006, i64 %.271.i.i.i.i
  %.309.i.i.i.i = load double, ptr %gep11007, align 8, !noalias !107
  %.313.i.i.i.i = fadd double %.309.i.i.i.i, %.253.i.i.i.6.i
  %.359.i.i.i = add nsw i64 %.229.i.i.02901.i, %.358.i.i.i
  %.361.i.i.i = mul nsw i64 %.359.i.i.i, %arg.shape.0
  %gep11009 = getelementptr double, ptr %invariant.gep11008, i64 %.361.i.i.i
  store double %.313.i.i.i.i, ptr %gep11009, align 8, !noalias !103
  %exitcond2946.not.i = icmp eq i64 %arg.shape.1, %.300.i.i.i
  br i1 %exitcond2946.not.i, label %B184.i.loopexit.i, label %B122.if.i.i.i

B294.endif.i.i:                                   ; preds = %B34.if.i.i.i
  %.985.i.i10667 = load i64, ptr %.984.i.i10664, align 8, !noalias !95
  %.1097.i.i10668 = inttoptr i64 %.985.i.i10667 to ptr
  tail call void %.1097.i.i10668(ptr %.571, ptr %.744.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !95
  %.1128.i.i = load i64, ptr %arg.code.4, align 8, !noalias !95
  %.1244.i.i = inttoptr i64 %.1128.i.i to ptr
  tail call void %.1244.i.i(ptr %.571, ptr %.744.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1243.i.i), !noalias !95
  br label %B34.if.i321.i.i

B34.if.i321.i.i:                                  ; preds = %B294.endif.i.i, %B34.if.i321.i.i
  %.53.i162.i.02910.i = phi i64 [ %.124.i328.i.i, %B34.if.i321.i.i ], [ 0, %B294.endif.i.i ]
  %.124.i328.i.i = add nsw i64 %.53.i162.i.02910.i, 1
  %214 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.53.i162.i.02910.i
  %.178.i253.i.i = load double, ptr %214, align 8, !noalias !111
  %.180.i255.i.i = add nsw i64 %.53.i162.i.02910.i, %.922.i.i
  %.194.i264.i.i = icmp slt i64 %.180.i255.i.i, 0
  %.195.i265.i.i = select i1 %.194.i264.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %215 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.180.i255.i.i
  %.209.i275.i.i = getelementptr double, ptr %215, i64 %.195.i265.i.i
  %.210.i276.i.i = load double, ptr %.209.i275.i.i, align 8, !noalias !111
  store double %.178.i253.i.i, ptr %.209.i275.i.i, align 8, !noalias !111
  store double %.210.i276.i.i, ptr %214, align 8, !noalias !111
  %exitcond2949.not.i = icmp eq i64 %.925.i.i, %.124.i328.i.i
  br i1 %exitcond2949.not.i, label %B294.endif.endif.i.i, label %B34.if.i321.i.i

B294.endif.endif.i.i.critedge:                    ; preds = %B246.i.i
  %.985.i.i10667.c = load i64, ptr %.984.i.i10664, align 8, !noalias !95
  %.1097.i.i10668.c = inttoptr i64 %.985.i.i10667.c to ptr
  tail call void %.1097.i.i10668.c(ptr %.571, ptr %.744.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !95
  %.1128.i.i.c = load i64, ptr %arg.code.4, align 8, !noalias !95
  %.1244.i.i.c = inttoptr i64 %.1128.i.i.c to ptr
  tail call void %.1244.i.i.c(ptr %.571, ptr %.744.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1243.i.i), !noalias !95
  br label %B294.endif.endif.i.i

B294.endif.endif.i.i:                             ; preds = %B34.if.i321.i.i, %B294.endif.endif.i.i.critedge
  %.1312.i.i = load i64, ptr %.984.i.i10664, align 8, !noalias !95
  %.1424.i.i = inttoptr i64 %.1312.i.i to ptr
  tail call void %.1424.i.i(ptr %.571, ptr %.744.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !95
  br i1 %.794, label %B148.i.loopexit.i, label %B928.if.i.i

B928.if.i.i:                                      ; preds = %B294.endif.endif.i.i, %B928.i.loopexit.i
  %.1450.i.02916.i = phi i64 [ %.1519.i.i, %B928.i.loopexit.i ], [ 0, %B294.endif.endif.i.i ]
  %.1519.i.i = add nsw i64 %.1450.i.02916.i, 1
  br i1 %.287.i.i2900.not.i, label %B928.i.loopexit.i, label %B962.if.i.lr.ph.i

B962.if.i.lr.ph.i:                                ; preds = %B928.if.i.i
  %.1891.i.i = getelementptr double, ptr %69, i64 %.1450.i.02916.i
  %.1974.i.i = getelementptr double, ptr %70, i64 %.1450.i.02916.i
  br label %B962.if.i.i

B962.if.i.i:                                      ; preds = %B962.if.i.i, %B962.if.i.lr.ph.i
  %.1571.i.02913.i = phi i64 [ 0, %B962.if.i.lr.ph.i ], [ %.1640.i.i, %B962.if.i.i ]
  %.1640.i.i = add nsw i64 %.1571.i.02913.i, 1
  %216 = mul nsw i64 %.1571.i.02913.i, %arg.shape.0
  %.1668.i.i = add nsw i64 %216, %.1450.i.02916.i
  %217 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1668.i.i
  %.1698.i.i = load double, ptr %217, align 8, !noalias !95
  %.1707.i.i = add nsw i64 %.1668.i.i, %factor.op.mul2918.i.reass
  %.1721.i.i = icmp slt i64 %.1707.i.i, 0
  %.1722.i.i = select i1 %.1721.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %218 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1707.i.i
  %.1736.i.i = getelementptr double, ptr %218, i64 %.1722.i.i
  %.1737.i.i = load double, ptr %.1736.i.i, align 8, !noalias !95
  %.1742.i.i = add nsw i64 %.1668.i.i, %factor.op.mul.i.reass
  %.1756.i.i = icmp slt i64 %.1742.i.i, 0
  %.1757.i.i = select i1 %.1756.i.i, i64 %arg.batch.5.0.5.0, i64 0
  %219 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1742.i.i
  %.1771.i.i = getelementptr double, ptr %219, i64 %.1757.i.i
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
  %.10.i.i.i10669 = fcmp ogt double %.1897.i..i, %.1975.i.i
  %.11.i.i.i10670 = select i1 %.10.i.i.i10669, double %.1897.i..i, double %.1975.i.i
  store double %.11.i.i.i10670, ptr %.1974.i.i, align 8, !noalias !95
  %exitcond2950.not.i = icmp eq i64 %arg.shape.1, %.1640.i.i
  br i1 %exitcond2950.not.i, label %B928.i.loopexit.i, label %B962.if.i.i

B478.preheader.i:                                 ; preds = %B1557.i, %B220.preheader.i
  %halvings.2.0.lcssa.i = phi i64 [ 0, %B220.preheader.i ], [ %halvings.3.1.i, %B1557.i ]
  %.8492938.i = icmp sgt i64 %halvings.2.0.lcssa.i, 0
  br i1 %.8492938.i, label %B480.if.i, label %B1058.preheader.i

B262.i:                                           ; preds = %B220.if.i
  %220 = getelementptr double, ptr %70, i64 %.377.02922.i
  %.585.i = load double, ptr %220, align 8, !noalias !92
  %.586.i = fcmp ogt double %.585.i, 1.000000e-01
  %.mux.i = select i1 %.586.i, i64 50, i64 %halvings.2.02924.i
  br i1 %.586.i, label %B1557.i, label %B34.i.i10684

B34.i.i10684:                                     ; preds = %B262.i, %B34.if.i.i10685
  %.48.i.0.i = phi i64 [ %.119.i60.i, %B34.if.i.i10685 ], [ 0, %B262.i ]
  %exitcond2953.not.i = icmp eq i64 %.48.i.0.i, %storemerge2877.i
  br i1 %exitcond2953.not.i, label %B364.endif.i, label %B34.if.i.i10685

B80.i.i10686:                                     ; preds = %B34.if.i.i10685
  %221 = icmp sgt i64 %.48.i.0.i, -1
  %222 = select i1 %221, double 1.000000e+00, double 0.000000e+00
  br label %B364.endif.i

B34.if.i.i10685:                                  ; preds = %B34.i.i10684
  %.119.i60.i = add i64 %.48.i.0.i, 1
  %.149.i.i = add nsw i64 %.48.i.0.i, %arg.shape.6
  %.151.i.i = mul nsw i64 %.149.i.i, %arg.shape.0
  %.153.i.i = add nsw i64 %.151.i.i, %.377.02922.i
  %.167.i45.i = icmp slt i64 %.153.i.i, 0
  %.168.i46.i = select i1 %.167.i45.i, i64 %arg.batch.5.4.5.0, i64 0
  %223 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i.i
  %.182.i52.i = getelementptr double, ptr %223, i64 %.168.i46.i
  %.183.i53.i = load double, ptr %.182.i52.i, align 8, !noalias !115
  %.184.i54.i = fcmp ogt double %.183.i53.i, 5.000000e-01
  br i1 %.184.i54.i, label %B80.i.i10686, label %B34.i.i10684

B478.loopexit.i.critedge:                         ; preds = %B480.if.i
  %.1184.i.c = load i64, ptr %.657.i.i, align 8, !noalias !92
  %.1300.i.c = inttoptr i64 %.1184.i.c to ptr
  tail call void %.1300.i.c(ptr %.571, ptr %.1274.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !92
  br label %B478.loopexit.i

B478.loopexit.i:                                  ; preds = %B1559.i, %B478.loopexit.i.critedge
  %.849.i = icmp sgt i64 %.795.02939.i, 1
  br i1 %.849.i, label %B480.if.i, label %B1058.preheader.i

B1058.preheader.i:                                ; preds = %B478.loopexit.i, %B478.preheader.i
  br i1 %.794, label %B3382, label %B1058.if.lr.ph.i

B1058.if.lr.ph.i:                                 ; preds = %B1058.preheader.i
  %.2389.i = fmul double %.253.i, 2.000000e+00
  br label %B1058.if.i

B514.loopexit.i:                                  ; preds = %B122.if.i.i10681, %B514.if.i
  %exitcond2957.not.i = icmp eq i64 %arg.shape.0, %.980.i
  br i1 %exitcond2957.not.i, label %B628.i, label %B514.if.i

B122.if.i.i10681:                                 ; preds = %B122.if.i.lr.ph.i, %B122.if.i.i10681
  %.229.i.02929.i = phi i64 [ 0, %B122.if.i.lr.ph.i ], [ %.300.i567.i, %B122.if.i.i10681 ]
  %.157.i.i501.i = add nsw i64 %.229.i.02929.i, %.155.i.i.i10680
  %.159.i.i503.i = mul nsw i64 %.157.i.i501.i, %arg.shape.0
  %gep11011 = getelementptr double, ptr %invariant.gep11010, i64 %.159.i.i503.i
  %.191.i.i523.i = load double, ptr %gep11011, align 8, !noalias !119
  %.193.i.i525.i = fadd double %.191.i.i523.i, 0.000000e+00
  %.253.i.i540.i = fmul double %.1114.i, %.193.i.i525.i
  %.157.i.i501.1.i = add nsw i64 %.229.i.02929.i, %.155.i.i.1.i
  %.159.i.i503.1.i = mul nsw i64 %.157.i.i501.1.i, %arg.shape.0
  %gep11013 = getelementptr double, ptr %invariant.gep11012, i64 %.159.i.i503.1.i
  %.191.i.i523.1.i = load double, ptr %gep11013, align 8, !noalias !119
  %.193.i.i525.1.i = fadd double %.191.i.i523.1.i, %.253.i.i540.i
  %.253.i.i540.1.i = fmul double %.247.i.i.i10679, %.193.i.i525.1.i
  %.157.i.i501.2.i = add nsw i64 %.229.i.02929.i, %.155.i.i.2.i
  %.159.i.i503.2.i = mul nsw i64 %.157.i.i501.2.i, %arg.shape.0
  %gep11015 = getelementptr double, ptr %invariant.gep11014, i64 %.159.i.i503.2.i
  %.191.i.i523.2.i = load double, ptr %gep11015, align 8, !noalias !119
  %.193.i.i525.2.i = fadd double %.191.i.i523.2.i, %.253.i.i540.1.i
  %.253.i.i540.2.i = fmul double %.1114.i, %.193.i.i525.2.i
  %.157.i.i501.3.i = add nsw i64 %.229.i.02929.i, %.155.i.i.3.i
  %.159.i.i503.3.i = mul nsw i64 %.157.i.i501.3.i, %arg.shape.0
  %gep11017 = getelementptr double, ptr %invariant.gep11016, i64 %.159.i.i503.3.i
  %.191.i.i523.3.i = load double, ptr %gep11017, align 8, !noalias !119
  %.193.i.i525.3.i = fadd double %.191.i.i523.3.i, %.253.i.i540.2.i
  %.253.i.i540.3.i = fmul double %.247.i.i.i10679, %.193.i.i525.3.i
  %.157.i.i501.4.i = add nsw i64 %.229.i.02929.i, %.155.i.i.4.i
  %.159.i.i503.4.i = mul nsw i64 %.157.i.i501.4.i, %arg.shape.0
  %gep11019 = getelementptr double, ptr %invariant.gep11018, i64 %.159.i.i503.4.i
  %.191.i.i523.4.i = load double, ptr %gep11019, align 8, !noalias !119
  %.193.i.i525.4.i = fadd double %.191.i.i523.4.i, %.253.i.i540.3.i
  %.253.i.i540.4.i = fmul double %.1114.i, %.193.i.i525.4.i
  %.157.i.i501.5.i = add nsw i64 %.229.i.02929.i, %.155.i.i.5.i
  %.159.i.i503.5.i = mul nsw i64 %.157.i.i501.5.i, %arg.shape.0
  %gep11021 = getelementptr double, ptr %invariant.gep11020, i64 %.159.i.i503.5.i
  %.191.i.i523.5.i = load double, ptr %gep11021, align 8, !noalias !119
  %.193.i.i525.5.i = fadd double %.191.i.i523.5.i, %.253.i.i540.4.i
  %.253.i.i540.5.i = fmul double %.247.i.i.i10679, %.193.i.i525.5.i
  %.157.i.i501.6.i = add nsw i64 %.229.i.02929.i, %.155.i.i.6.i
  %.159.i.i503.6.i = mul nsw i64 %.157.i.i501.6.i, %arg.shape.0
  %gep11023 = getelementptr double, ptr %invariant.gep11022, i64 %.159.i.i503.6.i
  %.191.i.i523.6.i = load double, ptr %gep11023, align 8, !noalias !119
  %.193.i.i525.6.i = fadd double %.191.i.i523.6.i, %.253.i.i540.5.i
  %.253.i.i540.6.i = fmul double %.1114.i, %.193.i.i525.6.i
  %.300.i567.i = add nsw i64 %.229.i.02929.i, 1
  %.271.i.i451.i = mul nsw i64 %.229.i.02929.i, %arg.shape.0
  %gep11025 = getelementptr double, ptr %invariant.gep11024, i64 %.271.i.i451.i
  %.309.i.i.i10682 = load double, ptr %gep11025, align 8, !noalias !119
  %.313.i.i.i10683 = fadd double %.309.i.i.i10682, %.253.i.i540.6.i
  %.359.i.i = add nsw i64 %.229.i.02929.i, %.358.i.i.i
  %.361.i477.i = mul nsw i64 %.359.i.i, %arg.shape.0
  %gep11027 = getelementptr double, ptr %invariant.gep11026, i64 %.361.i477.i
  store double %.313.i.i.i10683, ptr %gep11027, align 8, !noalias !126
  %exitcond2956.not.i = icmp eq i64 %arg.shape.1, %.300.i567.i
  br i1 %exitcond2956.not.i, label %B514.loopexit.i, label %B122.if.i.i10681

B628.i:                                           ; preds = %B514.loopexit.i
  %.1184.i = load i64, ptr %.657.i.i, align 8, !noalias !92
  %.1300.i = inttoptr i64 %.1184.i to ptr
  tail call void %.1300.i(ptr %.571, ptr %.1274.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !92
  br label %B770.if.i

B812.i:                                           ; preds = %B770.if.i
  %.1533.i = getelementptr double, ptr %70, i64 %.1326.02935.i
  %.1534.i = load double, ptr %.1533.i, align 8, !noalias !92
  %.1535.i = fcmp ogt double %.1534.i, 1.000000e-01
  br i1 %.1535.i, label %B860.i, label %B1559.i

B860.i:                                           ; preds = %B812.i
  %.1590.i = getelementptr double, ptr %73, i64 %.1326.02935.i
  %.1591.i = load double, ptr %.1590.i, align 8, !noalias !92
  %.1645.i = getelementptr double, ptr %74, i64 %.1326.02935.i
  %.1646.i = load double, ptr %.1645.i, align 8, !noalias !92
  %.1647.i = fadd double %.1591.i, %.1646.i
  %.1648.i = fmul double %.1647.i, 5.000000e-01
  br label %B34.i127.i

B34.i127.i:                                       ; preds = %B34.if.i192.i, %B860.i
  %.48.i85.0.i = phi i64 [ 0, %B860.i ], [ %.119.i199.i, %B34.if.i192.i ]
  %exitcond2958.not.i = icmp eq i64 %.48.i85.0.i, %storemerge2869.i
  br i1 %exitcond2958.not.i, label %B998.i, label %B34.if.i192.i

B80.i184.i:                                       ; preds = %B34.if.i192.i
  %224 = icmp sgt i64 %.48.i85.0.i, -1
  br i1 %224, label %B972.i, label %B998.i

B34.if.i192.i:                                    ; preds = %B34.i127.i
  %.119.i199.i = add i64 %.48.i85.0.i, 1
  %.149.i153.i = add nsw i64 %.48.i85.0.i, %arg.shape.6
  %.151.i155.i = mul nsw i64 %.149.i153.i, %arg.shape.0
  %.153.i157.i = add nsw i64 %.151.i155.i, %.1326.02935.i
  %.167.i166.i = icmp slt i64 %.153.i157.i, 0
  %.168.i167.i = select i1 %.167.i166.i, i64 %arg.batch.5.4.5.0, i64 0
  %225 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i157.i
  %.182.i179.i = getelementptr double, ptr %225, i64 %.168.i167.i
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
  %.2178.i = getelementptr double, ptr %70, i64 %.1861.02941.i
  %.2179.i = load double, ptr %.2178.i, align 8, !noalias !92
  %.2180.i = fcmp ogt double %.2179.i, 1.000000e-01
  br i1 %.2180.i, label %B1198.i, label %B1558.i

B1198.i:                                          ; preds = %B1150.i
  %.2235.i = getelementptr double, ptr %69, i64 %.1861.02941.i
  %.2236.i = load double, ptr %.2235.i, align 8, !noalias !92
  %.2292.i = load double, ptr %.2011.i, align 8, !noalias !92
  %.2293.i = tail call double @llvm.fabs.f64(double %.2292.i)
  %.2294.i = fmul double %.2293.i, 2.000000e-12
  %.2351.i = getelementptr double, ptr %78, i64 %.1861.02941.i
  %.2352.i = load double, ptr %.2351.i, align 8, !noalias !92
  %.2357.i = fmul double %.2236.i, 0x3D719799812DEA11
  %.10.i.i10672 = fcmp ogt double %.2294.i, %.2357.i
  %.11.i.i10673 = select i1 %.10.i.i10672, double %.2294.i, double %.2357.i
  %.2353.i = fsub double 1.000000e+00, %.2352.i
  %.2355.i = fmul double %.2236.i, %.2353.i
  %.2386.i = fcmp ugt double %.2355.i, %.11.i.i10673
  %.2391.i = fcmp ugt double %.2236.i, %.2389.i
  %or.cond.i = select i1 %.2386.i, i1 %.2391.i, i1 false
  br i1 %or.cond.i, label %B1458.i, label %B1422.i

B1422.i:                                          ; preds = %B1198.i
  %.2450.i = getelementptr double, ptr %79, i64 %.1861.02941.i
  store double 1.000000e+00, ptr %.2450.i, align 8, !noalias !92
  br label %B1558.i

B1458.i:                                          ; preds = %B1198.i
  %.2507.i = getelementptr double, ptr %80, i64 %.1861.02941.i
  %.2508.i = load double, ptr %.2507.i, align 8, !noalias !92
  %.2510.i = fmul double %.2236.i, %.2508.i
  %.10.i2890.i = fcmp ogt double %.253.i, %.2510.i
  %.11.i2891.i = select i1 %.10.i2890.i, double %.253.i, double %.2510.i
  %.108.i.i = getelementptr double, ptr %81, i64 %.1861.02941.i
  store double 0.000000e+00, ptr %.108.i.i, align 8, !noalias !131
  %.161.i706.i = getelementptr double, ptr %82, i64 %.1861.02941.i
  store double 0.000000e+00, ptr %.161.i706.i, align 8, !noalias !131
  %.214.i750.i = getelementptr double, ptr %83, i64 %.1861.02941.i
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
  %.452.i.i10674 = icmp slt i64 %.426.i.i, 0
  %.453.i904.i = select i1 %.452.i.i10674, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i10675 = add i64 %.453.i904.i, %.426.i.i
  %.474.i.i10676 = mul i64 %.454.i.i10675, %arg.batch.3.3.5.1
  %226 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i10676
  %.478.i916.i = getelementptr i8, ptr %226, i64 24
  %.479.i.i10677 = load i64, ptr %.478.i916.i, align 8, !noalias !131
  %.480.i917.i = add nsw i64 %.479.i.i10677, 1
  store i64 %.480.i917.i, ptr %.478.i916.i, align 8, !noalias !131
  br label %B1558.i

B1557.i:                                          ; preds = %B364.endif.i, %B220.if.i, %B262.i
  %halvings.3.1.i = phi i64 [ %.mux.i, %B262.i ], [ %halvings.2.02924.i, %B364.endif.i ], [ %halvings.2.02924.i, %B220.if.i ]
  %exitcond2954.not.i = icmp eq i64 %arg.shape.0, %.446.i
  br i1 %exitcond2954.not.i, label %B478.preheader.i, label %B220.if.i

B1558.i:                                          ; preds = %B1058.if.i, %B1458.i, %B1422.i, %B1150.i
  %exitcond2960.not.i = icmp eq i64 %arg.shape.0, %.1930.i
  br i1 %exitcond2960.not.i, label %B3382, label %B1058.if.i

B1559.i:                                          ; preds = %B770.if.i, %B998.i, %B972.i, %B812.i
  %exitcond2959.not.i = icmp eq i64 %arg.shape.0, %.1395.i
  br i1 %exitcond2959.not.i, label %B478.loopexit.i, label %B770.if.i

B220.if.i:                                        ; preds = %B220.preheader.i, %B1557.i
  %halvings.2.02924.i = phi i64 [ %halvings.3.1.i, %B1557.i ], [ 0, %B220.preheader.i ]
  %.377.02922.i = phi i64 [ %.446.i, %B1557.i ], [ 0, %B220.preheader.i ]
  %.446.i = add nsw i64 %.377.02922.i, 1
  %227 = getelementptr i64, ptr %71, i64 %.377.02922.i
  %.528.i = load i64, ptr %227, align 8, !noalias !92
  %.529.i = icmp sgt i64 %.528.i, -1
  br i1 %.529.i, label %B262.i, label %B1557.i

B364.endif.i:                                     ; preds = %B34.i.i10684, %B80.i.i10686
  %.658.0.i = phi double [ %222, %B80.i.i10686 ], [ 0.000000e+00, %B34.i.i10684 ]
  %228 = getelementptr double, ptr %72, i64 %.377.02922.i
  store double %.658.0.i, ptr %228, align 8, !noalias !92
  br label %B1557.i

B480.if.i:                                        ; preds = %B478.preheader.i, %B478.loopexit.i
  %.795.02939.i = phi i64 [ %.858.i, %B478.loopexit.i ], [ %halvings.2.0.lcssa.i, %B478.preheader.i ]
  %.858.i = add nsw i64 %.795.02939.i, -1
  br i1 %.794, label %B478.loopexit.i.critedge, label %B514.if.i

B514.if.i:                                        ; preds = %B480.if.i, %B514.loopexit.i
  %.911.02932.i = phi i64 [ %.980.i, %B514.loopexit.i ], [ 0, %B480.if.i ]
  %.980.i = add nsw i64 %.911.02932.i, 1
  %.1057.i = getelementptr double, ptr %73, i64 %.911.02932.i
  %.1058.i = load double, ptr %.1057.i, align 8, !noalias !92
  %.1111.i = getelementptr double, ptr %74, i64 %.911.02932.i
  %.1112.i = load double, ptr %.1111.i, align 8, !noalias !92
  %.1113.i = fadd double %.1058.i, %.1112.i
  %.1114.i = fmul double %.1113.i, 5.000000e-01
  %.92.i292.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.911.02932.i
  %.93.i293.i = load double, ptr %.92.i292.i, align 8, !noalias !126
  %.146.i.i = getelementptr double, ptr %69, i64 %.911.02932.i
  %.147.i325.i = load double, ptr %.146.i.i, align 8, !noalias !126
  %.149.i327.i = fmul double %.1114.i, %.147.i325.i
  %.150.i328.i = fadd double %.93.i293.i, %.149.i327.i
  %.203.i367.i = getelementptr double, ptr %.571, i64 %.911.02932.i
  store double %.150.i328.i, ptr %.203.i367.i, align 8, !noalias !126
  br i1 %.287.i.i2900.not.i, label %B514.loopexit.i, label %B122.if.i.lr.ph.i

B122.if.i.lr.ph.i:                                ; preds = %B514.if.i
  %.247.i.i.i10679 = fsub double 1.000000e+00, %.1114.i
  %invariant.gep11010 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep11012 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep11014 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep11016 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep11018 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep11020 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep11022 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep11024 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep11026 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  br label %B122.if.i.i10681

B770.if.i:                                        ; preds = %B628.i, %B1559.i
  %.1326.02935.i = phi i64 [ %.1395.i, %B1559.i ], [ 0, %B628.i ]
  %.1395.i = add nsw i64 %.1326.02935.i, 1
  %229 = getelementptr i64, ptr %75, i64 %.1326.02935.i
  %.1477.i = load i64, ptr %229, align 8, !noalias !92
  %.1478.i = icmp sgt i64 %.1477.i, -1
  br i1 %.1478.i, label %B812.i, label %B1559.i

B1058.if.i:                                       ; preds = %B1558.i, %B1058.if.lr.ph.i
  %.1861.02941.i = phi i64 [ 0, %B1058.if.lr.ph.i ], [ %.1930.i, %B1558.i ]
  %.1930.i = add nsw i64 %.1861.02941.i, 1
  %.2011.i = getelementptr double, ptr %76, i64 %.1861.02941.i
  %.2012.i = load double, ptr %.2011.i, align 8, !noalias !92
  %.2066.i = getelementptr double, ptr %.571, i64 %.1861.02941.i
  store double %.2012.i, ptr %.2066.i, align 8, !noalias !92
  %.2121.i = getelementptr i64, ptr %77, i64 %.1861.02941.i
  %.2122.i = load i64, ptr %.2121.i, align 8, !noalias !92
  %.2123.i = icmp sgt i64 %.2122.i, -1
  br i1 %.2123.i, label %B1150.i, label %B1558.i

B3382:                                            ; preds = %B1558.i, %B1058.preheader.i, %B3302.endif.endif, %B3298
  br i1 %.4906.not, label %B3444, label %B120.if.i

B120.loopexit.i.critedge:                         ; preds = %B120.if.i
  %.525.i.c = load i64, ptr %.524.i, align 8, !noalias !134
  %.641.i.c = inttoptr i64 %.525.i.c to ptr
  tail call void %.641.i.c(ptr %.571, ptr %.615.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !134
  br label %B120.loopexit.i

B120.loopexit.i:                                  ; preds = %B564.i, %B120.loopexit.i.critedge
  %exitcond738.not.i = icmp eq i64 %.231.0734.i, %.10619
  br i1 %exitcond738.not.i, label %B3444, label %B120.if.i

B154.loopexit.i:                                  ; preds = %B122.if.i.i10694, %B154.if.i
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
  %230 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.667.0732.i
  %.851.i = load double, ptr %230, align 8, !noalias !134
  %.853.i = fcmp olt double %.851.i, -1.000000e-09
  br i1 %.853.i, label %B426.i, label %B564.i

B426.i:                                           ; preds = %B390.i
  %231 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.667.0732.i
  %.84.i51.i = load i64, ptr %231, align 8, !noalias !137
  %.89.i.i10714 = icmp sgt i64 %.84.i51.i, -1
  br i1 %.89.i.i10714, label %B46.i.i10715, label %B426.endif.i

B46.i.i10715:                                     ; preds = %B426.i
  %.120.i73.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i51.i
  %.121.i74.i = load i64, ptr %.120.i73.i, align 8, !noalias !137
  %.122.i75.i = icmp eq i64 %.121.i74.i, 0
  br i1 %.122.i75.i, label %B80.i.i10716, label %B426.endif.i

B80.i.i10716:                                     ; preds = %B46.i.i10715
  store i64 4, ptr %.120.i73.i, align 8, !noalias !137
  br label %B426.endif.i

B564.i:                                           ; preds = %B426.endif.i, %B348.if.i, %B390.i
  %exitcond737.not.i = icmp eq i64 %arg.shape.0, %.736.i10711
  br i1 %exitcond737.not.i, label %B120.loopexit.i, label %B348.if.i

B120.if.i:                                        ; preds = %B3382, %B120.loopexit.i
  %.231.0734.i = phi i64 [ %.302.i, %B120.loopexit.i ], [ 1, %B3382 ]
  %.302.i = add nsw i64 %.231.0734.i, 1
  br i1 %.794, label %B120.loopexit.i.critedge, label %B154.if.lr.ph.i

B154.if.lr.ph.i:                                  ; preds = %B120.if.i
  %.451.i = uitofp i64 %.231.0734.i to double
  %.456.i = fdiv double %.451.i, %.452.i
  %.247.i.i.i10690 = fsub double 1.000000e+00, %.456.i
  br label %B154.if.i

B154.if.i:                                        ; preds = %B154.if.lr.ph.i, %B154.loopexit.i
  %.354.0729.i = phi i64 [ 0, %B154.if.lr.ph.i ], [ %.423.i, %B154.loopexit.i ]
  %.423.i = add nsw i64 %.354.0729.i, 1
  %.92.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.354.0729.i
  %.93.i.i = load double, ptr %.92.i.i, align 8, !noalias !140
  %.146.i.i10691 = getelementptr double, ptr %84, i64 %.354.0729.i
  %.147.i.i = load double, ptr %.146.i.i10691, align 8, !noalias !140
  %.149.i.i10692 = fmul double %.456.i, %.147.i.i
  %.150.i.i = fadd double %.93.i.i, %.149.i.i10692
  %.203.i.i = getelementptr double, ptr %.571, i64 %.354.0729.i
  store double %.150.i.i, ptr %.203.i.i, align 8, !noalias !140
  br i1 %.287.i725.not.i, label %B154.loopexit.i, label %B122.if.i.preheader.i

B122.if.i.preheader.i:                            ; preds = %B154.if.i
  %invariant.gep11028 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep11030 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep11032 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep11034 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep11036 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep11038 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep11040 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep11042 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep11044 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  br label %B122.if.i.i10694

B122.if.i.i10694:                                 ; preds = %B122.if.i.i10694, %B122.if.i.preheader.i
  %.229.i.0726.i = phi i64 [ %.300.i.i, %B122.if.i.i10694 ], [ 0, %B122.if.i.preheader.i ]
  %.157.i.i.i10695 = add nsw i64 %.229.i.0726.i, %.155.i.i.i10693
  %.159.i.i.i10696 = mul nsw i64 %.157.i.i.i10695, %arg.shape.0
  %gep11029 = getelementptr double, ptr %invariant.gep11028, i64 %.159.i.i.i10696
  %.191.i.i.i10697 = load double, ptr %gep11029, align 8, !noalias !144
  %.193.i.i.i10698 = fadd double %.191.i.i.i10697, 0.000000e+00
  %.253.i.i.i10699 = fmul double %.456.i, %.193.i.i.i10698
  %.157.i.i.1.i = add nsw i64 %.229.i.0726.i, %.155.i.i.1.i10700
  %.159.i.i.1.i = mul nsw i64 %.157.i.i.1.i, %arg.shape.0
  %gep11031 = getelementptr double, ptr %invariant.gep11030, i64 %.159.i.i.1.i
  %.191.i.i.1.i = load double, ptr %gep11031, align 8, !noalias !144
  %.193.i.i.1.i = fadd double %.191.i.i.1.i, %.253.i.i.i10699
  %.253.i.i.1.i = fmul double %.247.i.i.i10690, %.193.i.i.1.i
  %.157.i.i.2.i = add nsw i64 %.229.i.0726.i, %.155.i.i.2.i10701
  %.159.i.i.2.i = mul nsw i64 %.157.i.i.2.i, %arg.shape.0
  %gep11033 = getelementptr double, ptr %invariant.gep11032, i64 %.159.i.i.2.i
  %.191.i.i.2.i = load double, ptr %gep11033, align 8, !noalias !144
  %.193.i.i.2.i = fadd double %.191.i.i.2.i, %.253.i.i.1.i
  %.253.i.i.2.i = fmul double %.456.i, %.193.i.i.2.i
  %.157.i.i.3.i = add nsw i64 %.229.i.0726.i, %.155.i.i.3.i10702
  %.159.i.i.3.i = mul nsw i64 %.157.i.i.3.i, %arg.shape.0
  %gep11035 = getelementptr double, ptr %invariant.gep11034, i64 %.159.i.i.3.i
  %.191.i.i.3.i = load double, ptr %gep11035, align 8, !noalias !144
  %.193.i.i.3.i = fadd double %.191.i.i.3.i, %.253.i.i.2.i
  %.253.i.i.3.i = fmul double %.247.i.i.i10690, %.193.i.i.3.i
  %.157.i.i.4.i = add nsw i64 %.229.i.0726.i, %.155.i.i.4.i10703
  %.159.i.i.4.i = mul nsw i64 %.157.i.i.4.i, %arg.shape.0
  %gep11037 = getelementptr double, ptr %invariant.gep11036, i64 %.159.i.i.4.i
  %.191.i.i.4.i = load double, ptr %gep11037, align 8, !noalias !144
  %.193.i.i.4.i = fadd double %.191.i.i.4.i, %.253.i.i.3.i
  %.253.i.i.4.i = fmul double %.456.i, %.193.i.i.4.i
  %.157.i.i.5.i = add nsw i64 %.229.i.0726.i, %.155.i.i.5.i10704
  %.159.i.i.5.i = mul nsw i64 %.157.i.i.5.i, %arg.shape.0
  %gep11039 = getelementptr double, ptr %invariant.gep11038, i64 %.159.i.i.5.i
  %.191.i.i.5.i = load double, ptr %gep11039, align 8, !noalias !144
  %.193.i.i.5.i = fadd double %.191.i.i.5.i, %.253.i.i.4.i
  %.253.i.i.5.i = fmul double %.247.i.i.i10690, %.193.i.i.5.i
  %.157.i.i.6.i = add nsw i64 %.229.i.0726.i, %.155.i.i.6.i10705
  %.159.i.i.6.i = mul nsw i64 %.157.i.i.6.i, %arg.shape.0
  %gep11041 = getelementptr double, ptr %invariant.gep11040, i64 %.159.i.i.6.i
  %.191.i.i.6.i = load double, ptr %gep11041, align 8, !noalias !144
  %.193.i.i.6.i = fadd double %.191.i.i.6.i, %.253.i.i.5.i
  %.253.i.i.6.i = fmul double %.456.i, %.193.i.i.6.i
  %.300.i.i = add nsw i64 %.229.i.0726.i, 1
  %.271.i.i.i10706 = mul nsw i64 %.229.i.0726.i, %arg.shape.0
  %gep11043 = getelementptr double, ptr %invariant.gep11042, i64 %.271.i.i.i10706
  %.309.i.i.i10707 = load double, ptr %gep11043, align 8, !noalias !144
  %.313.i.i.i10708 = fadd double %.309.i.i.i10707, %.253.i.i.6.i
  %.359.i.i10709 = add nsw i64 %.229.i.0726.i, %.358.i.i10688
  %.361.i.i = mul nsw i64 %.359.i.i10709, %arg.shape.0
  %gep11045 = getelementptr double, ptr %invariant.gep11044, i64 %.361.i.i
  store double %.313.i.i.i10708, ptr %gep11045, align 8, !noalias !140
  %exitcond.not.i10710 = icmp eq i64 %arg.shape.1, %.300.i.i
  br i1 %exitcond.not.i10710, label %B154.loopexit.i, label %B122.if.i.i10694

B348.if.i:                                        ; preds = %B564.i, %B206.i
  %.667.0732.i = phi i64 [ 0, %B206.i ], [ %.736.i10711, %B564.i ]
  %.736.i10711 = add nsw i64 %.667.0732.i, 1
  %.817.i = getelementptr double, ptr %85, i64 %.667.0732.i
  %.818.i10712 = load double, ptr %.817.i, align 8, !noalias !134
  %.819.i = fcmp ogt double %.818.i10712, 5.000000e-01
  br i1 %.819.i, label %B390.i, label %B564.i

B426.endif.i:                                     ; preds = %B80.i.i10716, %B46.i.i10715, %B426.i
  store double 0.000000e+00, ptr %.817.i, align 8, !noalias !134
  %.1014.i = getelementptr double, ptr %86, i64 %.667.0732.i
  store double %.952.i, ptr %.1014.i, align 8, !noalias !134
  %.1071.i = getelementptr double, ptr %87, i64 %.667.0732.i
  store double %.960.i, ptr %.1071.i, align 8, !noalias !134
  br label %B564.i

B3444:                                            ; preds = %B120.loopexit.i, %B2872, %B3382
  %brmerge10621.not = and i1 %good.2.1.lcssa, %looked.2.1.lcssa
  br i1 %brmerge10621.not, label %B3452, label %B3504

B3452:                                            ; preds = %B3444
  %brmerge10622.not = select i1 %within.5.1, i1 %.614, i1 false
  %"$phi3488.7.2.2" = select i1 %brmerge10622.not, i64 3, i64 0
  br i1 %.794, label %B3504, label %B96.if.i

B172.i:                                           ; preds = %B96.if.i
  %.452.i10721 = getelementptr double, ptr %89, i64 %.180.0654.i
  %.453.i10722 = load double, ptr %.452.i10721, align 8, !noalias !148
  %.454.i10723 = fcmp olt double %.453.i10722, 5.000000e-01
  br i1 %.454.i10723, label %B789.i, label %B210.i

B210.i:                                           ; preds = %B172.i
  %.485.i10724 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.334.i
  %.486.i = load i64, ptr %.485.i10724, align 8, !noalias !148
  %.487.not.i = icmp eq i64 %.486.i, 0
  br i1 %.487.not.i, label %B246.i, label %B789.i

B246.i:                                           ; preds = %B210.i
  %.549.i = mul i64 %.334.i, %arg.batch.3.3.5.1
  %232 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.549.i
  %.553.i = getelementptr i8, ptr %232, i64 8
  %.554.i = load i64, ptr %.553.i, align 8, !noalias !148
  %.556.i = add nsw i64 %.554.i, %"$phi3488.7.2.2"
  store i64 %.556.i, ptr %.553.i, align 8, !noalias !148
  %.662.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.180.0654.i
  %.663.i = load double, ptr %.662.i, align 8, !noalias !148
  %.717.i = getelementptr double, ptr %90, i64 %.180.0654.i
  %.718.i = load double, ptr %.717.i, align 8, !noalias !148
  %.772.i = getelementptr double, ptr %91, i64 %.180.0654.i
  %.773.i = load double, ptr %.772.i, align 8, !noalias !148
  %.794.i = icmp slt i64 %.389.i, %arg.batch.2.5.0
  br i1 %.794.i, label %B420.i, label %B760.i

B420.i:                                           ; preds = %B246.i
  %.817.i10725 = icmp slt i64 %.389.i, 0
  %.818.i10726 = select i1 %.817.i10725, i64 %arg.batch.2.5.0, i64 0
  %233 = getelementptr double, ptr %arg.batch.2.4, i64 %.389.i
  %.832.i10727 = getelementptr double, ptr %233, i64 %.818.i10726
  %.833.i10728 = load double, ptr %.832.i10727, align 8, !noalias !148
  %.837.i = fcmp ugt double %.833.i10728, %.773.i
  br i1 %.837.i, label %B760.i, label %B444.preheader.i

B444.preheader.i:                                 ; preds = %B420.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul652.i, %.334.i
  %.1324.i = getelementptr double, ptr %92, i64 %.180.0654.i
  %234 = getelementptr double, ptr %arg.batch.3.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep11046 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep11048 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep11050 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep11052 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep11054 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep11056 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep11058 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep11060 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep11062 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  br label %B444.i

B444.i:                                           ; preds = %B736.i, %B444.preheader.i
  %done.2.3.i = phi i64 [ %.1262.i, %B736.i ], [ %.389.i, %B444.preheader.i ]
  br i1 %.924649.not.i, label %B644.i, label %B474.if.lr.ph.i

B474.if.lr.ph.i:                                  ; preds = %B444.i
  %.979.i = icmp slt i64 %done.2.3.i, 0
  %.980.i10729 = select i1 %.979.i, i64 %arg.batch.2.5.0, i64 0
  %235 = getelementptr double, ptr %arg.batch.2.4, i64 %done.2.3.i
  %.994.i = getelementptr double, ptr %235, i64 %.980.i10729
  %.1220.i = select i1 %.979.i, i64 %arg.batch.3.0.5.1, i64 0
  %.1221.i = add i64 %.1220.i, %done.2.3.i
  %.1250.i = mul i64 %.1221.i, %arg.batch.3.0.5.2
  %236 = getelementptr double, ptr %234, i64 %.1250.i
  br label %B474.if.i

B502.i:                                           ; preds = %B474.if.i
  %.1002.i10733 = add nsw i64 %.868.0650.i, %.1000.i10719
  %.1004.i = mul nsw i64 %.1002.i10733, %arg.shape.0
  %gep11063 = getelementptr double, ptr %invariant.gep11062, i64 %.1004.i
  %.1036.i = load double, ptr %gep11063, align 8, !noalias !148
  br label %B790.i

B644.i:                                           ; preds = %B790.i, %B444.i
  store double 0x7FF0000000000000, ptr %.1324.i, align 8, !noalias !148
  %exitcond656.not.i = icmp eq i64 %done.2.3.i, %93
  br i1 %exitcond656.not.i, label %B760.i, label %B736.i

B736.i:                                           ; preds = %B644.i
  %.1262.i = add i64 %done.2.3.i, 1
  %.1359.i = icmp slt i64 %done.2.3.i, -1
  %.1360.i = select i1 %.1359.i, i64 %arg.batch.2.5.0, i64 0
  %237 = getelementptr double, ptr %arg.batch.2.4, i64 %.1262.i
  %.1374.i = getelementptr double, ptr %237, i64 %.1360.i
  %.1375.i = load double, ptr %.1374.i, align 8, !noalias !148
  %.1379.i = fcmp ugt double %.1375.i, %.773.i
  br i1 %.1379.i, label %B760.i, label %B444.i

B760.i:                                           ; preds = %B736.i, %B644.i, %B420.i, %B246.i
  %done.3.2.i = phi i64 [ %.389.i, %B420.i ], [ %.389.i, %B246.i ], [ %arg.batch.2.5.0, %B644.i ], [ %.1262.i, %B736.i ]
  store i64 %done.3.2.i, ptr %.388.i, align 8, !noalias !148
  br label %B789.i

B789.i:                                           ; preds = %B96.if.i, %B760.i, %B210.i, %B172.i
  %exitcond657.not.i = icmp eq i64 %.252.i10720, %arg.shape.0
  br i1 %exitcond657.not.i, label %B3504, label %B96.if.i

B790.i:                                           ; preds = %B38.if.i.i, %B502.i
  %.313.i.i.sink = phi double [ %.313.i.i, %B38.if.i.i ], [ %.1036.i, %B502.i ]
  %238 = getelementptr double, ptr %236, i64 %.868.0650.i
  store double %.313.i.i.sink, ptr %238, align 8, !noalias !148
  %exitcond.not.i10732 = icmp eq i64 %arg.shape.1, %.937.i
  br i1 %exitcond.not.i10732, label %B644.i, label %B474.if.i

B96.if.i:                                         ; preds = %B3452, %B789.i
  %.180.0654.i = phi i64 [ %.252.i10720, %B789.i ], [ 0, %B3452 ]
  %.252.i10720 = add nsw i64 %.180.0654.i, 1
  %.333.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.180.0654.i
  %.334.i = load i64, ptr %.333.i, align 8, !noalias !148
  %.388.i = getelementptr i64, ptr %88, i64 %.180.0654.i
  %.389.i = load i64, ptr %.388.i, align 8, !noalias !148
  %.397.i = icmp slt i64 %.334.i, 0
  br i1 %.397.i, label %B789.i, label %B172.i

B474.if.i:                                        ; preds = %B790.i, %B474.if.lr.ph.i
  %.868.0650.i = phi i64 [ 0, %B474.if.lr.ph.i ], [ %.937.i, %B790.i ]
  %.937.i = add nsw i64 %.868.0650.i, 1
  %.995.i = load double, ptr %.994.i, align 8, !noalias !148
  %.997.i = fcmp oeq double %.995.i, %.773.i
  br i1 %.997.i, label %B502.i, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B474.if.i
  %.1145.i = fsub double %.995.i, %.663.i
  %.1150.i = fdiv double %.1145.i, %.718.i
  %.247.i.i = fsub double 1.000000e+00, %.1150.i
  %.157.i.i = add nsw i64 %.868.0650.i, %.155.i.i
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep11047 = getelementptr double, ptr %invariant.gep11046, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep11047, align 8, !noalias !151
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i10730 = fmul double %.1150.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.868.0650.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep11049 = getelementptr double, ptr %invariant.gep11048, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep11049, align 8, !noalias !151
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i10730
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.868.0650.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep11051 = getelementptr double, ptr %invariant.gep11050, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep11051, align 8, !noalias !151
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %.1150.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.868.0650.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep11053 = getelementptr double, ptr %invariant.gep11052, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep11053, align 8, !noalias !151
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.868.0650.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep11055 = getelementptr double, ptr %invariant.gep11054, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep11055, align 8, !noalias !151
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %.1150.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.868.0650.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep11057 = getelementptr double, ptr %invariant.gep11056, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep11057, align 8, !noalias !151
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.868.0650.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep11059 = getelementptr double, ptr %invariant.gep11058, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep11059, align 8, !noalias !151
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %.1150.i, %.193.i.6.i
  %.271.i.i10731 = mul nsw i64 %.868.0650.i, %arg.shape.0
  %gep11061 = getelementptr double, ptr %invariant.gep11060, i64 %.271.i.i10731
  %.309.i.i = load double, ptr %gep11061, align 8, !noalias !151
  %.313.i.i = fadd double %.309.i.i, %.253.i.6.i
  br label %B790.i

B3504:                                            ; preds = %B789.i, %B3452, %B3444
  br i1 %.5142, label %B3554, label %B3516

B3516:                                            ; preds = %B3504
  %.5197 = load double, ptr %.5196, align 8
  %.5198 = fcmp ogt double %.5197, 5.000000e-01
  br i1 %.5198, label %B3554, label %B3622

B3554:                                            ; preds = %B3516, %B3504
  %.5229 = load i64, ptr %.5228, align 8
  %.5274 = inttoptr i64 %.5229 to ptr
  tail call void %.5274(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3622

B3622:                                            ; preds = %B3554, %B3516
  %brmerge10614.not.not = xor i1 %brmerge10614.not, true
  %brmerge11093 = or i1 %.794, %brmerge10614.not.not
  br i1 %brmerge11093, label %B3678, label %B80.if.i7178

B134.i:                                           ; preds = %B80.if.i7178
  %.351.i6424 = getelementptr double, ptr %95, i64 %.141.i6180.011071
  %.352.i6425 = load double, ptr %.351.i6424, align 8, !noalias !155
  %.353.i6426 = fcmp ogt double %.352.i6425, 5.000000e-01
  br i1 %.353.i6426, label %B174.i, label %B740.i

B174.i:                                           ; preds = %B134.i
  %.408.i6474 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.141.i6180.011071
  %.409.i6475 = load double, ptr %.408.i6474, align 8, !noalias !155
  %.463.i6523 = getelementptr double, ptr %96, i64 %.141.i6180.011071
  %.464.i6524 = load double, ptr %.463.i6523, align 8, !noalias !155
  %.465.i6525 = fsub double %.409.i6475, %.464.i6524
  br i1 %.552.i656311064.not, label %B380.i, label %B270.if.i.preheader

B270.if.i.preheader:                              ; preds = %B174.i
  %invariant.gep11173 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.141.i6180.011071
  br label %B270.if.i

B380.i:                                           ; preds = %B270.if.i, %B174.i
  %fastest.2.i.2.lcssa = phi double [ 0.000000e+00, %B174.i ], [ %.11.i.i, %B270.if.i ]
  %.666.i6575 = fmul double %.465.i6525, %fastest.2.i.2.lcssa
  %.698.i6601 = load double, ptr %.697.i6600, align 8, !noalias !155
  %.699.i6602 = fcmp ogt double %.666.i6575, %.698.i6601
  %.10626 = select i1 %.699.i6602, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  %.743.i6631 = load double, ptr %.742.i6630, align 8, !noalias !155
  %.773.i6656 = load double, ptr %arg.batch.2.4, align 8, !noalias !155
  %.774.i6657 = fsub double %.743.i6631, %.773.i6656
  %.776.i6659 = fmul double %.10626, %.774.i6657
  %.780.i6662 = fcmp olt double %.465.i6525, %.776.i6659
  br i1 %.780.i6662, label %B490.i, label %B528.i

B490.i:                                           ; preds = %B380.i
  %239 = getelementptr i64, ptr %98, i64 %.141.i6180.011071
  %.838.i7114 = load i64, ptr %239, align 8, !noalias !155
  %.839.i7115 = add nsw i64 %.838.i7114, 1
  br label %B528.i

B528.i:                                           ; preds = %B380.i, %B490.i
  %"$phi528.1.2.i.2" = phi i64 [ %.839.i7115, %B490.i ], [ 0, %B380.i ]
  %240 = getelementptr i64, ptr %99, i64 %.141.i6180.011071
  store i64 %"$phi528.1.2.i.2", ptr %240, align 8, !noalias !155
  %.959.i6760 = load double, ptr %.408.i6474, align 8, !noalias !155
  store double %.959.i6760, ptr %.463.i6523, align 8, !noalias !155
  %.1068.i6853 = getelementptr double, ptr %100, i64 %.141.i6180.011071
  store double 1.000000e+00, ptr %.1068.i6853, align 8, !noalias !155
  store i64 1, ptr %.1166, align 8, !noalias !155
  %.1154.i6923 = load i64, ptr %240, align 8, !noalias !155
  %.1155.i6924 = icmp sgt i64 %.1154.i6923, 1000
  br i1 %.1155.i6924, label %B694.i, label %B740.i

B694.i:                                           ; preds = %B528.i
  %241 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.141.i6180.011071
  %.84.i.i7004 = load i64, ptr %241, align 8, !noalias !159
  %.89.i.i7007 = icmp sgt i64 %.84.i.i7004, -1
  br i1 %.89.i.i7007, label %B46.i.i7015, label %B740.i

B46.i.i7015:                                      ; preds = %B694.i
  %.120.i.i7035 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i7004
  %.121.i.i7036 = load i64, ptr %.120.i.i7035, align 8, !noalias !159
  %.122.i.i7037 = icmp eq i64 %.121.i.i7036, 0
  br i1 %.122.i.i7037, label %B80.i.i7042, label %B740.i

B80.i.i7042:                                      ; preds = %B46.i.i7015
  store i64 6, ptr %.120.i.i7035, align 8, !noalias !159
  br label %B740.i

B740.i:                                           ; preds = %B80.i.i7042, %B694.i, %B46.i.i7015, %B528.i, %B134.i, %B80.if.i7178
  store double 0.000000e+00, ptr %.294.i6335, align 8, !noalias !155
  %.200.i6266 = icmp sgt i64 %.144.i6181.011070, 1
  br i1 %.200.i6266, label %B80.if.i7178, label %B3678

B80.if.i7178:                                     ; preds = %B3622, %B740.i
  %.141.i6180.011071 = phi i64 [ %.213.i7186, %B740.i ], [ 0, %B3622 ]
  %.144.i6181.011070 = phi i64 [ %.209.i7183, %B740.i ], [ %storemerge, %B3622 ]
  %.209.i7183 = add nsw i64 %.144.i6181.011070, -1
  %.213.i7186 = add nsw i64 %.141.i6180.011071, 1
  %.294.i6335 = getelementptr double, ptr %94, i64 %.141.i6180.011071
  %.295.i6336 = load double, ptr %.294.i6335, align 8, !noalias !155
  %.296.i6337 = fcmp oeq double %.295.i6336, 1.000000e+00
  br i1 %.296.i6337, label %B134.i, label %B740.i

B270.if.i:                                        ; preds = %B270.if.i.preheader, %B270.if.i
  %fastest.2.i.211067 = phi double [ %.11.i.i, %B270.if.i ], [ 0.000000e+00, %B270.if.i.preheader ]
  %.496.i6197.011066 = phi i64 [ %.565.i7170, %B270.if.i ], [ 0, %B270.if.i.preheader ]
  %.565.i7170 = add nsw i64 %.496.i6197.011066, 1
  %.592.i7122 = add nsw i64 %.496.i6197.011066, %arg.shape.1
  %.594.i7124 = mul nsw i64 %.592.i7122, %arg.shape.0
  %gep11174 = getelementptr double, ptr %invariant.gep11173, i64 %.594.i7124
  %.626.i7152 = load double, ptr %gep11174, align 8, !noalias !155
  %.627.i7153 = tail call double @llvm.fabs.f64(double %.626.i7152)
  %.10.i.i = fcmp ogt double %.627.i7153, %fastest.2.i.211067
  %.11.i.i = select i1 %.10.i.i, double %.627.i7153, double %fastest.2.i.211067
  %exitcond11121.not = icmp eq i64 %arg.shape.1, %.565.i7170
  br i1 %exitcond11121.not, label %B380.i, label %B270.if.i

B3678:                                            ; preds = %B740.i, %B3622
  %brmerge10628.not = and i1 %.5344.not, %looked.2.1.lcssa
  %brmerge10628.not.not = xor i1 %brmerge10628.not, true
  %brmerge11092 = or i1 %.794, %brmerge10628.not.not
  br i1 %brmerge11092, label %B3728, label %B114.if.i

B46.i.i10734:                                     ; preds = %B114.if.i
  %.135.i.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !162
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i10740, label %B228.i

B80.i.i10740:                                     ; preds = %B46.i.i10734
  %.196.i.i = getelementptr double, ptr %101, i64 %.302.01639.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !162
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B228.i, label %B122.i.i10741

B122.i.i10741:                                    ; preds = %B80.i.i10740
  %.264.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.302.01639.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !162
  %.321.i.i = getelementptr double, ptr %102, i64 %.302.01639.i
  %.322.i.i = load double, ptr %.321.i.i, align 8, !noalias !162
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.175.i3061635.not.i
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01641.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01641.i
  br i1 %brmerge.i, label %B228.i, label %B76.if.i.lr.ph.i10742

B76.if.i.lr.ph.i10742:                            ; preds = %B122.i.i10741
  %242 = getelementptr i64, ptr %103, i64 %.302.01639.i
  %.513.i = load i64, ptr %242, align 8, !noalias !167
  %.514.i = add nsw i64 %.513.i, 1
  %.236.i323.i = icmp slt i64 %.513.i, -1
  %.237.i324.i = select i1 %.236.i323.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i325.i = add i64 %.514.i, %.237.i324.i
  %.258.i342.i = mul i64 %.238.i325.i, %arg.batch.1.3.5.1
  %243 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i342.i
  br label %B76.if.i.i10743

B76.if.i.i10743:                                  ; preds = %B76.if.i.i10743, %B76.if.i.lr.ph.i10742
  %.117.i268.01636.i = phi i64 [ 0, %B76.if.i.lr.ph.i10742 ], [ %.188.i390.i, %B76.if.i.i10743 ]
  %.188.i390.i = add nsw i64 %.117.i268.01636.i, 1
  %244 = getelementptr double, ptr %243, i64 %.117.i268.01636.i
  %.263.i344.i = load double, ptr %244, align 8, !noalias !168
  %245 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i268.01636.i
  %.293.i360.i = load i64, ptr %245, align 8, !noalias !168
  %.295.i362.i = mul nsw i64 %.293.i360.i, %arg.shape.0
  %.297.i364.i = add nsw i64 %.295.i362.i, %.302.01639.i
  %.311.i372.i = icmp slt i64 %.297.i364.i, 0
  %.312.i373.i = select i1 %.311.i372.i, i64 %arg.batch.5.1.5.0, i64 0
  %246 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i364.i
  %.326.i383.i = getelementptr double, ptr %246, i64 %.312.i373.i
  store double %.263.i344.i, ptr %.326.i383.i, align 8, !noalias !168
  %exitcond.not.i10744 = icmp eq i64 %arg.batch.1.1.5.0, %.188.i390.i
  br i1 %exitcond.not.i10744, label %B228.i, label %B76.if.i.i10743

B228.i:                                           ; preds = %B76.if.i.i10743, %B114.if.i, %B122.i.i10741, %B80.i.i10740, %B46.i.i10734
  %some.3.1.i = phi i1 [ %some.2.01641.mux.i, %B122.i.i10741 ], [ %some.2.01641.i, %B80.i.i10740 ], [ %some.2.01641.i, %B114.if.i ], [ %some.2.01641.i, %B46.i.i10734 ], [ true, %B76.if.i.i10743 ]
  %exitcond1650.not.i = icmp eq i64 %arg.shape.0, %.373.i
  br i1 %exitcond1650.not.i, label %B230.i, label %B114.if.i

B230.i:                                           ; preds = %B228.i
  br i1 %some.3.1.i, label %B238.i, label %B3728

B238.i:                                           ; preds = %B230.i
  %.637.i = load i64, ptr %.636.i, align 8, !noalias !167
  %.749.i = inttoptr i64 %.637.i to ptr
  tail call void %.749.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !167
  %.780.i = load i64, ptr %.779.i, align 8, !noalias !167
  %.896.i = inttoptr i64 %.780.i to ptr
  tail call void %.896.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.895.i10735), !noalias !167
  br i1 %.900.not.i, label %B598.if.i.preheader, label %B456.i

B456.i:                                           ; preds = %B238.i
  %.931.i = load i64, ptr %.930.i10736, align 8, !noalias !167
  %.1049.i = inttoptr i64 %.931.i to ptr
  tail call void %.1049.i(ptr %arg.batch.4.0.4, ptr %.895.i10735, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !167
  br label %B598.if.i.preheader

B598.if.i.preheader:                              ; preds = %B456.i, %B238.i
  br label %B598.if.i

B46.i82.i:                                        ; preds = %B598.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !172
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B1076.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %101, i64 %.1090.01648.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !172
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B1076.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.1090.01648.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !172
  %.321.i223.i = getelementptr double, ptr %102, i64 %.1090.01648.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !172
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B1076.i, label %B638.i

B638.i:                                           ; preds = %B122.i147.i
  %.1344.i = getelementptr i64, ptr %104, i64 %.1090.01648.i
  %.1345.i = load i64, ptr %.1344.i, align 8, !noalias !167
  %.1356.i = icmp sgt i64 %.1345.i, 0
  br i1 %.1356.i, label %B714.i, label %B768.i

B714.i:                                           ; preds = %B638.i
  %247 = getelementptr double, ptr %arg.batch.2.4, i64 %.1345.i
  %.1391.i = getelementptr i8, ptr %247, i64 -8
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
  %248 = getelementptr double, ptr %arg.batch.3.0.4, i64 %.1741.i
  %249 = getelementptr double, ptr %248, i64 %.1743.i
  %invariant.gep11072 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  %invariant.gep11074 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  br label %B800.if.i

B896.i:                                           ; preds = %B800.if.i
  %250 = getelementptr double, ptr %249, i64 %.1488.01643.i
  store double %.1622.i, ptr %250, align 8, !noalias !167
  br label %B918.i

B918.i:                                           ; preds = %B800.if.i, %B896.i
  %exitcond1651.not.i = icmp eq i64 %arg.shape.1, %.1557.i
  br i1 %exitcond1651.not.i, label %B920.loopexit.i, label %B800.if.i

B920.loopexit.i:                                  ; preds = %B918.i
  %251 = fcmp une double %.1629.i, 0.000000e+00
  br i1 %251, label %B932.i, label %B978.i

B932.i:                                           ; preds = %B920.loopexit.i
  %.84.i452.i = load i64, ptr %254, align 8, !noalias !175
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
  %252 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.1090.01648.i
  %.1846.i = load double, ptr %252, align 8, !noalias !167
  %.1848.i = fcmp olt double %.1846.i, -1.000000e-09
  br i1 %.1848.i, label %B1030.i, label %B1076.i

B1030.i:                                          ; preds = %B994.i
  %.84.i583.i = load i64, ptr %254, align 8, !noalias !178
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
  %.1146.i10738 = icmp sgt i64 %.1093.01649.i, 1
  br i1 %.1146.i10738, label %B598.if.i, label %B3728

B114.if.i:                                        ; preds = %B3678, %B228.i
  %some.2.01641.i = phi i1 [ %some.3.1.i, %B228.i ], [ false, %B3678 ]
  %.302.01639.i = phi i64 [ %.373.i, %B228.i ], [ 0, %B3678 ]
  %.373.i = add nsw i64 %.302.01639.i, 1
  %253 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.302.01639.i
  %.99.i.i = load i64, ptr %253, align 8, !noalias !162
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B228.i, label %B46.i.i10734

B598.if.i:                                        ; preds = %B598.if.i.preheader, %B1076.i
  %.1093.01649.i = phi i64 [ %.1155.i, %B1076.i ], [ %storemerge.i, %B598.if.i.preheader ]
  %.1090.01648.i = phi i64 [ %.1159.i, %B1076.i ], [ 0, %B598.if.i.preheader ]
  %.1155.i = add nsw i64 %.1093.01649.i, -1
  %.1159.i = add nsw i64 %.1090.01648.i, 1
  %254 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.1090.01648.i
  %.99.i78.i = load i64, ptr %254, align 8, !noalias !172
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B1076.i, label %B46.i82.i

B800.if.i:                                        ; preds = %B918.i, %B800.if.lr.ph.i
  %trouble.2.11645.i = phi double [ 0.000000e+00, %B800.if.lr.ph.i ], [ %.1629.i, %B918.i ]
  %.1488.01643.i = phi i64 [ 0, %B800.if.lr.ph.i ], [ %.1557.i, %B918.i ]
  %.1557.i = add nsw i64 %.1488.01643.i, 1
  %.1588.i = add nsw i64 %.1488.01643.i, %.850.i
  %.1590.i10739 = mul nsw i64 %.1588.i, %arg.shape.0
  %gep11073 = getelementptr double, ptr %invariant.gep11072, i64 %.1590.i10739
  %.1622.i = load double, ptr %gep11073, align 8, !noalias !167
  %.1627.i = fmul double %.1622.i, 0.000000e+00
  %.1629.i = fadd double %trouble.2.11645.i, %.1627.i
  %.1637.i = mul nsw i64 %.1488.01643.i, %arg.shape.0
  %gep11075 = getelementptr double, ptr %invariant.gep11074, i64 %.1637.i
  store double %.1622.i, ptr %gep11075, align 8, !noalias !167
  br i1 %"$phi768.1.2.1.i", label %B896.i, label %B918.i

B3728:                                            ; preds = %B1076.i, %B3678, %B230.i
  %looked.2.1.lcssa.not = xor i1 %looked.2.1.lcssa, true
  %brmerge11094 = or i1 %.794, %looked.2.1.lcssa.not
  %active.9.1.mux = select i1 %looked.2.1.lcssa, i64 0, i64 %active.9.1
  br i1 %brmerge11094, label %B4704, label %B3770.if

B3818:                                            ; preds = %B3770.if
  %.5729 = mul i64 %.5656, %arg.batch.3.3.5.1
  %.5733 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.5729
  %.5734 = load i64, ptr %.5733, align 8
  %.5790 = getelementptr i8, ptr %.5733, i64 24
  %.5791 = load i64, ptr %.5790, align 8
  %255 = add i64 %.5734, %.5791
  %.5792 = sub i64 %arg.most, %255
  %.5797 = icmp slt i64 %.5792, 1
  br i1 %.5797, label %B3898, label %B3944

B3898:                                            ; preds = %B3818
  %256 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5494.011080
  %.84.i7267 = load i64, ptr %256, align 8, !noalias !181
  %.89.i7270 = icmp sgt i64 %.84.i7267, -1
  br i1 %.89.i7270, label %B46.i7275, label %B3944

B46.i7275:                                        ; preds = %B3898
  %.120.i7301 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i7267
  %.121.i7302 = load i64, ptr %.120.i7301, align 8, !noalias !181
  %.122.i7303 = icmp eq i64 %.121.i7302, 0
  br i1 %.122.i7303, label %B80.i7308, label %B3944

B80.i7308:                                        ; preds = %B46.i7275
  store i64 5, ptr %.120.i7301, align 8, !noalias !181
  br label %B3944

B3944:                                            ; preds = %B80.i7308, %B3898, %B46.i7275, %B3818
  %.5887 = getelementptr double, ptr %105, i64 %.5494.011080
  %.5888 = load double, ptr %.5887, align 8
  %.5889 = fcmp ogt double %.5888, 5.000000e-01
  br i1 %.5889, label %B3982, label %B4086

B3982:                                            ; preds = %B3944
  %.5944 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5494.011080
  %.5945 = load double, ptr %.5944, align 8
  %.5999 = getelementptr double, ptr %106, i64 %.5494.011080
  %.6000 = load double, ptr %.5999, align 8
  %.6001 = fcmp oeq double %.5945, %.6000
  br i1 %.6001, label %B4046, label %B4086

B4046:                                            ; preds = %B3982
  %.192.i7536 = load i64, ptr %.5655, align 8, !noalias !184
  %.248.i7584 = getelementptr i64, ptr %107, i64 %.5494.011080
  %.249.i7585 = load i64, ptr %.248.i7584, align 8, !noalias !184
  %.250.i7586 = add nsw i64 %.249.i7585, 1
  store i64 %.250.i7586, ptr %.248.i7584, align 8, !noalias !184
  %.373.i7691 = icmp slt i64 %.249.i7585, -1
  %.374.i7692 = select i1 %.373.i7691, i64 %arg.batch.1.2.5.0, i64 0
  %257 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.250.i7586
  %.388.i7706 = getelementptr double, ptr %257, i64 %.374.i7692
  %.389.i7707 = load double, ptr %.388.i7706, align 8, !noalias !184
  %.390.i7708 = fcmp oeq double %.389.i7707, 0x7FF0000000000000
  br i1 %.390.i7708, label %B182.i, label %B240.i

B182.i:                                           ; preds = %B4046
  %.424.i8235 = icmp slt i64 %.192.i7536, 0
  %.425.i8236 = select i1 %.424.i8235, i64 %arg.batch.3.1.5.0, i64 0
  %258 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.192.i7536
  %.439.i8250 = getelementptr i64, ptr %258, i64 %.425.i8236
  %.440.i8251 = load i64, ptr %.439.i8250, align 8, !noalias !184
  %.441.i8252 = icmp eq i64 %.440.i8251, 0
  br i1 %.441.i8252, label %B216.i8256, label %B4086

B216.i8256:                                       ; preds = %B182.i
  store i64 1, ptr %.439.i8250, align 8, !noalias !184
  br label %B4086

B240.i:                                           ; preds = %B4046
  store double %.389.i7707, ptr %.5999, align 8, !noalias !184
  %.592.i7798 = select i1 %.373.i7691, i64 %arg.batch.1.4.5.0, i64 0
  %259 = getelementptr i64, ptr %arg.batch.1.4.4, i64 %.250.i7586
  %.606.i7812 = getelementptr i64, ptr %259, i64 %.592.i7798
  %.607.i7813 = load i64, ptr %.606.i7812, align 8, !noalias !184
  %.610.i7815 = icmp eq i64 %.607.i7813, 0
  br i1 %.610.i7815, label %B300.i, label %B348.i

B300.i:                                           ; preds = %B240.i
  %.665.i8189 = getelementptr double, ptr %108, i64 %.5494.011080
  store double 1.000000e+00, ptr %.665.i8189, align 8, !noalias !184
  br label %B392.i.sink.split

B348.i:                                           ; preds = %B240.i
  %.733.i7841 = load i64, ptr %.1166, align 8, !noalias !184
  %.734.i7842 = icmp eq i64 %.733.i7841, 0
  br i1 %.734.i7842, label %B392.i.sink.split, label %B392.i

B392.i.sink.split:                                ; preds = %B348.i, %B300.i
  %.sink = phi i64 [ 1, %B300.i ], [ 2, %B348.i ]
  store i64 %.sink, ptr %.1166, align 8, !noalias !184
  br label %B392.i

B392.i:                                           ; preds = %B392.i.sink.split, %B348.i
  br i1 %.175.i.i799411076.not, label %B4086, label %B76.if.i.i.lr.ph

B76.if.i.i.lr.ph:                                 ; preds = %B392.i
  %.237.i.i8042 = select i1 %.373.i7691, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i8043 = add i64 %.237.i.i8042, %.250.i7586
  %.258.i.i8059 = mul i64 %.238.i.i8043, %arg.batch.1.3.5.1
  %260 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i8059
  br label %B76.if.i.i

B76.if.i.i:                                       ; preds = %B76.if.i.i.lr.ph, %B76.if.i.i
  %.117.i.i7346.011078 = phi i64 [ 0, %B76.if.i.i.lr.ph ], [ %.188.i.i8108, %B76.if.i.i ]
  %.188.i.i8108 = add nsw i64 %.117.i.i7346.011078, 1
  %261 = getelementptr double, ptr %260, i64 %.117.i.i7346.011078
  %.263.i.i8062 = load double, ptr %261, align 8, !noalias !188
  %262 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.i7346.011078
  %.293.i.i8080 = load i64, ptr %262, align 8, !noalias !188
  %.295.i.i8082 = mul nsw i64 %.293.i.i8080, %arg.shape.0
  %.297.i.i8084 = add nsw i64 %.295.i.i8082, %.5494.011080
  %.311.i.i8091 = icmp slt i64 %.297.i.i8084, 0
  %.312.i.i8092 = select i1 %.311.i.i8091, i64 %arg.batch.5.1.5.0, i64 0
  %263 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i8084
  %.326.i.i8102 = getelementptr double, ptr %263, i64 %.312.i.i8092
  store double %.263.i.i8062, ptr %.326.i.i8102, align 8, !noalias !188
  %exitcond11122.not = icmp eq i64 %arg.batch.1.1.5.0, %.188.i.i8108
  br i1 %exitcond11122.not, label %B4086, label %B76.if.i.i

B4086:                                            ; preds = %B76.if.i.i, %B392.i, %B216.i8256, %B182.i, %B3982, %B3944
  %.6090 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.5656
  %.6091 = load i64, ptr %.6090, align 8
  %.6092.not = icmp eq i64 %.6091, 0
  br i1 %.6092.not, label %B4228, label %B4120

B4120:                                            ; preds = %B4086
  %.6153 = getelementptr i64, ptr %109, i64 %.5494.011080
  %.6154 = load i64, ptr %.6153, align 8
  %.6184 = getelementptr i64, ptr %arg.batch.3.2.4, i64 %.5656
  store i64 %.6154, ptr %.6184, align 8
  store i64 -1, ptr %.5655, align 8
  %.236.i10745 = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !192
  %.293.i10750 = getelementptr double, ptr %110, i64 %.5494.011080
  store double 0.000000e+00, ptr %.293.i10750, align 8, !noalias !192
  %.324.i10752 = load i64, ptr %.323.i10751, align 8, !noalias !192
  %.326.i10753 = icmp eq i64 %.236.i10745, %.324.i10752
  br i1 %.326.i10753, label %B4436, label %B132.i10754

B132.i10754:                                      ; preds = %B4120
  %.359.i10755 = add nsw i64 %.236.i10745, 1
  store i64 %.359.i10755, ptr %arg.batch.4.2.4, align 8, !noalias !192
  store i64 1, ptr %.1166, align 8, !noalias !192
  %.438.i10757 = icmp slt i64 %.236.i10745, 0
  %.439.i10758 = select i1 %.438.i10757, i64 %arg.batch.0.2.5.0, i64 0
  %264 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i10745
  %.453.i10759 = getelementptr i64, ptr %264, i64 %.439.i10758
  %.454.i10760 = load i64, ptr %.453.i10759, align 8, !noalias !192
  %.469.i10761 = icmp slt i64 %.454.i10760, 0
  %.470.i10762 = select i1 %.469.i10761, i64 %arg.batch.1.0.5.0, i64 0
  %265 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i10760
  %.484.i10763 = getelementptr i64, ptr %265, i64 %.470.i10762
  %.485.i10764 = load i64, ptr %.484.i10763, align 8, !noalias !192
  store i64 %.236.i10745, ptr %.5655, align 8, !noalias !192
  %.595.i10768 = getelementptr i64, ptr %111, i64 %.5494.011080
  store i64 %.485.i10764, ptr %.595.i10768, align 8, !noalias !192
  store i64 1, ptr %.6153, align 8, !noalias !192
  %.709.i10772 = getelementptr i64, ptr %112, i64 %.5494.011080
  store i64 0, ptr %.709.i10772, align 8, !noalias !192
  br i1 %.8051131.not.i10773, label %B402.i10788, label %B358.if.lr.ph.i10774

B358.if.lr.ph.i10774:                             ; preds = %B132.i10754
  %.867.i10775 = select i1 %.438.i10757, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i10776 = add i64 %.867.i10775, %.236.i10745
  %.888.i10777 = mul i64 %.868.i10776, %arg.batch.0.1.5.1
  %266 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i10777
  %invariant.gep11175 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.5494.011080
  br label %B358.if.i10778

B402.i10788:                                      ; preds = %B358.if.i10778, %B132.i10754
  br i1 %.175.i1134.not.i10789, label %B402.endif.i10807, label %B76.if.i.lr.ph.i10790

B76.if.i.lr.ph.i10790:                            ; preds = %B402.i10788
  %.990.i10791 = load i64, ptr %.595.i10768, align 8, !noalias !192
  %.236.i.i10792 = icmp slt i64 %.990.i10791, 0
  %.237.i.i10793 = select i1 %.236.i.i10792, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i10794 = add i64 %.237.i.i10793, %.990.i10791
  %.258.i.i10795 = mul i64 %.238.i.i10794, %arg.batch.1.3.5.1
  %267 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i10795
  br label %B76.if.i.i10796

B76.if.i.i10796:                                  ; preds = %B76.if.i.i10796, %B76.if.i.lr.ph.i10790
  %.117.i.01135.i10797 = phi i64 [ 0, %B76.if.i.lr.ph.i10790 ], [ %.188.i.i10798, %B76.if.i.i10796 ]
  %.188.i.i10798 = add nsw i64 %.117.i.01135.i10797, 1
  %268 = getelementptr double, ptr %267, i64 %.117.i.01135.i10797
  %.263.i.i10799 = load double, ptr %268, align 8, !noalias !195
  %269 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i10797
  %.293.i.i10800 = load i64, ptr %269, align 8, !noalias !195
  %.295.i.i10801 = mul nsw i64 %.293.i.i10800, %arg.shape.0
  %.297.i.i10802 = add nsw i64 %.295.i.i10801, %.5494.011080
  %.311.i.i10803 = icmp slt i64 %.297.i.i10802, 0
  %.312.i.i10804 = select i1 %.311.i.i10803, i64 %arg.batch.5.1.5.0, i64 0
  %270 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i10802
  %.326.i.i10805 = getelementptr double, ptr %270, i64 %.312.i.i10804
  store double %.263.i.i10799, ptr %.326.i.i10805, align 8, !noalias !195
  %exitcond1142.not.i10806 = icmp eq i64 %.188.i.i10798, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i10806, label %B402.endif.i10807, label %B76.if.i.i10796

B888.i10895:                                      ; preds = %B580.if.i10823
  store double 0.000000e+00, ptr %.1877.i10892, align 8, !noalias !192
  br label %B4436

B358.if.i10778:                                   ; preds = %B358.if.i10778, %B358.if.lr.ph.i10774
  %.747.01132.i10779 = phi i64 [ 0, %B358.if.lr.ph.i10774 ], [ %.818.i10780, %B358.if.i10778 ]
  %.818.i10780 = add nsw i64 %.747.01132.i10779, 1
  %271 = getelementptr double, ptr %266, i64 %.747.01132.i10779
  %.893.i10781 = load double, ptr %271, align 8, !noalias !192
  %.895.i10782 = mul nsw i64 %.747.01132.i10779, %arg.shape.0
  %gep11176 = getelementptr double, ptr %invariant.gep11175, i64 %.895.i10782
  store double %.893.i10781, ptr %gep11176, align 8, !noalias !192
  %exitcond.not.i10787 = icmp eq i64 %.818.i10780, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i10787, label %B402.i10788, label %B358.if.i10778

B402.endif.i10807:                                ; preds = %B76.if.i.i10796, %B402.i10788
  br i1 %.11171137.not.i10808, label %B580.if.i10823, label %B496.if.lr.ph.i10809

B496.if.lr.ph.i10809:                             ; preds = %B402.endif.i10807
  %.1179.i10810 = select i1 %.438.i10757, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i10811 = add i64 %.1179.i10810, %.236.i10745
  %.1200.i10812 = mul i64 %.1180.i10811, %arg.batch.0.0.5.1
  %272 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i10812
  %invariant.gep11177 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.5494.011080
  br label %B496.if.i10813

B496.if.i10813:                                   ; preds = %B496.if.i10813, %B496.if.lr.ph.i10809
  %.1061.01138.i10814 = phi i64 [ 0, %B496.if.lr.ph.i10809 ], [ %.1130.i10815, %B496.if.i10813 ]
  %.1130.i10815 = add nsw i64 %.1061.01138.i10814, 1
  %273 = getelementptr double, ptr %272, i64 %.1061.01138.i10814
  %.1205.i10816 = load double, ptr %273, align 8, !noalias !192
  %.1207.i10817 = mul nsw i64 %.1061.01138.i10814, %arg.shape.0
  %gep11178 = getelementptr double, ptr %invariant.gep11177, i64 %.1207.i10817
  store double %.1205.i10816, ptr %gep11178, align 8, !noalias !192
  %exitcond1143.not.i10822 = icmp eq i64 %.1130.i10815, %arg.shape.1
  br i1 %exitcond1143.not.i10822, label %B580.if.i10823, label %B496.if.i10813

B580.if.i10823:                                   ; preds = %B496.if.i10813, %B402.endif.i10807
  %invariant.gep.i10824 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5494.011080
  store double 0.000000e+00, ptr %invariant.gep.i10824, align 8, !noalias !192
  %gep.1.i10825 = getelementptr double, ptr %invariant.gep.i10824, i64 %arg.batch.4.0.5.1
  store double 0.000000e+00, ptr %gep.1.i10825, align 8, !noalias !192
  %gep.2.i10827 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.2.idx.i10826
  store double 0.000000e+00, ptr %gep.2.i10827, align 8, !noalias !192
  %gep.3.i10829 = getelementptr i8, ptr %invariant.gep.i10824, i64 %.idx.i10749
  store double 0.000000e+00, ptr %gep.3.i10829, align 8, !noalias !192
  %gep.4.i10831 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.4.idx.i10830
  store double 0.000000e+00, ptr %gep.4.i10831, align 8, !noalias !192
  %gep.5.i10833 = getelementptr i8, ptr %invariant.gep.i10824, i64 %.idx10537
  store double 0.000000e+00, ptr %gep.5.i10833, align 8, !noalias !192
  %gep.6.i10835 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.6.idx.i10834
  store double 0.000000e+00, ptr %gep.6.i10835, align 8, !noalias !192
  %gep.7.i10837 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.7.idx.i10836
  store double 0.000000e+00, ptr %gep.7.i10837, align 8, !noalias !192
  %gep.8.i10839 = getelementptr i8, ptr %invariant.gep.i10824, i64 %.571.idx
  store double 0.000000e+00, ptr %gep.8.i10839, align 8, !noalias !192
  %gep.9.i10841 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.9.idx.i10840
  store double 0.000000e+00, ptr %gep.9.i10841, align 8, !noalias !192
  %gep.10.i10843 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.10.idx.i10842
  store double 0.000000e+00, ptr %gep.10.i10843, align 8, !noalias !192
  %gep.11.i10845 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.11.idx.i10844
  store double 0.000000e+00, ptr %gep.11.i10845, align 8, !noalias !192
  %gep.12.i10847 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.12.idx.i10846
  store double 0.000000e+00, ptr %gep.12.i10847, align 8, !noalias !192
  %gep.13.i10849 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.13.idx.i10848
  store double 0.000000e+00, ptr %gep.13.i10849, align 8, !noalias !192
  %gep.14.i10851 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.14.idx.i10850
  store double 0.000000e+00, ptr %gep.14.i10851, align 8, !noalias !192
  %gep.15.i10853 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.15.idx.i10852
  store double 0.000000e+00, ptr %gep.15.i10853, align 8, !noalias !192
  %gep.16.i10855 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.16.idx.i10854
  store double 0.000000e+00, ptr %gep.16.i10855, align 8, !noalias !192
  %gep.17.i10857 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.17.idx.i10856
  store double 0.000000e+00, ptr %gep.17.i10857, align 8, !noalias !192
  %gep.18.i10859 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.18.idx.i10858
  store double 0.000000e+00, ptr %gep.18.i10859, align 8, !noalias !192
  %gep.19.i10861 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.19.idx.i10860
  store double 0.000000e+00, ptr %gep.19.i10861, align 8, !noalias !192
  %gep.20.i10863 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.20.idx.i10862
  store double 0.000000e+00, ptr %gep.20.i10863, align 8, !noalias !192
  %gep.21.i10865 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.21.idx.i10864
  store double 0.000000e+00, ptr %gep.21.i10865, align 8, !noalias !192
  %gep.22.i10867 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.22.idx.i10866
  store double 0.000000e+00, ptr %gep.22.i10867, align 8, !noalias !192
  %gep.23.i10869 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.23.idx.i10868
  store double 0.000000e+00, ptr %gep.23.i10869, align 8, !noalias !192
  %gep.24.i10871 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.24.idx.i10870
  store double 0.000000e+00, ptr %gep.24.i10871, align 8, !noalias !192
  %gep.25.i10873 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.25.idx.i10872
  store double 0.000000e+00, ptr %gep.25.i10873, align 8, !noalias !192
  %gep.26.i10875 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.26.idx.i10874
  store double 0.000000e+00, ptr %gep.26.i10875, align 8, !noalias !192
  %gep.27.i10877 = getelementptr i8, ptr %invariant.gep.i10824, i64 %gep.27.idx.i10876
  store double 0.000000e+00, ptr %gep.27.i10877, align 8, !noalias !192
  %.1455.i10878 = load double, ptr %arg.batch.2.4, align 8, !noalias !192
  %.1516.i10879 = load i64, ptr %.595.i10768, align 8, !noalias !192
  %.1531.i10880 = icmp slt i64 %.1516.i10879, 0
  %.1532.i10881 = select i1 %.1531.i10880, i64 %arg.batch.1.2.5.0, i64 0
  %274 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i10879
  %.1546.i10882 = getelementptr double, ptr %274, i64 %.1532.i10881
  %.1547.i10883 = load double, ptr %.1546.i10882, align 8, !noalias !192
  store double %.1455.i10878, ptr %invariant.gep.i10824, align 8, !noalias !192
  %.1656.i10886 = getelementptr double, ptr %113, i64 %.5494.011080
  store double %.1547.i10883, ptr %.1656.i10886, align 8, !noalias !192
  store double 1.000000e+00, ptr %.293.i10750, align 8, !noalias !192
  %.1767.i10888 = getelementptr double, ptr %114, i64 %.5494.011080
  store double 0xFFF0000000000000, ptr %.1767.i10888, align 8, !noalias !192
  %.1822.i10890 = getelementptr double, ptr %115, i64 %.5494.011080
  store double 0x7FF0000000000000, ptr %.1822.i10890, align 8, !noalias !192
  %.1877.i10892 = getelementptr double, ptr %116, i64 %.5494.011080
  %.1878.i10893 = load double, ptr %.1877.i10892, align 8, !noalias !192
  %.1880.i10894 = fcmp ueq double %.1878.i10893, 0xFFF0000000000000
  br i1 %.1880.i10894, label %B4436, label %B888.i10895

B4228:                                            ; preds = %B4086
  %.6380 = getelementptr double, ptr %117, i64 %.5494.011080
  %.6381 = load double, ptr %.6380, align 8
  %.6383 = fcmp ult double %.6381, 1.500000e+01
  br i1 %.6383, label %B4436, label %B4276

B4276:                                            ; preds = %B4228
  %.6427 = load double, ptr %.6426, align 8
  %.6481 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5494.011080
  %.6482 = load double, ptr %.6481, align 8
  %.6483 = fsub double %.6427, %.6482
  %.6537 = getelementptr double, ptr %120, i64 %.5494.011080
  %.6538 = load double, ptr %.6537, align 8
  %.6540 = fmul double %.6538, 5.000000e+03
  %.6541 = fcmp ogt double %.6483, %.6540
  br i1 %.6541, label %B4436, label %B4412

B4412:                                            ; preds = %B4276
  store double 0.000000e+00, ptr %.6380, align 8
  br label %B4436

B4436:                                            ; preds = %B888.i10895, %B4120, %B580.if.i10823, %B4276, %B4412, %B4228
  %budget.7.4 = phi i64 [ %budget.5.211082, %B4228 ], [ 0, %B4276 ], [ %budget.5.211082, %B4412 ], [ %budget.5.211082, %B580.if.i10823 ], [ %budget.5.211082, %B4120 ], [ %budget.5.211082, %B888.i10895 ]
  %.6669 = load i64, ptr %.5655, align 8
  %.6670 = icmp sgt i64 %.6669, -1
  br i1 %.6670, label %B4474, label %B4731

B4474:                                            ; preds = %B4436
  %.6675 = add nsw i64 %active.5.211083, 1
  %.6784 = mul i64 %.6669, %arg.batch.3.3.5.1
  %.6788 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.6784
  %.6789 = load i64, ptr %.6788, align 8
  %.6800.0 = and i64 %.6789, 127
  %.6830 = sub nsw i64 128, %.6800.0
  %.11.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.6830, i64 %.5792)
  %.6918 = getelementptr double, ptr %121, i64 %.5494.011080
  %.6919 = load double, ptr %.6918, align 8
  %.6921 = fcmp ogt double %.6919, 0.000000e+00
  %.6932 = sitofp i64 %.11.i to double
  %"$phi4644.1.2.5" = select i1 %.6921, double 1.000000e+00, double %.6932
  %.6995 = getelementptr double, ptr %122, i64 %.5494.011080
  store double %"$phi4644.1.2.5", ptr %.6995, align 8
  %.111.i8389 = getelementptr i64, ptr %123, i64 %.5494.011080
  %.112.i8390 = load i64, ptr %.111.i8389, align 8, !noalias !199
  %.169.i8439 = getelementptr double, ptr %124, i64 %.5494.011080
  %.170.i8440 = load double, ptr %.169.i8439, align 8, !noalias !199
  %.224.i8488 = getelementptr double, ptr %125, i64 %.5494.011080
  store double %.170.i8440, ptr %.224.i8488, align 8, !noalias !199
  %.237.i8496 = icmp slt i64 %.112.i8390, %arg.batch.2.5.0
  br i1 %.237.i8496, label %B134.i8501, label %B4731

B134.i8501:                                       ; preds = %B4474
  %.253.i8512 = icmp slt i64 %.112.i8390, 0
  %.254.i8513 = select i1 %.253.i8512, i64 %arg.batch.2.5.0, i64 0
  %275 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i8390
  %.268.i8527 = getelementptr double, ptr %275, i64 %.254.i8513
  %.269.i8528 = load double, ptr %.268.i8527, align 8, !noalias !199
  %.328.i8579 = load double, ptr %.169.i8439, align 8, !noalias !199
  %.10.i.i8586 = fcmp olt double %.328.i8579, %.269.i8528
  %.11.i.i8587 = select i1 %.10.i.i8586, double %.328.i8579, double %.269.i8528
  store double %.11.i.i8587, ptr %.224.i8488, align 8, !noalias !199
  br label %B4731

B4704:                                            ; preds = %B4731, %B3728
  %budget.4.2 = phi i64 [ %.1132, %B3728 ], [ %budget.6.3, %B4731 ]
  %active.8.2 = phi i64 [ %active.9.1.mux, %B3728 ], [ %active.6.3, %B4731 ]
  %.7073 = icmp sgt i64 %active.8.2, 0
  %.7087 = icmp sgt i64 %budget.4.2, 0
  %or.cond10629 = select i1 %.7073, i1 %.7087, i1 false
  br i1 %or.cond10629, label %B584, label %B4730

B4730:                                            ; preds = %B4704, %B556
  %active.10.0 = phi i64 [ %active.4.0.lcssa, %B556 ], [ %active.8.2, %B4704 ]
  br i1 %.794, label %B4730.endif, label %B80.if.i2039.lr.ph

B80.if.i2039.lr.ph:                               ; preds = %B4730
  %.idx = mul i64 %arg.batch.4.0.5.1, 184
  %276 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx
  %.idx10535 = mul i64 %arg.batch.4.0.5.1, 192
  %277 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10535
  %.703.i1698 = add nsw i64 %arg.shape.2, -1
  %.idx10536 = mul i64 %arg.batch.4.0.5.1, 168
  %278 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10536
  br label %B80.if.i2039

B126.i1345:                                       ; preds = %B80.if.i2039
  %.318.i1392 = getelementptr double, ptr %276, i64 %.105.i1190.011089
  %.319.i1393 = load double, ptr %.318.i1392, align 8, !noalias !203
  %.5.i.i1394 = fptosi double %.319.i1393 to i64
  %.397.i1443 = getelementptr double, ptr %277, i64 %.105.i1190.011089
  %.398.i1444 = load double, ptr %.397.i1443, align 8, !noalias !203
  %.5.i1.i1445 = fptosi double %.398.i1444 to i64
  %.478.i1496 = mul i64 %.258.i1338, %arg.batch.3.3.5.1
  %.482.i1500 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.478.i1496
  %.483.i1501 = load i64, ptr %.482.i1500, align 8, !noalias !203
  %.485.i1503 = add nsw i64 %.483.i1501, %.5.i.i1394
  store i64 %.485.i1503, ptr %.482.i1500, align 8, !noalias !203
  %.591.i1598 = getelementptr i8, ptr %.482.i1500, i64 24
  %.592.i1599 = load i64, ptr %.591.i1598, align 8, !noalias !203
  %.594.i1601 = add nsw i64 %.592.i1599, %.5.i1.i1445
  store i64 %.594.i1601, ptr %.591.i1598, align 8, !noalias !203
  %.700.i1695 = getelementptr i8, ptr %.482.i1500, i64 8
  %.701.i1696 = load i64, ptr %.700.i1695, align 8, !noalias !203
  %.706.i1701 = add nsw i64 %.5.i1.i1445, %.5.i.i1394
  %.707.i1702 = mul nsw i64 %.706.i1701, %.703.i1698
  %..5.i.i1394 = select i1 %.625, i64 0, i64 %.5.i.i1394
  %.708.i1703 = add i64 %.707.i1702, %..5.i.i1394
  %.841.i1807 = add i64 %.708.i1703, %.701.i1696
  store i64 %.841.i1807, ptr %.700.i1695, align 8, !noalias !203
  store double 0.000000e+00, ptr %.318.i1392, align 8, !noalias !203
  store double 0.000000e+00, ptr %.397.i1443, align 8, !noalias !203
  %.1072.i1985 = getelementptr double, ptr %278, i64 %.105.i1190.011089
  %.1073.i1986 = load double, ptr %.1072.i1985, align 8, !noalias !203
  %.1081.i1992 = sitofp i64 %.706.i1701 to double
  %.1082.i1993 = fsub double %.1073.i1986, %.1081.i1992
  store double %.1082.i1993, ptr %.1072.i1985, align 8, !noalias !203
  br label %B568.i1342

B568.i1342:                                       ; preds = %B126.i1345, %B80.if.i2039
  %.163.i1271 = icmp sgt i64 %.108.i1191.011090, 1
  br i1 %.163.i1271, label %B80.if.i2039, label %B4730.endif

B80.if.i2039:                                     ; preds = %B80.if.i2039.lr.ph, %B568.i1342
  %.108.i1191.011090 = phi i64 [ %storemerge, %B80.if.i2039.lr.ph ], [ %.172.i2043, %B568.i1342 ]
  %.105.i1190.011089 = phi i64 [ 0, %B80.if.i2039.lr.ph ], [ %.176.i2046, %B568.i1342 ]
  %.172.i2043 = add nsw i64 %.108.i1191.011090, -1
  %.176.i2046 = add nsw i64 %.105.i1190.011089, 1
  %279 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i1190.011089
  %.258.i1338 = load i64, ptr %279, align 8, !noalias !203
  %.263.i1341 = icmp sgt i64 %.258.i1338, -1
  br i1 %.263.i1341, label %B126.i1345, label %B568.i1342

B4731:                                            ; preds = %B4474, %B134.i8501, %B4436, %B3770.if
  %budget.6.3 = phi i64 [ %budget.5.211082, %B3770.if ], [ %budget.7.4, %B4436 ], [ %budget.7.4, %B134.i8501 ], [ %budget.7.4, %B4474 ]
  %active.6.3 = phi i64 [ %active.5.211083, %B3770.if ], [ %active.5.211083, %B4436 ], [ %.6675, %B134.i8501 ], [ %.6675, %B4474 ]
  %.5557 = icmp sgt i64 %.5497.011081, 1
  br i1 %.5557, label %B3770.if, label %B4704

B416.if:                                          ; preds = %B416.if.lr.ph, %B502
  %active.4.010907 = phi i64 [ 0, %B416.if.lr.ph ], [ %.1089, %B502 ]
  %.783.010906 = phi i64 [ %storemerge, %B416.if.lr.ph ], [ %.847, %B502 ]
  %.780.010905 = phi i64 [ 0, %B416.if.lr.ph ], [ %.851, %B502 ]
  %.847 = add nsw i64 %.783.010906, -1
  %.851 = add nsw i64 %.780.010905, 1
  %280 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.780.010905
  %.933 = load i64, ptr %280, align 8
  %.934 = icmp slt i64 %.933, 0
  br i1 %.934, label %B458, label %B502

B1534.if:                                         ; preds = %B1502, %B1726
  %.2165.010922 = phi i64 [ %.2234, %B1726 ], [ 1, %B1502 ]
  %.2234 = add i64 %.2165.010922, 1
  %281 = getelementptr i64, ptr %arg.code.4, i64 %.2165.010922
  %282 = getelementptr i8, ptr %281, i64 128
  %.2293 = load i64, ptr %282, align 8
  %.2338 = inttoptr i64 %.2293 to ptr
  tail call void %.2338(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.2344 = add nsw i64 %.2165.010922, %.
  %.2346 = mul nsw i64 %.2344, %.463
  %.2391 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2346
  tail call void %.2392(ptr %.571, ptr %.2366, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.2391)
  br i1 %or.cond10899.not, label %B68.if.lr.ph.i, label %B1726

B1870.if:                                         ; preds = %B1728, %B1956
  %looked.2.110928 = phi i1 [ %"$phi1956.1.2.2", %B1956 ], [ %spec.select10630, %B1728 ]
  %good.2.110927 = phi i1 [ %"$phi1914.1.2.2", %B1956 ], [ false, %B1728 ]
  %.2611.010926 = phi i64 [ %.2673, %B1956 ], [ %storemerge, %B1728 ]
  %.2608.010925 = phi i64 [ %.2677, %B1956 ], [ 0, %B1728 ]
  %.2673 = add nsw i64 %.2611.010926, -1
  %.2677 = add nsw i64 %.2608.010925, 1
  br i1 %good.2.110927, label %B1914, label %B1878

B2030.if:                                         ; preds = %B2030.preheader, %B2536
  %checked.3.210938 = phi i1 [ %checked.4.3, %B2536 ], [ false, %B2030.preheader ]
  %within.3.210937 = phi i1 [ %within.4.3, %B2536 ], [ false, %B2030.preheader ]
  %.2966.010936 = phi i64 [ %.3034, %B2536 ], [ %storemerge, %B2030.preheader ]
  %.2963.010935 = phi i64 [ %.3038, %B2536 ], [ 0, %B2030.preheader ]
  %.3034 = add nsw i64 %.2966.010936, -1
  %.3038 = add nsw i64 %.2963.010935, 1
  %.3123 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2963.010935
  %.3124 = load i64, ptr %.3123, align 8
  %.3178 = getelementptr i64, ptr %38, i64 %.2963.010935
  %.3179 = load i64, ptr %.3178, align 8
  %.3239 = getelementptr double, ptr %39, i64 %.2963.010935
  store double 0.000000e+00, ptr %.3239, align 8
  %.3242 = icmp sgt i64 %.3124, -1
  br i1 %.3242, label %B2130, label %B2536

B46.i:                                            ; preds = %B2168
  %.120.i2141 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i2115
  %.121.i2142 = load i64, ptr %.120.i2141, align 8, !noalias !50
  %.122.i2143 = icmp eq i64 %.121.i2142, 0
  br i1 %.122.i2143, label %B80.i2147, label %B2268

B80.i2147:                                        ; preds = %B46.i
  store i64 %.5.i, ptr %.120.i2141, align 8, !noalias !50
  br label %B2268

B2930.if:                                         ; preds = %B2882
  %.4398 = load i64, ptr %127, align 8
  %.4443 = inttoptr i64 %.4398 to ptr
  tail call void %.4443(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4474 = load i64, ptr %arg.code.4, align 8
  %.4524 = inttoptr i64 %.4474 to ptr
  tail call void %.4524(ptr %.571, ptr %.4498, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4523)
  %.4398.1 = load i64, ptr %128, align 8
  %.4443.1 = inttoptr i64 %.4398.1 to ptr
  tail call void %.4443.1(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4474.1 = load i64, ptr %arg.code.4, align 8
  %.4524.1 = inttoptr i64 %.4474.1 to ptr
  tail call void %.4524.1(ptr %.571, ptr %.4498, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4523.1)
  %.4398.2 = load i64, ptr %129, align 8
  %.4443.2 = inttoptr i64 %.4398.2 to ptr
  tail call void %.4443.2(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4474.2 = load i64, ptr %arg.code.4, align 8
  %.4524.2 = inttoptr i64 %.4474.2 to ptr
  tail call void %.4524.2(ptr %.571, ptr %.4498, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4523.2)
  %.4562 = load i64, ptr %.4561, align 8
  %.4607 = inttoptr i64 %.4562 to ptr
  tail call void %.4607(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4639 = load i64, ptr %.4638, align 8
  %.4684 = inttoptr i64 %.4639 to ptr
  tail call void %.4684(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.794, label %B3298, label %B64.if.i6069

B3302.endif.endif:                                ; preds = %B806.if.i3735, %B806.i3639.preheader
  br i1 %some.2.i3423.1.lcssa, label %B3340, label %B3382

B3770.if:                                         ; preds = %B3728, %B4731
  %active.5.211083 = phi i64 [ %active.6.3, %B4731 ], [ 0, %B3728 ]
  %budget.5.211082 = phi i64 [ %budget.6.3, %B4731 ], [ %.1132, %B3728 ]
  %.5497.011081 = phi i64 [ %.5566, %B4731 ], [ %storemerge, %B3728 ]
  %.5494.011080 = phi i64 [ %.5570, %B4731 ], [ 0, %B3728 ]
  %.5566 = add nsw i64 %.5497.011081, -1
  %.5570 = add nsw i64 %.5494.011080, 1
  %.5655 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5494.011080
  %.5656 = load i64, ptr %.5655, align 8
  %.5661 = icmp slt i64 %.5656, 0
  br i1 %.5661, label %B4731, label %B3818

B4730.endif:                                      ; preds = %B568.i1342, %B4730
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

define dso_local noundef i32 @evaluate_of_many(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.role, i64 %arg.n, i64 %arg.decisions.0, i64 %arg.decisions.1, ptr readnone %arg.points.0.0, ptr readnone %arg.points.0.1, i64 %arg.points.0.2, i64 %arg.points.0.3, ptr readonly %arg.points.0.4, i64 %arg.points.0.5.0, i64 %arg.points.0.6.0, ptr readnone %arg.points.1.0, ptr readnone %arg.points.1.1, i64 %arg.points.1.2, i64 %arg.points.1.3, ptr readonly %arg.points.1.4, i64 %arg.points.1.5.0, i64 %arg.points.1.6.0, ptr readnone %arg.points.2.0, ptr readnone %arg.points.2.1, i64 %arg.points.2.2, i64 %arg.points.2.3, ptr %arg.points.2.4, i64 %arg.points.2.5.0, i64 %arg.points.2.6.0, ptr readnone %arg.points.3.0, ptr readnone %arg.points.3.1, i64 %arg.points.3.2, i64 %arg.points.3.3, ptr %arg.points.3.4, i64 %arg.points.3.5.0, i64 %arg.points.3.6.0, ptr readnone %arg.pieces.0.0, ptr readnone %arg.pieces.0.1, i64 %arg.pieces.0.2, i64 %arg.pieces.0.3, ptr readonly %arg.pieces.0.4, i64 %arg.pieces.0.5.0, i64 %arg.pieces.0.6.0, ptr readnone %arg.pieces.1.0, ptr readnone %arg.pieces.1.1, i64 %arg.pieces.1.2, i64 %arg.pieces.1.3, ptr readonly %arg.pieces.1.4, i64 %arg.pieces.1.5.0, i64 %arg.pieces.1.5.1, i64 %arg.pieces.1.6.0, i64 %arg.pieces.1.6.1, ptr readnone %arg.arrays.0.0, ptr readnone %arg.arrays.0.1, i64 %arg.arrays.0.2, i64 %arg.arrays.0.3, ptr %arg.arrays.0.4, i64 %arg.arrays.0.5.0, i64 %arg.arrays.0.6.0, ptr readnone %arg.arrays.1.0, ptr readnone %arg.arrays.1.1, i64 %arg.arrays.1.2, i64 %arg.arrays.1.3, ptr %arg.arrays.1.4, i64 %arg.arrays.1.5.0, i64 %arg.arrays.1.6.0, ptr readnone %arg.arrays.2.0, ptr readnone %arg.arrays.2.1, i64 %arg.arrays.2.2, i64 %arg.arrays.2.3, ptr %arg.arrays.2.4, i64 %arg.arrays.2.5.0, i64 %arg.arrays.2.6.0, ptr readnone %arg.arrays.3.0, ptr readnone %arg.arrays.3.1, i64 %arg.arrays.3.2, i64 %arg.arrays.3.3, ptr %arg.arrays.3.4, i64 %arg.arrays.3.5.0, i64 %arg.arrays.3.6.0, ptr readnone %arg.out.0, ptr readnone %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.5.1, i64 %arg.out.6.0, i64 %arg.out.6.1) local_unnamed_addr {
entry:
  %.281834.not = icmp slt i64 %arg.points.0.5.0, 1
  br i1 %.281834.not, label %B794, label %B118.if.lr.ph

B118.if.lr.ph:                                    ; preds = %entry
  %.548826.not = icmp slt i64 %arg.pieces.0.5.0, 1
  %.735 = getelementptr i8, ptr %arg.code.4, i64 8
  %.788 = icmp eq i64 %arg.role, 0
  %.791 = icmp sgt i64 %arg.decisions.1, 0
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
  %exitcond840.not = icmp eq i64 %.294, %arg.points.0.5.0
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
  %.758 = getelementptr double, ptr %arg.points.3.4, i64 %.739
  %.784 = inttoptr i64 %.736 to ptr
  tail call void %.784(ptr nonnull %arg.points.2.4, ptr %.758, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.2.4)
  br label %B358

B358:                                             ; preds = %B284, %B118.if
  %piece.3.1 = phi i64 [ %.417, %B284 ], [ %piece.2.0837, %B118.if ]
  br i1 %or.cond, label %B392, label %B604

B392:                                             ; preds = %B358
  %.822 = load i64, ptr %.821, align 8
  %.825 = mul nsw i64 %.222.0835, %arg.n
  %.844 = getelementptr double, ptr %arg.points.3.4, i64 %.825
  %.870 = inttoptr i64 %.822 to ptr
  tail call void %.870(ptr nonnull %arg.points.2.4, ptr %.844, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4)
  br label %B496.if

B530:                                             ; preds = %B496.if
  %.1086 = load i64, ptr %.1085, align 8
  %.1134 = inttoptr i64 %.1086 to ptr
  tail call void %.1134(ptr nonnull %arg.points.2.4, ptr %.844, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.2.4)
  br label %B604

B604:                                             ; preds = %B530, %B358
  %.1167 = load i64, ptr %.1166, align 8
  %.1170 = mul nsw i64 %.222.0835, %arg.n
  %.1189 = getelementptr double, ptr %arg.points.3.4, i64 %.1170
  %.1215 = inttoptr i64 %.1167 to ptr
  tail call void %.1215(ptr nonnull %arg.points.2.4, ptr %.1189, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4)
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
  %3 = getelementptr double, ptr %arg.points.0.4, i64 %.222.0835
  %.356 = load double, ptr %3, align 8
  store double %.356, ptr %arg.points.2.4, align 8
  %4 = getelementptr i64, ptr %arg.points.1.4, i64 %.222.0835
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
  %.1021 = add nsw i64 %.896.0829, %arg.decisions.0
  %.1035 = icmp slt i64 %.1021, 0
  %.1036 = select i1 %.1035, i64 %arg.arrays.0.5.0, i64 0
  %9 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1021
  %.1050 = getelementptr double, ptr %9, i64 %.1036
  store double %.1019, ptr %.1050, align 8
  %exitcond838.not = icmp eq i64 %.965, %arg.decisions.1
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
!1 = distinct !{!1, !2, !"_ZN12clpt_control6native9for_numba8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN12clpt_control6native9for_numba8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!3 = !{!4, !6, !1}
!4 = distinct !{!4, !5, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!5 = distinct !{!5, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!6 = distinct !{!6, !5, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!7 = !{!8, !10}
!8 = distinct !{!8, !9, !"_ZN12clpt_control6native9for_numba6decideB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!9 = distinct !{!9, !"_ZN12clpt_control6native9for_numba6decideB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!10 = distinct !{!10, !9, !"_ZN12clpt_control6native9for_numba6decideB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!11 = !{!12, !14}
!12 = distinct !{!12, !13, !"_ZN12clpt_control6native9for_numba11begin_pieceB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!13 = distinct !{!13, !"_ZN12clpt_control6native9for_numba11begin_pieceB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!14 = distinct !{!14, !13, !"_ZN12clpt_control6native9for_numba11begin_pieceB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
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
!47 = distinct !{!47, !48, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!48 = distinct !{!48, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!49 = distinct !{!49, !48, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!50 = !{!51}
!51 = distinct !{!51, !52, !"_ZN12clpt_control6native9for_numba4failB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx: %retptr"}
!52 = distinct !{!52, !"_ZN12clpt_control6native9for_numba4failB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedExx"}
!53 = !{!54, !56}
!54 = distinct !{!54, !55, !"_ZN12clpt_control6native9for_numba11mark_passedB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!55 = distinct !{!55, !"_ZN12clpt_control6native9for_numba11mark_passedB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!56 = distinct !{!56, !55, !"_ZN12clpt_control6native9for_numba11mark_passedB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!57 = !{!58, !60, !54, !56}
!58 = distinct !{!58, !59, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!59 = distinct !{!59, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!60 = distinct !{!60, !59, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!61 = !{!62, !64, !54, !56}
!62 = distinct !{!62, !63, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!63 = distinct !{!63, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!64 = distinct !{!64, !63, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!65 = !{!66, !68, !62, !64, !54, !56}
!66 = distinct !{!66, !67, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!67 = distinct !{!67, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!68 = distinct !{!68, !67, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!69 = !{!70, !72}
!70 = distinct !{!70, !71, !"_ZN12clpt_control6native9for_numba17check_interpolantB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!71 = distinct !{!71, !"_ZN12clpt_control6native9for_numba17check_interpolantB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!72 = distinct !{!72, !71, !"_ZN12clpt_control6native9for_numba17check_interpolantB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!73 = !{!74, !70, !72}
!74 = distinct !{!74, !75, !"_ZN12clpt_control6native9for_numba9try_againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!75 = distinct !{!75, !"_ZN12clpt_control6native9for_numba9try_againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!76 = !{!77, !79}
!77 = distinct !{!77, !78, !"_ZN12clpt_control6native9for_numba11mark_passedB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!78 = distinct !{!78, !"_ZN12clpt_control6native9for_numba11mark_passedB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!79 = distinct !{!79, !78, !"_ZN12clpt_control6native9for_numba11mark_passedB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!80 = !{!81, !83, !77, !79}
!81 = distinct !{!81, !82, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!82 = distinct !{!82, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!83 = distinct !{!83, !82, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!84 = !{!85, !87, !77, !79}
!85 = distinct !{!85, !86, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!86 = distinct !{!86, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!87 = distinct !{!87, !86, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!88 = !{!89, !91, !85, !87, !77, !79}
!89 = distinct !{!89, !90, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!90 = distinct !{!90, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!91 = distinct !{!91, !90, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!92 = !{!93}
!93 = distinct !{!93, !94, !"_ZN12clpt_control6native9for_numba12locate_kinksB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!94 = distinct !{!94, !"_ZN12clpt_control6native9for_numba12locate_kinksB3v31B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!95 = !{!96, !98, !93}
!96 = distinct !{!96, !97, !"_ZN12clpt_control6native9for_numba14measure_effectB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!97 = distinct !{!97, !"_ZN12clpt_control6native9for_numba14measure_effectB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!98 = distinct !{!98, !97, !"_ZN12clpt_control6native9for_numba14measure_effectB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!99 = !{!100, !102, !96, !98, !93}
!100 = distinct !{!100, !101, !"_ZN12clpt_control6native9for_numba8exchangeB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!101 = distinct !{!101, !"_ZN12clpt_control6native9for_numba8exchangeB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!102 = distinct !{!102, !101, !"_ZN12clpt_control6native9for_numba8exchangeB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!103 = !{!104, !106, !96, !98, !93}
!104 = distinct !{!104, !105, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!105 = distinct !{!105, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!106 = distinct !{!106, !105, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!107 = !{!108, !110, !104, !106, !96, !98, !93}
!108 = distinct !{!108, !109, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!109 = distinct !{!109, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!110 = distinct !{!110, !109, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!111 = !{!112, !114, !96, !98, !93}
!112 = distinct !{!112, !113, !"_ZN12clpt_control6native9for_numba8exchangeB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!113 = distinct !{!113, !"_ZN12clpt_control6native9for_numba8exchangeB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!114 = distinct !{!114, !113, !"_ZN12clpt_control6native9for_numba8exchangeB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!115 = !{!116, !118, !93}
!116 = distinct !{!116, !117, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!117 = distinct !{!117, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!118 = distinct !{!118, !117, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!119 = !{!120, !122, !123, !125, !93}
!120 = distinct !{!120, !121, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!121 = distinct !{!121, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!122 = distinct !{!122, !121, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!123 = distinct !{!123, !124, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!124 = distinct !{!124, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!125 = distinct !{!125, !124, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!126 = !{!123, !125, !93}
!127 = !{!128, !130, !93}
!128 = distinct !{!128, !129, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!129 = distinct !{!129, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!130 = distinct !{!130, !129, !"_ZN12clpt_control6native9for_numba12first_passedB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!131 = !{!132, !93}
!132 = distinct !{!132, !133, !"_ZN12clpt_control6native9for_numba9try_againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!133 = distinct !{!133, !"_ZN12clpt_control6native9for_numba9try_againB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExd5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!134 = !{!135}
!135 = distinct !{!135, !136, !"_ZN12clpt_control6native9for_numba12watch_guardsB3v35B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!136 = distinct !{!136, !"_ZN12clpt_control6native9for_numba12watch_guardsB3v35B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!137 = !{!138, !135}
!138 = distinct !{!138, !139, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!139 = distinct !{!139, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!140 = !{!141, !143, !135}
!141 = distinct !{!141, !142, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %retptr"}
!142 = distinct !{!142, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd"}
!143 = distinct !{!143, !142, !"_ZN12clpt_control6native9for_numba12state_withinB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEd: %excinfo"}
!144 = !{!145, !147, !141, !143, !135}
!145 = distinct !{!145, !146, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!146 = distinct !{!146, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!147 = distinct !{!147, !146, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!148 = !{!149}
!149 = distinct !{!149, !150, !"_ZN12clpt_control6native9for_numba6sampleB3v36B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!150 = distinct !{!150, !"_ZN12clpt_control6native9for_numba6sampleB3v36B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi7EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!151 = !{!152, !154, !149}
!152 = distinct !{!152, !153, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!153 = distinct !{!153, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!154 = distinct !{!154, !153, !"_ZN12clpt_control6native9for_numba11interpolateB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
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
!165 = distinct !{!165, !166, !"_ZN12clpt_control6native9for_numba4jumpB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!166 = distinct !{!166, !"_ZN12clpt_control6native9for_numba4jumpB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi7EE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
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
!185 = distinct !{!185, !186, !"_ZN12clpt_control6native9for_numba11enter_pieceB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!186 = distinct !{!186, !"_ZN12clpt_control6native9for_numba11enter_pieceB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!187 = distinct !{!187, !186, !"_ZN12clpt_control6native9for_numba11enter_pieceB3v42B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!188 = !{!189, !191, !185, !187}
!189 = distinct !{!189, !190, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!190 = distinct !{!190, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!191 = distinct !{!191, !190, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!192 = !{!193}
!193 = distinct !{!193, !194, !"_ZN12clpt_control6native9for_numba8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!194 = distinct !{!194, !"_ZN12clpt_control6native9for_numba8take_runB2v2B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi7EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!195 = !{!196, !198, !193}
!196 = distinct !{!196, !197, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!197 = distinct !{!197, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE"}
!198 = distinct !{!198, !197, !"_ZN12clpt_control6native9for_numba9set_pieceB2v3B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEEx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!199 = !{!200, !202}
!200 = distinct !{!200, !201, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!201 = distinct !{!201, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!202 = distinct !{!202, !201, !"_ZN12clpt_control6native9for_numba10look_aheadB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!203 = !{!204, !206}
!204 = distinct !{!204, !205, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!205 = distinct !{!205, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!206 = distinct !{!206, !205, !"_ZN12clpt_control6native9for_numba11count_stepsB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi7EE5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}

define i64 @advance(ptr %numbers) {
  %result = alloca i64
  %error = alloca ptr
  %at.0 = getelementptr i64, ptr %numbers, i64 0
  %number.0 = load ptr, ptr %at.0
  %at.1 = getelementptr i64, ptr %numbers, i64 1
  %number.1 = load ptr, ptr %at.1
  %at.2 = getelementptr i64, ptr %numbers, i64 2
  %number.2 = load i64, ptr %at.2
  %at.3 = getelementptr i64, ptr %numbers, i64 3
  %number.3 = load i64, ptr %at.3
  %at.4 = getelementptr i64, ptr %numbers, i64 4
  %number.4 = load ptr, ptr %at.4
  %at.5 = getelementptr i64, ptr %numbers, i64 5
  %number.5 = load i64, ptr %at.5
  %at.6 = getelementptr i64, ptr %numbers, i64 6
  %number.6 = load i64, ptr %at.6
  %at.7 = getelementptr i64, ptr %numbers, i64 7
  %number.7 = load i64, ptr %at.7
  %at.8 = getelementptr i64, ptr %numbers, i64 8
  %number.8 = load i64, ptr %at.8
  %at.9 = getelementptr i64, ptr %numbers, i64 9
  %number.9 = load i64, ptr %at.9
  %at.10 = getelementptr i64, ptr %numbers, i64 10
  %number.10 = load i64, ptr %at.10
  %at.11 = getelementptr i64, ptr %numbers, i64 11
  %number.11 = load i64, ptr %at.11
  %at.12 = getelementptr i64, ptr %numbers, i64 12
  %number.12 = load i64, ptr %at.12
  %at.13 = getelementptr i64, ptr %numbers, i64 13
  %number.13 = load i64, ptr %at.13
  %at.14 = getelementptr i64, ptr %numbers, i64 14
  %number.14 = load ptr, ptr %at.14
  %at.15 = getelementptr i64, ptr %numbers, i64 15
  %number.15 = load ptr, ptr %at.15
  %at.16 = getelementptr i64, ptr %numbers, i64 16
  %number.16 = load i64, ptr %at.16
  %at.17 = getelementptr i64, ptr %numbers, i64 17
  %number.17 = load i64, ptr %at.17
  %at.18 = getelementptr i64, ptr %numbers, i64 18
  %number.18 = load ptr, ptr %at.18
  %at.19 = getelementptr i64, ptr %numbers, i64 19
  %number.19 = load i64, ptr %at.19
  %at.20 = getelementptr i64, ptr %numbers, i64 20
  %number.20 = load i64, ptr %at.20
  %at.21 = getelementptr i64, ptr %numbers, i64 21
  %number.21 = load ptr, ptr %at.21
  %at.22 = getelementptr i64, ptr %numbers, i64 22
  %number.22 = load ptr, ptr %at.22
  %at.23 = getelementptr i64, ptr %numbers, i64 23
  %number.23 = load i64, ptr %at.23
  %at.24 = getelementptr i64, ptr %numbers, i64 24
  %number.24 = load i64, ptr %at.24
  %at.25 = getelementptr i64, ptr %numbers, i64 25
  %number.25 = load ptr, ptr %at.25
  %at.26 = getelementptr i64, ptr %numbers, i64 26
  %number.26 = load i64, ptr %at.26
  %at.27 = getelementptr i64, ptr %numbers, i64 27
  %number.27 = load i64, ptr %at.27
  %at.28 = getelementptr i64, ptr %numbers, i64 28
  %number.28 = load i64, ptr %at.28
  %at.29 = getelementptr i64, ptr %numbers, i64 29
  %number.29 = load i64, ptr %at.29
  %at.30 = getelementptr i64, ptr %numbers, i64 30
  %number.30 = load ptr, ptr %at.30
  %at.31 = getelementptr i64, ptr %numbers, i64 31
  %number.31 = load ptr, ptr %at.31
  %at.32 = getelementptr i64, ptr %numbers, i64 32
  %number.32 = load i64, ptr %at.32
  %at.33 = getelementptr i64, ptr %numbers, i64 33
  %number.33 = load i64, ptr %at.33
  %at.34 = getelementptr i64, ptr %numbers, i64 34
  %number.34 = load ptr, ptr %at.34
  %at.35 = getelementptr i64, ptr %numbers, i64 35
  %number.35 = load i64, ptr %at.35
  %at.36 = getelementptr i64, ptr %numbers, i64 36
  %number.36 = load i64, ptr %at.36
  %at.37 = getelementptr i64, ptr %numbers, i64 37
  %number.37 = load i64, ptr %at.37
  %at.38 = getelementptr i64, ptr %numbers, i64 38
  %number.38 = load i64, ptr %at.38
  %at.39 = getelementptr i64, ptr %numbers, i64 39
  %number.39 = load ptr, ptr %at.39
  %at.40 = getelementptr i64, ptr %numbers, i64 40
  %number.40 = load ptr, ptr %at.40
  %at.41 = getelementptr i64, ptr %numbers, i64 41
  %number.41 = load i64, ptr %at.41
  %at.42 = getelementptr i64, ptr %numbers, i64 42
  %number.42 = load i64, ptr %at.42
  %at.43 = getelementptr i64, ptr %numbers, i64 43
  %number.43 = load ptr, ptr %at.43
  %at.44 = getelementptr i64, ptr %numbers, i64 44
  %number.44 = load i64, ptr %at.44
  %at.45 = getelementptr i64, ptr %numbers, i64 45
  %number.45 = load i64, ptr %at.45
  %at.46 = getelementptr i64, ptr %numbers, i64 46
  %number.46 = load ptr, ptr %at.46
  %at.47 = getelementptr i64, ptr %numbers, i64 47
  %number.47 = load ptr, ptr %at.47
  %at.48 = getelementptr i64, ptr %numbers, i64 48
  %number.48 = load i64, ptr %at.48
  %at.49 = getelementptr i64, ptr %numbers, i64 49
  %number.49 = load i64, ptr %at.49
  %at.50 = getelementptr i64, ptr %numbers, i64 50
  %number.50 = load ptr, ptr %at.50
  %at.51 = getelementptr i64, ptr %numbers, i64 51
  %number.51 = load i64, ptr %at.51
  %at.52 = getelementptr i64, ptr %numbers, i64 52
  %number.52 = load i64, ptr %at.52
  %at.53 = getelementptr i64, ptr %numbers, i64 53
  %number.53 = load ptr, ptr %at.53
  %at.54 = getelementptr i64, ptr %numbers, i64 54
  %number.54 = load ptr, ptr %at.54
  %at.55 = getelementptr i64, ptr %numbers, i64 55
  %number.55 = load i64, ptr %at.55
  %at.56 = getelementptr i64, ptr %numbers, i64 56
  %number.56 = load i64, ptr %at.56
  %at.57 = getelementptr i64, ptr %numbers, i64 57
  %number.57 = load ptr, ptr %at.57
  %at.58 = getelementptr i64, ptr %numbers, i64 58
  %number.58 = load i64, ptr %at.58
  %at.59 = getelementptr i64, ptr %numbers, i64 59
  %number.59 = load i64, ptr %at.59
  %at.60 = getelementptr i64, ptr %numbers, i64 60
  %number.60 = load ptr, ptr %at.60
  %at.61 = getelementptr i64, ptr %numbers, i64 61
  %number.61 = load ptr, ptr %at.61
  %at.62 = getelementptr i64, ptr %numbers, i64 62
  %number.62 = load i64, ptr %at.62
  %at.63 = getelementptr i64, ptr %numbers, i64 63
  %number.63 = load i64, ptr %at.63
  %at.64 = getelementptr i64, ptr %numbers, i64 64
  %number.64 = load ptr, ptr %at.64
  %at.65 = getelementptr i64, ptr %numbers, i64 65
  %number.65 = load i64, ptr %at.65
  %at.66 = getelementptr i64, ptr %numbers, i64 66
  %number.66 = load i64, ptr %at.66
  %at.67 = getelementptr i64, ptr %numbers, i64 67
  %number.67 = load ptr, ptr %at.67
  %at.68 = getelementptr i64, ptr %numbers, i64 68
  %number.68 = load ptr, ptr %at.68
  %at.69 = getelementptr i64, ptr %numbers, i64 69
  %number.69 = load i64, ptr %at.69
  %at.70 = getelementptr i64, ptr %numbers, i64 70
  %number.70 = load i64, ptr %at.70
  %at.71 = getelementptr i64, ptr %numbers, i64 71
  %number.71 = load ptr, ptr %at.71
  %at.72 = getelementptr i64, ptr %numbers, i64 72
  %number.72 = load i64, ptr %at.72
  %at.73 = getelementptr i64, ptr %numbers, i64 73
  %number.73 = load i64, ptr %at.73
  %at.74 = getelementptr i64, ptr %numbers, i64 74
  %number.74 = load i64, ptr %at.74
  %at.75 = getelementptr i64, ptr %numbers, i64 75
  %number.75 = load i64, ptr %at.75
  %at.76 = getelementptr i64, ptr %numbers, i64 76
  %number.76 = load ptr, ptr %at.76
  %at.77 = getelementptr i64, ptr %numbers, i64 77
  %number.77 = load ptr, ptr %at.77
  %at.78 = getelementptr i64, ptr %numbers, i64 78
  %number.78 = load i64, ptr %at.78
  %at.79 = getelementptr i64, ptr %numbers, i64 79
  %number.79 = load i64, ptr %at.79
  %at.80 = getelementptr i64, ptr %numbers, i64 80
  %number.80 = load ptr, ptr %at.80
  %at.81 = getelementptr i64, ptr %numbers, i64 81
  %number.81 = load i64, ptr %at.81
  %at.82 = getelementptr i64, ptr %numbers, i64 82
  %number.82 = load i64, ptr %at.82
  %at.83 = getelementptr i64, ptr %numbers, i64 83
  %number.83 = load ptr, ptr %at.83
  %at.84 = getelementptr i64, ptr %numbers, i64 84
  %number.84 = load ptr, ptr %at.84
  %at.85 = getelementptr i64, ptr %numbers, i64 85
  %number.85 = load i64, ptr %at.85
  %at.86 = getelementptr i64, ptr %numbers, i64 86
  %number.86 = load i64, ptr %at.86
  %at.87 = getelementptr i64, ptr %numbers, i64 87
  %number.87 = load ptr, ptr %at.87
  %at.88 = getelementptr i64, ptr %numbers, i64 88
  %number.88 = load i64, ptr %at.88
  %at.89 = getelementptr i64, ptr %numbers, i64 89
  %number.89 = load i64, ptr %at.89
  %at.90 = getelementptr i64, ptr %numbers, i64 90
  %number.90 = load ptr, ptr %at.90
  %at.91 = getelementptr i64, ptr %numbers, i64 91
  %number.91 = load ptr, ptr %at.91
  %at.92 = getelementptr i64, ptr %numbers, i64 92
  %number.92 = load i64, ptr %at.92
  %at.93 = getelementptr i64, ptr %numbers, i64 93
  %number.93 = load i64, ptr %at.93
  %at.94 = getelementptr i64, ptr %numbers, i64 94
  %number.94 = load ptr, ptr %at.94
  %at.95 = getelementptr i64, ptr %numbers, i64 95
  %number.95 = load i64, ptr %at.95
  %at.96 = getelementptr i64, ptr %numbers, i64 96
  %number.96 = load i64, ptr %at.96
  %at.97 = getelementptr i64, ptr %numbers, i64 97
  %number.97 = load i64, ptr %at.97
  %at.98 = getelementptr i64, ptr %numbers, i64 98
  %number.98 = load i64, ptr %at.98
  %at.99 = getelementptr i64, ptr %numbers, i64 99
  %number.99 = load i64, ptr %at.99
  %at.100 = getelementptr i64, ptr %numbers, i64 100
  %number.100 = load i64, ptr %at.100
  %at.101 = getelementptr i64, ptr %numbers, i64 101
  %number.101 = load ptr, ptr %at.101
  %at.102 = getelementptr i64, ptr %numbers, i64 102
  %number.102 = load ptr, ptr %at.102
  %at.103 = getelementptr i64, ptr %numbers, i64 103
  %number.103 = load i64, ptr %at.103
  %at.104 = getelementptr i64, ptr %numbers, i64 104
  %number.104 = load i64, ptr %at.104
  %at.105 = getelementptr i64, ptr %numbers, i64 105
  %number.105 = load ptr, ptr %at.105
  %at.106 = getelementptr i64, ptr %numbers, i64 106
  %number.106 = load i64, ptr %at.106
  %at.107 = getelementptr i64, ptr %numbers, i64 107
  %number.107 = load i64, ptr %at.107
  %at.108 = getelementptr i64, ptr %numbers, i64 108
  %number.108 = load ptr, ptr %at.108
  %at.109 = getelementptr i64, ptr %numbers, i64 109
  %number.109 = load ptr, ptr %at.109
  %at.110 = getelementptr i64, ptr %numbers, i64 110
  %number.110 = load i64, ptr %at.110
  %at.111 = getelementptr i64, ptr %numbers, i64 111
  %number.111 = load i64, ptr %at.111
  %at.112 = getelementptr i64, ptr %numbers, i64 112
  %number.112 = load ptr, ptr %at.112
  %at.113 = getelementptr i64, ptr %numbers, i64 113
  %number.113 = load i64, ptr %at.113
  %at.114 = getelementptr i64, ptr %numbers, i64 114
  %number.114 = load i64, ptr %at.114
  %at.115 = getelementptr i64, ptr %numbers, i64 115
  %number.115 = load ptr, ptr %at.115
  %at.116 = getelementptr i64, ptr %numbers, i64 116
  %number.116 = load ptr, ptr %at.116
  %at.117 = getelementptr i64, ptr %numbers, i64 117
  %number.117 = load i64, ptr %at.117
  %at.118 = getelementptr i64, ptr %numbers, i64 118
  %number.118 = load i64, ptr %at.118
  %at.119 = getelementptr i64, ptr %numbers, i64 119
  %number.119 = load ptr, ptr %at.119
  %at.120 = getelementptr i64, ptr %numbers, i64 120
  %number.120 = load i64, ptr %at.120
  %at.121 = getelementptr i64, ptr %numbers, i64 121
  %number.121 = load i64, ptr %at.121
  %at.122 = getelementptr i64, ptr %numbers, i64 122
  %number.122 = load i64, ptr %at.122
  %at.123 = getelementptr i64, ptr %numbers, i64 123
  %number.123 = load i64, ptr %at.123
  %at.124 = getelementptr i64, ptr %numbers, i64 124
  %number.124 = load ptr, ptr %at.124
  %at.125 = getelementptr i64, ptr %numbers, i64 125
  %number.125 = load ptr, ptr %at.125
  %at.126 = getelementptr i64, ptr %numbers, i64 126
  %number.126 = load i64, ptr %at.126
  %at.127 = getelementptr i64, ptr %numbers, i64 127
  %number.127 = load i64, ptr %at.127
  %at.128 = getelementptr i64, ptr %numbers, i64 128
  %number.128 = load ptr, ptr %at.128
  %at.129 = getelementptr i64, ptr %numbers, i64 129
  %number.129 = load i64, ptr %at.129
  %at.130 = getelementptr i64, ptr %numbers, i64 130
  %number.130 = load i64, ptr %at.130
  %at.131 = getelementptr i64, ptr %numbers, i64 131
  %number.131 = load i64, ptr %at.131
  %at.132 = getelementptr i64, ptr %numbers, i64 132
  %number.132 = load i64, ptr %at.132
  %at.133 = getelementptr i64, ptr %numbers, i64 133
  %number.133 = load ptr, ptr %at.133
  %at.134 = getelementptr i64, ptr %numbers, i64 134
  %number.134 = load ptr, ptr %at.134
  %at.135 = getelementptr i64, ptr %numbers, i64 135
  %number.135 = load i64, ptr %at.135
  %at.136 = getelementptr i64, ptr %numbers, i64 136
  %number.136 = load i64, ptr %at.136
  %at.137 = getelementptr i64, ptr %numbers, i64 137
  %number.137 = load ptr, ptr %at.137
  %at.138 = getelementptr i64, ptr %numbers, i64 138
  %number.138 = load i64, ptr %at.138
  %at.139 = getelementptr i64, ptr %numbers, i64 139
  %number.139 = load i64, ptr %at.139
  %at.140 = getelementptr i64, ptr %numbers, i64 140
  %number.140 = load i64, ptr %at.140
  %at.141 = getelementptr i64, ptr %numbers, i64 141
  %number.141 = load i64, ptr %at.141
  %at.142 = getelementptr i64, ptr %numbers, i64 142
  %number.142 = load ptr, ptr %at.142
  %at.143 = getelementptr i64, ptr %numbers, i64 143
  %number.143 = load ptr, ptr %at.143
  %at.144 = getelementptr i64, ptr %numbers, i64 144
  %number.144 = load i64, ptr %at.144
  %at.145 = getelementptr i64, ptr %numbers, i64 145
  %number.145 = load i64, ptr %at.145
  %at.146 = getelementptr i64, ptr %numbers, i64 146
  %number.146 = load ptr, ptr %at.146
  %at.147 = getelementptr i64, ptr %numbers, i64 147
  %number.147 = load i64, ptr %at.147
  %at.148 = getelementptr i64, ptr %numbers, i64 148
  %number.148 = load i64, ptr %at.148
  %at.149 = getelementptr i64, ptr %numbers, i64 149
  %number.149 = load ptr, ptr %at.149
  %at.150 = getelementptr i64, ptr %numbers, i64 150
  %number.150 = load ptr, ptr %at.150
  %at.151 = getelementptr i64, ptr %numbers, i64 151
  %number.151 = load i64, ptr %at.151
  %at.152 = getelementptr i64, ptr %numbers, i64 152
  %number.152 = load i64, ptr %at.152
  %at.153 = getelementptr i64, ptr %numbers, i64 153
  %number.153 = load ptr, ptr %at.153
  %at.154 = getelementptr i64, ptr %numbers, i64 154
  %number.154 = load i64, ptr %at.154
  %at.155 = getelementptr i64, ptr %numbers, i64 155
  %number.155 = load i64, ptr %at.155
  %at.156 = getelementptr i64, ptr %numbers, i64 156
  %number.156 = load ptr, ptr %at.156
  %at.157 = getelementptr i64, ptr %numbers, i64 157
  %number.157 = load ptr, ptr %at.157
  %at.158 = getelementptr i64, ptr %numbers, i64 158
  %number.158 = load i64, ptr %at.158
  %at.159 = getelementptr i64, ptr %numbers, i64 159
  %number.159 = load i64, ptr %at.159
  %at.160 = getelementptr i64, ptr %numbers, i64 160
  %number.160 = load ptr, ptr %at.160
  %at.161 = getelementptr i64, ptr %numbers, i64 161
  %number.161 = load i64, ptr %at.161
  %at.162 = getelementptr i64, ptr %numbers, i64 162
  %number.162 = load i64, ptr %at.162
  %at.163 = getelementptr i64, ptr %numbers, i64 163
  %number.163 = load ptr, ptr %at.163
  %at.164 = getelementptr i64, ptr %numbers, i64 164
  %number.164 = load ptr, ptr %at.164
  %at.165 = getelementptr i64, ptr %numbers, i64 165
  %number.165 = load i64, ptr %at.165
  %at.166 = getelementptr i64, ptr %numbers, i64 166
  %number.166 = load i64, ptr %at.166
  %at.167 = getelementptr i64, ptr %numbers, i64 167
  %number.167 = load ptr, ptr %at.167
  %at.168 = getelementptr i64, ptr %numbers, i64 168
  %number.168 = load i64, ptr %at.168
  %at.169 = getelementptr i64, ptr %numbers, i64 169
  %number.169 = load i64, ptr %at.169
  %at.170 = getelementptr i64, ptr %numbers, i64 170
  %number.170 = load ptr, ptr %at.170
  %at.171 = getelementptr i64, ptr %numbers, i64 171
  %number.171 = load ptr, ptr %at.171
  %at.172 = getelementptr i64, ptr %numbers, i64 172
  %number.172 = load i64, ptr %at.172
  %at.173 = getelementptr i64, ptr %numbers, i64 173
  %number.173 = load i64, ptr %at.173
  %at.174 = getelementptr i64, ptr %numbers, i64 174
  %number.174 = load ptr, ptr %at.174
  %at.175 = getelementptr i64, ptr %numbers, i64 175
  %number.175 = load i64, ptr %at.175
  %at.176 = getelementptr i64, ptr %numbers, i64 176
  %number.176 = load i64, ptr %at.176
  %at.177 = getelementptr i64, ptr %numbers, i64 177
  %number.177 = load ptr, ptr %at.177
  %at.178 = getelementptr i64, ptr %numbers, i64 178
  %number.178 = load ptr, ptr %at.178
  %at.179 = getelementptr i64, ptr %numbers, i64 179
  %number.179 = load i64, ptr %at.179
  %at.180 = getelementptr i64, ptr %numbers, i64 180
  %number.180 = load i64, ptr %at.180
  %at.181 = getelementptr i64, ptr %numbers, i64 181
  %number.181 = load ptr, ptr %at.181
  %at.182 = getelementptr i64, ptr %numbers, i64 182
  %number.182 = load i64, ptr %at.182
  %at.183 = getelementptr i64, ptr %numbers, i64 183
  %number.183 = load i64, ptr %at.183
  %at.184 = getelementptr i64, ptr %numbers, i64 184
  %number.184 = load ptr, ptr %at.184
  %at.185 = getelementptr i64, ptr %numbers, i64 185
  %number.185 = load ptr, ptr %at.185
  %at.186 = getelementptr i64, ptr %numbers, i64 186
  %number.186 = load i64, ptr %at.186
  %at.187 = getelementptr i64, ptr %numbers, i64 187
  %number.187 = load i64, ptr %at.187
  %at.188 = getelementptr i64, ptr %numbers, i64 188
  %number.188 = load ptr, ptr %at.188
  %at.189 = getelementptr i64, ptr %numbers, i64 189
  %number.189 = load i64, ptr %at.189
  %at.190 = getelementptr i64, ptr %numbers, i64 190
  %number.190 = load i64, ptr %at.190
  %at.191 = getelementptr i64, ptr %numbers, i64 191
  %number.191 = load ptr, ptr %at.191
  %at.192 = getelementptr i64, ptr %numbers, i64 192
  %number.192 = load ptr, ptr %at.192
  %at.193 = getelementptr i64, ptr %numbers, i64 193
  %number.193 = load i64, ptr %at.193
  %at.194 = getelementptr i64, ptr %numbers, i64 194
  %number.194 = load i64, ptr %at.194
  %at.195 = getelementptr i64, ptr %numbers, i64 195
  %number.195 = load ptr, ptr %at.195
  %at.196 = getelementptr i64, ptr %numbers, i64 196
  %number.196 = load i64, ptr %at.196
  %at.197 = getelementptr i64, ptr %numbers, i64 197
  %number.197 = load i64, ptr %at.197
  %at.198 = getelementptr i64, ptr %numbers, i64 198
  %number.198 = load ptr, ptr %at.198
  %at.199 = getelementptr i64, ptr %numbers, i64 199
  %number.199 = load ptr, ptr %at.199
  %at.200 = getelementptr i64, ptr %numbers, i64 200
  %number.200 = load i64, ptr %at.200
  %at.201 = getelementptr i64, ptr %numbers, i64 201
  %number.201 = load i64, ptr %at.201
  %at.202 = getelementptr i64, ptr %numbers, i64 202
  %number.202 = load ptr, ptr %at.202
  %at.203 = getelementptr i64, ptr %numbers, i64 203
  %number.203 = load i64, ptr %at.203
  %at.204 = getelementptr i64, ptr %numbers, i64 204
  %number.204 = load i64, ptr %at.204
  %at.205 = getelementptr i64, ptr %numbers, i64 205
  %number.205 = load i64, ptr %at.205
  %at.206 = getelementptr i64, ptr %numbers, i64 206
  %number.206 = load i64, ptr %at.206
  %at.207 = getelementptr i64, ptr %numbers, i64 207
  %number.207 = load i64, ptr %at.207
  %at.208 = getelementptr i64, ptr %numbers, i64 208
  %number.208 = load ptr, ptr %at.208
  %at.209 = getelementptr i64, ptr %numbers, i64 209
  %number.209 = load ptr, ptr %at.209
  %at.210 = getelementptr i64, ptr %numbers, i64 210
  %number.210 = load i64, ptr %at.210
  %at.211 = getelementptr i64, ptr %numbers, i64 211
  %number.211 = load i64, ptr %at.211
  %at.212 = getelementptr i64, ptr %numbers, i64 212
  %number.212 = load ptr, ptr %at.212
  %at.213 = getelementptr i64, ptr %numbers, i64 213
  %number.213 = load i64, ptr %at.213
  %at.214 = getelementptr i64, ptr %numbers, i64 214
  %number.214 = load i64, ptr %at.214
  %at.215 = getelementptr i64, ptr %numbers, i64 215
  %number.215 = load ptr, ptr %at.215
  %at.216 = getelementptr i64, ptr %numbers, i64 216
  %number.216 = load ptr, ptr %at.216
  %at.217 = getelementptr i64, ptr %numbers, i64 217
  %number.217 = load i64, ptr %at.217
  %at.218 = getelementptr i64, ptr %numbers, i64 218
  %number.218 = load i64, ptr %at.218
  %at.219 = getelementptr i64, ptr %numbers, i64 219
  %number.219 = load ptr, ptr %at.219
  %at.220 = getelementptr i64, ptr %numbers, i64 220
  %number.220 = load i64, ptr %at.220
  %at.221 = getelementptr i64, ptr %numbers, i64 221
  %number.221 = load i64, ptr %at.221
  %at.222 = getelementptr i64, ptr %numbers, i64 222
  %number.222 = load ptr, ptr %at.222
  %at.223 = getelementptr i64, ptr %numbers, i64 223
  %number.223 = load ptr, ptr %at.223
  %at.224 = getelementptr i64, ptr %numbers, i64 224
  %number.224 = load i64, ptr %at.224
  %at.225 = getelementptr i64, ptr %numbers, i64 225
  %number.225 = load i64, ptr %at.225
  %at.226 = getelementptr i64, ptr %numbers, i64 226
  %number.226 = load ptr, ptr %at.226
  %at.227 = getelementptr i64, ptr %numbers, i64 227
  %number.227 = load i64, ptr %at.227
  %at.228 = getelementptr i64, ptr %numbers, i64 228
  %number.228 = load i64, ptr %at.228
  %at.229 = getelementptr i64, ptr %numbers, i64 229
  %number.229 = load ptr, ptr %at.229
  %at.230 = getelementptr i64, ptr %numbers, i64 230
  %number.230 = load ptr, ptr %at.230
  %at.231 = getelementptr i64, ptr %numbers, i64 231
  %number.231 = load i64, ptr %at.231
  %at.232 = getelementptr i64, ptr %numbers, i64 232
  %number.232 = load i64, ptr %at.232
  %at.233 = getelementptr i64, ptr %numbers, i64 233
  %number.233 = load ptr, ptr %at.233
  %at.234 = getelementptr i64, ptr %numbers, i64 234
  %number.234 = load i64, ptr %at.234
  %at.235 = getelementptr i64, ptr %numbers, i64 235
  %number.235 = load i64, ptr %at.235
  %at.236 = getelementptr i64, ptr %numbers, i64 236
  %number.236 = load ptr, ptr %at.236
  %at.237 = getelementptr i64, ptr %numbers, i64 237
  %number.237 = load ptr, ptr %at.237
  %at.238 = getelementptr i64, ptr %numbers, i64 238
  %number.238 = load i64, ptr %at.238
  %at.239 = getelementptr i64, ptr %numbers, i64 239
  %number.239 = load i64, ptr %at.239
  %at.240 = getelementptr i64, ptr %numbers, i64 240
  %number.240 = load ptr, ptr %at.240
  %at.241 = getelementptr i64, ptr %numbers, i64 241
  %number.241 = load i64, ptr %at.241
  %at.242 = getelementptr i64, ptr %numbers, i64 242
  %number.242 = load i64, ptr %at.242
  %at.243 = getelementptr i64, ptr %numbers, i64 243
  %number.243 = load ptr, ptr %at.243
  %at.244 = getelementptr i64, ptr %numbers, i64 244
  %number.244 = load ptr, ptr %at.244
  %at.245 = getelementptr i64, ptr %numbers, i64 245
  %number.245 = load i64, ptr %at.245
  %at.246 = getelementptr i64, ptr %numbers, i64 246
  %number.246 = load i64, ptr %at.246
  %at.247 = getelementptr i64, ptr %numbers, i64 247
  %number.247 = load ptr, ptr %at.247
  %at.248 = getelementptr i64, ptr %numbers, i64 248
  %number.248 = load i64, ptr %at.248
  %at.249 = getelementptr i64, ptr %numbers, i64 249
  %number.249 = load i64, ptr %at.249
  %at.250 = getelementptr i64, ptr %numbers, i64 250
  %number.250 = load i64, ptr %at.250
  %at.251 = getelementptr i64, ptr %numbers, i64 251
  %number.251 = load i64, ptr %at.251
  %status = call i32 @advance_of_many(ptr %result, ptr %error, ptr %number.0, ptr %number.1, i64 %number.2, i64 %number.3, ptr %number.4, i64 %number.5, i64 %number.6, i64 %number.7, i64 %number.8, i64 %number.9, i64 %number.10, i64 %number.11, i64 %number.12, i64 %number.13, ptr %number.14, ptr %number.15, i64 %number.16, i64 %number.17, ptr %number.18, i64 %number.19, i64 %number.20, ptr %number.21, ptr %number.22, i64 %number.23, i64 %number.24, ptr %number.25, i64 %number.26, i64 %number.27, i64 %number.28, i64 %number.29, ptr %number.30, ptr %number.31, i64 %number.32, i64 %number.33, ptr %number.34, i64 %number.35, i64 %number.36, i64 %number.37, i64 %number.38, ptr %number.39, ptr %number.40, i64 %number.41, i64 %number.42, ptr %number.43, i64 %number.44, i64 %number.45, ptr %number.46, ptr %number.47, i64 %number.48, i64 %number.49, ptr %number.50, i64 %number.51, i64 %number.52, ptr %number.53, ptr %number.54, i64 %number.55, i64 %number.56, ptr %number.57, i64 %number.58, i64 %number.59, ptr %number.60, ptr %number.61, i64 %number.62, i64 %number.63, ptr %number.64, i64 %number.65, i64 %number.66, ptr %number.67, ptr %number.68, i64 %number.69, i64 %number.70, ptr %number.71, i64 %number.72, i64 %number.73, i64 %number.74, i64 %number.75, ptr %number.76, ptr %number.77, i64 %number.78, i64 %number.79, ptr %number.80, i64 %number.81, i64 %number.82, ptr %number.83, ptr %number.84, i64 %number.85, i64 %number.86, ptr %number.87, i64 %number.88, i64 %number.89, ptr %number.90, ptr %number.91, i64 %number.92, i64 %number.93, ptr %number.94, i64 %number.95, i64 %number.96, i64 %number.97, i64 %number.98, i64 %number.99, i64 %number.100, ptr %number.101, ptr %number.102, i64 %number.103, i64 %number.104, ptr %number.105, i64 %number.106, i64 %number.107, ptr %number.108, ptr %number.109, i64 %number.110, i64 %number.111, ptr %number.112, i64 %number.113, i64 %number.114, ptr %number.115, ptr %number.116, i64 %number.117, i64 %number.118, ptr %number.119, i64 %number.120, i64 %number.121, i64 %number.122, i64 %number.123, ptr %number.124, ptr %number.125, i64 %number.126, i64 %number.127, ptr %number.128, i64 %number.129, i64 %number.130, i64 %number.131, i64 %number.132, ptr %number.133, ptr %number.134, i64 %number.135, i64 %number.136, ptr %number.137, i64 %number.138, i64 %number.139, i64 %number.140, i64 %number.141, ptr %number.142, ptr %number.143, i64 %number.144, i64 %number.145, ptr %number.146, i64 %number.147, i64 %number.148, ptr %number.149, ptr %number.150, i64 %number.151, i64 %number.152, ptr %number.153, i64 %number.154, i64 %number.155, ptr %number.156, ptr %number.157, i64 %number.158, i64 %number.159, ptr %number.160, i64 %number.161, i64 %number.162, ptr %number.163, ptr %number.164, i64 %number.165, i64 %number.166, ptr %number.167, i64 %number.168, i64 %number.169, ptr %number.170, ptr %number.171, i64 %number.172, i64 %number.173, ptr %number.174, i64 %number.175, i64 %number.176, ptr %number.177, ptr %number.178, i64 %number.179, i64 %number.180, ptr %number.181, i64 %number.182, i64 %number.183, ptr %number.184, ptr %number.185, i64 %number.186, i64 %number.187, ptr %number.188, i64 %number.189, i64 %number.190, ptr %number.191, ptr %number.192, i64 %number.193, i64 %number.194, ptr %number.195, i64 %number.196, i64 %number.197, ptr %number.198, ptr %number.199, i64 %number.200, i64 %number.201, ptr %number.202, i64 %number.203, i64 %number.204, i64 %number.205, i64 %number.206, i64 %number.207, ptr %number.208, ptr %number.209, i64 %number.210, i64 %number.211, ptr %number.212, i64 %number.213, i64 %number.214, ptr %number.215, ptr %number.216, i64 %number.217, i64 %number.218, ptr %number.219, i64 %number.220, i64 %number.221, ptr %number.222, ptr %number.223, i64 %number.224, i64 %number.225, ptr %number.226, i64 %number.227, i64 %number.228, ptr %number.229, ptr %number.230, i64 %number.231, i64 %number.232, ptr %number.233, i64 %number.234, i64 %number.235, ptr %number.236, ptr %number.237, i64 %number.238, i64 %number.239, ptr %number.240, i64 %number.241, i64 %number.242, ptr %number.243, ptr %number.244, i64 %number.245, i64 %number.246, ptr %number.247, i64 %number.248, i64 %number.249, i64 %number.250, i64 %number.251)
  %value = load i64, ptr %result
  ret i64 %value
}

define i64 @evaluate(ptr %numbers) {
  %result = alloca i64
  %error = alloca ptr
  %at.0 = getelementptr i64, ptr %numbers, i64 0
  %number.0 = load ptr, ptr %at.0
  %at.1 = getelementptr i64, ptr %numbers, i64 1
  %number.1 = load ptr, ptr %at.1
  %at.2 = getelementptr i64, ptr %numbers, i64 2
  %number.2 = load i64, ptr %at.2
  %at.3 = getelementptr i64, ptr %numbers, i64 3
  %number.3 = load i64, ptr %at.3
  %at.4 = getelementptr i64, ptr %numbers, i64 4
  %number.4 = load ptr, ptr %at.4
  %at.5 = getelementptr i64, ptr %numbers, i64 5
  %number.5 = load i64, ptr %at.5
  %at.6 = getelementptr i64, ptr %numbers, i64 6
  %number.6 = load i64, ptr %at.6
  %at.7 = getelementptr i64, ptr %numbers, i64 7
  %number.7 = load i64, ptr %at.7
  %at.8 = getelementptr i64, ptr %numbers, i64 8
  %number.8 = load i64, ptr %at.8
  %at.9 = getelementptr i64, ptr %numbers, i64 9
  %number.9 = load i64, ptr %at.9
  %at.10 = getelementptr i64, ptr %numbers, i64 10
  %number.10 = load i64, ptr %at.10
  %at.11 = getelementptr i64, ptr %numbers, i64 11
  %number.11 = load ptr, ptr %at.11
  %at.12 = getelementptr i64, ptr %numbers, i64 12
  %number.12 = load ptr, ptr %at.12
  %at.13 = getelementptr i64, ptr %numbers, i64 13
  %number.13 = load i64, ptr %at.13
  %at.14 = getelementptr i64, ptr %numbers, i64 14
  %number.14 = load i64, ptr %at.14
  %at.15 = getelementptr i64, ptr %numbers, i64 15
  %number.15 = load ptr, ptr %at.15
  %at.16 = getelementptr i64, ptr %numbers, i64 16
  %number.16 = load i64, ptr %at.16
  %at.17 = getelementptr i64, ptr %numbers, i64 17
  %number.17 = load i64, ptr %at.17
  %at.18 = getelementptr i64, ptr %numbers, i64 18
  %number.18 = load ptr, ptr %at.18
  %at.19 = getelementptr i64, ptr %numbers, i64 19
  %number.19 = load ptr, ptr %at.19
  %at.20 = getelementptr i64, ptr %numbers, i64 20
  %number.20 = load i64, ptr %at.20
  %at.21 = getelementptr i64, ptr %numbers, i64 21
  %number.21 = load i64, ptr %at.21
  %at.22 = getelementptr i64, ptr %numbers, i64 22
  %number.22 = load ptr, ptr %at.22
  %at.23 = getelementptr i64, ptr %numbers, i64 23
  %number.23 = load i64, ptr %at.23
  %at.24 = getelementptr i64, ptr %numbers, i64 24
  %number.24 = load i64, ptr %at.24
  %at.25 = getelementptr i64, ptr %numbers, i64 25
  %number.25 = load ptr, ptr %at.25
  %at.26 = getelementptr i64, ptr %numbers, i64 26
  %number.26 = load ptr, ptr %at.26
  %at.27 = getelementptr i64, ptr %numbers, i64 27
  %number.27 = load i64, ptr %at.27
  %at.28 = getelementptr i64, ptr %numbers, i64 28
  %number.28 = load i64, ptr %at.28
  %at.29 = getelementptr i64, ptr %numbers, i64 29
  %number.29 = load ptr, ptr %at.29
  %at.30 = getelementptr i64, ptr %numbers, i64 30
  %number.30 = load i64, ptr %at.30
  %at.31 = getelementptr i64, ptr %numbers, i64 31
  %number.31 = load i64, ptr %at.31
  %at.32 = getelementptr i64, ptr %numbers, i64 32
  %number.32 = load ptr, ptr %at.32
  %at.33 = getelementptr i64, ptr %numbers, i64 33
  %number.33 = load ptr, ptr %at.33
  %at.34 = getelementptr i64, ptr %numbers, i64 34
  %number.34 = load i64, ptr %at.34
  %at.35 = getelementptr i64, ptr %numbers, i64 35
  %number.35 = load i64, ptr %at.35
  %at.36 = getelementptr i64, ptr %numbers, i64 36
  %number.36 = load ptr, ptr %at.36
  %at.37 = getelementptr i64, ptr %numbers, i64 37
  %number.37 = load i64, ptr %at.37
  %at.38 = getelementptr i64, ptr %numbers, i64 38
  %number.38 = load i64, ptr %at.38
  %at.39 = getelementptr i64, ptr %numbers, i64 39
  %number.39 = load ptr, ptr %at.39
  %at.40 = getelementptr i64, ptr %numbers, i64 40
  %number.40 = load ptr, ptr %at.40
  %at.41 = getelementptr i64, ptr %numbers, i64 41
  %number.41 = load i64, ptr %at.41
  %at.42 = getelementptr i64, ptr %numbers, i64 42
  %number.42 = load i64, ptr %at.42
  %at.43 = getelementptr i64, ptr %numbers, i64 43
  %number.43 = load ptr, ptr %at.43
  %at.44 = getelementptr i64, ptr %numbers, i64 44
  %number.44 = load i64, ptr %at.44
  %at.45 = getelementptr i64, ptr %numbers, i64 45
  %number.45 = load i64, ptr %at.45
  %at.46 = getelementptr i64, ptr %numbers, i64 46
  %number.46 = load ptr, ptr %at.46
  %at.47 = getelementptr i64, ptr %numbers, i64 47
  %number.47 = load ptr, ptr %at.47
  %at.48 = getelementptr i64, ptr %numbers, i64 48
  %number.48 = load i64, ptr %at.48
  %at.49 = getelementptr i64, ptr %numbers, i64 49
  %number.49 = load i64, ptr %at.49
  %at.50 = getelementptr i64, ptr %numbers, i64 50
  %number.50 = load ptr, ptr %at.50
  %at.51 = getelementptr i64, ptr %numbers, i64 51
  %number.51 = load i64, ptr %at.51
  %at.52 = getelementptr i64, ptr %numbers, i64 52
  %number.52 = load i64, ptr %at.52
  %at.53 = getelementptr i64, ptr %numbers, i64 53
  %number.53 = load i64, ptr %at.53
  %at.54 = getelementptr i64, ptr %numbers, i64 54
  %number.54 = load i64, ptr %at.54
  %at.55 = getelementptr i64, ptr %numbers, i64 55
  %number.55 = load ptr, ptr %at.55
  %at.56 = getelementptr i64, ptr %numbers, i64 56
  %number.56 = load ptr, ptr %at.56
  %at.57 = getelementptr i64, ptr %numbers, i64 57
  %number.57 = load i64, ptr %at.57
  %at.58 = getelementptr i64, ptr %numbers, i64 58
  %number.58 = load i64, ptr %at.58
  %at.59 = getelementptr i64, ptr %numbers, i64 59
  %number.59 = load ptr, ptr %at.59
  %at.60 = getelementptr i64, ptr %numbers, i64 60
  %number.60 = load i64, ptr %at.60
  %at.61 = getelementptr i64, ptr %numbers, i64 61
  %number.61 = load i64, ptr %at.61
  %at.62 = getelementptr i64, ptr %numbers, i64 62
  %number.62 = load ptr, ptr %at.62
  %at.63 = getelementptr i64, ptr %numbers, i64 63
  %number.63 = load ptr, ptr %at.63
  %at.64 = getelementptr i64, ptr %numbers, i64 64
  %number.64 = load i64, ptr %at.64
  %at.65 = getelementptr i64, ptr %numbers, i64 65
  %number.65 = load i64, ptr %at.65
  %at.66 = getelementptr i64, ptr %numbers, i64 66
  %number.66 = load ptr, ptr %at.66
  %at.67 = getelementptr i64, ptr %numbers, i64 67
  %number.67 = load i64, ptr %at.67
  %at.68 = getelementptr i64, ptr %numbers, i64 68
  %number.68 = load i64, ptr %at.68
  %at.69 = getelementptr i64, ptr %numbers, i64 69
  %number.69 = load ptr, ptr %at.69
  %at.70 = getelementptr i64, ptr %numbers, i64 70
  %number.70 = load ptr, ptr %at.70
  %at.71 = getelementptr i64, ptr %numbers, i64 71
  %number.71 = load i64, ptr %at.71
  %at.72 = getelementptr i64, ptr %numbers, i64 72
  %number.72 = load i64, ptr %at.72
  %at.73 = getelementptr i64, ptr %numbers, i64 73
  %number.73 = load ptr, ptr %at.73
  %at.74 = getelementptr i64, ptr %numbers, i64 74
  %number.74 = load i64, ptr %at.74
  %at.75 = getelementptr i64, ptr %numbers, i64 75
  %number.75 = load i64, ptr %at.75
  %at.76 = getelementptr i64, ptr %numbers, i64 76
  %number.76 = load ptr, ptr %at.76
  %at.77 = getelementptr i64, ptr %numbers, i64 77
  %number.77 = load ptr, ptr %at.77
  %at.78 = getelementptr i64, ptr %numbers, i64 78
  %number.78 = load i64, ptr %at.78
  %at.79 = getelementptr i64, ptr %numbers, i64 79
  %number.79 = load i64, ptr %at.79
  %at.80 = getelementptr i64, ptr %numbers, i64 80
  %number.80 = load ptr, ptr %at.80
  %at.81 = getelementptr i64, ptr %numbers, i64 81
  %number.81 = load i64, ptr %at.81
  %at.82 = getelementptr i64, ptr %numbers, i64 82
  %number.82 = load i64, ptr %at.82
  %at.83 = getelementptr i64, ptr %numbers, i64 83
  %number.83 = load ptr, ptr %at.83
  %at.84 = getelementptr i64, ptr %numbers, i64 84
  %number.84 = load ptr, ptr %at.84
  %at.85 = getelementptr i64, ptr %numbers, i64 85
  %number.85 = load i64, ptr %at.85
  %at.86 = getelementptr i64, ptr %numbers, i64 86
  %number.86 = load i64, ptr %at.86
  %at.87 = getelementptr i64, ptr %numbers, i64 87
  %number.87 = load ptr, ptr %at.87
  %at.88 = getelementptr i64, ptr %numbers, i64 88
  %number.88 = load i64, ptr %at.88
  %at.89 = getelementptr i64, ptr %numbers, i64 89
  %number.89 = load i64, ptr %at.89
  %at.90 = getelementptr i64, ptr %numbers, i64 90
  %number.90 = load i64, ptr %at.90
  %at.91 = getelementptr i64, ptr %numbers, i64 91
  %number.91 = load i64, ptr %at.91
  %status = call i32 @evaluate_of_many(ptr %result, ptr %error, ptr %number.0, ptr %number.1, i64 %number.2, i64 %number.3, ptr %number.4, i64 %number.5, i64 %number.6, i64 %number.7, i64 %number.8, i64 %number.9, i64 %number.10, ptr %number.11, ptr %number.12, i64 %number.13, i64 %number.14, ptr %number.15, i64 %number.16, i64 %number.17, ptr %number.18, ptr %number.19, i64 %number.20, i64 %number.21, ptr %number.22, i64 %number.23, i64 %number.24, ptr %number.25, ptr %number.26, i64 %number.27, i64 %number.28, ptr %number.29, i64 %number.30, i64 %number.31, ptr %number.32, ptr %number.33, i64 %number.34, i64 %number.35, ptr %number.36, i64 %number.37, i64 %number.38, ptr %number.39, ptr %number.40, i64 %number.41, i64 %number.42, ptr %number.43, i64 %number.44, i64 %number.45, ptr %number.46, ptr %number.47, i64 %number.48, i64 %number.49, ptr %number.50, i64 %number.51, i64 %number.52, i64 %number.53, i64 %number.54, ptr %number.55, ptr %number.56, i64 %number.57, i64 %number.58, ptr %number.59, i64 %number.60, i64 %number.61, ptr %number.62, ptr %number.63, i64 %number.64, i64 %number.65, ptr %number.66, i64 %number.67, i64 %number.68, ptr %number.69, ptr %number.70, i64 %number.71, i64 %number.72, ptr %number.73, i64 %number.74, i64 %number.75, ptr %number.76, ptr %number.77, i64 %number.78, i64 %number.79, ptr %number.80, i64 %number.81, i64 %number.82, ptr %number.83, ptr %number.84, i64 %number.85, i64 %number.86, ptr %number.87, i64 %number.88, i64 %number.89, i64 %number.90, i64 %number.91)
  %value = load i64, ptr %result
  ret i64 %value
}

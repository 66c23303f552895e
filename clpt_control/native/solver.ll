; sha256 c957b2ec0b0c8f850403f38243454b7299271025f7a85bf430d7a490832d9a76

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
  %.689 = icmp slt i64 %arg.shape.0, 1
  %storemerge = select i1 %.689, i64 0, i64 %arg.shape.0
  br i1 %.689, label %B470, label %B330.if.lr.ph

B330.if.lr.ph:                                    ; preds = %entry
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
  br label %B330.if

B372:                                             ; preds = %B330.if
  %.236.i = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !0
  %.293.i10601 = getelementptr double, ptr %0, i64 %.675.010872
  store double 0.000000e+00, ptr %.293.i10601, align 8, !noalias !0
  %.324.i = load i64, ptr %.323.i, align 8, !noalias !0
  %.326.i = icmp eq i64 %.236.i, %.324.i
  br i1 %.326.i, label %B416, label %B132.i

B132.i:                                           ; preds = %B372
  %.359.i10602 = add nsw i64 %.236.i, 1
  store i64 %.359.i10602, ptr %arg.batch.4.2.4, align 8, !noalias !0
  store i64 1, ptr %.418.i, align 8, !noalias !0
  %.438.i = icmp slt i64 %.236.i, 0
  %.439.i = select i1 %.438.i, i64 %arg.batch.0.2.5.0, i64 0
  %8 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i
  %.453.i10603 = getelementptr i64, ptr %8, i64 %.439.i
  %.454.i10604 = load i64, ptr %.453.i10603, align 8, !noalias !0
  %.469.i = icmp slt i64 %.454.i10604, 0
  %.470.i = select i1 %.469.i, i64 %arg.batch.1.0.5.0, i64 0
  %9 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i10604
  %.484.i10605 = getelementptr i64, ptr %9, i64 %.470.i
  %.485.i10606 = load i64, ptr %.484.i10605, align 8, !noalias !0
  %.540.i = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.675.010872
  store i64 %.236.i, ptr %.540.i, align 8, !noalias !0
  %.595.i = getelementptr i64, ptr %1, i64 %.675.010872
  store i64 %.485.i10606, ptr %.595.i, align 8, !noalias !0
  %.654.i = getelementptr i64, ptr %2, i64 %.675.010872
  store i64 1, ptr %.654.i, align 8, !noalias !0
  %.709.i = getelementptr i64, ptr %3, i64 %.675.010872
  store i64 0, ptr %.709.i, align 8, !noalias !0
  br i1 %.8051131.not.i, label %B402.i, label %B358.if.lr.ph.i

B358.if.lr.ph.i:                                  ; preds = %B132.i
  %.867.i = select i1 %.438.i, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i = add i64 %.867.i, %.236.i
  %.888.i = mul i64 %.868.i, %arg.batch.0.1.5.1
  %10 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i
  %invariant.gep11098 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.675.010872
  br label %B358.if.i

B402.i:                                           ; preds = %B358.if.i, %B132.i
  br i1 %.175.i1134.not.i, label %B402.endif.i, label %B76.if.i.lr.ph.i

B76.if.i.lr.ph.i:                                 ; preds = %B402.i
  %.990.i = load i64, ptr %.595.i, align 8, !noalias !0
  %.236.i.i = icmp slt i64 %.990.i, 0
  %.237.i.i10608 = select i1 %.236.i.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i = add i64 %.237.i.i10608, %.990.i
  %.258.i.i = mul i64 %.238.i.i, %arg.batch.1.3.5.1
  %11 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i
  br label %B76.if.i.i10609

B76.if.i.i10609:                                  ; preds = %B76.if.i.i10609, %B76.if.i.lr.ph.i
  %.117.i.01135.i = phi i64 [ 0, %B76.if.i.lr.ph.i ], [ %.188.i.i, %B76.if.i.i10609 ]
  %.188.i.i = add nsw i64 %.117.i.01135.i, 1
  %12 = getelementptr double, ptr %11, i64 %.117.i.01135.i
  %.263.i.i = load double, ptr %12, align 8, !noalias !3
  %13 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i
  %.293.i.i = load i64, ptr %13, align 8, !noalias !3
  %.295.i.i10610 = mul nsw i64 %.293.i.i, %arg.shape.0
  %.297.i.i = add nsw i64 %.295.i.i10610, %.675.010872
  %.311.i.i = icmp slt i64 %.297.i.i, 0
  %.312.i.i = select i1 %.311.i.i, i64 %arg.batch.5.1.5.0, i64 0
  %14 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i
  %.326.i.i = getelementptr double, ptr %14, i64 %.312.i.i
  store double %.263.i.i, ptr %.326.i.i, align 8, !noalias !3
  %exitcond1142.not.i = icmp eq i64 %.188.i.i, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i, label %B402.endif.i, label %B76.if.i.i10609

B888.i:                                           ; preds = %B580.if.i
  store double 0.000000e+00, ptr %.1877.i, align 8, !noalias !0
  br label %B416

B358.if.i:                                        ; preds = %B358.if.i, %B358.if.lr.ph.i
  %.747.01132.i = phi i64 [ 0, %B358.if.lr.ph.i ], [ %.818.i, %B358.if.i ]
  %.818.i = add nsw i64 %.747.01132.i, 1
  %15 = getelementptr double, ptr %10, i64 %.747.01132.i
  %.893.i = load double, ptr %15, align 8, !noalias !0
  %.895.i = mul nsw i64 %.747.01132.i, %arg.shape.0
  %gep11099 = getelementptr double, ptr %invariant.gep11098, i64 %.895.i
  store double %.893.i, ptr %gep11099, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.818.i, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i, label %B402.i, label %B358.if.i

B402.endif.i:                                     ; preds = %B76.if.i.i10609, %B402.i
  br i1 %.11171137.not.i, label %B580.if.i, label %B496.if.lr.ph.i

B496.if.lr.ph.i:                                  ; preds = %B402.endif.i
  %.1179.i = select i1 %.438.i, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i = add i64 %.1179.i, %.236.i
  %.1200.i = mul i64 %.1180.i, %arg.batch.0.0.5.1
  %16 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i
  %invariant.gep11100 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.675.010872
  br label %B496.if.i

B496.if.i:                                        ; preds = %B496.if.i, %B496.if.lr.ph.i
  %.1061.01138.i = phi i64 [ 0, %B496.if.lr.ph.i ], [ %.1130.i, %B496.if.i ]
  %.1130.i = add nsw i64 %.1061.01138.i, 1
  %17 = getelementptr double, ptr %16, i64 %.1061.01138.i
  %.1205.i = load double, ptr %17, align 8, !noalias !0
  %.1207.i = mul nsw i64 %.1061.01138.i, %arg.shape.0
  %gep11101 = getelementptr double, ptr %invariant.gep11100, i64 %.1207.i
  store double %.1205.i, ptr %gep11101, align 8, !noalias !0
  %exitcond1143.not.i = icmp eq i64 %.1130.i, %arg.shape.1
  br i1 %exitcond1143.not.i, label %B580.if.i, label %B496.if.i

B580.if.i:                                        ; preds = %B496.if.i, %B402.endif.i
  %invariant.gep.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.675.010872
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
  %.1656.i = getelementptr double, ptr %4, i64 %.675.010872
  store double %.1547.i, ptr %.1656.i, align 8, !noalias !0
  store double 1.000000e+00, ptr %.293.i10601, align 8, !noalias !0
  %.1767.i = getelementptr double, ptr %5, i64 %.675.010872
  store double 0xFFF0000000000000, ptr %.1767.i, align 8, !noalias !0
  %.1822.i = getelementptr double, ptr %6, i64 %.675.010872
  store double 0x7FF0000000000000, ptr %.1822.i, align 8, !noalias !0
  %.1877.i = getelementptr double, ptr %7, i64 %.675.010872
  %.1878.i = load double, ptr %.1877.i, align 8, !noalias !0
  %.1880.i = fcmp ueq double %.1878.i, 0xFFF0000000000000
  br i1 %.1880.i, label %B416, label %B888.i

B416:                                             ; preds = %B888.i, %B372, %B580.if.i, %B330.if
  %.966 = load i64, ptr %280, align 8
  %.967 = icmp sgt i64 %.966, -1
  %.10576 = zext i1 %.967 to i64
  %.984 = add nsw i64 %active.4.010874, %.10576
  %.733 = icmp sgt i64 %.678.010873, 1
  br i1 %.733, label %B330.if, label %B470

B470:                                             ; preds = %B416, %entry
  %active.4.0.lcssa = phi i64 [ 0, %entry ], [ %.984, %B416 ]
  %.1001.not = icmp ne i64 %active.4.0.lcssa, 0
  %.1017 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.1001.not, i1 %.1017, i1 false
  br i1 %or.cond, label %B498.preheader, label %B4666

B498.preheader:                                   ; preds = %B470
  %.1061 = getelementptr i8, ptr %arg.batch.4.2.4, i64 16
  %factor.op.mul = mul i64 %arg.shape.1, 14
  %factor.op.mul11053 = mul i64 %arg.shape.1, 15
  %factor.op.mul11054 = shl i64 %arg.shape.1, 4
  %.1157 = getelementptr i8, ptr %arg.code.4, i64 8
  %.1209 = icmp sgt i64 %arg.shape.6, 0
  %.162.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx10575 = mul i64 %arg.batch.4.0.5.1, 24
  %19 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10575
  %.537.i10875 = icmp slt i64 %arg.shape.6, 1
  %.691.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.1270.not = icmp eq i64 %arg.shape.3, 0
  %.1300 = getelementptr i8, ptr %arg.code.4, i64 16
  %.1427.idx = shl i64 %.463, 4
  %.1427 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1427.idx
  %.1458 = getelementptr i8, ptr %arg.code.4, i64 72
  %.1534 = getelementptr i8, ptr %arg.code.4, i64 80
  %.1635.idx = mul i64 %.463, 136
  %.1635 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1635.idx
  %.1660.idx = mul i64 %.463, 24
  %.1660 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.1660.idx
  %.1691 = getelementptr i8, ptr %arg.code.4, i64 88
  %.idx10567 = mul i64 %arg.batch.4.0.5.1, 24
  %20 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10567
  %.idx10568 = shl i64 %arg.batch.4.0.5.1, 5
  %21 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10568
  %.idx10569 = mul i64 %arg.batch.4.0.5.1, 232
  %22 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10569
  %.10577 = select i1 %.612, i64 0, i64 2
  %.792.i = icmp ne i64 %arg.shape.2, 1
  %"$phi364.4.2.i.2" = zext i1 %.792.i to i64
  %.idx10570 = mul i64 %arg.batch.4.0.5.1, 88
  %23 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10570
  %.idx10571 = shl i64 %arg.batch.4.0.5.1, 4
  %24 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10571
  %.idx10572 = shl i64 %arg.batch.4.1.5.1, 4
  %25 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10572
  %.idx10573 = shl i64 %arg.batch.4.0.5.1, 4
  %26 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10573
  %.idx10574 = mul i64 %arg.batch.4.0.5.1, 152
  %27 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10574
  %.1829 = getelementptr i8, ptr %arg.code.4, i64 56
  %.1954 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.463
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
  %.idx.i10616 = mul i64 %arg.shape.1, 152
  %30 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i10616
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
  %.520.i10611 = add i64 %arg.linear.3.0, 1
  %.434.sroa.0.02106.i = add i64 %arg.shape.1, 1
  %.831.idx.i = mul i64 %arg.batch.4.0.5.1, 144
  %.831.i = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.831.idx.i
  %31 = add i64 %arg.linear.3.1, %arg.linear.3.0
  %.199.i.i = add i64 %arg.linear.3.1, 1
  %.2073 = add i64 %arg.shape.2, -1
  %storemerge10492 = tail call i64 @llvm.smax.i64(i64 %.2073, i64 0)
  %.211610888.not = icmp slt i64 %.2073, 1
  %.2290.idx = mul i64 %.463, 136
  %.2290 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.2290.idx
  %.218614.not.i = icmp sgt i64 %arg.shape.1, 0
  %or.cond10866.not = select i1 %.610, i1 %.218614.not.i, i1 false
  %.326.i10617 = mul nsw i64 %arg.shape.1, 17
  %.idx.i10619 = mul i64 %arg.shape.1, 80
  %invariant.gep10884 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.idx.i10619
  %.395.i = mul nsw i64 %arg.shape.1, 17
  %.339.i.i = add i64 %arg.linear.3.0, 1
  %invariant.gep10886 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.395.i
  %32 = add i64 %arg.linear.3.1, %arg.linear.3.0
  %.2410 = getelementptr i8, ptr %arg.code.4, i64 64
  %.2487 = icmp sgt i64 %arg.shape.3, 0
  %.2492 = icmp sgt i64 %arg.shape.6, 0
  %.idx10565 = mul i64 %arg.batch.4.0.5.1, 40
  %33 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10565
  %.idx10566 = mul i64 %arg.batch.4.0.5.1, 168
  %34 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10566
  %.idx10562 = mul i64 %arg.batch.4.0.5.1, 176
  %35 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10562
  %.idx10563 = mul i64 %arg.batch.4.0.5.1, 184
  %36 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10563
  %.idx10564 = mul i64 %arg.batch.4.0.5.1, 160
  %37 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10564
  %.idx10556 = shl i64 %arg.batch.4.1.5.1, 4
  %38 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10556
  %.idx10557 = mul i64 %arg.batch.4.0.5.1, 192
  %39 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10557
  %.idx10558 = mul i64 %arg.batch.4.0.5.1, 72
  %40 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10558
  %.idx10559 = mul i64 %arg.batch.4.0.5.1, 40
  %41 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10559
  %.idx10560 = mul i64 %arg.batch.4.0.5.1, 216
  %42 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10560
  %.idx10561 = mul i64 %arg.batch.4.0.5.1, 56
  %43 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10561
  %44 = or i1 %.612, %.625
  %.3882.idx = mul i64 %.463, 136
  %.3882 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3882.idx
  %.3907.idx = mul i64 %.463, 104
  %.3907 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.3907.idx
  %.3947 = getelementptr i8, ptr %arg.code.4, i64 120
  %.4041 = getelementptr i8, ptr %arg.code.4, i64 112
  %.idx10555 = shl i64 %arg.batch.4.1.5.1, 5
  %45 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10555
  %.671.i2541 = getelementptr i8, ptr %arg.code.4, i64 40
  %.742.i2595 = mul i64 %arg.shape.1, %arg.shape.0
  %.idx10552 = mul i64 %arg.batch.4.0.5.1, 48
  %46 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10552
  %.287.i.i10914.not = icmp slt i64 %arg.shape.1, 1
  %.358.i.i = shl nsw i64 %arg.shape.1, 4
  %.idx10548 = mul i64 %arg.batch.4.0.5.1, 40
  %47 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10548
  %.idx10549 = shl i64 %arg.batch.4.1.5.1, 5
  %48 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10549
  %.idx10550 = mul i64 %arg.batch.4.0.5.1, 104
  %49 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10550
  %.idx10551 = mul i64 %arg.batch.4.0.5.1, 112
  %50 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10551
  %.idx10544 = mul i64 %arg.batch.4.0.5.1, 56
  %51 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10544
  %.4562.c = getelementptr i8, ptr %arg.code.4, i64 104
  %.4422.idx = mul i64 %.463, 136
  %.4422 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4422.idx
  %.4485 = getelementptr i8, ptr %arg.code.4, i64 216
  %.4562 = getelementptr i8, ptr %arg.code.4, i64 104
  %.idx10537 = shl i64 %arg.batch.4.1.5.1, 4
  %52 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10537
  %.idx10538 = mul i64 %arg.batch.4.0.5.1, 40
  %53 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10538
  %.idx10539 = mul i64 %arg.batch.4.0.5.1, 56
  %54 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10539
  %.idx10540 = mul i64 %arg.batch.4.0.5.1, 200
  %55 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10540
  %.idx10541 = mul i64 %arg.batch.4.0.5.1, 48
  %56 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10541
  %.idx10542 = shl i64 %arg.batch.4.0.5.1, 5
  %57 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10542
  %58 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx10543 = mul i64 %arg.batch.4.0.5.1, 208
  %59 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10543
  %.idx10536 = shl i64 %arg.batch.4.1.5.1, 5
  %60 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10536
  %.671.i3840 = getelementptr i8, ptr %arg.code.4, i64 40
  %.742.i3896 = mul i64 %arg.shape.1, %arg.shape.0
  %.idx10533 = mul i64 %arg.batch.4.0.5.1, 48
  %61 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10533
  %.287.i.i468410942.not = icmp slt i64 %arg.shape.1, 1
  %.358.i.i4838 = shl nsw i64 %arg.shape.1, 4
  %.idx10528 = mul i64 %arg.batch.4.0.5.1, 40
  %62 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10528
  %.idx10529 = shl i64 %arg.batch.4.1.5.1, 5
  %63 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10529
  %storemerge10530 = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.idx10531 = mul i64 %arg.batch.4.0.5.1, 104
  %64 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10531
  %.idx10532 = mul i64 %arg.batch.4.0.5.1, 112
  %65 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10532
  %.idx10524 = mul i64 %arg.batch.4.0.5.1, 56
  %66 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10524
  %67 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.221.i = getelementptr i8, ptr %67, i64 -8
  %.idx2889.i = shl i64 %arg.batch.4.0.5.1, 7
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
  %.984.i.i10633 = getelementptr i8, ptr %arg.code.4, i64 8
  %factor.op.mul2918.i.reass = mul i64 %factor.op.mul11053, %arg.shape.0
  %.1243.i.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %factor.op.mul2918.i.reass
  %.1803.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.idx2885.i = shl i64 %arg.batch.4.0.5.1, 7
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
  %.idx2878.i = mul i64 %arg.batch.4.0.5.1, 96
  %72 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2878.i
  %.idx2870.i = mul i64 %arg.batch.4.0.5.1, 104
  %73 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2870.i
  %.idx2871.i = mul i64 %arg.batch.4.0.5.1, 112
  %74 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2871.i
  %.1254.reass.i = mul i64 %.358.i.i.i, %arg.shape.0
  %.1274.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1254.reass.i
  %.idx2865.i = shl i64 %arg.batch.4.1.5.1, 5
  %75 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx2865.i
  %storemerge2869.i = tail call i64 @llvm.smax.i64(i64 %arg.shape.6, i64 0)
  %.155.i.i.i10649 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx.i10640 = mul i64 %arg.batch.4.0.5.1, 56
  %76 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i10640
  %.idx2855.i = shl i64 %arg.batch.4.1.5.1, 5
  %77 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx2855.i
  %.idx2858.i = mul i64 %arg.batch.4.0.5.1, 104
  %78 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2858.i
  %.idx2862.i = mul i64 %arg.batch.4.0.5.1, 96
  %79 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2862.i
  %.idx2859.i = mul i64 %arg.batch.4.0.5.1, 112
  %80 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2859.i
  %.idx2860.i = mul i64 %arg.batch.4.0.5.1, 40
  %81 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2860.i
  %.idx2861.i = shl i64 %arg.batch.4.0.5.1, 5
  %82 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx2861.i
  %83 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.4830.not = icmp eq i64 %arg.shape.3, 0
  %.10588 = select i1 %.612, i64 1, i64 16
  %.524.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.595.i10656.reass = mul i64 %factor.op.mul11054, %arg.shape.0
  %.615.i = getelementptr double, ptr %arg.batch.5.0.4, i64 %.595.i10656.reass
  %.452.i = uitofp i64 %.10588 to double
  %.idx719.i = mul i64 %arg.batch.4.0.5.1, 48
  %84 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx719.i
  %.287.i725.not.i = icmp slt i64 %arg.shape.1, 1
  %.358.i.i10657 = shl nsw i64 %arg.shape.1, 4
  %.idx.i10658 = mul i64 %arg.batch.4.0.5.1, 40
  %85 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i10658
  %.idx717.i = mul i64 %arg.batch.4.0.5.1, 104
  %86 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx717.i
  %.idx718.i = mul i64 %arg.batch.4.0.5.1, 112
  %87 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx718.i
  %.155.i.i.i10662 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.1.i10669 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.2.i10670 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.3.i10671 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.4.i10672 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.5.i10673 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.6.i10674 = mul nsw i64 %arg.shape.1, 18
  %factor.op.mul652.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx.i10687 = shl i64 %arg.batch.4.1.5.1, 4
  %88 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx.i10687
  %.idx640.i = mul i64 %arg.batch.4.0.5.1, 40
  %89 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx640.i
  %.idx641.i = mul i64 %arg.batch.4.0.5.1, 48
  %90 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx641.i
  %.idx642.i = mul i64 %arg.batch.4.0.5.1, 56
  %91 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx642.i
  %.924649.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx644.i = mul i64 %arg.batch.4.0.5.1, 208
  %92 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx644.i
  %.1000.i10688 = mul nsw i64 %arg.shape.1, 17
  %93 = add i64 %arg.batch.2.5.0, -1
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.5066 = icmp sgt i64 %arg.shape.0, 1
  %.5120.idx = mul i64 %arg.batch.4.0.5.1, 40
  %.5120 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.5120.idx
  %.5152 = getelementptr i8, ptr %arg.code.4, i64 96
  %.idx10517 = mul i64 %arg.batch.4.0.5.1, 96
  %94 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10517
  %.idx10518 = mul i64 %arg.batch.4.0.5.1, 40
  %95 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10518
  %.idx10519 = mul i64 %arg.batch.4.0.5.1, 120
  %96 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10519
  %.552.i656511031.not = icmp slt i64 %arg.shape.1, 1
  %.697.i6602 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %97 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %.742.i6632 = getelementptr i8, ptr %97, i64 -8
  %.idx10521 = mul i64 %arg.batch.4.1.5.1, 24
  %98 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10521
  %.idx10522 = mul i64 %arg.batch.4.1.5.1, 24
  %99 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10522
  %.idx10523 = mul i64 %arg.batch.4.0.5.1, 24
  %100 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10523
  %.5268.not = icmp ne i64 %arg.shape.4, 0
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
  %.895.i10704 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.852.i
  %.900.not.i = icmp eq i64 %arg.shape.3, 0
  %.930.i10705 = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx1630.i = shl i64 %arg.batch.4.1.5.1, 4
  %104 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1630.i
  %.15441642.not.i = icmp slt i64 %arg.shape.1, 1
  %.1739.i = mul i64 %arg.batch.3.0.5.2, %arg.batch.3.0.5.1
  %.idx10506 = mul i64 %arg.batch.4.0.5.1, 40
  %105 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10506
  %.idx10507 = shl i64 %arg.batch.4.0.5.1, 4
  %106 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10507
  %107 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx10508 = mul i64 %arg.batch.4.0.5.1, 24
  %108 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10508
  %.175.i.i799611043.not = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.idx10511 = shl i64 %arg.batch.4.1.5.1, 4
  %109 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10511
  %.idx.i10718 = mul i64 %arg.batch.4.0.5.1, 24
  %110 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx.i10718
  %.323.i10720 = getelementptr i8, ptr %arg.batch.4.2.4, i64 8
  %111 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %arg.batch.4.1.5.1
  %.idx1124.i10740 = mul i64 %arg.batch.4.1.5.1, 24
  %112 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx1124.i10740
  %.8051131.not.i10742 = icmp slt i64 %arg.batch.0.1.5.1, 1
  %.175.i1134.not.i10758 = icmp slt i64 %arg.batch.1.1.5.0, 1
  %.11171137.not.i10777 = icmp slt i64 %arg.shape.1, 1
  %gep.2.idx.i10795 = shl i64 %arg.batch.4.0.5.1, 4
  %gep.4.idx.i10799 = shl i64 %arg.batch.4.0.5.1, 5
  %gep.6.idx.i10803 = mul i64 %arg.batch.4.0.5.1, 48
  %gep.7.idx.i10805 = mul i64 %arg.batch.4.0.5.1, 56
  %gep.9.idx.i10809 = mul i64 %arg.batch.4.0.5.1, 72
  %gep.10.idx.i10811 = mul i64 %arg.batch.4.0.5.1, 80
  %gep.11.idx.i10813 = mul i64 %arg.batch.4.0.5.1, 88
  %gep.12.idx.i10815 = mul i64 %arg.batch.4.0.5.1, 96
  %gep.13.idx.i10817 = mul i64 %arg.batch.4.0.5.1, 104
  %gep.14.idx.i10819 = mul i64 %arg.batch.4.0.5.1, 112
  %gep.15.idx.i10821 = mul i64 %arg.batch.4.0.5.1, 120
  %gep.16.idx.i10823 = shl i64 %arg.batch.4.0.5.1, 7
  %gep.17.idx.i10825 = mul i64 %arg.batch.4.0.5.1, 136
  %gep.18.idx.i10827 = mul i64 %arg.batch.4.0.5.1, 144
  %gep.19.idx.i10829 = mul i64 %arg.batch.4.0.5.1, 152
  %gep.20.idx.i10831 = mul i64 %arg.batch.4.0.5.1, 160
  %gep.21.idx.i10833 = mul i64 %arg.batch.4.0.5.1, 168
  %gep.22.idx.i10835 = mul i64 %arg.batch.4.0.5.1, 176
  %gep.23.idx.i10837 = mul i64 %arg.batch.4.0.5.1, 184
  %gep.24.idx.i10839 = mul i64 %arg.batch.4.0.5.1, 192
  %gep.25.idx.i10841 = mul i64 %arg.batch.4.0.5.1, 200
  %gep.26.idx.i10843 = mul i64 %arg.batch.4.0.5.1, 208
  %113 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.2.idx.i10795
  %114 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.15.idx.i10821
  %115 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %gep.26.idx.i10843
  %.idx1130.i10858 = mul i64 %arg.batch.4.0.5.1, 216
  %116 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx1130.i10858
  %.idx10510 = mul i64 %arg.batch.4.0.5.1, 216
  %117 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10510
  %.6336 = tail call i64 @llvm.smin.i64(i64 %arg.batch.2.5.0, i64 0)
  %118 = getelementptr double, ptr %arg.batch.2.4, i64 %arg.batch.2.5.0
  %119 = getelementptr i8, ptr %118, i64 -8
  %.6350 = getelementptr double, ptr %119, i64 %.6336
  %120 = getelementptr double, ptr %arg.batch.4.0.4, i64 %arg.batch.4.0.5.1
  %.idx10512 = mul i64 %arg.batch.4.0.5.1, 216
  %121 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10512
  %.idx10513 = mul i64 %arg.batch.4.0.5.1, 160
  %122 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10513
  %.idx10514 = shl i64 %arg.batch.4.1.5.1, 4
  %123 = getelementptr i8, ptr %arg.batch.4.1.4, i64 %.idx10514
  %.idx10515 = shl i64 %arg.batch.4.0.5.1, 4
  %124 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10515
  %.idx10516 = mul i64 %arg.batch.4.0.5.1, 152
  %125 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10516
  %126 = shl i64 %arg.shape.0, 3
  %.155.i.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.i.1 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.i.2 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.i.3 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.i.4 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.i.5 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.i.6 = mul nsw i64 %arg.shape.1, 18
  %127 = getelementptr i8, ptr %arg.code.4, i64 224
  %.4447.idx = mul i64 %.463, 112
  %.4447 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4447.idx
  %128 = getelementptr i8, ptr %arg.code.4, i64 232
  %.4447.1.idx = mul i64 %.463, 120
  %.4447.1 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4447.1.idx
  %129 = getelementptr i8, ptr %arg.code.4, i64 240
  %.4447.2.idx = shl i64 %.463, 7
  %.4447.2 = getelementptr i8, ptr %arg.batch.5.0.4, i64 %.4447.2.idx
  %.155.i.i.i4875 = mul nsw i64 %arg.shape.1, 24
  %.155.i.i.i4875.1 = mul nsw i64 %arg.shape.1, 23
  %.155.i.i.i4875.2 = mul nsw i64 %arg.shape.1, 22
  %.155.i.i.i4875.3 = mul nsw i64 %arg.shape.1, 21
  %.155.i.i.i4875.4 = mul nsw i64 %arg.shape.1, 20
  %.155.i.i.i4875.5 = mul nsw i64 %arg.shape.1, 19
  %.155.i.i.i4875.6 = mul nsw i64 %arg.shape.1, 18
  br label %B498

B498:                                             ; preds = %B498.preheader, %B4640
  %budget.3.1 = phi i64 [ %budget.4.2, %B4640 ], [ %arg.budget, %B498.preheader ]
  %active.9.1 = phi i64 [ %active.8.2, %B4640 ], [ %active.4.0.lcssa, %B498.preheader ]
  %.1027 = add nsw i64 %budget.3.1, -1
  %.1062 = load i64, ptr %.1061, align 8
  %.1063 = icmp eq i64 %.1062, 1
  %.1097 = icmp sgt i64 %.1062, 0
  br i1 %.1097, label %B566, label %B644

B566:                                             ; preds = %B498
  store i64 0, ptr %.1061, align 8
  %.1158 = load i64, ptr %.1157, align 8
  %.1203 = inttoptr i64 %.1158 to ptr
  tail call void %.1203(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B644

B644:                                             ; preds = %B566, %B498
  br i1 %.1063, label %B650, label %B1216

B650:                                             ; preds = %B644
  br i1 %.1209, label %B662, label %B698

B662:                                             ; preds = %B650
  %.163.i = load i64, ptr %.162.i, align 8, !noalias !7
  %.275.i = inttoptr i64 %.163.i to ptr
  tail call void %.275.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br i1 %.689, label %B326.i, label %B194.if.i

B324.i:                                           ; preds = %B266.if.i, %B194.if.i
  %.359.i = icmp sgt i64 %.304.i.010880, 1
  br i1 %.359.i, label %B194.if.i, label %B326.i

B326.i:                                           ; preds = %B324.i, %B662
  %.692.i = load i64, ptr %.691.i, align 8, !noalias !7
  %.808.i = inttoptr i64 %.692.i to ptr
  tail call void %.808.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !7
  br label %B698

B194.if.i:                                        ; preds = %B662, %B324.i
  %.304.i.010880 = phi i64 [ %.368.i, %B324.i ], [ %storemerge, %B662 ]
  %.301.i.010879 = phi i64 [ %.372.i, %B324.i ], [ 0, %B662 ]
  %.368.i = add nsw i64 %.304.i.010880, -1
  %.372.i = add nsw i64 %.301.i.010879, 1
  %130 = getelementptr double, ptr %19, i64 %.301.i.010879
  %.454.i = load double, ptr %130, align 8, !noalias !7
  %.455.i = fcmp ule double %.454.i, 5.000000e-01
  %brmerge11058 = select i1 %.455.i, i1 true, i1 %.537.i10875
  br i1 %brmerge11058, label %B324.i, label %B266.if.i.preheader

B266.if.i.preheader:                              ; preds = %B194.if.i
  %invariant.gep11102 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.301.i.010879
  br label %B266.if.i

B266.if.i:                                        ; preds = %B266.if.i.preheader, %B266.if.i
  %.481.i.010876 = phi i64 [ %.550.i, %B266.if.i ], [ 0, %B266.if.i.preheader ]
  %.550.i = add nsw i64 %.481.i.010876, 1
  %.576.i = mul nsw i64 %.481.i.010876, %arg.shape.0
  %gep11103 = getelementptr double, ptr %invariant.gep11102, i64 %.576.i
  %.608.i = load double, ptr %gep11103, align 8, !noalias !7
  %.610.i = add nsw i64 %.481.i.010876, %arg.shape.5
  %.612.i = mul nsw i64 %.610.i, %arg.shape.0
  %.614.i = add nsw i64 %.612.i, %.301.i.010879
  %.628.i = icmp slt i64 %.614.i, 0
  %.629.i = select i1 %.628.i, i64 %arg.batch.5.1.5.0, i64 0
  %131 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.614.i
  %.643.i = getelementptr double, ptr %131, i64 %.629.i
  store double %.608.i, ptr %.643.i, align 8, !noalias !7
  %exitcond.not = icmp eq i64 %.550.i, %arg.shape.6
  br i1 %exitcond.not, label %B324.i, label %B266.if.i

B698:                                             ; preds = %B326.i, %B650
  br i1 %.1270.not, label %B770, label %B702

B702:                                             ; preds = %B698
  %.1301 = load i64, ptr %.1300, align 8
  %.1346 = inttoptr i64 %.1301 to ptr
  tail call void %.1346(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B770

B770:                                             ; preds = %B702, %B698
  br i1 %.612, label %B1174, label %B774

B774:                                             ; preds = %B770
  %.1380 = load i64, ptr %arg.code.4, align 8
  %.1428 = inttoptr i64 %.1380 to ptr
  tail call void %.1428(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1427)
  %.1459 = load i64, ptr %.1458, align 8
  %.1504 = inttoptr i64 %.1459 to ptr
  tail call void %.1504(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.1535 = load i64, ptr %.1534, align 8
  %.1580 = inttoptr i64 %.1535 to ptr
  tail call void %.1580(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.1611 = load i64, ptr %arg.code.4, align 8
  %.1661 = inttoptr i64 %.1611 to ptr
  tail call void %.1661(ptr %.571, ptr %.1635, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1660)
  %.1692 = load i64, ptr %.1691, align 8
  %.1737 = inttoptr i64 %.1692 to ptr
  tail call void %.1737(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B1174

B1174:                                            ; preds = %B774, %B770
  br i1 %.689, label %B1216, label %B64.if.i

B108.i:                                           ; preds = %B64.if.i
  store double 0.000000e+00, ptr %.314.i134, align 8, !noalias !11
  %.432.i191 = getelementptr double, ptr %21, i64 %.161.i.010882
  store double 0.000000e+00, ptr %.432.i191, align 8, !noalias !11
  %.487.i = getelementptr double, ptr %22, i64 %.161.i.010882
  store double 0.000000e+00, ptr %.487.i, align 8, !noalias !11
  %.542.i244 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.010882
  %.543.i245 = load i64, ptr %.542.i244, align 8, !noalias !11
  %.570.i = icmp slt i64 %.543.i245, 0
  %.571.i = select i1 %.570.i, i64 %arg.batch.3.3.5.0, i64 0
  %.572.i257 = add i64 %.571.i, %.543.i245
  %.592.i271 = mul i64 %.572.i257, %arg.batch.3.3.5.1
  %132 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.592.i271
  %.596.i = getelementptr i8, ptr %132, i64 8
  %.597.i275 = load i64, ptr %.596.i, align 8, !noalias !11
  %.620.i282 = add nsw i64 %.597.i275, %.10577
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
  %.928.i = getelementptr double, ptr %23, i64 %.161.i.010882
  %.929.i = load double, ptr %.928.i, align 8, !noalias !11
  %.930.i = fcmp une double %.929.i, 0.000000e+00
  br i1 %.930.i, label %B414.i, label %B460.i

B414.i:                                           ; preds = %B108.i
  %134 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.010882
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
  br i1 %.1270.not, label %B596.i, label %B464.i

B464.i:                                           ; preds = %B460.i
  %135 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.161.i.010882
  %.1000.i = load double, ptr %135, align 8, !noalias !11
  %.1002.i = fcmp olt double %.1000.i, -1.000000e-09
  br i1 %.1002.i, label %B500.i, label %B596.i

B500.i:                                           ; preds = %B464.i
  %136 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.161.i.010882
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
  %.1091.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.161.i.010882
  %.1092.i = load double, ptr %.1091.i, align 8, !noalias !11
  %.1146.i = getelementptr double, ptr %24, i64 %.161.i.010882
  store double %.1092.i, ptr %.1146.i, align 8, !noalias !11
  br label %B596.i

B596.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i, %B464.i, %B460.i
  %.111.i183.i = getelementptr i64, ptr %25, i64 %.161.i.010882
  %.112.i.i = load i64, ptr %.111.i183.i, align 8, !noalias !21
  %.169.i.i = getelementptr double, ptr %26, i64 %.161.i.010882
  %.170.i.i = load double, ptr %.169.i.i, align 8, !noalias !21
  %.224.i.i = getelementptr double, ptr %27, i64 %.161.i.010882
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
  %.220.i = icmp sgt i64 %.164.i70.010883, 1
  br i1 %.220.i, label %B64.if.i, label %B1216

B64.if.i:                                         ; preds = %B1174, %B630.i
  %.164.i70.010883 = phi i64 [ %.229.i381, %B630.i ], [ %storemerge, %B1174 ]
  %.161.i.010882 = phi i64 [ %.233.i384, %B630.i ], [ 0, %B1174 ]
  %.229.i381 = add nsw i64 %.164.i70.010883, -1
  %.233.i384 = add nsw i64 %.161.i.010882, 1
  %.314.i134 = getelementptr double, ptr %20, i64 %.161.i.010882
  %.315.i135 = load double, ptr %.314.i134, align 8, !noalias !11
  %.316.i136 = fcmp ogt double %.315.i135, 5.000000e-01
  br i1 %.316.i136, label %B108.i, label %B630.i

B1216:                                            ; preds = %B630.i, %B1174, %B644
  %.1830 = load i64, ptr %.1829, align 8
  %.1875 = inttoptr i64 %.1830 to ptr
  tail call void %.1875(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.612, label %B1288, label %B1372

B1288:                                            ; preds = %B1216
  %.1908 = load i64, ptr %arg.code.4, align 8
  %.1955 = inttoptr i64 %.1908 to ptr
  tail call void %.1955(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1954)
  br label %B1372

B1372:                                            ; preds = %B1288, %B1216
  br i1 %.610, label %B1376, label %B1416

B1376:                                            ; preds = %B1372
  %.267.i = load double, ptr %.266.i, align 8, !noalias !25
  %.268.i = fcmp olt double %.267.i, 5.000000e-01
  br i1 %.268.i, label %B76.i, label %B116.i

B76.i:                                            ; preds = %B1376
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
  %exitcond.not.i10615 = icmp eq i64 %arg.shape.1, %.330.i.i
  br i1 %exitcond.not.i10615, label %B166.i.i, label %B84.if.i.i

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

B116.i:                                           ; preds = %B228.i.loopexit.i, %B166.i.i, %B1376
  br i1 %.402.i, label %B146.if.i, label %B1416

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
  br i1 %exitcond.not.i.i, label %B1416, label %B36.if.i.i

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
  %.11.i.i.i10614 = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.165.i.i, i64 %arg.shape.1)
  %.200.i.i = add i64 %.199.i.i, %.164.i.i
  %.11.i492.i.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.200.i.i, i64 %arg.shape.1)
  %175 = getelementptr double, ptr %arg.linear.1.4, i64 %.161.i.i
  %176 = getelementptr double, ptr %175, i64 %.59.0509.i.i
  %.319.i.i = sub i64 %.11.i.i.i10614, %.131.i.i
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
  %.11.i.i10612 = tail call i64 @llvm.smax.i64(i64 %.489.i, i64 0)
  %.521.i = add i64 %.520.i10611, %.388.02152.i
  %.11.i2116.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.521.i, i64 %arg.shape.1)
  %.587.i = sub i64 %.11.i2116.i, %.11.i.i10612
  %.6302148.not.i = icmp slt i64 %.587.i, 1
  br i1 %.6302148.not.i, label %B316.i, label %B262.if.lr.ph.i

B262.if.lr.ph.i:                                  ; preds = %B146.if.i
  %.670.i = mul nsw i64 %.388.02152.i, %arg.shape.1
  br label %B262.if.i

B262.if.i:                                        ; preds = %B262.if.i, %B262.if.lr.ph.i
  %.577.02150.i = phi i64 [ %.587.i, %B262.if.lr.ph.i ], [ %.639.i, %B262.if.i ]
  %.574.02149.i = phi i64 [ %.11.i.i10612, %B262.if.lr.ph.i ], [ %.643.i10613, %B262.if.i ]
  %.639.i = add nsw i64 %.577.02150.i, -1
  %.643.i10613 = add i64 %.574.02149.i, 1
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

B1416:                                            ; preds = %B34.loopexit.i.i, %B116.i, %B1372
  br i1 %.211610888.not, label %B1664, label %B1448.if

B68.if.lr.ph.i:                                   ; preds = %B1448.if
  %.259.i = mul nsw i64 %.2129, %arg.shape.1
  br label %B68.if.i

B34.i.loopexit.i:                                 ; preds = %B198.if.i.i, %B34.if.i.i10624
  %exitcond633.not.i = icmp eq i64 %arg.shape.1, %.144.i.i
  br i1 %exitcond633.not.i, label %B314.if.i.i, label %B34.if.i.i10624

B314.i.loopexit.i:                                ; preds = %B474.if.i.i, %B314.if.i.i
  %.683.i.i = icmp sgt i64 %.627.i.0629.in.i, 1
  br i1 %.683.i.i, label %B314.if.i.i, label %B286.if.lr.ph.i

B286.if.lr.ph.i:                                  ; preds = %B314.i.loopexit.i
  %.624.i = mul nsw i64 %.2129, %arg.shape.1
  br label %B286.if.i

B34.if.i.i10624:                                  ; preds = %B68.if.i, %B34.i.loopexit.i
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
  %gep10887 = getelementptr double, ptr %invariant.gep10886, i64 %.73.i.0621.i
  %.270.i.i = load double, ptr %gep10887, align 8, !noalias !39
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !39
  store double %.234.i.i, ptr %gep10887, align 8, !noalias !39
  %.340.i.i = add i64 %.339.i.i, %.73.i.0621.i
  %.11.i.i.i10625 = tail call i64 @llvm.smin.i64(i64 %.340.i.i, i64 %arg.shape.1)
  %.406.i.i = sub i64 %.11.i.i.i10625, %.144.i.i
  %.449.i617.not.i = icmp slt i64 %.406.i.i, 1
  br i1 %.449.i617.not.i, label %B34.i.loopexit.i, label %B198.if.i.lr.ph.i

B198.if.i.lr.ph.i:                                ; preds = %B34.if.i.i10624
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
  %.755.i.i10626 = getelementptr double, ptr %190, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i10626, align 8, !noalias !39
  %.759.i.i10627 = mul nsw i64 %.627.i.0629.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i10627, %.627.i.0629.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %arg.linear.1.5.0, i64 0
  %191 = getelementptr double, ptr %arg.linear.1.4, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %191, i64 %.776.i.i
  %.791.i.i = load double, ptr %.790.i.i, align 8, !noalias !39
  %.795.i.i = fdiv double %.756.i.i, %.791.i.i
  store double %.795.i.i, ptr %.755.i.i10626, align 8, !noalias !39
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
  %.1044.i.i10628 = load double, ptr %.1043.i.i, align 8, !noalias !39
  %.1048.i.i = add nsw i64 %.919.i.0624.i, %.759.i.i10627
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %arg.linear.1.5.0, i64 0
  %193 = getelementptr double, ptr %arg.linear.1.4, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %193, i64 %.1063.i.i
  %.1078.i.i = load double, ptr %.1077.i.i, align 8, !noalias !39
  %.1080.i.i = fmul double %.795.i.i, %.1078.i.i
  %.1081.i.i = fsub double %.1044.i.i10628, %.1080.i.i
  store double %.1081.i.i, ptr %.1043.i.i, align 8, !noalias !39
  %.975.i.i10629 = icmp sgt i64 %.922.i.0625.i, 1
  br i1 %.975.i.i10629, label %B474.if.i.i, label %B314.i.loopexit.i

B68.if.i:                                         ; preds = %B68.if.i, %B68.if.lr.ph.i
  %.160.0615.i = phi i64 [ 0, %B68.if.lr.ph.i ], [ %.231.i, %B68.if.i ]
  %.231.i = add nsw i64 %.160.0615.i, 1
  %.260.i = add nsw i64 %.160.0615.i, %.259.i
  %.274.i = icmp slt i64 %.260.i, 0
  %.275.i10618 = select i1 %.274.i, i64 %arg.batch.5.0.5.0, i64 0
  %194 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.260.i
  %.289.i = getelementptr double, ptr %194, i64 %.275.i10618
  %.290.i = load double, ptr %.289.i, align 8, !noalias !45
  %gep10885 = getelementptr double, ptr %invariant.gep10884, i64 %.160.0615.i
  %.323.i10620 = load double, ptr %gep10885, align 8, !noalias !45
  %.324.i10621 = fadd double %.290.i, %.323.i10620
  %195 = getelementptr i64, ptr %arg.linear.4.4, i64 %.160.0615.i
  %.356.i = load i64, ptr %195, align 8, !noalias !45
  %.357.i = add nsw i64 %.356.i, %.326.i10617
  %.371.i = icmp slt i64 %.357.i, 0
  %.372.i10622 = select i1 %.371.i, i64 %arg.batch.5.0.5.0, i64 0
  %196 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.357.i
  %.386.i = getelementptr double, ptr %196, i64 %.372.i10622
  store double %.324.i10621, ptr %.386.i, align 8, !noalias !45
  %exitcond.not.i10623 = icmp eq i64 %arg.shape.1, %.231.i
  br i1 %exitcond.not.i10623, label %B34.if.i.i10624, label %B68.if.i

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
  %.639.i10630 = icmp slt i64 %.625.i, 0
  %.640.i = select i1 %.639.i10630, i64 %arg.batch.5.0.5.0, i64 0
  %199 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.625.i
  %.654.i10631 = getelementptr double, ptr %199, i64 %.640.i
  store double %.620.i, ptr %.654.i10631, align 8, !noalias !45
  %exitcond634.not.i = icmp eq i64 %arg.shape.1, %.533.i
  br i1 %exitcond634.not.i, label %B1662, label %B286.if.i

B1662:                                            ; preds = %B286.if.i, %B1448.if
  %exitcond11079.not = icmp eq i64 %.2060.010889, %storemerge10492
  br i1 %exitcond11079.not, label %B1664, label %B1448.if

B1664:                                            ; preds = %B1662, %B1416
  %.2411 = load i64, ptr %.2410, align 8
  %.2456 = inttoptr i64 %.2411 to ptr
  tail call void %.2456(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %brmerge = select i1 %.1063, i1 true, i1 %.610
  %or.cond10578 = select i1 %brmerge, i1 true, i1 %.2487
  %spec.select10599 = select i1 %or.cond10578, i1 true, i1 %.2492
  br i1 %.689, label %B1896, label %B1806.if

B1814:                                            ; preds = %B1806.if
  %200 = getelementptr double, ptr %33, i64 %.2532.010892
  %.2691 = load double, ptr %200, align 8
  %.2692 = fcmp ogt double %.2691, 5.000000e-01
  br label %B1850

B1850:                                            ; preds = %B1814, %B1806.if
  %"$phi1850.1.2.2" = phi i1 [ true, %B1806.if ], [ %.2692, %B1814 ]
  br i1 %looked.2.110895, label %B1892, label %B1856

B1856:                                            ; preds = %B1850
  %201 = getelementptr double, ptr %34, i64 %.2532.010892
  %.2766 = load double, ptr %201, align 8
  %.2767 = fcmp ogt double %.2766, 5.000000e-01
  br label %B1892

B1892:                                            ; preds = %B1856, %B1850
  %"$phi1892.1.2.2" = phi i1 [ true, %B1850 ], [ %.2767, %B1856 ]
  %.2588 = icmp sgt i64 %.2535.010893, 1
  br i1 %.2588, label %B1806.if, label %B1896

B1896:                                            ; preds = %B1892, %B1664
  %good.2.1.lcssa = phi i1 [ false, %B1664 ], [ %"$phi1850.1.2.2", %B1892 ]
  %looked.2.1.lcssa = phi i1 [ %spec.select10599, %B1664 ], [ %"$phi1892.1.2.2", %B1892 ]
  %looked.2.1.lcssa.not11090 = xor i1 %looked.2.1.lcssa, true
  %brmerge11091 = or i1 %.689, %looked.2.1.lcssa.not11090
  br i1 %brmerge11091, label %B2474, label %B80.if.i

B1966.preheader:                                  ; preds = %B568.i
  br i1 %.689, label %B2474, label %B1966.if

B126.i:                                           ; preds = %B80.if.i
  %.318.i589 = getelementptr double, ptr %35, i64 %.105.i435.010899
  %.319.i = load double, ptr %.318.i589, align 8, !noalias !46
  %.5.i.i = fptosi double %.319.i to i64
  %.397.i634 = getelementptr double, ptr %36, i64 %.105.i435.010899
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
  %.707.i870 = mul nsw i64 %.706.i869, %.2073
  %..5.i.i = select i1 %.625, i64 0, i64 %.5.i.i
  %.708.i871 = add i64 %.707.i870, %..5.i.i
  %.841.i958 = add i64 %.708.i871, %.701.i864
  store i64 %.841.i958, ptr %.700.i863, align 8, !noalias !46
  store double 0.000000e+00, ptr %.318.i589, align 8, !noalias !46
  store double 0.000000e+00, ptr %.397.i634, align 8, !noalias !46
  %.1072.i = getelementptr double, ptr %37, i64 %.105.i435.010899
  %.1073.i1075 = load double, ptr %.1072.i, align 8, !noalias !46
  %.1081.i1080 = sitofp i64 %.706.i869 to double
  %.1082.i1081 = fsub double %.1073.i1075, %.1081.i1080
  store double %.1082.i1081, ptr %.1072.i, align 8, !noalias !46
  br label %B568.i

B568.i:                                           ; preds = %B126.i, %B80.if.i
  %.163.i493 = icmp sgt i64 %.108.i.010900, 1
  br i1 %.163.i493, label %B80.if.i, label %B1966.preheader

B80.if.i:                                         ; preds = %B1896, %B568.i
  %.108.i.010900 = phi i64 [ %.172.i1118, %B568.i ], [ %storemerge, %B1896 ]
  %.105.i435.010899 = phi i64 [ %.176.i1121, %B568.i ], [ 0, %B1896 ]
  %.172.i1118 = add nsw i64 %.108.i.010900, -1
  %.176.i1121 = add nsw i64 %.105.i435.010899, 1
  %202 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i435.010899
  %.258.i = load i64, ptr %202, align 8, !noalias !46
  %.263.i545 = icmp sgt i64 %.258.i, -1
  br i1 %.263.i545, label %B126.i, label %B568.i

B2066:                                            ; preds = %B1966.if
  %.3221 = getelementptr double, ptr %40, i64 %.2887.010902
  %.3222 = load double, ptr %.3221, align 8
  %.3223 = fcmp ogt double %.3222, 5.000000e-01
  br i1 %.3223, label %B2104, label %B2204

B2104:                                            ; preds = %B2066
  %.5.i = fptosi double %.3222 to i64
  %203 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2887.010902
  %.84.i2116 = load i64, ptr %203, align 8, !noalias !50
  %.89.i2119 = icmp sgt i64 %.84.i2116, -1
  br i1 %.89.i2119, label %B46.i, label %B2204

B2204:                                            ; preds = %B2066, %B46.i, %B2104, %B80.i2148
  %.3409 = getelementptr double, ptr %41, i64 %.2887.010902
  %.3410 = load double, ptr %.3409, align 8
  %.3411 = fcmp ogt double %.3410, 5.000000e-01
  br i1 %.3411, label %B2242, label %B2472

B2242:                                            ; preds = %B2204
  %spec.select = select i1 %within.3.210904, i1 true, i1 %.2487
  %.3487 = mul i64 %.3048, %arg.batch.3.3.5.1
  %.3491 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.3487
  %.3492 = load i64, ptr %.3491, align 8
  %.3503.0 = and i64 %.3492, 127
  %.3533 = icmp eq i64 %.3503.0, 0
  br i1 %.3533, label %B2350, label %B2312

B2312:                                            ; preds = %B2242
  %.3594 = getelementptr double, ptr %42, i64 %.2887.010902
  %.3595 = load double, ptr %.3594, align 8
  %.3597 = fcmp ogt double %.3595, 0.000000e+00
  br i1 %.3597, label %B2350, label %B2380

B2350:                                            ; preds = %B2242, %B2312
  store double 1.000000e+00, ptr %.3163, align 8
  br label %B2380

B2380:                                            ; preds = %B2350, %B2312
  %checked.5.5 = phi i1 [ true, %B2350 ], [ %checked.3.210905, %B2312 ]
  %.3680 = icmp slt i64 %.3103, %arg.batch.2.5.0
  br i1 %.3680, label %B2418, label %B2472

B2418:                                            ; preds = %B2380
  %.3704 = icmp slt i64 %.3103, 0
  %.3705 = select i1 %.3704, i64 %arg.batch.2.5.0, i64 0
  %204 = getelementptr double, ptr %arg.batch.2.4, i64 %.3103
  %.3719 = getelementptr double, ptr %204, i64 %.3705
  %.3720 = load double, ptr %.3719, align 8
  %.3778 = getelementptr double, ptr %43, i64 %.2887.010902
  %.3779 = load double, ptr %.3778, align 8
  %.3780 = fcmp olt double %.3720, %.3779
  br i1 %.3780, label %B2468, label %B2472

B2468:                                            ; preds = %B2418
  br label %B2472

B2472:                                            ; preds = %B1966.if, %B2468, %B2418, %B2380, %B2204
  %within.4.3 = phi i1 [ true, %B2468 ], [ %spec.select, %B2418 ], [ %spec.select, %B2380 ], [ %within.3.210904, %B2204 ], [ %within.3.210904, %B1966.if ]
  %checked.4.3 = phi i1 [ %checked.5.5, %B2468 ], [ %checked.5.5, %B2418 ], [ %checked.5.5, %B2380 ], [ %checked.3.210905, %B2204 ], [ %checked.3.210905, %B1966.if ]
  %.2949 = icmp sgt i64 %.2890.010903, 1
  br i1 %.2949, label %B1966.if, label %B2474

B2474:                                            ; preds = %B2472, %B1896, %B1966.preheader
  %within.5.1 = phi i1 [ false, %B1896 ], [ false, %B1966.preheader ], [ %within.4.3, %B2472 ]
  %checked.2.1 = phi i1 [ false, %B1896 ], [ false, %B1966.preheader ], [ %checked.4.3, %B2472 ]
  %good.2.1.not = xor i1 %good.2.1.lcssa, true
  %brmerge10580 = select i1 %good.2.1.not, i1 true, i1 %44
  br i1 %brmerge10580, label %B2602, label %B2486

B2486:                                            ; preds = %B2474
  %.3858 = load i64, ptr %arg.code.4, align 8
  %.3908 = inttoptr i64 %.3858 to ptr
  tail call void %.3908(ptr %.571, ptr %.3882, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.3907)
  br label %B2602

B2602:                                            ; preds = %B2474, %B2486
  br i1 %checked.2.1, label %B2606, label %B2682

B2606:                                            ; preds = %B2602
  switch i64 %arg.shape.2, label %B2682 [
    i64 12, label %B2614
    i64 7, label %B2614
  ]

B2614:                                            ; preds = %B2606, %B2606
  %.3948 = load i64, ptr %.3947, align 8
  %.3993 = inttoptr i64 %.3948 to ptr
  tail call void %.3993(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B2682

B2682:                                            ; preds = %B2606, %B2614, %B2602
  %brmerge10583.not = and i1 %.2492, %good.2.1.lcssa
  br i1 %brmerge10583.not, label %B2702, label %B2808

B2702:                                            ; preds = %B2682
  %.4042 = load i64, ptr %.4041, align 8
  %.4087 = inttoptr i64 %.4042 to ptr
  tail call void %.4087(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.689, label %B188.if.i.preheader, label %B108.if.i

B186.i.loopexit.critedge:                         ; preds = %B188.if.i
  %.625.i2511.c = icmp ult i64 %.361.i2305.010925, 8
  %.10584.c = select i1 %.625.i2511.c, i64 16, i64 17
  %.672.i2542.c = load i64, ptr %.671.i2541, align 8, !noalias !53
  %.744.i2597.c = mul i64 %.742.i2595, %.10584.c
  %.762.i2605.c = getelementptr double, ptr %arg.batch.5.0.4, i64 %.744.i2597.c
  %.788.i2615.c = inttoptr i64 %.672.i2542.c to ptr
  tail call void %.788.i2615.c(ptr %.571, ptr %.762.i2605.c, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !53
  br label %B186.i.loopexit

B186.i.loopexit:                                  ; preds = %B770.i, %B186.i.loopexit.critedge
  %some.2.i.1.lcssa = phi i1 [ %some.4.i.010927, %B186.i.loopexit.critedge ], [ %some.3.i.2, %B770.i ]
  %exitcond11082.not = icmp eq i64 %.431.i3147, 9
  br i1 %exitcond11082.not, label %B806.i.preheader, label %B188.if.i

B806.i.preheader:                                 ; preds = %B186.i.loopexit
  br i1 %.689, label %B2808, label %B806.if.i

B222.i.loopexit:                                  ; preds = %B122.if.i.i, %B222.if.i
  %.539.i2501 = icmp sgt i64 %.486.i2315.010919, 1
  br i1 %.539.i2501, label %B222.if.i, label %B284.i

B284.i:                                           ; preds = %B222.i.loopexit
  %.625.i2511 = icmp ult i64 %.361.i2305.010925, 8
  %.10584 = select i1 %.625.i2511, i64 16, i64 17
  %.672.i2542 = load i64, ptr %.671.i2541, align 8, !noalias !53
  %.744.i2597 = mul i64 %.742.i2595, %.10584
  %.762.i2605 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.744.i2597
  %.788.i2615 = inttoptr i64 %.672.i2542 to ptr
  tail call void %.788.i2615(ptr %.571, ptr %.762.i2605, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !53
  %.1181.i = add nsw i64 %.361.i2305.010925, -1
  %.1182.i = sitofp i64 %.1181.i to double
  %.1187.i = fmul double %.1182.i, 1.250000e-01
  %.1189.i2867 = uitofp i64 %.361.i2305.010925 to double
  %.1194.i = fmul double %.1189.i2867, 1.250000e-01
  br label %B466.if.i

B508.i:                                           ; preds = %B466.if.i
  %.1028.i2744 = getelementptr double, ptr %47, i64 %.814.i2334.010921
  %.1029.i = load double, ptr %.1028.i2744, align 8, !noalias !53
  %.1030.i = fcmp ogt double %.1029.i, 5.000000e-01
  br i1 %.1030.i, label %B546.i, label %B770.i

B546.i:                                           ; preds = %B508.i
  %.1088.i2788 = getelementptr i64, ptr %48, i64 %.814.i2334.010921
  %.1089.i = load i64, ptr %.1088.i2788, align 8, !noalias !53
  %.1090.i2789 = icmp slt i64 %.1089.i, 0
  br i1 %.1090.i2789, label %B34.i.i, label %B770.i

B34.i.i:                                          ; preds = %B546.i, %B36.i.i
  %.48.i.i2177.0 = phi i64 [ %.119.i88.i, %B36.i.i ], [ 0, %B546.i ]
  %.51.i12.i.0 = phi i64 [ %.115.i.i2891, %B36.i.i ], [ %arg.shape.6, %B546.i ]
  %.106.i.i2820 = icmp sgt i64 %.51.i12.i.0, 0
  br i1 %.106.i.i2820, label %B36.i.i, label %B584.endif.i

B36.i.i:                                          ; preds = %B34.i.i
  %.115.i.i2891 = add nsw i64 %.51.i12.i.0, -1
  %.119.i88.i = add i64 %.48.i.i2177.0, 1
  %.149.i53.i = add nsw i64 %.48.i.i2177.0, %arg.shape.6
  %.151.i55.i = mul nsw i64 %.149.i53.i, %arg.shape.0
  %.153.i56.i = add nsw i64 %.151.i55.i, %.814.i2334.010921
  %.167.i61.i = icmp slt i64 %.153.i56.i, 0
  %.168.i62.i = select i1 %.167.i61.i, i64 %arg.batch.5.4.5.0, i64 0
  %205 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i56.i
  %.182.i74.i = getelementptr double, ptr %205, i64 %.168.i62.i
  %.183.i75.i = load double, ptr %.182.i74.i, align 8, !noalias !57
  %.184.i.i = fcmp ogt double %.183.i75.i, 5.000000e-01
  br i1 %.184.i.i, label %B584.endif.i, label %B34.i.i

B732.i:                                           ; preds = %B584.endif.i
  %.1369.i = load i64, ptr %.1088.i2788, align 8, !noalias !53
  %.1370.i = icmp sgt i64 %.1369.i, -1
  br label %B770.i

B770.i:                                           ; preds = %B732.i, %B584.endif.i, %B546.i, %B508.i, %B466.if.i
  %some.3.i.2 = phi i1 [ %some.2.i.110923, %B466.if.i ], [ %some.2.i.110923, %B546.i ], [ %some.2.i.110923, %B508.i ], [ true, %B584.endif.i ], [ %.1370.i, %B732.i ]
  %.870.i2647 = icmp sgt i64 %.817.i2335.010922, 1
  br i1 %.870.i2647, label %B466.if.i, label %B186.i.loopexit

B108.if.i:                                        ; preds = %B2702, %B108.if.i
  %.179.i2295.010910 = phi i64 [ %.243.i3203, %B108.if.i ], [ %storemerge, %B2702 ]
  %.176.i2294.010909 = phi i64 [ %.247.i3206, %B108.if.i ], [ 0, %B2702 ]
  %.243.i3203 = add nsw i64 %.179.i2295.010910, -1
  %.247.i3206 = add nsw i64 %.176.i2294.010909, 1
  %206 = getelementptr i64, ptr %45, i64 %.176.i2294.010909
  store i64 -1, ptr %206, align 8, !noalias !53
  %.234.i2410 = icmp sgt i64 %.179.i2295.010910, 1
  br i1 %.234.i2410, label %B108.if.i, label %B188.if.i.preheader

B188.if.i.preheader:                              ; preds = %B108.if.i, %B2702
  br label %B188.if.i

B188.if.i:                                        ; preds = %B188.if.i.preheader, %B186.i.loopexit
  %some.4.i.010927 = phi i1 [ %some.2.i.1.lcssa, %B186.i.loopexit ], [ false, %B188.if.i.preheader ]
  %.361.i2305.010925 = phi i64 [ %.431.i3147, %B186.i.loopexit ], [ 1, %B188.if.i.preheader ]
  %.431.i3147 = add nsw i64 %.361.i2305.010925, 1
  br i1 %.689, label %B186.i.loopexit.critedge, label %B222.if.i.lr.ph

B222.if.i.lr.ph:                                  ; preds = %B188.if.i
  %.579.i2908 = uitofp i64 %.361.i2305.010925 to double
  %.584.i2909 = fmul double %.579.i2908, 1.250000e-01
  %.247.i.i.i = fsub double 1.000000e+00, %.584.i2909
  br label %B222.if.i

B222.if.i:                                        ; preds = %B222.if.i.lr.ph, %B222.i.loopexit
  %.486.i2315.010919 = phi i64 [ %storemerge, %B222.if.i.lr.ph ], [ %.548.i3131, %B222.i.loopexit ]
  %.483.i2314.010918 = phi i64 [ 0, %B222.if.i.lr.ph ], [ %.552.i3134, %B222.i.loopexit ]
  %.548.i3131 = add nsw i64 %.486.i2315.010919, -1
  %.552.i3134 = add nsw i64 %.483.i2314.010918, 1
  %.92.i.i2984 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.483.i2314.010918
  %.93.i.i2985 = load double, ptr %.92.i.i2984, align 8, !noalias !61
  %.146.i.i3019 = getelementptr double, ptr %46, i64 %.483.i2314.010918
  %.147.i.i3020 = load double, ptr %.146.i.i3019, align 8, !noalias !61
  %.149.i.i3022 = fmul double %.584.i2909, %.147.i.i3020
  %.150.i.i3023 = fadd double %.93.i.i2985, %.149.i.i3022
  %.203.i.i3050 = getelementptr double, ptr %.571, i64 %.483.i2314.010918
  store double %.150.i.i3023, ptr %.203.i.i3050, align 8, !noalias !61
  br i1 %.287.i.i10914.not, label %B222.i.loopexit, label %B122.if.i.i.preheader

B122.if.i.i.preheader:                            ; preds = %B222.if.i
  %invariant.gep11104 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2314.010918
  %invariant.gep11106 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2314.010918
  %invariant.gep11108 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2314.010918
  %invariant.gep11110 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2314.010918
  %invariant.gep11112 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2314.010918
  %invariant.gep11114 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2314.010918
  %invariant.gep11116 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2314.010918
  %invariant.gep11118 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2314.010918
  %invariant.gep11120 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i2314.010918
  br label %B122.if.i.i

B122.if.i.i:                                      ; preds = %B122.if.i.i.preheader, %B122.if.i.i
  %.229.i.i.010915 = phi i64 [ %.300.i.i3121, %B122.if.i.i ], [ 0, %B122.if.i.i.preheader ]
  %.157.i.i.i = add nsw i64 %.155.i.i.i, %.229.i.i.010915
  %.159.i.i.i = mul nsw i64 %.157.i.i.i, %arg.shape.0
  %gep11105 = getelementptr double, ptr %invariant.gep11104, i64 %.159.i.i.i
  %.191.i.i.i = load double, ptr %gep11105, align 8, !noalias !65
  %.193.i.i.i = fadd double %.191.i.i.i, 0.000000e+00
  %.253.i.i.i = fmul double %.584.i2909, %.193.i.i.i
  %.157.i.i.i.1 = add nsw i64 %.155.i.i.i.1, %.229.i.i.010915
  %.159.i.i.i.1 = mul nsw i64 %.157.i.i.i.1, %arg.shape.0
  %gep11107 = getelementptr double, ptr %invariant.gep11106, i64 %.159.i.i.i.1
  %.191.i.i.i.1 = load double, ptr %gep11107, align 8, !noalias !65
  %.193.i.i.i.1 = fadd double %.253.i.i.i, %.191.i.i.i.1
  %.253.i.i.i.1 = fmul double %.247.i.i.i, %.193.i.i.i.1
  %.157.i.i.i.2 = add nsw i64 %.155.i.i.i.2, %.229.i.i.010915
  %.159.i.i.i.2 = mul nsw i64 %.157.i.i.i.2, %arg.shape.0
  %gep11109 = getelementptr double, ptr %invariant.gep11108, i64 %.159.i.i.i.2
  %.191.i.i.i.2 = load double, ptr %gep11109, align 8, !noalias !65
  %.193.i.i.i.2 = fadd double %.253.i.i.i.1, %.191.i.i.i.2
  %.253.i.i.i.2 = fmul double %.584.i2909, %.193.i.i.i.2
  %.157.i.i.i.3 = add nsw i64 %.155.i.i.i.3, %.229.i.i.010915
  %.159.i.i.i.3 = mul nsw i64 %.157.i.i.i.3, %arg.shape.0
  %gep11111 = getelementptr double, ptr %invariant.gep11110, i64 %.159.i.i.i.3
  %.191.i.i.i.3 = load double, ptr %gep11111, align 8, !noalias !65
  %.193.i.i.i.3 = fadd double %.253.i.i.i.2, %.191.i.i.i.3
  %.253.i.i.i.3 = fmul double %.247.i.i.i, %.193.i.i.i.3
  %.157.i.i.i.4 = add nsw i64 %.155.i.i.i.4, %.229.i.i.010915
  %.159.i.i.i.4 = mul nsw i64 %.157.i.i.i.4, %arg.shape.0
  %gep11113 = getelementptr double, ptr %invariant.gep11112, i64 %.159.i.i.i.4
  %.191.i.i.i.4 = load double, ptr %gep11113, align 8, !noalias !65
  %.193.i.i.i.4 = fadd double %.253.i.i.i.3, %.191.i.i.i.4
  %.253.i.i.i.4 = fmul double %.584.i2909, %.193.i.i.i.4
  %.157.i.i.i.5 = add nsw i64 %.155.i.i.i.5, %.229.i.i.010915
  %.159.i.i.i.5 = mul nsw i64 %.157.i.i.i.5, %arg.shape.0
  %gep11115 = getelementptr double, ptr %invariant.gep11114, i64 %.159.i.i.i.5
  %.191.i.i.i.5 = load double, ptr %gep11115, align 8, !noalias !65
  %.193.i.i.i.5 = fadd double %.253.i.i.i.4, %.191.i.i.i.5
  %.253.i.i.i.5 = fmul double %.247.i.i.i, %.193.i.i.i.5
  %.157.i.i.i.6 = add nsw i64 %.155.i.i.i.6, %.229.i.i.010915
  %.159.i.i.i.6 = mul nsw i64 %.157.i.i.i.6, %arg.shape.0
  %gep11117 = getelementptr double, ptr %invariant.gep11116, i64 %.159.i.i.i.6
  %.191.i.i.i.6 = load double, ptr %gep11117, align 8, !noalias !65
  %.193.i.i.i.6 = fadd double %.253.i.i.i.5, %.191.i.i.i.6
  %.253.i.i.i.6 = fmul double %.584.i2909, %.193.i.i.i.6
  %.300.i.i3121 = add nsw i64 %.229.i.i.010915, 1
  %.271.i.i.i = mul nsw i64 %.229.i.i.010915, %arg.shape.0
  %gep11119 = getelementptr double, ptr %invariant.gep11118, i64 %.271.i.i.i
  %.309.i.i.i = load double, ptr %gep11119, align 8, !noalias !65
  %.313.i.i.i = fadd double %.253.i.i.i.6, %.309.i.i.i
  %.359.i.i3100 = add nsw i64 %.229.i.i.010915, %.358.i.i
  %.361.i.i3101 = mul nsw i64 %.359.i.i3100, %arg.shape.0
  %gep11121 = getelementptr double, ptr %invariant.gep11120, i64 %.361.i.i3101
  store double %.313.i.i.i, ptr %gep11121, align 8, !noalias !61
  %exitcond11081.not = icmp eq i64 %arg.shape.1, %.300.i.i3121
  br i1 %exitcond11081.not, label %B222.i.loopexit, label %B122.if.i.i

B466.if.i:                                        ; preds = %B284.i, %B770.i
  %some.2.i.110923 = phi i1 [ %some.4.i.010927, %B284.i ], [ %some.3.i.2, %B770.i ]
  %.817.i2335.010922 = phi i64 [ %storemerge, %B284.i ], [ %.879.i2894, %B770.i ]
  %.814.i2334.010921 = phi i64 [ 0, %B284.i ], [ %.883.i2897, %B770.i ]
  %.879.i2894 = add nsw i64 %.817.i2335.010922, -1
  %.883.i2897 = add nsw i64 %.814.i2334.010921, 1
  %.968.i2701 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.814.i2334.010921
  %.969.i2702 = load i64, ptr %.968.i2701, align 8, !noalias !53
  %.970.i2703 = icmp sgt i64 %.969.i2702, -1
  br i1 %.970.i2703, label %B508.i, label %B770.i

B584.endif.i:                                     ; preds = %B36.i.i, %B34.i.i
  %.1099.i2343.0 = phi i64 [ %.48.i.i2177.0, %B36.i.i ], [ -1, %B34.i.i ]
  store i64 %.1099.i2343.0, ptr %.1088.i2788, align 8, !noalias !53
  %.1248.i = getelementptr double, ptr %49, i64 %.814.i2334.010921
  store double %.1187.i, ptr %.1248.i, align 8, !noalias !53
  %.1303.i = getelementptr double, ptr %50, i64 %.814.i2334.010921
  store double %.1194.i, ptr %.1303.i, align 8, !noalias !53
  br i1 %some.2.i.110923, label %B770.i, label %B732.i

B806.if.i:                                        ; preds = %B806.i.preheader, %B806.if.i
  %.1453.i.010930 = phi i64 [ %.1515.i, %B806.if.i ], [ %storemerge, %B806.i.preheader ]
  %.1450.i.010929 = phi i64 [ %.1519.i, %B806.if.i ], [ 0, %B806.i.preheader ]
  %.1515.i = add nsw i64 %.1453.i.010930, -1
  %.1519.i = add nsw i64 %.1450.i.010929, 1
  %.1596.i = getelementptr double, ptr %51, i64 %.1450.i.010929
  %.1597.i = load double, ptr %.1596.i, align 8, !noalias !53
  %.1650.i = getelementptr double, ptr %.571, i64 %.1450.i.010929
  store double %.1597.i, ptr %.1650.i, align 8, !noalias !53
  %.1506.i = icmp sgt i64 %.1453.i.010930, 1
  br i1 %.1506.i, label %B806.if.i, label %B2808

B2808:                                            ; preds = %B806.if.i, %B806.i.preheader, %B2682
  %beyond.2.1 = phi i1 [ false, %B2682 ], [ %some.2.i.1.lcssa, %B806.i.preheader ], [ %some.2.i.1.lcssa, %B806.if.i ]
  %brmerge10585 = select i1 %within.5.1, i1 true, i1 %beyond.2.1
  br i1 %brmerge10585, label %B2818, label %B3380

B2818:                                            ; preds = %B2808
  br i1 %.614, label %B2866.if, label %B3234.critedge

B140.i:                                           ; preds = %B64.if.i6071
  %.409.i5402 = getelementptr double, ptr %53, i64 %.138.i5169.010935
  %.410.i5403 = load double, ptr %.409.i5402, align 8, !noalias !69
  %.411.i5404 = fcmp uge double %.410.i5403, 5.000000e-01
  %.424.i5412.not = icmp slt i64 %.346.i5351, %arg.batch.2.5.0
  %or.cond10586 = select i1 %.411.i5404, i1 %.424.i5412.not, i1 false
  br i1 %or.cond10586, label %B216.i, label %B453.i

B216.i:                                           ; preds = %B140.i
  %.440.i = icmp slt i64 %.346.i5351, 0
  %.441.i5423 = select i1 %.440.i, i64 %arg.batch.2.5.0, i64 0
  %207 = getelementptr double, ptr %arg.batch.2.4, i64 %.346.i5351
  %.455.i5437 = getelementptr double, ptr %207, i64 %.441.i5423
  %.456.i5438 = load double, ptr %.455.i5437, align 8, !noalias !69
  %.510.i5486 = getelementptr double, ptr %54, i64 %.138.i5169.010935
  %.511.i5487 = load double, ptr %.510.i5486, align 8, !noalias !69
  %.512.i5488 = fcmp ult double %.456.i5438, %.511.i5487
  br i1 %.512.i5488, label %B268.i5489, label %B453.i

B268.i5489:                                       ; preds = %B216.i
  %.574.i5535 = getelementptr double, ptr %55, i64 %.138.i5169.010935
  %.575.i5536 = load double, ptr %.574.i5535, align 8, !noalias !69
  %.576.i5537 = fcmp ogt double %.575.i5536, 1.000000e+00
  br i1 %.576.i5537, label %B306.i5541, label %B453.i

B306.i5541:                                       ; preds = %B268.i5489
  %.632.i = getelementptr double, ptr %56, i64 %.138.i5169.010935
  %.633.i5590 = load double, ptr %.632.i, align 8, !noalias !69
  store double 0.000000e+00, ptr %.409.i5402, align 8, !noalias !73
  %.161.i.i5751 = getelementptr double, ptr %57, i64 %.138.i5169.010935
  store double 0.000000e+00, ptr %.161.i.i5751, align 8, !noalias !73
  %.214.i.i5786 = getelementptr double, ptr %58, i64 %.138.i5169.010935
  store double %.633.i5590, ptr %.214.i.i5786, align 8, !noalias !73
  %.268.i.i5819 = load i64, ptr %.290.i5304, align 8, !noalias !73
  %.294.i.i5833 = icmp slt i64 %.268.i.i5819, 0
  %.295.i.i = select i1 %.294.i.i5833, i64 %arg.batch.3.3.5.0, i64 0
  %.296.i.i5834 = add i64 %.295.i.i, %.268.i.i5819
  %.316.i.i5846 = mul i64 %.296.i.i5834, %arg.batch.3.3.5.1
  %.320.i.i5847 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.316.i.i5846
  %.321.i.i5848 = load i64, ptr %.320.i.i5847, align 8, !noalias !73
  %.322.i.i5849 = add nsw i64 %.321.i.i5848, -1
  store i64 %.322.i.i5849, ptr %.320.i.i5847, align 8, !noalias !73
  %.426.i.i5895 = load i64, ptr %.290.i5304, align 8, !noalias !73
  %.452.i.i = icmp slt i64 %.426.i.i5895, 0
  %.453.i.i = select i1 %.452.i.i, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i = add i64 %.453.i.i, %.426.i.i5895
  %.474.i.i = mul i64 %.454.i.i, %arg.batch.3.3.5.1
  %208 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i
  %.478.i.i = getelementptr i8, ptr %208, i64 24
  %.479.i.i = load i64, ptr %.478.i.i, align 8, !noalias !73
  %.480.i.i = add nsw i64 %.479.i.i, 1
  store i64 %.480.i.i, ptr %.478.i.i, align 8, !noalias !73
  %.705.i5925 = load double, ptr %.455.i5437, align 8, !noalias !69
  %.763.i5974 = getelementptr double, ptr %59, i64 %.138.i5169.010935
  store double %.705.i5925, ptr %.763.i5974, align 8, !noalias !69
  %.816.i6018 = mul i64 %.291.i5305, %arg.batch.3.3.5.1
  %209 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.816.i6018
  %.820.i6022 = getelementptr i8, ptr %209, i64 8
  %.821.i6023 = load i64, ptr %.820.i6022, align 8, !noalias !69
  %.822.i6024 = add nsw i64 %.821.i6023, 3
  store i64 %.822.i6024, ptr %.820.i6022, align 8, !noalias !69
  br label %B453.i

B453.i:                                           ; preds = %B268.i5489, %B306.i5541, %B64.if.i6071, %B140.i, %B216.i
  %.196.i5238 = icmp sgt i64 %.141.i5170.010934, 1
  br i1 %.196.i5238, label %B64.if.i6071, label %B3234

B64.if.i6071:                                     ; preds = %B2866.if, %B453.i
  %.138.i5169.010935 = phi i64 [ %.209.i6078, %B453.i ], [ 0, %B2866.if ]
  %.141.i5170.010934 = phi i64 [ %.205.i6075, %B453.i ], [ %storemerge, %B2866.if ]
  %.205.i6075 = add nsw i64 %.141.i5170.010934, -1
  %.209.i6078 = add nsw i64 %.138.i5169.010935, 1
  %.290.i5304 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.138.i5169.010935
  %.291.i5305 = load i64, ptr %.290.i5304, align 8, !noalias !69
  %.345.i5350 = getelementptr i64, ptr %52, i64 %.138.i5169.010935
  %.346.i5351 = load i64, ptr %.345.i5350, align 8, !noalias !69
  %.354.i5355 = icmp slt i64 %.291.i5305, 0
  br i1 %.354.i5355, label %B453.i, label %B140.i

B3234.critedge:                                   ; preds = %B2818
  %.4563.c = load i64, ptr %.4562.c, align 8
  %.4608.c = inttoptr i64 %.4563.c to ptr
  tail call void %.4608.c(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3234

B3234:                                            ; preds = %B453.i, %B2866.if, %B3234.critedge
  br i1 %beyond.2.1, label %B108.i3530.preheader, label %B3318

B108.i3530.preheader:                             ; preds = %B3234
  br i1 %.689, label %B188.if.i4982.preheader, label %B108.if.i5047

B186.i3583.loopexit.critedge:                     ; preds = %B188.if.i4982
  %.625.i3808.c = icmp ult i64 %.361.i3402.010953, 8
  %.10587.c = select i1 %.625.i3808.c, i64 16, i64 17
  %.672.i3841.c = load i64, ptr %.671.i3840, align 8, !noalias !76
  %.744.i3898.c = mul i64 %.742.i3896, %.10587.c
  %.762.i3908.c = getelementptr double, ptr %arg.batch.5.0.4, i64 %.744.i3898.c
  %.788.i3918.c = inttoptr i64 %.672.i3841.c to ptr
  tail call void %.788.i3918.c(ptr %.571, ptr %.762.i3908.c, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !76
  br label %B186.i3583.loopexit

B186.i3583.loopexit:                              ; preds = %B770.i4028, %B186.i3583.loopexit.critedge
  %some.2.i3425.1.lcssa = phi i1 [ %some.4.i3398.010955, %B186.i3583.loopexit.critedge ], [ %some.3.i3446.2, %B770.i4028 ]
  %exitcond11087.not = icmp eq i64 %.431.i4990, 9
  br i1 %exitcond11087.not, label %B806.i3641.preheader, label %B188.if.i4982

B806.i3641.preheader:                             ; preds = %B186.i3583.loopexit
  br i1 %.689, label %B3238.endif.endif, label %B806.if.i3737

B222.i3790.loopexit:                              ; preds = %B122.if.i.i4950, %B222.if.i4965
  %.539.i3795 = icmp sgt i64 %.486.i3415.010947, 1
  br i1 %.539.i3795, label %B222.if.i4965, label %B284.i3804

B284.i3804:                                       ; preds = %B222.i3790.loopexit
  %.625.i3808 = icmp ult i64 %.361.i3402.010953, 8
  %.10587 = select i1 %.625.i3808, i64 16, i64 17
  %.672.i3841 = load i64, ptr %.671.i3840, align 8, !noalias !76
  %.744.i3898 = mul i64 %.742.i3896, %.10587
  %.762.i3908 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.744.i3898
  %.788.i3918 = inttoptr i64 %.672.i3841 to ptr
  tail call void %.788.i3918(ptr %.571, ptr %.762.i3908, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !76
  %.1181.i4271 = add nsw i64 %.361.i3402.010953, -1
  %.1182.i4272 = sitofp i64 %.1181.i4271 to double
  %.1187.i4273 = fmul double %.1182.i4272, 1.250000e-01
  %.1189.i4275 = uitofp i64 %.361.i3402.010953 to double
  %.1194.i4276 = fmul double %.1189.i4275, 1.250000e-01
  br label %B466.if.i4466

B508.i4033:                                       ; preds = %B466.if.i4466
  %.1028.i4082 = getelementptr double, ptr %62, i64 %.814.i3438.010949
  %.1029.i4083 = load double, ptr %.1028.i4082, align 8, !noalias !76
  %.1030.i4084 = fcmp ogt double %.1029.i4083, 5.000000e-01
  br i1 %.1030.i4084, label %B546.i4085, label %B770.i4028

B546.i4085:                                       ; preds = %B508.i4033
  %.1088.i4134 = getelementptr i64, ptr %63, i64 %.814.i3438.010949
  %.1089.i4135 = load i64, ptr %.1088.i4134, align 8, !noalias !76
  %.1090.i4136 = icmp slt i64 %.1089.i4135, 0
  br i1 %.1090.i4136, label %B34.i.i4193, label %B770.i4028

B34.i.i4193:                                      ; preds = %B546.i4085, %B36.i.i4409
  %.48.i.i3224.0 = phi i64 [ %.119.i88.i4457, %B36.i.i4409 ], [ 0, %B546.i4085 ]
  %exitcond11086.not = icmp eq i64 %.48.i.i3224.0, %storemerge10530
  br i1 %exitcond11086.not, label %B584.endif.i4225, label %B36.i.i4409

B36.i.i4409:                                      ; preds = %B34.i.i4193
  %.119.i88.i4457 = add i64 %.48.i.i3224.0, 1
  %.149.i53.i4415 = add nsw i64 %.48.i.i3224.0, %arg.shape.6
  %.151.i55.i4417 = mul nsw i64 %.149.i53.i4415, %arg.shape.0
  %.153.i56.i4419 = add nsw i64 %.151.i55.i4417, %.814.i3438.010949
  %.167.i61.i4427 = icmp slt i64 %.153.i56.i4419, 0
  %.168.i62.i4428 = select i1 %.167.i61.i4427, i64 %arg.batch.5.4.5.0, i64 0
  %210 = getelementptr double, ptr %arg.batch.5.4.4, i64 %.153.i56.i4419
  %.182.i74.i4438 = getelementptr double, ptr %210, i64 %.168.i62.i4428
  %.183.i75.i4439 = load double, ptr %.182.i74.i4438, align 8, !noalias !80
  %.184.i.i4440 = fcmp ogt double %.183.i75.i4439, 5.000000e-01
  br i1 %.184.i.i4440, label %B584.endif.i4225, label %B34.i.i4193

B732.i4355:                                       ; preds = %B584.endif.i4225
  %.1369.i4394 = load i64, ptr %.1088.i4134, align 8, !noalias !76
  %.1370.i4395 = icmp sgt i64 %.1369.i4394, -1
  br label %B770.i4028

B770.i4028:                                       ; preds = %B732.i4355, %B584.endif.i4225, %B546.i4085, %B508.i4033, %B466.if.i4466
  %some.3.i3446.2 = phi i1 [ %some.2.i3425.110951, %B466.if.i4466 ], [ %some.2.i3425.110951, %B546.i4085 ], [ %some.2.i3425.110951, %B508.i4033 ], [ true, %B584.endif.i4225 ], [ %.1370.i4395, %B732.i4355 ]
  %.870.i3958 = icmp sgt i64 %.817.i3439.010950, 1
  br i1 %.870.i3958, label %B466.if.i4466, label %B186.i3583.loopexit

B108.if.i5047:                                    ; preds = %B108.i3530.preheader, %B108.if.i5047
  %.179.i3389.010938 = phi i64 [ %.243.i5052, %B108.if.i5047 ], [ %storemerge, %B108.i3530.preheader ]
  %.176.i3388.010937 = phi i64 [ %.247.i5055, %B108.if.i5047 ], [ 0, %B108.i3530.preheader ]
  %.243.i5052 = add nsw i64 %.179.i3389.010938, -1
  %.247.i5055 = add nsw i64 %.176.i3388.010937, 1
  %211 = getelementptr i64, ptr %60, i64 %.176.i3388.010937
  store i64 -1, ptr %211, align 8, !noalias !76
  %.234.i3535 = icmp sgt i64 %.179.i3389.010938, 1
  br i1 %.234.i3535, label %B108.if.i5047, label %B188.if.i4982.preheader

B188.if.i4982.preheader:                          ; preds = %B108.if.i5047, %B108.i3530.preheader
  br label %B188.if.i4982

B188.if.i4982:                                    ; preds = %B188.if.i4982.preheader, %B186.i3583.loopexit
  %some.4.i3398.010955 = phi i1 [ %some.2.i3425.1.lcssa, %B186.i3583.loopexit ], [ false, %B188.if.i4982.preheader ]
  %.361.i3402.010953 = phi i64 [ %.431.i4990, %B186.i3583.loopexit ], [ 1, %B188.if.i4982.preheader ]
  %.431.i4990 = add nsw i64 %.361.i3402.010953, 1
  br i1 %.689, label %B186.i3583.loopexit.critedge, label %B222.if.i4965.lr.ph

B222.if.i4965.lr.ph:                              ; preds = %B188.if.i4982
  %.579.i4489 = uitofp i64 %.361.i3402.010953 to double
  %.584.i4490 = fmul double %.579.i4489, 1.250000e-01
  %.247.i.i.i4920 = fsub double 1.000000e+00, %.584.i4490
  br label %B222.if.i4965

B222.if.i4965:                                    ; preds = %B222.if.i4965.lr.ph, %B222.i3790.loopexit
  %.486.i3415.010947 = phi i64 [ %storemerge, %B222.if.i4965.lr.ph ], [ %.548.i4970, %B222.i3790.loopexit ]
  %.483.i3414.010946 = phi i64 [ 0, %B222.if.i4965.lr.ph ], [ %.552.i4973, %B222.i3790.loopexit ]
  %.548.i4970 = add nsw i64 %.486.i3415.010947, -1
  %.552.i4973 = add nsw i64 %.483.i3414.010946, 1
  %.92.i.i4570 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.483.i3414.010946
  %.93.i.i4571 = load double, ptr %.92.i.i4570, align 8, !noalias !84
  %.146.i.i4607 = getelementptr double, ptr %61, i64 %.483.i3414.010946
  %.147.i.i4608 = load double, ptr %.146.i.i4607, align 8, !noalias !84
  %.149.i.i4610 = fmul double %.584.i4490, %.147.i.i4608
  %.150.i.i4611 = fadd double %.93.i.i4571, %.149.i.i4610
  %.203.i.i4647 = getelementptr double, ptr %.571, i64 %.483.i3414.010946
  store double %.150.i.i4611, ptr %.203.i.i4647, align 8, !noalias !84
  br i1 %.287.i.i468410942.not, label %B222.i3790.loopexit, label %B122.if.i.i4950.preheader

B122.if.i.i4950.preheader:                        ; preds = %B222.if.i4965
  %invariant.gep11122 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3414.010946
  %invariant.gep11124 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3414.010946
  %invariant.gep11126 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3414.010946
  %invariant.gep11128 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3414.010946
  %invariant.gep11130 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3414.010946
  %invariant.gep11132 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3414.010946
  %invariant.gep11134 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3414.010946
  %invariant.gep11136 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3414.010946
  %invariant.gep11138 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.483.i3414.010946
  br label %B122.if.i.i4950

B122.if.i.i4950:                                  ; preds = %B122.if.i.i4950.preheader, %B122.if.i.i4950
  %.229.i.i3273.010943 = phi i64 [ %.300.i.i4956, %B122.if.i.i4950 ], [ 0, %B122.if.i.i4950.preheader ]
  %.157.i.i.i4877 = add nsw i64 %.155.i.i.i4875, %.229.i.i3273.010943
  %.159.i.i.i4879 = mul nsw i64 %.157.i.i.i4877, %arg.shape.0
  %gep11123 = getelementptr double, ptr %invariant.gep11122, i64 %.159.i.i.i4879
  %.191.i.i.i4901 = load double, ptr %gep11123, align 8, !noalias !88
  %.193.i.i.i4903 = fadd double %.191.i.i.i4901, 0.000000e+00
  %.253.i.i.i4925 = fmul double %.584.i4490, %.193.i.i.i4903
  %.157.i.i.i4877.1 = add nsw i64 %.155.i.i.i4875.1, %.229.i.i3273.010943
  %.159.i.i.i4879.1 = mul nsw i64 %.157.i.i.i4877.1, %arg.shape.0
  %gep11125 = getelementptr double, ptr %invariant.gep11124, i64 %.159.i.i.i4879.1
  %.191.i.i.i4901.1 = load double, ptr %gep11125, align 8, !noalias !88
  %.193.i.i.i4903.1 = fadd double %.253.i.i.i4925, %.191.i.i.i4901.1
  %.253.i.i.i4925.1 = fmul double %.247.i.i.i4920, %.193.i.i.i4903.1
  %.157.i.i.i4877.2 = add nsw i64 %.155.i.i.i4875.2, %.229.i.i3273.010943
  %.159.i.i.i4879.2 = mul nsw i64 %.157.i.i.i4877.2, %arg.shape.0
  %gep11127 = getelementptr double, ptr %invariant.gep11126, i64 %.159.i.i.i4879.2
  %.191.i.i.i4901.2 = load double, ptr %gep11127, align 8, !noalias !88
  %.193.i.i.i4903.2 = fadd double %.253.i.i.i4925.1, %.191.i.i.i4901.2
  %.253.i.i.i4925.2 = fmul double %.584.i4490, %.193.i.i.i4903.2
  %.157.i.i.i4877.3 = add nsw i64 %.155.i.i.i4875.3, %.229.i.i3273.010943
  %.159.i.i.i4879.3 = mul nsw i64 %.157.i.i.i4877.3, %arg.shape.0
  %gep11129 = getelementptr double, ptr %invariant.gep11128, i64 %.159.i.i.i4879.3
  %.191.i.i.i4901.3 = load double, ptr %gep11129, align 8, !noalias !88
  %.193.i.i.i4903.3 = fadd double %.253.i.i.i4925.2, %.191.i.i.i4901.3
  %.253.i.i.i4925.3 = fmul double %.247.i.i.i4920, %.193.i.i.i4903.3
  %.157.i.i.i4877.4 = add nsw i64 %.155.i.i.i4875.4, %.229.i.i3273.010943
  %.159.i.i.i4879.4 = mul nsw i64 %.157.i.i.i4877.4, %arg.shape.0
  %gep11131 = getelementptr double, ptr %invariant.gep11130, i64 %.159.i.i.i4879.4
  %.191.i.i.i4901.4 = load double, ptr %gep11131, align 8, !noalias !88
  %.193.i.i.i4903.4 = fadd double %.253.i.i.i4925.3, %.191.i.i.i4901.4
  %.253.i.i.i4925.4 = fmul double %.584.i4490, %.193.i.i.i4903.4
  %.157.i.i.i4877.5 = add nsw i64 %.155.i.i.i4875.5, %.229.i.i3273.010943
  %.159.i.i.i4879.5 = mul nsw i64 %.157.i.i.i4877.5, %arg.shape.0
  %gep11133 = getelementptr double, ptr %invariant.gep11132, i64 %.159.i.i.i4879.5
  %.191.i.i.i4901.5 = load double, ptr %gep11133, align 8, !noalias !88
  %.193.i.i.i4903.5 = fadd double %.253.i.i.i4925.4, %.191.i.i.i4901.5
  %.253.i.i.i4925.5 = fmul double %.247.i.i.i4920, %.193.i.i.i4903.5
  %.157.i.i.i4877.6 = add nsw i64 %.155.i.i.i4875.6, %.229.i.i3273.010943
  %.159.i.i.i4879.6 = mul nsw i64 %.157.i.i.i4877.6, %arg.shape.0
  %gep11135 = getelementptr double, ptr %invariant.gep11134, i64 %.159.i.i.i4879.6
  %.191.i.i.i4901.6 = load double, ptr %gep11135, align 8, !noalias !88
  %.193.i.i.i4903.6 = fadd double %.253.i.i.i4925.5, %.191.i.i.i4901.6
  %.253.i.i.i4925.6 = fmul double %.584.i4490, %.193.i.i.i4903.6
  %.300.i.i4956 = add nsw i64 %.229.i.i3273.010943, 1
  %.271.i.i.i4798 = mul nsw i64 %.229.i.i3273.010943, %arg.shape.0
  %gep11137 = getelementptr double, ptr %invariant.gep11136, i64 %.271.i.i.i4798
  %.309.i.i.i4823 = load double, ptr %gep11137, align 8, !noalias !88
  %.313.i.i.i4826 = fadd double %.253.i.i.i4925.6, %.309.i.i.i4823
  %.359.i.i4839 = add nsw i64 %.229.i.i3273.010943, %.358.i.i4838
  %.361.i.i4841 = mul nsw i64 %.359.i.i4839, %arg.shape.0
  %gep11139 = getelementptr double, ptr %invariant.gep11138, i64 %.361.i.i4841
  store double %.313.i.i.i4826, ptr %gep11139, align 8, !noalias !84
  %exitcond11085.not = icmp eq i64 %arg.shape.1, %.300.i.i4956
  br i1 %exitcond11085.not, label %B222.i3790.loopexit, label %B122.if.i.i4950

B466.if.i4466:                                    ; preds = %B284.i3804, %B770.i4028
  %some.2.i3425.110951 = phi i1 [ %some.4.i3398.010955, %B284.i3804 ], [ %some.3.i3446.2, %B770.i4028 ]
  %.817.i3439.010950 = phi i64 [ %storemerge, %B284.i3804 ], [ %.879.i4470, %B770.i4028 ]
  %.814.i3438.010949 = phi i64 [ 0, %B284.i3804 ], [ %.883.i4473, %B770.i4028 ]
  %.879.i4470 = add nsw i64 %.817.i3439.010950, -1
  %.883.i4473 = add nsw i64 %.814.i3438.010949, 1
  %.968.i4025 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.814.i3438.010949
  %.969.i4026 = load i64, ptr %.968.i4025, align 8, !noalias !76
  %.970.i4027 = icmp sgt i64 %.969.i4026, -1
  br i1 %.970.i4027, label %B508.i4033, label %B770.i4028

B584.endif.i4225:                                 ; preds = %B36.i.i4409, %B34.i.i4193
  %.1099.i3451.0 = phi i64 [ %.48.i.i3224.0, %B36.i.i4409 ], [ -1, %B34.i.i4193 ]
  store i64 %.1099.i3451.0, ptr %.1088.i4134, align 8, !noalias !76
  %.1248.i4313 = getelementptr double, ptr %64, i64 %.814.i3438.010949
  store double %.1187.i4273, ptr %.1248.i4313, align 8, !noalias !76
  %.1303.i4350 = getelementptr double, ptr %65, i64 %.814.i3438.010949
  store double %.1194.i4276, ptr %.1303.i4350, align 8, !noalias !76
  br i1 %some.2.i3425.110951, label %B770.i4028, label %B732.i4355

B806.if.i3737:                                    ; preds = %B806.i3641.preheader, %B806.if.i3737
  %.1453.i3462.010958 = phi i64 [ %.1515.i3740, %B806.if.i3737 ], [ %storemerge, %B806.i3641.preheader ]
  %.1450.i3461.010957 = phi i64 [ %.1519.i3743, %B806.if.i3737 ], [ 0, %B806.i3641.preheader ]
  %.1515.i3740 = add nsw i64 %.1453.i3462.010958, -1
  %.1519.i3743 = add nsw i64 %.1450.i3461.010957, 1
  %.1596.i3699 = getelementptr double, ptr %66, i64 %.1450.i3461.010957
  %.1597.i3700 = load double, ptr %.1596.i3699, align 8, !noalias !76
  %.1650.i3736 = getelementptr double, ptr %.571, i64 %.1450.i3461.010957
  store double %.1597.i3700, ptr %.1650.i3736, align 8, !noalias !76
  %.1506.i3646 = icmp sgt i64 %.1453.i3462.010958, 1
  br i1 %.1506.i3646, label %B806.if.i3737, label %B3238.endif.endif

B3276:                                            ; preds = %B3238.endif.endif
  %.222.i = load double, ptr %.221.i, align 8, !noalias !92
  %.251.i = load double, ptr %arg.batch.2.4, align 8, !noalias !92
  %.252.i = fsub double %.222.i, %.251.i
  %.253.i = fmul double %.252.i, 1.000000e-13
  br i1 %.689, label %B150.if.i.i.preheader, label %B70.if.i.i.preheader

B70.if.i.i.preheader:                             ; preds = %B3276
  tail call void @llvm.memset.p0.i64(ptr align 8 %68, i8 0, i64 %126, i1 false), !noalias !95
  br label %B150.if.i.i.preheader

B150.if.i.i.preheader:                            ; preds = %B70.if.i.i.preheader, %B3276
  br label %B150.if.i.i

B148.i.loopexit.i:                                ; preds = %B928.i.loopexit.i, %B294.endif.endif.i.i
  %exitcond2952.not.i = icmp eq i64 %.417.i.i, 9
  br i1 %exitcond2952.not.i, label %B220.preheader.i, label %B150.if.i.i

B220.preheader.i:                                 ; preds = %B148.i.loopexit.i
  br i1 %.689, label %B478.preheader.i, label %B220.if.i

B184.i.loopexit.i:                                ; preds = %B122.if.i.i.i, %B184.if.i.i
  %exitcond2947.not.i = icmp eq i64 %arg.shape.0, %.538.i.i
  br i1 %exitcond2947.not.i, label %B246.i.i, label %B184.if.i.i

B246.i.i:                                         ; preds = %B184.i.loopexit.i, %B150.if.i.i
  %.611.i.i = icmp ult i64 %.347.i.02919.i, 8
  %..i10635 = select i1 %.611.i.i, i64 16, i64 17
  %.628.i.i = mul i64 %..i10635, %.463
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
  br i1 %.689, label %B246.i.i, label %B184.if.i.lr.ph.i

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
  %.150.i.i.i10634 = fadd double %.93.i.i.i, %.149.i.i.i
  %.203.i.i.i = getelementptr double, ptr %.571, i64 %.469.i.02904.i
  store double %.150.i.i.i10634, ptr %.203.i.i.i, align 8, !noalias !103
  br i1 %.287.i.i2900.not.i, label %B184.i.loopexit.i, label %B122.if.i.i.preheader.i

B122.if.i.i.preheader.i:                          ; preds = %B184.if.i.i
  %invariant.gep10959 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10961 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10963 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10965 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10967 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10969 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10971 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10973 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  %invariant.gep10975 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.469.i.02904.i
  br label %B122.if.i.i.i

B122.if.i.i.i:                                    ; preds = %B122.if.i.i.i, %B122.if.i.i.preheader.i
  %.229.i.i.02901.i = phi i64 [ %.300.i.i.i, %B122.if.i.i.i ], [ 0, %B122.if.i.i.preheader.i ]
  %.157.i.i.i.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.i
  %.159.i.i.i.i = mul nsw i64 %.157.i.i.i.i, %arg.shape.0
  %gep10960 = getelementptr double, ptr %invariant.gep10959, i64 %.159.i.i.i.i
  %.191.i.i.i.i = load double, ptr %gep10960, align 8, !noalias !107
  %.193.i.i.i.i = fadd double %.191.i.i.i.i, 0.000000e+00
  %.253.i.i.i.i = fmul double %.570.i.i, %.193.i.i.i.i
  %.157.i.i.i.1.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.1.i
  %.159.i.i.i.1.i = mul nsw i64 %.157.i.i.i.1.i, %arg.shape.0
  %gep10962 = getelementptr double, ptr %invariant.gep10961, i64 %.159.i.i.i.1.i
  %.191.i.i.i.1.i = load double, ptr %gep10962, align 8, !noalias !107
  %.193.i.i.i.1.i = fadd double %.191.i.i.i.1.i, %.253.i.i.i.i
  %.253.i.i.i.1.i = fmul double %.247.i.i.i.i, %.193.i.i.i.1.i
  %.157.i.i.i.2.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.2.i
  %.159.i.i.i.2.i = mul nsw i64 %.157.i.i.i.2.i, %arg.shape.0
  %gep10964 = getelementptr double, ptr %invariant.gep10963, i64 %.159.i.i.i.2.i
  %.191.i.i.i.2.i = load double, ptr %gep10964, align 8, !noalias !107
  %.193.i.i.i.2.i = fadd double %.191.i.i.i.2.i, %.253.i.i.i.1.i
  %.253.i.i.i.2.i = fmul double %.570.i.i, %.193.i.i.i.2.i
  %.157.i.i.i.3.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.3.i
  %.159.i.i.i.3.i = mul nsw i64 %.157.i.i.i.3.i, %arg.shape.0
  %gep10966 = getelementptr double, ptr %invariant.gep10965, i64 %.159.i.i.i.3.i
  %.191.i.i.i.3.i = load double, ptr %gep10966, align 8, !noalias !107
  %.193.i.i.i.3.i = fadd double %.191.i.i.i.3.i, %.253.i.i.i.2.i
  %.253.i.i.i.3.i = fmul double %.247.i.i.i.i, %.193.i.i.i.3.i
  %.157.i.i.i.4.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.4.i
  %.159.i.i.i.4.i = mul nsw i64 %.157.i.i.i.4.i, %arg.shape.0
  %gep10968 = getelementptr double, ptr %invariant.gep10967, i64 %.159.i.i.i.4.i
  %.191.i.i.i.4.i = load double, ptr %gep10968, align 8, !noalias !107
  %.193.i.i.i.4.i = fadd double %.191.i.i.i.4.i, %.253.i.i.i.3.i
  %.253.i.i.i.4.i = fmul double %.570.i.i, %.193.i.i.i.4.i
  %.157.i.i.i.5.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.5.i
  %.159.i.i.i.5.i = mul nsw i64 %.157.i.i.i.5.i, %arg.shape.0
  %gep10970 = getelementptr double, ptr %invariant.gep10969, i64 %.159.i.i.i.5.i
  %.191.i.i.i.5.i = load double, ptr %gep10970, align 8, !noalias !107
  %.193.i.i.i.5.i = fadd double %.191.i.i.i.5.i, %.253.i.i.i.4.i
  %.253.i.i.i.5.i = fmul double %.247.i.i.i.i, %.193.i.i.i.5.i
  %.157.i.i.i.6.i = add nsw i64 %.229.i.i.02901.i, %.155.i.i.i.6.i
  %.159.i.i.i.6.i = mul nsw i64 %.157.i.i.i.6.i, %arg.shape.0
  %gep10972 = getelementptr double, ptr %invariant.gep10971, i64 %.159.i.i.i.6.i
  %.191.i.i.i.6.i = load double, ptr %gep10972, align 8, !noalias !107
  %.193.i.i.i.6.i = fadd double %.191.i.i.i.6.i, %.253.i.i.i.5.i
  %.253.i.i.i.6.i = fmul double %.570.i.i, %.193.i.i.i.6.i
  %.300.i.i.i = add nsw i64 %.229.i.i.02901.i, 1
  %.271.i.i.i.i = mul nsw i64 %.229.i.i.02901.i, %arg.shape.0
  %gep10974 = getelementptr double, ptr %invariant.gep10973, i64 %.271.i.i.i.i
  %.309.i.i.i.i = load double, ptr %gep10974, align 8, !noalias !107
  %.313.i.i.i.i = fadd double %.309.i.i.i.i, %.253.i.i.i.6.i
  %.359.i.i.i = add nsw i64 %.229.i.i.02901.i, %.358.i.i.i
  %.361.i.i.i = mul nsw i64 %.359.i.i.i, %arg.shape.0
  %gep10976 = getelementptr double, ptr %invariant.gep10975, i64 %.361.i.i.i
  store double %.313.i.i.i.i, ptr %gep10976, align 8, !noalias !103
  %exitcond2946.not.i = icmp eq i64 %arg.shape.1, %.300.i.i.i
  br i1 %exitcond2946.not.i, label %B184.i.loopexit.i, label %B122.if.i.i.i

B294.endif.i.i:                                   ; preds = %B34.if.i.i.i
  %.985.i.i10636 = load i64, ptr %.984.i.i10633, align 8, !noalias !95
  %.1097.i.i10637 = inttoptr i64 %.985.i.i10636 to ptr
  tail call void %.1097.i.i10637(ptr %.571, ptr %.744.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !95
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
  %.985.i.i10636.c = load i64, ptr %.984.i.i10633, align 8, !noalias !95
  %.1097.i.i10637.c = inttoptr i64 %.985.i.i10636.c to ptr
  tail call void %.1097.i.i10637.c(ptr %.571, ptr %.744.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !95
  %.1128.i.i.c = load i64, ptr %arg.code.4, align 8, !noalias !95
  %.1244.i.i.c = inttoptr i64 %.1128.i.i.c to ptr
  tail call void %.1244.i.i.c(ptr %.571, ptr %.744.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.1243.i.i), !noalias !95
  br label %B294.endif.endif.i.i

B294.endif.endif.i.i:                             ; preds = %B34.if.i321.i.i, %B294.endif.endif.i.i.critedge
  %.1312.i.i = load i64, ptr %.984.i.i10633, align 8, !noalias !95
  %.1424.i.i = inttoptr i64 %.1312.i.i to ptr
  tail call void %.1424.i.i(ptr %.571, ptr %.744.i.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !95
  br i1 %.689, label %B148.i.loopexit.i, label %B928.if.i.i

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
  %.10.i.i.i10638 = fcmp ogt double %.1897.i..i, %.1975.i.i
  %.11.i.i.i10639 = select i1 %.10.i.i.i10638, double %.1897.i..i, double %.1975.i.i
  store double %.11.i.i.i10639, ptr %.1974.i.i, align 8, !noalias !95
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
  br i1 %.586.i, label %B1557.i, label %B34.i.i10653

B34.i.i10653:                                     ; preds = %B262.i, %B34.if.i.i10654
  %.48.i.0.i = phi i64 [ %.119.i60.i, %B34.if.i.i10654 ], [ 0, %B262.i ]
  %exitcond2953.not.i = icmp eq i64 %.48.i.0.i, %storemerge2877.i
  br i1 %exitcond2953.not.i, label %B364.endif.i, label %B34.if.i.i10654

B80.i.i10655:                                     ; preds = %B34.if.i.i10654
  %221 = icmp sgt i64 %.48.i.0.i, -1
  %222 = select i1 %221, double 1.000000e+00, double 0.000000e+00
  br label %B364.endif.i

B34.if.i.i10654:                                  ; preds = %B34.i.i10653
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
  br i1 %.184.i54.i, label %B80.i.i10655, label %B34.i.i10653

B478.loopexit.i.critedge:                         ; preds = %B480.if.i
  %.1184.i.c = load i64, ptr %.657.i.i, align 8, !noalias !92
  %.1300.i.c = inttoptr i64 %.1184.i.c to ptr
  tail call void %.1300.i.c(ptr %.571, ptr %.1274.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !92
  br label %B478.loopexit.i

B478.loopexit.i:                                  ; preds = %B1559.i, %B478.loopexit.i.critedge
  %.849.i = icmp sgt i64 %.795.02939.i, 1
  br i1 %.849.i, label %B480.if.i, label %B1058.preheader.i

B1058.preheader.i:                                ; preds = %B478.loopexit.i, %B478.preheader.i
  br i1 %.689, label %B3318, label %B1058.if.lr.ph.i

B1058.if.lr.ph.i:                                 ; preds = %B1058.preheader.i
  %.2389.i = fmul double %.253.i, 2.000000e+00
  br label %B1058.if.i

B514.loopexit.i:                                  ; preds = %B122.if.i.i10650, %B514.if.i
  %exitcond2957.not.i = icmp eq i64 %arg.shape.0, %.980.i
  br i1 %exitcond2957.not.i, label %B628.i, label %B514.if.i

B122.if.i.i10650:                                 ; preds = %B122.if.i.lr.ph.i, %B122.if.i.i10650
  %.229.i.02929.i = phi i64 [ 0, %B122.if.i.lr.ph.i ], [ %.300.i567.i, %B122.if.i.i10650 ]
  %.157.i.i501.i = add nsw i64 %.229.i.02929.i, %.155.i.i.i10649
  %.159.i.i503.i = mul nsw i64 %.157.i.i501.i, %arg.shape.0
  %gep10978 = getelementptr double, ptr %invariant.gep10977, i64 %.159.i.i503.i
  %.191.i.i523.i = load double, ptr %gep10978, align 8, !noalias !119
  %.193.i.i525.i = fadd double %.191.i.i523.i, 0.000000e+00
  %.253.i.i540.i = fmul double %.1114.i, %.193.i.i525.i
  %.157.i.i501.1.i = add nsw i64 %.229.i.02929.i, %.155.i.i.1.i
  %.159.i.i503.1.i = mul nsw i64 %.157.i.i501.1.i, %arg.shape.0
  %gep10980 = getelementptr double, ptr %invariant.gep10979, i64 %.159.i.i503.1.i
  %.191.i.i523.1.i = load double, ptr %gep10980, align 8, !noalias !119
  %.193.i.i525.1.i = fadd double %.191.i.i523.1.i, %.253.i.i540.i
  %.253.i.i540.1.i = fmul double %.247.i.i.i10648, %.193.i.i525.1.i
  %.157.i.i501.2.i = add nsw i64 %.229.i.02929.i, %.155.i.i.2.i
  %.159.i.i503.2.i = mul nsw i64 %.157.i.i501.2.i, %arg.shape.0
  %gep10982 = getelementptr double, ptr %invariant.gep10981, i64 %.159.i.i503.2.i
  %.191.i.i523.2.i = load double, ptr %gep10982, align 8, !noalias !119
  %.193.i.i525.2.i = fadd double %.191.i.i523.2.i, %.253.i.i540.1.i
  %.253.i.i540.2.i = fmul double %.1114.i, %.193.i.i525.2.i
  %.157.i.i501.3.i = add nsw i64 %.229.i.02929.i, %.155.i.i.3.i
  %.159.i.i503.3.i = mul nsw i64 %.157.i.i501.3.i, %arg.shape.0
  %gep10984 = getelementptr double, ptr %invariant.gep10983, i64 %.159.i.i503.3.i
  %.191.i.i523.3.i = load double, ptr %gep10984, align 8, !noalias !119
  %.193.i.i525.3.i = fadd double %.191.i.i523.3.i, %.253.i.i540.2.i
  %.253.i.i540.3.i = fmul double %.247.i.i.i10648, %.193.i.i525.3.i
  %.157.i.i501.4.i = add nsw i64 %.229.i.02929.i, %.155.i.i.4.i
  %.159.i.i503.4.i = mul nsw i64 %.157.i.i501.4.i, %arg.shape.0
  %gep10986 = getelementptr double, ptr %invariant.gep10985, i64 %.159.i.i503.4.i
  %.191.i.i523.4.i = load double, ptr %gep10986, align 8, !noalias !119
  %.193.i.i525.4.i = fadd double %.191.i.i523.4.i, %.253.i.i540.3.i
  %.253.i.i540.4.i = fmul double %.1114.i, %.193.i.i525.4.i
  %.157.i.i501.5.i = add nsw i64 %.229.i.02929.i, %.155.i.i.5.i
  %.159.i.i503.5.i = mul nsw i64 %.157.i.i501.5.i, %arg.shape.0
  %gep10988 = getelementptr double, ptr %invariant.gep10987, i64 %.159.i.i503.5.i
  %.191.i.i523.5.i = load double, ptr %gep10988, align 8, !noalias !119
  %.193.i.i525.5.i = fadd double %.191.i.i523.5.i, %.253.i.i540.4.i
  %.253.i.i540.5.i = fmul double %.247.i.i.i10648, %.193.i.i525.5.i
  %.157.i.i501.6.i = add nsw i64 %.229.i.02929.i, %.155.i.i.6.i
  %.159.i.i503.6.i = mul nsw i64 %.157.i.i501.6.i, %arg.shape.0
  %gep10990 = getelementptr double, ptr %invariant.gep10989, i64 %.159.i.i503.6.i
  %.191.i.i523.6.i = load double, ptr %gep10990, align 8, !noalias !119
  %.193.i.i525.6.i = fadd double %.191.i.i523.6.i, %.253.i.i540.5.i
  %.253.i.i540.6.i = fmul double %.1114.i, %.193.i.i525.6.i
  %.300.i567.i = add nsw i64 %.229.i.02929.i, 1
  %.271.i.i451.i = mul nsw i64 %.229.i.02929.i, %arg.shape.0
  %gep10992 = getelementptr double, ptr %invariant.gep10991, i64 %.271.i.i451.i
  %.309.i.i.i10651 = load double, ptr %gep10992, align 8, !noalias !119
  %.313.i.i.i10652 = fadd double %.309.i.i.i10651, %.253.i.i540.6.i
  %.359.i.i = add nsw i64 %.229.i.02929.i, %.358.i.i.i
  %.361.i477.i = mul nsw i64 %.359.i.i, %arg.shape.0
  %gep10994 = getelementptr double, ptr %invariant.gep10993, i64 %.361.i477.i
  store double %.313.i.i.i10652, ptr %gep10994, align 8, !noalias !126
  %exitcond2956.not.i = icmp eq i64 %arg.shape.1, %.300.i567.i
  br i1 %exitcond2956.not.i, label %B514.loopexit.i, label %B122.if.i.i10650

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
  %.10.i.i10641 = fcmp ogt double %.2294.i, %.2357.i
  %.11.i.i10642 = select i1 %.10.i.i10641, double %.2294.i, double %.2357.i
  %.2353.i = fsub double 1.000000e+00, %.2352.i
  %.2355.i = fmul double %.2236.i, %.2353.i
  %.2386.i = fcmp ugt double %.2355.i, %.11.i.i10642
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
  %.452.i.i10643 = icmp slt i64 %.426.i.i, 0
  %.453.i904.i = select i1 %.452.i.i10643, i64 %arg.batch.3.3.5.0, i64 0
  %.454.i.i10644 = add i64 %.453.i904.i, %.426.i.i
  %.474.i.i10645 = mul i64 %.454.i.i10644, %arg.batch.3.3.5.1
  %226 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.474.i.i10645
  %.478.i916.i = getelementptr i8, ptr %226, i64 24
  %.479.i.i10646 = load i64, ptr %.478.i916.i, align 8, !noalias !131
  %.480.i917.i = add nsw i64 %.479.i.i10646, 1
  store i64 %.480.i917.i, ptr %.478.i916.i, align 8, !noalias !131
  br label %B1558.i

B1557.i:                                          ; preds = %B364.endif.i, %B220.if.i, %B262.i
  %halvings.3.1.i = phi i64 [ %.mux.i, %B262.i ], [ %halvings.2.02924.i, %B364.endif.i ], [ %halvings.2.02924.i, %B220.if.i ]
  %exitcond2954.not.i = icmp eq i64 %arg.shape.0, %.446.i
  br i1 %exitcond2954.not.i, label %B478.preheader.i, label %B220.if.i

B1558.i:                                          ; preds = %B1058.if.i, %B1458.i, %B1422.i, %B1150.i
  %exitcond2960.not.i = icmp eq i64 %arg.shape.0, %.1930.i
  br i1 %exitcond2960.not.i, label %B3318, label %B1058.if.i

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

B364.endif.i:                                     ; preds = %B34.i.i10653, %B80.i.i10655
  %.658.0.i = phi double [ %222, %B80.i.i10655 ], [ 0.000000e+00, %B34.i.i10653 ]
  %228 = getelementptr double, ptr %72, i64 %.377.02922.i
  store double %.658.0.i, ptr %228, align 8, !noalias !92
  br label %B1557.i

B480.if.i:                                        ; preds = %B478.preheader.i, %B478.loopexit.i
  %.795.02939.i = phi i64 [ %.858.i, %B478.loopexit.i ], [ %halvings.2.0.lcssa.i, %B478.preheader.i ]
  %.858.i = add nsw i64 %.795.02939.i, -1
  br i1 %.689, label %B478.loopexit.i.critedge, label %B514.if.i

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
  %.247.i.i.i10648 = fsub double 1.000000e+00, %.1114.i
  %invariant.gep10977 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep10979 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep10981 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep10983 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep10985 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep10987 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep10989 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep10991 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  %invariant.gep10993 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.911.02932.i
  br label %B122.if.i.i10650

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

B3318:                                            ; preds = %B1558.i, %B1058.preheader.i, %B3238.endif.endif, %B3234
  br i1 %.4830.not, label %B3380, label %B120.if.i

B120.loopexit.i.critedge:                         ; preds = %B120.if.i
  %.525.i.c = load i64, ptr %.524.i, align 8, !noalias !134
  %.641.i.c = inttoptr i64 %.525.i.c to ptr
  tail call void %.641.i.c(ptr %.571, ptr %.615.i, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !134
  br label %B120.loopexit.i

B120.loopexit.i:                                  ; preds = %B564.i, %B120.loopexit.i.critedge
  %exitcond738.not.i = icmp eq i64 %.231.0734.i, %.10588
  br i1 %exitcond738.not.i, label %B3380, label %B120.if.i

B154.loopexit.i:                                  ; preds = %B122.if.i.i10663, %B154.if.i
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
  %.89.i.i10683 = icmp sgt i64 %.84.i51.i, -1
  br i1 %.89.i.i10683, label %B46.i.i10684, label %B426.endif.i

B46.i.i10684:                                     ; preds = %B426.i
  %.120.i73.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i51.i
  %.121.i74.i = load i64, ptr %.120.i73.i, align 8, !noalias !137
  %.122.i75.i = icmp eq i64 %.121.i74.i, 0
  br i1 %.122.i75.i, label %B80.i.i10685, label %B426.endif.i

B80.i.i10685:                                     ; preds = %B46.i.i10684
  store i64 4, ptr %.120.i73.i, align 8, !noalias !137
  br label %B426.endif.i

B564.i:                                           ; preds = %B426.endif.i, %B348.if.i, %B390.i
  %exitcond737.not.i = icmp eq i64 %arg.shape.0, %.736.i10680
  br i1 %exitcond737.not.i, label %B120.loopexit.i, label %B348.if.i

B120.if.i:                                        ; preds = %B3318, %B120.loopexit.i
  %.231.0734.i = phi i64 [ %.302.i, %B120.loopexit.i ], [ 1, %B3318 ]
  %.302.i = add nsw i64 %.231.0734.i, 1
  br i1 %.689, label %B120.loopexit.i.critedge, label %B154.if.lr.ph.i

B154.if.lr.ph.i:                                  ; preds = %B120.if.i
  %.451.i = uitofp i64 %.231.0734.i to double
  %.456.i = fdiv double %.451.i, %.452.i
  %.247.i.i.i10659 = fsub double 1.000000e+00, %.456.i
  br label %B154.if.i

B154.if.i:                                        ; preds = %B154.if.lr.ph.i, %B154.loopexit.i
  %.354.0729.i = phi i64 [ 0, %B154.if.lr.ph.i ], [ %.423.i, %B154.loopexit.i ]
  %.423.i = add nsw i64 %.354.0729.i, 1
  %.92.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.354.0729.i
  %.93.i.i = load double, ptr %.92.i.i, align 8, !noalias !140
  %.146.i.i10660 = getelementptr double, ptr %84, i64 %.354.0729.i
  %.147.i.i = load double, ptr %.146.i.i10660, align 8, !noalias !140
  %.149.i.i10661 = fmul double %.456.i, %.147.i.i
  %.150.i.i = fadd double %.93.i.i, %.149.i.i10661
  %.203.i.i = getelementptr double, ptr %.571, i64 %.354.0729.i
  store double %.150.i.i, ptr %.203.i.i, align 8, !noalias !140
  br i1 %.287.i725.not.i, label %B154.loopexit.i, label %B122.if.i.preheader.i

B122.if.i.preheader.i:                            ; preds = %B154.if.i
  %invariant.gep10995 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep10997 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep10999 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep11001 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep11003 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep11005 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep11007 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep11009 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  %invariant.gep11011 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.354.0729.i
  br label %B122.if.i.i10663

B122.if.i.i10663:                                 ; preds = %B122.if.i.i10663, %B122.if.i.preheader.i
  %.229.i.0726.i = phi i64 [ %.300.i.i, %B122.if.i.i10663 ], [ 0, %B122.if.i.preheader.i ]
  %.157.i.i.i10664 = add nsw i64 %.229.i.0726.i, %.155.i.i.i10662
  %.159.i.i.i10665 = mul nsw i64 %.157.i.i.i10664, %arg.shape.0
  %gep10996 = getelementptr double, ptr %invariant.gep10995, i64 %.159.i.i.i10665
  %.191.i.i.i10666 = load double, ptr %gep10996, align 8, !noalias !144
  %.193.i.i.i10667 = fadd double %.191.i.i.i10666, 0.000000e+00
  %.253.i.i.i10668 = fmul double %.456.i, %.193.i.i.i10667
  %.157.i.i.1.i = add nsw i64 %.229.i.0726.i, %.155.i.i.1.i10669
  %.159.i.i.1.i = mul nsw i64 %.157.i.i.1.i, %arg.shape.0
  %gep10998 = getelementptr double, ptr %invariant.gep10997, i64 %.159.i.i.1.i
  %.191.i.i.1.i = load double, ptr %gep10998, align 8, !noalias !144
  %.193.i.i.1.i = fadd double %.191.i.i.1.i, %.253.i.i.i10668
  %.253.i.i.1.i = fmul double %.247.i.i.i10659, %.193.i.i.1.i
  %.157.i.i.2.i = add nsw i64 %.229.i.0726.i, %.155.i.i.2.i10670
  %.159.i.i.2.i = mul nsw i64 %.157.i.i.2.i, %arg.shape.0
  %gep11000 = getelementptr double, ptr %invariant.gep10999, i64 %.159.i.i.2.i
  %.191.i.i.2.i = load double, ptr %gep11000, align 8, !noalias !144
  %.193.i.i.2.i = fadd double %.191.i.i.2.i, %.253.i.i.1.i
  %.253.i.i.2.i = fmul double %.456.i, %.193.i.i.2.i
  %.157.i.i.3.i = add nsw i64 %.229.i.0726.i, %.155.i.i.3.i10671
  %.159.i.i.3.i = mul nsw i64 %.157.i.i.3.i, %arg.shape.0
  %gep11002 = getelementptr double, ptr %invariant.gep11001, i64 %.159.i.i.3.i
  %.191.i.i.3.i = load double, ptr %gep11002, align 8, !noalias !144
  %.193.i.i.3.i = fadd double %.191.i.i.3.i, %.253.i.i.2.i
  %.253.i.i.3.i = fmul double %.247.i.i.i10659, %.193.i.i.3.i
  %.157.i.i.4.i = add nsw i64 %.229.i.0726.i, %.155.i.i.4.i10672
  %.159.i.i.4.i = mul nsw i64 %.157.i.i.4.i, %arg.shape.0
  %gep11004 = getelementptr double, ptr %invariant.gep11003, i64 %.159.i.i.4.i
  %.191.i.i.4.i = load double, ptr %gep11004, align 8, !noalias !144
  %.193.i.i.4.i = fadd double %.191.i.i.4.i, %.253.i.i.3.i
  %.253.i.i.4.i = fmul double %.456.i, %.193.i.i.4.i
  %.157.i.i.5.i = add nsw i64 %.229.i.0726.i, %.155.i.i.5.i10673
  %.159.i.i.5.i = mul nsw i64 %.157.i.i.5.i, %arg.shape.0
  %gep11006 = getelementptr double, ptr %invariant.gep11005, i64 %.159.i.i.5.i
  %.191.i.i.5.i = load double, ptr %gep11006, align 8, !noalias !144
  %.193.i.i.5.i = fadd double %.191.i.i.5.i, %.253.i.i.4.i
  %.253.i.i.5.i = fmul double %.247.i.i.i10659, %.193.i.i.5.i
  %.157.i.i.6.i = add nsw i64 %.229.i.0726.i, %.155.i.i.6.i10674
  %.159.i.i.6.i = mul nsw i64 %.157.i.i.6.i, %arg.shape.0
  %gep11008 = getelementptr double, ptr %invariant.gep11007, i64 %.159.i.i.6.i
  %.191.i.i.6.i = load double, ptr %gep11008, align 8, !noalias !144
  %.193.i.i.6.i = fadd double %.191.i.i.6.i, %.253.i.i.5.i
  %.253.i.i.6.i = fmul double %.456.i, %.193.i.i.6.i
  %.300.i.i = add nsw i64 %.229.i.0726.i, 1
  %.271.i.i.i10675 = mul nsw i64 %.229.i.0726.i, %arg.shape.0
  %gep11010 = getelementptr double, ptr %invariant.gep11009, i64 %.271.i.i.i10675
  %.309.i.i.i10676 = load double, ptr %gep11010, align 8, !noalias !144
  %.313.i.i.i10677 = fadd double %.309.i.i.i10676, %.253.i.i.6.i
  %.359.i.i10678 = add nsw i64 %.229.i.0726.i, %.358.i.i10657
  %.361.i.i = mul nsw i64 %.359.i.i10678, %arg.shape.0
  %gep11012 = getelementptr double, ptr %invariant.gep11011, i64 %.361.i.i
  store double %.313.i.i.i10677, ptr %gep11012, align 8, !noalias !140
  %exitcond.not.i10679 = icmp eq i64 %arg.shape.1, %.300.i.i
  br i1 %exitcond.not.i10679, label %B154.loopexit.i, label %B122.if.i.i10663

B348.if.i:                                        ; preds = %B564.i, %B206.i
  %.667.0732.i = phi i64 [ 0, %B206.i ], [ %.736.i10680, %B564.i ]
  %.736.i10680 = add nsw i64 %.667.0732.i, 1
  %.817.i = getelementptr double, ptr %85, i64 %.667.0732.i
  %.818.i10681 = load double, ptr %.817.i, align 8, !noalias !134
  %.819.i = fcmp ogt double %.818.i10681, 5.000000e-01
  br i1 %.819.i, label %B390.i, label %B564.i

B426.endif.i:                                     ; preds = %B80.i.i10685, %B46.i.i10684, %B426.i
  store double 0.000000e+00, ptr %.817.i, align 8, !noalias !134
  %.1014.i = getelementptr double, ptr %86, i64 %.667.0732.i
  store double %.952.i, ptr %.1014.i, align 8, !noalias !134
  %.1071.i = getelementptr double, ptr %87, i64 %.667.0732.i
  store double %.960.i, ptr %.1071.i, align 8, !noalias !134
  br label %B564.i

B3380:                                            ; preds = %B120.loopexit.i, %B2808, %B3318
  %brmerge10590.not = and i1 %good.2.1.lcssa, %looked.2.1.lcssa
  br i1 %brmerge10590.not, label %B3388, label %B3440

B3388:                                            ; preds = %B3380
  %brmerge10591.not = select i1 %within.5.1, i1 %.614, i1 false
  %"$phi3424.7.2.2" = select i1 %brmerge10591.not, i64 3, i64 0
  br i1 %.689, label %B3440, label %B96.if.i

B172.i:                                           ; preds = %B96.if.i
  %.452.i10690 = getelementptr double, ptr %89, i64 %.180.0654.i
  %.453.i10691 = load double, ptr %.452.i10690, align 8, !noalias !148
  %.454.i10692 = fcmp olt double %.453.i10691, 5.000000e-01
  br i1 %.454.i10692, label %B789.i, label %B210.i

B210.i:                                           ; preds = %B172.i
  %.485.i10693 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.334.i
  %.486.i = load i64, ptr %.485.i10693, align 8, !noalias !148
  %.487.not.i = icmp eq i64 %.486.i, 0
  br i1 %.487.not.i, label %B246.i, label %B789.i

B246.i:                                           ; preds = %B210.i
  %.549.i = mul i64 %.334.i, %arg.batch.3.3.5.1
  %232 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.549.i
  %.553.i = getelementptr i8, ptr %232, i64 8
  %.554.i = load i64, ptr %.553.i, align 8, !noalias !148
  %.556.i = add nsw i64 %.554.i, %"$phi3424.7.2.2"
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
  %.817.i10694 = icmp slt i64 %.389.i, 0
  %.818.i10695 = select i1 %.817.i10694, i64 %arg.batch.2.5.0, i64 0
  %233 = getelementptr double, ptr %arg.batch.2.4, i64 %.389.i
  %.832.i10696 = getelementptr double, ptr %233, i64 %.818.i10695
  %.833.i10697 = load double, ptr %.832.i10696, align 8, !noalias !148
  %.837.i = fcmp ugt double %.833.i10697, %.773.i
  br i1 %.837.i, label %B760.i, label %B444.preheader.i

B444.preheader.i:                                 ; preds = %B420.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul652.i, %.334.i
  %.1324.i = getelementptr double, ptr %92, i64 %.180.0654.i
  %234 = getelementptr double, ptr %arg.batch.3.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep11013 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep11015 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep11017 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep11019 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep11021 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep11023 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep11025 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep11027 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  %invariant.gep11029 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.180.0654.i
  br label %B444.i

B444.i:                                           ; preds = %B736.i, %B444.preheader.i
  %done.2.3.i = phi i64 [ %.1262.i, %B736.i ], [ %.389.i, %B444.preheader.i ]
  br i1 %.924649.not.i, label %B644.i, label %B474.if.lr.ph.i

B474.if.lr.ph.i:                                  ; preds = %B444.i
  %.979.i = icmp slt i64 %done.2.3.i, 0
  %.980.i10698 = select i1 %.979.i, i64 %arg.batch.2.5.0, i64 0
  %235 = getelementptr double, ptr %arg.batch.2.4, i64 %done.2.3.i
  %.994.i = getelementptr double, ptr %235, i64 %.980.i10698
  %.1220.i = select i1 %.979.i, i64 %arg.batch.3.0.5.1, i64 0
  %.1221.i = add i64 %.1220.i, %done.2.3.i
  %.1250.i = mul i64 %.1221.i, %arg.batch.3.0.5.2
  %236 = getelementptr double, ptr %234, i64 %.1250.i
  br label %B474.if.i

B502.i:                                           ; preds = %B474.if.i
  %.1002.i10702 = add nsw i64 %.868.0650.i, %.1000.i10688
  %.1004.i = mul nsw i64 %.1002.i10702, %arg.shape.0
  %gep11030 = getelementptr double, ptr %invariant.gep11029, i64 %.1004.i
  %.1036.i = load double, ptr %gep11030, align 8, !noalias !148
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
  %exitcond657.not.i = icmp eq i64 %.252.i10689, %arg.shape.0
  br i1 %exitcond657.not.i, label %B3440, label %B96.if.i

B790.i:                                           ; preds = %B38.if.i.i, %B502.i
  %.313.i.i.sink = phi double [ %.313.i.i, %B38.if.i.i ], [ %.1036.i, %B502.i ]
  %238 = getelementptr double, ptr %236, i64 %.868.0650.i
  store double %.313.i.i.sink, ptr %238, align 8, !noalias !148
  %exitcond.not.i10701 = icmp eq i64 %arg.shape.1, %.937.i
  br i1 %exitcond.not.i10701, label %B644.i, label %B474.if.i

B96.if.i:                                         ; preds = %B3388, %B789.i
  %.180.0654.i = phi i64 [ %.252.i10689, %B789.i ], [ 0, %B3388 ]
  %.252.i10689 = add nsw i64 %.180.0654.i, 1
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
  %gep11014 = getelementptr double, ptr %invariant.gep11013, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep11014, align 8, !noalias !151
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i10699 = fmul double %.1150.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.868.0650.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep11016 = getelementptr double, ptr %invariant.gep11015, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep11016, align 8, !noalias !151
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i10699
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.868.0650.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep11018 = getelementptr double, ptr %invariant.gep11017, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep11018, align 8, !noalias !151
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %.1150.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.868.0650.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep11020 = getelementptr double, ptr %invariant.gep11019, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep11020, align 8, !noalias !151
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.868.0650.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep11022 = getelementptr double, ptr %invariant.gep11021, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep11022, align 8, !noalias !151
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %.1150.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.868.0650.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep11024 = getelementptr double, ptr %invariant.gep11023, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep11024, align 8, !noalias !151
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.868.0650.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep11026 = getelementptr double, ptr %invariant.gep11025, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep11026, align 8, !noalias !151
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %.1150.i, %.193.i.6.i
  %.271.i.i10700 = mul nsw i64 %.868.0650.i, %arg.shape.0
  %gep11028 = getelementptr double, ptr %invariant.gep11027, i64 %.271.i.i10700
  %.309.i.i = load double, ptr %gep11028, align 8, !noalias !151
  %.313.i.i = fadd double %.309.i.i, %.253.i.6.i
  br label %B790.i

B3440:                                            ; preds = %B789.i, %B3388, %B3380
  br i1 %.5066, label %B3490, label %B3452

B3452:                                            ; preds = %B3440
  %.5121 = load double, ptr %.5120, align 8
  %.5122 = fcmp ogt double %.5121, 5.000000e-01
  br i1 %.5122, label %B3490, label %B3558

B3490:                                            ; preds = %B3452, %B3440
  %.5153 = load i64, ptr %.5152, align 8
  %.5198 = inttoptr i64 %.5153 to ptr
  tail call void %.5198(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br label %B3558

B3558:                                            ; preds = %B3490, %B3452
  %brmerge10583.not.not = xor i1 %brmerge10583.not, true
  %brmerge11060 = or i1 %.689, %brmerge10583.not.not
  br i1 %brmerge11060, label %B3614, label %B80.if.i7180

B134.i:                                           ; preds = %B80.if.i7180
  %.351.i6426 = getelementptr double, ptr %95, i64 %.141.i6182.011038
  %.352.i6427 = load double, ptr %.351.i6426, align 8, !noalias !155
  %.353.i6428 = fcmp ogt double %.352.i6427, 5.000000e-01
  br i1 %.353.i6428, label %B174.i, label %B740.i

B174.i:                                           ; preds = %B134.i
  %.408.i6476 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.141.i6182.011038
  %.409.i6477 = load double, ptr %.408.i6476, align 8, !noalias !155
  %.463.i6525 = getelementptr double, ptr %96, i64 %.141.i6182.011038
  %.464.i6526 = load double, ptr %.463.i6525, align 8, !noalias !155
  %.465.i6527 = fsub double %.409.i6477, %.464.i6526
  br i1 %.552.i656511031.not, label %B380.i, label %B270.if.i.preheader

B270.if.i.preheader:                              ; preds = %B174.i
  %invariant.gep11140 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.141.i6182.011038
  br label %B270.if.i

B380.i:                                           ; preds = %B270.if.i, %B174.i
  %fastest.2.i.2.lcssa = phi double [ 0.000000e+00, %B174.i ], [ %.11.i.i, %B270.if.i ]
  %.666.i6577 = fmul double %.465.i6527, %fastest.2.i.2.lcssa
  %.698.i6603 = load double, ptr %.697.i6602, align 8, !noalias !155
  %.699.i6604 = fcmp ogt double %.666.i6577, %.698.i6603
  %.10595 = select i1 %.699.i6604, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  %.743.i6633 = load double, ptr %.742.i6632, align 8, !noalias !155
  %.773.i6658 = load double, ptr %arg.batch.2.4, align 8, !noalias !155
  %.774.i6659 = fsub double %.743.i6633, %.773.i6658
  %.776.i6661 = fmul double %.10595, %.774.i6659
  %.780.i6664 = fcmp olt double %.465.i6527, %.776.i6661
  br i1 %.780.i6664, label %B490.i, label %B528.i

B490.i:                                           ; preds = %B380.i
  %239 = getelementptr i64, ptr %98, i64 %.141.i6182.011038
  %.838.i7116 = load i64, ptr %239, align 8, !noalias !155
  %.839.i7117 = add nsw i64 %.838.i7116, 1
  br label %B528.i

B528.i:                                           ; preds = %B380.i, %B490.i
  %"$phi528.1.2.i.2" = phi i64 [ %.839.i7117, %B490.i ], [ 0, %B380.i ]
  %240 = getelementptr i64, ptr %99, i64 %.141.i6182.011038
  store i64 %"$phi528.1.2.i.2", ptr %240, align 8, !noalias !155
  %.959.i6762 = load double, ptr %.408.i6476, align 8, !noalias !155
  store double %.959.i6762, ptr %.463.i6525, align 8, !noalias !155
  %.1068.i6855 = getelementptr double, ptr %100, i64 %.141.i6182.011038
  store double 1.000000e+00, ptr %.1068.i6855, align 8, !noalias !155
  store i64 1, ptr %.1061, align 8, !noalias !155
  %.1154.i6925 = load i64, ptr %240, align 8, !noalias !155
  %.1155.i6926 = icmp sgt i64 %.1154.i6925, 1000
  br i1 %.1155.i6926, label %B694.i, label %B740.i

B694.i:                                           ; preds = %B528.i
  %241 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.141.i6182.011038
  %.84.i.i7006 = load i64, ptr %241, align 8, !noalias !159
  %.89.i.i7009 = icmp sgt i64 %.84.i.i7006, -1
  br i1 %.89.i.i7009, label %B46.i.i7017, label %B740.i

B46.i.i7017:                                      ; preds = %B694.i
  %.120.i.i7037 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i.i7006
  %.121.i.i7038 = load i64, ptr %.120.i.i7037, align 8, !noalias !159
  %.122.i.i7039 = icmp eq i64 %.121.i.i7038, 0
  br i1 %.122.i.i7039, label %B80.i.i7044, label %B740.i

B80.i.i7044:                                      ; preds = %B46.i.i7017
  store i64 6, ptr %.120.i.i7037, align 8, !noalias !159
  br label %B740.i

B740.i:                                           ; preds = %B80.i.i7044, %B694.i, %B46.i.i7017, %B528.i, %B134.i, %B80.if.i7180
  store double 0.000000e+00, ptr %.294.i6337, align 8, !noalias !155
  %.200.i6268 = icmp sgt i64 %.144.i6183.011037, 1
  br i1 %.200.i6268, label %B80.if.i7180, label %B3614

B80.if.i7180:                                     ; preds = %B3558, %B740.i
  %.141.i6182.011038 = phi i64 [ %.213.i7188, %B740.i ], [ 0, %B3558 ]
  %.144.i6183.011037 = phi i64 [ %.209.i7185, %B740.i ], [ %storemerge, %B3558 ]
  %.209.i7185 = add nsw i64 %.144.i6183.011037, -1
  %.213.i7188 = add nsw i64 %.141.i6182.011038, 1
  %.294.i6337 = getelementptr double, ptr %94, i64 %.141.i6182.011038
  %.295.i6338 = load double, ptr %.294.i6337, align 8, !noalias !155
  %.296.i6339 = fcmp oeq double %.295.i6338, 1.000000e+00
  br i1 %.296.i6339, label %B134.i, label %B740.i

B270.if.i:                                        ; preds = %B270.if.i.preheader, %B270.if.i
  %fastest.2.i.211034 = phi double [ %.11.i.i, %B270.if.i ], [ 0.000000e+00, %B270.if.i.preheader ]
  %.496.i6199.011033 = phi i64 [ %.565.i7172, %B270.if.i ], [ 0, %B270.if.i.preheader ]
  %.565.i7172 = add nsw i64 %.496.i6199.011033, 1
  %.592.i7124 = add nsw i64 %.496.i6199.011033, %arg.shape.1
  %.594.i7126 = mul nsw i64 %.592.i7124, %arg.shape.0
  %gep11141 = getelementptr double, ptr %invariant.gep11140, i64 %.594.i7126
  %.626.i7154 = load double, ptr %gep11141, align 8, !noalias !155
  %.627.i7155 = tail call double @llvm.fabs.f64(double %.626.i7154)
  %.10.i.i = fcmp ogt double %.627.i7155, %fastest.2.i.211034
  %.11.i.i = select i1 %.10.i.i, double %.627.i7155, double %fastest.2.i.211034
  %exitcond11088.not = icmp eq i64 %arg.shape.1, %.565.i7172
  br i1 %exitcond11088.not, label %B380.i, label %B270.if.i

B3614:                                            ; preds = %B740.i, %B3558
  %brmerge10597.not = and i1 %.5268.not, %looked.2.1.lcssa
  %brmerge10597.not.not = xor i1 %brmerge10597.not, true
  %brmerge11059 = or i1 %.689, %brmerge10597.not.not
  br i1 %brmerge11059, label %B3664, label %B114.if.i

B46.i.i10703:                                     ; preds = %B114.if.i
  %.135.i.i = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !162
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i10709, label %B228.i

B80.i.i10709:                                     ; preds = %B46.i.i10703
  %.196.i.i = getelementptr double, ptr %101, i64 %.302.01639.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !162
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B228.i, label %B122.i.i10710

B122.i.i10710:                                    ; preds = %B80.i.i10709
  %.264.i.i = getelementptr double, ptr %arg.batch.4.0.4, i64 %.302.01639.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !162
  %.321.i.i = getelementptr double, ptr %102, i64 %.302.01639.i
  %.322.i.i = load double, ptr %.321.i.i, align 8, !noalias !162
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.175.i3061635.not.i
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01641.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01641.i
  br i1 %brmerge.i, label %B228.i, label %B76.if.i.lr.ph.i10711

B76.if.i.lr.ph.i10711:                            ; preds = %B122.i.i10710
  %242 = getelementptr i64, ptr %103, i64 %.302.01639.i
  %.513.i = load i64, ptr %242, align 8, !noalias !167
  %.514.i = add nsw i64 %.513.i, 1
  %.236.i323.i = icmp slt i64 %.513.i, -1
  %.237.i324.i = select i1 %.236.i323.i, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i325.i = add i64 %.514.i, %.237.i324.i
  %.258.i342.i = mul i64 %.238.i325.i, %arg.batch.1.3.5.1
  %243 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i342.i
  br label %B76.if.i.i10712

B76.if.i.i10712:                                  ; preds = %B76.if.i.i10712, %B76.if.i.lr.ph.i10711
  %.117.i268.01636.i = phi i64 [ 0, %B76.if.i.lr.ph.i10711 ], [ %.188.i390.i, %B76.if.i.i10712 ]
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
  %exitcond.not.i10713 = icmp eq i64 %arg.batch.1.1.5.0, %.188.i390.i
  br i1 %exitcond.not.i10713, label %B228.i, label %B76.if.i.i10712

B228.i:                                           ; preds = %B76.if.i.i10712, %B114.if.i, %B122.i.i10710, %B80.i.i10709, %B46.i.i10703
  %some.3.1.i = phi i1 [ %some.2.01641.mux.i, %B122.i.i10710 ], [ %some.2.01641.i, %B80.i.i10709 ], [ %some.2.01641.i, %B114.if.i ], [ %some.2.01641.i, %B46.i.i10703 ], [ true, %B76.if.i.i10712 ]
  %exitcond1650.not.i = icmp eq i64 %arg.shape.0, %.373.i
  br i1 %exitcond1650.not.i, label %B230.i, label %B114.if.i

B230.i:                                           ; preds = %B228.i
  br i1 %some.3.1.i, label %B238.i, label %B3664

B238.i:                                           ; preds = %B230.i
  %.637.i = load i64, ptr %.636.i, align 8, !noalias !167
  %.749.i = inttoptr i64 %.637.i to ptr
  tail call void %.749.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !167
  %.780.i = load i64, ptr %.779.i, align 8, !noalias !167
  %.896.i = inttoptr i64 %.780.i to ptr
  tail call void %.896.i(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.895.i10704), !noalias !167
  br i1 %.900.not.i, label %B598.if.i.preheader, label %B456.i

B456.i:                                           ; preds = %B238.i
  %.931.i = load i64, ptr %.930.i10705, align 8, !noalias !167
  %.1049.i = inttoptr i64 %.931.i to ptr
  tail call void %.1049.i(ptr %arg.batch.4.0.4, ptr %.895.i10704, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4), !noalias !167
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
  %invariant.gep11039 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
  %invariant.gep11041 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.1090.01648.i
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
  %.1146.i10707 = icmp sgt i64 %.1093.01649.i, 1
  br i1 %.1146.i10707, label %B598.if.i, label %B3664

B114.if.i:                                        ; preds = %B3614, %B228.i
  %some.2.01641.i = phi i1 [ %some.3.1.i, %B228.i ], [ false, %B3614 ]
  %.302.01639.i = phi i64 [ %.373.i, %B228.i ], [ 0, %B3614 ]
  %.373.i = add nsw i64 %.302.01639.i, 1
  %253 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.302.01639.i
  %.99.i.i = load i64, ptr %253, align 8, !noalias !162
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B228.i, label %B46.i.i10703

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
  %.1590.i10708 = mul nsw i64 %.1588.i, %arg.shape.0
  %gep11040 = getelementptr double, ptr %invariant.gep11039, i64 %.1590.i10708
  %.1622.i = load double, ptr %gep11040, align 8, !noalias !167
  %.1627.i = fmul double %.1622.i, 0.000000e+00
  %.1629.i = fadd double %trouble.2.11645.i, %.1627.i
  %.1637.i = mul nsw i64 %.1488.01643.i, %arg.shape.0
  %gep11042 = getelementptr double, ptr %invariant.gep11041, i64 %.1637.i
  store double %.1622.i, ptr %gep11042, align 8, !noalias !167
  br i1 %"$phi768.1.2.1.i", label %B896.i, label %B918.i

B3664:                                            ; preds = %B1076.i, %B3614, %B230.i
  %looked.2.1.lcssa.not = xor i1 %looked.2.1.lcssa, true
  %brmerge11061 = or i1 %.689, %looked.2.1.lcssa.not
  %active.9.1.mux = select i1 %looked.2.1.lcssa, i64 0, i64 %active.9.1
  br i1 %brmerge11061, label %B4640, label %B3706.if

B3754:                                            ; preds = %B3706.if
  %.5653 = mul i64 %.5580, %arg.batch.3.3.5.1
  %.5657 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.5653
  %.5658 = load i64, ptr %.5657, align 8
  %.5714 = getelementptr i8, ptr %.5657, i64 24
  %.5715 = load i64, ptr %.5714, align 8
  %255 = add i64 %.5658, %.5715
  %.5716 = sub i64 %arg.most, %255
  %.5721 = icmp slt i64 %.5716, 1
  br i1 %.5721, label %B3834, label %B3880

B3834:                                            ; preds = %B3754
  %256 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5418.011047
  %.84.i7269 = load i64, ptr %256, align 8, !noalias !181
  %.89.i7272 = icmp sgt i64 %.84.i7269, -1
  br i1 %.89.i7272, label %B46.i7277, label %B3880

B46.i7277:                                        ; preds = %B3834
  %.120.i7303 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i7269
  %.121.i7304 = load i64, ptr %.120.i7303, align 8, !noalias !181
  %.122.i7305 = icmp eq i64 %.121.i7304, 0
  br i1 %.122.i7305, label %B80.i7310, label %B3880

B80.i7310:                                        ; preds = %B46.i7277
  store i64 5, ptr %.120.i7303, align 8, !noalias !181
  br label %B3880

B3880:                                            ; preds = %B80.i7310, %B3834, %B46.i7277, %B3754
  %.5811 = getelementptr double, ptr %105, i64 %.5418.011047
  %.5812 = load double, ptr %.5811, align 8
  %.5813 = fcmp ogt double %.5812, 5.000000e-01
  br i1 %.5813, label %B3918, label %B4022

B3918:                                            ; preds = %B3880
  %.5868 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5418.011047
  %.5869 = load double, ptr %.5868, align 8
  %.5923 = getelementptr double, ptr %106, i64 %.5418.011047
  %.5924 = load double, ptr %.5923, align 8
  %.5925 = fcmp oeq double %.5869, %.5924
  br i1 %.5925, label %B3982, label %B4022

B3982:                                            ; preds = %B3918
  %.192.i7538 = load i64, ptr %.5579, align 8, !noalias !184
  %.248.i7586 = getelementptr i64, ptr %107, i64 %.5418.011047
  %.249.i7587 = load i64, ptr %.248.i7586, align 8, !noalias !184
  %.250.i7588 = add nsw i64 %.249.i7587, 1
  store i64 %.250.i7588, ptr %.248.i7586, align 8, !noalias !184
  %.373.i7693 = icmp slt i64 %.249.i7587, -1
  %.374.i7694 = select i1 %.373.i7693, i64 %arg.batch.1.2.5.0, i64 0
  %257 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.250.i7588
  %.388.i7708 = getelementptr double, ptr %257, i64 %.374.i7694
  %.389.i7709 = load double, ptr %.388.i7708, align 8, !noalias !184
  %.390.i7710 = fcmp oeq double %.389.i7709, 0x7FF0000000000000
  br i1 %.390.i7710, label %B182.i, label %B240.i

B182.i:                                           ; preds = %B3982
  %.424.i8238 = icmp slt i64 %.192.i7538, 0
  %.425.i8239 = select i1 %.424.i8238, i64 %arg.batch.3.1.5.0, i64 0
  %258 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.192.i7538
  %.439.i8253 = getelementptr i64, ptr %258, i64 %.425.i8239
  %.440.i8254 = load i64, ptr %.439.i8253, align 8, !noalias !184
  %.441.i8255 = icmp eq i64 %.440.i8254, 0
  br i1 %.441.i8255, label %B216.i8259, label %B4022

B216.i8259:                                       ; preds = %B182.i
  store i64 1, ptr %.439.i8253, align 8, !noalias !184
  br label %B4022

B240.i:                                           ; preds = %B3982
  store double %.389.i7709, ptr %.5923, align 8, !noalias !184
  %.592.i7800 = select i1 %.373.i7693, i64 %arg.batch.1.4.5.0, i64 0
  %259 = getelementptr i64, ptr %arg.batch.1.4.4, i64 %.250.i7588
  %.606.i7814 = getelementptr i64, ptr %259, i64 %.592.i7800
  %.607.i7815 = load i64, ptr %.606.i7814, align 8, !noalias !184
  %.610.i7817 = icmp eq i64 %.607.i7815, 0
  br i1 %.610.i7817, label %B300.i, label %B348.i

B300.i:                                           ; preds = %B240.i
  %.665.i8192 = getelementptr double, ptr %108, i64 %.5418.011047
  store double 1.000000e+00, ptr %.665.i8192, align 8, !noalias !184
  br label %B392.i.sink.split

B348.i:                                           ; preds = %B240.i
  %.733.i7843 = load i64, ptr %.1061, align 8, !noalias !184
  %.734.i7844 = icmp eq i64 %.733.i7843, 0
  br i1 %.734.i7844, label %B392.i.sink.split, label %B392.i

B392.i.sink.split:                                ; preds = %B348.i, %B300.i
  %.sink = phi i64 [ 1, %B300.i ], [ 2, %B348.i ]
  store i64 %.sink, ptr %.1061, align 8, !noalias !184
  br label %B392.i

B392.i:                                           ; preds = %B392.i.sink.split, %B348.i
  br i1 %.175.i.i799611043.not, label %B4022, label %B76.if.i.i.lr.ph

B76.if.i.i.lr.ph:                                 ; preds = %B392.i
  %.237.i.i8045 = select i1 %.373.i7693, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i8046 = add i64 %.237.i.i8045, %.250.i7588
  %.258.i.i8062 = mul i64 %.238.i.i8046, %arg.batch.1.3.5.1
  %260 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i8062
  br label %B76.if.i.i

B76.if.i.i:                                       ; preds = %B76.if.i.i.lr.ph, %B76.if.i.i
  %.117.i.i7348.011045 = phi i64 [ 0, %B76.if.i.i.lr.ph ], [ %.188.i.i8111, %B76.if.i.i ]
  %.188.i.i8111 = add nsw i64 %.117.i.i7348.011045, 1
  %261 = getelementptr double, ptr %260, i64 %.117.i.i7348.011045
  %.263.i.i8065 = load double, ptr %261, align 8, !noalias !188
  %262 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.i7348.011045
  %.293.i.i8083 = load i64, ptr %262, align 8, !noalias !188
  %.295.i.i8085 = mul nsw i64 %.293.i.i8083, %arg.shape.0
  %.297.i.i8087 = add nsw i64 %.295.i.i8085, %.5418.011047
  %.311.i.i8094 = icmp slt i64 %.297.i.i8087, 0
  %.312.i.i8095 = select i1 %.311.i.i8094, i64 %arg.batch.5.1.5.0, i64 0
  %263 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i8087
  %.326.i.i8105 = getelementptr double, ptr %263, i64 %.312.i.i8095
  store double %.263.i.i8065, ptr %.326.i.i8105, align 8, !noalias !188
  %exitcond11089.not = icmp eq i64 %arg.batch.1.1.5.0, %.188.i.i8111
  br i1 %exitcond11089.not, label %B4022, label %B76.if.i.i

B4022:                                            ; preds = %B76.if.i.i, %B392.i, %B216.i8259, %B182.i, %B3918, %B3880
  %.6014 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.5580
  %.6015 = load i64, ptr %.6014, align 8
  %.6016.not = icmp eq i64 %.6015, 0
  br i1 %.6016.not, label %B4164, label %B4056

B4056:                                            ; preds = %B4022
  %.6077 = getelementptr i64, ptr %109, i64 %.5418.011047
  %.6078 = load i64, ptr %.6077, align 8
  %.6108 = getelementptr i64, ptr %arg.batch.3.2.4, i64 %.5580
  store i64 %.6078, ptr %.6108, align 8
  store i64 -1, ptr %.5579, align 8
  %.236.i10714 = load i64, ptr %arg.batch.4.2.4, align 8, !noalias !192
  %.293.i10719 = getelementptr double, ptr %110, i64 %.5418.011047
  store double 0.000000e+00, ptr %.293.i10719, align 8, !noalias !192
  %.324.i10721 = load i64, ptr %.323.i10720, align 8, !noalias !192
  %.326.i10722 = icmp eq i64 %.236.i10714, %.324.i10721
  br i1 %.326.i10722, label %B4372, label %B132.i10723

B132.i10723:                                      ; preds = %B4056
  %.359.i10724 = add nsw i64 %.236.i10714, 1
  store i64 %.359.i10724, ptr %arg.batch.4.2.4, align 8, !noalias !192
  store i64 1, ptr %.1061, align 8, !noalias !192
  %.438.i10726 = icmp slt i64 %.236.i10714, 0
  %.439.i10727 = select i1 %.438.i10726, i64 %arg.batch.0.2.5.0, i64 0
  %264 = getelementptr i64, ptr %arg.batch.0.2.4, i64 %.236.i10714
  %.453.i10728 = getelementptr i64, ptr %264, i64 %.439.i10727
  %.454.i10729 = load i64, ptr %.453.i10728, align 8, !noalias !192
  %.469.i10730 = icmp slt i64 %.454.i10729, 0
  %.470.i10731 = select i1 %.469.i10730, i64 %arg.batch.1.0.5.0, i64 0
  %265 = getelementptr i64, ptr %arg.batch.1.0.4, i64 %.454.i10729
  %.484.i10732 = getelementptr i64, ptr %265, i64 %.470.i10731
  %.485.i10733 = load i64, ptr %.484.i10732, align 8, !noalias !192
  store i64 %.236.i10714, ptr %.5579, align 8, !noalias !192
  %.595.i10737 = getelementptr i64, ptr %111, i64 %.5418.011047
  store i64 %.485.i10733, ptr %.595.i10737, align 8, !noalias !192
  store i64 1, ptr %.6077, align 8, !noalias !192
  %.709.i10741 = getelementptr i64, ptr %112, i64 %.5418.011047
  store i64 0, ptr %.709.i10741, align 8, !noalias !192
  br i1 %.8051131.not.i10742, label %B402.i10757, label %B358.if.lr.ph.i10743

B358.if.lr.ph.i10743:                             ; preds = %B132.i10723
  %.867.i10744 = select i1 %.438.i10726, i64 %arg.batch.0.1.5.0, i64 0
  %.868.i10745 = add i64 %.867.i10744, %.236.i10714
  %.888.i10746 = mul i64 %.868.i10745, %arg.batch.0.1.5.1
  %266 = getelementptr double, ptr %arg.batch.0.1.4, i64 %.888.i10746
  %invariant.gep11142 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.5418.011047
  br label %B358.if.i10747

B402.i10757:                                      ; preds = %B358.if.i10747, %B132.i10723
  br i1 %.175.i1134.not.i10758, label %B402.endif.i10776, label %B76.if.i.lr.ph.i10759

B76.if.i.lr.ph.i10759:                            ; preds = %B402.i10757
  %.990.i10760 = load i64, ptr %.595.i10737, align 8, !noalias !192
  %.236.i.i10761 = icmp slt i64 %.990.i10760, 0
  %.237.i.i10762 = select i1 %.236.i.i10761, i64 %arg.batch.1.3.5.0, i64 0
  %.238.i.i10763 = add i64 %.237.i.i10762, %.990.i10760
  %.258.i.i10764 = mul i64 %.238.i.i10763, %arg.batch.1.3.5.1
  %267 = getelementptr double, ptr %arg.batch.1.3.4, i64 %.258.i.i10764
  br label %B76.if.i.i10765

B76.if.i.i10765:                                  ; preds = %B76.if.i.i10765, %B76.if.i.lr.ph.i10759
  %.117.i.01135.i10766 = phi i64 [ 0, %B76.if.i.lr.ph.i10759 ], [ %.188.i.i10767, %B76.if.i.i10765 ]
  %.188.i.i10767 = add nsw i64 %.117.i.01135.i10766, 1
  %268 = getelementptr double, ptr %267, i64 %.117.i.01135.i10766
  %.263.i.i10768 = load double, ptr %268, align 8, !noalias !195
  %269 = getelementptr i64, ptr %arg.batch.1.1.4, i64 %.117.i.01135.i10766
  %.293.i.i10769 = load i64, ptr %269, align 8, !noalias !195
  %.295.i.i10770 = mul nsw i64 %.293.i.i10769, %arg.shape.0
  %.297.i.i10771 = add nsw i64 %.295.i.i10770, %.5418.011047
  %.311.i.i10772 = icmp slt i64 %.297.i.i10771, 0
  %.312.i.i10773 = select i1 %.311.i.i10772, i64 %arg.batch.5.1.5.0, i64 0
  %270 = getelementptr double, ptr %arg.batch.5.1.4, i64 %.297.i.i10771
  %.326.i.i10774 = getelementptr double, ptr %270, i64 %.312.i.i10773
  store double %.263.i.i10768, ptr %.326.i.i10774, align 8, !noalias !195
  %exitcond1142.not.i10775 = icmp eq i64 %.188.i.i10767, %arg.batch.1.1.5.0
  br i1 %exitcond1142.not.i10775, label %B402.endif.i10776, label %B76.if.i.i10765

B888.i10862:                                      ; preds = %B580.if.i10792
  store double 0.000000e+00, ptr %.1877.i10859, align 8, !noalias !192
  br label %B4372

B358.if.i10747:                                   ; preds = %B358.if.i10747, %B358.if.lr.ph.i10743
  %.747.01132.i10748 = phi i64 [ 0, %B358.if.lr.ph.i10743 ], [ %.818.i10749, %B358.if.i10747 ]
  %.818.i10749 = add nsw i64 %.747.01132.i10748, 1
  %271 = getelementptr double, ptr %266, i64 %.747.01132.i10748
  %.893.i10750 = load double, ptr %271, align 8, !noalias !192
  %.895.i10751 = mul nsw i64 %.747.01132.i10748, %arg.shape.0
  %gep11143 = getelementptr double, ptr %invariant.gep11142, i64 %.895.i10751
  store double %.893.i10750, ptr %gep11143, align 8, !noalias !192
  %exitcond.not.i10756 = icmp eq i64 %.818.i10749, %arg.batch.0.1.5.1
  br i1 %exitcond.not.i10756, label %B402.i10757, label %B358.if.i10747

B402.endif.i10776:                                ; preds = %B76.if.i.i10765, %B402.i10757
  br i1 %.11171137.not.i10777, label %B580.if.i10792, label %B496.if.lr.ph.i10778

B496.if.lr.ph.i10778:                             ; preds = %B402.endif.i10776
  %.1179.i10779 = select i1 %.438.i10726, i64 %arg.batch.0.0.5.0, i64 0
  %.1180.i10780 = add i64 %.1179.i10779, %.236.i10714
  %.1200.i10781 = mul i64 %.1180.i10780, %arg.batch.0.0.5.1
  %272 = getelementptr double, ptr %arg.batch.0.0.4, i64 %.1200.i10781
  %invariant.gep11144 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.5418.011047
  br label %B496.if.i10782

B496.if.i10782:                                   ; preds = %B496.if.i10782, %B496.if.lr.ph.i10778
  %.1061.01138.i10783 = phi i64 [ 0, %B496.if.lr.ph.i10778 ], [ %.1130.i10784, %B496.if.i10782 ]
  %.1130.i10784 = add nsw i64 %.1061.01138.i10783, 1
  %273 = getelementptr double, ptr %272, i64 %.1061.01138.i10783
  %.1205.i10785 = load double, ptr %273, align 8, !noalias !192
  %.1207.i10786 = mul nsw i64 %.1061.01138.i10783, %arg.shape.0
  %gep11145 = getelementptr double, ptr %invariant.gep11144, i64 %.1207.i10786
  store double %.1205.i10785, ptr %gep11145, align 8, !noalias !192
  %exitcond1143.not.i10791 = icmp eq i64 %.1130.i10784, %arg.shape.1
  br i1 %exitcond1143.not.i10791, label %B580.if.i10792, label %B496.if.i10782

B580.if.i10792:                                   ; preds = %B496.if.i10782, %B402.endif.i10776
  %invariant.gep.i10793 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5418.011047
  store double 0.000000e+00, ptr %invariant.gep.i10793, align 8, !noalias !192
  %gep.1.i10794 = getelementptr double, ptr %invariant.gep.i10793, i64 %arg.batch.4.0.5.1
  store double 0.000000e+00, ptr %gep.1.i10794, align 8, !noalias !192
  %gep.2.i10796 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.2.idx.i10795
  store double 0.000000e+00, ptr %gep.2.i10796, align 8, !noalias !192
  %gep.3.i10798 = getelementptr i8, ptr %invariant.gep.i10793, i64 %.idx.i10718
  store double 0.000000e+00, ptr %gep.3.i10798, align 8, !noalias !192
  %gep.4.i10800 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.4.idx.i10799
  store double 0.000000e+00, ptr %gep.4.i10800, align 8, !noalias !192
  %gep.5.i10802 = getelementptr i8, ptr %invariant.gep.i10793, i64 %.idx10506
  store double 0.000000e+00, ptr %gep.5.i10802, align 8, !noalias !192
  %gep.6.i10804 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.6.idx.i10803
  store double 0.000000e+00, ptr %gep.6.i10804, align 8, !noalias !192
  %gep.7.i10806 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.7.idx.i10805
  store double 0.000000e+00, ptr %gep.7.i10806, align 8, !noalias !192
  %gep.8.i10808 = getelementptr i8, ptr %invariant.gep.i10793, i64 %.571.idx
  store double 0.000000e+00, ptr %gep.8.i10808, align 8, !noalias !192
  %gep.9.i10810 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.9.idx.i10809
  store double 0.000000e+00, ptr %gep.9.i10810, align 8, !noalias !192
  %gep.10.i10812 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.10.idx.i10811
  store double 0.000000e+00, ptr %gep.10.i10812, align 8, !noalias !192
  %gep.11.i10814 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.11.idx.i10813
  store double 0.000000e+00, ptr %gep.11.i10814, align 8, !noalias !192
  %gep.12.i10816 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.12.idx.i10815
  store double 0.000000e+00, ptr %gep.12.i10816, align 8, !noalias !192
  %gep.13.i10818 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.13.idx.i10817
  store double 0.000000e+00, ptr %gep.13.i10818, align 8, !noalias !192
  %gep.14.i10820 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.14.idx.i10819
  store double 0.000000e+00, ptr %gep.14.i10820, align 8, !noalias !192
  %gep.15.i10822 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.15.idx.i10821
  store double 0.000000e+00, ptr %gep.15.i10822, align 8, !noalias !192
  %gep.16.i10824 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.16.idx.i10823
  store double 0.000000e+00, ptr %gep.16.i10824, align 8, !noalias !192
  %gep.17.i10826 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.17.idx.i10825
  store double 0.000000e+00, ptr %gep.17.i10826, align 8, !noalias !192
  %gep.18.i10828 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.18.idx.i10827
  store double 0.000000e+00, ptr %gep.18.i10828, align 8, !noalias !192
  %gep.19.i10830 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.19.idx.i10829
  store double 0.000000e+00, ptr %gep.19.i10830, align 8, !noalias !192
  %gep.20.i10832 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.20.idx.i10831
  store double 0.000000e+00, ptr %gep.20.i10832, align 8, !noalias !192
  %gep.21.i10834 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.21.idx.i10833
  store double 0.000000e+00, ptr %gep.21.i10834, align 8, !noalias !192
  %gep.22.i10836 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.22.idx.i10835
  store double 0.000000e+00, ptr %gep.22.i10836, align 8, !noalias !192
  %gep.23.i10838 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.23.idx.i10837
  store double 0.000000e+00, ptr %gep.23.i10838, align 8, !noalias !192
  %gep.24.i10840 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.24.idx.i10839
  store double 0.000000e+00, ptr %gep.24.i10840, align 8, !noalias !192
  %gep.25.i10842 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.25.idx.i10841
  store double 0.000000e+00, ptr %gep.25.i10842, align 8, !noalias !192
  %gep.26.i10844 = getelementptr i8, ptr %invariant.gep.i10793, i64 %gep.26.idx.i10843
  store double 0.000000e+00, ptr %gep.26.i10844, align 8, !noalias !192
  %.1455.i10845 = load double, ptr %arg.batch.2.4, align 8, !noalias !192
  %.1516.i10846 = load i64, ptr %.595.i10737, align 8, !noalias !192
  %.1531.i10847 = icmp slt i64 %.1516.i10846, 0
  %.1532.i10848 = select i1 %.1531.i10847, i64 %arg.batch.1.2.5.0, i64 0
  %274 = getelementptr double, ptr %arg.batch.1.2.4, i64 %.1516.i10846
  %.1546.i10849 = getelementptr double, ptr %274, i64 %.1532.i10848
  %.1547.i10850 = load double, ptr %.1546.i10849, align 8, !noalias !192
  store double %.1455.i10845, ptr %invariant.gep.i10793, align 8, !noalias !192
  %.1656.i10853 = getelementptr double, ptr %113, i64 %.5418.011047
  store double %.1547.i10850, ptr %.1656.i10853, align 8, !noalias !192
  store double 1.000000e+00, ptr %.293.i10719, align 8, !noalias !192
  %.1767.i10855 = getelementptr double, ptr %114, i64 %.5418.011047
  store double 0xFFF0000000000000, ptr %.1767.i10855, align 8, !noalias !192
  %.1822.i10857 = getelementptr double, ptr %115, i64 %.5418.011047
  store double 0x7FF0000000000000, ptr %.1822.i10857, align 8, !noalias !192
  %.1877.i10859 = getelementptr double, ptr %116, i64 %.5418.011047
  %.1878.i10860 = load double, ptr %.1877.i10859, align 8, !noalias !192
  %.1880.i10861 = fcmp ueq double %.1878.i10860, 0xFFF0000000000000
  br i1 %.1880.i10861, label %B4372, label %B888.i10862

B4164:                                            ; preds = %B4022
  %.6304 = getelementptr double, ptr %117, i64 %.5418.011047
  %.6305 = load double, ptr %.6304, align 8
  %.6307 = fcmp ult double %.6305, 1.500000e+01
  br i1 %.6307, label %B4372, label %B4212

B4212:                                            ; preds = %B4164
  %.6351 = load double, ptr %.6350, align 8
  %.6405 = getelementptr double, ptr %arg.batch.4.0.4, i64 %.5418.011047
  %.6406 = load double, ptr %.6405, align 8
  %.6407 = fsub double %.6351, %.6406
  %.6461 = getelementptr double, ptr %120, i64 %.5418.011047
  %.6462 = load double, ptr %.6461, align 8
  %.6464 = fmul double %.6462, 5.000000e+03
  %.6465 = fcmp ogt double %.6407, %.6464
  br i1 %.6465, label %B4372, label %B4348

B4348:                                            ; preds = %B4212
  store double 0.000000e+00, ptr %.6304, align 8
  br label %B4372

B4372:                                            ; preds = %B888.i10862, %B4056, %B580.if.i10792, %B4212, %B4348, %B4164
  %budget.7.4 = phi i64 [ %budget.5.211049, %B4164 ], [ 0, %B4212 ], [ %budget.5.211049, %B4348 ], [ %budget.5.211049, %B580.if.i10792 ], [ %budget.5.211049, %B4056 ], [ %budget.5.211049, %B888.i10862 ]
  %.6593 = load i64, ptr %.5579, align 8
  %.6594 = icmp sgt i64 %.6593, -1
  br i1 %.6594, label %B4410, label %B4667

B4410:                                            ; preds = %B4372
  %.6599 = add nsw i64 %active.5.211050, 1
  %.6708 = mul i64 %.6593, %arg.batch.3.3.5.1
  %.6712 = getelementptr i64, ptr %arg.batch.3.3.4, i64 %.6708
  %.6713 = load i64, ptr %.6712, align 8
  %.6724.0 = and i64 %.6713, 127
  %.6754 = sub nsw i64 128, %.6724.0
  %.11.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.6754, i64 %.5716)
  %.6842 = getelementptr double, ptr %121, i64 %.5418.011047
  %.6843 = load double, ptr %.6842, align 8
  %.6845 = fcmp ogt double %.6843, 0.000000e+00
  %.6856 = sitofp i64 %.11.i to double
  %"$phi4580.1.2.5" = select i1 %.6845, double 1.000000e+00, double %.6856
  %.6919 = getelementptr double, ptr %122, i64 %.5418.011047
  store double %"$phi4580.1.2.5", ptr %.6919, align 8
  %.111.i8392 = getelementptr i64, ptr %123, i64 %.5418.011047
  %.112.i8393 = load i64, ptr %.111.i8392, align 8, !noalias !199
  %.169.i8442 = getelementptr double, ptr %124, i64 %.5418.011047
  %.170.i8443 = load double, ptr %.169.i8442, align 8, !noalias !199
  %.224.i8491 = getelementptr double, ptr %125, i64 %.5418.011047
  store double %.170.i8443, ptr %.224.i8491, align 8, !noalias !199
  %.237.i8499 = icmp slt i64 %.112.i8393, %arg.batch.2.5.0
  br i1 %.237.i8499, label %B134.i8504, label %B4667

B134.i8504:                                       ; preds = %B4410
  %.253.i8515 = icmp slt i64 %.112.i8393, 0
  %.254.i8516 = select i1 %.253.i8515, i64 %arg.batch.2.5.0, i64 0
  %275 = getelementptr double, ptr %arg.batch.2.4, i64 %.112.i8393
  %.268.i8530 = getelementptr double, ptr %275, i64 %.254.i8516
  %.269.i8531 = load double, ptr %.268.i8530, align 8, !noalias !199
  %.328.i8582 = load double, ptr %.169.i8442, align 8, !noalias !199
  %.10.i.i8589 = fcmp olt double %.328.i8582, %.269.i8531
  %.11.i.i8590 = select i1 %.10.i.i8589, double %.328.i8582, double %.269.i8531
  store double %.11.i.i8590, ptr %.224.i8491, align 8, !noalias !199
  br label %B4667

B4640:                                            ; preds = %B4667, %B3664
  %budget.4.2 = phi i64 [ %.1027, %B3664 ], [ %budget.6.3, %B4667 ]
  %active.8.2 = phi i64 [ %active.9.1.mux, %B3664 ], [ %active.6.3, %B4667 ]
  %.6997 = icmp sgt i64 %active.8.2, 0
  %.7011 = icmp sgt i64 %budget.4.2, 0
  %or.cond10598 = select i1 %.6997, i1 %.7011, i1 false
  br i1 %or.cond10598, label %B498, label %B4666

B4666:                                            ; preds = %B4640, %B470
  %active.10.0 = phi i64 [ %active.4.0.lcssa, %B470 ], [ %active.8.2, %B4640 ]
  br i1 %.689, label %B4666.endif, label %B80.if.i2040.lr.ph

B80.if.i2040.lr.ph:                               ; preds = %B4666
  %.idx = mul i64 %arg.batch.4.0.5.1, 176
  %276 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx
  %.idx10504 = mul i64 %arg.batch.4.0.5.1, 184
  %277 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10504
  %.703.i1698 = add nsw i64 %arg.shape.2, -1
  %.idx10505 = mul i64 %arg.batch.4.0.5.1, 160
  %278 = getelementptr i8, ptr %arg.batch.4.0.4, i64 %.idx10505
  br label %B80.if.i2040

B126.i1345:                                       ; preds = %B80.if.i2040
  %.318.i1392 = getelementptr double, ptr %276, i64 %.105.i1190.011056
  %.319.i1393 = load double, ptr %.318.i1392, align 8, !noalias !203
  %.5.i.i1394 = fptosi double %.319.i1393 to i64
  %.397.i1443 = getelementptr double, ptr %277, i64 %.105.i1190.011056
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
  %.841.i1808 = add i64 %.708.i1703, %.701.i1696
  store i64 %.841.i1808, ptr %.700.i1695, align 8, !noalias !203
  store double 0.000000e+00, ptr %.318.i1392, align 8, !noalias !203
  store double 0.000000e+00, ptr %.397.i1443, align 8, !noalias !203
  %.1072.i1986 = getelementptr double, ptr %278, i64 %.105.i1190.011056
  %.1073.i1987 = load double, ptr %.1072.i1986, align 8, !noalias !203
  %.1081.i1993 = sitofp i64 %.706.i1701 to double
  %.1082.i1994 = fsub double %.1073.i1987, %.1081.i1993
  store double %.1082.i1994, ptr %.1072.i1986, align 8, !noalias !203
  br label %B568.i1342

B568.i1342:                                       ; preds = %B126.i1345, %B80.if.i2040
  %.163.i1271 = icmp sgt i64 %.108.i1191.011057, 1
  br i1 %.163.i1271, label %B80.if.i2040, label %B4666.endif

B80.if.i2040:                                     ; preds = %B80.if.i2040.lr.ph, %B568.i1342
  %.108.i1191.011057 = phi i64 [ %storemerge, %B80.if.i2040.lr.ph ], [ %.172.i2044, %B568.i1342 ]
  %.105.i1190.011056 = phi i64 [ 0, %B80.if.i2040.lr.ph ], [ %.176.i2047, %B568.i1342 ]
  %.172.i2044 = add nsw i64 %.108.i1191.011057, -1
  %.176.i2047 = add nsw i64 %.105.i1190.011056, 1
  %279 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.105.i1190.011056
  %.258.i1338 = load i64, ptr %279, align 8, !noalias !203
  %.263.i1341 = icmp sgt i64 %.258.i1338, -1
  br i1 %.263.i1341, label %B126.i1345, label %B568.i1342

B4667:                                            ; preds = %B4410, %B134.i8504, %B4372, %B3706.if
  %budget.6.3 = phi i64 [ %budget.5.211049, %B3706.if ], [ %budget.7.4, %B4372 ], [ %budget.7.4, %B134.i8504 ], [ %budget.7.4, %B4410 ]
  %active.6.3 = phi i64 [ %active.5.211050, %B3706.if ], [ %active.5.211050, %B4372 ], [ %.6599, %B134.i8504 ], [ %.6599, %B4410 ]
  %.5481 = icmp sgt i64 %.5421.011048, 1
  br i1 %.5481, label %B3706.if, label %B4640

B330.if:                                          ; preds = %B330.if.lr.ph, %B416
  %active.4.010874 = phi i64 [ 0, %B330.if.lr.ph ], [ %.984, %B416 ]
  %.678.010873 = phi i64 [ %storemerge, %B330.if.lr.ph ], [ %.742, %B416 ]
  %.675.010872 = phi i64 [ 0, %B330.if.lr.ph ], [ %.746, %B416 ]
  %.742 = add nsw i64 %.678.010873, -1
  %.746 = add nsw i64 %.675.010872, 1
  %280 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.675.010872
  %.828 = load i64, ptr %280, align 8
  %.829 = icmp slt i64 %.828, 0
  br i1 %.829, label %B372, label %B416

B1448.if:                                         ; preds = %B1416, %B1662
  %.2060.010889 = phi i64 [ %.2129, %B1662 ], [ 1, %B1416 ]
  %.2129 = add i64 %.2060.010889, 1
  %281 = getelementptr i64, ptr %arg.code.4, i64 %.2060.010889
  %282 = getelementptr i8, ptr %281, i64 120
  %.2188 = load i64, ptr %282, align 8
  %.2233 = inttoptr i64 %.2188 to ptr
  tail call void %.2233(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.2264 = load i64, ptr %arg.code.4, align 8
  %.2269 = add nsw i64 %.2060.010889, %.
  %.2271 = mul nsw i64 %.2269, %.463
  %.2315 = getelementptr double, ptr %arg.batch.5.0.4, i64 %.2271
  %.2316 = inttoptr i64 %.2264 to ptr
  tail call void %.2316(ptr %.571, ptr %.2290, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.2315)
  br i1 %or.cond10866.not, label %B68.if.lr.ph.i, label %B1662

B1806.if:                                         ; preds = %B1664, %B1892
  %looked.2.110895 = phi i1 [ %"$phi1892.1.2.2", %B1892 ], [ %spec.select10599, %B1664 ]
  %good.2.110894 = phi i1 [ %"$phi1850.1.2.2", %B1892 ], [ false, %B1664 ]
  %.2535.010893 = phi i64 [ %.2597, %B1892 ], [ %storemerge, %B1664 ]
  %.2532.010892 = phi i64 [ %.2601, %B1892 ], [ 0, %B1664 ]
  %.2597 = add nsw i64 %.2535.010893, -1
  %.2601 = add nsw i64 %.2532.010892, 1
  br i1 %good.2.110894, label %B1850, label %B1814

B1966.if:                                         ; preds = %B1966.preheader, %B2472
  %checked.3.210905 = phi i1 [ %checked.4.3, %B2472 ], [ false, %B1966.preheader ]
  %within.3.210904 = phi i1 [ %within.4.3, %B2472 ], [ false, %B1966.preheader ]
  %.2890.010903 = phi i64 [ %.2958, %B2472 ], [ %storemerge, %B1966.preheader ]
  %.2887.010902 = phi i64 [ %.2962, %B2472 ], [ 0, %B1966.preheader ]
  %.2958 = add nsw i64 %.2890.010903, -1
  %.2962 = add nsw i64 %.2887.010902, 1
  %.3047 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.2887.010902
  %.3048 = load i64, ptr %.3047, align 8
  %.3102 = getelementptr i64, ptr %38, i64 %.2887.010902
  %.3103 = load i64, ptr %.3102, align 8
  %.3163 = getelementptr double, ptr %39, i64 %.2887.010902
  store double 0.000000e+00, ptr %.3163, align 8
  %.3166 = icmp sgt i64 %.3048, -1
  br i1 %.3166, label %B2066, label %B2472

B46.i:                                            ; preds = %B2104
  %.120.i2142 = getelementptr i64, ptr %arg.batch.3.1.4, i64 %.84.i2116
  %.121.i2143 = load i64, ptr %.120.i2142, align 8, !noalias !50
  %.122.i2144 = icmp eq i64 %.121.i2143, 0
  br i1 %.122.i2144, label %B80.i2148, label %B2204

B80.i2148:                                        ; preds = %B46.i
  store i64 %.5.i, ptr %.120.i2142, align 8, !noalias !50
  br label %B2204

B2866.if:                                         ; preds = %B2818
  %.4322 = load i64, ptr %127, align 8
  %.4367 = inttoptr i64 %.4322 to ptr
  tail call void %.4367(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4398 = load i64, ptr %arg.code.4, align 8
  %.4448 = inttoptr i64 %.4398 to ptr
  tail call void %.4448(ptr %.571, ptr %.4422, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4447)
  %.4322.1 = load i64, ptr %128, align 8
  %.4367.1 = inttoptr i64 %.4322.1 to ptr
  tail call void %.4367.1(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4398.1 = load i64, ptr %arg.code.4, align 8
  %.4448.1 = inttoptr i64 %.4398.1 to ptr
  tail call void %.4448.1(ptr %.571, ptr %.4422, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4447.1)
  %.4322.2 = load i64, ptr %129, align 8
  %.4367.2 = inttoptr i64 %.4322.2 to ptr
  tail call void %.4367.2(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4398.2 = load i64, ptr %arg.code.4, align 8
  %.4448.2 = inttoptr i64 %.4398.2 to ptr
  tail call void %.4448.2(ptr %.571, ptr %.4422, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %.4447.2)
  %.4486 = load i64, ptr %.4485, align 8
  %.4531 = inttoptr i64 %.4486 to ptr
  tail call void %.4531(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.batch.5.2.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  %.4563 = load i64, ptr %.4562, align 8
  %.4608 = inttoptr i64 %.4563 to ptr
  tail call void %.4608(ptr %arg.batch.4.0.4, ptr %arg.batch.5.0.4, ptr %arg.batch.5.1.4, ptr %arg.tolerances.4, ptr %arg.batch.5.3.4, ptr %arg.batch.5.4.4)
  br i1 %.689, label %B3234, label %B64.if.i6071

B3238.endif.endif:                                ; preds = %B806.if.i3737, %B806.i3641.preheader
  br i1 %some.2.i3425.1.lcssa, label %B3276, label %B3318

B3706.if:                                         ; preds = %B3664, %B4667
  %active.5.211050 = phi i64 [ %active.6.3, %B4667 ], [ 0, %B3664 ]
  %budget.5.211049 = phi i64 [ %budget.6.3, %B4667 ], [ %.1027, %B3664 ]
  %.5421.011048 = phi i64 [ %.5490, %B4667 ], [ %storemerge, %B3664 ]
  %.5418.011047 = phi i64 [ %.5494, %B4667 ], [ 0, %B3664 ]
  %.5490 = add nsw i64 %.5421.011048, -1
  %.5494 = add nsw i64 %.5418.011047, 1
  %.5579 = getelementptr i64, ptr %arg.batch.4.1.4, i64 %.5418.011047
  %.5580 = load i64, ptr %.5579, align 8
  %.5585 = icmp slt i64 %.5580, 0
  br i1 %.5585, label %B4667, label %B3754

B4666.endif:                                      ; preds = %B568.i1342, %B4666
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

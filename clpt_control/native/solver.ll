; sha256 40a3a9bc34531747c794994fb5e268e9174c9eba5a0359c667dfab3cdcd287f7

@.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727 = internal constant [76 x i8] c"\80\04\95A\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AValueError\94\93\94\8C\1Erange() arg 3 must not be zero\94\85\94N\87\94."
@.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727.sha1 = internal constant [20 x i8] c"\CA\8E\FB:r\D6\14\FE\87 2\CC\E3\AC2`\07\A3\07'"
@.const.picklebuf.ca8efb3a72d614fe872032cce3ac326007a30727 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727, i32 76, ptr @.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727.sha1, ptr null, i32 0 }

define dso_local noundef i32 @advance(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, ptr readnone %arg.tolerances.0, ptr readnone %arg.tolerances.1, i64 %arg.tolerances.2, i64 %arg.tolerances.3, ptr %arg.tolerances.4, i64 %arg.tolerances.5.0, i64 %arg.tolerances.6.0, ptr readnone %arg.runs.0.0, ptr readnone %arg.runs.0.1, i64 %arg.runs.0.2, i64 %arg.runs.0.3, ptr readonly %arg.runs.0.4, i64 %arg.runs.0.5.0, i64 %arg.runs.0.5.1, i64 %arg.runs.0.6.0, i64 %arg.runs.0.6.1, ptr readnone %arg.runs.1.0, ptr readnone %arg.runs.1.1, i64 %arg.runs.1.2, i64 %arg.runs.1.3, ptr readonly %arg.runs.1.4, i64 %arg.runs.1.5.0, i64 %arg.runs.1.5.1, i64 %arg.runs.1.6.0, i64 %arg.runs.1.6.1, ptr readnone %arg.runs.2.0, ptr readnone %arg.runs.2.1, i64 %arg.runs.2.2, i64 %arg.runs.2.3, ptr readonly %arg.runs.2.4, i64 %arg.runs.2.5.0, i64 %arg.runs.2.6.0, ptr readnone %arg.schedule.0.0, ptr readnone %arg.schedule.0.1, i64 %arg.schedule.0.2, i64 %arg.schedule.0.3, ptr readonly %arg.schedule.0.4, i64 %arg.schedule.0.5.0, i64 %arg.schedule.0.5.1, i64 %arg.schedule.0.6.0, i64 %arg.schedule.0.6.1, ptr readnone %arg.schedule.1.0, ptr readnone %arg.schedule.1.1, i64 %arg.schedule.1.2, i64 %arg.schedule.1.3, ptr readonly %arg.schedule.1.4, i64 %arg.schedule.1.5.0, i64 %arg.schedule.1.6.0, ptr readnone %arg.schedule.2.0, ptr readnone %arg.schedule.2.1, i64 %arg.schedule.2.2, i64 %arg.schedule.2.3, ptr readonly %arg.schedule.2.4, i64 %arg.schedule.2.5.0, i64 %arg.schedule.2.6.0, ptr readnone %arg.schedule.3.0, ptr readnone %arg.schedule.3.1, i64 %arg.schedule.3.2, i64 %arg.schedule.3.3, ptr readonly %arg.schedule.3.4, i64 %arg.schedule.3.5.0, i64 %arg.schedule.3.5.1, i64 %arg.schedule.3.5.2, i64 %arg.schedule.3.6.0, i64 %arg.schedule.3.6.1, i64 %arg.schedule.3.6.2, ptr readnone %arg.schedule.4.0, ptr readnone %arg.schedule.4.1, i64 %arg.schedule.4.2, i64 %arg.schedule.4.3, ptr readonly %arg.schedule.4.4, i64 %arg.schedule.4.5.0, i64 %arg.schedule.4.5.1, i64 %arg.schedule.4.6.0, i64 %arg.schedule.4.6.1, ptr readnone %arg.times.0, ptr readnone %arg.times.1, i64 %arg.times.2, i64 %arg.times.3, ptr readonly %arg.times.4, i64 %arg.times.5.0, i64 %arg.times.6.0, ptr readnone %arg.results.0.0, ptr readnone %arg.results.0.1, i64 %arg.results.0.2, i64 %arg.results.0.3, ptr %arg.results.0.4, i64 %arg.results.0.5.0, i64 %arg.results.0.5.1, i64 %arg.results.0.5.2, i64 %arg.results.0.6.0, i64 %arg.results.0.6.1, i64 %arg.results.0.6.2, ptr readnone %arg.results.1.0, ptr readnone %arg.results.1.1, i64 %arg.results.1.2, i64 %arg.results.1.3, ptr %arg.results.1.4, i64 %arg.results.1.5.0, i64 %arg.results.1.6.0, ptr readnone %arg.results.2.0, ptr readnone %arg.results.2.1, i64 %arg.results.2.2, i64 %arg.results.2.3, ptr %arg.results.2.4, i64 %arg.results.2.5.0, i64 %arg.results.2.6.0, ptr readnone %arg.results.3.0, ptr readnone %arg.results.3.1, i64 %arg.results.3.2, i64 %arg.results.3.3, ptr %arg.results.3.4, i64 %arg.results.3.5.0, i64 %arg.results.3.5.1, i64 %arg.results.3.6.0, i64 %arg.results.3.6.1, ptr readnone %arg.lane.0.0, ptr readnone %arg.lane.0.1, i64 %arg.lane.0.2, i64 %arg.lane.0.3, ptr %arg.lane.0.4, i64 %arg.lane.0.5.0, i64 %arg.lane.0.5.1, i64 %arg.lane.0.6.0, i64 %arg.lane.0.6.1, ptr readnone %arg.lane.1.0, ptr readnone %arg.lane.1.1, i64 %arg.lane.1.2, i64 %arg.lane.1.3, ptr %arg.lane.1.4, i64 %arg.lane.1.5.0, i64 %arg.lane.1.5.1, i64 %arg.lane.1.6.0, i64 %arg.lane.1.6.1, ptr readnone %arg.lane.2.0, ptr readnone %arg.lane.2.1, i64 %arg.lane.2.2, i64 %arg.lane.2.3, ptr %arg.lane.2.4, i64 %arg.lane.2.5.0, i64 %arg.lane.2.6.0, ptr readnone %arg.arrays.0.0, ptr readnone %arg.arrays.0.1, i64 %arg.arrays.0.2, i64 %arg.arrays.0.3, ptr %arg.arrays.0.4, i64 %arg.arrays.0.5.0, i64 %arg.arrays.0.6.0, ptr readnone %arg.arrays.1.0, ptr readnone %arg.arrays.1.1, i64 %arg.arrays.1.2, i64 %arg.arrays.1.3, ptr %arg.arrays.1.4, i64 %arg.arrays.1.5.0, i64 %arg.arrays.1.6.0, ptr readnone %arg.arrays.2.0, ptr readnone %arg.arrays.2.1, i64 %arg.arrays.2.2, i64 %arg.arrays.2.3, ptr %arg.arrays.2.4, i64 %arg.arrays.2.5.0, i64 %arg.arrays.2.6.0, ptr readnone %arg.arrays.3.0, ptr readnone %arg.arrays.3.1, i64 %arg.arrays.3.2, i64 %arg.arrays.3.3, ptr %arg.arrays.3.4, i64 %arg.arrays.3.5.0, i64 %arg.arrays.3.6.0, ptr readnone %arg.arrays.4.0, ptr readnone %arg.arrays.4.1, i64 %arg.arrays.4.2, i64 %arg.arrays.4.3, ptr %arg.arrays.4.4, i64 %arg.arrays.4.5.0, i64 %arg.arrays.4.6.0, ptr readnone %arg.linear.0.0, ptr readnone %arg.linear.0.1, i64 %arg.linear.0.2, i64 %arg.linear.0.3, ptr %arg.linear.0.4, i64 %arg.linear.0.5.0, i64 %arg.linear.0.6.0, ptr readnone %arg.linear.1.0, ptr readnone %arg.linear.1.1, i64 %arg.linear.1.2, i64 %arg.linear.1.3, ptr %arg.linear.1.4, i64 %arg.linear.1.5.0, i64 %arg.linear.1.6.0, i64 %arg.budget, i64 %arg.most, i64 %arg.guarded, i64 %arg.jumping, i64 %arg.held, i64 %arg.decided) local_unnamed_addr {
entry:
  %arg.linear.1.47661 = ptrtoint ptr %arg.linear.1.4 to i64
  %arg.arrays.0.47660 = ptrtoint ptr %arg.arrays.0.4 to i64
  %arg.runs.0.47550 = ptrtoint ptr %arg.runs.0.4 to i64
  %arg.results.0.47549 = ptrtoint ptr %arg.results.0.4 to i64
  %.382 = mul nsw i64 %arg.shape.1, %arg.shape.0
  %.490.idx = shl i64 %arg.lane.0.5.1, 6
  %.490 = getelementptr i8, ptr %arg.lane.0.4, i64 %.490.idx
  %.539 = icmp sgt i64 %arg.linear.0.5.0, 0
  %. = select i1 %.539, i64 8, i64 11
  %.274.i = icmp slt i64 %arg.shape.0, 1
  %storemerge = select i1 %.274.i, i64 0, i64 %arg.shape.0
  br i1 %.274.i, label %B202.endif, label %B50.if.i.lr.ph

B50.if.i.lr.ph:                                   ; preds = %entry
  %arg.results.0.47545 = ptrtoint ptr %arg.results.0.4 to i64
  %arg.runs.0.47546 = ptrtoint ptr %arg.runs.0.4 to i64
  %.373.i7080 = getelementptr i8, ptr %arg.lane.2.4, i64 8
  %.444.i = getelementptr i8, ptr %arg.lane.2.4, i64 16
  %0 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.idx.i = shl i64 %arg.lane.1.5.1, 4
  %1 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx.i
  %.6961437.not.i = icmp slt i64 %arg.shape.1, 1
  %.851.i7084 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.9661440.not.i = icmp slt i64 %arg.shape.2, 1
  %.11851443.not.i = icmp slt i64 %arg.schedule.2.5.0, 1
  %.1319.i = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1423.i.not = icmp eq i64 %arg.shape.0, 1
  %.163.i1446.not.i = icmp slt i64 %arg.shape.1, 1
  %2 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1426.i = shl i64 %arg.lane.0.5.1, 4
  %3 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1426.i
  %.idx1427.i = mul i64 %arg.lane.0.5.1, 24
  %4 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1427.i
  %.idx1428.i = shl i64 %arg.lane.0.5.1, 5
  %5 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1428.i
  %.15851449.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx1431.i = shl i64 %arg.lane.0.5.1, 4
  %6 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1431.i
  %7 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1432.i = mul i64 %arg.lane.0.5.1, 24
  %8 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1432.i
  %.idx1433.i = shl i64 %arg.lane.0.5.1, 5
  %9 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1433.i
  %.idx1434.i = mul i64 %arg.lane.0.5.1, 120
  %10 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1434.i
  %.idx1435.i = mul i64 %arg.lane.1.5.1, 24
  %11 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1435.i
  %.idx1436.i = mul i64 %arg.lane.0.5.1, 144
  %12 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1436.i
  %13 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %14 = shl i64 %13, 3
  %15 = shl i64 %arg.runs.0.5.1, 3
  %min.iters.check = icmp ult i64 %arg.shape.1, 8
  %n.vec = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n = icmp eq i64 %arg.shape.1, %n.vec
  br label %B50.if.i

B104.i:                                           ; preds = %B50.if.i
  %.420.i = add nsw i64 %active.3.i.07416, 1
  br label %B171.i

B116.i:                                           ; preds = %B50.if.i
  %.314.i = load i64, ptr %arg.lane.2.4, align 8, !noalias !0
  %.374.i = load i64, ptr %.373.i7080, align 8, !noalias !0
  %.375.i7081 = icmp slt i64 %.314.i, %.374.i
  br i1 %.375.i7081, label %B130.i, label %B316.i

B130.i:                                           ; preds = %B116.i
  %.385.i = add nsw i64 %.314.i, 1
  store i64 %.385.i, ptr %arg.lane.2.4, align 8, !noalias !0
  store i64 1, ptr %.444.i, align 8, !noalias !0
  %.502.i7083 = getelementptr i64, ptr %arg.lane.1.4, i64 %.260.i.07414
  store i64 %.314.i, ptr %.502.i7083, align 8, !noalias !0
  %.557.i = getelementptr i64, ptr %0, i64 %.260.i.07414
  store i64 0, ptr %.557.i, align 8, !noalias !0
  %.612.i = getelementptr i64, ptr %1, i64 %.260.i.07414
  store i64 1, ptr %.612.i, align 8, !noalias !0
  br i1 %.6961437.not.i, label %B316.i, label %B272.if.lr.ph.i

B272.if.lr.ph.i:                                  ; preds = %B130.i
  %.757.i = icmp slt i64 %.314.i, 0
  %.758.i = select i1 %.757.i, i64 %arg.runs.0.5.0, i64 0
  %.759.i = add i64 %.758.i, %.314.i
  %.779.i = mul i64 %.759.i, %arg.runs.0.5.1
  %16 = getelementptr double, ptr %arg.runs.0.4, i64 %.779.i
  %.822.i = select i1 %.757.i, i64 %arg.results.0.5.0, i64 0
  %.823.i = add i64 %.822.i, %.314.i
  %.853.i = mul i64 %.851.i7084, %.823.i
  %17 = getelementptr double, ptr %arg.results.0.4, i64 %.853.i
  br i1 %min.iters.check, label %B272.if.i.preheader, label %vector.memcheck

vector.memcheck:                                  ; preds = %B272.if.lr.ph.i
  %18 = mul i64 %14, %.823.i
  %19 = mul i64 %15, %.759.i
  %20 = add i64 %18, %arg.results.0.47545
  %21 = add i64 %19, %arg.runs.0.47546
  %22 = sub i64 %20, %21
  %diff.check = icmp ult i64 %22, 32
  br i1 %diff.check, label %B272.if.i.preheader, label %vector.body

vector.body:                                      ; preds = %vector.memcheck, %vector.body
  %index = phi i64 [ %index.next, %vector.body ], [ 0, %vector.memcheck ]
  %23 = getelementptr double, ptr %16, i64 %index
  %24 = getelementptr i8, ptr %23, i64 16
  %wide.load = load <2 x double>, ptr %23, align 8, !noalias !0
  %wide.load7547 = load <2 x double>, ptr %24, align 8, !noalias !0
  %25 = getelementptr double, ptr %17, i64 %index
  %26 = getelementptr i8, ptr %25, i64 16
  store <2 x double> %wide.load, ptr %25, align 8, !noalias !0
  store <2 x double> %wide.load7547, ptr %26, align 8, !noalias !0
  %index.next = add i64 %index, 4
  %27 = icmp eq i64 %index.next, %n.vec
  br i1 %27, label %middle.block, label %vector.body, !llvm.loop !6

middle.block:                                     ; preds = %vector.body
  br i1 %cmp.n, label %B316.i, label %B272.if.i.preheader

B272.if.i.preheader:                              ; preds = %vector.memcheck, %B272.if.lr.ph.i, %middle.block
  %.638.01438.i.ph = phi i64 [ 0, %vector.memcheck ], [ 0, %B272.if.lr.ph.i ], [ %n.vec, %middle.block ]
  br label %B272.if.i

B316.i:                                           ; preds = %B272.if.i, %middle.block, %B130.i, %B116.i
  %m.2.0.i = phi i64 [ 0, %B116.i ], [ %.314.i, %B130.i ], [ %.314.i, %middle.block ], [ %.314.i, %B272.if.i ]
  br i1 %.9661440.not.i, label %B390.i, label %B346.if.lr.ph.i

B346.if.lr.ph.i:                                  ; preds = %B316.i
  %.1027.i = icmp slt i64 %m.2.0.i, 0
  %.1028.i = select i1 %.1027.i, i64 %arg.runs.1.5.0, i64 0
  %.1029.i = add i64 %.1028.i, %m.2.0.i
  %.1049.i = mul i64 %.1029.i, %arg.runs.1.5.1
  %28 = getelementptr double, ptr %arg.runs.1.4, i64 %.1049.i
  %invariant.gep7708 = getelementptr double, ptr %arg.arrays.1.4, i64 %.260.i.07414
  br label %B346.if.i

B390.i:                                           ; preds = %B346.if.i, %B316.i
  br i1 %.11851443.not.i, label %B516.i, label %B446.if.lr.ph.i

B446.if.lr.ph.i:                                  ; preds = %B390.i
  %.1237.i = icmp slt i64 %m.2.0.i, 0
  %.1238.i = select i1 %.1237.i, i64 %arg.runs.2.5.0, i64 0
  %29 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i
  %.1252.i = getelementptr i64, ptr %29, i64 %.1238.i
  br label %B446.if.i

B516.i:                                           ; preds = %B446.if.i, %B390.i
  br i1 %.375.i7081, label %B574.i, label %B520.i

B520.i:                                           ; preds = %B516.i
  br i1 %.1423.i.not, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B532.i

B532.i:                                           ; preds = %B520.i
  br i1 %.163.i1446.not.i, label %B102.i.i, label %B46.if.i.i.preheader

B46.if.i.i.preheader:                             ; preds = %B532.i
  %invariant.gep7710 = getelementptr double, ptr %arg.arrays.0.4, i64 %.260.i.07414
  br label %B46.if.i.i

B102.i.i:                                         ; preds = %B46.if.i.i, %B532.i
  %.360.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.260.i.07414
  store double 0.000000e+00, ptr %.360.i.i, align 8, !noalias !9
  %.415.i.i = getelementptr double, ptr %2, i64 %.260.i.07414
  store double 5.000000e-01, ptr %.415.i.i, align 8, !noalias !9
  %.470.i.i = getelementptr double, ptr %3, i64 %.260.i.07414
  store double 1.000000e+00, ptr %.470.i.i, align 8, !noalias !9
  %.529.i.i = getelementptr double, ptr %4, i64 %.260.i.07414
  store double 0.000000e+00, ptr %.529.i.i, align 8, !noalias !9
  %.586.i.i = getelementptr double, ptr %5, i64 %.260.i.07414
  store double 0.000000e+00, ptr %.586.i.i, align 8, !noalias !9
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B46.if.i.i:                                       ; preds = %B46.if.i.i.preheader, %B46.if.i.i
  %.105.i.01447.i = phi i64 [ %.176.i.i, %B46.if.i.i ], [ 0, %B46.if.i.i.preheader ]
  %.176.i.i = add nsw i64 %.105.i.01447.i, 1
  %30 = getelementptr double, ptr %arg.runs.0.4, i64 %.105.i.01447.i
  %.255.i.i = load double, ptr %30, align 8, !noalias !9
  %.257.i.i = mul nsw i64 %.105.i.01447.i, %arg.shape.0
  %gep7711 = getelementptr double, ptr %invariant.gep7710, i64 %.257.i.i
  store double %.255.i.i, ptr %gep7711, align 8, !noalias !9
  %exitcond1454.not.i = icmp eq i64 %arg.shape.1, %.176.i.i
  br i1 %exitcond1454.not.i, label %B102.i.i, label %B46.if.i.i

B574.i:                                           ; preds = %B516.i
  br i1 %.15851449.not.i, label %B648.i, label %B604.if.lr.ph.i

B604.if.lr.ph.i:                                  ; preds = %B574.i
  %.1646.i = icmp slt i64 %m.2.0.i, 0
  %.1647.i = select i1 %.1646.i, i64 %arg.runs.0.5.0, i64 0
  %.1648.i = add i64 %.1647.i, %m.2.0.i
  %.1668.i = mul i64 %.1648.i, %arg.runs.0.5.1
  %31 = getelementptr double, ptr %arg.runs.0.4, i64 %.1668.i
  %invariant.gep7712 = getelementptr double, ptr %arg.arrays.0.4, i64 %.260.i.07414
  br label %B604.if.i

B648.i:                                           ; preds = %B604.if.i, %B574.i
  %.1748.i = load double, ptr %arg.times.4, align 8, !noalias !0
  %.1765.i = icmp slt i64 %m.2.0.i, 0
  %.1766.i = select i1 %.1765.i, i64 %arg.runs.2.5.0, i64 0
  %32 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i
  %.1780.i = getelementptr i64, ptr %32, i64 %.1766.i
  %.1781.i = load i64, ptr %.1780.i, align 8, !noalias !0
  %.1812.i = icmp slt i64 %.1781.i, 0
  %.1813.i = select i1 %.1812.i, i64 %arg.schedule.0.5.0, i64 0
  %.1814.i = add i64 %.1813.i, %.1781.i
  %.1834.i = mul i64 %.1814.i, %arg.schedule.0.5.1
  %.1838.i = getelementptr double, ptr %arg.schedule.0.4, i64 %.1834.i
  %.1839.i = load double, ptr %.1838.i, align 8, !noalias !0
  %.1895.i = getelementptr double, ptr %arg.lane.0.4, i64 %.260.i.07414
  store double %.1748.i, ptr %.1895.i, align 8, !noalias !0
  %.1950.i = getelementptr double, ptr %6, i64 %.260.i.07414
  store double %.1839.i, ptr %.1950.i, align 8, !noalias !0
  %.2005.i = getelementptr double, ptr %7, i64 %.260.i.07414
  store double 0.000000e+00, ptr %.2005.i, align 8, !noalias !0
  %.2064.i = getelementptr double, ptr %8, i64 %.260.i.07414
  store double 1.000000e+00, ptr %.2064.i, align 8, !noalias !0
  %.2119.i = getelementptr double, ptr %9, i64 %.260.i.07414
  store double 0.000000e+00, ptr %.2119.i, align 8, !noalias !0
  %.2175.i = getelementptr double, ptr %10, i64 %.260.i.07414
  store double 0xFFF0000000000000, ptr %.2175.i, align 8, !noalias !0
  %33 = getelementptr i64, ptr %11, i64 %.260.i.07414
  store i64 0, ptr %33, align 8, !noalias !0
  %.2287.i = getelementptr double, ptr %12, i64 %.260.i.07414
  %.2288.i = load double, ptr %.2287.i, align 8, !noalias !0
  %.2290.i = fcmp ueq double %.2288.i, 0xFFF0000000000000
  br i1 %.2290.i, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B944.i

B944.i:                                           ; preds = %B648.i
  store double 0.000000e+00, ptr %.2287.i, align 8, !noalias !0
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B272.if.i:                                        ; preds = %B272.if.i.preheader, %B272.if.i
  %.638.01438.i = phi i64 [ %.709.i, %B272.if.i ], [ %.638.01438.i.ph, %B272.if.i.preheader ]
  %.709.i = add nsw i64 %.638.01438.i, 1
  %34 = getelementptr double, ptr %16, i64 %.638.01438.i
  %.784.i = load double, ptr %34, align 8, !noalias !0
  %35 = getelementptr double, ptr %17, i64 %.638.01438.i
  store double %.784.i, ptr %35, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.709.i, %arg.shape.1
  br i1 %exitcond.not.i, label %B316.i, label %B272.if.i, !llvm.loop !13

B346.if.i:                                        ; preds = %B346.if.i, %B346.if.lr.ph.i
  %.910.01441.i = phi i64 [ 0, %B346.if.lr.ph.i ], [ %.979.i, %B346.if.i ]
  %.979.i = add nsw i64 %.910.01441.i, 1
  %36 = getelementptr double, ptr %28, i64 %.910.01441.i
  %.1054.i = load double, ptr %36, align 8, !noalias !0
  %.1056.i = mul nsw i64 %.910.01441.i, %arg.shape.0
  %gep7709 = getelementptr double, ptr %invariant.gep7708, i64 %.1056.i
  store double %.1054.i, ptr %gep7709, align 8, !noalias !0
  %exitcond1452.not.i = icmp eq i64 %.979.i, %arg.shape.2
  br i1 %exitcond1452.not.i, label %B390.i, label %B346.if.i

B446.if.i:                                        ; preds = %B446.if.i, %B446.if.lr.ph.i
  %.1129.01444.i = phi i64 [ 0, %B446.if.lr.ph.i ], [ %.1198.i, %B446.if.i ]
  %.1198.i = add nsw i64 %.1129.01444.i, 1
  %.1253.i = load i64, ptr %.1252.i, align 8, !noalias !0
  %.1289.i = icmp slt i64 %.1253.i, 0
  %.1290.i = select i1 %.1289.i, i64 %arg.schedule.3.5.0, i64 0
  %.1291.i = add i64 %.1290.i, %.1253.i
  %.1321.i = mul i64 %.1319.i, %.1291.i
  %37 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1321.i
  %38 = getelementptr double, ptr %37, i64 %.1129.01444.i
  %.1328.i7082 = load double, ptr %38, align 8, !noalias !0
  %39 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1129.01444.i
  %.1358.i = load i64, ptr %39, align 8, !noalias !0
  %.1360.i = mul nsw i64 %.1358.i, %arg.shape.0
  %.1362.i = add nsw i64 %.1360.i, %.260.i.07414
  %.1376.i = icmp slt i64 %.1362.i, 0
  %.1377.i = select i1 %.1376.i, i64 %arg.arrays.1.5.0, i64 0
  %40 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1362.i
  %.1391.i = getelementptr double, ptr %40, i64 %.1377.i
  store double %.1328.i7082, ptr %.1391.i, align 8, !noalias !0
  %exitcond1453.not.i = icmp eq i64 %.1198.i, %arg.schedule.2.5.0
  br i1 %exitcond1453.not.i, label %B516.i, label %B446.if.i

B604.if.i:                                        ; preds = %B604.if.i, %B604.if.lr.ph.i
  %.1529.01450.i = phi i64 [ 0, %B604.if.lr.ph.i ], [ %.1598.i, %B604.if.i ]
  %.1598.i = add nsw i64 %.1529.01450.i, 1
  %41 = getelementptr double, ptr %31, i64 %.1529.01450.i
  %.1673.i = load double, ptr %41, align 8, !noalias !0
  %.1675.i = mul nsw i64 %.1529.01450.i, %arg.shape.0
  %gep7713 = getelementptr double, ptr %invariant.gep7712, i64 %.1675.i
  store double %.1673.i, ptr %gep7713, align 8, !noalias !0
  %exitcond1455.not.i = icmp eq i64 %.1598.i, %arg.shape.1
  br i1 %exitcond1455.not.i, label %B648.i, label %B604.if.i

_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B520.i, %B102.i.i, %B648.i, %B944.i
  %storemerge1429.i = phi i64 [ 0, %B520.i ], [ 0, %B102.i.i ], [ 1, %B944.i ], [ 1, %B648.i ]
  %.525.i = add nsw i64 %storemerge1429.i, %active.3.i.07416
  br label %B171.i

B171.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B104.i
  %active.4.i.1 = phi i64 [ %.420.i, %B104.i ], [ %.525.i, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.318.i = icmp sgt i64 %.263.i.07415, 1
  br i1 %.318.i, label %B50.if.i, label %B202.endif

B50.if.i:                                         ; preds = %B50.if.i.lr.ph, %B171.i
  %active.3.i.07416 = phi i64 [ 0, %B50.if.i.lr.ph ], [ %active.4.i.1, %B171.i ]
  %.263.i.07415 = phi i64 [ %storemerge, %B50.if.i.lr.ph ], [ %.327.i, %B171.i ]
  %.260.i.07414 = phi i64 [ 0, %B50.if.i.lr.ph ], [ %.331.i, %B171.i ]
  %.327.i = add nsw i64 %.263.i.07415, -1
  %.331.i = add nsw i64 %.260.i.07414, 1
  %42 = getelementptr i64, ptr %arg.lane.1.4, i64 %.260.i.07414
  %.414.i = load i64, ptr %42, align 8, !noalias !14
  %.415.i = icmp sgt i64 %.414.i, -1
  br i1 %.415.i, label %B104.i, label %B116.i

B276:                                             ; preds = %B276.preheader, %B4080
  %budget.3.0 = phi i64 [ %budget.4.2.lcssa, %B4080 ], [ %arg.budget, %B276.preheader ]
  %active.4.0 = phi i64 [ %active.3.2.lcssa, %B4080 ], [ %active.3.i.0.lcssa, %B276.preheader ]
  %.688 = add nsw i64 %budget.3.0, -1
  %.723 = load i64, ptr %.722, align 8
  %.724 = icmp sgt i64 %.723, 0
  br i1 %.724, label %B310, label %B1000

B310:                                             ; preds = %B276
  %.756 = icmp eq i64 %.723, 1
  store i64 0, ptr %.722, align 8
  %.819 = load i64, ptr %.818, align 8
  %.864 = inttoptr i64 %.819 to ptr
  tail call void %.864(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.756, label %B434, label %B1000

B434:                                             ; preds = %B310
  br i1 %.875, label %B446, label %B490

B446:                                             ; preds = %B434
  %.150.i = load i64, ptr %.149.i, align 8, !noalias !15
  %.195.i99 = inttoptr i64 %.150.i to ptr
  tail call void %.195.i99(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !15
  br i1 %.274.i, label %B250.i, label %B118.if.i

B248.i:                                           ; preds = %B190.if.i, %B118.if.i
  %.279.i = icmp sgt i64 %.224.i.07422, 1
  br i1 %.279.i, label %B118.if.i, label %B250.i

B250.i:                                           ; preds = %B248.i, %B446
  %.614.i = load i64, ptr %.818, align 8, !noalias !15
  %.661.i = inttoptr i64 %.614.i to ptr
  tail call void %.661.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !15
  br label %B490

B118.if.i:                                        ; preds = %B446, %B248.i
  %.224.i.07422 = phi i64 [ %.288.i238, %B248.i ], [ %storemerge, %B446 ]
  %.221.i.07421 = phi i64 [ %.292.i240, %B248.i ], [ 0, %B446 ]
  %.288.i238 = add nsw i64 %.224.i.07422, -1
  %.292.i240 = add nsw i64 %.221.i.07421, 1
  %43 = getelementptr double, ptr %264, i64 %.221.i.07421
  %.374.i149 = load double, ptr %43, align 8, !noalias !15
  %.375.i = fcmp ule double %.374.i149, 5.000000e-01
  %brmerge7529 = select i1 %.375.i, i1 true, i1 %.457.i1787417
  br i1 %brmerge7529, label %B248.i, label %B190.if.i.preheader

B190.if.i.preheader:                              ; preds = %B118.if.i
  %invariant.gep7714 = getelementptr double, ptr %arg.arrays.4.4, i64 %.221.i.07421
  br label %B190.if.i

B190.if.i:                                        ; preds = %B190.if.i.preheader, %B190.if.i
  %.401.i.07418 = phi i64 [ %.470.i231, %B190.if.i ], [ 0, %B190.if.i.preheader ]
  %.470.i231 = add nsw i64 %.401.i.07418, 1
  %.496.i189 = mul nsw i64 %.401.i.07418, %arg.shape.0
  %gep7715 = getelementptr double, ptr %invariant.gep7714, i64 %.496.i189
  %.528.i210 = load double, ptr %gep7715, align 8, !noalias !15
  %.530.i = add nsw i64 %.401.i.07418, %arg.held
  %.532.i = mul nsw i64 %.530.i, %arg.shape.0
  %.534.i = add nsw i64 %.532.i, %.221.i.07421
  %.548.i = icmp slt i64 %.534.i, 0
  %.549.i218 = select i1 %.548.i, i64 %arg.arrays.1.5.0, i64 0
  %44 = getelementptr double, ptr %arg.arrays.1.4, i64 %.534.i
  %.563.i = getelementptr double, ptr %44, i64 %.549.i218
  store double %.528.i210, ptr %.563.i, align 8, !noalias !15
  %exitcond.not = icmp eq i64 %.470.i231, %arg.decided
  br i1 %exitcond.not, label %B248.i, label %B190.if.i

B490:                                             ; preds = %B250.i, %B434
  %.962 = load i64, ptr %arg.code.4, align 8
  %.1010 = inttoptr i64 %.962 to ptr
  tail call void %.1010(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1009)
  br i1 %.1013.not, label %B652, label %B584

B584:                                             ; preds = %B490
  %.1044 = load i64, ptr %.1043, align 8
  %.1089 = inttoptr i64 %.1044 to ptr
  tail call void %.1089(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B652

B652:                                             ; preds = %B584, %B490
  %.1121 = load i64, ptr %.1120, align 8
  %.1166 = inttoptr i64 %.1121 to ptr
  tail call void %.1166(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.1197 = load i64, ptr %.1196, align 8
  %.1242 = inttoptr i64 %.1197 to ptr
  tail call void %.1242(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.1273 = load i64, ptr %arg.code.4, align 8
  %.1323 = inttoptr i64 %.1273 to ptr
  tail call void %.1323(ptr %.490, ptr %.1297, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1322)
  %.1354 = load i64, ptr %.1353, align 8
  %.1399 = inttoptr i64 %.1354 to ptr
  tail call void %.1399(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.274.i, label %B1000, label %B62.if.i

B104.i430:                                        ; preds = %B62.if.i
  store double 0.000000e+00, ptr %.296.i427, align 8, !noalias !19
  %.414.i512 = getelementptr double, ptr %266, i64 %.144.i332.07424
  store double 0.000000e+00, ptr %.414.i512, align 8, !noalias !19
  %.469.i557 = getelementptr double, ptr %267, i64 %.144.i332.07424
  store double 0.000000e+00, ptr %.469.i557, align 8, !noalias !19
  %45 = getelementptr i64, ptr %arg.lane.1.4, i64 %.144.i332.07424
  %.525.i605 = load i64, ptr %45, align 8, !noalias !19
  %.552.i626 = icmp slt i64 %.525.i605, 0
  %.553.i627 = select i1 %.552.i626, i64 %arg.results.3.5.0, i64 0
  %.554.i628 = add i64 %.553.i627, %.525.i605
  %.574.i = mul i64 %.554.i628, %arg.results.3.5.1
  %46 = getelementptr i64, ptr %arg.results.3.4, i64 %.574.i
  %.578.i = getelementptr i8, ptr %46, i64 8
  %.579.i641 = load i64, ptr %.578.i, align 8, !noalias !19
  %.580.i = add nsw i64 %.579.i641, 2
  store i64 %.580.i, ptr %.578.i, align 8, !noalias !19
  %.687.i = load i64, ptr %45, align 8, !noalias !19
  %.714.i = icmp slt i64 %.687.i, 0
  %.715.i = select i1 %.714.i, i64 %arg.results.3.5.0, i64 0
  %.716.i = add i64 %.715.i, %.687.i
  %.736.i = mul i64 %.716.i, %arg.results.3.5.1
  %47 = getelementptr i64, ptr %arg.results.3.4, i64 %.736.i
  %.740.i = getelementptr i8, ptr %47, i64 16
  %.741.i = load i64, ptr %.740.i, align 8, !noalias !19
  %.742.i = add nsw i64 %.741.i, 1
  store i64 %.742.i, ptr %.740.i, align 8, !noalias !19
  %.848.i = getelementptr double, ptr %268, i64 %.144.i332.07424
  %.849.i = load double, ptr %.848.i, align 8, !noalias !19
  %.850.i = fcmp une double %.849.i, 0.000000e+00
  br i1 %.850.i, label %B358.i, label %B404.i

B358.i:                                           ; preds = %B104.i430
  %.84.i.i = load i64, ptr %45, align 8, !noalias !23
  %.89.i.i = icmp sgt i64 %.84.i.i, -1
  br i1 %.89.i.i, label %B46.i.i, label %B404.i

B46.i.i:                                          ; preds = %B358.i
  %.120.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i.i
  %.121.i.i = load i64, ptr %.120.i.i, align 8, !noalias !23
  %.122.i.i = icmp eq i64 %.121.i.i, 0
  br i1 %.122.i.i, label %B80.i.i, label %B404.i

B80.i.i:                                          ; preds = %B46.i.i
  store i64 3, ptr %.120.i.i, align 8, !noalias !23
  br label %B404.i

B404.i:                                           ; preds = %B80.i.i, %B358.i, %B46.i.i, %B104.i430
  br i1 %.1013.not, label %B540.i, label %B408.i

B408.i:                                           ; preds = %B404.i
  %48 = getelementptr double, ptr %arg.arrays.4.4, i64 %.144.i332.07424
  %.920.i = load double, ptr %48, align 8, !noalias !19
  %.922.i = fcmp olt double %.920.i, -1.000000e-09
  br i1 %.922.i, label %B444.i, label %B540.i

B444.i:                                           ; preds = %B408.i
  %.84.i63.i = load i64, ptr %45, align 8, !noalias !26
  %.89.i66.i = icmp sgt i64 %.84.i63.i, -1
  br i1 %.89.i66.i, label %B46.i71.i, label %_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

B46.i71.i:                                        ; preds = %B444.i
  %.120.i91.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i63.i
  %.121.i92.i = load i64, ptr %.120.i91.i, align 8, !noalias !26
  %.122.i93.i = icmp eq i64 %.121.i92.i, 0
  br i1 %.122.i93.i, label %B80.i98.i, label %_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

B80.i98.i:                                        ; preds = %B46.i71.i
  store i64 4, ptr %.120.i91.i, align 8, !noalias !26
  br label %_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i

_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i: ; preds = %B46.i71.i, %B444.i, %B80.i98.i
  %.1011.i = getelementptr double, ptr %arg.lane.0.4, i64 %.144.i332.07424
  %.1012.i = load double, ptr %.1011.i, align 8, !noalias !19
  %.1068.i = getelementptr double, ptr %269, i64 %.144.i332.07424
  store double %.1012.i, ptr %.1068.i, align 8, !noalias !19
  br label %B540.i

B540.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i, %B408.i, %B404.i, %B62.if.i
  %.202.i383 = icmp sgt i64 %.147.i.07425, 1
  br i1 %.202.i383, label %B62.if.i, label %B1000

B62.if.i:                                         ; preds = %B652, %B540.i
  %.147.i.07425 = phi i64 [ %.211.i723, %B540.i ], [ %storemerge, %B652 ]
  %.144.i332.07424 = phi i64 [ %.215.i726, %B540.i ], [ 0, %B652 ]
  %.211.i723 = add nsw i64 %.147.i.07425, -1
  %.215.i726 = add nsw i64 %.144.i332.07424, 1
  %.296.i427 = getelementptr double, ptr %265, i64 %.144.i332.07424
  %.297.i428 = load double, ptr %.296.i427, align 8, !noalias !19
  %.298.i429 = fcmp ogt double %.297.i428, 5.000000e-01
  br i1 %.298.i429, label %B104.i430, label %B540.i

B1000:                                            ; preds = %B540.i, %B652, %B276, %B310
  br i1 %.539, label %B1004, label %B1244.critedge

B1004:                                            ; preds = %B1000
  %.1513 = load i64, ptr %.1512, align 8
  %.1528 = icmp slt i64 %.1513, %arg.times.5.0
  br i1 %.1528, label %B1072, label %B1110

B1072:                                            ; preds = %B1004
  %.1544 = icmp slt i64 %.1513, 0
  %.1545 = select i1 %.1544, i64 %arg.times.5.0, i64 0
  %49 = getelementptr double, ptr %arg.times.4, i64 %.1513
  %.1559 = getelementptr double, ptr %49, i64 %.1545
  %.1560 = load double, ptr %.1559, align 8
  br label %B1110

B1110:                                            ; preds = %B1004, %B1072
  %"$phi1110.0.2.2" = phi double [ %.1560, %B1072 ], [ 0x7FF0000000000000, %B1004 ]
  store double %"$phi1110.0.2.2", ptr %.1625, align 8
  %.1659 = load i64, ptr %.1658, align 8
  %.1704 = inttoptr i64 %.1659 to ptr
  tail call void %.1704(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.174.not.i, label %B0.else.endif.endif.endif.if.i, label %B0.else.endif.if.i, !prof !29

B124.i:                                           ; preds = %B0.endif.else.endif.endif.i
  %.154.i.i7093 = load i64, ptr %.153.i.i7092, align 8, !noalias !30
  %.184.i.i7095 = load i64, ptr %.183.i.i7094, align 8, !noalias !30
  br i1 %.234.i.i, label %B0.else.endif.if.i.i, label %B0.else.endif.endif.i.i, !prof !36

B412.i.i:                                         ; preds = %B330.if.i.i, %middle.block7695, %B0.endif.endif.endif.endif.endif.i.i
  %.1311.i.i = add nsw i64 %.486.i.i, -1
  %.1349.i.i = icmp slt i64 %.477.i.i, 2
  %storemerge2355.i = select i1 %.1349.i.i, i64 0, i64 %.1311.i.i
  %.1392.i2403.i = icmp sgt i64 %storemerge2355.i, 0
  br i1 %.1392.i2403.i, label %B478.i.lr.ph.i, label %B164.i

B478.i.lr.ph.i:                                   ; preds = %B412.i.i
  %.1338.i.12406.i = add nsw i64 %storemerge2355.i, -1
  %.952.i.i.i = select i1 %.1556.i2382.not.i, i64 %.311.i.i, i64 0
  %50 = getelementptr i64, ptr %.327.i.i, i64 %arg.shape.1
  %.966.i.i.i = getelementptr i64, ptr %50, i64 %.952.i.i.i
  %51 = shl i64 %spec.select.i, 3
  %52 = add i64 %51, %arg.linear.1.47661
  %53 = sub i64 %351, %52
  %diff.check7662 = icmp ult i64 %53, 32
  %or.cond7699 = select i1 %min.iters.check7664, i1 true, i1 %diff.check7662
  br label %B478.i.i

B474.i.loopexit.i:                                ; preds = %B1261.i.i, %B960.i.i
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
  %.1462.i.i = load i64, ptr %.1461.i.i, align 8, !noalias !30
  %.1463.i.i = icmp sgt i64 %.1462.i.i, 0
  br i1 %.1463.i.i, label %B508.i.i, label %B914.i.i

B508.i.i:                                         ; preds = %B478.i.i
  br i1 %.1556.i2382.not.i, label %B610.i.i, label %B544.if.i.i.preheader

B544.if.i.i.preheader:                            ; preds = %B508.i.i
  br i1 %or.cond7699, label %B544.if.i.i.preheader7704, label %vector.ph7665

vector.ph7665:                                    ; preds = %B544.if.i.i.preheader
  %broadcast.splatinsert7668 = insertelement <2 x i64> poison, i64 %.1382.i.sroa.0.02409.i, i64 0
  %broadcast.splat7669 = shufflevector <2 x i64> %broadcast.splatinsert7668, <2 x i64> poison, <2 x i32> zeroinitializer
  br label %vector.body7670

vector.body7670:                                  ; preds = %vector.body7670, %vector.ph7665
  %index7671 = phi i64 [ 0, %vector.ph7665 ], [ %index.next7674, %vector.body7670 ]
  %54 = getelementptr i64, ptr %.327.i.i, i64 %index7671
  %55 = getelementptr i8, ptr %54, i64 16
  %wide.load7672 = load <2 x i64>, ptr %54, align 8, !noalias !30
  %wide.load7673 = load <2 x i64>, ptr %55, align 8, !noalias !30
  %56 = icmp eq <2 x i64> %wide.load7672, %broadcast.splat7669
  %57 = icmp eq <2 x i64> %wide.load7673, %broadcast.splat7669
  %58 = select <2 x i1> %56, <2 x double> splat (double 1.000000e+00), <2 x double> zeroinitializer
  %59 = select <2 x i1> %57, <2 x double> splat (double 1.000000e+00), <2 x double> zeroinitializer
  %60 = getelementptr double, ptr %invariant.gep, i64 %index7671
  %61 = getelementptr i8, ptr %60, i64 16
  store <2 x double> %58, ptr %60, align 8, !noalias !30
  store <2 x double> %59, ptr %61, align 8, !noalias !30
  %index.next7674 = add i64 %index7671, 4
  %62 = icmp eq i64 %index.next7674, %n.vec7667
  br i1 %62, label %middle.block7675, label %vector.body7670, !llvm.loop !37

middle.block7675:                                 ; preds = %vector.body7670
  br i1 %cmp.n7676, label %B610.i.i, label %B544.if.i.i.preheader7704

B544.if.i.i.preheader7704:                        ; preds = %B544.if.i.i.preheader, %middle.block7675
  %.1503.i.02384.i.ph = phi i64 [ %storemerge2359.i, %B544.if.i.i.preheader ], [ %354, %middle.block7675 ]
  %.1500.i.02383.i.ph = phi i64 [ 0, %B544.if.i.i.preheader ], [ %n.vec7667, %middle.block7675 ]
  br label %B544.if.i.i

B610.i.i:                                         ; preds = %B544.if.i.i, %middle.block7675, %B508.i.i
  %.1717.i.i = load i64, ptr %.1716.i.i, align 8, !noalias !30
  %.1833.i.i = inttoptr i64 %.1717.i.i to ptr
  tail call void %.1833.i.i(ptr %arg.lane.0.4, ptr %.1807.i.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1832.i.i), !noalias !30
  %.1849.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, 0
  %.1850.i.i = select i1 %.1849.i.i, i64 %.486.i.i, i64 0
  %63 = getelementptr i64, ptr %.502.i.i, i64 %.1382.i.sroa.0.02409.i
  %.1864.i.i = getelementptr i64, ptr %63, i64 %.1850.i.i
  %.1865.i.i = load i64, ptr %.1864.i.i, align 8, !noalias !30
  %.1881.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, -1
  %.1882.i.i = select i1 %.1881.i.i, i64 %.486.i.i, i64 0
  %64 = getelementptr i8, ptr %63, i64 8
  %.1896.i.i = getelementptr i64, ptr %64, i64 %.1882.i.i
  %.1897.i.i = load i64, ptr %.1896.i.i, align 8, !noalias !30
  %.1934.i.i = sub i64 %.1897.i.i, %.1865.i.i
  %.1980.i2385.not.i = icmp slt i64 %.1934.i.i, 1
  br i1 %.1980.i2385.not.i, label %B914.i.i, label %B794.if.i.i

B802.i.i:                                         ; preds = %B794.if.i.i
  %.2047.i.i = icmp slt i64 %.1921.i.02386.i, 0
  %.2048.i.i = select i1 %.2047.i.i, i64 %.665.i.i, i64 0
  %65 = getelementptr i64, ptr %.681.i.i, i64 %.1921.i.02386.i
  %.2062.i.i = getelementptr i64, ptr %65, i64 %.2048.i.i
  %.2063.i.i = load i64, ptr %.2062.i.i, align 8, !noalias !30
  %.2064.i.i = add nsw i64 %.2063.i.i, %.1789.i.i
  %.2078.i.i = icmp slt i64 %.2064.i.i, 0
  %.2079.i.i = select i1 %.2078.i.i, i64 %arg.arrays.0.5.0, i64 0
  %66 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2064.i.i
  %.2093.i.i = getelementptr double, ptr %66, i64 %.2079.i.i
  %.2094.i.i = load double, ptr %.2093.i.i, align 8, !noalias !30
  %.2161.i.i = fsub double %.2094.i.i, %.2094.i.i
  %.2162.i.i = fcmp oeq double %.2161.i.i, 0.000000e+00
  br label %B910.i.i

B910.i.i:                                         ; preds = %B794.if.i.i, %B802.i.i
  %"$phi910.2.2.i.3.i" = phi i1 [ %.2162.i.i, %B802.i.i ], [ false, %B794.if.i.i ]
  %.1980.i.i = icmp sgt i64 %.1924.i.02387.i, 1
  br i1 %.1980.i.i, label %B794.if.i.i, label %B914.i.i

B914.i.i:                                         ; preds = %B910.i.i, %B610.i.i, %B478.i.i
  %found.3.i.1.i = phi i1 [ false, %B478.i.i ], [ true, %B610.i.i ], [ %"$phi910.2.2.i.3.i", %B910.i.i ]
  br i1 %found.3.i.1.i, label %B960.i.i, label %B918.i.i

B918.i.i:                                         ; preds = %B914.i.i
  %.154.i.i.i = load double, ptr %.153.i.i.i, align 8, !noalias !38
  %.183.i.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !38
  %.187.i.i.i = fdiv double %.154.i.i.i, %.183.i.i.i
  br i1 %.1162.i2379.not.i, label %B498.i.i.i.critedge, label %B84.if.i.i.i.preheader

B84.if.i.i.i.preheader:                           ; preds = %B918.i.i
  br i1 %or.cond7700, label %B84.if.i.i.i.preheader7703, label %vector.ph7646

vector.ph7646:                                    ; preds = %B84.if.i.i.i.preheader
  %broadcast.splatinsert7649 = insertelement <2 x double> poison, double %.187.i.i.i, i64 0
  %broadcast.splat7650 = shufflevector <2 x double> %broadcast.splatinsert7649, <2 x double> poison, <2 x i32> zeroinitializer
  br label %vector.body7651

vector.body7651:                                  ; preds = %vector.body7651, %vector.ph7646
  %index7652 = phi i64 [ 0, %vector.ph7646 ], [ %index.next7655, %vector.body7651 ]
  %67 = getelementptr double, ptr %arg.arrays.0.4, i64 %index7652
  %68 = getelementptr i8, ptr %67, i64 16
  %wide.load7653 = load <2 x double>, ptr %67, align 8, !noalias !38
  %wide.load7654 = load <2 x double>, ptr %68, align 8, !noalias !38
  %69 = tail call <2 x double> @llvm.fabs.v2f64(<2 x double> %wide.load7653)
  %70 = tail call <2 x double> @llvm.fabs.v2f64(<2 x double> %wide.load7654)
  %71 = fcmp ogt <2 x double> %broadcast.splat7650, %69
  %72 = fcmp ogt <2 x double> %broadcast.splat7650, %70
  %73 = select <2 x i1> %71, <2 x double> %broadcast.splat7650, <2 x double> %69
  %74 = select <2 x i1> %72, <2 x double> %broadcast.splat7650, <2 x double> %70
  %75 = fcmp ogt <2 x double> %73, zeroinitializer
  %76 = fcmp ogt <2 x double> %74, zeroinitializer
  %77 = fmul <2 x double> %73, splat (double 1.200000e-05)
  %78 = fmul <2 x double> %74, splat (double 1.200000e-05)
  %79 = select <2 x i1> %75, <2 x double> %77, <2 x double> splat (double 1.200000e-05)
  %80 = select <2 x i1> %76, <2 x double> %78, <2 x double> splat (double 1.200000e-05)
  %81 = getelementptr i8, ptr %67, i64 %.idx2424.i
  %82 = getelementptr i8, ptr %81, i64 16
  store <2 x double> %79, ptr %81, align 8, !noalias !38
  store <2 x double> %80, ptr %82, align 8, !noalias !38
  %index.next7655 = add i64 %index7652, 4
  %83 = icmp eq i64 %index.next7655, %n.vec7648
  br i1 %83, label %middle.block7656, label %vector.body7651, !llvm.loop !42

middle.block7656:                                 ; preds = %vector.body7651
  br i1 %cmp.n7657, label %B230.i.i.i, label %B84.if.i.i.i.preheader7703

B84.if.i.i.i.preheader7703:                       ; preds = %B84.if.i.i.i.preheader, %middle.block7656
  %.215.i.i.02391.i.ph = phi i64 [ 0, %B84.if.i.i.i.preheader ], [ %n.vec7648, %middle.block7656 ]
  br label %B84.if.i.i.i

B230.i.i.i:                                       ; preds = %B84.if.i.i.i, %middle.block7656
  %.500.i.i.i = load double, ptr %.499.i.i.i, align 8, !noalias !38
  %.501.i.i.i = fmul double %.500.i.i.i, 1.000000e-03
  store double %.501.i.i.i, ptr %.534.i.i.i, align 8, !noalias !38
  br label %B370.if.i.i.i

B398.i.i.i:                                       ; preds = %B370.if.i.i.i
  %gep7427 = getelementptr double, ptr %invariant.gep7426, i64 %.687.i.i.02393.i
  %.851.i.i.i = load double, ptr %gep7427, align 8, !noalias !38
  %.853.i.i.i = fmul double %.851.i.i.i, 5.000000e-01
  br label %B444.i.i.i

B444.i.i.i:                                       ; preds = %B370.if.i.i.i, %B398.i.i.i
  %"$phi444.2.2.i.i.2.i" = phi double [ %.853.i.i.i, %B398.i.i.i ], [ 0.000000e+00, %B370.if.i.i.i ]
  %84 = getelementptr double, ptr %arg.arrays.0.4, i64 %.687.i.i.02393.i
  %.894.i.i.i = load double, ptr %84, align 8, !noalias !38
  %.895.i.i.i = fadd double %"$phi444.2.2.i.i.2.i", %.894.i.i.i
  %85 = getelementptr double, ptr %84, i64 %.897.i.i.i
  store double %.895.i.i.i, ptr %85, align 8, !noalias !38
  %exitcond2417.not.i = icmp eq i64 %arg.shape.1, %.756.i.i.i
  br i1 %exitcond2417.not.i, label %B498.i.i.i, label %B370.if.i.i.i

B498.i.i.i.critedge:                              ; preds = %B918.i.i
  %.500.i.i.i.c = load double, ptr %.499.i.i.i, align 8, !noalias !38
  %.501.i.i.i.c = fmul double %.500.i.i.i.c, 1.000000e-03
  store double %.501.i.i.i.c, ptr %.534.i.i.i, align 8, !noalias !38
  br label %B498.i.i.i

B498.i.i.i:                                       ; preds = %B444.i.i.i, %B498.i.i.i.critedge
  %.967.i.i.i = load i64, ptr %.966.i.i.i, align 8, !noalias !38
  %.969.i.i.i = icmp eq i64 %.967.i.i.i, %.1382.i.sroa.0.02409.i
  br i1 %.969.i.i.i, label %B522.i.i.i, label %B568.i.i.i

B522.i.i.i:                                       ; preds = %B498.i.i.i
  %.1004.i.i.i = load double, ptr %.534.i.i.i, align 8, !noalias !38
  %.1006.i.i.i = fmul double %.1004.i.i.i, 5.000000e-01
  br label %B568.i.i.i

B568.i.i.i:                                       ; preds = %B522.i.i.i, %B498.i.i.i
  %"$phi568.1.2.i.i.1.i" = phi double [ %.1006.i.i.i, %B522.i.i.i ], [ 0.000000e+00, %B498.i.i.i ]
  %.1074.i.i.i = load double, ptr %arg.lane.0.4, align 8, !noalias !38
  %.1075.i.i.i = fadd double %"$phi568.1.2.i.i.1.i", %.1074.i.i.i
  store double %.1075.i.i.i, ptr %.490, align 8, !noalias !38
  %.1164.i.i.i = load i64, ptr %arg.code.4, align 8, !noalias !38
  %.1280.i.i.i = inttoptr i64 %.1164.i.i.i to ptr
  tail call void %.1280.i.i.i(ptr nonnull %.490, ptr %.1807.i.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1279.i.i.i), !noalias !38
  br i1 %.1162.i2379.not.i, label %B498.i.i.1.i, label %B370.if.i.i.1.i

B1060.i.i.i:                                      ; preds = %B902.if.i.i.i
  %.1750.i.i.i = fsub double %.1666.i.i.i, %.1697.i.i.i
  br label %B1148.i.i.i

B1100.i.i.i:                                      ; preds = %B902.if.i.i.i
  %86 = getelementptr double, ptr %94, i64 %arg.shape.1
  %.1731.i.i.i = load double, ptr %86, align 8, !noalias !38
  %.1796.i.i.i = fsub double %.1666.i.i.i, %.1731.i.i.i
  %.1801.i.i.i = fmul double %.1796.i.i.i, 2.000000e+00
  br label %B1148.i.i.i

B370.if.i.i.1.i:                                  ; preds = %B568.i.i.i, %B444.i.i.1.i
  %.687.i.i.02393.1.i = phi i64 [ %.756.i.i.1.i, %B444.i.i.1.i ], [ 0, %B568.i.i.i ]
  %.756.i.i.1.i = add nsw i64 %.687.i.i.02393.1.i, 1
  %87 = getelementptr i64, ptr %.327.i.i, i64 %.687.i.i.02393.1.i
  %.814.i.i.1.i = load i64, ptr %87, align 8, !noalias !38
  %.816.i.i.1.i = icmp eq i64 %.814.i.i.1.i, %.1382.i.sroa.0.02409.i
  br i1 %.816.i.i.1.i, label %B398.i.i.1.i, label %B444.i.i.1.i

B398.i.i.1.i:                                     ; preds = %B370.if.i.i.1.i
  %gep7429 = getelementptr double, ptr %invariant.gep7428, i64 %.687.i.i.02393.1.i
  %.851.i.i.1.i = load double, ptr %gep7429, align 8, !noalias !38
  %.853.i.i.1.i = fmul double %.851.i.i.1.i, -5.000000e-01
  br label %B444.i.i.1.i

B444.i.i.1.i:                                     ; preds = %B398.i.i.1.i, %B370.if.i.i.1.i
  %"$phi444.2.2.i.i.2.1.i" = phi double [ %.853.i.i.1.i, %B398.i.i.1.i ], [ 0.000000e+00, %B370.if.i.i.1.i ]
  %88 = getelementptr double, ptr %arg.arrays.0.4, i64 %.687.i.i.02393.1.i
  %.894.i.i.1.i = load double, ptr %88, align 8, !noalias !38
  %.895.i.i.1.i = fadd double %"$phi444.2.2.i.i.2.1.i", %.894.i.i.1.i
  %89 = getelementptr double, ptr %88, i64 %.897.i.i.i
  store double %.895.i.i.1.i, ptr %89, align 8, !noalias !38
  %exitcond2417.1.not.i = icmp eq i64 %arg.shape.1, %.756.i.i.1.i
  br i1 %exitcond2417.1.not.i, label %B498.i.i.1.i, label %B370.if.i.i.1.i

B498.i.i.1.i:                                     ; preds = %B444.i.i.1.i, %B568.i.i.i
  %.967.i.i.1.i = load i64, ptr %.966.i.i.i, align 8, !noalias !38
  %.969.i.i.1.i = icmp eq i64 %.967.i.i.1.i, %.1382.i.sroa.0.02409.i
  br i1 %.969.i.i.1.i, label %B522.i.i.1.i, label %B568.i.i.1.i

B522.i.i.1.i:                                     ; preds = %B498.i.i.1.i
  %.1004.i.i.1.i = load double, ptr %.534.i.i.i, align 8, !noalias !38
  %.1006.i.i.1.i = fmul double %.1004.i.i.1.i, -5.000000e-01
  br label %B568.i.i.1.i

B568.i.i.1.i:                                     ; preds = %B522.i.i.1.i, %B498.i.i.1.i
  %"$phi568.1.2.i.i.1.1.i" = phi double [ %.1006.i.i.1.i, %B522.i.i.1.i ], [ 0.000000e+00, %B498.i.i.1.i ]
  %.1074.i.i.1.i = load double, ptr %arg.lane.0.4, align 8, !noalias !38
  %.1075.i.i.1.i = fadd double %"$phi568.1.2.i.i.1.1.i", %.1074.i.i.1.i
  store double %.1075.i.i.1.i, ptr %.490, align 8, !noalias !38
  %.1312.i.i.1.i = load i64, ptr %arg.code.4, align 8, !noalias !38
  %.1426.i.i.1.i = inttoptr i64 %.1312.i.i.1.i to ptr
  tail call void %.1426.i.i.1.i(ptr nonnull %.490, ptr %.1807.i.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !38
  br i1 %.1162.i2379.not.i, label %B960.i.i, label %B902.if.i.i.i

B1148.i.i.i:                                      ; preds = %B1100.i.i.i, %B1060.i.i.i
  %storemerge2363.i = phi double [ %.1801.i.i.i, %B1100.i.i.i ], [ %.1750.i.i.i, %B1060.i.i.i ]
  store double %storemerge2363.i, ptr %96, align 8, !noalias !38
  %exitcond2419.not.i = icmp eq i64 %arg.shape.1, %.1540.i.i.i
  br i1 %exitcond2419.not.i, label %B960.i.i, label %B902.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B84.if.i.i.i.preheader7703, %B84.if.i.i.i
  %.215.i.i.02391.i = phi i64 [ %.286.i.i.i, %B84.if.i.i.i ], [ %.215.i.i.02391.i.ph, %B84.if.i.i.i.preheader7703 ]
  %.286.i.i.i = add nsw i64 %.215.i.i.02391.i, 1
  %90 = getelementptr double, ptr %arg.arrays.0.4, i64 %.215.i.i.02391.i
  %.344.i.i.i = load double, ptr %90, align 8, !noalias !38
  %.345.i.i.i = tail call double @llvm.fabs.f64(double %.344.i.i.i)
  %.10.i.i.i.i = fcmp ogt double %.187.i.i.i, %.345.i.i.i
  %.11.i.i.i.i = select i1 %.10.i.i.i.i, double %.187.i.i.i, double %.345.i.i.i
  %.380.i.i.i = fcmp ogt double %.11.i.i.i.i, 0.000000e+00
  %91 = fmul double %.11.i.i.i.i, 1.200000e-05
  %"$phi194.2.2.i.i.1.i" = select i1 %.380.i.i.i, double %91, double 1.200000e-05
  %92 = getelementptr i8, ptr %90, i64 %.idx2424.i
  store double %"$phi194.2.2.i.i.1.i", ptr %92, align 8, !noalias !38
  %exitcond2416.not.i = icmp eq i64 %arg.shape.1, %.286.i.i.i
  br i1 %exitcond2416.not.i, label %B230.i.i.i, label %B84.if.i.i.i, !llvm.loop !43

B370.if.i.i.i:                                    ; preds = %B230.i.i.i, %B444.i.i.i
  %.687.i.i.02393.i = phi i64 [ %.756.i.i.i, %B444.i.i.i ], [ 0, %B230.i.i.i ]
  %.756.i.i.i = add nsw i64 %.687.i.i.02393.i, 1
  %93 = getelementptr i64, ptr %.327.i.i, i64 %.687.i.i.02393.i
  %.814.i.i.i = load i64, ptr %93, align 8, !noalias !38
  %.816.i.i.i = icmp eq i64 %.814.i.i.i, %.1382.i.sroa.0.02409.i
  br i1 %.816.i.i.i, label %B398.i.i.i, label %B444.i.i.i

B902.if.i.i.i:                                    ; preds = %B568.i.i.1.i, %B1148.i.i.i
  %.1471.i.i.02398.i = phi i64 [ %.1540.i.i.i, %B1148.i.i.i ], [ 0, %B568.i.i.1.i ]
  %.1540.i.i.i = add nsw i64 %.1471.i.i.02398.i, 1
  %94 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1471.i.i.02398.i
  %.1598.i.i.i = load double, ptr %94, align 8, !noalias !38
  %95 = getelementptr i8, ptr %94, i64 %.1807.i.idx.i
  store double %.1598.i.i.i, ptr %95, align 8, !noalias !38
  %96 = getelementptr i8, ptr %94, i64 %.1279.i.i.idx.i
  %.1666.i.i.i = load double, ptr %96, align 8, !noalias !38
  %97 = getelementptr double, ptr %arg.arrays.4.4, i64 %.1471.i.i.02398.i
  %.1697.i.i.i = load double, ptr %97, align 8, !noalias !38
  %.1743.i.i.i = fsub double %.1697.i.i.i, %.1697.i.i.i
  %.1744.i.i.i = fcmp oeq double %.1743.i.i.i, 0.000000e+00
  br i1 %.1744.i.i.i, label %B1060.i.i.i, label %B1100.i.i.i

B960.i.i:                                         ; preds = %B1148.i.i.i, %B568.i.i.1.i, %B914.i.i
  %.2256.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, 0
  %.2257.i.i = select i1 %.2256.i.i, i64 %.486.i.i, i64 0
  %98 = getelementptr i64, ptr %.502.i.i, i64 %.1382.i.sroa.0.02409.i
  %.2271.i.i = getelementptr i64, ptr %98, i64 %.2257.i.i
  %.2272.i.i = load i64, ptr %.2271.i.i, align 8, !noalias !30
  %.2290.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, -1
  %.2291.i.i = select i1 %.2290.i.i, i64 %.486.i.i, i64 0
  %99 = getelementptr i8, ptr %98, i64 8
  %.2305.i.i = getelementptr i64, ptr %99, i64 %.2291.i.i
  %.2306.i.i = load i64, ptr %.2305.i.i, align 8, !noalias !30
  %.2343.i.i = sub i64 %.2306.i.i, %.2272.i.i
  %.2386.i2400.not.i = icmp slt i64 %.2343.i.i, 1
  br i1 %.2386.i2400.not.i, label %B474.i.loopexit.i, label %B1022.if.i.i

B1080.i.i:                                        ; preds = %B1022.if.i.i
  %.2519.i.i = select i1 %.2443.i.i, i64 %.836.i.i, i64 0
  %100 = getelementptr i64, ptr %.852.i.i, i64 %.2330.i.02401.i
  %.2533.i.i = getelementptr i64, ptr %100, i64 %.2519.i.i
  %.2534.i.i = load i64, ptr %.2533.i.i, align 8, !noalias !30
  %.2535.i.i = add nsw i64 %.2534.i.i, %.503.i.i.i
  %.2549.i.i = icmp slt i64 %.2535.i.i, 0
  %.2550.i.i = select i1 %.2549.i.i, i64 %arg.arrays.0.5.0, i64 0
  %101 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2535.i.i
  %.2564.i.i = getelementptr double, ptr %101, i64 %.2550.i.i
  %.2565.i.i = load double, ptr %.2564.i.i, align 8, !noalias !30
  %.2570.i.i = fdiv double %.2490.i.i, %.2565.i.i
  %.2578.i.i = fsub double %.2570.i.i, %.2570.i.i
  %.2579.i.i = fcmp oeq double %.2578.i.i, 0.000000e+00
  %.2570.i..i = select i1 %.2579.i.i, double %.2570.i.i, double 0.000000e+00
  br label %B1162.i.i

B1162.i.i:                                        ; preds = %B1022.if.i.i, %B1080.i.i
  %slope.3.i.2.i = phi double [ %.2490.i.i, %B1022.if.i.i ], [ %.2570.i..i, %B1080.i.i ]
  %.2616.i.i = select i1 %.2443.i.i, i64 %.836.i.i, i64 0
  %102 = getelementptr i64, ptr %.852.i.i, i64 %.2330.i.02401.i
  %.2630.i.i = getelementptr i64, ptr %102, i64 %.2616.i.i
  %.2631.i.i = load i64, ptr %.2630.i.i, align 8, !noalias !30
  %.2633.i.i = icmp eq i64 %.2631.i.i, %arg.shape.1
  br i1 %.2633.i.i, label %B1186.i.i, label %B1232.i.i

B1186.i.i:                                        ; preds = %B1162.i.i
  %.2670.i.i = add nsw i64 %.2459.i.i, %.2636.i.i
  %.2685.i.i = icmp slt i64 %.2670.i.i, 0
  %.2686.i.i = select i1 %.2685.i.i, i64 %arg.arrays.0.5.0, i64 0
  %103 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2670.i.i
  %.2700.i.i = getelementptr double, ptr %103, i64 %.2686.i.i
  store double %slope.3.i.2.i, ptr %.2700.i.i, align 8, !noalias !30
  br label %B1261.i.i

B1232.i.i:                                        ; preds = %B1162.i.i
  %.2720.i.i = select i1 %.2443.i.i, i64 %.1014.i.i, i64 0
  %104 = getelementptr i64, ptr %.1030.i.i, i64 %.2330.i.02401.i
  %.2734.i.i = getelementptr i64, ptr %104, i64 %.2720.i.i
  %.2735.i.i = load i64, ptr %.2734.i.i, align 8, !noalias !30
  %.2752.i.i = icmp slt i64 %.2735.i.i, 0
  %.2753.i.i = select i1 %.2752.i.i, i64 %arg.linear.0.5.0, i64 0
  %105 = getelementptr double, ptr %arg.linear.0.4, i64 %.2735.i.i
  %.2767.i.i = getelementptr double, ptr %105, i64 %.2753.i.i
  store double %slope.3.i.2.i, ptr %.2767.i.i, align 8, !noalias !30
  br label %B1261.i.i

B1261.i.i:                                        ; preds = %B1232.i.i, %B1186.i.i
  %.2386.i.i = icmp sgt i64 %.2333.i.02402.i, 1
  br i1 %.2386.i.i, label %B1022.if.i.i, label %B474.i.loopexit.i

B0.endif.i.i:                                     ; preds = %B0.else.endif.endif.endif.if.i.i, %B0.else.endif.endif.endif.i.i
  %.214.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.else.endif.endif.endif.if.i.i ], [ %.214.i.sroa.11.1.i, %B0.else.endif.endif.endif.i.i ]
  %.302.i.i = sub i64 %.214.i.sroa.11.0.i, %spec.select.i
  %.311.i.i = tail call i64 @llvm.smax.i64(i64 %.302.i.i, i64 0)
  %.327.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select.i
  %.362.i.i = add nsw i64 %.154.i.i7093, %.187.i.i
  br i1 %.409.i.i, label %B0.endif.else.endif.if.i.i, label %B0.endif.else.endif.endif.i.i, !prof !36

B0.else.endif.if.i.i:                             ; preds = %B124.i
  br label %B0.else.endif.endif.i.i

B0.else.endif.endif.i.i:                          ; preds = %B0.else.endif.if.i.i, %B124.i
  %simplifycfg.merge.i = phi i64 [ %arg.linear.1.5.0, %B0.else.endif.if.i.i ], [ 0, %B124.i ]
  %spec.select.i = select i1 %270, i64 %simplifycfg.merge.i, i64 %.226.i.i, !prof !44
  br i1 %.246.i.i, label %B0.else.endif.endif.if.i.i, label %B0.else.endif.endif.endif.i.i, !prof !36

B0.else.endif.endif.if.i.i:                       ; preds = %B0.else.endif.endif.i.i
  br label %B0.else.endif.endif.endif.i.i

B0.else.endif.endif.endif.i.i:                    ; preds = %B0.else.endif.endif.if.i.i, %B0.else.endif.endif.i.i
  %.214.i.sroa.11.1.i = phi i64 [ 0, %B0.else.endif.endif.if.i.i ], [ %.243.i.i, %B0.else.endif.endif.i.i ]
  br i1 %.251.i.not.i, label %B0.endif.i.i, label %B0.else.endif.endif.endif.if.i.i, !prof !29

B0.else.endif.endif.endif.if.i.i:                 ; preds = %B0.else.endif.endif.endif.i.i
  br label %B0.endif.i.i

B0.endif.endif.i.i:                               ; preds = %B0.endif.else.endif.endif.endif.if.i.i, %B0.endif.else.endif.endif.endif.i.i
  %.389.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.endif.endif.if.i.i ], [ %.389.i.sroa.11.1.i, %B0.endif.else.endif.endif.endif.i.i ]
  %.477.i.i = sub i64 %.389.i.sroa.11.0.i, %spec.select2366.i
  %.486.i.i = tail call i64 @llvm.smax.i64(i64 %.477.i.i, i64 0)
  %.502.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2366.i
  %.540.i.i = add i64 %.539.i.i, %.154.i.i7093
  %.541.i.i = add nsw i64 %.540.i.i, %.184.i.i7095
  %.578.i.i = icmp slt i64 %.540.i.i, 0
  %.579.i.i = select i1 %.578.i.i, i64 %arg.linear.1.5.0, i64 0
  %.580.i.i = add i64 %.579.i.i, %.540.i.i
  %.583.i.i = icmp slt i64 %.580.i.i, 0
  %.588.i.i = icmp sge i64 %.580.i.i, %arg.linear.1.5.0
  br i1 %.588.i.i, label %B0.endif.endif.else.endif.if.i.i, label %B0.endif.endif.else.endif.endif.i.i, !prof !36

B0.endif.else.endif.if.i.i:                       ; preds = %B0.endif.i.i
  br label %B0.endif.else.endif.endif.i.i

B0.endif.else.endif.endif.i.i:                    ; preds = %B0.endif.else.endif.if.i.i, %B0.endif.i.i
  %simplifycfg.merge2.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.if.i.i ], [ 0, %B0.endif.i.i ]
  %spec.select2366.i = select i1 %271, i64 %simplifycfg.merge2.i, i64 %.243.i.i, !prof !44
  %.416.i.i = icmp slt i64 %.362.i.i, 0
  %.417.i.i = select i1 %.416.i.i, i64 %arg.linear.1.5.0, i64 0
  %.418.i.i = add i64 %.417.i.i, %.362.i.i
  %.421.i.i = icmp slt i64 %.418.i.i, 0
  br i1 %.421.i.i, label %B0.endif.else.endif.endif.if.i.i, label %B0.endif.else.endif.endif.endif.i.i, !prof !36

B0.endif.else.endif.endif.if.i.i:                 ; preds = %B0.endif.else.endif.endif.i.i
  br label %B0.endif.else.endif.endif.endif.i.i

B0.endif.else.endif.endif.endif.i.i:              ; preds = %B0.endif.else.endif.endif.if.i.i, %B0.endif.else.endif.endif.i.i
  %.389.i.sroa.11.1.i = phi i64 [ 0, %B0.endif.else.endif.endif.if.i.i ], [ %.418.i.i, %B0.endif.else.endif.endif.i.i ]
  %.426.i.not.i = icmp slt i64 %.418.i.i, %arg.linear.1.5.0
  br i1 %.426.i.not.i, label %B0.endif.endif.i.i, label %B0.endif.else.endif.endif.endif.if.i.i, !prof !29

B0.endif.else.endif.endif.endif.if.i.i:           ; preds = %B0.endif.else.endif.endif.endif.i.i
  br label %B0.endif.endif.i.i

B0.endif.endif.endif.i.i:                         ; preds = %B0.endif.endif.else.endif.endif.endif.if.i.i, %B0.endif.endif.else.endif.endif.endif.i.i
  %.568.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.endif.endif.if.i.i ], [ %.568.i.sroa.11.1.i, %B0.endif.endif.else.endif.endif.endif.i.i ]
  %.656.i.i = sub i64 %.568.i.sroa.11.0.i, %spec.select2367.i
  %.665.i.i = tail call i64 @llvm.smax.i64(i64 %.656.i.i, i64 0)
  %.681.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2367.i
  %.711.i.i = shl nsw i64 %.184.i.i7095, 1
  %.712.i.i = add nsw i64 %.711.i.i, %.540.i.i
  %.759.i.i = icmp sge i64 %.597.i.i, %arg.linear.1.5.0
  br i1 %.759.i.i, label %B0.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.else.endif.endif.i.i, !prof !36

B0.endif.endif.else.endif.if.i.i:                 ; preds = %B0.endif.endif.i.i
  br label %B0.endif.endif.else.endif.endif.i.i

B0.endif.endif.else.endif.endif.i.i:              ; preds = %B0.endif.endif.else.endif.if.i.i, %B0.endif.endif.i.i
  %simplifycfg.merge4.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.i.i ]
  %106 = or i1 %.583.i.i, %.588.i.i
  %spec.select2367.i = select i1 %106, i64 %simplifycfg.merge4.i, i64 %.580.i.i, !prof !44
  %.595.i.i = icmp slt i64 %.541.i.i, 0
  %.596.i.i = select i1 %.595.i.i, i64 %arg.linear.1.5.0, i64 0
  %.597.i.i = add i64 %.596.i.i, %.541.i.i
  %.600.i.i = icmp slt i64 %.597.i.i, 0
  br i1 %.600.i.i, label %B0.endif.endif.else.endif.endif.if.i.i, label %B0.endif.endif.else.endif.endif.endif.i.i, !prof !36

B0.endif.endif.else.endif.endif.if.i.i:           ; preds = %B0.endif.endif.else.endif.endif.i.i
  br label %B0.endif.endif.else.endif.endif.endif.i.i

B0.endif.endif.else.endif.endif.endif.i.i:        ; preds = %B0.endif.endif.else.endif.endif.if.i.i, %B0.endif.endif.else.endif.endif.i.i
  %.568.i.sroa.11.1.i = phi i64 [ 0, %B0.endif.endif.else.endif.endif.if.i.i ], [ %.597.i.i, %B0.endif.endif.else.endif.endif.i.i ]
  %.605.i.not.i = icmp slt i64 %.597.i.i, %arg.linear.1.5.0
  br i1 %.605.i.not.i, label %B0.endif.endif.endif.i.i, label %B0.endif.endif.else.endif.endif.endif.if.i.i, !prof !29

B0.endif.endif.else.endif.endif.endif.if.i.i:     ; preds = %B0.endif.endif.else.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.i.i

B0.endif.endif.endif.endif.i.i:                   ; preds = %B0.endif.endif.endif.else.endif.endif.endif.if.i.i, %B0.endif.endif.endif.else.endif.endif.endif.i.i
  %.739.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.else.endif.endif.endif.if.i.i ], [ %.739.i.sroa.11.1.i, %B0.endif.endif.endif.else.endif.endif.endif.i.i ]
  %.827.i.i = sub i64 %.739.i.sroa.11.0.i, %spec.select2368.i
  %.836.i.i = tail call i64 @llvm.smax.i64(i64 %.827.i.i, i64 0)
  %.852.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2368.i
  %.889.i.i = mul nsw i64 %.184.i.i7095, 3
  %.890.i.i = add nsw i64 %.889.i.i, %.540.i.i
  %.937.i.i = icmp sge i64 %.768.i.i, %arg.linear.1.5.0
  br i1 %.937.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.i.i, !prof !36

B0.endif.endif.endif.else.endif.if.i.i:           ; preds = %B0.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.else.endif.endif.i.i:        ; preds = %B0.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.i.i
  %simplifycfg.merge6.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.i.i ]
  %107 = or i1 %.600.i.i, %.759.i.i
  %spec.select2368.i = select i1 %107, i64 %simplifycfg.merge6.i, i64 %.597.i.i, !prof !44
  %.766.i.i = icmp slt i64 %.712.i.i, 0
  %.767.i.i = select i1 %.766.i.i, i64 %arg.linear.1.5.0, i64 0
  %.768.i.i = add i64 %.767.i.i, %.712.i.i
  %.771.i.i = icmp slt i64 %.768.i.i, 0
  br i1 %.771.i.i, label %B0.endif.endif.endif.else.endif.endif.if.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.i.i, !prof !36

B0.endif.endif.endif.else.endif.endif.if.i.i:     ; preds = %B0.endif.endif.endif.else.endif.endif.i.i
  br label %B0.endif.endif.endif.else.endif.endif.endif.i.i

B0.endif.endif.endif.else.endif.endif.endif.i.i:  ; preds = %B0.endif.endif.endif.else.endif.endif.if.i.i, %B0.endif.endif.endif.else.endif.endif.i.i
  %.739.i.sroa.11.1.i = phi i64 [ 0, %B0.endif.endif.endif.else.endif.endif.if.i.i ], [ %.768.i.i, %B0.endif.endif.endif.else.endif.endif.i.i ]
  %.776.i.not.i = icmp slt i64 %.768.i.i, %arg.linear.1.5.0
  br i1 %.776.i.not.i, label %B0.endif.endif.endif.endif.i.i, label %B0.endif.endif.endif.else.endif.endif.endif.if.i.i, !prof !29

B0.endif.endif.endif.else.endif.endif.endif.if.i.i: ; preds = %B0.endif.endif.endif.else.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.i.i

B0.endif.endif.endif.endif.endif.i.i:             ; preds = %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i
  %.917.i.sroa.11.0.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i ], [ %.917.i.sroa.11.1.i, %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i ]
  %.1005.i.i = sub i64 %.917.i.sroa.11.0.i, %spec.select2369.i
  %.1014.i.i = tail call i64 @llvm.smax.i64(i64 %.1005.i.i, i64 0)
  %.1030.i.i = getelementptr i64, ptr %arg.linear.1.4, i64 %spec.select2369.i
  br i1 %.1162.i2379.not.i, label %B412.i.i, label %B330.if.i.i.preheader

B330.if.i.i.preheader:                            ; preds = %B0.endif.endif.endif.endif.endif.i.i
  %brmerge = select i1 %min.iters.check7686, i1 true, i1 %conflict.rdx7684
  br i1 %brmerge, label %B330.if.i.i.preheader7705, label %vector.body7690

vector.body7690:                                  ; preds = %B330.if.i.i.preheader, %vector.body7690
  %index7691 = phi i64 [ %index.next7694, %vector.body7690 ], [ 0, %B330.if.i.i.preheader ]
  %108 = getelementptr double, ptr %arg.arrays.0.4, i64 %index7691
  %109 = getelementptr i8, ptr %108, i64 16
  %wide.load7692 = load <2 x double>, ptr %108, align 8, !noalias !30
  %wide.load7693 = load <2 x double>, ptr %109, align 8, !noalias !30
  %110 = getelementptr i8, ptr %108, i64 %.idx2421.i
  %111 = getelementptr i8, ptr %110, i64 16
  store <2 x double> %wide.load7692, ptr %110, align 8, !noalias !30
  store <2 x double> %wide.load7693, ptr %111, align 8, !noalias !30
  %112 = getelementptr i8, ptr %108, i64 %.idx2422.i
  %113 = getelementptr i8, ptr %112, i64 16
  store <2 x double> zeroinitializer, ptr %112, align 8, !noalias !30
  store <2 x double> zeroinitializer, ptr %113, align 8, !noalias !30
  %index.next7694 = add i64 %index7691, 4
  %114 = icmp eq i64 %index.next7694, %n.vec7689
  br i1 %114, label %middle.block7695, label %vector.body7690, !llvm.loop !45

middle.block7695:                                 ; preds = %vector.body7690
  br i1 %cmp.n7696, label %B412.i.i, label %B330.if.i.i.preheader7705

B330.if.i.i.preheader7705:                        ; preds = %B330.if.i.i.preheader, %middle.block7695
  %.1104.i.02380.i.ph = phi i64 [ %n.vec7689, %middle.block7695 ], [ 0, %B330.if.i.i.preheader ]
  br label %B330.if.i.i

B0.endif.endif.endif.endif.else.endif.if.i.i:     ; preds = %B0.endif.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.endif.else.endif.endif.i.i:  ; preds = %B0.endif.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.endif.i.i
  %simplifycfg.merge8.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.endif.i.i ]
  %115 = or i1 %.771.i.i, %.937.i.i
  %spec.select2369.i = select i1 %115, i64 %simplifycfg.merge8.i, i64 %.768.i.i, !prof !44
  %.944.i.i = icmp slt i64 %.890.i.i, 0
  %.945.i.i = select i1 %.944.i.i, i64 %arg.linear.1.5.0, i64 0
  %.946.i.i = add i64 %.945.i.i, %.890.i.i
  %.949.i.i = icmp slt i64 %.946.i.i, 0
  br i1 %.949.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.if.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i, !prof !36

B0.endif.endif.endif.endif.else.endif.endif.if.i.i: ; preds = %B0.endif.endif.endif.endif.else.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i

B0.endif.endif.endif.endif.else.endif.endif.endif.i.i: ; preds = %B0.endif.endif.endif.endif.else.endif.endif.if.i.i, %B0.endif.endif.endif.endif.else.endif.endif.i.i
  %.917.i.sroa.11.1.i = phi i64 [ 0, %B0.endif.endif.endif.endif.else.endif.endif.if.i.i ], [ %.946.i.i, %B0.endif.endif.endif.endif.else.endif.endif.i.i ]
  %.954.i.not.i = icmp slt i64 %.946.i.i, %arg.linear.1.5.0
  br i1 %.954.i.not.i, label %B0.endif.endif.endif.endif.endif.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i, !prof !29

B0.endif.endif.endif.endif.else.endif.endif.endif.if.i.i: ; preds = %B0.endif.endif.endif.endif.else.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.endif.i.i

B330.if.i.i:                                      ; preds = %B330.if.i.i.preheader7705, %B330.if.i.i
  %.1104.i.02380.i = phi i64 [ %.1175.i.i, %B330.if.i.i ], [ %.1104.i.02380.i.ph, %B330.if.i.i.preheader7705 ]
  %.1175.i.i = add nsw i64 %.1104.i.02380.i, 1
  %116 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1104.i.02380.i
  %.1229.i.i = load double, ptr %116, align 8, !noalias !30
  %117 = getelementptr i8, ptr %116, i64 %.idx2421.i
  store double %.1229.i.i, ptr %117, align 8, !noalias !30
  %118 = getelementptr i8, ptr %116, i64 %.idx2422.i
  store double 0.000000e+00, ptr %118, align 8, !noalias !30
  %exitcond.not.i7096 = icmp eq i64 %arg.shape.1, %.1175.i.i
  br i1 %exitcond.not.i7096, label %B412.i.i, label %B330.if.i.i, !llvm.loop !46

B544.if.i.i:                                      ; preds = %B544.if.i.i.preheader7704, %B544.if.i.i
  %.1503.i.02384.i = phi i64 [ %.1565.i.i, %B544.if.i.i ], [ %.1503.i.02384.i.ph, %B544.if.i.i.preheader7704 ]
  %.1500.i.02383.i = phi i64 [ %.1569.i.i, %B544.if.i.i ], [ %.1500.i.02383.i.ph, %B544.if.i.i.preheader7704 ]
  %.1565.i.i = add nsw i64 %.1503.i.02384.i, -1
  %.1569.i.i = add nsw i64 %.1500.i.02383.i, 1
  %119 = getelementptr i64, ptr %.327.i.i, i64 %.1500.i.02383.i
  %.1627.i.i = load i64, ptr %119, align 8, !noalias !30
  %.1629.i.i = icmp eq i64 %.1627.i.i, %.1382.i.sroa.0.02409.i
  %..i = select i1 %.1629.i.i, double 1.000000e+00, double 0.000000e+00
  %gep = getelementptr double, ptr %invariant.gep, i64 %.1500.i.02383.i
  store double %..i, ptr %gep, align 8, !noalias !30
  %.1556.i.i = icmp sgt i64 %.1503.i.02384.i, 1
  br i1 %.1556.i.i, label %B544.if.i.i, label %B610.i.i, !llvm.loop !47

B794.if.i.i:                                      ; preds = %B610.i.i, %B910.i.i
  %found.2.i.22388.i = phi i1 [ %"$phi910.2.2.i.3.i", %B910.i.i ], [ true, %B610.i.i ]
  %.1924.i.02387.i = phi i64 [ %.1989.i.i, %B910.i.i ], [ %.1934.i.i, %B610.i.i ]
  %.1921.i.02386.i = phi i64 [ %.1993.i.i, %B910.i.i ], [ %.1865.i.i, %B610.i.i ]
  %.1989.i.i = add nsw i64 %.1924.i.02387.i, -1
  %.1993.i.i = add i64 %.1921.i.02386.i, 1
  br i1 %found.2.i.22388.i, label %B802.i.i, label %B910.i.i

B1022.if.i.i:                                     ; preds = %B960.i.i, %B1261.i.i
  %.2333.i.02402.i = phi i64 [ %.2395.i.i, %B1261.i.i ], [ %.2343.i.i, %B960.i.i ]
  %.2330.i.02401.i = phi i64 [ %.2399.i.i, %B1261.i.i ], [ %.2272.i.i, %B960.i.i ]
  %.2395.i.i = add nsw i64 %.2333.i.02402.i, -1
  %.2399.i.i = add i64 %.2330.i.02401.i, 1
  %.2443.i.i = icmp slt i64 %.2330.i.02401.i, 0
  %.2444.i.i = select i1 %.2443.i.i, i64 %.665.i.i, i64 0
  %120 = getelementptr i64, ptr %.681.i.i, i64 %.2330.i.02401.i
  %.2458.i.i = getelementptr i64, ptr %120, i64 %.2444.i.i
  %.2459.i.i = load i64, ptr %.2458.i.i, align 8, !noalias !30
  %.2460.i.i = add nsw i64 %.2459.i.i, %.1789.i.i
  %.2474.i.i = icmp slt i64 %.2460.i.i, 0
  %.2475.i.i = select i1 %.2474.i.i, i64 %arg.arrays.0.5.0, i64 0
  %121 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2460.i.i
  %.2489.i.i = getelementptr double, ptr %121, i64 %.2475.i.i
  %.2490.i.i = load double, ptr %.2489.i.i, align 8, !noalias !30
  br i1 %found.3.i.1.i, label %B1162.i.i, label %B1080.i.i

B164.i:                                           ; preds = %B474.i.loopexit.i, %B0.endif.else.endif.endif.i, %B412.i.i
  %.634.i = load i64, ptr %arg.linear.1.4, align 8, !noalias !48
  %.664.i = load i64, ptr %.663.i, align 8, !noalias !48
  br i1 %.711.i, label %B226.if.lr.ph.i, label %B1276.if.preheader

B226.if.lr.ph.i:                                  ; preds = %B164.i
  %.829.i = add i64 %.634.i, 1
  %122 = add i64 %.664.i, %.634.i
  br label %B226.if.i

B396.i:                                           ; preds = %B342.if.i, %B226.if.i
  %.1055.i = mul i64 %.697.02414.i, %.743.sroa.0.02358.i
  %.1071.i = icmp slt i64 %.1055.i, 0
  %.1072.i7089 = select i1 %.1071.i, i64 %.251.i, i64 0
  %123 = getelementptr double, ptr %.267.i, i64 %.1055.i
  %.1086.i = getelementptr double, ptr %123, i64 %.1072.i7089
  %.1087.i7090 = load double, ptr %.1086.i, align 8, !noalias !48
  %.1141.i = load double, ptr %.1140.i, align 8, !noalias !48
  %.1142.i = fadd double %.1087.i7090, %.1141.i
  store double %.1142.i, ptr %.1086.i, align 8, !noalias !48
  %exitcond2420.not.i = icmp eq i64 %.766.i, %arg.shape.1
  br i1 %exitcond2420.not.i, label %B468.i, label %B226.if.i

B468.i:                                           ; preds = %B396.i
  %.199.i.i = add i64 %.664.i, 1
  br label %B36.if.i.i

B34.loopexit.i.i:                                 ; preds = %B790.i.i, %B528.i.i
  %exitcond.not.i.i = icmp eq i64 %.131.i.i, %arg.shape.1
  br i1 %exitcond.not.i.i, label %B1276.if.preheader, label %B36.if.i.i

B348.i.i:                                         ; preds = %B234.if.i.i, %B36.if.i.i
  %p.2.1.lcssa.i.i = phi i64 [ %.59.0509.i.i, %B36.if.i.i ], [ %p.3.2.i.i, %B234.if.i.i ]
  %124 = getelementptr i64, ptr %.437.i7085, i64 %.59.0509.i.i
  store i64 %p.2.1.lcssa.i.i, ptr %124, align 8, !noalias !49
  %.547.i.i = add nsw i64 %p.2.1.lcssa.i.i, %.161.i.i
  %.561.i.i = icmp slt i64 %.547.i.i, 0
  %.562.i.i = select i1 %.561.i.i, i64 %.251.i, i64 0
  %125 = getelementptr double, ptr %.267.i, i64 %.547.i.i
  %.576.i.i = getelementptr double, ptr %125, i64 %.562.i.i
  %.577.i.i = load double, ptr %.576.i.i, align 8, !noalias !49
  %.610.i.i = load double, ptr %127, align 8, !noalias !49
  store double %.577.i.i, ptr %127, align 8, !noalias !49
  store double %.610.i.i, ptr %.576.i.i, align 8, !noalias !49
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
  %.11.i.i.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.165.i.i, i64 %arg.shape.1)
  %.200.i.i = add i64 %.199.i.i, %.164.i.i
  %.11.i492.i.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.200.i.i, i64 %arg.shape.1)
  %126 = getelementptr double, ptr %.267.i, i64 %.161.i.i
  %127 = getelementptr double, ptr %126, i64 %.59.0509.i.i
  %.319.i.i = sub i64 %.11.i.i.i, %.131.i.i
  %storemerge488.i.i = tail call i64 @llvm.smax.i64(i64 %.319.i.i, i64 0)
  %.362493.not.i.i = icmp slt i64 %.319.i.i, 1
  br i1 %.362493.not.i.i, label %B348.i.i, label %B234.if.preheader.i.i

B234.if.preheader.i.i:                            ; preds = %B36.if.i.i
  %.271.i.i = load double, ptr %127, align 8, !noalias !49
  %.272.i.i = tail call double @llvm.fabs.f64(double %.271.i.i)
  br label %B234.if.i.i

B234.if.i.i:                                      ; preds = %B234.if.i.i, %B234.if.preheader.i.i
  %p.2.1497.i.i = phi i64 [ %p.3.2.i.i, %B234.if.i.i ], [ %.59.0509.i.i, %B234.if.preheader.i.i ]
  %largest.2.1496.i.i = phi double [ %largest.3.2.i.i, %B234.if.i.i ], [ %.272.i.i, %B234.if.preheader.i.i ]
  %.309.0495.i.i = phi i64 [ %.371.i.i, %B234.if.i.i ], [ %storemerge488.i.i, %B234.if.preheader.i.i ]
  %.306.0494.i.i = phi i64 [ %.375.i.i, %B234.if.i.i ], [ %.131.i.i, %B234.if.preheader.i.i ]
  %.371.i.i = add nsw i64 %.309.0495.i.i, -1
  %.375.i.i = add i64 %.306.0494.i.i, 1
  %.415.i.i7091 = add nsw i64 %.306.0494.i.i, %.161.i.i
  %.429.i.i = icmp slt i64 %.415.i.i7091, 0
  %.430.i.i = select i1 %.429.i.i, i64 %.251.i, i64 0
  %128 = getelementptr double, ptr %.267.i, i64 %.415.i.i7091
  %.444.i.i = getelementptr double, ptr %128, i64 %.430.i.i
  %.445.i.i = load double, ptr %.444.i.i, align 8, !noalias !49
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
  %129 = getelementptr double, ptr %.267.i, i64 %.798.i.i
  %.827.i2372.i = getelementptr double, ptr %129, i64 %.813.i.i
  %.828.i.i = load double, ptr %.827.i2372.i, align 8, !noalias !49
  %.861.i.i = load double, ptr %127, align 8, !noalias !49
  %.865.i.i = fdiv double %.828.i.i, %.861.i.i
  store double %.865.i.i, ptr %.827.i2372.i, align 8, !noalias !49
  %.759.i2373.i = icmp sgt i64 %.706.0500.i.i, 1
  br i1 %.759.i2373.i, label %B466.if.i.i, label %B528.i.i

B566.if.i.i:                                      ; preds = %B528.i.i, %B790.i.i
  %.932.0506.i.i = phi i64 [ %.994.i.i, %B790.i.i ], [ %.942.i.i, %B528.i.i ]
  %.929.0505.i.i = phi i64 [ %.998.i.i, %B790.i.i ], [ %.131.i.i, %B528.i.i ]
  %.994.i.i = add nsw i64 %.932.0506.i.i, -1
  %.998.i.i = add i64 %.929.0505.i.i, 1
  %130 = mul nsw i64 %.929.0505.i.i, %arg.shape.1
  %.1030.i2374.i = add nsw i64 %130, %p.2.1.lcssa.i.i
  %.1044.i.i = icmp slt i64 %.1030.i2374.i, 0
  %.1045.i.i = select i1 %.1044.i.i, i64 %.251.i, i64 0
  %131 = getelementptr double, ptr %.267.i, i64 %.1030.i2374.i
  %.1059.i.i = getelementptr double, ptr %131, i64 %.1045.i.i
  %.1060.i.i = load double, ptr %.1059.i.i, align 8, !noalias !49
  %.1068.i.i = add nsw i64 %130, %.59.0509.i.i
  %.1082.i.i = icmp slt i64 %.1068.i.i, 0
  %.1083.i.i = select i1 %.1082.i.i, i64 %.251.i, i64 0
  %132 = getelementptr double, ptr %.267.i, i64 %.1068.i.i
  %.1097.i.i = getelementptr double, ptr %132, i64 %.1083.i.i
  %.1098.i.i = load double, ptr %.1097.i.i, align 8, !noalias !49
  store double %.1098.i.i, ptr %.1059.i.i, align 8, !noalias !49
  store double %.1060.i.i, ptr %.1097.i.i, align 8, !noalias !49
  %.1171.i2375.i = fcmp oeq double %.1060.i.i, 0.000000e+00
  %brmerge.i.i = or i1 %.362493.not.i.i, %.1171.i2375.i
  br i1 %brmerge.i.i, label %B790.i.i, label %B716.if.i.i

B716.if.i.i:                                      ; preds = %B566.if.i.i, %B716.if.i.i
  %.1202.0503.i.i = phi i64 [ %.1264.i2376.i, %B716.if.i.i ], [ %storemerge488.i.i, %B566.if.i.i ]
  %.1199.0502.i.i = phi i64 [ %.1268.i.i, %B716.if.i.i ], [ %.131.i.i, %B566.if.i.i ]
  %.1264.i2376.i = add nsw i64 %.1202.0503.i.i, -1
  %.1268.i.i = add i64 %.1199.0502.i.i, 1
  %.1296.i.i = add nsw i64 %.1199.0502.i.i, %130
  %.1310.i.i = icmp slt i64 %.1296.i.i, 0
  %.1311.i2377.i = select i1 %.1310.i.i, i64 %.251.i, i64 0
  %133 = getelementptr double, ptr %.267.i, i64 %.1296.i.i
  %.1325.i.i = getelementptr double, ptr %133, i64 %.1311.i2377.i
  %.1326.i.i = load double, ptr %.1325.i.i, align 8, !noalias !49
  %.1328.i.i = add nsw i64 %.1199.0502.i.i, %.161.i.i
  %.1342.i.i = icmp slt i64 %.1328.i.i, 0
  %.1343.i.i = select i1 %.1342.i.i, i64 %.251.i, i64 0
  %134 = getelementptr double, ptr %.267.i, i64 %.1328.i.i
  %.1357.i.i = getelementptr double, ptr %134, i64 %.1343.i.i
  %.1358.i.i = load double, ptr %.1357.i.i, align 8, !noalias !49
  %.1360.i.i = fmul double %.1060.i.i, %.1358.i.i
  %.1361.i.i = fsub double %.1326.i.i, %.1360.i.i
  store double %.1361.i.i, ptr %.1325.i.i, align 8, !noalias !49
  %.1255.i.i = icmp sgt i64 %.1202.0503.i.i, 1
  br i1 %.1255.i.i, label %B716.if.i.i, label %B790.i.i

B0.else.endif.if.i:                               ; preds = %B1110
  br label %B0.else.endif.endif.endif.if.i

B0.else.endif.endif.endif.if.i:                   ; preds = %B0.else.endif.if.i, %B1110
  %.154.sroa.0.3.i = phi i64 [ %arg.linear.0.5.0, %B0.else.endif.if.i ], [ %.127.i, %B1110 ]
  %.242.i = sub nsw i64 %arg.linear.0.5.0, %.154.sroa.0.3.i
  %.251.i = tail call i64 @llvm.smax.i64(i64 %.242.i, i64 0)
  %.267.i = getelementptr double, ptr %arg.linear.0.4, i64 %.154.sroa.0.3.i
  br i1 %.344.i, label %B0.endif.else.endif.if.i, label %B0.endif.else.endif.endif.i, !prof !36

B0.endif.else.endif.if.i:                         ; preds = %B0.else.endif.endif.endif.if.i
  br label %B0.endif.else.endif.endif.i

B0.endif.else.endif.endif.i:                      ; preds = %B0.endif.else.endif.if.i, %B0.else.endif.endif.endif.if.i
  %.324.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.if.i ], [ 5, %B0.else.endif.endif.endif.if.i ]
  %.437.i7085 = getelementptr i64, ptr %arg.linear.1.4, i64 %.324.sroa.0.3.i
  %.525.i7086 = load double, ptr %.524.i, align 8, !noalias !48
  %.526.i = fcmp olt double %.525.i7086, 5.000000e-01
  br i1 %.526.i, label %B124.i, label %B164.i

B226.if.i:                                        ; preds = %B396.i, %B226.if.lr.ph.i
  %.697.02414.i = phi i64 [ 0, %B226.if.lr.ph.i ], [ %.766.i, %B396.i ]
  %.766.i = add nsw i64 %.697.02414.i, 1
  %.798.i = sub i64 %.697.02414.i, %122
  %.11.i.i = tail call i64 @llvm.smax.i64(i64 %.798.i, i64 0)
  %.830.i = add i64 %.829.i, %.697.02414.i
  %.11.i2378.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.830.i, i64 %arg.shape.1)
  %.896.i = sub i64 %.11.i2378.i, %.11.i.i
  %.9392410.not.i = icmp slt i64 %.896.i, 1
  br i1 %.9392410.not.i, label %B396.i, label %B342.if.lr.ph.i

B342.if.lr.ph.i:                                  ; preds = %B226.if.i
  %.979.i7087 = mul nsw i64 %.697.02414.i, %arg.shape.1
  br label %B342.if.i

B342.if.i:                                        ; preds = %B342.if.i, %B342.if.lr.ph.i
  %.886.02412.i = phi i64 [ %.896.i, %B342.if.lr.ph.i ], [ %.948.i, %B342.if.i ]
  %.883.02411.i = phi i64 [ %.11.i.i, %B342.if.lr.ph.i ], [ %.952.i, %B342.if.i ]
  %.948.i = add nsw i64 %.886.02412.i, -1
  %.952.i = add i64 %.883.02411.i, 1
  %.980.i = add nsw i64 %.883.02411.i, %.979.i7087
  %.994.i = icmp slt i64 %.980.i, 0
  %.995.i = select i1 %.994.i, i64 %arg.linear.0.5.0, i64 0
  %135 = getelementptr double, ptr %arg.linear.0.4, i64 %.980.i
  %.1009.i = getelementptr double, ptr %135, i64 %.995.i
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !48
  %.1011.i7088 = fneg double %.1010.i
  %.1030.i = select i1 %.994.i, i64 %.251.i, i64 0
  %136 = getelementptr double, ptr %.267.i, i64 %.980.i
  %.1044.i = getelementptr double, ptr %136, i64 %.1030.i
  store double %.1011.i7088, ptr %.1044.i, align 8, !noalias !48
  %.939.i = icmp sgt i64 %.886.02412.i, 1
  br i1 %.939.i, label %B342.if.i, label %B396.i

B1244.critedge:                                   ; preds = %B1000
  %.1659.c = load i64, ptr %.1658.c, align 8
  %.1704.c = inttoptr i64 %.1659.c to ptr
  tail call void %.1704.c(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B1276.if.preheader

B1276.if.preheader:                               ; preds = %B34.loopexit.i.i, %B164.i, %B1244.critedge
  br label %B1276.if

B1464:                                            ; preds = %B1276.if
  br i1 %.88.not.i, label %B0.else.endif.endif.endif.if.i7099, label %B0.else.endif.if.i7098, !prof !29

B322.i:                                           ; preds = %B192.if.i
  %.853.i7106 = load i64, ptr %arg.linear.1.4, align 8, !noalias !52
  %.883.i = load i64, ptr %.882.i, align 8, !noalias !52
  %.339.i.i7107 = add i64 %.853.i7106, 1
  br label %B34.if.i.i7108

B34.i.loopexit.i:                                 ; preds = %B198.if.i.i, %B34.if.i.i7108
  %exitcond766.not.i = icmp eq i64 %arg.shape.1, %.144.i.i
  br i1 %exitcond766.not.i, label %B314.if.i.lr.ph.i, label %B34.if.i.i7108

B314.if.i.lr.ph.i:                                ; preds = %B34.i.loopexit.i
  %137 = add i64 %.883.i, %.853.i7106
  br label %B314.if.i.i

B314.i.loopexit.i:                                ; preds = %B474.if.i.i, %B314.if.i.i
  %.683.i.i = icmp sgt i64 %.627.i.0762.in.i, 1
  br i1 %.683.i.i, label %B314.if.i.i, label %B434.if.lr.ph.i

B434.if.lr.ph.i:                                  ; preds = %B314.i.loopexit.i
  %.1110.i = mul nsw i64 %.1860, %arg.shape.1
  %invariant.gep7718 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1110.i
  br label %B434.if.i

B34.if.i.i7108:                                   ; preds = %B34.i.loopexit.i, %B322.i
  %.73.i.0754.i = phi i64 [ 0, %B322.i ], [ %.144.i.i, %B34.i.loopexit.i ]
  %.144.i.i = add nsw i64 %.73.i.0754.i, 1
  %138 = getelementptr i64, ptr %.358.i, i64 %.73.i.0754.i
  %.202.i.i = load i64, ptr %138, align 8, !noalias !55
  %.204.i.i = add nsw i64 %.202.i.i, %.887.i
  %.218.i.i = icmp slt i64 %.204.i.i, 0
  %.219.i.i = select i1 %.218.i.i, i64 %arg.arrays.0.5.0, i64 0
  %139 = getelementptr double, ptr %arg.arrays.0.4, i64 %.204.i.i
  %.233.i.i = getelementptr double, ptr %139, i64 %.219.i.i
  %.234.i.i7109 = load double, ptr %.233.i.i, align 8, !noalias !55
  %gep7433 = getelementptr double, ptr %invariant.gep7432, i64 %.73.i.0754.i
  %.270.i.i = load double, ptr %gep7433, align 8, !noalias !55
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !55
  store double %.234.i.i7109, ptr %gep7433, align 8, !noalias !55
  %.340.i.i = add i64 %.339.i.i7107, %.73.i.0754.i
  %.11.i.i.i7110 = tail call i64 @llvm.smin.i64(i64 %.340.i.i, i64 %arg.shape.1)
  %.406.i.i = sub i64 %.11.i.i.i7110, %.144.i.i
  %.449.i750.not.i = icmp slt i64 %.406.i.i, 1
  br i1 %.449.i750.not.i, label %B34.i.loopexit.i, label %B198.if.i.lr.ph.i

B198.if.i.lr.ph.i:                                ; preds = %B34.if.i.i7108
  %.521.i.i = mul nsw i64 %.73.i.0754.i, %arg.shape.1
  br label %B198.if.i.i

B198.if.i.i:                                      ; preds = %B198.if.i.i, %B198.if.i.lr.ph.i
  %.396.i.0752.i = phi i64 [ %.406.i.i, %B198.if.i.lr.ph.i ], [ %.458.i.i, %B198.if.i.i ]
  %.393.i.0751.i = phi i64 [ %.144.i.i, %B198.if.i.lr.ph.i ], [ %.462.i.i, %B198.if.i.i ]
  %.458.i.i = add nsw i64 %.396.i.0752.i, -1
  %.462.i.i = add i64 %.393.i.0751.i, 1
  %.488.i.i = add nsw i64 %.393.i.0751.i, %.887.i
  %.502.i.i7111 = icmp slt i64 %.488.i.i, 0
  %.503.i.i = select i1 %.502.i.i7111, i64 %arg.arrays.0.5.0, i64 0
  %140 = getelementptr double, ptr %arg.arrays.0.4, i64 %.488.i.i
  %.517.i.i = getelementptr double, ptr %140, i64 %.503.i.i
  %.518.i.i = load double, ptr %.517.i.i, align 8, !noalias !55
  %.522.i.i = add nsw i64 %.393.i.0751.i, %.521.i.i
  %.536.i.i = icmp slt i64 %.522.i.i, 0
  %.537.i.i = select i1 %.536.i.i, i64 %.165.i, i64 0
  %141 = getelementptr double, ptr %.181.i, i64 %.522.i.i
  %.551.i.i = getelementptr double, ptr %141, i64 %.537.i.i
  %.552.i.i = load double, ptr %.551.i.i, align 8, !noalias !55
  %.554.i.i = fmul double %.234.i.i7109, %.552.i.i
  %.555.i.i = fsub double %.518.i.i, %.554.i.i
  store double %.555.i.i, ptr %.517.i.i, align 8, !noalias !55
  %.449.i.i = icmp sgt i64 %.396.i.0752.i, 1
  br i1 %.449.i.i, label %B198.if.i.i, label %B34.i.loopexit.i

B314.if.i.i:                                      ; preds = %B314.i.loopexit.i, %B314.if.i.lr.ph.i
  %.627.i.0762.in.i = phi i64 [ %arg.shape.1, %B314.if.i.lr.ph.i ], [ %.627.i.0762.i, %B314.i.loopexit.i ]
  %.627.i.0762.i = add nsw i64 %.627.i.0762.in.i, -1
  %.726.i.i = add nsw i64 %.627.i.0762.i, %.887.i
  %.740.i.i = icmp slt i64 %.726.i.i, 0
  %.741.i.i = select i1 %.740.i.i, i64 %arg.arrays.0.5.0, i64 0
  %142 = getelementptr double, ptr %arg.arrays.0.4, i64 %.726.i.i
  %.755.i.i = getelementptr double, ptr %142, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i, align 8, !noalias !55
  %.759.i.i7112 = mul nsw i64 %.627.i.0762.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i7112, %.627.i.0762.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %.165.i, i64 0
  %143 = getelementptr double, ptr %.181.i, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %143, i64 %.776.i.i
  %.791.i.i = load double, ptr %.790.i.i, align 8, !noalias !55
  %.795.i.i = fdiv double %.756.i.i, %.791.i.i
  store double %.795.i.i, ptr %.755.i.i, align 8, !noalias !55
  %.866.i.i = sub i64 %.627.i.0762.i, %137
  %.11.i4.i.i = tail call i64 @llvm.smax.i64(i64 %.866.i.i, i64 0)
  %.932.i.i = sub i64 %.627.i.0762.i, %.11.i4.i.i
  %.975.i756.not.i = icmp slt i64 %.932.i.i, 1
  br i1 %.975.i756.not.i, label %B314.i.loopexit.i, label %B474.if.i.i

B474.if.i.i:                                      ; preds = %B314.if.i.i, %B474.if.i.i
  %.922.i.0758.i = phi i64 [ %.984.i.i, %B474.if.i.i ], [ %.932.i.i, %B314.if.i.i ]
  %.919.i.0757.i = phi i64 [ %.988.i.i, %B474.if.i.i ], [ %.11.i4.i.i, %B314.if.i.i ]
  %.984.i.i = add nsw i64 %.922.i.0758.i, -1
  %.988.i.i = add i64 %.919.i.0757.i, 1
  %.1014.i.i7113 = add nsw i64 %.919.i.0757.i, %.887.i
  %.1028.i.i = icmp slt i64 %.1014.i.i7113, 0
  %.1029.i.i = select i1 %.1028.i.i, i64 %arg.arrays.0.5.0, i64 0
  %144 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1014.i.i7113
  %.1043.i.i = getelementptr double, ptr %144, i64 %.1029.i.i
  %.1044.i.i7114 = load double, ptr %.1043.i.i, align 8, !noalias !55
  %.1048.i.i = add nsw i64 %.919.i.0757.i, %.759.i.i7112
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %.165.i, i64 0
  %145 = getelementptr double, ptr %.181.i, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %145, i64 %.1063.i.i
  %.1078.i.i = load double, ptr %.1077.i.i, align 8, !noalias !55
  %.1080.i.i = fmul double %.795.i.i, %.1078.i.i
  %.1081.i.i = fsub double %.1044.i.i7114, %.1080.i.i
  store double %.1081.i.i, ptr %.1043.i.i, align 8, !noalias !55
  %.975.i.i = icmp sgt i64 %.922.i.0758.i, 1
  br i1 %.975.i.i, label %B474.if.i.i, label %B314.i.loopexit.i

B0.else.endif.if.i7098:                           ; preds = %B1464
  br label %B0.else.endif.endif.endif.if.i7099

B0.else.endif.endif.endif.if.i7099:               ; preds = %B0.else.endif.if.i7098, %B1464
  %.68.sroa.0.3.i = phi i64 [ %arg.linear.0.5.0, %B0.else.endif.if.i7098 ], [ %.42.i, %B1464 ]
  %.156.i = sub nsw i64 %arg.linear.0.5.0, %.68.sroa.0.3.i
  %.165.i = tail call i64 @llvm.smax.i64(i64 %.156.i, i64 0)
  %.181.i = getelementptr double, ptr %arg.linear.0.4, i64 %.68.sroa.0.3.i
  br i1 %.265.i, label %B0.endif.else.endif.if.i7116, label %B0.endif.else.endif.endif.i7100, !prof !36

B0.endif.else.endif.if.i7116:                     ; preds = %B0.else.endif.endif.endif.if.i7099
  br label %B0.endif.else.endif.endif.i7100

B0.endif.else.endif.endif.i7100:                  ; preds = %B0.endif.else.endif.if.i7116, %B0.else.endif.endif.endif.if.i7099
  %.245.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.if.i7116 ], [ 5, %B0.else.endif.endif.endif.if.i7099 ]
  %.358.i = getelementptr i64, ptr %arg.linear.1.4, i64 %.245.sroa.0.3.i
  br i1 %.277.i, label %B0.endif.endif.else.if.i, label %B0.endif.endif.else.endif.i, !prof !36

B192.if.lr.ph.i:                                  ; preds = %B0.endif.endif.else.endif.endif.endif.i
  %.689.i = mul nsw i64 %.1860, %arg.shape.1
  %invariant.gep7716 = getelementptr double, ptr %arg.arrays.0.4, i64 %.689.i
  br label %B192.if.i

B0.endif.endif.else.if.i:                         ; preds = %B0.endif.else.endif.endif.i7100
  br label %B0.endif.endif.else.endif.i

B0.endif.endif.else.endif.i:                      ; preds = %B0.endif.endif.else.if.i, %B0.endif.else.endif.endif.i7100
  %.418.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.else.if.i ], [ %.274.i7101, %B0.endif.else.endif.endif.i7100 ]
  br i1 %.282.not.i, label %B0.endif.endif.else.endif.endif.endif.i, label %B0.endif.endif.else.endif.if.i, !prof !29

B0.endif.endif.else.endif.if.i:                   ; preds = %B0.endif.endif.else.endif.i
  br label %B0.endif.endif.else.endif.endif.endif.i

B0.endif.endif.else.endif.endif.endif.i:          ; preds = %B0.endif.endif.else.endif.if.i, %B0.endif.endif.else.endif.i
  %.418.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.if.i ], [ %.418.sroa.0.1.i, %B0.endif.endif.else.endif.i ]
  %.531.i = getelementptr i64, ptr %arg.linear.1.4, i64 %.418.sroa.0.3.i
  br i1 %.648747.not.i, label %B1500, label %B192.if.lr.ph.i

B192.if.i:                                        ; preds = %B192.if.i, %B192.if.lr.ph.i
  %.590.0748.i = phi i64 [ 0, %B192.if.lr.ph.i ], [ %.661.i7103, %B192.if.i ]
  %.661.i7103 = add nsw i64 %.590.0748.i, 1
  %gep7717 = getelementptr double, ptr %invariant.gep7716, i64 %.590.0748.i
  %.720.i = load double, ptr %gep7717, align 8, !noalias !52
  %gep7431 = getelementptr double, ptr %invariant.gep7430, i64 %.590.0748.i
  %.753.i = load double, ptr %gep7431, align 8, !noalias !52
  %.754.i = fadd double %.720.i, %.753.i
  %146 = getelementptr i64, ptr %.531.i, i64 %.590.0748.i
  %.786.i = load i64, ptr %146, align 8, !noalias !52
  %.787.i = add nsw i64 %.786.i, %.756.i
  %.801.i = icmp slt i64 %.787.i, 0
  %.802.i = select i1 %.801.i, i64 %arg.arrays.0.5.0, i64 0
  %147 = getelementptr double, ptr %arg.arrays.0.4, i64 %.787.i
  %.816.i = getelementptr double, ptr %147, i64 %.802.i
  store double %.754.i, ptr %.816.i, align 8, !noalias !52
  %exitcond.not.i7105 = icmp eq i64 %arg.shape.1, %.661.i7103
  br i1 %exitcond.not.i7105, label %B322.i, label %B192.if.i

B434.if.i:                                        ; preds = %B434.if.i, %B434.if.lr.ph.i
  %.950.0764.i = phi i64 [ 0, %B434.if.lr.ph.i ], [ %.1019.i, %B434.if.i ]
  %.1019.i = add nsw i64 %.950.0764.i, 1
  %148 = getelementptr i64, ptr %.531.i, i64 %.950.0764.i
  %.1075.i = load i64, ptr %148, align 8, !noalias !52
  %.1076.i = add nsw i64 %.1075.i, %.887.i
  %.1090.i = icmp slt i64 %.1076.i, 0
  %.1091.i = select i1 %.1090.i, i64 %arg.arrays.0.5.0, i64 0
  %149 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1076.i
  %.1105.i = getelementptr double, ptr %149, i64 %.1091.i
  %.1106.i = load double, ptr %.1105.i, align 8, !noalias !52
  %gep7719 = getelementptr double, ptr %invariant.gep7718, i64 %.950.0764.i
  store double %.1106.i, ptr %gep7719, align 8, !noalias !52
  %exitcond767.not.i = icmp eq i64 %arg.shape.1, %.1019.i
  br i1 %exitcond767.not.i, label %B1500, label %B434.if.i

B1500:                                            ; preds = %B434.if.i, %B0.endif.endif.else.endif.endif.endif.i, %B1276.if
  %exitcond7538.not = icmp eq i64 %.1791.07434, %.
  br i1 %exitcond7538.not, label %B1502, label %B1276.if

B1502:                                            ; preds = %B1500
  %.2124 = load i64, ptr %.2123, align 8
  %.2169 = inttoptr i64 %.2124 to ptr
  tail call void %.2169(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.274.i, label %B2274, label %B1616.if

B1694:                                            ; preds = %B1616.if
  %.2505 = mul i64 %.2383, %arg.results.3.5.1
  %150 = getelementptr i64, ptr %arg.results.3.4, i64 %.2505
  %.2509 = getelementptr i8, ptr %150, i64 8
  %.2510 = load i64, ptr %.2509, align 8
  %.2513 = add nsw i64 %.2510, %.
  store i64 %.2513, ptr %.2509, align 8
  %.2619 = getelementptr double, ptr %274, i64 %.2215.07437
  %.2620 = load double, ptr %.2619, align 8
  %.2621 = fcmp ogt double %.2620, 5.000000e-01
  br i1 %.2621, label %B1784, label %B1830

B1784:                                            ; preds = %B1694
  %151 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2215.07437
  %.84.i771 = load i64, ptr %151, align 8, !noalias !59
  %.89.i774 = icmp sgt i64 %.84.i771, -1
  br i1 %.89.i774, label %B46.i, label %B1830

B46.i:                                            ; preds = %B1784
  %.120.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i771
  %.121.i786 = load i64, ptr %.120.i, align 8, !noalias !59
  %.122.i787 = icmp eq i64 %.121.i786, 0
  br i1 %.122.i787, label %B80.i, label %B1830

B80.i:                                            ; preds = %B46.i
  store i64 2, ptr %.120.i, align 8, !noalias !59
  br label %B1830

B1830:                                            ; preds = %B80.i, %B1784, %B46.i, %B1694
  %.2711 = getelementptr double, ptr %275, i64 %.2215.07437
  %.2712 = load double, ptr %.2711, align 8
  %.2713 = fcmp olt double %.2712, 5.000000e-01
  br i1 %.2713, label %B1868, label %B1916

B1868:                                            ; preds = %B1830
  %.2798 = getelementptr i8, ptr %150, i64 24
  %.2799 = load i64, ptr %.2798, align 8
  %.2800 = add nsw i64 %.2799, 1
  store i64 %.2800, ptr %.2798, align 8
  br label %B4108

B1916:                                            ; preds = %B1830
  %spec.select = select i1 %within.3.17441, i1 true, i1 %.2868
  %.2938 = load i64, ptr %150, align 8
  %.2939 = add nsw i64 %.2938, 1
  store i64 %.2939, ptr %150, align 8
  %.3046 = load i64, ptr %.2509, align 8
  %.3047 = add nsw i64 %.3046, 1
  store i64 %.3047, ptr %.2509, align 8
  %.3175.0 = and i64 %.2939, 127
  %.3205 = icmp eq i64 %.3175.0, 0
  %or.cond7410 = select i1 %doubted.2.17442, i1 true, i1 %.3205
  br i1 %or.cond7410, label %B2122, label %B2086

B2086:                                            ; preds = %B1916
  %.3262 = getelementptr double, ptr %276, i64 %.2215.07437
  %.3263 = load double, ptr %.3262, align 8
  %.3265 = fcmp ogt double %.3263, 0.000000e+00
  br label %B2122

B2122:                                            ; preds = %B2086, %B1916
  %"$phi2122.1.3.4" = phi i1 [ true, %B1916 ], [ %.3265, %B2086 ]
  %.3300 = icmp slt i64 %.2438, %arg.times.5.0
  br i1 %.3300, label %B2162, label %B4108

B2162:                                            ; preds = %B2122
  %.3330 = icmp slt i64 %.2438, 0
  %.3331 = select i1 %.3330, i64 %arg.times.5.0, i64 0
  %152 = getelementptr double, ptr %arg.times.4, i64 %.2438
  %.3345 = getelementptr double, ptr %152, i64 %.3331
  %.3346 = load double, ptr %.3345, align 8
  %.3400 = getelementptr double, ptr %277, i64 %.2215.07437
  %.3401 = load double, ptr %.3400, align 8
  %.3402 = fcmp ugt double %.3346, %.3401
  br i1 %.3402, label %B4108, label %B2212

B2212:                                            ; preds = %B2162
  %.3513 = fcmp olt double %.3346, %.3401
  %spec.select7074 = or i1 %spec.select, %.3513
  br label %B4108

B2274.loopexit:                                   ; preds = %B4108
  %153 = xor i1 %doubted.3.2, true
  %154 = select i1 %153, i1 true, i1 %.539
  %155 = select i1 %wanted.3.2, i1 true, i1 %within.4.2
  br label %B2274

B2274:                                            ; preds = %B2274.loopexit, %B1502
  %good.2.1.lcssa = phi i1 [ false, %B1502 ], [ %good.3.2, %B2274.loopexit ]
  %wanted.2.1.lcssa = phi i1 [ false, %B1502 ], [ %155, %B2274.loopexit ]
  %within.3.1.lcssa = phi i1 [ false, %B1502 ], [ %within.4.2, %B2274.loopexit ]
  %doubted.2.1.lcssa = phi i1 [ true, %B1502 ], [ %154, %B2274.loopexit ]
  br i1 %good.2.1.lcssa, label %B2278, label %B2394

B2278:                                            ; preds = %B2274
  %.3618 = load i64, ptr %arg.code.4, align 8
  %.3668 = inttoptr i64 %.3618 to ptr
  tail call void %.3668(ptr %.490, ptr %.3642, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.3667)
  br label %B2394

B2394:                                            ; preds = %B2278, %B2274
  br i1 %doubted.2.1.lcssa, label %B2470, label %B2402

B2402:                                            ; preds = %B2394
  %.3706 = load i64, ptr %.3705, align 8
  %.3751 = inttoptr i64 %.3706 to ptr
  tail call void %.3751(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B2470

B2470:                                            ; preds = %B2394, %B2402
  %brmerge7075.not = and i1 %.3762, %good.2.1.lcssa
  br i1 %brmerge7075.not, label %B2490, label %B2612

B2490:                                            ; preds = %B2470
  %.3802 = load i64, ptr %.3801, align 8
  %.3849 = inttoptr i64 %.3802 to ptr
  tail call void %.3849(ptr %.490, ptr %.3823, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.274.i, label %B2612, label %B38.if.i

B104.i1024:                                       ; preds = %B38.if.i
  %.349.i1070 = getelementptr double, ptr %279, i64 %.78.i854.07448
  %.350.i1071 = load double, ptr %.349.i1070, align 8, !noalias !62
  %.351.i1072 = fcmp ogt double %.350.i1071, 5.000000e-01
  br i1 %.351.i1072, label %B34.i.i, label %B304.i

B34.i.i:                                          ; preds = %B104.i1024, %B36.i.i
  %.48.i.i817.0 = phi i64 [ %.119.i.i, %B36.i.i ], [ 0, %B104.i1024 ]
  %exitcond7539.not = icmp eq i64 %.48.i.i817.0, %arg.decided
  br i1 %exitcond7539.not, label %B142.endif.i, label %B36.i.i

B36.i.i:                                          ; preds = %B34.i.i
  %.119.i.i = add i64 %.48.i.i817.0, 1
  %.149.i.i1326 = add nsw i64 %.48.i.i817.0, %arg.decided
  %.151.i.i1328 = mul nsw i64 %.149.i.i1326, %arg.shape.0
  %.153.i.i = add nsw i64 %.151.i.i1328, %.78.i854.07448
  %.167.i.i = icmp slt i64 %.153.i.i, 0
  %.168.i.i1332 = select i1 %.167.i.i, i64 %arg.arrays.4.5.0, i64 0
  %156 = getelementptr double, ptr %arg.arrays.4.4, i64 %.153.i.i
  %.182.i.i = getelementptr double, ptr %156, i64 %.168.i.i1332
  %.183.i.i = load double, ptr %.182.i.i, align 8, !noalias !66
  %.184.i.i = fcmp ogt double %.183.i.i, 5.000000e-01
  br i1 %.184.i.i, label %B142.endif.i, label %B34.i.i

B190.i1134:                                       ; preds = %B142.endif.i
  store double 1.000000e+00, ptr %.234.i970, align 8, !noalias !62
  %.503.i1228 = getelementptr double, ptr %280, i64 %.78.i854.07448
  store double 0.000000e+00, ptr %.503.i1228, align 8, !noalias !62
  %.558.i1273 = getelementptr double, ptr %281, i64 %.78.i854.07448
  store double 1.000000e+00, ptr %.558.i1273, align 8, !noalias !62
  %.616.i1316 = getelementptr i64, ptr %282, i64 %.78.i854.07448
  store i64 %.363.i865.0, ptr %.616.i1316, align 8, !noalias !62
  br label %B304.i

B304.i:                                           ; preds = %B142.endif.i, %B190.i1134, %B104.i1024, %B38.if.i
  %some.3.i.1 = phi i1 [ true, %B190.i1134 ], [ %some.2.i.07450, %B142.endif.i ], [ %some.2.i.07450, %B104.i1024 ], [ %some.2.i.07450, %B38.if.i ]
  %.136.i906 = icmp sgt i64 %.81.i855.07449, 1
  br i1 %.136.i906, label %B38.if.i, label %B2612

B38.if.i:                                         ; preds = %B2490, %B304.i
  %some.2.i.07450 = phi i1 [ %some.3.i.1, %B304.i ], [ false, %B2490 ]
  %.81.i855.07449 = phi i64 [ %.145.i1347, %B304.i ], [ %storemerge, %B2490 ]
  %.78.i854.07448 = phi i64 [ %.149.i1350, %B304.i ], [ 0, %B2490 ]
  %.145.i1347 = add nsw i64 %.81.i855.07449, -1
  %.149.i1350 = add nsw i64 %.78.i854.07448, 1
  %.234.i970 = getelementptr double, ptr %278, i64 %.78.i854.07448
  store double 0.000000e+00, ptr %.234.i970, align 8, !noalias !62
  %.289.i1016 = getelementptr i64, ptr %arg.lane.1.4, i64 %.78.i854.07448
  %.290.i1017 = load i64, ptr %.289.i1016, align 8, !noalias !62
  %.291.i1018 = icmp sgt i64 %.290.i1017, -1
  br i1 %.291.i1018, label %B104.i1024, label %B304.i

B142.endif.i:                                     ; preds = %B36.i.i, %B34.i.i
  %.363.i865.0 = phi i64 [ %.48.i.i817.0, %B36.i.i ], [ -1, %B34.i.i ]
  %.393.i1133 = icmp sgt i64 %.363.i865.0, -1
  br i1 %.393.i1133, label %B190.i1134, label %B304.i

B2612:                                            ; preds = %B304.i, %B2490, %B2470
  %beyond.2.1 = phi i1 [ false, %B2470 ], [ false, %B2490 ], [ %some.3.i.1, %B304.i ]
  %brmerge7076 = select i1 %within.3.1.lcssa, i1 true, i1 %beyond.2.1
  br i1 %brmerge7076, label %B2620, label %B3112

B2620:                                            ; preds = %B2612
  br i1 %.539, label %B2958, label %B2688.if

B2958:                                            ; preds = %B2688.if, %B2620
  %.4302 = load i64, ptr %.4301, align 8
  %.4347 = inttoptr i64 %.4302 to ptr
  tail call void %.4347(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %beyond.2.1, label %B104.if.i, label %B3070

B102.loopexit.i.critedge:                         ; preds = %B104.if.i
  %.1014.i.c = load i64, ptr %.1013.i, align 8, !noalias !70
  %.1131.i.c = inttoptr i64 %.1014.i.c to ptr
  tail call void %.1131.i.c(ptr %.490, ptr %.1105.i7119, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !70
  br label %B102.loopexit.i

B102.loopexit.i:                                  ; preds = %B1498.i, %B102.loopexit.i.critedge
  %.281.i = icmp ugt i64 %.225.01193.i, 1
  br i1 %.281.i, label %B104.if.i, label %B842.i

B138.loopexit.i:                                  ; preds = %B380.if.i, %middle.block7639, %B138.if.i
  %exitcond1198.not.i = icmp eq i64 %arg.shape.0, %.412.i
  br i1 %exitcond1198.not.i, label %B474.i, label %B138.if.i

B474.i:                                           ; preds = %B138.loopexit.i
  %.1014.i = load i64, ptr %.1013.i, align 8, !noalias !70
  %.1131.i = inttoptr i64 %.1014.i to ptr
  tail call void %.1131.i(ptr %.490, ptr %.1105.i7119, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !70
  br label %B622.if.i

B674.i:                                           ; preds = %B622.if.i
  %.1364.i = getelementptr double, ptr %283, i64 %.1157.01191.i
  %.1365.i = load double, ptr %.1364.i, align 8, !noalias !70
  %.1419.i = getelementptr double, ptr %284, i64 %.1157.01191.i
  %.1420.i = load double, ptr %.1419.i, align 8, !noalias !70
  %.1421.i = fadd double %.1365.i, %.1420.i
  %.1422.i = fmul double %.1421.i, 5.000000e-01
  br label %B34.i.i7125

B34.i.i7125:                                      ; preds = %B34.if.i.i7126, %B674.i
  %.48.i.0.i = phi i64 [ 0, %B674.i ], [ %.119.i73.i, %B34.if.i.i7126 ]
  %exitcond1199.not.i = icmp eq i64 %.48.i.0.i, %storemerge1173.i
  br i1 %exitcond1199.not.i, label %B812.i, label %B34.if.i.i7126

B80.i.i7128:                                      ; preds = %B34.if.i.i7126
  %157 = icmp sgt i64 %.48.i.0.i, -1
  br i1 %157, label %B786.i, label %B812.i

B34.if.i.i7126:                                   ; preds = %B34.i.i7125
  %.119.i73.i = add i64 %.48.i.0.i, 1
  %.149.i42.i = add nsw i64 %.48.i.0.i, %arg.decided
  %.151.i.i = mul nsw i64 %.149.i42.i, %arg.shape.0
  %.153.i44.i = add nsw i64 %.151.i.i, %.1157.01191.i
  %.167.i51.i = icmp slt i64 %.153.i44.i, 0
  %.168.i.i = select i1 %.167.i51.i, i64 %arg.arrays.4.5.0, i64 0
  %158 = getelementptr double, ptr %arg.arrays.4.4, i64 %.153.i44.i
  %.182.i.i7127 = getelementptr double, ptr %158, i64 %.168.i.i
  %.183.i63.i = load double, ptr %.182.i.i7127, align 8, !noalias !73
  %.184.i64.i = fcmp ogt double %.183.i63.i, 5.000000e-01
  br i1 %.184.i64.i, label %B80.i.i7128, label %B34.i.i7125

B786.i:                                           ; preds = %B80.i.i7128
  store double %.1422.i, ptr %.1419.i, align 8, !noalias !70
  br label %B1498.i

B812.i:                                           ; preds = %B34.i.i7125, %B80.i.i7128
  store double %.1422.i, ptr %.1364.i, align 8, !noalias !70
  br label %B1498.i

B842.i:                                           ; preds = %B102.loopexit.i
  br i1 %.274.i, label %B3070, label %B874.if.i

B978.i:                                           ; preds = %B874.if.i
  %.2010.i = load double, ptr %.1786.i, align 8, !noalias !70
  %.2011.i = tail call double @llvm.fabs.f64(double %.2010.i)
  %.2012.i = fmul double %.2011.i, 2.000000e-12
  %.2069.i = getelementptr double, ptr %283, i64 %.1635.01195.i
  %.2070.i = load double, ptr %.2069.i, align 8, !noalias !70
  %.2125.i = getelementptr double, ptr %286, i64 %.1635.01195.i
  %.2126.i = load double, ptr %.2125.i, align 8, !noalias !70
  %.2183.i = fmul double %.2126.i, 0x3D719799812DEA11
  %.10.i.i = fcmp ogt double %.2012.i, %.2183.i
  %.11.i.i7124 = select i1 %.10.i.i, double %.2012.i, double %.2183.i
  %.2071.i = fsub double 1.000000e+00, %.2070.i
  %.2127.i = fmul double %.2071.i, %.2126.i
  %.2212.i = fcmp ugt double %.2127.i, %.11.i.i7124
  br i1 %.2212.i, label %B1268.i, label %B1232.i

B1232.i:                                          ; preds = %B978.i
  store double 2.000000e+00, ptr %.1896.i, align 8, !noalias !70
  br label %B1497.i

B1268.i:                                          ; preds = %B978.i
  %159 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1635.01195.i
  %.1954.i = load i64, ptr %159, align 8, !noalias !70
  %.2331.i = getelementptr double, ptr %288, i64 %.1635.01195.i
  store double 0.000000e+00, ptr %.2331.i, align 8, !noalias !70
  %.2386.i = getelementptr double, ptr %289, i64 %.1635.01195.i
  store double 0.000000e+00, ptr %.2386.i, align 8, !noalias !70
  %.2441.i = getelementptr double, ptr %284, i64 %.1635.01195.i
  %.2442.i = load double, ptr %.2441.i, align 8, !noalias !70
  %.2497.i = load double, ptr %.2125.i, align 8, !noalias !70
  %.2498.i = fmul double %.2442.i, %.2497.i
  %.2554.i = getelementptr double, ptr %290, i64 %.1635.01195.i
  store double %.2498.i, ptr %.2554.i, align 8, !noalias !70
  %.2583.i = icmp slt i64 %.1954.i, 0
  %.2584.i = select i1 %.2583.i, i64 %arg.results.3.5.0, i64 0
  %.2585.i = add i64 %.2584.i, %.1954.i
  %.2605.i = mul i64 %.2585.i, %arg.results.3.5.1
  %.2609.i = getelementptr i64, ptr %arg.results.3.4, i64 %.2605.i
  %.2610.i = load i64, ptr %.2609.i, align 8, !noalias !70
  %.2611.i = add nsw i64 %.2610.i, -1
  store i64 %.2611.i, ptr %.2609.i, align 8, !noalias !70
  %.2719.i = getelementptr i8, ptr %.2609.i, i64 24
  %.2720.i = load i64, ptr %.2719.i, align 8, !noalias !70
  %.2721.i = add nsw i64 %.2720.i, 1
  store i64 %.2721.i, ptr %.2719.i, align 8, !noalias !70
  br label %B1497.i

B1497.i:                                          ; preds = %B874.if.i, %B1268.i, %B1232.i
  %exitcond1201.not.i = icmp eq i64 %.1705.i, %arg.shape.0
  br i1 %exitcond1201.not.i, label %B3070, label %B874.if.i

B1498.i:                                          ; preds = %B622.if.i, %B812.i, %B786.i
  %exitcond1200.not.i = icmp eq i64 %arg.shape.0, %.1226.i
  br i1 %exitcond1200.not.i, label %B102.loopexit.i, label %B622.if.i

B104.if.i:                                        ; preds = %B2958, %B102.loopexit.i
  %.225.01193.i = phi i64 [ %.290.i, %B102.loopexit.i ], [ 50, %B2958 ]
  %.290.i = add nsw i64 %.225.01193.i, -1
  br i1 %.274.i, label %B102.loopexit.i.critedge, label %B138.if.i

B138.if.i:                                        ; preds = %B104.if.i, %B138.loopexit.i
  %.343.01188.i = phi i64 [ %.412.i, %B138.loopexit.i ], [ 0, %B104.if.i ]
  %.412.i = add nsw i64 %.343.01188.i, 1
  %.493.i = getelementptr double, ptr %283, i64 %.343.01188.i
  %.494.i = load double, ptr %.493.i, align 8, !noalias !70
  %.548.i7120 = getelementptr double, ptr %284, i64 %.343.01188.i
  %.549.i = load double, ptr %.548.i7120, align 8, !noalias !70
  %.550.i = fadd double %.494.i, %.549.i
  %.551.i = fmul double %.550.i, 5.000000e-01
  %.608.i = getelementptr double, ptr %285, i64 %.343.01188.i
  %.609.i = load double, ptr %.608.i, align 8, !noalias !70
  %.610.i = fcmp une double %.609.i, 1.000000e+00
  %share.3.2.i = select i1 %.610.i, double 1.000000e+00, double %.551.i
  %.668.i = getelementptr double, ptr %arg.lane.0.4, i64 %.343.01188.i
  %.669.i = load double, ptr %.668.i, align 8, !noalias !70
  %.723.i = getelementptr double, ptr %286, i64 %.343.01188.i
  %.724.i = load double, ptr %.723.i, align 8, !noalias !70
  %.726.i = fmul double %share.3.2.i, %.724.i
  %.727.i = fadd double %.669.i, %.726.i
  %.781.i = getelementptr double, ptr %.490, i64 %.343.01188.i
  store double %.727.i, ptr %.781.i, align 8, !noalias !70
  br i1 %.8631184.not.i, label %B138.loopexit.i, label %B380.if.lr.ph.i

B380.if.lr.ph.i:                                  ; preds = %B138.if.i
  %.247.i.i = fsub double 1.000000e+00, %share.3.2.i
  %invariant.gep7454 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep7456 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep7458 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep7460 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep7462 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep7464 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep7466 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep7468 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep7470 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %or.cond7701.not = xor i1 %or.cond7701, true
  %brmerge7760 = select i1 %or.cond7701.not, i1 true, i1 %conflict.rdx7618
  br i1 %brmerge7760, label %B380.if.i.preheader, label %vector.ph7621

vector.ph7621:                                    ; preds = %B380.if.lr.ph.i
  %broadcast.splatinsert7624 = insertelement <2 x double> poison, double %.247.i.i, i64 0
  %broadcast.splat7625 = shufflevector <2 x double> %broadcast.splatinsert7624, <2 x double> poison, <2 x i32> zeroinitializer
  %broadcast.splatinsert7626 = insertelement <2 x double> poison, double %share.3.2.i, i64 0
  %broadcast.splat7627 = shufflevector <2 x double> %broadcast.splatinsert7626, <2 x double> poison, <2 x i32> zeroinitializer
  %invariant.gep7720 = getelementptr double, ptr %invariant.gep7454, i64 %.155.i.i
  %invariant.gep7722 = getelementptr double, ptr %invariant.gep7456, i64 %.155.i.1.i
  %invariant.gep7724 = getelementptr double, ptr %invariant.gep7458, i64 %.155.i.2.i
  %invariant.gep7726 = getelementptr double, ptr %invariant.gep7460, i64 %.155.i.3.i
  %invariant.gep7728 = getelementptr double, ptr %invariant.gep7462, i64 %.155.i.4.i
  %invariant.gep7730 = getelementptr double, ptr %invariant.gep7464, i64 %.155.i.5.i
  %invariant.gep7732 = getelementptr double, ptr %invariant.gep7466, i64 %.155.i.6.i
  %invariant.gep7734 = getelementptr double, ptr %invariant.gep7470, i64 %.935.i
  br label %vector.body7628

vector.body7628:                                  ; preds = %vector.body7628, %vector.ph7621
  %index7629 = phi i64 [ 0, %vector.ph7621 ], [ %index.next7638, %vector.body7628 ]
  %gep7721 = getelementptr double, ptr %invariant.gep7720, i64 %index7629
  %wide.load7630 = load <2 x double>, ptr %gep7721, align 8, !noalias !77
  %160 = fadd <2 x double> %wide.load7630, zeroinitializer
  %161 = fmul <2 x double> %broadcast.splat7627, %160
  %gep7723 = getelementptr double, ptr %invariant.gep7722, i64 %index7629
  %wide.load7631 = load <2 x double>, ptr %gep7723, align 8, !noalias !77
  %162 = fadd <2 x double> %wide.load7631, %161
  %163 = fmul <2 x double> %broadcast.splat7625, %162
  %gep7725 = getelementptr double, ptr %invariant.gep7724, i64 %index7629
  %wide.load7632 = load <2 x double>, ptr %gep7725, align 8, !noalias !77
  %164 = fadd <2 x double> %wide.load7632, %163
  %165 = fmul <2 x double> %broadcast.splat7627, %164
  %gep7727 = getelementptr double, ptr %invariant.gep7726, i64 %index7629
  %wide.load7633 = load <2 x double>, ptr %gep7727, align 8, !noalias !77
  %166 = fadd <2 x double> %wide.load7633, %165
  %167 = fmul <2 x double> %broadcast.splat7625, %166
  %gep7729 = getelementptr double, ptr %invariant.gep7728, i64 %index7629
  %wide.load7634 = load <2 x double>, ptr %gep7729, align 8, !noalias !77
  %168 = fadd <2 x double> %wide.load7634, %167
  %169 = fmul <2 x double> %broadcast.splat7627, %168
  %gep7731 = getelementptr double, ptr %invariant.gep7730, i64 %index7629
  %wide.load7635 = load <2 x double>, ptr %gep7731, align 8, !noalias !77
  %170 = fadd <2 x double> %wide.load7635, %169
  %171 = fmul <2 x double> %broadcast.splat7625, %170
  %gep7733 = getelementptr double, ptr %invariant.gep7732, i64 %index7629
  %wide.load7636 = load <2 x double>, ptr %gep7733, align 8, !noalias !77
  %172 = fadd <2 x double> %wide.load7636, %171
  %173 = fmul <2 x double> %broadcast.splat7627, %172
  %174 = getelementptr double, ptr %invariant.gep7468, i64 %index7629
  %wide.load7637 = load <2 x double>, ptr %174, align 8, !noalias !77
  %175 = fadd <2 x double> %wide.load7637, %173
  %gep7735 = getelementptr double, ptr %invariant.gep7734, i64 %index7629
  store <2 x double> %175, ptr %gep7735, align 8, !noalias !70
  %index.next7638 = add i64 %index7629, 2
  %176 = icmp eq i64 %index.next7638, %n.vec7623
  br i1 %176, label %middle.block7639, label %vector.body7628, !llvm.loop !81

middle.block7639:                                 ; preds = %vector.body7628
  br i1 %cmp.n7640, label %B138.loopexit.i, label %B380.if.i.preheader

B380.if.i.preheader:                              ; preds = %B380.if.lr.ph.i, %middle.block7639
  %.807.01185.i.ph = phi i64 [ %n.vec7623, %middle.block7639 ], [ 0, %B380.if.lr.ph.i ]
  br label %B380.if.i

B380.if.i:                                        ; preds = %B380.if.i.preheader, %B380.if.i
  %.807.01185.i = phi i64 [ %.876.i, %B380.if.i ], [ %.807.01185.i.ph, %B380.if.i.preheader ]
  %.157.i.i = add nsw i64 %.807.01185.i, %.155.i.i
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep7455 = getelementptr double, ptr %invariant.gep7454, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep7455, align 8, !noalias !77
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i = fmul double %share.3.2.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.807.01185.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep7457 = getelementptr double, ptr %invariant.gep7456, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep7457, align 8, !noalias !77
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.807.01185.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep7459 = getelementptr double, ptr %invariant.gep7458, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep7459, align 8, !noalias !77
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %share.3.2.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.807.01185.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep7461 = getelementptr double, ptr %invariant.gep7460, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep7461, align 8, !noalias !77
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.807.01185.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep7463 = getelementptr double, ptr %invariant.gep7462, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep7463, align 8, !noalias !77
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %share.3.2.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.807.01185.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep7465 = getelementptr double, ptr %invariant.gep7464, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep7465, align 8, !noalias !77
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.807.01185.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep7467 = getelementptr double, ptr %invariant.gep7466, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep7467, align 8, !noalias !77
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %share.3.2.i, %.193.i.6.i
  %.876.i = add nsw i64 %.807.01185.i, 1
  %.271.i.i7121 = mul nsw i64 %.807.01185.i, %arg.shape.0
  %gep7469 = getelementptr double, ptr %invariant.gep7468, i64 %.271.i.i7121
  %.309.i.i = load double, ptr %gep7469, align 8, !noalias !77
  %.313.i.i = fadd double %.309.i.i, %.253.i.6.i
  %.936.i = add nsw i64 %.807.01185.i, %.935.i
  %.938.i = mul nsw i64 %.936.i, %arg.shape.0
  %gep7471 = getelementptr double, ptr %invariant.gep7470, i64 %.938.i
  store double %.313.i.i, ptr %gep7471, align 8, !noalias !70
  %exitcond.not.i7122 = icmp eq i64 %arg.shape.1, %.876.i
  br i1 %exitcond.not.i7122, label %B138.loopexit.i, label %B380.if.i, !llvm.loop !82

B622.if.i:                                        ; preds = %B474.i, %B1498.i
  %.1157.01191.i = phi i64 [ %.1226.i, %B1498.i ], [ 0, %B474.i ]
  %.1226.i = add nsw i64 %.1157.01191.i, 1
  %.1307.i = getelementptr double, ptr %285, i64 %.1157.01191.i
  %.1308.i = load double, ptr %.1307.i, align 8, !noalias !70
  %.1309.i = fcmp oeq double %.1308.i, 1.000000e+00
  br i1 %.1309.i, label %B674.i, label %B1498.i

B874.if.i:                                        ; preds = %B842.i, %B1497.i
  %.1635.01195.i = phi i64 [ %.1705.i, %B1497.i ], [ 0, %B842.i ]
  %.1705.i = add nsw i64 %.1635.01195.i, 1
  %.1786.i = getelementptr double, ptr %287, i64 %.1635.01195.i
  %.1787.i = load double, ptr %.1786.i, align 8, !noalias !70
  %.1841.i = getelementptr double, ptr %.490, i64 %.1635.01195.i
  store double %.1787.i, ptr %.1841.i, align 8, !noalias !70
  %.1896.i = getelementptr double, ptr %285, i64 %.1635.01195.i
  %.1897.i = load double, ptr %.1896.i, align 8, !noalias !70
  %.1898.i = fcmp oeq double %.1897.i, 1.000000e+00
  br i1 %.1898.i, label %B978.i, label %B1497.i

B3070:                                            ; preds = %B1497.i, %B842.i, %B2958
  br i1 %.4428.not, label %B3112, label %B112.if.i

B110.loopexit.i.critedge:                         ; preds = %B112.if.i
  %.846.i.c = load i64, ptr %.845.i, align 8, !noalias !83
  %.963.i.c = inttoptr i64 %.846.i.c to ptr
  tail call void %.963.i.c(ptr %.490, ptr %.937.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !83
  br label %B110.loopexit.i

B110.loopexit.i:                                  ; preds = %B678.i, %B110.loopexit.i.critedge
  %exitcond671.not.i = icmp eq i64 %.292.i, 17
  br i1 %exitcond671.not.i, label %B3112, label %B112.if.i

B166.loopexit.i:                                  ; preds = %B288.if.i, %middle.block7598, %B166.if.i
  %exitcond669.not.i = icmp eq i64 %arg.shape.0, %.419.i
  br i1 %exitcond669.not.i, label %B382.i, label %B166.if.i

B382.i:                                           ; preds = %B166.loopexit.i
  %.846.i = load i64, ptr %.845.i, align 8, !noalias !83
  %.963.i = inttoptr i64 %.846.i to ptr
  tail call void %.963.i(ptr %.490, ptr %.937.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !83
  br label %B530.if.i

B572.i:                                           ; preds = %B530.if.i
  %177 = getelementptr double, ptr %arg.arrays.4.4, i64 %.989.0665.i
  %.1173.i = load double, ptr %177, align 8, !noalias !83
  %.1175.i = fcmp olt double %.1173.i, -1.000000e-09
  br i1 %.1175.i, label %B608.i, label %B678.i

B608.i:                                           ; preds = %B572.i
  %178 = getelementptr i64, ptr %arg.lane.1.4, i64 %.989.0665.i
  %.84.i35.i = load i64, ptr %178, align 8, !noalias !86
  %.89.i37.i = icmp sgt i64 %.84.i35.i, -1
  br i1 %.89.i37.i, label %B46.i.i7182, label %B608.endif.i

B46.i.i7182:                                      ; preds = %B608.i
  %.120.i51.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i35.i
  %.121.i.i7183 = load i64, ptr %.120.i51.i, align 8, !noalias !86
  %.122.i.i7184 = icmp eq i64 %.121.i.i7183, 0
  br i1 %.122.i.i7184, label %B80.i.i7185, label %B608.endif.i

B80.i.i7185:                                      ; preds = %B46.i.i7182
  store i64 4, ptr %.120.i51.i, align 8, !noalias !86
  br label %B608.endif.i

B678.i:                                           ; preds = %B608.endif.i, %B530.if.i, %B572.i
  %exitcond670.not.i = icmp eq i64 %arg.shape.0, %.1058.i7179
  br i1 %exitcond670.not.i, label %B110.loopexit.i, label %B530.if.i

B112.if.i:                                        ; preds = %B3070, %B110.loopexit.i
  %.220.0667.i = phi i64 [ %.292.i, %B110.loopexit.i ], [ 1, %B3070 ]
  %.292.i = add nsw i64 %.220.0667.i, 1
  %179 = uitofp i64 %.220.0667.i to double
  %180 = fmul double %179, 6.250000e-02
  br i1 %.274.i, label %B110.loopexit.i.critedge, label %B166.if.lr.ph.i

B166.if.lr.ph.i:                                  ; preds = %B112.if.i
  %.247.i.i7131 = fsub double 1.000000e+00, %180
  %broadcast.splatinsert = insertelement <2 x double> poison, double %180, i64 0
  %broadcast.splat = shufflevector <2 x double> %broadcast.splatinsert, <2 x double> poison, <2 x i32> zeroinitializer
  %broadcast.splatinsert7585 = insertelement <2 x double> poison, double %.247.i.i7131, i64 0
  %broadcast.splat7586 = shufflevector <2 x double> %broadcast.splatinsert7585, <2 x double> poison, <2 x i32> zeroinitializer
  br label %B166.if.i

B166.if.i:                                        ; preds = %B166.if.lr.ph.i, %B166.loopexit.i
  %.350.0662.i = phi i64 [ 0, %B166.if.lr.ph.i ], [ %.419.i, %B166.loopexit.i ]
  %.419.i = add nsw i64 %.350.0662.i, 1
  %.500.i = getelementptr double, ptr %arg.lane.0.4, i64 %.350.0662.i
  %.501.i = load double, ptr %.500.i, align 8, !noalias !83
  %.555.i = getelementptr double, ptr %291, i64 %.350.0662.i
  %.556.i = load double, ptr %.555.i, align 8, !noalias !83
  %.558.i = fmul double %180, %.556.i
  %.559.i = fadd double %.501.i, %.558.i
  %.613.i7132 = getelementptr double, ptr %.490, i64 %.350.0662.i
  store double %.559.i, ptr %.613.i7132, align 8, !noalias !83
  br i1 %.695658.not.i, label %B166.loopexit.i, label %B288.if.preheader.i

B288.if.preheader.i:                              ; preds = %B166.if.i
  %invariant.gep7472 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep7474 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep7476 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep7478 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep7480 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep7482 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep7484 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep7486 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep7488 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %or.cond7702.not = xor i1 %or.cond7702, true
  %brmerge7761 = select i1 %or.cond7702.not, i1 true, i1 %conflict.rdx7579
  br i1 %brmerge7761, label %B288.if.i.preheader, label %vector.ph7582

vector.ph7582:                                    ; preds = %B288.if.preheader.i
  %invariant.gep7736 = getelementptr double, ptr %invariant.gep7472, i64 %.155.i.i7133
  %invariant.gep7738 = getelementptr double, ptr %invariant.gep7474, i64 %.155.i.1.i7139
  %invariant.gep7740 = getelementptr double, ptr %invariant.gep7476, i64 %.155.i.2.i7145
  %invariant.gep7742 = getelementptr double, ptr %invariant.gep7478, i64 %.155.i.3.i7151
  %invariant.gep7744 = getelementptr double, ptr %invariant.gep7480, i64 %.155.i.4.i7157
  %invariant.gep7746 = getelementptr double, ptr %invariant.gep7482, i64 %.155.i.5.i7163
  %invariant.gep7748 = getelementptr double, ptr %invariant.gep7484, i64 %.155.i.6.i7169
  %invariant.gep7750 = getelementptr double, ptr %invariant.gep7488, i64 %.767.i
  br label %vector.body7587

vector.body7587:                                  ; preds = %vector.body7587, %vector.ph7582
  %index7588 = phi i64 [ 0, %vector.ph7582 ], [ %index.next7597, %vector.body7587 ]
  %gep7737 = getelementptr double, ptr %invariant.gep7736, i64 %index7588
  %wide.load7589 = load <2 x double>, ptr %gep7737, align 8, !noalias !89
  %181 = fadd <2 x double> %wide.load7589, zeroinitializer
  %182 = fmul <2 x double> %broadcast.splat, %181
  %gep7739 = getelementptr double, ptr %invariant.gep7738, i64 %index7588
  %wide.load7590 = load <2 x double>, ptr %gep7739, align 8, !noalias !89
  %183 = fadd <2 x double> %wide.load7590, %182
  %184 = fmul <2 x double> %broadcast.splat7586, %183
  %gep7741 = getelementptr double, ptr %invariant.gep7740, i64 %index7588
  %wide.load7591 = load <2 x double>, ptr %gep7741, align 8, !noalias !89
  %185 = fadd <2 x double> %wide.load7591, %184
  %186 = fmul <2 x double> %broadcast.splat, %185
  %gep7743 = getelementptr double, ptr %invariant.gep7742, i64 %index7588
  %wide.load7592 = load <2 x double>, ptr %gep7743, align 8, !noalias !89
  %187 = fadd <2 x double> %wide.load7592, %186
  %188 = fmul <2 x double> %broadcast.splat7586, %187
  %gep7745 = getelementptr double, ptr %invariant.gep7744, i64 %index7588
  %wide.load7593 = load <2 x double>, ptr %gep7745, align 8, !noalias !89
  %189 = fadd <2 x double> %wide.load7593, %188
  %190 = fmul <2 x double> %broadcast.splat, %189
  %gep7747 = getelementptr double, ptr %invariant.gep7746, i64 %index7588
  %wide.load7594 = load <2 x double>, ptr %gep7747, align 8, !noalias !89
  %191 = fadd <2 x double> %wide.load7594, %190
  %192 = fmul <2 x double> %broadcast.splat7586, %191
  %gep7749 = getelementptr double, ptr %invariant.gep7748, i64 %index7588
  %wide.load7595 = load <2 x double>, ptr %gep7749, align 8, !noalias !89
  %193 = fadd <2 x double> %wide.load7595, %192
  %194 = fmul <2 x double> %broadcast.splat, %193
  %195 = getelementptr double, ptr %invariant.gep7486, i64 %index7588
  %wide.load7596 = load <2 x double>, ptr %195, align 8, !noalias !89
  %196 = fadd <2 x double> %wide.load7596, %194
  %gep7751 = getelementptr double, ptr %invariant.gep7750, i64 %index7588
  store <2 x double> %196, ptr %gep7751, align 8, !noalias !83
  %index.next7597 = add i64 %index7588, 2
  %197 = icmp eq i64 %index.next7597, %n.vec7584
  br i1 %197, label %middle.block7598, label %vector.body7587, !llvm.loop !93

middle.block7598:                                 ; preds = %vector.body7587
  br i1 %cmp.n7599, label %B166.loopexit.i, label %B288.if.i.preheader

B288.if.i.preheader:                              ; preds = %B288.if.preheader.i, %middle.block7598
  %.639.0659.i.ph = phi i64 [ %n.vec7584, %middle.block7598 ], [ 0, %B288.if.preheader.i ]
  br label %B288.if.i

B288.if.i:                                        ; preds = %B288.if.i.preheader, %B288.if.i
  %.639.0659.i = phi i64 [ %.708.i, %B288.if.i ], [ %.639.0659.i.ph, %B288.if.i.preheader ]
  %.157.i.i7134 = add nsw i64 %.639.0659.i, %.155.i.i7133
  %.159.i.i7135 = mul nsw i64 %.157.i.i7134, %arg.shape.0
  %gep7473 = getelementptr double, ptr %invariant.gep7472, i64 %.159.i.i7135
  %.191.i.i7136 = load double, ptr %gep7473, align 8, !noalias !89
  %.193.i.i7137 = fadd double %.191.i.i7136, 0.000000e+00
  %.253.i.i7138 = fmul double %180, %.193.i.i7137
  %.157.i.1.i7140 = add nsw i64 %.639.0659.i, %.155.i.1.i7139
  %.159.i.1.i7141 = mul nsw i64 %.157.i.1.i7140, %arg.shape.0
  %gep7475 = getelementptr double, ptr %invariant.gep7474, i64 %.159.i.1.i7141
  %.191.i.1.i7142 = load double, ptr %gep7475, align 8, !noalias !89
  %.193.i.1.i7143 = fadd double %.191.i.1.i7142, %.253.i.i7138
  %.253.i.1.i7144 = fmul double %.247.i.i7131, %.193.i.1.i7143
  %.157.i.2.i7146 = add nsw i64 %.639.0659.i, %.155.i.2.i7145
  %.159.i.2.i7147 = mul nsw i64 %.157.i.2.i7146, %arg.shape.0
  %gep7477 = getelementptr double, ptr %invariant.gep7476, i64 %.159.i.2.i7147
  %.191.i.2.i7148 = load double, ptr %gep7477, align 8, !noalias !89
  %.193.i.2.i7149 = fadd double %.191.i.2.i7148, %.253.i.1.i7144
  %.253.i.2.i7150 = fmul double %180, %.193.i.2.i7149
  %.157.i.3.i7152 = add nsw i64 %.639.0659.i, %.155.i.3.i7151
  %.159.i.3.i7153 = mul nsw i64 %.157.i.3.i7152, %arg.shape.0
  %gep7479 = getelementptr double, ptr %invariant.gep7478, i64 %.159.i.3.i7153
  %.191.i.3.i7154 = load double, ptr %gep7479, align 8, !noalias !89
  %.193.i.3.i7155 = fadd double %.191.i.3.i7154, %.253.i.2.i7150
  %.253.i.3.i7156 = fmul double %.247.i.i7131, %.193.i.3.i7155
  %.157.i.4.i7158 = add nsw i64 %.639.0659.i, %.155.i.4.i7157
  %.159.i.4.i7159 = mul nsw i64 %.157.i.4.i7158, %arg.shape.0
  %gep7481 = getelementptr double, ptr %invariant.gep7480, i64 %.159.i.4.i7159
  %.191.i.4.i7160 = load double, ptr %gep7481, align 8, !noalias !89
  %.193.i.4.i7161 = fadd double %.191.i.4.i7160, %.253.i.3.i7156
  %.253.i.4.i7162 = fmul double %180, %.193.i.4.i7161
  %.157.i.5.i7164 = add nsw i64 %.639.0659.i, %.155.i.5.i7163
  %.159.i.5.i7165 = mul nsw i64 %.157.i.5.i7164, %arg.shape.0
  %gep7483 = getelementptr double, ptr %invariant.gep7482, i64 %.159.i.5.i7165
  %.191.i.5.i7166 = load double, ptr %gep7483, align 8, !noalias !89
  %.193.i.5.i7167 = fadd double %.191.i.5.i7166, %.253.i.4.i7162
  %.253.i.5.i7168 = fmul double %.247.i.i7131, %.193.i.5.i7167
  %.157.i.6.i7170 = add nsw i64 %.639.0659.i, %.155.i.6.i7169
  %.159.i.6.i7171 = mul nsw i64 %.157.i.6.i7170, %arg.shape.0
  %gep7485 = getelementptr double, ptr %invariant.gep7484, i64 %.159.i.6.i7171
  %.191.i.6.i7172 = load double, ptr %gep7485, align 8, !noalias !89
  %.193.i.6.i7173 = fadd double %.191.i.6.i7172, %.253.i.5.i7168
  %.253.i.6.i7174 = fmul double %180, %.193.i.6.i7173
  %.708.i = add nsw i64 %.639.0659.i, 1
  %.271.i.i7175 = mul nsw i64 %.639.0659.i, %arg.shape.0
  %gep7487 = getelementptr double, ptr %invariant.gep7486, i64 %.271.i.i7175
  %.309.i.i7176 = load double, ptr %gep7487, align 8, !noalias !89
  %.313.i.i7177 = fadd double %.309.i.i7176, %.253.i.6.i7174
  %.768.i = add nsw i64 %.639.0659.i, %.767.i
  %.770.i = mul nsw i64 %.768.i, %arg.shape.0
  %gep7489 = getelementptr double, ptr %invariant.gep7488, i64 %.770.i
  store double %.313.i.i7177, ptr %gep7489, align 8, !noalias !83
  %exitcond.not.i7178 = icmp eq i64 %arg.shape.1, %.708.i
  br i1 %exitcond.not.i7178, label %B166.loopexit.i, label %B288.if.i, !llvm.loop !94

B530.if.i:                                        ; preds = %B382.i, %B678.i
  %.989.0665.i = phi i64 [ %.1058.i7179, %B678.i ], [ 0, %B382.i ]
  %.1058.i7179 = add nsw i64 %.989.0665.i, 1
  %198 = getelementptr double, ptr %292, i64 %.989.0665.i
  %.1140.i7180 = load double, ptr %198, align 8, !noalias !83
  %.1141.i7181 = fcmp ogt double %.1140.i7180, 5.000000e-01
  br i1 %.1141.i7181, label %B572.i, label %B678.i

B608.endif.i:                                     ; preds = %B80.i.i7185, %B46.i.i7182, %B608.i
  store double 0.000000e+00, ptr %198, align 8, !noalias !83
  br label %B678.i

B3112:                                            ; preds = %B110.loopexit.i, %B2612, %B3070
  br i1 %wanted.2.1.lcssa, label %B3120, label %B3172

B3120:                                            ; preds = %B3112
  %within.3.1.not = xor i1 %within.3.1.lcssa, true
  %brmerge7078 = select i1 %within.3.1.not, i1 true, i1 %.539
  %"$phi3156.7.2.2" = select i1 %brmerge7078, i64 0, i64 3
  br i1 %.274.i, label %B3172, label %B76.if.i

B152.i:                                           ; preds = %B76.if.i
  %.445.i = getelementptr double, ptr %294, i64 %.173.0633.i
  %.446.i = load double, ptr %.445.i, align 8, !noalias !95
  %.447.i = fcmp olt double %.446.i, 5.000000e-01
  br i1 %.447.i, label %B725.i, label %B190.i7189

B190.i7189:                                       ; preds = %B152.i
  %.478.i = getelementptr i64, ptr %arg.results.1.4, i64 %.327.i7187
  %.479.i7190 = load i64, ptr %.478.i, align 8, !noalias !95
  %.480.not.i = icmp eq i64 %.479.i7190, 0
  br i1 %.480.not.i, label %B226.i, label %B725.i

B226.i:                                           ; preds = %B190.i7189
  %.542.i = mul i64 %.327.i7187, %arg.results.3.5.1
  %199 = getelementptr i64, ptr %arg.results.3.4, i64 %.542.i
  %.546.i = getelementptr i8, ptr %199, i64 8
  %.547.i = load i64, ptr %.546.i, align 8, !noalias !95
  %.549.i7191 = add nsw i64 %.547.i, %"$phi3156.7.2.2"
  store i64 %.549.i7191, ptr %.546.i, align 8, !noalias !95
  %.655.i = getelementptr double, ptr %arg.lane.0.4, i64 %.173.0633.i
  %.656.i = load double, ptr %.655.i, align 8, !noalias !95
  %.710.i = getelementptr double, ptr %295, i64 %.173.0633.i
  %.711.i7192 = load double, ptr %.710.i, align 8, !noalias !95
  %.765.i = getelementptr double, ptr %296, i64 %.173.0633.i
  %.766.i7193 = load double, ptr %.765.i, align 8, !noalias !95
  %.787.i7194 = icmp slt i64 %.382.i, %arg.times.5.0
  br i1 %.787.i7194, label %B400.i, label %B696.i

B400.i:                                           ; preds = %B226.i
  %.810.i = icmp slt i64 %.382.i, 0
  %.811.i = select i1 %.810.i, i64 %arg.times.5.0, i64 0
  %200 = getelementptr double, ptr %arg.times.4, i64 %.382.i
  %.825.i = getelementptr double, ptr %200, i64 %.811.i
  %.826.i = load double, ptr %.825.i, align 8, !noalias !95
  %.830.i7195 = fcmp ugt double %.826.i, %.766.i7193
  br i1 %.830.i7195, label %B696.i, label %B424.preheader.i

B424.preheader.i:                                 ; preds = %B400.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul631.i, %.327.i7187
  %201 = getelementptr double, ptr %arg.results.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep7490 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep7492 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep7494 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep7496 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep7498 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep7500 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep7502 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep7504 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep7506 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  br label %B424.i

B424.i:                                           ; preds = %B672.i, %B424.preheader.i
  %done.2.3.i = phi i64 [ %.1255.i, %B672.i ], [ %.382.i, %B424.preheader.i ]
  br i1 %.917628.not.i, label %B624.i, label %B454.if.lr.ph.i

B454.if.lr.ph.i:                                  ; preds = %B424.i
  %.972.i = icmp slt i64 %done.2.3.i, 0
  %.973.i = select i1 %.972.i, i64 %arg.times.5.0, i64 0
  %202 = getelementptr double, ptr %arg.times.4, i64 %done.2.3.i
  %.987.i = getelementptr double, ptr %202, i64 %.973.i
  %.1213.i = select i1 %.972.i, i64 %arg.results.0.5.1, i64 0
  %.1214.i = add i64 %.1213.i, %done.2.3.i
  %.1243.i = mul i64 %.1214.i, %arg.results.0.5.2
  %203 = getelementptr double, ptr %201, i64 %.1243.i
  br label %B454.if.i

B482.i:                                           ; preds = %B454.if.i
  %.995.i7246 = add nsw i64 %.861.0629.i, %.993.i
  %.997.i = mul nsw i64 %.995.i7246, %arg.shape.0
  %gep7507 = getelementptr double, ptr %invariant.gep7506, i64 %.997.i
  %.1029.i7247 = load double, ptr %gep7507, align 8, !noalias !95
  br label %B726.i

B624.i:                                           ; preds = %B726.i, %B424.i
  %exitcond635.not.i = icmp eq i64 %done.2.3.i, %297
  br i1 %exitcond635.not.i, label %B696.i, label %B672.i

B672.i:                                           ; preds = %B624.i
  %.1255.i = add i64 %done.2.3.i, 1
  %.1297.i7244 = icmp slt i64 %done.2.3.i, -1
  %.1298.i = select i1 %.1297.i7244, i64 %arg.times.5.0, i64 0
  %204 = getelementptr double, ptr %arg.times.4, i64 %.1255.i
  %.1312.i = getelementptr double, ptr %204, i64 %.1298.i
  %.1313.i7245 = load double, ptr %.1312.i, align 8, !noalias !95
  %.1317.i = fcmp ugt double %.1313.i7245, %.766.i7193
  br i1 %.1317.i, label %B696.i, label %B424.i

B696.i:                                           ; preds = %B672.i, %B624.i, %B400.i, %B226.i
  %done.3.2.i = phi i64 [ %.382.i, %B400.i ], [ %.382.i, %B226.i ], [ %arg.times.5.0, %B624.i ], [ %.1255.i, %B672.i ]
  store i64 %done.3.2.i, ptr %.381.i, align 8, !noalias !95
  br label %B725.i

B725.i:                                           ; preds = %B76.if.i, %B696.i, %B190.i7189, %B152.i
  %exitcond636.not.i = icmp eq i64 %.245.i, %arg.shape.0
  br i1 %exitcond636.not.i, label %B3172, label %B76.if.i

B726.i:                                           ; preds = %B38.if.i.i, %B482.i
  %.313.i.i7242.sink = phi double [ %.313.i.i7242, %B38.if.i.i ], [ %.1029.i7247, %B482.i ]
  %205 = getelementptr double, ptr %203, i64 %.861.0629.i
  store double %.313.i.i7242.sink, ptr %205, align 8, !noalias !95
  %exitcond.not.i7243 = icmp eq i64 %arg.shape.1, %.930.i
  br i1 %exitcond.not.i7243, label %B624.i, label %B454.if.i

B76.if.i:                                         ; preds = %B3120, %B725.i
  %.173.0633.i = phi i64 [ %.245.i, %B725.i ], [ 0, %B3120 ]
  %.245.i = add nsw i64 %.173.0633.i, 1
  %.326.i = getelementptr i64, ptr %arg.lane.1.4, i64 %.173.0633.i
  %.327.i7187 = load i64, ptr %.326.i, align 8, !noalias !95
  %.381.i = getelementptr i64, ptr %293, i64 %.173.0633.i
  %.382.i = load i64, ptr %.381.i, align 8, !noalias !95
  %.390.i7188 = icmp slt i64 %.327.i7187, 0
  br i1 %.390.i7188, label %B725.i, label %B152.i

B454.if.i:                                        ; preds = %B726.i, %B454.if.lr.ph.i
  %.861.0629.i = phi i64 [ 0, %B454.if.lr.ph.i ], [ %.930.i, %B726.i ]
  %.930.i = add nsw i64 %.861.0629.i, 1
  %.988.i = load double, ptr %.987.i, align 8, !noalias !95
  %.990.i = fcmp oeq double %.988.i, %.766.i7193
  br i1 %.990.i, label %B482.i, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B454.if.i
  %.1138.i = fsub double %.988.i, %.656.i
  %.1143.i = fdiv double %.1138.i, %.711.i7192
  %.247.i.i7197 = fsub double 1.000000e+00, %.1143.i
  %.157.i.i7199 = add nsw i64 %.861.0629.i, %.155.i.i7198
  %.159.i.i7200 = mul nsw i64 %.157.i.i7199, %arg.shape.0
  %gep7491 = getelementptr double, ptr %invariant.gep7490, i64 %.159.i.i7200
  %.191.i.i7201 = load double, ptr %gep7491, align 8, !noalias !98
  %.193.i.i7202 = fadd double %.191.i.i7201, 0.000000e+00
  %.253.i.i7203 = fmul double %.1143.i, %.193.i.i7202
  %.157.i.1.i7205 = add nsw i64 %.861.0629.i, %.155.i.1.i7204
  %.159.i.1.i7206 = mul nsw i64 %.157.i.1.i7205, %arg.shape.0
  %gep7493 = getelementptr double, ptr %invariant.gep7492, i64 %.159.i.1.i7206
  %.191.i.1.i7207 = load double, ptr %gep7493, align 8, !noalias !98
  %.193.i.1.i7208 = fadd double %.191.i.1.i7207, %.253.i.i7203
  %.253.i.1.i7209 = fmul double %.247.i.i7197, %.193.i.1.i7208
  %.157.i.2.i7211 = add nsw i64 %.861.0629.i, %.155.i.2.i7210
  %.159.i.2.i7212 = mul nsw i64 %.157.i.2.i7211, %arg.shape.0
  %gep7495 = getelementptr double, ptr %invariant.gep7494, i64 %.159.i.2.i7212
  %.191.i.2.i7213 = load double, ptr %gep7495, align 8, !noalias !98
  %.193.i.2.i7214 = fadd double %.191.i.2.i7213, %.253.i.1.i7209
  %.253.i.2.i7215 = fmul double %.1143.i, %.193.i.2.i7214
  %.157.i.3.i7217 = add nsw i64 %.861.0629.i, %.155.i.3.i7216
  %.159.i.3.i7218 = mul nsw i64 %.157.i.3.i7217, %arg.shape.0
  %gep7497 = getelementptr double, ptr %invariant.gep7496, i64 %.159.i.3.i7218
  %.191.i.3.i7219 = load double, ptr %gep7497, align 8, !noalias !98
  %.193.i.3.i7220 = fadd double %.191.i.3.i7219, %.253.i.2.i7215
  %.253.i.3.i7221 = fmul double %.247.i.i7197, %.193.i.3.i7220
  %.157.i.4.i7223 = add nsw i64 %.861.0629.i, %.155.i.4.i7222
  %.159.i.4.i7224 = mul nsw i64 %.157.i.4.i7223, %arg.shape.0
  %gep7499 = getelementptr double, ptr %invariant.gep7498, i64 %.159.i.4.i7224
  %.191.i.4.i7225 = load double, ptr %gep7499, align 8, !noalias !98
  %.193.i.4.i7226 = fadd double %.191.i.4.i7225, %.253.i.3.i7221
  %.253.i.4.i7227 = fmul double %.1143.i, %.193.i.4.i7226
  %.157.i.5.i7229 = add nsw i64 %.861.0629.i, %.155.i.5.i7228
  %.159.i.5.i7230 = mul nsw i64 %.157.i.5.i7229, %arg.shape.0
  %gep7501 = getelementptr double, ptr %invariant.gep7500, i64 %.159.i.5.i7230
  %.191.i.5.i7231 = load double, ptr %gep7501, align 8, !noalias !98
  %.193.i.5.i7232 = fadd double %.191.i.5.i7231, %.253.i.4.i7227
  %.253.i.5.i7233 = fmul double %.247.i.i7197, %.193.i.5.i7232
  %.157.i.6.i7235 = add nsw i64 %.861.0629.i, %.155.i.6.i7234
  %.159.i.6.i7236 = mul nsw i64 %.157.i.6.i7235, %arg.shape.0
  %gep7503 = getelementptr double, ptr %invariant.gep7502, i64 %.159.i.6.i7236
  %.191.i.6.i7237 = load double, ptr %gep7503, align 8, !noalias !98
  %.193.i.6.i7238 = fadd double %.191.i.6.i7237, %.253.i.5.i7233
  %.253.i.6.i7239 = fmul double %.1143.i, %.193.i.6.i7238
  %.271.i.i7240 = mul nsw i64 %.861.0629.i, %arg.shape.0
  %gep7505 = getelementptr double, ptr %invariant.gep7504, i64 %.271.i.i7240
  %.309.i.i7241 = load double, ptr %gep7505, align 8, !noalias !98
  %.313.i.i7242 = fadd double %.309.i.i7241, %.253.i.6.i7239
  br label %B726.i

B3172:                                            ; preds = %B725.i, %B3120, %B3112
  %.4655 = load i64, ptr %.4654, align 8
  %.4700 = inttoptr i64 %.4655 to ptr
  tail call void %.4700(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %beyond.2.1.not = xor i1 %beyond.2.1, true
  %brmerge7531 = or i1 %.274.i, %beyond.2.1.not
  br i1 %brmerge7531, label %B3280, label %B46.if.i

B98.i1553:                                        ; preds = %B46.if.i
  %.306.i1599 = getelementptr double, ptr %299, i64 %.97.i1423.07510
  %.307.i1600 = load double, ptr %.306.i1599, align 8, !noalias !102
  %.308.i1601 = fcmp ogt double %.307.i1600, 5.000000e-01
  br i1 %.308.i1601, label %B136.i, label %B506.i

B136.i:                                           ; preds = %B98.i1553
  %.363.i1649 = getelementptr double, ptr %arg.lane.0.4, i64 %.97.i1423.07510
  %.364.i1650 = load double, ptr %.363.i1649, align 8, !noalias !102
  %.418.i1698 = getelementptr double, ptr %300, i64 %.97.i1423.07510
  %.419.i1699 = load double, ptr %.418.i1698, align 8, !noalias !102
  %.420.i1700 = fsub double %.364.i1650, %.419.i1699
  %.450.i1725 = load double, ptr %.449.i1724, align 8, !noalias !102
  %.480.i1750 = load double, ptr %arg.times.4, align 8, !noalias !102
  %.481.i1751 = fsub double %.450.i1725, %.480.i1750
  %.482.i1752 = fmul double %.481.i1751, 0x3E7AD7F29ABCAF48
  %.483.i1753 = fcmp olt double %.420.i1700, %.482.i1752
  br i1 %.483.i1753, label %B256.i, label %B294.i

B256.i:                                           ; preds = %B136.i
  %206 = getelementptr i64, ptr %302, i64 %.97.i1423.07510
  %.539.i2150 = load i64, ptr %206, align 8, !noalias !102
  %.540.i2151 = add nsw i64 %.539.i2150, 1
  br label %B294.i

B294.i:                                           ; preds = %B136.i, %B256.i
  %"$phi294.1.2.i.2" = phi i64 [ %.540.i2151, %B256.i ], [ 0, %B136.i ]
  %207 = getelementptr i64, ptr %303, i64 %.97.i1423.07510
  store i64 %"$phi294.1.2.i.2", ptr %207, align 8, !noalias !102
  %.660.i1847 = load double, ptr %.363.i1649, align 8, !noalias !102
  store double %.660.i1847, ptr %.418.i1698, align 8, !noalias !102
  %.769.i1915 = getelementptr double, ptr %304, i64 %.97.i1423.07510
  store double 1.000000e+00, ptr %.769.i1915, align 8, !noalias !102
  store i64 1, ptr %.722, align 8, !noalias !102
  %.855.i1967 = load i64, ptr %207, align 8, !noalias !102
  %.856.i1968 = icmp sgt i64 %.855.i1967, 1000
  br i1 %.856.i1968, label %B460.i, label %B506.i

B460.i:                                           ; preds = %B294.i
  %208 = getelementptr i64, ptr %arg.lane.1.4, i64 %.97.i1423.07510
  %.84.i.i2041 = load i64, ptr %208, align 8, !noalias !106
  %.89.i.i2044 = icmp sgt i64 %.84.i.i2041, -1
  br i1 %.89.i.i2044, label %B46.i.i2050, label %B506.i

B46.i.i2050:                                      ; preds = %B460.i
  %.120.i.i2070 = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i.i2041
  %.121.i.i2071 = load i64, ptr %.120.i.i2070, align 8, !noalias !106
  %.122.i.i2072 = icmp eq i64 %.121.i.i2071, 0
  br i1 %.122.i.i2072, label %B80.i.i2077, label %B506.i

B80.i.i2077:                                      ; preds = %B46.i.i2050
  store i64 6, ptr %.120.i.i2070, align 8, !noalias !106
  br label %B506.i

B506.i:                                           ; preds = %B80.i.i2077, %B460.i, %B46.i.i2050, %B294.i, %B98.i1553, %B46.if.i
  %.155.i1489 = icmp sgt i64 %.100.i1424.07509, 1
  br i1 %.155.i1489, label %B46.if.i, label %B3280

B46.if.i:                                         ; preds = %B3172, %B506.i
  %.97.i1423.07510 = phi i64 [ %.168.i2160, %B506.i ], [ 0, %B3172 ]
  %.100.i1424.07509 = phi i64 [ %.164.i2157, %B506.i ], [ %storemerge, %B3172 ]
  %.164.i2157 = add nsw i64 %.100.i1424.07509, -1
  %.168.i2160 = add nsw i64 %.97.i1423.07510, 1
  %.249.i1550 = getelementptr double, ptr %298, i64 %.97.i1423.07510
  %.250.i1551 = load double, ptr %.249.i1550, align 8, !noalias !102
  %.251.i1552 = fcmp oeq double %.250.i1551, 2.000000e+00
  br i1 %.251.i1552, label %B98.i1553, label %B506.i

B3280:                                            ; preds = %B506.i, %B3172
  br i1 %brmerge7530, label %B3330, label %B110.if.i

B46.i.i7248:                                      ; preds = %B110.if.i
  %.135.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !109
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i7255, label %B358.i7249

B80.i.i7255:                                      ; preds = %B46.i.i7248
  %.196.i.i = getelementptr double, ptr %305, i64 %.352.01856.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !109
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B358.i7249, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i7255
  %.264.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.352.01856.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !109
  %.321.i.i = getelementptr double, ptr %306, i64 %.352.01856.i
  %.322.i.i = load double, ptr %.321.i.i, align 8, !noalias !109
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.7511852.not.i
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01858.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01858.i
  br i1 %brmerge.i, label %B358.i7249, label %B300.if.lr.ph.i

B300.if.lr.ph.i:                                  ; preds = %B122.i.i
  %.650.i = getelementptr i64, ptr %307, i64 %.352.01856.i
  %.651.i = load i64, ptr %.650.i, align 8, !noalias !114
  %.652.i = add nsw i64 %.651.i, 1
  %209 = getelementptr i64, ptr %arg.runs.2.4, i64 %.99.i.i
  %.596.i = load i64, ptr %209, align 8, !noalias !114
  %.822.i7257 = icmp slt i64 %.596.i, 0
  %.823.i7258 = select i1 %.822.i7257, i64 %arg.schedule.3.5.0, i64 0
  %.824.i = add i64 %.823.i7258, %.596.i
  %.825.i7259 = icmp slt i64 %.651.i, -1
  %.826.i7260 = select i1 %.825.i7259, i64 %arg.schedule.3.5.1, i64 0
  %.827.i = add i64 %.652.i, %.826.i7260
  %.854.i = mul i64 %.852.i, %.824.i
  %.856.i = mul i64 %.827.i, %arg.schedule.3.5.2
  %210 = getelementptr double, ptr %arg.schedule.3.4, i64 %.854.i
  %211 = getelementptr double, ptr %210, i64 %.856.i
  br label %B300.if.i

B358.i7249:                                       ; preds = %B300.if.i, %B110.if.i, %B122.i.i, %B80.i.i7255, %B46.i.i7248
  %some.3.2.i = phi i1 [ %some.2.01858.i, %B80.i.i7255 ], [ %some.2.01858.mux.i, %B122.i.i ], [ %some.2.01858.i, %B46.i.i7248 ], [ %some.2.01858.i, %B110.if.i ], [ true, %B300.if.i ]
  %exitcond1870.not.i = icmp eq i64 %arg.shape.0, %.423.i
  br i1 %exitcond1870.not.i, label %B360.i, label %B110.if.i

B360.i:                                           ; preds = %B358.i7249
  br i1 %some.3.2.i, label %B368.i, label %B3330

B368.i:                                           ; preds = %B360.i
  %.1018.i = load i64, ptr %.1017.i, align 8, !noalias !114
  %.1130.i = inttoptr i64 %.1018.i to ptr
  tail call void %.1130.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !114
  %.1161.i = load i64, ptr %.1160.i, align 8, !noalias !114
  %.1277.i = inttoptr i64 %.1161.i to ptr
  tail call void %.1277.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1276.i), !noalias !114
  br label %B600.if.i

B46.i82.i:                                        ; preds = %B600.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !115
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B980.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %305, i64 %.1303.01865.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !115
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B980.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1303.01865.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !115
  %.321.i223.i = getelementptr double, ptr %306, i64 %.1303.01865.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !115
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B980.i, label %B640.i

B640.i:                                           ; preds = %B122.i147.i
  %.1557.i = getelementptr i64, ptr %308, i64 %.1303.01865.i
  %.1558.i = load i64, ptr %.1557.i, align 8, !noalias !114
  %.1569.i = icmp sgt i64 %.1558.i, 0
  br i1 %.1569.i, label %B716.i, label %B770.i

B716.i:                                           ; preds = %B640.i
  %212 = getelementptr double, ptr %arg.times.4, i64 %.1558.i
  %.1604.i = getelementptr i8, ptr %212, i64 -8
  %.1605.i = load double, ptr %.1604.i, align 8, !noalias !114
  %.1661.i = fcmp oeq double %.1605.i, %.265.i185.i
  br label %B770.i

B770.i:                                           ; preds = %B716.i, %B640.i
  %"$phi770.1.2.1.i" = phi i1 [ %.1661.i, %B716.i ], [ false, %B640.i ]
  br i1 %.17571859.not.i, label %B980.i, label %B802.if.lr.ph.i

B802.if.lr.ph.i:                                  ; preds = %B770.i
  %.1887.i = add nsw i64 %.1558.i, -1
  %.1926.i = select i1 %.1569.i, i64 0, i64 %arg.results.0.5.1
  %.1927.i = add i64 %.1887.i, %.1926.i
  %.1954.i7254 = mul i64 %.1952.i, %.99.i78.i
  %.1956.i = mul i64 %.1927.i, %arg.results.0.5.2
  %213 = getelementptr double, ptr %arg.results.0.4, i64 %.1954.i7254
  %214 = getelementptr double, ptr %213, i64 %.1956.i
  %invariant.gep7511 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1303.01865.i
  %invariant.gep7513 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1303.01865.i
  br label %B802.if.i

B898.i:                                           ; preds = %B802.if.i
  %215 = getelementptr double, ptr %214, i64 %.1701.01860.i
  store double %.1835.i, ptr %215, align 8, !noalias !114
  br label %B920.i

B920.i:                                           ; preds = %B802.if.i, %B898.i
  %exitcond1871.not.i = icmp eq i64 %arg.shape.1, %.1770.i
  br i1 %exitcond1871.not.i, label %B922.loopexit.i, label %B802.if.i

B922.loopexit.i:                                  ; preds = %B920.i
  %216 = fcmp une double %.1842.i, 0.000000e+00
  br i1 %216, label %B934.i, label %B980.i

B934.i:                                           ; preds = %B922.loopexit.i
  %.84.i516.i = load i64, ptr %222, align 8, !noalias !118
  %.89.i518.i = icmp sgt i64 %.84.i516.i, -1
  br i1 %.89.i518.i, label %B46.i521.i, label %B980.i

B46.i521.i:                                       ; preds = %B934.i
  %.120.i539.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i516.i
  %.121.i540.i = load i64, ptr %.120.i539.i, align 8, !noalias !118
  %.122.i541.i = icmp eq i64 %.121.i540.i, 0
  br i1 %.122.i541.i, label %B80.i545.i, label %B980.i

B80.i545.i:                                       ; preds = %B46.i521.i
  store i64 3, ptr %.120.i539.i, align 8, !noalias !118
  br label %B980.i

B980.i:                                           ; preds = %B600.if.i, %B80.i545.i, %B46.i521.i, %B934.i, %B922.loopexit.i, %B770.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %exitcond1872.not.i = icmp eq i64 %arg.shape.0, %.1372.i
  br i1 %exitcond1872.not.i, label %B982.i, label %B600.if.i

B982.i:                                           ; preds = %B980.i
  br i1 %.2041.not.i, label %B3330, label %B986.i

B986.i:                                           ; preds = %B982.i
  %.2074.i = load i64, ptr %.2073.i, align 8, !noalias !114
  %.2188.i = inttoptr i64 %.2074.i to ptr
  tail call void %.2188.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !114
  br label %B1106.if.i

B46.i315.i:                                       ; preds = %B1106.if.i
  %.135.i335.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i311.i
  %.136.i336.i = load i64, ptr %.135.i335.i, align 8, !noalias !121
  %.141.i339.not.i = icmp eq i64 %.136.i336.i, 0
  br i1 %.141.i339.not.i, label %B80.i340.i, label %B1228.i

B80.i340.i:                                       ; preds = %B46.i315.i
  %.196.i377.i = getelementptr double, ptr %305, i64 %.2224.01868.i
  %.197.i378.i = load double, ptr %.196.i377.i, align 8, !noalias !121
  %.198.i379.i = fcmp olt double %.197.i378.i, 5.000000e-01
  br i1 %.198.i379.i, label %B1228.i, label %B122.i380.i

B122.i380.i:                                      ; preds = %B80.i340.i
  %.264.i417.i = getelementptr double, ptr %arg.lane.0.4, i64 %.2224.01868.i
  %.265.i418.i = load double, ptr %.264.i417.i, align 8, !noalias !121
  %.321.i456.i = getelementptr double, ptr %306, i64 %.2224.01868.i
  %.322.i457.i = load double, ptr %.321.i456.i, align 8, !noalias !121
  %.325.i459.i = fcmp une double %.265.i418.i, %.322.i457.i
  br i1 %.325.i459.i, label %B1228.i, label %B1146.i

B1146.i:                                          ; preds = %B122.i380.i
  %217 = getelementptr double, ptr %arg.arrays.4.4, i64 %.2224.01868.i
  %.2400.i = load double, ptr %217, align 8, !noalias !114
  %.2402.i = fcmp olt double %.2400.i, -1.000000e-09
  br i1 %.2402.i, label %B80.i672.i, label %B1228.i

B80.i672.i:                                       ; preds = %B1146.i
  store i64 4, ptr %.135.i335.i, align 8, !noalias !124
  br label %B1228.i

B1228.i:                                          ; preds = %B1106.if.i, %B80.i672.i, %B1146.i, %B122.i380.i, %B80.i340.i, %B46.i315.i
  %exitcond7541.not = icmp eq i64 %arg.shape.0, %.2293.i
  br i1 %exitcond7541.not, label %B3330, label %B1106.if.i

B110.if.i:                                        ; preds = %B3280, %B358.i7249
  %some.2.01858.i = phi i1 [ %some.3.2.i, %B358.i7249 ], [ false, %B3280 ]
  %.352.01856.i = phi i64 [ %.423.i, %B358.i7249 ], [ 0, %B3280 ]
  %.423.i = add nsw i64 %.352.01856.i, 1
  %218 = getelementptr i64, ptr %arg.lane.1.4, i64 %.352.01856.i
  %.99.i.i = load i64, ptr %218, align 8, !noalias !109
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B358.i7249, label %B46.i.i7248

B300.if.i:                                        ; preds = %B300.if.i, %B300.if.lr.ph.i
  %.692.01853.i = phi i64 [ 0, %B300.if.lr.ph.i ], [ %.764.i, %B300.if.i ]
  %.764.i = add nsw i64 %.692.01853.i, 1
  %219 = getelementptr double, ptr %211, i64 %.692.01853.i
  %.861.i = load double, ptr %219, align 8, !noalias !114
  %220 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.692.01853.i
  %.891.i = load i64, ptr %220, align 8, !noalias !114
  %.893.i = mul nsw i64 %.891.i, %arg.shape.0
  %.895.i = add nsw i64 %.893.i, %.352.01856.i
  %.909.i = icmp slt i64 %.895.i, 0
  %.910.i = select i1 %.909.i, i64 %arg.arrays.1.5.0, i64 0
  %221 = getelementptr double, ptr %arg.arrays.1.4, i64 %.895.i
  %.924.i = getelementptr double, ptr %221, i64 %.910.i
  store double %.861.i, ptr %.924.i, align 8, !noalias !114
  %exitcond.not.i7261 = icmp eq i64 %arg.schedule.2.5.0, %.764.i
  br i1 %exitcond.not.i7261, label %B358.i7249, label %B300.if.i

B600.if.i:                                        ; preds = %B980.i, %B368.i
  %.1303.01865.i = phi i64 [ 0, %B368.i ], [ %.1372.i, %B980.i ]
  %.1372.i = add nsw i64 %.1303.01865.i, 1
  %222 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1303.01865.i
  %.99.i78.i = load i64, ptr %222, align 8, !noalias !115
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B980.i, label %B46.i82.i

B802.if.i:                                        ; preds = %B920.i, %B802.if.lr.ph.i
  %trouble.2.11862.i = phi double [ 0.000000e+00, %B802.if.lr.ph.i ], [ %.1842.i, %B920.i ]
  %.1701.01860.i = phi i64 [ 0, %B802.if.lr.ph.i ], [ %.1770.i, %B920.i ]
  %.1770.i = add nsw i64 %.1701.01860.i, 1
  %.1801.i = add nsw i64 %.1701.01860.i, %.1231.i7251
  %.1803.i = mul nsw i64 %.1801.i, %arg.shape.0
  %gep7512 = getelementptr double, ptr %invariant.gep7511, i64 %.1803.i
  %.1835.i = load double, ptr %gep7512, align 8, !noalias !114
  %.1840.i = fmul double %.1835.i, 0.000000e+00
  %.1842.i = fadd double %trouble.2.11862.i, %.1840.i
  %.1850.i = mul nsw i64 %.1701.01860.i, %arg.shape.0
  %gep7514 = getelementptr double, ptr %invariant.gep7513, i64 %.1850.i
  store double %.1835.i, ptr %gep7514, align 8, !noalias !114
  br i1 %"$phi770.1.2.1.i", label %B898.i, label %B920.i

B1106.if.i:                                       ; preds = %B1228.i, %B986.i
  %.2224.01868.i = phi i64 [ 0, %B986.i ], [ %.2293.i, %B1228.i ]
  %.2293.i = add nsw i64 %.2224.01868.i, 1
  %223 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2224.01868.i
  %.99.i311.i = load i64, ptr %223, align 8, !noalias !121
  %.104.i314.i = icmp slt i64 %.99.i311.i, 0
  br i1 %.104.i314.i, label %B1228.i, label %B46.i315.i

B3330:                                            ; preds = %B1228.i, %B3280, %B360.i, %B982.i
  br i1 %.274.i, label %B4080, label %B3362.if

B3408:                                            ; preds = %B3362.if
  br i1 %.163.i22937518.not, label %B102.i, label %B46.if.i2629.preheader

B46.if.i2629.preheader:                           ; preds = %B3408
  %invariant.gep7758 = getelementptr double, ptr %arg.arrays.0.4, i64 %.4898.07522
  br label %B46.if.i2629

B102.i:                                           ; preds = %B46.if.i2629, %B3408
  %.360.i2354 = getelementptr double, ptr %arg.lane.0.4, i64 %.4898.07522
  store double 0.000000e+00, ptr %.360.i2354, align 8, !noalias !127
  %.415.i2402 = getelementptr double, ptr %330, i64 %.4898.07522
  store double 5.000000e-01, ptr %.415.i2402, align 8, !noalias !127
  %.470.i2450 = getelementptr double, ptr %331, i64 %.4898.07522
  store double 1.000000e+00, ptr %.470.i2450, align 8, !noalias !127
  %.529.i2498 = getelementptr double, ptr %332, i64 %.4898.07522
  store double 0.000000e+00, ptr %.529.i2498, align 8, !noalias !127
  %.586.i2546 = getelementptr double, ptr %333, i64 %.4898.07522
  store double 0.000000e+00, ptr %.586.i2546, align 8, !noalias !127
  br label %B4107

B46.if.i2629:                                     ; preds = %B46.if.i2629.preheader, %B46.if.i2629
  %.105.i2236.07520 = phi i64 [ %.176.i2637, %B46.if.i2629 ], [ 0, %B46.if.i2629.preheader ]
  %.176.i2637 = add nsw i64 %.105.i2236.07520, 1
  %224 = getelementptr double, ptr %arg.runs.0.4, i64 %.105.i2236.07520
  %.255.i2599 = load double, ptr %224, align 8, !noalias !127
  %.257.i2601 = mul nsw i64 %.105.i2236.07520, %arg.shape.0
  %gep7759 = getelementptr double, ptr %invariant.gep7758, i64 %.257.i2601
  store double %.255.i2599, ptr %gep7759, align 8, !noalias !127
  %exitcond7543.not = icmp eq i64 %arg.shape.1, %.176.i2637
  br i1 %exitcond7543.not, label %B102.i, label %B46.if.i2629

B3448:                                            ; preds = %B3362.if
  %.5172 = mul i64 %.5050, %arg.results.3.5.1
  %.5176 = getelementptr i64, ptr %arg.results.3.4, i64 %.5172
  %.5177 = load i64, ptr %.5176, align 8
  %.5231 = getelementptr i8, ptr %.5176, i64 24
  %.5232 = load i64, ptr %.5231, align 8
  %.5233 = add nsw i64 %.5232, %.5177
  %.5235.not = icmp slt i64 %.5233, %arg.most
  br i1 %.5235.not, label %B3564, label %B3518

B3518:                                            ; preds = %B3448
  %225 = getelementptr i64, ptr %arg.lane.1.4, i64 %.4898.07522
  %.84.i2719 = load i64, ptr %225, align 8, !noalias !131
  %.89.i2722 = icmp sgt i64 %.84.i2719, -1
  br i1 %.89.i2722, label %B46.i2727, label %B3564

B46.i2727:                                        ; preds = %B3518
  %.120.i2752 = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i2719
  %.121.i2753 = load i64, ptr %.120.i2752, align 8, !noalias !131
  %.122.i2754 = icmp eq i64 %.121.i2753, 0
  br i1 %.122.i2754, label %B80.i2759, label %B3564

B80.i2759:                                        ; preds = %B46.i2727
  store i64 5, ptr %.120.i2752, align 8, !noalias !131
  br label %B3564

B3564:                                            ; preds = %B80.i2759, %B3518, %B46.i2727, %B3448
  %.5325 = getelementptr double, ptr %309, i64 %.4898.07522
  %.5326 = load double, ptr %.5325, align 8
  %.5327 = fcmp ogt double %.5326, 5.000000e-01
  br i1 %.5327, label %B3602, label %B3708

B3602:                                            ; preds = %B3564
  %.5382 = getelementptr double, ptr %arg.lane.0.4, i64 %.4898.07522
  %.5383 = load double, ptr %.5382, align 8
  %.5437 = getelementptr double, ptr %310, i64 %.4898.07522
  %.5438 = load double, ptr %.5437, align 8
  %.5439 = fcmp oeq double %.5383, %.5438
  br i1 %.5439, label %B3666, label %B3708

B3666:                                            ; preds = %B3602
  %.246.i3026 = load i64, ptr %.5049, align 8, !noalias !134
  %.264.i3038 = icmp slt i64 %.246.i3026, 0
  %.265.i3039 = select i1 %.264.i3038, i64 %arg.runs.2.5.0, i64 0
  %226 = getelementptr i64, ptr %arg.runs.2.4, i64 %.246.i3026
  %.279.i3053 = getelementptr i64, ptr %226, i64 %.265.i3039
  %.280.i3054 = load i64, ptr %.279.i3053, align 8, !noalias !134
  %.337.i3102 = getelementptr i64, ptr %311, i64 %.4898.07522
  %.338.i3103 = load i64, ptr %.337.i3102, align 8, !noalias !134
  %.339.i3104 = add nsw i64 %.338.i3103, 1
  store i64 %.339.i3104, ptr %.337.i3102, align 8, !noalias !134
  %.460.i3209 = icmp slt i64 %.280.i3054, 0
  %.461.i3210 = select i1 %.460.i3209, i64 %arg.schedule.1.5.0, i64 0
  %227 = getelementptr i64, ptr %arg.schedule.1.4, i64 %.280.i3054
  %.475.i3224 = getelementptr i64, ptr %227, i64 %.461.i3210
  %.476.i3225 = load i64, ptr %.475.i3224, align 8, !noalias !134
  %.477.i3226 = icmp eq i64 %.339.i3104, %.476.i3225
  br i1 %.477.i3226, label %B186.i, label %B244.i

B186.i:                                           ; preds = %B3666
  %.516.i3581 = select i1 %.264.i3038, i64 %arg.results.1.5.0, i64 0
  %228 = getelementptr i64, ptr %arg.results.1.4, i64 %.246.i3026
  %.530.i3595 = getelementptr i64, ptr %228, i64 %.516.i3581
  %.531.i3596 = load i64, ptr %.530.i3595, align 8, !noalias !134
  %.532.i3597 = icmp eq i64 %.531.i3596, 0
  br i1 %.532.i3597, label %B220.i, label %B3708

B220.i:                                           ; preds = %B186.i
  store i64 1, ptr %.530.i3595, align 8, !noalias !134
  br label %B3708

B244.i:                                           ; preds = %B3666
  %.659.i3298 = select i1 %.460.i3209, i64 %arg.schedule.0.5.0, i64 0
  %.660.i3299 = add i64 %.659.i3298, %.280.i3054
  %.661.i3300 = icmp slt i64 %.338.i3103, -1
  %.662.i3301 = select i1 %.661.i3300, i64 %arg.schedule.0.5.1, i64 0
  %.680.i3318 = mul i64 %.660.i3299, %arg.schedule.0.5.1
  %229 = getelementptr double, ptr %arg.schedule.0.4, i64 %.680.i3318
  %230 = getelementptr double, ptr %229, i64 %.339.i3104
  %.684.i3321 = getelementptr double, ptr %230, i64 %.662.i3301
  %.685.i3322 = load double, ptr %.684.i3321, align 8, !noalias !134
  store double %.685.i3322, ptr %.5437, align 8, !noalias !134
  %.797.i3407 = load i64, ptr %.337.i3102, align 8, !noalias !134
  %.822.i3424 = select i1 %.460.i3209, i64 %arg.schedule.4.5.0, i64 0
  %.823.i3425 = add i64 %.822.i3424, %.280.i3054
  %.824.i3426 = icmp slt i64 %.797.i3407, 0
  %.825.i3427 = select i1 %.824.i3426, i64 %arg.schedule.4.5.1, i64 0
  %.843.i3444 = mul i64 %.823.i3425, %arg.schedule.4.5.1
  %231 = getelementptr i64, ptr %arg.schedule.4.4, i64 %.843.i3444
  %232 = getelementptr i64, ptr %231, i64 %.797.i3407
  %.847.i3448 = getelementptr i64, ptr %232, i64 %.825.i3427
  %.848.i3449 = load i64, ptr %.847.i3448, align 8, !noalias !134
  %.851.i = icmp eq i64 %.848.i3449, 0
  br i1 %.851.i, label %B364.i, label %B412.i

B364.i:                                           ; preds = %B244.i
  %.906.i3540 = getelementptr double, ptr %312, i64 %.4898.07522
  store double 1.000000e+00, ptr %.906.i3540, align 8, !noalias !134
  br label %B456.i.sink.split

B412.i:                                           ; preds = %B244.i
  %.974.i3458 = load i64, ptr %.722, align 8, !noalias !134
  %.975.i3459 = icmp eq i64 %.974.i3458, 0
  br i1 %.975.i3459, label %B456.i.sink.split, label %B456.i

B456.i.sink.split:                                ; preds = %B412.i, %B364.i
  %.sink = phi i64 [ 1, %B364.i ], [ 2, %B412.i ]
  store i64 %.sink, ptr %.722, align 8, !noalias !134
  br label %B456.i

B456.i:                                           ; preds = %B456.i.sink.split, %B412.i
  br i1 %.1103.i7515.not, label %B3708, label %B512.if.i.lr.ph

B512.if.i.lr.ph:                                  ; preds = %B456.i
  %.1227.i = select i1 %.460.i3209, i64 %arg.schedule.3.5.0, i64 0
  %.1228.i = add i64 %.1227.i, %.280.i3054
  %.1258.i = mul i64 %.1256.i, %.1228.i
  %233 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1258.i
  br label %B512.if.i

B512.if.i:                                        ; preds = %B512.if.i.lr.ph, %B512.if.i
  %.1045.i2960.07517 = phi i64 [ 0, %B512.if.i.lr.ph ], [ %.1116.i, %B512.if.i ]
  %.1116.i = add nsw i64 %.1045.i2960.07517, 1
  %.1195.i = load i64, ptr %.337.i3102, align 8, !noalias !134
  %.1229.i = icmp slt i64 %.1195.i, 0
  %.1230.i = select i1 %.1229.i, i64 %arg.schedule.3.5.1, i64 0
  %.1231.i = add i64 %.1230.i, %.1195.i
  %.1260.i = mul i64 %.1231.i, %arg.schedule.3.5.2
  %234 = getelementptr double, ptr %233, i64 %.1260.i
  %235 = getelementptr double, ptr %234, i64 %.1045.i2960.07517
  %.1265.i = load double, ptr %235, align 8, !noalias !134
  %236 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1045.i2960.07517
  %.1295.i = load i64, ptr %236, align 8, !noalias !134
  %.1297.i = mul nsw i64 %.1295.i, %arg.shape.0
  %.1299.i = add nsw i64 %.1297.i, %.4898.07522
  %.1313.i = icmp slt i64 %.1299.i, 0
  %.1314.i = select i1 %.1313.i, i64 %arg.arrays.1.5.0, i64 0
  %237 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1299.i
  %.1328.i = getelementptr double, ptr %237, i64 %.1314.i
  store double %.1265.i, ptr %.1328.i, align 8, !noalias !134
  %exitcond7542.not = icmp eq i64 %arg.schedule.2.5.0, %.1116.i
  br i1 %exitcond7542.not, label %B3708, label %B512.if.i

B3708:                                            ; preds = %B512.if.i, %B456.i, %B220.i, %B186.i, %B3602, %B3564
  %.5545 = getelementptr i64, ptr %arg.results.1.4, i64 %.5050
  %.5546 = load i64, ptr %.5545, align 8
  %.5547.not = icmp eq i64 %.5546, 0
  br i1 %.5547.not, label %B3866, label %B3742

B3742:                                            ; preds = %B3708
  %.5607 = getelementptr i64, ptr %313, i64 %.4898.07522
  %.5608 = load i64, ptr %.5607, align 8
  %.5638 = getelementptr i64, ptr %arg.results.2.4, i64 %.5050
  store i64 %.5608, ptr %.5638, align 8
  store i64 -1, ptr %.5049, align 8
  %.314.i7262 = load i64, ptr %arg.lane.2.4, align 8, !noalias !138
  %.374.i7264 = load i64, ptr %.373.i7263, align 8, !noalias !138
  %.375.i7265 = icmp slt i64 %.314.i7262, %.374.i7264
  br i1 %.375.i7265, label %B130.i7385, label %B316.i7266

B130.i7385:                                       ; preds = %B3742
  %.385.i7386 = add nsw i64 %.314.i7262, 1
  store i64 %.385.i7386, ptr %arg.lane.2.4, align 8, !noalias !138
  store i64 1, ptr %.722, align 8, !noalias !138
  store i64 %.314.i7262, ptr %.5049, align 8, !noalias !138
  %.557.i7391 = getelementptr i64, ptr %314, i64 %.4898.07522
  store i64 0, ptr %.557.i7391, align 8, !noalias !138
  store i64 1, ptr %.5607, align 8, !noalias !138
  br i1 %.6961437.not.i7394, label %B316.i7266, label %B272.if.lr.ph.i7395

B272.if.lr.ph.i7395:                              ; preds = %B130.i7385
  %.757.i7396 = icmp slt i64 %.314.i7262, 0
  %.758.i7397 = select i1 %.757.i7396, i64 %arg.runs.0.5.0, i64 0
  %.759.i7398 = add i64 %.758.i7397, %.314.i7262
  %.779.i7399 = mul i64 %.759.i7398, %arg.runs.0.5.1
  %238 = getelementptr double, ptr %arg.runs.0.4, i64 %.779.i7399
  %.822.i7400 = select i1 %.757.i7396, i64 %arg.results.0.5.0, i64 0
  %.823.i7401 = add i64 %.822.i7400, %.314.i7262
  %.853.i7403 = mul i64 %.851.i7402, %.823.i7401
  %239 = getelementptr double, ptr %arg.results.0.4, i64 %.853.i7403
  br i1 %min.iters.check7553, label %B272.if.i7404.preheader, label %vector.memcheck7548

vector.memcheck7548:                              ; preds = %B272.if.lr.ph.i7395
  %240 = mul i64 %335, %.823.i7401
  %241 = mul i64 %336, %.759.i7398
  %242 = add i64 %240, %arg.results.0.47549
  %243 = add i64 %241, %arg.runs.0.47550
  %244 = sub i64 %242, %243
  %diff.check7551 = icmp ult i64 %244, 32
  br i1 %diff.check7551, label %B272.if.i7404.preheader, label %vector.body7557

vector.body7557:                                  ; preds = %vector.memcheck7548, %vector.body7557
  %index7558 = phi i64 [ %index.next7561, %vector.body7557 ], [ 0, %vector.memcheck7548 ]
  %245 = getelementptr double, ptr %238, i64 %index7558
  %246 = getelementptr i8, ptr %245, i64 16
  %wide.load7559 = load <2 x double>, ptr %245, align 8, !noalias !138
  %wide.load7560 = load <2 x double>, ptr %246, align 8, !noalias !138
  %247 = getelementptr double, ptr %239, i64 %index7558
  %248 = getelementptr i8, ptr %247, i64 16
  store <2 x double> %wide.load7559, ptr %247, align 8, !noalias !138
  store <2 x double> %wide.load7560, ptr %248, align 8, !noalias !138
  %index.next7561 = add i64 %index7558, 4
  %249 = icmp eq i64 %index.next7561, %n.vec7556
  br i1 %249, label %middle.block7562, label %vector.body7557, !llvm.loop !141

middle.block7562:                                 ; preds = %vector.body7557
  br i1 %cmp.n7563, label %B316.i7266, label %B272.if.i7404.preheader

B272.if.i7404.preheader:                          ; preds = %vector.memcheck7548, %B272.if.lr.ph.i7395, %middle.block7562
  %.638.01438.i7405.ph = phi i64 [ 0, %vector.memcheck7548 ], [ 0, %B272.if.lr.ph.i7395 ], [ %n.vec7556, %middle.block7562 ]
  br label %B272.if.i7404

B316.i7266:                                       ; preds = %B272.if.i7404, %middle.block7562, %B130.i7385, %B3742
  %m.2.0.i7267 = phi i64 [ 0, %B3742 ], [ %.314.i7262, %B130.i7385 ], [ %.314.i7262, %middle.block7562 ], [ %.314.i7262, %B272.if.i7404 ]
  br i1 %.9661440.not.i7268, label %B390.i7284, label %B346.if.lr.ph.i7269

B346.if.lr.ph.i7269:                              ; preds = %B316.i7266
  %.1027.i7270 = icmp slt i64 %m.2.0.i7267, 0
  %.1028.i7271 = select i1 %.1027.i7270, i64 %arg.runs.1.5.0, i64 0
  %.1029.i7272 = add i64 %.1028.i7271, %m.2.0.i7267
  %.1049.i7273 = mul i64 %.1029.i7272, %arg.runs.1.5.1
  %250 = getelementptr double, ptr %arg.runs.1.4, i64 %.1049.i7273
  %invariant.gep7752 = getelementptr double, ptr %arg.arrays.1.4, i64 %.4898.07522
  br label %B346.if.i7274

B390.i7284:                                       ; preds = %B346.if.i7274, %B316.i7266
  br i1 %.11851443.not.i7285, label %B516.i7307, label %B446.if.lr.ph.i7286

B446.if.lr.ph.i7286:                              ; preds = %B390.i7284
  %.1237.i7287 = icmp slt i64 %m.2.0.i7267, 0
  %.1238.i7288 = select i1 %.1237.i7287, i64 %arg.runs.2.5.0, i64 0
  %251 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i7267
  %.1252.i7289 = getelementptr i64, ptr %251, i64 %.1238.i7288
  br label %B446.if.i7291

B516.i7307:                                       ; preds = %B446.if.i7291, %B390.i7284
  br i1 %.375.i7265, label %B574.i7335, label %B520.i7308

B520.i7308:                                       ; preds = %B516.i7307
  br i1 %.1423.i7309, label %B532.i7311, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit7409

B532.i7311:                                       ; preds = %B520.i7308
  br i1 %.163.i1446.not.i7312, label %B102.i.i7323, label %B46.if.i.i7313.preheader

B46.if.i.i7313.preheader:                         ; preds = %B532.i7311
  %invariant.gep7754 = getelementptr double, ptr %arg.arrays.0.4, i64 %.4898.07522
  br label %B46.if.i.i7313

B102.i.i7323:                                     ; preds = %B46.if.i.i7313, %B532.i7311
  %.360.i.i7327 = getelementptr double, ptr %arg.lane.0.4, i64 %.4898.07522
  store double 0.000000e+00, ptr %.360.i.i7327, align 8, !noalias !142
  %.415.i.i7328 = getelementptr double, ptr %315, i64 %.4898.07522
  store double 5.000000e-01, ptr %.415.i.i7328, align 8, !noalias !142
  %.470.i.i7330 = getelementptr double, ptr %316, i64 %.4898.07522
  store double 1.000000e+00, ptr %.470.i.i7330, align 8, !noalias !142
  %.529.i.i7332 = getelementptr double, ptr %317, i64 %.4898.07522
  store double 0.000000e+00, ptr %.529.i.i7332, align 8, !noalias !142
  %.586.i.i7334 = getelementptr double, ptr %318, i64 %.4898.07522
  store double 0.000000e+00, ptr %.586.i.i7334, align 8, !noalias !142
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit7409

B46.if.i.i7313:                                   ; preds = %B46.if.i.i7313.preheader, %B46.if.i.i7313
  %.105.i.01447.i7314 = phi i64 [ %.176.i.i7315, %B46.if.i.i7313 ], [ 0, %B46.if.i.i7313.preheader ]
  %.176.i.i7315 = add nsw i64 %.105.i.01447.i7314, 1
  %252 = getelementptr double, ptr %arg.runs.0.4, i64 %.105.i.01447.i7314
  %.255.i.i7316 = load double, ptr %252, align 8, !noalias !142
  %.257.i.i7317 = mul nsw i64 %.105.i.01447.i7314, %arg.shape.0
  %gep7755 = getelementptr double, ptr %invariant.gep7754, i64 %.257.i.i7317
  store double %.255.i.i7316, ptr %gep7755, align 8, !noalias !142
  %exitcond1454.not.i7322 = icmp eq i64 %arg.shape.1, %.176.i.i7315
  br i1 %exitcond1454.not.i7322, label %B102.i.i7323, label %B46.if.i.i7313

B574.i7335:                                       ; preds = %B516.i7307
  br i1 %.15851449.not.i7336, label %B648.i7352, label %B604.if.lr.ph.i7337

B604.if.lr.ph.i7337:                              ; preds = %B574.i7335
  %.1646.i7338 = icmp slt i64 %m.2.0.i7267, 0
  %.1647.i7339 = select i1 %.1646.i7338, i64 %arg.runs.0.5.0, i64 0
  %.1648.i7340 = add i64 %.1647.i7339, %m.2.0.i7267
  %.1668.i7341 = mul i64 %.1648.i7340, %arg.runs.0.5.1
  %253 = getelementptr double, ptr %arg.runs.0.4, i64 %.1668.i7341
  %invariant.gep7756 = getelementptr double, ptr %arg.arrays.0.4, i64 %.4898.07522
  br label %B604.if.i7342

B648.i7352:                                       ; preds = %B604.if.i7342, %B574.i7335
  %.1748.i7353 = load double, ptr %arg.times.4, align 8, !noalias !138
  %.1765.i7354 = icmp slt i64 %m.2.0.i7267, 0
  %.1766.i7355 = select i1 %.1765.i7354, i64 %arg.runs.2.5.0, i64 0
  %254 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i7267
  %.1780.i7356 = getelementptr i64, ptr %254, i64 %.1766.i7355
  %.1781.i7357 = load i64, ptr %.1780.i7356, align 8, !noalias !138
  %.1812.i7358 = icmp slt i64 %.1781.i7357, 0
  %.1813.i7359 = select i1 %.1812.i7358, i64 %arg.schedule.0.5.0, i64 0
  %.1814.i7360 = add i64 %.1813.i7359, %.1781.i7357
  %.1834.i7361 = mul i64 %.1814.i7360, %arg.schedule.0.5.1
  %.1838.i7362 = getelementptr double, ptr %arg.schedule.0.4, i64 %.1834.i7361
  %.1839.i7363 = load double, ptr %.1838.i7362, align 8, !noalias !138
  %.1895.i7367 = getelementptr double, ptr %arg.lane.0.4, i64 %.4898.07522
  store double %.1748.i7353, ptr %.1895.i7367, align 8, !noalias !138
  %.1950.i7369 = getelementptr double, ptr %319, i64 %.4898.07522
  store double %.1839.i7363, ptr %.1950.i7369, align 8, !noalias !138
  %.2005.i7370 = getelementptr double, ptr %320, i64 %.4898.07522
  store double 0.000000e+00, ptr %.2005.i7370, align 8, !noalias !138
  %.2064.i7372 = getelementptr double, ptr %321, i64 %.4898.07522
  store double 1.000000e+00, ptr %.2064.i7372, align 8, !noalias !138
  %.2119.i7374 = getelementptr double, ptr %322, i64 %.4898.07522
  store double 0.000000e+00, ptr %.2119.i7374, align 8, !noalias !138
  %.2175.i7376 = getelementptr double, ptr %323, i64 %.4898.07522
  store double 0xFFF0000000000000, ptr %.2175.i7376, align 8, !noalias !138
  %255 = getelementptr i64, ptr %324, i64 %.4898.07522
  store i64 0, ptr %255, align 8, !noalias !138
  %.2287.i7381 = getelementptr double, ptr %325, i64 %.4898.07522
  %.2288.i7382 = load double, ptr %.2287.i7381, align 8, !noalias !138
  %.2290.i7383 = fcmp ueq double %.2288.i7382, 0xFFF0000000000000
  br i1 %.2290.i7383, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit7409, label %B944.i7384

B944.i7384:                                       ; preds = %B648.i7352
  store double 0.000000e+00, ptr %.2287.i7381, align 8, !noalias !138
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit7409

B272.if.i7404:                                    ; preds = %B272.if.i7404.preheader, %B272.if.i7404
  %.638.01438.i7405 = phi i64 [ %.709.i7406, %B272.if.i7404 ], [ %.638.01438.i7405.ph, %B272.if.i7404.preheader ]
  %.709.i7406 = add nsw i64 %.638.01438.i7405, 1
  %256 = getelementptr double, ptr %238, i64 %.638.01438.i7405
  %.784.i7407 = load double, ptr %256, align 8, !noalias !138
  %257 = getelementptr double, ptr %239, i64 %.638.01438.i7405
  store double %.784.i7407, ptr %257, align 8, !noalias !138
  %exitcond.not.i7408 = icmp eq i64 %.709.i7406, %arg.shape.1
  br i1 %exitcond.not.i7408, label %B316.i7266, label %B272.if.i7404, !llvm.loop !146

B346.if.i7274:                                    ; preds = %B346.if.i7274, %B346.if.lr.ph.i7269
  %.910.01441.i7275 = phi i64 [ 0, %B346.if.lr.ph.i7269 ], [ %.979.i7276, %B346.if.i7274 ]
  %.979.i7276 = add nsw i64 %.910.01441.i7275, 1
  %258 = getelementptr double, ptr %250, i64 %.910.01441.i7275
  %.1054.i7277 = load double, ptr %258, align 8, !noalias !138
  %.1056.i7278 = mul nsw i64 %.910.01441.i7275, %arg.shape.0
  %gep7753 = getelementptr double, ptr %invariant.gep7752, i64 %.1056.i7278
  store double %.1054.i7277, ptr %gep7753, align 8, !noalias !138
  %exitcond1452.not.i7283 = icmp eq i64 %.979.i7276, %arg.shape.2
  br i1 %exitcond1452.not.i7283, label %B390.i7284, label %B346.if.i7274

B446.if.i7291:                                    ; preds = %B446.if.i7291, %B446.if.lr.ph.i7286
  %.1129.01444.i7292 = phi i64 [ 0, %B446.if.lr.ph.i7286 ], [ %.1198.i7293, %B446.if.i7291 ]
  %.1198.i7293 = add nsw i64 %.1129.01444.i7292, 1
  %.1253.i7294 = load i64, ptr %.1252.i7289, align 8, !noalias !138
  %.1289.i7295 = icmp slt i64 %.1253.i7294, 0
  %.1290.i7296 = select i1 %.1289.i7295, i64 %arg.schedule.3.5.0, i64 0
  %.1291.i7297 = add i64 %.1290.i7296, %.1253.i7294
  %.1321.i7298 = mul i64 %.1319.i7290, %.1291.i7297
  %259 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1321.i7298
  %260 = getelementptr double, ptr %259, i64 %.1129.01444.i7292
  %.1328.i7299 = load double, ptr %260, align 8, !noalias !138
  %261 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1129.01444.i7292
  %.1358.i7300 = load i64, ptr %261, align 8, !noalias !138
  %.1360.i7301 = mul nsw i64 %.1358.i7300, %arg.shape.0
  %.1362.i7302 = add nsw i64 %.1360.i7301, %.4898.07522
  %.1376.i7303 = icmp slt i64 %.1362.i7302, 0
  %.1377.i7304 = select i1 %.1376.i7303, i64 %arg.arrays.1.5.0, i64 0
  %262 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1362.i7302
  %.1391.i7305 = getelementptr double, ptr %262, i64 %.1377.i7304
  store double %.1328.i7299, ptr %.1391.i7305, align 8, !noalias !138
  %exitcond1453.not.i7306 = icmp eq i64 %.1198.i7293, %arg.schedule.2.5.0
  br i1 %exitcond1453.not.i7306, label %B516.i7307, label %B446.if.i7291

B604.if.i7342:                                    ; preds = %B604.if.i7342, %B604.if.lr.ph.i7337
  %.1529.01450.i7343 = phi i64 [ 0, %B604.if.lr.ph.i7337 ], [ %.1598.i7344, %B604.if.i7342 ]
  %.1598.i7344 = add nsw i64 %.1529.01450.i7343, 1
  %263 = getelementptr double, ptr %253, i64 %.1529.01450.i7343
  %.1673.i7345 = load double, ptr %263, align 8, !noalias !138
  %.1675.i7346 = mul nsw i64 %.1529.01450.i7343, %arg.shape.0
  %gep7757 = getelementptr double, ptr %invariant.gep7756, i64 %.1675.i7346
  store double %.1673.i7345, ptr %gep7757, align 8, !noalias !138
  %exitcond1455.not.i7351 = icmp eq i64 %.1598.i7344, %arg.shape.1
  br i1 %exitcond1455.not.i7351, label %B648.i7352, label %B604.if.i7342

_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit7409: ; preds = %B520.i7308, %B102.i.i7323, %B648.i7352, %B944.i7384
  %storemerge1429.i7310 = phi i64 [ 0, %B520.i7308 ], [ 0, %B102.i.i7323 ], [ 1, %B944.i7384 ], [ 1, %B648.i7352 ]
  %.5698 = add nsw i64 %active.3.27525, -1
  %.5798 = add nsw i64 %.5698, %storemerge1429.i7310
  br label %B4107

B3866:                                            ; preds = %B3708
  %.5857 = getelementptr double, ptr %326, i64 %.4898.07522
  %.5858 = load double, ptr %.5857, align 8
  %.5860 = fcmp ult double %.5858, 1.500000e+01
  br i1 %.5860, label %B4107, label %B3914

B3914:                                            ; preds = %B3866
  %.5902 = load double, ptr %.5901, align 8
  %.5956 = getelementptr double, ptr %arg.lane.0.4, i64 %.4898.07522
  %.5957 = load double, ptr %.5956, align 8
  %.5958 = fsub double %.5902, %.5957
  %.6012 = getelementptr double, ptr %329, i64 %.4898.07522
  %.6013 = load double, ptr %.6012, align 8
  %.6015 = fmul double %.6013, 5.000000e+03
  %.6016 = fcmp ogt double %.5958, %.6015
  br i1 %.6016, label %B4107, label %B4052

B4052:                                            ; preds = %B3914
  store double 0.000000e+00, ptr %.5857, align 8
  br label %B4107

B4080:                                            ; preds = %B4107, %B3330
  %budget.4.2.lcssa = phi i64 [ %.688, %B3330 ], [ %budget.5.2, %B4107 ]
  %active.3.2.lcssa = phi i64 [ %active.4.0, %B3330 ], [ %active.5.2, %B4107 ]
  %.6109 = icmp sgt i64 %active.3.2.lcssa, 0
  %.6123 = icmp sgt i64 %budget.4.2.lcssa, 0
  %or.cond7079 = select i1 %.6109, i1 %.6123, i1 false
  br i1 %or.cond7079, label %B276, label %B4106

B4106:                                            ; preds = %B4080, %B202.endif
  %active.6.1 = phi i64 [ %active.3.i.0.lcssa, %B202.endif ], [ %active.3.2.lcssa, %B4080 ]
  store i64 %active.6.1, ptr %retptr, align 8
  ret i32 0

B4107:                                            ; preds = %B3866, %B4052, %B3914, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit7409, %B102.i
  %budget.5.2 = phi i64 [ %budget.4.27524, %B102.i ], [ %budget.4.27524, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit7409 ], [ 0, %B3914 ], [ %budget.4.27524, %B4052 ], [ %budget.4.27524, %B3866 ]
  %active.5.2 = phi i64 [ %active.3.27525, %B102.i ], [ %.5798, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit7409 ], [ %active.3.27525, %B3914 ], [ %active.3.27525, %B4052 ], [ %active.3.27525, %B3866 ]
  %.4955 = icmp sgt i64 %.4901.07523, 1
  br i1 %.4955, label %B3362.if, label %B4080

B4108:                                            ; preds = %B1616.if, %B2122, %B2162, %B2212, %B1868
  %good.3.2 = phi i1 [ %good.2.17439, %B1868 ], [ true, %B2212 ], [ true, %B2162 ], [ true, %B2122 ], [ %good.2.17439, %B1616.if ]
  %wanted.3.2 = phi i1 [ %wanted.2.17440, %B1868 ], [ true, %B2212 ], [ %wanted.2.17440, %B2162 ], [ %wanted.2.17440, %B2122 ], [ %wanted.2.17440, %B1616.if ]
  %within.4.2 = phi i1 [ %within.3.17441, %B1868 ], [ %spec.select7074, %B2212 ], [ %spec.select, %B2162 ], [ %spec.select, %B2122 ], [ %within.3.17441, %B1616.if ]
  %doubted.3.2 = phi i1 [ %doubted.2.17442, %B1868 ], [ %"$phi2122.1.3.4", %B2212 ], [ %"$phi2122.1.3.4", %B2162 ], [ %"$phi2122.1.3.4", %B2122 ], [ %doubted.2.17442, %B1616.if ]
  %.2272 = icmp sgt i64 %.2218.07438, 1
  br i1 %.2272, label %B1616.if, label %B2274.loopexit

B202.endif:                                       ; preds = %B171.i, %entry
  %active.3.i.0.lcssa = phi i64 [ 0, %entry ], [ %active.4.i.1, %B171.i ]
  %.662 = icmp sgt i64 %active.3.i.0.lcssa, 0
  %.678 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.662, i1 %.678, i1 false
  br i1 %or.cond, label %B276.preheader, label %B4106

B276.preheader:                                   ; preds = %B202.endif
  %.722 = getelementptr i8, ptr %arg.lane.2.4, i64 16
  %factor.op.mul = mul i64 %arg.shape.0, %arg.shape.1
  %factor.op.mul7528 = mul i64 %arg.shape.0, %arg.shape.1
  %.818 = getelementptr i8, ptr %arg.code.4, i64 8
  %.875 = icmp sgt i64 %arg.decided, 0
  %.149.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx7073 = mul i64 %arg.lane.0.5.1, 24
  %264 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7073
  %.457.i1787417 = icmp slt i64 %arg.decided, 1
  %.1009.idx = shl i64 %.382, 4
  %.1009 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1009.idx
  %.1013.not = icmp eq i64 %arg.guarded, 0
  %.1043 = getelementptr i8, ptr %arg.code.4, i64 16
  %.1120 = getelementptr i8, ptr %arg.code.4, i64 72
  %.1196 = getelementptr i8, ptr %arg.code.4, i64 80
  %.1297.idx = mul i64 %.382, 136
  %.1297 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1297.idx
  %.1322.idx = mul i64 %.382, 24
  %.1322 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1322.idx
  %.1353 = getelementptr i8, ptr %arg.code.4, i64 88
  %.idx7068 = mul i64 %arg.lane.0.5.1, 24
  %265 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7068
  %.idx7069 = shl i64 %arg.lane.0.5.1, 5
  %266 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7069
  %.idx7070 = mul i64 %arg.lane.0.5.1, 136
  %267 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7070
  %.idx7071 = mul i64 %arg.lane.0.5.1, 88
  %268 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7071
  %.idx7072 = shl i64 %arg.lane.0.5.1, 4
  %269 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7072
  %.1658.c = getelementptr i8, ptr %arg.code.4, i64 56
  %.1512.idx = shl i64 %arg.lane.1.5.1, 4
  %.1512 = getelementptr i8, ptr %arg.lane.1.4, i64 %.1512.idx
  %.1625.idx = mul i64 %arg.lane.0.5.1, 168
  %.1625 = getelementptr i8, ptr %arg.lane.0.4, i64 %.1625.idx
  %.1658 = getelementptr i8, ptr %arg.code.4, i64 56
  %.127.i = mul nsw i64 %arg.shape.1, %arg.shape.1
  %.174.not.i = icmp slt i64 %.127.i, %arg.linear.0.5.0
  %.344.i = icmp slt i64 %arg.linear.1.5.0, 6
  %.524.idx.i = shl i64 %arg.lane.0.5.1, 5
  %.524.i = getelementptr i8, ptr %arg.lane.0.4, i64 %.524.idx.i
  %.123.i.i = shl nsw i64 %arg.shape.1, 1
  %.124.i.i = add nsw i64 %.123.i.i, 5
  %.153.i.i7092 = getelementptr i8, ptr %arg.linear.1.4, i64 24
  %.183.i.i7094 = getelementptr i8, ptr %arg.linear.1.4, i64 32
  %.186.i.i = add nsw i64 %.124.i.i, %arg.shape.1
  %.187.i.i = add nsw i64 %.186.i.i, 1
  %.224.i.i = icmp slt i64 %arg.shape.1, -2
  %.225.i.i = select i1 %.224.i.i, i64 %arg.linear.1.5.0, i64 0
  %.226.i.i = add i64 %.225.i.i, %.124.i.i
  %.229.i.i = icmp slt i64 %.226.i.i, 0
  %.234.i.i = icmp sge i64 %.226.i.i, %arg.linear.1.5.0
  %270 = or i1 %.229.i.i, %.234.i.i
  %.241.i.i = icmp slt i64 %.186.i.i, -1
  %.242.i.i = select i1 %.241.i.i, i64 %arg.linear.1.5.0, i64 0
  %.243.i.i = add i64 %.242.i.i, %.187.i.i
  %.246.i.i = icmp slt i64 %.243.i.i, 0
  %.251.i.not.i = icmp slt i64 %.243.i.i, %arg.linear.1.5.0
  %.409.i.i = icmp sge i64 %.243.i.i, %arg.linear.1.5.0
  %271 = or i1 %.246.i.i, %.409.i.i
  %.538.i.i = add i64 %arg.shape.1, 1
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
  %.1807.i.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1807.i.idx.i
  %.1832.i.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.1789.i.i
  %.153.i.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.499.i.i.idx.i = mul i64 %arg.lane.0.5.1, 48
  %.499.i.i.i = getelementptr i8, ptr %arg.lane.0.4, i64 %.499.i.i.idx.i
  %.503.i.i.i = mul nsw i64 %arg.shape.1, 18
  %.520.i.i.i = select i1 %.1556.i2382.not.i, i64 %arg.arrays.0.5.0, i64 0
  %.idx.i7097 = mul i64 %arg.shape.1, 152
  %272 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx.i7097
  %.534.i.i.i = getelementptr double, ptr %272, i64 %.520.i.i.i
  %.897.i.i.i = mul nsw i64 %arg.shape.1, 17
  %.1279.i.i.idx.i = mul i64 %arg.shape.1, 96
  %.1279.i.i.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1279.i.i.idx.i
  %.2636.i.i = mul nsw i64 %arg.shape.1, 11
  %.idx2423.i = mul i64 %arg.shape.1, 144
  %invariant.gep = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx2423.i
  %.idx2424.i = mul i64 %arg.shape.1, 144
  %invariant.gep7426 = getelementptr double, ptr %arg.arrays.0.4, i64 %.503.i.i.i
  %invariant.gep7428 = getelementptr double, ptr %arg.arrays.0.4, i64 %.503.i.i.i
  %.663.i = getelementptr i8, ptr %arg.linear.1.4, i64 8
  %.711.i = icmp sgt i64 %arg.shape.1, 0
  %.743.sroa.0.02358.i = add i64 %arg.shape.1, 1
  %.1140.idx.i = mul i64 %arg.lane.0.5.1, 160
  %.1140.i = getelementptr i8, ptr %arg.lane.0.4, i64 %.1140.idx.i
  %.2020.idx = mul i64 %.382, 136
  %.2020 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.2020.idx
  %.42.i = mul nsw i64 %arg.shape.1, %arg.shape.1
  %.88.not.i = icmp slt i64 %.42.i, %arg.linear.0.5.0
  %.218.i = add nsw i64 %arg.shape.1, 5
  %.265.i = icmp slt i64 %arg.linear.1.5.0, 6
  %.272.i = icmp slt i64 %arg.shape.1, -5
  %.273.i = select i1 %.272.i, i64 %arg.linear.1.5.0, i64 0
  %.274.i7101 = add i64 %.218.i, %.273.i
  %.277.i = icmp slt i64 %.274.i7101, 0
  %.282.not.i = icmp slt i64 %.274.i7101, %arg.linear.1.5.0
  %.648747.not.i = icmp slt i64 %arg.shape.1, 1
  %.756.i = mul nsw i64 %arg.shape.1, 17
  %.idx.i7104 = mul i64 %arg.shape.1, 80
  %invariant.gep7430 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx.i7104
  %.882.i = getelementptr i8, ptr %arg.linear.1.4, i64 8
  %.887.i = mul nsw i64 %arg.shape.1, 17
  %invariant.gep7432 = getelementptr double, ptr %arg.arrays.0.4, i64 %.887.i
  %.2123 = getelementptr i8, ptr %arg.code.4, i64 64
  %.idx7063 = shl i64 %arg.lane.1.5.1, 4
  %273 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx7063
  %.idx7064 = mul i64 %arg.lane.0.5.1, 72
  %274 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7064
  %.idx7065 = mul i64 %arg.lane.0.5.1, 40
  %275 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7065
  %.2868 = icmp sgt i64 %arg.guarded, 0
  %.idx7066 = mul i64 %arg.lane.0.5.1, 144
  %276 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7066
  %.idx7067 = mul i64 %arg.lane.0.5.1, 56
  %277 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7067
  %.3642.idx = mul i64 %.382, 136
  %.3642 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3642.idx
  %.3667.idx = mul i64 %.382, 104
  %.3667 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3667.idx
  %.3705 = getelementptr i8, ptr %arg.code.4, i64 264
  %.3762 = icmp sgt i64 %arg.decided, 0
  %.3801 = getelementptr i8, ptr %arg.code.4, i64 40
  %.3823.idx = mul i64 %.382, 136
  %.3823 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3823.idx
  %.idx7058 = mul i64 %arg.lane.0.5.1, 96
  %278 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7058
  %.idx7059 = mul i64 %arg.lane.0.5.1, 40
  %279 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7059
  %.idx7060 = mul i64 %arg.lane.0.5.1, 104
  %280 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7060
  %.idx7061 = mul i64 %arg.lane.0.5.1, 112
  %281 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7061
  %.idx7062 = shl i64 %arg.lane.1.5.1, 5
  %282 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx7062
  %.4162.idx = mul i64 %.382, 136
  %.4162 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4162.idx
  %.4224 = getelementptr i8, ptr %arg.code.4, i64 200
  %.4301 = getelementptr i8, ptr %arg.code.4, i64 104
  %.1013.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.1105.i7119.idx = shl i64 %factor.op.mul, 4
  %.1105.i7119 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1105.i7119.idx
  %.idx1174.i = mul i64 %arg.lane.0.5.1, 104
  %283 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1174.i
  %.idx1175.i = mul i64 %arg.lane.0.5.1, 112
  %284 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1175.i
  %.idx1176.i = mul i64 %arg.lane.0.5.1, 96
  %285 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1176.i
  %.idx1177.i = mul i64 %arg.lane.0.5.1, 48
  %286 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1177.i
  %.8631184.not.i = icmp slt i64 %arg.shape.1, 1
  %.935.i = shl nsw i64 %arg.shape.1, 1
  %storemerge1173.i = tail call i64 @llvm.smax.i64(i64 %arg.decided, i64 0)
  %.155.i.i = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i = mul nsw i64 %arg.shape.1, 18
  %.idx.i7123 = mul i64 %arg.lane.0.5.1, 56
  %287 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx.i7123
  %.idx1165.i = mul i64 %arg.lane.0.5.1, 40
  %288 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1165.i
  %.idx1166.i = shl i64 %arg.lane.0.5.1, 5
  %289 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1166.i
  %290 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.4428.not = icmp eq i64 %arg.guarded, 0
  %.845.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.937.i.idx = shl i64 %factor.op.mul7528, 4
  %.937.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.937.i.idx
  %.idx652.i = mul i64 %arg.lane.0.5.1, 48
  %291 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx652.i
  %.695658.not.i = icmp slt i64 %arg.shape.1, 1
  %.767.i = shl nsw i64 %arg.shape.1, 1
  %.idx.i7130 = mul i64 %arg.lane.0.5.1, 40
  %292 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx.i7130
  %.155.i.i7133 = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i7139 = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i7145 = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i7151 = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i7157 = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i7163 = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i7169 = mul nsw i64 %arg.shape.1, 18
  %factor.op.mul631.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.idx.i7186 = shl i64 %arg.lane.1.5.1, 4
  %293 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx.i7186
  %.idx620.i = mul i64 %arg.lane.0.5.1, 40
  %294 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx620.i
  %.idx621.i = mul i64 %arg.lane.0.5.1, 48
  %295 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx621.i
  %.idx622.i = mul i64 %arg.lane.0.5.1, 56
  %296 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx622.i
  %.917628.not.i = icmp slt i64 %arg.shape.1, 1
  %.993.i = mul nsw i64 %arg.shape.1, 17
  %297 = add i64 %arg.times.5.0, -1
  %.155.i.i7198 = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i7204 = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i7210 = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i7216 = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i7222 = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i7228 = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i7234 = mul nsw i64 %arg.shape.1, 18
  %.4654 = getelementptr i8, ptr %arg.code.4, i64 96
  %.idx7052 = mul i64 %arg.lane.0.5.1, 96
  %298 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7052
  %.idx7053 = mul i64 %arg.lane.0.5.1, 40
  %299 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7053
  %.idx7054 = mul i64 %arg.lane.0.5.1, 120
  %300 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7054
  %301 = getelementptr double, ptr %arg.times.4, i64 %arg.times.5.0
  %.449.i1724 = getelementptr i8, ptr %301, i64 -8
  %.idx7055 = mul i64 %arg.lane.1.5.1, 24
  %302 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx7055
  %.idx7056 = mul i64 %arg.lane.1.5.1, 24
  %303 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx7056
  %.idx7057 = mul i64 %arg.lane.0.5.1, 24
  %304 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7057
  %.4751.not = icmp eq i64 %arg.jumping, 0
  %.idx1848.i = mul i64 %arg.lane.0.5.1, 40
  %305 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1848.i
  %.idx1849.i = shl i64 %arg.lane.0.5.1, 4
  %306 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1849.i
  %307 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.7511852.not.i = icmp slt i64 %arg.schedule.2.5.0, 1
  %.852.i = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1017.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.1160.i = getelementptr i8, ptr %arg.code.4, i64 32
  %.1231.i7251 = mul nsw i64 %arg.shape.1, 17
  %.1233.i7252 = mul nsw i64 %.1231.i7251, %arg.shape.0
  %.1276.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.1233.i7252
  %.idx1846.i = shl i64 %arg.lane.1.5.1, 4
  %308 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1846.i
  %.17571859.not.i = icmp slt i64 %arg.shape.1, 1
  %.1952.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.2041.not.i = icmp eq i64 %arg.guarded, 0
  %.2073.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx = mul i64 %arg.lane.0.5.1, 40
  %309 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx
  %.idx7043 = shl i64 %arg.lane.0.5.1, 4
  %310 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7043
  %311 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.idx7044 = mul i64 %arg.lane.0.5.1, 24
  %312 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7044
  %.1103.i7515.not = icmp slt i64 %arg.schedule.2.5.0, 1
  %.1256.i = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.idx7047 = shl i64 %arg.lane.1.5.1, 4
  %313 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx7047
  %.373.i7263 = getelementptr i8, ptr %arg.lane.2.4, i64 8
  %314 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.6961437.not.i7394 = icmp slt i64 %arg.shape.1, 1
  %.851.i7402 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.9661440.not.i7268 = icmp slt i64 %arg.shape.2, 1
  %.11851443.not.i7285 = icmp slt i64 %arg.schedule.2.5.0, 1
  %.1319.i7290 = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1423.i7309 = icmp sgt i64 %arg.shape.0, 1
  %.163.i1446.not.i7312 = icmp slt i64 %arg.shape.1, 1
  %315 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1426.i7329 = shl i64 %arg.lane.0.5.1, 4
  %316 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1426.i7329
  %.idx1427.i7331 = mul i64 %arg.lane.0.5.1, 24
  %317 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1427.i7331
  %.idx1428.i7333 = shl i64 %arg.lane.0.5.1, 5
  %318 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1428.i7333
  %.15851449.not.i7336 = icmp slt i64 %arg.shape.1, 1
  %.idx1431.i7368 = shl i64 %arg.lane.0.5.1, 4
  %319 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1431.i7368
  %320 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1432.i7371 = mul i64 %arg.lane.0.5.1, 24
  %321 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1432.i7371
  %.idx1433.i7373 = shl i64 %arg.lane.0.5.1, 5
  %322 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1433.i7373
  %.idx1434.i7375 = mul i64 %arg.lane.0.5.1, 120
  %323 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1434.i7375
  %.idx1435.i7378 = mul i64 %arg.lane.1.5.1, 24
  %324 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1435.i7378
  %.idx1436.i7380 = mul i64 %arg.lane.0.5.1, 144
  %325 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1436.i7380
  %.idx7046 = mul i64 %arg.lane.0.5.1, 144
  %326 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7046
  %.5887 = tail call i64 @llvm.smin.i64(i64 %arg.times.5.0, i64 0)
  %327 = getelementptr double, ptr %arg.times.4, i64 %arg.times.5.0
  %328 = getelementptr i8, ptr %327, i64 -8
  %.5901 = getelementptr double, ptr %328, i64 %.5887
  %329 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.163.i22937518.not = icmp slt i64 %arg.shape.1, 1
  %330 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx7049 = shl i64 %arg.lane.0.5.1, 4
  %331 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7049
  %.idx7050 = mul i64 %arg.lane.0.5.1, 24
  %332 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7050
  %.idx7051 = shl i64 %arg.lane.0.5.1, 5
  %333 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7051
  %334 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %335 = shl i64 %334, 3
  %336 = shl i64 %arg.runs.0.5.1, 3
  %337 = mul i64 %arg.shape.1, -176
  %338 = mul i64 %arg.shape.1, -168
  %339 = mul i64 %arg.shape.1, -160
  %340 = mul i64 %arg.shape.1, -152
  %341 = mul i64 %arg.shape.1, -144
  %342 = mul i64 %arg.shape.1, -136
  %343 = mul i64 %arg.shape.1, -128
  %344 = mul i64 %arg.shape.1, -176
  %345 = mul i64 %arg.shape.1, -168
  %346 = mul i64 %arg.shape.1, -160
  %347 = mul i64 %arg.shape.1, -152
  %348 = mul i64 %arg.shape.1, -144
  %349 = mul i64 %arg.shape.1, -136
  %350 = mul i64 %arg.shape.1, -128
  %351 = add i64 %.idx2424.i, %arg.arrays.0.47660
  %352 = tail call i64 @llvm.smax.i64(i64 %.538.i.i, i64 1)
  %353 = mul i64 %arg.shape.1, -48
  %min.iters.check7686 = icmp ult i64 %arg.shape.1, 4
  %diff.check7680 = icmp ult i64 %353, 32
  %diff.check7681 = icmp ult i64 %.1807.i.idx.i, 32
  %conflict.rdx7682 = or i1 %diff.check7680, %diff.check7681
  %diff.check7683 = icmp ult i64 %.idx2422.i, 32
  %conflict.rdx7684 = or i1 %conflict.rdx7682, %diff.check7683
  %n.vec7689 = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n7696 = icmp eq i64 %arg.shape.1, %n.vec7689
  %min.iters.check7664 = icmp slt i64 %.538.i.i, 4
  %n.vec7667 = and i64 %352, 9223372036854775804
  %354 = sub nsw i64 %storemerge2359.i, %n.vec7667
  %cmp.n7676 = icmp eq i64 %352, %n.vec7667
  %min.iters.check7645 = icmp ult i64 %arg.shape.1, 4
  %diff.check7643 = icmp ult i64 %.idx2424.i, 32
  %or.cond7700 = or i1 %min.iters.check7645, %diff.check7643
  %n.vec7648 = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n7657 = icmp eq i64 %arg.shape.1, %n.vec7648
  %355 = getelementptr i8, ptr %arg.code.4, i64 208
  %.4187.idx = mul i64 %.382, 112
  %.4187 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4187.idx
  %356 = getelementptr i8, ptr %arg.code.4, i64 216
  %.4187.1.idx = mul i64 %.382, 120
  %.4187.1 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4187.1.idx
  %357 = getelementptr i8, ptr %arg.code.4, i64 224
  %.4187.2.idx = shl i64 %.382, 7
  %.4187.2 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4187.2.idx
  %min.iters.check7620 = icmp ne i64 %arg.shape.1, 1
  %ident.check7602.not = icmp eq i64 %arg.shape.0, 1
  %or.cond7701 = and i1 %min.iters.check7620, %ident.check7602.not
  %diff.check7604 = icmp eq i64 %344, 0
  %diff.check7605 = icmp ult i64 %345, 16
  %conflict.rdx7606 = or i1 %diff.check7604, %diff.check7605
  %diff.check7607 = icmp eq i64 %346, 0
  %conflict.rdx7608 = or i1 %conflict.rdx7606, %diff.check7607
  %diff.check7609 = icmp ult i64 %347, 16
  %conflict.rdx7610 = or i1 %conflict.rdx7608, %diff.check7609
  %diff.check7611 = icmp eq i64 %348, 0
  %conflict.rdx7612 = or i1 %conflict.rdx7610, %diff.check7611
  %diff.check7613 = icmp ult i64 %349, 16
  %conflict.rdx7614 = or i1 %conflict.rdx7612, %diff.check7613
  %diff.check7615 = icmp eq i64 %350, 0
  %conflict.rdx7616 = or i1 %conflict.rdx7614, %diff.check7615
  %.mask = and i64 %arg.shape.1, 1152921504606846975
  %diff.check7617 = icmp eq i64 %.mask, 0
  %conflict.rdx7618 = or i1 %conflict.rdx7616, %diff.check7617
  %n.vec7623 = and i64 %arg.shape.1, 9223372036854775806
  %cmp.n7640 = icmp eq i64 %arg.shape.1, %n.vec7623
  %min.iters.check7581 = icmp ne i64 %arg.shape.1, 1
  %ident.check.not = icmp eq i64 %arg.shape.0, 1
  %or.cond7702 = and i1 %min.iters.check7581, %ident.check.not
  %diff.check7566 = icmp eq i64 %337, 0
  %diff.check7567 = icmp ult i64 %338, 16
  %conflict.rdx = or i1 %diff.check7566, %diff.check7567
  %diff.check7568 = icmp eq i64 %339, 0
  %conflict.rdx7569 = or i1 %conflict.rdx, %diff.check7568
  %diff.check7570 = icmp ult i64 %340, 16
  %conflict.rdx7571 = or i1 %conflict.rdx7569, %diff.check7570
  %diff.check7572 = icmp eq i64 %341, 0
  %conflict.rdx7573 = or i1 %conflict.rdx7571, %diff.check7572
  %diff.check7574 = icmp ult i64 %342, 16
  %conflict.rdx7575 = or i1 %conflict.rdx7573, %diff.check7574
  %diff.check7576 = icmp eq i64 %343, 0
  %conflict.rdx7577 = or i1 %conflict.rdx7575, %diff.check7576
  %.mask7698 = and i64 %arg.shape.1, 1152921504606846975
  %diff.check7578 = icmp eq i64 %.mask7698, 0
  %conflict.rdx7579 = or i1 %conflict.rdx7577, %diff.check7578
  %n.vec7584 = and i64 %arg.shape.1, 9223372036854775806
  %cmp.n7599 = icmp eq i64 %arg.shape.1, %n.vec7584
  %brmerge7530 = or i1 %.4751.not, %.274.i
  %min.iters.check7553 = icmp ult i64 %arg.shape.1, 8
  %n.vec7556 = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n7563 = icmp eq i64 %arg.shape.1, %n.vec7556
  br label %B276

B1276.if:                                         ; preds = %B1276.if.preheader, %B1500
  %.1791.07434 = phi i64 [ %.1860, %B1500 ], [ 1, %B1276.if.preheader ]
  %.1860 = add nsw i64 %.1791.07434, 1
  %358 = getelementptr i64, ptr %arg.code.4, i64 %.1791.07434
  %359 = getelementptr i8, ptr %358, i64 104
  %.1919 = load i64, ptr %359, align 8
  %.1964 = inttoptr i64 %.1919 to ptr
  tail call void %.1964(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.1995 = load i64, ptr %arg.code.4, align 8
  %.2001 = mul nsw i64 %.1860, %.382
  %.2045 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2001
  %.2046 = inttoptr i64 %.1995 to ptr
  tail call void %.2046(ptr %.490, ptr %.2020, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.2045)
  br i1 %.539, label %B1464, label %B1500

B1616.if:                                         ; preds = %B1502, %B4108
  %doubted.2.17442 = phi i1 [ %doubted.3.2, %B4108 ], [ false, %B1502 ]
  %within.3.17441 = phi i1 [ %within.4.2, %B4108 ], [ false, %B1502 ]
  %wanted.2.17440 = phi i1 [ %wanted.3.2, %B4108 ], [ false, %B1502 ]
  %good.2.17439 = phi i1 [ %good.3.2, %B4108 ], [ false, %B1502 ]
  %.2218.07438 = phi i64 [ %.2281, %B4108 ], [ %storemerge, %B1502 ]
  %.2215.07437 = phi i64 [ %.2285, %B4108 ], [ 0, %B1502 ]
  %.2281 = add nsw i64 %.2218.07438, -1
  %.2285 = add nsw i64 %.2215.07437, 1
  %.2382 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2215.07437
  %.2383 = load i64, ptr %.2382, align 8
  %.2437 = getelementptr i64, ptr %273, i64 %.2215.07437
  %.2438 = load i64, ptr %.2437, align 8
  %.2446 = icmp sgt i64 %.2383, -1
  br i1 %.2446, label %B1694, label %B4108

B2688.if:                                         ; preds = %B2620
  %.4062 = load i64, ptr %355, align 8
  %.4107 = inttoptr i64 %.4062 to ptr
  tail call void %.4107(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4138 = load i64, ptr %arg.code.4, align 8
  %.4188 = inttoptr i64 %.4138 to ptr
  tail call void %.4188(ptr %.490, ptr %.4162, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.4187)
  %.4062.1 = load i64, ptr %356, align 8
  %.4107.1 = inttoptr i64 %.4062.1 to ptr
  tail call void %.4107.1(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4138.1 = load i64, ptr %arg.code.4, align 8
  %.4188.1 = inttoptr i64 %.4138.1 to ptr
  tail call void %.4188.1(ptr %.490, ptr %.4162, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.4187.1)
  %.4062.2 = load i64, ptr %357, align 8
  %.4107.2 = inttoptr i64 %.4062.2 to ptr
  tail call void %.4107.2(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4138.2 = load i64, ptr %arg.code.4, align 8
  %.4188.2 = inttoptr i64 %.4138.2 to ptr
  tail call void %.4188.2(ptr %.490, ptr %.4162, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.4187.2)
  %.4225 = load i64, ptr %.4224, align 8
  %.4270 = inttoptr i64 %.4225 to ptr
  tail call void %.4270(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B2958

B3362.if:                                         ; preds = %B3330, %B4107
  %active.3.27525 = phi i64 [ %active.5.2, %B4107 ], [ %active.4.0, %B3330 ]
  %budget.4.27524 = phi i64 [ %budget.5.2, %B4107 ], [ %.688, %B3330 ]
  %.4901.07523 = phi i64 [ %.4964, %B4107 ], [ %storemerge, %B3330 ]
  %.4898.07522 = phi i64 [ %.4968, %B4107 ], [ 0, %B3330 ]
  %.4964 = add nsw i64 %.4901.07523, -1
  %.4968 = add nsw i64 %.4898.07522, 1
  %.5049 = getelementptr i64, ptr %arg.lane.1.4, i64 %.4898.07522
  %.5050 = load i64, ptr %.5049, align 8
  %.5055 = icmp slt i64 %.5050, 0
  br i1 %.5055, label %B3408, label %B3448
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare <2 x double> @llvm.fabs.v2f64(<2 x double>)

define dso_local range(i32 0, 2) i32 @advance_fixed(ptr noalias %retptr, ptr noalias %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, double %arg.step, ptr readnone %arg.runs.0.0, ptr readnone %arg.runs.0.1, i64 %arg.runs.0.2, i64 %arg.runs.0.3, ptr readonly %arg.runs.0.4, i64 %arg.runs.0.5.0, i64 %arg.runs.0.5.1, i64 %arg.runs.0.6.0, i64 %arg.runs.0.6.1, ptr readnone %arg.runs.1.0, ptr readnone %arg.runs.1.1, i64 %arg.runs.1.2, i64 %arg.runs.1.3, ptr readonly %arg.runs.1.4, i64 %arg.runs.1.5.0, i64 %arg.runs.1.5.1, i64 %arg.runs.1.6.0, i64 %arg.runs.1.6.1, ptr readnone %arg.runs.2.0, ptr readnone %arg.runs.2.1, i64 %arg.runs.2.2, i64 %arg.runs.2.3, ptr readonly %arg.runs.2.4, i64 %arg.runs.2.5.0, i64 %arg.runs.2.6.0, ptr readnone %arg.schedule.0.0, ptr readnone %arg.schedule.0.1, i64 %arg.schedule.0.2, i64 %arg.schedule.0.3, ptr readonly %arg.schedule.0.4, i64 %arg.schedule.0.5.0, i64 %arg.schedule.0.5.1, i64 %arg.schedule.0.6.0, i64 %arg.schedule.0.6.1, ptr readnone %arg.schedule.1.0, ptr readnone %arg.schedule.1.1, i64 %arg.schedule.1.2, i64 %arg.schedule.1.3, ptr readnone %arg.schedule.1.4, i64 %arg.schedule.1.5.0, i64 %arg.schedule.1.6.0, ptr readnone %arg.schedule.2.0, ptr readnone %arg.schedule.2.1, i64 %arg.schedule.2.2, i64 %arg.schedule.2.3, ptr readonly %arg.schedule.2.4, i64 %arg.schedule.2.5.0, i64 %arg.schedule.2.6.0, ptr readnone %arg.schedule.3.0, ptr readnone %arg.schedule.3.1, i64 %arg.schedule.3.2, i64 %arg.schedule.3.3, ptr readonly %arg.schedule.3.4, i64 %arg.schedule.3.5.0, i64 %arg.schedule.3.5.1, i64 %arg.schedule.3.5.2, i64 %arg.schedule.3.6.0, i64 %arg.schedule.3.6.1, i64 %arg.schedule.3.6.2, ptr readnone %arg.schedule.4.0, ptr readnone %arg.schedule.4.1, i64 %arg.schedule.4.2, i64 %arg.schedule.4.3, ptr readnone %arg.schedule.4.4, i64 %arg.schedule.4.5.0, i64 %arg.schedule.4.5.1, i64 %arg.schedule.4.6.0, i64 %arg.schedule.4.6.1, ptr readnone %arg.times.0, ptr readnone %arg.times.1, i64 %arg.times.2, i64 %arg.times.3, ptr readonly %arg.times.4, i64 %arg.times.5.0, i64 %arg.times.6.0, ptr readnone %arg.results.0.0, ptr readnone %arg.results.0.1, i64 %arg.results.0.2, i64 %arg.results.0.3, ptr %arg.results.0.4, i64 %arg.results.0.5.0, i64 %arg.results.0.5.1, i64 %arg.results.0.5.2, i64 %arg.results.0.6.0, i64 %arg.results.0.6.1, i64 %arg.results.0.6.2, ptr readnone %arg.results.1.0, ptr readnone %arg.results.1.1, i64 %arg.results.1.2, i64 %arg.results.1.3, ptr %arg.results.1.4, i64 %arg.results.1.5.0, i64 %arg.results.1.6.0, ptr readnone %arg.results.2.0, ptr readnone %arg.results.2.1, i64 %arg.results.2.2, i64 %arg.results.2.3, ptr %arg.results.2.4, i64 %arg.results.2.5.0, i64 %arg.results.2.6.0, ptr readnone %arg.results.3.0, ptr readnone %arg.results.3.1, i64 %arg.results.3.2, i64 %arg.results.3.3, ptr %arg.results.3.4, i64 %arg.results.3.5.0, i64 %arg.results.3.5.1, i64 %arg.results.3.6.0, i64 %arg.results.3.6.1, ptr readnone %arg.lane.0.0, ptr readnone %arg.lane.0.1, i64 %arg.lane.0.2, i64 %arg.lane.0.3, ptr %arg.lane.0.4, i64 %arg.lane.0.5.0, i64 %arg.lane.0.5.1, i64 %arg.lane.0.6.0, i64 %arg.lane.0.6.1, ptr readnone %arg.lane.1.0, ptr readnone %arg.lane.1.1, i64 %arg.lane.1.2, i64 %arg.lane.1.3, ptr %arg.lane.1.4, i64 %arg.lane.1.5.0, i64 %arg.lane.1.5.1, i64 %arg.lane.1.6.0, i64 %arg.lane.1.6.1, ptr readnone %arg.lane.2.0, ptr readnone %arg.lane.2.1, i64 %arg.lane.2.2, i64 %arg.lane.2.3, ptr readnone %arg.lane.2.4, i64 %arg.lane.2.5.0, i64 %arg.lane.2.6.0, ptr readnone %arg.arrays.0.0, ptr readnone %arg.arrays.0.1, i64 %arg.arrays.0.2, i64 %arg.arrays.0.3, ptr %arg.arrays.0.4, i64 %arg.arrays.0.5.0, i64 %arg.arrays.0.6.0, ptr readnone %arg.arrays.1.0, ptr readnone %arg.arrays.1.1, i64 %arg.arrays.1.2, i64 %arg.arrays.1.3, ptr %arg.arrays.1.4, i64 %arg.arrays.1.5.0, i64 %arg.arrays.1.6.0, ptr readnone %arg.arrays.2.0, ptr readnone %arg.arrays.2.1, i64 %arg.arrays.2.2, i64 %arg.arrays.2.3, ptr %arg.arrays.2.4, i64 %arg.arrays.2.5.0, i64 %arg.arrays.2.6.0, ptr readnone %arg.arrays.3.0, ptr readnone %arg.arrays.3.1, i64 %arg.arrays.3.2, i64 %arg.arrays.3.3, ptr %arg.arrays.3.4, i64 %arg.arrays.3.5.0, i64 %arg.arrays.3.6.0, ptr readnone %arg.arrays.4.0, ptr readnone %arg.arrays.4.1, i64 %arg.arrays.4.2, i64 %arg.arrays.4.3, ptr %arg.arrays.4.4, i64 %arg.arrays.4.5.0, i64 %arg.arrays.4.6.0, i64 %arg.guarded, i64 %arg.jumping, i64 %arg.held, i64 %arg.decided) local_unnamed_addr {
entry:
  %arg.arrays.0.44803 = ptrtoint ptr %arg.arrays.0.4 to i64
  %arg.results.0.44802 = ptrtoint ptr %arg.results.0.4 to i64
  %.428 = icmp sgt i64 %arg.runs.0.5.0, 0
  %.431 = icmp eq i64 %arg.shape.0, 0
  br i1 %.431, label %B0.if, label %B0.endif, !prof !36

B148.loopexit:                                    ; preds = %B1706, %B1576
  %.473 = icmp sgt i64 %.417.14768, 0
  %.486 = select i1 %.473, i64 %arg.shape.0, i64 0
  %.414.1 = add i64 %.486, %.414.14767
  %.482 = sext i1 %.473 to i64
  %.417.1 = add nsw i64 %.417.14768, %.482
  %.463.sroa.0.0 = select i1 %.473, i64 %.414.14767, i64 0
  br i1 %.473, label %B152, label %B1712

B152:                                             ; preds = %B152.lr.ph, %B148.loopexit
  %.463.sroa.0.04769 = phi i64 [ 0, %B152.lr.ph ], [ %.463.sroa.0.0, %B148.loopexit ]
  %.417.14768 = phi i64 [ %.417.14766, %B152.lr.ph ], [ %.417.1, %B148.loopexit ]
  %.414.14767 = phi i64 [ %arg.shape.0, %B152.lr.ph ], [ %.414.1, %B148.loopexit ]
  %.528 = sub i64 %arg.runs.0.5.0, %.463.sroa.0.04769
  %.11.i = tail call i64 @llvm.smin.i64(i64 %.528, i64 %arg.shape.0)
  br i1 %.6414696.not, label %B512, label %B248.if.lr.ph

B248.if.lr.ph:                                    ; preds = %B152
  %.683 = add nsw i64 %.11.i, -1
  br label %B248.if

B410:                                             ; preds = %B366.if, %B248.if
  br i1 %.10764693.not, label %B500, label %B440.if.lr.ph

B440.if.lr.ph:                                    ; preds = %B410
  %.1137 = icmp slt i64 %.714, 0
  %.1138 = select i1 %.1137, i64 %arg.runs.0.5.0, i64 0
  %.1139 = add i64 %.1138, %.714
  %.1159 = mul i64 %.1139, %arg.runs.0.5.1
  %0 = getelementptr double, ptr %arg.runs.0.4, i64 %.1159
  %.1236 = select i1 %.1137, i64 %arg.results.0.5.0, i64 0
  %.1237 = add i64 %.1236, %.714
  %.1267 = mul i64 %.1265, %.1237
  %1 = getelementptr double, ptr %arg.results.0.4, i64 %.1267
  %invariant.gep4975 = getelementptr double, ptr %arg.arrays.0.4, i64 %.585.04697
  br label %B440.if

B500:                                             ; preds = %B440.if, %B410
  %.1296 = icmp slt i64 %.714, 0
  %.1297 = select i1 %.1296, i64 %arg.results.2.5.0, i64 0
  %2 = getelementptr i64, ptr %arg.results.2.4, i64 %.714
  %.1311 = getelementptr i64, ptr %2, i64 %.1297
  store i64 1, ptr %.1311, align 8
  %exitcond4776.not = icmp eq i64 %arg.shape.0, %.654
  br i1 %exitcond4776.not, label %B512, label %B248.if

B512:                                             ; preds = %B500, %B152
  br i1 %.1414, label %B598.preheader, label %B1576

B598.preheader:                                   ; preds = %B512
  %3 = getelementptr i64, ptr %arg.runs.2.4, i64 %.463.sroa.0.04769
  %.1364 = icmp slt i64 %.463.sroa.0.04769, 0
  %.1365 = select i1 %.1364, i64 %arg.runs.2.5.0, i64 0
  %.1379 = getelementptr i64, ptr %3, i64 %.1365
  %.1380 = load i64, ptr %.1379, align 8
  %.1349 = load double, ptr %arg.times.4, align 8
  %.1701 = icmp slt i64 %.1380, 0
  %.1702 = select i1 %.1701, i64 %arg.schedule.3.5.0, i64 0
  %.1703 = add i64 %.1702, %.1380
  %.1733 = mul i64 %.1731, %.1703
  %4 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1733
  %.2405 = icmp slt i64 %.1380, 0
  %.2406 = select i1 %.2405, i64 %arg.schedule.0.5.0, i64 0
  %.2407 = add i64 %.2406, %.1380
  %.2427 = mul i64 %.2407, %arg.schedule.0.5.1
  %5 = getelementptr double, ptr %arg.schedule.0.4, i64 %.2427
  br label %B598

B598:                                             ; preds = %B598.preheader, %B1536
  %t.2.1 = phi double [ %t.3.4, %B1536 ], [ %.1349, %B598.preheader ]
  %done.3.1 = phi i64 [ %done.4.4, %B1536 ], [ 1, %B598.preheader ]
  %edge.2.1 = phi i64 [ %edge.3.4, %B1536 ], [ 0, %B598.preheader ]
  br i1 %.1468, label %B748.else.endif, label %B654.if.lr.ph

B654.if.lr.ph:                                    ; preds = %B598
  %.1704 = icmp slt i64 %edge.2.1, 0
  %.1705 = select i1 %.1704, i64 %arg.schedule.3.5.1, i64 0
  %.1706 = add i64 %.1705, %edge.2.1
  %.1735 = mul i64 %.1706, %arg.schedule.3.5.2
  %6 = getelementptr double, ptr %4, i64 %.1735
  br label %B654.if

B654.loopexit:                                    ; preds = %B688.if, %B654.if
  %.1510 = icmp sgt i64 %.1457.04704, 1
  br i1 %.1510, label %B654.if, label %B748.else.endif

B906:                                             ; preds = %B906.preheader, %B1496
  %t.4.3 = phi double [ %.11.i4679, %B1496 ], [ %t.2.1, %B906.preheader ]
  %done.6.3 = phi i64 [ %done.5.5, %B1496 ], [ %done.3.1, %B906.preheader ]
  %.2364 = icmp slt i64 %done.6.3, 0
  %.2365 = select i1 %.2364, i64 %arg.times.5.0, i64 0
  %7 = getelementptr double, ptr %arg.times.4, i64 %done.6.3
  %.2379 = getelementptr double, ptr %7, i64 %.2365
  %.2380 = load double, ptr %.2379, align 8
  %.2432 = load double, ptr %.2431, align 8
  %.10.i = fcmp olt double %.2432, %.2380
  %.11.i4679 = select i1 %.10.i, double %.2432, double %.2380
  %.2466 = fsub double %.11.i4679, %t.4.3
  %.2471 = fdiv double %.2466, %arg.step
  %.2472 = fmul double %.2471, 0x3FEFFFFFFFFFDCD1
  %.2473 = tail call double @llvm.ceil.f64(double %.2472)
  %.2474 = fptosi double %.2473 to i64
  %.11.i4680 = tail call i64 @llvm.smax.i64(i64 %.2474, i64 1)
  %.2506 = uitofp i64 %.11.i4680 to double
  %.2510 = fdiv double %.2466, %.2506
  br i1 %.2065, label %B0.endif.else.endif.if.i, label %B0.endif.else.endif.endif.i, !prof !36

B1158:                                            ; preds = %B906.endif.endif.endif.endif.endif
  br i1 %.2625.not, label %B1384, label %B1166

B1166:                                            ; preds = %B1158
  %.2678 = load double, ptr %.2431, align 8
  %.2680 = fcmp oeq double %.11.i4679, %.2678
  br i1 %.2680, label %B1194.else.endif, label %B1384

B1384:                                            ; preds = %B1228.i, %B360.i, %.4350.if, %B982.i, %B1166, %B1158
  %.4543 = load double, ptr %.2379, align 8
  %.4545 = fcmp oeq double %.11.i4679, %.4543
  br i1 %.4545, label %B1408, label %B1456

B1408:                                            ; preds = %B1384
  br i1 %.191230.not.i, label %_ZN12clpt_control6native9for_numba4keepB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B60.if.lr.ph.i

B60.if.lr.ph.i:                                   ; preds = %B1408
  %.513.i = select i1 %.2364, i64 %arg.results.0.5.1, i64 0
  %.514.i = add i64 %.513.i, %done.6.3
  %.543.i = mul i64 %.514.i, %arg.results.0.5.2
  %invariant.gep.i = getelementptr double, ptr %arg.results.0.4, i64 %.543.i
  %.557.i = add nsw i64 %done.6.3, 1
  %8 = shl i64 %.514.i, 3
  br label %B60.if.i

B106.i:                                           ; preds = %B60.if.i
  %.322.i = getelementptr i64, ptr %arg.results.1.4, i64 %.286.i
  %.323.i = load i64, ptr %.322.i, align 8, !noalias !147
  %.324.i = icmp eq i64 %.323.i, 0
  br i1 %.324.i, label %B140.i, label %B232.i

B140.i:                                           ; preds = %B106.i
  br i1 %.406226.not.i, label %B216.i, label %B170.if.lr.ph.i

B170.if.lr.ph.i:                                  ; preds = %B140.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul229.i, %.286.i
  %gep.i = getelementptr double, ptr %invariant.gep.i, i64 %factor.op.mul.reass.i
  %invariant.gep4758 = getelementptr double, ptr %arg.arrays.0.4, i64 %.133.0231.i
  br i1 %or.cond4958, label %vector.memcheck, label %B170.if.i.preheader

vector.memcheck:                                  ; preds = %B170.if.lr.ph.i
  %9 = mul i64 %35, %.286.i
  %10 = add i64 %8, %9
  %11 = mul i64 %arg.results.0.5.2, %10
  %12 = add i64 %20, %11
  %diff.check = icmp ult i64 %12, 32
  br i1 %diff.check, label %B170.if.i.preheader, label %vector.body

vector.body:                                      ; preds = %vector.memcheck, %vector.body
  %index = phi i64 [ %index.next, %vector.body ], [ 0, %vector.memcheck ]
  %13 = getelementptr double, ptr %invariant.gep4758, i64 %index
  %14 = getelementptr i8, ptr %13, i64 16
  %wide.load = load <2 x double>, ptr %13, align 8, !noalias !147
  %wide.load4804 = load <2 x double>, ptr %14, align 8, !noalias !147
  %15 = getelementptr double, ptr %gep.i, i64 %index
  %16 = getelementptr i8, ptr %15, i64 16
  store <2 x double> %wide.load, ptr %15, align 8, !noalias !147
  store <2 x double> %wide.load4804, ptr %16, align 8, !noalias !147
  %index.next = add i64 %index, 4
  %17 = icmp eq i64 %index.next, %n.vec
  br i1 %17, label %middle.block, label %vector.body, !llvm.loop !150

middle.block:                                     ; preds = %vector.body
  br i1 %cmp.n, label %B216.i, label %B170.if.i.preheader

B170.if.i.preheader:                              ; preds = %vector.memcheck, %B170.if.lr.ph.i, %middle.block
  %.350.0227.i.ph = phi i64 [ 0, %vector.memcheck ], [ 0, %B170.if.lr.ph.i ], [ %n.vec, %middle.block ]
  br label %B170.if.i

B216.i:                                           ; preds = %B170.if.i, %middle.block, %B140.i
  %.587.i = getelementptr i64, ptr %arg.results.2.4, i64 %.286.i
  store i64 %.557.i, ptr %.587.i, align 8, !noalias !147
  br label %B232.i

B232.i:                                           ; preds = %B60.if.i, %B216.i, %B106.i
  %exitcond233.not.i = icmp eq i64 %arg.shape.0, %.204.i
  br i1 %exitcond233.not.i, label %_ZN12clpt_control6native9for_numba4keepB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B60.if.i

B60.if.i:                                         ; preds = %B232.i, %B60.if.lr.ph.i
  %.133.0231.i = phi i64 [ 0, %B60.if.lr.ph.i ], [ %.204.i, %B232.i ]
  %18 = shl i64 %.133.0231.i, 3
  %19 = add i64 %18, %arg.arrays.0.44803
  %20 = sub i64 %arg.results.0.44802, %19
  %.204.i = add nsw i64 %.133.0231.i, 1
  %21 = getelementptr i64, ptr %arg.lane.1.4, i64 %.133.0231.i
  %.286.i = load i64, ptr %21, align 8, !noalias !147
  %.291.i = icmp sgt i64 %.286.i, -1
  br i1 %.291.i, label %B106.i, label %B232.i

B170.if.i:                                        ; preds = %B170.if.i.preheader, %B170.if.i
  %.350.0227.i = phi i64 [ %.419.i, %B170.if.i ], [ %.350.0227.i.ph, %B170.if.i.preheader ]
  %.419.i = add nsw i64 %.350.0227.i, 1
  %.445.i = mul nsw i64 %.350.0227.i, %arg.shape.0
  %gep4759 = getelementptr double, ptr %invariant.gep4758, i64 %.445.i
  %.477.i = load double, ptr %gep4759, align 8, !noalias !147
  %22 = getelementptr double, ptr %gep.i, i64 %.350.0227.i
  store double %.477.i, ptr %22, align 8, !noalias !147
  %exitcond.not.i = icmp eq i64 %arg.shape.1, %.419.i
  br i1 %exitcond.not.i, label %B216.i, label %B170.if.i, !llvm.loop !151

_ZN12clpt_control6native9for_numba4keepB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B232.i, %B1408
  %.4603 = add nsw i64 %done.6.3, 1
  br label %B1456

B1456:                                            ; preds = %_ZN12clpt_control6native9for_numba4keepB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B1384
  %done.5.5 = phi i64 [ %.4603, %_ZN12clpt_control6native9for_numba4keepB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %done.6.3, %B1384 ]
  %.4662 = load double, ptr %.2431, align 8
  %.4664 = fcmp oeq double %.11.i4679, %.4662
  br i1 %.4664, label %B1484, label %B1496

B1484:                                            ; preds = %B1456
  %.4677 = add nsw i64 %edge.2.1, 1
  br label %B1536

B1496:                                            ; preds = %B1456
  %.4711 = icmp slt i64 %done.5.5, %arg.times.5.0
  br i1 %.4711, label %B906, label %B1536

B1536:                                            ; preds = %B906.endif.endif.endif.endif.endif, %B1496, %.2131.if, %B1484
  %t.3.4 = phi double [ %t.2.1, %.2131.if ], [ %.11.i4679, %B1484 ], [ %.11.i4679, %B1496 ], [ %t.4.3, %B906.endif.endif.endif.endif.endif ]
  %done.4.4 = phi i64 [ %done.3.1, %.2131.if ], [ %done.5.5, %B1484 ], [ %done.5.5, %B1496 ], [ %arg.times.5.0, %B906.endif.endif.endif.endif.endif ]
  %edge.3.4 = phi i64 [ %edge.2.1, %.2131.if ], [ %.4677, %B1484 ], [ %edge.2.1, %B1496 ], [ %edge.2.1, %B906.endif.endif.endif.endif.endif ]
  %.4751 = icmp slt i64 %done.4.4, %arg.times.5.0
  br i1 %.4751, label %B598, label %B1576

B1576:                                            ; preds = %B1536, %B512
  %edge.4.2 = phi i64 [ 0, %B512 ], [ %edge.3.4, %B1536 ]
  %.48504760.not = icmp slt i64 %.11.i, 1
  br i1 %.48504760.not, label %B148.loopexit, label %B1606.if

B1680:                                            ; preds = %B1606.if
  store i64 1, ptr %.4980, align 8
  br label %B1706

B1706:                                            ; preds = %B1680, %B1606.if
  %exitcond4798.not = icmp eq i64 %.11.i, %.4863
  br i1 %exitcond4798.not, label %B148.loopexit, label %B1606.if

common.ret:                                       ; preds = %B0.if, %B1712
  %common.ret.op = phi i32 [ 0, %B1712 ], [ 1, %B0.if ]
  ret i32 %common.ret.op

B1712:                                            ; preds = %B148.loopexit, %B0.endif.endif
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B0.if:                                            ; preds = %entry
  store ptr @.const.picklebuf.ca8efb3a72d614fe872032cce3ac326007a30727, ptr %excinfo, align 8, !numba_exception_output !152
  br label %common.ret

B0.endif:                                         ; preds = %entry
  %.429 = icmp sgt i64 %arg.shape.0, 0
  %.430 = xor i1 %.429, %.428
  br i1 %.430, label %B0.endif.endif, label %B0.endif.else

B0.endif.else:                                    ; preds = %B0.endif
  %.445 = srem i64 %arg.runs.0.5.0, %arg.shape.0
  %.446 = sub nsw i64 0, %.445
  %.447 = select i1 %.428, i64 %.445, i64 %.446
  %.448 = icmp sgt i64 %.447, 0
  %.449 = sdiv i64 %arg.runs.0.5.0, %arg.shape.0
  %.450 = zext i1 %.448 to i64
  %.451 = add i64 %.449, %.450
  br label %B0.endif.endif

B0.endif.endif:                                   ; preds = %B0.endif, %B0.endif.else
  %storemerge = phi i64 [ %.451, %B0.endif.else ], [ 0, %B0.endif ]
  %.4734763 = icmp sgt i64 %storemerge, 0
  br i1 %.4734763, label %B152.lr.ph, label %B1712

B152.lr.ph:                                       ; preds = %B0.endif.endif
  %.417.14766 = add nsw i64 %storemerge, -1
  %.6414696.not = icmp slt i64 %arg.shape.0, 1
  %.8684690.not = icmp slt i64 %arg.shape.2, 1
  %.10764693.not = icmp slt i64 %arg.shape.1, 1
  %.1265 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.1414 = icmp sgt i64 %arg.times.5.0, 1
  %.1468 = icmp slt i64 %arg.schedule.2.5.0, 1
  %storemerge4657 = select i1 %.1468, i64 0, i64 %arg.schedule.2.5.0
  %.2065 = icmp slt i64 %arg.lane.0.5.1, 1
  %.2211 = getelementptr i8, ptr %arg.code.4, i64 8
  %.16314699.not = icmp slt i64 %arg.shape.0, 1
  %.1731 = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.223.i = mul i64 %arg.shape.1, %arg.shape.0
  %.331.i.idx = shl i64 %arg.lane.0.5.1, 6
  %.331.i = getelementptr i8, ptr %arg.lane.0.4, i64 %.331.i.idx
  %.idx4659 = shl i64 %arg.lane.0.5.1, 4
  %23 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx4659
  %.1621.i4713.not = icmp slt i64 %.223.i, 1
  %.1728.i = icmp sgt i64 %arg.decided, 0
  %.idx4661 = mul i64 %arg.lane.0.5.1, 24
  %24 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx4661
  %.149.i.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.279.i.i4721.not = icmp slt i64 %arg.shape.0, 1
  %.idx4672 = mul i64 %arg.lane.0.5.1, 24
  %25 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx4672
  %.457.i.i4718 = icmp slt i64 %arg.decided, 1
  %.2204.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.223.i
  %.149.i154.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.169.i.i.idx = mul i64 %.223.i, 136
  %.169.i.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.169.i.i.idx
  %.279.i211.i4727.not = icmp slt i64 %arg.shape.0, 1
  %.idx4671 = mul i64 %arg.lane.0.5.1, 24
  %26 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx4671
  %.457.i354.i4724 = icmp slt i64 %arg.decided, 1
  %.2522.i.idx = mul i64 %.223.i, 136
  %.2522.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.2522.i.idx
  %.2584.i = getelementptr i8, ptr %arg.code.4, i64 256
  %.2633.i.not = icmp eq i64 %arg.guarded, 0
  %.2663.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.2795.i4736.not = icmp slt i64 %arg.shape.0, 1
  %.3250.i4732.not = icmp slt i64 %arg.shape.1, 1
  %.idx = mul i64 %arg.lane.0.5.1, 48
  %27 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx
  %.3568.i = icmp ne i64 %arg.shape.0, 1
  %.3652.i4743.not4772 = icmp slt i64 %arg.shape.1, 1
  %.2625.not = icmp eq i64 %arg.jumping, 0
  %.idx4665 = shl i64 %arg.lane.0.5.1, 4
  %28 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx4665
  %.idx4666 = mul i64 %arg.lane.0.5.1, 40
  %29 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx4666
  %.3941 = icmp slt i64 %arg.lane.1.5.1, 1
  %30 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.idx4667 = shl i64 %arg.lane.1.5.1, 4
  %.4101855.not.i = icmp slt i64 %arg.shape.0, 1
  %.idx1848.i = mul i64 %arg.lane.0.5.1, 40
  %31 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1848.i
  %.idx1849.i = shl i64 %arg.lane.0.5.1, 4
  %32 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1849.i
  %33 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.852.i4683 = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1160.i = getelementptr i8, ptr %arg.code.4, i64 32
  %.1231.i = mul nsw i64 %arg.shape.1, 17
  %.1233.i = mul nsw i64 %.1231.i, %arg.shape.0
  %.1276.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.1233.i
  %.idx1846.i = shl i64 %arg.lane.1.5.1, 4
  %34 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1846.i
  %.17571859.not.i = icmp slt i64 %arg.shape.1, 1
  %.1952.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.2041.not.i = icmp eq i64 %arg.guarded, 0
  %.2073.i = getelementptr i8, ptr %arg.code.4, i64 16
  %factor.op.mul229.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.191230.not.i = icmp slt i64 %arg.shape.0, 1
  %.406226.not.i = icmp slt i64 %arg.shape.1, 1
  %scevgep = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx4667
  %35 = shl i64 %arg.results.0.5.1, 3
  %36 = shl i64 %arg.shape.1, 3
  %scevgep4857 = getelementptr i8, ptr %arg.arrays.0.4, i64 %36
  %37 = mul i64 %arg.shape.1, 144
  %scevgep4858 = getelementptr i8, ptr %arg.arrays.0.4, i64 %37
  %38 = mul i64 %arg.shape.1, 152
  %scevgep4859 = getelementptr i8, ptr %arg.arrays.0.4, i64 %38
  %39 = mul i64 %arg.shape.1, %arg.shape.0
  %40 = mul i64 %39, 144
  %min.iters.check4890 = icmp ult i64 %.223.i, 4
  %diff.check4888 = icmp ult i64 %40, 32
  %or.cond4959 = select i1 %min.iters.check4890, i1 true, i1 %diff.check4888
  %n.vec4893 = and i64 %.223.i, 9223372036854775804
  %41 = mul i64 %.223.i, 144
  %cmp.n4900 = icmp eq i64 %.223.i, %n.vec4893
  %.idx4799 = mul i64 %.223.i, 144
  %invariant.gep4977 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx4799
  %min.iters.check4861 = icmp ult i64 %arg.shape.1, 4
  %bound0 = icmp ult ptr %arg.arrays.0.4, %scevgep4859
  %bound1 = icmp ult ptr %scevgep4858, %scevgep4857
  %found.conflict = and i1 %bound0, %bound1
  %n.vec4864 = and i64 %arg.shape.1, 9223372036854775804
  %42 = mul i64 %arg.shape.1, 144
  %cmp.n4873 = icmp eq i64 %arg.shape.1, %n.vec4864
  %.idx4800 = mul i64 %arg.shape.1, 144
  %invariant.gep4985 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx4800
  %min.iters.check = icmp ugt i64 %arg.shape.1, 9
  %ident.check.not = icmp eq i64 %arg.shape.0, 1
  %or.cond4958 = and i1 %min.iters.check, %ident.check.not
  %n.vec = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n = icmp eq i64 %arg.shape.1, %n.vec
  br label %B152

B248.if:                                          ; preds = %B248.if.lr.ph, %B500
  %.585.04697 = phi i64 [ 0, %B248.if.lr.ph ], [ %.654, %B500 ]
  %.654 = add nsw i64 %.585.04697, 1
  %.11.i4681 = tail call i64 @llvm.smin.i64(i64 %.683, i64 %.585.04697)
  %.714 = add nsw i64 %.11.i4681, %.463.sroa.0.04769
  %.720 = icmp slt i64 %.585.04697, %.11.i
  %"$phi314.2.2.2" = select i1 %.720, i64 %.714, i64 -1
  %43 = getelementptr i64, ptr %arg.lane.1.4, i64 %.585.04697
  store i64 %"$phi314.2.2.2", ptr %43, align 8
  br i1 %.8684690.not, label %B410, label %B366.if.lr.ph

B366.if.lr.ph:                                    ; preds = %B248.if
  %.929 = icmp slt i64 %.714, 0
  %.930 = select i1 %.929, i64 %arg.runs.1.5.0, i64 0
  %.931 = add i64 %.930, %.714
  %.951 = mul i64 %.931, %arg.runs.1.5.1
  %44 = getelementptr double, ptr %arg.runs.1.4, i64 %.951
  %invariant.gep4973 = getelementptr double, ptr %arg.arrays.1.4, i64 %.585.04697
  br label %B366.if

B366.if:                                          ; preds = %B366.if.lr.ph, %B366.if
  %.812.04691 = phi i64 [ 0, %B366.if.lr.ph ], [ %.881, %B366.if ]
  %.881 = add nsw i64 %.812.04691, 1
  %45 = getelementptr double, ptr %44, i64 %.812.04691
  %.956 = load double, ptr %45, align 8
  %.958 = mul nsw i64 %.812.04691, %arg.shape.0
  %gep4974 = getelementptr double, ptr %invariant.gep4973, i64 %.958
  store double %.956, ptr %gep4974, align 8
  %exitcond.not = icmp eq i64 %arg.shape.2, %.881
  br i1 %exitcond.not, label %B410, label %B366.if

B440.if:                                          ; preds = %B440.if.lr.ph, %B440.if
  %.1020.04694 = phi i64 [ 0, %B440.if.lr.ph ], [ %.1089, %B440.if ]
  %.1089 = add nsw i64 %.1020.04694, 1
  %46 = getelementptr double, ptr %0, i64 %.1020.04694
  %.1164 = load double, ptr %46, align 8
  %.1166 = mul nsw i64 %.1020.04694, %arg.shape.0
  %gep4976 = getelementptr double, ptr %invariant.gep4975, i64 %.1166
  store double %.1164, ptr %gep4976, align 8
  %47 = getelementptr double, ptr %1, i64 %.1020.04694
  store double %.1164, ptr %47, align 8
  %exitcond4775.not = icmp eq i64 %arg.shape.1, %.1089
  br i1 %exitcond4775.not, label %B500, label %B440.if

B654.if:                                          ; preds = %B654.if.lr.ph, %B654.loopexit
  %.1457.04704 = phi i64 [ %storemerge4657, %B654.if.lr.ph ], [ %.1519, %B654.loopexit ]
  %.1454.04703 = phi i64 [ 0, %B654.if.lr.ph ], [ %.1523, %B654.loopexit ]
  %.1519 = add nsw i64 %.1457.04704, -1
  %.1523 = add nsw i64 %.1454.04703, 1
  br i1 %.16314699.not, label %B654.loopexit, label %B688.if.lr.ph

B688.if.lr.ph:                                    ; preds = %B654.if
  %48 = getelementptr double, ptr %6, i64 %.1454.04703
  %49 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1454.04703
  br label %B688.if

B688.if:                                          ; preds = %B688.if.lr.ph, %B688.if
  %.1575.04700 = phi i64 [ 0, %B688.if.lr.ph ], [ %.1644, %B688.if ]
  %.1644 = add nsw i64 %.1575.04700, 1
  %.1740 = load double, ptr %48, align 8
  %.1771 = load i64, ptr %49, align 8
  %.1773 = mul nsw i64 %.1771, %arg.shape.0
  %.1774 = add nsw i64 %.1773, %.1575.04700
  %.1788 = icmp slt i64 %.1774, 0
  %.1789 = select i1 %.1788, i64 %arg.arrays.1.5.0, i64 0
  %50 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1774
  %.1803 = getelementptr double, ptr %50, i64 %.1789
  store double %.1740, ptr %.1803, align 8
  %exitcond4777.not = icmp eq i64 %arg.shape.0, %.1644
  br i1 %exitcond4777.not, label %B654.loopexit, label %B688.if

B748.else.endif:                                  ; preds = %B654.loopexit, %B598
  br i1 %.2065, label %B748.endif.else.endif.if, label %B748.endif.else.endif.endif.endif.if, !prof !36

B748.endif.else.endif.if:                         ; preds = %B748.else.endif
  br label %B748.endif.else.endif.endif.endif.if

B748.endif.else.endif.endif.endif.if:             ; preds = %B748.endif.else.endif.if, %B748.else.endif
  %.2037.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %B748.endif.else.endif.if ], [ 0, %B748.else.endif ]
  %.2161.not4705 = icmp slt i64 %.2037.sroa.0.3, %arg.lane.0.5.1
  br i1 %.2161.not4705, label %.2131.endif.preheader, label %.2131.if, !prof !153

.2131.endif.preheader:                            ; preds = %B748.endif.else.endif.endif.endif.if
  %51 = sub i64 %arg.lane.0.5.1, %.2037.sroa.0.3
  %min.iters.check4945 = icmp ult i64 %51, 4
  br i1 %min.iters.check4945, label %.2131.endif.preheader4970, label %vector.ph4946, !prof !154

vector.ph4946:                                    ; preds = %.2131.endif.preheader
  %n.vec4948 = and i64 %51, -4
  %52 = add i64 %.2037.sroa.0.3, %n.vec4948
  %broadcast.splatinsert4949 = insertelement <2 x double> poison, double %t.2.1, i64 0
  %broadcast.splat4950 = shufflevector <2 x double> %broadcast.splatinsert4949, <2 x double> poison, <2 x i32> zeroinitializer
  %53 = getelementptr double, ptr %arg.lane.0.4, i64 %.2037.sroa.0.3
  br label %vector.body4951

vector.body4951:                                  ; preds = %vector.body4951, %vector.ph4946
  %index4952 = phi i64 [ 0, %vector.ph4946 ], [ %index.next4954, %vector.body4951 ]
  %54 = getelementptr double, ptr %53, i64 %index4952
  %55 = getelementptr i8, ptr %54, i64 16
  store <2 x double> %broadcast.splat4950, ptr %54, align 8
  store <2 x double> %broadcast.splat4950, ptr %55, align 8
  %index.next4954 = add i64 %index4952, 4
  %56 = icmp eq i64 %index.next4954, %n.vec4948
  br i1 %56, label %middle.block4955, label %vector.body4951, !prof !155, !llvm.loop !156

middle.block4955:                                 ; preds = %vector.body4951
  %cmp.n4956 = icmp eq i64 %51, %n.vec4948
  br i1 %cmp.n4956, label %.2131.if, label %.2131.endif.preheader4970, !prof !158

.2131.endif.preheader4970:                        ; preds = %.2131.endif.preheader, %middle.block4955
  %.2127.04706.ph = phi i64 [ %.2037.sroa.0.3, %.2131.endif.preheader ], [ %52, %middle.block4955 ]
  br label %.2131.endif

.2131.if:                                         ; preds = %.2131.endif, %middle.block4955, %B748.endif.else.endif.endif.endif.if
  %.2212 = load i64, ptr %.2211, align 8
  %.2324 = inttoptr i64 %.2212 to ptr
  tail call void %.2324(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.2337 = icmp slt i64 %done.3.1, %arg.times.5.0
  br i1 %.2337, label %B906.preheader, label %B1536

B906.preheader:                                   ; preds = %.2131.if
  %.2408 = icmp slt i64 %edge.2.1, 0
  %.2409 = select i1 %.2408, i64 %arg.schedule.0.5.1, i64 0
  %57 = getelementptr double, ptr %5, i64 %edge.2.1
  %.2431 = getelementptr double, ptr %57, i64 %.2409
  %broadcast.splatinsert = insertelement <2 x i64> poison, i64 %edge.2.1, i64 0
  %broadcast.splat = shufflevector <2 x i64> %broadcast.splatinsert, <2 x i64> poison, <2 x i32> zeroinitializer
  br label %B906

.2131.endif:                                      ; preds = %.2131.endif.preheader4970, %.2131.endif
  %.2127.04706 = phi i64 [ %.2175, %.2131.endif ], [ %.2127.04706.ph, %.2131.endif.preheader4970 ]
  %.2170 = getelementptr double, ptr %arg.lane.0.4, i64 %.2127.04706
  store double %t.2.1, ptr %.2170, align 8
  %.2175 = add nsw i64 %.2127.04706, 1
  %exitcond4778.not = icmp eq i64 %.2175, %arg.lane.0.5.1
  br i1 %exitcond4778.not, label %.2131.if, label %.2131.endif, !prof !159, !llvm.loop !160

B358.i:                                           ; preds = %B308.if.i, %middle.block4899, %.1491.if.i
  br i1 %.1728.i, label %B370.else.i, label %B442.i

B442.i:                                           ; preds = %B250.i.i, %B358.i
  %.2158.i = load i64, ptr %arg.code.4, align 8, !noalias !162
  %.2205.i = inttoptr i64 %.2158.i to ptr
  tail call void %.2205.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.2204.i), !noalias !162
  br label %B558.if.i

B648.i:                                           ; preds = %B558.if.i
  %.150.i155.i = load i64, ptr %.149.i154.i, align 8, !noalias !166
  %.195.i174.i = inttoptr i64 %.150.i155.i to ptr
  tail call void %.195.i174.i(ptr %.331.i, ptr %.169.i.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !166
  br i1 %.279.i211.i4727.not, label %B250.i219.i, label %B118.if.i429.i

B248.i313.i:                                      ; preds = %B190.if.i414.i, %B118.if.i429.i
  %exitcond4787.not = icmp eq i64 %arg.shape.0, %.292.i435.i
  br i1 %exitcond4787.not, label %B250.i219.i, label %B118.if.i429.i

B250.i219.i:                                      ; preds = %B248.i313.i, %B648.i
  %.614.i243.i = load i64, ptr %.2211, align 8, !noalias !166
  %.661.i263.i = inttoptr i64 %.614.i243.i to ptr
  tail call void %.661.i263.i(ptr %.331.i, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !166
  br label %B708.i

B118.if.i429.i:                                   ; preds = %B648.i, %B248.i313.i
  %.221.i102.i.04729 = phi i64 [ %.292.i435.i, %B248.i313.i ], [ 0, %B648.i ]
  %.292.i435.i = add nsw i64 %.221.i102.i.04729, 1
  %58 = getelementptr double, ptr %26, i64 %.221.i102.i.04729
  %.374.i311.i = load double, ptr %58, align 8, !noalias !166
  %.375.i312.i = fcmp ule double %.374.i311.i, 5.000000e-01
  %brmerge = select i1 %.375.i312.i, i1 true, i1 %.457.i354.i4724
  br i1 %brmerge, label %B248.i313.i, label %B190.if.i414.i.preheader

B190.if.i414.i.preheader:                         ; preds = %B118.if.i429.i
  %invariant.gep4981 = getelementptr double, ptr %arg.arrays.4.4, i64 %.221.i102.i.04729
  br label %B190.if.i414.i

B190.if.i414.i:                                   ; preds = %B190.if.i414.i.preheader, %B190.if.i414.i
  %.401.i116.i.04726 = phi i64 [ %.470.i420.i, %B190.if.i414.i ], [ 0, %B190.if.i414.i.preheader ]
  %.470.i420.i = add nsw i64 %.401.i116.i.04726, 1
  %.496.i366.i = mul nsw i64 %.401.i116.i.04726, %arg.shape.0
  %gep4982 = getelementptr double, ptr %invariant.gep4981, i64 %.496.i366.i
  %.528.i388.i = load double, ptr %gep4982, align 8, !noalias !166
  %.530.i390.i = add nsw i64 %.401.i116.i.04726, %arg.held
  %.532.i392.i = mul nsw i64 %.530.i390.i, %arg.shape.0
  %.534.i394.i = add nsw i64 %.532.i392.i, %.221.i102.i.04729
  %.548.i402.i = icmp slt i64 %.534.i394.i, 0
  %.549.i403.i = select i1 %.548.i402.i, i64 %arg.arrays.1.5.0, i64 0
  %59 = getelementptr double, ptr %arg.arrays.1.4, i64 %.534.i394.i
  %.563.i413.i = getelementptr double, ptr %59, i64 %.549.i403.i
  store double %.528.i388.i, ptr %.563.i413.i, align 8, !noalias !166
  %exitcond4786.not = icmp eq i64 %.470.i420.i, %arg.decided
  br i1 %exitcond4786.not, label %B248.i313.i, label %B190.if.i414.i

B708.i:                                           ; preds = %B250.i219.i, %B558.if.i
  %.2495.i = load i64, ptr %arg.code.4, align 8, !noalias !162
  %.2503.i = mul nsw i64 %.2299.i, %.223.i
  %.2547.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.2503.i
  %.2548.i = inttoptr i64 %.2495.i to ptr
  tail call void %.2548.i(ptr %.331.i, ptr %.2522.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.2547.i), !noalias !162
  %exitcond4788.not = icmp eq i64 %.2299.i, 4
  br i1 %exitcond4788.not, label %B816.i, label %B558.if.i

B816.i:                                           ; preds = %B708.i
  %.2585.i = load i64, ptr %.2584.i, align 8, !noalias !162
  %.2630.i = inttoptr i64 %.2585.i to ptr
  tail call void %.2630.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !162
  br i1 %.2633.i.not, label %B962.i, label %B894.i

B894.i:                                           ; preds = %B816.i
  %.2664.i = load i64, ptr %.2663.i, align 8, !noalias !162
  %.2709.i = inttoptr i64 %.2664.i to ptr
  tail call void %.2709.i(ptr %.331.i, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !162
  br label %B962.i

B962.i:                                           ; preds = %B894.i, %B816.i
  br i1 %.2795.i4736.not, label %B1410.i, label %B996.if.i

B1046.i:                                          ; preds = %B996.if.i
  %.2929.i = getelementptr i64, ptr %arg.results.1.4, i64 %.2890.i
  %.2930.i = load i64, ptr %.2929.i, align 8, !noalias !162
  %.2931.i.not = icmp eq i64 %.2930.i, 0
  br i1 %.2931.i.not, label %B1082.i, label %B1621.i

B1082.i:                                          ; preds = %B1046.i
  %.3001.i = mul i64 %.2890.i, %arg.results.3.5.1
  %.3005.i = getelementptr i64, ptr %arg.results.3.4, i64 %.3001.i
  %.3006.i = load i64, ptr %.3005.i, align 8, !noalias !162
  %.3007.i = add nsw i64 %.3006.i, 1
  store i64 %.3007.i, ptr %.3005.i, align 8, !noalias !162
  %.3115.i = getelementptr i8, ptr %.3005.i, i64 8
  %.3116.i = load i64, ptr %.3115.i, align 8, !noalias !162
  %.3117.i = add nsw i64 %.3116.i, 4
  store i64 %.3117.i, ptr %.3115.i, align 8, !noalias !162
  br i1 %.3250.i4732.not, label %B1310.i, label %B1204.if.i.preheader

B1204.if.i.preheader:                             ; preds = %B1082.i
  %invariant.gep4983 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2739.i.04737
  br label %B1204.if.i

B1250.i.loopexit:                                 ; preds = %B1204.if.i
  %60 = fcmp une double %.3324.i, 0.000000e+00
  br i1 %60, label %B1262.i, label %B1310.i

B1262.i:                                          ; preds = %B1250.i.loopexit
  %.84.i477.i = load i64, ptr %104, align 8, !noalias !170
  %.89.i.i = icmp sgt i64 %.84.i477.i, -1
  br i1 %.89.i.i, label %B46.i.i, label %B1621.i

B46.i.i:                                          ; preds = %B1262.i
  %.120.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i477.i
  %.121.i486.i = load i64, ptr %.120.i.i, align 8, !noalias !170
  %.122.i487.i = icmp eq i64 %.121.i486.i, 0
  br i1 %.122.i487.i, label %B80.i.i, label %B1621.i

B80.i.i:                                          ; preds = %B46.i.i
  store i64 3, ptr %.120.i.i, align 8, !noalias !170
  br label %B1621.i

B1310.i:                                          ; preds = %B1082.i, %B1250.i.loopexit
  br i1 %.2633.i.not, label %B1398.i, label %B1314.i

B1314.i:                                          ; preds = %B1310.i
  %61 = getelementptr double, ptr %arg.arrays.4.4, i64 %.2739.i.04737
  %.3412.i = load double, ptr %61, align 8, !noalias !162
  %.3414.i = fcmp olt double %.3412.i, -1.000000e-09
  br i1 %.3414.i, label %B1350.i, label %B1398.i

B1350.i:                                          ; preds = %B1314.i
  %.84.i577.i = load i64, ptr %104, align 8, !noalias !173
  %.89.i580.i = icmp sgt i64 %.84.i577.i, -1
  br i1 %.89.i580.i, label %B46.i585.i, label %B1621.i

B46.i585.i:                                       ; preds = %B1350.i
  %.120.i606.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i577.i
  %.121.i607.i = load i64, ptr %.120.i606.i, align 8, !noalias !173
  %.122.i608.i = icmp eq i64 %.121.i607.i, 0
  br i1 %.122.i608.i, label %B80.i613.i, label %B1621.i

B80.i613.i:                                       ; preds = %B46.i585.i
  store i64 4, ptr %.120.i606.i, align 8, !noalias !173
  br label %B1621.i

B1398.i:                                          ; preds = %B1314.i, %B1310.i
  %.3461.i = add nsw i64 %active.3.i.14739, 1
  br label %B1621.i

B1410.i.loopexit:                                 ; preds = %B1621.i
  %62 = icmp ne i64 %active.4.i.2, 0
  br label %B1410.i

B1410.i:                                          ; preds = %B1410.i.loopexit, %B962.i
  %active.3.i.1.lcssa = phi i1 [ false, %B962.i ], [ %62, %B1410.i.loopexit ]
  %.804.i = icmp sgt i64 %.742.i.04742, 1
  %or.cond = select i1 %active.3.i.1.lcssa, i1 %.804.i, i1 false
  br i1 %or.cond, label %B186.if.i, label %B1430.i

B1430.i:                                          ; preds = %B1410.i
  %or.cond.not4773 = or i1 %.3568.i, %active.3.i.1.lcssa
  %brmerge4771 = select i1 %or.cond.not4773, i1 true, i1 %.3652.i4743.not4772
  br i1 %brmerge4771, label %B906.endif.endif.endif.endif.endif, label %B1484.if.i.preheader

B1484.if.i.preheader:                             ; preds = %B1430.i
  %brmerge4987 = select i1 %min.iters.check4861, i1 true, i1 %found.conflict
  br i1 %brmerge4987, label %B1484.if.i.preheader4968, label %vector.body4865

vector.body4865:                                  ; preds = %B1484.if.i.preheader, %vector.body4865
  %index4866 = phi i64 [ %index.next4871, %vector.body4865 ], [ 0, %B1484.if.i.preheader ]
  %63 = getelementptr double, ptr %arg.arrays.0.4, i64 %index4866
  %64 = getelementptr i8, ptr %63, i64 %42
  %65 = getelementptr i8, ptr %64, i64 16
  %wide.load4867 = load <2 x double>, ptr %64, align 8, !alias.scope !176, !noalias !162
  %wide.load4868 = load <2 x double>, ptr %65, align 8, !alias.scope !176, !noalias !162
  %66 = getelementptr i8, ptr %63, i64 16
  %wide.load4869 = load <2 x double>, ptr %63, align 8, !alias.scope !179, !noalias !181
  %wide.load4870 = load <2 x double>, ptr %66, align 8, !alias.scope !179, !noalias !181
  %67 = fsub <2 x double> %wide.load4869, %wide.load4867
  %68 = fsub <2 x double> %wide.load4870, %wide.load4868
  store <2 x double> %wide.load4867, ptr %63, align 8, !alias.scope !179, !noalias !181
  store <2 x double> %wide.load4868, ptr %66, align 8, !alias.scope !179, !noalias !181
  store <2 x double> %67, ptr %64, align 8, !alias.scope !176, !noalias !162
  store <2 x double> %68, ptr %65, align 8, !alias.scope !176, !noalias !162
  %index.next4871 = add i64 %index4866, 4
  %69 = icmp eq i64 %index.next4871, %n.vec4864
  br i1 %69, label %middle.block4872, label %vector.body4865, !llvm.loop !182

middle.block4872:                                 ; preds = %vector.body4865
  br i1 %cmp.n4873, label %B906.endif.endif.endif.endif.endif, label %B1484.if.i.preheader4968

B1484.if.i.preheader4968:                         ; preds = %B1484.if.i.preheader, %middle.block4872
  %.3596.i.04744.ph = phi i64 [ %n.vec4864, %middle.block4872 ], [ 0, %B1484.if.i.preheader ]
  br label %B1484.if.i

B1621.i:                                          ; preds = %B80.i613.i, %B1350.i, %B46.i585.i, %B80.i.i, %B1262.i, %B46.i.i, %B996.if.i, %B1046.i, %B1398.i
  %active.4.i.2 = phi i64 [ %.3461.i, %B1398.i ], [ %active.3.i.14739, %B996.if.i ], [ %active.3.i.14739, %B80.i.i ], [ %active.3.i.14739, %B1046.i ], [ %active.3.i.14739, %B46.i.i ], [ %active.3.i.14739, %B1262.i ], [ %active.3.i.14739, %B46.i585.i ], [ %active.3.i.14739, %B1350.i ], [ %active.3.i.14739, %B80.i613.i ]
  %exitcond4790.not = icmp eq i64 %arg.shape.0, %.2808.i
  br i1 %exitcond4790.not, label %B1410.i.loopexit, label %B996.if.i

B0.endif.else.endif.if.i:                         ; preds = %B906
  br label %B0.endif.else.endif.endif.i

B0.endif.else.endif.endif.i:                      ; preds = %B0.endif.else.endif.if.i, %B906
  %spec.select = phi i64 [ %arg.lane.0.5.1, %B0.endif.else.endif.if.i ], [ 0, %B906 ]
  %.693.i.not4707 = icmp slt i64 %spec.select, %arg.lane.0.5.1
  br i1 %.693.i.not4707, label %.663.endif.i.preheader, label %B186.if.i.preheader, !prof !153

.663.endif.i.preheader:                           ; preds = %B0.endif.else.endif.endif.i
  %70 = sub i64 %arg.lane.0.5.1, %spec.select
  %min.iters.check4931 = icmp ult i64 %70, 4
  br i1 %min.iters.check4931, label %.663.endif.i.preheader4969, label %vector.ph4932, !prof !154

vector.ph4932:                                    ; preds = %.663.endif.i.preheader
  %n.vec4934 = and i64 %70, -4
  %71 = add i64 %spec.select, %n.vec4934
  %broadcast.splatinsert4935 = insertelement <2 x double> poison, double %.2510, i64 0
  %broadcast.splat4936 = shufflevector <2 x double> %broadcast.splatinsert4935, <2 x double> poison, <2 x i32> zeroinitializer
  %72 = getelementptr double, ptr %27, i64 %spec.select
  br label %vector.body4937

vector.body4937:                                  ; preds = %vector.body4937, %vector.ph4932
  %index4938 = phi i64 [ 0, %vector.ph4932 ], [ %index.next4940, %vector.body4937 ]
  %73 = getelementptr double, ptr %72, i64 %index4938
  %74 = getelementptr i8, ptr %73, i64 16
  store <2 x double> %broadcast.splat4936, ptr %73, align 8, !noalias !162
  store <2 x double> %broadcast.splat4936, ptr %74, align 8, !noalias !162
  %index.next4940 = add i64 %index4938, 4
  %75 = icmp eq i64 %index.next4940, %n.vec4934
  br i1 %75, label %middle.block4941, label %vector.body4937, !prof !155, !llvm.loop !183

middle.block4941:                                 ; preds = %vector.body4937
  %cmp.n4942 = icmp eq i64 %70, %n.vec4934
  br i1 %cmp.n4942, label %B186.if.i.preheader, label %.663.endif.i.preheader4969, !prof !158

.663.endif.i.preheader4969:                       ; preds = %.663.endif.i.preheader, %middle.block4941
  %.659.i.04708.ph = phi i64 [ %spec.select, %.663.endif.i.preheader ], [ %71, %middle.block4941 ]
  br label %.663.endif.i

.663.endif.i:                                     ; preds = %.663.endif.i.preheader4969, %.663.endif.i
  %.659.i.04708 = phi i64 [ %.707.i, %.663.endif.i ], [ %.659.i.04708.ph, %.663.endif.i.preheader4969 ]
  %.702.i = getelementptr double, ptr %27, i64 %.659.i.04708
  store double %.2510, ptr %.702.i, align 8, !noalias !162
  %.707.i = add nsw i64 %.659.i.04708, 1
  %exitcond4779.not = icmp eq i64 %.707.i, %arg.lane.0.5.1
  br i1 %exitcond4779.not, label %B186.if.i.preheader, label %.663.endif.i, !prof !159, !llvm.loop !184

B186.if.i.preheader:                              ; preds = %.663.endif.i, %middle.block4941, %B0.endif.else.endif.endif.i
  br label %B186.if.i

B186.if.i:                                        ; preds = %B186.if.i.preheader, %B1410.i
  %.742.i.04742 = phi i64 [ %.813.i, %B1410.i ], [ %.11.i4680, %B186.if.i.preheader ]
  %.739.i.04741 = phi i64 [ %.817.i, %B1410.i ], [ 0, %B186.if.i.preheader ]
  %.813.i = add nsw i64 %.742.i.04742, -1
  %.817.i = add nsw i64 %.739.i.04741, 1
  %.845.i = uitofp i64 %.739.i.04741 to double
  %.846.i = fmul double %.2510, %.845.i
  %.848.i = fadd double %t.4.3, %.846.i
  %.851.i = uitofp i64 %.817.i to double
  %.852.i = fmul double %.2510, %.851.i
  %.854.i = fadd double %t.4.3, %.852.i
  br i1 %.2065, label %B188.endif.else.endif.if.i, label %B188.endif.else.endif.endif.i, !prof !36

B188.endif.else.endif.if.i:                       ; preds = %B186.if.i
  br label %B188.endif.else.endif.endif.i

B188.endif.else.endif.endif.i:                    ; preds = %B188.endif.else.endif.if.i, %B186.if.i
  %spec.select4676 = phi i64 [ %arg.lane.0.5.1, %B188.endif.else.endif.if.i ], [ 0, %B186.if.i ]
  %.1178.i.not4709 = icmp slt i64 %spec.select4676, %arg.lane.0.5.1
  br i1 %.1178.i.not4709, label %.1148.endif.i.preheader, label %.1149.else.i, !prof !153

.1148.endif.i.preheader:                          ; preds = %B188.endif.else.endif.endif.i
  %76 = sub i64 %arg.lane.0.5.1, %spec.select4676
  %min.iters.check4917 = icmp ult i64 %76, 4
  br i1 %min.iters.check4917, label %.1148.endif.i.preheader4963, label %vector.ph4918, !prof !154

vector.ph4918:                                    ; preds = %.1148.endif.i.preheader
  %n.vec4920 = and i64 %76, -4
  %77 = add i64 %spec.select4676, %n.vec4920
  %broadcast.splatinsert4921 = insertelement <2 x double> poison, double %.848.i, i64 0
  %broadcast.splat4922 = shufflevector <2 x double> %broadcast.splatinsert4921, <2 x double> poison, <2 x i32> zeroinitializer
  %78 = getelementptr double, ptr %arg.lane.0.4, i64 %spec.select4676
  br label %vector.body4923

vector.body4923:                                  ; preds = %vector.body4923, %vector.ph4918
  %index4924 = phi i64 [ 0, %vector.ph4918 ], [ %index.next4926, %vector.body4923 ]
  %79 = getelementptr double, ptr %78, i64 %index4924
  %80 = getelementptr i8, ptr %79, i64 16
  store <2 x double> %broadcast.splat4922, ptr %79, align 8, !noalias !162
  store <2 x double> %broadcast.splat4922, ptr %80, align 8, !noalias !162
  %index.next4926 = add i64 %index4924, 4
  %81 = icmp eq i64 %index.next4926, %n.vec4920
  br i1 %81, label %middle.block4927, label %vector.body4923, !prof !155, !llvm.loop !185

middle.block4927:                                 ; preds = %vector.body4923
  %cmp.n4928 = icmp eq i64 %76, %n.vec4920
  br i1 %cmp.n4928, label %.1149.else.i, label %.1148.endif.i.preheader4963, !prof !158

.1148.endif.i.preheader4963:                      ; preds = %.1148.endif.i.preheader, %middle.block4927
  %.1144.i.04710.ph = phi i64 [ %spec.select4676, %.1148.endif.i.preheader ], [ %77, %middle.block4927 ]
  br label %.1148.endif.i

.1148.endif.i:                                    ; preds = %.1148.endif.i.preheader4963, %.1148.endif.i
  %.1144.i.04710 = phi i64 [ %.1192.i, %.1148.endif.i ], [ %.1144.i.04710.ph, %.1148.endif.i.preheader4963 ]
  %.1187.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1144.i.04710
  store double %.848.i, ptr %.1187.i, align 8, !noalias !162
  %.1192.i = add nsw i64 %.1144.i.04710, 1
  %exitcond4780.not = icmp eq i64 %.1192.i, %arg.lane.0.5.1
  br i1 %exitcond4780.not, label %.1149.else.i, label %.1148.endif.i, !prof !159, !llvm.loop !186

.1149.else.i:                                     ; preds = %.1148.endif.i, %middle.block4927, %B188.endif.else.endif.endif.i
  br i1 %.2065, label %.1149.endif.else.endif.if.i, label %.1149.endif.else.endif.endif.i, !prof !36

.1149.endif.else.endif.if.i:                      ; preds = %.1149.else.i
  br label %.1149.endif.else.endif.endif.i

.1149.endif.else.endif.endif.i:                   ; preds = %.1149.endif.else.endif.if.i, %.1149.else.i
  %spec.select4677 = phi i64 [ %arg.lane.0.5.1, %.1149.endif.else.endif.if.i ], [ 0, %.1149.else.i ]
  %.1521.i.not4711 = icmp slt i64 %spec.select4677, %arg.lane.0.5.1
  br i1 %.1521.i.not4711, label %.1491.endif.i.preheader, label %.1491.if.i, !prof !153

.1491.endif.i.preheader:                          ; preds = %.1149.endif.else.endif.endif.i
  %82 = sub i64 %arg.lane.0.5.1, %spec.select4677
  %min.iters.check4903 = icmp ult i64 %82, 4
  br i1 %min.iters.check4903, label %.1491.endif.i.preheader4962, label %vector.ph4904, !prof !154

vector.ph4904:                                    ; preds = %.1491.endif.i.preheader
  %n.vec4906 = and i64 %82, -4
  %83 = add i64 %spec.select4677, %n.vec4906
  %broadcast.splatinsert4907 = insertelement <2 x double> poison, double %.854.i, i64 0
  %broadcast.splat4908 = shufflevector <2 x double> %broadcast.splatinsert4907, <2 x double> poison, <2 x i32> zeroinitializer
  %84 = getelementptr double, ptr %23, i64 %spec.select4677
  br label %vector.body4909

vector.body4909:                                  ; preds = %vector.body4909, %vector.ph4904
  %index4910 = phi i64 [ 0, %vector.ph4904 ], [ %index.next4912, %vector.body4909 ]
  %85 = getelementptr double, ptr %84, i64 %index4910
  %86 = getelementptr i8, ptr %85, i64 16
  store <2 x double> %broadcast.splat4908, ptr %85, align 8, !noalias !162
  store <2 x double> %broadcast.splat4908, ptr %86, align 8, !noalias !162
  %index.next4912 = add i64 %index4910, 4
  %87 = icmp eq i64 %index.next4912, %n.vec4906
  br i1 %87, label %middle.block4913, label %vector.body4909, !prof !155, !llvm.loop !187

middle.block4913:                                 ; preds = %vector.body4909
  %cmp.n4914 = icmp eq i64 %82, %n.vec4906
  br i1 %cmp.n4914, label %.1491.if.i, label %.1491.endif.i.preheader4962, !prof !158

.1491.endif.i.preheader4962:                      ; preds = %.1491.endif.i.preheader, %middle.block4913
  %.1487.i.04712.ph = phi i64 [ %spec.select4677, %.1491.endif.i.preheader ], [ %83, %middle.block4913 ]
  br label %.1491.endif.i

.1491.if.i:                                       ; preds = %.1491.endif.i, %middle.block4913, %.1149.endif.else.endif.endif.i
  br i1 %.1621.i4713.not, label %B358.i, label %B308.if.i.preheader

B308.if.i.preheader:                              ; preds = %.1491.if.i
  br i1 %or.cond4959, label %B308.if.i.preheader4961, label %vector.body4894

vector.body4894:                                  ; preds = %B308.if.i.preheader, %vector.body4894
  %index4895 = phi i64 [ %index.next4898, %vector.body4894 ], [ 0, %B308.if.i.preheader ]
  %88 = getelementptr double, ptr %arg.arrays.0.4, i64 %index4895
  %89 = getelementptr i8, ptr %88, i64 16
  %wide.load4896 = load <2 x double>, ptr %88, align 8, !noalias !162
  %wide.load4897 = load <2 x double>, ptr %89, align 8, !noalias !162
  %90 = getelementptr i8, ptr %88, i64 %41
  %91 = getelementptr i8, ptr %90, i64 16
  store <2 x double> %wide.load4896, ptr %90, align 8, !noalias !162
  store <2 x double> %wide.load4897, ptr %91, align 8, !noalias !162
  %index.next4898 = add i64 %index4895, 4
  %92 = icmp eq i64 %index.next4898, %n.vec4893
  br i1 %92, label %middle.block4899, label %vector.body4894, !llvm.loop !188

middle.block4899:                                 ; preds = %vector.body4894
  br i1 %cmp.n4900, label %B358.i, label %B308.if.i.preheader4961

B308.if.i.preheader4961:                          ; preds = %B308.if.i.preheader, %middle.block4899
  %.1565.i.04714.ph = phi i64 [ 0, %B308.if.i.preheader ], [ %n.vec4893, %middle.block4899 ]
  br label %B308.if.i

.1491.endif.i:                                    ; preds = %.1491.endif.i.preheader4962, %.1491.endif.i
  %.1487.i.04712 = phi i64 [ %.1535.i, %.1491.endif.i ], [ %.1487.i.04712.ph, %.1491.endif.i.preheader4962 ]
  %.1530.i = getelementptr double, ptr %23, i64 %.1487.i.04712
  store double %.854.i, ptr %.1530.i, align 8, !noalias !162
  %.1535.i = add nsw i64 %.1487.i.04712, 1
  %exitcond4781.not = icmp eq i64 %.1535.i, %arg.lane.0.5.1
  br i1 %exitcond4781.not, label %.1491.if.i, label %.1491.endif.i, !prof !159, !llvm.loop !189

B308.if.i:                                        ; preds = %B308.if.i.preheader4961, %B308.if.i
  %.1565.i.04714 = phi i64 [ %.1634.i, %B308.if.i ], [ %.1565.i.04714.ph, %B308.if.i.preheader4961 ]
  %.1634.i = add nsw i64 %.1565.i.04714, 1
  %93 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1565.i.04714
  %.1688.i = load double, ptr %93, align 8, !noalias !162
  %gep4978 = getelementptr double, ptr %invariant.gep4977, i64 %.1565.i.04714
  store double %.1688.i, ptr %gep4978, align 8, !noalias !162
  %exitcond4782.not = icmp eq i64 %.223.i, %.1634.i
  br i1 %exitcond4782.not, label %B358.i, label %B308.if.i, !llvm.loop !190

B370.else.i:                                      ; preds = %B358.i
  br i1 %.2065, label %B370.endif.else.endif.if.i, label %B370.endif.else.endif.endif.i, !prof !36

B370.endif.else.endif.if.i:                       ; preds = %B370.else.i
  br label %B370.endif.else.endif.endif.i

B370.endif.else.endif.endif.i:                    ; preds = %B370.endif.else.endif.if.i, %B370.else.i
  %spec.select4678 = phi i64 [ %arg.lane.0.5.1, %B370.endif.else.endif.if.i ], [ 0, %B370.else.i ]
  %.2053.i.not4716 = icmp slt i64 %spec.select4678, %arg.lane.0.5.1
  br i1 %.2053.i.not4716, label %.2023.endif.i.preheader, label %.2023.if.i, !prof !153

.2023.endif.i.preheader:                          ; preds = %B370.endif.else.endif.endif.i
  %94 = sub i64 %arg.lane.0.5.1, %spec.select4678
  %min.iters.check4876 = icmp ult i64 %94, 4
  br i1 %min.iters.check4876, label %.2023.endif.i.preheader4960, label %vector.ph4877, !prof !154

vector.ph4877:                                    ; preds = %.2023.endif.i.preheader
  %n.vec4879 = and i64 %94, -4
  %95 = add i64 %spec.select4678, %n.vec4879
  %96 = getelementptr double, ptr %24, i64 %spec.select4678
  br label %vector.body4880

vector.body4880:                                  ; preds = %vector.body4880, %vector.ph4877
  %index4881 = phi i64 [ 0, %vector.ph4877 ], [ %index.next4883, %vector.body4880 ]
  %97 = getelementptr double, ptr %96, i64 %index4881
  %98 = getelementptr i8, ptr %97, i64 16
  store <2 x double> splat (double 1.000000e+00), ptr %97, align 8, !noalias !162
  store <2 x double> splat (double 1.000000e+00), ptr %98, align 8, !noalias !162
  %index.next4883 = add i64 %index4881, 4
  %99 = icmp eq i64 %index.next4883, %n.vec4879
  br i1 %99, label %middle.block4884, label %vector.body4880, !prof !155, !llvm.loop !191

middle.block4884:                                 ; preds = %vector.body4880
  %cmp.n4885 = icmp eq i64 %94, %n.vec4879
  br i1 %cmp.n4885, label %.2023.if.i, label %.2023.endif.i.preheader4960, !prof !158

.2023.endif.i.preheader4960:                      ; preds = %.2023.endif.i.preheader, %middle.block4884
  %.2019.i.04717.ph = phi i64 [ %spec.select4678, %.2023.endif.i.preheader ], [ %95, %middle.block4884 ]
  br label %.2023.endif.i

B248.i.i:                                         ; preds = %B190.if.i.i, %B118.if.i.i
  %exitcond4785.not = icmp eq i64 %arg.shape.0, %.292.i.i
  br i1 %exitcond4785.not, label %B250.i.i, label %B118.if.i.i

B250.i.i:                                         ; preds = %B248.i.i, %.2023.if.i
  %.614.i.i = load i64, ptr %.2211, align 8, !noalias !192
  %.661.i.i = inttoptr i64 %.614.i.i to ptr
  tail call void %.661.i.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !192
  br label %B442.i

B118.if.i.i:                                      ; preds = %.2023.if.i, %B248.i.i
  %.221.i.i.04723 = phi i64 [ %.292.i.i, %B248.i.i ], [ 0, %.2023.if.i ]
  %.292.i.i = add nsw i64 %.221.i.i.04723, 1
  %100 = getelementptr double, ptr %25, i64 %.221.i.i.04723
  %.374.i.i = load double, ptr %100, align 8, !noalias !192
  %.375.i.i = fcmp ule double %.374.i.i, 5.000000e-01
  %brmerge4770 = select i1 %.375.i.i, i1 true, i1 %.457.i.i4718
  br i1 %brmerge4770, label %B248.i.i, label %B190.if.i.i.preheader

B190.if.i.i.preheader:                            ; preds = %B118.if.i.i
  %invariant.gep4979 = getelementptr double, ptr %arg.arrays.4.4, i64 %.221.i.i.04723
  br label %B190.if.i.i

B190.if.i.i:                                      ; preds = %B190.if.i.i.preheader, %B190.if.i.i
  %.401.i.i.04719 = phi i64 [ %.470.i.i, %B190.if.i.i ], [ 0, %B190.if.i.i.preheader ]
  %.470.i.i = add nsw i64 %.401.i.i.04719, 1
  %.496.i.i = mul nsw i64 %.401.i.i.04719, %arg.shape.0
  %gep4980 = getelementptr double, ptr %invariant.gep4979, i64 %.496.i.i
  %.528.i.i = load double, ptr %gep4980, align 8, !noalias !192
  %.530.i.i = add nsw i64 %.401.i.i.04719, %arg.held
  %.532.i.i = mul nsw i64 %.530.i.i, %arg.shape.0
  %.534.i.i = add nsw i64 %.532.i.i, %.221.i.i.04723
  %.548.i.i = icmp slt i64 %.534.i.i, 0
  %.549.i.i = select i1 %.548.i.i, i64 %arg.arrays.1.5.0, i64 0
  %101 = getelementptr double, ptr %arg.arrays.1.4, i64 %.534.i.i
  %.563.i.i = getelementptr double, ptr %101, i64 %.549.i.i
  store double %.528.i.i, ptr %.563.i.i, align 8, !noalias !192
  %exitcond4784.not = icmp eq i64 %.470.i.i, %arg.decided
  br i1 %exitcond4784.not, label %B248.i.i, label %B190.if.i.i

.2023.if.i:                                       ; preds = %.2023.endif.i, %middle.block4884, %B370.endif.else.endif.endif.i
  %.150.i.i = load i64, ptr %.149.i.i, align 8, !noalias !192
  %.195.i.i = inttoptr i64 %.150.i.i to ptr
  tail call void %.195.i.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !192
  br i1 %.279.i.i4721.not, label %B250.i.i, label %B118.if.i.i

.2023.endif.i:                                    ; preds = %.2023.endif.i.preheader4960, %.2023.endif.i
  %.2019.i.04717 = phi i64 [ %.2067.i, %.2023.endif.i ], [ %.2019.i.04717.ph, %.2023.endif.i.preheader4960 ]
  %.2062.i = getelementptr double, ptr %24, i64 %.2019.i.04717
  store double 1.000000e+00, ptr %.2062.i, align 8, !noalias !162
  %.2067.i = add nsw i64 %.2019.i.04717, 1
  %exitcond4783.not = icmp eq i64 %.2067.i, %arg.lane.0.5.1
  br i1 %exitcond4783.not, label %.2023.if.i, label %.2023.endif.i, !prof !159, !llvm.loop !196

B558.if.i:                                        ; preds = %B442.i, %B708.i
  %.2230.i.04730 = phi i64 [ 1, %B442.i ], [ %.2299.i, %B708.i ]
  %.2299.i = add nsw i64 %.2230.i.04730, 1
  %102 = getelementptr i64, ptr %arg.code.4, i64 %.2230.i.04730
  %103 = getelementptr i8, ptr %102, i64 224
  %.2358.i = load i64, ptr %103, align 8, !noalias !162
  %.2403.i = inttoptr i64 %.2358.i to ptr
  tail call void %.2403.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !162
  br i1 %.1728.i, label %B648.i, label %B708.i

B996.if.i:                                        ; preds = %B962.i, %B1621.i
  %active.3.i.14739 = phi i64 [ %active.4.i.2, %B1621.i ], [ 0, %B962.i ]
  %.2739.i.04737 = phi i64 [ %.2808.i, %B1621.i ], [ 0, %B962.i ]
  %.2808.i = add nsw i64 %.2739.i.04737, 1
  %104 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2739.i.04737
  %.2890.i = load i64, ptr %104, align 8, !noalias !162
  %.2898.i = icmp slt i64 %.2890.i, 0
  br i1 %.2898.i, label %B1621.i, label %B1046.i

B1204.if.i:                                       ; preds = %B1204.if.i.preheader, %B1204.if.i
  %trouble.2.i.34735 = phi double [ %.3324.i, %B1204.if.i ], [ 0.000000e+00, %B1204.if.i.preheader ]
  %.3194.i.04733 = phi i64 [ %.3263.i, %B1204.if.i ], [ 0, %B1204.if.i.preheader ]
  %.3263.i = add nsw i64 %.3194.i.04733, 1
  %105 = mul nsw i64 %.3194.i.04733, %arg.shape.0
  %gep4984 = getelementptr double, ptr %invariant.gep4983, i64 %105
  %.3321.i = load double, ptr %gep4984, align 8, !noalias !162
  %.3322.i = fmul double %.3321.i, 0.000000e+00
  %.3324.i = fadd double %trouble.2.i.34735, %.3322.i
  %exitcond4789.not = icmp eq i64 %arg.shape.1, %.3263.i
  br i1 %exitcond4789.not, label %B1250.i.loopexit, label %B1204.if.i

B1484.if.i:                                       ; preds = %B1484.if.i.preheader4968, %B1484.if.i
  %.3596.i.04744 = phi i64 [ %.3665.i, %B1484.if.i ], [ %.3596.i.04744.ph, %B1484.if.i.preheader4968 ]
  %.3665.i = add nsw i64 %.3596.i.04744, 1
  %gep4986 = getelementptr double, ptr %invariant.gep4985, i64 %.3596.i.04744
  %.3722.i = load double, ptr %gep4986, align 8, !noalias !162
  %106 = getelementptr double, ptr %arg.arrays.0.4, i64 %.3596.i.04744
  %.3752.i = load double, ptr %106, align 8, !noalias !162
  %.3786.i = fsub double %.3752.i, %.3722.i
  store double %.3722.i, ptr %106, align 8, !noalias !162
  store double %.3786.i, ptr %gep4986, align 8, !noalias !162
  %exitcond4791.not = icmp eq i64 %arg.shape.1, %.3665.i
  br i1 %exitcond4791.not, label %B906.endif.endif.endif.endif.endif, label %B1484.if.i, !llvm.loop !197

B906.endif.endif.endif.endif.endif:               ; preds = %B1484.if.i, %middle.block4872, %B1430.i
  br i1 %active.3.i.1.lcssa, label %B1158, label %B1536

B1194.else.endif:                                 ; preds = %B1166
  br i1 %.2065, label %B1194.endif.else.endif.if, label %B1194.endif.else.endif.endif.endif.if, !prof !36

B1194.endif.else.endif.if:                        ; preds = %B1194.else.endif
  br label %B1194.endif.else.endif.endif.endif.if

B1194.endif.else.endif.endif.endif.if:            ; preds = %B1194.endif.else.endif.if, %B1194.else.endif
  %.2882.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %B1194.endif.else.endif.if ], [ 0, %B1194.else.endif ]
  %.3006.not4746 = icmp slt i64 %.2882.sroa.0.3, %arg.lane.0.5.1
  br i1 %.3006.not4746, label %.2976.endif.preheader, label %.2977.else.endif, !prof !153

.2976.endif.preheader:                            ; preds = %B1194.endif.else.endif.endif.endif.if
  %107 = sub i64 %arg.lane.0.5.1, %.2882.sroa.0.3
  %min.iters.check4843 = icmp ult i64 %107, 4
  br i1 %min.iters.check4843, label %.2976.endif.preheader4967, label %vector.ph4844, !prof !154

vector.ph4844:                                    ; preds = %.2976.endif.preheader
  %n.vec4846 = and i64 %107, -4
  %108 = add i64 %.2882.sroa.0.3, %n.vec4846
  %broadcast.splatinsert4847 = insertelement <2 x double> poison, double %.11.i4679, i64 0
  %broadcast.splat4848 = shufflevector <2 x double> %broadcast.splatinsert4847, <2 x double> poison, <2 x i32> zeroinitializer
  %109 = getelementptr double, ptr %arg.lane.0.4, i64 %.2882.sroa.0.3
  br label %vector.body4849

vector.body4849:                                  ; preds = %vector.body4849, %vector.ph4844
  %index4850 = phi i64 [ 0, %vector.ph4844 ], [ %index.next4852, %vector.body4849 ]
  %110 = getelementptr double, ptr %109, i64 %index4850
  %111 = getelementptr i8, ptr %110, i64 16
  store <2 x double> %broadcast.splat4848, ptr %110, align 8
  store <2 x double> %broadcast.splat4848, ptr %111, align 8
  %index.next4852 = add i64 %index4850, 4
  %112 = icmp eq i64 %index.next4852, %n.vec4846
  br i1 %112, label %middle.block4853, label %vector.body4849, !prof !155, !llvm.loop !198

middle.block4853:                                 ; preds = %vector.body4849
  %cmp.n4854 = icmp eq i64 %107, %n.vec4846
  br i1 %cmp.n4854, label %.2977.else.endif, label %.2976.endif.preheader4967, !prof !158

.2976.endif.preheader4967:                        ; preds = %.2976.endif.preheader, %middle.block4853
  %.2972.04747.ph = phi i64 [ %.2882.sroa.0.3, %.2976.endif.preheader ], [ %108, %middle.block4853 ]
  br label %.2976.endif

.2976.endif:                                      ; preds = %.2976.endif.preheader4967, %.2976.endif
  %.2972.04747 = phi i64 [ %.3020, %.2976.endif ], [ %.2972.04747.ph, %.2976.endif.preheader4967 ]
  %.3015 = getelementptr double, ptr %arg.lane.0.4, i64 %.2972.04747
  store double %.11.i4679, ptr %.3015, align 8
  %.3020 = add nsw i64 %.2972.04747, 1
  %exitcond4792.not = icmp eq i64 %.3020, %arg.lane.0.5.1
  br i1 %exitcond4792.not, label %.2977.else.endif, label %.2976.endif, !prof !159, !llvm.loop !199

.2977.else.endif:                                 ; preds = %.2976.endif, %middle.block4853, %B1194.endif.else.endif.endif.endif.if
  br i1 %.2065, label %.2977.endif.else.endif.if, label %.2977.endif.else.endif.endif.endif.if, !prof !36

.2977.endif.else.endif.if:                        ; preds = %.2977.else.endif
  br label %.2977.endif.else.endif.endif.endif.if

.2977.endif.else.endif.endif.endif.if:            ; preds = %.2977.endif.else.endif.if, %.2977.else.endif
  %.3226.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %.2977.endif.else.endif.if ], [ 0, %.2977.else.endif ]
  %.3350.not4748 = icmp slt i64 %.3226.sroa.0.3, %arg.lane.0.5.1
  br i1 %.3350.not4748, label %.3320.endif.preheader, label %.3321.else.endif, !prof !153

.3320.endif.preheader:                            ; preds = %.2977.endif.else.endif.endif.endif.if
  %113 = sub i64 %arg.lane.0.5.1, %.3226.sroa.0.3
  %min.iters.check4829 = icmp ult i64 %113, 4
  br i1 %min.iters.check4829, label %.3320.endif.preheader4966, label %vector.ph4830, !prof !154

vector.ph4830:                                    ; preds = %.3320.endif.preheader
  %n.vec4832 = and i64 %113, -4
  %114 = add i64 %.3226.sroa.0.3, %n.vec4832
  %broadcast.splatinsert4833 = insertelement <2 x double> poison, double %.11.i4679, i64 0
  %broadcast.splat4834 = shufflevector <2 x double> %broadcast.splatinsert4833, <2 x double> poison, <2 x i32> zeroinitializer
  %115 = getelementptr double, ptr %28, i64 %.3226.sroa.0.3
  br label %vector.body4835

vector.body4835:                                  ; preds = %vector.body4835, %vector.ph4830
  %index4836 = phi i64 [ 0, %vector.ph4830 ], [ %index.next4838, %vector.body4835 ]
  %116 = getelementptr double, ptr %115, i64 %index4836
  %117 = getelementptr i8, ptr %116, i64 16
  store <2 x double> %broadcast.splat4834, ptr %116, align 8
  store <2 x double> %broadcast.splat4834, ptr %117, align 8
  %index.next4838 = add i64 %index4836, 4
  %118 = icmp eq i64 %index.next4838, %n.vec4832
  br i1 %118, label %middle.block4839, label %vector.body4835, !prof !155, !llvm.loop !200

middle.block4839:                                 ; preds = %vector.body4835
  %cmp.n4840 = icmp eq i64 %113, %n.vec4832
  br i1 %cmp.n4840, label %.3321.else.endif, label %.3320.endif.preheader4966, !prof !158

.3320.endif.preheader4966:                        ; preds = %.3320.endif.preheader, %middle.block4839
  %.3316.04749.ph = phi i64 [ %.3226.sroa.0.3, %.3320.endif.preheader ], [ %114, %middle.block4839 ]
  br label %.3320.endif

.3320.endif:                                      ; preds = %.3320.endif.preheader4966, %.3320.endif
  %.3316.04749 = phi i64 [ %.3364, %.3320.endif ], [ %.3316.04749.ph, %.3320.endif.preheader4966 ]
  %.3359 = getelementptr double, ptr %28, i64 %.3316.04749
  store double %.11.i4679, ptr %.3359, align 8
  %.3364 = add nsw i64 %.3316.04749, 1
  %exitcond4793.not = icmp eq i64 %.3364, %arg.lane.0.5.1
  br i1 %exitcond4793.not, label %.3321.else.endif, label %.3320.endif, !prof !159, !llvm.loop !201

.3321.else.endif:                                 ; preds = %.3320.endif, %middle.block4839, %.2977.endif.else.endif.endif.endif.if
  br i1 %.2065, label %.3321.endif.else.endif.if, label %.3321.endif.else.endif.endif.endif.if, !prof !36

.3321.endif.else.endif.if:                        ; preds = %.3321.else.endif
  br label %.3321.endif.else.endif.endif.endif.if

.3321.endif.else.endif.endif.endif.if:            ; preds = %.3321.endif.else.endif.if, %.3321.else.endif
  %.3569.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %.3321.endif.else.endif.if ], [ 0, %.3321.else.endif ]
  %.3693.not4750 = icmp slt i64 %.3569.sroa.0.3, %arg.lane.0.5.1
  br i1 %.3693.not4750, label %.3663.endif.preheader, label %.3664.else.endif, !prof !153

.3663.endif.preheader:                            ; preds = %.3321.endif.else.endif.endif.endif.if
  %119 = sub i64 %arg.lane.0.5.1, %.3569.sroa.0.3
  %min.iters.check4817 = icmp ult i64 %119, 4
  br i1 %min.iters.check4817, label %.3663.endif.preheader4965, label %vector.ph4818, !prof !154

vector.ph4818:                                    ; preds = %.3663.endif.preheader
  %n.vec4820 = and i64 %119, -4
  %120 = add i64 %.3569.sroa.0.3, %n.vec4820
  %121 = getelementptr double, ptr %29, i64 %.3569.sroa.0.3
  br label %vector.body4821

vector.body4821:                                  ; preds = %vector.body4821, %vector.ph4818
  %index4822 = phi i64 [ 0, %vector.ph4818 ], [ %index.next4824, %vector.body4821 ]
  %122 = getelementptr double, ptr %121, i64 %index4822
  %123 = getelementptr i8, ptr %122, i64 16
  store <2 x double> splat (double 1.000000e+00), ptr %122, align 8
  store <2 x double> splat (double 1.000000e+00), ptr %123, align 8
  %index.next4824 = add i64 %index4822, 4
  %124 = icmp eq i64 %index.next4824, %n.vec4820
  br i1 %124, label %middle.block4825, label %vector.body4821, !prof !155, !llvm.loop !202

middle.block4825:                                 ; preds = %vector.body4821
  %cmp.n4826 = icmp eq i64 %119, %n.vec4820
  br i1 %cmp.n4826, label %.3664.else.endif, label %.3663.endif.preheader4965, !prof !158

.3663.endif.preheader4965:                        ; preds = %.3663.endif.preheader, %middle.block4825
  %.3659.04751.ph = phi i64 [ %.3569.sroa.0.3, %.3663.endif.preheader ], [ %120, %middle.block4825 ]
  br label %.3663.endif

.3663.endif:                                      ; preds = %.3663.endif.preheader4965, %.3663.endif
  %.3659.04751 = phi i64 [ %.3707, %.3663.endif ], [ %.3659.04751.ph, %.3663.endif.preheader4965 ]
  %.3702 = getelementptr double, ptr %29, i64 %.3659.04751
  store double 1.000000e+00, ptr %.3702, align 8
  %.3707 = add nsw i64 %.3659.04751, 1
  %exitcond4794.not = icmp eq i64 %.3707, %arg.lane.0.5.1
  br i1 %exitcond4794.not, label %.3664.else.endif, label %.3663.endif, !prof !159, !llvm.loop !203

.3664.else.endif:                                 ; preds = %.3663.endif, %middle.block4825, %.3321.endif.else.endif.endif.endif.if
  br i1 %.3941, label %.3664.endif.else.endif.if, label %.3664.endif.else.endif.endif.endif.if, !prof !36

.3664.endif.else.endif.if:                        ; preds = %.3664.else.endif
  br label %.3664.endif.else.endif.endif.endif.if

.3664.endif.else.endif.endif.endif.if:            ; preds = %.3664.endif.else.endif.if, %.3664.else.endif
  %.3913.sroa.0.3 = phi i64 [ %arg.lane.1.5.1, %.3664.endif.else.endif.if ], [ 0, %.3664.else.endif ]
  %.4037.not4752 = icmp slt i64 %.3913.sroa.0.3, %arg.lane.1.5.1
  br i1 %.4037.not4752, label %.4007.endif.preheader, label %.4008.else.endif, !prof !153

.4007.endif.preheader:                            ; preds = %.3664.endif.else.endif.endif.endif.if
  %125 = sub i64 %arg.lane.1.5.1, %.3913.sroa.0.3
  %min.iters.check4806 = icmp ult i64 %125, 4
  br i1 %min.iters.check4806, label %.4007.endif.preheader4964, label %vector.ph4807, !prof !154

vector.ph4807:                                    ; preds = %.4007.endif.preheader
  %n.vec4809 = and i64 %125, -4
  %126 = add i64 %.3913.sroa.0.3, %n.vec4809
  %127 = getelementptr i64, ptr %30, i64 %.3913.sroa.0.3
  br label %vector.body4810

vector.body4810:                                  ; preds = %vector.body4810, %vector.ph4807
  %index4811 = phi i64 [ 0, %vector.ph4807 ], [ %index.next4812, %vector.body4810 ]
  %128 = getelementptr i64, ptr %127, i64 %index4811
  %129 = getelementptr i8, ptr %128, i64 16
  store <2 x i64> %broadcast.splat, ptr %128, align 8
  store <2 x i64> %broadcast.splat, ptr %129, align 8
  %index.next4812 = add i64 %index4811, 4
  %130 = icmp eq i64 %index.next4812, %n.vec4809
  br i1 %130, label %middle.block4813, label %vector.body4810, !prof !155, !llvm.loop !204

middle.block4813:                                 ; preds = %vector.body4810
  %cmp.n4814 = icmp eq i64 %125, %n.vec4809
  br i1 %cmp.n4814, label %.4008.else.endif, label %.4007.endif.preheader4964, !prof !158

.4007.endif.preheader4964:                        ; preds = %.4007.endif.preheader, %middle.block4813
  %.4003.04753.ph = phi i64 [ %.3913.sroa.0.3, %.4007.endif.preheader ], [ %126, %middle.block4813 ]
  br label %.4007.endif

.4007.endif:                                      ; preds = %.4007.endif.preheader4964, %.4007.endif
  %.4003.04753 = phi i64 [ %.4051, %.4007.endif ], [ %.4003.04753.ph, %.4007.endif.preheader4964 ]
  %.4046 = getelementptr i64, ptr %30, i64 %.4003.04753
  store i64 %edge.2.1, ptr %.4046, align 8
  %.4051 = add nsw i64 %.4003.04753, 1
  %exitcond4795.not = icmp eq i64 %.4051, %arg.lane.1.5.1
  br i1 %exitcond4795.not, label %.4008.else.endif, label %.4007.endif, !prof !159, !llvm.loop !205

.4008.else.endif:                                 ; preds = %.4007.endif, %middle.block4813, %.3664.endif.else.endif.endif.endif.if
  br i1 %.3941, label %.4008.endif.else.endif.if, label %.4008.endif.else.endif.endif.endif.if, !prof !36

.4008.endif.else.endif.if:                        ; preds = %.4008.else.endif
  br label %.4008.endif.else.endif.endif.endif.if

.4008.endif.else.endif.endif.endif.if:            ; preds = %.4008.endif.else.endif.if, %.4008.else.endif
  %.4256.sroa.0.3 = phi i64 [ %arg.lane.1.5.1, %.4008.endif.else.endif.if ], [ 0, %.4008.else.endif ]
  %.4380.not4754 = icmp slt i64 %.4256.sroa.0.3, %arg.lane.1.5.1
  br i1 %.4380.not4754, label %.4350.endif.preheader, label %.4350.if, !prof !153

.4350.endif.preheader:                            ; preds = %.4008.endif.else.endif.endif.endif.if
  %131 = shl i64 %.4256.sroa.0.3, 3
  %scevgep4796 = getelementptr i8, ptr %scevgep, i64 %131
  %132 = sub i64 %arg.lane.1.5.1, %.4256.sroa.0.3
  %133 = shl i64 %132, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %scevgep4796, i8 0, i64 %133, i1 false)
  br label %.4350.if

.4350.if:                                         ; preds = %.4350.endif.preheader, %.4008.endif.else.endif.endif.endif.if
  br i1 %.4101855.not.i, label %B1384, label %B110.if.i

B46.i.i4684:                                      ; preds = %B110.if.i
  %.135.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !206
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i4686, label %B358.i4685

B80.i.i4686:                                      ; preds = %B46.i.i4684
  %.196.i.i = getelementptr double, ptr %31, i64 %.352.01856.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !206
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B358.i4685, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i4686
  %.264.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.352.01856.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !206
  %.321.i.i = getelementptr double, ptr %32, i64 %.352.01856.i
  %.322.i.i = load double, ptr %.321.i.i, align 8, !noalias !206
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.1468
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01858.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01858.i
  br i1 %brmerge.i, label %B358.i4685, label %B300.if.lr.ph.i

B300.if.lr.ph.i:                                  ; preds = %B122.i.i
  %.650.i = getelementptr i64, ptr %33, i64 %.352.01856.i
  %.651.i = load i64, ptr %.650.i, align 8, !noalias !211
  %.652.i = add nsw i64 %.651.i, 1
  %134 = getelementptr i64, ptr %arg.runs.2.4, i64 %.99.i.i
  %.596.i = load i64, ptr %134, align 8, !noalias !211
  %.822.i = icmp slt i64 %.596.i, 0
  %.823.i = select i1 %.822.i, i64 %arg.schedule.3.5.0, i64 0
  %.824.i = add i64 %.823.i, %.596.i
  %.825.i = icmp slt i64 %.651.i, -1
  %.826.i = select i1 %.825.i, i64 %arg.schedule.3.5.1, i64 0
  %.827.i = add i64 %.652.i, %.826.i
  %.854.i4687 = mul i64 %.852.i4683, %.824.i
  %.856.i = mul i64 %.827.i, %arg.schedule.3.5.2
  %135 = getelementptr double, ptr %arg.schedule.3.4, i64 %.854.i4687
  %136 = getelementptr double, ptr %135, i64 %.856.i
  br label %B300.if.i

B358.i4685:                                       ; preds = %B300.if.i, %B110.if.i, %B122.i.i, %B80.i.i4686, %B46.i.i4684
  %some.3.2.i = phi i1 [ %some.2.01858.i, %B80.i.i4686 ], [ %some.2.01858.mux.i, %B122.i.i ], [ %some.2.01858.i, %B46.i.i4684 ], [ %some.2.01858.i, %B110.if.i ], [ true, %B300.if.i ]
  %exitcond1870.not.i = icmp eq i64 %arg.shape.0, %.423.i
  br i1 %exitcond1870.not.i, label %B360.i, label %B110.if.i

B360.i:                                           ; preds = %B358.i4685
  br i1 %some.3.2.i, label %B368.i, label %B1384

B368.i:                                           ; preds = %B360.i
  %.1018.i = load i64, ptr %.2211, align 8, !noalias !211
  %.1130.i = inttoptr i64 %.1018.i to ptr
  tail call void %.1130.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !211
  %.1161.i = load i64, ptr %.1160.i, align 8, !noalias !211
  %.1277.i = inttoptr i64 %.1161.i to ptr
  tail call void %.1277.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1276.i), !noalias !211
  br label %B600.if.i

B46.i82.i:                                        ; preds = %B600.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !212
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B980.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %31, i64 %.1303.01865.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !212
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B980.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1303.01865.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !212
  %.321.i223.i = getelementptr double, ptr %32, i64 %.1303.01865.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !212
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B980.i, label %B640.i

B640.i:                                           ; preds = %B122.i147.i
  %.1557.i = getelementptr i64, ptr %34, i64 %.1303.01865.i
  %.1558.i = load i64, ptr %.1557.i, align 8, !noalias !211
  %.1569.i = icmp sgt i64 %.1558.i, 0
  br i1 %.1569.i, label %B716.i, label %B770.i

B716.i:                                           ; preds = %B640.i
  %137 = getelementptr double, ptr %arg.times.4, i64 %.1558.i
  %.1604.i = getelementptr i8, ptr %137, i64 -8
  %.1605.i = load double, ptr %.1604.i, align 8, !noalias !211
  %.1661.i = fcmp oeq double %.1605.i, %.265.i185.i
  br label %B770.i

B770.i:                                           ; preds = %B716.i, %B640.i
  %"$phi770.1.2.1.i" = phi i1 [ %.1661.i, %B716.i ], [ false, %B640.i ]
  br i1 %.17571859.not.i, label %B980.i, label %B802.if.lr.ph.i

B802.if.lr.ph.i:                                  ; preds = %B770.i
  %.1887.i = add nsw i64 %.1558.i, -1
  %.1926.i = select i1 %.1569.i, i64 0, i64 %arg.results.0.5.1
  %.1927.i = add i64 %.1887.i, %.1926.i
  %.1954.i = mul i64 %.1952.i, %.99.i78.i
  %.1956.i = mul i64 %.1927.i, %arg.results.0.5.2
  %138 = getelementptr double, ptr %arg.results.0.4, i64 %.1954.i
  %139 = getelementptr double, ptr %138, i64 %.1956.i
  %invariant.gep = getelementptr double, ptr %arg.arrays.0.4, i64 %.1303.01865.i
  %invariant.gep4756 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1303.01865.i
  br label %B802.if.i

B898.i:                                           ; preds = %B802.if.i
  %140 = getelementptr double, ptr %139, i64 %.1701.01860.i
  store double %.1835.i, ptr %140, align 8, !noalias !211
  br label %B920.i

B920.i:                                           ; preds = %B802.if.i, %B898.i
  %exitcond1871.not.i = icmp eq i64 %arg.shape.1, %.1770.i
  br i1 %exitcond1871.not.i, label %B922.loopexit.i, label %B802.if.i

B922.loopexit.i:                                  ; preds = %B920.i
  %141 = fcmp une double %.1842.i, 0.000000e+00
  br i1 %141, label %B934.i, label %B980.i

B934.i:                                           ; preds = %B922.loopexit.i
  %.84.i516.i = load i64, ptr %147, align 8, !noalias !215
  %.89.i518.i = icmp sgt i64 %.84.i516.i, -1
  br i1 %.89.i518.i, label %B46.i521.i, label %B980.i

B46.i521.i:                                       ; preds = %B934.i
  %.120.i539.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i516.i
  %.121.i540.i = load i64, ptr %.120.i539.i, align 8, !noalias !215
  %.122.i541.i = icmp eq i64 %.121.i540.i, 0
  br i1 %.122.i541.i, label %B80.i545.i, label %B980.i

B80.i545.i:                                       ; preds = %B46.i521.i
  store i64 3, ptr %.120.i539.i, align 8, !noalias !215
  br label %B980.i

B980.i:                                           ; preds = %B600.if.i, %B80.i545.i, %B46.i521.i, %B934.i, %B922.loopexit.i, %B770.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %exitcond1872.not.i = icmp eq i64 %arg.shape.0, %.1372.i
  br i1 %exitcond1872.not.i, label %B982.i, label %B600.if.i

B982.i:                                           ; preds = %B980.i
  br i1 %.2041.not.i, label %B1384, label %B986.i

B986.i:                                           ; preds = %B982.i
  %.2074.i = load i64, ptr %.2073.i, align 8, !noalias !211
  %.2188.i = inttoptr i64 %.2074.i to ptr
  tail call void %.2188.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !211
  br label %B1106.if.i

B46.i315.i:                                       ; preds = %B1106.if.i
  %.135.i335.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i311.i
  %.136.i336.i = load i64, ptr %.135.i335.i, align 8, !noalias !218
  %.141.i339.not.i = icmp eq i64 %.136.i336.i, 0
  br i1 %.141.i339.not.i, label %B80.i340.i, label %B1228.i

B80.i340.i:                                       ; preds = %B46.i315.i
  %.196.i377.i = getelementptr double, ptr %31, i64 %.2224.01868.i
  %.197.i378.i = load double, ptr %.196.i377.i, align 8, !noalias !218
  %.198.i379.i = fcmp olt double %.197.i378.i, 5.000000e-01
  br i1 %.198.i379.i, label %B1228.i, label %B122.i380.i

B122.i380.i:                                      ; preds = %B80.i340.i
  %.264.i417.i = getelementptr double, ptr %arg.lane.0.4, i64 %.2224.01868.i
  %.265.i418.i = load double, ptr %.264.i417.i, align 8, !noalias !218
  %.321.i456.i = getelementptr double, ptr %32, i64 %.2224.01868.i
  %.322.i457.i = load double, ptr %.321.i456.i, align 8, !noalias !218
  %.325.i459.i = fcmp une double %.265.i418.i, %.322.i457.i
  br i1 %.325.i459.i, label %B1228.i, label %B1146.i

B1146.i:                                          ; preds = %B122.i380.i
  %142 = getelementptr double, ptr %arg.arrays.4.4, i64 %.2224.01868.i
  %.2400.i = load double, ptr %142, align 8, !noalias !211
  %.2402.i = fcmp olt double %.2400.i, -1.000000e-09
  br i1 %.2402.i, label %B80.i672.i, label %B1228.i

B80.i672.i:                                       ; preds = %B1146.i
  store i64 4, ptr %.135.i335.i, align 8, !noalias !221
  br label %B1228.i

B1228.i:                                          ; preds = %B1106.if.i, %B80.i672.i, %B1146.i, %B122.i380.i, %B80.i340.i, %B46.i315.i
  %exitcond4797.not = icmp eq i64 %arg.shape.0, %.2293.i
  br i1 %exitcond4797.not, label %B1384, label %B1106.if.i

B110.if.i:                                        ; preds = %.4350.if, %B358.i4685
  %some.2.01858.i = phi i1 [ %some.3.2.i, %B358.i4685 ], [ false, %.4350.if ]
  %.352.01856.i = phi i64 [ %.423.i, %B358.i4685 ], [ 0, %.4350.if ]
  %.423.i = add nsw i64 %.352.01856.i, 1
  %143 = getelementptr i64, ptr %arg.lane.1.4, i64 %.352.01856.i
  %.99.i.i = load i64, ptr %143, align 8, !noalias !206
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B358.i4685, label %B46.i.i4684

B300.if.i:                                        ; preds = %B300.if.i, %B300.if.lr.ph.i
  %.692.01853.i = phi i64 [ 0, %B300.if.lr.ph.i ], [ %.764.i, %B300.if.i ]
  %.764.i = add nsw i64 %.692.01853.i, 1
  %144 = getelementptr double, ptr %136, i64 %.692.01853.i
  %.861.i = load double, ptr %144, align 8, !noalias !211
  %145 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.692.01853.i
  %.891.i = load i64, ptr %145, align 8, !noalias !211
  %.893.i = mul nsw i64 %.891.i, %arg.shape.0
  %.895.i = add nsw i64 %.893.i, %.352.01856.i
  %.909.i = icmp slt i64 %.895.i, 0
  %.910.i = select i1 %.909.i, i64 %arg.arrays.1.5.0, i64 0
  %146 = getelementptr double, ptr %arg.arrays.1.4, i64 %.895.i
  %.924.i = getelementptr double, ptr %146, i64 %.910.i
  store double %.861.i, ptr %.924.i, align 8, !noalias !211
  %exitcond.not.i4688 = icmp eq i64 %arg.schedule.2.5.0, %.764.i
  br i1 %exitcond.not.i4688, label %B358.i4685, label %B300.if.i

B600.if.i:                                        ; preds = %B980.i, %B368.i
  %.1303.01865.i = phi i64 [ 0, %B368.i ], [ %.1372.i, %B980.i ]
  %.1372.i = add nsw i64 %.1303.01865.i, 1
  %147 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1303.01865.i
  %.99.i78.i = load i64, ptr %147, align 8, !noalias !212
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B980.i, label %B46.i82.i

B802.if.i:                                        ; preds = %B920.i, %B802.if.lr.ph.i
  %trouble.2.11862.i = phi double [ 0.000000e+00, %B802.if.lr.ph.i ], [ %.1842.i, %B920.i ]
  %.1701.01860.i = phi i64 [ 0, %B802.if.lr.ph.i ], [ %.1770.i, %B920.i ]
  %.1770.i = add nsw i64 %.1701.01860.i, 1
  %.1801.i = add nsw i64 %.1701.01860.i, %.1231.i
  %.1803.i = mul nsw i64 %.1801.i, %arg.shape.0
  %gep = getelementptr double, ptr %invariant.gep, i64 %.1803.i
  %.1835.i = load double, ptr %gep, align 8, !noalias !211
  %.1840.i = fmul double %.1835.i, 0.000000e+00
  %.1842.i = fadd double %trouble.2.11862.i, %.1840.i
  %.1850.i = mul nsw i64 %.1701.01860.i, %arg.shape.0
  %gep4757 = getelementptr double, ptr %invariant.gep4756, i64 %.1850.i
  store double %.1835.i, ptr %gep4757, align 8, !noalias !211
  br i1 %"$phi770.1.2.1.i", label %B898.i, label %B920.i

B1106.if.i:                                       ; preds = %B1228.i, %B986.i
  %.2224.01868.i = phi i64 [ 0, %B986.i ], [ %.2293.i, %B1228.i ]
  %.2293.i = add nsw i64 %.2224.01868.i, 1
  %148 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2224.01868.i
  %.99.i311.i = load i64, ptr %148, align 8, !noalias !218
  %.104.i314.i = icmp slt i64 %.99.i311.i, 0
  br i1 %.104.i314.i, label %B1228.i, label %B46.i315.i

B1606.if:                                         ; preds = %B1576, %B1706
  %.4794.04761 = phi i64 [ %.4863, %B1706 ], [ 0, %B1576 ]
  %.4863 = add nsw i64 %.4794.04761, 1
  %.4893 = add nsw i64 %.4794.04761, %.463.sroa.0.04769
  %.4921 = icmp slt i64 %.4893, 0
  %.4922 = select i1 %.4921, i64 %arg.results.3.5.0, i64 0
  %.4923 = add i64 %.4922, %.4893
  %.4943 = mul i64 %.4923, %arg.results.3.5.1
  %149 = getelementptr i64, ptr %arg.results.3.4, i64 %.4943
  %.4947 = getelementptr i8, ptr %149, i64 16
  store i64 %edge.4.2, ptr %.4947, align 8
  %.4966 = select i1 %.4921, i64 %arg.results.1.5.0, i64 0
  %150 = getelementptr i64, ptr %arg.results.1.4, i64 %.4893
  %.4980 = getelementptr i64, ptr %150, i64 %.4966
  %.4981 = load i64, ptr %.4980, align 8
  %.4982 = icmp eq i64 %.4981, 0
  br i1 %.4982, label %B1680, label %B1706
}

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.ceil.f64(double)

; Function Attrs: nocallback nofree nounwind willreturn memory(argmem: write)
declare void @llvm.memset.p0.i64(ptr, i8, i64, i1)

define dso_local noundef i32 @signals_at(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, ptr readnone %arg.times.0, ptr readnone %arg.times.1, i64 %arg.times.2, i64 %arg.times.3, ptr readonly %arg.times.4, i64 %arg.times.5.0, i64 %arg.times.6.0, ptr readnone %arg.states.0, ptr readnone %arg.states.1, i64 %arg.states.2, i64 %arg.states.3, ptr %arg.states.4, i64 %arg.states.5.0, i64 %arg.states.6.0, i64 %arg.n, ptr readnone %arg.pieces.0, ptr readnone %arg.pieces.1, i64 %arg.pieces.2, i64 %arg.pieces.3, ptr readonly %arg.pieces.4, i64 %arg.pieces.5.0, i64 %arg.pieces.6.0, ptr readnone %arg.places.0, ptr readnone %arg.places.1, i64 %arg.places.2, i64 %arg.places.3, ptr readonly %arg.places.4, i64 %arg.places.5.0, i64 %arg.places.6.0, ptr readnone %arg.values.0, ptr readnone %arg.values.1, i64 %arg.values.2, i64 %arg.values.3, ptr readonly %arg.values.4, i64 %arg.values.5.0, i64 %arg.values.5.1, i64 %arg.values.6.0, i64 %arg.values.6.1, ptr readnone %arg.t.0, ptr readnone %arg.t.1, i64 %arg.t.2, i64 %arg.t.3, ptr %arg.t.4, i64 %arg.t.5.0, i64 %arg.t.6.0, ptr readnone %arg.P.0, ptr readnone %arg.P.1, i64 %arg.P.2, i64 %arg.P.3, ptr %arg.P.4, i64 %arg.P.5.0, i64 %arg.P.6.0, ptr readnone %arg.T.0, ptr readnone %arg.T.1, i64 %arg.T.2, i64 %arg.T.3, ptr %arg.T.4, i64 %arg.T.5.0, i64 %arg.T.6.0, ptr readnone %arg.W.0, ptr readnone %arg.W.1, i64 %arg.W.2, i64 %arg.W.3, ptr %arg.W.4, i64 %arg.W.5.0, i64 %arg.W.6.0, ptr readnone %arg.out.0, ptr readnone %arg.out.1, i64 %arg.out.2, i64 %arg.out.3, ptr %arg.out.4, i64 %arg.out.5.0, i64 %arg.out.5.1, i64 %arg.out.6.0, i64 %arg.out.6.1) local_unnamed_addr {
entry:
  %.230536.not = icmp slt i64 %arg.times.5.0, 1
  br i1 %.230536.not, label %B464, label %B64.if.lr.ph

B64.if.lr.ph:                                     ; preds = %entry
  %arg.out.4542 = ptrtoint ptr %arg.out.4 to i64
  %arg.W.4543 = ptrtoint ptr %arg.W.4 to i64
  %.497530.not = icmp slt i64 %arg.places.5.0, 1
  %.684 = getelementptr i8, ptr %arg.code.4, i64 8
  %.764 = getelementptr i8, ptr %arg.code.4, i64 24
  %.907533.not = icmp slt i64 %arg.out.5.1, 1
  %0 = sub i64 %arg.out.4542, %arg.W.4543
  %1 = shl i64 %arg.out.5.1, 3
  %min.iters.check = icmp ult i64 %arg.out.5.1, 4
  %n.vec = and i64 %arg.out.5.1, 9223372036854775804
  %cmp.n = icmp eq i64 %arg.out.5.1, %n.vec
  br label %B64.if

B64.loopexit:                                     ; preds = %B430.if, %middle.block, %B304
  %exitcond541.not = icmp eq i64 %.243, %arg.times.5.0
  br i1 %exitcond541.not, label %B464, label %B64.if

B114:                                             ; preds = %B64.if
  br i1 %.497530.not, label %B230, label %B186.if.lr.ph

B186.if.lr.ph:                                    ; preds = %B114
  %.558 = icmp slt i64 %.366, 0
  %.559 = select i1 %.558, i64 %arg.values.5.0, i64 0
  %.560 = add i64 %.559, %.366
  %.580 = mul i64 %.560, %arg.values.5.1
  %2 = getelementptr double, ptr %arg.values.4, i64 %.580
  br label %B186.if

B230:                                             ; preds = %B186.if, %B114
  %.685 = load i64, ptr %.684, align 8
  %.688 = mul nsw i64 %.172.0537, %arg.n
  %.707 = getelementptr double, ptr %arg.states.4, i64 %.688
  %.733 = inttoptr i64 %.685 to ptr
  tail call void %.733(ptr nonnull %arg.t.4, ptr %.707, ptr %arg.P.4, ptr %arg.T.4, ptr %arg.W.4, ptr %arg.W.4)
  br label %B304

B304:                                             ; preds = %B230, %B64.if
  %piece.3.1 = phi i64 [ %.366, %B230 ], [ %piece.2.0539, %B64.if ]
  %.765 = load i64, ptr %.764, align 8
  %.768 = mul nsw i64 %.172.0537, %arg.n
  %.787 = getelementptr double, ptr %arg.states.4, i64 %.768
  %.813 = inttoptr i64 %.765 to ptr
  tail call void %.813(ptr nonnull %arg.t.4, ptr %.787, ptr %arg.P.4, ptr %arg.T.4, ptr %arg.W.4, ptr %arg.W.4)
  br i1 %.907533.not, label %B64.loopexit, label %B430.if.lr.ph

B430.if.lr.ph:                                    ; preds = %B304
  %.1020 = mul i64 %.172.0537, %arg.out.5.1
  %3 = getelementptr double, ptr %arg.out.4, i64 %.1020
  %diff.check = icmp ult i64 %10, 32
  %or.cond = select i1 %min.iters.check, i1 true, i1 %diff.check
  br i1 %or.cond, label %B430.if.preheader, label %vector.body

vector.body:                                      ; preds = %B430.if.lr.ph, %vector.body
  %index = phi i64 [ %index.next, %vector.body ], [ 0, %B430.if.lr.ph ]
  %4 = getelementptr double, ptr %arg.W.4, i64 %index
  %5 = getelementptr i8, ptr %4, i64 16
  %wide.load = load <2 x double>, ptr %4, align 8
  %wide.load544 = load <2 x double>, ptr %5, align 8
  %6 = getelementptr double, ptr %3, i64 %index
  %7 = getelementptr i8, ptr %6, i64 16
  store <2 x double> %wide.load, ptr %6, align 8
  store <2 x double> %wide.load544, ptr %7, align 8
  %index.next = add i64 %index, 4
  %8 = icmp eq i64 %index.next, %n.vec
  br i1 %8, label %middle.block, label %vector.body, !llvm.loop !224

middle.block:                                     ; preds = %vector.body
  br i1 %cmp.n, label %B64.loopexit, label %B430.if.preheader

B430.if.preheader:                                ; preds = %B430.if.lr.ph, %middle.block
  %.851.0534.ph = phi i64 [ 0, %B430.if.lr.ph ], [ %n.vec, %middle.block ]
  br label %B430.if

B464:                                             ; preds = %B64.loopexit, %entry
  store ptr null, ptr %retptr, align 8
  ret i32 0

B64.if:                                           ; preds = %B64.if.lr.ph, %B64.loopexit
  %piece.2.0539 = phi i64 [ -1, %B64.if.lr.ph ], [ %piece.3.1, %B64.loopexit ]
  %.172.0537 = phi i64 [ 0, %B64.if.lr.ph ], [ %.243, %B64.loopexit ]
  %9 = mul i64 %1, %.172.0537
  %10 = add i64 %0, %9
  %.243 = add nsw i64 %.172.0537, 1
  %11 = getelementptr double, ptr %arg.times.4, i64 %.172.0537
  %.305 = load double, ptr %11, align 8
  store double %.305, ptr %arg.t.4, align 8
  %12 = getelementptr i64, ptr %arg.pieces.4, i64 %.172.0537
  %.366 = load i64, ptr %12, align 8
  %.368.not = icmp eq i64 %.366, %piece.2.0539
  br i1 %.368.not, label %B304, label %B114

B186.if:                                          ; preds = %B186.if.lr.ph, %B186.if
  %.441.0531 = phi i64 [ 0, %B186.if.lr.ph ], [ %.510, %B186.if ]
  %.510 = add nsw i64 %.441.0531, 1
  %13 = getelementptr double, ptr %2, i64 %.441.0531
  %.585 = load double, ptr %13, align 8
  %14 = getelementptr i64, ptr %arg.places.4, i64 %.441.0531
  %.615 = load i64, ptr %14, align 8
  %.629 = icmp slt i64 %.615, 0
  %.630 = select i1 %.629, i64 %arg.P.5.0, i64 0
  %15 = getelementptr double, ptr %arg.P.4, i64 %.615
  %.644 = getelementptr double, ptr %15, i64 %.630
  store double %.585, ptr %.644, align 8
  %exitcond.not = icmp eq i64 %arg.places.5.0, %.510
  br i1 %exitcond.not, label %B230, label %B186.if

B430.if:                                          ; preds = %B430.if.preheader, %B430.if
  %.851.0534 = phi i64 [ %.920, %B430.if ], [ %.851.0534.ph, %B430.if.preheader ]
  %.920 = add nsw i64 %.851.0534, 1
  %16 = getelementptr double, ptr %arg.W.4, i64 %.851.0534
  %.974 = load double, ptr %16, align 8
  %17 = getelementptr double, ptr %3, i64 %.851.0534
  store double %.974, ptr %17, align 8
  %exitcond540.not = icmp eq i64 %arg.out.5.1, %.920
  br i1 %exitcond540.not, label %B64.loopexit, label %B430.if, !llvm.loop !225
}


!0 = !{!1, !3, !5}
!1 = distinct !{!1, !2, !"_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!2 = distinct !{!2, !"_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!3 = distinct !{!3, !4, !"_ZN12clpt_control6native9for_numba5startB2v2B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!4 = distinct !{!4, !"_ZN12clpt_control6native9for_numba5startB2v2B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!5 = distinct !{!5, !4, !"_ZN12clpt_control6native9for_numba5startB2v2B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!6 = distinct !{!6, !7, !8}
!7 = !{!"llvm.loop.isvectorized", i32 1}
!8 = !{!"llvm.loop.unroll.runtime.disable"}
!9 = !{!10, !12, !1, !3, !5}
!10 = distinct !{!10, !11, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!11 = distinct !{!11, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!12 = distinct !{!12, !11, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!13 = distinct !{!13, !7}
!14 = !{!3, !5}
!15 = !{!16, !18}
!16 = distinct !{!16, !17, !"_ZN12clpt_control6native9for_numba6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!17 = distinct !{!17, !"_ZN12clpt_control6native9for_numba6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!18 = distinct !{!18, !17, !"_ZN12clpt_control6native9for_numba6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!19 = !{!20, !22}
!20 = distinct !{!20, !21, !"_ZN12clpt_control6native9for_numba5beginB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!21 = distinct !{!21, !"_ZN12clpt_control6native9for_numba5beginB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!22 = distinct !{!22, !21, !"_ZN12clpt_control6native9for_numba5beginB2v6B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!23 = !{!24, !20, !22}
!24 = distinct !{!24, !25, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!25 = distinct !{!25, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!26 = !{!27, !20, !22}
!27 = distinct !{!27, !28, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!28 = distinct !{!28, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!29 = !{!"branch_weights", i32 99, i32 1}
!30 = !{!31, !33, !34}
!31 = distinct !{!31, !32, !"_ZN12clpt_control6native9for_numba13differentiateB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!32 = distinct !{!32, !"_ZN12clpt_control6native9for_numba13differentiateB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!33 = distinct !{!33, !32, !"_ZN12clpt_control6native9for_numba13differentiateB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!34 = distinct !{!34, !35, !"_ZN12clpt_control6native9for_numba9lineariseB2v9B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!35 = distinct !{!35, !"_ZN12clpt_control6native9for_numba9lineariseB2v9B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!36 = !{!"branch_weights", i32 1, i32 99}
!37 = distinct !{!37, !7, !8}
!38 = !{!39, !41, !31, !33, !34}
!39 = distinct !{!39, !40, !"_ZN12clpt_control6native9for_numba14by_differencesB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!40 = distinct !{!40, !"_ZN12clpt_control6native9for_numba14by_differencesB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!41 = distinct !{!41, !40, !"_ZN12clpt_control6native9for_numba14by_differencesB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!42 = distinct !{!42, !7, !8}
!43 = distinct !{!43, !7}
!44 = !{!"branch_weights", i32 199, i32 9801}
!45 = distinct !{!45, !7, !8}
!46 = distinct !{!46, !7}
!47 = distinct !{!47, !7}
!48 = !{!34}
!49 = !{!50, !34}
!50 = distinct !{!50, !51, !"_ZN12clpt_control6native16linear_equations6factorB3v15B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!51 = distinct !{!51, !"_ZN12clpt_control6native16linear_equations6factorB3v15B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!52 = !{!53}
!53 = distinct !{!53, !54, !"_ZN12clpt_control6native9for_numba11solve_stageB3v16B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!54 = distinct !{!54, !"_ZN12clpt_control6native9for_numba11solve_stageB3v16B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!55 = !{!56, !58, !53}
!56 = distinct !{!56, !57, !"_ZN12clpt_control6native16linear_equations5solveB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!57 = distinct !{!57, !"_ZN12clpt_control6native16linear_equations5solveB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!58 = distinct !{!58, !57, !"_ZN12clpt_control6native16linear_equations5solveB3v17B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!59 = !{!60}
!60 = distinct !{!60, !61, !"_ZN12clpt_control6native9for_numba4failB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_282_29: %retptr"}
!61 = distinct !{!61, !"_ZN12clpt_control6native9for_numba4failB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_282_29"}
!62 = !{!63, !65}
!63 = distinct !{!63, !64, !"_ZN12clpt_control6native9for_numba6passesB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!64 = distinct !{!64, !"_ZN12clpt_control6native9for_numba6passesB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!65 = distinct !{!65, !64, !"_ZN12clpt_control6native9for_numba6passesB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!66 = !{!67, !69, !63, !65}
!67 = distinct !{!67, !68, !"_ZN12clpt_control6native9for_numba6passedB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!68 = distinct !{!68, !"_ZN12clpt_control6native9for_numba6passedB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!69 = distinct !{!69, !68, !"_ZN12clpt_control6native9for_numba6passedB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!70 = !{!71}
!71 = distinct !{!71, !72, !"_ZN12clpt_control6native9for_numba5crossB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!72 = distinct !{!72, !"_ZN12clpt_control6native9for_numba5crossB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!73 = !{!74, !76, !71}
!74 = distinct !{!74, !75, !"_ZN12clpt_control6native9for_numba6passedB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!75 = distinct !{!75, !"_ZN12clpt_control6native9for_numba6passedB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!76 = distinct !{!76, !75, !"_ZN12clpt_control6native9for_numba6passedB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!77 = !{!78, !80, !71}
!78 = distinct !{!78, !79, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!79 = distinct !{!79, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!80 = distinct !{!80, !79, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!81 = distinct !{!81, !7, !8}
!82 = distinct !{!82, !7}
!83 = !{!84}
!84 = distinct !{!84, !85, !"_ZN12clpt_control6native9for_numba5watchB3v26B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!85 = distinct !{!85, !"_ZN12clpt_control6native9for_numba5watchB3v26B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!86 = !{!87, !84}
!87 = distinct !{!87, !88, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!88 = distinct !{!88, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!89 = !{!90, !92, !84}
!90 = distinct !{!90, !91, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!91 = distinct !{!91, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!92 = distinct !{!92, !91, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!93 = distinct !{!93, !7, !8}
!94 = distinct !{!94, !7}
!95 = !{!96}
!96 = distinct !{!96, !97, !"_ZN12clpt_control6native9for_numba6sampleB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!97 = distinct !{!97, !"_ZN12clpt_control6native9for_numba6sampleB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!98 = !{!99, !101, !96}
!99 = distinct !{!99, !100, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!100 = distinct !{!100, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!101 = distinct !{!101, !100, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!102 = !{!103, !105}
!103 = distinct !{!103, !104, !"_ZN12clpt_control6native9for_numba11decide_anewB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!104 = distinct !{!104, !"_ZN12clpt_control6native9for_numba11decide_anewB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!105 = distinct !{!105, !104, !"_ZN12clpt_control6native9for_numba11decide_anewB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!106 = !{!107, !103, !105}
!107 = distinct !{!107, !108, !"_ZN12clpt_control6native9for_numba4failB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29: %retptr"}
!108 = distinct !{!108, !"_ZN12clpt_control6native9for_numba4failB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29"}
!109 = !{!110, !112}
!110 = distinct !{!110, !111, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!111 = distinct !{!111, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!112 = distinct !{!112, !113, !"_ZN12clpt_control6native9for_numba4leapB3v30B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx: %retptr"}
!113 = distinct !{!113, !"_ZN12clpt_control6native9for_numba4leapB3v30B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx"}
!114 = !{!112}
!115 = !{!116, !112}
!116 = distinct !{!116, !117, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!117 = distinct !{!117, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!118 = !{!119, !112}
!119 = distinct !{!119, !120, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!120 = distinct !{!120, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!121 = !{!122, !112}
!122 = distinct !{!122, !123, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!123 = distinct !{!123, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!124 = !{!125, !112}
!125 = distinct !{!125, !126, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!126 = distinct !{!126, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!127 = !{!128, !130}
!128 = distinct !{!128, !129, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!129 = distinct !{!129, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!130 = distinct !{!130, !129, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!131 = !{!132}
!132 = distinct !{!132, !133, !"_ZN12clpt_control6native9for_numba4failB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29: %retptr"}
!133 = distinct !{!133, !"_ZN12clpt_control6native9for_numba4failB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29"}
!134 = !{!135, !137}
!135 = distinct !{!135, !136, !"_ZN12clpt_control6native9for_numba5enterB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!136 = distinct !{!136, !"_ZN12clpt_control6native9for_numba5enterB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!137 = distinct !{!137, !136, !"_ZN12clpt_control6native9for_numba5enterB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!138 = !{!139}
!139 = distinct !{!139, !140, !"_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!140 = distinct !{!140, !"_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!141 = distinct !{!141, !7, !8}
!142 = !{!143, !145, !139}
!143 = distinct !{!143, !144, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!144 = distinct !{!144, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!145 = distinct !{!145, !144, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!146 = distinct !{!146, !7}
!147 = !{!148}
!148 = distinct !{!148, !149, !"_ZN12clpt_control6native9for_numba4keepB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!149 = distinct !{!149, !"_ZN12clpt_control6native9for_numba4keepB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!150 = distinct !{!150, !7, !8}
!151 = distinct !{!151, !7}
!152 = !{i1 true}
!153 = !{!"branch_weights", i32 127, i32 1}
!154 = !{!"branch_weights", i32 1, i32 127}
!155 = !{!"branch_weights", i32 127, i32 3048}
!156 = distinct !{!156, !7, !8, !157}
!157 = !{!"llvm.loop.estimated_trip_count", i32 25}
!158 = !{!"branch_weights", i32 1, i32 3}
!159 = !{!"branch_weights", i32 1, i32 0}
!160 = distinct !{!160, !8, !7, !161}
!161 = !{!"llvm.loop.estimated_trip_count", i32 0}
!162 = !{!163, !165}
!163 = distinct !{!163, !164, !"_ZN12clpt_control6native9for_numba5marchB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEddx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EExxx: %retptr"}
!164 = distinct !{!164, !"_ZN12clpt_control6native9for_numba5marchB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEddx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EExxx"}
!165 = distinct !{!165, !164, !"_ZN12clpt_control6native9for_numba5marchB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEddx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EExxx: %excinfo"}
!166 = !{!167, !169, !163, !165}
!167 = distinct !{!167, !168, !"_ZN12clpt_control6native9for_numba6decideB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!168 = distinct !{!168, !"_ZN12clpt_control6native9for_numba6decideB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!169 = distinct !{!169, !168, !"_ZN12clpt_control6native9for_numba6decideB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!170 = !{!171, !163, !165}
!171 = distinct !{!171, !172, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!172 = distinct !{!172, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!173 = !{!174, !163, !165}
!174 = distinct !{!174, !175, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!175 = distinct !{!175, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!176 = !{!177}
!177 = distinct !{!177, !178}
!178 = distinct !{!178, !"LVerDomain"}
!179 = !{!180}
!180 = distinct !{!180, !178}
!181 = !{!163, !165, !177}
!182 = distinct !{!182, !7, !8}
!183 = distinct !{!183, !7, !8, !157}
!184 = distinct !{!184, !8, !7, !161}
!185 = distinct !{!185, !7, !8, !157}
!186 = distinct !{!186, !8, !7, !161}
!187 = distinct !{!187, !7, !8, !157}
!188 = distinct !{!188, !7, !8}
!189 = distinct !{!189, !8, !7, !161}
!190 = distinct !{!190, !7}
!191 = distinct !{!191, !7, !8, !157}
!192 = !{!193, !195, !163, !165}
!193 = distinct !{!193, !194, !"_ZN12clpt_control6native9for_numba6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!194 = distinct !{!194, !"_ZN12clpt_control6native9for_numba6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!195 = distinct !{!195, !194, !"_ZN12clpt_control6native9for_numba6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!196 = distinct !{!196, !8, !7, !161}
!197 = distinct !{!197, !7}
!198 = distinct !{!198, !7, !8, !157}
!199 = distinct !{!199, !8, !7, !161}
!200 = distinct !{!200, !7, !8, !157}
!201 = distinct !{!201, !8, !7, !161}
!202 = distinct !{!202, !7, !8, !157}
!203 = distinct !{!203, !8, !7, !161}
!204 = distinct !{!204, !7, !8, !157}
!205 = distinct !{!205, !8, !7, !161}
!206 = !{!207, !209}
!207 = distinct !{!207, !208, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!208 = distinct !{!208, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!209 = distinct !{!209, !210, !"_ZN12clpt_control6native9for_numba4leapB3v30B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx: %retptr"}
!210 = distinct !{!210, !"_ZN12clpt_control6native9for_numba4leapB3v30B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx"}
!211 = !{!209}
!212 = !{!213, !209}
!213 = distinct !{!213, !214, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!214 = distinct !{!214, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!215 = !{!216, !209}
!216 = distinct !{!216, !217, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!217 = distinct !{!217, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!218 = !{!219, !209}
!219 = distinct !{!219, !220, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!220 = distinct !{!220, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!221 = !{!222, !209}
!222 = distinct !{!222, !223, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!223 = distinct !{!223, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!224 = distinct !{!224, !7, !8}
!225 = distinct !{!225, !7}

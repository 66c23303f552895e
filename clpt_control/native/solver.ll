; sha256 90843a5d3b7e7f8f09ac24f0b5a398edd5afa837dbf58dfc3bc1d3c8903f4f8d

@.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727 = internal constant [76 x i8] c"\80\04\95A\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AValueError\94\93\94\8C\1Erange() arg 3 must not be zero\94\85\94N\87\94."
@.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727.sha1 = internal constant [20 x i8] c"\CA\8E\FB:r\D6\14\FE\87 2\CC\E3\AC2`\07\A3\07'"
@.const.picklebuf.ca8efb3a72d614fe872032cce3ac326007a30727 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727, i32 76, ptr @.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727.sha1, ptr null, i32 0 }

define dso_local noundef i32 @advance(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, ptr readnone %arg.tolerances.0, ptr readnone %arg.tolerances.1, i64 %arg.tolerances.2, i64 %arg.tolerances.3, ptr %arg.tolerances.4, i64 %arg.tolerances.5.0, i64 %arg.tolerances.6.0, ptr readnone %arg.runs.0.0, ptr readnone %arg.runs.0.1, i64 %arg.runs.0.2, i64 %arg.runs.0.3, ptr readonly %arg.runs.0.4, i64 %arg.runs.0.5.0, i64 %arg.runs.0.5.1, i64 %arg.runs.0.6.0, i64 %arg.runs.0.6.1, ptr readnone %arg.runs.1.0, ptr readnone %arg.runs.1.1, i64 %arg.runs.1.2, i64 %arg.runs.1.3, ptr readonly %arg.runs.1.4, i64 %arg.runs.1.5.0, i64 %arg.runs.1.5.1, i64 %arg.runs.1.6.0, i64 %arg.runs.1.6.1, ptr readnone %arg.runs.2.0, ptr readnone %arg.runs.2.1, i64 %arg.runs.2.2, i64 %arg.runs.2.3, ptr readonly %arg.runs.2.4, i64 %arg.runs.2.5.0, i64 %arg.runs.2.6.0, ptr readnone %arg.schedule.0.0, ptr readnone %arg.schedule.0.1, i64 %arg.schedule.0.2, i64 %arg.schedule.0.3, ptr readonly %arg.schedule.0.4, i64 %arg.schedule.0.5.0, i64 %arg.schedule.0.5.1, i64 %arg.schedule.0.6.0, i64 %arg.schedule.0.6.1, ptr readnone %arg.schedule.1.0, ptr readnone %arg.schedule.1.1, i64 %arg.schedule.1.2, i64 %arg.schedule.1.3, ptr readonly %arg.schedule.1.4, i64 %arg.schedule.1.5.0, i64 %arg.schedule.1.6.0, ptr readnone %arg.schedule.2.0, ptr readnone %arg.schedule.2.1, i64 %arg.schedule.2.2, i64 %arg.schedule.2.3, ptr readonly %arg.schedule.2.4, i64 %arg.schedule.2.5.0, i64 %arg.schedule.2.6.0, ptr readnone %arg.schedule.3.0, ptr readnone %arg.schedule.3.1, i64 %arg.schedule.3.2, i64 %arg.schedule.3.3, ptr readonly %arg.schedule.3.4, i64 %arg.schedule.3.5.0, i64 %arg.schedule.3.5.1, i64 %arg.schedule.3.5.2, i64 %arg.schedule.3.6.0, i64 %arg.schedule.3.6.1, i64 %arg.schedule.3.6.2, ptr readnone %arg.schedule.4.0, ptr readnone %arg.schedule.4.1, i64 %arg.schedule.4.2, i64 %arg.schedule.4.3, ptr readonly %arg.schedule.4.4, i64 %arg.schedule.4.5.0, i64 %arg.schedule.4.5.1, i64 %arg.schedule.4.6.0, i64 %arg.schedule.4.6.1, ptr readnone %arg.times.0, ptr readnone %arg.times.1, i64 %arg.times.2, i64 %arg.times.3, ptr readonly %arg.times.4, i64 %arg.times.5.0, i64 %arg.times.6.0, ptr readnone %arg.results.0.0, ptr readnone %arg.results.0.1, i64 %arg.results.0.2, i64 %arg.results.0.3, ptr %arg.results.0.4, i64 %arg.results.0.5.0, i64 %arg.results.0.5.1, i64 %arg.results.0.5.2, i64 %arg.results.0.6.0, i64 %arg.results.0.6.1, i64 %arg.results.0.6.2, ptr readnone %arg.results.1.0, ptr readnone %arg.results.1.1, i64 %arg.results.1.2, i64 %arg.results.1.3, ptr %arg.results.1.4, i64 %arg.results.1.5.0, i64 %arg.results.1.6.0, ptr readnone %arg.results.2.0, ptr readnone %arg.results.2.1, i64 %arg.results.2.2, i64 %arg.results.2.3, ptr %arg.results.2.4, i64 %arg.results.2.5.0, i64 %arg.results.2.6.0, ptr readnone %arg.results.3.0, ptr readnone %arg.results.3.1, i64 %arg.results.3.2, i64 %arg.results.3.3, ptr %arg.results.3.4, i64 %arg.results.3.5.0, i64 %arg.results.3.5.1, i64 %arg.results.3.6.0, i64 %arg.results.3.6.1, ptr readnone %arg.lane.0.0, ptr readnone %arg.lane.0.1, i64 %arg.lane.0.2, i64 %arg.lane.0.3, ptr %arg.lane.0.4, i64 %arg.lane.0.5.0, i64 %arg.lane.0.5.1, i64 %arg.lane.0.6.0, i64 %arg.lane.0.6.1, ptr readnone %arg.lane.1.0, ptr readnone %arg.lane.1.1, i64 %arg.lane.1.2, i64 %arg.lane.1.3, ptr %arg.lane.1.4, i64 %arg.lane.1.5.0, i64 %arg.lane.1.5.1, i64 %arg.lane.1.6.0, i64 %arg.lane.1.6.1, ptr readnone %arg.lane.2.0, ptr readnone %arg.lane.2.1, i64 %arg.lane.2.2, i64 %arg.lane.2.3, ptr %arg.lane.2.4, i64 %arg.lane.2.5.0, i64 %arg.lane.2.6.0, ptr readnone %arg.arrays.0.0, ptr readnone %arg.arrays.0.1, i64 %arg.arrays.0.2, i64 %arg.arrays.0.3, ptr %arg.arrays.0.4, i64 %arg.arrays.0.5.0, i64 %arg.arrays.0.6.0, ptr readnone %arg.arrays.1.0, ptr readnone %arg.arrays.1.1, i64 %arg.arrays.1.2, i64 %arg.arrays.1.3, ptr %arg.arrays.1.4, i64 %arg.arrays.1.5.0, i64 %arg.arrays.1.6.0, ptr readnone %arg.arrays.2.0, ptr readnone %arg.arrays.2.1, i64 %arg.arrays.2.2, i64 %arg.arrays.2.3, ptr %arg.arrays.2.4, i64 %arg.arrays.2.5.0, i64 %arg.arrays.2.6.0, ptr readnone %arg.arrays.3.0, ptr readnone %arg.arrays.3.1, i64 %arg.arrays.3.2, i64 %arg.arrays.3.3, ptr %arg.arrays.3.4, i64 %arg.arrays.3.5.0, i64 %arg.arrays.3.6.0, ptr readnone %arg.arrays.4.0, ptr readnone %arg.arrays.4.1, i64 %arg.arrays.4.2, i64 %arg.arrays.4.3, ptr %arg.arrays.4.4, i64 %arg.arrays.4.5.0, i64 %arg.arrays.4.6.0, ptr readnone %arg.linear.0.0, ptr readnone %arg.linear.0.1, i64 %arg.linear.0.2, i64 %arg.linear.0.3, ptr %arg.linear.0.4, i64 %arg.linear.0.5.0, i64 %arg.linear.0.6.0, ptr readnone %arg.linear.1.0, ptr readnone %arg.linear.1.1, i64 %arg.linear.1.2, i64 %arg.linear.1.3, ptr %arg.linear.1.4, i64 %arg.linear.1.5.0, i64 %arg.linear.1.6.0, i64 %arg.budget, i64 %arg.most, i64 %arg.guarded, i64 %arg.jumping, i64 %arg.held, i64 %arg.decided) local_unnamed_addr {
entry:
  %arg.linear.1.48733 = ptrtoint ptr %arg.linear.1.4 to i64
  %arg.arrays.0.48732 = ptrtoint ptr %arg.arrays.0.4 to i64
  %arg.runs.0.48622 = ptrtoint ptr %arg.runs.0.4 to i64
  %arg.results.0.48621 = ptrtoint ptr %arg.results.0.4 to i64
  %.382 = mul nsw i64 %arg.shape.1, %arg.shape.0
  %.490.idx = shl i64 %arg.lane.0.5.1, 6
  %.490 = getelementptr i8, ptr %arg.lane.0.4, i64 %.490.idx
  %.539 = icmp sgt i64 %arg.linear.0.5.0, 0
  %. = select i1 %.539, i64 8, i64 11
  %.274.i = icmp slt i64 %arg.shape.0, 1
  %storemerge = select i1 %.274.i, i64 0, i64 %arg.shape.0
  br i1 %.274.i, label %B202.endif, label %B50.if.i.lr.ph

B50.if.i.lr.ph:                                   ; preds = %entry
  %arg.results.0.48617 = ptrtoint ptr %arg.results.0.4 to i64
  %arg.runs.0.48618 = ptrtoint ptr %arg.runs.0.4 to i64
  %.373.i8127 = getelementptr i8, ptr %arg.lane.2.4, i64 8
  %.444.i = getelementptr i8, ptr %arg.lane.2.4, i64 16
  %0 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.idx.i = shl i64 %arg.lane.1.5.1, 4
  %1 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx.i
  %.6961500.not.i = icmp slt i64 %arg.shape.1, 1
  %.851.i8131 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.9661503.not.i = icmp slt i64 %arg.shape.2, 1
  %.11851506.not.i = icmp slt i64 %arg.schedule.2.5.0, 1
  %.1319.i = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1423.i.not = icmp eq i64 %arg.shape.0, 1
  %.163.i1509.not.i = icmp slt i64 %arg.shape.1, 1
  %2 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1486.i = shl i64 %arg.lane.0.5.1, 4
  %3 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1486.i
  %.idx1487.i = mul i64 %arg.lane.0.5.1, 24
  %4 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1487.i
  %.idx1488.i = shl i64 %arg.lane.0.5.1, 5
  %5 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1488.i
  %.idx1489.i = mul i64 %arg.lane.0.5.1, 176
  %6 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1489.i
  %.15851512.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx1492.i = shl i64 %arg.lane.0.5.1, 4
  %7 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1492.i
  %8 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1493.i = mul i64 %arg.lane.0.5.1, 24
  %9 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1493.i
  %.idx1494.i = shl i64 %arg.lane.0.5.1, 5
  %10 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1494.i
  %.idx1495.i = mul i64 %arg.lane.0.5.1, 120
  %11 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1495.i
  %.idx1496.i = mul i64 %arg.lane.1.5.1, 24
  %12 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1496.i
  %.idx1497.i = mul i64 %arg.lane.0.5.1, 200
  %13 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1497.i
  %.idx1498.i = mul i64 %arg.lane.0.5.1, 208
  %14 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1498.i
  %.idx1499.i = mul i64 %arg.lane.0.5.1, 144
  %15 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1499.i
  %16 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %17 = shl i64 %16, 3
  %18 = shl i64 %arg.runs.0.5.1, 3
  %min.iters.check = icmp ult i64 %arg.shape.1, 8
  %n.vec = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n = icmp eq i64 %arg.shape.1, %n.vec
  br label %B50.if.i

B104.i:                                           ; preds = %B50.if.i
  %.420.i = add nsw i64 %active.3.i.08472, 1
  br label %B171.i

B116.i:                                           ; preds = %B50.if.i
  %.314.i = load i64, ptr %arg.lane.2.4, align 8, !noalias !0
  %.374.i = load i64, ptr %.373.i8127, align 8, !noalias !0
  %.375.i8128 = icmp slt i64 %.314.i, %.374.i
  br i1 %.375.i8128, label %B130.i, label %B316.i

B130.i:                                           ; preds = %B116.i
  %.385.i = add nsw i64 %.314.i, 1
  store i64 %.385.i, ptr %arg.lane.2.4, align 8, !noalias !0
  store i64 1, ptr %.444.i, align 8, !noalias !0
  %.502.i8130 = getelementptr i64, ptr %arg.lane.1.4, i64 %.260.i.08470
  store i64 %.314.i, ptr %.502.i8130, align 8, !noalias !0
  %.557.i = getelementptr i64, ptr %0, i64 %.260.i.08470
  store i64 0, ptr %.557.i, align 8, !noalias !0
  %.612.i = getelementptr i64, ptr %1, i64 %.260.i.08470
  store i64 1, ptr %.612.i, align 8, !noalias !0
  br i1 %.6961500.not.i, label %B316.i, label %B272.if.lr.ph.i

B272.if.lr.ph.i:                                  ; preds = %B130.i
  %.757.i = icmp slt i64 %.314.i, 0
  %.758.i = select i1 %.757.i, i64 %arg.runs.0.5.0, i64 0
  %.759.i = add i64 %.758.i, %.314.i
  %.779.i = mul i64 %.759.i, %arg.runs.0.5.1
  %19 = getelementptr double, ptr %arg.runs.0.4, i64 %.779.i
  %.822.i = select i1 %.757.i, i64 %arg.results.0.5.0, i64 0
  %.823.i = add i64 %.822.i, %.314.i
  %.853.i = mul i64 %.851.i8131, %.823.i
  %20 = getelementptr double, ptr %arg.results.0.4, i64 %.853.i
  br i1 %min.iters.check, label %B272.if.i.preheader, label %vector.memcheck

vector.memcheck:                                  ; preds = %B272.if.lr.ph.i
  %21 = mul i64 %17, %.823.i
  %22 = mul i64 %18, %.759.i
  %23 = add i64 %21, %arg.results.0.48617
  %24 = add i64 %22, %arg.runs.0.48618
  %25 = sub i64 %23, %24
  %diff.check = icmp ult i64 %25, 32
  br i1 %diff.check, label %B272.if.i.preheader, label %vector.body

vector.body:                                      ; preds = %vector.memcheck, %vector.body
  %index = phi i64 [ %index.next, %vector.body ], [ 0, %vector.memcheck ]
  %26 = getelementptr double, ptr %19, i64 %index
  %27 = getelementptr i8, ptr %26, i64 16
  %wide.load = load <2 x double>, ptr %26, align 8, !noalias !0
  %wide.load8619 = load <2 x double>, ptr %27, align 8, !noalias !0
  %28 = getelementptr double, ptr %20, i64 %index
  %29 = getelementptr i8, ptr %28, i64 16
  store <2 x double> %wide.load, ptr %28, align 8, !noalias !0
  store <2 x double> %wide.load8619, ptr %29, align 8, !noalias !0
  %index.next = add i64 %index, 4
  %30 = icmp eq i64 %index.next, %n.vec
  br i1 %30, label %middle.block, label %vector.body, !llvm.loop !6

middle.block:                                     ; preds = %vector.body
  br i1 %cmp.n, label %B316.i, label %B272.if.i.preheader

B272.if.i.preheader:                              ; preds = %vector.memcheck, %B272.if.lr.ph.i, %middle.block
  %.638.01501.i.ph = phi i64 [ 0, %vector.memcheck ], [ 0, %B272.if.lr.ph.i ], [ %n.vec, %middle.block ]
  br label %B272.if.i

B316.i:                                           ; preds = %B272.if.i, %middle.block, %B130.i, %B116.i
  %m.2.0.i = phi i64 [ 0, %B116.i ], [ %.314.i, %B130.i ], [ %.314.i, %middle.block ], [ %.314.i, %B272.if.i ]
  br i1 %.9661503.not.i, label %B390.i, label %B346.if.lr.ph.i

B346.if.lr.ph.i:                                  ; preds = %B316.i
  %.1027.i = icmp slt i64 %m.2.0.i, 0
  %.1028.i = select i1 %.1027.i, i64 %arg.runs.1.5.0, i64 0
  %.1029.i = add i64 %.1028.i, %m.2.0.i
  %.1049.i = mul i64 %.1029.i, %arg.runs.1.5.1
  %31 = getelementptr double, ptr %arg.runs.1.4, i64 %.1049.i
  %invariant.gep8780 = getelementptr double, ptr %arg.arrays.1.4, i64 %.260.i.08470
  br label %B346.if.i

B390.i:                                           ; preds = %B346.if.i, %B316.i
  br i1 %.11851506.not.i, label %B516.i, label %B446.if.lr.ph.i

B446.if.lr.ph.i:                                  ; preds = %B390.i
  %.1237.i = icmp slt i64 %m.2.0.i, 0
  %.1238.i = select i1 %.1237.i, i64 %arg.runs.2.5.0, i64 0
  %32 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i
  %.1252.i = getelementptr i64, ptr %32, i64 %.1238.i
  br label %B446.if.i

B516.i:                                           ; preds = %B446.if.i, %B390.i
  br i1 %.375.i8128, label %B574.i, label %B520.i

B520.i:                                           ; preds = %B516.i
  br i1 %.1423.i.not, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B532.i

B532.i:                                           ; preds = %B520.i
  br i1 %.163.i1509.not.i, label %B102.i.i, label %B46.if.i.i.preheader

B46.if.i.i.preheader:                             ; preds = %B532.i
  %invariant.gep8782 = getelementptr double, ptr %arg.arrays.0.4, i64 %.260.i.08470
  br label %B46.if.i.i

B102.i.i:                                         ; preds = %B46.if.i.i, %B532.i
  %.360.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.260.i.08470
  store double 0.000000e+00, ptr %.360.i.i, align 8, !noalias !9
  %.415.i.i = getelementptr double, ptr %2, i64 %.260.i.08470
  store double 5.000000e-01, ptr %.415.i.i, align 8, !noalias !9
  %.470.i.i = getelementptr double, ptr %3, i64 %.260.i.08470
  store double 1.000000e+00, ptr %.470.i.i, align 8, !noalias !9
  %.526.i.i = getelementptr double, ptr %4, i64 %.260.i.08470
  store double 0.000000e+00, ptr %.526.i.i, align 8, !noalias !9
  %.581.i.i = getelementptr double, ptr %5, i64 %.260.i.08470
  store double 0.000000e+00, ptr %.581.i.i, align 8, !noalias !9
  %.638.i.i = getelementptr double, ptr %6, i64 %.260.i.08470
  store double 0xFFF0000000000000, ptr %.638.i.i, align 8, !noalias !9
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B46.if.i.i:                                       ; preds = %B46.if.i.i.preheader, %B46.if.i.i
  %.105.i.01510.i = phi i64 [ %.176.i.i, %B46.if.i.i ], [ 0, %B46.if.i.i.preheader ]
  %.176.i.i = add nsw i64 %.105.i.01510.i, 1
  %33 = getelementptr double, ptr %arg.runs.0.4, i64 %.105.i.01510.i
  %.255.i.i = load double, ptr %33, align 8, !noalias !9
  %.257.i.i = mul nsw i64 %.105.i.01510.i, %arg.shape.0
  %gep8783 = getelementptr double, ptr %invariant.gep8782, i64 %.257.i.i
  store double %.255.i.i, ptr %gep8783, align 8, !noalias !9
  %exitcond1517.not.i = icmp eq i64 %arg.shape.1, %.176.i.i
  br i1 %exitcond1517.not.i, label %B102.i.i, label %B46.if.i.i

B574.i:                                           ; preds = %B516.i
  br i1 %.15851512.not.i, label %B648.i, label %B604.if.lr.ph.i

B604.if.lr.ph.i:                                  ; preds = %B574.i
  %.1646.i = icmp slt i64 %m.2.0.i, 0
  %.1647.i = select i1 %.1646.i, i64 %arg.runs.0.5.0, i64 0
  %.1648.i = add i64 %.1647.i, %m.2.0.i
  %.1668.i = mul i64 %.1648.i, %arg.runs.0.5.1
  %34 = getelementptr double, ptr %arg.runs.0.4, i64 %.1668.i
  %invariant.gep8784 = getelementptr double, ptr %arg.arrays.0.4, i64 %.260.i.08470
  br label %B604.if.i

B648.i:                                           ; preds = %B604.if.i, %B574.i
  %.1748.i = load double, ptr %arg.times.4, align 8, !noalias !0
  %.1765.i = icmp slt i64 %m.2.0.i, 0
  %.1766.i = select i1 %.1765.i, i64 %arg.runs.2.5.0, i64 0
  %35 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i
  %.1780.i = getelementptr i64, ptr %35, i64 %.1766.i
  %.1781.i = load i64, ptr %.1780.i, align 8, !noalias !0
  %.1812.i = icmp slt i64 %.1781.i, 0
  %.1813.i = select i1 %.1812.i, i64 %arg.schedule.0.5.0, i64 0
  %.1814.i = add i64 %.1813.i, %.1781.i
  %.1834.i = mul i64 %.1814.i, %arg.schedule.0.5.1
  %.1838.i = getelementptr double, ptr %arg.schedule.0.4, i64 %.1834.i
  %.1839.i = load double, ptr %.1838.i, align 8, !noalias !0
  %.1895.i = getelementptr double, ptr %arg.lane.0.4, i64 %.260.i.08470
  store double %.1748.i, ptr %.1895.i, align 8, !noalias !0
  %.1950.i = getelementptr double, ptr %7, i64 %.260.i.08470
  store double %.1839.i, ptr %.1950.i, align 8, !noalias !0
  %.2005.i = getelementptr double, ptr %8, i64 %.260.i.08470
  store double 0.000000e+00, ptr %.2005.i, align 8, !noalias !0
  %.2064.i = getelementptr double, ptr %9, i64 %.260.i.08470
  store double 1.000000e+00, ptr %.2064.i, align 8, !noalias !0
  %.2119.i = getelementptr double, ptr %10, i64 %.260.i.08470
  store double 0.000000e+00, ptr %.2119.i, align 8, !noalias !0
  %.2175.i = getelementptr double, ptr %11, i64 %.260.i.08470
  store double 0xFFF0000000000000, ptr %.2175.i, align 8, !noalias !0
  %36 = getelementptr i64, ptr %12, i64 %.260.i.08470
  store i64 0, ptr %36, align 8, !noalias !0
  %.2291.i = getelementptr double, ptr %13, i64 %.260.i.08470
  store double 0.000000e+00, ptr %.2291.i, align 8, !noalias !0
  %.2346.i = getelementptr double, ptr %14, i64 %.260.i.08470
  store double 0.000000e+00, ptr %.2346.i, align 8, !noalias !0
  %.2401.i = getelementptr double, ptr %15, i64 %.260.i.08470
  %.2402.i = load double, ptr %.2401.i, align 8, !noalias !0
  %.2404.i = fcmp ueq double %.2402.i, 0xFFF0000000000000
  br i1 %.2404.i, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B994.i

B994.i:                                           ; preds = %B648.i
  store double 0.000000e+00, ptr %.2401.i, align 8, !noalias !0
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B272.if.i:                                        ; preds = %B272.if.i.preheader, %B272.if.i
  %.638.01501.i = phi i64 [ %.709.i, %B272.if.i ], [ %.638.01501.i.ph, %B272.if.i.preheader ]
  %.709.i = add nsw i64 %.638.01501.i, 1
  %37 = getelementptr double, ptr %19, i64 %.638.01501.i
  %.784.i = load double, ptr %37, align 8, !noalias !0
  %38 = getelementptr double, ptr %20, i64 %.638.01501.i
  store double %.784.i, ptr %38, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.709.i, %arg.shape.1
  br i1 %exitcond.not.i, label %B316.i, label %B272.if.i, !llvm.loop !13

B346.if.i:                                        ; preds = %B346.if.i, %B346.if.lr.ph.i
  %.910.01504.i = phi i64 [ 0, %B346.if.lr.ph.i ], [ %.979.i, %B346.if.i ]
  %.979.i = add nsw i64 %.910.01504.i, 1
  %39 = getelementptr double, ptr %31, i64 %.910.01504.i
  %.1054.i = load double, ptr %39, align 8, !noalias !0
  %.1056.i = mul nsw i64 %.910.01504.i, %arg.shape.0
  %gep8781 = getelementptr double, ptr %invariant.gep8780, i64 %.1056.i
  store double %.1054.i, ptr %gep8781, align 8, !noalias !0
  %exitcond1515.not.i = icmp eq i64 %.979.i, %arg.shape.2
  br i1 %exitcond1515.not.i, label %B390.i, label %B346.if.i

B446.if.i:                                        ; preds = %B446.if.i, %B446.if.lr.ph.i
  %.1129.01507.i = phi i64 [ 0, %B446.if.lr.ph.i ], [ %.1198.i, %B446.if.i ]
  %.1198.i = add nsw i64 %.1129.01507.i, 1
  %.1253.i = load i64, ptr %.1252.i, align 8, !noalias !0
  %.1289.i = icmp slt i64 %.1253.i, 0
  %.1290.i = select i1 %.1289.i, i64 %arg.schedule.3.5.0, i64 0
  %.1291.i = add i64 %.1290.i, %.1253.i
  %.1321.i = mul i64 %.1319.i, %.1291.i
  %40 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1321.i
  %41 = getelementptr double, ptr %40, i64 %.1129.01507.i
  %.1328.i8129 = load double, ptr %41, align 8, !noalias !0
  %42 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1129.01507.i
  %.1358.i = load i64, ptr %42, align 8, !noalias !0
  %.1360.i = mul nsw i64 %.1358.i, %arg.shape.0
  %.1362.i = add nsw i64 %.1360.i, %.260.i.08470
  %.1376.i = icmp slt i64 %.1362.i, 0
  %.1377.i = select i1 %.1376.i, i64 %arg.arrays.1.5.0, i64 0
  %43 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1362.i
  %.1391.i = getelementptr double, ptr %43, i64 %.1377.i
  store double %.1328.i8129, ptr %.1391.i, align 8, !noalias !0
  %exitcond1516.not.i = icmp eq i64 %.1198.i, %arg.schedule.2.5.0
  br i1 %exitcond1516.not.i, label %B516.i, label %B446.if.i

B604.if.i:                                        ; preds = %B604.if.i, %B604.if.lr.ph.i
  %.1529.01513.i = phi i64 [ 0, %B604.if.lr.ph.i ], [ %.1598.i, %B604.if.i ]
  %.1598.i = add nsw i64 %.1529.01513.i, 1
  %44 = getelementptr double, ptr %34, i64 %.1529.01513.i
  %.1673.i = load double, ptr %44, align 8, !noalias !0
  %.1675.i = mul nsw i64 %.1529.01513.i, %arg.shape.0
  %gep8785 = getelementptr double, ptr %invariant.gep8784, i64 %.1675.i
  store double %.1673.i, ptr %gep8785, align 8, !noalias !0
  %exitcond1518.not.i = icmp eq i64 %.1598.i, %arg.shape.1
  br i1 %exitcond1518.not.i, label %B648.i, label %B604.if.i

_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B520.i, %B102.i.i, %B648.i, %B994.i
  %storemerge1490.i = phi i64 [ 0, %B520.i ], [ 0, %B102.i.i ], [ 1, %B994.i ], [ 1, %B648.i ]
  %.525.i = add nsw i64 %storemerge1490.i, %active.3.i.08472
  br label %B171.i

B171.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B104.i
  %active.4.i.1 = phi i64 [ %.420.i, %B104.i ], [ %.525.i, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.318.i = icmp sgt i64 %.263.i.08471, 1
  br i1 %.318.i, label %B50.if.i, label %B202.endif

B50.if.i:                                         ; preds = %B50.if.i.lr.ph, %B171.i
  %active.3.i.08472 = phi i64 [ 0, %B50.if.i.lr.ph ], [ %active.4.i.1, %B171.i ]
  %.263.i.08471 = phi i64 [ %storemerge, %B50.if.i.lr.ph ], [ %.327.i, %B171.i ]
  %.260.i.08470 = phi i64 [ 0, %B50.if.i.lr.ph ], [ %.331.i, %B171.i ]
  %.327.i = add nsw i64 %.263.i.08471, -1
  %.331.i = add nsw i64 %.260.i.08470, 1
  %45 = getelementptr i64, ptr %arg.lane.1.4, i64 %.260.i.08470
  %.414.i = load i64, ptr %45, align 8, !noalias !14
  %.415.i = icmp sgt i64 %.414.i, -1
  br i1 %.415.i, label %B104.i, label %B116.i

B276:                                             ; preds = %B276.preheader, %B4252
  %budget.3.0 = phi i64 [ %budget.4.2, %B4252 ], [ %arg.budget, %B276.preheader ]
  %active.4.0 = phi i64 [ %active.5.2, %B4252 ], [ %active.3.i.0.lcssa, %B276.preheader ]
  %.688 = add nsw i64 %budget.3.0, -1
  %.723 = load i64, ptr %.722, align 8
  %.724 = icmp sgt i64 %.723, 0
  br i1 %.724, label %B310, label %B428

B310:                                             ; preds = %B276
  %.756 = icmp eq i64 %.723, 1
  store i64 0, ptr %.722, align 8
  %.819 = load i64, ptr %.818, align 8
  %.864 = inttoptr i64 %.819 to ptr
  tail call void %.864(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B428

B428:                                             ; preds = %B276, %B310
  %anew.2.1 = phi i1 [ %.756, %B310 ], [ false, %B276 ]
  br i1 %anew.2.1, label %B434, label %B1000

B434:                                             ; preds = %B428
  br i1 %.873, label %B446, label %B490

B446:                                             ; preds = %B434
  %.150.i = load i64, ptr %.149.i, align 8, !noalias !15
  %.195.i108 = inttoptr i64 %.150.i to ptr
  tail call void %.195.i108(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !15
  br i1 %.274.i, label %B250.i, label %B118.if.i

B248.i:                                           ; preds = %B190.if.i, %B118.if.i
  %.279.i = icmp sgt i64 %.224.i.08478, 1
  br i1 %.279.i, label %B118.if.i, label %B250.i

B250.i:                                           ; preds = %B248.i, %B446
  %.614.i = load i64, ptr %.613.i, align 8, !noalias !15
  %.661.i = inttoptr i64 %.614.i to ptr
  tail call void %.661.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !15
  br label %B490

B118.if.i:                                        ; preds = %B446, %B248.i
  %.224.i.08478 = phi i64 [ %.288.i247, %B248.i ], [ %storemerge, %B446 ]
  %.221.i.08477 = phi i64 [ %.292.i249, %B248.i ], [ 0, %B446 ]
  %.288.i247 = add nsw i64 %.224.i.08478, -1
  %.292.i249 = add nsw i64 %.221.i.08477, 1
  %46 = getelementptr double, ptr %276, i64 %.221.i.08477
  %.374.i158 = load double, ptr %46, align 8, !noalias !15
  %.375.i = fcmp ule double %.374.i158, 5.000000e-01
  %brmerge8596 = select i1 %.375.i, i1 true, i1 %.457.i1878473
  br i1 %brmerge8596, label %B248.i, label %B190.if.i.preheader

B190.if.i.preheader:                              ; preds = %B118.if.i
  %invariant.gep8786 = getelementptr double, ptr %arg.arrays.4.4, i64 %.221.i.08477
  br label %B190.if.i

B190.if.i:                                        ; preds = %B190.if.i.preheader, %B190.if.i
  %.401.i.08474 = phi i64 [ %.470.i240, %B190.if.i ], [ 0, %B190.if.i.preheader ]
  %.470.i240 = add nsw i64 %.401.i.08474, 1
  %.496.i198 = mul nsw i64 %.401.i.08474, %arg.shape.0
  %gep8787 = getelementptr double, ptr %invariant.gep8786, i64 %.496.i198
  %.528.i219 = load double, ptr %gep8787, align 8, !noalias !15
  %.530.i = add nsw i64 %.401.i.08474, %arg.held
  %.532.i = mul nsw i64 %.530.i, %arg.shape.0
  %.534.i = add nsw i64 %.532.i, %.221.i.08477
  %.548.i = icmp slt i64 %.534.i, 0
  %.549.i227 = select i1 %.548.i, i64 %arg.arrays.1.5.0, i64 0
  %47 = getelementptr double, ptr %arg.arrays.1.4, i64 %.534.i
  %.563.i = getelementptr double, ptr %47, i64 %.549.i227
  store double %.528.i219, ptr %.563.i, align 8, !noalias !15
  %exitcond.not = icmp eq i64 %.470.i240, %arg.decided
  br i1 %exitcond.not, label %B248.i, label %B190.if.i

B490:                                             ; preds = %B250.i, %B434
  %.960 = load i64, ptr %arg.code.4, align 8
  %.1008 = inttoptr i64 %.960 to ptr
  tail call void %.1008(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1007)
  br i1 %.1011.not, label %B652, label %B584

B584:                                             ; preds = %B490
  %.1042 = load i64, ptr %.1041, align 8
  %.1087 = inttoptr i64 %.1042 to ptr
  tail call void %.1087(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B652

B652:                                             ; preds = %B584, %B490
  %.1119 = load i64, ptr %.1118, align 8
  %.1164 = inttoptr i64 %.1119 to ptr
  tail call void %.1164(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.1195 = load i64, ptr %.1194, align 8
  %.1240 = inttoptr i64 %.1195 to ptr
  tail call void %.1240(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.1271 = load i64, ptr %arg.code.4, align 8
  %.1321 = inttoptr i64 %.1271 to ptr
  tail call void %.1321(ptr %.490, ptr %.1295, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1320)
  %.1352 = load i64, ptr %.1351, align 8
  %.1397 = inttoptr i64 %.1352 to ptr
  tail call void %.1397(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.274.i, label %B1000, label %B62.if.i

B104.i439:                                        ; preds = %B62.if.i
  store double 0.000000e+00, ptr %.296.i436, align 8, !noalias !19
  %.414.i521 = getelementptr double, ptr %278, i64 %.144.i341.08480
  store double 0.000000e+00, ptr %.414.i521, align 8, !noalias !19
  %.469.i566 = getelementptr double, ptr %279, i64 %.144.i341.08480
  store double 0.000000e+00, ptr %.469.i566, align 8, !noalias !19
  %48 = getelementptr i64, ptr %arg.lane.1.4, i64 %.144.i341.08480
  %.525.i614 = load i64, ptr %48, align 8, !noalias !19
  %.552.i635 = icmp slt i64 %.525.i614, 0
  %.553.i636 = select i1 %.552.i635, i64 %arg.results.3.5.0, i64 0
  %.554.i637 = add i64 %.553.i636, %.525.i614
  %.574.i = mul i64 %.554.i637, %arg.results.3.5.1
  %49 = getelementptr i64, ptr %arg.results.3.4, i64 %.574.i
  %.578.i = getelementptr i8, ptr %49, i64 8
  %.579.i650 = load i64, ptr %.578.i, align 8, !noalias !19
  %.580.i = add nsw i64 %.579.i650, 2
  store i64 %.580.i, ptr %.578.i, align 8, !noalias !19
  %.687.i = load i64, ptr %48, align 8, !noalias !19
  %.714.i = icmp slt i64 %.687.i, 0
  %.715.i = select i1 %.714.i, i64 %arg.results.3.5.0, i64 0
  %.716.i = add i64 %.715.i, %.687.i
  %.736.i = mul i64 %.716.i, %arg.results.3.5.1
  %50 = getelementptr i64, ptr %arg.results.3.4, i64 %.736.i
  %.740.i = getelementptr i8, ptr %50, i64 16
  %.741.i = load i64, ptr %.740.i, align 8, !noalias !19
  %.742.i = add nsw i64 %.741.i, 1
  store i64 %.742.i, ptr %.740.i, align 8, !noalias !19
  %.848.i = getelementptr double, ptr %280, i64 %.144.i341.08480
  %.849.i = load double, ptr %.848.i, align 8, !noalias !19
  %.850.i = fcmp une double %.849.i, 0.000000e+00
  br i1 %.850.i, label %B358.i, label %B404.i

B358.i:                                           ; preds = %B104.i439
  %.84.i.i = load i64, ptr %48, align 8, !noalias !23
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

B404.i:                                           ; preds = %B80.i.i, %B358.i, %B46.i.i, %B104.i439
  br i1 %.1011.not, label %B540.i, label %B408.i

B408.i:                                           ; preds = %B404.i
  %51 = getelementptr double, ptr %arg.arrays.4.4, i64 %.144.i341.08480
  %.920.i = load double, ptr %51, align 8, !noalias !19
  %.922.i = fcmp olt double %.920.i, -1.000000e-09
  br i1 %.922.i, label %B444.i, label %B540.i

B444.i:                                           ; preds = %B408.i
  %.84.i63.i = load i64, ptr %48, align 8, !noalias !26
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
  %.1011.i = getelementptr double, ptr %arg.lane.0.4, i64 %.144.i341.08480
  %.1012.i = load double, ptr %.1011.i, align 8, !noalias !19
  %.1068.i = getelementptr double, ptr %281, i64 %.144.i341.08480
  store double %.1012.i, ptr %.1068.i, align 8, !noalias !19
  br label %B540.i

B540.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i, %B408.i, %B404.i, %B62.if.i
  %.202.i392 = icmp sgt i64 %.147.i.08481, 1
  br i1 %.202.i392, label %B62.if.i, label %B1000

B62.if.i:                                         ; preds = %B652, %B540.i
  %.147.i.08481 = phi i64 [ %.211.i732, %B540.i ], [ %storemerge, %B652 ]
  %.144.i341.08480 = phi i64 [ %.215.i735, %B540.i ], [ 0, %B652 ]
  %.211.i732 = add nsw i64 %.147.i.08481, -1
  %.215.i735 = add nsw i64 %.144.i341.08480, 1
  %.296.i436 = getelementptr double, ptr %277, i64 %.144.i341.08480
  %.297.i437 = load double, ptr %.296.i436, align 8, !noalias !19
  %.298.i438 = fcmp ogt double %.297.i437, 5.000000e-01
  br i1 %.298.i438, label %B104.i439, label %B540.i

B1000:                                            ; preds = %B540.i, %B652, %B428
  br i1 %.539, label %B1004, label %B1244.critedge

B1004:                                            ; preds = %B1000
  %.1511 = load i64, ptr %.1510, align 8
  %.1526 = icmp slt i64 %.1511, %arg.times.5.0
  br i1 %.1526, label %B1072, label %B1110

B1072:                                            ; preds = %B1004
  %.1542 = icmp slt i64 %.1511, 0
  %.1543 = select i1 %.1542, i64 %arg.times.5.0, i64 0
  %52 = getelementptr double, ptr %arg.times.4, i64 %.1511
  %.1557 = getelementptr double, ptr %52, i64 %.1543
  %.1558 = load double, ptr %.1557, align 8
  br label %B1110

B1110:                                            ; preds = %B1004, %B1072
  %"$phi1110.0.2.2" = phi double [ %.1558, %B1072 ], [ 0x7FF0000000000000, %B1004 ]
  store double %"$phi1110.0.2.2", ptr %.1623, align 8
  %.1657 = load i64, ptr %.1656, align 8
  %.1702 = inttoptr i64 %.1657 to ptr
  tail call void %.1702(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.174.not.i, label %B0.else.endif.endif.endif.if.i, label %B0.else.endif.if.i, !prof !29

B124.i:                                           ; preds = %B0.endif.else.endif.endif.i
  %.154.i.i8141 = load i64, ptr %.153.i.i8140, align 8, !noalias !30
  %.184.i.i8143 = load i64, ptr %.183.i.i8142, align 8, !noalias !30
  br i1 %.234.i.i, label %B0.else.endif.if.i.i, label %B0.else.endif.endif.i.i, !prof !36

B412.i.i:                                         ; preds = %B330.if.i.i, %middle.block8767, %B0.endif.endif.endif.endif.endif.i.i
  %.1311.i.i = add nsw i64 %.486.i.i, -1
  %.1349.i.i = icmp slt i64 %.477.i.i, 2
  %storemerge2355.i = select i1 %.1349.i.i, i64 0, i64 %.1311.i.i
  %.1392.i2403.i = icmp sgt i64 %storemerge2355.i, 0
  br i1 %.1392.i2403.i, label %B478.i.lr.ph.i, label %B164.i

B478.i.lr.ph.i:                                   ; preds = %B412.i.i
  %.1338.i.12406.i = add nsw i64 %storemerge2355.i, -1
  %.952.i.i.i = select i1 %.1556.i2382.not.i, i64 %.311.i.i, i64 0
  %53 = getelementptr i64, ptr %.327.i.i, i64 %arg.shape.1
  %.966.i.i.i = getelementptr i64, ptr %53, i64 %.952.i.i.i
  %54 = shl i64 %spec.select.i, 3
  %55 = add i64 %54, %arg.linear.1.48733
  %56 = sub i64 %376, %55
  %diff.check8734 = icmp ult i64 %56, 32
  %or.cond8771 = select i1 %min.iters.check8736, i1 true, i1 %diff.check8734
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
  br i1 %or.cond8771, label %B544.if.i.i.preheader8776, label %vector.ph8737

vector.ph8737:                                    ; preds = %B544.if.i.i.preheader
  %broadcast.splatinsert8740 = insertelement <2 x i64> poison, i64 %.1382.i.sroa.0.02409.i, i64 0
  %broadcast.splat8741 = shufflevector <2 x i64> %broadcast.splatinsert8740, <2 x i64> poison, <2 x i32> zeroinitializer
  br label %vector.body8742

vector.body8742:                                  ; preds = %vector.body8742, %vector.ph8737
  %index8743 = phi i64 [ 0, %vector.ph8737 ], [ %index.next8746, %vector.body8742 ]
  %57 = getelementptr i64, ptr %.327.i.i, i64 %index8743
  %58 = getelementptr i8, ptr %57, i64 16
  %wide.load8744 = load <2 x i64>, ptr %57, align 8, !noalias !30
  %wide.load8745 = load <2 x i64>, ptr %58, align 8, !noalias !30
  %59 = icmp eq <2 x i64> %wide.load8744, %broadcast.splat8741
  %60 = icmp eq <2 x i64> %wide.load8745, %broadcast.splat8741
  %61 = select <2 x i1> %59, <2 x double> splat (double 1.000000e+00), <2 x double> zeroinitializer
  %62 = select <2 x i1> %60, <2 x double> splat (double 1.000000e+00), <2 x double> zeroinitializer
  %63 = getelementptr double, ptr %invariant.gep, i64 %index8743
  %64 = getelementptr i8, ptr %63, i64 16
  store <2 x double> %61, ptr %63, align 8, !noalias !30
  store <2 x double> %62, ptr %64, align 8, !noalias !30
  %index.next8746 = add i64 %index8743, 4
  %65 = icmp eq i64 %index.next8746, %n.vec8739
  br i1 %65, label %middle.block8747, label %vector.body8742, !llvm.loop !37

middle.block8747:                                 ; preds = %vector.body8742
  br i1 %cmp.n8748, label %B610.i.i, label %B544.if.i.i.preheader8776

B544.if.i.i.preheader8776:                        ; preds = %B544.if.i.i.preheader, %middle.block8747
  %.1503.i.02384.i.ph = phi i64 [ %storemerge2359.i, %B544.if.i.i.preheader ], [ %379, %middle.block8747 ]
  %.1500.i.02383.i.ph = phi i64 [ 0, %B544.if.i.i.preheader ], [ %n.vec8739, %middle.block8747 ]
  br label %B544.if.i.i

B610.i.i:                                         ; preds = %B544.if.i.i, %middle.block8747, %B508.i.i
  %.1717.i.i = load i64, ptr %.1716.i.i, align 8, !noalias !30
  %.1833.i.i = inttoptr i64 %.1717.i.i to ptr
  tail call void %.1833.i.i(ptr %arg.lane.0.4, ptr %.1807.i.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1832.i.i), !noalias !30
  %.1849.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, 0
  %.1850.i.i = select i1 %.1849.i.i, i64 %.486.i.i, i64 0
  %66 = getelementptr i64, ptr %.502.i.i, i64 %.1382.i.sroa.0.02409.i
  %.1864.i.i = getelementptr i64, ptr %66, i64 %.1850.i.i
  %.1865.i.i = load i64, ptr %.1864.i.i, align 8, !noalias !30
  %.1881.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, -1
  %.1882.i.i = select i1 %.1881.i.i, i64 %.486.i.i, i64 0
  %67 = getelementptr i8, ptr %66, i64 8
  %.1896.i.i = getelementptr i64, ptr %67, i64 %.1882.i.i
  %.1897.i.i = load i64, ptr %.1896.i.i, align 8, !noalias !30
  %.1934.i.i = sub i64 %.1897.i.i, %.1865.i.i
  %.1980.i2385.not.i = icmp slt i64 %.1934.i.i, 1
  br i1 %.1980.i2385.not.i, label %B914.i.i, label %B794.if.i.i

B802.i.i:                                         ; preds = %B794.if.i.i
  %.2047.i.i = icmp slt i64 %.1921.i.02386.i, 0
  %.2048.i.i = select i1 %.2047.i.i, i64 %.665.i.i, i64 0
  %68 = getelementptr i64, ptr %.681.i.i, i64 %.1921.i.02386.i
  %.2062.i.i = getelementptr i64, ptr %68, i64 %.2048.i.i
  %.2063.i.i = load i64, ptr %.2062.i.i, align 8, !noalias !30
  %.2064.i.i = add nsw i64 %.2063.i.i, %.1789.i.i
  %.2078.i.i = icmp slt i64 %.2064.i.i, 0
  %.2079.i.i = select i1 %.2078.i.i, i64 %arg.arrays.0.5.0, i64 0
  %69 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2064.i.i
  %.2093.i.i = getelementptr double, ptr %69, i64 %.2079.i.i
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
  br i1 %or.cond8772, label %B84.if.i.i.i.preheader8775, label %vector.ph8718

vector.ph8718:                                    ; preds = %B84.if.i.i.i.preheader
  %broadcast.splatinsert8721 = insertelement <2 x double> poison, double %.187.i.i.i, i64 0
  %broadcast.splat8722 = shufflevector <2 x double> %broadcast.splatinsert8721, <2 x double> poison, <2 x i32> zeroinitializer
  br label %vector.body8723

vector.body8723:                                  ; preds = %vector.body8723, %vector.ph8718
  %index8724 = phi i64 [ 0, %vector.ph8718 ], [ %index.next8727, %vector.body8723 ]
  %70 = getelementptr double, ptr %arg.arrays.0.4, i64 %index8724
  %71 = getelementptr i8, ptr %70, i64 16
  %wide.load8725 = load <2 x double>, ptr %70, align 8, !noalias !38
  %wide.load8726 = load <2 x double>, ptr %71, align 8, !noalias !38
  %72 = tail call <2 x double> @llvm.fabs.v2f64(<2 x double> %wide.load8725)
  %73 = tail call <2 x double> @llvm.fabs.v2f64(<2 x double> %wide.load8726)
  %74 = fcmp ogt <2 x double> %broadcast.splat8722, %72
  %75 = fcmp ogt <2 x double> %broadcast.splat8722, %73
  %76 = select <2 x i1> %74, <2 x double> %broadcast.splat8722, <2 x double> %72
  %77 = select <2 x i1> %75, <2 x double> %broadcast.splat8722, <2 x double> %73
  %78 = fcmp ogt <2 x double> %76, zeroinitializer
  %79 = fcmp ogt <2 x double> %77, zeroinitializer
  %80 = fmul <2 x double> %76, splat (double 1.200000e-05)
  %81 = fmul <2 x double> %77, splat (double 1.200000e-05)
  %82 = select <2 x i1> %78, <2 x double> %80, <2 x double> splat (double 1.200000e-05)
  %83 = select <2 x i1> %79, <2 x double> %81, <2 x double> splat (double 1.200000e-05)
  %84 = getelementptr i8, ptr %70, i64 %.idx2424.i
  %85 = getelementptr i8, ptr %84, i64 16
  store <2 x double> %82, ptr %84, align 8, !noalias !38
  store <2 x double> %83, ptr %85, align 8, !noalias !38
  %index.next8727 = add i64 %index8724, 4
  %86 = icmp eq i64 %index.next8727, %n.vec8720
  br i1 %86, label %middle.block8728, label %vector.body8723, !llvm.loop !42

middle.block8728:                                 ; preds = %vector.body8723
  br i1 %cmp.n8729, label %B230.i.i.i, label %B84.if.i.i.i.preheader8775

B84.if.i.i.i.preheader8775:                       ; preds = %B84.if.i.i.i.preheader, %middle.block8728
  %.215.i.i.02391.i.ph = phi i64 [ 0, %B84.if.i.i.i.preheader ], [ %n.vec8720, %middle.block8728 ]
  br label %B84.if.i.i.i

B230.i.i.i:                                       ; preds = %B84.if.i.i.i, %middle.block8728
  %.500.i.i.i = load double, ptr %.499.i.i.i, align 8, !noalias !38
  %.501.i.i.i = fmul double %.500.i.i.i, 1.000000e-03
  store double %.501.i.i.i, ptr %.534.i.i.i, align 8, !noalias !38
  br label %B370.if.i.i.i

B398.i.i.i:                                       ; preds = %B370.if.i.i.i
  %gep8483 = getelementptr double, ptr %invariant.gep8482, i64 %.687.i.i.02393.i
  %.851.i.i.i = load double, ptr %gep8483, align 8, !noalias !38
  %.853.i.i.i = fmul double %.851.i.i.i, 5.000000e-01
  br label %B444.i.i.i

B444.i.i.i:                                       ; preds = %B370.if.i.i.i, %B398.i.i.i
  %"$phi444.2.2.i.i.2.i" = phi double [ %.853.i.i.i, %B398.i.i.i ], [ 0.000000e+00, %B370.if.i.i.i ]
  %87 = getelementptr double, ptr %arg.arrays.0.4, i64 %.687.i.i.02393.i
  %.894.i.i.i = load double, ptr %87, align 8, !noalias !38
  %.895.i.i.i = fadd double %"$phi444.2.2.i.i.2.i", %.894.i.i.i
  %88 = getelementptr double, ptr %87, i64 %.897.i.i.i
  store double %.895.i.i.i, ptr %88, align 8, !noalias !38
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
  %89 = getelementptr double, ptr %97, i64 %arg.shape.1
  %.1731.i.i.i = load double, ptr %89, align 8, !noalias !38
  %.1796.i.i.i = fsub double %.1666.i.i.i, %.1731.i.i.i
  %.1801.i.i.i = fmul double %.1796.i.i.i, 2.000000e+00
  br label %B1148.i.i.i

B370.if.i.i.1.i:                                  ; preds = %B568.i.i.i, %B444.i.i.1.i
  %.687.i.i.02393.1.i = phi i64 [ %.756.i.i.1.i, %B444.i.i.1.i ], [ 0, %B568.i.i.i ]
  %.756.i.i.1.i = add nsw i64 %.687.i.i.02393.1.i, 1
  %90 = getelementptr i64, ptr %.327.i.i, i64 %.687.i.i.02393.1.i
  %.814.i.i.1.i = load i64, ptr %90, align 8, !noalias !38
  %.816.i.i.1.i = icmp eq i64 %.814.i.i.1.i, %.1382.i.sroa.0.02409.i
  br i1 %.816.i.i.1.i, label %B398.i.i.1.i, label %B444.i.i.1.i

B398.i.i.1.i:                                     ; preds = %B370.if.i.i.1.i
  %gep8485 = getelementptr double, ptr %invariant.gep8484, i64 %.687.i.i.02393.1.i
  %.851.i.i.1.i = load double, ptr %gep8485, align 8, !noalias !38
  %.853.i.i.1.i = fmul double %.851.i.i.1.i, -5.000000e-01
  br label %B444.i.i.1.i

B444.i.i.1.i:                                     ; preds = %B398.i.i.1.i, %B370.if.i.i.1.i
  %"$phi444.2.2.i.i.2.1.i" = phi double [ %.853.i.i.1.i, %B398.i.i.1.i ], [ 0.000000e+00, %B370.if.i.i.1.i ]
  %91 = getelementptr double, ptr %arg.arrays.0.4, i64 %.687.i.i.02393.1.i
  %.894.i.i.1.i = load double, ptr %91, align 8, !noalias !38
  %.895.i.i.1.i = fadd double %"$phi444.2.2.i.i.2.1.i", %.894.i.i.1.i
  %92 = getelementptr double, ptr %91, i64 %.897.i.i.i
  store double %.895.i.i.1.i, ptr %92, align 8, !noalias !38
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
  store double %storemerge2363.i, ptr %99, align 8, !noalias !38
  %exitcond2419.not.i = icmp eq i64 %arg.shape.1, %.1540.i.i.i
  br i1 %exitcond2419.not.i, label %B960.i.i, label %B902.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B84.if.i.i.i.preheader8775, %B84.if.i.i.i
  %.215.i.i.02391.i = phi i64 [ %.286.i.i.i, %B84.if.i.i.i ], [ %.215.i.i.02391.i.ph, %B84.if.i.i.i.preheader8775 ]
  %.286.i.i.i = add nsw i64 %.215.i.i.02391.i, 1
  %93 = getelementptr double, ptr %arg.arrays.0.4, i64 %.215.i.i.02391.i
  %.344.i.i.i = load double, ptr %93, align 8, !noalias !38
  %.345.i.i.i = tail call double @llvm.fabs.f64(double %.344.i.i.i)
  %.10.i.i.i.i = fcmp ogt double %.187.i.i.i, %.345.i.i.i
  %.11.i.i.i.i = select i1 %.10.i.i.i.i, double %.187.i.i.i, double %.345.i.i.i
  %.380.i.i.i = fcmp ogt double %.11.i.i.i.i, 0.000000e+00
  %94 = fmul double %.11.i.i.i.i, 1.200000e-05
  %"$phi194.2.2.i.i.1.i" = select i1 %.380.i.i.i, double %94, double 1.200000e-05
  %95 = getelementptr i8, ptr %93, i64 %.idx2424.i
  store double %"$phi194.2.2.i.i.1.i", ptr %95, align 8, !noalias !38
  %exitcond2416.not.i = icmp eq i64 %arg.shape.1, %.286.i.i.i
  br i1 %exitcond2416.not.i, label %B230.i.i.i, label %B84.if.i.i.i, !llvm.loop !43

B370.if.i.i.i:                                    ; preds = %B230.i.i.i, %B444.i.i.i
  %.687.i.i.02393.i = phi i64 [ %.756.i.i.i, %B444.i.i.i ], [ 0, %B230.i.i.i ]
  %.756.i.i.i = add nsw i64 %.687.i.i.02393.i, 1
  %96 = getelementptr i64, ptr %.327.i.i, i64 %.687.i.i.02393.i
  %.814.i.i.i = load i64, ptr %96, align 8, !noalias !38
  %.816.i.i.i = icmp eq i64 %.814.i.i.i, %.1382.i.sroa.0.02409.i
  br i1 %.816.i.i.i, label %B398.i.i.i, label %B444.i.i.i

B902.if.i.i.i:                                    ; preds = %B568.i.i.1.i, %B1148.i.i.i
  %.1471.i.i.02398.i = phi i64 [ %.1540.i.i.i, %B1148.i.i.i ], [ 0, %B568.i.i.1.i ]
  %.1540.i.i.i = add nsw i64 %.1471.i.i.02398.i, 1
  %97 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1471.i.i.02398.i
  %.1598.i.i.i = load double, ptr %97, align 8, !noalias !38
  %98 = getelementptr i8, ptr %97, i64 %.1807.i.idx.i
  store double %.1598.i.i.i, ptr %98, align 8, !noalias !38
  %99 = getelementptr i8, ptr %97, i64 %.1279.i.i.idx.i
  %.1666.i.i.i = load double, ptr %99, align 8, !noalias !38
  %100 = getelementptr double, ptr %arg.arrays.4.4, i64 %.1471.i.i.02398.i
  %.1697.i.i.i = load double, ptr %100, align 8, !noalias !38
  %.1743.i.i.i = fsub double %.1697.i.i.i, %.1697.i.i.i
  %.1744.i.i.i = fcmp oeq double %.1743.i.i.i, 0.000000e+00
  br i1 %.1744.i.i.i, label %B1060.i.i.i, label %B1100.i.i.i

B960.i.i:                                         ; preds = %B1148.i.i.i, %B568.i.i.1.i, %B914.i.i
  %.2256.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, 0
  %.2257.i.i = select i1 %.2256.i.i, i64 %.486.i.i, i64 0
  %101 = getelementptr i64, ptr %.502.i.i, i64 %.1382.i.sroa.0.02409.i
  %.2271.i.i = getelementptr i64, ptr %101, i64 %.2257.i.i
  %.2272.i.i = load i64, ptr %.2271.i.i, align 8, !noalias !30
  %.2290.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, -1
  %.2291.i.i = select i1 %.2290.i.i, i64 %.486.i.i, i64 0
  %102 = getelementptr i8, ptr %101, i64 8
  %.2305.i.i = getelementptr i64, ptr %102, i64 %.2291.i.i
  %.2306.i.i = load i64, ptr %.2305.i.i, align 8, !noalias !30
  %.2343.i.i = sub i64 %.2306.i.i, %.2272.i.i
  %.2386.i2400.not.i = icmp slt i64 %.2343.i.i, 1
  br i1 %.2386.i2400.not.i, label %B474.i.loopexit.i, label %B1022.if.i.i

B1080.i.i:                                        ; preds = %B1022.if.i.i
  %.2519.i.i = select i1 %.2443.i.i, i64 %.836.i.i, i64 0
  %103 = getelementptr i64, ptr %.852.i.i, i64 %.2330.i.02401.i
  %.2533.i.i = getelementptr i64, ptr %103, i64 %.2519.i.i
  %.2534.i.i = load i64, ptr %.2533.i.i, align 8, !noalias !30
  %.2535.i.i = add nsw i64 %.2534.i.i, %.503.i.i.i
  %.2549.i.i = icmp slt i64 %.2535.i.i, 0
  %.2550.i.i = select i1 %.2549.i.i, i64 %arg.arrays.0.5.0, i64 0
  %104 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2535.i.i
  %.2564.i.i = getelementptr double, ptr %104, i64 %.2550.i.i
  %.2565.i.i = load double, ptr %.2564.i.i, align 8, !noalias !30
  %.2570.i.i = fdiv double %.2490.i.i, %.2565.i.i
  %.2578.i.i = fsub double %.2570.i.i, %.2570.i.i
  %.2579.i.i = fcmp oeq double %.2578.i.i, 0.000000e+00
  %.2570.i..i = select i1 %.2579.i.i, double %.2570.i.i, double 0.000000e+00
  br label %B1162.i.i

B1162.i.i:                                        ; preds = %B1022.if.i.i, %B1080.i.i
  %slope.3.i.2.i = phi double [ %.2490.i.i, %B1022.if.i.i ], [ %.2570.i..i, %B1080.i.i ]
  %.2616.i.i = select i1 %.2443.i.i, i64 %.836.i.i, i64 0
  %105 = getelementptr i64, ptr %.852.i.i, i64 %.2330.i.02401.i
  %.2630.i.i = getelementptr i64, ptr %105, i64 %.2616.i.i
  %.2631.i.i = load i64, ptr %.2630.i.i, align 8, !noalias !30
  %.2633.i.i = icmp eq i64 %.2631.i.i, %arg.shape.1
  br i1 %.2633.i.i, label %B1186.i.i, label %B1232.i.i

B1186.i.i:                                        ; preds = %B1162.i.i
  %.2670.i.i = add nsw i64 %.2459.i.i, %.2636.i.i
  %.2685.i.i = icmp slt i64 %.2670.i.i, 0
  %.2686.i.i = select i1 %.2685.i.i, i64 %arg.arrays.0.5.0, i64 0
  %106 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2670.i.i
  %.2700.i.i = getelementptr double, ptr %106, i64 %.2686.i.i
  store double %slope.3.i.2.i, ptr %.2700.i.i, align 8, !noalias !30
  br label %B1261.i.i

B1232.i.i:                                        ; preds = %B1162.i.i
  %.2720.i.i = select i1 %.2443.i.i, i64 %.1014.i.i, i64 0
  %107 = getelementptr i64, ptr %.1030.i.i, i64 %.2330.i.02401.i
  %.2734.i.i = getelementptr i64, ptr %107, i64 %.2720.i.i
  %.2735.i.i = load i64, ptr %.2734.i.i, align 8, !noalias !30
  %.2752.i.i = icmp slt i64 %.2735.i.i, 0
  %.2753.i.i = select i1 %.2752.i.i, i64 %arg.linear.0.5.0, i64 0
  %108 = getelementptr double, ptr %arg.linear.0.4, i64 %.2735.i.i
  %.2767.i.i = getelementptr double, ptr %108, i64 %.2753.i.i
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
  %.362.i.i = add nsw i64 %.154.i.i8141, %.187.i.i
  br i1 %.409.i.i, label %B0.endif.else.endif.if.i.i, label %B0.endif.else.endif.endif.i.i, !prof !36

B0.else.endif.if.i.i:                             ; preds = %B124.i
  br label %B0.else.endif.endif.i.i

B0.else.endif.endif.i.i:                          ; preds = %B0.else.endif.if.i.i, %B124.i
  %simplifycfg.merge.i = phi i64 [ %arg.linear.1.5.0, %B0.else.endif.if.i.i ], [ 0, %B124.i ]
  %spec.select.i = select i1 %282, i64 %simplifycfg.merge.i, i64 %.226.i.i, !prof !44
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
  %.540.i.i = add i64 %.539.i.i, %.154.i.i8141
  %.541.i.i = add nsw i64 %.540.i.i, %.184.i.i8143
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
  %spec.select2366.i = select i1 %283, i64 %simplifycfg.merge2.i, i64 %.243.i.i, !prof !44
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
  %.711.i.i = shl nsw i64 %.184.i.i8143, 1
  %.712.i.i = add nsw i64 %.711.i.i, %.540.i.i
  %.759.i.i = icmp sge i64 %.597.i.i, %arg.linear.1.5.0
  br i1 %.759.i.i, label %B0.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.else.endif.endif.i.i, !prof !36

B0.endif.endif.else.endif.if.i.i:                 ; preds = %B0.endif.endif.i.i
  br label %B0.endif.endif.else.endif.endif.i.i

B0.endif.endif.else.endif.endif.i.i:              ; preds = %B0.endif.endif.else.endif.if.i.i, %B0.endif.endif.i.i
  %simplifycfg.merge4.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.i.i ]
  %109 = or i1 %.583.i.i, %.588.i.i
  %spec.select2367.i = select i1 %109, i64 %simplifycfg.merge4.i, i64 %.580.i.i, !prof !44
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
  %.889.i.i = mul nsw i64 %.184.i.i8143, 3
  %.890.i.i = add nsw i64 %.889.i.i, %.540.i.i
  %.937.i.i = icmp sge i64 %.768.i.i, %arg.linear.1.5.0
  br i1 %.937.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.i.i, !prof !36

B0.endif.endif.endif.else.endif.if.i.i:           ; preds = %B0.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.else.endif.endif.i.i:        ; preds = %B0.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.i.i
  %simplifycfg.merge6.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.i.i ]
  %110 = or i1 %.600.i.i, %.759.i.i
  %spec.select2368.i = select i1 %110, i64 %simplifycfg.merge6.i, i64 %.597.i.i, !prof !44
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
  %brmerge8832 = select i1 %min.iters.check8758, i1 true, i1 %conflict.rdx8756
  br i1 %brmerge8832, label %B330.if.i.i.preheader8777, label %vector.body8762

vector.body8762:                                  ; preds = %B330.if.i.i.preheader, %vector.body8762
  %index8763 = phi i64 [ %index.next8766, %vector.body8762 ], [ 0, %B330.if.i.i.preheader ]
  %111 = getelementptr double, ptr %arg.arrays.0.4, i64 %index8763
  %112 = getelementptr i8, ptr %111, i64 16
  %wide.load8764 = load <2 x double>, ptr %111, align 8, !noalias !30
  %wide.load8765 = load <2 x double>, ptr %112, align 8, !noalias !30
  %113 = getelementptr i8, ptr %111, i64 %.idx2421.i
  %114 = getelementptr i8, ptr %113, i64 16
  store <2 x double> %wide.load8764, ptr %113, align 8, !noalias !30
  store <2 x double> %wide.load8765, ptr %114, align 8, !noalias !30
  %115 = getelementptr i8, ptr %111, i64 %.idx2422.i
  %116 = getelementptr i8, ptr %115, i64 16
  store <2 x double> zeroinitializer, ptr %115, align 8, !noalias !30
  store <2 x double> zeroinitializer, ptr %116, align 8, !noalias !30
  %index.next8766 = add i64 %index8763, 4
  %117 = icmp eq i64 %index.next8766, %n.vec8761
  br i1 %117, label %middle.block8767, label %vector.body8762, !llvm.loop !45

middle.block8767:                                 ; preds = %vector.body8762
  br i1 %cmp.n8768, label %B412.i.i, label %B330.if.i.i.preheader8777

B330.if.i.i.preheader8777:                        ; preds = %B330.if.i.i.preheader, %middle.block8767
  %.1104.i.02380.i.ph = phi i64 [ %n.vec8761, %middle.block8767 ], [ 0, %B330.if.i.i.preheader ]
  br label %B330.if.i.i

B0.endif.endif.endif.endif.else.endif.if.i.i:     ; preds = %B0.endif.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.endif.else.endif.endif.i.i:  ; preds = %B0.endif.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.endif.i.i
  %simplifycfg.merge8.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.endif.i.i ]
  %118 = or i1 %.771.i.i, %.937.i.i
  %spec.select2369.i = select i1 %118, i64 %simplifycfg.merge8.i, i64 %.768.i.i, !prof !44
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

B330.if.i.i:                                      ; preds = %B330.if.i.i.preheader8777, %B330.if.i.i
  %.1104.i.02380.i = phi i64 [ %.1175.i.i, %B330.if.i.i ], [ %.1104.i.02380.i.ph, %B330.if.i.i.preheader8777 ]
  %.1175.i.i = add nsw i64 %.1104.i.02380.i, 1
  %119 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1104.i.02380.i
  %.1229.i.i = load double, ptr %119, align 8, !noalias !30
  %120 = getelementptr i8, ptr %119, i64 %.idx2421.i
  store double %.1229.i.i, ptr %120, align 8, !noalias !30
  %121 = getelementptr i8, ptr %119, i64 %.idx2422.i
  store double 0.000000e+00, ptr %121, align 8, !noalias !30
  %exitcond.not.i8144 = icmp eq i64 %arg.shape.1, %.1175.i.i
  br i1 %exitcond.not.i8144, label %B412.i.i, label %B330.if.i.i, !llvm.loop !46

B544.if.i.i:                                      ; preds = %B544.if.i.i.preheader8776, %B544.if.i.i
  %.1503.i.02384.i = phi i64 [ %.1565.i.i, %B544.if.i.i ], [ %.1503.i.02384.i.ph, %B544.if.i.i.preheader8776 ]
  %.1500.i.02383.i = phi i64 [ %.1569.i.i, %B544.if.i.i ], [ %.1500.i.02383.i.ph, %B544.if.i.i.preheader8776 ]
  %.1565.i.i = add nsw i64 %.1503.i.02384.i, -1
  %.1569.i.i = add nsw i64 %.1500.i.02383.i, 1
  %122 = getelementptr i64, ptr %.327.i.i, i64 %.1500.i.02383.i
  %.1627.i.i = load i64, ptr %122, align 8, !noalias !30
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
  %123 = getelementptr i64, ptr %.681.i.i, i64 %.2330.i.02401.i
  %.2458.i.i = getelementptr i64, ptr %123, i64 %.2444.i.i
  %.2459.i.i = load i64, ptr %.2458.i.i, align 8, !noalias !30
  %.2460.i.i = add nsw i64 %.2459.i.i, %.1789.i.i
  %.2474.i.i = icmp slt i64 %.2460.i.i, 0
  %.2475.i.i = select i1 %.2474.i.i, i64 %arg.arrays.0.5.0, i64 0
  %124 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2460.i.i
  %.2489.i.i = getelementptr double, ptr %124, i64 %.2475.i.i
  %.2490.i.i = load double, ptr %.2489.i.i, align 8, !noalias !30
  br i1 %found.3.i.1.i, label %B1162.i.i, label %B1080.i.i

B164.i:                                           ; preds = %B474.i.loopexit.i, %B0.endif.else.endif.endif.i, %B412.i.i
  %.634.i = load i64, ptr %arg.linear.1.4, align 8, !noalias !48
  %.664.i = load i64, ptr %.663.i, align 8, !noalias !48
  br i1 %.711.i, label %B226.if.lr.ph.i, label %B1276.if.preheader

B226.if.lr.ph.i:                                  ; preds = %B164.i
  %.829.i = add i64 %.634.i, 1
  %125 = add i64 %.664.i, %.634.i
  br label %B226.if.i

B396.i:                                           ; preds = %B342.if.i, %B226.if.i
  %.1055.i = mul i64 %.697.02414.i, %.743.sroa.0.02358.i
  %.1071.i = icmp slt i64 %.1055.i, 0
  %.1072.i8137 = select i1 %.1071.i, i64 %.251.i, i64 0
  %126 = getelementptr double, ptr %.267.i, i64 %.1055.i
  %.1086.i = getelementptr double, ptr %126, i64 %.1072.i8137
  %.1087.i8138 = load double, ptr %.1086.i, align 8, !noalias !48
  %.1141.i = load double, ptr %.1140.i, align 8, !noalias !48
  %.1142.i = fadd double %.1087.i8138, %.1141.i
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
  %127 = getelementptr i64, ptr %.437.i8132, i64 %.59.0509.i.i
  store i64 %p.2.1.lcssa.i.i, ptr %127, align 8, !noalias !49
  %.547.i.i = add nsw i64 %p.2.1.lcssa.i.i, %.161.i.i
  %.561.i.i = icmp slt i64 %.547.i.i, 0
  %.562.i.i = select i1 %.561.i.i, i64 %.251.i, i64 0
  %128 = getelementptr double, ptr %.267.i, i64 %.547.i.i
  %.576.i.i = getelementptr double, ptr %128, i64 %.562.i.i
  %.577.i.i = load double, ptr %.576.i.i, align 8, !noalias !49
  %.610.i.i = load double, ptr %130, align 8, !noalias !49
  store double %.577.i.i, ptr %130, align 8, !noalias !49
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
  %129 = getelementptr double, ptr %.267.i, i64 %.161.i.i
  %130 = getelementptr double, ptr %129, i64 %.59.0509.i.i
  %.319.i.i = sub i64 %.11.i.i.i, %.131.i.i
  %storemerge488.i.i = tail call i64 @llvm.smax.i64(i64 %.319.i.i, i64 0)
  %.362493.not.i.i = icmp slt i64 %.319.i.i, 1
  br i1 %.362493.not.i.i, label %B348.i.i, label %B234.if.preheader.i.i

B234.if.preheader.i.i:                            ; preds = %B36.if.i.i
  %.271.i.i = load double, ptr %130, align 8, !noalias !49
  %.272.i.i = tail call double @llvm.fabs.f64(double %.271.i.i)
  br label %B234.if.i.i

B234.if.i.i:                                      ; preds = %B234.if.i.i, %B234.if.preheader.i.i
  %p.2.1497.i.i = phi i64 [ %p.3.2.i.i, %B234.if.i.i ], [ %.59.0509.i.i, %B234.if.preheader.i.i ]
  %largest.2.1496.i.i = phi double [ %largest.3.2.i.i, %B234.if.i.i ], [ %.272.i.i, %B234.if.preheader.i.i ]
  %.309.0495.i.i = phi i64 [ %.371.i.i, %B234.if.i.i ], [ %storemerge488.i.i, %B234.if.preheader.i.i ]
  %.306.0494.i.i = phi i64 [ %.375.i.i, %B234.if.i.i ], [ %.131.i.i, %B234.if.preheader.i.i ]
  %.371.i.i = add nsw i64 %.309.0495.i.i, -1
  %.375.i.i = add i64 %.306.0494.i.i, 1
  %.415.i.i8139 = add nsw i64 %.306.0494.i.i, %.161.i.i
  %.429.i.i = icmp slt i64 %.415.i.i8139, 0
  %.430.i.i = select i1 %.429.i.i, i64 %.251.i, i64 0
  %131 = getelementptr double, ptr %.267.i, i64 %.415.i.i8139
  %.444.i.i = getelementptr double, ptr %131, i64 %.430.i.i
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
  %132 = getelementptr double, ptr %.267.i, i64 %.798.i.i
  %.827.i2372.i = getelementptr double, ptr %132, i64 %.813.i.i
  %.828.i.i = load double, ptr %.827.i2372.i, align 8, !noalias !49
  %.861.i.i = load double, ptr %130, align 8, !noalias !49
  %.865.i.i = fdiv double %.828.i.i, %.861.i.i
  store double %.865.i.i, ptr %.827.i2372.i, align 8, !noalias !49
  %.759.i2373.i = icmp sgt i64 %.706.0500.i.i, 1
  br i1 %.759.i2373.i, label %B466.if.i.i, label %B528.i.i

B566.if.i.i:                                      ; preds = %B528.i.i, %B790.i.i
  %.932.0506.i.i = phi i64 [ %.994.i.i, %B790.i.i ], [ %.942.i.i, %B528.i.i ]
  %.929.0505.i.i = phi i64 [ %.998.i.i, %B790.i.i ], [ %.131.i.i, %B528.i.i ]
  %.994.i.i = add nsw i64 %.932.0506.i.i, -1
  %.998.i.i = add i64 %.929.0505.i.i, 1
  %133 = mul nsw i64 %.929.0505.i.i, %arg.shape.1
  %.1030.i2374.i = add nsw i64 %133, %p.2.1.lcssa.i.i
  %.1044.i.i = icmp slt i64 %.1030.i2374.i, 0
  %.1045.i.i = select i1 %.1044.i.i, i64 %.251.i, i64 0
  %134 = getelementptr double, ptr %.267.i, i64 %.1030.i2374.i
  %.1059.i.i = getelementptr double, ptr %134, i64 %.1045.i.i
  %.1060.i.i = load double, ptr %.1059.i.i, align 8, !noalias !49
  %.1068.i.i = add nsw i64 %133, %.59.0509.i.i
  %.1082.i.i = icmp slt i64 %.1068.i.i, 0
  %.1083.i.i = select i1 %.1082.i.i, i64 %.251.i, i64 0
  %135 = getelementptr double, ptr %.267.i, i64 %.1068.i.i
  %.1097.i.i = getelementptr double, ptr %135, i64 %.1083.i.i
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
  %.1296.i.i = add nsw i64 %.1199.0502.i.i, %133
  %.1310.i.i = icmp slt i64 %.1296.i.i, 0
  %.1311.i2377.i = select i1 %.1310.i.i, i64 %.251.i, i64 0
  %136 = getelementptr double, ptr %.267.i, i64 %.1296.i.i
  %.1325.i.i = getelementptr double, ptr %136, i64 %.1311.i2377.i
  %.1326.i.i = load double, ptr %.1325.i.i, align 8, !noalias !49
  %.1328.i.i = add nsw i64 %.1199.0502.i.i, %.161.i.i
  %.1342.i.i = icmp slt i64 %.1328.i.i, 0
  %.1343.i.i = select i1 %.1342.i.i, i64 %.251.i, i64 0
  %137 = getelementptr double, ptr %.267.i, i64 %.1328.i.i
  %.1357.i.i = getelementptr double, ptr %137, i64 %.1343.i.i
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
  %.437.i8132 = getelementptr i64, ptr %arg.linear.1.4, i64 %.324.sroa.0.3.i
  %.525.i8133 = load double, ptr %.524.i, align 8, !noalias !48
  %.526.i = fcmp olt double %.525.i8133, 5.000000e-01
  br i1 %.526.i, label %B124.i, label %B164.i

B226.if.i:                                        ; preds = %B396.i, %B226.if.lr.ph.i
  %.697.02414.i = phi i64 [ 0, %B226.if.lr.ph.i ], [ %.766.i, %B396.i ]
  %.766.i = add nsw i64 %.697.02414.i, 1
  %.798.i = sub i64 %.697.02414.i, %125
  %.11.i.i8134 = tail call i64 @llvm.smax.i64(i64 %.798.i, i64 0)
  %.830.i = add i64 %.829.i, %.697.02414.i
  %.11.i2378.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.830.i, i64 %arg.shape.1)
  %.896.i = sub i64 %.11.i2378.i, %.11.i.i8134
  %.9392410.not.i = icmp slt i64 %.896.i, 1
  br i1 %.9392410.not.i, label %B396.i, label %B342.if.lr.ph.i

B342.if.lr.ph.i:                                  ; preds = %B226.if.i
  %.979.i8135 = mul nsw i64 %.697.02414.i, %arg.shape.1
  br label %B342.if.i

B342.if.i:                                        ; preds = %B342.if.i, %B342.if.lr.ph.i
  %.886.02412.i = phi i64 [ %.896.i, %B342.if.lr.ph.i ], [ %.948.i, %B342.if.i ]
  %.883.02411.i = phi i64 [ %.11.i.i8134, %B342.if.lr.ph.i ], [ %.952.i, %B342.if.i ]
  %.948.i = add nsw i64 %.886.02412.i, -1
  %.952.i = add i64 %.883.02411.i, 1
  %.980.i = add nsw i64 %.883.02411.i, %.979.i8135
  %.994.i = icmp slt i64 %.980.i, 0
  %.995.i = select i1 %.994.i, i64 %arg.linear.0.5.0, i64 0
  %138 = getelementptr double, ptr %arg.linear.0.4, i64 %.980.i
  %.1009.i = getelementptr double, ptr %138, i64 %.995.i
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !48
  %.1011.i8136 = fneg double %.1010.i
  %.1030.i = select i1 %.994.i, i64 %.251.i, i64 0
  %139 = getelementptr double, ptr %.267.i, i64 %.980.i
  %.1044.i = getelementptr double, ptr %139, i64 %.1030.i
  store double %.1011.i8136, ptr %.1044.i, align 8, !noalias !48
  %.939.i = icmp sgt i64 %.886.02412.i, 1
  br i1 %.939.i, label %B342.if.i, label %B396.i

B1244.critedge:                                   ; preds = %B1000
  %.1657.c = load i64, ptr %.1656.c, align 8
  %.1702.c = inttoptr i64 %.1657.c to ptr
  tail call void %.1702.c(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B1276.if.preheader

B1276.if.preheader:                               ; preds = %B34.loopexit.i.i, %B164.i, %B1244.critedge
  br label %B1276.if

B1464:                                            ; preds = %B1276.if
  br i1 %.88.not.i, label %B0.else.endif.endif.endif.if.i8147, label %B0.else.endif.if.i8146, !prof !29

B322.i:                                           ; preds = %B192.if.i
  %.853.i8154 = load i64, ptr %arg.linear.1.4, align 8, !noalias !52
  %.883.i = load i64, ptr %.882.i, align 8, !noalias !52
  %.339.i.i8155 = add i64 %.853.i8154, 1
  br label %B34.if.i.i8156

B34.i.loopexit.i:                                 ; preds = %B198.if.i.i, %B34.if.i.i8156
  %exitcond766.not.i = icmp eq i64 %arg.shape.1, %.144.i.i
  br i1 %exitcond766.not.i, label %B314.if.i.lr.ph.i, label %B34.if.i.i8156

B314.if.i.lr.ph.i:                                ; preds = %B34.i.loopexit.i
  %140 = add i64 %.883.i, %.853.i8154
  br label %B314.if.i.i

B314.i.loopexit.i:                                ; preds = %B474.if.i.i, %B314.if.i.i
  %.683.i.i = icmp sgt i64 %.627.i.0762.in.i, 1
  br i1 %.683.i.i, label %B314.if.i.i, label %B434.if.lr.ph.i

B434.if.lr.ph.i:                                  ; preds = %B314.i.loopexit.i
  %.1110.i = mul nsw i64 %.1858, %arg.shape.1
  %invariant.gep8790 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1110.i
  br label %B434.if.i

B34.if.i.i8156:                                   ; preds = %B34.i.loopexit.i, %B322.i
  %.73.i.0754.i = phi i64 [ 0, %B322.i ], [ %.144.i.i, %B34.i.loopexit.i ]
  %.144.i.i = add nsw i64 %.73.i.0754.i, 1
  %141 = getelementptr i64, ptr %.358.i, i64 %.73.i.0754.i
  %.202.i.i = load i64, ptr %141, align 8, !noalias !55
  %.204.i.i = add nsw i64 %.202.i.i, %.887.i
  %.218.i.i = icmp slt i64 %.204.i.i, 0
  %.219.i.i = select i1 %.218.i.i, i64 %arg.arrays.0.5.0, i64 0
  %142 = getelementptr double, ptr %arg.arrays.0.4, i64 %.204.i.i
  %.233.i.i = getelementptr double, ptr %142, i64 %.219.i.i
  %.234.i.i8157 = load double, ptr %.233.i.i, align 8, !noalias !55
  %gep8489 = getelementptr double, ptr %invariant.gep8488, i64 %.73.i.0754.i
  %.270.i.i = load double, ptr %gep8489, align 8, !noalias !55
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !55
  store double %.234.i.i8157, ptr %gep8489, align 8, !noalias !55
  %.340.i.i = add i64 %.339.i.i8155, %.73.i.0754.i
  %.11.i.i.i8158 = tail call i64 @llvm.smin.i64(i64 %.340.i.i, i64 %arg.shape.1)
  %.406.i.i = sub i64 %.11.i.i.i8158, %.144.i.i
  %.449.i750.not.i = icmp slt i64 %.406.i.i, 1
  br i1 %.449.i750.not.i, label %B34.i.loopexit.i, label %B198.if.i.lr.ph.i

B198.if.i.lr.ph.i:                                ; preds = %B34.if.i.i8156
  %.521.i.i = mul nsw i64 %.73.i.0754.i, %arg.shape.1
  br label %B198.if.i.i

B198.if.i.i:                                      ; preds = %B198.if.i.i, %B198.if.i.lr.ph.i
  %.396.i.0752.i = phi i64 [ %.406.i.i, %B198.if.i.lr.ph.i ], [ %.458.i.i, %B198.if.i.i ]
  %.393.i.0751.i = phi i64 [ %.144.i.i, %B198.if.i.lr.ph.i ], [ %.462.i.i, %B198.if.i.i ]
  %.458.i.i = add nsw i64 %.396.i.0752.i, -1
  %.462.i.i = add i64 %.393.i.0751.i, 1
  %.488.i.i = add nsw i64 %.393.i.0751.i, %.887.i
  %.502.i.i8159 = icmp slt i64 %.488.i.i, 0
  %.503.i.i = select i1 %.502.i.i8159, i64 %arg.arrays.0.5.0, i64 0
  %143 = getelementptr double, ptr %arg.arrays.0.4, i64 %.488.i.i
  %.517.i.i = getelementptr double, ptr %143, i64 %.503.i.i
  %.518.i.i = load double, ptr %.517.i.i, align 8, !noalias !55
  %.522.i.i = add nsw i64 %.393.i.0751.i, %.521.i.i
  %.536.i.i = icmp slt i64 %.522.i.i, 0
  %.537.i.i = select i1 %.536.i.i, i64 %.165.i, i64 0
  %144 = getelementptr double, ptr %.181.i, i64 %.522.i.i
  %.551.i.i = getelementptr double, ptr %144, i64 %.537.i.i
  %.552.i.i = load double, ptr %.551.i.i, align 8, !noalias !55
  %.554.i.i = fmul double %.234.i.i8157, %.552.i.i
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
  %145 = getelementptr double, ptr %arg.arrays.0.4, i64 %.726.i.i
  %.755.i.i = getelementptr double, ptr %145, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i, align 8, !noalias !55
  %.759.i.i8160 = mul nsw i64 %.627.i.0762.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i8160, %.627.i.0762.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %.165.i, i64 0
  %146 = getelementptr double, ptr %.181.i, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %146, i64 %.776.i.i
  %.791.i.i = load double, ptr %.790.i.i, align 8, !noalias !55
  %.795.i.i = fdiv double %.756.i.i, %.791.i.i
  store double %.795.i.i, ptr %.755.i.i, align 8, !noalias !55
  %.866.i.i = sub i64 %.627.i.0762.i, %140
  %.11.i4.i.i = tail call i64 @llvm.smax.i64(i64 %.866.i.i, i64 0)
  %.932.i.i = sub i64 %.627.i.0762.i, %.11.i4.i.i
  %.975.i756.not.i = icmp slt i64 %.932.i.i, 1
  br i1 %.975.i756.not.i, label %B314.i.loopexit.i, label %B474.if.i.i

B474.if.i.i:                                      ; preds = %B314.if.i.i, %B474.if.i.i
  %.922.i.0758.i = phi i64 [ %.984.i.i, %B474.if.i.i ], [ %.932.i.i, %B314.if.i.i ]
  %.919.i.0757.i = phi i64 [ %.988.i.i, %B474.if.i.i ], [ %.11.i4.i.i, %B314.if.i.i ]
  %.984.i.i = add nsw i64 %.922.i.0758.i, -1
  %.988.i.i = add i64 %.919.i.0757.i, 1
  %.1014.i.i8161 = add nsw i64 %.919.i.0757.i, %.887.i
  %.1028.i.i = icmp slt i64 %.1014.i.i8161, 0
  %.1029.i.i = select i1 %.1028.i.i, i64 %arg.arrays.0.5.0, i64 0
  %147 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1014.i.i8161
  %.1043.i.i = getelementptr double, ptr %147, i64 %.1029.i.i
  %.1044.i.i8162 = load double, ptr %.1043.i.i, align 8, !noalias !55
  %.1048.i.i = add nsw i64 %.919.i.0757.i, %.759.i.i8160
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %.165.i, i64 0
  %148 = getelementptr double, ptr %.181.i, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %148, i64 %.1063.i.i
  %.1078.i.i = load double, ptr %.1077.i.i, align 8, !noalias !55
  %.1080.i.i = fmul double %.795.i.i, %.1078.i.i
  %.1081.i.i = fsub double %.1044.i.i8162, %.1080.i.i
  store double %.1081.i.i, ptr %.1043.i.i, align 8, !noalias !55
  %.975.i.i = icmp sgt i64 %.922.i.0758.i, 1
  br i1 %.975.i.i, label %B474.if.i.i, label %B314.i.loopexit.i

B0.else.endif.if.i8146:                           ; preds = %B1464
  br label %B0.else.endif.endif.endif.if.i8147

B0.else.endif.endif.endif.if.i8147:               ; preds = %B0.else.endif.if.i8146, %B1464
  %.68.sroa.0.3.i = phi i64 [ %arg.linear.0.5.0, %B0.else.endif.if.i8146 ], [ %.42.i, %B1464 ]
  %.156.i = sub nsw i64 %arg.linear.0.5.0, %.68.sroa.0.3.i
  %.165.i = tail call i64 @llvm.smax.i64(i64 %.156.i, i64 0)
  %.181.i = getelementptr double, ptr %arg.linear.0.4, i64 %.68.sroa.0.3.i
  br i1 %.265.i, label %B0.endif.else.endif.if.i8164, label %B0.endif.else.endif.endif.i8148, !prof !36

B0.endif.else.endif.if.i8164:                     ; preds = %B0.else.endif.endif.endif.if.i8147
  br label %B0.endif.else.endif.endif.i8148

B0.endif.else.endif.endif.i8148:                  ; preds = %B0.endif.else.endif.if.i8164, %B0.else.endif.endif.endif.if.i8147
  %.245.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.if.i8164 ], [ 5, %B0.else.endif.endif.endif.if.i8147 ]
  %.358.i = getelementptr i64, ptr %arg.linear.1.4, i64 %.245.sroa.0.3.i
  br i1 %.277.i, label %B0.endif.endif.else.if.i, label %B0.endif.endif.else.endif.i, !prof !36

B192.if.lr.ph.i:                                  ; preds = %B0.endif.endif.else.endif.endif.endif.i
  %.689.i = mul nsw i64 %.1858, %arg.shape.1
  %invariant.gep8788 = getelementptr double, ptr %arg.arrays.0.4, i64 %.689.i
  br label %B192.if.i

B0.endif.endif.else.if.i:                         ; preds = %B0.endif.else.endif.endif.i8148
  br label %B0.endif.endif.else.endif.i

B0.endif.endif.else.endif.i:                      ; preds = %B0.endif.endif.else.if.i, %B0.endif.else.endif.endif.i8148
  %.418.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.else.if.i ], [ %.274.i8149, %B0.endif.else.endif.endif.i8148 ]
  br i1 %.282.not.i, label %B0.endif.endif.else.endif.endif.endif.i, label %B0.endif.endif.else.endif.if.i, !prof !29

B0.endif.endif.else.endif.if.i:                   ; preds = %B0.endif.endif.else.endif.i
  br label %B0.endif.endif.else.endif.endif.endif.i

B0.endif.endif.else.endif.endif.endif.i:          ; preds = %B0.endif.endif.else.endif.if.i, %B0.endif.endif.else.endif.i
  %.418.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.if.i ], [ %.418.sroa.0.1.i, %B0.endif.endif.else.endif.i ]
  %.531.i = getelementptr i64, ptr %arg.linear.1.4, i64 %.418.sroa.0.3.i
  br i1 %.648747.not.i, label %B1500, label %B192.if.lr.ph.i

B192.if.i:                                        ; preds = %B192.if.i, %B192.if.lr.ph.i
  %.590.0748.i = phi i64 [ 0, %B192.if.lr.ph.i ], [ %.661.i8151, %B192.if.i ]
  %.661.i8151 = add nsw i64 %.590.0748.i, 1
  %gep8789 = getelementptr double, ptr %invariant.gep8788, i64 %.590.0748.i
  %.720.i = load double, ptr %gep8789, align 8, !noalias !52
  %gep8487 = getelementptr double, ptr %invariant.gep8486, i64 %.590.0748.i
  %.753.i = load double, ptr %gep8487, align 8, !noalias !52
  %.754.i = fadd double %.720.i, %.753.i
  %149 = getelementptr i64, ptr %.531.i, i64 %.590.0748.i
  %.786.i = load i64, ptr %149, align 8, !noalias !52
  %.787.i = add nsw i64 %.786.i, %.756.i
  %.801.i = icmp slt i64 %.787.i, 0
  %.802.i = select i1 %.801.i, i64 %arg.arrays.0.5.0, i64 0
  %150 = getelementptr double, ptr %arg.arrays.0.4, i64 %.787.i
  %.816.i = getelementptr double, ptr %150, i64 %.802.i
  store double %.754.i, ptr %.816.i, align 8, !noalias !52
  %exitcond.not.i8153 = icmp eq i64 %arg.shape.1, %.661.i8151
  br i1 %exitcond.not.i8153, label %B322.i, label %B192.if.i

B434.if.i:                                        ; preds = %B434.if.i, %B434.if.lr.ph.i
  %.950.0764.i = phi i64 [ 0, %B434.if.lr.ph.i ], [ %.1019.i, %B434.if.i ]
  %.1019.i = add nsw i64 %.950.0764.i, 1
  %151 = getelementptr i64, ptr %.531.i, i64 %.950.0764.i
  %.1075.i = load i64, ptr %151, align 8, !noalias !52
  %.1076.i = add nsw i64 %.1075.i, %.887.i
  %.1090.i = icmp slt i64 %.1076.i, 0
  %.1091.i = select i1 %.1090.i, i64 %arg.arrays.0.5.0, i64 0
  %152 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1076.i
  %.1105.i = getelementptr double, ptr %152, i64 %.1091.i
  %.1106.i = load double, ptr %.1105.i, align 8, !noalias !52
  %gep8791 = getelementptr double, ptr %invariant.gep8790, i64 %.950.0764.i
  store double %.1106.i, ptr %gep8791, align 8, !noalias !52
  %exitcond767.not.i = icmp eq i64 %arg.shape.1, %.1019.i
  br i1 %exitcond767.not.i, label %B1500, label %B434.if.i

B1500:                                            ; preds = %B434.if.i, %B0.endif.endif.else.endif.endif.endif.i, %B1276.if
  %exitcond8608.not = icmp eq i64 %.1789.08490, %.
  br i1 %exitcond8608.not, label %B1502, label %B1276.if

B1502:                                            ; preds = %B1500
  %.2122 = load i64, ptr %.2121, align 8
  %.2167 = inttoptr i64 %.2122 to ptr
  tail call void %.2167(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %brmerge = select i1 %anew.2.1, i1 true, i1 %.539
  %or.cond8117 = select i1 %brmerge, i1 true, i1 %.2203
  %spec.select8126 = select i1 %or.cond8117, i1 true, i1 %.2208
  br i1 %.274.i, label %B1736, label %B1646.if

B1654:                                            ; preds = %B1646.if
  %153 = getelementptr double, ptr %285, i64 %.2248.08493
  %.2407 = load double, ptr %153, align 8
  %.2408 = fcmp ogt double %.2407, 5.000000e-01
  br label %B1690

B1690:                                            ; preds = %B1654, %B1646.if
  %"$phi1690.1.2.2" = phi i1 [ true, %B1646.if ], [ %.2408, %B1654 ]
  br i1 %looked.2.18496, label %B1732, label %B1696

B1696:                                            ; preds = %B1690
  %154 = getelementptr double, ptr %286, i64 %.2248.08493
  %.2482 = load double, ptr %154, align 8
  %.2483 = fcmp ogt double %.2482, 5.000000e-01
  br label %B1732

B1732:                                            ; preds = %B1696, %B1690
  %"$phi1732.1.2.2" = phi i1 [ true, %B1690 ], [ %.2483, %B1696 ]
  %.2304 = icmp sgt i64 %.2251.08494, 1
  br i1 %.2304, label %B1646.if, label %B1736

B1736:                                            ; preds = %B1732, %B1502
  %good.2.1.lcssa = phi i1 [ false, %B1502 ], [ %"$phi1690.1.2.2", %B1732 ]
  %looked.2.1.lcssa = phi i1 [ %spec.select8126, %B1502 ], [ %"$phi1732.1.2.2", %B1732 ]
  br i1 %.539, label %B1740, label %B1848

B1740:                                            ; preds = %B1736
  %.2559 = load double, ptr %.2558, align 8
  %.2614 = fsub double 1.000000e+00, %.2559
  store double %.2559, ptr %.2667, align 8
  store double %.2614, ptr %.2721, align 8
  br label %B1848

B1848:                                            ; preds = %B1740, %B1736
  %looked.2.1.lcssa.not8614 = xor i1 %looked.2.1.lcssa, true
  %brmerge8615 = or i1 %.274.i, %looked.2.1.lcssa.not8614
  br i1 %brmerge8615, label %B2390, label %B46.if.i

B1920.preheader:                                  ; preds = %B416.i
  br i1 %.274.i, label %B2390, label %B1920.if

B92.i:                                            ; preds = %B46.if.i
  %.303.i934 = getelementptr double, ptr %287, i64 %.90.i783.08500
  %.304.i935 = load double, ptr %.303.i934, align 8, !noalias !59
  %.5.i.i = fptosi double %.304.i935 to i64
  %.382.i = getelementptr double, ptr %288, i64 %.90.i783.08500
  %.383.i984 = load double, ptr %.382.i, align 8, !noalias !59
  %.5.i1.i = fptosi double %.383.i984 to i64
  %.457.i1031 = mul i64 %.243.i885, %arg.results.3.5.1
  %.461.i1035 = getelementptr i64, ptr %arg.results.3.4, i64 %.457.i1031
  %.462.i1036 = load i64, ptr %.461.i1035, align 8, !noalias !59
  %.463.i1037 = add nsw i64 %.462.i1036, %.5.i.i
  store i64 %.463.i1037, ptr %.461.i1035, align 8, !noalias !59
  %.569.i1130 = getelementptr i8, ptr %.461.i1035, i64 24
  %.570.i1131 = load i64, ptr %.569.i1130, align 8, !noalias !59
  %.571.i1132 = add nsw i64 %.570.i1131, %.5.i1.i
  store i64 %.571.i1132, ptr %.569.i1130, align 8, !noalias !59
  %.679.i1216 = getelementptr i8, ptr %.461.i1035, i64 8
  %.680.i1217 = load i64, ptr %.679.i1216, align 8, !noalias !59
  %.683.i = add nsw i64 %.5.i1.i, %.5.i.i
  %.684.i = mul nsw i64 %.683.i, %.
  %.685.i1219 = add nsw i64 %.684.i, %.5.i.i
  %.686.i1220 = add nsw i64 %.685.i1219, %.680.i1217
  store i64 %.686.i1220, ptr %.679.i1216, align 8, !noalias !59
  store double 0.000000e+00, ptr %.303.i934, align 8, !noalias !59
  store double 0.000000e+00, ptr %.382.i, align 8, !noalias !59
  br label %B416.i

B416.i:                                           ; preds = %B92.i, %B46.if.i
  %.148.i = icmp sgt i64 %.93.i784.08501, 1
  br i1 %.148.i, label %B46.if.i, label %B1920.preheader

B46.if.i:                                         ; preds = %B1848, %B416.i
  %.93.i784.08501 = phi i64 [ %.157.i1324, %B416.i ], [ %storemerge, %B1848 ]
  %.90.i783.08500 = phi i64 [ %.161.i1327, %B416.i ], [ 0, %B1848 ]
  %.157.i1324 = add nsw i64 %.93.i784.08501, -1
  %.161.i1327 = add nsw i64 %.90.i783.08500, 1
  %155 = getelementptr i64, ptr %arg.lane.1.4, i64 %.90.i783.08500
  %.243.i885 = load i64, ptr %155, align 8, !noalias !59
  %.248.i888 = icmp sgt i64 %.243.i885, -1
  br i1 %.248.i888, label %B92.i, label %B416.i

B1996:                                            ; preds = %B1920.if
  %156 = getelementptr double, ptr %290, i64 %.2829.08503
  %.3114 = load double, ptr %156, align 8
  %.3115 = fcmp ogt double %.3114, 5.000000e-01
  br i1 %.3115, label %B2034, label %B2092

B2034:                                            ; preds = %B1996
  %157 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2829.08503
  %.84.i2084 = load i64, ptr %157, align 8, !noalias !63
  %.89.i2087 = icmp sgt i64 %.84.i2084, -1
  br i1 %.89.i2087, label %B46.i2091, label %B2092

B46.i2091:                                        ; preds = %B2034
  %.120.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i2084
  %.121.i2110 = load i64, ptr %.120.i, align 8, !noalias !63
  %.122.i2111 = icmp eq i64 %.121.i2110, 0
  br i1 %.122.i2111, label %B80.i, label %B2092

B80.i:                                            ; preds = %B46.i2091
  store i64 2, ptr %.120.i, align 8, !noalias !63
  br label %B2092

B2092:                                            ; preds = %B1996, %B46.i2091, %B2034, %B80.i
  %.3229 = getelementptr double, ptr %291, i64 %.2829.08503
  %.3230 = load double, ptr %.3229, align 8
  %.3231 = fcmp ogt double %.3230, 5.000000e-01
  br i1 %.3231, label %B2130, label %B2388

B2130:                                            ; preds = %B2092
  %spec.select = select i1 %within.3.28506, i1 true, i1 %.2203
  br i1 %doubted.2.28507, label %B2240, label %B2150

B2150:                                            ; preds = %B2130
  %.3317 = mul i64 %.2995, %arg.results.3.5.1
  %.3321 = getelementptr i64, ptr %arg.results.3.4, i64 %.3317
  %.3322 = load i64, ptr %.3321, align 8
  %.3333.0 = and i64 %.3322, 127
  %.3363 = icmp eq i64 %.3333.0, 0
  br i1 %.3363, label %B2240, label %B2204

B2204:                                            ; preds = %B2150
  %.3420 = getelementptr double, ptr %292, i64 %.2829.08503
  %.3421 = load double, ptr %.3420, align 8
  %.3423 = fcmp ogt double %.3421, 0.000000e+00
  br label %B2240

B2240:                                            ; preds = %B2150, %B2204, %B2130
  %"$phi2240.1.3.4" = phi i1 [ true, %B2130 ], [ true, %B2150 ], [ %.3423, %B2204 ]
  %.3455 = icmp slt i64 %.3050, %arg.times.5.0
  br i1 %.3455, label %B2280, label %B2388

B2280:                                            ; preds = %B2240
  %.3482 = icmp slt i64 %.3050, 0
  %.3483 = select i1 %.3482, i64 %arg.times.5.0, i64 0
  %158 = getelementptr double, ptr %arg.times.4, i64 %.3050
  %.3497 = getelementptr double, ptr %158, i64 %.3483
  %.3498 = load double, ptr %.3497, align 8
  %.3552 = getelementptr double, ptr %293, i64 %.2829.08503
  %.3553 = load double, ptr %.3552, align 8
  %.3554 = fcmp ugt double %.3498, %.3553
  br i1 %.3554, label %B2388, label %B2330

B2330:                                            ; preds = %B2280
  %.3663 = fcmp olt double %.3498, %.3553
  %spec.select8118 = or i1 %spec.select, %.3663
  br label %B2388

B2388:                                            ; preds = %B1920.if, %B2330, %B2280, %B2240, %B2092
  %wanted.4.3 = phi i1 [ true, %B2330 ], [ %wanted.3.28505, %B2280 ], [ %wanted.3.28505, %B2240 ], [ %wanted.3.28505, %B2092 ], [ %wanted.3.28505, %B1920.if ]
  %within.4.3 = phi i1 [ %spec.select8118, %B2330 ], [ %spec.select, %B2280 ], [ %spec.select, %B2240 ], [ %within.3.28506, %B2092 ], [ %within.3.28506, %B1920.if ]
  %doubted.3.3 = phi i1 [ %"$phi2240.1.3.4", %B2330 ], [ %"$phi2240.1.3.4", %B2280 ], [ %"$phi2240.1.3.4", %B2240 ], [ %doubted.2.28507, %B2092 ], [ %doubted.2.28507, %B1920.if ]
  %.2894 = icmp sgt i64 %.2832.08504, 1
  br i1 %.2894, label %B1920.if, label %B2390.loopexit

B2390.loopexit:                                   ; preds = %B2388
  %159 = xor i1 %doubted.3.3, true
  %160 = select i1 %159, i1 true, i1 %.539
  %161 = select i1 %wanted.4.3, i1 true, i1 %within.4.3
  br label %B2390

B2390:                                            ; preds = %B1848, %B2390.loopexit, %B1920.preheader
  %wanted.2.1 = phi i1 [ false, %B1848 ], [ false, %B1920.preheader ], [ %161, %B2390.loopexit ]
  %within.5.1 = phi i1 [ false, %B1848 ], [ false, %B1920.preheader ], [ %within.4.3, %B2390.loopexit ]
  %doubted.4.1 = phi i1 [ true, %B1848 ], [ true, %B1920.preheader ], [ %160, %B2390.loopexit ]
  br i1 %good.2.1.lcssa, label %B2394, label %B2510

B2394:                                            ; preds = %B2390
  %.3760 = load i64, ptr %arg.code.4, align 8
  %.3810 = inttoptr i64 %.3760 to ptr
  tail call void %.3810(ptr %.490, ptr %.3784, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.3809)
  br label %B2510

B2510:                                            ; preds = %B2394, %B2390
  br i1 %doubted.4.1, label %B2586, label %B2518

B2518:                                            ; preds = %B2510
  %.3848 = load i64, ptr %.3847, align 8
  %.3893 = inttoptr i64 %.3848 to ptr
  tail call void %.3893(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B2586

B2586:                                            ; preds = %B2510, %B2518
  %162 = select i1 %.2208, i1 %good.2.1.lcssa, i1 false
  br i1 %162, label %B2606, label %B2728

B2606:                                            ; preds = %B2586
  %.3944 = load i64, ptr %.3943, align 8
  %.3991 = inttoptr i64 %.3944 to ptr
  tail call void %.3991(ptr %.490, ptr %.3965, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.274.i, label %B2728, label %B38.if.i

B104.i2360:                                       ; preds = %B38.if.i
  %.349.i2406 = getelementptr double, ptr %295, i64 %.78.i2184.08512
  %.350.i2407 = load double, ptr %.349.i2406, align 8, !noalias !66
  %.351.i2408 = fcmp ogt double %.350.i2407, 5.000000e-01
  br i1 %.351.i2408, label %B34.i.i, label %B304.i

B34.i.i:                                          ; preds = %B104.i2360, %B36.i.i
  %.48.i.i2146.0 = phi i64 [ %.119.i.i, %B36.i.i ], [ 0, %B104.i2360 ]
  %exitcond8609.not = icmp eq i64 %.48.i.i2146.0, %arg.decided
  br i1 %exitcond8609.not, label %B142.endif.i, label %B36.i.i

B36.i.i:                                          ; preds = %B34.i.i
  %.119.i.i = add i64 %.48.i.i2146.0, 1
  %.149.i.i2673 = add nsw i64 %.48.i.i2146.0, %arg.decided
  %.151.i.i2675 = mul nsw i64 %.149.i.i2673, %arg.shape.0
  %.153.i.i = add nsw i64 %.151.i.i2675, %.78.i2184.08512
  %.167.i.i = icmp slt i64 %.153.i.i, 0
  %.168.i.i2679 = select i1 %.167.i.i, i64 %arg.arrays.4.5.0, i64 0
  %163 = getelementptr double, ptr %arg.arrays.4.4, i64 %.153.i.i
  %.182.i.i = getelementptr double, ptr %163, i64 %.168.i.i2679
  %.183.i.i = load double, ptr %.182.i.i, align 8, !noalias !70
  %.184.i.i = fcmp ogt double %.183.i.i, 5.000000e-01
  br i1 %.184.i.i, label %B142.endif.i, label %B34.i.i

B190.i2471:                                       ; preds = %B142.endif.i
  store double 1.000000e+00, ptr %.234.i2305, align 8, !noalias !66
  %.503.i2567 = getelementptr double, ptr %296, i64 %.78.i2184.08512
  store double 0.000000e+00, ptr %.503.i2567, align 8, !noalias !66
  %.558.i2614 = getelementptr double, ptr %297, i64 %.78.i2184.08512
  store double 1.000000e+00, ptr %.558.i2614, align 8, !noalias !66
  %.616.i2662 = getelementptr i64, ptr %298, i64 %.78.i2184.08512
  store i64 %.363.i2195.0, ptr %.616.i2662, align 8, !noalias !66
  br label %B304.i

B304.i:                                           ; preds = %B142.endif.i, %B190.i2471, %B104.i2360, %B38.if.i
  %some.3.i.1 = phi i1 [ true, %B190.i2471 ], [ %some.2.i.08514, %B142.endif.i ], [ %some.2.i.08514, %B104.i2360 ], [ %some.2.i.08514, %B38.if.i ]
  %.136.i2238 = icmp sgt i64 %.81.i2185.08513, 1
  br i1 %.136.i2238, label %B38.if.i, label %B2728

B38.if.i:                                         ; preds = %B2606, %B304.i
  %some.2.i.08514 = phi i1 [ %some.3.i.1, %B304.i ], [ false, %B2606 ]
  %.81.i2185.08513 = phi i64 [ %.145.i2694, %B304.i ], [ %storemerge, %B2606 ]
  %.78.i2184.08512 = phi i64 [ %.149.i2697, %B304.i ], [ 0, %B2606 ]
  %.145.i2694 = add nsw i64 %.81.i2185.08513, -1
  %.149.i2697 = add nsw i64 %.78.i2184.08512, 1
  %.234.i2305 = getelementptr double, ptr %294, i64 %.78.i2184.08512
  store double 0.000000e+00, ptr %.234.i2305, align 8, !noalias !66
  %.289.i2352 = getelementptr i64, ptr %arg.lane.1.4, i64 %.78.i2184.08512
  %.290.i2353 = load i64, ptr %.289.i2352, align 8, !noalias !66
  %.291.i2354 = icmp sgt i64 %.290.i2353, -1
  br i1 %.291.i2354, label %B104.i2360, label %B304.i

B142.endif.i:                                     ; preds = %B36.i.i, %B34.i.i
  %.363.i2195.0 = phi i64 [ %.48.i.i2146.0, %B36.i.i ], [ -1, %B34.i.i ]
  %.393.i2470 = icmp sgt i64 %.363.i2195.0, -1
  br i1 %.393.i2470, label %B190.i2471, label %B304.i

B2728:                                            ; preds = %B304.i, %B2606, %B2586
  %beyond.2.1 = phi i1 [ false, %B2586 ], [ false, %B2606 ], [ %some.3.i.1, %B304.i ]
  %brmerge8121 = select i1 %within.5.1, i1 true, i1 %beyond.2.1
  br i1 %brmerge8121, label %B2736, label %B3228

B2736:                                            ; preds = %B2728
  br i1 %.539, label %B3074, label %B2804.if

B3074:                                            ; preds = %B2804.if, %B2736
  %.4444 = load i64, ptr %.4443, align 8
  %.4489 = inttoptr i64 %.4444 to ptr
  tail call void %.4489(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %beyond.2.1, label %B104.if.i, label %B3186

B102.loopexit.i.critedge:                         ; preds = %B104.if.i
  %.1014.i.c = load i64, ptr %.1013.i, align 8, !noalias !74
  %.1131.i.c = inttoptr i64 %.1014.i.c to ptr
  tail call void %.1131.i.c(ptr %.490, ptr %.1105.i8167, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !74
  br label %B102.loopexit.i

B102.loopexit.i:                                  ; preds = %B1498.i, %B102.loopexit.i.critedge
  %.281.i = icmp ugt i64 %.225.01193.i, 1
  br i1 %.281.i, label %B104.if.i, label %B842.i

B138.loopexit.i:                                  ; preds = %B380.if.i, %middle.block8711, %B138.if.i
  %exitcond1198.not.i = icmp eq i64 %arg.shape.0, %.412.i
  br i1 %exitcond1198.not.i, label %B474.i, label %B138.if.i

B474.i:                                           ; preds = %B138.loopexit.i
  %.1014.i = load i64, ptr %.1013.i, align 8, !noalias !74
  %.1131.i = inttoptr i64 %.1014.i to ptr
  tail call void %.1131.i(ptr %.490, ptr %.1105.i8167, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !74
  br label %B622.if.i

B674.i:                                           ; preds = %B622.if.i
  %.1364.i = getelementptr double, ptr %299, i64 %.1157.01191.i
  %.1365.i = load double, ptr %.1364.i, align 8, !noalias !74
  %.1419.i = getelementptr double, ptr %300, i64 %.1157.01191.i
  %.1420.i = load double, ptr %.1419.i, align 8, !noalias !74
  %.1421.i = fadd double %.1365.i, %.1420.i
  %.1422.i = fmul double %.1421.i, 5.000000e-01
  br label %B34.i.i8173

B34.i.i8173:                                      ; preds = %B34.if.i.i8174, %B674.i
  %.48.i.0.i = phi i64 [ 0, %B674.i ], [ %.119.i73.i, %B34.if.i.i8174 ]
  %exitcond1199.not.i = icmp eq i64 %.48.i.0.i, %storemerge1173.i
  br i1 %exitcond1199.not.i, label %B812.i, label %B34.if.i.i8174

B80.i.i8176:                                      ; preds = %B34.if.i.i8174
  %164 = icmp sgt i64 %.48.i.0.i, -1
  br i1 %164, label %B786.i, label %B812.i

B34.if.i.i8174:                                   ; preds = %B34.i.i8173
  %.119.i73.i = add i64 %.48.i.0.i, 1
  %.149.i42.i = add nsw i64 %.48.i.0.i, %arg.decided
  %.151.i.i = mul nsw i64 %.149.i42.i, %arg.shape.0
  %.153.i44.i = add nsw i64 %.151.i.i, %.1157.01191.i
  %.167.i51.i = icmp slt i64 %.153.i44.i, 0
  %.168.i.i = select i1 %.167.i51.i, i64 %arg.arrays.4.5.0, i64 0
  %165 = getelementptr double, ptr %arg.arrays.4.4, i64 %.153.i44.i
  %.182.i.i8175 = getelementptr double, ptr %165, i64 %.168.i.i
  %.183.i63.i = load double, ptr %.182.i.i8175, align 8, !noalias !77
  %.184.i64.i = fcmp ogt double %.183.i63.i, 5.000000e-01
  br i1 %.184.i64.i, label %B80.i.i8176, label %B34.i.i8173

B786.i:                                           ; preds = %B80.i.i8176
  store double %.1422.i, ptr %.1419.i, align 8, !noalias !74
  br label %B1498.i

B812.i:                                           ; preds = %B34.i.i8173, %B80.i.i8176
  store double %.1422.i, ptr %.1364.i, align 8, !noalias !74
  br label %B1498.i

B842.i:                                           ; preds = %B102.loopexit.i
  br i1 %.274.i, label %B3186, label %B874.if.i

B978.i:                                           ; preds = %B874.if.i
  %.2010.i = load double, ptr %.1786.i, align 8, !noalias !74
  %.2011.i = tail call double @llvm.fabs.f64(double %.2010.i)
  %.2012.i = fmul double %.2011.i, 2.000000e-12
  %.2069.i = getelementptr double, ptr %299, i64 %.1635.01195.i
  %.2070.i = load double, ptr %.2069.i, align 8, !noalias !74
  %.2125.i = getelementptr double, ptr %302, i64 %.1635.01195.i
  %.2126.i = load double, ptr %.2125.i, align 8, !noalias !74
  %.2183.i = fmul double %.2126.i, 0x3D719799812DEA11
  %.10.i.i = fcmp ogt double %.2012.i, %.2183.i
  %.11.i.i8172 = select i1 %.10.i.i, double %.2012.i, double %.2183.i
  %.2071.i = fsub double 1.000000e+00, %.2070.i
  %.2127.i = fmul double %.2071.i, %.2126.i
  %.2212.i = fcmp ugt double %.2127.i, %.11.i.i8172
  br i1 %.2212.i, label %B1268.i, label %B1232.i

B1232.i:                                          ; preds = %B978.i
  store double 2.000000e+00, ptr %.1896.i, align 8, !noalias !74
  br label %B1497.i

B1268.i:                                          ; preds = %B978.i
  %166 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1635.01195.i
  %.1954.i = load i64, ptr %166, align 8, !noalias !74
  %.2331.i = getelementptr double, ptr %304, i64 %.1635.01195.i
  store double 0.000000e+00, ptr %.2331.i, align 8, !noalias !74
  %.2386.i = getelementptr double, ptr %305, i64 %.1635.01195.i
  store double 0.000000e+00, ptr %.2386.i, align 8, !noalias !74
  %.2441.i = getelementptr double, ptr %300, i64 %.1635.01195.i
  %.2442.i = load double, ptr %.2441.i, align 8, !noalias !74
  %.2497.i = load double, ptr %.2125.i, align 8, !noalias !74
  %.2498.i = fmul double %.2442.i, %.2497.i
  %.2554.i = getelementptr double, ptr %306, i64 %.1635.01195.i
  store double %.2498.i, ptr %.2554.i, align 8, !noalias !74
  %.2583.i = icmp slt i64 %.1954.i, 0
  %.2584.i = select i1 %.2583.i, i64 %arg.results.3.5.0, i64 0
  %.2585.i = add i64 %.2584.i, %.1954.i
  %.2605.i = mul i64 %.2585.i, %arg.results.3.5.1
  %.2609.i = getelementptr i64, ptr %arg.results.3.4, i64 %.2605.i
  %.2610.i = load i64, ptr %.2609.i, align 8, !noalias !74
  %.2611.i = add nsw i64 %.2610.i, -1
  store i64 %.2611.i, ptr %.2609.i, align 8, !noalias !74
  %.2719.i = getelementptr i8, ptr %.2609.i, i64 24
  %.2720.i = load i64, ptr %.2719.i, align 8, !noalias !74
  %.2721.i = add nsw i64 %.2720.i, 1
  store i64 %.2721.i, ptr %.2719.i, align 8, !noalias !74
  br label %B1497.i

B1497.i:                                          ; preds = %B874.if.i, %B1268.i, %B1232.i
  %exitcond1201.not.i = icmp eq i64 %.1705.i, %arg.shape.0
  br i1 %exitcond1201.not.i, label %B3186, label %B874.if.i

B1498.i:                                          ; preds = %B622.if.i, %B812.i, %B786.i
  %exitcond1200.not.i = icmp eq i64 %arg.shape.0, %.1226.i
  br i1 %exitcond1200.not.i, label %B102.loopexit.i, label %B622.if.i

B104.if.i:                                        ; preds = %B3074, %B102.loopexit.i
  %.225.01193.i = phi i64 [ %.290.i, %B102.loopexit.i ], [ 50, %B3074 ]
  %.290.i = add nsw i64 %.225.01193.i, -1
  br i1 %.274.i, label %B102.loopexit.i.critedge, label %B138.if.i

B138.if.i:                                        ; preds = %B104.if.i, %B138.loopexit.i
  %.343.01188.i = phi i64 [ %.412.i, %B138.loopexit.i ], [ 0, %B104.if.i ]
  %.412.i = add nsw i64 %.343.01188.i, 1
  %.493.i = getelementptr double, ptr %299, i64 %.343.01188.i
  %.494.i = load double, ptr %.493.i, align 8, !noalias !74
  %.548.i8168 = getelementptr double, ptr %300, i64 %.343.01188.i
  %.549.i = load double, ptr %.548.i8168, align 8, !noalias !74
  %.550.i = fadd double %.494.i, %.549.i
  %.551.i = fmul double %.550.i, 5.000000e-01
  %.608.i = getelementptr double, ptr %301, i64 %.343.01188.i
  %.609.i = load double, ptr %.608.i, align 8, !noalias !74
  %.610.i = fcmp une double %.609.i, 1.000000e+00
  %share.3.2.i = select i1 %.610.i, double 1.000000e+00, double %.551.i
  %.668.i = getelementptr double, ptr %arg.lane.0.4, i64 %.343.01188.i
  %.669.i = load double, ptr %.668.i, align 8, !noalias !74
  %.723.i = getelementptr double, ptr %302, i64 %.343.01188.i
  %.724.i = load double, ptr %.723.i, align 8, !noalias !74
  %.726.i = fmul double %share.3.2.i, %.724.i
  %.727.i = fadd double %.669.i, %.726.i
  %.781.i = getelementptr double, ptr %.490, i64 %.343.01188.i
  store double %.727.i, ptr %.781.i, align 8, !noalias !74
  br i1 %.8631184.not.i, label %B138.loopexit.i, label %B380.if.lr.ph.i

B380.if.lr.ph.i:                                  ; preds = %B138.if.i
  %.247.i.i = fsub double 1.000000e+00, %share.3.2.i
  %invariant.gep8518 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep8520 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep8522 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep8524 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep8526 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep8528 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep8530 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep8532 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep8534 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %or.cond8773.not = xor i1 %or.cond8773, true
  %brmerge8833 = select i1 %or.cond8773.not, i1 true, i1 %conflict.rdx8690
  br i1 %brmerge8833, label %B380.if.i.preheader, label %vector.ph8693

vector.ph8693:                                    ; preds = %B380.if.lr.ph.i
  %broadcast.splatinsert8696 = insertelement <2 x double> poison, double %.247.i.i, i64 0
  %broadcast.splat8697 = shufflevector <2 x double> %broadcast.splatinsert8696, <2 x double> poison, <2 x i32> zeroinitializer
  %broadcast.splatinsert8698 = insertelement <2 x double> poison, double %share.3.2.i, i64 0
  %broadcast.splat8699 = shufflevector <2 x double> %broadcast.splatinsert8698, <2 x double> poison, <2 x i32> zeroinitializer
  %invariant.gep8792 = getelementptr double, ptr %invariant.gep8518, i64 %.155.i.i
  %invariant.gep8794 = getelementptr double, ptr %invariant.gep8520, i64 %.155.i.1.i
  %invariant.gep8796 = getelementptr double, ptr %invariant.gep8522, i64 %.155.i.2.i
  %invariant.gep8798 = getelementptr double, ptr %invariant.gep8524, i64 %.155.i.3.i
  %invariant.gep8800 = getelementptr double, ptr %invariant.gep8526, i64 %.155.i.4.i
  %invariant.gep8802 = getelementptr double, ptr %invariant.gep8528, i64 %.155.i.5.i
  %invariant.gep8804 = getelementptr double, ptr %invariant.gep8530, i64 %.155.i.6.i
  %invariant.gep8806 = getelementptr double, ptr %invariant.gep8534, i64 %.935.i
  br label %vector.body8700

vector.body8700:                                  ; preds = %vector.body8700, %vector.ph8693
  %index8701 = phi i64 [ 0, %vector.ph8693 ], [ %index.next8710, %vector.body8700 ]
  %gep8793 = getelementptr double, ptr %invariant.gep8792, i64 %index8701
  %wide.load8702 = load <2 x double>, ptr %gep8793, align 8, !noalias !81
  %167 = fadd <2 x double> %wide.load8702, zeroinitializer
  %168 = fmul <2 x double> %broadcast.splat8699, %167
  %gep8795 = getelementptr double, ptr %invariant.gep8794, i64 %index8701
  %wide.load8703 = load <2 x double>, ptr %gep8795, align 8, !noalias !81
  %169 = fadd <2 x double> %wide.load8703, %168
  %170 = fmul <2 x double> %broadcast.splat8697, %169
  %gep8797 = getelementptr double, ptr %invariant.gep8796, i64 %index8701
  %wide.load8704 = load <2 x double>, ptr %gep8797, align 8, !noalias !81
  %171 = fadd <2 x double> %wide.load8704, %170
  %172 = fmul <2 x double> %broadcast.splat8699, %171
  %gep8799 = getelementptr double, ptr %invariant.gep8798, i64 %index8701
  %wide.load8705 = load <2 x double>, ptr %gep8799, align 8, !noalias !81
  %173 = fadd <2 x double> %wide.load8705, %172
  %174 = fmul <2 x double> %broadcast.splat8697, %173
  %gep8801 = getelementptr double, ptr %invariant.gep8800, i64 %index8701
  %wide.load8706 = load <2 x double>, ptr %gep8801, align 8, !noalias !81
  %175 = fadd <2 x double> %wide.load8706, %174
  %176 = fmul <2 x double> %broadcast.splat8699, %175
  %gep8803 = getelementptr double, ptr %invariant.gep8802, i64 %index8701
  %wide.load8707 = load <2 x double>, ptr %gep8803, align 8, !noalias !81
  %177 = fadd <2 x double> %wide.load8707, %176
  %178 = fmul <2 x double> %broadcast.splat8697, %177
  %gep8805 = getelementptr double, ptr %invariant.gep8804, i64 %index8701
  %wide.load8708 = load <2 x double>, ptr %gep8805, align 8, !noalias !81
  %179 = fadd <2 x double> %wide.load8708, %178
  %180 = fmul <2 x double> %broadcast.splat8699, %179
  %181 = getelementptr double, ptr %invariant.gep8532, i64 %index8701
  %wide.load8709 = load <2 x double>, ptr %181, align 8, !noalias !81
  %182 = fadd <2 x double> %wide.load8709, %180
  %gep8807 = getelementptr double, ptr %invariant.gep8806, i64 %index8701
  store <2 x double> %182, ptr %gep8807, align 8, !noalias !74
  %index.next8710 = add i64 %index8701, 2
  %183 = icmp eq i64 %index.next8710, %n.vec8695
  br i1 %183, label %middle.block8711, label %vector.body8700, !llvm.loop !85

middle.block8711:                                 ; preds = %vector.body8700
  br i1 %cmp.n8712, label %B138.loopexit.i, label %B380.if.i.preheader

B380.if.i.preheader:                              ; preds = %B380.if.lr.ph.i, %middle.block8711
  %.807.01185.i.ph = phi i64 [ %n.vec8695, %middle.block8711 ], [ 0, %B380.if.lr.ph.i ]
  br label %B380.if.i

B380.if.i:                                        ; preds = %B380.if.i.preheader, %B380.if.i
  %.807.01185.i = phi i64 [ %.876.i, %B380.if.i ], [ %.807.01185.i.ph, %B380.if.i.preheader ]
  %.157.i.i = add nsw i64 %.807.01185.i, %.155.i.i
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep8519 = getelementptr double, ptr %invariant.gep8518, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep8519, align 8, !noalias !81
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i = fmul double %share.3.2.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.807.01185.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep8521 = getelementptr double, ptr %invariant.gep8520, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep8521, align 8, !noalias !81
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.807.01185.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep8523 = getelementptr double, ptr %invariant.gep8522, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep8523, align 8, !noalias !81
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %share.3.2.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.807.01185.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep8525 = getelementptr double, ptr %invariant.gep8524, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep8525, align 8, !noalias !81
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.807.01185.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep8527 = getelementptr double, ptr %invariant.gep8526, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep8527, align 8, !noalias !81
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %share.3.2.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.807.01185.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep8529 = getelementptr double, ptr %invariant.gep8528, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep8529, align 8, !noalias !81
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.807.01185.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep8531 = getelementptr double, ptr %invariant.gep8530, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep8531, align 8, !noalias !81
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %share.3.2.i, %.193.i.6.i
  %.876.i = add nsw i64 %.807.01185.i, 1
  %.271.i.i8169 = mul nsw i64 %.807.01185.i, %arg.shape.0
  %gep8533 = getelementptr double, ptr %invariant.gep8532, i64 %.271.i.i8169
  %.309.i.i = load double, ptr %gep8533, align 8, !noalias !81
  %.313.i.i = fadd double %.309.i.i, %.253.i.6.i
  %.936.i = add nsw i64 %.807.01185.i, %.935.i
  %.938.i = mul nsw i64 %.936.i, %arg.shape.0
  %gep8535 = getelementptr double, ptr %invariant.gep8534, i64 %.938.i
  store double %.313.i.i, ptr %gep8535, align 8, !noalias !74
  %exitcond.not.i8170 = icmp eq i64 %arg.shape.1, %.876.i
  br i1 %exitcond.not.i8170, label %B138.loopexit.i, label %B380.if.i, !llvm.loop !86

B622.if.i:                                        ; preds = %B474.i, %B1498.i
  %.1157.01191.i = phi i64 [ %.1226.i, %B1498.i ], [ 0, %B474.i ]
  %.1226.i = add nsw i64 %.1157.01191.i, 1
  %.1307.i = getelementptr double, ptr %301, i64 %.1157.01191.i
  %.1308.i = load double, ptr %.1307.i, align 8, !noalias !74
  %.1309.i = fcmp oeq double %.1308.i, 1.000000e+00
  br i1 %.1309.i, label %B674.i, label %B1498.i

B874.if.i:                                        ; preds = %B842.i, %B1497.i
  %.1635.01195.i = phi i64 [ %.1705.i, %B1497.i ], [ 0, %B842.i ]
  %.1705.i = add nsw i64 %.1635.01195.i, 1
  %.1786.i = getelementptr double, ptr %303, i64 %.1635.01195.i
  %.1787.i = load double, ptr %.1786.i, align 8, !noalias !74
  %.1841.i = getelementptr double, ptr %.490, i64 %.1635.01195.i
  store double %.1787.i, ptr %.1841.i, align 8, !noalias !74
  %.1896.i = getelementptr double, ptr %301, i64 %.1635.01195.i
  %.1897.i = load double, ptr %.1896.i, align 8, !noalias !74
  %.1898.i = fcmp oeq double %.1897.i, 1.000000e+00
  br i1 %.1898.i, label %B978.i, label %B1497.i

B3186:                                            ; preds = %B1497.i, %B842.i, %B3074
  br i1 %.4570.not, label %B3228, label %B112.if.i

B110.loopexit.i.critedge:                         ; preds = %B112.if.i
  %.846.i.c = load i64, ptr %.845.i, align 8, !noalias !87
  %.963.i.c = inttoptr i64 %.846.i.c to ptr
  tail call void %.963.i.c(ptr %.490, ptr %.937.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !87
  br label %B110.loopexit.i

B110.loopexit.i:                                  ; preds = %B678.i, %B110.loopexit.i.critedge
  %exitcond671.not.i = icmp eq i64 %.292.i, 17
  br i1 %exitcond671.not.i, label %B3228, label %B112.if.i

B166.loopexit.i:                                  ; preds = %B288.if.i, %middle.block8670, %B166.if.i
  %exitcond669.not.i = icmp eq i64 %arg.shape.0, %.419.i
  br i1 %exitcond669.not.i, label %B382.i, label %B166.if.i

B382.i:                                           ; preds = %B166.loopexit.i
  %.846.i = load i64, ptr %.845.i, align 8, !noalias !87
  %.963.i = inttoptr i64 %.846.i to ptr
  tail call void %.963.i(ptr %.490, ptr %.937.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !87
  br label %B530.if.i

B572.i:                                           ; preds = %B530.if.i
  %184 = getelementptr double, ptr %arg.arrays.4.4, i64 %.989.0665.i
  %.1173.i = load double, ptr %184, align 8, !noalias !87
  %.1175.i = fcmp olt double %.1173.i, -1.000000e-09
  br i1 %.1175.i, label %B608.i, label %B678.i

B608.i:                                           ; preds = %B572.i
  %185 = getelementptr i64, ptr %arg.lane.1.4, i64 %.989.0665.i
  %.84.i35.i = load i64, ptr %185, align 8, !noalias !90
  %.89.i37.i = icmp sgt i64 %.84.i35.i, -1
  br i1 %.89.i37.i, label %B46.i.i8230, label %B608.endif.i

B46.i.i8230:                                      ; preds = %B608.i
  %.120.i51.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i35.i
  %.121.i.i8231 = load i64, ptr %.120.i51.i, align 8, !noalias !90
  %.122.i.i8232 = icmp eq i64 %.121.i.i8231, 0
  br i1 %.122.i.i8232, label %B80.i.i8233, label %B608.endif.i

B80.i.i8233:                                      ; preds = %B46.i.i8230
  store i64 4, ptr %.120.i51.i, align 8, !noalias !90
  br label %B608.endif.i

B678.i:                                           ; preds = %B608.endif.i, %B530.if.i, %B572.i
  %exitcond670.not.i = icmp eq i64 %arg.shape.0, %.1058.i8227
  br i1 %exitcond670.not.i, label %B110.loopexit.i, label %B530.if.i

B112.if.i:                                        ; preds = %B3186, %B110.loopexit.i
  %.220.0667.i = phi i64 [ %.292.i, %B110.loopexit.i ], [ 1, %B3186 ]
  %.292.i = add nsw i64 %.220.0667.i, 1
  %186 = uitofp i64 %.220.0667.i to double
  %187 = fmul double %186, 6.250000e-02
  br i1 %.274.i, label %B110.loopexit.i.critedge, label %B166.if.lr.ph.i

B166.if.lr.ph.i:                                  ; preds = %B112.if.i
  %.247.i.i8179 = fsub double 1.000000e+00, %187
  %broadcast.splatinsert = insertelement <2 x double> poison, double %187, i64 0
  %broadcast.splat = shufflevector <2 x double> %broadcast.splatinsert, <2 x double> poison, <2 x i32> zeroinitializer
  %broadcast.splatinsert8657 = insertelement <2 x double> poison, double %.247.i.i8179, i64 0
  %broadcast.splat8658 = shufflevector <2 x double> %broadcast.splatinsert8657, <2 x double> poison, <2 x i32> zeroinitializer
  br label %B166.if.i

B166.if.i:                                        ; preds = %B166.if.lr.ph.i, %B166.loopexit.i
  %.350.0662.i = phi i64 [ 0, %B166.if.lr.ph.i ], [ %.419.i, %B166.loopexit.i ]
  %.419.i = add nsw i64 %.350.0662.i, 1
  %.500.i = getelementptr double, ptr %arg.lane.0.4, i64 %.350.0662.i
  %.501.i = load double, ptr %.500.i, align 8, !noalias !87
  %.555.i = getelementptr double, ptr %307, i64 %.350.0662.i
  %.556.i = load double, ptr %.555.i, align 8, !noalias !87
  %.558.i = fmul double %187, %.556.i
  %.559.i = fadd double %.501.i, %.558.i
  %.613.i8180 = getelementptr double, ptr %.490, i64 %.350.0662.i
  store double %.559.i, ptr %.613.i8180, align 8, !noalias !87
  br i1 %.695658.not.i, label %B166.loopexit.i, label %B288.if.preheader.i

B288.if.preheader.i:                              ; preds = %B166.if.i
  %invariant.gep8536 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep8538 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep8540 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep8542 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep8544 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep8546 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep8548 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep8550 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep8552 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %or.cond8774.not = xor i1 %or.cond8774, true
  %brmerge8834 = select i1 %or.cond8774.not, i1 true, i1 %conflict.rdx8651
  br i1 %brmerge8834, label %B288.if.i.preheader, label %vector.ph8654

vector.ph8654:                                    ; preds = %B288.if.preheader.i
  %invariant.gep8808 = getelementptr double, ptr %invariant.gep8536, i64 %.155.i.i8181
  %invariant.gep8810 = getelementptr double, ptr %invariant.gep8538, i64 %.155.i.1.i8187
  %invariant.gep8812 = getelementptr double, ptr %invariant.gep8540, i64 %.155.i.2.i8193
  %invariant.gep8814 = getelementptr double, ptr %invariant.gep8542, i64 %.155.i.3.i8199
  %invariant.gep8816 = getelementptr double, ptr %invariant.gep8544, i64 %.155.i.4.i8205
  %invariant.gep8818 = getelementptr double, ptr %invariant.gep8546, i64 %.155.i.5.i8211
  %invariant.gep8820 = getelementptr double, ptr %invariant.gep8548, i64 %.155.i.6.i8217
  %invariant.gep8822 = getelementptr double, ptr %invariant.gep8552, i64 %.767.i
  br label %vector.body8659

vector.body8659:                                  ; preds = %vector.body8659, %vector.ph8654
  %index8660 = phi i64 [ 0, %vector.ph8654 ], [ %index.next8669, %vector.body8659 ]
  %gep8809 = getelementptr double, ptr %invariant.gep8808, i64 %index8660
  %wide.load8661 = load <2 x double>, ptr %gep8809, align 8, !noalias !93
  %188 = fadd <2 x double> %wide.load8661, zeroinitializer
  %189 = fmul <2 x double> %broadcast.splat, %188
  %gep8811 = getelementptr double, ptr %invariant.gep8810, i64 %index8660
  %wide.load8662 = load <2 x double>, ptr %gep8811, align 8, !noalias !93
  %190 = fadd <2 x double> %wide.load8662, %189
  %191 = fmul <2 x double> %broadcast.splat8658, %190
  %gep8813 = getelementptr double, ptr %invariant.gep8812, i64 %index8660
  %wide.load8663 = load <2 x double>, ptr %gep8813, align 8, !noalias !93
  %192 = fadd <2 x double> %wide.load8663, %191
  %193 = fmul <2 x double> %broadcast.splat, %192
  %gep8815 = getelementptr double, ptr %invariant.gep8814, i64 %index8660
  %wide.load8664 = load <2 x double>, ptr %gep8815, align 8, !noalias !93
  %194 = fadd <2 x double> %wide.load8664, %193
  %195 = fmul <2 x double> %broadcast.splat8658, %194
  %gep8817 = getelementptr double, ptr %invariant.gep8816, i64 %index8660
  %wide.load8665 = load <2 x double>, ptr %gep8817, align 8, !noalias !93
  %196 = fadd <2 x double> %wide.load8665, %195
  %197 = fmul <2 x double> %broadcast.splat, %196
  %gep8819 = getelementptr double, ptr %invariant.gep8818, i64 %index8660
  %wide.load8666 = load <2 x double>, ptr %gep8819, align 8, !noalias !93
  %198 = fadd <2 x double> %wide.load8666, %197
  %199 = fmul <2 x double> %broadcast.splat8658, %198
  %gep8821 = getelementptr double, ptr %invariant.gep8820, i64 %index8660
  %wide.load8667 = load <2 x double>, ptr %gep8821, align 8, !noalias !93
  %200 = fadd <2 x double> %wide.load8667, %199
  %201 = fmul <2 x double> %broadcast.splat, %200
  %202 = getelementptr double, ptr %invariant.gep8550, i64 %index8660
  %wide.load8668 = load <2 x double>, ptr %202, align 8, !noalias !93
  %203 = fadd <2 x double> %wide.load8668, %201
  %gep8823 = getelementptr double, ptr %invariant.gep8822, i64 %index8660
  store <2 x double> %203, ptr %gep8823, align 8, !noalias !87
  %index.next8669 = add i64 %index8660, 2
  %204 = icmp eq i64 %index.next8669, %n.vec8656
  br i1 %204, label %middle.block8670, label %vector.body8659, !llvm.loop !97

middle.block8670:                                 ; preds = %vector.body8659
  br i1 %cmp.n8671, label %B166.loopexit.i, label %B288.if.i.preheader

B288.if.i.preheader:                              ; preds = %B288.if.preheader.i, %middle.block8670
  %.639.0659.i.ph = phi i64 [ %n.vec8656, %middle.block8670 ], [ 0, %B288.if.preheader.i ]
  br label %B288.if.i

B288.if.i:                                        ; preds = %B288.if.i.preheader, %B288.if.i
  %.639.0659.i = phi i64 [ %.708.i, %B288.if.i ], [ %.639.0659.i.ph, %B288.if.i.preheader ]
  %.157.i.i8182 = add nsw i64 %.639.0659.i, %.155.i.i8181
  %.159.i.i8183 = mul nsw i64 %.157.i.i8182, %arg.shape.0
  %gep8537 = getelementptr double, ptr %invariant.gep8536, i64 %.159.i.i8183
  %.191.i.i8184 = load double, ptr %gep8537, align 8, !noalias !93
  %.193.i.i8185 = fadd double %.191.i.i8184, 0.000000e+00
  %.253.i.i8186 = fmul double %187, %.193.i.i8185
  %.157.i.1.i8188 = add nsw i64 %.639.0659.i, %.155.i.1.i8187
  %.159.i.1.i8189 = mul nsw i64 %.157.i.1.i8188, %arg.shape.0
  %gep8539 = getelementptr double, ptr %invariant.gep8538, i64 %.159.i.1.i8189
  %.191.i.1.i8190 = load double, ptr %gep8539, align 8, !noalias !93
  %.193.i.1.i8191 = fadd double %.191.i.1.i8190, %.253.i.i8186
  %.253.i.1.i8192 = fmul double %.247.i.i8179, %.193.i.1.i8191
  %.157.i.2.i8194 = add nsw i64 %.639.0659.i, %.155.i.2.i8193
  %.159.i.2.i8195 = mul nsw i64 %.157.i.2.i8194, %arg.shape.0
  %gep8541 = getelementptr double, ptr %invariant.gep8540, i64 %.159.i.2.i8195
  %.191.i.2.i8196 = load double, ptr %gep8541, align 8, !noalias !93
  %.193.i.2.i8197 = fadd double %.191.i.2.i8196, %.253.i.1.i8192
  %.253.i.2.i8198 = fmul double %187, %.193.i.2.i8197
  %.157.i.3.i8200 = add nsw i64 %.639.0659.i, %.155.i.3.i8199
  %.159.i.3.i8201 = mul nsw i64 %.157.i.3.i8200, %arg.shape.0
  %gep8543 = getelementptr double, ptr %invariant.gep8542, i64 %.159.i.3.i8201
  %.191.i.3.i8202 = load double, ptr %gep8543, align 8, !noalias !93
  %.193.i.3.i8203 = fadd double %.191.i.3.i8202, %.253.i.2.i8198
  %.253.i.3.i8204 = fmul double %.247.i.i8179, %.193.i.3.i8203
  %.157.i.4.i8206 = add nsw i64 %.639.0659.i, %.155.i.4.i8205
  %.159.i.4.i8207 = mul nsw i64 %.157.i.4.i8206, %arg.shape.0
  %gep8545 = getelementptr double, ptr %invariant.gep8544, i64 %.159.i.4.i8207
  %.191.i.4.i8208 = load double, ptr %gep8545, align 8, !noalias !93
  %.193.i.4.i8209 = fadd double %.191.i.4.i8208, %.253.i.3.i8204
  %.253.i.4.i8210 = fmul double %187, %.193.i.4.i8209
  %.157.i.5.i8212 = add nsw i64 %.639.0659.i, %.155.i.5.i8211
  %.159.i.5.i8213 = mul nsw i64 %.157.i.5.i8212, %arg.shape.0
  %gep8547 = getelementptr double, ptr %invariant.gep8546, i64 %.159.i.5.i8213
  %.191.i.5.i8214 = load double, ptr %gep8547, align 8, !noalias !93
  %.193.i.5.i8215 = fadd double %.191.i.5.i8214, %.253.i.4.i8210
  %.253.i.5.i8216 = fmul double %.247.i.i8179, %.193.i.5.i8215
  %.157.i.6.i8218 = add nsw i64 %.639.0659.i, %.155.i.6.i8217
  %.159.i.6.i8219 = mul nsw i64 %.157.i.6.i8218, %arg.shape.0
  %gep8549 = getelementptr double, ptr %invariant.gep8548, i64 %.159.i.6.i8219
  %.191.i.6.i8220 = load double, ptr %gep8549, align 8, !noalias !93
  %.193.i.6.i8221 = fadd double %.191.i.6.i8220, %.253.i.5.i8216
  %.253.i.6.i8222 = fmul double %187, %.193.i.6.i8221
  %.708.i = add nsw i64 %.639.0659.i, 1
  %.271.i.i8223 = mul nsw i64 %.639.0659.i, %arg.shape.0
  %gep8551 = getelementptr double, ptr %invariant.gep8550, i64 %.271.i.i8223
  %.309.i.i8224 = load double, ptr %gep8551, align 8, !noalias !93
  %.313.i.i8225 = fadd double %.309.i.i8224, %.253.i.6.i8222
  %.768.i = add nsw i64 %.639.0659.i, %.767.i
  %.770.i = mul nsw i64 %.768.i, %arg.shape.0
  %gep8553 = getelementptr double, ptr %invariant.gep8552, i64 %.770.i
  store double %.313.i.i8225, ptr %gep8553, align 8, !noalias !87
  %exitcond.not.i8226 = icmp eq i64 %arg.shape.1, %.708.i
  br i1 %exitcond.not.i8226, label %B166.loopexit.i, label %B288.if.i, !llvm.loop !98

B530.if.i:                                        ; preds = %B382.i, %B678.i
  %.989.0665.i = phi i64 [ %.1058.i8227, %B678.i ], [ 0, %B382.i ]
  %.1058.i8227 = add nsw i64 %.989.0665.i, 1
  %205 = getelementptr double, ptr %308, i64 %.989.0665.i
  %.1140.i8228 = load double, ptr %205, align 8, !noalias !87
  %.1141.i8229 = fcmp ogt double %.1140.i8228, 5.000000e-01
  br i1 %.1141.i8229, label %B572.i, label %B678.i

B608.endif.i:                                     ; preds = %B80.i.i8233, %B46.i.i8230, %B608.i
  store double 0.000000e+00, ptr %205, align 8, !noalias !87
  br label %B678.i

B3228:                                            ; preds = %B110.loopexit.i, %B2728, %B3186
  br i1 %wanted.2.1, label %B3236, label %B3288

B3236:                                            ; preds = %B3228
  %within.5.1.not = xor i1 %within.5.1, true
  %brmerge8123 = select i1 %within.5.1.not, i1 true, i1 %.539
  %"$phi3272.7.2.2" = select i1 %brmerge8123, i64 0, i64 3
  br i1 %.274.i, label %B3288, label %B76.if.i

B152.i:                                           ; preds = %B76.if.i
  %.445.i = getelementptr double, ptr %310, i64 %.173.0633.i
  %.446.i = load double, ptr %.445.i, align 8, !noalias !99
  %.447.i = fcmp olt double %.446.i, 5.000000e-01
  br i1 %.447.i, label %B725.i, label %B190.i8238

B190.i8238:                                       ; preds = %B152.i
  %.478.i = getelementptr i64, ptr %arg.results.1.4, i64 %.327.i8235
  %.479.i8239 = load i64, ptr %.478.i, align 8, !noalias !99
  %.480.not.i = icmp eq i64 %.479.i8239, 0
  br i1 %.480.not.i, label %B226.i, label %B725.i

B226.i:                                           ; preds = %B190.i8238
  %.542.i = mul i64 %.327.i8235, %arg.results.3.5.1
  %206 = getelementptr i64, ptr %arg.results.3.4, i64 %.542.i
  %.546.i = getelementptr i8, ptr %206, i64 8
  %.547.i = load i64, ptr %.546.i, align 8, !noalias !99
  %.549.i8240 = add nsw i64 %.547.i, %"$phi3272.7.2.2"
  store i64 %.549.i8240, ptr %.546.i, align 8, !noalias !99
  %.655.i = getelementptr double, ptr %arg.lane.0.4, i64 %.173.0633.i
  %.656.i = load double, ptr %.655.i, align 8, !noalias !99
  %.710.i = getelementptr double, ptr %311, i64 %.173.0633.i
  %.711.i8241 = load double, ptr %.710.i, align 8, !noalias !99
  %.765.i = getelementptr double, ptr %312, i64 %.173.0633.i
  %.766.i8242 = load double, ptr %.765.i, align 8, !noalias !99
  %.787.i8243 = icmp slt i64 %.382.i8236, %arg.times.5.0
  br i1 %.787.i8243, label %B400.i, label %B696.i

B400.i:                                           ; preds = %B226.i
  %.810.i = icmp slt i64 %.382.i8236, 0
  %.811.i = select i1 %.810.i, i64 %arg.times.5.0, i64 0
  %207 = getelementptr double, ptr %arg.times.4, i64 %.382.i8236
  %.825.i = getelementptr double, ptr %207, i64 %.811.i
  %.826.i = load double, ptr %.825.i, align 8, !noalias !99
  %.830.i8244 = fcmp ugt double %.826.i, %.766.i8242
  br i1 %.830.i8244, label %B696.i, label %B424.preheader.i

B424.preheader.i:                                 ; preds = %B400.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul631.i, %.327.i8235
  %208 = getelementptr double, ptr %arg.results.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep8554 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep8556 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep8558 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep8560 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep8562 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep8564 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep8566 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep8568 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep8570 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  br label %B424.i

B424.i:                                           ; preds = %B672.i, %B424.preheader.i
  %done.2.3.i = phi i64 [ %.1255.i, %B672.i ], [ %.382.i8236, %B424.preheader.i ]
  br i1 %.917628.not.i, label %B624.i, label %B454.if.lr.ph.i

B454.if.lr.ph.i:                                  ; preds = %B424.i
  %.972.i = icmp slt i64 %done.2.3.i, 0
  %.973.i = select i1 %.972.i, i64 %arg.times.5.0, i64 0
  %209 = getelementptr double, ptr %arg.times.4, i64 %done.2.3.i
  %.987.i = getelementptr double, ptr %209, i64 %.973.i
  %.1213.i = select i1 %.972.i, i64 %arg.results.0.5.1, i64 0
  %.1214.i = add i64 %.1213.i, %done.2.3.i
  %.1243.i = mul i64 %.1214.i, %arg.results.0.5.2
  %210 = getelementptr double, ptr %208, i64 %.1243.i
  br label %B454.if.i

B482.i:                                           ; preds = %B454.if.i
  %.995.i8295 = add nsw i64 %.861.0629.i, %.993.i
  %.997.i = mul nsw i64 %.995.i8295, %arg.shape.0
  %gep8571 = getelementptr double, ptr %invariant.gep8570, i64 %.997.i
  %.1029.i8296 = load double, ptr %gep8571, align 8, !noalias !99
  br label %B726.i

B624.i:                                           ; preds = %B726.i, %B424.i
  %exitcond635.not.i = icmp eq i64 %done.2.3.i, %313
  br i1 %exitcond635.not.i, label %B696.i, label %B672.i

B672.i:                                           ; preds = %B624.i
  %.1255.i = add i64 %done.2.3.i, 1
  %.1297.i8293 = icmp slt i64 %done.2.3.i, -1
  %.1298.i = select i1 %.1297.i8293, i64 %arg.times.5.0, i64 0
  %211 = getelementptr double, ptr %arg.times.4, i64 %.1255.i
  %.1312.i = getelementptr double, ptr %211, i64 %.1298.i
  %.1313.i8294 = load double, ptr %.1312.i, align 8, !noalias !99
  %.1317.i = fcmp ugt double %.1313.i8294, %.766.i8242
  br i1 %.1317.i, label %B696.i, label %B424.i

B696.i:                                           ; preds = %B672.i, %B624.i, %B400.i, %B226.i
  %done.3.2.i = phi i64 [ %.382.i8236, %B400.i ], [ %.382.i8236, %B226.i ], [ %arg.times.5.0, %B624.i ], [ %.1255.i, %B672.i ]
  store i64 %done.3.2.i, ptr %.381.i, align 8, !noalias !99
  br label %B725.i

B725.i:                                           ; preds = %B76.if.i, %B696.i, %B190.i8238, %B152.i
  %exitcond636.not.i = icmp eq i64 %.245.i, %arg.shape.0
  br i1 %exitcond636.not.i, label %B3288, label %B76.if.i

B726.i:                                           ; preds = %B38.if.i.i, %B482.i
  %.313.i.i8291.sink = phi double [ %.313.i.i8291, %B38.if.i.i ], [ %.1029.i8296, %B482.i ]
  %212 = getelementptr double, ptr %210, i64 %.861.0629.i
  store double %.313.i.i8291.sink, ptr %212, align 8, !noalias !99
  %exitcond.not.i8292 = icmp eq i64 %arg.shape.1, %.930.i
  br i1 %exitcond.not.i8292, label %B624.i, label %B454.if.i

B76.if.i:                                         ; preds = %B3236, %B725.i
  %.173.0633.i = phi i64 [ %.245.i, %B725.i ], [ 0, %B3236 ]
  %.245.i = add nsw i64 %.173.0633.i, 1
  %.326.i = getelementptr i64, ptr %arg.lane.1.4, i64 %.173.0633.i
  %.327.i8235 = load i64, ptr %.326.i, align 8, !noalias !99
  %.381.i = getelementptr i64, ptr %309, i64 %.173.0633.i
  %.382.i8236 = load i64, ptr %.381.i, align 8, !noalias !99
  %.390.i8237 = icmp slt i64 %.327.i8235, 0
  br i1 %.390.i8237, label %B725.i, label %B152.i

B454.if.i:                                        ; preds = %B726.i, %B454.if.lr.ph.i
  %.861.0629.i = phi i64 [ 0, %B454.if.lr.ph.i ], [ %.930.i, %B726.i ]
  %.930.i = add nsw i64 %.861.0629.i, 1
  %.988.i = load double, ptr %.987.i, align 8, !noalias !99
  %.990.i = fcmp oeq double %.988.i, %.766.i8242
  br i1 %.990.i, label %B482.i, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B454.if.i
  %.1138.i = fsub double %.988.i, %.656.i
  %.1143.i = fdiv double %.1138.i, %.711.i8241
  %.247.i.i8246 = fsub double 1.000000e+00, %.1143.i
  %.157.i.i8248 = add nsw i64 %.861.0629.i, %.155.i.i8247
  %.159.i.i8249 = mul nsw i64 %.157.i.i8248, %arg.shape.0
  %gep8555 = getelementptr double, ptr %invariant.gep8554, i64 %.159.i.i8249
  %.191.i.i8250 = load double, ptr %gep8555, align 8, !noalias !102
  %.193.i.i8251 = fadd double %.191.i.i8250, 0.000000e+00
  %.253.i.i8252 = fmul double %.1143.i, %.193.i.i8251
  %.157.i.1.i8254 = add nsw i64 %.861.0629.i, %.155.i.1.i8253
  %.159.i.1.i8255 = mul nsw i64 %.157.i.1.i8254, %arg.shape.0
  %gep8557 = getelementptr double, ptr %invariant.gep8556, i64 %.159.i.1.i8255
  %.191.i.1.i8256 = load double, ptr %gep8557, align 8, !noalias !102
  %.193.i.1.i8257 = fadd double %.191.i.1.i8256, %.253.i.i8252
  %.253.i.1.i8258 = fmul double %.247.i.i8246, %.193.i.1.i8257
  %.157.i.2.i8260 = add nsw i64 %.861.0629.i, %.155.i.2.i8259
  %.159.i.2.i8261 = mul nsw i64 %.157.i.2.i8260, %arg.shape.0
  %gep8559 = getelementptr double, ptr %invariant.gep8558, i64 %.159.i.2.i8261
  %.191.i.2.i8262 = load double, ptr %gep8559, align 8, !noalias !102
  %.193.i.2.i8263 = fadd double %.191.i.2.i8262, %.253.i.1.i8258
  %.253.i.2.i8264 = fmul double %.1143.i, %.193.i.2.i8263
  %.157.i.3.i8266 = add nsw i64 %.861.0629.i, %.155.i.3.i8265
  %.159.i.3.i8267 = mul nsw i64 %.157.i.3.i8266, %arg.shape.0
  %gep8561 = getelementptr double, ptr %invariant.gep8560, i64 %.159.i.3.i8267
  %.191.i.3.i8268 = load double, ptr %gep8561, align 8, !noalias !102
  %.193.i.3.i8269 = fadd double %.191.i.3.i8268, %.253.i.2.i8264
  %.253.i.3.i8270 = fmul double %.247.i.i8246, %.193.i.3.i8269
  %.157.i.4.i8272 = add nsw i64 %.861.0629.i, %.155.i.4.i8271
  %.159.i.4.i8273 = mul nsw i64 %.157.i.4.i8272, %arg.shape.0
  %gep8563 = getelementptr double, ptr %invariant.gep8562, i64 %.159.i.4.i8273
  %.191.i.4.i8274 = load double, ptr %gep8563, align 8, !noalias !102
  %.193.i.4.i8275 = fadd double %.191.i.4.i8274, %.253.i.3.i8270
  %.253.i.4.i8276 = fmul double %.1143.i, %.193.i.4.i8275
  %.157.i.5.i8278 = add nsw i64 %.861.0629.i, %.155.i.5.i8277
  %.159.i.5.i8279 = mul nsw i64 %.157.i.5.i8278, %arg.shape.0
  %gep8565 = getelementptr double, ptr %invariant.gep8564, i64 %.159.i.5.i8279
  %.191.i.5.i8280 = load double, ptr %gep8565, align 8, !noalias !102
  %.193.i.5.i8281 = fadd double %.191.i.5.i8280, %.253.i.4.i8276
  %.253.i.5.i8282 = fmul double %.247.i.i8246, %.193.i.5.i8281
  %.157.i.6.i8284 = add nsw i64 %.861.0629.i, %.155.i.6.i8283
  %.159.i.6.i8285 = mul nsw i64 %.157.i.6.i8284, %arg.shape.0
  %gep8567 = getelementptr double, ptr %invariant.gep8566, i64 %.159.i.6.i8285
  %.191.i.6.i8286 = load double, ptr %gep8567, align 8, !noalias !102
  %.193.i.6.i8287 = fadd double %.191.i.6.i8286, %.253.i.5.i8282
  %.253.i.6.i8288 = fmul double %.1143.i, %.193.i.6.i8287
  %.271.i.i8289 = mul nsw i64 %.861.0629.i, %arg.shape.0
  %gep8569 = getelementptr double, ptr %invariant.gep8568, i64 %.271.i.i8289
  %.309.i.i8290 = load double, ptr %gep8569, align 8, !noalias !102
  %.313.i.i8291 = fadd double %.309.i.i8290, %.253.i.6.i8288
  br label %B726.i

B3288:                                            ; preds = %B725.i, %B3236, %B3228
  %.4797 = load i64, ptr %.4796, align 8
  %.4842 = inttoptr i64 %.4797 to ptr
  tail call void %.4842(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %beyond.2.1.not = xor i1 %beyond.2.1, true
  %brmerge8598 = or i1 %.274.i, %beyond.2.1.not
  br i1 %brmerge8598, label %B3396, label %B46.if.i3551

B98.i2909:                                        ; preds = %B46.if.i3551
  %.306.i2956 = getelementptr double, ptr %315, i64 %.97.i2773.08574
  %.307.i2957 = load double, ptr %.306.i2956, align 8, !noalias !106
  %.308.i2958 = fcmp ogt double %.307.i2957, 5.000000e-01
  br i1 %.308.i2958, label %B136.i, label %B506.i

B136.i:                                           ; preds = %B98.i2909
  %.363.i3006 = getelementptr double, ptr %arg.lane.0.4, i64 %.97.i2773.08574
  %.364.i3007 = load double, ptr %.363.i3006, align 8, !noalias !106
  %.418.i3055 = getelementptr double, ptr %316, i64 %.97.i2773.08574
  %.419.i3056 = load double, ptr %.418.i3055, align 8, !noalias !106
  %.420.i3057 = fsub double %.364.i3007, %.419.i3056
  %.450.i3082 = load double, ptr %.449.i3081, align 8, !noalias !106
  %.480.i3107 = load double, ptr %arg.times.4, align 8, !noalias !106
  %.481.i3108 = fsub double %.450.i3082, %.480.i3107
  %.482.i3109 = fmul double %.481.i3108, 0x3E7AD7F29ABCAF48
  %.483.i3110 = fcmp olt double %.420.i3057, %.482.i3109
  br i1 %.483.i3110, label %B256.i, label %B294.i

B256.i:                                           ; preds = %B136.i
  %213 = getelementptr i64, ptr %318, i64 %.97.i2773.08574
  %.539.i3548 = load i64, ptr %213, align 8, !noalias !106
  %.540.i3549 = add nsw i64 %.539.i3548, 1
  br label %B294.i

B294.i:                                           ; preds = %B136.i, %B256.i
  %"$phi294.1.2.i.2" = phi i64 [ %.540.i3549, %B256.i ], [ 0, %B136.i ]
  %214 = getelementptr i64, ptr %319, i64 %.97.i2773.08574
  store i64 %"$phi294.1.2.i.2", ptr %214, align 8, !noalias !106
  %.660.i3209 = load double, ptr %.363.i3006, align 8, !noalias !106
  store double %.660.i3209, ptr %.418.i3055, align 8, !noalias !106
  %.769.i3294 = getelementptr double, ptr %320, i64 %.97.i2773.08574
  store double 1.000000e+00, ptr %.769.i3294, align 8, !noalias !106
  store i64 1, ptr %.722, align 8, !noalias !106
  %.855.i3362 = load i64, ptr %214, align 8, !noalias !106
  %.856.i3363 = icmp sgt i64 %.855.i3362, 1000
  br i1 %.856.i3363, label %B460.i, label %B506.i

B460.i:                                           ; preds = %B294.i
  %215 = getelementptr i64, ptr %arg.lane.1.4, i64 %.97.i2773.08574
  %.84.i.i3439 = load i64, ptr %215, align 8, !noalias !110
  %.89.i.i3442 = icmp sgt i64 %.84.i.i3439, -1
  br i1 %.89.i.i3442, label %B46.i.i3448, label %B506.i

B46.i.i3448:                                      ; preds = %B460.i
  %.120.i.i3468 = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i.i3439
  %.121.i.i3469 = load i64, ptr %.120.i.i3468, align 8, !noalias !110
  %.122.i.i3470 = icmp eq i64 %.121.i.i3469, 0
  br i1 %.122.i.i3470, label %B80.i.i3475, label %B506.i

B80.i.i3475:                                      ; preds = %B46.i.i3448
  store i64 6, ptr %.120.i.i3468, align 8, !noalias !110
  br label %B506.i

B506.i:                                           ; preds = %B80.i.i3475, %B460.i, %B46.i.i3448, %B294.i, %B98.i2909, %B46.if.i3551
  %.155.i2842 = icmp sgt i64 %.100.i2774.08573, 1
  br i1 %.155.i2842, label %B46.if.i3551, label %B3396

B46.if.i3551:                                     ; preds = %B3288, %B506.i
  %.97.i2773.08574 = phi i64 [ %.168.i3559, %B506.i ], [ 0, %B3288 ]
  %.100.i2774.08573 = phi i64 [ %.164.i3556, %B506.i ], [ %storemerge, %B3288 ]
  %.164.i3556 = add nsw i64 %.100.i2774.08573, -1
  %.168.i3559 = add nsw i64 %.97.i2773.08574, 1
  %.249.i2906 = getelementptr double, ptr %314, i64 %.97.i2773.08574
  %.250.i2907 = load double, ptr %.249.i2906, align 8, !noalias !106
  %.251.i2908 = fcmp oeq double %.250.i2907, 2.000000e+00
  br i1 %.251.i2908, label %B98.i2909, label %B506.i

B3396:                                            ; preds = %B506.i, %B3288
  %brmerge8124.not = select i1 %.4893.not, i1 %looked.2.1.lcssa, i1 false
  %brmerge8124.not.not = xor i1 %brmerge8124.not, true
  %brmerge8597 = or i1 %.274.i, %brmerge8124.not.not
  br i1 %brmerge8597, label %B3450, label %B110.if.i

B46.i.i8297:                                      ; preds = %B110.if.i
  %.135.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !113
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i8305, label %B358.i8298

B80.i.i8305:                                      ; preds = %B46.i.i8297
  %.196.i.i = getelementptr double, ptr %321, i64 %.352.01856.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !113
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B358.i8298, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i8305
  %.264.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.352.01856.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !113
  %.321.i.i = getelementptr double, ptr %322, i64 %.352.01856.i
  %.322.i.i = load double, ptr %.321.i.i, align 8, !noalias !113
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.7511852.not.i
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01858.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01858.i
  br i1 %brmerge.i, label %B358.i8298, label %B300.if.lr.ph.i

B300.if.lr.ph.i:                                  ; preds = %B122.i.i
  %.650.i = getelementptr i64, ptr %323, i64 %.352.01856.i
  %.651.i = load i64, ptr %.650.i, align 8, !noalias !118
  %.652.i = add nsw i64 %.651.i, 1
  %216 = getelementptr i64, ptr %arg.runs.2.4, i64 %.99.i.i
  %.596.i = load i64, ptr %216, align 8, !noalias !118
  %.822.i8307 = icmp slt i64 %.596.i, 0
  %.823.i8308 = select i1 %.822.i8307, i64 %arg.schedule.3.5.0, i64 0
  %.824.i = add i64 %.823.i8308, %.596.i
  %.825.i8309 = icmp slt i64 %.651.i, -1
  %.826.i8310 = select i1 %.825.i8309, i64 %arg.schedule.3.5.1, i64 0
  %.827.i = add i64 %.652.i, %.826.i8310
  %.854.i = mul i64 %.852.i, %.824.i
  %.856.i = mul i64 %.827.i, %arg.schedule.3.5.2
  %217 = getelementptr double, ptr %arg.schedule.3.4, i64 %.854.i
  %218 = getelementptr double, ptr %217, i64 %.856.i
  br label %B300.if.i

B358.i8298:                                       ; preds = %B300.if.i, %B110.if.i, %B122.i.i, %B80.i.i8305, %B46.i.i8297
  %some.3.2.i = phi i1 [ %some.2.01858.i, %B80.i.i8305 ], [ %some.2.01858.mux.i, %B122.i.i ], [ %some.2.01858.i, %B46.i.i8297 ], [ %some.2.01858.i, %B110.if.i ], [ true, %B300.if.i ]
  %exitcond1870.not.i = icmp eq i64 %arg.shape.0, %.423.i
  br i1 %exitcond1870.not.i, label %B360.i, label %B110.if.i

B360.i:                                           ; preds = %B358.i8298
  br i1 %some.3.2.i, label %B368.i, label %B3450

B368.i:                                           ; preds = %B360.i
  %.1018.i = load i64, ptr %.1017.i, align 8, !noalias !118
  %.1130.i = inttoptr i64 %.1018.i to ptr
  tail call void %.1130.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !118
  %.1161.i = load i64, ptr %.1160.i, align 8, !noalias !118
  %.1277.i = inttoptr i64 %.1161.i to ptr
  tail call void %.1277.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1276.i), !noalias !118
  br label %B600.if.i

B46.i82.i:                                        ; preds = %B600.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !119
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B980.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %321, i64 %.1303.01865.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !119
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B980.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1303.01865.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !119
  %.321.i223.i = getelementptr double, ptr %322, i64 %.1303.01865.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !119
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B980.i, label %B640.i

B640.i:                                           ; preds = %B122.i147.i
  %.1557.i = getelementptr i64, ptr %324, i64 %.1303.01865.i
  %.1558.i = load i64, ptr %.1557.i, align 8, !noalias !118
  %.1569.i = icmp sgt i64 %.1558.i, 0
  br i1 %.1569.i, label %B716.i, label %B770.i

B716.i:                                           ; preds = %B640.i
  %219 = getelementptr double, ptr %arg.times.4, i64 %.1558.i
  %.1604.i = getelementptr i8, ptr %219, i64 -8
  %.1605.i = load double, ptr %.1604.i, align 8, !noalias !118
  %.1661.i = fcmp oeq double %.1605.i, %.265.i185.i
  br label %B770.i

B770.i:                                           ; preds = %B716.i, %B640.i
  %"$phi770.1.2.1.i" = phi i1 [ %.1661.i, %B716.i ], [ false, %B640.i ]
  br i1 %.17571859.not.i, label %B980.i, label %B802.if.lr.ph.i

B802.if.lr.ph.i:                                  ; preds = %B770.i
  %.1887.i = add nsw i64 %.1558.i, -1
  %.1926.i = select i1 %.1569.i, i64 0, i64 %arg.results.0.5.1
  %.1927.i = add i64 %.1887.i, %.1926.i
  %.1954.i8304 = mul i64 %.1952.i, %.99.i78.i
  %.1956.i = mul i64 %.1927.i, %arg.results.0.5.2
  %220 = getelementptr double, ptr %arg.results.0.4, i64 %.1954.i8304
  %221 = getelementptr double, ptr %220, i64 %.1956.i
  %invariant.gep8575 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1303.01865.i
  %invariant.gep8577 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1303.01865.i
  br label %B802.if.i

B898.i:                                           ; preds = %B802.if.i
  %222 = getelementptr double, ptr %221, i64 %.1701.01860.i
  store double %.1835.i, ptr %222, align 8, !noalias !118
  br label %B920.i

B920.i:                                           ; preds = %B802.if.i, %B898.i
  %exitcond1871.not.i = icmp eq i64 %arg.shape.1, %.1770.i
  br i1 %exitcond1871.not.i, label %B922.loopexit.i, label %B802.if.i

B922.loopexit.i:                                  ; preds = %B920.i
  %223 = fcmp une double %.1842.i, 0.000000e+00
  br i1 %223, label %B934.i, label %B980.i

B934.i:                                           ; preds = %B922.loopexit.i
  %.84.i516.i = load i64, ptr %229, align 8, !noalias !122
  %.89.i518.i = icmp sgt i64 %.84.i516.i, -1
  br i1 %.89.i518.i, label %B46.i521.i, label %B980.i

B46.i521.i:                                       ; preds = %B934.i
  %.120.i539.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i516.i
  %.121.i540.i = load i64, ptr %.120.i539.i, align 8, !noalias !122
  %.122.i541.i = icmp eq i64 %.121.i540.i, 0
  br i1 %.122.i541.i, label %B80.i545.i, label %B980.i

B80.i545.i:                                       ; preds = %B46.i521.i
  store i64 3, ptr %.120.i539.i, align 8, !noalias !122
  br label %B980.i

B980.i:                                           ; preds = %B600.if.i, %B80.i545.i, %B46.i521.i, %B934.i, %B922.loopexit.i, %B770.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %exitcond1872.not.i = icmp eq i64 %arg.shape.0, %.1372.i
  br i1 %exitcond1872.not.i, label %B982.i, label %B600.if.i

B982.i:                                           ; preds = %B980.i
  br i1 %.2041.not.i, label %B3450, label %B986.i

B986.i:                                           ; preds = %B982.i
  %.2074.i = load i64, ptr %.2073.i, align 8, !noalias !118
  %.2188.i = inttoptr i64 %.2074.i to ptr
  tail call void %.2188.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !118
  br label %B1106.if.i

B46.i315.i:                                       ; preds = %B1106.if.i
  %.135.i335.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i311.i
  %.136.i336.i = load i64, ptr %.135.i335.i, align 8, !noalias !125
  %.141.i339.not.i = icmp eq i64 %.136.i336.i, 0
  br i1 %.141.i339.not.i, label %B80.i340.i, label %B1228.i

B80.i340.i:                                       ; preds = %B46.i315.i
  %.196.i377.i = getelementptr double, ptr %321, i64 %.2224.01868.i
  %.197.i378.i = load double, ptr %.196.i377.i, align 8, !noalias !125
  %.198.i379.i = fcmp olt double %.197.i378.i, 5.000000e-01
  br i1 %.198.i379.i, label %B1228.i, label %B122.i380.i

B122.i380.i:                                      ; preds = %B80.i340.i
  %.264.i417.i = getelementptr double, ptr %arg.lane.0.4, i64 %.2224.01868.i
  %.265.i418.i = load double, ptr %.264.i417.i, align 8, !noalias !125
  %.321.i456.i = getelementptr double, ptr %322, i64 %.2224.01868.i
  %.322.i457.i = load double, ptr %.321.i456.i, align 8, !noalias !125
  %.325.i459.i = fcmp une double %.265.i418.i, %.322.i457.i
  br i1 %.325.i459.i, label %B1228.i, label %B1146.i

B1146.i:                                          ; preds = %B122.i380.i
  %224 = getelementptr double, ptr %arg.arrays.4.4, i64 %.2224.01868.i
  %.2400.i = load double, ptr %224, align 8, !noalias !118
  %.2402.i8303 = fcmp olt double %.2400.i, -1.000000e-09
  br i1 %.2402.i8303, label %B80.i672.i, label %B1228.i

B80.i672.i:                                       ; preds = %B1146.i
  store i64 4, ptr %.135.i335.i, align 8, !noalias !128
  br label %B1228.i

B1228.i:                                          ; preds = %B1106.if.i, %B80.i672.i, %B1146.i, %B122.i380.i, %B80.i340.i, %B46.i315.i
  %exitcond8611.not = icmp eq i64 %arg.shape.0, %.2293.i
  br i1 %exitcond8611.not, label %B3450, label %B1106.if.i

B110.if.i:                                        ; preds = %B3396, %B358.i8298
  %some.2.01858.i = phi i1 [ %some.3.2.i, %B358.i8298 ], [ false, %B3396 ]
  %.352.01856.i = phi i64 [ %.423.i, %B358.i8298 ], [ 0, %B3396 ]
  %.423.i = add nsw i64 %.352.01856.i, 1
  %225 = getelementptr i64, ptr %arg.lane.1.4, i64 %.352.01856.i
  %.99.i.i = load i64, ptr %225, align 8, !noalias !113
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B358.i8298, label %B46.i.i8297

B300.if.i:                                        ; preds = %B300.if.i, %B300.if.lr.ph.i
  %.692.01853.i = phi i64 [ 0, %B300.if.lr.ph.i ], [ %.764.i, %B300.if.i ]
  %.764.i = add nsw i64 %.692.01853.i, 1
  %226 = getelementptr double, ptr %218, i64 %.692.01853.i
  %.861.i = load double, ptr %226, align 8, !noalias !118
  %227 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.692.01853.i
  %.891.i = load i64, ptr %227, align 8, !noalias !118
  %.893.i = mul nsw i64 %.891.i, %arg.shape.0
  %.895.i = add nsw i64 %.893.i, %.352.01856.i
  %.909.i = icmp slt i64 %.895.i, 0
  %.910.i = select i1 %.909.i, i64 %arg.arrays.1.5.0, i64 0
  %228 = getelementptr double, ptr %arg.arrays.1.4, i64 %.895.i
  %.924.i = getelementptr double, ptr %228, i64 %.910.i
  store double %.861.i, ptr %.924.i, align 8, !noalias !118
  %exitcond.not.i8311 = icmp eq i64 %arg.schedule.2.5.0, %.764.i
  br i1 %exitcond.not.i8311, label %B358.i8298, label %B300.if.i

B600.if.i:                                        ; preds = %B980.i, %B368.i
  %.1303.01865.i = phi i64 [ 0, %B368.i ], [ %.1372.i, %B980.i ]
  %.1372.i = add nsw i64 %.1303.01865.i, 1
  %229 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1303.01865.i
  %.99.i78.i = load i64, ptr %229, align 8, !noalias !119
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B980.i, label %B46.i82.i

B802.if.i:                                        ; preds = %B920.i, %B802.if.lr.ph.i
  %trouble.2.11862.i = phi double [ 0.000000e+00, %B802.if.lr.ph.i ], [ %.1842.i, %B920.i ]
  %.1701.01860.i = phi i64 [ 0, %B802.if.lr.ph.i ], [ %.1770.i, %B920.i ]
  %.1770.i = add nsw i64 %.1701.01860.i, 1
  %.1801.i = add nsw i64 %.1701.01860.i, %.1231.i8300
  %.1803.i = mul nsw i64 %.1801.i, %arg.shape.0
  %gep8576 = getelementptr double, ptr %invariant.gep8575, i64 %.1803.i
  %.1835.i = load double, ptr %gep8576, align 8, !noalias !118
  %.1840.i = fmul double %.1835.i, 0.000000e+00
  %.1842.i = fadd double %trouble.2.11862.i, %.1840.i
  %.1850.i = mul nsw i64 %.1701.01860.i, %arg.shape.0
  %gep8578 = getelementptr double, ptr %invariant.gep8577, i64 %.1850.i
  store double %.1835.i, ptr %gep8578, align 8, !noalias !118
  br i1 %"$phi770.1.2.1.i", label %B898.i, label %B920.i

B1106.if.i:                                       ; preds = %B1228.i, %B986.i
  %.2224.01868.i = phi i64 [ 0, %B986.i ], [ %.2293.i, %B1228.i ]
  %.2293.i = add nsw i64 %.2224.01868.i, 1
  %230 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2224.01868.i
  %.99.i311.i = load i64, ptr %230, align 8, !noalias !125
  %.104.i314.i = icmp slt i64 %.99.i311.i, 0
  br i1 %.104.i314.i, label %B1228.i, label %B46.i315.i

B3450:                                            ; preds = %B1228.i, %B3396, %B360.i, %B982.i
  %looked.2.1.lcssa.not = xor i1 %looked.2.1.lcssa, true
  %brmerge8599 = or i1 %.274.i, %looked.2.1.lcssa.not
  br i1 %brmerge8599, label %B4252, label %B3488.if

B3534:                                            ; preds = %B3488.if
  br i1 %.163.i36948582.not, label %B102.i, label %B46.if.i4079.preheader

B46.if.i4079.preheader:                           ; preds = %B3534
  %invariant.gep8830 = getelementptr double, ptr %arg.arrays.0.4, i64 %.5058.08586
  br label %B46.if.i4079

B102.i:                                           ; preds = %B46.if.i4079, %B3534
  %.360.i3755 = getelementptr double, ptr %arg.lane.0.4, i64 %.5058.08586
  store double 0.000000e+00, ptr %.360.i3755, align 8, !noalias !131
  %.415.i3803 = getelementptr double, ptr %354, i64 %.5058.08586
  store double 5.000000e-01, ptr %.415.i3803, align 8, !noalias !131
  %.470.i3851 = getelementptr double, ptr %355, i64 %.5058.08586
  store double 1.000000e+00, ptr %.470.i3851, align 8, !noalias !131
  %.526.i3899 = getelementptr double, ptr %356, i64 %.5058.08586
  store double 0.000000e+00, ptr %.526.i3899, align 8, !noalias !131
  %.581.i3947 = getelementptr double, ptr %357, i64 %.5058.08586
  store double 0.000000e+00, ptr %.581.i3947, align 8, !noalias !131
  %.638.i3996 = getelementptr double, ptr %358, i64 %.5058.08586
  store double 0xFFF0000000000000, ptr %.638.i3996, align 8, !noalias !131
  br label %B4279

B46.if.i4079:                                     ; preds = %B46.if.i4079.preheader, %B46.if.i4079
  %.105.i3635.08584 = phi i64 [ %.176.i4087, %B46.if.i4079 ], [ 0, %B46.if.i4079.preheader ]
  %.176.i4087 = add nsw i64 %.105.i3635.08584, 1
  %231 = getelementptr double, ptr %arg.runs.0.4, i64 %.105.i3635.08584
  %.255.i4049 = load double, ptr %231, align 8, !noalias !131
  %.257.i4051 = mul nsw i64 %.105.i3635.08584, %arg.shape.0
  %gep8831 = getelementptr double, ptr %invariant.gep8830, i64 %.257.i4051
  store double %.255.i4049, ptr %gep8831, align 8, !noalias !131
  %exitcond8613.not = icmp eq i64 %arg.shape.1, %.176.i4087
  br i1 %exitcond8613.not, label %B102.i, label %B46.if.i4079

B3574:                                            ; preds = %B3488.if
  %.5342 = mul i64 %.5220, %arg.results.3.5.1
  %.5346 = getelementptr i64, ptr %arg.results.3.4, i64 %.5342
  %.5347 = load i64, ptr %.5346, align 8
  %.5403 = getelementptr i8, ptr %.5346, i64 24
  %.5404 = load i64, ptr %.5403, align 8
  %232 = add i64 %.5347, %.5404
  %.5405 = sub i64 %arg.most, %232
  %.5410 = icmp slt i64 %.5405, 1
  br i1 %.5410, label %B3654, label %B3700

B3654:                                            ; preds = %B3574
  %233 = getelementptr i64, ptr %arg.lane.1.4, i64 %.5058.08586
  %.84.i4170 = load i64, ptr %233, align 8, !noalias !135
  %.89.i4173 = icmp sgt i64 %.84.i4170, -1
  br i1 %.89.i4173, label %B46.i4178, label %B3700

B46.i4178:                                        ; preds = %B3654
  %.120.i4203 = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i4170
  %.121.i4204 = load i64, ptr %.120.i4203, align 8, !noalias !135
  %.122.i4205 = icmp eq i64 %.121.i4204, 0
  br i1 %.122.i4205, label %B80.i4210, label %B3700

B80.i4210:                                        ; preds = %B46.i4178
  store i64 5, ptr %.120.i4203, align 8, !noalias !135
  br label %B3700

B3700:                                            ; preds = %B80.i4210, %B3654, %B46.i4178, %B3574
  %.5500 = getelementptr double, ptr %325, i64 %.5058.08586
  %.5501 = load double, ptr %.5500, align 8
  %.5502 = fcmp ogt double %.5501, 5.000000e-01
  br i1 %.5502, label %B3738, label %B3844

B3738:                                            ; preds = %B3700
  %.5557 = getelementptr double, ptr %arg.lane.0.4, i64 %.5058.08586
  %.5558 = load double, ptr %.5557, align 8
  %.5612 = getelementptr double, ptr %326, i64 %.5058.08586
  %.5613 = load double, ptr %.5612, align 8
  %.5614 = fcmp oeq double %.5558, %.5613
  br i1 %.5614, label %B3802, label %B3844

B3802:                                            ; preds = %B3738
  %.246.i4478 = load i64, ptr %.5219, align 8, !noalias !138
  %.264.i4490 = icmp slt i64 %.246.i4478, 0
  %.265.i4491 = select i1 %.264.i4490, i64 %arg.runs.2.5.0, i64 0
  %234 = getelementptr i64, ptr %arg.runs.2.4, i64 %.246.i4478
  %.279.i4505 = getelementptr i64, ptr %234, i64 %.265.i4491
  %.280.i4506 = load i64, ptr %.279.i4505, align 8, !noalias !138
  %.337.i4554 = getelementptr i64, ptr %327, i64 %.5058.08586
  %.338.i4555 = load i64, ptr %.337.i4554, align 8, !noalias !138
  %.339.i4556 = add nsw i64 %.338.i4555, 1
  store i64 %.339.i4556, ptr %.337.i4554, align 8, !noalias !138
  %.460.i4661 = icmp slt i64 %.280.i4506, 0
  %.461.i4662 = select i1 %.460.i4661, i64 %arg.schedule.1.5.0, i64 0
  %235 = getelementptr i64, ptr %arg.schedule.1.4, i64 %.280.i4506
  %.475.i4676 = getelementptr i64, ptr %235, i64 %.461.i4662
  %.476.i4677 = load i64, ptr %.475.i4676, align 8, !noalias !138
  %.477.i4678 = icmp eq i64 %.339.i4556, %.476.i4677
  br i1 %.477.i4678, label %B186.i, label %B244.i

B186.i:                                           ; preds = %B3802
  %.516.i5049 = select i1 %.264.i4490, i64 %arg.results.1.5.0, i64 0
  %236 = getelementptr i64, ptr %arg.results.1.4, i64 %.246.i4478
  %.530.i5063 = getelementptr i64, ptr %236, i64 %.516.i5049
  %.531.i5064 = load i64, ptr %.530.i5063, align 8, !noalias !138
  %.532.i5065 = icmp eq i64 %.531.i5064, 0
  br i1 %.532.i5065, label %B220.i, label %B3844

B220.i:                                           ; preds = %B186.i
  store i64 1, ptr %.530.i5063, align 8, !noalias !138
  br label %B3844

B244.i:                                           ; preds = %B3802
  %.659.i4750 = select i1 %.460.i4661, i64 %arg.schedule.0.5.0, i64 0
  %.660.i4751 = add i64 %.659.i4750, %.280.i4506
  %.661.i4752 = icmp slt i64 %.338.i4555, -1
  %.662.i4753 = select i1 %.661.i4752, i64 %arg.schedule.0.5.1, i64 0
  %.680.i4770 = mul i64 %.660.i4751, %arg.schedule.0.5.1
  %237 = getelementptr double, ptr %arg.schedule.0.4, i64 %.680.i4770
  %238 = getelementptr double, ptr %237, i64 %.339.i4556
  %.684.i4774 = getelementptr double, ptr %238, i64 %.662.i4753
  %.685.i4775 = load double, ptr %.684.i4774, align 8, !noalias !138
  store double %.685.i4775, ptr %.5612, align 8, !noalias !138
  %.797.i4871 = load i64, ptr %.337.i4554, align 8, !noalias !138
  %.822.i4891 = select i1 %.460.i4661, i64 %arg.schedule.4.5.0, i64 0
  %.823.i4892 = add i64 %.822.i4891, %.280.i4506
  %.824.i4893 = icmp slt i64 %.797.i4871, 0
  %.825.i4894 = select i1 %.824.i4893, i64 %arg.schedule.4.5.1, i64 0
  %.843.i4912 = mul i64 %.823.i4892, %arg.schedule.4.5.1
  %239 = getelementptr i64, ptr %arg.schedule.4.4, i64 %.843.i4912
  %240 = getelementptr i64, ptr %239, i64 %.797.i4871
  %.847.i4916 = getelementptr i64, ptr %240, i64 %.825.i4894
  %.848.i4917 = load i64, ptr %.847.i4916, align 8, !noalias !138
  %.851.i = icmp eq i64 %.848.i4917, 0
  br i1 %.851.i, label %B364.i, label %B412.i

B364.i:                                           ; preds = %B244.i
  %.906.i5008 = getelementptr double, ptr %328, i64 %.5058.08586
  store double 1.000000e+00, ptr %.906.i5008, align 8, !noalias !138
  br label %B456.i.sink.split

B412.i:                                           ; preds = %B244.i
  %.974.i4926 = load i64, ptr %.722, align 8, !noalias !138
  %.975.i4927 = icmp eq i64 %.974.i4926, 0
  br i1 %.975.i4927, label %B456.i.sink.split, label %B456.i

B456.i.sink.split:                                ; preds = %B412.i, %B364.i
  %.sink = phi i64 [ 1, %B364.i ], [ 2, %B412.i ]
  store i64 %.sink, ptr %.722, align 8, !noalias !138
  br label %B456.i

B456.i:                                           ; preds = %B456.i.sink.split, %B412.i
  br i1 %.1103.i8579.not, label %B3844, label %B512.if.i.lr.ph

B512.if.i.lr.ph:                                  ; preds = %B456.i
  %.1227.i = select i1 %.460.i4661, i64 %arg.schedule.3.5.0, i64 0
  %.1228.i = add i64 %.1227.i, %.280.i4506
  %.1258.i = mul i64 %.1256.i, %.1228.i
  %241 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1258.i
  br label %B512.if.i

B512.if.i:                                        ; preds = %B512.if.i.lr.ph, %B512.if.i
  %.1045.i4412.08581 = phi i64 [ 0, %B512.if.i.lr.ph ], [ %.1116.i, %B512.if.i ]
  %.1116.i = add nsw i64 %.1045.i4412.08581, 1
  %.1195.i = load i64, ptr %.337.i4554, align 8, !noalias !138
  %.1229.i = icmp slt i64 %.1195.i, 0
  %.1230.i = select i1 %.1229.i, i64 %arg.schedule.3.5.1, i64 0
  %.1231.i = add i64 %.1230.i, %.1195.i
  %.1260.i = mul i64 %.1231.i, %arg.schedule.3.5.2
  %242 = getelementptr double, ptr %241, i64 %.1260.i
  %243 = getelementptr double, ptr %242, i64 %.1045.i4412.08581
  %.1265.i = load double, ptr %243, align 8, !noalias !138
  %244 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1045.i4412.08581
  %.1295.i = load i64, ptr %244, align 8, !noalias !138
  %.1297.i = mul nsw i64 %.1295.i, %arg.shape.0
  %.1299.i = add nsw i64 %.1297.i, %.5058.08586
  %.1313.i = icmp slt i64 %.1299.i, 0
  %.1314.i = select i1 %.1313.i, i64 %arg.arrays.1.5.0, i64 0
  %245 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1299.i
  %.1328.i = getelementptr double, ptr %245, i64 %.1314.i
  store double %.1265.i, ptr %.1328.i, align 8, !noalias !138
  %exitcond8612.not = icmp eq i64 %arg.schedule.2.5.0, %.1116.i
  br i1 %exitcond8612.not, label %B3844, label %B512.if.i

B3844:                                            ; preds = %B512.if.i, %B456.i, %B220.i, %B186.i, %B3738, %B3700
  %.5720 = getelementptr i64, ptr %arg.results.1.4, i64 %.5220
  %.5721 = load i64, ptr %.5720, align 8
  %.5722.not = icmp eq i64 %.5721, 0
  br i1 %.5722.not, label %B4002, label %B3878

B3878:                                            ; preds = %B3844
  %.5783 = getelementptr i64, ptr %329, i64 %.5058.08586
  %.5784 = load i64, ptr %.5783, align 8
  %.5814 = getelementptr i64, ptr %arg.results.2.4, i64 %.5220
  store i64 %.5784, ptr %.5814, align 8
  store i64 -1, ptr %.5219, align 8
  %.314.i8312 = load i64, ptr %arg.lane.2.4, align 8, !noalias !142
  %.374.i8314 = load i64, ptr %.373.i8313, align 8, !noalias !142
  %.375.i8315 = icmp slt i64 %.314.i8312, %.374.i8314
  br i1 %.375.i8315, label %B130.i8441, label %B316.i8316

B130.i8441:                                       ; preds = %B3878
  %.385.i8442 = add nsw i64 %.314.i8312, 1
  store i64 %.385.i8442, ptr %arg.lane.2.4, align 8, !noalias !142
  store i64 1, ptr %.722, align 8, !noalias !142
  store i64 %.314.i8312, ptr %.5219, align 8, !noalias !142
  %.557.i8447 = getelementptr i64, ptr %330, i64 %.5058.08586
  store i64 0, ptr %.557.i8447, align 8, !noalias !142
  store i64 1, ptr %.5783, align 8, !noalias !142
  br i1 %.6961500.not.i8450, label %B316.i8316, label %B272.if.lr.ph.i8451

B272.if.lr.ph.i8451:                              ; preds = %B130.i8441
  %.757.i8452 = icmp slt i64 %.314.i8312, 0
  %.758.i8453 = select i1 %.757.i8452, i64 %arg.runs.0.5.0, i64 0
  %.759.i8454 = add i64 %.758.i8453, %.314.i8312
  %.779.i8455 = mul i64 %.759.i8454, %arg.runs.0.5.1
  %246 = getelementptr double, ptr %arg.runs.0.4, i64 %.779.i8455
  %.822.i8456 = select i1 %.757.i8452, i64 %arg.results.0.5.0, i64 0
  %.823.i8457 = add i64 %.822.i8456, %.314.i8312
  %.853.i8459 = mul i64 %.851.i8458, %.823.i8457
  %247 = getelementptr double, ptr %arg.results.0.4, i64 %.853.i8459
  br i1 %min.iters.check8625, label %B272.if.i8460.preheader, label %vector.memcheck8620

vector.memcheck8620:                              ; preds = %B272.if.lr.ph.i8451
  %248 = mul i64 %360, %.823.i8457
  %249 = mul i64 %361, %.759.i8454
  %250 = add i64 %248, %arg.results.0.48621
  %251 = add i64 %249, %arg.runs.0.48622
  %252 = sub i64 %250, %251
  %diff.check8623 = icmp ult i64 %252, 32
  br i1 %diff.check8623, label %B272.if.i8460.preheader, label %vector.body8629

vector.body8629:                                  ; preds = %vector.memcheck8620, %vector.body8629
  %index8630 = phi i64 [ %index.next8633, %vector.body8629 ], [ 0, %vector.memcheck8620 ]
  %253 = getelementptr double, ptr %246, i64 %index8630
  %254 = getelementptr i8, ptr %253, i64 16
  %wide.load8631 = load <2 x double>, ptr %253, align 8, !noalias !142
  %wide.load8632 = load <2 x double>, ptr %254, align 8, !noalias !142
  %255 = getelementptr double, ptr %247, i64 %index8630
  %256 = getelementptr i8, ptr %255, i64 16
  store <2 x double> %wide.load8631, ptr %255, align 8, !noalias !142
  store <2 x double> %wide.load8632, ptr %256, align 8, !noalias !142
  %index.next8633 = add i64 %index8630, 4
  %257 = icmp eq i64 %index.next8633, %n.vec8628
  br i1 %257, label %middle.block8634, label %vector.body8629, !llvm.loop !145

middle.block8634:                                 ; preds = %vector.body8629
  br i1 %cmp.n8635, label %B316.i8316, label %B272.if.i8460.preheader

B272.if.i8460.preheader:                          ; preds = %vector.memcheck8620, %B272.if.lr.ph.i8451, %middle.block8634
  %.638.01501.i8461.ph = phi i64 [ 0, %vector.memcheck8620 ], [ 0, %B272.if.lr.ph.i8451 ], [ %n.vec8628, %middle.block8634 ]
  br label %B272.if.i8460

B316.i8316:                                       ; preds = %B272.if.i8460, %middle.block8634, %B130.i8441, %B3878
  %m.2.0.i8317 = phi i64 [ 0, %B3878 ], [ %.314.i8312, %B130.i8441 ], [ %.314.i8312, %middle.block8634 ], [ %.314.i8312, %B272.if.i8460 ]
  br i1 %.9661503.not.i8318, label %B390.i8334, label %B346.if.lr.ph.i8319

B346.if.lr.ph.i8319:                              ; preds = %B316.i8316
  %.1027.i8320 = icmp slt i64 %m.2.0.i8317, 0
  %.1028.i8321 = select i1 %.1027.i8320, i64 %arg.runs.1.5.0, i64 0
  %.1029.i8322 = add i64 %.1028.i8321, %m.2.0.i8317
  %.1049.i8323 = mul i64 %.1029.i8322, %arg.runs.1.5.1
  %258 = getelementptr double, ptr %arg.runs.1.4, i64 %.1049.i8323
  %invariant.gep8824 = getelementptr double, ptr %arg.arrays.1.4, i64 %.5058.08586
  br label %B346.if.i8324

B390.i8334:                                       ; preds = %B346.if.i8324, %B316.i8316
  br i1 %.11851506.not.i8335, label %B516.i8357, label %B446.if.lr.ph.i8336

B446.if.lr.ph.i8336:                              ; preds = %B390.i8334
  %.1237.i8337 = icmp slt i64 %m.2.0.i8317, 0
  %.1238.i8338 = select i1 %.1237.i8337, i64 %arg.runs.2.5.0, i64 0
  %259 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i8317
  %.1252.i8339 = getelementptr i64, ptr %259, i64 %.1238.i8338
  br label %B446.if.i8341

B516.i8357:                                       ; preds = %B446.if.i8341, %B390.i8334
  br i1 %.375.i8315, label %B574.i8387, label %B520.i8358

B520.i8358:                                       ; preds = %B516.i8357
  br i1 %.1423.i8359, label %B532.i8361, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit8465

B532.i8361:                                       ; preds = %B520.i8358
  br i1 %.163.i1509.not.i8362, label %B102.i.i8373, label %B46.if.i.i8363.preheader

B46.if.i.i8363.preheader:                         ; preds = %B532.i8361
  %invariant.gep8826 = getelementptr double, ptr %arg.arrays.0.4, i64 %.5058.08586
  br label %B46.if.i.i8363

B102.i.i8373:                                     ; preds = %B46.if.i.i8363, %B532.i8361
  %.360.i.i8377 = getelementptr double, ptr %arg.lane.0.4, i64 %.5058.08586
  store double 0.000000e+00, ptr %.360.i.i8377, align 8, !noalias !146
  %.415.i.i8378 = getelementptr double, ptr %331, i64 %.5058.08586
  store double 5.000000e-01, ptr %.415.i.i8378, align 8, !noalias !146
  %.470.i.i8380 = getelementptr double, ptr %332, i64 %.5058.08586
  store double 1.000000e+00, ptr %.470.i.i8380, align 8, !noalias !146
  %.526.i.i8382 = getelementptr double, ptr %333, i64 %.5058.08586
  store double 0.000000e+00, ptr %.526.i.i8382, align 8, !noalias !146
  %.581.i.i8384 = getelementptr double, ptr %334, i64 %.5058.08586
  store double 0.000000e+00, ptr %.581.i.i8384, align 8, !noalias !146
  %.638.i.i8386 = getelementptr double, ptr %335, i64 %.5058.08586
  store double 0xFFF0000000000000, ptr %.638.i.i8386, align 8, !noalias !146
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit8465

B46.if.i.i8363:                                   ; preds = %B46.if.i.i8363.preheader, %B46.if.i.i8363
  %.105.i.01510.i8364 = phi i64 [ %.176.i.i8365, %B46.if.i.i8363 ], [ 0, %B46.if.i.i8363.preheader ]
  %.176.i.i8365 = add nsw i64 %.105.i.01510.i8364, 1
  %260 = getelementptr double, ptr %arg.runs.0.4, i64 %.105.i.01510.i8364
  %.255.i.i8366 = load double, ptr %260, align 8, !noalias !146
  %.257.i.i8367 = mul nsw i64 %.105.i.01510.i8364, %arg.shape.0
  %gep8827 = getelementptr double, ptr %invariant.gep8826, i64 %.257.i.i8367
  store double %.255.i.i8366, ptr %gep8827, align 8, !noalias !146
  %exitcond1517.not.i8372 = icmp eq i64 %arg.shape.1, %.176.i.i8365
  br i1 %exitcond1517.not.i8372, label %B102.i.i8373, label %B46.if.i.i8363

B574.i8387:                                       ; preds = %B516.i8357
  br i1 %.15851512.not.i8388, label %B648.i8404, label %B604.if.lr.ph.i8389

B604.if.lr.ph.i8389:                              ; preds = %B574.i8387
  %.1646.i8390 = icmp slt i64 %m.2.0.i8317, 0
  %.1647.i8391 = select i1 %.1646.i8390, i64 %arg.runs.0.5.0, i64 0
  %.1648.i8392 = add i64 %.1647.i8391, %m.2.0.i8317
  %.1668.i8393 = mul i64 %.1648.i8392, %arg.runs.0.5.1
  %261 = getelementptr double, ptr %arg.runs.0.4, i64 %.1668.i8393
  %invariant.gep8828 = getelementptr double, ptr %arg.arrays.0.4, i64 %.5058.08586
  br label %B604.if.i8394

B648.i8404:                                       ; preds = %B604.if.i8394, %B574.i8387
  %.1748.i8405 = load double, ptr %arg.times.4, align 8, !noalias !142
  %.1765.i8406 = icmp slt i64 %m.2.0.i8317, 0
  %.1766.i8407 = select i1 %.1765.i8406, i64 %arg.runs.2.5.0, i64 0
  %262 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i8317
  %.1780.i8408 = getelementptr i64, ptr %262, i64 %.1766.i8407
  %.1781.i8409 = load i64, ptr %.1780.i8408, align 8, !noalias !142
  %.1812.i8410 = icmp slt i64 %.1781.i8409, 0
  %.1813.i8411 = select i1 %.1812.i8410, i64 %arg.schedule.0.5.0, i64 0
  %.1814.i8412 = add i64 %.1813.i8411, %.1781.i8409
  %.1834.i8413 = mul i64 %.1814.i8412, %arg.schedule.0.5.1
  %.1838.i8414 = getelementptr double, ptr %arg.schedule.0.4, i64 %.1834.i8413
  %.1839.i8415 = load double, ptr %.1838.i8414, align 8, !noalias !142
  %.1895.i8419 = getelementptr double, ptr %arg.lane.0.4, i64 %.5058.08586
  store double %.1748.i8405, ptr %.1895.i8419, align 8, !noalias !142
  %.1950.i8421 = getelementptr double, ptr %336, i64 %.5058.08586
  store double %.1839.i8415, ptr %.1950.i8421, align 8, !noalias !142
  %.2005.i8422 = getelementptr double, ptr %337, i64 %.5058.08586
  store double 0.000000e+00, ptr %.2005.i8422, align 8, !noalias !142
  %.2064.i8424 = getelementptr double, ptr %338, i64 %.5058.08586
  store double 1.000000e+00, ptr %.2064.i8424, align 8, !noalias !142
  %.2119.i8426 = getelementptr double, ptr %339, i64 %.5058.08586
  store double 0.000000e+00, ptr %.2119.i8426, align 8, !noalias !142
  %.2175.i8428 = getelementptr double, ptr %340, i64 %.5058.08586
  store double 0xFFF0000000000000, ptr %.2175.i8428, align 8, !noalias !142
  %263 = getelementptr i64, ptr %341, i64 %.5058.08586
  store i64 0, ptr %263, align 8, !noalias !142
  %.2291.i8433 = getelementptr double, ptr %342, i64 %.5058.08586
  store double 0.000000e+00, ptr %.2291.i8433, align 8, !noalias !142
  %.2346.i8435 = getelementptr double, ptr %343, i64 %.5058.08586
  store double 0.000000e+00, ptr %.2346.i8435, align 8, !noalias !142
  %.2401.i8437 = getelementptr double, ptr %344, i64 %.5058.08586
  %.2402.i8438 = load double, ptr %.2401.i8437, align 8, !noalias !142
  %.2404.i8439 = fcmp ueq double %.2402.i8438, 0xFFF0000000000000
  br i1 %.2404.i8439, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit8465, label %B994.i8440

B994.i8440:                                       ; preds = %B648.i8404
  store double 0.000000e+00, ptr %.2401.i8437, align 8, !noalias !142
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit8465

B272.if.i8460:                                    ; preds = %B272.if.i8460.preheader, %B272.if.i8460
  %.638.01501.i8461 = phi i64 [ %.709.i8462, %B272.if.i8460 ], [ %.638.01501.i8461.ph, %B272.if.i8460.preheader ]
  %.709.i8462 = add nsw i64 %.638.01501.i8461, 1
  %264 = getelementptr double, ptr %246, i64 %.638.01501.i8461
  %.784.i8463 = load double, ptr %264, align 8, !noalias !142
  %265 = getelementptr double, ptr %247, i64 %.638.01501.i8461
  store double %.784.i8463, ptr %265, align 8, !noalias !142
  %exitcond.not.i8464 = icmp eq i64 %.709.i8462, %arg.shape.1
  br i1 %exitcond.not.i8464, label %B316.i8316, label %B272.if.i8460, !llvm.loop !150

B346.if.i8324:                                    ; preds = %B346.if.i8324, %B346.if.lr.ph.i8319
  %.910.01504.i8325 = phi i64 [ 0, %B346.if.lr.ph.i8319 ], [ %.979.i8326, %B346.if.i8324 ]
  %.979.i8326 = add nsw i64 %.910.01504.i8325, 1
  %266 = getelementptr double, ptr %258, i64 %.910.01504.i8325
  %.1054.i8327 = load double, ptr %266, align 8, !noalias !142
  %.1056.i8328 = mul nsw i64 %.910.01504.i8325, %arg.shape.0
  %gep8825 = getelementptr double, ptr %invariant.gep8824, i64 %.1056.i8328
  store double %.1054.i8327, ptr %gep8825, align 8, !noalias !142
  %exitcond1515.not.i8333 = icmp eq i64 %.979.i8326, %arg.shape.2
  br i1 %exitcond1515.not.i8333, label %B390.i8334, label %B346.if.i8324

B446.if.i8341:                                    ; preds = %B446.if.i8341, %B446.if.lr.ph.i8336
  %.1129.01507.i8342 = phi i64 [ 0, %B446.if.lr.ph.i8336 ], [ %.1198.i8343, %B446.if.i8341 ]
  %.1198.i8343 = add nsw i64 %.1129.01507.i8342, 1
  %.1253.i8344 = load i64, ptr %.1252.i8339, align 8, !noalias !142
  %.1289.i8345 = icmp slt i64 %.1253.i8344, 0
  %.1290.i8346 = select i1 %.1289.i8345, i64 %arg.schedule.3.5.0, i64 0
  %.1291.i8347 = add i64 %.1290.i8346, %.1253.i8344
  %.1321.i8348 = mul i64 %.1319.i8340, %.1291.i8347
  %267 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1321.i8348
  %268 = getelementptr double, ptr %267, i64 %.1129.01507.i8342
  %.1328.i8349 = load double, ptr %268, align 8, !noalias !142
  %269 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1129.01507.i8342
  %.1358.i8350 = load i64, ptr %269, align 8, !noalias !142
  %.1360.i8351 = mul nsw i64 %.1358.i8350, %arg.shape.0
  %.1362.i8352 = add nsw i64 %.1360.i8351, %.5058.08586
  %.1376.i8353 = icmp slt i64 %.1362.i8352, 0
  %.1377.i8354 = select i1 %.1376.i8353, i64 %arg.arrays.1.5.0, i64 0
  %270 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1362.i8352
  %.1391.i8355 = getelementptr double, ptr %270, i64 %.1377.i8354
  store double %.1328.i8349, ptr %.1391.i8355, align 8, !noalias !142
  %exitcond1516.not.i8356 = icmp eq i64 %.1198.i8343, %arg.schedule.2.5.0
  br i1 %exitcond1516.not.i8356, label %B516.i8357, label %B446.if.i8341

B604.if.i8394:                                    ; preds = %B604.if.i8394, %B604.if.lr.ph.i8389
  %.1529.01513.i8395 = phi i64 [ 0, %B604.if.lr.ph.i8389 ], [ %.1598.i8396, %B604.if.i8394 ]
  %.1598.i8396 = add nsw i64 %.1529.01513.i8395, 1
  %271 = getelementptr double, ptr %261, i64 %.1529.01513.i8395
  %.1673.i8397 = load double, ptr %271, align 8, !noalias !142
  %.1675.i8398 = mul nsw i64 %.1529.01513.i8395, %arg.shape.0
  %gep8829 = getelementptr double, ptr %invariant.gep8828, i64 %.1675.i8398
  store double %.1673.i8397, ptr %gep8829, align 8, !noalias !142
  %exitcond1518.not.i8403 = icmp eq i64 %.1598.i8396, %arg.shape.1
  br i1 %exitcond1518.not.i8403, label %B648.i8404, label %B604.if.i8394

_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit8465: ; preds = %B520.i8358, %B102.i.i8373, %B648.i8404, %B994.i8440
  %storemerge1490.i8360 = phi i64 [ 0, %B520.i8358 ], [ 0, %B102.i.i8373 ], [ 1, %B994.i8440 ], [ 1, %B648.i8404 ]
  %.5874 = add nsw i64 %active.3.28589, -1
  %.5972 = add nsw i64 %.5874, %storemerge1490.i8360
  br label %B4210

B4002:                                            ; preds = %B3844
  %.6038 = getelementptr double, ptr %345, i64 %.5058.08586
  %.6039 = load double, ptr %.6038, align 8
  %.6041 = fcmp ult double %.6039, 1.500000e+01
  br i1 %.6041, label %B4210, label %B4050

B4050:                                            ; preds = %B4002
  %.6087 = load double, ptr %.6086, align 8
  %.6141 = getelementptr double, ptr %arg.lane.0.4, i64 %.5058.08586
  %.6142 = load double, ptr %.6141, align 8
  %.6143 = fsub double %.6087, %.6142
  %.6197 = getelementptr double, ptr %348, i64 %.5058.08586
  %.6198 = load double, ptr %.6197, align 8
  %.6200 = fmul double %.6198, 5.000000e+03
  %.6201 = fcmp ogt double %.6143, %.6200
  br i1 %.6201, label %B4210, label %B4186

B4186:                                            ; preds = %B4050
  store double 0.000000e+00, ptr %.6038, align 8
  br label %B4210

B4210:                                            ; preds = %B4050, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit8465, %B4186, %B4002
  %budget.7.3 = phi i64 [ %budget.5.28588, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit8465 ], [ %budget.5.28588, %B4002 ], [ %budget.5.28588, %B4186 ], [ 0, %B4050 ]
  %active.7.3 = phi i64 [ %.5972, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit8465 ], [ %active.3.28589, %B4002 ], [ %active.3.28589, %B4186 ], [ %active.3.28589, %B4050 ]
  %.130.i5224 = load i64, ptr %.5219, align 8, !noalias !151
  %.183.i5271 = getelementptr i64, ptr %349, i64 %.5058.08586
  %.184.i5272 = load i64, ptr %.183.i5271, align 8, !noalias !151
  %.192.i5276 = icmp sgt i64 %.130.i5224, -1
  br i1 %.192.i5276, label %B88.i, label %B4279

B88.i:                                            ; preds = %B4210
  %.383.i5401 = getelementptr double, ptr %350, i64 %.5058.08586
  %.384.i5402 = load double, ptr %.383.i5401, align 8, !noalias !151
  %.386.i5403 = fcmp ogt double %.384.i5402, 0.000000e+00
  br i1 %.386.i5403, label %B222.i, label %B220.i5404

B220.i5404:                                       ; preds = %B88.i
  %.245.i5330 = mul i64 %.130.i5224, %arg.results.3.5.1
  %.249.i5334 = getelementptr i64, ptr %arg.results.3.4, i64 %.245.i5330
  %.250.i5335 = load i64, ptr %.249.i5334, align 8, !noalias !151
  %.263.i5160.0 = and i64 %.250.i5335, 127
  %.293.i5343 = sub nsw i64 128, %.263.i5160.0
  %.11.i.i = tail call i64 @llvm.smin.i64(i64 %.293.i5343, i64 %.5405)
  %.397.i5407 = sitofp i64 %.11.i.i to double
  br label %B222.i

B222.i:                                           ; preds = %B88.i, %B220.i5404
  %"$phi222.0.2.i.0" = phi double [ %.397.i5407, %B220.i5404 ], [ 1.000000e+00, %B88.i ]
  %.455.i5457 = getelementptr double, ptr %351, i64 %.5058.08586
  store double %"$phi222.0.2.i.0", ptr %.455.i5457, align 8, !noalias !151
  %.512.i5506 = getelementptr double, ptr %352, i64 %.5058.08586
  %.513.i5507 = load double, ptr %.512.i5506, align 8, !noalias !151
  %.567.i5555 = getelementptr double, ptr %353, i64 %.5058.08586
  store double %.513.i5507, ptr %.567.i5555, align 8, !noalias !151
  %.580.i5563 = icmp slt i64 %.184.i5272, %arg.times.5.0
  br i1 %.580.i5563, label %B332.i, label %B4279

B332.i:                                           ; preds = %B222.i
  %.596.i5578 = icmp slt i64 %.184.i5272, 0
  %.597.i5579 = select i1 %.596.i5578, i64 %arg.times.5.0, i64 0
  %272 = getelementptr double, ptr %arg.times.4, i64 %.184.i5272
  %.611.i5593 = getelementptr double, ptr %272, i64 %.597.i5579
  %.612.i5594 = load double, ptr %.611.i5593, align 8, !noalias !151
  %.671.i5645 = load double, ptr %.512.i5506, align 8, !noalias !151
  %.10.i3.i = fcmp olt double %.671.i5645, %.612.i5594
  %.11.i4.i = select i1 %.10.i3.i, double %.671.i5645, double %.612.i5594
  store double %.11.i4.i, ptr %.567.i5555, align 8, !noalias !151
  br label %B4279

B4252:                                            ; preds = %B4279, %B3450
  %budget.4.2 = phi i64 [ %.688, %B3450 ], [ %budget.6.3, %B4279 ]
  %active.5.2 = phi i64 [ %active.4.0, %B3450 ], [ %active.6.3, %B4279 ]
  %.6360 = icmp sgt i64 %active.5.2, 0
  %.6374 = icmp sgt i64 %budget.4.2, 0
  %or.cond8125 = select i1 %.6360, i1 %.6374, i1 false
  br i1 %or.cond8125, label %B276, label %B4278

B4278:                                            ; preds = %B4252, %B202.endif
  %active.8.1 = phi i64 [ %active.3.i.0.lcssa, %B202.endif ], [ %active.5.2, %B4252 ]
  br i1 %.274.i, label %B4278.endif, label %B46.if.i2014.lr.ph

B46.if.i2014.lr.ph:                               ; preds = %B4278
  %.idx = mul i64 %arg.lane.0.5.1, 200
  %273 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx
  %.idx8074 = mul i64 %arg.lane.0.5.1, 208
  %274 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8074
  br label %B46.if.i2014

B92.i1524:                                        ; preds = %B46.if.i2014
  %.303.i1570 = getelementptr double, ptr %273, i64 %.90.i1386.08594
  %.304.i1571 = load double, ptr %.303.i1570, align 8, !noalias !155
  %.5.i.i1572 = fptosi double %.304.i1571 to i64
  %.382.i1622 = getelementptr double, ptr %274, i64 %.90.i1386.08594
  %.383.i1623 = load double, ptr %.382.i1622, align 8, !noalias !155
  %.5.i1.i1624 = fptosi double %.383.i1623 to i64
  %.457.i1673 = mul i64 %.243.i1517, %arg.results.3.5.1
  %.461.i1677 = getelementptr i64, ptr %arg.results.3.4, i64 %.457.i1673
  %.462.i1678 = load i64, ptr %.461.i1677, align 8, !noalias !155
  %.463.i1679 = add nsw i64 %.462.i1678, %.5.i.i1572
  store i64 %.463.i1679, ptr %.461.i1677, align 8, !noalias !155
  %.569.i1775 = getelementptr i8, ptr %.461.i1677, i64 24
  %.570.i1776 = load i64, ptr %.569.i1775, align 8, !noalias !155
  %.571.i1777 = add nsw i64 %.570.i1776, %.5.i1.i1624
  store i64 %.571.i1777, ptr %.569.i1775, align 8, !noalias !155
  %.679.i1871 = getelementptr i8, ptr %.461.i1677, i64 8
  %.680.i1872 = load i64, ptr %.679.i1871, align 8, !noalias !155
  %.683.i1875 = add nsw i64 %.5.i1.i1624, %.5.i.i1572
  %.684.i1876 = mul nsw i64 %.683.i1875, %.
  %.685.i1877 = add nsw i64 %.684.i1876, %.5.i.i1572
  %.686.i1878 = add nsw i64 %.685.i1877, %.680.i1872
  store i64 %.686.i1878, ptr %.679.i1871, align 8, !noalias !155
  store double 0.000000e+00, ptr %.303.i1570, align 8, !noalias !155
  store double 0.000000e+00, ptr %.382.i1622, align 8, !noalias !155
  br label %B416.i1521

B416.i1521:                                       ; preds = %B92.i1524, %B46.if.i2014
  %.148.i1452 = icmp sgt i64 %.93.i1387.08595, 1
  br i1 %.148.i1452, label %B46.if.i2014, label %B4278.endif

B46.if.i2014:                                     ; preds = %B46.if.i2014.lr.ph, %B416.i1521
  %.93.i1387.08595 = phi i64 [ %storemerge, %B46.if.i2014.lr.ph ], [ %.157.i2019, %B416.i1521 ]
  %.90.i1386.08594 = phi i64 [ 0, %B46.if.i2014.lr.ph ], [ %.161.i2022, %B416.i1521 ]
  %.157.i2019 = add nsw i64 %.93.i1387.08595, -1
  %.161.i2022 = add nsw i64 %.90.i1386.08594, 1
  %275 = getelementptr i64, ptr %arg.lane.1.4, i64 %.90.i1386.08594
  %.243.i1517 = load i64, ptr %275, align 8, !noalias !155
  %.248.i1520 = icmp sgt i64 %.243.i1517, -1
  br i1 %.248.i1520, label %B92.i1524, label %B416.i1521

B4279:                                            ; preds = %B222.i, %B4210, %B332.i, %B102.i
  %budget.6.3 = phi i64 [ %budget.5.28588, %B102.i ], [ %budget.7.3, %B332.i ], [ %budget.7.3, %B4210 ], [ %budget.7.3, %B222.i ]
  %active.6.3 = phi i64 [ %active.3.28589, %B102.i ], [ %active.7.3, %B332.i ], [ %active.7.3, %B4210 ], [ %active.7.3, %B222.i ]
  %.5121 = icmp sgt i64 %.5061.08587, 1
  br i1 %.5121, label %B3488.if, label %B4252

B202.endif:                                       ; preds = %B171.i, %entry
  %active.3.i.0.lcssa = phi i64 [ 0, %entry ], [ %active.4.i.1, %B171.i ]
  %.662 = icmp sgt i64 %active.3.i.0.lcssa, 0
  %.678 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.662, i1 %.678, i1 false
  br i1 %or.cond, label %B276.preheader, label %B4278

B276.preheader:                                   ; preds = %B202.endif
  %.722 = getelementptr i8, ptr %arg.lane.2.4, i64 16
  %factor.op.mul = mul i64 %arg.shape.0, %arg.shape.1
  %factor.op.mul8592 = mul i64 %arg.shape.0, %arg.shape.1
  %.818 = getelementptr i8, ptr %arg.code.4, i64 8
  %.873 = icmp sgt i64 %arg.decided, 0
  %.149.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx8116 = mul i64 %arg.lane.0.5.1, 24
  %276 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8116
  %.457.i1878473 = icmp slt i64 %arg.decided, 1
  %.613.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.1007.idx = shl i64 %.382, 4
  %.1007 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1007.idx
  %.1011.not = icmp eq i64 %arg.guarded, 0
  %.1041 = getelementptr i8, ptr %arg.code.4, i64 16
  %.1118 = getelementptr i8, ptr %arg.code.4, i64 72
  %.1194 = getelementptr i8, ptr %arg.code.4, i64 80
  %.1295.idx = mul i64 %.382, 136
  %.1295 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1295.idx
  %.1320.idx = mul i64 %.382, 24
  %.1320 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1320.idx
  %.1351 = getelementptr i8, ptr %arg.code.4, i64 88
  %.idx8111 = mul i64 %arg.lane.0.5.1, 24
  %277 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8111
  %.idx8112 = shl i64 %arg.lane.0.5.1, 5
  %278 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8112
  %.idx8113 = mul i64 %arg.lane.0.5.1, 136
  %279 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8113
  %.idx8114 = mul i64 %arg.lane.0.5.1, 88
  %280 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8114
  %.idx8115 = shl i64 %arg.lane.0.5.1, 4
  %281 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8115
  %.1656.c = getelementptr i8, ptr %arg.code.4, i64 56
  %.1510.idx = shl i64 %arg.lane.1.5.1, 4
  %.1510 = getelementptr i8, ptr %arg.lane.1.4, i64 %.1510.idx
  %.1623.idx = mul i64 %arg.lane.0.5.1, 168
  %.1623 = getelementptr i8, ptr %arg.lane.0.4, i64 %.1623.idx
  %.1656 = getelementptr i8, ptr %arg.code.4, i64 56
  %.127.i = mul nsw i64 %arg.shape.1, %arg.shape.1
  %.174.not.i = icmp slt i64 %.127.i, %arg.linear.0.5.0
  %.344.i = icmp slt i64 %arg.linear.1.5.0, 6
  %.524.idx.i = shl i64 %arg.lane.0.5.1, 5
  %.524.i = getelementptr i8, ptr %arg.lane.0.4, i64 %.524.idx.i
  %.123.i.i = shl nsw i64 %arg.shape.1, 1
  %.124.i.i = add nsw i64 %.123.i.i, 5
  %.153.i.i8140 = getelementptr i8, ptr %arg.linear.1.4, i64 24
  %.183.i.i8142 = getelementptr i8, ptr %arg.linear.1.4, i64 32
  %.186.i.i = add nsw i64 %.124.i.i, %arg.shape.1
  %.187.i.i = add nsw i64 %.186.i.i, 1
  %.224.i.i = icmp slt i64 %arg.shape.1, -2
  %.225.i.i = select i1 %.224.i.i, i64 %arg.linear.1.5.0, i64 0
  %.226.i.i = add i64 %.225.i.i, %.124.i.i
  %.229.i.i = icmp slt i64 %.226.i.i, 0
  %.234.i.i = icmp sge i64 %.226.i.i, %arg.linear.1.5.0
  %282 = or i1 %.229.i.i, %.234.i.i
  %.241.i.i = icmp slt i64 %.186.i.i, -1
  %.242.i.i = select i1 %.241.i.i, i64 %arg.linear.1.5.0, i64 0
  %.243.i.i = add i64 %.242.i.i, %.187.i.i
  %.246.i.i = icmp slt i64 %.243.i.i, 0
  %.251.i.not.i = icmp slt i64 %.243.i.i, %arg.linear.1.5.0
  %.409.i.i = icmp sge i64 %.243.i.i, %arg.linear.1.5.0
  %283 = or i1 %.246.i.i, %.409.i.i
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
  %.idx.i8145 = mul i64 %arg.shape.1, 152
  %284 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx.i8145
  %.534.i.i.i = getelementptr double, ptr %284, i64 %.520.i.i.i
  %.897.i.i.i = mul nsw i64 %arg.shape.1, 17
  %.1279.i.i.idx.i = mul i64 %arg.shape.1, 96
  %.1279.i.i.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1279.i.i.idx.i
  %.2636.i.i = mul nsw i64 %arg.shape.1, 11
  %.idx2423.i = mul i64 %arg.shape.1, 144
  %invariant.gep = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx2423.i
  %.idx2424.i = mul i64 %arg.shape.1, 144
  %invariant.gep8482 = getelementptr double, ptr %arg.arrays.0.4, i64 %.503.i.i.i
  %invariant.gep8484 = getelementptr double, ptr %arg.arrays.0.4, i64 %.503.i.i.i
  %.663.i = getelementptr i8, ptr %arg.linear.1.4, i64 8
  %.711.i = icmp sgt i64 %arg.shape.1, 0
  %.743.sroa.0.02358.i = add i64 %arg.shape.1, 1
  %.1140.idx.i = mul i64 %arg.lane.0.5.1, 160
  %.1140.i = getelementptr i8, ptr %arg.lane.0.4, i64 %.1140.idx.i
  %.2018.idx = mul i64 %.382, 136
  %.2018 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.2018.idx
  %.42.i = mul nsw i64 %arg.shape.1, %arg.shape.1
  %.88.not.i = icmp slt i64 %.42.i, %arg.linear.0.5.0
  %.218.i = add nsw i64 %arg.shape.1, 5
  %.265.i = icmp slt i64 %arg.linear.1.5.0, 6
  %.272.i = icmp slt i64 %arg.shape.1, -5
  %.273.i = select i1 %.272.i, i64 %arg.linear.1.5.0, i64 0
  %.274.i8149 = add i64 %.218.i, %.273.i
  %.277.i = icmp slt i64 %.274.i8149, 0
  %.282.not.i = icmp slt i64 %.274.i8149, %arg.linear.1.5.0
  %.648747.not.i = icmp slt i64 %arg.shape.1, 1
  %.756.i = mul nsw i64 %arg.shape.1, 17
  %.idx.i8152 = mul i64 %arg.shape.1, 80
  %invariant.gep8486 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx.i8152
  %.882.i = getelementptr i8, ptr %arg.linear.1.4, i64 8
  %.887.i = mul nsw i64 %arg.shape.1, 17
  %invariant.gep8488 = getelementptr double, ptr %arg.arrays.0.4, i64 %.887.i
  %.2121 = getelementptr i8, ptr %arg.code.4, i64 64
  %.2203 = icmp sgt i64 %arg.guarded, 0
  %.2208 = icmp sgt i64 %arg.decided, 0
  %.idx8109 = mul i64 %arg.lane.0.5.1, 40
  %285 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8109
  %.idx8110 = mul i64 %arg.lane.0.5.1, 192
  %286 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8110
  %.2558.idx = mul i64 %arg.lane.0.5.1, 40
  %.2558 = getelementptr i8, ptr %arg.lane.0.4, i64 %.2558.idx
  %.2667.idx = mul i64 %arg.lane.0.5.1, 200
  %.2667 = getelementptr i8, ptr %arg.lane.0.4, i64 %.2667.idx
  %.2721.idx = mul i64 %arg.lane.0.5.1, 208
  %.2721 = getelementptr i8, ptr %arg.lane.0.4, i64 %.2721.idx
  %.idx8107 = mul i64 %arg.lane.0.5.1, 200
  %287 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8107
  %.idx8108 = mul i64 %arg.lane.0.5.1, 208
  %288 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8108
  %.idx8102 = shl i64 %arg.lane.1.5.1, 4
  %289 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx8102
  %.idx8103 = mul i64 %arg.lane.0.5.1, 72
  %290 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8103
  %.idx8104 = mul i64 %arg.lane.0.5.1, 40
  %291 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8104
  %.idx8105 = mul i64 %arg.lane.0.5.1, 144
  %292 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8105
  %.idx8106 = mul i64 %arg.lane.0.5.1, 56
  %293 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8106
  %.3784.idx = mul i64 %.382, 136
  %.3784 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3784.idx
  %.3809.idx = mul i64 %.382, 104
  %.3809 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3809.idx
  %.3847 = getelementptr i8, ptr %arg.code.4, i64 264
  %.3943 = getelementptr i8, ptr %arg.code.4, i64 40
  %.3965.idx = mul i64 %.382, 136
  %.3965 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3965.idx
  %.idx8097 = mul i64 %arg.lane.0.5.1, 96
  %294 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8097
  %.idx8098 = mul i64 %arg.lane.0.5.1, 40
  %295 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8098
  %.idx8099 = mul i64 %arg.lane.0.5.1, 104
  %296 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8099
  %.idx8100 = mul i64 %arg.lane.0.5.1, 112
  %297 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8100
  %.idx8101 = shl i64 %arg.lane.1.5.1, 5
  %298 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx8101
  %.4304.idx = mul i64 %.382, 136
  %.4304 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4304.idx
  %.4366 = getelementptr i8, ptr %arg.code.4, i64 200
  %.4443 = getelementptr i8, ptr %arg.code.4, i64 104
  %.1013.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.1105.i8167.idx = shl i64 %factor.op.mul, 4
  %.1105.i8167 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1105.i8167.idx
  %.idx1174.i = mul i64 %arg.lane.0.5.1, 104
  %299 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1174.i
  %.idx1175.i = mul i64 %arg.lane.0.5.1, 112
  %300 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1175.i
  %.idx1176.i = mul i64 %arg.lane.0.5.1, 96
  %301 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1176.i
  %.idx1177.i = mul i64 %arg.lane.0.5.1, 48
  %302 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1177.i
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
  %.idx.i8171 = mul i64 %arg.lane.0.5.1, 56
  %303 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx.i8171
  %.idx1165.i = mul i64 %arg.lane.0.5.1, 40
  %304 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1165.i
  %.idx1166.i = shl i64 %arg.lane.0.5.1, 5
  %305 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1166.i
  %306 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.4570.not = icmp eq i64 %arg.guarded, 0
  %.845.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.937.i.idx = shl i64 %factor.op.mul8592, 4
  %.937.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.937.i.idx
  %.idx652.i = mul i64 %arg.lane.0.5.1, 48
  %307 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx652.i
  %.695658.not.i = icmp slt i64 %arg.shape.1, 1
  %.767.i = shl nsw i64 %arg.shape.1, 1
  %.idx.i8178 = mul i64 %arg.lane.0.5.1, 40
  %308 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx.i8178
  %.155.i.i8181 = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i8187 = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i8193 = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i8199 = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i8205 = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i8211 = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i8217 = mul nsw i64 %arg.shape.1, 18
  %factor.op.mul631.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.idx.i8234 = shl i64 %arg.lane.1.5.1, 4
  %309 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx.i8234
  %.idx620.i = mul i64 %arg.lane.0.5.1, 40
  %310 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx620.i
  %.idx621.i = mul i64 %arg.lane.0.5.1, 48
  %311 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx621.i
  %.idx622.i = mul i64 %arg.lane.0.5.1, 56
  %312 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx622.i
  %.917628.not.i = icmp slt i64 %arg.shape.1, 1
  %.993.i = mul nsw i64 %arg.shape.1, 17
  %313 = add i64 %arg.times.5.0, -1
  %.155.i.i8247 = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i8253 = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i8259 = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i8265 = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i8271 = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i8277 = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i8283 = mul nsw i64 %arg.shape.1, 18
  %.4796 = getelementptr i8, ptr %arg.code.4, i64 96
  %.idx8091 = mul i64 %arg.lane.0.5.1, 96
  %314 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8091
  %.idx8092 = mul i64 %arg.lane.0.5.1, 40
  %315 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8092
  %.idx8093 = mul i64 %arg.lane.0.5.1, 120
  %316 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8093
  %317 = getelementptr double, ptr %arg.times.4, i64 %arg.times.5.0
  %.449.i3081 = getelementptr i8, ptr %317, i64 -8
  %.idx8094 = mul i64 %arg.lane.1.5.1, 24
  %318 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx8094
  %.idx8095 = mul i64 %arg.lane.1.5.1, 24
  %319 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx8095
  %.idx8096 = mul i64 %arg.lane.0.5.1, 24
  %320 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8096
  %.4893.not = icmp ne i64 %arg.jumping, 0
  %.idx1848.i = mul i64 %arg.lane.0.5.1, 40
  %321 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1848.i
  %.idx1849.i = shl i64 %arg.lane.0.5.1, 4
  %322 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1849.i
  %323 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.7511852.not.i = icmp slt i64 %arg.schedule.2.5.0, 1
  %.852.i = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1017.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.1160.i = getelementptr i8, ptr %arg.code.4, i64 32
  %.1231.i8300 = mul nsw i64 %arg.shape.1, 17
  %.1233.i8301 = mul nsw i64 %.1231.i8300, %arg.shape.0
  %.1276.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.1233.i8301
  %.idx1846.i = shl i64 %arg.lane.1.5.1, 4
  %324 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1846.i
  %.17571859.not.i = icmp slt i64 %arg.shape.1, 1
  %.1952.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.2041.not.i = icmp eq i64 %arg.guarded, 0
  %.2073.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx8075 = mul i64 %arg.lane.0.5.1, 40
  %325 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8075
  %.idx8076 = shl i64 %arg.lane.0.5.1, 4
  %326 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8076
  %327 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.idx8077 = mul i64 %arg.lane.0.5.1, 24
  %328 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8077
  %.1103.i8579.not = icmp slt i64 %arg.schedule.2.5.0, 1
  %.1256.i = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.idx8080 = shl i64 %arg.lane.1.5.1, 4
  %329 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx8080
  %.373.i8313 = getelementptr i8, ptr %arg.lane.2.4, i64 8
  %330 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.6961500.not.i8450 = icmp slt i64 %arg.shape.1, 1
  %.851.i8458 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.9661503.not.i8318 = icmp slt i64 %arg.shape.2, 1
  %.11851506.not.i8335 = icmp slt i64 %arg.schedule.2.5.0, 1
  %.1319.i8340 = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1423.i8359 = icmp sgt i64 %arg.shape.0, 1
  %.163.i1509.not.i8362 = icmp slt i64 %arg.shape.1, 1
  %331 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1486.i8379 = shl i64 %arg.lane.0.5.1, 4
  %332 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1486.i8379
  %.idx1487.i8381 = mul i64 %arg.lane.0.5.1, 24
  %333 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1487.i8381
  %.idx1488.i8383 = shl i64 %arg.lane.0.5.1, 5
  %334 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1488.i8383
  %.idx1489.i8385 = mul i64 %arg.lane.0.5.1, 176
  %335 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1489.i8385
  %.15851512.not.i8388 = icmp slt i64 %arg.shape.1, 1
  %.idx1492.i8420 = shl i64 %arg.lane.0.5.1, 4
  %336 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1492.i8420
  %337 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1493.i8423 = mul i64 %arg.lane.0.5.1, 24
  %338 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1493.i8423
  %.idx1494.i8425 = shl i64 %arg.lane.0.5.1, 5
  %339 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1494.i8425
  %.idx1495.i8427 = mul i64 %arg.lane.0.5.1, 120
  %340 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1495.i8427
  %.idx1496.i8430 = mul i64 %arg.lane.1.5.1, 24
  %341 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1496.i8430
  %.idx1497.i8432 = mul i64 %arg.lane.0.5.1, 200
  %342 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1497.i8432
  %.idx1498.i8434 = mul i64 %arg.lane.0.5.1, 208
  %343 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1498.i8434
  %.idx1499.i8436 = mul i64 %arg.lane.0.5.1, 144
  %344 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1499.i8436
  %.idx8079 = mul i64 %arg.lane.0.5.1, 144
  %345 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8079
  %.6072 = tail call i64 @llvm.smin.i64(i64 %arg.times.5.0, i64 0)
  %346 = getelementptr double, ptr %arg.times.4, i64 %arg.times.5.0
  %347 = getelementptr i8, ptr %346, i64 -8
  %.6086 = getelementptr double, ptr %347, i64 %.6072
  %348 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx8081 = shl i64 %arg.lane.1.5.1, 4
  %349 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx8081
  %.idx8082 = mul i64 %arg.lane.0.5.1, 144
  %350 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8082
  %.idx8083 = mul i64 %arg.lane.0.5.1, 184
  %351 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8083
  %.idx8084 = shl i64 %arg.lane.0.5.1, 4
  %352 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8084
  %.idx8085 = mul i64 %arg.lane.0.5.1, 176
  %353 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8085
  %.163.i36948582.not = icmp slt i64 %arg.shape.1, 1
  %354 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx8087 = shl i64 %arg.lane.0.5.1, 4
  %355 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8087
  %.idx8088 = mul i64 %arg.lane.0.5.1, 24
  %356 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8088
  %.idx8089 = shl i64 %arg.lane.0.5.1, 5
  %357 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8089
  %.idx8090 = mul i64 %arg.lane.0.5.1, 176
  %358 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8090
  %359 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %360 = shl i64 %359, 3
  %361 = shl i64 %arg.runs.0.5.1, 3
  %362 = mul i64 %arg.shape.1, -176
  %363 = mul i64 %arg.shape.1, -168
  %364 = mul i64 %arg.shape.1, -160
  %365 = mul i64 %arg.shape.1, -152
  %366 = mul i64 %arg.shape.1, -144
  %367 = mul i64 %arg.shape.1, -136
  %368 = mul i64 %arg.shape.1, -128
  %369 = mul i64 %arg.shape.1, -176
  %370 = mul i64 %arg.shape.1, -168
  %371 = mul i64 %arg.shape.1, -160
  %372 = mul i64 %arg.shape.1, -152
  %373 = mul i64 %arg.shape.1, -144
  %374 = mul i64 %arg.shape.1, -136
  %375 = mul i64 %arg.shape.1, -128
  %376 = add i64 %.idx2424.i, %arg.arrays.0.48732
  %377 = tail call i64 @llvm.smax.i64(i64 %.538.i.i, i64 1)
  %378 = mul i64 %arg.shape.1, -48
  %min.iters.check8758 = icmp ult i64 %arg.shape.1, 4
  %diff.check8752 = icmp ult i64 %378, 32
  %diff.check8753 = icmp ult i64 %.1807.i.idx.i, 32
  %conflict.rdx8754 = or i1 %diff.check8752, %diff.check8753
  %diff.check8755 = icmp ult i64 %.idx2422.i, 32
  %conflict.rdx8756 = or i1 %conflict.rdx8754, %diff.check8755
  %n.vec8761 = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n8768 = icmp eq i64 %arg.shape.1, %n.vec8761
  %min.iters.check8736 = icmp slt i64 %.538.i.i, 4
  %n.vec8739 = and i64 %377, 9223372036854775804
  %379 = sub nsw i64 %storemerge2359.i, %n.vec8739
  %cmp.n8748 = icmp eq i64 %377, %n.vec8739
  %min.iters.check8717 = icmp ult i64 %arg.shape.1, 4
  %diff.check8715 = icmp ult i64 %.idx2424.i, 32
  %or.cond8772 = or i1 %min.iters.check8717, %diff.check8715
  %n.vec8720 = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n8729 = icmp eq i64 %arg.shape.1, %n.vec8720
  %380 = getelementptr i8, ptr %arg.code.4, i64 208
  %.4329.idx = mul i64 %.382, 112
  %.4329 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4329.idx
  %381 = getelementptr i8, ptr %arg.code.4, i64 216
  %.4329.1.idx = mul i64 %.382, 120
  %.4329.1 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4329.1.idx
  %382 = getelementptr i8, ptr %arg.code.4, i64 224
  %.4329.2.idx = shl i64 %.382, 7
  %.4329.2 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4329.2.idx
  %min.iters.check8692 = icmp ne i64 %arg.shape.1, 1
  %ident.check8674.not = icmp eq i64 %arg.shape.0, 1
  %or.cond8773 = and i1 %min.iters.check8692, %ident.check8674.not
  %diff.check8676 = icmp eq i64 %369, 0
  %diff.check8677 = icmp ult i64 %370, 16
  %conflict.rdx8678 = or i1 %diff.check8676, %diff.check8677
  %diff.check8679 = icmp eq i64 %371, 0
  %conflict.rdx8680 = or i1 %conflict.rdx8678, %diff.check8679
  %diff.check8681 = icmp ult i64 %372, 16
  %conflict.rdx8682 = or i1 %conflict.rdx8680, %diff.check8681
  %diff.check8683 = icmp eq i64 %373, 0
  %conflict.rdx8684 = or i1 %conflict.rdx8682, %diff.check8683
  %diff.check8685 = icmp ult i64 %374, 16
  %conflict.rdx8686 = or i1 %conflict.rdx8684, %diff.check8685
  %diff.check8687 = icmp eq i64 %375, 0
  %conflict.rdx8688 = or i1 %conflict.rdx8686, %diff.check8687
  %.mask = and i64 %arg.shape.1, 1152921504606846975
  %diff.check8689 = icmp eq i64 %.mask, 0
  %conflict.rdx8690 = or i1 %conflict.rdx8688, %diff.check8689
  %n.vec8695 = and i64 %arg.shape.1, 9223372036854775806
  %cmp.n8712 = icmp eq i64 %arg.shape.1, %n.vec8695
  %min.iters.check8653 = icmp ne i64 %arg.shape.1, 1
  %ident.check.not = icmp eq i64 %arg.shape.0, 1
  %or.cond8774 = and i1 %min.iters.check8653, %ident.check.not
  %diff.check8638 = icmp eq i64 %362, 0
  %diff.check8639 = icmp ult i64 %363, 16
  %conflict.rdx = or i1 %diff.check8638, %diff.check8639
  %diff.check8640 = icmp eq i64 %364, 0
  %conflict.rdx8641 = or i1 %conflict.rdx, %diff.check8640
  %diff.check8642 = icmp ult i64 %365, 16
  %conflict.rdx8643 = or i1 %conflict.rdx8641, %diff.check8642
  %diff.check8644 = icmp eq i64 %366, 0
  %conflict.rdx8645 = or i1 %conflict.rdx8643, %diff.check8644
  %diff.check8646 = icmp ult i64 %367, 16
  %conflict.rdx8647 = or i1 %conflict.rdx8645, %diff.check8646
  %diff.check8648 = icmp eq i64 %368, 0
  %conflict.rdx8649 = or i1 %conflict.rdx8647, %diff.check8648
  %.mask8770 = and i64 %arg.shape.1, 1152921504606846975
  %diff.check8650 = icmp eq i64 %.mask8770, 0
  %conflict.rdx8651 = or i1 %conflict.rdx8649, %diff.check8650
  %n.vec8656 = and i64 %arg.shape.1, 9223372036854775806
  %cmp.n8671 = icmp eq i64 %arg.shape.1, %n.vec8656
  %min.iters.check8625 = icmp ult i64 %arg.shape.1, 8
  %n.vec8628 = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n8635 = icmp eq i64 %arg.shape.1, %n.vec8628
  br label %B276

B1276.if:                                         ; preds = %B1276.if.preheader, %B1500
  %.1789.08490 = phi i64 [ %.1858, %B1500 ], [ 1, %B1276.if.preheader ]
  %.1858 = add nsw i64 %.1789.08490, 1
  %383 = getelementptr i64, ptr %arg.code.4, i64 %.1789.08490
  %384 = getelementptr i8, ptr %383, i64 104
  %.1917 = load i64, ptr %384, align 8
  %.1962 = inttoptr i64 %.1917 to ptr
  tail call void %.1962(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.1993 = load i64, ptr %arg.code.4, align 8
  %.1999 = mul nsw i64 %.1858, %.382
  %.2043 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1999
  %.2044 = inttoptr i64 %.1993 to ptr
  tail call void %.2044(ptr %.490, ptr %.2018, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.2043)
  br i1 %.539, label %B1464, label %B1500

B1646.if:                                         ; preds = %B1502, %B1732
  %looked.2.18496 = phi i1 [ %"$phi1732.1.2.2", %B1732 ], [ %spec.select8126, %B1502 ]
  %good.2.18495 = phi i1 [ %"$phi1690.1.2.2", %B1732 ], [ false, %B1502 ]
  %.2251.08494 = phi i64 [ %.2313, %B1732 ], [ %storemerge, %B1502 ]
  %.2248.08493 = phi i64 [ %.2317, %B1732 ], [ 0, %B1502 ]
  %.2313 = add nsw i64 %.2251.08494, -1
  %.2317 = add nsw i64 %.2248.08493, 1
  br i1 %good.2.18495, label %B1690, label %B1654

B1920.if:                                         ; preds = %B1920.preheader, %B2388
  %doubted.2.28507 = phi i1 [ %doubted.3.3, %B2388 ], [ false, %B1920.preheader ]
  %within.3.28506 = phi i1 [ %within.4.3, %B2388 ], [ false, %B1920.preheader ]
  %wanted.3.28505 = phi i1 [ %wanted.4.3, %B2388 ], [ false, %B1920.preheader ]
  %.2832.08504 = phi i64 [ %.2903, %B2388 ], [ %storemerge, %B1920.preheader ]
  %.2829.08503 = phi i64 [ %.2907, %B2388 ], [ 0, %B1920.preheader ]
  %.2903 = add nsw i64 %.2832.08504, -1
  %.2907 = add nsw i64 %.2829.08503, 1
  %.2994 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2829.08503
  %.2995 = load i64, ptr %.2994, align 8
  %.3049 = getelementptr i64, ptr %289, i64 %.2829.08503
  %.3050 = load i64, ptr %.3049, align 8
  %.3058 = icmp sgt i64 %.2995, -1
  br i1 %.3058, label %B1996, label %B2388

B2804.if:                                         ; preds = %B2736
  %.4204 = load i64, ptr %380, align 8
  %.4249 = inttoptr i64 %.4204 to ptr
  tail call void %.4249(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4280 = load i64, ptr %arg.code.4, align 8
  %.4330 = inttoptr i64 %.4280 to ptr
  tail call void %.4330(ptr %.490, ptr %.4304, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.4329)
  %.4204.1 = load i64, ptr %381, align 8
  %.4249.1 = inttoptr i64 %.4204.1 to ptr
  tail call void %.4249.1(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4280.1 = load i64, ptr %arg.code.4, align 8
  %.4330.1 = inttoptr i64 %.4280.1 to ptr
  tail call void %.4330.1(ptr %.490, ptr %.4304, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.4329.1)
  %.4204.2 = load i64, ptr %382, align 8
  %.4249.2 = inttoptr i64 %.4204.2 to ptr
  tail call void %.4249.2(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4280.2 = load i64, ptr %arg.code.4, align 8
  %.4330.2 = inttoptr i64 %.4280.2 to ptr
  tail call void %.4330.2(ptr %.490, ptr %.4304, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.4329.2)
  %.4367 = load i64, ptr %.4366, align 8
  %.4412 = inttoptr i64 %.4367 to ptr
  tail call void %.4412(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B3074

B3488.if:                                         ; preds = %B3450, %B4279
  %active.3.28589 = phi i64 [ %active.6.3, %B4279 ], [ %active.4.0, %B3450 ]
  %budget.5.28588 = phi i64 [ %budget.6.3, %B4279 ], [ %.688, %B3450 ]
  %.5061.08587 = phi i64 [ %.5130, %B4279 ], [ %storemerge, %B3450 ]
  %.5058.08586 = phi i64 [ %.5134, %B4279 ], [ 0, %B3450 ]
  %.5130 = add nsw i64 %.5061.08587, -1
  %.5134 = add nsw i64 %.5058.08586, 1
  %.5219 = getelementptr i64, ptr %arg.lane.1.4, i64 %.5058.08586
  %.5220 = load i64, ptr %.5219, align 8
  %.5225 = icmp slt i64 %.5220, 0
  br i1 %.5225, label %B3534, label %B3574

B4278.endif:                                      ; preds = %B416.i1521, %B4278
  store i64 %active.8.1, ptr %retptr, align 8
  ret i32 0
}

; Function Attrs: mustprogress nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare double @llvm.fabs.f64(double)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smin.i64(i64, i64)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare i64 @llvm.smax.i64(i64, i64)

; Function Attrs: nocallback nofree nosync nounwind speculatable willreturn memory(none)
declare <2 x double> @llvm.fabs.v2f64(<2 x double>)

define dso_local range(i32 0, 2) i32 @advance_fixed(ptr noalias %retptr, ptr noalias %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, double %arg.step, ptr readnone %arg.runs.0.0, ptr readnone %arg.runs.0.1, i64 %arg.runs.0.2, i64 %arg.runs.0.3, ptr readonly %arg.runs.0.4, i64 %arg.runs.0.5.0, i64 %arg.runs.0.5.1, i64 %arg.runs.0.6.0, i64 %arg.runs.0.6.1, ptr readnone %arg.runs.1.0, ptr readnone %arg.runs.1.1, i64 %arg.runs.1.2, i64 %arg.runs.1.3, ptr readonly %arg.runs.1.4, i64 %arg.runs.1.5.0, i64 %arg.runs.1.5.1, i64 %arg.runs.1.6.0, i64 %arg.runs.1.6.1, ptr readnone %arg.runs.2.0, ptr readnone %arg.runs.2.1, i64 %arg.runs.2.2, i64 %arg.runs.2.3, ptr readonly %arg.runs.2.4, i64 %arg.runs.2.5.0, i64 %arg.runs.2.6.0, ptr readnone %arg.schedule.0.0, ptr readnone %arg.schedule.0.1, i64 %arg.schedule.0.2, i64 %arg.schedule.0.3, ptr readonly %arg.schedule.0.4, i64 %arg.schedule.0.5.0, i64 %arg.schedule.0.5.1, i64 %arg.schedule.0.6.0, i64 %arg.schedule.0.6.1, ptr readnone %arg.schedule.1.0, ptr readnone %arg.schedule.1.1, i64 %arg.schedule.1.2, i64 %arg.schedule.1.3, ptr readnone %arg.schedule.1.4, i64 %arg.schedule.1.5.0, i64 %arg.schedule.1.6.0, ptr readnone %arg.schedule.2.0, ptr readnone %arg.schedule.2.1, i64 %arg.schedule.2.2, i64 %arg.schedule.2.3, ptr readonly %arg.schedule.2.4, i64 %arg.schedule.2.5.0, i64 %arg.schedule.2.6.0, ptr readnone %arg.schedule.3.0, ptr readnone %arg.schedule.3.1, i64 %arg.schedule.3.2, i64 %arg.schedule.3.3, ptr readonly %arg.schedule.3.4, i64 %arg.schedule.3.5.0, i64 %arg.schedule.3.5.1, i64 %arg.schedule.3.5.2, i64 %arg.schedule.3.6.0, i64 %arg.schedule.3.6.1, i64 %arg.schedule.3.6.2, ptr readnone %arg.schedule.4.0, ptr readnone %arg.schedule.4.1, i64 %arg.schedule.4.2, i64 %arg.schedule.4.3, ptr readnone %arg.schedule.4.4, i64 %arg.schedule.4.5.0, i64 %arg.schedule.4.5.1, i64 %arg.schedule.4.6.0, i64 %arg.schedule.4.6.1, ptr readnone %arg.times.0, ptr readnone %arg.times.1, i64 %arg.times.2, i64 %arg.times.3, ptr readonly %arg.times.4, i64 %arg.times.5.0, i64 %arg.times.6.0, ptr readnone %arg.results.0.0, ptr readnone %arg.results.0.1, i64 %arg.results.0.2, i64 %arg.results.0.3, ptr %arg.results.0.4, i64 %arg.results.0.5.0, i64 %arg.results.0.5.1, i64 %arg.results.0.5.2, i64 %arg.results.0.6.0, i64 %arg.results.0.6.1, i64 %arg.results.0.6.2, ptr readnone %arg.results.1.0, ptr readnone %arg.results.1.1, i64 %arg.results.1.2, i64 %arg.results.1.3, ptr %arg.results.1.4, i64 %arg.results.1.5.0, i64 %arg.results.1.6.0, ptr readnone %arg.results.2.0, ptr readnone %arg.results.2.1, i64 %arg.results.2.2, i64 %arg.results.2.3, ptr %arg.results.2.4, i64 %arg.results.2.5.0, i64 %arg.results.2.6.0, ptr readnone %arg.results.3.0, ptr readnone %arg.results.3.1, i64 %arg.results.3.2, i64 %arg.results.3.3, ptr %arg.results.3.4, i64 %arg.results.3.5.0, i64 %arg.results.3.5.1, i64 %arg.results.3.6.0, i64 %arg.results.3.6.1, ptr readnone %arg.lane.0.0, ptr readnone %arg.lane.0.1, i64 %arg.lane.0.2, i64 %arg.lane.0.3, ptr %arg.lane.0.4, i64 %arg.lane.0.5.0, i64 %arg.lane.0.5.1, i64 %arg.lane.0.6.0, i64 %arg.lane.0.6.1, ptr readnone %arg.lane.1.0, ptr readnone %arg.lane.1.1, i64 %arg.lane.1.2, i64 %arg.lane.1.3, ptr %arg.lane.1.4, i64 %arg.lane.1.5.0, i64 %arg.lane.1.5.1, i64 %arg.lane.1.6.0, i64 %arg.lane.1.6.1, ptr readnone %arg.lane.2.0, ptr readnone %arg.lane.2.1, i64 %arg.lane.2.2, i64 %arg.lane.2.3, ptr readnone %arg.lane.2.4, i64 %arg.lane.2.5.0, i64 %arg.lane.2.6.0, ptr readnone %arg.arrays.0.0, ptr readnone %arg.arrays.0.1, i64 %arg.arrays.0.2, i64 %arg.arrays.0.3, ptr %arg.arrays.0.4, i64 %arg.arrays.0.5.0, i64 %arg.arrays.0.6.0, ptr readnone %arg.arrays.1.0, ptr readnone %arg.arrays.1.1, i64 %arg.arrays.1.2, i64 %arg.arrays.1.3, ptr %arg.arrays.1.4, i64 %arg.arrays.1.5.0, i64 %arg.arrays.1.6.0, ptr readnone %arg.arrays.2.0, ptr readnone %arg.arrays.2.1, i64 %arg.arrays.2.2, i64 %arg.arrays.2.3, ptr %arg.arrays.2.4, i64 %arg.arrays.2.5.0, i64 %arg.arrays.2.6.0, ptr readnone %arg.arrays.3.0, ptr readnone %arg.arrays.3.1, i64 %arg.arrays.3.2, i64 %arg.arrays.3.3, ptr %arg.arrays.3.4, i64 %arg.arrays.3.5.0, i64 %arg.arrays.3.6.0, ptr readnone %arg.arrays.4.0, ptr readnone %arg.arrays.4.1, i64 %arg.arrays.4.2, i64 %arg.arrays.4.3, ptr %arg.arrays.4.4, i64 %arg.arrays.4.5.0, i64 %arg.arrays.4.6.0, i64 %arg.guarded, i64 %arg.jumping) local_unnamed_addr {
entry:
  %arg.arrays.0.43791 = ptrtoint ptr %arg.arrays.0.4 to i64
  %arg.results.0.43790 = ptrtoint ptr %arg.results.0.4 to i64
  %.422 = icmp sgt i64 %arg.runs.0.5.0, 0
  %.425 = icmp eq i64 %arg.shape.0, 0
  br i1 %.425, label %B0.if, label %B0.endif, !prof !36

B148.loopexit:                                    ; preds = %B1702, %B1572
  %.467 = icmp sgt i64 %.411.13763, 0
  %.480 = select i1 %.467, i64 %arg.shape.0, i64 0
  %.408.1 = add i64 %.480, %.408.13762
  %.476 = sext i1 %.467 to i64
  %.411.1 = add nsw i64 %.411.13763, %.476
  %.457.sroa.0.0 = select i1 %.467, i64 %.408.13762, i64 0
  br i1 %.467, label %B152, label %B1708

B152:                                             ; preds = %B152.lr.ph, %B148.loopexit
  %.457.sroa.0.03764 = phi i64 [ 0, %B152.lr.ph ], [ %.457.sroa.0.0, %B148.loopexit ]
  %.411.13763 = phi i64 [ %.411.13761, %B152.lr.ph ], [ %.411.1, %B148.loopexit ]
  %.408.13762 = phi i64 [ %arg.shape.0, %B152.lr.ph ], [ %.408.1, %B148.loopexit ]
  %.522 = sub i64 %arg.runs.0.5.0, %.457.sroa.0.03764
  %.11.i = tail call i64 @llvm.smin.i64(i64 %.522, i64 %arg.shape.0)
  br i1 %.6353705.not, label %B512, label %B248.if.lr.ph

B248.if.lr.ph:                                    ; preds = %B152
  %.677 = add nsw i64 %.11.i, -1
  br label %B248.if

B410:                                             ; preds = %B366.if, %B248.if
  br i1 %.10703702.not, label %B500, label %B440.if.lr.ph

B440.if.lr.ph:                                    ; preds = %B410
  %.1131 = icmp slt i64 %.708, 0
  %.1132 = select i1 %.1131, i64 %arg.runs.0.5.0, i64 0
  %.1133 = add i64 %.1132, %.708
  %.1153 = mul i64 %.1133, %arg.runs.0.5.1
  %0 = getelementptr double, ptr %arg.runs.0.4, i64 %.1153
  %.1230 = select i1 %.1131, i64 %arg.results.0.5.0, i64 0
  %.1231 = add i64 %.1230, %.708
  %.1261 = mul i64 %.1259, %.1231
  %1 = getelementptr double, ptr %arg.results.0.4, i64 %.1261
  %invariant.gep3950 = getelementptr double, ptr %arg.arrays.0.4, i64 %.579.03706
  br label %B440.if

B500:                                             ; preds = %B440.if, %B410
  %.1290 = icmp slt i64 %.708, 0
  %.1291 = select i1 %.1290, i64 %arg.results.2.5.0, i64 0
  %2 = getelementptr i64, ptr %arg.results.2.4, i64 %.708
  %.1305 = getelementptr i64, ptr %2, i64 %.1291
  store i64 1, ptr %.1305, align 8
  %exitcond3769.not = icmp eq i64 %arg.shape.0, %.648
  br i1 %exitcond3769.not, label %B512, label %B248.if

B512:                                             ; preds = %B500, %B152
  br i1 %.1408, label %B598.preheader, label %B1572

B598.preheader:                                   ; preds = %B512
  %3 = getelementptr i64, ptr %arg.runs.2.4, i64 %.457.sroa.0.03764
  %.1358 = icmp slt i64 %.457.sroa.0.03764, 0
  %.1359 = select i1 %.1358, i64 %arg.runs.2.5.0, i64 0
  %.1373 = getelementptr i64, ptr %3, i64 %.1359
  %.1374 = load i64, ptr %.1373, align 8
  %.1343 = load double, ptr %arg.times.4, align 8
  %.1695 = icmp slt i64 %.1374, 0
  %.1696 = select i1 %.1695, i64 %arg.schedule.3.5.0, i64 0
  %.1697 = add i64 %.1696, %.1374
  %.1727 = mul i64 %.1725, %.1697
  %4 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1727
  %.2399 = icmp slt i64 %.1374, 0
  %.2400 = select i1 %.2399, i64 %arg.schedule.0.5.0, i64 0
  %.2401 = add i64 %.2400, %.1374
  %.2421 = mul i64 %.2401, %arg.schedule.0.5.1
  %5 = getelementptr double, ptr %arg.schedule.0.4, i64 %.2421
  br label %B598

B598:                                             ; preds = %B598.preheader, %B1532
  %t.2.1 = phi double [ %t.3.4, %B1532 ], [ %.1343, %B598.preheader ]
  %done.3.1 = phi i64 [ %done.4.4, %B1532 ], [ 1, %B598.preheader ]
  %edge.2.1 = phi i64 [ %edge.3.4, %B1532 ], [ 0, %B598.preheader ]
  br i1 %.1462, label %B748.else.endif, label %B654.if.lr.ph

B654.if.lr.ph:                                    ; preds = %B598
  %.1698 = icmp slt i64 %edge.2.1, 0
  %.1699 = select i1 %.1698, i64 %arg.schedule.3.5.1, i64 0
  %.1700 = add i64 %.1699, %edge.2.1
  %.1729 = mul i64 %.1700, %arg.schedule.3.5.2
  %6 = getelementptr double, ptr %4, i64 %.1729
  br label %B654.if

B654.loopexit:                                    ; preds = %B688.if, %B654.if
  %.1504 = icmp sgt i64 %.1451.03713, 1
  br i1 %.1504, label %B654.if, label %B748.else.endif

B906:                                             ; preds = %B906.preheader, %B1492
  %t.4.3 = phi double [ %.11.i3686, %B1492 ], [ %t.2.1, %B906.preheader ]
  %done.6.3 = phi i64 [ %done.5.5, %B1492 ], [ %done.3.1, %B906.preheader ]
  %.2358 = icmp slt i64 %done.6.3, 0
  %.2359 = select i1 %.2358, i64 %arg.times.5.0, i64 0
  %7 = getelementptr double, ptr %arg.times.4, i64 %done.6.3
  %.2373 = getelementptr double, ptr %7, i64 %.2359
  %.2374 = load double, ptr %.2373, align 8
  %.2426 = load double, ptr %.2425, align 8
  %.10.i = fcmp olt double %.2426, %.2374
  %.11.i3686 = select i1 %.10.i, double %.2426, double %.2374
  %.2460 = fsub double %.11.i3686, %t.4.3
  %.2465 = fdiv double %.2460, %arg.step
  %.2466 = fmul double %.2465, 0x3FEFFFFFFFFFDCD1
  %.2467 = tail call double @llvm.ceil.f64(double %.2466)
  %.2468 = fptosi double %.2467 to i64
  %.11.i3687 = tail call i64 @llvm.smax.i64(i64 %.2468, i64 1)
  %.2500 = uitofp i64 %.11.i3687 to double
  %.2504 = fdiv double %.2460, %.2500
  br i1 %.2059, label %B0.endif.else.endif.if.i, label %B0.endif.else.endif.endif.i, !prof !36

B1154:                                            ; preds = %B906.endif.endif.endif.endif.endif
  br i1 %.2617.not, label %B1380, label %B1162

B1162:                                            ; preds = %B1154
  %.2670 = load double, ptr %.2425, align 8
  %.2672 = fcmp oeq double %.11.i3686, %.2670
  br i1 %.2672, label %B1190.else.endif, label %B1380

B1380:                                            ; preds = %B1228.i, %B360.i, %.4342.if, %B982.i, %B1162, %B1154
  %.4535 = load double, ptr %.2373, align 8
  %.4537 = fcmp oeq double %.11.i3686, %.4535
  br i1 %.4537, label %B1404, label %B1452

B1404:                                            ; preds = %B1380
  br i1 %.191230.not.i, label %_ZN12clpt_control6native9for_numba4keepB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B60.if.lr.ph.i

B60.if.lr.ph.i:                                   ; preds = %B1404
  %.513.i = select i1 %.2358, i64 %arg.results.0.5.1, i64 0
  %.514.i = add i64 %.513.i, %done.6.3
  %.543.i = mul i64 %.514.i, %arg.results.0.5.2
  %invariant.gep.i = getelementptr double, ptr %arg.results.0.4, i64 %.543.i
  %.557.i = add nsw i64 %done.6.3, 1
  %8 = shl i64 %.514.i, 3
  br label %B60.if.i

B106.i:                                           ; preds = %B60.if.i
  %.322.i3688 = getelementptr i64, ptr %arg.results.1.4, i64 %.286.i
  %.323.i = load i64, ptr %.322.i3688, align 8, !noalias !159
  %.324.i = icmp eq i64 %.323.i, 0
  br i1 %.324.i, label %B140.i, label %B232.i

B140.i:                                           ; preds = %B106.i
  br i1 %.406226.not.i, label %B216.i, label %B170.if.lr.ph.i

B170.if.lr.ph.i:                                  ; preds = %B140.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul229.i, %.286.i
  %gep.i = getelementptr double, ptr %invariant.gep.i, i64 %factor.op.mul.reass.i
  %invariant.gep3753 = getelementptr double, ptr %arg.arrays.0.4, i64 %.133.0231.i
  br i1 %or.cond3934, label %vector.memcheck, label %B170.if.i.preheader

vector.memcheck:                                  ; preds = %B170.if.lr.ph.i
  %9 = mul i64 %32, %.286.i
  %10 = add i64 %8, %9
  %11 = mul i64 %arg.results.0.5.2, %10
  %12 = add i64 %20, %11
  %diff.check = icmp ult i64 %12, 32
  br i1 %diff.check, label %B170.if.i.preheader, label %vector.body

vector.body:                                      ; preds = %vector.memcheck, %vector.body
  %index = phi i64 [ %index.next, %vector.body ], [ 0, %vector.memcheck ]
  %13 = getelementptr double, ptr %invariant.gep3753, i64 %index
  %14 = getelementptr i8, ptr %13, i64 16
  %wide.load = load <2 x double>, ptr %13, align 8, !noalias !159
  %wide.load3792 = load <2 x double>, ptr %14, align 8, !noalias !159
  %15 = getelementptr double, ptr %gep.i, i64 %index
  %16 = getelementptr i8, ptr %15, i64 16
  store <2 x double> %wide.load, ptr %15, align 8, !noalias !159
  store <2 x double> %wide.load3792, ptr %16, align 8, !noalias !159
  %index.next = add i64 %index, 4
  %17 = icmp eq i64 %index.next, %n.vec
  br i1 %17, label %middle.block, label %vector.body, !llvm.loop !162

middle.block:                                     ; preds = %vector.body
  br i1 %cmp.n, label %B216.i, label %B170.if.i.preheader

B170.if.i.preheader:                              ; preds = %vector.memcheck, %B170.if.lr.ph.i, %middle.block
  %.350.0227.i.ph = phi i64 [ 0, %vector.memcheck ], [ 0, %B170.if.lr.ph.i ], [ %n.vec, %middle.block ]
  br label %B170.if.i

B216.i:                                           ; preds = %B170.if.i, %middle.block, %B140.i
  %.587.i = getelementptr i64, ptr %arg.results.2.4, i64 %.286.i
  store i64 %.557.i, ptr %.587.i, align 8, !noalias !159
  br label %B232.i

B232.i:                                           ; preds = %B60.if.i, %B216.i, %B106.i
  %exitcond233.not.i = icmp eq i64 %arg.shape.0, %.204.i
  br i1 %exitcond233.not.i, label %_ZN12clpt_control6native9for_numba4keepB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B60.if.i

B60.if.i:                                         ; preds = %B232.i, %B60.if.lr.ph.i
  %.133.0231.i = phi i64 [ 0, %B60.if.lr.ph.i ], [ %.204.i, %B232.i ]
  %18 = shl i64 %.133.0231.i, 3
  %19 = add i64 %18, %arg.arrays.0.43791
  %20 = sub i64 %arg.results.0.43790, %19
  %.204.i = add nsw i64 %.133.0231.i, 1
  %21 = getelementptr i64, ptr %arg.lane.1.4, i64 %.133.0231.i
  %.286.i = load i64, ptr %21, align 8, !noalias !159
  %.291.i = icmp sgt i64 %.286.i, -1
  br i1 %.291.i, label %B106.i, label %B232.i

B170.if.i:                                        ; preds = %B170.if.i.preheader, %B170.if.i
  %.350.0227.i = phi i64 [ %.419.i, %B170.if.i ], [ %.350.0227.i.ph, %B170.if.i.preheader ]
  %.419.i = add nsw i64 %.350.0227.i, 1
  %.445.i = mul nsw i64 %.350.0227.i, %arg.shape.0
  %gep3754 = getelementptr double, ptr %invariant.gep3753, i64 %.445.i
  %.477.i = load double, ptr %gep3754, align 8, !noalias !159
  %22 = getelementptr double, ptr %gep.i, i64 %.350.0227.i
  store double %.477.i, ptr %22, align 8, !noalias !159
  %exitcond.not.i = icmp eq i64 %arg.shape.1, %.419.i
  br i1 %exitcond.not.i, label %B216.i, label %B170.if.i, !llvm.loop !163

_ZN12clpt_control6native9for_numba4keepB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B232.i, %B1404
  %.4595 = add nsw i64 %done.6.3, 1
  br label %B1452

B1452:                                            ; preds = %_ZN12clpt_control6native9for_numba4keepB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B1380
  %done.5.5 = phi i64 [ %.4595, %_ZN12clpt_control6native9for_numba4keepB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %done.6.3, %B1380 ]
  %.4654 = load double, ptr %.2425, align 8
  %.4656 = fcmp oeq double %.11.i3686, %.4654
  br i1 %.4656, label %B1480, label %B1492

B1480:                                            ; preds = %B1452
  %.4669 = add nsw i64 %edge.2.1, 1
  br label %B1532

B1492:                                            ; preds = %B1452
  %.4703 = icmp slt i64 %done.5.5, %arg.times.5.0
  br i1 %.4703, label %B906, label %B1532

B1532:                                            ; preds = %B906.endif.endif.endif.endif.endif, %B1492, %.2125.if, %B1480
  %t.3.4 = phi double [ %t.2.1, %.2125.if ], [ %.11.i3686, %B1480 ], [ %.11.i3686, %B1492 ], [ %t.4.3, %B906.endif.endif.endif.endif.endif ]
  %done.4.4 = phi i64 [ %done.3.1, %.2125.if ], [ %done.5.5, %B1480 ], [ %done.5.5, %B1492 ], [ %arg.times.5.0, %B906.endif.endif.endif.endif.endif ]
  %edge.3.4 = phi i64 [ %edge.2.1, %.2125.if ], [ %.4669, %B1480 ], [ %edge.2.1, %B1492 ], [ %edge.2.1, %B906.endif.endif.endif.endif.endif ]
  %.4743 = icmp slt i64 %done.4.4, %arg.times.5.0
  br i1 %.4743, label %B598, label %B1572

B1572:                                            ; preds = %B1532, %B512
  %edge.4.2 = phi i64 [ 0, %B512 ], [ %edge.3.4, %B1532 ]
  %.48423755.not = icmp slt i64 %.11.i, 1
  br i1 %.48423755.not, label %B148.loopexit, label %B1602.if

B1676:                                            ; preds = %B1602.if
  store i64 1, ptr %.4972, align 8
  br label %B1702

B1702:                                            ; preds = %B1676, %B1602.if
  %exitcond3786.not = icmp eq i64 %.11.i, %.4855
  br i1 %exitcond3786.not, label %B148.loopexit, label %B1602.if

common.ret:                                       ; preds = %B0.if, %B1708
  %common.ret.op = phi i32 [ 0, %B1708 ], [ 1, %B0.if ]
  ret i32 %common.ret.op

B1708:                                            ; preds = %B148.loopexit, %B0.endif.endif
  store ptr null, ptr %retptr, align 8
  br label %common.ret

B0.if:                                            ; preds = %entry
  store ptr @.const.picklebuf.ca8efb3a72d614fe872032cce3ac326007a30727, ptr %excinfo, align 8, !numba_exception_output !164
  br label %common.ret

B0.endif:                                         ; preds = %entry
  %.423 = icmp sgt i64 %arg.shape.0, 0
  %.424 = xor i1 %.423, %.422
  br i1 %.424, label %B0.endif.endif, label %B0.endif.else

B0.endif.else:                                    ; preds = %B0.endif
  %.439 = srem i64 %arg.runs.0.5.0, %arg.shape.0
  %.440 = sub nsw i64 0, %.439
  %.441 = select i1 %.422, i64 %.439, i64 %.440
  %.442 = icmp sgt i64 %.441, 0
  %.443 = sdiv i64 %arg.runs.0.5.0, %arg.shape.0
  %.444 = zext i1 %.442 to i64
  %.445 = add i64 %.443, %.444
  br label %B0.endif.endif

B0.endif.endif:                                   ; preds = %B0.endif, %B0.endif.else
  %storemerge = phi i64 [ %.445, %B0.endif.else ], [ 0, %B0.endif ]
  %.4673758 = icmp sgt i64 %storemerge, 0
  br i1 %.4673758, label %B152.lr.ph, label %B1708

B152.lr.ph:                                       ; preds = %B0.endif.endif
  %.411.13761 = add nsw i64 %storemerge, -1
  %.6353705.not = icmp slt i64 %arg.shape.0, 1
  %.8623699.not = icmp slt i64 %arg.shape.2, 1
  %.10703702.not = icmp slt i64 %arg.shape.1, 1
  %.1259 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.1408 = icmp sgt i64 %arg.times.5.0, 1
  %.1462 = icmp slt i64 %arg.schedule.2.5.0, 1
  %storemerge3670 = select i1 %.1462, i64 0, i64 %arg.schedule.2.5.0
  %.2059 = icmp slt i64 %arg.lane.0.5.1, 1
  %.2205 = getelementptr i8, ptr %arg.code.4, i64 8
  %.16253708.not = icmp slt i64 %arg.shape.0, 1
  %.1725 = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.214.i = mul i64 %arg.shape.1, %arg.shape.0
  %.322.i.idx = shl i64 %arg.lane.0.5.1, 6
  %.322.i = getelementptr i8, ptr %arg.lane.0.4, i64 %.322.i.idx
  %.idx3672 = shl i64 %arg.lane.0.5.1, 4
  %23 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx3672
  %.1612.i3722.not = icmp slt i64 %.214.i, 1
  %.1793.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.214.i
  %.2043.i.idx = mul i64 %.214.i, 136
  %.2043.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.2043.i.idx
  %.2105.i = getelementptr i8, ptr %arg.code.4, i64 256
  %.2154.i.not = icmp eq i64 %arg.guarded, 0
  %.2184.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.2316.i3731.not = icmp slt i64 %arg.shape.0, 1
  %.2771.i3727.not = icmp slt i64 %arg.shape.1, 1
  %.idx = mul i64 %arg.lane.0.5.1, 48
  %24 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx
  %.3077.i = icmp ne i64 %arg.shape.0, 1
  %.3161.i3738.not3765 = icmp slt i64 %arg.shape.1, 1
  %.2617.not = icmp eq i64 %arg.jumping, 0
  %.idx3676 = shl i64 %arg.lane.0.5.1, 4
  %25 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx3676
  %.idx3677 = mul i64 %arg.lane.0.5.1, 40
  %26 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx3677
  %.3933 = icmp slt i64 %arg.lane.1.5.1, 1
  %27 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.idx3678 = shl i64 %arg.lane.1.5.1, 4
  %.4101855.not.i = icmp slt i64 %arg.shape.0, 1
  %.idx1848.i = mul i64 %arg.lane.0.5.1, 40
  %28 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1848.i
  %.idx1849.i = shl i64 %arg.lane.0.5.1, 4
  %29 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1849.i
  %30 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.852.i = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1160.i = getelementptr i8, ptr %arg.code.4, i64 32
  %.1231.i = mul nsw i64 %arg.shape.1, 17
  %.1233.i = mul nsw i64 %.1231.i, %arg.shape.0
  %.1276.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.1233.i
  %.idx1846.i = shl i64 %arg.lane.1.5.1, 4
  %31 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1846.i
  %.17571859.not.i = icmp slt i64 %arg.shape.1, 1
  %.1952.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.2041.not.i = icmp eq i64 %arg.guarded, 0
  %.2073.i = getelementptr i8, ptr %arg.code.4, i64 16
  %factor.op.mul229.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.191230.not.i = icmp slt i64 %arg.shape.0, 1
  %.406226.not.i = icmp slt i64 %arg.shape.1, 1
  %scevgep = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx3678
  %32 = shl i64 %arg.results.0.5.1, 3
  %33 = shl i64 %arg.shape.1, 3
  %scevgep3845 = getelementptr i8, ptr %arg.arrays.0.4, i64 %33
  %34 = mul i64 %arg.shape.1, 144
  %scevgep3846 = getelementptr i8, ptr %arg.arrays.0.4, i64 %34
  %35 = mul i64 %arg.shape.1, 152
  %scevgep3847 = getelementptr i8, ptr %arg.arrays.0.4, i64 %35
  %36 = mul i64 %arg.shape.1, %arg.shape.0
  %37 = mul i64 %36, 144
  %min.iters.check3866 = icmp ult i64 %.214.i, 4
  %diff.check3864 = icmp ult i64 %37, 32
  %or.cond3935 = select i1 %min.iters.check3866, i1 true, i1 %diff.check3864
  %n.vec3869 = and i64 %.214.i, 9223372036854775804
  %38 = mul i64 %.214.i, 144
  %cmp.n3876 = icmp eq i64 %.214.i, %n.vec3869
  %.idx3787 = mul i64 %.214.i, 144
  %invariant.gep3952 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx3787
  %39 = getelementptr i8, ptr %arg.code.4, i64 232
  %.2068.i.idx = shl i64 %.214.i, 4
  %.2068.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.2068.i.idx
  %40 = getelementptr i8, ptr %arg.code.4, i64 240
  %.2068.i.1.idx = mul i64 %.214.i, 24
  %.2068.i.1 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.2068.i.1.idx
  %41 = getelementptr i8, ptr %arg.code.4, i64 248
  %.2068.i.2.idx = shl i64 %.214.i, 5
  %.2068.i.2 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.2068.i.2.idx
  %min.iters.check3849 = icmp ult i64 %arg.shape.1, 4
  %bound0 = icmp ult ptr %arg.arrays.0.4, %scevgep3847
  %bound1 = icmp ult ptr %scevgep3846, %scevgep3845
  %found.conflict = and i1 %bound0, %bound1
  %n.vec3852 = and i64 %arg.shape.1, 9223372036854775804
  %42 = mul i64 %arg.shape.1, 144
  %cmp.n3861 = icmp eq i64 %arg.shape.1, %n.vec3852
  %.idx3788 = mul i64 %arg.shape.1, 144
  %invariant.gep3956 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx3788
  %min.iters.check = icmp ugt i64 %arg.shape.1, 9
  %ident.check.not = icmp eq i64 %arg.shape.0, 1
  %or.cond3934 = and i1 %min.iters.check, %ident.check.not
  %n.vec = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n = icmp eq i64 %arg.shape.1, %n.vec
  br label %B152

B248.if:                                          ; preds = %B248.if.lr.ph, %B500
  %.579.03706 = phi i64 [ 0, %B248.if.lr.ph ], [ %.648, %B500 ]
  %.648 = add nsw i64 %.579.03706, 1
  %.11.i3689 = tail call i64 @llvm.smin.i64(i64 %.677, i64 %.579.03706)
  %.708 = add nsw i64 %.11.i3689, %.457.sroa.0.03764
  %.714 = icmp slt i64 %.579.03706, %.11.i
  %"$phi314.2.2.2" = select i1 %.714, i64 %.708, i64 -1
  %43 = getelementptr i64, ptr %arg.lane.1.4, i64 %.579.03706
  store i64 %"$phi314.2.2.2", ptr %43, align 8
  br i1 %.8623699.not, label %B410, label %B366.if.lr.ph

B366.if.lr.ph:                                    ; preds = %B248.if
  %.923 = icmp slt i64 %.708, 0
  %.924 = select i1 %.923, i64 %arg.runs.1.5.0, i64 0
  %.925 = add i64 %.924, %.708
  %.945 = mul i64 %.925, %arg.runs.1.5.1
  %44 = getelementptr double, ptr %arg.runs.1.4, i64 %.945
  %invariant.gep3948 = getelementptr double, ptr %arg.arrays.1.4, i64 %.579.03706
  br label %B366.if

B366.if:                                          ; preds = %B366.if.lr.ph, %B366.if
  %.806.03700 = phi i64 [ 0, %B366.if.lr.ph ], [ %.875, %B366.if ]
  %.875 = add nsw i64 %.806.03700, 1
  %45 = getelementptr double, ptr %44, i64 %.806.03700
  %.950 = load double, ptr %45, align 8
  %.952 = mul nsw i64 %.806.03700, %arg.shape.0
  %gep3949 = getelementptr double, ptr %invariant.gep3948, i64 %.952
  store double %.950, ptr %gep3949, align 8
  %exitcond.not = icmp eq i64 %arg.shape.2, %.875
  br i1 %exitcond.not, label %B410, label %B366.if

B440.if:                                          ; preds = %B440.if.lr.ph, %B440.if
  %.1014.03703 = phi i64 [ 0, %B440.if.lr.ph ], [ %.1083, %B440.if ]
  %.1083 = add nsw i64 %.1014.03703, 1
  %46 = getelementptr double, ptr %0, i64 %.1014.03703
  %.1158 = load double, ptr %46, align 8
  %.1160 = mul nsw i64 %.1014.03703, %arg.shape.0
  %gep3951 = getelementptr double, ptr %invariant.gep3950, i64 %.1160
  store double %.1158, ptr %gep3951, align 8
  %47 = getelementptr double, ptr %1, i64 %.1014.03703
  store double %.1158, ptr %47, align 8
  %exitcond3768.not = icmp eq i64 %arg.shape.1, %.1083
  br i1 %exitcond3768.not, label %B500, label %B440.if

B654.if:                                          ; preds = %B654.if.lr.ph, %B654.loopexit
  %.1451.03713 = phi i64 [ %storemerge3670, %B654.if.lr.ph ], [ %.1513, %B654.loopexit ]
  %.1448.03712 = phi i64 [ 0, %B654.if.lr.ph ], [ %.1517, %B654.loopexit ]
  %.1513 = add nsw i64 %.1451.03713, -1
  %.1517 = add nsw i64 %.1448.03712, 1
  br i1 %.16253708.not, label %B654.loopexit, label %B688.if.lr.ph

B688.if.lr.ph:                                    ; preds = %B654.if
  %48 = getelementptr double, ptr %6, i64 %.1448.03712
  %49 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1448.03712
  br label %B688.if

B688.if:                                          ; preds = %B688.if.lr.ph, %B688.if
  %.1569.03709 = phi i64 [ 0, %B688.if.lr.ph ], [ %.1638, %B688.if ]
  %.1638 = add nsw i64 %.1569.03709, 1
  %.1734 = load double, ptr %48, align 8
  %.1765 = load i64, ptr %49, align 8
  %.1767 = mul nsw i64 %.1765, %arg.shape.0
  %.1768 = add nsw i64 %.1767, %.1569.03709
  %.1782 = icmp slt i64 %.1768, 0
  %.1783 = select i1 %.1782, i64 %arg.arrays.1.5.0, i64 0
  %50 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1768
  %.1797 = getelementptr double, ptr %50, i64 %.1783
  store double %.1734, ptr %.1797, align 8
  %exitcond3770.not = icmp eq i64 %arg.shape.0, %.1638
  br i1 %exitcond3770.not, label %B654.loopexit, label %B688.if

B748.else.endif:                                  ; preds = %B654.loopexit, %B598
  br i1 %.2059, label %B748.endif.else.endif.if, label %B748.endif.else.endif.endif.endif.if, !prof !36

B748.endif.else.endif.if:                         ; preds = %B748.else.endif
  br label %B748.endif.else.endif.endif.endif.if

B748.endif.else.endif.endif.endif.if:             ; preds = %B748.endif.else.endif.if, %B748.else.endif
  %.2031.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %B748.endif.else.endif.if ], [ 0, %B748.else.endif ]
  %.2155.not3714 = icmp slt i64 %.2031.sroa.0.3, %arg.lane.0.5.1
  br i1 %.2155.not3714, label %.2125.endif.preheader, label %.2125.if, !prof !165

.2125.endif.preheader:                            ; preds = %B748.endif.else.endif.endif.endif.if
  %51 = sub i64 %arg.lane.0.5.1, %.2031.sroa.0.3
  %min.iters.check3921 = icmp ult i64 %51, 4
  br i1 %min.iters.check3921, label %.2125.endif.preheader3945, label %vector.ph3922, !prof !166

vector.ph3922:                                    ; preds = %.2125.endif.preheader
  %n.vec3924 = and i64 %51, -4
  %52 = add i64 %.2031.sroa.0.3, %n.vec3924
  %broadcast.splatinsert3925 = insertelement <2 x double> poison, double %t.2.1, i64 0
  %broadcast.splat3926 = shufflevector <2 x double> %broadcast.splatinsert3925, <2 x double> poison, <2 x i32> zeroinitializer
  %53 = getelementptr double, ptr %arg.lane.0.4, i64 %.2031.sroa.0.3
  br label %vector.body3927

vector.body3927:                                  ; preds = %vector.body3927, %vector.ph3922
  %index3928 = phi i64 [ 0, %vector.ph3922 ], [ %index.next3930, %vector.body3927 ]
  %54 = getelementptr double, ptr %53, i64 %index3928
  %55 = getelementptr i8, ptr %54, i64 16
  store <2 x double> %broadcast.splat3926, ptr %54, align 8
  store <2 x double> %broadcast.splat3926, ptr %55, align 8
  %index.next3930 = add i64 %index3928, 4
  %56 = icmp eq i64 %index.next3930, %n.vec3924
  br i1 %56, label %middle.block3931, label %vector.body3927, !prof !167, !llvm.loop !168

middle.block3931:                                 ; preds = %vector.body3927
  %cmp.n3932 = icmp eq i64 %51, %n.vec3924
  br i1 %cmp.n3932, label %.2125.if, label %.2125.endif.preheader3945, !prof !170

.2125.endif.preheader3945:                        ; preds = %.2125.endif.preheader, %middle.block3931
  %.2121.03715.ph = phi i64 [ %.2031.sroa.0.3, %.2125.endif.preheader ], [ %52, %middle.block3931 ]
  br label %.2125.endif

.2125.if:                                         ; preds = %.2125.endif, %middle.block3931, %B748.endif.else.endif.endif.endif.if
  %.2206 = load i64, ptr %.2205, align 8
  %.2318 = inttoptr i64 %.2206 to ptr
  tail call void %.2318(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.2331 = icmp slt i64 %done.3.1, %arg.times.5.0
  br i1 %.2331, label %B906.preheader, label %B1532

B906.preheader:                                   ; preds = %.2125.if
  %.2402 = icmp slt i64 %edge.2.1, 0
  %.2403 = select i1 %.2402, i64 %arg.schedule.0.5.1, i64 0
  %57 = getelementptr double, ptr %5, i64 %edge.2.1
  %.2425 = getelementptr double, ptr %57, i64 %.2403
  %broadcast.splatinsert = insertelement <2 x i64> poison, i64 %edge.2.1, i64 0
  %broadcast.splat = shufflevector <2 x i64> %broadcast.splatinsert, <2 x i64> poison, <2 x i32> zeroinitializer
  br label %B906

.2125.endif:                                      ; preds = %.2125.endif.preheader3945, %.2125.endif
  %.2121.03715 = phi i64 [ %.2169, %.2125.endif ], [ %.2121.03715.ph, %.2125.endif.preheader3945 ]
  %.2164 = getelementptr double, ptr %arg.lane.0.4, i64 %.2121.03715
  store double %t.2.1, ptr %.2164, align 8
  %.2169 = add nsw i64 %.2121.03715, 1
  %exitcond3771.not = icmp eq i64 %.2169, %arg.lane.0.5.1
  br i1 %exitcond3771.not, label %.2125.if, label %.2125.endif, !prof !171, !llvm.loop !172

B358.i:                                           ; preds = %B308.if.i, %middle.block3875, %.1482.if.i
  %.1747.i = load i64, ptr %arg.code.4, align 8, !noalias !174
  %.1794.i = inttoptr i64 %.1747.i to ptr
  tail call void %.1794.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1793.i), !noalias !174
  %.1943.i = load i64, ptr %39, align 8, !noalias !174
  %.1988.i = inttoptr i64 %.1943.i to ptr
  tail call void %.1988.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !174
  %.2019.i = load i64, ptr %arg.code.4, align 8, !noalias !174
  %.2069.i = inttoptr i64 %.2019.i to ptr
  tail call void %.2069.i(ptr %.322.i, ptr %.2043.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.2068.i), !noalias !174
  %.1943.i.1 = load i64, ptr %40, align 8, !noalias !174
  %.1988.i.1 = inttoptr i64 %.1943.i.1 to ptr
  tail call void %.1988.i.1(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !174
  %.2019.i.1 = load i64, ptr %arg.code.4, align 8, !noalias !174
  %.2069.i.1 = inttoptr i64 %.2019.i.1 to ptr
  tail call void %.2069.i.1(ptr %.322.i, ptr %.2043.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.2068.i.1), !noalias !174
  %.1943.i.2 = load i64, ptr %41, align 8, !noalias !174
  %.1988.i.2 = inttoptr i64 %.1943.i.2 to ptr
  tail call void %.1988.i.2(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !174
  %.2019.i.2 = load i64, ptr %arg.code.4, align 8, !noalias !174
  %.2069.i.2 = inttoptr i64 %.2019.i.2 to ptr
  tail call void %.2069.i.2(ptr %.322.i, ptr %.2043.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.2068.i.2), !noalias !174
  %.2106.i = load i64, ptr %.2105.i, align 8, !noalias !174
  %.2151.i = inttoptr i64 %.2106.i to ptr
  tail call void %.2151.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !174
  br i1 %.2154.i.not, label %B806.i, label %B738.i

B738.i:                                           ; preds = %B358.i
  %.2185.i = load i64, ptr %.2184.i, align 8, !noalias !174
  %.2230.i = inttoptr i64 %.2185.i to ptr
  tail call void %.2230.i(ptr %.322.i, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !174
  br label %B806.i

B806.i:                                           ; preds = %B738.i, %B358.i
  br i1 %.2316.i3731.not, label %B1254.i, label %B840.if.i

B890.i:                                           ; preds = %B840.if.i
  %.2450.i = getelementptr i64, ptr %arg.results.1.4, i64 %.2411.i
  %.2451.i = load i64, ptr %.2450.i, align 8, !noalias !174
  %.2452.i.not = icmp eq i64 %.2451.i, 0
  br i1 %.2452.i.not, label %B926.i, label %B1465.i

B926.i:                                           ; preds = %B890.i
  %.2522.i = mul i64 %.2411.i, %arg.results.3.5.1
  %.2526.i = getelementptr i64, ptr %arg.results.3.4, i64 %.2522.i
  %.2527.i = load i64, ptr %.2526.i, align 8, !noalias !174
  %.2528.i = add nsw i64 %.2527.i, 1
  store i64 %.2528.i, ptr %.2526.i, align 8, !noalias !174
  %.2636.i = getelementptr i8, ptr %.2526.i, i64 8
  %.2637.i = load i64, ptr %.2636.i, align 8, !noalias !174
  %.2638.i = add nsw i64 %.2637.i, 4
  store i64 %.2638.i, ptr %.2636.i, align 8, !noalias !174
  br i1 %.2771.i3727.not, label %B1154.i, label %B1048.if.i.preheader

B1048.if.i.preheader:                             ; preds = %B926.i
  %invariant.gep3954 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2260.i.03732
  br label %B1048.if.i

B1094.i.loopexit:                                 ; preds = %B1048.if.i
  %58 = fcmp une double %.2845.i, 0.000000e+00
  br i1 %58, label %B1106.i, label %B1154.i

B1106.i:                                          ; preds = %B1094.i.loopexit
  %.84.i.i = load i64, ptr %92, align 8, !noalias !178
  %.89.i.i = icmp sgt i64 %.84.i.i, -1
  br i1 %.89.i.i, label %B46.i.i, label %B1465.i

B46.i.i:                                          ; preds = %B1106.i
  %.120.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i.i
  %.121.i.i = load i64, ptr %.120.i.i, align 8, !noalias !178
  %.122.i.i = icmp eq i64 %.121.i.i, 0
  br i1 %.122.i.i, label %B80.i.i, label %B1465.i

B80.i.i:                                          ; preds = %B46.i.i
  store i64 3, ptr %.120.i.i, align 8, !noalias !178
  br label %B1465.i

B1154.i:                                          ; preds = %B926.i, %B1094.i.loopexit
  br i1 %.2154.i.not, label %B1242.i, label %B1158.i

B1158.i:                                          ; preds = %B1154.i
  %59 = getelementptr double, ptr %arg.arrays.4.4, i64 %.2260.i.03732
  %.2933.i = load double, ptr %59, align 8, !noalias !174
  %.2935.i = fcmp olt double %.2933.i, -1.000000e-09
  br i1 %.2935.i, label %B1194.i, label %B1242.i

B1194.i:                                          ; preds = %B1158.i
  %.84.i63.i = load i64, ptr %92, align 8, !noalias !181
  %.89.i66.i = icmp sgt i64 %.84.i63.i, -1
  br i1 %.89.i66.i, label %B46.i71.i, label %B1465.i

B46.i71.i:                                        ; preds = %B1194.i
  %.120.i91.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i63.i
  %.121.i92.i = load i64, ptr %.120.i91.i, align 8, !noalias !181
  %.122.i93.i = icmp eq i64 %.121.i92.i, 0
  br i1 %.122.i93.i, label %B80.i98.i, label %B1465.i

B80.i98.i:                                        ; preds = %B46.i71.i
  store i64 4, ptr %.120.i91.i, align 8, !noalias !181
  br label %B1465.i

B1242.i:                                          ; preds = %B1158.i, %B1154.i
  %.2982.i = add nsw i64 %active.3.i.13734, 1
  br label %B1465.i

B1254.i.loopexit:                                 ; preds = %B1465.i
  %60 = icmp ne i64 %active.4.i.2, 0
  br label %B1254.i

B1254.i:                                          ; preds = %B1254.i.loopexit, %B806.i
  %active.3.i.1.lcssa = phi i1 [ false, %B806.i ], [ %60, %B1254.i.loopexit ]
  %.795.i = icmp sgt i64 %.733.i.03736, 1
  %or.cond = select i1 %active.3.i.1.lcssa, i1 %.795.i, i1 false
  br i1 %or.cond, label %B186.if.i, label %B1274.i

B1274.i:                                          ; preds = %B1254.i
  %or.cond.not3766 = or i1 %.3077.i, %active.3.i.1.lcssa
  %brmerge = select i1 %or.cond.not3766, i1 true, i1 %.3161.i3738.not3765
  br i1 %brmerge, label %B906.endif.endif.endif.endif.endif, label %B1328.if.i.preheader

B1328.if.i.preheader:                             ; preds = %B1274.i
  %brmerge3958 = select i1 %min.iters.check3849, i1 true, i1 %found.conflict
  br i1 %brmerge3958, label %B1328.if.i.preheader3943, label %vector.body3853

vector.body3853:                                  ; preds = %B1328.if.i.preheader, %vector.body3853
  %index3854 = phi i64 [ %index.next3859, %vector.body3853 ], [ 0, %B1328.if.i.preheader ]
  %61 = getelementptr double, ptr %arg.arrays.0.4, i64 %index3854
  %62 = getelementptr i8, ptr %61, i64 %42
  %63 = getelementptr i8, ptr %62, i64 16
  %wide.load3855 = load <2 x double>, ptr %62, align 8, !alias.scope !184, !noalias !174
  %wide.load3856 = load <2 x double>, ptr %63, align 8, !alias.scope !184, !noalias !174
  %64 = getelementptr i8, ptr %61, i64 16
  %wide.load3857 = load <2 x double>, ptr %61, align 8, !alias.scope !187, !noalias !189
  %wide.load3858 = load <2 x double>, ptr %64, align 8, !alias.scope !187, !noalias !189
  %65 = fsub <2 x double> %wide.load3857, %wide.load3855
  %66 = fsub <2 x double> %wide.load3858, %wide.load3856
  store <2 x double> %wide.load3855, ptr %61, align 8, !alias.scope !187, !noalias !189
  store <2 x double> %wide.load3856, ptr %64, align 8, !alias.scope !187, !noalias !189
  store <2 x double> %65, ptr %62, align 8, !alias.scope !184, !noalias !174
  store <2 x double> %66, ptr %63, align 8, !alias.scope !184, !noalias !174
  %index.next3859 = add i64 %index3854, 4
  %67 = icmp eq i64 %index.next3859, %n.vec3852
  br i1 %67, label %middle.block3860, label %vector.body3853, !llvm.loop !190

middle.block3860:                                 ; preds = %vector.body3853
  br i1 %cmp.n3861, label %B906.endif.endif.endif.endif.endif, label %B1328.if.i.preheader3943

B1328.if.i.preheader3943:                         ; preds = %B1328.if.i.preheader, %middle.block3860
  %.3105.i.03739.ph = phi i64 [ %n.vec3852, %middle.block3860 ], [ 0, %B1328.if.i.preheader ]
  br label %B1328.if.i

B1465.i:                                          ; preds = %B80.i98.i, %B1194.i, %B46.i71.i, %B80.i.i, %B1106.i, %B46.i.i, %B840.if.i, %B890.i, %B1242.i
  %active.4.i.2 = phi i64 [ %.2982.i, %B1242.i ], [ %active.3.i.13734, %B840.if.i ], [ %active.3.i.13734, %B80.i.i ], [ %active.3.i.13734, %B890.i ], [ %active.3.i.13734, %B46.i.i ], [ %active.3.i.13734, %B1106.i ], [ %active.3.i.13734, %B46.i71.i ], [ %active.3.i.13734, %B1194.i ], [ %active.3.i.13734, %B80.i98.i ]
  %exitcond3778.not = icmp eq i64 %arg.shape.0, %.2329.i
  br i1 %exitcond3778.not, label %B1254.i.loopexit, label %B840.if.i

B0.endif.else.endif.if.i:                         ; preds = %B906
  br label %B0.endif.else.endif.endif.i

B0.endif.else.endif.endif.i:                      ; preds = %B0.endif.else.endif.if.i, %B906
  %spec.select = phi i64 [ %arg.lane.0.5.1, %B0.endif.else.endif.if.i ], [ 0, %B906 ]
  %.684.i.not3716 = icmp slt i64 %spec.select, %arg.lane.0.5.1
  br i1 %.684.i.not3716, label %.654.endif.i.preheader, label %B186.if.i.preheader, !prof !165

.654.endif.i.preheader:                           ; preds = %B0.endif.else.endif.endif.i
  %68 = sub i64 %arg.lane.0.5.1, %spec.select
  %min.iters.check3907 = icmp ult i64 %68, 4
  br i1 %min.iters.check3907, label %.654.endif.i.preheader3944, label %vector.ph3908, !prof !166

vector.ph3908:                                    ; preds = %.654.endif.i.preheader
  %n.vec3910 = and i64 %68, -4
  %69 = add i64 %spec.select, %n.vec3910
  %broadcast.splatinsert3911 = insertelement <2 x double> poison, double %.2504, i64 0
  %broadcast.splat3912 = shufflevector <2 x double> %broadcast.splatinsert3911, <2 x double> poison, <2 x i32> zeroinitializer
  %70 = getelementptr double, ptr %24, i64 %spec.select
  br label %vector.body3913

vector.body3913:                                  ; preds = %vector.body3913, %vector.ph3908
  %index3914 = phi i64 [ 0, %vector.ph3908 ], [ %index.next3916, %vector.body3913 ]
  %71 = getelementptr double, ptr %70, i64 %index3914
  %72 = getelementptr i8, ptr %71, i64 16
  store <2 x double> %broadcast.splat3912, ptr %71, align 8, !noalias !174
  store <2 x double> %broadcast.splat3912, ptr %72, align 8, !noalias !174
  %index.next3916 = add i64 %index3914, 4
  %73 = icmp eq i64 %index.next3916, %n.vec3910
  br i1 %73, label %middle.block3917, label %vector.body3913, !prof !167, !llvm.loop !191

middle.block3917:                                 ; preds = %vector.body3913
  %cmp.n3918 = icmp eq i64 %68, %n.vec3910
  br i1 %cmp.n3918, label %B186.if.i.preheader, label %.654.endif.i.preheader3944, !prof !170

.654.endif.i.preheader3944:                       ; preds = %.654.endif.i.preheader, %middle.block3917
  %.650.i.03717.ph = phi i64 [ %spec.select, %.654.endif.i.preheader ], [ %69, %middle.block3917 ]
  br label %.654.endif.i

.654.endif.i:                                     ; preds = %.654.endif.i.preheader3944, %.654.endif.i
  %.650.i.03717 = phi i64 [ %.698.i, %.654.endif.i ], [ %.650.i.03717.ph, %.654.endif.i.preheader3944 ]
  %.693.i = getelementptr double, ptr %24, i64 %.650.i.03717
  store double %.2504, ptr %.693.i, align 8, !noalias !174
  %.698.i = add nsw i64 %.650.i.03717, 1
  %exitcond3772.not = icmp eq i64 %.698.i, %arg.lane.0.5.1
  br i1 %exitcond3772.not, label %B186.if.i.preheader, label %.654.endif.i, !prof !171, !llvm.loop !192

B186.if.i.preheader:                              ; preds = %.654.endif.i, %middle.block3917, %B0.endif.else.endif.endif.i
  br label %B186.if.i

B186.if.i:                                        ; preds = %B186.if.i.preheader, %B1254.i
  %.730.i.03737 = phi i64 [ %.808.i, %B1254.i ], [ 0, %B186.if.i.preheader ]
  %.733.i.03736 = phi i64 [ %.804.i, %B1254.i ], [ %.11.i3687, %B186.if.i.preheader ]
  %.804.i = add nsw i64 %.733.i.03736, -1
  %.808.i = add nsw i64 %.730.i.03737, 1
  %.836.i = uitofp i64 %.730.i.03737 to double
  %.837.i = fmul double %.2504, %.836.i
  %.839.i = fadd double %t.4.3, %.837.i
  %.842.i = uitofp i64 %.808.i to double
  %.843.i = fmul double %.2504, %.842.i
  %.845.i = fadd double %t.4.3, %.843.i
  br i1 %.2059, label %B188.endif.else.endif.if.i, label %B188.endif.else.endif.endif.i, !prof !36

B188.endif.else.endif.if.i:                       ; preds = %B186.if.i
  br label %B188.endif.else.endif.endif.i

B188.endif.else.endif.endif.i:                    ; preds = %B188.endif.else.endif.if.i, %B186.if.i
  %spec.select3684 = phi i64 [ %arg.lane.0.5.1, %B188.endif.else.endif.if.i ], [ 0, %B186.if.i ]
  %.1169.i.not3718 = icmp slt i64 %spec.select3684, %arg.lane.0.5.1
  br i1 %.1169.i.not3718, label %.1139.endif.i.preheader, label %.1140.else.i, !prof !165

.1139.endif.i.preheader:                          ; preds = %B188.endif.else.endif.endif.i
  %74 = sub i64 %arg.lane.0.5.1, %spec.select3684
  %min.iters.check3893 = icmp ult i64 %74, 4
  br i1 %min.iters.check3893, label %.1139.endif.i.preheader3938, label %vector.ph3894, !prof !166

vector.ph3894:                                    ; preds = %.1139.endif.i.preheader
  %n.vec3896 = and i64 %74, -4
  %75 = add i64 %spec.select3684, %n.vec3896
  %broadcast.splatinsert3897 = insertelement <2 x double> poison, double %.839.i, i64 0
  %broadcast.splat3898 = shufflevector <2 x double> %broadcast.splatinsert3897, <2 x double> poison, <2 x i32> zeroinitializer
  %76 = getelementptr double, ptr %arg.lane.0.4, i64 %spec.select3684
  br label %vector.body3899

vector.body3899:                                  ; preds = %vector.body3899, %vector.ph3894
  %index3900 = phi i64 [ 0, %vector.ph3894 ], [ %index.next3902, %vector.body3899 ]
  %77 = getelementptr double, ptr %76, i64 %index3900
  %78 = getelementptr i8, ptr %77, i64 16
  store <2 x double> %broadcast.splat3898, ptr %77, align 8, !noalias !174
  store <2 x double> %broadcast.splat3898, ptr %78, align 8, !noalias !174
  %index.next3902 = add i64 %index3900, 4
  %79 = icmp eq i64 %index.next3902, %n.vec3896
  br i1 %79, label %middle.block3903, label %vector.body3899, !prof !167, !llvm.loop !193

middle.block3903:                                 ; preds = %vector.body3899
  %cmp.n3904 = icmp eq i64 %74, %n.vec3896
  br i1 %cmp.n3904, label %.1140.else.i, label %.1139.endif.i.preheader3938, !prof !170

.1139.endif.i.preheader3938:                      ; preds = %.1139.endif.i.preheader, %middle.block3903
  %.1135.i.03719.ph = phi i64 [ %spec.select3684, %.1139.endif.i.preheader ], [ %75, %middle.block3903 ]
  br label %.1139.endif.i

.1139.endif.i:                                    ; preds = %.1139.endif.i.preheader3938, %.1139.endif.i
  %.1135.i.03719 = phi i64 [ %.1183.i, %.1139.endif.i ], [ %.1135.i.03719.ph, %.1139.endif.i.preheader3938 ]
  %.1178.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1135.i.03719
  store double %.839.i, ptr %.1178.i, align 8, !noalias !174
  %.1183.i = add nsw i64 %.1135.i.03719, 1
  %exitcond3773.not = icmp eq i64 %.1183.i, %arg.lane.0.5.1
  br i1 %exitcond3773.not, label %.1140.else.i, label %.1139.endif.i, !prof !171, !llvm.loop !194

.1140.else.i:                                     ; preds = %.1139.endif.i, %middle.block3903, %B188.endif.else.endif.endif.i
  br i1 %.2059, label %.1140.endif.else.endif.if.i, label %.1140.endif.else.endif.endif.i, !prof !36

.1140.endif.else.endif.if.i:                      ; preds = %.1140.else.i
  br label %.1140.endif.else.endif.endif.i

.1140.endif.else.endif.endif.i:                   ; preds = %.1140.endif.else.endif.if.i, %.1140.else.i
  %spec.select3685 = phi i64 [ %arg.lane.0.5.1, %.1140.endif.else.endif.if.i ], [ 0, %.1140.else.i ]
  %.1512.i.not3720 = icmp slt i64 %spec.select3685, %arg.lane.0.5.1
  br i1 %.1512.i.not3720, label %.1482.endif.i.preheader, label %.1482.if.i, !prof !165

.1482.endif.i.preheader:                          ; preds = %.1140.endif.else.endif.endif.i
  %80 = sub i64 %arg.lane.0.5.1, %spec.select3685
  %min.iters.check3879 = icmp ult i64 %80, 4
  br i1 %min.iters.check3879, label %.1482.endif.i.preheader3937, label %vector.ph3880, !prof !166

vector.ph3880:                                    ; preds = %.1482.endif.i.preheader
  %n.vec3882 = and i64 %80, -4
  %81 = add i64 %spec.select3685, %n.vec3882
  %broadcast.splatinsert3883 = insertelement <2 x double> poison, double %.845.i, i64 0
  %broadcast.splat3884 = shufflevector <2 x double> %broadcast.splatinsert3883, <2 x double> poison, <2 x i32> zeroinitializer
  %82 = getelementptr double, ptr %23, i64 %spec.select3685
  br label %vector.body3885

vector.body3885:                                  ; preds = %vector.body3885, %vector.ph3880
  %index3886 = phi i64 [ 0, %vector.ph3880 ], [ %index.next3888, %vector.body3885 ]
  %83 = getelementptr double, ptr %82, i64 %index3886
  %84 = getelementptr i8, ptr %83, i64 16
  store <2 x double> %broadcast.splat3884, ptr %83, align 8, !noalias !174
  store <2 x double> %broadcast.splat3884, ptr %84, align 8, !noalias !174
  %index.next3888 = add i64 %index3886, 4
  %85 = icmp eq i64 %index.next3888, %n.vec3882
  br i1 %85, label %middle.block3889, label %vector.body3885, !prof !167, !llvm.loop !195

middle.block3889:                                 ; preds = %vector.body3885
  %cmp.n3890 = icmp eq i64 %80, %n.vec3882
  br i1 %cmp.n3890, label %.1482.if.i, label %.1482.endif.i.preheader3937, !prof !170

.1482.endif.i.preheader3937:                      ; preds = %.1482.endif.i.preheader, %middle.block3889
  %.1478.i.03721.ph = phi i64 [ %spec.select3685, %.1482.endif.i.preheader ], [ %81, %middle.block3889 ]
  br label %.1482.endif.i

.1482.if.i:                                       ; preds = %.1482.endif.i, %middle.block3889, %.1140.endif.else.endif.endif.i
  br i1 %.1612.i3722.not, label %B358.i, label %B308.if.i.preheader

B308.if.i.preheader:                              ; preds = %.1482.if.i
  br i1 %or.cond3935, label %B308.if.i.preheader3936, label %vector.body3870

vector.body3870:                                  ; preds = %B308.if.i.preheader, %vector.body3870
  %index3871 = phi i64 [ %index.next3874, %vector.body3870 ], [ 0, %B308.if.i.preheader ]
  %86 = getelementptr double, ptr %arg.arrays.0.4, i64 %index3871
  %87 = getelementptr i8, ptr %86, i64 16
  %wide.load3872 = load <2 x double>, ptr %86, align 8, !noalias !174
  %wide.load3873 = load <2 x double>, ptr %87, align 8, !noalias !174
  %88 = getelementptr i8, ptr %86, i64 %38
  %89 = getelementptr i8, ptr %88, i64 16
  store <2 x double> %wide.load3872, ptr %88, align 8, !noalias !174
  store <2 x double> %wide.load3873, ptr %89, align 8, !noalias !174
  %index.next3874 = add i64 %index3871, 4
  %90 = icmp eq i64 %index.next3874, %n.vec3869
  br i1 %90, label %middle.block3875, label %vector.body3870, !llvm.loop !196

middle.block3875:                                 ; preds = %vector.body3870
  br i1 %cmp.n3876, label %B358.i, label %B308.if.i.preheader3936

B308.if.i.preheader3936:                          ; preds = %B308.if.i.preheader, %middle.block3875
  %.1556.i.03724.ph = phi i64 [ 0, %B308.if.i.preheader ], [ %n.vec3869, %middle.block3875 ]
  br label %B308.if.i

.1482.endif.i:                                    ; preds = %.1482.endif.i.preheader3937, %.1482.endif.i
  %.1478.i.03721 = phi i64 [ %.1526.i, %.1482.endif.i ], [ %.1478.i.03721.ph, %.1482.endif.i.preheader3937 ]
  %.1521.i = getelementptr double, ptr %23, i64 %.1478.i.03721
  store double %.845.i, ptr %.1521.i, align 8, !noalias !174
  %.1526.i = add nsw i64 %.1478.i.03721, 1
  %exitcond3774.not = icmp eq i64 %.1526.i, %arg.lane.0.5.1
  br i1 %exitcond3774.not, label %.1482.if.i, label %.1482.endif.i, !prof !171, !llvm.loop !197

B308.if.i:                                        ; preds = %B308.if.i.preheader3936, %B308.if.i
  %.1556.i.03724 = phi i64 [ %.1625.i, %B308.if.i ], [ %.1556.i.03724.ph, %B308.if.i.preheader3936 ]
  %.1625.i = add nsw i64 %.1556.i.03724, 1
  %91 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1556.i.03724
  %.1679.i = load double, ptr %91, align 8, !noalias !174
  %gep3953 = getelementptr double, ptr %invariant.gep3952, i64 %.1556.i.03724
  store double %.1679.i, ptr %gep3953, align 8, !noalias !174
  %exitcond3775.not = icmp eq i64 %.214.i, %.1625.i
  br i1 %exitcond3775.not, label %B358.i, label %B308.if.i, !llvm.loop !198

B840.if.i:                                        ; preds = %B806.i, %B1465.i
  %active.3.i.13734 = phi i64 [ %active.4.i.2, %B1465.i ], [ 0, %B806.i ]
  %.2260.i.03732 = phi i64 [ %.2329.i, %B1465.i ], [ 0, %B806.i ]
  %.2329.i = add nsw i64 %.2260.i.03732, 1
  %92 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2260.i.03732
  %.2411.i = load i64, ptr %92, align 8, !noalias !174
  %.2419.i = icmp slt i64 %.2411.i, 0
  br i1 %.2419.i, label %B1465.i, label %B890.i

B1048.if.i:                                       ; preds = %B1048.if.i.preheader, %B1048.if.i
  %trouble.2.i.33730 = phi double [ %.2845.i, %B1048.if.i ], [ 0.000000e+00, %B1048.if.i.preheader ]
  %.2715.i.03728 = phi i64 [ %.2784.i, %B1048.if.i ], [ 0, %B1048.if.i.preheader ]
  %.2784.i = add nsw i64 %.2715.i.03728, 1
  %93 = mul nsw i64 %.2715.i.03728, %arg.shape.0
  %gep3955 = getelementptr double, ptr %invariant.gep3954, i64 %93
  %.2842.i = load double, ptr %gep3955, align 8, !noalias !174
  %.2843.i = fmul double %.2842.i, 0.000000e+00
  %.2845.i = fadd double %trouble.2.i.33730, %.2843.i
  %exitcond3777.not = icmp eq i64 %arg.shape.1, %.2784.i
  br i1 %exitcond3777.not, label %B1094.i.loopexit, label %B1048.if.i

B1328.if.i:                                       ; preds = %B1328.if.i.preheader3943, %B1328.if.i
  %.3105.i.03739 = phi i64 [ %.3174.i, %B1328.if.i ], [ %.3105.i.03739.ph, %B1328.if.i.preheader3943 ]
  %.3174.i = add nsw i64 %.3105.i.03739, 1
  %gep3957 = getelementptr double, ptr %invariant.gep3956, i64 %.3105.i.03739
  %.3231.i = load double, ptr %gep3957, align 8, !noalias !174
  %94 = getelementptr double, ptr %arg.arrays.0.4, i64 %.3105.i.03739
  %.3261.i = load double, ptr %94, align 8, !noalias !174
  %.3295.i = fsub double %.3261.i, %.3231.i
  store double %.3231.i, ptr %94, align 8, !noalias !174
  store double %.3295.i, ptr %gep3957, align 8, !noalias !174
  %exitcond3779.not = icmp eq i64 %arg.shape.1, %.3174.i
  br i1 %exitcond3779.not, label %B906.endif.endif.endif.endif.endif, label %B1328.if.i, !llvm.loop !199

B906.endif.endif.endif.endif.endif:               ; preds = %B1328.if.i, %middle.block3860, %B1274.i
  br i1 %active.3.i.1.lcssa, label %B1154, label %B1532

B1190.else.endif:                                 ; preds = %B1162
  br i1 %.2059, label %B1190.endif.else.endif.if, label %B1190.endif.else.endif.endif.endif.if, !prof !36

B1190.endif.else.endif.if:                        ; preds = %B1190.else.endif
  br label %B1190.endif.else.endif.endif.endif.if

B1190.endif.else.endif.endif.endif.if:            ; preds = %B1190.endif.else.endif.if, %B1190.else.endif
  %.2874.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %B1190.endif.else.endif.if ], [ 0, %B1190.else.endif ]
  %.2998.not3741 = icmp slt i64 %.2874.sroa.0.3, %arg.lane.0.5.1
  br i1 %.2998.not3741, label %.2968.endif.preheader, label %.2969.else.endif, !prof !165

.2968.endif.preheader:                            ; preds = %B1190.endif.else.endif.endif.endif.if
  %95 = sub i64 %arg.lane.0.5.1, %.2874.sroa.0.3
  %min.iters.check3831 = icmp ult i64 %95, 4
  br i1 %min.iters.check3831, label %.2968.endif.preheader3942, label %vector.ph3832, !prof !166

vector.ph3832:                                    ; preds = %.2968.endif.preheader
  %n.vec3834 = and i64 %95, -4
  %96 = add i64 %.2874.sroa.0.3, %n.vec3834
  %broadcast.splatinsert3835 = insertelement <2 x double> poison, double %.11.i3686, i64 0
  %broadcast.splat3836 = shufflevector <2 x double> %broadcast.splatinsert3835, <2 x double> poison, <2 x i32> zeroinitializer
  %97 = getelementptr double, ptr %arg.lane.0.4, i64 %.2874.sroa.0.3
  br label %vector.body3837

vector.body3837:                                  ; preds = %vector.body3837, %vector.ph3832
  %index3838 = phi i64 [ 0, %vector.ph3832 ], [ %index.next3840, %vector.body3837 ]
  %98 = getelementptr double, ptr %97, i64 %index3838
  %99 = getelementptr i8, ptr %98, i64 16
  store <2 x double> %broadcast.splat3836, ptr %98, align 8
  store <2 x double> %broadcast.splat3836, ptr %99, align 8
  %index.next3840 = add i64 %index3838, 4
  %100 = icmp eq i64 %index.next3840, %n.vec3834
  br i1 %100, label %middle.block3841, label %vector.body3837, !prof !167, !llvm.loop !200

middle.block3841:                                 ; preds = %vector.body3837
  %cmp.n3842 = icmp eq i64 %95, %n.vec3834
  br i1 %cmp.n3842, label %.2969.else.endif, label %.2968.endif.preheader3942, !prof !170

.2968.endif.preheader3942:                        ; preds = %.2968.endif.preheader, %middle.block3841
  %.2964.03742.ph = phi i64 [ %.2874.sroa.0.3, %.2968.endif.preheader ], [ %96, %middle.block3841 ]
  br label %.2968.endif

.2968.endif:                                      ; preds = %.2968.endif.preheader3942, %.2968.endif
  %.2964.03742 = phi i64 [ %.3012, %.2968.endif ], [ %.2964.03742.ph, %.2968.endif.preheader3942 ]
  %.3007 = getelementptr double, ptr %arg.lane.0.4, i64 %.2964.03742
  store double %.11.i3686, ptr %.3007, align 8
  %.3012 = add nsw i64 %.2964.03742, 1
  %exitcond3780.not = icmp eq i64 %.3012, %arg.lane.0.5.1
  br i1 %exitcond3780.not, label %.2969.else.endif, label %.2968.endif, !prof !171, !llvm.loop !201

.2969.else.endif:                                 ; preds = %.2968.endif, %middle.block3841, %B1190.endif.else.endif.endif.endif.if
  br i1 %.2059, label %.2969.endif.else.endif.if, label %.2969.endif.else.endif.endif.endif.if, !prof !36

.2969.endif.else.endif.if:                        ; preds = %.2969.else.endif
  br label %.2969.endif.else.endif.endif.endif.if

.2969.endif.else.endif.endif.endif.if:            ; preds = %.2969.endif.else.endif.if, %.2969.else.endif
  %.3218.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %.2969.endif.else.endif.if ], [ 0, %.2969.else.endif ]
  %.3342.not3743 = icmp slt i64 %.3218.sroa.0.3, %arg.lane.0.5.1
  br i1 %.3342.not3743, label %.3312.endif.preheader, label %.3313.else.endif, !prof !165

.3312.endif.preheader:                            ; preds = %.2969.endif.else.endif.endif.endif.if
  %101 = sub i64 %arg.lane.0.5.1, %.3218.sroa.0.3
  %min.iters.check3817 = icmp ult i64 %101, 4
  br i1 %min.iters.check3817, label %.3312.endif.preheader3941, label %vector.ph3818, !prof !166

vector.ph3818:                                    ; preds = %.3312.endif.preheader
  %n.vec3820 = and i64 %101, -4
  %102 = add i64 %.3218.sroa.0.3, %n.vec3820
  %broadcast.splatinsert3821 = insertelement <2 x double> poison, double %.11.i3686, i64 0
  %broadcast.splat3822 = shufflevector <2 x double> %broadcast.splatinsert3821, <2 x double> poison, <2 x i32> zeroinitializer
  %103 = getelementptr double, ptr %25, i64 %.3218.sroa.0.3
  br label %vector.body3823

vector.body3823:                                  ; preds = %vector.body3823, %vector.ph3818
  %index3824 = phi i64 [ 0, %vector.ph3818 ], [ %index.next3826, %vector.body3823 ]
  %104 = getelementptr double, ptr %103, i64 %index3824
  %105 = getelementptr i8, ptr %104, i64 16
  store <2 x double> %broadcast.splat3822, ptr %104, align 8
  store <2 x double> %broadcast.splat3822, ptr %105, align 8
  %index.next3826 = add i64 %index3824, 4
  %106 = icmp eq i64 %index.next3826, %n.vec3820
  br i1 %106, label %middle.block3827, label %vector.body3823, !prof !167, !llvm.loop !202

middle.block3827:                                 ; preds = %vector.body3823
  %cmp.n3828 = icmp eq i64 %101, %n.vec3820
  br i1 %cmp.n3828, label %.3313.else.endif, label %.3312.endif.preheader3941, !prof !170

.3312.endif.preheader3941:                        ; preds = %.3312.endif.preheader, %middle.block3827
  %.3308.03744.ph = phi i64 [ %.3218.sroa.0.3, %.3312.endif.preheader ], [ %102, %middle.block3827 ]
  br label %.3312.endif

.3312.endif:                                      ; preds = %.3312.endif.preheader3941, %.3312.endif
  %.3308.03744 = phi i64 [ %.3356, %.3312.endif ], [ %.3308.03744.ph, %.3312.endif.preheader3941 ]
  %.3351 = getelementptr double, ptr %25, i64 %.3308.03744
  store double %.11.i3686, ptr %.3351, align 8
  %.3356 = add nsw i64 %.3308.03744, 1
  %exitcond3781.not = icmp eq i64 %.3356, %arg.lane.0.5.1
  br i1 %exitcond3781.not, label %.3313.else.endif, label %.3312.endif, !prof !171, !llvm.loop !203

.3313.else.endif:                                 ; preds = %.3312.endif, %middle.block3827, %.2969.endif.else.endif.endif.endif.if
  br i1 %.2059, label %.3313.endif.else.endif.if, label %.3313.endif.else.endif.endif.endif.if, !prof !36

.3313.endif.else.endif.if:                        ; preds = %.3313.else.endif
  br label %.3313.endif.else.endif.endif.endif.if

.3313.endif.else.endif.endif.endif.if:            ; preds = %.3313.endif.else.endif.if, %.3313.else.endif
  %.3561.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %.3313.endif.else.endif.if ], [ 0, %.3313.else.endif ]
  %.3685.not3745 = icmp slt i64 %.3561.sroa.0.3, %arg.lane.0.5.1
  br i1 %.3685.not3745, label %.3655.endif.preheader, label %.3656.else.endif, !prof !165

.3655.endif.preheader:                            ; preds = %.3313.endif.else.endif.endif.endif.if
  %107 = sub i64 %arg.lane.0.5.1, %.3561.sroa.0.3
  %min.iters.check3805 = icmp ult i64 %107, 4
  br i1 %min.iters.check3805, label %.3655.endif.preheader3940, label %vector.ph3806, !prof !166

vector.ph3806:                                    ; preds = %.3655.endif.preheader
  %n.vec3808 = and i64 %107, -4
  %108 = add i64 %.3561.sroa.0.3, %n.vec3808
  %109 = getelementptr double, ptr %26, i64 %.3561.sroa.0.3
  br label %vector.body3809

vector.body3809:                                  ; preds = %vector.body3809, %vector.ph3806
  %index3810 = phi i64 [ 0, %vector.ph3806 ], [ %index.next3812, %vector.body3809 ]
  %110 = getelementptr double, ptr %109, i64 %index3810
  %111 = getelementptr i8, ptr %110, i64 16
  store <2 x double> splat (double 1.000000e+00), ptr %110, align 8
  store <2 x double> splat (double 1.000000e+00), ptr %111, align 8
  %index.next3812 = add i64 %index3810, 4
  %112 = icmp eq i64 %index.next3812, %n.vec3808
  br i1 %112, label %middle.block3813, label %vector.body3809, !prof !167, !llvm.loop !204

middle.block3813:                                 ; preds = %vector.body3809
  %cmp.n3814 = icmp eq i64 %107, %n.vec3808
  br i1 %cmp.n3814, label %.3656.else.endif, label %.3655.endif.preheader3940, !prof !170

.3655.endif.preheader3940:                        ; preds = %.3655.endif.preheader, %middle.block3813
  %.3651.03746.ph = phi i64 [ %.3561.sroa.0.3, %.3655.endif.preheader ], [ %108, %middle.block3813 ]
  br label %.3655.endif

.3655.endif:                                      ; preds = %.3655.endif.preheader3940, %.3655.endif
  %.3651.03746 = phi i64 [ %.3699, %.3655.endif ], [ %.3651.03746.ph, %.3655.endif.preheader3940 ]
  %.3694 = getelementptr double, ptr %26, i64 %.3651.03746
  store double 1.000000e+00, ptr %.3694, align 8
  %.3699 = add nsw i64 %.3651.03746, 1
  %exitcond3782.not = icmp eq i64 %.3699, %arg.lane.0.5.1
  br i1 %exitcond3782.not, label %.3656.else.endif, label %.3655.endif, !prof !171, !llvm.loop !205

.3656.else.endif:                                 ; preds = %.3655.endif, %middle.block3813, %.3313.endif.else.endif.endif.endif.if
  br i1 %.3933, label %.3656.endif.else.endif.if, label %.3656.endif.else.endif.endif.endif.if, !prof !36

.3656.endif.else.endif.if:                        ; preds = %.3656.else.endif
  br label %.3656.endif.else.endif.endif.endif.if

.3656.endif.else.endif.endif.endif.if:            ; preds = %.3656.endif.else.endif.if, %.3656.else.endif
  %.3905.sroa.0.3 = phi i64 [ %arg.lane.1.5.1, %.3656.endif.else.endif.if ], [ 0, %.3656.else.endif ]
  %.4029.not3747 = icmp slt i64 %.3905.sroa.0.3, %arg.lane.1.5.1
  br i1 %.4029.not3747, label %.3999.endif.preheader, label %.4000.else.endif, !prof !165

.3999.endif.preheader:                            ; preds = %.3656.endif.else.endif.endif.endif.if
  %113 = sub i64 %arg.lane.1.5.1, %.3905.sroa.0.3
  %min.iters.check3794 = icmp ult i64 %113, 4
  br i1 %min.iters.check3794, label %.3999.endif.preheader3939, label %vector.ph3795, !prof !166

vector.ph3795:                                    ; preds = %.3999.endif.preheader
  %n.vec3797 = and i64 %113, -4
  %114 = add i64 %.3905.sroa.0.3, %n.vec3797
  %115 = getelementptr i64, ptr %27, i64 %.3905.sroa.0.3
  br label %vector.body3798

vector.body3798:                                  ; preds = %vector.body3798, %vector.ph3795
  %index3799 = phi i64 [ 0, %vector.ph3795 ], [ %index.next3800, %vector.body3798 ]
  %116 = getelementptr i64, ptr %115, i64 %index3799
  %117 = getelementptr i8, ptr %116, i64 16
  store <2 x i64> %broadcast.splat, ptr %116, align 8
  store <2 x i64> %broadcast.splat, ptr %117, align 8
  %index.next3800 = add i64 %index3799, 4
  %118 = icmp eq i64 %index.next3800, %n.vec3797
  br i1 %118, label %middle.block3801, label %vector.body3798, !prof !167, !llvm.loop !206

middle.block3801:                                 ; preds = %vector.body3798
  %cmp.n3802 = icmp eq i64 %113, %n.vec3797
  br i1 %cmp.n3802, label %.4000.else.endif, label %.3999.endif.preheader3939, !prof !170

.3999.endif.preheader3939:                        ; preds = %.3999.endif.preheader, %middle.block3801
  %.3995.03748.ph = phi i64 [ %.3905.sroa.0.3, %.3999.endif.preheader ], [ %114, %middle.block3801 ]
  br label %.3999.endif

.3999.endif:                                      ; preds = %.3999.endif.preheader3939, %.3999.endif
  %.3995.03748 = phi i64 [ %.4043, %.3999.endif ], [ %.3995.03748.ph, %.3999.endif.preheader3939 ]
  %.4038 = getelementptr i64, ptr %27, i64 %.3995.03748
  store i64 %edge.2.1, ptr %.4038, align 8
  %.4043 = add nsw i64 %.3995.03748, 1
  %exitcond3783.not = icmp eq i64 %.4043, %arg.lane.1.5.1
  br i1 %exitcond3783.not, label %.4000.else.endif, label %.3999.endif, !prof !171, !llvm.loop !207

.4000.else.endif:                                 ; preds = %.3999.endif, %middle.block3801, %.3656.endif.else.endif.endif.endif.if
  br i1 %.3933, label %.4000.endif.else.endif.if, label %.4000.endif.else.endif.endif.endif.if, !prof !36

.4000.endif.else.endif.if:                        ; preds = %.4000.else.endif
  br label %.4000.endif.else.endif.endif.endif.if

.4000.endif.else.endif.endif.endif.if:            ; preds = %.4000.endif.else.endif.if, %.4000.else.endif
  %.4248.sroa.0.3 = phi i64 [ %arg.lane.1.5.1, %.4000.endif.else.endif.if ], [ 0, %.4000.else.endif ]
  %.4372.not3749 = icmp slt i64 %.4248.sroa.0.3, %arg.lane.1.5.1
  br i1 %.4372.not3749, label %.4342.endif.preheader, label %.4342.if, !prof !165

.4342.endif.preheader:                            ; preds = %.4000.endif.else.endif.endif.endif.if
  %119 = shl i64 %.4248.sroa.0.3, 3
  %scevgep3784 = getelementptr i8, ptr %scevgep, i64 %119
  %120 = sub i64 %arg.lane.1.5.1, %.4248.sroa.0.3
  %121 = shl i64 %120, 3
  tail call void @llvm.memset.p0.i64(ptr align 8 %scevgep3784, i8 0, i64 %121, i1 false)
  br label %.4342.if

.4342.if:                                         ; preds = %.4342.endif.preheader, %.4000.endif.else.endif.endif.endif.if
  br i1 %.4101855.not.i, label %B1380, label %B110.if.i

B46.i.i3692:                                      ; preds = %B110.if.i
  %.135.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !208
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i3696, label %B358.i3693

B80.i.i3696:                                      ; preds = %B46.i.i3692
  %.196.i.i = getelementptr double, ptr %28, i64 %.352.01856.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !208
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B358.i3693, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i3696
  %.264.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.352.01856.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !208
  %.321.i.i = getelementptr double, ptr %29, i64 %.352.01856.i
  %.322.i.i = load double, ptr %.321.i.i, align 8, !noalias !208
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.1462
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01858.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01858.i
  br i1 %brmerge.i, label %B358.i3693, label %B300.if.lr.ph.i

B300.if.lr.ph.i:                                  ; preds = %B122.i.i
  %.650.i = getelementptr i64, ptr %30, i64 %.352.01856.i
  %.651.i = load i64, ptr %.650.i, align 8, !noalias !213
  %.652.i = add nsw i64 %.651.i, 1
  %122 = getelementptr i64, ptr %arg.runs.2.4, i64 %.99.i.i
  %.596.i = load i64, ptr %122, align 8, !noalias !213
  %.822.i = icmp slt i64 %.596.i, 0
  %.823.i = select i1 %.822.i, i64 %arg.schedule.3.5.0, i64 0
  %.824.i = add i64 %.823.i, %.596.i
  %.825.i = icmp slt i64 %.651.i, -1
  %.826.i = select i1 %.825.i, i64 %arg.schedule.3.5.1, i64 0
  %.827.i = add i64 %.652.i, %.826.i
  %.854.i = mul i64 %.852.i, %.824.i
  %.856.i = mul i64 %.827.i, %arg.schedule.3.5.2
  %123 = getelementptr double, ptr %arg.schedule.3.4, i64 %.854.i
  %124 = getelementptr double, ptr %123, i64 %.856.i
  br label %B300.if.i

B358.i3693:                                       ; preds = %B300.if.i, %B110.if.i, %B122.i.i, %B80.i.i3696, %B46.i.i3692
  %some.3.2.i = phi i1 [ %some.2.01858.i, %B80.i.i3696 ], [ %some.2.01858.mux.i, %B122.i.i ], [ %some.2.01858.i, %B46.i.i3692 ], [ %some.2.01858.i, %B110.if.i ], [ true, %B300.if.i ]
  %exitcond1870.not.i = icmp eq i64 %arg.shape.0, %.423.i3691
  br i1 %exitcond1870.not.i, label %B360.i, label %B110.if.i

B360.i:                                           ; preds = %B358.i3693
  br i1 %some.3.2.i, label %B368.i, label %B1380

B368.i:                                           ; preds = %B360.i
  %.1018.i = load i64, ptr %.2205, align 8, !noalias !213
  %.1130.i = inttoptr i64 %.1018.i to ptr
  tail call void %.1130.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !213
  %.1161.i = load i64, ptr %.1160.i, align 8, !noalias !213
  %.1277.i = inttoptr i64 %.1161.i to ptr
  tail call void %.1277.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1276.i), !noalias !213
  br label %B600.if.i

B46.i82.i:                                        ; preds = %B600.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !214
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B980.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %28, i64 %.1303.01865.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !214
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B980.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1303.01865.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !214
  %.321.i223.i = getelementptr double, ptr %29, i64 %.1303.01865.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !214
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B980.i, label %B640.i

B640.i:                                           ; preds = %B122.i147.i
  %.1557.i = getelementptr i64, ptr %31, i64 %.1303.01865.i
  %.1558.i = load i64, ptr %.1557.i, align 8, !noalias !213
  %.1569.i = icmp sgt i64 %.1558.i, 0
  br i1 %.1569.i, label %B716.i, label %B770.i

B716.i:                                           ; preds = %B640.i
  %125 = getelementptr double, ptr %arg.times.4, i64 %.1558.i
  %.1604.i = getelementptr i8, ptr %125, i64 -8
  %.1605.i = load double, ptr %.1604.i, align 8, !noalias !213
  %.1661.i = fcmp oeq double %.1605.i, %.265.i185.i
  br label %B770.i

B770.i:                                           ; preds = %B716.i, %B640.i
  %"$phi770.1.2.1.i" = phi i1 [ %.1661.i, %B716.i ], [ false, %B640.i ]
  br i1 %.17571859.not.i, label %B980.i, label %B802.if.lr.ph.i

B802.if.lr.ph.i:                                  ; preds = %B770.i
  %.1887.i = add nsw i64 %.1558.i, -1
  %.1926.i = select i1 %.1569.i, i64 0, i64 %arg.results.0.5.1
  %.1927.i3694 = add i64 %.1887.i, %.1926.i
  %.1954.i = mul i64 %.1952.i, %.99.i78.i
  %.1956.i = mul i64 %.1927.i3694, %arg.results.0.5.2
  %126 = getelementptr double, ptr %arg.results.0.4, i64 %.1954.i
  %127 = getelementptr double, ptr %126, i64 %.1956.i
  %invariant.gep = getelementptr double, ptr %arg.arrays.0.4, i64 %.1303.01865.i
  %invariant.gep3751 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1303.01865.i
  br label %B802.if.i

B898.i:                                           ; preds = %B802.if.i
  %128 = getelementptr double, ptr %127, i64 %.1701.01860.i
  store double %.1835.i, ptr %128, align 8, !noalias !213
  br label %B920.i

B920.i:                                           ; preds = %B802.if.i, %B898.i
  %exitcond1871.not.i = icmp eq i64 %arg.shape.1, %.1770.i
  br i1 %exitcond1871.not.i, label %B922.loopexit.i, label %B802.if.i

B922.loopexit.i:                                  ; preds = %B920.i
  %129 = fcmp une double %.1842.i, 0.000000e+00
  br i1 %129, label %B934.i, label %B980.i

B934.i:                                           ; preds = %B922.loopexit.i
  %.84.i516.i = load i64, ptr %135, align 8, !noalias !217
  %.89.i518.i = icmp sgt i64 %.84.i516.i, -1
  br i1 %.89.i518.i, label %B46.i521.i, label %B980.i

B46.i521.i:                                       ; preds = %B934.i
  %.120.i539.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i516.i
  %.121.i540.i = load i64, ptr %.120.i539.i, align 8, !noalias !217
  %.122.i541.i = icmp eq i64 %.121.i540.i, 0
  br i1 %.122.i541.i, label %B80.i545.i, label %B980.i

B80.i545.i:                                       ; preds = %B46.i521.i
  store i64 3, ptr %.120.i539.i, align 8, !noalias !217
  br label %B980.i

B980.i:                                           ; preds = %B600.if.i, %B80.i545.i, %B46.i521.i, %B934.i, %B922.loopexit.i, %B770.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %exitcond1872.not.i = icmp eq i64 %arg.shape.0, %.1372.i
  br i1 %exitcond1872.not.i, label %B982.i, label %B600.if.i

B982.i:                                           ; preds = %B980.i
  br i1 %.2041.not.i, label %B1380, label %B986.i

B986.i:                                           ; preds = %B982.i
  %.2074.i = load i64, ptr %.2073.i, align 8, !noalias !213
  %.2188.i = inttoptr i64 %.2074.i to ptr
  tail call void %.2188.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !213
  br label %B1106.if.i

B46.i315.i:                                       ; preds = %B1106.if.i
  %.135.i335.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i311.i
  %.136.i336.i = load i64, ptr %.135.i335.i, align 8, !noalias !220
  %.141.i339.not.i = icmp eq i64 %.136.i336.i, 0
  br i1 %.141.i339.not.i, label %B80.i340.i, label %B1228.i

B80.i340.i:                                       ; preds = %B46.i315.i
  %.196.i377.i = getelementptr double, ptr %28, i64 %.2224.01868.i
  %.197.i378.i = load double, ptr %.196.i377.i, align 8, !noalias !220
  %.198.i379.i = fcmp olt double %.197.i378.i, 5.000000e-01
  br i1 %.198.i379.i, label %B1228.i, label %B122.i380.i

B122.i380.i:                                      ; preds = %B80.i340.i
  %.264.i417.i = getelementptr double, ptr %arg.lane.0.4, i64 %.2224.01868.i
  %.265.i418.i = load double, ptr %.264.i417.i, align 8, !noalias !220
  %.321.i456.i = getelementptr double, ptr %29, i64 %.2224.01868.i
  %.322.i457.i = load double, ptr %.321.i456.i, align 8, !noalias !220
  %.325.i459.i = fcmp une double %.265.i418.i, %.322.i457.i
  br i1 %.325.i459.i, label %B1228.i, label %B1146.i

B1146.i:                                          ; preds = %B122.i380.i
  %130 = getelementptr double, ptr %arg.arrays.4.4, i64 %.2224.01868.i
  %.2400.i = load double, ptr %130, align 8, !noalias !213
  %.2402.i = fcmp olt double %.2400.i, -1.000000e-09
  br i1 %.2402.i, label %B80.i672.i, label %B1228.i

B80.i672.i:                                       ; preds = %B1146.i
  store i64 4, ptr %.135.i335.i, align 8, !noalias !223
  br label %B1228.i

B1228.i:                                          ; preds = %B1106.if.i, %B80.i672.i, %B1146.i, %B122.i380.i, %B80.i340.i, %B46.i315.i
  %exitcond3785.not = icmp eq i64 %arg.shape.0, %.2293.i
  br i1 %exitcond3785.not, label %B1380, label %B1106.if.i

B110.if.i:                                        ; preds = %.4342.if, %B358.i3693
  %some.2.01858.i = phi i1 [ %some.3.2.i, %B358.i3693 ], [ false, %.4342.if ]
  %.352.01856.i = phi i64 [ %.423.i3691, %B358.i3693 ], [ 0, %.4342.if ]
  %.423.i3691 = add nsw i64 %.352.01856.i, 1
  %131 = getelementptr i64, ptr %arg.lane.1.4, i64 %.352.01856.i
  %.99.i.i = load i64, ptr %131, align 8, !noalias !208
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B358.i3693, label %B46.i.i3692

B300.if.i:                                        ; preds = %B300.if.i, %B300.if.lr.ph.i
  %.692.01853.i = phi i64 [ 0, %B300.if.lr.ph.i ], [ %.764.i, %B300.if.i ]
  %.764.i = add nsw i64 %.692.01853.i, 1
  %132 = getelementptr double, ptr %124, i64 %.692.01853.i
  %.861.i = load double, ptr %132, align 8, !noalias !213
  %133 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.692.01853.i
  %.891.i = load i64, ptr %133, align 8, !noalias !213
  %.893.i = mul nsw i64 %.891.i, %arg.shape.0
  %.895.i = add nsw i64 %.893.i, %.352.01856.i
  %.909.i = icmp slt i64 %.895.i, 0
  %.910.i = select i1 %.909.i, i64 %arg.arrays.1.5.0, i64 0
  %134 = getelementptr double, ptr %arg.arrays.1.4, i64 %.895.i
  %.924.i = getelementptr double, ptr %134, i64 %.910.i
  store double %.861.i, ptr %.924.i, align 8, !noalias !213
  %exitcond.not.i3697 = icmp eq i64 %arg.schedule.2.5.0, %.764.i
  br i1 %exitcond.not.i3697, label %B358.i3693, label %B300.if.i

B600.if.i:                                        ; preds = %B980.i, %B368.i
  %.1303.01865.i = phi i64 [ 0, %B368.i ], [ %.1372.i, %B980.i ]
  %.1372.i = add nsw i64 %.1303.01865.i, 1
  %135 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1303.01865.i
  %.99.i78.i = load i64, ptr %135, align 8, !noalias !214
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B980.i, label %B46.i82.i

B802.if.i:                                        ; preds = %B920.i, %B802.if.lr.ph.i
  %trouble.2.11862.i = phi double [ 0.000000e+00, %B802.if.lr.ph.i ], [ %.1842.i, %B920.i ]
  %.1701.01860.i = phi i64 [ 0, %B802.if.lr.ph.i ], [ %.1770.i, %B920.i ]
  %.1770.i = add nsw i64 %.1701.01860.i, 1
  %.1801.i = add nsw i64 %.1701.01860.i, %.1231.i
  %.1803.i = mul nsw i64 %.1801.i, %arg.shape.0
  %gep = getelementptr double, ptr %invariant.gep, i64 %.1803.i
  %.1835.i = load double, ptr %gep, align 8, !noalias !213
  %.1840.i = fmul double %.1835.i, 0.000000e+00
  %.1842.i = fadd double %trouble.2.11862.i, %.1840.i
  %.1850.i = mul nsw i64 %.1701.01860.i, %arg.shape.0
  %gep3752 = getelementptr double, ptr %invariant.gep3751, i64 %.1850.i
  store double %.1835.i, ptr %gep3752, align 8, !noalias !213
  br i1 %"$phi770.1.2.1.i", label %B898.i, label %B920.i

B1106.if.i:                                       ; preds = %B1228.i, %B986.i
  %.2224.01868.i = phi i64 [ 0, %B986.i ], [ %.2293.i, %B1228.i ]
  %.2293.i = add nsw i64 %.2224.01868.i, 1
  %136 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2224.01868.i
  %.99.i311.i = load i64, ptr %136, align 8, !noalias !220
  %.104.i314.i = icmp slt i64 %.99.i311.i, 0
  br i1 %.104.i314.i, label %B1228.i, label %B46.i315.i

B1602.if:                                         ; preds = %B1572, %B1702
  %.4786.03756 = phi i64 [ %.4855, %B1702 ], [ 0, %B1572 ]
  %.4855 = add nsw i64 %.4786.03756, 1
  %.4885 = add nsw i64 %.4786.03756, %.457.sroa.0.03764
  %.4913 = icmp slt i64 %.4885, 0
  %.4914 = select i1 %.4913, i64 %arg.results.3.5.0, i64 0
  %.4915 = add i64 %.4914, %.4885
  %.4935 = mul i64 %.4915, %arg.results.3.5.1
  %137 = getelementptr i64, ptr %arg.results.3.4, i64 %.4935
  %.4939 = getelementptr i8, ptr %137, i64 16
  store i64 %edge.4.2, ptr %.4939, align 8
  %.4958 = select i1 %.4913, i64 %arg.results.1.5.0, i64 0
  %138 = getelementptr i64, ptr %arg.results.1.4, i64 %.4885
  %.4972 = getelementptr i64, ptr %138, i64 %.4958
  %.4973 = load i64, ptr %.4972, align 8
  %.4974 = icmp eq i64 %.4973, 0
  br i1 %.4974, label %B1676, label %B1702
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
  br i1 %8, label %middle.block, label %vector.body, !llvm.loop !226

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
  br i1 %exitcond540.not, label %B64.loopexit, label %B430.if, !llvm.loop !227
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
!59 = !{!60, !62}
!60 = distinct !{!60, !61, !"_ZN12clpt_control6native9for_numba5countB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!61 = distinct !{!61, !"_ZN12clpt_control6native9for_numba5countB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!62 = distinct !{!62, !61, !"_ZN12clpt_control6native9for_numba5countB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!63 = !{!64}
!64 = distinct !{!64, !65, !"_ZN12clpt_control6native9for_numba4failB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_282_29: %retptr"}
!65 = distinct !{!65, !"_ZN12clpt_control6native9for_numba4failB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_282_29"}
!66 = !{!67, !69}
!67 = distinct !{!67, !68, !"_ZN12clpt_control6native9for_numba6passesB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!68 = distinct !{!68, !"_ZN12clpt_control6native9for_numba6passesB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!69 = distinct !{!69, !68, !"_ZN12clpt_control6native9for_numba6passesB3v23B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!70 = !{!71, !73, !67, !69}
!71 = distinct !{!71, !72, !"_ZN12clpt_control6native9for_numba6passedB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!72 = distinct !{!72, !"_ZN12clpt_control6native9for_numba6passedB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!73 = distinct !{!73, !72, !"_ZN12clpt_control6native9for_numba6passedB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!74 = !{!75}
!75 = distinct !{!75, !76, !"_ZN12clpt_control6native9for_numba5crossB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!76 = distinct !{!76, !"_ZN12clpt_control6native9for_numba5crossB3v25B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!77 = !{!78, !80, !75}
!78 = distinct !{!78, !79, !"_ZN12clpt_control6native9for_numba6passedB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!79 = distinct !{!79, !"_ZN12clpt_control6native9for_numba6passedB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!80 = distinct !{!80, !79, !"_ZN12clpt_control6native9for_numba6passedB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!81 = !{!82, !84, !75}
!82 = distinct !{!82, !83, !"_ZN12clpt_control6native9for_numba7betweenB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!83 = distinct !{!83, !"_ZN12clpt_control6native9for_numba7betweenB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!84 = distinct !{!84, !83, !"_ZN12clpt_control6native9for_numba7betweenB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!85 = distinct !{!85, !7, !8}
!86 = distinct !{!86, !7}
!87 = !{!88}
!88 = distinct !{!88, !89, !"_ZN12clpt_control6native9for_numba5watchB3v28B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!89 = distinct !{!89, !"_ZN12clpt_control6native9for_numba5watchB3v28B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!90 = !{!91, !88}
!91 = distinct !{!91, !92, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!92 = distinct !{!92, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!93 = !{!94, !96, !88}
!94 = distinct !{!94, !95, !"_ZN12clpt_control6native9for_numba7betweenB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!95 = distinct !{!95, !"_ZN12clpt_control6native9for_numba7betweenB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!96 = distinct !{!96, !95, !"_ZN12clpt_control6native9for_numba7betweenB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!97 = distinct !{!97, !7, !8}
!98 = distinct !{!98, !7}
!99 = !{!100}
!100 = distinct !{!100, !101, !"_ZN12clpt_control6native9for_numba6sampleB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!101 = distinct !{!101, !"_ZN12clpt_control6native9for_numba6sampleB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!102 = !{!103, !105, !100}
!103 = distinct !{!103, !104, !"_ZN12clpt_control6native9for_numba7betweenB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!104 = distinct !{!104, !"_ZN12clpt_control6native9for_numba7betweenB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!105 = distinct !{!105, !104, !"_ZN12clpt_control6native9for_numba7betweenB3v26B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!106 = !{!107, !109}
!107 = distinct !{!107, !108, !"_ZN12clpt_control6native9for_numba11decide_anewB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!108 = distinct !{!108, !"_ZN12clpt_control6native9for_numba11decide_anewB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!109 = distinct !{!109, !108, !"_ZN12clpt_control6native9for_numba11decide_anewB3v30B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!110 = !{!111, !107, !109}
!111 = distinct !{!111, !112, !"_ZN12clpt_control6native9for_numba4failB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29: %retptr"}
!112 = distinct !{!112, !"_ZN12clpt_control6native9for_numba4failB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29"}
!113 = !{!114, !116}
!114 = distinct !{!114, !115, !"_ZN12clpt_control6native9for_numba6at_endB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!115 = distinct !{!115, !"_ZN12clpt_control6native9for_numba6at_endB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!116 = distinct !{!116, !117, !"_ZN12clpt_control6native9for_numba4leapB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx: %retptr"}
!117 = distinct !{!117, !"_ZN12clpt_control6native9for_numba4leapB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx"}
!118 = !{!116}
!119 = !{!120, !116}
!120 = distinct !{!120, !121, !"_ZN12clpt_control6native9for_numba6at_endB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!121 = distinct !{!121, !"_ZN12clpt_control6native9for_numba6at_endB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!122 = !{!123, !116}
!123 = distinct !{!123, !124, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!124 = distinct !{!124, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!125 = !{!126, !116}
!126 = distinct !{!126, !127, !"_ZN12clpt_control6native9for_numba6at_endB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!127 = distinct !{!127, !"_ZN12clpt_control6native9for_numba6at_endB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!128 = !{!129, !116}
!129 = distinct !{!129, !130, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!130 = distinct !{!130, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!131 = !{!132, !134}
!132 = distinct !{!132, !133, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!133 = distinct !{!133, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!134 = distinct !{!134, !133, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!135 = !{!136}
!136 = distinct !{!136, !137, !"_ZN12clpt_control6native9for_numba4failB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29: %retptr"}
!137 = distinct !{!137, !"_ZN12clpt_control6native9for_numba4failB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29"}
!138 = !{!139, !141}
!139 = distinct !{!139, !140, !"_ZN12clpt_control6native9for_numba5enterB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!140 = distinct !{!140, !"_ZN12clpt_control6native9for_numba5enterB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!141 = distinct !{!141, !140, !"_ZN12clpt_control6native9for_numba5enterB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!142 = !{!143}
!143 = distinct !{!143, !144, !"_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!144 = distinct !{!144, !"_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!145 = distinct !{!145, !7, !8}
!146 = !{!147, !149, !143}
!147 = distinct !{!147, !148, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!148 = distinct !{!148, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!149 = distinct !{!149, !148, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!150 = distinct !{!150, !7}
!151 = !{!152, !154}
!152 = distinct !{!152, !153, !"_ZN12clpt_control6native9for_numba10look_againB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!153 = distinct !{!153, !"_ZN12clpt_control6native9for_numba10look_againB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!154 = distinct !{!154, !153, !"_ZN12clpt_control6native9for_numba10look_againB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!155 = !{!156, !158}
!156 = distinct !{!156, !157, !"_ZN12clpt_control6native9for_numba5countB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!157 = distinct !{!157, !"_ZN12clpt_control6native9for_numba5countB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!158 = distinct !{!158, !157, !"_ZN12clpt_control6native9for_numba5countB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!159 = !{!160}
!160 = distinct !{!160, !161, !"_ZN12clpt_control6native9for_numba4keepB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!161 = distinct !{!161, !"_ZN12clpt_control6native9for_numba4keepB3v42B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!162 = distinct !{!162, !7, !8}
!163 = distinct !{!163, !7}
!164 = !{i1 true}
!165 = !{!"branch_weights", i32 127, i32 1}
!166 = !{!"branch_weights", i32 1, i32 127}
!167 = !{!"branch_weights", i32 127, i32 3048}
!168 = distinct !{!168, !7, !8, !169}
!169 = !{!"llvm.loop.estimated_trip_count", i32 25}
!170 = !{!"branch_weights", i32 1, i32 3}
!171 = !{!"branch_weights", i32 1, i32 0}
!172 = distinct !{!172, !8, !7, !173}
!173 = !{!"llvm.loop.estimated_trip_count", i32 0}
!174 = !{!175, !177}
!175 = distinct !{!175, !176, !"_ZN12clpt_control6native9for_numba5marchB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEddx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx: %retptr"}
!176 = distinct !{!176, !"_ZN12clpt_control6native9for_numba5marchB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEddx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx"}
!177 = distinct !{!177, !176, !"_ZN12clpt_control6native9for_numba5marchB3v40B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEddx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx: %excinfo"}
!178 = !{!179, !175, !177}
!179 = distinct !{!179, !180, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!180 = distinct !{!180, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!181 = !{!182, !175, !177}
!182 = distinct !{!182, !183, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!183 = distinct !{!183, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!184 = !{!185}
!185 = distinct !{!185, !186}
!186 = distinct !{!186, !"LVerDomain"}
!187 = !{!188}
!188 = distinct !{!188, !186}
!189 = !{!175, !177, !185}
!190 = distinct !{!190, !7, !8}
!191 = distinct !{!191, !7, !8, !169}
!192 = distinct !{!192, !8, !7, !173}
!193 = distinct !{!193, !7, !8, !169}
!194 = distinct !{!194, !8, !7, !173}
!195 = distinct !{!195, !7, !8, !169}
!196 = distinct !{!196, !7, !8}
!197 = distinct !{!197, !8, !7, !173}
!198 = distinct !{!198, !7}
!199 = distinct !{!199, !7}
!200 = distinct !{!200, !7, !8, !169}
!201 = distinct !{!201, !8, !7, !173}
!202 = distinct !{!202, !7, !8, !169}
!203 = distinct !{!203, !8, !7, !173}
!204 = distinct !{!204, !7, !8, !169}
!205 = distinct !{!205, !8, !7, !173}
!206 = distinct !{!206, !7, !8, !169}
!207 = distinct !{!207, !8, !7, !173}
!208 = !{!209, !211}
!209 = distinct !{!209, !210, !"_ZN12clpt_control6native9for_numba6at_endB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!210 = distinct !{!210, !"_ZN12clpt_control6native9for_numba6at_endB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!211 = distinct !{!211, !212, !"_ZN12clpt_control6native9for_numba4leapB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx: %retptr"}
!212 = distinct !{!212, !"_ZN12clpt_control6native9for_numba4leapB3v32B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx"}
!213 = !{!211}
!214 = !{!215, !211}
!215 = distinct !{!215, !216, !"_ZN12clpt_control6native9for_numba6at_endB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!216 = distinct !{!216, !"_ZN12clpt_control6native9for_numba6at_endB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!217 = !{!218, !211}
!218 = distinct !{!218, !219, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!219 = distinct !{!219, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!220 = !{!221, !211}
!221 = distinct !{!221, !222, !"_ZN12clpt_control6native9for_numba6at_endB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!222 = distinct !{!222, !"_ZN12clpt_control6native9for_numba6at_endB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!223 = !{!224, !211}
!224 = distinct !{!224, !225, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!225 = distinct !{!225, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!226 = distinct !{!226, !7, !8}
!227 = distinct !{!227, !7}

; sha256 a627d59fe05dfb8efb562bd537910a5ceae8079989c8a4ab13bd3a938b05056c

@.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727 = internal constant [76 x i8] c"\80\04\95A\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AValueError\94\93\94\8C\1Erange() arg 3 must not be zero\94\85\94N\87\94."
@.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727.sha1 = internal constant [20 x i8] c"\CA\8E\FB:r\D6\14\FE\87 2\CC\E3\AC2`\07\A3\07'"
@.const.picklebuf.ca8efb3a72d614fe872032cce3ac326007a30727 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727, i32 76, ptr @.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727.sha1, ptr null, i32 0 }

define dso_local noundef i32 @advance(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, ptr readnone %arg.tolerances.0, ptr readnone %arg.tolerances.1, i64 %arg.tolerances.2, i64 %arg.tolerances.3, ptr %arg.tolerances.4, i64 %arg.tolerances.5.0, i64 %arg.tolerances.6.0, ptr readnone %arg.runs.0.0, ptr readnone %arg.runs.0.1, i64 %arg.runs.0.2, i64 %arg.runs.0.3, ptr readonly %arg.runs.0.4, i64 %arg.runs.0.5.0, i64 %arg.runs.0.5.1, i64 %arg.runs.0.6.0, i64 %arg.runs.0.6.1, ptr readnone %arg.runs.1.0, ptr readnone %arg.runs.1.1, i64 %arg.runs.1.2, i64 %arg.runs.1.3, ptr readonly %arg.runs.1.4, i64 %arg.runs.1.5.0, i64 %arg.runs.1.5.1, i64 %arg.runs.1.6.0, i64 %arg.runs.1.6.1, ptr readnone %arg.runs.2.0, ptr readnone %arg.runs.2.1, i64 %arg.runs.2.2, i64 %arg.runs.2.3, ptr readonly %arg.runs.2.4, i64 %arg.runs.2.5.0, i64 %arg.runs.2.6.0, ptr readnone %arg.schedule.0.0, ptr readnone %arg.schedule.0.1, i64 %arg.schedule.0.2, i64 %arg.schedule.0.3, ptr readonly %arg.schedule.0.4, i64 %arg.schedule.0.5.0, i64 %arg.schedule.0.5.1, i64 %arg.schedule.0.6.0, i64 %arg.schedule.0.6.1, ptr readnone %arg.schedule.1.0, ptr readnone %arg.schedule.1.1, i64 %arg.schedule.1.2, i64 %arg.schedule.1.3, ptr readonly %arg.schedule.1.4, i64 %arg.schedule.1.5.0, i64 %arg.schedule.1.6.0, ptr readnone %arg.schedule.2.0, ptr readnone %arg.schedule.2.1, i64 %arg.schedule.2.2, i64 %arg.schedule.2.3, ptr readonly %arg.schedule.2.4, i64 %arg.schedule.2.5.0, i64 %arg.schedule.2.6.0, ptr readnone %arg.schedule.3.0, ptr readnone %arg.schedule.3.1, i64 %arg.schedule.3.2, i64 %arg.schedule.3.3, ptr readonly %arg.schedule.3.4, i64 %arg.schedule.3.5.0, i64 %arg.schedule.3.5.1, i64 %arg.schedule.3.5.2, i64 %arg.schedule.3.6.0, i64 %arg.schedule.3.6.1, i64 %arg.schedule.3.6.2, ptr readnone %arg.schedule.4.0, ptr readnone %arg.schedule.4.1, i64 %arg.schedule.4.2, i64 %arg.schedule.4.3, ptr readonly %arg.schedule.4.4, i64 %arg.schedule.4.5.0, i64 %arg.schedule.4.5.1, i64 %arg.schedule.4.6.0, i64 %arg.schedule.4.6.1, ptr readnone %arg.times.0, ptr readnone %arg.times.1, i64 %arg.times.2, i64 %arg.times.3, ptr readonly %arg.times.4, i64 %arg.times.5.0, i64 %arg.times.6.0, ptr readnone %arg.results.0.0, ptr readnone %arg.results.0.1, i64 %arg.results.0.2, i64 %arg.results.0.3, ptr %arg.results.0.4, i64 %arg.results.0.5.0, i64 %arg.results.0.5.1, i64 %arg.results.0.5.2, i64 %arg.results.0.6.0, i64 %arg.results.0.6.1, i64 %arg.results.0.6.2, ptr readnone %arg.results.1.0, ptr readnone %arg.results.1.1, i64 %arg.results.1.2, i64 %arg.results.1.3, ptr %arg.results.1.4, i64 %arg.results.1.5.0, i64 %arg.results.1.6.0, ptr readnone %arg.results.2.0, ptr readnone %arg.results.2.1, i64 %arg.results.2.2, i64 %arg.results.2.3, ptr %arg.results.2.4, i64 %arg.results.2.5.0, i64 %arg.results.2.6.0, ptr readnone %arg.results.3.0, ptr readnone %arg.results.3.1, i64 %arg.results.3.2, i64 %arg.results.3.3, ptr %arg.results.3.4, i64 %arg.results.3.5.0, i64 %arg.results.3.5.1, i64 %arg.results.3.6.0, i64 %arg.results.3.6.1, ptr readnone %arg.lane.0.0, ptr readnone %arg.lane.0.1, i64 %arg.lane.0.2, i64 %arg.lane.0.3, ptr %arg.lane.0.4, i64 %arg.lane.0.5.0, i64 %arg.lane.0.5.1, i64 %arg.lane.0.6.0, i64 %arg.lane.0.6.1, ptr readnone %arg.lane.1.0, ptr readnone %arg.lane.1.1, i64 %arg.lane.1.2, i64 %arg.lane.1.3, ptr %arg.lane.1.4, i64 %arg.lane.1.5.0, i64 %arg.lane.1.5.1, i64 %arg.lane.1.6.0, i64 %arg.lane.1.6.1, ptr readnone %arg.lane.2.0, ptr readnone %arg.lane.2.1, i64 %arg.lane.2.2, i64 %arg.lane.2.3, ptr %arg.lane.2.4, i64 %arg.lane.2.5.0, i64 %arg.lane.2.6.0, ptr readnone %arg.arrays.0.0, ptr readnone %arg.arrays.0.1, i64 %arg.arrays.0.2, i64 %arg.arrays.0.3, ptr %arg.arrays.0.4, i64 %arg.arrays.0.5.0, i64 %arg.arrays.0.6.0, ptr readnone %arg.arrays.1.0, ptr readnone %arg.arrays.1.1, i64 %arg.arrays.1.2, i64 %arg.arrays.1.3, ptr %arg.arrays.1.4, i64 %arg.arrays.1.5.0, i64 %arg.arrays.1.6.0, ptr readnone %arg.arrays.2.0, ptr readnone %arg.arrays.2.1, i64 %arg.arrays.2.2, i64 %arg.arrays.2.3, ptr %arg.arrays.2.4, i64 %arg.arrays.2.5.0, i64 %arg.arrays.2.6.0, ptr readnone %arg.arrays.3.0, ptr readnone %arg.arrays.3.1, i64 %arg.arrays.3.2, i64 %arg.arrays.3.3, ptr %arg.arrays.3.4, i64 %arg.arrays.3.5.0, i64 %arg.arrays.3.6.0, ptr readnone %arg.arrays.4.0, ptr readnone %arg.arrays.4.1, i64 %arg.arrays.4.2, i64 %arg.arrays.4.3, ptr %arg.arrays.4.4, i64 %arg.arrays.4.5.0, i64 %arg.arrays.4.6.0, ptr readnone %arg.linear.0.0, ptr readnone %arg.linear.0.1, i64 %arg.linear.0.2, i64 %arg.linear.0.3, ptr %arg.linear.0.4, i64 %arg.linear.0.5.0, i64 %arg.linear.0.6.0, ptr readnone %arg.linear.1.0, ptr readnone %arg.linear.1.1, i64 %arg.linear.1.2, i64 %arg.linear.1.3, ptr %arg.linear.1.4, i64 %arg.linear.1.5.0, i64 %arg.linear.1.6.0, i64 %arg.budget, i64 %arg.most, i64 %arg.guarded, i64 %arg.jumping, i64 %arg.held, i64 %arg.decided) local_unnamed_addr {
entry:
  %arg.linear.1.49433 = ptrtoint ptr %arg.linear.1.4 to i64
  %arg.arrays.0.49432 = ptrtoint ptr %arg.arrays.0.4 to i64
  %arg.runs.0.49322 = ptrtoint ptr %arg.runs.0.4 to i64
  %arg.results.0.49321 = ptrtoint ptr %arg.results.0.4 to i64
  %.382 = mul nsw i64 %arg.shape.1, %arg.shape.0
  %.490.idx = shl i64 %arg.lane.0.5.1, 6
  %.490 = getelementptr i8, ptr %arg.lane.0.4, i64 %.490.idx
  %.539 = icmp sgt i64 %arg.linear.0.5.0, 0
  %. = select i1 %.539, i64 8, i64 11
  %.274.i = icmp slt i64 %arg.shape.0, 1
  %storemerge = select i1 %.274.i, i64 0, i64 %arg.shape.0
  br i1 %.274.i, label %B202.endif, label %B50.if.i.lr.ph

B50.if.i.lr.ph:                                   ; preds = %entry
  %arg.results.0.49317 = ptrtoint ptr %arg.results.0.4 to i64
  %arg.runs.0.49318 = ptrtoint ptr %arg.runs.0.4 to i64
  %.373.i8806 = getelementptr i8, ptr %arg.lane.2.4, i64 8
  %.444.i = getelementptr i8, ptr %arg.lane.2.4, i64 16
  %0 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.idx.i = shl i64 %arg.lane.1.5.1, 4
  %1 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx.i
  %.6961563.not.i = icmp slt i64 %arg.shape.1, 1
  %.851.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.9661566.not.i = icmp slt i64 %arg.shape.2, 1
  %.11851569.not.i = icmp slt i64 %arg.schedule.2.5.0, 1
  %.1319.i = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1423.i.not = icmp eq i64 %arg.shape.0, 1
  %.163.i1572.not.i = icmp slt i64 %arg.shape.1, 1
  %2 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1546.i = shl i64 %arg.lane.0.5.1, 4
  %3 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1546.i
  %.idx1547.i = mul i64 %arg.lane.0.5.1, 24
  %4 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1547.i
  %.idx1548.i = shl i64 %arg.lane.0.5.1, 5
  %5 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1548.i
  %.idx1549.i = mul i64 %arg.lane.0.5.1, 176
  %6 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1549.i
  %.idx1550.i = mul i64 %arg.lane.0.5.1, 168
  %7 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1550.i
  %.15851575.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx1553.i = shl i64 %arg.lane.0.5.1, 4
  %8 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1553.i
  %9 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1554.i = mul i64 %arg.lane.0.5.1, 24
  %10 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1554.i
  %.idx1555.i = shl i64 %arg.lane.0.5.1, 5
  %11 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1555.i
  %.idx1556.i = mul i64 %arg.lane.0.5.1, 120
  %12 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1556.i
  %.idx1557.i = mul i64 %arg.lane.1.5.1, 24
  %13 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1557.i
  %.idx1558.i = mul i64 %arg.lane.0.5.1, 168
  %14 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1558.i
  %.idx1559.i = mul i64 %arg.lane.0.5.1, 200
  %15 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1559.i
  %.idx1560.i = mul i64 %arg.lane.0.5.1, 208
  %16 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1560.i
  %.idx1561.i = mul i64 %arg.lane.0.5.1, 152
  %17 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1561.i
  %.idx1562.i = mul i64 %arg.lane.0.5.1, 144
  %18 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1562.i
  %19 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %20 = shl i64 %19, 3
  %21 = shl i64 %arg.runs.0.5.1, 3
  %min.iters.check = icmp ult i64 %arg.shape.1, 8
  %n.vec = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n = icmp eq i64 %arg.shape.1, %n.vec
  br label %B50.if.i

B104.i:                                           ; preds = %B50.if.i
  %.420.i = add nsw i64 %active.3.i.09162, 1
  br label %B171.i

B116.i:                                           ; preds = %B50.if.i
  %.314.i = load i64, ptr %arg.lane.2.4, align 8, !noalias !0
  %.374.i = load i64, ptr %.373.i8806, align 8, !noalias !0
  %.375.i8807 = icmp slt i64 %.314.i, %.374.i
  br i1 %.375.i8807, label %B130.i, label %B316.i

B130.i:                                           ; preds = %B116.i
  %.385.i = add nsw i64 %.314.i, 1
  store i64 %.385.i, ptr %arg.lane.2.4, align 8, !noalias !0
  store i64 1, ptr %.444.i, align 8, !noalias !0
  %.502.i8809 = getelementptr i64, ptr %arg.lane.1.4, i64 %.260.i.09160
  store i64 %.314.i, ptr %.502.i8809, align 8, !noalias !0
  %.557.i = getelementptr i64, ptr %0, i64 %.260.i.09160
  store i64 0, ptr %.557.i, align 8, !noalias !0
  %.612.i = getelementptr i64, ptr %1, i64 %.260.i.09160
  store i64 1, ptr %.612.i, align 8, !noalias !0
  br i1 %.6961563.not.i, label %B316.i, label %B272.if.lr.ph.i

B272.if.lr.ph.i:                                  ; preds = %B130.i
  %.757.i = icmp slt i64 %.314.i, 0
  %.758.i = select i1 %.757.i, i64 %arg.runs.0.5.0, i64 0
  %.759.i = add i64 %.758.i, %.314.i
  %.779.i = mul i64 %.759.i, %arg.runs.0.5.1
  %22 = getelementptr double, ptr %arg.runs.0.4, i64 %.779.i
  %.822.i = select i1 %.757.i, i64 %arg.results.0.5.0, i64 0
  %.823.i = add i64 %.822.i, %.314.i
  %.853.i = mul i64 %.851.i, %.823.i
  %23 = getelementptr double, ptr %arg.results.0.4, i64 %.853.i
  br i1 %min.iters.check, label %B272.if.i.preheader, label %vector.memcheck

vector.memcheck:                                  ; preds = %B272.if.lr.ph.i
  %24 = mul i64 %20, %.823.i
  %25 = mul i64 %21, %.759.i
  %26 = add i64 %24, %arg.results.0.49317
  %27 = add i64 %25, %arg.runs.0.49318
  %28 = sub i64 %26, %27
  %diff.check = icmp ult i64 %28, 32
  br i1 %diff.check, label %B272.if.i.preheader, label %vector.body

vector.body:                                      ; preds = %vector.memcheck, %vector.body
  %index = phi i64 [ %index.next, %vector.body ], [ 0, %vector.memcheck ]
  %29 = getelementptr double, ptr %22, i64 %index
  %30 = getelementptr i8, ptr %29, i64 16
  %wide.load = load <2 x double>, ptr %29, align 8, !noalias !0
  %wide.load9319 = load <2 x double>, ptr %30, align 8, !noalias !0
  %31 = getelementptr double, ptr %23, i64 %index
  %32 = getelementptr i8, ptr %31, i64 16
  store <2 x double> %wide.load, ptr %31, align 8, !noalias !0
  store <2 x double> %wide.load9319, ptr %32, align 8, !noalias !0
  %index.next = add i64 %index, 4
  %33 = icmp eq i64 %index.next, %n.vec
  br i1 %33, label %middle.block, label %vector.body, !llvm.loop !6

middle.block:                                     ; preds = %vector.body
  br i1 %cmp.n, label %B316.i, label %B272.if.i.preheader

B272.if.i.preheader:                              ; preds = %vector.memcheck, %B272.if.lr.ph.i, %middle.block
  %.638.01564.i.ph = phi i64 [ 0, %vector.memcheck ], [ 0, %B272.if.lr.ph.i ], [ %n.vec, %middle.block ]
  br label %B272.if.i

B316.i:                                           ; preds = %B272.if.i, %middle.block, %B130.i, %B116.i
  %m.2.0.i = phi i64 [ 0, %B116.i ], [ %.314.i, %B130.i ], [ %.314.i, %middle.block ], [ %.314.i, %B272.if.i ]
  br i1 %.9661566.not.i, label %B390.i, label %B346.if.lr.ph.i

B346.if.lr.ph.i:                                  ; preds = %B316.i
  %.1027.i = icmp slt i64 %m.2.0.i, 0
  %.1028.i = select i1 %.1027.i, i64 %arg.runs.1.5.0, i64 0
  %.1029.i = add i64 %.1028.i, %m.2.0.i
  %.1049.i = mul i64 %.1029.i, %arg.runs.1.5.1
  %34 = getelementptr double, ptr %arg.runs.1.4, i64 %.1049.i
  %invariant.gep9480 = getelementptr double, ptr %arg.arrays.1.4, i64 %.260.i.09160
  br label %B346.if.i

B390.i:                                           ; preds = %B346.if.i, %B316.i
  br i1 %.11851569.not.i, label %B516.i, label %B446.if.lr.ph.i

B446.if.lr.ph.i:                                  ; preds = %B390.i
  %.1237.i = icmp slt i64 %m.2.0.i, 0
  %.1238.i = select i1 %.1237.i, i64 %arg.runs.2.5.0, i64 0
  %35 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i
  %.1252.i = getelementptr i64, ptr %35, i64 %.1238.i
  br label %B446.if.i

B516.i:                                           ; preds = %B446.if.i, %B390.i
  br i1 %.375.i8807, label %B574.i, label %B520.i

B520.i:                                           ; preds = %B516.i
  br i1 %.1423.i.not, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B532.i

B532.i:                                           ; preds = %B520.i
  br i1 %.163.i1572.not.i, label %B102.i.i, label %B46.if.i.i.preheader

B46.if.i.i.preheader:                             ; preds = %B532.i
  %invariant.gep9482 = getelementptr double, ptr %arg.arrays.0.4, i64 %.260.i.09160
  br label %B46.if.i.i

B102.i.i:                                         ; preds = %B46.if.i.i, %B532.i
  %.360.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.260.i.09160
  store double 0.000000e+00, ptr %.360.i.i, align 8, !noalias !9
  %.415.i.i = getelementptr double, ptr %2, i64 %.260.i.09160
  store double 5.000000e-01, ptr %.415.i.i, align 8, !noalias !9
  %.470.i.i = getelementptr double, ptr %3, i64 %.260.i.09160
  store double 1.000000e+00, ptr %.470.i.i, align 8, !noalias !9
  %.526.i.i = getelementptr double, ptr %4, i64 %.260.i.09160
  store double 0.000000e+00, ptr %.526.i.i, align 8, !noalias !9
  %.581.i.i = getelementptr double, ptr %5, i64 %.260.i.09160
  store double 0.000000e+00, ptr %.581.i.i, align 8, !noalias !9
  %.636.i.i = getelementptr double, ptr %6, i64 %.260.i.09160
  store double 0xFFF0000000000000, ptr %.636.i.i, align 8, !noalias !9
  %.693.i.i = getelementptr double, ptr %7, i64 %.260.i.09160
  store double 0x7FF0000000000000, ptr %.693.i.i, align 8, !noalias !9
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B46.if.i.i:                                       ; preds = %B46.if.i.i.preheader, %B46.if.i.i
  %.105.i.01573.i = phi i64 [ %.176.i.i, %B46.if.i.i ], [ 0, %B46.if.i.i.preheader ]
  %.176.i.i = add nsw i64 %.105.i.01573.i, 1
  %36 = getelementptr double, ptr %arg.runs.0.4, i64 %.105.i.01573.i
  %.255.i.i = load double, ptr %36, align 8, !noalias !9
  %.257.i.i = mul nsw i64 %.105.i.01573.i, %arg.shape.0
  %gep9483 = getelementptr double, ptr %invariant.gep9482, i64 %.257.i.i
  store double %.255.i.i, ptr %gep9483, align 8, !noalias !9
  %exitcond1580.not.i = icmp eq i64 %arg.shape.1, %.176.i.i
  br i1 %exitcond1580.not.i, label %B102.i.i, label %B46.if.i.i

B574.i:                                           ; preds = %B516.i
  br i1 %.15851575.not.i, label %B648.i, label %B604.if.lr.ph.i

B604.if.lr.ph.i:                                  ; preds = %B574.i
  %.1646.i = icmp slt i64 %m.2.0.i, 0
  %.1647.i = select i1 %.1646.i, i64 %arg.runs.0.5.0, i64 0
  %.1648.i = add i64 %.1647.i, %m.2.0.i
  %.1668.i = mul i64 %.1648.i, %arg.runs.0.5.1
  %37 = getelementptr double, ptr %arg.runs.0.4, i64 %.1668.i
  %invariant.gep9484 = getelementptr double, ptr %arg.arrays.0.4, i64 %.260.i.09160
  br label %B604.if.i

B648.i:                                           ; preds = %B604.if.i, %B574.i
  %.1748.i = load double, ptr %arg.times.4, align 8, !noalias !0
  %.1765.i = icmp slt i64 %m.2.0.i, 0
  %.1766.i = select i1 %.1765.i, i64 %arg.runs.2.5.0, i64 0
  %38 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i
  %.1780.i = getelementptr i64, ptr %38, i64 %.1766.i
  %.1781.i = load i64, ptr %.1780.i, align 8, !noalias !0
  %.1812.i = icmp slt i64 %.1781.i, 0
  %.1813.i = select i1 %.1812.i, i64 %arg.schedule.0.5.0, i64 0
  %.1814.i = add i64 %.1813.i, %.1781.i
  %.1834.i = mul i64 %.1814.i, %arg.schedule.0.5.1
  %.1838.i = getelementptr double, ptr %arg.schedule.0.4, i64 %.1834.i
  %.1839.i = load double, ptr %.1838.i, align 8, !noalias !0
  %.1895.i = getelementptr double, ptr %arg.lane.0.4, i64 %.260.i.09160
  store double %.1748.i, ptr %.1895.i, align 8, !noalias !0
  %.1950.i = getelementptr double, ptr %8, i64 %.260.i.09160
  store double %.1839.i, ptr %.1950.i, align 8, !noalias !0
  %.2005.i = getelementptr double, ptr %9, i64 %.260.i.09160
  store double 0.000000e+00, ptr %.2005.i, align 8, !noalias !0
  %.2064.i = getelementptr double, ptr %10, i64 %.260.i.09160
  store double 1.000000e+00, ptr %.2064.i, align 8, !noalias !0
  %.2119.i = getelementptr double, ptr %11, i64 %.260.i.09160
  store double 0.000000e+00, ptr %.2119.i, align 8, !noalias !0
  %.2175.i = getelementptr double, ptr %12, i64 %.260.i.09160
  store double 0xFFF0000000000000, ptr %.2175.i, align 8, !noalias !0
  %39 = getelementptr i64, ptr %13, i64 %.260.i.09160
  store i64 0, ptr %39, align 8, !noalias !0
  %.2287.i = getelementptr double, ptr %14, i64 %.260.i.09160
  store double 0x7FF0000000000000, ptr %.2287.i, align 8, !noalias !0
  %.2348.i = getelementptr double, ptr %15, i64 %.260.i.09160
  store double 0.000000e+00, ptr %.2348.i, align 8, !noalias !0
  %.2403.i = getelementptr double, ptr %16, i64 %.260.i.09160
  store double 0.000000e+00, ptr %.2403.i, align 8, !noalias !0
  %.2458.i = getelementptr double, ptr %17, i64 %.260.i.09160
  store double 0.000000e+00, ptr %.2458.i, align 8, !noalias !0
  %.2513.i = getelementptr double, ptr %18, i64 %.260.i.09160
  %.2514.i = load double, ptr %.2513.i, align 8, !noalias !0
  %.2516.i = fcmp ueq double %.2514.i, 0xFFF0000000000000
  br i1 %.2516.i, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B1060.i

B1060.i:                                          ; preds = %B648.i
  store double 0.000000e+00, ptr %.2513.i, align 8, !noalias !0
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B272.if.i:                                        ; preds = %B272.if.i.preheader, %B272.if.i
  %.638.01564.i = phi i64 [ %.709.i, %B272.if.i ], [ %.638.01564.i.ph, %B272.if.i.preheader ]
  %.709.i = add nsw i64 %.638.01564.i, 1
  %40 = getelementptr double, ptr %22, i64 %.638.01564.i
  %.784.i = load double, ptr %40, align 8, !noalias !0
  %41 = getelementptr double, ptr %23, i64 %.638.01564.i
  store double %.784.i, ptr %41, align 8, !noalias !0
  %exitcond.not.i = icmp eq i64 %.709.i, %arg.shape.1
  br i1 %exitcond.not.i, label %B316.i, label %B272.if.i, !llvm.loop !13

B346.if.i:                                        ; preds = %B346.if.i, %B346.if.lr.ph.i
  %.910.01567.i = phi i64 [ 0, %B346.if.lr.ph.i ], [ %.979.i, %B346.if.i ]
  %.979.i = add nsw i64 %.910.01567.i, 1
  %42 = getelementptr double, ptr %34, i64 %.910.01567.i
  %.1054.i = load double, ptr %42, align 8, !noalias !0
  %.1056.i = mul nsw i64 %.910.01567.i, %arg.shape.0
  %gep9481 = getelementptr double, ptr %invariant.gep9480, i64 %.1056.i
  store double %.1054.i, ptr %gep9481, align 8, !noalias !0
  %exitcond1578.not.i = icmp eq i64 %.979.i, %arg.shape.2
  br i1 %exitcond1578.not.i, label %B390.i, label %B346.if.i

B446.if.i:                                        ; preds = %B446.if.i, %B446.if.lr.ph.i
  %.1129.01570.i = phi i64 [ 0, %B446.if.lr.ph.i ], [ %.1198.i, %B446.if.i ]
  %.1198.i = add nsw i64 %.1129.01570.i, 1
  %.1253.i = load i64, ptr %.1252.i, align 8, !noalias !0
  %.1289.i = icmp slt i64 %.1253.i, 0
  %.1290.i = select i1 %.1289.i, i64 %arg.schedule.3.5.0, i64 0
  %.1291.i = add i64 %.1290.i, %.1253.i
  %.1321.i = mul i64 %.1319.i, %.1291.i
  %43 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1321.i
  %44 = getelementptr double, ptr %43, i64 %.1129.01570.i
  %.1328.i8808 = load double, ptr %44, align 8, !noalias !0
  %45 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1129.01570.i
  %.1358.i = load i64, ptr %45, align 8, !noalias !0
  %.1360.i = mul nsw i64 %.1358.i, %arg.shape.0
  %.1362.i = add nsw i64 %.1360.i, %.260.i.09160
  %.1376.i = icmp slt i64 %.1362.i, 0
  %.1377.i = select i1 %.1376.i, i64 %arg.arrays.1.5.0, i64 0
  %46 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1362.i
  %.1391.i = getelementptr double, ptr %46, i64 %.1377.i
  store double %.1328.i8808, ptr %.1391.i, align 8, !noalias !0
  %exitcond1579.not.i = icmp eq i64 %.1198.i, %arg.schedule.2.5.0
  br i1 %exitcond1579.not.i, label %B516.i, label %B446.if.i

B604.if.i:                                        ; preds = %B604.if.i, %B604.if.lr.ph.i
  %.1529.01576.i = phi i64 [ 0, %B604.if.lr.ph.i ], [ %.1598.i, %B604.if.i ]
  %.1598.i = add nsw i64 %.1529.01576.i, 1
  %47 = getelementptr double, ptr %37, i64 %.1529.01576.i
  %.1673.i = load double, ptr %47, align 8, !noalias !0
  %.1675.i = mul nsw i64 %.1529.01576.i, %arg.shape.0
  %gep9485 = getelementptr double, ptr %invariant.gep9484, i64 %.1675.i
  store double %.1673.i, ptr %gep9485, align 8, !noalias !0
  %exitcond1581.not.i = icmp eq i64 %.1598.i, %arg.shape.1
  br i1 %exitcond1581.not.i, label %B648.i, label %B604.if.i

_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B520.i, %B102.i.i, %B648.i, %B1060.i
  %storemerge1551.i = phi i64 [ 0, %B520.i ], [ 0, %B102.i.i ], [ 1, %B1060.i ], [ 1, %B648.i ]
  %.525.i = add nsw i64 %storemerge1551.i, %active.3.i.09162
  br label %B171.i

B171.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B104.i
  %active.4.i.1 = phi i64 [ %.420.i, %B104.i ], [ %.525.i, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.318.i = icmp sgt i64 %.263.i.09161, 1
  br i1 %.318.i, label %B50.if.i, label %B202.endif

B50.if.i:                                         ; preds = %B50.if.i.lr.ph, %B171.i
  %active.3.i.09162 = phi i64 [ 0, %B50.if.i.lr.ph ], [ %active.4.i.1, %B171.i ]
  %.263.i.09161 = phi i64 [ %storemerge, %B50.if.i.lr.ph ], [ %.327.i, %B171.i ]
  %.260.i.09160 = phi i64 [ 0, %B50.if.i.lr.ph ], [ %.331.i, %B171.i ]
  %.327.i = add nsw i64 %.263.i.09161, -1
  %.331.i = add nsw i64 %.260.i.09160, 1
  %48 = getelementptr i64, ptr %arg.lane.1.4, i64 %.260.i.09160
  %.414.i = load i64, ptr %48, align 8, !noalias !14
  %.415.i = icmp sgt i64 %.414.i, -1
  br i1 %.415.i, label %B104.i, label %B116.i

B276:                                             ; preds = %B276.preheader, %B4352
  %budget.3.0 = phi i64 [ %budget.4.2, %B4352 ], [ %arg.budget, %B276.preheader ]
  %active.6.0 = phi i64 [ %active.7.2, %B4352 ], [ %active.3.i.0.lcssa, %B276.preheader ]
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
  %.195.i104 = inttoptr i64 %.150.i to ptr
  tail call void %.195.i104(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !15
  br i1 %.274.i, label %B250.i, label %B118.if.i

B248.i:                                           ; preds = %B190.if.i, %B118.if.i
  %.279.i = icmp sgt i64 %.224.i.09168, 1
  br i1 %.279.i, label %B118.if.i, label %B250.i

B250.i:                                           ; preds = %B248.i, %B446
  %.614.i = load i64, ptr %.613.i, align 8, !noalias !15
  %.661.i = inttoptr i64 %.614.i to ptr
  tail call void %.661.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !15
  br label %B490

B118.if.i:                                        ; preds = %B446, %B248.i
  %.224.i.09168 = phi i64 [ %.288.i243, %B248.i ], [ %storemerge, %B446 ]
  %.221.i.09167 = phi i64 [ %.292.i245, %B248.i ], [ 0, %B446 ]
  %.288.i243 = add nsw i64 %.224.i.09168, -1
  %.292.i245 = add nsw i64 %.221.i.09167, 1
  %49 = getelementptr double, ptr %279, i64 %.221.i.09167
  %.374.i154 = load double, ptr %49, align 8, !noalias !15
  %.375.i = fcmp ule double %.374.i154, 5.000000e-01
  %brmerge9294 = select i1 %.375.i, i1 true, i1 %.457.i1839163
  br i1 %brmerge9294, label %B248.i, label %B190.if.i.preheader

B190.if.i.preheader:                              ; preds = %B118.if.i
  %invariant.gep9486 = getelementptr double, ptr %arg.arrays.4.4, i64 %.221.i.09167
  br label %B190.if.i

B190.if.i:                                        ; preds = %B190.if.i.preheader, %B190.if.i
  %.401.i.09164 = phi i64 [ %.470.i236, %B190.if.i ], [ 0, %B190.if.i.preheader ]
  %.470.i236 = add nsw i64 %.401.i.09164, 1
  %.496.i194 = mul nsw i64 %.401.i.09164, %arg.shape.0
  %gep9487 = getelementptr double, ptr %invariant.gep9486, i64 %.496.i194
  %.528.i215 = load double, ptr %gep9487, align 8, !noalias !15
  %.530.i = add nsw i64 %.401.i.09164, %arg.held
  %.532.i = mul nsw i64 %.530.i, %arg.shape.0
  %.534.i = add nsw i64 %.532.i, %.221.i.09167
  %.548.i = icmp slt i64 %.534.i, 0
  %.549.i223 = select i1 %.548.i, i64 %arg.arrays.1.5.0, i64 0
  %50 = getelementptr double, ptr %arg.arrays.1.4, i64 %.534.i
  %.563.i = getelementptr double, ptr %50, i64 %.549.i223
  store double %.528.i215, ptr %.563.i, align 8, !noalias !15
  %exitcond.not = icmp eq i64 %.470.i236, %arg.decided
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

B104.i435:                                        ; preds = %B62.if.i
  store double 0.000000e+00, ptr %.296.i432, align 8, !noalias !19
  %.414.i517 = getelementptr double, ptr %281, i64 %.144.i337.09170
  store double 0.000000e+00, ptr %.414.i517, align 8, !noalias !19
  %.469.i562 = getelementptr double, ptr %282, i64 %.144.i337.09170
  store double 0.000000e+00, ptr %.469.i562, align 8, !noalias !19
  %51 = getelementptr i64, ptr %arg.lane.1.4, i64 %.144.i337.09170
  %.525.i610 = load i64, ptr %51, align 8, !noalias !19
  %.552.i631 = icmp slt i64 %.525.i610, 0
  %.553.i632 = select i1 %.552.i631, i64 %arg.results.3.5.0, i64 0
  %.554.i633 = add i64 %.553.i632, %.525.i610
  %.574.i = mul i64 %.554.i633, %arg.results.3.5.1
  %52 = getelementptr i64, ptr %arg.results.3.4, i64 %.574.i
  %.578.i = getelementptr i8, ptr %52, i64 8
  %.579.i646 = load i64, ptr %.578.i, align 8, !noalias !19
  %.580.i = add nsw i64 %.579.i646, 2
  store i64 %.580.i, ptr %.578.i, align 8, !noalias !19
  %.687.i = load i64, ptr %51, align 8, !noalias !19
  %.714.i = icmp slt i64 %.687.i, 0
  %.715.i = select i1 %.714.i, i64 %arg.results.3.5.0, i64 0
  %.716.i = add i64 %.715.i, %.687.i
  %.736.i = mul i64 %.716.i, %arg.results.3.5.1
  %53 = getelementptr i64, ptr %arg.results.3.4, i64 %.736.i
  %.740.i = getelementptr i8, ptr %53, i64 16
  %.741.i = load i64, ptr %.740.i, align 8, !noalias !19
  %.742.i = add nsw i64 %.741.i, 1
  store i64 %.742.i, ptr %.740.i, align 8, !noalias !19
  %.848.i = getelementptr double, ptr %283, i64 %.144.i337.09170
  %.849.i = load double, ptr %.848.i, align 8, !noalias !19
  %.850.i = fcmp une double %.849.i, 0.000000e+00
  br i1 %.850.i, label %B358.i, label %B404.i

B358.i:                                           ; preds = %B104.i435
  %.84.i.i = load i64, ptr %51, align 8, !noalias !23
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

B404.i:                                           ; preds = %B80.i.i, %B358.i, %B46.i.i, %B104.i435
  br i1 %.1011.not, label %B540.i, label %B408.i

B408.i:                                           ; preds = %B404.i
  %54 = getelementptr double, ptr %arg.arrays.4.4, i64 %.144.i337.09170
  %.920.i = load double, ptr %54, align 8, !noalias !19
  %.922.i = fcmp olt double %.920.i, -1.000000e-09
  br i1 %.922.i, label %B444.i, label %B540.i

B444.i:                                           ; preds = %B408.i
  %.84.i63.i = load i64, ptr %51, align 8, !noalias !26
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
  %.1011.i = getelementptr double, ptr %arg.lane.0.4, i64 %.144.i337.09170
  %.1012.i = load double, ptr %.1011.i, align 8, !noalias !19
  %.1068.i = getelementptr double, ptr %284, i64 %.144.i337.09170
  store double %.1012.i, ptr %.1068.i, align 8, !noalias !19
  br label %B540.i

B540.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i, %B408.i, %B404.i, %B62.if.i
  %.202.i388 = icmp sgt i64 %.147.i.09171, 1
  br i1 %.202.i388, label %B62.if.i, label %B1000

B62.if.i:                                         ; preds = %B652, %B540.i
  %.147.i.09171 = phi i64 [ %.211.i728, %B540.i ], [ %storemerge, %B652 ]
  %.144.i337.09170 = phi i64 [ %.215.i731, %B540.i ], [ 0, %B652 ]
  %.211.i728 = add nsw i64 %.147.i.09171, -1
  %.215.i731 = add nsw i64 %.144.i337.09170, 1
  %.296.i432 = getelementptr double, ptr %280, i64 %.144.i337.09170
  %.297.i433 = load double, ptr %.296.i432, align 8, !noalias !19
  %.298.i434 = fcmp ogt double %.297.i433, 5.000000e-01
  br i1 %.298.i434, label %B104.i435, label %B540.i

B1000:                                            ; preds = %B540.i, %B652, %B428
  br i1 %.539, label %B1004, label %B1244.critedge

B1004:                                            ; preds = %B1000
  %.1511 = load i64, ptr %.1510, align 8
  %.1526 = icmp slt i64 %.1511, %arg.times.5.0
  br i1 %.1526, label %B1072, label %B1110

B1072:                                            ; preds = %B1004
  %.1542 = icmp slt i64 %.1511, 0
  %.1543 = select i1 %.1542, i64 %arg.times.5.0, i64 0
  %55 = getelementptr double, ptr %arg.times.4, i64 %.1511
  %.1557 = getelementptr double, ptr %55, i64 %.1543
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
  %.154.i.i8820 = load i64, ptr %.153.i.i8819, align 8, !noalias !30
  %.184.i.i8822 = load i64, ptr %.183.i.i8821, align 8, !noalias !30
  br i1 %.234.i.i, label %B0.else.endif.if.i.i, label %B0.else.endif.endif.i.i, !prof !36

B412.i.i:                                         ; preds = %B330.if.i.i, %middle.block9467, %B0.endif.endif.endif.endif.endif.i.i
  %.1311.i.i = add nsw i64 %.486.i.i, -1
  %.1349.i.i = icmp slt i64 %.477.i.i, 2
  %storemerge2355.i = select i1 %.1349.i.i, i64 0, i64 %.1311.i.i
  %.1392.i2403.i = icmp sgt i64 %storemerge2355.i, 0
  br i1 %.1392.i2403.i, label %B478.i.lr.ph.i, label %B164.i

B478.i.lr.ph.i:                                   ; preds = %B412.i.i
  %.1338.i.12406.i = add nsw i64 %storemerge2355.i, -1
  %.952.i.i.i = select i1 %.1556.i2382.not.i, i64 %.311.i.i, i64 0
  %56 = getelementptr i64, ptr %.327.i.i, i64 %arg.shape.1
  %.966.i.i.i = getelementptr i64, ptr %56, i64 %.952.i.i.i
  %57 = shl i64 %spec.select.i, 3
  %58 = add i64 %57, %arg.linear.1.49433
  %59 = sub i64 %394, %58
  %diff.check9434 = icmp ult i64 %59, 32
  %or.cond9471 = select i1 %min.iters.check9436, i1 true, i1 %diff.check9434
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
  br i1 %or.cond9471, label %B544.if.i.i.preheader9476, label %vector.ph9437

vector.ph9437:                                    ; preds = %B544.if.i.i.preheader
  %broadcast.splatinsert9440 = insertelement <2 x i64> poison, i64 %.1382.i.sroa.0.02409.i, i64 0
  %broadcast.splat9441 = shufflevector <2 x i64> %broadcast.splatinsert9440, <2 x i64> poison, <2 x i32> zeroinitializer
  br label %vector.body9442

vector.body9442:                                  ; preds = %vector.body9442, %vector.ph9437
  %index9443 = phi i64 [ 0, %vector.ph9437 ], [ %index.next9446, %vector.body9442 ]
  %60 = getelementptr i64, ptr %.327.i.i, i64 %index9443
  %61 = getelementptr i8, ptr %60, i64 16
  %wide.load9444 = load <2 x i64>, ptr %60, align 8, !noalias !30
  %wide.load9445 = load <2 x i64>, ptr %61, align 8, !noalias !30
  %62 = icmp eq <2 x i64> %wide.load9444, %broadcast.splat9441
  %63 = icmp eq <2 x i64> %wide.load9445, %broadcast.splat9441
  %64 = select <2 x i1> %62, <2 x double> splat (double 1.000000e+00), <2 x double> zeroinitializer
  %65 = select <2 x i1> %63, <2 x double> splat (double 1.000000e+00), <2 x double> zeroinitializer
  %66 = getelementptr double, ptr %invariant.gep, i64 %index9443
  %67 = getelementptr i8, ptr %66, i64 16
  store <2 x double> %64, ptr %66, align 8, !noalias !30
  store <2 x double> %65, ptr %67, align 8, !noalias !30
  %index.next9446 = add i64 %index9443, 4
  %68 = icmp eq i64 %index.next9446, %n.vec9439
  br i1 %68, label %middle.block9447, label %vector.body9442, !llvm.loop !37

middle.block9447:                                 ; preds = %vector.body9442
  br i1 %cmp.n9448, label %B610.i.i, label %B544.if.i.i.preheader9476

B544.if.i.i.preheader9476:                        ; preds = %B544.if.i.i.preheader, %middle.block9447
  %.1503.i.02384.i.ph = phi i64 [ %storemerge2359.i, %B544.if.i.i.preheader ], [ %397, %middle.block9447 ]
  %.1500.i.02383.i.ph = phi i64 [ 0, %B544.if.i.i.preheader ], [ %n.vec9439, %middle.block9447 ]
  br label %B544.if.i.i

B610.i.i:                                         ; preds = %B544.if.i.i, %middle.block9447, %B508.i.i
  %.1717.i.i = load i64, ptr %.1716.i.i, align 8, !noalias !30
  %.1833.i.i = inttoptr i64 %.1717.i.i to ptr
  tail call void %.1833.i.i(ptr %arg.lane.0.4, ptr %.1807.i.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1832.i.i), !noalias !30
  %.1849.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, 0
  %.1850.i.i = select i1 %.1849.i.i, i64 %.486.i.i, i64 0
  %69 = getelementptr i64, ptr %.502.i.i, i64 %.1382.i.sroa.0.02409.i
  %.1864.i.i = getelementptr i64, ptr %69, i64 %.1850.i.i
  %.1865.i.i = load i64, ptr %.1864.i.i, align 8, !noalias !30
  %.1881.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, -1
  %.1882.i.i = select i1 %.1881.i.i, i64 %.486.i.i, i64 0
  %70 = getelementptr i8, ptr %69, i64 8
  %.1896.i.i = getelementptr i64, ptr %70, i64 %.1882.i.i
  %.1897.i.i = load i64, ptr %.1896.i.i, align 8, !noalias !30
  %.1934.i.i = sub i64 %.1897.i.i, %.1865.i.i
  %.1980.i2385.not.i = icmp slt i64 %.1934.i.i, 1
  br i1 %.1980.i2385.not.i, label %B914.i.i, label %B794.if.i.i

B802.i.i:                                         ; preds = %B794.if.i.i
  %.2047.i.i = icmp slt i64 %.1921.i.02386.i, 0
  %.2048.i.i = select i1 %.2047.i.i, i64 %.665.i.i, i64 0
  %71 = getelementptr i64, ptr %.681.i.i, i64 %.1921.i.02386.i
  %.2062.i.i = getelementptr i64, ptr %71, i64 %.2048.i.i
  %.2063.i.i = load i64, ptr %.2062.i.i, align 8, !noalias !30
  %.2064.i.i = add nsw i64 %.2063.i.i, %.1789.i.i
  %.2078.i.i = icmp slt i64 %.2064.i.i, 0
  %.2079.i.i = select i1 %.2078.i.i, i64 %arg.arrays.0.5.0, i64 0
  %72 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2064.i.i
  %.2093.i.i = getelementptr double, ptr %72, i64 %.2079.i.i
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
  br i1 %or.cond9472, label %B84.if.i.i.i.preheader9475, label %vector.ph9418

vector.ph9418:                                    ; preds = %B84.if.i.i.i.preheader
  %broadcast.splatinsert9421 = insertelement <2 x double> poison, double %.187.i.i.i, i64 0
  %broadcast.splat9422 = shufflevector <2 x double> %broadcast.splatinsert9421, <2 x double> poison, <2 x i32> zeroinitializer
  br label %vector.body9423

vector.body9423:                                  ; preds = %vector.body9423, %vector.ph9418
  %index9424 = phi i64 [ 0, %vector.ph9418 ], [ %index.next9427, %vector.body9423 ]
  %73 = getelementptr double, ptr %arg.arrays.0.4, i64 %index9424
  %74 = getelementptr i8, ptr %73, i64 16
  %wide.load9425 = load <2 x double>, ptr %73, align 8, !noalias !38
  %wide.load9426 = load <2 x double>, ptr %74, align 8, !noalias !38
  %75 = tail call <2 x double> @llvm.fabs.v2f64(<2 x double> %wide.load9425)
  %76 = tail call <2 x double> @llvm.fabs.v2f64(<2 x double> %wide.load9426)
  %77 = fcmp ogt <2 x double> %broadcast.splat9422, %75
  %78 = fcmp ogt <2 x double> %broadcast.splat9422, %76
  %79 = select <2 x i1> %77, <2 x double> %broadcast.splat9422, <2 x double> %75
  %80 = select <2 x i1> %78, <2 x double> %broadcast.splat9422, <2 x double> %76
  %81 = fcmp ogt <2 x double> %79, zeroinitializer
  %82 = fcmp ogt <2 x double> %80, zeroinitializer
  %83 = fmul <2 x double> %79, splat (double 1.200000e-05)
  %84 = fmul <2 x double> %80, splat (double 1.200000e-05)
  %85 = select <2 x i1> %81, <2 x double> %83, <2 x double> splat (double 1.200000e-05)
  %86 = select <2 x i1> %82, <2 x double> %84, <2 x double> splat (double 1.200000e-05)
  %87 = getelementptr i8, ptr %73, i64 %.idx2424.i
  %88 = getelementptr i8, ptr %87, i64 16
  store <2 x double> %85, ptr %87, align 8, !noalias !38
  store <2 x double> %86, ptr %88, align 8, !noalias !38
  %index.next9427 = add i64 %index9424, 4
  %89 = icmp eq i64 %index.next9427, %n.vec9420
  br i1 %89, label %middle.block9428, label %vector.body9423, !llvm.loop !42

middle.block9428:                                 ; preds = %vector.body9423
  br i1 %cmp.n9429, label %B230.i.i.i, label %B84.if.i.i.i.preheader9475

B84.if.i.i.i.preheader9475:                       ; preds = %B84.if.i.i.i.preheader, %middle.block9428
  %.215.i.i.02391.i.ph = phi i64 [ 0, %B84.if.i.i.i.preheader ], [ %n.vec9420, %middle.block9428 ]
  br label %B84.if.i.i.i

B230.i.i.i:                                       ; preds = %B84.if.i.i.i, %middle.block9428
  %.500.i.i.i = load double, ptr %.499.i.i.i, align 8, !noalias !38
  %.501.i.i.i = fmul double %.500.i.i.i, 1.000000e-03
  store double %.501.i.i.i, ptr %.534.i.i.i, align 8, !noalias !38
  br label %B370.if.i.i.i

B398.i.i.i:                                       ; preds = %B370.if.i.i.i
  %gep9173 = getelementptr double, ptr %invariant.gep9172, i64 %.687.i.i.02393.i
  %.851.i.i.i = load double, ptr %gep9173, align 8, !noalias !38
  %.853.i.i.i = fmul double %.851.i.i.i, 5.000000e-01
  br label %B444.i.i.i

B444.i.i.i:                                       ; preds = %B370.if.i.i.i, %B398.i.i.i
  %"$phi444.2.2.i.i.2.i" = phi double [ %.853.i.i.i, %B398.i.i.i ], [ 0.000000e+00, %B370.if.i.i.i ]
  %90 = getelementptr double, ptr %arg.arrays.0.4, i64 %.687.i.i.02393.i
  %.894.i.i.i = load double, ptr %90, align 8, !noalias !38
  %.895.i.i.i = fadd double %"$phi444.2.2.i.i.2.i", %.894.i.i.i
  %91 = getelementptr double, ptr %90, i64 %.897.i.i.i
  store double %.895.i.i.i, ptr %91, align 8, !noalias !38
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
  %92 = getelementptr double, ptr %100, i64 %arg.shape.1
  %.1731.i.i.i = load double, ptr %92, align 8, !noalias !38
  %.1796.i.i.i = fsub double %.1666.i.i.i, %.1731.i.i.i
  %.1801.i.i.i = fmul double %.1796.i.i.i, 2.000000e+00
  br label %B1148.i.i.i

B370.if.i.i.1.i:                                  ; preds = %B568.i.i.i, %B444.i.i.1.i
  %.687.i.i.02393.1.i = phi i64 [ %.756.i.i.1.i, %B444.i.i.1.i ], [ 0, %B568.i.i.i ]
  %.756.i.i.1.i = add nsw i64 %.687.i.i.02393.1.i, 1
  %93 = getelementptr i64, ptr %.327.i.i, i64 %.687.i.i.02393.1.i
  %.814.i.i.1.i = load i64, ptr %93, align 8, !noalias !38
  %.816.i.i.1.i = icmp eq i64 %.814.i.i.1.i, %.1382.i.sroa.0.02409.i
  br i1 %.816.i.i.1.i, label %B398.i.i.1.i, label %B444.i.i.1.i

B398.i.i.1.i:                                     ; preds = %B370.if.i.i.1.i
  %gep9175 = getelementptr double, ptr %invariant.gep9174, i64 %.687.i.i.02393.1.i
  %.851.i.i.1.i = load double, ptr %gep9175, align 8, !noalias !38
  %.853.i.i.1.i = fmul double %.851.i.i.1.i, -5.000000e-01
  br label %B444.i.i.1.i

B444.i.i.1.i:                                     ; preds = %B398.i.i.1.i, %B370.if.i.i.1.i
  %"$phi444.2.2.i.i.2.1.i" = phi double [ %.853.i.i.1.i, %B398.i.i.1.i ], [ 0.000000e+00, %B370.if.i.i.1.i ]
  %94 = getelementptr double, ptr %arg.arrays.0.4, i64 %.687.i.i.02393.1.i
  %.894.i.i.1.i = load double, ptr %94, align 8, !noalias !38
  %.895.i.i.1.i = fadd double %"$phi444.2.2.i.i.2.1.i", %.894.i.i.1.i
  %95 = getelementptr double, ptr %94, i64 %.897.i.i.i
  store double %.895.i.i.1.i, ptr %95, align 8, !noalias !38
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
  store double %storemerge2363.i, ptr %102, align 8, !noalias !38
  %exitcond2419.not.i = icmp eq i64 %arg.shape.1, %.1540.i.i.i
  br i1 %exitcond2419.not.i, label %B960.i.i, label %B902.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B84.if.i.i.i.preheader9475, %B84.if.i.i.i
  %.215.i.i.02391.i = phi i64 [ %.286.i.i.i, %B84.if.i.i.i ], [ %.215.i.i.02391.i.ph, %B84.if.i.i.i.preheader9475 ]
  %.286.i.i.i = add nsw i64 %.215.i.i.02391.i, 1
  %96 = getelementptr double, ptr %arg.arrays.0.4, i64 %.215.i.i.02391.i
  %.344.i.i.i = load double, ptr %96, align 8, !noalias !38
  %.345.i.i.i = tail call double @llvm.fabs.f64(double %.344.i.i.i)
  %.10.i.i.i.i = fcmp ogt double %.187.i.i.i, %.345.i.i.i
  %.11.i.i.i.i = select i1 %.10.i.i.i.i, double %.187.i.i.i, double %.345.i.i.i
  %.380.i.i.i = fcmp ogt double %.11.i.i.i.i, 0.000000e+00
  %97 = fmul double %.11.i.i.i.i, 1.200000e-05
  %"$phi194.2.2.i.i.1.i" = select i1 %.380.i.i.i, double %97, double 1.200000e-05
  %98 = getelementptr i8, ptr %96, i64 %.idx2424.i
  store double %"$phi194.2.2.i.i.1.i", ptr %98, align 8, !noalias !38
  %exitcond2416.not.i = icmp eq i64 %arg.shape.1, %.286.i.i.i
  br i1 %exitcond2416.not.i, label %B230.i.i.i, label %B84.if.i.i.i, !llvm.loop !43

B370.if.i.i.i:                                    ; preds = %B230.i.i.i, %B444.i.i.i
  %.687.i.i.02393.i = phi i64 [ %.756.i.i.i, %B444.i.i.i ], [ 0, %B230.i.i.i ]
  %.756.i.i.i = add nsw i64 %.687.i.i.02393.i, 1
  %99 = getelementptr i64, ptr %.327.i.i, i64 %.687.i.i.02393.i
  %.814.i.i.i = load i64, ptr %99, align 8, !noalias !38
  %.816.i.i.i = icmp eq i64 %.814.i.i.i, %.1382.i.sroa.0.02409.i
  br i1 %.816.i.i.i, label %B398.i.i.i, label %B444.i.i.i

B902.if.i.i.i:                                    ; preds = %B568.i.i.1.i, %B1148.i.i.i
  %.1471.i.i.02398.i = phi i64 [ %.1540.i.i.i, %B1148.i.i.i ], [ 0, %B568.i.i.1.i ]
  %.1540.i.i.i = add nsw i64 %.1471.i.i.02398.i, 1
  %100 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1471.i.i.02398.i
  %.1598.i.i.i = load double, ptr %100, align 8, !noalias !38
  %101 = getelementptr i8, ptr %100, i64 %.1807.i.idx.i
  store double %.1598.i.i.i, ptr %101, align 8, !noalias !38
  %102 = getelementptr i8, ptr %100, i64 %.1279.i.i.idx.i
  %.1666.i.i.i = load double, ptr %102, align 8, !noalias !38
  %103 = getelementptr double, ptr %arg.arrays.4.4, i64 %.1471.i.i.02398.i
  %.1697.i.i.i = load double, ptr %103, align 8, !noalias !38
  %.1743.i.i.i = fsub double %.1697.i.i.i, %.1697.i.i.i
  %.1744.i.i.i = fcmp oeq double %.1743.i.i.i, 0.000000e+00
  br i1 %.1744.i.i.i, label %B1060.i.i.i, label %B1100.i.i.i

B960.i.i:                                         ; preds = %B1148.i.i.i, %B568.i.i.1.i, %B914.i.i
  %.2256.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, 0
  %.2257.i.i = select i1 %.2256.i.i, i64 %.486.i.i, i64 0
  %104 = getelementptr i64, ptr %.502.i.i, i64 %.1382.i.sroa.0.02409.i
  %.2271.i.i = getelementptr i64, ptr %104, i64 %.2257.i.i
  %.2272.i.i = load i64, ptr %.2271.i.i, align 8, !noalias !30
  %.2290.i.i = icmp slt i64 %.1382.i.sroa.0.02409.i, -1
  %.2291.i.i = select i1 %.2290.i.i, i64 %.486.i.i, i64 0
  %105 = getelementptr i8, ptr %104, i64 8
  %.2305.i.i = getelementptr i64, ptr %105, i64 %.2291.i.i
  %.2306.i.i = load i64, ptr %.2305.i.i, align 8, !noalias !30
  %.2343.i.i = sub i64 %.2306.i.i, %.2272.i.i
  %.2386.i2400.not.i = icmp slt i64 %.2343.i.i, 1
  br i1 %.2386.i2400.not.i, label %B474.i.loopexit.i, label %B1022.if.i.i

B1080.i.i:                                        ; preds = %B1022.if.i.i
  %.2519.i.i = select i1 %.2443.i.i, i64 %.836.i.i, i64 0
  %106 = getelementptr i64, ptr %.852.i.i, i64 %.2330.i.02401.i
  %.2533.i.i = getelementptr i64, ptr %106, i64 %.2519.i.i
  %.2534.i.i = load i64, ptr %.2533.i.i, align 8, !noalias !30
  %.2535.i.i = add nsw i64 %.2534.i.i, %.503.i.i.i
  %.2549.i.i = icmp slt i64 %.2535.i.i, 0
  %.2550.i.i = select i1 %.2549.i.i, i64 %arg.arrays.0.5.0, i64 0
  %107 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2535.i.i
  %.2564.i.i = getelementptr double, ptr %107, i64 %.2550.i.i
  %.2565.i.i = load double, ptr %.2564.i.i, align 8, !noalias !30
  %.2570.i.i = fdiv double %.2490.i.i, %.2565.i.i
  %.2578.i.i = fsub double %.2570.i.i, %.2570.i.i
  %.2579.i.i = fcmp oeq double %.2578.i.i, 0.000000e+00
  %.2570.i..i = select i1 %.2579.i.i, double %.2570.i.i, double 0.000000e+00
  br label %B1162.i.i

B1162.i.i:                                        ; preds = %B1022.if.i.i, %B1080.i.i
  %slope.3.i.2.i = phi double [ %.2490.i.i, %B1022.if.i.i ], [ %.2570.i..i, %B1080.i.i ]
  %.2616.i.i = select i1 %.2443.i.i, i64 %.836.i.i, i64 0
  %108 = getelementptr i64, ptr %.852.i.i, i64 %.2330.i.02401.i
  %.2630.i.i = getelementptr i64, ptr %108, i64 %.2616.i.i
  %.2631.i.i = load i64, ptr %.2630.i.i, align 8, !noalias !30
  %.2633.i.i = icmp eq i64 %.2631.i.i, %arg.shape.1
  br i1 %.2633.i.i, label %B1186.i.i, label %B1232.i.i

B1186.i.i:                                        ; preds = %B1162.i.i
  %.2670.i.i = add nsw i64 %.2459.i.i, %.2636.i.i
  %.2685.i.i = icmp slt i64 %.2670.i.i, 0
  %.2686.i.i = select i1 %.2685.i.i, i64 %arg.arrays.0.5.0, i64 0
  %109 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2670.i.i
  %.2700.i.i = getelementptr double, ptr %109, i64 %.2686.i.i
  store double %slope.3.i.2.i, ptr %.2700.i.i, align 8, !noalias !30
  br label %B1261.i.i

B1232.i.i:                                        ; preds = %B1162.i.i
  %.2720.i.i = select i1 %.2443.i.i, i64 %.1014.i.i, i64 0
  %110 = getelementptr i64, ptr %.1030.i.i, i64 %.2330.i.02401.i
  %.2734.i.i = getelementptr i64, ptr %110, i64 %.2720.i.i
  %.2735.i.i = load i64, ptr %.2734.i.i, align 8, !noalias !30
  %.2752.i.i = icmp slt i64 %.2735.i.i, 0
  %.2753.i.i = select i1 %.2752.i.i, i64 %arg.linear.0.5.0, i64 0
  %111 = getelementptr double, ptr %arg.linear.0.4, i64 %.2735.i.i
  %.2767.i.i = getelementptr double, ptr %111, i64 %.2753.i.i
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
  %.362.i.i = add nsw i64 %.154.i.i8820, %.187.i.i
  br i1 %.409.i.i, label %B0.endif.else.endif.if.i.i, label %B0.endif.else.endif.endif.i.i, !prof !36

B0.else.endif.if.i.i:                             ; preds = %B124.i
  br label %B0.else.endif.endif.i.i

B0.else.endif.endif.i.i:                          ; preds = %B0.else.endif.if.i.i, %B124.i
  %simplifycfg.merge.i = phi i64 [ %arg.linear.1.5.0, %B0.else.endif.if.i.i ], [ 0, %B124.i ]
  %spec.select.i = select i1 %285, i64 %simplifycfg.merge.i, i64 %.226.i.i, !prof !44
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
  %.540.i.i = add i64 %.539.i.i, %.154.i.i8820
  %.541.i.i = add nsw i64 %.540.i.i, %.184.i.i8822
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
  %spec.select2366.i = select i1 %286, i64 %simplifycfg.merge2.i, i64 %.243.i.i, !prof !44
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
  %.711.i.i = shl nsw i64 %.184.i.i8822, 1
  %.712.i.i = add nsw i64 %.711.i.i, %.540.i.i
  %.759.i.i = icmp sge i64 %.597.i.i, %arg.linear.1.5.0
  br i1 %.759.i.i, label %B0.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.else.endif.endif.i.i, !prof !36

B0.endif.endif.else.endif.if.i.i:                 ; preds = %B0.endif.endif.i.i
  br label %B0.endif.endif.else.endif.endif.i.i

B0.endif.endif.else.endif.endif.i.i:              ; preds = %B0.endif.endif.else.endif.if.i.i, %B0.endif.endif.i.i
  %simplifycfg.merge4.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.i.i ]
  %112 = or i1 %.583.i.i, %.588.i.i
  %spec.select2367.i = select i1 %112, i64 %simplifycfg.merge4.i, i64 %.580.i.i, !prof !44
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
  %.889.i.i = mul nsw i64 %.184.i.i8822, 3
  %.890.i.i = add nsw i64 %.889.i.i, %.540.i.i
  %.937.i.i = icmp sge i64 %.768.i.i, %arg.linear.1.5.0
  br i1 %.937.i.i, label %B0.endif.endif.endif.endif.else.endif.if.i.i, label %B0.endif.endif.endif.endif.else.endif.endif.i.i, !prof !36

B0.endif.endif.endif.else.endif.if.i.i:           ; preds = %B0.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.else.endif.endif.i.i:        ; preds = %B0.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.i.i
  %simplifycfg.merge6.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.i.i ]
  %113 = or i1 %.600.i.i, %.759.i.i
  %spec.select2368.i = select i1 %113, i64 %simplifycfg.merge6.i, i64 %.597.i.i, !prof !44
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
  %brmerge9534 = select i1 %min.iters.check9458, i1 true, i1 %conflict.rdx9456
  br i1 %brmerge9534, label %B330.if.i.i.preheader9477, label %vector.body9462

vector.body9462:                                  ; preds = %B330.if.i.i.preheader, %vector.body9462
  %index9463 = phi i64 [ %index.next9466, %vector.body9462 ], [ 0, %B330.if.i.i.preheader ]
  %114 = getelementptr double, ptr %arg.arrays.0.4, i64 %index9463
  %115 = getelementptr i8, ptr %114, i64 16
  %wide.load9464 = load <2 x double>, ptr %114, align 8, !noalias !30
  %wide.load9465 = load <2 x double>, ptr %115, align 8, !noalias !30
  %116 = getelementptr i8, ptr %114, i64 %.idx2421.i
  %117 = getelementptr i8, ptr %116, i64 16
  store <2 x double> %wide.load9464, ptr %116, align 8, !noalias !30
  store <2 x double> %wide.load9465, ptr %117, align 8, !noalias !30
  %118 = getelementptr i8, ptr %114, i64 %.idx2422.i
  %119 = getelementptr i8, ptr %118, i64 16
  store <2 x double> zeroinitializer, ptr %118, align 8, !noalias !30
  store <2 x double> zeroinitializer, ptr %119, align 8, !noalias !30
  %index.next9466 = add i64 %index9463, 4
  %120 = icmp eq i64 %index.next9466, %n.vec9461
  br i1 %120, label %middle.block9467, label %vector.body9462, !llvm.loop !45

middle.block9467:                                 ; preds = %vector.body9462
  br i1 %cmp.n9468, label %B412.i.i, label %B330.if.i.i.preheader9477

B330.if.i.i.preheader9477:                        ; preds = %B330.if.i.i.preheader, %middle.block9467
  %.1104.i.02380.i.ph = phi i64 [ %n.vec9461, %middle.block9467 ], [ 0, %B330.if.i.i.preheader ]
  br label %B330.if.i.i

B0.endif.endif.endif.endif.else.endif.if.i.i:     ; preds = %B0.endif.endif.endif.endif.i.i
  br label %B0.endif.endif.endif.endif.else.endif.endif.i.i

B0.endif.endif.endif.endif.else.endif.endif.i.i:  ; preds = %B0.endif.endif.endif.endif.else.endif.if.i.i, %B0.endif.endif.endif.endif.i.i
  %simplifycfg.merge8.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.endif.endif.else.endif.if.i.i ], [ 0, %B0.endif.endif.endif.endif.i.i ]
  %121 = or i1 %.771.i.i, %.937.i.i
  %spec.select2369.i = select i1 %121, i64 %simplifycfg.merge8.i, i64 %.768.i.i, !prof !44
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

B330.if.i.i:                                      ; preds = %B330.if.i.i.preheader9477, %B330.if.i.i
  %.1104.i.02380.i = phi i64 [ %.1175.i.i, %B330.if.i.i ], [ %.1104.i.02380.i.ph, %B330.if.i.i.preheader9477 ]
  %.1175.i.i = add nsw i64 %.1104.i.02380.i, 1
  %122 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1104.i.02380.i
  %.1229.i.i = load double, ptr %122, align 8, !noalias !30
  %123 = getelementptr i8, ptr %122, i64 %.idx2421.i
  store double %.1229.i.i, ptr %123, align 8, !noalias !30
  %124 = getelementptr i8, ptr %122, i64 %.idx2422.i
  store double 0.000000e+00, ptr %124, align 8, !noalias !30
  %exitcond.not.i8823 = icmp eq i64 %arg.shape.1, %.1175.i.i
  br i1 %exitcond.not.i8823, label %B412.i.i, label %B330.if.i.i, !llvm.loop !46

B544.if.i.i:                                      ; preds = %B544.if.i.i.preheader9476, %B544.if.i.i
  %.1503.i.02384.i = phi i64 [ %.1565.i.i, %B544.if.i.i ], [ %.1503.i.02384.i.ph, %B544.if.i.i.preheader9476 ]
  %.1500.i.02383.i = phi i64 [ %.1569.i.i, %B544.if.i.i ], [ %.1500.i.02383.i.ph, %B544.if.i.i.preheader9476 ]
  %.1565.i.i = add nsw i64 %.1503.i.02384.i, -1
  %.1569.i.i = add nsw i64 %.1500.i.02383.i, 1
  %125 = getelementptr i64, ptr %.327.i.i, i64 %.1500.i.02383.i
  %.1627.i.i = load i64, ptr %125, align 8, !noalias !30
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
  %126 = getelementptr i64, ptr %.681.i.i, i64 %.2330.i.02401.i
  %.2458.i.i = getelementptr i64, ptr %126, i64 %.2444.i.i
  %.2459.i.i = load i64, ptr %.2458.i.i, align 8, !noalias !30
  %.2460.i.i = add nsw i64 %.2459.i.i, %.1789.i.i
  %.2474.i.i = icmp slt i64 %.2460.i.i, 0
  %.2475.i.i = select i1 %.2474.i.i, i64 %arg.arrays.0.5.0, i64 0
  %127 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2460.i.i
  %.2489.i.i = getelementptr double, ptr %127, i64 %.2475.i.i
  %.2490.i.i = load double, ptr %.2489.i.i, align 8, !noalias !30
  br i1 %found.3.i.1.i, label %B1162.i.i, label %B1080.i.i

B164.i:                                           ; preds = %B474.i.loopexit.i, %B0.endif.else.endif.endif.i, %B412.i.i
  %.634.i = load i64, ptr %arg.linear.1.4, align 8, !noalias !48
  %.664.i = load i64, ptr %.663.i, align 8, !noalias !48
  br i1 %.711.i, label %B226.if.lr.ph.i, label %B1276.if.preheader

B226.if.lr.ph.i:                                  ; preds = %B164.i
  %.829.i = add i64 %.634.i, 1
  %128 = add i64 %.664.i, %.634.i
  br label %B226.if.i

B396.i:                                           ; preds = %B342.if.i, %B226.if.i
  %.1055.i = mul i64 %.697.02414.i, %.743.sroa.0.02358.i
  %.1071.i = icmp slt i64 %.1055.i, 0
  %.1072.i8816 = select i1 %.1071.i, i64 %.251.i, i64 0
  %129 = getelementptr double, ptr %.267.i, i64 %.1055.i
  %.1086.i = getelementptr double, ptr %129, i64 %.1072.i8816
  %.1087.i8817 = load double, ptr %.1086.i, align 8, !noalias !48
  %.1141.i = load double, ptr %.1140.i, align 8, !noalias !48
  %.1142.i = fadd double %.1087.i8817, %.1141.i
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
  %130 = getelementptr i64, ptr %.437.i8810, i64 %.59.0509.i.i
  store i64 %p.2.1.lcssa.i.i, ptr %130, align 8, !noalias !49
  %.547.i.i = add nsw i64 %p.2.1.lcssa.i.i, %.161.i.i
  %.561.i.i = icmp slt i64 %.547.i.i, 0
  %.562.i.i = select i1 %.561.i.i, i64 %.251.i, i64 0
  %131 = getelementptr double, ptr %.267.i, i64 %.547.i.i
  %.576.i.i = getelementptr double, ptr %131, i64 %.562.i.i
  %.577.i.i = load double, ptr %.576.i.i, align 8, !noalias !49
  %.610.i.i = load double, ptr %133, align 8, !noalias !49
  store double %.577.i.i, ptr %133, align 8, !noalias !49
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
  %132 = getelementptr double, ptr %.267.i, i64 %.161.i.i
  %133 = getelementptr double, ptr %132, i64 %.59.0509.i.i
  %.319.i.i = sub i64 %.11.i.i.i, %.131.i.i
  %storemerge488.i.i = tail call i64 @llvm.smax.i64(i64 %.319.i.i, i64 0)
  %.362493.not.i.i = icmp slt i64 %.319.i.i, 1
  br i1 %.362493.not.i.i, label %B348.i.i, label %B234.if.preheader.i.i

B234.if.preheader.i.i:                            ; preds = %B36.if.i.i
  %.271.i.i = load double, ptr %133, align 8, !noalias !49
  %.272.i.i = tail call double @llvm.fabs.f64(double %.271.i.i)
  br label %B234.if.i.i

B234.if.i.i:                                      ; preds = %B234.if.i.i, %B234.if.preheader.i.i
  %p.2.1497.i.i = phi i64 [ %p.3.2.i.i, %B234.if.i.i ], [ %.59.0509.i.i, %B234.if.preheader.i.i ]
  %largest.2.1496.i.i = phi double [ %largest.3.2.i.i, %B234.if.i.i ], [ %.272.i.i, %B234.if.preheader.i.i ]
  %.309.0495.i.i = phi i64 [ %.371.i.i, %B234.if.i.i ], [ %storemerge488.i.i, %B234.if.preheader.i.i ]
  %.306.0494.i.i = phi i64 [ %.375.i.i, %B234.if.i.i ], [ %.131.i.i, %B234.if.preheader.i.i ]
  %.371.i.i = add nsw i64 %.309.0495.i.i, -1
  %.375.i.i = add i64 %.306.0494.i.i, 1
  %.415.i.i8818 = add nsw i64 %.306.0494.i.i, %.161.i.i
  %.429.i.i = icmp slt i64 %.415.i.i8818, 0
  %.430.i.i = select i1 %.429.i.i, i64 %.251.i, i64 0
  %134 = getelementptr double, ptr %.267.i, i64 %.415.i.i8818
  %.444.i.i = getelementptr double, ptr %134, i64 %.430.i.i
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
  %135 = getelementptr double, ptr %.267.i, i64 %.798.i.i
  %.827.i2372.i = getelementptr double, ptr %135, i64 %.813.i.i
  %.828.i.i = load double, ptr %.827.i2372.i, align 8, !noalias !49
  %.861.i.i = load double, ptr %133, align 8, !noalias !49
  %.865.i.i = fdiv double %.828.i.i, %.861.i.i
  store double %.865.i.i, ptr %.827.i2372.i, align 8, !noalias !49
  %.759.i2373.i = icmp sgt i64 %.706.0500.i.i, 1
  br i1 %.759.i2373.i, label %B466.if.i.i, label %B528.i.i

B566.if.i.i:                                      ; preds = %B528.i.i, %B790.i.i
  %.932.0506.i.i = phi i64 [ %.994.i.i, %B790.i.i ], [ %.942.i.i, %B528.i.i ]
  %.929.0505.i.i = phi i64 [ %.998.i.i, %B790.i.i ], [ %.131.i.i, %B528.i.i ]
  %.994.i.i = add nsw i64 %.932.0506.i.i, -1
  %.998.i.i = add i64 %.929.0505.i.i, 1
  %136 = mul nsw i64 %.929.0505.i.i, %arg.shape.1
  %.1030.i2374.i = add nsw i64 %136, %p.2.1.lcssa.i.i
  %.1044.i.i = icmp slt i64 %.1030.i2374.i, 0
  %.1045.i.i = select i1 %.1044.i.i, i64 %.251.i, i64 0
  %137 = getelementptr double, ptr %.267.i, i64 %.1030.i2374.i
  %.1059.i.i = getelementptr double, ptr %137, i64 %.1045.i.i
  %.1060.i.i = load double, ptr %.1059.i.i, align 8, !noalias !49
  %.1068.i.i = add nsw i64 %136, %.59.0509.i.i
  %.1082.i.i = icmp slt i64 %.1068.i.i, 0
  %.1083.i.i = select i1 %.1082.i.i, i64 %.251.i, i64 0
  %138 = getelementptr double, ptr %.267.i, i64 %.1068.i.i
  %.1097.i.i = getelementptr double, ptr %138, i64 %.1083.i.i
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
  %.1296.i.i = add nsw i64 %.1199.0502.i.i, %136
  %.1310.i.i = icmp slt i64 %.1296.i.i, 0
  %.1311.i2377.i = select i1 %.1310.i.i, i64 %.251.i, i64 0
  %139 = getelementptr double, ptr %.267.i, i64 %.1296.i.i
  %.1325.i.i = getelementptr double, ptr %139, i64 %.1311.i2377.i
  %.1326.i.i = load double, ptr %.1325.i.i, align 8, !noalias !49
  %.1328.i.i = add nsw i64 %.1199.0502.i.i, %.161.i.i
  %.1342.i.i = icmp slt i64 %.1328.i.i, 0
  %.1343.i.i = select i1 %.1342.i.i, i64 %.251.i, i64 0
  %140 = getelementptr double, ptr %.267.i, i64 %.1328.i.i
  %.1357.i.i = getelementptr double, ptr %140, i64 %.1343.i.i
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
  %.437.i8810 = getelementptr i64, ptr %arg.linear.1.4, i64 %.324.sroa.0.3.i
  %.525.i8811 = load double, ptr %.524.i, align 8, !noalias !48
  %.526.i = fcmp olt double %.525.i8811, 5.000000e-01
  br i1 %.526.i, label %B124.i, label %B164.i

B226.if.i:                                        ; preds = %B396.i, %B226.if.lr.ph.i
  %.697.02414.i = phi i64 [ 0, %B226.if.lr.ph.i ], [ %.766.i, %B396.i ]
  %.766.i = add nsw i64 %.697.02414.i, 1
  %.798.i = sub i64 %.697.02414.i, %128
  %.11.i.i8812 = tail call i64 @llvm.smax.i64(i64 %.798.i, i64 0)
  %.830.i = add i64 %.829.i, %.697.02414.i
  %.11.i2378.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.830.i, i64 %arg.shape.1)
  %.896.i = sub i64 %.11.i2378.i, %.11.i.i8812
  %.9392410.not.i = icmp slt i64 %.896.i, 1
  br i1 %.9392410.not.i, label %B396.i, label %B342.if.lr.ph.i

B342.if.lr.ph.i:                                  ; preds = %B226.if.i
  %.979.i8813 = mul nsw i64 %.697.02414.i, %arg.shape.1
  br label %B342.if.i

B342.if.i:                                        ; preds = %B342.if.i, %B342.if.lr.ph.i
  %.886.02412.i = phi i64 [ %.896.i, %B342.if.lr.ph.i ], [ %.948.i, %B342.if.i ]
  %.883.02411.i = phi i64 [ %.11.i.i8812, %B342.if.lr.ph.i ], [ %.952.i8814, %B342.if.i ]
  %.948.i = add nsw i64 %.886.02412.i, -1
  %.952.i8814 = add i64 %.883.02411.i, 1
  %.980.i = add nsw i64 %.883.02411.i, %.979.i8813
  %.994.i = icmp slt i64 %.980.i, 0
  %.995.i = select i1 %.994.i, i64 %arg.linear.0.5.0, i64 0
  %141 = getelementptr double, ptr %arg.linear.0.4, i64 %.980.i
  %.1009.i = getelementptr double, ptr %141, i64 %.995.i
  %.1010.i = load double, ptr %.1009.i, align 8, !noalias !48
  %.1011.i8815 = fneg double %.1010.i
  %.1030.i = select i1 %.994.i, i64 %.251.i, i64 0
  %142 = getelementptr double, ptr %.267.i, i64 %.980.i
  %.1044.i = getelementptr double, ptr %142, i64 %.1030.i
  store double %.1011.i8815, ptr %.1044.i, align 8, !noalias !48
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
  br i1 %.88.not.i, label %B0.else.endif.endif.endif.if.i8826, label %B0.else.endif.if.i8825, !prof !29

B322.i:                                           ; preds = %B192.if.i
  %.853.i8833 = load i64, ptr %arg.linear.1.4, align 8, !noalias !52
  %.883.i = load i64, ptr %.882.i, align 8, !noalias !52
  %.339.i.i8834 = add i64 %.853.i8833, 1
  br label %B34.if.i.i8835

B34.i.loopexit.i:                                 ; preds = %B198.if.i.i, %B34.if.i.i8835
  %exitcond766.not.i = icmp eq i64 %arg.shape.1, %.144.i.i
  br i1 %exitcond766.not.i, label %B314.if.i.lr.ph.i, label %B34.if.i.i8835

B314.if.i.lr.ph.i:                                ; preds = %B34.i.loopexit.i
  %143 = add i64 %.883.i, %.853.i8833
  br label %B314.if.i.i

B314.i.loopexit.i:                                ; preds = %B474.if.i.i, %B314.if.i.i
  %.683.i.i = icmp sgt i64 %.627.i.0762.in.i, 1
  br i1 %.683.i.i, label %B314.if.i.i, label %B434.if.lr.ph.i

B434.if.lr.ph.i:                                  ; preds = %B314.i.loopexit.i
  %.1110.i8843 = mul nsw i64 %.1858, %arg.shape.1
  %invariant.gep9490 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1110.i8843
  br label %B434.if.i

B34.if.i.i8835:                                   ; preds = %B34.i.loopexit.i, %B322.i
  %.73.i.0754.i = phi i64 [ 0, %B322.i ], [ %.144.i.i, %B34.i.loopexit.i ]
  %.144.i.i = add nsw i64 %.73.i.0754.i, 1
  %144 = getelementptr i64, ptr %.358.i, i64 %.73.i.0754.i
  %.202.i.i = load i64, ptr %144, align 8, !noalias !55
  %.204.i.i = add nsw i64 %.202.i.i, %.887.i
  %.218.i.i = icmp slt i64 %.204.i.i, 0
  %.219.i.i = select i1 %.218.i.i, i64 %arg.arrays.0.5.0, i64 0
  %145 = getelementptr double, ptr %arg.arrays.0.4, i64 %.204.i.i
  %.233.i.i = getelementptr double, ptr %145, i64 %.219.i.i
  %.234.i.i8836 = load double, ptr %.233.i.i, align 8, !noalias !55
  %gep9179 = getelementptr double, ptr %invariant.gep9178, i64 %.73.i.0754.i
  %.270.i.i = load double, ptr %gep9179, align 8, !noalias !55
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !55
  store double %.234.i.i8836, ptr %gep9179, align 8, !noalias !55
  %.340.i.i = add i64 %.339.i.i8834, %.73.i.0754.i
  %.11.i.i.i8837 = tail call i64 @llvm.smin.i64(i64 %.340.i.i, i64 %arg.shape.1)
  %.406.i.i = sub i64 %.11.i.i.i8837, %.144.i.i
  %.449.i750.not.i = icmp slt i64 %.406.i.i, 1
  br i1 %.449.i750.not.i, label %B34.i.loopexit.i, label %B198.if.i.lr.ph.i

B198.if.i.lr.ph.i:                                ; preds = %B34.if.i.i8835
  %.521.i.i = mul nsw i64 %.73.i.0754.i, %arg.shape.1
  br label %B198.if.i.i

B198.if.i.i:                                      ; preds = %B198.if.i.i, %B198.if.i.lr.ph.i
  %.396.i.0752.i = phi i64 [ %.406.i.i, %B198.if.i.lr.ph.i ], [ %.458.i.i, %B198.if.i.i ]
  %.393.i.0751.i = phi i64 [ %.144.i.i, %B198.if.i.lr.ph.i ], [ %.462.i.i, %B198.if.i.i ]
  %.458.i.i = add nsw i64 %.396.i.0752.i, -1
  %.462.i.i = add i64 %.393.i.0751.i, 1
  %.488.i.i = add nsw i64 %.393.i.0751.i, %.887.i
  %.502.i.i8838 = icmp slt i64 %.488.i.i, 0
  %.503.i.i = select i1 %.502.i.i8838, i64 %arg.arrays.0.5.0, i64 0
  %146 = getelementptr double, ptr %arg.arrays.0.4, i64 %.488.i.i
  %.517.i.i = getelementptr double, ptr %146, i64 %.503.i.i
  %.518.i.i = load double, ptr %.517.i.i, align 8, !noalias !55
  %.522.i.i = add nsw i64 %.393.i.0751.i, %.521.i.i
  %.536.i.i = icmp slt i64 %.522.i.i, 0
  %.537.i.i = select i1 %.536.i.i, i64 %.165.i, i64 0
  %147 = getelementptr double, ptr %.181.i, i64 %.522.i.i
  %.551.i.i = getelementptr double, ptr %147, i64 %.537.i.i
  %.552.i.i = load double, ptr %.551.i.i, align 8, !noalias !55
  %.554.i.i = fmul double %.234.i.i8836, %.552.i.i
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
  %148 = getelementptr double, ptr %arg.arrays.0.4, i64 %.726.i.i
  %.755.i.i = getelementptr double, ptr %148, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i, align 8, !noalias !55
  %.759.i.i8839 = mul nsw i64 %.627.i.0762.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i8839, %.627.i.0762.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %.165.i, i64 0
  %149 = getelementptr double, ptr %.181.i, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %149, i64 %.776.i.i
  %.791.i.i = load double, ptr %.790.i.i, align 8, !noalias !55
  %.795.i.i = fdiv double %.756.i.i, %.791.i.i
  store double %.795.i.i, ptr %.755.i.i, align 8, !noalias !55
  %.866.i.i = sub i64 %.627.i.0762.i, %143
  %.11.i4.i.i = tail call i64 @llvm.smax.i64(i64 %.866.i.i, i64 0)
  %.932.i.i = sub i64 %.627.i.0762.i, %.11.i4.i.i
  %.975.i756.not.i = icmp slt i64 %.932.i.i, 1
  br i1 %.975.i756.not.i, label %B314.i.loopexit.i, label %B474.if.i.i

B474.if.i.i:                                      ; preds = %B314.if.i.i, %B474.if.i.i
  %.922.i.0758.i = phi i64 [ %.984.i.i, %B474.if.i.i ], [ %.932.i.i, %B314.if.i.i ]
  %.919.i.0757.i = phi i64 [ %.988.i.i, %B474.if.i.i ], [ %.11.i4.i.i, %B314.if.i.i ]
  %.984.i.i = add nsw i64 %.922.i.0758.i, -1
  %.988.i.i = add i64 %.919.i.0757.i, 1
  %.1014.i.i8840 = add nsw i64 %.919.i.0757.i, %.887.i
  %.1028.i.i = icmp slt i64 %.1014.i.i8840, 0
  %.1029.i.i = select i1 %.1028.i.i, i64 %arg.arrays.0.5.0, i64 0
  %150 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1014.i.i8840
  %.1043.i.i = getelementptr double, ptr %150, i64 %.1029.i.i
  %.1044.i.i8841 = load double, ptr %.1043.i.i, align 8, !noalias !55
  %.1048.i.i = add nsw i64 %.919.i.0757.i, %.759.i.i8839
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %.165.i, i64 0
  %151 = getelementptr double, ptr %.181.i, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %151, i64 %.1063.i.i
  %.1078.i.i = load double, ptr %.1077.i.i, align 8, !noalias !55
  %.1080.i.i = fmul double %.795.i.i, %.1078.i.i
  %.1081.i.i = fsub double %.1044.i.i8841, %.1080.i.i
  store double %.1081.i.i, ptr %.1043.i.i, align 8, !noalias !55
  %.975.i.i = icmp sgt i64 %.922.i.0758.i, 1
  br i1 %.975.i.i, label %B474.if.i.i, label %B314.i.loopexit.i

B0.else.endif.if.i8825:                           ; preds = %B1464
  br label %B0.else.endif.endif.endif.if.i8826

B0.else.endif.endif.endif.if.i8826:               ; preds = %B0.else.endif.if.i8825, %B1464
  %.68.sroa.0.3.i = phi i64 [ %arg.linear.0.5.0, %B0.else.endif.if.i8825 ], [ %.42.i, %B1464 ]
  %.156.i = sub nsw i64 %arg.linear.0.5.0, %.68.sroa.0.3.i
  %.165.i = tail call i64 @llvm.smax.i64(i64 %.156.i, i64 0)
  %.181.i = getelementptr double, ptr %arg.linear.0.4, i64 %.68.sroa.0.3.i
  br i1 %.265.i, label %B0.endif.else.endif.if.i8845, label %B0.endif.else.endif.endif.i8827, !prof !36

B0.endif.else.endif.if.i8845:                     ; preds = %B0.else.endif.endif.endif.if.i8826
  br label %B0.endif.else.endif.endif.i8827

B0.endif.else.endif.endif.i8827:                  ; preds = %B0.endif.else.endif.if.i8845, %B0.else.endif.endif.endif.if.i8826
  %.245.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.else.endif.if.i8845 ], [ 5, %B0.else.endif.endif.endif.if.i8826 ]
  %.358.i = getelementptr i64, ptr %arg.linear.1.4, i64 %.245.sroa.0.3.i
  br i1 %.277.i, label %B0.endif.endif.else.if.i, label %B0.endif.endif.else.endif.i, !prof !36

B192.if.lr.ph.i:                                  ; preds = %B0.endif.endif.else.endif.endif.endif.i
  %.689.i = mul nsw i64 %.1858, %arg.shape.1
  %invariant.gep9488 = getelementptr double, ptr %arg.arrays.0.4, i64 %.689.i
  br label %B192.if.i

B0.endif.endif.else.if.i:                         ; preds = %B0.endif.else.endif.endif.i8827
  br label %B0.endif.endif.else.endif.i

B0.endif.endif.else.endif.i:                      ; preds = %B0.endif.endif.else.if.i, %B0.endif.else.endif.endif.i8827
  %.418.sroa.0.1.i = phi i64 [ 0, %B0.endif.endif.else.if.i ], [ %.274.i8828, %B0.endif.else.endif.endif.i8827 ]
  br i1 %.282.not.i, label %B0.endif.endif.else.endif.endif.endif.i, label %B0.endif.endif.else.endif.if.i, !prof !29

B0.endif.endif.else.endif.if.i:                   ; preds = %B0.endif.endif.else.endif.i
  br label %B0.endif.endif.else.endif.endif.endif.i

B0.endif.endif.else.endif.endif.endif.i:          ; preds = %B0.endif.endif.else.endif.if.i, %B0.endif.endif.else.endif.i
  %.418.sroa.0.3.i = phi i64 [ %arg.linear.1.5.0, %B0.endif.endif.else.endif.if.i ], [ %.418.sroa.0.1.i, %B0.endif.endif.else.endif.i ]
  %.531.i = getelementptr i64, ptr %arg.linear.1.4, i64 %.418.sroa.0.3.i
  br i1 %.648747.not.i, label %B1500, label %B192.if.lr.ph.i

B192.if.i:                                        ; preds = %B192.if.i, %B192.if.lr.ph.i
  %.590.0748.i = phi i64 [ 0, %B192.if.lr.ph.i ], [ %.661.i8830, %B192.if.i ]
  %.661.i8830 = add nsw i64 %.590.0748.i, 1
  %gep9489 = getelementptr double, ptr %invariant.gep9488, i64 %.590.0748.i
  %.720.i = load double, ptr %gep9489, align 8, !noalias !52
  %gep9177 = getelementptr double, ptr %invariant.gep9176, i64 %.590.0748.i
  %.753.i = load double, ptr %gep9177, align 8, !noalias !52
  %.754.i = fadd double %.720.i, %.753.i
  %152 = getelementptr i64, ptr %.531.i, i64 %.590.0748.i
  %.786.i = load i64, ptr %152, align 8, !noalias !52
  %.787.i = add nsw i64 %.786.i, %.756.i
  %.801.i = icmp slt i64 %.787.i, 0
  %.802.i = select i1 %.801.i, i64 %arg.arrays.0.5.0, i64 0
  %153 = getelementptr double, ptr %arg.arrays.0.4, i64 %.787.i
  %.816.i = getelementptr double, ptr %153, i64 %.802.i
  store double %.754.i, ptr %.816.i, align 8, !noalias !52
  %exitcond.not.i8832 = icmp eq i64 %arg.shape.1, %.661.i8830
  br i1 %exitcond.not.i8832, label %B322.i, label %B192.if.i

B434.if.i:                                        ; preds = %B434.if.i, %B434.if.lr.ph.i
  %.950.0764.i = phi i64 [ 0, %B434.if.lr.ph.i ], [ %.1019.i, %B434.if.i ]
  %.1019.i = add nsw i64 %.950.0764.i, 1
  %154 = getelementptr i64, ptr %.531.i, i64 %.950.0764.i
  %.1075.i = load i64, ptr %154, align 8, !noalias !52
  %.1076.i = add nsw i64 %.1075.i, %.887.i
  %.1090.i = icmp slt i64 %.1076.i, 0
  %.1091.i = select i1 %.1090.i, i64 %arg.arrays.0.5.0, i64 0
  %155 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1076.i
  %.1105.i = getelementptr double, ptr %155, i64 %.1091.i
  %.1106.i = load double, ptr %.1105.i, align 8, !noalias !52
  %gep9491 = getelementptr double, ptr %invariant.gep9490, i64 %.950.0764.i
  store double %.1106.i, ptr %gep9491, align 8, !noalias !52
  %exitcond767.not.i = icmp eq i64 %arg.shape.1, %.1019.i
  br i1 %exitcond767.not.i, label %B1500, label %B434.if.i

B1500:                                            ; preds = %B434.if.i, %B0.endif.endif.else.endif.endif.endif.i, %B1276.if
  %exitcond9307.not = icmp eq i64 %.1789.09180, %.
  br i1 %exitcond9307.not, label %B1502, label %B1276.if

B1502:                                            ; preds = %B1500
  %.2122 = load i64, ptr %.2121, align 8
  %.2167 = inttoptr i64 %.2122 to ptr
  tail call void %.2167(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %brmerge = select i1 %anew.2.1, i1 true, i1 %.539
  %or.cond8794 = select i1 %brmerge, i1 true, i1 %.2203
  %spec.select8805 = select i1 %or.cond8794, i1 true, i1 %.2208
  br i1 %.274.i, label %B1736, label %B1646.if

B1654:                                            ; preds = %B1646.if
  %156 = getelementptr double, ptr %288, i64 %.2248.09183
  %.2407 = load double, ptr %156, align 8
  %.2408 = fcmp ogt double %.2407, 5.000000e-01
  br label %B1690

B1690:                                            ; preds = %B1654, %B1646.if
  %"$phi1690.1.2.2" = phi i1 [ true, %B1646.if ], [ %.2408, %B1654 ]
  br i1 %looked.2.19186, label %B1732, label %B1696

B1696:                                            ; preds = %B1690
  %157 = getelementptr double, ptr %289, i64 %.2248.09183
  %.2482 = load double, ptr %157, align 8
  %.2483 = fcmp ogt double %.2482, 5.000000e-01
  br label %B1732

B1732:                                            ; preds = %B1696, %B1690
  %"$phi1732.1.2.2" = phi i1 [ true, %B1690 ], [ %.2483, %B1696 ]
  %.2304 = icmp sgt i64 %.2251.09184, 1
  br i1 %.2304, label %B1646.if, label %B1736

B1736:                                            ; preds = %B1732, %B1502
  %good.2.1.lcssa = phi i1 [ false, %B1502 ], [ %"$phi1690.1.2.2", %B1732 ]
  %looked.2.1.lcssa = phi i1 [ %spec.select8805, %B1502 ], [ %"$phi1732.1.2.2", %B1732 ]
  br i1 %.539, label %B1740, label %B1848

B1740:                                            ; preds = %B1736
  %.2559 = load double, ptr %.2558, align 8
  %.2614 = fsub double 1.000000e+00, %.2559
  store double %.2559, ptr %.2667, align 8
  store double %.2614, ptr %.2721, align 8
  br label %B1848

B1848:                                            ; preds = %B1740, %B1736
  %looked.2.1.lcssa.not9314 = xor i1 %looked.2.1.lcssa, true
  %brmerge9315 = or i1 %.274.i, %looked.2.1.lcssa.not9314
  br i1 %brmerge9315, label %B2444, label %B46.if.i

B1920.preheader:                                  ; preds = %B416.i
  br i1 %.274.i, label %B2444, label %B1922.if

B92.i:                                            ; preds = %B46.if.i
  %.303.i930 = getelementptr double, ptr %290, i64 %.90.i779.09190
  %.304.i931 = load double, ptr %.303.i930, align 8, !noalias !59
  %.5.i.i = fptosi double %.304.i931 to i64
  %.382.i = getelementptr double, ptr %291, i64 %.90.i779.09190
  %.383.i980 = load double, ptr %.382.i, align 8, !noalias !59
  %.5.i1.i = fptosi double %.383.i980 to i64
  %.457.i1027 = mul i64 %.243.i881, %arg.results.3.5.1
  %.461.i1031 = getelementptr i64, ptr %arg.results.3.4, i64 %.457.i1027
  %.462.i1032 = load i64, ptr %.461.i1031, align 8, !noalias !59
  %.463.i1033 = add nsw i64 %.462.i1032, %.5.i.i
  store i64 %.463.i1033, ptr %.461.i1031, align 8, !noalias !59
  %.569.i1126 = getelementptr i8, ptr %.461.i1031, i64 24
  %.570.i1127 = load i64, ptr %.569.i1126, align 8, !noalias !59
  %.571.i1128 = add nsw i64 %.570.i1127, %.5.i1.i
  store i64 %.571.i1128, ptr %.569.i1126, align 8, !noalias !59
  %.679.i1212 = getelementptr i8, ptr %.461.i1031, i64 8
  %.680.i1213 = load i64, ptr %.679.i1212, align 8, !noalias !59
  %.683.i = add nsw i64 %.5.i1.i, %.5.i.i
  %.684.i = mul nsw i64 %.683.i, %.
  %.685.i1215 = add nsw i64 %.684.i, %.5.i.i
  %.686.i1216 = add nsw i64 %.685.i1215, %.680.i1213
  store i64 %.686.i1216, ptr %.679.i1212, align 8, !noalias !59
  store double 0.000000e+00, ptr %.303.i930, align 8, !noalias !59
  store double 0.000000e+00, ptr %.382.i, align 8, !noalias !59
  br label %B416.i

B416.i:                                           ; preds = %B92.i, %B46.if.i
  %.148.i = icmp sgt i64 %.93.i780.09191, 1
  br i1 %.148.i, label %B46.if.i, label %B1920.preheader

B46.if.i:                                         ; preds = %B1848, %B416.i
  %.93.i780.09191 = phi i64 [ %.157.i1320, %B416.i ], [ %storemerge, %B1848 ]
  %.90.i779.09190 = phi i64 [ %.161.i1323, %B416.i ], [ 0, %B1848 ]
  %.157.i1320 = add nsw i64 %.93.i780.09191, -1
  %.161.i1323 = add nsw i64 %.90.i779.09190, 1
  %158 = getelementptr i64, ptr %arg.lane.1.4, i64 %.90.i779.09190
  %.243.i881 = load i64, ptr %158, align 8, !noalias !59
  %.248.i884 = icmp sgt i64 %.243.i881, -1
  br i1 %.248.i884, label %B92.i, label %B416.i

B2022:                                            ; preds = %B1922.if
  %.3169 = getelementptr double, ptr %294, i64 %.2829.09193
  %.3170 = load double, ptr %.3169, align 8
  %.3171 = fcmp ogt double %.3170, 5.000000e-01
  br i1 %.3171, label %B2060, label %B2118

B2060:                                            ; preds = %B2022
  %159 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2829.09193
  %.84.i2080 = load i64, ptr %159, align 8, !noalias !63
  %.89.i2083 = icmp sgt i64 %.84.i2080, -1
  br i1 %.89.i2083, label %B46.i2087, label %B2118

B46.i2087:                                        ; preds = %B2060
  %.120.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i2080
  %.121.i2106 = load i64, ptr %.120.i, align 8, !noalias !63
  %.122.i2107 = icmp eq i64 %.121.i2106, 0
  br i1 %.122.i2107, label %B80.i, label %B2118

B80.i:                                            ; preds = %B46.i2087
  store i64 2, ptr %.120.i, align 8, !noalias !63
  br label %B2118

B2118:                                            ; preds = %B2022, %B46.i2087, %B2060, %B80.i
  %.3285 = getelementptr double, ptr %295, i64 %.2829.09193
  %.3286 = load double, ptr %.3285, align 8
  %.3287 = fcmp ogt double %.3286, 5.000000e-01
  br i1 %.3287, label %B2156, label %B2440

B2156:                                            ; preds = %B2118
  %spec.select = select i1 %within.3.29196, i1 true, i1 %.2203
  %.3365 = mul i64 %.2996, %arg.results.3.5.1
  %.3369 = getelementptr i64, ptr %arg.results.3.4, i64 %.3365
  %.3370 = load i64, ptr %.3369, align 8
  %.3381.0 = and i64 %.3370, 127
  %.3411 = icmp eq i64 %.3381.0, 0
  br i1 %.3411, label %B2264, label %B2226

B2226:                                            ; preds = %B2156
  %.3472 = getelementptr double, ptr %296, i64 %.2829.09193
  %.3473 = load double, ptr %.3472, align 8
  %.3475 = fcmp ogt double %.3473, 0.000000e+00
  br i1 %.3475, label %B2264, label %B2294

B2264:                                            ; preds = %B2156, %B2226
  store double 1.000000e+00, ptr %.3111, align 8
  br label %B2294

B2294:                                            ; preds = %B2264, %B2226
  %doubted.5.5 = phi i1 [ true, %B2264 ], [ %doubted.3.29197, %B2226 ]
  %.3561 = icmp slt i64 %.3051, %arg.times.5.0
  br i1 %.3561, label %B2332, label %B2440

B2332:                                            ; preds = %B2294
  %.3588 = icmp slt i64 %.3051, 0
  %.3589 = select i1 %.3588, i64 %arg.times.5.0, i64 0
  %160 = getelementptr double, ptr %arg.times.4, i64 %.3051
  %.3603 = getelementptr double, ptr %160, i64 %.3589
  %.3604 = load double, ptr %.3603, align 8
  %.3658 = getelementptr double, ptr %297, i64 %.2829.09193
  %.3659 = load double, ptr %.3658, align 8
  %.3660 = fcmp ugt double %.3604, %.3659
  br i1 %.3660, label %B2440, label %B2382

B2382:                                            ; preds = %B2332
  %.3769 = fcmp olt double %.3604, %.3659
  %spec.select8795 = or i1 %spec.select, %.3769
  br label %B2440

B2440:                                            ; preds = %B1922.if, %B2382, %B2332, %B2294, %B2118
  %wanted.4.3 = phi i1 [ true, %B2382 ], [ %wanted.3.29195, %B2332 ], [ %wanted.3.29195, %B2294 ], [ %wanted.3.29195, %B2118 ], [ %wanted.3.29195, %B1922.if ]
  %within.4.3 = phi i1 [ %spec.select8795, %B2382 ], [ %spec.select, %B2332 ], [ %spec.select, %B2294 ], [ %within.3.29196, %B2118 ], [ %within.3.29196, %B1922.if ]
  %doubted.4.3 = phi i1 [ %doubted.5.5, %B2382 ], [ %doubted.5.5, %B2332 ], [ %doubted.5.5, %B2294 ], [ %doubted.3.29197, %B2118 ], [ %doubted.3.29197, %B1922.if ]
  %.2895 = icmp sgt i64 %.2832.09194, 1
  br i1 %.2895, label %B1922.if, label %B2444.loopexit

B2444.loopexit:                                   ; preds = %B2440
  %161 = xor i1 %doubted.4.3, true
  %162 = select i1 %161, i1 true, i1 %.539
  %163 = select i1 %wanted.4.3, i1 true, i1 %within.4.3
  br label %B2444

B2444:                                            ; preds = %B1848, %B2444.loopexit, %B1920.preheader
  %wanted.2.1 = phi i1 [ false, %B1848 ], [ false, %B1920.preheader ], [ %163, %B2444.loopexit ]
  %within.5.1 = phi i1 [ false, %B1848 ], [ false, %B1920.preheader ], [ %within.4.3, %B2444.loopexit ]
  %doubted.2.1 = phi i1 [ true, %B1848 ], [ true, %B1920.preheader ], [ %162, %B2444.loopexit ]
  br i1 %good.2.1.lcssa, label %B2448, label %B2564

B2448:                                            ; preds = %B2444
  %.3866 = load i64, ptr %arg.code.4, align 8
  %.3916 = inttoptr i64 %.3866 to ptr
  tail call void %.3916(ptr %.490, ptr %.3890, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.3915)
  br label %B2564

B2564:                                            ; preds = %B2448, %B2444
  br i1 %doubted.2.1, label %B2640, label %B2572

B2572:                                            ; preds = %B2564
  %.3954 = load i64, ptr %.3953, align 8
  %.3999 = inttoptr i64 %.3954 to ptr
  tail call void %.3999(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B2640

B2640:                                            ; preds = %B2564, %B2572
  %164 = select i1 %.2208, i1 %good.2.1.lcssa, i1 false
  br i1 %164, label %B2660, label %B2782

B2660:                                            ; preds = %B2640
  %.4050 = load i64, ptr %.4049, align 8
  %.4097 = inttoptr i64 %.4050 to ptr
  tail call void %.4097(ptr %.490, ptr %.4071, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.274.i, label %B2782, label %B38.if.i

B104.i2356:                                       ; preds = %B38.if.i
  %.349.i2402 = getelementptr double, ptr %299, i64 %.78.i2180.09202
  %.350.i2403 = load double, ptr %.349.i2402, align 8, !noalias !66
  %.351.i2404 = fcmp ogt double %.350.i2403, 5.000000e-01
  br i1 %.351.i2404, label %B34.i.i, label %B304.i

B34.i.i:                                          ; preds = %B104.i2356, %B36.i.i
  %.48.i.i2142.0 = phi i64 [ %.119.i.i, %B36.i.i ], [ 0, %B104.i2356 ]
  %exitcond9308.not = icmp eq i64 %.48.i.i2142.0, %arg.decided
  br i1 %exitcond9308.not, label %B142.endif.i, label %B36.i.i

B36.i.i:                                          ; preds = %B34.i.i
  %.119.i.i = add i64 %.48.i.i2142.0, 1
  %.149.i.i2669 = add nsw i64 %.48.i.i2142.0, %arg.decided
  %.151.i.i2671 = mul nsw i64 %.149.i.i2669, %arg.shape.0
  %.153.i.i = add nsw i64 %.151.i.i2671, %.78.i2180.09202
  %.167.i.i = icmp slt i64 %.153.i.i, 0
  %.168.i.i2675 = select i1 %.167.i.i, i64 %arg.arrays.4.5.0, i64 0
  %165 = getelementptr double, ptr %arg.arrays.4.4, i64 %.153.i.i
  %.182.i.i = getelementptr double, ptr %165, i64 %.168.i.i2675
  %.183.i.i = load double, ptr %.182.i.i, align 8, !noalias !70
  %.184.i.i = fcmp ogt double %.183.i.i, 5.000000e-01
  br i1 %.184.i.i, label %B142.endif.i, label %B34.i.i

B190.i2467:                                       ; preds = %B142.endif.i
  store double 1.000000e+00, ptr %.234.i2301, align 8, !noalias !66
  %.503.i2563 = getelementptr double, ptr %300, i64 %.78.i2180.09202
  store double 0.000000e+00, ptr %.503.i2563, align 8, !noalias !66
  %.558.i2610 = getelementptr double, ptr %301, i64 %.78.i2180.09202
  store double 1.000000e+00, ptr %.558.i2610, align 8, !noalias !66
  %.616.i2658 = getelementptr i64, ptr %302, i64 %.78.i2180.09202
  store i64 %.363.i2191.0, ptr %.616.i2658, align 8, !noalias !66
  br label %B304.i

B304.i:                                           ; preds = %B142.endif.i, %B190.i2467, %B104.i2356, %B38.if.i
  %some.3.i.1 = phi i1 [ true, %B190.i2467 ], [ %some.2.i.09204, %B142.endif.i ], [ %some.2.i.09204, %B104.i2356 ], [ %some.2.i.09204, %B38.if.i ]
  %.136.i2234 = icmp sgt i64 %.81.i2181.09203, 1
  br i1 %.136.i2234, label %B38.if.i, label %B2782

B38.if.i:                                         ; preds = %B2660, %B304.i
  %some.2.i.09204 = phi i1 [ %some.3.i.1, %B304.i ], [ false, %B2660 ]
  %.81.i2181.09203 = phi i64 [ %.145.i2690, %B304.i ], [ %storemerge, %B2660 ]
  %.78.i2180.09202 = phi i64 [ %.149.i2693, %B304.i ], [ 0, %B2660 ]
  %.145.i2690 = add nsw i64 %.81.i2181.09203, -1
  %.149.i2693 = add nsw i64 %.78.i2180.09202, 1
  %.234.i2301 = getelementptr double, ptr %298, i64 %.78.i2180.09202
  store double 0.000000e+00, ptr %.234.i2301, align 8, !noalias !66
  %.289.i2348 = getelementptr i64, ptr %arg.lane.1.4, i64 %.78.i2180.09202
  %.290.i2349 = load i64, ptr %.289.i2348, align 8, !noalias !66
  %.291.i2350 = icmp sgt i64 %.290.i2349, -1
  br i1 %.291.i2350, label %B104.i2356, label %B304.i

B142.endif.i:                                     ; preds = %B36.i.i, %B34.i.i
  %.363.i2191.0 = phi i64 [ %.48.i.i2142.0, %B36.i.i ], [ -1, %B34.i.i ]
  %.393.i2466 = icmp sgt i64 %.363.i2191.0, -1
  br i1 %.393.i2466, label %B190.i2467, label %B304.i

B2782:                                            ; preds = %B304.i, %B2660, %B2640
  %beyond.2.1 = phi i1 [ false, %B2640 ], [ false, %B2660 ], [ %some.3.i.1, %B304.i ]
  %brmerge8798 = select i1 %within.5.1, i1 true, i1 %beyond.2.1
  br i1 %brmerge8798, label %B2792, label %B3324

B2792:                                            ; preds = %B2782
  br i1 %.539, label %B3238.critedge, label %B2860.if

B142.i2980:                                       ; preds = %B66.if.i
  %.407.i3028 = getelementptr double, ptr %304, i64 %.135.i2800.09209
  %.408.i3029 = load double, ptr %.407.i3028, align 8, !noalias !74
  %.409.i3030 = fcmp uge double %.408.i3029, 5.000000e-01
  %.422.i3038.not = icmp slt i64 %.344.i2975, %arg.times.5.0
  %or.cond8799 = select i1 %.409.i3030, i1 %.422.i3038.not, i1 false
  br i1 %or.cond8799, label %B218.i, label %B611.i

B218.i:                                           ; preds = %B142.i2980
  %.438.i3049 = icmp slt i64 %.344.i2975, 0
  %.439.i3050 = select i1 %.438.i3049, i64 %arg.times.5.0, i64 0
  %166 = getelementptr double, ptr %arg.times.4, i64 %.344.i2975
  %.453.i3064 = getelementptr double, ptr %166, i64 %.439.i3050
  %.454.i3065 = load double, ptr %.453.i3064, align 8, !noalias !74
  %.508.i3113 = getelementptr double, ptr %305, i64 %.135.i2800.09209
  %.509.i3114 = load double, ptr %.508.i3113, align 8, !noalias !74
  %.510.i3115 = fcmp ult double %.454.i3065, %.509.i3114
  br i1 %.510.i3115, label %B270.i, label %B611.i

B270.i:                                           ; preds = %B218.i
  %.572.i3163 = getelementptr double, ptr %306, i64 %.135.i2800.09209
  %.573.i3164 = load double, ptr %.572.i3163, align 8, !noalias !74
  %.574.i3165 = fcmp ogt double %.573.i3164, 1.000000e+00
  br i1 %.574.i3165, label %B308.i, label %B611.i

B308.i:                                           ; preds = %B270.i
  store double 0.000000e+00, ptr %.407.i3028, align 8, !noalias !74
  %.690.i3260 = getelementptr double, ptr %307, i64 %.135.i2800.09209
  store double 0.000000e+00, ptr %.690.i3260, align 8, !noalias !74
  %.745.i3301 = getelementptr double, ptr %308, i64 %.135.i2800.09209
  store double 0.000000e+00, ptr %.745.i3301, align 8, !noalias !74
  %.800.i3345 = getelementptr double, ptr %309, i64 %.135.i2800.09209
  %.801.i3346 = load double, ptr %.800.i3345, align 8, !noalias !74
  %.832.i3373 = load double, ptr %.453.i3064, align 8, !noalias !74
  %.888.i3402 = getelementptr double, ptr %310, i64 %.135.i2800.09209
  store double %.801.i3346, ptr %.888.i3402, align 8, !noalias !74
  %.945.i = getelementptr double, ptr %311, i64 %.135.i2800.09209
  store double %.832.i3373, ptr %.945.i, align 8, !noalias !74
  %.996.i3459 = mul i64 %.289.i2926, %arg.results.3.5.1
  %.1000.i3461 = getelementptr i64, ptr %arg.results.3.4, i64 %.996.i3459
  %.1001.i3462 = load i64, ptr %.1000.i3461, align 8, !noalias !74
  %.1002.i3463 = add nsw i64 %.1001.i3462, -1
  store i64 %.1002.i3463, ptr %.1000.i3461, align 8, !noalias !74
  %.1108.i = getelementptr i8, ptr %.1000.i3461, i64 24
  %.1109.i = load i64, ptr %.1108.i, align 8, !noalias !74
  %.1110.i = add nsw i64 %.1109.i, 1
  store i64 %.1110.i, ptr %.1108.i, align 8, !noalias !74
  %.1218.i = getelementptr i8, ptr %.1000.i3461, i64 8
  %.1219.i = load i64, ptr %.1218.i, align 8, !noalias !74
  %.1220.i = add nsw i64 %.1219.i, 3
  store i64 %.1220.i, ptr %.1218.i, align 8, !noalias !74
  br label %B611.i

B611.i:                                           ; preds = %B270.i, %B308.i, %B66.if.i, %B142.i2980, %B218.i
  %.194.i2868 = icmp sgt i64 %.138.i2801.09210, 1
  br i1 %.194.i2868, label %B66.if.i, label %B3238

B66.if.i:                                         ; preds = %B2860.if, %B611.i
  %.138.i2801.09210 = phi i64 [ %.203.i3520, %B611.i ], [ %storemerge, %B2860.if ]
  %.135.i2800.09209 = phi i64 [ %.207.i3523, %B611.i ], [ 0, %B2860.if ]
  %.203.i3520 = add nsw i64 %.138.i2801.09210, -1
  %.207.i3523 = add nsw i64 %.135.i2800.09209, 1
  %.288.i2925 = getelementptr i64, ptr %arg.lane.1.4, i64 %.135.i2800.09209
  %.289.i2926 = load i64, ptr %.288.i2925, align 8, !noalias !74
  %.343.i2974 = getelementptr i64, ptr %303, i64 %.135.i2800.09209
  %.344.i2975 = load i64, ptr %.343.i2974, align 8, !noalias !74
  %.352.i2979 = icmp slt i64 %.289.i2926, 0
  br i1 %.352.i2979, label %B611.i, label %B142.i2980

B3238.critedge:                                   ; preds = %B2792
  %.4550.c = load i64, ptr %.4549.c, align 8
  %.4595.c = inttoptr i64 %.4550.c to ptr
  tail call void %.4595.c(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B3238

B3238:                                            ; preds = %B611.i, %B2860.if, %B3238.critedge
  br i1 %beyond.2.1, label %B104.if.i, label %B3282

B102.loopexit.i.critedge:                         ; preds = %B104.if.i
  %.1014.i.c = load i64, ptr %.1013.i, align 8, !noalias !78
  %.1131.i.c = inttoptr i64 %.1014.i.c to ptr
  tail call void %.1131.i.c(ptr %.490, ptr %.1105.i8848, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !78
  br label %B102.loopexit.i

B102.loopexit.i:                                  ; preds = %B1498.i, %B102.loopexit.i.critedge
  %.281.i = icmp ugt i64 %.225.01193.i, 1
  br i1 %.281.i, label %B104.if.i, label %B842.i

B138.loopexit.i:                                  ; preds = %B380.if.i, %middle.block9411, %B138.if.i
  %exitcond1198.not.i = icmp eq i64 %arg.shape.0, %.412.i
  br i1 %exitcond1198.not.i, label %B474.i, label %B138.if.i

B474.i:                                           ; preds = %B138.loopexit.i
  %.1014.i = load i64, ptr %.1013.i, align 8, !noalias !78
  %.1131.i = inttoptr i64 %.1014.i to ptr
  tail call void %.1131.i(ptr %.490, ptr %.1105.i8848, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !78
  br label %B622.if.i

B674.i8855:                                       ; preds = %B622.if.i
  %.1364.i = getelementptr double, ptr %312, i64 %.1157.01191.i
  %.1365.i = load double, ptr %.1364.i, align 8, !noalias !78
  %.1419.i = getelementptr double, ptr %313, i64 %.1157.01191.i
  %.1420.i = load double, ptr %.1419.i, align 8, !noalias !78
  %.1421.i = fadd double %.1365.i, %.1420.i
  %.1422.i = fmul double %.1421.i, 5.000000e-01
  br label %B34.i.i8856

B34.i.i8856:                                      ; preds = %B34.if.i.i8857, %B674.i8855
  %.48.i.0.i = phi i64 [ 0, %B674.i8855 ], [ %.119.i73.i, %B34.if.i.i8857 ]
  %exitcond1199.not.i = icmp eq i64 %.48.i.0.i, %storemerge1173.i
  br i1 %exitcond1199.not.i, label %B812.i, label %B34.if.i.i8857

B80.i.i8859:                                      ; preds = %B34.if.i.i8857
  %167 = icmp sgt i64 %.48.i.0.i, -1
  br i1 %167, label %B786.i, label %B812.i

B34.if.i.i8857:                                   ; preds = %B34.i.i8856
  %.119.i73.i = add i64 %.48.i.0.i, 1
  %.149.i42.i = add nsw i64 %.48.i.0.i, %arg.decided
  %.151.i.i = mul nsw i64 %.149.i42.i, %arg.shape.0
  %.153.i44.i = add nsw i64 %.151.i.i, %.1157.01191.i
  %.167.i51.i = icmp slt i64 %.153.i44.i, 0
  %.168.i.i = select i1 %.167.i51.i, i64 %arg.arrays.4.5.0, i64 0
  %168 = getelementptr double, ptr %arg.arrays.4.4, i64 %.153.i44.i
  %.182.i.i8858 = getelementptr double, ptr %168, i64 %.168.i.i
  %.183.i63.i = load double, ptr %.182.i.i8858, align 8, !noalias !81
  %.184.i64.i = fcmp ogt double %.183.i63.i, 5.000000e-01
  br i1 %.184.i64.i, label %B80.i.i8859, label %B34.i.i8856

B786.i:                                           ; preds = %B80.i.i8859
  store double %.1422.i, ptr %.1419.i, align 8, !noalias !78
  br label %B1498.i

B812.i:                                           ; preds = %B34.i.i8856, %B80.i.i8859
  store double %.1422.i, ptr %.1364.i, align 8, !noalias !78
  br label %B1498.i

B842.i:                                           ; preds = %B102.loopexit.i
  br i1 %.274.i, label %B3282, label %B874.if.i

B978.i:                                           ; preds = %B874.if.i
  %.2010.i = load double, ptr %.1786.i, align 8, !noalias !78
  %.2011.i = tail call double @llvm.fabs.f64(double %.2010.i)
  %.2012.i = fmul double %.2011.i, 2.000000e-12
  %.2069.i = getelementptr double, ptr %312, i64 %.1635.01195.i
  %.2070.i = load double, ptr %.2069.i, align 8, !noalias !78
  %.2125.i = getelementptr double, ptr %315, i64 %.1635.01195.i
  %.2126.i = load double, ptr %.2125.i, align 8, !noalias !78
  %.2183.i = fmul double %.2126.i, 0x3D719799812DEA11
  %.10.i.i8853 = fcmp ogt double %.2012.i, %.2183.i
  %.11.i.i8854 = select i1 %.10.i.i8853, double %.2012.i, double %.2183.i
  %.2071.i = fsub double 1.000000e+00, %.2070.i
  %.2127.i = fmul double %.2071.i, %.2126.i
  %.2212.i = fcmp ugt double %.2127.i, %.11.i.i8854
  br i1 %.2212.i, label %B1268.i, label %B1232.i

B1232.i:                                          ; preds = %B978.i
  store double 2.000000e+00, ptr %.1896.i, align 8, !noalias !78
  br label %B1497.i

B1268.i:                                          ; preds = %B978.i
  %169 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1635.01195.i
  %.1954.i = load i64, ptr %169, align 8, !noalias !78
  %.2331.i = getelementptr double, ptr %317, i64 %.1635.01195.i
  store double 0.000000e+00, ptr %.2331.i, align 8, !noalias !78
  %.2386.i = getelementptr double, ptr %318, i64 %.1635.01195.i
  store double 0.000000e+00, ptr %.2386.i, align 8, !noalias !78
  %.2441.i = getelementptr double, ptr %313, i64 %.1635.01195.i
  %.2442.i = load double, ptr %.2441.i, align 8, !noalias !78
  %.2497.i = load double, ptr %.2125.i, align 8, !noalias !78
  %.2498.i = fmul double %.2442.i, %.2497.i
  %.2554.i = getelementptr double, ptr %319, i64 %.1635.01195.i
  store double %.2498.i, ptr %.2554.i, align 8, !noalias !78
  %.2583.i = icmp slt i64 %.1954.i, 0
  %.2584.i = select i1 %.2583.i, i64 %arg.results.3.5.0, i64 0
  %.2585.i = add i64 %.2584.i, %.1954.i
  %.2605.i = mul i64 %.2585.i, %arg.results.3.5.1
  %.2609.i = getelementptr i64, ptr %arg.results.3.4, i64 %.2605.i
  %.2610.i = load i64, ptr %.2609.i, align 8, !noalias !78
  %.2611.i = add nsw i64 %.2610.i, -1
  store i64 %.2611.i, ptr %.2609.i, align 8, !noalias !78
  %.2719.i = getelementptr i8, ptr %.2609.i, i64 24
  %.2720.i = load i64, ptr %.2719.i, align 8, !noalias !78
  %.2721.i = add nsw i64 %.2720.i, 1
  store i64 %.2721.i, ptr %.2719.i, align 8, !noalias !78
  br label %B1497.i

B1497.i:                                          ; preds = %B874.if.i, %B1268.i, %B1232.i
  %exitcond1201.not.i = icmp eq i64 %.1705.i, %arg.shape.0
  br i1 %exitcond1201.not.i, label %B3282, label %B874.if.i

B1498.i:                                          ; preds = %B622.if.i, %B812.i, %B786.i
  %exitcond1200.not.i = icmp eq i64 %arg.shape.0, %.1226.i
  br i1 %exitcond1200.not.i, label %B102.loopexit.i, label %B622.if.i

B104.if.i:                                        ; preds = %B3238, %B102.loopexit.i
  %.225.01193.i = phi i64 [ %.290.i, %B102.loopexit.i ], [ 50, %B3238 ]
  %.290.i = add nsw i64 %.225.01193.i, -1
  br i1 %.274.i, label %B102.loopexit.i.critedge, label %B138.if.i

B138.if.i:                                        ; preds = %B104.if.i, %B138.loopexit.i
  %.343.01188.i = phi i64 [ %.412.i, %B138.loopexit.i ], [ 0, %B104.if.i ]
  %.412.i = add nsw i64 %.343.01188.i, 1
  %.493.i = getelementptr double, ptr %312, i64 %.343.01188.i
  %.494.i = load double, ptr %.493.i, align 8, !noalias !78
  %.548.i8849 = getelementptr double, ptr %313, i64 %.343.01188.i
  %.549.i = load double, ptr %.548.i8849, align 8, !noalias !78
  %.550.i = fadd double %.494.i, %.549.i
  %.551.i = fmul double %.550.i, 5.000000e-01
  %.608.i = getelementptr double, ptr %314, i64 %.343.01188.i
  %.609.i = load double, ptr %.608.i, align 8, !noalias !78
  %.610.i = fcmp une double %.609.i, 1.000000e+00
  %share.3.2.i = select i1 %.610.i, double 1.000000e+00, double %.551.i
  %.668.i = getelementptr double, ptr %arg.lane.0.4, i64 %.343.01188.i
  %.669.i = load double, ptr %.668.i, align 8, !noalias !78
  %.723.i = getelementptr double, ptr %315, i64 %.343.01188.i
  %.724.i = load double, ptr %.723.i, align 8, !noalias !78
  %.726.i = fmul double %share.3.2.i, %.724.i
  %.727.i = fadd double %.669.i, %.726.i
  %.781.i = getelementptr double, ptr %.490, i64 %.343.01188.i
  store double %.727.i, ptr %.781.i, align 8, !noalias !78
  br i1 %.8631184.not.i, label %B138.loopexit.i, label %B380.if.lr.ph.i

B380.if.lr.ph.i:                                  ; preds = %B138.if.i
  %.247.i.i = fsub double 1.000000e+00, %share.3.2.i
  %invariant.gep9211 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep9213 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep9215 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep9217 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep9219 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep9221 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep9223 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep9225 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep9227 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %or.cond9473.not = xor i1 %or.cond9473, true
  %brmerge9535 = select i1 %or.cond9473.not, i1 true, i1 %conflict.rdx9390
  br i1 %brmerge9535, label %B380.if.i.preheader, label %vector.ph9393

vector.ph9393:                                    ; preds = %B380.if.lr.ph.i
  %broadcast.splatinsert9396 = insertelement <2 x double> poison, double %.247.i.i, i64 0
  %broadcast.splat9397 = shufflevector <2 x double> %broadcast.splatinsert9396, <2 x double> poison, <2 x i32> zeroinitializer
  %broadcast.splatinsert9398 = insertelement <2 x double> poison, double %share.3.2.i, i64 0
  %broadcast.splat9399 = shufflevector <2 x double> %broadcast.splatinsert9398, <2 x double> poison, <2 x i32> zeroinitializer
  %invariant.gep9492 = getelementptr double, ptr %invariant.gep9211, i64 %.155.i.i
  %invariant.gep9494 = getelementptr double, ptr %invariant.gep9213, i64 %.155.i.1.i
  %invariant.gep9496 = getelementptr double, ptr %invariant.gep9215, i64 %.155.i.2.i
  %invariant.gep9498 = getelementptr double, ptr %invariant.gep9217, i64 %.155.i.3.i
  %invariant.gep9500 = getelementptr double, ptr %invariant.gep9219, i64 %.155.i.4.i
  %invariant.gep9502 = getelementptr double, ptr %invariant.gep9221, i64 %.155.i.5.i
  %invariant.gep9504 = getelementptr double, ptr %invariant.gep9223, i64 %.155.i.6.i
  %invariant.gep9506 = getelementptr double, ptr %invariant.gep9227, i64 %.935.i
  br label %vector.body9400

vector.body9400:                                  ; preds = %vector.body9400, %vector.ph9393
  %index9401 = phi i64 [ 0, %vector.ph9393 ], [ %index.next9410, %vector.body9400 ]
  %gep9493 = getelementptr double, ptr %invariant.gep9492, i64 %index9401
  %wide.load9402 = load <2 x double>, ptr %gep9493, align 8, !noalias !85
  %170 = fadd <2 x double> %wide.load9402, zeroinitializer
  %171 = fmul <2 x double> %broadcast.splat9399, %170
  %gep9495 = getelementptr double, ptr %invariant.gep9494, i64 %index9401
  %wide.load9403 = load <2 x double>, ptr %gep9495, align 8, !noalias !85
  %172 = fadd <2 x double> %wide.load9403, %171
  %173 = fmul <2 x double> %broadcast.splat9397, %172
  %gep9497 = getelementptr double, ptr %invariant.gep9496, i64 %index9401
  %wide.load9404 = load <2 x double>, ptr %gep9497, align 8, !noalias !85
  %174 = fadd <2 x double> %wide.load9404, %173
  %175 = fmul <2 x double> %broadcast.splat9399, %174
  %gep9499 = getelementptr double, ptr %invariant.gep9498, i64 %index9401
  %wide.load9405 = load <2 x double>, ptr %gep9499, align 8, !noalias !85
  %176 = fadd <2 x double> %wide.load9405, %175
  %177 = fmul <2 x double> %broadcast.splat9397, %176
  %gep9501 = getelementptr double, ptr %invariant.gep9500, i64 %index9401
  %wide.load9406 = load <2 x double>, ptr %gep9501, align 8, !noalias !85
  %178 = fadd <2 x double> %wide.load9406, %177
  %179 = fmul <2 x double> %broadcast.splat9399, %178
  %gep9503 = getelementptr double, ptr %invariant.gep9502, i64 %index9401
  %wide.load9407 = load <2 x double>, ptr %gep9503, align 8, !noalias !85
  %180 = fadd <2 x double> %wide.load9407, %179
  %181 = fmul <2 x double> %broadcast.splat9397, %180
  %gep9505 = getelementptr double, ptr %invariant.gep9504, i64 %index9401
  %wide.load9408 = load <2 x double>, ptr %gep9505, align 8, !noalias !85
  %182 = fadd <2 x double> %wide.load9408, %181
  %183 = fmul <2 x double> %broadcast.splat9399, %182
  %184 = getelementptr double, ptr %invariant.gep9225, i64 %index9401
  %wide.load9409 = load <2 x double>, ptr %184, align 8, !noalias !85
  %185 = fadd <2 x double> %wide.load9409, %183
  %gep9507 = getelementptr double, ptr %invariant.gep9506, i64 %index9401
  store <2 x double> %185, ptr %gep9507, align 8, !noalias !78
  %index.next9410 = add i64 %index9401, 2
  %186 = icmp eq i64 %index.next9410, %n.vec9395
  br i1 %186, label %middle.block9411, label %vector.body9400, !llvm.loop !89

middle.block9411:                                 ; preds = %vector.body9400
  br i1 %cmp.n9412, label %B138.loopexit.i, label %B380.if.i.preheader

B380.if.i.preheader:                              ; preds = %B380.if.lr.ph.i, %middle.block9411
  %.807.01185.i.ph = phi i64 [ %n.vec9395, %middle.block9411 ], [ 0, %B380.if.lr.ph.i ]
  br label %B380.if.i

B380.if.i:                                        ; preds = %B380.if.i.preheader, %B380.if.i
  %.807.01185.i = phi i64 [ %.876.i, %B380.if.i ], [ %.807.01185.i.ph, %B380.if.i.preheader ]
  %.157.i.i = add nsw i64 %.807.01185.i, %.155.i.i
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep9212 = getelementptr double, ptr %invariant.gep9211, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep9212, align 8, !noalias !85
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i = fmul double %share.3.2.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.807.01185.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep9214 = getelementptr double, ptr %invariant.gep9213, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep9214, align 8, !noalias !85
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.807.01185.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep9216 = getelementptr double, ptr %invariant.gep9215, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep9216, align 8, !noalias !85
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %share.3.2.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.807.01185.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep9218 = getelementptr double, ptr %invariant.gep9217, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep9218, align 8, !noalias !85
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.807.01185.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep9220 = getelementptr double, ptr %invariant.gep9219, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep9220, align 8, !noalias !85
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %share.3.2.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.807.01185.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep9222 = getelementptr double, ptr %invariant.gep9221, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep9222, align 8, !noalias !85
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.807.01185.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep9224 = getelementptr double, ptr %invariant.gep9223, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep9224, align 8, !noalias !85
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %share.3.2.i, %.193.i.6.i
  %.876.i = add nsw i64 %.807.01185.i, 1
  %.271.i.i8850 = mul nsw i64 %.807.01185.i, %arg.shape.0
  %gep9226 = getelementptr double, ptr %invariant.gep9225, i64 %.271.i.i8850
  %.309.i.i = load double, ptr %gep9226, align 8, !noalias !85
  %.313.i.i = fadd double %.309.i.i, %.253.i.6.i
  %.936.i = add nsw i64 %.807.01185.i, %.935.i
  %.938.i = mul nsw i64 %.936.i, %arg.shape.0
  %gep9228 = getelementptr double, ptr %invariant.gep9227, i64 %.938.i
  store double %.313.i.i, ptr %gep9228, align 8, !noalias !78
  %exitcond.not.i8851 = icmp eq i64 %arg.shape.1, %.876.i
  br i1 %exitcond.not.i8851, label %B138.loopexit.i, label %B380.if.i, !llvm.loop !90

B622.if.i:                                        ; preds = %B474.i, %B1498.i
  %.1157.01191.i = phi i64 [ %.1226.i, %B1498.i ], [ 0, %B474.i ]
  %.1226.i = add nsw i64 %.1157.01191.i, 1
  %.1307.i = getelementptr double, ptr %314, i64 %.1157.01191.i
  %.1308.i = load double, ptr %.1307.i, align 8, !noalias !78
  %.1309.i = fcmp oeq double %.1308.i, 1.000000e+00
  br i1 %.1309.i, label %B674.i8855, label %B1498.i

B874.if.i:                                        ; preds = %B842.i, %B1497.i
  %.1635.01195.i = phi i64 [ %.1705.i, %B1497.i ], [ 0, %B842.i ]
  %.1705.i = add nsw i64 %.1635.01195.i, 1
  %.1786.i = getelementptr double, ptr %316, i64 %.1635.01195.i
  %.1787.i = load double, ptr %.1786.i, align 8, !noalias !78
  %.1841.i = getelementptr double, ptr %.490, i64 %.1635.01195.i
  store double %.1787.i, ptr %.1841.i, align 8, !noalias !78
  %.1896.i = getelementptr double, ptr %314, i64 %.1635.01195.i
  %.1897.i = load double, ptr %.1896.i, align 8, !noalias !78
  %.1898.i = fcmp oeq double %.1897.i, 1.000000e+00
  br i1 %.1898.i, label %B978.i, label %B1497.i

B3282:                                            ; preds = %B1497.i, %B842.i, %B3238
  br i1 %.4734.not, label %B3324, label %B112.if.i

B110.loopexit.i.critedge:                         ; preds = %B112.if.i
  %.846.i.c = load i64, ptr %.845.i, align 8, !noalias !91
  %.963.i.c = inttoptr i64 %.846.i.c to ptr
  tail call void %.963.i.c(ptr %.490, ptr %.937.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !91
  br label %B110.loopexit.i

B110.loopexit.i:                                  ; preds = %B678.i, %B110.loopexit.i.critedge
  %exitcond671.not.i = icmp eq i64 %.292.i, 17
  br i1 %exitcond671.not.i, label %B3324, label %B112.if.i

B166.loopexit.i:                                  ; preds = %B288.if.i, %middle.block9370, %B166.if.i
  %exitcond669.not.i = icmp eq i64 %arg.shape.0, %.419.i
  br i1 %exitcond669.not.i, label %B382.i, label %B166.if.i

B382.i:                                           ; preds = %B166.loopexit.i
  %.846.i = load i64, ptr %.845.i, align 8, !noalias !91
  %.963.i = inttoptr i64 %.846.i to ptr
  tail call void %.963.i(ptr %.490, ptr %.937.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !91
  br label %B530.if.i

B572.i:                                           ; preds = %B530.if.i
  %187 = getelementptr double, ptr %arg.arrays.4.4, i64 %.989.0665.i
  %.1173.i = load double, ptr %187, align 8, !noalias !91
  %.1175.i = fcmp olt double %.1173.i, -1.000000e-09
  br i1 %.1175.i, label %B608.i, label %B678.i

B608.i:                                           ; preds = %B572.i
  %188 = getelementptr i64, ptr %arg.lane.1.4, i64 %.989.0665.i
  %.84.i35.i = load i64, ptr %188, align 8, !noalias !94
  %.89.i37.i = icmp sgt i64 %.84.i35.i, -1
  br i1 %.89.i37.i, label %B46.i.i8913, label %B608.endif.i

B46.i.i8913:                                      ; preds = %B608.i
  %.120.i51.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i35.i
  %.121.i.i8914 = load i64, ptr %.120.i51.i, align 8, !noalias !94
  %.122.i.i8915 = icmp eq i64 %.121.i.i8914, 0
  br i1 %.122.i.i8915, label %B80.i.i8916, label %B608.endif.i

B80.i.i8916:                                      ; preds = %B46.i.i8913
  store i64 4, ptr %.120.i51.i, align 8, !noalias !94
  br label %B608.endif.i

B678.i:                                           ; preds = %B608.endif.i, %B530.if.i, %B572.i
  %exitcond670.not.i = icmp eq i64 %arg.shape.0, %.1058.i8910
  br i1 %exitcond670.not.i, label %B110.loopexit.i, label %B530.if.i

B112.if.i:                                        ; preds = %B3282, %B110.loopexit.i
  %.220.0667.i = phi i64 [ %.292.i, %B110.loopexit.i ], [ 1, %B3282 ]
  %.292.i = add nsw i64 %.220.0667.i, 1
  %189 = uitofp i64 %.220.0667.i to double
  %190 = fmul double %189, 6.250000e-02
  br i1 %.274.i, label %B110.loopexit.i.critedge, label %B166.if.lr.ph.i

B166.if.lr.ph.i:                                  ; preds = %B112.if.i
  %.247.i.i8862 = fsub double 1.000000e+00, %190
  %broadcast.splatinsert = insertelement <2 x double> poison, double %190, i64 0
  %broadcast.splat = shufflevector <2 x double> %broadcast.splatinsert, <2 x double> poison, <2 x i32> zeroinitializer
  %broadcast.splatinsert9357 = insertelement <2 x double> poison, double %.247.i.i8862, i64 0
  %broadcast.splat9358 = shufflevector <2 x double> %broadcast.splatinsert9357, <2 x double> poison, <2 x i32> zeroinitializer
  br label %B166.if.i

B166.if.i:                                        ; preds = %B166.if.lr.ph.i, %B166.loopexit.i
  %.350.0662.i = phi i64 [ 0, %B166.if.lr.ph.i ], [ %.419.i, %B166.loopexit.i ]
  %.419.i = add nsw i64 %.350.0662.i, 1
  %.500.i = getelementptr double, ptr %arg.lane.0.4, i64 %.350.0662.i
  %.501.i = load double, ptr %.500.i, align 8, !noalias !91
  %.555.i = getelementptr double, ptr %320, i64 %.350.0662.i
  %.556.i = load double, ptr %.555.i, align 8, !noalias !91
  %.558.i = fmul double %190, %.556.i
  %.559.i = fadd double %.501.i, %.558.i
  %.613.i8863 = getelementptr double, ptr %.490, i64 %.350.0662.i
  store double %.559.i, ptr %.613.i8863, align 8, !noalias !91
  br i1 %.695658.not.i, label %B166.loopexit.i, label %B288.if.preheader.i

B288.if.preheader.i:                              ; preds = %B166.if.i
  %invariant.gep9229 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep9231 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep9233 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep9235 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep9237 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep9239 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep9241 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep9243 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep9245 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %or.cond9474.not = xor i1 %or.cond9474, true
  %brmerge9536 = select i1 %or.cond9474.not, i1 true, i1 %conflict.rdx9351
  br i1 %brmerge9536, label %B288.if.i.preheader, label %vector.ph9354

vector.ph9354:                                    ; preds = %B288.if.preheader.i
  %invariant.gep9508 = getelementptr double, ptr %invariant.gep9229, i64 %.155.i.i8864
  %invariant.gep9510 = getelementptr double, ptr %invariant.gep9231, i64 %.155.i.1.i8870
  %invariant.gep9512 = getelementptr double, ptr %invariant.gep9233, i64 %.155.i.2.i8876
  %invariant.gep9514 = getelementptr double, ptr %invariant.gep9235, i64 %.155.i.3.i8882
  %invariant.gep9516 = getelementptr double, ptr %invariant.gep9237, i64 %.155.i.4.i8888
  %invariant.gep9518 = getelementptr double, ptr %invariant.gep9239, i64 %.155.i.5.i8894
  %invariant.gep9520 = getelementptr double, ptr %invariant.gep9241, i64 %.155.i.6.i8900
  %invariant.gep9522 = getelementptr double, ptr %invariant.gep9245, i64 %.767.i
  br label %vector.body9359

vector.body9359:                                  ; preds = %vector.body9359, %vector.ph9354
  %index9360 = phi i64 [ 0, %vector.ph9354 ], [ %index.next9369, %vector.body9359 ]
  %gep9509 = getelementptr double, ptr %invariant.gep9508, i64 %index9360
  %wide.load9361 = load <2 x double>, ptr %gep9509, align 8, !noalias !97
  %191 = fadd <2 x double> %wide.load9361, zeroinitializer
  %192 = fmul <2 x double> %broadcast.splat, %191
  %gep9511 = getelementptr double, ptr %invariant.gep9510, i64 %index9360
  %wide.load9362 = load <2 x double>, ptr %gep9511, align 8, !noalias !97
  %193 = fadd <2 x double> %wide.load9362, %192
  %194 = fmul <2 x double> %broadcast.splat9358, %193
  %gep9513 = getelementptr double, ptr %invariant.gep9512, i64 %index9360
  %wide.load9363 = load <2 x double>, ptr %gep9513, align 8, !noalias !97
  %195 = fadd <2 x double> %wide.load9363, %194
  %196 = fmul <2 x double> %broadcast.splat, %195
  %gep9515 = getelementptr double, ptr %invariant.gep9514, i64 %index9360
  %wide.load9364 = load <2 x double>, ptr %gep9515, align 8, !noalias !97
  %197 = fadd <2 x double> %wide.load9364, %196
  %198 = fmul <2 x double> %broadcast.splat9358, %197
  %gep9517 = getelementptr double, ptr %invariant.gep9516, i64 %index9360
  %wide.load9365 = load <2 x double>, ptr %gep9517, align 8, !noalias !97
  %199 = fadd <2 x double> %wide.load9365, %198
  %200 = fmul <2 x double> %broadcast.splat, %199
  %gep9519 = getelementptr double, ptr %invariant.gep9518, i64 %index9360
  %wide.load9366 = load <2 x double>, ptr %gep9519, align 8, !noalias !97
  %201 = fadd <2 x double> %wide.load9366, %200
  %202 = fmul <2 x double> %broadcast.splat9358, %201
  %gep9521 = getelementptr double, ptr %invariant.gep9520, i64 %index9360
  %wide.load9367 = load <2 x double>, ptr %gep9521, align 8, !noalias !97
  %203 = fadd <2 x double> %wide.load9367, %202
  %204 = fmul <2 x double> %broadcast.splat, %203
  %205 = getelementptr double, ptr %invariant.gep9243, i64 %index9360
  %wide.load9368 = load <2 x double>, ptr %205, align 8, !noalias !97
  %206 = fadd <2 x double> %wide.load9368, %204
  %gep9523 = getelementptr double, ptr %invariant.gep9522, i64 %index9360
  store <2 x double> %206, ptr %gep9523, align 8, !noalias !91
  %index.next9369 = add i64 %index9360, 2
  %207 = icmp eq i64 %index.next9369, %n.vec9356
  br i1 %207, label %middle.block9370, label %vector.body9359, !llvm.loop !101

middle.block9370:                                 ; preds = %vector.body9359
  br i1 %cmp.n9371, label %B166.loopexit.i, label %B288.if.i.preheader

B288.if.i.preheader:                              ; preds = %B288.if.preheader.i, %middle.block9370
  %.639.0659.i.ph = phi i64 [ %n.vec9356, %middle.block9370 ], [ 0, %B288.if.preheader.i ]
  br label %B288.if.i

B288.if.i:                                        ; preds = %B288.if.i.preheader, %B288.if.i
  %.639.0659.i = phi i64 [ %.708.i, %B288.if.i ], [ %.639.0659.i.ph, %B288.if.i.preheader ]
  %.157.i.i8865 = add nsw i64 %.639.0659.i, %.155.i.i8864
  %.159.i.i8866 = mul nsw i64 %.157.i.i8865, %arg.shape.0
  %gep9230 = getelementptr double, ptr %invariant.gep9229, i64 %.159.i.i8866
  %.191.i.i8867 = load double, ptr %gep9230, align 8, !noalias !97
  %.193.i.i8868 = fadd double %.191.i.i8867, 0.000000e+00
  %.253.i.i8869 = fmul double %190, %.193.i.i8868
  %.157.i.1.i8871 = add nsw i64 %.639.0659.i, %.155.i.1.i8870
  %.159.i.1.i8872 = mul nsw i64 %.157.i.1.i8871, %arg.shape.0
  %gep9232 = getelementptr double, ptr %invariant.gep9231, i64 %.159.i.1.i8872
  %.191.i.1.i8873 = load double, ptr %gep9232, align 8, !noalias !97
  %.193.i.1.i8874 = fadd double %.191.i.1.i8873, %.253.i.i8869
  %.253.i.1.i8875 = fmul double %.247.i.i8862, %.193.i.1.i8874
  %.157.i.2.i8877 = add nsw i64 %.639.0659.i, %.155.i.2.i8876
  %.159.i.2.i8878 = mul nsw i64 %.157.i.2.i8877, %arg.shape.0
  %gep9234 = getelementptr double, ptr %invariant.gep9233, i64 %.159.i.2.i8878
  %.191.i.2.i8879 = load double, ptr %gep9234, align 8, !noalias !97
  %.193.i.2.i8880 = fadd double %.191.i.2.i8879, %.253.i.1.i8875
  %.253.i.2.i8881 = fmul double %190, %.193.i.2.i8880
  %.157.i.3.i8883 = add nsw i64 %.639.0659.i, %.155.i.3.i8882
  %.159.i.3.i8884 = mul nsw i64 %.157.i.3.i8883, %arg.shape.0
  %gep9236 = getelementptr double, ptr %invariant.gep9235, i64 %.159.i.3.i8884
  %.191.i.3.i8885 = load double, ptr %gep9236, align 8, !noalias !97
  %.193.i.3.i8886 = fadd double %.191.i.3.i8885, %.253.i.2.i8881
  %.253.i.3.i8887 = fmul double %.247.i.i8862, %.193.i.3.i8886
  %.157.i.4.i8889 = add nsw i64 %.639.0659.i, %.155.i.4.i8888
  %.159.i.4.i8890 = mul nsw i64 %.157.i.4.i8889, %arg.shape.0
  %gep9238 = getelementptr double, ptr %invariant.gep9237, i64 %.159.i.4.i8890
  %.191.i.4.i8891 = load double, ptr %gep9238, align 8, !noalias !97
  %.193.i.4.i8892 = fadd double %.191.i.4.i8891, %.253.i.3.i8887
  %.253.i.4.i8893 = fmul double %190, %.193.i.4.i8892
  %.157.i.5.i8895 = add nsw i64 %.639.0659.i, %.155.i.5.i8894
  %.159.i.5.i8896 = mul nsw i64 %.157.i.5.i8895, %arg.shape.0
  %gep9240 = getelementptr double, ptr %invariant.gep9239, i64 %.159.i.5.i8896
  %.191.i.5.i8897 = load double, ptr %gep9240, align 8, !noalias !97
  %.193.i.5.i8898 = fadd double %.191.i.5.i8897, %.253.i.4.i8893
  %.253.i.5.i8899 = fmul double %.247.i.i8862, %.193.i.5.i8898
  %.157.i.6.i8901 = add nsw i64 %.639.0659.i, %.155.i.6.i8900
  %.159.i.6.i8902 = mul nsw i64 %.157.i.6.i8901, %arg.shape.0
  %gep9242 = getelementptr double, ptr %invariant.gep9241, i64 %.159.i.6.i8902
  %.191.i.6.i8903 = load double, ptr %gep9242, align 8, !noalias !97
  %.193.i.6.i8904 = fadd double %.191.i.6.i8903, %.253.i.5.i8899
  %.253.i.6.i8905 = fmul double %190, %.193.i.6.i8904
  %.708.i = add nsw i64 %.639.0659.i, 1
  %.271.i.i8906 = mul nsw i64 %.639.0659.i, %arg.shape.0
  %gep9244 = getelementptr double, ptr %invariant.gep9243, i64 %.271.i.i8906
  %.309.i.i8907 = load double, ptr %gep9244, align 8, !noalias !97
  %.313.i.i8908 = fadd double %.309.i.i8907, %.253.i.6.i8905
  %.768.i = add nsw i64 %.639.0659.i, %.767.i
  %.770.i = mul nsw i64 %.768.i, %arg.shape.0
  %gep9246 = getelementptr double, ptr %invariant.gep9245, i64 %.770.i
  store double %.313.i.i8908, ptr %gep9246, align 8, !noalias !91
  %exitcond.not.i8909 = icmp eq i64 %arg.shape.1, %.708.i
  br i1 %exitcond.not.i8909, label %B166.loopexit.i, label %B288.if.i, !llvm.loop !102

B530.if.i:                                        ; preds = %B382.i, %B678.i
  %.989.0665.i = phi i64 [ %.1058.i8910, %B678.i ], [ 0, %B382.i ]
  %.1058.i8910 = add nsw i64 %.989.0665.i, 1
  %208 = getelementptr double, ptr %321, i64 %.989.0665.i
  %.1140.i8911 = load double, ptr %208, align 8, !noalias !91
  %.1141.i8912 = fcmp ogt double %.1140.i8911, 5.000000e-01
  br i1 %.1141.i8912, label %B572.i, label %B678.i

B608.endif.i:                                     ; preds = %B80.i.i8916, %B46.i.i8913, %B608.i
  store double 0.000000e+00, ptr %208, align 8, !noalias !91
  br label %B678.i

B3324:                                            ; preds = %B110.loopexit.i, %B2782, %B3282
  br i1 %wanted.2.1, label %B3332, label %B3384

B3332:                                            ; preds = %B3324
  %within.5.1.not = xor i1 %within.5.1, true
  %brmerge8801 = select i1 %within.5.1.not, i1 true, i1 %.539
  %"$phi3368.7.2.2" = select i1 %brmerge8801, i64 0, i64 3
  br i1 %.274.i, label %B3384, label %B76.if.i

B152.i:                                           ; preds = %B76.if.i
  %.445.i = getelementptr double, ptr %323, i64 %.173.0654.i
  %.446.i = load double, ptr %.445.i, align 8, !noalias !103
  %.447.i = fcmp olt double %.446.i, 5.000000e-01
  br i1 %.447.i, label %B769.i, label %B190.i8921

B190.i8921:                                       ; preds = %B152.i
  %.478.i = getelementptr i64, ptr %arg.results.1.4, i64 %.327.i8918
  %.479.i8922 = load i64, ptr %.478.i, align 8, !noalias !103
  %.480.not.i = icmp eq i64 %.479.i8922, 0
  br i1 %.480.not.i, label %B226.i, label %B769.i

B226.i:                                           ; preds = %B190.i8921
  %.542.i = mul i64 %.327.i8918, %arg.results.3.5.1
  %209 = getelementptr i64, ptr %arg.results.3.4, i64 %.542.i
  %.546.i = getelementptr i8, ptr %209, i64 8
  %.547.i = load i64, ptr %.546.i, align 8, !noalias !103
  %.549.i8923 = add nsw i64 %.547.i, %"$phi3368.7.2.2"
  store i64 %.549.i8923, ptr %.546.i, align 8, !noalias !103
  %.655.i = getelementptr double, ptr %arg.lane.0.4, i64 %.173.0654.i
  %.656.i = load double, ptr %.655.i, align 8, !noalias !103
  %.710.i = getelementptr double, ptr %324, i64 %.173.0654.i
  %.711.i8924 = load double, ptr %.710.i, align 8, !noalias !103
  %.765.i = getelementptr double, ptr %325, i64 %.173.0654.i
  %.766.i8925 = load double, ptr %.765.i, align 8, !noalias !103
  %.787.i8926 = icmp slt i64 %.382.i8919, %arg.times.5.0
  br i1 %.787.i8926, label %B400.i, label %B740.i

B400.i:                                           ; preds = %B226.i
  %.810.i = icmp slt i64 %.382.i8919, 0
  %.811.i = select i1 %.810.i, i64 %arg.times.5.0, i64 0
  %210 = getelementptr double, ptr %arg.times.4, i64 %.382.i8919
  %.825.i = getelementptr double, ptr %210, i64 %.811.i
  %.826.i = load double, ptr %.825.i, align 8, !noalias !103
  %.830.i8927 = fcmp ugt double %.826.i, %.766.i8925
  br i1 %.830.i8927, label %B740.i, label %B424.preheader.i

B424.preheader.i:                                 ; preds = %B400.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul652.i, %.327.i8918
  %.1317.i = getelementptr double, ptr %326, i64 %.173.0654.i
  %211 = getelementptr double, ptr %arg.results.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep9247 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0654.i
  %invariant.gep9249 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0654.i
  %invariant.gep9251 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0654.i
  %invariant.gep9253 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0654.i
  %invariant.gep9255 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0654.i
  %invariant.gep9257 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0654.i
  %invariant.gep9259 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0654.i
  %invariant.gep9261 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0654.i
  %invariant.gep9263 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0654.i
  br label %B424.i

B424.i:                                           ; preds = %B716.i, %B424.preheader.i
  %done.2.3.i = phi i64 [ %.1255.i, %B716.i ], [ %.382.i8919, %B424.preheader.i ]
  br i1 %.917649.not.i, label %B624.i, label %B454.if.lr.ph.i

B454.if.lr.ph.i:                                  ; preds = %B424.i
  %.972.i = icmp slt i64 %done.2.3.i, 0
  %.973.i = select i1 %.972.i, i64 %arg.times.5.0, i64 0
  %212 = getelementptr double, ptr %arg.times.4, i64 %done.2.3.i
  %.987.i = getelementptr double, ptr %212, i64 %.973.i
  %.1213.i = select i1 %.972.i, i64 %arg.results.0.5.1, i64 0
  %.1214.i = add i64 %.1213.i, %done.2.3.i
  %.1243.i = mul i64 %.1214.i, %arg.results.0.5.2
  %213 = getelementptr double, ptr %211, i64 %.1243.i
  br label %B454.if.i

B482.i:                                           ; preds = %B454.if.i
  %.995.i8976 = add nsw i64 %.861.0650.i, %.993.i
  %.997.i = mul nsw i64 %.995.i8976, %arg.shape.0
  %gep9264 = getelementptr double, ptr %invariant.gep9263, i64 %.997.i
  %.1029.i8977 = load double, ptr %gep9264, align 8, !noalias !103
  br label %B770.i

B624.i:                                           ; preds = %B770.i, %B424.i
  store double 0x7FF0000000000000, ptr %.1317.i, align 8, !noalias !103
  %exitcond656.not.i = icmp eq i64 %done.2.3.i, %327
  br i1 %exitcond656.not.i, label %B740.i, label %B716.i

B716.i:                                           ; preds = %B624.i
  %.1255.i = add i64 %done.2.3.i, 1
  %.1352.i = icmp slt i64 %done.2.3.i, -1
  %.1353.i = select i1 %.1352.i, i64 %arg.times.5.0, i64 0
  %214 = getelementptr double, ptr %arg.times.4, i64 %.1255.i
  %.1367.i = getelementptr double, ptr %214, i64 %.1353.i
  %.1368.i = load double, ptr %.1367.i, align 8, !noalias !103
  %.1372.i = fcmp ugt double %.1368.i, %.766.i8925
  br i1 %.1372.i, label %B740.i, label %B424.i

B740.i:                                           ; preds = %B716.i, %B624.i, %B400.i, %B226.i
  %done.3.2.i = phi i64 [ %.382.i8919, %B400.i ], [ %.382.i8919, %B226.i ], [ %arg.times.5.0, %B624.i ], [ %.1255.i, %B716.i ]
  store i64 %done.3.2.i, ptr %.381.i, align 8, !noalias !103
  br label %B769.i

B769.i:                                           ; preds = %B76.if.i, %B740.i, %B190.i8921, %B152.i
  %exitcond657.not.i = icmp eq i64 %.245.i, %arg.shape.0
  br i1 %exitcond657.not.i, label %B3384, label %B76.if.i

B770.i:                                           ; preds = %B38.if.i.i, %B482.i
  %.313.i.i8974.sink = phi double [ %.313.i.i8974, %B38.if.i.i ], [ %.1029.i8977, %B482.i ]
  %215 = getelementptr double, ptr %213, i64 %.861.0650.i
  store double %.313.i.i8974.sink, ptr %215, align 8, !noalias !103
  %exitcond.not.i8975 = icmp eq i64 %arg.shape.1, %.930.i
  br i1 %exitcond.not.i8975, label %B624.i, label %B454.if.i

B76.if.i:                                         ; preds = %B3332, %B769.i
  %.173.0654.i = phi i64 [ %.245.i, %B769.i ], [ 0, %B3332 ]
  %.245.i = add nsw i64 %.173.0654.i, 1
  %.326.i = getelementptr i64, ptr %arg.lane.1.4, i64 %.173.0654.i
  %.327.i8918 = load i64, ptr %.326.i, align 8, !noalias !103
  %.381.i = getelementptr i64, ptr %322, i64 %.173.0654.i
  %.382.i8919 = load i64, ptr %.381.i, align 8, !noalias !103
  %.390.i8920 = icmp slt i64 %.327.i8918, 0
  br i1 %.390.i8920, label %B769.i, label %B152.i

B454.if.i:                                        ; preds = %B770.i, %B454.if.lr.ph.i
  %.861.0650.i = phi i64 [ 0, %B454.if.lr.ph.i ], [ %.930.i, %B770.i ]
  %.930.i = add nsw i64 %.861.0650.i, 1
  %.988.i = load double, ptr %.987.i, align 8, !noalias !103
  %.990.i = fcmp oeq double %.988.i, %.766.i8925
  br i1 %.990.i, label %B482.i, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B454.if.i
  %.1138.i = fsub double %.988.i, %.656.i
  %.1143.i = fdiv double %.1138.i, %.711.i8924
  %.247.i.i8929 = fsub double 1.000000e+00, %.1143.i
  %.157.i.i8931 = add nsw i64 %.861.0650.i, %.155.i.i8930
  %.159.i.i8932 = mul nsw i64 %.157.i.i8931, %arg.shape.0
  %gep9248 = getelementptr double, ptr %invariant.gep9247, i64 %.159.i.i8932
  %.191.i.i8933 = load double, ptr %gep9248, align 8, !noalias !106
  %.193.i.i8934 = fadd double %.191.i.i8933, 0.000000e+00
  %.253.i.i8935 = fmul double %.1143.i, %.193.i.i8934
  %.157.i.1.i8937 = add nsw i64 %.861.0650.i, %.155.i.1.i8936
  %.159.i.1.i8938 = mul nsw i64 %.157.i.1.i8937, %arg.shape.0
  %gep9250 = getelementptr double, ptr %invariant.gep9249, i64 %.159.i.1.i8938
  %.191.i.1.i8939 = load double, ptr %gep9250, align 8, !noalias !106
  %.193.i.1.i8940 = fadd double %.191.i.1.i8939, %.253.i.i8935
  %.253.i.1.i8941 = fmul double %.247.i.i8929, %.193.i.1.i8940
  %.157.i.2.i8943 = add nsw i64 %.861.0650.i, %.155.i.2.i8942
  %.159.i.2.i8944 = mul nsw i64 %.157.i.2.i8943, %arg.shape.0
  %gep9252 = getelementptr double, ptr %invariant.gep9251, i64 %.159.i.2.i8944
  %.191.i.2.i8945 = load double, ptr %gep9252, align 8, !noalias !106
  %.193.i.2.i8946 = fadd double %.191.i.2.i8945, %.253.i.1.i8941
  %.253.i.2.i8947 = fmul double %.1143.i, %.193.i.2.i8946
  %.157.i.3.i8949 = add nsw i64 %.861.0650.i, %.155.i.3.i8948
  %.159.i.3.i8950 = mul nsw i64 %.157.i.3.i8949, %arg.shape.0
  %gep9254 = getelementptr double, ptr %invariant.gep9253, i64 %.159.i.3.i8950
  %.191.i.3.i8951 = load double, ptr %gep9254, align 8, !noalias !106
  %.193.i.3.i8952 = fadd double %.191.i.3.i8951, %.253.i.2.i8947
  %.253.i.3.i8953 = fmul double %.247.i.i8929, %.193.i.3.i8952
  %.157.i.4.i8955 = add nsw i64 %.861.0650.i, %.155.i.4.i8954
  %.159.i.4.i8956 = mul nsw i64 %.157.i.4.i8955, %arg.shape.0
  %gep9256 = getelementptr double, ptr %invariant.gep9255, i64 %.159.i.4.i8956
  %.191.i.4.i8957 = load double, ptr %gep9256, align 8, !noalias !106
  %.193.i.4.i8958 = fadd double %.191.i.4.i8957, %.253.i.3.i8953
  %.253.i.4.i8959 = fmul double %.1143.i, %.193.i.4.i8958
  %.157.i.5.i8961 = add nsw i64 %.861.0650.i, %.155.i.5.i8960
  %.159.i.5.i8962 = mul nsw i64 %.157.i.5.i8961, %arg.shape.0
  %gep9258 = getelementptr double, ptr %invariant.gep9257, i64 %.159.i.5.i8962
  %.191.i.5.i8963 = load double, ptr %gep9258, align 8, !noalias !106
  %.193.i.5.i8964 = fadd double %.191.i.5.i8963, %.253.i.4.i8959
  %.253.i.5.i8965 = fmul double %.247.i.i8929, %.193.i.5.i8964
  %.157.i.6.i8967 = add nsw i64 %.861.0650.i, %.155.i.6.i8966
  %.159.i.6.i8968 = mul nsw i64 %.157.i.6.i8967, %arg.shape.0
  %gep9260 = getelementptr double, ptr %invariant.gep9259, i64 %.159.i.6.i8968
  %.191.i.6.i8969 = load double, ptr %gep9260, align 8, !noalias !106
  %.193.i.6.i8970 = fadd double %.191.i.6.i8969, %.253.i.5.i8965
  %.253.i.6.i8971 = fmul double %.1143.i, %.193.i.6.i8970
  %.271.i.i8972 = mul nsw i64 %.861.0650.i, %arg.shape.0
  %gep9262 = getelementptr double, ptr %invariant.gep9261, i64 %.271.i.i8972
  %.309.i.i8973 = load double, ptr %gep9262, align 8, !noalias !106
  %.313.i.i8974 = fadd double %.309.i.i8973, %.253.i.6.i8971
  br label %B770.i

B3384:                                            ; preds = %B769.i, %B3332, %B3324
  %.4961 = load i64, ptr %.4960, align 8
  %.5006 = inttoptr i64 %.4961 to ptr
  tail call void %.5006(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %beyond.2.1.not = xor i1 %beyond.2.1, true
  %brmerge9296 = or i1 %.274.i, %beyond.2.1.not
  br i1 %brmerge9296, label %B3496, label %B60.if.i

B114.i:                                           ; preds = %B60.if.i
  %.344.i3825 = getelementptr double, ptr %329, i64 %.134.i3622.09272
  %.345.i3826 = load double, ptr %.344.i3825, align 8, !noalias !110
  %.346.i3827 = fcmp ogt double %.345.i3826, 5.000000e-01
  br i1 %.346.i3827, label %B154.i, label %B720.i

B154.i:                                           ; preds = %B114.i
  %.401.i3875 = getelementptr double, ptr %arg.lane.0.4, i64 %.134.i3622.09272
  %.402.i3876 = load double, ptr %.401.i3875, align 8, !noalias !110
  %.456.i3924 = getelementptr double, ptr %330, i64 %.134.i3622.09272
  %.457.i3925 = load double, ptr %.456.i3924, align 8, !noalias !110
  %.458.i3926 = fsub double %.402.i3876, %.457.i3925
  br i1 %.545.i39659265.not, label %B360.i, label %B250.if.i.preheader

B250.if.i.preheader:                              ; preds = %B154.i
  %invariant.gep9524 = getelementptr double, ptr %arg.arrays.0.4, i64 %.134.i3622.09272
  br label %B250.if.i

B360.i:                                           ; preds = %B250.if.i, %B154.i
  %fastest.2.i.2.lcssa = phi double [ 0.000000e+00, %B154.i ], [ %.11.i.i, %B250.if.i ]
  %.659.i3977 = fmul double %.458.i3926, %fastest.2.i.2.lcssa
  %.691.i4003 = load double, ptr %.690.i4002, align 8, !noalias !110
  %.692.i4004 = fcmp ogt double %.659.i3977, %.691.i4003
  %.8802 = select i1 %.692.i4004, double 0x3E7AD7F29ABCAF48, double 5.000000e-06
  %.736.i4032 = load double, ptr %.735.i4031, align 8, !noalias !110
  %.766.i4055 = load double, ptr %arg.times.4, align 8, !noalias !110
  %.767.i4056 = fsub double %.736.i4032, %.766.i4055
  %.769.i4058 = fmul double %.8802, %.767.i4056
  %.773.i4061 = fcmp olt double %.458.i3926, %.769.i4058
  br i1 %.773.i4061, label %B470.i, label %B508.i

B470.i:                                           ; preds = %B360.i
  %216 = getelementptr i64, ptr %332, i64 %.134.i3622.09272
  %.831.i4473 = load i64, ptr %216, align 8, !noalias !110
  %.832.i4474 = add nsw i64 %.831.i4473, 1
  br label %B508.i

B508.i:                                           ; preds = %B360.i, %B470.i
  %"$phi508.1.2.i.2" = phi i64 [ %.832.i4474, %B470.i ], [ 0, %B360.i ]
  %217 = getelementptr i64, ptr %333, i64 %.134.i3622.09272
  store i64 %"$phi508.1.2.i.2", ptr %217, align 8, !noalias !110
  %.952.i = load double, ptr %.401.i3875, align 8, !noalias !110
  store double %.952.i, ptr %.456.i3924, align 8, !noalias !110
  %.1061.i4236 = getelementptr double, ptr %334, i64 %.134.i3622.09272
  store double 1.000000e+00, ptr %.1061.i4236, align 8, !noalias !110
  store i64 1, ptr %.722, align 8, !noalias !110
  %.1147.i4287 = load i64, ptr %217, align 8, !noalias !110
  %.1148.i = icmp sgt i64 %.1147.i4287, 1000
  br i1 %.1148.i, label %B674.i, label %B720.i

B674.i:                                           ; preds = %B508.i
  %218 = getelementptr i64, ptr %arg.lane.1.4, i64 %.134.i3622.09272
  %.84.i.i4364 = load i64, ptr %218, align 8, !noalias !114
  %.89.i.i4367 = icmp sgt i64 %.84.i.i4364, -1
  br i1 %.89.i.i4367, label %B46.i.i4375, label %B720.i

B46.i.i4375:                                      ; preds = %B674.i
  %.120.i.i4395 = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i.i4364
  %.121.i.i4396 = load i64, ptr %.120.i.i4395, align 8, !noalias !114
  %.122.i.i4397 = icmp eq i64 %.121.i.i4396, 0
  br i1 %.122.i.i4397, label %B80.i.i4402, label %B720.i

B80.i.i4402:                                      ; preds = %B46.i.i4375
  store i64 6, ptr %.120.i.i4395, align 8, !noalias !114
  br label %B720.i

B720.i:                                           ; preds = %B80.i.i4402, %B674.i, %B46.i.i4375, %B508.i, %B114.i, %B60.if.i
  %.193.i3706 = icmp sgt i64 %.137.i3623.09271, 1
  br i1 %.193.i3706, label %B60.if.i, label %B3496

B60.if.i:                                         ; preds = %B3384, %B720.i
  %.134.i3622.09272 = phi i64 [ %.206.i4544, %B720.i ], [ 0, %B3384 ]
  %.137.i3623.09271 = phi i64 [ %.202.i4541, %B720.i ], [ %storemerge, %B3384 ]
  %.202.i4541 = add nsw i64 %.137.i3623.09271, -1
  %.206.i4544 = add nsw i64 %.134.i3622.09272, 1
  %.287.i3775 = getelementptr double, ptr %328, i64 %.134.i3622.09272
  %.288.i3776 = load double, ptr %.287.i3775, align 8, !noalias !110
  %.289.i3777 = fcmp oeq double %.288.i3776, 2.000000e+00
  br i1 %.289.i3777, label %B114.i, label %B720.i

B250.if.i:                                        ; preds = %B250.if.i.preheader, %B250.if.i
  %fastest.2.i.29268 = phi double [ %.11.i.i, %B250.if.i ], [ 0.000000e+00, %B250.if.i.preheader ]
  %.489.i3637.09267 = phi i64 [ %.558.i4529, %B250.if.i ], [ 0, %B250.if.i.preheader ]
  %.558.i4529 = add nsw i64 %.489.i3637.09267, 1
  %.585.i4481 = add nsw i64 %.489.i3637.09267, %arg.shape.1
  %.587.i4483 = mul nsw i64 %.585.i4481, %arg.shape.0
  %gep9525 = getelementptr double, ptr %invariant.gep9524, i64 %.587.i4483
  %.619.i4511 = load double, ptr %gep9525, align 8, !noalias !110
  %.620.i4512 = tail call double @llvm.fabs.f64(double %.619.i4511)
  %.10.i.i = fcmp ogt double %.620.i4512, %fastest.2.i.29268
  %.11.i.i = select i1 %.10.i.i, double %.620.i4512, double %fastest.2.i.29268
  %exitcond9310.not = icmp eq i64 %arg.shape.1, %.558.i4529
  br i1 %exitcond9310.not, label %B360.i, label %B250.if.i

B3496:                                            ; preds = %B720.i, %B3384
  %brmerge8803.not = select i1 %.5066.not, i1 %looked.2.1.lcssa, i1 false
  %brmerge8803.not.not = xor i1 %brmerge8803.not, true
  %brmerge9295 = or i1 %.274.i, %brmerge8803.not.not
  br i1 %brmerge9295, label %B3550, label %B110.if.i

B46.i.i8978:                                      ; preds = %B110.if.i
  %.135.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !117
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i8989, label %B358.i8979

B80.i.i8989:                                      ; preds = %B46.i.i8978
  %.196.i.i = getelementptr double, ptr %335, i64 %.352.01856.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !117
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B358.i8979, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i8989
  %.264.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.352.01856.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !117
  %.321.i.i = getelementptr double, ptr %336, i64 %.352.01856.i
  %.322.i.i = load double, ptr %.321.i.i, align 8, !noalias !117
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.7511852.not.i
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01858.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01858.i
  br i1 %brmerge.i, label %B358.i8979, label %B300.if.lr.ph.i

B300.if.lr.ph.i:                                  ; preds = %B122.i.i
  %.650.i = getelementptr i64, ptr %337, i64 %.352.01856.i
  %.651.i = load i64, ptr %.650.i, align 8, !noalias !122
  %.652.i = add nsw i64 %.651.i, 1
  %219 = getelementptr i64, ptr %arg.runs.2.4, i64 %.99.i.i
  %.596.i = load i64, ptr %219, align 8, !noalias !122
  %.822.i8991 = icmp slt i64 %.596.i, 0
  %.823.i8992 = select i1 %.822.i8991, i64 %arg.schedule.3.5.0, i64 0
  %.824.i = add i64 %.823.i8992, %.596.i
  %.825.i8993 = icmp slt i64 %.651.i, -1
  %.826.i8994 = select i1 %.825.i8993, i64 %arg.schedule.3.5.1, i64 0
  %.827.i = add i64 %.652.i, %.826.i8994
  %.854.i = mul i64 %.852.i, %.824.i
  %.856.i = mul i64 %.827.i, %arg.schedule.3.5.2
  %220 = getelementptr double, ptr %arg.schedule.3.4, i64 %.854.i
  %221 = getelementptr double, ptr %220, i64 %.856.i
  br label %B300.if.i

B358.i8979:                                       ; preds = %B300.if.i, %B110.if.i, %B122.i.i, %B80.i.i8989, %B46.i.i8978
  %some.3.2.i = phi i1 [ %some.2.01858.i, %B80.i.i8989 ], [ %some.2.01858.mux.i, %B122.i.i ], [ %some.2.01858.i, %B46.i.i8978 ], [ %some.2.01858.i, %B110.if.i ], [ true, %B300.if.i ]
  %exitcond1870.not.i = icmp eq i64 %arg.shape.0, %.423.i
  br i1 %exitcond1870.not.i, label %B360.i8980, label %B110.if.i

B360.i8980:                                       ; preds = %B358.i8979
  br i1 %some.3.2.i, label %B368.i, label %B3550

B368.i:                                           ; preds = %B360.i8980
  %.1018.i = load i64, ptr %.1017.i, align 8, !noalias !122
  %.1130.i = inttoptr i64 %.1018.i to ptr
  tail call void %.1130.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !122
  %.1161.i = load i64, ptr %.1160.i, align 8, !noalias !122
  %.1277.i = inttoptr i64 %.1161.i to ptr
  tail call void %.1277.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1276.i), !noalias !122
  br label %B600.if.i

B46.i82.i:                                        ; preds = %B600.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !123
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B980.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %335, i64 %.1303.01865.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !123
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B980.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1303.01865.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !123
  %.321.i223.i = getelementptr double, ptr %336, i64 %.1303.01865.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !123
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B980.i, label %B640.i

B640.i:                                           ; preds = %B122.i147.i
  %.1557.i = getelementptr i64, ptr %338, i64 %.1303.01865.i
  %.1558.i = load i64, ptr %.1557.i, align 8, !noalias !122
  %.1569.i = icmp sgt i64 %.1558.i, 0
  br i1 %.1569.i, label %B716.i8988, label %B770.i8986

B716.i8988:                                       ; preds = %B640.i
  %222 = getelementptr double, ptr %arg.times.4, i64 %.1558.i
  %.1604.i = getelementptr i8, ptr %222, i64 -8
  %.1605.i = load double, ptr %.1604.i, align 8, !noalias !122
  %.1661.i = fcmp oeq double %.1605.i, %.265.i185.i
  br label %B770.i8986

B770.i8986:                                       ; preds = %B716.i8988, %B640.i
  %"$phi770.1.2.1.i" = phi i1 [ %.1661.i, %B716.i8988 ], [ false, %B640.i ]
  br i1 %.17571859.not.i, label %B980.i, label %B802.if.lr.ph.i

B802.if.lr.ph.i:                                  ; preds = %B770.i8986
  %.1887.i = add nsw i64 %.1558.i, -1
  %.1926.i = select i1 %.1569.i, i64 0, i64 %arg.results.0.5.1
  %.1927.i = add i64 %.1887.i, %.1926.i
  %.1954.i8987 = mul i64 %.1952.i, %.99.i78.i
  %.1956.i = mul i64 %.1927.i, %arg.results.0.5.2
  %223 = getelementptr double, ptr %arg.results.0.4, i64 %.1954.i8987
  %224 = getelementptr double, ptr %223, i64 %.1956.i
  %invariant.gep9273 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1303.01865.i
  %invariant.gep9275 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1303.01865.i
  br label %B802.if.i

B898.i:                                           ; preds = %B802.if.i
  %225 = getelementptr double, ptr %224, i64 %.1701.01860.i
  store double %.1835.i, ptr %225, align 8, !noalias !122
  br label %B920.i

B920.i:                                           ; preds = %B802.if.i, %B898.i
  %exitcond1871.not.i = icmp eq i64 %arg.shape.1, %.1770.i
  br i1 %exitcond1871.not.i, label %B922.loopexit.i, label %B802.if.i

B922.loopexit.i:                                  ; preds = %B920.i
  %226 = fcmp une double %.1842.i, 0.000000e+00
  br i1 %226, label %B934.i, label %B980.i

B934.i:                                           ; preds = %B922.loopexit.i
  %.84.i516.i = load i64, ptr %232, align 8, !noalias !126
  %.89.i518.i = icmp sgt i64 %.84.i516.i, -1
  br i1 %.89.i518.i, label %B46.i521.i, label %B980.i

B46.i521.i:                                       ; preds = %B934.i
  %.120.i539.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i516.i
  %.121.i540.i = load i64, ptr %.120.i539.i, align 8, !noalias !126
  %.122.i541.i = icmp eq i64 %.121.i540.i, 0
  br i1 %.122.i541.i, label %B80.i545.i, label %B980.i

B80.i545.i:                                       ; preds = %B46.i521.i
  store i64 3, ptr %.120.i539.i, align 8, !noalias !126
  br label %B980.i

B980.i:                                           ; preds = %B600.if.i, %B80.i545.i, %B46.i521.i, %B934.i, %B922.loopexit.i, %B770.i8986, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %exitcond1872.not.i = icmp eq i64 %arg.shape.0, %.1372.i8984
  br i1 %exitcond1872.not.i, label %B982.i, label %B600.if.i

B982.i:                                           ; preds = %B980.i
  br i1 %.2041.not.i, label %B3550, label %B986.i

B986.i:                                           ; preds = %B982.i
  %.2074.i = load i64, ptr %.2073.i, align 8, !noalias !122
  %.2188.i = inttoptr i64 %.2074.i to ptr
  tail call void %.2188.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !122
  br label %B1106.if.i

B46.i315.i:                                       ; preds = %B1106.if.i
  %.135.i335.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i311.i
  %.136.i336.i = load i64, ptr %.135.i335.i, align 8, !noalias !129
  %.141.i339.not.i = icmp eq i64 %.136.i336.i, 0
  br i1 %.141.i339.not.i, label %B80.i340.i, label %B1228.i

B80.i340.i:                                       ; preds = %B46.i315.i
  %.196.i377.i = getelementptr double, ptr %335, i64 %.2224.01868.i
  %.197.i378.i = load double, ptr %.196.i377.i, align 8, !noalias !129
  %.198.i379.i = fcmp olt double %.197.i378.i, 5.000000e-01
  br i1 %.198.i379.i, label %B1228.i, label %B122.i380.i

B122.i380.i:                                      ; preds = %B80.i340.i
  %.264.i417.i = getelementptr double, ptr %arg.lane.0.4, i64 %.2224.01868.i
  %.265.i418.i = load double, ptr %.264.i417.i, align 8, !noalias !129
  %.321.i456.i = getelementptr double, ptr %336, i64 %.2224.01868.i
  %.322.i457.i = load double, ptr %.321.i456.i, align 8, !noalias !129
  %.325.i459.i = fcmp une double %.265.i418.i, %.322.i457.i
  br i1 %.325.i459.i, label %B1228.i, label %B1146.i

B1146.i:                                          ; preds = %B122.i380.i
  %227 = getelementptr double, ptr %arg.arrays.4.4, i64 %.2224.01868.i
  %.2400.i = load double, ptr %227, align 8, !noalias !122
  %.2402.i = fcmp olt double %.2400.i, -1.000000e-09
  br i1 %.2402.i, label %B80.i672.i, label %B1228.i

B80.i672.i:                                       ; preds = %B1146.i
  store i64 4, ptr %.135.i335.i, align 8, !noalias !132
  br label %B1228.i

B1228.i:                                          ; preds = %B1106.if.i, %B80.i672.i, %B1146.i, %B122.i380.i, %B80.i340.i, %B46.i315.i
  %exitcond9311.not = icmp eq i64 %arg.shape.0, %.2293.i
  br i1 %exitcond9311.not, label %B3550, label %B1106.if.i

B110.if.i:                                        ; preds = %B3496, %B358.i8979
  %some.2.01858.i = phi i1 [ %some.3.2.i, %B358.i8979 ], [ false, %B3496 ]
  %.352.01856.i = phi i64 [ %.423.i, %B358.i8979 ], [ 0, %B3496 ]
  %.423.i = add nsw i64 %.352.01856.i, 1
  %228 = getelementptr i64, ptr %arg.lane.1.4, i64 %.352.01856.i
  %.99.i.i = load i64, ptr %228, align 8, !noalias !117
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B358.i8979, label %B46.i.i8978

B300.if.i:                                        ; preds = %B300.if.i, %B300.if.lr.ph.i
  %.692.01853.i = phi i64 [ 0, %B300.if.lr.ph.i ], [ %.764.i, %B300.if.i ]
  %.764.i = add nsw i64 %.692.01853.i, 1
  %229 = getelementptr double, ptr %221, i64 %.692.01853.i
  %.861.i = load double, ptr %229, align 8, !noalias !122
  %230 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.692.01853.i
  %.891.i = load i64, ptr %230, align 8, !noalias !122
  %.893.i = mul nsw i64 %.891.i, %arg.shape.0
  %.895.i = add nsw i64 %.893.i, %.352.01856.i
  %.909.i = icmp slt i64 %.895.i, 0
  %.910.i = select i1 %.909.i, i64 %arg.arrays.1.5.0, i64 0
  %231 = getelementptr double, ptr %arg.arrays.1.4, i64 %.895.i
  %.924.i = getelementptr double, ptr %231, i64 %.910.i
  store double %.861.i, ptr %.924.i, align 8, !noalias !122
  %exitcond.not.i8995 = icmp eq i64 %arg.schedule.2.5.0, %.764.i
  br i1 %exitcond.not.i8995, label %B358.i8979, label %B300.if.i

B600.if.i:                                        ; preds = %B980.i, %B368.i
  %.1303.01865.i = phi i64 [ 0, %B368.i ], [ %.1372.i8984, %B980.i ]
  %.1372.i8984 = add nsw i64 %.1303.01865.i, 1
  %232 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1303.01865.i
  %.99.i78.i = load i64, ptr %232, align 8, !noalias !123
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B980.i, label %B46.i82.i

B802.if.i:                                        ; preds = %B920.i, %B802.if.lr.ph.i
  %trouble.2.11862.i = phi double [ 0.000000e+00, %B802.if.lr.ph.i ], [ %.1842.i, %B920.i ]
  %.1701.01860.i = phi i64 [ 0, %B802.if.lr.ph.i ], [ %.1770.i, %B920.i ]
  %.1770.i = add nsw i64 %.1701.01860.i, 1
  %.1801.i = add nsw i64 %.1701.01860.i, %.1231.i8982
  %.1803.i = mul nsw i64 %.1801.i, %arg.shape.0
  %gep9274 = getelementptr double, ptr %invariant.gep9273, i64 %.1803.i
  %.1835.i = load double, ptr %gep9274, align 8, !noalias !122
  %.1840.i = fmul double %.1835.i, 0.000000e+00
  %.1842.i = fadd double %trouble.2.11862.i, %.1840.i
  %.1850.i = mul nsw i64 %.1701.01860.i, %arg.shape.0
  %gep9276 = getelementptr double, ptr %invariant.gep9275, i64 %.1850.i
  store double %.1835.i, ptr %gep9276, align 8, !noalias !122
  br i1 %"$phi770.1.2.1.i", label %B898.i, label %B920.i

B1106.if.i:                                       ; preds = %B1228.i, %B986.i
  %.2224.01868.i = phi i64 [ 0, %B986.i ], [ %.2293.i, %B1228.i ]
  %.2293.i = add nsw i64 %.2224.01868.i, 1
  %233 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2224.01868.i
  %.99.i311.i = load i64, ptr %233, align 8, !noalias !129
  %.104.i314.i = icmp slt i64 %.99.i311.i, 0
  br i1 %.104.i314.i, label %B1228.i, label %B46.i315.i

B3550:                                            ; preds = %B1228.i, %B3496, %B360.i8980, %B982.i
  %looked.2.1.lcssa.not = xor i1 %looked.2.1.lcssa, true
  %brmerge9297 = or i1 %.274.i, %looked.2.1.lcssa.not
  br i1 %brmerge9297, label %B4352, label %B3588.if

B3634:                                            ; preds = %B3588.if
  br i1 %.163.i46809280.not, label %B102.i, label %B46.if.i5112.preheader

B46.if.i5112.preheader:                           ; preds = %B3634
  %invariant.gep9532 = getelementptr double, ptr %arg.arrays.0.4, i64 %.5231.09284
  br label %B46.if.i5112

B102.i:                                           ; preds = %B46.if.i5112, %B3634
  %.360.i4741 = getelementptr double, ptr %arg.lane.0.4, i64 %.5231.09284
  store double 0.000000e+00, ptr %.360.i4741, align 8, !noalias !135
  %.415.i4789 = getelementptr double, ptr %371, i64 %.5231.09284
  store double 5.000000e-01, ptr %.415.i4789, align 8, !noalias !135
  %.470.i4837 = getelementptr double, ptr %372, i64 %.5231.09284
  store double 1.000000e+00, ptr %.470.i4837, align 8, !noalias !135
  %.526.i4885 = getelementptr double, ptr %373, i64 %.5231.09284
  store double 0.000000e+00, ptr %.526.i4885, align 8, !noalias !135
  %.581.i4933 = getelementptr double, ptr %374, i64 %.5231.09284
  store double 0.000000e+00, ptr %.581.i4933, align 8, !noalias !135
  %.636.i4981 = getelementptr double, ptr %375, i64 %.5231.09284
  store double 0xFFF0000000000000, ptr %.636.i4981, align 8, !noalias !135
  %.693.i5029 = getelementptr double, ptr %376, i64 %.5231.09284
  store double 0x7FF0000000000000, ptr %.693.i5029, align 8, !noalias !135
  br label %B4379

B46.if.i5112:                                     ; preds = %B46.if.i5112.preheader, %B46.if.i5112
  %.105.i4620.09282 = phi i64 [ %.176.i5120, %B46.if.i5112 ], [ 0, %B46.if.i5112.preheader ]
  %.176.i5120 = add nsw i64 %.105.i4620.09282, 1
  %234 = getelementptr double, ptr %arg.runs.0.4, i64 %.105.i4620.09282
  %.255.i5082 = load double, ptr %234, align 8, !noalias !135
  %.257.i5084 = mul nsw i64 %.105.i4620.09282, %arg.shape.0
  %gep9533 = getelementptr double, ptr %invariant.gep9532, i64 %.257.i5084
  store double %.255.i5082, ptr %gep9533, align 8, !noalias !135
  %exitcond9313.not = icmp eq i64 %arg.shape.1, %.176.i5120
  br i1 %exitcond9313.not, label %B102.i, label %B46.if.i5112

B3674:                                            ; preds = %B3588.if
  %.5515 = mul i64 %.5393, %arg.results.3.5.1
  %.5519 = getelementptr i64, ptr %arg.results.3.4, i64 %.5515
  %.5520 = load i64, ptr %.5519, align 8
  %.5576 = getelementptr i8, ptr %.5519, i64 24
  %.5577 = load i64, ptr %.5576, align 8
  %235 = add i64 %.5520, %.5577
  %.5578 = sub i64 %arg.most, %235
  %.5583 = icmp slt i64 %.5578, 1
  br i1 %.5583, label %B3754, label %B3800

B3754:                                            ; preds = %B3674
  %236 = getelementptr i64, ptr %arg.lane.1.4, i64 %.5231.09284
  %.84.i5203 = load i64, ptr %236, align 8, !noalias !139
  %.89.i5206 = icmp sgt i64 %.84.i5203, -1
  br i1 %.89.i5206, label %B46.i5211, label %B3800

B46.i5211:                                        ; preds = %B3754
  %.120.i5236 = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i5203
  %.121.i5237 = load i64, ptr %.120.i5236, align 8, !noalias !139
  %.122.i5238 = icmp eq i64 %.121.i5237, 0
  br i1 %.122.i5238, label %B80.i5243, label %B3800

B80.i5243:                                        ; preds = %B46.i5211
  store i64 5, ptr %.120.i5236, align 8, !noalias !139
  br label %B3800

B3800:                                            ; preds = %B80.i5243, %B3754, %B46.i5211, %B3674
  %.5673 = getelementptr double, ptr %339, i64 %.5231.09284
  %.5674 = load double, ptr %.5673, align 8
  %.5675 = fcmp ogt double %.5674, 5.000000e-01
  br i1 %.5675, label %B3838, label %B3944

B3838:                                            ; preds = %B3800
  %.5730 = getelementptr double, ptr %arg.lane.0.4, i64 %.5231.09284
  %.5731 = load double, ptr %.5730, align 8
  %.5785 = getelementptr double, ptr %340, i64 %.5231.09284
  %.5786 = load double, ptr %.5785, align 8
  %.5787 = fcmp oeq double %.5731, %.5786
  br i1 %.5787, label %B3902, label %B3944

B3902:                                            ; preds = %B3838
  %.246.i5519 = load i64, ptr %.5392, align 8, !noalias !142
  %.264.i5531 = icmp slt i64 %.246.i5519, 0
  %.265.i5532 = select i1 %.264.i5531, i64 %arg.runs.2.5.0, i64 0
  %237 = getelementptr i64, ptr %arg.runs.2.4, i64 %.246.i5519
  %.279.i5546 = getelementptr i64, ptr %237, i64 %.265.i5532
  %.280.i5547 = load i64, ptr %.279.i5546, align 8, !noalias !142
  %.337.i5595 = getelementptr i64, ptr %341, i64 %.5231.09284
  %.338.i5596 = load i64, ptr %.337.i5595, align 8, !noalias !142
  %.339.i5597 = add nsw i64 %.338.i5596, 1
  store i64 %.339.i5597, ptr %.337.i5595, align 8, !noalias !142
  %.460.i5702 = icmp slt i64 %.280.i5547, 0
  %.461.i5703 = select i1 %.460.i5702, i64 %arg.schedule.1.5.0, i64 0
  %238 = getelementptr i64, ptr %arg.schedule.1.4, i64 %.280.i5547
  %.475.i5717 = getelementptr i64, ptr %238, i64 %.461.i5703
  %.476.i5718 = load i64, ptr %.475.i5717, align 8, !noalias !142
  %.477.i5719 = icmp eq i64 %.339.i5597, %.476.i5718
  br i1 %.477.i5719, label %B186.i, label %B244.i

B186.i:                                           ; preds = %B3902
  %.516.i6264 = select i1 %.264.i5531, i64 %arg.results.1.5.0, i64 0
  %239 = getelementptr i64, ptr %arg.results.1.4, i64 %.246.i5519
  %.530.i6278 = getelementptr i64, ptr %239, i64 %.516.i6264
  %.531.i6279 = load i64, ptr %.530.i6278, align 8, !noalias !142
  %.532.i6280 = icmp eq i64 %.531.i6279, 0
  br i1 %.532.i6280, label %B220.i, label %B3944

B220.i:                                           ; preds = %B186.i
  store i64 1, ptr %.530.i6278, align 8, !noalias !142
  br label %B3944

B244.i:                                           ; preds = %B3902
  %.659.i5791 = select i1 %.460.i5702, i64 %arg.schedule.0.5.0, i64 0
  %.660.i5792 = add i64 %.659.i5791, %.280.i5547
  %.661.i5793 = icmp slt i64 %.338.i5596, -1
  %.662.i5794 = select i1 %.661.i5793, i64 %arg.schedule.0.5.1, i64 0
  %.680.i5812 = mul i64 %.660.i5792, %arg.schedule.0.5.1
  %240 = getelementptr double, ptr %arg.schedule.0.4, i64 %.680.i5812
  %241 = getelementptr double, ptr %240, i64 %.339.i5597
  %.684.i5816 = getelementptr double, ptr %241, i64 %.662.i5794
  %.685.i5817 = load double, ptr %.684.i5816, align 8, !noalias !142
  store double %.685.i5817, ptr %.5785, align 8, !noalias !142
  %.797.i5915 = load i64, ptr %.337.i5595, align 8, !noalias !142
  %.822.i5936 = select i1 %.460.i5702, i64 %arg.schedule.4.5.0, i64 0
  %.823.i5937 = add i64 %.822.i5936, %.280.i5547
  %.824.i5938 = icmp slt i64 %.797.i5915, 0
  %.825.i5939 = select i1 %.824.i5938, i64 %arg.schedule.4.5.1, i64 0
  %.843.i5957 = mul i64 %.823.i5937, %arg.schedule.4.5.1
  %242 = getelementptr i64, ptr %arg.schedule.4.4, i64 %.843.i5957
  %243 = getelementptr i64, ptr %242, i64 %.797.i5915
  %.847.i5961 = getelementptr i64, ptr %243, i64 %.825.i5939
  %.848.i5962 = load i64, ptr %.847.i5961, align 8, !noalias !142
  %.851.i5964 = icmp eq i64 %.848.i5962, 0
  br i1 %.851.i5964, label %B364.i, label %B412.i

B364.i:                                           ; preds = %B244.i
  %.906.i6215 = getelementptr double, ptr %342, i64 %.5231.09284
  store double 1.000000e+00, ptr %.906.i6215, align 8, !noalias !142
  br label %B456.i.sink.split

B412.i:                                           ; preds = %B244.i
  %.974.i5988 = load i64, ptr %.722, align 8, !noalias !142
  %.975.i5989 = icmp eq i64 %.974.i5988, 0
  br i1 %.975.i5989, label %B456.i.sink.split, label %B456.i

B456.i.sink.split:                                ; preds = %B412.i, %B364.i
  %.sink = phi i64 [ 1, %B364.i ], [ 2, %B412.i ]
  store i64 %.sink, ptr %.722, align 8, !noalias !142
  br label %B456.i

B456.i:                                           ; preds = %B456.i.sink.split, %B412.i
  br i1 %.1103.i9277.not, label %B3944, label %B512.if.i.lr.ph

B512.if.i.lr.ph:                                  ; preds = %B456.i
  %.1227.i = select i1 %.460.i5702, i64 %arg.schedule.3.5.0, i64 0
  %.1228.i6094 = add i64 %.1227.i, %.280.i5547
  %.1258.i = mul i64 %.1256.i6113, %.1228.i6094
  %244 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1258.i
  br label %B512.if.i

B512.if.i:                                        ; preds = %B512.if.i.lr.ph, %B512.if.i
  %.1045.i5447.09279 = phi i64 [ 0, %B512.if.i.lr.ph ], [ %.1116.i6138, %B512.if.i ]
  %.1116.i6138 = add nsw i64 %.1045.i5447.09279, 1
  %.1195.i = load i64, ptr %.337.i5595, align 8, !noalias !142
  %.1229.i = icmp slt i64 %.1195.i, 0
  %.1230.i = select i1 %.1229.i, i64 %arg.schedule.3.5.1, i64 0
  %.1231.i = add i64 %.1230.i, %.1195.i
  %.1260.i6115 = mul i64 %.1231.i, %arg.schedule.3.5.2
  %245 = getelementptr double, ptr %244, i64 %.1260.i6115
  %246 = getelementptr double, ptr %245, i64 %.1045.i5447.09279
  %.1265.i6120 = load double, ptr %246, align 8, !noalias !142
  %247 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1045.i5447.09279
  %.1295.i = load i64, ptr %247, align 8, !noalias !142
  %.1297.i = mul nsw i64 %.1295.i, %arg.shape.0
  %.1299.i = add nsw i64 %.1297.i, %.5231.09284
  %.1313.i = icmp slt i64 %.1299.i, 0
  %.1314.i = select i1 %.1313.i, i64 %arg.arrays.1.5.0, i64 0
  %248 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1299.i
  %.1328.i = getelementptr double, ptr %248, i64 %.1314.i
  store double %.1265.i6120, ptr %.1328.i, align 8, !noalias !142
  %exitcond9312.not = icmp eq i64 %arg.schedule.2.5.0, %.1116.i6138
  br i1 %exitcond9312.not, label %B3944, label %B512.if.i

B3944:                                            ; preds = %B512.if.i, %B456.i, %B220.i, %B186.i, %B3838, %B3800
  %.5893 = getelementptr i64, ptr %arg.results.1.4, i64 %.5393
  %.5894 = load i64, ptr %.5893, align 8
  %.5895.not = icmp eq i64 %.5894, 0
  br i1 %.5895.not, label %B4102, label %B3978

B3978:                                            ; preds = %B3944
  %.5956 = getelementptr i64, ptr %343, i64 %.5231.09284
  %.5957 = load i64, ptr %.5956, align 8
  %.5987 = getelementptr i64, ptr %arg.results.2.4, i64 %.5393
  store i64 %.5957, ptr %.5987, align 8
  store i64 -1, ptr %.5392, align 8
  %.314.i8996 = load i64, ptr %arg.lane.2.4, align 8, !noalias !146
  %.374.i8998 = load i64, ptr %.373.i8997, align 8, !noalias !146
  %.375.i8999 = icmp slt i64 %.314.i8996, %.374.i8998
  br i1 %.375.i8999, label %B130.i9131, label %B316.i9000

B130.i9131:                                       ; preds = %B3978
  %.385.i9132 = add nsw i64 %.314.i8996, 1
  store i64 %.385.i9132, ptr %arg.lane.2.4, align 8, !noalias !146
  store i64 1, ptr %.722, align 8, !noalias !146
  store i64 %.314.i8996, ptr %.5392, align 8, !noalias !146
  %.557.i9137 = getelementptr i64, ptr %344, i64 %.5231.09284
  store i64 0, ptr %.557.i9137, align 8, !noalias !146
  store i64 1, ptr %.5956, align 8, !noalias !146
  br i1 %.6961563.not.i9140, label %B316.i9000, label %B272.if.lr.ph.i9141

B272.if.lr.ph.i9141:                              ; preds = %B130.i9131
  %.757.i9142 = icmp slt i64 %.314.i8996, 0
  %.758.i9143 = select i1 %.757.i9142, i64 %arg.runs.0.5.0, i64 0
  %.759.i9144 = add i64 %.758.i9143, %.314.i8996
  %.779.i9145 = mul i64 %.759.i9144, %arg.runs.0.5.1
  %249 = getelementptr double, ptr %arg.runs.0.4, i64 %.779.i9145
  %.822.i9146 = select i1 %.757.i9142, i64 %arg.results.0.5.0, i64 0
  %.823.i9147 = add i64 %.822.i9146, %.314.i8996
  %.853.i9149 = mul i64 %.851.i9148, %.823.i9147
  %250 = getelementptr double, ptr %arg.results.0.4, i64 %.853.i9149
  br i1 %min.iters.check9325, label %B272.if.i9150.preheader, label %vector.memcheck9320

vector.memcheck9320:                              ; preds = %B272.if.lr.ph.i9141
  %251 = mul i64 %378, %.823.i9147
  %252 = mul i64 %379, %.759.i9144
  %253 = add i64 %251, %arg.results.0.49321
  %254 = add i64 %252, %arg.runs.0.49322
  %255 = sub i64 %253, %254
  %diff.check9323 = icmp ult i64 %255, 32
  br i1 %diff.check9323, label %B272.if.i9150.preheader, label %vector.body9329

vector.body9329:                                  ; preds = %vector.memcheck9320, %vector.body9329
  %index9330 = phi i64 [ %index.next9333, %vector.body9329 ], [ 0, %vector.memcheck9320 ]
  %256 = getelementptr double, ptr %249, i64 %index9330
  %257 = getelementptr i8, ptr %256, i64 16
  %wide.load9331 = load <2 x double>, ptr %256, align 8, !noalias !146
  %wide.load9332 = load <2 x double>, ptr %257, align 8, !noalias !146
  %258 = getelementptr double, ptr %250, i64 %index9330
  %259 = getelementptr i8, ptr %258, i64 16
  store <2 x double> %wide.load9331, ptr %258, align 8, !noalias !146
  store <2 x double> %wide.load9332, ptr %259, align 8, !noalias !146
  %index.next9333 = add i64 %index9330, 4
  %260 = icmp eq i64 %index.next9333, %n.vec9328
  br i1 %260, label %middle.block9334, label %vector.body9329, !llvm.loop !149

middle.block9334:                                 ; preds = %vector.body9329
  br i1 %cmp.n9335, label %B316.i9000, label %B272.if.i9150.preheader

B272.if.i9150.preheader:                          ; preds = %vector.memcheck9320, %B272.if.lr.ph.i9141, %middle.block9334
  %.638.01564.i9151.ph = phi i64 [ 0, %vector.memcheck9320 ], [ 0, %B272.if.lr.ph.i9141 ], [ %n.vec9328, %middle.block9334 ]
  br label %B272.if.i9150

B316.i9000:                                       ; preds = %B272.if.i9150, %middle.block9334, %B130.i9131, %B3978
  %m.2.0.i9001 = phi i64 [ 0, %B3978 ], [ %.314.i8996, %B130.i9131 ], [ %.314.i8996, %middle.block9334 ], [ %.314.i8996, %B272.if.i9150 ]
  br i1 %.9661566.not.i9002, label %B390.i9018, label %B346.if.lr.ph.i9003

B346.if.lr.ph.i9003:                              ; preds = %B316.i9000
  %.1027.i9004 = icmp slt i64 %m.2.0.i9001, 0
  %.1028.i9005 = select i1 %.1027.i9004, i64 %arg.runs.1.5.0, i64 0
  %.1029.i9006 = add i64 %.1028.i9005, %m.2.0.i9001
  %.1049.i9007 = mul i64 %.1029.i9006, %arg.runs.1.5.1
  %261 = getelementptr double, ptr %arg.runs.1.4, i64 %.1049.i9007
  %invariant.gep9526 = getelementptr double, ptr %arg.arrays.1.4, i64 %.5231.09284
  br label %B346.if.i9008

B390.i9018:                                       ; preds = %B346.if.i9008, %B316.i9000
  br i1 %.11851569.not.i9019, label %B516.i9041, label %B446.if.lr.ph.i9020

B446.if.lr.ph.i9020:                              ; preds = %B390.i9018
  %.1237.i9021 = icmp slt i64 %m.2.0.i9001, 0
  %.1238.i9022 = select i1 %.1237.i9021, i64 %arg.runs.2.5.0, i64 0
  %262 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i9001
  %.1252.i9023 = getelementptr i64, ptr %262, i64 %.1238.i9022
  br label %B446.if.i9025

B516.i9041:                                       ; preds = %B446.if.i9025, %B390.i9018
  br i1 %.375.i8999, label %B574.i9073, label %B520.i9042

B520.i9042:                                       ; preds = %B516.i9041
  br i1 %.1423.i9043, label %B532.i9045, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit9155

B532.i9045:                                       ; preds = %B520.i9042
  br i1 %.163.i1572.not.i9046, label %B102.i.i9057, label %B46.if.i.i9047.preheader

B46.if.i.i9047.preheader:                         ; preds = %B532.i9045
  %invariant.gep9528 = getelementptr double, ptr %arg.arrays.0.4, i64 %.5231.09284
  br label %B46.if.i.i9047

B102.i.i9057:                                     ; preds = %B46.if.i.i9047, %B532.i9045
  %.360.i.i9061 = getelementptr double, ptr %arg.lane.0.4, i64 %.5231.09284
  store double 0.000000e+00, ptr %.360.i.i9061, align 8, !noalias !150
  %.415.i.i9062 = getelementptr double, ptr %345, i64 %.5231.09284
  store double 5.000000e-01, ptr %.415.i.i9062, align 8, !noalias !150
  %.470.i.i9064 = getelementptr double, ptr %346, i64 %.5231.09284
  store double 1.000000e+00, ptr %.470.i.i9064, align 8, !noalias !150
  %.526.i.i9066 = getelementptr double, ptr %347, i64 %.5231.09284
  store double 0.000000e+00, ptr %.526.i.i9066, align 8, !noalias !150
  %.581.i.i9068 = getelementptr double, ptr %348, i64 %.5231.09284
  store double 0.000000e+00, ptr %.581.i.i9068, align 8, !noalias !150
  %.636.i.i9070 = getelementptr double, ptr %349, i64 %.5231.09284
  store double 0xFFF0000000000000, ptr %.636.i.i9070, align 8, !noalias !150
  %.693.i.i9072 = getelementptr double, ptr %350, i64 %.5231.09284
  store double 0x7FF0000000000000, ptr %.693.i.i9072, align 8, !noalias !150
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit9155

B46.if.i.i9047:                                   ; preds = %B46.if.i.i9047.preheader, %B46.if.i.i9047
  %.105.i.01573.i9048 = phi i64 [ %.176.i.i9049, %B46.if.i.i9047 ], [ 0, %B46.if.i.i9047.preheader ]
  %.176.i.i9049 = add nsw i64 %.105.i.01573.i9048, 1
  %263 = getelementptr double, ptr %arg.runs.0.4, i64 %.105.i.01573.i9048
  %.255.i.i9050 = load double, ptr %263, align 8, !noalias !150
  %.257.i.i9051 = mul nsw i64 %.105.i.01573.i9048, %arg.shape.0
  %gep9529 = getelementptr double, ptr %invariant.gep9528, i64 %.257.i.i9051
  store double %.255.i.i9050, ptr %gep9529, align 8, !noalias !150
  %exitcond1580.not.i9056 = icmp eq i64 %arg.shape.1, %.176.i.i9049
  br i1 %exitcond1580.not.i9056, label %B102.i.i9057, label %B46.if.i.i9047

B574.i9073:                                       ; preds = %B516.i9041
  br i1 %.15851575.not.i9074, label %B648.i9090, label %B604.if.lr.ph.i9075

B604.if.lr.ph.i9075:                              ; preds = %B574.i9073
  %.1646.i9076 = icmp slt i64 %m.2.0.i9001, 0
  %.1647.i9077 = select i1 %.1646.i9076, i64 %arg.runs.0.5.0, i64 0
  %.1648.i9078 = add i64 %.1647.i9077, %m.2.0.i9001
  %.1668.i9079 = mul i64 %.1648.i9078, %arg.runs.0.5.1
  %264 = getelementptr double, ptr %arg.runs.0.4, i64 %.1668.i9079
  %invariant.gep9530 = getelementptr double, ptr %arg.arrays.0.4, i64 %.5231.09284
  br label %B604.if.i9080

B648.i9090:                                       ; preds = %B604.if.i9080, %B574.i9073
  %.1748.i9091 = load double, ptr %arg.times.4, align 8, !noalias !146
  %.1765.i9092 = icmp slt i64 %m.2.0.i9001, 0
  %.1766.i9093 = select i1 %.1765.i9092, i64 %arg.runs.2.5.0, i64 0
  %265 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i9001
  %.1780.i9094 = getelementptr i64, ptr %265, i64 %.1766.i9093
  %.1781.i9095 = load i64, ptr %.1780.i9094, align 8, !noalias !146
  %.1812.i9096 = icmp slt i64 %.1781.i9095, 0
  %.1813.i9097 = select i1 %.1812.i9096, i64 %arg.schedule.0.5.0, i64 0
  %.1814.i9098 = add i64 %.1813.i9097, %.1781.i9095
  %.1834.i9099 = mul i64 %.1814.i9098, %arg.schedule.0.5.1
  %.1838.i9100 = getelementptr double, ptr %arg.schedule.0.4, i64 %.1834.i9099
  %.1839.i9101 = load double, ptr %.1838.i9100, align 8, !noalias !146
  %.1895.i9105 = getelementptr double, ptr %arg.lane.0.4, i64 %.5231.09284
  store double %.1748.i9091, ptr %.1895.i9105, align 8, !noalias !146
  %.1950.i9107 = getelementptr double, ptr %351, i64 %.5231.09284
  store double %.1839.i9101, ptr %.1950.i9107, align 8, !noalias !146
  %.2005.i9108 = getelementptr double, ptr %352, i64 %.5231.09284
  store double 0.000000e+00, ptr %.2005.i9108, align 8, !noalias !146
  %.2064.i9110 = getelementptr double, ptr %353, i64 %.5231.09284
  store double 1.000000e+00, ptr %.2064.i9110, align 8, !noalias !146
  %.2119.i9112 = getelementptr double, ptr %354, i64 %.5231.09284
  store double 0.000000e+00, ptr %.2119.i9112, align 8, !noalias !146
  %.2175.i9114 = getelementptr double, ptr %355, i64 %.5231.09284
  store double 0xFFF0000000000000, ptr %.2175.i9114, align 8, !noalias !146
  %266 = getelementptr i64, ptr %356, i64 %.5231.09284
  store i64 0, ptr %266, align 8, !noalias !146
  %.2287.i9119 = getelementptr double, ptr %357, i64 %.5231.09284
  store double 0x7FF0000000000000, ptr %.2287.i9119, align 8, !noalias !146
  %.2348.i9121 = getelementptr double, ptr %358, i64 %.5231.09284
  store double 0.000000e+00, ptr %.2348.i9121, align 8, !noalias !146
  %.2403.i9123 = getelementptr double, ptr %359, i64 %.5231.09284
  store double 0.000000e+00, ptr %.2403.i9123, align 8, !noalias !146
  %.2458.i9125 = getelementptr double, ptr %360, i64 %.5231.09284
  store double 0.000000e+00, ptr %.2458.i9125, align 8, !noalias !146
  %.2513.i9127 = getelementptr double, ptr %361, i64 %.5231.09284
  %.2514.i9128 = load double, ptr %.2513.i9127, align 8, !noalias !146
  %.2516.i9129 = fcmp ueq double %.2514.i9128, 0xFFF0000000000000
  br i1 %.2516.i9129, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit9155, label %B1060.i9130

B1060.i9130:                                      ; preds = %B648.i9090
  store double 0.000000e+00, ptr %.2513.i9127, align 8, !noalias !146
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit9155

B272.if.i9150:                                    ; preds = %B272.if.i9150.preheader, %B272.if.i9150
  %.638.01564.i9151 = phi i64 [ %.709.i9152, %B272.if.i9150 ], [ %.638.01564.i9151.ph, %B272.if.i9150.preheader ]
  %.709.i9152 = add nsw i64 %.638.01564.i9151, 1
  %267 = getelementptr double, ptr %249, i64 %.638.01564.i9151
  %.784.i9153 = load double, ptr %267, align 8, !noalias !146
  %268 = getelementptr double, ptr %250, i64 %.638.01564.i9151
  store double %.784.i9153, ptr %268, align 8, !noalias !146
  %exitcond.not.i9154 = icmp eq i64 %.709.i9152, %arg.shape.1
  br i1 %exitcond.not.i9154, label %B316.i9000, label %B272.if.i9150, !llvm.loop !154

B346.if.i9008:                                    ; preds = %B346.if.i9008, %B346.if.lr.ph.i9003
  %.910.01567.i9009 = phi i64 [ 0, %B346.if.lr.ph.i9003 ], [ %.979.i9010, %B346.if.i9008 ]
  %.979.i9010 = add nsw i64 %.910.01567.i9009, 1
  %269 = getelementptr double, ptr %261, i64 %.910.01567.i9009
  %.1054.i9011 = load double, ptr %269, align 8, !noalias !146
  %.1056.i9012 = mul nsw i64 %.910.01567.i9009, %arg.shape.0
  %gep9527 = getelementptr double, ptr %invariant.gep9526, i64 %.1056.i9012
  store double %.1054.i9011, ptr %gep9527, align 8, !noalias !146
  %exitcond1578.not.i9017 = icmp eq i64 %.979.i9010, %arg.shape.2
  br i1 %exitcond1578.not.i9017, label %B390.i9018, label %B346.if.i9008

B446.if.i9025:                                    ; preds = %B446.if.i9025, %B446.if.lr.ph.i9020
  %.1129.01570.i9026 = phi i64 [ 0, %B446.if.lr.ph.i9020 ], [ %.1198.i9027, %B446.if.i9025 ]
  %.1198.i9027 = add nsw i64 %.1129.01570.i9026, 1
  %.1253.i9028 = load i64, ptr %.1252.i9023, align 8, !noalias !146
  %.1289.i9029 = icmp slt i64 %.1253.i9028, 0
  %.1290.i9030 = select i1 %.1289.i9029, i64 %arg.schedule.3.5.0, i64 0
  %.1291.i9031 = add i64 %.1290.i9030, %.1253.i9028
  %.1321.i9032 = mul i64 %.1319.i9024, %.1291.i9031
  %270 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1321.i9032
  %271 = getelementptr double, ptr %270, i64 %.1129.01570.i9026
  %.1328.i9033 = load double, ptr %271, align 8, !noalias !146
  %272 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1129.01570.i9026
  %.1358.i9034 = load i64, ptr %272, align 8, !noalias !146
  %.1360.i9035 = mul nsw i64 %.1358.i9034, %arg.shape.0
  %.1362.i9036 = add nsw i64 %.1360.i9035, %.5231.09284
  %.1376.i9037 = icmp slt i64 %.1362.i9036, 0
  %.1377.i9038 = select i1 %.1376.i9037, i64 %arg.arrays.1.5.0, i64 0
  %273 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1362.i9036
  %.1391.i9039 = getelementptr double, ptr %273, i64 %.1377.i9038
  store double %.1328.i9033, ptr %.1391.i9039, align 8, !noalias !146
  %exitcond1579.not.i9040 = icmp eq i64 %.1198.i9027, %arg.schedule.2.5.0
  br i1 %exitcond1579.not.i9040, label %B516.i9041, label %B446.if.i9025

B604.if.i9080:                                    ; preds = %B604.if.i9080, %B604.if.lr.ph.i9075
  %.1529.01576.i9081 = phi i64 [ 0, %B604.if.lr.ph.i9075 ], [ %.1598.i9082, %B604.if.i9080 ]
  %.1598.i9082 = add nsw i64 %.1529.01576.i9081, 1
  %274 = getelementptr double, ptr %264, i64 %.1529.01576.i9081
  %.1673.i9083 = load double, ptr %274, align 8, !noalias !146
  %.1675.i9084 = mul nsw i64 %.1529.01576.i9081, %arg.shape.0
  %gep9531 = getelementptr double, ptr %invariant.gep9530, i64 %.1675.i9084
  store double %.1673.i9083, ptr %gep9531, align 8, !noalias !146
  %exitcond1581.not.i9089 = icmp eq i64 %.1598.i9082, %arg.shape.1
  br i1 %exitcond1581.not.i9089, label %B648.i9090, label %B604.if.i9080

_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit9155: ; preds = %B520.i9042, %B102.i.i9057, %B648.i9090, %B1060.i9130
  %storemerge1551.i9044 = phi i64 [ 0, %B520.i9042 ], [ 0, %B102.i.i9057 ], [ 1, %B1060.i9130 ], [ 1, %B648.i9090 ]
  %.6047 = add nsw i64 %active.3.29287, -1
  %.6145 = add nsw i64 %.6047, %storemerge1551.i9044
  br label %B4310

B4102:                                            ; preds = %B3944
  %.6211 = getelementptr double, ptr %362, i64 %.5231.09284
  %.6212 = load double, ptr %.6211, align 8
  %.6214 = fcmp ult double %.6212, 1.500000e+01
  br i1 %.6214, label %B4310, label %B4150

B4150:                                            ; preds = %B4102
  %.6260 = load double, ptr %.6259, align 8
  %.6314 = getelementptr double, ptr %arg.lane.0.4, i64 %.5231.09284
  %.6315 = load double, ptr %.6314, align 8
  %.6316 = fsub double %.6260, %.6315
  %.6370 = getelementptr double, ptr %365, i64 %.5231.09284
  %.6371 = load double, ptr %.6370, align 8
  %.6373 = fmul double %.6371, 5.000000e+03
  %.6374 = fcmp ogt double %.6316, %.6373
  br i1 %.6374, label %B4310, label %B4286

B4286:                                            ; preds = %B4150
  store double 0.000000e+00, ptr %.6211, align 8
  br label %B4310

B4310:                                            ; preds = %B4150, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit9155, %B4286, %B4102
  %budget.7.3 = phi i64 [ %budget.5.29286, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit9155 ], [ %budget.5.29286, %B4102 ], [ %budget.5.29286, %B4286 ], [ 0, %B4150 ]
  %active.5.3 = phi i64 [ %.6145, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit9155 ], [ %active.3.29287, %B4102 ], [ %active.3.29287, %B4286 ], [ %active.3.29287, %B4150 ]
  %.130.i6440 = load i64, ptr %.5392, align 8, !noalias !155
  %.183.i6487 = getelementptr i64, ptr %366, i64 %.5231.09284
  %.184.i6488 = load i64, ptr %.183.i6487, align 8, !noalias !155
  %.192.i6492 = icmp sgt i64 %.130.i6440, -1
  br i1 %.192.i6492, label %B88.i, label %B4379

B88.i:                                            ; preds = %B4310
  %.383.i6621 = getelementptr double, ptr %367, i64 %.5231.09284
  %.384.i6622 = load double, ptr %.383.i6621, align 8, !noalias !155
  %.386.i6623 = fcmp ogt double %.384.i6622, 0.000000e+00
  br i1 %.386.i6623, label %B222.i, label %B220.i6624

B220.i6624:                                       ; preds = %B88.i
  %.245.i6546 = mul i64 %.130.i6440, %arg.results.3.5.1
  %.249.i6550 = getelementptr i64, ptr %arg.results.3.4, i64 %.245.i6546
  %.250.i6551 = load i64, ptr %.249.i6550, align 8, !noalias !155
  %.263.i6376.0 = and i64 %.250.i6551, 127
  %.293.i6559 = sub nsw i64 128, %.263.i6376.0
  %.11.i.i6568 = tail call i64 @llvm.smin.i64(i64 %.293.i6559, i64 %.5578)
  %.397.i6627 = sitofp i64 %.11.i.i6568 to double
  br label %B222.i

B222.i:                                           ; preds = %B88.i, %B220.i6624
  %"$phi222.0.2.i.0" = phi double [ %.397.i6627, %B220.i6624 ], [ 1.000000e+00, %B88.i ]
  %.455.i6677 = getelementptr double, ptr %368, i64 %.5231.09284
  store double %"$phi222.0.2.i.0", ptr %.455.i6677, align 8, !noalias !155
  %.512.i6726 = getelementptr double, ptr %369, i64 %.5231.09284
  %.513.i6727 = load double, ptr %.512.i6726, align 8, !noalias !155
  %.567.i6775 = getelementptr double, ptr %370, i64 %.5231.09284
  store double %.513.i6727, ptr %.567.i6775, align 8, !noalias !155
  %.580.i6783 = icmp slt i64 %.184.i6488, %arg.times.5.0
  br i1 %.580.i6783, label %B332.i, label %B4379

B332.i:                                           ; preds = %B222.i
  %.596.i6798 = icmp slt i64 %.184.i6488, 0
  %.597.i6799 = select i1 %.596.i6798, i64 %arg.times.5.0, i64 0
  %275 = getelementptr double, ptr %arg.times.4, i64 %.184.i6488
  %.611.i6813 = getelementptr double, ptr %275, i64 %.597.i6799
  %.612.i6814 = load double, ptr %.611.i6813, align 8, !noalias !155
  %.671.i6865 = load double, ptr %.512.i6726, align 8, !noalias !155
  %.10.i3.i = fcmp olt double %.671.i6865, %.612.i6814
  %.11.i4.i = select i1 %.10.i3.i, double %.671.i6865, double %.612.i6814
  store double %.11.i4.i, ptr %.567.i6775, align 8, !noalias !155
  br label %B4379

B4352:                                            ; preds = %B4379, %B3550
  %budget.4.2 = phi i64 [ %.688, %B3550 ], [ %budget.6.3, %B4379 ]
  %active.7.2 = phi i64 [ %active.6.0, %B3550 ], [ %active.4.3, %B4379 ]
  %.6533 = icmp sgt i64 %active.7.2, 0
  %.6547 = icmp sgt i64 %budget.4.2, 0
  %or.cond8804 = select i1 %.6533, i1 %.6547, i1 false
  br i1 %or.cond8804, label %B276, label %B4378

B4378:                                            ; preds = %B4352, %B202.endif
  %active.8.1 = phi i64 [ %active.3.i.0.lcssa, %B202.endif ], [ %active.7.2, %B4352 ]
  br i1 %.274.i, label %B4378.endif, label %B46.if.i2010.lr.ph

B46.if.i2010.lr.ph:                               ; preds = %B4378
  %.idx8747 = mul i64 %arg.lane.0.5.1, 200
  %276 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8747
  %.idx8748 = mul i64 %arg.lane.0.5.1, 208
  %277 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8748
  br label %B46.if.i2010

B92.i1520:                                        ; preds = %B46.if.i2010
  %.303.i1566 = getelementptr double, ptr %276, i64 %.90.i1382.09292
  %.304.i1567 = load double, ptr %.303.i1566, align 8, !noalias !159
  %.5.i.i1568 = fptosi double %.304.i1567 to i64
  %.382.i1618 = getelementptr double, ptr %277, i64 %.90.i1382.09292
  %.383.i1619 = load double, ptr %.382.i1618, align 8, !noalias !159
  %.5.i1.i1620 = fptosi double %.383.i1619 to i64
  %.457.i1669 = mul i64 %.243.i1513, %arg.results.3.5.1
  %.461.i1673 = getelementptr i64, ptr %arg.results.3.4, i64 %.457.i1669
  %.462.i1674 = load i64, ptr %.461.i1673, align 8, !noalias !159
  %.463.i1675 = add nsw i64 %.462.i1674, %.5.i.i1568
  store i64 %.463.i1675, ptr %.461.i1673, align 8, !noalias !159
  %.569.i1771 = getelementptr i8, ptr %.461.i1673, i64 24
  %.570.i1772 = load i64, ptr %.569.i1771, align 8, !noalias !159
  %.571.i1773 = add nsw i64 %.570.i1772, %.5.i1.i1620
  store i64 %.571.i1773, ptr %.569.i1771, align 8, !noalias !159
  %.679.i1867 = getelementptr i8, ptr %.461.i1673, i64 8
  %.680.i1868 = load i64, ptr %.679.i1867, align 8, !noalias !159
  %.683.i1871 = add nsw i64 %.5.i1.i1620, %.5.i.i1568
  %.684.i1872 = mul nsw i64 %.683.i1871, %.
  %.685.i1873 = add nsw i64 %.684.i1872, %.5.i.i1568
  %.686.i1874 = add nsw i64 %.685.i1873, %.680.i1868
  store i64 %.686.i1874, ptr %.679.i1867, align 8, !noalias !159
  store double 0.000000e+00, ptr %.303.i1566, align 8, !noalias !159
  store double 0.000000e+00, ptr %.382.i1618, align 8, !noalias !159
  br label %B416.i1517

B416.i1517:                                       ; preds = %B92.i1520, %B46.if.i2010
  %.148.i1448 = icmp sgt i64 %.93.i1383.09293, 1
  br i1 %.148.i1448, label %B46.if.i2010, label %B4378.endif

B46.if.i2010:                                     ; preds = %B46.if.i2010.lr.ph, %B416.i1517
  %.93.i1383.09293 = phi i64 [ %storemerge, %B46.if.i2010.lr.ph ], [ %.157.i2015, %B416.i1517 ]
  %.90.i1382.09292 = phi i64 [ 0, %B46.if.i2010.lr.ph ], [ %.161.i2018, %B416.i1517 ]
  %.157.i2015 = add nsw i64 %.93.i1383.09293, -1
  %.161.i2018 = add nsw i64 %.90.i1382.09292, 1
  %278 = getelementptr i64, ptr %arg.lane.1.4, i64 %.90.i1382.09292
  %.243.i1513 = load i64, ptr %278, align 8, !noalias !159
  %.248.i1516 = icmp sgt i64 %.243.i1513, -1
  br i1 %.248.i1516, label %B92.i1520, label %B416.i1517

B4379:                                            ; preds = %B222.i, %B4310, %B332.i, %B102.i
  %budget.6.3 = phi i64 [ %budget.5.29286, %B102.i ], [ %budget.7.3, %B332.i ], [ %budget.7.3, %B4310 ], [ %budget.7.3, %B222.i ]
  %active.4.3 = phi i64 [ %active.3.29287, %B102.i ], [ %active.5.3, %B332.i ], [ %active.5.3, %B4310 ], [ %active.5.3, %B222.i ]
  %.5294 = icmp sgt i64 %.5234.09285, 1
  br i1 %.5294, label %B3588.if, label %B4352

B202.endif:                                       ; preds = %B171.i, %entry
  %active.3.i.0.lcssa = phi i64 [ 0, %entry ], [ %active.4.i.1, %B171.i ]
  %.662 = icmp sgt i64 %active.3.i.0.lcssa, 0
  %.678 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.662, i1 %.678, i1 false
  br i1 %or.cond, label %B276.preheader, label %B4378

B276.preheader:                                   ; preds = %B202.endif
  %.722 = getelementptr i8, ptr %arg.lane.2.4, i64 16
  %factor.op.mul = mul i64 %arg.shape.0, %arg.shape.1
  %factor.op.mul9290 = mul i64 %arg.shape.0, %arg.shape.1
  %.818 = getelementptr i8, ptr %arg.code.4, i64 8
  %.873 = icmp sgt i64 %arg.decided, 0
  %.149.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx8793 = mul i64 %arg.lane.0.5.1, 24
  %279 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8793
  %.457.i1839163 = icmp slt i64 %arg.decided, 1
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
  %.idx8788 = mul i64 %arg.lane.0.5.1, 24
  %280 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8788
  %.idx8789 = shl i64 %arg.lane.0.5.1, 5
  %281 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8789
  %.idx8790 = mul i64 %arg.lane.0.5.1, 136
  %282 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8790
  %.idx8791 = mul i64 %arg.lane.0.5.1, 88
  %283 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8791
  %.idx8792 = shl i64 %arg.lane.0.5.1, 4
  %284 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8792
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
  %.153.i.i8819 = getelementptr i8, ptr %arg.linear.1.4, i64 24
  %.183.i.i8821 = getelementptr i8, ptr %arg.linear.1.4, i64 32
  %.186.i.i = add nsw i64 %.124.i.i, %arg.shape.1
  %.187.i.i = add nsw i64 %.186.i.i, 1
  %.224.i.i = icmp slt i64 %arg.shape.1, -2
  %.225.i.i = select i1 %.224.i.i, i64 %arg.linear.1.5.0, i64 0
  %.226.i.i = add i64 %.225.i.i, %.124.i.i
  %.229.i.i = icmp slt i64 %.226.i.i, 0
  %.234.i.i = icmp sge i64 %.226.i.i, %arg.linear.1.5.0
  %285 = or i1 %.229.i.i, %.234.i.i
  %.241.i.i = icmp slt i64 %.186.i.i, -1
  %.242.i.i = select i1 %.241.i.i, i64 %arg.linear.1.5.0, i64 0
  %.243.i.i = add i64 %.242.i.i, %.187.i.i
  %.246.i.i = icmp slt i64 %.243.i.i, 0
  %.251.i.not.i = icmp slt i64 %.243.i.i, %arg.linear.1.5.0
  %.409.i.i = icmp sge i64 %.243.i.i, %arg.linear.1.5.0
  %286 = or i1 %.246.i.i, %.409.i.i
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
  %.idx.i8824 = mul i64 %arg.shape.1, 152
  %287 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx.i8824
  %.534.i.i.i = getelementptr double, ptr %287, i64 %.520.i.i.i
  %.897.i.i.i = mul nsw i64 %arg.shape.1, 17
  %.1279.i.i.idx.i = mul i64 %arg.shape.1, 96
  %.1279.i.i.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1279.i.i.idx.i
  %.2636.i.i = mul nsw i64 %arg.shape.1, 11
  %.idx2423.i = mul i64 %arg.shape.1, 144
  %invariant.gep = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx2423.i
  %.idx2424.i = mul i64 %arg.shape.1, 144
  %invariant.gep9172 = getelementptr double, ptr %arg.arrays.0.4, i64 %.503.i.i.i
  %invariant.gep9174 = getelementptr double, ptr %arg.arrays.0.4, i64 %.503.i.i.i
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
  %.274.i8828 = add i64 %.218.i, %.273.i
  %.277.i = icmp slt i64 %.274.i8828, 0
  %.282.not.i = icmp slt i64 %.274.i8828, %arg.linear.1.5.0
  %.648747.not.i = icmp slt i64 %arg.shape.1, 1
  %.756.i = mul nsw i64 %arg.shape.1, 17
  %.idx.i8831 = mul i64 %arg.shape.1, 80
  %invariant.gep9176 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx.i8831
  %.882.i = getelementptr i8, ptr %arg.linear.1.4, i64 8
  %.887.i = mul nsw i64 %arg.shape.1, 17
  %invariant.gep9178 = getelementptr double, ptr %arg.arrays.0.4, i64 %.887.i
  %.2121 = getelementptr i8, ptr %arg.code.4, i64 64
  %.2203 = icmp sgt i64 %arg.guarded, 0
  %.2208 = icmp sgt i64 %arg.decided, 0
  %.idx8786 = mul i64 %arg.lane.0.5.1, 40
  %288 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8786
  %.idx8787 = mul i64 %arg.lane.0.5.1, 192
  %289 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8787
  %.2558.idx = mul i64 %arg.lane.0.5.1, 40
  %.2558 = getelementptr i8, ptr %arg.lane.0.4, i64 %.2558.idx
  %.2667.idx = mul i64 %arg.lane.0.5.1, 200
  %.2667 = getelementptr i8, ptr %arg.lane.0.4, i64 %.2667.idx
  %.2721.idx = mul i64 %arg.lane.0.5.1, 208
  %.2721 = getelementptr i8, ptr %arg.lane.0.4, i64 %.2721.idx
  %.idx8784 = mul i64 %arg.lane.0.5.1, 200
  %290 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8784
  %.idx8785 = mul i64 %arg.lane.0.5.1, 208
  %291 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8785
  %.idx8778 = shl i64 %arg.lane.1.5.1, 4
  %292 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx8778
  %.idx8779 = mul i64 %arg.lane.0.5.1, 216
  %293 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8779
  %.idx8780 = mul i64 %arg.lane.0.5.1, 72
  %294 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8780
  %.idx8781 = mul i64 %arg.lane.0.5.1, 40
  %295 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8781
  %.idx8782 = mul i64 %arg.lane.0.5.1, 144
  %296 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8782
  %.idx8783 = mul i64 %arg.lane.0.5.1, 56
  %297 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8783
  %.3890.idx = mul i64 %.382, 136
  %.3890 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3890.idx
  %.3915.idx = mul i64 %.382, 104
  %.3915 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3915.idx
  %.3953 = getelementptr i8, ptr %arg.code.4, i64 264
  %.4049 = getelementptr i8, ptr %arg.code.4, i64 40
  %.4071.idx = mul i64 %.382, 136
  %.4071 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4071.idx
  %.idx8773 = mul i64 %arg.lane.0.5.1, 96
  %298 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8773
  %.idx8774 = mul i64 %arg.lane.0.5.1, 40
  %299 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8774
  %.idx8775 = mul i64 %arg.lane.0.5.1, 104
  %300 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8775
  %.idx8776 = mul i64 %arg.lane.0.5.1, 112
  %301 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8776
  %.idx8777 = shl i64 %arg.lane.1.5.1, 5
  %302 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx8777
  %.4410.idx = mul i64 %.382, 136
  %.4410 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4410.idx
  %.4472 = getelementptr i8, ptr %arg.code.4, i64 200
  %.4549 = getelementptr i8, ptr %arg.code.4, i64 104
  %.idx = shl i64 %arg.lane.1.5.1, 4
  %303 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx
  %.idx8737 = mul i64 %arg.lane.0.5.1, 40
  %304 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8737
  %.idx8738 = mul i64 %arg.lane.0.5.1, 56
  %305 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8738
  %.idx8739 = mul i64 %arg.lane.0.5.1, 224
  %306 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8739
  %.idx8740 = shl i64 %arg.lane.0.5.1, 5
  %307 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8740
  %.idx8741 = mul i64 %arg.lane.0.5.1, 96
  %308 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8741
  %.idx8742 = mul i64 %arg.lane.0.5.1, 48
  %309 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8742
  %310 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx8743 = mul i64 %arg.lane.0.5.1, 168
  %311 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8743
  %.4549.c = getelementptr i8, ptr %arg.code.4, i64 104
  %.1013.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.1105.i8848.idx = shl i64 %factor.op.mul, 4
  %.1105.i8848 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1105.i8848.idx
  %.idx1174.i = mul i64 %arg.lane.0.5.1, 104
  %312 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1174.i
  %.idx1175.i = mul i64 %arg.lane.0.5.1, 112
  %313 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1175.i
  %.idx1176.i = mul i64 %arg.lane.0.5.1, 96
  %314 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1176.i
  %.idx1177.i = mul i64 %arg.lane.0.5.1, 48
  %315 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1177.i
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
  %.idx.i8852 = mul i64 %arg.lane.0.5.1, 56
  %316 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx.i8852
  %.idx1165.i = mul i64 %arg.lane.0.5.1, 40
  %317 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1165.i
  %.idx1166.i = shl i64 %arg.lane.0.5.1, 5
  %318 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1166.i
  %319 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.4734.not = icmp eq i64 %arg.guarded, 0
  %.845.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.937.i.idx = shl i64 %factor.op.mul9290, 4
  %.937.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.937.i.idx
  %.idx652.i = mul i64 %arg.lane.0.5.1, 48
  %320 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx652.i
  %.695658.not.i = icmp slt i64 %arg.shape.1, 1
  %.767.i = shl nsw i64 %arg.shape.1, 1
  %.idx.i8861 = mul i64 %arg.lane.0.5.1, 40
  %321 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx.i8861
  %.155.i.i8864 = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i8870 = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i8876 = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i8882 = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i8888 = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i8894 = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i8900 = mul nsw i64 %arg.shape.1, 18
  %factor.op.mul652.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.idx.i8917 = shl i64 %arg.lane.1.5.1, 4
  %322 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx.i8917
  %.idx640.i = mul i64 %arg.lane.0.5.1, 40
  %323 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx640.i
  %.idx641.i = mul i64 %arg.lane.0.5.1, 48
  %324 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx641.i
  %.idx642.i = mul i64 %arg.lane.0.5.1, 56
  %325 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx642.i
  %.917649.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx644.i = mul i64 %arg.lane.0.5.1, 168
  %326 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx644.i
  %.993.i = mul nsw i64 %arg.shape.1, 17
  %327 = add i64 %arg.times.5.0, -1
  %.155.i.i8930 = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i8936 = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i8942 = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i8948 = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i8954 = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i8960 = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i8966 = mul nsw i64 %arg.shape.1, 18
  %.4960 = getelementptr i8, ptr %arg.code.4, i64 96
  %.idx8766 = mul i64 %arg.lane.0.5.1, 96
  %328 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8766
  %.idx8767 = mul i64 %arg.lane.0.5.1, 40
  %329 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8767
  %.idx8768 = mul i64 %arg.lane.0.5.1, 120
  %330 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8768
  %.545.i39659265.not = icmp slt i64 %arg.shape.1, 1
  %.690.i4002 = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %331 = getelementptr double, ptr %arg.times.4, i64 %arg.times.5.0
  %.735.i4031 = getelementptr i8, ptr %331, i64 -8
  %.idx8770 = mul i64 %arg.lane.1.5.1, 24
  %332 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx8770
  %.idx8771 = mul i64 %arg.lane.1.5.1, 24
  %333 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx8771
  %.idx8772 = mul i64 %arg.lane.0.5.1, 24
  %334 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8772
  %.5066.not = icmp ne i64 %arg.jumping, 0
  %.idx1848.i = mul i64 %arg.lane.0.5.1, 40
  %335 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1848.i
  %.idx1849.i = shl i64 %arg.lane.0.5.1, 4
  %336 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1849.i
  %337 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.7511852.not.i = icmp slt i64 %arg.schedule.2.5.0, 1
  %.852.i = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1017.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.1160.i = getelementptr i8, ptr %arg.code.4, i64 32
  %.1231.i8982 = mul nsw i64 %arg.shape.1, 17
  %.1233.i8983 = mul nsw i64 %.1231.i8982, %arg.shape.0
  %.1276.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.1233.i8983
  %.idx1846.i = shl i64 %arg.lane.1.5.1, 4
  %338 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1846.i
  %.17571859.not.i = icmp slt i64 %arg.shape.1, 1
  %.1952.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.2041.not.i = icmp eq i64 %arg.guarded, 0
  %.2073.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx8749 = mul i64 %arg.lane.0.5.1, 40
  %339 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8749
  %.idx8750 = shl i64 %arg.lane.0.5.1, 4
  %340 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8750
  %341 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.idx8751 = mul i64 %arg.lane.0.5.1, 24
  %342 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8751
  %.1103.i9277.not = icmp slt i64 %arg.schedule.2.5.0, 1
  %.1256.i6113 = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.idx8754 = shl i64 %arg.lane.1.5.1, 4
  %343 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx8754
  %.373.i8997 = getelementptr i8, ptr %arg.lane.2.4, i64 8
  %344 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.6961563.not.i9140 = icmp slt i64 %arg.shape.1, 1
  %.851.i9148 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.9661566.not.i9002 = icmp slt i64 %arg.shape.2, 1
  %.11851569.not.i9019 = icmp slt i64 %arg.schedule.2.5.0, 1
  %.1319.i9024 = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1423.i9043 = icmp sgt i64 %arg.shape.0, 1
  %.163.i1572.not.i9046 = icmp slt i64 %arg.shape.1, 1
  %345 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1546.i9063 = shl i64 %arg.lane.0.5.1, 4
  %346 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1546.i9063
  %.idx1547.i9065 = mul i64 %arg.lane.0.5.1, 24
  %347 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1547.i9065
  %.idx1548.i9067 = shl i64 %arg.lane.0.5.1, 5
  %348 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1548.i9067
  %.idx1549.i9069 = mul i64 %arg.lane.0.5.1, 176
  %349 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1549.i9069
  %.idx1550.i9071 = mul i64 %arg.lane.0.5.1, 168
  %350 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1550.i9071
  %.15851575.not.i9074 = icmp slt i64 %arg.shape.1, 1
  %.idx1553.i9106 = shl i64 %arg.lane.0.5.1, 4
  %351 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1553.i9106
  %352 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1554.i9109 = mul i64 %arg.lane.0.5.1, 24
  %353 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1554.i9109
  %.idx1555.i9111 = shl i64 %arg.lane.0.5.1, 5
  %354 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1555.i9111
  %.idx1556.i9113 = mul i64 %arg.lane.0.5.1, 120
  %355 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1556.i9113
  %.idx1557.i9116 = mul i64 %arg.lane.1.5.1, 24
  %356 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1557.i9116
  %.idx1558.i9118 = mul i64 %arg.lane.0.5.1, 168
  %357 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1558.i9118
  %.idx1559.i9120 = mul i64 %arg.lane.0.5.1, 200
  %358 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1559.i9120
  %.idx1560.i9122 = mul i64 %arg.lane.0.5.1, 208
  %359 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1560.i9122
  %.idx1561.i9124 = mul i64 %arg.lane.0.5.1, 152
  %360 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1561.i9124
  %.idx1562.i9126 = mul i64 %arg.lane.0.5.1, 144
  %361 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1562.i9126
  %.idx8753 = mul i64 %arg.lane.0.5.1, 144
  %362 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8753
  %.6245 = tail call i64 @llvm.smin.i64(i64 %arg.times.5.0, i64 0)
  %363 = getelementptr double, ptr %arg.times.4, i64 %arg.times.5.0
  %364 = getelementptr i8, ptr %363, i64 -8
  %.6259 = getelementptr double, ptr %364, i64 %.6245
  %365 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx8755 = shl i64 %arg.lane.1.5.1, 4
  %366 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx8755
  %.idx8756 = mul i64 %arg.lane.0.5.1, 144
  %367 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8756
  %.idx8757 = mul i64 %arg.lane.0.5.1, 184
  %368 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8757
  %.idx8758 = shl i64 %arg.lane.0.5.1, 4
  %369 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8758
  %.idx8759 = mul i64 %arg.lane.0.5.1, 176
  %370 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8759
  %.163.i46809280.not = icmp slt i64 %arg.shape.1, 1
  %371 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx8761 = shl i64 %arg.lane.0.5.1, 4
  %372 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8761
  %.idx8762 = mul i64 %arg.lane.0.5.1, 24
  %373 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8762
  %.idx8763 = shl i64 %arg.lane.0.5.1, 5
  %374 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8763
  %.idx8764 = mul i64 %arg.lane.0.5.1, 176
  %375 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8764
  %.idx8765 = mul i64 %arg.lane.0.5.1, 168
  %376 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx8765
  %377 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %378 = shl i64 %377, 3
  %379 = shl i64 %arg.runs.0.5.1, 3
  %380 = mul i64 %arg.shape.1, -176
  %381 = mul i64 %arg.shape.1, -168
  %382 = mul i64 %arg.shape.1, -160
  %383 = mul i64 %arg.shape.1, -152
  %384 = mul i64 %arg.shape.1, -144
  %385 = mul i64 %arg.shape.1, -136
  %386 = mul i64 %arg.shape.1, -128
  %387 = mul i64 %arg.shape.1, -176
  %388 = mul i64 %arg.shape.1, -168
  %389 = mul i64 %arg.shape.1, -160
  %390 = mul i64 %arg.shape.1, -152
  %391 = mul i64 %arg.shape.1, -144
  %392 = mul i64 %arg.shape.1, -136
  %393 = mul i64 %arg.shape.1, -128
  %394 = add i64 %.idx2424.i, %arg.arrays.0.49432
  %395 = tail call i64 @llvm.smax.i64(i64 %.538.i.i, i64 1)
  %396 = mul i64 %arg.shape.1, -48
  %min.iters.check9458 = icmp ult i64 %arg.shape.1, 4
  %diff.check9452 = icmp ult i64 %396, 32
  %diff.check9453 = icmp ult i64 %.1807.i.idx.i, 32
  %conflict.rdx9454 = or i1 %diff.check9452, %diff.check9453
  %diff.check9455 = icmp ult i64 %.idx2422.i, 32
  %conflict.rdx9456 = or i1 %conflict.rdx9454, %diff.check9455
  %n.vec9461 = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n9468 = icmp eq i64 %arg.shape.1, %n.vec9461
  %min.iters.check9436 = icmp slt i64 %.538.i.i, 4
  %n.vec9439 = and i64 %395, 9223372036854775804
  %397 = sub nsw i64 %storemerge2359.i, %n.vec9439
  %cmp.n9448 = icmp eq i64 %395, %n.vec9439
  %min.iters.check9417 = icmp ult i64 %arg.shape.1, 4
  %diff.check9415 = icmp ult i64 %.idx2424.i, 32
  %or.cond9472 = or i1 %min.iters.check9417, %diff.check9415
  %n.vec9420 = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n9429 = icmp eq i64 %arg.shape.1, %n.vec9420
  %398 = getelementptr i8, ptr %arg.code.4, i64 208
  %.4435.idx = mul i64 %.382, 112
  %.4435 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4435.idx
  %399 = getelementptr i8, ptr %arg.code.4, i64 216
  %.4435.1.idx = mul i64 %.382, 120
  %.4435.1 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4435.1.idx
  %400 = getelementptr i8, ptr %arg.code.4, i64 224
  %.4435.2.idx = shl i64 %.382, 7
  %.4435.2 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4435.2.idx
  %min.iters.check9392 = icmp ne i64 %arg.shape.1, 1
  %ident.check9374.not = icmp eq i64 %arg.shape.0, 1
  %or.cond9473 = and i1 %min.iters.check9392, %ident.check9374.not
  %diff.check9376 = icmp eq i64 %387, 0
  %diff.check9377 = icmp ult i64 %388, 16
  %conflict.rdx9378 = or i1 %diff.check9376, %diff.check9377
  %diff.check9379 = icmp eq i64 %389, 0
  %conflict.rdx9380 = or i1 %conflict.rdx9378, %diff.check9379
  %diff.check9381 = icmp ult i64 %390, 16
  %conflict.rdx9382 = or i1 %conflict.rdx9380, %diff.check9381
  %diff.check9383 = icmp eq i64 %391, 0
  %conflict.rdx9384 = or i1 %conflict.rdx9382, %diff.check9383
  %diff.check9385 = icmp ult i64 %392, 16
  %conflict.rdx9386 = or i1 %conflict.rdx9384, %diff.check9385
  %diff.check9387 = icmp eq i64 %393, 0
  %conflict.rdx9388 = or i1 %conflict.rdx9386, %diff.check9387
  %.mask = and i64 %arg.shape.1, 1152921504606846975
  %diff.check9389 = icmp eq i64 %.mask, 0
  %conflict.rdx9390 = or i1 %conflict.rdx9388, %diff.check9389
  %n.vec9395 = and i64 %arg.shape.1, 9223372036854775806
  %cmp.n9412 = icmp eq i64 %arg.shape.1, %n.vec9395
  %min.iters.check9353 = icmp ne i64 %arg.shape.1, 1
  %ident.check.not = icmp eq i64 %arg.shape.0, 1
  %or.cond9474 = and i1 %min.iters.check9353, %ident.check.not
  %diff.check9338 = icmp eq i64 %380, 0
  %diff.check9339 = icmp ult i64 %381, 16
  %conflict.rdx = or i1 %diff.check9338, %diff.check9339
  %diff.check9340 = icmp eq i64 %382, 0
  %conflict.rdx9341 = or i1 %conflict.rdx, %diff.check9340
  %diff.check9342 = icmp ult i64 %383, 16
  %conflict.rdx9343 = or i1 %conflict.rdx9341, %diff.check9342
  %diff.check9344 = icmp eq i64 %384, 0
  %conflict.rdx9345 = or i1 %conflict.rdx9343, %diff.check9344
  %diff.check9346 = icmp ult i64 %385, 16
  %conflict.rdx9347 = or i1 %conflict.rdx9345, %diff.check9346
  %diff.check9348 = icmp eq i64 %386, 0
  %conflict.rdx9349 = or i1 %conflict.rdx9347, %diff.check9348
  %.mask9470 = and i64 %arg.shape.1, 1152921504606846975
  %diff.check9350 = icmp eq i64 %.mask9470, 0
  %conflict.rdx9351 = or i1 %conflict.rdx9349, %diff.check9350
  %n.vec9356 = and i64 %arg.shape.1, 9223372036854775806
  %cmp.n9371 = icmp eq i64 %arg.shape.1, %n.vec9356
  %min.iters.check9325 = icmp ult i64 %arg.shape.1, 8
  %n.vec9328 = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n9335 = icmp eq i64 %arg.shape.1, %n.vec9328
  br label %B276

B1276.if:                                         ; preds = %B1276.if.preheader, %B1500
  %.1789.09180 = phi i64 [ %.1858, %B1500 ], [ 1, %B1276.if.preheader ]
  %.1858 = add nsw i64 %.1789.09180, 1
  %401 = getelementptr i64, ptr %arg.code.4, i64 %.1789.09180
  %402 = getelementptr i8, ptr %401, i64 104
  %.1917 = load i64, ptr %402, align 8
  %.1962 = inttoptr i64 %.1917 to ptr
  tail call void %.1962(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.1993 = load i64, ptr %arg.code.4, align 8
  %.1999 = mul nsw i64 %.1858, %.382
  %.2043 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1999
  %.2044 = inttoptr i64 %.1993 to ptr
  tail call void %.2044(ptr %.490, ptr %.2018, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.2043)
  br i1 %.539, label %B1464, label %B1500

B1646.if:                                         ; preds = %B1502, %B1732
  %looked.2.19186 = phi i1 [ %"$phi1732.1.2.2", %B1732 ], [ %spec.select8805, %B1502 ]
  %good.2.19185 = phi i1 [ %"$phi1690.1.2.2", %B1732 ], [ false, %B1502 ]
  %.2251.09184 = phi i64 [ %.2313, %B1732 ], [ %storemerge, %B1502 ]
  %.2248.09183 = phi i64 [ %.2317, %B1732 ], [ 0, %B1502 ]
  %.2313 = add nsw i64 %.2251.09184, -1
  %.2317 = add nsw i64 %.2248.09183, 1
  br i1 %good.2.19185, label %B1690, label %B1654

B1922.if:                                         ; preds = %B1920.preheader, %B2440
  %doubted.3.29197 = phi i1 [ %doubted.4.3, %B2440 ], [ false, %B1920.preheader ]
  %within.3.29196 = phi i1 [ %within.4.3, %B2440 ], [ false, %B1920.preheader ]
  %wanted.3.29195 = phi i1 [ %wanted.4.3, %B2440 ], [ false, %B1920.preheader ]
  %.2832.09194 = phi i64 [ %.2904, %B2440 ], [ %storemerge, %B1920.preheader ]
  %.2829.09193 = phi i64 [ %.2908, %B2440 ], [ 0, %B1920.preheader ]
  %.2904 = add nsw i64 %.2832.09194, -1
  %.2908 = add nsw i64 %.2829.09193, 1
  %.2995 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2829.09193
  %.2996 = load i64, ptr %.2995, align 8
  %.3050 = getelementptr i64, ptr %292, i64 %.2829.09193
  %.3051 = load i64, ptr %.3050, align 8
  %.3111 = getelementptr double, ptr %293, i64 %.2829.09193
  store double 0.000000e+00, ptr %.3111, align 8
  %.3114 = icmp sgt i64 %.2996, -1
  br i1 %.3114, label %B2022, label %B2440

B2860.if:                                         ; preds = %B2792
  %.4310 = load i64, ptr %398, align 8
  %.4355 = inttoptr i64 %.4310 to ptr
  tail call void %.4355(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4386 = load i64, ptr %arg.code.4, align 8
  %.4436 = inttoptr i64 %.4386 to ptr
  tail call void %.4436(ptr %.490, ptr %.4410, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.4435)
  %.4310.1 = load i64, ptr %399, align 8
  %.4355.1 = inttoptr i64 %.4310.1 to ptr
  tail call void %.4355.1(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4386.1 = load i64, ptr %arg.code.4, align 8
  %.4436.1 = inttoptr i64 %.4386.1 to ptr
  tail call void %.4436.1(ptr %.490, ptr %.4410, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.4435.1)
  %.4310.2 = load i64, ptr %400, align 8
  %.4355.2 = inttoptr i64 %.4310.2 to ptr
  tail call void %.4355.2(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4386.2 = load i64, ptr %arg.code.4, align 8
  %.4436.2 = inttoptr i64 %.4386.2 to ptr
  tail call void %.4436.2(ptr %.490, ptr %.4410, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.4435.2)
  %.4473 = load i64, ptr %.4472, align 8
  %.4518 = inttoptr i64 %.4473 to ptr
  tail call void %.4518(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4550 = load i64, ptr %.4549, align 8
  %.4595 = inttoptr i64 %.4550 to ptr
  tail call void %.4595(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.274.i, label %B3238, label %B66.if.i

B3588.if:                                         ; preds = %B3550, %B4379
  %active.3.29287 = phi i64 [ %active.4.3, %B4379 ], [ %active.6.0, %B3550 ]
  %budget.5.29286 = phi i64 [ %budget.6.3, %B4379 ], [ %.688, %B3550 ]
  %.5234.09285 = phi i64 [ %.5303, %B4379 ], [ %storemerge, %B3550 ]
  %.5231.09284 = phi i64 [ %.5307, %B4379 ], [ 0, %B3550 ]
  %.5303 = add nsw i64 %.5234.09285, -1
  %.5307 = add nsw i64 %.5231.09284, 1
  %.5392 = getelementptr i64, ptr %arg.lane.1.4, i64 %.5231.09284
  %.5393 = load i64, ptr %.5392, align 8
  %.5398 = icmp slt i64 %.5393, 0
  br i1 %.5398, label %B3634, label %B3674

B4378.endif:                                      ; preds = %B416.i1517, %B4378
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
  br i1 %.191230.not.i, label %_ZN12clpt_control6native9for_numba4keepB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B60.if.lr.ph.i

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
  %.323.i = load i64, ptr %.322.i3688, align 8, !noalias !163
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
  %wide.load = load <2 x double>, ptr %13, align 8, !noalias !163
  %wide.load3792 = load <2 x double>, ptr %14, align 8, !noalias !163
  %15 = getelementptr double, ptr %gep.i, i64 %index
  %16 = getelementptr i8, ptr %15, i64 16
  store <2 x double> %wide.load, ptr %15, align 8, !noalias !163
  store <2 x double> %wide.load3792, ptr %16, align 8, !noalias !163
  %index.next = add i64 %index, 4
  %17 = icmp eq i64 %index.next, %n.vec
  br i1 %17, label %middle.block, label %vector.body, !llvm.loop !166

middle.block:                                     ; preds = %vector.body
  br i1 %cmp.n, label %B216.i, label %B170.if.i.preheader

B170.if.i.preheader:                              ; preds = %vector.memcheck, %B170.if.lr.ph.i, %middle.block
  %.350.0227.i.ph = phi i64 [ 0, %vector.memcheck ], [ 0, %B170.if.lr.ph.i ], [ %n.vec, %middle.block ]
  br label %B170.if.i

B216.i:                                           ; preds = %B170.if.i, %middle.block, %B140.i
  %.587.i = getelementptr i64, ptr %arg.results.2.4, i64 %.286.i
  store i64 %.557.i, ptr %.587.i, align 8, !noalias !163
  br label %B232.i

B232.i:                                           ; preds = %B60.if.i, %B216.i, %B106.i
  %exitcond233.not.i = icmp eq i64 %arg.shape.0, %.204.i
  br i1 %exitcond233.not.i, label %_ZN12clpt_control6native9for_numba4keepB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B60.if.i

B60.if.i:                                         ; preds = %B232.i, %B60.if.lr.ph.i
  %.133.0231.i = phi i64 [ 0, %B60.if.lr.ph.i ], [ %.204.i, %B232.i ]
  %18 = shl i64 %.133.0231.i, 3
  %19 = add i64 %18, %arg.arrays.0.43791
  %20 = sub i64 %arg.results.0.43790, %19
  %.204.i = add nsw i64 %.133.0231.i, 1
  %21 = getelementptr i64, ptr %arg.lane.1.4, i64 %.133.0231.i
  %.286.i = load i64, ptr %21, align 8, !noalias !163
  %.291.i = icmp sgt i64 %.286.i, -1
  br i1 %.291.i, label %B106.i, label %B232.i

B170.if.i:                                        ; preds = %B170.if.i.preheader, %B170.if.i
  %.350.0227.i = phi i64 [ %.419.i, %B170.if.i ], [ %.350.0227.i.ph, %B170.if.i.preheader ]
  %.419.i = add nsw i64 %.350.0227.i, 1
  %.445.i = mul nsw i64 %.350.0227.i, %arg.shape.0
  %gep3754 = getelementptr double, ptr %invariant.gep3753, i64 %.445.i
  %.477.i = load double, ptr %gep3754, align 8, !noalias !163
  %22 = getelementptr double, ptr %gep.i, i64 %.350.0227.i
  store double %.477.i, ptr %22, align 8, !noalias !163
  %exitcond.not.i = icmp eq i64 %arg.shape.1, %.419.i
  br i1 %exitcond.not.i, label %B216.i, label %B170.if.i, !llvm.loop !167

_ZN12clpt_control6native9for_numba4keepB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B232.i, %B1404
  %.4595 = add nsw i64 %done.6.3, 1
  br label %B1452

B1452:                                            ; preds = %_ZN12clpt_control6native9for_numba4keepB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B1380
  %done.5.5 = phi i64 [ %.4595, %_ZN12clpt_control6native9for_numba4keepB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ], [ %done.6.3, %B1380 ]
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
  store ptr @.const.picklebuf.ca8efb3a72d614fe872032cce3ac326007a30727, ptr %excinfo, align 8, !numba_exception_output !168
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
  br i1 %.2155.not3714, label %.2125.endif.preheader, label %.2125.if, !prof !169

.2125.endif.preheader:                            ; preds = %B748.endif.else.endif.endif.endif.if
  %51 = sub i64 %arg.lane.0.5.1, %.2031.sroa.0.3
  %min.iters.check3921 = icmp ult i64 %51, 4
  br i1 %min.iters.check3921, label %.2125.endif.preheader3945, label %vector.ph3922, !prof !170

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
  br i1 %56, label %middle.block3931, label %vector.body3927, !prof !171, !llvm.loop !172

middle.block3931:                                 ; preds = %vector.body3927
  %cmp.n3932 = icmp eq i64 %51, %n.vec3924
  br i1 %cmp.n3932, label %.2125.if, label %.2125.endif.preheader3945, !prof !174

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
  br i1 %exitcond3771.not, label %.2125.if, label %.2125.endif, !prof !175, !llvm.loop !176

B358.i:                                           ; preds = %B308.if.i, %middle.block3875, %.1482.if.i
  %.1747.i = load i64, ptr %arg.code.4, align 8, !noalias !178
  %.1794.i = inttoptr i64 %.1747.i to ptr
  tail call void %.1794.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1793.i), !noalias !178
  %.1943.i = load i64, ptr %39, align 8, !noalias !178
  %.1988.i = inttoptr i64 %.1943.i to ptr
  tail call void %.1988.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !178
  %.2019.i = load i64, ptr %arg.code.4, align 8, !noalias !178
  %.2069.i = inttoptr i64 %.2019.i to ptr
  tail call void %.2069.i(ptr %.322.i, ptr %.2043.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.2068.i), !noalias !178
  %.1943.i.1 = load i64, ptr %40, align 8, !noalias !178
  %.1988.i.1 = inttoptr i64 %.1943.i.1 to ptr
  tail call void %.1988.i.1(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !178
  %.2019.i.1 = load i64, ptr %arg.code.4, align 8, !noalias !178
  %.2069.i.1 = inttoptr i64 %.2019.i.1 to ptr
  tail call void %.2069.i.1(ptr %.322.i, ptr %.2043.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.2068.i.1), !noalias !178
  %.1943.i.2 = load i64, ptr %41, align 8, !noalias !178
  %.1988.i.2 = inttoptr i64 %.1943.i.2 to ptr
  tail call void %.1988.i.2(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !178
  %.2019.i.2 = load i64, ptr %arg.code.4, align 8, !noalias !178
  %.2069.i.2 = inttoptr i64 %.2019.i.2 to ptr
  tail call void %.2069.i.2(ptr %.322.i, ptr %.2043.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.2068.i.2), !noalias !178
  %.2106.i = load i64, ptr %.2105.i, align 8, !noalias !178
  %.2151.i = inttoptr i64 %.2106.i to ptr
  tail call void %.2151.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !178
  br i1 %.2154.i.not, label %B806.i, label %B738.i

B738.i:                                           ; preds = %B358.i
  %.2185.i = load i64, ptr %.2184.i, align 8, !noalias !178
  %.2230.i = inttoptr i64 %.2185.i to ptr
  tail call void %.2230.i(ptr %.322.i, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !178
  br label %B806.i

B806.i:                                           ; preds = %B738.i, %B358.i
  br i1 %.2316.i3731.not, label %B1254.i, label %B840.if.i

B890.i:                                           ; preds = %B840.if.i
  %.2450.i = getelementptr i64, ptr %arg.results.1.4, i64 %.2411.i
  %.2451.i = load i64, ptr %.2450.i, align 8, !noalias !178
  %.2452.i.not = icmp eq i64 %.2451.i, 0
  br i1 %.2452.i.not, label %B926.i, label %B1465.i

B926.i:                                           ; preds = %B890.i
  %.2522.i = mul i64 %.2411.i, %arg.results.3.5.1
  %.2526.i = getelementptr i64, ptr %arg.results.3.4, i64 %.2522.i
  %.2527.i = load i64, ptr %.2526.i, align 8, !noalias !178
  %.2528.i = add nsw i64 %.2527.i, 1
  store i64 %.2528.i, ptr %.2526.i, align 8, !noalias !178
  %.2636.i = getelementptr i8, ptr %.2526.i, i64 8
  %.2637.i = load i64, ptr %.2636.i, align 8, !noalias !178
  %.2638.i = add nsw i64 %.2637.i, 4
  store i64 %.2638.i, ptr %.2636.i, align 8, !noalias !178
  br i1 %.2771.i3727.not, label %B1154.i, label %B1048.if.i.preheader

B1048.if.i.preheader:                             ; preds = %B926.i
  %invariant.gep3954 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2260.i.03732
  br label %B1048.if.i

B1094.i.loopexit:                                 ; preds = %B1048.if.i
  %58 = fcmp une double %.2845.i, 0.000000e+00
  br i1 %58, label %B1106.i, label %B1154.i

B1106.i:                                          ; preds = %B1094.i.loopexit
  %.84.i.i = load i64, ptr %92, align 8, !noalias !182
  %.89.i.i = icmp sgt i64 %.84.i.i, -1
  br i1 %.89.i.i, label %B46.i.i, label %B1465.i

B46.i.i:                                          ; preds = %B1106.i
  %.120.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i.i
  %.121.i.i = load i64, ptr %.120.i.i, align 8, !noalias !182
  %.122.i.i = icmp eq i64 %.121.i.i, 0
  br i1 %.122.i.i, label %B80.i.i, label %B1465.i

B80.i.i:                                          ; preds = %B46.i.i
  store i64 3, ptr %.120.i.i, align 8, !noalias !182
  br label %B1465.i

B1154.i:                                          ; preds = %B926.i, %B1094.i.loopexit
  br i1 %.2154.i.not, label %B1242.i, label %B1158.i

B1158.i:                                          ; preds = %B1154.i
  %59 = getelementptr double, ptr %arg.arrays.4.4, i64 %.2260.i.03732
  %.2933.i = load double, ptr %59, align 8, !noalias !178
  %.2935.i = fcmp olt double %.2933.i, -1.000000e-09
  br i1 %.2935.i, label %B1194.i, label %B1242.i

B1194.i:                                          ; preds = %B1158.i
  %.84.i63.i = load i64, ptr %92, align 8, !noalias !185
  %.89.i66.i = icmp sgt i64 %.84.i63.i, -1
  br i1 %.89.i66.i, label %B46.i71.i, label %B1465.i

B46.i71.i:                                        ; preds = %B1194.i
  %.120.i91.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i63.i
  %.121.i92.i = load i64, ptr %.120.i91.i, align 8, !noalias !185
  %.122.i93.i = icmp eq i64 %.121.i92.i, 0
  br i1 %.122.i93.i, label %B80.i98.i, label %B1465.i

B80.i98.i:                                        ; preds = %B46.i71.i
  store i64 4, ptr %.120.i91.i, align 8, !noalias !185
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
  %wide.load3855 = load <2 x double>, ptr %62, align 8, !alias.scope !188, !noalias !178
  %wide.load3856 = load <2 x double>, ptr %63, align 8, !alias.scope !188, !noalias !178
  %64 = getelementptr i8, ptr %61, i64 16
  %wide.load3857 = load <2 x double>, ptr %61, align 8, !alias.scope !191, !noalias !193
  %wide.load3858 = load <2 x double>, ptr %64, align 8, !alias.scope !191, !noalias !193
  %65 = fsub <2 x double> %wide.load3857, %wide.load3855
  %66 = fsub <2 x double> %wide.load3858, %wide.load3856
  store <2 x double> %wide.load3855, ptr %61, align 8, !alias.scope !191, !noalias !193
  store <2 x double> %wide.load3856, ptr %64, align 8, !alias.scope !191, !noalias !193
  store <2 x double> %65, ptr %62, align 8, !alias.scope !188, !noalias !178
  store <2 x double> %66, ptr %63, align 8, !alias.scope !188, !noalias !178
  %index.next3859 = add i64 %index3854, 4
  %67 = icmp eq i64 %index.next3859, %n.vec3852
  br i1 %67, label %middle.block3860, label %vector.body3853, !llvm.loop !194

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
  br i1 %.684.i.not3716, label %.654.endif.i.preheader, label %B186.if.i.preheader, !prof !169

.654.endif.i.preheader:                           ; preds = %B0.endif.else.endif.endif.i
  %68 = sub i64 %arg.lane.0.5.1, %spec.select
  %min.iters.check3907 = icmp ult i64 %68, 4
  br i1 %min.iters.check3907, label %.654.endif.i.preheader3944, label %vector.ph3908, !prof !170

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
  store <2 x double> %broadcast.splat3912, ptr %71, align 8, !noalias !178
  store <2 x double> %broadcast.splat3912, ptr %72, align 8, !noalias !178
  %index.next3916 = add i64 %index3914, 4
  %73 = icmp eq i64 %index.next3916, %n.vec3910
  br i1 %73, label %middle.block3917, label %vector.body3913, !prof !171, !llvm.loop !195

middle.block3917:                                 ; preds = %vector.body3913
  %cmp.n3918 = icmp eq i64 %68, %n.vec3910
  br i1 %cmp.n3918, label %B186.if.i.preheader, label %.654.endif.i.preheader3944, !prof !174

.654.endif.i.preheader3944:                       ; preds = %.654.endif.i.preheader, %middle.block3917
  %.650.i.03717.ph = phi i64 [ %spec.select, %.654.endif.i.preheader ], [ %69, %middle.block3917 ]
  br label %.654.endif.i

.654.endif.i:                                     ; preds = %.654.endif.i.preheader3944, %.654.endif.i
  %.650.i.03717 = phi i64 [ %.698.i, %.654.endif.i ], [ %.650.i.03717.ph, %.654.endif.i.preheader3944 ]
  %.693.i = getelementptr double, ptr %24, i64 %.650.i.03717
  store double %.2504, ptr %.693.i, align 8, !noalias !178
  %.698.i = add nsw i64 %.650.i.03717, 1
  %exitcond3772.not = icmp eq i64 %.698.i, %arg.lane.0.5.1
  br i1 %exitcond3772.not, label %B186.if.i.preheader, label %.654.endif.i, !prof !175, !llvm.loop !196

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
  br i1 %.1169.i.not3718, label %.1139.endif.i.preheader, label %.1140.else.i, !prof !169

.1139.endif.i.preheader:                          ; preds = %B188.endif.else.endif.endif.i
  %74 = sub i64 %arg.lane.0.5.1, %spec.select3684
  %min.iters.check3893 = icmp ult i64 %74, 4
  br i1 %min.iters.check3893, label %.1139.endif.i.preheader3938, label %vector.ph3894, !prof !170

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
  store <2 x double> %broadcast.splat3898, ptr %77, align 8, !noalias !178
  store <2 x double> %broadcast.splat3898, ptr %78, align 8, !noalias !178
  %index.next3902 = add i64 %index3900, 4
  %79 = icmp eq i64 %index.next3902, %n.vec3896
  br i1 %79, label %middle.block3903, label %vector.body3899, !prof !171, !llvm.loop !197

middle.block3903:                                 ; preds = %vector.body3899
  %cmp.n3904 = icmp eq i64 %74, %n.vec3896
  br i1 %cmp.n3904, label %.1140.else.i, label %.1139.endif.i.preheader3938, !prof !174

.1139.endif.i.preheader3938:                      ; preds = %.1139.endif.i.preheader, %middle.block3903
  %.1135.i.03719.ph = phi i64 [ %spec.select3684, %.1139.endif.i.preheader ], [ %75, %middle.block3903 ]
  br label %.1139.endif.i

.1139.endif.i:                                    ; preds = %.1139.endif.i.preheader3938, %.1139.endif.i
  %.1135.i.03719 = phi i64 [ %.1183.i, %.1139.endif.i ], [ %.1135.i.03719.ph, %.1139.endif.i.preheader3938 ]
  %.1178.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1135.i.03719
  store double %.839.i, ptr %.1178.i, align 8, !noalias !178
  %.1183.i = add nsw i64 %.1135.i.03719, 1
  %exitcond3773.not = icmp eq i64 %.1183.i, %arg.lane.0.5.1
  br i1 %exitcond3773.not, label %.1140.else.i, label %.1139.endif.i, !prof !175, !llvm.loop !198

.1140.else.i:                                     ; preds = %.1139.endif.i, %middle.block3903, %B188.endif.else.endif.endif.i
  br i1 %.2059, label %.1140.endif.else.endif.if.i, label %.1140.endif.else.endif.endif.i, !prof !36

.1140.endif.else.endif.if.i:                      ; preds = %.1140.else.i
  br label %.1140.endif.else.endif.endif.i

.1140.endif.else.endif.endif.i:                   ; preds = %.1140.endif.else.endif.if.i, %.1140.else.i
  %spec.select3685 = phi i64 [ %arg.lane.0.5.1, %.1140.endif.else.endif.if.i ], [ 0, %.1140.else.i ]
  %.1512.i.not3720 = icmp slt i64 %spec.select3685, %arg.lane.0.5.1
  br i1 %.1512.i.not3720, label %.1482.endif.i.preheader, label %.1482.if.i, !prof !169

.1482.endif.i.preheader:                          ; preds = %.1140.endif.else.endif.endif.i
  %80 = sub i64 %arg.lane.0.5.1, %spec.select3685
  %min.iters.check3879 = icmp ult i64 %80, 4
  br i1 %min.iters.check3879, label %.1482.endif.i.preheader3937, label %vector.ph3880, !prof !170

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
  store <2 x double> %broadcast.splat3884, ptr %83, align 8, !noalias !178
  store <2 x double> %broadcast.splat3884, ptr %84, align 8, !noalias !178
  %index.next3888 = add i64 %index3886, 4
  %85 = icmp eq i64 %index.next3888, %n.vec3882
  br i1 %85, label %middle.block3889, label %vector.body3885, !prof !171, !llvm.loop !199

middle.block3889:                                 ; preds = %vector.body3885
  %cmp.n3890 = icmp eq i64 %80, %n.vec3882
  br i1 %cmp.n3890, label %.1482.if.i, label %.1482.endif.i.preheader3937, !prof !174

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
  %wide.load3872 = load <2 x double>, ptr %86, align 8, !noalias !178
  %wide.load3873 = load <2 x double>, ptr %87, align 8, !noalias !178
  %88 = getelementptr i8, ptr %86, i64 %38
  %89 = getelementptr i8, ptr %88, i64 16
  store <2 x double> %wide.load3872, ptr %88, align 8, !noalias !178
  store <2 x double> %wide.load3873, ptr %89, align 8, !noalias !178
  %index.next3874 = add i64 %index3871, 4
  %90 = icmp eq i64 %index.next3874, %n.vec3869
  br i1 %90, label %middle.block3875, label %vector.body3870, !llvm.loop !200

middle.block3875:                                 ; preds = %vector.body3870
  br i1 %cmp.n3876, label %B358.i, label %B308.if.i.preheader3936

B308.if.i.preheader3936:                          ; preds = %B308.if.i.preheader, %middle.block3875
  %.1556.i.03724.ph = phi i64 [ 0, %B308.if.i.preheader ], [ %n.vec3869, %middle.block3875 ]
  br label %B308.if.i

.1482.endif.i:                                    ; preds = %.1482.endif.i.preheader3937, %.1482.endif.i
  %.1478.i.03721 = phi i64 [ %.1526.i, %.1482.endif.i ], [ %.1478.i.03721.ph, %.1482.endif.i.preheader3937 ]
  %.1521.i = getelementptr double, ptr %23, i64 %.1478.i.03721
  store double %.845.i, ptr %.1521.i, align 8, !noalias !178
  %.1526.i = add nsw i64 %.1478.i.03721, 1
  %exitcond3774.not = icmp eq i64 %.1526.i, %arg.lane.0.5.1
  br i1 %exitcond3774.not, label %.1482.if.i, label %.1482.endif.i, !prof !175, !llvm.loop !201

B308.if.i:                                        ; preds = %B308.if.i.preheader3936, %B308.if.i
  %.1556.i.03724 = phi i64 [ %.1625.i, %B308.if.i ], [ %.1556.i.03724.ph, %B308.if.i.preheader3936 ]
  %.1625.i = add nsw i64 %.1556.i.03724, 1
  %91 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1556.i.03724
  %.1679.i = load double, ptr %91, align 8, !noalias !178
  %gep3953 = getelementptr double, ptr %invariant.gep3952, i64 %.1556.i.03724
  store double %.1679.i, ptr %gep3953, align 8, !noalias !178
  %exitcond3775.not = icmp eq i64 %.214.i, %.1625.i
  br i1 %exitcond3775.not, label %B358.i, label %B308.if.i, !llvm.loop !202

B840.if.i:                                        ; preds = %B806.i, %B1465.i
  %active.3.i.13734 = phi i64 [ %active.4.i.2, %B1465.i ], [ 0, %B806.i ]
  %.2260.i.03732 = phi i64 [ %.2329.i, %B1465.i ], [ 0, %B806.i ]
  %.2329.i = add nsw i64 %.2260.i.03732, 1
  %92 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2260.i.03732
  %.2411.i = load i64, ptr %92, align 8, !noalias !178
  %.2419.i = icmp slt i64 %.2411.i, 0
  br i1 %.2419.i, label %B1465.i, label %B890.i

B1048.if.i:                                       ; preds = %B1048.if.i.preheader, %B1048.if.i
  %trouble.2.i.33730 = phi double [ %.2845.i, %B1048.if.i ], [ 0.000000e+00, %B1048.if.i.preheader ]
  %.2715.i.03728 = phi i64 [ %.2784.i, %B1048.if.i ], [ 0, %B1048.if.i.preheader ]
  %.2784.i = add nsw i64 %.2715.i.03728, 1
  %93 = mul nsw i64 %.2715.i.03728, %arg.shape.0
  %gep3955 = getelementptr double, ptr %invariant.gep3954, i64 %93
  %.2842.i = load double, ptr %gep3955, align 8, !noalias !178
  %.2843.i = fmul double %.2842.i, 0.000000e+00
  %.2845.i = fadd double %trouble.2.i.33730, %.2843.i
  %exitcond3777.not = icmp eq i64 %arg.shape.1, %.2784.i
  br i1 %exitcond3777.not, label %B1094.i.loopexit, label %B1048.if.i

B1328.if.i:                                       ; preds = %B1328.if.i.preheader3943, %B1328.if.i
  %.3105.i.03739 = phi i64 [ %.3174.i, %B1328.if.i ], [ %.3105.i.03739.ph, %B1328.if.i.preheader3943 ]
  %.3174.i = add nsw i64 %.3105.i.03739, 1
  %gep3957 = getelementptr double, ptr %invariant.gep3956, i64 %.3105.i.03739
  %.3231.i = load double, ptr %gep3957, align 8, !noalias !178
  %94 = getelementptr double, ptr %arg.arrays.0.4, i64 %.3105.i.03739
  %.3261.i = load double, ptr %94, align 8, !noalias !178
  %.3295.i = fsub double %.3261.i, %.3231.i
  store double %.3231.i, ptr %94, align 8, !noalias !178
  store double %.3295.i, ptr %gep3957, align 8, !noalias !178
  %exitcond3779.not = icmp eq i64 %arg.shape.1, %.3174.i
  br i1 %exitcond3779.not, label %B906.endif.endif.endif.endif.endif, label %B1328.if.i, !llvm.loop !203

B906.endif.endif.endif.endif.endif:               ; preds = %B1328.if.i, %middle.block3860, %B1274.i
  br i1 %active.3.i.1.lcssa, label %B1154, label %B1532

B1190.else.endif:                                 ; preds = %B1162
  br i1 %.2059, label %B1190.endif.else.endif.if, label %B1190.endif.else.endif.endif.endif.if, !prof !36

B1190.endif.else.endif.if:                        ; preds = %B1190.else.endif
  br label %B1190.endif.else.endif.endif.endif.if

B1190.endif.else.endif.endif.endif.if:            ; preds = %B1190.endif.else.endif.if, %B1190.else.endif
  %.2874.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %B1190.endif.else.endif.if ], [ 0, %B1190.else.endif ]
  %.2998.not3741 = icmp slt i64 %.2874.sroa.0.3, %arg.lane.0.5.1
  br i1 %.2998.not3741, label %.2968.endif.preheader, label %.2969.else.endif, !prof !169

.2968.endif.preheader:                            ; preds = %B1190.endif.else.endif.endif.endif.if
  %95 = sub i64 %arg.lane.0.5.1, %.2874.sroa.0.3
  %min.iters.check3831 = icmp ult i64 %95, 4
  br i1 %min.iters.check3831, label %.2968.endif.preheader3942, label %vector.ph3832, !prof !170

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
  br i1 %100, label %middle.block3841, label %vector.body3837, !prof !171, !llvm.loop !204

middle.block3841:                                 ; preds = %vector.body3837
  %cmp.n3842 = icmp eq i64 %95, %n.vec3834
  br i1 %cmp.n3842, label %.2969.else.endif, label %.2968.endif.preheader3942, !prof !174

.2968.endif.preheader3942:                        ; preds = %.2968.endif.preheader, %middle.block3841
  %.2964.03742.ph = phi i64 [ %.2874.sroa.0.3, %.2968.endif.preheader ], [ %96, %middle.block3841 ]
  br label %.2968.endif

.2968.endif:                                      ; preds = %.2968.endif.preheader3942, %.2968.endif
  %.2964.03742 = phi i64 [ %.3012, %.2968.endif ], [ %.2964.03742.ph, %.2968.endif.preheader3942 ]
  %.3007 = getelementptr double, ptr %arg.lane.0.4, i64 %.2964.03742
  store double %.11.i3686, ptr %.3007, align 8
  %.3012 = add nsw i64 %.2964.03742, 1
  %exitcond3780.not = icmp eq i64 %.3012, %arg.lane.0.5.1
  br i1 %exitcond3780.not, label %.2969.else.endif, label %.2968.endif, !prof !175, !llvm.loop !205

.2969.else.endif:                                 ; preds = %.2968.endif, %middle.block3841, %B1190.endif.else.endif.endif.endif.if
  br i1 %.2059, label %.2969.endif.else.endif.if, label %.2969.endif.else.endif.endif.endif.if, !prof !36

.2969.endif.else.endif.if:                        ; preds = %.2969.else.endif
  br label %.2969.endif.else.endif.endif.endif.if

.2969.endif.else.endif.endif.endif.if:            ; preds = %.2969.endif.else.endif.if, %.2969.else.endif
  %.3218.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %.2969.endif.else.endif.if ], [ 0, %.2969.else.endif ]
  %.3342.not3743 = icmp slt i64 %.3218.sroa.0.3, %arg.lane.0.5.1
  br i1 %.3342.not3743, label %.3312.endif.preheader, label %.3313.else.endif, !prof !169

.3312.endif.preheader:                            ; preds = %.2969.endif.else.endif.endif.endif.if
  %101 = sub i64 %arg.lane.0.5.1, %.3218.sroa.0.3
  %min.iters.check3817 = icmp ult i64 %101, 4
  br i1 %min.iters.check3817, label %.3312.endif.preheader3941, label %vector.ph3818, !prof !170

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
  br i1 %106, label %middle.block3827, label %vector.body3823, !prof !171, !llvm.loop !206

middle.block3827:                                 ; preds = %vector.body3823
  %cmp.n3828 = icmp eq i64 %101, %n.vec3820
  br i1 %cmp.n3828, label %.3313.else.endif, label %.3312.endif.preheader3941, !prof !174

.3312.endif.preheader3941:                        ; preds = %.3312.endif.preheader, %middle.block3827
  %.3308.03744.ph = phi i64 [ %.3218.sroa.0.3, %.3312.endif.preheader ], [ %102, %middle.block3827 ]
  br label %.3312.endif

.3312.endif:                                      ; preds = %.3312.endif.preheader3941, %.3312.endif
  %.3308.03744 = phi i64 [ %.3356, %.3312.endif ], [ %.3308.03744.ph, %.3312.endif.preheader3941 ]
  %.3351 = getelementptr double, ptr %25, i64 %.3308.03744
  store double %.11.i3686, ptr %.3351, align 8
  %.3356 = add nsw i64 %.3308.03744, 1
  %exitcond3781.not = icmp eq i64 %.3356, %arg.lane.0.5.1
  br i1 %exitcond3781.not, label %.3313.else.endif, label %.3312.endif, !prof !175, !llvm.loop !207

.3313.else.endif:                                 ; preds = %.3312.endif, %middle.block3827, %.2969.endif.else.endif.endif.endif.if
  br i1 %.2059, label %.3313.endif.else.endif.if, label %.3313.endif.else.endif.endif.endif.if, !prof !36

.3313.endif.else.endif.if:                        ; preds = %.3313.else.endif
  br label %.3313.endif.else.endif.endif.endif.if

.3313.endif.else.endif.endif.endif.if:            ; preds = %.3313.endif.else.endif.if, %.3313.else.endif
  %.3561.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %.3313.endif.else.endif.if ], [ 0, %.3313.else.endif ]
  %.3685.not3745 = icmp slt i64 %.3561.sroa.0.3, %arg.lane.0.5.1
  br i1 %.3685.not3745, label %.3655.endif.preheader, label %.3656.else.endif, !prof !169

.3655.endif.preheader:                            ; preds = %.3313.endif.else.endif.endif.endif.if
  %107 = sub i64 %arg.lane.0.5.1, %.3561.sroa.0.3
  %min.iters.check3805 = icmp ult i64 %107, 4
  br i1 %min.iters.check3805, label %.3655.endif.preheader3940, label %vector.ph3806, !prof !170

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
  br i1 %112, label %middle.block3813, label %vector.body3809, !prof !171, !llvm.loop !208

middle.block3813:                                 ; preds = %vector.body3809
  %cmp.n3814 = icmp eq i64 %107, %n.vec3808
  br i1 %cmp.n3814, label %.3656.else.endif, label %.3655.endif.preheader3940, !prof !174

.3655.endif.preheader3940:                        ; preds = %.3655.endif.preheader, %middle.block3813
  %.3651.03746.ph = phi i64 [ %.3561.sroa.0.3, %.3655.endif.preheader ], [ %108, %middle.block3813 ]
  br label %.3655.endif

.3655.endif:                                      ; preds = %.3655.endif.preheader3940, %.3655.endif
  %.3651.03746 = phi i64 [ %.3699, %.3655.endif ], [ %.3651.03746.ph, %.3655.endif.preheader3940 ]
  %.3694 = getelementptr double, ptr %26, i64 %.3651.03746
  store double 1.000000e+00, ptr %.3694, align 8
  %.3699 = add nsw i64 %.3651.03746, 1
  %exitcond3782.not = icmp eq i64 %.3699, %arg.lane.0.5.1
  br i1 %exitcond3782.not, label %.3656.else.endif, label %.3655.endif, !prof !175, !llvm.loop !209

.3656.else.endif:                                 ; preds = %.3655.endif, %middle.block3813, %.3313.endif.else.endif.endif.endif.if
  br i1 %.3933, label %.3656.endif.else.endif.if, label %.3656.endif.else.endif.endif.endif.if, !prof !36

.3656.endif.else.endif.if:                        ; preds = %.3656.else.endif
  br label %.3656.endif.else.endif.endif.endif.if

.3656.endif.else.endif.endif.endif.if:            ; preds = %.3656.endif.else.endif.if, %.3656.else.endif
  %.3905.sroa.0.3 = phi i64 [ %arg.lane.1.5.1, %.3656.endif.else.endif.if ], [ 0, %.3656.else.endif ]
  %.4029.not3747 = icmp slt i64 %.3905.sroa.0.3, %arg.lane.1.5.1
  br i1 %.4029.not3747, label %.3999.endif.preheader, label %.4000.else.endif, !prof !169

.3999.endif.preheader:                            ; preds = %.3656.endif.else.endif.endif.endif.if
  %113 = sub i64 %arg.lane.1.5.1, %.3905.sroa.0.3
  %min.iters.check3794 = icmp ult i64 %113, 4
  br i1 %min.iters.check3794, label %.3999.endif.preheader3939, label %vector.ph3795, !prof !170

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
  br i1 %118, label %middle.block3801, label %vector.body3798, !prof !171, !llvm.loop !210

middle.block3801:                                 ; preds = %vector.body3798
  %cmp.n3802 = icmp eq i64 %113, %n.vec3797
  br i1 %cmp.n3802, label %.4000.else.endif, label %.3999.endif.preheader3939, !prof !174

.3999.endif.preheader3939:                        ; preds = %.3999.endif.preheader, %middle.block3801
  %.3995.03748.ph = phi i64 [ %.3905.sroa.0.3, %.3999.endif.preheader ], [ %114, %middle.block3801 ]
  br label %.3999.endif

.3999.endif:                                      ; preds = %.3999.endif.preheader3939, %.3999.endif
  %.3995.03748 = phi i64 [ %.4043, %.3999.endif ], [ %.3995.03748.ph, %.3999.endif.preheader3939 ]
  %.4038 = getelementptr i64, ptr %27, i64 %.3995.03748
  store i64 %edge.2.1, ptr %.4038, align 8
  %.4043 = add nsw i64 %.3995.03748, 1
  %exitcond3783.not = icmp eq i64 %.4043, %arg.lane.1.5.1
  br i1 %exitcond3783.not, label %.4000.else.endif, label %.3999.endif, !prof !175, !llvm.loop !211

.4000.else.endif:                                 ; preds = %.3999.endif, %middle.block3801, %.3656.endif.else.endif.endif.endif.if
  br i1 %.3933, label %.4000.endif.else.endif.if, label %.4000.endif.else.endif.endif.endif.if, !prof !36

.4000.endif.else.endif.if:                        ; preds = %.4000.else.endif
  br label %.4000.endif.else.endif.endif.endif.if

.4000.endif.else.endif.endif.endif.if:            ; preds = %.4000.endif.else.endif.if, %.4000.else.endif
  %.4248.sroa.0.3 = phi i64 [ %arg.lane.1.5.1, %.4000.endif.else.endif.if ], [ 0, %.4000.else.endif ]
  %.4372.not3749 = icmp slt i64 %.4248.sroa.0.3, %arg.lane.1.5.1
  br i1 %.4372.not3749, label %.4342.endif.preheader, label %.4342.if, !prof !169

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
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !212
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i3696, label %B358.i3693

B80.i.i3696:                                      ; preds = %B46.i.i3692
  %.196.i.i = getelementptr double, ptr %28, i64 %.352.01856.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !212
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B358.i3693, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i3696
  %.264.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.352.01856.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !212
  %.321.i.i = getelementptr double, ptr %29, i64 %.352.01856.i
  %.322.i.i = load double, ptr %.321.i.i, align 8, !noalias !212
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.1462
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01858.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01858.i
  br i1 %brmerge.i, label %B358.i3693, label %B300.if.lr.ph.i

B300.if.lr.ph.i:                                  ; preds = %B122.i.i
  %.650.i = getelementptr i64, ptr %30, i64 %.352.01856.i
  %.651.i = load i64, ptr %.650.i, align 8, !noalias !217
  %.652.i = add nsw i64 %.651.i, 1
  %122 = getelementptr i64, ptr %arg.runs.2.4, i64 %.99.i.i
  %.596.i = load i64, ptr %122, align 8, !noalias !217
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
  %.1018.i = load i64, ptr %.2205, align 8, !noalias !217
  %.1130.i = inttoptr i64 %.1018.i to ptr
  tail call void %.1130.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !217
  %.1161.i = load i64, ptr %.1160.i, align 8, !noalias !217
  %.1277.i = inttoptr i64 %.1161.i to ptr
  tail call void %.1277.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1276.i), !noalias !217
  br label %B600.if.i

B46.i82.i:                                        ; preds = %B600.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !218
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B980.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %28, i64 %.1303.01865.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !218
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B980.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1303.01865.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !218
  %.321.i223.i = getelementptr double, ptr %29, i64 %.1303.01865.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !218
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B980.i, label %B640.i

B640.i:                                           ; preds = %B122.i147.i
  %.1557.i = getelementptr i64, ptr %31, i64 %.1303.01865.i
  %.1558.i = load i64, ptr %.1557.i, align 8, !noalias !217
  %.1569.i = icmp sgt i64 %.1558.i, 0
  br i1 %.1569.i, label %B716.i, label %B770.i

B716.i:                                           ; preds = %B640.i
  %125 = getelementptr double, ptr %arg.times.4, i64 %.1558.i
  %.1604.i = getelementptr i8, ptr %125, i64 -8
  %.1605.i = load double, ptr %.1604.i, align 8, !noalias !217
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
  store double %.1835.i, ptr %128, align 8, !noalias !217
  br label %B920.i

B920.i:                                           ; preds = %B802.if.i, %B898.i
  %exitcond1871.not.i = icmp eq i64 %arg.shape.1, %.1770.i
  br i1 %exitcond1871.not.i, label %B922.loopexit.i, label %B802.if.i

B922.loopexit.i:                                  ; preds = %B920.i
  %129 = fcmp une double %.1842.i, 0.000000e+00
  br i1 %129, label %B934.i, label %B980.i

B934.i:                                           ; preds = %B922.loopexit.i
  %.84.i516.i = load i64, ptr %135, align 8, !noalias !221
  %.89.i518.i = icmp sgt i64 %.84.i516.i, -1
  br i1 %.89.i518.i, label %B46.i521.i, label %B980.i

B46.i521.i:                                       ; preds = %B934.i
  %.120.i539.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i516.i
  %.121.i540.i = load i64, ptr %.120.i539.i, align 8, !noalias !221
  %.122.i541.i = icmp eq i64 %.121.i540.i, 0
  br i1 %.122.i541.i, label %B80.i545.i, label %B980.i

B80.i545.i:                                       ; preds = %B46.i521.i
  store i64 3, ptr %.120.i539.i, align 8, !noalias !221
  br label %B980.i

B980.i:                                           ; preds = %B600.if.i, %B80.i545.i, %B46.i521.i, %B934.i, %B922.loopexit.i, %B770.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %exitcond1872.not.i = icmp eq i64 %arg.shape.0, %.1372.i
  br i1 %exitcond1872.not.i, label %B982.i, label %B600.if.i

B982.i:                                           ; preds = %B980.i
  br i1 %.2041.not.i, label %B1380, label %B986.i

B986.i:                                           ; preds = %B982.i
  %.2074.i = load i64, ptr %.2073.i, align 8, !noalias !217
  %.2188.i = inttoptr i64 %.2074.i to ptr
  tail call void %.2188.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !217
  br label %B1106.if.i

B46.i315.i:                                       ; preds = %B1106.if.i
  %.135.i335.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i311.i
  %.136.i336.i = load i64, ptr %.135.i335.i, align 8, !noalias !224
  %.141.i339.not.i = icmp eq i64 %.136.i336.i, 0
  br i1 %.141.i339.not.i, label %B80.i340.i, label %B1228.i

B80.i340.i:                                       ; preds = %B46.i315.i
  %.196.i377.i = getelementptr double, ptr %28, i64 %.2224.01868.i
  %.197.i378.i = load double, ptr %.196.i377.i, align 8, !noalias !224
  %.198.i379.i = fcmp olt double %.197.i378.i, 5.000000e-01
  br i1 %.198.i379.i, label %B1228.i, label %B122.i380.i

B122.i380.i:                                      ; preds = %B80.i340.i
  %.264.i417.i = getelementptr double, ptr %arg.lane.0.4, i64 %.2224.01868.i
  %.265.i418.i = load double, ptr %.264.i417.i, align 8, !noalias !224
  %.321.i456.i = getelementptr double, ptr %29, i64 %.2224.01868.i
  %.322.i457.i = load double, ptr %.321.i456.i, align 8, !noalias !224
  %.325.i459.i = fcmp une double %.265.i418.i, %.322.i457.i
  br i1 %.325.i459.i, label %B1228.i, label %B1146.i

B1146.i:                                          ; preds = %B122.i380.i
  %130 = getelementptr double, ptr %arg.arrays.4.4, i64 %.2224.01868.i
  %.2400.i = load double, ptr %130, align 8, !noalias !217
  %.2402.i = fcmp olt double %.2400.i, -1.000000e-09
  br i1 %.2402.i, label %B80.i672.i, label %B1228.i

B80.i672.i:                                       ; preds = %B1146.i
  store i64 4, ptr %.135.i335.i, align 8, !noalias !227
  br label %B1228.i

B1228.i:                                          ; preds = %B1106.if.i, %B80.i672.i, %B1146.i, %B122.i380.i, %B80.i340.i, %B46.i315.i
  %exitcond3785.not = icmp eq i64 %arg.shape.0, %.2293.i
  br i1 %exitcond3785.not, label %B1380, label %B1106.if.i

B110.if.i:                                        ; preds = %.4342.if, %B358.i3693
  %some.2.01858.i = phi i1 [ %some.3.2.i, %B358.i3693 ], [ false, %.4342.if ]
  %.352.01856.i = phi i64 [ %.423.i3691, %B358.i3693 ], [ 0, %.4342.if ]
  %.423.i3691 = add nsw i64 %.352.01856.i, 1
  %131 = getelementptr i64, ptr %arg.lane.1.4, i64 %.352.01856.i
  %.99.i.i = load i64, ptr %131, align 8, !noalias !212
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B358.i3693, label %B46.i.i3692

B300.if.i:                                        ; preds = %B300.if.i, %B300.if.lr.ph.i
  %.692.01853.i = phi i64 [ 0, %B300.if.lr.ph.i ], [ %.764.i, %B300.if.i ]
  %.764.i = add nsw i64 %.692.01853.i, 1
  %132 = getelementptr double, ptr %124, i64 %.692.01853.i
  %.861.i = load double, ptr %132, align 8, !noalias !217
  %133 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.692.01853.i
  %.891.i = load i64, ptr %133, align 8, !noalias !217
  %.893.i = mul nsw i64 %.891.i, %arg.shape.0
  %.895.i = add nsw i64 %.893.i, %.352.01856.i
  %.909.i = icmp slt i64 %.895.i, 0
  %.910.i = select i1 %.909.i, i64 %arg.arrays.1.5.0, i64 0
  %134 = getelementptr double, ptr %arg.arrays.1.4, i64 %.895.i
  %.924.i = getelementptr double, ptr %134, i64 %.910.i
  store double %.861.i, ptr %.924.i, align 8, !noalias !217
  %exitcond.not.i3697 = icmp eq i64 %arg.schedule.2.5.0, %.764.i
  br i1 %exitcond.not.i3697, label %B358.i3693, label %B300.if.i

B600.if.i:                                        ; preds = %B980.i, %B368.i
  %.1303.01865.i = phi i64 [ 0, %B368.i ], [ %.1372.i, %B980.i ]
  %.1372.i = add nsw i64 %.1303.01865.i, 1
  %135 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1303.01865.i
  %.99.i78.i = load i64, ptr %135, align 8, !noalias !218
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B980.i, label %B46.i82.i

B802.if.i:                                        ; preds = %B920.i, %B802.if.lr.ph.i
  %trouble.2.11862.i = phi double [ 0.000000e+00, %B802.if.lr.ph.i ], [ %.1842.i, %B920.i ]
  %.1701.01860.i = phi i64 [ 0, %B802.if.lr.ph.i ], [ %.1770.i, %B920.i ]
  %.1770.i = add nsw i64 %.1701.01860.i, 1
  %.1801.i = add nsw i64 %.1701.01860.i, %.1231.i
  %.1803.i = mul nsw i64 %.1801.i, %arg.shape.0
  %gep = getelementptr double, ptr %invariant.gep, i64 %.1803.i
  %.1835.i = load double, ptr %gep, align 8, !noalias !217
  %.1840.i = fmul double %.1835.i, 0.000000e+00
  %.1842.i = fadd double %trouble.2.11862.i, %.1840.i
  %.1850.i = mul nsw i64 %.1701.01860.i, %arg.shape.0
  %gep3752 = getelementptr double, ptr %invariant.gep3751, i64 %.1850.i
  store double %.1835.i, ptr %gep3752, align 8, !noalias !217
  br i1 %"$phi770.1.2.1.i", label %B898.i, label %B920.i

B1106.if.i:                                       ; preds = %B1228.i, %B986.i
  %.2224.01868.i = phi i64 [ 0, %B986.i ], [ %.2293.i, %B1228.i ]
  %.2293.i = add nsw i64 %.2224.01868.i, 1
  %136 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2224.01868.i
  %.99.i311.i = load i64, ptr %136, align 8, !noalias !224
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
  br i1 %8, label %middle.block, label %vector.body, !llvm.loop !230

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
  br i1 %exitcond540.not, label %B64.loopexit, label %B430.if, !llvm.loop !231
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
!74 = !{!75, !77}
!75 = distinct !{!75, !76, !"_ZN12clpt_control6native9for_numba5doubtB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!76 = distinct !{!76, !"_ZN12clpt_control6native9for_numba5doubtB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!77 = distinct !{!77, !76, !"_ZN12clpt_control6native9for_numba5doubtB3v25B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!78 = !{!79}
!79 = distinct !{!79, !80, !"_ZN12clpt_control6native9for_numba5crossB3v26B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!80 = distinct !{!80, !"_ZN12clpt_control6native9for_numba5crossB3v26B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!81 = !{!82, !84, !79}
!82 = distinct !{!82, !83, !"_ZN12clpt_control6native9for_numba6passedB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!83 = distinct !{!83, !"_ZN12clpt_control6native9for_numba6passedB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!84 = distinct !{!84, !83, !"_ZN12clpt_control6native9for_numba6passedB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!85 = !{!86, !88, !79}
!86 = distinct !{!86, !87, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!87 = distinct !{!87, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!88 = distinct !{!88, !87, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!89 = distinct !{!89, !7, !8}
!90 = distinct !{!90, !7}
!91 = !{!92}
!92 = distinct !{!92, !93, !"_ZN12clpt_control6native9for_numba5watchB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!93 = distinct !{!93, !"_ZN12clpt_control6native9for_numba5watchB3v29B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!94 = !{!95, !92}
!95 = distinct !{!95, !96, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!96 = distinct !{!96, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!97 = !{!98, !100, !92}
!98 = distinct !{!98, !99, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!99 = distinct !{!99, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!100 = distinct !{!100, !99, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!101 = distinct !{!101, !7, !8}
!102 = distinct !{!102, !7}
!103 = !{!104}
!104 = distinct !{!104, !105, !"_ZN12clpt_control6native9for_numba6sampleB3v30B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!105 = distinct !{!105, !"_ZN12clpt_control6native9for_numba6sampleB3v30B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!106 = !{!107, !109, !104}
!107 = distinct !{!107, !108, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!108 = distinct !{!108, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!109 = distinct !{!109, !108, !"_ZN12clpt_control6native9for_numba7betweenB3v27B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!110 = !{!111, !113}
!111 = distinct !{!111, !112, !"_ZN12clpt_control6native9for_numba11decide_anewB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi3EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!112 = distinct !{!112, !"_ZN12clpt_control6native9for_numba11decide_anewB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi3EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!113 = distinct !{!113, !112, !"_ZN12clpt_control6native9for_numba11decide_anewB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE8UniTupleIxLi3EE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!114 = !{!115, !111, !113}
!115 = distinct !{!115, !116, !"_ZN12clpt_control6native9for_numba4failB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29: %retptr"}
!116 = distinct !{!116, !"_ZN12clpt_control6native9for_numba4failB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29"}
!117 = !{!118, !120}
!118 = distinct !{!118, !119, !"_ZN12clpt_control6native9for_numba6at_endB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!119 = distinct !{!119, !"_ZN12clpt_control6native9for_numba6at_endB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!120 = distinct !{!120, !121, !"_ZN12clpt_control6native9for_numba4leapB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx: %retptr"}
!121 = distinct !{!121, !"_ZN12clpt_control6native9for_numba4leapB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx"}
!122 = !{!120}
!123 = !{!124, !120}
!124 = distinct !{!124, !125, !"_ZN12clpt_control6native9for_numba6at_endB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!125 = distinct !{!125, !"_ZN12clpt_control6native9for_numba6at_endB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!126 = !{!127, !120}
!127 = distinct !{!127, !128, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!128 = distinct !{!128, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!129 = !{!130, !120}
!130 = distinct !{!130, !131, !"_ZN12clpt_control6native9for_numba6at_endB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!131 = distinct !{!131, !"_ZN12clpt_control6native9for_numba6at_endB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!132 = !{!133, !120}
!133 = distinct !{!133, !134, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!134 = distinct !{!134, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!135 = !{!136, !138}
!136 = distinct !{!136, !137, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!137 = distinct !{!137, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!138 = distinct !{!138, !137, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!139 = !{!140}
!140 = distinct !{!140, !141, !"_ZN12clpt_control6native9for_numba4failB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29: %retptr"}
!141 = distinct !{!141, !"_ZN12clpt_control6native9for_numba4failB3v35B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29"}
!142 = !{!143, !145}
!143 = distinct !{!143, !144, !"_ZN12clpt_control6native9for_numba5enterB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!144 = distinct !{!144, !"_ZN12clpt_control6native9for_numba5enterB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!145 = distinct !{!145, !144, !"_ZN12clpt_control6native9for_numba5enterB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!146 = !{!147}
!147 = distinct !{!147, !148, !"_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!148 = distinct !{!148, !"_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!149 = distinct !{!149, !7, !8}
!150 = !{!151, !153, !147}
!151 = distinct !{!151, !152, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!152 = distinct !{!152, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!153 = distinct !{!153, !152, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!154 = distinct !{!154, !7}
!155 = !{!156, !158}
!156 = distinct !{!156, !157, !"_ZN12clpt_control6native9for_numba10look_againB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!157 = distinct !{!157, !"_ZN12clpt_control6native9for_numba10look_againB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!158 = distinct !{!158, !157, !"_ZN12clpt_control6native9for_numba10look_againB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedEx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!159 = !{!160, !162}
!160 = distinct !{!160, !161, !"_ZN12clpt_control6native9for_numba5countB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!161 = distinct !{!161, !"_ZN12clpt_control6native9for_numba5countB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!162 = distinct !{!162, !161, !"_ZN12clpt_control6native9for_numba5countB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIxLi2E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!163 = !{!164}
!164 = distinct !{!164, !165, !"_ZN12clpt_control6native9for_numba4keepB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!165 = distinct !{!165, !"_ZN12clpt_control6native9for_numba4keepB3v43B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!166 = distinct !{!166, !7, !8}
!167 = distinct !{!167, !7}
!168 = !{i1 true}
!169 = !{!"branch_weights", i32 127, i32 1}
!170 = !{!"branch_weights", i32 1, i32 127}
!171 = !{!"branch_weights", i32 127, i32 3048}
!172 = distinct !{!172, !7, !8, !173}
!173 = !{!"llvm.loop.estimated_trip_count", i32 25}
!174 = !{!"branch_weights", i32 1, i32 3}
!175 = !{!"branch_weights", i32 1, i32 0}
!176 = distinct !{!176, !8, !7, !177}
!177 = !{!"llvm.loop.estimated_trip_count", i32 0}
!178 = !{!179, !181}
!179 = distinct !{!179, !180, !"_ZN12clpt_control6native9for_numba5marchB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEddx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx: %retptr"}
!180 = distinct !{!180, !"_ZN12clpt_control6native9for_numba5marchB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEddx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx"}
!181 = distinct !{!181, !180, !"_ZN12clpt_control6native9for_numba5marchB3v41B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEddx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx: %excinfo"}
!182 = !{!183, !179, !181}
!183 = distinct !{!183, !184, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!184 = distinct !{!184, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!185 = !{!186, !179, !181}
!186 = distinct !{!186, !187, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!187 = distinct !{!187, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!188 = !{!189}
!189 = distinct !{!189, !190}
!190 = distinct !{!190, !"LVerDomain"}
!191 = !{!192}
!192 = distinct !{!192, !190}
!193 = !{!179, !181, !189}
!194 = distinct !{!194, !7, !8}
!195 = distinct !{!195, !7, !8, !173}
!196 = distinct !{!196, !8, !7, !177}
!197 = distinct !{!197, !7, !8, !173}
!198 = distinct !{!198, !8, !7, !177}
!199 = distinct !{!199, !7, !8, !173}
!200 = distinct !{!200, !7, !8}
!201 = distinct !{!201, !8, !7, !177}
!202 = distinct !{!202, !7}
!203 = distinct !{!203, !7}
!204 = distinct !{!204, !7, !8, !173}
!205 = distinct !{!205, !8, !7, !177}
!206 = distinct !{!206, !7, !8, !173}
!207 = distinct !{!207, !8, !7, !177}
!208 = distinct !{!208, !7, !8, !173}
!209 = distinct !{!209, !8, !7, !177}
!210 = distinct !{!210, !7, !8, !173}
!211 = distinct !{!211, !8, !7, !177}
!212 = !{!213, !215}
!213 = distinct !{!213, !214, !"_ZN12clpt_control6native9for_numba6at_endB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!214 = distinct !{!214, !"_ZN12clpt_control6native9for_numba6at_endB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!215 = distinct !{!215, !216, !"_ZN12clpt_control6native9for_numba4leapB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx: %retptr"}
!216 = distinct !{!216, !"_ZN12clpt_control6native9for_numba4leapB3v33B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx"}
!217 = !{!215}
!218 = !{!219, !215}
!219 = distinct !{!219, !220, !"_ZN12clpt_control6native9for_numba6at_endB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!220 = distinct !{!220, !"_ZN12clpt_control6native9for_numba6at_endB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!221 = !{!222, !215}
!222 = distinct !{!222, !223, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!223 = distinct !{!223, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!224 = !{!225, !215}
!225 = distinct !{!225, !226, !"_ZN12clpt_control6native9for_numba6at_endB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!226 = distinct !{!226, !"_ZN12clpt_control6native9for_numba6at_endB3v34B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!227 = !{!228, !215}
!228 = distinct !{!228, !229, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!229 = distinct !{!229, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!230 = distinct !{!230, !7, !8}
!231 = distinct !{!231, !7}

; sha256 93d0fc9ab5d1a464c8bda9b801b9d29442b34da37d66081c312f3888b2154517

@.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727 = internal constant [76 x i8] c"\80\04\95A\00\00\00\00\00\00\00\8C\08builtins\94\8C\0AValueError\94\93\94\8C\1Erange() arg 3 must not be zero\94\85\94N\87\94."
@.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727.sha1 = internal constant [20 x i8] c"\CA\8E\FB:r\D6\14\FE\87 2\CC\E3\AC2`\07\A3\07'"
@.const.picklebuf.ca8efb3a72d614fe872032cce3ac326007a30727 = internal constant { ptr, i32, ptr, ptr, i32 } { ptr @.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727, i32 76, ptr @.const.pickledata.ca8efb3a72d614fe872032cce3ac326007a30727.sha1, ptr null, i32 0 }

define dso_local noundef i32 @advance(ptr noalias %retptr, ptr noalias readnone %excinfo, ptr readnone %arg.code.0, ptr readnone %arg.code.1, i64 %arg.code.2, i64 %arg.code.3, ptr readonly %arg.code.4, i64 %arg.code.5.0, i64 %arg.code.6.0, i64 %arg.shape.0, i64 %arg.shape.1, i64 %arg.shape.2, ptr readnone %arg.tolerances.0, ptr readnone %arg.tolerances.1, i64 %arg.tolerances.2, i64 %arg.tolerances.3, ptr %arg.tolerances.4, i64 %arg.tolerances.5.0, i64 %arg.tolerances.6.0, ptr readnone %arg.runs.0.0, ptr readnone %arg.runs.0.1, i64 %arg.runs.0.2, i64 %arg.runs.0.3, ptr readonly %arg.runs.0.4, i64 %arg.runs.0.5.0, i64 %arg.runs.0.5.1, i64 %arg.runs.0.6.0, i64 %arg.runs.0.6.1, ptr readnone %arg.runs.1.0, ptr readnone %arg.runs.1.1, i64 %arg.runs.1.2, i64 %arg.runs.1.3, ptr readonly %arg.runs.1.4, i64 %arg.runs.1.5.0, i64 %arg.runs.1.5.1, i64 %arg.runs.1.6.0, i64 %arg.runs.1.6.1, ptr readnone %arg.runs.2.0, ptr readnone %arg.runs.2.1, i64 %arg.runs.2.2, i64 %arg.runs.2.3, ptr readonly %arg.runs.2.4, i64 %arg.runs.2.5.0, i64 %arg.runs.2.6.0, ptr readnone %arg.schedule.0.0, ptr readnone %arg.schedule.0.1, i64 %arg.schedule.0.2, i64 %arg.schedule.0.3, ptr readonly %arg.schedule.0.4, i64 %arg.schedule.0.5.0, i64 %arg.schedule.0.5.1, i64 %arg.schedule.0.6.0, i64 %arg.schedule.0.6.1, ptr readnone %arg.schedule.1.0, ptr readnone %arg.schedule.1.1, i64 %arg.schedule.1.2, i64 %arg.schedule.1.3, ptr readonly %arg.schedule.1.4, i64 %arg.schedule.1.5.0, i64 %arg.schedule.1.6.0, ptr readnone %arg.schedule.2.0, ptr readnone %arg.schedule.2.1, i64 %arg.schedule.2.2, i64 %arg.schedule.2.3, ptr readonly %arg.schedule.2.4, i64 %arg.schedule.2.5.0, i64 %arg.schedule.2.6.0, ptr readnone %arg.schedule.3.0, ptr readnone %arg.schedule.3.1, i64 %arg.schedule.3.2, i64 %arg.schedule.3.3, ptr readonly %arg.schedule.3.4, i64 %arg.schedule.3.5.0, i64 %arg.schedule.3.5.1, i64 %arg.schedule.3.5.2, i64 %arg.schedule.3.6.0, i64 %arg.schedule.3.6.1, i64 %arg.schedule.3.6.2, ptr readnone %arg.schedule.4.0, ptr readnone %arg.schedule.4.1, i64 %arg.schedule.4.2, i64 %arg.schedule.4.3, ptr readonly %arg.schedule.4.4, i64 %arg.schedule.4.5.0, i64 %arg.schedule.4.5.1, i64 %arg.schedule.4.6.0, i64 %arg.schedule.4.6.1, ptr readnone %arg.times.0, ptr readnone %arg.times.1, i64 %arg.times.2, i64 %arg.times.3, ptr readonly %arg.times.4, i64 %arg.times.5.0, i64 %arg.times.6.0, ptr readnone %arg.results.0.0, ptr readnone %arg.results.0.1, i64 %arg.results.0.2, i64 %arg.results.0.3, ptr %arg.results.0.4, i64 %arg.results.0.5.0, i64 %arg.results.0.5.1, i64 %arg.results.0.5.2, i64 %arg.results.0.6.0, i64 %arg.results.0.6.1, i64 %arg.results.0.6.2, ptr readnone %arg.results.1.0, ptr readnone %arg.results.1.1, i64 %arg.results.1.2, i64 %arg.results.1.3, ptr %arg.results.1.4, i64 %arg.results.1.5.0, i64 %arg.results.1.6.0, ptr readnone %arg.results.2.0, ptr readnone %arg.results.2.1, i64 %arg.results.2.2, i64 %arg.results.2.3, ptr %arg.results.2.4, i64 %arg.results.2.5.0, i64 %arg.results.2.6.0, ptr readnone %arg.results.3.0, ptr readnone %arg.results.3.1, i64 %arg.results.3.2, i64 %arg.results.3.3, ptr %arg.results.3.4, i64 %arg.results.3.5.0, i64 %arg.results.3.5.1, i64 %arg.results.3.6.0, i64 %arg.results.3.6.1, ptr readnone %arg.lane.0.0, ptr readnone %arg.lane.0.1, i64 %arg.lane.0.2, i64 %arg.lane.0.3, ptr %arg.lane.0.4, i64 %arg.lane.0.5.0, i64 %arg.lane.0.5.1, i64 %arg.lane.0.6.0, i64 %arg.lane.0.6.1, ptr readnone %arg.lane.1.0, ptr readnone %arg.lane.1.1, i64 %arg.lane.1.2, i64 %arg.lane.1.3, ptr %arg.lane.1.4, i64 %arg.lane.1.5.0, i64 %arg.lane.1.5.1, i64 %arg.lane.1.6.0, i64 %arg.lane.1.6.1, ptr readnone %arg.lane.2.0, ptr readnone %arg.lane.2.1, i64 %arg.lane.2.2, i64 %arg.lane.2.3, ptr %arg.lane.2.4, i64 %arg.lane.2.5.0, i64 %arg.lane.2.6.0, ptr readnone %arg.arrays.0.0, ptr readnone %arg.arrays.0.1, i64 %arg.arrays.0.2, i64 %arg.arrays.0.3, ptr %arg.arrays.0.4, i64 %arg.arrays.0.5.0, i64 %arg.arrays.0.6.0, ptr readnone %arg.arrays.1.0, ptr readnone %arg.arrays.1.1, i64 %arg.arrays.1.2, i64 %arg.arrays.1.3, ptr %arg.arrays.1.4, i64 %arg.arrays.1.5.0, i64 %arg.arrays.1.6.0, ptr readnone %arg.arrays.2.0, ptr readnone %arg.arrays.2.1, i64 %arg.arrays.2.2, i64 %arg.arrays.2.3, ptr %arg.arrays.2.4, i64 %arg.arrays.2.5.0, i64 %arg.arrays.2.6.0, ptr readnone %arg.arrays.3.0, ptr readnone %arg.arrays.3.1, i64 %arg.arrays.3.2, i64 %arg.arrays.3.3, ptr %arg.arrays.3.4, i64 %arg.arrays.3.5.0, i64 %arg.arrays.3.6.0, ptr readnone %arg.arrays.4.0, ptr readnone %arg.arrays.4.1, i64 %arg.arrays.4.2, i64 %arg.arrays.4.3, ptr %arg.arrays.4.4, i64 %arg.arrays.4.5.0, i64 %arg.arrays.4.6.0, ptr readnone %arg.linear.0.0, ptr readnone %arg.linear.0.1, i64 %arg.linear.0.2, i64 %arg.linear.0.3, ptr %arg.linear.0.4, i64 %arg.linear.0.5.0, i64 %arg.linear.0.6.0, ptr readnone %arg.linear.1.0, ptr readnone %arg.linear.1.1, i64 %arg.linear.1.2, i64 %arg.linear.1.3, ptr %arg.linear.1.4, i64 %arg.linear.1.5.0, i64 %arg.linear.1.6.0, ptr readnone %arg.linear.2.0, ptr readnone %arg.linear.2.1, i64 %arg.linear.2.2, i64 %arg.linear.2.3, ptr %arg.linear.2.4, i64 %arg.linear.2.5.0, i64 %arg.linear.2.6.0, ptr readnone %arg.linear.3.0, ptr readnone %arg.linear.3.1, i64 %arg.linear.3.2, i64 %arg.linear.3.3, ptr readonly %arg.linear.3.4, i64 %arg.linear.3.5.0, i64 %arg.linear.3.6.0, ptr readnone %arg.linear.4.0, ptr readnone %arg.linear.4.1, i64 %arg.linear.4.2, i64 %arg.linear.4.3, ptr readonly %arg.linear.4.4, i64 %arg.linear.4.5.0, i64 %arg.linear.4.6.0, ptr readnone %arg.linear.5.0, ptr readnone %arg.linear.5.1, i64 %arg.linear.5.2, i64 %arg.linear.5.3, ptr readonly %arg.linear.5.4, i64 %arg.linear.5.5.0, i64 %arg.linear.5.6.0, ptr readnone %arg.linear.6.0, ptr readnone %arg.linear.6.1, i64 %arg.linear.6.2, i64 %arg.linear.6.3, ptr readonly %arg.linear.6.4, i64 %arg.linear.6.5.0, i64 %arg.linear.6.6.0, ptr readnone %arg.linear.7.0, ptr readnone %arg.linear.7.1, i64 %arg.linear.7.2, i64 %arg.linear.7.3, ptr readonly %arg.linear.7.4, i64 %arg.linear.7.5.0, i64 %arg.linear.7.6.0, ptr readnone %arg.linear.8.0, ptr readnone %arg.linear.8.1, i64 %arg.linear.8.2, i64 %arg.linear.8.3, ptr readonly %arg.linear.8.4, i64 %arg.linear.8.5.0, i64 %arg.linear.8.6.0, ptr readnone %arg.linear.9.0, ptr readnone %arg.linear.9.1, i64 %arg.linear.9.2, i64 %arg.linear.9.3, ptr readonly %arg.linear.9.4, i64 %arg.linear.9.5.0, i64 %arg.linear.9.6.0, i64 %arg.budget, i64 %arg.most, i64 %arg.guarded, i64 %arg.jumping, i64 %arg.held, i64 %arg.decided) local_unnamed_addr {
entry:
  %arg.linear.4.47800 = ptrtoint ptr %arg.linear.4.4 to i64
  %arg.arrays.0.47799 = ptrtoint ptr %arg.arrays.0.4 to i64
  %arg.runs.0.47689 = ptrtoint ptr %arg.runs.0.4 to i64
  %arg.results.0.47688 = ptrtoint ptr %arg.results.0.4 to i64
  %.454 = mul nsw i64 %arg.shape.1, %arg.shape.0
  %.562.idx = shl i64 %arg.lane.0.5.1, 6
  %.562 = getelementptr i8, ptr %arg.lane.0.4, i64 %.562.idx
  %.611 = icmp sgt i64 %arg.linear.0.5.0, 0
  %. = select i1 %.611, i64 8, i64 11
  %.274.i = icmp slt i64 %arg.shape.0, 1
  %storemerge = select i1 %.274.i, i64 0, i64 %arg.shape.0
  br i1 %.274.i, label %B202.endif, label %B50.if.i.lr.ph

B50.if.i.lr.ph:                                   ; preds = %entry
  %arg.results.0.47684 = ptrtoint ptr %arg.results.0.4 to i64
  %arg.runs.0.47685 = ptrtoint ptr %arg.runs.0.4 to i64
  %.373.i7232 = getelementptr i8, ptr %arg.lane.2.4, i64 8
  %.444.i = getelementptr i8, ptr %arg.lane.2.4, i64 16
  %0 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.idx.i = shl i64 %arg.lane.1.5.1, 4
  %1 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx.i
  %.6961437.not.i = icmp slt i64 %arg.shape.1, 1
  %.851.i7236 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
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
  %.420.i = add nsw i64 %active.3.i.07555, 1
  br label %B171.i

B116.i:                                           ; preds = %B50.if.i
  %.314.i = load i64, ptr %arg.lane.2.4, align 8, !noalias !0
  %.374.i = load i64, ptr %.373.i7232, align 8, !noalias !0
  %.375.i7233 = icmp slt i64 %.314.i, %.374.i
  br i1 %.375.i7233, label %B130.i, label %B316.i

B130.i:                                           ; preds = %B116.i
  %.385.i = add nsw i64 %.314.i, 1
  store i64 %.385.i, ptr %arg.lane.2.4, align 8, !noalias !0
  store i64 1, ptr %.444.i, align 8, !noalias !0
  %.502.i7235 = getelementptr i64, ptr %arg.lane.1.4, i64 %.260.i.07553
  store i64 %.314.i, ptr %.502.i7235, align 8, !noalias !0
  %.557.i = getelementptr i64, ptr %0, i64 %.260.i.07553
  store i64 0, ptr %.557.i, align 8, !noalias !0
  %.612.i = getelementptr i64, ptr %1, i64 %.260.i.07553
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
  %.853.i = mul i64 %.851.i7236, %.823.i
  %17 = getelementptr double, ptr %arg.results.0.4, i64 %.853.i
  br i1 %min.iters.check, label %B272.if.i.preheader, label %vector.memcheck

vector.memcheck:                                  ; preds = %B272.if.lr.ph.i
  %18 = mul i64 %14, %.823.i
  %19 = mul i64 %15, %.759.i
  %20 = add i64 %18, %arg.results.0.47684
  %21 = add i64 %19, %arg.runs.0.47685
  %22 = sub i64 %20, %21
  %diff.check = icmp ult i64 %22, 32
  br i1 %diff.check, label %B272.if.i.preheader, label %vector.body

vector.body:                                      ; preds = %vector.memcheck, %vector.body
  %index = phi i64 [ %index.next, %vector.body ], [ 0, %vector.memcheck ]
  %23 = getelementptr double, ptr %16, i64 %index
  %24 = getelementptr i8, ptr %23, i64 16
  %wide.load = load <2 x double>, ptr %23, align 8, !noalias !0
  %wide.load7686 = load <2 x double>, ptr %24, align 8, !noalias !0
  %25 = getelementptr double, ptr %17, i64 %index
  %26 = getelementptr i8, ptr %25, i64 16
  store <2 x double> %wide.load, ptr %25, align 8, !noalias !0
  store <2 x double> %wide.load7686, ptr %26, align 8, !noalias !0
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
  %invariant.gep7847 = getelementptr double, ptr %arg.arrays.1.4, i64 %.260.i.07553
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
  br i1 %.375.i7233, label %B574.i, label %B520.i

B520.i:                                           ; preds = %B516.i
  br i1 %.1423.i.not, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, label %B532.i

B532.i:                                           ; preds = %B520.i
  br i1 %.163.i1446.not.i, label %B102.i.i, label %B46.if.i.i.preheader

B46.if.i.i.preheader:                             ; preds = %B532.i
  %invariant.gep7849 = getelementptr double, ptr %arg.arrays.0.4, i64 %.260.i.07553
  br label %B46.if.i.i

B102.i.i:                                         ; preds = %B46.if.i.i, %B532.i
  %.360.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.260.i.07553
  store double 0.000000e+00, ptr %.360.i.i, align 8, !noalias !9
  %.415.i.i = getelementptr double, ptr %2, i64 %.260.i.07553
  store double 5.000000e-01, ptr %.415.i.i, align 8, !noalias !9
  %.470.i.i = getelementptr double, ptr %3, i64 %.260.i.07553
  store double 1.000000e+00, ptr %.470.i.i, align 8, !noalias !9
  %.529.i.i = getelementptr double, ptr %4, i64 %.260.i.07553
  store double 0.000000e+00, ptr %.529.i.i, align 8, !noalias !9
  %.586.i.i = getelementptr double, ptr %5, i64 %.260.i.07553
  store double 0.000000e+00, ptr %.586.i.i, align 8, !noalias !9
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit

B46.if.i.i:                                       ; preds = %B46.if.i.i.preheader, %B46.if.i.i
  %.105.i.01447.i = phi i64 [ %.176.i.i, %B46.if.i.i ], [ 0, %B46.if.i.i.preheader ]
  %.176.i.i = add nsw i64 %.105.i.01447.i, 1
  %30 = getelementptr double, ptr %arg.runs.0.4, i64 %.105.i.01447.i
  %.255.i.i = load double, ptr %30, align 8, !noalias !9
  %.257.i.i = mul nsw i64 %.105.i.01447.i, %arg.shape.0
  %gep7850 = getelementptr double, ptr %invariant.gep7849, i64 %.257.i.i
  store double %.255.i.i, ptr %gep7850, align 8, !noalias !9
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
  %invariant.gep7851 = getelementptr double, ptr %arg.arrays.0.4, i64 %.260.i.07553
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
  %.1895.i = getelementptr double, ptr %arg.lane.0.4, i64 %.260.i.07553
  store double %.1748.i, ptr %.1895.i, align 8, !noalias !0
  %.1950.i = getelementptr double, ptr %6, i64 %.260.i.07553
  store double %.1839.i, ptr %.1950.i, align 8, !noalias !0
  %.2005.i = getelementptr double, ptr %7, i64 %.260.i.07553
  store double 0.000000e+00, ptr %.2005.i, align 8, !noalias !0
  %.2064.i = getelementptr double, ptr %8, i64 %.260.i.07553
  store double 1.000000e+00, ptr %.2064.i, align 8, !noalias !0
  %.2119.i = getelementptr double, ptr %9, i64 %.260.i.07553
  store double 0.000000e+00, ptr %.2119.i, align 8, !noalias !0
  %.2175.i = getelementptr double, ptr %10, i64 %.260.i.07553
  store double 0xFFF0000000000000, ptr %.2175.i, align 8, !noalias !0
  %33 = getelementptr i64, ptr %11, i64 %.260.i.07553
  store i64 0, ptr %33, align 8, !noalias !0
  %.2287.i = getelementptr double, ptr %12, i64 %.260.i.07553
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
  %gep7848 = getelementptr double, ptr %invariant.gep7847, i64 %.1056.i
  store double %.1054.i, ptr %gep7848, align 8, !noalias !0
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
  %.1328.i7234 = load double, ptr %38, align 8, !noalias !0
  %39 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1129.01444.i
  %.1358.i = load i64, ptr %39, align 8, !noalias !0
  %.1360.i = mul nsw i64 %.1358.i, %arg.shape.0
  %.1362.i = add nsw i64 %.1360.i, %.260.i.07553
  %.1376.i = icmp slt i64 %.1362.i, 0
  %.1377.i = select i1 %.1376.i, i64 %arg.arrays.1.5.0, i64 0
  %40 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1362.i
  %.1391.i = getelementptr double, ptr %40, i64 %.1377.i
  store double %.1328.i7234, ptr %.1391.i, align 8, !noalias !0
  %exitcond1453.not.i = icmp eq i64 %.1198.i, %arg.schedule.2.5.0
  br i1 %exitcond1453.not.i, label %B516.i, label %B446.if.i

B604.if.i:                                        ; preds = %B604.if.i, %B604.if.lr.ph.i
  %.1529.01450.i = phi i64 [ 0, %B604.if.lr.ph.i ], [ %.1598.i, %B604.if.i ]
  %.1598.i = add nsw i64 %.1529.01450.i, 1
  %41 = getelementptr double, ptr %31, i64 %.1529.01450.i
  %.1673.i = load double, ptr %41, align 8, !noalias !0
  %.1675.i = mul nsw i64 %.1529.01450.i, %arg.shape.0
  %gep7852 = getelementptr double, ptr %invariant.gep7851, i64 %.1675.i
  store double %.1673.i, ptr %gep7852, align 8, !noalias !0
  %exitcond1455.not.i = icmp eq i64 %.1598.i, %arg.shape.1
  br i1 %exitcond1455.not.i, label %B648.i, label %B604.if.i

_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit: ; preds = %B520.i, %B102.i.i, %B648.i, %B944.i
  %storemerge1429.i = phi i64 [ 0, %B520.i ], [ 0, %B102.i.i ], [ 1, %B944.i ], [ 1, %B648.i ]
  %.525.i = add nsw i64 %storemerge1429.i, %active.3.i.07555
  br label %B171.i

B171.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit, %B104.i
  %active.4.i.1 = phi i64 [ %.420.i, %B104.i ], [ %.525.i, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit ]
  %.318.i = icmp sgt i64 %.263.i.07554, 1
  br i1 %.318.i, label %B50.if.i, label %B202.endif

B50.if.i:                                         ; preds = %B50.if.i.lr.ph, %B171.i
  %active.3.i.07555 = phi i64 [ 0, %B50.if.i.lr.ph ], [ %active.4.i.1, %B171.i ]
  %.263.i.07554 = phi i64 [ %storemerge, %B50.if.i.lr.ph ], [ %.327.i, %B171.i ]
  %.260.i.07553 = phi i64 [ 0, %B50.if.i.lr.ph ], [ %.331.i, %B171.i ]
  %.327.i = add nsw i64 %.263.i.07554, -1
  %.331.i = add nsw i64 %.260.i.07553, 1
  %42 = getelementptr i64, ptr %arg.lane.1.4, i64 %.260.i.07553
  %.414.i = load i64, ptr %42, align 8, !noalias !14
  %.415.i = icmp sgt i64 %.414.i, -1
  br i1 %.415.i, label %B104.i, label %B116.i

B276:                                             ; preds = %B276.preheader, %B4080
  %budget.3.0 = phi i64 [ %budget.4.2.lcssa, %B4080 ], [ %arg.budget, %B276.preheader ]
  %active.4.0 = phi i64 [ %active.3.2.lcssa, %B4080 ], [ %active.3.i.0.lcssa, %B276.preheader ]
  %.760 = add nsw i64 %budget.3.0, -1
  %.795 = load i64, ptr %.794, align 8
  %.796 = icmp sgt i64 %.795, 0
  br i1 %.796, label %B310, label %B1000

B310:                                             ; preds = %B276
  %.828 = icmp eq i64 %.795, 1
  store i64 0, ptr %.794, align 8
  %.891 = load i64, ptr %.890, align 8
  %.936 = inttoptr i64 %.891 to ptr
  tail call void %.936(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.828, label %B434, label %B1000

B434:                                             ; preds = %B310
  br i1 %.947, label %B446, label %B490

B446:                                             ; preds = %B434
  %.150.i = load i64, ptr %.149.i, align 8, !noalias !15
  %.195.i99 = inttoptr i64 %.150.i to ptr
  tail call void %.195.i99(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !15
  br i1 %.274.i, label %B250.i, label %B118.if.i

B248.i:                                           ; preds = %B190.if.i, %B118.if.i
  %.279.i = icmp sgt i64 %.224.i.07561, 1
  br i1 %.279.i, label %B118.if.i, label %B250.i

B250.i:                                           ; preds = %B248.i, %B446
  %.614.i = load i64, ptr %.890, align 8, !noalias !15
  %.661.i = inttoptr i64 %.614.i to ptr
  tail call void %.661.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !15
  br label %B490

B118.if.i:                                        ; preds = %B446, %B248.i
  %.224.i.07561 = phi i64 [ %.288.i238, %B248.i ], [ %storemerge, %B446 ]
  %.221.i.07560 = phi i64 [ %.292.i240, %B248.i ], [ 0, %B446 ]
  %.288.i238 = add nsw i64 %.224.i.07561, -1
  %.292.i240 = add nsw i64 %.221.i.07560, 1
  %43 = getelementptr double, ptr %257, i64 %.221.i.07560
  %.374.i149 = load double, ptr %43, align 8, !noalias !15
  %.375.i = fcmp ule double %.374.i149, 5.000000e-01
  %brmerge7668 = select i1 %.375.i, i1 true, i1 %.457.i1787556
  br i1 %brmerge7668, label %B248.i, label %B190.if.i.preheader

B190.if.i.preheader:                              ; preds = %B118.if.i
  %invariant.gep7853 = getelementptr double, ptr %arg.arrays.4.4, i64 %.221.i.07560
  br label %B190.if.i

B190.if.i:                                        ; preds = %B190.if.i.preheader, %B190.if.i
  %.401.i.07557 = phi i64 [ %.470.i231, %B190.if.i ], [ 0, %B190.if.i.preheader ]
  %.470.i231 = add nsw i64 %.401.i.07557, 1
  %.496.i189 = mul nsw i64 %.401.i.07557, %arg.shape.0
  %gep7854 = getelementptr double, ptr %invariant.gep7853, i64 %.496.i189
  %.528.i210 = load double, ptr %gep7854, align 8, !noalias !15
  %.530.i = add nsw i64 %.401.i.07557, %arg.held
  %.532.i = mul nsw i64 %.530.i, %arg.shape.0
  %.534.i = add nsw i64 %.532.i, %.221.i.07560
  %.548.i = icmp slt i64 %.534.i, 0
  %.549.i218 = select i1 %.548.i, i64 %arg.arrays.1.5.0, i64 0
  %44 = getelementptr double, ptr %arg.arrays.1.4, i64 %.534.i
  %.563.i = getelementptr double, ptr %44, i64 %.549.i218
  store double %.528.i210, ptr %.563.i, align 8, !noalias !15
  %exitcond.not = icmp eq i64 %.470.i231, %arg.decided
  br i1 %exitcond.not, label %B248.i, label %B190.if.i

B490:                                             ; preds = %B250.i, %B434
  %.1034 = load i64, ptr %arg.code.4, align 8
  %.1082 = inttoptr i64 %.1034 to ptr
  tail call void %.1082(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1081)
  br i1 %.1085.not, label %B652, label %B584

B584:                                             ; preds = %B490
  %.1116 = load i64, ptr %.1115, align 8
  %.1161 = inttoptr i64 %.1116 to ptr
  tail call void %.1161(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B652

B652:                                             ; preds = %B584, %B490
  %.1193 = load i64, ptr %.1192, align 8
  %.1238 = inttoptr i64 %.1193 to ptr
  tail call void %.1238(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.1269 = load i64, ptr %.1268, align 8
  %.1314 = inttoptr i64 %.1269 to ptr
  tail call void %.1314(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.1345 = load i64, ptr %arg.code.4, align 8
  %.1395 = inttoptr i64 %.1345 to ptr
  tail call void %.1395(ptr %.562, ptr %.1369, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1394)
  %.1426 = load i64, ptr %.1425, align 8
  %.1471 = inttoptr i64 %.1426 to ptr
  tail call void %.1471(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.274.i, label %B1000, label %B62.if.i

B104.i430:                                        ; preds = %B62.if.i
  store double 0.000000e+00, ptr %.296.i427, align 8, !noalias !19
  %.414.i512 = getelementptr double, ptr %259, i64 %.144.i332.07563
  store double 0.000000e+00, ptr %.414.i512, align 8, !noalias !19
  %.469.i557 = getelementptr double, ptr %260, i64 %.144.i332.07563
  store double 0.000000e+00, ptr %.469.i557, align 8, !noalias !19
  %45 = getelementptr i64, ptr %arg.lane.1.4, i64 %.144.i332.07563
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
  %.848.i = getelementptr double, ptr %261, i64 %.144.i332.07563
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
  br i1 %.1085.not, label %B540.i, label %B408.i

B408.i:                                           ; preds = %B404.i
  %48 = getelementptr double, ptr %arg.arrays.4.4, i64 %.144.i332.07563
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
  %.1011.i = getelementptr double, ptr %arg.lane.0.4, i64 %.144.i332.07563
  %.1012.i = load double, ptr %.1011.i, align 8, !noalias !19
  %.1068.i = getelementptr double, ptr %262, i64 %.144.i332.07563
  store double %.1012.i, ptr %.1068.i, align 8, !noalias !19
  br label %B540.i

B540.i:                                           ; preds = %_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29.exit.i, %B408.i, %B404.i, %B62.if.i
  %.202.i383 = icmp sgt i64 %.147.i.07564, 1
  br i1 %.202.i383, label %B62.if.i, label %B1000

B62.if.i:                                         ; preds = %B652, %B540.i
  %.147.i.07564 = phi i64 [ %.211.i723, %B540.i ], [ %storemerge, %B652 ]
  %.144.i332.07563 = phi i64 [ %.215.i726, %B540.i ], [ 0, %B652 ]
  %.211.i723 = add nsw i64 %.147.i.07564, -1
  %.215.i726 = add nsw i64 %.144.i332.07563, 1
  %.296.i427 = getelementptr double, ptr %258, i64 %.144.i332.07563
  %.297.i428 = load double, ptr %.296.i427, align 8, !noalias !19
  %.298.i429 = fcmp ogt double %.297.i428, 5.000000e-01
  br i1 %.298.i429, label %B104.i430, label %B540.i

B1000:                                            ; preds = %B540.i, %B652, %B276, %B310
  br i1 %.611, label %B1004, label %B1244.critedge

B1004:                                            ; preds = %B1000
  %.1585 = load i64, ptr %.1584, align 8
  %.1600 = icmp slt i64 %.1585, %arg.times.5.0
  br i1 %.1600, label %B1072, label %B1110

B1072:                                            ; preds = %B1004
  %.1616 = icmp slt i64 %.1585, 0
  %.1617 = select i1 %.1616, i64 %arg.times.5.0, i64 0
  %49 = getelementptr double, ptr %arg.times.4, i64 %.1585
  %.1631 = getelementptr double, ptr %49, i64 %.1617
  %.1632 = load double, ptr %.1631, align 8
  br label %B1110

B1110:                                            ; preds = %B1004, %B1072
  %"$phi1110.0.2.2" = phi double [ %.1632, %B1072 ], [ 0x7FF0000000000000, %B1004 ]
  store double %"$phi1110.0.2.2", ptr %.1697, align 8
  %.1731 = load i64, ptr %.1730, align 8
  %.1776 = inttoptr i64 %.1731 to ptr
  tail call void %.1776(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.264.i = load double, ptr %.263.i7237, align 8, !noalias !29
  %.265.i = fcmp olt double %.264.i, 5.000000e-01
  br i1 %.265.i, label %B68.i, label %B108.i

B68.i:                                            ; preds = %B1110
  br i1 %.317.i2791.not.i, label %B158.i.i, label %B76.if.i.i.preheader

B76.if.i.i.preheader:                             ; preds = %B68.i
  %brmerge = select i1 %min.iters.check7825, i1 true, i1 %conflict.rdx7823
  br i1 %brmerge, label %B76.if.i.i.preheader7844, label %vector.body7829

vector.body7829:                                  ; preds = %B76.if.i.i.preheader, %vector.body7829
  %index7830 = phi i64 [ %index.next7833, %vector.body7829 ], [ 0, %B76.if.i.i.preheader ]
  %50 = getelementptr double, ptr %arg.arrays.0.4, i64 %index7830
  %51 = getelementptr i8, ptr %50, i64 16
  %wide.load7831 = load <2 x double>, ptr %50, align 8, !noalias !32
  %wide.load7832 = load <2 x double>, ptr %51, align 8, !noalias !32
  %52 = getelementptr i8, ptr %50, i64 %.idx2853.i
  %53 = getelementptr i8, ptr %52, i64 16
  store <2 x double> %wide.load7831, ptr %52, align 8, !noalias !32
  store <2 x double> %wide.load7832, ptr %53, align 8, !noalias !32
  %54 = getelementptr i8, ptr %50, i64 %.idx2854.i
  %55 = getelementptr i8, ptr %54, i64 16
  store <2 x double> zeroinitializer, ptr %54, align 8, !noalias !32
  store <2 x double> zeroinitializer, ptr %55, align 8, !noalias !32
  %index.next7833 = add i64 %index7830, 4
  %56 = icmp eq i64 %index.next7833, %n.vec7828
  br i1 %56, label %middle.block7834, label %vector.body7829, !llvm.loop !36

middle.block7834:                                 ; preds = %vector.body7829
  br i1 %cmp.n7835, label %B158.i.i, label %B76.if.i.i.preheader7844

B76.if.i.i.preheader7844:                         ; preds = %B76.if.i.i.preheader, %middle.block7834
  %.259.i.02792.i.ph = phi i64 [ %n.vec7828, %middle.block7834 ], [ 0, %B76.if.i.i.preheader ]
  br label %B76.if.i.i

B158.i.i:                                         ; preds = %B76.if.i.i, %middle.block7834, %B68.i
  br i1 %.547.i2815.i, label %B224.i.i, label %B108.i

B220.i.loopexit.i:                                ; preds = %B1007.i.i, %B706.i.i
  %.547.i.i = icmp sgt i64 %.493.i.12820.i, 0
  %.560.i.i = zext i1 %.547.i.i to i64
  %.490.i.1.i = add i64 %.490.i.12819.i, %.560.i.i
  %.556.i.i = sext i1 %.547.i.i to i64
  %.493.i.1.i = add nsw i64 %.493.i.12820.i, %.556.i.i
  %.537.i.sroa.0.0.i = select i1 %.547.i.i, i64 %.490.i.12819.i, i64 0
  br i1 %.547.i.i, label %B224.i.i, label %B108.i

B224.i.i:                                         ; preds = %B158.i.i, %B220.i.loopexit.i
  %.537.i.sroa.0.02821.i = phi i64 [ %.537.i.sroa.0.0.i, %B220.i.loopexit.i ], [ 0, %B158.i.i ]
  %.493.i.12820.i = phi i64 [ %.493.i.1.i, %B220.i.loopexit.i ], [ %.493.i.12818.i, %B158.i.i ]
  %.490.i.12819.i = phi i64 [ %.490.i.1.i, %B220.i.loopexit.i ], [ 1, %B158.i.i ]
  %.617.i.i = load i64, ptr %.616.i.i, align 8, !noalias !32
  %.618.i.i = icmp sgt i64 %.617.i.i, 0
  br i1 %.618.i.i, label %B254.i.i, label %B660.i.i

B254.i.i:                                         ; preds = %B224.i.i
  br i1 %.711.i2794.i, label %B290.if.i.i.preheader, label %B356.i.i

B290.if.i.i.preheader:                            ; preds = %B254.i.i
  br i1 %or.cond7838, label %B290.if.i.i.preheader7843, label %vector.ph7804

vector.ph7804:                                    ; preds = %B290.if.i.i.preheader
  %broadcast.splatinsert7807 = insertelement <2 x i64> poison, i64 %.537.i.sroa.0.02821.i, i64 0
  %broadcast.splat7808 = shufflevector <2 x i64> %broadcast.splatinsert7807, <2 x i64> poison, <2 x i32> zeroinitializer
  br label %vector.body7809

vector.body7809:                                  ; preds = %vector.body7809, %vector.ph7804
  %index7810 = phi i64 [ 0, %vector.ph7804 ], [ %index.next7813, %vector.body7809 ]
  %57 = getelementptr i64, ptr %arg.linear.4.4, i64 %index7810
  %58 = getelementptr i8, ptr %57, i64 16
  %wide.load7811 = load <2 x i64>, ptr %57, align 8, !noalias !32
  %wide.load7812 = load <2 x i64>, ptr %58, align 8, !noalias !32
  %59 = icmp eq <2 x i64> %wide.load7811, %broadcast.splat7808
  %60 = icmp eq <2 x i64> %wide.load7812, %broadcast.splat7808
  %61 = select <2 x i1> %59, <2 x double> splat (double 1.000000e+00), <2 x double> zeroinitializer
  %62 = select <2 x i1> %60, <2 x double> splat (double 1.000000e+00), <2 x double> zeroinitializer
  %63 = getelementptr double, ptr %invariant.gep, i64 %index7810
  %64 = getelementptr i8, ptr %63, i64 16
  store <2 x double> %61, ptr %63, align 8, !noalias !32
  store <2 x double> %62, ptr %64, align 8, !noalias !32
  %index.next7813 = add i64 %index7810, 4
  %65 = icmp eq i64 %index.next7813, %n.vec7806
  br i1 %65, label %middle.block7814, label %vector.body7809, !llvm.loop !37

middle.block7814:                                 ; preds = %vector.body7809
  br i1 %cmp.n7815, label %B356.i.i, label %B290.if.i.i.preheader7843

B290.if.i.i.preheader7843:                        ; preds = %B290.if.i.i.preheader, %middle.block7814
  %.658.i.02796.i.ph = phi i64 [ %storemerge2783.i, %B290.if.i.i.preheader ], [ %349, %middle.block7814 ]
  %.655.i.02795.i.ph = phi i64 [ 0, %B290.if.i.i.preheader ], [ %n.vec7806, %middle.block7814 ]
  br label %B290.if.i.i

B356.i.i:                                         ; preds = %B290.if.i.i, %middle.block7814, %B254.i.i
  %.872.i.i = load i64, ptr %.871.i.i, align 8, !noalias !32
  %.988.i.i = inttoptr i64 %.872.i.i to ptr
  tail call void %.988.i.i(ptr %arg.lane.0.4, ptr %.962.i.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.987.i.i), !noalias !32
  %.1004.i.i = icmp slt i64 %.537.i.sroa.0.02821.i, 0
  %.1005.i.i = select i1 %.1004.i.i, i64 %arg.linear.5.5.0, i64 0
  %66 = getelementptr i64, ptr %arg.linear.5.4, i64 %.537.i.sroa.0.02821.i
  %.1019.i.i = getelementptr i64, ptr %66, i64 %.1005.i.i
  %.1020.i.i = load i64, ptr %.1019.i.i, align 8, !noalias !32
  %.1036.i.i = icmp slt i64 %.537.i.sroa.0.02821.i, -1
  %.1037.i.i = select i1 %.1036.i.i, i64 %arg.linear.5.5.0, i64 0
  %67 = getelementptr i8, ptr %66, i64 8
  %.1051.i.i = getelementptr i64, ptr %67, i64 %.1037.i.i
  %.1052.i.i = load i64, ptr %.1051.i.i, align 8, !noalias !32
  %.1089.i.i = sub i64 %.1052.i.i, %.1020.i.i
  %.1135.i2797.not.i = icmp slt i64 %.1089.i.i, 1
  br i1 %.1135.i2797.not.i, label %B660.i.i, label %B540.if.i.i

B548.i.i:                                         ; preds = %B540.if.i.i
  %.1202.i.i = icmp slt i64 %.1076.i.02798.i, 0
  %.1203.i.i = select i1 %.1202.i.i, i64 %arg.linear.6.5.0, i64 0
  %68 = getelementptr i64, ptr %arg.linear.6.4, i64 %.1076.i.02798.i
  %.1217.i.i = getelementptr i64, ptr %68, i64 %.1203.i.i
  %.1218.i.i = load i64, ptr %.1217.i.i, align 8, !noalias !32
  %.1219.i.i = add nsw i64 %.1218.i.i, %.944.i.i
  %.1233.i.i = icmp slt i64 %.1219.i.i, 0
  %.1234.i.i = select i1 %.1233.i.i, i64 %arg.arrays.0.5.0, i64 0
  %69 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1219.i.i
  %.1248.i.i = getelementptr double, ptr %69, i64 %.1234.i.i
  %.1249.i.i = load double, ptr %.1248.i.i, align 8, !noalias !32
  %.1316.i.i = fsub double %.1249.i.i, %.1249.i.i
  %.1317.i.i = fcmp oeq double %.1316.i.i, 0.000000e+00
  br label %B656.i.i

B656.i.i:                                         ; preds = %B540.if.i.i, %B548.i.i
  %"$phi656.2.2.i.3.i" = phi i1 [ %.1317.i.i, %B548.i.i ], [ false, %B540.if.i.i ]
  %.1135.i.i = icmp sgt i64 %.1079.i.02799.i, 1
  br i1 %.1135.i.i, label %B540.if.i.i, label %B660.i.i

B660.i.i:                                         ; preds = %B656.i.i, %B356.i.i, %B224.i.i
  %found.3.i.1.i = phi i1 [ false, %B224.i.i ], [ true, %B356.i.i ], [ %"$phi656.2.2.i.3.i", %B656.i.i ]
  br i1 %found.3.i.1.i, label %B706.i.i, label %B664.i.i

B664.i.i:                                         ; preds = %B660.i.i
  %.154.i.i.i = load double, ptr %.153.i.i.i, align 8, !noalias !38
  %.183.i.i.i = load double, ptr %arg.tolerances.4, align 8, !noalias !38
  %.187.i.i.i = fdiv double %.154.i.i.i, %.183.i.i.i
  br i1 %.317.i2791.not.i, label %B498.i.i.i.critedge, label %B84.if.i.i.i.preheader

B84.if.i.i.i.preheader:                           ; preds = %B664.i.i
  br i1 %or.cond7839, label %B84.if.i.i.i.preheader7842, label %vector.ph7785

vector.ph7785:                                    ; preds = %B84.if.i.i.i.preheader
  %broadcast.splatinsert7788 = insertelement <2 x double> poison, double %.187.i.i.i, i64 0
  %broadcast.splat7789 = shufflevector <2 x double> %broadcast.splatinsert7788, <2 x double> poison, <2 x i32> zeroinitializer
  br label %vector.body7790

vector.body7790:                                  ; preds = %vector.body7790, %vector.ph7785
  %index7791 = phi i64 [ 0, %vector.ph7785 ], [ %index.next7794, %vector.body7790 ]
  %70 = getelementptr double, ptr %arg.arrays.0.4, i64 %index7791
  %71 = getelementptr i8, ptr %70, i64 16
  %wide.load7792 = load <2 x double>, ptr %70, align 8, !noalias !38
  %wide.load7793 = load <2 x double>, ptr %71, align 8, !noalias !38
  %72 = tail call <2 x double> @llvm.fabs.v2f64(<2 x double> %wide.load7792)
  %73 = tail call <2 x double> @llvm.fabs.v2f64(<2 x double> %wide.load7793)
  %74 = fcmp ogt <2 x double> %broadcast.splat7789, %72
  %75 = fcmp ogt <2 x double> %broadcast.splat7789, %73
  %76 = select <2 x i1> %74, <2 x double> %broadcast.splat7789, <2 x double> %72
  %77 = select <2 x i1> %75, <2 x double> %broadcast.splat7789, <2 x double> %73
  %78 = fcmp ogt <2 x double> %76, zeroinitializer
  %79 = fcmp ogt <2 x double> %77, zeroinitializer
  %80 = fmul <2 x double> %76, splat (double 1.200000e-05)
  %81 = fmul <2 x double> %77, splat (double 1.200000e-05)
  %82 = select <2 x i1> %78, <2 x double> %80, <2 x double> splat (double 1.200000e-05)
  %83 = select <2 x i1> %79, <2 x double> %81, <2 x double> splat (double 1.200000e-05)
  %84 = getelementptr i8, ptr %70, i64 %.idx2856.i
  %85 = getelementptr i8, ptr %84, i64 16
  store <2 x double> %82, ptr %84, align 8, !noalias !38
  store <2 x double> %83, ptr %85, align 8, !noalias !38
  %index.next7794 = add i64 %index7791, 4
  %86 = icmp eq i64 %index.next7794, %n.vec7787
  br i1 %86, label %middle.block7795, label %vector.body7790, !llvm.loop !42

middle.block7795:                                 ; preds = %vector.body7790
  br i1 %cmp.n7796, label %B230.i.i.i, label %B84.if.i.i.i.preheader7842

B84.if.i.i.i.preheader7842:                       ; preds = %B84.if.i.i.i.preheader, %middle.block7795
  %.215.i.i.02802.i.ph = phi i64 [ 0, %B84.if.i.i.i.preheader ], [ %n.vec7787, %middle.block7795 ]
  br label %B84.if.i.i.i

B230.i.i.i:                                       ; preds = %B84.if.i.i.i, %middle.block7795
  %.500.i.i.i = load double, ptr %.499.i.i.i, align 8, !noalias !38
  %.501.i.i.i = fmul double %.500.i.i.i, 1.000000e-03
  store double %.501.i.i.i, ptr %.534.i.i.i, align 8, !noalias !38
  br label %B370.if.i.i.i

B398.i.i.i:                                       ; preds = %B370.if.i.i.i
  %gep7566 = getelementptr double, ptr %invariant.gep7565, i64 %.687.i.i.02805.i
  %.851.i.i.i = load double, ptr %gep7566, align 8, !noalias !38
  %.853.i.i.i = fmul double %.851.i.i.i, 5.000000e-01
  br label %B444.i.i.i

B444.i.i.i:                                       ; preds = %B370.if.i.i.i, %B398.i.i.i
  %"$phi444.2.2.i.i.2.i" = phi double [ %.853.i.i.i, %B398.i.i.i ], [ 0.000000e+00, %B370.if.i.i.i ]
  %87 = getelementptr double, ptr %arg.arrays.0.4, i64 %.687.i.i.02805.i
  %.894.i.i.i = load double, ptr %87, align 8, !noalias !38
  %.895.i.i.i = fadd double %"$phi444.2.2.i.i.2.i", %.894.i.i.i
  %88 = getelementptr double, ptr %87, i64 %.897.i.i.i
  store double %.895.i.i.i, ptr %88, align 8, !noalias !38
  %exitcond2848.not.i = icmp eq i64 %arg.shape.1, %.756.i.i.i
  br i1 %exitcond2848.not.i, label %B498.i.i.i, label %B370.if.i.i.i

B498.i.i.i.critedge:                              ; preds = %B664.i.i
  %.500.i.i.i.c = load double, ptr %.499.i.i.i, align 8, !noalias !38
  %.501.i.i.i.c = fmul double %.500.i.i.i.c, 1.000000e-03
  store double %.501.i.i.i.c, ptr %.534.i.i.i, align 8, !noalias !38
  br label %B498.i.i.i

B498.i.i.i:                                       ; preds = %B444.i.i.i, %B498.i.i.i.critedge
  %.967.i.i.i = load i64, ptr %.966.i.i.i, align 8, !noalias !38
  %.969.i.i.i = icmp eq i64 %.967.i.i.i, %.537.i.sroa.0.02821.i
  br i1 %.969.i.i.i, label %B522.i.i.i, label %B568.i.i.i

B522.i.i.i:                                       ; preds = %B498.i.i.i
  %.1004.i.i.i = load double, ptr %.534.i.i.i, align 8, !noalias !38
  %.1006.i.i.i = fmul double %.1004.i.i.i, 5.000000e-01
  br label %B568.i.i.i

B568.i.i.i:                                       ; preds = %B522.i.i.i, %B498.i.i.i
  %"$phi568.1.2.i.i.1.i" = phi double [ %.1006.i.i.i, %B522.i.i.i ], [ 0.000000e+00, %B498.i.i.i ]
  %.1074.i.i.i = load double, ptr %arg.lane.0.4, align 8, !noalias !38
  %.1075.i.i.i = fadd double %"$phi568.1.2.i.i.1.i", %.1074.i.i.i
  store double %.1075.i.i.i, ptr %.562, align 8, !noalias !38
  %.1164.i.i.i = load i64, ptr %arg.code.4, align 8, !noalias !38
  %.1280.i.i.i = inttoptr i64 %.1164.i.i.i to ptr
  tail call void %.1280.i.i.i(ptr nonnull %.562, ptr %.962.i.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1279.i.i.i), !noalias !38
  br i1 %.317.i2791.not.i, label %B498.i.i.1.i, label %B370.if.i.i.1.i

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
  %.687.i.i.02805.1.i = phi i64 [ %.756.i.i.1.i, %B444.i.i.1.i ], [ 0, %B568.i.i.i ]
  %.756.i.i.1.i = add nsw i64 %.687.i.i.02805.1.i, 1
  %90 = getelementptr i64, ptr %arg.linear.4.4, i64 %.687.i.i.02805.1.i
  %.814.i.i.1.i = load i64, ptr %90, align 8, !noalias !38
  %.816.i.i.1.i = icmp eq i64 %.814.i.i.1.i, %.537.i.sroa.0.02821.i
  br i1 %.816.i.i.1.i, label %B398.i.i.1.i, label %B444.i.i.1.i

B398.i.i.1.i:                                     ; preds = %B370.if.i.i.1.i
  %gep7568 = getelementptr double, ptr %invariant.gep7567, i64 %.687.i.i.02805.1.i
  %.851.i.i.1.i = load double, ptr %gep7568, align 8, !noalias !38
  %.853.i.i.1.i = fmul double %.851.i.i.1.i, -5.000000e-01
  br label %B444.i.i.1.i

B444.i.i.1.i:                                     ; preds = %B398.i.i.1.i, %B370.if.i.i.1.i
  %"$phi444.2.2.i.i.2.1.i" = phi double [ %.853.i.i.1.i, %B398.i.i.1.i ], [ 0.000000e+00, %B370.if.i.i.1.i ]
  %91 = getelementptr double, ptr %arg.arrays.0.4, i64 %.687.i.i.02805.1.i
  %.894.i.i.1.i = load double, ptr %91, align 8, !noalias !38
  %.895.i.i.1.i = fadd double %"$phi444.2.2.i.i.2.1.i", %.894.i.i.1.i
  %92 = getelementptr double, ptr %91, i64 %.897.i.i.i
  store double %.895.i.i.1.i, ptr %92, align 8, !noalias !38
  %exitcond2848.1.not.i = icmp eq i64 %arg.shape.1, %.756.i.i.1.i
  br i1 %exitcond2848.1.not.i, label %B498.i.i.1.i, label %B370.if.i.i.1.i

B498.i.i.1.i:                                     ; preds = %B444.i.i.1.i, %B568.i.i.i
  %.967.i.i.1.i = load i64, ptr %.966.i.i.i, align 8, !noalias !38
  %.969.i.i.1.i = icmp eq i64 %.967.i.i.1.i, %.537.i.sroa.0.02821.i
  br i1 %.969.i.i.1.i, label %B522.i.i.1.i, label %B568.i.i.1.i

B522.i.i.1.i:                                     ; preds = %B498.i.i.1.i
  %.1004.i.i.1.i = load double, ptr %.534.i.i.i, align 8, !noalias !38
  %.1006.i.i.1.i = fmul double %.1004.i.i.1.i, -5.000000e-01
  br label %B568.i.i.1.i

B568.i.i.1.i:                                     ; preds = %B522.i.i.1.i, %B498.i.i.1.i
  %"$phi568.1.2.i.i.1.1.i" = phi double [ %.1006.i.i.1.i, %B522.i.i.1.i ], [ 0.000000e+00, %B498.i.i.1.i ]
  %.1074.i.i.1.i = load double, ptr %arg.lane.0.4, align 8, !noalias !38
  %.1075.i.i.1.i = fadd double %"$phi568.1.2.i.i.1.1.i", %.1074.i.i.1.i
  store double %.1075.i.i.1.i, ptr %.562, align 8, !noalias !38
  %.1312.i.i.1.i = load i64, ptr %arg.code.4, align 8, !noalias !38
  %.1426.i.i.1.i = inttoptr i64 %.1312.i.i.1.i to ptr
  tail call void %.1426.i.i.1.i(ptr nonnull %.562, ptr %.962.i.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !38
  br i1 %.317.i2791.not.i, label %B706.i.i, label %B902.if.i.i.i

B1148.i.i.i:                                      ; preds = %B1100.i.i.i, %B1060.i.i.i
  %storemerge2787.i = phi double [ %.1801.i.i.i, %B1100.i.i.i ], [ %.1750.i.i.i, %B1060.i.i.i ]
  store double %storemerge2787.i, ptr %99, align 8, !noalias !38
  %exitcond2850.not.i = icmp eq i64 %arg.shape.1, %.1540.i.i.i
  br i1 %exitcond2850.not.i, label %B706.i.i, label %B902.if.i.i.i

B84.if.i.i.i:                                     ; preds = %B84.if.i.i.i.preheader7842, %B84.if.i.i.i
  %.215.i.i.02802.i = phi i64 [ %.286.i.i.i, %B84.if.i.i.i ], [ %.215.i.i.02802.i.ph, %B84.if.i.i.i.preheader7842 ]
  %.286.i.i.i = add nsw i64 %.215.i.i.02802.i, 1
  %93 = getelementptr double, ptr %arg.arrays.0.4, i64 %.215.i.i.02802.i
  %.344.i.i.i = load double, ptr %93, align 8, !noalias !38
  %.345.i.i.i = tail call double @llvm.fabs.f64(double %.344.i.i.i)
  %.10.i.i.i.i = fcmp ogt double %.187.i.i.i, %.345.i.i.i
  %.11.i.i.i.i = select i1 %.10.i.i.i.i, double %.187.i.i.i, double %.345.i.i.i
  %.380.i.i.i = fcmp ogt double %.11.i.i.i.i, 0.000000e+00
  %94 = fmul double %.11.i.i.i.i, 1.200000e-05
  %"$phi194.2.2.i.i.1.i" = select i1 %.380.i.i.i, double %94, double 1.200000e-05
  %95 = getelementptr i8, ptr %93, i64 %.idx2856.i
  store double %"$phi194.2.2.i.i.1.i", ptr %95, align 8, !noalias !38
  %exitcond2847.not.i = icmp eq i64 %arg.shape.1, %.286.i.i.i
  br i1 %exitcond2847.not.i, label %B230.i.i.i, label %B84.if.i.i.i, !llvm.loop !43

B370.if.i.i.i:                                    ; preds = %B230.i.i.i, %B444.i.i.i
  %.687.i.i.02805.i = phi i64 [ %.756.i.i.i, %B444.i.i.i ], [ 0, %B230.i.i.i ]
  %.756.i.i.i = add nsw i64 %.687.i.i.02805.i, 1
  %96 = getelementptr i64, ptr %arg.linear.4.4, i64 %.687.i.i.02805.i
  %.814.i.i.i = load i64, ptr %96, align 8, !noalias !38
  %.816.i.i.i = icmp eq i64 %.814.i.i.i, %.537.i.sroa.0.02821.i
  br i1 %.816.i.i.i, label %B398.i.i.i, label %B444.i.i.i

B902.if.i.i.i:                                    ; preds = %B568.i.i.1.i, %B1148.i.i.i
  %.1471.i.i.02810.i = phi i64 [ %.1540.i.i.i, %B1148.i.i.i ], [ 0, %B568.i.i.1.i ]
  %.1540.i.i.i = add nsw i64 %.1471.i.i.02810.i, 1
  %97 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1471.i.i.02810.i
  %.1598.i.i.i = load double, ptr %97, align 8, !noalias !38
  %98 = getelementptr i8, ptr %97, i64 %.962.i.idx.i
  store double %.1598.i.i.i, ptr %98, align 8, !noalias !38
  %99 = getelementptr i8, ptr %97, i64 %.1279.i.i.idx.i
  %.1666.i.i.i = load double, ptr %99, align 8, !noalias !38
  %100 = getelementptr double, ptr %arg.arrays.4.4, i64 %.1471.i.i.02810.i
  %.1697.i.i.i = load double, ptr %100, align 8, !noalias !38
  %.1743.i.i.i = fsub double %.1697.i.i.i, %.1697.i.i.i
  %.1744.i.i.i = fcmp oeq double %.1743.i.i.i, 0.000000e+00
  br i1 %.1744.i.i.i, label %B1060.i.i.i, label %B1100.i.i.i

B706.i.i:                                         ; preds = %B1148.i.i.i, %B568.i.i.1.i, %B660.i.i
  %.1411.i.i = icmp slt i64 %.537.i.sroa.0.02821.i, 0
  %.1412.i.i = select i1 %.1411.i.i, i64 %arg.linear.5.5.0, i64 0
  %101 = getelementptr i64, ptr %arg.linear.5.4, i64 %.537.i.sroa.0.02821.i
  %.1426.i.i = getelementptr i64, ptr %101, i64 %.1412.i.i
  %.1427.i.i = load i64, ptr %.1426.i.i, align 8, !noalias !32
  %.1445.i.i = icmp slt i64 %.537.i.sroa.0.02821.i, -1
  %.1446.i.i = select i1 %.1445.i.i, i64 %arg.linear.5.5.0, i64 0
  %102 = getelementptr i8, ptr %101, i64 8
  %.1460.i.i = getelementptr i64, ptr %102, i64 %.1446.i.i
  %.1461.i.i = load i64, ptr %.1460.i.i, align 8, !noalias !32
  %.1498.i.i = sub i64 %.1461.i.i, %.1427.i.i
  %.1541.i2812.not.i = icmp slt i64 %.1498.i.i, 1
  br i1 %.1541.i2812.not.i, label %B220.i.loopexit.i, label %B768.if.i.i

B826.i.i:                                         ; preds = %B768.if.i.i
  %.1674.i.i = select i1 %.1598.i.i, i64 %arg.linear.7.5.0, i64 0
  %103 = getelementptr i64, ptr %arg.linear.7.4, i64 %.1485.i.02813.i
  %.1688.i.i = getelementptr i64, ptr %103, i64 %.1674.i.i
  %.1689.i.i = load i64, ptr %.1688.i.i, align 8, !noalias !32
  %.1690.i.i = add nsw i64 %.1689.i.i, %.503.i.i.i
  %.1704.i.i = icmp slt i64 %.1690.i.i, 0
  %.1705.i.i = select i1 %.1704.i.i, i64 %arg.arrays.0.5.0, i64 0
  %104 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1690.i.i
  %.1719.i.i = getelementptr double, ptr %104, i64 %.1705.i.i
  %.1720.i.i = load double, ptr %.1719.i.i, align 8, !noalias !32
  %.1725.i.i = fdiv double %.1645.i.i, %.1720.i.i
  %.1733.i.i = fsub double %.1725.i.i, %.1725.i.i
  %.1734.i.i = fcmp oeq double %.1733.i.i, 0.000000e+00
  %.1725.i..i = select i1 %.1734.i.i, double %.1725.i.i, double 0.000000e+00
  br label %B908.i.i

B908.i.i:                                         ; preds = %B768.if.i.i, %B826.i.i
  %slope.3.i.2.i = phi double [ %.1645.i.i, %B768.if.i.i ], [ %.1725.i..i, %B826.i.i ]
  %.1771.i.i = select i1 %.1598.i.i, i64 %arg.linear.7.5.0, i64 0
  %105 = getelementptr i64, ptr %arg.linear.7.4, i64 %.1485.i.02813.i
  %.1785.i.i = getelementptr i64, ptr %105, i64 %.1771.i.i
  %.1786.i.i = load i64, ptr %.1785.i.i, align 8, !noalias !32
  %.1788.i.i = icmp eq i64 %.1786.i.i, %arg.shape.1
  br i1 %.1788.i.i, label %B932.i.i, label %B978.i.i

B932.i.i:                                         ; preds = %B908.i.i
  %.1825.i.i = add nsw i64 %.1614.i.i, %.1791.i.i
  %.1840.i.i = icmp slt i64 %.1825.i.i, 0
  %.1841.i.i = select i1 %.1840.i.i, i64 %arg.arrays.0.5.0, i64 0
  %106 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1825.i.i
  %.1855.i.i = getelementptr double, ptr %106, i64 %.1841.i.i
  store double %slope.3.i.2.i, ptr %.1855.i.i, align 8, !noalias !32
  br label %B1007.i.i

B978.i.i:                                         ; preds = %B908.i.i
  %.1875.i.i = select i1 %.1598.i.i, i64 %arg.linear.8.5.0, i64 0
  %107 = getelementptr i64, ptr %arg.linear.8.4, i64 %.1485.i.02813.i
  %.1889.i.i = getelementptr i64, ptr %107, i64 %.1875.i.i
  %.1890.i.i = load i64, ptr %.1889.i.i, align 8, !noalias !32
  %.1907.i.i = icmp slt i64 %.1890.i.i, 0
  %.1908.i.i = select i1 %.1907.i.i, i64 %arg.linear.0.5.0, i64 0
  %108 = getelementptr double, ptr %arg.linear.0.4, i64 %.1890.i.i
  %.1922.i.i = getelementptr double, ptr %108, i64 %.1908.i.i
  store double %slope.3.i.2.i, ptr %.1922.i.i, align 8, !noalias !32
  br label %B1007.i.i

B1007.i.i:                                        ; preds = %B978.i.i, %B932.i.i
  %.1541.i.i = icmp sgt i64 %.1488.i.02814.i, 1
  br i1 %.1541.i.i, label %B768.if.i.i, label %B220.i.loopexit.i

B76.if.i.i:                                       ; preds = %B76.if.i.i.preheader7844, %B76.if.i.i
  %.259.i.02792.i = phi i64 [ %.330.i.i, %B76.if.i.i ], [ %.259.i.02792.i.ph, %B76.if.i.i.preheader7844 ]
  %.330.i.i = add nsw i64 %.259.i.02792.i, 1
  %109 = getelementptr double, ptr %arg.arrays.0.4, i64 %.259.i.02792.i
  %.384.i.i = load double, ptr %109, align 8, !noalias !32
  %110 = getelementptr i8, ptr %109, i64 %.idx2853.i
  store double %.384.i.i, ptr %110, align 8, !noalias !32
  %111 = getelementptr i8, ptr %109, i64 %.idx2854.i
  store double 0.000000e+00, ptr %111, align 8, !noalias !32
  %exitcond.not.i7239 = icmp eq i64 %arg.shape.1, %.330.i.i
  br i1 %exitcond.not.i7239, label %B158.i.i, label %B76.if.i.i, !llvm.loop !44

B290.if.i.i:                                      ; preds = %B290.if.i.i.preheader7843, %B290.if.i.i
  %.658.i.02796.i = phi i64 [ %.720.i.i, %B290.if.i.i ], [ %.658.i.02796.i.ph, %B290.if.i.i.preheader7843 ]
  %.655.i.02795.i = phi i64 [ %.724.i.i, %B290.if.i.i ], [ %.655.i.02795.i.ph, %B290.if.i.i.preheader7843 ]
  %.720.i.i = add nsw i64 %.658.i.02796.i, -1
  %.724.i.i = add nsw i64 %.655.i.02795.i, 1
  %112 = getelementptr i64, ptr %arg.linear.4.4, i64 %.655.i.02795.i
  %.782.i.i = load i64, ptr %112, align 8, !noalias !32
  %.784.i.i = icmp eq i64 %.782.i.i, %.537.i.sroa.0.02821.i
  %..i = select i1 %.784.i.i, double 1.000000e+00, double 0.000000e+00
  %gep = getelementptr double, ptr %invariant.gep, i64 %.655.i.02795.i
  store double %..i, ptr %gep, align 8, !noalias !32
  %.711.i.i = icmp sgt i64 %.658.i.02796.i, 1
  br i1 %.711.i.i, label %B290.if.i.i, label %B356.i.i, !llvm.loop !45

B540.if.i.i:                                      ; preds = %B356.i.i, %B656.i.i
  %found.2.i.22800.i = phi i1 [ %"$phi656.2.2.i.3.i", %B656.i.i ], [ true, %B356.i.i ]
  %.1079.i.02799.i = phi i64 [ %.1144.i.i, %B656.i.i ], [ %.1089.i.i, %B356.i.i ]
  %.1076.i.02798.i = phi i64 [ %.1148.i.i, %B656.i.i ], [ %.1020.i.i, %B356.i.i ]
  %.1144.i.i = add nsw i64 %.1079.i.02799.i, -1
  %.1148.i.i = add i64 %.1076.i.02798.i, 1
  br i1 %found.2.i.22800.i, label %B548.i.i, label %B656.i.i

B768.if.i.i:                                      ; preds = %B706.i.i, %B1007.i.i
  %.1488.i.02814.i = phi i64 [ %.1550.i.i, %B1007.i.i ], [ %.1498.i.i, %B706.i.i ]
  %.1485.i.02813.i = phi i64 [ %.1554.i.i, %B1007.i.i ], [ %.1427.i.i, %B706.i.i ]
  %.1550.i.i = add nsw i64 %.1488.i.02814.i, -1
  %.1554.i.i = add i64 %.1485.i.02813.i, 1
  %.1598.i.i = icmp slt i64 %.1485.i.02813.i, 0
  %.1599.i.i = select i1 %.1598.i.i, i64 %arg.linear.6.5.0, i64 0
  %113 = getelementptr i64, ptr %arg.linear.6.4, i64 %.1485.i.02813.i
  %.1613.i.i = getelementptr i64, ptr %113, i64 %.1599.i.i
  %.1614.i.i = load i64, ptr %.1613.i.i, align 8, !noalias !32
  %.1615.i.i = add nsw i64 %.1614.i.i, %.944.i.i
  %.1629.i.i = icmp slt i64 %.1615.i.i, 0
  %.1630.i.i = select i1 %.1629.i.i, i64 %arg.arrays.0.5.0, i64 0
  %114 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1615.i.i
  %.1644.i.i = getelementptr double, ptr %114, i64 %.1630.i.i
  %.1645.i.i = load double, ptr %.1644.i.i, align 8, !noalias !32
  br i1 %found.3.i.1.i, label %B908.i.i, label %B826.i.i

B108.i:                                           ; preds = %B220.i.loopexit.i, %B158.i.i, %B1110
  %.389.i = load i64, ptr %arg.linear.9.4, align 8, !noalias !29
  %.419.i = load i64, ptr %.418.i, align 8, !noalias !29
  br i1 %.5082825.not.i, label %B1276.if.preheader, label %B170.if.lr.ph.i

B170.if.lr.ph.i:                                  ; preds = %B108.i
  %.584.i = add i64 %.389.i, 1
  %115 = add i64 %.419.i, %.389.i
  br label %B170.if.i

B36.if.i.lr.ph.i:                                 ; preds = %B340.i
  %.199.i.i = add i64 %.419.i, 1
  br label %B36.if.i.i

B340.i:                                           ; preds = %B286.if.i, %B170.if.i
  %.810.i = mul i64 %.452.02826.i, %.498.sroa.0.02782.i
  %.826.i = icmp slt i64 %.810.i, 0
  %.827.i = select i1 %.826.i, i64 %arg.linear.1.5.0, i64 0
  %116 = getelementptr double, ptr %arg.linear.1.4, i64 %.810.i
  %.841.i = getelementptr double, ptr %116, i64 %.827.i
  %.842.i = load double, ptr %.841.i, align 8, !noalias !29
  %.896.i = load double, ptr %.895.i, align 8, !noalias !29
  %.897.i = fadd double %.842.i, %.896.i
  store double %.897.i, ptr %.841.i, align 8, !noalias !29
  %exitcond2851.not.i = icmp eq i64 %arg.shape.1, %.521.i
  br i1 %exitcond2851.not.i, label %B36.if.i.lr.ph.i, label %B170.if.i

B34.i.loopexit.i:                                 ; preds = %B790.i.i, %B528.i.i
  %exitcond2852.not.i = icmp eq i64 %arg.shape.1, %.131.i.i
  br i1 %exitcond2852.not.i, label %B1276.if.preheader, label %B36.if.i.i

B348.i.i:                                         ; preds = %B234.if.i.i, %B36.if.i.i
  %p.2.i.1.lcssa.i = phi i64 [ %.59.i.02845.i, %B36.if.i.i ], [ %p.3.i.2.i, %B234.if.i.i ]
  %117 = getelementptr i64, ptr %arg.linear.2.4, i64 %.59.i.02845.i
  store i64 %p.2.i.1.lcssa.i, ptr %117, align 8, !noalias !46
  %.547.i151.i = add nsw i64 %p.2.i.1.lcssa.i, %.161.i80.i
  %.561.i.i = icmp slt i64 %.547.i151.i, 0
  %.562.i158.i = select i1 %.561.i.i, i64 %arg.linear.1.5.0, i64 0
  %118 = getelementptr double, ptr %arg.linear.1.4, i64 %.547.i151.i
  %.576.i163.i = getelementptr double, ptr %118, i64 %.562.i158.i
  %.577.i164.i = load double, ptr %.576.i163.i, align 8, !noalias !46
  %.610.i180.i = load double, ptr %120, align 8, !noalias !46
  store double %.577.i164.i, ptr %120, align 8, !noalias !46
  store double %.610.i180.i, ptr %.576.i163.i, align 8, !noalias !46
  br i1 %.362.i1282828.not.i, label %B528.i.i, label %B466.if.i.i

B528.i.i:                                         ; preds = %B466.if.i.i, %B348.i.i
  %.942.i245.i = sub i64 %.11.i4.i.i, %.131.i.i
  %.985.i2562840.not.i = icmp slt i64 %.942.i245.i, 1
  br i1 %.985.i2562840.not.i, label %B34.i.loopexit.i, label %B566.if.i.i

B790.i.i:                                         ; preds = %B716.if.i.i, %B566.if.i.i
  %.985.i256.i = icmp sgt i64 %.932.i44.02842.i, 1
  br i1 %.985.i256.i, label %B566.if.i.i, label %B34.i.loopexit.i

B36.if.i.i:                                       ; preds = %B34.i.loopexit.i, %B36.if.i.lr.ph.i
  %.59.i.02845.i = phi i64 [ 0, %B36.if.i.lr.ph.i ], [ %.131.i.i, %B34.i.loopexit.i ]
  %.131.i.i = add nsw i64 %.59.i.02845.i, 1
  %.161.i80.i = mul nsw i64 %.59.i.02845.i, %arg.shape.1
  %.164.i83.i = add nsw i64 %.59.i.02845.i, %.389.i
  %.165.i84.i = add nsw i64 %.164.i83.i, 1
  %.11.i.i.i = tail call i64 @llvm.smin.i64(i64 %.165.i84.i, i64 %arg.shape.1)
  %.200.i91.i = add i64 %.199.i.i, %.164.i83.i
  %.11.i4.i.i = tail call i64 @llvm.smin.i64(i64 %.200.i91.i, i64 %arg.shape.1)
  %119 = getelementptr double, ptr %arg.linear.1.4, i64 %.161.i80.i
  %120 = getelementptr double, ptr %119, i64 %.59.i.02845.i
  %.319.i.i = sub i64 %.11.i.i.i, %.131.i.i
  %storemerge2777.i = tail call i64 @llvm.smax.i64(i64 %.319.i.i, i64 0)
  %.362.i1282828.not.i = icmp slt i64 %.319.i.i, 1
  br i1 %.362.i1282828.not.i, label %B348.i.i, label %B234.if.i.preheader.i

B234.if.i.preheader.i:                            ; preds = %B36.if.i.i
  %.271.i.i = load double, ptr %120, align 8, !noalias !46
  %.272.i108.i = tail call double @llvm.fabs.f64(double %.271.i.i)
  br label %B234.if.i.i

B234.if.i.i:                                      ; preds = %B234.if.i.i, %B234.if.i.preheader.i
  %p.2.i.12832.i = phi i64 [ %p.3.i.2.i, %B234.if.i.i ], [ %.59.i.02845.i, %B234.if.i.preheader.i ]
  %largest.2.i.12831.i = phi double [ %largest.3.i.2.i, %B234.if.i.i ], [ %.272.i108.i, %B234.if.i.preheader.i ]
  %.309.i.02830.i = phi i64 [ %.371.i570.i, %B234.if.i.i ], [ %storemerge2777.i, %B234.if.i.preheader.i ]
  %.306.i26.02829.i = phi i64 [ %.375.i.i, %B234.if.i.i ], [ %.131.i.i, %B234.if.i.preheader.i ]
  %.371.i570.i = add nsw i64 %.309.i.02830.i, -1
  %.375.i.i = add i64 %.306.i26.02829.i, 1
  %.415.i.i7238 = add nsw i64 %.306.i26.02829.i, %.161.i80.i
  %.429.i530.i = icmp slt i64 %.415.i.i7238, 0
  %.430.i.i = select i1 %.429.i530.i, i64 %arg.linear.1.5.0, i64 0
  %121 = getelementptr double, ptr %arg.linear.1.4, i64 %.415.i.i7238
  %.444.i542.i = getelementptr double, ptr %121, i64 %.430.i.i
  %.445.i543.i = load double, ptr %.444.i542.i, align 8, !noalias !46
  %.446.i544.i = tail call double @llvm.fabs.f64(double %.445.i543.i)
  %.448.i.i = fcmp ogt double %.446.i544.i, %largest.2.i.12831.i
  %largest.3.i.2.i = select i1 %.448.i.i, double %.446.i544.i, double %largest.2.i.12831.i
  %p.3.i.2.i = select i1 %.448.i.i, i64 %.306.i26.02829.i, i64 %p.2.i.12832.i
  %.362.i128.i = icmp sgt i64 %.309.i.02830.i, 1
  br i1 %.362.i128.i, label %B234.if.i.i, label %B348.i.i

B466.if.i.i:                                      ; preds = %B348.i.i, %B466.if.i.i
  %.706.i.02836.i = phi i64 [ %.768.i511.i, %B466.if.i.i ], [ %storemerge2777.i, %B348.i.i ]
  %.703.i.02835.i = phi i64 [ %.772.i513.i, %B466.if.i.i ], [ %.131.i.i, %B348.i.i ]
  %.768.i511.i = add nsw i64 %.706.i.02836.i, -1
  %.772.i513.i = add i64 %.703.i.02835.i, 1
  %.798.i.i = add nsw i64 %.703.i.02835.i, %.161.i80.i
  %.812.i461.i = icmp slt i64 %.798.i.i, 0
  %.813.i462.i = select i1 %.812.i461.i, i64 %arg.linear.1.5.0, i64 0
  %122 = getelementptr double, ptr %arg.linear.1.4, i64 %.798.i.i
  %.827.i.i = getelementptr double, ptr %122, i64 %.813.i462.i
  %.828.i473.i = load double, ptr %.827.i.i, align 8, !noalias !46
  %.861.i488.i = load double, ptr %120, align 8, !noalias !46
  %.865.i490.i = fdiv double %.828.i473.i, %.861.i488.i
  store double %.865.i490.i, ptr %.827.i.i, align 8, !noalias !46
  %.759.i.i = icmp sgt i64 %.706.i.02836.i, 1
  br i1 %.759.i.i, label %B466.if.i.i, label %B528.i.i

B566.if.i.i:                                      ; preds = %B528.i.i, %B790.i.i
  %.932.i44.02842.i = phi i64 [ %.994.i.i, %B790.i.i ], [ %.942.i245.i, %B528.i.i ]
  %.929.i.02841.i = phi i64 [ %.998.i446.i, %B790.i.i ], [ %.131.i.i, %B528.i.i ]
  %.994.i.i = add nsw i64 %.932.i44.02842.i, -1
  %.998.i446.i = add i64 %.929.i.02841.i, 1
  %123 = mul nsw i64 %.929.i.02841.i, %arg.shape.1
  %.1030.i270.i = add nsw i64 %123, %p.2.i.1.lcssa.i
  %.1044.i278.i = icmp slt i64 %.1030.i270.i, 0
  %.1045.i279.i = select i1 %.1044.i278.i, i64 %arg.linear.1.5.0, i64 0
  %124 = getelementptr double, ptr %arg.linear.1.4, i64 %.1030.i270.i
  %.1059.i.i = getelementptr double, ptr %124, i64 %.1045.i279.i
  %.1060.i287.i = load double, ptr %.1059.i.i, align 8, !noalias !46
  %.1068.i.i = add nsw i64 %123, %.59.i.02845.i
  %.1082.i.i = icmp slt i64 %.1068.i.i, 0
  %.1083.i294.i = select i1 %.1082.i.i, i64 %arg.linear.1.5.0, i64 0
  %125 = getelementptr double, ptr %arg.linear.1.4, i64 %.1068.i.i
  %.1097.i303.i = getelementptr double, ptr %125, i64 %.1083.i294.i
  %.1098.i304.i = load double, ptr %.1097.i303.i, align 8, !noalias !46
  store double %.1098.i304.i, ptr %.1059.i.i, align 8, !noalias !46
  store double %.1060.i287.i, ptr %.1097.i303.i, align 8, !noalias !46
  %.1171.i.i = fcmp oeq double %.1060.i287.i, 0.000000e+00
  %brmerge.i = or i1 %.362.i1282828.not.i, %.1171.i.i
  br i1 %brmerge.i, label %B790.i.i, label %B716.if.i.i

B716.if.i.i:                                      ; preds = %B566.if.i.i, %B716.if.i.i
  %.1202.i55.02839.i = phi i64 [ %.1264.i433.i, %B716.if.i.i ], [ %storemerge2777.i, %B566.if.i.i ]
  %.1199.i54.02838.i = phi i64 [ %.1268.i436.i, %B716.if.i.i ], [ %.131.i.i, %B566.if.i.i ]
  %.1264.i433.i = add nsw i64 %.1202.i55.02839.i, -1
  %.1268.i436.i = add i64 %.1199.i54.02838.i, 1
  %.1296.i370.i = add nsw i64 %.1199.i54.02838.i, %123
  %.1310.i378.i = icmp slt i64 %.1296.i370.i, 0
  %.1311.i379.i = select i1 %.1310.i378.i, i64 %arg.linear.1.5.0, i64 0
  %126 = getelementptr double, ptr %arg.linear.1.4, i64 %.1296.i370.i
  %.1325.i.i = getelementptr double, ptr %126, i64 %.1311.i379.i
  %.1326.i388.i = load double, ptr %.1325.i.i, align 8, !noalias !46
  %.1328.i.i = add nsw i64 %.1199.i54.02838.i, %.161.i80.i
  %.1342.i395.i = icmp slt i64 %.1328.i.i, 0
  %.1343.i396.i = select i1 %.1342.i395.i, i64 %arg.linear.1.5.0, i64 0
  %127 = getelementptr double, ptr %arg.linear.1.4, i64 %.1328.i.i
  %.1357.i407.i = getelementptr double, ptr %127, i64 %.1343.i396.i
  %.1358.i408.i = load double, ptr %.1357.i407.i, align 8, !noalias !46
  %.1360.i410.i = fmul double %.1060.i287.i, %.1358.i408.i
  %.1361.i411.i = fsub double %.1326.i388.i, %.1360.i410.i
  store double %.1361.i411.i, ptr %.1325.i.i, align 8, !noalias !46
  %.1255.i.i = icmp sgt i64 %.1202.i55.02839.i, 1
  br i1 %.1255.i.i, label %B716.if.i.i, label %B790.i.i

B170.if.i:                                        ; preds = %B340.i, %B170.if.lr.ph.i
  %.452.02826.i = phi i64 [ 0, %B170.if.lr.ph.i ], [ %.521.i, %B340.i ]
  %.521.i = add nsw i64 %.452.02826.i, 1
  %.553.i = sub i64 %.452.02826.i, %115
  %.11.i.i = tail call i64 @llvm.smax.i64(i64 %.553.i, i64 0)
  %.585.i = add i64 %.584.i, %.452.02826.i
  %.11.i2790.i = tail call i64 @llvm.smin.i64(i64 range(i64 -9223372036854775807, -9223372036854775808) %.585.i, i64 %arg.shape.1)
  %.651.i = sub i64 %.11.i2790.i, %.11.i.i
  %.6942822.not.i = icmp slt i64 %.651.i, 1
  br i1 %.6942822.not.i, label %B340.i, label %B286.if.lr.ph.i

B286.if.lr.ph.i:                                  ; preds = %B170.if.i
  %.734.i = mul nsw i64 %.452.02826.i, %arg.shape.1
  br label %B286.if.i

B286.if.i:                                        ; preds = %B286.if.i, %B286.if.lr.ph.i
  %.641.02824.i = phi i64 [ %.651.i, %B286.if.lr.ph.i ], [ %.703.i, %B286.if.i ]
  %.638.02823.i = phi i64 [ %.11.i.i, %B286.if.lr.ph.i ], [ %.707.i, %B286.if.i ]
  %.703.i = add nsw i64 %.641.02824.i, -1
  %.707.i = add i64 %.638.02823.i, 1
  %.735.i = add nsw i64 %.638.02823.i, %.734.i
  %.749.i = icmp slt i64 %.735.i, 0
  %.750.i = select i1 %.749.i, i64 %arg.linear.0.5.0, i64 0
  %128 = getelementptr double, ptr %arg.linear.0.4, i64 %.735.i
  %.764.i = getelementptr double, ptr %128, i64 %.750.i
  %.765.i = load double, ptr %.764.i, align 8, !noalias !29
  %.766.i = fneg double %.765.i
  %.785.i = select i1 %.749.i, i64 %arg.linear.1.5.0, i64 0
  %129 = getelementptr double, ptr %arg.linear.1.4, i64 %.735.i
  %.799.i = getelementptr double, ptr %129, i64 %.785.i
  store double %.766.i, ptr %.799.i, align 8, !noalias !29
  %.694.i = icmp sgt i64 %.641.02824.i, 1
  br i1 %.694.i, label %B286.if.i, label %B340.i

B1244.critedge:                                   ; preds = %B1000
  %.1731.c = load i64, ptr %.1730.c, align 8
  %.1776.c = inttoptr i64 %.1731.c to ptr
  tail call void %.1776.c(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B1276.if.preheader

B1276.if.preheader:                               ; preds = %B34.i.loopexit.i, %B108.i, %B1244.critedge
  br label %B1276.if

B60.if.lr.ph.i:                                   ; preds = %B1276.if
  %.256.i = mul nsw i64 %.1948, %arg.shape.1
  %invariant.gep7855 = getelementptr double, ptr %arg.arrays.0.4, i64 %.256.i
  br label %B60.if.i

B190.i7243:                                       ; preds = %B60.if.i
  %.420.i7244 = load i64, ptr %arg.linear.9.4, align 8, !noalias !50
  %.450.i = load i64, ptr %.449.i, align 8, !noalias !50
  %.339.i.i7245 = add i64 %.420.i7244, 1
  br label %B34.if.i.i7246

B34.i.loopexit.i7248:                             ; preds = %B198.if.i.i, %B34.if.i.i7246
  %exitcond666.not.i = icmp eq i64 %arg.shape.1, %.144.i.i
  br i1 %exitcond666.not.i, label %B314.if.i.lr.ph.i, label %B34.if.i.i7246

B314.if.i.lr.ph.i:                                ; preds = %B34.i.loopexit.i7248
  %130 = add i64 %.450.i, %.420.i7244
  br label %B314.if.i.i

B314.i.loopexit.i:                                ; preds = %B474.if.i.i, %B314.if.i.i
  %.683.i.i = icmp sgt i64 %.627.i.0662.in.i, 1
  br i1 %.683.i.i, label %B314.if.i.i, label %B302.if.lr.ph.i

B302.if.lr.ph.i:                                  ; preds = %B314.i.loopexit.i
  %.677.i = mul nsw i64 %.1948, %arg.shape.1
  %invariant.gep7857 = getelementptr double, ptr %arg.arrays.0.4, i64 %.677.i
  br label %B302.if.i

B34.if.i.i7246:                                   ; preds = %B34.i.loopexit.i7248, %B190.i7243
  %.73.i.0654.i = phi i64 [ 0, %B190.i7243 ], [ %.144.i.i, %B34.i.loopexit.i7248 ]
  %.144.i.i = add nsw i64 %.73.i.0654.i, 1
  %131 = getelementptr i64, ptr %arg.linear.2.4, i64 %.73.i.0654.i
  %.202.i.i = load i64, ptr %131, align 8, !noalias !53
  %.204.i.i = add nsw i64 %.202.i.i, %.454.i
  %.218.i.i = icmp slt i64 %.204.i.i, 0
  %.219.i.i = select i1 %.218.i.i, i64 %arg.arrays.0.5.0, i64 0
  %132 = getelementptr double, ptr %arg.arrays.0.4, i64 %.204.i.i
  %.233.i.i = getelementptr double, ptr %132, i64 %.219.i.i
  %.234.i.i = load double, ptr %.233.i.i, align 8, !noalias !53
  %gep7572 = getelementptr double, ptr %invariant.gep7571, i64 %.73.i.0654.i
  %.270.i.i = load double, ptr %gep7572, align 8, !noalias !53
  store double %.270.i.i, ptr %.233.i.i, align 8, !noalias !53
  store double %.234.i.i, ptr %gep7572, align 8, !noalias !53
  %.340.i.i = add i64 %.339.i.i7245, %.73.i.0654.i
  %.11.i.i.i7247 = tail call i64 @llvm.smin.i64(i64 %.340.i.i, i64 %arg.shape.1)
  %.406.i.i = sub i64 %.11.i.i.i7247, %.144.i.i
  %.449.i650.not.i = icmp slt i64 %.406.i.i, 1
  br i1 %.449.i650.not.i, label %B34.i.loopexit.i7248, label %B198.if.i.lr.ph.i

B198.if.i.lr.ph.i:                                ; preds = %B34.if.i.i7246
  %.521.i.i = mul nsw i64 %.73.i.0654.i, %arg.shape.1
  br label %B198.if.i.i

B198.if.i.i:                                      ; preds = %B198.if.i.i, %B198.if.i.lr.ph.i
  %.396.i.0652.i = phi i64 [ %.406.i.i, %B198.if.i.lr.ph.i ], [ %.458.i.i, %B198.if.i.i ]
  %.393.i.0651.i = phi i64 [ %.144.i.i, %B198.if.i.lr.ph.i ], [ %.462.i.i, %B198.if.i.i ]
  %.458.i.i = add nsw i64 %.396.i.0652.i, -1
  %.462.i.i = add i64 %.393.i.0651.i, 1
  %.488.i.i = add nsw i64 %.393.i.0651.i, %.454.i
  %.502.i.i = icmp slt i64 %.488.i.i, 0
  %.503.i.i = select i1 %.502.i.i, i64 %arg.arrays.0.5.0, i64 0
  %133 = getelementptr double, ptr %arg.arrays.0.4, i64 %.488.i.i
  %.517.i.i = getelementptr double, ptr %133, i64 %.503.i.i
  %.518.i.i = load double, ptr %.517.i.i, align 8, !noalias !53
  %.522.i.i = add nsw i64 %.393.i.0651.i, %.521.i.i
  %.536.i.i = icmp slt i64 %.522.i.i, 0
  %.537.i.i = select i1 %.536.i.i, i64 %arg.linear.1.5.0, i64 0
  %134 = getelementptr double, ptr %arg.linear.1.4, i64 %.522.i.i
  %.551.i.i = getelementptr double, ptr %134, i64 %.537.i.i
  %.552.i.i = load double, ptr %.551.i.i, align 8, !noalias !53
  %.554.i.i = fmul double %.234.i.i, %.552.i.i
  %.555.i.i = fsub double %.518.i.i, %.554.i.i
  store double %.555.i.i, ptr %.517.i.i, align 8, !noalias !53
  %.449.i.i = icmp sgt i64 %.396.i.0652.i, 1
  br i1 %.449.i.i, label %B198.if.i.i, label %B34.i.loopexit.i7248

B314.if.i.i:                                      ; preds = %B314.i.loopexit.i, %B314.if.i.lr.ph.i
  %.627.i.0662.in.i = phi i64 [ %arg.shape.1, %B314.if.i.lr.ph.i ], [ %.627.i.0662.i, %B314.i.loopexit.i ]
  %.627.i.0662.i = add nsw i64 %.627.i.0662.in.i, -1
  %.726.i.i = add nsw i64 %.627.i.0662.i, %.454.i
  %.740.i.i = icmp slt i64 %.726.i.i, 0
  %.741.i.i = select i1 %.740.i.i, i64 %arg.arrays.0.5.0, i64 0
  %135 = getelementptr double, ptr %arg.arrays.0.4, i64 %.726.i.i
  %.755.i.i = getelementptr double, ptr %135, i64 %.741.i.i
  %.756.i.i = load double, ptr %.755.i.i, align 8, !noalias !53
  %.759.i.i7249 = mul nsw i64 %.627.i.0662.i, %arg.shape.1
  %.761.i.i = add nsw i64 %.759.i.i7249, %.627.i.0662.i
  %.775.i.i = icmp slt i64 %.761.i.i, 0
  %.776.i.i = select i1 %.775.i.i, i64 %arg.linear.1.5.0, i64 0
  %136 = getelementptr double, ptr %arg.linear.1.4, i64 %.761.i.i
  %.790.i.i = getelementptr double, ptr %136, i64 %.776.i.i
  %.791.i.i = load double, ptr %.790.i.i, align 8, !noalias !53
  %.795.i.i = fdiv double %.756.i.i, %.791.i.i
  store double %.795.i.i, ptr %.755.i.i, align 8, !noalias !53
  %.866.i.i = sub i64 %.627.i.0662.i, %130
  %.11.i4.i.i7250 = tail call i64 @llvm.smax.i64(i64 %.866.i.i, i64 0)
  %.932.i.i = sub i64 %.627.i.0662.i, %.11.i4.i.i7250
  %.975.i656.not.i = icmp slt i64 %.932.i.i, 1
  br i1 %.975.i656.not.i, label %B314.i.loopexit.i, label %B474.if.i.i

B474.if.i.i:                                      ; preds = %B314.if.i.i, %B474.if.i.i
  %.922.i.0658.i = phi i64 [ %.984.i.i, %B474.if.i.i ], [ %.932.i.i, %B314.if.i.i ]
  %.919.i.0657.i = phi i64 [ %.988.i.i7251, %B474.if.i.i ], [ %.11.i4.i.i7250, %B314.if.i.i ]
  %.984.i.i = add nsw i64 %.922.i.0658.i, -1
  %.988.i.i7251 = add i64 %.919.i.0657.i, 1
  %.1014.i.i = add nsw i64 %.919.i.0657.i, %.454.i
  %.1028.i.i = icmp slt i64 %.1014.i.i, 0
  %.1029.i.i = select i1 %.1028.i.i, i64 %arg.arrays.0.5.0, i64 0
  %137 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1014.i.i
  %.1043.i.i = getelementptr double, ptr %137, i64 %.1029.i.i
  %.1044.i.i = load double, ptr %.1043.i.i, align 8, !noalias !53
  %.1048.i.i = add nsw i64 %.919.i.0657.i, %.759.i.i7249
  %.1062.i.i = icmp slt i64 %.1048.i.i, 0
  %.1063.i.i = select i1 %.1062.i.i, i64 %arg.linear.1.5.0, i64 0
  %138 = getelementptr double, ptr %arg.linear.1.4, i64 %.1048.i.i
  %.1077.i.i = getelementptr double, ptr %138, i64 %.1063.i.i
  %.1078.i.i = load double, ptr %.1077.i.i, align 8, !noalias !53
  %.1080.i.i = fmul double %.795.i.i, %.1078.i.i
  %.1081.i.i = fsub double %.1044.i.i, %.1080.i.i
  store double %.1081.i.i, ptr %.1043.i.i, align 8, !noalias !53
  %.975.i.i = icmp sgt i64 %.922.i.0658.i, 1
  br i1 %.975.i.i, label %B474.if.i.i, label %B314.i.loopexit.i

B60.if.i:                                         ; preds = %B60.if.i, %B60.if.lr.ph.i
  %.157.0648.i = phi i64 [ 0, %B60.if.lr.ph.i ], [ %.228.i, %B60.if.i ]
  %.228.i = add nsw i64 %.157.0648.i, 1
  %gep7856 = getelementptr double, ptr %invariant.gep7855, i64 %.157.0648.i
  %.287.i = load double, ptr %gep7856, align 8, !noalias !50
  %gep7570 = getelementptr double, ptr %invariant.gep7569, i64 %.157.0648.i
  %.320.i = load double, ptr %gep7570, align 8, !noalias !50
  %.321.i = fadd double %.287.i, %.320.i
  %139 = getelementptr i64, ptr %arg.linear.3.4, i64 %.157.0648.i
  %.353.i = load i64, ptr %139, align 8, !noalias !50
  %.354.i = add nsw i64 %.353.i, %.323.i
  %.368.i = icmp slt i64 %.354.i, 0
  %.369.i = select i1 %.368.i, i64 %arg.arrays.0.5.0, i64 0
  %140 = getelementptr double, ptr %arg.arrays.0.4, i64 %.354.i
  %.383.i = getelementptr double, ptr %140, i64 %.369.i
  store double %.321.i, ptr %.383.i, align 8, !noalias !50
  %exitcond.not.i7242 = icmp eq i64 %arg.shape.1, %.228.i
  br i1 %exitcond.not.i7242, label %B190.i7243, label %B60.if.i

B302.if.i:                                        ; preds = %B302.if.i, %B302.if.lr.ph.i
  %.517.0664.i = phi i64 [ 0, %B302.if.lr.ph.i ], [ %.586.i, %B302.if.i ]
  %.586.i = add nsw i64 %.517.0664.i, 1
  %141 = getelementptr i64, ptr %arg.linear.3.4, i64 %.517.0664.i
  %.642.i = load i64, ptr %141, align 8, !noalias !50
  %.643.i = add nsw i64 %.642.i, %.454.i
  %.657.i = icmp slt i64 %.643.i, 0
  %.658.i = select i1 %.657.i, i64 %arg.arrays.0.5.0, i64 0
  %142 = getelementptr double, ptr %arg.arrays.0.4, i64 %.643.i
  %.672.i = getelementptr double, ptr %142, i64 %.658.i
  %.673.i = load double, ptr %.672.i, align 8, !noalias !50
  %gep7858 = getelementptr double, ptr %invariant.gep7857, i64 %.517.0664.i
  store double %.673.i, ptr %gep7858, align 8, !noalias !50
  %exitcond667.not.i = icmp eq i64 %arg.shape.1, %.586.i
  br i1 %exitcond667.not.i, label %B1500, label %B302.if.i

B1500:                                            ; preds = %B302.if.i, %B1276.if
  %exitcond7677.not = icmp eq i64 %.1879.07573, %.
  br i1 %exitcond7677.not, label %B1502, label %B1276.if

B1502:                                            ; preds = %B1500
  %.2228 = load i64, ptr %.2227, align 8
  %.2273 = inttoptr i64 %.2228 to ptr
  tail call void %.2273(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.tolerances.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.274.i, label %B2274, label %B1616.if

B1694:                                            ; preds = %B1616.if
  %.2609 = mul i64 %.2487, %arg.results.3.5.1
  %143 = getelementptr i64, ptr %arg.results.3.4, i64 %.2609
  %.2613 = getelementptr i8, ptr %143, i64 8
  %.2614 = load i64, ptr %.2613, align 8
  %.2617 = add nsw i64 %.2614, %.
  store i64 %.2617, ptr %.2613, align 8
  %.2723 = getelementptr double, ptr %267, i64 %.2319.07576
  %.2724 = load double, ptr %.2723, align 8
  %.2725 = fcmp ogt double %.2724, 5.000000e-01
  br i1 %.2725, label %B1784, label %B1830

B1784:                                            ; preds = %B1694
  %144 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2319.07576
  %.84.i771 = load i64, ptr %144, align 8, !noalias !57
  %.89.i774 = icmp sgt i64 %.84.i771, -1
  br i1 %.89.i774, label %B46.i, label %B1830

B46.i:                                            ; preds = %B1784
  %.120.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i771
  %.121.i786 = load i64, ptr %.120.i, align 8, !noalias !57
  %.122.i787 = icmp eq i64 %.121.i786, 0
  br i1 %.122.i787, label %B80.i, label %B1830

B80.i:                                            ; preds = %B46.i
  store i64 2, ptr %.120.i, align 8, !noalias !57
  br label %B1830

B1830:                                            ; preds = %B80.i, %B1784, %B46.i, %B1694
  %.2815 = getelementptr double, ptr %268, i64 %.2319.07576
  %.2816 = load double, ptr %.2815, align 8
  %.2817 = fcmp olt double %.2816, 5.000000e-01
  br i1 %.2817, label %B1868, label %B1916

B1868:                                            ; preds = %B1830
  %.2902 = getelementptr i8, ptr %143, i64 24
  %.2903 = load i64, ptr %.2902, align 8
  %.2904 = add nsw i64 %.2903, 1
  store i64 %.2904, ptr %.2902, align 8
  br label %B4108

B1916:                                            ; preds = %B1830
  %spec.select = select i1 %within.3.17580, i1 true, i1 %.2972
  %.3042 = load i64, ptr %143, align 8
  %.3043 = add nsw i64 %.3042, 1
  store i64 %.3043, ptr %143, align 8
  %.3150 = load i64, ptr %.2613, align 8
  %.3151 = add nsw i64 %.3150, 1
  store i64 %.3151, ptr %.2613, align 8
  %.3279.0 = and i64 %.3043, 127
  %.3309 = icmp eq i64 %.3279.0, 0
  %or.cond7548 = select i1 %doubted.2.17581, i1 true, i1 %.3309
  br i1 %or.cond7548, label %B2122, label %B2086

B2086:                                            ; preds = %B1916
  %.3366 = getelementptr double, ptr %269, i64 %.2319.07576
  %.3367 = load double, ptr %.3366, align 8
  %.3369 = fcmp ogt double %.3367, 0.000000e+00
  br label %B2122

B2122:                                            ; preds = %B2086, %B1916
  %"$phi2122.1.3.4" = phi i1 [ true, %B1916 ], [ %.3369, %B2086 ]
  %.3404 = icmp slt i64 %.2542, %arg.times.5.0
  br i1 %.3404, label %B2162, label %B4108

B2162:                                            ; preds = %B2122
  %.3434 = icmp slt i64 %.2542, 0
  %.3435 = select i1 %.3434, i64 %arg.times.5.0, i64 0
  %145 = getelementptr double, ptr %arg.times.4, i64 %.2542
  %.3449 = getelementptr double, ptr %145, i64 %.3435
  %.3450 = load double, ptr %.3449, align 8
  %.3504 = getelementptr double, ptr %270, i64 %.2319.07576
  %.3505 = load double, ptr %.3504, align 8
  %.3506 = fcmp ugt double %.3450, %.3505
  br i1 %.3506, label %B4108, label %B2212

B2212:                                            ; preds = %B2162
  %.3617 = fcmp olt double %.3450, %.3505
  %spec.select7226 = or i1 %spec.select, %.3617
  br label %B4108

B2274.loopexit:                                   ; preds = %B4108
  %146 = xor i1 %doubted.3.2, true
  %147 = select i1 %146, i1 true, i1 %.611
  %148 = select i1 %wanted.3.2, i1 true, i1 %within.4.2
  br label %B2274

B2274:                                            ; preds = %B2274.loopexit, %B1502
  %good.2.1.lcssa = phi i1 [ false, %B1502 ], [ %good.3.2, %B2274.loopexit ]
  %wanted.2.1.lcssa = phi i1 [ false, %B1502 ], [ %148, %B2274.loopexit ]
  %within.3.1.lcssa = phi i1 [ false, %B1502 ], [ %within.4.2, %B2274.loopexit ]
  %doubted.2.1.lcssa = phi i1 [ true, %B1502 ], [ %147, %B2274.loopexit ]
  br i1 %good.2.1.lcssa, label %B2278, label %B2394

B2278:                                            ; preds = %B2274
  %.3722 = load i64, ptr %arg.code.4, align 8
  %.3772 = inttoptr i64 %.3722 to ptr
  tail call void %.3772(ptr %.562, ptr %.3746, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.3771)
  br label %B2394

B2394:                                            ; preds = %B2278, %B2274
  br i1 %doubted.2.1.lcssa, label %B2470, label %B2402

B2402:                                            ; preds = %B2394
  %.3810 = load i64, ptr %.3809, align 8
  %.3855 = inttoptr i64 %.3810 to ptr
  tail call void %.3855(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B2470

B2470:                                            ; preds = %B2394, %B2402
  %brmerge7227.not = and i1 %.3866, %good.2.1.lcssa
  br i1 %brmerge7227.not, label %B2490, label %B2612

B2490:                                            ; preds = %B2470
  %.3906 = load i64, ptr %.3905, align 8
  %.3953 = inttoptr i64 %.3906 to ptr
  tail call void %.3953(ptr %.562, ptr %.3927, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %.274.i, label %B2612, label %B38.if.i

B104.i1024:                                       ; preds = %B38.if.i
  %.349.i1070 = getelementptr double, ptr %272, i64 %.78.i854.07587
  %.350.i1071 = load double, ptr %.349.i1070, align 8, !noalias !60
  %.351.i1072 = fcmp ogt double %.350.i1071, 5.000000e-01
  br i1 %.351.i1072, label %B34.i.i, label %B304.i

B34.i.i:                                          ; preds = %B104.i1024, %B36.i.i
  %.48.i.i817.0 = phi i64 [ %.119.i.i, %B36.i.i ], [ 0, %B104.i1024 ]
  %exitcond7678.not = icmp eq i64 %.48.i.i817.0, %arg.decided
  br i1 %exitcond7678.not, label %B142.endif.i, label %B36.i.i

B36.i.i:                                          ; preds = %B34.i.i
  %.119.i.i = add i64 %.48.i.i817.0, 1
  %.149.i.i1326 = add nsw i64 %.48.i.i817.0, %arg.decided
  %.151.i.i1328 = mul nsw i64 %.149.i.i1326, %arg.shape.0
  %.153.i.i = add nsw i64 %.151.i.i1328, %.78.i854.07587
  %.167.i.i = icmp slt i64 %.153.i.i, 0
  %.168.i.i1332 = select i1 %.167.i.i, i64 %arg.arrays.4.5.0, i64 0
  %149 = getelementptr double, ptr %arg.arrays.4.4, i64 %.153.i.i
  %.182.i.i = getelementptr double, ptr %149, i64 %.168.i.i1332
  %.183.i.i = load double, ptr %.182.i.i, align 8, !noalias !64
  %.184.i.i = fcmp ogt double %.183.i.i, 5.000000e-01
  br i1 %.184.i.i, label %B142.endif.i, label %B34.i.i

B190.i1134:                                       ; preds = %B142.endif.i
  store double 1.000000e+00, ptr %.234.i970, align 8, !noalias !60
  %.503.i1228 = getelementptr double, ptr %273, i64 %.78.i854.07587
  store double 0.000000e+00, ptr %.503.i1228, align 8, !noalias !60
  %.558.i1273 = getelementptr double, ptr %274, i64 %.78.i854.07587
  store double 1.000000e+00, ptr %.558.i1273, align 8, !noalias !60
  %.616.i1316 = getelementptr i64, ptr %275, i64 %.78.i854.07587
  store i64 %.363.i865.0, ptr %.616.i1316, align 8, !noalias !60
  br label %B304.i

B304.i:                                           ; preds = %B142.endif.i, %B190.i1134, %B104.i1024, %B38.if.i
  %some.3.i.1 = phi i1 [ true, %B190.i1134 ], [ %some.2.i.07589, %B142.endif.i ], [ %some.2.i.07589, %B104.i1024 ], [ %some.2.i.07589, %B38.if.i ]
  %.136.i906 = icmp sgt i64 %.81.i855.07588, 1
  br i1 %.136.i906, label %B38.if.i, label %B2612

B38.if.i:                                         ; preds = %B2490, %B304.i
  %some.2.i.07589 = phi i1 [ %some.3.i.1, %B304.i ], [ false, %B2490 ]
  %.81.i855.07588 = phi i64 [ %.145.i1347, %B304.i ], [ %storemerge, %B2490 ]
  %.78.i854.07587 = phi i64 [ %.149.i1350, %B304.i ], [ 0, %B2490 ]
  %.145.i1347 = add nsw i64 %.81.i855.07588, -1
  %.149.i1350 = add nsw i64 %.78.i854.07587, 1
  %.234.i970 = getelementptr double, ptr %271, i64 %.78.i854.07587
  store double 0.000000e+00, ptr %.234.i970, align 8, !noalias !60
  %.289.i1016 = getelementptr i64, ptr %arg.lane.1.4, i64 %.78.i854.07587
  %.290.i1017 = load i64, ptr %.289.i1016, align 8, !noalias !60
  %.291.i1018 = icmp sgt i64 %.290.i1017, -1
  br i1 %.291.i1018, label %B104.i1024, label %B304.i

B142.endif.i:                                     ; preds = %B36.i.i, %B34.i.i
  %.363.i865.0 = phi i64 [ %.48.i.i817.0, %B36.i.i ], [ -1, %B34.i.i ]
  %.393.i1133 = icmp sgt i64 %.363.i865.0, -1
  br i1 %.393.i1133, label %B190.i1134, label %B304.i

B2612:                                            ; preds = %B304.i, %B2490, %B2470
  %beyond.2.1 = phi i1 [ false, %B2470 ], [ false, %B2490 ], [ %some.3.i.1, %B304.i ]
  %brmerge7228 = select i1 %within.3.1.lcssa, i1 true, i1 %beyond.2.1
  br i1 %brmerge7228, label %B2620, label %B3112

B2620:                                            ; preds = %B2612
  br i1 %.611, label %B2958, label %B2688.if

B2958:                                            ; preds = %B2688.if, %B2620
  %.4406 = load i64, ptr %.4405, align 8
  %.4451 = inttoptr i64 %.4406 to ptr
  tail call void %.4451(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br i1 %beyond.2.1, label %B104.if.i, label %B3070

B102.loopexit.i.critedge:                         ; preds = %B104.if.i
  %.1014.i.c = load i64, ptr %.1013.i, align 8, !noalias !68
  %.1131.i.c = inttoptr i64 %.1014.i.c to ptr
  tail call void %.1131.i.c(ptr %.562, ptr %.1105.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !68
  br label %B102.loopexit.i

B102.loopexit.i:                                  ; preds = %B1498.i, %B102.loopexit.i.critedge
  %.281.i = icmp ugt i64 %.225.01193.i, 1
  br i1 %.281.i, label %B104.if.i, label %B842.i

B138.loopexit.i:                                  ; preds = %B380.if.i, %middle.block7778, %B138.if.i
  %exitcond1198.not.i = icmp eq i64 %arg.shape.0, %.412.i
  br i1 %exitcond1198.not.i, label %B474.i, label %B138.if.i

B474.i:                                           ; preds = %B138.loopexit.i
  %.1014.i = load i64, ptr %.1013.i, align 8, !noalias !68
  %.1131.i = inttoptr i64 %.1014.i to ptr
  tail call void %.1131.i(ptr %.562, ptr %.1105.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !68
  br label %B622.if.i

B674.i:                                           ; preds = %B622.if.i
  %.1364.i = getelementptr double, ptr %276, i64 %.1157.01191.i
  %.1365.i = load double, ptr %.1364.i, align 8, !noalias !68
  %.1419.i = getelementptr double, ptr %277, i64 %.1157.01191.i
  %.1420.i = load double, ptr %.1419.i, align 8, !noalias !68
  %.1421.i = fadd double %.1365.i, %.1420.i
  %.1422.i = fmul double %.1421.i, 5.000000e-01
  br label %B34.i.i7260

B34.i.i7260:                                      ; preds = %B34.if.i.i7261, %B674.i
  %.48.i.0.i = phi i64 [ 0, %B674.i ], [ %.119.i73.i, %B34.if.i.i7261 ]
  %exitcond1199.not.i = icmp eq i64 %.48.i.0.i, %storemerge1173.i
  br i1 %exitcond1199.not.i, label %B812.i, label %B34.if.i.i7261

B80.i.i7263:                                      ; preds = %B34.if.i.i7261
  %150 = icmp sgt i64 %.48.i.0.i, -1
  br i1 %150, label %B786.i, label %B812.i

B34.if.i.i7261:                                   ; preds = %B34.i.i7260
  %.119.i73.i = add i64 %.48.i.0.i, 1
  %.149.i42.i = add nsw i64 %.48.i.0.i, %arg.decided
  %.151.i.i = mul nsw i64 %.149.i42.i, %arg.shape.0
  %.153.i44.i = add nsw i64 %.151.i.i, %.1157.01191.i
  %.167.i51.i = icmp slt i64 %.153.i44.i, 0
  %.168.i.i = select i1 %.167.i51.i, i64 %arg.arrays.4.5.0, i64 0
  %151 = getelementptr double, ptr %arg.arrays.4.4, i64 %.153.i44.i
  %.182.i.i7262 = getelementptr double, ptr %151, i64 %.168.i.i
  %.183.i63.i = load double, ptr %.182.i.i7262, align 8, !noalias !71
  %.184.i64.i = fcmp ogt double %.183.i63.i, 5.000000e-01
  br i1 %.184.i64.i, label %B80.i.i7263, label %B34.i.i7260

B786.i:                                           ; preds = %B80.i.i7263
  store double %.1422.i, ptr %.1419.i, align 8, !noalias !68
  br label %B1498.i

B812.i:                                           ; preds = %B34.i.i7260, %B80.i.i7263
  store double %.1422.i, ptr %.1364.i, align 8, !noalias !68
  br label %B1498.i

B842.i:                                           ; preds = %B102.loopexit.i
  br i1 %.274.i, label %B3070, label %B874.if.i

B978.i:                                           ; preds = %B874.if.i
  %.2010.i = load double, ptr %.1786.i, align 8, !noalias !68
  %.2011.i = tail call double @llvm.fabs.f64(double %.2010.i)
  %.2012.i = fmul double %.2011.i, 2.000000e-12
  %.2069.i = getelementptr double, ptr %276, i64 %.1635.01195.i
  %.2070.i = load double, ptr %.2069.i, align 8, !noalias !68
  %.2125.i = getelementptr double, ptr %279, i64 %.1635.01195.i
  %.2126.i = load double, ptr %.2125.i, align 8, !noalias !68
  %.2183.i = fmul double %.2126.i, 0x3D719799812DEA11
  %.10.i.i = fcmp ogt double %.2012.i, %.2183.i
  %.11.i.i7259 = select i1 %.10.i.i, double %.2012.i, double %.2183.i
  %.2071.i = fsub double 1.000000e+00, %.2070.i
  %.2127.i = fmul double %.2071.i, %.2126.i
  %.2212.i = fcmp ugt double %.2127.i, %.11.i.i7259
  br i1 %.2212.i, label %B1268.i, label %B1232.i

B1232.i:                                          ; preds = %B978.i
  store double 2.000000e+00, ptr %.1896.i, align 8, !noalias !68
  br label %B1497.i

B1268.i:                                          ; preds = %B978.i
  %152 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1635.01195.i
  %.1954.i = load i64, ptr %152, align 8, !noalias !68
  %.2331.i = getelementptr double, ptr %281, i64 %.1635.01195.i
  store double 0.000000e+00, ptr %.2331.i, align 8, !noalias !68
  %.2386.i = getelementptr double, ptr %282, i64 %.1635.01195.i
  store double 0.000000e+00, ptr %.2386.i, align 8, !noalias !68
  %.2441.i = getelementptr double, ptr %277, i64 %.1635.01195.i
  %.2442.i = load double, ptr %.2441.i, align 8, !noalias !68
  %.2497.i = load double, ptr %.2125.i, align 8, !noalias !68
  %.2498.i = fmul double %.2442.i, %.2497.i
  %.2554.i = getelementptr double, ptr %283, i64 %.1635.01195.i
  store double %.2498.i, ptr %.2554.i, align 8, !noalias !68
  %.2583.i = icmp slt i64 %.1954.i, 0
  %.2584.i = select i1 %.2583.i, i64 %arg.results.3.5.0, i64 0
  %.2585.i = add i64 %.2584.i, %.1954.i
  %.2605.i = mul i64 %.2585.i, %arg.results.3.5.1
  %.2609.i = getelementptr i64, ptr %arg.results.3.4, i64 %.2605.i
  %.2610.i = load i64, ptr %.2609.i, align 8, !noalias !68
  %.2611.i = add nsw i64 %.2610.i, -1
  store i64 %.2611.i, ptr %.2609.i, align 8, !noalias !68
  %.2719.i = getelementptr i8, ptr %.2609.i, i64 24
  %.2720.i = load i64, ptr %.2719.i, align 8, !noalias !68
  %.2721.i = add nsw i64 %.2720.i, 1
  store i64 %.2721.i, ptr %.2719.i, align 8, !noalias !68
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
  %.493.i = getelementptr double, ptr %276, i64 %.343.01188.i
  %.494.i = load double, ptr %.493.i, align 8, !noalias !68
  %.548.i7255 = getelementptr double, ptr %277, i64 %.343.01188.i
  %.549.i = load double, ptr %.548.i7255, align 8, !noalias !68
  %.550.i = fadd double %.494.i, %.549.i
  %.551.i = fmul double %.550.i, 5.000000e-01
  %.608.i = getelementptr double, ptr %278, i64 %.343.01188.i
  %.609.i = load double, ptr %.608.i, align 8, !noalias !68
  %.610.i = fcmp une double %.609.i, 1.000000e+00
  %share.3.2.i = select i1 %.610.i, double 1.000000e+00, double %.551.i
  %.668.i = getelementptr double, ptr %arg.lane.0.4, i64 %.343.01188.i
  %.669.i = load double, ptr %.668.i, align 8, !noalias !68
  %.723.i = getelementptr double, ptr %279, i64 %.343.01188.i
  %.724.i = load double, ptr %.723.i, align 8, !noalias !68
  %.726.i = fmul double %share.3.2.i, %.724.i
  %.727.i = fadd double %.669.i, %.726.i
  %.781.i = getelementptr double, ptr %.562, i64 %.343.01188.i
  store double %.727.i, ptr %.781.i, align 8, !noalias !68
  br i1 %.8631184.not.i, label %B138.loopexit.i, label %B380.if.lr.ph.i

B380.if.lr.ph.i:                                  ; preds = %B138.if.i
  %.247.i.i = fsub double 1.000000e+00, %share.3.2.i
  %invariant.gep7593 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep7595 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep7597 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep7599 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep7601 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep7603 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep7605 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep7607 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %invariant.gep7609 = getelementptr double, ptr %arg.arrays.0.4, i64 %.343.01188.i
  %or.cond7840.not = xor i1 %or.cond7840, true
  %brmerge7899 = select i1 %or.cond7840.not, i1 true, i1 %conflict.rdx7757
  br i1 %brmerge7899, label %B380.if.i.preheader, label %vector.ph7760

vector.ph7760:                                    ; preds = %B380.if.lr.ph.i
  %broadcast.splatinsert7763 = insertelement <2 x double> poison, double %.247.i.i, i64 0
  %broadcast.splat7764 = shufflevector <2 x double> %broadcast.splatinsert7763, <2 x double> poison, <2 x i32> zeroinitializer
  %broadcast.splatinsert7765 = insertelement <2 x double> poison, double %share.3.2.i, i64 0
  %broadcast.splat7766 = shufflevector <2 x double> %broadcast.splatinsert7765, <2 x double> poison, <2 x i32> zeroinitializer
  %invariant.gep7859 = getelementptr double, ptr %invariant.gep7593, i64 %.155.i.i
  %invariant.gep7861 = getelementptr double, ptr %invariant.gep7595, i64 %.155.i.1.i
  %invariant.gep7863 = getelementptr double, ptr %invariant.gep7597, i64 %.155.i.2.i
  %invariant.gep7865 = getelementptr double, ptr %invariant.gep7599, i64 %.155.i.3.i
  %invariant.gep7867 = getelementptr double, ptr %invariant.gep7601, i64 %.155.i.4.i
  %invariant.gep7869 = getelementptr double, ptr %invariant.gep7603, i64 %.155.i.5.i
  %invariant.gep7871 = getelementptr double, ptr %invariant.gep7605, i64 %.155.i.6.i
  %invariant.gep7873 = getelementptr double, ptr %invariant.gep7609, i64 %.935.i
  br label %vector.body7767

vector.body7767:                                  ; preds = %vector.body7767, %vector.ph7760
  %index7768 = phi i64 [ 0, %vector.ph7760 ], [ %index.next7777, %vector.body7767 ]
  %gep7860 = getelementptr double, ptr %invariant.gep7859, i64 %index7768
  %wide.load7769 = load <2 x double>, ptr %gep7860, align 8, !noalias !75
  %153 = fadd <2 x double> %wide.load7769, zeroinitializer
  %154 = fmul <2 x double> %broadcast.splat7766, %153
  %gep7862 = getelementptr double, ptr %invariant.gep7861, i64 %index7768
  %wide.load7770 = load <2 x double>, ptr %gep7862, align 8, !noalias !75
  %155 = fadd <2 x double> %wide.load7770, %154
  %156 = fmul <2 x double> %broadcast.splat7764, %155
  %gep7864 = getelementptr double, ptr %invariant.gep7863, i64 %index7768
  %wide.load7771 = load <2 x double>, ptr %gep7864, align 8, !noalias !75
  %157 = fadd <2 x double> %wide.load7771, %156
  %158 = fmul <2 x double> %broadcast.splat7766, %157
  %gep7866 = getelementptr double, ptr %invariant.gep7865, i64 %index7768
  %wide.load7772 = load <2 x double>, ptr %gep7866, align 8, !noalias !75
  %159 = fadd <2 x double> %wide.load7772, %158
  %160 = fmul <2 x double> %broadcast.splat7764, %159
  %gep7868 = getelementptr double, ptr %invariant.gep7867, i64 %index7768
  %wide.load7773 = load <2 x double>, ptr %gep7868, align 8, !noalias !75
  %161 = fadd <2 x double> %wide.load7773, %160
  %162 = fmul <2 x double> %broadcast.splat7766, %161
  %gep7870 = getelementptr double, ptr %invariant.gep7869, i64 %index7768
  %wide.load7774 = load <2 x double>, ptr %gep7870, align 8, !noalias !75
  %163 = fadd <2 x double> %wide.load7774, %162
  %164 = fmul <2 x double> %broadcast.splat7764, %163
  %gep7872 = getelementptr double, ptr %invariant.gep7871, i64 %index7768
  %wide.load7775 = load <2 x double>, ptr %gep7872, align 8, !noalias !75
  %165 = fadd <2 x double> %wide.load7775, %164
  %166 = fmul <2 x double> %broadcast.splat7766, %165
  %167 = getelementptr double, ptr %invariant.gep7607, i64 %index7768
  %wide.load7776 = load <2 x double>, ptr %167, align 8, !noalias !75
  %168 = fadd <2 x double> %wide.load7776, %166
  %gep7874 = getelementptr double, ptr %invariant.gep7873, i64 %index7768
  store <2 x double> %168, ptr %gep7874, align 8, !noalias !68
  %index.next7777 = add i64 %index7768, 2
  %169 = icmp eq i64 %index.next7777, %n.vec7762
  br i1 %169, label %middle.block7778, label %vector.body7767, !llvm.loop !79

middle.block7778:                                 ; preds = %vector.body7767
  br i1 %cmp.n7779, label %B138.loopexit.i, label %B380.if.i.preheader

B380.if.i.preheader:                              ; preds = %B380.if.lr.ph.i, %middle.block7778
  %.807.01185.i.ph = phi i64 [ %n.vec7762, %middle.block7778 ], [ 0, %B380.if.lr.ph.i ]
  br label %B380.if.i

B380.if.i:                                        ; preds = %B380.if.i.preheader, %B380.if.i
  %.807.01185.i = phi i64 [ %.876.i, %B380.if.i ], [ %.807.01185.i.ph, %B380.if.i.preheader ]
  %.157.i.i = add nsw i64 %.807.01185.i, %.155.i.i
  %.159.i.i = mul nsw i64 %.157.i.i, %arg.shape.0
  %gep7594 = getelementptr double, ptr %invariant.gep7593, i64 %.159.i.i
  %.191.i.i = load double, ptr %gep7594, align 8, !noalias !75
  %.193.i.i = fadd double %.191.i.i, 0.000000e+00
  %.253.i.i = fmul double %share.3.2.i, %.193.i.i
  %.157.i.1.i = add nsw i64 %.807.01185.i, %.155.i.1.i
  %.159.i.1.i = mul nsw i64 %.157.i.1.i, %arg.shape.0
  %gep7596 = getelementptr double, ptr %invariant.gep7595, i64 %.159.i.1.i
  %.191.i.1.i = load double, ptr %gep7596, align 8, !noalias !75
  %.193.i.1.i = fadd double %.191.i.1.i, %.253.i.i
  %.253.i.1.i = fmul double %.247.i.i, %.193.i.1.i
  %.157.i.2.i = add nsw i64 %.807.01185.i, %.155.i.2.i
  %.159.i.2.i = mul nsw i64 %.157.i.2.i, %arg.shape.0
  %gep7598 = getelementptr double, ptr %invariant.gep7597, i64 %.159.i.2.i
  %.191.i.2.i = load double, ptr %gep7598, align 8, !noalias !75
  %.193.i.2.i = fadd double %.191.i.2.i, %.253.i.1.i
  %.253.i.2.i = fmul double %share.3.2.i, %.193.i.2.i
  %.157.i.3.i = add nsw i64 %.807.01185.i, %.155.i.3.i
  %.159.i.3.i = mul nsw i64 %.157.i.3.i, %arg.shape.0
  %gep7600 = getelementptr double, ptr %invariant.gep7599, i64 %.159.i.3.i
  %.191.i.3.i = load double, ptr %gep7600, align 8, !noalias !75
  %.193.i.3.i = fadd double %.191.i.3.i, %.253.i.2.i
  %.253.i.3.i = fmul double %.247.i.i, %.193.i.3.i
  %.157.i.4.i = add nsw i64 %.807.01185.i, %.155.i.4.i
  %.159.i.4.i = mul nsw i64 %.157.i.4.i, %arg.shape.0
  %gep7602 = getelementptr double, ptr %invariant.gep7601, i64 %.159.i.4.i
  %.191.i.4.i = load double, ptr %gep7602, align 8, !noalias !75
  %.193.i.4.i = fadd double %.191.i.4.i, %.253.i.3.i
  %.253.i.4.i = fmul double %share.3.2.i, %.193.i.4.i
  %.157.i.5.i = add nsw i64 %.807.01185.i, %.155.i.5.i
  %.159.i.5.i = mul nsw i64 %.157.i.5.i, %arg.shape.0
  %gep7604 = getelementptr double, ptr %invariant.gep7603, i64 %.159.i.5.i
  %.191.i.5.i = load double, ptr %gep7604, align 8, !noalias !75
  %.193.i.5.i = fadd double %.191.i.5.i, %.253.i.4.i
  %.253.i.5.i = fmul double %.247.i.i, %.193.i.5.i
  %.157.i.6.i = add nsw i64 %.807.01185.i, %.155.i.6.i
  %.159.i.6.i = mul nsw i64 %.157.i.6.i, %arg.shape.0
  %gep7606 = getelementptr double, ptr %invariant.gep7605, i64 %.159.i.6.i
  %.191.i.6.i = load double, ptr %gep7606, align 8, !noalias !75
  %.193.i.6.i = fadd double %.191.i.6.i, %.253.i.5.i
  %.253.i.6.i = fmul double %share.3.2.i, %.193.i.6.i
  %.876.i = add nsw i64 %.807.01185.i, 1
  %.271.i.i7256 = mul nsw i64 %.807.01185.i, %arg.shape.0
  %gep7608 = getelementptr double, ptr %invariant.gep7607, i64 %.271.i.i7256
  %.309.i.i = load double, ptr %gep7608, align 8, !noalias !75
  %.313.i.i = fadd double %.309.i.i, %.253.i.6.i
  %.936.i = add nsw i64 %.807.01185.i, %.935.i
  %.938.i = mul nsw i64 %.936.i, %arg.shape.0
  %gep7610 = getelementptr double, ptr %invariant.gep7609, i64 %.938.i
  store double %.313.i.i, ptr %gep7610, align 8, !noalias !68
  %exitcond.not.i7257 = icmp eq i64 %arg.shape.1, %.876.i
  br i1 %exitcond.not.i7257, label %B138.loopexit.i, label %B380.if.i, !llvm.loop !80

B622.if.i:                                        ; preds = %B474.i, %B1498.i
  %.1157.01191.i = phi i64 [ %.1226.i, %B1498.i ], [ 0, %B474.i ]
  %.1226.i = add nsw i64 %.1157.01191.i, 1
  %.1307.i = getelementptr double, ptr %278, i64 %.1157.01191.i
  %.1308.i = load double, ptr %.1307.i, align 8, !noalias !68
  %.1309.i = fcmp oeq double %.1308.i, 1.000000e+00
  br i1 %.1309.i, label %B674.i, label %B1498.i

B874.if.i:                                        ; preds = %B842.i, %B1497.i
  %.1635.01195.i = phi i64 [ %.1705.i, %B1497.i ], [ 0, %B842.i ]
  %.1705.i = add nsw i64 %.1635.01195.i, 1
  %.1786.i = getelementptr double, ptr %280, i64 %.1635.01195.i
  %.1787.i = load double, ptr %.1786.i, align 8, !noalias !68
  %.1841.i = getelementptr double, ptr %.562, i64 %.1635.01195.i
  store double %.1787.i, ptr %.1841.i, align 8, !noalias !68
  %.1896.i = getelementptr double, ptr %278, i64 %.1635.01195.i
  %.1897.i = load double, ptr %.1896.i, align 8, !noalias !68
  %.1898.i = fcmp oeq double %.1897.i, 1.000000e+00
  br i1 %.1898.i, label %B978.i, label %B1497.i

B3070:                                            ; preds = %B1497.i, %B842.i, %B2958
  br i1 %.4532.not, label %B3112, label %B112.if.i

B110.loopexit.i.critedge:                         ; preds = %B112.if.i
  %.846.i.c = load i64, ptr %.845.i, align 8, !noalias !81
  %.963.i.c = inttoptr i64 %.846.i.c to ptr
  tail call void %.963.i.c(ptr %.562, ptr %.937.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !81
  br label %B110.loopexit.i

B110.loopexit.i:                                  ; preds = %B678.i, %B110.loopexit.i.critedge
  %exitcond671.not.i = icmp eq i64 %.292.i, 17
  br i1 %exitcond671.not.i, label %B3112, label %B112.if.i

B166.loopexit.i:                                  ; preds = %B288.if.i, %middle.block7737, %B166.if.i
  %exitcond669.not.i = icmp eq i64 %arg.shape.0, %.419.i7267
  br i1 %exitcond669.not.i, label %B382.i, label %B166.if.i

B382.i:                                           ; preds = %B166.loopexit.i
  %.846.i = load i64, ptr %.845.i, align 8, !noalias !81
  %.963.i = inttoptr i64 %.846.i to ptr
  tail call void %.963.i(ptr %.562, ptr %.937.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !81
  br label %B530.if.i

B572.i:                                           ; preds = %B530.if.i
  %170 = getelementptr double, ptr %arg.arrays.4.4, i64 %.989.0665.i
  %.1173.i = load double, ptr %170, align 8, !noalias !81
  %.1175.i = fcmp olt double %.1173.i, -1.000000e-09
  br i1 %.1175.i, label %B608.i, label %B678.i

B608.i:                                           ; preds = %B572.i
  %171 = getelementptr i64, ptr %arg.lane.1.4, i64 %.989.0665.i
  %.84.i35.i = load i64, ptr %171, align 8, !noalias !84
  %.89.i37.i = icmp sgt i64 %.84.i35.i, -1
  br i1 %.89.i37.i, label %B46.i.i7316, label %B608.endif.i

B46.i.i7316:                                      ; preds = %B608.i
  %.120.i51.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i35.i
  %.121.i.i7317 = load i64, ptr %.120.i51.i, align 8, !noalias !84
  %.122.i.i7318 = icmp eq i64 %.121.i.i7317, 0
  br i1 %.122.i.i7318, label %B80.i.i7319, label %B608.endif.i

B80.i.i7319:                                      ; preds = %B46.i.i7316
  store i64 4, ptr %.120.i51.i, align 8, !noalias !84
  br label %B608.endif.i

B678.i:                                           ; preds = %B608.endif.i, %B530.if.i, %B572.i
  %exitcond670.not.i = icmp eq i64 %arg.shape.0, %.1058.i7315
  br i1 %exitcond670.not.i, label %B110.loopexit.i, label %B530.if.i

B112.if.i:                                        ; preds = %B3070, %B110.loopexit.i
  %.220.0667.i = phi i64 [ %.292.i, %B110.loopexit.i ], [ 1, %B3070 ]
  %.292.i = add nsw i64 %.220.0667.i, 1
  %172 = uitofp i64 %.220.0667.i to double
  %173 = fmul double %172, 6.250000e-02
  br i1 %.274.i, label %B110.loopexit.i.critedge, label %B166.if.lr.ph.i

B166.if.lr.ph.i:                                  ; preds = %B112.if.i
  %.247.i.i7266 = fsub double 1.000000e+00, %173
  %broadcast.splatinsert = insertelement <2 x double> poison, double %173, i64 0
  %broadcast.splat = shufflevector <2 x double> %broadcast.splatinsert, <2 x double> poison, <2 x i32> zeroinitializer
  %broadcast.splatinsert7724 = insertelement <2 x double> poison, double %.247.i.i7266, i64 0
  %broadcast.splat7725 = shufflevector <2 x double> %broadcast.splatinsert7724, <2 x double> poison, <2 x i32> zeroinitializer
  br label %B166.if.i

B166.if.i:                                        ; preds = %B166.if.lr.ph.i, %B166.loopexit.i
  %.350.0662.i = phi i64 [ 0, %B166.if.lr.ph.i ], [ %.419.i7267, %B166.loopexit.i ]
  %.419.i7267 = add nsw i64 %.350.0662.i, 1
  %.500.i = getelementptr double, ptr %arg.lane.0.4, i64 %.350.0662.i
  %.501.i = load double, ptr %.500.i, align 8, !noalias !81
  %.555.i = getelementptr double, ptr %284, i64 %.350.0662.i
  %.556.i = load double, ptr %.555.i, align 8, !noalias !81
  %.558.i = fmul double %173, %.556.i
  %.559.i = fadd double %.501.i, %.558.i
  %.613.i7268 = getelementptr double, ptr %.562, i64 %.350.0662.i
  store double %.559.i, ptr %.613.i7268, align 8, !noalias !81
  br i1 %.695658.not.i, label %B166.loopexit.i, label %B288.if.preheader.i

B288.if.preheader.i:                              ; preds = %B166.if.i
  %invariant.gep7611 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep7613 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep7615 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep7617 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep7619 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep7621 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep7623 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep7625 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %invariant.gep7627 = getelementptr double, ptr %arg.arrays.0.4, i64 %.350.0662.i
  %or.cond7841.not = xor i1 %or.cond7841, true
  %brmerge7900 = select i1 %or.cond7841.not, i1 true, i1 %conflict.rdx7718
  br i1 %brmerge7900, label %B288.if.i.preheader, label %vector.ph7721

vector.ph7721:                                    ; preds = %B288.if.preheader.i
  %invariant.gep7875 = getelementptr double, ptr %invariant.gep7611, i64 %.155.i.i7269
  %invariant.gep7877 = getelementptr double, ptr %invariant.gep7613, i64 %.155.i.1.i7275
  %invariant.gep7879 = getelementptr double, ptr %invariant.gep7615, i64 %.155.i.2.i7281
  %invariant.gep7881 = getelementptr double, ptr %invariant.gep7617, i64 %.155.i.3.i7287
  %invariant.gep7883 = getelementptr double, ptr %invariant.gep7619, i64 %.155.i.4.i7293
  %invariant.gep7885 = getelementptr double, ptr %invariant.gep7621, i64 %.155.i.5.i7299
  %invariant.gep7887 = getelementptr double, ptr %invariant.gep7623, i64 %.155.i.6.i7305
  %invariant.gep7889 = getelementptr double, ptr %invariant.gep7627, i64 %.767.i
  br label %vector.body7726

vector.body7726:                                  ; preds = %vector.body7726, %vector.ph7721
  %index7727 = phi i64 [ 0, %vector.ph7721 ], [ %index.next7736, %vector.body7726 ]
  %gep7876 = getelementptr double, ptr %invariant.gep7875, i64 %index7727
  %wide.load7728 = load <2 x double>, ptr %gep7876, align 8, !noalias !87
  %174 = fadd <2 x double> %wide.load7728, zeroinitializer
  %175 = fmul <2 x double> %broadcast.splat, %174
  %gep7878 = getelementptr double, ptr %invariant.gep7877, i64 %index7727
  %wide.load7729 = load <2 x double>, ptr %gep7878, align 8, !noalias !87
  %176 = fadd <2 x double> %wide.load7729, %175
  %177 = fmul <2 x double> %broadcast.splat7725, %176
  %gep7880 = getelementptr double, ptr %invariant.gep7879, i64 %index7727
  %wide.load7730 = load <2 x double>, ptr %gep7880, align 8, !noalias !87
  %178 = fadd <2 x double> %wide.load7730, %177
  %179 = fmul <2 x double> %broadcast.splat, %178
  %gep7882 = getelementptr double, ptr %invariant.gep7881, i64 %index7727
  %wide.load7731 = load <2 x double>, ptr %gep7882, align 8, !noalias !87
  %180 = fadd <2 x double> %wide.load7731, %179
  %181 = fmul <2 x double> %broadcast.splat7725, %180
  %gep7884 = getelementptr double, ptr %invariant.gep7883, i64 %index7727
  %wide.load7732 = load <2 x double>, ptr %gep7884, align 8, !noalias !87
  %182 = fadd <2 x double> %wide.load7732, %181
  %183 = fmul <2 x double> %broadcast.splat, %182
  %gep7886 = getelementptr double, ptr %invariant.gep7885, i64 %index7727
  %wide.load7733 = load <2 x double>, ptr %gep7886, align 8, !noalias !87
  %184 = fadd <2 x double> %wide.load7733, %183
  %185 = fmul <2 x double> %broadcast.splat7725, %184
  %gep7888 = getelementptr double, ptr %invariant.gep7887, i64 %index7727
  %wide.load7734 = load <2 x double>, ptr %gep7888, align 8, !noalias !87
  %186 = fadd <2 x double> %wide.load7734, %185
  %187 = fmul <2 x double> %broadcast.splat, %186
  %188 = getelementptr double, ptr %invariant.gep7625, i64 %index7727
  %wide.load7735 = load <2 x double>, ptr %188, align 8, !noalias !87
  %189 = fadd <2 x double> %wide.load7735, %187
  %gep7890 = getelementptr double, ptr %invariant.gep7889, i64 %index7727
  store <2 x double> %189, ptr %gep7890, align 8, !noalias !81
  %index.next7736 = add i64 %index7727, 2
  %190 = icmp eq i64 %index.next7736, %n.vec7723
  br i1 %190, label %middle.block7737, label %vector.body7726, !llvm.loop !91

middle.block7737:                                 ; preds = %vector.body7726
  br i1 %cmp.n7738, label %B166.loopexit.i, label %B288.if.i.preheader

B288.if.i.preheader:                              ; preds = %B288.if.preheader.i, %middle.block7737
  %.639.0659.i.ph = phi i64 [ %n.vec7723, %middle.block7737 ], [ 0, %B288.if.preheader.i ]
  br label %B288.if.i

B288.if.i:                                        ; preds = %B288.if.i.preheader, %B288.if.i
  %.639.0659.i = phi i64 [ %.708.i, %B288.if.i ], [ %.639.0659.i.ph, %B288.if.i.preheader ]
  %.157.i.i7270 = add nsw i64 %.639.0659.i, %.155.i.i7269
  %.159.i.i7271 = mul nsw i64 %.157.i.i7270, %arg.shape.0
  %gep7612 = getelementptr double, ptr %invariant.gep7611, i64 %.159.i.i7271
  %.191.i.i7272 = load double, ptr %gep7612, align 8, !noalias !87
  %.193.i.i7273 = fadd double %.191.i.i7272, 0.000000e+00
  %.253.i.i7274 = fmul double %173, %.193.i.i7273
  %.157.i.1.i7276 = add nsw i64 %.639.0659.i, %.155.i.1.i7275
  %.159.i.1.i7277 = mul nsw i64 %.157.i.1.i7276, %arg.shape.0
  %gep7614 = getelementptr double, ptr %invariant.gep7613, i64 %.159.i.1.i7277
  %.191.i.1.i7278 = load double, ptr %gep7614, align 8, !noalias !87
  %.193.i.1.i7279 = fadd double %.191.i.1.i7278, %.253.i.i7274
  %.253.i.1.i7280 = fmul double %.247.i.i7266, %.193.i.1.i7279
  %.157.i.2.i7282 = add nsw i64 %.639.0659.i, %.155.i.2.i7281
  %.159.i.2.i7283 = mul nsw i64 %.157.i.2.i7282, %arg.shape.0
  %gep7616 = getelementptr double, ptr %invariant.gep7615, i64 %.159.i.2.i7283
  %.191.i.2.i7284 = load double, ptr %gep7616, align 8, !noalias !87
  %.193.i.2.i7285 = fadd double %.191.i.2.i7284, %.253.i.1.i7280
  %.253.i.2.i7286 = fmul double %173, %.193.i.2.i7285
  %.157.i.3.i7288 = add nsw i64 %.639.0659.i, %.155.i.3.i7287
  %.159.i.3.i7289 = mul nsw i64 %.157.i.3.i7288, %arg.shape.0
  %gep7618 = getelementptr double, ptr %invariant.gep7617, i64 %.159.i.3.i7289
  %.191.i.3.i7290 = load double, ptr %gep7618, align 8, !noalias !87
  %.193.i.3.i7291 = fadd double %.191.i.3.i7290, %.253.i.2.i7286
  %.253.i.3.i7292 = fmul double %.247.i.i7266, %.193.i.3.i7291
  %.157.i.4.i7294 = add nsw i64 %.639.0659.i, %.155.i.4.i7293
  %.159.i.4.i7295 = mul nsw i64 %.157.i.4.i7294, %arg.shape.0
  %gep7620 = getelementptr double, ptr %invariant.gep7619, i64 %.159.i.4.i7295
  %.191.i.4.i7296 = load double, ptr %gep7620, align 8, !noalias !87
  %.193.i.4.i7297 = fadd double %.191.i.4.i7296, %.253.i.3.i7292
  %.253.i.4.i7298 = fmul double %173, %.193.i.4.i7297
  %.157.i.5.i7300 = add nsw i64 %.639.0659.i, %.155.i.5.i7299
  %.159.i.5.i7301 = mul nsw i64 %.157.i.5.i7300, %arg.shape.0
  %gep7622 = getelementptr double, ptr %invariant.gep7621, i64 %.159.i.5.i7301
  %.191.i.5.i7302 = load double, ptr %gep7622, align 8, !noalias !87
  %.193.i.5.i7303 = fadd double %.191.i.5.i7302, %.253.i.4.i7298
  %.253.i.5.i7304 = fmul double %.247.i.i7266, %.193.i.5.i7303
  %.157.i.6.i7306 = add nsw i64 %.639.0659.i, %.155.i.6.i7305
  %.159.i.6.i7307 = mul nsw i64 %.157.i.6.i7306, %arg.shape.0
  %gep7624 = getelementptr double, ptr %invariant.gep7623, i64 %.159.i.6.i7307
  %.191.i.6.i7308 = load double, ptr %gep7624, align 8, !noalias !87
  %.193.i.6.i7309 = fadd double %.191.i.6.i7308, %.253.i.5.i7304
  %.253.i.6.i7310 = fmul double %173, %.193.i.6.i7309
  %.708.i = add nsw i64 %.639.0659.i, 1
  %.271.i.i7311 = mul nsw i64 %.639.0659.i, %arg.shape.0
  %gep7626 = getelementptr double, ptr %invariant.gep7625, i64 %.271.i.i7311
  %.309.i.i7312 = load double, ptr %gep7626, align 8, !noalias !87
  %.313.i.i7313 = fadd double %.309.i.i7312, %.253.i.6.i7310
  %.768.i = add nsw i64 %.639.0659.i, %.767.i
  %.770.i = mul nsw i64 %.768.i, %arg.shape.0
  %gep7628 = getelementptr double, ptr %invariant.gep7627, i64 %.770.i
  store double %.313.i.i7313, ptr %gep7628, align 8, !noalias !81
  %exitcond.not.i7314 = icmp eq i64 %arg.shape.1, %.708.i
  br i1 %exitcond.not.i7314, label %B166.loopexit.i, label %B288.if.i, !llvm.loop !92

B530.if.i:                                        ; preds = %B382.i, %B678.i
  %.989.0665.i = phi i64 [ %.1058.i7315, %B678.i ], [ 0, %B382.i ]
  %.1058.i7315 = add nsw i64 %.989.0665.i, 1
  %191 = getelementptr double, ptr %285, i64 %.989.0665.i
  %.1140.i = load double, ptr %191, align 8, !noalias !81
  %.1141.i = fcmp ogt double %.1140.i, 5.000000e-01
  br i1 %.1141.i, label %B572.i, label %B678.i

B608.endif.i:                                     ; preds = %B80.i.i7319, %B46.i.i7316, %B608.i
  store double 0.000000e+00, ptr %191, align 8, !noalias !81
  br label %B678.i

B3112:                                            ; preds = %B110.loopexit.i, %B2612, %B3070
  br i1 %wanted.2.1.lcssa, label %B3120, label %B3172

B3120:                                            ; preds = %B3112
  %within.3.1.not = xor i1 %within.3.1.lcssa, true
  %brmerge7230 = select i1 %within.3.1.not, i1 true, i1 %.611
  %"$phi3156.7.2.2" = select i1 %brmerge7230, i64 0, i64 3
  br i1 %.274.i, label %B3172, label %B76.if.i

B152.i:                                           ; preds = %B76.if.i
  %.445.i = getelementptr double, ptr %287, i64 %.173.0633.i
  %.446.i = load double, ptr %.445.i, align 8, !noalias !93
  %.447.i = fcmp olt double %.446.i, 5.000000e-01
  br i1 %.447.i, label %B725.i, label %B190.i7323

B190.i7323:                                       ; preds = %B152.i
  %.478.i = getelementptr i64, ptr %arg.results.1.4, i64 %.327.i7321
  %.479.i7324 = load i64, ptr %.478.i, align 8, !noalias !93
  %.480.not.i = icmp eq i64 %.479.i7324, 0
  br i1 %.480.not.i, label %B226.i, label %B725.i

B226.i:                                           ; preds = %B190.i7323
  %.542.i = mul i64 %.327.i7321, %arg.results.3.5.1
  %192 = getelementptr i64, ptr %arg.results.3.4, i64 %.542.i
  %.546.i = getelementptr i8, ptr %192, i64 8
  %.547.i = load i64, ptr %.546.i, align 8, !noalias !93
  %.549.i7325 = add nsw i64 %.547.i, %"$phi3156.7.2.2"
  store i64 %.549.i7325, ptr %.546.i, align 8, !noalias !93
  %.655.i = getelementptr double, ptr %arg.lane.0.4, i64 %.173.0633.i
  %.656.i = load double, ptr %.655.i, align 8, !noalias !93
  %.710.i = getelementptr double, ptr %288, i64 %.173.0633.i
  %.711.i = load double, ptr %.710.i, align 8, !noalias !93
  %.765.i7326 = getelementptr double, ptr %289, i64 %.173.0633.i
  %.766.i7327 = load double, ptr %.765.i7326, align 8, !noalias !93
  %.787.i = icmp slt i64 %.382.i, %arg.times.5.0
  br i1 %.787.i, label %B400.i, label %B696.i

B400.i:                                           ; preds = %B226.i
  %.810.i7328 = icmp slt i64 %.382.i, 0
  %.811.i = select i1 %.810.i7328, i64 %arg.times.5.0, i64 0
  %193 = getelementptr double, ptr %arg.times.4, i64 %.382.i
  %.825.i = getelementptr double, ptr %193, i64 %.811.i
  %.826.i7329 = load double, ptr %.825.i, align 8, !noalias !93
  %.830.i = fcmp ugt double %.826.i7329, %.766.i7327
  br i1 %.830.i, label %B696.i, label %B424.preheader.i

B424.preheader.i:                                 ; preds = %B400.i
  %factor.op.mul.reass.i = mul i64 %factor.op.mul631.i, %.327.i7321
  %194 = getelementptr double, ptr %arg.results.0.4, i64 %factor.op.mul.reass.i
  %invariant.gep7629 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep7631 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep7633 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep7635 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep7637 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep7639 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep7641 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep7643 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  %invariant.gep7645 = getelementptr double, ptr %arg.arrays.0.4, i64 %.173.0633.i
  br label %B424.i

B424.i:                                           ; preds = %B672.i, %B424.preheader.i
  %done.2.3.i = phi i64 [ %.1255.i, %B672.i ], [ %.382.i, %B424.preheader.i ]
  br i1 %.917628.not.i, label %B624.i, label %B454.if.lr.ph.i

B454.if.lr.ph.i:                                  ; preds = %B424.i
  %.972.i = icmp slt i64 %done.2.3.i, 0
  %.973.i = select i1 %.972.i, i64 %arg.times.5.0, i64 0
  %195 = getelementptr double, ptr %arg.times.4, i64 %done.2.3.i
  %.987.i = getelementptr double, ptr %195, i64 %.973.i
  %.1213.i = select i1 %.972.i, i64 %arg.results.0.5.1, i64 0
  %.1214.i = add i64 %.1213.i, %done.2.3.i
  %.1243.i = mul i64 %.1214.i, %arg.results.0.5.2
  %196 = getelementptr double, ptr %194, i64 %.1243.i
  br label %B454.if.i

B482.i:                                           ; preds = %B454.if.i
  %.995.i = add nsw i64 %.861.0629.i, %.993.i
  %.997.i = mul nsw i64 %.995.i, %arg.shape.0
  %gep7646 = getelementptr double, ptr %invariant.gep7645, i64 %.997.i
  %.1029.i7380 = load double, ptr %gep7646, align 8, !noalias !93
  br label %B726.i

B624.i:                                           ; preds = %B726.i, %B424.i
  %exitcond635.not.i = icmp eq i64 %done.2.3.i, %290
  br i1 %exitcond635.not.i, label %B696.i, label %B672.i

B672.i:                                           ; preds = %B624.i
  %.1255.i = add i64 %done.2.3.i, 1
  %.1297.i7378 = icmp slt i64 %done.2.3.i, -1
  %.1298.i = select i1 %.1297.i7378, i64 %arg.times.5.0, i64 0
  %197 = getelementptr double, ptr %arg.times.4, i64 %.1255.i
  %.1312.i = getelementptr double, ptr %197, i64 %.1298.i
  %.1313.i7379 = load double, ptr %.1312.i, align 8, !noalias !93
  %.1317.i = fcmp ugt double %.1313.i7379, %.766.i7327
  br i1 %.1317.i, label %B696.i, label %B424.i

B696.i:                                           ; preds = %B672.i, %B624.i, %B400.i, %B226.i
  %done.3.2.i = phi i64 [ %.382.i, %B400.i ], [ %.382.i, %B226.i ], [ %arg.times.5.0, %B624.i ], [ %.1255.i, %B672.i ]
  store i64 %done.3.2.i, ptr %.381.i, align 8, !noalias !93
  br label %B725.i

B725.i:                                           ; preds = %B76.if.i, %B696.i, %B190.i7323, %B152.i
  %exitcond636.not.i = icmp eq i64 %.245.i, %arg.shape.0
  br i1 %exitcond636.not.i, label %B3172, label %B76.if.i

B726.i:                                           ; preds = %B38.if.i.i, %B482.i
  %.313.i.i7376.sink = phi double [ %.313.i.i7376, %B38.if.i.i ], [ %.1029.i7380, %B482.i ]
  %198 = getelementptr double, ptr %196, i64 %.861.0629.i
  store double %.313.i.i7376.sink, ptr %198, align 8, !noalias !93
  %exitcond.not.i7377 = icmp eq i64 %arg.shape.1, %.930.i
  br i1 %exitcond.not.i7377, label %B624.i, label %B454.if.i

B76.if.i:                                         ; preds = %B3120, %B725.i
  %.173.0633.i = phi i64 [ %.245.i, %B725.i ], [ 0, %B3120 ]
  %.245.i = add nsw i64 %.173.0633.i, 1
  %.326.i = getelementptr i64, ptr %arg.lane.1.4, i64 %.173.0633.i
  %.327.i7321 = load i64, ptr %.326.i, align 8, !noalias !93
  %.381.i = getelementptr i64, ptr %286, i64 %.173.0633.i
  %.382.i = load i64, ptr %.381.i, align 8, !noalias !93
  %.390.i7322 = icmp slt i64 %.327.i7321, 0
  br i1 %.390.i7322, label %B725.i, label %B152.i

B454.if.i:                                        ; preds = %B726.i, %B454.if.lr.ph.i
  %.861.0629.i = phi i64 [ 0, %B454.if.lr.ph.i ], [ %.930.i, %B726.i ]
  %.930.i = add nsw i64 %.861.0629.i, 1
  %.988.i = load double, ptr %.987.i, align 8, !noalias !93
  %.990.i = fcmp oeq double %.988.i, %.766.i7327
  br i1 %.990.i, label %B482.i, label %B38.if.i.i

B38.if.i.i:                                       ; preds = %B454.if.i
  %.1138.i = fsub double %.988.i, %.656.i
  %.1143.i = fdiv double %.1138.i, %.711.i
  %.247.i.i7331 = fsub double 1.000000e+00, %.1143.i
  %.157.i.i7333 = add nsw i64 %.861.0629.i, %.155.i.i7332
  %.159.i.i7334 = mul nsw i64 %.157.i.i7333, %arg.shape.0
  %gep7630 = getelementptr double, ptr %invariant.gep7629, i64 %.159.i.i7334
  %.191.i.i7335 = load double, ptr %gep7630, align 8, !noalias !96
  %.193.i.i7336 = fadd double %.191.i.i7335, 0.000000e+00
  %.253.i.i7337 = fmul double %.1143.i, %.193.i.i7336
  %.157.i.1.i7339 = add nsw i64 %.861.0629.i, %.155.i.1.i7338
  %.159.i.1.i7340 = mul nsw i64 %.157.i.1.i7339, %arg.shape.0
  %gep7632 = getelementptr double, ptr %invariant.gep7631, i64 %.159.i.1.i7340
  %.191.i.1.i7341 = load double, ptr %gep7632, align 8, !noalias !96
  %.193.i.1.i7342 = fadd double %.191.i.1.i7341, %.253.i.i7337
  %.253.i.1.i7343 = fmul double %.247.i.i7331, %.193.i.1.i7342
  %.157.i.2.i7345 = add nsw i64 %.861.0629.i, %.155.i.2.i7344
  %.159.i.2.i7346 = mul nsw i64 %.157.i.2.i7345, %arg.shape.0
  %gep7634 = getelementptr double, ptr %invariant.gep7633, i64 %.159.i.2.i7346
  %.191.i.2.i7347 = load double, ptr %gep7634, align 8, !noalias !96
  %.193.i.2.i7348 = fadd double %.191.i.2.i7347, %.253.i.1.i7343
  %.253.i.2.i7349 = fmul double %.1143.i, %.193.i.2.i7348
  %.157.i.3.i7351 = add nsw i64 %.861.0629.i, %.155.i.3.i7350
  %.159.i.3.i7352 = mul nsw i64 %.157.i.3.i7351, %arg.shape.0
  %gep7636 = getelementptr double, ptr %invariant.gep7635, i64 %.159.i.3.i7352
  %.191.i.3.i7353 = load double, ptr %gep7636, align 8, !noalias !96
  %.193.i.3.i7354 = fadd double %.191.i.3.i7353, %.253.i.2.i7349
  %.253.i.3.i7355 = fmul double %.247.i.i7331, %.193.i.3.i7354
  %.157.i.4.i7357 = add nsw i64 %.861.0629.i, %.155.i.4.i7356
  %.159.i.4.i7358 = mul nsw i64 %.157.i.4.i7357, %arg.shape.0
  %gep7638 = getelementptr double, ptr %invariant.gep7637, i64 %.159.i.4.i7358
  %.191.i.4.i7359 = load double, ptr %gep7638, align 8, !noalias !96
  %.193.i.4.i7360 = fadd double %.191.i.4.i7359, %.253.i.3.i7355
  %.253.i.4.i7361 = fmul double %.1143.i, %.193.i.4.i7360
  %.157.i.5.i7363 = add nsw i64 %.861.0629.i, %.155.i.5.i7362
  %.159.i.5.i7364 = mul nsw i64 %.157.i.5.i7363, %arg.shape.0
  %gep7640 = getelementptr double, ptr %invariant.gep7639, i64 %.159.i.5.i7364
  %.191.i.5.i7365 = load double, ptr %gep7640, align 8, !noalias !96
  %.193.i.5.i7366 = fadd double %.191.i.5.i7365, %.253.i.4.i7361
  %.253.i.5.i7367 = fmul double %.247.i.i7331, %.193.i.5.i7366
  %.157.i.6.i7369 = add nsw i64 %.861.0629.i, %.155.i.6.i7368
  %.159.i.6.i7370 = mul nsw i64 %.157.i.6.i7369, %arg.shape.0
  %gep7642 = getelementptr double, ptr %invariant.gep7641, i64 %.159.i.6.i7370
  %.191.i.6.i7371 = load double, ptr %gep7642, align 8, !noalias !96
  %.193.i.6.i7372 = fadd double %.191.i.6.i7371, %.253.i.5.i7367
  %.253.i.6.i7373 = fmul double %.1143.i, %.193.i.6.i7372
  %.271.i.i7374 = mul nsw i64 %.861.0629.i, %arg.shape.0
  %gep7644 = getelementptr double, ptr %invariant.gep7643, i64 %.271.i.i7374
  %.309.i.i7375 = load double, ptr %gep7644, align 8, !noalias !96
  %.313.i.i7376 = fadd double %.309.i.i7375, %.253.i.6.i7373
  br label %B726.i

B3172:                                            ; preds = %B725.i, %B3120, %B3112
  %.4759 = load i64, ptr %.4758, align 8
  %.4804 = inttoptr i64 %.4759 to ptr
  tail call void %.4804(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %beyond.2.1.not = xor i1 %beyond.2.1, true
  %brmerge7670 = or i1 %.274.i, %beyond.2.1.not
  br i1 %brmerge7670, label %B3280, label %B46.if.i

B98.i1553:                                        ; preds = %B46.if.i
  %.306.i1599 = getelementptr double, ptr %292, i64 %.97.i1423.07649
  %.307.i1600 = load double, ptr %.306.i1599, align 8, !noalias !100
  %.308.i1601 = fcmp ogt double %.307.i1600, 5.000000e-01
  br i1 %.308.i1601, label %B136.i, label %B506.i

B136.i:                                           ; preds = %B98.i1553
  %.363.i1649 = getelementptr double, ptr %arg.lane.0.4, i64 %.97.i1423.07649
  %.364.i1650 = load double, ptr %.363.i1649, align 8, !noalias !100
  %.418.i1698 = getelementptr double, ptr %293, i64 %.97.i1423.07649
  %.419.i1699 = load double, ptr %.418.i1698, align 8, !noalias !100
  %.420.i1700 = fsub double %.364.i1650, %.419.i1699
  %.450.i1725 = load double, ptr %.449.i1724, align 8, !noalias !100
  %.480.i1750 = load double, ptr %arg.times.4, align 8, !noalias !100
  %.481.i1751 = fsub double %.450.i1725, %.480.i1750
  %.482.i1752 = fmul double %.481.i1751, 0x3E7AD7F29ABCAF48
  %.483.i1753 = fcmp olt double %.420.i1700, %.482.i1752
  br i1 %.483.i1753, label %B256.i, label %B294.i

B256.i:                                           ; preds = %B136.i
  %199 = getelementptr i64, ptr %295, i64 %.97.i1423.07649
  %.539.i2150 = load i64, ptr %199, align 8, !noalias !100
  %.540.i2151 = add nsw i64 %.539.i2150, 1
  br label %B294.i

B294.i:                                           ; preds = %B136.i, %B256.i
  %"$phi294.1.2.i.2" = phi i64 [ %.540.i2151, %B256.i ], [ 0, %B136.i ]
  %200 = getelementptr i64, ptr %296, i64 %.97.i1423.07649
  store i64 %"$phi294.1.2.i.2", ptr %200, align 8, !noalias !100
  %.660.i1847 = load double, ptr %.363.i1649, align 8, !noalias !100
  store double %.660.i1847, ptr %.418.i1698, align 8, !noalias !100
  %.769.i1915 = getelementptr double, ptr %297, i64 %.97.i1423.07649
  store double 1.000000e+00, ptr %.769.i1915, align 8, !noalias !100
  store i64 1, ptr %.794, align 8, !noalias !100
  %.855.i1967 = load i64, ptr %200, align 8, !noalias !100
  %.856.i1968 = icmp sgt i64 %.855.i1967, 1000
  br i1 %.856.i1968, label %B460.i, label %B506.i

B460.i:                                           ; preds = %B294.i
  %201 = getelementptr i64, ptr %arg.lane.1.4, i64 %.97.i1423.07649
  %.84.i.i2041 = load i64, ptr %201, align 8, !noalias !104
  %.89.i.i2044 = icmp sgt i64 %.84.i.i2041, -1
  br i1 %.89.i.i2044, label %B46.i.i2050, label %B506.i

B46.i.i2050:                                      ; preds = %B460.i
  %.120.i.i2070 = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i.i2041
  %.121.i.i2071 = load i64, ptr %.120.i.i2070, align 8, !noalias !104
  %.122.i.i2072 = icmp eq i64 %.121.i.i2071, 0
  br i1 %.122.i.i2072, label %B80.i.i2077, label %B506.i

B80.i.i2077:                                      ; preds = %B46.i.i2050
  store i64 6, ptr %.120.i.i2070, align 8, !noalias !104
  br label %B506.i

B506.i:                                           ; preds = %B80.i.i2077, %B460.i, %B46.i.i2050, %B294.i, %B98.i1553, %B46.if.i
  %.155.i1489 = icmp sgt i64 %.100.i1424.07648, 1
  br i1 %.155.i1489, label %B46.if.i, label %B3280

B46.if.i:                                         ; preds = %B3172, %B506.i
  %.97.i1423.07649 = phi i64 [ %.168.i2160, %B506.i ], [ 0, %B3172 ]
  %.100.i1424.07648 = phi i64 [ %.164.i2157, %B506.i ], [ %storemerge, %B3172 ]
  %.164.i2157 = add nsw i64 %.100.i1424.07648, -1
  %.168.i2160 = add nsw i64 %.97.i1423.07649, 1
  %.249.i1550 = getelementptr double, ptr %291, i64 %.97.i1423.07649
  %.250.i1551 = load double, ptr %.249.i1550, align 8, !noalias !100
  %.251.i1552 = fcmp oeq double %.250.i1551, 2.000000e+00
  br i1 %.251.i1552, label %B98.i1553, label %B506.i

B3280:                                            ; preds = %B506.i, %B3172
  br i1 %brmerge7669, label %B3330, label %B110.if.i

B46.i.i7381:                                      ; preds = %B110.if.i
  %.135.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i.i
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !107
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i7388, label %B358.i7382

B80.i.i7388:                                      ; preds = %B46.i.i7381
  %.196.i.i = getelementptr double, ptr %298, i64 %.352.01856.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !107
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B358.i7382, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i7388
  %.264.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.352.01856.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !107
  %.321.i.i = getelementptr double, ptr %299, i64 %.352.01856.i
  %.322.i.i = load double, ptr %.321.i.i, align 8, !noalias !107
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i
  %brmerge.i7389 = select i1 %.325.i.i, i1 true, i1 %.7511852.not.i
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01858.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01858.i
  br i1 %brmerge.i7389, label %B358.i7382, label %B300.if.lr.ph.i

B300.if.lr.ph.i:                                  ; preds = %B122.i.i
  %.650.i = getelementptr i64, ptr %300, i64 %.352.01856.i
  %.651.i7390 = load i64, ptr %.650.i, align 8, !noalias !112
  %.652.i = add nsw i64 %.651.i7390, 1
  %202 = getelementptr i64, ptr %arg.runs.2.4, i64 %.99.i.i
  %.596.i = load i64, ptr %202, align 8, !noalias !112
  %.822.i7392 = icmp slt i64 %.596.i, 0
  %.823.i7393 = select i1 %.822.i7392, i64 %arg.schedule.3.5.0, i64 0
  %.824.i = add i64 %.823.i7393, %.596.i
  %.825.i7394 = icmp slt i64 %.651.i7390, -1
  %.826.i7395 = select i1 %.825.i7394, i64 %arg.schedule.3.5.1, i64 0
  %.827.i7396 = add i64 %.652.i, %.826.i7395
  %.854.i = mul i64 %.852.i, %.824.i
  %.856.i = mul i64 %.827.i7396, %arg.schedule.3.5.2
  %203 = getelementptr double, ptr %arg.schedule.3.4, i64 %.854.i
  %204 = getelementptr double, ptr %203, i64 %.856.i
  br label %B300.if.i

B358.i7382:                                       ; preds = %B300.if.i, %B110.if.i, %B122.i.i, %B80.i.i7388, %B46.i.i7381
  %some.3.2.i = phi i1 [ %some.2.01858.i, %B80.i.i7388 ], [ %some.2.01858.mux.i, %B122.i.i ], [ %some.2.01858.i, %B46.i.i7381 ], [ %some.2.01858.i, %B110.if.i ], [ true, %B300.if.i ]
  %exitcond1870.not.i = icmp eq i64 %arg.shape.0, %.423.i
  br i1 %exitcond1870.not.i, label %B360.i, label %B110.if.i

B360.i:                                           ; preds = %B358.i7382
  br i1 %some.3.2.i, label %B368.i, label %B3330

B368.i:                                           ; preds = %B360.i
  %.1018.i = load i64, ptr %.1017.i, align 8, !noalias !112
  %.1130.i = inttoptr i64 %.1018.i to ptr
  tail call void %.1130.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !112
  %.1161.i = load i64, ptr %.1160.i, align 8, !noalias !112
  %.1277.i = inttoptr i64 %.1161.i to ptr
  tail call void %.1277.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1276.i), !noalias !112
  br label %B600.if.i

B46.i82.i:                                        ; preds = %B600.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !113
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B980.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %298, i64 %.1303.01865.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !113
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B980.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1303.01865.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !113
  %.321.i223.i = getelementptr double, ptr %299, i64 %.1303.01865.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !113
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B980.i, label %B640.i

B640.i:                                           ; preds = %B122.i147.i
  %.1557.i = getelementptr i64, ptr %301, i64 %.1303.01865.i
  %.1558.i = load i64, ptr %.1557.i, align 8, !noalias !112
  %.1569.i = icmp sgt i64 %.1558.i, 0
  br i1 %.1569.i, label %B716.i, label %B770.i

B716.i:                                           ; preds = %B640.i
  %205 = getelementptr double, ptr %arg.times.4, i64 %.1558.i
  %.1604.i = getelementptr i8, ptr %205, i64 -8
  %.1605.i = load double, ptr %.1604.i, align 8, !noalias !112
  %.1661.i = fcmp oeq double %.1605.i, %.265.i185.i
  br label %B770.i

B770.i:                                           ; preds = %B716.i, %B640.i
  %"$phi770.1.2.1.i" = phi i1 [ %.1661.i, %B716.i ], [ false, %B640.i ]
  br i1 %.17571859.not.i, label %B980.i, label %B802.if.lr.ph.i

B802.if.lr.ph.i:                                  ; preds = %B770.i
  %.1887.i = add nsw i64 %.1558.i, -1
  %.1926.i = select i1 %.1569.i, i64 0, i64 %arg.results.0.5.1
  %.1927.i = add i64 %.1887.i, %.1926.i
  %.1954.i7387 = mul i64 %.1952.i, %.99.i78.i
  %.1956.i = mul i64 %.1927.i, %arg.results.0.5.2
  %206 = getelementptr double, ptr %arg.results.0.4, i64 %.1954.i7387
  %207 = getelementptr double, ptr %206, i64 %.1956.i
  %invariant.gep7650 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1303.01865.i
  %invariant.gep7652 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1303.01865.i
  br label %B802.if.i

B898.i:                                           ; preds = %B802.if.i
  %208 = getelementptr double, ptr %207, i64 %.1701.01860.i
  store double %.1835.i, ptr %208, align 8, !noalias !112
  br label %B920.i

B920.i:                                           ; preds = %B802.if.i, %B898.i
  %exitcond1871.not.i = icmp eq i64 %arg.shape.1, %.1770.i
  br i1 %exitcond1871.not.i, label %B922.loopexit.i, label %B802.if.i

B922.loopexit.i:                                  ; preds = %B920.i
  %209 = fcmp une double %.1842.i, 0.000000e+00
  br i1 %209, label %B934.i, label %B980.i

B934.i:                                           ; preds = %B922.loopexit.i
  %.84.i516.i = load i64, ptr %215, align 8, !noalias !116
  %.89.i518.i = icmp sgt i64 %.84.i516.i, -1
  br i1 %.89.i518.i, label %B46.i521.i, label %B980.i

B46.i521.i:                                       ; preds = %B934.i
  %.120.i539.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i516.i
  %.121.i540.i = load i64, ptr %.120.i539.i, align 8, !noalias !116
  %.122.i541.i = icmp eq i64 %.121.i540.i, 0
  br i1 %.122.i541.i, label %B80.i545.i, label %B980.i

B80.i545.i:                                       ; preds = %B46.i521.i
  store i64 3, ptr %.120.i539.i, align 8, !noalias !116
  br label %B980.i

B980.i:                                           ; preds = %B600.if.i, %B80.i545.i, %B46.i521.i, %B934.i, %B922.loopexit.i, %B770.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %exitcond1872.not.i = icmp eq i64 %arg.shape.0, %.1372.i
  br i1 %exitcond1872.not.i, label %B982.i, label %B600.if.i

B982.i:                                           ; preds = %B980.i
  br i1 %.2041.not.i, label %B3330, label %B986.i

B986.i:                                           ; preds = %B982.i
  %.2074.i = load i64, ptr %.2073.i, align 8, !noalias !112
  %.2188.i = inttoptr i64 %.2074.i to ptr
  tail call void %.2188.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !112
  br label %B1106.if.i

B46.i315.i:                                       ; preds = %B1106.if.i
  %.135.i335.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i311.i
  %.136.i336.i = load i64, ptr %.135.i335.i, align 8, !noalias !119
  %.141.i339.not.i = icmp eq i64 %.136.i336.i, 0
  br i1 %.141.i339.not.i, label %B80.i340.i, label %B1228.i

B80.i340.i:                                       ; preds = %B46.i315.i
  %.196.i377.i = getelementptr double, ptr %298, i64 %.2224.01868.i
  %.197.i378.i = load double, ptr %.196.i377.i, align 8, !noalias !119
  %.198.i379.i = fcmp olt double %.197.i378.i, 5.000000e-01
  br i1 %.198.i379.i, label %B1228.i, label %B122.i380.i

B122.i380.i:                                      ; preds = %B80.i340.i
  %.264.i417.i = getelementptr double, ptr %arg.lane.0.4, i64 %.2224.01868.i
  %.265.i418.i = load double, ptr %.264.i417.i, align 8, !noalias !119
  %.321.i456.i = getelementptr double, ptr %299, i64 %.2224.01868.i
  %.322.i457.i = load double, ptr %.321.i456.i, align 8, !noalias !119
  %.325.i459.i = fcmp une double %.265.i418.i, %.322.i457.i
  br i1 %.325.i459.i, label %B1228.i, label %B1146.i

B1146.i:                                          ; preds = %B122.i380.i
  %210 = getelementptr double, ptr %arg.arrays.4.4, i64 %.2224.01868.i
  %.2400.i = load double, ptr %210, align 8, !noalias !112
  %.2402.i = fcmp olt double %.2400.i, -1.000000e-09
  br i1 %.2402.i, label %B80.i672.i, label %B1228.i

B80.i672.i:                                       ; preds = %B1146.i
  store i64 4, ptr %.135.i335.i, align 8, !noalias !122
  br label %B1228.i

B1228.i:                                          ; preds = %B1106.if.i, %B80.i672.i, %B1146.i, %B122.i380.i, %B80.i340.i, %B46.i315.i
  %exitcond7680.not = icmp eq i64 %arg.shape.0, %.2293.i
  br i1 %exitcond7680.not, label %B3330, label %B1106.if.i

B110.if.i:                                        ; preds = %B3280, %B358.i7382
  %some.2.01858.i = phi i1 [ %some.3.2.i, %B358.i7382 ], [ false, %B3280 ]
  %.352.01856.i = phi i64 [ %.423.i, %B358.i7382 ], [ 0, %B3280 ]
  %.423.i = add nsw i64 %.352.01856.i, 1
  %211 = getelementptr i64, ptr %arg.lane.1.4, i64 %.352.01856.i
  %.99.i.i = load i64, ptr %211, align 8, !noalias !107
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B358.i7382, label %B46.i.i7381

B300.if.i:                                        ; preds = %B300.if.i, %B300.if.lr.ph.i
  %.692.01853.i = phi i64 [ 0, %B300.if.lr.ph.i ], [ %.764.i7397, %B300.if.i ]
  %.764.i7397 = add nsw i64 %.692.01853.i, 1
  %212 = getelementptr double, ptr %204, i64 %.692.01853.i
  %.861.i = load double, ptr %212, align 8, !noalias !112
  %213 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.692.01853.i
  %.891.i = load i64, ptr %213, align 8, !noalias !112
  %.893.i = mul nsw i64 %.891.i, %arg.shape.0
  %.895.i7398 = add nsw i64 %.893.i, %.352.01856.i
  %.909.i = icmp slt i64 %.895.i7398, 0
  %.910.i = select i1 %.909.i, i64 %arg.arrays.1.5.0, i64 0
  %214 = getelementptr double, ptr %arg.arrays.1.4, i64 %.895.i7398
  %.924.i = getelementptr double, ptr %214, i64 %.910.i
  store double %.861.i, ptr %.924.i, align 8, !noalias !112
  %exitcond.not.i7399 = icmp eq i64 %arg.schedule.2.5.0, %.764.i7397
  br i1 %exitcond.not.i7399, label %B358.i7382, label %B300.if.i

B600.if.i:                                        ; preds = %B980.i, %B368.i
  %.1303.01865.i = phi i64 [ 0, %B368.i ], [ %.1372.i, %B980.i ]
  %.1372.i = add nsw i64 %.1303.01865.i, 1
  %215 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1303.01865.i
  %.99.i78.i = load i64, ptr %215, align 8, !noalias !113
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B980.i, label %B46.i82.i

B802.if.i:                                        ; preds = %B920.i, %B802.if.lr.ph.i
  %trouble.2.11862.i = phi double [ 0.000000e+00, %B802.if.lr.ph.i ], [ %.1842.i, %B920.i ]
  %.1701.01860.i = phi i64 [ 0, %B802.if.lr.ph.i ], [ %.1770.i, %B920.i ]
  %.1770.i = add nsw i64 %.1701.01860.i, 1
  %.1801.i = add nsw i64 %.1701.01860.i, %.1231.i7384
  %.1803.i = mul nsw i64 %.1801.i, %arg.shape.0
  %gep7651 = getelementptr double, ptr %invariant.gep7650, i64 %.1803.i
  %.1835.i = load double, ptr %gep7651, align 8, !noalias !112
  %.1840.i = fmul double %.1835.i, 0.000000e+00
  %.1842.i = fadd double %trouble.2.11862.i, %.1840.i
  %.1850.i = mul nsw i64 %.1701.01860.i, %arg.shape.0
  %gep7653 = getelementptr double, ptr %invariant.gep7652, i64 %.1850.i
  store double %.1835.i, ptr %gep7653, align 8, !noalias !112
  br i1 %"$phi770.1.2.1.i", label %B898.i, label %B920.i

B1106.if.i:                                       ; preds = %B1228.i, %B986.i
  %.2224.01868.i = phi i64 [ 0, %B986.i ], [ %.2293.i, %B1228.i ]
  %.2293.i = add nsw i64 %.2224.01868.i, 1
  %216 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2224.01868.i
  %.99.i311.i = load i64, ptr %216, align 8, !noalias !119
  %.104.i314.i = icmp slt i64 %.99.i311.i, 0
  br i1 %.104.i314.i, label %B1228.i, label %B46.i315.i

B3330:                                            ; preds = %B1228.i, %B3280, %B360.i, %B982.i
  br i1 %.274.i, label %B4080, label %B3362.if

B3408:                                            ; preds = %B3362.if
  br i1 %.163.i22937657.not, label %B102.i, label %B46.if.i2629.preheader

B46.if.i2629.preheader:                           ; preds = %B3408
  %invariant.gep7897 = getelementptr double, ptr %arg.arrays.0.4, i64 %.5002.07661
  br label %B46.if.i2629

B102.i:                                           ; preds = %B46.if.i2629, %B3408
  %.360.i2354 = getelementptr double, ptr %arg.lane.0.4, i64 %.5002.07661
  store double 0.000000e+00, ptr %.360.i2354, align 8, !noalias !125
  %.415.i2402 = getelementptr double, ptr %323, i64 %.5002.07661
  store double 5.000000e-01, ptr %.415.i2402, align 8, !noalias !125
  %.470.i2450 = getelementptr double, ptr %324, i64 %.5002.07661
  store double 1.000000e+00, ptr %.470.i2450, align 8, !noalias !125
  %.529.i2498 = getelementptr double, ptr %325, i64 %.5002.07661
  store double 0.000000e+00, ptr %.529.i2498, align 8, !noalias !125
  %.586.i2546 = getelementptr double, ptr %326, i64 %.5002.07661
  store double 0.000000e+00, ptr %.586.i2546, align 8, !noalias !125
  br label %B4107

B46.if.i2629:                                     ; preds = %B46.if.i2629.preheader, %B46.if.i2629
  %.105.i2236.07659 = phi i64 [ %.176.i2637, %B46.if.i2629 ], [ 0, %B46.if.i2629.preheader ]
  %.176.i2637 = add nsw i64 %.105.i2236.07659, 1
  %217 = getelementptr double, ptr %arg.runs.0.4, i64 %.105.i2236.07659
  %.255.i2599 = load double, ptr %217, align 8, !noalias !125
  %.257.i2601 = mul nsw i64 %.105.i2236.07659, %arg.shape.0
  %gep7898 = getelementptr double, ptr %invariant.gep7897, i64 %.257.i2601
  store double %.255.i2599, ptr %gep7898, align 8, !noalias !125
  %exitcond7682.not = icmp eq i64 %arg.shape.1, %.176.i2637
  br i1 %exitcond7682.not, label %B102.i, label %B46.if.i2629

B3448:                                            ; preds = %B3362.if
  %.5276 = mul i64 %.5154, %arg.results.3.5.1
  %.5280 = getelementptr i64, ptr %arg.results.3.4, i64 %.5276
  %.5281 = load i64, ptr %.5280, align 8
  %.5335 = getelementptr i8, ptr %.5280, i64 24
  %.5336 = load i64, ptr %.5335, align 8
  %.5337 = add nsw i64 %.5336, %.5281
  %.5339.not = icmp slt i64 %.5337, %arg.most
  br i1 %.5339.not, label %B3564, label %B3518

B3518:                                            ; preds = %B3448
  %218 = getelementptr i64, ptr %arg.lane.1.4, i64 %.5002.07661
  %.84.i2719 = load i64, ptr %218, align 8, !noalias !129
  %.89.i2722 = icmp sgt i64 %.84.i2719, -1
  br i1 %.89.i2722, label %B46.i2727, label %B3564

B46.i2727:                                        ; preds = %B3518
  %.120.i2752 = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i2719
  %.121.i2753 = load i64, ptr %.120.i2752, align 8, !noalias !129
  %.122.i2754 = icmp eq i64 %.121.i2753, 0
  br i1 %.122.i2754, label %B80.i2759, label %B3564

B80.i2759:                                        ; preds = %B46.i2727
  store i64 5, ptr %.120.i2752, align 8, !noalias !129
  br label %B3564

B3564:                                            ; preds = %B80.i2759, %B3518, %B46.i2727, %B3448
  %.5429 = getelementptr double, ptr %302, i64 %.5002.07661
  %.5430 = load double, ptr %.5429, align 8
  %.5431 = fcmp ogt double %.5430, 5.000000e-01
  br i1 %.5431, label %B3602, label %B3708

B3602:                                            ; preds = %B3564
  %.5486 = getelementptr double, ptr %arg.lane.0.4, i64 %.5002.07661
  %.5487 = load double, ptr %.5486, align 8
  %.5541 = getelementptr double, ptr %303, i64 %.5002.07661
  %.5542 = load double, ptr %.5541, align 8
  %.5543 = fcmp oeq double %.5487, %.5542
  br i1 %.5543, label %B3666, label %B3708

B3666:                                            ; preds = %B3602
  %.246.i3026 = load i64, ptr %.5153, align 8, !noalias !132
  %.264.i3038 = icmp slt i64 %.246.i3026, 0
  %.265.i3039 = select i1 %.264.i3038, i64 %arg.runs.2.5.0, i64 0
  %219 = getelementptr i64, ptr %arg.runs.2.4, i64 %.246.i3026
  %.279.i3053 = getelementptr i64, ptr %219, i64 %.265.i3039
  %.280.i3054 = load i64, ptr %.279.i3053, align 8, !noalias !132
  %.337.i3102 = getelementptr i64, ptr %304, i64 %.5002.07661
  %.338.i3103 = load i64, ptr %.337.i3102, align 8, !noalias !132
  %.339.i3104 = add nsw i64 %.338.i3103, 1
  store i64 %.339.i3104, ptr %.337.i3102, align 8, !noalias !132
  %.460.i3209 = icmp slt i64 %.280.i3054, 0
  %.461.i3210 = select i1 %.460.i3209, i64 %arg.schedule.1.5.0, i64 0
  %220 = getelementptr i64, ptr %arg.schedule.1.4, i64 %.280.i3054
  %.475.i3224 = getelementptr i64, ptr %220, i64 %.461.i3210
  %.476.i3225 = load i64, ptr %.475.i3224, align 8, !noalias !132
  %.477.i3226 = icmp eq i64 %.339.i3104, %.476.i3225
  br i1 %.477.i3226, label %B186.i, label %B244.i

B186.i:                                           ; preds = %B3666
  %.516.i3581 = select i1 %.264.i3038, i64 %arg.results.1.5.0, i64 0
  %221 = getelementptr i64, ptr %arg.results.1.4, i64 %.246.i3026
  %.530.i3595 = getelementptr i64, ptr %221, i64 %.516.i3581
  %.531.i3596 = load i64, ptr %.530.i3595, align 8, !noalias !132
  %.532.i3597 = icmp eq i64 %.531.i3596, 0
  br i1 %.532.i3597, label %B220.i, label %B3708

B220.i:                                           ; preds = %B186.i
  store i64 1, ptr %.530.i3595, align 8, !noalias !132
  br label %B3708

B244.i:                                           ; preds = %B3666
  %.659.i3298 = select i1 %.460.i3209, i64 %arg.schedule.0.5.0, i64 0
  %.660.i3299 = add i64 %.659.i3298, %.280.i3054
  %.661.i3300 = icmp slt i64 %.338.i3103, -1
  %.662.i3301 = select i1 %.661.i3300, i64 %arg.schedule.0.5.1, i64 0
  %.680.i3318 = mul i64 %.660.i3299, %arg.schedule.0.5.1
  %222 = getelementptr double, ptr %arg.schedule.0.4, i64 %.680.i3318
  %223 = getelementptr double, ptr %222, i64 %.339.i3104
  %.684.i3321 = getelementptr double, ptr %223, i64 %.662.i3301
  %.685.i3322 = load double, ptr %.684.i3321, align 8, !noalias !132
  store double %.685.i3322, ptr %.5541, align 8, !noalias !132
  %.797.i3407 = load i64, ptr %.337.i3102, align 8, !noalias !132
  %.822.i3424 = select i1 %.460.i3209, i64 %arg.schedule.4.5.0, i64 0
  %.823.i3425 = add i64 %.822.i3424, %.280.i3054
  %.824.i3426 = icmp slt i64 %.797.i3407, 0
  %.825.i3427 = select i1 %.824.i3426, i64 %arg.schedule.4.5.1, i64 0
  %.843.i3444 = mul i64 %.823.i3425, %arg.schedule.4.5.1
  %224 = getelementptr i64, ptr %arg.schedule.4.4, i64 %.843.i3444
  %225 = getelementptr i64, ptr %224, i64 %.797.i3407
  %.847.i3448 = getelementptr i64, ptr %225, i64 %.825.i3427
  %.848.i3449 = load i64, ptr %.847.i3448, align 8, !noalias !132
  %.851.i = icmp eq i64 %.848.i3449, 0
  br i1 %.851.i, label %B364.i, label %B412.i

B364.i:                                           ; preds = %B244.i
  %.906.i3540 = getelementptr double, ptr %305, i64 %.5002.07661
  store double 1.000000e+00, ptr %.906.i3540, align 8, !noalias !132
  br label %B456.i.sink.split

B412.i:                                           ; preds = %B244.i
  %.974.i3458 = load i64, ptr %.794, align 8, !noalias !132
  %.975.i3459 = icmp eq i64 %.974.i3458, 0
  br i1 %.975.i3459, label %B456.i.sink.split, label %B456.i

B456.i.sink.split:                                ; preds = %B412.i, %B364.i
  %.sink = phi i64 [ 1, %B364.i ], [ 2, %B412.i ]
  store i64 %.sink, ptr %.794, align 8, !noalias !132
  br label %B456.i

B456.i:                                           ; preds = %B456.i.sink.split, %B412.i
  br i1 %.1103.i7654.not, label %B3708, label %B512.if.i.lr.ph

B512.if.i.lr.ph:                                  ; preds = %B456.i
  %.1227.i = select i1 %.460.i3209, i64 %arg.schedule.3.5.0, i64 0
  %.1228.i = add i64 %.1227.i, %.280.i3054
  %.1258.i = mul i64 %.1256.i, %.1228.i
  %226 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1258.i
  br label %B512.if.i

B512.if.i:                                        ; preds = %B512.if.i.lr.ph, %B512.if.i
  %.1045.i2960.07656 = phi i64 [ 0, %B512.if.i.lr.ph ], [ %.1116.i, %B512.if.i ]
  %.1116.i = add nsw i64 %.1045.i2960.07656, 1
  %.1195.i = load i64, ptr %.337.i3102, align 8, !noalias !132
  %.1229.i = icmp slt i64 %.1195.i, 0
  %.1230.i = select i1 %.1229.i, i64 %arg.schedule.3.5.1, i64 0
  %.1231.i = add i64 %.1230.i, %.1195.i
  %.1260.i = mul i64 %.1231.i, %arg.schedule.3.5.2
  %227 = getelementptr double, ptr %226, i64 %.1260.i
  %228 = getelementptr double, ptr %227, i64 %.1045.i2960.07656
  %.1265.i = load double, ptr %228, align 8, !noalias !132
  %229 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1045.i2960.07656
  %.1295.i = load i64, ptr %229, align 8, !noalias !132
  %.1297.i = mul nsw i64 %.1295.i, %arg.shape.0
  %.1299.i = add nsw i64 %.1297.i, %.5002.07661
  %.1313.i = icmp slt i64 %.1299.i, 0
  %.1314.i = select i1 %.1313.i, i64 %arg.arrays.1.5.0, i64 0
  %230 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1299.i
  %.1328.i = getelementptr double, ptr %230, i64 %.1314.i
  store double %.1265.i, ptr %.1328.i, align 8, !noalias !132
  %exitcond7681.not = icmp eq i64 %arg.schedule.2.5.0, %.1116.i
  br i1 %exitcond7681.not, label %B3708, label %B512.if.i

B3708:                                            ; preds = %B512.if.i, %B456.i, %B220.i, %B186.i, %B3602, %B3564
  %.5649 = getelementptr i64, ptr %arg.results.1.4, i64 %.5154
  %.5650 = load i64, ptr %.5649, align 8
  %.5651.not = icmp eq i64 %.5650, 0
  br i1 %.5651.not, label %B3866, label %B3742

B3742:                                            ; preds = %B3708
  %.5711 = getelementptr i64, ptr %306, i64 %.5002.07661
  %.5712 = load i64, ptr %.5711, align 8
  %.5742 = getelementptr i64, ptr %arg.results.2.4, i64 %.5154
  store i64 %.5712, ptr %.5742, align 8
  store i64 -1, ptr %.5153, align 8
  %.314.i7400 = load i64, ptr %arg.lane.2.4, align 8, !noalias !136
  %.374.i7402 = load i64, ptr %.373.i7401, align 8, !noalias !136
  %.375.i7403 = icmp slt i64 %.314.i7400, %.374.i7402
  br i1 %.375.i7403, label %B130.i7523, label %B316.i7404

B130.i7523:                                       ; preds = %B3742
  %.385.i7524 = add nsw i64 %.314.i7400, 1
  store i64 %.385.i7524, ptr %arg.lane.2.4, align 8, !noalias !136
  store i64 1, ptr %.794, align 8, !noalias !136
  store i64 %.314.i7400, ptr %.5153, align 8, !noalias !136
  %.557.i7529 = getelementptr i64, ptr %307, i64 %.5002.07661
  store i64 0, ptr %.557.i7529, align 8, !noalias !136
  store i64 1, ptr %.5711, align 8, !noalias !136
  br i1 %.6961437.not.i7532, label %B316.i7404, label %B272.if.lr.ph.i7533

B272.if.lr.ph.i7533:                              ; preds = %B130.i7523
  %.757.i7534 = icmp slt i64 %.314.i7400, 0
  %.758.i7535 = select i1 %.757.i7534, i64 %arg.runs.0.5.0, i64 0
  %.759.i7536 = add i64 %.758.i7535, %.314.i7400
  %.779.i7537 = mul i64 %.759.i7536, %arg.runs.0.5.1
  %231 = getelementptr double, ptr %arg.runs.0.4, i64 %.779.i7537
  %.822.i7538 = select i1 %.757.i7534, i64 %arg.results.0.5.0, i64 0
  %.823.i7539 = add i64 %.822.i7538, %.314.i7400
  %.853.i7541 = mul i64 %.851.i7540, %.823.i7539
  %232 = getelementptr double, ptr %arg.results.0.4, i64 %.853.i7541
  br i1 %min.iters.check7692, label %B272.if.i7542.preheader, label %vector.memcheck7687

vector.memcheck7687:                              ; preds = %B272.if.lr.ph.i7533
  %233 = mul i64 %328, %.823.i7539
  %234 = mul i64 %329, %.759.i7536
  %235 = add i64 %233, %arg.results.0.47688
  %236 = add i64 %234, %arg.runs.0.47689
  %237 = sub i64 %235, %236
  %diff.check7690 = icmp ult i64 %237, 32
  br i1 %diff.check7690, label %B272.if.i7542.preheader, label %vector.body7696

vector.body7696:                                  ; preds = %vector.memcheck7687, %vector.body7696
  %index7697 = phi i64 [ %index.next7700, %vector.body7696 ], [ 0, %vector.memcheck7687 ]
  %238 = getelementptr double, ptr %231, i64 %index7697
  %239 = getelementptr i8, ptr %238, i64 16
  %wide.load7698 = load <2 x double>, ptr %238, align 8, !noalias !136
  %wide.load7699 = load <2 x double>, ptr %239, align 8, !noalias !136
  %240 = getelementptr double, ptr %232, i64 %index7697
  %241 = getelementptr i8, ptr %240, i64 16
  store <2 x double> %wide.load7698, ptr %240, align 8, !noalias !136
  store <2 x double> %wide.load7699, ptr %241, align 8, !noalias !136
  %index.next7700 = add i64 %index7697, 4
  %242 = icmp eq i64 %index.next7700, %n.vec7695
  br i1 %242, label %middle.block7701, label %vector.body7696, !llvm.loop !139

middle.block7701:                                 ; preds = %vector.body7696
  br i1 %cmp.n7702, label %B316.i7404, label %B272.if.i7542.preheader

B272.if.i7542.preheader:                          ; preds = %vector.memcheck7687, %B272.if.lr.ph.i7533, %middle.block7701
  %.638.01438.i7543.ph = phi i64 [ 0, %vector.memcheck7687 ], [ 0, %B272.if.lr.ph.i7533 ], [ %n.vec7695, %middle.block7701 ]
  br label %B272.if.i7542

B316.i7404:                                       ; preds = %B272.if.i7542, %middle.block7701, %B130.i7523, %B3742
  %m.2.0.i7405 = phi i64 [ 0, %B3742 ], [ %.314.i7400, %B130.i7523 ], [ %.314.i7400, %middle.block7701 ], [ %.314.i7400, %B272.if.i7542 ]
  br i1 %.9661440.not.i7406, label %B390.i7422, label %B346.if.lr.ph.i7407

B346.if.lr.ph.i7407:                              ; preds = %B316.i7404
  %.1027.i7408 = icmp slt i64 %m.2.0.i7405, 0
  %.1028.i7409 = select i1 %.1027.i7408, i64 %arg.runs.1.5.0, i64 0
  %.1029.i7410 = add i64 %.1028.i7409, %m.2.0.i7405
  %.1049.i7411 = mul i64 %.1029.i7410, %arg.runs.1.5.1
  %243 = getelementptr double, ptr %arg.runs.1.4, i64 %.1049.i7411
  %invariant.gep7891 = getelementptr double, ptr %arg.arrays.1.4, i64 %.5002.07661
  br label %B346.if.i7412

B390.i7422:                                       ; preds = %B346.if.i7412, %B316.i7404
  br i1 %.11851443.not.i7423, label %B516.i7445, label %B446.if.lr.ph.i7424

B446.if.lr.ph.i7424:                              ; preds = %B390.i7422
  %.1237.i7425 = icmp slt i64 %m.2.0.i7405, 0
  %.1238.i7426 = select i1 %.1237.i7425, i64 %arg.runs.2.5.0, i64 0
  %244 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i7405
  %.1252.i7427 = getelementptr i64, ptr %244, i64 %.1238.i7426
  br label %B446.if.i7429

B516.i7445:                                       ; preds = %B446.if.i7429, %B390.i7422
  br i1 %.375.i7403, label %B574.i7473, label %B520.i7446

B520.i7446:                                       ; preds = %B516.i7445
  br i1 %.1423.i7447, label %B532.i7449, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit7547

B532.i7449:                                       ; preds = %B520.i7446
  br i1 %.163.i1446.not.i7450, label %B102.i.i7461, label %B46.if.i.i7451.preheader

B46.if.i.i7451.preheader:                         ; preds = %B532.i7449
  %invariant.gep7893 = getelementptr double, ptr %arg.arrays.0.4, i64 %.5002.07661
  br label %B46.if.i.i7451

B102.i.i7461:                                     ; preds = %B46.if.i.i7451, %B532.i7449
  %.360.i.i7465 = getelementptr double, ptr %arg.lane.0.4, i64 %.5002.07661
  store double 0.000000e+00, ptr %.360.i.i7465, align 8, !noalias !140
  %.415.i.i7466 = getelementptr double, ptr %308, i64 %.5002.07661
  store double 5.000000e-01, ptr %.415.i.i7466, align 8, !noalias !140
  %.470.i.i7468 = getelementptr double, ptr %309, i64 %.5002.07661
  store double 1.000000e+00, ptr %.470.i.i7468, align 8, !noalias !140
  %.529.i.i7470 = getelementptr double, ptr %310, i64 %.5002.07661
  store double 0.000000e+00, ptr %.529.i.i7470, align 8, !noalias !140
  %.586.i.i7472 = getelementptr double, ptr %311, i64 %.5002.07661
  store double 0.000000e+00, ptr %.586.i.i7472, align 8, !noalias !140
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit7547

B46.if.i.i7451:                                   ; preds = %B46.if.i.i7451.preheader, %B46.if.i.i7451
  %.105.i.01447.i7452 = phi i64 [ %.176.i.i7453, %B46.if.i.i7451 ], [ 0, %B46.if.i.i7451.preheader ]
  %.176.i.i7453 = add nsw i64 %.105.i.01447.i7452, 1
  %245 = getelementptr double, ptr %arg.runs.0.4, i64 %.105.i.01447.i7452
  %.255.i.i7454 = load double, ptr %245, align 8, !noalias !140
  %.257.i.i7455 = mul nsw i64 %.105.i.01447.i7452, %arg.shape.0
  %gep7894 = getelementptr double, ptr %invariant.gep7893, i64 %.257.i.i7455
  store double %.255.i.i7454, ptr %gep7894, align 8, !noalias !140
  %exitcond1454.not.i7460 = icmp eq i64 %arg.shape.1, %.176.i.i7453
  br i1 %exitcond1454.not.i7460, label %B102.i.i7461, label %B46.if.i.i7451

B574.i7473:                                       ; preds = %B516.i7445
  br i1 %.15851449.not.i7474, label %B648.i7490, label %B604.if.lr.ph.i7475

B604.if.lr.ph.i7475:                              ; preds = %B574.i7473
  %.1646.i7476 = icmp slt i64 %m.2.0.i7405, 0
  %.1647.i7477 = select i1 %.1646.i7476, i64 %arg.runs.0.5.0, i64 0
  %.1648.i7478 = add i64 %.1647.i7477, %m.2.0.i7405
  %.1668.i7479 = mul i64 %.1648.i7478, %arg.runs.0.5.1
  %246 = getelementptr double, ptr %arg.runs.0.4, i64 %.1668.i7479
  %invariant.gep7895 = getelementptr double, ptr %arg.arrays.0.4, i64 %.5002.07661
  br label %B604.if.i7480

B648.i7490:                                       ; preds = %B604.if.i7480, %B574.i7473
  %.1748.i7491 = load double, ptr %arg.times.4, align 8, !noalias !136
  %.1765.i7492 = icmp slt i64 %m.2.0.i7405, 0
  %.1766.i7493 = select i1 %.1765.i7492, i64 %arg.runs.2.5.0, i64 0
  %247 = getelementptr i64, ptr %arg.runs.2.4, i64 %m.2.0.i7405
  %.1780.i7494 = getelementptr i64, ptr %247, i64 %.1766.i7493
  %.1781.i7495 = load i64, ptr %.1780.i7494, align 8, !noalias !136
  %.1812.i7496 = icmp slt i64 %.1781.i7495, 0
  %.1813.i7497 = select i1 %.1812.i7496, i64 %arg.schedule.0.5.0, i64 0
  %.1814.i7498 = add i64 %.1813.i7497, %.1781.i7495
  %.1834.i7499 = mul i64 %.1814.i7498, %arg.schedule.0.5.1
  %.1838.i7500 = getelementptr double, ptr %arg.schedule.0.4, i64 %.1834.i7499
  %.1839.i7501 = load double, ptr %.1838.i7500, align 8, !noalias !136
  %.1895.i7505 = getelementptr double, ptr %arg.lane.0.4, i64 %.5002.07661
  store double %.1748.i7491, ptr %.1895.i7505, align 8, !noalias !136
  %.1950.i7507 = getelementptr double, ptr %312, i64 %.5002.07661
  store double %.1839.i7501, ptr %.1950.i7507, align 8, !noalias !136
  %.2005.i7508 = getelementptr double, ptr %313, i64 %.5002.07661
  store double 0.000000e+00, ptr %.2005.i7508, align 8, !noalias !136
  %.2064.i7510 = getelementptr double, ptr %314, i64 %.5002.07661
  store double 1.000000e+00, ptr %.2064.i7510, align 8, !noalias !136
  %.2119.i7512 = getelementptr double, ptr %315, i64 %.5002.07661
  store double 0.000000e+00, ptr %.2119.i7512, align 8, !noalias !136
  %.2175.i7514 = getelementptr double, ptr %316, i64 %.5002.07661
  store double 0xFFF0000000000000, ptr %.2175.i7514, align 8, !noalias !136
  %248 = getelementptr i64, ptr %317, i64 %.5002.07661
  store i64 0, ptr %248, align 8, !noalias !136
  %.2287.i7519 = getelementptr double, ptr %318, i64 %.5002.07661
  %.2288.i7520 = load double, ptr %.2287.i7519, align 8, !noalias !136
  %.2290.i7521 = fcmp ueq double %.2288.i7520, 0xFFF0000000000000
  br i1 %.2290.i7521, label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit7547, label %B944.i7522

B944.i7522:                                       ; preds = %B648.i7490
  store double 0.000000e+00, ptr %.2287.i7519, align 8, !noalias !136
  br label %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit7547

B272.if.i7542:                                    ; preds = %B272.if.i7542.preheader, %B272.if.i7542
  %.638.01438.i7543 = phi i64 [ %.709.i7544, %B272.if.i7542 ], [ %.638.01438.i7543.ph, %B272.if.i7542.preheader ]
  %.709.i7544 = add nsw i64 %.638.01438.i7543, 1
  %249 = getelementptr double, ptr %231, i64 %.638.01438.i7543
  %.784.i7545 = load double, ptr %249, align 8, !noalias !136
  %250 = getelementptr double, ptr %232, i64 %.638.01438.i7543
  store double %.784.i7545, ptr %250, align 8, !noalias !136
  %exitcond.not.i7546 = icmp eq i64 %.709.i7544, %arg.shape.1
  br i1 %exitcond.not.i7546, label %B316.i7404, label %B272.if.i7542, !llvm.loop !144

B346.if.i7412:                                    ; preds = %B346.if.i7412, %B346.if.lr.ph.i7407
  %.910.01441.i7413 = phi i64 [ 0, %B346.if.lr.ph.i7407 ], [ %.979.i7414, %B346.if.i7412 ]
  %.979.i7414 = add nsw i64 %.910.01441.i7413, 1
  %251 = getelementptr double, ptr %243, i64 %.910.01441.i7413
  %.1054.i7415 = load double, ptr %251, align 8, !noalias !136
  %.1056.i7416 = mul nsw i64 %.910.01441.i7413, %arg.shape.0
  %gep7892 = getelementptr double, ptr %invariant.gep7891, i64 %.1056.i7416
  store double %.1054.i7415, ptr %gep7892, align 8, !noalias !136
  %exitcond1452.not.i7421 = icmp eq i64 %.979.i7414, %arg.shape.2
  br i1 %exitcond1452.not.i7421, label %B390.i7422, label %B346.if.i7412

B446.if.i7429:                                    ; preds = %B446.if.i7429, %B446.if.lr.ph.i7424
  %.1129.01444.i7430 = phi i64 [ 0, %B446.if.lr.ph.i7424 ], [ %.1198.i7431, %B446.if.i7429 ]
  %.1198.i7431 = add nsw i64 %.1129.01444.i7430, 1
  %.1253.i7432 = load i64, ptr %.1252.i7427, align 8, !noalias !136
  %.1289.i7433 = icmp slt i64 %.1253.i7432, 0
  %.1290.i7434 = select i1 %.1289.i7433, i64 %arg.schedule.3.5.0, i64 0
  %.1291.i7435 = add i64 %.1290.i7434, %.1253.i7432
  %.1321.i7436 = mul i64 %.1319.i7428, %.1291.i7435
  %252 = getelementptr double, ptr %arg.schedule.3.4, i64 %.1321.i7436
  %253 = getelementptr double, ptr %252, i64 %.1129.01444.i7430
  %.1328.i7437 = load double, ptr %253, align 8, !noalias !136
  %254 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.1129.01444.i7430
  %.1358.i7438 = load i64, ptr %254, align 8, !noalias !136
  %.1360.i7439 = mul nsw i64 %.1358.i7438, %arg.shape.0
  %.1362.i7440 = add nsw i64 %.1360.i7439, %.5002.07661
  %.1376.i7441 = icmp slt i64 %.1362.i7440, 0
  %.1377.i7442 = select i1 %.1376.i7441, i64 %arg.arrays.1.5.0, i64 0
  %255 = getelementptr double, ptr %arg.arrays.1.4, i64 %.1362.i7440
  %.1391.i7443 = getelementptr double, ptr %255, i64 %.1377.i7442
  store double %.1328.i7437, ptr %.1391.i7443, align 8, !noalias !136
  %exitcond1453.not.i7444 = icmp eq i64 %.1198.i7431, %arg.schedule.2.5.0
  br i1 %exitcond1453.not.i7444, label %B516.i7445, label %B446.if.i7429

B604.if.i7480:                                    ; preds = %B604.if.i7480, %B604.if.lr.ph.i7475
  %.1529.01450.i7481 = phi i64 [ 0, %B604.if.lr.ph.i7475 ], [ %.1598.i7482, %B604.if.i7480 ]
  %.1598.i7482 = add nsw i64 %.1529.01450.i7481, 1
  %256 = getelementptr double, ptr %246, i64 %.1529.01450.i7481
  %.1673.i7483 = load double, ptr %256, align 8, !noalias !136
  %.1675.i7484 = mul nsw i64 %.1529.01450.i7481, %arg.shape.0
  %gep7896 = getelementptr double, ptr %invariant.gep7895, i64 %.1675.i7484
  store double %.1673.i7483, ptr %gep7896, align 8, !noalias !136
  %exitcond1455.not.i7489 = icmp eq i64 %.1598.i7482, %arg.shape.1
  br i1 %exitcond1455.not.i7489, label %B648.i7490, label %B604.if.i7480

_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit7547: ; preds = %B520.i7446, %B102.i.i7461, %B648.i7490, %B944.i7522
  %storemerge1429.i7448 = phi i64 [ 0, %B520.i7446 ], [ 0, %B102.i.i7461 ], [ 1, %B944.i7522 ], [ 1, %B648.i7490 ]
  %.5802 = add nsw i64 %active.3.27664, -1
  %.5902 = add nsw i64 %.5802, %storemerge1429.i7448
  br label %B4107

B3866:                                            ; preds = %B3708
  %.5961 = getelementptr double, ptr %319, i64 %.5002.07661
  %.5962 = load double, ptr %.5961, align 8
  %.5964 = fcmp ult double %.5962, 1.500000e+01
  br i1 %.5964, label %B4107, label %B3914

B3914:                                            ; preds = %B3866
  %.6006 = load double, ptr %.6005, align 8
  %.6060 = getelementptr double, ptr %arg.lane.0.4, i64 %.5002.07661
  %.6061 = load double, ptr %.6060, align 8
  %.6062 = fsub double %.6006, %.6061
  %.6116 = getelementptr double, ptr %322, i64 %.5002.07661
  %.6117 = load double, ptr %.6116, align 8
  %.6119 = fmul double %.6117, 5.000000e+03
  %.6120 = fcmp ogt double %.6062, %.6119
  br i1 %.6120, label %B4107, label %B4052

B4052:                                            ; preds = %B3914
  store double 0.000000e+00, ptr %.5961, align 8
  br label %B4107

B4080:                                            ; preds = %B4107, %B3330
  %budget.4.2.lcssa = phi i64 [ %.760, %B3330 ], [ %budget.5.2, %B4107 ]
  %active.3.2.lcssa = phi i64 [ %active.4.0, %B3330 ], [ %active.5.2, %B4107 ]
  %.6213 = icmp sgt i64 %active.3.2.lcssa, 0
  %.6227 = icmp sgt i64 %budget.4.2.lcssa, 0
  %or.cond7231 = select i1 %.6213, i1 %.6227, i1 false
  br i1 %or.cond7231, label %B276, label %B4106

B4106:                                            ; preds = %B4080, %B202.endif
  %active.6.1 = phi i64 [ %active.3.i.0.lcssa, %B202.endif ], [ %active.3.2.lcssa, %B4080 ]
  store i64 %active.6.1, ptr %retptr, align 8
  ret i32 0

B4107:                                            ; preds = %B3866, %B4052, %B3914, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit7547, %B102.i
  %budget.5.2 = phi i64 [ %budget.4.27663, %B102.i ], [ %budget.4.27663, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit7547 ], [ 0, %B3914 ], [ %budget.4.27663, %B4052 ], [ %budget.4.27663, %B3866 ]
  %active.5.2 = phi i64 [ %active.3.27664, %B102.i ], [ %.5902, %_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE.exit7547 ], [ %active.3.27664, %B3914 ], [ %active.3.27664, %B4052 ], [ %active.3.27664, %B3866 ]
  %.5059 = icmp sgt i64 %.5005.07662, 1
  br i1 %.5059, label %B3362.if, label %B4080

B4108:                                            ; preds = %B1616.if, %B2122, %B2162, %B2212, %B1868
  %good.3.2 = phi i1 [ %good.2.17578, %B1868 ], [ true, %B2212 ], [ true, %B2162 ], [ true, %B2122 ], [ %good.2.17578, %B1616.if ]
  %wanted.3.2 = phi i1 [ %wanted.2.17579, %B1868 ], [ true, %B2212 ], [ %wanted.2.17579, %B2162 ], [ %wanted.2.17579, %B2122 ], [ %wanted.2.17579, %B1616.if ]
  %within.4.2 = phi i1 [ %within.3.17580, %B1868 ], [ %spec.select7226, %B2212 ], [ %spec.select, %B2162 ], [ %spec.select, %B2122 ], [ %within.3.17580, %B1616.if ]
  %doubted.3.2 = phi i1 [ %doubted.2.17581, %B1868 ], [ %"$phi2122.1.3.4", %B2212 ], [ %"$phi2122.1.3.4", %B2162 ], [ %"$phi2122.1.3.4", %B2122 ], [ %doubted.2.17581, %B1616.if ]
  %.2376 = icmp sgt i64 %.2322.07577, 1
  br i1 %.2376, label %B1616.if, label %B2274.loopexit

B202.endif:                                       ; preds = %B171.i, %entry
  %active.3.i.0.lcssa = phi i64 [ 0, %entry ], [ %active.4.i.1, %B171.i ]
  %.734 = icmp sgt i64 %active.3.i.0.lcssa, 0
  %.750 = icmp sgt i64 %arg.budget, 0
  %or.cond = select i1 %.734, i1 %.750, i1 false
  br i1 %or.cond, label %B276.preheader, label %B4106

B276.preheader:                                   ; preds = %B202.endif
  %.794 = getelementptr i8, ptr %arg.lane.2.4, i64 16
  %factor.op.mul = mul i64 %arg.shape.0, %arg.shape.1
  %factor.op.mul7667 = mul i64 %arg.shape.0, %arg.shape.1
  %.890 = getelementptr i8, ptr %arg.code.4, i64 8
  %.947 = icmp sgt i64 %arg.decided, 0
  %.149.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.idx7225 = mul i64 %arg.lane.0.5.1, 24
  %257 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7225
  %.457.i1787556 = icmp slt i64 %arg.decided, 1
  %.1081.idx = shl i64 %.454, 4
  %.1081 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1081.idx
  %.1085.not = icmp eq i64 %arg.guarded, 0
  %.1115 = getelementptr i8, ptr %arg.code.4, i64 16
  %.1192 = getelementptr i8, ptr %arg.code.4, i64 72
  %.1268 = getelementptr i8, ptr %arg.code.4, i64 80
  %.1369.idx = mul i64 %.454, 136
  %.1369 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1369.idx
  %.1394.idx = mul i64 %.454, 24
  %.1394 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1394.idx
  %.1425 = getelementptr i8, ptr %arg.code.4, i64 88
  %.idx7220 = mul i64 %arg.lane.0.5.1, 24
  %258 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7220
  %.idx7221 = shl i64 %arg.lane.0.5.1, 5
  %259 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7221
  %.idx7222 = mul i64 %arg.lane.0.5.1, 136
  %260 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7222
  %.idx7223 = mul i64 %arg.lane.0.5.1, 88
  %261 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7223
  %.idx7224 = shl i64 %arg.lane.0.5.1, 4
  %262 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7224
  %.1730.c = getelementptr i8, ptr %arg.code.4, i64 56
  %.1584.idx = shl i64 %arg.lane.1.5.1, 4
  %.1584 = getelementptr i8, ptr %arg.lane.1.4, i64 %.1584.idx
  %.1697.idx = mul i64 %arg.lane.0.5.1, 168
  %.1697 = getelementptr i8, ptr %arg.lane.0.4, i64 %.1697.idx
  %.1730 = getelementptr i8, ptr %arg.code.4, i64 56
  %.263.idx.i = shl i64 %arg.lane.0.5.1, 5
  %.263.i7237 = getelementptr i8, ptr %arg.lane.0.4, i64 %.263.idx.i
  %.317.i2791.not.i = icmp slt i64 %arg.shape.1, 1
  %.idx2853.i = mul i64 %arg.shape.1, 136
  %.idx2854.i = mul i64 %arg.shape.1, 88
  %.547.i2815.i = icmp sgt i64 %arg.linear.5.5.0, 1
  %.493.i.12818.i = add nsw i64 %arg.linear.5.5.0, -2
  %.616.i.i = getelementptr i8, ptr %arg.linear.9.4, i64 16
  %263 = tail call i64 @llvm.smax.i64(i64 %arg.shape.1, i64 -1)
  %storemerge2783.i = add i64 %263, 1
  %.711.i2794.i = icmp sgt i64 %arg.shape.1, -1
  %.871.i.i = getelementptr i8, ptr %arg.code.4, i64 48
  %.944.i.i = mul nsw i64 %arg.shape.1, 12
  %.962.i.idx.i = mul i64 %arg.shape.1, 136
  %.962.i.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.962.i.idx.i
  %.987.i.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.944.i.i
  %.153.i.i.i = getelementptr i8, ptr %arg.tolerances.4, i64 8
  %.499.i.i.idx.i = mul i64 %arg.lane.0.5.1, 48
  %.499.i.i.i = getelementptr i8, ptr %arg.lane.0.4, i64 %.499.i.i.idx.i
  %.503.i.i.i = mul nsw i64 %arg.shape.1, 18
  %.519.i.i.i = icmp slt i64 %arg.shape.1, 0
  %.520.i.i.i = select i1 %.519.i.i.i, i64 %arg.arrays.0.5.0, i64 0
  %.idx.i7240 = mul i64 %arg.shape.1, 152
  %264 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx.i7240
  %.534.i.i.i = getelementptr double, ptr %264, i64 %.520.i.i.i
  %.952.i.i.i = select i1 %.519.i.i.i, i64 %arg.linear.4.5.0, i64 0
  %265 = getelementptr i64, ptr %arg.linear.4.4, i64 %arg.shape.1
  %.966.i.i.i = getelementptr i64, ptr %265, i64 %.952.i.i.i
  %.897.i.i.i = mul nsw i64 %arg.shape.1, 17
  %.1279.i.i.idx.i = mul i64 %arg.shape.1, 96
  %.1279.i.i.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1279.i.i.idx.i
  %.1791.i.i = mul nsw i64 %arg.shape.1, 11
  %.idx2855.i = mul i64 %arg.shape.1, 144
  %invariant.gep = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx2855.i
  %.idx2856.i = mul i64 %arg.shape.1, 144
  %invariant.gep7565 = getelementptr double, ptr %arg.arrays.0.4, i64 %.503.i.i.i
  %invariant.gep7567 = getelementptr double, ptr %arg.arrays.0.4, i64 %.503.i.i.i
  %.418.i = getelementptr i8, ptr %arg.linear.9.4, i64 8
  %.5082825.not.i = icmp slt i64 %arg.shape.1, 1
  %.498.sroa.0.02782.i = add i64 %arg.shape.1, 1
  %.895.idx.i = mul i64 %arg.lane.0.5.1, 160
  %.895.i = getelementptr i8, ptr %arg.lane.0.4, i64 %.895.idx.i
  %.2108.idx = mul i64 %.454, 136
  %.2108 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.2108.idx
  %.215647.not.i = icmp sgt i64 %arg.shape.1, 0
  %or.cond7549.not = select i1 %.611, i1 %.215647.not.i, i1 false
  %.323.i = mul nsw i64 %arg.shape.1, 17
  %.idx.i7241 = mul i64 %arg.shape.1, 80
  %invariant.gep7569 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.idx.i7241
  %.449.i = getelementptr i8, ptr %arg.linear.9.4, i64 8
  %.454.i = mul nsw i64 %arg.shape.1, 17
  %invariant.gep7571 = getelementptr double, ptr %arg.arrays.0.4, i64 %.454.i
  %.2227 = getelementptr i8, ptr %arg.code.4, i64 64
  %.idx7215 = shl i64 %arg.lane.1.5.1, 4
  %266 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx7215
  %.idx7216 = mul i64 %arg.lane.0.5.1, 72
  %267 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7216
  %.idx7217 = mul i64 %arg.lane.0.5.1, 40
  %268 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7217
  %.2972 = icmp sgt i64 %arg.guarded, 0
  %.idx7218 = mul i64 %arg.lane.0.5.1, 144
  %269 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7218
  %.idx7219 = mul i64 %arg.lane.0.5.1, 56
  %270 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7219
  %.3746.idx = mul i64 %.454, 136
  %.3746 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3746.idx
  %.3771.idx = mul i64 %.454, 104
  %.3771 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3771.idx
  %.3809 = getelementptr i8, ptr %arg.code.4, i64 264
  %.3866 = icmp sgt i64 %arg.decided, 0
  %.3905 = getelementptr i8, ptr %arg.code.4, i64 40
  %.3927.idx = mul i64 %.454, 136
  %.3927 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.3927.idx
  %.idx7210 = mul i64 %arg.lane.0.5.1, 96
  %271 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7210
  %.idx7211 = mul i64 %arg.lane.0.5.1, 40
  %272 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7211
  %.idx7212 = mul i64 %arg.lane.0.5.1, 104
  %273 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7212
  %.idx7213 = mul i64 %arg.lane.0.5.1, 112
  %274 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7213
  %.idx7214 = shl i64 %arg.lane.1.5.1, 5
  %275 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx7214
  %.4266.idx = mul i64 %.454, 136
  %.4266 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4266.idx
  %.4328 = getelementptr i8, ptr %arg.code.4, i64 200
  %.4405 = getelementptr i8, ptr %arg.code.4, i64 104
  %.1013.i = getelementptr i8, ptr %arg.code.4, i64 40
  %.1105.i.idx = shl i64 %factor.op.mul, 4
  %.1105.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.1105.i.idx
  %.idx1174.i = mul i64 %arg.lane.0.5.1, 104
  %276 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1174.i
  %.idx1175.i = mul i64 %arg.lane.0.5.1, 112
  %277 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1175.i
  %.idx1176.i = mul i64 %arg.lane.0.5.1, 96
  %278 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1176.i
  %.idx1177.i = mul i64 %arg.lane.0.5.1, 48
  %279 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1177.i
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
  %.idx.i7258 = mul i64 %arg.lane.0.5.1, 56
  %280 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx.i7258
  %.idx1165.i = mul i64 %arg.lane.0.5.1, 40
  %281 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1165.i
  %.idx1166.i = shl i64 %arg.lane.0.5.1, 5
  %282 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1166.i
  %283 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.4532.not = icmp eq i64 %arg.guarded, 0
  %.845.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.937.i.idx = shl i64 %factor.op.mul7667, 4
  %.937.i = getelementptr i8, ptr %arg.arrays.0.4, i64 %.937.i.idx
  %.idx652.i = mul i64 %arg.lane.0.5.1, 48
  %284 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx652.i
  %.695658.not.i = icmp slt i64 %arg.shape.1, 1
  %.767.i = shl nsw i64 %arg.shape.1, 1
  %.idx.i7265 = mul i64 %arg.lane.0.5.1, 40
  %285 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx.i7265
  %.155.i.i7269 = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i7275 = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i7281 = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i7287 = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i7293 = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i7299 = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i7305 = mul nsw i64 %arg.shape.1, 18
  %factor.op.mul631.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.idx.i7320 = shl i64 %arg.lane.1.5.1, 4
  %286 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx.i7320
  %.idx620.i = mul i64 %arg.lane.0.5.1, 40
  %287 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx620.i
  %.idx621.i = mul i64 %arg.lane.0.5.1, 48
  %288 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx621.i
  %.idx622.i = mul i64 %arg.lane.0.5.1, 56
  %289 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx622.i
  %.917628.not.i = icmp slt i64 %arg.shape.1, 1
  %.993.i = mul nsw i64 %arg.shape.1, 17
  %290 = add i64 %arg.times.5.0, -1
  %.155.i.i7332 = mul nsw i64 %arg.shape.1, 24
  %.155.i.1.i7338 = mul nsw i64 %arg.shape.1, 23
  %.155.i.2.i7344 = mul nsw i64 %arg.shape.1, 22
  %.155.i.3.i7350 = mul nsw i64 %arg.shape.1, 21
  %.155.i.4.i7356 = mul nsw i64 %arg.shape.1, 20
  %.155.i.5.i7362 = mul nsw i64 %arg.shape.1, 19
  %.155.i.6.i7368 = mul nsw i64 %arg.shape.1, 18
  %.4758 = getelementptr i8, ptr %arg.code.4, i64 96
  %.idx7204 = mul i64 %arg.lane.0.5.1, 96
  %291 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7204
  %.idx7205 = mul i64 %arg.lane.0.5.1, 40
  %292 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7205
  %.idx7206 = mul i64 %arg.lane.0.5.1, 120
  %293 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7206
  %294 = getelementptr double, ptr %arg.times.4, i64 %arg.times.5.0
  %.449.i1724 = getelementptr i8, ptr %294, i64 -8
  %.idx7207 = mul i64 %arg.lane.1.5.1, 24
  %295 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx7207
  %.idx7208 = mul i64 %arg.lane.1.5.1, 24
  %296 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx7208
  %.idx7209 = mul i64 %arg.lane.0.5.1, 24
  %297 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7209
  %.4855.not = icmp eq i64 %arg.jumping, 0
  %.idx1848.i = mul i64 %arg.lane.0.5.1, 40
  %298 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1848.i
  %.idx1849.i = shl i64 %arg.lane.0.5.1, 4
  %299 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1849.i
  %300 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.7511852.not.i = icmp slt i64 %arg.schedule.2.5.0, 1
  %.852.i = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1017.i = getelementptr i8, ptr %arg.code.4, i64 8
  %.1160.i = getelementptr i8, ptr %arg.code.4, i64 32
  %.1231.i7384 = mul nsw i64 %arg.shape.1, 17
  %.1233.i7385 = mul nsw i64 %.1231.i7384, %arg.shape.0
  %.1276.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.1233.i7385
  %.idx1846.i = shl i64 %arg.lane.1.5.1, 4
  %301 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1846.i
  %.17571859.not.i = icmp slt i64 %arg.shape.1, 1
  %.1952.i = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.2041.not.i = icmp eq i64 %arg.guarded, 0
  %.2073.i = getelementptr i8, ptr %arg.code.4, i64 16
  %.idx = mul i64 %arg.lane.0.5.1, 40
  %302 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx
  %.idx7195 = shl i64 %arg.lane.0.5.1, 4
  %303 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7195
  %304 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.idx7196 = mul i64 %arg.lane.0.5.1, 24
  %305 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7196
  %.1103.i7654.not = icmp slt i64 %arg.schedule.2.5.0, 1
  %.1256.i = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.idx7199 = shl i64 %arg.lane.1.5.1, 4
  %306 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx7199
  %.373.i7401 = getelementptr i8, ptr %arg.lane.2.4, i64 8
  %307 = getelementptr i64, ptr %arg.lane.1.4, i64 %arg.lane.1.5.1
  %.6961437.not.i7532 = icmp slt i64 %arg.shape.1, 1
  %.851.i7540 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %.9661440.not.i7406 = icmp slt i64 %arg.shape.2, 1
  %.11851443.not.i7423 = icmp slt i64 %arg.schedule.2.5.0, 1
  %.1319.i7428 = mul i64 %arg.schedule.3.5.2, %arg.schedule.3.5.1
  %.1423.i7447 = icmp sgt i64 %arg.shape.0, 1
  %.163.i1446.not.i7450 = icmp slt i64 %arg.shape.1, 1
  %308 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1426.i7467 = shl i64 %arg.lane.0.5.1, 4
  %309 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1426.i7467
  %.idx1427.i7469 = mul i64 %arg.lane.0.5.1, 24
  %310 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1427.i7469
  %.idx1428.i7471 = shl i64 %arg.lane.0.5.1, 5
  %311 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1428.i7471
  %.15851449.not.i7474 = icmp slt i64 %arg.shape.1, 1
  %.idx1431.i7506 = shl i64 %arg.lane.0.5.1, 4
  %312 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1431.i7506
  %313 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx1432.i7509 = mul i64 %arg.lane.0.5.1, 24
  %314 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1432.i7509
  %.idx1433.i7511 = shl i64 %arg.lane.0.5.1, 5
  %315 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1433.i7511
  %.idx1434.i7513 = mul i64 %arg.lane.0.5.1, 120
  %316 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1434.i7513
  %.idx1435.i7516 = mul i64 %arg.lane.1.5.1, 24
  %317 = getelementptr i8, ptr %arg.lane.1.4, i64 %.idx1435.i7516
  %.idx1436.i7518 = mul i64 %arg.lane.0.5.1, 144
  %318 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx1436.i7518
  %.idx7198 = mul i64 %arg.lane.0.5.1, 144
  %319 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7198
  %.5991 = tail call i64 @llvm.smin.i64(i64 %arg.times.5.0, i64 0)
  %320 = getelementptr double, ptr %arg.times.4, i64 %arg.times.5.0
  %321 = getelementptr i8, ptr %320, i64 -8
  %.6005 = getelementptr double, ptr %321, i64 %.5991
  %322 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.163.i22937657.not = icmp slt i64 %arg.shape.1, 1
  %323 = getelementptr double, ptr %arg.lane.0.4, i64 %arg.lane.0.5.1
  %.idx7201 = shl i64 %arg.lane.0.5.1, 4
  %324 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7201
  %.idx7202 = mul i64 %arg.lane.0.5.1, 24
  %325 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7202
  %.idx7203 = shl i64 %arg.lane.0.5.1, 5
  %326 = getelementptr i8, ptr %arg.lane.0.4, i64 %.idx7203
  %327 = mul i64 %arg.results.0.5.2, %arg.results.0.5.1
  %328 = shl i64 %327, 3
  %329 = shl i64 %arg.runs.0.5.1, 3
  %330 = mul i64 %arg.shape.1, -176
  %331 = mul i64 %arg.shape.1, -168
  %332 = mul i64 %arg.shape.1, -160
  %333 = mul i64 %arg.shape.1, -152
  %334 = mul i64 %arg.shape.1, -144
  %335 = mul i64 %arg.shape.1, -136
  %336 = mul i64 %arg.shape.1, -128
  %337 = mul i64 %arg.shape.1, -176
  %338 = mul i64 %arg.shape.1, -168
  %339 = mul i64 %arg.shape.1, -160
  %340 = mul i64 %arg.shape.1, -152
  %341 = mul i64 %arg.shape.1, -144
  %342 = mul i64 %arg.shape.1, -136
  %343 = mul i64 %arg.shape.1, -128
  %344 = add i64 %.idx2856.i, %arg.arrays.0.47799
  %345 = sub i64 %344, %arg.linear.4.47800
  %346 = add i64 %263, 2
  %smin = tail call i64 @llvm.smin.i64(i64 %storemerge2783.i, i64 1)
  %347 = sub i64 %346, %smin
  %348 = mul i64 %arg.shape.1, -48
  %min.iters.check7825 = icmp ult i64 %arg.shape.1, 4
  %diff.check7819 = icmp ult i64 %348, 32
  %diff.check7820 = icmp ult i64 %.962.i.idx.i, 32
  %conflict.rdx7821 = or i1 %diff.check7819, %diff.check7820
  %diff.check7822 = icmp ult i64 %.idx2854.i, 32
  %conflict.rdx7823 = or i1 %conflict.rdx7821, %diff.check7822
  %n.vec7828 = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n7835 = icmp eq i64 %arg.shape.1, %n.vec7828
  %min.iters.check7803 = icmp ult i64 %347, 4
  %diff.check7801 = icmp ult i64 %345, 32
  %or.cond7838 = select i1 %min.iters.check7803, i1 true, i1 %diff.check7801
  %n.vec7806 = and i64 %347, -4
  %349 = sub i64 %storemerge2783.i, %n.vec7806
  %cmp.n7815 = icmp eq i64 %347, %n.vec7806
  %min.iters.check7784 = icmp ult i64 %arg.shape.1, 4
  %diff.check7782 = icmp ult i64 %.idx2856.i, 32
  %or.cond7839 = or i1 %min.iters.check7784, %diff.check7782
  %n.vec7787 = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n7796 = icmp eq i64 %arg.shape.1, %n.vec7787
  %350 = getelementptr i8, ptr %arg.code.4, i64 208
  %.4291.idx = mul i64 %.454, 112
  %.4291 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4291.idx
  %351 = getelementptr i8, ptr %arg.code.4, i64 216
  %.4291.1.idx = mul i64 %.454, 120
  %.4291.1 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4291.1.idx
  %352 = getelementptr i8, ptr %arg.code.4, i64 224
  %.4291.2.idx = shl i64 %.454, 7
  %.4291.2 = getelementptr i8, ptr %arg.arrays.0.4, i64 %.4291.2.idx
  %min.iters.check7759 = icmp ne i64 %arg.shape.1, 1
  %ident.check7741.not = icmp eq i64 %arg.shape.0, 1
  %or.cond7840 = and i1 %min.iters.check7759, %ident.check7741.not
  %diff.check7743 = icmp eq i64 %337, 0
  %diff.check7744 = icmp ult i64 %338, 16
  %conflict.rdx7745 = or i1 %diff.check7743, %diff.check7744
  %diff.check7746 = icmp eq i64 %339, 0
  %conflict.rdx7747 = or i1 %conflict.rdx7745, %diff.check7746
  %diff.check7748 = icmp ult i64 %340, 16
  %conflict.rdx7749 = or i1 %conflict.rdx7747, %diff.check7748
  %diff.check7750 = icmp eq i64 %341, 0
  %conflict.rdx7751 = or i1 %conflict.rdx7749, %diff.check7750
  %diff.check7752 = icmp ult i64 %342, 16
  %conflict.rdx7753 = or i1 %conflict.rdx7751, %diff.check7752
  %diff.check7754 = icmp eq i64 %343, 0
  %conflict.rdx7755 = or i1 %conflict.rdx7753, %diff.check7754
  %.mask = and i64 %arg.shape.1, 1152921504606846975
  %diff.check7756 = icmp eq i64 %.mask, 0
  %conflict.rdx7757 = or i1 %conflict.rdx7755, %diff.check7756
  %n.vec7762 = and i64 %arg.shape.1, 9223372036854775806
  %cmp.n7779 = icmp eq i64 %arg.shape.1, %n.vec7762
  %min.iters.check7720 = icmp ne i64 %arg.shape.1, 1
  %ident.check.not = icmp eq i64 %arg.shape.0, 1
  %or.cond7841 = and i1 %min.iters.check7720, %ident.check.not
  %diff.check7705 = icmp eq i64 %330, 0
  %diff.check7706 = icmp ult i64 %331, 16
  %conflict.rdx = or i1 %diff.check7705, %diff.check7706
  %diff.check7707 = icmp eq i64 %332, 0
  %conflict.rdx7708 = or i1 %conflict.rdx, %diff.check7707
  %diff.check7709 = icmp ult i64 %333, 16
  %conflict.rdx7710 = or i1 %conflict.rdx7708, %diff.check7709
  %diff.check7711 = icmp eq i64 %334, 0
  %conflict.rdx7712 = or i1 %conflict.rdx7710, %diff.check7711
  %diff.check7713 = icmp ult i64 %335, 16
  %conflict.rdx7714 = or i1 %conflict.rdx7712, %diff.check7713
  %diff.check7715 = icmp eq i64 %336, 0
  %conflict.rdx7716 = or i1 %conflict.rdx7714, %diff.check7715
  %.mask7837 = and i64 %arg.shape.1, 1152921504606846975
  %diff.check7717 = icmp eq i64 %.mask7837, 0
  %conflict.rdx7718 = or i1 %conflict.rdx7716, %diff.check7717
  %n.vec7723 = and i64 %arg.shape.1, 9223372036854775806
  %cmp.n7738 = icmp eq i64 %arg.shape.1, %n.vec7723
  %brmerge7669 = or i1 %.4855.not, %.274.i
  %min.iters.check7692 = icmp ult i64 %arg.shape.1, 8
  %n.vec7695 = and i64 %arg.shape.1, 9223372036854775804
  %cmp.n7702 = icmp eq i64 %arg.shape.1, %n.vec7695
  br label %B276

B1276.if:                                         ; preds = %B1276.if.preheader, %B1500
  %.1879.07573 = phi i64 [ %.1948, %B1500 ], [ 1, %B1276.if.preheader ]
  %.1948 = add nsw i64 %.1879.07573, 1
  %353 = getelementptr i64, ptr %arg.code.4, i64 %.1879.07573
  %354 = getelementptr i8, ptr %353, i64 104
  %.2007 = load i64, ptr %354, align 8
  %.2052 = inttoptr i64 %.2007 to ptr
  tail call void %.2052(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.2083 = load i64, ptr %arg.code.4, align 8
  %.2089 = mul nsw i64 %.1948, %.454
  %.2133 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2089
  %.2134 = inttoptr i64 %.2083 to ptr
  tail call void %.2134(ptr %.562, ptr %.2108, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.2133)
  br i1 %or.cond7549.not, label %B60.if.lr.ph.i, label %B1500

B1616.if:                                         ; preds = %B1502, %B4108
  %doubted.2.17581 = phi i1 [ %doubted.3.2, %B4108 ], [ false, %B1502 ]
  %within.3.17580 = phi i1 [ %within.4.2, %B4108 ], [ false, %B1502 ]
  %wanted.2.17579 = phi i1 [ %wanted.3.2, %B4108 ], [ false, %B1502 ]
  %good.2.17578 = phi i1 [ %good.3.2, %B4108 ], [ false, %B1502 ]
  %.2322.07577 = phi i64 [ %.2385, %B4108 ], [ %storemerge, %B1502 ]
  %.2319.07576 = phi i64 [ %.2389, %B4108 ], [ 0, %B1502 ]
  %.2385 = add nsw i64 %.2322.07577, -1
  %.2389 = add nsw i64 %.2319.07576, 1
  %.2486 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2319.07576
  %.2487 = load i64, ptr %.2486, align 8
  %.2541 = getelementptr i64, ptr %266, i64 %.2319.07576
  %.2542 = load i64, ptr %.2541, align 8
  %.2550 = icmp sgt i64 %.2487, -1
  br i1 %.2550, label %B1694, label %B4108

B2688.if:                                         ; preds = %B2620
  %.4166 = load i64, ptr %350, align 8
  %.4211 = inttoptr i64 %.4166 to ptr
  tail call void %.4211(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4242 = load i64, ptr %arg.code.4, align 8
  %.4292 = inttoptr i64 %.4242 to ptr
  tail call void %.4292(ptr %.562, ptr %.4266, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.4291)
  %.4166.1 = load i64, ptr %351, align 8
  %.4211.1 = inttoptr i64 %.4166.1 to ptr
  tail call void %.4211.1(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4242.1 = load i64, ptr %arg.code.4, align 8
  %.4292.1 = inttoptr i64 %.4242.1 to ptr
  tail call void %.4292.1(ptr %.562, ptr %.4266, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.4291.1)
  %.4166.2 = load i64, ptr %352, align 8
  %.4211.2 = inttoptr i64 %.4166.2 to ptr
  tail call void %.4211.2(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  %.4242.2 = load i64, ptr %arg.code.4, align 8
  %.4292.2 = inttoptr i64 %.4242.2 to ptr
  tail call void %.4292.2(ptr %.562, ptr %.4266, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.4291.2)
  %.4329 = load i64, ptr %.4328, align 8
  %.4374 = inttoptr i64 %.4329 to ptr
  tail call void %.4374(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4)
  br label %B2958

B3362.if:                                         ; preds = %B3330, %B4107
  %active.3.27664 = phi i64 [ %active.5.2, %B4107 ], [ %active.4.0, %B3330 ]
  %budget.4.27663 = phi i64 [ %budget.5.2, %B4107 ], [ %.760, %B3330 ]
  %.5005.07662 = phi i64 [ %.5068, %B4107 ], [ %storemerge, %B3330 ]
  %.5002.07661 = phi i64 [ %.5072, %B4107 ], [ 0, %B3330 ]
  %.5068 = add nsw i64 %.5005.07662, -1
  %.5072 = add nsw i64 %.5002.07661, 1
  %.5153 = getelementptr i64, ptr %arg.lane.1.4, i64 %.5002.07661
  %.5154 = load i64, ptr %.5153, align 8
  %.5159 = icmp slt i64 %.5154, 0
  br i1 %.5159, label %B3408, label %B3448
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
  br i1 %.431, label %B0.if, label %B0.endif, !prof !145

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
  br i1 %.2065, label %B0.endif.else.endif.if.i, label %B0.endif.else.endif.endif.i, !prof !145

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
  %.323.i = load i64, ptr %.322.i, align 8, !noalias !146
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
  %wide.load = load <2 x double>, ptr %13, align 8, !noalias !146
  %wide.load4804 = load <2 x double>, ptr %14, align 8, !noalias !146
  %15 = getelementptr double, ptr %gep.i, i64 %index
  %16 = getelementptr i8, ptr %15, i64 16
  store <2 x double> %wide.load, ptr %15, align 8, !noalias !146
  store <2 x double> %wide.load4804, ptr %16, align 8, !noalias !146
  %index.next = add i64 %index, 4
  %17 = icmp eq i64 %index.next, %n.vec
  br i1 %17, label %middle.block, label %vector.body, !llvm.loop !149

middle.block:                                     ; preds = %vector.body
  br i1 %cmp.n, label %B216.i, label %B170.if.i.preheader

B170.if.i.preheader:                              ; preds = %vector.memcheck, %B170.if.lr.ph.i, %middle.block
  %.350.0227.i.ph = phi i64 [ 0, %vector.memcheck ], [ 0, %B170.if.lr.ph.i ], [ %n.vec, %middle.block ]
  br label %B170.if.i

B216.i:                                           ; preds = %B170.if.i, %middle.block, %B140.i
  %.587.i = getelementptr i64, ptr %arg.results.2.4, i64 %.286.i
  store i64 %.557.i, ptr %.587.i, align 8, !noalias !146
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
  %.286.i = load i64, ptr %21, align 8, !noalias !146
  %.291.i = icmp sgt i64 %.286.i, -1
  br i1 %.291.i, label %B106.i, label %B232.i

B170.if.i:                                        ; preds = %B170.if.i.preheader, %B170.if.i
  %.350.0227.i = phi i64 [ %.419.i, %B170.if.i ], [ %.350.0227.i.ph, %B170.if.i.preheader ]
  %.419.i = add nsw i64 %.350.0227.i, 1
  %.445.i = mul nsw i64 %.350.0227.i, %arg.shape.0
  %gep4759 = getelementptr double, ptr %invariant.gep4758, i64 %.445.i
  %.477.i = load double, ptr %gep4759, align 8, !noalias !146
  %22 = getelementptr double, ptr %gep.i, i64 %.350.0227.i
  store double %.477.i, ptr %22, align 8, !noalias !146
  %exitcond.not.i = icmp eq i64 %arg.shape.1, %.419.i
  br i1 %exitcond.not.i, label %B216.i, label %B170.if.i, !llvm.loop !150

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
  store ptr @.const.picklebuf.ca8efb3a72d614fe872032cce3ac326007a30727, ptr %excinfo, align 8, !numba_exception_output !151
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
  br i1 %.2065, label %B748.endif.else.endif.if, label %B748.endif.else.endif.endif.endif.if, !prof !145

B748.endif.else.endif.if:                         ; preds = %B748.else.endif
  br label %B748.endif.else.endif.endif.endif.if

B748.endif.else.endif.endif.endif.if:             ; preds = %B748.endif.else.endif.if, %B748.else.endif
  %.2037.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %B748.endif.else.endif.if ], [ 0, %B748.else.endif ]
  %.2161.not4705 = icmp slt i64 %.2037.sroa.0.3, %arg.lane.0.5.1
  br i1 %.2161.not4705, label %.2131.endif.preheader, label %.2131.if, !prof !152

.2131.endif.preheader:                            ; preds = %B748.endif.else.endif.endif.endif.if
  %51 = sub i64 %arg.lane.0.5.1, %.2037.sroa.0.3
  %min.iters.check4945 = icmp ult i64 %51, 4
  br i1 %min.iters.check4945, label %.2131.endif.preheader4970, label %vector.ph4946, !prof !153

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
  br i1 %56, label %middle.block4955, label %vector.body4951, !prof !154, !llvm.loop !155

middle.block4955:                                 ; preds = %vector.body4951
  %cmp.n4956 = icmp eq i64 %51, %n.vec4948
  br i1 %cmp.n4956, label %.2131.if, label %.2131.endif.preheader4970, !prof !157

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
  br i1 %exitcond4778.not, label %.2131.if, label %.2131.endif, !prof !158, !llvm.loop !159

B358.i:                                           ; preds = %B308.if.i, %middle.block4899, %.1491.if.i
  br i1 %.1728.i, label %B370.else.i, label %B442.i

B442.i:                                           ; preds = %B250.i.i, %B358.i
  %.2158.i = load i64, ptr %arg.code.4, align 8, !noalias !161
  %.2205.i = inttoptr i64 %.2158.i to ptr
  tail call void %.2205.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.2204.i), !noalias !161
  br label %B558.if.i

B648.i:                                           ; preds = %B558.if.i
  %.150.i155.i = load i64, ptr %.149.i154.i, align 8, !noalias !165
  %.195.i174.i = inttoptr i64 %.150.i155.i to ptr
  tail call void %.195.i174.i(ptr %.331.i, ptr %.169.i.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !165
  br i1 %.279.i211.i4727.not, label %B250.i219.i, label %B118.if.i429.i

B248.i313.i:                                      ; preds = %B190.if.i414.i, %B118.if.i429.i
  %exitcond4787.not = icmp eq i64 %arg.shape.0, %.292.i435.i
  br i1 %exitcond4787.not, label %B250.i219.i, label %B118.if.i429.i

B250.i219.i:                                      ; preds = %B248.i313.i, %B648.i
  %.614.i243.i = load i64, ptr %.2211, align 8, !noalias !165
  %.661.i263.i = inttoptr i64 %.614.i243.i to ptr
  tail call void %.661.i263.i(ptr %.331.i, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !165
  br label %B708.i

B118.if.i429.i:                                   ; preds = %B648.i, %B248.i313.i
  %.221.i102.i.04729 = phi i64 [ %.292.i435.i, %B248.i313.i ], [ 0, %B648.i ]
  %.292.i435.i = add nsw i64 %.221.i102.i.04729, 1
  %58 = getelementptr double, ptr %26, i64 %.221.i102.i.04729
  %.374.i311.i = load double, ptr %58, align 8, !noalias !165
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
  %.528.i388.i = load double, ptr %gep4982, align 8, !noalias !165
  %.530.i390.i = add nsw i64 %.401.i116.i.04726, %arg.held
  %.532.i392.i = mul nsw i64 %.530.i390.i, %arg.shape.0
  %.534.i394.i = add nsw i64 %.532.i392.i, %.221.i102.i.04729
  %.548.i402.i = icmp slt i64 %.534.i394.i, 0
  %.549.i403.i = select i1 %.548.i402.i, i64 %arg.arrays.1.5.0, i64 0
  %59 = getelementptr double, ptr %arg.arrays.1.4, i64 %.534.i394.i
  %.563.i413.i = getelementptr double, ptr %59, i64 %.549.i403.i
  store double %.528.i388.i, ptr %.563.i413.i, align 8, !noalias !165
  %exitcond4786.not = icmp eq i64 %.470.i420.i, %arg.decided
  br i1 %exitcond4786.not, label %B248.i313.i, label %B190.if.i414.i

B708.i:                                           ; preds = %B250.i219.i, %B558.if.i
  %.2495.i = load i64, ptr %arg.code.4, align 8, !noalias !161
  %.2503.i = mul nsw i64 %.2299.i, %.223.i
  %.2547.i = getelementptr double, ptr %arg.arrays.0.4, i64 %.2503.i
  %.2548.i = inttoptr i64 %.2495.i to ptr
  tail call void %.2548.i(ptr %.331.i, ptr %.2522.i, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.2547.i), !noalias !161
  %exitcond4788.not = icmp eq i64 %.2299.i, 4
  br i1 %exitcond4788.not, label %B816.i, label %B558.if.i

B816.i:                                           ; preds = %B708.i
  %.2585.i = load i64, ptr %.2584.i, align 8, !noalias !161
  %.2630.i = inttoptr i64 %.2585.i to ptr
  tail call void %.2630.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !161
  br i1 %.2633.i.not, label %B962.i, label %B894.i

B894.i:                                           ; preds = %B816.i
  %.2664.i = load i64, ptr %.2663.i, align 8, !noalias !161
  %.2709.i = inttoptr i64 %.2664.i to ptr
  tail call void %.2709.i(ptr %.331.i, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !161
  br label %B962.i

B962.i:                                           ; preds = %B894.i, %B816.i
  br i1 %.2795.i4736.not, label %B1410.i, label %B996.if.i

B1046.i:                                          ; preds = %B996.if.i
  %.2929.i = getelementptr i64, ptr %arg.results.1.4, i64 %.2890.i
  %.2930.i = load i64, ptr %.2929.i, align 8, !noalias !161
  %.2931.i.not = icmp eq i64 %.2930.i, 0
  br i1 %.2931.i.not, label %B1082.i, label %B1621.i

B1082.i:                                          ; preds = %B1046.i
  %.3001.i = mul i64 %.2890.i, %arg.results.3.5.1
  %.3005.i = getelementptr i64, ptr %arg.results.3.4, i64 %.3001.i
  %.3006.i = load i64, ptr %.3005.i, align 8, !noalias !161
  %.3007.i = add nsw i64 %.3006.i, 1
  store i64 %.3007.i, ptr %.3005.i, align 8, !noalias !161
  %.3115.i = getelementptr i8, ptr %.3005.i, i64 8
  %.3116.i = load i64, ptr %.3115.i, align 8, !noalias !161
  %.3117.i = add nsw i64 %.3116.i, 4
  store i64 %.3117.i, ptr %.3115.i, align 8, !noalias !161
  br i1 %.3250.i4732.not, label %B1310.i, label %B1204.if.i.preheader

B1204.if.i.preheader:                             ; preds = %B1082.i
  %invariant.gep4983 = getelementptr double, ptr %arg.arrays.0.4, i64 %.2739.i.04737
  br label %B1204.if.i

B1250.i.loopexit:                                 ; preds = %B1204.if.i
  %60 = fcmp une double %.3324.i, 0.000000e+00
  br i1 %60, label %B1262.i, label %B1310.i

B1262.i:                                          ; preds = %B1250.i.loopexit
  %.84.i477.i = load i64, ptr %104, align 8, !noalias !169
  %.89.i.i = icmp sgt i64 %.84.i477.i, -1
  br i1 %.89.i.i, label %B46.i.i, label %B1621.i

B46.i.i:                                          ; preds = %B1262.i
  %.120.i.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i477.i
  %.121.i486.i = load i64, ptr %.120.i.i, align 8, !noalias !169
  %.122.i487.i = icmp eq i64 %.121.i486.i, 0
  br i1 %.122.i487.i, label %B80.i.i, label %B1621.i

B80.i.i:                                          ; preds = %B46.i.i
  store i64 3, ptr %.120.i.i, align 8, !noalias !169
  br label %B1621.i

B1310.i:                                          ; preds = %B1082.i, %B1250.i.loopexit
  br i1 %.2633.i.not, label %B1398.i, label %B1314.i

B1314.i:                                          ; preds = %B1310.i
  %61 = getelementptr double, ptr %arg.arrays.4.4, i64 %.2739.i.04737
  %.3412.i = load double, ptr %61, align 8, !noalias !161
  %.3414.i = fcmp olt double %.3412.i, -1.000000e-09
  br i1 %.3414.i, label %B1350.i, label %B1398.i

B1350.i:                                          ; preds = %B1314.i
  %.84.i577.i = load i64, ptr %104, align 8, !noalias !172
  %.89.i580.i = icmp sgt i64 %.84.i577.i, -1
  br i1 %.89.i580.i, label %B46.i585.i, label %B1621.i

B46.i585.i:                                       ; preds = %B1350.i
  %.120.i606.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i577.i
  %.121.i607.i = load i64, ptr %.120.i606.i, align 8, !noalias !172
  %.122.i608.i = icmp eq i64 %.121.i607.i, 0
  br i1 %.122.i608.i, label %B80.i613.i, label %B1621.i

B80.i613.i:                                       ; preds = %B46.i585.i
  store i64 4, ptr %.120.i606.i, align 8, !noalias !172
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
  %wide.load4867 = load <2 x double>, ptr %64, align 8, !alias.scope !175, !noalias !161
  %wide.load4868 = load <2 x double>, ptr %65, align 8, !alias.scope !175, !noalias !161
  %66 = getelementptr i8, ptr %63, i64 16
  %wide.load4869 = load <2 x double>, ptr %63, align 8, !alias.scope !178, !noalias !180
  %wide.load4870 = load <2 x double>, ptr %66, align 8, !alias.scope !178, !noalias !180
  %67 = fsub <2 x double> %wide.load4869, %wide.load4867
  %68 = fsub <2 x double> %wide.load4870, %wide.load4868
  store <2 x double> %wide.load4867, ptr %63, align 8, !alias.scope !178, !noalias !180
  store <2 x double> %wide.load4868, ptr %66, align 8, !alias.scope !178, !noalias !180
  store <2 x double> %67, ptr %64, align 8, !alias.scope !175, !noalias !161
  store <2 x double> %68, ptr %65, align 8, !alias.scope !175, !noalias !161
  %index.next4871 = add i64 %index4866, 4
  %69 = icmp eq i64 %index.next4871, %n.vec4864
  br i1 %69, label %middle.block4872, label %vector.body4865, !llvm.loop !181

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
  br i1 %.693.i.not4707, label %.663.endif.i.preheader, label %B186.if.i.preheader, !prof !152

.663.endif.i.preheader:                           ; preds = %B0.endif.else.endif.endif.i
  %70 = sub i64 %arg.lane.0.5.1, %spec.select
  %min.iters.check4931 = icmp ult i64 %70, 4
  br i1 %min.iters.check4931, label %.663.endif.i.preheader4969, label %vector.ph4932, !prof !153

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
  store <2 x double> %broadcast.splat4936, ptr %73, align 8, !noalias !161
  store <2 x double> %broadcast.splat4936, ptr %74, align 8, !noalias !161
  %index.next4940 = add i64 %index4938, 4
  %75 = icmp eq i64 %index.next4940, %n.vec4934
  br i1 %75, label %middle.block4941, label %vector.body4937, !prof !154, !llvm.loop !182

middle.block4941:                                 ; preds = %vector.body4937
  %cmp.n4942 = icmp eq i64 %70, %n.vec4934
  br i1 %cmp.n4942, label %B186.if.i.preheader, label %.663.endif.i.preheader4969, !prof !157

.663.endif.i.preheader4969:                       ; preds = %.663.endif.i.preheader, %middle.block4941
  %.659.i.04708.ph = phi i64 [ %spec.select, %.663.endif.i.preheader ], [ %71, %middle.block4941 ]
  br label %.663.endif.i

.663.endif.i:                                     ; preds = %.663.endif.i.preheader4969, %.663.endif.i
  %.659.i.04708 = phi i64 [ %.707.i, %.663.endif.i ], [ %.659.i.04708.ph, %.663.endif.i.preheader4969 ]
  %.702.i = getelementptr double, ptr %27, i64 %.659.i.04708
  store double %.2510, ptr %.702.i, align 8, !noalias !161
  %.707.i = add nsw i64 %.659.i.04708, 1
  %exitcond4779.not = icmp eq i64 %.707.i, %arg.lane.0.5.1
  br i1 %exitcond4779.not, label %B186.if.i.preheader, label %.663.endif.i, !prof !158, !llvm.loop !183

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
  br i1 %.2065, label %B188.endif.else.endif.if.i, label %B188.endif.else.endif.endif.i, !prof !145

B188.endif.else.endif.if.i:                       ; preds = %B186.if.i
  br label %B188.endif.else.endif.endif.i

B188.endif.else.endif.endif.i:                    ; preds = %B188.endif.else.endif.if.i, %B186.if.i
  %spec.select4676 = phi i64 [ %arg.lane.0.5.1, %B188.endif.else.endif.if.i ], [ 0, %B186.if.i ]
  %.1178.i.not4709 = icmp slt i64 %spec.select4676, %arg.lane.0.5.1
  br i1 %.1178.i.not4709, label %.1148.endif.i.preheader, label %.1149.else.i, !prof !152

.1148.endif.i.preheader:                          ; preds = %B188.endif.else.endif.endif.i
  %76 = sub i64 %arg.lane.0.5.1, %spec.select4676
  %min.iters.check4917 = icmp ult i64 %76, 4
  br i1 %min.iters.check4917, label %.1148.endif.i.preheader4963, label %vector.ph4918, !prof !153

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
  store <2 x double> %broadcast.splat4922, ptr %79, align 8, !noalias !161
  store <2 x double> %broadcast.splat4922, ptr %80, align 8, !noalias !161
  %index.next4926 = add i64 %index4924, 4
  %81 = icmp eq i64 %index.next4926, %n.vec4920
  br i1 %81, label %middle.block4927, label %vector.body4923, !prof !154, !llvm.loop !184

middle.block4927:                                 ; preds = %vector.body4923
  %cmp.n4928 = icmp eq i64 %76, %n.vec4920
  br i1 %cmp.n4928, label %.1149.else.i, label %.1148.endif.i.preheader4963, !prof !157

.1148.endif.i.preheader4963:                      ; preds = %.1148.endif.i.preheader, %middle.block4927
  %.1144.i.04710.ph = phi i64 [ %spec.select4676, %.1148.endif.i.preheader ], [ %77, %middle.block4927 ]
  br label %.1148.endif.i

.1148.endif.i:                                    ; preds = %.1148.endif.i.preheader4963, %.1148.endif.i
  %.1144.i.04710 = phi i64 [ %.1192.i, %.1148.endif.i ], [ %.1144.i.04710.ph, %.1148.endif.i.preheader4963 ]
  %.1187.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1144.i.04710
  store double %.848.i, ptr %.1187.i, align 8, !noalias !161
  %.1192.i = add nsw i64 %.1144.i.04710, 1
  %exitcond4780.not = icmp eq i64 %.1192.i, %arg.lane.0.5.1
  br i1 %exitcond4780.not, label %.1149.else.i, label %.1148.endif.i, !prof !158, !llvm.loop !185

.1149.else.i:                                     ; preds = %.1148.endif.i, %middle.block4927, %B188.endif.else.endif.endif.i
  br i1 %.2065, label %.1149.endif.else.endif.if.i, label %.1149.endif.else.endif.endif.i, !prof !145

.1149.endif.else.endif.if.i:                      ; preds = %.1149.else.i
  br label %.1149.endif.else.endif.endif.i

.1149.endif.else.endif.endif.i:                   ; preds = %.1149.endif.else.endif.if.i, %.1149.else.i
  %spec.select4677 = phi i64 [ %arg.lane.0.5.1, %.1149.endif.else.endif.if.i ], [ 0, %.1149.else.i ]
  %.1521.i.not4711 = icmp slt i64 %spec.select4677, %arg.lane.0.5.1
  br i1 %.1521.i.not4711, label %.1491.endif.i.preheader, label %.1491.if.i, !prof !152

.1491.endif.i.preheader:                          ; preds = %.1149.endif.else.endif.endif.i
  %82 = sub i64 %arg.lane.0.5.1, %spec.select4677
  %min.iters.check4903 = icmp ult i64 %82, 4
  br i1 %min.iters.check4903, label %.1491.endif.i.preheader4962, label %vector.ph4904, !prof !153

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
  store <2 x double> %broadcast.splat4908, ptr %85, align 8, !noalias !161
  store <2 x double> %broadcast.splat4908, ptr %86, align 8, !noalias !161
  %index.next4912 = add i64 %index4910, 4
  %87 = icmp eq i64 %index.next4912, %n.vec4906
  br i1 %87, label %middle.block4913, label %vector.body4909, !prof !154, !llvm.loop !186

middle.block4913:                                 ; preds = %vector.body4909
  %cmp.n4914 = icmp eq i64 %82, %n.vec4906
  br i1 %cmp.n4914, label %.1491.if.i, label %.1491.endif.i.preheader4962, !prof !157

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
  %wide.load4896 = load <2 x double>, ptr %88, align 8, !noalias !161
  %wide.load4897 = load <2 x double>, ptr %89, align 8, !noalias !161
  %90 = getelementptr i8, ptr %88, i64 %41
  %91 = getelementptr i8, ptr %90, i64 16
  store <2 x double> %wide.load4896, ptr %90, align 8, !noalias !161
  store <2 x double> %wide.load4897, ptr %91, align 8, !noalias !161
  %index.next4898 = add i64 %index4895, 4
  %92 = icmp eq i64 %index.next4898, %n.vec4893
  br i1 %92, label %middle.block4899, label %vector.body4894, !llvm.loop !187

middle.block4899:                                 ; preds = %vector.body4894
  br i1 %cmp.n4900, label %B358.i, label %B308.if.i.preheader4961

B308.if.i.preheader4961:                          ; preds = %B308.if.i.preheader, %middle.block4899
  %.1565.i.04714.ph = phi i64 [ 0, %B308.if.i.preheader ], [ %n.vec4893, %middle.block4899 ]
  br label %B308.if.i

.1491.endif.i:                                    ; preds = %.1491.endif.i.preheader4962, %.1491.endif.i
  %.1487.i.04712 = phi i64 [ %.1535.i, %.1491.endif.i ], [ %.1487.i.04712.ph, %.1491.endif.i.preheader4962 ]
  %.1530.i = getelementptr double, ptr %23, i64 %.1487.i.04712
  store double %.854.i, ptr %.1530.i, align 8, !noalias !161
  %.1535.i = add nsw i64 %.1487.i.04712, 1
  %exitcond4781.not = icmp eq i64 %.1535.i, %arg.lane.0.5.1
  br i1 %exitcond4781.not, label %.1491.if.i, label %.1491.endif.i, !prof !158, !llvm.loop !188

B308.if.i:                                        ; preds = %B308.if.i.preheader4961, %B308.if.i
  %.1565.i.04714 = phi i64 [ %.1634.i, %B308.if.i ], [ %.1565.i.04714.ph, %B308.if.i.preheader4961 ]
  %.1634.i = add nsw i64 %.1565.i.04714, 1
  %93 = getelementptr double, ptr %arg.arrays.0.4, i64 %.1565.i.04714
  %.1688.i = load double, ptr %93, align 8, !noalias !161
  %gep4978 = getelementptr double, ptr %invariant.gep4977, i64 %.1565.i.04714
  store double %.1688.i, ptr %gep4978, align 8, !noalias !161
  %exitcond4782.not = icmp eq i64 %.223.i, %.1634.i
  br i1 %exitcond4782.not, label %B358.i, label %B308.if.i, !llvm.loop !189

B370.else.i:                                      ; preds = %B358.i
  br i1 %.2065, label %B370.endif.else.endif.if.i, label %B370.endif.else.endif.endif.i, !prof !145

B370.endif.else.endif.if.i:                       ; preds = %B370.else.i
  br label %B370.endif.else.endif.endif.i

B370.endif.else.endif.endif.i:                    ; preds = %B370.endif.else.endif.if.i, %B370.else.i
  %spec.select4678 = phi i64 [ %arg.lane.0.5.1, %B370.endif.else.endif.if.i ], [ 0, %B370.else.i ]
  %.2053.i.not4716 = icmp slt i64 %spec.select4678, %arg.lane.0.5.1
  br i1 %.2053.i.not4716, label %.2023.endif.i.preheader, label %.2023.if.i, !prof !152

.2023.endif.i.preheader:                          ; preds = %B370.endif.else.endif.endif.i
  %94 = sub i64 %arg.lane.0.5.1, %spec.select4678
  %min.iters.check4876 = icmp ult i64 %94, 4
  br i1 %min.iters.check4876, label %.2023.endif.i.preheader4960, label %vector.ph4877, !prof !153

vector.ph4877:                                    ; preds = %.2023.endif.i.preheader
  %n.vec4879 = and i64 %94, -4
  %95 = add i64 %spec.select4678, %n.vec4879
  %96 = getelementptr double, ptr %24, i64 %spec.select4678
  br label %vector.body4880

vector.body4880:                                  ; preds = %vector.body4880, %vector.ph4877
  %index4881 = phi i64 [ 0, %vector.ph4877 ], [ %index.next4883, %vector.body4880 ]
  %97 = getelementptr double, ptr %96, i64 %index4881
  %98 = getelementptr i8, ptr %97, i64 16
  store <2 x double> splat (double 1.000000e+00), ptr %97, align 8, !noalias !161
  store <2 x double> splat (double 1.000000e+00), ptr %98, align 8, !noalias !161
  %index.next4883 = add i64 %index4881, 4
  %99 = icmp eq i64 %index.next4883, %n.vec4879
  br i1 %99, label %middle.block4884, label %vector.body4880, !prof !154, !llvm.loop !190

middle.block4884:                                 ; preds = %vector.body4880
  %cmp.n4885 = icmp eq i64 %94, %n.vec4879
  br i1 %cmp.n4885, label %.2023.if.i, label %.2023.endif.i.preheader4960, !prof !157

.2023.endif.i.preheader4960:                      ; preds = %.2023.endif.i.preheader, %middle.block4884
  %.2019.i.04717.ph = phi i64 [ %spec.select4678, %.2023.endif.i.preheader ], [ %95, %middle.block4884 ]
  br label %.2023.endif.i

B248.i.i:                                         ; preds = %B190.if.i.i, %B118.if.i.i
  %exitcond4785.not = icmp eq i64 %arg.shape.0, %.292.i.i
  br i1 %exitcond4785.not, label %B250.i.i, label %B118.if.i.i

B250.i.i:                                         ; preds = %B248.i.i, %.2023.if.i
  %.614.i.i = load i64, ptr %.2211, align 8, !noalias !191
  %.661.i.i = inttoptr i64 %.614.i.i to ptr
  tail call void %.661.i.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !191
  br label %B442.i

B118.if.i.i:                                      ; preds = %.2023.if.i, %B248.i.i
  %.221.i.i.04723 = phi i64 [ %.292.i.i, %B248.i.i ], [ 0, %.2023.if.i ]
  %.292.i.i = add nsw i64 %.221.i.i.04723, 1
  %100 = getelementptr double, ptr %25, i64 %.221.i.i.04723
  %.374.i.i = load double, ptr %100, align 8, !noalias !191
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
  %.528.i.i = load double, ptr %gep4980, align 8, !noalias !191
  %.530.i.i = add nsw i64 %.401.i.i.04719, %arg.held
  %.532.i.i = mul nsw i64 %.530.i.i, %arg.shape.0
  %.534.i.i = add nsw i64 %.532.i.i, %.221.i.i.04723
  %.548.i.i = icmp slt i64 %.534.i.i, 0
  %.549.i.i = select i1 %.548.i.i, i64 %arg.arrays.1.5.0, i64 0
  %101 = getelementptr double, ptr %arg.arrays.1.4, i64 %.534.i.i
  %.563.i.i = getelementptr double, ptr %101, i64 %.549.i.i
  store double %.528.i.i, ptr %.563.i.i, align 8, !noalias !191
  %exitcond4784.not = icmp eq i64 %.470.i.i, %arg.decided
  br i1 %exitcond4784.not, label %B248.i.i, label %B190.if.i.i

.2023.if.i:                                       ; preds = %.2023.endif.i, %middle.block4884, %B370.endif.else.endif.endif.i
  %.150.i.i = load i64, ptr %.149.i.i, align 8, !noalias !191
  %.195.i.i = inttoptr i64 %.150.i.i to ptr
  tail call void %.195.i.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !191
  br i1 %.279.i.i4721.not, label %B250.i.i, label %B118.if.i.i

.2023.endif.i:                                    ; preds = %.2023.endif.i.preheader4960, %.2023.endif.i
  %.2019.i.04717 = phi i64 [ %.2067.i, %.2023.endif.i ], [ %.2019.i.04717.ph, %.2023.endif.i.preheader4960 ]
  %.2062.i = getelementptr double, ptr %24, i64 %.2019.i.04717
  store double 1.000000e+00, ptr %.2062.i, align 8, !noalias !161
  %.2067.i = add nsw i64 %.2019.i.04717, 1
  %exitcond4783.not = icmp eq i64 %.2067.i, %arg.lane.0.5.1
  br i1 %exitcond4783.not, label %.2023.if.i, label %.2023.endif.i, !prof !158, !llvm.loop !195

B558.if.i:                                        ; preds = %B442.i, %B708.i
  %.2230.i.04730 = phi i64 [ 1, %B442.i ], [ %.2299.i, %B708.i ]
  %.2299.i = add nsw i64 %.2230.i.04730, 1
  %102 = getelementptr i64, ptr %arg.code.4, i64 %.2230.i.04730
  %103 = getelementptr i8, ptr %102, i64 224
  %.2358.i = load i64, ptr %103, align 8, !noalias !161
  %.2403.i = inttoptr i64 %.2358.i to ptr
  tail call void %.2403.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !161
  br i1 %.1728.i, label %B648.i, label %B708.i

B996.if.i:                                        ; preds = %B962.i, %B1621.i
  %active.3.i.14739 = phi i64 [ %active.4.i.2, %B1621.i ], [ 0, %B962.i ]
  %.2739.i.04737 = phi i64 [ %.2808.i, %B1621.i ], [ 0, %B962.i ]
  %.2808.i = add nsw i64 %.2739.i.04737, 1
  %104 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2739.i.04737
  %.2890.i = load i64, ptr %104, align 8, !noalias !161
  %.2898.i = icmp slt i64 %.2890.i, 0
  br i1 %.2898.i, label %B1621.i, label %B1046.i

B1204.if.i:                                       ; preds = %B1204.if.i.preheader, %B1204.if.i
  %trouble.2.i.34735 = phi double [ %.3324.i, %B1204.if.i ], [ 0.000000e+00, %B1204.if.i.preheader ]
  %.3194.i.04733 = phi i64 [ %.3263.i, %B1204.if.i ], [ 0, %B1204.if.i.preheader ]
  %.3263.i = add nsw i64 %.3194.i.04733, 1
  %105 = mul nsw i64 %.3194.i.04733, %arg.shape.0
  %gep4984 = getelementptr double, ptr %invariant.gep4983, i64 %105
  %.3321.i = load double, ptr %gep4984, align 8, !noalias !161
  %.3322.i = fmul double %.3321.i, 0.000000e+00
  %.3324.i = fadd double %trouble.2.i.34735, %.3322.i
  %exitcond4789.not = icmp eq i64 %arg.shape.1, %.3263.i
  br i1 %exitcond4789.not, label %B1250.i.loopexit, label %B1204.if.i

B1484.if.i:                                       ; preds = %B1484.if.i.preheader4968, %B1484.if.i
  %.3596.i.04744 = phi i64 [ %.3665.i, %B1484.if.i ], [ %.3596.i.04744.ph, %B1484.if.i.preheader4968 ]
  %.3665.i = add nsw i64 %.3596.i.04744, 1
  %gep4986 = getelementptr double, ptr %invariant.gep4985, i64 %.3596.i.04744
  %.3722.i = load double, ptr %gep4986, align 8, !noalias !161
  %106 = getelementptr double, ptr %arg.arrays.0.4, i64 %.3596.i.04744
  %.3752.i = load double, ptr %106, align 8, !noalias !161
  %.3786.i = fsub double %.3752.i, %.3722.i
  store double %.3722.i, ptr %106, align 8, !noalias !161
  store double %.3786.i, ptr %gep4986, align 8, !noalias !161
  %exitcond4791.not = icmp eq i64 %arg.shape.1, %.3665.i
  br i1 %exitcond4791.not, label %B906.endif.endif.endif.endif.endif, label %B1484.if.i, !llvm.loop !196

B906.endif.endif.endif.endif.endif:               ; preds = %B1484.if.i, %middle.block4872, %B1430.i
  br i1 %active.3.i.1.lcssa, label %B1158, label %B1536

B1194.else.endif:                                 ; preds = %B1166
  br i1 %.2065, label %B1194.endif.else.endif.if, label %B1194.endif.else.endif.endif.endif.if, !prof !145

B1194.endif.else.endif.if:                        ; preds = %B1194.else.endif
  br label %B1194.endif.else.endif.endif.endif.if

B1194.endif.else.endif.endif.endif.if:            ; preds = %B1194.endif.else.endif.if, %B1194.else.endif
  %.2882.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %B1194.endif.else.endif.if ], [ 0, %B1194.else.endif ]
  %.3006.not4746 = icmp slt i64 %.2882.sroa.0.3, %arg.lane.0.5.1
  br i1 %.3006.not4746, label %.2976.endif.preheader, label %.2977.else.endif, !prof !152

.2976.endif.preheader:                            ; preds = %B1194.endif.else.endif.endif.endif.if
  %107 = sub i64 %arg.lane.0.5.1, %.2882.sroa.0.3
  %min.iters.check4843 = icmp ult i64 %107, 4
  br i1 %min.iters.check4843, label %.2976.endif.preheader4967, label %vector.ph4844, !prof !153

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
  br i1 %112, label %middle.block4853, label %vector.body4849, !prof !154, !llvm.loop !197

middle.block4853:                                 ; preds = %vector.body4849
  %cmp.n4854 = icmp eq i64 %107, %n.vec4846
  br i1 %cmp.n4854, label %.2977.else.endif, label %.2976.endif.preheader4967, !prof !157

.2976.endif.preheader4967:                        ; preds = %.2976.endif.preheader, %middle.block4853
  %.2972.04747.ph = phi i64 [ %.2882.sroa.0.3, %.2976.endif.preheader ], [ %108, %middle.block4853 ]
  br label %.2976.endif

.2976.endif:                                      ; preds = %.2976.endif.preheader4967, %.2976.endif
  %.2972.04747 = phi i64 [ %.3020, %.2976.endif ], [ %.2972.04747.ph, %.2976.endif.preheader4967 ]
  %.3015 = getelementptr double, ptr %arg.lane.0.4, i64 %.2972.04747
  store double %.11.i4679, ptr %.3015, align 8
  %.3020 = add nsw i64 %.2972.04747, 1
  %exitcond4792.not = icmp eq i64 %.3020, %arg.lane.0.5.1
  br i1 %exitcond4792.not, label %.2977.else.endif, label %.2976.endif, !prof !158, !llvm.loop !198

.2977.else.endif:                                 ; preds = %.2976.endif, %middle.block4853, %B1194.endif.else.endif.endif.endif.if
  br i1 %.2065, label %.2977.endif.else.endif.if, label %.2977.endif.else.endif.endif.endif.if, !prof !145

.2977.endif.else.endif.if:                        ; preds = %.2977.else.endif
  br label %.2977.endif.else.endif.endif.endif.if

.2977.endif.else.endif.endif.endif.if:            ; preds = %.2977.endif.else.endif.if, %.2977.else.endif
  %.3226.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %.2977.endif.else.endif.if ], [ 0, %.2977.else.endif ]
  %.3350.not4748 = icmp slt i64 %.3226.sroa.0.3, %arg.lane.0.5.1
  br i1 %.3350.not4748, label %.3320.endif.preheader, label %.3321.else.endif, !prof !152

.3320.endif.preheader:                            ; preds = %.2977.endif.else.endif.endif.endif.if
  %113 = sub i64 %arg.lane.0.5.1, %.3226.sroa.0.3
  %min.iters.check4829 = icmp ult i64 %113, 4
  br i1 %min.iters.check4829, label %.3320.endif.preheader4966, label %vector.ph4830, !prof !153

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
  br i1 %118, label %middle.block4839, label %vector.body4835, !prof !154, !llvm.loop !199

middle.block4839:                                 ; preds = %vector.body4835
  %cmp.n4840 = icmp eq i64 %113, %n.vec4832
  br i1 %cmp.n4840, label %.3321.else.endif, label %.3320.endif.preheader4966, !prof !157

.3320.endif.preheader4966:                        ; preds = %.3320.endif.preheader, %middle.block4839
  %.3316.04749.ph = phi i64 [ %.3226.sroa.0.3, %.3320.endif.preheader ], [ %114, %middle.block4839 ]
  br label %.3320.endif

.3320.endif:                                      ; preds = %.3320.endif.preheader4966, %.3320.endif
  %.3316.04749 = phi i64 [ %.3364, %.3320.endif ], [ %.3316.04749.ph, %.3320.endif.preheader4966 ]
  %.3359 = getelementptr double, ptr %28, i64 %.3316.04749
  store double %.11.i4679, ptr %.3359, align 8
  %.3364 = add nsw i64 %.3316.04749, 1
  %exitcond4793.not = icmp eq i64 %.3364, %arg.lane.0.5.1
  br i1 %exitcond4793.not, label %.3321.else.endif, label %.3320.endif, !prof !158, !llvm.loop !200

.3321.else.endif:                                 ; preds = %.3320.endif, %middle.block4839, %.2977.endif.else.endif.endif.endif.if
  br i1 %.2065, label %.3321.endif.else.endif.if, label %.3321.endif.else.endif.endif.endif.if, !prof !145

.3321.endif.else.endif.if:                        ; preds = %.3321.else.endif
  br label %.3321.endif.else.endif.endif.endif.if

.3321.endif.else.endif.endif.endif.if:            ; preds = %.3321.endif.else.endif.if, %.3321.else.endif
  %.3569.sroa.0.3 = phi i64 [ %arg.lane.0.5.1, %.3321.endif.else.endif.if ], [ 0, %.3321.else.endif ]
  %.3693.not4750 = icmp slt i64 %.3569.sroa.0.3, %arg.lane.0.5.1
  br i1 %.3693.not4750, label %.3663.endif.preheader, label %.3664.else.endif, !prof !152

.3663.endif.preheader:                            ; preds = %.3321.endif.else.endif.endif.endif.if
  %119 = sub i64 %arg.lane.0.5.1, %.3569.sroa.0.3
  %min.iters.check4817 = icmp ult i64 %119, 4
  br i1 %min.iters.check4817, label %.3663.endif.preheader4965, label %vector.ph4818, !prof !153

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
  br i1 %124, label %middle.block4825, label %vector.body4821, !prof !154, !llvm.loop !201

middle.block4825:                                 ; preds = %vector.body4821
  %cmp.n4826 = icmp eq i64 %119, %n.vec4820
  br i1 %cmp.n4826, label %.3664.else.endif, label %.3663.endif.preheader4965, !prof !157

.3663.endif.preheader4965:                        ; preds = %.3663.endif.preheader, %middle.block4825
  %.3659.04751.ph = phi i64 [ %.3569.sroa.0.3, %.3663.endif.preheader ], [ %120, %middle.block4825 ]
  br label %.3663.endif

.3663.endif:                                      ; preds = %.3663.endif.preheader4965, %.3663.endif
  %.3659.04751 = phi i64 [ %.3707, %.3663.endif ], [ %.3659.04751.ph, %.3663.endif.preheader4965 ]
  %.3702 = getelementptr double, ptr %29, i64 %.3659.04751
  store double 1.000000e+00, ptr %.3702, align 8
  %.3707 = add nsw i64 %.3659.04751, 1
  %exitcond4794.not = icmp eq i64 %.3707, %arg.lane.0.5.1
  br i1 %exitcond4794.not, label %.3664.else.endif, label %.3663.endif, !prof !158, !llvm.loop !202

.3664.else.endif:                                 ; preds = %.3663.endif, %middle.block4825, %.3321.endif.else.endif.endif.endif.if
  br i1 %.3941, label %.3664.endif.else.endif.if, label %.3664.endif.else.endif.endif.endif.if, !prof !145

.3664.endif.else.endif.if:                        ; preds = %.3664.else.endif
  br label %.3664.endif.else.endif.endif.endif.if

.3664.endif.else.endif.endif.endif.if:            ; preds = %.3664.endif.else.endif.if, %.3664.else.endif
  %.3913.sroa.0.3 = phi i64 [ %arg.lane.1.5.1, %.3664.endif.else.endif.if ], [ 0, %.3664.else.endif ]
  %.4037.not4752 = icmp slt i64 %.3913.sroa.0.3, %arg.lane.1.5.1
  br i1 %.4037.not4752, label %.4007.endif.preheader, label %.4008.else.endif, !prof !152

.4007.endif.preheader:                            ; preds = %.3664.endif.else.endif.endif.endif.if
  %125 = sub i64 %arg.lane.1.5.1, %.3913.sroa.0.3
  %min.iters.check4806 = icmp ult i64 %125, 4
  br i1 %min.iters.check4806, label %.4007.endif.preheader4964, label %vector.ph4807, !prof !153

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
  br i1 %130, label %middle.block4813, label %vector.body4810, !prof !154, !llvm.loop !203

middle.block4813:                                 ; preds = %vector.body4810
  %cmp.n4814 = icmp eq i64 %125, %n.vec4809
  br i1 %cmp.n4814, label %.4008.else.endif, label %.4007.endif.preheader4964, !prof !157

.4007.endif.preheader4964:                        ; preds = %.4007.endif.preheader, %middle.block4813
  %.4003.04753.ph = phi i64 [ %.3913.sroa.0.3, %.4007.endif.preheader ], [ %126, %middle.block4813 ]
  br label %.4007.endif

.4007.endif:                                      ; preds = %.4007.endif.preheader4964, %.4007.endif
  %.4003.04753 = phi i64 [ %.4051, %.4007.endif ], [ %.4003.04753.ph, %.4007.endif.preheader4964 ]
  %.4046 = getelementptr i64, ptr %30, i64 %.4003.04753
  store i64 %edge.2.1, ptr %.4046, align 8
  %.4051 = add nsw i64 %.4003.04753, 1
  %exitcond4795.not = icmp eq i64 %.4051, %arg.lane.1.5.1
  br i1 %exitcond4795.not, label %.4008.else.endif, label %.4007.endif, !prof !158, !llvm.loop !204

.4008.else.endif:                                 ; preds = %.4007.endif, %middle.block4813, %.3664.endif.else.endif.endif.endif.if
  br i1 %.3941, label %.4008.endif.else.endif.if, label %.4008.endif.else.endif.endif.endif.if, !prof !145

.4008.endif.else.endif.if:                        ; preds = %.4008.else.endif
  br label %.4008.endif.else.endif.endif.endif.if

.4008.endif.else.endif.endif.endif.if:            ; preds = %.4008.endif.else.endif.if, %.4008.else.endif
  %.4256.sroa.0.3 = phi i64 [ %arg.lane.1.5.1, %.4008.endif.else.endif.if ], [ 0, %.4008.else.endif ]
  %.4380.not4754 = icmp slt i64 %.4256.sroa.0.3, %arg.lane.1.5.1
  br i1 %.4380.not4754, label %.4350.endif.preheader, label %.4350.if, !prof !152

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
  %.136.i.i = load i64, ptr %.135.i.i, align 8, !noalias !205
  %.141.i.not.i = icmp eq i64 %.136.i.i, 0
  br i1 %.141.i.not.i, label %B80.i.i4686, label %B358.i4685

B80.i.i4686:                                      ; preds = %B46.i.i4684
  %.196.i.i = getelementptr double, ptr %31, i64 %.352.01856.i
  %.197.i.i = load double, ptr %.196.i.i, align 8, !noalias !205
  %.198.i.i = fcmp olt double %.197.i.i, 5.000000e-01
  br i1 %.198.i.i, label %B358.i4685, label %B122.i.i

B122.i.i:                                         ; preds = %B80.i.i4686
  %.264.i.i = getelementptr double, ptr %arg.lane.0.4, i64 %.352.01856.i
  %.265.i.i = load double, ptr %.264.i.i, align 8, !noalias !205
  %.321.i.i = getelementptr double, ptr %32, i64 %.352.01856.i
  %.322.i.i = load double, ptr %.321.i.i, align 8, !noalias !205
  %.325.i.i = fcmp une double %.265.i.i, %.322.i.i
  %brmerge.i = select i1 %.325.i.i, i1 true, i1 %.1468
  %not..325.i.i = xor i1 %.325.i.i, true
  %some.2.01858.mux.i = select i1 %not..325.i.i, i1 true, i1 %some.2.01858.i
  br i1 %brmerge.i, label %B358.i4685, label %B300.if.lr.ph.i

B300.if.lr.ph.i:                                  ; preds = %B122.i.i
  %.650.i = getelementptr i64, ptr %33, i64 %.352.01856.i
  %.651.i = load i64, ptr %.650.i, align 8, !noalias !210
  %.652.i = add nsw i64 %.651.i, 1
  %134 = getelementptr i64, ptr %arg.runs.2.4, i64 %.99.i.i
  %.596.i = load i64, ptr %134, align 8, !noalias !210
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
  %.1018.i = load i64, ptr %.2211, align 8, !noalias !210
  %.1130.i = inttoptr i64 %.1018.i to ptr
  tail call void %.1130.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !210
  %.1161.i = load i64, ptr %.1160.i, align 8, !noalias !210
  %.1277.i = inttoptr i64 %.1161.i to ptr
  tail call void %.1277.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %.1276.i), !noalias !210
  br label %B600.if.i

B46.i82.i:                                        ; preds = %B600.if.i
  %.135.i102.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i78.i
  %.136.i103.i = load i64, ptr %.135.i102.i, align 8, !noalias !211
  %.141.i106.not.i = icmp eq i64 %.136.i103.i, 0
  br i1 %.141.i106.not.i, label %B80.i107.i, label %B980.i

B80.i107.i:                                       ; preds = %B46.i82.i
  %.196.i144.i = getelementptr double, ptr %31, i64 %.1303.01865.i
  %.197.i145.i = load double, ptr %.196.i144.i, align 8, !noalias !211
  %.198.i146.i = fcmp olt double %.197.i145.i, 5.000000e-01
  br i1 %.198.i146.i, label %B980.i, label %B122.i147.i

B122.i147.i:                                      ; preds = %B80.i107.i
  %.264.i184.i = getelementptr double, ptr %arg.lane.0.4, i64 %.1303.01865.i
  %.265.i185.i = load double, ptr %.264.i184.i, align 8, !noalias !211
  %.321.i223.i = getelementptr double, ptr %32, i64 %.1303.01865.i
  %.322.i224.i = load double, ptr %.321.i223.i, align 8, !noalias !211
  %.325.i226.i = fcmp une double %.265.i185.i, %.322.i224.i
  br i1 %.325.i226.i, label %B980.i, label %B640.i

B640.i:                                           ; preds = %B122.i147.i
  %.1557.i = getelementptr i64, ptr %34, i64 %.1303.01865.i
  %.1558.i = load i64, ptr %.1557.i, align 8, !noalias !210
  %.1569.i = icmp sgt i64 %.1558.i, 0
  br i1 %.1569.i, label %B716.i, label %B770.i

B716.i:                                           ; preds = %B640.i
  %137 = getelementptr double, ptr %arg.times.4, i64 %.1558.i
  %.1604.i = getelementptr i8, ptr %137, i64 -8
  %.1605.i = load double, ptr %.1604.i, align 8, !noalias !210
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
  store double %.1835.i, ptr %140, align 8, !noalias !210
  br label %B920.i

B920.i:                                           ; preds = %B802.if.i, %B898.i
  %exitcond1871.not.i = icmp eq i64 %arg.shape.1, %.1770.i
  br i1 %exitcond1871.not.i, label %B922.loopexit.i, label %B802.if.i

B922.loopexit.i:                                  ; preds = %B920.i
  %141 = fcmp une double %.1842.i, 0.000000e+00
  br i1 %141, label %B934.i, label %B980.i

B934.i:                                           ; preds = %B922.loopexit.i
  %.84.i516.i = load i64, ptr %147, align 8, !noalias !214
  %.89.i518.i = icmp sgt i64 %.84.i516.i, -1
  br i1 %.89.i518.i, label %B46.i521.i, label %B980.i

B46.i521.i:                                       ; preds = %B934.i
  %.120.i539.i = getelementptr i64, ptr %arg.results.1.4, i64 %.84.i516.i
  %.121.i540.i = load i64, ptr %.120.i539.i, align 8, !noalias !214
  %.122.i541.i = icmp eq i64 %.121.i540.i, 0
  br i1 %.122.i541.i, label %B80.i545.i, label %B980.i

B80.i545.i:                                       ; preds = %B46.i521.i
  store i64 3, ptr %.120.i539.i, align 8, !noalias !214
  br label %B980.i

B980.i:                                           ; preds = %B600.if.i, %B80.i545.i, %B46.i521.i, %B934.i, %B922.loopexit.i, %B770.i, %B122.i147.i, %B80.i107.i, %B46.i82.i
  %exitcond1872.not.i = icmp eq i64 %arg.shape.0, %.1372.i
  br i1 %exitcond1872.not.i, label %B982.i, label %B600.if.i

B982.i:                                           ; preds = %B980.i
  br i1 %.2041.not.i, label %B1384, label %B986.i

B986.i:                                           ; preds = %B982.i
  %.2074.i = load i64, ptr %.2073.i, align 8, !noalias !210
  %.2188.i = inttoptr i64 %.2074.i to ptr
  tail call void %.2188.i(ptr %arg.lane.0.4, ptr %arg.arrays.0.4, ptr %arg.arrays.1.4, ptr %arg.arrays.2.4, ptr %arg.arrays.3.4, ptr %arg.arrays.4.4), !noalias !210
  br label %B1106.if.i

B46.i315.i:                                       ; preds = %B1106.if.i
  %.135.i335.i = getelementptr i64, ptr %arg.results.1.4, i64 %.99.i311.i
  %.136.i336.i = load i64, ptr %.135.i335.i, align 8, !noalias !217
  %.141.i339.not.i = icmp eq i64 %.136.i336.i, 0
  br i1 %.141.i339.not.i, label %B80.i340.i, label %B1228.i

B80.i340.i:                                       ; preds = %B46.i315.i
  %.196.i377.i = getelementptr double, ptr %31, i64 %.2224.01868.i
  %.197.i378.i = load double, ptr %.196.i377.i, align 8, !noalias !217
  %.198.i379.i = fcmp olt double %.197.i378.i, 5.000000e-01
  br i1 %.198.i379.i, label %B1228.i, label %B122.i380.i

B122.i380.i:                                      ; preds = %B80.i340.i
  %.264.i417.i = getelementptr double, ptr %arg.lane.0.4, i64 %.2224.01868.i
  %.265.i418.i = load double, ptr %.264.i417.i, align 8, !noalias !217
  %.321.i456.i = getelementptr double, ptr %32, i64 %.2224.01868.i
  %.322.i457.i = load double, ptr %.321.i456.i, align 8, !noalias !217
  %.325.i459.i = fcmp une double %.265.i418.i, %.322.i457.i
  br i1 %.325.i459.i, label %B1228.i, label %B1146.i

B1146.i:                                          ; preds = %B122.i380.i
  %142 = getelementptr double, ptr %arg.arrays.4.4, i64 %.2224.01868.i
  %.2400.i = load double, ptr %142, align 8, !noalias !210
  %.2402.i = fcmp olt double %.2400.i, -1.000000e-09
  br i1 %.2402.i, label %B80.i672.i, label %B1228.i

B80.i672.i:                                       ; preds = %B1146.i
  store i64 4, ptr %.135.i335.i, align 8, !noalias !220
  br label %B1228.i

B1228.i:                                          ; preds = %B1106.if.i, %B80.i672.i, %B1146.i, %B122.i380.i, %B80.i340.i, %B46.i315.i
  %exitcond4797.not = icmp eq i64 %arg.shape.0, %.2293.i
  br i1 %exitcond4797.not, label %B1384, label %B1106.if.i

B110.if.i:                                        ; preds = %.4350.if, %B358.i4685
  %some.2.01858.i = phi i1 [ %some.3.2.i, %B358.i4685 ], [ false, %.4350.if ]
  %.352.01856.i = phi i64 [ %.423.i, %B358.i4685 ], [ 0, %.4350.if ]
  %.423.i = add nsw i64 %.352.01856.i, 1
  %143 = getelementptr i64, ptr %arg.lane.1.4, i64 %.352.01856.i
  %.99.i.i = load i64, ptr %143, align 8, !noalias !205
  %.104.i.i = icmp slt i64 %.99.i.i, 0
  br i1 %.104.i.i, label %B358.i4685, label %B46.i.i4684

B300.if.i:                                        ; preds = %B300.if.i, %B300.if.lr.ph.i
  %.692.01853.i = phi i64 [ 0, %B300.if.lr.ph.i ], [ %.764.i, %B300.if.i ]
  %.764.i = add nsw i64 %.692.01853.i, 1
  %144 = getelementptr double, ptr %136, i64 %.692.01853.i
  %.861.i = load double, ptr %144, align 8, !noalias !210
  %145 = getelementptr i64, ptr %arg.schedule.2.4, i64 %.692.01853.i
  %.891.i = load i64, ptr %145, align 8, !noalias !210
  %.893.i = mul nsw i64 %.891.i, %arg.shape.0
  %.895.i = add nsw i64 %.893.i, %.352.01856.i
  %.909.i = icmp slt i64 %.895.i, 0
  %.910.i = select i1 %.909.i, i64 %arg.arrays.1.5.0, i64 0
  %146 = getelementptr double, ptr %arg.arrays.1.4, i64 %.895.i
  %.924.i = getelementptr double, ptr %146, i64 %.910.i
  store double %.861.i, ptr %.924.i, align 8, !noalias !210
  %exitcond.not.i4688 = icmp eq i64 %arg.schedule.2.5.0, %.764.i
  br i1 %exitcond.not.i4688, label %B358.i4685, label %B300.if.i

B600.if.i:                                        ; preds = %B980.i, %B368.i
  %.1303.01865.i = phi i64 [ 0, %B368.i ], [ %.1372.i, %B980.i ]
  %.1372.i = add nsw i64 %.1303.01865.i, 1
  %147 = getelementptr i64, ptr %arg.lane.1.4, i64 %.1303.01865.i
  %.99.i78.i = load i64, ptr %147, align 8, !noalias !211
  %.104.i81.i = icmp slt i64 %.99.i78.i, 0
  br i1 %.104.i81.i, label %B980.i, label %B46.i82.i

B802.if.i:                                        ; preds = %B920.i, %B802.if.lr.ph.i
  %trouble.2.11862.i = phi double [ 0.000000e+00, %B802.if.lr.ph.i ], [ %.1842.i, %B920.i ]
  %.1701.01860.i = phi i64 [ 0, %B802.if.lr.ph.i ], [ %.1770.i, %B920.i ]
  %.1770.i = add nsw i64 %.1701.01860.i, 1
  %.1801.i = add nsw i64 %.1701.01860.i, %.1231.i
  %.1803.i = mul nsw i64 %.1801.i, %arg.shape.0
  %gep = getelementptr double, ptr %invariant.gep, i64 %.1803.i
  %.1835.i = load double, ptr %gep, align 8, !noalias !210
  %.1840.i = fmul double %.1835.i, 0.000000e+00
  %.1842.i = fadd double %trouble.2.11862.i, %.1840.i
  %.1850.i = mul nsw i64 %.1701.01860.i, %arg.shape.0
  %gep4757 = getelementptr double, ptr %invariant.gep4756, i64 %.1850.i
  store double %.1835.i, ptr %gep4757, align 8, !noalias !210
  br i1 %"$phi770.1.2.1.i", label %B898.i, label %B920.i

B1106.if.i:                                       ; preds = %B1228.i, %B986.i
  %.2224.01868.i = phi i64 [ 0, %B986.i ], [ %.2293.i, %B1228.i ]
  %.2293.i = add nsw i64 %.2224.01868.i, 1
  %148 = getelementptr i64, ptr %arg.lane.1.4, i64 %.2224.01868.i
  %.99.i311.i = load i64, ptr %148, align 8, !noalias !217
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
  br i1 %8, label %middle.block, label %vector.body, !llvm.loop !223

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
  br i1 %exitcond540.not, label %B64.loopexit, label %B430.if, !llvm.loop !224
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
!29 = !{!30}
!30 = distinct !{!30, !31, !"_ZN12clpt_control6native9for_numba9lineariseB2v9B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!31 = distinct !{!31, !"_ZN12clpt_control6native9for_numba9lineariseB2v9B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!32 = !{!33, !35, !30}
!33 = distinct !{!33, !34, !"_ZN12clpt_control6native9for_numba13differentiateB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!34 = distinct !{!34, !"_ZN12clpt_control6native9for_numba13differentiateB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!35 = distinct !{!35, !34, !"_ZN12clpt_control6native9for_numba13differentiateB3v10B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!36 = distinct !{!36, !7, !8}
!37 = distinct !{!37, !7, !8}
!38 = !{!39, !41, !33, !35, !30}
!39 = distinct !{!39, !40, !"_ZN12clpt_control6native9for_numba14by_differencesB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!40 = distinct !{!40, !"_ZN12clpt_control6native9for_numba14by_differencesB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!41 = distinct !{!41, !40, !"_ZN12clpt_control6native9for_numba14by_differencesB3v11B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedExx5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!42 = distinct !{!42, !7, !8}
!43 = distinct !{!43, !7}
!44 = distinct !{!44, !7}
!45 = distinct !{!45, !7}
!46 = !{!47, !49, !30}
!47 = distinct !{!47, !48, !"_ZN12clpt_control6native16linear_equations6factorB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %retptr"}
!48 = distinct !{!48, !"_ZN12clpt_control6native16linear_equations6factorB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE"}
!49 = distinct !{!49, !48, !"_ZN12clpt_control6native16linear_equations6factorB3v15B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE: %excinfo"}
!50 = !{!51}
!51 = distinct !{!51, !52, !"_ZN12clpt_control6native9for_numba11solve_stageB3v17B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!52 = distinct !{!52, !"_ZN12clpt_control6native9for_numba11solve_stageB3v17B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dExx5TupleI5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!53 = !{!54, !56, !51}
!54 = distinct !{!54, !55, !"_ZN12clpt_control6native16linear_equations5solveB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!55 = distinct !{!55, !"_ZN12clpt_control6native16linear_equations5solveB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx"}
!56 = distinct !{!56, !55, !"_ZN12clpt_control6native16linear_equations5solveB3v18B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedEx: %excinfo"}
!57 = !{!58}
!58 = distinct !{!58, !59, !"_ZN12clpt_control6native9for_numba4failB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_282_29: %retptr"}
!59 = distinct !{!59, !"_ZN12clpt_control6native9for_numba4failB3v20B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_282_29"}
!60 = !{!61, !63}
!61 = distinct !{!61, !62, !"_ZN12clpt_control6native9for_numba6passesB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!62 = distinct !{!62, !"_ZN12clpt_control6native9for_numba6passesB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!63 = distinct !{!63, !62, !"_ZN12clpt_control6native9for_numba6passesB3v21B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!64 = !{!65, !67, !61, !63}
!65 = distinct !{!65, !66, !"_ZN12clpt_control6native9for_numba6passedB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!66 = distinct !{!66, !"_ZN12clpt_control6native9for_numba6passedB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!67 = distinct !{!67, !66, !"_ZN12clpt_control6native9for_numba6passedB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!68 = !{!69}
!69 = distinct !{!69, !70, !"_ZN12clpt_control6native9for_numba5crossB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!70 = distinct !{!70, !"_ZN12clpt_control6native9for_numba5crossB3v23B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!71 = !{!72, !74, !69}
!72 = distinct !{!72, !73, !"_ZN12clpt_control6native9for_numba6passedB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!73 = distinct !{!73, !"_ZN12clpt_control6native9for_numba6passedB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE"}
!74 = distinct !{!74, !73, !"_ZN12clpt_control6native9for_numba6passedB3v22B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExxx5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!75 = !{!76, !78, !69}
!76 = distinct !{!76, !77, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!77 = distinct !{!77, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!78 = distinct !{!78, !77, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!79 = distinct !{!79, !7, !8}
!80 = distinct !{!80, !7}
!81 = !{!82}
!82 = distinct !{!82, !83, !"_ZN12clpt_control6native9for_numba5watchB3v26B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!83 = distinct !{!83, !"_ZN12clpt_control6native9for_numba5watchB3v26B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!84 = !{!85, !82}
!85 = distinct !{!85, !86, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!86 = distinct !{!86, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!87 = !{!88, !90, !82}
!88 = distinct !{!88, !89, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!89 = distinct !{!89, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!90 = distinct !{!90, !89, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!91 = distinct !{!91, !7, !8}
!92 = distinct !{!92, !7}
!93 = !{!94}
!94 = distinct !{!94, !95, !"_ZN12clpt_control6native9for_numba6sampleB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx: %retptr"}
!95 = distinct !{!95, !"_ZN12clpt_control6native9for_numba6sampleB3v27B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedEx"}
!96 = !{!97, !99, !94}
!97 = distinct !{!97, !98, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %retptr"}
!98 = distinct !{!98, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd"}
!99 = distinct !{!99, !98, !"_ZN12clpt_control6native9for_numba7betweenB3v24B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIdLi1E1C7mutable7alignedExxxxd: %excinfo"}
!100 = !{!101, !103}
!101 = distinct !{!101, !102, !"_ZN12clpt_control6native9for_numba11decide_anewB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %retptr"}
!102 = distinct !{!102, !"_ZN12clpt_control6native9for_numba11decide_anewB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE"}
!103 = distinct !{!103, !102, !"_ZN12clpt_control6native9for_numba11decide_anewB3v28B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIdLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE: %excinfo"}
!104 = !{!105, !101, !103}
!105 = distinct !{!105, !106, !"_ZN12clpt_control6native9for_numba4failB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29: %retptr"}
!106 = distinct !{!106, !"_ZN12clpt_control6native9for_numba4failB3v29B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_286_29"}
!107 = !{!108, !110}
!108 = distinct !{!108, !109, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!109 = distinct !{!109, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!110 = distinct !{!110, !111, !"_ZN12clpt_control6native9for_numba4leapB3v30B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx: %retptr"}
!111 = distinct !{!111, !"_ZN12clpt_control6native9for_numba4leapB3v30B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx"}
!112 = !{!110}
!113 = !{!114, !110}
!114 = distinct !{!114, !115, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!115 = distinct !{!115, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!116 = !{!117, !110}
!117 = distinct !{!117, !118, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!118 = distinct !{!118, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!119 = !{!120, !110}
!120 = distinct !{!120, !121, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!121 = distinct !{!121, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!122 = !{!123, !110}
!123 = distinct !{!123, !124, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!124 = distinct !{!124, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!125 = !{!126, !128}
!126 = distinct !{!126, !127, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!127 = distinct !{!127, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!128 = distinct !{!128, !127, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!129 = !{!130}
!130 = distinct !{!130, !131, !"_ZN12clpt_control6native9for_numba4failB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29: %retptr"}
!131 = distinct !{!131, !"_ZN12clpt_control6native9for_numba4failB3v32B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_285_29"}
!132 = !{!133, !135}
!133 = distinct !{!133, !134, !"_ZN12clpt_control6native9for_numba5enterB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!134 = distinct !{!134, !"_ZN12clpt_control6native9for_numba5enterB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE"}
!135 = distinct !{!135, !134, !"_ZN12clpt_control6native9for_numba5enterB3v33B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dExx5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi1E1C7mutable7alignedE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!136 = !{!137}
!137 = distinct !{!137, !138, !"_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!138 = distinct !{!138, !"_ZN12clpt_control6native9for_numba4takeB2v3B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!139 = distinct !{!139, !7, !8}
!140 = !{!141, !143, !137}
!141 = distinct !{!141, !142, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!142 = distinct !{!142, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!143 = distinct !{!143, !142, !"_ZN12clpt_control6native9for_numba4restB2v4B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %excinfo"}
!144 = distinct !{!144, !7}
!145 = !{!"branch_weights", i32 1, i32 99}
!146 = !{!147}
!147 = distinct !{!147, !148, !"_ZN12clpt_control6native9for_numba4keepB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE: %retptr"}
!148 = distinct !{!148, !"_ZN12clpt_control6native9for_numba4keepB3v39B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE8UniTupleIxLi3EEx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIxLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE"}
!149 = distinct !{!149, !7, !8}
!150 = distinct !{!150, !7}
!151 = !{i1 true}
!152 = !{!"branch_weights", i32 127, i32 1}
!153 = !{!"branch_weights", i32 1, i32 127}
!154 = !{!"branch_weights", i32 127, i32 3048}
!155 = distinct !{!155, !7, !8, !156}
!156 = !{!"llvm.loop.estimated_trip_count", i32 25}
!157 = !{!"branch_weights", i32 1, i32 3}
!158 = !{!"branch_weights", i32 1, i32 0}
!159 = distinct !{!159, !8, !7, !160}
!160 = !{!"llvm.loop.estimated_trip_count", i32 0}
!161 = !{!162, !164}
!162 = distinct !{!162, !163, !"_ZN12clpt_control6native9for_numba5marchB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEddx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EExxx: %retptr"}
!163 = distinct !{!163, !"_ZN12clpt_control6native9for_numba5marchB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEddx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EExxx"}
!164 = distinct !{!164, !163, !"_ZN12clpt_control6native9for_numba5marchB3v36B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EEddx5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EExxx: %excinfo"}
!165 = !{!166, !168, !162, !164}
!166 = distinct !{!166, !167, !"_ZN12clpt_control6native9for_numba6decideB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!167 = distinct !{!167, !"_ZN12clpt_control6native9for_numba6decideB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!168 = distinct !{!168, !167, !"_ZN12clpt_control6native9for_numba6decideB3v37B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedExxx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!169 = !{!170, !162, !164}
!170 = distinct !{!170, !171, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!171 = distinct !{!171, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!172 = !{!173, !162, !164}
!173 = distinct !{!173, !174, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!174 = distinct !{!174, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!175 = !{!176}
!176 = distinct !{!176, !177}
!177 = distinct !{!177, !"LVerDomain"}
!178 = !{!179}
!179 = distinct !{!179, !177}
!180 = !{!162, !164, !176}
!181 = distinct !{!181, !7, !8}
!182 = distinct !{!182, !7, !8, !156}
!183 = distinct !{!183, !8, !7, !160}
!184 = distinct !{!184, !7, !8, !156}
!185 = distinct !{!185, !8, !7, !160}
!186 = distinct !{!186, !7, !8, !156}
!187 = distinct !{!187, !7, !8}
!188 = distinct !{!188, !8, !7, !160}
!189 = distinct !{!189, !7}
!190 = distinct !{!190, !7, !8, !156}
!191 = !{!192, !194, !162, !164}
!192 = distinct !{!192, !193, !"_ZN12clpt_control6native9for_numba6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %retptr"}
!193 = distinct !{!193, !"_ZN12clpt_control6native9for_numba6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE"}
!194 = distinct !{!194, !193, !"_ZN12clpt_control6native9for_numba6decideB2v5B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedEx5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi1E1C7mutable7alignedE23Literal_5bint_5d_280_29xx8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EE: %excinfo"}
!195 = distinct !{!195, !8, !7, !160}
!196 = distinct !{!196, !7}
!197 = distinct !{!197, !7, !8, !156}
!198 = distinct !{!198, !8, !7, !160}
!199 = distinct !{!199, !7, !8, !156}
!200 = distinct !{!200, !8, !7, !160}
!201 = distinct !{!201, !7, !8, !156}
!202 = distinct !{!202, !8, !7, !160}
!203 = distinct !{!203, !7, !8, !156}
!204 = distinct !{!204, !8, !7, !160}
!205 = !{!206, !208}
!206 = distinct !{!206, !207, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!207 = distinct !{!207, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!208 = distinct !{!208, !209, !"_ZN12clpt_control6native9for_numba4leapB3v30B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx: %retptr"}
!209 = distinct !{!209, !"_ZN12clpt_control6native9for_numba4leapB3v30B66c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsBAQ4s_2fqErM2IZKIKUpsIgmAA_3d_3dE5ArrayIxLi1E1C7mutable7alignedE8UniTupleIxLi3EE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5ArrayIdLi1E1C7mutable7alignedE5TupleI5ArrayIdLi3E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEE5TupleI5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE5ArrayIxLi1E1C7mutable7alignedEE8UniTupleI5ArrayIdLi1E1C7mutable7alignedELi5EEx"}
!210 = !{!208}
!211 = !{!212, !208}
!212 = distinct !{!212, !213, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!213 = distinct !{!213, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!214 = !{!215, !208}
!215 = distinct !{!215, !216, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29: %retptr"}
!216 = distinct !{!216, !"_ZN12clpt_control6native9for_numba4failB2v7B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_283_29"}
!217 = !{!218, !208}
!218 = distinct !{!218, !219, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE: %retptr"}
!219 = distinct !{!219, !"_ZN12clpt_control6native9for_numba6at_endB3v31B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dEx5ArrayIxLi1E1C7mutable7alignedE5ArrayIdLi2E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedE"}
!220 = !{!221, !208}
!221 = distinct !{!221, !222, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29: %retptr"}
!222 = distinct !{!222, !"_ZN12clpt_control6native9for_numba4failB2v8B68c8tJTIeFIjxB2IKSgI4CrvQCk0Z4yRYcWsCAQUQzVBF6jCIJo8Y_2fVAIplYFFNAE_3dE5ArrayIxLi1E1C7mutable7alignedE5ArrayIxLi2E1C7mutable7alignedEx23Literal_5bint_5d_284_29"}
!223 = distinct !{!223, !7, !8}
!224 = distinct !{!224, !7}

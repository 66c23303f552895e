define double @search(ptr %row, i64 %stride, i64 %count, double %value, double %right) {
  ; how many numbers of a sorted row are below a value, or equal to it if `right`; 0 for NaN
start:
  %also_equal = fcmp ogt double %right, 0.5
  br label %loop
loop:
  ; the result is from low to high
  %low = phi i64 [ 0, %start ], [ %new_low, %body ]
  %high = phi i64 [ %count, %start ], [ %new_high, %body ]
  %is_open = icmp slt i64 %low, %high
  br i1 %is_open, label %body, label %end
body:
  %low_and_high = add i64 %low, %high
  %middle = lshr i64 %low_and_high, 1
  %offset = mul i64 %middle, %stride
  %address = getelementptr double, ptr %row, i64 %offset
  %number = load double, ptr %address
  %is_equal = fcmp oeq double %number, %value
  %counts = and i1 %also_equal, %is_equal
  %is_less = fcmp olt double %number, %value
  %below = or i1 %is_less, %counts
  %after = add i64 %middle, 1
  %new_low = select i1 %below, i64 %after, i64 %low
  %new_high = select i1 %below, i64 %high, i64 %middle
  br label %loop
end:
  %result = sitofp i64 %low to double
  ret double %result
}

define double @argmin(ptr %row, i64 %stride, i64 %count) {
  ; index of the least number of a row, or of the first NaN
start:
  %first = load double, ptr %row
  br label %loop
loop:
  %position = phi i64 [ 0, %start ], [ %following, %loop ]
  %best = phi i64 [ 0, %start ], [ %new_best, %loop ]
  %least = phi double [ %first, %start ], [ %new_least, %loop ]
  %offset = mul i64 %position, %stride
  %address = getelementptr double, ptr %row, i64 %offset
  %number = load double, ptr %address
  %is_number = fcmp ord double %least, %least ; a NaN stays the least
  %is_less = fcmp ult double %number, %least
  %better = and i1 %is_number, %is_less
  %new_best = select i1 %better, i64 %position, i64 %best
  %new_least = select i1 %better, double %number, double %least
  %following = add i64 %position, 1
  %continues = icmp slt i64 %following, %count
  br i1 %continues, label %loop, label %end
end:
  %result = sitofp i64 %new_best to double
  ret double %result
}

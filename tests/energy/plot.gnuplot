# gnuplot -e "data='folder'; out='file.svg'" plot.gnuplot
set terminal svg size 1000,420 font "DejaVu Sans,13" background "white"
set output out
set multiplot layout 1,2 title "Error of the albedo against the random walk, largest over cosines from 0.02"
set logscale y
set yrange [3e-4:1]
set format y "10^{%L}"
set grid ytics lc rgb "#dddddd"
set key off
set xlabel "F0"
set ylabel "largest error, alpha 0.05 to 1"
set xrange [0:1]
colour(i) = word("#777777 #e69f00 #cc3311 #0072b2 #009e73", i)
name(i) = word("single_scattering turquin fdez_aguera kulla_conty smith_multiscatter", i)
plot for [i=1:5] data."/by_F0.dat" using 1:(column(i+1) < 3e-4 ? 3e-4 : column(i+1)) with linespoints lw 2 pt 7 ps 0.4 lc rgb colour(i)
set key at screen 0.90,0.60 right noenhanced samplen 2
set xlabel "alpha"
set ylabel "largest error, F0 0 to 1"
plot for [i=1:5] data."/by_alpha.dat" using 1:(column(i+1) < 3e-4 ? 3e-4 : column(i+1)) with linespoints lw 2 pt 7 ps 0.4 lc rgb colour(i) title name(i)
unset multiplot

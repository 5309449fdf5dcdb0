/**
 * Time for logic that waits, passed in so that tests step it ({@link org.dfra.time.Scheduler}), and
 * what clocks differ by ({@link org.dfra.time.ClockOffset}).
 */
@NullMarked
package org.dfra.time;

import org.jspecify.annotations.NullMarked;

/**
 * Time: an injected clock with timers, which tests step ({@link org.dfra.time.Scheduler}), and
 * clock offsets ({@link org.dfra.time.ClockOffset}).
 */
@NullMarked
package org.dfra.time;

import org.jspecify.annotations.NullMarked;

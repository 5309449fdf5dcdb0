/**
 * Measures how threads and traffic grow with the number of robots: each is a process with a lookup
 * service and modules of its own. Enter at {@link org.dfra.benchmarks.scale.Team}.
 */
@NullMarked
package org.dfra.benchmarks.scale;

import org.jspecify.annotations.NullMarked;

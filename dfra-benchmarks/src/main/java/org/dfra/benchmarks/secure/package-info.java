/**
 * What the security of a team costs beside the calls themselves: how fast a revocation is in force,
 * and how robots recover with and without it.
 */
@NullMarked
package org.dfra.benchmarks.secure;

import org.jspecify.annotations.NullMarked;

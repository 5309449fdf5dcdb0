/**
 * Affects that motivate a robot to help: {@link org.dfra.recruit.affect.Shame}, DFRA's own model,
 * or {@link org.dfra.recruit.affect.Impatience} after ALLIANCE.
 */
@NullMarked
package org.dfra.recruit.affect;

import org.jspecify.annotations.NullMarked;

/**
 * Which messages are lost: {@link org.dfra.recruit.loss.LossModel}. Seeded, so a run can be
 * repeated.
 */
@NullMarked
package org.dfra.recruit.loss;

import org.jspecify.annotations.NullMarked;

/**
 * Models of message loss: {@link org.dfra.recruit.loss.LossModel}. Seeded, so runs are
 * reproducible.
 */
@NullMarked
package org.dfra.recruit.loss;

import org.jspecify.annotations.NullMarked;

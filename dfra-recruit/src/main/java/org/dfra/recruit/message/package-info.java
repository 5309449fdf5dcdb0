/**
 * What recruitment agents tell each other: {@link org.dfra.recruit.message.RecruitmentMessage}, in
 * a {@link org.dfra.recruit.message.MessageEnvelope}.
 */
@NullMarked
package org.dfra.recruit.message;

import org.jspecify.annotations.NullMarked;

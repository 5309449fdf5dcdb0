/**
 * The messages between recruitment agents: {@link org.dfra.recruit.message.RecruitmentMessage}, in
 * a {@link org.dfra.recruit.message.MessageEnvelope}.
 */
@NullMarked
package org.dfra.recruit.message;

import org.jspecify.annotations.NullMarked;

/**
 * The responder: {@link org.dfra.recruit.responder.ResponderMachine} moves a {@link
 * org.dfra.recruit.responder.ResponderState} through the phases of {@link
 * org.dfra.agent.ResponderPhase}.
 */
@NullMarked
package org.dfra.recruit.responder;

import org.jspecify.annotations.NullMarked;

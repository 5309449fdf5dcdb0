/**
 * Who may help: {@link org.dfra.recruit.responder.ResponderMachine} moves a {@link
 * org.dfra.recruit.responder.ResponderState} along the arrows of {@link
 * org.dfra.agent.ResponderPhase}.
 */
@NullMarked
package org.dfra.recruit.responder;

import org.jspecify.annotations.NullMarked;

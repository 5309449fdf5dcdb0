/**
 * The requester: {@link org.dfra.recruit.requester.RequesterMachine} moves a {@link
 * org.dfra.recruit.requester.RequesterState} through the phases of {@link
 * org.dfra.agent.RequesterPhase}.
 */
@NullMarked
package org.dfra.recruit.requester;

import org.jspecify.annotations.NullMarked;

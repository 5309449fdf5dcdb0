/**
 * Who needs help: {@link org.dfra.recruit.requester.RequesterMachine} moves a {@link
 * org.dfra.recruit.requester.RequesterState} along the arrows of {@link
 * org.dfra.agent.RequesterPhase}.
 */
@NullMarked
package org.dfra.recruit.requester;

import org.jspecify.annotations.NullMarked;

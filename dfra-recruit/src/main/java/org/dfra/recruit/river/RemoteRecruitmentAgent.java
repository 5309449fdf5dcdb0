package org.dfra.recruit.river;

import java.rmi.RemoteException;
import net.jini.core.event.RemoteEvent;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.event.UnknownEventException;
import org.dfra.agent.RecruitmentControl;
import org.dfra.module.Idempotent;
import org.dfra.river.remote.RemoteModule;

/**
 * What other robots may call on a recruitment agent's server. Letters come as remote events, and in
 * no other way.
 */
public interface RemoteRecruitmentAgent
    extends RemoteModule, RecruitmentControl, RemoteEventListener {

  /**
   * Takes a {@link AgentMessageEvent}. One that comes twice does no harm, so the call may be
   * repeated.
   *
   * @throws UnknownEventException if it is another event
   * @throws IllegalArgumentException if it carries no letter of recruitment
   */
  @Override
  @Idempotent
  void notify(RemoteEvent event) throws UnknownEventException, RemoteException;
}

package org.dfra.recruit.river;

import java.rmi.RemoteException;
import net.jini.core.event.RemoteEvent;
import net.jini.core.event.RemoteEventListener;
import net.jini.core.event.UnknownEventException;
import org.dfra.agent.RecruitmentControl;
import org.dfra.module.Idempotent;
import org.dfra.river.remote.RemoteModule;

/**
 * The remote interface of a recruitment agent's server for other robots. Messages arrive only as
 * remote events.
 */
public interface RemoteRecruitmentAgent
    extends RemoteModule, RecruitmentControl, RemoteEventListener {

  /**
   * Receives an {@link AgentMessageEvent}. Duplicates have no effect, so the call is idempotent.
   *
   * @throws UnknownEventException if it is another event
   * @throws IllegalArgumentException if it contains no recruitment message
   */
  @Override
  @Idempotent
  void notify(RemoteEvent event) throws UnknownEventException, RemoteException;
}

package org.dfra.recruit.river;

import java.rmi.RemoteException;
import java.util.UUID;
import net.jini.core.event.UnknownEventException;
import org.dfra.agent.AgentMessage;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.agent.RecruitmentControl;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.module.Identification;
import org.dfra.river.proxy.ModuleProxy;
import org.dfra.river.remote.RemoteModule;

/** Smart proxy of a recruitment agent. It sends messages as remote events. */
public final class RecruitmentAgentProxy extends ModuleProxy<RecruitmentControl>
    implements RecruitmentAgent {

  private static final long serialVersionUID = 1L;

  /** See {@link ModuleProxy#ModuleProxy}. */
  public RecruitmentAgentProxy(RemoteModule server, UUID id, Identification identification) {
    super(RecruitmentControl.class, server, id, identification);
  }

  @Override
  public void callForHelp(HelpCall call) throws RemoteException {
    target().callForHelp(call);
  }

  @Override
  public void release() throws RemoteException {
    target().release();
  }

  @Override
  public void resume() throws RemoteException {
    target().resume();
  }

  @Override
  public RecruitmentStatus status() throws RemoteException {
    return target().status();
  }

  @Override
  public void receive(AgentMessage message) throws RemoteException {
    RecruitmentControl target = target();
    if (target instanceof RecruitmentAgent here) {
      here.receive(message);
      return;
    }
    try {
      ((RemoteRecruitmentAgent) target).notify(new AgentMessageEvent(message));
    } catch (UnknownEventException e) {
      throw new IllegalArgumentException(
          identification().path()
              + " does not accept messages of type "
              + message.getClass().getName(),
          e);
    }
  }
}

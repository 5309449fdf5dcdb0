package org.dfra.recruit.river;

import java.rmi.MarshalledObject;
import java.rmi.RemoteException;
import java.rmi.activation.ActivationID;
import net.jini.core.event.RemoteEvent;
import net.jini.core.event.UnknownEventException;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.river.server.ModuleActivation;
import org.dfra.river.server.ModuleServer;
import org.jspecify.annotations.Nullable;

/** Activatable server of a recruitment agent. */
public final class RecruitmentAgentServer extends ModuleServer<RecruitmentAgent>
    implements RemoteRecruitmentAgent {

  /** See {@link ModuleServer#ModuleServer}. */
  public RecruitmentAgentServer(@Nullable ActivationID id, MarshalledObject<ModuleActivation> data)
      throws Exception {
    super(RecruitmentAgent.class, id, data);
  }

  @Override
  public void callForHelp(HelpCall call) throws RemoteException {
    module().callForHelp(call);
  }

  @Override
  public void release() throws RemoteException {
    module().release();
  }

  @Override
  public void resume() throws RemoteException {
    module().resume();
  }

  @Override
  public RecruitmentStatus status() throws RemoteException {
    return module().status();
  }

  @Override
  public void notify(RemoteEvent event) throws UnknownEventException, RemoteException {
    if (!(event instanceof AgentMessageEvent known)) {
      throw new UnknownEventException(
          path() + " accepts messages of agents, not " + event.getClass().getName());
    }
    module().receive(known.message());
  }
}

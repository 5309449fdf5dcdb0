package org.dfra.benchmarks;

import java.time.Instant;
import java.util.List;
import java.util.concurrent.BlockingQueue;
import java.util.concurrent.LinkedBlockingQueue;
import org.dfra.agent.AgentMessage;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.benchmarks.event.BenchActivation;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.AttributeProvider;
import org.dfra.persona.Attributes;
import org.dfra.persona.RecruitmentAttributes;
import org.dfra.recruit.river.RecruitmentAgentProxy;
import org.dfra.recruit.river.RecruitmentAgentServer;
import org.dfra.river.server.ModuleServer;

/**
 * An agent that records when messages arrive and does nothing else; served like any other agent.
 */
public final class BenchAgent extends ModuleImpl implements RecruitmentAgent, AttributeProvider {

  private static final BlockingQueue<BenchAgent> MADE = new LinkedBlockingQueue<>();

  private volatile long came;

  /** Called by the module's server, as for every driver. */
  public BenchAgent(ModuleContext context) {
    super(context, "an agent of a benchmark", "DFRA", "1");
    MADE.add(this);
  }

  /** The instance that a server has created by its class name. */
  static BenchAgent awaitInstance() throws InterruptedException {
    return MADE.take();
  }

  /** Serves an instance in this JVM, as a group would. */
  static RecruitmentAgentServer serve(String locator) throws Exception {
    return ModuleServer.started(
        new RecruitmentAgentServer(
            null,
            BenchActivation.of(
                "agent",
                RecruitmentAgentServer.class,
                RecruitmentAgentProxy.class,
                BenchAgent.class,
                List.of(locator))));
  }

  @Override
  protected void onStart() {
    transitionTo(Readiness.READY);
  }

  @Override
  protected void onClose() {}

  /** When the last message arrived, by {@link System#nanoTime}. */
  long lastReceivedNanos() {
    return came;
  }

  @Override
  public void receive(AgentMessage message) {
    came = System.nanoTime();
  }

  @Override
  public void callForHelp(HelpCall call) {
    // it recruits no helpers
  }

  @Override
  public void resume() {
    // it is not suspended
  }

  @Override
  public void release() {
    // it recruits no helpers
  }

  @Override
  public RecruitmentStatus status() {
    return new RecruitmentStatus(
        Instant.EPOCH, RequesterPhase.IDLE, null, ResponderPhase.FREE, null, 0, "nothing");
  }

  @Override
  public List<Attributes> attributes() {
    return List.of(new RecruitmentAttributes(List.of("bench"), 1, "none", 20, 1));
  }
}

package org.dfra.experiments.recruit.embedded;

import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import java.util.UUID;
import java.util.concurrent.ConcurrentHashMap;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.dfra.agent.AgentMessage;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.time.ScaledTime;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.experiments.recruit.simulation.ExperimentEnvironment;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.persona.AttributeProvider;
import org.dfra.persona.Attributes;
import org.dfra.persona.RecruitmentAttributes;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.agent.DirectoryTransport;
import org.dfra.recruit.agent.Recruiter;
import org.dfra.recruit.agent.RecruiterPorts;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.transport.Transport;
import org.dfra.time.Scheduler;
import org.jspecify.annotations.Nullable;

/**
 * The driver of an agent in the experiment's field, served and discovered like any other: a {@link
 * Recruiter} with its own transport to the others, on the body that the experiment supplies in
 * place of a robot's modules. It takes part in one run after the other, without memory.
 */
public final class FieldAgent extends ModuleImpl
    implements RecruitmentAgent, AttributeProvider, ExperimentEnvironment.AgentHandle {

  /** Name of the parameter with the agent's slot. */
  static final String SLOT = "seat";

  /** The speed in its persona, metres per second; not used. */
  private static final double SPEED = 1;

  /**
   * Objects that a server cannot pass to the driver, since it creates it by class name.
   *
   * @param percepts in its persona
   * @param time of the agent
   * @param timers of the agent and its leases
   * @param made receives the agent
   */
  record AgentSlot(
      Set<String> percepts, ScaledTime time, Scheduler timers, Consumer<FieldAgent> made) {

    private static final Map<String, AgentSlot> FREE = new ConcurrentHashMap<>();

    /** Reserves it; returns the value for the parameter. */
    String reserve() {
      String key = UUID.randomUUID().toString();
      FREE.put(key, this);
      return key;
    }

    private static AgentSlot claim(ModuleContext context) {
      String key = context.parameters().text(SLOT);
      return Objects.requireNonNull(FREE.remove(key), "no slot is reserved for key " + key);
    }
  }

  /** Its participation in a run. */
  private record RunParticipation(Recruiter recruiter, Consumer<MessageEnvelope> onMessage) {}

  private final AgentSlot slot;
  private final ModuleContext timed;
  private final DirectoryTransport transport;
  private volatile @Nullable RunParticipation part;

  /** Called by the module's server, as for every driver. */
  public FieldAgent(ModuleContext context) {
    this(context, AgentSlot.claim(context));
  }

  @SuppressWarnings("this-escape") // the receiver uses it once it is served
  private FieldAgent(ModuleContext context, AgentSlot slot) {
    super(by(slot, context), "recruitment agent of the experiment", "DFRA", "1");
    this.slot = slot;
    this.timed = by(slot, context);
    this.transport = new DirectoryTransport(timed, log);
    slot.made().accept(this);
  }

  /** The same module context with another time, for its leases too. */
  private static ModuleContext by(AgentSlot slot, ModuleContext context) {
    return new ModuleContext(
        context.robot(),
        context.name(),
        context.parameters(),
        slot.time(),
        context.state(),
        LeaseTerms.DEFAULT,
        slot.timers(),
        context::directory);
  }

  @Override
  protected void onStart() {
    transitionTo(Readiness.READY);
    Set<String> unused = known(); // starts the discovery of the others
  }

  @Override
  protected void onClose() {
    leave();
    transport.close();
  }

  /** Robots whose agents it has discovered, including its own. */
  Set<String> known() {
    return timed.directory().find(ModuleQuery.of(RecruitmentAgent.class)).stream()
        .map(ModuleListing::robot)
        .collect(Collectors.toSet());
  }

  /** Its transport to the others. */
  Transport transport() {
    return transport;
  }

  /**
   * Joins a run, as an agent without memory.
   *
   * @param way transport to the others
   * @param come is notified of each received message
   */
  void join(ExperimentEnvironment.AgentSpec member, Transport way, Consumer<MessageEnvelope> come) {
    Recruiter fresh =
        new Recruiter(
            timed.robot(),
            member.settings(),
            member.strategy(),
            member.mode(),
            new RecruiterPorts(way, member.body(), leases(), slot.time(), slot.timers()),
            member.listener(),
            Optional.empty());
    part = new RunParticipation(fresh, come);
    fresh.start();
  }

  /** Leaves the run. */
  void leave() {
    RunParticipation over = part;
    part = null;
    if (over != null) {
      over.recruiter().close();
    }
  }

  private RunParticipation part() {
    RunParticipation now = part;
    if (now == null) {
      throw new NotReadyException(path(), readiness(), "it takes part in no run now");
    }
    return now;
  }

  @Override
  public void callForHelp(HelpCall call) {
    MessageDelays.runTimed(() -> part().recruiter().help(call));
  }

  @Override
  public void release() {
    part().recruiter().release();
  }

  /** The body in the simulation is never stopped. */
  @Override
  public void resume() {}

  @Override
  public RecruitmentStatus status() {
    return part().recruiter().status();
  }

  @Override
  public void receive(AgentMessage message) {
    if (!(message instanceof MessageEnvelope envelope)) {
      throw new IllegalArgumentException(path() + " accepts recruitment messages only");
    }
    RunParticipation now = part();
    now.onMessage().accept(envelope);
    MessageDelays.runTimed(() -> now.recruiter().receive(envelope));
  }

  @Override
  public List<Attributes> attributes() {
    return List.of(
        new RecruitmentAttributes(
            List.copyOf(slot.percepts()),
            SPEED,
            "as the run has it",
            RecruitmentSettings.DEFAULT.replaceAfter().toMillis() / 1e3,
            RecruitmentSettings.DEFAULT.margin().toMillis() / 1e3));
  }
}

package org.dfra.recruit.agent;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.TreeMap;
import org.dfra.agent.AgentMessage;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.core.host.CommandName;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.time.BootId;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.NotReadyException;
import org.dfra.persona.AttributeProvider;
import org.dfra.persona.Attributes;
import org.dfra.persona.RecruitmentAttributes;
import org.dfra.recruit.RecruitmentSettings;
import org.dfra.recruit.affect.Shame.ShameSettings;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.message.SentMessage;
import org.dfra.recruit.requester.RequesterAction;
import org.dfra.recruit.responder.ResponderAction;
import org.dfra.recruit.strategy.RecruitmentStrategy;
import org.dfra.recruit.strategy.StrategyRegistry;
import org.dfra.recruit.transport.Transport.MessageMode;
import org.jspecify.annotations.Nullable;

/**
 * The recruitment agent of a robot: a {@link Recruiter} on the robot's own modules. It stores its
 * state, and resumes from it after a crash of its process.
 *
 * <p>Parameters, read at the start:
 *
 * <ul>
 *   <li>{@code percepts}: the percepts that its robot can observe, separated by commas; default
 *       none
 *   <li>{@code strategy}: {@code affective}, {@code greedy}, {@code random}, {@code contract-net},
 *       or the name of a class ({@link StrategyRegistry}); default {@code affective}. {@code
 *       affect}: {@code shame} or {@code impatience}; default {@code shame}
 *   <li>{@code shame_gain}, {@code shame_exponent}, {@code shame_floor}, {@code shame_idle_factor},
 *       {@code shame_busy_factor}: the constants of {@link ShameSettings}, 0.01 to 100, 0.01 to 10,
 *       0.001 to 1, and 0.01 to 10 twice. {@code eta_reference}: ETA from which on a place counts
 *       as farthest, seconds, 0.1 to 86400; default the field's diagonal divided by {@code speed}
 *   <li>{@code impatience_min_wait}, {@code impatience_max_wait}: time after which an unanswered
 *       call motivates an idle robot at the place, and one at {@code eta_reference}, seconds, 0.1
 *       to 3600; default 5 and 30
 *   <li>{@code random_offer_probability}: probability that a free robot offers with the random
 *       strategy, 0.01 to 1; default 0.5
 *   <li>{@code offer_window}: wait for other offers after the first, seconds, 0.1 to 10 and below
 *       {@code replace_after} less {@code margin}; default the strategy's own
 *   <li>{@code message_mode}: {@code broadcast} or {@code unicast}; default {@code broadcast}
 *   <li>{@code speed}: travel speed, metres per second, 0.01 to 50; default 0.5. {@code
 *       detour_factor}: ratio of path length to straight distance, 1 to 10; default 1.2. ETA is the
 *       straight distance times {@code detour_factor}, divided by {@code speed}: give realistic
 *       values, otherwise it withdraws as late
 *   <li>{@code field}: two corners, south-west and north-east, latitude,longitude each; it neither
 *       travels nor calls outside of it. Default unlimited
 *   <li>{@code tolerance}: tolerance of arrival, metres, 0.05 to 20; default 1
 *   <li>{@code battery_reserve}: charge below which it does not help, 0 to 0.99; default 0.1
 *   <li>{@code max_stay}: maximum time of help for one call, seconds, 1 to 86400; default 600
 *   <li>{@code go_to_waypoint}: name of the module that drives it; default any of its robot
 *   <li>{@code help_every}, {@code help_rounds}, {@code replace_after}, {@code margin}, {@code
 *       repeat_every}, {@code accept_sends}, {@code arrival_sends}, {@code agree_every}, {@code
 *       release_every}: those of {@link RecruitmentSettings}, spans in seconds, 0.1 to 3600, and
 *       counts, 1 to 100. Robots of a team warn if {@code replace_after} or {@code margin} differ
 * </ul>
 */
public final class RecruitmentAgentImpl extends ModuleImpl
    implements RecruitmentAgent, AttributeProvider {

  private static final Duration SHORTEST_STAY = Duration.ofSeconds(1);

  private final ModuleContext context;
  private final RobotTraits traits;
  private final RecruitmentSettings recruitmentSettings;
  private final RecruitmentStrategy strategy;
  private final MessageMode mode;
  private final ModuleRobotPort body;
  private final DirectoryTransport transport;
  private final AgentSnapshotStore memory;
  private final TimeoutConsistencyMonitor agreement;
  private final RecruiterListener observer;
  private volatile @Nullable Recruiter recruiter;

  /** See {@link ModuleImpl}. */
  public RecruitmentAgentImpl(ModuleContext context) {
    this(context, new RecruiterListener() {});
  }

  /**
   * The same with an observer: for reports and tests.
   *
   * @param extra observes all its actions
   */
  public RecruitmentAgentImpl(ModuleContext context, RecruiterListener extra) {
    this(context, extra, BootId.system());
  }

  /** For tests: on another computer. */
  RecruitmentAgentImpl(ModuleContext context, RecruiterListener extra, BootId boot) {
    super(lasting(context), "requests help from other robots, and helps them", "DFRA", "1");
    this.context = context;
    this.observer = extra;
    this.traits = RobotTraits.of(settings());
    this.recruitmentSettings = RecruitmentSettingsParser.of(settings());
    this.strategy =
        StrategyParser.of(
            settings(),
            traits,
            recruitmentSettings.helpEvery(),
            new SplittableRandom(context.path().hashCode() ^ clock().millis()));
    String messages = settings().find("message_mode").orElse("broadcast").strip();
    if (!messages.equals("broadcast") && !messages.equals("unicast")) {
      throw settings().fault("message_mode", "broadcast or unicast", null);
    }
    this.mode = messages.equals("unicast") ? MessageMode.UNICAST : MessageMode.BROADCAST;
    this.body = new ModuleRobotPort(context, traits, log);
    this.transport = new DirectoryTransport(context, log);
    this.memory = new AgentSnapshotStore(context, boot);
    this.agreement = new TimeoutConsistencyMonitor(context, attributes(null), log);
    parameterTable()
        .declareReadOnly(
            "disagreements",
            "robots of the team whose replace_after or margin differs from this agent's",
            () -> String.join("; ", new TreeMap<>(agreement.disagreements()).values()));
  }

  /** The requester holds a lease for the whole stay, which is longer than other leases. */
  private static ModuleContext lasting(ModuleContext context) {
    Duration stay =
        context
            .parameters()
            .seconds("max_stay", Duration.ofMinutes(10), SHORTEST_STAY, Duration.ofDays(1));
    LeaseTerms terms = context.leases();
    Duration usual = terms.defaultDuration().compareTo(stay) < 0 ? terms.defaultDuration() : stay;
    return context.with(new LeaseTerms(stay, usual));
  }

  @Override
  protected void onStart() {
    body.start();
    Optional<AgentSnapshot> kept;
    try {
      kept = recalled();
    } catch (IOException e) {
      fail(e);
      return;
    }
    Recruiter made =
        new Recruiter(
            context.robot(),
            recruitmentSettings,
            strategy,
            mode,
            new RecruiterPorts(
                transport, body, leases(), clock(), memory.clock(), context.robotTime()),
            new StatusPublisher(),
            kept);
    recruiter = made;
    body.onHoldChange(made::refresh);
    transitionTo(Readiness.READY);
    made.start();
    agreement.start();
  }

  /**
   * The stored state, as far as it can be loaded.
   *
   * @throws IOException if a stored state exists and cannot be read at all
   */
  private Optional<AgentSnapshot> recalled() throws IOException {
    try {
      return memory.load();
    } catch (IOException e) {
      log.warn(
          "{}: its call or help from before the restart is not continued: {}",
          path(),
          e.toString());
      recordException(e);
    }
    return memory.loadWithoutTimers();
  }

  /**
   * The agent may have promised help, or have a helper on its way, without a record of it: so it
   * takes no part in recruitment until an operator has checked. Its robot stops at the last
   * process' target.
   */
  private void fail(IOException why) {
    body.stop();
    log.error("{}: the agent does not start: {}", path(), why.toString(), why);
    String first =
        why instanceof AgentSnapshotStore.DamagedException
            ? "move that file away, which discards its call and its promises, and restart it"
            : "restart it when the file can be read";
    transitionTo(
        Readiness.FAILED,
        why.getMessage()
            + ", so it neither calls for help nor helps; "
            + first
            + ": "
            + CommandName.current()
            + " module stop "
            + path()
            + ", then "
            + CommandName.current()
            + " module start "
            + path());
  }

  @Override
  protected void onClose() {
    agreement.close();
    Recruiter made = recruiter;
    if (made != null) {
      made.close();
    }
    transport.close();
    body.close();
  }

  private Recruiter serving() {
    Recruiter made = recruiter;
    if (made == null || !readiness().serves()) {
      throw new NotReadyException(path(), readiness(), "it cannot call for help now");
    }
    return made;
  }

  @Override
  public void callForHelp(HelpCall call) {
    serving().help(call);
  }

  @Override
  public void release() {
    serving().release();
  }

  @Override
  public void resume() {
    Recruiter made = serving();
    body.endHold();
    made.refresh();
  }

  @Override
  public RecruitmentStatus status() {
    Recruiter made = recruiter;
    return made == null
        ? new RecruitmentStatus(
            clock().instant(),
            RequesterPhase.IDLE,
            null,
            ResponderPhase.FREE,
            null,
            0,
            notReadyReason().orElse("it has not started yet"))
        : made.status();
  }

  @Override
  public void receive(AgentMessage message) {
    if (!(message instanceof MessageEnvelope envelope)) {
      throw new IllegalArgumentException(
          path() + " accepts recruitment messages, not " + message.getClass().getName());
    }
    serving().receive(envelope);
  }

  @Override
  public List<Attributes> attributes() {
    return List.of(attributes(body.holdReason().orElse(null)));
  }

  private RecruitmentAttributes attributes(@Nullable String held) {
    return new RecruitmentAttributes(
        traits.percepts(),
        traits.speed(),
        strategy.name(),
        recruitmentSettings.replaceAfter().toMillis() / 1000.0,
        recruitmentSettings.margin().toMillis() / 1000.0,
        held);
  }

  /** Notifies listeners, and stores the state. */
  private final class StatusPublisher implements RecruiterListener {

    @Override
    public void snapshotChanged(AgentSnapshot snapshot) {
      try {
        memory.save(snapshot);
      } catch (IOException e) {
        log.warn(
            "{}: its state cannot be stored, so it is lost after a restart: {}",
            path(),
            e.toString());
        recordException(e);
      }
      observer.snapshotChanged(snapshot);
    }

    @Override
    public void statusChanged(RecruitmentStatus status) {
      log.info(
          "{}: {} / {}: {}",
          path(),
          status.requesterPhase(),
          status.responderPhase(),
          status.lastChange());
      publish(status);
      observer.statusChanged(status);
    }

    @Override
    public void sent(String to, MessageEnvelope envelope) {
      publish(new SentMessage(envelope.time(), to, envelope));
      observer.sent(to, envelope);
    }

    @Override
    public void received(MessageEnvelope envelope) {
      observer.received(envelope);
    }

    @Override
    public void performed(RequesterAction action) {
      observer.performed(action);
    }

    @Override
    public void performed(ResponderAction action) {
      observer.performed(action);
    }
  }
}

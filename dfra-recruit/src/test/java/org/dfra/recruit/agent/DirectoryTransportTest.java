package org.dfra.recruit.agent;

import static org.assertj.core.api.Assertions.assertThat;
import static org.awaitility.Awaitility.await;

import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.CountDownLatch;
import java.util.concurrent.TimeUnit;
import org.dfra.agent.AgentMessage;
import org.dfra.agent.HelpCall;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.agent.RecruitmentStatus;
import org.dfra.agent.RequesterPhase;
import org.dfra.agent.ResponderPhase;
import org.dfra.core.config.Parameters;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.state.StateStore;
import org.dfra.directory.Locality;
import org.dfra.lifecycle.Readiness;
import org.dfra.persona.AttributeProvider;
import org.dfra.persona.Attributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.RecruitmentAttributes;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.message.RecruitmentMessage.Release;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.slf4j.LoggerFactory;

/**
 * One call to each robot, and none waits for another: neither for a slow one nor for a dead one.
 */
@Timeout(120)
class DirectoryTransportTest {

  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final int MANY = 100;

  private final InMemoryModuleDirectory directory =
      new InMemoryModuleDirectory(InstantSource.system());
  private final List<ModuleImpl> made = new ArrayList<>();
  private final DirectoryTransport transport =
      new DirectoryTransport(
          context("uav").withDirectory(directory),
          LoggerFactory.getLogger(DirectoryTransportTest.class));

  @AfterEach
  void end() {
    transport.close();
    made.forEach(ModuleImpl::close);
    directory.close();
  }

  private static ModuleContext context(String robot) {
    return new ModuleContext(
        robot,
        "agent",
        Parameters.of(robot + "/agent", Map.of()),
        InstantSource.system(),
        StateStore.inMemory());
  }

  /** What an agent at the other end does with a message. */
  @FunctionalInterface
  private interface Taking {
    void take(MessageEnvelope envelope) throws RemoteException, InterruptedException;
  }

  private static final class Other extends ModuleImpl
      implements RecruitmentAgent, AttributeProvider {

    private final Taking taking;

    Other(ModuleContext context, Taking taking) {
      super(context, "an agent at the other end", "DFRA", "1");
      this.taking = taking;
    }

    @Override
    protected void onStart() {
      transitionTo(Readiness.READY);
    }

    @Override
    protected void onClose() {}

    @Override
    public void callForHelp(HelpCall call) {
      throw new AssertionError("nobody asks it to call");
    }

    @Override
    public void release() {
      throw new AssertionError("nobody asks it to release");
    }

    @Override
    public void resume() {
      throw new AssertionError("nobody holds it");
    }

    @Override
    public RecruitmentStatus status() {
      return new RecruitmentStatus(
          Instant.EPOCH, RequesterPhase.IDLE, null, ResponderPhase.FREE, null, 0, "nothing");
    }

    @Override
    public void receive(AgentMessage message) throws RemoteException {
      try {
        taking.take((MessageEnvelope) message);
      } catch (InterruptedException e) {
        Thread.currentThread().interrupt();
      }
    }

    @Override
    public List<Attributes> attributes() {
      return List.of(new RecruitmentAttributes(List.of("mine"), 1, "affective", 20, 1));
    }
  }

  private void agent(String robot, Taking taking) {
    Other other = new Other(context(robot), taking);
    made.add(other);
    other.start();
    Object unused = directory.add(other);
  }

  /** One of a robot on a host of its own. */
  private UUID agentAt(String host, String robot, Taking taking) {
    Other other = new Other(context(robot), taking);
    made.add(other);
    other.start();
    UUID id = UUID.randomUUID();
    List<Attributes> attributes = new ArrayList<>(other.attributes());
    attributes.add(
        new ModuleAttributes(
            robot,
            "agent",
            Other.class.getName(),
            host,
            "DFRA",
            "1",
            Readiness.READY,
            Instant.EPOCH,
            null,
            0));
    directory.put(id, other, attributes, Locality.REMOTE);
    return id;
  }

  private static MessageEnvelope message(long number) {
    return new MessageEnvelope(
        "uav", number, Instant.EPOCH, new Release(new Conversation("uav", 1), "enough", false));
  }

  @Test
  void aSlowAndADeadRobotDelayNobody() throws InterruptedException {
    CountDownLatch answers = new CountDownLatch(1);
    CountDownLatch asked = new CountDownLatch(1);
    List<Long> slow = new CopyOnWriteArrayList<>();
    List<Long> well = new CopyOnWriteArrayList<>();
    agent(
        "slow",
        envelope -> {
          asked.countDown();
          answers.await();
          slow.add(envelope.number());
        });
    agent(
        "dead",
        envelope -> {
          throw new RemoteException("nobody is there any more");
        });
    agent("well", envelope -> well.add(envelope.number()));
    assertThat(transport.capableRobots("mine")).containsExactlyInAnyOrder("slow", "dead", "well");

    List<Long> sent = new ArrayList<>();
    for (long number = 1; number <= MANY; number++) {
      transport.broadcast("mine", message(number));
      sent.add(number);
      long last = number;
      await().atMost(PATIENCE).until(() -> well.size() == last);
    }
    assertThat(asked.await(PATIENCE.toSeconds(), TimeUnit.SECONDS)).isTrue();
    assertThat(slow).as("it still has the first message in its hands").isEmpty();
    assertThat(well).as("every message, in order").isEqualTo(sent);

    answers.countDown();
    await().atMost(PATIENCE).until(() -> slow.size() == 32);
    assertThat(slow).as("those that were not lost, in order").isEqualTo(sent.subList(0, 32));
    transport.send("slow", message(1000));
    await().atMost(PATIENCE).until(() -> slow.contains(1000L));
  }

  /** Names of threads that wait for messages, or bring one. */
  private static List<String> couriers(String robots) {
    return Thread.getAllStackTraces().keySet().stream()
        .map(Thread::getName)
        .filter(name -> name.startsWith("dfra-messages uav/agent to " + robots))
        .toList();
  }

  @Test
  void aRobotHasAThreadOnlyWhileMessagesWaitForIt() {
    List<Long> taken = new CopyOnWriteArrayList<>();
    agent("courier-taker", envelope -> taken.add(envelope.number()));
    for (int robot = 0; robot < MANY; robot++) {
      transport.send("courier-" + robot, message(robot)); // gone, each under a name of its own
    }
    transport.send("courier-taker", message(7));
    await().atMost(PATIENCE).untilAsserted(() -> assertThat(couriers("courier-")).isEmpty());
    transport.send("courier-taker", message(8));
    await()
        .atMost(PATIENCE)
        .untilAsserted(() -> assertThat(taken).as("in order").containsExactly(7L, 8L));
  }

  @Test
  void noneOfTwoRobotsOfOneNameGetsAMessage() {
    List<Long> first = new CopyOnWriteArrayList<>();
    List<Long> second = new CopyOnWriteArrayList<>();
    List<Long> other = new CopyOnWriteArrayList<>();
    UUID wrong = agentAt("10.0.0.5", "atrv1", envelope -> first.add(envelope.number()));
    UUID right = agentAt("10.0.0.6", "atrv1", envelope -> second.add(envelope.number()));
    agent("atrv2", envelope -> other.add(envelope.number()));
    assertThat(transport.capableRobots("mine")).containsExactly("atrv2");
    assertThat(transport.ambiguousNames("mine"))
        .containsExactly("2 robots are named atrv1, on 10.0.0.5 and 10.0.0.6");
    assertThat(transport.ambiguousNames("gold")).isEmpty();
    transport.send("atrv1", message(1));
    transport.broadcast("mine", message(2));
    await().atMost(PATIENCE).until(() -> other.contains(2L));

    directory.markStale(wrong);
    transport.send("atrv1", message(3)); // the one that is out of reach may be meant
    await().atMost(PATIENCE).untilAsserted(() -> assertThat(couriers("atrv1")).isEmpty());

    directory.remove(wrong);
    assertThat(transport.ambiguousNames("mine")).isEmpty();
    assertThat(transport.capableRobots("mine")).containsExactlyInAnyOrder("atrv1", "atrv2");
    transport.send("atrv1", message(4));
    await().atMost(PATIENCE).until(() -> second.contains(4L));
    assertThat(second).as("%s", right).containsExactly(4L);
    assertThat(first).isEmpty();
  }

  @Test
  void noMessageIsSentToARobotThatHasLeft() {
    transport.send("nobody", message(1));
    assertThat(transport.capableRobots("mine")).isEmpty();
    assertThat(transport.percepts()).isEmpty();
  }
}

package org.dfra.benchmarks;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Queue;
import java.util.concurrent.ConcurrentLinkedQueue;
import org.dfra.agent.RecruitmentAgent;
import org.dfra.directory.ModuleQuery;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.Subscription;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.recruit.message.Conversation;
import org.dfra.recruit.message.MessageEnvelope;
import org.dfra.recruit.message.RecruitmentMessage.Accept;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.lookup.JiniModuleDirectory;

/**
 * A process that subscribes to a receiver and records when events arrive. It reads commands from
 * standard input: {@code clock} prints the current time; {@code letter} sends a message to the
 * agent and prints when it was sent and when it was acknowledged; {@code report} prints the
 * recorded times, one {@code number nanoseconds} per line, and an empty line.
 */
final class ListenerMain {

  private static final Duration PATIENCE = Duration.ofMinutes(1);
  private static final int DEPTH = 50;

  private ListenerMain() {}

  /** The arrival time of the event with this number. */
  private record ReceivedEvent(long number, long nanos) {}

  public static void main(String[] args) throws Exception {
    SerialFilters.install();
    TrustedCode.install();
    PrintStream out = new PrintStream(System.out, true);
    Queue<ReceivedEvent> reported = new ConcurrentLinkedQueue<>();
    try (JiniModuleDirectory directory =
        new JiniModuleDirectory(BenchRegistrar.HOST, List.of(), List.of(args[0]))) {
      GPSSensor gps =
          directory.findFirst(ModuleQuery.of(GPSSensor.class), PATIENCE).orElseThrow().module();
      try (Subscription subscription =
          gps.subscribe(
              event -> {
                long now = System.nanoTime();
                if (event.kind() == EventKind.READING) {
                  reported.add(new ReceivedEvent(event.sequence(), now));
                }
              },
              DeliveryPolicy.keepLast(DEPTH))) {
        long envelopes = 0;
        out.println("ready");
        BufferedReader in = new BufferedReader(new InputStreamReader(System.in));
        for (String line; (line = in.readLine()) != null; ) {
          if (line.equals("clock")) {
            out.println(System.nanoTime());
          } else if (line.equals("letter")) {
            long sent = write(agent(directory), ++envelopes);
            out.println(sent + " " + System.nanoTime());
          } else {
            reported.forEach(each -> out.println(each.number() + " " + each.nanos()));
            out.println(subscription.interruptedSince().isEmpty() ? "" : "interrupted");
          }
        }
      }
    }
    System.exit(0);
  }

  private static RecruitmentAgent agent(JiniModuleDirectory directory) throws InterruptedException {
    return directory
        .findFirst(ModuleQuery.of(RecruitmentAgent.class), PATIENCE)
        .orElseThrow()
        .module();
  }

  /** Returns the send time, by {@link System#nanoTime}. */
  private static long write(RecruitmentAgent agent, long number) throws RemoteException {
    MessageEnvelope envelope =
        new MessageEnvelope(
            "listener",
            number,
            Instant.now(),
            new Accept(new Conversation("bench", number), 0, Duration.ofSeconds(30), 1));
    long sent = System.nanoTime();
    agent.receive(envelope);
    return sent;
  }
}

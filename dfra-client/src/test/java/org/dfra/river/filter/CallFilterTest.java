package org.dfra.river.filter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.Remote;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import net.jini.jeri.BasicJeriExporter;
import org.assertj.core.api.AbstractThrowableAssert;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Arguments and results of calls over JERI. */
class CallFilterTest {

  /** What the test calls. */
  public interface Store extends Remote {
    /** Takes an argument of any class. */
    int put(Object value) throws RemoteException;

    /** Gives what the server holds. */
    Object get() throws RemoteException;
  }

  @TempDir static Path folder;
  private Payload payload;
  private BasicJeriExporter exporter;
  private Store store;
  private volatile Object held = "";
  private volatile int puts;
  private final Store server =
      new Store() {
        @Override
        public int put(Object value) {
          return ++puts;
        }

        @Override
        public Object get() {
          return held;
        }
      };

  @BeforeAll
  static void compile() throws IOException {
    Payload.compile(folder);
  }

  @BeforeEach
  void export() throws IOException {
    payload = new Payload(folder);
    exporter =
        new BasicJeriExporter(
            Endpoints.tcp("127.0.0.1", 0),
            new DeadlineILFactory(null, null, payload.loader(), Duration.ofSeconds(20)),
            false,
            true);
    store = (Store) exporter.export(server);
  }

  @AfterEach
  void unexport() {
    exporter.unexport(true);
  }

  @Test
  void carriesWhatIsAllowed() throws Exception {
    assertThat(store.put(List.of("a", 1.5))).isEqualTo(1);
    held = Map.of("pose", new double[] {1, 2, 3});
    assertThat((Map<?, ?>) store.get()).hasSize(1);
  }

  @Test
  void refusesGadgetsAmongTheArguments() throws Exception {
    for (Map.Entry<String, Object> gadget : payload.gadgets().entrySet()) {
      Payload.reset();
      assertRefused(() -> store.put(gadget.getValue()), gadget.getKey());
      assertThat(Payload.ran()).as(gadget.getKey()).isFalse();
    }
    assertThat(puts).isZero();
    assertThat(store.put("still serving")).isEqualTo(1);
  }

  @Test
  void refusesGadgetsInTheResult() throws Exception {
    for (Map.Entry<String, Object> gadget : payload.gadgets().entrySet()) {
      held = gadget.getValue();
      Payload.reset();
      assertRefused(() -> store.get(), gadget.getKey());
      assertThat(Payload.ran()).as(gadget.getKey()).isFalse();
    }
  }

  @Test
  void refusesWhatIsTooDeepOrTooLargeBothWays() throws Exception {
    Map<String, Object> graphs =
        Map.of(
            "objects nested",
            Payload.nested(100),
            "elements in one array",
            new byte[(4 << 20) + 1],
            "bytes claimed by arrays",
            new long[(1 << 20) + 1],
            "bytes",
            "x".repeat((8 << 20) + 1));
    for (Map.Entry<String, Object> graph : graphs.entrySet()) {
      assertRefused(() -> store.put(graph.getValue()), graph.getKey())
          .hasStackTraceContaining(" " + graph.getKey() + " > ");
      if (graph.getKey().contains("bytes")) {
        continue; // a result may have more of them: a registrar's answers do
      }
      held = graph.getValue();
      assertRefused(() -> store.get(), graph.getKey())
          .hasStackTraceContaining(" " + graph.getKey() + " > ");
    }
    assertThat(puts).isZero();
  }

  @Test
  void anArrayOfManySmallObjectsPasses() throws Exception {
    assertThat(store.put(Collections.nCopies(10_000, "fix").toArray())).isEqualTo(1);
  }

  private static AbstractThrowableAssert<?, ?> assertRefused(ThrowingCallable call, String what) {
    return assertThatThrownBy(call)
        .as(what)
        .isInstanceOf(RemoteException.class)
        .hasStackTraceContaining(RefusedDataException.class.getName() + ": refused to read");
  }
}

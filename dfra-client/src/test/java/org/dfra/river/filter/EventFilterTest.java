package org.dfra.river.filter;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CopyOnWriteArrayList;
import net.jini.jeri.BasicJeriExporter;
import org.assertj.core.api.AbstractThrowableAssert;
import org.assertj.core.api.ThrowableAssert.ThrowingCallable;
import org.dfra.event.Delivery;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.event.Reading;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.Endpoints;
import org.dfra.river.remote.RemoteModuleListener;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Events as a module sends them to a listener elsewhere, with something else in the reading. */
class EventFilterTest {

  /** A reading that any kind of module might have, and whose contents anybody may choose. */
  public record Freight(Object cargo) implements Reading {
    @Override
    public Instant measured() {
      return Instant.EPOCH;
    }
  }

  @TempDir static Path folder;
  private Payload payload;
  private BasicJeriExporter exporter;
  private RemoteModuleListener stub;
  private final List<Delivery> received = new CopyOnWriteArrayList<>();
  private final RemoteModuleListener listener = received::add;

  @BeforeAll
  static void compile() throws IOException {
    Payload.compile(folder);
  }

  @BeforeEach
  void export() throws Exception {
    payload = new Payload(folder);
    exporter =
        new BasicJeriExporter(
            Endpoints.tcp("127.0.0.1", 0),
            new DeadlineILFactory(null, null, payload.loader(), Duration.ofSeconds(20)),
            false,
            false);
    stub = (RemoteModuleListener) exporter.export(listener);
  }

  @AfterEach
  void unexport() {
    assertThat(exporter.unexport(true)).isTrue();
  }

  private void send(Object cargo) throws RemoteException {
    NewReading event = new NewReading(new Freight(cargo));
    Delivery delivery = new Delivery("atrv1/laser", 1, 1, 0, Instant.EPOCH, event);
    stub.notify(delivery, 1, 1);
    stub.notify(List.of(delivery, delivery), 2, 1);
  }

  private AbstractThrowableAssert<?, ?> assertRefusedEitherWay(Object cargo, String what) {
    NewReading event = new NewReading(new Freight(cargo));
    Delivery delivery = new Delivery("atrv1/laser", 1, 1, 0, Instant.EPOCH, event);
    AbstractThrowableAssert<?, ?> unused =
        assertRefused(what + " in a list", () -> stub.notify(List.of(delivery), 1, 1));
    return assertRefused(what, () -> stub.notify(delivery, 1, 1));
  }

  private static AbstractThrowableAssert<?, ?> assertRefused(String what, ThrowingCallable call) {
    return assertThatThrownBy(call)
        .as(what)
        .isInstanceOf(RemoteException.class)
        .hasStackTraceContaining(RefusedDataException.class.getName() + ": refused to read");
  }

  @Test
  void refusesGadgetsAndGoesOnListening() throws Exception {
    for (Map.Entry<String, Object> gadget : payload.gadgets().entrySet()) {
      Payload.reset();
      assertRefusedEitherWay(gadget.getValue(), gadget.getKey());
      assertThat(Payload.ran()).as(gadget.getKey()).isFalse();
    }
    assertThat(received).isEmpty();
    send(new double[] {1, 2, 3});
    assertThat(received).hasSize(3);
  }

  @Test
  void refusesWhatIsTooDeepOrTooLarge() {
    Map<String, Object> cargoes =
        Map.of(
            "objects nested",
            Payload.nested(100),
            "elements in one array",
            new byte[(4 << 20) + 1],
            "bytes claimed by arrays",
            new long[(1 << 20) + 1],
            "bytes",
            "x".repeat((8 << 20) + 1));
    cargoes.forEach(
        (limit, cargo) ->
            assertRefusedEitherWay(cargo, limit).hasStackTraceContaining(" " + limit + " > "));
    assertThat(received).isEmpty();
  }
}

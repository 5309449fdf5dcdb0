package org.dfra.benchmarks.event;

import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.ObjectInputStream;
import java.io.ObjectOutputStream;
import java.util.Base64;
import java.util.List;
import java.util.UUID;
import java.util.function.LongConsumer;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.DeliveryPolicy.EventKind;
import org.dfra.event.Subscription;
import org.dfra.river.call.DeadlineExceededException;
import org.dfra.river.filter.SerialFilters;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.proxy.sensor.GPSProxy;
import org.dfra.river.remote.RemoteModule;
import org.dfra.river.server.sensor.GPSServer;
import org.jspecify.annotations.Nullable;

/**
 * The readings of a receiver. A listener gets the module's proxy from the source's process: there
 * is no lookup service, which would take part of the computer's time.
 */
final class ModuleEvents implements EventTransport {

  private static final int DEPTH = 50;
  private static final int ATTEMPTS = 10;

  // Else the garbage collector could take them.
  private @Nullable GPSServer server;
  private @Nullable Subscription subscription;

  @Override
  public ServedSource serve() throws Exception {
    filterEverything();
    GPSServer served = BenchSensor.serve(List.of());
    server = served;
    GPSProxy proxy =
        new GPSProxy((RemoteModule) served.getProxy(), UUID.randomUUID(), served.identification());
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (ObjectOutputStream out = new ObjectOutputStream(bytes)) {
      out.writeObject(proxy);
    }
    BenchSensor sensor = BenchSensor.awaitInstance();
    return new ServedSource(
        Base64.getEncoder().encodeToString(bytes.toByteArray()), sensor::publish);
  }

  @Override
  public void listen(String address, LongConsumer received) throws Exception {
    filterEverything();
    byte[] bytes = Base64.getDecoder().decode(address);
    try (ObjectInputStream in = new ObjectInputStream(new ByteArrayInputStream(bytes))) {
      subscription = subscribe((GPSProxy) in.readObject(), received);
    }
  }

  /** A computer that starts many processes at once may answer the first calls too late. */
  private static Subscription subscribe(GPSProxy module, LongConsumer received) throws IOException {
    for (int attempt = 1; ; attempt++) {
      try {
        return module.subscribe(
            delivery -> received.accept(delivery.sequence()),
            DeliveryPolicy.keepLast(DEPTH).withKinds(EventKind.READING));
      } catch (DeadlineExceededException e) {
        if (attempt == ATTEMPTS) {
          throw e;
        }
      }
    }
  }

  /** What a main of DFRA does first. */
  private static void filterEverything() throws Exception {
    SerialFilters.install();
    TrustedCode.install();
  }
}

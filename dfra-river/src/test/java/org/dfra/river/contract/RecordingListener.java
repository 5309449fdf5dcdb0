package org.dfra.river.contract;

import java.time.Duration;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.Semaphore;
import org.dfra.event.Delivery;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.event.ModuleListener;
import org.dfra.flow.sensor.GpsFix;

/** A listener that records its deliveries, and can be made slow. */
final class RecordingListener implements ModuleListener {

  private final List<Delivery> received = new CopyOnWriteArrayList<>();
  private final Semaphore listening = new Semaphore(Integer.MAX_VALUE / 2);
  volatile boolean throwing;

  @Override
  public void notify(Delivery delivery) {
    received.add(delivery);
    listening.acquireUninterruptibly();
    listening.release();
    if (throwing) {
      throw new IllegalStateException("a listener that fails");
    }
  }

  /** Takes one more delivery, and then blocks until {@link #open}. */
  void stop() {
    listening.drainPermits();
  }

  void open() {
    listening.release(1000);
  }

  List<Delivery> received() {
    return received;
  }

  /** Waits for so many deliveries. */
  List<Delivery> await(int count) {
    Duration patience = Duration.ofSeconds(20);
    org.awaitility.Awaitility.await().atMost(patience).until(() -> received.size() >= count);
    return received;
  }

  List<Double> latitudes() {
    return received.stream()
        .filter(delivery -> delivery.event() instanceof NewReading)
        .map(delivery -> ((GpsFix) ((NewReading) delivery.event()).reading()).position().latitude())
        .toList();
  }
}

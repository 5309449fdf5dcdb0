package org.dfra.sim.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dfra.core.config.Parameters;
import org.dfra.core.lease.LeaseTerms;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.core.state.StateStore;
import org.dfra.drivers.camera.mjpeg.MjpegCameraImpl;
import org.dfra.drivers.gyro.kvh.Dsp3000Impl;
import org.dfra.drivers.pantilt.ptu.PtuImpl;
import org.dfra.event.DeliveryPolicy;
import org.dfra.event.ModuleEvent.NewReading;
import org.dfra.flow.effector.CommandLease;
import org.dfra.flow.effector.PanTiltCommand.PointAt;
import org.dfra.lifecycle.Readiness;
import org.dfra.sim.device.camera.MjpegDevice;
import org.dfra.sim.device.camera.MjpegDevice.MjpegOptions;
import org.dfra.sim.device.gyro.Dsp3000Device;
import org.dfra.sim.device.pantilt.PtuDevice;
import org.dfra.sim.physics.CameraInput;
import org.dfra.sim.time.LockStep;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** Head, gyro and camera on {@code sim:} links: the same run twice is the same to the last bit. */
@Timeout(120)
class HeadInLockStepTest {

  private static final Instant BEGIN = Instant.parse("2026-11-21T10:00:00Z");

  /** The readings that a run published, and when. */
  private static final class Run implements AutoCloseable {

    final LockStep time = new LockStep(BEGIN);
    final List<String> published = new ArrayList<>();
    final List<AutoCloseable> open = new ArrayList<>();
    double pan;

    ModuleContext context(String name, Map<String, String> more) {
      Map<String, String> all = new TreeMap<>(more);
      all.put("link", "sim:" + name);
      return new ModuleContext(
          "robot",
          name,
          Parameters.of("robot/" + name, all),
          time,
          StateStore.inMemory(),
          LeaseTerms.DEFAULT,
          time);
    }

    <M extends ModuleImpl> M start(M module, SerialDevice device) {
      SimPort port = new SimPort(module.identification().name(), device, time);
      open.add(0, port);
      open.add(0, module);
      port.start();
      module.start();
      return module;
    }

    void listen(ModuleImpl module) {
      var unused =
          module.subscribe(
              delivery -> {
                if (delivery.event() instanceof NewReading reading) {
                  published.add(delivery.published() + " " + reading.reading());
                }
              },
              DeliveryPolicy.keepLast(1000));
    }

    boolean becomesReady(ModuleImpl module) {
      return time.advanceUntil(() -> module.readiness().serves(), Duration.ofSeconds(20));
    }

    @Override
    public void close() throws Exception {
      for (AutoCloseable each : open) {
        each.close();
      }
    }
  }

  @Test
  void repeatsARunToTheLastBit() throws Exception {
    List<String> first = run();
    assertThat(first).hasSizeGreaterThan(1000);
    assertThat(first).anyMatch(line -> line.contains("PanTiltState") && line.contains("true"));
    assertThat(first).anyMatch(line -> line.contains("CameraImage"));
    assertThat(run()).isEqualTo(first);
  }

  private static List<String> run() throws Exception {
    try (Run run = new Run()) {
      PtuImpl head =
          run.start(
              new PtuImpl(run.context("head", Map.of())),
              new PtuDevice((time, pan, tilt) -> run.pan = pan, 9600, true));
      Dsp3000Impl gyro =
          run.start(
              new Dsp3000Impl(run.context("gyro", Map.of())),
              new Dsp3000Device(time -> run.pan, 38_400, Duration.ofSeconds(1)));
      CameraInput view =
          time -> {
            int[] samples = new int[40 * 30];
            for (int i = 0; i < samples.length; i++) {
              samples[i] = (int) (1000 * run.pan) + 7 * i;
            }
            return new CameraInput.Frame(40, 30, samples);
          };
      MjpegCameraImpl camera =
          run.start(
              new MjpegCameraImpl(
                  run.context("camera", Map.of("path", "/video", "field_of_view", "1"))),
              new MjpegDevice(view, MjpegOptions.visible(10)));
      run.time.advance(Duration.ofSeconds(60)); // the unit's own reset takes its time
      assertThat(head.readiness()).isEqualTo(Readiness.READY);
      assertThat(run.becomesReady(gyro) && run.becomesReady(camera)).isTrue();
      for (ModuleImpl module : List.of(head, gyro, camera)) {
        run.listen(module);
      }
      try (CommandLease lease = head.acquireCommandLease(Duration.ofSeconds(20))) {
        head.execute(lease.key(), new PointAt(1, 0.3, 1));
        run.time.advance(Duration.ofSeconds(5));
        assertThat(head.panTiltState().pan()).isBetween(0.99, 1.01);
        assertThat(gyro.rate().rate()).isBetween(0.99, 1.01);
      }
      run.time.advance(Duration.ofSeconds(10));
      assertThat(head.history().failures() + gyro.history().failures()).isZero();
      assertThat(camera.history().failures()).isZero();
      return List.copyOf(run.published);
    }
  }
}

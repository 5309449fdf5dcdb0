package org.dfra.sim.run;

import java.io.IOException;
import java.time.InstantSource;
import org.dfra.sim.device.Cable;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.SerialDevice;
import org.dfra.sim.device.SimPort;
import org.dfra.sim.time.LockStep;

/** Transports an emulated device's bytes to its driver. */
interface EmulatorTransport extends AutoCloseable {

  /** Opens the link, once. */
  void start() throws IOException;

  /** The link for a driver; only after {@link #start}. */
  String link();

  /** The cable, for fault injection. */
  Cable cable();

  @Override
  void close();

  /** Over a TCP port. */
  static EmulatorTransport tcp(String name, int port, SerialDevice device, InstantSource clock) {
    DeviceEmulator emulator = new DeviceEmulator(name, port, device, clock);
    return new EmulatorTransport() {
      @Override
      public void start() throws IOException {
        emulator.start();
      }

      @Override
      public String link() {
        return emulator.url();
      }

      @Override
      public Cable cable() {
        return emulator.cable();
      }

      @Override
      public void close() {
        emulator.close();
      }
    };
  }

  /** In lock-step with its driver. */
  static EmulatorTransport lockStep(String name, SerialDevice device, LockStep time) {
    SimPort port = new SimPort(name, device, time);
    return new EmulatorTransport() {
      @Override
      public void start() {
        port.start();
      }

      @Override
      public String link() {
        return port.url();
      }

      @Override
      public Cable cable() {
        return port.cable();
      }

      @Override
      public void close() {
        port.close();
      }
    };
  }
}

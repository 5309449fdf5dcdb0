package org.dfra.examples.foundation;

import java.io.IOException;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import org.dfra.directory.ModuleDirectory;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.flow.sensor.GpsFix;
import org.dfra.lifecycle.Readiness;
import org.dfra.river.lookup.JiniModuleDirectory;

/**
 * A client that knows one interface, {@link GPSSensor}, and the locators of lookup services:
 * neither the robot's name, nor the receiver's make, nor its host.
 */
final class PositionClient implements AutoCloseable {

  private final ModuleDirectory directory;
  private final GPSSensor gps;

  private PositionClient(ModuleDirectory directory, GPSSensor gps) {
    this.directory = directory;
    this.gps = gps;
  }

  /** Finds a GPS receiver through discovery and lookup. */
  static PositionClient find(String locator, Duration patience)
      throws IOException, InterruptedException {
    ModuleDirectory directory =
        new JiniModuleDirectory(DemoEnvironment.ADDRESS, List.of(), List.of(locator));
    GPSSensor gps =
        directory
            .find(GPSSensor.class, patience)
            .orElseThrow(() -> new IOException("no GPS receiver was found at " + locator));
    return new PositionClient(directory, gps);
  }

  /** The proxy; always the same instance. */
  GPSSensor gps() {
    return gps;
  }

  /** Waits for the receiver's first fix, polling by remote calls. */
  GpsFix position(Duration patience) throws RemoteException {
    Readiness readiness = gps.awaitReadiness(patience);
    if (!readiness.serves()) {
      throw new RemoteException(
          gps.identification().path() + " is still " + readiness + " after " + patience);
    }
    return gps.fix();
  }

  @Override
  public void close() {
    directory.close();
  }
}

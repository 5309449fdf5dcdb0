package org.dfra.bringup;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SensorImpl;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.lifecycle.Readiness;

/**
 * A driver of a device that stands two drivers no better than a motor does: while one has it open
 * there is a file, and a driver that finds it records that. Parameters: {@code device}, that file;
 * {@code celsius}, what is measured.
 */
public final class DeviceInUseImpl extends SensorImpl implements Thermometer {

  private final Path device;
  private final double celsius;

  /** Called by the module's server. */
  public DeviceInUseImpl(ModuleContext context) {
    super(context, "Device that one driver may have", "you", "1.0");
    this.device = Path.of(settings().text("device"));
    this.celsius = settings().number("celsius", 20, -273.15, 1000);
  }

  /** Where it is written down that two drivers had a device. */
  static Path twice(Path device) {
    return device.resolveSibling(device.getFileName() + ".twice");
  }

  @Override
  protected void onStart() {
    try {
      Optional<Long> other = holder();
      if (other.flatMap(ProcessHandle::of).filter(ProcessHandle::isAlive).isPresent()) {
        Files.writeString(twice(device), path() + " found it open in " + other.get() + "\n");
      }
      Files.writeString(device, Long.toString(ProcessHandle.current().pid()));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    transitionTo(Readiness.READY);
  }

  /** The process that has it open; a dead one, which was killed, does not count. */
  private Optional<Long> holder() throws IOException {
    return Files.exists(device)
        ? Optional.of(Long.valueOf(Files.readString(device)))
        : Optional.empty();
  }

  @Override
  protected void onClose() {
    try {
      Files.deleteIfExists(device);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  @Override
  public double updateRate() {
    return 0;
  }

  @Override
  public double celsius() {
    return celsius;
  }
}

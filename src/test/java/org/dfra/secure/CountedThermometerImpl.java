package org.dfra.secure;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.SensorImpl;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.lifecycle.Readiness;

/** A thermometer that adds a line to the file {@code calls} whenever it is read. */
public final class CountedThermometerImpl extends SensorImpl implements Thermometer {

  private final Path calls;

  /** Called by the module's server. */
  public CountedThermometerImpl(ModuleContext context) {
    super(context, "Thermometer that counts", "somebody", "1.0");
    this.calls = Path.of(settings().text("calls"));
  }

  @Override
  protected void onStart() {
    transitionTo(Readiness.READY);
  }

  @Override
  protected void onClose() {}

  @Override
  public double updateRate() {
    return 0;
  }

  @Override
  public double celsius() {
    try {
      Path unused =
          Files.writeString(calls, "read\n", StandardOpenOption.CREATE, StandardOpenOption.APPEND);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return -1;
  }
}

package org.dfra.river.lookup;

import static org.assertj.core.api.Assertions.assertThat;

import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.List;
import java.util.logging.Level;
import java.util.logging.LogRecord;
import org.dfra.directory.RegistrationRefusedException;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.Test;

class RefusalLogFilterTest {

  private static LogRecord record(@Nullable Throwable thrown) {
    LogRecord record = new LogRecord(Level.INFO, "failure");
    record.setThrown(thrown);
    return record;
  }

  @Test
  void refusalsAreTakenOutAndEverythingElseIsDecidedByTheNext() {
    List<LogRecord> asked = new ArrayList<>();
    RefusalLogFilter filter = new RefusalLogFilter(asked::add);
    RegistrationRefusedException refused = new RegistrationRefusedException("no");
    assertThat(filter.isLoggable(record(refused))).isFalse();
    assertThat(filter.isLoggable(record(new RemoteException("", refused)))).isFalse();
    assertThat(asked).isEmpty();
    assertThat(filter.isLoggable(record(new RemoteException("lost")))).isTrue();
    assertThat(filter.isLoggable(record(null))).isTrue();
    assertThat(asked).hasSize(2);
    assertThat(new RefusalLogFilter(null).isLoggable(record(null))).isTrue();
    assertThat(new RefusalLogFilter(each -> false).isLoggable(record(null))).isFalse();
  }
}

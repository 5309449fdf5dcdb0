package org.dfra.example.login;

import java.time.LocalTime;
import java.time.ZoneOffset;
import java.util.Map;
import javax.security.auth.Subject;
import javax.security.auth.callback.CallbackHandler;
import javax.security.auth.login.LoginException;
import javax.security.auth.spi.LoginModule;

/** Options: from and until, times of day in UTC. */
public final class WorkingHours implements LoginModule {

  private LocalTime from = LocalTime.MIN;
  private LocalTime until = LocalTime.MAX;

  @Override
  public void initialize(
      Subject subject, CallbackHandler handler, Map<String, ?> shared, Map<String, ?> options) {
    from = LocalTime.parse((String) options.get("from"));
    until = LocalTime.parse((String) options.get("until"));
  }

  @Override
  public boolean login() throws LoginException {
    LocalTime now = LocalTime.now(ZoneOffset.UTC);
    if (now.isBefore(from) || now.isAfter(until)) {
      throw new LoginException(
          "it is " + now + " UTC, and robots are used from " + from + " until " + until);
    }
    return true;
  }

  /** A module that has principals adds them to the subject here. */
  @Override
  public boolean commit() {
    return true;
  }

  @Override
  public boolean abort() {
    return true;
  }

  @Override
  public boolean logout() {
    return true;
  }
}

package org.dfra.app.doctor;

import com.sun.management.UnixOperatingSystemMXBean;
import java.lang.management.ManagementFactory;
import java.util.List;

/**
 * How many files and sockets a process may have open.
 *
 * @param most as many; 0 where the system does not tell
 */
record FileDescriptorCheck(long most) implements Check {

  /** A group with a registrar, a class server and a listener for each module needs hundreds. */
  private static final long ENOUGH = 4096;

  /** The limit of this process, which those that it starts inherit. */
  static FileDescriptorCheck ofThisProcess() {
    return new FileDescriptorCheck(
        ManagementFactory.getOperatingSystemMXBean() instanceof UnixOperatingSystemMXBean unix
            ? unix.getMaxFileDescriptorCount()
            : 0);
  }

  @Override
  public Subject subject() {
    return Subject.FILE_DESCRIPTORS;
  }

  @Override
  public List<Finding> examine() {
    if (most <= 0) {
      return List.of();
    }
    String what = "a process may have " + most + " files and sockets open";
    return List.of(
        most >= ENOUGH
            ? Finding.ok(subject(), what)
            : Finding.warn(
                subject(),
                what,
                "Raise the limit to "
                    + ENOUGH
                    + ": ulimit -n "
                    + ENOUGH
                    + ", or LimitNOFILE in the systemd unit."));
  }
}

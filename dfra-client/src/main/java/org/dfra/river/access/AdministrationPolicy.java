package org.dfra.river.access;

import java.lang.System.Logger.Level;
import java.net.InetAddress;
import java.net.UnknownHostException;
import java.util.Arrays;
import java.util.Collection;
import java.util.List;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.module.AdministrationRefusedException;
import org.jspecify.annotations.Nullable;

/**
 * The addresses from which an exported object may be administered: its own computer and the
 * configured ranges.
 *
 * <p>The configured ranges apply to all objects of a virtual machine. They are the system property
 * {@value #PROPERTY}, which a robot's processes get from {@code <administration from="…">} of its
 * XML, and the ranges that a robot within the virtual machine {@linkplain #admit admits} while it
 * runs.
 *
 * <p>Thread-safe.
 */
public final class AdministrationPolicy {

  /**
   * System property: addresses and ranges in the form of {@link AddressRange#of}, separated by
   * commas.
   */
  public static final String PROPERTY = "dfra.administration.from";

  private static final System.Logger LOG = System.getLogger(AdministrationPolicy.class.getName());

  /** Limits the log lines about repeated calls of an unauthorised client. */
  private static final long LOG_AGAIN_NANOS = TimeUnit.SECONDS.toNanos(10);

  private static final List<Admission> ADMITTED = new CopyOnWriteArrayList<>();
  private static final AtomicLong LAST_LOGGED = new AtomicLong(System.nanoTime() - LOG_AGAIN_NANOS);

  /** Read when the first object is exported, so that a main can set it before. */
  private static final class ConfiguredRanges {
    static final List<AddressRange> RANGES = parse(System.getProperty(PROPERTY, ""));
  }

  private final OwnAddresses own;

  private AdministrationPolicy(OwnAddresses own) {
    this.own = own;
  }

  /**
   * The policy of an object that is exported at an address of this computer.
   *
   * @param host the address, or a name of it; null for all of the computer's addresses
   * @throws UnknownHostException if the name is unknown
   * @throws IllegalArgumentException if the system property {@value #PROPERTY} is invalid; the
   *     message describes valid values
   */
  public static AdministrationPolicy exportedAt(@Nullable String host) throws UnknownHostException {
    List<AddressRange> unused = configured(); // reports an invalid value before the first call
    return new AdministrationPolicy(OwnAddresses.exportedAt(host));
  }

  private static List<AddressRange> configured() {
    try {
      return ConfiguredRanges.RANGES;
    } catch (ExceptionInInitializerError e) {
      if (e.getCause() instanceof IllegalArgumentException wrong) {
        throw wrong;
      }
      throw e;
    }
  }

  /**
   * Parses a list.
   *
   * @param list addresses and ranges, separated by commas; empty for none
   * @throws IllegalArgumentException if an element is neither
   */
  static List<AddressRange> parse(String list) {
    return Arrays.stream(list.split(","))
        .map(String::strip)
        .filter(each -> !each.isEmpty())
        .map(AddressRange::of)
        .toList();
  }

  /** The addresses that a robot in this virtual machine admits, until it is closed. */
  public static final class Admission implements AutoCloseable {

    private final List<AddressRange> ranges;

    private Admission(Collection<AddressRange> ranges) {
      this.ranges = List.copyOf(ranges);
    }

    private boolean contains(InetAddress address) {
      return ranges.stream().anyMatch(each -> each.contains(address));
    }

    @Override
    public void close() {
      ADMITTED.remove(this);
    }
  }

  /** Admits these addresses to the administration of all objects of this virtual machine. */
  public static Admission admit(Collection<AddressRange> ranges) {
    Admission admission = new Admission(ranges);
    ADMITTED.add(admission);
    return admission;
  }

  /** Whether a client may administer; one with an unknown address may not. */
  public boolean allows(RemoteCaller caller) {
    @Nullable InetAddress address = caller.address();
    return address != null
        && (own.contains(address)
            || configured().stream().anyMatch(each -> each.contains(address))
            || ADMITTED.stream().anyMatch(each -> each.contains(address)));
  }

  /**
   * Refuses a client that may not administer.
   *
   * @param what the method that it calls, such as {@code Module.setParameter}
   * @throws AdministrationRefusedException if it may not
   */
  public void check(RemoteCaller caller, String what) {
    if (!allows(caller)) {
      AdministrationRefusedException refused =
          new AdministrationRefusedException(
              what
                  + " is refused to "
                  + caller
                  + ": it is an administrative call, which is allowed from the robot's own computer"
                  + " and from what <administration from=\"…\"> in its XML names; call from there,"
                  + " or add the address and bring the robot up again");
      log(refused.getMessage());
      throw refused;
    }
  }

  private static void log(@Nullable String refusal) {
    long now = System.nanoTime();
    long last = LAST_LOGGED.get();
    if (now - last >= LOG_AGAIN_NANOS && LAST_LOGGED.compareAndSet(last, now)) {
      LOG.log(Level.WARNING, refusal);
    }
  }
}

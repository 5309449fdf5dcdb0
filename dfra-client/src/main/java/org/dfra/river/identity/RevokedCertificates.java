package org.dfra.river.identity;

import java.math.BigInteger;
import java.security.GeneralSecurityException;
import java.security.cert.X509CRL;
import java.security.cert.X509CRLEntry;
import java.security.cert.X509Certificate;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import org.jspecify.annotations.Nullable;

/**
 * The certificates of a team that its authority has revoked: the list with the highest number that
 * this process has seen. Thread-safe.
 */
public final class RevokedCertificates {

  /** What a list says. */
  private record Known(BigInteger number, Set<BigInteger> serials) {}

  private final X509Certificate authority;
  private final List<Runnable> listeners = new CopyOnWriteArrayList<>();
  private volatile Known known = new Known(BigInteger.ZERO, Set.of());

  /**
   * None yet.
   *
   * @param authority must have signed each list
   */
  public RevokedCertificates(X509Certificate authority) {
    this.authority = authority;
  }

  /** Whether a certificate is revoked. */
  public boolean contains(X509Certificate certificate) {
    return contains(certificate.getSerialNumber());
  }

  /** Whether the certificate of this number is revoked. */
  public boolean contains(BigInteger certificate) {
    return known.serials().contains(certificate);
  }

  /** Number of the list; 0 before the first. */
  public BigInteger number() {
    return known.number();
  }

  /** Calls back after each new list, on the thread that brought it. */
  public void addListener(Runnable listener) {
    listeners.add(listener);
  }

  /** Ends {@link #addListener}. */
  public void removeListener(Runnable listener) {
    listeners.remove(listener);
  }

  /**
   * Takes a list if it is newer than the known one.
   *
   * @return whether it is
   * @throws GeneralSecurityException if the authority has not signed it, or it has no number; the
   *     message is a sentence
   */
  public boolean replace(X509CRL list) throws GeneralSecurityException {
    if (!list.getIssuerX500Principal().equals(authority.getSubjectX500Principal())) {
      throw new GeneralSecurityException(
          "a list of revoked certificates is of "
              + list.getIssuerX500Principal()
              + " instead of "
              + authority.getSubjectX500Principal());
    }
    list.verify(authority.getPublicKey());
    BigInteger number =
        SignedFiles.number(list)
            .orElseThrow(
                () -> new GeneralSecurityException("a list of revoked certificates has no number"));
    Known next = new Known(number, serials(list));
    synchronized (this) {
      if (next.number().compareTo(known.number()) <= 0) {
        return false;
      }
      known = next;
    }
    listeners.forEach(Runnable::run);
    return true;
  }

  private static Set<BigInteger> serials(X509CRL list) {
    @Nullable Set<? extends X509CRLEntry> entries = list.getRevokedCertificates();
    Set<BigInteger> serials = new HashSet<>();
    if (entries != null) {
      entries.forEach(each -> serials.add(each.getSerialNumber()));
    }
    return Set.copyOf(serials);
  }
}

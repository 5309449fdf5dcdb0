package org.dfra.river.security;

import java.security.cert.X509Certificate;
import java.time.Clock;
import java.util.Date;
import java.util.List;
import java.util.Optional;
import org.dfra.river.identity.RevokedCertificates;
import org.dfra.river.identity.TeamCertificates;
import org.dfra.river.loading.TeamSigners;

/**
 * The keys for code that a team's authority has issued: {@code security issue code}. A revoked or
 * expired one signs nothing any more; what was loaded before stays loaded.
 *
 * @param authority certificate of the authority
 * @param revoked its list
 */
record TeamCode(X509Certificate authority, RevokedCertificates revoked, Clock clock)
    implements TeamSigners {

  @Override
  public Optional<String> refusal(List<X509Certificate> chain) {
    X509Certificate certificate = chain.get(0);
    if (!TeamCertificates.isForCode(chain, authority)) {
      return Optional.of(
          "the authority of this team has not issued for code; sign the jar with a key of \"security"
              + " issue code NAME\", or add the certificate to the trust file if its key should be"
              + " trusted");
    } else if (revoked.contains(certificate)) {
      return Optional.of(
          "the authority of this team has revoked; sign the jar with a new key of \"security issue"
              + " code NAME\"");
    }
    Date now = Date.from(clock.instant());
    return now.before(certificate.getNotBefore()) || now.after(certificate.getNotAfter())
        ? Optional.of(
            "is valid only from "
                + certificate.getNotBefore().toInstant()
                + " until "
                + certificate.getNotAfter().toInstant()
                + "; sign the jar with a new key, or set the clock")
        : Optional.empty();
  }
}

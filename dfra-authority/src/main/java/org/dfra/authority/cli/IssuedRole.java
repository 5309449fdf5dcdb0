package org.dfra.authority.cli;

import java.util.Locale;
import org.dfra.authority.IssuedCertificate;

/** What a certificate can be issued for: a member's role, or the signing of code. */
enum IssuedRole {
  ROBOT,
  OPERATOR,
  OBSERVER,
  /** {@link IssuedCertificate#CODE}. */
  CODE;

  /** As the register has it. */
  String text() {
    return name().toLowerCase(Locale.ROOT);
  }
}

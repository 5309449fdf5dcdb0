package org.dfra.report.plot;

/** Java finds no font on this computer, so no image can be painted. */
public final class NoFontException extends RuntimeException {

  private static final long serialVersionUID = 1L;

  NoFontException(Throwable cause) {
    super(
        "no picture can be painted, since Java finds no font here ("
            + cause.getMessage()
            + "); install fontconfig and a font, as apt-get install fontconfig fonts-dejavu-core",
        cause);
  }
}

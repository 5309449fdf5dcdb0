/**
 * A peer on an older release, as far as the wire shows it: written from the table of serial forms
 * alone, without looking at the module's own classes.
 */
package org.dfra.activation.oldpeer;

/** Tests of discovery, with lookup services that answer what the test says. */
@NullMarked
package org.dfra.river.discovery;

import org.jspecify.annotations.NullMarked;

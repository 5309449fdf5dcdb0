/**
 * Attacks by others on the same network, made for real against robots of these tests: each of them
 * must fail.
 */
@NullMarked
package org.dfra.attack;

import org.jspecify.annotations.NullMarked;
